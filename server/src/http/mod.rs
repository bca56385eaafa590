//! Everything that knows HTTP; nothing else does.
//!
//! Handlers take a request apart, call one thing, and shape the answer; they decide nothing.

mod agreement;
mod assets;
mod auth;
mod control;
mod dashboard;
mod demonstrations;
mod error;
mod extract;
mod flights;
mod headers;
mod health;
mod jobs;
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

use tokio::net::TcpListener;

/// Answers requests until the server is asked to stop and the last answer is given.
///
/// # Errors
/// When the system takes the listener away.
pub async fn serve(listener: TcpListener, state: AppState) -> std::io::Result<()> {
    let shutdown = state.shutdown.clone();
    let service = router::router(state).into_make_service_with_connect_info::<SocketAddr>();
    axum::serve(listener, service)
        .with_graceful_shutdown(async move { shutdown.raised().await })
        .await
}
