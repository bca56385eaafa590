//! Motions of the virtual arm: started once, judged, and stopped.

use std::sync::Arc;
use std::time::Duration;

use motion::JointAngles;
use tokio::time::timeout;

use super::{RunningApp, arm, with_arm};
use crate::arms::Arm;
use crate::ids::{ModelId, TaskId};
use crate::planning::{PlanRequest, Target};
use crate::plans::KnownPlan;
use crate::reproducing::{ReproducingError, StartRequest};
use crate::store::flights::Stretch;
use crate::store::reproductions::ReproductionState;
use crate::test_support::TestFolder;
use crate::training::{self, Wish};
use crate::uploads;

/// Plans a short motion from where the arm stands, by a model that is trained for it.
async fn planned(app: &RunningApp, task: TaskId) -> Arc<KnownPlan> {
    let model = trained(app, task).await;
    plan_for(app, arm(app), task, model).await
}

/// A model of a short motion from where the first arm stands.
pub(super) async fn trained(app: &RunningApp, task: TaskId) -> ModelId {
    let state = &app.state;
    let (mut events, now) = (state.events.listen(), state.clock.now());
    let home = arm(app).robot.view().borrow().joints_deg.unwrap();
    let mut text = "t_s,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n".to_owned();
    for row in 0..=60 {
        // Every joint has a pace of its own, so that the path is no straight line.
        let turn = |joint: usize| {
            let share = (f64::from(row) / 60.0).powf(1.0 + 0.3 * joint as f64);
            4.0 - 4.0 * (std::f64::consts::PI * share).cos()
        };
        let joints: Vec<String> = (0..6).map(|j| (home[j] + turn(j)).to_string()).collect();
        text += &format!("{},{}\n", f64::from(row) * 0.02, joints.join(","));
    }
    let take = uploads::store(&state.store, task, "short", text, now)
        .await
        .unwrap();
    let wish = Wish {
        task_id: task,
        demonstrations: Some(vec![take.id]),
        method: None,
        seed: None,
    };
    let (job, model) = training::begin(&state.store, &state.queue, wish)
        .await
        .unwrap();
    let trained = async {
        while state.store.job(job.id).await.unwrap().finished_at.is_none() {
            events.recv().await.ok();
        }
    };
    timeout(Duration::from_secs(120), trained).await.unwrap();
    model.id
}

/// A plan of this model for this arm, as it stands.
pub(super) async fn plan_for(
    app: &RunningApp,
    arm: &Arm,
    task: TaskId,
    model: ModelId,
) -> Arc<KnownPlan> {
    let learnt = training::load(&app.state.store, model).await.unwrap();
    let request = PlanRequest {
        start: Target::AsTaught,
        goal: Target::AsTaught,
        speed: 1.0,
    };
    let present = arm.robot.view().borrow().joints_deg.map(JointAngles);
    let (id, limits) = (&arm.id, &arm.limits);
    let plan = KnownPlan::make(id, limits, task, model, learnt, &request, present).unwrap();
    app.state.plans.remember(plan)
}

#[tokio::test(flavor = "multi_thread")]
async fn a_motion_is_started_once_and_judged_by_what_was_measured() {
    let folder = TestFolder::new();
    let (app, task) = with_arm(folder.path()).await;
    let plan = planned(&app, task).await;
    let start = StartRequest {
        plan: plan.plan.hash().to_owned(),
        id: None,
        key: Some("once".into()),
        hold: false,
    };
    let reproducer = &arm(&app).reproducer;
    let begun = reproducer.start(start.clone()).await.unwrap();
    assert_eq!(begun.state, ReproductionState::Running);
    assert_eq!(reproducer.start(start.clone()).await.unwrap().id, begun.id);
    let other = StartRequest {
        plan: "other".into(),
        ..start.clone()
    };
    let reused = reproducer.start(other).await;
    assert!(matches!(reused, Err(ReproducingError::KeyReused)));
    reproducer.settled().await;
    let ended = app.state.store.reproduction(begun.id).await.unwrap();
    assert_eq!(
        ended.state,
        ReproductionState::Succeeded,
        "{:?}",
        ended.reason
    );
    assert!(ended.e_j_deg.unwrap() < 0.05, "{ended:?}");
    assert!((0.99..1.01).contains(&ended.gmcc.unwrap()), "{ended:?}");
    let (mut pages, mut cycles) = (app.state.store.flight(begun.id, Stretch::ALL), Vec::new());
    while let Some(page) = pages.next().await.unwrap() {
        cycles.extend(page);
    }
    assert_eq!(ended.cycles.unwrap().total, cycles.len() as u64);
    assert!(ended.armed_at.unwrap() >= ended.created_at);
    let (first, last) = (cycles[0], cycles[cycles.len() - 1]);
    assert!(
        last.measured_deg[0] - first.measured_deg[0] > 7.0,
        "the arm really moved"
    );
    assert_eq!(
        reproducer.start(start).await.unwrap(),
        ended,
        "and it does not move again"
    );

    let again = StartRequest {
        plan: plan.plan.hash().to_owned(),
        id: None,
        key: None,
        hold: false,
    };
    let moved = reproducer.start(again).await;
    let Err(ReproducingError::Robot(error)) = moved else {
        panic!("{moved:?}")
    };
    assert_eq!(error.code(), "arm_moved");
    let all = app.state.store.reproductions(None, 200).await.unwrap();
    assert_eq!(all.len(), 1, "a refused start is no reproduction");
    app.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_motion_can_be_stopped_and_says_so() {
    let folder = TestFolder::new();
    let (app, task) = with_arm(folder.path()).await;
    let plan = planned(&app, task).await;
    let start = StartRequest {
        plan: plan.plan.hash().to_owned(),
        id: None,
        key: None,
        hold: false,
    };
    let begun = arm(&app).reproducer.start(start).await.unwrap();
    let mut view = arm(&app).robot.view();
    let moving = view.wait_for(|view| view.run.is_some_and(|run| run.t_s > 0.2));
    timeout(Duration::from_secs(20), moving)
        .await
        .unwrap()
        .unwrap();
    let stopped = arm(&app).reproducer.stop(begun.id).await.unwrap();
    assert_eq!(stopped.state, ReproductionState::Stopped);
    assert_eq!((stopped.e_j_deg, stopped.gmcc), (None, None));
    assert!(stopped.tracking_error_deg.is_some() && stopped.finished_at.is_some());
    let twice = arm(&app).reproducer.stop(begun.id).await.unwrap();
    assert_eq!(twice, stopped);
    app.shutdown().await;
}
