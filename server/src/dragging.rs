//! Dragging the virtual arm with a finger while it is soft: who has no robot guides by hand all the
//! same.
//!
//! Targets come from a live socket, up to 60 a second; the newest counts. A task for each drag
//! moves [`motion::drag`] on and has the virtual hand lead the arm there. Not here: the
//! mathematics (`motion`), and what the hand does when nobody leads it any more
//! (`virtual_controller`).

use std::sync::Arc;
use std::time::Duration;

use motion::JointAngles;
use motion::drag::{Drag, Target};
use motion::limits::RobotLimits;
use robot::{HandActivity, HandCommand, Robot, RobotError, RobotKind, RobotState, RobotView};
use tokio::sync::{Mutex, mpsc, watch};
use tokio::time::{Instant, MissedTickBehavior, interval, timeout};

use crate::arms::Arm;
use crate::control::ControlError;

/// How often the hand hears where to lead the arm.
const TICK: Duration = Duration::from_millis(20);
/// After so much silence the next target is another attempt.
const SILENCE: Duration = Duration::from_secs(1);
/// Longest wait for a drag before that is ending.
const HANDOVER: Duration = Duration::from_millis(500);
/// Refusals that may wait to be sent; each attempt has one.
const REFUSALS: usize = 4;

/// Why the arm cannot be dragged, or no longer.
#[derive(Debug, thiserror::Error)]
pub enum DragError {
    /// Only a virtual arm has a hand that a server can lead.
    #[error("a real arm cannot be dragged on the screen")]
    RealArm,
    /// The virtual hand brings the arm somewhere or shows a script.
    #[error("the virtual hand is moving the arm")]
    HandBusy,
    /// Another socket drags it.
    #[error("somebody else is dragging the arm")]
    Taken,
    /// Another phone has the robot.
    #[error(transparent)]
    Control(#[from] ControlError),
    /// The arm is stiff, or does not answer.
    #[error(transparent)]
    Robot(#[from] RobotError),
}

/// Who drags an arm: one at a time.
#[derive(Clone, Default)]
pub struct DragSeat(Arc<Mutex<()>>);

/// The drags of one socket. Dropping it ends the present one.
pub struct Drags<'a> {
    arm: &'a Arm,
    refusals: mpsc::Sender<DragError>,
    attempt: Attempt,
}

enum Attempt {
    None,
    Dragging(watch::Sender<Target>),
    /// What else comes of it is ignored.
    Refused {
        last: Instant,
    },
}

impl<'a> Drags<'a> {
    /// No drag yet; each refused attempt is told to the receiver once.
    pub fn of(arm: &'a Arm) -> (Self, mpsc::Receiver<DragError>) {
        let (refusals, told) = mpsc::channel(REFUSALS);
        let drags = Self {
            arm,
            refusals,
            attempt: Attempt::None,
        };
        (drags, told)
    }

    /// A target; with the first one a drag begins, for which `claim` has to give control of the
    /// robot. Never waits.
    pub fn aim(&mut self, target: Target, claim: impl FnOnce() -> Result<(), ControlError>) {
        match &mut self.attempt {
            Attempt::Dragging(targets) => {
                if targets.send(target).is_err() {
                    // The task has ended it and said why.
                    let last = Instant::now();
                    self.attempt = Attempt::Refused { last };
                }
            }
            Attempt::Refused { last } if last.elapsed() < SILENCE => *last = Instant::now(),
            Attempt::None | Attempt::Refused { .. } => {
                self.attempt = match self.begin(target, claim) {
                    Ok(targets) => Attempt::Dragging(targets),
                    Err(error) => {
                        // Only a client that reads nothing misses it.
                        self.refusals.try_send(error).ok();
                        let last = Instant::now();
                        Attempt::Refused { last }
                    }
                };
            }
        }
    }

    /// The finger is lifted.
    pub fn end(&mut self) {
        self.attempt = Attempt::None;
    }

    fn begin(
        &self,
        target: Target,
        claim: impl FnOnce() -> Result<(), ControlError>,
    ) -> Result<watch::Sender<Target>, DragError> {
        let arm = self.arm;
        joints_of(&arm.robot.view().borrow())?;
        claim()?;
        let (targets, received) = watch::channel(target);
        let refusals = self.refusals.clone();
        let (robot, seat) = (arm.robot.clone(), Arc::clone(&arm.drag.0));
        let limits = with_whole_arm(&arm.limits);
        tokio::spawn(async move {
            if let Err(error) = lead(robot, seat, limits, received).await {
                refusals.try_send(error).ok();
            }
        });
        Ok(targets)
    }
}

/// The flange is what is dragged, so its speed is the one that counts.
fn with_whole_arm(limits: &RobotLimits) -> RobotLimits {
    RobotLimits {
        tool_mm: [0.0; 3],
        keep_out: Vec::new(),
        ..limits.clone()
    }
}

/// Where the arm stands, when it may be dragged.
fn joints_of(view: &RobotView) -> Result<JointAngles, DragError> {
    match view.kind {
        RobotKind::None => return Err(RobotError::NoRobot.into()),
        RobotKind::Gofa => return Err(DragError::RealArm),
        RobotKind::Virtual => {}
    }
    if view.state != RobotState::Guiding {
        return Err(RobotError::NotGuiding.into());
    }
    if matches!(
        view.hand,
        Some(HandActivity::Returning | HandActivity::Showing)
    ) {
        return Err(DragError::HandBusy);
    }
    let joints = view.joints_deg.map(JointAngles);
    joints.ok_or_else(|| RobotError::PoseUnknown.into())
}

/// Leads the arm until the sender of targets is dropped or the arm may not be dragged any more.
async fn lead(
    robot: Robot,
    seat: Arc<Mutex<()>>,
    limits: RobotLimits,
    mut targets: watch::Receiver<Target>,
) -> Result<(), DragError> {
    // A drag that was let go a moment ago may still be telling the hand so.
    let seat = timeout(HANDOVER, seat.lock()).await;
    let _seat = seat.map_err(|_| DragError::Taken)?;
    let view = robot.view();
    let mut drag = Drag::begin(joints_of(&view.borrow())?, &limits);
    drag.aim(&targets.borrow_and_update());
    let mut tick = interval(TICK);
    tick.set_missed_tick_behavior(MissedTickBehavior::Delay);
    let mut last = Instant::now();
    loop {
        if drag.is_at_rest() {
            // A finger that rests costs nothing.
            if targets.changed().await.is_err() {
                break;
            }
            targets.mark_changed();
            drag.resume(joints_of(&view.borrow())?);
            last = Instant::now();
        }
        tick.tick().await;
        match targets.has_changed() {
            Ok(true) => drag.aim(&targets.borrow_and_update()),
            Ok(false) => {}
            Err(_) => break,
        }
        joints_of(&view.borrow())?;
        let now = Instant::now();
        let joints = drag.advance((now - last).as_secs_f64());
        last = now;
        if let Err(error) = robot.virtual_hand(HandCommand::Lead(joints)).await {
            // The controller may know before the view that the arm has got stiff.
            joints_of(&view.borrow())?;
            return Err(if is_refusal(&error) {
                RobotError::NotGuiding.into()
            } else {
                error.into()
            });
        }
    }
    // The hand lets go by itself when this does not arrive.
    robot.virtual_hand(HandCommand::LetGo).await.ok();
    Ok(())
}

fn is_refusal(error: &RobotError) -> bool {
    matches!(error, RobotError::Controller(error) if !error.is_unreachable())
}
