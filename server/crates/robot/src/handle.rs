//! What the rest of the server holds of the robot.

use crate::config::{RobotConfig, RobotKind};
use crate::control_loop::ControlLoop;
use crate::control_thread;
use crate::error::RobotError;
use crate::guidance::{GuidanceEvent, HandCommand};
use crate::links::{Flags, links};
use crate::run::RunHandle;
use crate::supervisor::{Reply, Request, Supervisor};
use crate::view::{RobotState, RobotView};
use motion::plan::Plan;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{Notify, mpsc, oneshot, watch};
use tracing::Instrument;

/// Requests that may wait; each is answered within a moment or by a refusal.
const REQUESTS: usize = 32;

/// The robot. Cloning is cheap; the arm comes to rest when the last clone is dropped.
#[derive(Debug, Clone)]
pub struct Robot {
    kind: RobotKind,
    egm_addr: SocketAddr,
    view: watch::Receiver<RobotView>,
    requests: mpsc::Sender<Request>,
    flags: Arc<Flags>,
    stop: Arc<Notify>,
    /// The zero of the program's time.
    epoch: Instant,
}

/// How long the arm goes on after the last word that the button is held. Short, since everything
/// may have happened to the phone meanwhile; longer than Wi-Fi keeps a message waiting.
pub const HOLD: Duration = Duration::from_millis(180);

impl Robot {
    /// Binds the EGM port and starts the control thread and the supervisor. The controller need
    /// not be there yet.
    ///
    /// # Errors
    /// [`RobotError::Bind`] when the port is not available.
    pub async fn start(config: RobotConfig) -> Result<Self, RobotError> {
        let address = config.egm_listen;
        let bind_error = |source| RobotError::Bind { address, source };
        let socket = control_thread::bind(address).map_err(bind_error)?;
        let egm_addr = socket.local_addr().map_err(bind_error)?;
        let epoch = Instant::now();
        let (thread_links, supervisor_links) = links();
        let flags = Arc::clone(&supervisor_links.flags);
        let control = ControlLoop::new(thread_links, &config.limits, config.silence);
        control_thread::spawn(socket, control, Arc::clone(&flags), epoch, config.real_time)
            .map_err(bind_error)?;

        let kind = config.kind;
        let (view_in, view) = watch::channel(RobotView::new(kind));
        let (requests, requests_out) = mpsc::channel(REQUESTS);
        let stop = Arc::new(Notify::new());
        let supervisor = Supervisor::new(
            config,
            supervisor_links,
            epoch,
            Arc::clone(&stop),
            view_in,
            requests.downgrade(),
        );
        // What it logs belongs to the robot that is being started.
        tokio::spawn(supervisor.serve(requests_out).in_current_span());
        Ok(Self {
            kind,
            egm_addr,
            view,
            requests,
            flags,
            stop,
            epoch,
        })
    }

    /// Where the controller has to send its EGM messages.
    #[must_use]
    pub fn egm_addr(&self) -> SocketAddr {
        self.egm_addr
    }

    /// The robot as it is, about 25 times a second.
    #[must_use]
    pub fn view(&self) -> watch::Receiver<RobotView> {
        self.view.clone()
    }

    /// Sets the address of the controller's web services, when it was not known at the start.
    ///
    /// # Errors
    /// [`RobotError::Controller`] when the address is not usable, [`RobotError::Busy`] once
    /// connected.
    pub async fn connect(&self, rws_url: impl Into<String>) -> Result<(), RobotError> {
        let url = rws_url.into();
        self.ask(|reply| Request::Connect(url, reply)).await
    }

    /// Makes the arm soft. The stream ends with [`GuidanceEvent::Ended`].
    ///
    /// # Errors
    /// Unless the arm is idle, in automatic mode, and lets itself be made soft.
    pub async fn start_guidance(&self) -> Result<mpsc::Receiver<GuidanceEvent>, RobotError> {
        let stops = self.flags.stops();
        self.ask(|reply| Request::StartGuidance { stops, reply })
            .await
    }

    /// Makes the arm stiff and returns when it is.
    ///
    /// # Errors
    /// [`RobotError::NotGuiding`] when it is not soft, [`RobotError::Faulted`] when it stays soft.
    pub async fn stop_guidance(&self) -> Result<(), RobotError> {
        self.ask(Request::StopGuidance).await
    }

    /// Runs a plan. Returns as soon as it is accepted.
    ///
    /// # Errors
    /// Unless the arm is idle and stands within 1 deg of the plan's first sample.
    pub async fn run(&self, plan: Arc<Plan>) -> Result<RunHandle, RobotError> {
        self.begin(plan, false).await
    }

    /// Runs a plan, moving only while somebody holds the button ([`Robot::hold`]): from its first
    /// cycle on, and the arm slows down to standstill on its path as soon as nobody does.
    ///
    /// # Errors
    /// As [`Robot::run`].
    pub async fn run_while_held(&self, plan: Arc<Plan>) -> Result<RunHandle, RobotError> {
        self.begin(plan, true).await
    }

    async fn begin(&self, plan: Arc<Plan>, held: bool) -> Result<RunHandle, RobotError> {
        let stops = self.flags.stops();
        self.ask(|reply| Request::Run {
            stops,
            plan,
            held,
            reply,
        })
        .await
    }

    /// Somebody holds the button at this moment; it counts for [`HOLD`] and is to be said again
    /// before that is over. The control thread itself watches that time.
    ///
    /// # Errors
    /// [`RobotError::NotRunning`] when nothing runs.
    pub fn hold(&self) -> Result<(), RobotError> {
        self.check_runs()?;
        let until = self.epoch.elapsed() + HOLD;
        self.flags.hold_until(until.as_micros() as u64);
        Ok(())
    }

    /// Nobody holds the button any more.
    pub fn let_go(&self) {
        self.flags.let_go();
    }

    /// Stops whatever the arm does; also makes a soft arm stiff. Never waits, never fails, and is
    /// no safety function: that is the controller's.
    pub fn stop(&self) {
        self.flags.stop();
        self.stop.notify_one();
    }

    /// Speed of the present run as a share of its plan's, from [`crate::SLOWEST`] to 1. It holds
    /// from the next cycle on and until the run ends; the next one begins at full speed.
    ///
    /// # Errors
    /// [`RobotError::BadSpeed`] outside that range, [`RobotError::NotRunning`] when nothing runs.
    pub fn set_speed(&self, share: f64) -> Result<(), RobotError> {
        if !(crate::SLOWEST..=1.0).contains(&share) {
            return Err(RobotError::BadSpeed { share });
        }
        self.check_runs()?;
        self.flags.set_speed(share);
        Ok(())
    }

    /// Slows the present run down to standstill, or lets it go on.
    ///
    /// # Errors
    /// [`RobotError::NotRunning`] when nothing runs.
    pub fn set_paused(&self, paused: bool) -> Result<(), RobotError> {
        self.check_runs()?;
        self.flags.set_paused(paused);
        Ok(())
    }

    fn check_runs(&self) -> Result<(), RobotError> {
        if self.view.borrow().state == RobotState::Reproducing {
            Ok(())
        } else {
            Err(RobotError::NotRunning)
        }
    }

    /// A person has looked at the fault.
    ///
    /// # Errors
    /// [`RobotError::NotReady`] while a stop is still active on the controller.
    pub async fn reset(&self) -> Result<(), RobotError> {
        self.ask(Request::Reset).await
    }

    /// Sets the virtual hand going. When this returns, the view shows what it does.
    ///
    /// # Errors
    /// [`RobotError::NotGuiding`] unless the arm is soft.
    pub async fn virtual_hand(&self, command: HandCommand) -> Result<(), RobotError> {
        self.ask(|reply| Request::Hand(command, reply)).await
    }

    /// Sets a signal. When this returns, the controller has it and the view shows it.
    ///
    /// # Errors
    /// [`RobotError::SignalUnknown`] unless it is configured, [`RobotError::Busy`] while a plan
    /// runs, [`RobotError::SignalNotSet`] when it does not read as it was set.
    pub async fn set_signal(&self, name: &str, on: bool) -> Result<(), RobotError> {
        let name = name.to_owned();
        self.ask(|reply| Request::SetSignal { name, on, reply })
            .await
    }

    /// Which arm there is.
    #[must_use]
    pub fn kind(&self) -> RobotKind {
        self.kind
    }

    /// Brings the arm to rest, logs out, and ends the control thread.
    pub async fn shutdown(&self) {
        let (done, waits) = oneshot::channel();
        if self.requests.send(Request::Shutdown(done)).await.is_ok() {
            // An error means that it is over already.
            let _ = waits.await;
        }
    }

    async fn ask<T>(&self, request: impl FnOnce(Reply<T>) -> Request) -> Result<T, RobotError> {
        let (reply, answer) = oneshot::channel();
        self.requests
            .send(request(reply))
            .await
            .map_err(|_| RobotError::ShuttingDown)?;
        answer.await.unwrap_or(Err(RobotError::ShuttingDown))
    }
}
