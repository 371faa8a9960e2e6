//! Inspection of gears: evaluation of measured lines and pitches, the closed loop of measuring and correcting, series of parts, sheets and
//! pages. For the loop it plans and grinds by `generating_grinding`.

pub mod page;
pub mod workflow;
