//! The table of axes of the programs of one kind.

use super::listed;
use super::station::{Moving, Resting, Station, Turning};
use report::charts::{format_fixed, format_significant, share_of_limit};
use report::{Column, Table, unit};

pub(super) fn axis_table(station: &Station<'_>) -> Table {
    let of = |(value, most): (f64, Option<f64>)| {
        let share = most.map_or("–".to_owned(), |most| share_of_limit(value / most));
        [format_significant(value, 4), share]
    };
    let row = |moving: &Moving<'_>| {
        let a = moving.axis;
        let role = moving.role.map_or(String::new(), |role| format!(", {}", role.key()));
        let mut cells = vec![format!("{}{role}", a.axis), words(moving), unit(a.unit).into_owned()];
        let decimals = decimals_of_way(a.way);
        cells.extend([a.from, a.to, a.way].map(|x| format_fixed(x, decimals)));
        cells.extend(of((a.velocity, a.max_velocity)));
        cells.extend(of((a.acceleration, a.max_acceleration)));
        cells
    };
    let mut notes = vec!["The share is that of the machine's limit.".to_owned()];
    let reversed: Vec<&str> =
        station.axes.iter().filter(|a| a.reversed).map(|a| a.axis.axis.as_str()).collect();
    if !reversed.is_empty() {
        notes.push(format!(
            "Positions count as the machine file does; the control counts {} the other way.",
            listed(&reversed)
        ));
    }
    let at = |r: &Resting| match r.unit {
        "deg" => format!("{} at {}°", r.axis, format_fixed(r.at, 4)),
        unit => format!("{} at {} {unit}", r.axis, format_fixed(r.at, 4)),
    };
    if !station.resting.is_empty() {
        notes.push(format!(
            "Standing still: {}.",
            listed(&station.resting.iter().map(at).collect::<Vec<_>>())
        ));
    }
    let turning =
        |s: &Turning| format!("{} ({}) at {} 1/min", s.axis, s.word, format_significant(s.speed_per_min, 5));
    if !station.spindles.is_empty() {
        let all: Vec<String> = station.spindles.iter().map(turning).collect();
        notes.push(format!("Turning as a spindle: {}.", listed(&all)));
    }
    Table {
        caption: format!("Axes that move in {}", station.job),
        columns: vec![
            Column::name("Axis"),
            Column::text("Word"),
            Column::text("Unit"),
            Column::number("From", ""),
            Column::number("To", ""),
            Column::number("Way", ""),
            Column::number("Largest velocity", "per s"),
            Column::number("Share", "%"),
            Column::number("Largest acceleration", "per s²"),
            Column::number("Share", "%"),
        ],
        rows: station.axes.iter().map(row).collect(),
        note: notes.join(" "),
    }
}

/// Decimals that show a way (mm or deg) to four digits, at least three and at most six.
fn decimals_of_way(way: f64) -> usize {
    match way {
        way if way >= 1.0 => 3,
        way if way >= 0.1 => 4,
        way if way >= 0.01 => 5,
        _ => 6,
    }
}

/// The word of an axis; with the controls where they differ.
fn words(axis: &Moving<'_>) -> String {
    match axis.words.as_slice() {
        [(only, _)] => (*only).to_owned(),
        several => several
            .iter()
            .map(|(word, controls)| format!("{word} ({})", controls.join(", ")))
            .collect::<Vec<_>>()
            .join("; "),
    }
}
