//! The controller's event log.

use crate::hal::Entries;
use crate::{Client, RwsError, elog_words};

/// Log domain of the safety controller.
pub const SAFETY_DOMAIN: u32 = 9;

/// Weight of an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventType {
    /// For information.
    Information,
    /// Warning.
    Warning,
    /// Error.
    Error,
}

/// One entry of the event log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EventMessage {
    /// The controller's own reference of the entry.
    pub reference: String,
    /// Weight.
    pub kind: EventType,
    /// ABB's event number, for example 90515.
    pub code: u32,
    /// The controller's local time, as it writes it.
    pub at: String,
    /// One line.
    pub title: String,
    /// What exactly, if the controller says so.
    pub description: String,
}

impl EventMessage {
    /// What to do about it.
    #[must_use]
    pub fn advice(&self) -> &'static str {
        elog_words::advice(self.code)
    }
}

/// In plain words where the event is known, with the controller's own title in any case.
impl std::fmt::Display for EventMessage {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { code, title, .. } = self;
        match (elog_words::explain(*code), title.as_str()) {
            (Some(words), "") => write!(formatter, "{} (event {code})", words.what),
            (Some(words), title) => write!(formatter, "{} (event {code}: {title})", words.what),
            (None, "") => write!(formatter, "event {code}"),
            (None, title) => write!(formatter, "{title} (event {code})"),
        }
    }
}

impl Client {
    /// Reads the newest `limit` entries of a log domain, newest first.
    ///
    /// # Errors
    /// As for every call.
    pub async fn events(&self, domain: u32, limit: u32) -> Result<Vec<EventMessage>, RwsError> {
        let path = format!("/rw/elog/{domain}?lang=en&order=lifo&limit={limit}");
        let text = self.get(&path).await?;
        let entries = Entries::parse(&path, &text)?;
        let messages = entries.of_type("elog-message-li").map(|entry| {
            let code = entry.text("code")?;
            Ok(EventMessage {
                reference: entry.optional_text("_title"),
                kind: match entry.optional_text("msgtype").as_str() {
                    "3" => EventType::Error,
                    "2" => EventType::Warning,
                    _ => EventType::Information,
                },
                code: code.parse().map_err(|_| RwsError::Unreadable {
                    path: path.clone(),
                    reason: format!("\"{code}\" is not an event number"),
                })?,
                at: entry.optional_text("tstamp"),
                title: entry.optional_text("title"),
                description: entry.optional_text("desc"),
            })
        });
        messages.collect()
    }
}
