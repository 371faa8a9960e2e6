//! A measurement as it was read from its files, with everything that was not understood.

use super::result::LinesResult;
use foundation::geometry::Sides;
use foundation::modification::ModificationSpec;
use measured_files::inspection::Inspection;
use verdict::Remark;

/// A measurement as it was read.
#[derive(Clone, Debug)]
pub struct MeasuredFiles {
    /// The measurement.
    pub inspection: Inspection,
    /// Lines that were not understood.
    pub not_understood: Vec<LinesResult>,
    /// What was assumed.
    pub remarks: Vec<Remark>,
    /// Modifications that the file states for the gear.
    pub modifications: Sides<Vec<ModificationSpec>>,
    /// What the user stated about it, in words.
    pub stated: Vec<String>,
}

impl MeasuredFiles {
    pub(super) fn new(inspection: Inspection) -> Self {
        Self {
            inspection,
            not_understood: Vec::new(),
            remarks: Vec::new(),
            modifications: Sides::default(),
            stated: Vec::new(),
        }
    }
}
