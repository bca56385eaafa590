//! The forms of an answer: resources and lists in JSON and XHTML, and refusals.

use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde_json::{Map, Value, json};

use super::negotiation::Format;
use crate::controller::Refusal;

/// ABB's code of a success.
const OK_CODE: u32 = 294_912;
/// ABB's codes of some refusals.
pub const HELD_BY_ANOTHER: i64 = -1_073_445_862;
pub const NO_MASTERSHIP: i64 = -4501;
const REJECTED: i64 = -1_073_445_881;
const WRONG_STATE: i64 = -1_073_442_809;

/// One resource, or one entry of a list.
pub struct Item {
    pub kind: &'static str,
    pub title: String,
    pub fields: Vec<(&'static str, String)>,
}

impl Item {
    /// A resource without a field.
    pub fn new(kind: &'static str, title: impl Into<String>) -> Self {
        Self {
            kind,
            title: title.into(),
            fields: Vec::new(),
        }
    }

    /// The same with another field; the order matters to clients that read XHTML by position.
    pub fn with(mut self, name: &'static str, value: impl ToString) -> Self {
        self.fields.push((name, value.to_string()));
        self
    }

    fn json(&self) -> Value {
        let mut object = Map::new();
        object.insert("_type".to_owned(), self.kind.into());
        object.insert("_title".to_owned(), self.title.clone().into());
        for (name, value) in &self.fields {
            object.insert((*name).to_owned(), value.clone().into());
        }
        object.into()
    }

    fn xhtml(&self) -> String {
        let mut out = format!(
            "<li class=\"{}\" title=\"{}\">",
            self.kind,
            escape(&self.title)
        );
        for (name, value) in &self.fields {
            out += &format!("<span class=\"{name}\">{}</span>", escape(value));
        }
        out + "</li>"
    }
}

/// Answers with one resource.
pub fn single(format: Format, item: &Item) -> Response {
    match format {
        Format::Json => json_body(json!({"state": [item.json()]})),
        Format::Xhtml => xhtml_body(&item.xhtml()),
    }
}

/// Answers with a list.
pub fn list(format: Format, items: &[Item]) -> Response {
    match format {
        Format::Json => {
            let resources: Vec<Value> = items.iter().map(Item::json).collect();
            json_body(json!({"_embedded": {"resources": resources}}))
        }
        Format::Xhtml => xhtml_body(&items.iter().map(Item::xhtml).collect::<String>()),
    }
}

fn json_body(mut body: Value) -> Response {
    body["_links"] = json!({"base": {"href": "/"}, "self": {"href": ""}});
    body["status"] = json!({"code": OK_CODE});
    (
        [(header::CONTENT_TYPE, Format::Json.content_type())],
        body.to_string(),
    )
        .into_response()
}

fn xhtml_body(entries: &str) -> Response {
    (
        [(header::CONTENT_TYPE, Format::Xhtml.content_type())],
        document(&format!("<div class=\"state\"><ul>{entries}</ul></div>")),
    )
        .into_response()
}

/// An XHTML document.
pub fn document(body: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\
         <html xmlns=\"http://www.w3.org/1999/xhtml\"><head><title>rws</title><base href=\"/\"/></head>\
         <body>{body}</body></html>"
    )
}

/// Text as it may stand in XHTML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// A refusal. Handlers return it; [`super::guard`] writes it in the form the request accepts.
#[derive(Clone, Debug)]
pub struct Problem {
    status: StatusCode,
    code: i64,
    message: String,
}

impl Problem {
    /// A refusal with a status and ABB's code.
    pub fn new(status: StatusCode, code: i64, message: impl Into<String>) -> Self {
        Self {
            status,
            code,
            message: message.into(),
        }
    }

    /// A refusal that says no more than its status.
    pub fn of_status(status: StatusCode) -> Self {
        let message = status.canonical_reason().unwrap_or("refused");
        Self::new(status, i64::from(status.as_u16()), message)
    }

    /// The request makes no sense.
    pub fn bad_request(message: impl Into<String>) -> Self {
        Self::new(StatusCode::BAD_REQUEST, 400, message)
    }

    /// There is no such thing.
    pub fn missing(message: impl Into<String>) -> Self {
        Self::new(StatusCode::NOT_FOUND, 404, message)
    }

    /// Not now.
    pub fn unavailable(message: &str) -> Self {
        Self::new(StatusCode::SERVICE_UNAVAILABLE, 503, message)
    }

    /// Writes it.
    pub fn render(self, format: Format) -> Response {
        let message = format!("rws_controller.cpp[1] {} code:{}", self.message, self.code);
        let body = match format {
            Format::Json => json!({"status": {"code": self.code, "msg": message}}).to_string(),
            Format::Xhtml => document(&format!(
                "<div class=\"status\"><span class=\"code\">{}</span><span class=\"msg\">{}</span></div>",
                self.code,
                escape(&message)
            )),
        };
        (
            self.status,
            [(header::CONTENT_TYPE, format.content_type())],
            body,
        )
            .into_response()
    }
}

impl IntoResponse for Problem {
    fn into_response(self) -> Response {
        let mut response = self.status.into_response();
        response.extensions_mut().insert(self);
        response
    }
}

impl From<Refusal> for Problem {
    fn from(refusal: Refusal) -> Self {
        let (status, code) = match refusal {
            Refusal::WrongState(_) => (StatusCode::FORBIDDEN, WRONG_STATE),
            Refusal::Rejected => (StatusCode::FORBIDDEN, REJECTED),
            Refusal::Missing(_) => (StatusCode::NOT_FOUND, 404),
        };
        Self::new(status, code, refusal.to_string())
    }
}
