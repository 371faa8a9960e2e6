//! Whether a store is sound: what the database says of its own pages, what refers to nothing, what cannot be read any more; and how much
//! there is.

use crate::catalogue;
use crate::error::StoreError;
use crate::migrations;
use crate::pool::{Pool, on_pool};
use crate::reports::StoreHealth;
use crate::store::Store;

/// Faults of one kind that are reported; of a broken disk there may be thousands.
const TOLD: usize = 20;

impl Store {
    /// Looks through the whole store. A store that is damaged is no error: the faults tell.
    ///
    /// # Errors
    /// Those of the database, where it cannot even be asked.
    pub async fn health(&self) -> Result<StoreHealth, StoreError> {
        let mut faults = Vec::new();
        let kind = match &self.pool {
            Pool::Sqlite(pool) => {
                // Broken pages, rows that contradict their index, and rows that refer to nothing.
                let told: Vec<String> =
                    self.done(sqlx::query_scalar("PRAGMA integrity_check").fetch_all(pool).await)?;
                faults.extend(told.into_iter().filter(|line| line != "ok").take(TOLD));
                let lost = sqlx::query("PRAGMA foreign_key_check").fetch_all(pool).await;
                match self.done(lost)?.len() {
                    0 => {}
                    count => faults.push(format!("{count} rows refer to rows that are not there")),
                }
                "sqlite"
            }
            Pool::Postgres(_) => "postgresql",
        };
        let parts = self.count("SELECT count(*) FROM part").await?;
        // Parts are written with their values or not at all, so that each says how many it has.
        let torn = "SELECT count(*) FROM part p WHERE p.characteristics <> (SELECT count(*) FROM measured_value v WHERE v.part = p.id)";
        match self.count(torn).await? {
            0 => {}
            count => faults.push(format!("{count} parts have not all of their values")),
        }
        let (parts_with_files, torn) = self.content_faults(TOLD).await?;
        faults.extend(torn);
        for found in [
            self.catalogue().await.map(drop),
            self.history(None).await.map(drop),
            self.unreadable_documents().await,
        ] {
            match found {
                Ok(()) => {}
                Err(StoreError::Damaged { what, cause, .. }) => {
                    faults.push(format!("{what} cannot be read: {cause}"))
                }
                Err(error) => return Err(error),
            }
        }
        let tables = match migrations::version(&self.pool).await {
            Ok(version) => version.unwrap_or(0),
            Err(unfit) => return Err(self.unfit(unfit)),
        };
        Ok(StoreHealth {
            store: self.address().to_string(),
            kind,
            tables,
            parts,
            parts_with_files,
            file_bytes: self.content_bytes().await?,
            values: self.count("SELECT count(*) FROM measured_value").await?,
            bodies: self.count(catalogue::COUNT).await?,
            plans: self.count("SELECT count(*) FROM plan").await?,
            tool_measurements: self.count("SELECT count(*) FROM tool_measurement").await?,
            faults,
        })
    }

    async fn count(&self, statement: &'static str) -> Result<u64, StoreError> {
        let count: Result<i64, _> =
            on_pool!(&self.pool, pool => sqlx::query_scalar(statement).fetch_one(pool).await);
        Ok(self.done(count)?.unsigned_abs())
    }

    /// Documents that are no JSON; PostgreSQL does not take such.
    async fn unreadable_documents(&self) -> Result<(), StoreError> {
        let Pool::Sqlite(pool) = &self.pool else { return Ok(()) };
        for (what, statement) in [
            ("a part's document", "SELECT count(*) FROM part WHERE NOT json_valid(document)"),
            ("a part's statements", "SELECT count(*) FROM part_content WHERE NOT json_valid(stated)"),
            ("a plan's document", "SELECT count(*) FROM plan WHERE NOT json_valid(document)"),
        ] {
            let count: i64 = self.done(sqlx::query_scalar(statement).fetch_one(pool).await)?;
            if count > 0 {
                let address = self.address().to_string();
                return Err(StoreError::Damaged { address, what, cause: format!("{count} are no JSON") });
            }
        }
        Ok(())
    }
}
