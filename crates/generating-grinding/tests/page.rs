//! The report of a run: complete, self-contained, repeatable, and as wide as what was made.

use foundation::numerics::Silent;
use generating_grinding::job::LoadedJob;
use generating_grinding::page::html_page;
use generating_grinding::workflow::{Outcome, plan_job};
use job::read_job_of;
use job::tables::{Flanks, Program};
use report::charts::ChartError;
use std::path::PathBuf;

/// An example on a coarse grid.
fn load(name: &str) -> LoadedJob {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    let mut loaded: LoadedJob = read_job_of(&path).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (5, 5);
    loaded
}

fn run(loaded: &LoadedJob) -> Outcome {
    plan_job(loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}"))
}

fn page(outcome: &Outcome) -> String {
    html_page(outcome, &[("result.json".into(), "all figures of this report")]).unwrap()
}

fn assert_holds(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "\"{part}\" is missing");
    }
}

#[test]
fn the_page_is_complete_and_self_contained() {
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.output.programs = vec![Program::Linuxcnc, Program::Siemens];
    loaded.job.job.name = "shaft <7>".into();
    let outcome = run(&loaded);
    let page = page(&outcome);
    for heading in [
        "Result per flank",
        "Values of the drawing",
        "Scope of the verdict",
        "Gear and tools",
        "Settings",
        "Topographies",
        "Profile and helix",
        "Grinding motion",
        "Dressing corrections",
        "NC programs",
        "Files",
        "Choice of the diagonal ratio",
        "How it was verified",
        "Convergence of the precompensation",
    ] {
        assert!(page.contains(&format!("<h2>{heading}</h2>")), "{heading}");
    }
    // How values were found stands behind what they are.
    let at = |text: &str| page.find(text).unwrap_or_else(|| panic!("{text}"));
    assert!(
        at("<h2>Files</h2>") < at(">Appendix</p>")
            && at(">Appendix</p>") < at("<h2>How it was verified</h2>")
    );
    let ratio = outcome.execution.ratio;
    let ratio = report::charts::format_significant(ratio, 6);
    assert_holds(
        &page,
        &[
            "shaft &lt;7&gt;",
            "within the tolerance of",
            &format!("Diagonal ratio K = {ratio}."),
            "Diagonal ratios compared",
            "C<sub>β</sub>",
            "result.json",
            "@media print",
            "Proven from the program text",
            "Axes that move in grinding",
            "Passes of grinding: linuxcnc",
            "worm against workpiece",
        ],
    );
    // Every proof stands with its sentence, every program with its file.
    let programs = outcome.programs.as_ref().unwrap();
    assert!(!programs.result.proofs.is_empty() && programs.result.programs.len() > 2);
    for program in &programs.result.programs {
        assert!(page.contains(&program.file), "{}", program.file);
    }
    // Nothing is fetched: no script, no link, no image, no address but the name of the SVG namespace.
    for foreign in ["<script", "<link", "<img", "url(", "@import", "src=", "href="] {
        assert!(!page.contains(foreign), "{foreign}");
    }
    assert_eq!(page.matches("http").count(), page.matches("http://www.w3.org/2000/svg").count());
    assert_eq!(page, self::page(&outcome), "not the same bytes twice");
}

/// The lists of the first page: name and value.
fn first_page(page: &str) -> Vec<(String, String)> {
    let (_, lists) = page.split_once("<div class=\"lists\">").expect("lists");
    let (lists, _) = lists.split_once("<h2>").expect("details");
    let plain = |text: &str| {
        let mut plain = String::new();
        let mut tag = false;
        for c in text.chars() {
            match c {
                '<' => tag = true,
                '>' => tag = false,
                c if !tag => plain.push(c),
                _ => {}
            }
        }
        plain
    };
    let row = |row: &str| {
        let (name, value) = row.split_once("</th><td>")?;
        let (value, _) = value.split_once("</td>")?;
        Some((plain(&format!("<{name}")), plain(value)))
    };
    lists.split("<tr><th scope=\"row\"").skip(1).filter_map(row).collect()
}

#[test]
fn the_first_page_has_what_the_operator_sets() {
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.output.programs = vec![Program::Siemens];
    loaded.job.job.part_number = Some("A <1>".into());
    let outcome = run(&loaded);
    let page = page(&outcome);
    let lists = first_page(&page);
    let value = |name: &str| {
        let found = lists.iter().find(|(of, _)| of.trim_start_matches('>').starts_with(name));
        found.unwrap_or_else(|| panic!("{name} in {lists:?}")).1.clone()
    };
    // The head stands beside a right angle by what the programs leave on its axis.
    let settings = &outcome.result.settings;
    let beside = settings.crossed_axes_angle_deg.abs() - 90.0;
    let swivel: f64 =
        value("head swivel angle, axis A1").replace('−', "-").trim_end_matches('°').parse().unwrap();
    assert!((swivel.abs() - beside.abs()).abs() < 1e-4, "{swivel} {beside}");
    // The cutting speed is that of the largest worm, the speeds of worm and workpiece follow the threads and teeth.
    let number = |name: &str| -> f64 { value(name).split(' ').next().unwrap().parse().unwrap() };
    let radius = outcome.prepared.setup.largest_tip_radius;
    let wanted = number("worm speed n") * std::f64::consts::TAU / 60.0 * radius * 1e-3;
    assert!((number("cutting speed") - wanted).abs() < 0.1, "{wanted}");
    let threads = f64::from(loaded.job.worm.threads) / f64::from(loaded.job.gear.teeth);
    assert!((number("workpiece speed") - number("worm speed n") * threads).abs() < 0.2);
    assert!((number("axial feed rate") - number("axial feed per") * number("workpiece speed")).abs() < 0.2);
    // Without stock nothing is said of before.
    assert!(
        page.contains("Before machining: not known")
            && !lists.iter().any(|(name, _)| name.contains("before"))
    );
    assert!(page.contains("@bottom-left { content: \"A \\3c 1\\3e  · twist-free-crowning\"; }"));
    loaded.job.machine = None;
    let page = self::page(&run(&loaded));
    assert_holds(
        &page,
        &[
            "Speeds: not given, the job names no machine.",
            "head swivel angle, amount",
            "Not known: no programs",
        ],
    );
}

#[test]
fn stock_shows_in_the_measures_before() {
    let mut loaded = load("cycles/planet-gear.toml");
    loaded.job.machine = None;
    let outcome = run(&loaded);
    let lists = first_page(&page(&outcome));
    let value = |name: &str| -> f64 {
        let found =
            lists.iter().find(|(of, _)| of.contains(name)).unwrap_or_else(|| panic!("{name} in {lists:?}"));
        found.1.split(' ').next().unwrap().parse().unwrap()
    };
    // The base tangent meets both flanks along their normals.
    let allowance = 0.110 + 0.100;
    assert!((value("teeth, before") - value("teeth, finished") - allowance).abs() < 1.1e-3);
    assert!(value("mm, before") > value("mm, finished"));
    let thicker = value("thickness, before") - value("thickness, finished");
    assert!((thicker * 20f64.to_radians().cos() - allowance).abs() < 1.1e-3, "{thicker}");
}

#[test]
fn a_missed_target_is_said_with_its_figures_on_the_flanks_that_are_ground() {
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.machine = None;
    loaded.job.grinding.flanks = Flanks::Left;
    loaded.job.target.tolerance_um = 1e-5;
    let outcome = run(&loaded);
    let page = page(&outcome);
    let code = outcome.result.verdict.reason().unwrap().code;
    assert_holds(&page, &["banner missed", "outside the tolerance of", code, "Left flank"]);
    for absent in ["Right flank", "<h2>NC programs", "<h2>Gearbox and servo"] {
        assert!(!page.contains(absent), "{absent}");
    }
}

#[test]
fn numbers_that_are_none_make_no_page() {
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.machine = None;
    let mut outcome = run(&loaded);
    outcome.result.flanks.get_mut("left").unwrap().planned_um[2][1] = f64::NAN;
    assert!(matches!(html_page(&outcome, &[]), Err(ChartError::InvalidNumber { .. })));
    outcome.result.flanks.get_mut("left").unwrap().planned_um[2].pop();
    assert!(html_page(&outcome, &[]).is_err());
}
