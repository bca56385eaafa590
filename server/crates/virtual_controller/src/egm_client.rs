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

use egm::MAX_DATAGRAM_BYTES;

use crate::clock::WallTime;
use crate::controller::Controller;
use crate::line::{Line, Parcel};
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
    let epoch = Instant::now();
    let mut line = Line::default();
    let mut sockets = Sockets::new(remote);
    let mut deadline = epoch;
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
        let late = Duration::from_micros(line.cycle_delay_us(since(epoch)));
        let mut refused = send_until(deadline + late, epoch, &mut line, &mut sockets);
        let now_us = since(epoch);
        line.begin_cycle(&mut lock(controller), now_us, WallTime::now());
        refused = refused.or(sockets.send(&mut line, now_us));
        if let Err(again) = sockets.receive(&mut line, now_us) {
            refused = refused.or(Some(again));
        }
        let mut controller = lock(controller);
        if let Some(refused) = refused {
            controller.message_refused(refused.session, refused.bytes);
        }
        line.end_cycle(&mut controller, now_us);
    }
}

/// Waits for the next cycle. What the fault script delayed until then goes out meanwhile.
fn send_until(
    deadline: Instant,
    epoch: Instant,
    line: &mut Line,
    sockets: &mut Sockets,
) -> Option<Refused> {
    let mut refused = None;
    loop {
        let departure = line
            .next_departure_us()
            .map(|at_us| epoch + Duration::from_micros(at_us))
            .filter(|departure| *departure < deadline);
        let until = departure.unwrap_or(deadline);
        thread::sleep(until.saturating_duration_since(Instant::now()));
        if departure.is_none() {
            return refused;
        }
        refused = refused.or(sockets.send(line, since(epoch)));
    }
}

fn since(epoch: Instant) -> u64 {
    u64::try_from(epoch.elapsed().as_micros()).unwrap_or(u64::MAX)
}

/// A message that nobody wanted.
#[derive(Clone, Copy, Debug)]
struct Refused {
    session: u64,
    bytes: usize,
}

/// An open socket.
struct Open {
    number: u64,
    session: u64,
    /// Size of the last message sent from it, bytes.
    bytes: usize,
    socket: UdpSocket,
}

impl Open {
    fn refused(&self) -> Refused {
        Refused {
            session: self.session,
            bytes: self.bytes,
        }
    }
}

/// The socket of the present session, and older ones from which delayed messages still go out.
struct Sockets {
    remote: SocketAddr,
    open: Vec<Open>,
}

impl Sockets {
    fn new(remote: SocketAddr) -> Self {
        Self {
            remote,
            open: Vec::new(),
        }
    }

    /// Sends what is due, each from its own socket, and closes the sockets that are not needed any
    /// more. Returns what was refused.
    fn send(&mut self, line: &mut Line, now_us: u64) -> Option<Refused> {
        let mut refused = None;
        while let Some(parcel) = line.departing(now_us) {
            refused = refused.or(self.send_one(&parcel));
        }
        if line.next_departure_us().is_none() {
            let present = line.socket();
            self.open.retain(|open| present == Some(open.number));
        }
        refused
    }

    fn send_one(&mut self, parcel: &Parcel) -> Option<Refused> {
        let place = self
            .open
            .iter()
            .position(|open| open.number == parcel.socket);
        let place = match place {
            Some(place) => place,
            None => {
                let Ok(socket) = connect(self.remote) else {
                    return Some(Refused {
                        session: parcel.session,
                        bytes: parcel.bytes.len(),
                    });
                };
                self.open.push(Open {
                    number: parcel.socket,
                    session: parcel.session,
                    bytes: 0,
                    socket,
                });
                self.open.len() - 1
            }
        };
        let open = &mut self.open[place];
        open.bytes = parcel.bytes.len();
        match open.socket.send(&parcel.bytes) {
            Err(error) if error.kind() == ErrorKind::ConnectionRefused => Some(open.refused()),
            _ => None,
        }
    }

    /// Hands the line all datagrams that wait, in their order.
    fn receive(&self, line: &mut Line, now_us: u64) -> Result<(), Refused> {
        let mut buffer = [0; MAX_DATAGRAM_BYTES];
        for open in &self.open {
            loop {
                match open.socket.recv(&mut buffer) {
                    Ok(length) => line.arrived(open.number, now_us, &buffer[..length]),
                    Err(error) if error.kind() == ErrorKind::ConnectionRefused => {
                        return Err(open.refused());
                    }
                    Err(_) => break,
                }
            }
        }
        Ok(())
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
        let mut line = Line::default();
        let mut sockets = Sockets::new(remote);
        for cycle in 0..PATIENCE as u64 {
            line.begin_cycle(&mut controller, cycle, WallTime::default());
            if line.next_departure_us().is_some() {
                break;
            }
            line.end_cycle(&mut controller, cycle);
        }
        assert!(sockets.send(&mut line, u64::MAX).is_none());
        let mut buffer = [0; MAX_DATAGRAM_BYTES];
        let (_, client) = server.recv_from(&mut buffer).unwrap();
        for number in 1..=3 {
            server.send_to(&[number], client).unwrap();
        }
        for number in 1..=3 {
            let datagram = (0..PATIENCE).find_map(|_| {
                sockets.receive(&mut line, 0).unwrap();
                line.take(0)
            });
            assert_eq!(datagram, Some(vec![number]));
        }
        assert_eq!(line.take(0), None);
    }
}
