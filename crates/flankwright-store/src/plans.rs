//! Plans: what was planned for which job by which version, with the whole result.

use flankwright::exchange::Diagnostic;
use serde_json::Value;
use sqlx::types::Json;

use crate::catalogue::unwritable;
use crate::check;
use crate::digest::digest_of;
use crate::error::StoreError;
use crate::pool::{on_pool, on_writing};
use crate::records::{PlanRecord, PlanSummary};
use crate::store::Store;

/// The only part of a result that differs between two runs of the same job.
pub(crate) const TIMING: &str = "timing_s";

impl PlanRecord {
    /// A plan from the document of its `result.json` and the bytes of its job.
    ///
    /// # Errors
    /// `invalid-record` for a document without job, status or version.
    pub fn of_result(document: Value, job: &[u8]) -> Result<Self, StoreError> {
        let text =
            |key: &str| {
                let value = document.get(key);
                value.and_then(Value::as_str).map(str::to_owned).ok_or_else(|| {
                    Diagnostic::with_code("invalid-record", format!("the document has no text `{key}`"))
                        .field(key)
                        .value(value.map_or("nothing".to_owned(), |value| {
                            value.to_string().chars().take(60).collect()
                        }))
                        .allowed("a `result.json` with job, status and version")
                        .way_out("give the result.json that `flankwright plan` wrote")
                })
            };
        let (name, status, version) = (text("job")?, text("status")?, text("version")?);
        Ok(Self { job: name, digest: digest_of(job), status, version, document })
    }
}

impl Store {
    /// Adds a plan. `false` if the same result of the same job is there already; times of computation do not count.
    ///
    /// # Errors
    /// `invalid-record`; those of the database.
    pub async fn add_plan(&self, plan: &PlanRecord) -> Result<bool, StoreError> {
        check::plan(plan)?;
        let result_digest = digest_without_times(&plan.document)?;
        let added = async {
            let mut writing = self.pool.write().await?;
            let added = on_writing!(&mut writing, connection => {
                sqlx::query(
                    "INSERT INTO plan (job, job_digest, result_digest, status, version, document) \
                     VALUES ($1, $2, $3, $4, $5, $6) ON CONFLICT (job_digest, result_digest) DO NOTHING",
                )
                .bind(&plan.job)
                .bind(&plan.digest)
                .bind(&result_digest)
                .bind(&plan.status)
                .bind(&plan.version)
                .bind(Json(&plan.document))
                .execute(connection)
                .await?
                .rows_affected()
            });
            writing.commit().await?;
            Ok(added > 0)
        };
        self.done(added.await)
    }

    /// All plans in the order in which they came.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn plans(&self) -> Result<Vec<PlanSummary>, StoreError> {
        let rows: Result<Vec<(i64, String, String, String, String)>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT id, job, job_digest, status, version FROM plan ORDER BY id").fetch_all(pool).await
        });
        let summary = |(id, job, digest, status, version)| PlanSummary { id, job, digest, status, version };
        Ok(self.done(rows)?.into_iter().map(summary).collect())
    }

    /// A plan by its number; `None` if there is none.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn plan(&self, id: i64) -> Result<Option<PlanRecord>, StoreError> {
        let row: Result<Option<(String, String, String, String, Json<Value>)>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT job, job_digest, status, version, document FROM plan WHERE id = $1")
                .bind(id)
                .fetch_optional(pool)
                .await
        });
        let record = |(job, digest, status, version, Json(document))| PlanRecord {
            job,
            digest,
            status,
            version,
            document,
        };
        Ok(self.done(row)?.map(record))
    }
}

fn digest_without_times(document: &Value) -> Result<String, StoreError> {
    let mut document = document.clone();
    if let Value::Object(entries) = &mut document {
        entries.remove(TIMING);
    }
    let text = serde_json::to_string(&document).map_err(|error| unwritable(&error))?;
    Ok(digest_of(text.as_bytes()))
}
