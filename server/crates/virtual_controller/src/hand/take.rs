//! One showing of a script, with what varies from showing to showing.
//!
//! A showing is a row of minimum-jerk movements from way-point to way-point. Each begins before the
//! one in front of it has ended, so that the hand passes its way-points without standing still; it
//! stands only where the script pauses. Pace, way-points, the bow of each movement, pauses, idle
//! time at both ends and a small tremor come from the seed: the same seed gives the same showing.

use std::f64::consts::TAU;

use motion::kinematics::tool0;
use motion::{JOINTS, JointAngles};
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

use super::bow::bow;
use super::script::{Script, WayPoint};
use motion::minimum_jerk;

/// Speed of the tool from way-point to way-point in an average showing, mm/s, before the time that
/// starting and stopping take; a showing's pace varies by the part given.
const TOOL_MM_S: f64 = 125.0;
const PACE_VARIATION: f64 = 0.15;
/// Fastest moment of the tool: a showing that would exceed it goes slower as a whole, mm/s.
const PEAK_TOOL_MM_S: f64 = 230.0;
/// Fastest joint, deg/s.
const PEAK_JOINT_DEG_S: f64 = 70.0;
/// How many millimetres of the tool's way a degree of a turning wrist counts as.
const TURN_MM_PER_DEG: f64 = 3.0;
/// Part of the shorter neighbour by which a movement begins early and ends late.
const OVERLAP: f64 = 0.5;
/// How much longer a movement takes for each of its ends that is at rest.
const REST_FACTOR: f64 = 1.25;
/// Standard deviation of a way-point: passed, paused at, and at the ends, deg.
const THROUGH_DEG: f64 = 1.2;
const PAUSE_DEG: f64 = 0.3;
const END_DEG: f64 = 0.6;
/// Standard deviation of the bow of a movement, deg.
const BOW_DEG: f64 = 1.0;
/// Shortest and longest pause and idle time, s.
const PAUSE_S: [f64; 2] = [0.4, 1.2];
/// The gripper is worked after this share of a pause.
const GRIP_SHARE: f64 = 0.3;
const IDLE_S: [f64; 2] = [0.5, 1.5];
/// Amplitude (deg) and frequency (Hz) of the tremor. A hand that stands still has none, because
/// the joints' friction holds the arm; it is fully there well above the speed given (deg/s).
const TREMOR_DEG: [f64; 2] = [0.02, 0.05];
const TREMOR_HZ: [f64; 2] = [4.0, 10.0];
const TREMOR_FROM_DEG_S: f64 = 4.0;
/// How the amplitude is spread over the waves of one joint.
const TREMOR_WAVES: [f64; 3] = [0.5, 0.3, 0.2];
/// Step in which the fastest moment is searched, s.
const SEARCH_STEP_S: f64 = 0.02;

/// One movement of the row.
#[derive(Clone, Copy, Debug)]
struct Movement {
    from_s: f64,
    duration_s: f64,
    way_deg: [f64; JOINTS],
    bow_deg: [f64; JOINTS],
}

#[derive(Clone, Copy, Debug)]
struct Wave {
    amplitude_deg: f64,
    frequency_hz: f64,
    phase: f64,
}

/// One showing of a script.
#[derive(Clone, Debug)]
pub struct Take {
    start: JointAngles,
    movements: Vec<Movement>,
    tremor: [[Wave; TREMOR_WAVES.len()]; JOINTS],
    duration_s: f64,
    /// When the gripper is closed (`true`) or opened, s.
    grips: Vec<(f64, bool)>,
}

impl Take {
    /// The showing of `script` that belongs to `seed`.
    #[must_use]
    pub fn new(script: Script, seed: u64) -> Self {
        let mut chance = Chance(Xoshiro256PlusPlus::seed_from_u64(seed));
        let way = script.way_points();
        let last = way.len() - 1;
        let points: Vec<[f64; JOINTS]> = (0..=last)
            .map(|index| {
                let deviation_deg = match (index, way[index].pause) {
                    (_, true) => PAUSE_DEG,
                    (index, false) if index == 0 || index == last => END_DEG,
                    _ => THROUGH_DEG,
                };
                way[index]
                    .joints_deg
                    .map(|angle| angle + deviation_deg * chance.normal())
            })
            .collect();
        let bows: Vec<[f64; JOINTS]> = (0..last)
            .map(|_| std::array::from_fn(|_| BOW_DEG * chance.normal()))
            .collect();
        let tremor = std::array::from_fn(|_| chance.tremor());
        let pace = chance.between([1.0 - PACE_VARIATION, 1.0 + PACE_VARIATION]);
        let stands: Vec<f64> = way
            .iter()
            .map(|point| {
                if point.pause {
                    chance.between(PAUSE_S)
                } else {
                    0.0
                }
            })
            .collect();
        let [idle_before_s, idle_after_s] = [chance.between(IDLE_S), chance.between(IDLE_S)];

        let mut take = Self {
            start: JointAngles(points[0]),
            movements: Vec::new(),
            tremor,
            duration_s: 0.0,
            grips: Vec::new(),
        };
        // First without standing, to see how fast the fastest moment is.
        take.lay_out(way, &points, &bows, 1.0 / pace, &vec![0.0; way.len()]);
        let slower = take.time_stretch().max(1.0);
        take.lay_out(way, &points, &bows, slower / pace, &stands);
        for movement in &mut take.movements {
            movement.from_s += idle_before_s;
        }
        for (at_s, _) in &mut take.grips {
            *at_s += idle_before_s;
        }
        take.duration_s += idle_before_s + idle_after_s;
        take
    }

    /// How long it takes, s.
    #[must_use]
    pub fn duration_s(&self) -> f64 {
        self.duration_s
    }

    /// When the gripper is closed (`true`) or opened, s, in order.
    #[must_use]
    pub fn grips(&self) -> &[(f64, bool)] {
        &self.grips
    }

    /// Where the arm is after `t_s`; held at both ends.
    #[must_use]
    pub fn at(&self, t_s: f64) -> JointAngles {
        let mut at = self.start.0;
        let mut speeds = [0.0; JOINTS];
        for movement in &self.movements {
            let s = (t_s - movement.from_s) / movement.duration_s;
            let (part, rate) = (minimum_jerk::share(s), minimum_jerk::slope(s));
            let bow = bow(s);
            for joint in 0..JOINTS {
                at[joint] += part * movement.way_deg[joint] + bow * movement.bow_deg[joint];
                speeds[joint] += rate * movement.way_deg[joint] / movement.duration_s;
            }
        }
        let square: f64 = speeds.iter().map(|speed| speed * speed).sum();
        let moving = square / (square + TREMOR_FROM_DEG_S * TREMOR_FROM_DEG_S);
        for (angle, waves) in at.iter_mut().zip(&self.tremor) {
            *angle += moving * waves.iter().map(|wave| wave.at(t_s)).sum::<f64>();
        }
        JointAngles(at)
    }

    /// Puts the movements in a row: a movement's time follows from its length, times `stretch`.
    fn lay_out(
        &mut self,
        way: &[WayPoint],
        points: &[[f64; JOINTS]],
        bows: &[[f64; JOINTS]],
        stretch: f64,
        stands_s: &[f64],
    ) {
        let last = points.len() - 1;
        let at_rest = |point: usize| point == 0 || point == last || way[point].pause;
        let factor = |point: usize| if at_rest(point) { REST_FACTOR } else { 1.0 };
        let lasts_s: Vec<f64> = (0..last)
            .map(|index| {
                let length_mm = length_mm(&points[index], &points[index + 1]);
                stretch * factor(index) * factor(index + 1) * length_mm / TOOL_MM_S
            })
            .collect();
        let overlap_s = |point: usize| {
            if at_rest(point) {
                0.0
            } else {
                OVERLAP * lasts_s[point - 1].min(lasts_s[point])
            }
        };
        let mut t_s = 0.0;
        self.movements.clear();
        self.grips.clear();
        for index in 0..last {
            let (before_s, after_s) = (overlap_s(index), overlap_s(index + 1));
            self.movements.push(Movement {
                from_s: t_s - before_s,
                duration_s: before_s + lasts_s[index] + after_s,
                way_deg: std::array::from_fn(|joint| {
                    points[index + 1][joint] - points[index][joint]
                }),
                bow_deg: bows[index],
            });
            if let Some(close) = way[index + 1].closes {
                let stood_s = GRIP_SHARE * stands_s[index + 1];
                self.grips.push((t_s + lasts_s[index] + stood_s, close));
            }
            t_s += lasts_s[index] + stands_s[index + 1];
        }
        self.duration_s = t_s;
    }

    /// By how much the time must be stretched for the fastest moment to be as fast as allowed.
    fn time_stretch(&self) -> f64 {
        let steps = (self.duration_s / SEARCH_STEP_S) as usize;
        let mut stretch: f64 = 0.0;
        let mut before = self.start;
        for step in 1..=steps {
            let now = self.at(step as f64 * SEARCH_STEP_S);
            let way_mm = tool0(&now).position.distance(&tool0(&before).position);
            stretch = stretch
                .max(way_mm / SEARCH_STEP_S / PEAK_TOOL_MM_S)
                .max(now.max_abs_difference(&before) / SEARCH_STEP_S / PEAK_JOINT_DEG_S);
            before = now;
        }
        stretch
    }
}

/// Length of a movement, mm: the tool's way, or what the turning of a joint counts as.
fn length_mm(from: &[f64; JOINTS], to: &[f64; JOINTS]) -> f64 {
    let (from, to) = (JointAngles(*from), JointAngles(*to));
    let way_mm = tool0(&from).position.distance(&tool0(&to).position);
    way_mm.max(TURN_MM_PER_DEG * from.max_abs_difference(&to))
}

impl Wave {
    fn at(&self, t_s: f64) -> f64 {
        self.amplitude_deg * (TAU * self.frequency_hz * t_s + self.phase).sin()
    }
}

/// The seeded source of everything that varies.
struct Chance(Xoshiro256PlusPlus);

impl Chance {
    /// Even between 0 (included) and 1 (not included).
    fn even(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * self.even()
    }

    /// Normal with deviation 1 (Box and Muller), cut at 2.5 so that no showing is wild.
    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.even()).ln()).sqrt();
        (radius * (TAU * self.even()).cos()).clamp(-2.5, 2.5)
    }

    fn tremor(&mut self) -> [Wave; TREMOR_WAVES.len()] {
        let amplitude_deg = self.between(TREMOR_DEG);
        TREMOR_WAVES.map(|share| Wave {
            amplitude_deg: amplitude_deg * share,
            frequency_hz: self.between(TREMOR_HZ),
            phase: TAU * self.even(),
        })
    }
}

#[cfg(test)]
mod tests;
