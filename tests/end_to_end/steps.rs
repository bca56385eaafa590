//! Steps that several tests take: teach from files, train, plan, run. Each goes through the REST
//! interface and waits for what a person would wait for.

use e2e::{Client, Folder, LONG, Process, SHORT, eventually, take};
use serde_json::{Value, json};
use tokio::sync::{Semaphore, SemaphorePermit};

use crate::PROGRAM;

/// Only one arm moves at a time: several control loops and a training on two cores would measure
/// the machine and not the program.
static ARMS: Semaphore = Semaphore::const_new(1);

/// Waits for its turn to move an arm.
pub async fn alone() -> SemaphorePermit<'static> {
    ARMS.acquire().await.expect("the semaphore is never closed")
}

/// The text of a member that must be there.
pub fn text<'a>(value: &'a Value, member: &str) -> &'a str {
    value[member]
        .as_str()
        .unwrap_or_else(|| panic!("no text {member:?} in {value}"))
}

/// The number of a member that must be there.
pub fn number(value: &Value, member: &str) -> f64 {
    value[member]
        .as_f64()
        .unwrap_or_else(|| panic!("no number {member:?} in {value}"))
}

/// Six angles of a member that must be there.
pub fn joints(value: &Value, member: &str) -> [f64; 6] {
    let angles = numbers(&value[member]);
    angles
        .try_into()
        .unwrap_or_else(|_| panic!("no six angles {member:?} in {value}"))
}

/// An array of numbers.
pub fn numbers(value: &Value) -> Vec<f64> {
    let array = value
        .as_array()
        .unwrap_or_else(|| panic!("no array: {value}"));
    array
        .iter()
        .map(|v| v.as_f64().unwrap_or_else(|| panic!("no number: {v}")))
        .collect()
}

/// Asks for a resource until it is in one of the states, and returns it.
pub async fn until_state(client: &Client, path: &str, states: &[&str]) -> Value {
    eventually(&format!("{path} is one of {states:?}"), LONG, || async {
        let resource = client.get(path).await.expect(200);
        states
            .contains(&text(&resource, "state"))
            .then_some(resource)
    })
    .await
}

/// A new task's id.
pub async fn new_task(client: &Client, name: &str) -> String {
    let task = client
        .post("/tasks", json!({ "name": name }))
        .await
        .expect(201);
    text(&task, "id").to_owned()
}

/// Uploads one file and keeps the demonstration that it makes.
pub async fn upload_and_keep(client: &Client, task: &str, name: &str, csv: String) -> Value {
    let path = format!("/tasks/{task}/demonstrations/upload?name={name}");
    let demonstration = client.post_text(&path, "text/csv", csv).await.expect(201);
    let path = format!("/demonstrations/{}/keep", text(&demonstration, "id"));
    client.post_empty(&path).await.expect(200)
}

/// A task with `takes` made-up demonstrations of about `seconds` each.
pub async fn task_from_files(client: &Client, takes: u32, seconds: f64) -> String {
    let task = new_task(client, "from files").await;
    for number in 1..=takes {
        let csv = take(number, seconds).csv();
        upload_and_keep(client, &task, &format!("take-{number}.csv"), csv).await;
    }
    task
}

/// Starts a training and waits until the model is ready.
pub async fn train(client: &Client, task: &str, request: Value) -> Value {
    let accepted = client
        .post(&format!("/tasks/{task}/models"), request)
        .await
        .expect(202);
    let path = format!("/jobs/{}", text(&accepted["job"], "id"));
    let job = until_state(client, &path, &["succeeded", "failed", "cancelled"]).await;
    assert_eq!(job["state"], "succeeded", "{job}");
    let path = format!("/models/{}", text(&accepted["model"], "id"));
    let model = client.get(&path).await.expect(200);
    assert_eq!(model["state"], "ready", "{model}");
    model
}

/// Waits until the arm is connected and idle, and returns the robot's view.
pub async fn idle_arm(client: &Client) -> Value {
    eventually("the arm is idle", SHORT, || async {
        let robot = client.get("/robots/virtual").await.expect(200);
        (robot["state"] == "idle" && robot["joints_deg"].is_array()).then_some(robot)
    })
    .await
}

/// Plans a motion that the gate must approve.
pub async fn plan(client: &Client, model: &Value, start: Value, goal: Value) -> Value {
    let request = json!({ "model_id": model["id"], "start": start, "goal": goal });
    client.post("/plans", request).await.expect(200)
}

/// Starts a plan.
pub async fn start(client: &Client, plan: &Value) -> Value {
    client
        .post("/reproductions", json!({ "plan": plan["plan"] }))
        .await
        .expect(202)
}

/// Waits until a reproduction has ended.
pub async fn ended(client: &Client, reproduction: &Value) -> Value {
    let path = format!("/reproductions/{}", text(reproduction, "id"));
    until_state(client, &path, &["succeeded", "stopped", "failed"]).await
}

/// Waits until the arm is in the motion itself, past the approach and past `t_s` seconds of it.
pub async fn in_motion(client: &Client, t_s: f64) -> Value {
    eventually("the motion is under way", LONG, || async {
        let robot = client.get("/robots/virtual").await.expect(200);
        let run = &robot["run"];
        (run["phase"] == "motion" && number(run, "t_s") > t_s).then_some(robot)
    })
    .await
}

/// A server that listens on every address, as phones reach it, without an arm. Its client uses this
/// machine's own address.
pub async fn on_the_network(folder: &Folder) -> Process {
    Process::start_on(PROGRAM, "0.0.0.0:0", folder.path(), &["--robot", "none"]).await
}

/// The code that the terminal shows.
pub async fn pairing_code(server: &Process) -> String {
    eventually("the terminal shows the pairing code", SHORT, || async {
        let output = server.output();
        let code = output
            .lines()
            .find_map(|line| line.strip_prefix("Pairing code:"))?;
        Some(code.split_whitespace().collect())
    })
    .await
}
