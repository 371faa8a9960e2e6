//! What follows from a job before anything is planned, in sections of named quantities: what `check` shows.

mod gears;
mod processes;

use super::finding::{JobFailure, Remark};
use super::programs::machine_of_job;
use crate::exchange::AnyJob;
use crate::exchange::catalogue::catalogue_of_job;
use serde::Serialize;
use serde_json::{Map, Value};
use std::fmt::Write;

/// Sections in the order of the printed text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DerivedGeometry {
    sections: Vec<DerivedSection>,
}

/// Quantities that belong together.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DerivedSection {
    /// Heading, e.g. `worm`.
    pub title: &'static str,
    /// Quantities in the order of reading.
    pub quantities: Vec<DerivedQuantity>,
}

/// A quantity with its name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DerivedQuantity {
    /// Key in JSON, with the unit.
    pub key: &'static str,
    /// Name.
    pub label: &'static str,
    /// Number or word.
    pub value: Value,
    /// Unit, empty where there is none.
    pub unit: &'static str,
}

impl DerivedGeometry {
    /// All sections.
    pub fn sections(&self) -> &[DerivedSection] {
        &self.sections
    }

    /// Begins a section; its title is its key in JSON as well, blanks as `_`.
    fn section(&mut self, title: &'static str) {
        self.sections.push(DerivedSection { title, quantities: Vec::new() });
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
            section.quantities.push(DerivedQuantity { key, label, value: value.into(), unit });
        }
    }

    /// `{ section: { key: value } }`.
    pub fn to_json(&self) -> Value {
        let section = |section: &DerivedSection| {
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
                    Value::Number(number) if number.is_f64() => {
                        format!("{:.6}", number.as_f64().unwrap_or(f64::NAN))
                    }
                    other => other.to_string(),
                };
                let _ = writeln!(text, "  {:<36} {value} {}", quantity.label, quantity.unit);
            }
        }
        text
    }
}

/// What follows from a job of any process, and remarks on it.
///
/// # Errors
/// [`JobFailure`]: bodies or targets that cannot exist, a file that the job names.
pub fn derived_geometry(job: &AnyJob) -> Result<(DerivedGeometry, Vec<Remark>), JobFailure> {
    check_machine(job)?;
    Ok(match job {
        AnyJob::Grinding(loaded) => {
            let catalogue = catalogue_of_job(loaded)?;
            gears::of_grinding(loaded, catalogue.as_ref())?
        }
        AnyJob::Tangential(loaded) => (gears::of_tangential(loaded)?, Vec::new()),
        AnyJob::Gearbox(loaded) => (processes::of_gearbox(loaded)?, Vec::new()),
        AnyJob::Milling(loaded) => (processes::of_milling(loaded)?, Vec::new()),
        AnyJob::Skiving(loaded) => (processes::of_skiving(loaded)?, Vec::new()),
    })
}

/// Reads the machine description that a job names, so that a missing or wrong file is reported before planning.
fn check_machine(job: &AnyJob) -> Result<(), JobFailure> {
    let read = match job {
        AnyJob::Grinding(loaded) => loaded.job.machine.as_ref().map(|m| machine_of_job(loaded, &m.file)),
        AnyJob::Tangential(loaded) => loaded.job.machine.as_ref().map(|m| machine_of_job(loaded, &m.file)),
        AnyJob::Milling(loaded) => loaded.job.machine.as_ref().map(|m| machine_of_job(loaded, &m.file)),
        AnyJob::Skiving(loaded) => loaded.job.machine.as_ref().map(|m| machine_of_job(loaded, &m.file)),
        AnyJob::Gearbox(_) => None,
    };
    read.transpose()?;
    Ok(())
}
