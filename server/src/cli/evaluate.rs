//! `team evaluate FOLDER`: the tables of the paper's evaluation, with its figures
//! beside ours.

mod published;

use std::io::IsTerminal;
use std::ops::ControlFlow;
use std::path::PathBuf;

use learning::{
    Demonstration, Method, TrainingParams, evaluation,
    statistics::{mean, median, population_std},
};
use serde::Serialize;

use super::{CliError, folder, terminal::now};

/// A search that ends within 0.5 % of the grid's minimum has found it.
const NEAR: f64 = 1.005;

/// Arguments of `team evaluate`.
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// Folder with the recorded demonstrations of one task (.json or .csv).
    pub folder: PathBuf,
    /// Which table.
    #[arg(long, value_enum, default_value = "all")]
    pub table: Table,
    /// Runs for the statistics of k and of the optimisation.
    #[arg(long, default_value_t = 50, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub runs: u16,
    /// The method that is evaluated.
    #[arg(long, default_value = "paper", value_parser = super::train::method)]
    pub method: Method,
    /// Seed of the first run; the others follow.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Threads to compute with; 0 takes all cores.
    #[arg(long, default_value_t = 0)]
    pub threads: usize,
    /// Print the rows as CSV.
    #[arg(long, conflicts_with = "json")]
    pub csv: bool,
    /// Print the rows as JSON.
    #[arg(long)]
    pub json: bool,
}

/// The tables of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Table {
    /// The number of components over many runs.
    Repeatability,
    /// Grid search against Bayesian optimisation.
    Optimisation,
    /// Reproductions from noisy starts.
    Noise,
    /// All of them.
    All,
}

/// One figure: ours, and the paper's where it prints one.
#[derive(Debug, Serialize)]
struct Row {
    task: String,
    method: &'static str,
    table: &'static str,
    figure: String,
    value: f64,
    deviation: Option<f64>,
    paper: Option<f64>,
    paper_deviation: Option<f64>,
}

/// Computes and prints the tables.
pub fn run(args: &Args) -> Result<(), CliError> {
    let demonstrations = folder::demonstrations(&args.folder)?;
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(args.threads)
        .build()?;
    let evaluated = Evaluated {
        task: folder::task_name(&args.folder),
        params: TrainingParams::of(args.method, args.seed),
        runs: usize::from(args.runs),
        quiet: !std::io::stderr().is_terminal(),
        demonstrations,
    };
    let wants = |table: Table| args.table == table || args.table == Table::All;
    let mut rows = Vec::new();
    pool.install(|| -> Result<(), CliError> {
        if wants(Table::Repeatability) {
            evaluated.repeatability(&mut rows)?;
        }
        if wants(Table::Optimisation) {
            evaluated.optimisation(&mut rows)?;
        }
        if wants(Table::Noise) {
            evaluated.noise(&mut rows)?;
        }
        Ok(())
    })?;
    if args.json {
        println!(
            "{}",
            serde_json::to_string_pretty(&rows).unwrap_or_default()
        );
    } else if args.csv {
        print_csv(&rows);
    } else {
        print_table(&rows);
    }
    Ok(())
}

struct Evaluated {
    task: String,
    params: TrainingParams,
    runs: usize,
    quiet: bool,
    demonstrations: Vec<Demonstration>,
}

impl Evaluated {
    fn repeatability(&self, rows: &mut Vec<Row>) -> Result<(), CliError> {
        let bar = self.bar("choosing k");
        let result = evaluation::repeatability(
            &self.demonstrations,
            &self.params,
            self.runs,
            &|run, progress| {
                let share = (run as f64 + progress.fraction) / self.runs as f64;
                bar.set_position((1000.0 * share) as u64);
                ControlFlow::Continue(())
            },
        )?;
        bar.finish_and_clear();
        let paper = published::of(&self.task).map(|p| p.k);
        rows.push(self.row(
            "repeatability",
            "median k",
            result.median,
            Some(result.std),
            paper,
        ));
        Ok(())
    }

    fn optimisation(&self, rows: &mut Vec<Row>) -> Result<(), CliError> {
        let bar = self.bar("searching alpha_z and N");
        let searches =
            evaluation::Searches::prepare(&self.demonstrations, &self.params, &|progress| {
                bar.set_position((1000.0 * progress.fraction) as u64);
                ControlFlow::Continue(())
            })?;
        let began = now();
        let grid = searches.grid();
        let grid_s = began.elapsed().as_secs_f64();
        let began = now();
        let bayesian = (0..self.runs)
            .map(|run| searches.bayesian(run))
            .collect::<Result<Vec<_>, _>>()?;
        let bayesian_s = began.elapsed().as_secs_f64() / self.runs as f64;
        bar.finish_and_clear();
        let paper = published::of(&self.task);
        let values: Vec<f64> = bayesian.iter().map(|run| run.value).collect();
        let calls: Vec<f64> = bayesian.iter().map(|run| run.calls as f64).collect();
        let near = values.iter().filter(|&&v| v <= NEAR * grid.value).count();
        let table = "optimisation";
        rows.extend([
            self.row(
                table,
                "grid minimum",
                grid.value,
                None,
                paper.map(|p| (p.grid, 0.0)),
            ),
            self.row(
                table,
                "grid calls",
                grid.calls as f64,
                None,
                paper.map(|_| (published::GRID_CALLS as f64, 0.0)),
            ),
            self.row(table, "grid alpha_z", f64::from(grid.point[0]), None, None),
            self.row(table, "grid N", f64::from(grid.point[1]), None, None),
            self.row(
                table,
                "Bayesian minimum",
                mean(&values),
                Some(population_std(&values)),
                paper.map(|p| p.bayesian),
            ),
            self.row(
                table,
                "Bayesian calls",
                mean(&calls),
                Some(population_std(&calls)),
                paper.map(|p| p.calls),
            ),
            self.row(table, "Bayesian calls, median", median(&calls), None, None),
            self.row(
                table,
                "Bayesian runs within 0.5 % of the grid",
                near as f64,
                None,
                None,
            ),
            self.row(table, "grid, seconds", grid_s, None, None),
            self.row(table, "one Bayesian run, seconds", bayesian_s, None, None),
        ]);
        Ok(())
    }

    fn noise(&self, rows: &mut Vec<Row>) -> Result<(), CliError> {
        let bar = self.bar("training");
        let figures = evaluation::noise(
            &self.task,
            &self.demonstrations,
            &self.params,
            &|progress| {
                bar.set_position((1000.0 * progress.fraction) as u64);
                ControlFlow::Continue(())
            },
        )?;
        bar.finish_and_clear();
        let paper = published::of(&self.task);
        for (i, noise) in figures.iter().enumerate() {
            let figure = |name: &str| format!("{name} at {} deg", noise.noise_deg);
            rows.push(self.row(
                "noise",
                &figure("GMCC"),
                noise.gmcc,
                None,
                paper.map(|_| (1.0, 0.0)),
            ));
            rows.push(self.row(
                "noise",
                &figure("e_j [deg]"),
                noise.e_j_deg,
                None,
                paper.and_then(|p| p.e_j_deg.get(i)).map(|e| (*e, 0.0)),
            ));
        }
        Ok(())
    }

    fn row(
        &self,
        table: &'static str,
        figure: &str,
        value: f64,
        deviation: Option<f64>,
        paper: Option<(f64, f64)>,
    ) -> Row {
        Row {
            task: self.task.clone(),
            method: self.params.method.name(),
            table,
            figure: figure.to_string(),
            value,
            deviation,
            paper: paper.map(|p| p.0),
            paper_deviation: deviation.and(paper).map(|p| p.1),
        }
    }

    fn bar(&self, what: &'static str) -> indicatif::ProgressBar {
        if self.quiet {
            return indicatif::ProgressBar::hidden();
        }
        let bar = indicatif::ProgressBar::new(1000);
        if let Ok(style) =
            indicatif::ProgressStyle::with_template("{bar:40} {percent:>3} %  {eta} left  {msg}")
        {
            bar.set_style(style);
        }
        bar.with_message(what)
    }
}

fn print_table(rows: &[Row]) {
    let number = |value: Option<f64>, deviation: Option<f64>| match (value, deviation) {
        (Some(value), Some(deviation)) => format!("{value:.4} ± {deviation:.4}"),
        (Some(value), None) => format!("{value:.4}"),
        _ => "-".to_string(),
    };
    println!(
        "{:<28} {:<14} {:<24} {:>22} {:>20}",
        "task", "table", "figure", "here", "paper"
    );
    for row in rows {
        println!(
            "{:<28} {:<14} {:<24} {:>22} {:>20}",
            row.task,
            row.table,
            row.figure,
            number(Some(row.value), row.deviation),
            number(row.paper, row.paper_deviation)
        );
    }
}

fn print_csv(rows: &[Row]) {
    println!("task,method,table,figure,value,deviation,paper,paper_deviation");
    let cell = |value: Option<f64>| value.map_or_else(String::new, |v| v.to_string());
    for row in rows {
        println!(
            "{},{},{},\"{}\",{},{},{},{}",
            row.task,
            row.method,
            row.table,
            row.figure,
            row.value,
            cell(row.deviation),
            cell(row.paper),
            cell(row.paper_deviation)
        );
    }
}
