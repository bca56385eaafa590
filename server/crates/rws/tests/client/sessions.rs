//! Logging in, staying in one session, and what the client makes of refusals.

use crate::scripted::Scripted;
use rws::{Client, Config, ControllerState, RwsError};

const CTRL_STATE: &str = "GET /rw/panel/ctrl-state";

#[tokio::test]
async fn it_logs_in_once_and_stays_in_its_session() {
    let controller = Scripted::start().await;
    controller.reports(CTRL_STATE, "ctrlstate", "motoron");
    let client = controller.client();
    for _ in 0..3 {
        let state = client.controller_state().await.unwrap();
        assert_eq!(state, ControllerState::MotorsOn);
    }
    let asked = controller.asked();
    assert!(asked[0].authorized && asked[0].cookie.is_empty());
    assert!(!asked[1].authorized && asked[1].cookie.contains("-http-session-=1"));
    assert_eq!(asked[0].accept, "application/hal+json;v=2.0");
    assert_eq!((asked.len(), controller.sessions()), (3, 1));
}

#[tokio::test]
async fn a_lost_session_is_opened_again_without_the_caller_noticing() {
    let controller = Scripted::start().await;
    controller.reports(CTRL_STATE, "ctrlstate", "motoroff");
    let client = controller.client();
    client.controller_state().await.unwrap();
    controller.expire_session();
    let state = client.controller_state().await.unwrap();
    assert_eq!(state, ControllerState::MotorsOff);
    assert_eq!(controller.sessions(), 2);
}

#[tokio::test]
async fn a_wrong_password_is_tried_no_more_than_twice() {
    let controller = Scripted::start().await;
    let mut config = Config::new(&controller.url);
    config.password = "wrong".to_owned();
    let error = Client::new(config)
        .unwrap()
        .controller_state()
        .await
        .unwrap_err();
    assert!(matches!(&error, RwsError::Unauthorized { user } if user == "Default User"));
    assert!(controller.asked().len() <= 2);
}

#[tokio::test]
async fn a_busy_controller_is_asked_again_but_not_for_ever() {
    let controller = Scripted::start().await;
    controller
        .answers(CTRL_STATE, 503, "")
        .answers(CTRL_STATE, 503, "")
        .reports(CTRL_STATE, "ctrlstate", "guardstop");
    let state = controller.client().controller_state().await.unwrap();
    assert_eq!(state, ControllerState::GuardStop);

    let overloaded = Scripted::start().await;
    overloaded.answers(CTRL_STATE, 503, "");
    let error = overloaded.client().controller_state().await.unwrap_err();
    assert_eq!(error.code(), "robot_overloaded");
    assert_eq!(overloaded.asked().len(), 4);
}

#[tokio::test]
async fn a_refusal_carries_the_controllers_words_and_advice_for_them() {
    let controller = Scripted::start().await;
    let body = r#"{"status":{"code":-1073445862,"msg":"held by someone else icode:-4501"}}"#;
    controller.answers("POST /rw/mastership/edit/request", 403, body);
    let error = controller
        .client()
        .request_edit_mastership()
        .await
        .unwrap_err();
    let RwsError::Refused { code, message, .. } = &error else {
        panic!("{error}");
    };
    assert_eq!(*code, Some(-1_073_445_862));
    assert!(message.contains("held by someone else"));
    assert!(error.advice().contains("FlexPendant"));
}

#[tokio::test]
async fn a_post_says_the_version_of_its_form_also_when_it_is_empty() {
    let controller = Scripted::start().await;
    controller
        .answers("POST /rw/rapid/execution/resetpp", 204, "")
        .answers("POST /rw/panel/ctrl-state", 204, "");
    let client = controller.client();
    client.reset_program_pointer().await.unwrap();
    client.set_motors(true).await.unwrap();
    let asked = controller.asked();
    for request in &asked {
        assert_eq!(
            request.content_type,
            "application/x-www-form-urlencoded;v=2.0"
        );
    }
    assert_eq!(asked[1].body, "ctrl-state=motoron");
}

#[tokio::test]
async fn nobody_at_home_is_told_apart_from_a_refusal() {
    let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
    let url = format!("http://{}", listener.local_addr().unwrap());
    drop(listener);
    let client = Client::new(Config::new(&url)).unwrap();
    let error = client.controller_state().await.unwrap_err();
    assert!(error.is_unreachable());
    assert!(error.to_string().contains(&url), "{error}");
}

#[tokio::test]
async fn an_address_that_is_none_is_refused_at_once() {
    for url in ["", "192.168.125.1", "ftp://robot", "http://"] {
        let error = Client::new(Config::new(url)).unwrap_err();
        assert_eq!(error.code(), "robot_address", "{url}");
    }
}

#[tokio::test]
async fn logging_out_ends_the_session() {
    let controller = Scripted::start().await;
    controller
        .reports(CTRL_STATE, "ctrlstate", "motoron")
        .answers("GET /logout", 204, "");
    let client = controller.client();
    client.logout().await.unwrap();
    assert!(controller.lines().is_empty());
    client.controller_state().await.unwrap();
    client.logout().await.unwrap();
    client.controller_state().await.unwrap();
    assert_eq!(controller.lines(), [CTRL_STATE, "GET /logout", CTRL_STATE]);
    assert!(controller.asked()[2].cookie.is_empty());
}
