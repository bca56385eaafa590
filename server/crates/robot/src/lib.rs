//! The robot side of the server: the real-time EGM thread, the supervisor, the player.
//!
//! What lives here: everything that makes the arm move or stand.
//! What does not: HTTP, the database and planning. This crate depends on none of them, so that
//! the control loop cannot wait for them.
//!
//! ```text
//! Robot (handle) --requests--> supervisor (task) --rings--> control thread "egm" --UDP--> arm
//!        |                          |  ^                            ^
//!        |                          |  +-- poll (web services)      |
//!        +-------- stop: one atomic --------------------------------+
//! ```

mod config;
mod control_loop;
mod control_thread;
mod ending;
mod error;
mod flight;
mod follow;
mod guidance;
mod handle;
mod links;
mod player;
mod poll;
mod procedures;
mod rate_limit;
mod run;
mod signals;
mod supervisor;
#[cfg(test)]
mod testing;
mod view;

pub use config::{RobotConfig, RobotKind};
pub use error::{Fault, RobotError};
pub use flight::{FlightChunk, FlightEvent};
pub use guidance::{GuidanceEvent, GuidanceSample, HandActivity, HandCommand, HandScript};
pub use handle::{HOLD, Robot};
pub use player::{RunPhase, SLOWEST};
pub use run::{CycleRecord, RunEnd, RunHandle, RunOutcome, RunProgress};
pub use signals::{SignalConfig, SignalSet, SignalView};
pub use view::{EgmView, RobotState, RobotView};
