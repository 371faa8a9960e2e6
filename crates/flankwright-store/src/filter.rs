//! Which parts and values are asked for, and the condition in SQL that this is. Knows the columns, runs nothing.

use flankwright::exchange::Diagnostic;
use flankwright::exchange::inspection::{SORTABLE_DATE, is_sortable_date};
use flankwright::geometry::Flank;

use crate::words::flank_word;

/// Which parts; every entry that is given has to agree, none means all.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PartFilter {
    /// The series.
    pub series: Option<String>,
    /// Number or name of the part.
    pub part: Option<String>,
    /// Number of the drawing.
    pub drawing: Option<String>,
    /// Measuring machine.
    pub machine: Option<String>,
    /// Measured at this date or later, in the form of [`crate::PartRecord::date`]. Parts without a date are left out.
    pub from: Option<String>,
    /// Measured at this date or earlier; a day means up to its end.
    pub to: Option<String>,
    /// Of all that agree, so many of the newest.
    pub newest: Option<u32>,
}

/// Which values of which parts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CharacteristicFilter {
    /// The parts.
    pub parts: PartFilter,
    /// Symbol, e.g. `fHa`.
    pub name: Option<String>,
    /// Flank; none means both and those of the whole gear.
    pub flank: Option<Flank>,
    /// What was made of single values, e.g. `mean`.
    pub statistic: Option<String>,
}

/// A condition with the texts of its places `$1`, `$2` and so on.
#[derive(Debug, Default)]
pub(crate) struct Condition {
    /// Empty, or ` WHERE ...`.
    pub text: String,
    /// What is bound, in this order.
    pub values: Vec<String>,
}

impl Condition {
    /// For the table `part p`.
    pub fn of_parts(filter: &PartFilter) -> Result<Self, Diagnostic> {
        for (field, date) in [("from", &filter.from), ("to", &filter.to)] {
            if let Some(text) = date.as_ref().filter(|text| !is_sortable_date(text)) {
                return Err(Diagnostic::with_code(
                    "invalid-filter",
                    format!("`{field}` is no date of this form"),
                )
                .field(field)
                .value(format!("{:?}", text.chars().take(40).collect::<String>()))
                .allowed(SORTABLE_DATE)
                .way_out("write the date in this form"));
            }
        }
        let mut condition = Self::default();
        condition.add("p.series = $", filter.series.as_deref());
        condition.add("p.name = $", filter.part.as_deref());
        condition.add("p.drawing = $", filter.drawing.as_deref());
        condition.add("p.machine = $", filter.machine.as_deref());
        condition.add("p.measured >= $", filter.from.as_deref());
        if let Some(to) = &filter.to {
            // A part of 09:30 belongs to the day on which it was measured.
            condition.add(&format!("substr(p.measured, 1, {}) <= $", to.len()), Some(to));
        }
        if let Some(most) = filter.newest {
            condition.text = format!(
                " WHERE p.id IN (SELECT p.id FROM part p{} ORDER BY p.measured DESC NULLS LAST, p.id DESC LIMIT {most})",
                condition.text
            );
        }
        Ok(condition)
    }

    /// For the tables `part p` and `characteristic c`.
    pub fn of_characteristics(filter: &CharacteristicFilter) -> Result<Self, Diagnostic> {
        let mut condition = Self::of_parts(&filter.parts)?;
        condition.add("c.name = $", filter.name.as_deref());
        condition.add("c.flank = $", filter.flank.map(flank_word));
        condition.add("c.statistic = $", filter.statistic.as_deref());
        Ok(condition)
    }

    fn add(&mut self, condition: &str, value: Option<&str>) {
        let Some(value) = value else { return };
        self.values.push(value.to_owned());
        self.text += if self.text.is_empty() { " WHERE " } else { " AND " };
        self.text += condition;
        self.text += &self.values.len().to_string();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted() {
        let parts =
            PartFilter { part: Some("17".into()), to: Some("2026-03-14".into()), ..PartFilter::default() };
        let filter =
            CharacteristicFilter { parts, flank: Some(Flank::Left), ..CharacteristicFilter::default() };
        let condition = Condition::of_characteristics(&filter).unwrap();
        assert_eq!(condition.text, " WHERE p.name = $1 AND substr(p.measured, 1, 10) <= $2 AND c.flank = $3");
        assert_eq!(condition.values, ["17", "2026-03-14", "left"]);
        assert_eq!(Condition::of_parts(&PartFilter::default()).unwrap().text, "");
    }

    #[test]
    fn a_date_that_is_none_is_refused() {
        let filter = PartFilter { from: Some("14.03.2026".into()), ..PartFilter::default() };
        let finding = Condition::of_parts(&filter).unwrap_err();
        assert_eq!((finding.code, finding.field.as_deref()), ("invalid-filter", Some("from")));
    }
}
