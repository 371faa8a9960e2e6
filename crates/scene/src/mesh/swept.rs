//! A closed body between sections: walls from section to section, end faces on the first and the last.

use super::cap::cap;
use super::error::MeshError;
use super::section::Section;
use super::triangle_mesh::{TriangleMesh, check_points};

/// The closed body through `sections` in their order: point i of a loop runs to point i of the same loop of the next section. The normals
/// point outwards whatever the sense of the loops. The end faces are plane if the first and the last section are; otherwise they are
/// divided as seen along the axis closest to their normal (the back cone of a bevel gear).
///
/// Whether walls pass through each other between the sections is not looked at.
///
/// # Errors
/// [`MeshError::TooFew`] for fewer than two sections or three points of a loop, [`MeshError::WrongCount`] for sections of unequal
/// counts, [`MeshError::OutlineNotSimple`] for an end face that crosses itself, those of [`TriangleMesh::check_watertight`].
pub fn swept(sections: &[Section]) -> Result<TriangleMesh, MeshError> {
    let [first, .., last] = sections else {
        return Err(MeshError::TooFew { what: "sections of a body", least: 2, found: sections.len() });
    };
    for (number, section) in sections.iter().enumerate() {
        check_section(number, section, first)?;
    }
    let per_section: usize = first.loops().map(Vec::len).sum();
    let most = u32::MAX as usize;
    let found = per_section.saturating_mul(sections.len());
    if found > most {
        return Err(MeshError::TooMany { what: "vertices", most, found });
    }

    let (bottom, top) = (cap(first, 0)?, cap(last, sections.len() - 1)?);
    let vertices = sections.iter().flat_map(|section| section.loops().flatten().copied()).collect();
    let mut mesh = TriangleMesh { vertices, triangles: Vec::new() };
    let last_vertex = (per_section * (sections.len() - 1)) as u32;
    mesh.triangles.extend(bottom.triangles.iter().map(|&[a, b, c]| [a, c, b]));
    mesh.triangles.extend(top.triangles.iter().map(|corners| corners.map(|corner| corner + last_vertex)));
    for section in 0..sections.len() - 1 {
        let mut start = section * per_section;
        for (number, points) in first.loops().enumerate() {
            // The material lies to the left of an outline and to the right of a hole that both run counterclockwise.
            let material_left = bottom.with_outline[number] == (number == 0);
            for i in 0..points.len() {
                let (here, next) = ((start + i) as u32, (start + (i + 1) % points.len()) as u32);
                let (here, next) = if material_left { (here, next) } else { (next, here) };
                let step = per_section as u32;
                mesh.add_cell([here, next, next + step, here + step]);
            }
            start += points.len();
        }
    }
    // Sections that follow each other against the sense of their outline make the body inside out.
    let mesh = if mesh.volume() < 0.0 { mesh.turned() } else { mesh };
    mesh.check_watertight()?;
    Ok(mesh)
}

/// A section must have finite points and the counts of the first one.
fn check_section(number: usize, section: &Section, first: &Section) -> Result<(), MeshError> {
    let (expected, found) = (first.holes.len(), section.holes.len());
    if expected != found {
        return Err(MeshError::WrongCount { what: format!("holes of section {number}"), expected, found });
    }
    for (number_of_loop, (points, pattern)) in section.loops().zip(first.loops()).enumerate() {
        let name =
            if number_of_loop == 0 { "outline".to_owned() } else { format!("hole {}", number_of_loop - 1) };
        if pattern.len() < 3 {
            return Err(MeshError::TooFew { what: "points of a loop", least: 3, found: pattern.len() });
        }
        let (expected, found) = (pattern.len(), points.len());
        if expected != found {
            let what = format!("points of the {name} of section {number}");
            return Err(MeshError::WrongCount { what, expected, found });
        }
        check_points(&format!("the {name} of section {number}, point"), points)?;
    }
    Ok(())
}
