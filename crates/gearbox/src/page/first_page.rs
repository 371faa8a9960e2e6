//! The first page: errors beside their limits, scale and interpolator, coupling, servo.

use crate::workflow::{GearboxResult, RangeUm};
use report::cells::NONE;
use report::charts::{format_fixed, format_significant};
use report::{Column, FirstPage, Quantity, Section, Sheet, Table};

pub(super) fn first_page(result: &GearboxResult, sections: &[Section]) -> FirstPage {
    let explored = FirstPage::picture_of(sections, "set-ups-to-choose-from");
    FirstPage {
        scope: result.verdict.scope_in_short(),
        picture: explored.or_else(|| FirstPage::picture_of(sections, "errors")),
        values: values(result),
        sheets: vec![scale(result), coupling(result), pulses(result), servo(result)],
    }
}

/// Errors that the motion has; `None` for a train of pulses.
fn values(result: &GearboxResult) -> Option<Table> {
    let row = |name: &str, found: Option<RangeUm>, limits: Option<RangeUm>| {
        let um = |range: Option<RangeUm>, end: fn(RangeUm) -> f64| {
            range.map_or_else(|| NONE.to_owned(), |range| format_fixed(end(range), 3))
        };
        found?;
        let ends: [fn(RangeUm) -> f64; 2] = [|range| range.least_um, |range| range.greatest_um];
        let cells = [found, limits].into_iter().flat_map(|range| ends.map(|end| um(range, end)));
        Some(std::iter::once(name.to_owned()).chain(cells).collect::<Vec<String>>())
    };
    let along = result.along_feed.as_ref();
    let angle = result.angle.as_ref();
    let rows: Vec<Vec<String>> = [
        row("along the feed, whole motion", along.and_then(|a| a.whole), along.and_then(|a| a.bound)),
        row(
            "along the feed, constant speed",
            along.and_then(|a| a.steady),
            along.and_then(|a| a.steady_bound),
        ),
        row("rotation at the flank, whole motion", angle.map(|a| a.flank), angle.and_then(|a| a.bound)),
    ]
    .into_iter()
    .flatten()
    .collect();
    let tolerance = result.tolerance_um.map(|um| format_significant(um, 4));
    (!rows.is_empty()).then(|| Table {
        caption: "Errors beside their limits".to_owned(),
        columns: vec![
            Column::text("Error"),
            Column::number("Least", "µm"),
            Column::number("Greatest", "µm"),
            Column::number("Limit, least", "µm"),
            Column::number("Limit, greatest", "µm"),
        ],
        rows,
        note: tolerance.map_or_else(
            || "Tolerance at the flank: not given.".to_owned(),
            |um| format!("Tolerance at the flank: {um} µm."),
        ),
    })
}

fn scale(result: &GearboxResult) -> Sheet {
    let s = &result.settings;
    Sheet::new(
        "Scale, interpolator, encoder",
        vec![
            Quantity::number("reference pulses per metre", "q", s.pulses_per_metre, "1/m"),
            Quantity::number("clock", "f_1", s.clock_hz, "Hz"),
            Quantity::count("pulses per interval", "P", i64::from(s.pulses_per_interval)),
            Quantity::count(
                "workpiece pulses per revolution",
                "N_w",
                i64::from(s.workpiece_pulses_per_revolution),
            ),
            Quantity::rounded("greatest speed", "v_max", s.greatest_speed_mm_per_min, 1, "mm/min"),
        ],
    )
}

fn coupling(result: &GearboxResult) -> Sheet {
    let c = &result.coupling;
    let mut list = Vec::new();
    list.extend(c.lead_mm.map(|lead| Quantity::rounded("lead", "p_z", lead, 4, "mm")));
    list.push(Quantity::number("coefficient", "b", c.coefficient, ""));
    list.push(Quantity::rounded("flank per workpiece pulse", "", c.flank_um_per_workpiece_pulse, 4, "µm"));
    list.push(Quantity::number("rounding of the rotation in use", "", c.rotation_error_um_per_m, "µm/m"));
    Sheet::new("Coupling", list)
}

fn pulses(result: &GearboxResult) -> Sheet {
    let p = &result.pulses;
    let count = |n: u64| i64::try_from(n).unwrap_or(i64::MAX);
    Sheet::new(
        "Pulses and time",
        vec![
            Quantity::count("pulses", "", count(p.pulses)),
            Quantity::count("alarms: overruns", "", count(p.overruns)),
            Quantity::count("alarms: too fast", "", count(p.too_fast)),
            Quantity::rounded("duration", "", result.settings.duration_s, 3, "s"),
        ],
    )
}

fn servo(result: &GearboxResult) -> Sheet {
    let sheet = Sheet::new("Servo of the workpiece spindle", Vec::new());
    let Some(servo) = &result.servo else { return sheet.remark("Not given: the job has no servo.") };
    Sheet::new(
        "Servo of the workpiece spindle",
        vec![
            Quantity::rounded("workpiece, rms", "", servo.workpiece.rms_um, 3, "µm"),
            Quantity::rounded("workpiece, peak", "", servo.workpiece.peak_um, 3, "µm"),
            Quantity::rounded("greatest torque", "", servo.greatest_torque_n_m, 2, "N m"),
        ],
    )
}
