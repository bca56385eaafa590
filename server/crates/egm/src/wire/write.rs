//! The writer of our references.

use motion::{JOINTS, JointAngles, JointVelocities};

use crate::error::Error;
use crate::header::{ControllerTime, SequenceNumber};
use crate::messages::MessageType;

/// One reference for the controller: where the arm is to be and how fast it is to move there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correction {
    /// `header.seqno`
    pub sequence: SequenceNumber,
    /// `header.tm`
    pub sent_at: ControllerTime,
    /// `planned.joints`, deg
    pub joints: JointAngles,
    /// `speedRef.joints`, deg/s. Without it the arm lags behind the positions.
    pub velocities: JointVelocities,
}

/// Key and eight bytes for each joint.
const JOINT_LIST_BYTES: usize = JOINTS * 9;
/// A message that holds a joint list: two keys, two lengths, and the list.
const POSITION_BYTES: usize = 4 + JOINT_LIST_BYTES;
/// Key, length, and three fields: two counters of at most five bytes and the kind.
const MAX_HEADER_BYTES: usize = 2 + 6 + 6 + 2;

/// The most bytes [`encode_correction`] writes.
pub const MAX_CORRECTION_BYTES: usize = MAX_HEADER_BYTES + 2 * POSITION_BYTES;

/// Writes `correction` as an `EgmSensor` at the start of `buffer` and returns its length in bytes.
///
/// Doubles are written unpacked, and the kind of the message is `CORRECTION`. Never allocates.
///
/// # Errors
/// [`Error::NotFinite`] when a value is not a finite number, [`Error::BufferTooSmall`] when the
/// buffer has fewer than [`MAX_CORRECTION_BYTES`] bytes. Nothing usable is in the buffer then.
pub fn encode_correction(correction: &Correction, buffer: &mut [u8]) -> Result<usize, Error> {
    let angles = &correction.joints.0;
    let speeds = &correction.velocities.0;
    if !angles.iter().all(|value| value.is_finite()) {
        return Err(Error::NotFinite {
            field: "planned.joints",
        });
    }
    if !speeds.iter().all(|value| value.is_finite()) {
        return Err(Error::NotFinite {
            field: "speedRef.joints",
        });
    }
    if buffer.len() < MAX_CORRECTION_BYTES {
        return Err(Error::BufferTooSmall {
            needed: MAX_CORRECTION_BYTES,
            given: buffer.len(),
        });
    }
    let (sequence, sent_at) = (correction.sequence.0, correction.sent_at.0);
    let header_bytes = 4 + varint_length(sequence) + varint_length(sent_at);
    let mut out = Writer { buffer, length: 0 };
    out.bytes(&[key(1, 2), header_bytes]);
    out.bytes(&[key(1, 0)]);
    out.varint(sequence);
    out.bytes(&[key(2, 0)]);
    out.varint(sent_at);
    out.bytes(&[key(3, 0), MessageType::Correction as u8]);
    out.position(2, angles);
    out.position(3, speeds);
    Ok(out.length)
}

/// The key of a field with a number below 16.
const fn key(number: u8, wire_type: u8) -> u8 {
    number << 3 | wire_type
}

fn varint_length(value: u32) -> u8 {
    match value {
        0..0x80 => 1,
        0x80..0x4000 => 2,
        0x4000..0x20_0000 => 3,
        0x20_0000..0x1000_0000 => 4,
        0x1000_0000.. => 5,
    }
}

struct Writer<'a> {
    buffer: &'a mut [u8],
    length: usize,
}

impl Writer<'_> {
    fn bytes(&mut self, bytes: &[u8]) {
        let end = self.length + bytes.len();
        self.buffer[self.length..end].copy_from_slice(bytes);
        self.length = end;
    }

    fn varint(&mut self, mut value: u32) {
        while value >= 0x80 {
            self.bytes(&[value as u8 | 0x80]);
            value >>= 7;
        }
        self.bytes(&[value as u8]);
    }

    /// `EgmPlanned` or `EgmSpeedRef` with joints alone.
    fn position(&mut self, number: u8, joints: &[f64; JOINTS]) {
        const LIST: u8 = JOINT_LIST_BYTES as u8;
        self.bytes(&[key(number, 2), LIST + 2, key(1, 2), LIST]);
        for value in joints {
            self.bytes(&[key(1, 1)]);
            self.bytes(&value.to_le_bytes());
        }
    }
}
