//! The numeric gate: nothing reaches the robot unless [`approve`] has looked at
//! the exact samples that will be streamed. Preview, API, command line and player
//! all rely on this one check.

use crate::keep_out::KeepOut;
use crate::limits::RobotLimits;
use crate::plan::{Plan, PlanSignal, Setpoint};
use crate::{JOINTS, JointAngles, JointVelocities, kinematics};

/// Longest motion that is accepted, samples (one hour at 4 ms).
pub const MAX_SAMPLES: usize = 900_000;

/// A motion that asks to be approved: equally spaced joint angles that begin and
/// end at rest.
#[derive(Clone, Debug)]
pub struct ProposedMotion {
    /// Time between two samples, seconds.
    pub period_s: f64,
    /// Number of samples at the beginning that only bring the arm to the start.
    pub approach_samples: usize,
    /// The samples.
    pub joints: Vec<JointAngles>,
    /// Signals that are set on the way, in the order of time.
    pub signals: Vec<PlanSignal>,
}

/// What the gate saw of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// Largest speed of each joint, deg/s.
    pub peak_joint_speed_deg_s: [f64; JOINTS],
    /// Largest speed of the tool, mm/s.
    pub peak_tcp_speed_mm_s: f64,
    /// Smallest absolute angle of joint 5 (0 is the singular pose of the wrist), degrees.
    pub min_wrist_angle_deg: f64,
    /// The worst breach of a rate limit, if there is one. Slowing the motion down
    /// by [`Breach::slow_down_by`] mends it.
    pub breach: Option<Breach>,
}

/// A quantity that exceeds its limit because the motion is too quick.
#[derive(Clone, Debug, PartialEq)]
pub struct Breach {
    /// What is too large.
    pub quantity: Quantity,
    /// When it happens, seconds from the first sample.
    pub t_s: f64,
    /// Its value there, in the unit of the quantity.
    pub value: f64,
    /// What is allowed.
    pub limit: f64,
    /// Factor by which time must be stretched so that the limit holds.
    pub slow_down_by: f64,
}

/// The rates that are limited. Joints count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Speed of a joint, deg/s.
    JointSpeed(usize),
    /// Acceleration of a joint, deg/s².
    JointAcceleration(usize),
    /// Jerk of a joint, deg/s³.
    JointJerk(usize),
    /// Speed of the tool, mm/s.
    TcpSpeed,
}

/// Why a motion may not run.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Refusal {
    /// Fewer than two or too many samples, or a period that is not a time.
    #[error("the motion has no usable samples")]
    Malformed,
    /// A signal without a name, at no time of the motion, or out of order.
    #[error("signal {name:?} cannot be set at {at_s} s of this motion")]
    SignalMisplaced {
        /// Its name.
        name: String,
        /// When it would be set, seconds from the first sample.
        at_s: f64,
    },
    /// A sample is NaN or infinite.
    #[error("joint {} is not a number at {t_s:.2} s", joint + 1)]
    NotFinite {
        /// Joint, from 0.
        joint: usize,
        /// Time from the first sample, seconds.
        t_s: f64,
    },
    /// A joint would leave its range.
    #[error(
        "joint {} would reach {value_deg:.1}° at {t_s:.2} s, its limit is {limit_deg:.1}°",
        joint + 1
    )]
    OutsideRange {
        /// Joint, from 0.
        joint: usize,
        /// Time from the first sample, seconds.
        t_s: f64,
        /// Angle there, degrees.
        value_deg: f64,
        /// The end of the range that is passed, degrees.
        limit_deg: f64,
    },
    /// The arm or its tool would enter a box that it must not enter.
    #[error("the arm would enter the keep-out box \"{name}\" at {t_s:.2} s")]
    KeepOut {
        /// What stands there.
        name: String,
        /// Time from the first sample, seconds.
        t_s: f64,
        /// Where the tool is then, millimetres in the base frame.
        tool_mm: [f64; 3],
    },
    /// The wrist would come nearer to its singular pose than this robot may.
    #[error(
        "joint 5 would come to {value_deg:.1}° at {t_s:.2} s, it has to stay {limit_deg:.1}° away from 0°"
    )]
    WristStretched {
        /// Time from the first sample, seconds.
        t_s: f64,
        /// Angle there, degrees.
        value_deg: f64,
        /// How far from 0 it has to stay, degrees.
        limit_deg: f64,
    },
    /// The motion is too quick somewhere.
    #[error("{}", describe(.0))]
    TooQuick(Breach),
}

impl Refusal {
    /// A stable name for programs.
    pub fn code(&self) -> &'static str {
        match self {
            Refusal::Malformed => "motion_malformed",
            Refusal::SignalMisplaced { .. } => "signal_misplaced",
            Refusal::NotFinite { .. } => "motion_not_finite",
            Refusal::OutsideRange { .. } => "outside_joint_range",
            Refusal::KeepOut { .. } => "keep_out",
            Refusal::WristStretched { .. } => "wrist_stretched",
            Refusal::TooQuick(_) => "motion_too_quick",
        }
    }

    /// The joint concerned, from 0.
    pub fn joint(&self) -> Option<usize> {
        match self {
            Refusal::NotFinite { joint, .. } | Refusal::OutsideRange { joint, .. } => Some(*joint),
            Refusal::TooQuick(breach) => breach.quantity.joint(),
            Refusal::WristStretched { .. } => Some(4),
            Refusal::Malformed | Refusal::SignalMisplaced { .. } | Refusal::KeepOut { .. } => None,
        }
    }
}

impl Quantity {
    /// The joint concerned, from 0; none for the tool.
    pub fn joint(&self) -> Option<usize> {
        match *self {
            Quantity::JointSpeed(j) | Quantity::JointAcceleration(j) | Quantity::JointJerk(j) => {
                Some(j)
            }
            Quantity::TcpSpeed => None,
        }
    }
}

fn describe(breach: &Breach) -> String {
    let Breach {
        quantity,
        t_s,
        value,
        limit,
        ..
    } = breach;
    match quantity {
        Quantity::JointSpeed(j) => format!(
            "joint {} would turn at {value:.0}°/s at {t_s:.2} s, {limit:.0}°/s are allowed",
            j + 1
        ),
        Quantity::JointAcceleration(j) => format!(
            "joint {} would accelerate with {value:.0}°/s² at {t_s:.2} s, {limit:.0}°/s² are allowed",
            j + 1
        ),
        Quantity::JointJerk(j) => format!(
            "joint {} would jerk with {value:.0}°/s³ at {t_s:.2} s, {limit:.0}°/s³ are allowed",
            j + 1
        ),
        Quantity::TcpSpeed => format!(
            "the tool would move at {value:.0} mm/s at {t_s:.2} s, {limit:.0} mm/s are allowed"
        ),
    }
}

/// Checks every sample against `limits` and makes the plan that may be streamed.
pub fn approve(motion: &ProposedMotion, limits: &RobotLimits) -> Result<Plan, Refusal> {
    let inspection = inspect(motion, limits)?;
    if let Some(breach) = inspection.breach {
        return Err(Refusal::TooQuick(breach));
    }
    let last = motion.joints.len() - 1;
    let samples = motion
        .joints
        .iter()
        .enumerate()
        .map(|(i, &joints)| Setpoint {
            joints,
            velocities: if i == 0 || i == last {
                JointVelocities::ZERO
            } else {
                central_difference(
                    &motion.joints[i - 1],
                    &motion.joints[i + 1],
                    motion.period_s,
                )
            },
        })
        .collect();
    Ok(Plan::new(
        motion.period_s,
        motion.approach_samples,
        samples,
        motion.signals.clone(),
    ))
}

/// Looks at a motion. Errors are what no slowing down can mend; a motion that is
/// only too quick comes back with its worst [`Breach`].
pub fn inspect(motion: &ProposedMotion, limits: &RobotLimits) -> Result<Inspection, Refusal> {
    let n = motion.joints.len();
    let dt = motion.period_s;
    if !(2..=MAX_SAMPLES).contains(&n) || motion.approach_samples >= n || !(dt > 0.0 && dt <= 0.1) {
        return Err(Refusal::Malformed);
    }
    check_positions(motion, limits)?;
    check_signals(motion)?;

    let mut worst = Worst::default();
    let mut peak_joint_speed_deg_s = [0.0; JOINTS];
    for j in 0..JOINTS {
        // The arm rests before the first and after the last sample.
        let at = |i: isize| motion.joints[i.clamp(0, n as isize - 1) as usize].0[j];
        for i in -2..=n as isize {
            let q = [at(i - 1), at(i), at(i + 1), at(i + 2)];
            let t_s = i.clamp(0, n as isize - 1) as f64 * dt;
            let speed = ((q[2] - q[1]) / dt).abs();
            let acceleration = ((q[2] - 2.0 * q[1] + q[0]) / (dt * dt)).abs();
            let jerk = ((q[3] - 3.0 * q[2] + 3.0 * q[1] - q[0]) / (dt * dt * dt)).abs();
            peak_joint_speed_deg_s[j] = f64::max(peak_joint_speed_deg_s[j], speed);
            worst.see(
                Quantity::JointSpeed(j),
                t_s,
                speed,
                limits.joint_speed_deg_s[j],
                1.0,
            );
            worst.see(
                Quantity::JointAcceleration(j),
                t_s,
                acceleration,
                limits.joint_acceleration_deg_s2[j],
                1.0 / 2.0,
            );
            worst.see(
                Quantity::JointJerk(j),
                t_s,
                jerk,
                limits.joint_jerk_deg_s3[j],
                1.0 / 3.0,
            );
        }
    }
    let mut peak_tcp_speed_mm_s = 0.0;
    let tool = |joints| kinematics::tool_point(joints, limits.tool_mm);
    let mut previous = tool(&motion.joints[0]);
    for (i, joints) in motion.joints.iter().enumerate().skip(1) {
        let position = tool(joints);
        let speed = position.distance(&previous) / dt;
        peak_tcp_speed_mm_s = f64::max(peak_tcp_speed_mm_s, speed);
        worst.see(
            Quantity::TcpSpeed,
            i as f64 * dt,
            speed,
            limits.tcp_speed_mm_s,
            1.0,
        );
        previous = position;
    }
    Ok(Inspection {
        peak_joint_speed_deg_s,
        peak_tcp_speed_mm_s,
        min_wrist_angle_deg: motion
            .joints
            .iter()
            .map(|q| q.0[4].abs())
            .fold(f64::INFINITY, f64::min),
        breach: worst.breach,
    })
}

fn check_positions(motion: &ProposedMotion, limits: &RobotLimits) -> Result<(), Refusal> {
    for (i, joints) in motion.joints.iter().enumerate() {
        let t_s = i as f64 * motion.period_s;
        if let Some(joint) = joints.0.iter().position(|q| !q.is_finite()) {
            return Err(Refusal::NotFinite { joint, t_s });
        }
        if let Some(joint) = limits.joint_out_of_range(joints) {
            let value_deg = joints.0[joint];
            let limit_deg = if value_deg > limits.joint_max_deg[joint] {
                limits.joint_max_deg[joint]
            } else {
                limits.joint_min_deg[joint]
            };
            return Err(Refusal::OutsideRange {
                joint,
                t_s,
                value_deg,
                limit_deg,
            });
        }
        let value_deg = joints.0[4];
        if value_deg.abs() < limits.refused_wrist_angle_deg {
            return Err(Refusal::WristStretched {
                t_s,
                value_deg,
                limit_deg: limits.refused_wrist_angle_deg,
            });
        }
        let entered = |keep_out: &&KeepOut| keep_out.is_entered(joints, limits.tool_mm);
        if let Some(keep_out) = limits.keep_out.iter().find(entered) {
            return Err(Refusal::KeepOut {
                name: keep_out.name.clone(),
                t_s,
                tool_mm: kinematics::tool_point(joints, limits.tool_mm).0,
            });
        }
    }
    Ok(())
}

fn check_signals(motion: &ProposedMotion) -> Result<(), Refusal> {
    let duration_s = (motion.joints.len() - 1) as f64 * motion.period_s;
    let mut earliest_s = 0.0;
    for signal in &motion.signals {
        if signal.name.is_empty() || !(earliest_s..=duration_s).contains(&signal.at_s) {
            return Err(Refusal::SignalMisplaced {
                name: signal.name.clone(),
                at_s: signal.at_s,
            });
        }
        earliest_s = signal.at_s;
    }
    Ok(())
}

fn central_difference(before: &JointAngles, after: &JointAngles, dt: f64) -> JointVelocities {
    let mut velocities = [0.0; JOINTS];
    for (v, (a, b)) in velocities.iter_mut().zip(after.0.iter().zip(&before.0)) {
        *v = (a - b) / (2.0 * dt);
    }
    JointVelocities(velocities)
}

#[derive(Default)]
struct Worst {
    breach: Option<Breach>,
}

impl Worst {
    /// Slowing down by s divides speed by s, acceleration by s², jerk by s³:
    /// `root` is the inverse of that power.
    fn see(&mut self, quantity: Quantity, t_s: f64, value: f64, limit: f64, root: f64) {
        let excess = value / limit;
        // A limit of zero with no motion gives NaN, which is no breach; samples that
        // are NaN were refused before.
        if excess.is_nan() || excess <= 1.0 {
            return;
        }
        let slow_down_by = excess.powf(root);
        if self
            .breach
            .as_ref()
            .is_none_or(|worst| slow_down_by > worst.slow_down_by)
        {
            self.breach = Some(Breach {
                quantity,
                t_s,
                value,
                limit,
                slow_down_by,
            });
        }
    }
}

#[cfg(test)]
mod tests;
