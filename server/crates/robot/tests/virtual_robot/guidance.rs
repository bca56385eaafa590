//! Guiding the soft arm, here by the virtual hand.

use crate::support::Cell;
use robot::{GuidanceEvent, GuidanceSample, HandActivity, HandCommand, HandScript, RobotState};
use std::time::Duration;
use tokio::sync::mpsc;

const SHOW: HandCommand = HandCommand::Show {
    script: HandScript::F1,
    seed: 3,
};
const RETURN: HandCommand = HandCommand::Return {
    script: HandScript::F1,
    seed: 3,
};

/// Collects samples until the stream is over; returns them and the reason.
async fn until_ended(events: &mut mpsc::Receiver<GuidanceEvent>) -> (Vec<GuidanceSample>, String) {
    let mut samples = Vec::new();
    loop {
        let event = tokio::time::timeout(Duration::from_secs(10), events.recv());
        match event.await.expect("the stream must go on").unwrap() {
            GuidanceEvent::Sample(sample) => samples.push(sample),
            GuidanceEvent::Gap { .. } | GuidanceEvent::Signal { .. } => {}
            GuidanceEvent::Ended { reason } => return (samples, reason),
        }
    }
}

async fn until_sample(
    events: &mut mpsc::Receiver<GuidanceEvent>,
    mut wanted: impl FnMut(&GuidanceSample) -> bool,
) -> Vec<GuidanceSample> {
    let mut samples = Vec::new();
    loop {
        let event = tokio::time::timeout(Duration::from_secs(30), events.recv());
        match event.await.expect("a sample must come").unwrap() {
            GuidanceEvent::Sample(sample) => {
                samples.push(sample);
                if wanted(&sample) {
                    return samples;
                }
            }
            GuidanceEvent::Gap { .. } | GuidanceEvent::Signal { .. } => {}
            GuidanceEvent::Ended { reason } => panic!("guidance ended: {reason}"),
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn the_virtual_hand_shows_a_motion_and_its_samples_arrive() {
    let mut cell = Cell::start().await;
    let before = cell.pose();
    let mut events = cell.robot.start_guidance().await.unwrap();
    let soft = cell.wait_for_state(RobotState::Guiding).await;
    assert_eq!(
        (soft.lead_through, soft.motors_on),
        (Some(true), Some(true))
    );

    cell.robot.virtual_hand(RETURN).await.unwrap();
    let hand = cell.view.borrow().hand;
    assert_eq!(hand, Some(HandActivity::Returning));
    cell.wait_for("the hand at the start", |view| {
        view.hand == Some(HandActivity::Idle)
    })
    .await;
    cell.robot.virtual_hand(SHOW).await.unwrap();
    assert_eq!(cell.view.borrow().hand, Some(HandActivity::Showing));
    let samples = until_sample(&mut events, |sample| {
        sample.joints.max_abs_difference(&before) > 5.0
    })
    .await;
    assert!(samples.len() > 20);
    eprintln!(
        "RATE {} in {}",
        samples.len(),
        samples.last().unwrap().at_us
    );
    assert!(samples.windows(2).all(|pair| pair[0].at_us < pair[1].at_us));

    cell.robot.stop_guidance().await.unwrap();
    let (_, reason) = until_ended(&mut events).await;
    assert_eq!(reason, "stopped");
    let stiff = cell.wait_for_state(RobotState::Idle).await;
    assert_eq!(stiff.lead_through, Some(false));
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn egm_feedback_is_used_when_it_comes_while_guiding() {
    let mut cell = Cell::with(|config| config.egm.stream_when_idle = true).await;
    cell.wait_for("EGM", |view| view.egm.connected).await;
    let mut events = cell.robot.start_guidance().await.unwrap();
    let samples = until_sample(&mut events, |sample| sample.at_us > 1_000_000).await;
    // Polling never asks twice within 10 ms.
    let close = samples
        .windows(2)
        .filter(|pair| pair[1].at_us - pair[0].at_us < 8_000)
        .count();
    assert!(close > 20, "{close}");
    cell.robot.stop_guidance().await.unwrap();
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn stop_makes_the_arm_stiff() {
    let mut cell = Cell::start().await;
    let mut events = cell.robot.start_guidance().await.unwrap();
    cell.robot.stop();
    let (_, reason) = until_ended(&mut events).await;
    assert_eq!(reason, "the arm was stopped");
    let stiff = cell.wait_for_state(RobotState::Idle).await;
    assert_eq!(stiff.lead_through, Some(false));
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn an_arm_that_a_killed_server_left_soft_is_shown_and_can_be_stopped() {
    let mut cell = Cell::start().await;
    let url = crate::support::url(&cell.controller);
    let earlier = rws::Client::new(rws::Config::new(url)).unwrap();
    earlier.set_motors(true).await.unwrap();
    earlier.set_lead_through(true).await.unwrap();
    cell.wait_for("the soft arm", |view| view.lead_through == Some(true))
        .await;
    cell.robot.stop();
    cell.wait_for("the stiff arm", |view| {
        view.state == RobotState::Idle && view.lead_through == Some(false)
    })
    .await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn guiding_is_one_at_a_time_and_its_end_is_answered_plainly() {
    let mut cell = Cell::start().await;
    let refusal = cell.robot.stop_guidance().await.unwrap_err();
    assert_eq!(refusal.code(), "robot_not_guiding");
    let _events = cell.robot.start_guidance().await.unwrap();
    let refusal = cell.robot.start_guidance().await.unwrap_err();
    assert_eq!(refusal.code(), "robot_busy");
    let plan = cell.plan([1.0; 6], 2.0);
    let refusal = cell.robot.run(plan).await.unwrap_err();
    assert_eq!(refusal.code(), "robot_busy");
    cell.robot.stop_guidance().await.unwrap();
    cell.wait_for_state(RobotState::Idle).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn lead_through_that_is_taken_back_at_once_is_refused_with_the_reason() {
    let mut cell = Cell::start().await;
    cell.controller
        .faults()
        .set(|faults| faults.lead_through_reverts = true);
    let refusal = cell.robot.start_guidance().await.unwrap_err();
    assert_eq!(refusal.code(), "lead_through_reverted");
    assert!(refusal.to_string().contains("90515"), "{refusal}");
    assert!(!refusal.advice().is_empty());
    let idle = cell.wait_for_state(RobotState::Idle).await;
    assert_eq!(idle.fault, None);

    cell.controller
        .faults()
        .set(|faults| faults.lead_through_reverts = false);
    cell.robot.start_guidance().await.unwrap();
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_safety_stop_while_guiding_ends_it_and_says_why() {
    let mut cell = Cell::start().await;
    let mut events = cell.robot.start_guidance().await.unwrap();
    cell.controller.faults().guard_stop(true);
    let (_, reason) = until_ended(&mut events).await;
    assert!(
        reason.contains("guard") || reason.contains("hold"),
        "{reason}"
    );
    cell.wait_for_state(RobotState::Idle).await;
    let refusal = cell.robot.start_guidance().await.unwrap_err();
    assert_eq!(refusal.code(), "robot_not_ready");
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn the_safety_controller_taking_lead_through_back_later_ends_guidance() {
    let mut cell = Cell::start().await;
    let mut events = cell.robot.start_guidance().await.unwrap();
    cell.controller.faults().violate_tool_speed();
    let (_, reason) = until_ended(&mut events).await;
    assert_eq!(reason, "the robot took hold of the arm again");
    cell.wait_for_state(RobotState::Idle).await;
    cell.end().await;
}
