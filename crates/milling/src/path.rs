//! Paths of the cutter along rows, in which sense and order they are run, and how the cutter comes and goes
//! (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::{CutterLocation, MillingError};
use nalgebra::Vector3;

/// The cutter at one place. mm, workpiece coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutterPlace {
    /// Tip, on the axis.
    pub tip: Vector3<f64>,
    /// Unit axis towards the shank.
    pub axis: Vector3<f64>,
    /// The point that it touches, if any; on an arc of approach the point of the cutter that will touch.
    pub contact: Option<Vector3<f64>>,
}

/// A path with the cutter in the material, from one end to the other, in straight blocks.
#[derive(Clone, Debug, PartialEq)]
pub struct CutterPath {
    /// Its places.
    pub places: Vec<CutterPlace>,
}

/// Against or with the feed: spindle clockwise seen from the shank (M3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CutDirection {
    /// The edge leaves the material in the direction of its cut: F.(a x n) < 0.
    Climb,
    /// The edge enters it: F.(a x n) > 0.
    Conventional,
}

/// How rows follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Traverse {
    /// All rows in one sense.
    OneWay(CutDirection),
    /// To and fro; the first row in this sense.
    Zigzag(CutDirection),
}

/// Which row comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowOrder {
    /// From the tip down, so that the material below supports.
    TipToRoot,
    /// From the root up.
    RootToTip,
}

/// Where the cutter is out of the workpiece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Retraction {
    /// Outside a cylinder about the axis, mm (external teeth and blades).
    Outside(f64),
    /// Inside one, mm (internal teeth).
    Inside(f64),
    /// Outside a cone about the axis, moved outwards: half angle in rad and distance in mm (bevel gears).
    OutsideCone {
        /// Half angle of the cone.
        half_angle: f64,
        /// Distance from it.
        distance: f64,
        /// Position of its apex on the axis, mm; 0 of bevel gears.
        apex: f64,
    },
    /// On the side towards -z of a plane across the axis, mm (crown gears, whose teeth point there).
    Below(f64),
}

/// A row's path from its cutter locations and contact points.
pub fn row_path(locations: impl IntoIterator<Item = (CutterLocation, Vector3<f64>)>) -> CutterPath {
    let place = |(location, contact): (CutterLocation, Vector3<f64>)| CutterPlace {
        tip: location.tip,
        axis: location.axis,
        contact: Some(contact),
    };
    CutterPath { places: locations.into_iter().map(place).collect() }
}

impl CutDirection {
    /// The sense of a travel direction F with the axis a and the flank's normal n.
    pub fn of(travel: &Vector3<f64>, axis: &Vector3<f64>, normal: &Vector3<f64>) -> Self {
        if travel.dot(&axis.cross(normal)) < 0.0 { Self::Climb } else { Self::Conventional }
    }

    /// The other one.
    pub const fn reversed(self) -> Self {
        match self {
            Self::Climb => Self::Conventional,
            Self::Conventional => Self::Climb,
        }
    }
}

impl Traverse {
    /// The sense of the n-th row that is run.
    pub const fn of_row(self, number: usize) -> CutDirection {
        match self {
            Self::OneWay(direction) => direction,
            Self::Zigzag(first) => {
                if number.is_multiple_of(2) {
                    first
                } else {
                    first.reversed()
                }
            }
        }
    }
}

/// The place that a cutter reaches when it is drawn back along its axis until its tip is out of the workpiece.
///
/// # Errors
/// [`MillingError::NoRetraction`] if the axis does not lead out.
pub fn retracted(place: &CutterPlace, out: Retraction) -> Result<CutterPlace, MillingError> {
    let (tip, axis) = (&place.tip, &place.axis);
    // Quadratic a x^2 + 2 b x + c = 0 for the way x along the axis; out where `sense` times it is positive.
    let (a, b, c, sense) = match out {
        Retraction::Below(plane) => return below(place, plane),
        Retraction::Outside(radius) | Retraction::Inside(radius) => {
            let (t, d) = (tip.xy(), axis.xy());
            let sense = if matches!(out, Retraction::Outside(_)) { 1.0 } else { -1.0 };
            (d.norm_squared(), t.dot(&d), t.norm_squared() - radius * radius, sense)
        }
        Retraction::OutsideCone { half_angle, distance, apex } => {
            let (sin, cos) = half_angle.sin_cos();
            // The cone moved outwards has its apex lower.
            let (tan, apex) = (sin / cos, apex - distance / sin);
            let (t, d, z) = (tip.xy(), axis.xy(), tip.z - apex);
            (
                d.norm_squared() - tan * tan * axis.z * axis.z,
                t.dot(&d) - tan * tan * z * axis.z,
                t.norm_squared() - tan * tan * z * z,
                1.0,
            )
        }
    };
    if sense * c >= 0.0 {
        return Ok(CutterPlace { contact: None, ..*place });
    }
    let no_way = MillingError::NoRetraction { tip: (*tip).into(), axis: (*axis).into() };
    let root = b * b - a * c;
    if root.is_nan() || root < 0.0 || a == 0.0 && b == 0.0 {
        return Err(no_way);
    }
    // Both roots without cancellation; the nearest one ahead.
    let q = -(b + root.sqrt().copysign(b));
    let ahead = [q / a, c / q].into_iter().filter(|x| x.is_finite() && *x > 0.0).reduce(f64::min);
    let way = ahead.ok_or(no_way)?;
    Ok(CutterPlace { tip: tip + axis * way, contact: None, ..*place })
}

/// The place at which the tip passes a plane across the workpiece's axis towards -z.
fn below(place: &CutterPlace, plane: f64) -> Result<CutterPlace, MillingError> {
    let CutterPlace { tip, axis, .. } = place;
    let rest = (tip.z - plane).max(0.0);
    if rest > 0.0 && axis.z >= 0.0 {
        return Err(MillingError::NoRetraction { tip: (*tip).into(), axis: (*axis).into() });
    }
    let way = if rest > 0.0 { -rest / axis.z } else { 0.0 };
    Ok(CutterPlace { tip: tip + axis * way, contact: None, ..*place })
}
