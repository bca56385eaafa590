//! Edit mastership: the right to move the program pointer. It must be given back.

use crate::{Client, RwsError};

impl Client {
    /// Asks for edit mastership.
    ///
    /// # Errors
    /// [`RwsError::Refused`] while someone else holds it.
    pub async fn request_edit_mastership(&self) -> Result<(), RwsError> {
        self.post("/rw/mastership/edit/request", &[])
            .await
            .map(|_| ())
    }

    /// Gives edit mastership back.
    ///
    /// # Errors
    /// As for every call.
    pub async fn release_edit_mastership(&self) -> Result<(), RwsError> {
        self.post("/rw/mastership/edit/release", &[])
            .await
            .map(|_| ())
    }
}
