//! Who did what, when. Events are only ever added.

use super::{Result, Store};
use crate::clock::WallTime;

impl Store {
    /// Writes down that `actor` did `action` to `subject`.
    pub async fn audit(
        &self,
        actor: &str,
        action: &str,
        subject: &str,
        now: WallTime,
    ) -> Result<()> {
        sqlx::query("INSERT INTO audit_event (at_ms, actor, action, subject) VALUES (?, ?, ?, ?)")
            .bind(now.0)
            .bind(actor)
            .bind(action)
            .bind(subject)
            .execute(&self.writer)
            .await?;
        Ok(())
    }

    /// Who did what, oldest first: actor, action and subject.
    #[cfg(test)]
    pub(crate) async fn audit_trail(&self) -> Result<Vec<(String, String, String)>> {
        let rows = sqlx::query_as("SELECT actor, action, subject FROM audit_event ORDER BY id");
        Ok(rows.fetch_all(&self.readers).await?)
    }
}
