//! What a recording can be told on its way besides to end: to be held up, and to go on.

use tokio::sync::oneshot;

use super::{Guiding, Recorder, RecordingError};
use crate::ids::DemonstrationId;
use crate::store::demonstrations::{Demonstration, DemonstrationSource};
use crate::uninterrupted::uninterrupted;

/// What a recording is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// To be held up where the arm is.
    Pause,
    /// To go on from there.
    Resume,
}

/// An order on its way to the recording, with where its answer goes.
pub(super) struct Ordered {
    pub(super) order: Order,
    pub(super) reply: oneshot::Sender<Result<Demonstration, RecordingError>>,
}

impl Recorder {
    /// Tells an open recording to be held up or to go on. The same again changes nothing.
    ///
    /// # Errors
    /// When it is not open, the virtual hand makes it, or the arm is not where it was held up.
    pub async fn order(
        &self,
        id: DemonstrationId,
        order: Order,
    ) -> Result<Demonstration, RecordingError> {
        let recorder = self.clone();
        uninterrupted(async move { recorder.pass_on(id, order).await }).await
    }

    async fn pass_on(
        &self,
        id: DemonstrationId,
        order: Order,
    ) -> Result<Demonstration, RecordingError> {
        let demonstration = self.0.tools.store.demonstration(id).await?;
        let guiding = self.0.guiding.lock().await;
        let Guiding::Recording {
            id: open, orders, ..
        } = &*guiding
        else {
            return Err(RecordingError::NotOpen);
        };
        if *open != id || orders.is_closed() {
            return Err(RecordingError::NotOpen);
        }
        if demonstration.source == DemonstrationSource::VirtualHand {
            return Err(RecordingError::HandGoesOn);
        }
        let (reply, answer) = oneshot::channel();
        // A recording that is ending takes no orders any more.
        let sent = orders.send(Ordered { order, reply }).await;
        match (sent, answer.await) {
            (Ok(()), Ok(answer)) => answer,
            _ => Err(RecordingError::NotOpen),
        }
    }
}
