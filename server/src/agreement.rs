//! What a person is told about a task's takes before anything is trained: whether they agree,
//! which one does not and where, and whether to record another. Comparing itself is in
//! `learning::agreement`; here it is decided what is compared, and said in words.

mod cache;

use serde::Serialize;
use utoipa::ToSchema;

use crate::ids::{DemonstrationId, TaskId};
use crate::jobs::demonstration_with;
use crate::store::demonstrations::{Demonstration, DemonstrationState};
use crate::store::samples::Sample;
use crate::store::signals::SignalEvent;
use crate::store::text::Failure;
use crate::store::{self, Store};
use crate::trimming::recording;
use crate::uninterrupted::uninterrupted;
use crate::words::sentence;

pub use cache::Agreements;

/// Warping takes time by the square of a take's length: more warpings times seconds squared than
/// this would keep a small computer busy for many seconds. Three takes may last two minutes each,
/// ten takes almost one.
const MOST_WORK_S2: f64 = 300_000.0;

/// How well a task's takes agree.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub struct TaskAgreement {
    /// Each take that is recorded completely and was not discarded, by take.
    takes: Vec<ComparedTake>,
    /// Whether another take would hardly change the motion.
    enough: bool,
    /// What to do, in a worker's words.
    advice: String,
    /// Why nothing can be trained from these takes together.
    #[serde(skip_serializing_if = "Option::is_none")]
    problem: Option<Failure>,
}

/// One take beside the others.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub struct ComparedTake {
    /// The demonstration.
    id: DemonstrationId,
    /// Its number within the task.
    take: u32,
    /// How it compares.
    verdict: Verdict,
    /// The same in a worker's words; missing while there is nothing to say.
    #[serde(skip_serializing_if = "Option::is_none")]
    words: Option<String>,
    /// Mean distance of the tool from the other takes, in millimetres.
    #[serde(skip_serializing_if = "Option::is_none")]
    off_mm: Option<f64>,
    /// Where it differs most from the other takes.
    #[serde(skip_serializing_if = "Option::is_none")]
    worst: Option<WorstPlace>,
}

/// How a take compares with the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It is like the others.
    Agrees,
    /// It shows the same motion, but clearly elsewhere.
    Differs,
    /// It shows another motion.
    OtherMotion,
    /// Nothing can be learnt from it.
    Unusable,
    /// Nothing can be said yet.
    Open,
}

/// A place on the motion.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub struct WorstPlace {
    /// Share of the motion's time, 0 to 1.
    phase: f64,
    /// Joint, from 1.
    joint: usize,
    /// How far the joint is from the other takes there, in degrees.
    off_deg: f64,
}

/// Why takes could not be compared. What is wrong with the takes themselves is an answer.
#[derive(Debug, thiserror::Error)]
pub enum AgreementError {
    /// The store refused.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// A thread broke off.
    #[error("comparing the takes broke off: {0}")]
    Broke(#[from] tokio::task::JoinError),
}

/// How well a task's takes agree. What was compared once is remembered: recordings never change,
/// only the stretches of them that are used.
///
/// # Errors
/// When the task is not there or its recordings can't be read.
pub async fn of_task(
    store: &Store,
    known: &Agreements,
    task: TaskId,
) -> Result<TaskAgreement, AgreementError> {
    store.task(task).await?;
    let mut takes = store.demonstrations(task).await?;
    takes.retain(|take| {
        matches!(
            take.state,
            DemonstrationState::Recorded | DemonstrationState::Kept
        )
    });
    let answer = known.about(takes.iter().map(|take| (take.id, take.trim)).collect());
    if let Some(agreement) = answer.get() {
        return Ok(agreement.clone());
    }
    let store = store.clone();
    // A phone that asks and hangs up must not have the work begun again at its next question.
    uninterrupted(async move {
        let agreement = answer.get_or_try_init(|| compare(&store, takes)).await?;
        Ok(agreement.clone())
    })
    .await
}

async fn compare(
    store: &Store,
    takes: Vec<Demonstration>,
) -> Result<TaskAgreement, AgreementError> {
    let longest_s = takes.iter().map(Demonstration::used_s).fold(0.0, f64::max);
    let warpings = learning::alignment::barycentre::steps(takes.len().max(1));
    if warpings as f64 * longest_s * longest_s > MOST_WORK_S2 {
        return Ok(TaskAgreement::of_too_long(&takes));
    }
    let mut recordings = Vec::with_capacity(takes.len());
    for take in takes {
        let recorded = recording(store, take.id, take.trim).await?;
        recordings.push((take, recorded.samples, recorded.signals));
    }
    Ok(tokio::task::spawn_blocking(move || judge(&recordings)).await?)
}

/// CPU-heavy: not for the async threads.
fn judge(recordings: &[(Demonstration, Vec<Sample>, Vec<SignalEvent>)]) -> TaskAgreement {
    let mut takes: Vec<ComparedTake> = recordings
        .iter()
        .map(|(demonstration, ..)| ComparedTake::open(demonstration))
        .collect();
    let (mut compared, mut usable, mut unusable) = (Vec::new(), Vec::new(), None);
    for (index, (_, samples, signals)) in recordings.iter().enumerate() {
        match demonstration_with(&takes[index].name(), samples, signals) {
            Ok(demonstration) => {
                compared.push(index);
                usable.push(demonstration);
            }
            Err(error) => {
                takes[index].judge(Verdict::Unusable, "Can't be used");
                unusable.get_or_insert((index, error));
            }
        }
    }
    let agreement = learning::agreement::of(&usable, &mut |_, _| Ok(()))
        .and_then(|agreement| learning::signals::check_same(&usable).map(|()| agreement));
    if let Ok(agreement) = &agreement {
        for (&index, take) in compared.iter().zip(&agreement.takes) {
            takes[index].compared(take, agreement.takes.len());
        }
    }
    let problem = match (unusable, &agreement) {
        (Some((index, error)), _) => {
            let advice = format!("{} Discard {}.", error.advice(), takes[index].name());
            Some(failure(&error, sentence(&error), advice))
        }
        (None, Err(error)) => {
            let words = different_motions(error, &mut takes)
                .or_else(|| different_signals(error, &mut takes))
                .unwrap_or_else(|| sentence(error));
            Some(failure(error, words, error.advice().into()))
        }
        (None, Ok(_)) => None,
    };
    match (problem, agreement) {
        (None, Ok(agreement)) => TaskAgreement {
            takes,
            enough: agreement.enough,
            advice: sentence(&agreement.advice),
            problem: None,
        },
        (problem, _) => TaskAgreement {
            takes,
            enough: false,
            advice: problem
                .iter()
                .map(|problem| format!("{} {}", problem.message, problem.advice))
                .collect(),
            problem,
        },
    }
}

fn failure(error: &learning::Error, message: String, advice: String) -> Failure {
    Failure {
        code: error.code().into(),
        message,
        advice,
    }
}

/// Marks the takes that show another motion, and says which. Where as many show the one as the
/// other, nobody can tell which was meant.
fn different_motions(error: &learning::Error, takes: &mut [ComparedTake]) -> Option<String> {
    let learning::Error::DifferentMotions { groups } = error else {
        return None;
    };
    let [most, others] = groups;
    let undecided = most.len() <= others.len();
    for take in takes {
        if others.contains(&take.name()) || undecided {
            take.judge(Verdict::OtherMotion, "Shows another motion");
        }
    }
    let several = others.len() > 1;
    let (most, others) = (listed(most), listed(others));
    Some(sentence(&if undecided {
        format!("{most} and {others} show different motions")
    } else if several {
        format!("{others} show another motion than {most}")
    } else {
        format!("{others} shows another motion than {most}")
    }))
}

/// Marks the take that works the signals differently. Of two takes nobody can tell which is odd.
fn different_signals(error: &learning::Error, takes: &mut [ComparedTake]) -> Option<String> {
    let learning::Error::SignalsDiffer { name, other, .. } = error else {
        return None;
    };
    let undecided = takes.len() < 3;
    for take in takes {
        if take.name() == *name || (undecided && take.name() == *other) {
            take.judge(Verdict::Differs, "Works the gripper differently");
        }
    }
    Some(sentence(error))
}

/// "take 1, take 2 and take 3".
fn listed(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [name] => name.clone(),
        [names @ .., last] => format!("{} and {last}", names.join(", ")),
    }
}

impl ComparedTake {
    fn open(demonstration: &Demonstration) -> Self {
        Self {
            id: demonstration.id,
            take: demonstration.take,
            verdict: Verdict::Open,
            words: None,
            off_mm: None,
            worst: None,
        }
    }

    fn name(&self) -> String {
        format!("take {}", self.take)
    }

    fn judge(&mut self, verdict: Verdict, words: impl Into<String>) {
        self.verdict = verdict;
        self.words = Some(words.into());
    }

    /// Of two takes nobody can tell which one is odd, and one has nothing beside it.
    fn compared(&mut self, found: &learning::agreement::TakeAgreement, takes: usize) {
        if takes < 2 {
            return;
        }
        let worst = &found.worst;
        self.off_mm = found.off_mm;
        self.worst = Some(WorstPlace {
            phase: worst.phase,
            joint: worst.joint,
            off_deg: worst.off_deg,
        });
        if found.differs {
            let words = format!("Differs most {} at joint {}", worst.words(), worst.joint);
            self.judge(Verdict::Differs, words);
        } else if takes > 2 {
            self.judge(Verdict::Agrees, "Agrees");
        }
    }
}

impl TaskAgreement {
    fn of_too_long(takes: &[Demonstration]) -> Self {
        Self {
            takes: takes.iter().map(ComparedTake::open).collect(),
            enough: false,
            advice: "Together these takes are too long to be compared here. The training compares them and says what it finds.".into(),
            problem: None,
        }
    }
}
