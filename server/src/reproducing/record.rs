//! Keeping the flight record: chunks of a run go into the store while the run goes on.

use std::time::Instant;

use robot::{CycleRecord, FlightChunk, RunPhase};

use crate::clock::{SharedClock, WallTime};
use crate::ids::ReproductionId;
use crate::store::cycles::{Cycle, CycleDetails, CyclePhase};
use crate::store::flights::{FlightEvent, NewFlight};
use crate::store::{Error, Store};

/// Cycles that wait at most when the store refuses them: a minute.
const MOST_WAITING: usize = 15_000;

/// Keeps the record of one run.
pub(super) struct Keeper {
    store: Store,
    clock: SharedClock,
    id: ReproductionId,
    cycles: Vec<Cycle>,
    events: Vec<FlightEvent>,
    lost: usize,
}

impl Keeper {
    pub(super) fn new(store: Store, clock: SharedClock, id: ReproductionId) -> Self {
        Self {
            store,
            clock,
            id,
            cycles: Vec::new(),
            events: Vec::new(),
            lost: 0,
        }
    }

    /// Commits a chunk. What the store does not take is tried again with the next one.
    pub(super) async fn keep(&mut self, chunk: FlightChunk) {
        let space = MOST_WAITING.saturating_sub(self.cycles.len());
        self.lost += chunk.cycles.len().saturating_sub(space);
        let cycles = chunk.cycles.iter().take(space);
        self.cycles.extend(cycles.map(cycle_of));
        self.events
            .extend(chunk.events.into_iter().map(|event| FlightEvent {
                at_us: event.at_us,
                code: event.code.to_owned(),
                message: event.message,
            }));
        if let Err(error) = self.commit(chunk.armed).await {
            tracing::error!(reproduction.id = %self.id, %error, "a flight record could not be stored");
        }
    }

    /// Commits the last chunk.
    pub(super) async fn finish(mut self, rest: FlightChunk) {
        if self.lost > 0 {
            let at_us = rest
                .armed
                .map_or(0, |armed| armed.elapsed().as_micros() as u64);
            let message = format!("{} cycles could not be stored.", self.lost);
            self.events.push(FlightEvent {
                at_us,
                code: "record_incomplete".into(),
                message,
            });
        }
        self.keep(rest).await;
    }

    async fn commit(&mut self, armed: Option<Instant>) -> Result<(), Error> {
        if self.cycles.is_empty() && self.events.is_empty() {
            return Ok(());
        }
        let new = NewFlight {
            armed_at: armed.map(|armed| wall_time(&self.clock, armed)),
            cycles: &self.cycles,
            events: &self.events,
        };
        self.store.append_flight(self.id, new).await?;
        self.cycles.clear();
        self.events.clear();
        Ok(())
    }
}

/// The wall clock's time at a moment that has passed.
fn wall_time(clock: &SharedClock, moment: Instant) -> WallTime {
    let age_ms = i64::try_from(moment.elapsed().as_millis()).unwrap_or(i64::MAX);
    clock.now().plus_ms(-age_ms)
}

/// Speeds and percentages keep seven digits, which is plenty.
fn cycle_of(record: &CycleRecord) -> Cycle {
    Cycle {
        at_us: record.at_us,
        plan_t_s: record.plan_t_s,
        commanded_deg: record.commanded.0,
        measured_deg: record.measured.0,
        details: Some(CycleDetails {
            commanded_deg_s: record.commanded_speed.0.map(|speed| speed as f32),
            utilization_percent: record.utilization_percent.map(|percent| percent as f32),
            lost: record.lost,
            phase: match record.phase {
                RunPhase::Approach => CyclePhase::Approach,
                RunPhase::Motion => CyclePhase::Motion,
                RunPhase::Settling => CyclePhase::Settling,
                RunPhase::Stopping => CyclePhase::Stopping,
                RunPhase::Paused => CyclePhase::Paused,
            },
            late: record.late,
            held: record.held,
            limited: record.limited,
            motors_on: record.motors_on,
            rapid_running: record.rapid_running,
        }),
    }
}
