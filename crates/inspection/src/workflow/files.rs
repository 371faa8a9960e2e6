//! What a measurement is read from: Klingelnberg files, REXS, tables. One inspection comes out, with everything that was not understood.

mod rexs;

use super::drawn::DrawnGear;
use super::files_content::MeasuredFiles;
use super::middle::middle_line;
use super::readings::SAME_PLACE;
use super::result::LinesResult;
use super::statements::Statements;
use foundation::geometry::Flank;
use foundation::numerics::extremes;
use job::{Diagnostic, Problem, Source};
use measured_files::inspection::{
    InspectedGear, Inspection, InspectionError, InspectionWarning, KlingelnbergFile, MeasuredTable, Trace,
    TraceKind, WarningKind, inspection_of, parse_klingelnberg, parse_measured_table, read_klingelnberg,
};
use measured_files::rexs::{parse_rexs, read_rexs};
use run::{JobFailure, RunFailure};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Endings of curves and of values; the files of a part have one stem.
const KLINGELNBERG: [&str; 2] = ["mka", "mew"];
/// Endings of REXS files.
const REXS: [&str; 3] = ["rexs", "rexsj", "rexsz"];
/// Ending of tables.
const TABLE: &str = "csv";

/// Whether a file has the ending of a measurement.
pub fn is_measurement(path: &Path) -> bool {
    let ending = ending(path);
    KLINGELNBERG.iter().chain(&REXS).chain([&TABLE]).any(|known| *known == ending)
}

/// A file of a measurement that is at hand as bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeasurementFile {
    /// Its name, whose ending tells the form.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// Reads a measurement; of a Klingelnberg part also the file beside it that holds the curves to its values, or the values to its curves.
///
/// # Errors
/// [`JobFailure`]: a file of no known form, what its reader refuses, a table without `drawn`, statements that contradict the file.
pub fn read_measurement(
    path: &Path,
    drawn: Option<&DrawnGear>,
    statements: &Statements,
) -> Result<MeasuredFiles, JobFailure> {
    let found = match Form::of(path)? {
        Form::Klingelnberg => {
            let paths = files_of_measurement(path);
            let read = |path: &PathBuf| read_klingelnberg(path).map_err(|error| refused(path, &error));
            let files = paths.iter().map(read).collect::<Result<Vec<_>, _>>()?;
            klingelnberg(path, &paths, &files)?
        }
        Form::Rexs => rexs::measured(path, read_rexs(path), statements)?,
        Form::Table => table(path, Source::read(path)?, drawn, statements)?,
    };
    Ok(statements.apply(found))
}

/// What [`read_measurement`] reads, from bytes: the files of one part, of which the first tells the form.
///
/// # Errors
/// As there.
pub fn parse_measurement(
    files: &[MeasurementFile],
    drawn: Option<&DrawnGear>,
    statements: &Statements,
) -> Result<MeasuredFiles, JobFailure> {
    let paths: Vec<PathBuf> = files.iter().map(|file| PathBuf::from(&file.name)).collect();
    let (Some(path), Some(first)) = (paths.first(), files.first()) else {
        let finding = Diagnostic::new(Problem::MissingKey, "the measurement has no file")
            .field("FILE")
            .value("none")
            .allowed("one file, or curves and values of one part")
            .way_out("name the file of the measurement");
        return Err(RunFailure::bad_input(finding).into());
    };
    let found = match Form::of(path)? {
        Form::Klingelnberg => {
            let parse = |(path, file): (&PathBuf, &MeasurementFile)| {
                parse_klingelnberg(&file.bytes).map_err(|error| refused(path, &error))
            };
            let parsed = paths.iter().zip(files).map(parse).collect::<Result<Vec<_>, _>>()?;
            klingelnberg(path, &paths, &parsed)?
        }
        Form::Rexs => rexs::measured(path, parse_rexs(&first.bytes), statements)?,
        Form::Table => table(path, Source::from_bytes(&first.name, &first.bytes)?, drawn, statements)?,
    };
    Ok(statements.apply(found))
}

/// The form of a file, by its ending.
enum Form {
    Klingelnberg,
    Rexs,
    Table,
}

impl Form {
    fn of(path: &Path) -> Result<Self, RunFailure> {
        let ending = ending(path);
        if KLINGELNBERG.contains(&ending.as_str()) {
            return Ok(Self::Klingelnberg);
        }
        if REXS.contains(&ending.as_str()) {
            return Ok(Self::Rexs);
        }
        if ending == TABLE {
            return Ok(Self::Table);
        }
        let finding =
            Diagnostic::new(Problem::UnknownValue, "the ending of the file tells no form of measurement")
                .field("FILE")
                .value(path.display())
                .allowed(".mka, .mew, .rexs, .rexsj, .rexsz, .csv")
                .way_out("give the file the ending of its form");
        Err(RunFailure::bad_input(finding))
    }
}

fn ending(path: &Path) -> String {
    path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_lowercase()
}

/// The files that [`read_measurement`] reads for this one: itself, and of a Klingelnberg part the one of the same stem with the other
/// ending, if it is there.
pub fn files_of_measurement(path: &Path) -> Vec<PathBuf> {
    let own = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    if !KLINGELNBERG.contains(&own.to_lowercase().as_str()) {
        return vec![path.to_owned()];
    }
    let other = KLINGELNBERG.into_iter().find(|other| !other.eq_ignore_ascii_case(own));
    let beside = other.and_then(|other| {
        // Spelled as this one first, else as machines and file systems spell it.
        let mut spelled = [other.to_owned(), other.to_uppercase(), capital(other)];
        if own == own.to_uppercase() {
            spelled.swap(0, 1);
        }
        spelled.into_iter().map(|ending| path.with_extension(ending)).find(|path| path.is_file())
    });
    [Some(path.to_owned()), beside].into_iter().flatten().collect()
}

fn capital(word: &str) -> String {
    word.char_indices().map(|(k, c)| if k == 0 { c.to_ascii_uppercase() } else { c }).collect()
}

/// What a folder holds.
#[derive(Clone, Debug, Default)]
pub struct MeasuredFolder {
    /// Measurements that tell which gear was measured.
    pub measurements: BTreeSet<PathBuf>,
    /// What may be meant as one and is left out.
    pub left_out: Vec<LeftOutFile>,
}

/// Something in a folder that was not evaluated.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LeftOutFile {
    /// Its name.
    pub file: String,
    /// Why.
    pub reason: &'static str,
}

/// Files of a folder that are measurements and tell which gear was measured: no tables, none in folders below it. Files with other endings
/// are none of its business.
///
/// # Errors
/// Those of the file system.
pub fn measurements_in(folder: &Path) -> std::io::Result<MeasuredFolder> {
    let mut found = MeasuredFolder::default();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        // Results of this program are no parts that were forgotten.
        let made = path.extension().is_some_and(|ending| ending == "inspected" || ending == "out");
        let reason = if path.is_dir() && made {
            continue;
        } else if path.is_dir() {
            "subfolder skipped"
        } else if !is_measurement(&path) {
            continue;
        } else if ending(&path) == TABLE {
            "a table does not tell which gear was measured: inspect it with `--job`"
        } else if !path.is_file() {
            "it is no regular file"
        } else {
            found.measurements.insert(path);
            continue;
        };
        found.left_out.push(LeftOutFile { file: file_name(&path), reason });
    }
    found.left_out.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(found)
}

fn klingelnberg(
    path: &Path,
    paths: &[PathBuf],
    files: &[KlingelnbergFile],
) -> Result<MeasuredFiles, RunFailure> {
    let names: Vec<String> = paths.iter().map(|path| file_name(path)).collect();
    let named: Vec<(&str, &KlingelnbergFile)> = names.iter().map(String::as_str).zip(files).collect();
    let inspection = inspection_of(&named).map_err(|error| refused(path, &error))?;
    let not_understood = named.iter().flat_map(|(name, file)| {
        let line = |unknown: &measured_files::inspection::UnknownLine| LinesResult {
            file: (*name).into(),
            line: unknown.line,
            text: unknown.text.clone(),
        };
        file.unknown_lines.iter().map(line).collect::<Vec<_>>()
    });
    let not_understood = not_understood.collect();
    Ok(MeasuredFiles { not_understood, ..MeasuredFiles::new(inspection) })
}

/// An error of a file of measurements.
pub(super) fn refused(path: &Path, error: &InspectionError) -> RunFailure {
    let message = match error {
        InspectionError::Unreadable { .. } => error.to_string(),
        _ => format!("{}: {error}", path.display()),
    };
    RunFailure::bad_input(Diagnostic::with_code(error.code(), message).way_out(error.way_out()))
}

fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| "part".into(), |name| name.to_string_lossy().into_owned())
}

fn table(
    path: &Path,
    source: Source,
    drawn: Option<&DrawnGear>,
    statements: &Statements,
) -> Result<MeasuredFiles, JobFailure> {
    let cut = cut_short(&source);
    let found = parse_measured_table(source)?;
    let Some(drawn) = drawn else {
        let finding = Diagnostic::new(Problem::MissingKey, "a table does not tell which gear was measured")
            .field("--job")
            .value("none")
            .allowed("a job with the gear")
            .way_out("add `--job JOB`");
        return Err(RunFailure::bad_input(finding).into());
    };
    let mut inspection = empty(drawn.gear, path);
    // The ranges are those of the gear, not of the table: turned beforehand they are themselves again once the whole is turned.
    inspection.conditions = match statements.other_end {
        true => drawn.conditions.clone().turned(),
        false => drawn.conditions.clone(),
    };
    inspection.warnings.extend(cut);
    match found {
        MeasuredTable::Traces(traces) => inspection.traces = traces,
        MeasuredTable::Fields(fields) => inspection.topographies = fields,
    }
    tag(&mut inspection.traces);
    Ok(MeasuredFiles::new(inspection))
}

/// Without an end of the last line its last number may be incomplete.
fn cut_short(source: &Source) -> Option<InspectionWarning> {
    let message = "the last line has no end: the file may be cut short, and the last value with it";
    let last = source.text().lines().count();
    let cut = !source.text().ends_with(['\r', '\n']);
    cut.then(|| InspectionWarning::at(WarningKind::FileCutShort, last, message))
}

fn empty(gear: InspectedGear, path: &Path) -> Inspection {
    Inspection { sources: vec![file_name(path)], ..Inspection::of_gear(gear) }
}

/// Marks the outer ones of several lines of one flank, as measuring machines do: on each tooth the line in the middle of its lines stays
/// without a mark. A tooth whose only line lies where others have outer ones has none in the middle. Where every tooth has one line, all are
/// middle ones.
pub(super) fn tag(traces: &mut [Trace]) {
    for kind in [TraceKind::Profile, TraceKind::Helix] {
        for flank in Flank::BOTH {
            let own = |t: &Trace| t.kind == kind && t.flank == flank && t.tag.is_empty();
            let mut teeth: BTreeMap<u32, Vec<f64>> = BTreeMap::new();
            for trace in traces.iter().filter(|t| own(t)) {
                teeth.entry(trace.tooth).or_default().push(trace.position_mm);
            }
            for places in teeth.values_mut() {
                places.sort_by(f64::total_cmp);
                places.dedup_by(|a, b| (*a - *b).abs() < SAME_PLACE);
            }
            if teeth.values().all(|places| places.len() == 1) {
                continue;
            }
            let all = extremes(teeth.values().flatten().copied());
            let [below, above] = match kind {
                TraceKind::Profile => ["u", "o"],
                TraceKind::Helix => ["f", "k"],
            };
            for trace in traces.iter_mut().filter(|t| own(t)) {
                let places = &teeth[&trace.tooth];
                let middle = middle_line(places, all).map(|k| places[k]);
                let half = 0.5 * (all[0] + all[1]);
                if middle.is_none_or(|middle| (trace.position_mm - middle).abs() >= SAME_PLACE) {
                    trace.tag = if trace.position_mm < middle.unwrap_or(half) { below } else { above }.into();
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_whose_last_line_has_no_end_may_be_cut_short() {
        let of = |text: &str| cut_short(&Source::new("measured.csv", text));
        let warning = of("tooth,flank,w_mm,z_mm,f_um\n1,left,2,3,4").unwrap();
        assert_eq!((warning.kind, warning.line), (WarningKind::FileCutShort, Some(2)));
        assert_eq!(of("tooth,flank,w_mm,z_mm,f_um\n1,left,2,3,4\n"), None);
        assert_eq!(of("tooth,flank,w_mm,z_mm,f_um\r1,left,2,3,4\r"), None);
    }
}
