//! The flight record: it survives a kill, and what is downloaded is what was recorded.

use e2e::{Client, Process};
use serde_json::{Value, json};

use crate::PROGRAM;
use crate::prepared::with_model;
use crate::steps::{alone, ended, idle_arm, in_motion, number, numbers, plan, start, text};

/// What a kill may cost of a record.
const MAY_BE_LOST_S: f64 = 0.5;

async fn started(client: &Client, model: &Value) -> Value {
    idle_arm(client).await;
    let plan = plan(client, model, json!("as_taught"), json!("as_taught")).await;
    start(client, &plan).await
}

fn codes(events: &Value) -> Vec<&str> {
    let events = events.as_array().expect("a list of events");
    events.iter().map(|event| text(event, "code")).collect()
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_kill_while_the_arm_moves_keeps_the_record_up_to_there() {
    let _turn = alone().await;
    let (folder, server, model) = with_model("kill-run", &[]).await;
    let client = server.client();
    let running = started(&client, &model).await;
    let path = format!("/reproductions/{}", text(&running, "id"));
    let seen = in_motion(&client, 1.5).await;
    // The arm was at least this far when the server was killed.
    let seen_s = number(&seen["run"], "t_s");
    server.kill().await;

    let server = Process::start(PROGRAM, folder.path(), &["--robot", "none"]).await;
    let client = server.client();
    let found = client.get(&path).await.expect(200);
    assert_eq!(found["state"], "failed", "{found}");
    assert!(text(&found, "reason").contains("stopped while the arm was moving"));
    assert!(number(&found["cycles"], "total") > 100.0, "{found}");
    assert!(
        found["tracking_error_deg"]["rms_by_joint"].is_array(),
        "{found}"
    );
    let flight = client
        .get(&format!("{path}/flight?points=20000"))
        .await
        .expect(200);
    let plan_t_s = numbers(&flight["plan_t_s"]);
    let kept_s = plan_t_s[plan_t_s.len() - 1];
    assert!(
        kept_s >= seen_s - MAY_BE_LOST_S,
        "{kept_s} s are kept, and the arm was at {seen_s} s"
    );
    let events = client.get(&format!("{path}/events")).await.expect(200);
    let codes = codes(&events);
    assert!(
        codes.contains(&"armed") && codes.contains(&"motion"),
        "{events}"
    );
    assert_eq!(codes.last(), Some(&"interrupted"), "{events}");
    // It can be taken away as a file too.
    let csv = client.get(&format!("{path}/flight.csv")).await;
    let rows = String::from_utf8(csv.expect_bytes(200)).expect("CSV is text");
    assert_eq!(
        rows.lines().count() as f64,
        1.0 + number(&found["cycles"], "total")
    );
    server.terminate().await;
}

/// The columns of a CSV file by their names.
struct Table<'a>(Vec<Vec<&'a str>>);

impl<'a> Table<'a> {
    fn of(text: &'a str) -> Self {
        Self(text.lines().map(|line| line.split(',').collect()).collect())
    }

    fn column(&self, name: &str) -> Vec<&'a str> {
        let at = self.0[0].iter().position(|one| *one == name);
        let at = at.unwrap_or_else(|| panic!("no column {name:?}"));
        self.0[1..].iter().map(|row| row[at]).collect()
    }

    fn numbers(&self, name: &str) -> Vec<f64> {
        let parse = |field: &str| field.parse().unwrap_or_else(|_| panic!("{field:?}"));
        self.column(name).into_iter().map(parse).collect()
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_whole_run_can_be_plotted_and_taken_away() {
    let _turn = alone().await;
    let (_folder, server, model) = with_model("flight", &[]).await;
    let client = server.client();
    let result = ended(&client, &started(&client, &model).await).await;
    assert_eq!(result["state"], "succeeded", "{result}");
    let path = format!("/reproductions/{}", text(&result, "id"));

    let reply = client.get(&format!("{path}/flight.csv")).await;
    assert!(reply.header("content-type").starts_with("text/csv"));
    let name = reply.header("content-disposition").to_owned();
    assert!(name.starts_with("attachment; filename=\"motion_") && name.ends_with(".csv\""));
    let csv = String::from_utf8(reply.expect_bytes(200)).expect("CSV is text");
    let table = Table::of(&csv);
    let times = table.numbers("t_s");
    assert_eq!(times.len() as f64, number(&result["cycles"], "total"));
    assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
    let phases = table.column("phase");
    assert_eq!(phases.first(), Some(&"approach"), "the arm stands at home");
    assert_eq!(phases.last(), Some(&"settling"));
    for joint in 0..6 {
        let commanded = table.numbers(&format!("commanded_{}_deg", joint + 1));
        let measured = table.numbers(&format!("measured_{}_deg", joint + 1));
        let off = commanded.iter().zip(&measured).map(|(a, b)| (a - b).abs());
        let off_deg = numbers(&result["tracking_error_deg"]["max_by_joint"])[joint];
        assert!((off.fold(0.0, f64::max) - off_deg).abs() < 1e-9);

        // Few points, and the extremes of all cycles are among them.
        let few = client.get(&format!("{path}/flight?points=25")).await;
        let few = few.expect(200);
        assert!(numbers(&few["t_s"]).len() <= 25);
        let highest = |values: Vec<f64>| values.into_iter().fold(f64::MIN, f64::max);
        let kept = highest(numbers(&few["measured_max_deg"][joint]));
        assert!((kept - highest(measured)).abs() < 1e-9);
    }

    // A stretch of it is nothing but that stretch, and finer.
    let (from_s, to_s) = (times[times.len() / 2], times[times.len() / 2 + 50]);
    let stretch = format!("{path}/flight?points=51&from_s={from_s}&to_s={to_s}");
    let stretch = numbers(&client.get(&stretch).await.expect(200)["t_s"]);
    assert!((stretch[0] - from_s).abs() < 1e-6);
    assert!((stretch[stretch.len() - 1] - to_s).abs() < 1e-6);
    for wrong in [
        "points=1",
        "points=30000",
        "from_s=-1",
        "from_s=3&to_s=2",
        "to_s=NaN",
    ] {
        let reply = client.get(&format!("{path}/flight?{wrong}")).await;
        let _ = reply.problem(&[422]);
    }

    let events = client.get(&format!("{path}/events")).await.expect(200);
    let codes = codes(&events);
    let places = ["armed", "approach", "motion", "settling", "completed"]
        .map(|code| codes.iter().position(|one| *one == code));
    assert!(
        places.iter().all(Option::is_some) && places.is_sorted(),
        "{events}"
    );

    let reply = client.get(&format!("{path}/flight.mcap")).await;
    assert!(reply.header("content-disposition").ends_with(".mcap\""));
    let mcap = reply.expect_bytes(200);
    // A complete file begins and ends with the same eight bytes.
    let magic = b"\x89MCAP0\r\n";
    assert!(mcap.starts_with(magic) && mcap.ends_with(magic));
    for words in [
        "foxglove.JointStates",
        "/commanded",
        "/measured",
        "foxglove.Log",
    ] {
        let there = mcap.windows(words.len()).any(|one| one == words.as_bytes());
        assert!(there, "{words}");
    }
    server.terminate().await;
}
