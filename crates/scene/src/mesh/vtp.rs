//! VTK XML PolyData (.vtp): meshes and tool paths with values at their points.

use super::error::MeshError;
use super::triangle_mesh::{TriangleMesh, check_points};
use super::vtk_document::VtkDocument;
use job::xml::escape;
use nalgebra::Vector3;

/// Values of one quantity at the points, with the name under which a viewer offers it; the name carries the unit, e.g. `deviation_um`.
#[derive(Clone, Copy, Debug)]
pub struct PointData<'a> {
    /// The name.
    pub name: &'a str,
    /// One value for each point.
    pub values: PointValues<'a>,
}

/// The values of a quantity.
#[derive(Clone, Copy, Debug)]
pub enum PointValues<'a> {
    /// Numbers, e.g. a deviation or a block time.
    Scalars(&'a [f64]),
    /// Whole numbers, e.g. the row.
    Integers(&'a [i32]),
    /// Vectors, e.g. the tool axis.
    Vectors(&'a [Vector3<f64>]),
}

/// A mesh with values at its vertices, in the vertices' order. Positions in mm and double precision.
///
/// # Errors
/// Those of [`TriangleMesh::check`]; [`MeshError::WrongCount`], [`MeshError::InvalidNumber`] and [`MeshError::DuplicateName`] for point
/// data that do not fit; [`MeshError::TooMany`] for more corners than can be numbered.
pub fn vtp_of_mesh(mesh: &TriangleMesh, data: &[PointData<'_>]) -> Result<String, MeshError> {
    mesh.check()?;
    check_data(data, mesh.vertices.len())?;
    check_numbers("corners of triangles", 3 * mesh.triangles.len())?;
    check_numbers("vertices", mesh.vertices.len())?;
    let corners = mesh.triangles.iter().flatten().map(|&corner| corner as i32);
    let ends = (1..=mesh.triangles.len()).map(|count| 3 * count as i32);
    let cells = Cells { element: "Polys", count: mesh.triangles.len() };
    Ok(document(&mesh.vertices, data, &cells, corners, ends))
}

/// Tool paths as lines through points (mm) with values at the points: `data` counts through all points, path after path.
///
/// # Errors
/// [`MeshError::TooFew`] without a path or for a path of fewer than two points, and those of [`vtp_of_mesh`] for points and data.
pub fn vtp_of_paths(paths: &[Vec<Vector3<f64>>], data: &[PointData<'_>]) -> Result<String, MeshError> {
    if paths.is_empty() {
        return Err(MeshError::TooFew { what: "paths", least: 1, found: 0 });
    }
    if let Some(path) = paths.iter().find(|path| path.len() < 2) {
        return Err(MeshError::TooFew { what: "points of a path", least: 2, found: path.len() });
    }
    let points = paths.concat();
    check_points("path point", &points)?;
    check_data(data, points.len())?;
    check_numbers("path points", points.len())?;
    let ends = paths.iter().scan(0, |end, path| {
        *end += path.len() as i32;
        Some(*end)
    });
    let cells = Cells { element: "Lines", count: paths.len() };
    Ok(document(&points, data, &cells, 0..points.len() as i32, ends))
}

/// What the points are joined to.
struct Cells {
    element: &'static str,
    count: usize,
}

fn document(
    points: &[Vector3<f64>],
    data: &[PointData<'_>],
    cells: &Cells,
    connectivity: impl Iterator<Item = i32>,
    ends: impl Iterator<Item = i32>,
) -> String {
    let mut document = VtkDocument::default();
    let Cells { element, count } = cells;
    document.line(&format!(
        r#"<Piece NumberOfPoints="{}" NumberOfVerts="0" NumberOf{element}="{count}" NumberOfStrips="0" NumberOf{}="0">"#,
        points.len(),
        if *element == "Lines" { "Polys" } else { "Lines" },
    ));
    // A viewer colours by the first quantity without being asked.
    let shown = data.iter().find(|d| !matches!(d.values, PointValues::Vectors(_)));
    let shown = shown.map_or(String::new(), |d| format!(" Scalars=\"{}\"", escape(d.name)));
    document.line(&format!("<PointData{shown}>"));
    for set in data {
        match set.values {
            PointValues::Scalars(values) => document.numbers(set.name, values),
            PointValues::Integers(values) => document.integers(set.name, values.iter().copied()),
            PointValues::Vectors(values) => document.vectors(set.name, values),
        }
    }
    document.line("</PointData>\n<Points>");
    document.vectors("Points", points);
    document.line(&format!("</Points>\n<{element}>"));
    document.integers("connectivity", connectivity);
    document.integers("offsets", ends);
    document.line(&format!("</{element}>\n</Piece>"));
    document.finish("PolyData")
}

fn check_data(data: &[PointData<'_>], points: usize) -> Result<(), MeshError> {
    for (i, set) in data.iter().enumerate() {
        if data[..i].iter().any(|other| other.name == set.name) {
            return Err(MeshError::DuplicateName { name: set.name.to_owned() });
        }
        let (found, bad) = match set.values {
            PointValues::Scalars(values) => (values.len(), first_not_finite(values.iter().copied(), 1)),
            PointValues::Integers(values) => (values.len(), None),
            PointValues::Vectors(values) => {
                (values.len(), first_not_finite(values.iter().flat_map(|v| [v.x, v.y, v.z]), 3))
            }
        };
        if found != points {
            let what = format!("values of `{}`", set.name);
            return Err(MeshError::WrongCount { what, expected: points, found });
        }
        if let Some((index, value)) = bad {
            let what = format!("`{}` at point", set.name);
            return Err(MeshError::InvalidNumber { what, index, value, allowed: "finite" });
        }
    }
    Ok(())
}

/// Place and value of the first number that is not finite, counted in groups.
fn first_not_finite(mut values: impl Iterator<Item = f64>, group: usize) -> Option<(usize, f64)> {
    let mut last = 0.0;
    let place = values.position(|value| {
        last = value;
        !value.is_finite()
    })?;
    Some((place / group, last))
}

fn check_numbers(what: &'static str, found: usize) -> Result<(), MeshError> {
    let most = i32::MAX as usize;
    if found > most { Err(MeshError::TooMany { what, most, found }) } else { Ok(()) }
}
