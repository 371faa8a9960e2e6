//! A measured blank as stock for grinding: how much stands over the finished gear on each flank of each tooth space.
//!
//! Traces tell the shape of a flank, not where it stands: the level of all is that of the measured tooth thickness, the level of each that
//! of its pitch. The table holds what is to be added to `stock.allowance_um` of the job.

use super::closed_loop::check_teeth;
use super::drawn::DrawnGear;
use super::evaluate::{EvaluatedGear, evaluate_inspection};
use super::files::{MeasurementFile, parse_measurement, read_measurement};
use super::files_content::MeasuredFiles;
use super::statements::Statements;
use super::surface::measured_surface;
use foundation::geometry::{Flank, Gear, Sides};
use foundation::numerics::{equidistant, extremes};
use generating::GrindingSetup;
use generating_grinding::job::LoadedJob;
use generating_grinding::stock_file::MeasuredStock;
use generating_grinding::workflow::prepare::prepare;
use job::{Diagnostic, Problem};
use measured_files::inspection::Inspection;
use metrology::Topography;
use run::{JobFailure, RunFailure};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::Path;
use verdict::Remark;

/// Places of the table along profile and face width.
const PLACES: [usize; 2] = [11, 17];
const UM: f64 = 1e3;

/// The stock that a blank has over the finished gear.
#[derive(Clone, Debug)]
pub struct BlankStock {
    /// Amounts on a grid in every tooth space beyond `stock.allowance_um` of the job, um.
    pub flanks: Sides<Option<MeasuredStock>>,
    /// In short.
    pub result: BlankStockResult,
}

/// What a blank has on its flanks in all, normal.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BlankStockResult {
    /// Name of the job.
    pub job: String,
    /// Files of the measurement.
    pub files: Vec<String>,
    /// Least, mean and greatest of each flank; absent for a flank that was not measured.
    pub stock_um: Sides<Option<[f64; 3]>>,
    /// Teeth whose traces were measured, on each flank; the others have the mean of them.
    pub teeth_with_traces: Sides<usize>,
    /// What the level comes from: "span", "balls" or "stock.allowance_um".
    pub level_from: &'static str,
    /// Whether every tooth stands where its pitch says.
    pub with_pitch: bool,
    /// What to know.
    pub remarks: Vec<Remark>,
}

/// Reads a measured blank of the gear of a job.
///
/// # Errors
/// [`JobFailure`]: what is wrong with file and job, a measurement of another gear or without thickness, cones.
pub fn blank_of_file(
    loaded: &LoadedJob,
    path: &Path,
    statements: &Statements,
) -> Result<BlankStock, JobFailure> {
    blank_by(loaded, |drawn| read_measurement(path, Some(drawn), statements))
}

/// As [`blank_of_file`], of a measurement that is at hand as bytes, such as one of the store.
///
/// # Errors
/// As there.
pub fn blank_of_content(
    loaded: &LoadedJob,
    files: &[MeasurementFile],
    statements: &Statements,
) -> Result<BlankStock, JobFailure> {
    blank_by(loaded, |drawn| parse_measurement(files, Some(drawn), statements))
}

fn blank_by(
    loaded: &LoadedJob,
    read: impl FnOnce(&DrawnGear) -> Result<MeasuredFiles, JobFailure>,
) -> Result<BlankStock, JobFailure> {
    let mut plain = loaded.clone();
    // The stock that is looked for is not asked for.
    plain.job.stock = None;
    plain.job.technology = None;
    let setup = prepare(&plain)?.setup;
    let drawn = DrawnGear::of_setup(&setup)?;
    let files = read(&drawn)?;
    check_teeth(&files)?;
    drawn.is_of(&files.inspection)?;
    Ok(stock_of(loaded, &setup, &files)?)
}

fn stock_of(
    loaded: &LoadedJob,
    setup: &GrindingSetup,
    files: &MeasuredFiles,
) -> Result<BlankStock, RunFailure> {
    let inspection = &files.inspection;
    let evaluated = evaluate_inspection(inspection, None)
        .map_err(|error| RunFailure::bad_input(Diagnostic::of(&error)))?;
    let finished = &setup.input.gear;
    let allowance = loaded.job.stock.as_ref().and_then(|stock| stock.allowance_um);
    let allowance = allowance.map(|um| um.sides().map(|_, um| um / UM));
    let level = Level::new(finished, &evaluated, allowance)?;
    let stated = allowance.unwrap_or(Sides::both(0.0));
    let mut remarks = files.remarks.clone();
    let pitch = pitch_of(inspection.conditions.turned, finished, &evaluated);
    if pitch.is_none() {
        remarks.push(Remark {
            code: "blank-without-pitch",
            text: "the pitches are not known: every tooth space has the same mean stock".into(),
            way_out: "measure the pitch of both flanks, counted counter-clockwise".into(),
        });
    }
    let mut teeth_with_traces = Sides::both(0);
    let teeth = finished.data().teeth.unsigned_abs() as usize;
    let flanks = Sides::try_from_fn(|flank| {
        let [roll, face] = [setup.fields[flank].roll(), setup.fields[flank].face()];
        let (w, z) = (rounded(roll, PLACES[0]), rounded(face, PLACES[1]));
        let surface = |inspection: &Inspection| {
            measured_surface(inspection, &evaluated.gear, flank, [&w, &z], &|_, _, _| 0.0)
                .map_err(|error| RunFailure::bad_input(Diagnostic::of(&error).field("FILE")))
        };
        let of_teeth = surface(inspection)?;
        let crossed = of_teeth.is_some();
        let found = match of_teeth {
            Some(found) => found,
            None => match surface(&of_one_tooth(inspection))? {
                Some(found) => found,
                None => return Ok(None),
            },
        };
        let place = [middle_roll(loaded, finished, flank), 0.5 * (face[0] + face[1])];
        let about = |surface: &Topography| about_place(surface, place);
        let shapes: Vec<(u32, Vec<f64>)> =
            found.teeth.iter().filter_map(|(tooth, surface)| Some((*tooth, about(surface)?))).collect();
        let Some(mean) = mean_of(&shapes) else { return Ok(None) };
        if crossed {
            teeth_with_traces[flank] = shapes.len();
        } else {
            remarks.push(Remark {
                code: "blank-of-single-lines",
                text: format!(
                    "no tooth has a profile and a helix trace of its {flank} flank: its shape is that of lines of several teeth"
                ),
                way_out: "measure one profile and one helix trace of the same tooth".into(),
            });
        }
        let shapes = if crossed { shapes } else { Vec::new() };
        let of_space = |space: usize| {
            let tooth = tooth_of(flank, space, teeth);
            let own = shapes.iter().find(|(number, _)| *number as usize == tooth + 1);
            let by_pitch = pitch.as_ref().map_or(0.0, |pitch| pitch[flank][tooth]);
            let shape = own.map_or(&mean, |(_, shape)| shape);
            let over = level.amount[flank] - stated[flank] + by_pitch;
            // Hundredths of a micrometre are far below what a machine measures.
            let um = shape.iter().map(|f| (1e2 * UM * (f + over)).round() * 1e-2).collect();
            // Without pitches the others have the mean of those that stand there, as the reader of the table takes it.
            let alike = shapes.is_empty() && space == 0;
            (pitch.is_some() || own.is_some() || alike).then_some((space, um))
        };
        let spaces: Vec<(usize, Vec<f64>)> = (0..teeth).filter_map(of_space).collect();
        Ok::<_, RunFailure>(Some(MeasuredStock { w, z, spaces }))
    })?;
    if flanks.iter().all(|(_, found)| found.is_none()) {
        let finding =
            Diagnostic::new(Problem::InvalidTable, "no flank has a profile and a helix trace that cross")
                .field("FILE")
                .allowed("a profile and a helix trace of at least one flank, or points of a field")
                .way_out("measure one profile and one helix trace of some teeth");
        return Err(RunFailure::bad_input(finding));
    }
    let stock_um = Sides::from_fn(|flank| {
        let of_flank = flanks[flank].as_ref()?;
        let all = || of_flank.spaces.iter().flat_map(|(_, um)| um).map(|um| um + UM * stated[flank]);
        let [least, most] = extremes(all());
        let count = (of_flank.spaces.len() * of_flank.w.len() * of_flank.z.len()) as f64;
        Some([least, all().sum::<f64>() / count, most])
    });
    let result = BlankStockResult {
        job: loaded.job.job.name.clone(),
        files: inspection.sources.clone(),
        stock_um,
        teeth_with_traces,
        level_from: level.from,
        with_pitch: pitch.is_some(),
        remarks,
    };
    Ok(BlankStock { flanks, result })
}

/// The lines of all teeth as if one tooth had them.
fn of_one_tooth(inspection: &Inspection) -> Inspection {
    let mut together = inspection.clone();
    together.traces.iter_mut().for_each(|trace| trace.tooth = 1);
    together
}

/// Equidistant places, to a micrometre.
fn rounded(ends: [f64; 2], count: usize) -> Vec<f64> {
    equidistant(ends, count).into_iter().map(|place| (1e3 * place).round() * 1e-3).collect()
}

/// How far both flanks of the blank stand over the finished ones in the middle of the profile, mm.
struct Level {
    amount: Sides<f64>,
    from: &'static str,
}

impl Level {
    fn new(
        finished: &Gear,
        evaluated: &EvaluatedGear,
        allowance: Option<Sides<f64>>,
    ) -> Result<Self, RunFailure> {
        let thickness = &evaluated.thickness;
        // Of thicker teeth the half space is narrower: the flanks stand nearer to each other by this angle.
        let over = |blank: &Gear| {
            Sides::from_fn(|flank| {
                let (f, g) = (finished.flank(flank), blank.flank(flank));
                (f.base_space_half_angle - g.base_space_half_angle) * f.base_radius * f.base_helix_angle.cos()
            })
        };
        if thickness.by_span.is_some() || thickness.by_balls.is_some() {
            let from = if thickness.by_span.is_some() { "span" } else { "balls" };
            return Ok(Self { amount: over(&evaluated.gear), from });
        }
        if let Some(amount) = allowance {
            return Ok(Self { amount, from: "stock.allowance_um" });
        }
        let finding = Diagnostic::new(
            Problem::MissingKey,
            "the measurement tells no tooth thickness, so that nothing says how far the flanks stand over the finished ones",
        )
        .field("stock.allowance_um")
        .allowed("a file with span or size over balls, or the mean stock in the job")
        .way_out("give stock.allowance_um in the job: the stock in the middle of the flank");
        Err(RunFailure::bad_input(finding))
    }
}

/// Length of roll in the middle of the evaluated profile, mm: where the level of a shape is that of the tooth thickness.
fn middle_roll(loaded: &LoadedJob, finished: &Gear, flank: Flank) -> f64 {
    let range = loaded.job.gear.evaluation_range();
    let radius = 0.25 * (range.start_diameter + range.end_diameter);
    finished.flank(flank).length_of_roll(radius).unwrap_or(0.0)
}

/// Stock of each tooth by its pitch about the mean, normal, mm, tooth 1 first; `None` where the pitches of a flank are not known.
fn pitch_of(turned: bool, finished: &Gear, evaluated: &EvaluatedGear) -> Option<Sides<Vec<f64>>> {
    let pitch = evaluated.pitch.as_ref()?;
    // Without a thickness variation the sense in which teeth are counted is not known.
    pitch.thickness_variation?;
    let of_flank = |flank: Flank| {
        let found = pitch.flanks[flank].as_ref()?;
        let f = finished.flank(flank);
        let mean = found.cumulative.iter().sum::<f64>() / found.cumulative.len() as f64;
        let angle = |arc: f64| (arc - mean) / finished.pitch_radius();
        // A left flank that stands further on narrows the space behind it, a right one widens the space before it; the machine counted
        // the gear as it saw it.
        let seen = if turned { flank.other() } else { flank };
        let sign = if seen == Flank::Left { 1.0 } else { -1.0 };
        let normal = f.base_radius * f.base_helix_angle.cos();
        Some(found.cumulative.iter().map(|arc| sign * angle(*arc) * normal).collect())
    };
    Some(Sides { left: of_flank(Flank::Left)?, right: of_flank(Flank::Right)? })
}

/// The tooth, from 0, whose flank bounds a space: space i follows the left flank of tooth i and precedes the right flank of the next.
fn tooth_of(flank: Flank, space: usize, teeth: usize) -> usize {
    match flank {
        Flank::Left => space,
        Flank::Right => (space + 1) % teeth,
    }
}

/// A surface about its value at a place (w, z), complete: places that were not measured have the value of the nearest that was.
fn about_place(surface: &Topography, [w, z]: [f64; 2]) -> Option<Vec<f64>> {
    let columns = surface.z.len();
    let known: Vec<usize> = (0..surface.f.len()).filter(|&k| surface.f[k].is_finite()).collect();
    let scale = [surface.w.last()? - surface.w.first()?, surface.z.last()? - surface.z.first()?];
    let nearest = |w: f64, z: f64| {
        let distance = |k: usize| {
            let (dw, dz) = ((surface.w[k / columns] - w) / scale[0], (surface.z[k % columns] - z) / scale[1]);
            dw.hypot(dz)
        };
        known.iter().copied().min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
    };
    let level = surface.f[nearest(w, z)?];
    (0..surface.f.len())
        .map(|k| {
            let here = if surface.f[k].is_finite() {
                k
            } else {
                nearest(surface.w[k / columns], surface.z[k % columns])?
            };
            Some(surface.f[here] - level)
        })
        .collect()
}

fn mean_of(shapes: &[(u32, Vec<f64>)]) -> Option<Vec<f64>> {
    let (_, first) = shapes.first()?;
    let share = 1.0 / shapes.len() as f64;
    Some((0..first.len()).map(|k| share * shapes.iter().map(|(_, shape)| shape[k]).sum::<f64>()).collect())
}
