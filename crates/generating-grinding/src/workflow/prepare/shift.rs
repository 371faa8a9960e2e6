//! From `[grinding] diagonal_ratio` to the law of the tool shift: curves and tables of
//! `docs/mathematics/planning.md#variable-diagonal-ratio`, areas of section 8. Every finding names the job's key.

use crate::job::{DiagonalRatio, DiagonalRule, Job, ShiftCurve, ShiftTable};
use crate::workflow::generating_finding;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{InverseLaw, MotionLaw};
use foundation::modification::{ModificationSpec, ToleranceMap};
use generating::areas::{AreaPlan, AreaTask, Demand, Region};
use generating::least_squares::{DEFAULT_GRID, FitSettings, FlankFit, FunctionClass, Samples};
use generating::{
    CurveLaw, DEFAULT_NODES, FlankTarget, GeneratingError, GrindingSetup, ShiftFit, WantedCurve, fit_shift,
};
use job::Diagnostic;
use run::RunFailure;

/// Key of the ratio.
const RATIO: &str = "grinding.diagonal_ratio";
/// Travel beyond the field for which a law must hold, mm: overrun and contact shift.
const BEYOND: f64 = 3.0;
/// A curve is continued beyond the profile by this many profile lengths at the most until it covers the flank.
const WIDEST: f64 = 64.0;
/// Corners between areas are rounded over this at the most, mm of feed.
const ROUNDING: f64 = 1.0;

/// What the job's shift is.
pub struct Shift {
    /// The law, if it is no constant ratio.
    pub law: Option<MotionLaw>,
    /// The areas that it was made for.
    pub areas: Option<AreaPlan>,
}

/// The law through the points of a job: a spline, of fewer than four points a broken line.
fn through(x: &[f64], y: &[f64], field: &str) -> Result<MotionLaw, RunFailure> {
    let law = if x.len() < 4 { MotionLaw::broken_line(x, y) } else { MotionLaw::spline(x, y) };
    law.map_err(|e| RunFailure::of_law(&e, field))
}

/// The shift that a job asks for; flanks that are ground in `which`.
///
/// # Errors
/// Laws that are no law, that do not cover the flank or run back; areas that overlap or share lines.
pub fn shift_of_job(
    job: &Job,
    setup: &GrindingSetup,
    targets: &Sides<Option<FlankTarget>>,
    tolerance: &ToleranceMap,
    which: &[Flank],
) -> Result<Shift, RunFailure> {
    let none = Shift { law: None, areas: None };
    match &job.grinding.diagonal_ratio {
        Some(DiagonalRatio::Rule(DiagonalRule::Areas)) => {
            cylinders_only(setup, "\"areas\"")?;
            areas(job, setup, which)
        }
        Some(DiagonalRatio::Rule(DiagonalRule::Variable)) => {
            cylinders_only(setup, "\"variable\"")?;
            let law = fitted(setup, targets, tolerance, which)
                .map_err(|e| generating_finding::on_field(&e, RATIO))?;
            Ok(Shift { law: Some(law), areas: None })
        }
        Some(DiagonalRatio::Law(law)) => {
            let law = match (&law.curve, &law.table) {
                (Some(curve), _) => {
                    cylinders_only(setup, "a curve")?;
                    of_curve(curve, setup, which)?
                }
                (None, Some(table)) => of_table(table, setup, which)?,
                (None, None) => return Ok(none),
            };
            Ok(Shift { law: Some(law), areas: None })
        }
        _ => Ok(none),
    }
}

/// Curves and areas are stated on the flank of a cylinder.
fn cylinders_only(setup: &GrindingSetup, what: &str) -> Result<(), RunFailure> {
    if setup.pair.worm.is_cylindrical() && setup.pair.work.is_cylindrical() {
        return Ok(());
    }
    let finding = Diagnostic::with_code(
        "cylindrical-only",
        format!("{what} as diagonal ratio needs a cylindrical gear and a cylindrical tool"),
    );
    let finding = finding
        .field(RATIO)
        .way_out("give the shift as { table = { z_v2_mm = [..], z_v1_mm = [..] } }, or a number");
    Err(RunFailure::bad_input(finding))
}

/// The law fitted to the targets together with worm functions, profile and motion: the better of both signs of the ratio.
fn fitted(
    setup: &GrindingSetup,
    targets: &Sides<Option<FlankTarget>>,
    tolerance: &ToleranceMap,
    which: &[Flank],
) -> Result<MotionLaw, GeneratingError> {
    let samples = Sides::try_from_fn(|flank| {
        let Some(target) = &targets[flank] else { return Ok(None) };
        let cos = setup.lines[flank].cos_b2;
        Samples::of_modification(&target.modification, DEFAULT_GRID)?
            .with_tolerance(|w, z| tolerance.value(w, z) / cos)
            .map(Some)
    })?;
    let settings = FitSettings::new(FunctionClass::CLPK);
    let fits = Sides::from_fn(|flank| {
        let samples = samples[flank].as_ref()?;
        Some(FlankFit { lines: &setup.lines[flank], samples, settings: &settings, rack_slope: 0.0 })
    });
    // Lines straight along the face width are the usual ones; a spur gear has no ratio for them.
    let level = which.iter().map(|&flank| setup.lines[flank].ratio_of_direction(0.0).abs());
    let start = level.filter(|k| k.is_finite()).fold(0.0, f64::max);
    let start = if start > 0.0 { start } else { 1.0 };
    let tried = [start, -start].map(|ratio| fit_shift(&fits, ratio, DEFAULT_NODES));
    let best = |a: ShiftFit, b: ShiftFit| if b.objective < a.objective { b } else { a };
    let fit = match tried {
        [Ok(a), Ok(b)] => best(a, b),
        [Ok(fit), Err(_)] | [Err(_), Ok(fit)] => fit,
        [Err(error), Err(_)] => return Err(error),
    };
    Ok(setup.centred(fit.shift.law(), which))
}

/// Feeds that the law must cover, mm.
fn feeds(setup: &GrindingSetup, which: &[Flank], law: &MotionLaw) -> [f64; 2] {
    let [from, to] = setup.feed_range(law, which);
    [from - BEYOND, to + BEYOND]
}

/// A law is refused unless it runs one way over the whole feed: a tool line that grinds two places has no modification of
/// its own.
fn one_way(law: &MotionLaw, domain: [f64; 2], field: &str) -> Result<(), RunFailure> {
    InverseLaw::new(law.clone(), domain).map(|_| ()).map_err(|e| RunFailure::of_law(&e, field))
}

fn of_curve(curve: &ShiftCurve, setup: &GrindingSetup, which: &[Flank]) -> Result<MotionLaw, RunFailure> {
    const FIELD: &str = "grinding.diagonal_ratio.curve";
    let (law, line, flank, given) = match curve {
        ShiftCurve::LineBlend(c) => {
            let (slope, turn, half_length, level) = (c.slope, c.w_t_mm, c.h_mm, c.z_e_mm);
            (CurveLaw::LineBlend { slope, turn, half_length, level }, c.x_ref_mm, c.flank, None)
        }
        ShiftCurve::LineSine(c) => {
            let (slope, origin, amplitude, phase_length) = (c.slope, c.w_0_mm, c.a_mm, c.p_mm);
            (CurveLaw::LineSine { slope, origin, amplitude, phase_length }, c.x_ref_mm, c.flank, None)
        }
        ShiftCurve::Points(c) => {
            let law = through(&c.w_mm, &c.z_mm, FIELD)?;
            let ends = c.w_mm.first().zip(c.w_mm.last()).map(|(a, b)| [*a, *b]);
            (CurveLaw::Law(law), c.x_ref_mm, c.flank, ends)
        }
    };
    let lines = &setup.lines[flank];
    let length = lines.roll[1] - lines.roll[0];
    let needed = feeds(setup, which, &MotionLaw::zero());
    let mut beyond = 1.0;
    loop {
        // Beyond the profile w is only a parameter of the curve. Points go on straight there.
        let [low, high] = given.unwrap_or(lines.roll);
        let roll = [low.min(lines.roll[0]) - beyond * length, high.max(lines.roll[1]) + beyond * length];
        let covered = WantedCurve { law: law.clone(), line, roll }.shift(lines).and_then(|shift| {
            let [from, to] = shift.domain();
            let missing = from > needed[0] || to < needed[1];
            if missing {
                Err(GeneratingError::RangeNotCovered { flank, covered: [from, to], needed })
            } else {
                Ok(shift)
            }
        });
        match covered {
            Ok(shift) => {
                let smooth = shift.law().smooth(needed).map_err(|e| RunFailure::of_law(&e, FIELD))?;
                one_way(&smooth, needed, FIELD)?;
                return Ok(setup.centred(&smooth, which));
            }
            Err(GeneratingError::RangeNotCovered { .. }) if beyond < WIDEST => beyond *= 2.0,
            Err(error) => return Err(generating_finding::on_field(&error, FIELD)),
        }
    }
}

fn of_table(table: &ShiftTable, setup: &GrindingSetup, which: &[Flank]) -> Result<MotionLaw, RunFailure> {
    const FIELD: &str = "grinding.diagonal_ratio.table";
    let (x, y) = (&table.z_v2_mm, &table.z_v1_mm);
    let law = through(x, y, FIELD)?;
    let [from, to] = setup.feed_range(&law, which);
    // Written so that a range that is no number is refused.
    let covered = x.first().is_some_and(|&a| a <= from) && x.last().is_some_and(|&b| b >= to);
    if !covered {
        let finding = Diagnostic::with_code(
            "range-not-covered",
            format!(
                "the table gives no shift over the whole feed: the flanks need z_V2 = {from:.3} .. {to:.3} mm"
            ),
        );
        let finding = finding.field(FIELD).way_out("let the table reach over the feed that the flanks need");
        return Err(RunFailure::bad_input(finding));
    }
    one_way(&law, [from, to], FIELD)?;
    Ok(law)
}

/// Regions of the target that need lines of their own, one diagonal ratio each.
fn areas(job: &Job, setup: &GrindingSetup, which: &[Flank]) -> Result<Shift, RunFailure> {
    let mut regions = Vec::new();
    for &flank in which {
        for spec in job.target.modifications.iter().flatten().filter(|spec| spec.flank().includes(flank)) {
            if let ModificationSpec::TriangularEndRelief(relief) = spec {
                let region = Region::of_triangular_relief(relief, &setup.lines[flank]);
                regions.push(region.map_err(|e| generating_finding::on_field(&e, "target.modifications"))?);
            }
        }
    }
    if regions.is_empty() {
        let finding = Diagnostic::with_code(
            "no-region",
            "the target has no region with lines of its own (triangular_end_relief) on the flanks that are ground",
        );
        let finding = finding.field(RATIO).way_out("use diagonal_ratio = \"auto\" or a number");
        return Err(RunFailure::bad_input(finding));
    }
    let lines = Sides::from_fn(|flank| which.contains(&flank).then_some(setup.lines[flank]));
    let least = |regions: &[Region]| {
        let ratios = regions.iter().map(|region| match region.demand {
            Demand::Direction(t) => setup.lines[region.flank].ratio_of_direction(t),
            Demand::Ratio(k) => k,
        });
        ratios.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0)
    };
    let free_ratio = job.grinding.free_ratio.unwrap_or_else(|| least(&regions));
    let plan = AreaTask { lines, regions, free_ratio }
        .plan()
        .map_err(|e| generating_finding::on_field(&e, RATIO))?;
    plan.check_exclusive().map_err(|e| generating_finding::on_field(&e, RATIO))?;
    let room = plan
        .segments
        .iter()
        .filter(|s| !s.modified)
        .map(|s| (s.feed[1] - s.feed[0]) / 4.0)
        .fold(ROUNDING, f64::min);
    // Where regions touch there is nothing to round in; both are unmodified along their border.
    let law = plan.rounded_shift(room).unwrap_or_else(|_| plan.shift.clone());
    Ok(Shift { law: Some(setup.centred(&law, which)), areas: Some(plan) })
}
