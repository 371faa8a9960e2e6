//! `[stock]` and `[technology]` of a job: stock on the flanks, strokes, limits, times and rates, typed and in mm and s.

use super::Cycle;
use super::stock::{StockOnGear, stock_of_job};
use crate::job::{
    CycleRule, DressingRotation, FeedDirection, Job, LoadedJob, StrokeOfJob, StrokeZone, TechnologyLimits,
};
use crate::workflow::programs::Technology;
use foundation::geometry::Sides;
use generating::GrindingSetup;
use grinding_technology::{Direction, PartTimes, Rates, Rotation, Stock};
use job::{Diagnostic, Problem, shown_number};
use run::RunFailure;
use std::f64::consts::TAU;

const UM: f64 = 1e-3;
/// Speeds are equal within this share.
const ROUNDING: f64 = 1e-9;
/// Between areas for roughing and finishing where a job gives nothing, mm.
const ZONE_GAP: f64 = 2.0;

/// A limit of the shop for roughing and for finishing strokes; `None` where it gives none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ShopLimit {
    /// Strokes that leave something.
    pub roughing: Option<f64>,
    /// Strokes that leave nothing.
    pub finishing: Option<f64>,
}

/// Which strokes a part gets.
#[derive(Clone, Debug)]
pub enum StrokesWanted {
    /// Those of `[machine]`.
    OfMachine,
    /// The standard cycle where one keeps the limits, else those of `[machine]`.
    Offered,
    /// By a rule within the limits.
    Rule(CycleRule),
    /// Those of the job.
    Listed(Vec<WantedStroke>),
}

/// A stroke of the job. mm, s.
#[derive(Clone, Debug)]
pub struct WantedStroke {
    /// Stock left on each flank.
    pub left: Sides<f64>,
    /// Feed per workpiece revolution.
    pub feed_per_revolution: f64,
    /// At the worm's tip, m/s.
    pub cutting_speed: f64,
    /// Sense of the feed.
    pub direction: Direction,
    /// Diagonal ratio and shift at z_V2 = 0 where they are not those of the plan.
    pub ratio: Option<f64>,
    /// The same.
    pub origin: Option<f64>,
    /// Jump from part to part.
    pub step_per_part: f64,
    /// Way beyond first and last contact.
    pub overrun: f64,
    /// Pause after it.
    pub dwell: f64,
    /// Area of the worm.
    pub zone: Option<StrokeZone>,
}

/// What bounds the cycles that a rule may choose. mm.
#[derive(Clone, Copy, Debug)]
pub struct CycleLimits {
    /// Height of the feed marks of finishing.
    pub feed_mark: f64,
    /// Least and largest feed per workpiece revolution.
    pub feed: [f64; 2],
    /// Least and largest depth of finishing.
    pub finishing: [f64; 2],
    /// Most roughing strokes.
    pub most_roughing_strokes: usize,
}

/// Defaults of [`CycleLimits`].
const FEED_MARK_UM: f64 = 0.5;
const FEED: [f64; 2] = [0.02, 1.2];
const FINISHING_UM: [f64; 2] = [10.0, 50.0];
const MOST_ROUGHING: u32 = 4;

impl CycleLimits {
    fn of_job(limits: &TechnologyLimits) -> Self {
        Self {
            feed_mark: UM * limits.feed_mark_um.unwrap_or(FEED_MARK_UM),
            feed: [limits.least_feed.unwrap_or(FEED[0]), limits.largest_feed.unwrap_or(FEED[1])],
            finishing: [
                UM * limits.least_finishing_um.unwrap_or(FINISHING_UM[0]),
                UM * limits.most_finishing_um.unwrap_or(FINISHING_UM[1]),
            ],
            most_roughing_strokes: limits.most_roughing_strokes.unwrap_or(MOST_ROUGHING) as usize,
        }
    }
}

/// Speeds that nothing exceeds.
#[derive(Clone, Copy, Debug, Default)]
pub struct SpeedLimits {
    /// Periphery of the wheel, m/s.
    pub wheel: Option<f64>,
    /// Worm and workpiece, 1/s.
    pub worm: Option<f64>,
    /// The same.
    pub work: Option<f64>,
}

/// The last dressing stroke. mm.
#[derive(Clone, Copy, Debug)]
pub struct DressingWanted {
    /// Taken from the flank.
    pub depth: f64,
    /// At the contact.
    pub rotation: Rotation,
    /// Overlap that the shop asks for.
    pub least_overlap: Option<f64>,
}

/// What a job asks beside the flank.
#[derive(Clone, Debug)]
pub struct RemovalTask {
    /// On the flanks.
    pub stock: Stock,
    /// Tooth spaces that the table of the stock does not have, on the flank that lacks most.
    pub spaces_left_out: usize,
    /// How the worm is dressed; `None` where the job does not say.
    pub dressing: Option<DressingWanted>,
    /// Strokes of a part.
    pub strokes: StrokesWanted,
    /// What bounds them where a rule chooses.
    pub cycle_limits: CycleLimits,
    /// Height of the feed marks of finishing, where the shop bounds it, mm.
    pub feed_mark: Option<f64>,
    /// Speeds.
    pub speeds: SpeedLimits,
    /// Of the worm, mm; `None` for one without a stated width.
    pub worm_width: Option<f64>,
    /// Q'_w, mm^3/(mm s).
    pub rates: ShopLimit,
    /// V'_w between two dressings, mm^3/mm.
    pub loads: ShopLimit,
    /// Used between two dressings, mm; `None` for a worm without a stated width.
    pub zone_width: Option<f64>,
    /// Between roughing and finishing, mm.
    pub zone_gap: f64,
    /// Jump from part to part, mm.
    pub step_per_part: f64,
    /// Times of a part beside grinding.
    pub times: Option<PartTimes>,
    /// Last tip diameter and what a dressing takes of the radius, mm.
    pub life: Option<[f64; 2]>,
    /// The shop's rates.
    pub cost: Option<Rates>,
}

impl RemovalTask {
    /// Of a job; `None` without stock.
    ///
    /// # Errors
    /// A finding on `stock` for diameters below a base circle, tables that cannot be read, a hob that makes no gear; on speeds beyond
    /// their limits.
    pub(super) fn of_job(
        loaded: &LoadedJob,
        setup: &GrindingSetup,
        (cycle, machine): (&Cycle, &Technology),
    ) -> Result<Option<Self>, RunFailure> {
        let job = &loaded.job;
        let Some(given) = job.stock.as_ref() else { return Ok(None) };
        let StockOnGear { stock, spaces_left_out } = stock_of_job(loaded, given, setup)?;
        let technology = job.technology.clone().unwrap_or_default();
        let limits = technology.limits;
        let step_per_part = technology.step_per_part.unwrap_or(0.0);
        let tip_radius = setup.largest_tip_radius;
        let strokes = match strokes_of_job(job, (cycle, machine), (tip_radius, step_per_part)) {
            Some(listed) => StrokesWanted::Listed(listed),
            None => unlisted_strokes(job),
        };
        let speeds = SpeedLimits {
            wheel: limits.wheel_speed_m_per_s,
            worm: limits.worm_speed_rpm.map(|rpm| rpm / 60.0),
            work: limits.work_speed_rpm.map(|rpm| rpm / 60.0),
        };
        speeds.check(job, (machine, tip_radius), &strokes)?;
        Ok(Some(Self {
            stock,
            spaces_left_out,
            dressing: technology.dressing.map(|given| DressingWanted {
                depth: UM * given.depth_um,
                rotation: match given.rotation {
                    Some(DressingRotation::Opposite) => Rotation::Opposite,
                    Some(DressingRotation::Same) | None => Rotation::Same,
                },
                least_overlap: given.least_overlap,
            }),
            strokes,
            cycle_limits: CycleLimits::of_job(&limits),
            feed_mark: limits.feed_mark_um.map(|um| UM * um),
            speeds,
            worm_width: job.worm.width,
            rates: ShopLimit { roughing: limits.Qw_roughing, finishing: limits.Qw_finishing },
            loads: ShopLimit { roughing: limits.Vw_roughing, finishing: limits.Vw_finishing },
            zone_width: limits.zone_width.or(job.worm.width),
            zone_gap: limits.zone_gap.unwrap_or(ZONE_GAP),
            step_per_part,
            times: technology.times.map(|times| PartTimes {
                load: times.load_s,
                index: times.index_s,
                other: times.other_s,
                dressing_aux: times.dressing_aux_s,
            }),
            life: technology.life.map(|life| [life.last_tip_diameter, life.radial_per_dressing]),
            cost: technology.cost.map(|cost| Rates {
                machine_per_hour: cost.machine_per_hour,
                worm_price: cost.worm_price,
                worm_change: 60.0 * cost.worm_change_min,
                dresser_price: cost.dresser_price,
                dressings_per_dresser: f64::from(cost.dressings_per_dresser),
            }),
        }))
    }
}

/// The strokes that a job lists.
fn strokes_of_job(
    job: &Job,
    (cycle, machine): (&Cycle, &Technology),
    (tip_radius, step_per_part): (f64, f64),
) -> Option<Vec<WantedStroke>> {
    let technology = job.technology.as_ref().filter(|technology| !technology.strokes.is_empty())?;
    let usual = machine.finishing();
    let stroke = |given: &StrokeOfJob| {
        let shift = given.shift.unwrap_or_default();
        WantedStroke {
            left: given.left_um.sides().map(|_, um| UM * um),
            feed_per_revolution: given.feed_per_revolution.unwrap_or(usual.feed_per_revolution),
            cutting_speed: given.cutting_speed_m_per_s.unwrap_or(machine.cutting_speed(tip_radius)),
            direction: match given.direction {
                Some(FeedDirection::Down) => Direction::Down,
                Some(FeedDirection::Up) | None => Direction::Up,
            },
            ratio: shift.ratio,
            origin: shift.origin,
            step_per_part: shift.step_per_part.unwrap_or(step_per_part),
            overrun: given.overrun.unwrap_or(cycle.overrun),
            dwell: given.dwell_s.unwrap_or(0.0),
            zone: given.zone,
        }
    };
    Some(technology.strokes.iter().map(stroke).collect())
}

/// Where strokes come from that a job does not list.
fn unlisted_strokes(job: &Job) -> StrokesWanted {
    let technology = job.technology.as_ref();
    if let Some(rule) = technology.and_then(|technology| technology.cycle) {
        return StrokesWanted::Rule(rule);
    }
    let limits = technology.map(|technology| technology.limits).unwrap_or_default();
    let limited = limits.Qw_roughing.is_some() && limits.Qw_finishing.is_some();
    let said = job
        .machine
        .as_ref()
        .is_some_and(|machine| !machine.roughing_stock_um.is_empty() || machine.spark_out > 0);
    if limited && !said && job.grinding.feed_per_revolution.is_none() {
        StrokesWanted::Offered
    } else {
        StrokesWanted::OfMachine
    }
}

/// A speed that limits are held against.
struct Limited {
    /// The key that gives it; `None` where it is a default.
    key: Option<String>,
    /// Of the worm's tip, m/s.
    speed: f64,
    /// Whether the workpiece turns with the worm.
    grinds: bool,
}

impl SpeedLimits {
    /// Speeds of the job against its limits.
    fn check(
        &self,
        job: &Job,
        (machine, tip_radius): (&Technology, f64),
        strokes: &StrokesWanted,
    ) -> Result<(), RunFailure> {
        let given = job.machine.as_ref();
        let usual = given.and_then(|machine| machine.cutting_speed_m_per_s);
        let usual = usual.map(|_| "machine.cutting_speed_m_per_s".to_owned());
        let mut speeds: Vec<Limited> = match strokes {
            StrokesWanted::Listed(strokes) => {
                let own = job.technology.iter().flat_map(|technology| &technology.strokes);
                let of_stroke = |(k, (stroke, own)): (usize, (&WantedStroke, &StrokeOfJob))| {
                    let key = own.cutting_speed_m_per_s;
                    let key = key.map(|_| format!("technology.strokes[{k}].cutting_speed_m_per_s"));
                    Limited { key: key.or(usual.clone()), speed: stroke.cutting_speed, grinds: true }
                };
                strokes.iter().zip(own).enumerate().map(of_stroke).collect()
            }
            StrokesWanted::OfMachine | StrokesWanted::Offered | StrokesWanted::Rule(_) => {
                vec![Limited { key: usual, speed: machine.cutting_speed(tip_radius), grinds: true }]
            }
        };
        let dressing = given.and_then(|machine| machine.dressing_worm_speed_rpm);
        speeds.push(Limited {
            key: dressing.map(|_| "machine.dressing_worm_speed_rpm".to_owned()),
            speed: 1e-3 * machine.dressing_speed * tip_radius,
            grinds: false,
        });
        let per_turn = 1e-3 * TAU * tip_radius;
        let work_per_worm = f64::from(job.worm.threads) / f64::from(job.gear.teeth.unsigned_abs());
        for limited in speeds {
            // Each limit as a speed of the worm's tip.
            let limits = [
                ("wheel_speed_m_per_s", self.wheel, 1.0),
                ("worm_speed_rpm", self.worm, per_turn),
                ("work_speed_rpm", self.work.filter(|_| limited.grinds), per_turn / work_per_worm),
            ];
            for (name, limit, tip_speed) in limits {
                let most = limit.map(|limit| limit * tip_speed);
                if let Some(most) = most.filter(|most| limited.speed > most * (1.0 + ROUNDING)) {
                    return Err(RunFailure::bad_input(limited.refused(name, (most, tip_speed, per_turn))));
                }
            }
        }
        Ok(())
    }
}

impl Limited {
    /// The finding on its key, or on that of the limit where it is a default.
    fn refused(&self, name: &str, (most, tip_speed, per_turn): (f64, f64, f64)) -> Diagnostic {
        let limit = format!("technology.limits.{name}");
        let three = |value: f64| shown_number((1e3 * value).round() / 1e3);
        let what = if self.grinds { "grinding" } else { "dressing" };
        let text = format!(
            "{what} at {} m/s of the worm's tip ({} 1/min) is faster than {limit} allows",
            three(self.speed),
            three(60.0 * self.speed / per_turn)
        );
        let finding = Diagnostic::new(Problem::InvalidNumber, text);
        // Limits of spindles are stated in 1/min, a dressing speed as well.
        let unit = if name.ends_with("rpm") { 60.0 } else { 1.0 };
        let finding = match &self.key {
            Some(key) if key.ends_with("rpm") => {
                let rpm = 60.0 / per_turn;
                finding
                    .field(key.clone())
                    .value(three(self.speed * rpm))
                    .allowed(format!("up to {} 1/min", three(most * rpm)))
            }
            Some(key) => finding
                .field(key.clone())
                .value(three(self.speed))
                .allowed(format!("up to {} m/s", three(most))),
            None => finding
                .field(limit)
                .value(three(unit * most / tip_speed))
                .allowed(format!("{} or more for the default speed", three(unit * self.speed / tip_speed))),
        };
        finding.way_out("lower the speed, or raise the limit if wheel and spindle allow it")
    }
}
