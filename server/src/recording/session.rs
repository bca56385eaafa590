//! One recording: samples come in, chunks go out, until somebody or something ends it.

mod pausing;

use std::time::Duration;

use robot::{GuidanceEvent, GuidanceSample, HandActivity, HandCommand, RobotView};
use tokio::sync::{mpsc, watch};
use tokio::time::{Instant, MissedTickBehavior, interval, sleep_until};

use super::orders::Ordered;
use super::{HandShowing, SERVER_STOPPED, Samples, Stop, Tools};
use crate::ids::DemonstrationId;
use crate::jobs::demonstration_of;
use crate::store;
use crate::store::demonstrations::DemonstrationState;
use crate::store::recordings::{Closing, Gap, NewSamples};
use crate::store::samples::Sample;
use crate::store::signals::SignalEvent;
use crate::words::sentence;
use pausing::Flow;

/// A crash costs at most what came in since the last chunk.
const COMMIT_EVERY: Duration = Duration::from_millis(200);
/// A recording that nobody ends, because the phone's battery ran out, ends itself.
const LONGEST: Duration = Duration::from_secs(20 * 60);
/// One recording on its way.
pub(super) struct Session {
    tools: Tools,
    id: DemonstrationId,
    incoming: Samples,
    stop: watch::Receiver<Stop>,
    orders: mpsc::Receiver<Ordered>,
    begin_us: Option<u64>,
    flow: Flow,
    seq: usize,
    samples: Vec<Sample>,
    gaps: Vec<Gap>,
    signals: Vec<SignalEvent>,
}

/// Why a recording ended.
enum End {
    /// Somebody pressed stop, or the hand was done: all is well.
    Wanted,
    /// Something else ended it; the words are for people.
    Note(String),
}

impl Session {
    pub(super) fn new(
        tools: Tools,
        id: DemonstrationId,
        incoming: Samples,
        stop: watch::Receiver<Stop>,
        orders: mpsc::Receiver<Ordered>,
    ) -> Self {
        Self {
            tools,
            id,
            incoming,
            stop,
            orders,
            begin_us: None,
            flow: Flow::default(),
            seq: 0,
            samples: Vec::new(),
            gaps: Vec::new(),
            signals: Vec::new(),
        }
    }

    /// Records until the end, whatever it is, and closes the demonstration.
    pub(super) async fn run(mut self, hand: Option<HandShowing>) {
        let end = match hand {
            Some(hand) => match self.prepare(hand).await {
                Ok(()) => self.record(Some(hand)).await,
                Err(end) => end,
            },
            None => self.record(None).await,
        };
        // Nobody can stop it any more; who wants the arm next waits for the rest.
        self.stop = watch::channel(Stop::No).1;
        self.orders.close();
        self.tools.stiff_arm().await;
        if let Err(error) = self.close(end).await {
            tracing::error!(demonstration.id = %self.id, %error, "a recording could not be closed");
        }
    }

    /// Has the hand bring the arm to where the showing begins; nothing is kept of that.
    async fn prepare(&mut self, hand: HandShowing) -> Result<(), End> {
        let HandShowing { script, seed } = hand;
        let view = self.tools.robot.view();
        let command = HandCommand::Return { script, seed };
        self.tools
            .robot
            .virtual_hand(command)
            .await
            .map_err(refused)?;
        let mut done = std::pin::pin!(hand_done(view, HandActivity::Returning));
        loop {
            tokio::select! {
                biased;
                end = stopped(&mut self.stop) => return Err(end),
                event = self.incoming.recv() => {
                    if let Some(end) = end_in(event.as_ref()) {
                        return Err(end);
                    }
                }
                () = &mut done => break,
            }
        }
        let demonstration = self
            .tools
            .store
            .begin_recording(self.id)
            .await
            .map_err(unstored)?;
        self.tools.events.tell(&demonstration);
        Ok(())
    }

    async fn record(&mut self, hand: Option<HandShowing>) -> End {
        // What is still queued was made before the recording began.
        if hand.is_some() {
            while self.incoming.try_recv().is_ok() {}
        }
        let view = self.tools.robot.view();
        if let Some(HandShowing { script, seed }) = hand {
            let command = HandCommand::Show { script, seed };
            if let Err(error) = self.tools.robot.virtual_hand(command).await {
                return refused(error);
            }
        }
        let mut done = std::pin::pin!(async {
            match hand {
                Some(_) => hand_done(view, HandActivity::Showing).await,
                None => std::future::pending().await,
            }
        });
        let mut commit = interval(COMMIT_EVERY);
        commit.set_missed_tick_behavior(MissedTickBehavior::Delay);
        let too_long = Instant::now() + LONGEST;
        let end = loop {
            tokio::select! {
                biased;
                end = stopped(&mut self.stop) => break end,
                () = &mut done => break End::Wanted,
                () = sleep_until(too_long) => break End::Note(
                    "The recording was ended after 20 minutes.".into()
                ),
                _ = commit.tick() => {
                    if let Err(error) = self.commit().await {
                        break unstored(error);
                    }
                }
                event = self.incoming.recv() => {
                    if let Some(end) = end_in(event.as_ref()) {
                        break end;
                    }
                    event.into_iter().for_each(|event| self.take(event));
                }
                // Last, so that all that came before is taken first.
                Some(ordered) = self.orders.recv() => self.obey(ordered).await,
            }
        };
        // What the arm did before the end was asked for belongs to the recording.
        while let Ok(event) = self.incoming.try_recv() {
            self.take(event);
        }
        end
    }

    fn take(&mut self, event: GuidanceEvent) {
        match event {
            GuidanceEvent::Sample(sample) => {
                if self.flow.holds_up(&sample) {
                    return;
                }
                let begin_us = self.begin_at(&sample);
                let sample = Sample {
                    at_us: sample.at_us.saturating_sub(begin_us),
                    joints_deg: sample.joints.0,
                    tcp_mm: None,
                };
                self.flow.saw(&sample);
                self.samples.push(sample);
            }
            GuidanceEvent::Gap { at_us, length_us } => {
                // A gap before the first sample or in a pause is not inside the recording.
                if let (Some(begin_us), None) = (self.begin_us, self.flow.place_us()) {
                    let at_us = at_us.saturating_sub(begin_us);
                    self.gaps.push(Gap { at_us, length_us });
                }
            }
            GuidanceEvent::Signal { name, on, at_us } => {
                self.take_signal(at_us, name, on);
            }
            GuidanceEvent::Ended { .. } => {}
        }
    }

    /// When the recording began. With its first sample it begins, and the signals as they stand.
    /// After a pause it is moved so that the pause is closed up.
    fn begin_at(&mut self, sample: &GuidanceSample) -> u64 {
        let at_us = sample.at_us;
        if let Some(begin_us) = self.begin_us {
            let begin_us = self.flow.closed_up(sample).unwrap_or(begin_us);
            self.begin_us = Some(begin_us);
            return begin_us;
        }
        self.begin_us = Some(at_us);
        let view = self.tools.robot.view();
        for signal in &view.borrow().signals {
            let name = &signal.signal.name;
            let is_told = self.signals.iter().any(|told| told.name == *name);
            if let (false, Some(on)) = (is_told, signal.is_on) {
                let name = name.clone();
                self.flow.stands(&name, on);
                self.signals.push(SignalEvent { at_us: 0, name, on });
            }
        }
        at_us
    }

    /// A change of a signal. One before the first sample is part of how the recording began.
    fn take_signal(&mut self, at_us: u64, name: String, on: bool) {
        if self.flow.is_paused() {
            return self.flow.meanwhile(name, on);
        }
        if let Some(at_us) = self.flow.place_us() {
            self.flow.stands(&name, on);
            return self.signals.push(SignalEvent { at_us, name, on });
        }
        self.flow.stands(&name, on);
        let begin_us = self.begin_us.unwrap_or(u64::MAX);
        let at_us = at_us.saturating_sub(begin_us);
        let mut told = self.signals.iter_mut();
        if let Some(began) = told.find(|told| told.name == name && told.at_us == 0) {
            if at_us == 0 {
                began.on = on;
                return;
            }
            // Only changes are told. One to how the signal began means that it was looked at
            // after this change; and whatever comes after one is no news about the beginning.
            let is_first = self.signals.iter().filter(|told| told.name == name).count() == 1;
            if is_first && let Some(began) = self.signals.iter_mut().find(|s| s.name == name) {
                began.on = !on;
            }
        }
        self.signals.push(SignalEvent { at_us, name, on });
    }

    /// Commits what came in since the last time.
    async fn commit(&mut self) -> Result<(), store::Error> {
        if self.samples.is_empty() && self.gaps.is_empty() && self.signals.is_empty() {
            return Ok(());
        }
        let new = self.uncommitted();
        let demonstration = self.tools.store.append_samples(self.id, new).await?;
        self.committed();
        self.tools.events.tell(&demonstration);
        Ok(())
    }

    fn uncommitted(&self) -> NewSamples<'_> {
        NewSamples {
            seq: self.seq,
            samples: &self.samples,
            gaps: &self.gaps,
            signals: &self.signals,
        }
    }

    fn committed(&mut self) {
        self.seq += 1;
        self.samples.clear();
        self.gaps.clear();
        self.signals.clear();
    }

    async fn close(&mut self, end: End) -> Result<(), store::Error> {
        let stored = self.tools.store.samples(self.id).await?;
        let all: Vec<Sample> = stored
            .into_iter()
            .chain(self.samples.iter().copied())
            .collect();
        let (state, note) = match end {
            _ if all.is_empty() => (
                DemonstrationState::Discarded,
                Some(match end {
                    End::Wanted => "It was stopped before anything was recorded.".into(),
                    End::Note(note) => note,
                }),
            ),
            End::Wanted => (DemonstrationState::Recorded, None),
            End::Note(note) => (DemonstrationState::Recorded, Some(note)),
        };
        let last = self.uncommitted();
        let problem = problem_with(&all);
        let closing = Closing {
            state,
            note: note.as_deref(),
            problem: problem.as_deref(),
        };
        let demonstration = self
            .tools
            .store
            .close_demonstration(self.id, last, &closing)
            .await?;
        self.tools.events.tell(&demonstration);
        Ok(())
    }
}

/// Why nothing can be learnt from these samples, in words, or nothing.
fn problem_with(samples: &[Sample]) -> Option<String> {
    const NAME: &str = "recording";
    let error = demonstration_of(NAME, samples).err()?;
    let words = error.to_string();
    let words = words
        .strip_prefix(NAME)
        .map_or(words.as_str(), |rest| rest.trim_start_matches(": "));
    Some(format!("{} {}", sentence(&words), error.advice()))
}

async fn stopped(stop: &mut watch::Receiver<Stop>) -> End {
    match stop
        .wait_for(|stop| *stop != Stop::No)
        .await
        .map(|stop| *stop)
    {
        Ok(Stop::Asked | Stop::No) => End::Wanted,
        Ok(Stop::ServerStops) | Err(_) => End::Note(SERVER_STOPPED.into()),
    }
}

fn end_in(event: Option<&GuidanceEvent>) -> Option<End> {
    match event {
        Some(GuidanceEvent::Ended { reason }) => Some(End::Note(sentence(reason))),
        None => Some(End::Note("The connection to the arm was lost.".into())),
        Some(_) => None,
    }
}

/// Waits until the hand has done what it was told; it is at it when it has taken the command.
async fn hand_done(mut view: watch::Receiver<RobotView>, doing: HandActivity) {
    // An error means that the robot is gone, which also ends the samples.
    let _ = view.wait_for(|view| view.hand != Some(doing)).await;
}

fn refused(error: robot::RobotError) -> End {
    End::Note(sentence(&format!(
        "the virtual hand could not begin: {error}"
    )))
}

fn unstored(error: store::Error) -> End {
    tracing::error!(%error, "a recording could not be stored");
    End::Note("The recording ended early because it could not be stored.".into())
}
