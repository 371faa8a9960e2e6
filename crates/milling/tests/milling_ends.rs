//! How rows begin and end: in the middle of double-helical gears against the reference of `docs/mathematics/milling.md#flanks-as-patches`,
//! on arcs of approach, and what rays find there.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use job::{Source, parse_job_of};
use milling::job::LoadedMillingJob;
use milling::workflow::{MillingBodies, prepare_milling, referee};
use milling::{
    ColumnPlane, FlankPlan, Half, HeightLimits, MillingError, MillingPlan, OperationKind, plan_all,
};

fn loaded(example: &str, changes: &[(&str, &str)]) -> LoadedMillingJob {
    let path = format!("{}/../../examples/milling/{example}.toml", env!("CARGO_MANIFEST_DIR"));
    let mut text = std::fs::read_to_string(path).unwrap();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    parse_job_of(Source::new(example, &text)).unwrap()
}

fn bodies(changes: &[(&str, &str)]) -> MillingBodies {
    prepare_milling(&loaded("double-helical", changes)).unwrap().bodies
}

fn planned(bodies: &MillingBodies) -> MillingPlan {
    plan_all(&bodies.parts, &bodies.options).unwrap()
}

/// Two rows, a sharp cutter of radius 2.5 mm that touches 4 mm above its tip; the half towards -z has the helix of the reference.
const REFERENCE: [(&str, &str); 7] = [
    ("helix_angle_deg = 25.0", "helix_angle_deg = -25.0"),
    ("corner_radius = 1.0\ncutting_length = 16.0", "corner_radius = 0.0\ncutting_length = 30.0"),
    ("rows = 12", "rows = 2"),
    ("contact_height = 2.91", "contact_height = 4.0"),
    ("[milling.root]\nbottom = 0.0\n", ""),
    (
        "[bottom_cutter]\nshape = \"end-mill\"\ndiameter = 3.0\ncorner_radius = 1.0\ncutting_length = 12.0\n",
        "",
    ),
    ("face_width = 41.0", "face_width = 50.0"),
];

/// One flank alone, as the reference looks at it: the flank across the space would limit the contact height. The row at the root is that of
/// the reference; the flank of the other half goes farther down.
fn reference(halves: &str, side: Flank) -> MillingBodies {
    let changes: Vec<_> = REFERENCE.into_iter().chain([("double_helical = { gap = 1.0 }", halves)]).collect();
    let mut bodies = bodies(&changes);
    for part in &mut bodies.parts {
        part.flanks.retain(|flank| flank.side == side);
        part.other_half.retain(|flank| flank.side == side);
        let active = &mut part.flanks[0].active;
        active.heights = HeightLimits::Constant([26.443_756_149_197_426, active.height_span()[1]]);
    }
    bodies
}

/// Where the row at the root ends on every flank.
fn ends(plan: &MillingPlan) -> Vec<(&'static str, Option<f64>)> {
    plan.flanks.iter().map(|flank| (flank.side.name(), flank.ends[0].map(|end| end.length))).collect()
}

#[test]
fn rows_of_hollow_corners_end_where_the_reference_says() {
    // `docs/mathematics/milling.md#flanks-as-patches` and block `herringbone` of its reference file: exactly 1.2246 mm, 0.9928 mm if the
    // flanks were flat.
    let exact = 1.224_576_800_126_211_6;
    for apex in [0.0, 3.0] {
        let halves = format!("double_helical = {{ gap = 0.0, apex = {apex:?} }}");
        let hollow = planned(&reference(&halves, Flank::Right));
        let found = ends(&hollow);
        let [("upper-right", Some(upper)), ("lower-right", Some(lower))] = found[..] else {
            panic!("{found:?}")
        };
        assert!((upper - apex - exact).abs() < 1e-3, "{upper}");
        assert!((lower - apex + exact).abs() < 1e-3, "{lower}");
        for flank in &hollow.flanks {
            assert!((flank.rows[0].contact_height - 4.0).abs() < 1e-12);
            assert!((flank.unmilled_length(0) - exact).abs() < 1e-3);
        }
        let other = planned(&reference(&halves, Flank::Left));
        assert_eq!(ends(&other), [("upper-left", None), ("lower-left", None)]);
        assert_eq!(other.flanks[0].unmilled_length(0), 0.0);
    }
}

#[test]
fn a_gap_takes_the_limit_away() {
    let left = |gap: f64| {
        let plan = planned(&reference(&format!("double_helical = {{ gap = {gap:?} }}"), Flank::Right));
        plan.flanks[0].unmilled_length(0)
    };
    let [none, some, wide] = [0.0, 0.6, 8.0].map(left);
    assert!(none > some && some > 0.0, "{none} {some}");
    assert_eq!(wide, 0.0);
}

/// Places at which the cutter touches the flank or the fillet below it.
fn contacts<'a>(plan: &'a MillingPlan, flank: &FlankPlan) -> impl Iterator<Item = f64> + 'a {
    let side = flank.side;
    let own = [OperationKind::Flank(side), OperationKind::Fillet(side)];
    let operations = plan.operations.iter().filter(move |operation| own.contains(&operation.kind));
    operations
        .flat_map(|o| o.paths.iter().flat_map(|path| &path.places))
        .map(|place| place.contact.unwrap().z)
}

#[test]
fn nothing_crosses_the_middle_and_rays_find_no_gouge() {
    let gap = [
        ("double_helical = { gap = 1.0 }", "double_helical = { gap = 0.0 }"),
        ("face_width = 41.0", "face_width = 24.0"),
    ];
    let bodies = bodies(&gap);
    let plan = planned(&bodies);
    assert_eq!(plan.operations.iter().filter(|o| o.kind == OperationKind::Bottom).count(), 1);
    for flank in &plan.flanks {
        let side = if flank.side.half == Some(Half::Upper) { 1.0 } else { -1.0 };
        let nearest = contacts(&plan, flank).map(|z| side * z).fold(f64::INFINITY, f64::min);
        assert!(nearest >= -1e-9, "{}: {nearest}", flank.side);
    }
    let flanks = referee(&bodies, &plan, [15, 41], &Silent).unwrap();
    for (planned, flank) in plan.flanks.iter().zip(&flanks) {
        let left = flank.judged.iter().filter(|judged| !**judged).count();
        assert_eq!(left > 0, planned.ends.iter().any(Option::is_some), "{}", flank.side);
        assert!(flank.unmilled.is_empty(), "{}: {:?}", flank.side, flank.unmilled);
        let found = flank.simulated.iter().flatten().map(|mm| 1e3 * mm);
        let [least, most] = found.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
        assert!(least > -1.0 && most < 14.0, "{}: {least} to {most} um", flank.side);
    }
}

#[test]
fn a_column_that_crosses_the_middle_is_refused() {
    let bodies = reference("double_helical = { gap = 0.0 }", Flank::Left);
    let upper = &bodies.parts[0];
    let active = &upper.flanks[0].active;
    let plane = ColumnPlane::new(active, upper.lead.at(-2.0).unwrap());
    let height = active.height_span()[0];
    assert!(
        matches!(plane.section(height, -2.0), Err(MillingError::ColumnKink { kink: 0.0, length, .. }) if length < 0.0)
    );
    let extended = active.extended();
    let plane = ColumnPlane::new(&extended, upper.lead.at(-2.0).unwrap());
    assert!(plane.section(height, -2.0).is_ok());
}

/// The spur gear without overrun, so that rows begin and end between the flanks.
fn spur(radius: Option<f64>) -> MillingBodies {
    let arcs = radius.map_or(String::new(), |radius| format!("approach_radius = {radius:?}\n"));
    let ends = format!("overrun = 0.0\n{arcs}rows = ");
    let roughing = ("[milling.roughing]\nallowance = 0.3\nstep_down = 3.0\nstep_over = 2.0\n", "");
    prepare_milling(&loaded("spur-module-8", &[roughing, ("rows = ", ends.as_str())])).unwrap().bodies
}

#[test]
fn rows_are_approached_on_arcs_without_a_gouge() {
    let (plain, with_arcs) = (spur(None), spur(Some(0.5)));
    let (without, with) = (planned(&plain), planned(&with_arcs));
    for (plain, arched) in without.operations.iter().zip(&with.operations) {
        if !matches!(plain.kind, OperationKind::Flank(_)) {
            assert_eq!(plain.paths, arched.paths, "{}", plain.kind);
            continue;
        }
        for (plain, arched) in plain.paths.iter().zip(&arched.paths) {
            let one = (arched.places.len() - plain.places.len()) / 2;
            assert!(one > 5, "{one} places");
            assert_eq!(arched.places[one..one + plain.places.len()], plain.places);
            // A quarter circle of 0.5 mm: as far from the row across and along.
            for [begin, edge] in [[0, one], [arched.places.len() - 1, one + plain.places.len() - 1]] {
                let off = arched.places[begin].tip - arched.places[edge].tip;
                assert!((off.norm() - 0.5 * std::f64::consts::SQRT_2).abs() < 1e-12, "{off}");
                assert_eq!(arched.places[begin].axis, arched.places[edge].axis);
            }
        }
    }
    let [plain, arched] =
        [(&plain, &without), (&with_arcs, &with)].map(|(b, p)| referee(b, p, [41, 9], &Silent).unwrap());
    for (plain, arched) in plain.iter().zip(&arched) {
        for (before, now) in plain.simulated.iter().zip(&arched.simulated) {
            assert!((before.unwrap() - now.unwrap()).abs() < 1e-9, "{before:?} {now:?}");
        }
    }
}

#[test]
fn an_arc_wider_than_the_space_is_refused_with_its_numbers() {
    let bodies = spur(Some(5.0));
    let error = plan_all(&bodies.parts, &bodies.options).unwrap_err();
    let MillingError::Approach { aside, room } = error else { panic!("{error}") };
    assert!(error.code() == "approach" && (aside - 5.0).abs() < 1e-12, "{aside}");
    assert!(room > 0.5 && room < 5.0, "{room}");
    let told = error.to_string();
    assert!(told.contains("5.0000 mm") && told.contains(&format!("{room:.4} mm")), "{told}");
}
