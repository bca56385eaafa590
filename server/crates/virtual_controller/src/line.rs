//! The controller's end of the EGM line: what is on its way, in which order, and from which socket.
//!
//! No sockets and no clock of its own: [`crate::egm_client`] and [`crate::simulation`] bring both.
//! Without a fault script, everything goes out at once and comes in in its order.

use std::collections::VecDeque;

use egm::codec;

use crate::clock::WallTime;
use crate::controller::Controller;
use crate::faults::link::{Delivery, LinkFaults};

/// So many datagrams may wait for the controller to take them; more are lost, as they are when a
/// socket's buffer is full.
const MOST_WAITING: usize = 256;

/// A datagram for the server.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parcel {
    /// When it is on the wire, µs.
    pub at_us: u64,
    /// The session it belongs to.
    pub session: u64,
    /// Number of the socket it leaves from: each session has its own, and the fault script can
    /// change it.
    pub socket: u64,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// The line.
#[derive(Clone, Debug)]
pub struct Line {
    faults: LinkFaults,
    /// The session that the present socket belongs to.
    open: Option<u64>,
    socket: u64,
    port_changes: u32,
    outbox: VecDeque<Parcel>,
    inbox: VecDeque<Delivery>,
    message: Vec<u8>,
}

impl Default for Line {
    fn default() -> Self {
        Self {
            faults: LinkFaults::none(),
            open: None,
            socket: 0,
            port_changes: 0,
            outbox: VecDeque::new(),
            inbox: VecDeque::new(),
            message: Vec::new(),
        }
    }
}

impl Line {
    /// First half of a cycle: the controller measures and sends.
    pub fn begin_cycle(&mut self, controller: &mut Controller, now_us: u64, now: WallTime) {
        if let Some(script) = controller.take_fault_script() {
            self.faults = LinkFaults::new(&script);
            self.port_changes = 0;
        }
        for fault in self.faults.controller_faults(now_us) {
            controller.suffer(fault);
        }
        let Some(outgoing) = controller.begin_cycle(now) else {
            self.open = None;
            self.inbox.clear();
            return;
        };
        let session = outgoing.session;
        if self.open != Some(session) {
            self.open = Some(session);
            self.faults.session_began();
            self.open_socket();
        }
        if outgoing.lost || codec::encode_robot(&outgoing.message, &mut self.message).is_err() {
            return;
        }
        for delivery in self.faults.to_server(now_us, &self.message) {
            if delivery.port_changes > self.port_changes {
                self.port_changes = delivery.port_changes;
                self.open_socket();
            }
            let parcel = Parcel {
                at_us: delivery.at_us,
                session,
                socket: self.socket,
                bytes: delivery.bytes,
            };
            let place = self
                .outbox
                .partition_point(|other| other.at_us <= parcel.at_us);
            self.outbox.insert(place, parcel);
        }
    }

    /// Second half of a cycle: the controller takes the oldest datagram that has arrived, and
    /// moves the arm.
    pub fn end_cycle(&mut self, controller: &mut Controller, now_us: u64) {
        controller.end_cycle(self.take(now_us).as_deref());
    }

    /// The oldest datagram that has arrived: one per cycle, in their order.
    pub fn take(&mut self, now_us: u64) -> Option<Vec<u8>> {
        let oldest = self.inbox.pop_front_if(|next| next.at_us <= now_us)?;
        Some(oldest.bytes)
    }

    /// The next datagram for the server whose time has come.
    pub fn departing(&mut self, now_us: u64) -> Option<Parcel> {
        self.outbox.pop_front_if(|next| next.at_us <= now_us)
    }

    /// When the next datagram for the server is on the wire, µs.
    #[must_use]
    pub fn next_departure_us(&self) -> Option<u64> {
        self.outbox.front().map(|next| next.at_us)
    }

    /// Number of the socket that is open.
    #[must_use]
    pub fn socket(&self) -> Option<u64> {
        self.open.map(|_| self.socket)
    }

    /// Takes in a datagram of the server that came to a socket. One that came to a socket that is
    /// closed now is gone.
    pub fn arrived(&mut self, socket: u64, now_us: u64, datagram: &[u8]) {
        if self.socket() != Some(socket) {
            return;
        }
        for delivery in self.faults.to_robot(now_us, datagram) {
            if self.inbox.len() < MOST_WAITING {
                let place = self
                    .inbox
                    .partition_point(|other| other.at_us <= delivery.at_us);
                self.inbox.insert(place, delivery);
            }
        }
    }

    /// How much too late the next cycle is, µs.
    pub fn cycle_delay_us(&mut self, now_us: u64) -> u64 {
        self.faults.cycle_delay_us(now_us)
    }

    fn open_socket(&mut self) {
        self.socket += 1;
        self.inbox.clear();
    }
}
