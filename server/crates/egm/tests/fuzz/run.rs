//! Gives many datagrams to every reader and looks at what that costs.

use allocation_counter::measure;
use egm::{MAX_DATAGRAM_BYTES, RobotFeedback, codec, read_feedback};
use motion::JointAngles;

use super::datagrams::Datagrams;

/// What the readers made of the datagrams.
#[derive(Debug, Default)]
pub struct Figures {
    pub datagrams: u64,
    /// Read by the control loop's reader, by the general one, and by the virtual controller's.
    pub feedback: u64,
    pub robot: u64,
    pub sensor: u64,
    /// Allocations of the control loop's reader.
    pub reader_allocations: u64,
    /// Most bytes that the general readers held at a time, of one datagram.
    pub most_bytes: u64,
    /// Bytes that they have not given back.
    pub kept_bytes: i64,
}

/// # Panics
/// When a reader does, or lets a value through that is no number.
pub fn run(count: u64, seed: u64) -> Figures {
    let mut datagrams = Datagrams::new(seed);
    let mut figures = Figures::default();
    for _ in 0..count {
        let datagram = datagrams.next();
        assert!(datagram.len() <= MAX_DATAGRAM_BYTES);
        figures.datagrams += 1;
        let mut read = None;
        let cost = measure(|| read = read_feedback(datagram).ok());
        figures.reader_allocations += cost.count_total;
        if let Some(feedback) = read {
            figures.feedback += 1;
            assert_sound(&feedback);
        }
        let (mut robot, mut sensor) = (false, false);
        let cost = measure(|| {
            robot = codec::decode_robot(datagram).is_ok();
            sensor = codec::decode_sensor(datagram).is_ok();
        });
        figures.robot += u64::from(robot);
        figures.sensor += u64::from(sensor);
        figures.most_bytes = figures.most_bytes.max(cost.bytes_max);
        figures.kept_bytes += cost.bytes_current;
    }
    figures
}

fn assert_sound(feedback: &RobotFeedback) {
    for joints in [feedback.feedback, feedback.planned].into_iter().flatten() {
        assert!(JointAngles::is_finite(&joints), "{feedback:?}");
    }
    assert!(feedback.utilization_rate.is_none_or(f64::is_finite));
}
