//! The message the controller sends each cycle, filled as RobotWare 7 fills it, or an older one.

use egm::messages::{
    EgmCartesian, EgmClock, EgmCollisionInfo, EgmEuler, EgmFeedBack, EgmHeader, EgmJoints,
    EgmMciState, EgmMeasuredForce, EgmMotorState, EgmPlanned, EgmPose, EgmQuaternion,
    EgmRapidCtrlExecState, EgmRapidData, EgmRobot, EgmTestSignals, MciState, MessageType,
    MotorState, RapidExecState,
};
use egm::{ControllerTime, SequenceNumber};
use motion::kinematics::{euler_xyz_deg, tool0};
use motion::{JOINTS, JointAngles, Orientation};

use crate::clock::WallTime;
use crate::config::MessageSet;

/// What goes into one message.
pub struct Content {
    /// Number within the session.
    pub sequence: SequenceNumber,
    /// Time since the controller started.
    pub sent_at: ControllerTime,
    /// Time of the measurement.
    pub at: WallTime,
    /// Where the arm is.
    pub measured: JointAngles,
    /// Where the controller wants it.
    pub planned: JointAngles,
    /// The motors are on.
    pub motors_on: bool,
    /// State of the motion correction.
    pub correction: MciState,
    /// All joints are within the convergence window.
    pub convergence_met: bool,
    /// State of the RAPID program.
    pub rapid: RapidExecState,
    /// Percent of the arm's performance the latest reference needs.
    pub load_percent: f64,
    /// How often the target has changed.
    pub targets: u32,
}

impl Content {
    /// The message with this content.
    #[must_use]
    pub fn into_message(self, set: MessageSet) -> EgmRobot {
        let mut message = self.into_robotware_7();
        if set == MessageSet::RobotWare7 {
            return message;
        }
        if let Some(force) = &mut message.measured_force {
            force.fc_active = None;
            force.force_rw6 = std::mem::take(&mut force.force);
        }
        message.move_index = None;
        message.collision_info = None;
        message.rapid_from_robot = None;
        message.torque_ref = None;
        if set == MessageSet::EarlyRobotWare6 {
            message.utilization_rate = None;
            if let Some(feed_back) = &mut message.feed_back {
                feed_back.time = None;
            }
            if let Some(planned) = &mut message.planned {
                planned.time = None;
            }
        }
        message
    }

    fn into_robotware_7(self) -> EgmRobot {
        let time = EgmClock {
            sec: self.at.seconds,
            usec: self.at.microseconds.into(),
        };
        let motors = if self.motors_on {
            MotorState::MotorsOn
        } else {
            MotorState::MotorsOff
        };
        EgmRobot {
            header: Some(EgmHeader {
                seqno: Some(self.sequence.0),
                tm: Some(self.sent_at.0),
                mtype: Some(MessageType::Data as i32),
            }),
            feed_back: Some(EgmFeedBack {
                joints: Some(joints(&self.measured)),
                cartesian: Some(pose(&self.measured)),
                external_joints: None,
                time: Some(time),
                // A controller needs an option of its own for this one.
                time_stamp: None,
            }),
            planned: Some(EgmPlanned {
                joints: Some(joints(&self.planned)),
                cartesian: Some(pose(&self.planned)),
                external_joints: None,
                time: Some(time),
                time_stamp: None,
            }),
            motor_state: Some(EgmMotorState {
                state: motors as i32,
            }),
            mci_state: Some(EgmMciState {
                state: self.correction as i32,
            }),
            mci_convergence_met: Some(self.convergence_met),
            test_signals: Some(EgmTestSignals {
                signals: vec![0.0; JOINTS],
            }),
            rapid_exec_state: Some(EgmRapidCtrlExecState {
                state: self.rapid as i32,
            }),
            measured_force: Some(EgmMeasuredForce {
                fc_active: Some(false),
                force_rw6: Vec::new(),
                force: vec![0.0; 6],
            }),
            utilization_rate: Some(self.load_percent),
            move_index: Some(self.targets),
            collision_info: Some(EgmCollisionInfo {
                collision_triggered: Some(false),
                coll_det_quota: vec![0.0; JOINTS],
            }),
            rapid_from_robot: Some(EgmRapidData {
                dig_val: Some(false),
                dnum: Vec::new(),
            }),
            torque_ref: Some(EgmJoints {
                joints: vec![0.0; JOINTS],
            }),
        }
    }
}

fn joints(angles: &JointAngles) -> EgmJoints {
    EgmJoints {
        joints: angles.0.to_vec(),
    }
}

fn pose(angles: &JointAngles) -> EgmPose {
    let pose = tool0(angles);
    let [x, y, z] = pose.position.0;
    let Orientation {
        w: u0,
        x: u1,
        y: u2,
        z: u3,
    } = pose.orientation;
    let [roll, pitch, yaw] = euler_xyz_deg(&pose.orientation);
    EgmPose {
        pos: Some(EgmCartesian { x, y, z }),
        orient: Some(EgmQuaternion { u0, u1, u2, u3 }),
        euler: Some(EgmEuler {
            x: roll,
            y: pitch,
            z: yaw,
        }),
    }
}
