//! Guiding: from the request to the stiff arm, and what the controller says meanwhile.

use super::{Done, Mode, Reply, Request, Supervisor};
use crate::config::RobotKind;
use crate::error::RobotError;
use crate::guidance::{GuidanceEvent, GuidanceStream, HandCommand, Source};
use crate::poll::{News, Observation};
use crate::procedures;
use rws::ControllerState;
use rws::virtual_hand::Action;
use std::time::Instant;
use tokio::sync::mpsc;

/// Without an answer of the controller for this long, guidance is over, µs.
const PATIENCE_US: u64 = 1_000_000;

impl Supervisor {
    pub(super) fn start_guidance(
        &mut self,
        stops: u64,
        reply: Reply<mpsc::Receiver<GuidanceEvent>>,
    ) {
        let client = match self.idle_client() {
            Ok(client) => client,
            Err(error) => {
                let _ = reply.send(Err(error));
                return;
            }
        };
        let flags = std::sync::Arc::clone(&self.links.flags);
        self.mode = Mode::EnteringGuidance(reply);
        self.operation = Some(Box::pin(async move {
            let stopped = || flags.stops() != stops;
            let result = procedures::enter_guidance(&client, stopped).await;
            Done::GuidanceEntered(stops, result)
        }));
    }

    pub(super) fn guidance_entered(&mut self, stops: u64, result: Result<(), RobotError>) {
        let mode = std::mem::replace(&mut self.mode, Mode::Idle);
        let Mode::EnteringGuidance(reply) = mode else {
            self.mode = mode;
            return;
        };
        if let Err(error) = result {
            tracing::warn!(%error, "the arm did not go soft");
            let unreachable =
                matches!(&error, RobotError::Controller(error) if error.is_unreachable());
            self.unfinished.guidance = unreachable;
            let _ = reply.send(Err(error));
            if unreachable {
                self.seen.connected = false;
            }
            self.come_to_rest();
            return;
        }
        self.seen.change(Some(ControllerState::MotorsOn), true);
        self.drop_samples();
        self.links.flags.set_streaming(true);
        let (stream, events) = GuidanceStream::begin(self.now_us());
        self.mode = Mode::Guiding { stream, stops };
        self.publish();
        if reply.send(Ok(events)).is_err() {
            // Nobody waits for it any more: a soft arm must not be forgotten.
            self.leave_guidance("nobody was there any more", None);
        }
    }

    pub(super) fn stop_guidance(&mut self, reply: Reply<()>) {
        let is_soft = self.is_soft_by_itself();
        match &mut self.mode {
            Mode::Guiding { .. } => self.leave_guidance("stopped", Some(reply)),
            Mode::LeavingGuidance(replies) => replies.push(reply),
            Mode::Idle if is_soft => self.make_stiff(vec![reply]),
            Mode::Idle => {
                let _ = reply.send(Err(RobotError::NotGuiding));
            }
            _ => {
                let _ = reply.send(Err(self.busy()));
            }
        }
    }

    /// The arm is soft although nobody guides it through us: a server before us may have been
    /// killed, or someone used the FlexPendant.
    pub(super) fn is_soft_by_itself(&self) -> bool {
        matches!(self.mode, Mode::Idle)
            && self.operation.is_none()
            && self.seen.lead_through == Some(true)
    }

    /// Ends the stream with `reason` and makes the arm stiff.
    pub(super) fn leave_guidance(&mut self, reason: &str, reply: Option<Reply<()>>) {
        self.drain_samples();
        self.links.flags.set_streaming(false);
        let Mode::Guiding { stream, .. } = &mut self.mode else {
            return;
        };
        stream.end(reason);
        tracing::info!(reason, "guidance ends");
        self.make_stiff(reply.into_iter().collect());
    }

    /// Makes the arm stiff and answers `replies` when it is.
    pub(super) fn make_stiff(&mut self, replies: Vec<Reply<()>>) {
        self.mode = Mode::LeavingGuidance(replies);
        if let Some(client) = self.client.clone() {
            self.operation = Some(Box::pin(async move {
                Done::GuidanceLeft(procedures::leave_guidance(&client).await)
            }));
        }
    }

    pub(super) fn guidance_left(&mut self, result: Result<(), RobotError>) {
        let mode = std::mem::replace(&mut self.mode, Mode::Disconnected);
        let Mode::LeavingGuidance(replies) = mode else {
            self.mode = mode;
            return;
        };
        match &result {
            Ok(()) => {
                self.seen.change(None, false);
                self.come_to_rest();
            }
            Err(RobotError::Controller(error)) if error.is_unreachable() => {
                self.unfinished.guidance = true;
                self.seen.connected = false;
            }
            Err(error) => {
                tracing::error!(%error, "the arm may still be soft");
                self.unfinished.guidance = true;
                self.mode = Mode::Faulted(error.to_fault());
            }
        }
        let fault = result.err().map(|error| error.to_fault());
        for reply in replies {
            let _ = reply.send(match (&fault, &self.mode) {
                (None, _) => Ok(()),
                (Some(fault), Mode::Faulted(_)) => Err(RobotError::Faulted(fault.clone())),
                (Some(_), _) => Err(RobotError::Disconnected),
            });
        }
    }

    /// Sets the virtual hand going, beside everything else.
    pub(super) fn move_hand(&mut self, command: HandCommand, reply: Reply<()>) {
        let client = match (&self.mode, &self.client) {
            _ if self.config.kind == RobotKind::None => Err(RobotError::NoRobot),
            (Mode::Guiding { .. }, Some(client)) => Ok(client.clone()),
            _ => Err(RobotError::NotGuiding),
        };
        let client = match client {
            Ok(client) => client,
            Err(error) => {
                let _ = reply.send(Err(error));
                return;
            }
        };
        let (action, script, seed) = match command {
            HandCommand::Return { script, seed } => (Action::Return, script, seed),
            HandCommand::Show { script, seed } => (Action::Show, script, seed),
            HandCommand::Lead(_) | HandCommand::LetGo => {
                tokio::spawn(lead_hand(client, command, reply));
                return;
            }
        };
        let requests = self.requests.clone();
        tokio::spawn(async move {
            let moved = client.move_virtual_hand(action, script.name(), seed).await;
            let at = Instant::now();
            let state = match moved {
                Ok(()) => client.virtual_hand_state().await,
                Err(error) => Err(error),
            };
            let refusal = match (state, requests.upgrade()) {
                (Err(error), _) => error.into(),
                (Ok(_), None) => RobotError::ShuttingDown,
                (Ok(state), Some(requests)) => {
                    let activity = state.into();
                    let moves = Request::HandMoves {
                        at,
                        activity,
                        reply,
                    };
                    // When the supervisor is gone its caller sees the reply dropped.
                    let _ = requests.send(moves).await;
                    return;
                }
            };
            let _ = reply.send(Err(refusal));
        });
    }

    pub(super) fn observe(&mut self, observation: Observation) {
        if let News::Failed(error) = &observation.news {
            return self.see_failure(error);
        }
        let was_connected = std::mem::replace(&mut self.seen.connected, true);
        self.seen.answered_us = self.now_us();
        match observation.news {
            News::Joints { joints, at } => {
                let at_us = at.saturating_duration_since(self.epoch).as_micros() as u64;
                self.seen.see_joints(joints, at_us);
                if let Mode::Guiding { stream, .. } = &mut self.mode {
                    stream.offer(at_us, joints, Source::WebServices);
                }
            }
            News::Controller(_) | News::LeadThrough(_)
                if !self.seen.is_current(observation.asked) => {}
            News::Controller(state) => {
                self.seen.controller = Some(state);
                self.attend_guidance();
                self.attend_run();
            }
            News::Mode(mode) => self.seen.mode = Some(mode),
            News::LeadThrough(active) => {
                self.seen.lead_through = Some(active);
                self.attend_guidance();
            }
            News::Hand(activity) => self.seen.see_hand(observation.asked, activity),
            News::Signal { name, value } => self.see_signal(&name, value, observation.asked),
            News::Failed(_) => {}
        }
        if matches!(self.mode, Mode::Disconnected) {
            self.come_back();
        }
        if !was_connected {
            tracing::info!("the robot answers");
            self.publish();
        }
    }

    /// Whether the arm is still soft and may be; a person, a safety stop or the FlexPendant can
    /// end that.
    pub(super) fn attend_guidance(&mut self) {
        let Mode::Guiding { stops, .. } = self.mode else {
            return;
        };
        let stop = self.seen.controller.as_ref();
        let reason = if self.links.flags.stops() != stops {
            "the arm was stopped"
        } else if let Some(reason) = stop.and_then(procedures::not_ready) {
            reason
        } else if stop == Some(&ControllerState::MotorsOff) {
            "the motors were switched off"
        } else if self.seen.lead_through == Some(false) {
            "the robot took hold of the arm again"
        } else {
            return;
        };
        self.leave_guidance(reason, None);
    }

    fn see_failure(&mut self, error: &rws::RwsError) {
        if std::mem::replace(&mut self.seen.connected, false) {
            tracing::warn!(%error, "the robot does not answer");
            self.signals.forget();
        }
        match &mut self.mode {
            Mode::Idle => self.mode = Mode::Disconnected,
            Mode::Guiding { stream, .. } => {
                let now_us = self.epoch.elapsed().as_micros() as u64;
                if now_us.saturating_sub(self.seen.answered_us) > PATIENCE_US {
                    stream.end("the connection to the robot was lost");
                    self.links.flags.set_streaming(false);
                    self.unfinished.guidance = true;
                    self.mode = Mode::Disconnected;
                }
            }
            _ => {}
        }
        self.publish();
    }

    /// Passes on what came over EGM while guiding.
    pub(super) fn drain_samples(&mut self) {
        let Mode::Guiding { stream, .. } = &mut self.mode else {
            return self.drop_samples();
        };
        while let Ok(sample) = self.links.samples.pop() {
            stream.offer(sample.at_us, sample.joints, Source::Egm);
        }
    }

    fn drop_samples(&mut self) {
        while self.links.samples.pop().is_ok() {}
    }
}

/// Passes on where the hand shall lead the arm. What it does then is seen when it is asked for:
/// so many commands come that each must be short.
async fn lead_hand(client: rws::Client, command: HandCommand, reply: Reply<()>) {
    let done = match command {
        HandCommand::Lead(joints) => client.lead_virtual_hand(&joints.0).await,
        _ => client.release_virtual_hand().await,
    };
    // Who asked may have gone away meanwhile.
    let _ = reply.send(done.map_err(RobotError::from));
}
