//! What arrives of what was sent.

use egm::messages::{EgmFeedBack, EgmHeader, EgmJoints, EgmRobot};
use egm::{Error, codec, read_feedback};

use super::*;

const CYCLE_US: u64 = 4_000;

fn message(number: u32) -> Vec<u8> {
    let message = EgmRobot {
        header: Some(EgmHeader {
            seqno: Some(number),
            tm: Some(number * 4),
            mtype: Some(2),
        }),
        feed_back: Some(EgmFeedBack {
            joints: Some(EgmJoints {
                joints: vec![f64::from(number); 6],
            }),
            ..EgmFeedBack::default()
        }),
        ..EgmRobot::default()
    };
    let mut datagram = Vec::new();
    codec::encode_robot(&message, &mut datagram).unwrap();
    datagram
}

fn line(faults: &[Fault], share: f64) -> LinkFaults {
    LinkFaults::new(&FaultScript {
        seed: 5,
        faults: faults
            .iter()
            .map(|fault| ScriptedFault {
                share,
                ..(*fault).into()
            })
            .collect(),
    })
}

/// Sends messages 0 to `count` and returns the numbers in the order of arrival, with the times.
fn arrivals(line: &mut LinkFaults, count: u32) -> Vec<(u32, u64)> {
    let mut all: Vec<Delivery> = (0..count)
        .flat_map(|number| line.to_server(u64::from(number) * CYCLE_US, &message(number)))
        .collect();
    all.sort_by_key(|delivery| delivery.at_us);
    all.iter()
        .map(|delivery| {
            let feedback = read_feedback(&delivery.bytes).unwrap();
            (feedback.sequence.unwrap().0, delivery.at_us)
        })
        .collect()
}

fn order(line: &mut LinkFaults, count: u32) -> Vec<u32> {
    arrivals(line, count)
        .iter()
        .map(|arrival| arrival.0)
        .collect()
}

#[test]
fn without_faults_everything_arrives_at_once_as_it_was() {
    let mut line = LinkFaults::none();
    for number in 0..10 {
        for deliveries in [
            line.to_server(9, &message(number)),
            line.to_robot(9, &message(number)),
        ] {
            let expected = Delivery {
                at_us: 9,
                port_changes: 0,
                bytes: message(number),
            };
            assert_eq!(deliveries, [expected]);
        }
    }
}

#[test]
fn about_the_share_given_is_lost() {
    let arrived = order(&mut line(&[Fault::Loss], 0.25), 10_000).len() as f64;
    // Four standard deviations of 10000 draws.
    assert!((arrived - 7_500.0).abs() < 4.0 * 43.3, "{arrived}");
}

#[test]
fn a_direction_leaves_the_other_one_alone() {
    let mut line = LinkFaults::new(&FaultScript {
        seed: 0,
        faults: vec![ScriptedFault {
            direction: Direction::ToServer,
            ..Fault::Loss.into()
        }],
    });
    assert!(line.to_server(0, &message(0)).is_empty());
    assert_eq!(line.to_robot(0, &message(0)).len(), 1);
}

#[test]
fn delayed_messages_keep_their_order() {
    let delay = Fault::Delay {
        delay_s: 0.01,
        spread_s: 0.03,
    };
    let arrivals = arrivals(&mut line(&[delay], 1.0), 500);
    for (place, (number, at_us)) in arrivals.iter().enumerate() {
        assert_eq!(*number as usize, place);
        let late_us = at_us - u64::from(*number) * CYCLE_US;
        assert!((10_000..=40_000).contains(&late_us), "{late_us}");
    }
}

#[test]
fn copies_arrive_after_the_original() {
    let twice = Fault::Duplicate {
        copies: 2,
        apart_s: 0.001,
    };
    let arrivals = arrivals(&mut line(&[twice], 1.0), 2);
    let expected = [
        (0, 0),
        (0, 1000),
        (0, 2000),
        (1, 4000),
        (1, 5000),
        (1, 6000),
    ];
    assert_eq!(arrivals, expected);
}

#[test]
fn a_held_message_arrives_behind_the_others() {
    let mut line = LinkFaults::new(&FaultScript {
        seed: 0,
        faults: vec![ScriptedFault {
            from_s: 0.004,
            for_s: Some(0.004),
            ..Fault::Reorder { behind: 2 }.into()
        }],
    });
    assert_eq!(order(&mut line, 5), [0, 2, 3, 1, 4]);
}

#[test]
fn a_repeated_message_is_the_old_one_and_a_repeated_number_has_a_new_pose() {
    assert_eq!(order(&mut line(&[Fault::Repeat], 1.0), 4), [0, 0, 1, 2]);
    let mut line = line(&[Fault::SameNumber], 1.0);
    for number in 0..4 {
        let delivery = line.to_server(0, &message(number)).remove(0);
        let feedback = read_feedback(&delivery.bytes).unwrap();
        assert_eq!(feedback.sequence.unwrap().0, 0);
        assert_eq!(feedback.feedback.unwrap().0, [f64::from(number); 6]);
    }
}

#[test]
fn angles_become_absurd_or_no_numbers() {
    let absurd = Fault::Angle {
        joint: 2,
        angle_deg: 1e300,
    };
    let delivery = line(&[absurd], 1.0).to_server(0, &message(1)).remove(0);
    let angles = read_feedback(&delivery.bytes).unwrap().feedback.unwrap();
    assert_eq!(angles.0, [1.0, 1e300, 1.0, 1.0, 1.0, 1.0]);
    // A new count does not hide it.
    let faults = [Fault::NotANumber { joint: 6 }, Fault::CounterReset];
    let delivery = line(&faults, 1.0).to_server(0, &message(4)).remove(0);
    let read = read_feedback(&delivery.bytes);
    assert!(matches!(read, Err(Error::NotFinite { .. })));
    assert_eq!(
        rewrite::number(&delivery.bytes, Direction::ToServer),
        Some(0)
    );
}

#[test]
fn garbage_and_cut_messages_have_sizes_of_all_kinds() {
    for fault in [Fault::Garbage, Fault::Cut] {
        let mut line = line(&[fault], 1.0);
        let sizes: std::collections::HashSet<usize> = (0..500)
            .flat_map(|number| line.to_server(0, &message(number)))
            .map(|delivery| delivery.bytes.len())
            .collect();
        assert!(sizes.len() > 30, "{fault:?}: {} sizes", sizes.len());
    }
}

#[test]
fn a_count_begins_anew_from_another_port_until_a_session_counts_by_itself() {
    let mut line = LinkFaults::new(&FaultScript {
        seed: 0,
        faults: vec![ScriptedFault {
            from_s: 0.008,
            ..Fault::CounterReset.into()
        }],
    });
    let mut seen = Vec::new();
    for number in 0..5 {
        let delivery = line
            .to_server(u64::from(number) * CYCLE_US, &message(number))
            .remove(0);
        let sequence = read_feedback(&delivery.bytes).unwrap().sequence.unwrap();
        seen.push((sequence.0, delivery.port_changes));
    }
    assert_eq!(seen, [(0, 0), (1, 0), (0, 1), (1, 1), (2, 1)]);
    line.session_began();
    let delivery = line.to_server(20_000, &message(0)).remove(0);
    let feedback = read_feedback(&delivery.bytes).unwrap();
    assert_eq!(feedback.sequence.unwrap().0, 0);
}
