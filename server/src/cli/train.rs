//! `team train FOLDER`: demonstrations in files, a model in a file.

use std::io::IsTerminal;
use std::path::PathBuf;
use std::time::Duration;

use learning::{Method, Model, Stage, TrainingParams};
use serde::Serialize;

use super::{
    CliError, folder,
    terminal::{Watch, now},
};

/// Arguments of `team train`.
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// Folder with the recorded demonstrations of one task (.json or .csv).
    pub folder: PathBuf,
    /// How to learn: "faithful" goes where the demonstrations went; "paper" is the
    /// paper's method to its protocol.
    #[arg(long, default_value = "faithful", value_parser = method)]
    pub method: Method,
    /// Seed of all random numbers; the same seed gives the same model.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Threads to compute with; 0 takes all cores. The result does not depend on it.
    #[arg(long, default_value_t = 0)]
    pub threads: usize,
    /// Write the model to this file.
    #[arg(long, value_name = "OUT.json")]
    pub model: Option<PathBuf>,
    /// Print one JSON object with everything that was found.
    #[arg(long)]
    pub json: bool,
}

pub(super) fn method(name: &str) -> Result<Method, String> {
    Method::from_name(name)
        .ok_or_else(|| format!("no method is called \"{name}\"; use \"faithful\" or \"paper\""))
}

#[derive(Serialize)]
struct Printed<'a> {
    #[serde(flatten)]
    report: &'a learning::Report,
    summary: String,
    threads: usize,
    stages_s: serde_json::Map<String, serde_json::Value>,
    cpu_s: f64,
    wall_s: f64,
}

/// Trains and prints the result.
pub fn run(args: &Args) -> Result<(), CliError> {
    let demonstrations = folder::demonstrations(&args.folder)?;
    let task = folder::task_name(&args.folder);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(args.threads)
        .build()?;
    let params = TrainingParams::of(args.method, args.seed);

    let watch = Watch::begin(!args.json && std::io::stderr().is_terminal());
    let (began, cpu_before) = (now(), cpu_time());
    let result = pool.install(|| {
        learning::train(&task, &demonstrations, &params, &|progress| {
            watch.see(progress)
        })
    });
    let wall_s = began.elapsed().as_secs_f64();
    let cpu_s = cpu_time().saturating_sub(cpu_before).as_secs_f64();
    let stages = watch.finish();
    let model = result?;

    if let Some(path) = &args.model {
        write_whole(path, &model.to_json())?;
    }
    if args.json {
        let printed = Printed {
            report: &model.report,
            summary: model.summary(),
            threads: pool.current_num_threads(),
            stages_s: stages
                .iter()
                .map(|(stage, seconds)| (stage.name().to_string(), (*seconds).into()))
                .collect(),
            cpu_s,
            wall_s,
        };
        println!(
            "{}",
            serde_json::to_string_pretty(&printed).unwrap_or_default()
        );
    } else {
        print_report(&model, &stages, wall_s, cpu_s);
    }
    Ok(())
}

/// Processor time of this process so far.
fn cpu_time() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(
        u64::try_from(time.tv_sec).unwrap_or(0),
        u32::try_from(time.tv_nsec).unwrap_or(0),
    )
}

/// A reader never sees half a model: it is written beside and moved into place.
fn write_whole(path: &std::path::Path, text: &str) -> Result<(), CliError> {
    let mut beside = path.as_os_str().to_owned();
    beside.push(".part");
    let beside = PathBuf::from(beside);
    std::fs::write(&beside, text).map_err(CliError::file(&beside))?;
    std::fs::rename(&beside, path).map_err(CliError::file(path))
}

fn print_report(model: &Model, stages: &[(Stage, f64)], wall_s: f64, cpu_s: f64) {
    let report = &model.report;
    println!("{}", model.summary());
    println!("{}", report.agreement.advice);
    for note in &report.notes {
        println!("Note: {note}");
    }
    println!();
    println!("task             {}", report.task);
    println!(
        "method           {}, seed {}",
        report.method.name(),
        report.seed
    );
    println!(
        "demonstrations   {}, time axis of {}",
        report.demonstrations.len(),
        report.reference
    );
    for take in &report.agreement.takes {
        let tool = take
            .off_mm
            .map_or_else(String::new, |mm| format!("{mm:.1} mm, "));
        println!(
            "  {:<20} {tool}{:.1} deg from the others, most at joint {} at {:.0} %{}",
            take.name,
            take.off_deg,
            take.worst.joint,
            100.0 * take.worst.phase,
            if take.differs { "  <- differs" } else { "" }
        );
    }
    for s in &report.js {
        let mark = if s.k == report.k { "  <- k*" } else { "" };
        println!(
            "  k = {:<2} JS      {:.4} ± {:.4}{mark}",
            s.k, s.mean, s.std
        );
    }
    for left_out in &report.left_out {
        println!(
            "  k = {:<2} a left-out demonstration misses {:.2} mm",
            left_out.k, left_out.missed
        );
    }
    let edge = if report.on_bound {
        format!(
            ", on the edge of the searched box: {}",
            report.on_bound_of.join(", ")
        )
    } else {
        String::new()
    };
    println!(
        "alpha_z, N       {}, {} ({} evaluations{edge})",
        report.alpha_z, report.n_basis, report.bo_calls
    );
    println!(
        "objective        {:.4} deg (with the true root mean square {:.4})",
        report.objective, report.objective_rms
    );
    println!(
        "GMCC, e_j        {:.6} (centred {:.6}), {:.4} deg commanded",
        report.gmcc, report.gmcc_centred, report.e_j_deg
    );
    for noise in &report.start_noise {
        println!(
            "  start ± {:<4} deg  GMCC {:.6} (least {:.6}), e_j {:.4} deg (most {:.4})",
            noise.noise_deg, noise.gmcc, noise.gmcc_min, noise.e_j_deg, noise.e_j_max_deg
        );
    }
    print_fidelity(report);
    let stages: Vec<String> = stages
        .iter()
        .map(|(stage, seconds)| format!("{} {seconds:.2}", stage.name()))
        .collect();
    println!(
        "time             {wall_s:.2} s, {cpu_s:.2} s of processor ({})",
        stages.join(", ")
    );
}

fn print_fidelity(report: &learning::Report) {
    let Some(f) = &report.fidelity else {
        println!("fidelity         not known: only six-joint motions have a tool path");
        return;
    };
    let list = |values: &[f64]| {
        values
            .iter()
            .map(|v| format!("{v:.0}"))
            .collect::<Vec<_>>()
            .join(" ")
    };
    println!(
        "fidelity [mm]    missed {:.1} mean, {:.1} max; off path {:.1} mean, {:.1} max",
        f.missed_mean_mm, f.missed_max_mm, f.off_path_mean_mm, f.off_path_max_mm
    );
    if let (Some(mean), Some(max), Some(ratio)) =
        (f.mutual_mean_mm, f.mutual_max_mm, f.missed_over_mutual)
    {
        println!(
            "                 mutual {mean:.1} mean, {max:.1} max; missed over mutual {ratio:.2}"
        );
    }
    println!(
        "                 start to the demonstrated starts {} (their spread {:.0})",
        list(&f.start_mm),
        f.start_spread_mm
    );
    println!(
        "                 end to the demonstrated ends {} (their spread {:.0})",
        list(&f.end_mm),
        f.end_spread_mm
    );
    println!(
        "                 peaks {:.0} deg/s, {:.0} deg/s², {:.0} deg/s³ (shown: {:.0}, {:.0}, {:.0})",
        f.reproduction.peak_speed_deg_s,
        f.reproduction.peak_acceleration_deg_s2,
        f.reproduction.peak_jerk_deg_s3,
        f.demonstrations.peak_speed_deg_s,
        f.demonstrations.peak_acceleration_deg_s2,
        f.demonstrations.peak_jerk_deg_s3,
    );
    println!(
        "                 duration {:.1} s (shown, without idle ends: {:.1} s)",
        f.duration_s, f.demonstrated_duration_s
    );
}
