//! One smooth movement from where the arm is to a given place.

use motion::kinematics::tool0;
use motion::{JOINTS, JointAngles};

use motion::minimum_jerk;

/// Speed of the tool that the hand likes, and the one it never exceeds, mm/s.
const GENTLE_MM_S: f64 = 180.0;
const FASTEST_MM_S: f64 = 240.0;
/// Shortest time, and the time that is exceeded only to stay below the fastest speed, s.
const SHORTEST_S: f64 = 1.0;
const LONGEST_S: f64 = 4.0;
/// Fastest joint, deg/s.
const JOINT_DEG_S: f64 = 60.0;
/// Pieces in which the path is measured.
const PIECES: usize = 100;

/// A movement with the minimum-jerk profile, straight in joint angles.
#[derive(Clone, Debug)]
pub struct Reach {
    from: JointAngles,
    to: JointAngles,
    duration_s: f64,
}

impl Reach {
    /// A gentle movement from `from` to `to`.
    pub fn new(from: JointAngles, to: JointAngles) -> Self {
        let mut reach = Self {
            from,
            to,
            duration_s: 1.0,
        };
        let tool_mm_s = reach.peak_tool_speed();
        let joint_deg_s = minimum_jerk::PEAK * from.max_abs_difference(&to);
        reach.duration_s = (tool_mm_s / GENTLE_MM_S)
            .clamp(SHORTEST_S, LONGEST_S)
            .max(tool_mm_s / FASTEST_MM_S)
            .max(joint_deg_s / JOINT_DEG_S);
        reach
    }

    /// How long it takes, s.
    pub fn duration_s(&self) -> f64 {
        self.duration_s
    }

    /// Where the arm is after `t_s`; held at both ends.
    pub fn at(&self, t_s: f64) -> JointAngles {
        let part = minimum_jerk::share(t_s / self.duration_s);
        JointAngles(std::array::from_fn::<_, JOINTS, _>(|joint| {
            self.from.0[joint] + part * (self.to.0[joint] - self.from.0[joint])
        }))
    }

    fn peak_tool_speed(&self) -> f64 {
        let step_s = self.duration_s / PIECES as f64;
        let place = |piece: usize| tool0(&self.at(piece as f64 * step_s)).position;
        (0..PIECES)
            .map(|piece| place(piece).distance(&place(piece + 1)) / step_s)
            .fold(0.0, f64::max)
    }
}
