//! Pitch and run-out of a bevel gear from one point of each flank (`docs/mathematics/inspection.md#bevel-gears`): the normal deviation there
//! as a turn of the tooth about the axis of the gear, on the tolerance diameter, and as the way of a ball in the space.

use super::{InspectionError, PitchDeviations};
use foundation::geometry::Sides;
use foundation::numerics::extremes;
use nalgebra::{Matrix2, Vector2, Vector3};

/// The point of a flank at which its pitch is measured, in the space about +y. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PitchPoint {
    /// The point.
    pub point: Vector3<f64>,
    /// The normal out of the material.
    pub normal: Vector3<f64>,
}

impl PitchPoint {
    /// mm of normal deviation for each rad by which the tooth is turned about +z.
    fn lever(&self) -> f64 {
        Vector3::z().cross(&self.point).dot(&self.normal)
    }
}

/// Pitch deviations on a diameter (mm) from the normal deviations of all teeth (mm, tooth 1 first, counted counter-clockwise seen from +z).
///
/// # Errors
/// Those of [`PitchDeviations::from_cumulative`]; [`InspectionError::InvalidNumber`] for a normal that no turn changes.
pub fn bevel_pitch(
    point: &PitchPoint,
    deviations: &[f64],
    teeth: usize,
    diameter: f64,
) -> Result<PitchDeviations, InspectionError> {
    let lever = point.lever();
    if !(lever.is_finite() && lever.abs() > f64::EPSILON) {
        let (field, allowed) = ("lever of the pitch point, mm", "a normal that leans around the axis");
        return Err(InspectionError::InvalidNumber { field, value: lever, allowed });
    }
    let ways: Vec<f64> = deviations.iter().map(|f| 0.5 * diameter * f / lever).collect();
    PitchDeviations::from_cumulative(&ways, teeth)
}

/// Run-out, mm: largest less least way, across the pitch cone, of a ball that touches both flanks of a space, from their normal deviations.
/// `across`: the direction across the cone in the middle of the space about +y.
///
/// # Errors
/// [`InspectionError::WrongCount`] for flanks of different length; [`InspectionError::InvalidNumber`] for flanks between which no ball lies.
pub fn bevel_run_out(
    points: &Sides<PitchPoint>,
    deviations: &Sides<Vec<f64>>,
    across: Vector3<f64>,
) -> Result<f64, InspectionError> {
    let (found, needed) = (deviations.right.len(), deviations.left.len());
    if found != needed || needed == 0 {
        return Err(InspectionError::WrongCount { field: "spaces of the right flank", found, needed });
    }
    // The ball goes across the cone and around the axis; both flanks push it along their normals.
    let around = Vector3::z().cross(&across).normalize();
    let row = |normal: &Vector3<f64>| [normal.dot(&across), normal.dot(&around)];
    let ([a, b], [c, d]) = (row(&points.left.normal), row(&points.right.normal));
    let Some(inverse) = Matrix2::new(a, b, c, d).try_inverse() else {
        let (field, allowed) = ("lean of the flanks against each other", "two flanks that hold a ball");
        return Err(InspectionError::InvalidNumber { field, value: a * d - b * c, allowed });
    };
    let way = |(left, right): (&f64, &f64)| (inverse * Vector2::new(*left, *right)).x;
    let [least, greatest] = extremes(deviations.left.iter().zip(&deviations.right).map(way));
    Ok(greatest - least)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Flanks of a space about +y, pressure angle 20 degrees, on a cylinder (a bevel gear without cone).
    fn space(radius: f64) -> Sides<PitchPoint> {
        let (sin, cos) = 20f64.to_radians().sin_cos();
        let of = |side: f64| PitchPoint {
            point: Vector3::new(-side * 1.5, radius, 3.0),
            // Out of the material into the space and up.
            normal: Vector3::new(side * cos, sin, 0.0),
        };
        Sides { left: of(1.0), right: of(-1.0) }
    }

    #[test]
    fn a_turned_tooth_shows_its_way_on_both_flanks() {
        let (points, teeth, radius) = (space(50.0), 12, 50.0);
        // Tooth 3 is turned by 20 um on a radius of 40 mm, counter-clockwise.
        let turn = 0.02 / 40.0;
        for (_, point) in points.iter() {
            let moved = Vector3::z().cross(&point.point) * turn;
            let mut deviations = vec![0.0; teeth];
            deviations[2] = moved.dot(&point.normal);
            let found = bevel_pitch(point, &deviations, teeth, 80.0).unwrap();
            let pitch = found.evaluate(None).unwrap();
            assert!((found.single()[2] - 0.02).abs() < 1e-12 && (found.single()[3] + 0.02).abs() < 1e-12);
            assert!((pitch.single - 0.02).abs() < 1e-12 && (pitch.total - 0.02).abs() < 1e-12);
        }
        assert!(bevel_pitch(&points.left, &[0.0; 11], teeth, 80.0).is_err());
        let flat = PitchPoint { point: Vector3::new(0.0, radius, 0.0), normal: Vector3::y() };
        assert_eq!(bevel_pitch(&flat, &[0.0; 12], teeth, 80.0).unwrap_err().code(), "invalid-number");
    }

    #[test]
    fn an_eccentric_gear_runs_out_by_twice_its_eccentricity() {
        let points = space(50.0);
        let teeth = 36;
        let eccentricity = 0.013;
        let deviation = |point: &PitchPoint, tooth: usize| {
            // In the frame of the space the gear is shifted against the turn of the tooth.
            let angle = -std::f64::consts::TAU * tooth as f64 / teeth as f64;
            Vector3::new(angle.cos(), angle.sin(), 0.0).dot(&point.normal) * eccentricity
        };
        let of = |point: &PitchPoint| (0..teeth).map(|tooth| deviation(point, tooth)).collect::<Vec<f64>>();
        let deviations = Sides { left: of(&points.left), right: of(&points.right) };
        let found = bevel_run_out(&points, &deviations, Vector3::y()).unwrap();
        assert!((found - 2.0 * eccentricity).abs() < 1e-12, "{found}");
        let short = Sides { right: vec![0.0; 3], ..deviations };
        assert!(bevel_run_out(&points, &short, Vector3::y()).is_err());
        let same = Sides::both(points.left);
        let some = Sides::both(vec![0.0; 3]);
        assert_eq!(bevel_run_out(&same, &some, Vector3::y()).unwrap_err().code(), "invalid-number");
    }
}
