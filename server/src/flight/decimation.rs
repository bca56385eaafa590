//! Thinning a record out for a plot without losing its extremes.
//!
//! The stretch is cut into spans of equal time. Each keeps its first cycle, the lowest and the
//! highest value of every joint, and counts what was out of the ordinary. The last cycle of the
//! stretch has a span of its own, so that both ends of the curve are exact.

use crate::store::cycles::Cycle;
use crate::store::flights::Stretch;

/// The cycles of one span.
#[derive(Clone, Debug, PartialEq)]
pub struct Bucket {
    index: u128,
    /// The first of them.
    pub first: Cycle,
    /// Lowest commanded angles, in degrees.
    pub commanded_min_deg: [f64; 6],
    /// Highest commanded angles, in degrees.
    pub commanded_max_deg: [f64; 6],
    /// Lowest measured angles, in degrees.
    pub measured_min_deg: [f64; 6],
    /// Highest measured angles, in degrees.
    pub measured_max_deg: [f64; 6],
    /// Largest distances of the measured from the commanded angles, in degrees.
    pub error_max_deg: [f64; 6],
    /// Messages that never came.
    pub lost: u64,
    /// Messages that came late.
    pub late: u64,
    /// Cycles in which the arm was held.
    pub held: u64,
    /// Cycles in which the setpoint was slowed down.
    pub limited: u64,
}

/// Takes in a record and keeps at most so many points of it.
pub struct Decimation {
    stretch: Stretch,
    spans: u128,
    buckets: Vec<Bucket>,
}

impl Decimation {
    /// For a stretch of a record, thinned out to at most `points`, which is 2 or more.
    pub fn new(stretch: Stretch, points: usize) -> Self {
        Self {
            stretch,
            spans: points.saturating_sub(1).max(1) as u128,
            buckets: Vec::new(),
        }
    }

    /// The next cycles, all within the stretch.
    pub fn add(&mut self, cycles: &[Cycle]) {
        for cycle in cycles {
            let index = self.index(cycle.at_us);
            match self.buckets.last_mut() {
                Some(bucket) if bucket.index == index => bucket.add(cycle),
                _ => self.buckets.push(Bucket::new(index, cycle)),
            }
        }
    }

    /// What is left of the record.
    pub fn finish(self) -> Vec<Bucket> {
        self.buckets
    }

    fn index(&self, at_us: u64) -> u128 {
        let length = u128::from(self.stretch.to_us.saturating_sub(self.stretch.from_us)).max(1);
        let from_start = u128::from(at_us.saturating_sub(self.stretch.from_us));
        (from_start * self.spans / length).min(self.spans)
    }
}

impl Bucket {
    fn new(index: u128, cycle: &Cycle) -> Self {
        let mut bucket = Self {
            index,
            first: *cycle,
            commanded_min_deg: cycle.commanded_deg,
            commanded_max_deg: cycle.commanded_deg,
            measured_min_deg: cycle.measured_deg,
            measured_max_deg: cycle.measured_deg,
            error_max_deg: [0.0; 6],
            lost: 0,
            late: 0,
            held: 0,
            limited: 0,
        };
        bucket.add(cycle);
        bucket
    }

    fn add(&mut self, cycle: &Cycle) {
        for joint in 0..6 {
            let (commanded, measured) = (cycle.commanded_deg[joint], cycle.measured_deg[joint]);
            lower(&mut self.commanded_min_deg[joint], commanded);
            raise(&mut self.commanded_max_deg[joint], commanded);
            lower(&mut self.measured_min_deg[joint], measured);
            raise(&mut self.measured_max_deg[joint], measured);
            raise(&mut self.error_max_deg[joint], (commanded - measured).abs());
        }
        if let Some(details) = &cycle.details {
            self.lost += u64::from(details.lost);
            self.late += u64::from(details.late);
            self.held += u64::from(details.held);
            self.limited += u64::from(details.limited);
        }
    }
}

fn lower(lowest: &mut f64, value: f64) {
    *lowest = lowest.min(value);
}

fn raise(highest: &mut f64, value: f64) {
    *highest = highest.max(value);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::cycles::tests::record;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn both_ends_and_every_extreme_survive(cycles in record(400), points in 2usize..60) {
            let (first, last) = (cycles[0], cycles[cycles.len() - 1]);
            let stretch = Stretch { from_us: first.at_us, to_us: last.at_us };
            let mut decimation = Decimation::new(stretch, points);
            cycles.chunks(17).for_each(|page| decimation.add(page));
            let buckets = decimation.finish();
            prop_assert!(buckets.len() <= points);
            prop_assert_eq!(buckets[0].first, first);
            prop_assert_eq!(buckets[buckets.len() - 1].first, last);
            let times: Vec<u64> = buckets.iter().map(|bucket| bucket.first.at_us).collect();
            prop_assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
            for joint in 0..6 {
                let most = |of: &dyn Fn(&Cycle) -> f64| cycles.iter().map(of).fold(f64::MIN, f64::max);
                let kept = |of: &dyn Fn(&Bucket) -> f64| buckets.iter().map(of).fold(f64::MIN, f64::max);
                prop_assert_eq!(most(&|c| c.measured_deg[joint]), kept(&|b| b.measured_max_deg[joint]));
                prop_assert_eq!(most(&|c| -c.measured_deg[joint]), kept(&|b| -b.measured_min_deg[joint]));
                prop_assert_eq!(most(&|c| c.commanded_deg[joint]), kept(&|b| b.commanded_max_deg[joint]));
                prop_assert_eq!(most(&|c| -c.commanded_deg[joint]), kept(&|b| -b.commanded_min_deg[joint]));
                let error = |c: &Cycle| (c.commanded_deg[joint] - c.measured_deg[joint]).abs();
                prop_assert_eq!(most(&error), kept(&|b| b.error_max_deg[joint]));
            }
            let lost: u64 = cycles.iter().filter_map(|c| c.details).map(|d| u64::from(d.lost)).sum();
            prop_assert_eq!(buckets.iter().map(|bucket| bucket.lost).sum::<u64>(), lost);
        }
    }
}
