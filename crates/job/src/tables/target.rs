//! What the tables `[target]` of several processes have in common.

use foundation::modification::ModificationSpec;

/// One entry of `modifications`: a table with `kind` and the keys of that kind.
pub type Modification = ModificationSpec;

/// Tolerance of a job that gives none, um.
pub fn default_tolerance() -> f64 {
    1.0
}
