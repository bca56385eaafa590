//! The store against a real file, with times that the test chooses.

mod demonstrations;
mod flights;
mod jobs;
mod others;
mod people;
mod positions;

use super::demonstrations::{DemonstrationSource, DemonstrationState, NewDemonstration};
use super::jobs::{Job, NewTraining};
use super::models::{Model, TrainedModel};
use super::samples::Sample;
use super::{MIGRATIONS, Store};
use crate::clock::WallTime;
use crate::ids::{DemonstrationId, TaskId};
use crate::test_support::TestFolder;

pub(super) const NOW: WallTime = WallTime(1_700_000_000_000);

pub(super) async fn store() -> (Store, TestFolder) {
    let folder = TestFolder::new();
    let store = Store::open(&folder.path().join("team.sqlite"))
        .await
        .unwrap();
    (store, folder)
}

pub(super) async fn task(store: &Store) -> TaskId {
    let id = TaskId::new();
    store.create_task(id, "Drill", NOW).await.unwrap();
    id
}

pub(super) fn new_demonstration(task_id: TaskId) -> NewDemonstration<'static> {
    NewDemonstration {
        id: DemonstrationId::new(),
        task_id,
        state: DemonstrationState::Recording,
        source: DemonstrationSource::HandGuiding,
        robot: Some("left"),
    }
}

/// `count` samples, 10 ms apart, the first at `first_us`.
pub(super) fn samples(first_us: u64, count: u64) -> Vec<Sample> {
    (0..count)
        .map(|i| Sample {
            at_us: first_us + 10_000 * i,
            joints_deg: std::array::from_fn(|j| j as f64 + (i as f64) * 0.1),
            tcp_mm: None,
        })
        .collect()
}

pub(super) async fn training(store: &Store, task_id: TaskId, key: &str) -> (Job, Model, bool) {
    let new = NewTraining {
        task_id,
        sources: &[],
        method: "paper",
        seed: u64::MAX,
        unique_key: key,
        max_attempts: 2,
    };
    store.create_training(new, NOW).await.unwrap()
}

pub(super) fn trained() -> TrainedModel {
    TrainedModel {
        summary: "Learnt.".into(),
        report: serde_json::json!({"k": 4}),
        start_deg: vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0],
        goal_deg: vec![6.0, 7.0, 8.0, 9.0, 10.0, 11.0],
        duration_s: 12.5,
        body: b"{}".to_vec(),
        sha256: "00".into(),
    }
}

#[tokio::test]
async fn the_list_of_migrations_is_the_folder() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../migrations");
    let mut files: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".sql"))
        .collect();
    files.sort();
    assert_eq!(files.len(), MIGRATIONS.len());
    for (file, (version, description, sql)) in files.iter().zip(MIGRATIONS) {
        let name = format!("{version:04}_{}.sql", description.replace(' ', "_"));
        assert_eq!(*file, name);
        let text = std::fs::read_to_string(format!("{folder}/{file}")).unwrap();
        assert_eq!(text, sql);
    }
}

#[tokio::test]
async fn a_database_is_opened_again_with_everything_in_it() {
    let (store, folder) = store().await;
    let id = task(&store).await;
    store.close().await;
    let store = Store::open(&folder.path().join("team.sqlite"))
        .await
        .unwrap();
    assert_eq!(store.task(id).await.unwrap().name, "Drill");
}

#[tokio::test]
async fn commits_are_durable_and_references_are_enforced() {
    let (store, _folder) = store().await;
    let synchronous: i64 = sqlx::query_scalar("PRAGMA synchronous")
        .fetch_one(&store.writer)
        .await
        .unwrap();
    assert_eq!(synchronous, 2, "2 is FULL");
    let mode: String = sqlx::query_scalar("PRAGMA journal_mode")
        .fetch_one(&store.writer)
        .await
        .unwrap();
    assert_eq!(mode, "wal");
    let orphan = new_demonstration(TaskId::new());
    assert!(store.create_demonstration(orphan, NOW).await.is_err());
}
