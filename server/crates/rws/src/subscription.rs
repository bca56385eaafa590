//! Changes as the controller reports them, instead of asking again and again.
//!
//! What lives here: which resources are subscribed to and what their events mean. Keeping the
//! connection is in [`link`]. Polling remains the way that always works: an event may be late or
//! lost, and the arm's position cannot be subscribed to at all.

mod link;

use crate::hal::{Entries, Entry};
use crate::signals::path_of;
use crate::{Client, ControllerState, Execution, OperatingMode, RwsError};
use tokio::sync::mpsc;
use tokio::task::JoinHandle;

/// So many changes may wait to be read.
const WAITING: usize = 64;

/// Something to be told about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Topic {
    /// Motors and stops.
    ControllerState,
    /// The mode switch.
    OperatingMode,
    /// The speed override.
    SpeedRatio,
    /// Whether the robot program runs.
    Execution,
    /// A signal.
    Signal(String),
    /// New entries of a log domain.
    Events(u32),
}

impl Topic {
    /// The resource, and how fast its changes are to be reported.
    fn resource(&self) -> Result<(String, &'static str), RwsError> {
        const MEDIUM: &str = "1";
        // Only signals and persistent variables may have it.
        const HIGH: &str = "2";
        Ok(match self {
            Self::ControllerState => ("/rw/panel/ctrl-state;ctrlstate".to_owned(), MEDIUM),
            Self::OperatingMode => ("/rw/panel/opmode;opmode".to_owned(), MEDIUM),
            Self::SpeedRatio => ("/rw/panel/speedratio;speedratio".to_owned(), MEDIUM),
            Self::Execution => ("/rw/rapid/execution;ctrlexecstate".to_owned(), MEDIUM),
            Self::Signal(name) => (format!("{};state", path_of(name)?), HIGH),
            Self::Events(domain) => (format!("/rw/elog/{domain}"), MEDIUM),
        })
    }
}

/// What was reported.
#[derive(Debug, Clone, PartialEq)]
pub enum Change {
    /// Motors and stops.
    ControllerState(ControllerState),
    /// The mode switch.
    OperatingMode(OperatingMode),
    /// The speed override in percent.
    SpeedRatio(f64),
    /// Whether the robot program runs.
    Execution(Execution),
    /// The value of a signal.
    Signal {
        /// Its name, without network and device.
        name: String,
        /// Logical value.
        value: f64,
    },
    /// The log has a new entry; [`Client::events`] reads it.
    Event {
        /// Log domain.
        domain: u32,
        /// The controller's number of the entry.
        number: u64,
    },
    /// The connection broke and is being made anew. What changed meanwhile is reported as soon as
    /// it stands again, because the controller begins with the present values.
    Lost {
        /// Why.
        reason: String,
    },
}

impl Change {
    /// Reads one event; nothing for those that nobody here asked for or that are not readable.
    fn of(entry: &Entry<'_>) -> Option<Self> {
        let address = entry.optional_text("_href");
        let address = if address.is_empty() {
            entry.optional_text("_title")
        } else {
            address
        };
        match entry.optional_text("_type").as_str() {
            "pnl-ctrlstate-ev" => {
                let word = entry.text("ctrlstate").ok()?;
                Some(Self::ControllerState(ControllerState::from_wire(&word)))
            }
            "pnl-opmode-ev" => {
                let word = entry.text("opmode").ok()?;
                Some(Self::OperatingMode(OperatingMode::from_wire(&word)))
            }
            "pnl-speedratio-ev" => Some(Self::SpeedRatio(entry.number("speedratio").ok()?)),
            "rap-ctrlexecstate-ev" => {
                let word = entry.text("ctrlexecstate").ok()?;
                Some(Self::Execution(Execution::from_wire(&word)))
            }
            "ios-signalstate-ev" => {
                let resource = address.split(';').next().unwrap_or_default();
                Some(Self::Signal {
                    name: resource.rsplit('/').next().unwrap_or_default().to_owned(),
                    value: entry.number("lvalue").ok()?,
                })
            }
            "elog-message-ev" => {
                // `/rw/elog/DOMAIN`, in some answers with the number of the entry behind it.
                let domain = address.split("/elog/").nth(1)?.split('/').next()?;
                Some(Self::Event {
                    domain: domain.parse().ok()?,
                    number: entry.text("seqnum").ok()?.parse().ok()?,
                })
            }
            _ => None,
        }
    }

    fn all_of(text: &str) -> Vec<Self> {
        let entries = Entries::parse("/subscription", text);
        entries
            .iter()
            .flat_map(|entries| entries.all())
            .filter_map(|entry| Self::of(&entry))
            .collect()
    }
}

/// A stream of changes. Dropping it ends it; [`Subscription::end`] also tells the controller.
#[derive(Debug)]
pub struct Subscription {
    changes: mpsc::Receiver<Change>,
    end: Option<tokio::sync::oneshot::Sender<()>>,
    task: JoinHandle<()>,
}

impl Client {
    /// Subscribes to `topics`, at first with what holds now. When the connection breaks it is made
    /// again until the subscription is dropped.
    ///
    /// # Errors
    /// As for every call, when the controller does not accept the first subscription;
    /// [`RwsError::Missing`] for a signal that cannot exist.
    pub async fn subscribe(&self, topics: &[Topic]) -> Result<Subscription, RwsError> {
        let resources = topics
            .iter()
            .map(Topic::resource)
            .collect::<Result<Vec<_>, _>>()?;
        let link = link::open(self, &resources).await?;
        let (sender, changes) = mpsc::channel(WAITING);
        let (end, ended) = tokio::sync::oneshot::channel();
        let task = tokio::spawn(link::keep(self.clone(), resources, link, sender, ended));
        Ok(Subscription {
            changes,
            end: Some(end),
            task,
        })
    }
}

impl Subscription {
    /// The next change; waits for it.
    pub async fn next(&mut self) -> Option<Change> {
        self.changes.recv().await
    }

    /// Ends it at the controller too, which has only so many.
    pub async fn end(mut self) {
        if let Some(end) = self.end.take() {
            // An error means that it has ended already.
            let _ = end.send(());
            let _ = (&mut self.task).await;
        }
    }
}

impl Drop for Subscription {
    fn drop(&mut self) {
        self.task.abort();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn events_are_read_with_their_resource_and_anything_else_is_passed_over() {
        let text = r#"<?xml version="1.0"?><html><body><div class="state"><ul>
            <li class="pnl-ctrlstate-ev" title=""><a href="/rw/panel/ctrl-state" rel="self"/><span class="ctrlstate">guardstop</span></li>
            <li class="ios-signalstate-ev" title=""><a href="/rw/iosystem/signals/IntBus/Asi/Asi1Button1;state" rel="self"/><span class="lvalue">1</span></li>
            <li class="ios-signalstate-ev" title=""><a href="/rw/iosystem/signals/x;state" rel="self"/><span class="lvalue">on</span></li>
            <li class="elog-message-ev" title=""><a href="/rw/elog/9/4711" rel="self"/><span class="seqnum">4711</span></li>
            <li class="something-ev" title=""></li></ul></div></body></html>"#;
        let changes = Change::all_of(text);
        assert_eq!(
            changes,
            [
                Change::ControllerState(ControllerState::GuardStop),
                Change::Signal {
                    name: "Asi1Button1".to_owned(),
                    value: 1.0
                },
                Change::Event {
                    domain: 9,
                    number: 4711
                },
            ]
        );
    }
}
