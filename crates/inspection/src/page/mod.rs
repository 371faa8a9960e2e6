//! Pages of inspected gears: one gear, a series, the inspection sheet. Finished numbers in, pages out.

pub mod measured_gear;
pub mod series;
pub mod sheet;
