//! Who the controller is, what it can do, and what time it has.

use crate::hal::Entries;
use crate::{Client, RwsError};

/// Name and software of the controller.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct System {
    /// Name of the system.
    pub name: String,
    /// RobotWare version, for example `7.20.0+1391`.
    pub robotware: String,
}

impl Client {
    /// Reads `/rw/system`.
    ///
    /// # Errors
    /// As for every call.
    pub async fn system(&self) -> Result<System, RwsError> {
        let path = "/rw/system";
        let text = self.get(path).await?;
        let entries = Entries::parse(path, &text)?;
        let entry = entries.with_field("rwversion")?;
        Ok(System {
            name: entry.optional_text("name"),
            robotware: entry.text("rwversion")?,
        })
    }

    /// Reads the options that are installed, for example `3124-1 Externally Guided Motion`.
    ///
    /// # Errors
    /// As for every call.
    pub async fn options(&self) -> Result<Vec<String>, RwsError> {
        let path = "/rw/system/options";
        let text = self.get(path).await?;
        let entries = Entries::parse(path, &text)?;
        Ok(entries
            .all()
            .flat_map(|entry| entry.texts("option"))
            .collect())
    }

    /// Reads the controller's clock, as it writes it: `YYYY-MM-DD T HH:MM:SS`, in the time zone
    /// that it is set to.
    ///
    /// # Errors
    /// As for every call.
    pub async fn clock(&self) -> Result<String, RwsError> {
        let path = "/ctrl/clock";
        let text = self.get(path).await?;
        Entries::parse(path, &text)?
            .with_field("datetime")?
            .text("datetime")
    }
}
