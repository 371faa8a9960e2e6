//! The first page: deviations of the flanks, what the machine and the cutter do, times, tooth thickness.

use super::cutter_words::cutter_words;
use super::shown_flank::ShownFlank;
use crate::workflow::MillingOutcome;
use report::cells::NONE;
use report::charts::{format_fixed, format_significant};
use report::{Column, FirstPage, Quantity, Section, Sheet, Table};
use std::f64::consts::PI;

pub(super) fn first_page(
    outcome: &MillingOutcome,
    shown: &[ShownFlank<'_>],
    sections: &[Section],
) -> FirstPage {
    let mut sheets = vec![settings(outcome), cutter(outcome), times(outcome)];
    if let Some((gear, measures)) = &outcome.prepared.teeth {
        sheets.push(measures.sheet(gear, None));
    }
    FirstPage {
        scope: outcome.result.verdict.scope_in_short(),
        picture: FirstPage::picture_of(sections, "deviations"),
        values: Some(values(shown, outcome.result.tolerance_um)),
        sheets,
    }
}

fn values(shown: &[ShownFlank<'_>], tolerance_um: f64) -> Table {
    let um = |x: f64| format_fixed(x, 2);
    let row = |flank: &ShownFlank<'_>| {
        let [deepest, highest] = flank.result.stock_um;
        let scallop = flank.result.rows.iter().filter_map(|row| row.scallop_um).reduce(f64::max);
        vec![
            flank.name(),
            format_significant(tolerance_um, 4),
            um(flank.result.max_deviation_um),
            um(flank.result.rms_deviation_um),
            um(highest),
            um(deepest),
            scallop.map_or_else(|| NONE.to_owned(), um),
        ]
    };
    Table {
        caption: "Deviation from the target".to_owned(),
        columns: vec![
            Column::name("Flank"),
            Column::number("Tolerance", "µm"),
            Column::number("Largest", "µm"),
            Column::number("Rms", "µm"),
            Column::number("Highest stock", "µm"),
            Column::number("Deepest gouge", "µm"),
            Column::number("Largest scallop", "µm"),
        ],
        rows: shown.iter().map(row).collect(),
        note: "Normal to the flank, positive: material left.".to_owned(),
    }
}

fn settings(outcome: &MillingOutcome) -> Sheet {
    let technology = &outcome.prepared.technology;
    let [spaces, milled] = outcome.result.spaces;
    let count = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
    let mut list = vec![
        Quantity::count("tooth spaces", "", count(spaces)),
        Quantity::count("of these milled", "", count(milled)),
        Quantity::rounded("spindle speed", "n", technology.finishing.spindle_rpm, 0, "1/min"),
        Quantity::rounded("feed", "v_f", technology.finishing.feed, 0, "mm/min"),
        Quantity::rounded("roughing feed", "v_f", technology.roughing.feed, 0, "mm/min"),
        Quantity::rounded("plunge feed", "v_f", technology.finishing.plunge_feed, 0, "mm/min"),
    ];
    if let Some(tilt) = outcome.result.programs.iter().find_map(|program| program.mount_tilt) {
        list.push(Quantity::rounded("tilt of the workpiece on the table", "", tilt.angle_deg, 3, "deg"));
    }
    Sheet::new("Machine settings", list)
}

fn cutter(outcome: &MillingOutcome) -> Sheet {
    let cutter = &outcome.result.cutter;
    let tool = &outcome.prepared.technology.finishing;
    let speed = PI * cutter.diameter * tool.spindle_rpm * 1e-3;
    let mut list = vec![
        Quantity::text("cutter of the flanks", cutter_words(cutter)),
        Quantity::count("tool number", "T", i64::from(tool.number)),
        Quantity::rounded("cutting length", "", cutter.cutting_length, 1, "mm"),
        Quantity::rounded("cutting speed at its diameter", "v_c", speed, 1, "m/min"),
    ];
    if let Some(edges) = tool.edges {
        list.push(Quantity::count("cutting edges", "z", i64::from(edges)));
        let per_tooth = tool.feed / (tool.spindle_rpm * f64::from(edges));
        list.push(Quantity::rounded("feed per tooth", "f_z", per_tooth, 4, "mm"));
    }
    Sheet::new("Cutter", list)
}

fn times(outcome: &MillingOutcome) -> Sheet {
    let sheet = Sheet::new("Times", Vec::new());
    let Some(program) = outcome.result.programs.first() else {
        return sheet.remark("Not known: no programs, the job names no machine.");
    };
    let second = |name: &str, value: f64| Quantity::rounded(name, "", value, 1, "s");
    let mut list = vec![
        second("milling, all spaces", program.duration_s),
        second("milling, one space", program.one_space_s),
    ];
    list.extend(program.operations.iter().map(|one| second(&one.name, one.cutting_s + one.rapid_s)));
    Sheet::new("Times", list)
        .remark("Without changes of tools, loading and clamping, which the job does not give.")
}
