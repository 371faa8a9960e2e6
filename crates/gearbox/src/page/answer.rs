//! The answer of the page: one sentence and the figures beside it.

use crate::workflow::{GearboxResult, RangeUm};
use report::charts::format_significant;

pub(super) fn headline(result: &GearboxResult) -> String {
    if let Some(reason) = result.verdict.reason() {
        return format!("{}.", reason.text);
    }
    if let Some(explored) = &result.explore {
        return format!(
            "{} of {} set-ups keep to {} µm at the flank.",
            explored.feasible,
            explored.set_ups.len(),
            explored.wanted_um
        );
    }
    let pulses = &result.pulses;
    let of_angle = result.angle.and_then(|angle| angle.within_bound);
    let of_feed = result.along_feed.as_ref().and_then(|along| along.within_bound);
    let kept = of_angle.zip(of_feed).map(|(a, b)| a && b);
    let within = match kept {
        Some(true) => ", every error within its limits",
        Some(false) => ", ERRORS OUTSIDE THEIR LIMITS",
        None => "",
    };
    format!("{} reference pulses became {} pulses{within}.", pulses.references, pulses.pulses)
}

pub(super) fn figures(result: &GearboxResult) -> Vec<(String, String)> {
    let um = |x: f64| format!("{} µm", format_significant(x, 4));
    let mut figures =
        vec![("alarms".to_owned(), (result.pulses.too_fast + result.pulses.overruns).to_string())];
    if let Some(angle) = &result.angle {
        let RangeUm { least_um, greatest_um } = angle.flank;
        figures.push((
            "error at the flank".into(),
            format!("{} to {}", format_significant(least_um, 4), um(greatest_um)),
        ));
    }
    if let Some(servo) = &result.servo {
        figures.push(("servo, rms at the flank".into(), um(servo.workpiece.rms_um)));
    }
    if let Some(best) = result.explore.as_ref().and_then(|e| e.best) {
        figures.push(("cheapest set-up costs".into(), format_significant(best.set_up.cost, 6)));
        figures.extend(best.set_up.flank_um.map(|x| ("its budget".into(), um(x))));
    }
    figures
}
