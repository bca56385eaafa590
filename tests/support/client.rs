//! A small HTTP client for the REST interface.

use reqwest::header::{CONTENT_TYPE, HeaderMap, HeaderName, HeaderValue};
use reqwest::{ClientBuilder, Method, StatusCode};
use serde_json::Value;

/// Speaks to one server.
#[derive(Clone)]
pub struct Client {
    base: String,
    http: reqwest::Client,
    headers: HeaderMap,
}

impl Client {
    /// `base` is the address the server printed, such as `http://127.0.0.1:4711/`.
    ///
    /// # Panics
    /// When the system refuses to make an HTTP client.
    #[must_use]
    pub fn new(base: &str) -> Self {
        Self::with(base, |client| client)
    }

    /// A client that trusts the authority with this certificate (DER) and no other.
    ///
    /// # Panics
    /// When it is no certificate.
    #[must_use]
    pub fn trusting(base: &str, authority: &[u8]) -> Self {
        let authority = reqwest::Certificate::from_der(authority).expect("a certificate");
        Self::with(base, |client| client.tls_certs_only([authority]))
    }

    fn with(base: &str, trust: impl FnOnce(ClientBuilder) -> ClientBuilder) -> Self {
        // The robot's client brings TLS into reqwest, which cannot be built without a provider then.
        rustls::crypto::ring::default_provider()
            .install_default()
            .ok();
        let http = trust(reqwest::Client::builder())
            .no_proxy()
            .redirect(reqwest::redirect::Policy::none())
            .timeout(super::SHORT)
            .build()
            .expect("an HTTP client can be made");
        Self {
            base: base.trim_end_matches('/').to_owned(),
            http,
            headers: HeaderMap::new(),
        }
    }

    /// The address without the final slash.
    #[must_use]
    pub fn base(&self) -> &str {
        &self.base
    }

    /// The same client with one more header on every request.
    ///
    /// # Panics
    /// When the text is no valid header.
    #[must_use]
    pub fn with_header(&self, name: &'static str, value: &str) -> Self {
        let mut client = self.clone();
        let value = HeaderValue::from_str(value).expect("a valid header");
        client.headers.insert(HeaderName::from_static(name), value);
        client
    }

    pub async fn get(&self, path: &str) -> Reply {
        self.send(Method::GET, path, None).await
    }

    pub async fn post(&self, path: &str, body: Value) -> Reply {
        self.send(
            Method::POST,
            path,
            Some(("application/json", body.to_string())),
        )
        .await
    }

    pub async fn post_empty(&self, path: &str) -> Reply {
        self.send(Method::POST, path, None).await
    }

    pub async fn post_text(&self, path: &str, content_type: &str, body: String) -> Reply {
        self.send(Method::POST, path, Some((content_type, body)))
            .await
    }

    /// `path` is below `/api/v1` unless it begins with `//`, which stands for the root.
    ///
    /// # Panics
    /// When no answer comes.
    pub async fn send(&self, method: Method, path: &str, body: Option<(&str, String)>) -> Reply {
        let url = match path.strip_prefix("//") {
            Some(rest) => format!("{}/{rest}", self.base),
            None => format!("{}/api/v1{path}", self.base),
        };
        let what = format!("{method} {url}");
        let mut request = self.http.request(method, url).headers(self.headers.clone());
        if let Some((content_type, text)) = body {
            request = request.header(CONTENT_TYPE, content_type).body(text);
        }
        let answer = request
            .send()
            .await
            .unwrap_or_else(|error| panic!("{what}: {error:?}"));
        let (status, headers) = (answer.status(), answer.headers().clone());
        let bytes = answer
            .bytes()
            .await
            .unwrap_or_else(|error| panic!("{what}: {error:?}"));
        Reply {
            what,
            status,
            headers,
            bytes: bytes.to_vec(),
        }
    }

    /// Whether anything answers at the address.
    pub async fn answers(&self) -> bool {
        self.http
            .get(format!("{}/api/v1/health", self.base))
            .send()
            .await
            .is_ok()
    }
}

/// What came back.
pub struct Reply {
    pub what: String,
    pub status: StatusCode,
    pub headers: HeaderMap,
    pub bytes: Vec<u8>,
}

impl Reply {
    /// The JSON of an answer that must have this status.
    ///
    /// # Panics
    /// When the status is another or the body is not JSON.
    #[must_use]
    pub fn expect(self, status: u16) -> Value {
        let what = self.what.clone();
        let bytes = self.expect_bytes(status);
        serde_json::from_slice(&bytes).unwrap_or_else(|error| panic!("{what}: {error}"))
    }

    /// The bytes of an answer that must have this status.
    ///
    /// # Panics
    /// When the status is another.
    #[must_use]
    pub fn expect_bytes(self, status: u16) -> Vec<u8> {
        assert_eq!(
            self.status.as_u16(),
            status,
            "{}: {}",
            self.what,
            self.text()
        );
        self.bytes
    }

    /// The body as text.
    #[must_use]
    pub fn text(&self) -> String {
        String::from_utf8_lossy(&self.bytes).into_owned()
    }

    /// A header's text, empty when it is not there.
    #[must_use]
    pub fn header(&self, name: &str) -> &str {
        self.headers
            .get(name)
            .and_then(|value| value.to_str().ok())
            .unwrap_or_default()
    }

    /// The problem document of an answer that must be an error with one of these statuses:
    /// complete, and in words.
    ///
    /// # Panics
    /// When it is something else.
    #[must_use]
    pub fn problem(self, statuses: &[u16]) -> Value {
        let status = self.status.as_u16();
        assert!(
            statuses.contains(&status),
            "{}: {status} instead of {statuses:?}: {}",
            self.what,
            self.text()
        );
        let (what, kind) = (self.what.clone(), self.header("content-type").to_owned());
        assert!(
            kind.starts_with("application/problem+json"),
            "{what}: content type {kind:?}"
        );
        let problem: Value = self.expect(status);
        for member in ["type", "title", "code", "detail"] {
            let text = problem[member].as_str().unwrap_or_default();
            assert!(
                !text.trim().is_empty(),
                "{what}: no {member:?} in {problem}"
            );
        }
        assert_eq!(problem["status"], status, "{what}: {problem}");
        problem
    }
}
