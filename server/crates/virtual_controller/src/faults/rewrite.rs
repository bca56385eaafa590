//! Changes to a datagram that its encoder would refuse to make, or that leave the rest of it alone.

use egm::codec;
use egm::messages::EgmHeader;

use super::script::Direction;

/// Keys of the path to a joint angle, the same in both kinds of messages: `feedBack` or `planned`
/// (field 2), its `joints` (field 1), and one angle (field 1, a double).
const POSITION: u8 = 2 << 3 | 2;
const JOINTS: u8 = 1 << 3 | 2;
const ANGLE: u8 = 1 << 3 | 1;

/// The number of a message.
pub fn number(datagram: &[u8], direction: Direction) -> Option<u32> {
    let header = match direction {
        Direction::ToRobot => codec::decode_sensor(datagram).ok()?.header,
        _ => codec::decode_robot(datagram).ok()?.header,
    };
    header?.seqno
}

/// Gives a message another number. What is no message, or holds what is no number, stays.
pub fn set_number(datagram: &mut Vec<u8>, direction: Direction, number: u32) {
    let renumber = |header: &mut Option<EgmHeader>| {
        header.get_or_insert_default().seqno = Some(number);
    };
    let mut out = Vec::new();
    let written = match direction {
        Direction::ToRobot => codec::decode_sensor(datagram).and_then(|mut message| {
            renumber(&mut message.header);
            codec::encode_sensor(&message, &mut out)
        }),
        _ => codec::decode_robot(datagram).and_then(|mut message| {
            renumber(&mut message.header);
            codec::encode_robot(&message, &mut out)
        }),
    };
    if written.is_ok() {
        *datagram = out;
    }
}

/// Puts another value in the place of a joint's angle (joint from 1). Without that joint in the
/// message, nothing happens.
pub fn set_angle(datagram: &mut [u8], joint: u32, value: f64) {
    let place = angle_at(datagram, joint as usize - 1);
    if let Some(bytes) = place.and_then(|at| datagram.get_mut(at..at + 8)) {
        bytes.copy_from_slice(&value.to_le_bytes());
    }
}

/// Where the eight bytes of an angle are.
fn angle_at(datagram: &[u8], index: usize) -> Option<usize> {
    let whole = 0..datagram.len();
    let position = fields(datagram, whole).find(|(key, _)| *key == POSITION)?;
    let joints = fields(datagram, position.1).find(|(key, _)| *key == JOINTS)?;
    let mut angles = fields(datagram, joints.1).filter(|(key, _)| *key == ANGLE);
    Some(angles.nth(index)?.1.start)
}

/// The fields of a message: key, and where the content is. Ends at what it does not understand.
fn fields(
    datagram: &[u8],
    within: std::ops::Range<usize>,
) -> impl Iterator<Item = (u8, std::ops::Range<usize>)> {
    let end = within.end;
    let mut at = within.start;
    std::iter::from_fn(move || {
        let key = *datagram[..end].get(at)?;
        let begin = at + 1;
        let range = match key & 7 {
            0 => begin..begin + varint(&datagram[..end], begin)?.1,
            1 => begin..begin + 8,
            2 => {
                let (length, bytes) = varint(&datagram[..end], begin)?;
                begin + bytes..(begin + bytes).checked_add(length)?
            }
            _ => return None,
        };
        at = range.end;
        (at <= end).then_some((key, range))
    })
}

/// A length and how many bytes it takes.
fn varint(bytes: &[u8], at: usize) -> Option<(usize, usize)> {
    let mut value = 0usize;
    for place in 0..5 {
        let byte = *bytes.get(at + place)?;
        value |= usize::from(byte & 0x7f) << (7 * place);
        if byte < 0x80 {
            return Some((value, place + 1));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use egm::messages::{EgmFeedBack, EgmJoints, EgmRobot};
    use egm::{Error, SequenceNumber, read_feedback};

    fn message() -> Vec<u8> {
        let message = EgmRobot {
            header: Some(EgmHeader {
                seqno: Some(300),
                tm: Some(4),
                mtype: Some(2),
            }),
            feed_back: Some(EgmFeedBack {
                joints: Some(EgmJoints {
                    joints: vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
                }),
                ..EgmFeedBack::default()
            }),
            ..EgmRobot::default()
        };
        let mut datagram = Vec::new();
        codec::encode_robot(&message, &mut datagram).unwrap();
        datagram
    }

    #[test]
    fn one_angle_changes_and_nothing_else() {
        let mut datagram = message();
        set_angle(&mut datagram, 3, -40.5);
        let feedback = read_feedback(&datagram).unwrap();
        let angles = feedback.feedback.unwrap().0;
        assert_eq!(angles, [1.0, 2.0, -40.5, 4.0, 5.0, 6.0]);
        assert_eq!(feedback.sequence, Some(SequenceNumber(300)));
        set_angle(&mut datagram, 6, f64::NAN);
        assert!(matches!(
            read_feedback(&datagram),
            Err(Error::NotFinite { .. })
        ));
    }

    #[test]
    fn a_number_is_replaced_and_what_is_no_message_stays() {
        let mut datagram = message();
        set_number(&mut datagram, Direction::ToServer, 7);
        assert_eq!(number(&datagram, Direction::ToServer), Some(7));
        assert_eq!(read_feedback(&datagram).unwrap().sent_at.unwrap().0, 4);
        let mut garbage = vec![0xff; 9];
        set_number(&mut garbage, Direction::ToServer, 7);
        set_number(&mut garbage, Direction::ToRobot, 7);
        set_angle(&mut garbage, 1, 0.0);
        assert_eq!(garbage, vec![0xff; 9]);
    }

    #[test]
    fn a_cut_message_is_left_alone_without_a_panic() {
        let whole = message();
        for length in 0..whole.len() {
            let mut cut = whole[..length].to_vec();
            for joint in 1..=6 {
                set_angle(&mut cut, joint, 0.0);
            }
            assert_eq!(cut.len(), length);
        }
    }
}
