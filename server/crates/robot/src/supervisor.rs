//! The state machine of the arm: Disconnected, Idle, Guiding, Reproducing, Stopping, Faulted.
//!
//! One task owns it. It never waits for the controller itself: calls run as one operation beside
//! it, so that a stop, the view and the control thread's news are always attended to.

mod guiding;
mod report;
mod reproducing;
mod seen;
mod signals;

use crate::config::{RobotConfig, RobotKind};
use crate::error::{Fault, RobotError};
use crate::follow::follow;
use crate::guidance::{GuidanceEvent, GuidanceStream, HandActivity, HandCommand};
use crate::links::SupervisorLinks;
use crate::poll::{self, Observation, Pace};
use crate::procedures::{self, Aftermath};
use crate::run::RunHandle;
use crate::signals::SignalBoard;
use crate::view::RobotView;
use motion::plan::Plan;
use reproducing::RunSlot;
use rws::Client;
use seen::Seen;
use signals::RunSignal;
use std::future::Future;
use std::pin::Pin;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{Notify, mpsc, oneshot, watch};

const TICK: Duration = Duration::from_millis(20);
/// The view is published every so many ticks.
const VIEW_EVERY: u32 = 2;
/// Longest time for everything to come to rest at shutdown.
const SHUTDOWN_WITHIN: Duration = Duration::from_secs(6);
const OBSERVATIONS: usize = 64;

pub(crate) type Reply<T> = oneshot::Sender<Result<T, RobotError>>;

/// What the handle asks for.
pub(crate) enum Request {
    Connect(String, Reply<()>),
    StartGuidance {
        stops: u64,
        reply: Reply<mpsc::Receiver<GuidanceEvent>>,
    },
    StopGuidance(Reply<()>),
    Run {
        stops: u64,
        plan: Arc<Plan>,
        held: bool,
        reply: Reply<RunHandle>,
    },
    Reset(Reply<()>),
    Hand(HandCommand, Reply<()>),
    /// The virtual hand was set going; the view must show it before its caller goes on.
    HandMoves {
        at: Instant,
        activity: HandActivity,
        reply: Reply<()>,
    },
    SetSignal {
        name: String,
        on: bool,
        reply: Reply<()>,
    },
    /// A person's signal was set; the view must show it before its caller goes on.
    SignalIs {
        name: String,
        on: bool,
        at: Instant,
        reply: Reply<()>,
    },
    /// A run's signal was set, or could not be.
    RunSignal(RunSignal),
    Shutdown(oneshot::Sender<()>),
}

/// What the arm does, with what belongs to it.
enum Mode {
    Disconnected,
    Idle,
    EnteringGuidance(Reply<mpsc::Receiver<GuidanceEvent>>),
    Guiding {
        stream: GuidanceStream,
        /// [`crate::links::Flags::stops`] when it was asked for.
        stops: u64,
    },
    LeavingGuidance(Vec<Reply<()>>),
    Run(Box<RunSlot>),
    Faulted(Fault),
}

/// What an operation came to.
enum Done {
    GuidanceEntered(u64, Result<(), RobotError>),
    GuidanceLeft(Result<(), RobotError>),
    RunBegun(Result<(), RobotError>),
    RunEnded(Aftermath),
    CleanedUp(Result<(), RobotError>),
}

type Operation = Pin<Box<dyn Future<Output = Done> + Send>>;

/// What could not be done because the controller did not answer, and must be before anything else.
#[derive(Debug, Clone, Copy, Default)]
struct Unfinished {
    guidance: bool,
    run: bool,
}

pub(crate) struct Supervisor {
    config: RobotConfig,
    links: SupervisorLinks,
    epoch: Instant,
    stop: Arc<Notify>,
    view: watch::Sender<RobotView>,
    requests: mpsc::WeakSender<Request>,
    client: Option<Client>,
    poller: Option<tokio::task::JoinHandle<()>>,
    pace: watch::Sender<Pace>,
    seen: Seen,
    signals: SignalBoard,
    mode: Mode,
    operation: Option<Operation>,
    unfinished: Unfinished,
    runs: u64,
    ticks: u32,
}

impl Supervisor {
    pub(crate) fn new(
        config: RobotConfig,
        links: SupervisorLinks,
        epoch: Instant,
        stop: Arc<Notify>,
        view: watch::Sender<RobotView>,
        requests: mpsc::WeakSender<Request>,
    ) -> Self {
        Self {
            signals: SignalBoard::new(&config.signals),
            config,
            links,
            epoch,
            stop,
            view,
            requests,
            client: None,
            poller: None,
            pace: watch::Sender::new(Pace::Idle),
            seen: Seen::default(),
            mode: Mode::Disconnected,
            operation: None,
            unfinished: Unfinished::default(),
            runs: 0,
            ticks: 0,
        }
    }

    /// Runs until shutdown is asked for or every handle is gone.
    pub(crate) async fn serve(mut self, mut requests: mpsc::Receiver<Request>) {
        let (news_in, mut news) = mpsc::channel(OBSERVATIONS);
        if let Some(url) = self.config.rws_url.clone()
            && let Err(error) = self.connect(url, &news_in)
        {
            tracing::error!(%error, "the robot's address is not usable");
        }
        let stop = Arc::clone(&self.stop);
        let mut tick = tokio::time::interval(TICK);
        let mut leaving: Option<(Instant, Option<oneshot::Sender<()>>)> = None;
        loop {
            tokio::select! {
                () = stop.notified() => self.see_stop(),
                request = requests.recv(), if leaving.is_none() => match request {
                    Some(Request::Connect(url, reply)) => {
                        let _ = reply.send(self.connect(url, &news_in));
                    }
                    Some(Request::Shutdown(done)) => leaving = Some(self.leave(Some(done))),
                    None => leaving = Some(self.leave(None)),
                    Some(request) => self.handle(request),
                },
                done = next_done(&mut self.operation) => self.finish(done),
                Some(observation) = news.recv() => self.observe(observation),
                _ = tick.tick() => self.tick(),
            }
            if let Some((deadline, done)) = &mut leaving
                && (self.is_quiet() || Instant::now() >= *deadline)
            {
                self.close().await;
                if let Some(done) = done.take() {
                    let _ = done.send(());
                }
                return;
            }
        }
    }

    fn connect(&mut self, url: String, news: &mpsc::Sender<Observation>) -> Result<(), RobotError> {
        if self.config.kind == RobotKind::None {
            return Err(RobotError::NoRobot);
        }
        if !matches!(self.mode, Mode::Disconnected) || self.operation.is_some() {
            return Err(self.busy());
        }
        let client = Client::new(rws::Config {
            base_url: url,
            user: self.config.rws_user.clone(),
            password: self.config.rws_password.clone(),
            certificate_sha256: self.config.rws_certificate_sha256.clone(),
            timeout: self.config.rws_timeout,
        })?;
        if let Some(poller) = self.poller.take() {
            poller.abort();
        }
        let has_virtual_hand = self.config.kind == RobotKind::Virtual;
        let follow = follow(client.clone(), self.signals.names(), news.clone());
        let poll = poll::poll(
            client.clone(),
            has_virtual_hand,
            self.signals.names(),
            self.pace.subscribe(),
            news.clone(),
        );
        self.poller = Some(tokio::spawn(async move {
            tokio::join!(poll, follow);
        }));
        self.client = Some(client);
        Ok(())
    }

    fn handle(&mut self, request: Request) {
        match request {
            Request::StartGuidance { stops, reply } => self.start_guidance(stops, reply),
            Request::StopGuidance(reply) => self.stop_guidance(reply),
            Request::Run {
                stops,
                plan,
                held,
                reply,
            } => {
                let _ = reply.send(self.start_run(stops, plan, held));
            }
            Request::Reset(reply) => {
                let _ = reply.send(self.reset());
            }
            Request::Hand(command, reply) => self.move_hand(command, reply),
            Request::HandMoves {
                at,
                activity,
                reply,
            } => {
                self.seen.hand_moves(at, activity);
                self.publish();
                let _ = reply.send(Ok(()));
            }
            Request::SetSignal { name, on, reply } => self.set_signal(&name, on, reply),
            Request::SignalIs {
                name,
                on,
                at,
                reply,
            } => {
                self.see_signal(&name, Some(on), at);
                self.publish();
                let _ = reply.send(Ok(()));
            }
            Request::RunSignal(done) => self.run_signal_set(done),
            // These two are dealt with where the channels are.
            Request::Connect(..) | Request::Shutdown(_) => {}
        }
    }

    /// A person acknowledges a fault.
    fn reset(&mut self) -> Result<(), RobotError> {
        if self.config.kind == RobotKind::None {
            return Err(RobotError::NoRobot);
        }
        if !matches!(self.mode, Mode::Faulted(_)) {
            return Ok(());
        }
        if let Some(reason) = self
            .seen
            .controller
            .as_ref()
            .and_then(procedures::not_ready)
        {
            return Err(RobotError::NotReady { reason });
        }
        self.come_to_rest();
        self.publish();
        Ok(())
    }

    fn see_stop(&mut self) {
        self.attend_guidance();
        self.attend_run();
        if self.is_soft_by_itself() {
            self.make_stiff(Vec::new());
        }
        self.publish();
    }

    fn finish(&mut self, done: Done) {
        match done {
            Done::GuidanceEntered(stops, result) => self.guidance_entered(stops, result),
            Done::GuidanceLeft(result) => self.guidance_left(result),
            Done::RunBegun(result) => self.run_begun(result),
            Done::RunEnded(aftermath) => self.run_ended(aftermath),
            Done::CleanedUp(Ok(())) => {
                self.unfinished = Unfinished::default();
                self.come_to_rest();
            }
            Done::CleanedUp(Err(RobotError::Controller(error))) if error.is_unreachable() => {
                self.seen.connected = false;
            }
            Done::CleanedUp(Err(error)) => {
                tracing::error!(%error, "the robot could not be brought to rest");
                self.mode = Mode::Faulted(error.to_fault());
            }
        }
        self.publish();
    }

    /// Idle when the controller answers and nothing is left over, else Disconnected.
    fn come_to_rest(&mut self) {
        self.mode = Mode::Disconnected;
        if self.seen.connected {
            self.come_back();
        }
    }

    /// The controller answers (again): first what was left over, then Idle. Nothing is resumed.
    fn come_back(&mut self) {
        if self.operation.is_some() || !matches!(self.mode, Mode::Disconnected) {
            return;
        }
        let Unfinished { guidance, run } = self.unfinished;
        match self.client.clone() {
            Some(client) if guidance || run => {
                self.operation = Some(Box::pin(async move {
                    Done::CleanedUp(clean_up(&client, guidance, run).await)
                }));
            }
            Some(_) => self.mode = Mode::Idle,
            None => {}
        }
    }

    fn tick(&mut self) {
        let state = *self.links.state.read();
        self.seen.see_loop(&state);
        while self.links.retired.pop().is_ok() {}
        self.drain_samples();
        self.attend_guidance();
        self.attend_run();
        self.pace.send_if_modified(|pace| {
            let wanted = match &self.mode {
                Mode::Guiding { .. } => Pace::Guiding {
                    egm_delivers: self.seen.egm_is_fresh(self.now_us()),
                },
                Mode::Run(_) => Pace::Reproducing,
                _ => Pace::Idle,
            };
            std::mem::replace(pace, wanted) != wanted
        });
        self.ticks = self.ticks.wrapping_add(1);
        if self.ticks.is_multiple_of(VIEW_EVERY) {
            self.publish();
        }
    }

    fn is_quiet(&self) -> bool {
        let resting = matches!(
            self.mode,
            Mode::Disconnected | Mode::Idle | Mode::Faulted(_)
        );
        resting && self.operation.is_none()
    }

    fn leave(
        &mut self,
        done: Option<oneshot::Sender<()>>,
    ) -> (Instant, Option<oneshot::Sender<()>>) {
        self.links.flags.stop();
        self.see_stop();
        (Instant::now() + SHUTDOWN_WITHIN, done)
    }

    async fn close(&mut self) {
        if let Some(poller) = self.poller.take() {
            poller.abort();
        }
        if let Some(client) = &self.client
            && let Err(error) = client.logout().await
        {
            tracing::debug!(%error, "the robot's session was not logged out");
        }
        self.links.flags.quit();
    }

    fn now_us(&self) -> u64 {
        self.epoch.elapsed().as_micros() as u64
    }
}

/// The end of the present operation; never, when there is none.
async fn next_done(operation: &mut Option<Operation>) -> Done {
    match operation {
        Some(running) => {
            let done = running.await;
            *operation = None;
            done
        }
        None => std::future::pending().await,
    }
}

async fn clean_up(client: &Client, guidance: bool, run: bool) -> Result<(), RobotError> {
    if run {
        procedures::end_run(client).await.stopped?;
    }
    if guidance {
        procedures::leave_guidance(client).await?;
    }
    Ok(())
}
