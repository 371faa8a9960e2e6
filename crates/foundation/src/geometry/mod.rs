//! Shapes: involute flanks, gears, worms, racks, surfaces of revolution, milled flanks and cutters, skiving tools. Knows no motion and no process.

mod bevel;
mod blank;
mod cutter;
mod error;
mod gear;
mod involute;
mod rack;
mod revolution;
mod rolls;
mod sides;
mod skiving_tool;
mod surface;
mod thickness;
mod turned_body;
mod worm;

pub use bevel::{
    BevelData, BevelGear, CircularLine, FlankLine, Hand, LineForm, Octoid, SphericalInvolute, Spiral,
    TangentLine,
};
pub use blank::{Blank, BlankWarning, EvaluationLimits};
pub use cutter::{Cutter, CutterShape, ShankStep, Support, in_tool};
pub use error::GeometryError;
pub use gear::{Gear, GearData, involute_function};
pub use involute::{FlankDeviation, FlankFrame, InvoluteFlank};
pub use rack::Rack;
pub use revolution::{MeridianPoint, ProfileOffset, Revolution};
pub use rolls::OverRolls;
pub use sides::{Flank, Sides};
pub use skiving_tool::{
    ConeRake, EdgeRounding, PlaneRake, RakeChange, RakeFace, SkivingTool, SphericalRake, VariableRake,
};
pub use surface::{
    BladeCurve, BladeData, CylindricalCurve, EaseOff, EaseOffAmounts, Frustum, GridSurface, Helicoid,
    Mirrored, Modified, NormalOffset, NormalSide, OffsetBase, OffsetBounds, OffsetSum, RuledBlade,
    SecondOrder, SplineCurve, Surface, SurfaceJet,
};
pub use thickness::{OverBalls, Span, ThicknessMeasure};
pub use turned_body::TurnedBody;
pub use worm::{WormChoice, WormForGear, check_mating, worm_for_gear};
