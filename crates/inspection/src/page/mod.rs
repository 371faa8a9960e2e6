//! Pages of inspected gears: one gear and a series, composed from their results, and the inspection sheet, which draws what
//! `workflow/sheet` fills it with.

pub mod bevel;
mod class_table;
pub mod measured_gear;
pub mod series;
pub mod sheet;
