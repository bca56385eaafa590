//! What a fault script does to the datagrams of the EGM line.
//!
//! No sockets and no clock: a datagram and the time go in, and what arrives, and when, comes out.

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

use super::chance::{below, share};
use super::rewrite;
use super::script::{Direction, Fault, FaultScript, ScriptedFault};

/// Longest datagram of random bytes.
const MOST_GARBAGE_BYTES: u32 = 1_500;

/// A datagram that arrives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Delivery {
    /// When, µs.
    pub at_us: u64,
    /// How often the controller's port had changed when it was sent; to the robot always 0.
    pub port_changes: u32,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// Something the script does to the controller itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ControllerFault {
    /// A guard opens (`true`) or closes.
    GuardStop(bool),
    /// The controller restarts.
    Restart,
}

/// A fault of the script and how far it is.
#[derive(Clone, Debug)]
struct Entry {
    fault: ScriptedFault,
    /// How many of its beginnings have been seen by a fault that happens once, or is there a
    /// guard to be closed.
    seen: u64,
}

/// One direction of the line.
#[derive(Clone, Debug, Default)]
struct Way {
    /// When the latest datagram arrives, µs.
    latest_us: u64,
    /// The datagram before, as it was sent, and its number as it was seen.
    before: Option<Vec<u8>>,
    number_before: Option<u32>,
    /// Datagrams that let others overtake them: how many still, and what.
    held: Vec<(u32, Delivery)>,
}

/// The line with its faults.
#[derive(Clone, Debug)]
pub struct LinkFaults {
    entries: Vec<Entry>,
    random: Xoshiro256PlusPlus,
    began_us: Option<u64>,
    to_server: Way,
    to_robot: Way,
    port_changes: u32,
    /// What the controller's own count is ahead of the one that is sent.
    count_ahead: u32,
}

impl LinkFaults {
    /// A line with the faults of `script`, whose chances come from its seed.
    #[must_use]
    pub fn new(script: &FaultScript) -> Self {
        Self {
            entries: script
                .faults
                .iter()
                .map(|fault| Entry {
                    fault: *fault,
                    seen: 0,
                })
                .collect(),
            random: Xoshiro256PlusPlus::seed_from_u64(script.seed),
            began_us: None,
            to_server: Way::default(),
            to_robot: Way::default(),
            port_changes: 0,
            count_ahead: 0,
        }
    }

    /// A line without faults.
    #[must_use]
    pub fn none() -> Self {
        Self::new(&FaultScript::default())
    }

    /// Sends a datagram of the controller. The script's time begins with the first one.
    pub fn to_server(&mut self, now_us: u64, datagram: &[u8]) -> Vec<Delivery> {
        self.began_us.get_or_insert(now_us);
        let mut way = std::mem::take(&mut self.to_server);
        let deliveries = self.pass(&mut way, Direction::ToServer, now_us, datagram);
        self.to_server = way;
        deliveries
    }

    /// Sends a datagram of the server.
    pub fn to_robot(&mut self, now_us: u64, datagram: &[u8]) -> Vec<Delivery> {
        let mut way = std::mem::take(&mut self.to_robot);
        let deliveries = self.pass(&mut way, Direction::ToRobot, now_us, datagram);
        self.to_robot = way;
        deliveries
    }

    /// A new session of the controller counts from 0 by itself.
    pub fn session_began(&mut self) {
        self.count_ahead = 0;
    }

    /// What happens to the controller now; call it once per cycle.
    pub fn controller_faults(&mut self, now_us: u64) -> Vec<ControllerFault> {
        let Some(t_s) = self.t_s(now_us) else {
            return Vec::new();
        };
        let random = &mut self.random;
        let happens = |entry: &mut Entry| match entry.fault.fault {
            Fault::ControllerRestart => entry
                .begins(t_s, random)
                .then_some(ControllerFault::Restart),
            Fault::GuardStop => {
                let open = entry.fault.is_active(t_s);
                let changed = open != (entry.seen == 1);
                entry.seen = u64::from(open);
                changed.then_some(ControllerFault::GuardStop(open))
            }
            _ => None,
        };
        self.entries.iter_mut().filter_map(happens).collect()
    }

    /// How much too late the controller's next cycle is, µs.
    pub fn cycle_delay_us(&mut self, now_us: u64) -> u64 {
        let Some(t_s) = self.t_s(now_us) else {
            return 0;
        };
        let mut delay_s = 0.0;
        for entry in &self.entries {
            if let Fault::Jitter { spread_s } = entry.fault.fault
                && entry.fault.is_active(t_s)
                && share(&mut self.random) < entry.fault.share
            {
                delay_s += spread_s * share(&mut self.random);
            }
        }
        microseconds(delay_s)
    }

    fn t_s(&self, now_us: u64) -> Option<f64> {
        Some(now_us.saturating_sub(self.began_us?) as f64 * 1e-6)
    }

    fn pass(
        &mut self,
        way: &mut Way,
        direction: Direction,
        now_us: u64,
        datagram: &[u8],
    ) -> Vec<Delivery> {
        let fate = self.fate(direction, now_us, datagram);
        let mut bytes = datagram.to_vec();
        let before = way.before.replace(datagram.to_vec());
        if fate.repeated {
            bytes = before.unwrap_or(bytes);
        }
        self.renumber(way, direction, fate.same_number, &mut bytes);
        for (joint, angle_deg) in &fate.angles {
            rewrite::set_angle(&mut bytes, *joint, *angle_deg);
        }
        if fate.garbage {
            bytes = vec![0; below(&mut self.random, MOST_GARBAGE_BYTES) as usize];
            self.random.fill_bytes(&mut bytes);
        }
        if fate.cut {
            bytes.truncate(below(&mut self.random, bytes.len() as u32) as usize);
        }
        way.latest_us = way.latest_us.max(now_us + microseconds(fate.delay_s));
        let delivery = Delivery {
            at_us: way.latest_us,
            port_changes: match direction {
                Direction::ToRobot => 0,
                _ => self.port_changes,
            },
            bytes,
        };
        way.deliver(delivery, &fate)
    }

    /// Gives a message the number that the faults want it to have.
    fn renumber(
        &self,
        way: &mut Way,
        direction: Direction,
        same_number: bool,
        bytes: &mut Vec<u8>,
    ) {
        let own = rewrite::number(bytes, direction);
        let ahead = match direction {
            Direction::ToRobot => 0,
            _ => self.count_ahead,
        };
        let counted = own.map(|own| own.wrapping_sub(ahead));
        let wanted = way.number_before.filter(|_| same_number).or(counted);
        if let Some(number) = wanted.filter(|_| wanted != own) {
            rewrite::set_number(bytes, direction, number);
        }
        way.number_before = wanted.or(way.number_before);
    }

    /// What the script has in mind for a datagram.
    fn fate(&mut self, direction: Direction, now_us: u64, datagram: &[u8]) -> Fate {
        let mut fate = Fate::default();
        let Some(t_s) = self.t_s(now_us) else {
            return fate;
        };
        let random = &mut self.random;
        for entry in &mut self.entries {
            if entry.happens_once() {
                // A port is the sender's: whatever its direction, the fault is the controller's.
                if direction == Direction::ToServer && entry.begins(t_s, random) {
                    self.port_changes += 1;
                    if entry.fault.fault == Fault::CounterReset {
                        self.count_ahead = rewrite::number(datagram, direction).unwrap_or(0);
                    }
                }
                continue;
            }
            let concerns = [direction, Direction::Both].contains(&entry.fault.direction);
            if concerns && entry.fault.is_active(t_s) && share(random) < entry.fault.share {
                fate.meet(&entry.fault.fault, random);
            }
        }
        fate
    }
}

/// What is to happen to one datagram.
#[derive(Default)]
struct Fate {
    lost: bool,
    delay_s: f64,
    copies: u32,
    apart_s: f64,
    behind: u32,
    repeated: bool,
    same_number: bool,
    angles: Vec<(u32, f64)>,
    garbage: bool,
    cut: bool,
}

impl Fate {
    fn meet(&mut self, fault: &Fault, random: &mut Xoshiro256PlusPlus) {
        match *fault {
            Fault::Loss => self.lost = true,
            Fault::Delay { delay_s, spread_s } => {
                self.delay_s += delay_s + spread_s * share(random);
            }
            Fault::Duplicate { copies, apart_s } => {
                (self.copies, self.apart_s) = (copies, apart_s);
            }
            Fault::Reorder { behind } => self.behind = behind,
            Fault::Repeat => self.repeated = true,
            Fault::SameNumber => self.same_number = true,
            Fault::NotANumber { joint } => self.angles.push((joint, f64::NAN)),
            Fault::Angle { joint, angle_deg } => self.angles.push((joint, angle_deg)),
            Fault::Garbage => self.garbage = true,
            Fault::Cut => self.cut = true,
            // These are the controller's, not a datagram's.
            Fault::SourceChange
            | Fault::CounterReset
            | Fault::Jitter { .. }
            | Fault::GuardStop
            | Fault::ControllerRestart => {}
        }
    }
}

impl Way {
    /// The datagram with its copies, unless it is lost or held, and behind it those that have
    /// waited long enough.
    fn deliver(&mut self, delivery: Delivery, fate: &Fate) -> Vec<Delivery> {
        let mut arrive = Vec::new();
        let at_us = delivery.at_us;
        if !fate.lost && fate.behind == 0 {
            arrive.extend((0..=fate.copies).map(|copy| Delivery {
                at_us: at_us + microseconds(f64::from(copy) * fate.apart_s),
                ..delivery.clone()
            }));
        }
        self.held.retain_mut(|(left, held)| {
            *left -= 1;
            if *left == 0 {
                arrive.push(Delivery {
                    at_us,
                    ..held.clone()
                });
            }
            *left > 0
        });
        if !fate.lost && fate.behind > 0 {
            self.held.push((fate.behind, delivery));
        }
        arrive
    }
}

impl Entry {
    /// A fault of the datagrams' source that happens at a moment.
    fn happens_once(&self) -> bool {
        matches!(self.fault.fault, Fault::SourceChange | Fault::CounterReset)
    }

    /// Whether a fault that happens once does so now.
    fn begins(&mut self, t_s: f64, random: &mut Xoshiro256PlusPlus) -> bool {
        let beginnings = self.fault.beginnings(t_s);
        let begins = beginnings > self.seen;
        self.seen = beginnings;
        begins && share(random) < self.fault.share
    }
}

fn microseconds(seconds: f64) -> u64 {
    (seconds * 1e6).round() as u64
}

#[cfg(test)]
mod tests;
