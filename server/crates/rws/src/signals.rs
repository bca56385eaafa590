//! Inputs and outputs of the controller.

use crate::hal::{Entries, Entry};
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

/// So many signals the controller puts into one answer at most.
const PAGE: usize = 100;

impl Client {
    /// Reads all signals.
    ///
    /// # Errors
    /// As for every call.
    pub async fn signals(&self) -> Result<Vec<Signal>, RwsError> {
        let mut signals = Vec::new();
        loop {
            let path = format!("/rw/iosystem/signals?start={}&limit={PAGE}", signals.len());
            let text = self.get(&path).await?;
            let entries = Entries::parse(&path, &text)?;
            let before = signals.len();
            for entry in entries.of_type("ios-signal-li") {
                signals.push(Signal::of(&entry)?);
            }
            // An answer without a signal ends the list, whatever else it says.
            if !entries.has_more() || signals.len() == before {
                return Ok(signals);
            }
        }
    }

    /// Reads the signal `name`.
    ///
    /// # Errors
    /// [`RwsError::Missing`] when the controller has no such signal, or can have none of this
    /// name.
    pub async fn signal(&self, name: &str) -> Result<Signal, RwsError> {
        let path = path_of(name)?;
        let text = self.get(&path).await?;
        Signal::of(&Entries::parse(&path, &text)?.with_field("lvalue")?)
    }

    /// Writes the signal `name`. Its access level must allow it.
    ///
    /// # Errors
    /// [`RwsError::Refused`] when the access level forbids it, [`RwsError::Missing`] when there
    /// is no such signal.
    pub async fn set_signal(&self, name: &str, value: f64) -> Result<(), RwsError> {
        let path = format!("{}/set-value", path_of(name)?);
        self.post(&path, &[("lvalue", &value.to_string())])
            .await
            .map(|_| ())
    }
}

impl Signal {
    fn of(entry: &Entry<'_>) -> Result<Self, RwsError> {
        Ok(Self {
            name: entry.optional_text("name"),
            kind: entry.optional_text("type"),
            value: entry.number("lvalue")?,
        })
    }
}

/// The resource of a signal, which may be named with its network and device. Anything that is not
/// a name must not get into an address.
pub(crate) fn path_of(name: &str) -> Result<String, RwsError> {
    let path = format!("/rw/iosystem/signals/{name}");
    let is_name = |part: &str| {
        !part.is_empty()
            && part.chars().all(|character| {
                character.is_ascii_alphanumeric() || matches!(character, '_' | '-')
            })
    };
    if name.split('/').all(is_name) {
        Ok(path)
    } else {
        Err(RwsError::Missing { path })
    }
}
