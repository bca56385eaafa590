//! Every route on one page.

use axum::extract::DefaultBodyLimit;
use axum::routing::get;
use axum::{Router, middleware};
use tower_http::catch_panic::CatchPanicLayer;
use tower_http::trace::TraceLayer;
use utoipa::OpenApi;
use utoipa::openapi::OpenApi as Document;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use super::state::AppState;
use super::{
    agreement, assets, auth, control, dashboard, demonstrations, flights, headers, health, jobs,
    join, live, models, outcomes, pauses, pictures, plans, positions, questionnaire, reproductions,
    robot, run_control, session, signals, tasks, trims,
};

/// Requests are small; only recorded files are not.
const BODY_BYTES: usize = 256 * 1024;
const UPLOAD_BYTES: usize = 16 * 1024 * 1024;

#[derive(OpenApi)]
#[openapi(info(
    title = "TEAM",
    description = "Teach a robot arm to move: record, train, preview, reproduce."
))]
struct Description;

/// The whole server as one service.
pub fn router(state: AppState) -> Router {
    let (api, document) = api().split_for_parts();
    let api = api
        .route("/openapi.json", get(async move || axum::Json(document)))
        .fallback(headers::unknown_route)
        .method_not_allowed_fallback(headers::unknown_method)
        .layer(DefaultBodyLimit::max(BODY_BYTES));
    Router::new()
        .nest("/api/v1", api)
        .route(join::CERTIFICATE, get(join::certificate))
        .fallback(assets::serve)
        .layer(middleware::from_fn_with_state(state.clone(), auth::guard))
        .layer(CatchPanicLayer::custom(headers::panicked))
        .layer(middleware::from_fn(headers::secure))
        .layer(TraceLayer::new_for_http())
        .with_state(state)
}

fn api() -> OpenApiRouter<AppState> {
    let upload = OpenApiRouter::new()
        .routes(routes!(demonstrations::upload))
        .layer(DefaultBodyLimit::max(UPLOAD_BYTES));
    OpenApiRouter::with_openapi(described())
        .routes(routes!(health::show))
        .routes(routes!(session::show, session::pair))
        .routes(routes!(join::show))
        .routes(routes!(join::picture))
        .routes(routes!(tasks::list, tasks::create))
        .routes(routes!(tasks::show, tasks::rename, tasks::delete))
        .routes(routes!(tasks::restore))
        .routes(routes!(pictures::set, pictures::show, pictures::remove))
        .routes(routes!(demonstrations::list, demonstrations::record))
        .routes(routes!(demonstrations::show))
        .routes(routes!(demonstrations::trajectory))
        .routes(routes!(demonstrations::download))
        .routes(routes!(demonstrations::stop))
        .routes(routes!(pauses::pause))
        .routes(routes!(pauses::resume))
        .routes(routes!(demonstrations::keep))
        .routes(routes!(demonstrations::discard))
        .routes(routes!(demonstrations::undecide))
        .routes(routes!(trims::set, trims::remove))
        .routes(routes!(trims::suggest))
        .routes(routes!(agreement::show))
        .routes(routes!(models::list, models::train))
        .routes(routes!(models::show))
        .routes(routes!(models::file))
        .routes(routes!(models::curve))
        .routes(routes!(jobs::list))
        .routes(routes!(jobs::show))
        .routes(routes!(jobs::cancel))
        .routes(routes!(robot::list))
        .routes(routes!(robot::stop_all))
        .routes(routes!(robot::show))
        .routes(routes!(robot::stop))
        .routes(routes!(robot::reset))
        .routes(routes!(robot::lead_through))
        .routes(routes!(robot::virtual_hand))
        .routes(routes!(signals::set))
        .routes(routes!(control::change))
        .routes(routes!(live::open))
        .routes(routes!(plans::create))
        .routes(routes!(reproductions::list, reproductions::start))
        .routes(routes!(reproductions::show))
        .routes(routes!(reproductions::stop))
        .routes(routes!(run_control::pace))
        .routes(routes!(run_control::back))
        .routes(routes!(reproductions::trajectory))
        .routes(routes!(flights::show))
        .routes(routes!(flights::events))
        .routes(routes!(flights::csv))
        .routes(routes!(flights::mcap))
        .routes(routes!(outcomes::set, outcomes::forget))
        .routes(routes!(positions::list, positions::save))
        .routes(routes!(
            positions::show,
            positions::change,
            positions::delete
        ))
        .routes(routes!(questionnaire::due))
        .routes(routes!(questionnaire::reply))
        .routes(routes!(questionnaire::results))
        .routes(routes!(dashboard::show))
        .merge(upload)
}

fn described() -> Document {
    let mut document = Description::openapi();
    document.servers = Some(vec![utoipa::openapi::Server::new("/api/v1")]);
    document
}
