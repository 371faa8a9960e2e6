//! The root of the space (`docs/mathematics/milling.md#root-and-clearance`): the tool goes on below the active flank, its corner leaves the
//! fillet, and a second pass with an upright axis joins both fillets by the bottom.

use super::{LeadPoint, MillingError};
use foundation::numerics::equidistant;
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// What is known of the bottom. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RootDepth {
    /// h_b: length of the straight piece below the lowest active point.
    Straight(f64),
    /// y_f: height of the bottom above the lead point.
    Bottom(f64),
}

/// The section of the root in the column plane; abscissa X_2, ordinate N. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RootSection {
    /// p_g: the lowest active point.
    pub lowest_active: [f64; 2],
    /// nu: lean of the axis against the base body's normal.
    pub lean: f64,
    /// h_b: length of the straight piece.
    pub straight: f64,
    /// q: where the fillet begins.
    pub fillet_start: [f64; 2],
    /// o: centre of the fillet.
    pub fillet_centre: [f64; 2],
    /// The lowest point, where the fillet runs parallel to the base body.
    pub lowest: [f64; 2],
    /// The fillet's angle.
    pub fillet_angle: f64,
    /// h: contact height of the pass.
    pub contact_height: f64,
    /// Distance between the lowest points of both fillets, halved.
    pub half_width: f64,
    corner_radius: f64,
}

/// The second pass: axis = N, along the guide curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BottomPass {
    /// x_c: the tool's centre goes from -x_c to x_c across the guide curve, mm.
    pub half_travel: f64,
    /// Height of the tip above the lead point, mm.
    pub height: f64,
}

impl RootSection {
    /// The section below the lowest active point of a column, for a tool of corner radius r_c and cutting length l_c whose flank pass has
    /// this axis.
    ///
    /// # Errors
    /// [`MillingError::RootCorner`], [`MillingError::RootOverlap`], [`MillingError::ToolShort`].
    pub fn new(
        lead: &LeadPoint,
        lowest_active: &Vector3<f64>,
        normal: &Vector3<f64>,
        axis: &Vector3<f64>,
        corner_radius: f64,
        cutting_length: f64,
        depth: RootDepth,
    ) -> Result<Self, MillingError> {
        let u = lead.u;
        let side = if normal.dot(&lead.abscissa()) < 0.0 { 1.0 } else { -1.0 };
        let [x_g, y_g] = lead.in_plane(lowest_active);
        let (sin, cos) = (side * axis.dot(&lead.abscissa()), axis.dot(&lead.base_normal));
        let lean = sin.atan2(cos);
        let straight = match depth {
            RootDepth::Straight(straight) => straight,
            RootDepth::Bottom(height) => (y_g - height - corner_radius * (1.0 - sin)) / cos,
        };
        if straight.is_nan() || straight < 0.0 {
            return Err(MillingError::RootCorner { u, straight, corner_radius });
        }
        let fillet_start = [x_g - straight * side * sin, y_g - straight * cos];
        let fillet_centre =
            [fillet_start[0] - corner_radius * side * cos, fillet_start[1] + corner_radius * sin];
        let lowest = [fillet_centre[0], fillet_centre[1] - corner_radius];
        if side * lowest[0] < 0.0 {
            return Err(MillingError::RootOverlap { u, overlap: -side * lowest[0], corner_radius });
        }
        let contact_height = straight + corner_radius;
        if contact_height > cutting_length {
            return Err(MillingError::ToolShort { u, needed: contact_height, cutting_length });
        }
        Ok(Self {
            lowest_active: [x_g, y_g],
            lean,
            straight,
            fillet_start,
            fillet_centre,
            lowest,
            fillet_angle: FRAC_PI_2 - lean,
            contact_height,
            half_width: lowest[0].abs(),
            corner_radius,
        })
    }

    /// The pass that joins both fillets, with a tool of radius R_2 and the same corner.
    ///
    /// # Errors
    /// [`MillingError::RootBottom`] if the tool is too wide for it or the axis of the flank pass leans over the base body.
    pub fn bottom_pass(&self, u: f64, radius: f64) -> Result<BottomPass, MillingError> {
        let half_travel = self.half_width - (radius - self.corner_radius);
        if half_travel < 0.0 || self.lean < 0.0 {
            return Err(MillingError::RootBottom { u, half_width: self.half_width, radius, lean: self.lean });
        }
        Ok(BottomPass { half_travel, height: self.lowest[1] })
    }

    /// Points of the fillet from the straight piece to the lowest point, each with its normal out of the material, in the column plane.
    pub fn fillet(&self, count: usize) -> Vec<[[f64; 2]; 2]> {
        let (from, [x, y]) = (self.fillet_start, self.fillet_centre);
        let begin = (y - from[1]).atan2(x - from[0]);
        let at = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            [[x - self.corner_radius * cos, y - self.corner_radius * sin], [cos, sin]]
        };
        equidistant([begin, FRAC_PI_2], count).into_iter().map(at).collect()
    }

    /// Height of the roof that the flank passes alone leave over the lowest points in the middle, mm, if the end face of the tool
    /// reaches there; `None` if it does not.
    pub fn roof(&self, radius: f64) -> Option<f64> {
        let (sin, cos) = self.lean.sin_cos();
        let reach = self.half_width - self.corner_radius * sin;
        (2.0 * (radius - self.corner_radius) * cos >= reach)
            .then(|| self.corner_radius * (1.0 - cos) + reach * sin / cos)
    }
}

/// h_max: the greatest contact height of a row that keeps the tool's corner above a bottom, mm (end of
/// `docs/mathematics/milling.md#root-and-clearance`).
pub fn greatest_contact_height(
    lead: &LeadPoint,
    point: &Vector3<f64>,
    normal: &Vector3<f64>,
    axis: &Vector3<f64>,
    corner_radius: f64,
    bottom: f64,
) -> f64 {
    let side = if normal.dot(&lead.abscissa()) < 0.0 { 1.0 } else { -1.0 };
    let (sin, cos) = (side * axis.dot(&lead.abscissa()), axis.dot(&lead.base_normal));
    let [_, height] = lead.in_plane(point);
    corner_radius + (height - bottom - corner_radius * (1.0 - sin)) / cos
}
