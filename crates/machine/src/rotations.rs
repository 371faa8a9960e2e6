//! Rotations about given axes that make up a given rotation: the wrist of any machine in closed form. Knows no machine.

use nalgebra::{Matrix3, Rotation3, Unit, Vector3};
use std::f64::consts::PI;

/// Rotation by an angle (rad) about a unit vector.
pub(super) fn about(axis: &Vector3<f64>, angle: f64) -> Matrix3<f64> {
    *Rotation3::from_axis_angle(&Unit::new_unchecked(*axis), angle).matrix()
}

/// Angle (rad) about k by which p has to turn so that its part across k points as that of q does.
pub(super) fn turn(k: &Vector3<f64>, p: &Vector3<f64>, q: &Vector3<f64>) -> f64 {
    let (p, q) = (p - k * k.dot(p), q - k * k.dot(q));
    k.dot(&p.cross(&q)).atan2(p.dot(&q))
}

/// A unit vector across k.
pub(super) fn across(k: &Vector3<f64>) -> Vector3<f64> {
    let least = k.iamin();
    let mut e = Vector3::zeros();
    e[least] = 1.0;
    (e - k * k.dot(&e)).normalize()
}

/// Why a wrist does not make a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NoWrist {
    /// The middle axis does not bring the outer ones to the wanted angle.
    Beyond {
        /// Wanted cosine between the outer axes.
        wanted: f64,
        /// Least cosine that is reached.
        least: f64,
        /// Greatest cosine that is reached.
        greatest: f64,
    },
    /// The middle axis turns nothing, or the outer ones do the same.
    Singular {
        /// Sine of the angle from it.
        measure: f64,
    },
}

/// Below this share of its reach squared, the two solutions of the middle axis are one: apart by 3e-8 rad at most, which turns
/// the outer axes against each other by less than rounding.
const COINCIDENT: f64 = 1e-15;
/// Farther below zero than this share of the reach squared nothing is reached (`docs/mathematics/milling.md#positions-of-five-axes`): at
/// most 5e-13 rad of the direction, what rounding makes of a horizontal tool on a table that nutates by 45 degrees.
const BEYOND: f64 = 1e-12;
/// Axes closer to parallel than this (sine) do the same.
const PARALLEL: f64 = 1e-9;

/// All angles b at which k1 . (R(k2, b) k3) = `wanted`; one where two coincide. `least_reach`: sine below which b does not
/// matter.
fn middle([k1, k2, k3]: [&Vector3<f64>; 3], wanted: f64, least_reach: f64) -> Result<Vec<f64>, NoWrist> {
    // k1 . R(k2, b) k3 = p + u cos b + v sin b.
    let p = k1.dot(k2) * k2.dot(k3);
    let (u, v) = (k1.dot(k3) - p, k1.dot(&k2.cross(k3)));
    let reach = u.hypot(v);
    if reach < least_reach {
        return Err(NoWrist::Singular { measure: reach });
    }
    let rest = wanted - p;
    // As a product: 1 - cos^2 would lose half of the digits where the solutions meet.
    let square = (reach - rest) * (reach + rest);
    let coincident = COINCIDENT * reach * reach;
    if square < -BEYOND * reach * reach {
        return Err(NoWrist::Beyond { wanted, least: p - reach, greatest: p + reach });
    }
    let centre = v.atan2(u);
    if square <= coincident {
        return Ok(vec![if rest < 0.0 { centre + PI } else { centre }]);
    }
    let half = square.sqrt().atan2(rest);
    Ok(vec![centre + half, centre - half])
}

/// All angles a, b, c with R(k1, a) R(k2, b) R(k3, c) = `rotation`, rad. `least_reach` as in [`middle`].
pub(super) fn three_axes(
    [k1, k2, k3]: [&Vector3<f64>; 3],
    rotation: &Matrix3<f64>,
    least_reach: f64,
) -> Result<Vec<[f64; 3]>, NoWrist> {
    let image = rotation * k3;
    let x = across(k3);
    let outer = |b: f64| {
        let z = about(k2, b) * k3;
        let measure = k1.cross(&z).norm();
        if measure < PARALLEL {
            return Err(NoWrist::Singular { measure });
        }
        let a = turn(k1, &z, &image);
        let rest = (about(k1, a) * about(k2, b)).transpose() * rotation;
        Ok([a, b, turn(k3, &x, &(rest * x))])
    };
    middle([k1, k2, k3], k1.dot(&image), least_reach)?.into_iter().map(outer).collect()
}

/// Directions that stand to an axis at cosines closer than this stand at one angle to it.
const SAME_ANGLE: f64 = 1e-13;

/// The angles of [`middle`] for a direction near k1 or its opposite, where the cosine between them does not tell how near: from
/// the chord, |q -+ k1| = 2 |k1 x k2| sin(half / 2). `None` farther away, and where p does not come to stand along k1.
fn near_pole([k1, k2]: [&Vector3<f64>; 2], p: &Vector3<f64>, q: &Vector3<f64>) -> Option<[f64; 2]> {
    let side = k1.dot(q).signum();
    let pole = k1 * side;
    if k2.dot(&(p - pole)).abs() > SAME_ANGLE {
        return None;
    }
    let sine = (q - pole).norm() / (2.0 * k1.cross(k2).norm());
    let centre = turn(k2, p, &pole);
    // Beyond 60 degrees of the middle axis the cosine tells more.
    let half = (sine < 0.5).then(|| 2.0 * sine.asin())?;
    Some(if side > 0.0 { [centre + half, centre - half] } else { [centre - half, centre + half] })
}

/// All angles a, b with R(k1, a) R(k2, b) p = q for unit vectors p and q, rad: a tool on two rotary axes, the solution with
/// R(k2, b) p on the side of k1 x k2 first (`docs/mathematics/milling.md#positions-of-five-axes`).
pub(super) fn two_axes(
    [k1, k2]: [&Vector3<f64>; 2],
    p: &Vector3<f64>,
    q: &Vector3<f64>,
) -> Result<Vec<[f64; 2]>, NoWrist> {
    let measure = k1.cross(q).norm();
    if measure < PARALLEL {
        return Err(NoWrist::Singular { measure });
    }
    let middles = match near_pole([k1, k2], p, q) {
        Some(middles) => middles.into(),
        None => middle([k1, k2, p], k1.dot(q), PARALLEL)?,
    };
    // The part of R(k2, b) p along k1 x k2 is the rate of `middle`'s cosine with b: positive at its second angle.
    Ok(middles.into_iter().rev().map(|b| [turn(k1, &(about(k2, b) * p), q), b]).collect())
}
