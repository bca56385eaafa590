//! Reproducing: a plan that was approved is run by the arm, and what came of it is stored.
//!
//! Not here: the motion itself (crate `robot`) and its approval (`planning`, `motion::gate`).

mod figures;
mod judging;
mod record;
mod signals;

use std::sync::{Arc, PoisonError};

use motion::limits::RobotLimits;
use robot::{Robot, RobotError, RunHandle, RunOutcome};
use tokio::sync::Mutex;
use tokio::task::JoinHandle;

use crate::clock::SharedClock;
use crate::events::Events;
use crate::ids::ReproductionId;
use crate::planning::PlanError;
use crate::plans::{KnownPlan, Plans};
use crate::store::flights::{FlightEvent, NewFlight, Stretch};
use crate::store::reproductions::{
    NewReproduction, Reproduction, ReproductionResult, ReproductionState,
};
use crate::store::{self, Store};
use crate::uninterrupted::uninterrupted;
use figures::{Figures, Measure};
use judging::{failed, judge, measured};
use record::Keeper;
use signals::keep_signals;

/// Why a reproduction could not begin.
#[derive(Debug, thiserror::Error)]
pub enum ReproducingError {
    /// The robot refused.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// The store refused.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// The plan was never made, or was forgotten.
    #[error("this preview is not known any more")]
    PlanUnknown,
    /// There is no way back.
    #[error(transparent)]
    NoWay(#[from] PlanError),
    /// A computation failed.
    #[error("the way back could not be worked out")]
    Crashed(tokio::task::JoinError),
    /// The plan was made for another robot's pose and limits.
    #[error("this preview was made for the robot \"{of}\", not for \"{robot}\"")]
    OtherRobot {
        /// The robot that it was made for.
        of: String,
        /// The robot that was to run it.
        robot: String,
    },
    /// The robot moves only while somebody holds the button.
    #[error("this robot moves only while somebody holds the button on a phone")]
    HoldRequired,
    /// The motion is over, or another one is running.
    #[error("this motion is not running")]
    NotRunning,
    /// The client's key or identifier was used for another motion.
    #[error("this start was already used for another motion")]
    KeyReused,
}

/// Asks for a motion.
#[derive(Clone, Debug)]
pub struct StartRequest {
    /// The hash of the plan to run.
    pub plan: String,
    /// The reproduction's identifier, if the client chose one.
    pub id: Option<ReproductionId>,
    /// The client's key for this start, if it sent one.
    pub key: Option<String>,
    /// Whether the arm moves only while somebody holds the button.
    pub hold: bool,
}

const LEFT_RUNNING: &str = "The server stopped while the arm was moving.";

/// Starts motions and writes down how they ended. Cheap to clone.
#[derive(Clone)]
pub struct Reproducer(Arc<Inner>);

struct Inner {
    tools: Tools,
    plans: Arc<Plans>,
    /// The last run; while it is locked nobody else starts one.
    last: Mutex<Option<JoinHandle<()>>>,
    /// The motion that moves only while the button is held, from its start on.
    held: std::sync::Mutex<Option<ReproductionId>>,
}

#[derive(Clone)]
struct Tools {
    store: Store,
    events: Events,
    clock: SharedClock,
    /// What the robot is called.
    name: Arc<str>,
    robot: Robot,
}

impl Tools {
    async fn finish(&self, id: ReproductionId, result: &ReproductionResult) {
        let now = self.clock.now();
        match self.store.finish_reproduction(id, result, now).await {
            Ok(reproduction) => self.events.tell(&reproduction),
            Err(error) => {
                tracing::error!(reproduction.id = %id, %error, "a reproduction could not be stored");
            }
        }
    }
}

impl Reproducer {
    /// A reproducer for this robot, which requests call `name`, and these plans.
    pub fn new(
        store: Store,
        events: Events,
        clock: SharedClock,
        name: &str,
        robot: Robot,
        plans: Arc<Plans>,
    ) -> Self {
        Self(Arc::new(Inner {
            tools: Tools {
                store,
                events,
                clock,
                name: name.into(),
                robot,
            },
            plans,
            last: Mutex::new(None),
            held: std::sync::Mutex::default(),
        }))
    }

    /// At start-up: motions that the last run left running have failed, whichever robot made
    /// them. Their records can be read up to where they end.
    pub async fn recover(&self) -> Result<u64, store::Error> {
        let tools = &self.0.tools;
        let mut found = 0;
        while let Some(left) = tools.store.any_running_reproduction().await? {
            let figures = match measured(&tools.store, left.id, Measure::default()).await {
                Ok(measure) => measure.broken(),
                Err(error) => {
                    tracing::error!(reproduction.id = %left.id, %error, "a flight record can't be read");
                    Figures::default()
                }
            };
            let end_us = tools.store.flight_end_us(left.id).await.ok().flatten();
            let interrupted = NewFlight {
                armed_at: None,
                cycles: &[],
                events: &[FlightEvent {
                    at_us: end_us.unwrap_or(0),
                    code: "interrupted".into(),
                    message: LEFT_RUNNING.into(),
                }],
            };
            tools.store.append_flight(left.id, interrupted).await?;
            let now = tools.clock.now();
            let result = failed(LEFT_RUNNING, figures);
            tools
                .store
                .finish_reproduction(left.id, &result, now)
                .await?;
            found += 1;
        }
        Ok(found)
    }

    /// Starts a motion, once: a start that is repeated returns the motion that it began.
    ///
    /// # Errors
    /// When the robot refuses; then the arm has not moved and nothing was stored.
    pub async fn start(&self, request: StartRequest) -> Result<Reproduction, ReproducingError> {
        let reproducer = self.clone();
        uninterrupted(async move { reproducer.begin(request).await }).await
    }

    async fn begin(&self, request: StartRequest) -> Result<Reproduction, ReproducingError> {
        let mut last = self.0.last.lock().await;
        if let Some(known) = self.known(&request).await? {
            // Robots that stand alike have the same plan, but each its own motion.
            let same = known.robot.as_deref() == Some(&*self.0.tools.name);
            return if same && known.plan == request.plan {
                Ok(known)
            } else {
                Err(ReproducingError::KeyReused)
            };
        }
        let plan = self.plan(&request.plan)?;
        let tools = &self.0.tools;
        let new = NewReproduction {
            id: request.id.unwrap_or_else(ReproductionId::new),
            task_id: plan.task_id,
            model_id: plan.model_id,
            robot: &tools.name,
            plan: &request.plan,
            start_deg: &plan.start.0,
            goal_deg: &plan.goal.0,
            duration_s: plan.plan.duration_s(),
            backwards: plan.backwards,
            idempotency_key: request.key.as_deref(),
        };
        // The row comes first, so that no motion can happen of which nothing is known.
        let reproduction = tools
            .store
            .create_reproduction(new, tools.clock.now())
            .await?;
        let run = Arc::clone(&plan.plan);
        let begun = if request.hold {
            tools.robot.run_while_held(run).await
        } else {
            tools.robot.run(run).await
        };
        match begun {
            Ok(handle) => {
                // Only now: a start that is refused must not let go of the motion that runs.
                self.set_held(request.hold.then_some(reproduction.id));
                tools.events.tell(&reproduction);
                let watch = watch(tools.clone(), reproduction.id, plan, handle);
                *last = Some(tokio::spawn(watch));
                Ok(reproduction)
            }
            Err(error) => {
                tools.store.withdraw_reproduction(reproduction.id).await?;
                Err(error.into())
            }
        }
    }

    /// Stops a motion and waits until its end is stored. One that has ended stays as it is.
    pub async fn stop(&self, id: ReproductionId) -> Result<Reproduction, ReproducingError> {
        let tools = &self.0.tools;
        let reproduction = tools.store.reproduction(id).await?;
        if reproduction.state != ReproductionState::Running {
            return Ok(reproduction);
        }
        tools.robot.stop();
        self.settled().await;
        Ok(tools.store.reproduction(id).await?)
    }

    /// Changes the speed of a running motion, pauses it, or lets it go on.
    ///
    /// # Errors
    /// When it does not run, or the speed is none.
    pub fn pace(
        &self,
        running: &Reproduction,
        speed: Option<f64>,
        paused: Option<bool>,
    ) -> Result<(), ReproducingError> {
        let tools = &self.0.tools;
        if running.state != ReproductionState::Running {
            return Err(RobotError::NotRunning.into());
        }
        if let Some(speed) = speed {
            tools.robot.set_speed(speed)?;
        }
        if let Some(paused) = paused {
            tools.robot.set_paused(paused)?;
        }
        Ok(())
    }

    /// Somebody holds the button for this motion at this moment.
    ///
    /// # Errors
    /// When another motion, or none, moves while it is held.
    pub fn hold(&self, id: ReproductionId) -> Result<(), ReproducingError> {
        let held = *self.0.held.lock().unwrap_or_else(PoisonError::into_inner);
        if held != Some(id) {
            return Err(ReproducingError::NotRunning);
        }
        Ok(self.0.tools.robot.hold()?)
    }

    fn set_held(&self, id: Option<ReproductionId>) {
        *self.0.held.lock().unwrap_or_else(PoisonError::into_inner) = id;
    }

    /// Plans the way back of a motion that is over.
    ///
    /// # Errors
    /// When it still runs, its plan is forgotten, or there is no way.
    pub async fn way_back(
        &self,
        stopped: &Reproduction,
        limits: RobotLimits,
    ) -> Result<Arc<KnownPlan>, ReproducingError> {
        let Inner { tools, plans, .. } = &*self.0;
        if stopped.state == ReproductionState::Running {
            let state = tools.robot.view().borrow().state;
            return Err(RobotError::Busy { state }.into());
        }
        let plan = plans
            .find(&stopped.plan, &tools.name)
            .ok_or(ReproducingError::PlanUnknown)?;
        let mut stopped_s = 0.0;
        let mut pages = tools.store.flight(stopped.id, Stretch::ALL);
        while let Some(cycles) = pages.next().await? {
            stopped_s = cycles.last().map_or(stopped_s, |cycle| cycle.plan_t_s);
        }
        let back = tokio::task::spawn_blocking(move || plan.back(stopped_s, &limits))
            .await
            .map_err(ReproducingError::Crashed)??;
        Ok(plans.remember(back))
    }

    /// Waits until the last motion's end is stored.
    pub async fn settled(&self) {
        let mut last = self.0.last.lock().await;
        if let Some(task) = last.take()
            && let Err(error) = task.await
        {
            tracing::error!(%error, "the end of a reproduction could not be stored");
        }
    }

    /// This robot's plan with this hash.
    fn plan(&self, hash: &str) -> Result<Arc<KnownPlan>, ReproducingError> {
        let (plans, robot) = (&self.0.plans, &self.0.tools.name);
        plans
            .find(hash, robot)
            .ok_or_else(|| match plans.robot_of(hash) {
                Some(of) => ReproducingError::OtherRobot {
                    of,
                    robot: robot.to_string(),
                },
                None => ReproducingError::PlanUnknown,
            })
    }

    async fn known(&self, request: &StartRequest) -> Result<Option<Reproduction>, store::Error> {
        let store = &self.0.tools.store;
        if let Some(id) = request.id {
            match store.reproduction(id).await {
                Err(store::Error::NotFound { .. }) => {}
                found => return found.map(Some),
            }
        }
        match &request.key {
            Some(key) => store.reproduction_by_key(key).await,
            None => Ok(None),
        }
    }
}

/// Keeps the record of a run while it goes on, waits for its end and stores what came of it.
async fn watch(tools: Tools, id: ReproductionId, plan: Arc<KnownPlan>, mut handle: RunHandle) {
    let mut keeper = Keeper::new(tools.store.clone(), Arc::clone(&tools.clock), id);
    while let Some(chunk) = handle.flight.recv().await {
        keeper.keep(chunk).await;
    }
    let end = match handle.outcome.await {
        Ok(RunOutcome { end, signals, rest }) => {
            keeper.finish(rest).await;
            keep_signals(&tools.store, id, signals).await;
            Some(end)
        }
        Err(_) => None,
    };
    let result = judge(&tools.store, id, plan, end)
        .await
        .unwrap_or_else(|error| {
            tracing::error!(reproduction.id = %id, %error, "a reproduction could not be judged");
            failed(
                "What came of the motion could not be worked out.",
                Figures::default(),
            )
        });
    tools.finish(id, &result).await;
}
