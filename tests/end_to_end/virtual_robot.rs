//! The virtual robot as a program of its own, with faults from a file.

use std::net::SocketAddr;
use std::process::Stdio;

use e2e::{Client, Folder, SHORT};
use tokio::io::{AsyncBufReadExt, BufReader};
use tokio::net::UdpSocket;
use tokio::process::{Child, Command};
use tokio::time::timeout;

use crate::{PROGRAM, SCRATCH};

const READY: &str = "The virtual robot is ready: ";

/// Starts the robot and returns it with the port of its web services.
async fn start(arguments: &[&str]) -> (Child, u16) {
    let mut child = Command::new(PROGRAM)
        .arg("virtual-robot")
        .args(arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .kill_on_drop(true)
        .spawn()
        .expect("the robot starts");
    let output = child.stdout.take().expect("its output is piped");
    let mut lines = BufReader::new(output).lines();
    let ready = timeout(SHORT, lines.next_line())
        .await
        .expect("the robot becomes ready")
        .expect("its output is text")
        .expect("it says something");
    let address = ready.strip_prefix(READY).expect("it is ready");
    let (url, _) = address.split_once("/ ").expect("address and more");
    let port = url.rsplit(':').next().expect("a port");
    // Whoever prints to a closed pipe ends: go on reading.
    tokio::spawn(async move { while let Ok(Some(_)) = lines.next_line().await {} });
    (child, port.parse().expect("a number"))
}

/// The number of a message and where it came from; the first numbers take one byte.
async fn next_message(server: &UdpSocket) -> (u8, SocketAddr) {
    let mut datagram = [0; 1500];
    let received = timeout(SHORT, server.recv_from(&mut datagram)).await;
    let (length, source) = received.expect("a message comes").expect("it is received");
    assert!(length > 300, "{length} bytes");
    assert_eq!((datagram[0], datagram[2]), (0x0a, 0x08), "header, number");
    (datagram[3], source)
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_robot_runs_by_itself_and_suffers_what_its_script_says() {
    let folder = Folder::new(SCRATCH, "virtual-robot");
    let faults = folder.path().join("faults.json");
    let script = r#"{"faults": [{"fault": "counter_reset", "from_s": 0.1}]}"#;
    std::fs::write(&faults, script).expect("the script can be written");
    let server = UdpSocket::bind("127.0.0.1:0").await.expect("a free port");
    let egm = server.local_addr().expect("an address").to_string();
    let (mut robot, rws) = start(&[
        "--egm",
        &egm,
        "--rws",
        "0.0.0.0:0",
        "--run",
        "--faults",
        faults.to_str().expect("the path is text"),
    ])
    .await;

    let (number, first) = next_message(&server).await;
    assert_eq!(number, 0);
    let mut expected = 1;
    let second = loop {
        let (number, source) = next_message(&server).await;
        if source != first {
            assert_eq!(number, 0, "another port begins another count");
            break source;
        }
        assert_eq!(number, expected);
        expected += 1;
    };
    assert_eq!(next_message(&server).await, (1, second));

    let account = "Basic RGVmYXVsdCBVc2VyOnJvYm90aWNz";
    let _ = Client::new(&format!("http://127.0.0.1:{rws}"))
        .with_header("authorization", account)
        .with_header("accept", "application/hal+json;v=2.0")
        .get("//rw/system")
        .await
        .expect(200);
    robot.kill().await.expect("the robot can be ended");
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_script_with_a_mistake_stops_the_robot_before_it_starts() {
    let folder = Folder::new(SCRATCH, "virtual-robot-mistake");
    let faults = folder.path().join("faults.json");
    std::fs::write(&faults, r#"{"faults": [{"fault": "los"}]}"#).expect("it can be written");
    let faults = faults.to_str().expect("the path is text");
    let ended = e2e::run_to_end(PROGRAM, &["virtual-robot", "--faults", faults]).await;
    let said = String::from_utf8_lossy(&ended.stderr).into_owned();
    assert!(!ended.status.success());
    assert!(
        said.contains("faults.json") && said.contains("los"),
        "{said}"
    );
}
