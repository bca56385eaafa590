//! Asking for a training: which demonstrations, whether they can be used, and the way back from a
//! stored model to one that can be computed with.

use crate::ids::{DemonstrationId, ModelId, TaskId};
use crate::jobs::{Queue, TrainingRequest, demonstration_with};
use crate::store::demonstrations::{Demonstration, DemonstrationState};
use crate::store::jobs::Job;
use crate::store::models::{Model, ModelState, Source};
use crate::store::{self, Store};
use crate::trimming::recording;

/// The seed when nobody chooses one.
const SEED: u64 = 1;

/// What somebody wants to be trained.
#[derive(Clone, Debug)]
pub struct Wish {
    /// The task.
    pub task_id: TaskId,
    /// From what; all kept demonstrations when it is missing.
    pub demonstrations: Option<Vec<DemonstrationId>>,
    /// How; the usual method when it is missing.
    pub method: Option<String>,
    /// The seed of everything random.
    pub seed: Option<u64>,
}

/// Why a training could not begin, or a model not be used.
#[derive(Debug, thiserror::Error)]
pub enum TrainingError {
    /// The store refused.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// Nothing was kept.
    #[error("no demonstration of this task was kept")]
    NothingKept,
    /// A demonstration is of another task, or not there.
    #[error("this task has no demonstration {id}")]
    NotOfThisTask {
        /// Which one.
        id: DemonstrationId,
    },
    /// A demonstration is still being recorded.
    #[error("take {take} is still being recorded")]
    StillOpen {
        /// Which one.
        take: u32,
    },
    /// Nothing can be learnt from a demonstration.
    #[error("take {take} can't be used: {error}")]
    Unusable {
        /// Which one.
        id: DemonstrationId,
        /// Its number.
        take: u32,
        /// Why.
        error: learning::Error,
    },
    /// Demonstrations that are good alone do not go together.
    #[error(transparent)]
    Together(learning::Error),
    /// The method is not known.
    #[error("there is no method {0}")]
    UnknownMethod(String),
    /// The model is not trained.
    #[error("this model is {}; it must be ready for that", .0.as_str())]
    NotReady(ModelState),
    /// The stored file is no model any more.
    #[error("the stored model can't be read: {0}")]
    Damaged(String),
    /// A thread broke off.
    #[error("reading broke off: {0}")]
    Broke(#[from] tokio::task::JoinError),
}

/// Begins a training, or finds the one that was begun for the same.
///
/// # Errors
/// When a demonstration can't be used; then nothing is stored.
pub async fn begin(
    store: &Store,
    queue: &Queue,
    wish: Wish,
) -> Result<(Job, Model), TrainingError> {
    store.task(wish.task_id).await?;
    let method = match wish.method {
        None => learning::Method::default(),
        Some(name) => match learning::Method::from_name(&name) {
            Some(method) => method,
            None => return Err(TrainingError::UnknownMethod(name)),
        },
    };
    let all = store.demonstrations(wish.task_id).await?;
    let chosen = chosen(all, wish.demonstrations.as_deref())?;
    let mut checked = Vec::with_capacity(chosen.len());
    for demonstration in &chosen {
        checked.push(check(store, demonstration).await?);
    }
    learning::signals::check_same(&checked).map_err(TrainingError::Together)?;
    let request = TrainingRequest {
        task_id: wish.task_id,
        sources: chosen
            .iter()
            .map(|demonstration| Source {
                id: demonstration.id,
                trim: demonstration.trim,
            })
            .collect(),
        method: method.name().to_owned(),
        seed: wish.seed.unwrap_or(SEED),
    };
    Ok(queue.train(&request).await?)
}

/// The chosen demonstrations by take, each once, so that the order of asking makes no difference.
fn chosen(
    all: Vec<Demonstration>,
    wanted: Option<&[DemonstrationId]>,
) -> Result<Vec<Demonstration>, TrainingError> {
    if let Some(wanted) = wanted {
        let missing = wanted.iter().find(|id| all.iter().all(|d| d.id != **id));
        if let Some(id) = missing {
            return Err(TrainingError::NotOfThisTask { id: *id });
        }
    }
    let chosen: Vec<Demonstration> = all
        .into_iter()
        .filter(|demonstration| match wanted {
            Some(wanted) => wanted.contains(&demonstration.id),
            None => demonstration.state == DemonstrationState::Kept,
        })
        .collect();
    if chosen.is_empty() {
        return Err(TrainingError::NothingKept);
    }
    Ok(chosen)
}

async fn check(
    store: &Store,
    demonstration: &Demonstration,
) -> Result<learning::Demonstration, TrainingError> {
    let take = demonstration.take;
    if matches!(
        demonstration.state,
        DemonstrationState::Preparing | DemonstrationState::Recording
    ) {
        return Err(TrainingError::StillOpen { take });
    }
    let recorded = recording(store, demonstration.id, demonstration.trim).await?;
    let name = format!("take {take}");
    tokio::task::spawn_blocking(move || {
        demonstration_with(&name, &recorded.samples, &recorded.signals)
    })
    .await?
    .map_err(|error| TrainingError::Unusable {
        id: demonstration.id,
        take,
        error,
    })
}

/// A trained model, ready to be computed with.
///
/// # Errors
/// When it is not trained.
pub async fn load(store: &Store, id: ModelId) -> Result<learning::Model, TrainingError> {
    let model = store.model(id).await?;
    if model.state != ModelState::Ready {
        return Err(TrainingError::NotReady(model.state));
    }
    let (body, _) = store.model_file(id).await?;
    tokio::task::spawn_blocking(move || {
        let damaged = |error: &dyn std::fmt::Display| TrainingError::Damaged(error.to_string());
        let text = std::str::from_utf8(&body).map_err(|error| damaged(&error))?;
        learning::Model::from_json(text).map_err(|error| damaged(&error))
    })
    .await?
}
