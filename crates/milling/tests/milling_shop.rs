//! What a shop sets up: lengths, speeds, feeds and coolant of every tool, work offset, clocking angle. Programs are looked at as texts, and
//! texts that say something else than the job are found.

use foundation::numerics::Silent;
use job::machine::read_machine;
use job::{Loaded, Source, parse_job_of};
use milling::job::MillingJob;
use milling::workflow::{MillingOutcome, check_milling, run_milling};
use nc::Dialect;
use run::program_check::CheckedProgram;
use std::path::PathBuf;

/// A spur gear in few rows, one space, with two tools; all that is set up stands in `machine`, `cutter` and `bottom`.
fn text(machine: &str, cutter: &str, bottom: &str) -> String {
    format!(
        r#"[job]
name = "shop"
process = "five-axis-milling"
[gear]
teeth = 20
normal_module = 8.0
normal_pressure_angle_deg = 20.0
helix_angle_deg = 0.0
profile_shift = 0.0
face_width = 20.0
tip_diameter = 176.0
root_diameter = 140.0
form_diameter = 152.0
[target]
tolerance_um = 60.0
[cutter]
shape = "end-mill"
diameter = 6.0
corner_radius = 1.5
cutting_length = 22.0
{cutter}
[bottom_cutter]
shape = "end-mill"
diameter = 4.0
corner_radius = 1.5
cutting_length = 15.0
{bottom}
[milling]
row_spacing = "scallop"
rows = 6
columns = 9
contact_height = {{ from = 5.0, to = 15.0 }}
teeth = "one"
feed_mm_per_min = 1200.0
spindle_rpm = 8000.0
[milling.root]
bottom = 0.0
[simulation]
rays_profile = 9
rays_length = 3
[machine]
file = "five-axis-ac-table.toml"
tool_length = 100.0
{machine}
[output]
programs = ["linuxcnc", "siemens", "fanuc"]
"#
    )
}

fn machines() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../machines")
}

fn load(text: &str) -> Loaded<MillingJob> {
    let name = machines().join("job.toml");
    parse_job_of(Source::new(&*name.to_string_lossy(), text)).unwrap_or_else(|error| panic!("{error}"))
}

fn made(text: &str) -> MillingOutcome {
    run_milling(&load(text), &Silent).unwrap_or_else(|failure| panic!("{failure:?}"))
}

fn program(outcome: &MillingOutcome, dialect: Dialect) -> &str {
    let programs = &outcome.texts.programs.as_ref().unwrap().programs;
    &programs.iter().find(|program| program.dialect == dialect).unwrap().written.text
}

fn checked(job: &str, text: &str, dialect: Dialect) -> Result<CheckedProgram, String> {
    let machine = read_machine(&machines().join("five-axis-ac-table.toml")).unwrap();
    check_milling(text.as_bytes(), dialect, &machine, &load(job), &Silent)
        .map_err(|failure| format!("{failure:?}"))
}

fn codes(checked: &CheckedProgram) -> Vec<&'static str> {
    checked.part.iter().flat_map(|part| &part.faults).map(|fault| fault.code).collect()
}

/// Largest value of Z in a text.
fn highest(text: &str) -> f64 {
    let words = text.lines().filter(|line| !line.starts_with(['(', ';'])).flat_map(|line| line.split(' '));
    let heights = words.filter_map(|word| word.strip_prefix('Z')?.parse::<f64>().ok());
    heights.fold(f64::NEG_INFINITY, f64::max)
}

const MOUNT: &str = "mount = { height = 40.0 }";

#[test]
fn every_tool_has_its_length_speed_feed_and_coolant() {
    let cutter =
        "tool_length = 130.0\nspindle_rpm = 9000.0\nfeed_mm_per_min = 900.0\ncoolant = \"flood-and-mist\"";
    let bottom = "spindle_rpm = 12000.0\nplunge_feed_mm_per_min = 300.0\ncoolant = \"flood\"";
    let job = text(&format!("{MOUNT}\nrtcp = \"off\"\nspindle_dwell_s = 1.5"), cutter, bottom);
    let outcome = made(&job);
    let tools = &outcome.result.tools;
    assert_eq!(tools.iter().map(|tool| tool.length_mm.unwrap()).collect::<Vec<_>>(), [130.0, 100.0]);
    assert_eq!(tools[0].feed_mm_per_min, 900.0);
    assert_eq!(
        (tools[1].spindle_rpm, tools[1].plunge_feed_mm_per_min, tools[1].coolant),
        (12000.0, 300.0, "flood")
    );
    for dialect in Dialect::ALL {
        let own = program(&outcome, dialect);
        let change = own.find("T2").unwrap();
        // The flanks come first, 30 mm higher than with the length of the machine; both supplies on, then off before the change.
        let (first, second) = own.split_at(change);
        assert!(first.contains("M7\nM8\n") && first.contains("M9\n") && second.contains("M8\n"), "{own}");
        assert!(!second.contains("M7\n") && second.contains("M9\n"), "{own}");
        assert!(first.contains("G4 "), "{own}");
        let alike = made(&text(&format!("{MOUNT}\nrtcp = \"off\""), "", ""));
        let before = program(&alike, dialect);
        let before = before.split_at(before.find("T2").unwrap());
        assert!((highest(first) - highest(before.0) - 30.0).abs() < 1e-3);
        assert!((highest(second) - highest(before.1)).abs() < 1e-3);
        assert_eq!(codes(&checked(&job, own, dialect).unwrap()), [""; 0]);
        // Without coolant, or with that of the other tool, the text is found.
        for changed in [own.replacen("M8\n", "", 1), own.replacen("M9\n", "", 1)] {
            let found = codes(&checked(&job, &changed, dialect).unwrap());
            assert_eq!(found, ["coolant"], "{dialect:?}");
        }
    }
}

#[test]
fn a_control_that_holds_lengths_gets_positions_of_the_tip() {
    let with = |holder: &str, numbers: [&str; 2]| {
        text(&format!("{MOUNT}\nrtcp = \"off\"\ntool_length_in = \"{holder}\""), numbers[0], numbers[1])
    };
    let job = with("control", ["tool_length = 130.0\nlength_offset = 21", ""]);
    let outcome = made(&job);
    let beside = made(&with("program", ["tool_length = 130.0", ""]));
    for (dialect, first, second, ends) in [
        (Dialect::LinuxCnc, "\nG43 H21\n", "\nG43 H2\n", "G49"),
        (Dialect::Siemens, "\nD21\n", "\nD1\n", "D0"),
        (Dialect::Fanuc, "\nG43 H21\n", "\nG43 H2\n", "G49"),
    ] {
        let own = program(&outcome, dialect);
        assert!(own.contains(first) && own.contains(second) && own.contains(ends), "{own}");
        let (own_first, _) = own.split_at(own.find("T2").unwrap());
        let other = program(&beside, dialect);
        let (other_first, _) = other.split_at(other.find("T2").unwrap());
        assert!((highest(other_first) - highest(own_first) - 130.0).abs() < 1e-3);
        assert_eq!(codes(&checked(&job, own, dialect).unwrap()), [""; 0]);
        // Another number, and a text that holds the lengths itself, are not what the job says.
        let changed = own.replacen(first, &first.replace("21", "22"), 1);
        assert!(checked(&job, &changed, dialect).unwrap_err().contains("length offset"));
        let refused =
            checked(&with("program", ["tool_length = 130.0\nlength_offset = 21", ""]), own, dialect)
                .unwrap_err();
        assert!(refused.contains("machine.tool_length_in"), "{refused}");
    }
    // No linear axis of a head that tilts stays along its tool.
    let tilting = job.replace("five-axis-ac-table", "five-axis-head-table");
    let refused = run_milling(&load(&tilting), &Silent).map(|_| ()).unwrap_err();
    let refused = format!("{refused:?}");
    assert!(
        refused.contains("length-not-addable") && refused.contains("machine.tool_length_in"),
        "{refused}"
    );
}

#[test]
fn a_work_offset_shifts_positions_and_is_the_one_of_the_job() {
    for rtcp in ["off", "on"] {
        let with = |offset: &str| text(&format!("{MOUNT}\nrtcp = \"{rtcp}\"\n{offset}"), "", "");
        let job = with("work_offset = { number = 3 }");
        let outcome = made(&job);
        let given = made(&with("work_offset = { number = 1, position = [1.0, 2.0, 3.0] }"));
        let without = made(&with(""));
        let held = outcome.result.work_offset.as_ref().unwrap();
        // Without values of its own it is the workpiece on the table.
        assert_eq!((held.number, held.position_mm, held.clocking.is_none()), (3, [0.0, 0.0, 40.0], true));
        for (dialect, word) in
            [(Dialect::LinuxCnc, "\nG56\n"), (Dialect::Siemens, "\nG56\n"), (Dialect::Fanuc, "\nG56\n")]
        {
            let [own, other, plain] = [&outcome, &given, &without].map(|outcome| program(outcome, dialect));
            assert!(own.contains(word) && other.contains("\nG54\n") && !plain.contains(word), "{own}");
            assert!((highest(plain) - highest(own) - 40.0).abs() < 1e-3);
            assert!((highest(plain) - highest(other) - 3.0).abs() < 1e-3);
            assert_eq!(codes(&checked(&job, own, dialect).unwrap()), [""; 0]);
            let refused = checked(&job, &own.replacen("G56", "G55", 1), dialect).unwrap_err();
            assert!(refused.contains("work offset"), "{refused}");
            let refused = checked(&job, &own.replacen("G56\n", "", 1), dialect).unwrap_err();
            assert!(refused.contains("work offset"), "{refused}");
        }
    }
}

#[test]
fn a_clocking_angle_turns_the_workpiece_in_the_program_or_on_the_control() {
    let with = |clocking: &str, offset: &str| {
        text(
            &format!("mount = {{ height = 40.0, clocking_deg = {clocking} }}\nrtcp = \"off\"\n{offset}"),
            "",
            "",
        )
    };
    let straight = made(&with("0.0", "work_offset = { number = 1 }"));
    let turned = made(&with("7.25", "work_offset = { number = 1 }"));
    let held = made(&with("7.25", "work_offset = { number = 1, clocking = true }"));
    let first = |outcome: &MillingOutcome| {
        let text = program(outcome, Dialect::Siemens).to_owned();
        let line = text.lines().find(|line| line.starts_with('N') && line.contains(" C")).unwrap().to_owned();
        let angle = line.split(' ').find_map(|word| word.strip_prefix('C')?.parse::<f64>().ok());
        angle.unwrap()
    };
    // The table turns the other way round to bring the tooth back; it counts the other way as well (ISO 841).
    assert!(
        (first(&turned) - first(&straight) - 7.25).abs() < 1e-4,
        "{} {}",
        first(&turned),
        first(&straight)
    );
    assert_eq!(program(&held, Dialect::Siemens), program(&straight, Dialect::Siemens));
    let clocking = held.result.work_offset.unwrap().clocking.unwrap();
    assert!(clocking.axis == "C" && (clocking.value_deg - 7.25).abs() < 1e-9, "{clocking:?}");
    // The same tooth: what one holds in the program is beside the other by its angle, and is found.
    let job = with("7.25", "work_offset = { number = 1 }");
    let found = codes(&checked(&job, program(&straight, Dialect::Siemens), Dialect::Siemens).unwrap());
    assert!(!found.is_empty());
    let beside = with("7.25", "work_offset = { number = 1, clocking = true }")
        .replace("five-axis-ac-table", "five-axis-head-head");
    let refused = run_milling(&load(&beside), &Silent).map(|_| ()).unwrap_err();
    assert!(format!("{refused:?}").contains("clocking-not-holdable"), "{refused:?}");
}

#[test]
fn what_stands_before_finishing_is_found_and_has_to_be_enough() {
    let plain = text(MOUNT, "", "");
    let stocked = |stock: &str| {
        let job = plain.replace("[target]", &format!("{stock}\n[target]"));
        job.replace("programs = [\"linuxcnc\", \"siemens\", \"fanuc\"]", "programs = [\"siemens\"]")
    };
    let codes = |outcome: &MillingOutcome| {
        outcome.result.verdict.reason().map(|reason| reason.code).into_iter().collect::<Vec<_>>()
    };
    // The tip of the tooth moves by r_a times the angle, its normal stands at the pressure angle there: r_b times the angle.
    let base_radius = 80.0 * 20f64.to_radians().cos();
    let met = made(&stocked("[stock]\nform = \"pre-cut\"\nallowance = 0.2\nclocking_error_deg = 0.1"));
    let off = base_radius * 0.1f64.to_radians();
    for stock in met.result.stock.values() {
        assert!(
            (stock.before_mm[0] - (0.2 - off)).abs() < 1e-9
                && (stock.before_mm[1] - (0.2 + off)).abs() < 1e-9
        );
    }
    assert!(codes(&met).is_empty());
    let missed = made(&stocked("[stock]\nform = \"pre-cut\"\nallowance = 0.1\nclocking_error_deg = 0.1"));
    assert!(codes(&missed).contains(&"no-stock"), "{:?}", codes(&missed));
    // Roughing leaves its allowance to a hundredth of a millimetre or more, and nothing uncut below the first layer.
    let roughing = "[milling.roughing]\nallowance = 0.3\nstep_down = 3.0\nstep_over = 2.0\n[simulation]";
    let solid = made(&stocked("[stock]\nform = \"solid\"").replace("[simulation]", roughing));
    for stock in solid.result.stock.values() {
        let [least, greatest] = stock.before_mm;
        assert!(least > 0.29 && greatest > least && stock.uncut < stock.rays / 4, "{stock:?}");
    }
    assert!(plain_has_no_stock(&plain));
}

fn plain_has_no_stock(job: &str) -> bool {
    made(job).result.stock.is_empty()
}

#[test]
fn leads_stand_at_the_ends_at_which_the_cutter_comes_and_leaves() {
    let with = |leads: &str| {
        let job = text(MOUNT, "", "")
            .replace("traverse = \"zigzag\"", "")
            .replace("teeth = \"one\"", &format!("teeth = \"one\"\n{leads}"));
        made(&job)
    };
    let plain = with("");
    let led = with("lead_in = { radius = 0.4, angle_deg = 60.0, straight = 0.3 }");
    let out = with("lead_out = { radius = 0.4, angle_deg = 60.0, straight = 0.3 }");
    let places = |outcome: &MillingOutcome| outcome.plan.operations[0].paths[0].places.clone();
    let [plain, led, out] = [&plain, &led, &out].map(places);
    let more = led.len() - plain.len();
    assert!(more > 3 && led[more..] == plain[..] && out[..plain.len()] == plain[..]);
    let begin = led[0].tip - plain[0].tip;
    let aside = 0.4 * 0.5 + 0.3 * 60f64.to_radians().sin();
    let along = 0.4 * 60f64.to_radians().sin() + 0.3 * 0.5;
    assert!((begin.norm() - aside.hypot(along)).abs() < 1e-9, "{begin}");
}

const CLOCKED: &str =
    "mount = { height = 40.0, clocking_deg = 3.0 }\nwork_offset = { number = 2, clocking = true }";

/// The ball touches where its middle lies on the involute that the flank becomes a radius off: theta = eta - inv(alpha_t) + inv(alpha_M) -
/// rho/r_b to either side of the middle, as sizes over balls have it.
#[test]
fn the_clocking_program_touches_where_sizes_over_balls_say() {
    let probe = "probe = { number = 90, diameter = 4.0, tool_length = 140.0, height = 10.0 }";
    let outcome = made(&text(&format!("{CLOCKED}\n{probe}"), "", ""));
    let theta = (std::f64::consts::PI / 40.0 - 2.0 / (80.0 * 20f64.to_radians().cos())).to_degrees();
    let cycles = &outcome.result.clocking_programs;
    assert_eq!(cycles.len(), 3);
    for cycle in cycles {
        let [first, second] = cycle.touches_deg;
        assert!(((first - second).abs() - 2.0 * theta).abs() < 1e-6, "{cycle:?} {theta}");
        assert!((cycle.middle_deg - 0.5 * (first + second)).abs() < 1e-12);
        assert!(cycle.axis == "C" && cycle.tried_deg == 1.0 && cycle.off_deg < 1e-4, "{cycle:?}");
    }
    for (dialect, words) in [
        (Dialect::LinuxCnc, ["G55\n", "G38.2 C", "G10 L2 P2 C[#5246+[#101+#102]/2-["]),
        (Dialect::Siemens, ["G55\n", "MEAS=1 G1 C", "$P_UIFR[2,C,TR]=$P_UIFR[2,C,TR]+(R101+R102)/2-("]),
        (Dialect::Fanuc, ["G55\n", "G31 C", "G90 G10 L2 P2 C[#"]),
    ] {
        let cycle = outcome.texts.cycles.iter().find(|cycle| cycle.dialect == dialect).unwrap();
        assert!(words.iter().all(|wanted| cycle.text.contains(wanted)), "{}", cycle.text);
    }
}

#[test]
fn helical_and_asymmetric_spaces_are_probed_as_well_and_balls_have_to_fit() {
    let with = |diameter: &str| {
        let probe = format!(
            "probe = {{ number = 90, diameter = {diameter}, tool_length = 140.0, search_deg = 1.0 }}"
        );
        text(&format!("{CLOCKED}\n{probe}"), "", "")
    };
    for (was, is) in [
        ("helix_angle_deg = 0.0", "helix_angle_deg = 12.0"),
        ("normal_pressure_angle_deg = 20.0", "normal_pressure_angle_deg = { left = 20.0, right = 17.0 }"),
    ] {
        let job = with("3.0")
            .replace(was, is)
            .replace("form_diameter = 152.0", "form_diameter = 154.0")
            .replace("tolerance_um = 60.0", "tolerance_um = 900.0");
        let outcome = made(&job);
        for cycle in &outcome.result.clocking_programs {
            assert!(cycle.tried_deg == 0.5 && cycle.off_deg < 1e-4, "{cycle:?}");
        }
        assert_eq!(outcome.result.clocking_programs.len(), 3);
    }
    let refused = run_milling(&load(&with("14.0")), &Silent).map(|_| ()).unwrap_err();
    let refused = format!("{refused:?}");
    assert!(refused.contains("probe-too-large") && refused.contains("machine.probe.diameter"), "{refused}");
}
