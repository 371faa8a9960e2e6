//! Block `mounting_only`: an ideal tool mounted off its axis.

use super::super::expected::Expected;
use super::super::given::{Checked, array, check_object, text};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::example::SkivingExample;
use super::measured::Measured;
use foundation::numerics::extremes;
use serde_json::Value;
use skiving::evaluation::{ProfileOptions, evaluate};
use skiving::measuring::RealTool;

/// Neither bands nor wear are asked for here.
const WIDE: ProfileOptions = ProfileOptions { degree: 2, band: 1.0, wear_limit: 1.0 };

/// Block `mounting_only`.
pub(crate) fn mounting_only(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_array() else {
        return ledger.fail("mounting_only", "", block.clone(), "a list is needed here".into());
    };
    for item in list {
        let name = format!("mounting_only {}", item["example"].as_str().unwrap_or_default());
        let expected = Expected::new(&name, "", item, ledger);
        check_object(expected, ledger, |expected, ledger| check_item(reference, expected, ledger));
    }
}

fn check_item(reference: &Reference<'_>, expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked {
    let example = SkivingExample::named(reference, text(expected, "example", ledger)?)?;
    let eccentricity = array::<2>(expected, "ecc_in_um", ledger)?.map(|x| 1e-3 * x);
    let wobble = array::<2>(expected, "tilt_in_rad", ledger)?;
    let tool = RealTool { eccentricity, wobble, ..RealTool::ideal(example.teeth()) };
    let beam = example.beam;
    let (measured, _) = Measured::new(example, beam, tool)?;
    let found = evaluate(&measured.flanks, &measured.deviations, &WIDE)?;
    let tolerances = reference.tolerances();
    let um = tolerances.get("evaluation_um");
    let mounting = &found.mounting;
    expected.list("ecc_found_um", &mounting.eccentricity.map(|x| 1e3 * x), um, ledger);
    expected.list("tilt_found_rad", &mounting.wobble, tolerances.get("evaluation_rad"), ledger);
    let relative = |x: f64| tolerances.get("calibration_std_rel") * x;
    expected.list_to("std_per_unit_noise", &mounting.deviation_per_noise, relative, ledger);
    let means = &found.profile.track_means;
    let rest = found.remaining.map(|flank, track, _, f| f - means[flank][track]);
    let largest = extremes(rest.iter().map(|(.., f)| f.abs()))[1];
    expected.number("largest_rest_um", 1e3 * largest, um, ledger);
    Ok(())
}
