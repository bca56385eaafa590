//! A controller on its sockets, and an EGM server for it.

use std::net::{Ipv4Addr, SocketAddr, UdpSocket};
use std::time::{Duration, Instant};

use egm::{
    Correction, MAX_CORRECTION_BYTES, MAX_DATAGRAM_BYTES, RobotFeedback, SequenceNumber,
    encode_correction, read_feedback,
};
use motion::{JointAngles, JointVelocities};
use reqwest::Client;
use reqwest::header::{ACCEPT, CONTENT_TYPE};
use serde_json::Value;
use virtual_controller::{Config, VirtualController};

/// Longer than anything in these tests takes.
const PATIENCE: Duration = Duration::from_secs(20);

pub struct Cell {
    pub controller: VirtualController,
    client: Client,
}

impl Cell {
    pub async fn start(egm_remote: SocketAddr) -> Self {
        // Without one, a client of reqwest cannot be built.
        rustls::crypto::ring::default_provider()
            .install_default()
            .ok();
        Self {
            controller: VirtualController::start(Config::new(egm_remote))
                .await
                .unwrap(),
            client: Client::builder()
                .cookie_store(true)
                .no_proxy()
                .build()
                .unwrap(),
        }
    }

    pub async fn act(&self, path: &str, body: &str) {
        let response = self
            .client
            .post(format!("http://{}{path}", self.controller.rws_addr()))
            .basic_auth("Default User", Some("robotics"))
            .header(CONTENT_TYPE, "application/x-www-form-urlencoded;v=2.0")
            .body(body.to_owned())
            .send()
            .await
            .unwrap();
        assert_eq!(response.status(), reqwest::StatusCode::NO_CONTENT);
    }

    pub async fn run_program(&self) {
        self.act("/rw/panel/ctrl-state", "ctrl-state=motoron").await;
        self.act("/rw/rapid/execution/start", "cycle=once").await;
    }

    /// Waits until an event is in the log.
    pub async fn wait_for_event(&self, code: u32) {
        let url = format!(
            "http://{}/rw/elog/{}",
            self.controller.rws_addr(),
            code / 10_000
        );
        let name = code.to_string();
        let deadline = Instant::now() + PATIENCE;
        loop {
            let answer = self
                .client
                .get(&url)
                .basic_auth("Default User", Some("robotics"))
                .header(ACCEPT, "application/hal+json;v=2.0")
                .send()
                .await
                .unwrap();
            let body: Value = answer.json().await.unwrap();
            let events = body["_embedded"]["resources"].as_array().unwrap();
            if events
                .iter()
                .any(|event| event["code"].as_str() == Some(&name))
            {
                return;
            }
            assert!(Instant::now() < deadline, "no event {code}");
        }
    }
}

/// The server's side of the socket.
pub struct Server {
    pub socket: UdpSocket,
    sent: SequenceNumber,
}

impl Server {
    pub fn bind() -> Self {
        let socket = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        socket.set_read_timeout(Some(PATIENCE)).unwrap();
        Self {
            socket,
            sent: SequenceNumber(0),
        }
    }

    pub fn receive(&self) -> (RobotFeedback, SocketAddr) {
        let mut buffer = [0; MAX_DATAGRAM_BYTES];
        let (length, from) = self.socket.recv_from(&mut buffer).unwrap();
        (read_feedback(&buffer[..length]).unwrap(), from)
    }

    pub fn answer(&mut self, feedback: &RobotFeedback, joints: JointAngles, to: SocketAddr) {
        let correction = Correction {
            sequence: self.sent,
            sent_at: feedback.sent_at.unwrap(),
            joints,
            velocities: JointVelocities::ZERO,
        };
        self.sent = self.sent.next();
        let mut buffer = [0; MAX_CORRECTION_BYTES];
        let length = encode_correction(&correction, &mut buffer).unwrap();
        self.socket.send_to(&buffer[..length], to).unwrap();
    }
}
