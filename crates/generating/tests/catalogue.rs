//! Dressers on other worms and the search in a catalogue: against rays, closed relations, symmetry and the borders of the answers.

use dressing::catalogue::{
    BackwardsSearch, CatalogueDresser, CatalogueSearch, CatalogueWorm, DesignedDresser, DresserSize,
    FreeQuantity, Look, Pair, PairLimits, RankedPair, Refusal, Wanted, Workshop, WornDiameter,
};
use dressing::{
    DressingError, angle_of_least_stretch, fit_profile, fit_profile_along, fit_profile_on_path, stretch,
    uncorrected_profile,
};
use foundation::geometry::{Blank, Flank, Gear, GearData, Sides, WormChoice};
use foundation::kinematics::DressingMotion;
use foundation::numerics::{Progress, Silent};
use generating::GearWorkshop;
use referee::{Dressing, RayGrid, dress};
use std::sync::atomic::{AtomicU64, Ordering};

/// 19 teeth, module 3.5, 35 degrees; pressure angles per flank in degrees.
fn workshop(angles: Sides<f64>) -> GearWorkshop {
    let gear = Gear::new(GearData {
        teeth: 19,
        normal_module: 3.5,
        pressure_angle: angles.map(|_, a| a.to_radians()),
        helix_angle: 35f64.to_radians(),
        profile_shift: 0.1,
        cone_angle: 0.0,
    })
    .unwrap();
    let blank = Blank {
        face_width: 30.0,
        tip_diameter: 88.6,
        root_diameter: 73.0,
        tip_form_diameter: 88.6,
        form_diameter: 77.2,
        rack_addendum: None,
    };
    GearWorkshop { gear, blank, evaluation: [77.2, 88.6, -15.0, 15.0], root_clearance: None }
}

fn symmetric() -> GearWorkshop {
    workshop(Sides::both(17.5))
}

fn choice(threads: i32, pitch_diameter: f64) -> WormChoice {
    WormChoice {
        threads,
        hand: 1.0,
        pitch_diameter: Some(pitch_diameter),
        tip_diameter: None,
        pressure_angle: Some(17.5f64.to_radians()),
        profile_shift: 0.0,
        cone_angle: 0.0,
    }
}

fn worm(threads: i32, now: f64, smallest: f64) -> CatalogueWorm {
    CatalogueWorm {
        name: format!("{threads} threads, {now} mm"),
        choice: choice(threads, now),
        right_angle: None,
        normal_module: None,
        smallest: Some(WornDiameter::Pitch(smallest)),
        width: 100.0,
    }
}

fn dresser(tip_diameter: f64, threads: i32, designed: f64, crowning_um: f64) -> CatalogueDresser {
    CatalogueDresser {
        name: format!("{tip_diameter} mm for {threads} x {designed}"),
        size: DresserSize { tip_radius: tip_diameter / 2.0, pitch_radius: None },
        designed_for: choice(threads, designed),
        designed_right_angle: None,
        designed_module: None,
        crowning: Sides::both(crowning_um * 1e-3),
        tip_land: None,
        flank: None,
    }
}

fn wanted(workshop: &GearWorkshop, crowning_um: f64) -> Wanted {
    Wanted {
        crowning: Sides::both(Some(crowning_um * 1e-3)),
        cos_base_helix: Sides::from_fn(|flank| workshop.gear.flank(flank).base_helix_angle.cos()),
        tolerance: Some(0.5e-3),
    }
}

const LIMITS: PairLimits = PairLimits {
    correction: [10.0 * RAD, 6.0 * RAD, 5.0, 20.0],
    stretch: Some(0.15),
    tip_land: 0.5,
    clearance: 0.0,
};
const RAD: f64 = std::f64::consts::PI / 180.0;

fn pair<'a>(
    workshop: &'a GearWorkshop,
    bodies: (&'a CatalogueWorm, &'a CatalogueDresser, &'a DesignedDresser),
    wanted: &'a Wanted,
    limits: &'a PairLimits,
) -> Pair<'a> {
    let (worm, dresser, designed) = bodies;
    Pair { workshop, worm, dresser, designed, wanted, limits, collisions: false }
}

#[test]
fn a_dresser_fits_the_worm_it_was_designed_for() {
    let shop = symmetric();
    let (worm, dresser) = (worm(5, 100.0, 90.0), dresser(123.0, 5, 100.0, 2.0));
    let designed = dresser.designed(&shop, 1.0).unwrap();
    let wanted = wanted(&shop, 2.0);
    let pair = pair(&shop, (&worm, &dresser, &designed), &wanted, &LIMITS);
    let seat = pair.seat().unwrap();
    let figures = pair.judge(&worm.choice, &seat, None, Look::Whole).unwrap();
    assert_eq!(figures.refusal, None);
    assert!(figures.cost < 1e-9 && figures.stretch().unwrap().abs() < 1e-9, "{figures:?}");
    // Without corrections the worm has what the dresser carries.
    let uncorrected = pair.uncorrected(&seat).unwrap();
    for flank in Flank::BOTH {
        assert!((uncorrected[flank].unwrap() - 2e-3).abs() < 1e-9, "{uncorrected:?}");
    }
}

#[test]
fn rays_of_the_worm_find_the_profile_that_was_asked_for() {
    for (shop, angle) in [(symmetric(), 17.5), (workshop(Sides { left: 20.0, right: 17.0 }), 20.0)] {
        let at = |d: f64| WormChoice { pressure_angle: Some(f64::to_radians(angle)), ..choice(5, d) };
        let mut dresser = dresser(123.0, 5, 104.0, 0.0);
        dresser.designed_for = at(104.0);
        let designed = dresser.designed(&shop, 1.0).unwrap();
        let seat = shop.seat(&at(95.0), dresser.size).unwrap();
        let tool = designed.tool.on_worm(&seat).unwrap();
        for flank in Flank::BOTH {
            let middle = -1.2e-3;
            let fit = fit_profile(&tool, flank, seat.reference_radius(), middle, &[0.0; 4]).unwrap();
            let range = seat.ranges[flank];
            let grid = RayGrid::new(vec![range.w_nf, range.middle(), range.w_na], vec![-4.0, 7.0]).unwrap();
            let motion = DressingMotion::constant(seat.chains[flank], fit.dk);
            let stage = Dressing {
                worm: seat.worm.flank(flank),
                dresser: &designed.tool.flanks[flank].profile,
                motion: &motion,
                shift_range: [-60.0, 60.0],
                stock: 0.2,
            };
            let left = dress(&stage, &grid, &Silent).unwrap();
            let lengths = left.lengths().unwrap();
            for (k, f) in lengths.iter().enumerate() {
                let want = if k / 2 == 1 { middle } else { 0.0 };
                assert!((f - want).abs() < 1e-8, "{flank} {k}: {f}");
            }
            // P is read off where the designed end of the profile is dressed.
            assert!((stretch(&tool, flank, fit.dk).unwrap() - fit.stretch).abs() < 1e-15);
        }
    }
}

#[test]
fn flanks_of_a_symmetric_pair_mirror_each_other() {
    let shop = symmetric();
    let dresser = dresser(110.0, 3, 140.0, 0.0);
    let designed = dresser.designed(&shop, 1.0).unwrap();
    let seat = shop.seat(&choice(3, 120.0), dresser.size).unwrap();
    let tool = designed.tool.on_worm(&seat).unwrap();
    let fit = |flank| fit_profile(&tool, flank, seat.reference_radius(), -1e-3, &[0.0; 4]).unwrap();
    let (left, right) = (fit(Flank::Left), fit(Flank::Right));
    // Half a turn about the common perpendicular maps one flank onto the other: phase and offset change their sign.
    for (j, sign) in [-1.0, 1.0, 1.0, -1.0].into_iter().enumerate() {
        let size = left.dk[j].abs().max(1e-6);
        assert!((left.dk[j] - sign * right.dk[j]).abs() < 1e-6 * size, "{j}: {left:?} {right:?}");
    }
    assert!((left.stretch - right.stretch).abs() < 1e-9);
}

#[test]
fn the_hand_of_the_worm_only_mirrors_the_corrections() {
    let shop = symmetric();
    let dresser = dresser(110.0, 3, 140.0, 0.0);
    let fit = |hand: f64| {
        let designed = dresser.designed(&shop, hand).unwrap();
        let seat = shop.seat(&WormChoice { hand, ..choice(3, 120.0) }, dresser.size).unwrap();
        let tool = designed.tool.on_worm(&seat).unwrap();
        fit_profile(&tool, Flank::Left, seat.reference_radius(), -1e-3, &[0.0; 4]).unwrap()
    };
    let (right, left) = (fit(1.0), fit(-1.0));
    for j in 0..4 {
        assert!((right.dk[j].abs() - left.dk[j].abs()).abs() < 1e-6 * right.dk[j].abs().max(1e-6), "{j}");
    }
    assert!((right.stretch - left.stretch).abs() < 1e-9);
}

#[test]
fn a_path_of_worms_leads_to_the_direct_solution() {
    let shop = symmetric();
    let dresser = dresser(123.0, 5, 110.0, 0.0);
    let designed = dresser.designed(&shop, 1.0).unwrap();
    let path = |share: f64| shop.seat(&choice(5, 110.0 - 25.0 * share), dresser.size);
    let on_path = fit_profile_on_path(&designed.tool, Flank::Left, &path, -1e-3).unwrap();
    let direct = fit_profile_along(&designed.tool, Flank::Left, &path, -1e-3).unwrap();
    for j in 0..4 {
        assert!((on_path.dk[j] - direct.dk[j]).abs() < 1e-7, "{on_path:?} {direct:?}");
    }
    // A smaller worm: P falls below 0, with what is left uncorrected growing (figure 19 of the source).
    let mut last = (0.0, 0.0);
    for share in [0.25, 0.5, 0.75, 1.0] {
        let seat = path(share).unwrap();
        let tool = designed.tool.on_worm(&seat).unwrap();
        let (_, middle) = uncorrected_profile(&tool, Flank::Left, seat.reference_radius()).unwrap();
        let fit = fit_profile_along(&designed.tool, Flank::Left, &|s| path(s * share), 0.0).unwrap();
        assert!(fit.stretch < last.0 && middle < last.1, "{share}: {fit:?} {middle}");
        last = (fit.stretch, middle);
    }
}

#[test]
fn stretch_vanishes_at_the_angle_found() {
    let shop = symmetric();
    let dresser = dresser(123.0, 5, 110.0, 0.0);
    let designed = dresser.designed(&shop, 1.0).unwrap();
    let seat =
        |angle: f64| shop.seat(&WormChoice { pressure_angle: Some(angle), ..choice(5, 94.0) }, dresser.size);
    let bracket = [15.5, 19.5].map(f64::to_radians);
    let found = angle_of_least_stretch(&designed.tool, &Flank::BOTH, &seat, bracket).unwrap();
    for flank in Flank::BOTH {
        assert!(found.stretch[flank].unwrap().abs() < 1e-9, "{found:?}");
    }
    // Between the designed angle and the bracket's other end P keeps its sign.
    let refused =
        angle_of_least_stretch(&designed.tool, &Flank::BOTH, &seat, [17.6, 19.0].map(f64::to_radians));
    let Err(error @ DressingError::NoAngleWithoutStretch { stretch: [a, b], .. }) = refused else {
        panic!("{refused:?}")
    };
    assert!(a * b > 0.0 && error.code() == "no-zero" && !error.way_out().is_empty());
}

#[test]
fn asymmetric_flanks_share_the_least_stretch() {
    let shop = workshop(Sides { left: 22.0, right: 16.0 });
    let at = |d: f64, angle: f64| WormChoice { pressure_angle: Some(angle), ..choice(5, d) };
    let own = 22f64.to_radians();
    let mut dresser = dresser(123.0, 5, 110.0, 0.0);
    dresser.designed_for = at(110.0, own);
    let designed = dresser.designed(&shop, 1.0).unwrap();
    let seat = |angle: f64| shop.seat(&at(96.0, angle), dresser.size);
    let bracket = [own - 2.0 * RAD, own + 2.0 * RAD];
    let found = angle_of_least_stretch(&designed.tool, &Flank::BOTH, &seat, bracket).unwrap();
    let [left, right] = Flank::BOTH.map(|flank| found.stretch[flank].unwrap());
    assert!((left + right).abs() < 1e-9 && left.abs() > 1e-5, "{found:?}");
    // No neighbour has a smaller larger |P|.
    let larger = |angle: f64| {
        let seat = seat(angle).unwrap();
        let tool = designed.tool.on_worm(&seat).unwrap();
        let p = |flank| fit_profile(&tool, flank, seat.reference_radius(), 0.0, &[0.0; 4]).unwrap().stretch;
        f64::max(p(Flank::Left).abs(), p(Flank::Right).abs())
    };
    let least = larger(found.angle);
    for step in [-0.2, -0.02, 0.02, 0.2] {
        assert!(larger(found.angle + step * RAD) > least, "{step}");
    }
}

fn lists() -> (Vec<CatalogueWorm>, Vec<CatalogueDresser>) {
    let mut other_module = worm(3, 140.0, 120.0);
    other_module.normal_module = Some(3.0);
    let too_small = worm(6, 20.0, 18.0);
    let worms =
        vec![worm(5, 200.0, 180.0), worm(5, 100.0, 88.0), worm(3, 120.0, 105.0), other_module, too_small];
    let dressers = vec![
        dresser(123.0, 5, 100.0, 0.0),
        dresser(98.4, 5, 120.0, 1.0),
        dresser(123.0, 3, 115.0, 2.5),
        CatalogueDresser { flank: Some([58.0, 60.5]), ..dresser(123.0, 5, 100.0, 2.5) },
    ];
    (worms, dressers)
}

fn search<'a>(
    shop: &'a GearWorkshop,
    (worms, dressers): &'a (Vec<CatalogueWorm>, Vec<CatalogueDresser>),
    crowning_um: f64,
) -> CatalogueSearch<'a> {
    CatalogueSearch {
        workshop: shop,
        worms,
        dressers,
        wanted: wanted(shop, crowning_um),
        limits: LIMITS,
        collisions: false,
        life: true,
    }
}

#[derive(Default)]
struct Count(AtomicU64);

impl Progress for Count {
    fn start(&self, _: &str, total: u64) {
        self.0.store(total << 32, Ordering::SeqCst);
    }
    fn advance(&self, n: u64) {
        self.0.fetch_add(n, Ordering::SeqCst);
    }
    fn finish(&self) {}
}

#[test]
fn a_search_ranks_all_pairs_and_tells_why_some_fail() {
    let (shop, lists) = (symmetric(), lists());
    let search = search(&shop, &lists, 2.5);
    let count = Count::default();
    let ranking = search.run(&count);
    assert_eq!(count.0.load(Ordering::SeqCst), (20 << 32) + 20);
    assert_eq!(ranking.len(), 20);
    let of = |w: usize, d: usize| ranking.iter().find(|p| (p.worm, p.dresser) == (w, d)).unwrap();
    // The dresser that carries the crowning on the worm nearest to its own is the best of the worms with 3 threads.
    let best = |w: usize| ranking.iter().find(|p| p.worm == w).unwrap();
    assert_eq!((best(2).dresser, best(2).is_ok()), (2, true));
    let ok = ranking.iter().filter(|p| p.is_ok()).count();
    assert!(ok > 4 && ranking[..ok].iter().all(RankedPair::is_ok), "{ok}");
    for pairs in ranking[..ok].windows(2) {
        assert!(pairs[0].cost() <= pairs[1].cost());
    }
    for (pair, code) in
        [(of(3, 0), "not-mating"), (of(4, 1), "worm-too-small"), (of(1, 3), "dresser-flank-too-short")]
    {
        let refusal = pair.refusal.as_ref().unwrap();
        assert_eq!(refusal.code(), code, "{refusal}");
        assert!(!refusal.to_string().is_empty() && !refusal.way_out().is_empty());
    }
    // What has no figures stands at the end.
    let first = ranking.iter().position(|p| p.figures.is_none()).unwrap();
    assert!(ranking[first..].iter().all(|p| p.figures.is_none() && p.refusal.is_some()));
    for pair in &ranking[..ok] {
        let life = pair.life.as_ref().unwrap();
        assert!(life.to <= life.from, "{life:?}");
    }
}

#[test]
fn a_search_gives_the_same_on_any_number_of_threads() {
    let (shop, lists) = (symmetric(), lists());
    let search = search(&shop, &lists, 1.0);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| search.run(&Silent))
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn a_life_ends_where_a_limit_is_met() {
    let shop = symmetric();
    let (worm, dresser) = (worm(5, 110.0, 80.0), dresser(123.0, 5, 110.0, 0.0));
    let designed = dresser.designed(&shop, 1.0).unwrap();
    let wanted = wanted(&shop, 0.0);
    let limits = PairLimits { stretch: Some(0.03), ..LIMITS };
    let pair = pair(&shop, (&worm, &dresser, &designed), &wanted, &limits);
    let rows = pair.life(7).unwrap();
    assert_eq!((rows.len(), rows[6].pitch_diameter), (7, 80.0));
    assert!((rows[0].pitch_diameter - 110.0).abs() < 1e-12);
    assert!(rows[0].refusal().is_none());
    // Uncorrected crowning grows as the worm shrinks; corrections bring it back to 0.
    let left: Vec<f64> = rows.iter().map(|r| r.uncorrected.unwrap().left.unwrap()).collect();
    assert!(left[0].abs() < 1e-9 && left.windows(2).all(|w| w[1] > w[0]), "{left:?}");
    let seat = pair.seat().unwrap();
    let figures = pair.judge(&worm.choice, &seat, None, Look::Whole).unwrap();
    let life = pair.remaining_life(&seat, &figures).unwrap();
    assert!(life.to > 80.0 && life.to < 110.0, "{life:?}");
    assert!(matches!(life.end, Some(Refusal::Stretch { .. })), "{life:?}");
    // The border is where |P| meets its limit.
    let worn = pair.worn_seat(&seat, life.to).unwrap();
    let there = pair.judge(&worm.worn(&seat, life.to), &worn, None, Look::Whole).unwrap();
    assert!(there.refusal.is_none() && (there.stretch().unwrap().abs() - 0.03).abs() < 1e-4, "{there:?}");
}

#[test]
fn backwards_a_dresser_finds_its_worms() {
    let shop = symmetric();
    let (worm, dresser) = (worm(5, 130.0, 100.0), dresser(123.0, 5, 100.0, 2.0));
    let limits = PairLimits { correction: [2.0 * RAD, 1.0 * RAD, 2.0, 8.0], ..LIMITS };
    let search = BackwardsSearch {
        workshop: &shop,
        worm: &worm,
        dresser: &dresser,
        wanted: wanted(&shop, 2.0),
        limits,
        collisions: false,
    };
    let found = search.run(FreeQuantity::PitchDiameter([60.0, 240.0])).unwrap();
    let range = found.ranges.iter().find(|r| r.from < 100.0 && r.to > 100.0).unwrap();
    assert!((range.best.value - 100.0).abs() < 0.5, "{}", range.best.value);
    assert_eq!(found.best().unwrap().value, range.best.value);
    // Both ends are borders: a little beyond, the pair is refused.
    let judge = |d: f64| {
        let designed = dresser.designed(&shop, 1.0).unwrap();
        let there = CatalogueWorm { choice: choice(5, d), smallest: None, ..worm.clone() };
        let wanted = wanted(&shop, 2.0);
        let pair = pair(&shop, (&there, &dresser, &designed), &wanted, &limits);
        let seat = pair.seat().unwrap();
        pair.judge(&there.choice, &seat, None, Look::Whole).map(|f| f.refusal)
    };
    for (inside, outside) in [(range.from + 0.02, range.from - 0.02), (range.to - 0.02, range.to + 0.02)] {
        assert_eq!(judge(inside), Ok(None), "{inside}");
        assert!(!matches!(judge(outside), Ok(None)), "{outside}");
    }
    let threads = search.run(FreeQuantity::Threads([1, 8])).unwrap();
    assert_eq!(threads.looked_at.len(), 8);
    assert!(threads.ranges.iter().all(|r| r.from.fract() == 0.0 && r.best.value.fract() == 0.0));
    let angle = search.run(FreeQuantity::ProfileAngle([15.0 * RAD, 20.0 * RAD])).unwrap();
    assert!(angle.looked_at.windows(2).all(|w| w[0].value < w[1].value));
}
