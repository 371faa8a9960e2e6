//! The catalogue of worms and dressers: in as a whole, out as a whole, each body under its name.

use std::collections::{HashMap, HashSet};

use flankwright::exchange::catalogue::{Catalogue, DresserEntry, WormEntry, parse_catalogue};
use flankwright::exchange::{Diagnostic, Source};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use sqlx::types::Json;

use crate::error::StoreError;
use crate::pool::{Writing, on_pool, on_writing};
use crate::reports::CatalogueReport;
use crate::store::Store;

/// What the tables call the two kinds.
const WORM: &str = "worm";
const DRESSER: &str = "dresser";

/// Bodies of both kinds.
pub(crate) const COUNT: &str = "SELECT count(*) FROM body";

/// A body as it stands in the table: kind, name, entry.
type Body = (&'static str, String, Value);

impl Store {
    /// Imports a catalogue, whole or not at all. Bodies of a name that is there take the place of the old ones, others come behind them.
    /// With `replace` bodies that the catalogue does not name are taken out, and the order is that of the catalogue.
    ///
    /// # Errors
    /// What a catalogue file with these entries would be refused for; those of the database.
    pub async fn import_catalogue(
        &self,
        catalogue: &Catalogue,
        replace: bool,
    ) -> Result<CatalogueReport, StoreError> {
        let bodies = checked(catalogue)?;
        self.done(self.put_bodies(&bodies, replace).await)
    }

    async fn put_bodies(&self, bodies: &[Body], replace: bool) -> Result<CatalogueReport, sqlx::Error> {
        let mut writing = self.pool.write().await?;
        let rows: Vec<(String, String, i64, Json<Value>)> = on_writing!(&mut writing, connection => {
            sqlx::query_as("SELECT kind, name, place, entry FROM body").fetch_all(connection).await?
        });
        let mut report = CatalogueReport::default();
        let mut end = rows.iter().map(|row| row.2 + 1).max().unwrap_or(0);
        if replace {
            let named: HashSet<(&str, &str)> =
                bodies.iter().map(|(kind, name, _)| (*kind, name.as_str())).collect();
            report.removed =
                rows.iter().filter(|row| !named.contains(&(row.0.as_str(), row.1.as_str()))).count();
            on_writing!(&mut writing, connection => {
                sqlx::query("DELETE FROM body").execute(connection).await?;
            });
            end = 0;
        }
        let there: HashMap<(&str, &str), (i64, &Value)> = rows
            .iter()
            .map(|(kind, name, place, Json(entry))| ((kind.as_str(), name.as_str()), (*place, entry)))
            .collect();
        for (kind, name, entry) in bodies {
            let old = there.get(&(*kind, name.as_str()));
            match old {
                None => report.added += 1,
                Some((_, old)) if *old == entry => report.unchanged += 1,
                Some(_) => report.changed += 1,
            }
            let place = match old {
                Some((place, _)) if !replace => *place,
                _ => {
                    end += 1;
                    end - 1
                }
            };
            put(&mut writing, kind, name, place, entry).await?;
        }
        writing.commit().await?;
        Ok(report)
    }

    /// The whole catalogue in its order; both lists may be empty.
    ///
    /// # Errors
    /// `damaged-store`; those of the database.
    pub async fn catalogue(&self) -> Result<Catalogue, StoreError> {
        Ok(Catalogue {
            worm: self.bodies::<WormEntry>(WORM).await?,
            dresser: self.bodies::<DresserEntry>(DRESSER).await?,
        })
    }

    async fn bodies<T: DeserializeOwned>(&self, kind: &'static str) -> Result<Vec<T>, StoreError> {
        let rows: Result<Vec<(Json<Value>,)>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT entry FROM body WHERE kind = $1 ORDER BY place").bind(kind).fetch_all(pool).await
        });
        let entry = |(Json(entry),): (Json<Value>,)| {
            T::deserialize(entry).map_err(|error| self.damaged(kind, &error))
        };
        self.done(rows)?.into_iter().map(entry).collect()
    }

    /// What does not have the form that this version writes.
    pub(crate) fn damaged(&self, what: &'static str, error: &serde_json::Error) -> StoreError {
        StoreError::Damaged { address: self.address().to_string(), what, cause: error.to_string() }
    }
}

async fn put(
    writing: &mut Writing,
    kind: &str,
    name: &str,
    place: i64,
    entry: &Value,
) -> Result<(), sqlx::Error> {
    on_writing!(writing, connection => {
        sqlx::query(
            "INSERT INTO body (kind, name, place, entry) VALUES ($1, $2, $3, $4) \
             ON CONFLICT (kind, name) DO UPDATE SET place = excluded.place, entry = excluded.entry",
        )
        .bind(kind)
        .bind(name)
        .bind(place)
        .bind(Json(entry))
        .execute(connection)
        .await?;
    });
    Ok(())
}

/// The bodies, after the checks that a file goes through: a catalogue may also be made by a program.
fn checked(catalogue: &Catalogue) -> Result<Vec<Body>, StoreError> {
    let text = serde_json::to_string(catalogue).map_err(|error| unwritable(&error))?;
    parse_catalogue(Source::new("catalogue.json", &text))?;
    let worms = catalogue.worm.iter().map(|worm| body(WORM, &worm.name, worm));
    let dressers = catalogue.dresser.iter().map(|dresser| body(DRESSER, &dresser.name, dresser));
    worms.chain(dressers).collect()
}

fn body(kind: &'static str, name: &str, entry: &impl Serialize) -> Result<Body, StoreError> {
    Ok((kind, name.to_owned(), serde_json::to_value(entry).map_err(|error| unwritable(&error))?))
}

/// A record that JSON cannot hold.
pub(crate) fn unwritable(error: &serde_json::Error) -> StoreError {
    Diagnostic::with_code("invalid-record", format!("the record cannot be written as JSON: {error}"))
        .way_out("give every number a finite value")
        .into()
}
