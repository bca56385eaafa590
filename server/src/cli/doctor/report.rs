//! What the doctor found, for people and for programs.

use serde::Serialize;
use serde_json::json;

/// What is looked at, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Step {
    Address,
    Certificate,
    LogIn,
    RobotWare,
    Options,
    Rights,
    Mode,
    Motors,
    Program,
    Position,
    LeadThrough,
    Signals,
    Clock,
    EgmPort,
    EgmMessages,
    EgmAnswers,
}

impl Step {
    pub const ALL: [Self; 16] = [
        Self::Address,
        Self::Certificate,
        Self::LogIn,
        Self::RobotWare,
        Self::Options,
        Self::Rights,
        Self::Mode,
        Self::Motors,
        Self::Program,
        Self::Position,
        Self::LeadThrough,
        Self::Signals,
        Self::Clock,
        Self::EgmPort,
        Self::EgmMessages,
        Self::EgmAnswers,
    ];

    fn title(self) -> &'static str {
        match self {
            Self::Address => "The controller's address answers",
            Self::Certificate => "The certificate is the controller's",
            Self::LogIn => "The account is accepted",
            Self::RobotWare => "RobotWare is of generation 7",
            Self::Options => "The option for guided motion is installed",
            Self::Rights => "The account may move the program pointer",
            Self::Mode => "The controller is in automatic mode",
            Self::Motors => "No stop is active",
            Self::Program => "TEAM's robot modules are loaded",
            Self::Position => "The arm's position can be read",
            Self::LeadThrough => "Lead-through is there",
            Self::Signals => "The signals are there",
            Self::Clock => "The clocks agree",
            Self::EgmPort => "The port for EGM is free",
            Self::EgmMessages => "EGM messages arrive",
            Self::EgmAnswers => "Our EGM answers are applied",
        }
    }
}

/// How a step went.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    Ok,
    Failed,
    Skipped,
}

/// One step.
#[derive(Clone, Debug, Serialize)]
pub struct Finding {
    pub step: Step,
    pub outcome: Outcome,
    /// What was seen, or why nothing was.
    pub saw: String,
    /// What to do about a failure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub advice: Option<String>,
}

/// All steps.
#[derive(Debug, Default)]
pub struct Report(Vec<Finding>);

impl Report {
    pub fn ok(&mut self, step: Step, saw: impl Into<String>) {
        self.add(step, Outcome::Ok, saw.into(), None);
    }

    pub fn failed(&mut self, step: Step, saw: impl Into<String>, advice: impl Into<String>) {
        self.add(step, Outcome::Failed, saw.into(), Some(advice.into()));
    }

    pub fn skipped(&mut self, step: Step, why: impl Into<String>) {
        self.add(step, Outcome::Skipped, why.into(), None);
    }

    /// The controller refused, with its words and ours.
    pub fn refused(&mut self, step: Step, error: &rws::RwsError) {
        self.failed(step, error.to_string(), error.advice());
    }

    fn add(&mut self, step: Step, outcome: Outcome, saw: String, advice: Option<String>) {
        self.0.push(Finding {
            step,
            outcome,
            saw,
            advice,
        });
    }

    /// Marks every step that was not looked at.
    pub fn skip_the_rest(&mut self, why: &str) {
        for step in Step::ALL {
            if self.0.iter().all(|finding| finding.step != step) {
                self.skipped(step, why);
            }
        }
    }

    /// Whether all of these went well.
    pub fn all_ok(&self, steps: &[Step]) -> bool {
        steps
            .iter()
            .all(|step| self.with(Outcome::Ok).any(|ok| ok == *step))
    }

    pub fn findings(&self) -> &[Finding] {
        &self.0
    }

    /// So many steps failed.
    pub fn failures(&self) -> usize {
        self.with(Outcome::Failed).count()
    }

    fn with(&self, outcome: Outcome) -> impl Iterator<Item = Step> {
        self.0
            .iter()
            .filter(move |finding| finding.outcome == outcome)
            .map(|finding| finding.step)
    }

    /// A line for each step, and what to do below those that failed.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for finding in &self.0 {
            let word = match finding.outcome {
                Outcome::Ok => "ok     ",
                Outcome::Failed => "FAILED ",
                Outcome::Skipped => "skipped",
            };
            text += &format!("{word}  {}: {}\n", finding.step.title(), finding.saw);
            if let Some(advice) = &finding.advice {
                text += &format!("         What to do: {advice}\n");
            }
        }
        let [ok, failed, skipped] = [Outcome::Ok, Outcome::Failed, Outcome::Skipped]
            .map(|outcome| self.with(outcome).count());
        text + &format!("\n{ok} ok, {failed} failed, {skipped} skipped\n")
    }

    /// The same for programs.
    pub fn json(&self) -> String {
        let healthy = self.failures() == 0;
        format!("{:#}\n", json!({"healthy": healthy, "steps": self.0}))
    }
}
