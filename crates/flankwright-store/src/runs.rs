//! Runs of a server: a submitted job, its state, and once it has ended its document and files. What becomes of runs whose server
//! is gone is decided in `run_servers.rs`.

use flankwright::workflow::Task;
use serde_json::Value;
use sqlx::types::Json;

use crate::error::StoreError;
use crate::pool::{Writing, on_pool, on_writing};
use crate::records::{NewRun, RunEnd, RunFile, RunFileSummary, RunRecord, RunState, RunSummary};
use crate::store::Store;

type SummaryRow = (i64, String, String, String, String, Option<String>, Option<String>);

fn summary((id, kind, name, state, created, ended, status): SummaryRow) -> Result<RunSummary, sqlx::Error> {
    let task = Task::ALL.into_iter().find(|task| task.name() == kind);
    let kind = task.ok_or_else(|| sqlx::Error::Decode(format!("kind {kind}").into()))?;
    let state = RunState::of(&state).ok_or_else(|| sqlx::Error::Decode(format!("state {state}").into()))?;
    Ok(RunSummary { id, kind, name, state, created, ended, status })
}

async fn put_files(
    writing: &mut Writing,
    run: i64,
    handed_in: bool,
    files: &[RunFile],
) -> Result<(), sqlx::Error> {
    for (place, file) in files.iter().enumerate() {
        on_writing!(&mut *writing, connection => {
            sqlx::query("INSERT INTO run_file (run, handed_in, name, place, bytes) VALUES ($1, $2, $3, $4, $5)")
                .bind(run)
                .bind(handed_in)
                .bind(&file.name)
                .bind(place as i64)
                .bind(&file.bytes)
                .execute(connection)
                .await?
                .rows_affected()
        });
    }
    Ok(())
}

impl Store {
    /// Takes a run in, queued, with the uploaded files; its number.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn add_run(&self, run: &NewRun) -> Result<i64, StoreError> {
        let added = async {
            let mut writing = self.pool.write().await?;
            let id: i64 = on_writing!(&mut writing, connection => {
                sqlx::query_scalar(
                    "INSERT INTO run (owner, kind, name, job, state, created) VALUES ($1, $2, $3, $4, 'queued', $5) RETURNING id",
                )
                .bind(&run.owner)
                .bind(run.kind.name())
                .bind(&run.name)
                .bind(&run.job)
                .bind(&run.created)
                .fetch_one(connection)
                .await?
            });
            put_files(&mut writing, id, true, &run.files).await?;
            writing.commit().await?;
            Ok(id)
        };
        self.done(added.await)
    }

    /// Tells that a queued run has begun. `false` if it is not queued any more.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn begin_run(&self, id: i64) -> Result<bool, StoreError> {
        let begun = async {
            let mut writing = self.pool.write().await?;
            let begun = on_writing!(&mut writing, connection => {
                sqlx::query("UPDATE run SET state = 'running' WHERE id = $1 AND state = 'queued'")
                    .bind(id)
                    .execute(connection)
                    .await?
                    .rows_affected()
            });
            writing.commit().await?;
            Ok(begun > 0)
        };
        self.done(begun.await)
    }

    /// Tells how a run has ended, with its document and all its files, whole or not at all. `false` if it had ended before.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn end_run(&self, id: i64, end: &RunEnd) -> Result<bool, StoreError> {
        let ended = async {
            let mut writing = self.pool.write().await?;
            let changed = on_writing!(&mut writing, connection => {
                sqlx::query(
                    "UPDATE run SET state = $2, ended = $3, document = $4, status = $5 WHERE id = $1 AND state IN ('queued', 'running')",
                )
                .bind(id)
                .bind(end.state.name())
                .bind(&end.ended)
                .bind(end.document.as_ref().map(Json))
                .bind(end.document.as_ref().and_then(|document| document.get("status")?.as_str()))
                .execute(connection)
                .await?
                .rows_affected()
            });
            if changed == 0 {
                return Ok(false);
            }
            put_files(&mut writing, id, false, &end.files).await?;
            writing.commit().await?;
            Ok(true)
        };
        self.done(ended.await)
    }

    /// The newest runs, newest first.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn runs(&self, most: u32) -> Result<Vec<RunSummary>, StoreError> {
        let rows: Result<Vec<SummaryRow>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT id, kind, name, state, created, ended, status FROM run ORDER BY id DESC LIMIT $1")
                .bind(i64::from(most))
                .fetch_all(pool)
                .await
        });
        self.done(rows.and_then(|rows| rows.into_iter().map(summary).collect()))
    }

    /// A run by its number, with the names of its files; `None` if there is none.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn run(&self, id: i64) -> Result<Option<RunRecord>, StoreError> {
        type Row = (
            i64,
            String,
            String,
            String,
            String,
            Option<String>,
            Option<String>,
            String,
            Option<Json<Value>>,
        );
        let row: Result<Option<Row>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT id, kind, name, state, created, ended, status, job, document FROM run WHERE id = $1")
                .bind(id)
                .fetch_optional(pool)
                .await
        });
        let Some((id, kind, name, state, created, ended, status, job, document)) = self.done(row)? else {
            return Ok(None);
        };
        let files: Result<Vec<(String, i64)>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT name, CAST(length(bytes) AS BIGINT) FROM run_file WHERE run = $1 AND handed_in = $2 ORDER BY place")
                .bind(id)
                .bind(false)
                .fetch_all(pool)
                .await
        });
        let file = |(name, bytes): (String, i64)| RunFileSummary { name, bytes: bytes.unsigned_abs() };
        Ok(Some(RunRecord {
            summary: self.done(summary((id, kind, name, state, created, ended, status)))?,
            job,
            document: document.map(|Json(document)| document),
            files: self.done(files)?.into_iter().map(file).collect(),
        }))
    }

    /// What lists show of a run; `None` if there is none.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn run_summary(&self, id: i64) -> Result<Option<RunSummary>, StoreError> {
        let row: Result<Option<SummaryRow>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT id, kind, name, state, created, ended, status FROM run WHERE id = $1")
                .bind(id)
                .fetch_optional(pool)
                .await
        });
        self.done(row.and_then(|row| row.map(summary).transpose()))
    }

    /// Names of the files that were uploaded with a run, in their order.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn run_input_names(&self, id: i64) -> Result<Vec<String>, StoreError> {
        let names = on_pool!(&self.pool, pool => {
            sqlx::query_scalar("SELECT name FROM run_file WHERE run = $1 AND handed_in = $2 ORDER BY place")
                .bind(id)
                .bind(true)
                .fetch_all(pool)
                .await
        });
        self.done(names)
    }

    /// The files that were uploaded with a run, in their order.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn run_inputs(&self, id: i64) -> Result<Vec<RunFile>, StoreError> {
        let files: Result<Vec<(String, Vec<u8>)>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT name, bytes FROM run_file WHERE run = $1 AND handed_in = $2 ORDER BY place")
                .bind(id)
                .bind(true)
                .fetch_all(pool)
                .await
        });
        Ok(self.done(files)?.into_iter().map(|(name, bytes)| RunFile { name, bytes }).collect())
    }

    /// A file of a run; `None` if there is none of that name.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn run_file(&self, id: i64, name: &str) -> Result<Option<RunFile>, StoreError> {
        let row: Result<Option<Vec<u8>>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_scalar("SELECT bytes FROM run_file WHERE run = $1 AND name = $2 AND handed_in = $3")
                .bind(id)
                .bind(name)
                .bind(false)
                .fetch_optional(pool)
                .await
        });
        Ok(self.done(row)?.map(|bytes| RunFile { name: name.to_owned(), bytes }))
    }

    /// Takes a run that has ended out, with its files. `false` if there is none, or if it has not ended.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn remove_run(&self, id: i64) -> Result<bool, StoreError> {
        let removed = async {
            let mut writing = self.pool.write().await?;
            let count = on_writing!(&mut writing, connection => {
                sqlx::query("DELETE FROM run WHERE id = $1 AND state NOT IN ('queued', 'running')")
                    .bind(id)
                    .execute(connection)
                    .await?
                    .rows_affected()
            });
            writing.commit().await?;
            Ok(count > 0)
        };
        self.done(removed.await)
    }
}
