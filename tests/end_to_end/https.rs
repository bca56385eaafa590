//! HTTPS by one flag, as a phone sees it that has this cell's certificate installed and trusts
//! nobody else.

use std::sync::Arc;

use e2e::{Client, Folder, Process};
use futures_util::StreamExt;
use reqwest::StatusCode;
use rustls::pki_types::ServerName;
use rustls::{ClientConfig, RootCertStore};
use serde_json::json;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;
use tokio_rustls::TlsConnector;
use tokio_tungstenite::client_async;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;

use crate::steps::pairing_code;
use crate::{PROGRAM, SCRATCH};

const CERTIFICATE: &str = "//team-cell.crt";

async fn start(folder: &Folder) -> Process {
    let more = ["--robot", "none", "--https"];
    Process::start_on(PROGRAM, "0.0.0.0:0", folder.path(), &more).await
}

/// What a phone downloads over plain HTTP and installs.
async fn certificate(server: &Process) -> Vec<u8> {
    server.client().get(CERTIFICATE).await.expect_bytes(200)
}

/// The same address over HTTPS, for a client that trusts this certificate alone.
fn secured(server: &Process, certificate: &[u8]) -> Client {
    let base = server.client().base().replace("http://", "https://");
    Client::trusting(&base, certificate)
}

fn port(client: &Client) -> u16 {
    let port = client.base().rsplit(':').next().unwrap_or_default();
    port.parse().expect("a port")
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_phone_with_the_certificate_pairs_and_works_over_https() {
    let folder = Folder::new(SCRATCH, "https");
    let server = start(&folder).await;
    let offered = server.client().get(CERTIFICATE).await;
    assert_eq!(
        offered.header("content-type"),
        "application/x-x509-ca-cert",
        "with this type a phone offers to install it"
    );
    let certificate = certificate(&server).await;
    let phone = secured(&server, &certificate);
    assert_eq!(phone.get("/session").await.expect(200)["https"], true);
    assert!(phone.get("//").await.status.is_success());
    let _ = phone.get("/tasks").await.problem(&[401]);

    let code = pairing_code(&server).await;
    let paired = phone.post("/session", json!({ "code": code })).await;
    assert_eq!(paired.status, StatusCode::NO_CONTENT);
    let cookie = paired.header("set-cookie").to_owned();
    for part in [
        "__Host-team_session=",
        "; Secure",
        "HttpOnly",
        "SameSite=Strict",
        "Path=/",
    ] {
        assert!(cookie.contains(part), "{cookie}");
    }
    let cookie = cookie.split(';').next().unwrap_or_default();
    let own = phone.with_header("cookie", cookie);
    let own = own.with_header("origin", phone.base());
    assert_eq!(own.get("/tasks").await.expect(200), json!([]));
    let foreign = phone.with_header("cookie", cookie);
    for origin in ["https://evil.example", server.client().base()] {
        let foreign = foreign.with_header("origin", origin);
        let _ = foreign.get("/tasks").await.problem(&[403]);
    }

    live_over_tls(port(&phone), &certificate, cookie).await;
    server.terminate().await;
}

/// The live socket over TLS brings its snapshot.
async fn live_over_tls(port: u16, certificate: &[u8], cookie: &str) {
    let mut roots = RootCertStore::empty();
    let added = roots.add(certificate.to_vec().into());
    added.expect("it is the certificate of an authority");
    let config = ClientConfig::builder()
        .with_root_certificates(roots)
        .with_no_client_auth();
    let stream = TcpStream::connect(("127.0.0.1", port)).await;
    let stream = stream.expect("the port is open");
    let name = ServerName::try_from("127.0.0.1").expect("an address");
    let connector = TlsConnector::from(Arc::new(config));
    let stream = connector.connect(name, stream).await;
    let stream = stream.expect("the certificate is trusted");
    let mut request = format!("wss://127.0.0.1:{port}/api/v1/live")
        .into_client_request()
        .expect("a request");
    let cookie = cookie.parse().expect("a header");
    request.headers_mut().insert("cookie", cookie);
    let (mut socket, _) = client_async(request, stream)
        .await
        .expect("the socket opens");
    let first = socket.next().await.expect("a message").expect("no error");
    assert!(first.to_string().contains("\"snapshot\""), "{first}");
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_phone_without_the_certificate_works_over_plain_http_at_the_same_address() {
    let folder = Folder::new(SCRATCH, "https-plain");
    let server = start(&folder).await;
    let phone = server.client();
    let code = pairing_code(&server).await;
    let paired = phone.post("/session", json!({ "code": code })).await;
    let cookie = paired.header("set-cookie").to_owned();
    assert!(
        cookie.starts_with("team_session=") && !cookie.contains("Secure"),
        "{cookie}"
    );
    let cookie = cookie.split(';').next().unwrap_or_default();
    let own = phone.with_header("cookie", cookie);
    assert_eq!(own.get("/tasks").await.expect(200), json!([]));

    // What was read along on plain HTTP is no key to HTTPS, under whatever name.
    let secured = secured(&server, &certificate(&server).await);
    let token = cookie.trim_start_matches("team_session=");
    let stolen = secured.with_header("cookie", cookie);
    let _ = stolen.get("/tasks").await.problem(&[401]);
    assert!(!token.is_empty());

    let joining = own.get("/join").await.expect(200);
    assert_eq!(joining["code"], code);
    assert_eq!(
        joining["certificate_sha256"].as_str().map(str::len),
        Some(95)
    );
    let picture = own.get("/join.svg").await;
    assert_eq!(picture.header("content-type"), "image/svg+xml");
    assert!(picture.text().contains("<svg"));
    let _ = phone.get("/join").await.problem(&[401]);
    let _ = phone.get("/join.svg").await.problem(&[401]);
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_certificate_on_the_phones_outlives_every_restart() {
    let folder = Folder::new(SCRATCH, "https-restart");
    let server = start(&folder).await;
    let before = certificate(&server).await;
    server.kill().await;
    let server = start(&folder).await;
    assert_eq!(certificate(&server).await, before);
    let phone = secured(&server, &before);
    assert_eq!(phone.get("/health").await.expect(200)["status"], "ok");
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn old_tls_is_refused_and_silent_clients_keep_nobody_waiting() {
    let folder = Folder::new(SCRATCH, "https-old");
    let server = start(&folder).await;
    let port = port(&server.client());
    let connect = || TcpStream::connect(("127.0.0.1", port));
    let mut silent = Vec::new();
    for _ in 0..200 {
        silent.push(connect().await.expect("the port is open"));
    }
    // A record's kind (RFC 5246, 6.2.1 and 7.2): 22 goes on with the handshake, 21 is an alert, here
    // fatal (2) with protocol_version (70).
    let new = first_answer(port, 3).await;
    assert_eq!(new.first(), Some(&22), "{new:?}");
    for old in [2, 1] {
        let old = first_answer(port, old).await;
        assert_eq!(old.first(), Some(&21), "{old:?}");
        assert_eq!(old.get(5..7), Some(&[2, 70][..]), "{old:?}");
    }
    assert!(server.client().answers().await);
    server.terminate().await;
}

/// What the server says first to a client that offers this minor version of TLS at most: 3 is TLS
/// 1.2, 2 is TLS 1.1.
async fn first_answer(port: u16, minor: u8) -> Vec<u8> {
    let mut stream = TcpStream::connect(("127.0.0.1", port))
        .await
        .expect("the port is open");
    let hello = client_hello(minor);
    stream.write_all(&hello).await.expect("it is sent");
    let mut answer = vec![0; 16];
    let length = stream.read(&mut answer).await.expect("an answer");
    answer.truncate(length);
    answer
}

/// A handshake's first message (RFC 5246, 7.4.1.2) that names the curve, the signature and the
/// ciphers which go with the server's certificate, so that only the version is left to refuse.
fn client_hello(minor: u8) -> Vec<u8> {
    let mut body = vec![3, minor];
    body.extend([7; 32]);
    body.push(0);
    body.extend([0, 4, 0xc0, 0x2b, 0xc0, 0x09]);
    body.extend([1, 0]);
    let groups = [0, 10, 0, 4, 0, 2, 0, 23];
    let points = [0, 11, 0, 2, 1, 0];
    let signatures = [0, 13, 0, 4, 0, 2, 4, 3];
    body.extend([0, 22]);
    body.extend([&groups[..], &points, &signatures].concat());
    let length = u8::try_from(body.len()).expect("a short message");
    let mut record = vec![0x16, 3, 1, 0, length + 4, 1, 0, 0, length];
    record.extend(body);
    record
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn without_the_flag_there_is_no_certificate_and_no_folder_for_it() {
    let folder = Folder::new(SCRATCH, "https-off");
    let server = Process::start(PROGRAM, folder.path(), &["--robot", "none"]).await;
    let client = server.client();
    let _ = client.get(CERTIFICATE).await.problem(&[404]);
    assert_eq!(client.get("/session").await.expect(200)["https"], false);
    let joining = client.get("/join").await.expect(200);
    assert!(
        joining["address"].is_null() && joining["code"].is_null(),
        "{joining}"
    );
    let _ = client.get("/join.svg").await.problem(&[404]);
    assert!(!folder.path().join("https").exists());
    server.terminate().await;
}
