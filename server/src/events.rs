//! What changed, told to everybody who watches the live socket.

use serde::Serialize;
use tokio::sync::broadcast;

use crate::store::demonstrations::Demonstration;
use crate::store::jobs::Job;
use crate::store::models::Model;
use crate::store::reproductions::Reproduction;

/// One change: the thing as it is now.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Event {
    /// A demonstration changed.
    Demonstration {
        /// As it is now.
        demonstration: Demonstration,
    },
    /// A job changed.
    Job {
        /// As it is now.
        job: Job,
    },
    /// A model changed.
    Model {
        /// As it is now.
        model: Model,
    },
    /// A reproduction changed.
    Reproduction {
        /// As it is now.
        reproduction: Reproduction,
    },
}

impl From<&Demonstration> for Event {
    fn from(demonstration: &Demonstration) -> Self {
        Self::Demonstration {
            demonstration: demonstration.clone(),
        }
    }
}

impl From<&Job> for Event {
    fn from(job: &Job) -> Self {
        Self::Job { job: job.clone() }
    }
}

impl From<&Model> for Event {
    fn from(model: &Model) -> Self {
        Self::Model {
            model: model.clone(),
        }
    }
}

impl From<&Reproduction> for Event {
    fn from(reproduction: &Reproduction) -> Self {
        Self::Reproduction {
            reproduction: reproduction.clone(),
        }
    }
}

/// Where changes are told. Cheap to clone.
#[derive(Clone)]
pub struct Events(broadcast::Sender<Event>);

impl Default for Events {
    fn default() -> Self {
        // A watcher that falls further behind than this gets the whole picture anew.
        Self(broadcast::channel(128).0)
    }
}

impl Events {
    /// Tells a change. It never waits, and nobody needs to listen.
    pub fn tell(&self, event: impl Into<Event>) {
        let _ = self.0.send(event.into());
    }

    /// Listens from now on.
    pub fn listen(&self) -> broadcast::Receiver<Event> {
        self.0.subscribe()
    }
}
