//! The live socket: the whole picture first, then every change, and one robot about 20 times a
//! second. A client may stop that robot through it.

use std::borrow::Cow;
use std::time::Duration;

use axum::extract::State;
use axum::extract::ws::rejection::WebSocketUpgradeRejection;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::response::Response;
use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt, StreamExt};
use motion::drag::Target;
use serde::{Deserialize, Serialize};
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::mpsc;
use tokio::time::{MissedTickBehavior, interval};
use utoipa::IntoParams;

use super::auth::Actor;
use super::control::phone;
use super::error::{ApiError, Problem};
use super::extract::Query;
use super::holds::Holds;
use super::robot::RobotAnswer;
use super::state::AppState;
use crate::arms::Arm;
use crate::control::Phone;
use crate::dragging::{DragError, Drags};
use crate::events::Event;
use crate::ids::ReproductionId;
use crate::store;
use crate::store::demonstrations::{Demonstration, DemonstrationState};
use crate::store::jobs::Job;
use crate::store::reproductions::Reproduction;

/// How often a client hears of the arm while it changes.
const ROBOT_EVERY: Duration = Duration::from_millis(50);
/// An arm that nothing is heard of is told again after this many of those, so that a client can
/// tell a silent arm from a lost connection.
const QUIET_TICKS: u32 = 20;
/// A client sends nothing longer than a short command.
const LONGEST_MESSAGE: usize = 4_096;

/// The whole picture.
#[derive(Serialize)]
#[serde(tag = "type", rename = "snapshot")]
struct Snapshot {
    robot: RobotAnswer,
    demonstration: Option<Demonstration>,
    jobs: Vec<Job>,
    reproduction: Option<Reproduction>,
}

/// The arm.
#[derive(Serialize)]
#[serde(tag = "type", rename = "robot")]
struct RobotNow {
    robot: RobotAnswer,
}

/// The arm cannot be dragged, or no longer.
#[derive(Serialize)]
#[serde(tag = "type", rename = "drag_refused")]
struct DragRefused {
    code: Cow<'static, str>,
    detail: String,
    advice: Cow<'static, str>,
}

/// Which robot a client watches.
#[derive(Deserialize, IntoParams)]
pub struct Watched {
    /// Its identifier; the first robot when it is missing.
    robot: Option<String>,
    /// The phone that watches, when it is one: its identifier ...
    phone: Option<String>,
    /// ... and what people call it.
    phone_name: Option<String>,
}

/// What a client may send.
#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
enum Command {
    Stop,
    Hold {
        reproduction: ReproductionId,
        press: u64,
    },
    LetGo,
    Drag {
        tool_mm: [f64; 3],
        #[serde(default)]
        turn_deg: [f64; 3],
    },
    DragEnd,
}

/// Who is at the other end of a socket.
struct Client {
    actor: String,
    phone: Option<Phone>,
}

/// Opens the live socket of one robot: first a message of type "snapshot", then "robot",
/// "demonstration", "job", "model" and "reproduction" as they change. What other robots record is
/// told when it is over. A client may send {"type": "stop"}, which stops this robot.
///
/// A motion that was started with "hold" moves only while {"type": "hold", "reproduction", "press"}
/// comes at least every 180 ms (send it every 50 ms); {"type": "let_go"}, silence and a lost socket
/// bring the arm to a standstill on its path. "press" is a number that grows with every press of the
/// button: after a let-go or 400 ms of silence only a new press makes the arm go on.
///
/// While a virtual arm is soft, {"type": "drag", "tool_mm": [x, y, z]} pulls the centre of its tool
/// flange there (base frame) with the orientation that it had when the drag began; "turn_deg" turns
/// it from there about the flange's own axes. Repeat it up to 60 times a second: after 300 ms
/// without, the arm comes to rest. {"type": "drag_end"} ends the drag. An attempt that cannot begin
/// or go on is answered by one {"type": "drag_refused", "code", "detail", "advice"}.
#[utoipa::path(get, path = "/live", tag = "robots", params(Watched), responses(
    (status = 101, description = "The socket is open"),
    (status = 404, description = "There is no such robot", body = Problem, content_type = "application/problem+json"),
    (status = 400, description = "Not a WebSocket request", body = Problem, content_type = "application/problem+json"),
))]
pub async fn open(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Query(watched): Query<Watched>,
    upgrade: Result<WebSocketUpgrade, WebSocketUpgradeRejection>,
) -> Result<Response, ApiError> {
    let robot = state.arms.named(watched.robot.as_deref())?.id.clone();
    let name = watched.phone_name.unwrap_or_default();
    let phone = watched.phone.and_then(|id| phone(&id, &name));
    let client = Client { actor, phone };
    let upgrade = upgrade?;
    Ok(upgrade
        .max_message_size(LONGEST_MESSAGE)
        .on_upgrade(move |socket| serve(state, robot, client, socket)))
}

/// Runs until either side leaves. Receiving does not wait for sending: a stop gets through even
/// when the client is too slow to take what is sent to it.
async fn serve(state: AppState, robot: String, client: Client, socket: WebSocket) {
    let Ok(arm) = state.arms.named(Some(&robot)) else {
        return;
    };
    let _watching = client.phone.as_ref().map(|phone| arm.control.watch(phone));
    let (sender, receiver) = socket.split();
    let mut holds = Holds::of(arm);
    let (mut drags, refusals) = Drags::of(arm);
    tokio::select! {
        () = receive(&state, arm, &client, &mut holds, &mut drags, receiver) => {}
        result = send(&state, arm, refusals, sender) => {
            if let Err(error) = result {
                tracing::debug!(%error, "a live socket ended");
            }
        }
        () = state.shutdown.raised() => {}
    }
}

async fn receive(
    state: &AppState,
    arm: &Arm,
    client: &Client,
    holds: &mut Holds<'_>,
    drags: &mut Drags<'_>,
    mut receiver: SplitStream<WebSocket>,
) {
    while let Some(Ok(message)) = receiver.next().await {
        match message {
            Message::Text(text) => match serde_json::from_str(&text) {
                Ok(Command::Stop) => {
                    arm.robot.stop();
                    state.audit(&client.actor, "stopped the arm", &arm.id).await;
                }
                Ok(Command::Hold {
                    reproduction,
                    press,
                }) => holds.hold(client.phone.as_ref(), reproduction, press),
                Ok(Command::LetGo) => holds.let_go(),
                Ok(Command::Drag { tool_mm, turn_deg }) => {
                    let target = Target { tool_mm, turn_deg };
                    drags.aim(target, || arm.claim(client.phone.as_ref()));
                }
                Ok(Command::DragEnd) => drags.end(),
                Err(_) => {}
            },
            Message::Close(_) => return,
            Message::Binary(_) | Message::Ping(_) | Message::Pong(_) => {}
        }
    }
}

type Sender = SplitSink<WebSocket, Message>;

#[derive(Debug, thiserror::Error)]
enum SendError {
    #[error(transparent)]
    Socket(#[from] axum::Error),
    #[error(transparent)]
    Store(#[from] store::Error),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    #[error("the robot is gone")]
    RobotGone,
}

async fn send(
    state: &AppState,
    arm: &Arm,
    mut refusals: mpsc::Receiver<DragError>,
    mut sender: Sender,
) -> Result<(), SendError> {
    let mut events = state.events.listen();
    let mut robot = arm.robot.view();
    send_json(&mut sender, &snapshot(state, arm).await?).await?;
    let mut tick = interval(ROBOT_EVERY);
    tick.set_missed_tick_behavior(MissedTickBehavior::Delay);
    let mut quiet = 0;
    loop {
        tokio::select! {
            event = events.recv() => match event {
                Ok(event) if grows_elsewhere(&event, arm) => {}
                Ok(event) => send_json(&mut sender, &event).await?,
                Err(RecvError::Lagged(_)) => {
                    send_json(&mut sender, &snapshot(state, arm).await?).await?;
                }
                Err(RecvError::Closed) => return Ok(()),
            },
            Some(refusal) = refusals.recv() => {
                let (code, detail, advice) = ApiError::from(refusal).words();
                send_json(&mut sender, &DragRefused { code, detail, advice }).await?;
            }
            _ = tick.tick() => {
                quiet += 1;
                if robot.has_changed().map_err(|_| SendError::RobotGone)? || quiet >= QUIET_TICKS {
                    quiet = 0;
                    let robot = RobotAnswer::of(arm, &robot.borrow_and_update());
                    send_json(&mut sender, &RobotNow { robot }).await?;
                }
            }
        }
    }
}

/// Whether this is a recording of another robot that is still growing. Each grows several times a
/// second, which is too much to tell every phone of a large cell.
fn grows_elsewhere(event: &Event, arm: &Arm) -> bool {
    let Event::Demonstration { demonstration } = event else {
        return false;
    };
    let open = matches!(
        demonstration.state,
        DemonstrationState::Preparing | DemonstrationState::Recording
    );
    open && demonstration.robot.as_deref() != Some(&arm.id)
}

async fn snapshot(state: &AppState, arm: &Arm) -> Result<Snapshot, store::Error> {
    Ok(Snapshot {
        demonstration: state.store.open_demonstration(&arm.id).await?,
        jobs: state.store.open_jobs().await?,
        reproduction: state.store.running_reproduction(&arm.id).await?,
        robot: RobotAnswer::now(arm),
    })
}

async fn send_json(sender: &mut Sender, value: &impl Serialize) -> Result<(), SendError> {
    let text = serde_json::to_string(value)?;
    Ok(sender.send(Message::Text(text.into())).await?)
}
