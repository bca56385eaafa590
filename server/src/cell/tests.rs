//! Configuration files: what they give, and what is said about those that can't be used.

use std::path::Path;
use std::time::Duration;

use motion::limits::RobotLimits;
use proptest::prelude::*;
use robot::RobotKind;

use super::check::{Source, robots};
use super::{CellError, RobotSettings};
use crate::test_support::TestFolder;

fn read(text: &str) -> Result<Vec<RobotSettings>, CellError> {
    let environment = |name: &str| (name == "RIGHT_PASSWORD").then(|| "s3cret".to_owned());
    robots(&Source::new(Path::new("cell.toml"), text, &environment))
}

const TWO: &str = r#"
[[robot]]
id = "left"
name = "Left arm"
kind = "virtual"

[[robot]]
id = "right-2"
kind = "gofa"
egm_listen = "192.168.125.99:6511"
rws_url = "https://192.168.125.1"
rws_user = "team"
rws_password_env = "RIGHT_PASSWORD"
rws_certificate_sha256 = "AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa:AA:aa"
tcp_speed_mm_s = 180
joint_speed_deg_s = [50, 50, 50, 60, 60, 60]
joint_acceleration_deg_s2 = [100.0, 100.0, 100.0, 200.0, 200.0, 200.0]
silence_limit_ms = 60

[[robot.keep_out]]
name = "conveyor"
min_mm = [300, -500, -100]
max_mm = [700, 500, 250.5]
"#;

#[test]
fn a_whole_file_gives_what_it_says_and_the_defaults_for_the_rest() {
    let robots = read(TWO).unwrap();
    let [left, right] = &robots[..] else {
        panic!("{robots:?}")
    };
    assert_eq!((&*left.id, &*left.name), ("left", "Left arm"));
    assert_eq!(left.kind, RobotKind::Virtual);
    assert_eq!(left.egm_listen, ([127, 0, 0, 1], 0).into());
    assert_eq!(left.limits, RobotLimits::gofa5());
    assert!(left.controller.is_none() && left.limits.keep_out.is_empty());

    assert_eq!((&*right.id, &*right.name), ("right-2", "right-2"));
    assert_eq!(right.egm_listen, ([192, 168, 125, 99], 6511).into());
    assert_eq!(right.silence, Duration::from_millis(60));
    assert_eq!(right.limits.tcp_speed_mm_s, 180.0);
    assert_eq!(right.limits.joint_speed_deg_s[3], 60.0);
    assert_eq!(right.limits.joint_acceleration_deg_s2[0], 100.0);
    assert_eq!(
        right.limits.joint_max_deg,
        RobotLimits::gofa5().joint_max_deg
    );
    assert_eq!(right.limits.keep_out[0].max_mm, [700.0, 500.0, 250.5]);
    let controller = right.controller.as_ref().unwrap();
    assert_eq!(controller.certificate_sha256, Some("aa".repeat(32)));
    let config = right.robot_config();
    assert_eq!(config.rws_url.as_deref(), Some("https://192.168.125.1"));
    assert_eq!(
        (&*config.rws_user, &*config.rws_password),
        ("team", "s3cret")
    );
    let printed = format!("{robots:?}");
    assert!(!printed.contains("s3cret"), "{printed}");
}

#[test]
fn a_gofa_without_more_has_the_short_silence_limit_and_the_factorys_account() {
    let text = "[[robot]]\nid = \"a\"\nkind = \"gofa\"\nrws_url = \"http://10.0.0.2:80/\"\negm_listen = \"0.0.0.0:6510\"\n";
    let [gofa] = &read(text).unwrap()[..] else {
        panic!()
    };
    assert_eq!(gofa.silence, Duration::from_millis(100));
    assert_eq!(gofa.limits.tcp_speed_mm_s, 250.0);
    assert!(gofa.controller.as_ref().unwrap().account.is_none());
}

#[test]
fn a_password_is_read_from_the_file_beside_the_configuration() {
    let folder = TestFolder::new();
    let text = TWO.replace(
        "rws_password_env = \"RIGHT_PASSWORD\"",
        "rws_password_file = \"pw\"",
    );
    let file = folder.path().join("cell.toml");
    let environment = |_: &str| None;
    let missing = robots(&Source::new(&file, &text, &environment)).unwrap_err();
    assert!(
        missing.to_string().contains("rws_password_file"),
        "{missing}"
    );
    std::fs::write(folder.path().join("pw"), "two words\r\n").unwrap();
    let read = robots(&Source::new(&file, &text, &environment)).unwrap();
    assert_eq!(read[1].robot_config().rws_password, "two words");
    std::fs::write(folder.path().join("pw"), "\n").unwrap();
    let empty = robots(&Source::new(&file, &text, &environment)).unwrap_err();
    assert!(
        empty.to_string().contains("the password is empty"),
        "{empty}"
    );
}

/// Changes of the good file, the line that is then wrong, the field, and a word of the reason.
const WRONG: [(&str, &str, usize, &str, &str); 29] = [
    ("id = \"left\"", "", 2, "id", "has no id"),
    (
        "id = \"left\"",
        "id = \"Left arm\"",
        3,
        "id",
        "can't be an id",
    ),
    (
        "id = \"left\"",
        "id = \"stop\"",
        3,
        "id",
        "word of the interface",
    ),
    (
        "id = \"right-2\"",
        "id = \"left\"",
        8,
        "id",
        "already another robot's",
    ),
    ("id = \"left\"", "id = 7", 3, "id", "invalid type"),
    (
        "name = \"Left arm\"",
        "name = \"  \"",
        4,
        "name",
        "can't be a name",
    ),
    (
        "name = \"Left arm\"",
        "nmae = \"Left\"",
        4,
        "nmae",
        "unknown field",
    ),
    (
        "kind = \"virtual\"",
        "",
        2,
        "kind",
        "robot \"left\" has no kind",
    ),
    (
        "kind = \"virtual\"",
        "kind = \"kuka\"",
        5,
        "kind",
        "unknown variant",
    ),
    (
        "kind = \"virtual\"",
        "kind = \"virtual\"\negm_listen = \"127.0.0.1:6511\"",
        11,
        "egm_listen",
        "port 6511 is already",
    ),
    (
        "kind = \"virtual\"",
        "kind = \"virtual\"\negm_listen = \"0.0.0.0:6520\"",
        6,
        "egm_listen",
        "on this computer",
    ),
    (
        "kind = \"virtual\"",
        "kind = \"virtual\"\nrws_url = \"http://10.0.0.1\"",
        6,
        "rws_url",
        "its own controller",
    ),
    (
        "egm_listen = \"192.168.125.99:6511\"",
        "",
        7,
        "egm_listen",
        "has no egm_listen",
    ),
    (":6511", "", 10, "egm_listen", "not an address"),
    (":6511", ":0", 10, "egm_listen", "port 0"),
    (
        "rws_url = \"https://192.168.125.1\"",
        "",
        7,
        "rws_url",
        "has no rws_url",
    ),
    ("https://192", "ftp://192", 11, "rws_url", "does not begin"),
    (
        "https://192",
        "https://team:pw@192",
        11,
        "rws_url",
        "holds an account",
    ),
    (
        "https://192",
        "http://192",
        14,
        "rws_certificate_sha256",
        "without https",
    ),
    (
        "rws_user = \"team\"",
        "rws_password = \"hunter2\"",
        12,
        "rws_password",
        "must not be in this file",
    ),
    (
        "rws_user = \"team\"",
        "",
        13,
        "rws_password_env",
        "has no account",
    ),
    (
        "rws_password_env = \"RIGHT_PASSWORD\"",
        "",
        12,
        "rws_user",
        "has no password",
    ),
    (
        "RIGHT_PASSWORD",
        "LEFT_PASSWORD",
        13,
        "rws_password_env",
        "no environment variable",
    ),
    (
        "AA:aa:AA",
        "AA:aa:A",
        14,
        "rws_certificate_sha256",
        "not a SHA-256",
    ),
    ("= 180", "= 0", 15, "tcp_speed_mm_s", "0 mm/s"),
    (
        "[50, 50, 50, 60, 60, 60]",
        "[50, 50, 50, 60, 60, 201]",
        16,
        "joint_speed_deg_s",
        "201 for joint 6",
    ),
    (
        "[50, 50, 50, 60, 60, 60]",
        "[50, 50]",
        16,
        "joint_speed_deg_s",
        "invalid length",
    ),
    ("= 60\n", "= 5\n", 18, "silence_limit_ms", "5 ms"),
    ("250.5]", "-200]", 20, "keep_out.min_mm", "no inside"),
];

#[test]
fn what_is_wrong_is_said_with_line_field_and_advice() {
    for (old, new, at, name, reason) in WRONG {
        assert!(TWO.contains(old), "{old}");
        let error = read(&TWO.replacen(old, new, 1)).unwrap_err();
        let words = error.to_string();
        let CellError::Wrong {
            line,
            field,
            what,
            advice,
            ..
        } = error
        else {
            panic!("{words}")
        };
        assert_eq!((line, &*field), (at, name), "{words}");
        assert!(what.contains(reason) && !advice.is_empty(), "{words}");
        assert!(words.starts_with("cell.toml, line "), "{words}");
        assert!(!words.contains("hunter2"), "{words}");
    }
}

#[test]
fn a_file_without_robots_and_no_file_at_all_are_refused() {
    assert!(read("").unwrap_err().to_string().contains("no robot"));
    let config = crate::config::Config {
        listen: ([127, 0, 0, 1], 0).into(),
        https: false,
        egm_port: 0,
        data: "data".into(),
        robot: crate::config::RobotChoice::Virtual,
        config: Some("nowhere/cell.toml".into()),
    };
    let missing = super::robots(&config).unwrap_err().to_string();
    assert!(
        missing.contains("nowhere/cell.toml") && missing.contains("--config"),
        "{missing}"
    );
}

#[test]
fn the_last_parts_of_a_file_that_is_no_toml_are_not_repeated() {
    let error = read("[[robot]]\nrws_password = hunter2 and more\n")
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with("cell.toml, line 2, rws_password: "),
        "{error}"
    );
    assert!(!error.contains("hunter2"), "{error}");
}

proptest! {
    #[test]
    fn limits_are_taken_when_they_are_lower_and_refused_when_they_are_not(
        joint in 0_usize..6,
        share in 0.01_f64..2.0,
    ) {
        let own = RobotLimits::gofa5();
        let mut wish = own.joint_speed_deg_s;
        wish[joint] *= share;
        let numbers = wish.map(|value| format!("{value:?}")).join(", ");
        let line = format!("joint_speed_deg_s = [{numbers}]");
        let text = TWO.replace("joint_speed_deg_s = [50, 50, 50, 60, 60, 60]", &line);
        match read(&text) {
            Ok(robots) => {
                prop_assert!(share <= 1.0);
                prop_assert_eq!(robots[1].limits.joint_speed_deg_s, wish);
            }
            Err(error) => {
                prop_assert!(share > 1.0);
                let joint = format!("joint {}", joint + 1);
                prop_assert!(error.to_string().contains(&joint), "{}", error);
            }
        }
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in any::<String>()) {
        let cut = TWO.len() - text.len().min(TWO.len());
        let _ = read(&text);
        if let Some(begin) = TWO.get(..cut) {
            let _ = read(&format!("{begin}{text}"));
        }
    }
}

#[test]
fn signals_are_those_of_the_file_or_the_virtual_gripper() {
    let robots = read(TWO).unwrap();
    assert_eq!(robots[0].robot_config().signals[0].label, "Gripper");
    assert!(
        robots[1].signals.is_empty(),
        "nobody knows what a real arm holds"
    );

    let vacuum = "\n[[robot.signal]]\nname = \"doVacuum\"\nlabel = \"Vacuum\"\non = \"suck\"\noff = \"let go\"\n";
    let robots = read(&format!("{TWO}{vacuum}")).unwrap();
    let config = robots[1].robot_config();
    let told: Vec<(&str, &str)> = config
        .signals
        .iter()
        .map(|signal| (&*signal.name, &*signal.off))
        .collect();
    assert_eq!(told, [("doVacuum", "let go")]);

    let twice = read(&format!("{TWO}{vacuum}{vacuum}"))
        .unwrap_err()
        .to_string();
    assert!(
        twice.contains("signal.name") && twice.contains("twice"),
        "{twice}"
    );
    let nameless = vacuum.replace("doVacuum", " ");
    let nameless = read(&format!("{TWO}{nameless}")).unwrap_err().to_string();
    assert!(nameless.contains("signal.name"), "{nameless}");
}
