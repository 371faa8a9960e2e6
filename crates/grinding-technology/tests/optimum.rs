//! The fastest cycle against a search by trying.

use crate::bodies::{axes, helical, spur};
use foundation::geometry::Sides;
use grinding_technology::{
    BestCycle, Bodies, Cycle, Direction, FlankStroke, Ground, OptimumTask, Rates, Shift, Stock, StockField,
    Stroke, TechnologyError, ZoneLimits,
};

fn task(ratio: f64) -> OptimumTask {
    OptimumTask {
        passes: vec![Ground::Both],
        cost: None,
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
        ratio_roughing: 0.0,
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

/// A cycle of some roughing strokes and one finishing stroke on its stock.
fn cycle(
    task: &OptimumTask,
    bodies: &Bodies,
    roughing: u32,
    finishing: f64,
    [rough, fine]: [f64; 2],
) -> Cycle {
    let stroke = |left: f64, feed: f64, ratio: f64, zone: &str| Stroke {
        ground: Ground::Both,
        left: Sides::both(left),
        feed_per_revolution: feed,
        cutting_speed: task.cutting_speed,
        direction: Direction::Up,
        shift: Shift::straight(ratio, 0.0),
        overrun: task.overrun,
        dwell: 0.0,
        zone: zone.into(),
    };
    let by = (task.stock - finishing) / f64::from(roughing.max(1));
    let mut strokes: Vec<Stroke> = (1..=roughing)
        .map(|i| stroke((task.stock - by * f64::from(i)).max(finishing), rough, 0.0, "roughing"))
        .collect();
    strokes.push(stroke(0.0, fine, task.ratio_finishing, "finishing"));
    let stock = StockField::new(Stock::constant(Sides::both(task.stock)), bodies).unwrap();
    Cycle::new(bodies.clone(), stock, strokes).unwrap()
}

/// Time of a part and parts between two dressings.
fn time(task: &OptimumTask, cycle: &Cycle) -> [f64; 2] {
    let strokes: f64 = cycle.times(&axes(), task.clearance).unwrap().iter().map(|time| time.total).sum();
    let between = task.between_strokes * (cycle.strokes.len() - 1) as f64;
    let parts = cycle.level(&task.zones).parts;
    [task.auxiliary + strokes + between + task.dressing / parts, parts]
}

/// Depths of finishing one by one, each with feeds at shares of what the limits allow: rates go with the feed, marks with its square. Every
/// cycle is worked out by itself, another way than the search's own figures.
fn by_trying(task: &OptimumTask, bodies: &Bodies, worth: impl Fn([f64; 2]) -> f64) -> f64 {
    const DEPTHS: u32 = 120;
    let mut best = f64::INFINITY;
    for roughing in 0..=2 {
        for k in 0..=DEPTHS {
            let span = task.most_finishing - task.least_finishing;
            let finishing = task.least_finishing + span * f64::from(k) / f64::from(DEPTHS);
            // Without roughing the stroke takes all.
            let finishing = if roughing == 0 { task.stock } else { finishing };
            let of_one = cycle(task, bodies, roughing, finishing, [1.0, 1.0]);
            let largest = |k: usize, figure: fn(&FlankStroke) -> [f64; 9]| {
                let flanks = &of_one.strokes[k].flanks;
                figure(&flanks.left).into_iter().chain(figure(&flanks.right)).fold(0.0, f64::max)
            };
            let last = of_one.strokes.len() - 1;
            let rough = task.rate_roughing / largest(0, |f| f.rate_bound);
            let fine = (task.rate_finishing / largest(last, |f| f.rate_bound))
                .min((task.feed_mark / largest(last, |f| f.feed_mark)).sqrt());
            for shares in [[1.0, 1.0], [0.9, 1.0], [1.0, 0.9]] {
                let feeds =
                    [shares[0] * rough.min(task.largest_feed), shares[1] * fine.min(task.largest_feed)];
                best = best.min(worth(time(task, &cycle(task, bodies, roughing, finishing, feeds))));
            }
        }
    }
    best
}

#[test]
fn what_trying_finds_is_the_same() {
    for (bodies, ratio) in [(spur(), 0.0), (helical(), -1.9)] {
        let task = task(ratio);
        let found = task.solve(&bodies, &axes()).unwrap();
        let time = found.best.cycle.unwrap().time;
        let tried = by_trying(&task, &bodies, |[time, _]| time);
        assert!((tried / time - 1.0).abs() < 2e-3, "{time} s found, {tried} s by trying");
        assert!(time <= tried * (1.0 + 1e-9), "{time} s found, {tried} s by trying");
    }
}

/// A worm and a dresser that are dear, and finishing that loads the worm less, make a cycle that saves dressings.
#[test]
fn the_cheapest_cycle_is_the_one_that_trying_finds() {
    let rates = Rates {
        machine_per_hour: 60.0,
        worm_price: 9000.0,
        worm_change: 1200.0,
        dresser_price: 2500.0,
        dressings_per_dresser: 300.0,
    };
    let (bodies, full_dressings) = (helical(), 80.0);
    let cost = rates.goal(full_dressings);
    let usual = task(-1.9);
    let zones = ZoneLimits { allowed_roughing: 300.0, allowed_finishing: 1500.0, ..usual.zones };
    let task = OptimumTask { cost: Some(cost), zones, ..usual };
    let found = task.solve(&bodies, &axes()).unwrap();
    let [cheapest, fastest] = [found.cheapest.unwrap(), found.best].map(|row| row.cycle.unwrap());
    let of = |cycle: &BestCycle| cost.per_part(cycle.time, cycle.parts);
    let by_rates = rates.per_part(cheapest.time, cheapest.parts, full_dressings * cheapest.parts).unwrap();
    assert!((by_rates.total() / of(&cheapest) - 1.0).abs() < 1e-12);
    assert!(of(&cheapest) < 0.999 * of(&fastest) && cheapest.parts > fastest.parts);
    let tried = by_trying(&task, &bodies, |[time, parts]| cost.per_part(time, parts));
    assert!((tried / of(&cheapest) - 1.0).abs() < 2e-3, "{} found, {tried} by trying", of(&cheapest));
    assert!(of(&cheapest) <= tried * (1.0 + 1e-9));
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
