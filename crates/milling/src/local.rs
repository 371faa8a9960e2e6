//! What a cutter does near its contact (`docs/mathematics/milling.md#scallops-chords-local-gouging`): curvatures of flank and cutter, gouging,
//! the scallop between rows and the error of straight blocks.

use super::{ContactZone, CutterLocation, MillingError};
use foundation::geometry::{CutterShape, SurfaceJet};
use nalgebra::{Matrix2, Vector2, Vector3};

/// Flank and cutter in the tangent plane of their contact, to the second order. 1/mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalContact {
    /// K: curvatures of the flank in the basis (along the axis, across), convex > 0.
    pub flank: Matrix2<f64>,
    /// Q: those of the gap between flank and cutter.
    pub gap: Matrix2<f64>,
    /// v_1 and v_2: the basis.
    pub basis: [Vector3<f64>; 2],
    /// Radius of the cutter across its profile, mm: where the tip runs beside a curved row.
    offset_radius: f64,
}

/// A gap may be this much less open than flat before it counts as gouging, 1/mm: rounding of a contact along a line, whose least
/// eigenvalue is 0. At a distance of 1 mm from the contact it is 5e-10 mm.
const CLOSED: f64 = 1e-9;

impl LocalContact {
    /// Curvatures at a contact.
    pub fn new(jet: &SurfaceJet, location: &CutterLocation, shape: &CutterShape) -> Self {
        let normal = &jet.normal;
        let along = -normal.dot(&location.axis);
        let across = (1.0 - along * along).sqrt();
        let first = (location.axis - normal * normal.dot(&location.axis)).normalize();
        let basis = [first, normal.cross(&first)];
        let [k_11, k_12, k_22] = jet.curvatures(&basis[0], &basis[1]);
        let flank = Matrix2::new(k_11, k_12, k_12, k_22);
        let side_radius = location.contact_radius / across;
        let (profile, offset_radius) = match (shape, location.zone) {
            (CutterShape::Conical { corner_radius, .. }, ContactZone::Corner) => {
                // Of a corner, the tip runs beside the corner's circle; of a ball that is the ball.
                (1.0 / corner_radius, *corner_radius)
            }
            (CutterShape::Barrel { profile_radius, .. }, _) => (1.0 / profile_radius, side_radius),
            (CutterShape::Conical { .. }, _) => (0.0, side_radius),
        };
        let gap = flank + Matrix2::new(profile, 0.0, 0.0, 1.0 / side_radius);
        Self { flank, gap, basis, offset_radius }
    }

    /// The least eigenvalue of the gap's curvatures, 1/mm: below 0 the cutter digs into the flank around its contact.
    pub fn least_opening(&self) -> f64 {
        let (mean, half) = (0.5 * self.gap.trace(), 0.5 * (self.gap.m11 - self.gap.m22));
        mean - half.hypot(self.gap.m12)
    }

    /// Refuses a contact around which the cutter digs into the flank.
    ///
    /// # Errors
    /// [`MillingError::GougeLocal`].
    pub fn check(&self, jet: &SurfaceJet) -> Result<(), MillingError> {
        let least = self.least_opening();
        if least >= -CLOSED {
            Ok(())
        } else {
            Err(MillingError::GougeLocal { point: jet.point.into(), least })
        }
    }

    /// A direction of the tangent plane in the basis, made a unit vector.
    fn in_basis(&self, direction: &Vector3<f64>) -> Vector2<f64> {
        Vector2::new(direction.dot(&self.basis[0]), direction.dot(&self.basis[1])).normalize()
    }

    /// kappa_eff: curvature of what stays between rows that run along `feed`, 1/mm.
    pub fn effective_curvature(&self, feed: &Vector3<f64>) -> f64 {
        let f = self.in_basis(feed);
        self.gap.determinant() / f.dot(&(self.gap * f))
    }

    /// Height of what stays between two rows at this distance, mm.
    pub fn scallop(&self, feed: &Vector3<f64>, row_distance: f64) -> f64 {
        self.effective_curvature(feed) * row_distance * row_distance / 8.0
    }

    /// k_chord: curvature of the row as the cutter's straight blocks meet it, 1/mm.
    pub fn chord_curvature(&self, feed: &Vector3<f64>) -> f64 {
        let f = self.in_basis(feed);
        let turned = self.flank * f;
        f.dot(&turned) + self.offset_radius * turned.norm_squared()
    }

    /// What a straight block of this length leaves in its middle, mm: > 0 stock, < 0 gouge.
    pub fn chord(&self, feed: &Vector3<f64>, block_length: f64) -> f64 {
        -self.chord_curvature(feed) * block_length * block_length / 8.0
    }
}

/// D: distance of two points of neighbouring rows across the feed, mm.
pub fn row_distance(feed: &Vector3<f64>, between: &Vector3<f64>) -> f64 {
    let along = feed.normalize();
    (between - along * between.dot(&along)).norm()
}
