//! Every error of `docs/mathematics/milling.md#limits`: what provokes it, its code, what it says and its way out. Where a job can provoke
//! it a job does, and its exit status is looked at.

use foundation::geometry::CutterShape;
use foundation::numerics::Silent;
use job::{ProcessJob, Source, parse_job_of};
use milling::job::{LoadedMillingJob, MillingJob};
use milling::workflow::{MillingBodies, prepare_milling, run_milling};
use milling::{
    ActiveFlank, Along, ColumnPlane, CutterLocation, CutterPlace, DensityLimits, DistanceLimits, HeightRule,
    HeightWindow, Kink, LeadArc, LeadPoint, MillingError, Orientation, RootDepth, RootSection, RowSpacing,
    approach_arc, dense_grid, lead_range,
};
use nalgebra::Vector3;
use run::RunFailure;

/// The errors of the section, with what is said of them here; in its order.
const ERRORS: [(&str, Shown); 24] = [
    ("E_GEOM_INPUT", Shown::Here(face_to_the_apex)),
    ("E_GEOM_BASE", Shown::Here(flank_line_out_of_reach)),
    ("E_GEOM_POINTED", Shown::Here(pointed_tooth)),
    (
        "E_UNDERCUT",
        Shown::In("../../foundation/tests/surfaces/errors.rs", "octoids_below_their_regular_branch"),
    ),
    ("E_GRID_SIZE", Shown::In("../../foundation/tests/surfaces/errors.rs", "grids_that_are_no_surface")),
    ("E_LEAD_OFF_BASE", Shown::Here(lead_off_base)),
    ("E_COLUMN_NO_SECTION", Shown::Here(column_beside_the_flank)),
    ("E_COLUMN_KINK", Shown::Here(column_across_the_kink)),
    ("E_DENSITY_INPUT", Shown::Here(density_that_contradicts_itself)),
    ("E_DENSITY_SIZE", Shown::Here(density_without_end)),
    ("E_DENSITY_INFEASIBLE", Shown::Here(density_that_no_grid_keeps)),
    ("E_TOOL", Shown::Here(contact_below_the_corner)),
    ("E_AXIS_NONE", Shown::Here(no_axis_in_the_plane)),
    ("E_GOUGE_LOCAL", Shown::Here(end_mill_in_a_ring)),
    ("E_TOOL_GAP", Shown::Here(ball_as_wide_as_the_gap)),
    ("E_TOOL_SHORT", Shown::Here(edge_too_short_for_the_root)),
    ("E_ROOT_CORNER", Shown::Here(root_too_shallow_for_the_corner)),
    ("E_ROOT_OVERLAP", Shown::Here(root_too_deep)),
    ("E_ROOT_BOTTOM", Shown::Here(bottom_cutter_too_wide)),
    ("E_APPROACH", Shown::Here(arc_wider_than_the_gap)),
    (
        "E_INTERNAL_ACCESS",
        Shown::In("milled_jobs/internal_access.rs", "a_holder_must_end_before_the_teeth_on_the_other_side"),
    ),
    ("E_WEAR_WINDOW", Shown::Here(row_without_a_height)),
    (
        "E_AXIS_UNREACHABLE",
        Shown::In("../../motion/tests/five_axis.rs", "what_the_travel_does_not_hold_is_told_with_its_place"),
    ),
    (
        "E_AXIS_LIMIT",
        Shown::In("../../motion/tests/five_axis.rs", "what_the_travel_does_not_hold_is_told_with_its_place"),
    ),
];

/// Where an error is tested.
#[derive(Clone, Copy)]
enum Shown {
    /// By this function.
    Here(fn() -> Case),
    /// In a test of that file.
    In(&'static str, &'static str),
}

/// What was said, and what has to be.
struct Case {
    told: Told,
    code: &'static str,
    /// Exit status; none where no job gets there.
    exit: Option<i32>,
    says: &'static [&'static str],
}

#[derive(Debug)]
struct Told {
    code: String,
    message: String,
    way_out: String,
    exit: Option<i32>,
}

#[test]
fn every_error_is_told_with_its_numbers_and_a_way_out() {
    for (name, shown) in ERRORS {
        let Shown::Here(provoke) = shown else { continue };
        let Case { told, code, exit, says } = provoke();
        assert_eq!((told.code.as_str(), told.exit), (code, exit), "{name}: {told:?}");
        assert!(!told.way_out.is_empty(), "{name}: {told:?}");
        for part in says {
            assert!(told.message.contains(part), "{name}: `{part}` is not said: {told:?}");
        }
    }
}

#[test]
fn errors_tested_elsewhere_are() {
    let tests = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    for (name, shown) in ERRORS {
        let Shown::In(file, function) = shown else { continue };
        let text = std::fs::read_to_string(tests.join(file)).unwrap();
        assert!(text.contains(&format!("#[test]\nfn {function}()")), "{name}: no {function} in {file}");
    }
    let mut names: Vec<&str> = ERRORS.iter().map(|(name, _)| *name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), ERRORS.len());
}

fn of_room<T>(made: Result<T, MillingError>) -> Told {
    let error = made.err().expect("an error");
    Told {
        code: error.code().into(),
        message: error.to_string(),
        way_out: error.way_out().into(),
        exit: None,
    }
}

fn of_finding(finding: &job::Diagnostic, exit: i32) -> Told {
    Told {
        code: finding.code.into(),
        message: finding.to_string(),
        way_out: finding.way_out.as_ref().map(ToString::to_string).unwrap_or_default(),
        exit: Some(exit),
    }
}

fn replaced(text: &str, replacements: &[(&str, &str)]) -> String {
    replacements.iter().fold(text.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    })
}

fn loaded(text: &str) -> LoadedMillingJob {
    match parse_job_of::<MillingJob>(Source::new("job.toml", text)) {
        Ok(loaded) => loaded,
        Err(error) => panic!("{error}"),
    }
}

/// What a run of a job says when it fails.
fn of_job(text: &str, replacements: &[(&str, &str)]) -> Told {
    let text = replaced(text, replacements);
    match parse_job_of::<MillingJob>(Source::new("job.toml", &text)) {
        Err(error) => of_finding(&error.diagnostics[0], 2),
        Ok(_) => match run_milling(&loaded(&text), &Silent) {
            Ok(outcome) => panic!("it is milled: {:?}", outcome.result.verdict.status()),
            Err(RunFailure::BadInput(finding)) => of_finding(&finding, 2),
            Err(RunFailure::NotProducible(finding)) => of_finding(&finding, 4),
        },
    }
}

/// An example without its machine, whose description stands beside it.
fn example(name: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/milling").join(name);
    without_machine(&std::fs::read_to_string(path).unwrap())
}

fn without_machine(text: &str) -> String {
    let Some(from) = text.find("\n[machine]") else { return text.to_owned() };
    let to = text[from..].find("\n\n").map_or(text.len(), |length| from + length + 1);
    let text = text[..from].to_owned() + &text[to..];
    text.lines().filter(|line| !line.starts_with("programs = ")).map(|line| line.to_owned() + "\n").collect()
}

/// The spur gear of module 8 with 20 teeth, an end mill of 6 mm, its root milled; few rays.
fn spur() -> String {
    let text = without_machine(MillingJob::TEMPLATE);
    replaced(&text, &[("rays_profile = 81", "rays_profile = 3"), ("rays_length = 61", "rays_length = 3")])
}

fn bodies() -> MillingBodies {
    match prepare_milling(&loaded(&spur())) {
        Ok(prepared) => prepared.bodies,
        Err(failure) => panic!("{failure:?}"),
    }
}

fn face_to_the_apex() -> Case {
    let told = of_job(&example("straight-bevel-16.toml"), &[("face_width = 20.0", "face_width = 75.0")]);
    Case { told, code: "invalid-geometry", exit: Some(2), says: &["75", "72.11"] }
}

fn flank_line_out_of_reach() -> Case {
    let told = of_job(&example("spiral-bevel-15.toml"), &[("cutter_radius = 63.0", "cutter_radius = 12.0")]);
    Case { told, code: "flank-line-out-of-reach", exit: Some(2), says: &["mm"] }
}

fn pointed_tooth() -> Case {
    let told = of_job(
        &example("straight-bevel-16.toml"),
        &[("face_width = 20.0", "face_width = 20.0\naddendum_factor = 2.2")],
    );
    Case { told, code: "bevel-tooth-pointed", exit: Some(2), says: &["-"] }
}

fn lead_off_base() -> Case {
    let point = Vector3::new(0.0, 70.0, 0.0);
    let told = of_room(LeadPoint::new(1.5, point, &Vector3::new(0.0, 0.1, 1.0), &Vector3::y()));
    Case { told, code: "lead-off-base", exit: None, says: &["1.5", "9.95037"] }
}

/// Planes along a spur gear's flank do not cut it.
fn column_beside_the_flank() -> Case {
    let bodies = bodies();
    let lead = LeadPoint::new(2.5, Vector3::new(0.0, 70.0, 0.0), &Vector3::x(), &Vector3::y()).unwrap();
    let flank = &bodies.parts[0].flanks[0].active;
    let [root, _] = flank.height_span();
    let told = of_room(ColumnPlane::new(flank, lead).section(root, 7.25));
    Case { told, code: "column-no-section", exit: None, says: &["2.5", "7.25"] }
}

fn column_across_the_kink() -> Case {
    let bodies = bodies();
    let middle = Kink { length: 0.0, side: 1.0, along: Along::Axis };
    let flank = ActiveFlank { kink: Some(middle), ..bodies.parts[0].flanks[0].active.clone() };
    let [root, _] = flank.height_span();
    let section = |u: f64| {
        let lead = bodies.parts[0].lead.at(u).unwrap();
        ColumnPlane::new(&flank, lead).section(root, u)
    };
    assert!(section(3.0).is_ok());
    Case { told: of_room(section(-3.0)), code: "column-kink", exit: None, says: &["-3", "0"] }
}

fn dense(limits: DensityLimits) -> Result<(), MillingError> {
    let bodies = bodies();
    let flank = &bodies.parts[0].flanks[0].active;
    let range = lead_range(flank, &*bodies.parts[0].lead)?;
    dense_grid(flank, &*bodies.parts[0].lead, range, RowSpacing::Arc, &limits).map(|_| ())
}

/// A job with such limits is refused when it is read; the room refuses them by itself.
fn density_that_contradicts_itself() -> Case {
    let row = DistanceLimits { greatest: Some(1.0), least: Some(1.25), ..DistanceLimits::default() };
    let told = of_room(dense(DensityLimits { row, ..DensityLimits::default() }));
    for wrong in [0.0, -1.0, f64::NAN] {
        let column = DistanceLimits { greatest_mean: Some(wrong), ..DistanceLimits::default() };
        let error = dense(DensityLimits { column, ..DensityLimits::default() }).unwrap_err();
        assert!(matches!(error, MillingError::DensityInput { name: "column_max_mean", .. }), "{error}");
    }
    Case { told, code: "density-input", exit: None, says: &["row_min", "1.25"] }
}

fn density_without_end() -> Case {
    let told = of_job(
        &spur(),
        &[("rows = 14\ncolumns = 21", "density = { row_max = 0.001, column_max = 2.0 }")]
            .map(|(_, to)| (GRID, to)),
    );
    Case { told, code: "density-size", exit: Some(2), says: &["columns", "20000"] }
}

/// Rows and columns of the template, with their remarks.
const GRID: &str = "rows = 14                               # from root to tip, counted from 0\ncolumns = 21                            # along the tooth";

/// Told as a warning beside the grid with its eight figures: it is milled, but never without saying so.
fn density_that_no_grid_keeps() -> Case {
    let limits = "density = { row_max = 17.0, row_min = 16.0, column_max = 2.0 }";
    let outcome = match run_milling(&loaded(&replaced(&spur(), &[(GRID, limits)])), &Silent) {
        Ok(outcome) => outcome,
        Err(failure) => panic!("{failure:?}"),
    };
    let found = outcome.result.warnings.iter().find(|warning| warning.code == "density-infeasible");
    let warning = found.expect("a warning");
    let flank = &outcome.result.flanks["left"];
    assert!(flank.along_rows.max_mm <= 17.0 && flank.along_rows.min_mm < 16.0, "{:?}", flank.along_rows);
    let told = Told {
        code: warning.code.into(),
        message: warning.text.clone(),
        way_out: warning.way_out.clone(),
        exit: None,
    };
    Case { told, code: "density-infeasible", exit: None, says: &["row_min = 16 mm", "15.0000"] }
}

/// A contact of the spur gear's first flank in its middle column.
fn location(
    shape: CutterShape,
    height: f64,
    orientation: Orientation,
    askew: bool,
) -> Result<CutterLocation, MillingError> {
    let bodies = bodies();
    let flank = &bodies.parts[0].flanks[0].active;
    let [root, tip] = flank.height_span();
    let mut lead = bodies.parts[0].lead.at(0.0)?;
    let section = ColumnPlane::new(flank, lead).section(0.5 * (root + tip), 0.0)?;
    if askew {
        // A plane that lies along the flank: its normal is that of the flank, but for a little.
        lead.direction = (section.jet.normal + Vector3::z() * 0.05).normalize();
    }
    CutterLocation::new(&section.jet, &lead, &shape, 22.0, height, orientation)
}

fn contact_below_the_corner() -> Case {
    let mill = CutterShape::end_mill(3.0, 1.5);
    assert!(location(mill, 6.0, Orientation::default(), false).is_ok());
    let leant = Orientation { tilt: -0.1, ..Orientation::default() };
    assert_eq!(location(mill, 6.0, leant, false).unwrap_err().code(), "tool");
    let told = of_room(location(mill, 1.25, Orientation::default(), false));
    Case { told, code: "tool", exit: None, says: &["1.25", "1.5000", "22"] }
}

fn no_axis_in_the_plane() -> Case {
    let cone = CutterShape::Conical { radius: 2.0, half_angle: 10f64.to_radians(), corner_radius: 0.5 };
    assert!(location(cone, 6.0, Orientation::default(), false).is_ok());
    let told = of_room(location(cone, 6.0, Orientation::default(), true));
    Case { told, code: "axis-none", exit: None, says: &["10.0000 deg", "87."] }
}

/// Its flanks are hollow: a straight cutter touches them at both ends of a chord.
fn end_mill_in_a_ring() -> Case {
    let told = of_job(
        &example("internal-ring.toml"),
        &[
            ("shape = \"ball\"", "shape = \"end-mill\""),
            ("tilt_deg = 14.0", "contact_height = 4.0"),
            ("cutting_length = 12.0", "cutting_length = 12.0\ncorner_radius = 0.5"),
        ],
    );
    Case { told, code: "gouge-local", exit: Some(4), says: &["least curvature", "-0.0"] }
}

fn ball_as_wide_as_the_gap() -> Case {
    let told = of_job(
        &example("internal-ring.toml"),
        &[("diameter = 3.0", "diameter = 8.0"), ("cutting_length = 12.0", "cutting_length = 14.0")],
    );
    Case { told, code: "tool-gap", exit: Some(4), says: &["opposite flank", "wanted are 0.102 mm"] }
}

fn edge_too_short_for_the_root() -> Case {
    let told = of_job(
        &spur(),
        &[
            ("cutting_length = 22.0", "cutting_length = 6.2"),
            ("contact_height = 6.16", "contact_height = 5.0"),
        ],
    );
    Case { told, code: "tool-short", exit: Some(4), says: &["6.26", "6.2 mm"] }
}

fn root_too_shallow_for_the_corner() -> Case {
    let lead = LeadPoint::new(2.5, Vector3::new(0.0, 70.0, 0.0), &Vector3::z(), &Vector3::y()).unwrap();
    let (sin, cos) = 0.2f64.sin_cos();
    let section = |height: f64| {
        let (point, normal) = (Vector3::new(2.0, 72.0, 0.0), Vector3::new(-cos, sin, 0.0));
        let axis = Vector3::new(sin, cos, 0.0);
        RootSection::new(&lead, &point, &normal, &axis, 1.5, 22.0, RootDepth::Bottom(height))
    };
    assert!(section(0.5).is_ok());
    let told = of_room(section(1.9));
    assert!(told.code == "root-corner" && told.message.contains("u = 2.5"), "{told:?}");
    let told = of_job(&spur(), &[("bottom = 0.0", "bottom = 5.5")]);
    Case { told, code: "root-corner", exit: Some(4), says: &["corner radius 1.5 mm", "-0.8626 mm"] }
}

fn root_too_deep() -> Case {
    let told = of_job(&spur(), &[("bottom = 0.0", "straight = 19.0")]);
    Case { told, code: "root-overlap", exit: Some(4), says: &["overlap", "corner radius 1.5 mm"] }
}

fn bottom_cutter_too_wide() -> Case {
    let cutter = "[bottom_cutter]\nshape = \"end-mill\"\ndiameter = 9.0\ncorner_radius = 1.5\ncutting_length = 15.0\n\n[milling]\n";
    let told = of_job(&spur(), &[("[milling]\n", cutter)]);
    Case {
        told,
        code: "root-bottom",
        exit: Some(4),
        says: &["half width 2.44", "tool radius 4.5 mm", "12.15"],
    }
}

fn arc_wider_than_the_gap() -> Case {
    let place = CutterPlace { tip: Vector3::zeros(), axis: Vector3::y(), contact: None };
    let arc = |radius: f64, clearance: f64| {
        approach_arc(&place, &Vector3::z(), &Vector3::x(), &LeadArc::quarter(radius), clearance)
    };
    assert!(arc(0.5, 1.25).is_ok());
    assert_eq!(arc(f64::NAN, 1.25).unwrap_err().code(), "approach");
    Case { told: of_room(arc(2.5, 1.25)), code: "approach", exit: None, says: &["2.5000 mm", "1.2500 mm"] }
}

fn row_without_a_height() -> Case {
    let windows = [[1.5, 9.0], [3.25, 2.0]].map(|[least, greatest]| HeightWindow { least, greatest });
    let told = of_room(HeightRule::Fixed(4.0).heights(&windows));
    Case { told, code: "wear-window", exit: None, says: &["row 1", "3.2500", "2.0000"] }
}
