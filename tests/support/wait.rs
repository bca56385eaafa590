//! Waiting for a condition: the only place in the tests that polls.

use std::future::Future;
use std::time::Duration;

use tokio::time::{Instant, MissedTickBehavior, interval};

/// Enough for anything that does not compute or move.
pub const SHORT: Duration = Duration::from_secs(30);

/// Enough for a training or a motion on a machine that is busy with other tests.
pub const LONG: Duration = Duration::from_secs(300);

/// Asks until `condition` gives a value, and returns that value.
///
/// The bound exists so that a broken server fails a test instead of hanging it; no test may
/// depend on how long something takes.
///
/// # Panics
/// When the condition has not held within `limit`; `what` says what was waited for.
pub async fn eventually<T, F>(what: &str, limit: Duration, mut condition: impl FnMut() -> F) -> T
where
    F: Future<Output = Option<T>>,
{
    let deadline = Instant::now() + limit;
    let mut tick = interval(Duration::from_millis(20));
    tick.set_missed_tick_behavior(MissedTickBehavior::Delay);
    loop {
        tick.tick().await;
        if let Some(value) = condition().await {
            return value;
        }
        assert!(
            Instant::now() < deadline,
            "waited {limit:?} in vain for: {what}"
        );
    }
}
