//! The verdict on a measured bevel gear: its flanks by the tolerance of the job, its pitches by a class of ISO 17485.

use super::super::closed_loop::RoundResult;
use super::pitches::Pitches;
use foundation::geometry::Flank;
use job::Diagnostic;
use metrology::inspection::{BEVEL_CLASSES, BevelQuantity};
use run::RunFailure;
use verdict::{Remark, Verdict};

/// Refuses a class that the standard does not have.
///
/// # Errors
/// [`RunFailure::BadInput`] naming the classes.
pub(super) fn check_class(class: Option<i32>) -> Result<(), RunFailure> {
    let Some(class) = class.filter(|class| !BEVEL_CLASSES.contains(class)) else { return Ok(()) };
    let finding = Diagnostic::with_code("out-of-standard-range", "ISO 17485 has no such class")
        .field("class")
        .value(class)
        .allowed(format!("{} to {}", BEVEL_CLASSES.start(), BEVEL_CLASSES.end()))
        .way_out("choose a class of the standard");
    Err(RunFailure::bad_input(finding))
}

/// Of the flanks.
pub(super) fn of_flanks(round: &RoundResult, tolerance_um: f64, asks_for: &dyn Fn(Flank) -> bool) -> Verdict {
    let way_out: String = match (&round.correction, &round.no_correction) {
        (Some(_), _) => "mill the next part by corrected-job.json".into(),
        (None, Some(why)) => format!("look at clamping, machine and measurement; no correction: {why}"),
        (None, None) => "look at clamping, machine and measurement".into(),
    };
    let mut verdict = Verdict::new();
    for flank in Flank::BOTH {
        let item = format!("{flank} flank");
        let Some(of) = round.flanks.get(flank.name()) else {
            if asks_for(flank) {
                let text = format!("the {flank} flank was not measured");
                let way_out = "measure its grid on three teeth or more, evenly around the gear";
                verdict.owe(item, Remark::new("not-judged", text, way_out));
            } else {
                verdict.leave(item, "the job does not ask for it");
            }
            continue;
        };
        let most = of.measured.largest_um;
        verdict.judge(item.clone(), most <= tolerance_um, format!("{most:.3} of {tolerance_um} um"), || {
            let text = format!(
                "the {flank} flank was measured {most:.3} um off its target (tolerance {tolerance_um} um)"
            );
            Remark::new("tolerance-exceeded", text, way_out.clone())
        });
        for (tooth, most) in &of.standing_out {
            let text = format!(
                "tooth {tooth} of the {flank} flank differs from what all teeth share by {most:.3} um (tolerance {tolerance_um} um)"
            );
            let remark = Remark::new("tooth-stands-out", text, "look at that tooth, and measure it again");
            verdict.missed(
                format!("tooth {tooth}, {item}"),
                format!("{most:.3} of {tolerance_um} um"),
                remark,
            );
        }
        let open = of.measured_um.iter().flatten().filter(|value| value.is_none()).count();
        if open > 0 {
            let text = format!("{open} points of the {flank} flank were not measured on all teeth");
            let remark = Remark::new("not-judged", text, "measure the whole grid of every tooth");
            verdict.owe(format!("all of the {item}"), remark);
        }
    }
    verdict
}

/// Of pitches and run-out.
pub(super) fn of_class(pitches: &Pitches, class: i32) -> Verdict {
    let name = format!("class {class} of ISO 17485:2006");
    let mut verdict = Verdict::new();
    let Some(tolerances) = &pitches.tolerances else {
        let text = match pitches.remarks.first() {
            Some(remark) => format!("{name} gives no tolerances for this gear: {}", remark.text),
            None => format!("{name} needs the point in the middle of every tooth"),
        };
        let way_out = "measure the point in the middle of every tooth of both flanks, or leave the class out";
        verdict.owe(name, Remark::new("not-measured", text, way_out));
        return verdict;
    };
    let mut judge = |item: String, flank: Option<&'static str>, quantity: BevelQuantity| {
        let found = pitches.classes.iter().find(|of| of.flank == flank && of.quantity == quantity.symbol());
        let (Some(found), Ok(limit)) = (found, tolerances.of(quantity, class)) else {
            let text = format!("{item}: {name} needs it, and it was not measured");
            let way_out = "measure the point in the middle of every tooth of both flanks";
            return verdict.owe(item, Remark::new("not-measured", text, way_out));
        };
        let kept = found.class.is_some_and(|reached| reached <= class);
        let detail = format!("{} {:.1} of {:.1} um", found.quantity, found.value_um, 1e3 * limit);
        verdict.judge(item.clone(), kept, detail, || {
            let text = format!(
                "{item}: {} is {:.1} um, {name} allows {:.1} um",
                found.quantity,
                found.value_um,
                1e3 * limit
            );
            Remark::new("class-not-reached", text, "look at the indexing axis, the clamping and the blank")
        });
    };
    for flank in Flank::BOTH {
        judge(format!("{flank} flank, single pitch"), Some(flank.name()), BevelQuantity::SinglePitch);
        judge(format!("{flank} flank, total pitch"), Some(flank.name()), BevelQuantity::TotalPitch);
    }
    judge("run-out".into(), None, BevelQuantity::RunOut);
    verdict.leave("flank forms by a class", "ISO 17485 has no tolerances for them");
    verdict
}
