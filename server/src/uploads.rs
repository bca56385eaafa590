//! Recorded files from elsewhere: read, checked for this arm, and stored whole or not at all.

use crate::clock::WallTime;
use crate::ids::{DemonstrationId, TaskId};
use crate::jobs::demonstration_with;
use crate::store::demonstrations::{
    Demonstration, DemonstrationSource, DemonstrationState, NewDemonstration,
};
use crate::store::samples::Sample;
use crate::store::signals::SignalEvent;
use crate::store::{self, Store};

/// Why a file was not stored.
#[derive(Debug, thiserror::Error)]
pub enum UploadError {
    /// It is not text.
    #[error("the file is not text")]
    NotText,
    /// It is from another arm.
    #[error("this recording has {found} joints, and this arm has {JOINTS}", JOINTS = motion::JOINTS)]
    OtherArm {
        /// How many joints it has.
        found: usize,
    },
    /// Nothing can be learnt from it.
    #[error(transparent)]
    Learning(#[from] learning::Error),
    /// The store refused.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// The thread that read it broke off.
    #[error("reading the file broke off: {0}")]
    Broke(#[from] tokio::task::JoinError),
}

/// Reads a file and stores it as a task's next take.
///
/// # Errors
/// When the file can't be used; then nothing is stored.
pub async fn store(
    store: &Store,
    task_id: TaskId,
    name: &str,
    body: impl AsRef<[u8]> + Send + 'static,
    now: WallTime,
) -> Result<Demonstration, UploadError> {
    store.task(task_id).await?;
    let label: String = name.chars().filter(|c| !c.is_control()).take(80).collect();
    let read_as = label.clone();
    let (samples, signals) =
        tokio::task::spawn_blocking(move || read(&read_as, body.as_ref())).await??;
    let new = NewDemonstration {
        id: DemonstrationId::new(),
        task_id,
        state: DemonstrationState::Recorded,
        source: DemonstrationSource::File,
        robot: None,
    };
    let note = format!("From the file {label}.");
    Ok(store
        .store_demonstration(new, &samples, &signals, &note, now)
        .await?)
}

fn read(name: &str, body: &[u8]) -> Result<(Vec<Sample>, Vec<SignalEvent>), UploadError> {
    let text = std::str::from_utf8(body).map_err(|_| UploadError::NotText)?;
    let demonstration = learning::read::from_str(name, text)?;
    let rows = demonstration.joints_deg();
    if rows.width() != motion::JOINTS {
        return Err(UploadError::OtherArm {
            found: rows.width(),
        });
    }
    let times_s = demonstration.times_s();
    let begin_s = times_s.first().copied().unwrap_or_default();
    let tcp_mm = demonstration.recorded_tcp_mm();
    let samples: Vec<Sample> = times_s
        .iter()
        .zip(rows.rows())
        .enumerate()
        .map(|(row, (t_s, joints))| Sample {
            at_us: ((t_s - begin_s) * 1e6).round() as u64,
            joints_deg: std::array::from_fn(|joint| joints[joint]),
            tcp_mm: tcp_mm.map(|tcp| tcp[row]),
        })
        .collect();
    let signals: Vec<SignalEvent> = demonstration
        .signals()
        .iter()
        .map(|event| SignalEvent {
            at_us: ((event.at_s - begin_s) * 1e6).round() as u64,
            name: event.name.clone(),
            on: event.on,
        })
        .collect();
    // Times are kept in microseconds; what is stored has to be as good as what was read.
    demonstration_with(name, &samples, &signals)?;
    Ok((samples, signals))
}
