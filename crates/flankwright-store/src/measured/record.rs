//! The record of an evaluated part: who it is, when it was measured, to which series it belongs.

use flankwright::exchange::Diagnostic;
use flankwright::metrology::inspection::ToleranceQuantity;
use flankwright::workflow::inspection::{
    GearInspection, PartCharacteristic, PartIdentity, part_characteristics,
};
use serde_json::Value;

use crate::catalogue::unwritable;
use crate::error::StoreError;
use crate::plans::TIMING;
use crate::records::{CharacteristicValue, PartRecord};

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
        if let Some(class) = class {
            class_has_limits(found, class)?;
        }
        let result = &found.result;
        let head = |key: &str| {
            result.head.get(key).map(|text| text.trim().to_owned()).filter(|text| !text.is_empty())
        };
        let PartIdentity { series, part, time } = PartIdentity::of(found);
        let mut document = serde_json::to_value(result).map_err(|error| unwritable(&error))?;
        if let Value::Object(entries) = &mut document {
            // The only part that differs between two runs.
            entries.remove(TIMING);
        }
        Ok(Self {
            series,
            part,
            drawing: head("drawing"),
            date: time,
            machine: head("machine"),
            source: result.files.first().cloned().unwrap_or_else(|| result.job.clone()),
            digest,
            document,
            characteristics: part_characteristics(found, class)
                .into_iter()
                .map(CharacteristicValue::from)
                .collect(),
        })
    }
}

/// Whether the standard has limits for the gear.
fn class_has_limits(found: &GearInspection, class: i32) -> Result<(), Diagnostic> {
    let Some(tolerances) = &found.gear.tolerances else {
        return Err(Diagnostic::with_code("no-tolerances", "ISO 1328-1 has no tolerances for this gear")
            .field("class")
            .value(class)
            .allowed("a gear within the range of the standard, with its face width")
            .way_out(
                "import this part without a class; its warnings tell what the standard does not cover",
            ));
    };
    tolerances
        .rounded(ToleranceQuantity::ProfileSlope, class)
        .map(drop)
        .map_err(|error| Diagnostic::of(&error).field("class").value(class))
}

impl From<PartCharacteristic> for CharacteristicValue {
    fn from(of: PartCharacteristic) -> Self {
        let PartCharacteristic { name, flank, tooth, statistic, unit, value, lower_limit, upper_limit } = of;
        Self { name, flank, tooth, statistic, value, unit: unit.into(), lower_limit, upper_limit }
    }
}
