//! Recording from the virtual arm, in every way that a recording can end.

use robot::{HandScript, RobotState};

use super::{App, arm, by_hand, config, heard, robot_is, with_arm};
use crate::config::RobotChoice;
use crate::recording::{HandShowing, RecordingError, RecordingRequest};
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
