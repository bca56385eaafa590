//! Flight records: thinned out for plots, the events, and whole as files.

use axum::body::Body;
use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse, Response};
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};

use super::error::{ApiError, Problem};
use super::extract::{Json, Path, Query};
use super::signals::RunSignalMark;
use super::state::AppState;
use super::trajectories::{columns, seconds};
use crate::flight::{Bucket, Decimation, Export, Format, file_name};
use crate::ids::ReproductionId;
use crate::store::cycles::CyclePhase;
use crate::store::flights::Stretch;

/// Which stretch of a record, and how many points of it.
#[derive(Debug, Deserialize, IntoParams)]
pub struct Wanted {
    /// Where the stretch begins, in seconds since the motion was armed; the beginning when missing.
    from_s: Option<f64>,
    /// Where it ends; the end of the record when missing or later.
    to_s: Option<f64>,
    /// How many points at most: from 2 to 20000; 400 when missing.
    points: Option<usize>,
}

/// A stretch of a flight record. Each point stands for the cycles from its time to the next one's:
/// `commanded_deg` and `measured_deg` are those at its time, the rest is about all of them.
#[derive(Debug, Serialize, ToSchema)]
pub struct Flight {
    /// The time of the record's last cycle, in seconds since the motion was armed.
    end_s: f64,
    /// Times of the points in seconds since the motion was armed.
    t_s: Vec<f64>,
    /// Times within the plan, in seconds.
    plan_t_s: Vec<f64>,
    /// What the arm was doing; nothing in old records.
    phase: Vec<Option<CyclePhase>>,
    /// For each joint, the angle asked for in degrees.
    commanded_deg: Vec<Vec<f64>>,
    /// For each joint, the lowest angle asked for.
    commanded_min_deg: Vec<Vec<f64>>,
    /// For each joint, the highest angle asked for.
    commanded_max_deg: Vec<Vec<f64>>,
    /// For each joint, the angle that the controller reported in degrees.
    measured_deg: Vec<Vec<f64>>,
    /// For each joint, the lowest angle that was reported.
    measured_min_deg: Vec<Vec<f64>>,
    /// For each joint, the highest angle that was reported.
    measured_max_deg: Vec<Vec<f64>>,
    /// For each joint, the largest distance of the reported angle from the one asked for.
    error_max_deg: Vec<Vec<f64>>,
    /// Messages of the controller that never came.
    lost: Vec<u64>,
    /// Messages that came late.
    late: Vec<u64>,
    /// Cycles in which the setpoint was refused and the arm held.
    held: Vec<u64>,
    /// Cycles in which the setpoint was slowed down to stay within the limits.
    limited: Vec<u64>,
    /// The signals that the motion has set, when it is over; all of them, whatever the stretch.
    signals: Vec<RunSignalMark>,
}

/// Something that happened during a motion.
#[derive(Debug, Serialize, ToSchema)]
pub struct FlightEvent {
    /// Seconds since the motion was armed.
    at_s: f64,
    /// For programs. There may be more kinds in the future.
    code: String,
    /// For people.
    message: String,
}

/// What was commanded and measured, thinned out for a plot so that every extreme survives.
#[utoipa::path(get, path = "/reproductions/{id}/flight", tag = "reproductions", params(("id" = ReproductionId, Path), Wanted), responses(
    (status = 200, body = Flight),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "The stretch is empty or there are too many points", body = Problem, content_type = "application/problem+json"),
))]
pub async fn show(
    State(state): State<AppState>,
    Path(id): Path<ReproductionId>,
    Query(wanted): Query<Wanted>,
) -> Result<Json<Flight>, ApiError> {
    state.store.reproduction(id).await?;
    let end_us = state.store.flight_end_us(id).await?.unwrap_or(0);
    let stretch = wanted.stretch(end_us)?;
    let mut decimation = Decimation::new(stretch, wanted.points()?);
    let mut pages = state.store.flight(id, stretch);
    while let Some(cycles) = pages.next().await? {
        decimation.add(&cycles);
    }
    let signals = RunSignalMark::all(state.store.run_signals(id).await?);
    Ok(Json(flight_of(&decimation.finish(), end_us, signals)))
}

/// What happened during a motion, in order.
#[utoipa::path(get, path = "/reproductions/{id}/events", tag = "reproductions", params(("id" = ReproductionId, Path)), responses(
    (status = 200, body = [FlightEvent]),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn events(
    State(state): State<AppState>,
    Path(id): Path<ReproductionId>,
) -> Result<Json<Vec<FlightEvent>>, ApiError> {
    state.store.reproduction(id).await?;
    let events = state.store.flight_events(id).await?;
    let answers = events.into_iter().map(|event| FlightEvent {
        at_s: seconds(event.at_us),
        code: event.code,
        message: event.message,
    });
    Ok(Json(answers.collect()))
}

/// The whole record, one row per cycle.
#[utoipa::path(get, path = "/reproductions/{id}/flight.csv", tag = "reproductions", params(("id" = ReproductionId, Path)), responses(
    (status = 200, body = String, content_type = "text/csv"),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn csv(
    State(state): State<AppState>,
    Path(id): Path<ReproductionId>,
) -> Result<Response, ApiError> {
    download(&state, id, Format::Csv).await
}

/// The whole record as an MCAP file: joints, cycles and events.
#[utoipa::path(get, path = "/reproductions/{id}/flight.mcap", tag = "reproductions", params(("id" = ReproductionId, Path)), responses(
    (status = 200, body = Vec<u8>, content_type = "application/octet-stream"),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn mcap(
    State(state): State<AppState>,
    Path(id): Path<ReproductionId>,
) -> Result<Response, ApiError> {
    download(&state, id, Format::Mcap).await
}

/// Sends the file while it is being made. A record that turns out to be damaged breaks the download
/// off, so that nobody takes the part for the whole.
async fn download(
    state: &AppState,
    id: ReproductionId,
    format: Format,
) -> Result<Response, ApiError> {
    let reproduction = state.store.reproduction(id).await?;
    let export = Export::begin(&state.store, &reproduction, format).await?;
    let pieces = futures_util::stream::try_unfold(export, move |mut export| async move {
        let piece = export.next().await.inspect_err(|error| {
            tracing::error!(reproduction.id = %id, %error, "a download was broken off");
        })?;
        Ok::<_, crate::flight::ExportError>(piece.map(|piece| (piece, export)))
    });
    let kind = match format {
        Format::Csv => "text/csv; charset=utf-8",
        Format::Mcap => "application/octet-stream",
    };
    let name = file_name(&reproduction, format);
    let headers = [
        (header::CONTENT_TYPE, kind.to_owned()),
        (
            header::CONTENT_DISPOSITION,
            format!("attachment; filename=\"{name}\""),
        ),
    ];
    Ok((headers, Body::from_stream(pieces)).into_response())
}

impl Wanted {
    fn stretch(&self, end_us: u64) -> Result<Stretch, ApiError> {
        let from_us = microseconds("from_s", self.from_s)?.unwrap_or(0);
        let to_us = microseconds("to_s", self.to_s)?.unwrap_or(end_us);
        if from_us > to_us {
            return Err(ApiError::unprocessable(
                "out_of_range",
                "to_s",
                "The stretch ends before it begins.",
            )
            .advise("Choose an end after the beginning, within the motion."));
        }
        Ok(Stretch {
            from_us,
            to_us: to_us.min(end_us).max(from_us),
        })
    }

    fn points(&self) -> Result<usize, ApiError> {
        match self.points.unwrap_or(400) {
            points @ 2..=20_000 => Ok(points),
            _ => Err(ApiError::unprocessable(
                "out_of_range",
                "points",
                "points must be from 2 to 20000.",
            )),
        }
    }
}

/// A time of the query; nothing that a record could have is later than a month.
fn microseconds(field: &str, value_s: Option<f64>) -> Result<Option<u64>, ApiError> {
    match value_s {
        None => Ok(None),
        Some(value_s) if (0.0..=2_678_400.0).contains(&value_s) => {
            Ok(Some((value_s * 1e6).round() as u64))
        }
        Some(_) => Err(ApiError::unprocessable(
            "out_of_range",
            field,
            format!("{field} must be a number of seconds that is not negative."),
        )),
    }
}

fn flight_of(buckets: &[Bucket], end_us: u64, signals: Vec<RunSignalMark>) -> Flight {
    let angles = |of: fn(&Bucket) -> [f64; 6]| columns(buckets.iter().map(of));
    let counts = |of: fn(&Bucket) -> u64| buckets.iter().map(of).collect();
    let first = |bucket: &Bucket| bucket.first;
    Flight {
        end_s: seconds(end_us),
        t_s: buckets
            .iter()
            .map(|bucket| seconds(bucket.first.at_us))
            .collect(),
        plan_t_s: buckets
            .iter()
            .map(|bucket| first(bucket).plan_t_s)
            .collect(),
        phase: buckets
            .iter()
            .map(|bucket| bucket.first.details.map(|details| details.phase))
            .collect(),
        commanded_deg: angles(|bucket| bucket.first.commanded_deg),
        commanded_min_deg: angles(|bucket| bucket.commanded_min_deg),
        commanded_max_deg: angles(|bucket| bucket.commanded_max_deg),
        measured_deg: angles(|bucket| bucket.first.measured_deg),
        measured_min_deg: angles(|bucket| bucket.measured_min_deg),
        measured_max_deg: angles(|bucket| bucket.measured_max_deg),
        error_max_deg: angles(|bucket| bucket.error_max_deg),
        lost: counts(|bucket| bucket.lost),
        late: counts(|bucket| bucket.late),
        held: counts(|bucket| bucket.held),
        limited: counts(|bucket| bucket.limited),
        signals,
    }
}
