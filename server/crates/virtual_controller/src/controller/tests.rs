//! Tests of the controller cycle by cycle, without sockets and without waiting: the bench.
//! The tests themselves are in the modules below.

use std::net::{Ipv4Addr, SocketAddr};

use egm::messages::MotorState;
use egm::{
    Correction, MAX_CORRECTION_BYTES, RobotFeedback, SequenceNumber, codec, encode_correction,
    read_feedback,
};
use motion::{JOINTS, JointVelocities};

mod guidance;
mod program;
mod session;

use super::*;
use crate::config::{EgmSettings, MessageSet, StopMode};
use crate::hand::Action;
use crate::hand::script::Script;

/// More cycles than anything in these tests takes.
const PATIENCE: usize = 20_000;

/// A controller and the EGM server it talks to.
struct Bench {
    controller: Controller,
    sent: u32,
}

impl Bench {
    fn new(egm: EgmSettings) -> Self {
        let mut config = Config::new(SocketAddr::from((Ipv4Addr::LOCALHOST, 6510)));
        config.egm = egm;
        Self {
            controller: Controller::new(config),
            sent: 0,
        }
    }

    /// Motors on and the program running.
    fn running(egm: EgmSettings) -> Self {
        let mut bench = Self::new(egm);
        bench.controller.set_motors(true).unwrap();
        bench.controller.start_program(None).unwrap();
        bench
    }

    /// One cycle in which `answer` is what the server says to the message.
    fn cycle(
        &mut self,
        answer: impl FnOnce(&RobotFeedback) -> Option<JointAngles>,
    ) -> Option<RobotFeedback> {
        let outgoing = self.controller.begin_cycle(WallTime::default());
        let mut datagram = Vec::new();
        let feedback = outgoing.map(|outgoing| {
            codec::encode_robot(&outgoing.message, &mut datagram).unwrap();
            read_feedback(&datagram).unwrap()
        });
        let mut buffer = [0; MAX_CORRECTION_BYTES];
        let reply = feedback.as_ref().and_then(answer).map(|joints| {
            let correction = Correction {
                sequence: SequenceNumber(self.sent),
                sent_at: ControllerTime(self.sent * 4),
                joints,
                velocities: JointVelocities::ZERO,
            };
            self.sent += 1;
            encode_correction(&correction, &mut buffer).unwrap()
        });
        self.controller
            .end_cycle(reply.map(|length| &buffer[..length]));
        feedback
    }

    fn silent_cycle(&mut self) -> Option<RobotFeedback> {
        self.cycle(|_| None)
    }

    /// One cycle in which the server wants the arm where it began.
    fn holding_cycle(&mut self) -> Option<RobotFeedback> {
        let home = self.controller.config().home;
        self.cycle(|_| Some(home))
    }

    /// Cycles until a message comes that fulfils `wanted`.
    fn message(
        &mut self,
        mut cycle: impl FnMut(&mut Self) -> Option<RobotFeedback>,
        wanted: impl Fn(&RobotFeedback) -> bool,
    ) -> RobotFeedback {
        for _ in 0..PATIENCE {
            if let Some(feedback) = cycle(self).filter(&wanted) {
                return feedback;
            }
        }
        panic!("the message waited for did not come");
    }

    /// Cycles until no message comes any more.
    fn until_silent(&mut self) {
        for _ in 0..PATIENCE {
            if self.silent_cycle().is_none() {
                return;
            }
        }
        panic!("the session does not end");
    }

    fn until_soft(&mut self) {
        self.controller.set_lead_through(true).unwrap();
        for _ in 0..PATIENCE {
            if self.controller.lead_through() == LeadThrough::Active {
                return;
            }
            self.silent_cycle();
        }
        panic!("lead-through does not become active");
    }

    fn has_event(&self, code: u32) -> bool {
        self.controller
            .events()
            .newest_first(0)
            .any(|event| event.code == code)
    }
}

fn beside_home(bench: &Bench, offset_deg: f64) -> JointAngles {
    JointAngles(
        bench
            .controller
            .config()
            .home
            .0
            .map(|angle| angle + offset_deg),
    )
}
