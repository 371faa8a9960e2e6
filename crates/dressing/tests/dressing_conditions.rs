//! Sets of conditions, conditions that vary along the worm and compensation: what is found is held against the forward
//! calculation, and every refusal against its code and message.

use crate::dressing_bodies::{Bodies, CASE_A, bodies, flanks};
use dressing::{
    Compensation, Condition, ConditionSolver, DressedProfile, DressedWorm, DresserTool, DressingError,
    NodePlan, NodeSolution, PathReason, PitchPlace, PitchPoint, RowAlong, RowSet, RowsAlong, SoftCondition,
    WidthLaw, four_points, head_gradient, map_of_upper_end, missed_rows, shift_through,
    solve_dressing_motion, solve_rows_along, solve_rows_at, stretch, three_points, three_points_with_map,
    two_flank_points, two_points,
};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::DressingCorrection;
use foundation::numerics::value_of;
use proptest::prelude::*;

fn says(error: &DressingError, code: &str, parts: &[&str]) {
    assert_eq!(error.code(), code, "{error}");
    let text = error.to_string();
    assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    assert!(!error.way_out().is_empty());
}

/// Case A with the head part of a combination dresser.
fn with_head() -> DresserTool {
    CASE_A.tool().unwrap().with_head(53.5, 1.5).unwrap()
}

/// Largest residual of conditions, computed without the solver, mm or rad.
fn missed(tool: &DresserTool, rows: &[Condition], dk: DressingCorrection) -> f64 {
    let one = |row: &Condition| match *row {
        Condition::Point { flank, w, f } => DressedProfile::new(tool, flank, dk).at_roll(w).unwrap().f - f,
        Condition::Map { flank, t, w } => DressedProfile::new(tool, flank, dk).at_parameter(t).unwrap().w - w,
        Condition::Head { t, r } => head_gradient(tool, t, &dk).unwrap().0 - r,
        Condition::Fixed { j, x } => dk[j] - x,
    };
    rows.iter().map(|row| one(row).abs()).fold(0.0, f64::max)
}

#[test]
fn sets_of_conditions_by_name_are_met() {
    let tool = with_head();
    let solver = ConditionSolver::new(&tool, 50.0);
    let (left, right) = (tool.flanks.left.range, tool.flanks.right.range);
    let point = |flank, w, f| PitchPoint { flank, w, f };
    let (l, r) = (Flank::Left, Flank::Right);
    let three = [point(l, left.w_nf, 0.0), point(l, left.middle(), -0.001), point(l, left.w_na, 0.0)];
    let two = [point(l, left.w_nf, 0.0008), point(l, left.w_na, -0.0012)];
    let head =
        |dk: &DressingCorrection, t: f64| Condition::Head { t, r: head_gradient(&tool, t, dk).unwrap().0 };
    let small = [1e-4, -2e-3, -0.004, 0.1];
    let mixed =
        [point(l, left.w_nf, -0.001), point(r, right.w_na, -0.002), point(r, right.middle(), -0.0015)];
    let sets = [
        three_points(three, map_of_upper_end(&tool.flanks.left)),
        three_points_with_map(&tool.flanks.left, [0.001, -0.0005, 0.0]),
        three_points(three, Condition::Head { t: 0.0, r: 53.5 }),
        three_points(three, Condition::Fixed { j: 3, x: 1.9 }),
        three_points(mixed, map_of_upper_end(&tool.flanks.right)),
        two_points(two, [head(&small, -0.6), head(&small, 0.7)]),
        two_points(two, [map_of_upper_end(&tool.flanks.left), Condition::Fixed { j: 0, x: 0.0005 }]),
        two_points(two, [Condition::Fixed { j: 1, x: 0.001 }, Condition::Fixed { j: 3, x: 0.2 }]),
        two_points(
            [point(l, left.w_nf, 0.001), point(r, right.w_nf, 0.001)],
            [Condition::Fixed { j: 1, x: 0.001 }, map_of_upper_end(&tool.flanks.left)],
        ),
        two_flank_points(&tool, [0.003, 0.005], [0.004, 0.002]),
    ];
    for rows in sets {
        let dk = solver.solve(&rows, &[0.0; 4]).unwrap_or_else(|error| panic!("{rows:?}: {error}"));
        assert!(missed(&tool, &rows, dk) < 1e-9, "{rows:?}: {dk:?}");
    }
    // Four points on one flank are practically singular: with values of a dressed profile they are met all the same.
    let dk = [2e-4, -3e-3, -0.005, 0.4];
    let profile = DressedProfile::new(&tool, Flank::Left, dk);
    let four = four_points([0.0, 0.35, 0.7, 1.0].map(|x| {
        let w = left.w_nf + x * left.length();
        point(l, w, profile.at_roll(w).unwrap().f)
    }));
    let found = solver.solve(&four, &[0.0; 4]).unwrap();
    assert!(missed(&tool, &four, found) < 1e-9);
}

#[test]
fn radii_and_lines_of_contact_become_conditions() {
    let tool = CASE_A.tool().unwrap();
    let dresser = &tool.flanks.left;
    let t = 0.4 * dresser.range.w_nf + 0.6 * dresser.range.w_na;
    let radius = value_of(dresser.profile.at(t).r);
    let map = Condition::map_of_radii(dresser, radius, dresser.worm.radius(44.0)).unwrap();
    let Condition::Map { flank: Flank::Left, t: found, w } = map else { panic!("{map:?}") };
    assert!((found - t).abs() < 1e-9 && (w - 44.0).abs() < 1e-12);
    says(
        &Condition::map_of_radii(dresser, 10.0, 50.0).unwrap_err(),
        "invalid-number",
        &["dresser radius", "10"],
    );
    says(
        &Condition::map_of_radii(dresser, radius, 3.0).unwrap_err(),
        "invalid-number",
        &["worm radius", "3"],
    );
    says(&Condition::map_of_radii(dresser, f64::NAN, 50.0).unwrap_err(), "invalid-number", &["NaN"]);
    // The fifth condition: the position of the worm at which the line of contact goes through a point.
    let dk = [1e-4, -2e-3, -0.004, 0.3];
    let v = shift_through(&tool, Flank::Left, &dk, 44.0, 2.5).unwrap();
    let at = DressedProfile::new(&tool, Flank::Left, dk).at_roll(44.0).unwrap();
    assert!((at.b - v - 2.5).abs() < 1e-12);
    let error = shift_through(&tool, Flank::Left, &dk, 44.0, f64::NAN).unwrap_err();
    says(&error, "invalid-number", &["contact line"]);
}

/// Amounts that a worm and its dresser allow: a share of the range of one flank.
fn crowned(bodies: &Bodies, tool: &DresserTool, flank: Flank, share: f64) -> Option<DressingCorrection> {
    use dressing::{CrowningLimits, CrowningRows};
    let rows = CrowningRows::new(&tool.flanks[flank], bodies.radius(), 0.5);
    let range = rows.range(&CrowningLimits::default()).ok()?;
    let largest = f64::min(range.largest.crowning, 0.003);
    let crowning =
        if share < 0.0 { share * range.smallest.crowning.abs().min(0.003) } else { share * largest };
    let wish = three_points_with_map(&tool.flanks[flank], [0.0, -crowning * 0.5f64.cos(), 0.0]);
    ConditionSolver::new(tool, bodies.radius()).solve(&wish, &[0.0; 4]).ok()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Rows with values taken from a correction have that correction as solution, whatever rows they are.
    #[test]
    fn rows_of_a_correction_lead_back_to_it(
        bodies in bodies(),
        flank in flanks(),
        share in -0.5..0.5f64,
        kind in 0..4usize,
    ) {
        let Ok(tool) = bodies.tool() else { return Ok(()) };
        let Some(dk) = crowned(&bodies, &tool, flank, share) else {
            return Err(TestCaseError::fail("half of the range was not reached"));
        };
        let range = tool.flanks[flank].range;
        // On the smallest worms the dressed profile may fold over itself between the pitch points.
        let Ok(made) = DressedProfile::new(&tool, flank, dk).at_rolls(&[range.w_nf, range.middle(), range.w_na])
        else {
            return Ok(());
        };
        let here = [0, 1, 2].map(|i| PitchPoint { flank, w: made[i].w, f: made[i].f });
        let rows = match kind {
            0 => three_points(here, map_of_upper_end(&tool.flanks[flank])),
            1 => three_points(here, Condition::Fixed { j: 1, x: dk[1] }),
            2 => two_points([here[0], here[2]], [Condition::Fixed { j: 1, x: dk[1] }, Condition::Fixed { j: 3, x: dk[3] }]),
            _ => two_points([here[0], here[2]], [map_of_upper_end(&tool.flanks[flank]), Condition::Fixed { j: 3, x: dk[3] }]),
        };
        let solver = ConditionSolver::new(&tool, bodies.radius());
        // Another solution of the same rows may be found: they are met all the same.
        let found = match solver.solve(&rows, &dk.map(|x| 0.9 * x)) {
            // The way from there may leave the dresser: then the correction itself is where it leads back to.
            Err(DressingError::NoZero { reason: PathReason::OutOfDresser, .. }) => solver.solve(&rows, &dk),
            found => found,
        }
        .unwrap();
        prop_assert!(missed(&tool, &rows, found) < 1e-8);
    }
}

#[test]
fn the_way_to_a_target_says_where_and_why_it_ends() {
    let tool = CASE_A.tool().unwrap();
    let solver = ConditionSolver::new(&tool, 50.0);
    let crowning = |c: f64| three_points_with_map(&tool.flanks.left, [0.0, -c, 0.0]);
    // Beyond the fold of negative crownings the share of the target is that of the fold.
    let shares: Vec<f64> = [-0.010, -0.020]
        .map(|c| match solver.solve(&crowning(c), &[0.0; 4]).unwrap_err() {
            DressingError::NoZero { fraction, reason: PathReason::Fold, .. } => fraction * c,
            other => panic!("{other}"),
        })
        .into();
    assert!((shares[0] - shares[1]).abs() < 1e-7 && shares[0] < -0.003, "{shares:?}");
    let error = solver.solve(&crowning(-0.02), &[0.0; 4]).unwrap_err();
    says(&error, "no-zero", &["left", "percent (fold)"]);
    // Beyond contact, beyond the profile of a narrow dresser and beyond an axis.
    let error = solver.solve(&crowning(0.08), &[0.0; 4]).unwrap_err();
    says(&error, "no-zero", &["(contact lost)"]);
    let narrow =
        DresserTool::conjugate_beyond(&CASE_A.worm(), CASE_A.chains(), CASE_A.ranges(), 0.01).unwrap();
    let below = ConditionSolver::new(&narrow, 50.0)
        .solve(&three_points_with_map(&narrow.flanks.left, [0.0, 0.003, 0.0]), &[0.0; 4]);
    says(&below.unwrap_err(), "no-zero", &["(out of dresser)"]);
    let mut limits = [[-1e3, 1e3]; 4];
    limits[3] = [-0.5, 0.5];
    let bounded = solver.with_limits(limits);
    let error = bounded.solve(&crowning(0.002), &[0.0; 4]).unwrap_err();
    says(&error, "no-zero", &["(axis limit of d_v_yA)"]);
    let DressingError::NoZero { fraction, .. } = error else { panic!() };
    let at_limit = bounded.solve(&crowning(0.002 * fraction * 0.9999), &[0.0; 4]).unwrap();
    assert!((at_limit[3].abs() - 0.5).abs() < 1e-3, "{at_limit:?}");
}

#[test]
fn bad_conditions_are_refused() {
    let tool = with_head();
    let solver = ConditionSolver::new(&tool, 50.0);
    let range = tool.flanks.left.range;
    let good = three_points_with_map(&tool.flanks.left, [0.0; 3]);
    let nan = f64::NAN;
    let flank = Flank::Left;
    for (row, part) in [
        (Condition::Point { flank, w: nan, f: 0.0 }, "length of roll of a pitch point"),
        (Condition::Point { flank, w: range.w_nf, f: f64::INFINITY }, "wanted modification"),
        (Condition::Map { flank, t: nan, w: 44.0 }, "dresser parameter"),
        (Condition::Map { flank, t: 44.0, w: nan }, "length of roll of a radius map"),
        (Condition::Map { flank, t: 400.0, w: 44.0 }, "within the profile"),
        (Condition::Head { t: nan, r: 53.0 }, "parameter of the head profile"),
        (Condition::Head { t: 0.0, r: nan }, "head radius"),
        (Condition::Head { t: 5.0, r: 53.0 }, "within the head profile"),
        (Condition::Fixed { j: 2, x: nan }, "fixed correction"),
        (Condition::Fixed { j: 4, x: 0.0 }, "0 to 3"),
    ] {
        let rows = [good[0], good[1], good[2], row];
        says(&solver.solve(&rows, &[0.0; 4]).unwrap_err(), "invalid-number", &[part]);
    }
    says(&solver.solve(&good, &[0.0, nan, 0.0, 0.0]).unwrap_err(), "invalid-number", &["start"]);
    says(
        &ConditionSolver::new(&tool, 0.0).solve(&good, &[0.0; 4]).unwrap_err(),
        "invalid-number",
        &["reference radius"],
    );
    let limits = [[0.0, nan]; 4];
    says(&solver.with_limits(limits).solve(&good, &[0.0; 4]).unwrap_err(), "invalid-number", &["axis limit"]);
    says(&solver.solve(&good[..2], &[0.0; 4]).unwrap_err(), "condition-count", &["2 conditions"]);
    let five = [good[0], good[1], good[2], good[3], Condition::Fixed { j: 0, x: 0.0 }];
    says(&solver.solve(&five, &[0.0; 4]).unwrap_err(), "condition-count", &["5 conditions"]);
    let equal = [good[0], good[1], good[1], good[3]];
    says(&solver.solve(&equal, &[0.0; 4]).unwrap_err(), "condition-count", &["3 conditions"]);
    // Two values at one place contradict each other.
    let other = Condition::Point { flank, w: range.w_nf, f: 0.002 };
    says(
        &solver.solve(&[good[0], other, good[2], good[3]], &[0.0; 4]).unwrap_err(),
        "singular",
        &["do not determine"],
    );
    // Points that the dresser does not reach, and a position without contact.
    let far = Condition::Point { flank, w: 3.0 * range.w_na, f: 0.0 };
    says(
        &solver.solve(&[far, good[1], good[2], good[3]], &[0.0; 4]).unwrap_err(),
        "out-of-dresser",
        &["left"],
    );
    says(&solver.solve(&good, &[0.0, 1.5, -80.0, 0.0]).unwrap_err(), "no-contact", &["does not touch"]);
    let profile = DressedProfile::new(&tool, flank, [0.0, nan, 0.0, 0.0]);
    says(&profile.at_roll(44.0).unwrap_err(), "invalid-number", &["NaN"]);
    let profile = DressedProfile::new(&tool, flank, [0.0; 4]);
    says(&profile.at_roll(nan).unwrap_err(), "invalid-number", &["length of roll"]);
    says(&profile.at_parameter(nan).unwrap_err(), "invalid-number", &["profile parameter"]);
    says(&profile.at_parameter(400.0).unwrap_err(), "invalid-number", &["within the profile"]);
    // Both flanks of a conical worm.
    let cone = Bodies { cone: 2.0, ..CASE_A };
    let conical = cone.tool().unwrap();
    let rows = two_flank_points(&conical, [0.0; 2], [0.0; 2]);
    says(
        &ConditionSolver::new(&conical, 50.0).solve(&rows, &[0.0; 4]).unwrap_err(),
        "two-flanks-of-cone",
        &["conical"],
    );
}

#[test]
fn impossible_dressers_of_any_number_are_refused() {
    let (worm, chains, ranges) = (CASE_A.worm(), CASE_A.chains(), CASE_A.ranges());
    let nan = f64::NAN;
    type Change = fn(&mut foundation::kinematics::DressingChain, f64);
    let changes: [(Change, &str); 5] = [
        (|c, x| c.worm_angle = x, "worm angle"),
        (|c, x| c.crossing_angle = x, "crossing angle"),
        (|c, x| c.centre_distance = x, "centre distance"),
        (|c, x| c.offset = x, "offset"),
        (|c, x| c.screw_parameter = x, "screw parameter"),
    ];
    for (change, part) in changes {
        for value in [nan, f64::INFINITY] {
            let mut chain = chains.left;
            change(&mut chain, value);
            let error = DresserTool::conjugate(&worm, Sides::both(chain), ranges).unwrap_err();
            says(&error, "invalid-number", &[part]);
        }
    }
    let mut chain = chains.left;
    chain.screw_parameter = 0.0;
    says(
        &DresserTool::conjugate(&worm, Sides::both(chain), ranges).unwrap_err(),
        "invalid-number",
        &["screw"],
    );
    for (w_nf, w_na) in [(0.0, 5.0), (-1.0, 5.0), (nan, 5.0), (40.0, nan), (40.0, f64::INFINITY)] {
        let range = dressing::GeometricRange { w_nf, w_na };
        let error = DresserTool::conjugate(&worm, chains, Sides::both(range)).unwrap_err();
        says(&error, "invalid-number", &["w_NfS", "0 < w_NfS < w_NaS"]);
    }
    for margin in [-0.1, nan, f64::INFINITY] {
        let error = DresserTool::conjugate_beyond(&worm, chains, ranges, margin).unwrap_err();
        says(&error, "invalid-number", &["continuation of the profile"]);
    }
}

/// Pitch points that move over the width, maps, a stretch, head heights and a given axis that change with it, on both flanks.
#[test]
fn conditions_that_vary_over_the_width_are_met_everywhere() {
    let tool = with_head();
    let solver = ConditionSolver::new(&tool, 50.0);
    let (left, right) = (tool.flanks.left.range, tool.flanks.right.range);
    let law = |c: &[f64]| WidthLaw::new(c).unwrap();
    let wish = |place: PitchPlace| match place.flank {
        Flank::Left => 3e-4 * ((place.b / 23.0).sin() - 0.4 * (place.w - left.middle()) / left.length()),
        Flank::Right => -3e-4 * (place.b / 31.0).cos(),
    };
    let here = |c: &[f64]| RowAlong::Point { flank: None, at: law(c) };
    let there = |c: &[f64]| RowAlong::Point { flank: Some(Flank::Right), at: law(c) };
    let map = RowAlong::Map { flank: None, dresser: law(&[1.0, 0.03]), at: law(&[1.0, 0.04, -0.02]) };
    let little = RowAlong::Map { flank: None, dresser: law(&[1.0, 0.02]), at: law(&[1.0, 0.025]) };
    let longer = RowAlong::Stretch { flank: Some(Flank::Left), stretch: law(&[0.01, 0.01]) };
    let head = |position: f64| RowAlong::Head { position, above: law(&[0.0, 2e-4]) };
    let (low, middle, top) = (here(&[0.05, 0.05]), here(&[0.5, 0.0, 0.04]), here(&[1.0]));
    let fixed = RowAlong::Fixed { j: 1, x: law(&[0.0, 2e-4]) };
    let sets: [[RowAlong; 4]; 6] = [
        [low, middle, top, map],
        [low, middle, top, longer],
        [low, top, there(&[0.0, 0.03]), head(0.4)],
        [low, top, head(-0.6), head(0.7)],
        [low, little, there(&[0.0, 0.03]), fixed],
        [low, middle, top, there(&[0.3, 0.1])],
    ];
    let plan = NodePlan { interval: (-20.0, 20.0), nodes: 9 };
    let tip = |z: f64| 53.5 + 1e-4 * z;
    let q = |z: f64| z / 20.0;
    for rows in sets {
        let wanted =
            |places: &[Option<PitchPlace>]| places.iter().map(|place| place.map_or(f64::NAN, wish)).collect();
        let used = Sides::both([-20.0, 20.0]);
        let conditions = RowsAlong {
            tool: &tool,
            flank: Flank::Left,
            rows: RowSet::exact(rows),
            used,
            wanted: &wanted,
            tip: &tip,
        };
        let solved = solve_rows_along(&solver, &plan, &conditions);
        let (series, nodes) = solved.unwrap_or_else(|error| panic!("{rows:?}: {error}"));
        for node in &nodes {
            assert!((0..4).all(|j| (series[j].value(node.v) - node.dk[j]).abs() < 1e-12));
            let again = solve_rows_at(&solver, node.v, &node.dk, &conditions).unwrap();
            assert!((0..4).all(|j| (again[j] - node.dk[j]).abs() < 1e-7 * solver.scale()[j].max(1e-3)));
            let stands = |flank: Flank| {
                let dresser = &tool.flanks[flank];
                q(dresser.line.value(dresser.range.middle()) - node.v)
            };
            for row in &rows {
                let missed = match *row {
                    RowAlong::Point { flank, at } => {
                        let flank = flank.unwrap_or(Flank::Left);
                        let range = if flank == Flank::Left { left } else { right };
                        // Where the pitch point lies: w(b) meets the line of contact b(w; DK) - v.
                        let profile = DressedProfile::new(&tool, flank, node.dk);
                        let mut b = 0.0;
                        let w = |b: f64| range.w_nf + at.value(q(b)) * range.length();
                        for _ in 0..60 {
                            b = profile.at_roll(w(b)).unwrap().b - node.v;
                        }
                        profile.at_roll(w(b)).unwrap().f - wish(PitchPlace { flank, w: w(b), b })
                    }
                    RowAlong::Map { dresser, at, .. } => {
                        let there =
                            |law: WidthLaw| left.w_nf + law.value(stands(Flank::Left)) * left.length();
                        let profile = DressedProfile::new(&tool, Flank::Left, node.dk);
                        profile.at_parameter(there(dresser)).unwrap().w - there(at)
                    }
                    RowAlong::Stretch { stretch: wanted, .. } => {
                        stretch(&tool, Flank::Left, node.dk).unwrap() - wanted.value(stands(Flank::Left))
                    }
                    RowAlong::Head { position, above } => {
                        let z = position - node.v;
                        let (r, _) = head_gradient(&tool, position, &node.dk).unwrap();
                        r - tip(z) - above.value(q(z))
                    }
                    RowAlong::Fixed { j, x } => node.dk[j] - x.value(stands(Flank::Left)),
                };
                assert!(missed.abs() < 1e-8, "v {} {row:?}: {missed}", node.v);
            }
        }
    }
    assert_eq!(WidthLaw::new(&[0.0; 7]), None);
}

/// A wish that changes along the worm and across it.
fn waved(place: PitchPlace) -> f64 {
    3e-4 * ((place.b / 23.0).sin() - 0.3 * (place.w / 2.0).cos())
}

fn rows_along<'a>(
    tool: &'a DresserTool,
    rows: RowSet,
    wanted: &'a dyn Fn(&[Option<PitchPlace>]) -> Vec<f64>,
    tip: &'a dyn Fn(f64) -> f64,
) -> RowsAlong<'a> {
    RowsAlong { tool, flank: Flank::Left, rows, used: Sides::both([-20.0, 20.0]), wanted, tip }
}

/// Four rows with weights are as many as there are motions: they are met as exactly as without.
#[test]
fn four_weighed_rows_are_met_exactly() {
    let tool = CASE_A.tool().unwrap();
    let solver = ConditionSolver::new(&tool, 50.0);
    let plan = NodePlan { interval: (-15.0, 15.0), nodes: 5 };
    let wanted =
        |places: &[Option<PitchPlace>]| places.iter().map(|place| place.map_or(f64::NAN, waved)).collect();
    let tip = |_: f64| f64::NAN;
    let rows = RowAlong::three_points_with_map();
    let exact = rows_along(&tool, RowSet::exact(rows), &wanted, &tip);
    let weighed = rows.map(|row| (row, Some(0.7)));
    let weighed = rows_along(&tool, RowSet::weighed(&weighed).unwrap(), &wanted, &tip);
    let (_, one) = solve_rows_along(&solver, &plan, &exact).unwrap();
    let (_, other) = solve_rows_along(&solver, &plan, &weighed).unwrap();
    for (one, other) in one.iter().zip(&other) {
        assert!(one.dk.iter().any(|x| x.abs() > 1e-5));
        for j in 0..4 {
            assert!((one.dk[j] - other.dk[j]).abs() < 1e-6 * solver.scale()[j], "{one:?} {other:?}");
        }
    }
    let left = missed_rows(&other, &weighed).unwrap();
    assert!(left.iter().all(|miss| miss.largest < 1e-8 && miss.rms <= miss.largest), "{left:?}");
}

/// More rows than motions: no correction nearby leaves a smaller sum of squares, what is exact stays so, and a heavier row is missed by less.
#[test]
fn weighed_rows_leave_the_least_sum_of_squares() {
    let tool = CASE_A.tool().unwrap();
    let solver = ConditionSolver::new(&tool, 50.0);
    // Over the roll only, so that the places do not count.
    let wish = |place: PitchPlace| 2e-3 * (place.w * 1.3).sin();
    let wanted =
        |places: &[Option<PitchPlace>]| places.iter().map(|place| place.map_or(f64::NAN, wish)).collect();
    let tip = |_: f64| f64::NAN;
    let range = tool.flanks.left.range;
    let points = [0.0, 0.2, 0.4, 0.6, 0.8, 1.0];
    let solved = |weight: f64, exact: Option<f64>| {
        let mut rows: Vec<(RowAlong, Option<f64>)> =
            points.map(|at| (RowAlong::point(at), Some(if at == 0.4 { weight } else { 1.0 }))).to_vec();
        rows.push((RowAlong::map_of_upper_end(), Some(0.2)));
        rows.extend(exact.map(|at| (RowAlong::point(at), None)));
        let along = rows_along(&tool, RowSet::weighed(&rows).unwrap(), &wanted, &tip);
        let dk = solve_rows_at(&solver, 3.0, &[0.0; 4], &along).unwrap();
        let node = NodeSolution { v: 3.0, dk };
        (dk, missed_rows(&[node], &along).unwrap())
    };
    // um and per cent of the profile, by the forward calculation alone.
    let sum = |dk: DressingCorrection| {
        let profile = DressedProfile::new(&tool, Flank::Left, dk);
        let at = |at: f64| {
            let w = range.w_nf + at * range.length();
            1e3 * (profile.at_roll(w).unwrap().f - wish(PitchPlace { flank: Flank::Left, w, b: 0.0 }))
        };
        let map = 100.0 * (profile.at_parameter(range.w_na).unwrap().w - range.w_na) / range.length();
        points.iter().map(|x| at(*x).powi(2)).sum::<f64>() + (0.2 * map).powi(2)
    };
    let (dk, left) = solved(1.0, None);
    let least = sum(dk);
    let found = left.iter().take(6).map(|miss| (1e3 * miss.largest).powi(2)).sum::<f64>()
        + (0.2 * 100.0 * left[6].largest / range.length()).powi(2);
    assert!((found - least).abs() < 1e-9 * least && least > 0.1, "{found} {least}");
    for j in 0..4 {
        for step in [1e-4, -1e-4] {
            let mut beside = dk;
            beside[j] += step * solver.scale()[j];
            assert!(sum(beside) > least, "{j} {step}: {} {least}", sum(beside));
        }
    }
    let (_, heavier) = solved(5.0, None);
    assert!(heavier[2].largest < 0.5 * left[2].largest, "{heavier:?} {left:?}");
    let (exactly, held) = solved(1.0, Some(0.4));
    assert!(held[7].largest < 1e-9 && held[2].largest < 1e-9, "{held:?}");
    assert!(sum(exactly) > least);
}

#[test]
fn sets_of_rows_have_a_number_that_can_be_solved() {
    let row = |weight| (RowAlong::point(0.5), weight);
    assert_eq!(RowSet::weighed(&[row(None); 5]), None);
    assert_eq!(RowSet::weighed(&[row(None); 3]), None);
    assert_eq!(RowSet::weighed(&[row(Some(1.0)); 13]), None);
    let set = RowSet::weighed(&[row(None), row(Some(2.0))]).unwrap();
    assert_eq!((set.rows().len(), set.weights(), set.is_weighed()), (2, [None, Some(2.0)].as_slice(), true));
    // Two rows do not determine four motions.
    let tool = CASE_A.tool().unwrap();
    let wanted = |places: &[Option<PitchPlace>]| vec![0.0; places.len()];
    let along = rows_along(&tool, set, &wanted, &|_| f64::NAN);
    let error = solve_rows_at(&ConditionSolver::new(&tool, 50.0), 0.0, &[0.0; 4], &along).unwrap_err();
    says(&error, "underdetermined", &["2 conditions"]);
}

#[test]
fn three_points_leave_the_residue_of_a_wave() {
    let tool = CASE_A.tool().unwrap();
    let cos = 0.55f64.cos();
    let range = tool.flanks.left.range;
    let half = 0.5 * range.length();
    let crowned = |w: f64, b: f64| {
        let c = 0.003 + 0.003 * (2.0 * std::f64::consts::PI * b / 60.0).sin();
        -c * cos * (1.0 - ((w - range.middle()) / half).powi(2))
    };
    let wanted = |b: [f64; 3]| {
        let rolls = [range.w_nf, range.middle(), range.w_na];
        std::array::from_fn(|i| crowned(rolls[i], b[i]))
    };
    let plan = NodePlan { interval: (-60.0, 60.0), nodes: 33 };
    let (series, _) = solve_dressing_motion(&tool, Flank::Left, 50.0, &plan, &wanted).unwrap();
    let points: Vec<(f64, f64)> = (0..=8)
        .flat_map(|i| (-10..=10).map(move |k| (i, k)))
        .map(|(i, k)| (range.w_nf + range.length() * f64::from(i) / 8.0, 3.0 * f64::from(k)))
        .collect();
    let dressed = DressedWorm::new(&tool, Flank::Left, &series);
    let left = points.iter().map(|&(w, b)| dressed.modification(w, b).unwrap().0 - crowned(w, b));
    let largest = left.fold(0.0_f64, |m, f| m.max(f.abs())) * 1e3;
    // `docs/mathematics/dressing.md#conditions` states 0.10 um for this wave (on a slightly deeper range).
    assert!(largest > 0.02 && largest < 0.2, "{largest}");
    assert!(dressed.modification(44.0, 500.0).is_none());
    let plan = |from: f64, to: f64, nodes| NodePlan { interval: (from, to), nodes };
    for plan in [plan(1.0, 1.0, 3), plan(f64::NAN, 1.0, 3), plan(0.0, 1.0, 0)] {
        let error = solve_dressing_motion(&tool, Flank::Left, 50.0, &plan, &wanted).unwrap_err();
        says(&error, "invalid-number", ["worm position from"][..usize::from(plan.nodes > 0)].as_ref());
    }
    // Targets steeper than the line of contact can follow have no fixed point, and values that are none are told.
    let steep = |b: [f64; 3]| b.map(|b| 0.002 * (20.0 * b).sin());
    let plan = plan(-1.0, 1.0, 1);
    let error = solve_dressing_motion(&tool, Flank::Left, 50.0, &plan, &steep).unwrap_err();
    says(&error, "no-zero", &["v_zS"]);
    let none = |_: [f64; 3]| [f64::NAN; 3];
    let error = solve_dressing_motion(&tool, Flank::Left, 50.0, &plan, &none).unwrap_err();
    says(&error, "invalid-number", &["wanted modification"]);
}

/// Soft points over a flank, wanted = those of a correction plus something no dresser can make.
fn soft(
    tool: &DresserTool,
    flank: Flank,
    dk: DressingCorrection,
    wave: f64,
    count: usize,
) -> Vec<SoftCondition> {
    let range = tool.flanks[flank].range;
    let profile = DressedProfile::new(tool, flank, dk);
    (0..count)
        .map(|k| {
            let x = k as f64 / (count - 1) as f64;
            let w = range.w_nf + x * range.length();
            let f = profile.at_roll(w).unwrap().f + wave * (9.0 * x).cos();
            SoftCondition { condition: Condition::Point { flank, w, f }, weight: 1.0 }
        })
        .collect()
}

/// Sum of the squares that compensation minimises.
fn objective(tool: &DresserTool, soft: &[SoftCondition], dk: DressingCorrection) -> f64 {
    soft.iter().map(|s| (s.weight * missed(tool, &[s.condition], dk)).powi(2)).sum()
}

#[test]
fn compensation_is_the_least_of_its_neighbourhood() {
    let tool = CASE_A.tool().unwrap();
    let goal = [-4e-4, -4e-3, -0.02, 0.6];
    let map = map_of_upper_end(&tool.flanks.left);
    // One flank with a hard map; both flanks without hard rows; a soft map; points of unlike weight.
    let mut both = soft(&tool, Flank::Left, goal, 2e-4, 11);
    both.extend(soft(&tool, Flank::Right, goal, -1e-4, 9));
    let mut mapped = soft(&tool, Flank::Left, goal, 1e-4, 9);
    mapped.push(SoftCondition { condition: map, weight: 0.01 });
    let mut weighted = both.clone();
    weighted.iter_mut().enumerate().for_each(|(i, s)| s.weight = 1.0 + i as f64 / 4.0);
    let tasks = [
        (soft(&tool, Flank::Left, goal, 1e-4, 15), vec![map]),
        (both, vec![]),
        (mapped, vec![]),
        (weighted, vec![map]),
    ];
    for (soft, hard) in tasks {
        let found = Compensation::new(&tool, 50.0, soft.clone(), hard.clone()).solve(&[0.0; 4]).unwrap();
        assert_eq!((found.rank, found.residuals.len()), (4, soft.len()));
        assert!(missed(&tool, &hard, found.dk) < 1e-9);
        let least = objective(&tool, &soft, found.dk);
        let weights: f64 = soft.iter().map(|s| s.weight.powi(2)).sum();
        assert!((found.rms - (least / weights).sqrt()).abs() < 1e-12);
        for (s, r) in soft.iter().zip(&found.residuals) {
            assert!((missed(&tool, &[s.condition], found.dk) - r.abs()).abs() < 1e-12);
        }
        // Steps along which the hard rows hold, found by solving them with three axes given.
        let scale = ConditionSolver::new(&tool, 50.0).scale();
        for j in 0..4 {
            for sign in [1.0, -1.0] {
                let mut dk = found.dk;
                dk[j] += sign * 1e-3 * scale[j];
                if let [row] = hard[..] {
                    // The map moves mostly with the crossing angle and the offset: let another axis hold it.
                    let free = if j == 2 { 3 } else { 2 };
                    let fixed: Vec<Condition> =
                        (0..4).filter(|&k| k != free).map(|j| Condition::Fixed { j, x: dk[j] }).collect();
                    let rows = [row, fixed[0], fixed[1], fixed[2]];
                    dk = ConditionSolver::new(&tool, 50.0).solve(&rows, &dk).unwrap();
                }
                assert!(objective(&tool, &soft, dk) > least, "{j} {sign}");
            }
        }
    }
}

#[test]
fn compensation_meets_what_can_be_met() {
    let tool = CASE_A.tool().unwrap();
    let goal = [3e-4, 5e-3, 0.01, -0.4];
    let mut rows = soft(&tool, Flank::Left, goal, 0.0, 7);
    rows.extend(soft(&tool, Flank::Right, goal, 0.0, 7));
    let found = Compensation::new(&tool, 50.0, rows, vec![]).solve(&[0.0; 4]).unwrap();
    assert!(found.rms < 1e-10, "{}", found.rms);
    let scale = ConditionSolver::new(&tool, 50.0).scale();
    assert!((0..4).all(|j| (found.dk[j] - goal[j]).abs() < 1e-5 * scale[j]), "{:?}", found.dk);
    // Four hard rows are a plain solve.
    let hard = three_points_with_map(&tool.flanks.left, [0.0, -0.001, 0.0]).to_vec();
    let one = soft(&tool, Flank::Right, goal, 0.0, 3);
    let found = Compensation::new(&tool, 50.0, one, hard.clone()).solve(&[0.0; 4]).unwrap();
    let plain = ConditionSolver::new(&tool, 50.0).solve(&hard, &[0.0; 4]).unwrap();
    assert!((0..4).all(|j| (found.dk[j] - plain[j]).abs() < 1e-6 * scale[j]));
}

#[test]
fn the_shortest_correction_is_taken_when_asked_for() {
    let tool = CASE_A.tool().unwrap();
    let range = tool.flanks.left.range;
    let point =
        |w, f| SoftCondition { condition: Condition::Point { flank: Flank::Left, w, f }, weight: 1.0 };
    let two = vec![point(range.w_nf, 0.002), point(range.w_na, 0.001)];
    let task = Compensation::new(&tool, 50.0, two.clone(), vec![]);
    says(&task.solve(&[0.0; 4]).unwrap_err(), "underdetermined", &["2 conditions", "only 2"]);
    let found = task.shortest().solve(&[0.0; 4]).unwrap();
    assert!(found.rms < 1e-10 && found.rank == 2);
    let scale = ConditionSolver::new(&tool, 50.0).scale();
    let length = |dk: &DressingCorrection| (0..4).map(|j| (dk[j] / scale[j]).powi(2)).sum::<f64>().sqrt();
    // No solution of the two points with two given axes is shorter.
    for (j, k, x, y) in
        [(1, 3, 0.0, 0.0), (1, 2, 0.001, 0.001), (0, 3, 1e-4, 0.05), (1, 3, found.dk[1] * 1.1, found.dk[3])]
    {
        let rows =
            [two[0].condition, two[1].condition, Condition::Fixed { j, x }, Condition::Fixed { j: k, x: y }];
        if let Ok(other) = ConditionSolver::new(&tool, 50.0).solve(&rows, &found.dk) {
            assert!(length(&found.dk) < length(&other) + 1e-9, "{found:?} {other:?}");
        }
    }
}

#[test]
fn bad_compensations_are_refused() {
    let tool = CASE_A.tool().unwrap();
    let good = soft(&tool, Flank::Left, [0.0; 4], 1e-4, 9);
    let map = map_of_upper_end(&tool.flanks.left);
    let task = |soft: &[SoftCondition], hard: &[Condition]| {
        Compensation::new(&tool, 50.0, soft.to_vec(), hard.to_vec())
    };
    let start = [0.0; 4];
    for weight in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let mut rows = good.clone();
        rows[3].weight = weight;
        says(&task(&rows, &[map]).solve(&start).unwrap_err(), "invalid-number", &["weight"]);
    }
    let mut rows = good.clone();
    rows[3].condition = Condition::Point { flank: Flank::Left, w: 44.0, f: f64::NAN };
    says(&task(&rows, &[map]).solve(&start).unwrap_err(), "invalid-number", &["wanted modification"]);
    says(&task(&good, &[map]).solve(&[f64::NAN; 4]).unwrap_err(), "invalid-number", &["start"]);
    let error = Compensation::new(&tool, f64::NAN, good.clone(), vec![]).solve(&start).unwrap_err();
    says(&error, "invalid-number", &["reference radius"]);
    says(
        &task(&good[..2], &[map]).solve(&start).unwrap_err(),
        "underdetermined",
        &["3 conditions", "only 3"],
    );
    // Many rows on one place, and rows of three axes only.
    let same = vec![good[4]; 9];
    says(&task(&same, &[]).solve(&start).unwrap_err(), "underdetermined", &["9 conditions", "only 1"]);
    says(&task(&good, &[map, map]).solve(&start).unwrap_err(), "condition-count", &["1 conditions"]);
    let contrary = [Condition::Fixed { j: 1, x: 0.0 }, Condition::Fixed { j: 1, x: 0.1 }];
    says(&task(&good, &contrary).solve(&start).unwrap_err(), "singular", &[]);
    let five = [0, 1, 2, 3].map(|j| Condition::Fixed { j, x: 0.0 });
    let five = [five[0], five[1], five[2], five[3], map];
    says(&task(&good, &five).solve(&start).unwrap_err(), "condition-count", &["5 conditions"]);
    // Hard rows beyond the fold.
    let hard = three_points_with_map(&tool.flanks.left, [0.0, 0.06, 0.0]);
    let error = task(&good, &hard).solve(&start).unwrap_err();
    says(&error, "no-zero", &["percent"]);
    let DressingError::NoZero { fraction, .. } = error else { panic!() };
    assert!(fraction > 0.01 && fraction < 0.5, "{fraction}");
    let error = task(&good, &[Condition::Head { t: 0.0, r: 53.0 }]).solve(&start).unwrap_err();
    says(&error, "invalid-number", &["head condition"]);
}
