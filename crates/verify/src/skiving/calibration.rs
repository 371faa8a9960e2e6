//! Block `calibration`: the beam found again from where a mandrel switched it.

use super::super::expected::Expected;
use super::super::given::{Checked, array, check_object, number, vectors};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use nalgebra::{Vector2, Vector3};
use serde_json::Value;
use skiving::measuring::{Approach, BeamLine, Calibration, Mandrel, Observation};

/// The order of the observations: through in Y, an approach in X, at each height.
const ORDER: [Approach; 3] = [Approach::Y, Approach::Y, Approach::X];
/// How far before a switch the way of the mandrel begins, and how far behind it it ends, mm.
const WAY: f64 = 1.0;

/// Block `calibration`.
pub(crate) fn calibration(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_array() else {
        return ledger.fail("calibration", "", block.clone(), "a list is needed here".into());
    };
    for (k, item) in list.iter().enumerate() {
        let expected = Expected::new(&format!("calibration {k}"), "", item, ledger);
        check_object(expected, ledger, |expected, ledger| check_item(reference, expected, ledger));
    }
}

fn check_item(reference: &Reference<'_>, expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked {
    let mandrel = Mandrel {
        radius: number(expected, "mandrel_radius", ledger)?,
        height: number(expected, "mandrel_height", ledger)?,
    };
    let [first, second] = [number(expected, "Z1", ledger)?, number(expected, "Z2", ledger)?];
    let [x, y] = ["true_x_at_Z1mid", "true_y_at_Z1mid"].map(|key| number(expected, key, ledger));
    let slope = Vector2::new(number(expected, "tan_delta", ledger)?, number(expected, "tan_eps", ledger)?);
    let radius = number(expected, "r_L", ledger)?;
    let middle = first + 0.5 * mandrel.height;
    let beam = BeamLine { point: Vector2::new(x?, y?) - slope * middle, slope, radius };
    let start = BeamLine::from_numbers(array::<5>(expected, "start", ledger)?);
    let places = vectors(expected, "observations_XYZ")?;
    let observations: Vec<Observation> = places
        .iter()
        .zip(ORDER.iter().cycle())
        .map(|(place, along)| Observation { place: *place, along: *along })
        .collect();
    let tolerances = reference.tolerances();
    let mm = tolerances.get("calibration_mm");
    for (k, seen) in observations.iter().enumerate() {
        if seen.place.z != first && seen.place.z != second {
            return Err(format!("observations_XYZ[{k}]: Z1 or Z2 is needed here").into());
        }
        let found = switched(&mandrel, &beam, seen).ok_or_else(|| format!("observation {k}: no switch"))?;
        ledger.number(expected.case(), &format!("observations_XYZ[{k}]"), 0.0, found, mm);
    }
    let found = Calibration::fit(&mandrel, &observations, &start)?;
    expected.list("found", &found.line.numbers(), mm, ledger);
    if let Some(mut object) = expected.object("std_per_unit_sigma", ledger) {
        let keys = ["x_at_Z1mid", "y_at_Z1mid", "tan_delta", "tan_eps", "r_L"];
        for (key, actual) in keys.into_iter().zip(found.deviations_at(middle)) {
            object.number(key, actual, tolerances.get("calibration_std_rel") * actual.abs(), ledger);
        }
        object.finish(ledger);
    }
    let through = 0.5 * (places[0].y + places[1].y) - beam.at(middle).y;
    let um = tolerances.get("evaluation_um");
    expected.number("midpoint_error_Y_um_at_X_offset_0p3mm", 1e3 * through, um, ledger);
    Ok(())
}

/// How far from an observation the mandrel switches the beam on its way there from outside, mm.
fn switched(mandrel: &Mandrel, beam: &BeamLine, seen: &Observation) -> Option<f64> {
    let axis = match seen.along {
        Approach::X => Vector3::x(),
        Approach::Y => Vector3::y(),
    };
    let off = seen.place.xy() - beam.at(seen.place.z + 0.5 * mandrel.height);
    let inwards = -axis * off.dot(&axis.xy()).signum();
    let found = mandrel.switch(beam, &seen.place, &inwards, [-WAY, WAY])?;
    Some((found - seen.place).norm())
}
