//! The page of a series of measured parts: statistics, capability and trends of every characteristic with their charts, parts with links
//! to their sheets. It shows finished figures and must not know how they were computed.

mod chart;
mod compose;
mod data;
mod tables;

pub use data::{
    CapabilityFigures, CharacteristicFigures, CharacteristicRow, MarkedStretch, PartRow, SeriesGroup,
    SeriesReport, TrendFigures,
};
