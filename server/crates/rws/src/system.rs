//! Who the controller is.

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
}
