//! The embedded pages.

use axum::body::Body;
use axum::http::header;

use super::{Api, request};

#[tokio::test]
async fn the_page_is_served_under_its_own_paths_too() {
    let api = Api::local().await;
    let page = api.get("/").await;
    assert_eq!(page.status, 200);
    assert_eq!(page.header("content-type"), "text/html; charset=utf-8");
    for path in ["/teach", "/run/whatever", "/index.html"] {
        let same = api.get(path).await;
        assert_eq!(
            (same.status.as_u16(), same.text),
            (200, page.text.clone()),
            "{path}"
        );
    }
}

#[tokio::test]
async fn a_browser_that_has_the_page_gets_no_copy() {
    let api = Api::local().await;
    let page = api.get("/").await;
    let mut again = request("GET", "/", Body::empty());
    let etag = page.headers[header::ETAG].clone();
    again.headers_mut().insert(header::IF_NONE_MATCH, etag);
    let again = api.send(again).await;
    assert_eq!((again.status.as_u16(), again.text.as_str()), (304, ""));
}

#[tokio::test]
async fn files_with_a_hash_in_their_name_are_kept_for_ever() {
    let api = Api::local().await;
    for name in webapp::names() {
        let file = api.get(&format!("/{name}")).await;
        assert_eq!(file.status, 200, "{name}");
        let immutable = file.header("cache-control").contains("immutable");
        assert_eq!(immutable, name.starts_with("assets/"), "{name}");
    }
}

async fn fetch(api: &Api, path: &str, name: header::HeaderName, value: &str) -> super::Answer {
    let mut wanted = request("GET", path, Body::empty());
    wanted
        .headers_mut()
        .insert(name, value.parse().expect("a header"));
    api.send(wanted).await
}

#[tokio::test]
async fn files_are_packed_for_browsers_that_can_unpack_them() {
    let api = Api::local().await;
    for name in webapp::names() {
        let path = format!("/{name}");
        let asset = webapp::asset(name).unwrap();
        for (accept, encoding, packed) in [
            ("gzip, deflate, br, zstd", "br", asset.brotli),
            ("*", "br", asset.brotli),
            ("br;q=0, gzip;q=0.5", "gzip", asset.gzip),
            ("GZIP", "gzip", asset.gzip),
            ("gzip;q=0, br;q=0, *", "", None),
            ("br; q=0", "", None),
            ("identity", "", None),
            ("nonsense;q=much", "", None),
        ] {
            let answer = fetch(&api, &path, header::ACCEPT_ENCODING, accept).await;
            assert_eq!(answer.status, 200, "{name} {accept}");
            assert_eq!(answer.header("content-type"), asset.mime);
            assert_eq!(answer.header("vary"), "Accept-Encoding");
            let told = answer.headers.get(header::CONTENT_ENCODING);
            let expected = packed.is_some().then_some(encoding);
            assert_eq!(
                told.and_then(|value| value.to_str().ok()),
                expected,
                "{name} {accept}"
            );
            let length = packed.map_or(asset.bytes.len(), <[u8]>::len);
            assert_eq!(answer.bytes, length, "{name} {accept}");
        }
    }
}

#[tokio::test]
async fn each_packing_has_its_own_tag() {
    let api = Api::local().await;
    let plain = api.get("/").await;
    let packed = fetch(&api, "/", header::ACCEPT_ENCODING, "gzip").await;
    let is_packed = packed.headers.contains_key(header::CONTENT_ENCODING);
    assert_eq!(plain.header("etag") != packed.header("etag"), is_packed);
    let known = format!("\"other\", W/{}", plain.header("etag"));
    let again = fetch(&api, "/", header::IF_NONE_MATCH, &known).await;
    assert_eq!(again.status, 304);
    assert_eq!(again.header("vary"), "Accept-Encoding");
}
