//! 25-modifications: figures 25 to 28, a flank ground with a diagonal ratio that varies so that one worm line meets a wanted
//! curve.

use super::expected::Expected;
use super::gear_sets::{Set, entries, named};
use super::ledger::Ledger;
use super::reference::{Reference, Tolerances};
use contact::{ExactContact, ModifiedThread};
use foundation::geometry::Flank;
use foundation::kinematics::{MotionLaw, PiecewisePolynomial};
use generating::{
    CurveLaw, FlankLines, GeneratingError, LineFunctions, LineWorm, VariableRatio, WantedCurve,
};
use serde_json::Value;

const UM: f64 = 1e-3;

/// Block `figure_25`.
pub(super) fn figure_25(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    figure("figure_25", file, block, ledger);
}

/// Block `figure_26_28`.
pub(super) fn figure_26_28(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    figure("figure_26_28", file, block, ledger);
}

/// The modification of the figures: f_t2 = -amplitude max(sigma X_1, 0)^2 (1 + share u^2). Transverse, mm.
struct OneSided {
    sigma: f64,
    amplitude: f64,
    share: f64,
    lines: FlankLines,
}

impl OneSided {
    /// The factor of max(...)^2 at length of roll w.
    fn factor(&self, w: f64) -> f64 {
        let [w_f, w_a] = self.lines.roll;
        let u = 2.0 * (w - self.lines.w_m) / (w_a - w_f);
        -self.amplitude * (1.0 + self.share * u * u)
    }

    fn value(&self, w: f64, x_1: f64) -> f64 {
        self.factor(w) * (self.sigma * x_1).max(0.0).powi(2)
    }

    /// F_1C, F_1L, F_1Q over X_1 within +-reach: parabolas on one side of X_1 = 0.
    fn worm(&self, reach: f64) -> Result<LineWorm, GeneratingError> {
        let w_2 = [self.lines.roll[0], self.lines.w_m, self.lines.roll[1]];
        let unit = LineFunctions::through(&self.lines, w_2, w_2.map(|w| self.factor(w)))?;
        let half = |k: f64| {
            let (still, bent) = ([0.0; 4], |from: f64| [k * from * from, 2.0 * k * from, k, 0.0]);
            let pieces = if self.sigma > 0.0 { vec![still, bent(0.0)] } else { vec![bent(-reach), still] };
            PiecewisePolynomial::new(vec![-reach, 0.0, reach], pieces).map(MotionLaw::Pieces)
        };
        let [c, l, q] = unit.centred;
        Ok(LineWorm { lines: self.lines, centre: unit.centre, functions: [half(c)?, half(l)?, half(q)?] })
    }
}

fn figure(name: &str, file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let list = Value::Array(vec![block.clone()]);
    entries(name, &list, ledger, |item, ledger| {
        item.rename(name);
        let tolerance = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let Some(mut input) = item.object("input", ledger) else { return Ok(()) };
        // The formula in words; it is the one of `OneSided`.
        input.informative(&["modification"]);
        let keys = ["tan_rho_F1", "amplitude_um_per_mm2", "quadratic_share"];
        let numbers = keys.map(|key| input.given(key, ledger));
        let kind = input.object("kind", ledger);
        let curve = kind.and_then(|kind| wanted_curve(kind, ledger));
        let ([Some(t_1), Some(amplitude), Some(share)], Some((wanted, above))) = (numbers, curve) else {
            input.refused(&"a curve with its relief is needed", ledger);
            return Ok(());
        };
        let lines = set.lines(flank, t_1)?;
        let shift = wanted.shift(&lines)?;
        let ratio = VariableRatio::new(&lines, &shift);
        // Above the curve (greater z) the feed is less and X_1 differs by c_1 F' times that.
        let rising = ratio.local_ratio(lines.w_m, lines.z_m).signum();
        let sigma = if above { rising } else { -rising };
        input.number("sigma", sigma, 0.0, ledger);
        input.finish(ledger);
        let relief = OneSided { sigma, amplitude: amplitude * UM, share, lines };
        let case = Case { set: &set, flank, wanted: &wanted, ratio, relief: &relief, tolerance };
        let mut largest = [0.0; 2];
        if let Some(mut expected) = item.object("expected", ledger) {
            match case.compare(&shift, &mut expected, ledger) {
                Ok(found) => largest = found,
                Err(error) => expected.refused(&error, ledger),
            }
            expected.finish(ledger);
        }
        if let Some(mut measured) = item.object("measured", ledger) {
            // Errors of approximations when the file was made; those of the library's own models are checked elsewhere.
            let others = ["err_local_envelope_um", "err_second_order_um", "shift_property_error_mm"];
            measured.informative(&others);
            let [first_order, size] = largest;
            measured.number("err_first_order_um", first_order, tolerance.get("ground_um"), ledger);
            measured.number("max_f_um", size, tolerance.get("f_um"), ledger);
            measured.finish(ledger);
        }
        Ok(())
    });
}

/// The curve of `input.kind` and whether the relief lies above it.
fn wanted_curve(mut kind: Expected<'_>, ledger: &mut Ledger) -> Option<(WantedCurve, bool)> {
    let name = kind.given_text("curve", ledger)?;
    let mut read = |key: &str| kind.given(key, ledger);
    let law = match name {
        "line_sine" => CurveLaw::LineSine {
            slope: read("slope")?,
            origin: read("w_0_mm")?,
            amplitude: read("a_mm")?,
            phase_length: read("p_mm")?,
        },
        "line_blend" => CurveLaw::LineBlend {
            slope: read("slope")?,
            turn: read("w_t_mm")?,
            half_length: read("h_mm")?,
            level: read("z_e_mm")?,
        },
        _ => {
            ledger.fail(kind.case(), "curve", name.into(), "line_sine or line_blend is needed here".into());
            return None;
        }
    };
    let (line, roll) = (read("X_ref_mm")?, [read("w_from_mm")?, read("w_to_mm")?]);
    let side = kind.given_text("relief_side", ledger)?;
    if !matches!(side, "above" | "below") {
        ledger.fail(kind.case(), "relief_side", side.into(), "above or below is needed here".into());
        return None;
    }
    kind.finish(ledger);
    Some((WantedCurve { law, line, roll }, side == "above"))
}

struct Case<'a> {
    set: &'a Set,
    flank: Flank,
    wanted: &'a WantedCurve,
    ratio: VariableRatio<'a>,
    relief: &'a OneSided,
    tolerance: Tolerances<'a>,
}

impl Case<'_> {
    /// Compares `expected`; the largest first-order error and the largest modification, um.
    fn compare(
        &self,
        shift: &foundation::kinematics::InverseLaw,
        expected: &mut Expected<'_>,
        ledger: &mut Ledger,
    ) -> Result<[f64; 2], GeneratingError> {
        let [z_mm, ratio_tolerance, f_um, ground_um] =
            ["z_mm", "diagonal_ratio", "f_um", "ground_um"].map(|key| self.tolerance.get(key));
        let lines = &self.relief.lines;
        let law = shift.law();
        let corners = lines.corners().map(|(w, z)| lines.path_feed(w, z));
        let range = corners.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [v.min(a), v.max(b)]);
        expected.list("z_V2_range_of_flank_mm", &range, z_mm, ledger);
        if let Some(feeds) = expected.given_list("z_V2_mm", ledger) {
            let at = |k: usize| feeds.iter().map(|&v| law.jet(v)[k]).collect::<Vec<_>>();
            expected.list("z_V1_mm", &at(0), z_mm, ledger);
            expected.list("diagonal_ratio", &at(1), ratio_tolerance, ledger);
        }
        for mut curve in expected.objects("curves", ledger) {
            if let Err(error) = self.compare_curve(&mut curve, z_mm, ledger) {
                curve.refused(&error, ledger);
            }
            curve.finish(ledger);
        }
        let slope = self.wanted.law.jet(lines.w_m)[1];
        let closed = lines.ratio_of_direction(-slope);
        expected.number("diagonal_ratio_closed_form_at_w_m", closed, ratio_tolerance, ledger);
        for mut entry in expected.objects("worm_functions", ledger) {
            if let Err(error) = self.compare_functions(&mut entry, f_um, ledger) {
                entry.refused(&error, ledger);
            }
            entry.finish(ledger);
        }
        let [w, z] = ["points_w_mm", "points_z_mm"].map(|key| expected.given_list(key, ledger));
        let (Some(w), Some(z)) = (w, z) else { return Ok([f64::NAN; 2]) };
        let points: Vec<(f64, f64)> = w.into_iter().zip(z).collect();
        let x_1: Vec<f64> = points.iter().map(|&(w, z)| self.ratio.line_coordinate(w, z)).collect();
        expected.list("X_F1_mm", &x_1, z_mm, ledger);
        let first: Vec<f64> =
            points.iter().zip(&x_1).map(|(&(w, _), &x)| self.relief.value(w, x) / UM).collect();
        expected.list("f_t2_first_order_um", &first, f_um, ledger);
        let reach = x_1.iter().fold(0.0_f64, |m, x| m.max(x.abs())) + 20.0;
        let worm = self.relief.worm(reach)?;
        let motion = self.set.pair.motion(law.clone());
        let thread = ModifiedThread::new(self.set.pair.flanks[self.flank].worm, &worm);
        let exact = ExactContact::new(&self.set.pair, self.flank, &motion, &thread);
        let mut ground = Vec::with_capacity(points.len());
        for &(w, z) in &points {
            ground.push(exact.solve(w, z)?.f_n / UM);
        }
        expected.list("ground_f_n_um", &ground, ground_um, ledger);
        let apart = ground.iter().zip(&first).map(|(g, f)| (g - lines.cos_b2 * f).abs()).fold(0.0, f64::max);
        Ok([apart, first.iter().fold(0.0, |m: f64, f| m.max(f.abs()))])
    }

    fn compare_curve(
        &self,
        curve: &mut Expected<'_>,
        tolerance: f64,
        ledger: &mut Ledger,
    ) -> Result<(), GeneratingError> {
        let (Some(x_1), Some(w)) = (curve.given("X_F1_mm", ledger), curve.given_list("w_mm", ledger)) else {
            return Ok(());
        };
        let mut z = Vec::with_capacity(w.len());
        for &w in &w {
            z.push(self.ratio.curve(w, x_1)?[0]);
        }
        curve.list("z_mm", &z, tolerance, ledger);
        let [dw, dz] = self.relief.lines.curve_displacement(x_1 - self.wanted.line)?;
        curve.numbers(&[("shift_w_mm", dw), ("shift_z_mm", dz)], tolerance, ledger);
        Ok(())
    }

    fn compare_functions(
        &self,
        entry: &mut Expected<'_>,
        tolerance: f64,
        ledger: &mut Ledger,
    ) -> Result<(), GeneratingError> {
        let Some(x_1) = entry.given("X_F1_mm", ledger) else { return Ok(()) };
        // The modification is a parabola in w along any line, so that any three lengths of roll give its functions.
        let lines = &self.relief.lines;
        let w_2 = [lines.roll[0], lines.w_m, lines.roll[1]];
        let functions = LineFunctions::through(lines, w_2, w_2.map(|w| self.relief.value(w, x_1)))?;
        let [c, l, q] = functions.raw().map(|f| f / UM);
        let names = [("F_Ft1C_um", c), ("F_Ft1L_um_per_mm", l), ("F_Ft1Q_um_per_mm2", q)];
        entry.numbers(&names, tolerance, ledger);
        Ok(())
    }
}
