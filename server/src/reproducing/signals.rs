//! The signals that a run has set, on the clock of its flight record.

use robot::SignalSet;

use crate::ids::ReproductionId;
use crate::store::flights::Stretch;
use crate::store::signals::RunSignal;
use crate::store::{self, Store};

/// Stores what a run has set; what can't be stored is only told.
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
