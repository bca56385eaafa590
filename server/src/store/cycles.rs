//! One control cycle of a reproduction, and the bytes of a chunk of them.
//!
//! Two layouts: what is written now, and the first one, which told less. Both are described in
//! `migrations`.

use super::samples::{checked, put, word};
use super::text::words;
use super::{Error, Result};

words!(
    /// What the arm was doing. The order is that of `PHASES`: new ones come last.
    CyclePhase {
        /// On the way to the start of the motion.
        Approach = "approach",
        /// In the motion.
        Motion = "motion",
        /// At the end of the plan, waiting for the arm to arrive.
        Settling = "settling",
        /// Coming to a standstill.
        Stopping = "stopping",
        /// Standing on the path until it is to go on.
        Paused = "paused",
    }
);

/// Phases by the number that stands for them in a chunk. Only ever added to.
const PHASES: [CyclePhase; 5] = [
    CyclePhase::Approach,
    CyclePhase::Motion,
    CyclePhase::Settling,
    CyclePhase::Stopping,
    CyclePhase::Paused,
];

/// One control cycle of a reproduction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// Microseconds since the motion was armed.
    pub at_us: u64,
    /// Where in the plan the arm was asked to be, in seconds.
    pub plan_t_s: f64,
    /// Joint angles asked for, in degrees.
    pub commanded_deg: [f64; 6],
    /// Joint angles that the controller reported, in degrees.
    pub measured_deg: [f64; 6],
    /// The rest; nothing in a record of the first layout.
    pub details: Option<CycleDetails>,
}

/// What else is known of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CycleDetails {
    /// Speeds asked for, in degrees per second.
    pub commanded_deg_s: [f32; 6],
    /// How much of what the arm can do the reference needed, if the controller said so, in percent.
    pub utilization_percent: Option<f32>,
    /// Messages missing right before this one.
    pub lost: u32,
    /// What the arm was doing.
    pub phase: CyclePhase,
    /// The message came late.
    pub late: bool,
    /// The answer was not the setpoint: the arm was held.
    pub held: bool,
    /// The setpoint was slowed down to stay within the limits.
    pub limited: bool,
    /// The controller reported motors on.
    pub motors_on: bool,
    /// The controller reported that its program runs.
    pub rapid_running: bool,
}

/// The layout that is written.
pub(super) const LAYOUT: i64 = 2;
const FIRST_LAYOUT: i64 = 1;

/// Time, plan time, and two sets of angles.
const COMMON_BYTES: usize = 8 * 14;
/// Speeds, utilisation, lost, phase, bits.
const DETAIL_BYTES: usize = 4 * 6 + 4 + 4 + 1 + 1;

pub(super) fn encode(cycles: &[Cycle]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(cycles.len() * (COMMON_BYTES + DETAIL_BYTES));
    for cycle in cycles {
        bytes.extend_from_slice(&cycle.at_us.to_le_bytes());
        put(&mut bytes, &[cycle.plan_t_s]);
        put(&mut bytes, &cycle.commanded_deg);
        put(&mut bytes, &cycle.measured_deg);
        put_details(&mut bytes, cycle.details.as_ref());
    }
    bytes
}

/// A cycle without details is never written: only old records lack them, and those stay as they are.
fn put_details(bytes: &mut Vec<u8>, details: Option<&CycleDetails>) {
    let Some(details) = details else {
        bytes.extend_from_slice(&[0; DETAIL_BYTES]);
        return;
    };
    for speed in details.commanded_deg_s {
        bytes.extend_from_slice(&speed.to_le_bytes());
    }
    let utilization = details.utilization_percent.unwrap_or(f32::NAN);
    bytes.extend_from_slice(&utilization.to_le_bytes());
    bytes.extend_from_slice(&details.lost.to_le_bytes());
    bytes.push(details.phase as u8);
    let bits = [
        details.late,
        details.held,
        details.limited,
        details.motors_on,
        details.rapid_running,
    ];
    bytes.push(
        bits.iter()
            .enumerate()
            .fold(0, |byte, (at, bit)| byte | u8::from(*bit) << at),
    );
}

pub(super) fn decode(bytes: &[u8], layout: i64, crc32: u32) -> Result<Vec<Cycle>> {
    let damaged = || Error::Damaged {
        what: "reproduction",
    };
    let length = match layout {
        FIRST_LAYOUT => COMMON_BYTES,
        LAYOUT => COMMON_BYTES + DETAIL_BYTES,
        _ => return Err(damaged()),
    };
    checked(bytes, length, crc32, "reproduction")?
        .map(|record| {
            let (common, details) = record.split_at(COMMON_BYTES);
            let angle = |at: usize| f64::from_le_bytes(word(common, at));
            Ok(Cycle {
                at_us: u64::from_le_bytes(word(common, 0)),
                plan_t_s: angle(1),
                commanded_deg: std::array::from_fn(|joint| angle(2 + joint)),
                measured_deg: std::array::from_fn(|joint| angle(8 + joint)),
                details: match layout {
                    FIRST_LAYOUT => None,
                    _ => Some(read_details(details).ok_or_else(damaged)?),
                },
            })
        })
        .collect()
}

fn read_details(bytes: &[u8]) -> Option<CycleDetails> {
    let four = |at: usize| std::array::from_fn::<u8, 4, _>(|i| bytes[4 * at + i]);
    let utilization = f32::from_le_bytes(four(6));
    let bit = |at: u8| bytes[33] & (1 << at) != 0;
    Some(CycleDetails {
        commanded_deg_s: std::array::from_fn(|joint| f32::from_le_bytes(four(joint))),
        utilization_percent: Some(utilization).filter(|known| !known.is_nan()),
        lost: u32::from_le_bytes(four(7)),
        phase: *PHASES.get(usize::from(bytes[32]))?,
        late: bit(0),
        held: bit(1),
        limited: bit(2),
        motors_on: bit(3),
        rapid_running: bit(4),
    })
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use proptest::prelude::*;

    prop_compose! {
        fn details()(
            commanded_deg_s in prop::array::uniform6(-200.0..200.0_f32),
            utilization_percent in prop::option::of(0.0..200.0_f32),
            lost in any::<u32>(),
            phase in 0..PHASES.len(),
            bits in prop::array::uniform5(any::<bool>()),
        ) -> CycleDetails {
            let [late, held, limited, motors_on, rapid_running] = bits;
            CycleDetails {
                commanded_deg_s, utilization_percent, lost, phase: PHASES[phase],
                late, held, limited, motors_on, rapid_running,
            }
        }
    }

    prop_compose! {
        /// Any cycle, of which the time is to be set.
        pub(crate) fn cycle()(
            plan_t_s in 0.0..1e4_f64,
            commanded_deg in prop::array::uniform6(-400.0..400.0_f64),
            measured_deg in prop::array::uniform6(-400.0..400.0_f64),
            details in details(),
        ) -> Cycle {
            Cycle { at_us: 0, plan_t_s, commanded_deg, measured_deg, details: Some(details) }
        }
    }

    /// A record: times 1 to 12 ms apart.
    pub(crate) fn record(longest: usize) -> impl Strategy<Value = Vec<Cycle>> {
        prop::collection::vec((cycle(), 1_000..12_000_u64), 1..longest).prop_map(|rows| {
            let mut at_us = 0;
            let timed = rows.into_iter().map(|(cycle, step_us)| {
                at_us += step_us;
                Cycle { at_us, ..cycle }
            });
            timed.collect()
        })
    }

    proptest! {
        #[test]
        fn cycles_come_back_bit_for_bit_and_a_changed_bit_is_noticed(
            cycles in record(20), at in any::<prop::sample::Index>(), bit in 0u8..8,
        ) {
            let mut bytes = encode(&cycles);
            let crc32 = crc32fast::hash(&bytes);
            prop_assert_eq!(&decode(&bytes, LAYOUT, crc32).unwrap(), &cycles);
            bytes[at.index(cycles.len())] ^= 1 << bit;
            let damaged = matches!(decode(&bytes, LAYOUT, crc32), Err(Error::Damaged { .. }));
            prop_assert!(damaged);
        }
    }

    #[test]
    fn a_record_of_the_first_layout_can_still_be_read() {
        let mut bytes = 8_000_u64.to_le_bytes().to_vec();
        put(&mut bytes, &[0.5]);
        put(&mut bytes, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        put(&mut bytes, &[1.5, 2.5, 3.5, 4.5, 5.5, 6.5]);
        let read = decode(&bytes, 1, crc32fast::hash(&bytes)).unwrap();
        let expected = Cycle {
            at_us: 8_000,
            plan_t_s: 0.5,
            commanded_deg: [1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
            measured_deg: [1.5, 2.5, 3.5, 4.5, 5.5, 6.5],
            details: None,
        };
        assert_eq!(read, [expected]);
        let unknown = decode(&bytes, 3, crc32fast::hash(&bytes));
        assert!(matches!(unknown, Err(Error::Damaged { .. })));
    }
}
