//! Block `closed_loop`: columns of the settings, corrections of two rounds, what the flank is after each. The flank of the second round comes
//! from the exact contact: hidden errors of the settings are known here, wave and anything else hidden stay as they were measured.

use super::super::expected::Expected;
use super::super::given::{Checked, list, number, requires};
use super::super::ledger::Ledger;
use super::super::reference::{Reference, Tolerances};
use super::each_case::each_case;
use super::grinding::{Grinding, UM, key, unit};
use super::loop_input::{Hidden, bounds, settings_used};
use foundation::geometry::Flank;
use foundation::kinematics::MotionLaw;
use foundation::numerics::root_mean_square;
use generating::correction::{ClosedLoop, Correction, FlankPoint, Setting, SettingInfluence, SettingsFlank};
use serde_json::Value;

/// What the second round may differ by where a wave was hidden that a forward model does not know, um (`docs/mathematics/inspection.md`).
const SECOND_ROUND: f64 = 0.02;

/// Block `closed_loop`.
pub(crate) fn closed_loop(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each_case("closed_loop", block, ledger, |input, tolerances, case, ledger| {
        let mut expected = case.object("expected", ledger).ok_or("expected is missing")?;
        let grinding = Grinding::read(input, ledger)?;
        let influence = SettingInfluence::new(&grinding.lines, grinding.ratio, grinding.face_width)?;
        let points = grinding.grid(input)?;
        let hidden = Hidden::read(input, ledger)?;
        requires(input, "order", &["left flank points first, i = w outer, j = z inner"], ledger)?;
        let measured = list(input, "deviation_um", ledger)?;
        let used = settings_used(input)?;
        let bounds = bounds(input, &used)?;
        let kappa = number(input, "kappa", ledger)?;
        ledger.number(expected.case(), "kappa", 1.0, kappa, 0.0);
        check_columns(&grinding, &influence, &points, tolerances, &mut expected, ledger)?;
        let deviations: Vec<f64> = measured.iter().map(|f| f * UM).collect();
        let run = Run { grinding: &grinding, influence: &influence, points: &points, used: &used };
        run.check_hidden(&hidden, &measured, tolerances, &expected, ledger)?;
        run.check_rounds(&hidden, &deviations, bounds, tolerances, &mut expected, ledger)?;
        expected.finish(ledger);
        Ok(())
    });
}

/// Geometry behind the columns and their first and last rows.
fn check_columns(
    grinding: &Grinding,
    influence: &SettingInfluence<'_>,
    points: &[FlankPoint],
    tolerances: Tolerances<'_>,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let relative = tolerances.get("correction_relative");
    let lines = &grinding.lines;
    let per_flank: [(&str, &dyn Fn(Flank) -> f64); 6] = [
        ("tan_rho_2", &|flank| influence.directions()[flank]),
        ("sin_alpha_n", &|flank| lines[flank].sin_an),
        ("C_c2_mm", &|flank| lines[flank].c_c2),
        ("t_K", &|flank| lines[flank].t_k),
        ("w_f_mm", &|flank| grinding.fields[flank].roll()[0]),
        ("w_a_mm", &|flank| grinding.fields[flank].roll()[1]),
    ];
    for (key, value) in per_flank {
        let Some(mut object) = expected.object(key, ledger) else { continue };
        for flank in Flank::BOTH {
            object.number(flank.name(), value(flank), relative * value(flank).abs(), ledger);
        }
        object.finish(ledger);
    }
    expected.number("z_V2_pivot_mm", influence.pivot(), relative * grinding.face_width, ledger);
    let names: Vec<String> = Setting::USUAL.into_iter().map(key).collect();
    if let Some(listed) = expected.take("J_columns") {
        ledger.equal(expected.case(), "J_columns", listed.clone(), serde_json::to_value(&names)?);
    }
    let columns = influence.columns(&Setting::USUAL, points)?;
    for (key, row) in [("J_first_row", 0), ("J_last_row", points.len() - 1)] {
        let per_unit = |(column, setting): (&generating::correction::Column, Setting)| {
            column.values[row] * unit(setting) / UM
        };
        let row: Vec<f64> = columns.iter().zip(Setting::USUAL).map(per_unit).collect();
        expected.list_to(key, &row, |e| relative * e.abs().max(relative), ledger);
    }
    Ok(())
}

/// A case being worked through.
struct Run<'a> {
    grinding: &'a Grinding,
    influence: &'a SettingInfluence<'a>,
    points: &'a [FlankPoint],
    used: &'a [Setting],
}

impl Run<'_> {
    /// The flank that the hidden errors leave, wave excepted, mm.
    fn ground(&self, settings: &[(Setting, f64)], delta_gamma: f64) -> Checked<Vec<f64>> {
        let motion = self.grinding.pair.motion(MotionLaw::polynomial(0.0, vec![0.0, self.grinding.ratio]));
        let flank = SettingsFlank::new(&self.grinding.pair, self.influence, &motion);
        Ok(flank.exact(settings, delta_gamma, self.points)?)
    }

    /// Where no wave was hidden the exact contact gives the measured flank; where one was, it stays within it.
    fn check_hidden(
        &self,
        hidden: &Hidden,
        measured: &[f64],
        tolerances: Tolerances<'_>,
        expected: &Expected<'_>,
        ledger: &mut Ledger,
    ) -> Checked {
        let ground = self.ground(&hidden.settings, hidden.delta_gamma)?;
        if ground.len() != measured.len() {
            return Err(format!("deviation_um: {} numbers are needed here", ground.len()).into());
        }
        // Besides the wave itself its second order.
        let tolerance = tolerances.get("brute_force_um") + 1.1 * hidden.wave.abs();
        for (k, (found, wanted)) in ground.iter().zip(measured).enumerate() {
            ledger.number(expected.case(), &format!("deviation_um[{k}]"), *wanted, found / UM, tolerance);
        }
        Ok(())
    }

    fn check_rounds(
        &self,
        hidden: &Hidden,
        deviations: &[f64],
        bounds: Vec<[f64; 2]>,
        tolerances: Tolerances<'_>,
        expected: &mut Expected<'_>,
        ledger: &mut Ledger,
    ) -> Checked {
        let columns = self.influence.columns(self.used, self.points)?;
        let before = self.ground(&hidden.settings, hidden.delta_gamma)?;
        let mut closed = ClosedLoop::new(bounds, true);
        let mut now = deviations.to_vec();
        let later = if hidden.wave == 0.0 { tolerances.get("brute_force_um") } else { SECOND_ROUND };
        for (round, mut item) in expected.objects("iterations", ledger).into_iter().enumerate() {
            let correction = closed.task(now.clone(), columns.clone()).solve()?;
            let rms = if round == 0 { None } else { Some(later) };
            self.check_correction(&correction, rms, tolerances, &mut item, ledger);
            item.finish(ledger);
            closed.apply(&correction)?;
            let settings: Vec<(Setting, f64)> = self
                .used
                .iter()
                .copied()
                .zip(closed.applied().iter().copied())
                .chain(hidden.settings.clone())
                .collect();
            let ground = self.ground(&settings, hidden.delta_gamma)?;
            now = deviations.iter().zip(ground.iter().zip(&before)).map(|(d, (g, b))| d + g - b).collect();
        }
        let um: Vec<f64> = now.iter().map(|f| f / UM).collect();
        let largest = um.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
        expected.number("final_rms_um", root_mean_square(&um), later, ledger);
        expected.number("final_max_um", largest, later, ledger);
        Ok(())
    }

    /// The first correction exactly; a later one as far as the flank before it is the same (`later`, um).
    fn check_correction(
        &self,
        correction: &Correction,
        later: Option<f64>,
        tolerances: Tolerances<'_>,
        item: &mut Expected<'_>,
        ledger: &mut Ledger,
    ) {
        let [relative, absolute] =
            ["correction_relative", "correction_absolute"].map(|key| tolerances.get(key));
        let rms = later.unwrap_or(tolerances.get("rms_um"));
        let pairs = [
            ("rms_before_um", correction.rms_before / UM),
            ("predicted_rms_after_um", correction.rms_after / UM),
            ("rms_unremovable_um", correction.rms_unremovable / UM),
        ];
        item.numbers(&pairs, rms, ledger);
        item.number("rank", correction.rank as f64, 0.0, ledger);
        item.list_to("singular_values_scaled", &correction.singular_values, |e| relative * e, ledger);
        if let Some(mut values) = item.object("correction", ledger) {
            for (found, setting) in correction.settings.iter().zip(self.used) {
                let value = found.value / unit(*setting);
                let allowed = match later {
                    None => absolute + relative * value.abs(),
                    // What the flanks differ by may be taken for any setting.
                    Some(um) => um * self.reach(*setting),
                };
                values.number(&key(*setting), value, allowed, ledger);
            }
            values.finish(ledger);
        }
        if let Some(mut flags) = item.object("at_bound", ledger) {
            for (found, setting) in correction.settings.iter().zip(self.used) {
                let key = key(*setting);
                if let Some(value) = flags.take(&key) {
                    ledger.equal(flags.case(), &flags.name(&key), value.clone(), found.at_bound.into());
                }
            }
            flags.finish(ledger);
        }
    }

    /// The amount of a setting, in the file's unit, whose effect is 1 um.
    fn reach(&self, setting: Setting) -> f64 {
        let effect = self.points.iter().map(|p| self.influence.effect(setting, p));
        let squares: Vec<f64> = effect.map(|e| e * unit(setting) / UM).collect();
        1.0 / root_mean_square(&squares)
    }
}
