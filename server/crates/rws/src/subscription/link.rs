//! The WebSocket of a subscription: opening it, noticing that it is dead, opening it again.
//!
//! The controller closes a connection on which its client sends anything, so nothing is ever sent
//! (a ping is answered, as the protocol demands). Its silence says nothing either: whether it is
//! still there is asked over HTTP.

use super::Change;
use crate::{Client, RwsError};
use futures_util::StreamExt;
use reqwest::Url;
use reqwest::header::HeaderValue;
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::sync::{mpsc, oneshot};
use tokio::time::{MissedTickBehavior, interval};
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::tungstenite::{Error, Message};
use tokio_tungstenite::{WebSocketStream, client_async};

const PROTOCOL: &str = "rws_subscription";
/// How often to ask whether the controller and the session are still there; a session that does
/// not ask for five minutes is gone.
const ALIVE: Duration = Duration::from_secs(10);
/// Pause before the connection is made again, doubled each time up to the longest.
const AGAIN: Duration = Duration::from_millis(250);
const LONGEST: Duration = Duration::from_secs(8);

/// Either kind of connection.
trait Connection: AsyncRead + AsyncWrite + Send + Unpin {}
impl<T: AsyncRead + AsyncWrite + Send + Unpin> Connection for T {}

/// An open subscription.
pub(super) struct Link {
    socket: WebSocketStream<Box<dyn Connection>>,
    /// `/subscription/ID`
    path: String,
    session: Option<String>,
    first: Vec<Change>,
}

/// Subscribes and opens the WebSocket.
pub(super) async fn open(
    client: &Client,
    resources: &[(String, &'static str)],
) -> Result<Link, RwsError> {
    let mut form = vec![("resources".to_owned(), resources.len().to_string())];
    for (place, (path, priority)) in resources.iter().enumerate() {
        let number = place + 1;
        form.push((number.to_string(), path.clone()));
        form.push((format!("{number}-p"), (*priority).to_owned()));
    }
    let fields: Vec<(&str, &str)> = form
        .iter()
        .map(|(name, value)| (name.as_str(), value.as_str()))
        .collect();
    let answer = client.create("/subscription", &fields).await?;
    let unreadable = |reason: &str| RwsError::Unreadable {
        path: "/subscription".to_owned(),
        reason: reason.to_owned(),
    };
    let location = answer
        .location
        .ok_or_else(|| unreadable("it does not say where the changes are reported"))?;
    let location = client
        .base()
        .join(&location)
        .map_err(|error| unreadable(&error.to_string()))?;
    let id = location
        .path_segments()
        .and_then(|mut parts| parts.next_back().map(str::to_owned))
        .unwrap_or_default();
    let first = Change::all_of(&answer.text);
    let path = format!("/subscription/{id}");
    match connect(client, location.path()).await {
        Ok(socket) => Ok(Link {
            socket,
            path,
            session: client.session_id(),
            first,
        }),
        Err(error) => {
            // The controller has only so many; the first error is the one to report.
            let _ = client.delete(&path).await;
            Err(error)
        }
    }
}

/// Opens the WebSocket at `path`. The host in the controller's answer is its own idea of its
/// address, which behind a router is not ours; so the configured one is used.
async fn connect(
    client: &Client,
    path: &str,
) -> Result<WebSocketStream<Box<dyn Connection>>, RwsError> {
    let unreachable = |reason: String| RwsError::Unreachable {
        url: client.base().to_string(),
        reason,
    };
    let opening = async {
        let base = client.base();
        let stream = crate::tls::connect(base)
            .await
            .map_err(|error| unreachable(error.to_string()))?;
        let stream: Box<dyn Connection> = if base.scheme() == "https" {
            let secured = client.tls().secure(stream, base).await;
            Box::new(secured.map_err(|error| {
                let refusal = client.tls().refusal(base.as_str());
                refusal.unwrap_or_else(|| unreachable(error.to_string()))
            })?)
        } else {
            Box::new(stream)
        };
        let request = request(base, path, client.session_cookies())
            .map_err(|error| unreachable(error.to_string()))?;
        let (socket, _) = client_async(request, stream)
            .await
            .map_err(|error| unreachable(error.to_string()))?;
        Ok(socket)
    };
    tokio::time::timeout(client.timeout(), opening)
        .await
        .unwrap_or_else(|_| Err(unreachable("no answer in time".to_owned())))
}

fn request(
    base: &Url,
    path: &str,
    cookies: Option<HeaderValue>,
) -> Result<tokio_tungstenite::tungstenite::handshake::client::Request, Error> {
    let scheme = if base.scheme() == "https" {
        "wss"
    } else {
        "ws"
    };
    let host = base.host_str().unwrap_or_default();
    let port = base.port_or_known_default().unwrap_or_default();
    let mut request = format!("{scheme}://{host}:{port}{path}").into_client_request()?;
    let headers = request.headers_mut();
    headers.insert("sec-websocket-protocol", HeaderValue::from_static(PROTOCOL));
    if let Some(cookies) = cookies {
        headers.insert("cookie", cookies);
    }
    Ok(request)
}

/// Passes changes on until nobody wants them any more, and keeps the connection.
pub(super) async fn keep(
    client: Client,
    resources: Vec<(String, &'static str)>,
    first: Link,
    changes: mpsc::Sender<Change>,
    mut ended: oneshot::Receiver<()>,
) {
    let mut link = first;
    loop {
        let path = link.path.clone();
        let reason = tokio::select! {
            reason = pass_on(&client, link, &changes) => reason,
            _ = &mut ended => {
                let _ = client.delete(&path).await;
                return;
            }
        };
        let Some(reason) = reason else {
            return;
        };
        tracing::debug!(%reason, "a subscription broke");
        if changes.send(Change::Lost { reason }).await.is_err() {
            return;
        }
        // It may be there still when only the connection broke.
        let _ = client.delete(&path).await;
        let mut pause = AGAIN;
        link = loop {
            tokio::select! {
                () = tokio::time::sleep(pause) => {}
                _ = &mut ended => return,
            }
            match open(&client, &resources).await {
                Ok(link) => break link,
                Err(error) => {
                    tracing::debug!(%error, "the subscription is not accepted yet");
                    pause = (pause * 2).min(LONGEST);
                }
            }
        };
    }
}

/// Passes changes on until the connection breaks, and says why; nothing when nobody listens.
async fn pass_on(client: &Client, link: Link, changes: &mpsc::Sender<Change>) -> Option<String> {
    let Link {
        mut socket,
        session,
        first,
        ..
    } = link;
    for change in first {
        changes.send(change).await.ok()?;
    }
    let mut alive = interval(ALIVE);
    alive.set_missed_tick_behavior(MissedTickBehavior::Delay);
    loop {
        tokio::select! {
            message = socket.next() => match message {
                Some(Ok(Message::Text(text))) => {
                    for change in Change::all_of(&text) {
                        changes.send(change).await.ok()?;
                    }
                }
                Some(Ok(Message::Close(frame))) => {
                    let words = frame.map_or_else(String::new, |frame| format!(": {}", frame.reason));
                    return Some(format!("the controller closed the connection{words}"));
                }
                Some(Ok(_)) => {}
                Some(Err(error)) => return Some(error.to_string()),
                None => return Some("the connection ended".to_owned()),
            },
            _ = alive.tick() => {
                if let Err(error) = client.controller_state().await {
                    return Some(error.to_string());
                }
                // A subscription belongs to its session; a new session knows nothing of it.
                if client.session_id() != session {
                    return Some("the session ended".to_owned());
                }
            }
            () = changes.closed() => return None,
        }
    }
}
