//! What follows from a job before anything is planned, in sections of named quantities. The one place where
//! `check` meets the geometry of the library.

use std::fmt::Write;

use flankwright::exchange::Diagnostic;
use flankwright::exchange::job::{Hand, Job};
use serde_json::{Map, Value};

/// Sections in the order of the printed text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DerivedGeometry {
    sections: Vec<Section>,
}

#[derive(Clone, Debug, PartialEq)]
struct Section {
    title: &'static str,
    quantities: Vec<Quantity>,
}

#[derive(Clone, Debug, PartialEq)]
struct Quantity {
    /// Key in JSON, with the unit.
    key: &'static str,
    label: &'static str,
    value: Value,
    unit: &'static str,
}

impl DerivedGeometry {
    /// Begins a section; its title is its key in JSON as well, blanks as `_`.
    fn section(&mut self, title: &'static str) {
        self.sections.push(Section { title, quantities: Vec::new() });
    }

    /// Adds a quantity to the last section.
    fn quantity(
        &mut self,
        key: &'static str,
        label: &'static str,
        value: impl Into<Value>,
        unit: &'static str,
    ) {
        if let Some(section) = self.sections.last_mut() {
            section.quantities.push(Quantity { key, label, value: value.into(), unit });
        }
    }

    /// `{ section: { key: value } }`.
    pub fn to_json(&self) -> Value {
        let section = |section: &Section| {
            let quantities: Map<String, Value> =
                section.quantities.iter().map(|q| (q.key.to_owned(), q.value.clone())).collect();
            (section.title.replace(' ', "_"), Value::Object(quantities))
        };
        Value::Object(self.sections.iter().map(section).collect())
    }

    /// Aligned lines, a blank line before each section.
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        for section in &self.sections {
            // Writing to a text cannot fail.
            let _ = writeln!(text, "\n{}", section.title);
            for quantity in &section.quantities {
                let value = match &quantity.value {
                    Value::String(word) => word.clone(),
                    other => other.to_string(),
                };
                let _ = writeln!(text, "  {:<32} {value} {}", quantity.label, quantity.unit);
            }
        }
        text
    }
}

/// What follows from the job: so far the defaults that it leaves open, filled in.
///
/// # Errors
/// A finding about a body that cannot exist; its field is the key of the job that is to blame.
pub fn derived_geometry(job: &Job) -> Result<DerivedGeometry, Diagnostic> {
    let mut derived = DerivedGeometry::default();
    let range = job.gear.evaluation_range();
    derived.section("evaluation");
    derived.quantity("start_diameter", "start diameter", range.start_diameter, "mm");
    derived.quantity("end_diameter", "end diameter", range.end_diameter, "mm");
    derived.quantity("z_start", "z start", range.z_start, "mm");
    derived.quantity("z_end", "z end", range.z_end, "mm");
    let hand = match job.worm_hand() {
        Hand::Left => "left",
        Hand::Right => "right",
    };
    let angle = job.worm_pressure_angle_deg().sides();
    derived.section("worm");
    derived.quantity("hand", "hand", hand, "");
    derived.quantity("normal_pressure_angle_left_deg", "normal pressure angle, left", angle.left, "deg");
    derived.quantity("normal_pressure_angle_right_deg", "normal pressure angle, right", angle.right, "deg");
    Ok(derived)
}
