//! The bytes of a recording's chunk and of a reproduction's chunk.
//!
//! Fixed-size little-endian records with a CRC-32 beside them, so that a torn or rotten chunk is
//! noticed instead of being taught to the arm.

use super::{Error, Result};

/// One sample of a demonstration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Microseconds since the demonstration began.
    pub at_us: u64,
    /// Joint angles in degrees.
    pub joints_deg: [f64; 6],
    /// Tool position in millimetres, when the recording came with one.
    pub tcp_mm: Option<[f64; 3]>,
}

/// One control cycle of a reproduction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// Microseconds since the motion began.
    pub at_us: u64,
    /// Where in the plan the arm was asked to be, in seconds.
    pub plan_t_s: f64,
    /// Joint angles asked for, in degrees.
    pub commanded_deg: [f64; 6],
    /// Joint angles that the controller reported, in degrees.
    pub measured_deg: [f64; 6],
}

/// The number of `f64` columns that these samples need: 6, or 9 with tool positions.
pub(super) fn columns(samples: &[Sample]) -> usize {
    if samples.iter().all(|s| s.tcp_mm.is_some()) && !samples.is_empty() {
        9
    } else {
        6
    }
}

pub(super) fn encode_samples(samples: &[Sample], columns: usize) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(samples.len() * record_bytes(columns));
    for sample in samples {
        bytes.extend_from_slice(&sample.at_us.to_le_bytes());
        put(&mut bytes, &sample.joints_deg);
        if columns == 9 {
            put(&mut bytes, &sample.tcp_mm.unwrap_or_default());
        }
    }
    bytes
}

pub(super) fn decode_samples(bytes: &[u8], columns: usize, crc32: u32) -> Result<Vec<Sample>> {
    let records = checked(bytes, columns, crc32, "recording")?;
    Ok(records
        .map(|record| Sample {
            at_us: at_us(record),
            joints_deg: numbers(record, 0),
            tcp_mm: (columns == 9).then(|| numbers(record, 6)),
        })
        .collect())
}

const CYCLE_COLUMNS: usize = 13;

pub(super) fn encode_cycles(cycles: &[Cycle]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(cycles.len() * record_bytes(CYCLE_COLUMNS));
    for cycle in cycles {
        bytes.extend_from_slice(&cycle.at_us.to_le_bytes());
        put(&mut bytes, &[cycle.plan_t_s]);
        put(&mut bytes, &cycle.commanded_deg);
        put(&mut bytes, &cycle.measured_deg);
    }
    bytes
}

pub(super) fn decode_cycles(bytes: &[u8], crc32: u32) -> Result<Vec<Cycle>> {
    let records = checked(bytes, CYCLE_COLUMNS, crc32, "reproduction")?;
    Ok(records
        .map(|record| Cycle {
            at_us: at_us(record),
            plan_t_s: numbers::<1>(record, 0)[0],
            commanded_deg: numbers(record, 1),
            measured_deg: numbers(record, 7),
        })
        .collect())
}

fn record_bytes(columns: usize) -> usize {
    8 * (columns + 1)
}

fn checked<'a>(
    bytes: &'a [u8],
    columns: usize,
    crc32: u32,
    what: &'static str,
) -> Result<std::slice::ChunksExact<'a, u8>> {
    if crc32fast::hash(bytes) != crc32 || !bytes.len().is_multiple_of(record_bytes(columns)) {
        return Err(Error::Damaged { what });
    }
    Ok(bytes.chunks_exact(record_bytes(columns)))
}

fn put(bytes: &mut Vec<u8>, values: &[f64]) {
    for value in values {
        bytes.extend_from_slice(&value.to_le_bytes());
    }
}

fn word(record: &[u8], index: usize) -> [u8; 8] {
    std::array::from_fn(|i| record[8 * index + i])
}

fn at_us(record: &[u8]) -> u64 {
    u64::from_le_bytes(word(record, 0))
}

fn numbers<const N: usize>(record: &[u8], first: usize) -> [f64; N] {
    std::array::from_fn(|i| f64::from_le_bytes(word(record, 1 + first + i)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = f64> {
        -1e6..1e6_f64
    }

    proptest! {
        #[test]
        fn samples_come_back_bit_for_bit(
            rows in prop::collection::vec(
                (any::<u64>(), prop::array::uniform6(number()), prop::array::uniform3(number())),
                1..40,
            ),
            with_tcp in any::<bool>(),
        ) {
            let samples: Vec<Sample> = rows
                .into_iter()
                .map(|(at_us, joints_deg, tcp)| Sample {
                    at_us,
                    joints_deg,
                    tcp_mm: with_tcp.then_some(tcp),
                })
                .collect();
            let columns = columns(&samples);
            let bytes = encode_samples(&samples, columns);
            let back = decode_samples(&bytes, columns, crc32fast::hash(&bytes)).unwrap();
            prop_assert_eq!(back, samples);
        }

        #[test]
        fn one_changed_bit_is_noticed(at in 0usize..112, bit in 0u8..8) {
            let cycles = [Cycle {
                at_us: 4_000,
                plan_t_s: 0.004,
                commanded_deg: [1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
                measured_deg: [1.1, 2.1, 3.1, 4.1, 5.1, 6.1],
            }];
            let mut bytes = encode_cycles(&cycles);
            let crc32 = crc32fast::hash(&bytes);
            prop_assert_eq!(&decode_cycles(&bytes, crc32).unwrap()[..], &cycles[..]);
            bytes[at] ^= 1 << bit;
            let damaged = matches!(decode_cycles(&bytes, crc32), Err(Error::Damaged { .. }));
            prop_assert!(damaged);
        }
    }
}
