//! Clamping and bodies of the machine in the proof of programs: what worm and worm spindle come near to over all blocks of a text. Expected
//! distances follow from the words of the texts and the diameters of the bodies.

use flankwright::exchange::machine::parse_machine;
use flankwright::exchange::{AnyJob, Diagnostic, Job, Source, parse_any_job};
use flankwright::nc::Dialect;
use flankwright::numerics::Silent;
use flankwright::workflow::tangential::plan_tangential;
use flankwright::workflow::{
    BodyClearance, CheckedProgram, ClearanceResult, RunFailure, RunPrograms, check_program, plan_job,
};
use std::path::{Path, PathBuf};

const GRINDING: &str = r#"
[job]
name = "clamped"
process = "generating-grinding"
[target]
tolerance_um = 1.0
modifications = [{ kind = "helix_crowning", amount_um = 20.0 }]
[dressing]
profile_crowning_by = "dresser"
[grinding]
method = "diagonal"
prefer = "accuracy"
feed_per_revolution = 0.3
"#;

const TANGENTIAL: &str = r#"
[job]
name = "clamped"
process = "tangential-dressing"
[target]
tolerance_um = 1.0
edge_amounts = { profile_crowning_um = 5.0, lead_crowning_um = 100.0 }
[grinding]
flanks = "right"
shift_width = 48.1042
shift_offset = 0.0
feed_per_revolution = 0.3
[dressing]
variables = "source"
weights = "source"
fit_points = 5
"#;

/// A gear with a face of 40 mm and a root diameter of 72.4 mm, a worm 200 mm in diameter and 100 mm wide.
const BODIES: &str = r#"
[gear]
teeth = 19
normal_module = 3.5
normal_pressure_angle_deg = 17.5
helix_angle_deg = -35.0
profile_shift = 0.0
face_width = 40.0
tip_diameter = 88.5315
root_diameter = 72.4315
form_diameter = 76.2065
[worm]
threads = 3
tip_diameter = 200.0
width = 100.0
[dresser]
tip_diameter = 123.0
pitch_diameter = 115.65
[grid]
profile_points = 5
helix_points = 5
[output]
programs = ["fanuc"]
"#;

const WORM_RADIUS: f64 = 100.0;
/// What a least distance may be above the true one, and what digits and corrections of a motion add, mm.
const KNOWN: f64 = 0.02;
const CORRECTIONS: f64 = 0.1;
const THIN_NUT: &str = r#"{ name = "clamping nut", z = [21, 120], diameter = 60 }"#;

fn shipped() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines/eight-axis.toml")
}

fn text_of(process: &str, machine: &Path, more: &str) -> String {
    format!("{process}{BODIES}[machine]\nfile = {:?}\n{more}\n", machine.display().to_string())
}

fn job(process: &str, machine: &Path, more: &str) -> AnyJob {
    let text = text_of(process, machine, more);
    parse_any_job(Source::new("job.toml", &text)).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

fn planned(job: &AnyJob) -> Result<RunPrograms, RunFailure> {
    let programs = match job.of() {
        Some(loaded) => plan_job(loaded, &Silent)?.programs,
        None => plan_tangential(job.of().expect("a job of tangential dressing"), &Silent)?.programs,
    };
    Ok(programs.expect("a job with a machine"))
}

fn clamped(process: &str, bodies: &str) -> AnyJob {
    job(process, &shipped(), &format!("clamping = [{bodies}]"))
}

fn clearance(programs: &RunPrograms) -> &ClearanceResult {
    programs.result.clearance.as_ref().expect("bodies of revolution")
}

fn refused(job: &AnyJob) -> Diagnostic {
    match planned(job) {
        Err(RunFailure::NotProducible(finding)) => *finding,
        Err(other) => panic!("{other:?}"),
        Ok(programs) => panic!("it must be refused: {:?}", programs.result.clearance),
    }
}

fn of<'a>(clearance: &'a ClearanceResult, name: &str) -> &'a BodyClearance {
    clearance.bodies.iter().find(|body| body.body == name).unwrap_or_else(|| panic!("{name}: {clearance:?}"))
}

/// The text of the Fanuc program of a station.
fn text(programs: &RunPrograms, what: &str) -> String {
    let of = programs.built.programs.iter().find(|p| p.dialect == Dialect::Fanuc && p.file.contains(what));
    of.expect("a program").written.text.clone()
}

/// How near the axis of the worm comes to that of gear or dresser, by the X of a text.
fn nearest_axes(text: &str) -> f64 {
    let words = text.lines().filter(|line| line.starts_with('G')).flat_map(str::split_whitespace);
    let places = words.filter_map(|word| word.strip_prefix('X')?.parse::<f64>().ok());
    -places.fold(f64::NEG_INFINITY, f64::max)
}

/// A thin nut stays below the root: the worm passes over it at the centre distance.
#[test]
fn a_thin_nut_passes_with_its_least_distance_in_both_processes() {
    for process in [GRINDING, TANGENTIAL] {
        let programs = planned(&clamped(process, THIN_NUT)).expect("a thin nut");
        let clearance = clearance(&programs);
        assert_eq!(clearance.bodies.len(), 1);
        let nut = of(clearance, "clamping nut");
        let expected = nearest_axes(&text(&programs, "grinding")) - WORM_RADIUS - 30.0;
        assert!((nut.least_mm - expected).abs() < KNOWN, "{nut:?}, expected {expected}");
        assert_eq!(nut.of, "worm");
        assert!(nut.file.contains("grinding") && nut.block > 0);
        assert_eq!(clearance.bodies_kept_mm, Some(1.0));
        assert!(
            clearance.statement.contains("clear of clamping nut: least distance"),
            "{}",
            clearance.statement
        );
        assert!(!clearance.not_checked.contains(&"clamping"), "{:?}", clearance.not_checked);
        assert!(clearance.not_checked.contains(&"parts of the machine"), "{:?}", clearance.not_checked);
        for proof in &programs.result.proofs {
            let not = proof.not_covered.join("; ");
            assert!(not.contains("parts of the machine") && !not.contains("clamping"), "{not}");
        }
    }
}

/// What the verdict says of the clamping is what the texts were checked for.
#[test]
fn the_verdict_lists_the_nut_or_that_nothing_stands_for_it() {
    let verdict = |job: AnyJob| {
        let Some(loaded) = job.of::<Job>().cloned() else { panic!("a grinding job") };
        plan_job(&loaded, &Silent).expect("a plan").result.verdict
    };
    let with = verdict(clamped(GRINDING, THIN_NUT));
    assert!(with.judged().iter().any(|one| one.item.contains("clamping nut")), "{with:?}");
    assert!(!with.not_judged().iter().any(|one| one.item.contains("collisions with clamping")), "{with:?}");
    let without = verdict(job(GRINDING, &shipped(), ""));
    assert!(
        without.not_judged().iter().any(|one| one.item.contains("collisions with clamping")),
        "{without:?}"
    );
}

/// The stroke runs out beside the face at full depth: a nut wider than the root stands in its way.
#[test]
fn a_long_nut_beside_the_face_is_refused_by_name() {
    for process in [GRINDING, TANGENTIAL] {
        let wide = r#"{ name = "arbor", z = [-90, -21], diameter = 40 }, { name = "clamping nut", z = [21, 60], diameter = 80 }"#;
        let finding = refused(&clamped(process, wide));
        assert_eq!(finding.code, "bodies-too-close");
        assert_eq!(finding.field.as_deref(), Some("machine.clamping[1]"));
        for part in ["grinding-fanuc", "block ", "worm and clamping nut run into each other", "1 mm are kept"]
        {
            assert!(finding.message.contains(part), "{part}: {}", finding.message);
        }
        assert!(finding.way_out.as_ref().is_some_and(|way_out| way_out.contains("thinner or shorter")));
    }
}

/// Between clear and touching the distance is told, and less may be kept.
#[test]
fn a_nut_that_comes_too_near_is_told_with_its_distance() {
    let near = r#"{ name = "clamping nut", z = [21, 60], diameter = 71.2 }"#;
    let finding = refused(&clamped(GRINDING, near));
    assert!(finding.message.contains("worm and clamping nut come to 0."), "{}", finding.message);
    let less = job(GRINDING, &shipped(), &format!("clamping = [{near}]\nbody_clearance = 0.5"));
    let programs = planned(&less).expect("0.5 mm are kept");
    let least = of(clearance(&programs), "clamping nut").least_mm;
    let expected = nearest_axes(&text(&programs, "grinding")) - WORM_RADIUS - 35.6;
    assert!((least - expected).abs() < KNOWN && least > 0.5, "{least}, {expected}");
}

/// A cone is as wide as it is where the worm passes.
#[test]
fn a_cone_is_no_cylinder() {
    let cone = |end: f64| {
        clamped(
            GRINDING,
            &format!(r#"{{ name = "cone", z = [21, 221], diameter = 50, end_diameter = {end} }}"#),
        )
    };
    let least = |job: &AnyJob| of(clearance(&planned(job).expect("a slim cone")), "cone").least_mm;
    let (slim, wide) = (least(&cone(50.0)), least(&cone(90.0)));
    assert!(wide < slim - 0.5, "{wide}, {slim}");
    assert_eq!(refused(&cone(400.0)).field.as_deref(), Some("machine.clamping[0]"));
}

fn checked(text: &str, job: &AnyJob, programs: &RunPrograms) -> CheckedProgram {
    check_program((text.as_bytes(), None), Dialect::Fanuc, &programs.machine, Some(job), &Silent)
        .expect("a program")
}

fn too_close(checked: &CheckedProgram) -> Vec<String> {
    let remarks = checked.remarks.iter().filter(|remark| remark.code == "bodies-too-close");
    remarks.map(|remark| remark.text.clone()).collect()
}

/// The block that a message begins with.
fn block_of(text: &str) -> usize {
    let number = text.strip_prefix("block ").and_then(|rest| rest.split(':').next());
    number.and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("{text}"))
}

/// Rapid moves into the nut behind the last stroke, far above the blank, are found by their block; the text as written is clear.
#[test]
fn a_rapid_move_through_the_nut_is_noticed_with_its_block() {
    for process in [GRINDING, TANGENTIAL] {
        let job = clamped(process, THIN_NUT);
        let programs = planned(&job).expect("a thin nut");
        let written = text(&programs, "grinding");
        let whole = checked(&written, &job, &programs);
        assert_eq!(too_close(&whole), [""; 0]);
        let least = whole.bodies.iter().find(|body| body.body == "clamping nut").expect("the nut").least_mm;
        assert_eq!(least, of(clearance(&programs), "clamping nut").least_mm);
        let at = written.rfind("G94").expect("the end of inverse time");
        let with = |moves: &str| {
            let damaged = format!("{}{moves}{}", &written[..at], &written[at..]);
            checked(&damaged, &job, &programs)
        };
        // Beside the nut, and to its middle.
        assert_eq!(too_close(&with("G0 Z110.000000 Y0.000000\nG0 X-140.000000\n")), [""; 0]);
        let damaged = with("G0 Z110.000000 Y0.000000\nG0 X-120.000000\n");
        let found = too_close(&damaged);
        assert_eq!(found.len(), 1, "{:?}", damaged.remarks);
        assert!(found[0].contains("worm and clamping nut run into each other"), "{found:?}");
        let last = whole.strokes.iter().map(|stroke| stroke.blocks[1]).max().expect("strokes");
        assert!(block_of(&found[0]) > last + 1 && block_of(&found[0]) <= damaged.blocks, "{found:?}");
    }
}

/// The shipped machine with bodies and with its dresser elsewhere.
fn machine(directory: &Path, dresser_z: f64, bodies: &str) -> PathBuf {
    let mut text = std::fs::read_to_string(shipped()).expect("a shipped machine");
    if dresser_z != 0.0 {
        for (from, to) in [
            ("min_mm = -250\n".to_owned(), "min_mm = -800\n".to_owned()),
            (
                "direction = [0, 1, 0]\nendless = true\nletter = \"spindle 1\"".to_owned(),
                format!(
                    "direction = [0, 1, 0]\npoint_mm = [0, 0, {dresser_z}]\nendless = true\nletter = \"spindle 1\""
                ),
            ),
            (
                "axes = [\"C5\", \"B3\"]\nframe = { x".to_owned(),
                format!("axes = [\"C5\", \"B3\"]\nframe = {{ origin_mm = [0, 0, {dresser_z}], x"),
            ),
        ] {
            assert!(text.contains(&from), "{from}");
            text = text.replacen(&from, &to, 1);
        }
    }
    let path = directory.join("machine.toml");
    std::fs::write(&path, format!("{text}\n{bodies}")).expect("a machine");
    path
}

fn body(name: &str, axis: &str, [from, to]: [[f64; 3]; 2], diameter: f64) -> String {
    let axis = if axis.is_empty() { String::new() } else { format!("axis = {axis:?}\n") };
    format!(
        "[[bodies]]\nname = {name:?}\n{axis}from_mm = {from:?}\nto_mm = {to:?}\ndiameter_mm = {diameter}\n"
    )
}

/// A bearing beside the worm, a table below the gear, the spindle of the dresser, a column on the bed.
fn all_sides(bearing: f64, spindle: f64) -> String {
    [
        body("outboard bearing", "V1", [[0.0, 52.0, 0.0], [0.0, 120.0, 0.0]], bearing),
        body("table", "C2", [[0.0, 0.0, -300.0], [0.0, 0.0, -190.0]], 200.0),
        body("dresser spindle", "B3", [[0.0, 10.0, 0.0], [0.0, 80.0, 0.0]], spindle),
        body("column", "", [[120.0, 0.0, -200.0], [120.0, 0.0, 300.0]], 80.0),
    ]
    .concat()
}

#[test]
fn bodies_of_the_machine_are_kept_clear_in_grinding_and_dressing() {
    let directory = tempfile::tempdir().expect("a directory");
    let with = |bodies: &str| {
        job(GRINDING, &machine(directory.path(), 0.0, bodies), &format!("clamping = [{THIN_NUT}]"))
    };
    let programs = planned(&with(&all_sides(150.0, 90.0))).expect("bodies that are clear");
    let clearance = clearance(&programs);
    let names: Vec<&str> = clearance.bodies.iter().map(|body| body.body.as_str()).collect();
    for name in ["clamping nut", "table", "dresser spindle", "column", "blank", "dresser"] {
        assert!(names.contains(&name), "{name}: {names:?}");
    }
    assert!(clearance.bodies.windows(2).all(|pair| pair[0].least_mm <= pair[1].least_mm));
    // Worm and dresser spindle stand across each other at their centre distance; the spindle is 90 mm thick.
    let spindle = of(clearance, "dresser spindle");
    let expected = nearest_axes(&text(&programs, "dressing")) - WORM_RADIUS - 45.0;
    assert!((spindle.least_mm - expected).abs() < CORRECTIONS, "{spindle:?}, {expected}");
    assert!(spindle.of == "worm" && spindle.file.contains("dressing"), "{spindle:?}");
    // The bearing beside the worm, which the blank meets; worm and blank themselves belong to the strokes.
    assert_eq!(of(clearance, "blank").of, "outboard bearing");
    assert_eq!(of(clearance, "dresser").of, "outboard bearing");
    // All that is left is what the machine does with the dresser while it grinds.
    assert_eq!(clearance.not_checked.len(), 1, "{:?}", clearance.not_checked);
    assert!(clearance.not_checked[0].contains("in one place"));
    // A bearing nearly as wide as the worm meets the dresser, a wide spindle of the dresser the worm.
    let finding = refused(&with(&all_sides(196.0, 90.0)));
    assert!(finding.message.contains("outboard bearing and dresser"), "{finding:?}");
    assert_eq!(finding.field.as_deref(), Some("machine.file"));
    let finding = refused(&with(&all_sides(150.0, 115.0)));
    assert!(
        finding.message.contains("dressing-fanuc") && finding.message.contains("worm and dresser spindle"),
        "{finding:?}"
    );
}

/// Where the machine says where its dresser stands, the gear is kept from the worm while it is dressed and the dresser while it grinds.
#[test]
fn a_dresser_beside_the_gear_is_kept_clear_of_the_worm_that_grinds() {
    let directory = tempfile::tempdir().expect("a directory");
    let programs = planned(&job(GRINDING, &machine(directory.path(), -500.0, ""), "")).expect("far away");
    let clearance = clearance(&programs);
    let [blank, dresser] = ["blank", "dresser"].map(|name| of(clearance, name));
    assert!(blank.file.contains("dressing") && dresser.file.contains("grinding"), "{blank:?}, {dresser:?}");
    assert!(blank.least_mm > 200.0 && dresser.least_mm > 200.0, "{blank:?}, {dresser:?}");
    assert!(!clearance.not_checked.iter().any(|left| left.contains("in one place")));
    let finding = refused(&job(GRINDING, &machine(directory.path(), -90.0, ""), ""));
    assert!(finding.message.contains("grinding-fanuc"), "{finding:?}");
    assert!(finding.message.contains("worm and dresser"), "{finding:?}");
}

#[test]
fn contradictions_are_told_with_their_key() {
    let fields = |more: &str| -> Vec<String> {
        let error =
            parse_any_job(Source::new("job.toml", &text_of(GRINDING, &shipped(), more))).expect_err(more);
        error.diagnostics.iter().filter_map(|d| d.field.as_deref().map(str::to_owned)).collect()
    };
    assert_eq!(
        fields(r#"clamping = [{ name = "nut", z = [40, 21], diameter = 60 }]"#),
        ["machine.clamping[0].z"]
    );
    let twice = r#"{ name = "nut", z = [21, 40], diameter = 60 }"#;
    assert_eq!(fields(&format!("clamping = [{twice}, {twice}]")), ["machine.clamping[1].name"]);
    assert_eq!(
        fields(r#"clamping = [{ name = "nut", z = [21, 40], diameter = 0 }]"#),
        ["machine.clamping[0].diameter"]
    );
    let of_machine = |bodies: &str| -> Vec<String> {
        let text = std::fs::read_to_string(shipped()).expect("a shipped machine");
        let error =
            parse_machine(Source::new("machine.toml", &format!("{text}\n{bodies}"))).expect_err(bodies);
        error.diagnostics.iter().filter_map(|d| d.field.as_deref().map(str::to_owned)).collect()
    };
    let ends = [[0.0, 52.0, 0.0], [0.0, 120.0, 0.0]];
    assert_eq!(of_machine(&body("bearing", "V9", ends, 150.0)), ["bodies[0].axis"]);
    // The spindle would swing it around.
    assert_eq!(
        of_machine(&body("head", "B1", [[0.0, 52.0, 30.0], [0.0, 120.0, 30.0]], 150.0)),
        ["bodies[0].axis"]
    );
    assert_eq!(of_machine(&body("disc", "V1", [ends[0], ends[0]], 150.0)), ["bodies[0].to_mm"]);
    let one = body("bearing", "V1", ends, 150.0);
    assert_eq!(of_machine(&format!("{one}{one}")), ["bodies[1].name"]);
}
