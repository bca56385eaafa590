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

use serde::{Deserialize, Serialize};

use crate::{Error, path::Path};
use forcing::Forcing;

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
/// The path must have at least three rows.
pub fn imitate(
    path_deg: &Path,
    dt_s: f64,
    tau_s: f64,
    alpha_z: f64,
    n_basis: usize,
    floor: f64,
) -> MovementPrimitive {
    let (n, d) = (path_deg.len(), path_deg.width());
    let forcing = Forcing::new(alpha_z, n_basis, tau_s, dt_s, n);
    let mut weights = Vec::with_capacity(d);
    for j in 0..d {
        let target = forcing_target(&path_deg.column(j), dt_s, tau_s, alpha_z);
        weights.push(forcing.fit(&target, floor));
    }
    MovementPrimitive {
        alpha_z,
        tau_s,
        dt_s,
        steps: n,
        start_deg: path_deg.row(0).to_vec(),
        goal_deg: path_deg.last().to_vec(),
        weights,
    }
}

/// What the forcing term must be for the spring to follow one joint exactly:
/// tau² y'' - alpha_z (beta_z (g - y) - tau y').
fn forcing_target(y: &[f64], dt_s: f64, tau_s: f64, alpha_z: f64) -> Vec<f64> {
    let n = y.len();
    let (beta_z, alpha_g) = (alpha_z / 4.0, alpha_z / 6.0);
    let goal = y[n - 1];
    let mut filtered = y[0];
    // Forward differences; the last rows are at rest.
    let velocity = |i: usize| {
        if i + 1 < n {
            (y[i + 1] - y[i]) / dt_s
        } else {
            0.0
        }
    };
    let acceleration = |i: usize| {
        if i + 2 < n {
            (velocity(i + 1) - velocity(i)) / dt_s
        } else {
            0.0
        }
    };
    (0..n)
        .map(|i| {
            let spring = alpha_z * (beta_z * (filtered - y[i]) - tau_s * velocity(i));
            filtered += alpha_g * (goal - filtered) * dt_s;
            tau_s * tau_s * acceleration(i) - spring
        })
        .collect()
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
        let d = self.weights.len();
        for (which, values) in [("start", start_deg), ("goal", goal_deg)] {
            if values.len() != d {
                return Err(Error::BadTarget {
                    which,
                    reason: format!("{} angles for {d} joints", values.len()),
                });
            }
            if let Some(j) = values.iter().position(|q| !q.is_finite()) {
                return Err(Error::BadTarget {
                    which,
                    reason: format!("joint {} is not a number", j + 1),
                });
            }
        }
        let longest = match extent {
            Extent::AsTaught => self.steps,
            Extent::UntilSettled { longest_s, .. } => {
                self.steps.max((longest_s / self.dt_s).ceil() as usize)
            }
        };
        let forces = self.forces(longest);
        let mut state: Vec<Spring> = start_deg.iter().map(|&q| Spring::at_rest(q)).collect();
        let mut path = Path::with_capacity(d, self.steps);
        let mut row = vec![0.0; d];
        for step in 0..longest {
            for j in 0..d {
                let force = forces.get(step).map_or(0.0, |f| f[j]);
                state[j].advance(self, goal_deg[j], force);
                row[j] = state[j].y;
            }
            path.push(&row);
            if let Extent::UntilSettled { tolerance_deg, .. } = extent
                && step + 1 >= self.steps
                && state.iter().zip(goal_deg).all(|(s, goal)| {
                    (s.y - goal).abs() <= tolerance_deg && (s.z / self.tau_s).abs() <= tolerance_deg
                })
            {
                break;
            }
        }
        Ok(path)
    }

    /// Forcing term of each joint at each step. It depends on the phase alone and
    /// is shared by all starts and goals.
    fn forces(&self, steps: usize) -> Vec<Vec<f64>> {
        Forcing::new(self.alpha_z, self.n_basis(), self.tau_s, self.dt_s, steps)
            .evaluate(&self.weights)
    }
}

/// State of one joint's spring and of its filtered goal.
struct Spring {
    y: f64,
    z: f64,
    goal: f64,
}

impl Spring {
    fn at_rest(y: f64) -> Spring {
        Spring { y, z: 0.0, goal: y }
    }

    /// One Euler step; every derivative is taken from the old state.
    fn advance(&mut self, primitive: &MovementPrimitive, goal: f64, force: f64) {
        let alpha = primitive.alpha_z;
        let (tau, dt) = (primitive.tau_s, primitive.dt_s);
        let dz = (alpha * (alpha / 4.0 * (self.goal - self.y) - self.z) + force) / tau;
        let dy = self.z / tau;
        let dg = alpha / 6.0 * (goal - self.goal);
        self.z += dz * dt;
        self.y += dy * dt;
        self.goal += dg * dt;
    }
}

#[cfg(test)]
mod tests;
