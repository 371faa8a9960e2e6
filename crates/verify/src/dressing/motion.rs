//! Block `topological`: the worm left by a correction that changes along it.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::bodies::Bodies;
use super::{UM, corrections};
use contact::ContactError;
use dressing::{DressedWorm, dressing_motion, quasi_static_modification};
use foundation::geometry::Flank;
use foundation::numerics::Chebyshev;
use generating::GeneratingError;
use serde_json::Value;

/// Nodes that represent a parabola exactly.
const NODES: usize = 3;

/// Block `topological`: DK = lin v + quad v^2, left flank.
pub(super) fn topological(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), GeneratingError> {
    // How well formula and ray simulation agreed when the file was made.
    item.informative(&["check_simulation_max_diff_um"]);
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let four = |list: Option<Vec<f64>>| list.and_then(|list| <[f64; 4]>::try_from(list).ok());
    let lin = four(item.given_list("DK_lin_deg_mm_per_mm", ledger));
    let quad = four(item.given_list("DK_quad_deg_mm_per_mm2", ledger));
    let points = (item.given_list("w_mm", ledger), item.given_list("b_mm", ledger));
    let (Some(lin), Some(quad), (Some(w), Some(b))) = (lin, quad, points) else { return Ok(()) };
    let line = &bodies.tool.flanks.left.line;
    let nominal: Vec<f64> = w.iter().zip(&b).map(|(&w, &b)| line.value(w) - b).collect();
    let [low, high] =
        nominal.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], &v| [l.min(v), h.max(v)]);
    // The correction moves the contact line by less than the dressed length and a pitch.
    let margin =
        (high - low) + 2.0 * std::f64::consts::PI * bodies.tool.flanks.left.chain.screw_parameter.abs();
    let series = std::array::from_fn(|j| {
        let nodes = Chebyshev::nodes(low - margin, high + margin, NODES);
        let values: Vec<f64> =
            nodes.iter().map(|v| corrections::from_file_units(j, (lin[j] + quad[j] * v) * v)).collect();
        Chebyshev::interpolate(low - margin, high + margin, &values)
    });
    let dressed = DressedWorm::new(&bodies.tool, Flank::Left, &series);
    let motion = dressing_motion(bodies.tool.flanks.left.chain, &series);
    let (mut exact, mut positions, mut quasi_static) = (Vec::new(), Vec::new(), Vec::new());
    for (&w, &b) in w.iter().zip(&b) {
        let (f, _, v) = dressed.modification(w, b).ok_or(ContactError::WormSurfaceMissing { p: w, q: b })?;
        exact.push(f / UM);
        positions.push(v);
        let (f, _) = quasi_static_modification(&bodies.tool, Flank::Left, &motion, w, b)?;
        quasi_static.push(f / UM);
    }
    item.list("f_exact_um", &exact, tolerances.get("um"), ledger);
    item.list("v_zS_mm", &positions, tolerances.get("mm"), ledger);
    item.list("f_quasistatic_um", &quasi_static, tolerances.get("um"), ledger);
    Ok(())
}
