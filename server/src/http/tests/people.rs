//! Outcomes, the questionnaire and the dashboard, as far as they go without an arm.

use serde_json::{Value, json};

use super::{Api, NOW};
use crate::ids::{ReproductionId, TaskId};
use crate::store::jobs::NewTraining;
use crate::store::reproductions::{NewReproduction, ReproductionResult, ReproductionState};

const QUESTIONNAIRE: &str = "/api/v1/questionnaire";
const PERSON: &str = "0190b5a2-0000-7000-8000-00000000000a";
const HOUR_MS: i64 = 3_600_000;

/// A motion of the task; it has ended unless it shall still run.
async fn motion(api: &Api, task: &str, running: bool) -> String {
    let task_id: TaskId = task.parse().unwrap();
    let id = ReproductionId::new();
    let key = id.to_string();
    let training = NewTraining {
        task_id,
        sources: &[],
        method: "paper",
        seed: 0,
        unique_key: &key,
        max_attempts: 1,
    };
    let store = &api.state.store;
    let (_, model, _) = store.create_training(training, NOW).await.unwrap();
    let new = NewReproduction {
        id,
        task_id,
        model_id: model.id,
        robot: "none",
        plan: "aa",
        start_deg: &[0.0; 6],
        goal_deg: &[1.0; 6],
        duration_s: 3.0,
        backwards: false,
        idempotency_key: None,
    };
    store.create_reproduction(new, NOW).await.unwrap();
    if !running {
        let result = ReproductionResult {
            state: ReproductionState::Succeeded,
            reason: None,
            e_j_deg: Some(0.02),
            e_j_commanded_deg: None,
            gmcc: Some(0.99),
            tracking_error_deg: None,
            cycles: None,
        };
        store.finish_reproduction(id, &result, NOW).await.unwrap();
    }
    key
}

#[tokio::test]
async fn a_person_says_that_a_motion_worked_changes_it_and_takes_it_back() {
    let api = Api::local().await;
    let task = api.task().await;
    let id = motion(&api, &task, false).await;
    let path = format!("/api/v1/reproductions/{id}");
    let outcome = format!("{path}/outcome");
    assert_eq!(api.get(&path).await.ok(200)["outcome"], Value::Null);
    let mut events = api.state.events.listen();
    let no = json!({"worked": false, "note": " It dropped the part. "});
    let said = api.json("PUT", &outcome, no).await.ok(200);
    assert_eq!(
        said["outcome"],
        json!({"worked": false, "note": "It dropped the part.", "at": "2023-11-14T22:13:20.000Z"})
    );
    let told = serde_json::to_value(events.recv().await.unwrap()).unwrap();
    assert_eq!(told["reproduction"], said, "every phone hears of it");
    let yes = api.json("PUT", &outcome, json!({"worked": true})).await;
    assert_eq!(yes.ok(200)["outcome"]["worked"], true);
    assert_eq!(yes.json()["outcome"]["note"], Value::Null);
    let dashboard = api.get("/api/v1/dashboard").await.ok(200);
    assert_eq!(dashboard["runs"][0]["worked"], true);
    let counts = ["runs", "succeeded", "judged", "worked"].map(|one| &dashboard["tasks"][0][one]);
    assert_eq!(counts, [1, 1, 1, 1]);
    let back = api.json("DELETE", &outcome, json!(null)).await;
    assert_eq!(back.ok(200)["outcome"], Value::Null);
    let long = json!({"worked": true, "note": "x".repeat(401)});
    api.json("PUT", &outcome, long)
        .await
        .problem(422, "bad_note");
    api.json("PUT", &outcome, json!({}))
        .await
        .problem(422, "bad_field");
}

#[tokio::test]
async fn nothing_is_said_of_a_motion_that_still_runs() {
    let api = Api::local().await;
    let task = api.task().await;
    let id = motion(&api, &task, true).await;
    let outcome = format!("/api/v1/reproductions/{id}/outcome");
    let early = api.json("PUT", &outcome, json!({"worked": true})).await;
    early.problem(409, "wrong_state");
}

#[tokio::test]
async fn the_list_of_motions_can_be_short() {
    let api = Api::local().await;
    let task = api.task().await;
    motion(&api, &task, false).await;
    let latest = motion(&api, &task, false).await;
    let path = format!("/api/v1/reproductions?task={task}&limit=1");
    let list = api.get(&path).await.ok(200);
    assert_eq!(list.as_array().unwrap().len(), 1);
    assert_eq!(list[0]["id"], json!(latest));
}

#[tokio::test]
async fn a_person_is_asked_once_in_a_shift() {
    let api = Api::local().await;
    let task = api.task().await;
    let after = motion(&api, &task, false).await;
    let path = format!("{QUESTIONNAIRE}/due?person={PERSON}&reproduction={after}");
    assert_eq!(api.get(&path).await.ok(200), json!({"due": true}));
    let answers = json!({
        "id": "0190b5a2-0000-7000-8000-000000000001", "person": PERSON, "task_id": task,
        "reproduction_id": after, "answers": [5, 4, 4, 5, 3],
    });
    let given = api.post(QUESTIONNAIRE, answers.clone()).await.ok(201);
    assert_eq!(
        given["person"],
        Value::Null,
        "whose reply it is is not told"
    );
    assert_eq!(api.post(QUESTIONNAIRE, answers).await.ok(200), given);
    let due = api.get(&path).await.ok(200);
    assert_eq!(
        due,
        json!({"due": false, "not_before": "2023-11-15T06:13:20.000Z"})
    );
    let more = json!({"person": PERSON, "task_id": task, "answers": [1, 1, 1, 1, 1]});
    let refused = api.post(QUESTIONNAIRE, more.clone()).await;
    refused.problem(409, "already_answered");
    api.clock.advance_ms(8 * HOUR_MS);
    let next_shift = api
        .get(&format!("{QUESTIONNAIRE}/due?person={PERSON}"))
        .await;
    assert_eq!(next_shift.ok(200), json!({"due": true}));
    let old = api.get(&path).await.ok(200);
    assert_eq!(old["due"], false, "not about a motion of long ago");
    api.post(QUESTIONNAIRE, more).await.ok(201);
    let results = api.get(&format!("{QUESTIONNAIRE}/results")).await.ok(200);
    assert_eq!(results[0]["replies"], 2);
    assert_eq!(results[0]["mean"], json!([3.0, 2.5, 2.5, 3.0, 2.0]));
}

#[tokio::test]
async fn who_does_not_want_to_answer_is_left_alone_for_the_shift_and_is_no_result() {
    let api = Api::local().await;
    let task = api.task().await;
    let declined = json!({"person": PERSON, "task_id": task});
    assert_eq!(
        api.post(QUESTIONNAIRE, declined).await.ok(201)["answers"],
        Value::Null
    );
    let due = api
        .get(&format!("{QUESTIONNAIRE}/due?person={PERSON}"))
        .await;
    assert_eq!(due.ok(200)["due"], false);
    let other = "0190b5a2-0000-7000-8000-00000000000b";
    let due = api
        .get(&format!("{QUESTIONNAIRE}/due?person={other}"))
        .await;
    assert_eq!(due.ok(200)["due"], true);
    let results = api.get(&format!("{QUESTIONNAIRE}/results?by=week")).await;
    assert_eq!(results.ok(200), json!([]));
}

#[tokio::test]
async fn replies_that_make_no_sense_are_refused() {
    let api = Api::local().await;
    let (task, other) = (api.task().await, api.task().await);
    let wish = |answers: Value| json!({"person": PERSON, "task_id": task, "answers": answers});
    for (answers, statement) in [([0, 1, 1, 1, 1], 1), ([5, 5, 5, 5, 6], 5)] {
        let refused = api.post(QUESTIONNAIRE, wish(json!(answers))).await;
        let problem = refused.problem(422, "bad_answer");
        assert_eq!(problem["where"]["statement"], statement);
    }
    let four = api.post(QUESTIONNAIRE, wish(json!([1, 2, 3, 4]))).await;
    four.problem(422, "bad_field");
    let after = motion(&api, &other, false).await;
    let crossed = json!({"person": PERSON, "task_id": task, "reproduction_id": after});
    api.post(QUESTIONNAIRE, crossed)
        .await
        .problem(422, "other_task");
    let nothing = json!({"person": PERSON, "task_id": PERSON});
    api.post(QUESTIONNAIRE, nothing)
        .await
        .problem(404, "not_found");
    let unnamed = api.get(&format!("{QUESTIONNAIRE}/due")).await;
    unnamed.problem(400, "bad_query");
    let decade = api.get(&format!("{QUESTIONNAIRE}/results?by=decade")).await;
    decade.problem(400, "bad_query");
}

#[tokio::test]
async fn the_dashboard_shows_robots_work_and_tasks() {
    let api = Api::local().await;
    let task = api.task().await;
    let running = motion(&api, &task, true).await;
    let dashboard = api.get("/api/v1/dashboard").await.ok(200);
    assert_eq!(dashboard["at"], "2023-11-14T22:13:20.000Z");
    assert_eq!(dashboard["robots"][0]["id"], "none");
    assert_eq!(dashboard["jobs"][0]["state"], "queued");
    assert_eq!(dashboard["runs"][0]["id"], json!(running));
    assert_eq!(dashboard["runs"][0]["task_name"], "Drill");
    assert_eq!(
        dashboard["tasks"][0]["runs"], 0,
        "a running one is no result yet"
    );
}
