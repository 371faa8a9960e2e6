//! How smoothly the rotary axes run along a row: figures over the way of the contact
//! (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::{CutterPlace, MillingSetup};
use machine::Positions;
use nalgebra::Vector3;

/// Figures of one axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Change {
    /// Sum of |d th|, rad.
    pub travel: f64,
    /// Largest |d th / ds|, rad/mm.
    pub rate: f64,
    /// Largest second difference, rad/mm^2.
    pub second: f64,
    /// How often the axis turns back; steps below 1e-10 rad do not count.
    pub reversals: usize,
}

/// Figures of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowSmoothness {
    /// Of th_1 and th_2.
    pub rotary: [Change; 2],
    /// Way of the contact, mm.
    pub path: f64,
    /// Least and greatest lean of the cutter's axis into the feed direction, rad.
    pub lean: [f64; 2],
}

/// Steps below this (rad) are rounding and turn nothing back (`docs/mathematics/milling.md#positions-of-five-axes`).
const STILL: f64 = 1e-10;

impl Change {
    /// Figures of angles (rad) over steps of these lengths (mm); steps without length have no rate.
    pub fn new(angles: &[f64], steps: &[f64]) -> Self {
        let turns: Vec<f64> = angles.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let rates: Vec<(f64, f64)> =
            turns.iter().zip(steps).filter(|(_, ds)| **ds > 0.0).map(|(turn, ds)| (turn / ds, *ds)).collect();
        let second = |pair: &[(f64, f64)]| ((pair[1].0 - pair[0].0) / (0.5 * (pair[0].1 + pair[1].1))).abs();
        let senses: Vec<bool> =
            turns.iter().filter(|turn| turn.abs() >= STILL).map(|turn| *turn > 0.0).collect();
        Self {
            travel: turns.iter().map(|turn| turn.abs()).sum(),
            rate: rates.iter().map(|(rate, _)| rate.abs()).fold(0.0, f64::max),
            second: rates.windows(2).map(second).fold(0.0, f64::max),
            reversals: senses.windows(2).filter(|pair| pair[0] != pair[1]).count(),
        }
    }
}

/// Ways of the contact from place to place, mm.
pub fn contact_arcs(places: &[CutterPlace]) -> Vec<f64> {
    places.windows(2).map(|pair| (pair[1].contact.xyz - pair[0].contact.xyz).norm()).collect()
}

/// asin(a . f) at every place, rad, with the feed direction f of the parabola through the contact there and at its neighbours; of
/// two places, of the chord. 0 where the contact stands still.
pub fn leans(places: &[CutterPlace]) -> Vec<f64> {
    let at = |k: usize| places[k].contact.xyz;
    let chord = |a: usize, b: usize| (at(b) - at(a), (at(b) - at(a)).norm());
    let direction = |k: usize| -> Vector3<f64> {
        let last = places.len() - 1;
        if last < 2 {
            return if last == 1 { chord(0, 1).0 } else { Vector3::zeros() };
        }
        let middle = k.clamp(1, last - 1);
        let ((before, h), (after, g)) = (chord(middle - 1, middle), chord(middle, middle + 1));
        if h == 0.0 || g == 0.0 {
            return before + after;
        }
        let (before, after) = (before / h, after / g);
        let bend = (after - before) / (h + g);
        let slope = before + bend * h;
        match k {
            _ if k < middle => slope - bend * (2.0 * h),
            _ if k > middle => slope + bend * (2.0 * g),
            _ => slope,
        }
    };
    let lean = |k: usize| match direction(k).try_normalize(f64::MIN_POSITIVE) {
        Some(feed) => feed.dot(&places[k].axis.xyz).clamp(-1.0, 1.0).asin(),
        None => 0.0,
    };
    (0..places.len()).map(lean).collect()
}

/// The figures of a row from its places and the positions of the axes there.
pub fn smoothness(setup: &MillingSetup, places: &[CutterPlace], nodes: &[Positions]) -> RowSmoothness {
    figures(setup, places, nodes, &leans(places))
}

/// The same for a row whose feed directions (units, as many as places) are known: a surface knows them better than places beside
/// each other do.
pub fn smoothness_along(
    setup: &MillingSetup,
    places: &[CutterPlace],
    nodes: &[Positions],
    feeds: &[Vector3<f64>],
) -> RowSmoothness {
    let lean =
        |(feed, place): (&Vector3<f64>, &CutterPlace)| feed.dot(&place.axis.xyz).clamp(-1.0, 1.0).asin();
    let leans: Vec<f64> = feeds.iter().zip(places).map(lean).collect();
    figures(setup, places, nodes, &leans)
}

fn figures(
    setup: &MillingSetup,
    places: &[CutterPlace],
    nodes: &[Positions],
    leans: &[f64],
) -> RowSmoothness {
    let arcs = contact_arcs(places);
    let angles = |axis: usize| nodes.iter().map(|at| at[axis]).collect::<Vec<f64>>();
    let [low, high] = match leans.first() {
        Some(&first) => leans.iter().fold([first; 2], |[low, high], &x| [low.min(x), high.max(x)]),
        None => [0.0; 2],
    };
    RowSmoothness {
        rotary: setup.axes().rotary.map(|axis| Change::new(&angles(axis), &arcs)),
        path: arcs.iter().sum(),
        lean: [low, high],
    }
}
