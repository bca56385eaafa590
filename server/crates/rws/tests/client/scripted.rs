//! A controller that answers what a test tells it to, and remembers what it was asked.

use axum::Router;
use axum::body::Bytes;
use axum::extract::{Request, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use std::collections::{HashMap, VecDeque};
use std::sync::{Arc, Mutex};

/// One request as it came.
#[derive(Debug, Clone)]
pub struct Asked {
    pub line: String,
    pub body: String,
    pub accept: String,
    pub content_type: String,
    pub authorized: bool,
    pub cookie: String,
}

#[derive(Default)]
struct Script {
    /// Answers for a request line; the last one stays.
    answers: HashMap<String, VecDeque<(u16, String)>>,
    asked: Vec<Asked>,
    sessions: u32,
    valid_session: Option<String>,
}

#[derive(Clone)]
pub struct Scripted {
    script: Arc<Mutex<Script>>,
    pub url: String,
}

impl Scripted {
    pub async fn start() -> Self {
        let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
        let url = format!("http://{}", listener.local_addr().unwrap());
        let script = Arc::new(Mutex::new(Script::default()));
        let app = Router::new()
            .fallback(answer)
            .with_state(Arc::clone(&script));
        tokio::spawn(async move { axum::serve(listener, app).await });
        Self { script, url }
    }

    pub fn client(&self) -> rws::Client {
        rws::Client::new(rws::Config::new(&self.url)).unwrap()
    }

    /// Answers `line` ("GET /path") with `status` and `body`, after what was scripted before.
    pub fn answers(&self, line: &str, status: u16, body: &str) -> &Self {
        let mut script = self.script.lock().unwrap();
        let answers = script.answers.entry(line.to_owned()).or_default();
        answers.push_back((status, body.to_owned()));
        drop(script);
        self
    }

    /// Answers `line` with one resource that holds one field.
    pub fn reports(&self, line: &str, field: &str, value: &str) -> &Self {
        let body = format!(r#"{{"state":[{{"_type":"x","{field}":"{value}"}}]}}"#);
        self.answers(line, 200, &body)
    }

    /// Forgets the session, as after five idle minutes.
    pub fn expire_session(&self) {
        self.script.lock().unwrap().valid_session = None;
    }

    pub fn asked(&self) -> Vec<Asked> {
        self.script.lock().unwrap().asked.clone()
    }

    pub fn lines(&self) -> Vec<String> {
        self.asked().into_iter().map(|asked| asked.line).collect()
    }

    pub fn sessions(&self) -> u32 {
        self.script.lock().unwrap().sessions
    }
}

async fn answer(State(script): State<Arc<Mutex<Script>>>, request: Request) -> Response {
    let (parts, body) = request.into_parts();
    let body: Bytes = axum::body::to_bytes(body, 1 << 16).await.unwrap();
    let text = |name: header::HeaderName| {
        let value = parts.headers.get(name);
        value.map_or(String::new(), |value| value.to_str().unwrap().to_owned())
    };
    let asked = Asked {
        line: format!("{} {}", parts.method, parts.uri),
        body: String::from_utf8(body.to_vec()).unwrap(),
        accept: text(header::ACCEPT),
        content_type: text(header::CONTENT_TYPE),
        // "Default User:robotics"
        authorized: text(header::AUTHORIZATION) == "Basic RGVmYXVsdCBVc2VyOnJvYm90aWNz",
        cookie: text(header::COOKIE),
    };
    let mut script = script.lock().unwrap();
    script.asked.push(asked.clone());
    let known = script
        .valid_session
        .as_ref()
        .is_some_and(|session| asked.cookie.contains(session.as_str()));
    if !known && !asked.authorized {
        return StatusCode::UNAUTHORIZED.into_response();
    }
    let answers = script.answers.get_mut(&asked.line);
    let (status, body) = match answers {
        Some(answers) if answers.len() > 1 => answers.pop_front().unwrap(),
        Some(answers) => answers[0].clone(),
        None => (404, String::new()),
    };
    let mut response = (StatusCode::from_u16(status).unwrap(), body).into_response();
    if !known {
        script.sessions += 1;
        let session = format!("-http-session-={}", script.sessions);
        let cookie = format!("{session}; path=/; httponly");
        script.valid_session = Some(session);
        let cookie = cookie.parse().unwrap();
        response.headers_mut().append(header::SET_COOKIE, cookie);
    }
    response
}
