//! Block `limits`: the profile crownings that the dresser's position alone can make, and what ends their range.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::UM;
use super::bodies::Bodies;
use dressing::{
    CrowningEnd, CrowningLimits, CrowningRows, DressedProfile, DresserSection, DressingError, PathReason,
    ThreadSpace, pitch_rolls,
};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;
use serde_json::Value;

/// Tip land of the entries `with_tip_land_1mm_...`, mm.
const LAND: f64 = 1.0;
/// A clearance beyond this does not change the range, mm.
const AMPLE: f64 = 100.0;

/// Block `limits`, left flank.
pub(super) fn limits(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let gear = bodies.gear.flank(Flank::Left).base_helix_angle;
    let rows = CrowningRows::new(&bodies.tool.flanks.left, bodies.reference_radius, gear);
    let within = |margin: &dyn Fn(&DressingCorrection) -> f64| {
        rows.range(&CrowningLimits { margin: Some(margin), ..CrowningLimits::default() })
    };
    let whole = rows.range(&CrowningLimits::default())?;
    // The files end where Newton's method for w(t) = w, started at t = w, steps on a circle that touches nothing; that is 1 to 2
    // percent before a circle in use loses contact.
    let files = within(&|dk| plain_newton_slack(bodies, dk))?;
    let section = DresserSection::new(&bodies.tool, Flank::Left, bodies.tip_radius)?;
    let tip = within(&|dk| {
        section
            .counter_flank_clearance(dk, LAND, ThreadSpace::default())
            .map_or(f64::NAN, |clearance| clearance.min(AMPLE))
    })?;
    let word = |reason: PathReason| reason.to_string().replace(' ', "_");
    for (key, whole, files, tip) in [
        ("min", whole.smallest, files.smallest, tip.smallest),
        ("max", whole.largest, files.largest, tip.largest),
    ] {
        let Some(mut end) = item.object(key, ledger) else { continue };
        number(&mut end, "c_alpha_V_um", files, tolerances.get("c_rel"), ledger);
        text(&mut end, "reason", word(whole.reason), ledger);
        number(&mut end, "with_tip_land_1mm_c_um", tip, tolerances.get("c_tip_rel"), ledger);
        text(&mut end, "with_tip_reason", word(tip.reason), ledger);
        end.finish(ledger);
    }
    Ok(())
}

fn number(end: &mut Expected<'_>, key: &str, at: CrowningEnd, relative: f64, ledger: &mut Ledger) {
    let size = end.peek(key).and_then(Value::as_f64).map_or(f64::NAN, f64::abs);
    end.number(key, at.crowning / UM, relative * size, ledger);
}

fn text(end: &mut Expected<'_>, key: &str, actual: String, ledger: &mut Ledger) {
    if let Some(expected) = end.take(key) {
        ledger.equal(end.case(), key, expected.clone(), actual.into());
    }
}

/// Steps of Newton's method that are looked at; it converges in fewer.
const STEPS: usize = 20;

/// The least slack of the circles that undamped Newton for w(t) = w meets from t = w at the pitch points.
fn plain_newton_slack(bodies: &Bodies, dk: &DressingCorrection) -> f64 {
    let profile = DressedProfile::new(&bodies.tool, Flank::Left, *dk);
    let mut least = f64::INFINITY;
    for w in pitch_rolls(&bodies.tool, Flank::Left) {
        let mut t = w;
        for _ in 0..STEPS {
            let slack = profile.slack(t);
            least = least.min(slack);
            let (Ok(at), Some(slope)) = (profile.at_parameter(t), profile.roll_slope(t)) else { break };
            let step = (at.w - w) / slope;
            t -= step;
            if step.abs() < 1e-12 {
                break;
            }
        }
    }
    least
}
