//! Files of demonstrations: what is read, and what is refused with its place.

#![expect(
    clippy::unwrap_used,
    reason = "a test stops at what it does not expect"
)]

use learning::{Demonstration, Error, Model, read, write};

#[test]
fn a_demonstration_survives_its_own_json_exactly() {
    let times: Vec<f64> = (0..150).map(|i| 0.013 * f64::from(i)).collect();
    let joints = times.iter().map(|t| vec![t.sin() / 3.0, 0.1 + t]).collect();
    let take = Demonstration::new("take 1".into(), times, joints, None).unwrap();
    assert_eq!(
        read::from_str("take 1", &write::to_json(&take)).unwrap(),
        take
    );
}

#[test]
fn csv_with_dots_or_german_commas_reads_the_same() {
    let mut dots = String::from("t_s,q1_deg,q2_deg\n");
    let mut commas = String::from("\u{feff}t_s;q1_deg;q2_deg\r\n");
    for i in 0..100 {
        let (t, q) = (f64::from(i) * 0.02, f64::from(i) * 0.25);
        dots += &format!("{t},{q},-1.5\n");
        commas += &format!("{t};{q};-1.5\r\n").replace('.', ",");
    }
    let a = read::from_str("x", &dots).unwrap();
    assert_eq!(a, read::from_str("x", &commas).unwrap());
    assert_eq!((a.len(), a.joints()), (100, 2));
}

#[test]
fn bad_csv_is_refused_with_the_place() {
    let rows = |extra: &str| {
        let mut text = String::from("t_s,q1_deg\n");
        for i in 0..100 {
            text += &format!("{},{}\n", f64::from(i) * 0.02, i);
        }
        text + extra
    };
    let read = |text: &str| read::from_str("x", text).unwrap_err();
    assert!(matches!(read(&rows("3.0\n")), Error::Ragged { what, .. } if what == "row 101"));
    assert!(matches!(
        read(&rows("3.0,NaN\n")),
        Error::NotFinite { row: 101, .. }
    ));
    assert!(matches!(
        read(&rows("3.0,oops\n")),
        Error::NotFinite { row: 101, .. }
    ));
    assert!(matches!(
        read(&rows("1.98,5\n")),
        Error::TimeNotIncreasing { row: 101, .. }
    ));
    assert!(matches!(
        read(&rows("1.0,5\n")),
        Error::TimeNotIncreasing { row: 101, .. }
    ));
    assert!(matches!(
        read("t_s,q1_rad\n0,0\n"),
        Error::Unreadable { .. }
    ));
    assert!(matches!(
        read("t_s,q1_deg,q3_deg\n"),
        Error::Unreadable { .. }
    ));
    assert!(matches!(read(""), Error::Unreadable { .. }));
    assert!(matches!(
        read("t_s,q1_deg\n0,0\n0.5,1\n"),
        Error::TooShort { .. }
    ));
    assert!(matches!(read("t_s,q1_deg\n"), Error::TooShort { .. }));
}

/// A recording as the paper's recorder wrote them, with one column changed.
fn recording(change: impl Fn(&str, usize) -> Option<serde_json::Value>) -> String {
    let names = [
        "timestamp",
        "tcp_x",
        "tcp_y",
        "tcp_z",
        "tcp_q1",
        "tcp_q2",
        "tcp_q3",
        "tcp_q4",
        "cf1",
        "cf4",
        "cf6",
        "cfx",
        "joint_1",
        "joint_2",
        "joint_3",
        "joint_4",
        "joint_5",
        "joint_6",
    ];
    let columns: Vec<String> = names
        .iter()
        .map(|name| {
            let values: Vec<serde_json::Value> = (0..100)
                .filter_map(|i| match change(name, i) {
                    Some(value) if value == serde_json::json!("absent") => None,
                    Some(value) => Some(value),
                    None if *name == "timestamp" => Some(serde_json::json!(0.02 * (i + 1) as f64)),
                    None if *name == "joint_2" => Some(serde_json::json!(0.3 * i as f64)),
                    None => Some(serde_json::json!(1.0)),
                })
                .collect();
            format!("\"{name}\": {}", serde_json::to_string(&values).unwrap())
        })
        .collect();
    format!("{{{}}}", columns.join(", "))
}

#[test]
fn the_recorders_files_are_read_by_position() {
    let demonstration = read::from_str("x", &recording(|_, _| None)).unwrap();
    assert_eq!((demonstration.len(), demonstration.joints()), (100, 6));
    assert!((demonstration.joints_deg().row(10)[1] - 3.0).abs() < 1e-12);
    assert_eq!(demonstration.recorded_tcp_mm().unwrap()[0], [1.0; 3]);
}

#[test]
fn damaged_recordings_are_refused_with_the_place() {
    let read = |change: &dyn Fn(&str, usize) -> Option<serde_json::Value>| {
        read::from_str("x", &recording(change)).unwrap_err()
    };
    let at = |name: &'static str, row: usize, value: serde_json::Value| {
        move |n: &str, i: usize| (n == name && i == row).then(|| value.clone())
    };
    let ragged = read(&at("joint_3", 50, serde_json::json!("absent")));
    assert!(
        matches!(ragged, Error::Ragged { what, expected: 100, found: 99, .. } if what == "joint_3")
    );
    let null = read(&at("joint_4", 7, serde_json::Value::Null));
    assert!(matches!(null, Error::NotFinite { what, row: 8, .. } if what == "joint_4"));
    let back = read(&at("timestamp", 30, serde_json::json!(0.1)));
    assert!(matches!(back, Error::TimeNotIncreasing { row: 31, .. }));
    let range = read(&at("joint_3", 20, serde_json::json!(120.0)));
    assert!(matches!(
        range,
        Error::JointOutOfRange {
            joint: 3,
            row: 21,
            ..
        }
    ));
    let location = range.where_();
    assert_eq!((location.joint, location.row), (Some(3), Some(21)));
    let still = read(&|n, _| (n == "joint_2").then(|| serde_json::json!(4.0)));
    assert!(matches!(still, Error::NoMotion { .. }));
    assert!(!still.advice().is_empty());
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig {
        failure_persistence: None,
        ..Default::default()
    })]

    #[test]
    fn no_text_makes_the_readers_panic(text in ".{0,400}") {
        let _ = read::from_str("x", &text);
        let _ = read::from_str("x", &format!("{{{text}"));
        let _ = read::from_str("x", &format!("t_s,q1_deg\n{text}"));
        let _ = Model::from_json(&text);
    }
}
