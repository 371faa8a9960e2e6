//! Teeth that are not like the others: what differs from what all share and from what goes around the gear once a turn, beyond chance.

use foundation::numerics::student_two_sided;
use metrology::Topography;
use metrology::areal::{ArealDegree, ArealField, ArealFit};
use nalgebra::{DMatrix, DVector};

/// A tooth that differs from the others by more than those do among themselves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StandingOut {
    /// Its number.
    pub tooth: u32,
    /// Its largest difference from what all teeth share and what goes around the gear once a turn, about its mean, mm.
    pub largest: f64,
}

/// Teeth from which on what goes around the gear once a turn is separated, and fewest teeth.
const TEETH_WITH_HARMONIC: usize = 6;
const TEETH_WITHOUT: usize = 4;
/// Teeth that differ by less are alike, mm.
const ALIKE: f64 = 1e-4;
/// A tooth is an outlier if by chance one gear in so many has one whose feature differs as much.
const ONE_IN: f64 = 20.0;

/// What of a tooth's surface is compared: five features and what they leave.
const COMPARED: usize = 6;

/// Outlier teeth: a feature of their surface, or what the features leave, differs from what the other teeth let expect at that place
/// around the gear by more than those differ themselves (externally studentised residuals). `angle` of a tooth, rad.
pub(super) fn standing_out(surfaces: &[(u32, Topography)], angle: impl Fn(u32) -> f64) -> Vec<StandingOut> {
    let count = surfaces.len();
    if count < TEETH_WITHOUT {
        return Vec::new();
    }
    let columns = if count < TEETH_WITH_HARMONIC { 1 } else { 3 };
    let angles: Vec<f64> = surfaces.iter().map(|(tooth, _)| angle(*tooth)).collect();
    let terms = DMatrix::from_fn(count, columns, |i, k| [1.0, angles[i].cos(), angles[i].sin()][k]);
    let Some(solver) = (terms.transpose() * &terms).cholesky() else { return Vec::new() };
    // From the values of the teeth to what they differ by from what all share and from the harmonic.
    let rest = DMatrix::identity(count, count) - &terms * solver.inverse() * terms.transpose();
    let Some(compared) = surfaces.iter().map(|(_, s)| numbers(s)).collect::<Option<Vec<_>>>() else {
        return Vec::new();
    };
    let freedom = (count - columns - 1) as f64;
    let residuals: [DVector<f64>; COMPARED] =
        std::array::from_fn(|k| &rest * DVector::from_iterator(count, compared.iter().map(|of| of[k])));
    let beyond_chance = |i: usize, residual: &DVector<f64>| {
        let own = rest[(i, i)];
        // A tooth that alone tells a term differs from nothing.
        if own < 0.1 {
            return false;
        }
        let square = residual[i].powi(2) / own;
        let others = ((residual.norm_squared() - square) / freedom).max(ALIKE * ALIKE);
        student_two_sided((square / others).sqrt(), freedom) < 1.0 / (ONE_IN * count as f64)
    };
    let odd = (0..count).filter(|&i| residuals.iter().any(|residual| beyond_chance(i, residual)));
    odd.map(|i| StandingOut { tooth: surfaces[i].0, largest: largest_difference(surfaces, &rest, i) })
        .collect()
}

/// Features and rest of a surface, mm; `None` for one that has none.
fn numbers(surface: &Topography) -> Option<[f64; COMPARED]> {
    let ends = |x: &[f64]| Some([*x.first()?, *x.last()?]);
    let field = ArealField::new(ends(&surface.w)?, ends(&surface.z)?).ok()?;
    let fit = ArealFit::of_grid(surface, &field, ArealDegree::Second).ok()?;
    let of = fit.features();
    let values = [
        of.profile_slope,
        of.profile_crowning,
        of.helix_slope,
        of.helix_crowning,
        of.twist,
        fit.residual_rms,
    ];
    Some(values)
}

/// How far a tooth, about its mean, differs at most from what all share and what goes around the gear.
fn largest_difference(surfaces: &[(u32, Topography)], rest: &DMatrix<f64>, tooth: usize) -> f64 {
    let places = surfaces[tooth].1.f.len();
    let common = (0..places).filter(|&k| surfaces.iter().all(|(_, s)| s.f[k].is_finite()));
    let difference = |k: usize| {
        let values = DVector::from_iterator(surfaces.len(), surfaces.iter().map(|(_, s)| s.f[k]));
        (rest.row(tooth) * &values)[0]
    };
    let values: Vec<f64> = common.map(difference).collect();
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    values.iter().fold(0.0, |most: f64, f| most.max((f - mean).abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Teeth whose slope over z goes around the gear, one of them with more.
    fn teeth(count: u32, odd: f64) -> Vec<StandingOut> {
        let places: Vec<f64> = (0..5).map(f64::from).collect();
        let angle = |tooth: u32| TAU * f64::from(tooth) / f64::from(count);
        let surfaces: Vec<(u32, Topography)> = (1..=count)
            .map(|tooth| {
                let own = 1e-4 * (f64::from(tooth) * 2.3).sin() + if tooth == 2 { odd } else { 0.0 };
                let slope = 0.003 * (angle(tooth) + 0.7).cos() + own;
                let f = (0..25).map(|k| slope * (f64::from(k % 5) - 2.0)).collect();
                (tooth, Topography::new(places.clone(), places.clone(), f).unwrap())
            })
            .collect();
        standing_out(&surfaces, angle)
    }

    #[test]
    fn one_tooth_stands_out_of_a_wobble() {
        for count in [7, 8, 9, 13] {
            assert!(teeth(count, 0.0).is_empty(), "{count}");
            let found = teeth(count, 0.003);
            assert_eq!(found.iter().map(|odd| odd.tooth).collect::<Vec<_>>(), [2], "{count}");
            // 3 um at the outermost of places that reach to 2; the fit gives some of it to the other teeth.
            assert!((0.003..=0.006).contains(&found[0].largest), "{count}: {}", found[0].largest);
        }
        assert!(teeth(3, 0.1).is_empty());
    }
}
