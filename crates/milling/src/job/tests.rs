//! Jobs of five-axis milling as they are read: what stands in for absent keys, and which bodies and cutters there are.

use super::*;
use foundation::geometry::CutterShape;
use job::{JobError, Source, parse_job_of};

/// The template without comments.
pub(super) fn template() -> String {
    let text = MillingJob::TEMPLATE;
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or(line).trim_end());
    lines.filter(|line| !line.is_empty()).map(|line| line.to_owned() + "\n").collect()
}

/// The template with the table that a comment holds in place of [gear].
pub(super) fn with_body(table: &str) -> String {
    let text = MillingJob::TEMPLATE;
    let from = text.find(&format!("# [{table}]")).unwrap();
    let body = text[from..].split("\n\n").next().unwrap();
    let body: String = body.lines().map(|line| line.trim_start_matches("# ").to_owned() + "\n").collect();
    let job = template();
    let (begin, end) = (job.find("[gear]").unwrap(), job.find("[target]").unwrap());
    format!("{}{body}{}", &job[..begin], &job[end..])
}

/// Blades by lines.
pub(super) fn ruled() -> String {
    let text = with_body("blade");
    text.lines()
        .filter(|line| !line.starts_with("points") && !line.starts_with("naca"))
        .map(|line| line.to_owned() + "\n")
        .collect()
}

pub(super) fn read(text: &str) -> Result<MillingJob, JobError> {
    parse_job_of(Source::new("job.toml", text)).map(|loaded| loaded.job)
}

pub(super) fn sound(text: &str) -> MillingJob {
    read(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

#[test]
fn the_template_is_the_spur_gear_that_it_describes() {
    let job = sound(MillingJob::TEMPLATE);
    assert!(
        matches!(job.body(), Some(MilledBody::Gear(gear)) if gear.drawing.teeth == 20 && gear.double_helical.is_none())
    );
    assert_eq!(job.flanks(), [Flank::Left, Flank::Right]);
    assert_eq!(job.milling.grid(), GridChoice::Counts { rows: 14, columns: 21 });
    assert_eq!(job.milling.contact_height, Some(ContactHeight::Fixed(6.16)));
    assert_eq!(
        job.milling.root.map(|root| (root.depth(), root.bottom_pass)),
        Some((RootBottom::Height(0.0), true))
    );
    assert_eq!((job.milling.plunge_feed_mm_per_min, job.milling.feed_mm_per_min), (None, 1200.0));
    let body = job.cutter.body().unwrap();
    assert_eq!(*body.shape(), CutterShape::end_mill(3.0, 1.5));
    for purpose in [CutterUse::Finishing, CutterUse::Bottom, CutterUse::Roughing] {
        assert_eq!(job.cutter_for(purpose), (&job.cutter, 1));
    }
}

#[test]
fn what_the_template_calls_defaults_is_what_stands_in() {
    let job = sound(&template());
    let text = MillingJob::TEMPLATE;
    let defaults = [
        "cone_angle_deg",
        "row_spacing",
        "tilt_deg",
        "lead_angle_deg",
        "skew_deg",
        "safety_distance",
        "direction",
        "traverse",
        "order",
        "bottom_pass",
        "compare_orientation",
        "mount",
        "rtcp",
        "position_tolerance_um",
        "cl",
    ];
    for key in defaults {
        let line = text.lines().find(|line| line.starts_with(&format!("# {key} = "))).unwrap();
        assert_eq!(sound(&text.replacen(line, &line[2..], 1)), job, "{key}");
    }
    let plain = template().replace("rays_profile = 81\nrays_length = 61\n", "");
    assert_eq!(sound(&plain), job);
}

#[test]
fn what_is_behind_a_mark_is_valid_as_well() {
    let text = MillingJob::TEMPLATE;
    let start = text.find("\n[cutter]").unwrap();
    let others = ["half_angle_deg", "profile_radius", "largest_diameter_height", "ease_off"];
    let mut keys = 0;
    let mut table = "";
    for line in text[start..].lines() {
        table = if line.trim_start_matches("# ").starts_with('[') { line } else { table };
        let Some(entry) = line.strip_prefix("# ").filter(|_| table.starts_with('[')) else { continue };
        let Some((key, _)) = entry.split_once(" = ").filter(|(key, _)| !key.contains(' ')) else { continue };
        if others.contains(&key) {
            continue;
        }
        keys += 1;
        let changed = text.replacen(line, entry, 1);
        let changed = match key {
            "density" | "scallop_um" | "chord_um" => {
                changed.replace("\nrows = 14", "\n").replace("\ncolumns = 21", "\n")
            }
            "probe" => changed
                .replace("# work_offset = {", "work_offset = {")
                .replace("clocking = false }", "clocking = true }"),
            "straight" => changed.replace("\nbottom = 0.0", "\n"),
            _ => changed,
        };
        sound(&changed);
    }
    assert!(keys > 22, "{keys}");
    for table in ["# [bottom_cutter]", "# [roughing_cutter]\n# [milling.roughing]"] {
        let mut changed = text.to_owned();
        for name in table.lines() {
            let from = changed.find(name).unwrap();
            let block = changed[from..].split("\n\n").next().unwrap().to_owned();
            let plain: String =
                block.lines().map(|line| line.trim_start_matches("# ").to_owned() + "\n").collect();
            changed = changed.replace(&block, &plain);
        }
        let job = sound(&changed);
        let own = [CutterUse::Bottom, CutterUse::Roughing].map(|purpose| job.cutter_for(purpose).1);
        assert_eq!(own, if table.contains("bottom") { [2, 1] } else { [1, 3] });
    }
    for key in ["modifications", "normal_tooth_thickness", "span", "over_balls", "evaluation"] {
        let line = text
            .lines()
            .find(|line| line.starts_with(&format!("# {key} = ")) && !line.contains("over its own flank"))
            .unwrap();
        let removed =
            if ["modifications", "evaluation"].contains(&key) { "\nnone" } else { "\nprofile_shift = 0.0" };
        sound(&text.replacen(line, &line[2..], 1).replace(removed, "\n"));
    }
}

#[test]
fn bevels_and_blades_are_read() {
    let job = sound(&with_body("bevel"));
    let Some(MilledBody::Bevel(bevel)) = job.body() else { panic!("{job:?}") };
    assert!((bevel.outer_cone_distance() - 95.2).abs() < 0.1, "{}", bevel.outer_cone_distance());
    let [root, tip] = bevel.cone_angles_deg();
    assert!(
        (bevel.pitch_cone_angle_deg - root - 3.756).abs() < 0.01
            && (tip - bevel.pitch_cone_angle_deg - 3.006).abs() < 0.01
    );
    let eased =
        with_body("bevel").replace("[cutter]", "ease_off = { lengthwise_um = 10, bias_um = -2 }\n[cutter]");
    let ease = sound(&eased).target.ease_off.unwrap();
    assert_eq!((ease.lengthwise_um, ease.profile_um, ease.bias_um), (10.0, 0.0, -2.0));

    let job = sound(&ruled());
    assert_eq!(job.flanks(), [Flank::Left]);
    let right = sound(&ruled().replace("side = \"left\"", "side = \"right\""));
    assert_eq!(right.flanks(), [Flank::Right]);
    let points = with_body("blade");
    let without = |keys: [&str; 2]| -> String {
        let lines = points.lines().filter(|line| !keys.iter().any(|key| line.starts_with(key)));
        lines.map(|line| line.to_owned() + "\n").collect()
    };
    let naca = without(["ruled", "points"]).replace("thickness = [4.0, 2.0]", "");
    assert_eq!(sound(&naca).flanks(), [Flank::Right]);
    assert_eq!(sound(&naca.replace("\"upper\"", "\"lower\"")).flanks(), [Flank::Left]);
    let job = sound(&without(["ruled", "naca"]));
    assert_eq!(
        job.blade.and_then(|blade| blade.points).map(|points| (points.rows, points.columns)),
        Some((9, 9))
    );
}

#[test]
fn double_helical_gears_and_cutters_of_all_shapes_are_read() {
    let halves =
        template().replace("helix_angle_deg = 0.0", "helix_angle_deg = 30.0\ndouble_helical = { gap = 4.0 }");
    assert_eq!(sound(&halves).gear.unwrap().double_helical, Some(DoubleHelical { apex: 0.0, gap: 4.0 }));
    let begin = "shape = \"end-mill\"\ndiameter = 6.0\ncorner_radius = 1.5\n";
    let without_root = template().replace("[milling.root]\nbottom = 0.0\n", "");
    let without_height = without_root.replace("contact_height = 6.16\n", "");
    let cases = [
        (
            &without_root,
            "shape = \"torus\"\ndiameter = 6\ncorner_radius = 2\n",
            CutterShape::end_mill(3.0, 2.0),
        ),
        (&without_height, "shape = \"ball\"\ndiameter = 6\n", CutterShape::ball(3.0)),
        (
            &without_root,
            "shape = \"cone\"\ndiameter = 6\nhalf_angle_deg = 3\n",
            CutterShape::Conical { radius: 3.0, half_angle: 3f64.to_radians(), corner_radius: 0.0 },
        ),
        (
            &without_height,
            "shape = \"drum\"\ndiameter = 6\nprofile_radius = 40\nlargest_diameter_height = 8\n",
            CutterShape::Barrel { radius: 3.0, height: 8.0, profile_radius: 40.0 },
        ),
    ];
    for (job, cutter, shape) in cases {
        let job = sound(&job.replace(begin, cutter));
        assert_eq!(job.cutter.cutting_part(), shape);
        assert!(job.cutter.body().is_ok());
    }
}

#[test]
fn a_job_has_one_workpiece() {
    let job = template();
    let (begin, end) = (job.find("[gear]").unwrap(), job.find("[target]").unwrap());
    let error = read(&format!("{}{}", &job[..begin], &job[end..])).unwrap_err();
    assert_eq!(
        (error.diagnostics[0].code, error.diagnostics[0].field.as_deref()),
        ("missing-key", Some("gear"))
    );
    assert!(error.to_string().contains("[blade]"), "{error}");
    let both = with_body("bevel") + &job[begin..end];
    let error = read(&both).unwrap_err();
    assert_eq!(
        (error.diagnostics[0].code, error.diagnostics[0].field.as_deref()),
        ("invalid-job", Some("bevel"))
    );
}
