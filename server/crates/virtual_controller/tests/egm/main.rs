//! EGM on its socket: a server that answers, one that does not, and one that is not there.

use std::net::{Ipv4Addr, UdpSocket};

use egm::SequenceNumber;
use egm::messages::MciState;
use motion::JointAngles;
use virtual_controller::{Direction, Fault, FaultScript, ScriptedFault};

#[cfg(test)]
mod cell;

use cell::{Cell, Server};

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_arm_follows_a_server_that_answers_every_message() {
    let mut server = Server::bind();
    let cell = Cell::start(server.socket.local_addr().unwrap()).await;
    cell.run_program().await;
    let guided = tokio::task::spawn_blocking(move || {
        let (first, from) = server.receive();
        assert_eq!(first.sequence, Some(SequenceNumber(0)));
        let start = first.feedback.unwrap();
        server.answer(&first, start, from);
        let goal = JointAngles(start.0.map(|angle| angle + 2.0));
        let mut expected = SequenceNumber(1);
        loop {
            let (feedback, from) = server.receive();
            assert_eq!(feedback.sequence, Some(expected));
            expected = expected.next();
            server.answer(&feedback, goal, from);
            if feedback.feedback.unwrap().max_abs_difference(&goal) < 0.05 {
                return (server, feedback);
            }
            assert!(expected.0 < 5000, "the arm does not arrive");
        }
    });
    let (mut server, feedback) = guided.await.unwrap();
    assert_eq!(feedback.mci_state, Some(MciState::Running));

    cell.act("/rw/rapid/execution/stop", "stopmode=stop").await;
    let ended = tokio::task::spawn_blocking(move || {
        loop {
            let (feedback, from) = server.receive();
            server.answer(&feedback, feedback.feedback.unwrap(), from);
            if feedback.mci_state == Some(MciState::Stopped) {
                return server;
            }
        }
    });
    let server = ended.await.unwrap();

    // The next run is another session: it counts from 0 again.
    cell.act("/rw/rapid/execution/start", "cycle=once").await;
    let again = tokio::task::spawn_blocking(move || {
        loop {
            let (feedback, _) = server.receive();
            if feedback.mci_state == Some(MciState::Running) {
                return feedback;
            }
        }
    });
    assert_eq!(again.await.unwrap().sequence, Some(SequenceNumber(0)));
    cell.controller.stop().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_server_that_never_answers_is_an_error() {
    let server = Server::bind();
    let cell = Cell::start(server.socket.local_addr().unwrap()).await;
    cell.run_program().await;
    cell.wait_for_event(41_822).await;
    cell.controller.stop().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_port_where_nobody_listens_is_another_error() {
    let closed = {
        let socket = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        socket.local_addr().unwrap()
    };
    let cell = Cell::start(closed).await;
    cell.run_program().await;
    cell.wait_for_event(41_830).await;
    cell.controller.stop().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn lost_messages_leave_the_server_without_feedback_and_the_arm_without_references() {
    let server = Server::bind();
    let cell = Cell::start(server.socket.local_addr().unwrap()).await;
    cell.controller
        .faults()
        .set(|faults| faults.egm_lost = true);
    cell.run_program().await;
    cell.wait_for_event(41_822).await;
    server.socket.set_nonblocking(true).unwrap();
    let mut buffer = [0; 1];
    let nothing = server.socket.recv_from(&mut buffer).unwrap_err();
    assert_eq!(nothing.kind(), std::io::ErrorKind::WouldBlock);
    cell.controller.stop().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_script_delays_and_doubles_messages_on_their_way_and_the_arm_is_guided_all_the_same() {
    let mut server = Server::bind();
    let cell = Cell::start(server.socket.local_addr().unwrap()).await;
    let delay = Fault::Delay {
        delay_s: 0.002,
        spread_s: 0.005,
    };
    let twice = Fault::Duplicate {
        copies: 1,
        apart_s: 0.0,
    };
    let script = FaultScript {
        seed: 1,
        faults: vec![
            delay.into(),
            ScriptedFault {
                direction: Direction::ToServer,
                ..twice.into()
            },
        ],
    };
    cell.controller.faults().play(script).unwrap();
    cell.run_program().await;
    let arrived = tokio::task::spawn_blocking(move || {
        for expected in 0..200 {
            for copy in 0..2 {
                let (feedback, from) = server.receive();
                assert_eq!(feedback.sequence, Some(SequenceNumber(expected)), "{copy}");
                if copy == 0 {
                    server.answer(&feedback, feedback.feedback.unwrap(), from);
                }
                assert_eq!(feedback.mci_state, Some(MciState::Running));
            }
        }
    });
    arrived.await.unwrap();
    cell.controller.stop().await;
}
