//! Programs: what was proven of them, what the axes do in them, how long they take. Programs with the same kind of tip control are
//! described once.

mod axes;
mod cycle_times;
mod shown_motion;

use crate::workflow::{MillingOutcome, ProgramResult};
use report::Block;
use report::charts::{ChartError, format_significant};
use shown_motion::ShownMotion;

/// Proof, remarks, tables of times, charts of the axes; nothing without programs.
pub(super) fn blocks(outcome: &MillingOutcome) -> Result<Vec<Block>, ChartError> {
    let (Some(programs), Some(machine)) = (&outcome.texts.programs, &outcome.prepared.machine) else {
        return Ok(Vec::new());
    };
    let results = &outcome.result.programs;
    let motions = ShownMotion::of_programs(&programs.programs, results);
    let Some(first) = motions.first() else { return Ok(Vec::new()) };
    let mut blocks: Vec<Block> = results.iter().map(|result| Block::Paragraph(proof(result))).collect();
    blocks.extend(remarks(&motions).into_iter().map(Block::Paragraph));
    blocks.extend(motions.iter().map(|shown| Block::Table(cycle_times::table(shown))));
    blocks.extend(axes::figures(&machine.machine, first)?.into_iter().map(Block::Figure));
    Ok(blocks)
}

fn proof(result: &ProgramResult) -> String {
    let um = |x: f64| format_significant(x, 3);
    format!(
        "{}: {} blocks. Read back by a reader that shares no code with the writer and milled again by rays, the text leaves the \
         planned flanks of the first space within {} µm; digits and straight blocks explain up to {} µm. The whole part: {}; {}.",
        result.file,
        result.blocks,
        um(result.proof_difference_um),
        um(result.proof_allowed_um),
        result.part.statement,
        match result.part.faults.len() {
            0 => "nothing is wrong".to_owned(),
            count => format!("{count} faults"),
        }
    )
}

/// What the axes do: what holds for all motions is given once, without names.
fn remarks(motions: &[ShownMotion<'_>]) -> Vec<String> {
    let common = |remark: &&String| motions.iter().all(|shown| shown.result.remarks.contains(remark));
    let first = motions.first().map(|shown| &shown.result.remarks);
    let mut remarks: Vec<String> = first.into_iter().flatten().filter(common).cloned().collect();
    for shown in motions {
        let own = shown.result.remarks.iter().filter(|remark| !common(remark));
        remarks.extend(own.map(|remark| format!("{}: {remark}", shown.controls)));
    }
    remarks
}
