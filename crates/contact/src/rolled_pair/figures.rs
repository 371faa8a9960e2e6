//! A contact pattern in figures: how much of the flank it covers, its centre and its ends, and how far two patterns are one.

use super::{FlankPlaces, GapField};
use foundation::numerics::extremes;

/// Where the gap stays below the thickness of the marking. Shares of the flank: 0 at root and toe, 1 at tip and heel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPattern {
    /// Covered share of the flank's area.
    pub area: f64,
    /// Centre of the area: over the height, along the tooth.
    pub centre: [f64; 2],
    /// Ends over the height, ends along the tooth.
    pub ends: [[f64; 2]; 2],
}

impl ContactPattern {
    /// The pattern of a field; `areas` are those of the places. `None` where nothing is marked.
    pub fn of(field: &GapField, marking: f64, places: &FlankPlaces, areas: &[f64]) -> Option<Self> {
        let shares = [&places.heights, &places.lengths].map(|of| {
            let (from, to) = (of[0], of[of.len() - 1]);
            of.iter().map(|x| (x - from) / (to - from)).collect::<Vec<f64>>()
        });
        let columns = places.lengths.len();
        let marked = |k: usize| field.gaps[k] <= marking;
        let (mut area, mut moment) = (0.0, [0.0; 2]);
        // Ends are found between the places, where the gap passes the marking.
        let mut borders = [Vec::new(), Vec::new()];
        for (k, part) in areas.iter().enumerate().filter(|(k, _)| marked(*k)) {
            let at = [k / columns, k % columns];
            area += part;
            for axis in 0..2 {
                let here = shares[axis][at[axis]];
                moment[axis] += part * here;
                borders[axis].push(here);
                let stride = if axis == 0 { columns } else { 1 };
                for (inside, neighbour) in
                    [(at[axis] > 0, k.wrapping_sub(stride)), (at[axis] + 1 < shares[axis].len(), k + stride)]
                {
                    if !inside || marked(neighbour) || field.gaps[neighbour].is_infinite() {
                        continue;
                    }
                    let of_neighbour = if axis == 0 { neighbour / columns } else { neighbour % columns };
                    let way = (marking - field.gaps[k]) / (field.gaps[neighbour] - field.gaps[k]);
                    borders[axis].push(here + way * (shares[axis][of_neighbour] - here));
                }
            }
        }
        let all: f64 = areas.iter().sum();
        (area > 0.0).then(|| Self {
            area: area / all,
            centre: moment.map(|m| m / area),
            ends: borders.map(extremes),
        })
    }
}

/// Common area of two patterns over the area of both together; 1 if they are the same, also if both are empty.
pub fn overlap(fields: [&GapField; 2], marking: f64, areas: &[f64]) -> f64 {
    let [mut common, mut either] = [0.0; 2];
    for (k, area) in areas.iter().enumerate() {
        let marked = fields.map(|field| field.gaps[k] <= marking);
        if marked[0] || marked[1] {
            either += area;
        }
        if marked[0] && marked[1] {
            common += area;
        }
    }
    if either > 0.0 { common / either } else { 1.0 }
}
