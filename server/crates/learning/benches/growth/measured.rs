//! Measuring a process's time and memory, and the table of what was measured.

use std::time::{Duration, Instant};

use rustix::time::{ClockId, clock_gettime};

use crate::cases::Case;

/// Quick work is repeated, and the best time counts.
const RUNS: usize = 3;
const LONG_ENOUGH: Duration = Duration::from_secs(2);

/// What a case costs.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    pub case: Case,
    pub wall_s: f64,
    pub cpu_s: f64,
    /// None where the system does not tell it.
    pub peak_mb: Option<f64>,
}

/// Does the work of `case` and measures it.
pub fn measured(case: Case, mut work: impl FnMut()) -> Measured {
    let begun = Instant::now();
    let (mut wall_s, mut cpu_s) = (f64::INFINITY, f64::INFINITY);
    for run in 0..RUNS {
        if run > 0 && begun.elapsed() > LONG_ENOUGH {
            break;
        }
        let (wall, cpu) = (Instant::now(), processor_time_s());
        work();
        wall_s = wall_s.min(wall.elapsed().as_secs_f64());
        cpu_s = cpu_s.min(processor_time_s() - cpu);
    }
    Measured {
        case,
        wall_s,
        cpu_s,
        peak_mb: peak_mb(),
    }
}

/// Of this process so far.
fn processor_time_s() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// Largest resident memory of this process so far; Linux tells it in KiB.
fn peak_mb() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kib: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib * 1024.0 / 1e6)
}

impl Measured {
    pub const HEADER: &str = "growth,task,what,demonstrations,length_s,k,wall_s,cpu_s,peak_mb";

    /// Whether it needed more memory than it may.
    pub fn is_too_large(&self) -> bool {
        let allowed_mb = self.case.allowed_mb().unwrap_or(f64::INFINITY);
        self.peak_mb.is_some_and(|peak_mb| peak_mb > allowed_mb)
    }

    pub fn to_csv(&self) -> String {
        let peak = self.peak_mb.map_or(String::new(), |mb| format!("{mb:.1}"));
        format!(
            "{},{:.4},{:.4},{peak}",
            self.case.to_csv(),
            self.wall_s,
            self.cpu_s
        )
    }

    pub fn from_csv(line: &str) -> Measured {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |at: usize| fields[at].parse().unwrap();
        Measured {
            case: Case::from_csv(line),
            wall_s: number(6),
            cpu_s: number(7),
            peak_mb: (!fields[8].is_empty()).then(|| number(8)),
        }
    }
}

impl Case {
    pub fn to_csv(&self) -> String {
        format!(
            "{},{},{},{},{},{}",
            self.growth, self.task, self.what, self.demonstrations, self.length_s, self.k
        )
    }

    pub fn from_csv(line: &str) -> Case {
        let fields: Vec<&str> = line.split(',').collect();
        Case {
            growth: fields[0].into(),
            task: fields[1].into(),
            what: fields[2].into(),
            demonstrations: fields[3].parse().unwrap(),
            length_s: fields[4].parse().unwrap(),
            k: fields[5].parse().unwrap(),
        }
    }
}
