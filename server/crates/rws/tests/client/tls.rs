//! HTTPS: the client against the virtual controller, with the right certificate and others.

use crate::cell::{PATIENCE, cell, config};
use rws::{Client, RwsError};

/// SHA-256 of "abc": the certificate of nobody.
const OTHER: &str = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

#[tokio::test]
async fn the_pinned_certificate_is_accepted_although_no_authority_signed_it() {
    let cell = cell(true).await;
    let sha256 = cell.controller.certificate_sha256().unwrap();
    let client = Client::new(config(cell.controller.rws_url(), Some(sha256))).unwrap();
    assert_eq!(client.system().await.unwrap().name, "virtual_gofa");
    client.logout().await.unwrap();
    cell.controller.stop().await;
}

#[tokio::test]
async fn the_name_in_the_address_does_not_matter_once_the_certificate_is_pinned() {
    let cell = cell(true).await;
    let sha256 = cell.controller.certificate_sha256().unwrap().to_lowercase();
    // The certificate names 127.0.0.1 and localhost, not this.
    let url = format!(
        "https://[::ffff:127.0.0.1]:{}",
        cell.controller.rws_addr().port()
    );
    let client = Client::new(config(url, Some(&sha256.replace(':', "")))).unwrap();
    client.controller_state().await.unwrap();
    cell.controller.stop().await;
}

#[tokio::test]
async fn another_certificate_is_refused_and_both_fingerprints_are_named() {
    let cell = cell(true).await;
    let client = Client::new(config(cell.controller.rws_url(), Some(OTHER))).unwrap();
    let error = client.system().await.unwrap_err();
    assert!(
        matches!(error, RwsError::WrongCertificate { .. }),
        "{error}"
    );
    assert!(!error.is_unreachable());
    let words = error.to_string();
    assert!(
        words.contains(cell.controller.certificate_sha256().unwrap()),
        "{words}"
    );
    assert!(words.contains("BA:78:16:BF"), "{words}");
    cell.controller.stop().await;
}

#[tokio::test]
async fn without_a_pin_an_unsigned_certificate_is_refused_with_its_fingerprint_and_what_to_do() {
    let cell = cell(true).await;
    let client = Client::new(config(cell.controller.rws_url(), None)).unwrap();
    let error = client.system().await.unwrap_err();
    assert_eq!(error.code(), "robot_certificate_unknown", "{error}");
    let sha256 = cell.controller.certificate_sha256().unwrap();
    assert!(error.to_string().contains(sha256), "{error}");
    assert!(error.advice().contains("certificate_sha256"));
    cell.controller.stop().await;
}

#[tokio::test]
async fn the_fingerprint_can_be_read_without_trusting_it() {
    let cell = cell(true).await;
    let seen = rws::read_fingerprint(&cell.controller.rws_url(), PATIENCE)
        .await
        .unwrap();
    assert_eq!(
        seen.to_string(),
        cell.controller.certificate_sha256().unwrap()
    );
    cell.controller.stop().await;
}

#[tokio::test]
async fn plain_http_goes_on_but_never_for_someone_who_pinned_a_certificate() {
    let cell = cell(false).await;
    let url = cell.controller.rws_url();
    let client = Client::new(config(&url, None)).unwrap();
    client.system().await.unwrap();
    let error = Client::new(config(&url, Some(OTHER))).unwrap_err();
    assert_eq!(error.code(), "robot_address", "{error}");
    assert!(error.to_string().contains("https"), "{error}");
    cell.controller.stop().await;
}

#[tokio::test]
async fn a_plain_http_server_at_an_https_address_is_unreachable_and_not_trusted() {
    let cell = cell(false).await;
    let url = cell.controller.rws_url().replace("http:", "https:");
    let client = Client::new(config(&url, Some(OTHER))).unwrap();
    let error = client.system().await.unwrap_err();
    assert!(error.is_unreachable(), "{error}");
    cell.controller.stop().await;
}

#[test]
fn a_pin_that_is_no_fingerprint_is_refused_at_once() {
    let error = Client::new(config("https://192.168.125.1", Some("AA:BB"))).unwrap_err();
    assert_eq!(error.code(), "robot_fingerprint");
    assert!(error.to_string().contains("AA:BB"));
}
