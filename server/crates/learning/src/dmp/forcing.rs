//! The forcing term: basis functions of the phase and their weights.

/// Added to each basis function in the normalisation, which so never divides by
/// zero far from every centre.
const EPSILON: f64 = 1e-10;
/// Basis functions below exp of this are taken as zero (8.8e-27).
const FAR: f64 = -60.0;
/// Width of a basis function in units of the distance to the next centre.
const WIDTH: f64 = 0.55;

/// Phase and basis functions over time, for one (alpha_z, N, tau).
pub struct Forcing {
    /// Phase velocity at each step.
    v: Vec<f64>,
    bases: Vec<Basis>,
    /// sum_i (psi_i + EPSILON) at each step.
    normalisation: Vec<f64>,
}

/// One basis function where it is not zero: from step `first` on.
struct Basis {
    first: usize,
    values: Vec<f64>,
}

impl Forcing {
    pub fn new(alpha_z: f64, n_basis: usize, tau_s: f64, dt_s: f64, steps: usize) -> Forcing {
        let (x, v) = phase(alpha_z, tau_s, dt_s, steps);
        let centres = centres(alpha_z, n_basis);
        let mut normalisation = vec![n_basis as f64 * EPSILON; steps];
        let bases = (0..n_basis)
            .map(|i| {
                let spacing = if n_basis == 1 {
                    1.0
                } else {
                    let next = i.min(n_basis - 2);
                    centres[next + 1] - centres[next]
                };
                let width = WIDTH * spacing;
                let reach = (-2.0 * FAR).sqrt() * width.abs();
                // The phase falls monotonically: the support is one stretch of time.
                let first = x.partition_point(|&phase| phase > centres[i] + reach);
                let end = x.partition_point(|&phase| phase >= centres[i] - reach);
                let values: Vec<f64> = x[first..end.max(first)]
                    .iter()
                    .map(|phase| {
                        let offset = (phase - centres[i]) / width;
                        (-0.5 * offset * offset).exp()
                    })
                    .collect();
                for (sum, psi) in normalisation[first..].iter_mut().zip(&values) {
                    *sum += psi;
                }
                Basis { first, values }
            })
            .collect();
        Forcing {
            v,
            bases,
            normalisation,
        }
    }

    /// Weights by locally weighted regression: each basis function alone,
    /// w = sum(v target psi) / (sum(v² psi) + floor).
    pub fn fit(&self, target: &[f64], floor: f64) -> Vec<f64> {
        self.bases
            .iter()
            .map(|basis| {
                let (mut above, mut below) = (0.0, 0.0);
                for (offset, psi) in basis.values.iter().enumerate() {
                    let v = self.v[basis.first + offset];
                    above += v * target[basis.first + offset] * psi;
                    below += v * v * psi;
                }
                above / (below + floor)
            })
            .collect()
    }

    /// Forcing term at each step, for each set of weights (one set a joint).
    pub fn evaluate(&self, weights: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let mut forces = vec![vec![0.0; weights.len()]; self.v.len()];
        for (i, basis) in self.bases.iter().enumerate() {
            for (force, psi) in forces[basis.first..].iter_mut().zip(&basis.values) {
                for (f, w) in force.iter_mut().zip(weights) {
                    *f += w[i] * psi;
                }
            }
        }
        for ((force, v), sum) in forces.iter_mut().zip(&self.v).zip(&self.normalisation) {
            for f in force {
                *f *= v / sum;
            }
        }
        forces
    }
}

/// Phase x and its scaled velocity v before each Euler step.
fn phase(alpha: f64, tau_s: f64, dt_s: f64, steps: usize) -> (Vec<f64>, Vec<f64>) {
    let (mut x, mut v) = (1.0, 0.0);
    let mut xs = Vec::with_capacity(steps);
    let mut vs = Vec::with_capacity(steps);
    for _ in 0..steps {
        xs.push(x);
        vs.push(v);
        let dv = alpha * (-alpha / 4.0 * x - v) / tau_s;
        let dx = v / tau_s;
        v += dv * dt_s;
        x += dx * dt_s;
    }
    (xs, vs)
}

/// Phase of the exact solution at equally spaced times from 0 to tau.
fn centres(alpha: f64, n_basis: usize) -> Vec<f64> {
    let a = alpha / 2.0;
    (0..n_basis)
        .map(|i| {
            let s = i as f64 / (n_basis.max(2) - 1) as f64;
            (1.0 + a * s) * (-a * s).exp()
        })
        .collect()
}
