//! Block `helical_zero_eps_lead_radius`: the guide curve whose planes hold the normals of one row.

use super::super::given::{check_block, number, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::body::Body;
use super::case::MilledCase;
use foundation::numerics::brent;
use milling::{ColumnPlane, HelixOnCylinder, LeadCurve};
use serde_json::Value;

/// Block `helical_zero_eps_lead_radius`.
pub(crate) fn helical_zero_eps_lead_radius(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("helical_zero_eps_lead_radius", block, ledger, |expected, ledger| {
        let case = MilledCase::given(reference, expected, ledger)?;
        let height = number(expected, "row_w_mm", ledger)?;
        let mm = tolerance(expected, "tolerance_mm", ledger);
        let Body::Cylinder { helicoid, radii: [tip, root] } = &case.body else {
            return Err("a cylindrical gear is needed here".into());
        };
        // n.t of the row on the column at u = 0; on cylinders it is the same on all.
        let sine = |radius: f64| {
            let (turn_per_length, external_sign) = (helicoid.twist(), helicoid.external_sign());
            let lead = HelixOnCylinder { radius, turn_per_length, external_sign }.at(0.0).ok()?;
            let section = ColumnPlane::new(&case.flank, lead).section(height, 0.0).ok()?;
            Some(section.jet.normal.dot(&lead.direction))
        };
        let ends = [0.5 * root.min(*tip), 2.0 * root.max(*tip)];
        let at_ends = ends.map(|radius| sine(radius).unwrap_or(f64::NAN));
        let radius = brent(ends, at_ends, 0.0, sine).ok_or("no guide curve passes the row without turn")?;
        expected.number("r0_mm", radius, mm, ledger);
        Ok(())
    });
}
