//! The virtual cell: where it connects, where the arm stands, and how its controller is set.

use std::net::{Ipv4Addr, SocketAddr};

use motion::JointAngles;
use motion::limits::RobotLimits;

use crate::error::Error;

/// What the arm does when an EGM run ends normally.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopMode {
    /// It stays where it is (`EGM_STOP_HOLD`).
    Hold,
    /// It goes back to where the run began (`EGM_STOP_RAMP_DOWN`).
    RampDown,
}

/// Whose messages the controller sends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MessageSet {
    /// RobotWare 7, all fields.
    #[default]
    RobotWare7,
    /// RobotWare 6.10 and later: the force in its old layout, nothing that RobotWare 7 added.
    RobotWare6,
    /// RobotWare 6 before 6.07: no times and no utilisation either. Its angles are degrees all the
    /// same, unlike those of some such controllers.
    EarlyRobotWare6,
}

/// The numbers of the EGM control law and of its supervision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EgmSettings {
    /// Period in which the controller sends and reads, s. Real hardware has 4.032 ms.
    pub cycle_s: f64,
    /// Proportional position gain k, 1/s (0 to 20).
    pub position_gain: f64,
    /// Bandwidth of the low-pass filter on the speed, Hz.
    pub low_pass_hz: f64,
    /// Largest joint speed EGM may cause, deg/s. The controller's own default is 1 deg/s, with
    /// which the arm creeps; the cell's RAPID program sets it high.
    pub max_speed_deviation_deg_s: f64,
    /// Half width of the convergence window of each joint, deg.
    pub convergence_deg: f64,
    /// How long the window must be fulfilled before the run ends by itself, s.
    pub cond_time_s: f64,
    /// How long the controller waits for a reference before it gives up, s.
    pub comm_timeout_s: f64,
    /// How long a stop of the program takes to bring the arm to rest, s.
    pub ramp_s: f64,
    /// What the arm does when the run ends normally.
    pub stop_mode: StopMode,
    /// How long `EGM_STOP_RAMP_DOWN` takes, s.
    pub ramp_out_s: f64,
    /// Cycles between the controller's reference and the arm being there.
    pub servo_delay_cycles: usize,
    /// Cycles from the start of the program to the first message.
    pub set_up_cycles: u32,
    /// The controller sends its position also when no program guides the arm.
    pub stream_when_idle: bool,
    /// Whose messages it sends.
    pub messages: MessageSet,
    /// Until its program has stopped once, the controller reports RAPID as undefined, as a real
    /// one can after a restart.
    pub rapid_undefined_at_first: bool,
}

impl Default for EgmSettings {
    fn default() -> Self {
        Self {
            cycle_s: 0.004_032,
            position_gain: 5.0,
            low_pass_hz: 20.0,
            max_speed_deviation_deg_s: 1000.0,
            convergence_deg: 0.5,
            cond_time_s: 600.0,
            comm_timeout_s: 1.0,
            ramp_s: 0.5,
            stop_mode: StopMode::Hold,
            ramp_out_s: 0.5,
            servo_delay_cycles: 2,
            set_up_cycles: 20,
            stream_when_idle: false,
            messages: MessageSet::RobotWare7,
            rapid_undefined_at_first: false,
        }
    }
}

/// Everything a virtual controller needs to start.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// Where the EGM server listens: the controller is the UDP client and sends there.
    pub egm_remote: SocketAddr,
    /// Where Robot Web Services listen; port 0 takes a free one.
    pub rws_listen: SocketAddr,
    /// Robot Web Services are served over HTTPS, with a certificate of the controller's own that
    /// no authority has signed, as real ones do.
    pub rws_https: bool,
    /// Joint angles at the start, deg.
    pub home: JointAngles,
    /// Name of the controller in `/rw/system`.
    pub name: String,
    /// EGM control law and supervision.
    pub egm: EgmSettings,
}

impl Config {
    /// A controller on this machine that sends EGM to `egm_remote` and serves RWS on a free port.
    #[must_use]
    pub fn new(egm_remote: SocketAddr) -> Self {
        Self {
            egm_remote,
            rws_listen: SocketAddr::from((Ipv4Addr::LOCALHOST, 0)),
            rws_https: false,
            home: JointAngles([0.0, 8.0, 24.0, 0.0, -45.0, 0.0]),
            name: "virtual_gofa".to_owned(),
            egm: EgmSettings::default(),
        }
    }
}

impl Config {
    /// Checks that the numbers make sense.
    ///
    /// # Errors
    /// [`Error::Config`] with the first entry that does not.
    pub fn check(&self) -> Result<(), Error> {
        let positive = "it must be larger than 0";
        let egm = &self.egm;
        let rules = [
            (
                "cycle_s",
                egm.cycle_s,
                egm.cycle_s > 0.0 && egm.cycle_s <= 1.0,
                "it must be in 0 to 1 s",
            ),
            (
                "position_gain",
                egm.position_gain,
                (0.0..=20.0).contains(&egm.position_gain),
                "it must be in 0 to 20 1/s",
            ),
            (
                "low_pass_hz",
                egm.low_pass_hz,
                egm.low_pass_hz > 0.0,
                positive,
            ),
            (
                "max_speed_deviation_deg_s",
                egm.max_speed_deviation_deg_s,
                egm.max_speed_deviation_deg_s > 0.0,
                positive,
            ),
            (
                "convergence_deg",
                egm.convergence_deg,
                egm.convergence_deg > 0.0,
                positive,
            ),
            (
                "cond_time_s",
                egm.cond_time_s,
                egm.cond_time_s > 0.0,
                positive,
            ),
            (
                "comm_timeout_s",
                egm.comm_timeout_s,
                egm.comm_timeout_s > 0.0,
                positive,
            ),
            ("ramp_s", egm.ramp_s, egm.ramp_s > 0.0, positive),
            ("ramp_out_s", egm.ramp_out_s, egm.ramp_out_s > 0.0, positive),
        ];
        for (key, value, holds, rule) in rules {
            if !holds {
                return Err(Error::Config { key, value, rule });
            }
        }
        match RobotLimits::gofa5().joint_out_of_range(&self.home) {
            None => Ok(()),
            Some(joint) => Err(Error::Config {
                key: "home",
                value: self.home.0[joint],
                rule: "each joint must be in its range",
            }),
        }
    }
}
