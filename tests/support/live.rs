//! The live socket, as a page sees it.

use futures_util::{SinkExt, StreamExt};
use serde_json::Value;
use tokio::net::TcpStream;
use tokio::time::{Instant, timeout_at};
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::{MaybeTlsStream, WebSocketStream, connect_async};

use super::SHORT;

/// An open connection to `/api/v1/live`.
pub struct Live(WebSocketStream<MaybeTlsStream<TcpStream>>);

impl Live {
    /// Connects.
    ///
    /// # Panics
    /// When the server refuses.
    pub async fn connect(base: &str) -> Self {
        Self::connect_with(base, "").await
    }

    /// Connects with a query, such as `?robot=left`.
    ///
    /// # Panics
    /// When the server refuses.
    pub async fn connect_with(base: &str, query: &str) -> Self {
        let url = format!("{}/api/v1/live{query}", base.replacen("http", "ws", 1));
        let (socket, _) = connect_async(&url)
            .await
            .unwrap_or_else(|error| panic!("{url}: {error}"));
        Self(socket)
    }

    /// The next message, or nothing when the connection has ended.
    ///
    /// # Panics
    /// When nothing comes for a long time, or something that is not JSON.
    pub async fn next(&mut self) -> Option<Value> {
        let deadline = Instant::now() + SHORT;
        loop {
            let message = timeout_at(deadline, self.0.next()).await;
            match message.expect("the live socket keeps talking")? {
                Ok(Message::Text(text)) => {
                    return Some(serde_json::from_str(&text).expect("live messages are JSON"));
                }
                Ok(Message::Close(_)) | Err(_) => return None,
                Ok(_) => {}
            }
        }
    }

    /// Reads on until a message of this type passes the test.
    ///
    /// # Panics
    /// When the connection ends before.
    pub async fn wait_for(&mut self, kind: &str, mut test: impl FnMut(&Value) -> bool) -> Value {
        loop {
            let message = self.next().await;
            let message =
                message.unwrap_or_else(|| panic!("the live socket ended before a {kind} message"));
            if message["type"] == kind && test(&message) {
                return message;
            }
        }
    }

    /// Sends a text.
    ///
    /// # Panics
    /// When the connection is gone.
    pub async fn send(&mut self, text: &str) {
        self.0
            .send(Message::text(text))
            .await
            .expect("the live socket takes a message");
    }
}
