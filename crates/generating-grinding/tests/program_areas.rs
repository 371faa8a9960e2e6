//! Programs on more than one area of the worm, and on conical bodies: proven from their texts.

use foundation::numerics::Silent;
use generating_grinding::job::LoadedJob;
use generating_grinding::workflow::{Outcome, plan_job};
use job::{Source, parse_job_of as parse_job};
use std::path::Path;

/// An example on the machine without swivel, its keys changed, with lines for `[machine]`.
fn job(example: &str, changes: &[(&str, &str)], more: &str) -> LoadedJob {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let path = root.join("examples").join(format!("{example}.toml"));
    let mut text = std::fs::read_to_string(&path).expect("an example");
    if let Some(from) = text.find("[machine]") {
        let to = from + text[from..].find("\n\n").expect("the table's end");
        text.replace_range(from..to, "");
    }
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    let mut file = root.join("machines/no-swivel.toml");
    if !more.is_empty() {
        // Areas over a worm of 200 mm take more travel along it than the shipped machine has.
        let machine = std::fs::read_to_string(&file).expect("a machine");
        let machine =
            machine.replace("min_mm = -140", "min_mm = -250").replace("max_mm = 140", "max_mm = 250");
        file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no-swivel-long-shift.toml");
        std::fs::write(&file, machine).expect("a machine with more travel");
    }
    text.push_str(&format!("\n[machine]\nfile = {:?}\n{more}\n", file.display().to_string()));
    parse_job(Source::new(path.display().to_string(), &text)).unwrap_or_else(|e| panic!("{example}: {e}"))
}

fn planned(loaded: &LoadedJob) -> Outcome {
    plan_job(loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}"))
}

/// The proof says of every flank what the run says.
fn proven(outcome: &Outcome) {
    let programs = outcome.result.programs.as_ref().expect("programs");
    assert!(!programs.proofs.is_empty());
    for proof in &programs.proofs {
        assert_eq!(proof.flanks.len(), outcome.result.flanks.len());
        for (flank, proof) in &proof.flanks {
            let planned = outcome.result.flanks[flank].max_deviation_um;
            let apart = (proof.max_deviation_um - planned).abs();
            assert!(apart < 0.02, "{flank}: {} um proven, {planned} um planned", proof.max_deviation_um);
        }
    }
}

const GRID: &str = "profile_points = 41\nhelix_points = 41";
const COARSE: &str = "profile_points = 11\nhelix_points = 11";

/// Roughing passes touch lines of their own, which are dressed; the finished flank is that of the plan.
#[test]
fn roughing_passes_keep_to_their_dressed_areas() {
    let loaded = job(
        "twist-free-crowning",
        &[
            (GRID, COARSE),
            ("width = 100.0", "width = 200.0"),
            ("method = \"diagonal\"", "method = \"diagonal\"\nroughing_areas = 2\nroughing_ratio = -0.3"),
        ],
        "roughing_stock_um = [60.0, 20.0]",
    );
    let outcome = planned(&loaded);
    proven(&outcome);
    let programs = outcome.result.programs.as_ref().expect("programs");
    for flank in outcome.result.flanks.keys() {
        let of = |area: &str| -> Vec<[f64; 2]> {
            let found = programs.worm_use.iter().filter(|one| one.flank == *flank && one.area == area);
            found.map(|one| one.lines_mm).collect()
        };
        let areas = ["roughing 1", "roughing 2", "finishing 1"].map(of);
        for lines in &areas {
            assert!(!lines.is_empty(), "{:?}", programs.worm_use);
        }
        for pair in areas.windows(2) {
            assert!(pair[0][0][1] < pair[1][0][0] + 1e-3, "{flank}: {areas:?}");
        }
    }
    // The dressing program covers the whole of it: at least the length of all areas.
    let length = outcome.result.settings.partition.as_ref().expect("areas").length_mm;
    for program in programs.programs.iter().filter(|p| p.job == "dressing") {
        for pass in &program.passes {
            let way = (pass.driven_mm[1] - pass.driven_mm[0]).abs();
            assert!(way > length, "{}: {way} of {length} mm", pass.name);
        }
    }
}

/// Conical worms and workpieces: programs as of any other body.
#[test]
fn conical_bodies_have_proven_programs() {
    for example in [
        "dressing/conical-worm",
        "beveloid-cylindrical-worm",
        "beveloid-conical-worm",
        "asymmetric-conical-worm",
    ] {
        proven(&planned(&job(example, &[], "")));
    }
}

/// Every finishing area is dressed and has a grinding program of its own, which is proven; roughing areas lie beside them.
#[test]
fn every_finishing_area_is_dressed_and_ground_with() {
    for (more, stock) in
        [("", ""), ("\nroughing_areas = 1\nroughing_ratio = 0.0", "roughing_stock_um = [60.0]")]
    {
        let method = format!("method = \"diagonal\"\nareas = 2{more}");
        let changes =
            [(GRID, COARSE), ("width = 100.0", "width = 280.0"), ("method = \"diagonal\"", method.as_str())];
        let loaded = job("twist-free-crowning", &changes, &format!("{stock}\n"));
        let outcome = planned(&loaded);
        proven(&outcome);
        assert!(outcome.result.verdict.is_accepted(), "{:?}", outcome.result.verdict);
        let programs = outcome.result.programs.as_ref().expect("programs");
        let grinding = |control: &str| {
            programs.programs.iter().filter(|p| p.job == "grinding" && p.control == control).count()
        };
        assert_eq!((grinding("siemens"), grinding("linuxcnc"), grinding("fanuc")), (2, 2, 2));
        assert!(programs.proofs.iter().all(|proof| proof.areas == 2));
        for flank in outcome.result.flanks.keys() {
            let of = |area: &str| {
                let found = programs.worm_use.iter().find(|one| one.flank == *flank && one.area == area);
                let found = found.unwrap_or_else(|| panic!("{area}: {:?}", programs.worm_use));
                assert!(found.area.starts_with("roughing") || found.file.contains("grinding-area-"));
                found.lines_mm
            };
            let [first, second] = ["finishing 1", "finishing 2"].map(of);
            assert!(first[1] < second[0] - 5.0, "{flank}: {first:?} {second:?}");
            if !more.is_empty() {
                assert!(of("roughing 1")[1] < first[0] + 1e-3);
            }
        }
        let texts = &outcome.programs.as_ref().expect("programs").built.programs;
        let heads = texts.iter().filter(|p| p.written.text.contains("FINISHING AREA 2 OF 2 OF THE WORM"));
        assert_eq!(heads.count(), 3);
    }
}

/// Least and largest height over the finished flank after each stroke in an area of its own, um, as the verdict has it.
fn heights(outcome: &Outcome) -> Vec<(String, [f64; 2])> {
    let verdict = serde_json::to_value(&outcome.result.verdict).expect("a verdict");
    let judged = verdict["scope"]["judged"].as_array().expect("items").clone();
    let text = |item: &serde_json::Value, key: &str| item[key].as_str().expect("a text").to_owned();
    let of_area =
        judged.iter().filter(|item| text(item, "item").ends_with("which has its own area of the worm"));
    of_area
        .map(|item| {
            let detail = text(item, "detail");
            let numbers: Vec<f64> = detail.split_whitespace().filter_map(|word| word.parse().ok()).collect();
            assert_eq!(numbers.len(), 2, "{detail}");
            (text(item, "item"), [numbers[0], numbers[1]])
        })
        .collect()
}

/// A job with two roughing strokes in areas of their own.
fn in_areas(strokes: &str) -> LoadedJob {
    job(
        "twist-free-crowning",
        &[
            (GRID, COARSE),
            ("width = 100.0", "width = 280.0"),
            (
                "diagonal_ratio = \"auto\"",
                "diagonal_ratio = -1.03979\nroughing_areas = 2\nroughing_ratio = -1.03979",
            ),
        ],
        &format!(
            "\n[stock]\nallowance_um = 120.0\n\n[technology]\nstrokes = [{strokes}, {{ left_um = 0.0 }}]"
        ),
    )
}

/// With the whole modification and the ratio of the plan a roughing area leaves its stock everywhere; with half of it more where the plan takes
/// more off, and with a ratio of its own some twist.
#[test]
fn a_roughing_area_makes_its_share_of_the_modification() {
    let crowning = |outcome: &Outcome| 20.0 * outcome.prepared.setup.lines.left.cos_b2;
    let outcome = planned(&in_areas(
        "{ left_um = 60.0, modification_share = 0.5, shift = { ratio = -0.7 } }, { left_um = 20.0, modification_share = 1.0 }",
    ));
    proven(&outcome);
    let found = heights(&outcome);
    assert_eq!(found.len(), 4, "{found:?}");
    for (item, [least, most]) in &found {
        if item.contains("stroke 1") {
            assert!(*least > 54.0 && *least < 66.0, "{item}: {least}");
            assert!(
                *most > 60.0 + 0.4 * crowning(&outcome) && *most < 60.0 + 1.5 * crowning(&outcome),
                "{item}: {most}"
            );
        } else {
            assert!((least - 20.0).abs() < 0.4 && (most - 20.0).abs() < 0.4, "{item}: {least} {most}");
        }
    }
    let programs = outcome.result.programs.as_ref().expect("programs");
    for area in ["roughing 1", "roughing 2", "finishing 1"] {
        assert!(programs.worm_use.iter().any(|used| used.area == area), "{area}");
    }
}

/// More than the whole modification goes below the finished flank, which the rays find.
#[test]
fn a_roughing_area_with_too_much_of_it_is_no_good() {
    let loaded = in_areas("{ left_um = 60.0 }, { left_um = 5.0, modification_share = 1.8 }");
    let outcome = planned(&loaded);
    let verdict = serde_json::to_string(&outcome.result.verdict).expect("a verdict");
    assert!(verdict.contains("roughing-below-finished"), "{verdict}");
    assert!(!outcome.result.verdict.is_accepted());
}
