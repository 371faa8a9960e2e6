//! What a cutter that runs along rows leaves at a point of the flank: the exact surface of the cutter met by the point's normal, least
//! over the way along the row, and the part of the straight blocks from curvatures.

use super::{
    ActiveFlank, ColumnPlane, ContactZone, CutterLocation, FlankGrid, LeadCurve, LocalContact, MillingError,
    Orientation,
};
use crate::geometry::{CutterShape, SurfaceJet};
use crate::numerics::{CubicSpline, SplineError, golden_section};
use nalgebra::{Matrix3, Vector3};

/// A row that the cutter runs along without any gap between its places.
#[derive(Clone, Debug)]
pub struct RowModel<'a> {
    flank: &'a ActiveFlank,
    lead: &'a dyn LeadCurve,
    shape: &'a CutterShape,
    cutting_length: f64,
    contact_height: f64,
    orientation: Orientation,
    /// Height and length parameters of the row over the lead parameter.
    heights: CubicSpline,
    lengths: CubicSpline,
    /// Lead parameters and points of the grid's columns: the ends of the blocks.
    columns: Vec<(f64, Vector3<f64>)>,
}

/// What stays at a point, mm, > 0 stock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prediction {
    /// By the shape of the cutter and the distance of the rows.
    pub scallop: f64,
    /// By the straight blocks.
    pub chord: f64,
    /// Lead parameter at which the cutter does it.
    pub u: f64,
}

impl Prediction {
    /// Both together.
    pub fn stock(&self) -> f64 {
        self.scallop + self.chord
    }
}

/// Evaluations along the row: 0.618^26 of some millimetres is 1e-5 mm, of the stock, which is flat there, less than 1e-11 mm.
const ALONG: usize = 26;

/// Newton's steps and the step that ends them, mm and rad.
const STEPS: usize = 30;
const SMALLEST_STEP: f64 = 1e-13;

impl<'a> RowModel<'a> {
    /// A row of a grid with at least four columns.
    ///
    /// # Errors
    /// [`SplineError`] for fewer columns.
    pub fn new(
        flank: &'a ActiveFlank,
        lead: &'a dyn LeadCurve,
        grid: &FlankGrid,
        row: usize,
        (shape, cutting_length): (&'a CutterShape, f64),
        contact_height: f64,
        orientation: Orientation,
    ) -> Result<Self, SplineError> {
        let of = |value: fn(&super::GridPlace) -> f64| -> Vec<f64> {
            grid.columns.iter().map(|column| value(&column.places[row])).collect()
        };
        let at: Vec<f64> = grid.columns.iter().map(|column| column.lead.u).collect();
        let points = grid.columns.iter().map(|column| column.places[row].jet.point);
        Ok(Self {
            flank,
            lead,
            shape,
            cutting_length,
            contact_height,
            orientation,
            heights: CubicSpline::new(&at, &of(|place| place.height))?,
            lengths: CubicSpline::new(&at, &of(|place| place.length))?,
            columns: at.iter().copied().zip(points).collect(),
        })
    }

    /// Height parameter of the row at a lead parameter.
    pub fn height(&self, u: f64) -> f64 {
        self.heights.value(u)
    }

    fn at(&self, u: f64) -> Result<(SurfaceJet, CutterLocation), MillingError> {
        let lead = self.lead.at(u)?;
        let section =
            ColumnPlane::new(self.flank, lead).section(self.heights.value(u), self.lengths.value(u))?;
        let location = CutterLocation::new(
            &section.jet,
            &lead,
            self.shape,
            self.cutting_length,
            self.contact_height,
            self.orientation,
        )?;
        Ok((section.jet, location))
    }

    /// What the row leaves on the flank's normal at a point, looked for `reach` to both sides of a lead parameter.
    ///
    /// # Errors
    /// Those of the sections and locations; [`MillingError::NotMet`] if the normal does not meet the cutter.
    pub fn stock(&self, at: &SurfaceJet, near: f64, reach: f64) -> Result<Prediction, MillingError> {
        let first = self.columns.first().map_or(near, |column| column.0);
        let last = self.columns.last().map_or(near, |column| column.0);
        let (from, to) = ((near - reach).max(first), (near + reach).min(last));
        let met = |u: f64| {
            let (_, location) = self.at(u)?;
            meeting(self.shape, &location, &at.point, &at.normal)
                .ok_or_else(|| MillingError::NotMet { point: at.point.into() })
        };
        let mut failed = None;
        let u = golden_section(from, to, ALONG, |u| {
            met(u).unwrap_or_else(|error| {
                failed = Some(error);
                f64::INFINITY
            })
        });
        let scallop = met(u).map_err(|error| failed.unwrap_or(error))?;
        Ok(Prediction { scallop, chord: self.chord(u)?, u })
    }

    /// What the block that holds a lead parameter leaves there beside the continuous motion.
    fn chord(&self, u: f64) -> Result<f64, MillingError> {
        let block = self.columns.partition_point(|column| column.0 <= u).clamp(1, self.columns.len() - 1);
        let ((from, start), (to, end)) = (self.columns[block - 1], self.columns[block]);
        let share = ((u - from) / (to - from)).clamp(0.0, 1.0);
        let (jet, location) = self.at(u)?;
        let local = LocalContact::new(&jet, &location, self.shape);
        let middle = local.chord(&(end - start), (end - start).norm());
        Ok(4.0 * share * (1.0 - share) * middle)
    }
}

/// Where a line meets the part of the cutter that touches nearby: distance from its point along its direction, mm. By the cutter's own
/// surface: height or angle of its profile, angle about its axis, distance.
fn meeting(
    shape: &CutterShape,
    location: &CutterLocation,
    point: &Vector3<f64>,
    direction: &Vector3<f64>,
) -> Option<f64> {
    let (axis, first) = (&location.axis, &location.radial);
    let second = axis.cross(first);
    let mut at = Vector3::new(profile_start(shape, location), 0.0, 0.0);
    for _ in 0..STEPS {
        let [rho, z, rho_t, z_t] = profile(shape, location.zone, at.x);
        let (sin, cos) = at.y.sin_cos();
        let (radial, around) = (first * cos + second * sin, second * cos - first * sin);
        let off = location.tip + axis * z + radial * rho - point - direction * at.z;
        let slopes = Matrix3::from_columns(&[axis * z_t + radial * rho_t, around * rho, -direction]);
        let step = slopes.lu().solve(&off)?;
        at -= step;
        if !at.iter().all(|x| x.is_finite()) {
            return None;
        }
        if step.amax() < SMALLEST_STEP * at.amax().max(1.0) {
            return Some(at.z);
        }
    }
    None
}

/// The profile's parameter at the contact: height of a side, angle of an arc between its outward normal and the radial direction.
fn profile_start(shape: &CutterShape, location: &CutterLocation) -> f64 {
    match (shape, location.zone) {
        (CutterShape::Conical { corner_radius, .. }, ContactZone::Corner) => {
            (location.contact_height / corner_radius - 1.0).clamp(-1.0, 1.0).asin()
        }
        (CutterShape::Barrel { height, profile_radius, .. }, _) => {
            ((location.contact_height - height) / profile_radius).clamp(-1.0, 1.0).asin()
        }
        _ => location.contact_height,
    }
}

/// Radius and height of the profile with their slopes.
fn profile(shape: &CutterShape, zone: ContactZone, t: f64) -> [f64; 4] {
    match (*shape, zone) {
        (CutterShape::Conical { radius, half_angle, corner_radius }, ContactZone::Corner) => {
            let (sin, cos) = t.sin_cos();
            let circle = radius + (half_angle.sin() - 1.0) * corner_radius / half_angle.cos();
            [
                circle + corner_radius * cos,
                corner_radius * (1.0 + sin),
                -corner_radius * sin,
                corner_radius * cos,
            ]
        }
        (CutterShape::Conical { radius, half_angle, .. }, _) => {
            [radius + t * half_angle.tan(), t, half_angle.tan(), 1.0]
        }
        (CutterShape::Barrel { radius, height, profile_radius }, _) => {
            let (sin, cos) = t.sin_cos();
            [
                radius - profile_radius + profile_radius * cos,
                height + profile_radius * sin,
                -profile_radius * sin,
                profile_radius * cos,
            ]
        }
    }
}
