//! The job that makes a model from demonstrations: reading, training, and the model's file.

use sha2::{Digest, Sha256};

use super::queue::hex;
use super::{JobContext, JobError};
use crate::ids::ModelId;
use crate::store::jobs::JobProgress;
use crate::store::models::TrainedModel;
use crate::store::samples::Sample;
use crate::store::signals::SignalEvent;
use crate::store::text::Failure;
use crate::store::{self, Store};
use crate::trimming::recording;

/// Everything that a training needs, read from the store.
pub(crate) struct Inputs {
    task: String,
    demonstrations: Vec<(String, Vec<Sample>, Vec<SignalEvent>)>,
    method: learning::Method,
    seed: u64,
}

/// Reads what a model is to be trained from.
pub(crate) async fn inputs(store: &Store, model: ModelId) -> Result<Inputs, JobError> {
    let model = store.model(model).await?;
    let Some(method) = learning::Method::from_name(&model.method) else {
        return Err(JobError::Fail(Failure {
            code: "method_unknown".into(),
            message: format!("This program does not know the method {}.", model.method),
            advice: "Train again.".into(),
        }));
    };
    let task = match store.task(model.task_id).await {
        Ok(task) => task.name,
        Err(store::Error::NotFound { .. }) => {
            return Err(JobError::Fail(Failure {
                code: "task_deleted".into(),
                message: "The task was deleted before the training began.".into(),
                advice: "Make a new task.".into(),
            }));
        }
        Err(error) => return Err(error.into()),
    };
    let mut demonstrations = Vec::with_capacity(model.demonstrations.len());
    for source in model.sources() {
        let take = store.demonstration(source.id).await?.take;
        let recorded = recording(store, source.id, source.trim).await?;
        demonstrations.push((format!("take {take}"), recorded.samples, recorded.signals));
    }
    Ok(Inputs {
        task,
        demonstrations,
        method,
        seed: model.seed,
    })
}

/// A stored recording as the learning method wants it.
///
/// # Errors
/// When nothing can be learnt from it: too short, no motion, a joint out of range and so on.
pub(crate) fn demonstration_of(
    name: &str,
    samples: &[Sample],
) -> Result<learning::Demonstration, learning::Error> {
    let times_s = samples.iter().map(|s| s.at_us as f64 / 1e6).collect();
    let joints_deg = samples.iter().map(|s| s.joints_deg.to_vec()).collect();
    let tcp_mm = samples.iter().map(|s| s.tcp_mm).collect();
    learning::Demonstration::new(name.to_owned(), times_s, joints_deg, tcp_mm)
}

/// The same with what was done with signals meanwhile.
///
/// # Errors
/// As above, or when a signal can't be one.
pub(crate) fn demonstration_with(
    name: &str,
    samples: &[Sample],
    signals: &[SignalEvent],
) -> Result<learning::Demonstration, learning::Error> {
    let demonstration = demonstration_of(name, samples)?;
    let times_s = demonstration.times_s();
    let (first_s, last_s) = (times_s[0], times_s[times_s.len() - 1]);
    let events = signals.iter().map(|signal| learning::SignalEvent {
        name: signal.name.clone(),
        // One that was worked after the last sample was worked where the arm stood then.
        at_s: (signal.at_us as f64 / 1e6).clamp(first_s, last_s),
        on: signal.on,
    });
    let events = events.collect();
    demonstration.with_signals(events)
}

impl Inputs {
    /// Trains. CPU-heavy: for the trainer threads only.
    ///
    /// # Errors
    /// When the demonstrations don't make a model, or the job is called off.
    pub(crate) fn train(self, context: &JobContext) -> Result<TrainedModel, JobError> {
        let demonstrations = self
            .demonstrations
            .into_iter()
            .map(|(name, samples, signals)| demonstration_with(&name, &samples, &signals))
            .collect::<Result<Vec<_>, _>>()?;
        let params = learning::TrainingParams::of(self.method, self.seed);
        let report = |progress: learning::Progress| context.report(progress_of(&progress));
        let model = learning::train(&self.task, &demonstrations, &params, &report)?;
        let body = model.to_json().into_bytes();
        Ok(TrainedModel {
            summary: model.summary(),
            report: serde_json::to_value(&model.report).map_err(unwritable)?,
            start_deg: model.start_deg().to_vec(),
            goal_deg: model.goal_deg().to_vec(),
            duration_s: model.duration_s(),
            sha256: hex(&Sha256::digest(&body)),
            body,
        })
    }
}

fn progress_of(progress: &learning::Progress) -> JobProgress {
    JobProgress {
        stage: progress.stage.name().to_owned(),
        words: progress.stage.words().to_owned(),
        done: progress.done as u64,
        total: progress.total as u64,
        fraction: progress.fraction,
    }
}

fn unwritable(error: serde_json::Error) -> JobError {
    JobError::Fail(Failure {
        code: "model_unwritable".into(),
        message: format!("The model could not be written: {error}."),
        advice: "Your demonstrations are safe. Tell whoever looks after the server.".into(),
    })
}
