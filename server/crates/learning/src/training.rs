//! The whole way from demonstrations to a model.

mod encoding;

use std::ops::ControlFlow;

use crate::{
    Demonstration, Error, Method, Model, Progress, Report, Stage, TrainingParams,
    dmp::{self, Extent, Imitation, MovementPrimitive},
    metrics,
    optimisation::{self, Optimum},
    progress::{self, Counter},
    regression::Regression,
    report::{self, Lineage, NoiseFigures},
    rng::Stream,
    selection::Stability,
    signals,
    statistics::mean,
};
use encoding::Encoding;

/// Most demonstrations of one task.
const MAX_DEMONSTRATIONS: usize = 50;
const STREAM_NOISE: u64 = 4;
/// Reproductions for each level of start noise, as in the paper.
const NOISE_RUNS: usize = 30;
const NOISE_DEG: [f64; 4] = [1.0, 5.0, 10.0, 20.0];

/// Learns the motion of `task` from `demonstrations`.
///
/// `progress` is called with every step, from several threads; breaking from it
/// ends the training with [`Error::Cancelled`].
pub fn train(
    task: &str,
    demonstrations: &[Demonstration],
    params: &TrainingParams,
    progress: &(dyn Fn(Progress) -> ControlFlow<()> + Sync),
) -> Result<Model, Error> {
    let encoding = encode(demonstrations, params, progress)?;
    let regression = &encoding.regression;
    let (primitive, optimum) = optimise(regression, params, progress)?;

    let counter = Counter::begin(progress, Stage::Evaluation, NOISE_DEG.len() + 1)?;
    let taught = primitive.rollout(&primitive.start_deg, &primitive.goal_deg, Extent::AsTaught)?;
    let mut start_noise = Vec::new();
    for noise_deg in NOISE_DEG {
        start_noise.push(noise_figures(
            &primitive,
            regression,
            params.seed,
            noise_deg,
        )?);
        counter.step()?;
    }
    let gmcc = metrics::gmcc_both(&taught, &regression.mean_deg);
    let report = Report {
        task: task.to_string(),
        method: params.method,
        seed: params.seed,
        demonstrations: demonstrations.iter().map(Lineage::of).collect(),
        reference: demonstrations[encoding.reference].name().to_string(),
        notes: report::notes(demonstrations),
        agreement: encoding.agreement,
        k: encoding.k,
        left_out: encoding.left_out,
        js: encoding
            .js
            .into_iter()
            .map(|s| Stability {
                values: Vec::new(),
                ..s
            })
            .collect(),
        alignment_missed_mean_mm: metrics::missed_mean_mm(demonstrations, &encoding.middle_deg),
        alpha_z: primitive.alpha_z,
        n_basis: primitive.n_basis(),
        objective: optimum.best.value,
        objective_rms: metrics::objective_rms(&taught, &regression.mean_deg),
        bo_calls: optimum.evaluations.len(),
        on_bound: !on_bound_of(&optimum, params).is_empty(),
        on_bound_of: on_bound_of(&optimum, params),
        gmcc: gmcc.published,
        gmcc_centred: gmcc.centred,
        e_j_deg: metrics::e_j_deg(taught.last(), &primitive.goal_deg),
        start_noise,
        fidelity: metrics::fidelity(demonstrations, &taught, primitive.dt_s),
    };
    counter.step()?;
    Ok(Model::new(
        report,
        params.clone(),
        encoding.mixture,
        encoding.course,
        primitive,
    )
    .with_signals(encoding.signals))
}

/// The motion that the demonstrations have in common, by the method of `params`.
pub(crate) fn encode(
    demonstrations: &[Demonstration],
    params: &TrainingParams,
    progress: progress::Report,
) -> Result<Encoding, Error> {
    check(demonstrations)?;
    match params.method {
        Method::Paper => encoding::by_the_paper(demonstrations, params, progress),
        Method::Faithful => encoding::faithfully(demonstrations, params, progress),
    }
}

fn check(demonstrations: &[Demonstration]) -> Result<(), Error> {
    let first = demonstrations.first().ok_or(Error::NoDemonstrations)?;
    if demonstrations.len() > MAX_DEMONSTRATIONS {
        return Err(Error::TooManyDemonstrations {
            found: demonstrations.len(),
            limit: MAX_DEMONSTRATIONS,
        });
    }
    match demonstrations.iter().find(|d| d.joints() != first.joints()) {
        Some(other) => Err(Error::DifferentJointCounts {
            name: other.name().to_string(),
            other: first.name().to_string(),
            expected: first.joints(),
            found: other.joints(),
        }),
        None => signals::check_same(demonstrations),
    }
}

/// Finds alpha_z and N, and the primitive that belongs to them.
fn optimise(
    regression: &Regression,
    params: &TrainingParams,
    progress: progress::Report,
) -> Result<(MovementPrimitive, Optimum), Error> {
    let counter = Counter::begin(progress, Stage::Optimisation, params.search.max_calls)?;
    let imitation = imitation(regression, params.method);
    let optimum = optimisation::minimise(&params.search, params.seed, &mut |point| {
        counter.step()?;
        Ok(objective_at(&imitation, point))
    })?;
    let [alpha_z, n_basis] = optimum.best.point;
    let primitive = imitation
        .with(f64::from(alpha_z))
        .primitive(n_basis as usize);
    Ok((primitive, optimum))
}

/// The regression, ready to be imitated with many candidates (alpha_z, N).
pub(crate) fn imitation(regression: &Regression, method: Method) -> Imitation {
    let dt_s = regression.t_s[1] - regression.t_s[0];
    let path = &regression.mean_deg;
    let (tau_s, floor) = match method {
        // A faithful motion comes to rest by itself: it is pushed to its very end.
        Method::Faithful => (regression.t_s[path.len() - 1], dmp::SMALLEST_FLOOR),
        Method::Paper => (dmp::time_constant_s(path, dt_s), dmp::PUBLISHED_FLOOR),
    };
    Imitation::of(path, dt_s, tau_s, floor)
}

/// The objective of the optimisation at (alpha_z, N), degrees.
pub(crate) fn objective_at(imitation: &Imitation, [alpha_z, n_basis]: [u32; 2]) -> f64 {
    imitation
        .with(f64::from(alpha_z))
        .objective(n_basis as usize)
}

fn on_bound_of(optimum: &Optimum, params: &TrainingParams) -> Vec<String> {
    let search = &params.search;
    ["alpha_z", "n_basis"]
        .into_iter()
        .enumerate()
        .filter(|&(i, _)| {
            let value = optimum.best.point[i];
            value == search.low[i] || value == search.high[i]
        })
        .map(|(_, name)| name.to_string())
        .collect()
}

/// GMCC and e_j over reproductions whose start has independent normal noise on
/// every joint; the goal stays.
fn noise_figures(
    primitive: &MovementPrimitive,
    regression: &Regression,
    seed: u64,
    noise_deg: f64,
) -> Result<NoiseFigures, Error> {
    let mut rng = Stream::derive(seed, &[STREAM_NOISE, noise_deg.to_bits()]);
    let landscape = primitive.landscape();
    let (mut gmccs, mut centred, mut errors) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..NOISE_RUNS {
        let start: Vec<f64> = primitive
            .start_deg
            .iter()
            .map(|q| q + noise_deg * rng.normal())
            .collect();
        let path = landscape.rollout(&start, &primitive.goal_deg, Extent::AsTaught)?;
        let both = metrics::gmcc_both(&path, &regression.mean_deg);
        gmccs.push(both.published);
        centred.push(both.centred);
        errors.push(metrics::e_j_deg(path.last(), &primitive.goal_deg));
    }
    Ok(NoiseFigures {
        noise_deg,
        runs: NOISE_RUNS,
        gmcc: mean(&gmccs),
        gmcc_min: gmccs.iter().copied().fold(f64::INFINITY, f64::min),
        gmcc_centred: Some(mean(&centred)),
        e_j_deg: mean(&errors),
        e_j_max_deg: errors.iter().copied().fold(0.0, f64::max),
    })
}
