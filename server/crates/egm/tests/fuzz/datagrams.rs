//! Datagrams of all kinds of wrongness: messages of both directions, damaged, and random bytes.
//!
//! The seed decides everything. Nothing is allocated from one datagram to the next.

use egm::messages::{EgmMeasuredForce, MessageType};
use egm::{
    ControllerTime, Correction, MAX_CORRECTION_BYTES, MAX_DATAGRAM_BYTES, SequenceNumber, codec,
    encode_correction,
};
use motion::{JointAngles, JointVelocities};
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

/// Bytes that mean something at many places: keys of the fields of a message, ends of varints,
/// lengths that reach beyond the datagram.
const TELLING: [u8; 16] = [
    0x00, 0x01, 0x08, 0x09, 0x0a, 0x12, 0x1a, 0x4a, 0x0b, 0x0c, 0x7f, 0x80, 0xff, 0xfe, 0x36, 0xf0,
];

/// The source of the datagrams.
pub struct Datagrams {
    random: Xoshiro256PlusPlus,
    whole: Vec<Vec<u8>>,
    next: Vec<u8>,
}

impl Datagrams {
    pub fn new(seed: u64) -> Self {
        Self {
            random: Xoshiro256PlusPlus::seed_from_u64(seed),
            whole: whole_messages(),
            next: Vec::with_capacity(2 * MAX_DATAGRAM_BYTES),
        }
    }

    /// The next datagram, at most as long as the largest that is received.
    pub fn next(&mut self) -> &[u8] {
        self.next.clear();
        if self.below(10) == 0 {
            let length = self.below(MAX_DATAGRAM_BYTES + 1);
            self.next.resize(length, 0);
            self.random.fill_bytes(&mut self.next);
        } else {
            let message = self.below(self.whole.len());
            self.next.extend_from_slice(&self.whole[message]);
            for _ in 0..=self.below(4) {
                self.damage();
            }
        }
        self.next.truncate(MAX_DATAGRAM_BYTES);
        &self.next
    }

    fn damage(&mut self) {
        let kind = self.below(9);
        let at = self.below(self.next.len().max(1));
        let rest = self.next.len().saturating_sub(at);
        match kind {
            0 if rest > 0 => self.next[at] ^= 1 << self.below(8),
            1 if rest > 0 => self.next[at] = self.random.next_u64() as u8,
            2 if rest > 0 => self.next[at] = TELLING[self.below(TELLING.len())],
            3 => self.next.truncate(at),
            4 => {
                let count = self.below(20);
                for _ in 0..count {
                    let byte = TELLING[self.below(TELLING.len())];
                    self.next.insert(at, byte);
                }
            }
            5 => {
                let end = at + self.below(rest.min(40) + 1);
                self.next.drain(at..end);
            }
            6 => {
                // A part of another message, or of this one, in the middle.
                let other = self.below(self.whole.len());
                let part = self.below(self.whole[other].len());
                self.next.truncate(at);
                self.next.extend_from_slice(&self.whole[other][part..]);
            }
            7 if rest >= 8 => {
                let odd = [f64::NAN, f64::INFINITY, f64::MAX, -0.0, f64::MIN_POSITIVE];
                let value = odd[self.below(odd.len())];
                self.next[at..at + 8].copy_from_slice(&value.to_le_bytes());
            }
            8 => {
                // The longest varint, as a key, a length or a number.
                self.next.truncate(at);
                self.next.extend_from_slice(&[0xff; 9]);
                self.next.push(self.random.next_u64() as u8 & 1);
            }
            _ => {}
        }
    }

    fn below(&mut self, limit: usize) -> usize {
        (self.random.next_u64() % limit.max(1) as u64) as usize
    }
}

/// Messages without a mistake: RobotWare 7 as another implementation encodes it, RobotWare 6, a
/// sparse one, and two of ours.
fn whole_messages() -> Vec<Vec<u8>> {
    let text = include_str!("../data/rw7_egm_robot.hex").trim();
    let robotware_7: Vec<u8> = (0..text.len())
        .step_by(2)
        .map(|at| u8::from_str_radix(&text[at..at + 2], 16).expect("the file is hexadecimal"))
        .collect();
    let mut message = codec::decode_robot(&robotware_7).expect("the golden message is whole");
    message.measured_force = Some(EgmMeasuredForce {
        force_rw6: vec![1.0; 6],
        ..EgmMeasuredForce::default()
    });
    message.collision_info = None;
    message.rapid_from_robot = None;
    message.torque_ref = None;
    let mut robotware_6 = Vec::new();
    codec::encode_robot(&message, &mut robotware_6).expect("its values are numbers");
    message.planned = None;
    message.test_signals = None;
    message.measured_force = None;
    let mut sparse = Vec::new();
    codec::encode_robot(&message, &mut sparse).expect("its values are numbers");

    let correction = Correction {
        sequence: SequenceNumber(300),
        sent_at: ControllerTime(70_000),
        joints: JointAngles([1.0, -2.0, 3.0, -4.0, 5.0, -6.0]),
        velocities: JointVelocities([0.5; 6]),
    };
    let mut buffer = [0; MAX_CORRECTION_BYTES];
    let length = encode_correction(&correction, &mut buffer).expect("its values are numbers");
    let sensor = codec::decode_sensor(&buffer[..length]).expect("it is whole");
    let kind = sensor.header.and_then(|header| header.mtype);
    assert_eq!(kind, Some(MessageType::Correction as i32));
    vec![robotware_7, robotware_6, sparse, buffer[..length].to_vec()]
}
