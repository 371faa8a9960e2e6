//! Block `blade_limits`: curvatures of a twisted blade and the cutters that they allow
//! (`docs/mathematics/milling.md#scallops-chords-local-gouging`).

use super::super::given::{check_block, check_items, number, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{MilledCase, located};
use foundation::geometry::CutterShape;
use milling::{Column, ColumnPlane, LocalContact};
use serde_json::Value;

/// Block `blade_limits`.
pub(crate) fn blade_limits(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("blade_limits", block, ledger, |expected, ledger| {
        let case = MilledCase::given(reference, expected, ledger)?;
        let relative = tolerance(expected, "tolerance_rel", ledger);
        // Any ball: only its axis is of interest.
        let cutter = super::cutter::of_shape(CutterShape::ball(1.0), super::cutter::EDGES)?;
        check_items(expected, "items", ledger, |item, ledger| {
            let [u, v] = [number(item, "u", ledger)?, number(item, "v", ledger)?];
            let plane = ColumnPlane::new(&case.flank, case.lead.at(u)?);
            let column = Column::at_heights(&case.flank, &plane, &[v])?;
            let place = &column.places[0];
            let location = located(place, &column.lead, &cutter, 0.0, 0.0)?;
            let local = LocalContact::new(&place.jet, &location, cutter.shape());
            let (k, half) = (local.flank, 0.5 * local.flank.trace());
            let reach = (0.5 * (k.m11 - k.m22)).hypot(k.m12);
            let principal = [half - reach, half + reach];
            item.list_relative_to_largest("principal_per_mm", &principal, relative, ledger);
            let ball = (principal[0] < 0.0).then(|| -1.0 / principal[0]);
            let twisted = k.m12 * k.m12 - k.m11 * k.m22;
            let cylinder = if k.m11 <= 0.0 { Some(0.0) } else { (twisted > 0.0).then(|| k.m11 / twisted) };
            for (key, radius) in [("R_ball_max_mm", ball), ("R_cylinder_max_mm", cylinder)] {
                item.optional(key, radius, relative * radius.unwrap_or(0.0), ledger);
            }
            Ok(())
        })
    });
}
