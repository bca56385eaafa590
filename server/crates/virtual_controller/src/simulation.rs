//! A controller with its EGM line, step by step: no sockets, no clock, no waiting.
//!
//! The same arm, session rules and faults as on real sockets, for many runs in little time. Time
//! is an argument in microseconds, and randomness comes from the fault script's seed, so that a
//! run is the same each time.

use std::net::{Ipv4Addr, SocketAddr};

use motion::JointAngles;

use crate::clock::WallTime;
use crate::config::Config;
use crate::controller::{Controller, Refusal};
use crate::error::Error;
use crate::faults::script::FaultScript;
use crate::line::Line;

/// Ports of the simulated sockets: so many from the first on, used in turn.
const FIRST_PORT: u16 = 49_152;
const PORTS: u64 = 16_384;

/// A datagram between a controller and its EGM server.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Datagram {
    /// To the server: when it arrives there, µs. To the controller: when it is sent, µs.
    pub at_us: u64,
    /// The controller's end: where it comes from, or where it is sent to.
    pub controller: SocketAddr,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// A virtual controller in simulated time, which begins at 0.
pub struct SimulatedController {
    controller: Controller,
    line: Line,
    cycle: u64,
    next_cycle_us: u64,
    /// On the way to the server, in the order of their arrival; used by [`Self::cycle`] alone.
    under_way: Vec<Datagram>,
}

impl SimulatedController {
    /// A controller with its arm at home and its motors off.
    ///
    /// # Errors
    /// [`Error::Config`] when the configuration makes no sense. Its addresses are not used.
    pub fn new(config: Config) -> Result<Self, Error> {
        config.check()?;
        Ok(Self {
            controller: Controller::new(config),
            line: Line::default(),
            cycle: 0,
            next_cycle_us: 0,
            under_way: Vec::new(),
        })
    }

    /// Lets a script of faults begin; the one before ends.
    ///
    /// # Errors
    /// [`Error::ScriptedFault`] when its numbers make no sense.
    pub fn play(&mut self, script: FaultScript) -> Result<(), Error> {
        script.check()?;
        self.controller.set_fault_script(script);
        Ok(())
    }

    /// Switches the motors on and starts the program that opens an EGM session.
    ///
    /// # Errors
    /// [`Refusal`] when the controller's state does not allow it.
    pub fn start_program(&mut self) -> Result<(), Refusal> {
        self.controller.set_motors(true)?;
        self.controller.start_program(None)
    }

    /// When the next cycle is, µs.
    #[must_use]
    pub fn next_cycle_us(&self) -> u64 {
        self.next_cycle_us
    }

    /// Hands over what was sent to the controller since the step before, in the order in which it
    /// was sent, and runs all cycles up to and with `now_us`. Returns what the controller sent,
    /// in the order in which it arrives.
    ///
    /// In each cycle the controller sends before it reads: an answer counts in the cycle after.
    /// A datagram for a socket that is closed meanwhile is gone.
    pub fn step(
        &mut self,
        now_us: u64,
        incoming: impl IntoIterator<Item = Datagram>,
    ) -> Vec<Datagram> {
        for datagram in incoming {
            if let Some(socket) = self.line.socket()
                && address(socket) == datagram.controller
            {
                self.line.arrived(socket, datagram.at_us, &datagram.bytes);
            }
        }
        let period_us = self.controller.config().egm.cycle_s * 1e6;
        while self.next_cycle_us <= now_us {
            let at_us = self.next_cycle_us;
            let wall = WallTime {
                seconds: at_us / 1_000_000,
                microseconds: (at_us % 1_000_000) as u32,
            };
            self.line.begin_cycle(&mut self.controller, at_us, wall);
            self.line.end_cycle(&mut self.controller, at_us);
            self.cycle += 1;
            // Lateness does not add up, and no cycle overtakes the one before.
            let due_us = (self.cycle as f64 * period_us).round() as u64;
            let late_us = self.line.cycle_delay_us(at_us);
            self.next_cycle_us = (due_us + late_us).max(at_us);
        }
        std::iter::from_fn(|| self.line.departing(u64::MAX))
            .map(|parcel| Datagram {
                at_us: parcel.at_us,
                controller: address(parcel.socket),
                bytes: parcel.bytes,
            })
            .collect()
    }

    /// One cycle with a server: `serve` gets each datagram when its time has come, in the order
    /// of arrival, and may answer it at once.
    pub fn cycle(&mut self, mut serve: impl FnMut(&Datagram) -> Option<Vec<u8>>) {
        let now_us = self.next_cycle_us();
        let due = self
            .under_way
            .partition_point(|datagram| datagram.at_us < now_us);
        let answers: Vec<Datagram> = self
            .under_way
            .drain(..due)
            .filter_map(|datagram| {
                let bytes = serve(&datagram)?;
                Some(Datagram { bytes, ..datagram })
            })
            .collect();
        let sent = self.step(now_us, answers);
        self.under_way.extend(sent);
        self.under_way.sort_by_key(|datagram| datagram.at_us);
    }

    /// Where the arm is.
    #[must_use]
    pub fn measured(&self) -> JointAngles {
        self.controller.measured()
    }

    /// The controller: its states, switches and event log.
    #[must_use]
    pub fn controller(&self) -> &Controller {
        &self.controller
    }

    /// The controller, to switch or stop something.
    pub fn controller_mut(&mut self) -> &mut Controller {
        &mut self.controller
    }
}

/// The address of a simulated socket.
fn address(socket: u64) -> SocketAddr {
    // The remainder fits a port.
    let offset = u16::try_from(socket % PORTS).unwrap_or_default();
    SocketAddr::from((Ipv4Addr::LOCALHOST, FIRST_PORT + offset))
}

#[cfg(test)]
mod tests;
