//! Milling of gear teeth and blades on five axes: from a flank to the places of the cutter (`docs/mathematics/milling.md`).
//!
//! A guide curve runs along the bottom of the space; planes perpendicular to it cut the flank in columns; the cutter's axis stays in
//! its column's plane and perpendicular to the flank's normal. Knows no machine and no file; what is left on the flank is predicted
//! here from the cutter's surface on its way and judged elsewhere by rays.

mod access;
mod approach;
mod bottom;
mod clearance;
mod collision;
mod column;
mod density;
mod drawn_limits;
mod drawn_root;
mod error;
mod finish;
mod flank;
mod flank_plan;
mod grid;
pub mod job;
mod lead_curve;
mod lead_through;
mod lines;
mod local;
mod location;
mod meeting;
mod middle;
mod milled_side;
mod milling_plan;
mod obstacle;
mod operation_kind;
mod orientation;
pub mod page;
mod patch;
mod path;
mod plan;
mod plan_options;
mod predict;
mod probe;
mod process;
mod range;
mod root_pass;
mod roughing;
mod row_paths;
mod size;
mod space;
mod spacing;
mod sweep;
mod tapered;
mod touch_fault;
mod wall;
mod wear;
pub mod workflow;

pub use access::check_access;
pub use approach::{LeadArc, approach_arc};
pub use collision::check_path;
pub use column::{ColumnPlane, Section};
pub use density::{DenseGrid, DensityLimits, DistanceLimits, Violated, dense_grid};
pub use drawn_root::{RootModel, RootPart, RootPoint, drawn_root, drawn_section, root_limits};
pub use error::MillingError;
pub use finish::{Bottom, FinishOptions, FinishedRow, Kept, finish};
pub use flank::{ActiveFlank, Along, HeightLimits, Kink, LimitBody};
pub use flank_plan::{FlankPlan, RowFigures};
pub use grid::{Column, FlankGrid, GridPlace, NeighbourDistances};
pub use lead_curve::{
    CurveOnCone, FootOnHub, HelixOnCone, HelixOnCylinder, LeadCurve, LeadPoint, MirroredLead, SkewPlanes,
};
pub use lead_through::lead_through_row;
pub use lines::{LaidLines, Lines, SpacingLaw, lay_lines};
pub use local::{LocalContact, row_distance};
pub use location::{ContactZone, CutterLocation, Orientation};
pub use milled_side::{Half, MilledSide};
pub use milling_plan::{MillingPlan, Operation};
pub use obstacle::{Collision, Obstacle};
pub use operation_kind::OperationKind;
pub use orientation::{AxisChoice, OrientedPlace, OrientedRow, RowCutter, other_axis};
pub use patch::{Clearance, HIDDEN, Patch};
pub use path::{CutDirection, CutterPath, CutterPlace, Retraction, RowOrder, Traverse, retracted, row_path};
pub use plan::{plan, plan_all};
pub use plan_options::PlanOptions;
pub use predict::{FlankModel, Prediction};
pub use process::FiveAxisMilling;
pub use range::{lead_range, plane_through};
pub use root_pass::{BottomPass, RootDepth, RootSection, greatest_contact_height};
pub use roughing::{RoughingLayer, RoughingOptions, rough};
pub use row_paths::RowEnd;
pub use size::MOST_LINES;
pub use space::{Land, Space, SpaceFlank};
pub use spacing::{RowSpacing, row_heights};
pub use tapered::{RollOnCone, Tapered};
pub use touch_fault::TouchFault;
pub use wall::{Wall, WallKind};
pub use wear::{HeightRule, HeightWindow, RowLoad, WearHistogram};
