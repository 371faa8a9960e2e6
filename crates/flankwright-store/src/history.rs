//! Histories of skiving tools: the lines of history files, under the rules of those files.

use std::collections::BTreeSet;

use flankwright::exchange::Source;
use flankwright::exchange::skiving_history::{History, HistoryRecord, extend_history, parse_history};
use serde::Deserialize;
use serde_json::Value;
use sqlx::types::Json;

use crate::catalogue::unwritable;
use crate::error::StoreError;
use crate::pool::{Writing, on_pool, on_writing};
use crate::records::ToolSummary;
use crate::reports::HistoryReport;
use crate::store::Store;

impl Store {
    /// Adds the measurements of a history behind those that are there, all or none. One that is there already, the same in all but the
    /// version of the program, is left as it is.
    ///
    /// # Errors
    /// `invalid-history` for another measurement of the same tool and time, or one against the order of the tool's times, workpieces
    /// and resharpenings; those of the database.
    pub async fn import_history(&self, history: &History) -> Result<HistoryReport, StoreError> {
        let records = history.records();
        let tools: BTreeSet<&str> = records.iter().map(|record| record.tool.as_str()).collect();
        let mut writing = self.done(self.pool.write().await)?;
        let mut there = Vec::new();
        for tool in tools {
            let rows = self.done(of_tool(&mut writing, tool).await)?;
            there.extend(self.decoded(rows)?);
        }
        // One tool after the other is an order as good as any: the rules are about each tool by itself.
        let mut text = String::new();
        for record in &there {
            text += &serde_json::to_string(record).map_err(|error| unwritable(&error))?;
            text.push('\n');
        }
        let there = parse_history(Source::new(self.address().to_string(), &text))?;
        let (_, added) = extend_history(&there, records)?;
        let report = HistoryReport { added: added.len(), known: records.len() - added.len() };
        for record in added {
            let value = serde_json::to_value(record).map_err(|error| unwritable(&error))?;
            self.done(insert(&mut writing, &record.tool, value).await)?;
        }
        self.done(writing.commit().await)?;
        Ok(report)
    }

    /// The measurements of one tool or of all, in the order in which they came.
    ///
    /// # Errors
    /// `damaged-store`; those of the database.
    pub async fn history(&self, tool: Option<&str>) -> Result<Vec<HistoryRecord>, StoreError> {
        let rows: Result<Vec<(Json<Value>,)>, _> = on_pool!(&self.pool, pool => {
            let all = "SELECT record FROM tool_measurement ORDER BY id";
            match tool {
                Some(tool) => sqlx::query_as(OF_TOOL).bind(tool).fetch_all(pool).await,
                None => sqlx::query_as(all).fetch_all(pool).await,
            }
        });
        let rows = self.done(rows)?;
        self.decoded(rows)
    }

    /// All tools in the order of their names.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn tools(&self) -> Result<Vec<ToolSummary>, StoreError> {
        let rows: Result<Vec<(String, i64)>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT tool, count(*) FROM tool_measurement GROUP BY tool").fetch_all(pool).await
        });
        let summary = |(tool, count): (String, i64)| ToolSummary { tool, measurements: count.unsigned_abs() };
        let mut tools: Vec<ToolSummary> = self.done(rows)?.into_iter().map(summary).collect();
        tools.sort_by(|a, b| a.tool.cmp(&b.tool));
        Ok(tools)
    }

    fn decoded(&self, rows: Vec<(Json<Value>,)>) -> Result<Vec<HistoryRecord>, StoreError> {
        let record = |(Json(record),): (Json<Value>,)| {
            HistoryRecord::deserialize(record)
                .map_err(|error| self.damaged("a measurement of a tool", &error))
        };
        rows.into_iter().map(record).collect()
    }
}

const OF_TOOL: &str = "SELECT record FROM tool_measurement WHERE tool = $1 ORDER BY id";

async fn of_tool(writing: &mut Writing, tool: &str) -> Result<Vec<(Json<Value>,)>, sqlx::Error> {
    on_writing!(writing, connection => sqlx::query_as(OF_TOOL).bind(tool).fetch_all(connection).await)
}

async fn insert(writing: &mut Writing, tool: &str, record: Value) -> Result<(), sqlx::Error> {
    on_writing!(writing, connection => {
        sqlx::query("INSERT INTO tool_measurement (tool, record) VALUES ($1, $2)")
            .bind(tool)
            .bind(Json(record))
            .execute(connection)
            .await?;
    });
    Ok(())
}
