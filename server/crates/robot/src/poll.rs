//! Asks the controller again and again how it is, at a pace that fits what the arm does.
//!
//! The answers go to the supervisor; nothing is decided here.

use crate::guidance::HandActivity;
use crate::signals;
use motion::JointAngles;
use rws::{Client, ControllerState, OperatingMode, RwsError};
use std::time::{Duration, Instant};
use tokio::sync::{mpsc, watch};
use tokio::time::MissedTickBehavior;

const SLOW: Duration = Duration::from_millis(100);
const FAST: Duration = Duration::from_millis(10);
/// While the controller does not answer.
const RETRY: Duration = Duration::from_millis(300);
/// While guiding, every so many joint readings one other thing is asked for.
const OTHER_EVERY: u32 = 5;

/// How often to ask.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pace {
    /// Nothing moves: about 20 questions a second, as ABB advises.
    Idle,
    /// A recorder wants the joints about 100 times a second, unless EGM delivers them.
    Guiding { egm_delivers: bool },
    /// EGM delivers the joints; the controller's state matters.
    Reproducing,
}

/// An answer.
#[derive(Debug)]
pub(crate) struct Observation {
    /// When the question was asked.
    pub asked: Instant,
    pub news: News,
}

/// What was learnt.
#[derive(Debug)]
pub(crate) enum News {
    Joints {
        joints: JointAngles,
        /// Half way between question and answer.
        at: Instant,
    },
    Controller(ControllerState),
    Mode(OperatingMode),
    LeadThrough(bool),
    Hand(HandActivity),
    /// Nothing when the controller does not tell.
    Signal {
        name: String,
        value: Option<bool>,
    },
    Failed(RwsError),
}

#[derive(Debug, Clone)]
enum Question {
    Joints,
    Controller,
    Mode,
    LeadThrough,
    Hand,
    Signal(String),
}

/// Asks until the supervisor is gone.
pub(crate) async fn poll(
    client: Client,
    has_virtual_hand: bool,
    signals: Vec<String>,
    pace: watch::Receiver<Pace>,
    observations: mpsc::Sender<Observation>,
) {
    let mut others = Turn::new(has_virtual_hand, signals);
    let mut fast = tokio::time::interval(FAST);
    let mut slow = tokio::time::interval(SLOW);
    fast.set_missed_tick_behavior(MissedTickBehavior::Delay);
    slow.set_missed_tick_behavior(MissedTickBehavior::Delay);
    let mut count = 0_u32;
    let mut complained = None;
    loop {
        let pace = *pace.borrow();
        let questions = match pace {
            Pace::Guiding {
                egm_delivers: false,
            } => {
                fast.tick().await;
                let other = count.is_multiple_of(OTHER_EVERY).then(|| others.next(pace));
                [Some(Question::Joints), other]
            }
            _ => {
                slow.tick().await;
                [Some(Question::Joints), Some(others.next(pace))]
            }
        };
        count = count.wrapping_add(1);
        for question in questions.into_iter().flatten() {
            let asked = Instant::now();
            let news = ask(&client, question, asked)
                .await
                .unwrap_or_else(News::Failed);
            let failed = matches!(news, News::Failed(_));
            complain(&news, &mut complained);
            if observations
                .send(Observation { asked, news })
                .await
                .is_err()
            {
                return;
            }
            if failed {
                tokio::time::sleep(RETRY).await;
                break;
            }
        }
    }
}

/// Logs why the controller cannot be asked, once until it is something else.
fn complain(news: &News, complained: &mut Option<&'static str>) {
    let News::Failed(error) = news else {
        *complained = None;
        return;
    };
    if complained.replace(error.code()) != Some(error.code()) {
        tracing::warn!("{error}. {}", error.advice());
    }
}

async fn ask(client: &Client, question: Question, asked: Instant) -> Result<News, RwsError> {
    Ok(match question {
        Question::Joints => {
            let joints = JointAngles(client.joint_target_deg().await?);
            let at = asked + asked.elapsed() / 2;
            News::Joints { joints, at }
        }
        Question::Controller => News::Controller(client.controller_state().await?),
        Question::Mode => News::Mode(client.operating_mode().await?),
        Question::LeadThrough => News::LeadThrough(client.lead_through().await?),
        Question::Hand => News::Hand(client.virtual_hand_state().await?.into()),
        Question::Signal(name) => {
            let value = match signals::read(client, &name).await {
                Ok(on) => Some(on),
                Err(error) if error.is_unreachable() => return Err(error),
                // A signal that the controller does not have is no reason to lose the robot.
                Err(_) => None,
            };
            News::Signal { name, value }
        }
    })
}

/// Whose turn it is among the slower questions.
struct Turn {
    next: usize,
    has_virtual_hand: bool,
    signals: Vec<String>,
}

impl Turn {
    fn new(has_virtual_hand: bool, signals: Vec<String>) -> Self {
        Self {
            next: 0,
            has_virtual_hand,
            signals,
        }
    }

    fn next(&mut self, pace: Pace) -> Question {
        const IDLE: [Question; 4] = [
            Question::Controller,
            Question::LeadThrough,
            Question::Controller,
            Question::Mode,
        ];
        const GUIDING: [Question; 3] =
            [Question::LeadThrough, Question::Controller, Question::Hand];
        const REPRODUCING: [Question; 1] = [Question::Controller];
        let questions: &[Question] = match pace {
            Pace::Idle => &IDLE,
            Pace::Guiding { .. } if self.has_virtual_hand => &GUIDING,
            Pace::Guiding { .. } => &GUIDING[..2],
            Pace::Reproducing => &REPRODUCING,
        };
        // A run knows how its signals stand because it sets them.
        let signals: &[String] = match pace {
            Pace::Reproducing => &[],
            _ => &self.signals,
        };
        self.next = (self.next + 1) % (questions.len() + signals.len());
        match questions.get(self.next) {
            Some(question) => question.clone(),
            None => Question::Signal(signals[self.next - questions.len()].clone()),
        }
    }
}
