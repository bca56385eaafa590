//! Recording from the virtual arm, in every way that a recording can end.

use std::time::Duration;

use robot::{HandActivity, HandScript, RobotState};
use tokio::time::timeout;

use super::{App, RunningApp, arm, by_hand, config, heard, robot_is, with_arm};
use crate::config::RobotChoice;
use crate::recording::{HandShowing, Order, RecordingError, RecordingRequest};
use crate::store::demonstrations::DemonstrationState;
use crate::test_support::TestFolder;

const HAND: HandShowing = HandShowing {
    script: HandScript::F1,
    seed: 1,
};

#[tokio::test(flavor = "multi_thread")]
async fn a_recording_is_begun_once_and_ends_when_it_is_stopped() {
    let folder = TestFolder::new();
    let (app, task) = with_arm(folder.path()).await;
    let mut events = app.state.events.listen();
    let request = by_hand(task);
    let (begun, made) = arm(&app).recorder.start(request).await.unwrap();
    assert_eq!((begun.state, made), (DemonstrationState::Recording, true));
    let (again, made) = arm(&app).recorder.start(request).await.unwrap();
    assert_eq!((again.id, made), (begun.id, false));
    let other = arm(&app).recorder.start(by_hand(task)).await;
    assert!(matches!(other, Err(RecordingError::Busy)));
    let free = arm(&app).recorder.set_free(true).await;
    assert!(matches!(free, Err(RecordingError::Busy)));
    heard(&mut events, |d| d.duration_s > 1.2).await;
    let ended = arm(&app).recorder.stop(begun.id).await.unwrap();
    assert_eq!(
        (ended.state, ended.note.as_deref()),
        (DemonstrationState::Recorded, None)
    );
    assert!(
        ended.problem.unwrap().contains("does not move"),
        "nobody moved the arm"
    );
    let samples = app.state.store.samples(begun.id).await.unwrap();
    assert_eq!(samples.len() as u64, ended.samples);
    assert_eq!(samples[0].at_us, 0);
    assert!(samples.windows(2).all(|pair| pair[0].at_us < pair[1].at_us));
    robot_is(&app, RobotState::Idle).await;
    let twice = arm(&app).recorder.stop(begun.id).await.unwrap();
    assert_eq!(twice.state, DemonstrationState::Recorded);
    app.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn an_arm_in_somebodys_hand_can_be_recorded_and_a_stop_of_the_arm_is_noted() {
    let folder = TestFolder::new();
    let (app, task) = with_arm(folder.path()).await;
    let mut events = app.state.events.listen();
    arm(&app).recorder.set_free(true).await.unwrap();
    arm(&app).recorder.set_free(true).await.unwrap();
    robot_is(&app, RobotState::Guiding).await;
    let (begun, _) = arm(&app).recorder.start(by_hand(task)).await.unwrap();
    arm(&app).recorder.hand_returns(HAND).await.unwrap();
    heard(&mut events, |d| d.duration_s > 1.2).await;
    arm(&app).robot.stop();
    let ended = heard(&mut events, |d| d.state == DemonstrationState::Recorded).await;
    assert_eq!(ended.id, begun.id);
    assert!(ended.usable && ended.note.unwrap().contains("stopped"));
    robot_is(&app, RobotState::Idle).await;
    arm(&app).recorder.set_free(true).await.unwrap();
    arm(&app).recorder.set_free(false).await.unwrap();
    arm(&app).recorder.set_free(false).await.unwrap();
    robot_is(&app, RobotState::Idle).await;
    app.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_showing_prepares_first_and_lead_through_that_fails_closes_it_with_words() {
    let folder = TestFolder::new();
    let (app, task) = with_arm(folder.path()).await;
    let mut events = app.state.events.listen();
    let cut = RecordingRequest {
        hand: Some(HAND),
        ..by_hand(task)
    };
    let (begun, _) = arm(&app).recorder.start(cut).await.unwrap();
    assert_eq!(begun.state, DemonstrationState::Preparing);
    let ended = arm(&app).recorder.stop(cut.id).await.unwrap();
    assert_eq!(
        ended.state,
        DemonstrationState::Discarded,
        "nothing was shown yet"
    );

    robot_is(&app, RobotState::Idle).await;
    let showing = RecordingRequest {
        hand: Some(HAND),
        ..by_hand(task)
    };
    arm(&app).recorder.start(showing).await.unwrap();
    heard(&mut events, |d| {
        d.state == DemonstrationState::Recording && d.duration_s > 1.2
    })
    .await;
    app.virtual_faults().unwrap().guard_stop(true);
    let ended = heard(&mut events, |d| d.state == DemonstrationState::Recorded).await;
    assert_eq!(ended.id, showing.id);
    assert!(!ended.note.unwrap().is_empty());
    app.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_server_that_is_stopped_closes_the_recording() {
    let folder = TestFolder::new();
    let (app, task) = with_arm(folder.path()).await;
    let mut events = app.state.events.listen();
    let (begun, _) = arm(&app).recorder.start(by_hand(task)).await.unwrap();
    heard(&mut events, |d| d.samples > 20).await;
    app.shutdown().await;
    let app = App::start(config(folder.path(), RobotChoice::None))
        .await
        .unwrap();
    let kept = app.state.store.demonstration(begun.id).await.unwrap();
    assert_eq!(kept.state, DemonstrationState::Recorded);
    assert!(kept.samples > 20 && kept.note.unwrap().contains("server was stopped"));
    app.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_recording_is_held_up_and_goes_on_only_from_the_same_place() {
    let folder = TestFolder::new();
    let (app, task) = with_arm(folder.path()).await;
    let mut events = app.state.events.listen();
    let recorder = &arm(&app).recorder;
    recorder.set_free(true).await.unwrap();
    hand_is_done(&app, HandScript::F1, 1).await;
    let (begun, _) = recorder.start(by_hand(task)).await.unwrap();
    heard(&mut events, |d| d.duration_s > 0.3).await;

    let paused = recorder.order(begun.id, Order::Pause).await.unwrap();
    let at_deg = paused.paused_at_deg.unwrap();
    assert_eq!(
        (paused.state, paused.pauses),
        (DemonstrationState::Recording, 1)
    );
    let again = recorder.order(begun.id, Order::Pause).await.unwrap();
    assert_eq!(again, paused, "nothing comes in while it is held up");
    hand_is_done(&app, HandScript::F3, 7).await;
    let elsewhere = recorder.order(begun.id, Order::Resume).await;
    assert!(
        matches!(elsewhere, Err(RecordingError::Elsewhere { off_deg, .. }) if off_deg > 2.0),
        "{elsewhere:?}"
    );
    let open = app.state.store.demonstration(begun.id).await.unwrap();
    assert_eq!(open, paused, "a refusal changes nothing");

    hand_is_done(&app, HandScript::F1, 1).await;
    let robot = &arm(&app).robot;
    robot.set_signal("GripperClose", true).await.unwrap();
    let going_on = recorder.order(begun.id, Order::Resume).await.unwrap();
    assert_eq!(going_on.paused_at_deg, None);
    heard(&mut events, |d| d.samples > paused.samples + 10).await;
    let ended = recorder.stop(begun.id).await.unwrap();
    let store = &app.state.store;
    let samples = store.samples(begun.id).await.unwrap();
    let steps_us = samples.windows(2).map(|pair| pair[1].at_us - pair[0].at_us);
    assert!(
        steps_us.clone().all(|step| (1..200_000).contains(&step)),
        "the pause is closed up"
    );
    assert!(
        samples.iter().all(|sample| {
            let off = sample
                .joints_deg
                .iter()
                .zip(&at_deg)
                .map(|(a, b)| (a - b).abs());
            off.fold(0.0, f64::max) < 2.1
        }),
        "nothing of the way to the other place is recorded"
    );
    let pauses = store.pauses(begun.id).await.unwrap();
    assert!(pauses[0].length_us.unwrap() > 500_000, "{pauses:?}");
    let signals = store.signals(begun.id).await.unwrap();
    let worked: Vec<_> = signals.iter().filter(|s| s.at_us > 0).collect();
    assert_eq!(worked.len(), 1, "{signals:?}");
    assert_eq!((worked[0].at_us, worked[0].on), (pauses[0].at_us, true));
    assert_eq!((ended.pauses, ended.paused_at_deg), (1, None));
    app.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_recording_that_ends_in_a_pause_is_whole_and_the_hand_can_not_be_held_up() {
    let folder = TestFolder::new();
    let (app, task) = with_arm(folder.path()).await;
    let mut events = app.state.events.listen();
    let recorder = &arm(&app).recorder;
    let (begun, _) = recorder.start(by_hand(task)).await.unwrap();
    heard(&mut events, |d| d.samples > 20).await;
    let paused = recorder.order(begun.id, Order::Pause).await.unwrap();
    let ended = recorder.stop(begun.id).await.unwrap();
    assert_eq!((ended.samples, ended.paused_at_deg), (paused.samples, None));
    let pauses = app.state.store.pauses(begun.id).await.unwrap();
    assert_eq!(pauses[0].length_us, None);
    let over = recorder.order(begun.id, Order::Resume).await;
    assert!(matches!(over, Err(RecordingError::NotOpen)));

    robot_is(&app, RobotState::Idle).await;
    let showing = RecordingRequest {
        hand: Some(HAND),
        ..by_hand(task)
    };
    recorder.start(showing).await.unwrap();
    let refused = recorder.order(showing.id, Order::Pause).await;
    assert!(matches!(refused, Err(RecordingError::HandGoesOn)));
    recorder.stop(showing.id).await.unwrap();
    app.shutdown().await;
}

/// Has the virtual hand bring the arm to the start of a script and waits until it is there.
async fn hand_is_done(app: &RunningApp, script: HandScript, seed: u64) {
    let recorder = &arm(app).recorder;
    let hand = HandShowing { script, seed };
    recorder.hand_returns(hand).await.unwrap();
    let mut view = arm(app).robot.view();
    let idle = view.wait_for(|view| view.hand == Some(HandActivity::Idle));
    timeout(Duration::from_secs(30), idle)
        .await
        .unwrap()
        .unwrap();
}
