//! The plans that were previewed and may be run: the latest few of each robot, in memory.
//!
//! A plan is worth little after a restart, because the arm may have been moved; so nothing is
//! stored, and a client previews again.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use motion::JointAngles;
use motion::gate::Inspection;
use motion::limits::RobotLimits;
use motion::plan::Plan;

use crate::ids::{ModelId, TaskId};
use crate::planning::{self, PlanError, PlanRequest, Warning};

/// How many plans of one robot are remembered.
const REMEMBERED: usize = 32;
/// How many samples they may have together: about 20 MB.
const SAMPLES: usize = 200_000;

/// A previewed motion with where it comes from.
pub struct KnownPlan {
    /// The robot whose pose and limits it was made for.
    pub robot: String,
    /// What is to be reproduced.
    pub task_id: TaskId,
    /// By which model.
    pub model_id: ModelId,
    /// The model, for comparing the outcome with what was learnt.
    pub model: learning::Model,
    /// The samples that the gate approved.
    pub plan: Arc<Plan>,
    /// Where the motion proper begins.
    pub start: JointAngles,
    /// Where it ends.
    pub goal: JointAngles,
    /// It leads back along another plan, so that there is nothing learnt to compare it with.
    pub backwards: bool,
    /// How many times slower than asked for the limits made it.
    pub slowed_by: f64,
    /// How many times slower than taught it is.
    pub stretch: f64,
    /// What the gate saw.
    pub inspection: Inspection,
    /// Remarks for people.
    pub warnings: Vec<Warning>,
}

impl KnownPlan {
    /// Plans a motion for the robot with these limits. CPU-heavy: not for the async threads.
    ///
    /// # Errors
    /// When the motion is not allowed.
    pub fn make(
        robot: &str,
        limits: &RobotLimits,
        task_id: TaskId,
        model_id: ModelId,
        model: learning::Model,
        request: &PlanRequest,
        present: Option<JointAngles>,
    ) -> Result<Self, PlanError> {
        let motion = planning::plan(&model, request, present, limits)?;
        Ok(Self {
            robot: robot.to_owned(),
            task_id,
            model_id,
            model,
            plan: Arc::new(motion.plan),
            start: motion.start,
            goal: motion.goal,
            backwards: false,
            slowed_by: motion.slowed_by,
            stretch: motion.stretch,
            inspection: motion.inspection,
            warnings: motion.warnings,
        })
    }

    /// The way back of an arm that stopped at `stopped_s` of this plan. CPU-heavy.
    ///
    /// # Errors
    /// When there is none.
    pub fn back(&self, stopped_s: f64, limits: &RobotLimits) -> Result<Self, PlanError> {
        let (plan, inspection) = planning::back(&self.plan, stopped_s, limits)?;
        Ok(Self {
            robot: self.robot.clone(),
            task_id: self.task_id,
            model_id: self.model_id,
            model: self.model.clone(),
            start: plan.first(),
            goal: plan.last(),
            plan: Arc::new(plan),
            backwards: true,
            slowed_by: 1.0,
            stretch: self.stretch,
            inspection,
            warnings: Vec::new(),
        })
    }
}

/// The latest plans by their hash.
#[derive(Default)]
pub struct Plans(Mutex<VecDeque<Arc<KnownPlan>>>);

impl Plans {
    /// Remembers a plan; the oldest ones beyond the limits are forgotten.
    pub fn remember(&self, plan: KnownPlan) -> Arc<KnownPlan> {
        let plan = Arc::new(plan);
        let mut plans = self.lock();
        // Two robots that stand alike may have the very same motion.
        plans.retain(|known| known.robot != plan.robot || known.plan.hash() != plan.plan.hash());
        plans.push_back(Arc::clone(&plan));
        while too_many(&plans, &plan.robot) {
            let oldest = plans.iter().position(|known| known.robot == plan.robot);
            oldest.and_then(|index| plans.remove(index));
        }
        plan
    }

    /// This robot's plan with this hash.
    pub fn find(&self, hash: &str, robot: &str) -> Option<Arc<KnownPlan>> {
        let plans = self.lock();
        plans
            .iter()
            .find(|known| known.robot == robot && known.plan.hash() == hash)
            .map(Arc::clone)
    }

    /// The robot that a plan with this hash was made for.
    pub fn robot_of(&self, hash: &str) -> Option<String> {
        let plans = self.lock();
        plans
            .iter()
            .find(|known| known.plan.hash() == hash)
            .map(|known| known.robot.clone())
    }

    fn lock(&self) -> MutexGuard<'_, VecDeque<Arc<KnownPlan>>> {
        // The list is valid after every single operation, so a panic elsewhere can't spoil it.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Whether one of this robot's plans has to go. The latest one stays, however long it is.
fn too_many(plans: &VecDeque<Arc<KnownPlan>>, robot: &str) -> bool {
    let own = || plans.iter().filter(|known| known.robot == robot);
    let samples: usize = own().map(|known| known.plan.samples().len()).sum();
    let count = own().count();
    count > 1 && (count > REMEMBERED || samples > SAMPLES)
}
