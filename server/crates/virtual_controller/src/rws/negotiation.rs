//! What a request must say about itself: which form it accepts, which form its body has.

use axum::Form;
use axum::extract::{FromRequest, FromRequestParts, Request};
use axum::http::request::Parts;
use axum::http::{HeaderMap, StatusCode, header};

use super::reply::Problem;

/// The form of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// `application/hal+json;v=2.0`
    Json,
    /// `application/xhtml+xml;v=2.0`
    Xhtml,
}

impl Format {
    /// The form a request accepts; without a wish it is XHTML.
    pub fn of(headers: &HeaderMap) -> Option<Self> {
        let Some(accept) = headers.get(header::ACCEPT) else {
            return Some(Self::Xhtml);
        };
        accept.to_str().ok()?.split(',').find_map(|kind| {
            match kind.replace(' ', "").to_ascii_lowercase().as_str() {
                "application/hal+json;v=2.0" => Some(Self::Json),
                "application/xhtml+xml;v=2.0" | "*/*" => Some(Self::Xhtml),
                _ => None,
            }
        })
    }

    /// The value of `Content-Type`.
    pub fn content_type(self) -> &'static str {
        match self {
            Self::Json => "application/hal+json;v=2.0",
            Self::Xhtml => "application/xhtml+xml;v=2.0",
        }
    }
}

impl<S: Sync> FromRequestParts<S> for Format {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Problem> {
        Self::of(&parts.headers).ok_or_else(|| Problem::of_status(StatusCode::NOT_ACCEPTABLE))
    }
}

/// The fields of a form, in the order they came.
pub struct Fields(Vec<(String, String)>);

impl Fields {
    /// The value of a field.
    pub fn get(&self, name: &str) -> Option<&str> {
        self.all(name).next()
    }

    /// All values of a field.
    pub fn all(&self, name: &str) -> impl Iterator<Item = &str> {
        self.0
            .iter()
            .filter(move |(key, _)| key == name)
            .map(|(_, value)| value.as_str())
    }

    /// The value of a field that must be there.
    pub fn require(&self, name: &str) -> Result<&str, Problem> {
        self.get(name)
            .ok_or_else(|| Problem::bad_request(format!("the field {name} is missing")))
    }

    /// Reads a body, whatever its type says.
    pub async fn read<S: Send + Sync>(request: Request, state: &S) -> Result<Self, Problem> {
        match Form::<Vec<(String, String)>>::from_request(request, state).await {
            Ok(Form(fields)) => Ok(Self(fields)),
            Err(rejection) => Err(Problem::bad_request(rejection.to_string())),
        }
    }
}

/// A body is accepted only with the type that says version 2.0, even when it is empty.
impl<S: Send + Sync> FromRequest<S> for Fields {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &S) -> Result<Self, Problem> {
        let content_type = request
            .headers()
            .get(header::CONTENT_TYPE)
            .and_then(|value| value.to_str().ok())
            .unwrap_or_default()
            .replace(' ', "")
            .to_ascii_lowercase();
        let mut parts = content_type.split(';');
        match parts.next() {
            Some("application/x-www-form-urlencoded") if parts.any(|part| part == "v=2.0") => {
                Self::read(request, state).await
            }
            Some("application/x-www-form-urlencoded" | "") => {
                Err(Problem::of_status(StatusCode::NOT_ACCEPTABLE))
            }
            _ => Err(Problem::of_status(StatusCode::UNSUPPORTED_MEDIA_TYPE)),
        }
    }
}
