//! `inspect` of a measured gear: by itself, for a job, or of a simulated machine in rounds.

use super::areal::areal;
use super::assemble::{InspectionContext, gear_result};
use super::bands::Bands;
use super::closed_loop::{Round, Wanted, of_file, of_header, simulated};
use super::evaluate::{
    Design, EvaluatedGear, EvaluatedTrace, evaluate_inspection, trace_name, without_design,
};
use super::files::{MeasuredFiles, read_measurement, refused};
use super::result::{BandResult, GearInspectionResult, LinesResult};
use super::statements::Statements;
use crate::exchange::LoadedJob;
use crate::exchange::inspection::Inspection;
use crate::geometry::{Flank, Sides};
use crate::modification::{EvaluationField, Modification};
use crate::numerics::Progress;
use crate::workflow::finding::{JobFailure, Remark, RunFailure};
use crate::workflow::result::Status;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

/// Everything that is known of a measured gear.
pub struct GearInspection {
    /// The document of `result.json`.
    pub result: GearInspectionResult,
    /// What was read, or measured on the simulated machine in the last round.
    pub inspection: Inspection,
    /// Its evaluation.
    pub gear: EvaluatedGear,
    /// Rounds against a job.
    pub rounds: Vec<Round>,
    /// Of a job: the measurement less the target, with its evaluation; what the inspection sheet shows.
    pub against_target: Option<Box<(Inspection, EvaluatedGear)>>,
    /// Bands of a job.
    pub bands: Bands,
}

/// Reads and evaluates a measurement by itself; a file that states modifications is judged against them.
///
/// # Errors
/// [`JobFailure`]: a file that is no measurement, a header that makes no gear. What single traces lack is told by warnings.
pub fn inspect_gear(path: &Path, statements: &Statements) -> Result<GearInspection, JobFailure> {
    let begun = Instant::now();
    let mut files = read_measurement(path, None, statements)?;
    let mut timing = BTreeMap::from([("reading", begun.elapsed().as_secs_f64())]);
    let begun = Instant::now();
    let stated = stated_design(&mut files);
    let design = |flank: Flank, w: f64, z: f64| {
        stated[flank].as_ref().map_or(0.0, |m: &Modification| m.value(w, z).unwrap_or(f64::NAN))
    };
    let design: Option<Design<'_>> = stated.iter().any(|(_, m)| m.is_some()).then_some(&design as Design<'_>);
    let gear = evaluate_inspection(&files.inspection, design).map_err(|error| refused(path, &error))?;
    timing.insert("evaluation", begun.elapsed().as_secs_f64());
    let context = InspectionContext {
        name: stem(path),
        not_understood: files.not_understood,
        remarks: files.remarks,
        stated: files.stated,
        rounds: Vec::new(),
        bands: BTreeMap::new(),
        areal: areal(&files.inspection, &gear, design),
        tolerance_um: None,
        verdict: evaluated_at_all(&gear),
        timing,
    };
    let result = gear_result(&files.inspection, &gear, context);
    let inspection = files.inspection;
    Ok(GearInspection {
        result,
        inspection,
        gear,
        rounds: Vec::new(),
        against_target: None,
        bands: Bands::default(),
    })
}

/// Judges a measured file against a job.
///
/// # Errors
/// As [`inspect_gear`]; a measurement of another gear, and what is wrong with the job.
pub fn inspect_for_job(
    loaded: &LoadedJob,
    path: &Path,
    statements: &Statements,
    progress: &dyn Progress,
) -> Result<GearInspection, JobFailure> {
    let begun = Instant::now();
    let judging = Judging::of_job(loaded)?;
    let (round, files) = of_file(loaded, &judging.wanted, (path, statements), progress)?;
    let told = Told { not_understood: files.not_understood, remarks: files.remarks, stated: files.stated };
    Ok(of_rounds(judging, vec![round], stem(path), told, begun)?)
}

/// Measures and corrects the simulated machine of a job.
///
/// # Errors
/// [`RunFailure`]: what is wrong with the job.
pub fn inspect_simulated(loaded: &LoadedJob, progress: &dyn Progress) -> Result<GearInspection, RunFailure> {
    let begun = Instant::now();
    let judging = Judging::of_job(loaded)?;
    let rounds = simulated(loaded, &judging.wanted, progress)?;
    of_rounds(judging, rounds, loaded.job.job.name.clone(), Told::default(), begun)
}

/// What a measurement is judged by.
struct Judging {
    wanted: Wanted,
    bands: Bands,
    tolerance_um: f64,
}

impl Judging {
    fn of_job(loaded: &LoadedJob) -> Result<Self, RunFailure> {
        let table = loaded.job.inspection.clone().unwrap_or_default();
        let tolerance_um = table.tolerance_um.unwrap_or(loaded.job.target.tolerance_um);
        Ok(Self { bands: Bands::of_table(&table)?, wanted: Wanted::of_job(loaded)?, tolerance_um })
    }
}

/// What reading a file has told.
#[derive(Default)]
struct Told {
    not_understood: Vec<LinesResult>,
    remarks: Vec<Remark>,
    stated: Vec<String>,
}

fn of_rounds(
    Judging { wanted, bands: all, tolerance_um: tolerance }: Judging,
    rounds: Vec<Round>,
    name: String,
    Told { not_understood, mut remarks, stated }: Told,
    begun: Instant,
) -> Result<GearInspection, RunFailure> {
    let Some(last) = rounds.last() else { return Err(RunFailure::no_settings()) };
    let design = wanted.design();
    let mut bands: BTreeMap<usize, BandResult> = BTreeMap::new();
    let mut unjudged = 0;
    for one in &last.gear.traces {
        match all.judge(&last.inspection, &last.gear.gear, one.trace, Some(&design)) {
            Some(Ok(found)) => drop(bands.insert(one.trace, found)),
            Some(Err(error)) => {
                unjudged += 1;
                remarks.push(Remark {
                    code: error.code(),
                    text: format!(
                        "{}: no verdict of its band: {error}",
                        trace_name(&last.inspection.traces[one.trace])
                    ),
                    way_out: error.way_out().into(),
                });
            }
            None => {}
        }
    }
    for (flank, of) in &last.result.flanks {
        if !of.sees_twist {
            remarks.push(Remark {
                code: "twist-not-measured",
                text: format!(
                    "one profile and one helix trace tell nothing of the twist of the {flank} flank: its surface was taken to have that of the target"
                ),
                way_out: "measure a second profile or a second helix trace of the same tooth".into(),
            });
        }
        if let Some([_, most]) = of.mismatch_um.filter(|[_, most]| *most > tolerance) {
            remarks.push(Remark {
                code: "lines-disagree",
                text: format!(
                    "profiles and helix traces of the {flank} flank disagree by {most:.3} um where they cross"
                ),
                way_out: "look for burrs and dust at the crossings, and measure again".into(),
            });
        }
        remarks.extend(of.standing_out.iter().map(|(tooth, most)| Remark {
            code: "tooth-stands-out",
            text: format!("tooth {tooth} of the {flank} flank differs from what all share by {most:.3} um"),
            way_out: "look at that tooth, and measure it again".into(),
        }));
        if of.sees_twist {
            remarks.extend(of.outside_traces.iter().map(|(along, share)| Remark {
            code: "outside-traces",
            text: format!(
                "the surface of the {flank} flank goes {:.0} % of the field beyond the outermost lines, by {along}",
                100.0 * share
            ),
            way_out: "measure lines nearer to the ends of the field".into(),
        }));
        }
    }
    let verdict = verdict_of(last, &wanted, &bands, unjudged, tolerance);
    let (inspection, gear) = (last.inspection.clone(), last.gear.clone());
    let less = without_design(&inspection, &gear.gear, &design);
    let evaluated = evaluate_inspection(&less, None).map_err(|error| of_header(&error))?;
    let against_target = Some(Box::new((less, evaluated)));
    let context = InspectionContext {
        name,
        not_understood,
        remarks,
        stated,
        rounds: rounds.iter().map(|round| round.result.clone()).collect(),
        bands,
        areal: BTreeMap::new(),
        tolerance_um: Some(tolerance),
        verdict,
        timing: BTreeMap::from([("all", begun.elapsed().as_secs_f64())]),
    };
    let result = gear_result(&inspection, &gear, context);
    Ok(GearInspection { result, inspection, gear, rounds, against_target, bands: all })
}

/// A measurement of which nothing could be evaluated says nothing.
fn evaluated_at_all(gear: &EvaluatedGear) -> Option<(Status, Remark)> {
    let pitch = gear.pitch.as_ref().is_some_and(|pitch| pitch.flanks.iter().any(|(_, of)| of.is_some()));
    let thickness = gear.thickness.by_span.or(gear.thickness.by_balls).is_some();
    (gear.traces.is_empty() && !pitch && !thickness).then(|| {
        let remark = Remark {
            code: "nothing-evaluated",
            text: "the file holds no trace, pitch or size that could be evaluated".into(),
            way_out: "look at the warnings; perhaps the file is cut short: export it again".into(),
        };
        (Status::NotJudged, remark)
    })
}

/// What a measured gear is for its job, unless it is what the job asks for: missed, or not judged because of what was not measured.
fn verdict_of(
    last: &Round,
    wanted: &Wanted,
    bands: &BTreeMap<usize, BandResult>,
    unjudged: usize,
    tolerance_um: f64,
) -> Option<(Status, Remark)> {
    let way_out = match (&last.result.correction, &last.result.no_correction) {
        (Some(_), _) => "grind the next part by corrected-job.json".into(),
        (None, Some(why)) => {
            format!("look at clamping, machine and measurement; there is no correction: {why}")
        }
        (None, None) => "look at clamping, machine and measurement".into(),
    };
    let missed = |code, text| Some((Status::Missed, Remark { code, text, way_out: way_out.clone() }));
    let flanks = &last.result.flanks;
    let far = flanks.iter().max_by(|a, b| a.1.measured.largest_um.total_cmp(&b.1.measured.largest_um));
    if let Some((flank, of)) = far.filter(|(_, of)| of.measured.largest_um > tolerance_um) {
        let most = of.measured.largest_um;
        return missed(
            "tolerance-exceeded",
            format!(
                "the {flank} flank was measured {most:.3} um off its target (tolerance {tolerance_um} um)"
            ),
        );
    }
    // Where no surface could be laid through the lines, each line is judged by itself.
    let lines = last.gear.traces.iter().map(|one| (&last.inspection.traces[one.trace], one));
    let alone = lines.filter(|(trace, _)| !flanks.contains_key(trace.flank.name()));
    let total = |(trace, one): &(&crate::exchange::inspection::Trace, &EvaluatedTrace)| {
        1e3 * one.evaluation.total * last.gear.gear.flank(trace.flank).base_helix_angle.cos()
    };
    let farthest = alone.max_by(|a, b| total(a).total_cmp(&total(b)));
    if let Some(found) = farthest.filter(|found| total(found) > tolerance_um) {
        let name = trace_name(found.0);
        let text = format!("{name}: total deviation {:.3} um (tolerance {tolerance_um} um)", total(&found));
        return missed("tolerance-exceeded", text);
    }
    let out = bands.values().filter(|band| !band.passed).count();
    if out > 0 {
        return missed("outside-the-band", format!("{out} of {} traces lie outside their band", bands.len()));
    }
    let mut odd = flanks.iter().flat_map(|(flank, of)| of.standing_out.iter().map(move |odd| (flank, odd)));
    if let Some((flank, (tooth, most))) = odd.next() {
        return missed(
            "tooth-stands-out",
            format!(
                "tooth {tooth} of the {flank} flank differs from what all teeth share by {most:.3} um (tolerance {tolerance_um} um)"
            ),
        );
    }
    let not_judged = |text, way_out: &str| {
        Some((Status::NotJudged, Remark { code: "not-judged", text, way_out: way_out.into() }))
    };
    for flank in Flank::BOTH.into_iter().filter(|flank| wanted.asks_for(*flank)) {
        let whole = flanks.get(flank.name()).map(|of| of.measured_um.iter().flatten().all(Option::is_some));
        if whole != Some(true) {
            let how = if whole.is_some() { "only in part" } else { "not" };
            return not_judged(
                format!("the {flank} flank was {how} measured as a surface"),
                "measure at least one profile and one helix trace of the same tooth on every ground flank",
            );
        }
    }
    if unjudged > 0 {
        return not_judged(
            format!("{unjudged} traces could not be laid into their band"),
            "see the warnings; the band has to lie within the measured traces",
        );
    }
    None
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "part".into(), |stem| stem.to_string_lossy().into_owned())
}

/// The modifications that a file states; what they cannot be built from becomes a remark.
fn stated_design(files: &mut MeasuredFiles) -> Sides<Option<Modification>> {
    let Ok(gear) = files.inspection.gear.checked() else { return Sides::default() };
    let conditions = &files.inspection.conditions;
    let mut remarks = Vec::new();
    let found = Sides::from_fn(|flank| {
        let specs = &files.modifications[flank];
        if specs.is_empty() {
            return None;
        }
        let of = &conditions.flanks[flank];
        let involute = gear.flank(flank);
        let made = of.w_1_mm.zip(of.w_2_mm).zip(of.z_1_mm.zip(of.z_2_mm)).map(|((a, b), (c, d))| {
            EvaluationField::new([a, b], [c, d], involute.base_radius, involute.base_helix_angle).and_then(
                |field| Modification::for_flank(specs, flank, &field, &crate::modification::NoFiles),
            )
        });
        match made {
            Some(Ok(made)) => Some(made),
            other => {
                let why = other.map_or_else(
                    || "it states no range".into(),
                    |e| e.err().map_or_else(String::new, |e| e.to_string()),
                );
                remarks.push(Remark {
                    code: "modifications-not-used",
                    text: format!("the {flank} flank is judged against the involute, not against the file's modifications: {why}"),
                    way_out: "give a job with the target".into(),
                });
                None
            }
        }
    });
    files.remarks.extend(remarks);
    found
}
