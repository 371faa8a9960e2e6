//! The milled part as a mesh, its flanks with the deviation, and the paths of the cutter, for other programs.

use super::part_mesh::part;
use super::referee::RefereedFlank;
use super::run::MillingOutcome;
use job::tables::Mesh;
use run::NamedFile;
use scene::mesh::{
    MeshError, NamedMesh, PatchSide, PointData, PointValues, patch, stl, three_mf, vtp_of_mesh, vtp_of_paths,
};
use std::ops::Range;

/// Files of all formats that the job asks for.
///
/// # Errors
/// [`MeshError`].
pub(super) fn files(outcome: &MillingOutcome, formats: &[Mesh]) -> Result<Vec<NamedFile>, MeshError> {
    let mut files: Vec<NamedFile> = Vec::new();
    for format in formats {
        match format {
            Mesh::Stl => {
                files.push(("part.stl".into(), "the milled part, mm", stl(&part(&outcome.prepared.bodies)?)?))
            }
            Mesh::ThreeMf => {
                let (part, title) = (part(&outcome.prepared.bodies)?, &outcome.result.job);
                let named = [NamedMesh { name: "part", mesh: &part }];
                files.push(("part.3mf".into(), "the milled part", three_mf(title, &named)?));
            }
            Mesh::Vtk => {
                files.push(("paths.vtp".into(), "paths of the cutter in one space", paths(outcome)?));
                for (made, flank) in outcome.plan.flanks.iter().zip(&outcome.flanks) {
                    // Where no cutter comes by there is no number; 0 would be a lie, the file has NaN nowhere.
                    let whole = milled_lengths(flank);
                    let (mut points, mut deviation) = (Vec::new(), Vec::new());
                    for (&a, found) in flank.heights.iter().zip(flank.simulated.chunks(flank.lengths.len())) {
                        points.extend(
                            flank.lengths[whole.clone()].iter().map(|&b| made.active.surface.point(a, b)),
                        );
                        deviation.extend(found[whole.clone()].iter().flatten().map(|mm| 1e3 * mm));
                    }
                    if whole.len() < 2 {
                        continue;
                    }
                    let mesh = patch(&points, whole.len(), PatchSide::RowsTimesColumns)?;
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

/// The longest run of length parameters at which all rays have a length.
fn milled_lengths(flank: &RefereedFlank) -> Range<usize> {
    let columns = flank.lengths.len();
    let whole = |column: usize| flank.simulated.iter().skip(column).step_by(columns).all(Option::is_some);
    let (mut longest, mut from) = (0..0, 0);
    for column in 0..columns {
        if !whole(column) {
            from = column + 1;
        } else if column + 1 - from > longest.len() {
            longest = from..column + 1;
        }
    }
    longest
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
