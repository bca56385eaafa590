//! Everything that knows HTTP; nothing else does.
//!
//! Handlers take a request apart, call one thing, and shape the answer; they decide nothing.

mod agreement;
mod assets;
mod auth;
mod control;
mod dashboard;
mod demonstrations;
mod entrance;
mod error;
mod extract;
mod flights;
mod headers;
mod health;
mod holds;
mod jobs;
mod join;
mod live;
mod models;
mod outcomes;
mod pauses;
mod pictures;
mod plans;
mod positions;
mod questionnaire;
mod reproductions;
mod robot;
mod router;
mod run_control;
mod session;
mod signals;
mod state;
mod tasks;
#[cfg(test)]
mod tests;
mod trajectories;
mod trims;

pub use state::AppState;

use std::net::SocketAddr;

use axum::middleware::map_request_with_state;
use tokio::net::TcpListener;

use entrance::{Peer, Scheme};

/// Answers requests until the server is asked to stop and the last answer is given.
///
/// # Errors
/// When the system takes the listener away.
pub async fn serve(listener: TcpListener, state: AppState) -> std::io::Result<()> {
    let shutdown = state.shutdown.clone();
    let stopped = || {
        let shutdown = shutdown.clone();
        async move { shutdown.raised().await }
    };
    let Some(certificates) = state.certificates.clone() else {
        let service = router::router(state).into_make_service_with_connect_info::<SocketAddr>();
        return axum::serve(listener, service)
            .with_graceful_shutdown(stopped())
            .await;
    };
    let config = certificates.tls().map_err(std::io::Error::other)?;
    let (plain, secured) = entrance::open(listener, config, shutdown.clone())?;
    let service = |scheme| {
        let introduce = map_request_with_state(scheme, entrance::introduce);
        let router = router::router(state.clone()).layer(introduce);
        router.into_make_service_with_connect_info::<Peer>()
    };
    let plain = axum::serve(plain, service(Scheme::Http)).with_graceful_shutdown(stopped());
    let secured = axum::serve(secured, service(Scheme::Https)).with_graceful_shutdown(stopped());
    tokio::try_join!(plain, secured)?;
    Ok(())
}
