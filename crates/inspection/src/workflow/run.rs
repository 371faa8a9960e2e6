//! `inspect` of a measured gear: by itself, for a job, or of a simulated machine in rounds.

use super::areal::areal;
use super::asked::Asked;
use super::assemble::{InspectionContext, gear_result};
use super::bands::Bands;
use super::closed_loop::{Round, of_file, of_header, of_milled_file, simulated};
use super::evaluate::{Design, EvaluatedGear, evaluate_inspection, trace_name, without_design};
use super::files::{read_measurement, refused};
use super::files_content::MeasuredFiles;
use super::judgement;
use super::result::{BandResult, GearInspectionResult, LinesResult};
use super::statements::Statements;
use foundation::geometry::{Flank, Sides};
use foundation::modification::{EvaluationField, Modification};
use foundation::numerics::Progress;
use generating_grinding::job::LoadedJob;
use job::tables::{JobInfo, Language};
use measured_files::inspection::Inspection;
use milling::job::LoadedMillingJob;
use run::{JobFailure, RunFailure};
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;
use verdict::Remark;

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
    /// The job that the measurement was judged by.
    pub job: Option<JobInfo>,
    /// Language of report and sheet: that of the job, English without one.
    pub language: Language,
}

/// Reads and evaluates a measurement by itself; a file that states modifications is evaluated against them. With a class of ISO 1328-1 the
/// part is judged by it.
///
/// # Errors
/// [`JobFailure`]: a file that is no measurement, a header that makes no gear, a class that the standard does not have. What single traces lack is reported in warnings.
pub fn inspect_gear(
    path: &Path,
    statements: &Statements,
    class: Option<i32>,
) -> Result<GearInspection, JobFailure> {
    judgement::check_class(class)?;
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
        verdict: judgement::alone(&files.inspection, &gear, class),
        tolerance_class: class,
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
        job: None,
        language: Language::default(),
    })
}

/// Judges a measured file against a job, and by a class of ISO 1328-1 where one is asked for, here or by `gear.tolerance_class`.
///
/// # Errors
/// As [`inspect_gear`]; a measurement of another gear, and what is wrong with the job.
pub fn inspect_for_job(
    loaded: &LoadedJob,
    path: &Path,
    statements: &Statements,
    class: Option<i32>,
    progress: &dyn Progress,
) -> Result<GearInspection, JobFailure> {
    let begun = Instant::now();
    let class = class.or(loaded.job.gear.tolerance_class);
    judgement::check_class(class)?;
    let asked = Asked::of_job(loaded)?;
    let (round, files) = of_file(loaded, &asked, (path, statements), progress)?;
    let told = Told { not_understood: files.not_understood, remarks: files.remarks, stated: files.stated };
    Ok(of_rounds(&asked, class, vec![round], stem(path), told, begun)?)
}

/// Judges a measured file against a job of five-axis milling, and by a class of ISO 1328-1 where one is asked for, here or by
/// `gear.tolerance_class`.
///
/// # Errors
/// As [`inspect_gear`]; a measurement of another gear, a workpiece that is no cylindrical gear, and what is wrong with the job.
pub fn inspect_for_milling(
    loaded: &LoadedMillingJob,
    path: &Path,
    statements: &Statements,
    class: Option<i32>,
    progress: &dyn Progress,
) -> Result<GearInspection, JobFailure> {
    let begun = Instant::now();
    let job = &loaded.job;
    let class = class.or(job.gear.as_ref().and_then(|gear| gear.drawing.tolerance_class));
    judgement::check_class(class)?;
    let (round, files) = of_milled_file(loaded, (path, statements), progress)?;
    let tolerance_um = job.target.tolerance_um;
    let asks_for = |flank: Flank| job.flanks().contains(&flank);
    let mut verdict = judgement::of_job(&round, (tolerance_um, &asks_for), &BTreeMap::new(), 0);
    if let Some(class) = class {
        verdict.extend(judgement::of_class(&round.inspection, &round.gear, class));
    }
    let mut remarks = files.remarks;
    remarks.extend(remarks_on_surfaces(&round, tolerance_um));
    let context = InspectionContext {
        name: stem(path),
        not_understood: files.not_understood,
        remarks,
        stated: files.stated,
        rounds: vec![round.result.clone()],
        bands: BTreeMap::new(),
        areal: BTreeMap::new(),
        tolerance_um: Some(tolerance_um),
        verdict,
        tolerance_class: class,
        timing: BTreeMap::from([("all", begun.elapsed().as_secs_f64())]),
    };
    let result = gear_result(&round.inspection, &round.gear, context);
    let (inspection, gear) = (round.inspection.clone(), round.gear.clone());
    Ok(GearInspection {
        result,
        inspection,
        gear,
        rounds: vec![round],
        against_target: None,
        bands: Bands::default(),
        job: Some(job.job.clone()),
        language: job.output.language,
    })
}

/// Measures and corrects the simulated machine of a job; the last part is judged by the class as well, where one is asked for.
///
/// # Errors
/// [`RunFailure`]: what is wrong with the job.
pub fn inspect_simulated(
    loaded: &LoadedJob,
    class: Option<i32>,
    progress: &dyn Progress,
) -> Result<GearInspection, RunFailure> {
    let begun = Instant::now();
    let class = class.or(loaded.job.gear.tolerance_class);
    judgement::check_class(class)?;
    let asked = Asked::of_job(loaded)?;
    let rounds = simulated(loaded, &asked, progress)?;
    let name = asked.info.name.clone();
    of_rounds(&asked, class, rounds, name, Told::default(), begun)
}

/// What reading a file has found.
#[derive(Default)]
struct Told {
    not_understood: Vec<LinesResult>,
    remarks: Vec<Remark>,
    stated: Vec<String>,
}

fn of_rounds(
    asked: &Asked,
    class: Option<i32>,
    rounds: Vec<Round>,
    name: String,
    Told { not_understood, mut remarks, stated }: Told,
    begun: Instant,
) -> Result<GearInspection, RunFailure> {
    let Some(last) = rounds.last() else { return Err(RunFailure::no_settings()) };
    let design = asked.design();
    let mut bands: BTreeMap<usize, BandResult> = BTreeMap::new();
    let mut unjudged = 0;
    for one in &last.gear.traces {
        match asked.bands.judge(&last.inspection, &last.gear.gear, one.trace, Some(&design)) {
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
    remarks.extend(remarks_on_surfaces(last, asked.tolerance_um));
    let asks_for = |flank| asked.asks_for(flank);
    let mut verdict = judgement::of_job(last, (asked.tolerance_um, &asks_for), &bands, unjudged);
    if let Some(class) = class {
        verdict.extend(judgement::of_class(&last.inspection, &last.gear, class));
    }
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
        tolerance_um: Some(asked.tolerance_um),
        verdict,
        tolerance_class: class,
        timing: BTreeMap::from([("all", begun.elapsed().as_secs_f64())]),
    };
    let result = gear_result(&inspection, &gear, context);
    Ok(GearInspection {
        result,
        inspection,
        gear,
        rounds,
        against_target,
        bands: asked.bands.clone(),
        job: Some(asked.info.clone()),
        language: asked.language,
    })
}

/// What measured surfaces do not tell, or tell twice.
fn remarks_on_surfaces(last: &Round, tolerance_um: f64) -> Vec<Remark> {
    let mut remarks = Vec::new();
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
        if let Some([_, most]) = of.mismatch_um.filter(|[_, most]| *most > tolerance_um) {
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
    remarks
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
                |field| Modification::for_flank(specs, flank, &field, &foundation::modification::NoFiles),
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
