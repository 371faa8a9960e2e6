//! How the cutters touch: contact heights and leans that their shapes allow, and what root and roughing need.

use super::exactly_one;
use crate::job::{ContactHeight, CutterForm, CutterUse, MilledRoot, MillingJob};
use job::checks::contradiction;
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    tilt(job, findings);
    heights(job, findings);
    if let Some(given) = &job.milling.root {
        root(job, given, findings);
    }
    if let Some(given) = &job.milling.roughing {
        let (cutter, _) = job.cutter_for(CutterUse::Roughing);
        if given.step_over > cutter.diameter {
            findings.push(contradiction(
                "passes of roughing lie further apart than the cutter is wide",
                "milling.roughing.step_over",
                shown_number(given.step_over),
                &format!("<= {}, the diameter of the cutter that clears", shown_number(cutter.diameter)),
                "give a smaller distance, e.g. half of the diameter",
            ));
        }
    }
}

/// A straight side touches along its length; leant away from it, a rounded corner has to touch.
fn tilt(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let (milling, cutter) = (&job.milling, &job.cutter);
    let straight = matches!(cutter.shape, CutterForm::EndMill | CutterForm::Torus | CutterForm::Cone);
    if !milling.leans() || !straight {
        return;
    }
    let keys = ["milling.tilt_deg", "milling.tilt_at_tip_deg"];
    let tilts = milling.tilts_deg();
    let mut refuse = |row: usize, message: &str, allowed: &str, way_out: &str| {
        findings.push(contradiction(message, keys[row], shown_number(tilts[row]), allowed, way_out));
    };
    if cutter.corner_radius() == 0.0 {
        refuse(
            usize::from(tilts[0] == 0.0),
            "a cutter with a sharp corner touches with its straight side only, which takes no tilt",
            "0, or a cutter with a corner radius, a ball or a barrel",
            "leave `tilt_deg` out, or give `cutter.corner_radius`",
        );
    } else if let Some(row) = tilts.iter().position(|tilt| *tilt < 0.0 && cutter.has_side()) {
        refuse(
            row,
            "a shank that leans towards the flank cuts it with the upper end of its edges",
            ">= 0, or a ball or a barrel",
            "give a tilt away from the flank, > 0",
        );
    } else if tilts.contains(&0.0) && cutter.has_side() {
        refuse(
            1,
            "with rows that lean differently a rounded corner touches in all of them, which an upright one does not",
            "no key, or > 0 with `tilt_deg` > 0 as well, or a ball or a barrel",
            "give a tilt > 0 to both ends, or leave `tilt_at_tip_deg` out",
        );
    }
}

fn heights(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let (cutter, milling) = (&job.cutter, &job.milling);
    const FIELD: &str = "milling.contact_height";
    let side = cutter.has_side() && !milling.leans();
    let (from, to) = (cutter.side_from(), cutter.cutting_length);
    let range = format!("from {} to {}", shown_number(from), shown_number(to));
    match (&milling.contact_height, side) {
        (None, true) => findings.push(
            Diagnostic::new(
                Problem::MissingKey,
                "the straight side of the cutter touches at a height that is not given",
            )
            .field(FIELD)
            .allowed(format!("a number, {{ from, to }} or a list of numbers, {range} mm above the tip"))
            .way_out("add `contact_height = ...`"),
        ),
        (Some(given), false) => {
            let value = match given {
                ContactHeight::Fixed(height) => shown_number(*height),
                ContactHeight::Ramp(_) => "a table".to_owned(),
                ContactHeight::Rows(heights) => format!("a list of {}", heights.len()),
            };
            findings.push(contradiction(
                "where a ball, a barrel or a tilted cutter touches follows from its axis",
                FIELD,
                value,
                "no key, or an end mill, torus or cone without tilt",
                "leave `contact_height` out",
            ));
        }
        (Some(given), true) => {
            for (key, height) in given.given() {
                if !(from..=to).contains(&height) {
                    let part = if height < from { "the rounded corner" } else { "the end of the edges" };
                    findings.push(contradiction(
                        &format!("the contact height {height} lies beyond the straight side, at {part}"),
                        format!("{FIELD}{key}"),
                        shown_number(height),
                        &format!("{range}: from the corner to the cutting length"),
                        "give a height at which the straight side cuts",
                    ));
                    // Of a long list the first wrong one says enough.
                    break;
                }
            }
            if let ContactHeight::Rows(heights) = given {
                list(heights.len(), milling.rows, findings);
            }
        }
        (None, false) => {}
    }
}

fn list(given: usize, rows: Option<usize>, findings: &mut Vec<Diagnostic>) {
    let allowed = match rows {
        Some(rows) if rows == given => return,
        Some(rows) => format!("{rows} heights, one for each row"),
        None => "a number or { from, to } where the number of rows follows from limits".to_owned(),
    };
    let message = match rows {
        Some(rows) => format!("{given} contact heights for {rows} rows"),
        None => "a contact height for each row, and the number of rows is not given".to_owned(),
    };
    findings.push(
        Diagnostic::new(Problem::InvalidList, message)
            .field("milling.contact_height")
            .value(format!("{given} entries"))
            .allowed(allowed)
            .way_out("give as many heights as rows, or { from, to }"),
    );
}

fn root(job: &MillingJob, root: &MilledRoot, findings: &mut Vec<Diagnostic>) {
    exactly_one(
        "milling.root",
        &[("bottom", root.bottom.is_some()), ("straight", root.straight.is_some())],
        "`milling.root` does not say how deep the root is",
        "add `bottom = 0.0` for a bottom on the root body",
        findings,
    );
    if let Some(gear) = job.gear.as_ref().filter(|gear| gear.drawing.teeth < 0) {
        findings.push(contradiction(
            "a straight side along the hollow flank of an internal gear digs in with both of its ends, so that only balls, barrels and \
             tilted corners finish it; the root is drawn by the corner of a cutter that stands along the flank with its straight side",
            "milling.root",
            format!("a table beside gear.teeth = {}", gear.drawing.teeth),
            "no table with an internal gear",
            "leave [milling.root] out, and cut the root before, by shaping or broaching, or take it as it comes",
        ));
        return;
    }
    let upright =
        matches!(job.cutter.shape, CutterForm::EndMill | CutterForm::Torus) && job.cutter.has_side();
    if !upright || job.milling.leans() {
        let tilted = if job.milling.leans() { ", tilted" } else { "" };
        findings.push(contradiction(
            "the root below the active flank is left by the corner of a cylindrical cutter that stands along the flank",
            "milling.root",
            format!("beside cutter.shape = \"{}\"{tilted}", job.cutter.shape.name()),
            "no table, or cutter.shape = \"end-mill\" or \"torus\" without tilt",
            "leave [milling.root] out, or take an end mill",
        ));
        return;
    }
    let (bottom, corner) = (job.bottom_cutter.as_ref(), job.cutter.corner_radius());
    if let Some(cutter) = bottom.filter(|_| root.bottom_pass)
        && (cutter.corner_radius() - corner).abs() > 1e-9
    {
        findings.push(contradiction(
            "the bottom would not join the fillets: both cutters need the same corner",
            "bottom_cutter.corner_radius",
            shown_number(cutter.corner_radius()),
            &format!("{}, that of [cutter]", shown_number(corner)),
            "take a thinner cutter with the same corner radius",
        ));
    }
}
