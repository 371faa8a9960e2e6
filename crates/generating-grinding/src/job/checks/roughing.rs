//! What strokes ask of the areas of the worm that are kept for roughing.

use crate::job::{Job, Method, StrokeOfJob, Technology, Tool};
use foundation::geometry::Flank;
use job::{Diagnostic, Problem, shown_number};

/// What a stroke asks of its roughing area: strokes that share an area ask for the same.
pub(super) fn area_of_stroke(
    job: &Job,
    technology: &Technology,
    (k, finishes): (usize, bool),
    findings: &mut Vec<Diagnostic>,
) {
    let this = &technology.strokes[k];
    let areas = job.grinding.roughing_areas as usize;
    let field = format!("technology.strokes[{k}].modification_share");
    let ratio = |stroke: &StrokeOfJob| {
        stroke.shift.and_then(|shift| shift.ratio).unwrap_or(job.grinding.roughing_ratio.unwrap_or(0.0))
    };
    if let Some(share) = this.modification_share {
        let why = if finishes {
            Some(("a stroke that leaves nothing makes the whole modification", "leave it out"))
        } else if areas == 0 {
            Some((
                "without an area of its own a stroke that leaves stock uses the worm of the finishing stroke, modification and all",
                "give grinding.roughing_areas, or leave the share out",
            ))
        } else if job.dressing.strokes.is_some()
            || job.worm.tool != Tool::Dressed
            || job.point_dresser().is_some()
        {
            Some((
                "roughing areas get a modification of their own from a disc that dresses the worm in one stroke of each flank",
                "describe such a disc in [dresser], or leave the share out",
            ))
        } else if share != 0.0 && ratio(this) == 0.0 && job.grinding.method == Method::Diagonal {
            Some((
                "without a shift all of the face is ground by the same line of the worm, which has one modification",
                "give the stroke a shift.ratio, or grinding.roughing_ratio, or leave the share out",
            ))
        } else {
            None
        };
        if let Some((text, way_out)) = why {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, text)
                    .field(field.clone())
                    .value(shown_number(share))
                    .allowed("nothing for this stroke")
                    .way_out(way_out),
            );
        }
    }
    if finishes || areas == 0 {
        return;
    }
    let leaves = |stroke: &StrokeOfJob| Flank::BOTH.iter().any(|&f| stroke.left_um.sides()[f] != 0.0);
    let roughing: Vec<usize> =
        (0..technology.strokes.len()).filter(|&j| leaves(&technology.strokes[j])).collect();
    let Some(number) = roughing.iter().position(|&j| j == k).filter(|&number| number >= areas) else {
        return;
    };
    let first = &technology.strokes[roughing[number % areas]];
    let same = (first.modification_share, ratio(first)) == (this.modification_share, ratio(this));
    if !same {
        let text = format!(
            "stroke {} uses the roughing area of stroke {}, which is another one",
            k + 1,
            roughing[number % areas] + 1
        );
        findings.push(
            Diagnostic::new(Problem::InvalidJob, text)
                .field(field)
                .value(this.modification_share.map_or("none".into(), shown_number))
                .allowed("the same share and shift.ratio for all strokes of an area")
                .way_out(format!("give an area to each stroke that leaves stock (grinding.roughing_areas = {}), or the same values", roughing.len())),
        );
    }
}
