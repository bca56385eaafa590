//! The controller: everything that has a state, and what one cycle does to it.
//!
//! No sockets, threads or clocks: [`crate::egm_client`] calls [`Controller::begin_cycle`] and
//! [`Controller::end_cycle`] once per cycle, [`crate::rws`] calls the rest.

mod guidance;
mod panel;
mod program;

use egm::ControllerTime;
use egm::messages::{EgmRobot, MciState, RapidExecState};
use motion::JointAngles;
use tokio::sync::broadcast;

use crate::arm::{Arm, BRAKE_S};
use crate::clock::WallTime;
use crate::config::Config;
use crate::egm_message::Content;
use crate::egm_session::{Failure, Session};
use crate::events::{EventLog, Incident};
use crate::faults::Faults;
use crate::faults::link::ControllerFault;
use crate::faults::script::FaultScript;
use crate::hand::Hand;
use crate::signals::{GRIPPER_CLOSE, Signals};

pub use guidance::LeadThrough;
pub use panel::{ControllerState, OperatingMode};
pub use program::{Program, RunMode};

/// So many changes may wait for a slow subscriber.
const CHANGES_WAITING: usize = 256;
/// After a refused position stream the controller waits this long before it streams again, s.
const STREAM_PAUSE_S: f64 = 2.0;

/// Why the controller does not do what a client asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Refusal {
    /// Not in this operating mode, motor state or program state.
    #[error("{0}")]
    WrongState(&'static str),
    /// The signal's access level does not let clients write it.
    #[error("Rejected: the signal is not open to clients")]
    Rejected,
    /// There is no such thing.
    #[error("{0}")]
    Missing(&'static str),
}

/// Something that clients can subscribe to has changed.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// Motors and stops.
    State(ControllerState),
    /// Mode switch.
    Mode(OperatingMode),
    /// Speed ratio, percent.
    SpeedRatio(u8),
    /// The program runs or stands.
    Running(bool),
    /// A signal.
    Signal {
        /// Its name.
        name: String,
        /// Its value.
        on: bool,
    },
    /// A new event.
    Event {
        /// Its domain.
        domain: u32,
        /// Its number.
        number: u64,
    },
}

/// One message for the EGM server.
#[derive(Clone, Debug)]
pub struct Outgoing {
    /// The session it belongs to: each has its own socket.
    pub session: u64,
    /// The message.
    pub message: EgmRobot,
    /// A test wants it to be lost.
    pub lost: bool,
}

/// The whole controller.
pub struct Controller {
    config: Config,
    arm: Arm,
    state: ControllerState,
    mode: OperatingMode,
    speed_ratio: u8,
    program: Program,
    run_mode: RunMode,
    /// The program has not stopped since the controller started.
    never_stopped: bool,
    lead_through: LeadThrough,
    hand: Hand,
    session: Option<Session>,
    sessions: u64,
    stream_pause_s: f64,
    signals: Signals,
    events: EventLog,
    faults: Faults,
    /// A script that the line has not taken yet.
    fault_script: Option<FaultScript>,
    changes: broadcast::Sender<Change>,
    cycles: u64,
    now: WallTime,
}

impl Controller {
    /// A controller with its arm at home, motors off, in automatic mode.
    #[must_use]
    pub fn new(config: Config) -> Self {
        Self {
            arm: Arm::new(config.egm, config.home),
            config,
            state: ControllerState::MotorsOff,
            mode: OperatingMode::Automatic,
            speed_ratio: 100,
            program: Program::Stopped,
            run_mode: RunMode::Once,
            never_stopped: true,
            lead_through: LeadThrough::Inactive,
            hand: Hand::default(),
            session: None,
            sessions: 0,
            stream_pause_s: 0.0,
            signals: Signals::default(),
            events: EventLog::default(),
            faults: Faults::default(),
            fault_script: None,
            changes: broadcast::Sender::new(CHANGES_WAITING),
            cycles: 0,
            now: WallTime::default(),
        }
    }

    /// First half of a cycle: measures, and makes the message that is to be sent.
    pub fn begin_cycle(&mut self, now: WallTime) -> Option<Outgoing> {
        self.now = now;
        self.open_session();
        let rapid = if self.config.egm.rapid_undefined_at_first && self.never_stopped {
            RapidExecState::Undefined
        } else if self.program.is_running() {
            RapidExecState::Running
        } else {
            RapidExecState::Stopped
        };
        let session = self.session.as_mut()?;
        let elapsed_ms = self.cycles as f64 * self.config.egm.cycle_s * 1000.0;
        let content = Content {
            sequence: session.take_sequence(),
            sent_at: ControllerTime((elapsed_ms as u64 & u64::from(u32::MAX)) as u32),
            at: now,
            measured: self.arm.measured(),
            planned: self.arm.planned(),
            motors_on: self.state == ControllerState::MotorsOn,
            correction: session.state(),
            convergence_met: session.convergence_met(),
            rapid,
            load_percent: session.load_percent(),
            targets: session.targets(),
        };
        Some(Outgoing {
            session: session.id,
            message: content.into_message(self.config.egm.messages),
            lost: self.faults.egm_lost,
        })
    }

    /// Second half of a cycle: takes the next datagram of the server, and moves the arm.
    pub fn end_cycle(&mut self, datagram: Option<&[u8]>) {
        self.cycles += 1;
        self.advance_lead_through();
        self.advance_program();
        let egm = self.config.egm;
        let rest_s = if self.state == ControllerState::MotorsOn {
            egm.ramp_s
        } else {
            BRAKE_S
        };
        if self.lead_through.is_soft() {
            if let Some(at) = self.hand.step(egm.cycle_s) {
                self.arm.place(at);
            }
            if let Some(close) = self.hand.grips() {
                self.turn_signal(GRIPPER_CLOSE, close);
            }
        } else if let Some(session) = &mut self.session {
            if let Err(failure) = session.cycle(datagram, &mut self.arm, &egm, rest_s) {
                self.fail(failure);
            }
        } else {
            self.arm.come_to_rest(rest_s);
        }
        self.close_session();
    }

    /// The network said that nobody listens where a message was sent.
    pub fn message_refused(&mut self, session: u64, bytes: usize) {
        match &self.session {
            Some(open) if open.id == session => {
                self.log(Incident::SendRefused { bytes });
                self.session = None;
                self.stream_pause_s = STREAM_PAUSE_S;
                self.set_program(Program::Stopped);
            }
            _ => {}
        }
    }

    /// Where the arm is.
    #[must_use]
    pub fn measured(&self) -> JointAngles {
        self.arm.measured()
    }

    /// The configuration.
    #[must_use]
    pub fn config(&self) -> &Config {
        &self.config
    }

    /// The event log.
    #[must_use]
    pub fn events(&self) -> &EventLog {
        &self.events
    }

    /// The signals.
    #[must_use]
    pub fn signals(&self) -> &Signals {
        &self.signals
    }

    /// The switches for tests.
    pub fn faults_mut(&mut self) -> &mut Faults {
        &mut self.faults
    }

    /// The switches for tests.
    #[must_use]
    pub fn faults(&self) -> &Faults {
        &self.faults
    }

    /// Lets a script of faults begin.
    pub fn set_fault_script(&mut self, script: FaultScript) {
        self.fault_script = Some(script);
    }

    /// The script that is to begin, once.
    pub(crate) fn take_fault_script(&mut self) -> Option<FaultScript> {
        self.fault_script.take()
    }

    /// Lets a fault of the script happen.
    pub(crate) fn suffer(&mut self, fault: ControllerFault) {
        match fault {
            ControllerFault::GuardStop(open) => self.set_guard_stop(open),
            ControllerFault::Restart => self.restart(),
        }
    }

    /// Reports every later change.
    #[must_use]
    pub fn subscribe(&self) -> broadcast::Receiver<Change> {
        self.changes.subscribe()
    }

    /// What was going on ends without a farewell, and the brakes hold the arm; afterwards all
    /// counts begin anew. The event log stays, as it does on a real controller.
    fn restart(&mut self) {
        self.session = None;
        self.leave_motors_on(ControllerState::MotorsOff);
        self.never_stopped = true;
        self.stream_pause_s = STREAM_PAUSE_S;
        self.cycles = 0;
    }

    fn fail(&mut self, failure: Failure) {
        self.set_program(Program::Stopped);
        match failure {
            Failure::NoData => {
                self.log(Incident::NoData {
                    timeout_s: self.config.egm.comm_timeout_s,
                });
                self.end_session(MciState::Error);
            }
            Failure::OutOfRange(bad) => {
                self.log(Incident::OutOfRange(bad));
                self.end_session(MciState::Error);
                self.leave_motors_on(ControllerState::MotorsOff);
            }
        }
    }

    fn log(&mut self, incident: Incident) {
        let (domain, number) = self.events.add(incident, self.now);
        self.report(Change::Event { domain, number });
    }

    fn report(&self, change: Change) {
        // Nobody may be subscribed.
        self.changes.send(change).ok();
    }
}

#[cfg(test)]
mod tests;
