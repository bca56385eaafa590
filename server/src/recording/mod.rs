//! Recording: from the arm in a person's hand to chunks in the store.
//!
//! At most one recording of a robot is open, because it has one arm. Here it is begun and ended; `session`
//! does what lies between. Not here: how lead-through is switched (crate `robot`).

mod orders;
mod session;

use std::sync::Arc;

use robot::{GuidanceEvent, HandCommand, HandScript, Robot, RobotError, RobotKind};
use tokio::sync::{Mutex, mpsc, watch};
use tokio::task::JoinHandle;

use crate::clock::SharedClock;
use crate::events::Events;
use crate::ids::{DemonstrationId, TaskId};
use crate::store::demonstrations::{
    Demonstration, DemonstrationSource, DemonstrationState, NewDemonstration,
};
use crate::store::{self, Store};
use crate::uninterrupted::uninterrupted;
use session::Session;

pub use orders::Order;

/// Why a recording could not begin or end.
#[derive(Debug, thiserror::Error)]
pub enum RecordingError {
    /// The robot refused.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// The store refused.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// Another recording is open.
    #[error("the arm is busy with another recording")]
    Busy,
    /// Only a virtual arm has a hand that shows by itself.
    #[error("a real robot has no virtual hand")]
    NoVirtualHand,
    /// The recording's state says open, but nobody records.
    #[error("this demonstration is not being recorded")]
    NotOpen,
    /// The virtual hand can't be held up.
    #[error("the virtual hand shows its motion in one go, so this recording can't be paused")]
    HandGoesOn,
    /// A recording without a sample has no place to be held up at.
    #[error("nothing is recorded yet")]
    NothingYet,
    /// The arm is not where the recording was held up.
    #[error("joint {joint} is {off_deg:.1}° from where you paused")]
    Elsewhere {
        /// The joint that is furthest off, from 1.
        joint: usize,
        /// How far.
        off_deg: f64,
    },
    /// The server is stopping.
    #[error("the server is stopping")]
    Closing,
}

/// A showing by the virtual controller's scripted hand.
#[derive(Clone, Copy, Debug)]
pub struct HandShowing {
    /// What it shows.
    pub script: HandScript,
    /// The seed of its variation from take to take.
    pub seed: u64,
}

/// Asks for a recording.
#[derive(Clone, Copy, Debug)]
pub struct RecordingRequest {
    /// The demonstration's identifier, which a client may choose.
    pub id: DemonstrationId,
    /// What it is an example of.
    pub task_id: TaskId,
    /// Who moves the arm: a person, or the virtual hand.
    pub hand: Option<HandShowing>,
}

const CUT_OFF: &str =
    "The server stopped while this was recorded. Everything up to half a second before is here.";
const SERVER_STOPPED: &str = "The server was stopped during the recording.";

/// Begins and ends recordings. Cheap to clone.
#[derive(Clone)]
pub struct Recorder(Arc<Inner>);

struct Inner {
    tools: Tools,
    guiding: Mutex<Guiding>,
}

/// What a recording works with.
#[derive(Clone)]
struct Tools {
    store: Store,
    events: Events,
    clock: SharedClock,
    /// What the robot is called.
    name: Arc<str>,
    robot: Robot,
}

type Samples = mpsc::Receiver<GuidanceEvent>;

/// What the arm's softness is used for.
enum Guiding {
    /// It is stiff, or not ours.
    Nothing,
    /// Somebody brings it somewhere by hand; what it does meanwhile is not kept.
    Free {
        stop: watch::Sender<Stop>,
        task: JoinHandle<Option<Samples>>,
    },
    /// A demonstration is being recorded.
    Recording {
        id: DemonstrationId,
        stop: watch::Sender<Stop>,
        orders: mpsc::Sender<orders::Ordered>,
        task: JoinHandle<()>,
    },
    /// The server is stopping.
    Closed,
}

/// Tells a recording to end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stop {
    No,
    Asked,
    ServerStops,
}

impl Recorder {
    /// A recorder for this robot, which requests call `name`.
    pub fn new(store: Store, events: Events, clock: SharedClock, name: &str, robot: Robot) -> Self {
        Self(Arc::new(Inner {
            tools: Tools {
                store,
                events,
                clock,
                name: name.into(),
                robot,
            },
            guiding: Mutex::new(Guiding::Nothing),
        }))
    }

    /// At start-up: recordings that the last run left open become interrupted and are offered,
    /// whichever robot they were made from.
    pub async fn recover(&self) -> Result<Vec<Demonstration>, store::Error> {
        self.0.tools.store.recover_recordings(CUT_OFF).await
    }

    /// Makes the arm soft and begins a recording. The same identifier again is the same
    /// demonstration, and the second value is false.
    ///
    /// # Errors
    /// When the robot refuses or another recording is open; then nothing was stored.
    pub async fn start(
        &self,
        request: RecordingRequest,
    ) -> Result<(Demonstration, bool), RecordingError> {
        let recorder = self.clone();
        uninterrupted(async move { recorder.begin(request).await }).await
    }

    /// Ends a recording and makes the arm stiff. One that has ended stays as it is.
    pub async fn stop(&self, id: DemonstrationId) -> Result<Demonstration, RecordingError> {
        let recorder = self.clone();
        uninterrupted(async move { recorder.end(id).await }).await
    }

    /// Makes the arm soft so that it can be brought somewhere by hand, or stiff again.
    pub async fn set_free(&self, free: bool) -> Result<(), RecordingError> {
        let recorder = self.clone();
        uninterrupted(async move { recorder.free_or_hold(free).await }).await
    }

    async fn begin(
        &self,
        request: RecordingRequest,
    ) -> Result<(Demonstration, bool), RecordingError> {
        let tools = &self.0.tools;
        let mut guiding = self.0.guiding.lock().await;
        match tools.store.demonstration(request.id).await {
            Ok(known)
                if known.task_id == request.task_id
                    && known.robot.as_deref() == Some(&*tools.name) =>
            {
                return Ok((known, false));
            }
            Ok(_) => {
                return Err(store::Error::IdTaken {
                    what: "demonstration",
                }
                .into());
            }
            Err(store::Error::NotFound { .. }) => {}
            Err(error) => return Err(error.into()),
        }
        tools.store.task(request.task_id).await?;
        if request.hand.is_some() {
            tools.has_virtual_hand()?;
        }
        let samples = self.soft_arm(&mut guiding).await?;
        let made = tools
            .store
            .create_demonstration(row_of(&request, &tools.name), tools.clock.now())
            .await;
        let demonstration = match made {
            Ok(demonstration) => demonstration,
            Err(error) => {
                tools.stiff_arm().await;
                return Err(error.into());
            }
        };
        tools.events.tell(&demonstration);
        let (stop, stopped) = watch::channel(Stop::No);
        let (orders, ordered) = mpsc::channel(1);
        let session = Session::new(tools.clone(), request.id, samples, stopped, ordered);
        let task = tokio::spawn(session.run(request.hand));
        *guiding = Guiding::Recording {
            id: request.id,
            stop,
            orders,
            task,
        };
        Ok((demonstration, true))
    }

    async fn end(&self, id: DemonstrationId) -> Result<Demonstration, RecordingError> {
        let mut guiding = self.0.guiding.lock().await;
        if let Guiding::Recording {
            id: open,
            stop,
            task,
            ..
        } = &mut *guiding
            && *open == id
        {
            stop.send_replace(Stop::Asked);
            ended(task).await;
            *guiding = Guiding::Nothing;
        }
        drop(guiding);
        let demonstration = self.0.tools.store.demonstration(id).await?;
        match demonstration.state {
            DemonstrationState::Preparing | DemonstrationState::Recording => {
                Err(RecordingError::NotOpen)
            }
            _ => Ok(demonstration),
        }
    }

    async fn free_or_hold(&self, free: bool) -> Result<(), RecordingError> {
        let tools = &self.0.tools;
        let mut guiding = self.0.guiding.lock().await;
        forget_ended(&mut guiding).await;
        match (&mut *guiding, free) {
            (Guiding::Closed, _) => return Err(RecordingError::Closing),
            (Guiding::Recording { .. }, _) => return Err(RecordingError::Busy),
            (Guiding::Free { .. }, true) => {}
            (Guiding::Nothing, true) => {
                let samples = tools.robot.start_guidance().await?;
                let (stop, stopped) = watch::channel(Stop::No);
                let task = tokio::spawn(discard(samples, stopped));
                *guiding = Guiding::Free { stop, task };
            }
            (Guiding::Free { stop, task }, false) => {
                stop.send_replace(Stop::Asked);
                ended(task).await;
                *guiding = Guiding::Nothing;
                tools.stop_guidance().await?;
            }
            (Guiding::Nothing, false) => tools.stop_guidance().await?,
        }
        Ok(())
    }

    /// Has the virtual hand bring the arm to where a showing begins.
    pub async fn hand_returns(&self, hand: HandShowing) -> Result<(), RecordingError> {
        self.0.tools.has_virtual_hand()?;
        let HandShowing { script, seed } = hand;
        let command = HandCommand::Return { script, seed };
        Ok(self.0.tools.robot.virtual_hand(command).await?)
    }

    /// Closes an open recording because the server stops; no other begins after this.
    pub async fn close(&self) {
        let mut guiding = self.0.guiding.lock().await;
        match &mut *guiding {
            Guiding::Recording { stop, task, .. } => {
                stop.send_replace(Stop::ServerStops);
                ended(task).await;
            }
            Guiding::Free { stop, task } => {
                stop.send_replace(Stop::ServerStops);
                ended(task).await;
                self.0.tools.stiff_arm().await;
            }
            Guiding::Nothing | Guiding::Closed => {}
        }
        *guiding = Guiding::Closed;
    }

    /// A soft arm for a recording: the one that is already in somebody's hand, or a fresh one.
    async fn soft_arm(&self, guiding: &mut Guiding) -> Result<Samples, RecordingError> {
        forget_ended(guiding).await;
        match guiding {
            Guiding::Closed => return Err(RecordingError::Closing),
            Guiding::Recording { .. } => return Err(RecordingError::Busy),
            Guiding::Nothing => {}
            Guiding::Free { stop, task } => {
                stop.send_replace(Stop::Asked);
                let samples = ended(task).await;
                *guiding = Guiding::Nothing;
                if let Some(Some(samples)) = samples {
                    return Ok(samples);
                }
            }
        }
        Ok(self.0.tools.robot.start_guidance().await?)
    }
}

impl Tools {
    /// Refuses before a real arm would be made soft for a hand that never comes.
    fn has_virtual_hand(&self) -> Result<(), RecordingError> {
        match self.robot.kind() {
            RobotKind::Gofa => Err(RecordingError::NoVirtualHand),
            RobotKind::Virtual | RobotKind::None => Ok(()),
        }
    }

    /// Makes the arm stiff; one that is stiff already stays so.
    async fn stop_guidance(&self) -> Result<(), RobotError> {
        match self.robot.stop_guidance().await {
            Err(RobotError::NotGuiding) => Ok(()),
            result => result,
        }
    }

    /// Makes the arm stiff where nobody can be told any more that it did not work.
    async fn stiff_arm(&self) {
        if let Err(error) = self.stop_guidance().await {
            tracing::warn!(%error, "lead-through could not be switched off");
        }
    }
}

fn row_of<'a>(request: &RecordingRequest, robot: &'a str) -> NewDemonstration<'a> {
    let (state, source) = match request.hand {
        Some(_) => (
            DemonstrationState::Preparing,
            DemonstrationSource::VirtualHand,
        ),
        None => (
            DemonstrationState::Recording,
            DemonstrationSource::HandGuiding,
        ),
    };
    NewDemonstration {
        id: request.id,
        task_id: request.task_id,
        state,
        source,
        robot: Some(robot),
    }
}

/// A recording or a free arm that ended by itself leaves the arm to the next one. Whoever no
/// longer listens for a stop is ending, and is waited for.
async fn forget_ended(guiding: &mut Guiding) {
    match guiding {
        Guiding::Recording { stop, task, .. } if stop.is_closed() => {
            ended(task).await;
        }
        Guiding::Free { stop, task } if stop.is_closed() => {
            ended(task).await;
        }
        _ => return,
    }
    *guiding = Guiding::Nothing;
}

async fn ended<T>(task: &mut JoinHandle<T>) -> Option<T> {
    task.await
        .inspect_err(|error| tracing::error!(%error, "a recording broke off"))
        .ok()
}

/// Lets samples pass until told to stop; then hands them over, unless guidance has ended.
async fn discard(mut samples: Samples, mut stop: watch::Receiver<Stop>) -> Option<Samples> {
    loop {
        tokio::select! {
            biased;
            _ = stop.wait_for(|stop| *stop != Stop::No) => return Some(samples),
            event = samples.recv() => match event {
                Some(GuidanceEvent::Ended { .. }) | None => return None,
                Some(_) => {}
            },
        }
    }
}
