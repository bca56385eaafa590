//! Data folders that are made once and copied by every test that needs them, because a training
//! costs more than everything else in these tests.

use e2e::{Folder, Process};
use serde_json::{Value, json};
use tokio::sync::OnceCell;

use crate::steps::{task_from_files, train};
use crate::{PROGRAM, SCRATCH};

/// The seed of the prepared model.
pub const SEED: u64 = 1;

/// A task with kept demonstrations of the made-up motion, and a model trained from them.
pub struct Prepared {
    /// The data before the training.
    pub taught: Folder,
    /// The data after it.
    pub trained: Folder,
    pub task: String,
    pub model: Value,
    /// The model's file, byte for byte.
    pub file: Vec<u8>,
}

static PREPARED: OnceCell<Prepared> = OnceCell::const_new();

/// The prepared data.
pub async fn prepared() -> &'static Prepared {
    PREPARED.get_or_init(prepare).await
}

async fn prepare() -> Prepared {
    // A static is never dropped: the names are fixed so that the next run replaces the folders.
    let work = Folder::new(SCRATCH, "prepare");
    let taught = Folder::replacing(SCRATCH, "prepared-taught");
    let trained = Folder::replacing(SCRATCH, "prepared-trained");

    let server = Process::start(PROGRAM, work.path(), &["--robot", "none"]).await;
    let task = task_from_files(&server.client(), 3, 4.0).await;
    server.terminate().await;
    taught.copy_from(&work);

    let server = Process::start(PROGRAM, work.path(), &["--robot", "none"]).await;
    let client = server.client();
    let model = train(&client, &task, json!({ "seed": SEED })).await;
    let path = format!("/models/{}/file", model["id"].as_str().unwrap_or_default());
    let file = client.get(&path).await.expect_bytes(200);
    server.terminate().await;
    trained.copy_from(&work);
    Prepared {
        taught,
        trained,
        task,
        model,
        file,
    }
}

/// A copy of the trained data.
pub async fn copy(label: &str) -> Folder {
    let folder = Folder::new(SCRATCH, label);
    folder.copy_from(&prepared().await.trained);
    folder
}

/// A server on a copy of the trained data, and the model in it.
pub async fn with_model(label: &str, more: &[&str]) -> (Folder, Process, Value) {
    let folder = copy(label).await;
    let server = Process::start(PROGRAM, folder.path(), more).await;
    (folder, server, prepared().await.model.clone())
}
