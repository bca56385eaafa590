//! `/subscription` and the WebSocket that reports changes.

use std::collections::HashMap;

use axum::Extension;
use axum::extract::ws::{CloseFrame, Message, WebSocket, WebSocketUpgrade, close_code};
use axum::extract::{Path, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use tokio::sync::{broadcast, watch};

use super::negotiation::{Fields, Format};
use super::reply::{self, Item, Problem, escape};
use super::sessions::SessionId;
use super::{App, rapid};
use crate::controller::{Change, Controller};

const PROTOCOL: &str = "rws_subscription";

/// What is reported when a resource changes: its class, and its fields.
struct Report {
    resource: String,
    item: Item,
}

/// The subscriptions of all clients.
#[derive(Default)]
pub struct Subscriptions {
    last: u64,
    open: HashMap<u64, Subscription>,
}

struct Subscription {
    session: SessionId,
    resources: Vec<String>,
    /// What has changed since; taken by the WebSocket.
    changes: Option<broadcast::Receiver<Change>>,
    /// Dropped with the subscription, which the WebSocket sees.
    _alive: watch::Sender<()>,
    alive: watch::Receiver<()>,
}

impl Subscriptions {
    /// Ends all subscriptions of a session.
    pub fn end_of_session(&mut self, session: &SessionId) {
        self.open.retain(|_, open| open.session != *session);
    }
}

pub async fn subscribe(
    State(app): State<App>,
    Extension(session): Extension<SessionId>,
    format: Format,
    fields: Fields,
) -> Result<Response, Problem> {
    let resources = requested(&fields)?;
    // Changes are collected before the present values are read, so that none falls between.
    let (changes, first) = {
        let controller = app.controller();
        let changes = controller.subscribe();
        let first: Vec<Item> = resources
            .iter()
            .map(|resource| {
                present(&controller, resource).ok_or_else(|| {
                    Problem::bad_request(format!("invalid subscription URI {resource}"))
                })
            })
            .collect::<Result<Vec<_>, _>>()?
            .into_iter()
            .flatten()
            .collect();
        (changes, first)
    };
    let (sender, alive) = watch::channel(());
    let id = {
        let mut subscriptions = app.subscriptions();
        subscriptions.last += 1;
        let id = subscriptions.last;
        let subscription = Subscription {
            session,
            resources,
            changes: Some(changes),
            _alive: sender,
            alive,
        };
        subscriptions.open.insert(id, subscription);
        id
    };
    let mut response = reply::list(format, &first);
    *response.status_mut() = StatusCode::CREATED;
    let location = format!("{}/poll/{id}", app.web_sockets);
    Ok(([(header::LOCATION, location)], response).into_response())
}

pub async fn unsubscribe(
    State(app): State<App>,
    Extension(session): Extension<SessionId>,
    Path(id): Path<u64>,
) -> Result<StatusCode, Problem> {
    let mut subscriptions = app.subscriptions();
    if subscriptions
        .open
        .get(&id)
        .is_none_or(|open| open.session != session)
    {
        return Err(Problem::missing("no such subscription"));
    }
    subscriptions.open.remove(&id);
    Ok(StatusCode::OK)
}

pub async fn poll(
    State(app): State<App>,
    Extension(session): Extension<SessionId>,
    Path(id): Path<u64>,
    headers: HeaderMap,
    upgrade: WebSocketUpgrade,
) -> Result<Response, Problem> {
    let offered = headers
        .get_all(header::SEC_WEBSOCKET_PROTOCOL)
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|value| value.split(','))
        .any(|protocol| protocol.trim() == PROTOCOL);
    if !offered {
        return Err(Problem::bad_request(
            "the WebSocket needs the protocol rws_subscription",
        ));
    }
    let (resources, changes, alive) = {
        let mut subscriptions = app.subscriptions();
        let open = subscriptions
            .open
            .get_mut(&id)
            .filter(|open| open.session == session)
            .ok_or_else(|| Problem::missing("no such subscription"))?;
        let changes = open
            .changes
            .take()
            .ok_or_else(|| Problem::bad_request("the subscription is already being read"))?;
        (open.resources.clone(), changes, open.alive.clone())
    };
    let ends = app.ends.clone();
    Ok(upgrade
        .protocols([PROTOCOL])
        .on_upgrade(move |socket| async move {
            send_changes(socket, &resources, changes, alive, ends).await;
            app.subscriptions().open.remove(&id);
        }))
}

/// Reports changes until either side ends.
async fn send_changes(
    mut socket: WebSocket,
    resources: &[String],
    mut changes: broadcast::Receiver<Change>,
    mut alive: watch::Receiver<()>,
    mut ends: watch::Receiver<bool>,
) {
    loop {
        let message = tokio::select! {
            change = changes.recv() => match change {
                Ok(change) => {
                    let report = report(&change);
                    if !resources.contains(&report.resource) {
                        continue;
                    }
                    Message::text(document(&report))
                }
                Err(broadcast::error::RecvError::Lagged(_)) => continue,
                Err(broadcast::error::RecvError::Closed) => Message::Close(None),
            },
            incoming = socket.recv() => match incoming {
                Some(Ok(Message::Ping(_) | Message::Pong(_))) => continue,
                Some(Ok(Message::Text(_) | Message::Binary(_))) => Message::Close(Some(CloseFrame {
                    code: close_code::POLICY,
                    reason: "Client cannot send data".into(),
                })),
                Some(Ok(Message::Close(_)) | Err(_)) | None => return,
            },
            _ = alive.changed() => Message::Close(None),
            _ = ends.changed() => Message::Close(None),
        };
        let last = matches!(message, Message::Close(_));
        if socket.send(message).await.is_err() || last {
            return;
        }
    }
}

/// The resources a form asks for: `resources=N&1=path&1-p=priority…`, or `resources=k` for each.
fn requested(fields: &Fields) -> Result<Vec<String>, Problem> {
    fields.require("resources")?;
    let numbers: Vec<u32> = fields
        .all("resources")
        .filter_map(|text| text.parse().ok())
        .collect();
    let names: Vec<u32> = match numbers[..] {
        [count] if count <= 1000 => (1..=count).collect(),
        _ => numbers,
    };
    let resources: Vec<String> = names
        .iter()
        .filter_map(|name| fields.get(&name.to_string()))
        .map(str::to_owned)
        .collect();
    if resources.is_empty() || resources.len() != names.len() {
        return Err(Problem::bad_request(
            "the resources do not match their number",
        ));
    }
    Ok(resources)
}

/// The present value of a resource, nothing when it can not be subscribed to; a log has none.
fn present(controller: &Controller, resource: &str) -> Option<Option<Item>> {
    let change = match resource {
        "/rw/panel/ctrl-state;ctrlstate" => Change::State(controller.state()),
        "/rw/panel/opmode;opmode" => Change::Mode(controller.mode()),
        "/rw/panel/speedratio;speedratio" => Change::SpeedRatio(controller.speed_ratio()),
        "/rw/rapid/execution;ctrlexecstate" => Change::Running(controller.program().is_running()),
        other => {
            if let Some(domain) = other.strip_prefix("/rw/elog/") {
                return domain.parse::<u32>().ok().map(|_| None);
            }
            let path = other
                .strip_prefix("/rw/iosystem/signals/")?
                .strip_suffix(";state")?;
            let signal = controller.signals().find(path)?;
            Change::Signal {
                name: signal.name.to_owned(),
                on: signal.on,
            }
        }
    };
    Some(Some(report(&change).item))
}

fn report(change: &Change) -> Report {
    let (resource, kind, field, value) = match change {
        Change::State(state) => (
            "/rw/panel/ctrl-state;ctrlstate".to_owned(),
            "pnl-ctrlstate-ev",
            "ctrlstate",
            state.word().to_owned(),
        ),
        Change::Mode(mode) => (
            "/rw/panel/opmode;opmode".to_owned(),
            "pnl-opmode-ev",
            "opmode",
            mode.word().to_owned(),
        ),
        Change::SpeedRatio(percent) => (
            "/rw/panel/speedratio;speedratio".to_owned(),
            "pnl-speedratio-ev",
            "speedratio",
            percent.to_string(),
        ),
        Change::Running(running) => (
            "/rw/rapid/execution;ctrlexecstate".to_owned(),
            "rap-ctrlexecstate-ev",
            "ctrlexecstate",
            rapid::execution_word(*running).to_owned(),
        ),
        Change::Signal { name, on } => (
            format!("/rw/iosystem/signals/{name};state"),
            "ios-signalstate-ev",
            "lvalue",
            u8::from(*on).to_string(),
        ),
        Change::Event { domain, number } => (
            format!("/rw/elog/{domain}"),
            "elog-message-ev",
            "seqnum",
            number.to_string(),
        ),
    };
    let title = resource.split(';').next().unwrap_or_default().to_owned();
    Report {
        resource,
        item: Item::new(kind, title).with(field, value),
    }
}

/// An event as the WebSocket carries it.
fn document(report: &Report) -> String {
    let item = &report.item;
    let fields: String = item
        .fields
        .iter()
        .map(|(name, value)| format!("<span class=\"{name}\">{}</span>", escape(value)))
        .collect();
    reply::document(&format!(
        "<div class=\"state\"><ul><li class=\"{}\" title=\"\"><a href=\"{}\" rel=\"self\"/>{fields}</li></ul></div>",
        item.kind,
        escape(&item.title),
    ))
}
