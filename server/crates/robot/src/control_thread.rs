//! The thread "egm": receives each message of the controller and answers it.
//!
//! It is a plain thread with a plain socket, so that neither the async runtime nor a training job
//! can keep an answer waiting. What is computed lives in [`crate::control_loop`].

use crate::control_loop::ControlLoop;
use crate::links::Flags;
use std::io::ErrorKind;
use std::net::{SocketAddr, UdpSocket};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use thread_priority::{
    RealtimeThreadSchedulePolicy, ThreadPriority, ThreadPriorityValue, ThreadSchedulePolicy,
    set_thread_priority_and_policy, thread_native_id,
};

/// Longest wait for a message before looking after other things.
const RECEIVE_TIMEOUT: Duration = Duration::from_millis(20);
/// From this distance on, more messages may be waiting behind the one that was received, µs.
const STALLED_US: u64 = 6_000;
/// Above everything that computes, below what the system itself needs (1 to 99).
const FIFO_PRIORITY: u8 = 60;
/// Highest priority that is not real-time; needs the right to raise it, too.
const NICENESS: i32 = -20;

/// Binds the port of the control thread.
pub(crate) fn bind(address: SocketAddr) -> std::io::Result<UdpSocket> {
    let socket = UdpSocket::bind(address)?;
    socket.set_read_timeout(Some(RECEIVE_TIMEOUT))?;
    Ok(socket)
}

/// Asks for real-time priority for the calling thread. Without the right to it the loop runs at
/// the highest ordinary one that it gets; the view says so.
fn raise_priority(real_time: bool) -> bool {
    let fifo = real_time
        && ThreadPriorityValue::try_from(FIFO_PRIORITY).is_ok_and(|priority| {
            set_thread_priority_and_policy(
                thread_native_id(),
                ThreadPriority::Crossplatform(priority),
                ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo),
            )
            .is_ok()
        });
    if !fifo {
        // Either way the arm is served; a raised priority only makes late answers rarer.
        let raised = rustix::process::setpriority_process(None, NICENESS).is_ok();
        if real_time {
            tracing::warn!(
                raised,
                "the system gives the control loop no real-time priority; answers may be late when it is busy"
            );
        }
    }
    fifo
}

/// Starts the thread. It ends when [`Flags::quit`] is called.
pub(crate) fn spawn(
    socket: UdpSocket,
    control: ControlLoop,
    flags: Arc<Flags>,
    epoch: Instant,
    real_time: bool,
) -> std::io::Result<JoinHandle<()>> {
    std::thread::Builder::new()
        .name("egm".to_owned())
        .spawn(move || {
            flags.set_real_time(raise_priority(real_time));
            let mut thread = ControlThread {
                socket,
                control,
                epoch,
                last_arrival_us: 0,
            };
            while !flags.quits() {
                // A bug must not leave the arm without answers: hold, and go on.
                if catch_unwind(AssertUnwindSafe(|| thread.cycle())).is_err() {
                    thread.control.recover();
                }
                thread.control.publish();
            }
        })
}

struct ControlThread {
    socket: UdpSocket,
    control: ControlLoop,
    epoch: Instant,
    last_arrival_us: u64,
}

impl ControlThread {
    /// Waits for one message and answers it to where it came from.
    fn cycle(&mut self) {
        let mut datagram = [0; egm::MAX_DATAGRAM_BYTES];
        let (length, source) = match self.socket.recv_from(&mut datagram) {
            Ok(received) => received,
            Err(error) => return self.nothing_received(error.kind()),
        };
        let now_us = self.now_us();
        let stalled = now_us.saturating_sub(self.last_arrival_us) > STALLED_US;
        self.last_arrival_us = now_us;
        let mut answer_to = self
            .control
            .receive(&datagram[..length], now_us, source)
            .then_some(source);
        if stalled {
            self.catch_up(&mut datagram, &mut answer_to);
        }
        if let Some(source) = answer_to {
            self.answer(source);
        }
    }

    /// Takes in what piled up while we were not scheduled. The controller applies one answer per
    /// cycle: answering all of them would keep it behind by as many cycles for the rest of the
    /// session, so only the newest message of a sender is answered.
    fn catch_up(&mut self, datagram: &mut [u8], answer_to: &mut Option<SocketAddr>) {
        if self.socket.set_nonblocking(true).is_err() {
            return;
        }
        while let Ok((length, source)) = self.socket.recv_from(datagram) {
            if let Some(other) = answer_to.filter(|other| *other != source) {
                self.answer(other);
                *answer_to = None;
            }
            if self
                .control
                .receive(&datagram[..length], self.now_us(), source)
            {
                *answer_to = Some(source);
            }
        }
        // Not to block again would make this loop spin, which the next receive shows as an
        // error that is waited for below.
        let _ = self.socket.set_nonblocking(false);
    }

    fn answer(&mut self, source: SocketAddr) {
        let mut reply = [0; egm::MAX_CORRECTION_BYTES];
        if let Some(length) = self.control.answer(&mut reply) {
            // A reply that cannot be sent is lost like any other; the controller repeats.
            let _ = self.socket.send_to(&reply[..length], source);
        }
    }

    fn nothing_received(&mut self, kind: ErrorKind) {
        if !matches!(kind, ErrorKind::WouldBlock | ErrorKind::TimedOut) {
            // A broken network answers at once: do not spin.
            std::thread::sleep(Duration::from_millis(1));
        }
        self.control.silence(self.now_us());
    }

    fn now_us(&self) -> u64 {
        self.epoch.elapsed().as_micros() as u64
    }
}
