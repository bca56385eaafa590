//! What people say: outcomes, replies to the questionnaire, and what the dashboard makes of them.

use super::super::questionnaire::{Given, Period, Reply};
use super::super::reproductions::{NewReproduction, ReproductionResult, ReproductionState};
use super::super::{Error, Store, outcomes::Outcome};
use super::{NOW, store, task, training};
use crate::clock::WallTime;
use crate::ids::{ModelId, PersonId, ReplyId, ReproductionId, TaskId};

const DAY_MS: i64 = 86_400_000;

async fn run(store: &Store, task_id: TaskId, model_id: ModelId, backwards: bool) -> ReproductionId {
    let id = ReproductionId::new();
    let new = NewReproduction {
        id,
        task_id,
        model_id,
        robot: "left",
        plan: "aa",
        start_deg: &[1.0; 6],
        goal_deg: &[2.0; 6],
        duration_s: 7.5,
        backwards,
        idempotency_key: None,
    };
    store.create_reproduction(new, NOW).await.unwrap();
    id
}

async fn end(store: &Store, id: ReproductionId, state: ReproductionState, e_j_deg: Option<f64>) {
    let result = ReproductionResult {
        state,
        reason: None,
        e_j_deg,
        e_j_commanded_deg: None,
        gmcc: e_j_deg.map(|_| 0.99),
        tracking_error_deg: None,
        cycles: None,
    };
    store.finish_reproduction(id, &result, NOW).await.unwrap();
}

fn outcome(worked: bool, note: Option<&str>) -> Outcome {
    Outcome {
        worked,
        note: note.map(str::to_owned),
        at: NOW.plus_ms(1),
    }
}

#[tokio::test]
async fn an_outcome_is_nothing_until_said_and_can_be_said_anew_or_taken_back() {
    let (store, _folder) = store().await;
    let task = task(&store).await;
    let (_, model, _) = training(&store, task, "a").await;
    let id = run(&store, task, model.id, false).await;
    let early = store.set_outcome(id, Some(&outcome(true, None))).await;
    assert!(matches!(early, Err(Error::WrongState { .. })));
    end(&store, id, ReproductionState::Succeeded, Some(0.02)).await;
    assert_eq!(store.reproduction(id).await.unwrap().outcome, None);
    for said in [outcome(false, Some("dropped it")), outcome(true, None)] {
        let told = store.set_outcome(id, Some(&said)).await.unwrap();
        assert_eq!(told.outcome, Some(said));
    }
    assert_eq!(store.set_outcome(id, None).await.unwrap().outcome, None);
    let nobody = store.set_outcome(ReproductionId::new(), None).await;
    assert!(matches!(nobody, Err(Error::NotFound { .. })));
}

#[tokio::test]
async fn the_dashboard_counts_tries_and_leaves_ways_back_out() {
    let (store, _folder) = store().await;
    let drill = task(&store).await;
    let (_, model, _) = training(&store, drill, "a").await;
    let idle = task(&store).await;
    let mut runs = Vec::new();
    for (state, e_j, backwards, worked) in [
        (ReproductionState::Succeeded, Some(0.02), false, Some(true)),
        (ReproductionState::Succeeded, Some(0.04), false, Some(false)),
        (ReproductionState::Stopped, None, false, None),
        (ReproductionState::Succeeded, Some(9.0), true, None),
    ] {
        let id = run(&store, drill, model.id, backwards).await;
        end(&store, id, state, e_j).await;
        if let Some(worked) = worked {
            let said = outcome(worked, None);
            store.set_outcome(id, Some(&said)).await.unwrap();
        }
        runs.push(id);
    }
    let moving = run(&store, drill, model.id, false).await;
    let summaries = store.task_summaries().await.unwrap();
    let [first, second] = &summaries[..] else {
        panic!("{summaries:?}");
    };
    assert_eq!((first.task_id, second.task_id), (drill, idle));
    let counts = (first.runs, first.succeeded, first.judged, first.worked);
    assert_eq!(
        counts,
        (3, 2, 2, 1),
        "neither the way back nor the running one"
    );
    assert!((first.e_j_mean_deg.unwrap() - 0.03).abs() < 1e-12);
    assert_eq!((second.runs, second.last_run_at), (0, None));
    let latest = store.latest_runs(3).await.unwrap();
    let ids: Vec<ReproductionId> = latest.iter().map(|run| run.id).collect();
    assert_eq!(ids, [moving, runs[2], runs[1]]);
    assert_eq!(latest[2].worked, Some(false));
    store.delete_task(drill, NOW).await.unwrap();
    assert_eq!(store.task_summaries().await.unwrap().len(), 1);
    assert_eq!(store.latest_runs(1).await.unwrap()[0].task_name, "Drill");
}

fn reply(task_id: TaskId, at: WallTime, answers: Option<[u8; 5]>) -> Reply {
    Reply {
        id: ReplyId::new(),
        task_id,
        reproduction_id: None,
        at,
        answers,
    }
}

#[tokio::test]
async fn one_person_replies_once_in_a_time_and_a_repeated_request_is_the_same_reply() {
    let (store, _folder) = store().await;
    let task = task(&store).await;
    let (person, other) = (PersonId::new(), PersonId::new());
    assert_eq!(store.last_reply(person).await.unwrap(), None);
    let first = reply(task, NOW, Some([5, 4, 3, 2, 1]));
    let since = NOW.plus_ms(-1);
    let add = async |person, reply: &Reply| store.add_reply(person, reply, since).await;
    assert_eq!(
        add(person, &first).await.unwrap(),
        Given::Stored(first.clone())
    );
    assert_eq!(
        add(person, &first).await.unwrap(),
        Given::Known(first.clone())
    );
    assert!(matches!(
        add(other, &first).await,
        Err(Error::IdTaken { .. })
    ));
    let second = reply(task, NOW, None);
    assert_eq!(add(person, &second).await.unwrap(), Given::TooSoon);
    assert_eq!(add(other, &second).await.unwrap(), Given::Stored(second));
    assert_eq!(store.last_reply(person).await.unwrap(), Some(NOW));
    assert_eq!(
        store.last_reply(other).await.unwrap(),
        Some(NOW),
        "declining counts"
    );
}

#[tokio::test]
async fn replies_are_averaged_by_task_and_by_week_and_month() {
    let (store, _folder) = store().await;
    let task = task(&store).await;
    // 2023-11-14 22:13 UTC, a Tuesday; the Sunday after, the Monday after that, and December.
    let times = [0, 5, 6, 20].map(|days| NOW.plus_ms(days * DAY_MS));
    let answers = [[5, 5, 5, 5, 1], [3, 5, 5, 5, 1], [1, 2, 3, 4, 5], [2; 5]];
    for (at, answers) in times.into_iter().zip(answers) {
        for given in [Some(answers), None] {
            let reply = reply(task, at, given);
            store.add_reply(PersonId::new(), &reply, at).await.unwrap();
        }
    }
    let by = async |period| {
        let results = store.questionnaire_results(period).await.unwrap();
        let row = |one: super::super::questionnaire::QuestionnaireResult| {
            assert_eq!((one.task_id, one.task_name.as_str()), (task, "Drill"));
            (one.from, one.replies, one.mean)
        };
        results.into_iter().map(row).collect::<Vec<_>>()
    };
    let all = by(Period::All).await;
    assert_eq!(
        all,
        [("2023-11-14".to_owned(), 4, [2.75, 3.5, 3.75, 4.0, 2.25])]
    );
    let weeks: Vec<(String, u32)> = by(Period::Week)
        .await
        .into_iter()
        .map(|w| (w.0, w.1))
        .collect();
    let expected = [("2023-11-13", 2), ("2023-11-20", 1), ("2023-12-04", 1)];
    assert_eq!(
        weeks,
        expected.map(|(from, replies)| (from.to_owned(), replies))
    );
    let months = by(Period::Month).await;
    assert_eq!(
        months[0],
        (
            "2023-11-01".to_owned(),
            3,
            [3.0, 4.0, 13.0 / 3.0, 14.0 / 3.0, 7.0 / 3.0]
        )
    );
    assert_eq!(months[1], ("2023-12-01".to_owned(), 1, [2.0; 5]));
    store.delete_task(task, NOW).await.unwrap();
    assert!(by(Period::All).await.is_empty());
}
