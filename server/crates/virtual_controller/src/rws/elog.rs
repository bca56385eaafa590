//! `/rw/elog`: the event log.

use std::collections::HashMap;

use axum::extract::{Path, Query, State};
use axum::response::Response;

use super::App;
use super::negotiation::Format;
use super::reply::{self, Item, Problem};
use crate::events::{Event, Severity};

/// So many events an answer holds when the request does not say.
const PAGE: usize = 50;

pub async fn messages(
    State(app): State<App>,
    format: Format,
    Path(domain): Path<u32>,
    Query(query): Query<HashMap<String, String>>,
) -> Result<Response, Problem> {
    if domain > 15 {
        return Err(Problem::missing("no such domain"));
    }
    let limit = match query.get("limit") {
        None => PAGE,
        Some(text) => text
            .parse()
            .map_err(|_| Problem::bad_request(format!("invalid limit {text}")))?,
    };
    let controller = app.controller();
    let mut items: Vec<Item> = controller
        .events()
        .newest_first(domain)
        .map(|event| item(domain, event))
        .collect();
    if query.get("order").is_none_or(|order| order != "lifo") {
        items.reverse();
    }
    items.truncate(limit);
    Ok(reply::list(format, &items))
}

fn item(domain: u32, event: &Event) -> Item {
    let kind = match event.severity {
        Severity::Information => 1,
        Severity::Warning => 2,
        Severity::Error => 3,
    };
    Item::new(
        "elog-message-li",
        format!("/rw/elog/{domain}/{}", event.number),
    )
    .with("msgtype", kind)
    .with("code", event.code)
    .with("src-name", "MC0")
    .with("tstamp", event.at)
    .with("argc", 0)
    .with("title", event.title)
    .with("desc", &event.description)
}
