//! What the arm is allowed to do: ranges and rates per joint, speed at the tool.
//! The numbers only; the check itself is in [`crate::gate`].

use serde::{Deserialize, Serialize};

use crate::{JOINTS, JointAngles, keep_out::KeepOut};

/// Limits of one robot. Per-joint arrays are joints 1 to 6.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RobotLimits {
    /// Lower end of each joint's range, degrees.
    pub joint_min_deg: [f64; JOINTS],
    /// Upper end of each joint's range, degrees.
    pub joint_max_deg: [f64; JOINTS],
    /// Largest speed of each joint, deg/s.
    pub joint_speed_deg_s: [f64; JOINTS],
    /// Largest acceleration of each joint, deg/s².
    pub joint_acceleration_deg_s2: [f64; JOINTS],
    /// Largest jerk of each joint, deg/s³.
    pub joint_jerk_deg_s3: [f64; JOINTS],
    /// Largest speed of the tool's centre point, mm/s.
    pub tcp_speed_mm_s: f64,
    /// Where the tool's centre point is in the frame of tool0, millimetres.
    pub tool_mm: [f64; 3],
    /// Boxes that must not be entered.
    pub keep_out: Vec<KeepOut>,
    /// A motion that comes nearer to the wrist's singular pose (joint 5 at 0°) is refused,
    /// degrees; 0 refuses none, because joint angles lead through that pose without harm.
    pub refused_wrist_angle_deg: f64,
    /// Below this angle of joint 5 the wrist is near its singular pose and a
    /// motion is reported with a warning, degrees.
    pub min_wrist_angle_deg: f64,
}

impl RobotLimits {
    /// A GoFa CRB 15000-5/0.95.
    ///
    /// Ranges and speeds are the arm's own. ABB publishes no acceleration or jerk
    /// limits: ours are chosen above what people reach when they guide the arm by
    /// hand (99th percentile 35 to 172 deg/s²). 250 mm/s at the tool is the
    /// speed that the controller itself allows in manual mode.
    pub fn gofa5() -> Self {
        RobotLimits {
            joint_min_deg: [-180.0, -180.0, -225.0, -180.0, -180.0, -270.0],
            joint_max_deg: [180.0, 180.0, 85.0, 180.0, 180.0, 270.0],
            joint_speed_deg_s: [125.0, 125.0, 140.0, 200.0, 200.0, 200.0],
            joint_acceleration_deg_s2: [150.0, 150.0, 200.0, 300.0, 300.0, 500.0],
            joint_jerk_deg_s3: [3000.0, 3000.0, 4000.0, 8000.0, 8000.0, 12000.0],
            tcp_speed_mm_s: 250.0,
            tool_mm: [0.0; 3],
            keep_out: Vec::new(),
            refused_wrist_angle_deg: 0.0,
            min_wrist_angle_deg: 1.0,
        }
    }

    /// First joint (from 0) outside its range, if any.
    pub fn joint_out_of_range(&self, joints: &JointAngles) -> Option<usize> {
        (0..JOINTS).find(|&j| {
            let angle = joints.0[j];
            !(angle >= self.joint_min_deg[j] && angle <= self.joint_max_deg[j])
        })
    }
}
