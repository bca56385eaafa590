//! The errors of this crate.

/// Why a datagram could not be read or written.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// The datagram ends in the middle of a field.
    #[error("the EGM message ends in the middle of a field, after byte {at}")]
    Truncated {
        /// Offset of the field that is incomplete.
        at: usize,
    },
    /// The bytes at this offset are no valid protobuf.
    #[error("the EGM message is malformed at byte {at}")]
    Malformed {
        /// Offset of the first byte that makes no sense.
        at: usize,
    },
    /// The datagram is no valid message (reported by the general decoder).
    #[error("the EGM message is malformed: {0}")]
    Decode(#[from] prost::DecodeError),
    /// A value is not a finite number.
    #[error("the EGM field {field} holds a value that is not a finite number")]
    NotFinite {
        /// The field's name in the message.
        field: &'static str,
    },
    /// The caller's buffer cannot hold the message.
    #[error("the EGM message needs {needed} bytes, the buffer has {given}")]
    BufferTooSmall {
        /// Bytes the message needs.
        needed: usize,
        /// Bytes the buffer has.
        given: usize,
    },
}
