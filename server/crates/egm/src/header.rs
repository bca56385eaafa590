//! The two counters of an EGM header, with the wrapping arithmetic they need.

/// Message counter of one sender: 0 at the start of a session, then one more for each message.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct SequenceNumber(pub u32);

impl SequenceNumber {
    /// The number of the next message; 0 follows the largest one.
    #[must_use]
    pub fn next(self) -> Self {
        Self(self.0.wrapping_add(1))
    }

    /// How many messages this one comes after `earlier`; negative when it comes before it.
    ///
    /// The shorter way round the circle of 2^32 numbers counts.
    #[must_use]
    pub fn steps_since(self, earlier: Self) -> i32 {
        self.0.wrapping_sub(earlier.0).cast_signed()
    }
}

/// Time stamp of one sender in milliseconds; wraps after about 49.7 days.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ControllerTime(pub u32);

impl ControllerTime {
    /// Milliseconds from `earlier` to this time; negative when it is before it.
    #[must_use]
    pub fn ms_since(self, earlier: Self) -> i32 {
        self.0.wrapping_sub(earlier.0).cast_signed()
    }

    /// This time plus `ms` milliseconds.
    #[must_use]
    pub fn plus_ms(self, ms: u32) -> Self {
        Self(self.0.wrapping_add(ms))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_counter_goes_on_across_its_wrap() {
        let last = SequenceNumber(u32::MAX);
        assert_eq!(last.next(), SequenceNumber(0));
        assert_eq!(last.next().steps_since(last), 1);
        assert_eq!(last.steps_since(last.next()), -1);
    }

    #[test]
    fn time_differences_survive_the_wrap() {
        let before = ControllerTime(u32::MAX - 1);
        assert_eq!(before.plus_ms(4), ControllerTime(2));
        assert_eq!(before.plus_ms(4).ms_since(before), 4);
        assert_eq!(before.ms_since(before.plus_ms(4)), -4);
    }
}
