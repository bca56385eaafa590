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
