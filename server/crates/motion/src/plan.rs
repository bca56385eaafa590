//! A motion that has passed the gate: the exact samples that will be streamed,
//! with a hash by which a person's approval names them.

use sha2::{Digest, Sha256};

use crate::{JOINTS, JointAngles, JointVelocities};

/// Position and speed reference of one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setpoint {
    /// Where the joints should be.
    pub joints: JointAngles,
    /// How fast they should be moving there.
    pub velocities: JointVelocities,
}

/// A signal that is set on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanSignal {
    /// The controller's name of the signal.
    pub name: String,
    /// When, seconds from the first sample.
    pub at_s: f64,
    /// The value from then on.
    pub on: bool,
}

impl Setpoint {
    /// Standing still at `joints`.
    pub fn at_rest(joints: JointAngles) -> Self {
        Self {
            joints,
            velocities: JointVelocities::ZERO,
        }
    }
}

/// An approved motion: equally spaced samples, at rest at both ends.
///
/// Only [`crate::gate::approve`] makes one, so that holding a `Plan` means that
/// its samples were checked.
#[derive(Clone, Debug)]
pub struct Plan {
    period_s: f64,
    approach_samples: usize,
    samples: Vec<Setpoint>,
    signals: Vec<PlanSignal>,
    hash: String,
}

impl Plan {
    pub(crate) fn new(
        period_s: f64,
        approach_samples: usize,
        samples: Vec<Setpoint>,
        signals: Vec<PlanSignal>,
    ) -> Plan {
        let mut digest = Sha256::new();
        digest.update(period_s.to_le_bytes());
        digest.update((approach_samples as u64).to_le_bytes());
        for sample in &samples {
            for value in sample.joints.0.iter().chain(&sample.velocities.0) {
                digest.update(value.to_le_bytes());
            }
        }
        for signal in &signals {
            digest.update((signal.name.len() as u64).to_le_bytes());
            digest.update(signal.name.as_bytes());
            digest.update(signal.at_s.to_le_bytes());
            digest.update([u8::from(signal.on)]);
        }
        let hash = digest
            .finalize()
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect();
        Plan {
            period_s,
            approach_samples,
            samples,
            signals,
            hash,
        }
    }

    /// Time between two samples, seconds.
    pub fn period_s(&self) -> f64 {
        self.period_s
    }

    /// Time from the first to the last sample, seconds.
    pub fn duration_s(&self) -> f64 {
        (self.samples.len() - 1) as f64 * self.period_s
    }

    /// When the approach to the start is over and the motion proper begins, seconds.
    pub fn approach_s(&self) -> f64 {
        self.approach_samples as f64 * self.period_s
    }

    /// The samples, never empty.
    pub fn samples(&self) -> &[Setpoint] {
        &self.samples
    }

    /// The signals that are set on the way, in the order of time.
    pub fn signals(&self) -> &[PlanSignal] {
        &self.signals
    }

    /// Where the arm must stand when the plan begins.
    pub fn first(&self) -> JointAngles {
        self.samples[0].joints
    }

    /// Where the plan ends.
    pub fn last(&self) -> JointAngles {
        self.samples[self.samples.len() - 1].joints
    }

    /// SHA-256 over period, approach, the exact bytes of the samples and the signals, in hex.
    pub fn hash(&self) -> &str {
        &self.hash
    }

    /// Reference at `t_s` seconds: cubic Hermite between the samples, at rest
    /// before the first and after the last. Allocates nothing.
    pub fn at(&self, t_s: f64) -> Setpoint {
        let last = self.samples.len() - 1;
        if t_s.is_nan() || t_s <= 0.0 || last == 0 {
            return Setpoint::at_rest(self.samples[0].joints);
        }
        let position = t_s / self.period_s;
        if position >= last as f64 {
            return Setpoint::at_rest(self.samples[last].joints);
        }
        let index = position as usize;
        let u = position - index as f64;
        let (a, b) = (&self.samples[index], &self.samples[index + 1]);
        let h = self.period_s;
        let mut joints = [0.0; JOINTS];
        let mut velocities = [0.0; JOINTS];
        for j in 0..JOINTS {
            let (p0, p1) = (a.joints.0[j], b.joints.0[j]);
            let (m0, m1) = (a.velocities.0[j] * h, b.velocities.0[j] * h);
            let c2 = 3.0 * (p1 - p0) - 2.0 * m0 - m1;
            let c3 = 2.0 * (p0 - p1) + m0 + m1;
            joints[j] = p0 + u * (m0 + u * (c2 + u * c3));
            velocities[j] = (m0 + u * (2.0 * c2 + u * 3.0 * c3)) / h;
        }
        Setpoint {
            joints: JointAngles(joints),
            velocities: JointVelocities(velocities),
        }
    }
}

#[cfg(test)]
mod tests;
