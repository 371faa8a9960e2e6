//! Block `other_diameter`: the dresser of a case on worms of other diameters and profile angles.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::bodies::{Bodies, OtherWorm};
use super::{UM, corrections};
use dressing::{DressingError, angle_of_least_stretch, fit_profile_along, uncorrected_profile};
use foundation::geometry::Flank;
use serde_json::Value;

/// Bracket of the profile angle around that of the case (`docs/mathematics/dressing.md#conditions`), degrees.
const BRACKET: f64 = 2.0;

/// One entry of block `other_diameter`, left flank.
pub(super) fn other_diameter(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let Some(diameter) = item.given("d_S_mm", ledger) else { return Ok(()) };
    let (own, dresser) = (bodies.own_worm(), 2.0 * bodies.tip_radius);
    let path = |share: f64| {
        let diameter = own.diameter + share * (diameter - own.diameter);
        bodies.seat(OtherWorm { diameter, ..own }, dresser)
    };
    let fit = fit_profile_along(&bodies.tool, Flank::Left, &path, 0.0)?;
    let seat = path(1.0)?;
    let chain = seat.chains.left;
    let nominal = [chain.worm_angle, chain.crossing_angle, chain.centre_distance, chain.offset];
    if let Some(mut table) = item.object("K", ledger) {
        let relative = tolerances.get("K_rel");
        for (j, key) in ["phi_S_deg", "gamma_A_deg", "d_mm", "v_yA_mm"].into_iter().enumerate() {
            let expected = table.peek(key).and_then(Value::as_f64).unwrap_or(f64::NAN);
            let value = corrections::in_file_units(j, nominal[j] + fit.dk[j]);
            table.number(key, value, relative * expected.abs(), ledger);
        }
        table.finish(ledger);
    }
    item.number("stretch_P", fit.stretch, tolerances.get("P"), ledger);
    let tool = bodies.tool.on_worm(&seat)?;
    let (_, middle) = uncorrected_profile(&tool, Flank::Left, seat.reference_radius())?;
    let crowning = -middle / bodies.gear.flank(Flank::Left).base_helix_angle.cos();
    // The block states no tolerance in um: a share of the amount as for K.
    item.number(
        "uncorrected_crowning_c_alpha_V_um",
        crowning / UM,
        tolerances.get("K_rel") * (crowning / UM).abs(),
        ledger,
    );
    let of_angle = |angle: f64| bodies.seat(OtherWorm { diameter, angle, ..own }, dresser);
    let half = BRACKET.to_radians();
    let found =
        angle_of_least_stretch(&bodies.tool, &[Flank::Left], &of_angle, [own.angle - half, own.angle + half]);
    let angle = match found {
        Ok(found) => Some(found.angle.to_degrees()),
        Err(DressingError::NoAngleWithoutStretch { .. }) => None,
        Err(other) => return Err(other),
    };
    item.optional("alpha_nS_for_P0_deg", angle, tolerances.get("alpha_deg"), ledger);
    Ok(())
}
