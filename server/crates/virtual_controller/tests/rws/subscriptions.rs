//! Subscriptions and their WebSocket.

use futures_util::StreamExt;
use reqwest::header::{LOCATION, SET_COOKIE};
use reqwest::{Client, StatusCode};
use serde_json::Value;
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;

use crate::cell::{Cell, PATIENCE};

#[tokio::test]
async fn a_subscription_says_what_holds_now_and_belongs_to_its_session() {
    let cell = Cell::start().await;
    let wrong = "resources=1&1=/rw/motionsystem/mechunits/ROB_1/jointtarget;x&1-p=1";
    assert_eq!(
        cell.post("/subscription", wrong).await.status(),
        StatusCode::BAD_REQUEST
    );

    let body = "resources=2&1=/rw/panel/ctrl-state;ctrlstate&1-p=1\
                &2=/rw/iosystem/signals/GripperClose;state&2-p=2";
    let created = cell.post("/subscription", body).await;
    assert_eq!(created.status(), StatusCode::CREATED);
    let location = created.headers()[LOCATION].to_str().unwrap().to_owned();
    let first: Value = created.json().await.unwrap();
    assert_eq!(first["_embedded"]["resources"][0]["ctrlstate"], "motoroff");

    let cookie = {
        let login = Client::builder().no_proxy().build().unwrap();
        let answer = login
            .get(cell.url("/rw/system"))
            .basic_auth("Admin", Some("robotics"))
            .send()
            .await
            .unwrap();
        answer.headers()[SET_COOKIE].to_str().unwrap().to_owned()
    };
    let mut foreign = location.as_str().into_client_request().unwrap();
    foreign.headers_mut().insert(
        "sec-websocket-protocol",
        "rws_subscription".parse().unwrap(),
    );
    foreign
        .headers_mut()
        .insert("cookie", cookie.parse().unwrap());
    assert!(tokio_tungstenite::connect_async(foreign).await.is_err());
    cell.controller.stop().await;
}

#[tokio::test]
async fn a_subscription_reports_changes_until_it_is_deleted() {
    let cell = Cell::start().await;
    let login = cell.get("/rw/system").await;
    let cookie = login.headers()[SET_COOKIE].to_str().unwrap().to_owned();
    let body = "resources=1&1=/rw/panel/ctrl-state;ctrlstate&1-p=1";
    let created = cell.post("/subscription", body).await;
    let location = created.headers()[LOCATION].to_str().unwrap().to_owned();
    let request = |protocol: &str| {
        let mut request = location.as_str().into_client_request().unwrap();
        let headers = request.headers_mut();
        headers.insert("sec-websocket-protocol", protocol.parse().unwrap());
        headers.insert("cookie", cookie.parse().unwrap());
        request
    };
    let old = tokio_tungstenite::connect_async(request("robapi2_subscription")).await;
    assert!(old.is_err());
    let (mut socket, _) = tokio_tungstenite::connect_async(request("rws_subscription"))
        .await
        .unwrap();
    cell.act("/rw/panel/ctrl-state", "ctrl-state=motoron").await;
    let event = tokio::time::timeout(PATIENCE, socket.next()).await.unwrap();
    let Some(Ok(Message::Text(text))) = event else {
        panic!("{event:?}");
    };
    assert!(text.contains("<li class=\"pnl-ctrlstate-ev\""), "{text}");
    assert!(
        text.contains("<span class=\"ctrlstate\">motoron</span>"),
        "{text}"
    );

    let id = location.rsplit('/').next().unwrap();
    let deleted = cell
        .client
        .delete(cell.url(&format!("/subscription/{id}")))
        .send()
        .await
        .unwrap();
    assert_eq!(deleted.status(), StatusCode::OK);
    let end = tokio::time::timeout(PATIENCE, socket.next()).await.unwrap();
    assert!(matches!(end, Some(Ok(Message::Close(_))) | None), "{end:?}");
    cell.controller.stop().await;
}
