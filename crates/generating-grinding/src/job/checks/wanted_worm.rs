//! Contradictions of a job that wants a worm topography: the gear follows from it, so that nothing else may ask for a gear.

use crate::job::{DiagonalRatio, DressingFlanks, Fit, Gauge, Job, Method, ProfileCrowningBy};
use job::{Diagnostic, Problem};

/// What the gear follows from.
const WAY_OUT: &str = "leave the key out: the gear follows from worm.modifications";

pub(super) fn check(job: &Job, findings: &mut Vec<Diagnostic>) {
    let (target, dressing, grinding) = (&job.target, &job.dressing, &job.grinding);
    let given = [
        ("target.modifications", target.modifications.is_some()),
        ("target.file", target.file.is_some()),
        ("target.fit", target.fit != Fit::default()),
        ("compensation", job.compensation.is_some()),
        ("explore", job.explore.is_some()),
        ("inspection", job.inspection.is_some()),
        ("dressing.strokes", dressing.strokes.is_some()),
        ("dressing.flanks", dressing.flanks == DressingFlanks::Two),
        ("dressing.profile_crowning_by", dressing.profile_crowning_by != ProfileCrowningBy::Auto),
        ("grinding.gauge", grinding.gauge != Gauge::default()),
        ("grinding.prefer", grinding.prefer.is_some()),
        ("grinding.precompensation", grinding.precompensation.is_some()),
        ("grinding.try_changes", grinding.try_changes.is_some()),
    ];
    for (field, _) in given.into_iter().filter(|(_, given)| *given) {
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                "a job that wants a worm topography plans no gear, and this key has no meaning there",
            )
            .field(field)
            .value("given")
            .allowed("no key beside worm.modifications of a dressed worm")
            .way_out(WAY_OUT),
        );
    }
    let number = matches!(grinding.diagonal_ratio, Some(DiagonalRatio::Number(_)));
    if grinding.method == Method::Diagonal && !number {
        findings.push(
            Diagnostic::new(
                Problem::MissingKey,
                "which gear follows from a worm depends on how it is shifted; a ratio is chosen for targets of the gear only",
            )
            .field("grinding.diagonal_ratio")
            .allowed("a number beside worm.modifications, or method = \"radial\"")
            .way_out("give the ratio, e.g. diagonal_ratio = -1.2"),
        );
    }
}
