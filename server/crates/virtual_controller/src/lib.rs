//! A virtual GoFa: an arm and its controller that speak EGM over UDP and Robot Web Services 2.0
//! over HTTP or HTTPS, on real sockets, as a real cell does.
//!
//! Its state and physics ([`controller`], [`arm`], [`hand`]) know neither sockets nor clocks;
//! [`egm_client`] and [`rws`] connect them, and [`simulation`] runs them without both. Other
//! programs reach it through its sockets alone.
//! Only one resource is not ABB's: `/virtual/hand`, with which a hand guides the arm while
//! lead-through is active, by script or to joint angles that somebody names again and again.

pub mod arm;
pub mod clock;
pub mod config;
pub mod controller;
pub mod egm_client;
mod egm_message;
pub mod egm_session;
pub mod error;
pub mod events;
pub mod faults;
pub mod hand;
mod line;
pub mod rws;
pub mod signals;
pub mod simulation;

use std::net::SocketAddr;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tokio::net::TcpListener;
use tokio::sync::{broadcast, watch};
use tokio::task::JoinHandle;

pub use config::{Config, EgmSettings, MessageSet, StopMode};
pub use error::Error;
pub use faults::link::LinkFaults;
pub use faults::script::{Direction, Fault, FaultScript, ScriptedFault};
pub use faults::{FaultSwitches, Faults};
pub use simulation::{Datagram, SimulatedController};

use controller::{Change, Controller, Refusal};
use egm_client::EgmClient;
use events::Event;
use rws::Identity;

/// How long open connections may take to end when the controller stops.
const FAREWELL: Duration = Duration::from_secs(1);

/// A running virtual controller. Dropping it stops it, without waiting for its HTTP server.
pub struct VirtualController {
    controller: Arc<Mutex<Controller>>,
    egm: EgmClient,
    rws_addr: SocketAddr,
    certificate_sha256: Option<String>,
    end_rws: watch::Sender<bool>,
    rws: JoinHandle<()>,
}

impl VirtualController {
    /// Starts the controller: its cycle on a thread of its own, Robot Web Services on the present
    /// tokio runtime.
    ///
    /// # Errors
    /// [`Error`] when the configuration makes no sense, the address is taken or the system has no
    /// thread to give.
    pub async fn start(config: Config) -> Result<Self, Error> {
        config.check()?;
        let address = config.rws_listen;
        let listen_error = |source| Error::Listen { address, source };
        let listener = TcpListener::bind(address).await.map_err(listen_error)?;
        let rws_addr = listener.local_addr().map_err(listen_error)?;
        let identity = config.rws_https.then(Identity::new).transpose()?;
        let certificate_sha256 = identity.as_ref().map(Identity::sha256);
        let controller = Arc::new(Mutex::new(Controller::new(config)));
        let egm = EgmClient::start(Arc::clone(&controller)).map_err(Error::Thread)?;
        let (end_rws, rws_ends) = watch::channel(false);
        let rws = tokio::spawn(rws::serve(
            listener,
            identity,
            Arc::clone(&controller),
            rws_ends,
        ));
        Ok(Self {
            controller,
            egm,
            rws_addr,
            certificate_sha256,
            end_rws,
            rws,
        })
    }

    /// Where Robot Web Services listen.
    #[must_use]
    pub fn rws_addr(&self) -> SocketAddr {
        self.rws_addr
    }

    /// Address of Robot Web Services, `http://host:port` or `https://host:port`.
    #[must_use]
    pub fn rws_url(&self) -> String {
        let s = self.certificate_sha256.as_ref().map_or("", |_| "s");
        format!("http{s}://{}", self.rws_addr)
    }

    /// SHA-256 fingerprint of the certificate, pairs of hexadecimal digits with colons between
    /// them; nothing without HTTPS.
    #[must_use]
    pub fn certificate_sha256(&self) -> Option<&str> {
        self.certificate_sha256.as_deref()
    }

    /// The faults that tests can bring about.
    #[must_use]
    pub fn faults(&self) -> FaultSwitches {
        FaultSwitches(Arc::clone(&self.controller))
    }

    /// Reports every later change, new events among them.
    #[must_use]
    pub fn changes(&self) -> broadcast::Receiver<Change> {
        lock(&self.controller).subscribe()
    }

    /// The events after the one with this number, oldest first.
    #[must_use]
    pub fn events_after(&self, number: u64) -> Vec<Event> {
        let controller = lock(&self.controller);
        let newest = controller.events().newest_first(0);
        let mut events: Vec<Event> = newest
            .take_while(|event| event.number > number)
            .cloned()
            .collect();
        events.reverse();
        events
    }

    /// Switches the motors on and starts the program, unless it runs, as a person at the
    /// controller does.
    ///
    /// # Errors
    /// [`Refusal`] when the controller's state does not allow it.
    pub fn keep_running(&self) -> Result<(), Refusal> {
        let mut controller = lock(&self.controller);
        if controller.program().is_running() {
            return Ok(());
        }
        controller.set_motors(true)?;
        controller.start_program(None)
    }

    /// Stops the controller and waits until its sockets are closed.
    pub async fn stop(mut self) {
        self.egm.stop();
        self.end_rws.send(true).ok();
        let rws = &mut self.rws;
        if tokio::time::timeout(FAREWELL, &mut *rws).await.is_err() {
            rws.abort();
        }
    }
}

impl Drop for VirtualController {
    fn drop(&mut self) {
        self.end_rws.send(true).ok();
    }
}

/// Locks; a thread that panicked leaves the state as it was after its last whole step.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
