//! One flank of a planned case at the listed diagonal ratio.

use super::super::expected::{Expected, numbers};
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::{UM, spans};
use contact::{ContactSolution, ExactContact, ModifiedThread, ThreadFunction, ToolSurface};
use foundation::geometry::Flank;
use foundation::numerics::{Chebyshev, root_mean_square};
use generating::{
    DressedFlank, FlankTarget, GeneratingError, GrindingPlan, GrindingSetup, IdealWorm, PlannedTool,
};

const KEYS: [(&str, &str); 4] = [
    ("DK_phi_S_deg", "phi_S_deg"),
    ("DK_gamma_deg", "gamma_deg"),
    ("DK_d_mm", "d_mm"),
    ("DK_v_y_mm", "v_y_mm"),
];

/// What one flank of a finished plan is compared with.
pub(super) struct PlannedFlank<'a> {
    pub setup: &'a GrindingSetup,
    pub plan: &'a GrindingPlan,
    pub target: &'a FlankTarget,
    pub flank: Flank,
}

impl PlannedFlank<'_> {
    /// Everything that the file lists of this flank.
    pub fn check(
        &self,
        side: &mut Expected<'_>,
        tolerances: Tolerances<'_>,
        ledger: &mut Ledger,
    ) -> Result<(), GeneratingError> {
        let (Some(planned), Some(worm)) = (&self.plan.flanks[self.flank], &self.plan.ideal.worms[self.flank])
        else {
            return Err(GeneratingError::NoFlank);
        };
        let relative = tolerances.get("K_star_relative");
        let tan_rho = self.setup.tool_direction[self.flank];
        side.number("tan_rho_1", tan_rho, relative * tan_rho.abs(), ledger);
        let corners = worm.lines.corners();
        let on_worm = corners.map(|(w, z)| worm.lines.worm_point(w, z, &worm.shift));
        let (rolls, axial) = (range(on_worm.map(|p| p.0)), range(on_worm.map(|p| p.1)));
        let length = tolerances.get("worm_length_mm");
        worm_function(worm, (rolls, axial, length), side, tolerances.get("f_n1_um"), ledger);
        let positions = [-axial[1], -axial[0]];
        let PlannedTool::Dressed(dressed) = &planned.tool else {
            return Err(GeneratingError::NotDressed);
        };
        corrections(&dressed.corrections, (positions, length), side, tolerances, ledger);
        self.flanks(dressed, worm, side, tolerances, ledger)
    }

    fn ground<S: ToolSurface>(
        &self,
        surface: &S,
        points: &[(f64, f64)],
    ) -> Result<Vec<ContactSolution>, GeneratingError> {
        let exact = ExactContact::new(&self.setup.pair, self.flank, &self.plan.ideal.motion, surface);
        Ok(points.iter().map(|&(w, z)| exact.solve(w, z)).collect::<Result<_, _>>()?)
    }

    /// The target and the flank that the dressed worm leaves, with the errors on the way.
    fn flanks(
        &self,
        made: &DressedFlank,
        worm: &IdealWorm,
        side: &mut Expected<'_>,
        tolerances: Tolerances<'_>,
        ledger: &mut Ledger,
    ) -> Result<(), GeneratingError> {
        let given = (side.given_list("points_w_mm", ledger), side.given_list("points_z_mm", ledger));
        let (Some(w), Some(z)) = given else { return Ok(()) };
        let points: Vec<(f64, f64)> = w.into_iter().zip(z).collect();
        let thread = ModifiedThread::new(self.setup.pair.flanks[self.flank].worm, worm);
        let ideal = self.ground(&thread, &points)?;
        let dressed = self.ground(&made.worm, &points)?;
        let cos = worm.lines.cos_b2;
        let target = points
            .iter()
            .map(|&(w, z)| Ok(self.target.value(w, z)? * cos / UM))
            .collect::<Result<Vec<f64>, GeneratingError>>()?;
        let simulated: Vec<f64> = dressed.iter().map(|s| s.f_n / UM).collect();
        let allowed = tolerances.get("max_error_um");
        side.list_relative_to_largest("target_f_n_um", &target, tolerances.get("K_star_relative"), ledger);
        side.list("simulated_f_n_um", &simulated, allowed, ledger);
        let errors: Vec<f64> = target.iter().zip(&simulated).map(|(t, s)| (t - s).abs()).collect();
        let rms = root_mean_square(&errors);
        side.at_most("max_error_um", errors.iter().copied().fold(0.0, f64::max), allowed, ledger);
        side.at_most("rms_error_um", rms, allowed, ledger);
        // How well the dressing motion follows the ideal worm: what it misses is part of the error.
        let apart = ideal.iter().zip(&dressed).map(|(i, d)| (i.f_n - d.f_n).abs() / UM).fold(0.0, f64::max);
        side.at_most("dressed_worm_minus_plan_um", apart, allowed, ledger);
        // A pure number near 1, held to the share to which the corrections behind it are held.
        let least = dressed.iter().map(|s| s.determinant_ratio).fold(f64::INFINITY, f64::min);
        side.number("least_determinant_ratio", least, tolerances.get("DK_relative_to_range"), ledger);
        let rounds: Vec<f64> = self.plan.ideal_error_by_round[self.flank].iter().map(|e| e / UM).collect();
        by_round(&rounds, side, allowed, ledger);
        Ok(())
    }
}

fn range(values: [f64; 4]) -> [f64; 2] {
    values.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
}

/// f_n1 on the points (w_1, z_1), row-major `[w_1][z_1]`.
fn worm_function(
    worm: &IdealWorm,
    (rolls, axial, length): ([f64; 2], [f64; 2], f64),
    side: &mut Expected<'_>,
    tolerance: f64,
    ledger: &mut Ledger,
) {
    let given = (side.given_list("w_1_mm", ledger), side.given_list("z_1_mm", ledger));
    let (Some(w_1), Some(z_1)) = given else { return };
    spans(side, "w_1_mm", &w_1, (rolls, length), ledger);
    spans(side, "z_1_mm", &z_1, (axial, length), ledger);
    // A point without a value becomes NaN, which no tolerance lets pass.
    let value = |w: f64, z: f64| worm.jet(w, z).map_or(f64::NAN, |jet| jet.f / UM);
    let values: Vec<f64> = w_1.iter().flat_map(|&w| z_1.iter().map(move |&z| value(w, z))).collect();
    side.list("f_n1_um", &values, tolerance, ledger);
}

/// DK at the listed worm positions: each component within its share of the listed range, or its absolute tolerance.
fn corrections(
    series: &[Chebyshev; 4],
    (positions, length): ([f64; 2], f64),
    side: &mut Expected<'_>,
    tolerances: Tolerances<'_>,
    ledger: &mut Ledger,
) {
    let Some(v) = side.given_list("v_zS_mm", ledger) else { return };
    spans(side, "v_zS_mm", &v, (positions, length), ledger);
    for (j, (key, absolute)) in KEYS.into_iter().enumerate() {
        let listed = side.peek(key).and_then(numbers).unwrap_or_default();
        let [low, high] =
            listed.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], &x| [a.min(x), b.max(x)]);
        let tolerance = f64::max(
            tolerances.get("DK_relative_to_range") * (high - low),
            tolerances.inside("DK_absolute").get(absolute),
        );
        let unit = |x: f64| if j < 2 { x.to_degrees() } else { x };
        let values: Vec<f64> = v.iter().map(|&v| unit(series[j].value(v))).collect();
        side.list(key, &values, tolerance, ledger);
    }
}

/// Errors by round, none worse than listed; a plan that stopped earlier keeps its last error.
fn by_round(rounds: &[f64], side: &mut Expected<'_>, allowed: f64, ledger: &mut Ledger) {
    const KEY: &str = "ideal_worm_error_by_round_um";
    let Some(value) = side.take(KEY) else { return };
    let Some(listed) = numbers(value) else {
        ledger.fail(side.case(), KEY, value.clone(), "a list of numbers is needed here".into());
        return;
    };
    for (k, expected) in listed.into_iter().enumerate() {
        let found = rounds.get(k).or(rounds.last()).copied().unwrap_or(f64::NAN);
        ledger.at_most(side.case(), &format!("{KEY}[{k}]"), expected, found, allowed);
    }
}
