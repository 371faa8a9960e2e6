//! The one place that draws charts: plain numbers in, SVG text out.
//!
//! Every chart carries a title, axis units and a legend, and is made for paper: white ground, dark ink, and
//! no meaning that colour carries alone. Series differ by dash and marker, isolines carry their value,
//! negative isolines are dashed, and material left standing is hatched. Drawing the same data gives the same
//! bytes. The module must not know gears beyond the names of their coordinates: w (length of roll, mm) and
//! z (face width, mm).

mod axes;
mod axis_chart;
pub mod contour_map;
pub mod contours;
pub mod drawing;
mod dressing_section;
pub mod error;
mod hatch;
pub mod line_chart;
mod line_legend;
mod line_marks;
mod line_series;
pub mod magnification;
pub mod numbers;
pub mod palette;
pub mod polar_chart;
pub mod profile_helix;
pub mod scale;
pub mod signal_strip;
pub mod svg;
pub mod text;
mod thinning;
pub mod topography;
pub mod topography_net;
mod worm_occupation;

pub use axis_chart::{AxisChart, AxisChartLimits, axis_chart};
pub use contour_map::{ContourMap, MapFrame, MapMark, MapValues, contour_map, contour_map_in};
pub use contours::region_above;
pub use drawing::{Drawing, DrawingLayer, DrawingLook, DrawingNote, drawing};
pub use dressing_section::{
    DressingSectionChart, MarkedClearance, SectionKind, SectionStretch, SpaceFlank, dressing_section_chart,
};
pub use error::ChartError;
pub use line_chart::{line_chart, line_chart_in};
pub use line_series::{LineChart, LineFrame, Marks, Panel, Series, YScale};
pub use numbers::{format_fixed, format_significant};
pub use polar_chart::{PolarChart, PolarCurve, polar_chart};
pub use profile_helix::{FlankSections, ProfileHelixDiagram, RangeMark, SectionTrace, profile_helix_diagram};
pub use scale::LevelScale;
pub use signal_strip::{SignalStrip, StripCell, signal_strip};
pub use svg::Svg;
pub use topography::{NamedTopography, Topography};
pub use topography_net::{TopographyNet, topography_net};
pub use worm_occupation::{
    OccupationBar, OccupationKind, OccupationRow, WormOccupationChart, worm_occupation_chart,
};

pub use axis_chart::share_of_limit;
pub use error::{check_ascending, check_length, check_values};
pub use palette::{FAINT, INK, MUTED};
pub use scale::round_below;
pub use svg::{Anchor, Canvas, Stroke, TextStyle, escape};
pub use text::{indices, text_width};
