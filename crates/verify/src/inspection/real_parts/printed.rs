//! What the measuring machine printed of the whole gear: it must stand in the file of values, and the evaluation must agree with it.

use super::super::super::expected::Expected;
use super::super::super::ledger::Ledger;
use super::Allowed;
use flankwright::workflow::inspection::{EvaluatedGear, EvaluatedPitch};
use foundation::geometry::Flank;
use measured_files::inspection::{Characteristic, Inspection, Statistic};

/// Printed values are read as printed; this is the rounding of reading them.
pub(super) const AS_PRINTED: f64 = 1e-9;

/// Adds to the name of a quantity that its evaluation is compared with what the machine printed.
pub(super) fn compared(quantity: &str) -> String {
    format!("{quantity}: evaluated against the machine's printed value")
}

/// Compares printed values of the gear: pairs left and right, or one number.
pub(super) fn of_gear(
    inspection: &Inspection,
    found: &EvaluatedGear,
    allowed: &Allowed,
    printed: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let of = |characteristic: Characteristic, flank: Option<Flank>, statistic: Statistic| {
        let found = inspection.results.iter().find(|q| {
            let m = q.meaning;
            (m.characteristic, m.flank, m.statistic) == (characteristic, flank, statistic)
        });
        found.and_then(|q| q.value).unwrap_or(f64::NAN)
    };
    let pitch = found.pitch.as_ref();
    type OfFlank = fn(&EvaluatedPitch, Flank) -> Option<f64>;
    let of_flanks: [(&str, Characteristic, OfFlank); 5] = [
        ("fp", Characteristic::SinglePitch, |pitch, flank| Some(pitch.flanks[flank].as_ref()?.single)),
        ("fu", Characteristic::AdjacentPitch, |pitch, flank| Some(pitch.flanks[flank].as_ref()?.neighbours)),
        ("Rp", Characteristic::PitchRange, |pitch, flank| pitch.printed_range[flank]),
        ("Fp", Characteristic::CumulativePitch, |pitch, flank| Some(pitch.flanks[flank].as_ref()?.total)),
        ("Fpk", Characteristic::SectorPitch, |pitch, flank| Some(pitch.flanks[flank].as_ref()?.sector)),
    ];
    for (key, characteristic, evaluated) in of_flanks {
        if printed.peek(key).is_none() {
            continue;
        }
        let both = Flank::BOTH.map(|flank| of(characteristic, Some(flank), Statistic::Gear));
        printed.list(key, &both, AS_PRINTED, ledger);
        for (flank, machine) in Flank::BOTH.into_iter().zip(both) {
            let evaluated = pitch.and_then(|pitch| evaluated(pitch, flank)).unwrap_or(f64::NAN) * 1e3;
            let quantity = compared(&printed.name(&format!("{key}.{flank}")));
            ledger.number(printed.case(), &quantity, machine, evaluated, allowed.printed_um);
        }
    }
    let run_out = pitch.and_then(|pitch| pitch.run_out.as_ref()).map(|found| found.total * 1e3);
    let variation = pitch.and_then(|pitch| pitch.thickness_variation).map(|mm| mm * 1e3);
    for (key, characteristic, statistic, evaluated, tolerance) in [
        ("Fr", Characteristic::RunOut, Statistic::Gear, run_out, allowed.printed_um),
        ("Rs", Characteristic::ThicknessRange, Statistic::Gear, variation, allowed.printed_um),
        ("MdK", Characteristic::OverBalls, Statistic::Mean, found.over_balls_by_span, allowed.over_balls_mm),
    ] {
        if printed.peek(key).is_none() {
            continue;
        }
        let machine = of(characteristic, None, statistic);
        printed.number(key, machine, AS_PRINTED, ledger);
        let evaluated = evaluated.unwrap_or(f64::NAN);
        ledger.number(printed.case(), &compared(&printed.name(key)), machine, evaluated, tolerance);
    }
    // The span is what the measure over balls was evaluated from.
    printed.number("Wk", of(Characteristic::Span, None, Statistic::Mean), AS_PRINTED, ledger);
}
