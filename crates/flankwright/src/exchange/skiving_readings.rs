//! stand-in
use super::diagnostic::JobError;
use crate::process::skiving::measuring::Reading;
pub fn read_trigger_file(_: &std::path::Path, _: usize) -> Result<Vec<Reading>, JobError> {
    Ok(vec![])
}
