//! The checks of a configuration file: from its tables to settings, or to what is wrong with it.

mod controller;
mod signals;

use std::collections::HashMap;
use std::net::{Ipv4Addr, SocketAddr};
use std::ops::Range;
use std::path::Path;
use std::time::Duration;

use motion::limits::RobotLimits;
use robot::{RobotConfig, RobotKind};
use toml::Spanned;

use super::file::{CellFile, KeepOutTable, Kind, RobotTable};
use super::{CellError, RobotSettings};
use motion::keep_out::KeepOut;

/// The arm's own speed at the tool, in millimetres per second.
const FASTEST_TOOL_MM_S: f64 = 2_200.0;
/// Longest distance of a tool's point from the flange, mm.
const LONGEST_TOOL_MM: f64 = 1_000.0;
/// Words of the interface that a robot can't be called.
const RESERVED: [&str; 1] = ["stop"];
const SEE_DOCS: &str = "docs/cell.md lists every key with its unit";

type Checked<T> = Result<T, CellError>;

/// A file's text, and what its words are about.
pub(super) struct Source<'a> {
    file: &'a Path,
    text: &'a str,
    environment: &'a dyn Fn(&str) -> Option<String>,
}

impl<'a> Source<'a> {
    pub(super) fn new(
        file: &'a Path,
        text: &'a str,
        environment: &'a dyn Fn(&str) -> Option<String>,
    ) -> Self {
        Self {
            file,
            text,
            environment,
        }
    }

    fn wrong(&self, at: Range<usize>, field: &str, what: &str, advice: &str) -> CellError {
        let before = self.text.get(..at.start).unwrap_or(self.text);
        CellError::Wrong {
            file: self.file.to_owned(),
            line: before.matches('\n').count() + 1,
            field: field.to_owned(),
            what: what.to_owned(),
            advice: advice.to_owned(),
        }
    }

    /// What the parser says, without the line itself: it could hold a password.
    fn unreadable(&self, error: &toml::de::Error) -> CellError {
        let at = error.span().unwrap_or_default();
        let begin = self.text[..at.start].rfind('\n').map_or(0, |end| end + 1);
        let line = self.text[begin..].lines().next().unwrap_or_default();
        let key = line.split_once('=').map_or("", |(key, _)| key.trim());
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let field = if key.chars().all(plain) { key } else { "" };
        let what = error.message().lines().collect::<Vec<_>>().join(", ");
        self.wrong(at, field, &what, SEE_DOCS)
    }
}

/// The robots of a file.
pub(super) fn robots(source: &Source<'_>) -> Checked<Vec<RobotSettings>> {
    let file: CellFile = toml::from_str(source.text).map_err(|e| source.unreadable(&e))?;
    if file.robot.is_empty() {
        return Err(source.wrong(
            0..0,
            "robot",
            "there is no robot in it",
            "add a [[robot]], or start without --config",
        ));
    }
    let mut robots: Vec<RobotSettings> = Vec::new();
    let mut ports: HashMap<u16, String> = HashMap::new();
    for table in file.robot {
        let at = table.span();
        let table = table.into_inner();
        let (id_at, egm_at) = (span(&table.id, &at), span(&table.egm_listen, &at));
        let settings = OneRobot { source, at, table }.settings()?;
        let id = &settings.id;
        if robots.iter().any(|known| known.id == *id) {
            let what = format!("\"{id}\" is already another robot's id");
            return Err(source.wrong(id_at, "id", &what, "give each robot an id of its own"));
        }
        let port = settings.egm_listen.port();
        // Port 0 is any free one.
        if port != 0
            && let Some(other) = ports.insert(port, id.clone())
        {
            let what = format!("port {port} is already the one of robot \"{other}\"");
            let advice = "give each robot a port of its own, and set it in its controller too";
            return Err(source.wrong(egm_at, "egm_listen", &what, advice));
        }
        robots.push(settings);
    }
    Ok(robots)
}

fn span<T>(field: &Option<Spanned<T>>, table: &Range<usize>) -> Range<usize> {
    field.as_ref().map_or(table.clone(), Spanned::span)
}

/// One robot's table on its way to settings.
struct OneRobot<'a> {
    source: &'a Source<'a>,
    at: Range<usize>,
    table: RobotTable,
}

impl OneRobot<'_> {
    fn settings(self) -> Checked<RobotSettings> {
        let id = self.id()?;
        let kind = match self
            .needed(
                &self.table.kind,
                "kind",
                "write kind = \"gofa\" or kind = \"virtual\"",
            )?
            .get_ref()
        {
            Kind::Gofa => RobotKind::Gofa,
            Kind::Virtual => RobotKind::Virtual,
        };
        let egm_listen = self.egm_listen(kind)?;
        Ok(RobotSettings {
            name: self.name(&id)?,
            kind,
            egm_listen,
            controller: self.controller(kind)?,
            limits: self.limits()?,
            // On a real arm somebody has to allow it in writing.
            continuous_run: (self.table.continuous_run).unwrap_or(kind == RobotKind::Virtual),
            signals: self.signals(kind)?,
            silence: self.silence(RobotConfig::new(kind, egm_listen).silence)?,
            id,
        })
    }

    fn wrong<T>(&self, field: &Spanned<T>, name: &str, what: &str, advice: &str) -> CellError {
        self.source.wrong(field.span(), name, what, advice)
    }

    fn needed<'t, T>(
        &self,
        field: &'t Option<Spanned<T>>,
        name: &str,
        advice: &str,
    ) -> Checked<&'t Spanned<T>> {
        field.as_ref().ok_or_else(|| {
            let robot = match &self.table.id {
                Some(id) => format!("robot \"{}\" has no {name}", id.get_ref()),
                None => format!("this robot has no {name}"),
            };
            self.source.wrong(self.at.clone(), name, &robot, advice)
        })
    }

    fn id(&self) -> Checked<String> {
        let form =
            "write 1 to 32 lower-case letters, digits and hyphens, for example id = \"left\"";
        let id = self.needed(&self.table.id, "id", form)?;
        let text = id.get_ref();
        let known = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        if !(1..=32).contains(&text.len()) || !text.chars().all(known) {
            return Err(self.wrong(id, "id", &format!("{text:?} can't be an id"), form));
        }
        if RESERVED.contains(&text.as_str()) {
            let what = format!("\"{text}\" is a word of the interface");
            return Err(self.wrong(id, "id", &what, "choose another id"));
        }
        Ok(text.clone())
    }

    fn name(&self, id: &str) -> Checked<String> {
        let Some(name) = &self.table.name else {
            return Ok(id.to_owned());
        };
        let text = name.get_ref().trim();
        if !(1..=60).contains(&text.chars().count()) || text.chars().any(char::is_control) {
            let advice = "write 1 to 60 characters that people know the robot by";
            return Err(self.wrong(name, "name", "this can't be a name", advice));
        }
        Ok(text.to_owned())
    }

    fn egm_listen(&self, kind: RobotKind) -> Checked<SocketAddr> {
        const FORM: &str = "write the address and UDP port on which this computer awaits the robot, for example egm_listen = \"0.0.0.0:6511\"";
        if kind == RobotKind::Virtual && self.table.egm_listen.is_none() {
            return Ok(SocketAddr::from((Ipv4Addr::LOCALHOST, 0)));
        }
        let field = self.needed(&self.table.egm_listen, "egm_listen", FORM)?;
        let address: SocketAddr = field.get_ref().parse().map_err(|_| {
            self.wrong(
                field,
                "egm_listen",
                "this is not an address with a port",
                FORM,
            )
        })?;
        if kind == RobotKind::Gofa && address.port() == 0 {
            let what = "port 0 is any free one, and the robot would not find it";
            return Err(self.wrong(field, "egm_listen", what, FORM));
        }
        if kind == RobotKind::Virtual && !address.ip().is_loopback() {
            let what = "a virtual robot is on this computer";
            let advice = "write 127.0.0.1 and the port, or leave it out";
            return Err(self.wrong(field, "egm_listen", what, advice));
        }
        Ok(address)
    }

    fn limits(&self) -> Checked<RobotLimits> {
        let mut limits = RobotLimits::gofa5();
        if let Some(field) = &self.table.tcp_speed_mm_s {
            let speed = *field.get_ref();
            if !(speed > 0.0 && speed <= FASTEST_TOOL_MM_S) {
                let what = format!("{speed} mm/s is not above 0 and up to {FASTEST_TOOL_MM_S}");
                let advice = "write the speed in mm/s that the cell's risk assessment allows";
                return Err(self.wrong(field, "tcp_speed_mm_s", &what, advice));
            }
            limits.tcp_speed_mm_s = speed;
        }
        let lower = |field: &Option<Spanned<[f64; 6]>>, name: &str, own: &mut [f64; 6]| {
            let Some(field) = field else { return Ok(()) };
            for (joint, (wish, own)) in field.get_ref().iter().zip(own).enumerate() {
                if !(*wish > 0.0 && wish <= own) {
                    let what = format!(
                        "{wish} for joint {} is not above 0 and up to {own}, the arm's own limit",
                        joint + 1
                    );
                    return Err(self.wrong(field, name, &what, "limits can only be made lower"));
                }
                *own = *wish;
            }
            Ok(())
        };
        let table = &self.table;
        lower(
            &table.joint_speed_deg_s,
            "joint_speed_deg_s",
            &mut limits.joint_speed_deg_s,
        )?;
        lower(
            &table.joint_acceleration_deg_s2,
            "joint_acceleration_deg_s2",
            &mut limits.joint_acceleration_deg_s2,
        )?;
        if let Some(field) = &table.tool_mm {
            let reach = field.get_ref().iter().map(|mm| mm * mm).sum::<f64>().sqrt();
            if !(0.0..=LONGEST_TOOL_MM).contains(&reach) {
                let advice = "write x, y and z of the tool's point from the flange, in mm";
                return Err(self.wrong(field, "tool_mm", "no tool is that long", advice));
            }
            limits.tool_mm = *field.get_ref();
        }
        if let Some(field) = &table.refused_wrist_angle_deg {
            let angle = *field.get_ref();
            if !(0.0..=45.0).contains(&angle) {
                let what = format!("{angle}° is not in 0 to 45");
                let advice = "write how far joint 5 has to stay from 0°, in degrees";
                return Err(self.wrong(field, "refused_wrist_angle_deg", &what, advice));
            }
            limits.refused_wrist_angle_deg = angle;
        }
        limits.keep_out = self.keep_out()?;
        Ok(limits)
    }

    fn silence(&self, default: Duration) -> Checked<Duration> {
        let Some(field) = &self.table.silence_limit_ms else {
            return Ok(default);
        };
        let ms = *field.get_ref();
        if !(20..=1_000).contains(&ms) {
            let what = format!("{ms} ms is not in 20 to 1000");
            let advice = "write after how many milliseconds without a message a motion has failed";
            return Err(self.wrong(field, "silence_limit_ms", &what, advice));
        }
        Ok(Duration::from_millis(ms))
    }

    fn keep_out(&self) -> Checked<Vec<KeepOut>> {
        let mut boxes: Vec<KeepOut> = Vec::new();
        for table in &self.table.keep_out {
            let KeepOutTable {
                name,
                min_mm,
                max_mm,
            } = table.get_ref();
            let wrong = |field: &str, what: &str, advice: &str| {
                self.wrong(table, &format!("keep_out.{field}"), what, advice)
            };
            if name.trim().is_empty() || boxes.iter().any(|known| known.name == *name) {
                let advice =
                    "give each box a name of its own; it is shown when a motion is refused";
                return Err(wrong("name", "this can't be a box's name", advice));
            }
            let ordered = (0..3).all(|axis| {
                min_mm[axis].is_finite() && max_mm[axis].is_finite() && min_mm[axis] < max_mm[axis]
            });
            if !ordered {
                let what = format!("the box {name:?} has no inside");
                return Err(wrong(
                    "min_mm",
                    &what,
                    "each number of min_mm must be below the one of max_mm",
                ));
            }
            boxes.push(KeepOut {
                name: name.clone(),
                min_mm: *min_mm,
                max_mm: *max_mm,
            });
        }
        Ok(boxes)
    }
}
