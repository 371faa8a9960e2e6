//! A folder of measured parts as a series: every part counts once, figures are those of single evaluations, a bad file stops no other,
//! and the files say the same on any number of threads.

use crate::measured_parts::{MadePart, noise};
use foundation::geometry::Sides;
use inspection::workflow::series::{
    InspectionSeries, SeriesCharacteristic, SeriesOptions, inspect_series, measured_parts_in, series_summary,
    write_inspection_series,
};
use inspection::workflow::{SheetOptions, Statements, inspect_gear};
use run::RunFailure;
use std::path::{Path, PathBuf};
use tempfile::TempDir;
use verdict::Status;

fn options(class: i32) -> SeriesOptions {
    let sheet = SheetOptions { tolerance_class: Some(class), ..SheetOptions::default() };
    SeriesOptions { sheet, ..SeriesOptions::default() }
}

/// The k-th part of a series: measured later than those before, its helix slope drifting.
fn part(k: u32, drift: f64) -> MadePart {
    let mut part = MadePart::new(&format!("part {k}"), 7 + u64::from(k));
    part.time = format!("{:02}:{:02}:00   /   09:00:00", 6 + k / 60, k % 60);
    let own = |n: u64| 0.4 * noise(99, 10 * u64::from(k) + n);
    part.profile_slope = Sides { left: 1.0 + own(1), right: -0.5 + own(2) };
    part.helix_slope = Sides { left: 0.5 + drift * f64::from(k) + own(3), right: 0.5 + own(4) };
    part
}

struct Folder(TempDir);

impl Folder {
    /// Parts in files whose names do not follow their times.
    fn of(parts: impl IntoIterator<Item = MadePart>) -> Self {
        let folder = Self(tempfile::tempdir().expect("a directory"));
        for (k, part) in parts.into_iter().enumerate() {
            folder.file(&format!("{:02}.mka", (7 * k + 3) % 41), &part.text());
        }
        folder
    }

    fn file(&self, name: &str, text: &str) {
        std::fs::write(self.path().join(name), text).expect("a file");
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    fn series(&self, class: i32) -> InspectionSeries {
        inspect_series(&measured_parts_in(self.path()).expect("parts").parts, &options(class))
            .expect("a series")
    }
}

fn of<'a>(series: &'a InspectionSeries, key: &str) -> &'a SeriesCharacteristic {
    let all = series.result.groups.iter().flat_map(|group| &group.characteristics);
    all.into_iter().find(|of| of.key == key).unwrap_or_else(|| panic!("{key}"))
}

#[test]
fn figures_are_those_of_the_single_parts_in_the_order_of_time() {
    let folder = Folder::of((0..12).map(|k| part(k, 0.0)));
    let series = folder.series(7);
    assert_eq!((series.result.verdict.status(), series.result.refused.len()), (Status::Met, 0));
    let [group] = &series.result.groups[..] else { panic!("one group") };
    assert_eq!((group.series.as_str(), group.ordered_by, group.parts.len()), ("Z-17", "time", 12));
    let names: Vec<&str> = group.parts.iter().map(|part| part.part.as_str()).collect();
    assert_eq!(names, (0..12).map(|k| format!("part {k}")).collect::<Vec<_>>());
    assert_eq!(group.parts[1].time.as_deref(), Some("2026-02-01T06:01:00"));
    // Each value is that of the part by itself.
    let single: Vec<_> = group
        .parts
        .iter()
        .map(|part| {
            inspect_gear(&folder.path().join(&part.file), &Statements::default(), None).expect("a part")
        })
        .collect();
    let close = |key: &str, want: Vec<f64>| {
        let found = of(&series, key);
        assert_eq!(found.values, want, "{key}");
        let n = want.len() as f64;
        let mean = want.iter().sum::<f64>() / n;
        let s = (want.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
        let figures = found.figures.as_ref().expect("figures");
        assert!((figures.mean - mean).abs() < 1e-12 && (figures.s - s).abs() < 1e-12, "{key}");
        // t of 11 degrees of freedom: 2.200985.
        let half = 2.200_985_16 * s / n.sqrt();
        assert!((figures.mean_interval_95[1] - mean - half).abs() < 1e-7, "{key}");
        (mean, s)
    };
    let slopes = single.iter().map(|found| {
        let rows = &found.result.summary;
        let row = rows.iter().find(|r| (r.kind, r.flank, r.characteristic) == ("helix", "right", "fH"));
        row.expect("a slope").mean_um
    });
    let (mean, s) = close("fHb.right.mean", slopes.collect());
    let largest = single.iter().map(|found| {
        let of_line = found.result.traces.iter().filter(|t| (t.kind, t.flank) == ("profile", "left"));
        of_line.map(|t| t.form_um).fold(0.0, f64::max)
    });
    close("ffa.left.max", largest.collect());
    close("Fp.left.single", single.iter().map(|found| found.result.pitch["left"].total_um).collect());
    // fHb of class 7 for d 46, b 20: 2 (0.05 sqrt 46 + 0.35 sqrt 20 + 4) = 11.8 -> 12 um, both sides.
    let slope = of(&series, "fHb.right.mean");
    assert_eq!((slope.lower_limit, slope.upper_limit), (Some(-12.0), Some(12.0)));
    let capability = slope.figures.as_ref().and_then(|f| f.capability.as_ref()).expect("a capability");
    assert!((capability.cp.expect("two limits") - 4.0 / s).abs() < 1e-9);
    assert!((capability.cpk - (12.0 - mean.abs()) / (3.0 * s)).abs() < 1e-9);
    let total = of(&series, "Fb.right.max");
    assert_eq!((total.lower_limit, total.upper_limit.is_some()), (None, true));
    let capability = total.figures.as_ref().and_then(|f| f.capability.as_ref()).expect("a capability");
    assert!(capability.cp.is_none() && capability.one_sided && capability.cpk > 0.0);
    assert!(total.remarks.iter().any(|remark| remark.contains("12 parts only")), "{:?}", total.remarks);
}

#[test]
fn a_drift_is_found_and_only_where_it_is() {
    let series = Folder::of((0..30).map(|k| part(k, 0.1))).series(7);
    let trend = |key: &str| of(&series, key).figures.as_ref().and_then(|f| f.trend).expect("a trend");
    let left = trend("fHb.left.mean");
    // The reference length is the face width: 20/18 of the drift over the range.
    assert!(left.interval_95[0] < 0.111 && left.interval_95[1] > 0.111, "{left:?}");
    assert!(left.p.expect("p") < 1e-8);
    assert!(trend("fHb.right.mean").p.expect("p") > 0.01);
    let found = &of(&series, "fHb.left.mean").figures.as_ref().expect("figures").special_causes;
    assert!(
        found.iter().any(|found| found.rule == "one-side" && found.meaning.contains("Nelson")),
        "{found:?}"
    );
    assert!(of(&series, "fHb.left.mean").remarks.iter().any(|remark| remark.contains("drift by")));
    assert!(series_summary(&series).contains("fHb.left.mean"));
}

#[test]
fn a_refused_file_is_told_and_stops_no_other() {
    let folder = Folder::of((0..3).map(|k| part(k, 0.0)));
    folder.file("broken.mka", "HEADER KS.MK.FILE\r\n");
    folder.file("nothing.mew", "");
    folder.file("text.rexs", "<model>");
    let series = folder.series(7);
    let refused: Vec<&str> = series.result.refused.iter().map(|file| file.file.as_str()).collect();
    assert_eq!(refused, ["broken.mka", "nothing.mew", "text.rexs"]);
    for file in &series.result.refused {
        assert!(!file.code.is_empty() && !file.message.is_empty() && !file.way_out.is_empty(), "{file:?}");
    }
    assert_eq!(series.result.groups[0].parts.len(), 3);
    assert!(series_summary(&series).contains("refused: broken.mka"));
    // Nothing but bad files: a series without parts, still written.
    let bad = Folder::of([]);
    bad.file("broken.mka", "no measurement");
    let series = bad.series(7);
    assert!(series.result.groups.is_empty() && series.result.refused.len() == 1);
    let out = tempfile::tempdir().expect("a directory");
    assert_eq!(write_inspection_series(&series, out.path()).expect("files").len(), 3);
}

#[test]
fn drawings_are_kept_apart_and_missing_values_are_no_zeros() {
    let mut parts: Vec<MadePart> = (0..6).map(|k| part(k, 0.0)).collect();
    parts[1].pitch = false;
    parts[1].positions = false;
    parts[4].traced = Vec::new();
    parts[5].drawing = "Z-18".into();
    parts[5].teeth = 31;
    let series = Folder::of(parts).series(5);
    let [first, second] = &series.result.groups[..] else { panic!("two groups") };
    assert_eq!((first.parts.len(), second.parts.len(), second.series.as_str()), (5, 1, "Z-18"));
    assert_eq!(of(&series, "Fp.left.single").parts, [1, 3, 4, 5]);
    assert_eq!(of(&series, "fHa.left.mean").parts, [1, 2, 3, 4]);
    // One part has values and no statistics, and says why.
    for single in &second.characteristics {
        assert!(single.n == 1 && single.figures.is_none());
        assert!(single.remarks.iter().any(|remark| remark.contains("at least 2 are needed")));
    }
}

#[test]
fn equal_parts_have_no_capability_and_no_nan() {
    let twin = |name: &str| MadePart { name: name.into(), ..part(1, 0.0) };
    let series = Folder::of(["a", "b", "c", "d"].map(twin)).series(6);
    let slope = of(&series, "fHa.left.mean");
    let figures = slope.figures.as_ref().expect("figures");
    assert_eq!((figures.s, figures.sigma_mr, figures.range), (0.0, 0.0, 0.0));
    assert!(figures.capability.is_none() && slope.remarks.iter().any(|r| r.contains("all parts are equal")));
    let out = tempfile::tempdir().expect("a directory");
    write_inspection_series(&series, out.path()).expect("files");
    let text = std::fs::read_to_string(out.path().join("series.json")).expect("text");
    assert!(!text.contains("NaN") && !text.contains("null"), "no number that is none");
}

#[test]
fn files_of_a_series_hold_together() {
    let folder = Folder::of((0..9).map(|k| part(k, 0.0)));
    folder.file("broken.mka", "HEADER KS.MK.FILE\r\n");
    let paths = measured_parts_in(folder.path()).expect("parts").parts;
    let write = |threads: usize, paths: &[PathBuf]| {
        let pool = rayon_pool(threads);
        let out = tempfile::tempdir().expect("a directory");
        let written = pool.install(|| {
            let series = inspect_series(paths, &options(5)).expect("a series");
            write_inspection_series(&series, out.path()).expect("files")
        });
        let read = |path: &PathBuf| {
            let name = path.strip_prefix(out.path()).expect("below").to_string_lossy().into_owned();
            (name, std::fs::read_to_string(path).expect("a text"))
        };
        written.iter().map(read).collect::<Vec<(String, String)>>()
    };
    let one = write(1, &paths);
    assert!(one == write(3, &paths), "other files on other threads");
    let names: Vec<&str> = one.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(
        (names.len(), &names[..2], names[11]),
        (12, &["series.json", "series.csv"][..], "series.html")
    );
    let text = |name: &str| &one.iter().find(|(known, _)| known == name).expect(name).1;
    let page = text("series.html");
    for name in &names[2..11] {
        assert!(page.contains(&format!("<a href=\"{name}\">")), "{name}");
        assert!(text(name).contains("Inspection sheet"));
    }
    assert!(page.contains("broken.mka: not evaluated") && page.contains("Cpk"));
    let charts = page.matches("<figure ").count();
    let document: serde_json::Value = serde_json::from_str(text("series.json")).expect("JSON");
    let all = document["groups"][0]["characteristics"].as_array().expect("characteristics").clone();
    assert_eq!(charts, all.len());
    // A row of the table for every value of the document.
    let values: usize = all.iter().map(|of| of["values"].as_array().map_or(0, Vec::len)).sum();
    assert_eq!(text("series.csv").lines().count(), values + 1);
    let keys: std::collections::BTreeSet<&str> = all.iter().filter_map(|of| of["key"].as_str()).collect();
    assert_eq!(keys.len(), all.len());
    for key in ["fHa.left.mean", "fHa.right.range", "Fb.left.max", "fp.right.single", "Rs.single"] {
        assert!(keys.contains(key), "{key}: {keys:?}");
    }
}

fn rayon_pool(threads: usize) -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads")
}

#[test]
fn a_wrong_class_and_no_file_are_refused() {
    let folder = Folder::of([part(0, 0.0)]);
    let paths = measured_parts_in(folder.path()).expect("parts").parts;
    for (paths, class) in [(&paths[..], 0), (&paths[..], 12), (&[][..], 5)] {
        let RunFailure::BadInput(finding) = inspect_series(paths, &options(class)).expect_err("refused")
        else {
            panic!("bad input");
        };
        assert!(finding.field.is_some() && finding.way_out.is_some(), "{finding:?}");
    }
    let without = SeriesOptions { without_sheets: true, ..options(5) };
    assert!(inspect_series(&paths, &without).expect("a series").sheets.is_empty());
}

/// The parts lie beside the repository, if at all.
#[test]
fn real_parts_make_a_series_each() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/measurements");
    if !folder.is_dir() {
        eprintln!("not run: {} is not there", folder.display());
        return;
    }
    let series =
        inspect_series(&measured_parts_in(&folder).expect("parts").parts, &options(7)).expect("a series");
    assert_eq!((series.result.groups.len(), series.result.refused.len(), series.sheets.len()), (2, 0, 2));
    let times: Vec<_> = series.result.groups.iter().map(|group| group.parts[0].time.as_deref()).collect();
    assert!(times.iter().all(Option::is_some), "{times:?}");
}
