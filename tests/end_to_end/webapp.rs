//! The web app's own checks, and its pages in a headless browser against the real server.

use std::path::{Path, PathBuf};
use std::time::Duration;

use e2e::{Folder, Process};
use tokio::process::Command;
use tokio::time::timeout;

use crate::steps::{alone, idle_arm, on_the_network, pairing_code};
use crate::{PROGRAM, SCRATCH};

/// Enough for a whole round on the pages, with takes and trainings, on a busy machine.
const LIMIT: Duration = Duration::from_secs(1_800);

fn folder(below: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(below)
}

/// Whether the server was built without its pages, for work without Node.
fn without_pages() -> bool {
    let without = std::env::var("WEBAPP_SKIP").is_ok_and(|value| value == "1");
    if without {
        println!("skipped: WEBAPP_SKIP=1 builds the server without its pages");
    }
    without
}

/// Runs npm in a folder; its output is shown when it fails.
async fn npm(folder: &Path, arguments: &[&str], environment: &[(&str, &str)]) {
    let mut command = Command::new("npm");
    command
        .args(arguments)
        .current_dir(folder)
        .envs(environment.iter().copied());
    command.kill_on_drop(true);
    let output = timeout(LIMIT, command.output()).await;
    let output = output
        .expect("npm ends")
        .expect("npm can be run; Node is needed (README.md)");
    assert!(
        output.status.success(),
        "npm {arguments:?} in {}:\n{}\n{}",
        folder.display(),
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
}

/// Installs the packages of the lock file when they are missing or of an older one.
async fn install(folder: &Path) {
    let modified = |name: &str| {
        folder
            .join(name)
            .metadata()
            .and_then(|file| file.modified())
            .ok()
    };
    let installed = modified("node_modules/.package-lock.json");
    if installed.is_none() || installed < modified("package-lock.json") {
        npm(
            folder,
            &["ci", "--no-audit", "--no-fund", "--prefer-offline"],
            &[],
        )
        .await;
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_web_app_is_typed_formatted_and_passes_its_own_tests() {
    if without_pages() {
        return;
    }
    let webapp = folder("../webapp");
    install(&webapp).await;
    npm(&webapp, &["run", "check"], &[]).await;
    npm(&webapp, &["test"], &[]).await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_pages_do_the_main_job_on_a_phone() {
    if without_pages() {
        return;
    }
    let browser = folder("browser");
    install(&browser).await;
    let _turn = alone().await;
    let data = Folder::new(SCRATCH, "browser");
    let server = Process::start(PROGRAM, data.path(), &[]).await;
    let cell_data = Folder::new(SCRATCH, "browser-cell");
    let cell = two_arms(&cell_data).await;
    let network_data = Folder::new(SCRATCH, "browser-pairing");
    let network = on_the_network(&network_data).await;
    let https_data = Folder::new(SCRATCH, "browser-https");
    let more = ["--robot", "none", "--https"];
    let https = Process::start_on(PROGRAM, "0.0.0.0:0", https_data.path(), &more).await;
    idle_arm(&server.client()).await;
    let (arm, phones, arms) = (server.client(), network.client(), cell.client());
    let code = pairing_code(&network).await;
    // What the app costs a phone, for whoever reads the output of all tests.
    let costs = Path::new(SCRATCH).join("budgets.txt");
    std::fs::write(&costs, "").expect("the scratch folder can be written");
    let (secured, secured_code) = (https.client(), pairing_code(&https).await);
    let environment = [
        ("BASE_URL", arm.base()),
        ("PAIRING_URL", phones.base()),
        ("PAIRING_CODE", &code),
        ("CELL_URL", arms.base()),
        ("BUDGETS", costs.to_str().expect("a plain path")),
        ("HTTPS_URL", secured.base()),
        ("HTTPS_CODE", &secured_code),
    ];
    npm(&browser, &["run", "browser"], &environment).await;
    server.terminate().await;
    cell.terminate().await;
    network.terminate().await;
    https.terminate().await;
}

/// A server with the two virtual arms that the specs know.
async fn two_arms(data: &Folder) -> Process {
    let robots = [("left", "Left arm"), ("right", "Right arm")]
        .map(|(id, name)| {
            format!("[[robot]]\nid = \"{id}\"\nname = \"{name}\"\nkind = \"virtual\"\n")
        })
        .concat();
    let file = data.path().join("cell.toml");
    std::fs::write(&file, robots).expect("the configuration file can be written");
    let file = file.to_str().expect("a plain path");
    Process::start(PROGRAM, data.path(), &["--config", file]).await
}
