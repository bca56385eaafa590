//! A small client for Robot Web Services 2.0, the HTTP interface of ABB's OmniCore controllers.
//!
//! What lives here: one authenticated session with one controller, and the few resources that
//! hand guiding and guided motion need (panel, RAPID execution, mastership, joint target,
//! lead-through, signals, event log).
//! What does not: decisions about when the arm may move; those belong to the supervisor.
//!
//! All angles are degrees, as on the controller's wire.
//! [`virtual_hand`] is the one exception to "ABB's interface": it exists only on the virtual
//! controller.

mod client;
mod elog;
mod error;
mod fingerprint;
mod hal;
mod lead_through;
mod mastership;
mod motion_system;
mod panel;
mod rapid;
mod session;
mod signals;
mod system;
mod tls;
pub mod virtual_hand;

pub use client::{Client, Config};
pub use elog::{EventMessage, EventType, SAFETY_DOMAIN};
pub use error::RwsError;
pub use fingerprint::{Fingerprint, NotAFingerprint};
pub use panel::{ControllerState, OperatingMode};
pub use rapid::{Cycle, Execution};
pub use signals::Signal;
pub use system::System;
pub use tls::read_fingerprint;
