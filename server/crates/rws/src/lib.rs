//! A small client for Robot Web Services 2.0, the HTTP interface of ABB's OmniCore controllers.
//!
//! What lives here: one authenticated session with one controller, and the few resources that
//! hand guiding and guided motion need (panel, RAPID execution, mastership, joint target,
//! lead-through, signals, event log), the subscriptions to them, and the certificate of HTTPS.
//! What does not: decisions about when the arm may move; those belong to the supervisor.
//!
//! All angles are degrees, as on the controller's wire.
//! [`virtual_hand`] is the one exception to "ABB's interface": it exists only on the virtual
//! controller.

mod client;
mod elog;
mod elog_words;
mod error;
mod fingerprint;
mod hal;
mod lead_through;
mod mastership;
mod motion_system;
mod panel;
mod program;
mod rapid;
mod session;
mod signals;
mod subscription;
mod system;
mod tls;
pub mod virtual_hand;
mod xhtml;

pub use client::{Client, Config};
pub use elog::{EventMessage, EventType, SAFETY_DOMAIN};
pub use elog_words::{Explanation, explain};
pub use error::RwsError;
pub use fingerprint::{Fingerprint, NotAFingerprint};
pub use panel::{ControllerState, OperatingMode};
pub use program::{Module, Task};
pub use rapid::{Cycle, Execution};
pub use signals::Signal;
pub use subscription::{Change, Subscription, Topic};
pub use system::System;
pub use tls::read_fingerprint;
