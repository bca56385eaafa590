//! How another phone comes in: the address and the code for it, as text and as a picture, and the
//! certificate that phones install for HTTPS.

use axum::extract::State;
use axum::http::{HeaderMap, header};
use axum::response::{IntoResponse, Response};
use qrcode::QrCode;
use qrcode::render::svg;
use serde::Serialize;
use utoipa::ToSchema;

use super::auth::{host, is_loopback};
use super::error::{ApiError, Problem};
use super::extract::Json;
use super::headers::RESOURCE_POLICY;
use super::state::AppState;

/// Where phones get the certificate of this cell's authority. The name is the file's on the phone.
pub const CERTIFICATE: &str = "/team-cell.crt";
/// With this type phones offer to install it.
const CERTIFICATE_TYPE: &str = "application/x-x509-ca-cert";

/// Pixels of each square of the picture; it is scaled on the screen.
const SQUARE: u32 = 8;

/// What another phone needs to come in.
#[derive(Debug, Serialize, ToSchema)]
pub struct Joining {
    /// The address to open; nothing when only this computer can reach the server.
    #[serde(skip_serializing_if = "Option::is_none")]
    address: Option<String>,
    /// The pairing code.
    #[serde(skip_serializing_if = "Option::is_none")]
    code: Option<String>,
    /// Fingerprint of the certificate that the phone is led to; nothing without HTTPS.
    #[serde(skip_serializing_if = "Option::is_none")]
    certificate_sha256: Option<String>,
}

/// What another phone needs to come in.
#[utoipa::path(get, path = "/join", tag = "session", responses((status = 200, body = Joining)))]
pub async fn show(
    State(state): State<AppState>,
    headers: HeaderMap,
) -> Result<Json<Joining>, ApiError> {
    let code = state.gatekeeper.as_ref().map(|keeper| keeper.code());
    Ok(Json(Joining {
        address: address(&state, &headers)?,
        code: code.map(|code| code.as_str().to_owned()),
        certificate_sha256: state.certificates.as_ref().map(|c| c.authority_sha256()),
    }))
}

/// The same as a QR code that a phone's camera opens, with the pairing code in it.
#[utoipa::path(get, path = "/join.svg", tag = "session", responses(
    (status = 200, description = "A picture", content_type = "image/svg+xml"),
    (status = 404, description = "Phones can't reach this server", body = Problem, content_type = "application/problem+json"),
))]
pub async fn picture(
    State(state): State<AppState>,
    headers: HeaderMap,
) -> Result<Response, ApiError> {
    let (Some(address), Some(gatekeeper)) = (address(&state, &headers)?, &state.gatekeeper) else {
        return Err(ApiError::not_found("address for phones")
            .advise("Start the server with --listen 0.0.0.0:8080 to let phones in."));
    };
    let code = gatekeeper.code().as_str();
    // A phone that may lack the certificate begins where the way to it is shown.
    let url = match state.certificates {
        Some(_) => format!("{address}#/join/{code}"),
        None => format!("{address}#pair={code}"),
    };
    let code = QrCode::new(&url).map_err(|error| ApiError::internal(&error))?;
    let drawing = code
        .render::<svg::Color<'_>>()
        .module_dimensions(SQUARE, SQUARE)
        .build();
    Ok(([(header::CONTENT_TYPE, "image/svg+xml")], drawing).into_response())
}

/// The certificate of this cell's authority.
///
/// Any page may ask for it, which the page on plain HTTP does: when it gets it over HTTPS, this
/// phone has the certificate installed.
pub async fn certificate(State(state): State<AppState>) -> Result<Response, ApiError> {
    let Some(certificates) = &state.certificates else {
        return Err(ApiError::not_found("certificate")
            .advise("Start the server with --https, or use it as it is."));
    };
    let headers = [
        (header::CONTENT_TYPE, CERTIFICATE_TYPE),
        (RESOURCE_POLICY, "cross-origin"),
    ];
    Ok((headers, certificates.authority().to_vec()).into_response())
}

/// Where another phone finds the server: under the name that this one uses, which works on this
/// network. A browser on the server itself uses one that means something else on a phone.
fn address(state: &AppState, headers: &HeaderMap) -> Result<Option<String>, ApiError> {
    let host = host(headers)?;
    Ok(state.found_at.map(|found_at| {
        if is_loopback(host) {
            format!("http://{found_at}/")
        } else {
            format!("http://{}/", with_port(host, found_at.port()))
        }
    }))
}

/// HTTPS and plain HTTP share a port but not the one that a browser leaves out.
fn with_port(host: &str, port: u16) -> String {
    let after_address = host.rsplit(']').next().unwrap_or(host);
    if after_address.contains(':') {
        host.to_owned()
    } else {
        format!("{host}:{port}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_address_always_names_the_port() {
        for (host, address) in [
            ("192.168.7.20:8080", "192.168.7.20:8080"),
            ("cell.local", "cell.local:443"),
            ("[fd12::7]", "[fd12::7]:443"),
            ("[fd12::7]:80", "[fd12::7]:80"),
        ] {
            assert_eq!(with_port(host, 443), address);
        }
    }
}
