//! CSV with a header that names the units: `t_s,q1_deg,…,q6_deg` and optionally
//! `x_mm,y_mm,z_mm`. Semicolons with decimal commas are understood too.

use crate::{Demonstration, Error};

/// Reads the CSV form. Column order is free; unknown columns are refused, so that
/// a file in radians is not taken for degrees.
pub fn from_csv_str(name: &str, text: &str) -> Result<Demonstration, Error> {
    let unreadable = |reason: String| Error::Unreadable {
        name: name.into(),
        reason,
    };
    let mut lines = text
        .trim_start_matches('\u{feff}')
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty());
    let header = lines
        .next()
        .ok_or_else(|| unreadable("the file is empty".into()))?;
    let separator = if header.contains(';') { ';' } else { ',' };
    let columns = header
        .split(separator)
        .map(|field| Column::parse(field.trim()))
        .collect::<Result<Vec<_>, _>>()
        .map_err(unreadable)?;
    let joints = columns
        .iter()
        .filter(|c| matches!(c, Column::Joint(_)))
        .count();
    let has_tcp = columns.iter().any(|c| matches!(c, Column::Tcp(_)));
    check_header(&columns, joints, has_tcp).map_err(unreadable)?;

    let (mut times_s, mut joints_deg, mut tcp_mm) = (Vec::new(), Vec::new(), Vec::new());
    for (i, line) in lines.enumerate() {
        let row = i + 1;
        let fields: Vec<&str> = line.split(separator).map(str::trim).collect();
        if fields.len() != columns.len() {
            return Err(Error::Ragged {
                name: name.into(),
                what: format!("row {row}"),
                expected: columns.len(),
                found: fields.len(),
            });
        }
        let (mut t, mut q, mut p) = (0.0, vec![0.0; joints], [0.0; 3]);
        for (column, field) in columns.iter().zip(fields) {
            let value = number(field, separator).ok_or_else(|| Error::NotFinite {
                name: name.into(),
                what: column.name(),
                row,
            })?;
            match *column {
                Column::Time => t = value,
                Column::Joint(j) => q[j] = value,
                Column::Tcp(axis) => p[axis] = value,
            }
        }
        times_s.push(t);
        joints_deg.push(q);
        tcp_mm.push(p);
    }
    Demonstration::new(name.into(), times_s, joints_deg, has_tcp.then_some(tcp_mm))
}

fn number(field: &str, separator: char) -> Option<f64> {
    if separator == ';' {
        field.replace(',', ".").parse().ok()
    } else {
        field.parse().ok()
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Column {
    Time,
    Joint(usize),
    Tcp(usize),
}

impl Column {
    fn parse(field: &str) -> Result<Column, String> {
        let joint = || {
            let number: usize = field
                .strip_prefix('q')?
                .strip_suffix("_deg")?
                .parse()
                .ok()?;
            (1..=7).contains(&number).then(|| Column::Joint(number - 1))
        };
        match field {
            "t_s" => Ok(Column::Time),
            "x_mm" => Ok(Column::Tcp(0)),
            "y_mm" => Ok(Column::Tcp(1)),
            "z_mm" => Ok(Column::Tcp(2)),
            _ => joint().ok_or_else(|| {
                format!("column \"{field}\" is not known; use t_s, q1_deg, q2_deg, … and x_mm, y_mm, z_mm")
            }),
        }
    }

    fn name(&self) -> String {
        match self {
            Column::Time => "time".into(),
            Column::Joint(j) => format!("joint {}", j + 1),
            Column::Tcp(_) => "tcp".into(),
        }
    }
}

fn check_header(columns: &[Column], joints: usize, has_tcp: bool) -> Result<(), String> {
    let occurs = |wanted: Column| columns.iter().filter(|&&c| c == wanted).count();
    if occurs(Column::Time) != 1 {
        return Err("one column t_s is needed".into());
    }
    if joints == 0 || (0..joints).any(|j| occurs(Column::Joint(j)) != 1) {
        return Err("the joints must be q1_deg, q2_deg, … without gaps".into());
    }
    if has_tcp && (0..3).any(|axis| occurs(Column::Tcp(axis)) != 1) {
        return Err("x_mm, y_mm and z_mm belong together".into());
    }
    Ok(())
}
