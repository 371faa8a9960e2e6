//! The fastest cycle against a search by trying.

use crate::bodies::{axes, helical, spur};
use foundation::geometry::Sides;
use grinding_technology::{
    Bodies, Cycle, Direction, FlankStroke, OptimumTask, Shift, Stock, StockField, Stroke, TechnologyError,
    ZoneLimits,
};

fn task(ratio: f64) -> OptimumTask {
    OptimumTask {
        stock: 0.12,
        cutting_speed: 63.0,
        least_feed: 0.02,
        largest_feed: 1.2,
        feed_mark: 0.5e-3,
        rate_roughing: 14.0,
        rate_finishing: 6.0,
        least_finishing: 0.01,
        most_finishing: 0.06,
        most_roughing_strokes: 2,
        ratio_finishing: ratio,
        overrun: 1.0,
        clearance: 15.0,
        auxiliary: 9.0,
        between_strokes: 0.7,
        dressing: 40.0,
        zones: ZoneLimits {
            zone_width: 120.0,
            zone_gap: 2.0,
            allowed_roughing: 1500.0,
            allowed_finishing: 800.0,
        },
    }
}

/// Time of a part for a number of roughing strokes, a depth of finishing and both feeds, worked out as a cycle on its stock; infinite beyond a
/// limit. Another way than the search's own figures.
fn tried(task: &OptimumTask, bodies: &Bodies, roughing: u32, [finishing, rough, fine]: [f64; 3]) -> f64 {
    let outside = |value: f64, [least, most]: [f64; 2]| value < least || value > most;
    let feeds = [task.least_feed, task.largest_feed];
    if outside(finishing, [task.least_finishing, task.most_finishing])
        || outside(rough, feeds)
        || outside(fine, feeds)
    {
        return f64::INFINITY;
    }
    let stroke = |left: f64, feed: f64, ratio: f64, zone: &str| Stroke {
        left: Sides::both(left),
        feed_per_revolution: feed,
        cutting_speed: task.cutting_speed,
        direction: Direction::Up,
        shift: Shift { ratio, ..Shift::default() },
        overrun: task.overrun,
        dwell: 0.0,
        zone: zone.into(),
    };
    let by = (task.stock - finishing) / f64::from(roughing);
    let mut strokes: Vec<Stroke> = (1..=roughing)
        .map(|i| stroke((task.stock - by * f64::from(i)).max(finishing), rough, 0.0, "roughing"))
        .collect();
    strokes.push(stroke(0.0, fine, task.ratio_finishing, "finishing"));
    let stock = StockField::new(Stock::constant(Sides::both(task.stock)), bodies).unwrap();
    let cycle = Cycle::new(bodies.clone(), stock, strokes).unwrap();
    let largest = |figure: fn(&FlankStroke) -> f64, k: usize| {
        let flanks = &cycle.strokes[k].flanks;
        f64::max(figure(&flanks.left), figure(&flanks.right))
    };
    let rate = |f: &FlankStroke| f.rate_bound.into_iter().fold(0.0, f64::max);
    let mark = |f: &FlankStroke| f.feed_mark.into_iter().fold(0.0, f64::max);
    let last = cycle.strokes.len() - 1;
    if largest(rate, 0) > task.rate_roughing
        || largest(rate, last) > task.rate_finishing
        || largest(mark, last) > task.feed_mark
    {
        return f64::INFINITY;
    }
    let strokes: f64 = cycle.times(&axes(), task.clearance).unwrap().iter().map(|time| time.total).sum();
    let parts = cycle.level(&task.zones).parts;
    task.auxiliary + strokes + task.between_strokes * f64::from(roughing) + task.dressing / parts
}

/// The best of a coarse grid, then of steps along each variable that are halved where none helps.
fn by_trying(task: &OptimumTask, bodies: &Bodies) -> f64 {
    let mut best = f64::INFINITY;
    for roughing in 1..=2 {
        let mut at = ([0.01, 0.02, 0.02], f64::INFINITY);
        for depth in [0.012, 0.024, 0.05] {
            for rough in [0.05, 0.1, 0.2, 0.4] {
                for fine in [0.3, 0.6, 1.0] {
                    let time = tried(task, bodies, roughing, [depth, rough, fine]);
                    if time < at.1 {
                        at = ([depth, rough, fine], time);
                    }
                }
            }
        }
        // Depth and feeds are bound to each other by the limits: steps along one, and along two at a time.
        let mut share = 0.3;
        while share > 2e-4 {
            let mut better = at;
            for j in 0..27_u32 {
                let factor = |k: u32| 1.0 + share * (f64::from(j / 3_u32.pow(k) % 3) - 1.0);
                let next: [f64; 3] = std::array::from_fn(|k| at.0[k] * factor(k as u32));
                let time = tried(task, bodies, roughing, next);
                if time < better.1 {
                    better = (next, time);
                }
            }
            if better.1 < at.1 {
                at = better;
            } else {
                share *= 0.5;
            }
        }
        best = best.min(at.1);
    }
    best
}

#[test]
fn what_trying_finds_is_the_same() {
    for (bodies, ratio) in [(spur(), 0.0), (helical(), -1.9)] {
        let task = task(ratio);
        let found = task.solve(&bodies, &axes()).unwrap();
        let time = found.best.cycle.unwrap().time;
        let tried = by_trying(&task, &bodies);
        assert!((tried / time - 1.0).abs() < 2e-3, "{time} s found, {tried} s by trying");
        assert!(time <= tried * (1.0 + 1e-9), "{time} s found, {tried} s by trying");
    }
}

#[test]
fn a_cycle_that_cannot_be_names_the_limit_and_what_would_do() {
    let task = OptimumTask { rate_finishing: 1e-3, ..task(0.0) };
    let error = task.solve(&spur(), &axes()).unwrap_err();
    let TechnologyError::NoFeasiblePlan { limit, needed, .. } = error else { panic!("{error}") };
    assert_eq!(limit, "optimise.Qw_finishing");
    let raised = OptimumTask { rate_finishing: needed * (1.0 + 1e-9), ..task };
    assert!(raised.solve(&spur(), &axes()).is_ok());
}
