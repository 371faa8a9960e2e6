//! Cycles within the shop's limits: roughing strokes of equal thickness with one feed, then one finishing stroke. The fastest of them, and the
//! one that a rule of thumb offers, the cheapest by the shop's rates.

use super::cost::CostGoal;
use super::cycle::contact_feeds;
use super::error::{in_range, positive};
use super::level::ZoneLimits;
use super::time::{Axes, Driven};
use super::{Bodies, Direction, Ground, STATIONS, TechnologyError};
use foundation::geometry::Sides;
use foundation::numerics::{equidistant, golden_section};
use rayon::prelude::*;

/// Depths of finishing that are looked at before the best is refined, and steps of that.
const SCANNED: usize = 161;
const REFINED: usize = 40;
/// The rule of thumb: finishing takes this share of the stock, and so many roughing strokes are made that they feed at least as much per
/// workpiece revolution, mm.
const USUAL_FINISHING: f64 = 0.25;
const USUAL_FEED: f64 = 0.2;
/// Factors on both limits of Q'_w for the picture of time, load and parts.
const FACTORS: [f64; 5] = [0.5, 0.7, 1.0, 1.4, 2.0];

/// Limits and figures of the search. mm, s.
#[derive(Clone, Debug, PartialEq)]
pub struct OptimumTask {
    /// What grinds by itself, one after the other: both flanks, one, or each with strokes of its own.
    pub passes: Vec<Ground>,
    /// Stock on each flank, mm.
    pub stock: f64,
    /// m/s.
    pub cutting_speed: f64,
    /// Feed per workpiece revolution, mm.
    pub least_feed: f64,
    /// The same.
    pub largest_feed: f64,
    /// Largest height of the feed marks of finishing, mm.
    pub feed_mark: f64,
    /// Largest Q'_w of roughing, mm^3/(mm s).
    pub rate_roughing: f64,
    /// The same of finishing.
    pub rate_finishing: f64,
    /// Depth of finishing, mm.
    pub least_finishing: f64,
    /// The same.
    pub most_finishing: f64,
    /// Roughing strokes, at most.
    pub most_roughing_strokes: usize,
    /// Diagonal ratio of roughing.
    pub ratio_roughing: f64,
    /// Diagonal ratio of finishing.
    pub ratio_finishing: f64,
    /// Way beyond first and last contact, each, mm.
    pub overrun: f64,
    /// Way of the infeed, mm.
    pub clearance: f64,
    /// Times beside grinding, s.
    pub auxiliary: f64,
    /// Between two strokes, s.
    pub between_strokes: f64,
    /// One dressing, s.
    pub dressing: f64,
    /// What time and dressings cost, where the cheapest cycle is wanted.
    pub cost: Option<CostGoal>,
    /// Zones of the worm.
    pub zones: ZoneLimits,
}

/// What is to be least.
#[derive(Clone, Copy)]
enum Goal {
    Time,
    Cost(CostGoal),
}

impl Goal {
    fn of(self, cycle: &BestCycle) -> f64 {
        match self {
            Self::Time => cycle.time,
            Self::Cost(cost) => cost.per_part(cycle.time, cycle.parts),
        }
    }

    fn of_row(self, row: &OptimumRow) -> f64 {
        row.cycle.map_or(f64::INFINITY, |cycle| self.of(&cycle))
    }

    /// The best row; the first one where none keeps the limits.
    fn best(self, rows: &[OptimumRow]) -> Option<OptimumRow> {
        rows.iter().copied().min_by(|a, b| self.of_row(a).total_cmp(&self.of_row(b)))
    }
}

/// A cycle at its best for one number of roughing strokes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BestCycle {
    /// Depth of finishing, mm.
    pub finishing: f64,
    /// Feeds per workpiece revolution of roughing (0 without) and finishing, mm.
    pub feeds: [f64; 2],
    /// Time of a part with its share of dressing, s.
    pub time: f64,
    /// Parts between two dressings, not whole.
    pub parts: f64,
    /// Largest Q'_w of roughing (0 without) and finishing, mm^3/(mm s).
    pub rates: [f64; 2],
    /// Height of the feed marks of finishing, mm.
    pub feed_mark: f64,
}

/// One row of the table or of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OptimumRow {
    /// Factor on both limits of Q'_w.
    pub limit_factor: f64,
    /// Roughing strokes.
    pub roughing_strokes: usize,
    /// `None` where no cycle keeps the limits.
    pub cycle: Option<BestCycle>,
}

/// The fastest cycle, what each number of roughing strokes comes to, and how time goes with the load.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// The fastest.
    pub best: OptimumRow,
    /// The cheapest, where costs are given.
    pub cheapest: Option<OptimumRow>,
    /// By the rule of thumb: a quarter of the stock for finishing, the fewest roughing strokes that feed 0.2 mm per revolution, every feed at
    /// its limit.
    pub standard: OptimumRow,
    /// By the number of roughing strokes.
    pub by_roughing_strokes: Vec<OptimumRow>,
    /// By the load.
    pub pareto: Vec<OptimumRow>,
}

/// What the search needs of the bodies.
struct Figures<'a> {
    task: &'a OptimumTask,
    bodies: &'a Bodies,
    axes: &'a Axes,
    curvature: Sides<[f64; STATIONS]>,
    /// G': Q'_w per feed and depth.
    rate: f64,
    /// Largest M times b, mm^2.
    wear: f64,
    /// Largest feed for the feed marks, mm.
    by_mark: f64,
    largest_curvature: f64,
}

impl OptimumTask {
    fn check(&self) -> Result<(), TechnologyError> {
        for (field, value) in [
            ("optimise.stock_um", 1e3 * self.stock),
            ("optimise.cutting_speed_m_per_s", self.cutting_speed),
            ("optimise.least_feed", self.least_feed),
            ("optimise.feed_mark_um", 1e3 * self.feed_mark),
            ("optimise.Qw_roughing", self.rate_roughing),
            ("optimise.Qw_finishing", self.rate_finishing),
            ("optimise.least_finishing_um", 1e3 * self.least_finishing),
            ("optimise.zone_width", self.zones.zone_width),
            ("optimise.allowed_Vw_roughing", self.zones.allowed_roughing),
            ("optimise.allowed_Vw_finishing", self.zones.allowed_finishing),
        ] {
            positive(field, value)?;
        }
        for (field, value) in [
            ("optimise.overrun", self.overrun),
            ("optimise.clearance", self.clearance),
            ("optimise.auxiliary_s", self.auxiliary),
            ("optimise.between_strokes_s", self.between_strokes),
            ("optimise.dressing_s", self.dressing),
        ] {
            in_range(field, value, value >= 0.0, ">= 0")?;
        }
        let passes = self.passes.len();
        in_range("optimise.passes", passes as f64, passes > 0, "at least one")?;
        for (field, value) in
            [("optimise.K_roughing", self.ratio_roughing), ("optimise.K_finishing", self.ratio_finishing)]
        {
            in_range(field, value, true, "a finite number")?;
        }
        let above = |least: f64| format!(">= {least}");
        let (feed, finishing, gap) = (self.largest_feed, 1e3 * self.most_finishing, self.zones.zone_gap);
        in_range("optimise.largest_feed", feed, feed >= self.least_feed, &above(self.least_feed))?;
        let least = 1e3 * self.least_finishing;
        in_range("optimise.most_finishing_um", finishing, finishing >= least, &above(least))?;
        let narrow = format!(">= 0 and below zone_width = {}", self.zones.zone_width);
        in_range("optimise.zone_gap", gap, gap >= 0.0 && gap < self.zones.zone_width, &narrow)?;
        Ok(())
    }

    /// The fastest cycle on these bodies and axes.
    ///
    /// # Errors
    /// `OutOfRange`; `NoFeasiblePlan` with the limit that binds and the value that would do.
    pub fn solve(&self, bodies: &Bodies, axes: &Axes) -> Result<Optimum, TechnologyError> {
        self.check()?;
        axes.check()?;
        let curvature = Sides::from_fn(|flank| {
            bodies.flanks[flank].stations().map(|w| bodies.flanks[flank].gap_curvature(w))
        });
        let ground = || self.passes.iter().flat_map(|pass| pass.flanks());
        let largest_curvature = bodies.largest(ground(), |engagement, w| engagement.gap_curvature(w));
        let density = bodies
            .largest(ground(), |engagement, w| engagement.area_density(w) / engagement.profile_width(w));
        let figures = Figures {
            task: self,
            bodies,
            axes,
            curvature,
            rate: bodies.threads() * bodies.speeds(self.cutting_speed)[0] * density,
            wear: bodies.face_width * bodies.largest(ground(), |engagement, w| engagement.wear_factor(w)),
            by_mark: (8.0 * self.feed_mark / largest_curvature).sqrt(),
            largest_curvature,
        };
        let table = |goal: Goal, limit_factor: f64| -> Vec<OptimumRow> {
            (0..=self.most_roughing_strokes)
                .into_par_iter()
                .map(|roughing_strokes| OptimumRow {
                    limit_factor,
                    roughing_strokes,
                    cycle: figures.best(goal, roughing_strokes, limit_factor),
                })
                .collect()
        };
        let by_roughing_strokes = table(Goal::Time, 1.0);
        let best = Goal::Time.best(&by_roughing_strokes).filter(|row| row.cycle.is_some());
        let best = best.ok_or_else(|| figures.infeasible())?;
        let cheapest = self.cost.map(Goal::Cost).and_then(|goal| goal.best(&table(goal, 1.0)));
        let pareto =
            FACTORS.into_iter().filter_map(|factor| Goal::Time.best(&table(Goal::Time, factor))).collect();
        let standard = figures.standard().unwrap_or(best);
        Ok(Optimum { best, cheapest, standard, by_roughing_strokes, pareto })
    }
}

impl Figures<'_> {
    /// The best depth of finishing for a number of roughing strokes.
    fn best(&self, goal: Goal, roughing: usize, factor: f64) -> Option<BestCycle> {
        if roughing == 0 {
            return self.at(0, factor, self.task.stock);
        }
        // Something is left for roughing.
        let most = self.task.most_finishing.min(self.task.stock * (1.0 - 1e-9));
        let least = self.task.least_finishing;
        if least > most {
            return None;
        }
        let value = |finishing: f64| {
            self.at(roughing, factor, finishing).map_or(f64::INFINITY, |cycle| goal.of(&cycle))
        };
        let scanned = equidistant([least, most], SCANNED);
        let values: Vec<f64> = scanned.iter().map(|&finishing| value(finishing)).collect();
        let place = (0..scanned.len()).min_by(|a, b| values[*a].total_cmp(&values[*b]))?;
        let [from, to] = [place.saturating_sub(1), (place + 1).min(scanned.len() - 1)].map(|k| scanned[k]);
        let refined = golden_section(from, to, REFINED, value);
        let better = if value(refined) < values[place] { refined } else { scanned[place] };
        self.at(roughing, factor, better)
    }

    /// The cycle of the rule of thumb; where its depths leave too little feed, that of the most strokes that keep the limits.
    fn standard(&self) -> Option<OptimumRow> {
        let task = self.task;
        let finishing = (USUAL_FINISHING * task.stock).clamp(task.least_finishing, task.most_finishing);
        let row = |roughing_strokes: usize| {
            let finishing = if roughing_strokes == 0 { task.stock } else { finishing };
            let cycle = self.at(roughing_strokes, 1.0, finishing)?;
            Some(OptimumRow { limit_factor: 1.0, roughing_strokes, cycle: Some(cycle) })
        };
        // What finishing takes by itself needs no roughing.
        let least = usize::from(task.stock > finishing);
        let rows: Vec<OptimumRow> = (least..=task.most_roughing_strokes).filter_map(row).collect();
        let usual = |row: &&OptimumRow| {
            row.roughing_strokes == 0 || row.cycle.is_some_and(|cycle| cycle.feeds[0] >= USUAL_FEED)
        };
        rows.iter().find(usual).or(rows.last()).copied()
    }

    /// The cycle with the largest feeds for a depth of finishing; `None` where one is below the least.
    fn at(&self, roughing: usize, factor: f64, finishing: f64) -> Option<BestCycle> {
        let task = self.task;
        let feed_finishing =
            task.largest_feed.min(factor * task.rate_finishing / (self.rate * finishing)).min(self.by_mark);
        let depth = if roughing > 0 { (task.stock - finishing) / roughing as f64 } else { 0.0 };
        let feed_roughing = if roughing > 0 {
            task.largest_feed.min(factor * task.rate_roughing / (self.rate * depth))
        } else {
            0.0
        };
        if feed_finishing < task.least_feed || roughing > 0 && feed_roughing < task.least_feed {
            return None;
        }
        let rough = (1..=roughing)
            .map(|i| self.stroke(task.stock - depth * i as f64, depth, feed_roughing, task.ratio_roughing));
        let strokes = rough.sum::<f64>() + self.stroke(0.0, finishing, feed_finishing, task.ratio_finishing);
        let taken = (roughing > 0).then_some(self.wear * (task.stock - finishing));
        let parts = task.zones.parts(taken, self.wear * finishing);
        let between = task.between_strokes * (task.passes.len() * (roughing + 1) - 1) as f64;
        Some(BestCycle {
            finishing,
            feeds: [feed_roughing, feed_finishing],
            time: task.auxiliary + strokes + between + task.dressing / parts,
            parts,
            rates: [self.rate * feed_roughing * depth, self.rate * feed_finishing * finishing],
            feed_mark: self.largest_curvature * feed_finishing * feed_finishing / 8.0,
        })
    }

    /// Time of one stroke of every pass that leaves `left` after a depth of cut, s.
    fn stroke(&self, left: f64, depth: f64, feed: f64, ratio: f64) -> f64 {
        self.task.passes.iter().map(|&pass| self.stroke_of(pass, [left, depth], feed, ratio)).sum()
    }

    fn stroke_of(&self, pass: Ground, [left, depth]: [f64; 2], feed: f64, ratio: f64) -> f64 {
        let infeed = self.bodies.stand_off(pass, Sides::both(left));
        let flanks = pass.flanks().map(|flank| {
            let raised = self.bodies.flanks[flank].raised(infeed.delta_d)[1];
            (flank, raised, self.curvature[flank].map(|h| (2.0 * depth / h).sqrt()))
        });
        let [first, last] = contact_feeds(self.bodies, Direction::Up, flanks);
        let driven = Driven {
            feed: feed * self.bodies.speeds(self.task.cutting_speed)[1],
            per_revolution: feed,
            ratio,
            sign: Direction::Up.sign(),
            travel: (last - first).abs() + 2.0 * self.task.overrun,
        };
        driven.time(self.bodies, self.axes, self.task.clearance).total
    }

    /// Why no number of roughing strokes will do: the limit that leaves the least feed at the shallowest cuts.
    fn infeasible(&self) -> TechnologyError {
        let task = self.task;
        let finishing = task.least_finishing.min(task.stock);
        let most = task.most_roughing_strokes;
        let depth = if most > 0 { (task.stock - finishing) / most as f64 } else { 0.0 };
        let finishing = if most > 0 { finishing } else { task.stock };
        let least = task.least_feed;
        let mut limits = vec![
            (
                "optimise.Qw_finishing",
                task.rate_finishing / (self.rate * finishing),
                least * self.rate * finishing,
            ),
            ("optimise.feed_mark_um", self.by_mark, 1e3 * self.largest_curvature * least * least / 8.0),
        ];
        if depth > 0.0 {
            let roughing = task.rate_roughing / (self.rate * depth);
            limits.push(("optimise.Qw_roughing", roughing, least * self.rate * depth));
        }
        let binding = limits.into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
        let (limit, feed, needed) = binding.unwrap_or(("optimise.least_feed", 0.0, 0.0));
        TechnologyError::NoFeasiblePlan { limit, feed, least, needed }
    }
}
