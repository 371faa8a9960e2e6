//! Evaluation of a measured tool and the correction of the setting that answers it.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, number, requires};
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::measured::Measured;
use foundation::geometry::{Flank, Sides};
use serde_json::{Value, json};
use skiving::evaluation::{Evaluation, ProfileOptions, correction, evaluate_all_teeth};
use skiving::{Setting, SettingLimits};

/// Degree of the compensation curve (`docs/mathematics/skiving.md#evaluation`).
const DEGREE: usize = 2;

/// Compares the evaluation and returns it.
pub(super) fn check_evaluation(
    tolerances: &Tolerances<'_>,
    measured: &Measured,
    outer: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked<Evaluation> {
    let mut expected = outer.object("evaluation", ledger).ok_or("evaluation is missing")?;
    let [band, wear_limit] =
        [number(&mut expected, "band_um", ledger)?, number(&mut expected, "wear_limit_um", ledger)?];
    let options = ProfileOptions { degree: DEGREE, band: 1e-3 * band, wear_limit: 1e-3 * wear_limit };
    let found = evaluate_all_teeth(&measured.flanks, &measured.deviations, &options)?;
    let [um, rad] = ["evaluation_um", "evaluation_rad"].map(|key| tolerances.get(key));
    let micrometres = |list: &[f64]| -> Vec<f64> { list.iter().map(|x| 1e3 * x).collect() };
    let (pitch, mounting, profile) = (&found.pitch, &found.mounting, &found.profile);
    expected.number("delta0_rad", found.clocking, rad, ledger);
    expected.list("ecc_um", &micrometres(&mounting.eccentricity), um, ledger);
    expected.list("tilt_rad", &mounting.wobble, rad, ledger);
    let relative = |x: f64| tolerances.get("calibration_std_rel") * x;
    expected.list_to("rigid_fit_std_per_unit_noise", &mounting.deviation_per_noise, relative, ledger);
    let left_out: Vec<i64> = mounting.left_out.iter().map(|&tooth| tooth as i64).collect();
    expected.wholes("teeth_excluded_from_rigid_fit", &left_out, ledger);
    expected.list("single_pitch_um", &micrometres(&pitch.single), um, ledger);
    expected.list("cumulative_pitch_um", &micrometres(&pitch.cumulative), um, ledger);
    expected.numbers(
        &[("f_p_max_um", 1e3 * pitch.largest_single), ("F_p_um", 1e3 * pitch.total)],
        um,
        ledger,
    );
    expected.list("centre_first_harmonic_cos_sin_rad", &pitch.first_harmonic, rad, ledger);
    expected.list("tooth_thickness_dev_mid_um", &micrometres(&pitch.thickness), um, ledger);
    for (key, of) in
        [("compensation_curve_coeff_um", &profile.curve), ("track_mean_um", &profile.track_means)]
    {
        check_flanks(&mut expected, key, of, um, ledger);
    }
    check_teeth(&mut expected, "teeth_out_of_band", &profile.out_of_band, ledger);
    if let Some(mut worn) = expected.object("worn", ledger) {
        for flank in Flank::BOTH {
            if let Some(value) = worn.take(flank.name()) {
                ledger.equal(
                    worn.case(),
                    &worn.name(flank.name()),
                    value.clone(),
                    profile.worn[flank].into(),
                );
            }
        }
        worn.finish(ledger);
    }
    expected.finish(ledger);
    Ok(found)
}

/// Compares the correction of the setting, if the file has one.
pub(super) fn check_corrections(
    tolerances: &Tolerances<'_>,
    measured: &Measured,
    evaluation: &Evaluation,
    outer: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let Some(expected) = outer.object("corrections", ledger) else { return Ok(()) };
    check_object(expected, ledger, |expected, ledger| {
        requires(expected, "parameters", &["d, gamma, phi_1 (z_V1 held)"], ledger)?;
        let fit = correction(&measured.flanks, evaluation, (&Setting::USUAL, &SettingLimits::default()))?;
        let um = tolerances.get("evaluation_um");
        check_flanks(expected, "predicted_f2_um", &evaluation.profile.workpiece, um, ledger);
        expected.number("delta_d_mm", fit.change[0], tolerances.get("length_mm"), ledger);
        let degrees = tolerances.get("angle_deg");
        expected.number("delta_gamma_deg", fit.change[1].to_degrees(), degrees, ledger);
        expected.number("delta_phi_1_deg", fit.change[3].to_degrees(), degrees, ledger);
        let residual: Vec<f64> = fit.residual.iter().map(|x| 1e3 * x).collect();
        expected.list("residual_um", &residual, um, ledger);
        let [before, after] = fit.rms;
        expected.numbers(&[("rms_before_um", 1e3 * before), ("rms_after_um", 1e3 * after)], um, ledger);
        expected.list("singular_values", &fit.singular_values, tolerances.get("sensitivity"), ledger);
        Ok(())
    });
    Ok(())
}

/// Compares a list for each flank, mm against um.
fn check_flanks(
    expected: &mut Expected<'_>,
    key: &str,
    actual: &Sides<Vec<f64>>,
    um: f64,
    ledger: &mut Ledger,
) {
    let Some(mut object) = expected.object(key, ledger) else { return };
    for flank in Flank::BOTH {
        let values: Vec<f64> = actual[flank].iter().map(|x| 1e3 * x).collect();
        object.list(flank.name(), &values, um, ledger);
    }
    object.finish(ledger);
}

/// Compares a set of teeth with their flanks, whatever its order.
fn check_teeth(expected: &mut Expected<'_>, key: &str, actual: &[(Flank, usize)], ledger: &mut Ledger) {
    let Some(value) = expected.take(key) else { return };
    let sorted = |list: Vec<Value>| {
        let mut list = list;
        list.sort_by_key(|pair| (pair[0].as_str().map(str::to_owned), pair[1].as_u64()));
        Value::from(list)
    };
    let found = actual.iter().map(|(flank, tooth)| json!([flank.name(), tooth])).collect();
    let wanted = value.as_array().cloned().map_or_else(|| value.clone(), sorted);
    ledger.equal(expected.case(), &expected.name(key), wanted, sorted(found));
}
