//! Imitating one path with many candidates for alpha_z and N: what they share is
//! computed once, and a candidate's roll-out is compared with the path on the way.

use super::{
    Joints, MovementPrimitive, Phase, SPARE,
    forcing::{self, Learned},
    springs::{Constants, Springs},
};
use crate::{
    path::Path,
    vector::{self, Aligned, Kernel, LANES, multiply_add},
};

/// A path that is to be imitated.
pub struct Imitation {
    joints: usize,
    dt_s: f64,
    tau_s: f64,
    floor: f64,
    path: Vec<Joints>,
    velocities: Vec<Joints>,
    accelerations: Vec<Joints>,
}

impl Imitation {
    /// Prepares `path_deg` (rows `dt_s` apart, at least three, of at most seven
    /// joints), to be imitated over the time constant `tau_s`; `floor` is added to the
    /// denominator of each weight.
    ///
    /// # Panics
    /// With more than seven joints.
    pub fn of(path_deg: &Path, dt_s: f64, tau_s: f64, floor: f64) -> Imitation {
        let joints = path_deg.width();
        assert!(joints <= SPARE, "more than {SPARE} joints");
        let path: Vec<Joints> = path_deg
            .rows()
            .map(|row| {
                let mut lanes = [0.0; LANES];
                lanes[..joints].copy_from_slice(row);
                Aligned(lanes)
            })
            .collect();
        // Forward differences; the last rows are at rest.
        let difference = |values: &[Joints], valid: usize| -> Vec<Joints> {
            (0..values.len())
                .map(|i| {
                    if i < valid {
                        Aligned(std::array::from_fn(|lane| {
                            (values[i + 1].0[lane] - values[i].0[lane]) / dt_s
                        }))
                    } else {
                        Joints::default()
                    }
                })
                .collect()
        };
        let velocities = difference(&path, path.len() - 1);
        let accelerations = difference(&velocities, path.len() - 2);
        Imitation {
            joints,
            dt_s,
            tau_s,
            floor,
            path,
            velocities,
            accelerations,
        }
    }

    /// Prepares one alpha_z.
    pub fn with(&self, alpha_z: f64) -> Stiffness<'_> {
        let phase = Phase::new(alpha_z, self.tau_s, self.dt_s, self.path.len());
        let pushed = self.pushed(alpha_z, &phase);
        Stiffness {
            imitation: self,
            alpha_z,
            phase,
            pushed,
        }
    }

    /// Phase velocity times what the forcing term must be for the springs to follow
    /// the path exactly, tau² y'' - alpha_z (beta_z (g - y) - tau y').
    fn pushed(&self, alpha_z: f64, phase: &Phase) -> Vec<Joints> {
        let (beta_z, alpha_g) = (alpha_z / 4.0, alpha_z / 6.0);
        let goal = self.path[self.path.len() - 1].0;
        let mut filtered = self.path[0].0;
        phase
            .velocities()
            .iter()
            .enumerate()
            .map(|(i, v)| {
                let (y, speed) = (&self.path[i].0, &self.velocities[i].0);
                let acceleration = &self.accelerations[i].0;
                let mut pushed = [0.0; LANES];
                for lane in 0..LANES {
                    let spring =
                        alpha_z * (beta_z * (filtered[lane] - y[lane]) - self.tau_s * speed[lane]);
                    pushed[lane] = v * (self.tau_s * self.tau_s * acceleration[lane] - spring);
                    filtered[lane] += alpha_g * (goal[lane] - filtered[lane]) * self.dt_s;
                }
                pushed[SPARE] = v * v;
                Aligned(pushed)
            })
            .collect()
    }
}

/// A path to be imitated with one alpha_z.
pub struct Stiffness<'a> {
    imitation: &'a Imitation,
    alpha_z: f64,
    phase: Phase,
    pushed: Vec<Joints>,
}

impl Stiffness<'_> {
    /// The primitive with `n_basis` basis functions.
    pub fn primitive(&self, n_basis: usize) -> MovementPrimitive {
        let imitation = self.imitation;
        let learned = self.learn(n_basis);
        let ends = |row: &Joints| row.0[..imitation.joints].to_vec();
        MovementPrimitive {
            alpha_z: self.alpha_z,
            tau_s: imitation.tau_s,
            dt_s: imitation.dt_s,
            steps: imitation.path.len(),
            start_deg: ends(&imitation.path[0]),
            goal_deg: ends(&imitation.path[imitation.path.len() - 1]),
            weights: (0..imitation.joints)
                .map(|joint| learned.weights.iter().map(|w| w[joint]).collect())
                .collect(),
        }
    }

    /// The objective of the primitive with `n_basis` basis functions, degrees: that of
    /// [`crate::metrics::objective`] for its roll-out and the path.
    pub fn objective(&self, n_basis: usize) -> f64 {
        vector::dispatch(Compare {
            path: &self.imitation.path,
            forces: &self.learn(n_basis).forces,
            constants: Constants::new(self.alpha_z, self.imitation.tau_s, self.imitation.dt_s),
        })
    }

    fn learn(&self, n_basis: usize) -> Learned {
        forcing::learn(&self.phase, n_basis, &self.pushed, self.imitation.floor)
    }
}

/// Rolls out from the path's start to its end and compares.
struct Compare<'a> {
    path: &'a [Joints],
    forces: &'a [Joints],
    constants: Constants,
}

impl Kernel for Compare<'_> {
    type Output = f64;

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> f64 {
        let goal = &self.path[self.path.len() - 1].0;
        let mut springs = Springs::at_rest(self.path[0].0);
        let (mut sum, mut last) = (0.0, 0.0);
        for (shown, force) in self.path.iter().zip(self.forces) {
            springs.advance::<FUSED>(&self.constants, goal, force);
            let mut squares = [0.0; LANES];
            for lane in 0..SPARE {
                let off = springs.y[lane] - shown.0[lane];
                squares[lane] = multiply_add::<FUSED>(off, off, 0.0);
            }
            last = vector::reduce(squares, |a, b| a + b).sqrt();
            sum += last;
        }
        sum / (self.path.len() as f64).sqrt() + last
    }
}
