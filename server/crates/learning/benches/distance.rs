//! How many samples the Jensen-Shannon distance needs, in the published form and in
//! the one that `selection::js` estimates: `cargo bench -p learning --bench distance`.
//!
//! Both forms are written out here in the plainest way; only the last column comes
//! from the code that is judged.

#![expect(
    clippy::unwrap_used,
    reason = "a benchmark stops at what it does not expect"
)]

mod takes;

use learning::{
    Demonstration, TrainingParams, alignment,
    mixture::{self, Mixture, Rows},
    rng::Stream,
    selection::js,
    statistics::mean,
};
use nalgebra::{SMatrix, SVector};

/// Time and six joints.
const D: usize = 7;
/// Samples from each mixture, as published.
const SAMPLES: usize = 100_000;

type Vector = SVector<f64, D>;

fn main() {
    println!("task,k,distance,published_form,its_error_percent,samples_for_2_percent,ours");
    print_task("synthetic", &takes::synthetic(4, 30.0));
    for (name, folder) in [("T1", "T1_opening"), ("T2", "T2_brush_picking_up")] {
        if let Some(takes) = takes::published(folder) {
            print_task(name, &takes);
        }
    }
}

/// For each k of the protocol, mixtures fitted to two random halves of the samples.
fn print_task(name: &str, takes: &[Demonstration]) {
    let aligned = alignment::align(takes, 100.0, &mut |_, _| Ok(())).unwrap();
    let all: Vec<usize> = (0..takes.len()).collect();
    let values = aligned.rows(&all);
    let rows = Rows::new(D, &values);
    let range = TrainingParams::paper(1).selection;
    for k in range.k_min..=range.k_max {
        let mut rng = Stream::derive(1, &[k as u64]);
        let (first, second): (Vec<usize>, Vec<usize>) =
            rows.by_time().iter().partition(|_| rng.uniform() < 0.5);
        let mut fit = |half: &[usize]| mixture::fit(rows, half, k, &mut rng).unwrap().mixture;
        let pair = [fit(&first), fit(&second)];
        let [published, nonnegative] = estimate(&pair, &mut rng);
        println!(
            "{name},{k},{:.4},{:.4},{:.2},{:.0},{:.4}",
            nonnegative.distance(),
            published.distance(),
            100.0 * published.relative_error(),
            // The error falls with the root of the number of samples.
            2.0 * SAMPLES as f64 * (nonnegative.relative_error() / 0.02).powi(2),
            js::distance(&pair[0], &pair[1], &mut rng).unwrap(),
        );
    }
}

/// A divergence and its standard error.
struct Estimate {
    divergence: f64,
    error: f64,
}

impl Estimate {
    fn distance(&self) -> f64 {
        self.divergence.max(0.0).sqrt()
    }

    /// Of the distance, whose relative error is half that of the divergence.
    fn relative_error(&self) -> f64 {
        0.5 * self.error / self.divergence.abs()
    }
}

/// With m = (p + q) / 2 and u = p / (p + q): half the means of ln p - ln m over
/// samples of p and of ln q - ln m over samples of q, as published; and the mean of
/// u ln 2u + (1 - u) ln 2(1 - u) over all of them.
fn estimate(pair: &[Mixture; 2], rng: &mut Stream) -> [Estimate; 2] {
    let prepared = pair.each_ref().map(prepare);
    let mut ratios = [Vec::new(), Vec::new()];
    let mut terms = Vec::new();
    for (from, ratios) in ratios.iter_mut().enumerate() {
        for _ in 0..SAMPLES {
            let x = draw(&prepared[from], rng);
            let [p, q] = prepared.each_ref().map(|mixture| log_density(mixture, &x));
            let u = 1.0 / (1.0 + (q - p).exp());
            let (own, other) = if from == 0 { (p, q) } else { (q, p) };
            ratios.push(-(0.5 * (1.0 + (other - own).exp())).ln());
            terms.push(entropy_term(u) + entropy_term(1.0 - u));
        }
    }
    let [p, q] = ratios.each_ref().map(|values| estimate_mean(values));
    [
        Estimate {
            divergence: 0.5 * (p.divergence + q.divergence),
            error: 0.5 * p.error.hypot(q.error),
        },
        estimate_mean(&terms),
    ]
}

fn estimate_mean(values: &[f64]) -> Estimate {
    let (n, centre) = (values.len() as f64, mean(values));
    let squares: f64 = values.iter().map(|v| (v - centre).powi(2)).sum();
    Estimate {
        divergence: centre,
        error: (squares / (n - 1.0) / n).sqrt(),
    }
}

fn entropy_term(u: f64) -> f64 {
    if u > 0.0 { u * (2.0 * u).ln() } else { 0.0 }
}

/// A component: its weight, its mean, and the lower factor of its covariance.
struct Component {
    weight: f64,
    mean: Vector,
    factor: SMatrix<f64, D, D>,
    log_scale: f64,
}

fn prepare(mixture: &Mixture) -> Vec<Component> {
    (0..mixture.weights.len())
        .map(|c| {
            let covariance = SMatrix::<f64, D, D>::from_fn(|i, j| mixture.covariances[c][i][j]);
            let factor = covariance.cholesky().unwrap().l();
            let log_determinant: f64 = factor.diagonal().iter().map(|l| l.ln()).sum();
            let normal = 0.5 * D as f64 * (2.0 * std::f64::consts::PI).ln();
            Component {
                weight: mixture.weights[c],
                mean: Vector::from_column_slice(&mixture.means[c]),
                factor,
                log_scale: mixture.weights[c].ln() - log_determinant - normal,
            }
        })
        .collect()
}

fn draw(mixture: &[Component], rng: &mut Stream) -> Vector {
    let mut left = rng.uniform();
    let chosen = mixture.iter().find(|component| {
        left -= component.weight;
        left < 0.0
    });
    let component = chosen.unwrap_or(&mixture[mixture.len() - 1]);
    component.mean + component.factor * Vector::from_fn(|_, _| rng.normal())
}

fn log_density(mixture: &[Component], x: &Vector) -> f64 {
    let logs: Vec<f64> = mixture
        .iter()
        .map(|component| {
            let whitened = component
                .factor
                .solve_lower_triangular(&(x - component.mean));
            component.log_scale - 0.5 * whitened.unwrap().norm_squared()
        })
        .collect();
    let max = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    max + logs.iter().map(|log| (log - max).exp()).sum::<f64>().ln()
}
