//! What the measuring machine printed beside what is evaluated here.

use super::evaluate::EvaluatedGear;
use super::result::PrintedResult;
use foundation::geometry::Flank;
use measured_files::inspection::{Characteristic, Inspection, Position, Statistic, TraceKind};

/// Printed values that have a counterpart.
pub(super) fn printed(inspection: &Inspection, gear: &EvaluatedGear) -> Vec<PrintedResult> {
    let mut found = Vec::new();
    let mut take = |name: String, printed: Option<f64>, evaluated: Option<f64>| {
        if let (Some(printed_um), Some(evaluated)) = (printed, evaluated) {
            found.push(PrintedResult { name, printed_um, evaluated_um: 1e3 * evaluated });
        }
    };
    for flank in Flank::BOTH {
        of_traces(inspection, gear, flank, &mut take);
        let pitch = gear.pitch.as_ref();
        let of = pitch.and_then(|pitch| pitch.flanks[flank].as_ref());
        for (name, characteristic, evaluated) in [
            ("fp", Characteristic::SinglePitch, of.map(|p| p.single)),
            ("fu", Characteristic::AdjacentPitch, of.map(|p| p.neighbours)),
            ("Rp", Characteristic::PitchRange, pitch.and_then(|p| p.printed_range[flank])),
            ("Fp", Characteristic::CumulativePitch, of.map(|p| p.total)),
            ("Fpz/8", Characteristic::SectorPitch, of.map(|p| p.sector)),
        ] {
            let value = value(inspection, characteristic, Some(flank), Statistic::Gear);
            take(format!("{name} {flank}"), value, evaluated);
        }
    }
    let pitch = gear.pitch.as_ref();
    let run_out = pitch.and_then(|p| p.run_out.as_ref()).map(|r| r.total);
    take("Fr".into(), value(inspection, Characteristic::RunOut, None, Statistic::Gear), run_out);
    let range = pitch.and_then(|p| p.thickness_variation);
    take("Rs".into(), value(inspection, Characteristic::ThicknessRange, None, Statistic::Gear), range);
    found
}

/// Values of traces: their codes count the measured teeth, so that they belong to traces only where all of those are there.
fn of_traces(
    inspection: &Inspection,
    gear: &EvaluatedGear,
    flank: Flank,
    take: &mut impl FnMut(String, Option<f64>, Option<f64>),
) {
    for kind in [TraceKind::Profile, TraceKind::Helix] {
        let [slope, total, form] = match kind {
            TraceKind::Profile => {
                [Characteristic::ProfileSlope, Characteristic::ProfileTotal, Characteristic::ProfileForm]
            }
            TraceKind::Helix => {
                [Characteristic::HelixSlope, Characteristic::HelixTotal, Characteristic::HelixForm]
            }
        };
        let measured = inspection.results.iter().filter(|q| {
            q.meaning.characteristic == slope
                && q.meaning.flank == Some(flank)
                && q.meaning.position == Position::Middle
                && matches!(q.meaning.statistic, Statistic::Tooth(_))
                && q.value.is_some()
        });
        let own = gear.traces.iter().filter(|one| {
            let trace = &inspection.traces[one.trace];
            trace.kind == kind && trace.flank == flank && trace.tag.is_empty()
        });
        let own: Vec<_> = own.collect();
        if measured.count() != own.len() {
            continue;
        }
        for (number, one) in own.into_iter().enumerate() {
            let at = Statistic::Tooth(number as u8 + 1);
            let tooth = inspection.traces[one.trace].tooth;
            let e = &one.evaluation;
            for (name, characteristic, evaluated) in
                [("fH", slope, e.slope.printed()), ("F", total, e.total), ("ff", form, e.form)]
            {
                let printed = value(inspection, characteristic, Some(flank), at);
                take(format!("{name} {} {flank} tooth {tooth}", kind.name()), printed, Some(evaluated));
            }
            let relief = one.tip_relief.as_ref().map(|relief| relief.amount);
            let printed = value(inspection, Characteristic::TipRelief, Some(flank), at);
            take(format!("fKo {flank} tooth {tooth}"), printed, relief);
        }
    }
}

fn value(
    inspection: &Inspection,
    characteristic: Characteristic,
    flank: Option<Flank>,
    statistic: Statistic,
) -> Option<f64> {
    let found = inspection.results.iter().find(|q| {
        let m = q.meaning;
        (m.characteristic, m.flank, m.statistic) == (characteristic, flank, statistic)
            && m.position == Position::Middle
    });
    found.and_then(|q| q.value)
}
