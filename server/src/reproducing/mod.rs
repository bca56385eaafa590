//! Reproducing: a plan that was approved is run by the arm, and what came of it is stored.
//!
//! Not here: the motion itself (crate `robot`) and its approval (`planning`, `motion::gate`).

mod figures;

use std::sync::Arc;

use robot::{Robot, RobotError, RunEnd, RunHandle, RunOutcome};
use tokio::sync::Mutex;
use tokio::task::JoinHandle;

use crate::clock::SharedClock;
use crate::events::Events;
use crate::ids::ReproductionId;
use crate::plans::{KnownPlan, Plans};
use crate::store::reproductions::{
    NewReproduction, Reproduction, ReproductionResult, ReproductionState,
};
use crate::store::samples::Cycle;
use crate::store::{self, Store};
use crate::uninterrupted::uninterrupted;
use crate::words::sentence;
use figures::{Figures, MotionPart};

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
    /// The plan was made for another robot's pose and limits.
    #[error("this preview was made for the robot \"{of}\", not for \"{robot}\"")]
    OtherRobot {
        /// The robot that it was made for.
        of: String,
        /// The robot that was to run it.
        robot: String,
    },
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
        }))
    }

    /// At start-up: motions that the last run left running have failed, whichever robot made them.
    pub async fn recover(&self) -> Result<u64, store::Error> {
        let tools = &self.0.tools;
        let now = tools.clock.now();
        tools
            .store
            .fail_running_reproductions(LEFT_RUNNING, now)
            .await
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
            idempotency_key: request.key.as_deref(),
        };
        // The row comes first, so that no motion can happen of which nothing is known.
        let reproduction = tools
            .store
            .create_reproduction(new, tools.clock.now())
            .await?;
        match tools.robot.run(Arc::clone(&plan.plan)).await {
            Ok(handle) => {
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

/// Waits for the end of a run and stores what came of it.
async fn watch(tools: Tools, id: ReproductionId, plan: Arc<KnownPlan>, handle: RunHandle) {
    let outcome = handle.outcome.await.ok();
    let judged = tokio::task::spawn_blocking(move || judge(&plan, outcome)).await;
    let (result, cycles) = match judged {
        Ok(judged) => judged,
        Err(error) => {
            tracing::error!(reproduction.id = %id, %error, "a reproduction could not be judged");
            (
                failed("What came of the motion could not be worked out."),
                Vec::new(),
            )
        }
    };
    let now = tools.clock.now();
    match tools
        .store
        .finish_reproduction(id, &result, &cycles, now)
        .await
    {
        Ok(reproduction) => tools.events.tell(&reproduction),
        Err(error) => {
            tracing::error!(reproduction.id = %id, %error, "a reproduction could not be stored");
        }
    }
}

fn judge(plan: &KnownPlan, outcome: Option<RunOutcome>) -> (ReproductionResult, Vec<Cycle>) {
    let Some(outcome) = outcome else {
        return (failed("The connection to the arm was lost."), Vec::new());
    };
    let cycles: Vec<Cycle> = outcome
        .record
        .iter()
        .map(|cycle| Cycle {
            at_us: cycle.at_us,
            plan_t_s: cycle.plan_t_s,
            commanded_deg: cycle.commanded.0,
            measured_deg: cycle.measured.0,
        })
        .collect();
    let result = match outcome.end {
        RunEnd::Completed => {
            let part = MotionPart {
                begins_s: plan.plan.approach_s(),
                stretch: plan.stretch,
            };
            let learnt = plan.model.regression();
            let figures = figures::of_completed(&cycles, part, &plan.goal.0, &learnt);
            result(ReproductionState::Succeeded, None, figures)
        }
        RunEnd::Stopped => result(
            ReproductionState::Stopped,
            Some("It was stopped.".into()),
            figures::of_broken(&cycles),
        ),
        RunEnd::Failed(fault) => result(
            ReproductionState::Failed,
            Some(format!("{} {}", sentence(&fault.message), fault.advice)),
            figures::of_broken(&cycles),
        ),
    };
    (result, cycles)
}

fn failed(reason: &str) -> ReproductionResult {
    result(
        ReproductionState::Failed,
        Some(reason.into()),
        Figures::default(),
    )
}

fn result(
    state: ReproductionState,
    reason: Option<String>,
    figures: Figures,
) -> ReproductionResult {
    ReproductionResult {
        state,
        reason,
        e_j_deg: figures.e_j_deg,
        e_j_commanded_deg: figures.e_j_commanded_deg,
        gmcc: figures.gmcc,
        tracking_error_deg: figures.tracking_error_deg,
    }
}
