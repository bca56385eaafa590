//! When the questionnaire is put to a person: after a motion, once a shift. What the statements say
//! is the app's; what is stored is the store's.

use crate::clock::WallTime;
use crate::ids::{PersonId, ReproductionId};
use crate::store::questionnaire::{Given, Reply};
use crate::store::reproductions::Reproduction;
use crate::store::{self, Store};

/// A shift is not known by its hours here: nobody is asked twice within its length.
const SHIFT_MS: i64 = 8 * 3_600_000;
/// A motion that ended longer ago is looked up, not remembered.
const FRESH_MS: i64 = 3_600_000;

/// Why a reply can't be taken.
#[derive(Debug, thiserror::Error)]
pub enum QuestionnaireError {
    /// The store refused.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// An answer that is none of the five.
    #[error("answer {statement} is {value}, it must be from 1 to 5")]
    BadAnswer {
        /// Statement, from 1.
        statement: usize,
        /// What was sent.
        value: u8,
    },
    /// The motion named is another task's.
    #[error("this motion belongs to another task")]
    OtherTask,
    /// The person replied in this shift already.
    #[error("the questions of this shift are answered or skipped already")]
    TooSoon,
}

/// Whether to ask, and from when on if not now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Due {
    /// Ask now.
    pub now: bool,
    /// This person is left alone until then.
    pub not_before: Option<WallTime>,
}

/// Whether to ask this person now. When a motion is named, only for a while after it.
///
/// # Errors
/// When there is no such motion.
pub async fn due(
    store: &Store,
    person: PersonId,
    after: Option<ReproductionId>,
    now: WallTime,
) -> Result<Due, store::Error> {
    let last = store.last_reply(person).await?;
    let not_before = last
        .map(|at| at.plus_ms(SHIFT_MS))
        .filter(|next| *next > now);
    let fresh = match after {
        Some(id) => worth_asking_about(&store.reproduction(id).await?, now),
        None => true,
    };
    Ok(Due {
        now: fresh && not_before.is_none(),
        not_before,
    })
}

/// A way back shows nothing of what was taught.
fn worth_asking_about(motion: &Reproduction, now: WallTime) -> bool {
    let lately = |end: WallTime| end.plus_ms(FRESH_MS) > now;
    !motion.backwards && motion.finished_at.is_some_and(lately)
}

/// Takes a reply; the second value is false when it was there already.
///
/// # Errors
/// When the answers are none, or the person replied in this shift.
pub async fn take(
    store: &Store,
    person: PersonId,
    reply: &Reply,
) -> Result<(Reply, bool), QuestionnaireError> {
    for (index, &value) in reply.answers.iter().flatten().enumerate() {
        if !(1..=5).contains(&value) {
            return Err(QuestionnaireError::BadAnswer {
                statement: index + 1,
                value,
            });
        }
    }
    let task = store.task(reply.task_id).await?;
    if let Some(id) = reply.reproduction_id
        && store.reproduction(id).await?.task_id != task.id
    {
        return Err(QuestionnaireError::OtherTask);
    }
    let since = reply.at.plus_ms(-SHIFT_MS);
    match store.add_reply(person, reply, since).await? {
        Given::Stored(reply) => Ok((reply, true)),
        Given::Known(reply) => Ok((reply, false)),
        Given::TooSoon => Err(QuestionnaireError::TooSoon),
    }
}
