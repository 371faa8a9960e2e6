//! What the drawing asks for, with tolerances and as made: traces where they were evaluated, else the whole field.

use crate::page::content::{GrindingPage, ShownFlank};
use crate::page::drawn_values::SYMBOLS;
use crate::page::summary::ROWS;
use crate::page::target_amounts::TargetAmount;
use crate::workflow::drawn_values::{TraceDirection, TraceResult};
use report::cells::NONE;
use report::charts::{format_fixed, format_significant};
use report::{Column, Table};
use run::ToleranceResult;

/// Rows that the page has room for.
const MOST_ROWS: usize = 14;

/// What a flank has of a characteristic, um.
#[derive(Clone, Copy, Default)]
struct Cells {
    drawn: Option<f64>,
    target: Option<f64>,
    made: Option<f64>,
}

/// A characteristic of both flanks.
struct Row {
    name: String,
    flanks: Vec<Cells>,
    tolerance: Option<f64>,
}

/// Amounts of a modification that a trace evaluates, by the words of the target.
const EVALUATED: [&str; 8] = [
    "profile crowning",
    "helix crowning",
    "profile slope",
    "helix slope",
    "tip relief",
    "root relief",
    "end relief at",
    "end relief opposite",
];

/// The table; `None` without flanks.
pub(in crate::page) fn values(page: &GrindingPage<'_>) -> Option<Table> {
    let flanks: Vec<(String, &ShownFlank<'_>)> = page
        .flanks
        .iter()
        .filter_map(|(side, flank)| flank.as_ref().map(|flank| (side.to_string(), flank)))
        .collect();
    if flanks.is_empty() {
        return None;
    }
    let shown: Vec<&ShownFlank<'_>> = flanks.iter().map(|(_, flank)| *flank).collect();
    let traced = shown.iter().any(|flank| !flank.result.traces.is_empty());
    let mut rows = if traced { evaluated(&shown) } else { Vec::new() };
    rows.extend(other_amounts(&shown, traced));
    rows.extend(deviations(&shown, page.class.as_ref()));
    let fits = rows.len() < MOST_ROWS;
    rows.truncate(MOST_ROWS - 1);
    rows.push(Row {
        name: "Largest deviation from the target, normal".to_owned(),
        flanks: made(&shown, |flank| Some(flank.result.max_deviation_um)),
        tolerance: Some(page.tolerance_um),
    });
    let mut columns = vec![Column::symbols("Characteristic")];
    for (side, _) in &flanks {
        let side = if side == "left" { "Left" } else { "Right" };
        columns
            .extend(["drawing", "target", "made"].map(|what| Column::number(format!("{side} {what}"), "µm")));
    }
    columns.push(Column::number("Tolerance", "µm"));
    let cell = |um: Option<f64>| um.map_or_else(|| NONE.to_owned(), |um| format_fixed(um, 2));
    let drawn = |um: Option<f64>| um.map_or_else(|| NONE.to_owned(), |um| format_significant(um, 5));
    let rows = rows.into_iter().map(|row| {
        let cells = row.flanks.iter().flat_map(|c| [drawn(c.drawn), cell(c.target), cell(c.made)]);
        std::iter::once(row.name).chain(cells).chain([drawn(row.tolerance)]).collect()
    });
    let how = if traced {
        "Made: traces of the simulated flank, evaluated as a gear measuring machine does; target: the wanted flank, evaluated alike."
    } else {
        "Made: least squares over the whole simulated flank; target: the wanted flank alike."
    };
    let more = if fits { "" } else { " Further values stand in the details." };
    Some(Table {
        caption: "Values of the drawing, as made".to_owned(),
        columns,
        rows: rows.collect(),
        note: format!("Transverse, positive: material removed. {how}{more}"),
    })
}

fn made(flanks: &[&ShownFlank<'_>], value: impl Fn(&ShownFlank<'_>) -> Option<f64>) -> Vec<Cells> {
    flanks.iter().map(|flank| Cells { made: value(flank), ..Cells::default() }).collect()
}

/// Values of the traces, the one farthest from its target of each flank.
fn evaluated(flanks: &[&ShownFlank<'_>]) -> Vec<Row> {
    let of = |flank: &ShownFlank<'_>, symbol: &str| {
        let values = flank.result.traces.iter().flat_map(|trace| &trace.values);
        let distance = |made: f64, target: f64| (made - target).abs();
        values
            .filter(|value| value.symbol == symbol)
            .max_by(|a, b| distance(a.made_um, a.target_um).total_cmp(&distance(b.made_um, b.target_um)))
            .map_or_else(Cells::default, |value| Cells {
                drawn: value.drawn_um,
                target: Some(value.target_um),
                made: Some(value.made_um),
            })
    };
    let rows = SYMBOLS.iter().map(|(symbol, name)| Row {
        name: (*name).to_owned(),
        flanks: flanks.iter().map(|flank| of(flank, symbol)).collect(),
        tolerance: None,
    });
    // What the drawing does not name stands in the details.
    rows.filter(|row| row.flanks.iter().any(|cells| cells.drawn.is_some())).collect()
}

/// Amounts of the drawing that no trace evaluates: twist by the whole field, of others what is asked for.
fn other_amounts(flanks: &[&ShownFlank<'_>], traced: bool) -> Vec<Row> {
    let mut names: Vec<&str> = Vec::new();
    for amount in flanks.iter().flat_map(|flank| &flank.amounts) {
        let seen = traced && EVALUATED.iter().any(|name| amount.name.starts_with(name));
        if !seen && !names.contains(&amount.name.as_str()) {
            names.push(&amount.name);
        }
    }
    names.into_iter().map(|name| fitted(flanks, name)).collect()
}

fn fitted(flanks: &[&ShownFlank<'_>], name: &str) -> Row {
    let row = ROWS.iter().find(|(_, kind, _)| *kind == name);
    let of = |flank: &&ShownFlank<'_>| {
        let asked: Vec<&TargetAmount> = flank.amounts.iter().filter(|amount| amount.name == name).collect();
        let drawn = asked.iter().filter_map(|amount| amount.amount_um).reduce(|a, b| a + b);
        match row.filter(|_| !asked.is_empty()) {
            Some((.., value)) => Cells {
                drawn,
                target: Some(value(&flank.result.target_characteristics)),
                made: Some(value(&flank.result.simulated_characteristics)),
            },
            None => Cells { drawn, ..Cells::default() },
        }
    };
    let mut letters = name.chars();
    let capital =
        letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect());
    let name = row.map_or(capital, |(shown, ..)| (*shown).to_owned());
    Row { name, flanks: flanks.iter().map(of).collect(), tolerance: None }
}

/// Deviations of profile and helix to ISO 1328-1, the largest of each direction, beside the tolerances of the drawing's class.
fn deviations(flanks: &[&ShownFlank<'_>], class: Option<&ToleranceResult>) -> Vec<Row> {
    type Value = fn(&TraceResult) -> f64;
    type Tolerance = fn(&ToleranceResult) -> f64;
    let rows: [(&str, TraceDirection, Value, Tolerance); 6] = [
        (
            "F_α profile, total deviation",
            TraceDirection::Profile,
            |trace| trace.total_um,
            |class| class.F_alphaT_um,
        ),
        (
            "f_Hα profile, slope deviation",
            TraceDirection::Profile,
            |trace| trace.slope_um,
            |class| class.f_HalphaT_um,
        ),
        (
            "f_fα profile, form deviation",
            TraceDirection::Profile,
            |trace| trace.form_um,
            |class| class.f_falphaT_um,
        ),
        (
            "F_β helix, total deviation",
            TraceDirection::Helix,
            |trace| trace.total_um,
            |class| class.F_betaT_um,
        ),
        (
            "f_Hβ helix, slope deviation",
            TraceDirection::Helix,
            |trace| trace.slope_um,
            |class| class.f_HbetaT_um,
        ),
        (
            "f_fβ helix, form deviation",
            TraceDirection::Helix,
            |trace| trace.form_um,
            |class| class.f_fbetaT_um,
        ),
    ];
    let rows = rows.into_iter().map(|(name, direction, value, tolerance)| {
        let largest = |flank: &ShownFlank<'_>| {
            let of = flank.result.traces.iter().filter(|trace| trace.direction == direction).map(value);
            of.max_by(|a, b| a.abs().total_cmp(&b.abs()))
        };
        Row { name: name.to_owned(), flanks: made(flanks, largest), tolerance: class.map(tolerance) }
    });
    rows.filter(|row| row.flanks.iter().any(|cells| cells.made.is_some())).collect()
}
