//! What is seen from outside: the folder's lock, the live socket, and the terminal.

use std::time::Duration;

use futures_util::{SinkExt, StreamExt};
use robot::RobotState;
use serde_json::{Value, json};
use tokio::net::TcpStream;
use tokio::time::timeout;
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::{MaybeTlsStream, WebSocketStream, connect_async};

use super::super::StartError;
use super::{App, arm, by_hand, config, robot_is, with_arm};
use crate::announcement;
use crate::config::{Config, RobotChoice};
use crate::test_support::TestFolder;

pub(super) type Socket = WebSocketStream<MaybeTlsStream<TcpStream>>;

pub(super) async fn next(socket: &mut Socket, kind: &str) -> Value {
    let wait = async {
        loop {
            if let Some(Ok(Message::Text(text))) = socket.next().await {
                let message: Value = serde_json::from_str(&text).unwrap();
                if message["type"] == kind {
                    return message;
                }
            }
        }
    };
    timeout(Duration::from_secs(20), wait).await.unwrap()
}

#[tokio::test(flavor = "multi_thread")]
async fn two_servers_can_not_share_a_folder() {
    let folder = TestFolder::new();
    let first = App::start(config(folder.path(), RobotChoice::None))
        .await
        .unwrap();
    assert!(first.url().starts_with("http://127.0.0.1:"));
    assert_eq!((first.pairing_code(), first.pairing_url()), (None, None));
    let second = App::start(config(folder.path(), RobotChoice::None)).await;
    assert!(matches!(second.err(), Some(StartError::FolderInUse { .. })));
    first.shutdown().await;
    let third = App::start(config(folder.path(), RobotChoice::None))
        .await
        .unwrap();
    third.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn the_live_socket_shows_everything_and_stops_the_arm() {
    let folder = TestFolder::new();
    let (app, task) = with_arm(folder.path()).await;
    let url = format!("{}api/v1/live", app.url().replace("http", "ws"));
    let (mut socket, _) = connect_async(&url).await.unwrap();
    let snapshot = next(&mut socket, "snapshot").await;
    assert_eq!(snapshot["robot"]["kind"], "virtual");
    assert_eq!(
        (&snapshot["demonstration"], &snapshot["jobs"]),
        (&Value::Null, &json!([]))
    );
    let (begun, _) = arm(&app).recorder.start(by_hand(task)).await.unwrap();
    let told = next(&mut socket, "demonstration").await;
    assert_eq!(told["demonstration"]["id"], begun.id.to_string());
    next(&mut socket, "robot").await;
    let (mut second, _) = connect_async(&url).await.unwrap();
    let snapshot = next(&mut second, "snapshot").await;
    assert_eq!(snapshot["demonstration"]["id"], begun.id.to_string());
    for nonsense in ["hello", "{\"type\": \"jump\"}", "{\"type\": \"stop\"}"] {
        second.send(Message::text(nonsense)).await.unwrap();
    }
    robot_is(&app, RobotState::Idle).await;
    app.shutdown().await;
    let ends = async { while let Some(Ok(_)) = socket.next().await {} };
    timeout(Duration::from_secs(20), ends).await.unwrap();
}

#[tokio::test(flavor = "multi_thread")]
async fn on_the_network_the_terminal_shows_code_and_address() {
    let folder = TestFolder::new();
    let listen = ([0, 0, 0, 0], 0).into();
    let app = App::start(Config {
        listen,
        ..config(folder.path(), RobotChoice::None)
    })
    .await
    .unwrap();
    let code = app.pairing_code().unwrap().to_owned();
    let text = announcement(&app);
    assert!(text.starts_with(&format!("TEAM is ready: {}\n", app.url())));
    assert!(text.contains(&format!("Pairing code: {} {}", &code[..4], &code[4..])));
    assert!(
        app.pairing_url()
            .unwrap()
            .ends_with(&format!("/#pair={code}"))
    );
    app.shutdown().await;
}
