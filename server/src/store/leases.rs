//! Leases on jobs. Whoever holds a lease's token may write; everybody else's writes change
//! nothing, so a worker that was thought dead can't overwrite the one that took over.

use sqlx::{Row, Sqlite, Transaction};

use super::jobs::{Job, JobProgress, JobState, from_row};
use super::models::{ModelState, TrainedModel, give_up, make_ready};
use super::text::Failure;
use super::{Result, Store};
use crate::clock::WallTime;
use crate::ids::JobId;

/// The right to work on a job, for a while.
#[derive(Clone, Debug)]
pub struct Lease {
    /// The job.
    pub job_id: JobId,
    /// Proves that the lease is still ours.
    pub token: String,
}

impl Store {
    /// Takes the oldest job that waits or whose lease ran out, under a new lease.
    pub async fn claim_job(
        &self,
        token: &str,
        now: WallTime,
        until: WallTime,
    ) -> Result<Option<(Job, Lease)>> {
        let row = sqlx::query(
            "UPDATE job SET state = 'running', lease_token = ?1, lease_until_ms = ?2, \
             attempt = attempt + 1, started_at_ms = ?3 \
             WHERE id = (SELECT id FROM job WHERE attempt < max_attempts AND \
             ((state = 'queued' AND not_before_ms <= ?3) OR \
              (state = 'running' AND lease_until_ms <= ?3)) \
             ORDER BY created_at_ms, id LIMIT 1) RETURNING *",
        )
        .bind(token)
        .bind(until.0)
        .bind(now.0)
        .fetch_optional(&self.writer)
        .await?;
        let Some(row) = row else { return Ok(None) };
        let job = from_row(&row)?;
        let lease = Lease {
            job_id: job.id,
            token: token.to_owned(),
        };
        Ok(Some((job, lease)))
    }

    /// Prolongs a lease. False: it is lost, and the work must stop.
    pub async fn renew_lease(&self, lease: &Lease, until: WallTime) -> Result<bool> {
        let changed =
            sqlx::query("UPDATE job SET lease_until_ms = ? WHERE id = ? AND lease_token = ?")
                .bind(until.0)
                .bind(lease.job_id.to_string())
                .bind(&lease.token)
                .execute(&self.writer)
                .await?
                .rows_affected();
        Ok(changed == 1)
    }

    /// Writes down how far a job is. False: the lease is lost.
    pub async fn save_progress(&self, lease: &Lease, progress: &JobProgress) -> Result<bool> {
        let changed = sqlx::query(
            "UPDATE job SET stage = ?, words = ?, done = ?, total = ?, fraction = ? \
             WHERE id = ? AND lease_token = ?",
        )
        .bind(&progress.stage)
        .bind(&progress.words)
        .bind(progress.done.cast_signed())
        .bind(progress.total.cast_signed())
        .bind(progress.fraction)
        .bind(lease.job_id.to_string())
        .bind(&lease.token)
        .execute(&self.writer)
        .await?
        .rows_affected();
        Ok(changed == 1)
    }

    /// Ends a training with its model: job, model and file in one transaction. False: the lease
    /// is lost or the job was called off, and nothing was written.
    pub async fn finish_training(
        &self,
        lease: &Lease,
        trained: &TrainedModel,
        now: WallTime,
    ) -> Result<bool> {
        let mut transaction = self.begin().await?;
        let Some(model_id) = end(&mut transaction, lease, JobState::Succeeded, None, now).await?
        else {
            return Ok(false);
        };
        make_ready(&mut transaction, &model_id, trained).await?;
        transaction.commit().await?;
        Ok(true)
    }

    /// Ends a job that came to nothing, and its model. False: the lease is lost.
    pub async fn fail_job(&self, lease: &Lease, failure: &Failure, now: WallTime) -> Result<bool> {
        let mut transaction = self.begin().await?;
        let Some(model_id) = end(
            &mut transaction,
            lease,
            JobState::Failed,
            Some(failure),
            now,
        )
        .await?
        else {
            return Ok(false);
        };
        give_up(
            &mut transaction,
            &model_id,
            ModelState::Failed,
            Some(failure),
        )
        .await?;
        transaction.commit().await?;
        Ok(true)
    }

    /// Puts a job back into the queue until `not_before`. An attempt that was cut short by our
    /// own shutdown does not count. False: the lease is lost.
    pub async fn return_job(
        &self,
        lease: &Lease,
        not_before: WallTime,
        attempt_counts: bool,
    ) -> Result<bool> {
        let changed = sqlx::query(
            "UPDATE job SET state = 'queued', lease_token = NULL, lease_until_ms = NULL, \
             attempt = attempt - ?, not_before_ms = ? WHERE id = ? AND lease_token = ?",
        )
        .bind(i64::from(!attempt_counts))
        .bind(not_before.0)
        .bind(lease.job_id.to_string())
        .bind(&lease.token)
        .execute(&self.writer)
        .await?
        .rows_affected();
        Ok(changed == 1)
    }
}

/// Ends a job in `state` if the lease still holds, and returns the model's identifier.
async fn end(
    transaction: &mut Transaction<'static, Sqlite>,
    lease: &Lease,
    state: JobState,
    failure: Option<&Failure>,
    now: WallTime,
) -> Result<Option<String>> {
    let row = sqlx::query(
        "UPDATE job SET state = ?1, lease_token = NULL, lease_until_ms = NULL, \
         fraction = CASE WHEN ?1 = 'succeeded' THEN 1.0 ELSE fraction END, \
         failure_code = ?2, failure_message = ?3, failure_advice = ?4, finished_at_ms = ?5 \
         WHERE id = ?6 AND lease_token = ?7 RETURNING model_id",
    )
    .bind(state.as_str())
    .bind(failure.map(|f| f.code.as_str()))
    .bind(failure.map(|f| f.message.as_str()))
    .bind(failure.map(|f| f.advice.as_str()))
    .bind(now.0)
    .bind(lease.job_id.to_string())
    .bind(&lease.token)
    .fetch_optional(&mut **transaction)
    .await?;
    Ok(row.map(|row| row.try_get("model_id")).transpose()?)
}
