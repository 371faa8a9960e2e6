//! Blocks `axis_recovery` and `trace_layouts`: which settings a measurement tells apart and how well, on grids and from traces.

use super::super::expected::Expected;
use super::super::given::{Checked, MOST, count, number, requires};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::each_case::each_case;
use super::grinding::{Grinding, UM, key, unit};
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use generating::correction::{Correction, CorrectionTask, FlankPoint, Setting, SettingInfluence, Weighting};
use serde_json::Value;

/// Singular values of no meaning are some roundings of the first.
const ROUNDING: f64 = 1e-12;

/// Block `axis_recovery`.
pub(crate) fn axis_recovery(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each_case("axis_recovery", block, ledger, |input, tolerances, case, ledger| {
        let mut expected = case.object("expected", ledger).ok_or("expected is missing")?;
        let grinding = Grinding::read(input, ledger)?;
        let influence = SettingInfluence::new(&grinding.lines, grinding.ratio, grinding.face_width)?;
        let points = grinding.grid(input)?;
        let sigma = number(input, "sigma_um", ledger)? * UM;
        let one: Vec<FlankPoint> = points.iter().copied().filter(|p| p.flank == Flank::Left).collect();
        let own = |s: &Setting| s.flank().is_none_or(|flank| flank == Flank::Left);
        let of_one: Vec<Setting> = Setting::USUAL.into_iter().filter(own).collect();
        for (name, points, settings) in
            [("both", &points, Setting::USUAL.as_slice()), ("left", &one, of_one.as_slice())]
        {
            let Some(mut object) = expected.object(name, ledger) else { continue };
            let found = judged(&influence, settings, points, None, sigma)?;
            compare(
                &found,
                settings,
                tolerances.get("relative"),
                tolerances.get("rank"),
                &mut object,
                ledger,
            )?;
            object.finish(ledger);
        }
        expected.finish(ledger);
        Ok(())
    });
}

/// Block `trace_layouts`: every trace has its own zero, so that size and index are left out.
pub(crate) fn trace_layouts(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each_case("trace_layouts", block, ledger, |input, tolerances, case, ledger| {
        let grinding = Grinding::read(input, ledger)?;
        let influence = SettingInfluence::new(&grinding.lines, grinding.ratio, grinding.face_width)?;
        let sigma = number(input, "sigma_um", ledger)? * UM;
        let samples = count(input, "samples_per_trace", 2..=MOST)?;
        requires(input, "positions", &["1: 0.5; 2: 0.1, 0.9; 3: 0.1, 0.5, 0.9 of the field"], ledger)?;
        let settings: Vec<Setting> =
            Setting::USUAL.into_iter().filter(|s| !s.needs_absolute_zeros()).collect();
        for mut layout in case.objects("expected", ledger) {
            let counts = [count(&mut layout, "profiles", 1..=3)?, count(&mut layout, "leads", 1..=3)?];
            let (points, traces) = traces(&grinding, counts, samples);
            let found = judged(&influence, &settings, &points, Some(traces), sigma)?;
            layout.number("unknowns", found.unknowns as f64, 0.0, ledger);
            let relative = tolerances.get("relative");
            compare(&found, &settings, relative, tolerances.get("rank"), &mut layout, ledger)?;
            layout.finish(ledger);
        }
        Ok(())
    });
}

/// Positions of so many traces over a field of length 1.
fn positions(count: usize) -> &'static [f64] {
    [[0.5].as_slice(), &[0.1, 0.9], &[0.1, 0.5, 0.9]][count - 1]
}

/// Points of all traces and the trace of each.
fn traces(
    grinding: &Grinding,
    [profiles, leads]: [usize; 2],
    samples: usize,
) -> (Vec<FlankPoint>, Vec<usize>) {
    let (mut points, mut traces, mut trace) = (Vec::new(), Vec::new(), 0);
    let at = |[from, to]: [f64; 2], share: f64| from + share * (to - from);
    for flank in Flank::BOTH {
        let (roll, face) = (grinding.fields[flank].roll(), grinding.fields[flank].face());
        for &share in positions(profiles) {
            let z = at(face, share);
            points.extend(equidistant(roll, samples).into_iter().map(|w| FlankPoint { flank, w, z }));
            traces.extend(std::iter::repeat_n(trace, samples));
            trace += 1;
        }
        for &share in positions(leads) {
            let w = at(roll, share);
            points.extend(equidistant(face, samples).into_iter().map(|z| FlankPoint { flank, w, z }));
            traces.extend(std::iter::repeat_n(trace, samples));
            trace += 1;
        }
    }
    (points, traces)
}

/// A flank without deviations: what counts is what is known of the settings.
fn judged(
    influence: &SettingInfluence<'_>,
    settings: &[Setting],
    points: &[FlankPoint],
    traces: Option<Vec<usize>>,
    sigma: f64,
) -> Checked<Correction> {
    let columns = influence.columns(settings, points)?;
    let mut task = CorrectionTask::new(vec![0.0; points.len()], columns);
    task.traces = traces;
    task.weighting = Weighting::Uncertainties(vec![sigma; points.len()]);
    task.allow_underdetermined = true;
    Ok(task.solve()?)
}

fn compare(
    found: &Correction,
    settings: &[Setting],
    relative: f64,
    rank: f64,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let first = found.singular_values.first().copied().unwrap_or(f64::NAN);
    let allowed = |e: f64| relative * e + ROUNDING * first;
    expected.number("rank", found.rank as f64, rank, ledger);
    expected.list_to("singular_values_scaled", &found.singular_values, allowed, ledger);
    let smallest = found.singular_values.last().copied().unwrap_or(f64::NAN);
    expected.number("smallest_singular_value_scaled", smallest, allowed(smallest), ledger);
    if let Some(listed) = expected.take("parameters") {
        let names: Vec<String> = settings.iter().copied().map(key).collect();
        ledger.equal(
            expected.case(),
            &expected.name("parameters"),
            listed.clone(),
            serde_json::to_value(names)?,
        );
    }
    if let Some(Value::Object(_)) = expected.peek("std_per_parameter") {
        let Some(mut object) = expected.object("std_per_parameter", ledger) else { return Ok(()) };
        for (setting, item) in settings.iter().zip(&found.settings) {
            let value = item.deviation.unwrap_or(f64::NAN) / unit(*setting);
            object.number(&key(*setting), value, relative * value.abs(), ledger);
        }
        object.finish(ledger);
    }
    Ok(())
}
