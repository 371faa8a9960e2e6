//! How the drawing judges a flank: everywhere alike, or on traces with a wider band beside them. Both are a map of the tolerance.

use super::targets::{is_ground, tolerance_of_job};
use crate::job::{Judged, LoadedJob};
use foundation::geometry::Flank;
use foundation::modification::{EvaluationField, ToleranceMap};
use generating::GrindingSetup;
use job::{Diagnostic, Problem, shown_number};
use run::modification_finding;

/// Band beside the traces where the job gives none, in tolerances.
const BESIDE: f64 = 3.0;
/// Width of the step from a trace to the band beside it, as a share of the evaluated length.
const STEP: f64 = 1e-6;
/// Ranges of both flanks that differ by less are one, mm.
const SAME: f64 = 1e-9;

/// Where the traces of a flank stand that a drawing states values for.
#[derive(Clone, Debug, PartialEq)]
pub struct TracePlaces {
    /// Lengths of roll of the helix traces, mm.
    pub helix_w: Vec<f64>,
    /// Face positions of the profile traces, mm.
    pub profile_z: Vec<f64>,
}

impl TracePlaces {
    /// Of a flank: those of `target.traces`, else its middles.
    pub(super) fn of_job(loaded: &LoadedJob, field: &EvaluationField) -> Self {
        let given = loaded.job.target.traces.clone().unwrap_or_default();
        let ascending = |places: Option<Vec<f64>>, middle: f64| {
            let mut places = places.unwrap_or_else(|| vec![middle]);
            places.sort_by(f64::total_cmp);
            places.dedup();
            places
        };
        Self {
            helix_w: ascending(given.helix_w_mm, field.roll_middle()),
            profile_z: ascending(given.profile_z_mm, field.face_middle()),
        }
    }
}

/// The tolerance over the flanks of a job, and in words where it holds, if that is not everywhere.
///
/// # Errors
/// A finding on `target.tolerance_map` or `target.traces`.
pub(super) fn tolerance_over_flank(
    loaded: &LoadedJob,
    setup: &GrindingSetup,
) -> Result<(ToleranceMap, Option<String>), Diagnostic> {
    match loaded.job.target.judged {
        Judged::Field => Ok((tolerance_of_job(loaded)?, None)),
        Judged::Traces => tolerance_on_traces(loaded, setup),
    }
}

/// The tolerance within half a step of the result grid of each trace, so that the points next to a trace are judged as it is; the band
/// elsewhere.
fn tolerance_on_traces(
    loaded: &LoadedJob,
    setup: &GrindingSetup,
) -> Result<(ToleranceMap, Option<String>), Diagnostic> {
    let target = &loaded.job.target;
    let fields = &setup.fields;
    let which: Vec<Flank> = Flank::BOTH.into_iter().filter(|&flank| is_ground(&loaded.job, flank)).collect();
    let first = which.first().copied().unwrap_or(Flank::Left);
    let (roll, face) = (fields[first].roll(), fields[first].face());
    let differs = |&flank: &Flank| (0..2).any(|k| (fields[flank].roll()[k] - roll[k]).abs() > SAME);
    if which.iter().any(differs) {
        let of =
            |flank: Flank| format!("{} mm", shown_number(0.5 * fields[flank].roll().iter().sum::<f64>()));
        return Err(Diagnostic::new(
            Problem::InvalidJob,
            "the flanks have other lengths of roll: traces at one of them are no traces of the other",
        )
        .field("target.judged")
        .value("\"traces\"")
        .allowed(format!(
            "flanks alike; the middles are {} left, {} right",
            of(Flank::Left),
            of(Flank::Right)
        ))
        .way_out("give target.tolerance_map, or grind the flanks in two jobs (grinding.flanks)"));
    }
    let traces = target.traces.clone().unwrap_or_default();
    let tolerance = target.tolerance_um;
    let beside = traces.beside_um.unwrap_or(BESIDE * tolerance);
    if beside < tolerance {
        return Err(Diagnostic::new(
            Problem::InvalidNumber,
            "the band beside the traces is narrower than the tolerance on them",
        )
        .field("target.traces.beside_um")
        .value(shown_number(beside))
        .allowed(format!("at least tolerance_um = {}", shown_number(tolerance)))
        .way_out("give the wider of both, or judged = \"field\""));
    }
    let grid = &loaded.job.grid;
    let w = Places::new("helix_w_mm", traces.helix_w_mm.as_deref(), roll, grid.profile_points)?;
    let z = Places::new("profile_z_mm", traces.profile_z_mm.as_deref(), face, grid.helix_points)?;
    let row = |&(_, on_helix): &(f64, bool)| {
        let at =
            |&(_, on_profile): &(f64, bool)| 1e-3 * if on_helix || on_profile { tolerance } else { beside };
        z.all.iter().map(at).collect()
    };
    let table = w.all.iter().map(row).collect();
    let places = |of: &Places| of.all.iter().map(|(x, _)| *x).collect();
    let listed = |at: &[f64]| at.iter().map(|x| shown_number(*x)).collect::<Vec<_>>().join(", ");
    let words = format!(
        "helix traces at w = {} mm, profile traces at z = {} mm; {} um beside them",
        listed(&w.traces),
        listed(&z.traces),
        shown_number(beside)
    );
    let map = ToleranceMap::new(places(&w), places(&z), table);
    map.map(|map| (map, Some(words))).map_err(|e| modification_finding(&e, "target.traces"))
}

/// Places in one direction, ascending, each with whether it belongs to a trace, and the traces.
struct Places {
    all: Vec<(f64, bool)>,
    traces: Vec<f64>,
}

impl Places {
    fn new(key: &str, given: Option<&[f64]>, range: [f64; 2], points: usize) -> Result<Self, Diagnostic> {
        let [from, to] = range;
        let middle = [0.5 * (from + to)];
        let at = given.unwrap_or(&middle);
        if let Some((k, &x)) = at.iter().enumerate().find(|(_, x)| !(from..=to).contains(*x)) {
            return Err(Diagnostic::new(
                Problem::InvalidNumber,
                "a trace stands outside the evaluated range",
            )
            .field(format!("target.traces.{key}[{k}]"))
            .value(shown_number(x))
            .allowed(format!("{} to {} mm", shown_number(from), shown_number(to)))
            .way_out("give places within the evaluated range, or none for the middle"));
        }
        let step = STEP * (to - from);
        let half = 0.5 * (to - from) / (points - 1) as f64 + step;
        let near = |x: f64| at.iter().any(|&trace| (x - trace).abs() <= half + 0.5 * step);
        let mut places: Vec<f64> =
            at.iter().flat_map(|&x| [x - half - step, x - half, x + half, x + half + step]).collect();
        places.extend([from - step, to + step]);
        places.sort_by(f64::total_cmp);
        places.dedup_by(|b, a| *b - *a < 0.25 * step);
        Ok(Self { all: places.into_iter().map(|x| (x, near(x))).collect(), traces: at.to_vec() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grid_points_next_to_a_trace_are_on_it_and_no_others() {
        // 11 points over 0..10, traces at 5 and 7.4: 5 and 7 lie within half a step.
        let places = Places::new("helix_w_mm", Some(&[5.0, 7.4]), [0.0, 10.0], 11).unwrap();
        let (x, tight): (Vec<f64>, Vec<bool>) = places.all.iter().copied().unzip();
        let on = |at: f64| {
            let map = ToleranceMap::new(
                x.clone(),
                vec![0.0],
                tight.iter().map(|&t| vec![if t { 1.0 } else { 3.0 }]).collect(),
            );
            map.unwrap().value(at, 0.0)
        };
        for (at, expected) in
            [(4.0, 3.0), (5.0, 1.0), (5.49, 1.0), (6.0, 3.0), (7.0, 1.0), (8.0, 3.0), (0.0, 3.0), (10.0, 3.0)]
        {
            assert_eq!(on(at), expected, "{at}");
        }
        assert!(Places::new("helix_w_mm", Some(&[10.1]), [0.0, 10.0], 11).is_err());
    }
}
