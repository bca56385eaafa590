//! Every route as a client sees it, without sockets and without an arm.

mod access;
mod agreement;
mod assets;
mod demonstrations;
mod faults;
mod join;
mod learning;
mod live;
mod people;
mod pictures;
mod positions;
mod robot;
mod tasks;
mod trims;

use std::net::SocketAddr;
use std::sync::Arc;

use ::robot::{Robot, RobotConfig, RobotKind};
use axum::Router;
use axum::body::{Body, to_bytes};
use axum::extract::connect_info::MockConnectInfo;
use axum::http::{HeaderMap, Request, StatusCode, header};
use motion::limits::RobotLimits;
use serde_json::Value;
use tower::ServiceExt;

use super::{AppState, router::router};
use crate::arms::StartedRobot;
use crate::clock::{FixedClock, WallTime};
use crate::pairing::{Gatekeeper, PairingCode};
use crate::store::Store;
use crate::test_support::TestFolder;

const NOW: WallTime = WallTime(1_700_000_000_000);

/// A server without sockets.
struct Api {
    router: Router,
    state: AppState,
    clock: Arc<FixedClock>,
    _folder: TestFolder,
}

/// What came back.
#[derive(Debug)]
struct Answer {
    status: StatusCode,
    headers: HeaderMap,
    text: String,
    /// How long the body is.
    bytes: usize,
}

impl Answer {
    fn json(&self) -> Value {
        serde_json::from_str(&self.text).unwrap_or_else(|e| panic!("{e} in {:?}", self.text))
    }

    fn header(&self, name: &str) -> &str {
        self.headers[name].to_str().unwrap()
    }

    /// Asserts a problem document with this status and code, and returns it.
    #[track_caller]
    fn problem(&self, status: u16, code: &str) -> Value {
        assert_eq!(self.status, status, "{}", self.text);
        assert_eq!(self.header("content-type"), "application/problem+json");
        let problem = self.json();
        assert_eq!(problem["code"], code, "{problem}");
        assert_eq!(problem["status"], status);
        assert_eq!(problem["type"], format!("urn:team:problem:{code}"));
        assert!(problem["title"].is_string());
        let detail = problem["detail"].as_str().unwrap();
        assert!(!detail.is_empty());
        problem
    }

    /// Asserts the status, and returns the body.
    #[track_caller]
    fn ok(&self, status: u16) -> Value {
        assert_eq!(self.status, status, "{}", self.text);
        self.json()
    }
}

impl Api {
    /// A server that only this computer can reach.
    async fn local() -> Self {
        Self::with(None).await
    }

    /// A server on the network.
    async fn networked() -> Self {
        let code = PairingCode::random().unwrap();
        Self::with(Some(Arc::new(Gatekeeper::new(code)))).await
    }

    async fn with(gatekeeper: Option<Arc<Gatekeeper>>) -> Self {
        let folder = TestFolder::new();
        let store = Store::open(&folder.path().join("team.sqlite"))
            .await
            .unwrap();
        let egm = SocketAddr::from(([127, 0, 0, 1], 0));
        let robot = Robot::start(RobotConfig::new(RobotKind::None, egm))
            .await
            .unwrap();
        let clock = FixedClock::at(NOW);
        let none = StartedRobot {
            id: "none".to_owned(),
            name: "No robot".to_owned(),
            limits: RobotLimits::gofa5(),
            continuous_run: true,
            robot,
        };
        let state = AppState::new(store, clock.clone(), vec![none], gatekeeper);
        let client = SocketAddr::from(([192, 0, 2, 7], 50_000));
        Self {
            router: router(state.clone()).layer(MockConnectInfo(client)),
            state,
            clock,
            _folder: folder,
        }
    }

    /// The server is found here from now on.
    fn found_at(&mut self, address: &str) {
        self.state.found_at = Some(address.parse().unwrap());
        let client = SocketAddr::from(([192, 0, 2, 7], 50_000));
        self.router = router(self.state.clone()).layer(MockConnectInfo(client));
    }

    /// Sends a request as it is.
    async fn send(&self, request: Request<Body>) -> Answer {
        let response = self.router.clone().oneshot(request).await.unwrap();
        let (parts, body) = response.into_parts();
        let bytes = to_bytes(body, usize::MAX).await.unwrap();
        Answer {
            status: parts.status,
            headers: parts.headers,
            text: String::from_utf8_lossy(&bytes).into_owned(),
            bytes: bytes.len(),
        }
    }

    async fn get(&self, path: &str) -> Answer {
        self.send(request("GET", path, Body::empty())).await
    }

    async fn post(&self, path: &str, body: Value) -> Answer {
        self.json("POST", path, body).await
    }

    async fn json(&self, method: &str, path: &str, body: Value) -> Answer {
        let mut request = request(method, path, Body::from(body.to_string()));
        let json = "application/json".parse().unwrap();
        request.headers_mut().insert(header::CONTENT_TYPE, json);
        self.send(request).await
    }

    async fn upload(&self, task: &str, name: &str, text: impl Into<Body>) -> Answer {
        let path = format!("/api/v1/tasks/{task}/demonstrations/upload?name={name}");
        self.send(request("POST", &path, text.into())).await
    }

    /// A fresh task's identifier.
    async fn task(&self) -> String {
        let made = self
            .post("/api/v1/tasks", serde_json::json!({"name": "Drill"}))
            .await;
        made.ok(201)["id"].as_str().unwrap().to_owned()
    }

    /// A kept demonstration's identifier.
    async fn kept(&self, task: &str, text: String) -> String {
        let uploaded = self.upload(task, "take.csv", text).await.ok(201);
        let id = uploaded["id"].as_str().unwrap().to_owned();
        let kept = self
            .post(&format!("/api/v1/demonstrations/{id}/keep"), Value::Null)
            .await;
        kept.ok(200);
        id
    }
}

/// A request from this computer's browser.
fn request(method: &str, path: &str, body: Body) -> Request<Body> {
    Request::builder()
        .method(method)
        .uri(path)
        .header(header::HOST, "localhost")
        .body(body)
        .unwrap()
}

/// A recording of a quiet swing of all joints: `seconds` long, at 50 samples a second.
fn swing(seconds: f64, pace: f64) -> String {
    let mut text = "t_s,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n".to_owned();
    for row in 0..=(seconds * 50.0) as u32 {
        let t_s = f64::from(row) * 0.02;
        let share = (t_s / seconds).powf(pace);
        let turn = 0.5 - 0.5 * (std::f64::consts::PI * share).cos();
        let joints = [10.0, 20.0, -15.0, 12.0, -18.0, 25.0].map(|span| span * turn);
        let [a, b, c, d, e, f] = joints;
        text += &format!("{t_s},{a},{},{},{d},{},{f}\n", b + 5.0, c + 20.0, e - 30.0);
    }
    text
}
