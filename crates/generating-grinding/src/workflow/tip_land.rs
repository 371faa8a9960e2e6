//! Whether the dresser clears the opposite flank while it dresses, and how wide its tip land may be
//! (`docs/mathematics/planning.md#choice-of-the-ratio`, `docs/mathematics/dressing.md#limits-of-a-correction`).

use super::executed_strokes::ExecutedStrokes;
use super::execution::Execution;
use super::prepare::Prepared;
use crate::workflow::generating_finding;
use dressing::{SectionOutline, SectionPart};
use foundation::geometry::{Flank, Sides};
use generating::{GeneratingError, GrindingSetup, LeastRoom};
use report::charts::{
    DressingSectionChart, MarkedClearance, SectionKind, SectionStretch, SpaceFlank, format_significant,
};
use run::RunFailure;
use verdict::Remark;

/// The largest tip lands by flank, mm: absent where no flank is dressed alone.
pub struct TipLands {
    /// The widest tip land of the dresser that stays clear, mm.
    pub largest: Sides<Option<f64>>,
    /// The dresser in the thread space where it has least room.
    pub pictures: Vec<DressingSectionChart>,
    /// Remarks.
    pub warnings: Vec<Remark>,
}

impl TipLands {
    /// Of a process with all its settings. A plan whose dresser cuts into the opposite flank is refused; of given settings it is
    /// said.
    ///
    /// # Errors
    /// [`GeneratingError::CounterFlankCut`] for a plan.
    pub fn of_execution(
        prepared: &Prepared,
        execution: &Execution,
        planned: bool,
    ) -> Result<Self, RunFailure> {
        let mut found =
            Self { largest: Sides { left: None, right: None }, pictures: Vec::new(), warnings: Vec::new() };
        // Both flanks at once: the flank across the space is dressed as well.
        let (Some(dresser), false) = (&execution.dresser, prepared.dressing.two_flanks) else {
            return Ok(found);
        };
        let given = prepared.dressing.tip_land;
        let threads = prepared.setup.pair.worm.data().teeth.unsigned_abs();
        let left_out = prepared.cycle.strokes.as_ref().map_or(0, |strokes| strokes.left_out(threads));
        for flank in Flank::BOTH {
            let Some(executed) = &execution.flanks[flank] else { continue };
            if let Some(strokes) = executed.strokes() {
                found.of_strokes(&prepared.setup, strokes, flank, given, left_out);
                continue;
            }
            let (Some(dressing), Some(choice)) = (executed.dressing(), &prepared.setup.input.dresser) else {
                continue;
            };
            let tip_radius = 0.5 * choice.tip_diameter;
            let room = LeastRoom::of_motion(dresser, tip_radius, flank, &dressing.corrections, left_out);
            let room = match room {
                Ok(room) => room,
                Err(error) => {
                    found.warnings.push(Remark {
                        code: "tip-land-unknown",
                        text: format!("the clearance of the {} flank is not known: {error}", flank.other()),
                        way_out: error.way_out().into(),
                    });
                    continue;
                }
            };
            found.largest[flank] = room.tip_land;
            if room.tip_land.is_none_or(|largest| given.is_some_and(|land| land > largest)) {
                let cut = GeneratingError::CounterFlankCut { flank, land: given, largest: room.tip_land };
                if planned {
                    return Err(generating_finding::on_field(&cut, "dresser.tip_land"));
                }
                found.warnings.push(Remark {
                    code: cut.code(),
                    text: cut.to_string(),
                    way_out: cut.way_out().into(),
                });
            }
            let land = given.or(room.tip_land).unwrap_or(0.0);
            // A section that cannot be drawn takes nothing from the figures.
            if let Ok(outline) = room.outline(&prepared.setup, (dresser, tip_radius), flank, land, left_out) {
                found.pictures.push(picture(&outline, flank, land));
            }
        }
        Ok(found)
    }

    /// The same for a flank that is dressed in strokes. A dresser may stand back outside its active areas, which no job describes: what
    /// is found for a whole one is reported and not decided upon.
    fn of_strokes(
        &mut self,
        setup: &GrindingSetup,
        strokes: &ExecutedStrokes,
        flank: Flank,
        given: Option<f64>,
        left_out: u32,
    ) {
        let Some(layout) = &setup.strokes else { return };
        let mut least: Option<f64> = None;
        for (k, stroke) in strokes.strokes.iter().enumerate() {
            let number = stroke.place.dresser;
            let (Some(tool), Some(&tip)) = (layout.dressers.get(number), layout.tip_radii.get(number)) else {
                continue;
            };
            let room = LeastRoom::of_motion(tool, tip, flank, &stroke.corrections, left_out);
            // The tip land of the job is that of its first dresser.
            let land = given.filter(|_| number == 0);
            match room {
                Ok(LeastRoom { tip_land: Some(here), .. }) if land.is_none_or(|land| land <= here) => {
                    least = Some(least.map_or(here, |land| land.min(here)));
                }
                Ok(LeastRoom { tip_land, .. }) => {
                    let cut = GeneratingError::CounterFlankCut { flank, land, largest: tip_land };
                    self.warnings.push(Remark {
                        code: cut.code(),
                        text: format!("stroke {}: {cut}", k + 1),
                        way_out: "let the dresser stand back there, or leave out threads of the worm".into(),
                    });
                }
                Err(error) => self.warnings.push(Remark {
                    code: "tip-land-unknown",
                    text: format!(
                        "stroke {}: the clearance of the {} flank is not known: {error}",
                        k + 1,
                        flank.other()
                    ),
                    way_out: error.way_out().into(),
                }),
            }
        }
        self.largest[flank] = least;
    }
}

/// The picture of a section: the dresser dresses `flank` with a tip land, mm.
fn picture(outline: &SectionOutline, flank: Flank, land: f64) -> DressingSectionChart {
    let space = |side: Flank| SpaceFlank {
        name: format!("{side} flank{}", if side == flank { ", dressed" } else { "" }),
        line_mm: outline.space[side].clone(),
        used_radius_mm: outline.used_radii[side],
        clearance: outline.closest[side].filter(|_| side != flank).map(|(at, [dresser, worm])| {
            MarkedClearance {
                normal_mm: at.f,
                dresser_mm: dresser,
                flank_mm: worm,
                dresser_radius_mm: at.circle[0],
            }
        }),
    };
    let mut flanks = [space(Flank::Left), space(Flank::Right)];
    let first = |flank: &SpaceFlank| flank.line_mm.first().map_or(0.0, |point| point[0]);
    if first(&flanks[0]) > first(&flanks[1]) {
        flanks.reverse();
    }
    let kind = |part: &SectionPart| match part {
        SectionPart::ActiveFlank => SectionKind::ActiveFlank,
        SectionPart::TipLand => SectionKind::TipLand,
        SectionPart::CounterFlank => SectionKind::CounterFlank,
    };
    DressingSectionChart {
        title: format!("Dressing the {flank} flank: section through the thread space"),
        subtitle: format!("where there is least room; tip land {} mm", format_significant(land, 4)),
        flanks,
        dresser: outline
            .dresser
            .iter()
            .map(|(part, line)| SectionStretch { kind: kind(part), line_mm: line.clone() })
            .collect(),
    }
}
