//! The reader of the controller's message.

use motion::{JOINTS, JointAngles};

use super::fields::Fields;
use crate::error::Error;
use crate::header::{ControllerTime, SequenceNumber};
use crate::messages::{MciState, MessageType, MotorState, RapidExecState};

/// Wall time of the controller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClockTime {
    /// Whole seconds since 1970-01-01.
    pub seconds: u64,
    /// Microseconds.
    pub microseconds: u64,
}

/// What the control loop needs from one message of the controller.
///
/// Everything is optional on the wire. A state this program does not know reads as undefined.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RobotFeedback {
    /// `header.seqno`
    pub sequence: Option<SequenceNumber>,
    /// `header.tm`
    pub sent_at: Option<ControllerTime>,
    /// `header.mtype`; [`MessageType::Data`] comes from a robot.
    pub message_type: Option<MessageType>,
    /// `feedBack.joints` when there are exactly six: the measured angles, deg.
    pub feedback: Option<JointAngles>,
    /// `feedBack.time`
    pub feedback_time: Option<ClockTime>,
    /// `planned.joints` when there are exactly six: the controller's own reference, deg.
    pub planned: Option<JointAngles>,
    /// `motorState`
    pub motor_state: Option<MotorState>,
    /// `mciState`
    pub mci_state: Option<MciState>,
    /// `mciConvergenceMet`
    pub mci_convergence_met: Option<bool>,
    /// `rapidExecState`
    pub rapid_exec_state: Option<RapidExecState>,
    /// `utilizationRate`, percent; nothing when it is not a finite number.
    pub utilization_rate: Option<f64>,
    /// `moveIndex`
    pub move_index: Option<u32>,
    /// `CollisionInfo.collsionTriggered`
    pub collision_triggered: Option<bool>,
}

/// Reads one datagram of the controller. Never panics, whatever the bytes, and never allocates.
///
/// # Errors
/// [`Error::Truncated`] or [`Error::Malformed`] when the bytes are no such message,
/// [`Error::NotFinite`] when a joint angle is not a finite number.
pub fn read_feedback(datagram: &[u8]) -> Result<RobotFeedback, Error> {
    let mut robot = RobotFeedback::default();
    let mut measured = JointList::default();
    let mut planned = JointList::default();
    let mut fields = Fields::of(datagram);
    while let Some(field) = fields.next()? {
        match field.number {
            1 => read_header(field.message()?, &mut robot)?,
            2 => read_position(
                field.message()?,
                &mut measured,
                Some(&mut robot.feedback_time),
            )?,
            3 => read_position(field.message()?, &mut planned, None)?,
            4 => read_state(
                field.message()?,
                &mut robot.motor_state,
                MotorState::Undefined,
            )?,
            5 => read_state(field.message()?, &mut robot.mci_state, MciState::Undefined)?,
            6 => robot.mci_convergence_met = Some(field.varint()? != 0),
            8 => read_state(
                field.message()?,
                &mut robot.rapid_exec_state,
                RapidExecState::Undefined,
            )?,
            10 => robot.utilization_rate = Some(field.double()?).filter(|rate| rate.is_finite()),
            11 => robot.move_index = Some(field.uint32()?),
            12 => read_collision(field.message()?, &mut robot.collision_triggered)?,
            _ => {}
        }
    }
    robot.feedback = measured.finish("feedBack.joints")?;
    robot.planned = planned.finish("planned.joints")?;
    Ok(robot)
}

/// Six joint angles in the making; more or fewer are counted but make no angles.
#[derive(Default)]
struct JointList {
    degrees: [f64; JOINTS],
    count: usize,
}

impl JointList {
    fn push(&mut self, value: f64) {
        if let Some(place) = self.degrees.get_mut(self.count) {
            *place = value;
        }
        self.count += 1;
    }

    fn finish(self, field: &'static str) -> Result<Option<JointAngles>, Error> {
        if self.count != JOINTS {
            return Ok(None);
        }
        let joints = JointAngles(self.degrees);
        if joints.is_finite() {
            Ok(Some(joints))
        } else {
            Err(Error::NotFinite { field })
        }
    }
}

fn read_header(mut fields: Fields, robot: &mut RobotFeedback) -> Result<(), Error> {
    while let Some(field) = fields.next()? {
        match field.number {
            1 => robot.sequence = Some(SequenceNumber(field.uint32()?)),
            2 => robot.sent_at = Some(ControllerTime(field.uint32()?)),
            3 => {
                let kind = MessageType::try_from(field.enumeration()?);
                robot.message_type = Some(kind.unwrap_or(MessageType::Undefined));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Reads `EgmFeedBack` or `EgmPlanned`, which have the same layout.
fn read_position(
    mut fields: Fields,
    joints: &mut JointList,
    mut time: Option<&mut Option<ClockTime>>,
) -> Result<(), Error> {
    while let Some(field) = fields.next()? {
        match (field.number, &mut time) {
            (1, _) => {
                let mut list = field.message()?;
                while let Some(element) = list.next()? {
                    if element.number == 1 {
                        element.doubles(|value| joints.push(value))?;
                    }
                }
            }
            (4, Some(time)) => read_clock(field.message()?, time.get_or_insert_default())?,
            _ => {}
        }
    }
    Ok(())
}

fn read_clock(mut fields: Fields, time: &mut ClockTime) -> Result<(), Error> {
    while let Some(field) = fields.next()? {
        match field.number {
            1 => time.seconds = field.varint()?,
            2 => time.microseconds = field.varint()?,
            _ => {}
        }
    }
    Ok(())
}

/// Reads a message whose field 1 is a state; one without the field says `undefined`.
fn read_state<S: Copy + TryFrom<i32>>(
    mut fields: Fields,
    state: &mut Option<S>,
    undefined: S,
) -> Result<(), Error> {
    let state = state.get_or_insert(undefined);
    while let Some(field) = fields.next()? {
        if field.number == 1 {
            *state = S::try_from(field.enumeration()?).unwrap_or(undefined);
        }
    }
    Ok(())
}

fn read_collision(mut fields: Fields, triggered: &mut Option<bool>) -> Result<(), Error> {
    while let Some(field) = fields.next()? {
        if field.number == 1 {
            *triggered = Some(field.varint()? != 0);
        }
    }
    Ok(())
}
