//! Who is let through: loopback names and same origin for this computer, the cookie for others.

use std::convert::Infallible;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};

use axum::extract::{ConnectInfo, FromRequestParts, Request, State};
use axum::http::request::Parts;
use axum::http::{Extensions, HeaderMap, StatusCode, header};
use axum::middleware::Next;
use axum::response::Response;

use super::entrance::Scheme;
use super::error::ApiError;
use super::state::AppState;
use crate::pairing::Token;

/// The name of the cookie. Each scheme has its own: what somebody read along on plain HTTP opens
/// nothing on HTTPS, and a browser keeps the `__Host-` one for this very host.
pub const fn cookie_name(scheme: Scheme) -> &'static str {
    match scheme {
        Scheme::Http => "team_session",
        Scheme::Https => "__Host-team_session",
    }
}

/// How long a phone stays paired.
pub const PAIRED_FOR_MS: i64 = 30 * 24 * 3_600 * 1_000;

/// Routes that a phone needs before it is paired.
const OPEN: [&str; 2] = ["/api/v1/health", "/api/v1/session"];

/// Who sent a request, as the audit trail names it.
#[derive(Clone, Debug)]
pub struct Actor(pub String);

/// The address that a request came from.
#[derive(Clone, Copy, Debug)]
pub struct Client(pub IpAddr);

/// Refuses what may not come in, before anything else sees it.
///
/// # Errors
/// 403 for a foreign page or host name, 401 for a client that is not paired.
pub async fn guard(
    State(state): State<AppState>,
    mut request: Request,
    next: Next,
) -> Result<Response, ApiError> {
    let headers = request.headers();
    let scheme = scheme(request.extensions());
    let host = host(headers)?;
    if state.gatekeeper.is_none() && !is_loopback(host) {
        return Err(ApiError::new(
            StatusCode::FORBIDDEN,
            "host_refused",
            "This server answers only under the name of this computer.",
        )
        .advise("Open the address that the server printed when it started."));
    }
    if !is_same_origin(headers, scheme, host) {
        return Err(ApiError::new(
            StatusCode::FORBIDDEN,
            "origin_refused",
            "This request came from another web page.",
        )
        .advise("Use the server's own pages."));
    }
    let actor = match (&state.gatekeeper, cookie(headers, scheme)) {
        (None, _) => "this computer".to_owned(),
        (Some(_), token) => {
            let paired = is_paired(&state, token.as_ref()).await?;
            if !paired && !is_open(request.uri().path()) {
                return Err(not_paired());
            }
            match token {
                Some(token) if paired => format!("paired {:02x?}", &token.sha256()[..4]),
                _ => "unpaired".to_owned(),
            }
        }
    };
    request.extensions_mut().insert(Actor(actor));
    Ok(next.run(request).await)
}

/// The cookie's token, if the client sent one.
pub fn cookie(headers: &HeaderMap, scheme: Scheme) -> Option<Token> {
    headers
        .get_all(header::COOKIE)
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|value| value.split(';'))
        .filter_map(|pair| pair.trim().split_once('='))
        .find(|(name, _)| *name == cookie_name(scheme))
        .map(|(_, token)| Token::received(token))
}

/// Whether the client is paired.
pub async fn is_paired(state: &AppState, token: Option<&Token>) -> Result<bool, ApiError> {
    let Some(token) = token else { return Ok(false) };
    Ok(state
        .store
        .is_paired(&token.sha256(), state.clock.now())
        .await?)
}

fn not_paired() -> ApiError {
    ApiError::new(
        StatusCode::UNAUTHORIZED,
        "not_paired",
        "This device does not know the pairing code yet.",
    )
    .advise("Scan the code that the server shows, or type its eight digits.")
}

/// The pages themselves hold nothing secret, and a phone needs them to ask for the code.
fn is_open(path: &str) -> bool {
    !path.starts_with("/api/") || OPEN.contains(&path)
}

pub(super) fn host(headers: &HeaderMap) -> Result<&str, ApiError> {
    let host = headers
        .get(header::HOST)
        .and_then(|host| host.to_str().ok());
    host.ok_or_else(|| {
        ApiError::new(
            StatusCode::BAD_REQUEST,
            "host_missing",
            "The request names no host.",
        )
    })
}

/// A page on another site may have its name resolve to this computer; it can't choose the name
/// that the browser sends along.
pub(super) fn is_loopback(host: &str) -> bool {
    let name = match host.strip_prefix('[') {
        Some(rest) => rest.split(']').next().unwrap_or_default(),
        None => host.split(':').next().unwrap_or_default(),
    };
    name.eq_ignore_ascii_case("localhost")
        || name.parse::<Ipv4Addr>().is_ok_and(|ip| ip.is_loopback())
        || name.parse::<Ipv6Addr>().is_ok_and(|ip| ip.is_loopback())
}

/// How the request came in; without an entrance there is plain HTTP only.
fn scheme(extensions: &Extensions) -> Scheme {
    extensions.get().copied().unwrap_or_default()
}

fn is_same_origin(headers: &HeaderMap, scheme: Scheme, host: &str) -> bool {
    let prefix = match scheme {
        Scheme::Http => "http://",
        Scheme::Https => "https://",
    };
    match headers.get(header::ORIGIN).map(|origin| origin.to_str()) {
        None => true,
        Some(Err(_)) => false,
        Some(Ok(origin)) => origin
            .strip_prefix(prefix)
            .is_some_and(|origin| origin.eq_ignore_ascii_case(host)),
    }
}

impl<S: Sync> FromRequestParts<S> for Scheme {
    type Rejection = Infallible;

    async fn from_request_parts(parts: &mut Parts, _state: &S) -> Result<Self, Infallible> {
        Ok(scheme(&parts.extensions))
    }
}

impl<S: Sync> FromRequestParts<S> for Actor {
    type Rejection = ApiError;

    async fn from_request_parts(parts: &mut Parts, _state: &S) -> Result<Self, ApiError> {
        parts
            .extensions
            .get()
            .cloned()
            .ok_or_else(|| ApiError::internal(&"a route is not behind the guard"))
    }
}

impl<S: Send + Sync> FromRequestParts<S> for Client {
    type Rejection = ApiError;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, ApiError> {
        let address = ConnectInfo::<SocketAddr>::from_request_parts(parts, state).await;
        let ConnectInfo(address) = address.map_err(|error| ApiError::internal(&error))?;
        Ok(Self(address.ip()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_loopback_names_are_this_computer() {
        for host in [
            "localhost",
            "LOCALHOST:80",
            "127.0.0.1:8080",
            "127.1.2.3",
            "[::1]:9",
        ] {
            assert!(is_loopback(host), "{host}");
        }
        for host in [
            "evil.example",
            "localhost.evil.example",
            "192.0.2.1",
            "[::2]:9",
            "",
            "[",
        ] {
            assert!(!is_loopback(host), "{host}");
        }
    }

    #[test]
    fn only_the_servers_own_pages_are_the_same_origin() {
        let check = |origin: &str| {
            let mut headers = HeaderMap::new();
            headers.insert(header::ORIGIN, origin.parse().unwrap());
            let same = |scheme| is_same_origin(&headers, scheme, "127.0.0.1:8080");
            (same(Scheme::Http), same(Scheme::Https))
        };
        assert_eq!(check("http://127.0.0.1:8080"), (true, false));
        assert_eq!(check("https://127.0.0.1:8080"), (false, true));
        for origin in [
            "null",
            "http://evil.example",
            "https://evil.example",
            "http://127.0.0.1",
            "https://127.0.0.1",
        ] {
            assert_eq!(check(origin), (false, false), "{origin}");
        }
        let none = HeaderMap::new();
        assert!(is_same_origin(&none, Scheme::Http, "127.0.0.1:8080"));
    }

    #[test]
    fn the_cookie_is_found_among_others() {
        let mut headers = HeaderMap::new();
        headers.insert(
            header::COOKIE,
            "a=b; team_session=cafe; __Host-team_session=beef; c=d"
                .parse()
                .unwrap(),
        );
        for (scheme, token) in [(Scheme::Http, "cafe"), (Scheme::Https, "beef")] {
            assert_eq!(cookie(&headers, scheme).unwrap().as_str(), token);
            assert!(cookie(&HeaderMap::new(), scheme).is_none());
        }
    }
}
