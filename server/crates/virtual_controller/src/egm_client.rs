//! The controller's side of the EGM socket: a thread of its own that keeps the cycle.
//!
//! Each cycle it sends one message and takes at most one of the datagrams that wait, in order.
//! Deadlines are absolute, so that lateness does not add up. When the machine was busy, the cycles
//! that could not be sent in time are made up for in motion but not in messages: the arm of a real
//! cell does not wait either.

use std::io::ErrorKind;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, UdpSocket};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use egm::{MAX_DATAGRAM_BYTES, codec};

use crate::clock::WallTime;
use crate::controller::{Controller, Outgoing};
use crate::lock;

/// After so much lateness the lost time is dropped: the machine was asleep.
const LONGEST_LATENESS: Duration = Duration::from_secs(1);

/// The running thread.
pub struct EgmClient {
    stop: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl EgmClient {
    /// Starts the cycle of `controller`.
    ///
    /// # Errors
    /// When the system cannot start a thread.
    pub fn start(controller: Arc<Mutex<Controller>>) -> std::io::Result<Self> {
        let stop = Arc::new(AtomicBool::new(false));
        let thread = thread::Builder::new()
            .name("virtual-gofa".to_owned())
            .spawn({
                let stop = Arc::clone(&stop);
                move || {
                    // A real controller keeps its cycle whatever the computer does. Without
                    // the right to a higher priority it runs like everything else.
                    let _ = rustix::process::setpriority_process(None, -20);
                    run(&controller, &stop);
                }
            })?;
        Ok(Self {
            stop,
            thread: Some(thread),
        })
    }

    /// Ends the cycle and waits for its last one.
    pub fn stop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            thread.join().ok();
        }
    }
}

impl Drop for EgmClient {
    fn drop(&mut self) {
        self.stop();
    }
}

fn run(controller: &Mutex<Controller>, stop: &AtomicBool) {
    let (period, remote) = {
        let controller = lock(controller);
        let config = controller.config();
        (
            Duration::from_secs_f64(config.egm.cycle_s),
            config.egm_remote,
        )
    };
    let mut link = Link::new(remote);
    let mut deadline = Instant::now();
    while !stop.load(Ordering::Relaxed) {
        deadline += period;
        let now = Instant::now();
        if now.saturating_duration_since(deadline) > LONGEST_LATENESS {
            deadline = now;
        }
        while now.saturating_duration_since(deadline) > period {
            lock(controller).end_cycle(None);
            deadline += period;
        }
        thread::sleep(deadline.saturating_duration_since(now));
        let outgoing = lock(controller).begin_cycle(WallTime::now());
        let refused = link.send(outgoing);
        let mut buffer = [0; MAX_DATAGRAM_BYTES];
        let received = link.receive(&mut buffer);
        let mut controller = lock(controller);
        match (refused, received) {
            (Some(refused), _) | (None, Err(refused)) => {
                controller.message_refused(refused.session, refused.bytes);
                controller.end_cycle(None);
            }
            (None, Ok(length)) => controller.end_cycle(length.map(|length| &buffer[..length])),
        }
    }
}

/// A message that nobody wanted.
#[derive(Clone, Copy)]
struct Refused {
    session: u64,
    bytes: usize,
}

/// The socket of the present session.
struct Link {
    remote: SocketAddr,
    open: Option<(u64, UdpSocket)>,
    message: Vec<u8>,
}

impl Link {
    fn new(remote: SocketAddr) -> Self {
        Self {
            remote,
            open: None,
            message: Vec::new(),
        }
    }

    /// Sends a message, on a new socket when it begins a session; closes the socket when there is
    /// none to send. Returns what was refused.
    fn send(&mut self, outgoing: Option<Outgoing>) -> Option<Refused> {
        let Some(outgoing) = outgoing else {
            self.open = None;
            return None;
        };
        let session = outgoing.session;
        if codec::encode_robot(&outgoing.message, &mut self.message).is_err() {
            return None;
        }
        let refused = Refused {
            session,
            bytes: self.message.len(),
        };
        if self.open.as_ref().is_none_or(|(open, _)| *open != session) {
            match connect(self.remote) {
                Ok(socket) => self.open = Some((session, socket)),
                Err(_) => return Some(refused),
            }
        }
        let (_, socket) = self.open.as_ref()?;
        if outgoing.lost {
            return None;
        }
        match socket.send(&self.message) {
            Err(error) if error.kind() == ErrorKind::ConnectionRefused => Some(refused),
            _ => None,
        }
    }

    /// Takes the oldest datagram that waits, if one does.
    fn receive(&self, buffer: &mut [u8]) -> Result<Option<usize>, Refused> {
        let Some((session, socket)) = &self.open else {
            return Ok(None);
        };
        match socket.recv(buffer) {
            Ok(length) => Ok(Some(length)),
            Err(error) if error.kind() == ErrorKind::ConnectionRefused => Err(Refused {
                session: *session,
                bytes: self.message.len(),
            }),
            Err(_) => Ok(None),
        }
    }
}

/// A socket whose peer is the server: datagrams of others are not received.
fn connect(remote: SocketAddr) -> std::io::Result<UdpSocket> {
    let any: IpAddr = if remote.is_ipv4() {
        Ipv4Addr::UNSPECIFIED.into()
    } else {
        Ipv6Addr::UNSPECIFIED.into()
    };
    let socket = UdpSocket::bind((any, 0))?;
    socket.connect(remote)?;
    socket.set_nonblocking(true)?;
    Ok(socket)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;

    /// More tries than a datagram on this machine takes to arrive.
    const PATIENCE: usize = 10_000_000;

    #[test]
    fn datagrams_are_taken_one_by_one_in_their_order() {
        let server = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let remote = server.local_addr().unwrap();
        let mut controller = Controller::new(Config::new(remote));
        controller.set_motors(true).unwrap();
        controller.start_program(None).unwrap();
        let outgoing = (0..PATIENCE)
            .find_map(|_| {
                let outgoing = controller.begin_cycle(WallTime::default());
                controller.end_cycle(None);
                outgoing
            })
            .unwrap();
        let mut link = Link::new(remote);
        assert!(link.send(Some(outgoing)).is_none());
        let mut buffer = [0; MAX_DATAGRAM_BYTES];
        let (_, client) = server.recv_from(&mut buffer).unwrap();
        for number in 1..=3 {
            server.send_to(&[number], client).unwrap();
        }
        for number in 1..=3 {
            let length = (0..PATIENCE)
                .find_map(|_| link.receive(&mut buffer).ok().flatten())
                .unwrap();
            assert_eq!(buffer[..length], [number]);
        }
        assert!(matches!(link.receive(&mut buffer), Ok(None)));
    }
}
