//! Receives EGM messages, answers each with "stand still", and keeps account.

use std::net::SocketAddr;
use std::time::Duration;

use egm::header::ControllerTime;
use egm::session::{Session, SessionConfig};
use egm::{RobotFeedback, encode_correction, read_feedback};
use motion::JointAngles;
use tokio::net::UdpSocket;
use tokio::time::{Instant, timeout};

use crate::clock::{Clock, SystemClock};

/// How long to listen once messages come: longer than the controller waits for answers.
const LISTEN: Duration = Duration::from_secs(3);
/// A silence that ends the listening.
const SILENCE: Duration = Duration::from_millis(500);
/// No setpoint is ever sent, so only the time-outs matter.
const SESSION: SessionConfig = SessionConfig {
    timeout_us: 500_000,
    late_after_us: 10_000,
    max_lost: 120,
    max_advance_us: 16_000,
    brake_us: 0,
    max_speed_deg_s: [0.0; 6],
};

/// What was heard.
#[derive(Debug, Default)]
pub struct Heard {
    pub messages: u64,
    pub lost: u64,
    /// The controller reported an error of its motion interface.
    pub in_error: bool,
    /// Farthest that a joint went from where it stood when answers began to be applied, deg.
    pub moved_deg: f64,
    source: Option<SocketAddr>,
    arrivals: Option<(Instant, Instant)>,
    worst_gap: Duration,
    applied: Option<(Instant, Instant)>,
    held: Option<JointAngles>,
    newest: Option<RobotFeedback>,
    clock_ahead_ms: Option<f64>,
}

/// Waits for the first message, then listens for a while.
pub async fn listen(socket: &UdpSocket, wait: Duration) -> Heard {
    let mut heard = Heard::default();
    let mut session = Session::new(SESSION);
    let began = Instant::now();
    let mut datagram = [0; egm::MAX_DATAGRAM_BYTES];
    loop {
        let patience = match heard.arrivals {
            None => wait.saturating_sub(began.elapsed()),
            Some((first, _)) => SILENCE.min(LISTEN.saturating_sub(first.elapsed())),
        };
        let (length, source) = match timeout(patience, socket.recv_from(&mut datagram)).await {
            Ok(Ok(received)) => received,
            // The closed port of an earlier receiver of our answers shows here; it is read once.
            Ok(Err(_)) => continue,
            Err(_) => break,
        };
        let Ok(feedback) = read_feedback(&datagram[..length]) else {
            continue;
        };
        let arrived = Instant::now();
        let arrival_us = arrived.duration_since(began).as_micros() as u64;
        if let Some(received) = session.receive(&feedback, arrival_us, source) {
            heard.note(&feedback, arrived, source);
            heard.in_error |= received.mci_error;
            if received.may_be_commanded {
                heard.note_applied(arrived, received.measured);
            }
        }
        answer(socket, &mut session, arrival_us, source).await;
    }
    heard.lost = session.counters().lost;
    heard
}

async fn answer(socket: &UdpSocket, session: &mut Session, now_us: u64, source: SocketAddr) {
    // The controller's time stamp is 32 bits wide as well, and wraps.
    let now_ms = ControllerTime((now_us / 1000) as u32);
    let Some(answer) = session.answer(None, now_ms) else {
        return;
    };
    let mut reply = [0; egm::MAX_CORRECTION_BYTES];
    if let Ok(length) = encode_correction(&answer.correction, &mut reply) {
        // An answer that cannot be sent is lost like any other; the controller asks again.
        socket.send_to(&reply[..length], source).await.ok();
    }
}

impl Heard {
    fn note(&mut self, feedback: &RobotFeedback, arrived: Instant, source: SocketAddr) {
        self.messages += 1;
        self.source = Some(source);
        self.newest = Some(*feedback);
        if let Some(time) = feedback.feedback_time {
            let theirs_ms = time.seconds as f64 * 1000.0 + time.microseconds as f64 / 1000.0;
            self.clock_ahead_ms = Some(theirs_ms - SystemClock.now().0 as f64);
        }
        self.arrivals = match self.arrivals {
            None => Some((arrived, arrived)),
            Some((first, last)) => {
                self.worst_gap = self.worst_gap.max(arrived.duration_since(last));
                Some((first, arrived))
            }
        };
    }

    fn note_applied(&mut self, arrived: Instant, measured: JointAngles) {
        let since = self.applied.map_or(arrived, |(since, _)| since);
        self.applied = Some((since, arrived));
        let held = *self.held.get_or_insert(measured);
        let moved = held
            .0
            .iter()
            .zip(measured.0)
            .map(|(from, to)| (to - from).abs());
        self.moved_deg = moved.fold(self.moved_deg, f64::max);
    }

    /// Whether the controller applied answers at any time.
    pub fn was_applied(&self) -> bool {
        self.applied.is_some()
    }

    /// For how long it did.
    pub fn applied_s(&self) -> f64 {
        self.applied.map_or(0.0, |(since, last)| {
            last.duration_since(since).as_secs_f64()
        })
    }

    /// Whose messages these are; nothing when they are of no generation that TEAM can guide.
    pub fn generation(&self) -> Option<&'static str> {
        let newest = self.newest.as_ref()?;
        newest.feedback?;
        newest.feedback_time?;
        if newest.move_index.is_some() || newest.collision_triggered.is_some() {
            Some("RobotWare 7")
        } else {
            Some("RobotWare 6")
        }
    }

    /// Everything in one line.
    pub fn words(&self) -> String {
        let span_s = self.arrivals.map_or(0.0, |(first, last)| {
            last.duration_since(first).as_secs_f64()
        });
        let mean_ms = span_s * 1000.0 / self.messages.saturating_sub(1).max(1) as f64;
        let source = self
            .source
            .map_or_else(String::new, |source| source.to_string());
        let clock = self.clock_ahead_ms.map_or_else(String::new, |ahead_ms| {
            format!(", its clock {ahead_ms:+.0} ms from ours")
        });
        format!(
            "{} from {source} in {span_s:.1} s ({}), one each {mean_ms:.2} ms, longest gap {:.1} ms, {} lost{clock}",
            self.messages,
            self.generation().unwrap_or("of no known generation"),
            self.worst_gap.as_secs_f64() * 1000.0,
            self.lost,
        )
    }
}
