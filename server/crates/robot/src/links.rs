//! What the control thread and the supervisor share: rings, one triple buffer, a few atomics.
//! Neither side can make the other wait.

use crate::control_loop::LoopState;
use crate::run::CycleRecord;
use motion::JointAngles;
use motion::plan::Plan;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};

const COMMANDS: usize = 8;
/// Sixteen seconds of cycles: far more than the supervisor can be late.
const CYCLES: usize = 4096;

/// An order to the control thread.
#[derive(Debug)]
pub(crate) enum Command {
    /// Play a plan, beginning now.
    Arm {
        /// Names the run in [`LoopState`].
        run: u64,
        /// [`Flags::stops`] when the run was asked for; a change stops it.
        stops: u64,
        /// What to play.
        plan: Arc<Plan>,
        /// It moves only while [`Flags::is_held`].
        held: bool,
    },
    /// Hold, and let no setpoint through until armed again.
    Disarm,
}

/// A measured pose that came over EGM.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FeedbackSample {
    /// Since the start of the program.
    pub at_us: u64,
    pub joints: JointAngles,
}

/// Switches that are read or written from anywhere.
#[derive(Debug, Default)]
pub(crate) struct Flags {
    stops: AtomicU64,
    quit: AtomicBool,
    streaming: AtomicBool,
    real_time: AtomicBool,
    paused: AtomicBool,
    /// Until when somebody holds the button of a run that moves only then, since the start of
    /// the program.
    held_until_us: AtomicU64,
    /// What is missing to full speed, so that the default is full speed, 1/1000.
    slower_by: AtomicU32,
}

impl Flags {
    /// How often a stop was asked for. Counting instead of a flag leaves nothing to reset, so
    /// that no stop can get lost between two runs.
    pub(crate) fn stops(&self) -> u64 {
        self.stops.load(Ordering::Acquire)
    }

    pub(crate) fn stop(&self) {
        self.stops.fetch_add(1, Ordering::AcqRel);
    }

    pub(crate) fn quits(&self) -> bool {
        self.quit.load(Ordering::Acquire)
    }

    pub(crate) fn quit(&self) {
        self.quit.store(true, Ordering::Release);
    }

    /// Whether the present run shall stand still until it is to go on.
    pub(crate) fn is_paused(&self) -> bool {
        self.paused.load(Ordering::Acquire)
    }

    pub(crate) fn set_paused(&self, paused: bool) {
        self.paused.store(paused, Ordering::Release);
    }

    /// Whether somebody holds the button at this instant, since the start of the program.
    pub(crate) fn is_held(&self, now_us: u64) -> bool {
        now_us <= self.held_until_us.load(Ordering::Acquire)
    }

    pub(crate) fn hold_until(&self, until_us: u64) {
        self.held_until_us.store(until_us, Ordering::Release);
    }

    pub(crate) fn let_go(&self) {
        self.hold_until(0);
    }

    /// Speed of the present run as a share of its plan's.
    pub(crate) fn speed(&self) -> f64 {
        f64::from(1000_u32.saturating_sub(self.slower_by.load(Ordering::Acquire))) / 1e3
    }

    /// `share` is 0 to 1.
    pub(crate) fn set_speed(&self, share: f64) {
        let slower_by = ((1.0 - share.clamp(0.0, 1.0)) * 1e3).round() as u32;
        self.slower_by.store(slower_by, Ordering::Release);
    }

    /// Whether measured poses are to be passed on one by one.
    pub(crate) fn streams(&self) -> bool {
        self.streaming.load(Ordering::Relaxed)
    }

    pub(crate) fn set_streaming(&self, on: bool) {
        self.streaming.store(on, Ordering::Relaxed);
    }

    pub(crate) fn is_real_time(&self) -> bool {
        self.real_time.load(Ordering::Relaxed)
    }

    pub(crate) fn set_real_time(&self, yes: bool) {
        self.real_time.store(yes, Ordering::Relaxed);
    }
}

/// The control thread's ends.
pub(crate) struct ThreadLinks {
    pub commands: rtrb::Consumer<Command>,
    pub records: rtrb::Producer<CycleRecord>,
    pub samples: rtrb::Producer<FeedbackSample>,
    /// Plans that are done with: freeing memory is not for the control thread.
    pub retired: rtrb::Producer<Arc<Plan>>,
    pub state: triple_buffer::Input<LoopState>,
    pub flags: Arc<Flags>,
}

/// The supervisor's ends.
pub(crate) struct SupervisorLinks {
    pub commands: rtrb::Producer<Command>,
    pub records: rtrb::Consumer<CycleRecord>,
    pub samples: rtrb::Consumer<FeedbackSample>,
    pub retired: rtrb::Consumer<Arc<Plan>>,
    pub state: triple_buffer::Output<LoopState>,
    pub flags: Arc<Flags>,
}

/// Both sides of every link.
pub(crate) fn links() -> (ThreadLinks, SupervisorLinks) {
    let (commands_in, commands) = rtrb::RingBuffer::new(COMMANDS);
    let (records, records_out) = rtrb::RingBuffer::new(CYCLES);
    let (samples, samples_out) = rtrb::RingBuffer::new(CYCLES);
    let (retired, retired_out) = rtrb::RingBuffer::new(COMMANDS);
    let (state, state_out) = triple_buffer::triple_buffer(&LoopState::default());
    let flags = Arc::new(Flags::default());
    let thread = ThreadLinks {
        commands,
        records,
        samples,
        retired,
        state,
        flags: Arc::clone(&flags),
    };
    let supervisor = SupervisorLinks {
        commands: commands_in,
        records: records_out,
        samples: samples_out,
        retired: retired_out,
        state: state_out,
        flags,
    };
    (thread, supervisor)
}
