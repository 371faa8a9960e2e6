//! Whether a whole cutter is outside of the body that holds the workpiece, and how far it has to be drawn back until it is.
//!
//! A convex body and a cutter are apart if a plane lies between them. The plane tried is the one that touches the body below the tip;
//! its normal u points out of the body. The cutter reaches towards the body, beyond its tip, by r sin psi - h cos psi for every disc
//! of radius r at height h, psi the angle between its axis and u.

use crate::{CutterPlace, MillingError, Retraction, retracted};
use foundation::geometry::{Cutter, CutterShape};
use nalgebra::Vector3;

/// A cutter and the body that it keeps out of.
#[derive(Clone, Debug)]
pub(super) struct SafeRoom {
    body: Retraction,
    /// Radius and height of the discs that reach farthest.
    discs: Vec<[f64; 2]>,
}

/// Longest way along the axis that is tried, mm.
const FARTHEST: f64 = 4096.0;
/// Halvings of the way: below a nanometre.
const HALVINGS: usize = 40;

impl SafeRoom {
    pub fn new(body: Retraction, cutter: &Cutter) -> Self {
        let mut discs = match *cutter.shape() {
            CutterShape::Conical { radius, half_angle, .. } => {
                let top = cutter.cutting_length();
                vec![[radius, 0.0], [radius + top * half_angle.tan(), top]]
            }
            CutterShape::Barrel { radius, .. } => vec![[radius, 0.0]],
        };
        discs.extend(cutter.steps().iter().map(|step| [step.radius, step.from]));
        Self { body, discs }
    }

    /// How far the cutter is out of the body at least, mm; below 0 it may reach into it. `dip`: share of its distance from the
    /// workpiece's axis that a tip keeps on a chord.
    pub fn clearance(&self, tip: &Vector3<f64>, axis: &Vector3<f64>, dip: f64) -> f64 {
        let rho = tip.xy().norm();
        let radial = if rho > 0.0 { Vector3::new(tip.x / rho, tip.y / rho, 0.0) } else { Vector3::zeros() };
        match self.body {
            Retraction::Outside(radius) => rho * dip - radius - self.reach(axis.dot(&radial)),
            Retraction::OutsideCone { half_angle, distance, apex } => {
                let (sin, cos) = half_angle.sin_cos();
                let out = radial * cos - Vector3::z() * sin;
                rho * dip * cos - (tip.z - apex) * sin - distance - self.reach(axis.dot(&out))
            }
            Retraction::Below(plane) => plane - tip.z - self.reach(-axis.z),
            Retraction::Inside(radius) => {
                // Towards the shank the tool comes nearer to the axis of the gear, so that only its discs on this side count.
                let cos = -axis.dot(&radial);
                let sin = (1.0 - cos * cos).max(0.0).sqrt();
                let edge = |[r, h]: &[f64; 2]| (rho - h * cos + r * sin).max(0.0).hypot(*r);
                if cos <= 0.0 && rho > 0.0 {
                    return f64::NEG_INFINITY;
                }
                radius - self.discs.iter().map(edge).fold(rho, f64::max)
            }
        }
    }

    /// How far the cutter reaches beyond its tip towards the body; `cos` of the angle between its axis and the way out.
    fn reach(&self, cos: f64) -> f64 {
        if cos <= 0.0 {
            // The shank leads into the body.
            return f64::INFINITY;
        }
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        self.discs.iter().map(|[r, h]| r * sin - h * cos).fold(0.0, f64::max)
    }

    /// A place with its tip outside, and the one farther along the axis at which the whole cutter is.
    ///
    /// # Errors
    /// [`MillingError::NoRetraction`].
    pub fn drawn_back(&self, place: &CutterPlace, dip: f64) -> Result<[CutterPlace; 2], MillingError> {
        let top = retracted(place, self.body)?;
        let at = |way: f64| self.clearance(&(top.tip + top.axis * way), &top.axis, dip);
        if at(0.0) >= 0.0 {
            return Ok([top, top]);
        }
        let mut enough = 1.0;
        while at(enough) < 0.0 {
            enough *= 2.0;
            if enough > FARTHEST {
                return Err(MillingError::NoRetraction { tip: top.tip.into(), axis: top.axis.into() });
            }
        }
        let mut short = 0.0;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (short + enough);
            if at(middle) >= 0.0 { enough = middle } else { short = middle }
        }
        Ok([top, CutterPlace { tip: top.tip + top.axis * enough, ..top }])
    }
}
