//! The milled part as a mesh, its flanks with the deviation, and the paths of the cutter, for other programs.

use super::run::MillingOutcome;
use crate::exchange::job::Mesh;
use crate::exchange::mesh::{
    MeshError, NamedMesh, PatchSide, PointData, PointValues, Section, TriangleMesh, patch, stl, swept,
    three_mf, vtp_of_mesh, vtp_of_paths,
};
use crate::geometry::Surface;
use crate::numerics::equidistant;
use crate::workflow::write::NamedFile;
use nalgebra::{Rotation3, Vector3};
use std::f64::consts::TAU;

/// Points from root to tip, and sections along the teeth.
const ALONG_HEIGHT: usize = 25;
const ALONG_LENGTH: usize = 33;
/// Corners of a bore or rim.
const AROUND: usize = 180;

/// Files of all formats that the job asks for.
///
/// # Errors
/// [`MeshError`].
pub(super) fn files(outcome: &MillingOutcome, formats: &[Mesh]) -> Result<Vec<NamedFile>, MeshError> {
    let mut files: Vec<NamedFile> = Vec::new();
    for format in formats {
        match format {
            Mesh::Stl => files.push(("part.stl".into(), "the milled part, mm", stl(&part(outcome)?)?)),
            Mesh::ThreeMf => {
                let (part, title) = (part(outcome)?, &outcome.result.job);
                let named = [NamedMesh { name: "part", mesh: &part }];
                files.push(("part.3mf".into(), "the milled part", three_mf(title, &named)?));
            }
            Mesh::Vtk => {
                files.push(("paths.vtp".into(), "paths of the cutter in one space", paths(outcome)?));
                for flank in &outcome.flanks {
                    let Some(space) = outcome.bodies.space.flanks.iter().find(|f| f.side == flank.side)
                    else {
                        continue;
                    };
                    let point = |a: f64, b: f64| space.active.surface.point(a, b);
                    let points: Vec<Vector3<f64>> = flank
                        .heights
                        .iter()
                        .flat_map(|&a| flank.lengths.iter().map(move |&b| point(a, b)))
                        .collect();
                    // Where no cutter comes by there is no number; 0 would be a lie, the file has NaN nowhere.
                    let Some(deviation) =
                        flank.simulated.iter().map(|mm| mm.map(|mm| 1e3 * mm)).collect::<Option<Vec<f64>>>()
                    else {
                        continue;
                    };
                    let mesh = patch(&points, flank.lengths.len(), PatchSide::RowsTimesColumns)?;
                    let data = [PointData { name: "deviation_um", values: PointValues::Scalars(&deviation) }];
                    let text = vtp_of_mesh(&mesh, &data)?.into_bytes();
                    let name = format!("flank-{}.vtp", flank.side);
                    files.push((name, "flank with its deviation", text));
                }
            }
        }
    }
    Ok(files)
}

fn paths(outcome: &MillingOutcome) -> Result<Vec<u8>, MeshError> {
    let (mut lines, mut axes, mut operations) = (Vec::new(), Vec::new(), Vec::new());
    for (number, operation) in outcome.plan.operations.iter().enumerate() {
        for path in &operation.paths {
            lines.push(path.places.iter().map(|place| place.tip).collect::<Vec<_>>());
            axes.extend(path.places.iter().map(|place| place.axis));
            let number = i32::try_from(number).unwrap_or(i32::MAX);
            operations.extend(path.places.iter().map(|_| number));
        }
    }
    let data = [
        PointData { name: "operation", values: PointValues::Integers(&operations) },
        PointData { name: "axis", values: PointValues::Vectors(&axes) },
    ];
    Ok(vtp_of_paths(&lines, &data)?.into_bytes())
}

/// The part: teeth all around, swept along their length with a bore or a rim; of blades the milled side of each.
fn part(outcome: &MillingOutcome) -> Result<TriangleMesh, MeshError> {
    let bodies = &outcome.bodies;
    let turn = |k: usize| {
        let angle = TAU * k as f64 / bodies.spaces as f64;
        Rotation3::from_axis_angle(&Vector3::z_axis(), angle)
    };
    let [first, .., second] = bodies.space.flanks.as_slice() else {
        let Some(flank) = bodies.space.flanks.first() else { return TriangleMesh::joined(&[]) };
        let lengths = equidistant(flank.active.face, ALONG_LENGTH);
        let heights = equidistant(flank.active.height_span(), ALONG_HEIGHT);
        let side = |k: usize| {
            let points: Vec<Vector3<f64>> = heights
                .iter()
                .flat_map(|&a| lengths.iter().map(move |&b| (a, b)))
                .map(|(a, b)| turn(k) * flank.active.surface.point(a, b))
                .collect();
            patch(&points, ALONG_LENGTH, PatchSide::RowsTimesColumns)
        };
        let sides = (0..bodies.spaces).map(side).collect::<Result<Vec<_>, _>>()?;
        return TriangleMesh::joined(&sides);
    };
    // The blank's section goes round from the tip at the first end to bore or rim there.
    let [[tip, _], _, [end, _], [start, _]] = bodies.blank;
    let internal = start > tip;
    let [from, to] = first.active.face;
    let section = |length: f64| {
        let of = |surface: &dyn Surface, span: [f64; 2]| -> Vec<Vector3<f64>> {
            equidistant(span, ALONG_HEIGHT).into_iter().map(|a| surface.point(a, length)).collect()
        };
        let left = of(&*first.active.surface, first.active.height_span());
        let right = of(&*second.active.surface, second.active.height_span());
        // Down one flank, along the root body, up the other one.
        let root = bodies.space.lead.at(length).map(|lead| lead.point);
        let foot = |point: &Vector3<f64>| match &root {
            Ok(root) => {
                let share = root.xy().norm() / point.xy().norm();
                Vector3::new(point.x * share, point.y * share, point.z)
            }
            Err(_) => *point,
        };
        let mut space: Vec<Vector3<f64>> = left.iter().rev().copied().collect();
        space.extend([foot(&left[0]), foot(&right[0])]);
        space.extend(right.iter().copied());
        let around = (0..bodies.spaces).flat_map(|k| {
            // Spaces follow each other in the sense in which the flanks of one do.
            let sense = if left[0].x > right[0].x { 1 } else { bodies.spaces - 1 };
            let turn = turn(k * sense % bodies.spaces);
            space.iter().map(move |point| turn * point).collect::<Vec<_>>()
        });
        let teeth: Vec<Vector3<f64>> = around.collect();
        let height = teeth.iter().map(|p| p.z).sum::<f64>() / teeth.len() as f64;
        let radius = start + (end - start) * (length - from) / (to - from);
        let circle: Vec<Vector3<f64>> = (0..AROUND)
            .map(|k| {
                let (sin, cos) = (TAU * k as f64 / AROUND as f64).sin_cos();
                Vector3::new(radius * cos, radius * sin, height)
            })
            .collect();
        if internal {
            Section { outline: circle, holes: vec![teeth] }
        } else {
            Section { outline: teeth, holes: vec![circle] }
        }
    };
    let sections: Vec<Section> =
        equidistant(first.active.face, ALONG_LENGTH).into_iter().map(section).collect();
    swept(&sections)
}
