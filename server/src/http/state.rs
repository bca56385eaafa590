//! What every handler can reach.

use std::net::SocketAddr;
use std::sync::Arc;

use crate::agreement::Agreements;
use crate::arms::{Arm, Arms, StartedRobot};
use crate::certificates::Certificates;
use crate::clock::SharedClock;
use crate::control::Control;
use crate::dragging::DragSeat;
use crate::events::Events;
use crate::jobs::Queue;
use crate::pairing::Gatekeeper;
use crate::plans::Plans;
use crate::recording::Recorder;
use crate::reproducing::Reproducer;
use crate::shutdown::Shutdown;
use crate::store::Store;

/// The parts of the server. Cheap to clone.
#[derive(Clone)]
pub struct AppState {
    /// The database.
    pub store: Store,
    /// Where changes are told.
    pub events: Events,
    /// The time.
    pub clock: SharedClock,
    /// The robots.
    pub arms: Arms,
    /// Background work.
    pub queue: Queue,
    /// Which takes were compared lately.
    pub agreements: Arc<Agreements>,
    /// Previewed motions.
    pub plans: Arc<Plans>,
    /// Checks pairing codes; nothing when only this computer can reach the server.
    pub gatekeeper: Option<Arc<Gatekeeper>>,
    /// This cell's certificates; nothing when there is plain HTTP only.
    pub certificates: Option<Arc<Certificates>>,
    /// Where the server is found by a phone; nothing when only this computer can reach it.
    pub found_at: Option<SocketAddr>,
    /// Raised when the server stops.
    pub shutdown: Shutdown,
}

impl AppState {
    /// Puts the parts together around a store and the robots.
    pub fn new(
        store: Store,
        clock: SharedClock,
        robots: Vec<StartedRobot>,
        gatekeeper: Option<Arc<Gatekeeper>>,
    ) -> Self {
        let events = Events::default();
        let plans = Arc::new(Plans::default());
        let parts = || (store.clone(), events.clone(), Arc::clone(&clock));
        let (s, e, c) = parts();
        let queue = Queue::new(s, e, c);
        let arm = |started: StartedRobot| {
            let StartedRobot {
                id,
                name,
                limits,
                continuous_run,
                robot,
            } = started;
            let (s, e, c) = parts();
            let recorder = Recorder::new(s, e, c, &id, robot.clone());
            let (s, e, c) = parts();
            let reproducer = Reproducer::new(s, e, c, &id, robot.clone(), Arc::clone(&plans));
            Arm {
                id,
                name,
                limits,
                continuous_run,
                robot,
                control: Control::default(),
                drag: DragSeat::default(),
                recorder,
                reproducer,
            }
        };
        let arms = Arms::new(robots.into_iter().map(arm).collect());
        Self {
            store,
            events,
            clock,
            arms,
            queue,
            agreements: Arc::default(),
            plans,
            gatekeeper,
            certificates: None,
            found_at: None,
            shutdown: Shutdown::default(),
        }
    }

    /// Writes down who did what. A trail that can't be written does not stop the work.
    pub async fn audit(&self, actor: &str, action: &str, subject: impl std::fmt::Display) {
        let now = self.clock.now();
        let subject = subject.to_string();
        if let Err(error) = self.store.audit(actor, action, &subject, now).await {
            tracing::error!(actor, action, subject, %error, "an audit event could not be stored");
        }
    }
}
