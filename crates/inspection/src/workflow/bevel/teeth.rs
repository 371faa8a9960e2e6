//! From readings of a grid to deviations tooth by tooth: what covers the grid is a surface, the point in the middle alone tells the pitch.

use super::super::closed_loop::{GridTeeth, MilledBevel};
use foundation::geometry::{Flank, Sides};
use job::{Diagnostic, Problem, shown_number};
use measured_files::inspection::{GridReading, Touched};
use metrology::Topography;
use nalgebra::{Rotation3, Vector3};
use run::RunFailure;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A point that lies farther off its flank than this belongs to another place, mm.
const FARTHEST: f64 = 2.0;
/// Fewest points of a tooth that make a surface: the terms of one of third degree.
const FEWEST: usize = 10;

/// What was measured of a gear.
pub(super) struct MeasuredTeeth {
    /// Teeth with a surface.
    pub surfaces: Sides<GridTeeth>,
    /// Mean deviation of the point in the middle of each tooth, normal, mm.
    pub middles: Sides<BTreeMap<u32, f64>>,
}

/// Row and column of the point at which pitches are measured, from 0.
pub(super) fn middle(made: &MilledBevel) -> [usize; 2] {
    [made.grid.rows / 2, made.grid.columns / 2]
}

/// Sorts readings by flank and tooth.
///
/// # Errors
/// [`RunFailure`] for a point that is not near its flank, and for teeth of which too few points were measured.
pub(super) fn teeth_of(made: &MilledBevel, readings: &[GridReading]) -> Result<MeasuredTeeth, RunFailure> {
    let mut found: Sides<BTreeMap<u32, BTreeMap<u32, Vec<f64>>>> = Sides::default();
    let columns = made.grid.columns;
    let count = made.grid.rows * columns;
    for reading in readings {
        let deviation = deviation(made, reading)?;
        let of_tooth = found[reading.flank].entry(reading.tooth).or_default();
        let grid = of_tooth.entry(reading.reading).or_insert_with(|| vec![f64::NAN; count]);
        grid[(reading.row - 1) * columns + reading.column - 1] = deviation;
    }
    let [row, column] = middle(made);
    let at_middle = row * columns + column;
    let mut measured = MeasuredTeeth { surfaces: Sides::default(), middles: Sides::default() };
    for (flank, teeth) in found.iter() {
        let [w, z] = made.places(flank);
        for (tooth, readings) in teeth {
            let middles: Vec<f64> =
                readings.values().map(|grid| grid[at_middle]).filter(|f| f.is_finite()).collect();
            if !middles.is_empty() {
                measured.middles[flank].insert(*tooth, middles.iter().sum::<f64>() / middles.len() as f64);
            }
            for grid in readings.values() {
                let known = grid.iter().filter(|f| f.is_finite()).count();
                if known == usize::from(grid[at_middle].is_finite()) {
                    continue;
                }
                if known < FEWEST {
                    return Err(sparse(flank, *tooth, known, count));
                }
                let surface = Topography::new(w.clone(), z.clone(), grid.clone());
                measured.surfaces[flank].entry(*tooth).or_default().extend(surface);
            }
        }
    }
    Ok(measured)
}

/// Normal deviation from the target, mm.
fn deviation(made: &MilledBevel, reading: &GridReading) -> Result<f64, RunFailure> {
    let at = match reading.found {
        Touched::Deviation(um) => return Ok(1e-3 * um),
        Touched::At(point) => Vector3::from(point),
    };
    let pitch = TAU / f64::from(made.gear.data().teeth);
    let back = Rotation3::from_axis_angle(&Vector3::z_axis(), -pitch * f64::from(reading.tooth - 1));
    let [w, z] = made.places(reading.flank);
    let (roll, position) = (w[reading.row - 1], z[reading.column - 1]);
    let wanted = &made.wanted[reading.flank];
    let point = back * at;
    let far = (point - wanted.target(roll, position).point).norm();
    if let Some(distance) = wanted.distance(&point, roll, position).filter(|_| far <= FARTHEST) {
        return Ok(distance);
    }
    let text = format!(
        "row {}, column {} of the {} flank of tooth {} was measured {} mm beside its place",
        reading.row,
        reading.column,
        reading.flank,
        reading.tooth,
        shown_number((1e3 * far).round() / 1e3)
    );
    let finding = Diagnostic::new(Problem::InvalidTable, text)
        .field("x_mm")
        .value(format!("{}, {}, {}", at.x, at.y, at.z))
        .allowed(format!(
            "a point within {FARTHEST} mm of its place in measuring-grid.csv, tooth 1 about +y"
        ));
    let way_out = "count the teeth counter-clockwise from the space about +y as seen from +z, in mm and in coordinates of the workpiece";
    Err(RunFailure::bad_input(finding.way_out(way_out)))
}

fn sparse(flank: Flank, tooth: u32, known: usize, count: usize) -> RunFailure {
    let text = format!("{known} of {count} points of the {flank} flank of tooth {tooth} make no surface");
    let finding = Diagnostic::new(Problem::InvalidTable, text)
        .field("row")
        .value(format!("{known} points"))
        .allowed(format!("{FEWEST} points or more of a tooth, or the one in the middle alone for the pitch"));
    RunFailure::bad_input(finding.way_out("measure the whole grid of a few teeth"))
}
