//! `team doctor` as a process, against a controller with HTTPS.

use std::net::UdpSocket;

use e2e::{Folder, run_to_end};
use serde_json::Value;
use virtual_controller::{Config, VirtualController};

use crate::cli::{path, stdout};
use crate::{PROGRAM, SCRATCH};

#[tokio::test]
async fn it_ends_well_with_the_right_password_and_badly_with_a_wrong_one() {
    let egm = UdpSocket::bind("127.0.0.1:0").expect("a free port");
    let mut config = Config::new(egm.local_addr().expect("an address"));
    config.rws_https = true;
    let controller = VirtualController::start(config)
        .await
        .expect("a controller");
    let url = controller.rws_url();
    let certificate = controller
        .certificate_sha256()
        .expect("a certificate")
        .to_owned();
    let folder = Folder::new(SCRATCH, "doctor");
    let right = folder.write("right", "robotics\n");
    let wrong = folder.write("wrong", "robotik\n");
    let arguments = |password| {
        [
            "doctor",
            "--rws",
            &url,
            "--certificate",
            &certificate,
            "--password-file",
            password,
            "--json",
        ]
        .map(str::to_owned)
    };

    let well = run_to_end(
        PROGRAM,
        &arguments(path(&right)).each_ref().map(String::as_str),
    )
    .await;
    let report: Value = serde_json::from_str(&stdout(&well)).expect("JSON");
    assert!(
        well.status.success() && report["healthy"] == true,
        "{report:#}"
    );

    let ill = run_to_end(
        PROGRAM,
        &arguments(path(&wrong)).each_ref().map(String::as_str),
    )
    .await;
    let report: Value = serde_json::from_str(&stdout(&ill)).expect("JSON");
    assert_eq!(ill.status.code(), Some(1), "{report:#}");
    assert_eq!(report["healthy"], false);
    let said = String::from_utf8_lossy(&ill.stderr);
    assert!(said.contains("1 of 16 checks failed"), "{said}");
    assert!(
        !format!("{report}{said}").contains("robotik"),
        "the password is shown"
    );
    controller.stop().await;
}
