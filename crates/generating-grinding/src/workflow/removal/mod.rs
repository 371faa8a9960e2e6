//! What the strokes of a run take of the stock, how long the worm lasts, what a part takes and costs
//! (`docs/mathematics/grinding-technology.md`). The flank does not depend on it.

mod result;

pub use result::{
    CostResult, FlankRemovalResult, IndicatorResult, PartTimeResult, RemovalResult, StockResult,
    StrokeResult, WormLifeResult, WormLoadResult,
};

use super::execution::Execution;
use super::partition::Partition;
use super::prepare::{Prepared, RemovalTask};
use super::programs::result::{ProgramResult, ProgramsResult};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use grinding_technology::{
    Bodies, Cycle, Direction, FlankStroke, STATIONS, Sense, Shift, StockField, Stroke, TechnologyError,
    WidthUse, WormLife, ZoneLimits,
};
use job::{Diagnostic, Problem, shown_number};
use run::RunFailure;
use verdict::Remark;

const UM: f64 = 1e3;
const RPM: f64 = 60.0;
/// Intervals of the removal rate over a stroke.
const INTERVALS: usize = 60;
/// Bodies that nothing limits but the wanted cutting speed.
const NO_LIMIT: f64 = 1e9;
/// A shift within this of a straight line over the stroke is one, mm.
const STRAIGHT: f64 = 1e-6;

/// Figures and remarks.
pub struct Removal {
    /// For `result.json`; `None` where the bodies or motions are beyond what is worked out.
    pub result: Option<RemovalResult>,
    /// What to know.
    pub remarks: Vec<Remark>,
}

/// Of a run with stock; nothing without.
///
/// # Errors
/// [`RunFailure`] with a finding on `[stock]` or `[technology]`.
pub fn removal_of_run(
    prepared: &Prepared,
    execution: &Execution,
    (partition, programs): (Option<&Partition>, Option<&ProgramsResult>),
) -> Result<Removal, RunFailure> {
    let Some(task) = &prepared.removal else { return Ok(Removal { result: None, remarks: Vec::new() }) };
    match beyond(prepared, execution) {
        Some(why) => {
            let remark = Remark {
                code: "removal-not-worked-out",
                text: format!("stock and removal are not worked out for this job: {why}"),
                way_out: "leave out [stock] and [technology]; the flank does not depend on them".into(),
            };
            Ok(Removal { result: None, remarks: vec![remark] })
        }
        None => {
            let strokes = strokes(prepared, execution, task, partition);
            worked_out(prepared, task, strokes, programs).map_err(|error| refused(&error))
        }
    }
}

/// Why strokes are not worked out.
fn beyond(prepared: &Prepared, execution: &Execution) -> Option<&'static str> {
    let setup = &prepared.setup;
    if !(setup.pair.worm.is_cylindrical() && setup.pair.work.is_cylindrical()) {
        Some("a body is conical")
    } else if Flank::BOTH.iter().any(|&flank| execution.flanks[flank].is_none()) {
        Some("one flank is ground by itself")
    } else if shift_of(execution).is_none() {
        Some("the shift of the worm is not proportional to the feed")
    } else if prepared.cycle.strokes.is_some() {
        Some("some threads of the worm do not grind")
    } else {
        None
    }
}

/// The finishing stroke's shift, where it is straight over the stroke.
fn shift_of(execution: &Execution) -> Option<Shift> {
    straight(&execution.motion.shift, execution.feed_range)
}

/// A law that is straight over a range of the feed.
fn straight(law: &MotionLaw, [from, to]: [f64; 2]) -> Option<Shift> {
    let (start, end) = (law.value(from), law.value(to));
    let ratio = (end - start) / (to - from);
    let holds = (0..=8).all(|k| {
        let v = from + (to - from) * f64::from(k) / 8.0;
        (law.value(v) - start - ratio * (v - from)).abs() < STRAIGHT
    });
    holds.then_some(Shift { ratio, origin: start - ratio * from, step_per_part: 0.0 })
}

fn refused(error: &TechnologyError) -> RunFailure {
    let field = match error {
        TechnologyError::OutOfRange { field, .. } if field.starts_with("life") => "technology.life",
        TechnologyError::OutOfRange { field, .. } if field.starts_with("stock.profile") => "stock.profile",
        TechnologyError::StrokeOrder { .. } => "machine.roughing_stock_um",
        _ => "stock",
    };
    let finding = Diagnostic::new(Problem::InvalidJob, error.to_string()).field(field);
    RunFailure::bad_input(finding.way_out("see docs/job-file.md for what [stock] and [technology] take"))
}

fn worked_out(
    prepared: &Prepared,
    task: &RemovalTask,
    strokes: Vec<Stroke>,
    programs: Option<&ProgramsResult>,
) -> Result<Removal, TechnologyError> {
    let setup = &prepared.setup;
    let roll = Sides::from_fn(|flank| setup.fields[flank].roll());
    let bodies =
        Bodies::new(setup.pair.clone(), setup.largest_tip_radius, setup.input.blank.face_width, roll)?;
    let field = StockField::new(task.stock.clone(), &bodies)?;
    let cycle = Cycle::new(bodies, field, strokes)?;
    let rates: Vec<[Vec<f64>; 2]> = (0..cycle.strokes.len()).map(|k| over_time(&cycle, k)).collect();
    let strokes: Vec<StrokeResult> =
        cycle.strokes.iter().zip(rates).map(|(figures, curve)| stroke_result(figures, curve)).collect();
    let load = worm_load(&cycle, task);
    let life = match (task.life, &load) {
        (Some(of_worm), Some(load)) => Some(life_of(&cycle, prepared, of_worm, load.parts_per_dressing)?),
        _ => None,
    };
    let parts_per_dressing = load.as_ref().map(|load| load.parts_per_dressing);
    let part_time = part_time(task, programs, parts_per_dressing);
    let cost_per_part = match (task.cost, part_time, life, parts_per_dressing) {
        (Some(rates), Some(time), Some(life), Some(parts)) if parts > 0 && life.parts_per_worm > 0.0 => {
            let cost = rates.per_part(time.part_s, parts as f64, life.parts_per_worm)?;
            Some(CostResult {
                machine: cost.machine,
                worm: cost.worm,
                dresser: cost.dresser,
                change: cost.change,
                total: cost.total(),
            })
        }
        _ => None,
    };
    let indicators = indicators(&cycle, task, load.as_ref());
    let result = RemovalResult {
        stock: StockResult {
            volume_mm3: cycle.stock_volume(),
            largest_um: cycle.extent.map(|_, [_, most]| UM * most),
            least_um: cycle.extent.map(|_, [least, _]| UM * least),
        },
        strokes,
        worm_load: load,
        worm_life: life,
        part_time,
        cost_per_part,
        indicators,
    };
    let remarks = remarks(&result, &cycle, programs);
    Ok(Removal { result: Some(result), remarks })
}

/// Roughing, finishing and spark-out as the job has them, in the first area of each kind.
fn strokes(
    prepared: &Prepared,
    execution: &Execution,
    task: &RemovalTask,
    partition: Option<&Partition>,
) -> Vec<Stroke> {
    let technology = &prepared.technology;
    let planned = shift_of(execution).unwrap_or_default();
    let areas = partition.and_then(|partition| partition.tool_areas(prepared, &execution.motion.shift));
    let apart = prepared.cycle.roughing_areas > 0;
    let (finishing, roughing) = match areas.filter(|_| apart) {
        Some(areas) => {
            let by = areas.finishing.first().copied().unwrap_or(0.0);
            let law = areas.roughing.first();
            let rough = law.and_then(|law| straight(law, execution.feed_range)).unwrap_or(planned);
            (Shift { origin: planned.origin + by, ..planned }, rough)
        }
        None => (planned, planned),
    };
    let step_per_part = task.step_per_part;
    let stroke = |left: f64, shift: Shift, zone: &str| Stroke {
        left: Sides::both(left),
        feed_per_revolution: technology.feed_per_revolution,
        cutting_speed: 1e-3 * technology.worm_speed * prepared.setup.largest_tip_radius,
        direction: Direction::Up,
        shift: Shift { step_per_part, ..shift },
        overrun: prepared.cycle.overrun,
        dwell: 0.0,
        zone: zone.into(),
    };
    let zone = |name: &'static str| if apart { name } else { "all" };
    let rough = technology.roughing.iter().map(|&left| stroke(left, roughing, zone("roughing")));
    let fine = (0..=technology.spark_out).map(|_| stroke(0.0, finishing, zone("finishing")));
    rough.chain(fine).collect()
}

/// Times from the first contact on and the removal rate at each.
fn over_time(cycle: &Cycle, k: usize) -> [Vec<f64>; 2] {
    let figures = &cycle.strokes[k];
    let [first, last] = figures.contact;
    let at = |i: usize| first + (last - first) * i as f64 / INTERVALS as f64;
    let time = (0..=INTERVALS).map(|i| (at(i) - first).abs() / figures.feed).collect();
    [time, (0..=INTERVALS).map(|i| cycle.rate(k, at(i))).collect()]
}

fn stroke_result(figures: &grinding_technology::StrokeFigures, [time, rate]: [Vec<f64>; 2]) -> StrokeResult {
    let most = |list: &[f64]| list.iter().copied().fold(0.0, f64::max);
    let left = figures.stroke.left.left;
    StrokeResult {
        stage: match (left > 0.0, figures.volume > 0.0) {
            (true, _) => "roughing",
            (false, true) => "finishing",
            (false, false) => "spark-out",
        },
        left_um: UM * left,
        diagonal_ratio: figures.stroke.shift.ratio,
        infeed_um: UM * figures.infeed.delta_d,
        worm_speed_rpm: RPM * figures.speeds[0],
        work_speed_rpm: RPM * figures.speeds[1],
        feed_mm_per_s: figures.feed,
        sense: match figures.sense {
            Sense::Climb => "climb",
            Sense::Conventional => "conventional",
        },
        contact_mm: figures.contact,
        approach_mm: figures.approach,
        travel_mm: figures.travel,
        volume_mm3: figures.volume,
        largest_rate_mm3_per_s: most(&rate),
        worm_mm: figures.occupation,
        time_s: time,
        rate_mm3_per_s: rate,
        flanks: figures.flanks.map(|_, flank: &FlankStroke| FlankRemovalResult {
            depth_um: UM * flank.deepest,
            contact_length_mm: most(&flank.contact_length),
            contact_area_mm2: flank.contact_area,
            specific_rate_mm3_per_mm_s: most(&flank.rate_bound),
            chip_thickness_um: UM * flank.chip_thickness,
            passage_um: UM * most(&flank.passage),
        }),
    }
}

fn worm_load(cycle: &Cycle, task: &RemovalTask) -> Option<WormLoadResult> {
    let (finishing, width) = (task.loads.finishing?, task.zone_width?);
    let level = cycle.level(&ZoneLimits {
        zone_width: width,
        zone_gap: task.zone_gap,
        allowed_roughing: task.loads.roughing.unwrap_or(finishing),
        allowed_finishing: finishing,
    });
    let by_width = cycle.parts_by_width(width);
    let wear = cycle.wear();
    let by_shift = wear.parts_by_map(by_width, finishing);
    let by_load = level.parts;
    let maps = wear.after(by_shift.max(1));
    let [left, right] = [maps.left.ends(), maps.right.ends()];
    let (from, to) = (left[0].min(right[0]), left[1].max(right[1]));
    let removed = maps.map(|_, map| {
        let most = |bin: i64| (0..STATIONS).map(|station| map.value(station, bin)).fold(0.0, f64::max);
        (from..to).map(most).collect()
    });
    Some(WormLoadResult {
        parts_by_load: by_load,
        parts_by_width: match by_width {
            WidthUse::Parts(parts) => Some(parts),
            WidthUse::Unbounded => None,
        },
        parts_per_dressing: by_shift,
        from_mm: from as f64,
        removed_mm3_per_mm: removed,
    })
}

fn life_of(
    cycle: &Cycle,
    prepared: &Prepared,
    [last_tip_diameter, radial_per_dressing]: [f64; 2],
    parts_per_dressing: usize,
) -> Result<WormLifeResult, TechnologyError> {
    let bodies = &cycle.bodies;
    let tip_radius = bodies.worm_tip_radius;
    let life = WormLife {
        first_tip_diameter: 2.0 * tip_radius,
        last_tip_diameter,
        radial_per_dressing,
        cutting_speed: 1e-3 * prepared.technology.worm_speed * tip_radius,
        largest_worm_speed: NO_LIMIT,
        largest_work_speed: NO_LIMIT,
        // How the parts change with the diameter is all that is asked.
        allowed: 1.0,
        zone_width: 1.0,
        section_per_part: 1.0,
    }
    .rows(bodies)?;
    let (first, last) = match life.rows.as_slice() {
        [first, .., last] => (first, last),
        [only] => (only, only),
        [] => unreachable!("a life has at least its first state"),
    };
    Ok(WormLifeResult {
        dressings: life.rows.len(),
        parts_per_worm: life
            .rows
            .iter()
            .map(|row| (parts_per_dressing as f64 * row.parts / first.parts).floor())
            .sum(),
        crossed_axes_angle_deg: [first, last].map(|row| row.crossed_axes_angle.to_degrees()),
        worm_speed_rpm: [first, last].map(|row| RPM * row.worm_speed),
    })
}

/// Programs of one control, "dressing" or "grinding": those of all controls say the same motion.
fn of_one_control<'a>(
    programs: &'a ProgramsResult,
    station: &'static str,
) -> impl Iterator<Item = &'a ProgramResult> {
    let control = programs.programs.first().map(|program| program.control);
    programs.programs.iter().filter(move |program| Some(program.control) == control && program.job == station)
}

fn part_time(
    task: &RemovalTask,
    programs: Option<&ProgramsResult>,
    parts_per_dressing: Option<usize>,
) -> Option<PartTimeResult> {
    let (times, programs) = (task.times?, programs?);
    let of_station = |station: &'static str| {
        of_one_control(programs, station).map(|program| program.duration_s).sum::<f64>()
    };
    let (grinding_s, dressing_s) = (of_station("grinding"), of_station("dressing"));
    let parts = parts_per_dressing.filter(|parts| *parts > 0)?;
    let dressing_per_part_s = (dressing_s + times.dressing_aux) / parts as f64;
    let auxiliary_s = times.load + times.index + times.other;
    let part_s = grinding_s + dressing_per_part_s + auxiliary_s;
    Some(PartTimeResult { grinding_s, dressing_s, dressing_per_part_s, auxiliary_s, part_s })
}

fn indicators(cycle: &Cycle, task: &RemovalTask, load: Option<&WormLoadResult>) -> Vec<IndicatorResult> {
    let rate = |roughing: bool| {
        let strokes = cycle.strokes.iter().filter(|figures| (figures.stroke.left.left > 0.0) == roughing);
        let flanks = strokes.flat_map(|figures| [&figures.flanks.left, &figures.flanks.right]);
        flanks.flat_map(|flank| flank.rate_bound).fold(0.0, f64::max)
    };
    let mut found = Vec::new();
    let mut add = |limit: &'static str, value: f64, allowed: Option<f64>| {
        if let Some(allowed) = allowed {
            found.push(IndicatorResult { limit, value, allowed, share: value / allowed });
        }
    };
    add("technology.limits.Qw_roughing", rate(true), task.rates.roughing);
    add("technology.limits.Qw_finishing", rate(false), task.rates.finishing);
    if let Some(load) = load {
        let removed = &load.removed_mm3_per_mm;
        let most = removed.left.iter().chain(&removed.right).copied().fold(0.0, f64::max);
        add("technology.limits.Vw_finishing", most, task.loads.finishing);
    }
    found
}

fn remarks(result: &RemovalResult, cycle: &Cycle, programs: Option<&ProgramsResult>) -> Vec<Remark> {
    let mut remarks = Vec::new();
    for (flank, &least) in result.stock.least_um.iter() {
        if least <= 0.0 {
            remarks.push(Remark {
                code: "no-stock",
                text: format!(
                    "material is missing on the {flank} flank, up to {:.1} um: it does not clean up there",
                    -least
                ),
                way_out: "raise stock.allowance_um, or centre the blank".into(),
            });
        }
    }
    for (k, stroke) in result.strokes.iter().enumerate() {
        if stroke.volume_mm3 <= 0.0 && stroke.left_um > 0.0 {
            remarks.push(Remark {
                code: "stroke-cuts-air",
                text: format!(
                    "stroke {} leaves {:.1} um, which is more than the stock: it takes nothing",
                    k + 1,
                    stroke.left_um
                ),
                way_out: "take it out of machine.roughing_stock_um, or raise stock.allowance_um".into(),
            });
        }
    }
    for indicator in result.indicators.iter().filter(|indicator| indicator.share > 1.0) {
        remarks.push(Remark {
            code: "limit-exceeded",
            text: format!(
                "{} = {} is exceeded: {} ({:.0} % of it). The limit is the shop's own; the figure says harder than what it calls safe, not burnt",
                indicator.limit,
                shown_number(indicator.allowed),
                shown_number((indicator.value * 1e3).round() / 1e3),
                100.0 * indicator.share
            ),
            way_out: "spread the stock over more strokes, lower the feed, or dress sooner".into(),
        });
    }
    remarks.extend(short_approach(cycle, programs));
    remarks
}

/// A worm that comes in when it should grind already plunges into the end of the teeth.
fn short_approach(cycle: &Cycle, programs: Option<&ProgramsResult>) -> Option<Remark> {
    let programs = programs?;
    let passes: Vec<_> = of_one_control(programs, "grinding").flat_map(|program| &program.passes).collect();
    if passes.len() != cycle.strokes.len() {
        return None;
    }
    let missing = |(figures, driven): (&grinding_technology::StrokeFigures, [f64; 2])| {
        if figures.volume > 0.0 { driven[0] - figures.contact[0] } else { 0.0 }
    };
    let short =
        cycle.strokes.iter().zip(passes.iter().map(|pass| pass.driven_mm)).map(missing).fold(0.0, f64::max);
    (short > 0.0).then(|| Remark {
        code: "approach-too-short",
        text: format!(
            "contact begins before the worm has come in: it plunges into the end of the teeth, {short:.1} mm of way are missing"
        ),
        way_out: format!("raise grinding.overrun by {:.1} mm, or spread the stock over more strokes", short.ceil()),
    })
}
