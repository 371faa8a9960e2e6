//! A closed body of revolution from its section.

use super::error::MeshError;
use super::triangle_mesh::TriangleMesh;
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// The body that a section (radius, z) makes when it turns about z, with `around` corners on every circle; mm. The section is a line from
/// the axis to the axis (a solid body), or a loop off the axis (a ring, whose last point is joined with its first); either sense. The
/// corners stand on the true circles.
///
/// # Errors
/// [`MeshError::TooFew`] for fewer than three points or corners, [`MeshError::InvalidNumber`] for a radius that is not positive between
/// the ends, those of [`TriangleMesh::check_watertight`].
pub fn revolved(section: &[[f64; 2]], around: usize) -> Result<TriangleMesh, MeshError> {
    for (what, least, found) in
        [("points of a section", 3, section.len()), ("corners of a circle", 3, around)]
    {
        if found < least {
            return Err(MeshError::TooFew { what, least, found });
        }
    }
    let most = u32::MAX as usize;
    let found = section.len().saturating_mul(around);
    if found > most {
        return Err(MeshError::TooMany { what: "vertices", most, found });
    }
    let last = section.len() - 1;
    let solid = section[0][0] == 0.0 && section[last][0] == 0.0;
    let on_axis = |point: usize| solid && (point == 0 || point == last);
    let mut mesh = TriangleMesh::default();
    // First vertex of every circle.
    let mut first = Vec::with_capacity(section.len());
    for (index, &[radius, z]) in section.iter().enumerate() {
        first.push(mesh.vertices.len() as u32);
        if on_axis(index) {
            mesh.vertices.push(Vector3::new(0.0, 0.0, z));
            continue;
        }
        if !(radius > 0.0 && radius.is_finite()) {
            let (what, allowed) = ("radius of a section, point".to_owned(), "> 0 mm between the ends");
            return Err(MeshError::InvalidNumber { what, index, value: radius, allowed });
        }
        mesh.vertices.extend((0..around).map(|k| {
            let (sin, cos) = (TAU * k as f64 / around as f64).sin_cos();
            Vector3::new(radius * cos, radius * sin, z)
        }));
    }
    let bands = if solid { last } else { section.len() };
    for here in 0..bands {
        let next = (here + 1) % section.len();
        for k in 0..around {
            let (at, after) = (k as u32, ((k + 1) % around) as u32);
            match (on_axis(here), on_axis(next)) {
                (true, _) => mesh.triangles.push([first[here], first[next] + at, first[next] + after]),
                (_, true) => mesh.triangles.push([first[here] + after, first[here] + at, first[next]]),
                _ => mesh.add_cell([
                    first[here] + after,
                    first[here] + at,
                    first[next] + at,
                    first[next] + after,
                ]),
            }
        }
    }
    let mesh = if mesh.volume() < 0.0 { mesh.turned() } else { mesh };
    mesh.check_watertight()?;
    Ok(mesh)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn rings_and_solids_hold_their_volume() {
        let around = 256;
        // Area of a regular polygon over that of its circle.
        let share = (TAU / around as f64).sin() * around as f64 / TAU;
        let ring = [[20.0, -3.0], [30.0, -3.0], [30.0, 5.0], [20.0, 5.0]];
        let cone = [[0.0, 0.0], [6.0, 0.0], [0.0, 9.0]];
        for (section, volume) in [(&ring[..], PI * 500.0 * 8.0), (&cone[..], PI * 12.0 * 9.0)] {
            let mut turned = section.to_vec();
            turned.reverse();
            for section in [section, &turned] {
                let mesh = revolved(section, around).unwrap();
                assert!((mesh.volume() - share * volume).abs() < 1e-9 * volume, "{}", mesh.volume());
            }
        }
    }

    #[test]
    fn a_section_that_bounds_nothing_is_refused() {
        let refused = |section: &[[f64; 2]], around| revolved(section, around).unwrap_err().code();
        assert_eq!(refused(&[[1.0, 0.0], [2.0, 0.0]], 8), "too-few");
        assert_eq!(refused(&[[1.0, 0.0], [2.0, 0.0], [2.0, 1.0]], 2), "too-few");
        assert_eq!(refused(&[[1.0, 0.0], [-2.0, 0.0], [2.0, 1.0]], 8), "invalid-number");
        assert_eq!(refused(&[[1.0, 0.0], [f64::NAN, 0.0], [2.0, 1.0]], 8), "invalid-number");
        assert_eq!(refused(&[[1.0, 0.0], [2.0, f64::INFINITY], [2.0, 1.0]], 8), "invalid-number");
    }
}
