//! The bytes of a recording's chunk.
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
    let records = checked(bytes, record_bytes(columns), crc32, "recording")?;
    Ok(records
        .map(|record| Sample {
            at_us: at_us(record),
            joints_deg: numbers(record, 0),
            tcp_mm: (columns == 9).then(|| numbers(record, 6)),
        })
        .collect())
}

fn record_bytes(columns: usize) -> usize {
    8 * (columns + 1)
}

pub(super) fn checked<'a>(
    bytes: &'a [u8],
    record_bytes: usize,
    crc32: u32,
    what: &'static str,
) -> Result<std::slice::ChunksExact<'a, u8>> {
    if crc32fast::hash(bytes) != crc32 || !bytes.len().is_multiple_of(record_bytes) {
        return Err(Error::Damaged { what });
    }
    Ok(bytes.chunks_exact(record_bytes))
}

pub(super) fn put(bytes: &mut Vec<u8>, values: &[f64]) {
    for value in values {
        bytes.extend_from_slice(&value.to_le_bytes());
    }
}

pub(super) fn word(record: &[u8], index: usize) -> [u8; 8] {
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
    }
}
