//! Generating grinding and the dressing of its worms: what settings leave on the flank, which settings leave a wanted flank, and what a
//! measured flank says about both. Knows no file, no report and no referee.

pub mod correction;

pub mod dressing;

pub mod generating;

pub mod tangential_dressing;
