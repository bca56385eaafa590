//! What a run came to, worked out from its stored record page by page, so that a long one never has
//! to be in memory. The figures themselves are in `figures`.

use std::sync::Arc;

use robot::RunEnd;

use super::figures::{Figures, Measure, MotionPart};
use crate::ids::ReproductionId;
use crate::plans::KnownPlan;
use crate::store::flights::Stretch;
use crate::store::reproductions::{ReproductionResult, ReproductionState};
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
