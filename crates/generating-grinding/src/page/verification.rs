//! How the result was verified: the two calculations, the stages of the referee, and what samples of rays saw.

use crate::workflow::referee::Verdict;
use crate::workflow::run::Outcome;
use foundation::geometry::Flank;
use report::charts::format_significant;
use report::{Block, Column, Table};

/// Why planned and simulated flank may be compared.
const TWO_CALCULATIONS: [&str; 2] = [
    "The planned flank is the exact contact of the worm as dressed with the workpiece, solved point by point.",
    "The simulated flank comes from a second calculation that shares no formula with the first: normal rays of the worm are \
     shortened by the dresser over the real dressing motion, a smooth surface through their ends is the worm, and normal rays of \
     the workpiece are shortened by that worm over the real grinding motion. Only the shapes, the chain of axes and the motions are \
     common to both; the plan only tells on which part of the worm the rays stand.",
];

/// One stage of the referee.
pub struct RefereeStage {
    name: String,
    rays: u64,
    poses: u64,
    error_um: f64,
}

/// The stages behind a verdict.
pub fn referee_stages(flank: Flank, verdict: &Verdict) -> Vec<RefereeStage> {
    let dressing = verdict.dressing.iter().map(|stage| ("dresser against worm", stage));
    dressing
        .chain([("worm against workpiece", &verdict.grinding)])
        .map(|(name, stage)| RefereeStage {
            name: format!("{flank} flank: {name}"),
            rays: stage.statistics.rays,
            poses: stage.statistics.poses,
            error_um: stage.error_um,
        })
        .collect()
}

/// The section, with what a process says beside the two calculations.
pub fn verification_blocks(more: impl IntoIterator<Item = String>, stages: &[RefereeStage]) -> Vec<Block> {
    let paragraphs = TWO_CALCULATIONS.map(String::from).into_iter().chain(more);
    let mut blocks: Vec<Block> = paragraphs.map(Block::Paragraph).collect();
    if !stages.is_empty() {
        let row = |s: &RefereeStage| {
            vec![s.name.clone(), grouped(s.rays), grouped(s.poses), format_significant(s.error_um, 2)]
        };
        blocks.push(Block::Table(Table {
            caption: "Material removal by normal rays (referee)".to_owned(),
            columns: vec![
                Column::text("Stage"),
                Column::number("Rays", ""),
                Column::number("Poses", "per ray"),
                Column::number("Own discretisation error", "µm"),
            ],
            rows: stages.iter().map(row).collect(),
            note: String::new(),
        }));
    }
    blocks
}

/// Digits in groups of three with narrow blanks.
fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// Own error of the rays against lines: the splines of the motions hold 1e-6 mm.
const LINE_STAGE_ERROR_UM: f64 = 1e-3;

/// The section of a run.
pub(super) fn verification(outcome: &Outcome) -> Vec<Block> {
    let mut stages = Vec::new();
    for (flank, verdict) in outcome.verdicts.iter() {
        let Some(v) = verdict else { continue };
        if let Some(written) = &outcome.written[flank] {
            stages.push(RefereeStage {
                name: format!("{flank} flank: disc on its lines against worm, a sample"),
                rays: written.statistics.rays,
                poses: written.statistics.poses,
                error_um: LINE_STAGE_ERROR_UM,
            });
        }
        stages.extend(referee_stages(flank, v));
    }
    verification_blocks(feed_marks(outcome).into_iter().chain(line_sample(outcome)), &stages)
}

fn feed_marks(outcome: &Outcome) -> Option<String> {
    let heights: Vec<String> = outcome
        .result
        .flanks
        .iter()
        .filter_map(|(flank, f)| Some(format!("{flank} flank {} um", format_significant(f.feed_mark_um?, 2))))
        .collect();
    (!heights.is_empty()).then(|| {
        format!(
            "The simulated flank is the envelope, as an endlessly slow feed leaves it. At the feed of the job the marks stand \
             above it by up to: {}.",
            heights.join(", ")
        )
    })
}

fn line_sample(outcome: &Outcome) -> Option<String> {
    let seen: Vec<String> = outcome
        .result
        .flanks
        .iter()
        .filter_map(|(flank, f)| {
            let lines = f.line_dressing.as_ref()?;
            let um = |x| format_significant(x, 2);
            let (over, under) = (um(lines.simulated_scallop_um), um(lines.simulated_undercut_um));
            Some(format!("{flank} flank {over} um above and {under} um below"))
        })
        .collect();
    (!seen.is_empty()).then(|| {
        format!(
            "The worm is written line by line. The flank above is ground by the wanted worm; what the lines leave of it was seen by \
             normal rays of the worm, a sample of them, shortened by the rounded disc on all its lines: {} the wanted worm \
             flank at most.",
            seen.join(", ")
        )
    })
}
