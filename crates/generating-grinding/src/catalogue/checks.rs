//! Contradictions between entries of a catalogue that are each in range. Knows no gear.

use std::collections::HashMap;

use super::{Catalogue, DresserEntry, WormEntry};
use job::{Diagnostic, Problem, shown_number};

/// All contradictions; without places, which the caller knows.
pub(super) fn check(catalogue: &Catalogue) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    names("worm", catalogue.worm.iter().map(|w| w.name.as_str()), &mut findings);
    names("dresser", catalogue.dresser.iter().map(|d| d.name.as_str()), &mut findings);
    for (i, entry) in catalogue.worm.iter().enumerate() {
        worm(&format!("worm[{i}]"), entry, &mut findings);
    }
    for (i, entry) in catalogue.dresser.iter().enumerate() {
        dresser(&format!("dresser[{i}]"), entry, &mut findings);
    }
    findings
}

/// The ranking calls bodies by their names.
fn names<'a>(list: &str, names: impl Iterator<Item = &'a str>, findings: &mut Vec<Diagnostic>) {
    let mut seen: HashMap<&str, usize> = HashMap::new();
    for (i, name) in names.enumerate() {
        match seen.get(name) {
            Some(first) => findings.push(
                Diagnostic::new(Problem::InvalidCatalogue, format!("two entries are called {name:?}"))
                    .field(format!("{list}[{i}].name"))
                    .value(format!("{name:?}"))
                    .allowed(format!("another name than that of {list}[{first}]"))
                    .way_out("give each body its own name"),
            ),
            None => _ = seen.insert(name, i),
        }
    }
}

/// At least one diameter, the pitch circle inside the tip circle.
fn diameters(at: &str, pitch: Option<f64>, tip: Option<f64>, findings: &mut Vec<Diagnostic>) {
    match (pitch, tip) {
        (None, None) => findings.push(
            Diagnostic::new(Problem::MissingKey, format!("`{at}` has no diameter"))
                .field(format!("{at}.pitch_diameter"))
                .allowed("pitch_diameter or tip_diameter, or both")
                .way_out("add the pitch diameter of the worm in mm"),
        ),
        (Some(pitch), Some(tip)) => below(at, ("pitch_diameter", pitch), ("tip_diameter", tip), findings),
        _ => {}
    }
}

fn below(at: &str, (small, value): (&str, f64), (large, limit): (&str, f64), findings: &mut Vec<Diagnostic>) {
    if value >= limit {
        findings.push(
            Diagnostic::new(
                Problem::InvalidGeometry,
                format!("`{small}` = {value} is not below `{large}` = {limit}"),
            )
            .field(format!("{at}.{small}"))
            .value(shown_number(value))
            .allowed(format!("< {}", shown_number(limit)))
            .way_out("compare both with the drawing of this body"),
        );
    }
}

fn worm(at: &str, worm: &WormEntry, findings: &mut Vec<Diagnostic>) {
    diameters(at, worm.pitch_diameter, worm.tip_diameter, findings);
    let worn = [
        ("smallest_pitch_diameter", worm.smallest_pitch_diameter, "pitch_diameter", worm.pitch_diameter),
        ("smallest_tip_diameter", worm.smallest_tip_diameter, "tip_diameter", worm.tip_diameter),
    ];
    for (small, smallest, now, diameter) in worn {
        if let (Some(smallest), Some(diameter)) = (smallest, diameter)
            && smallest > diameter
        {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidGeometry,
                    format!(
                        "the worn worm is larger than the worm in its present state ({now} = {diameter})"
                    ),
                )
                .field(format!("{at}.{small}"))
                .value(shown_number(smallest))
                .allowed(format!("<= {}", shown_number(diameter)))
                .way_out("give the diameter at which the worm is used up, or leave it out"),
            );
        }
    }
    if worm.smallest_pitch_diameter.is_some()
        && let Some(tip) = worm.smallest_tip_diameter
    {
        findings.push(
            Diagnostic::new(Problem::InvalidCatalogue, "the worn diameter is given twice")
                .field(format!("{at}.smallest_tip_diameter"))
                .value(shown_number(tip))
                .allowed("one of smallest_pitch_diameter, smallest_tip_diameter")
                .way_out("keep one of them"),
        );
    }
}

fn dresser(at: &str, dresser: &DresserEntry, findings: &mut Vec<Diagnostic>) {
    let tip = dresser.tip_diameter;
    if let Some(pitch) = dresser.pitch_diameter {
        below(at, ("pitch_diameter", pitch), ("tip_diameter", tip), findings);
    }
    if let Some(flank) = dresser.flank_diameters {
        below(&format!("{at}.flank_diameters"), ("from", flank.from), ("to", flank.to), findings);
        if flank.to > tip {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidGeometry,
                    "the profile reaches beyond the tip of the dresser",
                )
                .field(format!("{at}.flank_diameters.to"))
                .value(shown_number(flank.to))
                .allowed(format!("<= tip_diameter = {}", shown_number(tip)))
                .way_out("give the diameter at which the flanks end"),
            );
        }
    }
    let there = &dresser.designed_for;
    diameters(&format!("{at}.designed_for"), there.pitch_diameter, there.tip_diameter, findings);
}
