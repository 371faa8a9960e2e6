//! 25-modifications: decompositions by least squares, and the common ratio of two flanks whose reliefs ask for different
//! ones.

use super::decompositions::{axial, relief_direction};
use super::expected::Expected;
use super::gear_sets::{Set, entries, named};
use super::ledger::Ledger;
use super::reference::{Reference, Tolerances};
use foundation::geometry::{Flank, Sides};
use foundation::modification::{Modification, ModificationSpec, NoFiles};
use generating::least_squares::{
    Candidates, FitNorm, FitQuality, FitSettings, FlankFit, FunctionClass, Objective, Samples, search_ratio,
};
use generating::{FlankLines, GeneratingError};
use serde_json::Value;

const UM: f64 = 1e-3;

/// Keys `use`, `n`, `nw`, `nz` and, where they are given, the degree `k` and `norm` = "max".
fn settings(item: &mut Expected<'_>, ledger: &mut Ledger) -> Option<(FitSettings, [usize; 2])> {
    let listed = item.take("use").and_then(Value::as_array);
    let letters: Option<Vec<char>> = listed.and_then(|list| list.iter().map(single_letter).collect());
    let class = letters.and_then(FunctionClass::from_letters);
    if class.is_none() {
        ledger.fail(item.case(), "use", Value::Null, "a list of letters C, L, Q, P, K is needed".into());
    }
    let mut settings = FitSettings::new(class?);
    settings.intervals = whole(item, "n", ledger)?;
    if item.peek("k").is_some() {
        settings.degree = whole(item, "k", ledger)?;
    }
    if item.peek("norm").is_some() {
        match item.given_text("norm", ledger)? {
            "max" => settings.norm = FitNorm::Largest,
            other => {
                ledger.fail(item.case(), "norm", other.into(), "max is the only norm that is named".into());
                return None;
            }
        }
    }
    Some((settings, [whole(item, "nw", ledger)?, whole(item, "nz", ledger)?]))
}

fn single_letter(value: &Value) -> Option<char> {
    let mut letters = value.as_str()?.chars();
    letters.next().filter(|_| letters.next().is_none())
}

/// A count among the inputs.
fn whole(item: &mut Expected<'_>, key: &str, ledger: &mut Ledger) -> Option<usize> {
    let value = item.take(key);
    let count = value.and_then(Value::as_u64).and_then(|n| usize::try_from(n).ok());
    if count.is_none() {
        let found = value.cloned().unwrap_or(Value::Null);
        ledger.fail(item.case(), key, found, "a whole number is needed here as input".into());
    }
    count
}

/// The sum of the modifications listed in `list` on a grid over the field of a flank.
fn samples(set: &Set, flank: Flank, list: &Value, grid: [usize; 2]) -> Result<Samples, GeneratingError> {
    let specs = read_specs(list)?;
    let target = Modification::for_flank(&specs, flank, &set.field(flank)?, &NoFiles)?;
    Samples::of_modification(&target, grid)
}

fn read_specs(list: &Value) -> Result<Vec<ModificationSpec>, GeneratingError> {
    let list = list.as_array().map(Vec::as_slice).unwrap_or_default();
    Ok(list.iter().map(ModificationSpec::from_json).collect::<Result<Vec<_>, _>>()?)
}

/// `rms_um` and `max_um`.
fn compare(quality: FitQuality, relative: [f64; 2], expected: &mut Expected<'_>, ledger: &mut Ledger) {
    let (rms, largest) = (quality.rms / UM, quality.largest / UM);
    expected.number("rms_um", rms, relative[0] * rms, ledger);
    expected.number("max_um", largest, relative[1] * largest, ledger);
}

/// Block `least_squares`.
pub(super) fn least_squares(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    entries("least_squares", block, ledger, |item, ledger| {
        item.informative(&["name"]);
        let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
        let relative = ["rms_relative", "max_relative"].map(|key| tolerances.get(key));
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let scan = item.given_list("rho_scan_deg", ledger);
        let specs = item.take("specs").unwrap_or(&Value::Null);
        let (Some((settings, grid)), Some(scan)) = (settings(item, ledger), scan) else { return Ok(()) };
        let lines = axial(&set, flank)?;
        let samples = samples(&set, flank, specs, grid)?;
        let fit = FlankFit { lines: &lines, samples: &samples, settings: &settings, rack_slope: 0.0 };
        let results = item.objects("results", ledger);
        let count = Value::from(results.len());
        ledger.equal(item.case(), "number of results", count, scan.len().into());
        for (rho_deg, mut expected) in scan.into_iter().zip(results) {
            let rho = rho_deg.to_radians();
            expected.number("rho_F2_deg", rho_deg, relative[0], ledger);
            match fit.at_direction(rho.tan()) {
                Ok(found) => compare(found.report.quality(), relative, &mut expected, ledger),
                Err(error) => expected.refused(&error, ledger),
            }
            expected.finish(ledger);
        }
        Ok(())
    });
}

/// One flank of block `two_flanks`.
struct Side {
    lines: FlankLines,
    samples: Samples,
    /// tan(rho_2) of its relief.
    relief: Option<f64>,
}

fn side(set: &Set, flank: Flank, specs: &Value, grid: [usize; 2]) -> Result<Side, GeneratingError> {
    let list = &specs[flank.name()];
    let relief = read_specs(list)?.iter().find_map(|spec| match spec {
        ModificationSpec::TriangularEndRelief(relief) => Some(relief_direction(relief)),
        _ => None,
    });
    Ok(Side { lines: axial(set, flank)?, samples: samples(set, flank, list, grid)?, relief })
}

/// Block `two_flanks`.
pub(super) fn two_flanks(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let list = Value::Array(vec![block.clone()]);
    entries("two_flanks", &list, ledger, |item, ledger| {
        let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
        let [relative, ratio_mm] = ["objective_relative", "best_K_absolute"].map(|key| tolerances.get(key));
        let Some(name) = item.given_text("gear", ledger) else { return Ok(()) };
        let Some(set) = Set::read(name, &file.root["gears"][name], ledger) else { return Ok(()) };
        let ratios = item.given_list("K_scan", ledger);
        let specs = item.take("specs").unwrap_or(&Value::Null);
        let (Some((settings, grid)), Some(ratios)) = (settings(item, ledger), ratios) else {
            return Ok(());
        };
        let sides = Sides::try_from_fn(|flank| side(&set, flank, specs, grid))?;
        for (flank, side) in sides.iter() {
            let Some(t) = side.relief else { continue };
            item.number(&format!("tan_rho_{}", flank.name()), t, relative * t.abs(), ledger);
            let exact = side.lines.ratio_of_direction(t);
            item.number(&format!("exact_K_{}", flank.name()), exact, relative * exact.abs(), ledger);
        }
        let fits = Sides::from_fn(|flank| {
            let Side { lines, samples, .. } = &sides[flank];
            FlankFit { lines, samples, settings: &settings, rack_slope: 0.0 }
        });
        let rows = item.objects("scan", ledger);
        let count = Value::from(rows.len());
        ledger.equal(item.case(), "number of scanned ratios", count, ratios.len().into());
        for (&ratio, mut row) in ratios.iter().zip(rows) {
            row.number("K_ZV1", ratio, relative, ledger);
            if let Err(error) = scanned(&fits, ratio, relative, &mut row, ledger) {
                row.refused(&error, ledger);
            }
            row.finish(ledger);
        }
        let candidates = Candidates::ratios(&ratios)?;
        let best = search_ratio(&fits.map(|_, fit| Some(*fit)), &candidates, Objective::Rms)?;
        item.number("best_K_ZV1", best.ratio, ratio_mm, ledger);
        let objective = best.objective / UM;
        item.number("best_objective_um", objective, relative * objective, ledger);
        Ok(())
    });
}

/// One ratio of the scan.
fn scanned(
    fits: &Sides<FlankFit<'_>>,
    ratio: f64,
    relative: f64,
    row: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), GeneratingError> {
    let mut met = Vec::new();
    for (flank, fit) in fits.iter() {
        let found = fit.at_ratio(ratio)?;
        let quality = found.report.quality();
        met.push(quality);
        let Some(mut expected) = row.object(flank.name(), ledger) else { continue };
        let rho_deg = found.coordinates.t().atan().to_degrees();
        expected.number("rho_F2_deg", rho_deg, relative * rho_deg.abs(), ledger);
        compare(quality, [relative; 2], &mut expected, ledger);
        expected.finish(ledger);
    }
    let objective = Objective::Rms.of(met) / UM;
    row.number("objective_um", objective, relative * objective, ledger);
    Ok(())
}
