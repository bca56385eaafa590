//! Serves the embedded phone app, packed as the build left it when the browser can unpack it.

use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, Uri, header};
use axum::response::{IntoResponse, Response};
use sha2::{Digest, Sha256};
use webapp::Asset;

use super::error::ApiError;
use super::headers::unknown_method;

/// The file under this path; a path of the app's own is the page itself.
pub async fn serve(method: Method, uri: Uri, headers: HeaderMap) -> Result<Response, ApiError> {
    let path = uri.path();
    if path.starts_with("/api/") || path == "/api" {
        return Err(ApiError::not_found("address"));
    }
    if !matches!(method, Method::GET | Method::HEAD) {
        return Err(unknown_method().await);
    }
    let asset = webapp::asset(path)
        .or_else(|| webapp::asset("/"))
        .ok_or_else(|| ApiError::not_found("page"))?;
    let encoding = Encoding::choose(&asset, &headers);
    let etag = etag(&asset, encoding);
    let mut response = if has(&headers, &etag) {
        StatusCode::NOT_MODIFIED.into_response()
    } else {
        let body = match encoding {
            Encoding::Brotli => asset.brotli.map(IntoResponse::into_response),
            Encoding::Gzip => asset.gzip.map(IntoResponse::into_response),
            Encoding::Plain => None,
        };
        let mut response = body.unwrap_or_else(|| asset.bytes.into_response());
        let answer = response.headers_mut();
        answer.insert(header::CONTENT_TYPE, HeaderValue::from_static(asset.mime));
        if let Some(name) = encoding.name() {
            answer.insert(header::CONTENT_ENCODING, HeaderValue::from_static(name));
        }
        response
    };
    let cache = if asset.immutable {
        "public, max-age=31536000, immutable"
    } else {
        "no-cache"
    };
    let answer = response.headers_mut();
    answer.insert(header::CACHE_CONTROL, HeaderValue::from_static(cache));
    answer.insert(header::VARY, HeaderValue::from_static("Accept-Encoding"));
    if let Ok(etag) = HeaderValue::from_str(&etag) {
        answer.insert(header::ETAG, etag);
    }
    Ok(response)
}

/// How the bytes of an answer are packed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Encoding {
    Brotli,
    Gzip,
    Plain,
}

impl Encoding {
    fn name(self) -> Option<&'static str> {
        match self {
            Self::Brotli => Some("br"),
            Self::Gzip => Some("gzip"),
            Self::Plain => None,
        }
    }

    /// The smallest that there is and that the browser takes.
    fn choose(asset: &Asset, headers: &HeaderMap) -> Self {
        let there = [
            (asset.brotli.is_some(), Self::Brotli),
            (asset.gzip.is_some(), Self::Gzip),
        ];
        there
            .into_iter()
            .find(|(there, encoding)| *there && encoding.name().is_some_and(|n| takes(headers, n)))
            .map_or(Self::Plain, |(_, encoding)| encoding)
    }
}

/// Whether the browser takes this encoding: named, or else by the star, and not with a weight of 0.
fn takes(headers: &HeaderMap, encoding: &str) -> bool {
    let weight = |wanted: &str| {
        list(headers, header::ACCEPT_ENCODING).find_map(|entry| {
            let mut parts = entry.split(';').map(str::trim);
            if !parts.next()?.eq_ignore_ascii_case(wanted) {
                return None;
            }
            let weight = parts.find_map(|part| part.strip_prefix("q="));
            Some(weight.map_or(1.0, |text| text.parse::<f32>().unwrap_or(0.0)))
        })
    };
    weight(encoding).or_else(|| weight("*")).unwrap_or(0.0) > 0.0
}

/// Whether the browser has the bytes that this tag stands for.
fn has(headers: &HeaderMap, etag: &str) -> bool {
    list(headers, header::IF_NONE_MATCH)
        .any(|known| known == "*" || known.trim_start_matches("W/") == etag)
}

/// The entries of a header that is a list.
fn list(headers: &HeaderMap, name: header::HeaderName) -> impl Iterator<Item = &str> {
    headers
        .get_all(name)
        .into_iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|value| value.split(','))
        .map(str::trim)
}

/// Of the content and how it is packed: a tag stands for bytes.
fn etag(asset: &Asset, encoding: Encoding) -> String {
    let hash: String = Sha256::digest(&asset.bytes)
        .iter()
        .take(12)
        .map(|byte| format!("{byte:02x}"))
        .collect();
    match encoding.name() {
        Some(name) => format!("\"{hash}-{name}\""),
        None => format!("\"{hash}\""),
    }
}
