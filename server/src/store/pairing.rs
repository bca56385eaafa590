//! Sessions of paired phones. Only a hash of the cookie is stored, so the file gives no access.

use super::{Result, Store};
use crate::clock::WallTime;

impl Store {
    /// Remembers a paired client until `expires`, and forgets the ones that have expired.
    pub async fn add_pairing(
        &self,
        token_sha256: &[u8; 32],
        address: &str,
        now: WallTime,
        expires: WallTime,
    ) -> Result<()> {
        let mut transaction = self.begin().await?;
        sqlx::query("DELETE FROM pairing_session WHERE expires_at_ms <= ?")
            .bind(now.0)
            .execute(&mut *transaction)
            .await?;
        sqlx::query(
            "INSERT INTO pairing_session (token_sha256, created_at_ms, expires_at_ms, address) \
             VALUES (?, ?, ?, ?)",
        )
        .bind(token_sha256.as_slice())
        .bind(now.0)
        .bind(expires.0)
        .bind(address)
        .execute(&mut *transaction)
        .await?;
        transaction.commit().await?;
        Ok(())
    }

    /// Whether a client with this cookie is paired.
    pub async fn is_paired(&self, token_sha256: &[u8; 32], now: WallTime) -> Result<bool> {
        let row = sqlx::query(
            "SELECT 1 FROM pairing_session WHERE token_sha256 = ? AND expires_at_ms > ?",
        )
        .bind(token_sha256.as_slice())
        .bind(now.0)
        .fetch_optional(&self.readers)
        .await?;
        Ok(row.is_some())
    }
}
