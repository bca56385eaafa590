//! The forcing term: basis functions of the phase and their weights.
//!
//! All joints share phase and basis functions, and are worked on together, one in
//! each lane of a vector. A basis function is evaluated only where it is not zero.

use crate::{
    exp::exp_lanes,
    vector::{self, Aligned, Kernel, LANES, lanes, multiply_add},
};

/// Added to each basis function in the normalisation, which so never divides by
/// zero far from every centre.
const EPSILON: f64 = 1e-10;
/// Basis functions below exp of this are taken as zero (8.8e-27).
const FAR: f64 = -60.0;
/// Width of a basis function in units of the distance to the next centre.
const WIDTH: f64 = 0.55;
/// Lane that no joint needs: what belongs to the basis functions alone is summed here.
pub const SPARE: usize = LANES - 1;
/// Sums that run beside each other, so that additions do not wait.
const BESIDE: usize = 4;

/// One value for each joint (lane) at one step.
pub type Joints = Aligned<[f64; LANES]>;

/// The phase x and its scaled velocity v before each Euler step, for one (alpha_z,
/// tau).
pub struct Phase {
    alpha_z: f64,
    steps: usize,
    /// With room for a whole vector behind the last one.
    x: Vec<f64>,
    v: Vec<f64>,
}

impl Phase {
    pub fn new(alpha_z: f64, tau_s: f64, dt_s: f64, steps: usize) -> Phase {
        let (mut x, mut v) = (1.0, 0.0);
        let mut phase = Phase {
            alpha_z,
            steps,
            x: Vec::with_capacity(steps + LANES),
            v: Vec::with_capacity(steps),
        };
        for _ in 0..steps {
            phase.x.push(x);
            phase.v.push(v);
            let dv = alpha_z * (-alpha_z / 4.0 * x - v) / tau_s;
            let dx = v / tau_s;
            v += dv * dt_s;
            x += dx * dt_s;
        }
        phase.x.extend([x; LANES]);
        phase
    }

    /// Phase velocity at each step.
    pub fn velocities(&self) -> &[f64] {
        &self.v
    }

    /// Phase of the exact solution at `n_basis` equally spaced times from 0 to tau.
    fn centres(&self, n_basis: usize) -> Vec<f64> {
        let a = self.alpha_z / 2.0;
        (0..n_basis)
            .map(|i| {
                let s = i as f64 / (n_basis.max(2) - 1) as f64;
                (1.0 + a * s) * (-a * s).exp()
            })
            .collect()
    }
}

/// Weights of each basis function, and the forcing term that they give at each step.
pub struct Learned {
    pub weights: Vec<[f64; LANES]>,
    pub forces: Vec<Joints>,
}

/// Weights by locally weighted regression, each basis function alone,
/// w = sum(v target psi) / (sum(v² psi) + floor). `pushed` holds v times the target of
/// each joint at each step, and v² in the lane [`SPARE`].
pub fn learn(phase: &Phase, n_basis: usize, pushed: &[Joints], floor: f64) -> Learned {
    vector::dispatch(Work {
        phase,
        centres: phase.centres(n_basis),
        weights: Weights::Learn { pushed, floor },
    })
}

/// The forcing term at each step for given weights.
pub fn forces(phase: &Phase, weights: Vec<[f64; LANES]>) -> Vec<Joints> {
    vector::dispatch(Work {
        phase,
        centres: phase.centres(weights.len()),
        weights: Weights::Given(weights),
    })
    .forces
}

enum Weights<'a> {
    Learn { pushed: &'a [Joints], floor: f64 },
    Given(Vec<[f64; LANES]>),
}

struct Work<'a> {
    phase: &'a Phase,
    centres: Vec<f64>,
    weights: Weights<'a>,
}

impl Kernel for Work<'_> {
    type Output = Learned;

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> Learned {
        let (steps, n_basis) = (self.phase.steps, self.centres.len());
        let mut learned = Learned {
            weights: Vec::with_capacity(n_basis),
            forces: vec![Aligned([0.0; LANES]); steps],
        };
        let mut psi = vec![0.0; steps + LANES];
        for i in 0..n_basis {
            let (first, end) = self.basis::<FUSED>(i, &mut psi);
            let mut weight = match &self.weights {
                Weights::Given(weights) => weights[i],
                Weights::Learn { pushed, floor } => fit::<FUSED>(&psi, &pushed[first..end], *floor),
            };
            learned.weights.push(weight);
            weight[SPARE] = 1.0;
            for (force, &psi) in learned.forces[first..end].iter_mut().zip(&psi) {
                for lane in 0..LANES {
                    force.0[lane] = multiply_add::<FUSED>(psi, weight[lane], force.0[lane]);
                }
            }
        }
        for (force, v) in learned.forces.iter_mut().zip(&self.phase.v) {
            let share = v / (force.0[SPARE] + n_basis as f64 * EPSILON);
            for lane in 0..LANES {
                force.0[lane] *= share;
            }
        }
        learned
    }
}

impl Work<'_> {
    /// Values of basis function `i`; gives the steps (from, to) that they are for.
    #[inline(always)]
    fn basis<const FUSED: bool>(&self, i: usize, psi: &mut [f64]) -> (usize, usize) {
        let (centres, x) = (&self.centres, &self.phase.x);
        let spacing = if centres.len() == 1 {
            1.0
        } else {
            let next = i.min(centres.len() - 2);
            centres[next + 1] - centres[next]
        };
        let (centre, width) = (centres[i], WIDTH * spacing);
        let reach = (-2.0 * FAR).sqrt() * width.abs();
        // The phase falls monotonically: the support is one stretch of time.
        let phase = &x[..self.phase.steps];
        let first = phase.partition_point(|&phase| phase > centre + reach);
        let end = phase
            .partition_point(|&phase| phase >= centre - reach)
            .max(first);
        let inverse = 1.0 / width;
        for at in (first..end).step_by(LANES) {
            let powers = exp_lanes::<FUSED, LANES>(lanes(|lane| {
                let offset = (x[at + lane] - centre) * inverse;
                -0.5 * offset * offset
            }));
            psi[at - first..at - first + LANES].copy_from_slice(&powers);
        }
        (first, end)
    }
}

/// Weights of one basis function with the values `psi`.
#[inline(always)]
fn fit<const FUSED: bool>(psi: &[f64], pushed: &[Joints], floor: f64) -> [f64; LANES] {
    let mut sums = [[0.0; LANES]; BESIDE];
    let whole = pushed.len() / BESIDE * BESIDE;
    for at in (0..whole).step_by(BESIDE) {
        for beside in 0..BESIDE {
            add::<FUSED>(&mut sums[beside], psi[at + beside], &pushed[at + beside]);
        }
    }
    for at in whole..pushed.len() {
        add::<FUSED>(&mut sums[0], psi[at], &pushed[at]);
    }
    let sum: [f64; LANES] =
        lanes(|lane| (sums[0][lane] + sums[1][lane]) + (sums[2][lane] + sums[3][lane]));
    lanes(|lane| sum[lane] / (sum[SPARE] + floor))
}

#[inline(always)]
fn add<const FUSED: bool>(sum: &mut [f64; LANES], psi: f64, pushed: &Joints) {
    for lane in 0..LANES {
        sum[lane] = multiply_add::<FUSED>(psi, pushed.0[lane], sum[lane]);
    }
}
