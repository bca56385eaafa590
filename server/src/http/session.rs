//! Pairing: whether this client may, and the exchange of the code for a cookie.

use axum::extract::State;
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::auth::{Client, PAIRED_FOR_MS, cookie, cookie_name, is_paired};
use super::entrance::Scheme;
use super::error::{ApiError, Problem};
use super::extract::Json;
use super::state::AppState;
use crate::pairing::{Token, Verdict};

/// What a page needs to know before anything else.
#[derive(Debug, Serialize, ToSchema)]
pub struct Session {
    /// Whether this client may use the server.
    paired: bool,
    /// Whether the server asks for the code at all.
    pairing_required: bool,
    /// Whether the server answers over HTTPS too, at the same address.
    https: bool,
    /// The server's version.
    version: &'static str,
}

/// The code that a person typed or scanned.
#[derive(Debug, Deserialize, ToSchema)]
pub struct Pairing {
    /// Eight digits; spaces are no matter.
    code: String,
}

/// Whether this client is paired.
#[utoipa::path(get, path = "/session", tag = "session", responses((status = 200, body = Session)))]
pub async fn show(
    State(state): State<AppState>,
    scheme: Scheme,
    headers: HeaderMap,
) -> Result<Json<Session>, ApiError> {
    let pairing_required = state.gatekeeper.is_some();
    let paired = !pairing_required || is_paired(&state, cookie(&headers, scheme).as_ref()).await?;
    Ok(Json(Session {
        paired,
        pairing_required,
        https: state.certificates.is_some(),
        version: env!("CARGO_PKG_VERSION"),
    }))
}

/// Pairs this client.
#[utoipa::path(post, path = "/session", tag = "session", request_body = Pairing, responses(
    (status = 204, description = "Paired; the cookie is set"),
    (status = 401, description = "Wrong code", body = Problem, content_type = "application/problem+json"),
    (status = 429, description = "Too many wrong codes", body = Problem, content_type = "application/problem+json"),
))]
pub async fn pair(
    State(state): State<AppState>,
    Client(address): Client,
    scheme: Scheme,
    Json(pairing): Json<Pairing>,
) -> Result<Response, ApiError> {
    let Some(gatekeeper) = &state.gatekeeper else {
        return Ok(StatusCode::NO_CONTENT.into_response());
    };
    let now = state.clock.now();
    match gatekeeper.judge(address, &pairing.code, now) {
        Verdict::Right => {}
        Verdict::Wrong => {
            state.audit("unpaired", "wrong pairing code", address).await;
            return Err(ApiError::new(
                StatusCode::UNAUTHORIZED,
                "wrong_code",
                "This is not the pairing code.",
            )
            .advise("Look at the server's screen; the code changes with every start."));
        }
        Verdict::TooMany { wait_s } => {
            return Err(ApiError::new(
                StatusCode::TOO_MANY_REQUESTS,
                "too_many_attempts",
                format!("Too many wrong codes. Wait {wait_s} seconds."),
            )
            .retry_after(wait_s));
        }
    }
    let token = Token::random().map_err(|error| ApiError::internal(&error))?;
    let expires = now.plus_ms(PAIRED_FOR_MS);
    let hash = token.sha256();
    state
        .store
        .add_pairing(&hash, &address.to_string(), now, expires)
        .await?;
    state.audit("unpaired", "paired", address).await;
    let secure = match scheme {
        Scheme::Http => "",
        Scheme::Https => "; Secure",
    };
    let text = format!(
        "{}={}; Path=/; Max-Age={}; HttpOnly; SameSite=Strict{secure}",
        cookie_name(scheme),
        token.as_str(),
        PAIRED_FOR_MS / 1_000
    );
    let value = HeaderValue::from_str(&text).map_err(|error| ApiError::internal(&error))?;
    Ok((StatusCode::NO_CONTENT, [(header::SET_COOKIE, value)]).into_response())
}
