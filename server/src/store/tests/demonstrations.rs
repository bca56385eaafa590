//! Recordings: what is committed stays, in whatever way the recording ends.

use super::super::Error;
use super::super::demonstrations::{Decision, DemonstrationState};
use super::super::recordings::{Closing, Gap, NewSamples};
use super::super::samples::Sample;
use super::super::signals::SignalEvent;
use super::{NOW, new_demonstration, samples, store, task};
use crate::ids::DemonstrationId;

fn chunk(seq: usize, samples: &[Sample]) -> NewSamples<'_> {
    NewSamples {
        seq,
        samples,
        gaps: &[],
        signals: &[],
    }
}

const RECORDED: Closing<'static> = Closing {
    state: DemonstrationState::Recorded,
    note: None,
    problem: None,
};

#[tokio::test]
async fn chunks_come_back_in_order_with_their_counters() {
    let (store, _folder) = store().await;
    let new = new_demonstration(task(&store).await);
    let made = store.create_demonstration(new, NOW).await.unwrap();
    assert_eq!((made.take, made.samples, made.usable), (1, 0, false));
    let first = samples(0, 20);
    let second = samples(250_000, 30);
    let gap = Gap {
        at_us: 190_000,
        length_us: 60_000,
    };
    store
        .append_samples(new.id, chunk(0, &first))
        .await
        .unwrap();
    let with_gap = NewSamples {
        gaps: &[gap],
        ..chunk(1, &second)
    };
    let open = store.append_samples(new.id, with_gap).await.unwrap();
    assert_eq!((open.samples, open.gaps), (50, 1));
    assert!((open.duration_s - 0.54).abs() < 1e-9);
    assert!((open.rate_hz - 49.0 / 0.54).abs() < 1e-6);
    let last = samples(600_000, 2);
    let closing = Closing {
        note: Some("note"),
        ..RECORDED
    };
    let closed = store
        .close_demonstration(new.id, chunk(2, &last), &closing)
        .await
        .unwrap();
    let all = [first, second, last].concat();
    assert_eq!(store.samples(new.id).await.unwrap(), all);
    assert_eq!(store.gaps(new.id).await.unwrap(), [gap]);
    assert_eq!(
        (closed.state, closed.samples),
        (DemonstrationState::Recorded, 52)
    );
    assert_eq!(closed.note.as_deref(), Some("note"));
    assert!(closed.usable);
    let again = store
        .close_demonstration(new.id, chunk(3, &samples(700_000, 2)), &RECORDED)
        .await;
    assert!(matches!(again, Err(Error::WrongState { .. })));
    assert_eq!(
        store.samples(new.id).await.unwrap(),
        all,
        "nothing is added to what is closed"
    );
}

#[tokio::test]
async fn takes_are_counted_within_a_task() {
    let (store, _folder) = store().await;
    let (drill, weld) = (task(&store).await, task(&store).await);
    for (task, take) in [(drill, 1), (drill, 2), (weld, 1), (drill, 3)] {
        let made = store
            .create_demonstration(new_demonstration(task), NOW)
            .await
            .unwrap();
        assert_eq!(made.take, take);
    }
    let takes: Vec<u32> = store
        .demonstrations(drill)
        .await
        .unwrap()
        .iter()
        .map(|d| d.take)
        .collect();
    assert_eq!(takes, [1, 2, 3]);
}

#[tokio::test]
async fn discarding_keeps_the_data_and_can_be_undone() {
    let (store, _folder) = store().await;
    let new = new_demonstration(task(&store).await);
    store.create_demonstration(new, NOW).await.unwrap();
    let early = store.decide(new.id, Decision::Keep).await;
    assert!(matches!(
        early,
        Err(Error::WrongState {
            state: "recording",
            ..
        })
    ));
    store
        .append_samples(new.id, chunk(0, &samples(0, 5)))
        .await
        .unwrap();
    store
        .close_demonstration(new.id, chunk(1, &[]), &RECORDED)
        .await
        .unwrap();
    for (decision, state) in [
        (Decision::Discard, DemonstrationState::Discarded),
        (Decision::Discard, DemonstrationState::Discarded),
        (Decision::Keep, DemonstrationState::Kept),
        (Decision::Keep, DemonstrationState::Kept),
        (Decision::Discard, DemonstrationState::Discarded),
    ] {
        assert_eq!(store.decide(new.id, decision).await.unwrap().state, state);
        assert_eq!(store.samples(new.id).await.unwrap().len(), 5);
    }
    let nobody = store.decide(DemonstrationId::new(), Decision::Keep).await;
    assert!(matches!(nobody, Err(Error::NotFound { .. })));
}

#[tokio::test]
async fn a_recording_that_was_cut_off_keeps_every_chunk_and_is_offered() {
    let (store, _folder) = store().await;
    let task = task(&store).await;
    let (cut, empty) = (new_demonstration(task), new_demonstration(task));
    store.create_demonstration(cut, NOW).await.unwrap();
    store.create_demonstration(empty, NOW).await.unwrap();
    store
        .append_samples(cut.id, chunk(0, &samples(0, 40)))
        .await
        .unwrap();
    let recovered = store.recover_recordings("cut off").await.unwrap();
    assert_eq!(recovered.len(), 2);
    let offered = store.demonstration(cut.id).await.unwrap();
    assert_eq!(offered.state, DemonstrationState::Interrupted);
    assert_eq!((offered.samples, offered.usable), (40, true));
    assert_eq!(offered.note.as_deref(), Some("cut off"));
    let nothing = store.demonstration(empty.id).await.unwrap();
    assert_eq!(nothing.state, DemonstrationState::Discarded);
    assert!(store.open_demonstration("left").await.unwrap().is_none());
    let kept = store.decide(cut.id, Decision::Keep).await.unwrap();
    assert_eq!(kept.state, DemonstrationState::Kept);
}

#[tokio::test]
async fn preparing_turns_into_recording_once() {
    let (store, _folder) = store().await;
    let mut new = new_demonstration(task(&store).await);
    new.state = DemonstrationState::Preparing;
    store.create_demonstration(new, NOW).await.unwrap();
    let open = store.open_demonstration("left").await.unwrap().unwrap();
    assert_eq!(open.state, DemonstrationState::Preparing);
    let recording = store.begin_recording(new.id).await.unwrap();
    assert_eq!(recording.state, DemonstrationState::Recording);
    assert!(store.begin_recording(new.id).await.is_err());
}

#[tokio::test]
async fn a_file_is_stored_whole_with_its_tool_positions() {
    let (store, _folder) = store().await;
    let mut new = new_demonstration(task(&store).await);
    new.state = DemonstrationState::Recorded;
    let mut rows = samples(0, 4_000);
    for row in &mut rows {
        row.tcp_mm = Some([1.0, 2.0, row.at_us as f64]);
    }
    let stored = store
        .store_demonstration(new, &rows, &[], "from a file", NOW)
        .await
        .unwrap();
    assert_eq!((stored.samples, stored.usable), (4_000, true));
    assert_eq!(store.samples(new.id).await.unwrap(), rows);
    let whole = stored.duration_s;
    assert!((whole - 39.99).abs() < 1e-9);
}

#[tokio::test]
async fn a_rotten_chunk_is_noticed() {
    let (store, _folder) = store().await;
    let new = new_demonstration(task(&store).await);
    store.create_demonstration(new, NOW).await.unwrap();
    store
        .append_samples(new.id, chunk(0, &samples(0, 5)))
        .await
        .unwrap();
    sqlx::query("UPDATE demonstration_chunk SET samples = zeroblob(length(samples))")
        .execute(&store.writer)
        .await
        .unwrap();
    let damaged = store.samples(new.id).await;
    assert!(matches!(damaged, Err(Error::Damaged { .. })));
}

#[tokio::test]
async fn what_was_done_with_signals_survives_a_crash_with_the_samples_beside_it() {
    let (store, _folder) = store().await;
    let new = new_demonstration(task(&store).await);
    store.create_demonstration(new, NOW).await.unwrap();
    let event = |at_us, on| SignalEvent {
        at_us,
        name: "GripperClose".into(),
        on,
    };
    let (first, second) = ([event(0, false)], [event(120_000, true)]);
    let rows = samples(0, 20);
    let with = |seq, signals| NewSamples {
        signals,
        ..chunk(seq, &rows)
    };
    store.append_samples(new.id, with(0, &first)).await.unwrap();
    store
        .append_samples(new.id, with(1, &second))
        .await
        .unwrap();
    store.recover_recordings("cut off").await.unwrap();
    let told = store.signals(new.id).await.unwrap();
    assert_eq!(told, [first, second].concat());
    assert_eq!(store.signals(DemonstrationId::new()).await.unwrap(), []);
}
