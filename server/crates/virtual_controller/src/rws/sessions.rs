//! The sessions of the clients, and who of them holds mastership.

use std::collections::HashMap;
use std::hash::{BuildHasher, RandomState};
use std::time::{Duration, Instant};

/// A controller has so many sessions, and no more.
const MOST_SESSIONS: usize = 70;
/// A session that nobody uses for so long is over.
const IDLE: Duration = Duration::from_secs(300);

/// Who a request belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SessionId(pub String);

/// All sessions.
#[derive(Default)]
pub struct Sessions {
    last_used: HashMap<String, Instant>,
    master: Option<String>,
}

impl Sessions {
    /// True when the session exists; it counts as used then.
    pub fn resume(&mut self, id: &str) -> bool {
        self.forget_idle();
        match self.last_used.get_mut(id) {
            Some(used) => {
                *used = Instant::now();
                true
            }
            None => false,
        }
    }

    /// Opens a session; nothing when there are too many.
    pub fn open(&mut self) -> Option<SessionId> {
        self.forget_idle();
        if self.last_used.len() >= MOST_SESSIONS {
            return None;
        }
        let random = RandomState::new();
        let id = format!("{:016x}{:016x}", random.hash_one(1), random.hash_one(2));
        self.last_used.insert(id.clone(), Instant::now());
        Some(SessionId(id))
    }

    /// Ends a session and frees its mastership.
    pub fn close(&mut self, id: &SessionId) {
        self.last_used.remove(&id.0);
        self.release(id);
    }

    /// Gives mastership to a session; false when another one holds it.
    pub fn take_mastership(&mut self, id: &SessionId) -> bool {
        self.forget_idle();
        if self.master.as_ref().is_some_and(|master| *master != id.0) {
            return false;
        }
        self.master = Some(id.0.clone());
        true
    }

    /// Frees mastership; false when the session does not hold it.
    pub fn release(&mut self, id: &SessionId) -> bool {
        let held = self.is_master(id);
        if held {
            self.master = None;
        }
        held
    }

    /// Anyone holds mastership.
    pub fn has_master(&self) -> bool {
        self.master.is_some()
    }

    /// This session holds mastership.
    pub fn is_master(&self, id: &SessionId) -> bool {
        self.master.as_ref() == Some(&id.0)
    }

    fn forget_idle(&mut self) {
        self.last_used.retain(|_, used| used.elapsed() < IDLE);
        let last_used = &self.last_used;
        self.master = self
            .master
            .take()
            .filter(|master| last_used.contains_key(master));
    }
}
