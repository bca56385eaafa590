//! `team reproduce MODEL.json`: a motion from a start to a goal, as numbers.

use std::io::Write;
use std::path::PathBuf;

use learning::{Model, dmp::Extent, metrics, rng::Stream};
use motion::{JOINTS, JointAngles, limits::RobotLimits};

use super::CliError;

/// Label of the noise stream, apart from those of training.
const STREAM_START_NOISE: u64 = 100;

/// Arguments of `team reproduce`.
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// Model file written by `team train --model`.
    pub model: PathBuf,
    /// Where to begin: "as-taught" or joint angles in degrees, q1,..,q6.
    #[arg(long, default_value = "as-taught", value_parser = Target::parse, allow_hyphen_values = true)]
    pub start: Target,
    /// Where to end: "as-taught" or joint angles in degrees, q1,..,q6.
    #[arg(long, default_value = "as-taught", value_parser = Target::parse, allow_hyphen_values = true)]
    pub goal: Target,
    /// Standard deviation of normal noise on every joint of the start, degrees.
    #[arg(long, default_value_t = 0.0, value_name = "S")]
    pub noise_deg: f64,
    /// Seed of the noise.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Print the path as CSV: t_s,q1_deg,..,q6_deg.
    #[arg(long)]
    pub csv: bool,
}

/// A start or a goal.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// That of the demonstrations.
    AsTaught,
    /// These joint angles, degrees.
    Joints(Vec<f64>),
}

impl Target {
    fn parse(text: &str) -> Result<Target, String> {
        if text == "as-taught" {
            return Ok(Target::AsTaught);
        }
        text.split(',')
            .map(|field| {
                let angle: f64 = field
                    .trim()
                    .parse()
                    .map_err(|_| format!("\"{field}\" is not an angle in degrees"))?;
                if angle.is_finite() {
                    Ok(angle)
                } else {
                    Err(format!("\"{field}\" is not a finite angle"))
                }
            })
            .collect::<Result<_, _>>()
            .map(Target::Joints)
    }

    /// Six angles are the GoFa's and must be within its ranges.
    fn check(&self, which: &str) -> Result<(), CliError> {
        let Target::Joints(angles) = self else {
            return Ok(());
        };
        let Ok(angles) = <[f64; JOINTS]>::try_from(&**angles) else {
            return Ok(());
        };
        let limits = RobotLimits::gofa5();
        let Some(joint) = limits.joint_out_of_range(&JointAngles(angles)) else {
            return Ok(());
        };
        Err(CliError::Usage(format!(
            "joint {} of the {which} is {}°, its range is {}° to {}°",
            joint + 1,
            angles[joint],
            limits.joint_min_deg[joint],
            limits.joint_max_deg[joint]
        )))
    }

    fn or(&self, taught: &[f64]) -> Vec<f64> {
        match self {
            Target::AsTaught => taught.to_vec(),
            Target::Joints(angles) => angles.clone(),
        }
    }
}

/// Reproduces and prints the path or its figures.
pub fn run(args: &Args) -> Result<(), CliError> {
    if !(args.noise_deg.is_finite() && args.noise_deg >= 0.0) {
        return Err(CliError::Usage(
            "--noise-deg must be 0 or more degrees".into(),
        ));
    }
    let text = std::fs::read_to_string(&args.model).map_err(CliError::file(&args.model))?;
    let model = Model::from_json(&text).map_err(|error| CliError::Model {
        path: args.model.display().to_string(),
        error,
    })?;
    args.start.check("start")?;
    args.goal.check("goal")?;
    let mut start = args.start.or(model.start_deg());
    let goal = args.goal.or(model.goal_deg());
    let mut rng = Stream::derive(args.seed, &[STREAM_START_NOISE]);
    for angle in &mut start {
        *angle += args.noise_deg * rng.normal();
    }
    let path = model.reproduce(&start, &goal, Extent::AsTaught)?;
    if args.csv {
        let out = std::io::stdout().lock();
        return match write_csv(out, &path, model.primitive.dt_s) {
            // Whoever reads may stop early, as `head` does.
            Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
            written => written.map_err(CliError::file("standard output".as_ref())),
        };
    }
    let regression = model.regression();
    let angles = |values: &[f64]| {
        values
            .iter()
            .map(|v| format!("{v:.3}"))
            .collect::<Vec<_>>()
            .join(", ")
    };
    println!("start      {} deg", angles(&start));
    println!("goal       {} deg", angles(&goal));
    println!("end        {} deg", angles(path.last()));
    println!(
        "duration   {:.2} s",
        (path.len() - 1) as f64 * model.primitive.dt_s
    );
    println!(
        "e_j        {:.4} deg commanded",
        metrics::e_j_deg(path.last(), &goal)
    );
    println!(
        "GMCC       {:.6} against the regression",
        metrics::gmcc(&path, &regression.mean_deg)
    );
    println!("Print the path itself with --csv.");
    Ok(())
}

fn write_csv(out: impl Write, path: &learning::Path, dt_s: f64) -> std::io::Result<()> {
    let mut out = std::io::BufWriter::new(out);
    write!(out, "t_s")?;
    for j in 1..=path.width() {
        write!(out, ",q{j}_deg")?;
    }
    writeln!(out)?;
    for (i, row) in path.rows().enumerate() {
        write!(out, "{:.6}", i as f64 * dt_s)?;
        for angle in row {
            write!(out, ",{angle:.6}")?;
        }
        writeln!(out)?;
    }
    out.flush()
}
