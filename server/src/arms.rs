//! The robots of the cell as everything else reaches them: each with its arm, its limits, its
//! recorder and its reproducer. Not here: how they are configured (`cell`) and started (`app`).

use std::sync::Arc;

use motion::limits::RobotLimits;
use robot::Robot;

use crate::control::Control;
use crate::dragging::DragSeat;
use crate::recording::Recorder;
use crate::reproducing::Reproducer;

/// A robot that has been started, before anything works with it.
pub struct StartedRobot {
    /// What requests call it.
    pub id: String,
    /// What people call it.
    pub name: String,
    /// What it may do.
    pub limits: RobotLimits,
    /// Whether it may move without anybody holding a button.
    pub continuous_run: bool,
    /// The robot.
    pub robot: Robot,
}

/// One robot of the cell with what works on it.
pub struct Arm {
    /// What requests call it.
    pub id: String,
    /// What people call it.
    pub name: String,
    /// What it may do.
    pub limits: RobotLimits,
    /// Whether it may move without anybody holding a button.
    pub continuous_run: bool,
    /// The robot.
    pub robot: Robot,
    /// Which phone may make it move.
    pub control: Control,
    /// Who drags it on a screen.
    pub drag: DragSeat,
    /// Begins and ends recordings from it.
    pub recorder: Recorder,
    /// Has it make motions.
    pub reproducer: Reproducer,
}

/// A request names a robot that is not there.
#[derive(Debug, thiserror::Error)]
#[error("there is no robot \"{asked}\"; there is {}", quoted(.known))]
pub struct UnknownRobot {
    /// What was asked for.
    pub asked: String,
    /// What there is.
    pub known: Vec<String>,
}

fn quoted(ids: &[String]) -> String {
    let quoted: Vec<String> = ids.iter().map(|id| format!("\"{id}\"")).collect();
    quoted.join(", ")
}

/// All robots, in the order of the configuration; at least one. Cheap to clone.
#[derive(Clone)]
pub struct Arms(Arc<[Arm]>);

impl Arms {
    /// The robots of a cell.
    ///
    /// # Panics
    /// Without a robot: a configuration without one is refused long before.
    pub fn new(arms: Vec<Arm>) -> Self {
        assert!(!arms.is_empty(), "a cell has at least one robot");
        Self(arms.into())
    }

    /// Every robot.
    pub fn all(&self) -> &[Arm] {
        &self.0
    }

    /// The robot with this identifier; the first one when none is named.
    ///
    /// # Errors
    /// When there is no such robot.
    pub fn named(&self, id: Option<&str>) -> Result<&Arm, UnknownRobot> {
        let Some(id) = id else {
            return Ok(&self.0[0]);
        };
        let found = self.0.iter().find(|arm| arm.id == id);
        found.ok_or_else(|| UnknownRobot {
            asked: id.to_owned(),
            known: self.0.iter().map(|arm| arm.id.clone()).collect(),
        })
    }

    /// The robot of something that is stored. What was made by a robot that is not configured any
    /// more has ended, and any robot can say so.
    pub fn that_made(&self, robot: Option<&str>) -> &Arm {
        self.named(robot).unwrap_or(&self.0[0])
    }
}
