//! Division of the worm's profile into strokes by the active areas of dressers (`docs/mathematics/dressing.md#conditions`, figure 20 of its
//! source). Knows no corrections.

use crate::strokes::stroke::check_range;
use crate::{ActiveArea, DresserTool, DressingError, Stroke};
use foundation::geometry::Flank;

/// A section of the worm's profile that one active area dresses in as many strokes as it takes.
#[derive(Clone, Copy, Debug)]
pub struct ProfileSection<'a> {
    /// The dresser, in nominal kinematics on the worm.
    pub tool: &'a DresserTool,
    /// What of it cuts.
    pub area: ActiveArea,
    /// Lengths of roll of the section, mm.
    pub range: [f64; 2],
}

/// Most strokes of a section; more are a mistake in the units.
const MOST: usize = 1000;

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
        check_range(section.range)?;
        if k > 0 && (from - sections[k - 1].range[1]).abs() > 1e-9 {
            return invalid("start of a section", from, "the end of the section before it");
        }
        let part = section.area.part();
        let dresser = &section.tool.flanks[flank];
        let length = (part[1] - part[0]) * (dresser.range.length() / dresser.designed.length());
        if overlap >= length {
            return invalid("overlap of strokes", overlap, "below the length of the active part");
        }
        let width = to - from;
        let (first, last) = (k == 0, k + 1 == sections.len());
        if width <= length {
            // What the stroke is too long by lies beyond the profile.
            let start = match (first, last) {
                (true, true) => from - 0.5 * (length - width),
                (true, false) => to - length,
                (false, true) => from,
                (false, false) if length - width <= 1e-9 => from,
                (false, false) => {
                    return invalid(
                        "length of the active part",
                        length,
                        "up to the length of a section between two others",
                    );
                }
            };
            let range = [start, start + length];
            check_range(range)?;
            strokes.push((k, Stroke { tool: section.tool, area: section.area, range }));
            continue;
        }
        let count = ((width - overlap) / (length - overlap) - 1e-12).ceil();
        if count > MOST as f64 {
            return invalid("length of the active part", length, "a thousandth of the section at least");
        }
        let step = (width - length) / (count - 1.0);
        for i in 0..count as usize {
            // The last stroke meets the end of the section exactly.
            let end = if i + 1 == count as usize { to } else { from + step * i as f64 + length };
            let range = [end - length, end];
            strokes.push((k, Stroke { tool: section.tool, area: section.area, range }));
        }
    }
    Ok(strokes)
}
