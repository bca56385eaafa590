//! What is written in `deploy/gofa` agrees with what the doctor looks for and with what the
//! virtual controller has.

use std::path::Path;

use super::super::{MODULES, SIGNALS};
use virtual_controller::signals::{EGM_STOP, Signals};

fn deployed(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../deploy/gofa");
    std::fs::read_to_string(folder.join(name)).unwrap()
}

/// The text between the first pair of quotation marks behind `key`.
fn quoted<'a>(text: &'a str, key: &str) -> &'a str {
    let (_, after) = text
        .split_once(key)
        .unwrap_or_else(|| panic!("{key} is missing"));
    after.split('"').nth(1).unwrap()
}

#[test]
fn every_module_is_in_the_file_of_its_name_and_main_calls_what_is_there() {
    for module in MODULES {
        let text = deployed(&format!("{module}.mod"));
        assert!(text.starts_with(&format!("MODULE {module}\n")), "{module}");
    }
    let egm = deployed("TEAM_egm.mod");
    let main = deployed("TEAM_main.mod");
    assert!(main.contains("PROC main()") && main.contains("TEAM_guide;"));
    assert!(egm.contains("PROC TEAM_guide()") && egm.contains("PROC TEAM_stream()"));
    assert!(!egm.contains("PROC main()"));
}

#[test]
fn the_program_uses_the_devices_that_the_configuration_makes() {
    let egm = deployed("TEAM_egm.mod");
    let set_up = egm
        .lines()
        .find(|line| line.contains("EGMSetupUC"))
        .unwrap();
    let names: Vec<&str> = set_up.split('"').skip(1).step_by(2).collect();
    let device = deployed("TEAM_sio.cfg");
    let interface = deployed("TEAM_moc.cfg");
    assert_eq!(
        names,
        [quoted(&interface, "-name"), quoted(&device, "-Name")]
    );
    assert!(set_up.contains("ROB_1") && set_up.contains("\\Joint"));
    // The controller's default of 1 deg/s is the most frequent reason for an arm that creeps.
    assert!(egm.contains("\\MaxSpeedDeviation:=teamMaxSpeed"));
}

#[test]
fn every_signal_that_is_looked_for_can_be_written_and_is_in_the_virtual_controller() {
    let configuration = deployed("TEAM_eio.cfg");
    let entries: Vec<&str> = configuration.split("-Name").skip(1).collect();
    let virtual_signals = Signals::default();
    for signal in SIGNALS {
        let entry = entries
            .iter()
            .find(|entry| entry.trim_start().starts_with(&format!("\"{signal}\"")))
            .unwrap_or_else(|| panic!("{signal} is not configured"));
        assert_eq!(quoted(entry, "-Access"), "All", "{signal}");
        let twin = virtual_signals.find(signal).unwrap();
        assert_eq!(quoted(entry, "-SignalType"), twin.kind.word(), "{signal}");
        assert!(twin.writable, "{signal}");
    }
    assert!(SIGNALS.contains(&EGM_STOP));
    let egm = deployed("TEAM_egm.mod");
    assert!(egm.contains(&format!("ISignalDI {EGM_STOP},1")));
}
