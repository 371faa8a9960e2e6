//! One measured part: what it is, how it was measured, what was found, what is doubtful.

use serde::{Deserialize, Serialize};

use super::{
    Circles, Conditions, InspectedGear, InspectionWarning, Pitch, Quantity, RunOut, Thickness, Topography,
    Trace,
};

/// The inspection of one part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Inspection {
    /// Number of the part.
    pub part: Option<String>,
    /// Its name.
    pub name: Option<String>,
    /// Number of the drawing.
    pub drawing: Option<String>,
    /// Date of the measurement as the file writes it.
    pub date: Option<String>,
    /// Time of day of the measurement, its beginning and perhaps its end, as the file writes it.
    pub time: Option<String>,
    /// Measuring machine or its program.
    pub machine: Option<String>,
    /// Who measured.
    pub operator: Option<String>,
    /// Files it came from.
    pub sources: Vec<String>,
    /// Doubts.
    pub warnings: Vec<InspectionWarning>,
    /// The gear.
    pub gear: InspectedGear,
    /// How it was measured.
    pub conditions: Conditions,
    /// Profiles and helix traces in the order of the file.
    pub traces: Vec<Trace>,
    /// Measured fields.
    pub topographies: Vec<Topography>,
    /// Pitches.
    pub pitch: Option<Pitch>,
    /// Run-out.
    pub run_out: Option<RunOut>,
    /// Thickness of the teeth.
    pub thickness: Thickness,
    /// Root and tip circle.
    pub circles: Circles,
    /// Values that the machine printed.
    pub results: Vec<Quantity>,
}

impl Inspection {
    /// Of a gear of which nothing is measured yet.
    pub fn of_gear(gear: InspectedGear) -> Self {
        Self {
            part: None,
            name: None,
            drawing: None,
            date: None,
            time: None,
            machine: None,
            operator: None,
            sources: Vec::new(),
            warnings: Vec::new(),
            gear,
            conditions: Conditions::default(),
            traces: Vec::new(),
            topographies: Vec::new(),
            pitch: None,
            run_out: None,
            thickness: Thickness::default(),
            circles: Circles::default(),
            results: Vec::new(),
        }
    }
}
