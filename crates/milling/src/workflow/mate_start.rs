//! Where the flank of a cylindrical gear has to begin for its mate: where it touches the mate's tip edge.

use super::mate_result::MateStartResult;
use super::prepare::PairSide;
use foundation::geometry::Flank;
use verdict::Remark;

/// Lengths of roll that count as the same, mm: rounding.
const SAME_ROLL: f64 = 1e-6;

/// Where the flanks of a cylindrical gear begin and where its mate needs them to, by the flank that lacks most, with a remark where one
/// lacks something.
pub(super) fn start_of_cylindrical_flank(sides: &[(Flank, &PairSide)]) -> (MateStartResult, Option<Remark>) {
    let of_side = |(_, of): &(Flank, &PairSide)| {
        let [[form, tip], [_, mate_tip]] = of.conjugate.heights();
        let needed = of.conjugate.touching(mate_tip);
        // Of an internal gear rolls fall from root to tip.
        let lacking = if tip > form { form - needed } else { needed - form };
        let surface = &of.gears[0].surface;
        let diameter = |roll: f64| 2.0 * surface.point(roll, 0.0).xy().norm();
        (lacking, diameter(form), (needed >= 0.0).then(|| diameter(needed)))
    };
    let most = sides.iter().map(of_side).max_by(|a, b| a.0.total_cmp(&b.0));
    let (lacking, active, needed) = most.unwrap_or((0.0, 0.0, None));
    let result = MateStartResult {
        active_deg: None,
        needed_deg: None,
        active_diameter_mm: Some(active),
        needed_diameter_mm: needed,
        covered: lacking <= SAME_ROLL && needed.is_some(),
    };
    let remark = match needed {
        _ if result.covered => return (result, None),
        Some(needed) => Remark {
            code: "mate-needs-more-flank",
            text: format!(
                "the tip of the mate engages down to a diameter of {needed:.4} mm, the active flank begins at {active:.4}: what is \
                 between them is not milled as a flank and not judged"
            ),
            way_out: "set `gear.form_diameter` to it, or reduce the tip diameter of the mate".into(),
        },
        None => Remark {
            code: "mate-needs-more-flank",
            text: "the tip of the mate reaches below the base circle, where there is no involute: it meets the root".into(),
            way_out: "reduce the tip diameter of the mate, or give more teeth to this gear".into(),
        },
    };
    (result, Some(remark))
}
