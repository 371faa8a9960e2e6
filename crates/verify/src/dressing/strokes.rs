//! Blocks `multi_stroke` and `axis_deviation`: dressing in several strokes, and deviations of the axes found from both flanks.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::bodies::Bodies;
use super::{UM, corrections};
use dressing::{
    ActiveArea, DressingError, Measurement, MultiStroke, Recovery, Stroke, influence, recover_deviation,
};
use foundation::geometry::Flank;
use serde_json::Value;

/// Height of the wanted parabola of block `multi_stroke`, mm, as its key `wanted` says.
const WANTED: f64 = -0.008;
/// Noise that the standard deviations of block `axis_deviation` belong to, mm.
const NOISE: f64 = 0.1 * UM;

/// Block `multi_stroke`, left flank: strokes that can all be made, or none of them.
pub(super) fn multi_stroke(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    item.informative(&["rows", "wanted"]);
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let (Some(t_a), Some(t_b)) = (item.given("t_a_mm", ledger), item.given("t_b_mm", ledger)) else {
        return Ok(());
    };
    let touching = item.given_list("t_active_mm", ledger).and_then(|list| <[f64; 2]>::try_from(list).ok());
    let Some(touching) = touching else {
        item.refused(&"t_active_mm needs two numbers", ledger);
        return Ok(());
    };
    let area = ActiveArea::new([t_a, t_b], touching)?;
    let range = bodies.range;
    let wanted = |w: f64| WANTED * ((w - range.w_nf) / range.length() - 0.5).powi(2);
    let (mut strokes, mut made) = (Vec::new(), Vec::new());
    for mut entry in item.objects("strokes", ledger) {
        if let (Some(a), Some(b)) = (entry.given("w_a_mm", ledger), entry.given("w_b_mm", ledger)) {
            let stroke = Stroke { tool: &bodies.tool, area, range: [a, b] };
            let f = [a, 0.5 * (a + b), b].map(wanted);
            let solved = stroke.solve(Flank::Left, bodies.reference_radius, f, &[0.0; 4]);
            match (entry.take("error"), solved) {
                (None, Ok(dk)) => {
                    let within = |_: usize, x: f64| tolerances.get("DK_rel") * x.abs();
                    corrections::compare(&mut entry, &dk, within, ledger);
                    made.push(dk);
                }
                (None, Err(error)) => entry.refused(&error, ledger),
                (Some(expected), solved) => {
                    let name = match solved {
                        Ok(_) => Value::Null,
                        Err(DressingError::NoZero { .. }) => "NoZero".into(),
                        Err(other) => other.code().into(),
                    };
                    ledger.equal(item.case(), "multi_stroke.strokes.error", expected.clone(), name);
                }
            }
            strokes.push(stroke);
        }
        entry.finish(ledger);
    }
    if item.peek("w_mm").is_none() {
        return Ok(());
    }
    let Some(w) = item.given_list("w_mm", ledger) else { return Ok(()) };
    let dressed = MultiStroke::at(&strokes, Flank::Left, &made)?;
    let points = dressed.at_rolls(&w)?;
    let um = tolerances.get("um");
    item.list("f_um", &points.iter().map(|p| p.point.f / UM).collect::<Vec<_>>(), um, ledger);
    let apart = points.iter().zip(&w).map(|(p, &w)| (p.point.f - wanted(w)).abs()).fold(0.0, f64::max);
    item.number("max_deviation_um", apart / UM, um, ledger);
    Ok(())
}

/// Block `axis_deviation`: profiles of both flanks at given deviations, and the deviations back from them.
pub(super) fn axis_deviation(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let Some(deviation) = corrections::given_as("deviation", item, ledger) else { return Ok(()) };
    let Some(w) = item.given_list("w_mm", ledger) else { return Ok(()) };
    let of = |flank| influence(&bodies.tool, flank, [0.0; 4], deviation, &w).map(|found| found.exact);
    let (left, right) = (of(Flank::Left)?, of(Flank::Right)?);
    let in_um = |f: &[f64]| f.iter().map(|f| f / UM).collect::<Vec<_>>();
    item.list("f_left_um", &in_um(&left), tolerances.get("um"), ledger);
    item.list("f_right_um", &in_um(&right), tolerances.get("um"), ledger);
    let of = |flank, f| Measurement { flank, dk: [0.0; 4], w: &w, f };
    let both = [of(Flank::Left, &left), of(Flank::Right, &right)];
    let known = Recovery { noise: NOISE, held: [None; 4] };
    let found = recover_deviation(&bodies.tool, bodies.reference_radius, &both, &known)?;
    for (key, values, share) in [
        ("recovered", &found.deviation, tolerances.get("recovered_rel")),
        ("sigma_for_noise_0p1um", &found.standard_deviation, tolerances.get("sigma_rel")),
    ] {
        corrections::compare_as(key, item, values, |_, x| share * x.abs(), ledger);
    }
    Ok(())
}
