//! Whether the client of a live socket holds the button of a motion.

use std::time::{Duration, Instant};

use crate::arms::Arm;
use crate::control::Phone;
use crate::ids::ReproductionId;

/// After so much silence a press is over. What a network kept back for longer must not make an arm
/// move that has come to rest and that somebody may have walked up to.
const LAPSES: Duration = Duration::from_millis(400);

/// The presses of one socket. Letting go of the socket lets go of the arm.
pub struct Holds<'a> {
    arm: &'a Arm,
    presses: Presses,
}

impl<'a> Holds<'a> {
    /// Nothing is held yet.
    pub fn of(arm: &'a Arm) -> Self {
        Self {
            arm,
            presses: Presses::default(),
        }
    }

    /// The client says that it holds the button.
    pub fn hold(&mut self, phone: Option<&Phone>, motion: ReproductionId, press: u64) {
        let may = self.presses.goes_on(press, Instant::now()) && self.arm.claim(phone).is_ok();
        if !(may && self.arm.reproducer.hold(motion).is_ok()) {
            self.let_go();
        }
    }

    /// The client holds it no more.
    pub fn let_go(&mut self) {
        if self.presses.end() {
            self.arm.robot.let_go();
        }
    }
}

impl Drop for Holds<'_> {
    fn drop(&mut self) {
        self.let_go();
    }
}

/// Which press is held, if any, and which are over.
#[derive(Default)]
struct Presses {
    /// The newest press that was heard of, and when last while it is held.
    newest: Option<(u64, Option<Instant>)>,
}

impl Presses {
    /// Whether this word counts: of a new press, or of one that has not been silent for too long.
    fn goes_on(&mut self, press: u64, now: Instant) -> bool {
        let goes_on = match self.newest {
            Some((newest, heard)) if newest == press => {
                heard.is_some_and(|heard| now.duration_since(heard) <= LAPSES)
            }
            Some((newest, _)) => press > newest,
            None => true,
        };
        if goes_on {
            self.newest = Some((press, Some(now)));
        }
        goes_on
    }

    /// The newest press is over. Whether it was held until now.
    fn end(&mut self) -> bool {
        let heard = self.newest.as_mut().and_then(|(_, heard)| heard.take());
        heard.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_press_goes_on_while_it_is_heard_of_and_not_after_a_silence() {
        let (mut presses, begin) = (Presses::default(), Instant::now());
        let at = |ms| begin + Duration::from_millis(ms);
        assert!(presses.goes_on(1, at(0)));
        assert!(presses.goes_on(1, at(300)));
        assert!(!presses.goes_on(1, at(800)));
        assert!(presses.goes_on(2, at(900)));
        assert!(!presses.goes_on(1, at(901)), "an older one is over");
        assert!(presses.goes_on(2, at(950)));
    }

    #[test]
    fn a_press_that_was_let_go_is_over() {
        let (mut presses, now) = (Presses::default(), Instant::now());
        assert!(!presses.end());
        assert!(presses.goes_on(7, now));
        assert!(presses.end());
        assert!(!presses.end());
        assert!(!presses.goes_on(7, now));
        assert!(presses.goes_on(8, now));
    }
}
