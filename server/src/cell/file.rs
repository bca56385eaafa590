//! The shape of the configuration file. What its values may be is in `check`.

use serde::Deserialize;
use serde::de::IgnoredAny;
use toml::Spanned;

/// The whole file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CellFile {
    #[serde(default)]
    pub robot: Vec<Spanned<RobotTable>>,
}

/// One `[[robot]]`. Everything may be missing here, so that the check can say what for.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RobotTable {
    pub id: Option<Spanned<String>>,
    pub name: Option<Spanned<String>>,
    pub kind: Option<Spanned<Kind>>,
    pub egm_listen: Option<Spanned<String>>,
    pub rws_url: Option<Spanned<String>>,
    pub rws_user: Option<Spanned<String>>,
    pub rws_password_file: Option<Spanned<String>>,
    pub rws_password_env: Option<Spanned<String>>,
    /// Known only to be refused: a password does not belong into this file.
    pub rws_password: Option<Spanned<IgnoredAny>>,
    pub rws_certificate_sha256: Option<Spanned<String>>,
    pub tcp_speed_mm_s: Option<Spanned<f64>>,
    pub joint_speed_deg_s: Option<Spanned<[f64; 6]>>,
    pub joint_acceleration_deg_s2: Option<Spanned<[f64; 6]>>,
    pub tool_mm: Option<Spanned<[f64; 3]>>,
    pub refused_wrist_angle_deg: Option<Spanned<f64>>,
    pub silence_limit_ms: Option<Spanned<u64>>,
    pub continuous_run: Option<bool>,
    #[serde(default)]
    pub keep_out: Vec<Spanned<KeepOutTable>>,
    #[serde(default)]
    pub signal: Vec<Spanned<SignalTable>>,
}

/// Which arm.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Kind {
    Gofa,
    Virtual,
}

/// One `[[robot.keep_out]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct KeepOutTable {
    pub name: String,
    pub min_mm: [f64; 3],
    pub max_mm: [f64; 3],
}

/// One `[[robot.signal]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SignalTable {
    pub name: String,
    pub label: String,
    pub on: String,
    pub off: String,
}
