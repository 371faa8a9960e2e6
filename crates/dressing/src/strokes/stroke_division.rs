//! Division of the worm's profile into strokes by the active areas of dressers (`docs/mathematics/dressing.md#conditions`, figure 20 of its
//! source). Knows no corrections.

use crate::strokes::stroke::check_range;
use crate::{ActiveArea, DresserTool, DressingError, Stroke, WidthLaw};
use foundation::geometry::Flank;

/// A section of the worm's profile that one active area dresses in as many strokes as it takes; its ends are numbers, or laws where they move.
#[derive(Clone, Copy, Debug)]
pub struct StrokeSection<'a, End> {
    /// The dresser, in nominal kinematics on the worm.
    pub tool: &'a DresserTool,
    /// What of it cuts.
    pub area: ActiveArea,
    /// Lengths of roll of the section, mm.
    pub range: [End; 2],
}

/// A section that is the same over the face.
pub type ProfileSection<'a> = StrokeSection<'a, f64>;

/// A section whose ends move.
pub type MovingSection<'a> = StrokeSection<'a, WidthLaw>;

/// Most strokes of a section; more are a mistake in the units.
const MOST: usize = 1000;

/// How far the laws of sections are looked at, in q: contacts go a little beyond the face.
const REACH: f64 = 1.05;

/// Strokes for the sections of a profile, each with the number of its section from 0. Sections are given in ascending order of w and
/// without room between them. The strokes of a section are
/// as long as the active part (on the worm in use) and lie evenly; neighbours overlap by at least `overlap` (mm). One stroke that is longer than its
/// section may reach beyond the profile at its first or last end, where the gear does not touch the worm, but not into another section.
///
/// # Errors
/// [`DressingError::InvalidNumber`] without sections, for ranges that do not follow each other, an overlap below 0 or as long as an
/// active part, and an active part that is longer than a section between two others.
pub fn divide<'a>(
    sections: &[ProfileSection<'a>],
    flank: Flank,
    overlap: f64,
) -> Result<Vec<(usize, Stroke<'a>)>, DressingError> {
    let moving = |section: &ProfileSection<'a>| MovingSection {
        tool: section.tool,
        area: section.area,
        range: section.range.map(WidthLaw::constant),
    };
    let still = |(k, range): (usize, [WidthLaw; 2])| {
        let range = range.map(|law| law.value(0.0));
        (k, Stroke { tool: sections[k].tool, area: sections[k].area, range })
    };
    let moving: Vec<_> = sections.iter().map(moving).collect();
    Ok(divide_moving(&moving, flank, overlap)?.into_iter().map(still).collect())
}

/// The same for sections whose ends move: ranges of the strokes as laws, each with the number of its section from 0. A section takes as
/// many strokes as where it is widest.
///
/// # Errors
/// As [`divide`]; a section that takes several strokes is nowhere shorter than its active part.
pub fn divide_moving(
    sections: &[MovingSection<'_>],
    flank: Flank,
    overlap: f64,
) -> Result<Vec<(usize, [WidthLaw; 2])>, DressingError> {
    let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
    if sections.is_empty() {
        return invalid("number of sections", 0.0, "at least 1");
    }
    if !(overlap.is_finite() && overlap >= 0.0) {
        return invalid("overlap of strokes", overlap, "a finite length from 0 on");
    }
    let mut strokes = Vec::new();
    for (k, section) in sections.iter().enumerate() {
        let [from, to] = section.range;
        let width = to + from.times(-1.0);
        check_range([from.extremes(REACH)[0], to.extremes(REACH)[1]])?;
        let [narrowest, widest] = width.extremes(REACH);
        if narrowest <= 0.0 {
            return invalid("end w_b of a range of the worm", narrowest, "a finite length of roll above w_a");
        }
        if k > 0 && gap_before(sections, k) > 1e-9 {
            return invalid("start of a section", from.value(0.0), "the end of the section before it");
        }
        let part = section.area.part();
        let dresser = &section.tool.flanks[flank];
        let length = (part[1] - part[0]) * (dresser.range.length() / dresser.designed.length());
        if overlap >= length {
            return invalid("overlap of strokes", overlap, "below the length of the active part");
        }
        let (first, last) = (k == 0, k + 1 == sections.len());
        // Where the strokes begin: from + share (width - length).
        let shares = if widest <= length {
            // What the stroke is too long by lies beyond the profile.
            match (first, last) {
                (true, true) => vec![0.5],
                (true, false) => vec![1.0],
                (false, true) => vec![0.0],
                (false, false) if length - narrowest <= 1e-9 => vec![0.0],
                (false, false) => {
                    return invalid(
                        "length of the active part",
                        length,
                        "up to the length of a section between two others",
                    );
                }
            }
        } else if narrowest < length {
            return invalid(
                "length of the active part",
                length,
                "up to the shortest length of a section that it dresses in several strokes",
            );
        } else {
            let count = ((widest - overlap) / (length - overlap) - 1e-12).ceil();
            if count > MOST as f64 {
                return invalid("length of the active part", length, "a thousandth of the section at least");
            }
            (0..count as usize).map(|i| i as f64 / (count - 1.0)).collect()
        };
        for share in shares {
            let less = WidthLaw::constant(-length);
            // The last stroke meets the end of the section exactly.
            let start = if share == 1.0 { to + less } else { from + (width + less).times(share) };
            let end = if share == 1.0 { to } else { start + WidthLaw::constant(length) };
            check_range([start.extremes(REACH)[0], end.extremes(REACH)[1]])?;
            strokes.push((k, [start, end]));
        }
    }
    Ok(strokes)
}

/// Largest distance of a section's start from the end of the section before it, mm.
fn gap_before(sections: &[MovingSection<'_>], k: usize) -> f64 {
    let [low, high] = (sections[k].range[0] + sections[k - 1].range[1].times(-1.0)).extremes(REACH);
    low.abs().max(high.abs())
}
