//! The hand leads the arm to joint angles that somebody names again and again, as fast as a person
//! may move the soft arm. Whoever falls silent is followed no longer.

use motion::JointAngles;
use motion::drag::PATIENCE_S;
use motion::follower::Follower;
use motion::limits::RobotLimits;

/// How quickly the arm follows, 1/s: it smooths steps of 20 ms and lags behind by 50 ms.
const QUICKNESS: f64 = 40.0;

/// An arm that is being led.
#[derive(Clone, Debug)]
pub struct Lead {
    arm: Follower,
    to: Option<JointAngles>,
    age_s: f64,
}

impl Lead {
    /// Takes hold of an arm at rest.
    pub fn begin(from: JointAngles) -> Self {
        Self {
            arm: Follower::new(from, RobotLimits::gofa5(), QUICKNESS),
            to: None,
            age_s: 0.0,
        }
    }

    /// Names where to lead it from now on.
    pub fn aim(&mut self, to: JointAngles) {
        self.to = Some(to);
        self.age_s = 0.0;
    }

    /// Lets the arm come to rest.
    pub fn end(&mut self) {
        self.to = None;
    }

    /// Moves on and returns where the arm is then.
    pub fn step(&mut self, step_s: f64) -> JointAngles {
        self.age_s += step_s;
        if self.age_s > PATIENCE_S {
            self.to = None;
        }
        self.arm.advance(self.to.as_ref(), step_s)
    }

    /// Whether nobody leads any more and the arm stands still.
    pub fn is_over(&self) -> bool {
        self.to.is_none() && self.arm.is_at_rest()
    }
}
