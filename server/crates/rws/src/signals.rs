//! Inputs and outputs of the controller.

use crate::hal::Entries;
use crate::{Client, RwsError};

/// One signal.
#[derive(Debug, Clone, PartialEq)]
pub struct Signal {
    /// Its name in the controller's configuration.
    pub name: String,
    /// DI, DO, GI, GO, AI or AO.
    pub kind: String,
    /// Logical value.
    pub value: f64,
}

impl Client {
    /// Reads the signal `name`.
    ///
    /// # Errors
    /// [`RwsError::Missing`] when the controller has no such signal.
    pub async fn signal(&self, name: &str) -> Result<Signal, RwsError> {
        let path = format!("/rw/iosystem/signals/{name}");
        let text = self.get(&path).await?;
        let entries = Entries::parse(&path, &text)?;
        let entry = entries.with_field("lvalue")?;
        Ok(Signal {
            name: entry.optional_text("name"),
            kind: entry.optional_text("type"),
            value: entry.number("lvalue")?,
        })
    }

    /// Writes the signal `name`. Its access level must allow it.
    ///
    /// # Errors
    /// [`RwsError::Refused`] when the access level forbids it, [`RwsError::Missing`] when there
    /// is no such signal.
    pub async fn set_signal(&self, name: &str, value: f64) -> Result<(), RwsError> {
        let path = format!("/rw/iosystem/signals/{name}/set-value");
        self.post(&path, &[("lvalue", &value.to_string())])
            .await
            .map(|_| ())
    }
}
