//! The latest few answers, by the demonstrations that were compared and the stretches of them.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::OnceCell;

use super::TaskAgreement;
use crate::ids::DemonstrationId;
use crate::store::trims::Trim;

/// How many sets of demonstrations are remembered.
const REMEMBERED: usize = 64;

/// An answer that is there or is being found, once for all who ask at the same time.
pub(super) type Answer = Arc<OnceCell<TaskAgreement>>;

/// A demonstration and the stretch of it that was compared.
type Compared = (DemonstrationId, Option<Trim>);

/// What was compared lately.
#[derive(Default)]
pub struct Agreements(Mutex<VecDeque<(Vec<Compared>, Answer)>>);

impl Agreements {
    /// The answer about these demonstrations; an empty one when they are new.
    pub(super) fn about(&self, takes: Vec<Compared>) -> Answer {
        // The list is valid after every single operation, so a panic elsewhere can't spoil it.
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let place = known.iter().position(|(compared, _)| *compared == takes);
        let entry = place
            .and_then(|place| known.remove(place))
            .unwrap_or_else(|| (takes, Answer::default()));
        let answer = Arc::clone(&entry.1);
        known.push_back(entry);
        if known.len() > REMEMBERED {
            known.pop_front();
        }
        answer
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_demonstrations_share_an_answer_and_only_the_latest_are_remembered() {
        let known = Agreements::default();
        let ids = vec![
            (DemonstrationId::new(), None),
            (DemonstrationId::new(), None),
        ];
        let answer = known.about(ids.clone());
        assert!(!Arc::ptr_eq(&answer, &known.about(vec![ids[0]])));
        let trim = Trim {
            from_s: 1.0,
            to_s: 3.0,
        };
        let cut = vec![ids[0], (ids[1].0, Some(trim))];
        assert!(!Arc::ptr_eq(&answer, &known.about(cut)));
        for _ in 0..2 * REMEMBERED {
            known.about(vec![(DemonstrationId::new(), None)]);
            assert!(Arc::ptr_eq(&answer, &known.about(ids.clone())));
        }
        for _ in 0..REMEMBERED {
            known.about(vec![(DemonstrationId::new(), None)]);
        }
        assert!(!Arc::ptr_eq(&answer, &known.about(ids)));
    }
}
