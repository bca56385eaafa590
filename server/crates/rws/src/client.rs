//! The session: authentication, headers, back-off, and the mapping of statuses to errors.

use crate::hal;
use crate::tls::Tls;
use crate::{RwsError, session::SessionCookies};
use reqwest::cookie::CookieStore;
use reqwest::header::{ACCEPT, CONTENT_TYPE, HeaderValue, LOCATION};
use reqwest::{Method, StatusCode, Url};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Semaphore;

const ACCEPT_HAL: &str = "application/hal+json;v=2.0";
// What every resource has, also where an older controller has no JSON.
const ACCEPT_XHTML: &str = "application/xhtml+xml;v=2.0";
// Without ";v=2.0" the controller answers 406, also to an empty body.
const FORM: &str = "application/x-www-form-urlencoded;v=2.0";
// The controller allows so many connections per session, beside one WebSocket.
const CONNECTIONS: usize = 2;
const BACK_OFF: [Duration; 3] = [
    Duration::from_millis(100),
    Duration::from_millis(250),
    Duration::from_millis(600),
];

/// Where the controller is and how to log in.
#[derive(Debug, Clone)]
pub struct Config {
    /// For example `https://192.168.125.1`.
    pub base_url: String,
    /// Controller account.
    pub user: String,
    /// Its password.
    pub password: String,
    /// SHA-256 fingerprint of the one certificate that is accepted, whatever its name and dates;
    /// hexadecimal, colons allowed. Without it https is verified as a browser does, which a
    /// controller's own certificate does not pass.
    pub certificate_sha256: Option<String>,
    /// Longest wait for one answer.
    pub timeout: Duration,
}

impl Config {
    /// The factory account at `base_url`, no pinned certificate, two seconds per answer.
    pub fn new(base_url: impl Into<String>) -> Self {
        Self {
            base_url: base_url.into(),
            user: "Default User".to_owned(),
            password: "robotics".to_owned(),
            certificate_sha256: None,
            timeout: Duration::from_secs(2),
        }
    }
}

/// What the controller said to a request that it accepted.
#[derive(Debug)]
pub(crate) struct Answer {
    /// Where the new resource is, if one was made.
    pub(crate) location: Option<String>,
    /// The body.
    pub(crate) text: String,
}

/// One session with one controller. Cloning shares the session.
#[derive(Debug, Clone)]
pub struct Client {
    http: reqwest::Client,
    cookies: Arc<SessionCookies>,
    base: Url,
    tls: Tls,
    connections: Arc<Semaphore>,
    config: Arc<Config>,
}

impl Client {
    /// Prepares a session; nothing is sent yet.
    ///
    /// # Errors
    /// [`RwsError::BadAddress`] when the address is not an HTTP address, or is one without TLS
    /// although a certificate is pinned; [`RwsError::BadFingerprint`] when the pin is none.
    pub fn new(config: Config) -> Result<Self, RwsError> {
        let bad = |reason: String| RwsError::BadAddress {
            url: config.base_url.clone(),
            reason,
        };
        let base = Url::parse(&config.base_url).map_err(|error| bad(error.to_string()))?;
        if base.host().is_none() || !matches!(base.scheme(), "http" | "https") {
            return Err(bad("it must look like https://host:port".to_owned()));
        }
        let pinned = match &config.certificate_sha256 {
            Some(text) => Some(
                text.parse()
                    .map_err(|_| RwsError::BadFingerprint { text: text.clone() })?,
            ),
            None => None,
        };
        let https = base.scheme() == "https";
        // Somebody who pinned a certificate must never talk without one.
        if pinned.is_some() && !https {
            return Err(bad(
                "a certificate is pinned, so it must begin with https://".to_owned(),
            ));
        }
        let tls = Tls::new(pinned).map_err(|error| bad(error.to_string()))?;
        let cookies = Arc::new(SessionCookies::default());
        let http = reqwest::Client::builder()
            .tls_backend_preconfigured(rustls::ClientConfig::clone(&tls.config))
            .https_only(https)
            // A controller never sends anybody elsewhere.
            .redirect(reqwest::redirect::Policy::none())
            .cookie_provider(Arc::clone(&cookies))
            // Commands to the arm must never take a detour through a proxy of the office network.
            .no_proxy()
            .pool_max_idle_per_host(CONNECTIONS)
            .connect_timeout(config.timeout)
            .timeout(config.timeout)
            .build()
            .map_err(|error| bad(error.to_string()))?;
        Ok(Self {
            http,
            cookies,
            base,
            tls,
            connections: Arc::new(Semaphore::new(CONNECTIONS)),
            config: Arc::new(config),
        })
    }

    /// Ends the session; this also frees the mastership that it holds.
    ///
    /// # Errors
    /// As for every call; the session is forgotten here in any case.
    pub async fn logout(&self) -> Result<(), RwsError> {
        if !self.cookies.is_open(&self.base) {
            return Ok(());
        }
        let answer = self.get("/logout").await;
        self.cookies.clear();
        answer.map(|_| ())
    }

    pub(crate) async fn get(&self, path: &str) -> Result<String, RwsError> {
        Ok(self.send(Method::GET, path, None).await?.text)
    }

    pub(crate) async fn post(&self, path: &str, form: &[(&str, &str)]) -> Result<String, RwsError> {
        Ok(self.create(path, form).await?.text)
    }

    /// Posts what makes a new resource; the answer says where it is.
    pub(crate) async fn create(
        &self,
        path: &str,
        form: &[(&str, &str)],
    ) -> Result<Answer, RwsError> {
        self.send(Method::POST, path, Some(form)).await
    }

    pub(crate) async fn delete(&self, path: &str) -> Result<(), RwsError> {
        self.send(Method::DELETE, path, None).await.map(|_| ())
    }

    /// The cookies of the session, for a request that is not made here; nothing without one.
    pub(crate) fn session_cookies(&self) -> Option<HeaderValue> {
        self.cookies.cookies(&self.base)
    }

    /// Which session this is.
    pub(crate) fn session_id(&self) -> Option<String> {
        self.cookies.id(&self.base)
    }

    pub(crate) fn base(&self) -> &Url {
        &self.base
    }

    pub(crate) fn tls(&self) -> &Tls {
        &self.tls
    }

    pub(crate) fn timeout(&self) -> Duration {
        self.config.timeout
    }

    /// Sends one request, logging in again once when the session was lost, and waiting a little
    /// when the controller has no session to spare.
    async fn send(
        &self,
        method: Method,
        path: &str,
        form: Option<&[(&str, &str)]>,
    ) -> Result<Answer, RwsError> {
        let mut accept = ACCEPT_HAL;
        let mut logged_in_again = false;
        let mut back_off = BACK_OFF.into_iter();
        loop {
            let had_session = self.cookies.is_open(&self.base);
            let (status, answer) = self
                .send_once(method.clone(), path, form, accept, !had_session)
                .await
                .map_err(|error| self.unreachable(&error))?;
            match status {
                StatusCode::UNAUTHORIZED if !logged_in_again => {
                    self.cookies.clear();
                    logged_in_again = true;
                }
                StatusCode::NOT_ACCEPTABLE if accept == ACCEPT_HAL => accept = ACCEPT_XHTML,
                StatusCode::SERVICE_UNAVAILABLE => match back_off.next() {
                    Some(pause) => tokio::time::sleep(pause).await,
                    None => {
                        return Err(RwsError::Busy {
                            path: path.to_owned(),
                        });
                    }
                },
                status if status.is_success() => return Ok(answer),
                status => return Err(self.refused(path, status, &answer.text)),
            }
        }
    }

    async fn send_once(
        &self,
        method: Method,
        path: &str,
        form: Option<&[(&str, &str)]>,
        accept: &'static str,
        with_login: bool,
    ) -> Result<(StatusCode, Answer), reqwest::Error> {
        let url = format!("{}{path}", self.base.as_str().trim_end_matches('/'));
        let mut request = self.http.request(method, url).header(ACCEPT, accept);
        if with_login {
            request = request.basic_auth(&self.config.user, Some(&self.config.password));
        }
        if let Some(form) = form {
            request = request.header(CONTENT_TYPE, FORM).form(form);
        }
        // It is never closed, so there is always a permit to come.
        let _permit = self.connections.acquire().await.ok();
        let answer = request.send().await?;
        let status = answer.status();
        let location = answer
            .headers()
            .get(LOCATION)
            .and_then(|value| value.to_str().ok())
            .map(str::to_owned);
        let text = answer.text().await?;
        Ok((status, Answer { location, text }))
    }

    fn unreachable(&self, error: &reqwest::Error) -> RwsError {
        let reason = if error.is_timeout() {
            "no answer in time".to_owned()
        } else if error.is_connect() {
            if let Some(refusal) = self.tls.refusal(&self.config.base_url) {
                return refusal;
            }
            "no connection".to_owned()
        } else {
            error.to_string()
        };
        RwsError::Unreachable {
            url: self.config.base_url.clone(),
            reason,
        }
    }

    fn refused(&self, path: &str, status: StatusCode, text: &str) -> RwsError {
        let path = path.to_owned();
        let (code, message) = hal::refusal(text);
        match status {
            StatusCode::UNAUTHORIZED => RwsError::Unauthorized {
                user: self.config.user.clone(),
            },
            StatusCode::NOT_FOUND | StatusCode::GONE => RwsError::Missing { path },
            StatusCode::FORBIDDEN | StatusCode::CONFLICT | StatusCode::BAD_REQUEST => {
                RwsError::Refused {
                    path,
                    status: status.as_u16(),
                    code,
                    message,
                }
            }
            other => RwsError::Unexpected {
                path,
                status: other.as_u16(),
                message,
            },
        }
    }
}
