//! Reading the controller's answers: where the fields are, and what to do with its mistakes.
//!
//! In JSON (HAL) single resources carry their fields in `state[0]`, lists in
//! `_embedded.resources[]`; every value is a string. XHTML, which some resources have alone, is
//! brought into the same shape by [`crate::xhtml`].

use crate::{RwsError, xhtml};
use serde_json::{Map, Value};

/// The entries of an answer: one for a single resource, any number for a list.
#[derive(Debug)]
pub(crate) struct Entries<'a> {
    path: &'a str,
    entries: Vec<Map<String, Value>>,
    more: bool,
}

impl<'a> Entries<'a> {
    /// Finds the entries in the text of an answer to `path`.
    pub(crate) fn parse(path: &'a str, text: &str) -> Result<Self, RwsError> {
        let unreadable = |reason: String| RwsError::Unreadable {
            path: path.to_owned(),
            reason,
        };
        if is_xhtml(text) {
            let entries = xhtml::entries(text);
            return Ok(Self {
                path,
                entries,
                more: text.contains("rel=\"next\""),
            });
        }
        let document: Value = serde_json::from_str(text)
            .or_else(|_| serde_json::from_str(&without_leading_zeros(text)))
            .map_err(|error| unreadable(error.to_string()))?;
        let list = [
            document.pointer("/_embedded/resources"),
            document.pointer("/state"),
            document.pointer("/_embedded/_state"),
        ]
        .into_iter()
        .flatten()
        .find_map(Value::as_array)
        .ok_or_else(|| unreadable("it holds no resource".to_owned()))?;
        let entries = list
            .iter()
            .filter_map(|entry| entry.as_object().cloned())
            .collect();
        let more = document.pointer("/_links/next").is_some();
        Ok(Self {
            path,
            entries,
            more,
        })
    }

    /// Whether the list goes on in another answer.
    pub(crate) fn has_more(&self) -> bool {
        self.more
    }

    /// All entries.
    pub(crate) fn all(&self) -> impl Iterator<Item = Entry<'_>> {
        self.entries.iter().map(|fields| Entry {
            path: self.path,
            fields,
        })
    }

    /// All entries of type `kind` (`_type`), each readable by field name.
    pub(crate) fn of_type(&self, kind: &str) -> impl Iterator<Item = Entry<'_>> {
        self.all()
            .filter(move |entry| entry.fields.get("_type").and_then(Value::as_str) == Some(kind))
    }

    /// The first entry that holds `field`. The type is not looked at, because controllers
    /// differ in it more than in the names of the fields.
    pub(crate) fn with_field(&self, field: &str) -> Result<Entry<'_>, RwsError> {
        self.all()
            .find(|entry| entry.fields.contains_key(field))
            .ok_or_else(|| RwsError::Unreadable {
                path: self.path.to_owned(),
                reason: format!("\"{field}\" is missing"),
            })
    }
}

/// One entry of an answer.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Entry<'a> {
    path: &'a str,
    fields: &'a Map<String, Value>,
}

impl Entry<'_> {
    /// A field as text; numbers and booleans are accepted as well.
    pub(crate) fn text(&self, field: &str) -> Result<String, RwsError> {
        match self.fields.get(field) {
            Some(Value::String(text)) => Ok(text.clone()),
            Some(value @ (Value::Number(_) | Value::Bool(_))) => Ok(value.to_string()),
            _ => Err(self.unreadable(format!("\"{field}\" is missing"))),
        }
    }

    /// A field as a finite number.
    pub(crate) fn number(&self, field: &str) -> Result<f64, RwsError> {
        let text = self.text(field)?;
        text.trim()
            .parse::<f64>()
            .ok()
            .filter(|value| value.is_finite())
            .ok_or_else(|| self.unreadable(format!("\"{field}\" is \"{text}\", not a number")))
    }

    /// A field that may be absent.
    pub(crate) fn optional_text(&self, field: &str) -> String {
        self.text(field).unwrap_or_default()
    }

    /// All texts of a field that holds one or several.
    pub(crate) fn texts(&self, field: &str) -> Vec<String> {
        match self.fields.get(field) {
            Some(Value::Array(values)) => values
                .iter()
                .filter_map(|value| value.as_str().map(str::to_owned))
                .collect(),
            _ => self.text(field).into_iter().collect(),
        }
    }

    fn unreadable(&self, reason: String) -> RwsError {
        RwsError::Unreadable {
            path: self.path.to_owned(),
            reason,
        }
    }
}

/// ABB's code and words in the body of a refusal, if it has any.
pub(crate) fn refusal(text: &str) -> (Option<i64>, String) {
    const NO_REASON: &str = "no reason given";
    if is_xhtml(text) {
        let code = xhtml::span(text, "code").and_then(|code| code.trim().parse().ok());
        let message = xhtml::span(text, "msg").unwrap_or_else(|| NO_REASON.to_owned());
        return (code, message);
    }
    let document: Value = serde_json::from_str(text).unwrap_or_default();
    let code = document.pointer("/status/code").and_then(Value::as_i64);
    let message = ["/status/msg", "/detail", "/message"]
        .into_iter()
        .find_map(|pointer| document.pointer(pointer).and_then(Value::as_str))
        .unwrap_or(NO_REASON);
    (code, message.to_owned())
}

fn is_xhtml(text: &str) -> bool {
    text.trim_start().starts_with('<')
}

/// Event-log arguments arrive as `-01`, which is not JSON: drops leading zeros of numbers
/// outside strings.
fn without_leading_zeros(text: &str) -> String {
    let mut fixed = String::with_capacity(text.len());
    let mut in_string = false;
    let mut escaped = false;
    let mut previous = ' ';
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        if in_string {
            in_string = escaped || character != '"';
            escaped = character == '\\' && !escaped;
        } else if character == '"' {
            in_string = true;
        } else if character == '0'
            && !previous.is_ascii_digit()
            && previous != '.'
            && characters.peek().is_some_and(char::is_ascii_digit)
        {
            continue;
        }
        previous = character;
        fixed.push(character);
    }
    fixed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_a_single_resource_and_a_list() {
        let single = r#"{"state":[{"_type":"pnl-ctrlstate","ctrlstate":"motoron"}]}"#;
        let entries = Entries::parse("/x", single).unwrap();
        let entry = entries.with_field("ctrlstate").unwrap();
        assert_eq!(entry.text("ctrlstate").unwrap(), "motoron");

        let list = r#"{"_embedded":{"resources":[{"_type":"a","n":"1.5"},{"_type":"b","n":"2"}]}}"#;
        let entries = Entries::parse("/x", list).unwrap();
        let numbers: Vec<f64> = entries
            .of_type("b")
            .map(|entry| entry.number("n").unwrap())
            .collect();
        assert_eq!(numbers, [2.0]);
    }

    #[test]
    fn tolerates_numbers_with_leading_zeros_but_leaves_text_alone() {
        let text = r#"{"state":[{"argv":[-01,007,10.05,0,0.5],"title":"code \"-01\" 007"}]}"#;
        let entries = Entries::parse("/x", text).unwrap();
        let entry = entries.with_field("title").unwrap();
        assert_eq!(entry.text("title").unwrap(), "code \"-01\" 007");
        assert_eq!(
            entry.fields["argv"],
            serde_json::json!([-1, 7, 10.05, 0, 0.5])
        );
    }

    #[test]
    fn says_what_is_missing() {
        let entries = Entries::parse("/rw/x", r#"{"state":[{"a":"NaN"}]}"#).unwrap();
        let missing = entries.with_field("b").unwrap_err().to_string();
        assert!(
            missing.contains("/rw/x") && missing.contains("\"b\""),
            "{missing}"
        );
        let entry = entries.with_field("a").unwrap();
        assert!(entry.number("a").is_err());
    }
}
