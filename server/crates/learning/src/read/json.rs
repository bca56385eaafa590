//! The two JSON forms: columns by position as the paper's recorder wrote them,
//! and our own with named, unit-carrying fields.

use serde::{
    Deserialize, Deserializer,
    de::{MapAccess, Visitor},
};

use crate::{Demonstration, Error, SignalEvent};

/// Marks our own files.
pub const FORMAT: &str = "team-demonstration";

/// Our own form: `{"format": "team-demonstration", "version": 1, "t_s": [n],
/// "joints_deg": [n][d], "tcp_mm": [n][3] (optional),
/// "signals": [{"name": "GripperClose", "at_s": 1.5, "on": true}] (optional)}`.
#[derive(Deserialize)]
struct Own {
    version: u32,
    t_s: Vec<f64>,
    joints_deg: Vec<Vec<f64>>,
    #[serde(default)]
    tcp_mm: Option<Vec<[f64; 3]>>,
    #[serde(default)]
    signals: Vec<SignalEvent>,
}

/// Columns in the order of the file. The paper's recordings are read by position:
/// first time (s), then TCP x, y, z (mm), last the joints (deg).
struct Columns(Vec<(String, serde_json::Value)>);

impl<'de> Deserialize<'de> for Columns {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Ordered;
        impl<'de> Visitor<'de> for Ordered {
            type Value = Columns;
            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("an object of columns")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Columns, A::Error> {
                let mut columns = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    columns.push(entry);
                }
                Ok(Columns(columns))
            }
        }
        deserializer.deserialize_map(Ordered)
    }
}

/// Reads either JSON form.
pub fn from_json_str(name: &str, text: &str) -> Result<Demonstration, Error> {
    let unreadable = |reason: String| Error::Unreadable {
        name: name.into(),
        reason,
    };
    let Columns(entries) =
        serde_json::from_str(text).map_err(|error| unreadable(error.to_string()))?;
    if entries
        .iter()
        .any(|(key, value)| key == "format" && value == FORMAT)
    {
        let own: Own = serde_json::from_str(text).map_err(|e| unreadable(e.to_string()))?;
        if own.version != 1 {
            return Err(unreadable(format!("version {} is not known", own.version)));
        }
        return Demonstration::new(name.into(), own.t_s, own.joints_deg, own.tcp_mm)?
            .with_signals(own.signals);
    }
    from_columns(name, entries)
}

fn from_columns(
    name: &str,
    entries: Vec<(String, serde_json::Value)>,
) -> Result<Demonstration, Error> {
    let unreadable = |reason: String| Error::Unreadable {
        name: name.into(),
        reason,
    };
    if entries.len() != 18 {
        return Err(unreadable(format!(
            "{} columns where the recorder's files have 18",
            entries.len()
        )));
    }
    let mut columns = Vec::with_capacity(entries.len());
    for (key, value) in entries {
        let serde_json::Value::Array(values) = value else {
            return Err(unreadable(format!("{key} is not a list of numbers")));
        };
        let mut column = Vec::with_capacity(values.len());
        for (row, value) in values.iter().enumerate() {
            // JSON knows no NaN: recorders that meet one write null or a word.
            column.push(value.as_f64().ok_or_else(|| Error::NotFinite {
                name: name.into(),
                what: key.clone(),
                row: row + 1,
            })?);
        }
        columns.push((key, column));
    }
    let n = columns[0].1.len();
    if let Some((key, column)) = columns.iter().find(|(_, column)| column.len() != n) {
        return Err(Error::Ragged {
            name: name.into(),
            what: key.clone(),
            expected: n,
            found: column.len(),
        });
    }
    let rows = |range: std::ops::Range<usize>| -> Vec<Vec<f64>> {
        (0..n)
            .map(|i| columns[range.clone()].iter().map(|(_, c)| c[i]).collect())
            .collect()
    };
    let tcp = (0..n).map(|i| [1, 2, 3].map(|c| columns[c].1[i])).collect();
    Demonstration::new(name.into(), columns[0].1.clone(), rows(12..18), Some(tcp))
}
