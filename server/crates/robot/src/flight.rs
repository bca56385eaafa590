//! The flight record of a run on its way out: cycles and events in chunks, several a second.
//!
//! The supervisor fills it from the control thread's ring. Whoever keeps the record takes the
//! chunks from a channel; a keeper that lags behind makes neither the supervisor nor the control
//! thread wait. Not here: where the chunks are stored.

use crate::player::RunPhase;
use crate::run::{CycleRecord, RunEnd};
use rws::ControllerState;
use std::time::{Duration, Instant};
use tokio::sync::mpsc;

/// A crash costs at most what came in since the last chunk left.
const CHUNK_EVERY: Duration = Duration::from_millis(200);
/// Cycles of one chunk and some more.
const CHUNK_CYCLES: usize = 64;
/// Chunks that may wait for their keeper: about twelve seconds.
const CHUNKS: usize = 64;
/// Cycles that may wait besides, about a minute; what comes then is lost and counted.
const MOST_WAITING: usize = 15_000;

/// Something that happened during a run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FlightEvent {
    /// Since the run was armed, as in [`CycleRecord::at_us`].
    pub at_us: u64,
    /// For machines.
    pub code: &'static str,
    /// For people.
    pub message: String,
}

/// What came in since the last chunk.
#[derive(Debug, Clone, PartialEq)]
pub struct FlightChunk {
    /// When the run was armed: the zero of its time line; nothing before that.
    pub armed: Option<Instant>,
    /// Cycles in the order in which they were answered.
    pub cycles: Vec<CycleRecord>,
    /// Events in the order in which they were seen.
    pub events: Vec<FlightEvent>,
}

/// Fills chunks and sends them off.
pub(crate) struct FlightWriter {
    out: mpsc::Sender<FlightChunk>,
    armed: Option<Instant>,
    phase: Option<RunPhase>,
    controller: Option<ControllerState>,
    stop_seen: bool,
    speed: f64,
    held: Option<bool>,
    cycles: Vec<CycleRecord>,
    events: Vec<FlightEvent>,
    last_us: u64,
    due: Instant,
    lost: u64,
}

impl FlightWriter {
    pub(crate) fn new() -> (Self, mpsc::Receiver<FlightChunk>) {
        let (out, flight) = mpsc::channel(CHUNKS);
        let writer = Self {
            out,
            armed: None,
            phase: None,
            controller: None,
            stop_seen: false,
            speed: 1.0,
            held: None,
            cycles: Vec::with_capacity(CHUNK_CYCLES),
            events: Vec::new(),
            last_us: 0,
            due: Instant::now() + CHUNK_EVERY,
            lost: 0,
        };
        (writer, flight)
    }

    /// When the run was armed. Cycles are taken only after that is known.
    pub(crate) fn armed(&mut self, at: Instant) {
        self.armed.get_or_insert(at);
    }

    /// Takes what the control thread has written, and sends a chunk when it is time.
    pub(crate) fn take(&mut self, records: &mut rtrb::Consumer<CycleRecord>) {
        if self.armed.is_none() {
            return;
        }
        while let Ok(record) = records.pop() {
            self.see_phase(&record);
            self.last_us = record.at_us;
            if self.cycles.len() < MOST_WAITING {
                self.cycles.push(record);
            } else {
                self.lost += 1;
            }
        }
        let now = Instant::now();
        if now >= self.due {
            self.due = now + CHUNK_EVERY;
            self.send();
        }
    }

    /// Notes something that happened now.
    pub(crate) fn event(&mut self, code: &'static str, message: impl Into<String>) {
        let now_us = self.armed.map_or(0, |armed| armed.elapsed().as_micros());
        self.note(now_us as u64, code, message.into());
    }

    /// Notes the controller's state when it is another than before.
    pub(crate) fn see_controller(&mut self, state: Option<&ControllerState>) {
        if let Some(state) = state
            && self.controller.as_ref() != Some(state)
        {
            self.controller = Some(state.clone());
            self.event("controller_state", controller_words(state));
        }
    }

    /// Notes the speed that was asked for when it is another than before.
    pub(crate) fn see_speed(&mut self, share: f64) {
        if self.speed != share {
            self.speed = share;
            let words = format!("The speed is set to {:.0} %.", share * 100.0);
            self.event("speed", words);
        }
    }

    /// Notes when the button of a run that moves only while it is held is pressed and let go.
    pub(crate) fn see_hold(&mut self, held: Option<bool>) {
        let before = std::mem::replace(&mut self.held, held);
        match (before, held) {
            (Some(false) | None, Some(true)) => self.event("held", "The button is being held."),
            (Some(true), Some(false)) => self.event("let_go", "The button was let go."),
            _ => {}
        }
    }

    /// Notes once that a stop was asked for.
    pub(crate) fn see_stop(&mut self) {
        if !std::mem::replace(&mut self.stop_seen, true) {
            self.event("stop_requested", "A stop was asked for.");
        }
    }

    /// The last chunk, with how the run ended.
    pub(crate) fn finish(
        mut self,
        end: &RunEnd,
        records: &mut rtrb::Consumer<CycleRecord>,
    ) -> FlightChunk {
        self.take(records);
        if self.lost > 0 {
            let message = format!("{} cycles could not be kept.", self.lost);
            self.event("record_incomplete", message);
        }
        match end {
            RunEnd::Completed => self.event("completed", "The arm stands at the end of the plan."),
            RunEnd::Stopped => self.event("stopped", "The arm was stopped."),
            RunEnd::Failed(fault) => {
                let words = format!("{}. {}", fault.message, fault.advice);
                self.note(self.last_us, fault.code, words);
                self.event("failed", "The motion was broken off.");
            }
        }
        self.chunk()
    }

    fn see_phase(&mut self, record: &CycleRecord) {
        if self.phase.is_none() {
            let words = "The server commands the arm.".to_owned();
            self.note(record.at_us, "armed", words);
        }
        if self.phase.replace(record.phase) != Some(record.phase) {
            let (code, words) = phase_event(record.phase);
            self.note(record.at_us, code, words.to_owned());
        }
    }

    fn note(&mut self, at_us: u64, code: &'static str, message: String) {
        self.events.push(FlightEvent {
            at_us,
            code,
            message,
        });
    }

    fn send(&mut self) {
        let nothing = self.cycles.is_empty() && self.events.is_empty();
        // When the channel is full they go with the next chunk.
        if nothing || self.out.capacity() == 0 {
            return;
        }
        let chunk = self.chunk();
        // An error means that nobody keeps the record any more.
        let _ = self.out.try_send(chunk);
    }

    fn chunk(&mut self) -> FlightChunk {
        FlightChunk {
            armed: self.armed,
            cycles: std::mem::replace(&mut self.cycles, Vec::with_capacity(CHUNK_CYCLES)),
            events: std::mem::take(&mut self.events),
        }
    }
}

fn phase_event(phase: RunPhase) -> (&'static str, &'static str) {
    match phase {
        RunPhase::Approach => ("approach", "The arm goes to the start of the motion."),
        RunPhase::Motion => ("motion", "The arm does the motion."),
        RunPhase::Paused => ("paused", "The arm stands until it is to go on."),
        RunPhase::Settling => ("settling", "The plan is over; the arm comes to rest."),
        RunPhase::Stopping => ("stopping", "The arm comes to a standstill."),
    }
}

fn controller_words(state: &ControllerState) -> String {
    let words = match state {
        ControllerState::Init => "The controller is starting up.",
        ControllerState::MotorsOff => "The controller reports motors off.",
        ControllerState::MotorsOn => "The controller reports motors on.",
        ControllerState::GuardStop => "The controller reports a guard stop.",
        ControllerState::EmergencyStop => "The controller reports an emergency stop.",
        ControllerState::EmergencyStopReset => {
            "The controller waits for its emergency stop to be acknowledged."
        }
        ControllerState::SystemFailure => "The controller reports a system failure.",
        ControllerState::Other(word) => return format!("The controller reports {word:?}."),
    };
    words.to_owned()
}

#[cfg(test)]
mod tests;
