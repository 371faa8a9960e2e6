//! The contact pattern on the developed flank.

use super::developed::Developed;
use super::shown::ShownContact;
use report::charts::{ChartError, Drawing, DrawingLayer, DrawingLook, DrawingNote};

/// The flank with the pattern that was rolled and the one that both ease-offs say.
pub(super) fn drawn(flank: &ShownContact<'_>, marking_um: f64) -> Result<Drawing, ChartError> {
    let developed = Developed::new(flank.rolled);
    let [rolled, said] = &flank.rolled.gaps;
    let [root, tip] = developed.root_and_tip();
    let [toe, heel] = developed.toe_and_heel();
    let outline = root.iter().chain(tip.iter().rev()).copied().collect();
    let middle = |row: &[[f64; 2]]| row.get(row.len() / 2).copied().unwrap_or_default();
    let mut notes: Vec<DrawingNote> =
        [(middle(root), "root"), (middle(tip), "tip"), (toe, "toe"), (heel, "heel")]
            .map(|(at_mm, text)| DrawingNote { at_mm, text: text.into() })
            .into();
    let centre = flank.result.rolled.map(|pattern| developed.centre(&pattern));
    notes.extend(centre.map(|at_mm| DrawingNote { at_mm, text: "centre".into() }));
    let layer = |name: &str, look, lines_mm| DrawingLayer { name: name.into(), look, lines_mm };
    Ok(Drawing {
        title: format!("{}: contact pattern", flank.name()),
        subtitle: "the flank of a space, developed, seen from outside the material".into(),
        axes: Some(["along the tooth, toe to heel [mm]".into(), "up the profile, root to tip [mm]".into()]),
        layers: vec![
            layer("active flank", DrawingLook::Body, vec![outline]),
            layer("rolled", DrawingLook::Material, developed.loops(&rolled.gaps, marking_um)?),
            layer("by the ease-offs", DrawingLook::OtherEdge, developed.loops(&said.gaps, marking_um)?),
        ],
        notes,
    })
}
