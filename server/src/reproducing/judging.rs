//! What a run came to, worked out from its stored record page by page, so that a long one never has
//! to be in memory. The figures themselves are in `figures`.

use std::sync::Arc;

use robot::{RunEnd, SignalSet};

use super::figures::{Figures, Measure, MotionPart};
use crate::ids::ReproductionId;
use crate::plans::KnownPlan;
use crate::store::flights::Stretch;
use crate::store::reproductions::{ReproductionResult, ReproductionState};
use crate::store::signals::RunSignal;
use crate::store::{self, Store};
use crate::words::sentence;

/// What a run came to, from its stored record.
pub(super) async fn judge(
    store: &Store,
    id: ReproductionId,
    plan: Arc<KnownPlan>,
    end: Option<RunEnd>,
) -> anyhow::Result<ReproductionResult> {
    if end == Some(RunEnd::Completed) {
        let known = Arc::clone(&plan);
        let learnt = tokio::task::spawn_blocking(move || known.model.regression()).await?;
        let part = MotionPart {
            begins_s: plan.plan.approach_s(),
            stretch: plan.stretch,
        };
        let measure = if plan.backwards {
            Measure::default()
        } else {
            Measure::along(part, &learnt)
        };
        let measure = measured(store, id, measure).await?;
        let figures =
            tokio::task::spawn_blocking(move || measure.completed(&plan.goal.0, &learnt)).await?;
        return Ok(result(ReproductionState::Succeeded, None, figures));
    }
    let figures = measured(store, id, Measure::default()).await?.broken();
    Ok(match end {
        Some(RunEnd::Failed(fault)) => {
            let reason = format!("{} {}", sentence(&fault.message), fault.advice);
            failed(&reason, figures)
        }
        Some(_) => result(
            ReproductionState::Stopped,
            Some("It was stopped.".into()),
            figures,
        ),
        None => failed("The connection to the arm was lost.", figures),
    })
}

pub(super) async fn keep_signals(store: &Store, id: ReproductionId, set: Vec<SignalSet>) {
    let kept = match run_signals(store, id, set).await {
        Ok(signals) => store.add_run_signals(id, &signals).await,
        Err(error) => Err(error),
    };
    if let Err(error) = kept {
        tracing::error!(reproduction.id = %id, %error, "a reproduction's signals could not be stored");
    }
}

/// On the record's clock: when the plan came to each signal, and how late it was set then.
async fn run_signals(
    store: &Store,
    id: ReproductionId,
    set: Vec<SignalSet>,
) -> Result<Vec<RunSignal>, store::Error> {
    let mut left = set.into_iter().peekable();
    let mut signals = Vec::new();
    let mut last_us = 0;
    let place = |signal: SignalSet, due_us: u64| RunSignal {
        at_us: due_us + (signal.late_s * 1e6).round() as u64,
        name: signal.name,
        on: signal.on,
        late_s: signal.late_s,
    };
    let mut pages = store.flight(id, Stretch::ALL);
    while let Some(cycles) = pages.next().await? {
        for cycle in cycles {
            last_us = cycle.at_us;
            while let Some(signal) = left.next_if(|signal| signal.at_s <= cycle.plan_t_s) {
                signals.push(place(signal, last_us));
            }
        }
    }
    signals.extend(left.map(|signal| place(signal, last_us)));
    Ok(signals)
}

pub(super) async fn measured(
    store: &Store,
    id: ReproductionId,
    mut measure: Measure,
) -> Result<Measure, store::Error> {
    let mut pages = store.flight(id, Stretch::ALL);
    while let Some(cycles) = pages.next().await? {
        measure.add(&cycles);
    }
    Ok(measure)
}

pub(super) fn failed(reason: &str, figures: Figures) -> ReproductionResult {
    result(ReproductionState::Failed, Some(reason.into()), figures)
}

fn result(
    state: ReproductionState,
    reason: Option<String>,
    figures: Figures,
) -> ReproductionResult {
    ReproductionResult {
        state,
        reason,
        e_j_deg: figures.e_j_deg,
        e_j_commanded_deg: figures.e_j_commanded_deg,
        gmcc: figures.gmcc,
        tracking_error_deg: figures.tracking_error_deg,
        cycles: figures.cycles,
    }
}
