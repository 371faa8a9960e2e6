//! Blocks `dresser`, `profile` and `parallel_axes`: meridians and dressed profiles at given corrections.

use super::super::expected::{Expected, numbers};
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::bodies::Bodies;
use super::{UM, corrections};
use dressing::{
    ContactLine, DressedProfile, DresserTool, DressingError, NominalContact, ProfilePoint, full_tip_land,
    nominal_contact, stretch,
};
use foundation::geometry::{Flank, ProfileOffset, Sides};
use foundation::kinematics::DressingChain;
use serde_json::Value;
use std::sync::Arc;

/// Equidistant lengths of roll over the used profile at which the files fit lines and list profiles.
pub(super) const PROFILE_POINTS: usize = 7;

/// Those lengths of roll, mm.
pub(super) fn profile_rolls(bodies: &Bodies) -> Vec<f64> {
    let last = (PROFILE_POINTS - 1) as f64;
    (0..PROFILE_POINTS).map(|k| bodies.range.w_nf + bodies.range.length() * k as f64 / last).collect()
}

/// Block `dresser`.
pub(super) fn dresser(bodies: &Bodies, block: &mut Expected<'_>, ledger: &mut Ledger) {
    let mut length = f64::NAN;
    for flank in Flank::BOTH {
        let Some(mut side) = block.object(flank.name(), ledger) else { continue };
        let tolerances = Tolerances::table(side.take("tolerance").unwrap_or(&Value::Null));
        length = tolerances.get("mm");
        if let Err(error) = meridian(bodies, flank, tolerances, &mut side, ledger) {
            side.refused(&error, ledger);
        }
        side.finish(ledger);
    }
    match full_tip_land(&bodies.tool, bodies.tip_radius) {
        Ok(land) => block.number("tip_land_full_mm", land, length, ledger),
        Err(error) => block.refused(&error, ledger),
    }
}

fn meridian(
    bodies: &Bodies,
    flank: Flank,
    tolerances: Tolerances<'_>,
    side: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    let Some(w) = side.given_list("w_mm", ledger) else { return Ok(()) };
    let (tool, worm) = (&bodies.tool, bodies.worm.flank(flank));
    let contacts = w
        .iter()
        .map(|&w| nominal_contact(worm, &tool.flanks.left.chain, w))
        .collect::<Result<Vec<_>, _>>()?;
    let list = |of: &dyn Fn(f64, &NominalContact) -> f64| -> Vec<f64> {
        w.iter().zip(&contacts).map(|(&w, c)| of(w, c)).collect()
    };
    // The contact line from the closed relation, the meridian from the series that the calculations use.
    let profile = &tool.flanks[flank].profile;
    let (mm, unit) = (tolerances.get("mm"), tolerances.get("n"));
    side.list("b_mm", &list(&|_, c| c.b), mm, ledger);
    side.list("r_A_mm", &list(&|w, _| profile.at(w).r), mm, ledger);
    side.list("z_A_mm", &list(&|w, _| profile.at(w).z), mm, ledger);
    side.list("n_r", &list(&|w, _| profile.at(w).n_r), unit, ledger);
    side.list("n_z", &list(&|w, _| profile.at(w).n_z), unit, ledger);
    let points: Vec<(f64, f64)> = w.iter().zip(&contacts).map(|(&w, c)| (w, c.b)).collect();
    let line = ContactLine::through(&points);
    let middle = nominal_contact(worm, &tool.flanks.left.chain, bodies.range.middle())?;
    let degrees = tolerances.get("deg");
    side.number("rho_fit_deg", line.rho.to_degrees(), degrees, ledger);
    side.number("X_fit_mm", line.coordinate, mm, ledger);
    side.number("straightness_peak_to_peak_um", line.straightness / UM, tolerances.get("um"), ledger);
    side.number("rho_closed_mid_deg", (-middle.slope).atan().to_degrees(), degrees, ledger);
    Ok(())
}

/// g = a0 + a1 x + a2 x^2 with x = (t - w_NfS)/(w_NaS - w_NfS).
#[derive(Debug)]
struct Parabola {
    coefficients: [f64; 3],
    from: f64,
    length: f64,
}

impl ProfileOffset for Parabola {
    fn jet(&self, t: f64) -> [f64; 3] {
        let [a_0, a_1, a_2] = self.coefficients;
        let (x, m) = ((t - self.from) / self.length, self.length);
        [a_0 + (a_1 + a_2 * x) * x, (a_1 + 2.0 * a_2 * x) / m, 2.0 * a_2 / (m * m)]
    }
}

fn modified(bodies: &Bodies, coefficients: [f64; 3]) -> DresserTool {
    let offset: Arc<dyn ProfileOffset> =
        Arc::new(Parabola { coefficients, from: bodies.range.w_nf, length: bodies.range.length() });
    bodies.tool.with_offsets(&Sides::both(Some(offset)))
}

/// One entry of block `profile`.
pub(super) fn profile(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    // How well formula and ray simulation agreed when the file was made.
    item.informative(&["check_simulation_max_diff_um"]);
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let (flank, dk, w) =
        (item.given_flank(ledger), corrections::given(item, ledger), item.given_list("w_mm", ledger));
    let offset = item.take("dresser_mod_mm").filter(|value| !value.is_null());
    let offset = match offset.map(|value| numbers(value).and_then(|list| <[f64; 3]>::try_from(list).ok())) {
        Some(None) => {
            item.refused(&"three coefficients of the dresser modification are needed", ledger);
            return Ok(());
        }
        Some(found) => found,
        None => None,
    };
    let (Some(flank), Some(dk), Some(w)) = (flank, dk, w) else { return Ok(()) };
    let tool = offset.map_or_else(|| bodies.tool.clone(), |offset| modified(bodies, offset));
    let points = DressedProfile::new(&tool, flank, dk).at_rolls(&w)?;
    let list = |of: fn(&ProfilePoint) -> f64| points.iter().map(of).collect::<Vec<f64>>();
    let (um, mm) = (tolerances.get("um"), tolerances.get("mm"));
    item.list("f_n_um", &list(|p| p.f / UM), um, ledger);
    item.list("b_mm", &list(|p| p.b), mm, ledger);
    item.list("t_mm", &list(|p| p.t), mm, ledger);
    item.list("r_A_mm", &list(|p| p.r_a), mm, ledger);
    jacobian(&points, tolerances.get("jacobian_rel"), item, ledger);
    item.number("stretch_P", stretch(&tool, flank, dk)?, tolerances.get("P"), ledger);
    let line = ContactLine::through(&points.iter().map(|p| (p.w, p.b)).collect::<Vec<_>>());
    item.number("rho_fit_deg", line.rho.to_degrees(), tolerances.get("deg"), ledger);
    item.number("straightness_peak_to_peak_um", line.straightness / UM, um, ledger);
    Ok(())
}

/// Rows a profile point, columns phi_S, gamma, d, v_y. A derivative that passes through zero is held to the size that its
/// column has along the profile.
fn jacobian(points: &[ProfilePoint], relative: f64, item: &mut Expected<'_>, ledger: &mut Ledger) {
    let Some(value) = item.take("jacobian_mm_per_rad_or_mm") else { return };
    let rows: Option<Vec<[f64; 4]>> = value
        .as_array()
        .and_then(|rows| rows.iter().map(|row| <[f64; 4]>::try_from(numbers(row)?).ok()).collect());
    let Some(rows) = rows.filter(|rows| rows.len() == points.len()) else {
        ledger.fail(
            item.case(),
            "jacobian",
            value.clone(),
            "one row of four numbers a point is needed".into(),
        );
        return;
    };
    for j in 0..4 {
        let largest = rows.iter().map(|row| row[j].abs()).fold(0.0, f64::max);
        for (k, (row, point)) in rows.iter().zip(points).enumerate() {
            let name = format!("jacobian[{k}][{j}]");
            ledger.number(item.case(), &name, row[j], point.df_dk[j], relative * largest);
        }
    }
}

/// Block `parallel_axes`: at crossing angle 0 the dresser is a cone and the contact line straight.
pub(super) fn parallel_axes(
    bodies: &Bodies,
    tolerances: &Value,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    // The block states no tolerances: those of the nominal dresser hold.
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(tolerances));
    let chain = DressingChain { crossing_angle: 0.0, offset: 0.0, ..bodies.tool.flanks.left.chain };
    let worm = bodies.worm.flank(Flank::Left);
    let rolls = profile_rolls(bodies);
    let contacts = rolls.iter().map(|&w| nominal_contact(worm, &chain, w)).collect::<Result<Vec<_>, _>>()?;
    let (first, last) = (&contacts[0], &contacts[PROFILE_POINTS - 1]);
    let closed = -worm.s() / worm.base_helix_angle.tan();
    let line = ContactLine::through(&rolls.iter().zip(&contacts).map(|(&w, c)| (w, c.b)).collect::<Vec<_>>());
    let unit = tolerances.get("n");
    item.number("slope_dz_dr", (last.z - first.z) / (last.r - first.r), unit, ledger);
    item.number("closed", closed, unit, ledger);
    item.number("straightness_um", line.straightness / UM, tolerances.get("um"), ledger);
    item.number("rho_deg", line.rho.to_degrees(), tolerances.get("deg"), ledger);
    Ok(())
}
