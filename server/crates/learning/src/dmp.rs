//! Dynamic movement primitive: a damped spring per joint (the "attractor
//! landscape"), pushed along the learned motion by a forcing term.
//!
//! With one alpha_z for all joints, beta_z = alpha_z / 4, alpha_g = alpha_z / 6:
//!
//! ```text
//! tau v' = alpha_z (-beta_z x - v)      tau x' = v        phase, x(0) = 1, v(0) = 0
//!     g' = alpha_g (G - g)                                filtered goal, g(0) = y(0)
//! tau z' = alpha_z (beta_z (g - y) - z) + f(x, v)         transformation
//! tau y' = z
//! f = v sum_i w_i psi_i(x) / sum_i (psi_i(x) + 1e-10)     forcing term
//! ```
//!
//! (equations of the paper's section "Damped spring model", with what its text
//! leaves out.) The forcing term carries no factor (G - y0): a motion is moved to
//! a new start and goal, not scaled, so that joints that end where they began keep
//! their shape. All derivatives are integrated with explicit Euler steps of `dt_s`.

mod forcing;
mod imitation;
mod springs;

use serde::{Deserialize, Serialize};

use crate::{
    Error,
    path::Path,
    vector::{self, Kernel, LANES},
};
use forcing::{Joints, Phase, SPARE};
pub use imitation::{Imitation, Stiffness};
use springs::{Constants, Springs};

/// Speeds below this share of the largest one count as standing still.
const STILL_SHARE: f64 = 0.05;

/// A learned primitive. It is plain data: times in seconds, angles in degrees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MovementPrimitive {
    /// Stiffness of the spring.
    pub alpha_z: f64,
    /// Time constant of the motion, seconds.
    pub tau_s: f64,
    /// Integration step, seconds.
    pub dt_s: f64,
    /// Number of steps of the motion it was learned from.
    pub steps: usize,
    /// Taught start, degrees.
    pub start_deg: Vec<f64>,
    /// Taught goal, degrees.
    pub goal_deg: Vec<f64>,
    /// Weights of the forcing term: for each joint one for each basis function.
    pub weights: Vec<Vec<f64>>,
}

/// How far a rollout goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// As many steps as the motion it was learned from.
    AsTaught,
    /// On until every joint is within `tolerance_deg` of the goal and slower than
    /// `tolerance_deg` per second, or `longest_s` is reached.
    UntilSettled {
        /// Tolerance at the goal, degrees.
        tolerance_deg: f64,
        /// Bound on the duration, seconds.
        longest_s: f64,
    },
}

/// The primitive's time constant: when the last joint slows below 5 % of the
/// largest speed of all joints (its magnitude, so that the direction of travel
/// does not matter).
pub fn time_constant_s(path_deg: &Path, dt_s: f64) -> f64 {
    let n = path_deg.len();
    let speed = |i: usize| {
        path_deg
            .row(i)
            .iter()
            .zip(path_deg.row(i + 1))
            .map(|(a, b)| ((b - a) / dt_s).abs())
            .fold(0.0, f64::max)
    };
    let largest = (0..n - 1).map(speed).fold(0.0, f64::max);
    let last = (0..n - 1)
        .rev()
        .find(|&i| speed(i) > STILL_SHARE * largest)
        .unwrap_or(n - 1);
    (last as f64 * dt_s).max(dt_s)
}

/// The published floor of the denominator in the fit of a weight.
pub const PUBLISHED_FLOOR: f64 = 1e-10;
/// A floor that only keeps from dividing by zero. The phase velocity falls like
/// exp(-alpha_z / 2); beyond alpha_z of about 36 the published floor stifles the
/// end of a motion.
pub const SMALLEST_FLOOR: f64 = 1e-100;

/// Learns a primitive that imitates `path_deg` (rows `dt_s` apart) with `n_basis`
/// basis functions, by locally weighted regression for each of them; `floor` is
/// added to the denominator of each weight.
///
/// The path must have at least three rows, of at most seven joints.
pub fn imitate(
    path_deg: &Path,
    dt_s: f64,
    tau_s: f64,
    alpha_z: f64,
    n_basis: usize,
    floor: f64,
) -> MovementPrimitive {
    Imitation::of(path_deg, dt_s, tau_s, floor)
        .with(alpha_z)
        .primitive(n_basis)
}

impl MovementPrimitive {
    /// Number of basis functions.
    pub fn n_basis(&self) -> usize {
        self.weights.first().map_or(0, Vec::len)
    }

    /// Duration of the taught motion, seconds.
    pub fn duration_s(&self) -> f64 {
        self.steps.saturating_sub(1) as f64 * self.dt_s
    }

    /// The motion from `start_deg` to `goal_deg`, rows `dt_s` apart.
    ///
    /// Row i is the state after i + 1 Euler steps; since the spring starts at
    /// rest, row 0 is the start itself.
    pub fn rollout(
        &self,
        start_deg: &[f64],
        goal_deg: &[f64],
        extent: Extent,
    ) -> Result<Path, Error> {
        self.landscape().rollout(start_deg, goal_deg, extent)
    }

    /// The primitive with its forcing term evaluated, for many rollouts.
    pub fn landscape(&self) -> Landscape<'_> {
        let phase = Phase::new(self.alpha_z, self.tau_s, self.dt_s, self.steps);
        let weights = (0..self.n_basis())
            .map(|i| {
                let mut joints = [0.0; LANES];
                for (joint, weights) in joints.iter_mut().zip(&self.weights) {
                    *joint = weights[i];
                }
                joints
            })
            .collect();
        Landscape {
            primitive: self,
            forces: forcing::forces(&phase, weights),
        }
    }
}

/// A primitive whose forcing term, which depends on the phase alone and is shared by
/// all starts and goals, is known at each step.
pub struct Landscape<'a> {
    primitive: &'a MovementPrimitive,
    forces: Vec<Joints>,
}

impl Landscape<'_> {
    /// As [`MovementPrimitive::rollout`].
    pub fn rollout(
        &self,
        start_deg: &[f64],
        goal_deg: &[f64],
        extent: Extent,
    ) -> Result<Path, Error> {
        let joints = self.primitive.weights.len();
        let start = in_lanes("start", start_deg, joints)?;
        let goal = in_lanes("goal", goal_deg, joints)?;
        Ok(vector::dispatch(Rollout {
            landscape: self,
            start,
            goal,
            joints,
            extent,
        }))
    }
}

fn in_lanes(which: &'static str, values: &[f64], joints: usize) -> Result<[f64; LANES], Error> {
    if values.len() != joints {
        return Err(Error::BadTarget {
            which,
            reason: format!("{} angles for {joints} joints", values.len()),
        });
    }
    if let Some(j) = values.iter().position(|q| !q.is_finite()) {
        return Err(Error::BadTarget {
            which,
            reason: format!("joint {} is not a number", j + 1),
        });
    }
    let mut lanes = [0.0; LANES];
    lanes[..joints].copy_from_slice(values);
    Ok(lanes)
}

struct Rollout<'a> {
    landscape: &'a Landscape<'a>,
    start: [f64; LANES],
    goal: [f64; LANES],
    joints: usize,
    extent: Extent,
}

impl Kernel for Rollout<'_> {
    type Output = Path;

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> Path {
        let primitive = self.landscape.primitive;
        let constants = Constants::new(primitive.alpha_z, primitive.tau_s, primitive.dt_s);
        let (longest, tolerance_deg) = match self.extent {
            Extent::AsTaught => (primitive.steps, 0.0),
            Extent::UntilSettled {
                tolerance_deg,
                longest_s,
            } => {
                let longest = (longest_s / primitive.dt_s).ceil() as usize;
                (longest.max(primitive.steps), tolerance_deg)
            }
        };
        let mut springs = Springs::at_rest(self.start);
        let mut path = Path::with_capacity(self.joints, primitive.steps);
        // Beyond the taught time nothing pushes.
        let none = Joints::default();
        for step in 0..longest {
            let force = self.landscape.forces.get(step).unwrap_or(&none);
            springs.advance::<FUSED>(&constants, &self.goal, force);
            path.push(&springs.y[..self.joints]);
            let settled = |j: usize| {
                (springs.y[j] - self.goal[j]).abs() <= tolerance_deg
                    && (springs.z[j] / primitive.tau_s).abs() <= tolerance_deg
            };
            if step + 1 >= primitive.steps && (0..self.joints).all(settled) {
                break;
            }
        }
        path
    }
}

#[cfg(test)]
mod tests;
