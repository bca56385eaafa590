//! The model: everything that is needed to reproduce a motion and to know where it
//! came from. As JSON it documents its own units.

use serde::{Deserialize, Serialize};

use crate::{
    Error, Path, Report, TrainingParams,
    dmp::{Extent, MovementPrimitive},
    mixture::Mixture,
    regression::{Course, Regression},
    signals::{self, ModelSignal},
};

/// Marks model files.
pub const FORMAT: &str = "team-model";
/// Version of the file's form.
pub const VERSION: u32 = 1;

/// A trained motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Model {
    format: String,
    version: u32,
    units: Units,
    /// What was found, and how good it is.
    pub report: Report,
    /// What it was trained with.
    pub params: TrainingParams,
    /// Mixture over (time, joints).
    pub mixture: Mixture,
    /// How the motion is read off the mixture.
    pub course: Course,
    /// The spring that reproduces the motion.
    pub primitive: MovementPrimitive,
    /// The signals that are worked on the way, in the order of time.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub signals: Vec<ModelSignal>,
}

/// Units of the file, for whoever reads it without this program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Units {
    angles: String,
    times: String,
    lengths: String,
    mixture: String,
}

impl Model {
    pub(crate) fn new(
        report: Report,
        params: TrainingParams,
        mixture: Mixture,
        course: Course,
        primitive: MovementPrimitive,
    ) -> Model {
        Model {
            format: FORMAT.into(),
            version: VERSION,
            units: Units {
                angles: "degrees".into(),
                times: "seconds".into(),
                lengths: "millimetres".into(),
                mixture: "dimension 0 is time in seconds, the others are joints in degrees".into(),
            },
            report,
            params,
            mixture,
            course,
            primitive,
            signals: Vec::new(),
        }
    }

    pub(crate) fn with_signals(self, signals: Vec<ModelSignal>) -> Model {
        Model { signals, ..self }
    }

    /// Reads a model file and checks that it can be used.
    pub fn from_json(text: &str) -> Result<Model, Error> {
        let bad = |reason: String| Error::BadModel { reason };
        let model: Model = serde_json::from_str(text).map_err(|e| bad(e.to_string()))?;
        if model.format != FORMAT || model.version != VERSION {
            return Err(bad(format!(
                "this is {} version {}, {FORMAT} version {VERSION} is needed",
                model.format, model.version
            )));
        }
        model.check().map_err(bad)?;
        Ok(model)
    }

    /// The model as JSON text.
    pub fn to_json(&self) -> String {
        // Finite numbers and strings always serialise.
        serde_json::to_string_pretty(self).unwrap_or_default()
    }

    fn check(&self) -> Result<(), String> {
        let p = &self.primitive;
        let d = p.weights.len();
        let positive = |value: f64| value.is_finite() && value > 0.0;
        if !(1..=7).contains(&d) || p.start_deg.len() != d || p.goal_deg.len() != d {
            return Err("start, goal and weights are of different joint counts".into());
        }
        if !positive(p.alpha_z) || !positive(p.tau_s) || !positive(p.dt_s) {
            return Err("alpha_z, tau_s and dt_s must be positive".into());
        }
        if !(3..=1_000_000).contains(&p.steps) || p.n_basis() == 0 || p.n_basis() > 10_000 {
            return Err("steps or basis functions are out of range".into());
        }
        if p.weights.iter().any(|w| w.len() != p.n_basis()) {
            return Err("joints have different numbers of weights".into());
        }
        let k = self.mixture.weights.len();
        let square = |c: &Vec<Vec<f64>>| c.len() == d + 1 && c.iter().all(|row| row.len() == d + 1);
        if k == 0
            || self.mixture.means.len() != k
            || self.mixture.covariances.len() != k
            || self.mixture.means.iter().any(|m| m.len() != d + 1)
            || !self.mixture.covariances.iter().all(square)
        {
            return Err("the mixture's parts do not fit together".into());
        }
        self.course.check(d)?;
        signals::check_model(&self.signals)?;
        if self.mixture.covariances.iter().any(|c| !positive(c[0][0])) {
            return Err("a component of the mixture has no extent in time".into());
        }
        Ok(())
    }

    /// Number of joints.
    pub fn joints(&self) -> usize {
        self.primitive.weights.len()
    }

    /// Taught start, degrees.
    pub fn start_deg(&self) -> &[f64] {
        &self.primitive.start_deg
    }

    /// Taught goal, degrees.
    pub fn goal_deg(&self) -> &[f64] {
        &self.primitive.goal_deg
    }

    /// Duration of the taught motion, seconds.
    pub fn duration_s(&self) -> f64 {
        self.primitive.duration_s()
    }

    /// The learned motion with its spread, at the primitive's times.
    pub fn regression(&self) -> Regression {
        self.course.regress(&self.mixture)
    }

    /// The motion from `start_deg` to `goal_deg`, rows `primitive.dt_s` apart, degrees.
    ///
    /// Errors: [`Error::BadTarget`] when start or goal do not fit the joints.
    pub fn reproduce(
        &self,
        start_deg: &[f64],
        goal_deg: &[f64],
        extent: Extent,
    ) -> Result<Path, Error> {
        self.primitive.rollout(start_deg, goal_deg, extent)
    }

    /// The result in a sentence or two.
    pub fn summary(&self) -> String {
        self.report.summary()
    }
}
