//! What happens around every request: authentication, session cookies, and the form of refusals.

use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use super::negotiation::Format;
use super::reply::Problem;
use super::sessions::SessionId;
use super::{App, accounts};

const SESSION_COOKIE: &str = "-http-session-";
const CONNECTION_COOKIE: &str = "ABBCX";

/// Lets a request through when its session or its account is known.
pub async fn guard(State(app): State<App>, mut request: Request, next: Next) -> Response {
    let format = Format::of(request.headers()).unwrap_or(Format::Xhtml);
    if app.controller().faults().rws_unavailable {
        return Problem::unavailable("the service is not available").render(format);
    }
    let (session, opened) = match identify(&app, request.headers()) {
        Ok(identified) => identified,
        Err(problem) => {
            let mut response = problem.render(format);
            let challenge = HeaderValue::from_static("Basic realm=\"validusers@robapi.abb\"");
            if response.status() == StatusCode::UNAUTHORIZED {
                response
                    .headers_mut()
                    .insert(header::WWW_AUTHENTICATE, challenge);
            }
            return response;
        }
    };
    request.extensions_mut().insert(session.clone());
    let mut response = next.run(request).await;
    let status = response.status();
    if status.is_client_error() || status.is_server_error() {
        let problem = response
            .extensions_mut()
            .remove::<Problem>()
            .unwrap_or_else(|| Problem::of_status(status));
        let allow = response.headers_mut().remove(header::ALLOW);
        response = problem.render(format).into_response();
        if let Some(allow) = allow {
            response.headers_mut().insert(header::ALLOW, allow);
        }
    }
    if opened {
        let id = &session.0;
        for cookie in [
            format!("{SESSION_COOKIE}={id}; path=/; httponly"),
            format!("{CONNECTION_COOKIE}={}; path=/; httponly", &id[..8]),
        ] {
            if let Ok(cookie) = HeaderValue::from_str(&cookie) {
                response.headers_mut().append(header::SET_COOKIE, cookie);
            }
        }
    }
    response
}

/// The session of a request, and whether it was opened for it.
fn identify(app: &App, headers: &HeaderMap) -> Result<(SessionId, bool), Problem> {
    let mut sessions = app.sessions();
    if let Some(id) = session_cookie(headers)
        && sessions.resume(id)
    {
        return Ok((SessionId(id.to_owned()), false));
    }
    let known = headers
        .get(header::AUTHORIZATION)
        .and_then(|value| value.to_str().ok())
        .is_some_and(accounts::is_known);
    if !known {
        return Err(Problem::of_status(StatusCode::UNAUTHORIZED));
    }
    let session = sessions
        .open()
        .ok_or_else(|| Problem::unavailable("too many sessions"))?;
    Ok((session, true))
}

fn session_cookie(headers: &HeaderMap) -> Option<&str> {
    headers
        .get_all(header::COOKIE)
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|value| value.split(';'))
        .filter_map(|pair| pair.trim().split_once('='))
        .find_map(|(name, value)| (name == SESSION_COOKIE).then_some(value))
}
