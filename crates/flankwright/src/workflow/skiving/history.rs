//! stand-in
use super::measurement::Measurement;
use super::prepare::SkivingBodies;
use super::result::MeasurementResult;
use crate::exchange::LoadedSkivingJob;
use crate::workflow::finding::{JobFailure, Remark};
pub struct Noted {
    pub remarks: Vec<Remark>,
}
pub(super) fn noted(
    _: &LoadedSkivingJob,
    _: &SkivingBodies,
    _: Option<&MeasurementResult>,
    _: Option<&Measurement>,
) -> Result<Option<Noted>, JobFailure> {
    Ok(None)
}
