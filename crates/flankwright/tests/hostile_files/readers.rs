//! The readers, each with a small file that it takes.

use std::path::Path;

use flankwright::exchange::catalogue::{read_catalogue, read_catalogue_tables};
use flankwright::exchange::inspection::{
    GridSize, InspectionError, MeasuredTable, inspection_of, read_grid_table, read_klingelnberg,
    read_measured_table,
};
use flankwright::exchange::machine::read_machine;
use flankwright::exchange::milling_job::{BladePoints, BladeSide, read_point_grid};
use flankwright::exchange::rexs::{RexsError, gear_ids, gear_of, read_rexs};
use flankwright::exchange::skiving_history::read_history;
use flankwright::exchange::{
    JobError, job_template, read_any_job, read_grid_target, read_measured_worm, read_points,
    read_probe_values, read_profile, read_reference_train, read_skiving_readings, read_stock,
    read_tolerances, read_traces,
};
use verify::{VerifyError, VerifyOptions, verify_file};

/// An error as a user gets it.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    pub code: String,
    pub message: String,
    pub way_out: String,
}

/// What a reader makes of a file: how much of it is in the content (samples, rows, findings), or an error.
pub type Answer = Result<usize, Told>;

/// A reader of files.
pub struct Reader {
    /// Its name in messages.
    pub name: &'static str,
    /// Ending of its files.
    pub ending: &'static str,
    /// A file that it takes.
    pub sample: Vec<u8>,
    /// Reads a file.
    pub read: fn(&Path) -> Answer,
}

/// Tracks of the sample of readings.
const TRACKS: usize = 5;

fn told(code: &str, message: String, way_out: &str) -> Told {
    Told { code: code.into(), message, way_out: way_out.into() }
}

impl From<JobError> for Told {
    fn from(error: JobError) -> Self {
        let first = &error.diagnostics[0];
        told(first.code, error.to_string(), first.way_out.as_deref().unwrap_or_default())
    }
}

impl From<InspectionError> for Told {
    fn from(error: InspectionError) -> Self {
        told(error.code(), error.to_string(), &error.way_out())
    }
}

impl From<RexsError> for Told {
    fn from(error: RexsError) -> Self {
        told(error.code(), error.to_string(), &error.way_out())
    }
}

impl From<VerifyError> for Told {
    fn from(error: VerifyError) -> Self {
        told(error.code(), error.to_string(), &error.way_out())
    }
}

fn job(path: &Path) -> Answer {
    Ok(read_any_job(path).map(|_| 1)?)
}

fn rexs(path: &Path) -> Answer {
    let document = read_rexs(path)?;
    for id in gear_ids(&document) {
        gear_of(&document, id)?;
    }
    Ok(gear_ids(&document).len())
}

fn klingelnberg(path: &Path) -> Answer {
    let file = read_klingelnberg(path)?;
    let whole = inspection_of(&[("part", &file)])?;
    let samples = whole.traces.iter().map(|trace| trace.f_um.len()).sum::<usize>();
    Ok(samples + whole.results.len() + whole.warnings.len() + file.unknown_lines.len())
}

fn measured(path: &Path) -> Answer {
    Ok(match read_measured_table(path)? {
        MeasuredTable::Traces(traces) => traces.iter().map(|trace| trace.f_um.len()).sum(),
        MeasuredTable::Fields(fields) => fields.iter().map(|field| field.f_um.len()).sum(),
    })
}

fn blade(path: &Path) -> Answer {
    let wanted = BladePoints { file: "points.csv".into(), rows: 4, columns: 4, side: BladeSide::Left };
    Ok(read_point_grid(path, &wanted)?.points.iter().map(Vec::len).sum())
}

/// Worms and dressers in files of one name.
fn catalogue_tables(path: &Path) -> Answer {
    let found = read_catalogue_tables(path, &seed("examples/catalogue/dressers.csv"))?;
    Ok(found.catalogue.worm.len())
}

fn grid(count: u32, value: &str) -> Vec<u8> {
    let rows = (0..count).flat_map(|w| (0..4).map(move |z| format!("{w}.25,{z}.5,{}.75\n", 1 + w + z)));
    format!("w_mm,z_mm,{value}\n{}", rows.collect::<String>()).into_bytes()
}

/// A path of the repository.
pub fn seed(path: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

fn file(path: &str) -> Vec<u8> {
    std::fs::read(seed(path)).unwrap()
}

/// All readers of files.
pub fn all() -> Vec<Reader> {
    let gearbox = job_template("electronic-gearbox").expect("a template").as_bytes().to_vec();
    let reader = |name, ending, sample, read| Reader { name, ending, sample, read };
    vec![
        reader("a job", "toml", gearbox, job),
        reader("a job of inspection", "json", file("fuzz/seeds/job/inspection.json"), job),
        reader("a machine", "toml", file("machines/five-axis-ac-table.toml"), |path| {
            Ok(read_machine(path).map(|_| 1)?)
        }),
        reader("a catalogue", "toml", file("examples/catalogue/bodies.toml"), |path| {
            Ok(read_catalogue(path)?.catalogue.worm.len())
        }),
        reader("tables of a catalogue", "csv", file("examples/catalogue/worms.csv"), catalogue_tables),
        reader("a grid", "csv", grid(4, "f_um"), |path| Ok(read_grid_target(path)?.w_mm.len() * 4)),
        reader("traces of a target", "csv", grid(2, "f_um"), |path| Ok(read_traces(path)?.w_mm.len() * 4)),
        reader(
            "tolerances",
            "csv",
            grid(3, "tolerance_um"),
            |path| Ok(read_tolerances(path)?.w_mm.len() * 4),
        ),
        reader("scattered points", "csv", grid(4, "f_um"), |path| Ok(read_points(path)?.len())),
        reader("measured profile", "csv", file("fuzz/seeds/table/profile.csv"), |path| {
            Ok(read_profile(path)?.len())
        }),
        reader("points of a blade", "csv", file("fuzz/seeds/table/blade.csv"), blade),
        reader("measured traces", "csv", file("fuzz/seeds/measured_table/traces.csv"), measured),
        reader("measured fields", "csv", file("fuzz/seeds/measured_table/fields.csv"), measured),
        reader("measured grid", "csv", file("fuzz/seeds/measured_table/grid.csv"), |path| {
            Ok(read_grid_table(path, GridSize { teeth: 16, rows: 5, columns: 9 })?.len())
        }),
        reader("readings", "csv", file("fuzz/seeds/table/readings.csv"), |path| {
            Ok(read_skiving_readings(path, TRACKS)?.len())
        }),
        reader("values of a probe", "csv", file("fuzz/seeds/table/probe.csv"), |path| {
            Ok(read_probe_values(path)?.len())
        }),
        reader("stock", "csv", file("fuzz/seeds/table/stock.csv"), |path| {
            Ok(read_stock(path, 3)?.flanks.iter().flat_map(|(_, map)| map).map(|map| map.spaces()).sum())
        }),
        reader("a measured worm", "csv", file("fuzz/seeds/table/worm.csv"), |path| {
            let points = read_measured_worm(path)?;
            Ok(points.left.len() + points.right.len())
        }),
        reader("reference pulses", "csv", file("fuzz/seeds/table/train.csv"), |path| {
            Ok(read_reference_train(path)?.references().len())
        }),
        reader("a history", "jsonl", file("fuzz/seeds/history/two.jsonl"), |path| {
            Ok(read_history(path)?.records().len())
        }),
        reader("curves", "mka", file("fuzz/seeds/klingelnberg/curves.mka"), klingelnberg),
        reader("values", "mew", file("fuzz/seeds/klingelnberg/values.mew"), klingelnberg),
        reader("REXS as XML", "rexs", file("fuzz/seeds/rexs_xml/crowning.rexs"), rexs),
        reader("REXS as JSON", "rexsj", file("fuzz/seeds/rexs_json/slope.rexsj"), rexs),
        reader("packed REXS", "rexsz", file("fuzz/seeds/rexs_packed/xml.rexsz"), rexs),
        reader("a reference file", "json", file("tests/reference/26-machine-chains.json"), |path| {
            Ok(verify_file(path, &VerifyOptions::default()).map(|_| 1)?)
        }),
    ]
}

impl Reader {
    /// Reads bytes as a file; an error is told in full.
    pub fn take(&self, bytes: &[u8]) -> Answer {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join(format!("file.{}", self.ending));
        std::fs::write(&path, bytes).unwrap();
        self.answer(&path)
    }

    /// What the reader says of a path; an error is told in full.
    pub fn answer(&self, path: &Path) -> Answer {
        (self.read)(path).inspect_err(|error| {
            assert!(
                error.code.bytes().all(|b| b.is_ascii_lowercase() || b == b'-'),
                "{}: {error:?}",
                self.name
            );
            assert!(!error.code.is_empty() && !error.message.is_empty(), "{}: {error:?}", self.name);
            assert!(!error.way_out.is_empty(), "{}: {error:?}", self.name);
        })
    }

    /// Whether the files are text of lines, and not one document or a package.
    pub fn of_rows(&self) -> bool {
        self.ending == "csv"
    }
}
