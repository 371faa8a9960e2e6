//! A part of a flank that needs worm lines in one direction.

use super::polygon::{Corner, clip, rectangle};
use crate::{FlankLines, GeneratingError};
use foundation::geometry::Flank;
use foundation::modification::{CornerProfile, TriangularSpec};

/// Which lines a region needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Demand {
    /// Lines in the direction t_2 = tan(rho_2) on the workpiece.
    Direction(f64),
    /// Lines that the diagonal ratio K lays onto the workpiece; K != 0.
    Ratio(f64),
}

/// A polygon on a flank and the lines that it needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Flank.
    pub flank: Flank,
    /// Corners (w, z) in order, on the evaluated flank, mm.
    pub polygon: Vec<[f64; 2]>,
    /// The lines.
    pub demand: Demand,
}

impl Region {
    /// The region of a triangular end relief on a flank: where it removes anything, with lines along its start
    /// (`docs/mathematics/modifications.md`: tan(rho_2) = s_w s_z L_z/L_w). What lies beyond the evaluated flank is cut off.
    ///
    /// # Errors
    /// `InvalidNumber` for lengths that are not positive or a transition below 0.
    pub fn of_triangular_relief(
        relief: &TriangularSpec,
        lines: &FlankLines,
    ) -> Result<Self, GeneratingError> {
        let number = super::super::curve_law::number;
        let (l_w, l_z, h) = (relief.length_w_mm, relief.length_z_mm, relief.transition);
        number("length_w_mm", l_w, l_w.is_finite() && l_w > 0.0, "> 0 mm")?;
        number("length_z_mm", l_z, l_z.is_finite() && l_z > 0.0, "> 0 mm")?;
        number("transition", h, h.is_finite() && h >= 0.0, ">= 0")?;
        let (s_w, w_c) = match relief.corner_profile {
            CornerProfile::Tip => (1.0, lines.roll[1]),
            CornerProfile::Root => (-1.0, lines.roll[0]),
        };
        let (s_z, z_c) =
            if relief.corner_face.is_datum() { (1.0, lines.face[1]) } else { (-1.0, lines.face[0]) };
        // A rounded start (exponent 1) begins h earlier; a power law begins at x = 0.
        let reach = if relief.exponent > 1.0 { 1.0 } else { 1.0 + h };
        let x = |[w, z]: Corner| reach + s_w * (w - w_c) / l_w + s_z * (z - z_c) / l_z;
        let polygon = clip(&rectangle(lines.roll, lines.face), x);
        Ok(Self { flank: lines.flank(), polygon, demand: Demand::Direction(s_w * s_z * l_z / l_w) })
    }

    /// Direction and diagonal ratio that the region needs, after a check of its corners.
    ///
    /// # Errors
    /// `InvalidRegion`, `DegenerateDirection`.
    pub(super) fn needs(&self, region: usize, lines: &FlankLines) -> Result<[f64; 2], GeneratingError> {
        let invalid = |reason| Err(GeneratingError::InvalidRegion { region, flank: self.flank, reason });
        if self.polygon.len() < 3 {
            return invalid("fewer than three corners");
        }
        let on = |x: f64, [lo, hi]: [f64; 2]| x >= lo - super::SAME_PLACE && x <= hi + super::SAME_PLACE;
        // Written so that NaN lies outside.
        if !self.polygon.iter().all(|&[w, z]| on(w, lines.roll) && on(z, lines.face)) {
            return invalid("a corner outside the evaluated flank");
        }
        let degenerate = |ratio| GeneratingError::DegenerateDirection { flank: self.flank, ratio };
        match self.demand {
            Demand::Direction(t) if !t.is_finite() => invalid("a direction that is no number"),
            // The limit of `docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`.
            Demand::Direction(t) if (t - lines.t_k).abs() < 1e-6 => Err(degenerate(f64::INFINITY)),
            Demand::Direction(t) => Ok([t, lines.ratio_of_direction(t)]),
            Demand::Ratio(k) if !k.is_finite() => invalid("a diagonal ratio that is no number"),
            Demand::Ratio(0.0) => Err(degenerate(0.0)),
            Demand::Ratio(k) => Ok([lines.work_direction(k), k]),
        }
    }
}
