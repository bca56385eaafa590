//! The doctor against the virtual controller, well and ill.

mod deployed;

use std::net::UdpSocket;

use super::report::{Outcome, Step};
use super::*;
use virtual_controller::{Config, VirtualController};

/// SHA-256 of "abc": the certificate of nobody.
const OTHER: &str = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

struct Cell {
    controller: VirtualController,
    arguments: Args,
}

/// A controller with HTTPS and a port for its EGM messages, on which nobody listens yet.
async fn cell(change: impl FnOnce(&mut Config)) -> Cell {
    let egm = UdpSocket::bind("127.0.0.1:0").unwrap();
    let egm_at = egm.local_addr().unwrap();
    drop(egm);
    let mut config = Config::new(egm_at);
    config.rws_https = true;
    change(&mut config);
    let controller = VirtualController::start(config).await.unwrap();
    let arguments = Args {
        rws: controller.rws_url(),
        user: "Default User".to_owned(),
        password_file: None,
        certificate: controller.certificate_sha256().map(str::to_owned),
        egm: Some(egm_at),
        egm_wait: 20.0,
        signals: SIGNALS.map(str::to_owned).to_vec(),
        move_arm: false,
        json: false,
    };
    Cell {
        controller,
        arguments,
    }
}

impl Cell {
    async fn examine(&self) -> Report {
        examine(&self.arguments, "robotics").await
    }

    fn client(&self) -> Client {
        client(&self.arguments, "robotics").unwrap()
    }
}

fn finding(report: &Report, step: Step) -> &report::Finding {
    let mut found = report
        .findings()
        .iter()
        .filter(|finding| finding.step == step);
    let first = found
        .next()
        .unwrap_or_else(|| panic!("{step:?} is missing"));
    assert!(found.next().is_none(), "{step:?} is there twice");
    first
}

/// Every step, each once, and only these failed.
fn assert_failed(report: &Report, steps: &[Step]) {
    for step in Step::ALL {
        let finding = finding(report, step);
        let failed = finding.outcome == Outcome::Failed;
        assert_eq!(failed, steps.contains(&step), "{}", report.text());
        assert_eq!(finding.advice.is_some(), failed, "{finding:?}");
    }
}

/// Nothing is looked at after `step`.
fn assert_stopped_at(report: &Report, step: Step) {
    assert_failed(report, &[step]);
    let after = Step::ALL.iter().skip_while(|other| **other != step).skip(1);
    for other in after {
        assert_eq!(
            finding(report, *other).outcome,
            Outcome::Skipped,
            "{}",
            report.text()
        );
    }
}

#[tokio::test]
async fn a_healthy_cell_passes_and_is_left_as_it_was() {
    let cell = cell(|config| config.egm.stream_when_idle = true).await;
    let client = cell.client();
    let before = client.joint_target_deg().await.unwrap();
    let report = cell.examine().await;
    assert_failed(&report, &[]);
    assert!(
        finding(&report, Step::EgmMessages)
            .saw
            .contains("RobotWare 7"),
        "{}",
        report.text()
    );
    // The controller streams only, so whether it applies answers cannot be seen.
    assert_eq!(finding(&report, Step::EgmAnswers).outcome, Outcome::Skipped);
    assert_eq!(client.joint_target_deg().await.unwrap(), before);
    assert_eq!(
        client.controller_state().await.unwrap(),
        rws::ControllerState::MotorsOff
    );
    assert!(!client.lead_through().await.unwrap());
    cell.controller.stop().await;
}

#[tokio::test]
async fn when_it_may_it_tries_lead_through_and_the_program_and_leaves_the_arm_at_rest() {
    let mut cell = cell(|_| {}).await;
    cell.arguments.move_arm = true;
    let client = cell.client();
    let before = client.joint_target_deg().await.unwrap();
    let report = cell.examine().await;
    assert_failed(&report, &[]);
    for step in [Step::LeadThrough, Step::EgmMessages, Step::EgmAnswers] {
        assert_eq!(
            finding(&report, step).outcome,
            Outcome::Ok,
            "{}",
            report.text()
        );
    }
    assert_eq!(client.execution().await.unwrap(), rws::Execution::Stopped);
    assert_eq!(
        client.controller_state().await.unwrap(),
        rws::ControllerState::MotorsOff
    );
    assert!(!client.lead_through().await.unwrap());
    let after = client.joint_target_deg().await.unwrap();
    for (before, after) in before.iter().zip(after) {
        assert!((before - after).abs() < 0.01, "{before} {after}");
    }
    cell.controller.stop().await;
}

#[tokio::test]
async fn the_arm_is_left_alone_while_a_stop_is_active_even_when_it_may_be_moved() {
    let mut cell = cell(|_| {}).await;
    cell.arguments.move_arm = true;
    cell.controller.faults().guard_stop(true);
    let report = cell.examine().await;
    assert_failed(&report, &[Step::Motors]);
    for step in [Step::LeadThrough, Step::EgmMessages, Step::EgmAnswers] {
        assert_eq!(
            finding(&report, step).outcome,
            Outcome::Skipped,
            "{}",
            report.text()
        );
    }
    let events = cell.client().events(1, 50).await.unwrap();
    let started = events.iter().any(|event| event.title == "Program started");
    assert!(!started, "{events:?}");
    cell.controller.stop().await;
}

#[tokio::test]
async fn without_messages_it_says_that_the_program_stands_and_what_to_check() {
    let mut cell = cell(|_| {}).await;
    cell.arguments.egm_wait = 0.2;
    let report = cell.examine().await;
    assert_failed(&report, &[Step::EgmMessages]);
    let advice = finding(&report, Step::EgmMessages).advice.clone().unwrap();
    assert!(
        advice.contains("program stands") && advice.contains("Remote Address"),
        "{advice}"
    );
    assert!(report.text().contains("1 failed"), "{}", report.text());
    cell.controller.stop().await;
}

#[tokio::test]
async fn a_wrong_password_stops_it_with_words_about_the_account() {
    let cell = cell(|_| {}).await;
    let report = examine(&cell.arguments, "wrong").await;
    assert_stopped_at(&report, Step::LogIn);
    let login = finding(&report, Step::LogIn);
    assert!(login.saw.contains("Default User"), "{login:?}");
    assert!(
        finding(&report, Step::Mode)
            .saw
            .contains("does not let us in")
    );
    cell.controller.stop().await;
}

#[tokio::test]
async fn a_wrong_certificate_stops_it_before_the_password_is_sent() {
    let mut cell = cell(|_| {}).await;
    let right = cell
        .arguments
        .certificate
        .replace(OTHER.to_owned())
        .unwrap();
    let report = cell.examine().await;
    assert_stopped_at(&report, Step::Certificate);
    let saw = &finding(&report, Step::Certificate).saw;
    assert!(saw.contains(&right) && saw.contains("BA:78:16:BF"), "{saw}");

    cell.arguments.certificate = None;
    let report = cell.examine().await;
    assert_stopped_at(&report, Step::Certificate);
    assert!(finding(&report, Step::Certificate).saw.contains(&right));
    cell.controller.stop().await;
}

#[tokio::test]
async fn plain_http_is_looked_at_too_but_said_to_be_readable() {
    let cell = cell(|config| {
        config.rws_https = false;
        config.egm.stream_when_idle = true;
    })
    .await;
    let report = cell.examine().await;
    assert_failed(&report, &[]);
    let certificate = finding(&report, Step::Certificate);
    assert_eq!(certificate.outcome, Outcome::Skipped);
    assert!(
        certificate.saw.contains("can read the password"),
        "{certificate:?}"
    );
    cell.controller.stop().await;
}

#[tokio::test]
async fn nobody_at_the_address_stops_it_at_once() {
    let cell = cell(|_| {}).await;
    let arguments = cell.arguments.clone();
    cell.controller.stop().await;
    let report = examine(&arguments, "robotics").await;
    assert_stopped_at(&report, Step::Address);
}

#[tokio::test]
async fn an_open_guard_and_a_missing_signal_are_found_and_the_rest_is_looked_at() {
    let mut cell = cell(|config| config.egm.stream_when_idle = true).await;
    cell.controller.faults().guard_stop(true);
    cell.arguments.signals.push("Vacuum".to_owned());
    let report = cell.examine().await;
    assert_failed(&report, &[Step::Motors, Step::Signals]);
    assert!(finding(&report, Step::Signals).saw.contains("Vacuum"));
    cell.controller.stop().await;
}

#[tokio::test]
async fn a_port_in_use_and_somebody_elses_mastership_are_found() {
    let cell = cell(|_| {}).await;
    let taken = UdpSocket::bind(cell.arguments.egm.unwrap()).unwrap();
    let other = cell.client();
    other.request_edit_mastership().await.unwrap();
    let report = cell.examine().await;
    assert_failed(&report, &[Step::Rights, Step::EgmPort]);
    assert!(
        finding(&report, Step::EgmPort)
            .advice
            .as_ref()
            .unwrap()
            .contains("TEAM service")
    );
    drop(taken);
    cell.controller.stop().await;
}

#[tokio::test]
async fn a_program_reads_the_same_as_json() {
    let cell = cell(|_| {}).await;
    let report = examine(&cell.arguments, "wrong").await;
    let json: serde_json::Value = serde_json::from_str(&report.json()).unwrap();
    assert_eq!(json["healthy"], false);
    assert_eq!(json["steps"].as_array().unwrap().len(), Step::ALL.len());
    let login = &json["steps"][2];
    assert_eq!(
        (&login["step"], &login["outcome"]),
        (&"log_in".into(), &"failed".into())
    );
    assert!(login["advice"].is_string());
    cell.controller.stop().await;
}
