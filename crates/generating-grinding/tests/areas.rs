//! Areas of different diagonal ratio, their place on the worm, strokes with inactive threads, equal swivel: properties and every
//! refusal. The reference numbers are checked by `verify`.

use crate::cylindrical_pair::{lines, pair};
use foundation::geometry::{Flank, Sides};
use foundation::modification::{CornerFace, CornerProfile, FlankChoice, Reference, TriangularSpec};
use foundation::numerics::Polynomial2;
use generating::areas::{
    AreaKind, AreaPlan, AreaSet, AreaTask, Demand, Occupation, PlaceKind, Region, conflicts, feed_intervals,
};
use generating::{
    EqualSwivel, FlankLines, GeneratingError, Strokes, SwivelSide, decompose_diagonal, equal_swivel,
};
use generating_grinding::workflow::occupation_chart;
use proptest::prelude::*;
use report::charts::worm_occupation_chart;

fn relief(
    corner_profile: CornerProfile,
    corner_face: CornerFace,
    length_w_mm: f64,
    length_z_mm: f64,
) -> TriangularSpec {
    TriangularSpec {
        amount_um: 10.0,
        corner_profile,
        corner_face,
        length_w_mm,
        length_z_mm,
        exponent: 1.0,
        transition: 0.0,
        flank: FlankChoice::Both,
        reference: Reference::Transverse,
    }
}

fn region(lines: &FlankLines, tip: bool, face_2: bool, size: [f64; 2]) -> Region {
    let profile = if tip { CornerProfile::Tip } else { CornerProfile::Root };
    let face = if face_2 { CornerFace::II } else { CornerFace::I };
    Region::of_triangular_relief(&relief(profile, face, size[0], size[1]), lines).unwrap()
}

fn left_only(lines: FlankLines) -> Sides<Option<FlankLines>> {
    Sides { left: Some(lines), right: None }
}

/// Figure 23: two corners of the left flank with lines of the same direction.
fn two_corners(free_ratio: f64) -> AreaTask {
    let lines = lines(&pair(20.0), Flank::Left);
    let regions = vec![region(&lines, true, true, [6.0, 8.0]), region(&lines, false, false, [6.0, 8.0])];
    AreaTask { lines: left_only(lines), regions, free_ratio }
}

fn roughing(ratio: f64) -> AreaPlan {
    AreaTask { regions: Vec::new(), ..two_corners(ratio) }.plan().unwrap()
}

/// Ranges of z_1 and worm lines by brute force over the flank.
fn brute_extent(plan: &AreaPlan, lines: &FlankLines) -> [[f64; 2]; 2] {
    let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let ([w0, w1], [z0, z1]) = (lines.roll, lines.face);
    for i in 0..=200 {
        for j in 0..=800 {
            let (w, z) = (w0 + (w1 - w0) * f64::from(i) / 200.0, z0 + (z1 - z0) * f64::from(j) / 800.0);
            let shift = plan.shift.value(lines.path_feed(w, z));
            let w_1 = lines.worm_roll(w);
            let z_1 = lines.c_c1 - lines.worm_path * w_1 - shift;
            for (range, x) in ranges.iter_mut().zip([z_1, z_1 + lines.t_1 * w_1]) {
                *range = [range[0].min(x), range[1].max(x)];
            }
        }
    }
    ranges
}

#[test]
fn the_extent_is_that_of_the_whole_flank() {
    for free in [0.0, 0.4, 2.0, -0.5] {
        let task = two_corners(free);
        let plan = task.plan().unwrap();
        let extent = plan.extents.left.unwrap();
        let brute = brute_extent(&plan, task.lines.left.as_ref().unwrap());
        for (exact, brute) in [extent.z_1, extent.line].into_iter().zip(brute) {
            // The grid misses corners of the segments by at most a step.
            assert!(exact[0] <= brute[0] + 1e-9 && exact[0] > brute[0] - 0.15, "{exact:?} {brute:?}");
            assert!(exact[1] >= brute[1] - 1e-9 && exact[1] < brute[1] + 0.15, "{exact:?} {brute:?}");
        }
        assert!((plan.length() - (extent.z_1[1] - extent.z_1[0])).abs() < 1e-12);
        assert!((plan.pitch() - (extent.line[1] - extent.line[0])).abs() < 1e-12);
    }
}

#[test]
fn a_constant_ratio_has_the_closed_lengths() {
    let task = two_corners(0.0);
    let lines = task.lines.left.unwrap();
    for k in [0.0, 0.6, -0.9, 2.5] {
        let plan = roughing(k);
        let (b, l_a) = (lines.face[1] - lines.face[0], lines.roll[1] - lines.roll[0]);
        let (sin_b1, tan_b2) = (lines.worm_path * lines.cos_b1 * lines.s, lines.t_k * lines.s);
        let length = k.abs() * b + (sin_b1 / lines.cos_b2 + k * tan_b2).abs() * l_a;
        let pitch = k.abs() * b + (k * lines.t_k - lines.big_t1 / lines.cos_b2).abs() * l_a;
        assert!((plan.length() - length).abs() < 1e-10 && (plan.pitch() - pitch).abs() < 1e-10, "{k}");
        assert!(plan.shared.is_empty() && plan.segments.len() == 1);
        let usable = length + 2.5 * pitch;
        assert_eq!(plan.areas_on(usable).unwrap(), 3);
        // Rounding of a width that is met exactly takes no area away.
        assert_eq!((1..9).map(|n| plan.areas_on(length + f64::from(n) * pitch).unwrap()).sum::<usize>(), 44);
        assert!(plan.areas_on(1e300).unwrap() > 1_000_000);
        let short = plan.areas_on(length - 0.01).unwrap_err();
        assert_eq!((short.code(), short.is_bad_input()), ("worm-too-short", false));
        assert_eq!(plan.areas_on(f64::NAN).unwrap_err().code(), "invalid-number");
    }
}

#[test]
fn overlapping_regions_of_different_ratio_are_refused() {
    let mut task = two_corners(0.0);
    let lines = task.lines.left.unwrap();
    task.regions[0] = region(&lines, true, true, [6.0, 26.0]);
    task.regions[1] = region(&lines, false, false, [7.0, 18.0]);
    let error = task.plan().unwrap_err();
    let GeneratingError::AreasOverlap { first, second } = &error else { panic!("{error}") };
    assert!(first.feed[0] < second.feed[0] && second.feed[0] < first.feed[1] && first.ratio != second.ratio);
    assert_eq!((error.code(), error.is_bad_input()), ("areas-overlap", false));
    assert!(error.to_string().contains("left") && !error.way_out().is_empty());
    assert_eq!(conflicts(&feed_intervals(&task).unwrap()), [[0, 1]]);
    // The same ratio on both: one segment.
    for region in &mut task.regions {
        region.demand = Demand::Ratio(0.7);
    }
    let plan = task.plan().unwrap();
    assert_eq!(plan.segments.iter().filter(|s| s.modified).count(), 1);
}

#[test]
fn reversing_the_shift_shares_worm_lines() {
    let plan = two_corners(-0.5).plan().unwrap();
    let error = plan.check_exclusive().unwrap_err();
    let GeneratingError::WormLinesShared { largest, shared } = &error else { panic!("{error}") };
    assert_eq!(shared, &plan.shared);
    assert!(
        shared.len() == 4 && shared.iter().all(|s| s.overlap <= largest.overlap && s.flank == Flank::Left)
    );
    assert_eq!((error.code(), error.is_bad_input()), ("worm-lines-shared", false));
    assert!(error.to_string().contains("4 worm line ranges") && !error.way_out().is_empty());
    two_corners(0.5).plan().unwrap().check_exclusive().unwrap();
}

#[test]
fn bad_regions_and_tasks_are_refused() {
    let good = two_corners(0.0);
    let lines = good.lines.left.unwrap();
    let code = |change: &dyn Fn(&mut AreaTask)| {
        let mut task = good.clone();
        change(&mut task);
        let error = task.plan().unwrap_err();
        assert!(error.is_bad_input() && !error.way_out().is_empty() && !error.to_string().is_empty());
        error.code()
    };
    assert_eq!(code(&|t| t.free_ratio = f64::NAN), "invalid-number");
    assert_eq!(code(&|t| t.lines.left = None), "no-flank");
    assert_eq!(code(&|t| t.regions[0].flank = Flank::Right), "invalid-region");
    assert_eq!(code(&|t| t.regions[0].polygon.truncate(2)), "invalid-region");
    assert_eq!(code(&|t| t.regions[1].polygon[0][0] = f64::NAN), "invalid-region");
    assert_eq!(code(&|t| t.regions[1].polygon[0][1] += 40.0), "invalid-region");
    assert_eq!(code(&|t| t.regions[1].demand = Demand::Direction(f64::NAN)), "invalid-region");
    assert_eq!(code(&|t| t.regions[1].demand = Demand::Ratio(f64::INFINITY)), "invalid-region");
    assert_eq!(code(&|t| t.regions[1].demand = Demand::Ratio(0.0)), "degenerate-direction");
    assert_eq!(code(&|t| t.regions[1].demand = Demand::Direction(lines.t_k)), "degenerate-direction");
    let parallel = FlankLines { big_t1: 0.0, ..lines };
    assert_eq!(code(&|t| t.lines.left = Some(parallel)), "worm-direction-degenerate");
    for lines in
        [FlankLines { c_c2: f64::NAN, ..lines }, FlankLines { face: [1.0, 1.0], roll: [9.0, 9.0], ..lines }]
    {
        assert_eq!(code(&|t| t.lines.left = Some(lines)), "invalid-number");
    }
    for (l_w, l_z, transition) in [(0.0, 8.0, 0.0), (6.0, f64::NAN, 0.0), (6.0, 8.0, -0.1)] {
        let spec = TriangularSpec { transition, ..relief(CornerProfile::Tip, CornerFace::I, l_w, l_z) };
        let error = Region::of_triangular_relief(&spec, &lines).unwrap_err();
        assert_eq!(error.code(), "invalid-number");
    }
}

#[test]
fn a_relief_needs_lines_where_it_removes_anything() {
    let lines = lines(&pair(20.0), Flank::Left);
    let plain = region(&lines, true, true, [6.0, 8.0]);
    assert_eq!(plain.polygon.len(), 3);
    assert_eq!(plain.demand, Demand::Direction(8.0 / 6.0));
    assert_eq!(region(&lines, false, true, [6.0, 8.0]).demand, Demand::Direction(-8.0 / 6.0));
    // A rounded start begins earlier by its share of the lengths.
    let spec = TriangularSpec { transition: 0.25, ..relief(CornerProfile::Tip, CornerFace::II, 6.0, 8.0) };
    let wide = Region::of_triangular_relief(&spec, &lines).unwrap();
    let reach = |r: &Region| r.polygon.iter().map(|p| lines.face[1] - p[1]).fold(0.0, f64::max);
    assert!((reach(&plain) - 8.0).abs() < 1e-12 && (reach(&wide) - 10.0).abs() < 1e-12);
    // A relief longer than the field is cut off at its edges.
    let long = region(&lines, true, true, [40.0, 50.0]);
    assert!(long.polygon.len() >= 4);
    assert!(long.polygon.iter().all(|p| p[0] >= lines.roll[0] - 1e-12 && p[1] >= lines.face[0] - 1e-12));
}

#[test]
fn rounding_leaves_the_regions_their_ratio() {
    let task = two_corners(0.1);
    let plan = task.plan().unwrap();
    let law = plan.rounded_shift(2.0).unwrap();
    for interval in &plan.intervals {
        for k in 0..=20 {
            let v = interval.feed[0] + (interval.feed[1] - interval.feed[0]) * f64::from(k) / 20.0;
            assert!((law.jet(v)[1] - interval.ratio).abs() < 1e-12, "at {v}");
        }
    }
    for (segment, next) in plan.segments.iter().zip(&plan.segments[1..]) {
        let corner = segment.feed[1];
        for v in [corner, corner - 4.0, corner + 4.0] {
            let (below, above) = (law.jet(v - 1e-9), law.jet(v + 1e-9));
            assert!((below[0] - above[0]).abs() < 1e-7 && (below[1] - above[1]).abs() < 1e-7, "{next:?}");
        }
    }
    // The free area is 18.8 mm long: two corners of 4 half lengths together fit up to 4.7 mm.
    assert!(plan.rounded_shift(4.7).is_ok());
    assert_eq!(plan.rounded_shift(4.8).unwrap_err().code(), "law-rounding-out-of-range");
    assert_eq!(plan.rounded_shift(0.0).unwrap_err().code(), "law-rounding-out-of-range");
    assert_eq!(roughing(0.3).rounded_shift(1.0).unwrap(), roughing(0.3).shift);
}

#[test]
fn areas_on_a_worm_share_no_lines_and_fit() {
    let (finishing, rough) = (two_corners(0.0).plan().unwrap(), roughing(0.2));
    let sets = [
        AreaSet { kind: AreaKind::Finishing, plan: &finishing, count: 2, apart: 0.0 },
        AreaSet { kind: AreaKind::Roughing, plan: &rough, count: 3, apart: 0.0 },
    ];
    let width = [-80.0, 80.0];
    let laid = Occupation::lay(width, &sets).unwrap();
    assert_eq!(laid.shifts.len(), 5);
    let of = |kind: PlaceKind| laid.places.iter().filter(move |p| p.kind == kind);
    assert_eq!((of(PlaceKind::Finishing).count(), of(PlaceKind::Roughing).count()), (2, 3));
    assert_eq!(of(PlaceKind::Modified).count(), 4);
    assert!(laid.places.iter().all(|p| p.z_1[0] >= width[0] - 1e-9 && p.z_1[1] <= width[1] + 1e-9));
    assert!(laid.places.iter().all(|p| p.z_1[1] > p.z_1[0] && p.flank == Flank::Left));
    for modified in of(PlaceKind::Modified) {
        let area = of(PlaceKind::Finishing).find(|p| p.area == modified.area).unwrap();
        assert!(modified.z_1[0] >= area.z_1[0] - 1e-9 && modified.z_1[1] <= area.z_1[1] + 1e-9);
    }
    let plans = [&finishing, &finishing, &rough, &rough, &rough];
    let line = |k: usize| plans[k].extents.left.unwrap().line.map(|x| x - laid.shifts[k]);
    for k in 0..4 {
        assert!(line(k + 1)[0] >= line(k)[1] - 1e-9, "areas {k} and {}", k + 1);
        let pitch = laid.shifts[k] - laid.shifts[k + 1] + plans[k + 1].z_1()[0] - plans[k].z_1()[0];
        assert!(pitch >= plans[k].pitch() - 1e-9);
    }
    // Equal areas lie one pitch apart exactly, and end where the rule of the specification says.
    let alone = [AreaSet { count: 4, ..sets[0] }];
    let four = Occupation::lay(width, &alone).unwrap();
    assert!((four.needed - finishing.length() - 3.0 * finishing.pitch()).abs() < 1e-9);
    assert_eq!(finishing.areas_on(160.0).unwrap(), 4);
    let five = Occupation::lay(width, &[AreaSet { count: 5, ..sets[0] }]).unwrap_err();
    assert!(matches!(five, GeneratingError::WormTooShort { needed, .. } if needed > 160.0), "{five}");
    let unused: f64 =
        four.places.iter().filter(|p| p.kind == PlaceKind::Unused).map(|p| p.z_1[1] - p.z_1[0]).sum();
    assert!((unused - (160.0 - 4.0 * finishing.length())).abs() < 1e-9);
    let endless = [AreaSet { count: usize::MAX, ..sets[0] }, sets[1]];
    for (width, sets) in
        [([0.0, 0.0], &alone[..]), ([f64::NAN, 1.0], &alone[..]), (width, &[]), (width, &endless[..])]
    {
        assert_eq!(Occupation::lay(width, sets).unwrap_err().code(), "invalid-number");
    }
}

#[test]
fn both_flanks_of_a_partition_are_drawn() {
    let pair = pair(20.0);
    let (left, right) = (lines(&pair, Flank::Left), lines(&pair, Flank::Right));
    let size = [6.0, 8.0];
    let regions = vec![
        region(&left, true, true, size),
        region(&left, false, false, size),
        region(&right, true, false, size),
        region(&right, false, true, size),
    ];
    let task = AreaTask { lines: Sides { left: Some(left), right: Some(right) }, regions, free_ratio: 0.0 };
    let finishing = task.plan().unwrap();
    let rough = AreaTask { regions: Vec::new(), free_ratio: 0.1, ..task }.plan().unwrap();
    let sets = [
        AreaSet { kind: AreaKind::Finishing, plan: &finishing, count: 2, apart: 0.0 },
        AreaSet { kind: AreaKind::Roughing, plan: &rough, count: 2, apart: 0.0 },
    ];
    let laid = Occupation::lay([-80.0, 80.0], &sets).unwrap();
    let chart = occupation_chart("Worm of 160 mm", &laid);
    assert_eq!(
        chart.rows.iter().map(|row| row.name.as_str()).collect::<Vec<_>>(),
        ["Left flank", "Right flank"]
    );
    assert_eq!(chart.rows.iter().map(|row| row.bars.len()).sum::<usize>(), laid.places.len());
    let svg = worm_occupation_chart(&chart).unwrap();
    if let Ok(path) = std::env::var("OCCUPATION_SVG") {
        std::fs::write(path, svg.to_document()).unwrap();
    }
    for label in ["1", "2", "3", "4"] {
        assert_eq!(svg.as_str().matches(&format!(">{label}</text>")).count(), 2, "area {label}");
    }
    // Only the flank that is ground has a row.
    let alone = Occupation::lay(
        [0.0, 60.0],
        &[AreaSet { plan: &two_corners(0.0).plan().unwrap(), count: 1, ..sets[0] }],
    );
    assert_eq!(occupation_chart("one flank", &alone.unwrap()).rows.len(), 1);
}

#[test]
fn strokes_reach_every_gap_with_the_fewest_offsets() {
    for threads in 1..=6usize {
        for teeth in [29, 30, 31, 32, 36, 45, 60] {
            for set in 1..(1u32 << threads) {
                let active: Vec<usize> = (0..threads).filter(|a| set >> a & 1 == 1).collect();
                let strokes = Strokes::new(threads, teeth, &active).unwrap();
                let g = strokes.common_divisor;
                assert!(threads % g == 0 && teeth % g == 0);
                let meets = |offsets: &[usize]| {
                    (0..g).all(|j| offsets.iter().any(|o| active.iter().any(|a| (a + o) % g == j)))
                };
                assert!(meets(&strokes.index_pitches), "{threads} {teeth} {active:?}");
                // No smaller set, and no set of equal size with smaller bits.
                let bits: u32 = strokes.index_pitches.iter().map(|o| 1u32 << o).sum();
                for other in 1..(1u32 << g) {
                    let offsets: Vec<usize> = (0..g).filter(|o| other >> o & 1 == 1).collect();
                    let better = offsets.len() < strokes.per_pass()
                        || (offsets.len() == strokes.per_pass() && other < bits);
                    assert!(!(better && meets(&offsets)), "{threads} {teeth} {active:?}: {offsets:?}");
                }
                assert!(strokes.feed_factor > 0.0 && strokes.feed_factor <= 1.0);
            }
        }
    }
    assert_eq!(Strokes::new(4, 30, &[0, 0]).unwrap(), Strokes::new(4, 30, &[0]).unwrap());
}

#[test]
fn strokes_refuse_what_no_worm_has() {
    let none = Strokes::new(3, 31, &[]).unwrap_err();
    assert_eq!((none.code(), none.is_bad_input()), ("no-active-thread", true));
    assert!(none.to_string().contains('3') && !none.way_out().is_empty());
    for (threads, teeth, active) in [(0, 31, 0), (25, 31, 0), (3, 0, 0), (3, 31, 3)] {
        let error = Strokes::new(threads, teeth, &[active]).unwrap_err();
        assert_eq!((error.code(), error.is_bad_input()), ("invalid-number", true), "{threads} {teeth}");
    }
}

fn swivel(pair_helix: f64, second: [[f64; 3]; 2], gain: [f64; 2]) -> Sides<SwivelSide> {
    let pair = pair(pair_helix);
    let side = |k: usize| SwivelSide {
        lines: lines(&pair, Flank::BOTH[k]),
        second_degree: second[k],
        gain: gain[k],
    };
    Sides { left: side(0), right: side(1) }
}

#[test]
fn one_ratio_gives_both_flanks_the_same_swivel() {
    let (a, b) = ([-8e-5, -1.2e-5, -4e-5], [-5e-5, -2e-5, -3e-5]);
    let sides = swivel(20.0, [a, b], [1.2, -0.9]);
    let EqualSwivel::Ratio(k) = equal_swivel(&sides).unwrap() else { panic!("one ratio") };
    let [l, r] = [sides.left.rate(k), sides.right.rate(k)];
    assert!(l.abs() > 1e-6 && (l - r).abs() < 1e-12 * l.abs(), "{l} {r} at {k}");
    for (_, side) in sides.iter() {
        let lines = &side.lines;
        let [a_20, a_11, a_02] = side.second_degree;
        let poly = Polynomial2::from_terms([(2, 0, a_20), (1, 1, a_11), (0, 2, a_02)]);
        let parts = decompose_diagonal(&poly, lines.work_direction(k), lines.t_k, 0.0, 0.0);
        let [k_10, k_11] = side.linear_part(k, 7.0, 12.0, 2e-4);
        assert!((k_11 / parts.linear[1] - 1.0).abs() < 1e-9, "{k_11} {:?}", parts.linear);
        // psi = g b^2 F_L(X_2) at the dresser's place and a mm further.
        let x_2 = |xi_1: f64| {
            let t = lines.work_direction(k);
            (lines.c_c2 + (7.0 - lines.c_c1 - lines.big_t1 * lines.e + xi_1) / k) / t.hypot(1.0)
        };
        let b = lines.cos_b2 / lines.cos_b1;
        let psi = |xi_1: f64| side.gain * b * b * (k_10 + k_11 * x_2(xi_1));
        assert!((psi(12.0) - 2e-4).abs() < 1e-12);
        assert!((psi(13.0) - psi(12.0) - l).abs() < 1e-9 * l.abs());
    }
}

#[test]
fn symmetric_flanks_swivel_alike_at_every_ratio_and_others_at_none() {
    // Half-turn symmetric: f_r(w, z) = f_l(w, -z).
    let every = swivel(20.0, [[-8e-5, -1e-5, -4e-5], [-8e-5, 1e-5, -4e-5]], [1.0, -1.0]);
    assert_eq!(equal_swivel(&every).unwrap(), EqualSwivel::Every);
    // Profile crowning alone has no part over K; here it differs.
    let none = swivel(20.0, [[-8e-5, 0.0, 0.0], [-5e-5, 0.0, 0.0]], [1.0, -1.0]);
    let error = equal_swivel(&none).unwrap_err();
    assert!(matches!(error, GeneratingError::NoCommonSwivel { numerator: 0.0, .. }), "{error}");
    assert_eq!((error.code(), error.is_bad_input()), ("no-common-swivel", false));
    assert!(!error.way_out().is_empty() && error.to_string().contains("swivel"));
    for (second, gain) in [([0.0; 3], 0.0), ([0.0; 3], f64::NAN), ([f64::NAN, 0.0, 0.0], 1.0)] {
        let error = equal_swivel(&swivel(20.0, [second, [0.0; 3]], [gain, 1.0])).unwrap_err();
        assert_eq!(error.code(), "invalid-number");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Whatever the regions: either they are refused as overlapping, or the tool shift is continuous, every region has its ratio,
    /// free areas have theirs, and with ratios of one sign no worm line is used twice.
    #[test]
    fn plans_are_continuous_and_give_every_region_its_ratio(
        left_hand: bool, both: bool, sizes in prop::array::uniform4((3.0..12.0f64, 3.0..16.0f64)),
        count in 0..3usize, free in -0.5..2.0f64,
    ) {
        let pair = pair(if left_hand { -20.0 } else { 20.0 });
        let (left, right) = (lines(&pair, Flank::Left), lines(&pair, Flank::Right));
        // Directions of one sign per flank, mirrored on the other: ratios of one sign.
        let size = |k: usize| [sizes[k].0, sizes[k].1];
        let mut regions = vec![region(&left, true, true, size(0)), region(&left, false, false, size(1))];
        if both {
            regions.push(region(&right, true, false, size(2)));
            regions.push(region(&right, false, true, size(3)));
        }
        regions.truncate(count + usize::from(both) * 2);
        let lines = Sides { left: Some(left), right: both.then_some(right) };
        let task = AreaTask { lines, regions, free_ratio: free };
        let intervals = feed_intervals(&task).unwrap();
        let plan = match task.plan() {
            Ok(plan) => plan,
            Err(GeneratingError::AreasOverlap { .. }) => {
                prop_assert!(!conflicts(&intervals).is_empty());
                return Ok(());
            }
            Err(error) => return Err(TestCaseError::fail(error.to_string())),
        };
        prop_assert!(conflicts(&intervals).is_empty());
        for pair in plan.segments.windows(2) {
            prop_assert_eq!(pair[0].feed[1], pair[1].feed[0]);
            let v = pair[0].feed[1];
            let at = |k: usize| pair[k].ratio * v + pair[k].shift_origin;
            prop_assert!((at(0) - at(1)).abs() < 1e-11 && (plan.shift.value(v) - at(0)).abs() < 1e-11);
        }
        for segment in &plan.segments {
            let middle = 0.5 * (segment.feed[0] + segment.feed[1]);
            prop_assert!((plan.shift.jet(middle)[1] - segment.ratio).abs() < 1e-9);
            prop_assert!(segment.modified || segment.ratio == free);
        }
        for interval in &intervals {
            for share in [1e-3, 0.5, 1.0 - 1e-3] {
                let v = interval.feed[0] + share * (interval.feed[1] - interval.feed[0]);
                prop_assert!((plan.shift.jet(v)[1] - interval.ratio).abs() < 2e-9);
            }
        }
        let one_sign = intervals.iter().all(|i| i.ratio > 0.0) && free >= 0.0;
        prop_assert!(!one_sign || plan.shared.is_empty(), "{:?}", plan.shared);
        prop_assert_eq!(plan.shared.is_empty(), plan.check_exclusive().is_ok());
    }
}
