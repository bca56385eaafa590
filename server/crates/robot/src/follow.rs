//! Hears of the signals as they change, so that a short press of a button at the arm is not missed.
//!
//! Polling goes on beside it (`poll`): a controller without subscriptions only costs promptness.

use crate::poll::{News, Observation};
use rws::{Change, Client, Topic};
use std::time::{Duration, Instant};
use tokio::sync::mpsc;

/// Wait before the next trial, when the controller does not accept a subscription.
const RETRY: Duration = Duration::from_secs(2);

/// Passes on changes of `signals` until the supervisor is gone.
pub(crate) async fn follow(
    client: Client,
    signals: Vec<String>,
    observations: mpsc::Sender<Observation>,
) {
    let topics: Vec<Topic> = signals.into_iter().map(Topic::Signal).collect();
    while !topics.is_empty() {
        match client.subscribe(&topics).await {
            Ok(mut changes) => {
                while let Some(change) = changes.next().await {
                    let Change::Signal { name, value } = change else {
                        continue;
                    };
                    let news = News::Signal {
                        name,
                        value: Some(value != 0.0),
                    };
                    let asked = Instant::now();
                    if observations
                        .send(Observation { asked, news })
                        .await
                        .is_err()
                    {
                        return;
                    }
                }
            }
            Err(error) => tracing::debug!(%error, "the signals cannot be subscribed to"),
        }
        tokio::time::sleep(RETRY).await;
    }
}
