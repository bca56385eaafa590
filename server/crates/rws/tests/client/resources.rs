//! The resources: what is read from their answers, and following a change until it holds.

use crate::scripted::Scripted;
use rws::virtual_hand::{Action, HandState};
use rws::{Cycle, EventType, Execution, OperatingMode, RwsError};

const LEAD_THROUGH: &str = "/rw/motionsystem/mechunits/ROB_1/lead-through";
const SAFETY_LOG: &str = "GET /rw/elog/9?lang=en&order=lifo&limit=";

fn lead_through(method: &str) -> String {
    format!("{method} {LEAD_THROUGH}")
}

fn event(number: u32, code: u32, title: &str) -> String {
    format!(
        r#"{{"_type":"elog-message-li","_title":"/rw/elog/9/{number}","msgtype":"3","code":"{code}","tstamp":"2025-01-01 T 08:00:00","title":"{title}","argv":[-01]}}"#
    )
}

fn log(events: &[String]) -> String {
    format!(r#"{{"_embedded":{{"resources":[{}]}}}}"#, events.join(","))
}

#[tokio::test]
async fn joint_angles_are_read_in_the_order_of_the_axes() {
    let controller = Scripted::start().await;
    let line = "GET /rw/motionsystem/mechunits/ROB_1/jointtarget";
    let body = r#"{"state":[{"_type":"ms-jointtarget","rax_1":"1.5","rax_2":"-2","rax_3":"3e1","rax_4":"4","rax_5":"-45.25","rax_6":"6","eax_a":"9E9"}]}"#;
    controller.answers(line, 200, body);
    let joints = controller.client().joint_target_deg().await.unwrap();
    assert_eq!(joints, [1.5, -2.0, 30.0, 4.0, -45.25, 6.0]);
}

#[tokio::test]
async fn a_joint_angle_that_is_no_number_is_an_error_and_not_a_pose() {
    let line = "GET /rw/motionsystem/mechunits/ROB_1/jointtarget";
    for value in ["NaN", "inf", "", "seven"] {
        let controller = Scripted::start().await;
        let body = format!(
            r#"{{"state":[{{"rax_1":"1","rax_2":"2","rax_3":"{value}","rax_4":"4","rax_5":"5","rax_6":"6"}}]}}"#
        );
        controller.answers(line, 200, &body);
        let error = controller.client().joint_target_deg().await.unwrap_err();
        assert!(error.to_string().contains("rax_3"), "{error}");
    }
}

#[tokio::test]
async fn panel_and_system_are_read_whatever_the_case() {
    let controller = Scripted::start().await;
    controller
        .reports("GET /rw/panel/opmode", "opmode", "AUTO")
        .reports("GET /rw/panel/opmode", "opmode", "manr")
        .reports("GET /rw/panel/speedratio", "speedratio", "75")
        .reports("GET /rw/system", "rwversion", "7.20.0+1391");
    let client = controller.client();
    let modes = [
        client.operating_mode().await.unwrap(),
        client.operating_mode().await.unwrap(),
    ];
    assert_eq!(modes, [OperatingMode::Auto, OperatingMode::ManualReduced]);
    assert_eq!(client.speed_ratio_percent().await.unwrap(), 75.0);
    assert_eq!(client.system().await.unwrap().robotware, "7.20.0+1391");
}

#[tokio::test]
async fn lead_through_is_on_only_once_the_controller_keeps_it() {
    let controller = Scripted::start().await;
    let get = lead_through("GET");
    controller
        .answers(&format!("{SAFETY_LOG}1"), 200, &log(&[]))
        .answers(&lead_through("POST"), 204, "")
        .reports(&get, "status", "Inactive")
        .reports(&get, "status", "Active");
    let client = controller.client();
    client.set_lead_through(true).await.unwrap();
    let post = controller
        .asked()
        .into_iter()
        .find(|asked| asked.line == lead_through("POST"));
    assert_eq!(post.unwrap().body, "status=active");
}

#[tokio::test]
async fn lead_through_that_is_taken_back_is_reported_with_what_is_new_in_the_safety_log() {
    let controller = Scripted::start().await;
    let get = lead_through("GET");
    let old = event(1, 90_200, "Old message");
    let new = event(2, 90_515, "Tool speed violation");
    controller
        .answers(
            &format!("{SAFETY_LOG}1"),
            200,
            &log(std::slice::from_ref(&old)),
        )
        .answers(&lead_through("POST"), 204, "")
        .reports(&get, "status", "Active")
        .reports(&get, "status", "Inactive")
        .answers(&format!("{SAFETY_LOG}5"), 200, &log(&[new, old]));
    let error = controller
        .client()
        .set_lead_through(true)
        .await
        .unwrap_err();
    let RwsError::LeadThroughReverted {
        active: true,
        reason,
    } = &error
    else {
        panic!("{error}");
    };
    assert!(reason.contains("Tool speed violation") && reason.contains("90515"));
    assert!(!reason.contains("Old message"));
}

#[tokio::test]
async fn a_program_that_is_said_to_start_but_does_not_is_an_error() {
    let controller = Scripted::start().await;
    let line = "GET /rw/rapid/execution";
    controller
        .answers("POST /rw/rapid/execution/start", 204, "")
        .reports(line, "ctrlexecstate", "running")
        .reports(line, "ctrlexecstate", "stopped");
    let client = controller.client();
    let error = client.start_execution(Cycle::Once).await.unwrap_err();
    assert!(matches!(
        error,
        RwsError::ExecutionUnchanged { running: true }
    ));
    assert_eq!(client.execution().await.unwrap(), Execution::Stopped);
    let form = &controller.asked()[0].body;
    assert!(
        form.contains("cycle=once") && form.contains("regain=continue"),
        "{form}"
    );
}

#[tokio::test]
async fn stopping_waits_until_the_program_stands() {
    let controller = Scripted::start().await;
    let line = "GET /rw/rapid/execution";
    controller
        .answers("POST /rw/rapid/execution/stop", 204, "")
        .reports(line, "ctrlexecstate", "running")
        .reports(line, "ctrlexecstate", "running")
        .reports(line, "ctrlexecstate", "stopped");
    controller.client().stop_execution().await.unwrap();
    assert_eq!(controller.lines().len(), 4);
}

#[tokio::test]
async fn signals_are_read_and_written() {
    let controller = Scripted::start().await;
    let line = "GET /rw/iosystem/signals/Asi1Button1";
    let body = r#"{"_embedded":{"resources":[{"_type":"ios-signal","name":"Asi1Button1","type":"DI","lvalue":"1"}]}}"#;
    controller.answers(line, 200, body).answers(
        "POST /rw/iosystem/signals/gripper/set-value",
        204,
        "",
    );
    let client = controller.client();
    let signal = client.signal("Asi1Button1").await.unwrap();
    assert_eq!((signal.kind.as_str(), signal.value), ("DI", 1.0));
    client.set_signal("gripper", 1.0).await.unwrap();
    assert_eq!(controller.asked()[1].body, "lvalue=1");
    let error = client.signal("nothing").await.unwrap_err();
    assert_eq!(error.code(), "robot_resource_missing");
}

#[tokio::test]
async fn a_list_of_signals_is_read_to_its_end() {
    let controller = Scripted::start().await;
    let page = |names: &[&str], links: &str| {
        let signals: Vec<String> = names
            .iter()
            .map(|name| {
                format!(r#"{{"_type":"ios-signal-li","name":"{name}","type":"DO","lvalue":"1"}}"#)
            })
            .collect();
        format!(
            r#"{{"_links":{{{links}}},"_embedded":{{"resources":[{}]}}}}"#,
            signals.join(",")
        )
    };
    let next = r#""next":{"href":"signals?start=2&limit=100"}"#;
    let line = |start| format!("GET /rw/iosystem/signals?start={start}&limit=100");
    controller
        .answers(&line(0), 200, &page(&["a", "b"], next))
        .answers(&line(2), 200, &page(&["c"], ""));
    let signals = controller.client().signals().await.unwrap();
    let names: Vec<&str> = signals.iter().map(|signal| signal.name.as_str()).collect();
    assert_eq!(names, ["a", "b", "c"]);
}

#[tokio::test]
async fn a_resource_that_has_no_json_is_read_as_xhtml() {
    let controller = Scripted::start().await;
    let xhtml = r#"<html><body><div class="state"><ul><li class="pnl-opmode" title="opmode"><span class="opmode">AUTO</span></li></ul></div></body></html>"#;
    controller
        .answers("GET /rw/panel/opmode", 406, "")
        .answers("GET /rw/panel/opmode", 200, xhtml);
    let mode = controller.client().operating_mode().await.unwrap();
    assert_eq!(mode, OperatingMode::Auto);
    let accepts: Vec<String> = controller
        .asked()
        .into_iter()
        .map(|asked| asked.accept)
        .collect();
    assert_eq!(
        accepts,
        ["application/hal+json;v=2.0", "application/xhtml+xml;v=2.0"]
    );
}

#[tokio::test]
async fn what_is_loaded_and_installed_is_read() {
    let controller = Scripted::start().await;
    let list = |entry: &str| format!(r#"{{"state":[{entry}]}}"#);
    controller
        .answers(
            "GET /rw/rapid/tasks",
            200,
            &list(r#"{"_type":"rap-task-li","name":"T_ROB1","active":"On","motiontask":"TRUE"}"#),
        )
        .answers(
            "GET /rw/rapid/tasks/T_ROB1/modules",
            200,
            &list(r#"{"_type":"rap-module-info-li","name":"TEAM_egm","type":"ProgMod"}"#),
        )
        .answers(
            "GET /rw/system/options",
            200,
            &list(r#"{"_type":"sys-option-li","option":"3124-1 Externally Guided Motion"}"#),
        )
        .reports("GET /ctrl/clock", "datetime", "2026-07-09 T 02:55:41");
    let client = controller.client();
    let tasks = client.tasks().await.unwrap();
    assert!(tasks[0].name == "T_ROB1" && tasks[0].active && tasks[0].moves_arm);
    assert_eq!(client.modules("T_ROB1").await.unwrap()[0].name, "TEAM_egm");
    assert!(client.options().await.unwrap()[0].starts_with("3124-1"));
    assert_eq!(client.clock().await.unwrap(), "2026-07-09 T 02:55:41");
}

#[tokio::test]
async fn a_known_event_is_told_in_plain_words_and_says_what_to_do() {
    let controller = Scripted::start().await;
    let body = log(&[event(7, 41_822, "No data from the UdpUc device")]);
    controller.answers("GET /rw/elog/4?lang=en&order=lifo&limit=1", 200, &body);
    let events = controller.client().events(4, 1).await.unwrap();
    let words = events[0].to_string();
    assert!(
        words.starts_with("the controller got no motion data"),
        "{words}"
    );
    assert!(
        words.contains("41822") && words.contains("No data from the UdpUc device"),
        "{words}"
    );
    assert!(events[0].advice().contains("cable"));
}

#[tokio::test]
async fn events_are_read_although_their_arguments_are_no_json() {
    let controller = Scripted::start().await;
    let body = log(&[event(7, 10_011, "Motors ON state")]);
    controller.answers("GET /rw/elog/0?lang=en&order=lifo&limit=3", 200, &body);
    let events = controller.client().events(0, 3).await.unwrap();
    assert_eq!(events[0].code, 10_011);
    assert_eq!(events[0].kind, EventType::Error);
    assert_eq!(events[0].to_string(), "Motors ON state (event 10011)");
}

#[tokio::test]
async fn the_virtual_hand_exists_only_on_the_virtual_controller() {
    let controller = Scripted::start().await;
    controller.answers("POST /virtual/hand", 204, "").answers(
        "GET /virtual/hand",
        200,
        r#"{"state":"showing","t_s":1.5}"#,
    );
    let client = controller.client();
    client
        .move_virtual_hand(Action::Show, "f2", 42)
        .await
        .unwrap();
    assert_eq!(controller.asked()[0].body, "action=show&script=f2&seed=42");
    assert_eq!(
        client.virtual_hand_state().await.unwrap(),
        HandState::Showing
    );

    client
        .lead_virtual_hand(&[1.5, -2.0, 0.0, 1e-7, -45.25, 6.0])
        .await
        .unwrap();
    client.release_virtual_hand().await.unwrap();
    let asked = controller.asked();
    assert_eq!(
        asked[asked.len() - 2].body,
        "action=lead&joints=1.5%2C-2%2C0%2C0.0000001%2C-45.25%2C6"
    );
    assert_eq!(asked[asked.len() - 1].body, "action=let_go");

    let real = Scripted::start().await;
    let error = real.client().virtual_hand_state().await.unwrap_err();
    assert_eq!(error.code(), "robot_resource_missing");
    let error = real.client().lead_virtual_hand(&[0.0; 6]).await;
    assert_eq!(error.unwrap_err().code(), "robot_resource_missing");
}
