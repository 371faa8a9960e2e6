//! Sections of what a job adds: errors of scale, screw and encoder, added rotation, whole pulses and voltage, the way into the gap,
//! multipliers compared.

use super::bands::{Stretch, chart, panel, stretches};
use crate::workflow::{
    ComparedResult, CorrectionResult, EngagementResult, GearboxOutcome, GearboxResult, MeasuringResult,
    RangeUm, SplitResult,
};
use control::{EngagingRecord, MultiplierRun};
use report::cells::NONE;
use report::charts::{ChartError, Panel, Series, format_fixed, format_significant};
use report::{Block, Column, Figure, Quantity, Section, Table};

/// The sections that a job asks for.
pub(super) fn sections(outcome: &GearboxOutcome) -> Result<Vec<Section>, ChartError> {
    let GearboxResult { errors, corrections, split, engagement, compare, .. } = &outcome.result;
    let mut sections = Vec::new();
    if !compare.is_empty() {
        let blocks = compared(compare, outcome)?;
        sections.push(Section::new("multipliers-compared", "Multipliers compared", blocks));
    }
    if let Some(errors) = errors {
        sections.push(Section::new("scale-screw-and-encoder", "Scale, screw and encoder", measured(errors)));
    }
    if !corrections.is_empty() {
        sections.push(Section::new(
            "added-rotation",
            "Added rotation",
            vec![Block::Table(added(corrections))],
        ));
    }
    if let Some(split) = split {
        let table = Table::of_quantities("", &of_split(split));
        sections.push(Section::new(
            "whole-pulses-and-voltage",
            "Whole pulses and voltage",
            vec![Block::Table(table)],
        ));
    }
    if let (Some(engagement), Some(record)) = (engagement, &outcome.engaging) {
        let blocks = engaged(engagement, record)?;
        sections.push(Section::new("into-the-gap-of-the-worm", "Into the gap of the worm", blocks));
    }
    Ok(sections)
}

fn ends(range: RangeUm) -> String {
    format!("{} … {}", format_significant(range.least_um, 4), format_significant(range.greatest_um, 4))
}

fn um(name: &str, range: RangeUm) -> Quantity {
    let mut quantity = Quantity::text(name, ends(range));
    quantity.unit = "µm".into();
    quantity
}

fn measured(errors: &MeasuringResult) -> Vec<Block> {
    let row = |name: &str, along: Option<f64>, flank: f64| {
        vec![
            name.to_owned(),
            along.map_or_else(|| NONE.to_owned(), |um| format_significant(um, 4)),
            format_significant(flank, 4),
        ]
    };
    let parts = errors.parts.iter().map(|part| row(part.name, part.along_feed_um, part.flank_um));
    let mut blocks = vec![Block::Table(Table {
        caption: String::new(),
        columns: vec![
            Column::text("Part"),
            Column::number("Along the feed", "µm"),
            Column::number("At the flank", "µm"),
        ],
        rows: parts.chain([row("sum", None, errors.sum_flank_um)]).collect(),
        note: "Greatest amount over the motion, along the feed against the place where it begins.".into(),
    })];
    if let Some(encoder) = &errors.encoder {
        let list = [
            Quantity::number("greatest error either way", "", encoder.greatest_um, "µm"),
            um("error of a tooth space", encoder.teeth),
            Quantity::number("single pitch deviation", "", encoder.single_pitch_um, "µm"),
            Quantity::number("cumulative pitch deviation", "", encoder.cumulative_pitch_um, "µm"),
        ];
        blocks.push(Block::Table(Table::of_quantities("Encoder on the teeth, normal to the flank", &list)));
    }
    blocks
}

fn added(corrections: &[CorrectionResult]) -> Table {
    let rows = corrections.iter().map(|correction| {
        vec![
            correction.axis.to_owned(),
            format_significant(correction.flank.least_um, 4),
            format_significant(correction.flank.greatest_um, 4),
            format_significant(correction.greatest_speed_deg_per_s, 4),
            format_significant(correction.speed_jump_deg_per_s, 4),
            format_significant(correction.rounding_um, 3),
        ]
    });
    Table {
        caption: String::new(),
        columns: vec![
            Column::text("Over"),
            Column::number("Least", "µm"),
            Column::number("Greatest", "µm"),
            Column::number("Greatest speed", "°/s"),
            Column::number("Jump of the speed", "°/s"),
            Column::number("Rounding", "µm"),
        ],
        rows: rows.collect(),
        note: "At the flank, normal; speeds of the workpiece. A table that holds its end values jumps in speed where the feed passes them."
            .into(),
    }
}

fn of_split(split: &SplitResult) -> Vec<Quantity> {
    let count = |name: &str, value: u64| Quantity::count(name, "", i64::try_from(value).unwrap_or(i64::MAX));
    vec![
        count("whole pulses forward", split.forward_pulses),
        count("whole pulses backward", split.backward_pulses),
        Quantity::count("whole pulses at the end", "", split.whole_pulses),
        Quantity::count("parts 1/P at the end", "", i64::from(split.part)),
        Quantity::number("their voltage", "", split.voltage_v, "V"),
        Quantity::number("one part at the flank", "", split.step_um, "µm"),
        um("voltage less part, at the flank", split.error),
        um("limits of it", split.limits),
        Quantity::number("read apart: one whole pulse", "", split.read_apart_um, "µm"),
    ]
}

fn engaged(engagement: &EngagementResult, record: &EngagingRecord) -> Result<Vec<Block>, ChartError> {
    let time: Vec<f64> = record.samples.iter().map(|sample| sample.time).collect();
    let speed = record.samples.iter().map(|sample| sample.speed).collect();
    let named: Vec<(f64, f64)> =
        record.samples.iter().filter_map(|sample| Some((sample.time, sample.to_gap?))).collect();
    let (at, way): (Vec<f64>, Vec<f64>) = named.into_iter().unzip();
    let mut panels =
        vec![Panel::linear("speed of the workpiece [°/s]", 0.0, vec![Series::new("speed", time, speed)])];
    if !at.is_empty() {
        panels.push(Panel::linear("way to the gap [°]", 0.0, vec![Series::new("way", at, way)]));
    }
    let svg = chart("The way into the gap", panels)?;
    let caption = "The workpiece comes up to the speed of the coupling, then moves into the nearest gap while both turn.";
    let list = [
        Quantity::rounded("up to speed", "", engagement.ramp_s, 4, "s"),
        Quantity::rounded("way meanwhile", "", engagement.ramp_way_deg, 3, "deg"),
        Quantity::rounded("move into the gap", "", engagement.phase_move_deg, 4, "deg"),
        Quantity::rounded("in the gap after", "", engagement.coupled_after_s, 4, "s"),
        Quantity::rounded(
            "greatest speed of the workpiece",
            "",
            engagement.greatest_speed_deg_per_s,
            2,
            "deg/s",
        ),
        Quantity::rounded(
            "greatest acceleration of the workpiece",
            "",
            engagement.greatest_acceleration_deg_per_s2,
            1,
            "deg/s²",
        ),
        um("workpiece less gap, at the flank", engagement.miss),
    ];
    let counter = [
        Quantity::count("greatest way in a cycle", "", engagement.counts_a_cycle),
        Quantity::rounded("of half the range", "", engagement.counter_used_percent, 2, "%"),
        Quantity::count("wrapped", "", i64::try_from(engagement.counter_wraps).unwrap_or(i64::MAX)),
        Quantity::rounded("greatest speed of the worm", "", engagement.greatest_worm_speed_rpm, 1, "1/min"),
    ];
    Ok(vec![
        Block::Figure(Figure::new("the-way-into-the-gap", svg, caption)),
        Block::Tables(vec![
            Table::of_quantities("Engagement", &list),
            Table::of_quantities("Counter of the worm", &counter),
        ]),
    ])
}

fn compared(compare: &[ComparedResult], outcome: &GearboxOutcome) -> Result<Vec<Block>, ChartError> {
    let own: Vec<Stretch> = stretches(&outcome.run.bins, 1e3, |bin| (bin.time, bin.axial));
    let others = outcome.compared.iter().map(|run: &MultiplierRun| stretches(&run.bins, 1e3, |bin| *bin));
    let bands: Vec<Vec<Stretch>> = std::iter::once(own).chain(others).collect();
    let panels = compare
        .iter()
        .zip(&bands)
        .filter(|(_, band)| !band.is_empty())
        .map(|(line, band)| panel(&format!("{} [µm]", line.multiplier), band, None, None));
    let svg = chart("Errors of the multipliers along the feed", panels.collect())?;
    let caption = "Shown position less slide, least and greatest in each stretch of time, on the same motion and scale.";
    let rows = compare.iter().map(|line| {
        let steady = |of: fn(RangeUm) -> f64| {
            line.steady.map_or_else(|| NONE.to_owned(), |range| format_fixed(of(range), 3))
        };
        vec![
            line.multiplier.to_owned(),
            format_fixed(line.whole.least_um, 3),
            format_fixed(line.whole.greatest_um, 3),
            steady(|range| range.least_um),
            steady(|range| range.greatest_um),
            format_fixed(line.flank_um, 3),
            line.steady_flank_um.map_or_else(|| NONE.to_owned(), |um| format_fixed(um, 3)),
        ]
    });
    let table = Table {
        caption: String::new(),
        columns: vec![
            Column::text("Multiplier"),
            Column::number("Least", "µm"),
            Column::number("Greatest", "µm"),
            Column::number("Constant speed, least", "µm"),
            Column::number("Constant speed, greatest", "µm"),
            Column::number("At the flank", "µm"),
            Column::number("Constant speed, at the flank", "µm"),
        ],
        rows: rows.collect(),
        note: "Along the feed but for the last two columns; the last one is half the range, which no constant lag enters.".into(),
    };
    Ok(vec![Block::Figure(Figure::new("errors-of-the-multipliers", svg, caption)), Block::Table(table)])
}
