//! The values of characteristics over parts: what statistics over time are made of.

use sqlx::AssertSqlSafe;

use crate::error::StoreError;
use crate::filter::{CharacteristicFilter, Condition};
use crate::pool::on_pool;
use crate::records::{Characteristic, MeasuredCharacteristic};
use crate::store::Store;
use crate::words::flank_of;

/// Part, its date, what was measured on it, and what was found.
type Row = (
    String,
    String,
    Option<String>,
    String,
    Option<String>,
    Option<i64>,
    String,
    String,
    f64,
    Option<f64>,
    Option<f64>,
);

impl Store {
    /// Values of the parts that the filter lets through, in the order of [`Store::parts`], those of one part in the order of its record.
    /// The values of one [`Characteristic`] are what `flankwright::metrology::inspection::evaluate_series` takes.
    ///
    /// # Errors
    /// `invalid-filter`; those of the database.
    pub async fn characteristics(
        &self,
        filter: &CharacteristicFilter,
    ) -> Result<Vec<MeasuredCharacteristic>, StoreError> {
        let condition = Condition::of_characteristics(filter)?;
        let text = format!(
            "SELECT p.digest, p.name, p.measured, c.name, c.flank, c.tooth, c.statistic, c.unit, v.value, v.lower_limit, \
             v.upper_limit FROM part p JOIN measured_value v ON v.part = p.id JOIN characteristic c ON c.id = v.characteristic{} \
             ORDER BY p.measured NULLS LAST, p.id, v.place",
            condition.text
        );
        let rows: Result<Vec<Row>, _> = on_pool!(&self.pool, pool => {
            let query = sqlx::query_as(AssertSqlSafe(text));
            condition.values.iter().fold(query, |query, value| query.bind(value)).fetch_all(pool).await
        });
        let of_row = |row: Row| {
            let (digest, part, date, name, flank, tooth, statistic, unit, value, lower_limit, upper_limit) =
                row;
            let tooth = tooth.and_then(|tooth| u32::try_from(tooth).ok());
            let flank = flank.as_deref().map(flank_of);
            let characteristic = Characteristic { name, flank, tooth, statistic, unit };
            MeasuredCharacteristic { digest, part, date, characteristic, value, lower_limit, upper_limit }
        };
        Ok(self.done(rows)?.into_iter().map(of_row).collect())
    }
}
