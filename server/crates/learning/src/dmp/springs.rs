//! The springs of all joints, one in each lane, and their Euler steps.

use super::forcing::Joints;
use crate::vector::{LANES, multiply_add};

/// What the steps of one primitive have in common.
#[derive(Clone, Copy)]
pub struct Constants {
    /// dt alpha_z beta_z / tau, dt alpha_z / tau, dt / tau, dt alpha_g.
    spring: f64,
    damping: f64,
    pace: f64,
    goal: f64,
}

impl Constants {
    pub fn new(alpha_z: f64, tau_s: f64, dt_s: f64) -> Constants {
        let pace = dt_s / tau_s;
        Constants {
            spring: pace * alpha_z * alpha_z / 4.0,
            damping: pace * alpha_z,
            pace,
            goal: dt_s * alpha_z / 6.0,
        }
    }
}

/// State of the springs and of their filtered goals.
#[derive(Clone, Copy)]
pub struct Springs {
    pub y: [f64; LANES],
    pub z: [f64; LANES],
    goal: [f64; LANES],
}

impl Springs {
    pub fn at_rest(y: [f64; LANES]) -> Springs {
        Springs {
            y,
            z: [0.0; LANES],
            goal: y,
        }
    }

    /// One Euler step; every derivative is taken from the old state.
    #[inline(always)]
    pub fn advance<const FUSED: bool>(
        &mut self,
        constants: &Constants,
        goal: &[f64; LANES],
        force: &Joints,
    ) {
        for lane in 0..LANES {
            let stretched = self.goal[lane] - self.y[lane];
            let pushed = multiply_add::<FUSED>(constants.pace, force.0[lane], self.z[lane]);
            let damped = multiply_add::<FUSED>(-constants.damping, self.z[lane], pushed);
            self.y[lane] = multiply_add::<FUSED>(constants.pace, self.z[lane], self.y[lane]);
            self.z[lane] = multiply_add::<FUSED>(constants.spring, stretched, damped);
            let open = goal[lane] - self.goal[lane];
            self.goal[lane] = multiply_add::<FUSED>(constants.goal, open, self.goal[lane]);
        }
    }
}
