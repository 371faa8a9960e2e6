//! What positive amounts mean, in the words of REXS.

/// What positive amounts mean, written beside each component.
pub(super) const REMOVED: &str = "material_removed";
pub(super) const MATERIAL: &str = "material_standing";
