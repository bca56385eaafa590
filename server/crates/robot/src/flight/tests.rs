//! The writer of the flight record on its own.

use super::*;
use motion::{JointAngles, JointVelocities};

fn cycle(index: u64, phase: RunPhase) -> CycleRecord {
    CycleRecord {
        at_us: 4_000 * index,
        commanded: JointAngles([index as f64; 6]),
        commanded_speed: JointVelocities::ZERO,
        measured: JointAngles([index as f64 - 0.5; 6]),
        plan_t_s: 0.004 * index as f64,
        phase,
        lost: 0,
        late: false,
        motors_on: true,
        rapid_running: true,
        utilization_percent: None,
        held: false,
        limited: false,
    }
}

fn codes(chunk: &FlightChunk) -> Vec<&'static str> {
    chunk.events.iter().map(|event| event.code).collect()
}

#[test]
fn nothing_is_lost_when_nobody_keeps_the_chunks_for_a_while() {
    let (mut writer, mut flight) = FlightWriter::new();
    let (mut ring, mut records) = rtrb::RingBuffer::new(4096);
    writer.armed(Instant::now());
    // Far more chunks than the channel holds.
    let all = 50 * (CHUNKS as u64 + 100);
    for index in 0..all {
        ring.push(cycle(index, RunPhase::Motion)).unwrap();
        if index % 50 == 49 {
            writer.due = Instant::now();
            writer.take(&mut records);
        }
    }
    let rest = writer.finish(&RunEnd::Completed, &mut records);
    let mut kept = Vec::new();
    while let Ok(chunk) = flight.try_recv() {
        kept.extend(chunk.cycles);
    }
    kept.extend(rest.cycles.iter().copied());
    assert!(
        kept.iter()
            .map(|one| one.at_us)
            .eq((0..all).map(|i| 4_000 * i))
    );
    assert_eq!(codes(&rest), ["completed"]);
}

#[test]
fn memory_stays_bounded_and_the_record_says_what_it_lacks() {
    let (mut writer, _flight) = FlightWriter::new();
    let (mut ring, mut records) = rtrb::RingBuffer::new(4096);
    writer.armed(Instant::now());
    // The keeper is gone for good: the channel fills, then the writer does.
    for index in 0..MOST_WAITING as u64 + 70 {
        ring.push(cycle(index, RunPhase::Motion)).unwrap();
        writer.due = Instant::now() + Duration::from_secs(3600);
        writer.take(&mut records);
    }
    let rest = writer.finish(&RunEnd::Stopped, &mut records);
    assert_eq!(rest.cycles.len(), MOST_WAITING);
    assert_eq!(
        codes(&rest),
        ["armed", "motion", "record_incomplete", "stopped"]
    );
    assert!(rest.events[2].message.contains("70"));
}

#[test]
fn what_happens_is_noted_once_and_a_fault_at_the_last_cycle() {
    let (mut writer, _flight) = FlightWriter::new();
    let (mut ring, mut records) = rtrb::RingBuffer::new(16);
    ring.push(cycle(0, RunPhase::Approach)).unwrap();
    writer.take(&mut records);
    assert!(writer.cycles.is_empty(), "its place in time is not known");
    writer.armed(Instant::now());
    for index in 1..4 {
        ring.push(cycle(index, RunPhase::Motion)).unwrap();
        writer.take(&mut records);
        writer.see_stop();
        writer.see_controller(Some(&ControllerState::GuardStop));
        writer.see_controller(None);
    }
    let fault = crate::ending::lost();
    let rest = writer.finish(&RunEnd::Failed(fault), &mut records);
    assert_eq!(
        codes(&rest),
        [
            "armed",
            "approach",
            "motion",
            "stop_requested",
            "controller_state",
            "egm_lost",
            "failed"
        ]
    );
    assert_eq!(rest.events[5].at_us, 12_000);
}
