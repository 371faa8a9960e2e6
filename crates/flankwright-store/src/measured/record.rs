//! The record of an evaluated part: who it is, when it was measured, to which series it belongs.

use flankwright::exchange::Diagnostic;
use flankwright::workflow::inspection::GearInspection;
use serde_json::Value;

use super::characteristics::characteristics;
use super::limits::ClassLimits;
use crate::catalogue::unwritable;
use crate::date::sortable_date;
use crate::error::StoreError;
use crate::plans::TIMING;
use crate::records::PartRecord;

impl PartRecord {
    /// A part from its evaluated measurement and the digest of its file. The series is the drawing, else the name of the gear, else teeth
    /// and module. With a class of ISO 1328-1 its tolerances are the limits of the characteristics.
    ///
    /// # Errors
    /// `out-of-standard-range` for a class outside 1 to 11, `no-tolerances` for a gear that the standard does not cover.
    pub fn of_inspection(
        found: &GearInspection,
        digest: String,
        class: Option<i32>,
    ) -> Result<Self, StoreError> {
        let limits = class.map(|class| class_limits(found, class)).transpose()?.unwrap_or_default();
        let result = &found.result;
        let head = |key: &str| {
            result.head.get(key).map(|text| text.trim().to_owned()).filter(|text| !text.is_empty())
        };
        let gear = &found.inspection.gear;
        let of_body = || format!("z {} mn {}", gear.teeth, gear.normal_module_mm);
        let mut document = serde_json::to_value(result).map_err(|error| unwritable(&error))?;
        if let Value::Object(entries) = &mut document {
            // The only part that differs between two runs.
            entries.remove(TIMING);
        }
        Ok(Self {
            series: head("drawing").or_else(|| head("name")).unwrap_or_else(of_body),
            part: head("part").unwrap_or_else(|| result.job.clone()),
            drawing: head("drawing"),
            date: date(head("date"), head("time")),
            machine: head("machine"),
            source: result.files.first().cloned().unwrap_or_else(|| result.job.clone()),
            digest,
            document,
            characteristics: characteristics(result, &limits),
        })
    }
}

/// Date and time at which the measurement began; the date alone where the time is no time of day.
fn date(date: Option<String>, time: Option<String>) -> Option<String> {
    let date = date?;
    let begun = time.as_deref().and_then(|time| time.split('/').next()).unwrap_or_default();
    sortable_date(&format!("{date} {}", begun.trim())).or_else(|| sortable_date(&date))
}

fn class_limits(found: &GearInspection, class: i32) -> Result<ClassLimits, Diagnostic> {
    let Some(tolerances) = &found.gear.tolerances else {
        return Err(Diagnostic::with_code("no-tolerances", "ISO 1328-1 has no tolerances for this gear")
            .field("class")
            .value(class)
            .allowed("a gear within the range of the standard, with its face width")
            .way_out(
                "import this part without a class; its warnings tell what the standard does not cover",
            ));
    };
    ClassLimits::new(tolerances, class).map_err(|error| {
        Diagnostic::with_code(error.code(), error.to_string())
            .field("class")
            .value(class)
            .way_out(error.way_out())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_is_that_of_the_beginning() {
        let of = |day: &str, time: Option<&str>| date(Some(day.into()), time.map(str::to_owned));
        assert_eq!(of("13.10.25", Some("08:21:31   /   08:34:28")).as_deref(), Some("2025-10-13T08:21:31"));
        assert_eq!(of("13.10.25", Some("morning")).as_deref(), Some("2025-10-13"));
        assert_eq!(of("13.10.25", None).as_deref(), Some("2025-10-13"));
        assert_eq!(of("13/10/25", Some("08:21:31")), None);
    }
}
