//! Discs as closed meshes: a dressing disc from its profile down to a bore. Knows no worm and no motion.

use dressing::{DresserSection, DressingError, SectionPart, TipDisc};
use foundation::geometry::Revolution;
use foundation::numerics::equidistant;
use scene::mesh::{MeshError, TriangleMesh, revolved};
use std::f64::consts::TAU;

/// Corners of a circle: the edges of a disc of 120 mm stand 0.02 mm inside it.
const AROUND: usize = 160;
/// Points of a flank of the profile.
const PROFILE: usize = 20;
/// Radius of the bore as a share of the outside radius.
const BORE: f64 = 0.35;
/// Points of the rounding of a narrow disc.
const ROUNDING: usize = 24;

/// A disc whose rim runs through (radius, z) from one side to the other, mm.
///
/// # Errors
/// [`MeshError`].
fn disc(mut rim: Vec<[f64; 2]>) -> Result<TriangleMesh, MeshError> {
    let outside = rim.iter().map(|point| point[0]).fold(0.0, f64::max);
    if let (Some(&[_, first]), Some(&[_, last])) = (rim.first(), rim.last()) {
        rim.extend([[BORE * outside, last], [BORE * outside, first]]);
    }
    revolved(&rim, AROUND)
}

/// A dresser with a land of width `tip_land` (mm) in coordinates of its active flank.
///
/// # Errors
/// A land that this dresser cannot have, and a mesh that cannot be made.
pub fn dresser_disc(
    section: &DresserSection<'_>,
    tip_land: f64,
) -> Result<Result<TriangleMesh, MeshError>, DressingError> {
    let along = |part: SectionPart| -> Result<Vec<[f64; 2]>, DressingError> {
        equidistant([0.0, 1.0], PROFILE)
            .into_iter()
            .map(|share| section.point(part, share, tip_land))
            .collect()
    };
    let mut rim = along(SectionPart::ActiveFlank)?;
    rim.reverse();
    let other = along(SectionPart::CounterFlank)?;
    // Without a land both flanks meet in one point.
    let shared = usize::from(tip_land < 1e-6);
    rim.extend(&other[shared..]);
    Ok(disc(rim))
}

/// A disc between two profiles over the same interval of their parameter, the greater radius at its end.
///
/// # Errors
/// [`MeshError`].
pub fn profiled_disc(sides: [&Revolution; 2], interval: [f64; 2]) -> Result<TriangleMesh, MeshError> {
    let along = |side: &Revolution| -> Vec<[f64; 2]> {
        let at = |t: f64| {
            let point = side.at(t);
            [point.r, point.z]
        };
        equidistant(interval, PROFILE).into_iter().map(at).collect()
    };
    let mut rim = along(sides[0]);
    rim.extend(along(sides[1]).into_iter().rev());
    disc(rim)
}

/// A narrow disc with a rounded rim.
///
/// # Errors
/// [`MeshError`].
pub fn narrow_disc(form: &TipDisc) -> Result<TriangleMesh, MeshError> {
    let (centre, radius) = (form.centre_radius(), form.tip_radius());
    let rim = (0..=ROUNDING).map(|k| {
        let (sin, cos) = (0.5 * TAU * k as f64 / ROUNDING as f64).sin_cos();
        [centre + radius * sin, radius * cos]
    });
    disc(rim.collect())
}
