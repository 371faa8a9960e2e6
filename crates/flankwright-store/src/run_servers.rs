//! Servers that carry runs out: each tells from time to time that it lives. Runs of one that is gone, or that has sent no sign of life for a
//! while, are reported as interrupted; what had ended stays whole. Time is that of the database, so that clocks of stations may differ.

use std::time::Duration;

use crate::error::StoreError;
use crate::pool::{Writing, on_writing};
use crate::store::Store;

/// Seconds of the database's clock.
fn clock(writing: &Writing) -> &'static str {
    match writing {
        Writing::Sqlite(_) => "unixepoch()",
        Writing::Postgres(_) => "CAST(extract(epoch FROM clock_timestamp()) AS BIGINT)",
    }
}

impl Store {
    /// Tells that the server `owner` lives, and forgets those that are known to be `gone` or have been silent for longer than `silence`:
    /// their runs are interrupted. How many runs that were. A server that was silent for so long itself drops no other: the machine slept, and the
    /// others may be about to beat.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn beat(
        &self,
        owner: &str,
        gone: &[String],
        silence: Duration,
        ended: &str,
    ) -> Result<u64, StoreError> {
        let beaten = async {
            let mut writing = self.pool.write().await?;
            let clock = clock(&writing);
            let seen = format!(
                "INSERT INTO run_server (owner, seen) VALUES ($1, {clock}) ON CONFLICT (owner) DO UPDATE SET seen = excluded.seen"
            );
            let silent = format!("DELETE FROM run_server WHERE seen < {clock} - $1");
            let silence = i64::try_from(silence.as_secs()).unwrap_or(i64::MAX);
            let awake = format!("SELECT count(*) FROM run_server WHERE owner = $1 AND seen >= {clock} - $2");
            on_writing!(&mut writing, connection => {
                let awake: i64 = sqlx::query_scalar(sqlx::AssertSqlSafe(awake))
                    .bind(owner)
                    .bind(silence)
                    .fetch_one(&mut *connection)
                    .await?;
                sqlx::query(sqlx::AssertSqlSafe(seen)).bind(owner).execute(&mut *connection).await?;
                if awake > 0 {
                    sqlx::query(sqlx::AssertSqlSafe(silent)).bind(silence).execute(&mut *connection).await?;
                }
                for owner in gone {
                    sqlx::query(FORGET).bind(owner).execute(&mut *connection).await?;
                }
            });
            let interrupted = interrupt(&mut writing, ended).await?;
            writing.commit().await?;
            Ok(interrupted)
        };
        self.done(beaten.await)
    }

    /// Tells that the server `owner` ends: its runs are interrupted. How many there were.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn leave(&self, owner: &str, ended: &str) -> Result<u64, StoreError> {
        let left = async {
            let mut writing = self.pool.write().await?;
            on_writing!(&mut writing, connection => {
                sqlx::query(FORGET).bind(owner).execute(connection).await?;
            });
            let interrupted = interrupt(&mut writing, ended).await?;
            writing.commit().await?;
            Ok(interrupted)
        };
        self.done(left.await)
    }
}

const FORGET: &str = "DELETE FROM run_server WHERE owner = $1";

/// Whose server is not known any more has ended.
async fn interrupt(writing: &mut Writing, ended: &str) -> Result<u64, sqlx::Error> {
    Ok(on_writing!(writing, connection => {
        sqlx::query(
            "UPDATE run SET state = 'interrupted', ended = $1 WHERE state IN ('queued', 'running') \
             AND owner NOT IN (SELECT owner FROM run_server)",
        )
        .bind(ended)
        .execute(connection)
        .await?
        .rows_affected()
    }))
}
