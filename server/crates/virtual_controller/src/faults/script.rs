//! Faults by script: which faults the EGM line and its controller have, when, and for how long.
//!
//! Data alone; [`super::link`] does to datagrams what a script says. A script is JSON:
//!
//! ```json
//! {"seed": 7, "faults": [
//!   {"fault": "loss", "direction": "to_server", "from_s": 2, "for_s": 5, "share": 0.1},
//!   {"fault": {"delay": {"delay_s": 0.02, "spread_s": 0.01}}},
//!   {"fault": "guard_stop", "from_s": 30, "for_s": 1, "every_s": 60}
//! ]}
//! ```
//!
//! Its time begins with the first message that the controller sends after the script was loaded.

use motion::JOINTS;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use serde::{Deserialize, Serialize};

use super::chance::{below, pick, share};
use crate::error::Error;

/// Most copies that one datagram may be given, and most datagrams that one may be held behind.
const MOST: u32 = 100;

/// Which way a datagram goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Direction {
    /// From the controller to the EGM server.
    ToServer,
    /// From the EGM server to the controller.
    ToRobot,
    /// Either way.
    #[default]
    Both,
}

/// What goes wrong.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Fault {
    /// The datagram never arrives.
    Loss,
    /// The datagram arrives later; those behind it wait, so that the order stays.
    Delay {
        /// Time that each takes at least, s.
        delay_s: f64,
        /// Up to this much is added by chance, s.
        #[serde(default)]
        spread_s: f64,
    },
    /// The datagram arrives more than once.
    Duplicate {
        /// How many more.
        #[serde(default = "one")]
        copies: u32,
        /// Time between them, s.
        #[serde(default)]
        apart_s: f64,
    },
    /// The datagram arrives behind later ones.
    Reorder {
        /// How many of them.
        #[serde(default = "one")]
        behind: u32,
    },
    /// The datagram before it arrives again in its place.
    Repeat,
    /// The datagram has the number of the one before it, and its own content.
    SameNumber,
    /// A joint angle is NaN.
    NotANumber {
        /// Joint, from 1.
        #[serde(default = "one")]
        joint: u32,
    },
    /// A joint has an angle that it does not have.
    Angle {
        /// Joint, from 1.
        joint: u32,
        /// The angle, deg.
        angle_deg: f64,
    },
    /// Random bytes arrive in place of the datagram.
    Garbage,
    /// The datagram is cut at a random place.
    Cut,
    /// Once: from now on the controller sends from another port.
    SourceChange,
    /// Once: from now on the controller counts from 0 again, from another port, while the arm
    /// goes on; so does a program that sets EGM up anew.
    CounterReset,
    /// The controller's cycle comes too late by chance, without adding up.
    Jitter {
        /// By up to this much, s.
        spread_s: f64,
    },
    /// A guard is open as long as the fault lasts: the arm stops, its motors go off and stay off.
    GuardStop,
    /// Once: the controller restarts. Everything it did ends, and its counters begin anew.
    ControllerRestart,
}

/// One fault and when it is there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ScriptedFault {
    /// What goes wrong.
    pub fault: Fault,
    /// Which datagrams it concerns; the controller's own faults have no direction.
    #[serde(default)]
    pub direction: Direction,
    /// When it begins, s.
    #[serde(default)]
    pub from_s: f64,
    /// How long it lasts, s; without it to the end. What happens once does not last.
    #[serde(default)]
    pub for_s: Option<f64>,
    /// It comes again with this period, s.
    #[serde(default)]
    pub every_s: Option<f64>,
    /// Which part of the datagrams it concerns, 0 to 1; of what happens once, how likely it is.
    #[serde(default = "all")]
    pub share: f64,
}

/// Faults and the seed of everything in them that is left to chance.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FaultScript {
    /// The same seed makes the same faults of the same datagrams.
    #[serde(default)]
    pub seed: u64,
    /// The faults. Several can meet one datagram.
    pub faults: Vec<ScriptedFault>,
}

fn one() -> u32 {
    1
}

fn all() -> f64 {
    1.0
}

impl From<Fault> for ScriptedFault {
    /// The fault from the beginning to the end, on every datagram in both directions.
    fn from(fault: Fault) -> Self {
        Self {
            fault,
            direction: Direction::Both,
            from_s: 0.0,
            for_s: None,
            every_s: None,
            share: 1.0,
        }
    }
}

impl ScriptedFault {
    /// Whether the fault lasts at `t_s`.
    #[must_use]
    pub fn is_active(&self, t_s: f64) -> bool {
        let since_s = t_s - self.from_s;
        let within_s = match self.every_s {
            Some(every_s) => since_s.rem_euclid(every_s),
            None => since_s,
        };
        since_s >= 0.0 && self.for_s.is_none_or(|for_s| within_s < for_s)
    }

    /// How often the fault has begun up to `t_s`.
    #[must_use]
    pub fn beginnings(&self, t_s: f64) -> u64 {
        let since_s = t_s - self.from_s;
        match self.every_s {
            _ if since_s < 0.0 => 0,
            Some(every_s) => 1 + (since_s / every_s) as u64,
            None => 1,
        }
    }

    fn check(&self) -> Result<(), &'static str> {
        let time = |value: f64| value.is_finite() && value >= 0.0;
        let joint = |joint: u32| (1..=JOINTS as u32).contains(&joint);
        if !time(self.from_s) || !self.for_s.is_none_or(time) {
            return Err("from_s and for_s must be 0 s or more");
        }
        if !self.every_s.is_none_or(|every| time(every) && every > 0.0) {
            return Err("every_s must be more than 0 s");
        }
        if !(0.0..=1.0).contains(&self.share) {
            return Err("share must be in 0 to 1");
        }
        match self.fault {
            Fault::Delay { delay_s, spread_s } if !time(delay_s) || !time(spread_s) => {
                Err("delay_s and spread_s must be 0 s or more")
            }
            Fault::Duplicate { copies, apart_s } if copies > MOST || !time(apart_s) => {
                Err("copies must be at most 100, and apart_s 0 s or more")
            }
            Fault::Reorder { behind } if behind > MOST => Err("behind must be at most 100"),
            Fault::NotANumber { joint: number } | Fault::Angle { joint: number, .. }
                if !joint(number) =>
            {
                Err("joint must be in 1 to 6")
            }
            Fault::Angle { angle_deg, .. } if !angle_deg.is_finite() => {
                Err("angle_deg must be a number")
            }
            Fault::Jitter { spread_s } if !time(spread_s) => Err("spread_s must be 0 s or more"),
            _ => Ok(()),
        }
    }
}

impl FaultScript {
    /// Reads a script.
    ///
    /// # Errors
    /// [`Error::Script`] when the text is no script, [`Error::ScriptedFault`] with the first fault
    /// whose numbers make no sense.
    pub fn from_json(text: &str) -> Result<Self, Error> {
        let script: Self = serde_json::from_str(text).map_err(Error::Script)?;
        script.check()?;
        Ok(script)
    }

    /// Checks that the numbers make sense.
    ///
    /// # Errors
    /// [`Error::ScriptedFault`] with the first fault whose numbers do not.
    pub fn check(&self) -> Result<(), Error> {
        for (index, fault) in self.faults.iter().enumerate() {
            fault.check().map_err(|rule| Error::ScriptedFault {
                number: index + 1,
                rule,
            })?;
        }
        Ok(())
    }

    /// One to five faults of all kinds at random times within `duration_s`, for many different
    /// runs.
    #[must_use]
    pub fn random(seed: u64, duration_s: f64) -> Self {
        let random = &mut Xoshiro256PlusPlus::seed_from_u64(seed);
        let count = 1 + below(random, 5);
        let faults = (0..count)
            .map(|_| {
                let joint = 1 + below(random, JOINTS as u32);
                let kinds = [
                    Fault::Loss,
                    Fault::Delay {
                        delay_s: 0.05 * share(random),
                        spread_s: 0.05 * share(random),
                    },
                    Fault::Duplicate {
                        copies: 1 + below(random, 3),
                        apart_s: 0.02 * share(random),
                    },
                    Fault::Reorder {
                        behind: 1 + below(random, 5),
                    },
                    Fault::Repeat,
                    Fault::SameNumber,
                    Fault::NotANumber { joint },
                    Fault::Angle {
                        joint,
                        angle_deg: 1000.0 * (share(random) - 0.5),
                    },
                    Fault::Garbage,
                    Fault::Cut,
                    Fault::SourceChange,
                    Fault::CounterReset,
                    Fault::Jitter {
                        spread_s: 0.02 * share(random),
                    },
                    Fault::GuardStop,
                    Fault::ControllerRestart,
                ];
                let directions = [Direction::ToServer, Direction::ToRobot, Direction::Both];
                ScriptedFault {
                    fault: *pick(random, &kinds),
                    direction: *pick(random, &directions),
                    from_s: duration_s * share(random),
                    for_s: Some(duration_s * share(random).powi(2)),
                    every_s: None,
                    share: *pick(random, &[1.0, 0.5, 0.1, 0.02]),
                }
            })
            .collect();
        Self { seed, faults }
    }
}

#[cfg(test)]
mod tests;
