//! A demonstration: what was recorded while a person guided the arm, checked.

use std::ops::RangeInclusive;

use motion::{JOINTS, JointAngles, kinematics, limits::RobotLimits};
use sha2::{Digest, Sha256};

use crate::{
    Error,
    path::Path,
    signals::{self, SignalEvent},
};

/// Most samples of one demonstration (an hour at 100 Hz).
pub const MAX_SAMPLES: usize = 360_000;
/// A recording must be longer than this, seconds.
pub const MIN_DURATION_S: f64 = 1.0;
/// A joint that travels less than this in a demonstration is called still, degrees.
pub const STILL_DEG: f64 = 0.05;
/// The arm is idle at an end while no joint is further from it than this, degrees.
const IDLE_DEG: f64 = 0.2;

/// One recorded example of a motion: times, joint angles and, where known, the
/// positions of the tool. Times are increasing and everything is finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Demonstration {
    name: String,
    times_s: Vec<f64>,
    joints_deg: Path,
    tcp_mm: Option<Vec<[f64; 3]>>,
    signals: Vec<SignalEvent>,
}

impl Demonstration {
    /// Checks a recording: `times_s` of n samples, `joints_deg` n rows of 1 to 7
    /// angles, `tcp_mm` n positions of tool0 in the base frame when recorded.
    ///
    /// A six-joint recording must lie within the GoFa's ranges; its tool positions
    /// are computed where they were not recorded.
    pub fn new(
        name: String,
        times_s: Vec<f64>,
        joints_deg: Vec<Vec<f64>>,
        tcp_mm: Option<Vec<[f64; 3]>>,
    ) -> Result<Demonstration, Error> {
        let n = times_s.len();
        let ragged = |what: String, expected, found| Error::Ragged {
            name: name.clone(),
            what,
            expected,
            found,
        };
        if joints_deg.len() != n {
            return Err(ragged("joints".into(), n, joints_deg.len()));
        }
        if let Some(tcp) = &tcp_mm
            && tcp.len() != n
        {
            return Err(ragged("tcp".into(), n, tcp.len()));
        }
        let joints = joints_deg.first().map_or(0, Vec::len);
        if n > 0 && !(1..=7).contains(&joints) {
            return Err(Error::JointCount {
                name,
                found: joints,
            });
        }
        if let Some(row) = joints_deg.iter().position(|r| r.len() != joints) {
            let found = joints_deg[row].len();
            return Err(ragged(format!("row {}", row + 1), joints, found));
        }
        if n > MAX_SAMPLES {
            return Err(Error::TooLong {
                name,
                samples: n,
                limit: MAX_SAMPLES,
            });
        }
        check_finite(&name, &times_s, &joints_deg, tcp_mm.as_deref())?;
        check_times(&name, &times_s)?;
        let joints_deg = Path::from_rows(joints.max(1), joints_deg);
        check_range(&name, &joints_deg)?;
        if (0..joints_deg.width()).all(|j| joints_deg.column_span(j) < STILL_DEG) {
            return Err(Error::NoMotion { name });
        }
        Ok(Demonstration {
            name,
            times_s,
            joints_deg,
            tcp_mm,
            signals: Vec::new(),
        })
    }

    /// The same demonstration with the signals that were worked in it, in any order; an
    /// event at the first sample's time says how a signal stood at the beginning.
    ///
    /// Errors: [`Error::BadSignal`] for an event outside the recording or without a name.
    pub fn with_signals(self, events: Vec<SignalEvent>) -> Result<Demonstration, Error> {
        let (first_s, last_s) = (self.times_s[0], self.times_s[self.len() - 1]);
        let signals = signals::checked(&self.name, events, first_s, last_s)?;
        Ok(Demonstration { signals, ..self })
    }

    /// Name by which people know it, such as a file name or "take 3".
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.times_s.len()
    }

    /// Never true: an empty recording is refused.
    pub fn is_empty(&self) -> bool {
        self.times_s.is_empty()
    }

    /// Number of joints.
    pub fn joints(&self) -> usize {
        self.joints_deg.width()
    }

    /// Time stamps as recorded, seconds, increasing.
    pub fn times_s(&self) -> &[f64] {
        &self.times_s
    }

    /// Joint angles, one row a sample, degrees.
    pub fn joints_deg(&self) -> &Path {
        &self.joints_deg
    }

    /// Recorded positions of tool0, if any, mm.
    pub fn recorded_tcp_mm(&self) -> Option<&[[f64; 3]]> {
        self.tcp_mm.as_deref()
    }

    /// The signals' events in the order of time.
    pub fn signals(&self) -> &[SignalEvent] {
        &self.signals
    }

    /// The events that change a signal after the beginning.
    pub fn signal_changes(&self) -> Vec<&SignalEvent> {
        signals::changes(&self.signals, self.times_s[0])
    }

    /// Length of the recording, seconds.
    pub fn duration_s(&self) -> f64 {
        self.times_s[self.len() - 1] - self.times_s[0]
    }

    /// Positions of tool0 by forward kinematics, mm; none unless there are six joints.
    pub fn tool_path_mm(&self) -> Option<Vec<[f64; 3]>> {
        tool_path_mm(&self.joints_deg)
    }

    /// What alignment compares: the recorded tool positions, else those of forward
    /// kinematics, else (any other number of joints) the joint angles themselves.
    pub fn alignment_signal(&self) -> Path {
        match self.tcp_mm.clone().or_else(|| self.tool_path_mm()) {
            Some(positions) => Path::from_rows(3, positions.iter().map(|p| p.to_vec())),
            None => self.joints_deg.clone(),
        }
    }

    /// From the first sample that has left the start to the last one that is not yet
    /// at the end: what lies before and after is idle.
    pub fn moving(&self) -> RangeInclusive<usize> {
        let path = &self.joints_deg;
        let away = |i: usize, from: usize| {
            path.row(i)
                .iter()
                .zip(path.row(from))
                .any(|(a, b)| (a - b).abs() > IDLE_DEG)
        };
        let last = path.len() - 1;
        let begins = (0..=last).find(|&i| away(i, 0)).unwrap_or(0);
        let ends = (0..=last).rev().find(|&i| away(i, last)).unwrap_or(last);
        begins.min(ends)..=begins.max(ends)
    }

    /// Joints (from 0) that stand still in this demonstration.
    pub fn still_joints(&self) -> Vec<usize> {
        (0..self.joints())
            .filter(|&j| self.joints_deg.column_span(j) < STILL_DEG)
            .collect()
    }

    /// SHA-256 over times, joint angles and signals, in hex: the lineage of a model.
    pub fn hash(&self) -> String {
        let mut digest = Sha256::new();
        digest.update((self.joints() as u64).to_le_bytes());
        for (i, t) in self.times_s.iter().enumerate() {
            digest.update(t.to_le_bytes());
            for q in self.joints_deg.row(i) {
                digest.update(q.to_le_bytes());
            }
        }
        for event in &self.signals {
            digest.update((event.name.len() as u64).to_le_bytes());
            digest.update(event.name.as_bytes());
            digest.update(event.at_s.to_le_bytes());
            digest.update([u8::from(event.on)]);
        }
        digest
            .finalize()
            .iter()
            .map(|b| format!("{b:02x}"))
            .collect()
    }
}

/// Positions of tool0 along a six-joint path, mm; none for other joint counts.
pub fn tool_path_mm(joints_deg: &Path) -> Option<Vec<[f64; 3]>> {
    (joints_deg.width() == JOINTS).then(|| {
        joints_deg
            .rows()
            .map(|row| {
                let mut angles = [0.0; JOINTS];
                angles.copy_from_slice(row);
                kinematics::tool0(&JointAngles(angles)).position.0
            })
            .collect()
    })
}

fn check_finite(
    name: &str,
    times_s: &[f64],
    joints_deg: &[Vec<f64>],
    tcp_mm: Option<&[[f64; 3]]>,
) -> Result<(), Error> {
    let bad = |what: String, row: usize| Error::NotFinite {
        name: name.into(),
        what,
        row: row + 1,
    };
    for (row, t) in times_s.iter().enumerate() {
        if !t.is_finite() {
            return Err(bad("time".into(), row));
        }
        if let Some(j) = joints_deg[row].iter().position(|q| !q.is_finite()) {
            return Err(bad(format!("joint {}", j + 1), row));
        }
        if tcp_mm.is_some_and(|tcp| tcp[row].iter().any(|p| !p.is_finite())) {
            return Err(bad("tcp".into(), row));
        }
    }
    Ok(())
}

fn check_times(name: &str, times_s: &[f64]) -> Result<(), Error> {
    if let Some(i) = (1..times_s.len()).find(|&i| times_s[i] <= times_s[i - 1]) {
        return Err(Error::TimeNotIncreasing {
            name: name.into(),
            row: i + 1,
            before_s: times_s[i - 1],
            after_s: times_s[i],
        });
    }
    let duration_s = match times_s {
        [first, .., last] => last - first,
        _ => 0.0,
    };
    if duration_s <= MIN_DURATION_S {
        return Err(Error::TooShort {
            name: name.into(),
            duration_s,
        });
    }
    Ok(())
}

fn check_range(name: &str, joints_deg: &Path) -> Result<(), Error> {
    if joints_deg.width() != JOINTS {
        return Ok(());
    }
    let limits = RobotLimits::gofa5();
    for (row, angles) in joints_deg.rows().enumerate() {
        for (j, &value_deg) in angles.iter().enumerate() {
            let (min_deg, max_deg) = (limits.joint_min_deg[j], limits.joint_max_deg[j]);
            if value_deg < min_deg || value_deg > max_deg {
                return Err(Error::JointOutOfRange {
                    name: name.into(),
                    joint: j + 1,
                    row: row + 1,
                    value_deg,
                    min_deg,
                    max_deg,
                });
            }
        }
    }
    Ok(())
}
