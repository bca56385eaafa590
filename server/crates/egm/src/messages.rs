//! The protobuf messages of EGM (proto2, package `abb.egm`), RobotWare 6.07 to 7.
//!
//! Names are ABB's. Repeated numbers are written unpacked, one key per element, as the protocol
//! asks; the packed form is read too. Unknown fields are ignored. Newer fields are `Option`s or
//! lists, so that a message of an older RobotWare is a message with these left out.

use prost::{Enumeration, Message};

mod force;
pub use force::EgmMeasuredForce;

/// Kind of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Enumeration)]
#[repr(i32)]
pub enum MessageType {
    /// Not said.
    Undefined = 0,
    /// Reserved by ABB.
    Command = 1,
    /// From the robot: feedback.
    Data = 2,
    /// To the robot: position guidance.
    Correction = 3,
    /// To the robot: path correction.
    PathCorrection = 4,
}

/// State of the motors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Enumeration)]
#[repr(i32)]
pub enum MotorState {
    /// Not known.
    Undefined = 0,
    /// The motors are on.
    MotorsOn = 1,
    /// The motors are off.
    MotorsOff = 2,
}

/// State of the motion correction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Enumeration)]
#[repr(i32)]
pub enum MciState {
    /// No EGM identity is set up.
    Undefined = 0,
    /// EGM ended with an error.
    Error = 1,
    /// EGM does not move the robot.
    Stopped = 2,
    /// EGM moves the robot.
    Running = 3,
}

/// State of the RAPID program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Enumeration)]
#[repr(i32)]
pub enum RapidExecState {
    /// Not known; also right after a controller restart, although RAPID runs.
    Undefined = 0,
    /// The program is stopped.
    Stopped = 1,
    /// The program runs.
    Running = 2,
}

/// Counter, time stamp and kind of a message.
#[derive(Clone, Copy, PartialEq, Message)]
pub struct EgmHeader {
    /// Message counter of the sender.
    #[prost(uint32, optional, tag = "1")]
    pub seqno: Option<u32>,
    /// Time stamp of the sender, ms.
    #[prost(uint32, optional, tag = "2")]
    pub tm: Option<u32>,
    /// Kind of the message.
    #[prost(enumeration = "MessageType", optional, tag = "3")]
    pub mtype: Option<i32>,
}

/// A position, mm.
#[derive(Clone, Copy, PartialEq, Message)]
pub struct EgmCartesian {
    /// mm
    #[prost(double, required, tag = "1")]
    pub x: f64,
    /// mm
    #[prost(double, required, tag = "2")]
    pub y: f64,
    /// mm
    #[prost(double, required, tag = "3")]
    pub z: f64,
}

/// An orientation as a unit quaternion; `u0` is the real part.
#[derive(Clone, Copy, PartialEq, Message)]
pub struct EgmQuaternion {
    /// w
    #[prost(double, required, tag = "1")]
    pub u0: f64,
    /// x
    #[prost(double, required, tag = "2")]
    pub u1: f64,
    /// y
    #[prost(double, required, tag = "3")]
    pub u2: f64,
    /// z
    #[prost(double, required, tag = "4")]
    pub u3: f64,
}

/// An orientation as Euler angles, deg.
#[derive(Clone, Copy, PartialEq, Message)]
pub struct EgmEuler {
    /// deg
    #[prost(double, required, tag = "1")]
    pub x: f64,
    /// deg
    #[prost(double, required, tag = "2")]
    pub y: f64,
    /// deg
    #[prost(double, required, tag = "3")]
    pub z: f64,
}

/// Wall time since 1970-01-01.
#[derive(Clone, Copy, PartialEq, Message)]
pub struct EgmClock {
    /// Whole seconds.
    #[prost(uint64, required, tag = "1")]
    pub sec: u64,
    /// Microseconds.
    #[prost(uint64, required, tag = "2")]
    pub usec: u64,
}

/// IEEE 1588 time (RobotWare 7).
#[derive(Clone, Copy, PartialEq, Message)]
pub struct EgmTimestamp {
    /// Whole seconds.
    #[prost(uint64, optional, tag = "1")]
    pub sec: Option<u64>,
    /// Nanoseconds.
    #[prost(uint64, optional, tag = "2")]
    pub nsec: Option<u64>,
}

/// Position and orientation of the tool.
#[derive(Clone, Copy, PartialEq, Message)]
pub struct EgmPose {
    /// mm
    #[prost(message, optional, tag = "1")]
    pub pos: Option<EgmCartesian>,
    /// Unit quaternion.
    #[prost(message, optional, tag = "2")]
    pub orient: Option<EgmQuaternion>,
    /// deg
    #[prost(message, optional, tag = "3")]
    pub euler: Option<EgmEuler>,
}

/// Tool speed: three values in mm/s, three in deg/s.
#[derive(Clone, PartialEq, Message)]
pub struct EgmCartesianSpeed {
    /// Six values.
    #[prost(double, repeated, packed = "false", tag = "1")]
    pub value: Vec<f64>,
}

/// Joint values: deg, or deg/s inside [`EgmSpeedRef`].
#[derive(Clone, PartialEq, Message)]
pub struct EgmJoints {
    /// Six values for a TCP robot.
    #[prost(double, repeated, packed = "false", tag = "1")]
    pub joints: Vec<f64>,
}

/// Where the controller wants the robot (from the robot), or where we want it (to the robot).
#[derive(Clone, PartialEq, Message)]
pub struct EgmPlanned {
    /// deg
    #[prost(message, optional, tag = "1")]
    pub joints: Option<EgmJoints>,
    /// Tool pose.
    #[prost(message, optional, tag = "2")]
    pub cartesian: Option<EgmPose>,
    /// External axes, deg or mm.
    #[prost(message, optional, tag = "3")]
    pub external_joints: Option<EgmJoints>,
    /// When the robot is to be there (RobotWare 6.07 and later).
    #[prost(message, optional, tag = "4")]
    pub time: Option<EgmClock>,
    /// The same as IEEE 1588 time (RobotWare 7).
    #[prost(message, optional, tag = "5")]
    pub time_stamp: Option<EgmTimestamp>,
}

/// Where the robot was measured to be.
#[derive(Clone, PartialEq, Message)]
pub struct EgmFeedBack {
    /// deg
    #[prost(message, optional, tag = "1")]
    pub joints: Option<EgmJoints>,
    /// Tool pose.
    #[prost(message, optional, tag = "2")]
    pub cartesian: Option<EgmPose>,
    /// External axes, deg or mm.
    #[prost(message, optional, tag = "3")]
    pub external_joints: Option<EgmJoints>,
    /// When it was measured (RobotWare 6.07 and later).
    #[prost(message, optional, tag = "4")]
    pub time: Option<EgmClock>,
    /// The same as IEEE 1588 time (RobotWare 7).
    #[prost(message, optional, tag = "5")]
    pub time_stamp: Option<EgmTimestamp>,
}

/// Speed reference.
#[derive(Clone, PartialEq, Message)]
pub struct EgmSpeedRef {
    /// deg/s
    #[prost(message, optional, tag = "1")]
    pub joints: Option<EgmJoints>,
    /// Tool speed.
    #[prost(message, optional, tag = "2")]
    pub cartesians: Option<EgmCartesianSpeed>,
    /// External axes, deg/s or mm/s.
    #[prost(message, optional, tag = "3")]
    pub external_joints: Option<EgmJoints>,
}

/// Motor state as a message.
#[derive(Clone, Copy, PartialEq, Message)]
pub struct EgmMotorState {
    /// The state.
    #[prost(enumeration = "MotorState", required, tag = "1")]
    pub state: i32,
}

/// State of the motion correction as a message.
#[derive(Clone, Copy, PartialEq, Message)]
pub struct EgmMciState {
    /// The state.
    #[prost(enumeration = "MciState", required, tag = "1")]
    pub state: i32,
}

/// State of RAPID as a message.
#[derive(Clone, Copy, PartialEq, Message)]
pub struct EgmRapidCtrlExecState {
    /// The state.
    #[prost(enumeration = "RapidExecState", required, tag = "1")]
    pub state: i32,
}

/// Signals for ABB's internal use.
#[derive(Clone, PartialEq, Message)]
pub struct EgmTestSignals {
    /// Values without a published meaning.
    #[prost(double, repeated, packed = "false", tag = "1")]
    pub signals: Vec<f64>,
}

/// Collision detection (RobotWare 7).
#[derive(Clone, PartialEq, Message)]
pub struct EgmCollisionInfo {
    /// A collision was detected.
    #[prost(bool, optional, tag = "1")]
    pub collision_triggered: Option<bool>,
    /// How much of the detection level each axis uses.
    #[prost(double, repeated, packed = "false", tag = "2")]
    pub coll_det_quota: Vec<f64>,
}

/// One digital signal and up to 40 numbers shared with RAPID (RobotWare 7).
#[derive(Clone, PartialEq, Message)]
pub struct EgmRapidData {
    /// The digital signal.
    #[prost(bool, optional, tag = "1")]
    pub dig_val: Option<bool>,
    /// The numbers.
    #[prost(double, repeated, packed = "false", tag = "2")]
    pub dnum: Vec<f64>,
}

/// The controller's message to us.
#[derive(Clone, PartialEq, Message)]
pub struct EgmRobot {
    /// Counter, time and kind.
    #[prost(message, optional, tag = "1")]
    pub header: Option<EgmHeader>,
    /// Measured.
    #[prost(message, optional, tag = "2")]
    pub feed_back: Option<EgmFeedBack>,
    /// Planned by the controller.
    #[prost(message, optional, tag = "3")]
    pub planned: Option<EgmPlanned>,
    /// Motors.
    #[prost(message, optional, tag = "4")]
    pub motor_state: Option<EgmMotorState>,
    /// Motion correction.
    #[prost(message, optional, tag = "5")]
    pub mci_state: Option<EgmMciState>,
    /// The convergence window of the running EGM instruction is fulfilled.
    #[prost(bool, optional, tag = "6")]
    pub mci_convergence_met: Option<bool>,
    /// ABB's internal use.
    #[prost(message, optional, tag = "7")]
    pub test_signals: Option<EgmTestSignals>,
    /// RAPID.
    #[prost(message, optional, tag = "8")]
    pub rapid_exec_state: Option<EgmRapidCtrlExecState>,
    /// Forces; the layout differs between RobotWare 6 and 7.
    #[prost(message, optional, tag = "9")]
    pub measured_force: Option<EgmMeasuredForce>,
    /// Percent of the robot's performance the latest reference needs (RobotWare 6.10 and later).
    #[prost(double, optional, tag = "10")]
    pub utilization_rate: Option<f64>,
    /// Steps when a movement starts and when its target changes (RobotWare 7).
    #[prost(uint32, optional, tag = "11")]
    pub move_index: Option<u32>,
    /// Collision detection (RobotWare 7).
    #[prost(message, optional, tag = "12")]
    pub collision_info: Option<EgmCollisionInfo>,
    /// Data from RAPID (RobotWare 7).
    #[prost(message, optional, tag = "13")]
    pub rapid_from_robot: Option<EgmRapidData>,
    /// Torque reference, only with the raw motion level (RobotWare 7).
    #[prost(message, optional, tag = "14")]
    pub torque_ref: Option<EgmJoints>,
}

/// Our message to the controller (position guidance).
#[derive(Clone, PartialEq, Message)]
pub struct EgmSensor {
    /// Counter, time and kind.
    #[prost(message, optional, tag = "1")]
    pub header: Option<EgmHeader>,
    /// Position reference.
    #[prost(message, optional, tag = "2")]
    pub planned: Option<EgmPlanned>,
    /// Speed reference.
    #[prost(message, optional, tag = "3")]
    pub speed_ref: Option<EgmSpeedRef>,
    /// Data to RAPID (RobotWare 7).
    #[prost(message, optional, tag = "4")]
    pub rapid_to_robot: Option<EgmRapidData>,
}
