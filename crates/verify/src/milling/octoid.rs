//! Block `octoid`: the flank that plane crown-gear flanks cut, against the spherical involute.

use super::super::given::{check_block, check_items, compare_vector, number, text, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::body::Body;
use super::case::MilledCase;
use super::near_foot::foot;
use foundation::geometry::{Octoid, SphericalInvolute, Surface};
use serde_json::Value;
use std::f64::consts::FRAC_PI_2;

/// Block `octoid`.
pub(crate) fn octoid(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("octoid", block, ledger, |expected, ledger| {
        let name = text(expected, "case", ledger)?;
        let case = MilledCase::named(reference, name)?;
        let flank =
            super::body::side(reference.root["cases"][name]["input"]["flank"].as_str().unwrap_or_default())?;
        let Body::Bevel(gear) = &case.body else { return Err("a bevel gear is needed here".into()) };
        let distance = number(expected, "R_mm", ledger)?;
        let [mm, um] = ["tolerance_mm", "tolerance_um"].map(|key| tolerance(expected, key, ledger));
        let (octoid, involute) = (Octoid::new(gear, flank), SphericalInvolute::new(gear, flank));
        let half_space = FRAC_PI_2 / f64::from(gear.data().teeth);
        check_items(expected, "items", ledger, |item, ledger| {
            let theta = number(item, "theta_deg", ledger)?.to_radians();
            let height = octoid.height_of(theta)?;
            let jet = octoid.jet(height, distance);
            item.number("gamma_rad", -flank.sign() * (height + half_space), mm, ledger);
            compare_vector(item, "P_octoid_mm", &jet.point, mm, ledger);
            compare_vector(item, "n_octoid", &jet.normal, mm, ledger);
            let (_, off) = foot(&involute, &jet.point, [gear.roll_angle(theta)?, distance])?;
            item.number("normal_difference_um", 1e3 * off, um, ledger);
            Ok(())
        })
    });
}
