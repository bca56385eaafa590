//! The newest of everything that is known about the robot.

use crate::control_loop::LoopState;
use crate::guidance::HandActivity;
use crate::view::{EgmView, RobotView};
use motion::JointAngles;
use rws::{ControllerState, OperatingMode};
use std::time::Instant;

/// EGM counts as connected for this long after a message, µs.
const EGM_FRESH_US: u64 = 100_000;

/// What was seen last.
#[derive(Debug, Default)]
pub(super) struct Seen {
    /// Whether the web services answered the last question.
    pub connected: bool,
    /// When they answered last, µs of the program's time.
    pub answered_us: u64,
    pub controller: Option<ControllerState>,
    pub mode: Option<OperatingMode>,
    pub lead_through: Option<bool>,
    /// Answers to questions asked before do not tell about motors and lead-through.
    changed: Option<Instant>,
    joints: Option<(JointAngles, u64)>,
    hand: Option<HandActivity>,
    hand_since: Option<Instant>,
    control: LoopState,
}

impl Seen {
    /// The control thread's news.
    pub(super) fn see_loop(&mut self, state: &LoopState) {
        self.control = *state;
        if let (Some(joints), Some(at_us)) = (state.measured, state.last_arrival_us) {
            self.see_joints(joints, at_us);
        }
    }

    /// A pose measured at `at_us`; an older one than the one that is known is ignored.
    pub(super) fn see_joints(&mut self, joints: JointAngles, at_us: u64) {
        if self.joints.is_none_or(|(_, known_us)| at_us > known_us) {
            self.joints = Some((joints, at_us));
        }
    }

    /// We have just changed motors or lead-through ourselves: an answer that is still under way
    /// must not look like a change back.
    pub(super) fn change(&mut self, controller: Option<ControllerState>, lead_through: bool) {
        self.changed = Some(Instant::now());
        self.controller = controller;
        self.lead_through = Some(lead_through);
    }

    /// Whether an answer to a question asked at `asked` tells about motors and lead-through.
    pub(super) fn is_current(&self, asked: Instant) -> bool {
        self.changed.is_none_or(|changed| asked >= changed)
    }

    /// The hand was set going at `at`: answers to older questions do not count.
    pub(super) fn hand_moves(&mut self, at: Instant, activity: HandActivity) {
        self.hand_since = Some(at);
        self.hand = Some(activity);
    }

    /// What the hand does, as asked for at `asked`.
    pub(super) fn see_hand(&mut self, asked: Instant, activity: HandActivity) {
        if self.hand_since.is_none_or(|since| asked >= since) {
            self.hand = Some(activity);
        }
    }

    /// The pose and its age in µs.
    pub(super) fn joints(&self, now_us: u64) -> Option<(JointAngles, u64)> {
        self.joints
            .map(|(joints, at_us)| (joints, now_us.saturating_sub(at_us)))
    }

    /// Whether EGM messages arrive.
    pub(super) fn egm_is_fresh(&self, now_us: u64) -> bool {
        self.control
            .last_arrival_us
            .is_some_and(|at_us| now_us.saturating_sub(at_us) < EGM_FRESH_US)
    }

    /// What the control thread said last.
    pub(super) fn control(&self) -> &LoopState {
        &self.control
    }

    /// Fills in the view.
    pub(super) fn show(&self, view: &mut RobotView, now_us: u64) {
        if let Some((joints, age_us)) = self.joints(now_us) {
            view.joints_deg = Some(joints.0);
            view.tcp_mm = Some(motion::kinematics::tool0(&joints).position.0);
            view.age_ms = age_us / 1000;
        }
        view.motors_on = self
            .controller
            .as_ref()
            .map(|state| *state == ControllerState::MotorsOn);
        view.operating_mode = self.mode.as_ref().map(ToString::to_string);
        view.lead_through = self.lead_through;
        view.hand = self.hand;
        let counters = self.control.counters;
        view.egm = EgmView {
            connected: self.egm_is_fresh(now_us),
            cycles: counters.cycles,
            lost: counters.lost,
            late: counters.late,
            real_time: false,
        };
    }
}
