//! The checks of the signals that people may work on a robot.

use robot::{RobotConfig, RobotKind, SignalConfig};

use super::{Checked, OneRobot};
use crate::cell::file::SignalTable;

/// Longest name, as the store keeps it.
const LONGEST: usize = 64;

impl OneRobot<'_> {
    /// The signals of the file; without any, those that this kind of robot has by itself.
    pub(super) fn signals(&self, kind: RobotKind) -> Checked<Vec<SignalConfig>> {
        let mut signals: Vec<SignalConfig> = Vec::new();
        for table in &self.table.signal {
            let SignalTable {
                name,
                label,
                on,
                off,
            } = table.get_ref();
            let fits = |text: &str| {
                let length = text.trim().chars().count();
                (1..=LONGEST).contains(&length) && !text.chars().any(char::is_control)
            };
            let texts = [("name", name), ("label", label), ("on", on), ("off", off)];
            if let Some((field, _)) = texts.iter().find(|(_, text)| !fits(text)) {
                let what = format!("signal.{field} must have 1 to {LONGEST} characters");
                let advice = "write the controller's name of the signal, what people call it, and what setting and resetting it does, for example on = \"close\" and off = \"open\"";
                return Err(self.wrong(table, &format!("signal.{field}"), &what, advice));
            }
            if signals.iter().any(|known| known.name == *name) {
                let what = format!("the signal {name:?} is there twice");
                let advice = "name each signal once";
                return Err(self.wrong(table, "signal.name", &what, advice));
            }
            signals.push(SignalConfig {
                name: name.clone(),
                label: label.clone(),
                on: on.clone(),
                off: off.clone(),
            });
        }
        if signals.is_empty() {
            let nowhere = ([127, 0, 0, 1], 0).into();
            signals = RobotConfig::new(kind, nowhere).signals;
        }
        Ok(signals)
    }
}
