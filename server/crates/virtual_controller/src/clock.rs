//! Wall time, read in one place; everything else gets it as an argument.

use std::fmt;
use std::time::{SystemTime, UNIX_EPOCH};

/// Wall time since 1970-01-01, UTC.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WallTime {
    /// Whole seconds.
    pub seconds: u64,
    /// Microseconds of the second.
    pub microseconds: u32,
}

impl WallTime {
    /// The present time.
    #[must_use]
    pub fn now() -> Self {
        // A clock before 1970 would be a broken machine; the epoch is as good as any value then.
        let since = SystemTime::now()
            .duration_since(UNIX_EPOCH)
            .unwrap_or_default();
        Self {
            seconds: since.as_secs(),
            microseconds: since.subsec_micros(),
        }
    }
}

/// As the controller's event log writes it: `YYYY-MM-DD T HH:MM:SS`.
impl fmt::Display for WallTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let days = self.seconds / 86_400;
        let second = self.seconds % 86_400;
        let (year, month, day) = civil_date(days);
        write!(
            f,
            "{year:04}-{month:02}-{day:02} T {:02}:{:02}:{:02}",
            second / 3600,
            second / 60 % 60,
            second % 60
        )
    }
}

/// Year, month and day of a day counted from 1970-01-01.
fn civil_date(mut days: u64) -> (u64, u64, u64) {
    let leap = |year: u64| {
        year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400))
    };
    let mut year = 1970;
    loop {
        let length = if leap(year) { 366 } else { 365 };
        if days < length {
            break;
        }
        days -= length;
        year += 1;
    }
    let february = if leap(year) { 29 } else { 28 };
    let mut month = 1;
    for length in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    (year, month, days + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(seconds: u64) -> String {
        WallTime {
            seconds,
            microseconds: 0,
        }
        .to_string()
    }

    #[test]
    fn known_dates_are_written_right() {
        assert_eq!(at(0), "1970-01-01 T 00:00:00");
        assert_eq!(at(951_782_400), "2000-02-29 T 00:00:00");
        assert_eq!(at(1_700_000_000), "2023-11-14 T 22:13:20");
    }
}
