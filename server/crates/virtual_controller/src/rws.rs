//! Robot Web Services 2.0, as far as a client of this project needs them, over plain HTTP.
//!
//! Every route is on this page. What a request must look like is in `negotiation` and `guard`,
//! what an answer looks like in `reply`.

mod accounts;
mod elog;
mod guard;
mod hand;
mod https;
mod io;
mod mastership;
mod motion_system;
mod negotiation;
mod panel;
mod rapid;
mod reply;
mod sessions;
mod subscription;
mod system;

use std::sync::{Arc, Mutex, MutexGuard};

use axum::Router;
use axum::middleware;
use axum::routing::{delete, get, post};
use tokio::net::TcpListener;
use tokio::sync::watch;

use crate::controller::Controller;
use crate::lock;
pub use https::Identity;
use https::TlsListener;
use sessions::Sessions;
use subscription::Subscriptions;

/// What the handlers share.
#[derive(Clone)]
struct App {
    controller: Arc<Mutex<Controller>>,
    sessions: Arc<Mutex<Sessions>>,
    subscriptions: Arc<Mutex<Subscriptions>>,
    /// Becomes true when the server ends.
    ends: watch::Receiver<bool>,
    /// Scheme and address of this server's WebSockets, `ws://host:port` or `wss://host:port`.
    web_sockets: Arc<str>,
}

impl App {
    fn controller(&self) -> MutexGuard<'_, Controller> {
        lock(&self.controller)
    }

    fn sessions(&self) -> MutexGuard<'_, Sessions> {
        lock(&self.sessions)
    }

    fn subscriptions(&self) -> MutexGuard<'_, Subscriptions> {
        lock(&self.subscriptions)
    }
}

/// Serves on `listener` until `ends` becomes true; over HTTPS with an identity.
pub async fn serve(
    listener: TcpListener,
    identity: Option<Identity>,
    controller: Arc<Mutex<Controller>>,
    ends: watch::Receiver<bool>,
) {
    let authority = match listener.local_addr() {
        Ok(address) => address,
        Err(error) => {
            tracing::error!(%error, "Robot Web Services have no address");
            return;
        }
    };
    let scheme = if identity.is_some() { "wss" } else { "ws" };
    let app = App {
        controller,
        sessions: Arc::default(),
        subscriptions: Arc::default(),
        ends: ends.clone(),
        web_sockets: format!("{scheme}://{authority}").into(),
    };
    let mut end = ends;
    let ended = async move {
        // An error means that the controller is gone, which is an end too.
        end.wait_for(|end| *end).await.ok();
    };
    let outcome = match identity {
        None => {
            axum::serve(listener, router(app))
                .with_graceful_shutdown(ended)
                .await
        }
        Some(identity) => {
            let listener = TlsListener::new(listener, &identity);
            axum::serve(listener, router(app))
                .with_graceful_shutdown(ended)
                .await
        }
    };
    if let Err(error) = outcome {
        tracing::error!(%error, "Robot Web Services ended");
    }
}

fn router(app: App) -> Router {
    const UNIT: &str = "/rw/motionsystem/mechunits/ROB_1";
    let unit = |resource: &str| format!("{UNIT}/{resource}");
    Router::new()
        .route("/", get(system::root))
        .route("/rw/system", get(system::system))
        .route("/rw/system/options", get(system::options))
        .route("/ctrl/identity", get(system::identity))
        .route("/ctrl/clock", get(system::clock))
        .route("/logout", get(system::logout))
        .route(
            "/rw/panel/ctrl-state",
            get(panel::state).post(panel::set_state),
        )
        .route("/rw/panel/opmode", get(panel::mode).post(panel::set_mode))
        .route(
            "/rw/panel/speedratio",
            get(panel::speed_ratio).post(panel::set_speed_ratio),
        )
        .route("/rw/panel/coldetstate", get(panel::collision_detection))
        .route("/rw/rapid/execution", get(rapid::execution))
        .route("/rw/rapid/execution/start", post(rapid::start))
        .route("/rw/rapid/execution/stop", post(rapid::stop))
        .route(
            "/rw/rapid/execution/resetpp",
            post(rapid::reset_program_pointer),
        )
        .route("/rw/rapid/tasks", get(rapid::tasks))
        .route("/rw/rapid/tasks/{task}/modules", get(rapid::modules))
        .route("/rw/mastership/edit", get(mastership::state))
        .route("/rw/mastership/edit/request", post(mastership::request))
        .route("/rw/mastership/edit/release", post(mastership::release))
        .route(UNIT, get(motion_system::unit))
        .route(&unit("jointtarget"), get(motion_system::joint_target))
        .route(&unit("robtarget"), get(motion_system::rob_target))
        .route(&unit("cartesian"), get(motion_system::cartesian))
        .route(
            &unit("lead-through"),
            get(motion_system::lead_through).post(motion_system::set_lead_through),
        )
        .route("/rw/iosystem/signals", get(io::signals))
        .route(
            "/rw/iosystem/signals/{*path}",
            get(io::signal).post(io::set_signal),
        )
        .route("/rw/elog/{domain}", get(elog::messages))
        .route("/subscription", post(subscription::subscribe))
        .route("/subscription/{id}", delete(subscription::unsubscribe))
        .route("/poll/{id}", get(subscription::poll))
        .route("/virtual/hand", get(hand::doing).post(hand::act))
        .layer(middleware::from_fn_with_state(app.clone(), guard::guard))
        .with_state(app)
}
