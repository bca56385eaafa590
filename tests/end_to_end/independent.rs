//! Programs of others at both ends of the EGM line: they are in `tests/independent`, and need a
//! Python with the package that they are made of, named by `TEAM_EGM_PYTHON`.

use std::path::Path;

use e2e::run_to_end;

use crate::PROGRAM;

/// Runs one of the scripts and returns what it printed, or says that it is skipped.
async fn run(script: &str) -> Option<String> {
    let Ok(python) = std::env::var("TEAM_EGM_PYTHON") else {
        println!("skipped: TEAM_EGM_PYTHON is not set (see tests/independent/README.md)");
        return None;
    };
    let script = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("independent")
        .join(script);
    let script = script.to_str().expect("the path is text");
    let output = run_to_end(&python, &["-B", script, PROGRAM]).await;
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    println!("{printed}");
    assert!(
        output.status.success(),
        "{printed}\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
    Some(printed)
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn another_egm_server_drives_the_virtual_robot_with_the_lag_of_the_control_law() {
    if let Some(printed) = run("drive_virtual_robot.py").await {
        assert!(printed.contains("with the speed the lag is below 20 ms"));
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn another_robot_is_answered_once_per_message_with_the_pose_that_is_held() {
    if let Some(printed) = run("answer_other_robots.py").await {
        assert!(printed.contains("every message was answered once"));
    }
}
