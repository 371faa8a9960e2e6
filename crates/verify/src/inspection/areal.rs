//! Block `areal`: fits of grids with their features and uncertainties, point by point and by orthogonal polynomials.

use super::super::expected::{Expected, numbers};
use super::super::given::{Checked, MOST, count, number, requires};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::each_case::each_case;
use metrology::Topography;
use metrology::areal::{ArealDegree, ArealFeatures, ArealField, ArealFit, ArealPoint};
use serde_json::Value;

const UM: f64 = 1e-3;
/// The two ways of fitting a grid agree to this, um.
const SAME: f64 = 1e-9;
const KEYS: [&str; 6] =
    ["offset_um", "f_Halpha_um", "f_Hbeta_material_um", "C_alpha_um", "C_beta_um", "twist_S_um"];

/// Block `areal`.
pub(crate) fn areal(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each_case("areal", block, ledger, |input, tolerances, case, ledger| {
        // What the surface was made of, before it was rounded and noise was added.
        input.informative(&["constructed_from", "noise_sigma_um"]);
        let mut expected = case.object("expected", ledger).ok_or("expected is missing")?;
        let (um, relative) = (tolerances.get("um"), tolerances.get("relative"));
        let field = field(input, ledger)?;
        requires(input, "order", &["f[i][j], i = w, j = z, uniform incl. borders"], ledger)?;
        let degree = match count(input, "degree", 2..=3)? {
            2 => ArealDegree::Second,
            _ => ArealDegree::Third,
        };
        let sizes = [count(input, "n_w", 2..=MOST)?, count(input, "n_z", 2..=MOST)?];
        let (w, z) = field.grid(sizes);
        let values = grid(input, "f_um", sizes)?;
        let topography = Topography::new(w, z, values).ok_or("f_um: another shape than n_w and n_z")?;
        let fit = ArealFit::of_grid(&topography, &field, degree)?;
        compare_ways(expected.case(), &topography, &fit, ledger)?;
        check_fit(&fit, [um, relative], &mut expected, ledger)?;
        expected.finish(ledger);
        Ok(())
    });
}

/// [w_f, w_a] x [z_I, z_II] of the input.
pub(super) fn field(input: &mut Expected<'_>, ledger: &mut Ledger) -> Checked<ArealField> {
    let mut geometry = input.object("geometry_mm", ledger).ok_or("geometry_mm is missing")?;
    let ends = ["w_f", "w_a", "z_I", "z_II"].map(|key| number(&mut geometry, key, ledger));
    geometry.finish(ledger);
    let [w_f, w_a, z_1, z_2] = ends;
    Ok(ArealField::new([w_f?, w_a?], [z_1?, z_2?])?)
}

/// A table `[i][j]` of micrometres in mm, row by row.
pub(super) fn grid(input: &mut Expected<'_>, key: &str, [rows, columns]: [usize; 2]) -> Checked<Vec<f64>> {
    let table = input.take(key).and_then(Value::as_array).filter(|table| table.len() == rows);
    let row = |row: &Value| numbers(row).filter(|row| row.len() == columns);
    let found = table.and_then(|table| table.iter().map(row).collect::<Option<Vec<_>>>());
    let found =
        found.ok_or_else(|| format!("{key}: a table of {rows} rows of {columns} numbers is needed here"))?;
    Ok(found.into_iter().flatten().map(|f| UM * f).collect())
}

/// Features in micrometres in the order of the file's names.
pub(super) fn features_um(features: &ArealFeatures) -> [(&'static str, f64); 6] {
    let values = features.values();
    std::array::from_fn(|k| (KEYS[k], values[k] / UM))
}

/// The same grid point by point.
fn compare_ways(case: &str, topography: &Topography, fit: &ArealFit, ledger: &mut Ledger) -> Checked {
    let columns = topography.z.len();
    let point = |k: usize| ArealPoint {
        w: topography.w[k / columns],
        z: topography.z[k % columns],
        f: topography.f[k],
        weight: 1.0,
    };
    let points: Vec<ArealPoint> = (0..topography.f.len()).map(point).collect();
    let other = ArealFit::of_points(&points, fit.field(), fit.degree())?;
    let size = topography.largest() / UM;
    for (k, (a, b)) in fit.coefficients().iter().zip(other.coefficients()).enumerate() {
        ledger.number(
            case,
            &format!("legendre_um[{k}] point by point"),
            a / UM,
            b / UM,
            SAME * size.max(1.0),
        );
    }
    let (a, b) = (fit.uncertainties(1.0).values(), other.uncertainties(1.0).values());
    for k in 0..KEYS.len() {
        ledger.number(case, &format!("u of {} point by point", KEYS[k]), a[k], b[k], SAME);
    }
    Ok(())
}

fn check_fit(
    fit: &ArealFit,
    [um, relative]: [f64; 2],
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let terms = fit.degree().terms();
    if let Some(listed) = expected.take("terms") {
        let own: Vec<[usize; 2]> = terms.iter().map(|t| [t.p, t.q]).collect();
        ledger.equal(expected.case(), "terms", listed.clone(), serde_json::to_value(own)?);
    }
    let coefficients: Vec<f64> = fit.coefficients().iter().map(|a| a / UM).collect();
    expected.list("legendre_um", &coefficients, um, ledger);
    let scatter = fit.scatter.ok_or("as many points as terms")?;
    if let Some(mut features) = expected.object("features", ledger) {
        features.numbers(&features_um(&fit.features()), um, ledger);
        features.finish(ledger);
    }
    if let Some(mut features) = expected.object("u_features", ledger) {
        features.numbers(&features_um(&fit.uncertainties(scatter)), um, ledger);
        features.finish(ledger);
    }
    if let Some(mut features) = expected.object("u_features_per_um_of_noise", ledger) {
        for (key, value) in features_um(&fit.uncertainties(UM)) {
            features.number(key, value, relative * value, ledger);
        }
        features.finish(ledger);
    }
    let lengths = [
        ("residual_rms_um", fit.residual_rms / UM),
        ("residual_p2p_um", fit.form / UM),
        ("s_um", scatter / UM),
    ];
    expected.numbers(&lengths, um, ledger);
    expected.number("explained_share", fit.explained_share, relative, ledger);
    Ok(())
}
