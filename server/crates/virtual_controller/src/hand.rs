//! The virtual hand: a person who guides the arm while it is soft, by script or as somebody says.
//!
//! It brings the arm to the start of a script ([`Action::Return`]) or shows the script's task
//! ([`Action::Show`]), differently from seed to seed. The scripts are in [`script`], the variation
//! of one showing in [`take`]. What it does when somebody else leads it is in `lead`.

mod bow;
mod lead;
mod reach;
pub mod script;
pub mod take;

use lead::Lead;
use motion::minimum_jerk;
use motion::{JOINTS, JointAngles};
use reach::Reach;
use script::Script;
use take::Take;

/// Up to this distance from its start a take is entered while moving, deg; from farther away the
/// hand goes to the start first.
const ENTER_WITHIN_DEG: f64 = 1.0;
/// Over this time the distance to the take's start vanishes, s.
const ENTER_S: f64 = 1.5;

/// What the hand can be asked to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Bring the arm to where the take begins.
    Return,
    /// Show the take.
    Show,
}

/// What the hand is doing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Doing {
    /// `idle`, `returning`, `showing` or `leading`.
    pub state: &'static str,
    /// Time since this began, s.
    pub t_s: f64,
}

/// The hand and what it is doing.
#[derive(Clone, Debug, Default)]
pub struct Hand {
    motion: Option<Motion>,
    lead: Option<Lead>,
    t_s: f64,
    /// The other hand works the gripper: close or open it now.
    grips: Option<bool>,
}

#[derive(Clone, Debug)]
struct Motion {
    reach: Option<Reach>,
    take: Option<Take>,
    /// Where the arm was, less where the take begins, deg.
    offset: [f64; JOINTS],
}

impl Hand {
    /// Takes hold of the arm at `from` and begins; what it did before ends.
    pub fn begin(&mut self, action: Action, script: Script, seed: u64, from: JointAngles) {
        let take = Take::new(script, seed);
        let start = take.at(0.0);
        let near = from.max_abs_difference(&start) <= ENTER_WITHIN_DEG;
        self.t_s = 0.0;
        self.lead = None;
        // A take begins with an open gripper; a showing leaves it as it is until it comes to it.
        self.grips = match action {
            Action::Return => Some(false),
            Action::Show => None,
        };
        self.motion = Some(match action {
            Action::Return => Motion {
                reach: Some(Reach::new(from, start)),
                take: None,
                offset: [0.0; JOINTS],
            },
            Action::Show if near => Motion {
                reach: None,
                take: Some(take),
                offset: std::array::from_fn(|joint| from.0[joint] - start.0[joint]),
            },
            Action::Show => Motion {
                reach: Some(Reach::new(from, start)),
                take: Some(take),
                offset: [0.0; JOINTS],
            },
        });
    }

    /// Leads the arm, which is at `from`, to a place; what a script did before ends.
    pub fn lead(&mut self, to: JointAngles, from: JointAngles) {
        if self.lead.is_none() {
            self.let_go();
        }
        self.lead.get_or_insert_with(|| Lead::begin(from)).aim(to);
    }

    /// Leads the arm no longer: it comes to rest.
    pub fn end_lead(&mut self) {
        if let Some(lead) = &mut self.lead {
            lead.end();
        }
    }

    /// Lets go of the arm.
    pub fn let_go(&mut self) {
        *self = Self::default();
    }

    /// Moves on by `step_s` and returns where the arm is then; nothing while the hand rests.
    pub fn step(&mut self, step_s: f64) -> Option<JointAngles> {
        if let Some(lead) = &mut self.lead {
            let at = lead.step(step_s);
            self.t_s += step_s;
            if lead.is_over() {
                self.let_go();
            }
            return Some(at);
        }
        let motion = self.motion.as_ref()?;
        let before_s = self.t_s;
        self.t_s += step_s;
        let at = motion.at(self.t_s);
        self.grips = self.grips.or(motion.grips_between(before_s, self.t_s));
        if self.t_s >= motion.duration_s() {
            let grips = self.grips;
            self.let_go();
            self.grips = grips;
        }
        Some(at)
    }

    /// Whether the gripper is to be closed or opened now; asking takes the wish away.
    pub fn grips(&mut self) -> Option<bool> {
        self.grips.take()
    }

    /// What the hand is doing.
    #[must_use]
    pub fn doing(&self) -> Doing {
        Doing {
            state: match &self.motion {
                None if self.lead.is_some() => "leading",
                None => "idle",
                Some(Motion { take: None, .. }) => "returning",
                Some(_) => "showing",
            },
            t_s: self.t_s,
        }
    }
}

impl Motion {
    fn duration_s(&self) -> f64 {
        self.reach.as_ref().map_or(0.0, |reach| reach.duration_s())
            + self.take.as_ref().map_or(0.0, |take| take.duration_s())
    }

    /// The last thing done to the gripper after `from_s` and until `to_s`.
    fn grips_between(&self, from_s: f64, to_s: f64) -> Option<bool> {
        let reach_s = self.reach.as_ref().map_or(0.0, |reach| reach.duration_s());
        let grips = self.take.as_ref().map_or(&[][..], Take::grips);
        let mut past = grips.iter().rev();
        past.find(|(at_s, _)| (from_s..to_s).contains(&(at_s + reach_s)))
            .map(|(_, close)| *close)
    }

    fn at(&self, t_s: f64) -> JointAngles {
        let reach_s = self.reach.as_ref().map_or(0.0, |reach| reach.duration_s());
        match (&self.reach, &self.take) {
            (Some(reach), _) if t_s < reach_s => reach.at(t_s),
            (_, Some(take)) => {
                let left = 1.0 - minimum_jerk::share(t_s / ENTER_S);
                let at = take.at(t_s - reach_s);
                JointAngles(std::array::from_fn(|joint| {
                    at.0[joint] + self.offset[joint] * left
                }))
            }
            (Some(reach), None) => reach.at(t_s),
            (None, None) => JointAngles([f64::NAN; JOINTS]),
        }
    }
}
