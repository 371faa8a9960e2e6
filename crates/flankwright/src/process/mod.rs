//! Processes: each maps settings to a flank and inverts that map. Knows the layers below, never the referee.

pub mod correction;
pub mod dressing;
pub mod generating;
pub mod milling;
pub mod skiving;
pub mod tangential_dressing;
