//! The wall clock, as a thing that a test can hold in its hand, and the time stamps made from it.

use std::sync::Arc;
#[cfg(test)]
use std::sync::atomic::{AtomicI64, Ordering};

use serde::{Serialize, Serializer};

/// A moment in milliseconds since 1970, UTC. It is RFC 3339 text in JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct WallTime(pub i64);

impl WallTime {
    /// The moment `ms` milliseconds later.
    pub fn plus_ms(self, ms: i64) -> Self {
        Self(self.0.saturating_add(ms))
    }
}

impl Serialize for WallTime {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let timestamp = jiff::Timestamp::from_millisecond(self.0)
            .map_err(|_| serde::ser::Error::custom("a time out of range"))?;
        serializer.collect_str(&format_args!("{timestamp:.3}"))
    }
}

/// Tells the time.
pub trait Clock: Send + Sync + 'static {
    /// The present moment.
    fn now(&self) -> WallTime;
}

/// A clock that many parts of the server share.
pub type SharedClock = Arc<dyn Clock>;

/// The computer's clock.
pub struct SystemClock;

impl Clock for SystemClock {
    fn now(&self) -> WallTime {
        WallTime(jiff::Timestamp::now().as_millisecond())
    }
}

/// A clock that stands still until it is moved, for tests of leases and expiry.
#[cfg(test)]
pub(crate) struct FixedClock(AtomicI64);

#[cfg(test)]
impl FixedClock {
    /// A clock that shows `now`.
    pub(crate) fn at(now: WallTime) -> Arc<Self> {
        Arc::new(Self(AtomicI64::new(now.0)))
    }

    /// Moves the clock forward.
    pub(crate) fn advance_ms(&self, ms: i64) {
        self.0.fetch_add(ms, Ordering::SeqCst);
    }
}

#[cfg(test)]
impl Clock for FixedClock {
    fn now(&self) -> WallTime {
        WallTime(self.0.load(Ordering::SeqCst))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moment_is_rfc_3339_text_with_milliseconds() {
        let text = serde_json::to_string(&WallTime(1_700_000_000_120)).unwrap();
        assert_eq!(text, "\"2023-11-14T22:13:20.120Z\"");
    }
}
