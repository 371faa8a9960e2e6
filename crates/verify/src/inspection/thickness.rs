//! Block `thickness`: span and balls of a gear, and the profile shift by both as they are printed.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::evaluation_case::check_each;
use foundation::geometry::{Gear, GearData, Sides};
use metrology::inspection::{BallContact, ThicknessSizes, measured_thickness, round_to};
use serde::Deserialize;
use serde_json::Value;

/// Printed sizes end with this, mm.
const PRINTED: f64 = 1e-3;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    teeth: i32,
    m_n_mm: f64,
    alpha_n_deg: f64,
    beta_deg: f64,
    span_teeth: u32,
    ball_mm: f64,
    profile_shift_x: f64,
}

/// Block `thickness`.
pub(crate) fn thickness(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("thickness", block, ledger, |input: &Input, tolerances, expected, ledger| {
        let data = GearData {
            teeth: input.teeth,
            normal_module: input.m_n_mm,
            pressure_angle: Sides::both(input.alpha_n_deg.to_radians()),
            helix_angle: input.beta_deg.to_radians(),
            profile_shift: input.profile_shift_x,
            cone_angle: 0.0,
        };
        let gear = Gear::new(data)?;
        let span = gear.span(input.span_teeth)?.length;
        let balls = gear.over_balls(input.ball_mm, 0.0)?;
        let ball = BallContact::of(&gear, input.ball_mm)?;
        let printed = ThicknessSizes {
            span: Some((input.span_teeth, round_to(span, PRINTED))),
            balls: Some((input.ball_mm, round_to(balls.size, PRINTED))),
        };
        let found = measured_thickness(data, &printed)?;
        let (mm, x) = (tolerances.get("mm"), tolerances.get("x"));
        expected.number("W_k_mm", span, mm, ledger);
        expected.number("M_dK_mm", balls.size, mm, ledger);
        expected.number("r_K_mm", ball.centre_diameter / 2.0, mm, ledger);
        expected.number("alpha_K_deg", ball.pressure_angle.to_degrees(), mm, ledger);
        expected.optional("x_from_rounded_span", found.by_span, x, ledger);
        expected.optional("x_from_rounded_balls", found.by_balls, x, ledger);
        Ok(())
    });
}
