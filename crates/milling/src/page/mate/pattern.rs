//! The contact pattern on the developed flank.

use super::developed::Developed;
use super::shown::ShownContact;
use crate::workflow::PatternResult;
use report::charts::{ChartError, Drawing, DrawingLayer, DrawingLook, DrawingNote};

/// The flank with the pattern that was rolled and the one that both ease-offs say.
pub(super) fn drawn(flank: &ShownContact<'_>, marking_um: f64) -> Result<Drawing, ChartError> {
    let developed = Developed::new(&*flank.rolled.surface, &flank.rolled.places);
    let [rolled, said] = &flank.rolled.gaps;
    let layers = vec![
        layer("rolled", DrawingLook::Material, developed.loops(&rolled.gaps, marking_um)?),
        layer("by the ease-offs", DrawingLook::OtherEdge, developed.loops(&said.gaps, marking_um)?),
    ];
    let title = format!("{}: contact pattern", flank.name());
    Ok(on_flank(&developed, title, flank.ends(), layers, flank.result.rolled.as_ref()))
}

/// The flank with the pattern that it has as it is milled; `None` before it is planned.
pub(super) fn milled(flank: &ShownContact<'_>, marking_um: f64) -> Result<Option<Drawing>, ChartError> {
    let Some(milled) = &flank.rolled.milled else { return Ok(None) };
    let developed = Developed::new(&*flank.rolled.surface, &milled.places);
    let marked = developed.loops(&milled.gaps.gaps, marking_um)?;
    let title = format!("{}: contact pattern as milled", flank.name());
    let layers = vec![layer("as milled", DrawingLook::Material, marked)];
    Ok(Some(on_flank(&developed, title, flank.ends(), layers, flank.result.milled.as_ref())))
}

fn layer(name: &str, look: DrawingLook, lines_mm: Vec<Vec<[f64; 2]>>) -> DrawingLayer {
    DrawingLayer { name: name.into(), look, lines_mm }
}

/// Patterns on the outline of the active flank, whose ends along the tooth have these names.
fn on_flank(
    developed: &Developed,
    title: String,
    [first, last]: [&str; 2],
    patterns: Vec<DrawingLayer>,
    pattern: Option<&PatternResult>,
) -> Drawing {
    let [root, tip] = developed.root_and_tip();
    let [toe, heel] = developed.toe_and_heel();
    let outline = root.iter().chain(tip.iter().rev()).copied().collect();
    let middle = |row: &[[f64; 2]]| row.get(row.len() / 2).copied().unwrap_or_default();
    let mut notes: Vec<DrawingNote> =
        [(middle(root), "root"), (middle(tip), "tip"), (toe, first), (heel, last)]
            .map(|(at_mm, text)| DrawingNote { at_mm, text: text.into() })
            .into();
    let centre = pattern.map(|pattern| developed.centre(pattern));
    notes.extend(centre.map(|at_mm| DrawingNote { at_mm, text: "centre".into() }));
    let mut layers = vec![layer("active flank", DrawingLook::Body, vec![outline])];
    layers.extend(patterns);
    Drawing {
        title,
        subtitle: "the flank of a space, developed, seen from outside the material".into(),
        axes: Some([
            format!("along the tooth, {first} to {last} [mm]"),
            "up the profile, root to tip [mm]".into(),
        ]),
        layers,
        notes,
    }
}
