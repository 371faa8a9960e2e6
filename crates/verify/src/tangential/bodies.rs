//! Blocks `input`, `machine`, `grid`, `dresser_profile`: bodies in place, points with their weights, the nominal dresser.

use super::super::expected::{Expected, numbers};
use super::super::gear_sets::Hand;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::{Outcome, Setup, UM, with_setup};
use contact::Measure;
use foundation::geometry::{Flank, Gear, GearData, Revolution, Sides};
use serde::Deserialize;
use serde_json::Value;
use std::f64::consts::FRAC_PI_2;
use tangential_dressing::{
    FitGrid, ProfileKind, ShiftOffset, ShiftRatio, TangentialError, TangentialFlank, TangentialInput,
    TangentialModel, TangentialSettings, Weights,
};

/// The bodies as the file describes them.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Input {
    z2: i32,
    m_n: f64,
    alpha_n_deg: f64,
    beta2_deg: f64,
    x2: f64,
    b_g: f64,
    r_s: f64,
    r_e: f64,
    z1: i32,
    hand1: Hand,
    r_p1: f64,
    r_pd: f64,
    b_w: f64,
    pub kappa: f64,
    s_range_over_m_n: [f64; 2],
}

impl Input {
    /// The bodies in place; no tips limit.
    pub fn model(&self, profile: ProfileKind, kappa: f64) -> Result<TangentialModel, TangentialError> {
        let gear = GearData {
            teeth: self.z2,
            normal_module: self.m_n,
            pressure_angle: Sides::both(self.alpha_n_deg.to_radians()),
            helix_angle: self.beta2_deg.to_radians(),
            profile_shift: self.x2,
            cone_angle: 0.0,
        };
        let lead_angle = (f64::from(self.z1) * self.m_n / (2.0 * self.r_p1)).asin();
        let steep = FRAC_PI_2 - lead_angle;
        let helix_angle = if self.hand1 == Hand::Right { steep } else { -steep };
        TangentialModel::new(TangentialInput {
            gear: Gear::new(gear)?,
            worm: Gear::new(GearData { teeth: self.z1, helix_angle, profile_shift: 0.0, ..gear })?,
            worm_tip_radius: None,
            dresser_pitch_radius: self.r_pd,
            dresser_tip_radius: None,
            dresser_depth: None,
            profile,
            radii: [self.r_s, self.r_e],
            faces: [-0.5 * self.b_g, 0.5 * self.b_g],
            face_width: self.b_g,
            shift_width: self.b_w,
            shift_ratio: ShiftRatio::Given(kappa),
            shift_offset: ShiftOffset::Given(0.0),
        })
    }
}

/// The unmodified dresser of a flank.
fn dresser(model: &TangentialModel, flank: Flank) -> Revolution {
    TangentialFlank::new(model, flank, &[flank], &TangentialSettings::default(), Measure::Arc).dresser()
}

/// Block `input`: what the other blocks are computed from; of the library's own it states the heights of the dresser.
pub(crate) fn input(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    if let Some(input) = super::super::reference::read::<Input>("input", block, ledger) {
        let within = file.tolerances().get("dresser_S_mm");
        match input.model(ProfileKind::Conjugate, input.kappa) {
            Ok(model) => {
                let (from, to) = dresser(&model, Flank::Left).interval();
                for (k, actual) in [from, to].into_iter().enumerate() {
                    let expected = input.s_range_over_m_n[k] * input.m_n;
                    ledger.number("input", &format!("s_range_over_m_n[{k}]"), expected, actual, within);
                }
            }
            Err(error) => ledger.fail("input", "input", block.clone(), error.to_string().into()),
        }
    }
}

/// Block `machine`.
pub(crate) fn machine(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    with_setup("machine", file, block, ledger, |setup, item, ledger| {
        placed(setup, item, ledger);
        Ok(())
    });
}

fn placed(setup: &Setup<'_>, item: &mut Expected<'_>, ledger: &mut Ledger) {
    let model = &setup.model;
    let (pair, dressing) = (&model.pair, &model.chain);
    let (worm, work) = (pair.worm.flank(Flank::Left), pair.work.flank(Flank::Left));
    let motion = pair.motion(foundation::kinematics::MotionLaw::zero());
    let worm_helix = pair.worm.data().helix_angle;
    let (r_p1, offset) = (pair.worm.pitch_radius(), model.lines.left.offset.abs());
    let share = setup.tolerances.get("machine_rel");
    for (key, actual) in [
        ("r_p2", pair.work.pitch_radius()),
        ("r_b2", work.base_radius),
        ("beta_b2_deg", work.base_helix_angle.to_degrees()),
        ("eta_b2", work.base_space_half_angle),
        ("r_p1", r_p1),
        ("r_b1", worm.base_radius),
        ("beta1_deg", worm_helix.to_degrees()),
        ("beta_b1_deg", worm.base_helix_angle.to_degrees()),
        ("eta_b1", worm.base_space_half_angle),
        ("lambda_deg", 90.0 - worm_helix.abs().to_degrees()),
        ("p_mm_per_rad", dressing.screw_parameter),
        ("d0", pair.chain.centre_distance),
        ("gamma0_deg", pair.chain.crossed_axes_angle.to_degrees()),
        ("d_A0", dressing.centre_distance),
        ("gamma_A0_deg", dressing.crossing_angle.to_degrees()),
        ("phi2_per_zV1", motion.shift_coupling / motion.teeth),
        ("phi2_per_zV2", motion.feed_coupling / motion.teeth),
        ("phi2_per_phi1", -motion.threads / motion.teeth),
        ("w_star_left", model.lines.left.w_star),
        ("w_star_right", model.lines.right.w_star),
        ("FT0_left", model.lines.left.offset),
        ("FT0_right", model.lines.right.offset),
    ] {
        // What is zero (a spur gear's helix) is held to its own unit.
        let size = if actual == 0.0 { 1.0 } else { actual.abs() };
        item.number(key, actual, share * size, ledger);
    }
    let neutral = model.neutral_ratio();
    item.optional("kappa0", neutral, share * neutral.unwrap_or(1.0).abs(), ledger);
    // The difference of places of the size of FT0.
    item.number("contact_line_nonlinearity", model.lines.left.nonlinearity, share * offset, ledger);
}

/// Block `grid`.
pub(crate) fn grid(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    with_setup("grid", file, block, ledger, points);
}

fn points(setup: &Setup<'_>, item: &mut Expected<'_>, ledger: &mut Ledger) -> Outcome {
    let [radii, _] = setup.points()?;
    let share = setup.tolerances.get("machine_rel");
    let flank = Flank::Left;
    let grid = FitGrid::Radii(radii.len()).of(&setup.model, flank);
    let found: Vec<f64> = grid.w.iter().map(|&w| setup.model.radius(flank, w)).collect();
    let size = found.iter().fold(0.0, |m: f64, r| m.max(r.abs()));
    item.list("R", &found, share * size, ledger);
    item.list("Z", &grid.z, share * size, ledger);
    let order = item.take("order").cloned().unwrap_or(Value::Null);
    ledger.equal(item.case(), "order", order, "[iR][iZ]".into());
    let weights: Vec<f64> =
        grid.points().map(|(w, z)| Weights::Source.at(&setup.model, flank, w, z)).collect();
    item.table("weights", (&weights, grid.z.len()), share, ledger);
    Ok(())
}

/// Block `dresser_profile`: both sides have the same.
pub(crate) fn dresser_profile(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    with_setup("dresser_profile", file, block, ledger, |setup, item, ledger| {
        let heights = item.take("s").and_then(numbers).ok_or("a list of heights s is needed here")?;
        let straight = setup.input.model(ProfileKind::Straight, setup.input.kappa)?;
        let (length, slope) = (setup.tolerances.get("dresser_S_mm"), setup.tolerances.get("dresser_slope"));
        for flank in Flank::BOTH {
            let found = half_thicknesses(&dresser(&setup.model, flank), &heights);
            let line = half_thicknesses(&dresser(&straight, flank), &heights);
            let thick: Vec<f64> = found.iter().map(|[s, _]| *s).collect();
            item.list("S", &thick, length, ledger);
            item.list("dS_ds", &found.iter().map(|[_, slope]| *slope).collect::<Vec<_>>(), slope, ledger);
            let apart: Vec<f64> = thick.iter().zip(&line).map(|(s, [line, _])| (s - line) / UM).collect();
            item.list("minus_straight_um", &apart, length / UM, ledger);
        }
        Ok(())
    });
}

/// S and S' at heights s: distance of the profile from the middle plane, which its outward normal points away from.
fn half_thicknesses(dresser: &Revolution, heights: &[f64]) -> Vec<[f64; 2]> {
    let one = |&s: &f64| {
        let m = dresser.at(s);
        let side = m.n_z.signum();
        [side * m.z, -side * m.n_r / m.n_z]
    };
    heights.iter().map(one).collect()
}
