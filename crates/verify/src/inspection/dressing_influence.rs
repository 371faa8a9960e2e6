//! Block `dressing_influence`: what the dressing correction does to the gear flanks, and which patterns of both flanks it removes.

use super::super::dressing::bodies::Bodies;
use super::super::expected::Expected;
use super::super::given::{Checked, MOST, count, number, requires, whole};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::each_case::each_case;
use foundation::geometry::Flank;
use generating::correction::{DressingInfluence, FlankDressing, TwoFlankPattern};
use serde_json::{Value, json};

const UM: f64 = 1e-3;

/// Block `dressing_influence`.
pub(crate) fn dressing_influence(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each_case("dressing_influence", block, ledger, |input, tolerances, case, ledger| {
        let mut expected = case.object("expected", ledger).ok_or("expected is missing")?;
        let bodies = bodies(input, ledger)?;
        let units = "columns per 1 deg d_phi_S, 1 deg d_gamma, 1 mm d_d, 1 mm d_v_yA";
        requires(input, "units", &[units], ledger)?;
        let samples = count(input, "samples", 3..=MOST)?;
        let found = DressingInfluence::new(&bodies.tool, [0.0; 4], samples)?;
        let [relative, absolute, share] = ["relative", "absolute_um", "share"].map(|key| tolerances.get(key));
        if let Some(mut effect) = expected.object("effect", ledger) {
            for flank in Flank::BOTH {
                let Some(mut side) = effect.object(flank.name(), ledger) else { continue };
                let pairs = [("w_NfS_mm", bodies.range.w_nf), ("w_NaS_mm", bodies.range.w_na)];
                for (key, value) in pairs {
                    side.number(key, value, relative * value, ledger);
                }
                check_flank(&found.flanks[flank], [relative, absolute], &mut side, ledger);
                side.finish(ledger);
            }
            effect.finish(ledger);
        }
        if let Some(mut shares) = expected.object("two_flank_removable_share", ledger) {
            for (key, pattern) in [
                ("slope_equal", TwoFlankPattern::EqualSlopes),
                ("slope_opposite", TwoFlankPattern::OppositeSlopes),
                ("crowning_equal", TwoFlankPattern::EqualCrownings),
                ("crowning_opposite", TwoFlankPattern::OppositeCrownings),
            ] {
                let value = found.removable_share(pattern).unwrap_or(f64::NAN);
                shares.number(key, value, share, ledger);
            }
            shares.finish(ledger);
        }
        expected.finish(ledger);
        Ok(())
    });
}

fn check_flank(
    found: &FlankDressing,
    [relative, absolute]: [f64; 2],
    side: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let per_unit = |values: [f64; 4]| {
        let degree = 1f64.to_radians();
        let units = [degree, degree, 1.0, 1.0];
        std::array::from_fn::<f64, 4, _>(|j| values[j] * units[j] / UM)
    };
    for (key, values) in [
        ("offset_um_per_unit", found.offset),
        ("slope_um_per_unit", found.slope),
        ("crowning_um_per_unit", found.crowning),
    ] {
        side.list_to(key, &per_unit(values), |e| absolute + relative * e.abs(), ledger);
    }
}

/// Gear, worm and dresser, as the files of dressing write them.
fn bodies(input: &mut Expected<'_>, ledger: &mut Ledger) -> Checked<Bodies> {
    let mut gear = input.object("gear", ledger).ok_or("gear is missing")?;
    let keys = ["m_n_mm", "alpha_n_deg", "beta_deg", "d_Na_mm", "d_Nf_mm"];
    let [module, alpha, beta, end, start] = keys.map(|key| number(&mut gear, key, ledger));
    let (module, alpha, beta, end, start) = (module?, alpha?, beta?, end?, start?);
    let teeth = count(&mut gear, "teeth", 1..=10_000)?;
    gear.finish(ledger);
    let mut worm = input.object("worm", ledger).ok_or("worm is missing")?;
    let threads = whole("threads", worm.take("threads"), 1..=100)?;
    let diameter = number(&mut worm, "d_S_mm", ledger)?;
    let hand = [1.0, -1.0][requires(&mut worm, "hand", &["right", "left"], ledger)?];
    worm.finish(ledger);
    let dresser = number(input, "d_aA_mm", ledger)?;
    let other = json!({
        "m_n": module, "alpha_n_deg": alpha, "alpha_nS_deg": alpha, "beta_deg": beta, "d_Na": end, "d_Nf": start,
        "d_S": diameter, "d_aA": dresser, "z_V": teeth, "z_S": threads, "hand": hand,
    });
    let mut other = Expected::new(input.case(), "", &other, ledger);
    let bodies = Bodies::read(&mut other, ledger).ok_or("gear, worm and dresser are incomplete")?;
    other.finish(ledger);
    Ok(bodies?)
}
