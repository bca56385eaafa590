//! One EGM session as the controller sees it: what it follows, and when it ends.

use egm::SequenceNumber;
use egm::codec;
use egm::messages::{EgmJoints, MciState, MessageType};
use motion::{JOINTS, JointAngles, JointVelocities};

use crate::arm::{Arm, OutOfRange, Reference};
use crate::config::{EgmSettings, StopMode};
use motion::minimum_jerk;

/// How long the last messages of a session go on after the arm stands, s.
const FAREWELL_S: f64 = 0.1;

/// Why guidance cannot go on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// No reference came in time.
    NoData,
    /// A reference, or the motion it causes, leaves a joint's range.
    OutOfRange(OutOfRange),
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    /// Feedback only; references are not read.
    Streaming,
    Guiding,
    /// Back to where the run began, without references.
    Returning {
        from: JointAngles,
        t_s: f64,
    },
    Ending {
        state: MciState,
        left_s: f64,
    },
}

/// A session.
#[derive(Clone, Debug)]
pub struct Session {
    /// Tells the sessions of one controller apart.
    pub id: u64,
    phase: Phase,
    start: JointAngles,
    next_sequence: SequenceNumber,
    reference: Option<Reference>,
    silent_s: f64,
    converged_s: f64,
    convergence_met: bool,
    load_percent: f64,
    targets: u32,
}

impl Session {
    /// A session that guides the arm, from where it is.
    #[must_use]
    pub fn guiding(id: u64, at: JointAngles) -> Self {
        Self {
            id,
            phase: Phase::Guiding,
            start: at,
            next_sequence: SequenceNumber(0),
            reference: None,
            silent_s: 0.0,
            converged_s: 0.0,
            convergence_met: false,
            load_percent: 0.0,
            targets: 0,
        }
    }

    /// A session that sends feedback and guides nothing.
    #[must_use]
    pub fn streaming(id: u64, at: JointAngles) -> Self {
        Self {
            phase: Phase::Streaming,
            ..Self::guiding(id, at)
        }
    }

    /// The number of the message that is to be sent now.
    pub fn take_sequence(&mut self) -> SequenceNumber {
        let number = self.next_sequence;
        self.next_sequence = number.next();
        number
    }

    /// State of the motion correction.
    #[must_use]
    pub fn state(&self) -> MciState {
        match self.phase {
            Phase::Streaming => MciState::Stopped,
            Phase::Guiding | Phase::Returning { .. } => MciState::Running,
            Phase::Ending { state, .. } => state,
        }
    }

    /// All joints are within the convergence window.
    #[must_use]
    pub fn convergence_met(&self) -> bool {
        self.convergence_met
    }

    /// How much of the arm's performance the latest reference needs, percent.
    #[must_use]
    pub fn load_percent(&self) -> f64 {
        self.load_percent
    }

    /// How often the target has changed.
    #[must_use]
    pub fn targets(&self) -> u32 {
        self.targets
    }

    /// References are followed.
    #[must_use]
    pub fn is_guiding(&self) -> bool {
        self.phase == Phase::Guiding
    }

    /// The session decides where the arm goes.
    #[must_use]
    pub fn moves_arm(&self) -> bool {
        matches!(self.phase, Phase::Guiding | Phase::Returning { .. })
    }

    /// Feedback only.
    #[must_use]
    pub fn is_streaming(&self) -> bool {
        self.phase == Phase::Streaming
    }

    /// The last message has been sent.
    #[must_use]
    pub fn is_over(&self) -> bool {
        matches!(self.phase, Phase::Ending { left_s, .. } if left_s <= 0.0)
    }

    /// Stops guiding: the messages go on with `state` for `for_s` and a little longer.
    pub fn end(&mut self, state: MciState, for_s: f64) {
        self.convergence_met = false;
        self.load_percent = 0.0;
        self.phase = Phase::Ending {
            state,
            left_s: for_s + FAREWELL_S,
        };
    }

    /// Ends the run as its instruction says: the arm holds, or goes back to the start.
    pub fn end_normally(&mut self, settings: &EgmSettings, arm: &Arm) {
        match settings.stop_mode {
            StopMode::Hold => self.end(MciState::Stopped, settings.ramp_s),
            StopMode::RampDown => {
                self.phase = Phase::Returning {
                    from: arm.planned(),
                    t_s: 0.0,
                };
            }
        }
    }

    /// One cycle: takes the datagram that came, if any, and moves the arm.
    ///
    /// `rest_s` is the time in which the arm comes to rest where the session does not move it.
    ///
    /// # Errors
    /// Why guidance ends; the session is not ended by this.
    pub fn cycle(
        &mut self,
        datagram: Option<&[u8]>,
        arm: &mut Arm,
        settings: &EgmSettings,
        rest_s: f64,
    ) -> Result<(), Failure> {
        match self.phase {
            Phase::Streaming => arm.come_to_rest(rest_s),
            Phase::Guiding => return self.guide(datagram, arm, settings),
            Phase::Returning { from, t_s } => self.go_back(from, t_s, arm, settings)?,
            Phase::Ending { state, left_s } => {
                arm.come_to_rest(rest_s);
                let left_s = left_s - settings.cycle_s;
                self.phase = Phase::Ending { state, left_s };
            }
        }
        Ok(())
    }

    fn guide(
        &mut self,
        datagram: Option<&[u8]>,
        arm: &mut Arm,
        settings: &EgmSettings,
    ) -> Result<(), Failure> {
        self.silent_s += settings.cycle_s;
        if let Some(reference) = datagram.and_then(read_reference) {
            self.silent_s = 0.0;
            self.targets += u32::from(self.reference != Some(reference));
            self.reference = Some(reference);
        }
        if self.silent_s > settings.comm_timeout_s {
            return Err(Failure::NoData);
        }
        let Some(reference) = self.reference else {
            arm.come_to_rest(settings.ramp_s);
            return Ok(());
        };
        self.load_percent = arm.follow(&reference).map_err(Failure::OutOfRange)?;
        self.convergence_met = reference
            .joints
            .is_some_and(|to| to.max_abs_difference(&arm.measured()) <= settings.convergence_deg);
        self.converged_s = if self.convergence_met {
            self.converged_s + settings.cycle_s
        } else {
            0.0
        };
        if self.converged_s >= settings.cond_time_s {
            self.end_normally(settings, arm);
        }
        Ok(())
    }

    fn go_back(
        &mut self,
        from: JointAngles,
        t_s: f64,
        arm: &mut Arm,
        settings: &EgmSettings,
    ) -> Result<(), Failure> {
        let t_s = t_s + settings.cycle_s;
        let s = t_s / settings.ramp_out_s;
        let (part, rate) = (minimum_jerk::share(s), minimum_jerk::slope(s));
        let way: [f64; JOINTS] = std::array::from_fn(|joint| self.start.0[joint] - from.0[joint]);
        let reference = Reference {
            joints: Some(JointAngles(std::array::from_fn(|joint| {
                from.0[joint] + part * way[joint]
            }))),
            velocities: JointVelocities(way.map(|way| rate * way / settings.ramp_out_s)),
        };
        arm.follow(&reference).map_err(Failure::OutOfRange)?;
        let arrived = self.start.max_abs_difference(&arm.planned()) <= settings.convergence_deg;
        if s >= 1.0 && arrived {
            self.end(MciState::Stopped, settings.ramp_s);
        } else {
            self.phase = Phase::Returning { from, t_s };
        }
        Ok(())
    }
}

/// The reference in a datagram; nothing when it is no position guidance or holds neither six
/// angles nor six speeds.
fn read_reference(datagram: &[u8]) -> Option<Reference> {
    let message = codec::decode_sensor(datagram).ok()?;
    if message.header?.mtype != Some(MessageType::Correction as i32) {
        return None;
    }
    let six = |joints: Option<EgmJoints>| <[f64; JOINTS]>::try_from(joints?.joints).ok();
    let joints = six(message.planned.and_then(|planned| planned.joints));
    let speeds = six(message.speed_ref.and_then(|speed| speed.joints));
    (joints.is_some() || speeds.is_some()).then(|| Reference {
        joints: joints.map(JointAngles),
        velocities: speeds.map_or(JointVelocities::ZERO, JointVelocities),
    })
}
