//! What was promised of the method's published recordings. They are not part of the repository: the
//! tests read them from the folder in `TEAM_PAPER_DATA` and say so when there is none.

use std::path::{Path, PathBuf};

use e2e::{Folder, LONG, Process, eventually, run_to_end};
use serde_json::{Value, json};

use crate::cli::{off, path, rows, stdout};
use crate::steps::{new_task, number, text};
use crate::{PROGRAM, SCRATCH};

/// Most memory that the server may have in use while it trains.
const RESIDENT_KB: u64 = 150_000;

/// The folder of a recorded task, if the recordings are there.
fn recordings(task: &str) -> Option<PathBuf> {
    let Ok(data) = std::env::var("TEAM_PAPER_DATA") else {
        println!("skipped: TEAM_PAPER_DATA is not set (see README.md)");
        return None;
    };
    Some(Path::new(&data).join("paper").join(task))
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_published_recording_trains_within_the_published_error() {
    let Some(recordings) = recordings("T4_brush_homing") else {
        return;
    };
    let folder = Folder::new(SCRATCH, "cli-published");
    let model = folder.path().join("model.json");
    let arguments = [
        "train",
        path(&recordings),
        "--method",
        "paper",
        "--json",
        "--model",
        path(&model),
    ];
    let trained = run_to_end(PROGRAM, &arguments).await;
    assert!(
        trained.status.success(),
        "{}",
        String::from_utf8_lossy(&trained.stderr)
    );
    let report: Value = serde_json::from_str(&stdout(&trained)).expect("one JSON object");
    assert!(number(&report, "gmcc") >= 0.99, "{report}");
    assert!(number(&report, "e_j_deg") <= 0.30, "{report}");
    let shown = rows(&stdout(
        &run_to_end(PROGRAM, &["reproduce", path(&model), "--csv"]).await,
    ));
    for noise_deg in ["1", "5", "10", "20"] {
        let noise = ["--noise-deg", noise_deg, "--seed", "9", "--csv"];
        let arguments = [&["reproduce", path(&model)][..], &noise].concat();
        let noisy = run_to_end(PROGRAM, &arguments).await;
        assert!(
            noisy.status.success(),
            "{}",
            String::from_utf8_lossy(&noisy.stderr)
        );
        let noisy = rows(&stdout(&noisy));
        assert!(off(&noisy[0], &shown[0][1..]) > 0.1, "the start is another");
        let goal = &shown[shown.len() - 1][1..];
        assert!(
            off(&noisy[noisy.len() - 1], goal) <= 0.30,
            "noise of {noise_deg} degrees"
        );
    }
}

/// The most memory the process has had in use, as Linux counts it.
fn peak_resident_kb(process: u32) -> u64 {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).expect("it runs");
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))
        .expect("its memory");
    line.trim()
        .trim_end_matches("kB")
        .trim()
        .parse()
        .expect("a number of kB")
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_server_stays_small_and_answers_while_it_trains_published_recordings() {
    let Some(recordings) = recordings("T1_opening") else {
        return;
    };
    let folder = Folder::new(SCRATCH, "published");
    let server = Process::start(PROGRAM, folder.path(), &["--robot", "none"]).await;
    let client = server.client();
    let task = new_task(&client, "opening").await;
    let files = std::fs::read_dir(&recordings).expect("the recordings can be listed");
    let mut takes = 0;
    for file in files {
        let file = file.expect("the recordings can be listed").path();
        if file
            .extension()
            .is_some_and(|extension| extension == "json")
        {
            let content = std::fs::read_to_string(&file).expect("a recording can be read");
            let upload = format!("/tasks/{task}/demonstrations/upload?name=take-{takes}.json");
            let stored = client
                .post_text(&upload, "application/json", content)
                .await
                .expect(201);
            let keep = format!("/demonstrations/{}/keep", text(&stored, "id"));
            let _ = client.post_empty(&keep).await.expect(200);
            takes += 1;
        }
    }
    assert_eq!(takes, 6, "the recordings of T1");
    let accepted = client
        .post(&format!("/tasks/{task}/models"), json!({}))
        .await
        .expect(202);
    let job_path = format!("/jobs/{}", text(&accepted["job"], "id"));
    // Every question on the way has to be answered, whatever the trainer does.
    let job = eventually("the training has ended", LONG, || async {
        let _ = client.get("/tasks").await.expect(200);
        let job = client.get(&job_path).await.expect(200);
        (!["queued", "running"].contains(&text(&job, "state"))).then_some(job)
    })
    .await;
    assert_eq!(job["state"], "succeeded", "{job}");
    let resident_kb = peak_resident_kb(server.id());
    println!("at most {resident_kb} kB resident, job {job}");
    assert!(resident_kb < RESIDENT_KB, "{resident_kb} kB");
    server.terminate().await;
}
