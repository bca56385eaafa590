//! Each stage of a training, and a whole one, on made-up takes and, where
//! TEAM_PAPER_DATA names the published recordings, on T1 and T2: `cargo bench -p
//! learning --bench stages`. On one thread, unless RAYON_NUM_THREADS says otherwise.
//!
//! How cost grows with the size of a task is another benchmark, `growth`.

#![expect(
    clippy::unwrap_used,
    reason = "a benchmark stops at what it does not expect"
)]

mod takes;

use std::ops::ControlFlow;
use std::sync::LazyLock;

use divan::Bencher;
use learning::{
    Demonstration, Method, TrainingParams,
    alignment::{
        self, Aligned,
        barycentre::{self, Barycentre},
        centre,
    },
    dmp::{self, Extent, Imitation, MovementPrimitive},
    mixture::{self, Mixture, Rows},
    optimisation,
    regression::{self, Regression},
    rng::Stream,
    selection::{self, SelectionParams},
    train,
};

const K: usize = 5;
/// Of the protocol's 50 halves for each k.
const SPLITS: usize = 4;
const ALPHA_Z: f64 = 25.0;
const N: usize = 200;

/// A task, and what each stage begins with.
struct Task {
    name: &'static str,
    demonstrations: Vec<Demonstration>,
    aligned: Aligned,
    barycentre: Barycentre,
    rows: Vec<f64>,
    mixtures: [Mixture; 2],
    regression: Regression,
}

static TASKS: LazyLock<Vec<Task>> = LazyLock::new(|| {
    let mut tasks = vec![Task::new("synthetic", takes::synthetic(4, 30.0))];
    for (name, folder) in [("T1", "T1_opening"), ("T2", "T2_brush_picking_up")] {
        tasks.extend(takes::published(folder).map(|takes| Task::new(name, takes)));
    }
    tasks
});

impl Task {
    fn new(name: &'static str, demonstrations: Vec<Demonstration>) -> Task {
        let aligned = alignment::align(&demonstrations, 100.0, &mut |_, _| Ok(())).unwrap();
        let barycentre =
            barycentre::align_to_mean(&demonstrations, 100.0, &mut |_, _| Ok(())).unwrap();
        let all: Vec<usize> = (0..demonstrations.len()).collect();
        let rows = aligned.rows(&all);
        let fit = |seed: u64| {
            let rows = Rows::new(7, &rows);
            let chosen = rows.by_time();
            let half: Vec<usize> = chosen.into_iter().skip(seed as usize).step_by(2).collect();
            let mut rng = Stream::derive(seed, &[]);
            mixture::fit(rows, &half, K, &mut rng).unwrap().mixture
        };
        let mixtures = [fit(0), fit(1)];
        let regression = regression::regress(&mixtures[0], &aligned.t_s);
        Task {
            name,
            demonstrations,
            aligned,
            barycentre,
            rows,
            mixtures,
            regression,
        }
    }

    fn rows(&self) -> Rows<'_> {
        Rows::new(7, &self.rows)
    }
}

fn names() -> Vec<&'static str> {
    TASKS.iter().map(|task| task.name).collect()
}

fn task(name: &str) -> &'static Task {
    TASKS.iter().find(|task| task.name == name).unwrap()
}

fn main() {
    if std::env::var_os("RAYON_NUM_THREADS").is_none() {
        let one = rayon::ThreadPoolBuilder::new().num_threads(1);
        one.build_global().unwrap();
    }
    divan::main();
}

/// Positions of the tool of all takes.
#[divan::bench(args = names(), sample_size = 1)]
fn forward_kinematics(bencher: Bencher, name: &str) {
    let takes = &task(name).demonstrations;
    let samples: usize = takes.iter().map(Demonstration::len).sum();
    bencher
        .counter(divan::counter::ItemsCount::new(samples))
        .bench(|| {
            takes
                .iter()
                .map(Demonstration::tool_path_mm)
                .collect::<Vec<_>>()
        });
}

#[divan::bench(args = names(), sample_count = 10, sample_size = 1)]
fn alignment_paper(bencher: Bencher, name: &str) {
    let takes = &task(name).demonstrations;
    bencher.bench(|| alignment::align(takes, 100.0, &mut |_, _| Ok(())));
}

#[divan::bench(args = names(), sample_count = 10, sample_size = 1)]
fn alignment_faithful(bencher: Bencher, name: &str) {
    let takes = &task(name).demonstrations;
    bencher.bench(|| barycentre::align_to_mean(takes, 100.0, &mut |_, _| Ok(())));
}

#[divan::bench(args = names(), sample_count = 10, sample_size = 1)]
fn middle_of_the_bundle(bencher: Bencher, name: &str) {
    let found = &task(name).barycentre;
    bencher.bench(|| centre::centred(&found.aligned, &found.clocks_s));
}

/// One fit of five components, k-means included.
#[divan::bench(args = names(), sample_count = 20, sample_size = 1)]
fn mixture_of_5(bencher: Bencher, name: &str) {
    let rows = task(name).rows();
    let chosen = rows.by_time();
    bencher.bench(|| mixture::fit(rows, &chosen, K, &mut Stream::derive(1, &[])));
}

/// One fit of fifty components that begin as stretches of time.
#[divan::bench(args = names(), sample_count = 20, sample_size = 1)]
fn mixture_along_time_of_50(bencher: Bencher, name: &str) {
    let rows = task(name).rows();
    bencher.bench(|| mixture::fit_along_time(rows, 50));
}

/// k = 2..9 with 4 halves each instead of 50.
#[divan::bench(args = names(), sample_count = 5, sample_size = 1)]
fn selection_paper_4_splits(bencher: Bencher, name: &str) {
    let rows = task(name).rows();
    let params = SelectionParams {
        splits: SPLITS,
        ..TrainingParams::paper(1).selection
    };
    bencher.bench(|| selection::stabilities(rows, &params, 1, &|| Ok(())));
}

#[divan::bench(args = names(), sample_count = 5, sample_size = 1)]
fn selection_faithful(bencher: Bencher, name: &str) {
    let aligned = &task(name).barycentre.aligned;
    let candidates = TrainingParams::faithful(1).candidates;
    bencher.bench(|| selection::leave_one_out(aligned, &candidates, 1, &|| Ok(())));
}

/// Between two mixtures of five components, each from another half of the rows.
#[divan::bench(args = names(), sample_size = 1)]
fn jensen_shannon_distance(bencher: Bencher, name: &str) {
    let [p, q] = &task(name).mixtures;
    bencher.bench(|| selection::js::distance(p, q, &mut Stream::derive(1, &[])));
}

#[divan::bench(args = names(), sample_size = 1)]
fn regression(bencher: Bencher, name: &str) {
    let task = task(name);
    bencher.bench(|| regression::regress(&task.mixtures[0], &task.aligned.t_s));
}

fn imitation_of(curve: &Regression) -> Imitation {
    let (path, dt_s) = (&curve.mean_deg, curve.t_s[1]);
    let tau_s = dmp::time_constant_s(path, dt_s);
    Imitation::of(path, dt_s, tau_s, dmp::PUBLISHED_FLOOR)
}

fn imitate(curve: &Regression) -> MovementPrimitive {
    imitation_of(curve).with(ALPHA_Z).primitive(N)
}

#[divan::bench(args = names(), sample_size = 1)]
fn imitation(bencher: Bencher, name: &str) {
    let curve = &task(name).regression;
    bencher.bench(|| imitate(curve));
}

#[divan::bench(args = names(), sample_size = 1)]
fn roll_out(bencher: Bencher, name: &str) {
    let primitive = imitate(&task(name).regression);
    let (start, goal) = (&primitive.start_deg, &primitive.goal_deg);
    bencher.bench(|| primitive.rollout(start, goal, Extent::AsTaught));
}

/// One evaluation of the objective of the search.
#[divan::bench(args = names(), sample_size = 1)]
fn search_one_point(bencher: Bencher, name: &str) {
    let imitation = imitation_of(&task(name).regression);
    bencher.bench(|| imitation.with(ALPHA_Z).objective(N));
}

/// The whole search for alpha_z and N in the paper's box.
#[divan::bench(args = names(), sample_count = 10, sample_size = 1)]
fn search(bencher: Bencher, name: &str) {
    let curve = &task(name).regression;
    let search = TrainingParams::paper(1).search;
    bencher.bench(|| {
        let imitation = imitation_of(curve);
        optimisation::minimise(&search, 1, &mut |[alpha_z, n_basis]| {
            let stiffness = imitation.with(f64::from(alpha_z));
            Ok(stiffness.objective(n_basis as usize))
        })
    });
}

fn whole(bencher: Bencher, name: &str, method: Method) {
    let takes = &task(name).demonstrations;
    let params = TrainingParams::of(method, 1);
    bencher.bench(|| train(name, takes, &params, &|_| ControlFlow::Continue(())));
}

#[divan::bench(args = names(), sample_count = 3, sample_size = 1)]
fn training_paper(bencher: Bencher, name: &str) {
    whole(bencher, name, Method::Paper);
}

#[divan::bench(args = names(), sample_count = 3, sample_size = 1)]
fn training_faithful(bencher: Bencher, name: &str) {
    whole(bencher, name, Method::Faithful);
}
