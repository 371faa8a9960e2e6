//! Rows with the axis as other systems choose it (`docs/mathematics/milling.md#positions-of-five-axes`), to be laid beside those with the
//! axis in the column planes: along the parameter lines of the flank, or along lines that a patched surface has made wavy.

use super::{
    ActiveFlank, ColumnPlane, CutterLocation, LeadCurve, LeadPoint, MillingError, Orientation, lead_range,
};
use foundation::geometry::{Cutter, SurfaceJet};
use foundation::numerics::equidistant;
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// How the axis is found along a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AxisChoice {
    /// Along the lines of constant length parameter.
    ParameterLines,
    /// Along lines sheared by eps L sin(2 pi x), linear over the height, as irregular patches have them.
    ShearedLines {
        /// eps: share of the face.
        shear: f64,
        /// L: length of the face in the length parameter.
        face: f64,
        /// From root to tip in the height parameter, signed.
        height: f64,
    },
}

/// The unit axis of another system at a place that lies at the share `along` (0..1) of its row; towards the shank.
pub fn other_axis(choice: AxisChoice, jet: &SurfaceJet, lead: &LeadPoint, along: f64) -> Vector3<f64> {
    let line = match choice {
        AxisChoice::ParameterLines => jet.by_height,
        AxisChoice::ShearedLines { shear, face, height } => {
            jet.by_height + jet.by_length * (shear * face * (TAU * along).sin() / height)
        }
    };
    let axis = line.normalize();
    if axis.dot(&lead.base_normal) < 0.0 { -axis } else { axis }
}

/// A place of a row and the cutter that touches there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrientedPlace {
    /// The flank.
    pub jet: SurfaceJet,
    /// The cutter.
    pub location: CutterLocation,
}

/// The cutter of a row: its contact height (mm) where that is chosen, and its turn against the axis without tilt and lead angle.
#[derive(Clone, Copy, Debug)]
pub struct RowCutter<'a> {
    /// The cutter.
    pub cutter: &'a Cutter,
    /// Height of the contact on a straight side, mm.
    pub contact_height: f64,
    /// Tilt and lead angle.
    pub orientation: Orientation,
}

impl RowCutter<'_> {
    fn located(&self, jet: &SurfaceJet, lead: &LeadPoint) -> Result<OrientedPlace, MillingError> {
        let (cutter, height) = (self.cutter, self.contact_height);
        let location = CutterLocation::new(
            jet,
            lead,
            cutter.shape(),
            cutter.cutting_length(),
            height,
            self.orientation,
        )?;
        Ok(OrientedPlace { jet: *jet, location })
    }
}

/// A row of constant height, the same in every choice of the axis.
#[derive(Clone, Debug)]
pub struct OrientedRow<'a> {
    flank: &'a ActiveFlank,
    lead: &'a dyn LeadCurve,
    cutter: RowCutter<'a>,
    height: f64,
    columns: Vec<OrientedPlace>,
    /// Length parameters at both ends.
    ends: [f64; 2],
}

impl<'a> OrientedRow<'a> {
    /// The row at a height with the axis in the column planes: `points` (2 or more) equal steps of the lead parameter over its range.
    ///
    /// # Errors
    /// Those of range, sections and cutter location.
    pub fn new(
        flank: &'a ActiveFlank,
        lead: &'a dyn LeadCurve,
        cutter: RowCutter<'a>,
        height: f64,
        points: usize,
    ) -> Result<Self, MillingError> {
        let mut columns = Vec::new();
        let mut ends: Option<[f64; 2]> = None;
        for u in equidistant(lead_range(flank, lead)?, points.max(2)) {
            let plane = ColumnPlane::new(flank, lead.at(u)?);
            let section = plane.section(height, u)?;
            columns.push(cutter.located(&section.jet, plane.lead())?);
            ends = Some([ends.map_or(section.length, |[first, _]| first), section.length]);
        }
        Ok(Self { flank, lead, cutter, height, columns, ends: ends.unwrap_or_default() })
    }

    /// With the axis in the column planes.
    pub fn in_columns(&self) -> &[OrientedPlace] {
        &self.columns
    }

    /// Lines sheared by this share of the face.
    pub fn sheared(&self, shear: f64) -> AxisChoice {
        let ([from, to], [root, tip]) = (self.flank.face, self.flank.height_span());
        AxisChoice::ShearedLines { shear, face: to - from, height: tip - root }
    }

    /// With another choice of the axis, as many places in equal steps of the length parameter between the same ends.
    ///
    /// # Errors
    /// Those of guide curve and cutter location.
    pub fn with(&self, choice: AxisChoice) -> Result<Vec<OrientedPlace>, MillingError> {
        let last = (self.columns.len() - 1) as f64;
        let lengths = equidistant(self.ends, self.columns.len()).into_iter().enumerate();
        let place = |(k, length): (usize, f64)| {
            let jet = self.flank.surface.jet(self.height, length);
            // The guide curve says where the shank stands; that far, both parameters are one.
            let lead = self.lead.at(length)?;
            let axis = other_axis(choice, &jet, &lead, k as f64 / last);
            // The plane that holds axis and normal takes the place of the column plane.
            let direction = axis.cross(&jet.normal).normalize();
            self.cutter.located(&jet, &LeadPoint { direction, ..lead })
        };
        lengths.map(place).collect()
    }
}
