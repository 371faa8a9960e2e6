//! Block `reconstruction`: a surface from profiles and leads of one tooth flank.

use super::super::expected::Expected;
use super::super::given::{Checked, MOST, count, list};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::areal::{features_um, field, grid};
use super::each_case::each_case;
use foundation::numerics::equidistant;
use metrology::areal::{ArealDegree, ArealField, ArealFit, Reconstruction, Trace, Zeros};
use serde_json::Value;

const UM: f64 = 1e-3;

/// Block `reconstruction`.
pub(crate) fn reconstruction(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each_case("reconstruction", block, ledger, |input, tolerances, case, ledger| {
        let mut expected = case.object("expected", ledger).ok_or("expected is missing")?;
        // The error against the surface that the traces were taken from; the file does not hold that surface.
        expected.informative(&["true_error_max_um"]);
        let (um, relative) = (tolerances.get("um"), tolerances.get("relative"));
        let field = field(input, ledger)?;
        let samples = count(input, "n_samples", 2..=MOST)?;
        let profiles = traces(input, ["profile_z_mm", "profiles_um"], field.roll(), samples, ledger)?;
        let leads = traces(input, ["lead_w_mm", "leads_um"], field.face(), samples, ledger)?;
        let sizes = [count(input, "grid_n_w", 2..=MOST)?, count(input, "grid_n_z", 2..=MOST)?];
        let surface = Reconstruction::new(profiles, leads, Zeros::Free)?;
        check_surface(&surface, &field, sizes, [um, relative], &mut expected, ledger)?;
        expected.finish(ledger);
        Ok(())
    });
}

/// Traces of one direction, sampled evenly over the whole field.
fn traces(
    input: &mut Expected<'_>,
    [places, values]: [&str; 2],
    range: [f64; 2],
    samples: usize,
    ledger: &mut Ledger,
) -> Checked<Vec<Trace>> {
    let places = list(input, places, ledger)?;
    let values = grid(input, values, [places.len(), samples])?;
    let along = equidistant(range, samples);
    let traces = places.iter().zip(values.chunks(samples)).map(|(&at, f)| Trace::new(at, &along, f));
    Ok(traces.collect::<Result<_, _>>()?)
}

fn check_surface(
    surface: &Reconstruction,
    field: &ArealField,
    sizes: [usize; 2],
    [um, relative]: [f64; 2],
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let (w, z) = field.grid(sizes);
    let grid = surface.on_grid(w, z)?;
    // Free zeros leave the mean of the surface open; the file lists surfaces without it.
    let mean = grid.f.iter().sum::<f64>() / grid.f.len() as f64;
    let values: Vec<f64> = grid.f.iter().map(|f| (f - mean) / UM).collect();
    expected.table("surface_um", (&values, sizes[1]), um, ledger);
    let mismatch = surface.mismatch.ok_or("no mismatch of free zeros")?;
    let pairs = [("mismatch_rms_um", mismatch.rms / UM), ("mismatch_max_um", mismatch.largest / UM)];
    expected.numbers(&pairs, um, ledger);
    let fit = ArealFit::of_grid(&grid, field, ArealDegree::Second)?;
    if let Some(mut features) = expected.object("features_without_offset", ledger) {
        for (key, value) in features_um(&fit.features()).into_iter().skip(1) {
            features.number(key, value, um.max(relative * value.abs()), ledger);
        }
        features.finish(ledger);
    }
    Ok(())
}
