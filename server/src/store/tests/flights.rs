//! Flight records: they grow, are read in stretches, and old ones can still be read.

use super::super::cycles::{Cycle, CycleDetails, CyclePhase};
use super::super::flights::{FlightEvent, NewFlight, Stretch};
use super::super::reproductions::NewReproduction;
use super::super::{Error, Store};
use super::{NOW, store, task, training};
use crate::ids::ReproductionId;

async fn running(store: &Store) -> ReproductionId {
    let task = task(store).await;
    let (_, model, _) = training(store, task, "a").await;
    let new = NewReproduction {
        id: ReproductionId::new(),
        task_id: task,
        model_id: model.id,
        robot: "left",
        plan: "aa",
        start_deg: &[1.0; 6],
        goal_deg: &[2.0; 6],
        duration_s: 7.5,
        backwards: false,
        idempotency_key: None,
    };
    store.create_reproduction(new, NOW).await.unwrap().id
}

fn cycles(from: u64, count: u64) -> Vec<Cycle> {
    let one = |i: u64| Cycle {
        at_us: 4_032 * i,
        plan_t_s: 0.004_032 * i as f64,
        commanded_deg: [i as f64; 6],
        measured_deg: [i as f64 - 0.5; 6],
        details: Some(CycleDetails {
            commanded_deg_s: [1.5; 6],
            utilization_percent: Some(12.0),
            lost: 0,
            phase: CyclePhase::Motion,
            late: false,
            held: false,
            limited: false,
            motors_on: true,
            rapid_running: true,
        }),
    };
    (from..from + count).map(one).collect()
}

async fn read(store: &Store, id: ReproductionId, stretch: Stretch) -> Vec<Cycle> {
    let (mut pages, mut all) = (store.flight(id, stretch), Vec::new());
    while let Some(page) = pages.next().await.unwrap() {
        assert!(!page.is_empty() && page.len() <= 16 * 50, "{}", page.len());
        all.extend(page);
    }
    all
}

#[tokio::test]
async fn a_record_grows_while_the_arm_moves_and_is_read_in_stretches() {
    let (store, _folder) = store().await;
    let id = running(&store).await;
    assert_eq!(read(&store, id, Stretch::ALL).await, []);
    assert_eq!(store.flight_end_us(id).await.unwrap(), None);
    let all = cycles(0, 2_500);
    for (number, part) in all.chunks(50).enumerate() {
        let event = FlightEvent {
            at_us: part[0].at_us,
            code: "part".into(),
            message: number.to_string(),
        };
        let new = NewFlight {
            armed_at: Some(NOW.plus_ms(number as i64)),
            cycles: part,
            events: &[event],
        };
        store.append_flight(id, new).await.unwrap();
    }
    assert_eq!(read(&store, id, Stretch::ALL).await, all);
    assert_eq!(store.flight_cycles(id).await.unwrap(), 2_500);
    assert_eq!(store.flight_end_us(id).await.unwrap(), Some(4_032 * 2_499));
    let stretch = Stretch {
        from_us: 4_032 * 777,
        to_us: 4_032 * 1_234,
    };
    assert_eq!(read(&store, id, stretch).await, all[777..=1_234]);
    let armed_at = store.reproduction(id).await.unwrap().armed_at;
    assert_eq!(armed_at, Some(NOW), "the first one says when");
    let events = store.flight_events(id).await.unwrap();
    let numbers = events.iter().map(|event| event.message.clone());
    assert!(numbers.eq((0..50).map(|number| number.to_string())));
}

#[tokio::test]
async fn a_record_of_the_time_before_chunks_had_times_is_still_read() {
    let (store, _folder) = store().await;
    let id = running(&store).await;
    let old: Vec<Cycle> = cycles(0, 30)
        .into_iter()
        .map(|cycle| Cycle {
            details: None,
            ..cycle
        })
        .collect();
    let mut bytes = Vec::new();
    for cycle in &old {
        bytes.extend(cycle.at_us.to_le_bytes());
        let angles = cycle.commanded_deg.iter().chain(&cycle.measured_deg);
        for value in std::iter::once(&cycle.plan_t_s).chain(angles) {
            bytes.extend(value.to_le_bytes());
        }
    }
    sqlx::query(
        "INSERT INTO reproduction_chunk (reproduction_id, seq, count, records, crc32) \
         VALUES (?, 0, 30, ?, ?)",
    )
    .bind(id.to_string())
    .bind(&bytes)
    .bind(i64::from(crc32fast::hash(&bytes)))
    .execute(&store.writer)
    .await
    .unwrap();
    assert_eq!(read(&store, id, Stretch::ALL).await, old);
    let stretch = Stretch {
        from_us: 4_032 * 10,
        to_us: 4_032 * 12,
    };
    assert_eq!(read(&store, id, stretch).await, old[10..=12]);
}

#[tokio::test]
async fn a_rotten_chunk_is_noticed() {
    let (store, _folder) = store().await;
    let id = running(&store).await;
    let new = NewFlight {
        armed_at: Some(NOW),
        cycles: &cycles(0, 50),
        events: &[],
    };
    store.append_flight(id, new).await.unwrap();
    sqlx::query("UPDATE reproduction_chunk SET crc32 = crc32 + 1")
        .execute(&store.writer)
        .await
        .unwrap();
    let read = store.flight(id, Stretch::ALL).next().await;
    assert!(matches!(read, Err(Error::Damaged { .. })));
}
