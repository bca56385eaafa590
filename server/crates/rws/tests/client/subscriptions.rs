//! Subscriptions against the virtual controller.

use crate::cell::{PATIENCE, cell, cell_at};
use rws::{Change, ControllerState, Execution, OperatingMode, RwsError, Subscription, Topic};

async fn next(subscription: &mut Subscription) -> Change {
    let change = tokio::time::timeout(PATIENCE, subscription.next()).await;
    change.unwrap().unwrap()
}

/// Reads on until `wanted` comes.
async fn wait_for(subscription: &mut Subscription, wanted: &Change) {
    while next(subscription).await != *wanted {}
}

fn topics() -> [Topic; 6] {
    [
        Topic::ControllerState,
        Topic::OperatingMode,
        Topic::SpeedRatio,
        Topic::Execution,
        Topic::Signal("GripperClose".to_owned()),
        Topic::Events(0),
    ]
}

#[tokio::test]
async fn it_begins_with_what_holds_and_goes_on_with_what_changes_also_over_https() {
    for https in [false, true] {
        let cell = cell(https).await;
        let client = cell.client();
        let mut subscription = client.subscribe(&topics()).await.unwrap();
        let mut first = Vec::new();
        for _ in 0..5 {
            first.push(next(&mut subscription).await);
        }
        assert!(
            first.contains(&Change::ControllerState(ControllerState::MotorsOff)),
            "{first:?}"
        );
        assert!(
            first.contains(&Change::OperatingMode(OperatingMode::Auto)),
            "{first:?}"
        );
        assert!(first.contains(&Change::SpeedRatio(100.0)), "{first:?}");
        assert!(
            first.contains(&Change::Execution(Execution::Stopped)),
            "{first:?}"
        );

        client.set_motors(true).await.unwrap();
        let on = Change::ControllerState(ControllerState::MotorsOn);
        wait_for(&mut subscription, &on).await;
        client.set_signal("GripperClose", 1.0).await.unwrap();
        let closed = Change::Signal {
            name: "GripperClose".to_owned(),
            value: 1.0,
        };
        wait_for(&mut subscription, &closed).await;
        subscription.end().await;
        cell.controller.stop().await;
    }
}

#[tokio::test]
async fn new_log_entries_are_reported_and_can_be_read() {
    let cell = cell(false).await;
    let client = cell.client();
    let mut subscription = client.subscribe(&[Topic::Events(1)]).await.unwrap();
    client.set_motors(true).await.unwrap();
    let Change::Event { domain: 1, number } = next(&mut subscription).await else {
        panic!("no event");
    };
    let events = client.events(1, 1).await.unwrap();
    assert!(
        events[0].reference.ends_with(&format!("/{number}")),
        "{events:?}"
    );
    assert_eq!(events[0].code, 10_011);
    subscription.end().await;
    cell.controller.stop().await;
}

#[tokio::test]
async fn after_a_restart_of_the_controller_it_goes_on_by_itself() {
    let first = cell(false).await;
    let address = first.controller.rws_addr();
    let client = first.client();
    client.set_motors(true).await.unwrap();
    let mut subscription = client.subscribe(&[Topic::ControllerState]).await.unwrap();
    let on = Change::ControllerState(ControllerState::MotorsOn);
    assert_eq!(next(&mut subscription).await, on);
    first.controller.stop().await;
    assert!(matches!(next(&mut subscription).await, Change::Lost { .. }));

    let second = cell_at(address, false).await;
    let off = Change::ControllerState(ControllerState::MotorsOff);
    assert_eq!(next(&mut subscription).await, off);
    client.set_motors(true).await.unwrap();
    assert_eq!(next(&mut subscription).await, on);
    subscription.end().await;
    second.controller.stop().await;
}

#[tokio::test]
async fn a_subscription_to_what_is_not_there_is_refused_at_once() {
    let cell = cell(false).await;
    let client = cell.client();
    let nowhere = [Topic::Signal("nowhere".to_owned())];
    let error = client.subscribe(&nowhere).await.unwrap_err();
    assert!(
        matches!(error, RwsError::Refused { status: 400, .. }),
        "{error}"
    );
    let no_name = [Topic::Signal("a;b&c=d".to_owned())];
    let error = client.subscribe(&no_name).await.unwrap_err();
    assert!(matches!(error, RwsError::Missing { .. }), "{error}");
    cell.controller.stop().await;
}
