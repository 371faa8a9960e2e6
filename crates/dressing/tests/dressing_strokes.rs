//! Dressing in several strokes and deviations of the axes: against the referee's rays, brute force and simulated measurements,
//! and every refusal. The reference numbers are checked by `verify` (`tests/verify.rs`).

use dressing::{
    ActiveArea, DressedProfile, DresserTool, DressingError, GeometricRange, Measurement, MovingSection,
    MovingStroke, MultiStroke, NodePlan, ProfileSection, Recovery, Spread, Spreads, Stroke, StrokedWorm,
    WidthLaw, divide, divide_moving, dressing_motion, influence, recover_deviation, spread_of_profile,
};
use foundation::geometry::{Flank, Gear, GearData, Revolution, Sides};
use foundation::kinematics::{DressingChain, DressingCorrection, DressingMotion};
use foundation::numerics::{Chebyshev, Silent, equidistant, value_of};
use proptest::prelude::*;
use referee::{Dressing, RayGrid, dress};
use std::f64::consts::FRAC_PI_2;

const MODULE: f64 = 3.5;
const DIAMETER: f64 = 100.0;
const RADIUS: f64 = 0.5 * DIAMETER;

fn worm(threads: i32) -> Gear {
    Gear::new(GearData {
        teeth: threads,
        normal_module: MODULE,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: (f64::from(threads) * MODULE / DIAMETER).acos(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap()
}

/// A dresser of 123 mm on a worm of 5 threads and 100 mm.
fn tool() -> DresserTool {
    let worm = worm(5);
    let p = worm.screw_parameter(Flank::Left);
    let chain = DressingChain {
        worm_angle: -FRAC_PI_2,
        crossing_angle: -(p / RADIUS).atan(),
        centre_distance: 61.5 + RADIUS - 1.25 * MODULE,
        offset: 0.0,
        screw_parameter: p,
    };
    let flank = *worm.flank(Flank::Left);
    let roll = |height: f64| flank.length_of_roll(RADIUS + height * MODULE).unwrap();
    let range = GeometricRange { w_nf: roll(-0.9), w_na: roll(0.9) };
    DresserTool::conjugate(&worm, Sides::both(chain), Sides::both(range)).unwrap()
}

fn range(tool: &DresserTool) -> [f64; 2] {
    [tool.flanks.left.range.w_nf, tool.flanks.left.range.w_na]
}

/// The part of the dresser between two shares of its designed profile, touching a little more.
fn area(tool: &DresserTool, shares: [f64; 2], excess: f64) -> ActiveArea {
    let [from, to] = range(tool);
    let part = shares.map(|s| from + s * (to - from));
    let more = excess * (to - from);
    ActiveArea::new(part, [part[0] - more, part[1] + more]).unwrap()
}

/// The meridian between two parameters alone: what is left of a dresser that is relieved beside its active area.
fn cut_out(whole: &Revolution, [from, to]: [f64; 2]) -> Revolution {
    let fit = |of: &dyn Fn(f64) -> f64| {
        Chebyshev::interpolate(
            from,
            to,
            &Chebyshev::nodes(from, to, 40).into_iter().map(of).collect::<Vec<_>>(),
        )
    };
    let (r, z) = (fit(&|t| value_of(whole.at(t).r)), fit(&|t| value_of(whole.at(t).z)));
    let outward = Revolution::new(r.clone(), z.clone(), 1.0);
    let middle = 0.5 * (from + to);
    let (a, b) = (outward.at(middle), whole.at(middle));
    if a.n_r * b.n_r + a.n_z * b.n_z > 0.0 { outward } else { Revolution::new(r, z, -1.0) }
}

/// Rays of one stroke at z = `heights`: w by w, `None` where the dresser does not finish a ray.
fn rays(
    tool: &DresserTool,
    touching: [f64; 2],
    motion: &DressingMotion,
    grid: &RayGrid,
    stroke: [f64; 2],
) -> Vec<Option<f64>> {
    let flank = &tool.flanks.left;
    let dresser = cut_out(&flank.profile, touching);
    let setup = Dressing { worm: &flank.worm, dresser: &dresser, motion, shift_range: stroke, stock: 0.3 };
    dress(&setup, grid, &Silent).unwrap().rays.into_iter().map(|ray| ray.ok().map(|ray| ray.f)).collect()
}

fn parabola(tool: &DresserTool, amount: f64) -> impl Fn(f64) -> f64 + Sync {
    let [from, to] = range(tool);
    move |w: f64| amount * ((w - from) / (to - from) - 0.5).powi(2)
}

/// Three strokes of one area over the whole profile.
fn three(tool: &DresserTool, excess: f64) -> Vec<Stroke<'_>> {
    let section = ProfileSection { tool, area: area(tool, [0.3, 0.65], excess), range: range(tool) };
    divided(&[section], 0.02 * (range(tool)[1] - range(tool)[0]))
}

/// The strokes without the numbers of their sections.
fn divided<'a>(sections: &[ProfileSection<'a>], overlap: f64) -> Vec<Stroke<'a>> {
    divide(sections, Flank::Left, overlap).unwrap().into_iter().map(|(_, stroke)| stroke).collect()
}

#[test]
fn the_envelope_of_all_strokes_is_the_least_of_their_rays() {
    let tool = tool();
    let strokes = three(&tool, 0.02);
    assert_eq!(strokes.len(), 3);
    let wanted = parabola(&tool, -0.008);
    let dressed = MultiStroke::solve(&strokes, Flank::Left, RADIUS, &wanted).unwrap();
    dressed.check_cover(range(&tool)).unwrap();
    let grid = RayGrid::equidistant(range(&tool), 41, [-2.0, 2.0], 2).unwrap();
    let mut least = vec![f64::INFINITY; grid.count()];
    for (stroke, made) in strokes.iter().zip(dressed.strokes()) {
        let motion = DressingMotion::constant(tool.flanks.left.chain, made.dk);
        let found = rays(&tool, stroke.area.touching(), &motion, &grid, [-40.0, 40.0]);
        for (index, ray) in found.into_iter().enumerate() {
            let (w, _) = grid.ray(index);
            let inside = w > made.covers[0] + 1e-3 && w < made.covers[1] - 1e-3;
            let outside = w < made.covers[0] - 1e-3 || w > made.covers[1] + 1e-3;
            assert!(!inside || ray.is_some(), "{w}");
            assert!(!outside || ray.is_none(), "{w}");
            if let Some(f) = ray {
                least[index] = least[index].min(f);
            }
        }
    }
    let mut used = std::collections::BTreeSet::new();
    for (index, f) in least.into_iter().enumerate() {
        let (w, _) = grid.ray(index);
        let at = dressed.at_roll(w).unwrap();
        assert!((at.point.f - f).abs() < 1e-9, "{w}: {} {f}", at.point.f);
        // Three pitch points on each third leave little of a parabola.
        assert!((f - wanted(w)).abs() < 1e-6, "{w}: {f}");
        used.insert(at.stroke);
    }
    assert_eq!(used.into_iter().collect::<Vec<_>>(), [0, 1, 2]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// Gaps are where no stroke's own profile passes through, counted point by point.
    #[test]
    fn gaps_are_where_brute_force_finds_them(
        shares in prop::collection::vec(0.02..0.65f64, 1..4),
        amount in -0.004..0.0f64,
    ) {
        let tool = tool();
        let [from, to] = range(&tool);
        let part = area(&tool, [0.3, 0.65], 0.0);
        let length = part.part()[1] - part.part()[0];
        let strokes: Vec<Stroke<'_>> = shares
            .iter()
            .map(|share| {
                let start = from + share * (to - from);
                Stroke { tool: &tool, area: part, range: [start, start + length] }
            })
            .collect();
        let dressed = MultiStroke::solve(&strokes, Flank::Left, RADIUS, &parabola(&tool, amount)).unwrap();
        let reached = |w: f64| {
            dressed.strokes().iter().any(|s| {
                let t = s.profile().at_roll(w).map(|at| at.t);
                t.is_ok_and(|t| t >= part.touching()[0] && t <= part.touching()[1])
            })
        };
        let places = equidistant([from, to], 400);
        let open: Vec<f64> = places.iter().copied().filter(|&w| !reached(w)).collect();
        for &w in &places {
            prop_assert_eq!(dressed.at_roll(w).is_ok(), reached(w), "{}", w);
        }
        match dressed.check_cover([from, to]) {
            Ok(()) => prop_assert!(open.is_empty(), "{open:?}"),
            Err(DressingError::Gap { from: low, to: high, beside, b, .. }) => {
                // The first gap, up to the distance of the places.
                let step = places[1] - places[0];
                if let Some(&first) = open.first() {
                    prop_assert!(first >= low - 1e-9 && first <= low.max(from) + step, "{first} {low}");
                    prop_assert!(reached((high + 1e-6).min(to)) || high >= to - 1e-9, "{high}");
                } else {
                    prop_assert!(high - low < step);
                }
                prop_assert!(b.is_none());
                for (side, end) in [(0, low), (1, high)] {
                    if let Some(k) = beside[side] {
                        prop_assert!((dressed.strokes()[k].covers[1 - side] - end).abs() < 1e-9);
                    }
                }
            }
            Err(other) => prop_assert!(false, "{other}"),
        }
    }

    #[test]
    fn strokes_of_a_division_overlap_and_meet_the_sections(
        length in 0.1..0.9f64,
        kink in 0.2..0.8f64,
        overlap in 0.0..0.05f64,
    ) {
        let tool = tool();
        let [from, to] = range(&tool);
        let m = to - from;
        let part = area(&tool, [0.0, length], 0.0);
        let middle = from + kink * m;
        let sections = [[from, middle], [middle, to]].map(|range| ProfileSection { tool: &tool, area: part, range });
        let strokes = divided(&sections, overlap * m);
        let count = |width: f64| if width <= length { 1 } else {
            (1..).find(|&n| f64::from(n) * length - f64::from(n - 1) * overlap >= width - 1e-9).unwrap()
        };
        let (below, above) = (count(kink), count(1.0 - kink));
        prop_assert_eq!(strokes.len() as i32, below + above);
        prop_assert!(strokes.iter().all(|s| ((s.range[1] - s.range[0]) / m - length).abs() < 1e-9));
        prop_assert!(strokes[0].range[0] <= from + 1e-9);
        prop_assert!((strokes[below as usize - 1].range[1] - middle).abs() < 1e-9);
        prop_assert!((strokes[below as usize].range[0] - middle).abs() < 1e-9);
        prop_assert!(strokes[strokes.len() - 1].range[1] >= to - 1e-9);
        for pair in strokes.windows(2) {
            let common = pair[0].range[1] - pair[1].range[0];
            prop_assert!(common >= overlap * m - 1e-9 || pair[0].range[1] == middle, "{common}");
        }
    }
}

/// A relief whose start runs over the width: exact envelopes against rays, and the gap of a stroke that moves away.
#[test]
fn strokes_that_move_over_the_width_are_the_least_of_their_rays() {
    let tool = tool();
    let [from, to] = range(&tool);
    let m = to - from;
    let kink = move |b: f64| from + (0.35 + 0.002 * b) * m;
    let wanted = move |w: f64, b: f64| {
        let x = (kink(b) - w) / m;
        if x > 0.0 { 0.003 * x } else { -0.002 * x * x }
    };
    let (lower, upper) = (area(&tool, [0.0, 0.45], 0.01), area(&tool, [0.2, 0.95], 0.01));
    let below = move |b: f64| [kink(b) - 0.45 * m, kink(b)];
    let above = move |b: f64| [kink(b), kink(b) + 0.75 * m];
    let strokes = [
        MovingStroke { tool: &tool, area: lower, range: &below },
        MovingStroke { tool: &tool, area: upper, range: &above },
    ];
    let plan = NodePlan { interval: (-45.0, 45.0), nodes: 9 };
    let worm = StrokedWorm::solve(&strokes, Flank::Left, RADIUS, &plan, &wanted).unwrap();
    worm.check_cover([from, to], &equidistant([-20.0, 20.0], 9)).unwrap();
    let grid = RayGrid::equidistant([from, to], 21, [-20.0, 20.0], 5).unwrap();
    let mut least = vec![f64::INFINITY; grid.count()];
    for (stroke, made) in strokes.iter().zip(worm.strokes()) {
        assert_eq!(made.nodes.len(), 9);
        let motion = dressing_motion(tool.flanks.left.chain, &made.corrections);
        let found = rays(&tool, stroke.area.touching(), &motion, &grid, [-45.0, 45.0]);
        for (least, ray) in least.iter_mut().zip(found) {
            *least = least.min(ray.unwrap_or(f64::INFINITY));
        }
    }
    for (index, f) in least.into_iter().enumerate() {
        let (w, b) = grid.ray(index);
        let at = worm.modification(w, b).unwrap();
        assert!((at.f - f).abs() < 1e-9, "{w} {b}: {} {f}", at.f);
        assert_eq!(at.stroke, usize::from(w > kink(b)), "{w} {b}");
        // Motion and interpolation of DK(v) leave some hundredths of a micrometre.
        assert!((f - wanted(w, b)).abs() < 2e-4, "{w} {b}: {f} {}", wanted(w, b));
    }

    let away = move |b: f64| [kink(b) + 0.004 * (b + 5.0) * m, kink(b) + (0.75 + 0.004 * (b + 5.0)) * m];
    let apart = [strokes[0], MovingStroke { tool: &tool, area: upper, range: &away }];
    let worm = StrokedWorm::solve(&apart, Flank::Left, RADIUS, &plan, &wanted).unwrap();
    let place = [from, kink(-20.0) + 0.6 * m];
    worm.check_cover(place, &[-20.0, -10.0]).unwrap();
    let error = worm.check_cover([from, from + 0.9 * m], &[-10.0, 15.0]).unwrap_err();
    says(&error, "gap", &["at worm z 15.000", "strokes 1 and 2 do not overlap", "left"]);
    let DressingError::Gap { from: low, to: high, b: Some(b), .. } = error else { panic!("{error}") };
    let error = worm.modification(0.5 * (low + high), b).unwrap_err();
    says(&error, "gap", &["strokes 1 and 2"]);
    assert!(worm.modification(low - 1e-6, b).is_ok() && worm.modification(high + 1e-6, b).is_ok());
    // Beyond the motion nothing is dressed.
    assert_eq!(worm.covers(500.0), [None, None]);
    says(&worm.modification(from + 0.1, 500.0).unwrap_err(), "gap", &["no stroke reaches it"]);
}

fn says(error: &DressingError, code: &str, parts: &[&str]) {
    assert_eq!(error.code(), code, "{error}");
    let text = error.to_string();
    assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    assert!(!error.way_out().is_empty());
}

#[test]
fn strokes_that_cannot_be_are_refused() {
    let tool = tool();
    let [from, to] = range(&tool);
    for (part, touching, parts) in [
        ([f64::NAN, 44.0], [40.0, 44.0], ["t_a", "NaN"]),
        ([44.0, 42.0], [42.0, 44.0], ["t_b", "42"]),
        ([42.0, 44.0], [42.5, 44.0], ["start of what touches", "42.5"]),
        ([42.0, 44.0], [42.0, 43.0], ["end of what touches", "43"]),
    ] {
        says(&ActiveArea::new(part, touching).unwrap_err(), "invalid-number", &parts);
    }
    let good = area(&tool, [0.3, 0.65], 0.0);
    let solve = |area: ActiveArea, range: [f64; 2], f: f64| {
        let strokes = [Stroke { tool: &tool, area, range }];
        MultiStroke::solve(&strokes, Flank::Left, RADIUS, &|_| f).unwrap_err()
    };
    says(&solve(good, [to, from], 0.0), "invalid-number", &["w_b", "above w_a"]);
    says(&solve(good, [-1.0, to], 0.0), "invalid-number", &["w_a", "-1"]);
    says(&solve(good, [from, to], f64::NAN), "invalid-number", &["wanted modification", "NaN"]);
    let beyond = ActiveArea::new([from, to], [from, 10.0 * to]).unwrap();
    says(&solve(beyond, [from, to], 0.0), "invalid-number", &["active area of the dresser"]);
    // A parabola that the three points of the whole profile fold before.
    let whole = area(&tool, [0.0, 1.0], 0.0);
    let far = Stroke { tool: &tool, area: whole, range: [from, to] };
    let folded = far.solve(Flank::Left, RADIUS, [0.0, 0.5, 0.0], &[0.0; 4]).unwrap_err();
    says(&folded, "no-zero", &["left", "percent"]);
    let none = MultiStroke::solve(&[], Flank::Left, RADIUS, &|_| 0.0).unwrap_err();
    says(&none, "invalid-number", &["number of strokes"]);
    let uneven = MultiStroke::at(&[far], Flank::Left, &[]).unwrap_err();
    says(&uneven, "invalid-number", &["number of corrections"]);
    let nan = MultiStroke::at(&[far], Flank::Left, &[[0.0, f64::NAN, 0.0, 0.0]]).unwrap_err();
    says(&nan, "invalid-number", &["dressing correction", "NaN"]);

    let section = ProfileSection { tool: &tool, area: good, range: [from, to] };
    let refused =
        |sections: &[ProfileSection<'_>], overlap: f64| divide(sections, Flank::Left, overlap).unwrap_err();
    says(&refused(&[], 0.0), "invalid-number", &["number of sections"]);
    says(&refused(&[section], -0.1), "invalid-number", &["overlap", "-0.1"]);
    says(&refused(&[section], f64::NAN), "invalid-number", &["overlap"]);
    says(&refused(&[section], to), "invalid-number", &["overlap", "below the length"]);
    let reversed = ProfileSection { range: [to, from], ..section };
    says(&refused(&[reversed], 0.0), "invalid-number", &["w_b"]);
    says(&refused(&[section, section], 0.0), "invalid-number", &["start of a section"]);
    let cut = |a: f64, b: f64| ProfileSection {
        range: [from + a * (to - from), from + b * (to - from)],
        ..section
    };
    let between = [cut(0.0, 0.4), cut(0.4, 0.6), cut(0.6, 1.0)];
    says(&refused(&between, 0.0), "invalid-number", &["active part", "between two others"]);

    // A section that moves takes as many strokes as where it is widest, and is nowhere shorter than its area.
    let law = |c: &[f64]| WidthLaw::new(c).unwrap();
    let ends = |move_by: f64| {
        let border = law(&[from + 0.25 * (to - from), move_by]);
        let part = |range: [WidthLaw; 2]| MovingSection { tool: &tool, area: good, range };
        [part([law(&[from]), border]), part([border, law(&[to])])]
    };
    let strokes = divide_moving(&ends(0.4), Flank::Left, 0.02).unwrap();
    for q in [-1.0, 0.0, 1.0] {
        let at: Vec<[f64; 2]> = strokes.iter().map(|(_, laws)| laws.map(|law| law.value(q))).collect();
        let border = from + 0.25 * (to - from) + 0.4 * q;
        let first = strokes.iter().rposition(|(section, _)| *section == 0).unwrap();
        assert!((at[first][1] - border).abs() < 1e-12 && at[first + 1][0] >= border - 1e-12, "{at:?}");
        assert!(at[first + 1..].windows(2).all(|pair| pair[0][1] - pair[1][0] > 0.02 - 1e-12), "{at:?}");
        assert!((at[at.len() - 1][1] - to).abs() < 1e-12, "{at:?}");
    }
    let beyond = divide_moving(&ends(0.4 * (to - from)), Flank::Left, 0.02).unwrap_err();
    says(&beyond, "invalid-number", &["w_a"]);

    let bent = |_: f64| [f64::NAN, to];
    let moving = [MovingStroke { tool: &tool, area: good, range: &bent }];
    let plan = NodePlan { interval: (-5.0, 5.0), nodes: 3 };
    let solve =
        |plan: NodePlan| StrokedWorm::solve(&moving, Flank::Left, RADIUS, &plan, &|_, _| 0.0).unwrap_err();
    says(&solve(plan), "invalid-number", &["w_a", "NaN"]);
    says(&solve(NodePlan { interval: (5.0, -5.0), ..plan }), "invalid-number", &["interval of v_zS"]);
    says(&solve(NodePlan { nodes: 1, ..plan }), "invalid-number", &["nodes"]);
    // A range that jumps back and forth with the place of its ends has no place that fits.
    let jumping = |b: f64| if b > 0.0 { [from - 0.5, from + 2.0] } else { [from + 0.5, from + 3.0] };
    let moving = [MovingStroke { tool: &tool, area: good, range: &jumping }];
    for node in -10..10 {
        let plan = NodePlan { interval: (f64::from(node), f64::from(node) + 1.0), nodes: 2 };
        match StrokedWorm::solve(&moving, Flank::Left, RADIUS, &plan, &|_, _| 0.0) {
            Ok(worm) => assert_eq!(worm.strokes().len(), 1),
            Err(error) => says(&error, "not-converged", &["pitch points"]),
        }
    }
}

#[test]
fn influences_are_exact_and_of_first_order() {
    let tool = tool();
    let w = equidistant(range(&tool), 7);
    let dk = [0.002, -0.004, 0.05, 0.7];
    let deviation = [1e-4, 2e-4, 0.01, 0.05];
    for flank in Flank::BOTH {
        let at = |factor: f64| {
            let found = influence(&tool, flank, dk, deviation.map(|x| factor * x), &w).unwrap();
            let linear = |i: usize| found.first_order.iter().map(|f| f[i]).sum::<f64>();
            (0..w.len()).map(|i| found.exact[i] - linear(i)).fold(0.0_f64, |m, x| m.max(x.abs()))
        };
        // What first order leaves falls with the square of the deviation.
        let (whole, half) = (at(1.0), at(0.5));
        assert!(whole > 1e-9 && whole < 1e-4 && (whole / half - 4.0).abs() < 0.2, "{whole} {half}");
    }
    let found = influence(&tool, Flank::Left, dk, deviation, &w).unwrap();
    let [real, ideal] = [[0, 1, 2, 3].map(|j| dk[j] + deviation[j]), dk]
        .map(|dk| DressedProfile::new(&tool, Flank::Left, dk).at_roll(w[3]).unwrap().f);
    assert_eq!(found.exact[3], real - ideal);
    let refused = |dk: DressingCorrection, deviation: DressingCorrection, w: &[f64]| {
        influence(&tool, Flank::Left, dk, deviation, w).unwrap_err()
    };
    says(&refused([f64::NAN; 4], deviation, &w), "invalid-number", &["dressing correction"]);
    says(&refused(dk, [f64::INFINITY; 4], &w), "invalid-number", &["deviation of an axis", "inf"]);
    says(&refused(dk, deviation, &[]), "invalid-number", &["number of lengths of roll"]);
    says(&refused(dk, deviation, &[-1.0]), "invalid-number", &["length of roll", "-1"]);
}

/// Sums of twelve draws that are even over 0..1 less 6: nearly normal, from a generator other than the library's.
fn noise(sigma: f64, count: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut draw = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..count).map(|_| sigma * ((0..12).map(|_| draw()).sum::<f64>() - 6.0)).collect()
}

const NOISE: f64 = 1e-4;
const TRUE: DressingCorrection = [2e-4, 3e-4, 0.012, -0.04];

fn measured(tool: &DresserTool, flank: Flank, dk: DressingCorrection, seed: u64) -> (Vec<f64>, Vec<f64>) {
    let w = equidistant(range(tool), 25);
    let real = std::array::from_fn(|j| dk[j] + TRUE[j]);
    let points = DressedProfile::new(tool, flank, real).at_rolls(&w).unwrap();
    let f = points.iter().zip(noise(NOISE, w.len(), seed)).map(|(p, noise)| p.f + noise).collect();
    (w, f)
}

#[test]
fn deviations_come_back_from_noisy_measurements() {
    let tool = tool();
    let mut normalised = [0.0; 4];
    let rounds = 12;
    for seed in 0..rounds {
        let (w, left) = measured(&tool, Flank::Left, [0.0; 4], 2 * seed);
        let (_, right) = measured(&tool, Flank::Right, [0.0; 4], 2 * seed + 1);
        let both = [
            Measurement { flank: Flank::Left, dk: [0.0; 4], w: &w, f: &left },
            Measurement { flank: Flank::Right, dk: [0.0; 4], w: &w, f: &right },
        ];
        let known = Recovery { noise: NOISE, held: [None; 4] };
        let found = recover_deviation(&tool, RADIUS, &both, &known).unwrap();
        for j in 0..4 {
            let off = (found.deviation[j] - TRUE[j]) / found.standard_deviation[j];
            assert!(off.abs() < 4.0, "{j}: {off}");
            normalised[j] += off * off;
        }
        assert!((found.residual_rms / NOISE - 1.0).abs() < 0.4, "{}", found.residual_rms);
        assert!(found.singular_values.windows(2).all(|s| s[0] >= s[1]) && found.singular_values.len() == 4);
    }
    // The standard deviations are neither too small nor too large: chi-square of 12 rounds.
    for sum in normalised {
        assert!(sum > 2.0 && sum < 36.0, "{normalised:?}");
    }
}

#[test]
fn one_flank_alone_tells_three_combinations() {
    let tool = tool();
    let (w, f) = measured(&tool, Flank::Left, [0.0; 4], 5);
    let left = Measurement { flank: Flank::Left, dk: [0.0; 4], w: &w, f: &f };
    let free = Recovery { noise: NOISE, held: [None; 4] };
    let error = recover_deviation(&tool, RADIUS, &[left], &free).unwrap_err();
    says(&error, "not-identifiable", &["does not determine", "singular values"]);
    let DressingError::NotIdentifiable { singular_values, standard_deviation, .. } = &error else { panic!() };
    assert!(singular_values[3] / singular_values[0] < 1e-5 && *standard_deviation > 0.0, "{error:?}");
    assert!(error.way_out().contains("both flanks") && error.way_out().contains("hold"));

    // Holding the offset, or knowing what other corrections do, tells the rest.
    let held = Recovery { held: [None, None, None, Some(TRUE[3])], ..free };
    let found = recover_deviation(&tool, RADIUS, &[left], &held).unwrap();
    assert_eq!((found.deviation[3], found.standard_deviation[3]), (TRUE[3], 0.0));
    for j in 0..3 {
        assert!((found.deviation[j] - TRUE[j]).abs() < 4.0 * found.standard_deviation[j], "{j}: {found:?}");
    }
    let changes: [DressingCorrection; 3] = [[0.0; 4], [0.0, 0.04, 0.0, 0.0], [0.0, -0.04, 0.0, 3.0]];
    let several: Vec<_> =
        changes.iter().zip(6..).map(|(&dk, seed)| (dk, measured(&tool, Flank::Left, dk, seed))).collect();
    let measurements: Vec<Measurement<'_>> =
        several.iter().map(|(dk, (w, f))| Measurement { flank: Flank::Left, dk: *dk, w, f }).collect();
    let found = recover_deviation(&tool, RADIUS, &measurements, &free).unwrap();
    for j in 0..4 {
        assert!((found.deviation[j] - TRUE[j]).abs() < 4.0 * found.standard_deviation[j], "{j}: {found:?}");
    }
}

#[test]
fn measurements_that_say_nothing_are_refused() {
    let tool = tool();
    let (w, f) = measured(&tool, Flank::Left, [0.0; 4], 5);
    let good = Measurement { flank: Flank::Left, dk: [0.0; 4], w: &w, f: &f };
    let free = Recovery { noise: NOISE, held: [None; 4] };
    let refused = |measurements: &[Measurement<'_>], known: &Recovery| {
        recover_deviation(&tool, RADIUS, measurements, known).unwrap_err()
    };
    says(&refused(&[], &free), "invalid-number", &["number of measured profiles"]);
    says(&refused(&[Measurement { w: &[], f: &[], ..good }], &free), "invalid-number", &["lengths of roll"]);
    says(
        &refused(&[Measurement { f: &f[1..], ..good }], &free),
        "invalid-number",
        &["measured values", "24"],
    );
    let mut broken = f.clone();
    broken[3] = f64::NAN;
    says(
        &refused(&[Measurement { f: &broken, ..good }], &free),
        "invalid-number",
        &["measured modification"],
    );
    says(&refused(&[Measurement { dk: [f64::NAN; 4], ..good }], &free), "invalid-number", &["correction of"]);
    for noise in [0.0, -1e-4, f64::NAN] {
        says(&refused(&[good], &Recovery { noise, ..free }), "invalid-number", &["standard deviation"]);
    }
    let all = Recovery { held: [Some(0.0); 4], ..free };
    says(&refused(&[good], &all), "invalid-number", &["held components", "at most 3"]);
    let nan = Recovery { held: [Some(f64::NAN), None, None, None], ..free };
    says(&refused(&[good], &nan), "invalid-number", &["held component"]);
    // Two points are fewer rows than unknowns.
    let few = Measurement { w: &w[..2], f: &f[..2], ..good };
    let error = refused(&[few], &Recovery { held: [None, None, None, Some(0.0)], ..free });
    says(&error, "not-identifiable", &["inf"]);
}

#[test]
fn draws_do_not_depend_on_the_threads_and_scatter_as_the_derivatives_say() {
    let tool = tool();
    let axes = [Spread::Normal(5e-5), Spread::Uniform(1e-4), Spread::Normal(0.003), Spread::Uniform(0.02)];
    let spreads = Spreads { axes, samples: 2000, seed: 1 };
    let levels = [0.0, 0.158_655, 0.5, 0.841_345, 1.0];
    let run = |threads: usize, seed: u64| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let spreads = Spreads { seed, ..spreads };
        pool.install(|| spread_of_profile(&tool, [0.0; 4], &spreads, &levels, &Silent).unwrap())
    };
    let found = run(1, 1);
    assert_eq!(found, run(2, 1));
    assert_ne!(found, run(2, 2));
    // To first order the slope is a sum of independent parts; of nearly normal sums 68 percent lie within one standard deviation.
    let [from, to] = range(&tool);
    for flank in Flank::BOTH {
        let at = |w: f64| DressedProfile::new(&tool, flank, [0.0; 4]).at_roll(w).unwrap().df_dk;
        let (start, end) = (at(from), at(to));
        let sigma = [5e-5, 1e-4 / 3f64.sqrt(), 0.003, 0.02 / 3f64.sqrt()];
        let slope = (0..4).map(|j| ((end[j] - start[j]) * sigma[j]).powi(2)).sum::<f64>().sqrt();
        let q = &found.quantiles[flank];
        let half = 0.5 * (q.slope[3] - q.slope[1]);
        assert!((half / slope - 1.0).abs() < 0.1, "{half} {slope}");
        assert!(q.slope[2].abs() < 0.1 * slope);
        for list in [&q.largest, &q.slope, &q.crowning] {
            assert!(list.windows(2).all(|p| p[0] <= p[1]), "{list:?}");
        }
        assert!(q.largest[0] >= 0.0 && q.crowning[4].abs() < q.largest[4]);
    }
}

#[test]
fn draws_that_cannot_be_are_refused() {
    let tool = tool();
    let good = Spreads { axes: [Spread::Normal(1e-5); 4], samples: 3, seed: 0 };
    let refused = |spreads: Spreads, levels: &[f64]| {
        spread_of_profile(&tool, [0.0; 4], &spreads, levels, &Silent).unwrap_err()
    };
    let axes =
        |spread: Spread| Spreads { axes: [Spread::Normal(0.0), spread, good.axes[2], good.axes[3]], ..good };
    says(&refused(axes(Spread::Normal(-1.0)), &[0.5]), "invalid-number", &["standard deviation", "-1"]);
    says(&refused(axes(Spread::Uniform(f64::NAN)), &[0.5]), "invalid-number", &["half width", "NaN"]);
    says(&refused(Spreads { samples: 0, ..good }, &[0.5]), "invalid-number", &["number of draws", "0"]);
    says(&refused(Spreads { samples: usize::MAX, ..good }, &[0.5]), "invalid-number", &["10 million"]);
    says(&refused(good, &[]), "invalid-number", &["number of quantiles"]);
    says(&refused(good, &[1.5]), "invalid-number", &["level of a quantile", "1.5"]);
    // Deviations that tear the dresser off the worm: the first draw is named by its error.
    let wild = refused(
        Spreads { axes: [Spread::Normal(0.0), Spread::Normal(3.0), good.axes[2], good.axes[3]], ..good },
        &[0.5],
    );
    assert!(matches!(wild, DressingError::NoContact { .. } | DressingError::OutOfDresser { .. }), "{wild}");
}
