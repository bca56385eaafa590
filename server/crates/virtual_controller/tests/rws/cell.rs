//! A controller on its sockets, and a client of its Robot Web Services.

use std::net::{Ipv4Addr, UdpSocket};
use std::time::{Duration, Instant};

use reqwest::header::{ACCEPT, CONTENT_TYPE};
use reqwest::{Client, Response, StatusCode};
use serde_json::Value;
use virtual_controller::{Config, VirtualController};

pub const JSON: &str = "application/hal+json;v=2.0";
pub const XHTML: &str = "application/xhtml+xml;v=2.0";
pub const FORM: &str = "application/x-www-form-urlencoded;v=2.0";
pub const UNIT: &str = "/rw/motionsystem/mechunits/ROB_1";
/// Longer than anything in these tests takes.
pub const PATIENCE: Duration = Duration::from_secs(20);

/// A controller, and a client with one session.
pub struct Cell {
    pub controller: VirtualController,
    pub client: Client,
    /// Where the controller sends EGM; nobody answers.
    _egm: UdpSocket,
}

impl Cell {
    pub async fn start() -> Self {
        // Without one, a client of reqwest cannot be built.
        rustls::crypto::ring::default_provider()
            .install_default()
            .ok();
        let egm = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let config = Config::new(egm.local_addr().unwrap());
        Self {
            controller: VirtualController::start(config).await.unwrap(),
            client: Client::builder()
                .cookie_store(true)
                .no_proxy()
                .build()
                .unwrap(),
            _egm: egm,
        }
    }

    pub fn url(&self, path: &str) -> String {
        format!("http://{}{path}", self.controller.rws_addr())
    }

    pub async fn get(&self, path: &str) -> Response {
        self.client
            .get(self.url(path))
            .header(ACCEPT, JSON)
            .basic_auth("Default User", Some("robotics"))
            .send()
            .await
            .unwrap()
    }

    pub async fn post(&self, path: &str, body: &str) -> Response {
        self.client
            .post(self.url(path))
            .header(ACCEPT, JSON)
            .header(CONTENT_TYPE, FORM)
            .basic_auth("Default User", Some("robotics"))
            .body(body.to_owned())
            .send()
            .await
            .unwrap()
    }

    /// Posts what the controller must accept.
    pub async fn act(&self, path: &str, body: &str) {
        let response = self.post(path, body).await;
        assert_eq!(response.status(), StatusCode::NO_CONTENT, "{path} {body}");
    }

    /// The first entry of a resource or list.
    pub async fn read(&self, path: &str) -> Value {
        let response = self.get(path).await;
        assert_eq!(response.status(), StatusCode::OK, "{path}");
        assert_eq!(response.headers()[CONTENT_TYPE], JSON);
        let body: Value = response.json().await.unwrap();
        body.pointer("/state/0")
            .or_else(|| body.pointer("/_embedded/resources/0"))
            .unwrap_or_else(|| panic!("{path}: {body}"))
            .clone()
    }

    /// Reads until a field has the value.
    pub async fn wait_for(&self, path: &str, field: &str, value: &str) {
        let deadline = Instant::now() + PATIENCE;
        while self.read(path).await[field] != value {
            assert!(
                Instant::now() < deadline,
                "{path}: {field} does not become {value}"
            );
        }
    }

    pub async fn make_soft(&self) {
        self.act("/rw/panel/ctrl-state", "ctrl-state=motoron").await;
        self.act(&format!("{UNIT}/lead-through"), "status=active")
            .await;
        self.wait_for(&format!("{UNIT}/lead-through"), "status", "Active")
            .await;
    }
}

/// The code of a refusal.
pub async fn code_of(response: Response) -> i64 {
    let body: Value = response.json().await.unwrap();
    body["status"]["code"].as_i64().unwrap()
}
