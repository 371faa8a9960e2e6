//! Pitches and run-out of a bevel gear from the point in the middle of each tooth, and the classes of ISO 17485 that they reach.

use super::super::closed_loop::MilledBevel;
use super::super::result::{ClassResult, PitchInspectionResult};
use super::result::BevelPitchPlace;
use super::teeth::{MeasuredTeeth, middle};
use foundation::geometry::{Flank, Sides};
use metrology::inspection::{
    BevelQuantity, BevelToleranceGear, BevelTolerances, InspectionError, PitchPoint, bevel_pitch,
    bevel_run_out,
};
use nalgebra::Vector3;
use std::collections::BTreeMap;
use verdict::Remark;

/// What pitches come to.
#[derive(Default)]
pub(super) struct Pitches {
    pub place: Option<BevelPitchPlace>,
    pub flanks: BTreeMap<&'static str, PitchInspectionResult>,
    pub run_out_um: Option<f64>,
    pub classes: Vec<ClassResult>,
    pub tolerances: Option<BevelTolerances>,
    /// What could not be evaluated.
    pub remarks: Vec<Remark>,
}

/// Mean pitch diameter, which is the tolerance diameter of gears with equal addenda, and mean normal module, mm.
fn sizes(made: &MilledBevel) -> [f64; 2] {
    let (gear, data) = (&made.gear, made.gear.data());
    let mean = gear.mean_distance();
    let [_, turn, ..] = gear.line().derivatives(mean);
    // tan(beta) of the flank line on the pitch cone.
    let spiral = (mean * data.pitch_angle.sin() * turn).atan();
    let module = data.outer_transverse_module * mean / gear.outer_distance() * spiral.cos();
    [2.0 * mean * data.pitch_angle.sin(), module]
}

/// Of all that was measured.
pub(super) fn pitches(made: &MilledBevel, measured: &MeasuredTeeth) -> Pitches {
    let mut found = Pitches::default();
    let teeth = made.gear.data().teeth;
    let count = teeth as usize;
    let [diameter, module] = sizes(made);
    let gear = BevelToleranceGear { teeth, mean_normal_module: module, tolerance_diameter: diameter };
    let [row, column] = middle(made);
    let point = |flank: Flank| {
        let [w, z] = made.places(flank);
        let at = made.wanted[flank].target(w[row], z[column]);
        PitchPoint { point: at.point, normal: at.normal }
    };
    let points = Sides::from_fn(point);
    let whole = |flank: Flank| measured.middles[flank].len() == count;
    if !Flank::BOTH.into_iter().any(whole) {
        return found;
    }
    found.place = Some(BevelPitchPlace {
        row: row + 1,
        column: column + 1,
        radius_mm: points.left.point.xy().norm(),
        tolerance_diameter_mm: diameter,
        mean_normal_module_mm: module,
    });
    let list = |flank: Flank| measured.middles[flank].values().copied().collect::<Vec<f64>>();
    let mut values: Vec<(Option<&'static str>, BevelQuantity, f64)> = Vec::new();
    for flank in Flank::BOTH.into_iter().filter(|flank| whole(*flank)) {
        let pitch =
            bevel_pitch(&points[flank], &list(flank), count, diameter).and_then(|pitch| pitch.evaluate(None));
        match pitch {
            Err(error) => found.remarks.push(left_out(&format!("pitch of the {flank} flank"), &error)),
            Ok(pitch) => {
                let name = Some(flank.name());
                values.push((name, BevelQuantity::SinglePitch, pitch.single));
                values.push((name, BevelQuantity::TotalPitch, pitch.total));
                found.flanks.insert(flank.name(), PitchInspectionResult::of(&pitch));
            }
        }
    }
    if Flank::BOTH.into_iter().all(whole) {
        // Across the pitch cone in the middle of the space.
        let (sin, cos) = made.gear.data().pitch_angle.sin_cos();
        let across = Vector3::new(0.0, cos, -sin);
        match bevel_run_out(&points, &Sides::from_fn(list), across) {
            Err(error) => found.remarks.push(left_out("run-out", &error)),
            Ok(run_out) => {
                values.push((None, BevelQuantity::RunOut, run_out));
                found.run_out_um = Some(1e3 * run_out);
            }
        }
    }
    match BevelTolerances::new(&gear) {
        Err(error) => found.remarks.push(left_out("classes of ISO 17485", &error)),
        Ok(tolerances) => {
            found.classes.extend(values.into_iter().map(|(flank, quantity, value)| ClassResult {
                flank,
                quantity: quantity.symbol(),
                value_um: 1e3 * value,
                class: tolerances.reached(quantity, value).ok().flatten(),
            }));
            found.tolerances = Some(tolerances);
        }
    }
    found
}

fn left_out(what: &str, error: &InspectionError) -> Remark {
    Remark {
        code: error.code(),
        text: format!("{what}: not evaluated: {error}"),
        way_out: error.way_out().into(),
    }
}
