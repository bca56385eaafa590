//! Who may ask, how one must ask, and what the arm's position looks like.

use std::net::{Ipv4Addr, SocketAddr};

use reqwest::header::{ACCEPT, CONTENT_TYPE, COOKIE, SET_COOKIE, WWW_AUTHENTICATE};
use reqwest::{Client, Method, StatusCode};
use virtual_controller::Config;

use crate::cell::{Cell, FORM, JSON, UNIT, XHTML, code_of};

#[tokio::test]
async fn a_session_is_opened_once_and_ends_with_logout() {
    let cell = Cell::start().await;
    let stranger = Client::builder().no_proxy().build().unwrap();
    let refused = stranger.get(cell.url("/rw/system")).send().await.unwrap();
    assert_eq!(refused.status(), StatusCode::UNAUTHORIZED);
    let challenge = refused.headers()[WWW_AUTHENTICATE].to_str().unwrap();
    assert!(challenge.starts_with("Basic"));

    let first = cell.get("/rw/system").await;
    let cookies: Vec<_> = first
        .headers()
        .get_all(SET_COOKIE)
        .iter()
        .map(|cookie| {
            cookie
                .to_str()
                .unwrap()
                .split(';')
                .next()
                .unwrap()
                .to_owned()
        })
        .collect();
    assert!(cookies[0].starts_with("-http-session-=") && cookies[1].starts_with("ABBCX="));
    let second = cell.get("/rw/system").await;
    assert!(!second.headers().contains_key(SET_COOKIE));

    let with_cookie = || {
        stranger
            .get(cell.url("/rw/system"))
            .header(COOKIE, cookies.join("; "))
            .send()
    };
    assert_eq!(with_cookie().await.unwrap().status(), StatusCode::OK);
    assert_eq!(cell.get("/logout").await.status(), StatusCode::NO_CONTENT);
    assert_eq!(
        with_cookie().await.unwrap().status(),
        StatusCode::UNAUTHORIZED
    );
    cell.controller.stop().await;
}

#[tokio::test]
async fn requests_that_are_wrong_get_the_status_that_says_why() {
    let cell = Cell::start().await;
    let send = async |method: Method, path: &str, accept: &str, content_type: &str| {
        cell.client
            .request(method, cell.url(path))
            .basic_auth("Admin", Some("robotics"))
            .header(ACCEPT, accept)
            .header(CONTENT_TYPE, content_type)
            .body("ctrl-state=motoroff")
            .send()
            .await
            .unwrap()
            .status()
    };
    let path = "/rw/panel/ctrl-state";
    let plain = "application/x-www-form-urlencoded";
    let get = || Method::GET;
    let post = || Method::POST;
    assert_eq!(send(get(), path, XHTML, FORM).await, StatusCode::OK);
    assert_eq!(
        send(get(), path, "application/json", FORM).await,
        StatusCode::NOT_ACCEPTABLE
    );
    assert_eq!(
        send(post(), path, JSON, plain).await,
        StatusCode::NOT_ACCEPTABLE
    );
    assert_eq!(
        send(post(), path, JSON, "application/json;v=2.0").await,
        StatusCode::UNSUPPORTED_MEDIA_TYPE
    );
    assert_eq!(
        send(Method::PUT, path, JSON, FORM).await,
        StatusCode::METHOD_NOT_ALLOWED
    );
    assert_eq!(
        send(get(), "/rw/nothing", JSON, FORM).await,
        StatusCode::NOT_FOUND
    );
    let deeper = format!("{UNIT}/lead-through/activate");
    assert_eq!(
        send(post(), &deeper, JSON, FORM).await,
        StatusCode::NOT_FOUND
    );
    let old = "/rw/iosystem/signals/GripperClose/set";
    assert_eq!(
        send(post(), old, JSON, FORM).await,
        StatusCode::METHOD_NOT_ALLOWED
    );
    let unknown = cell.post(path, "ctrl-state=dance").await;
    assert_eq!(unknown.status(), StatusCode::BAD_REQUEST);

    cell.controller
        .faults()
        .set(|faults| faults.rws_unavailable = true);
    assert_eq!(
        send(get(), path, JSON, FORM).await,
        StatusCode::SERVICE_UNAVAILABLE
    );
    cell.controller.stop().await;
}

#[tokio::test]
async fn the_joints_stand_in_their_order_in_xhtml_too() {
    let cell = Cell::start().await;
    let text = cell
        .client
        .get(cell.url(&format!("{UNIT}/jointtarget?ignore=1")))
        .basic_auth("Default User", Some("robotics"))
        .header(ACCEPT, XHTML)
        .send()
        .await
        .unwrap()
        .text()
        .await
        .unwrap();
    let spans: Vec<(&str, f64)> = text
        .split("<span class=\"")
        .skip(1)
        .map(|span| span.split_once("\">").unwrap())
        .map(|(name, rest)| (name, rest.split('<').next().unwrap().parse().unwrap()))
        .collect();
    let home = Config::new(SocketAddr::from((Ipv4Addr::LOCALHOST, 1))).home;
    for (joint, angle) in home.0.iter().enumerate() {
        assert_eq!(
            spans[joint],
            (
                ["rax_1", "rax_2", "rax_3", "rax_4", "rax_5", "rax_6"][joint],
                *angle
            )
        );
    }
    cell.controller.stop().await;
}

#[tokio::test]
async fn the_pose_is_that_of_tool0_in_the_base() {
    let cell = Cell::start().await;
    let path = format!("{UNIT}/robtarget?tool=tool0&wobj=wobj0&coordinate=Base");
    let target = cell.read(&path).await;
    let home = Config::new(SocketAddr::from((Ipv4Addr::LOCALHOST, 1))).home;
    let tool = motion::kinematics::tool0(&home).position.0;
    for (name, value) in ["x", "y", "z"].into_iter().zip(tool) {
        let given: f64 = target[name].as_str().unwrap().parse().unwrap();
        assert!((given - value).abs() < 1e-3);
    }
    assert_eq!(target["cfx"], "1");
    let other = cell.get(&format!("{UNIT}/robtarget?tool=RG2")).await;
    assert_eq!(other.status(), StatusCode::NOT_FOUND);
    cell.controller.stop().await;
}

#[tokio::test]
async fn the_program_pointer_needs_mastership_and_only_one_client_has_it() {
    let cell = Cell::start().await;
    let reset = "/rw/rapid/execution/resetpp";
    let refused = cell.post(reset, "").await;
    assert_eq!(refused.status(), StatusCode::FORBIDDEN);
    assert_eq!(code_of(refused).await, -4501);
    cell.act(&format!("{reset}?mastership=implicit"), "").await;
    cell.act("/rw/mastership/edit/request", "").await;
    cell.act(reset, "").await;
    assert_eq!(
        cell.read("/rw/mastership/edit").await["mastershipheldbyme"],
        "TRUE"
    );

    let other = Client::builder().no_proxy().build().unwrap();
    let refused = other
        .post(cell.url("/rw/mastership/edit/request"))
        .basic_auth("Admin", Some("robotics"))
        .header(ACCEPT, JSON)
        .header(CONTENT_TYPE, FORM)
        .send()
        .await
        .unwrap();
    assert_eq!(refused.status(), StatusCode::FORBIDDEN);
    assert_eq!(code_of(refused).await, -1_073_445_862);
    cell.act("/rw/mastership/edit/release", "").await;
    cell.controller.stop().await;
}
