//! Isolines and regions of a topography by marching squares.
//!
//! The field is taken as linear along the edges of a cell; a saddle is decided by the mean of its corners. Lines
//! are chained by the numbers of the edges that they cross, so that no comparison of coordinates is needed.

use std::collections::{BTreeMap, BTreeSet};

use super::topography::Topography;

/// A polyline in (z, w), mm.
pub type Line = Vec<[f64; 2]>;

/// The lines f = level inside the grid. A closed line repeats its first point.
pub fn isolines(field: &Topography, level: f64) -> Vec<Line> {
    let rows: Vec<&[f64]> = field.f_um().iter().map(Vec::as_slice).collect();
    march(field.z_mm(), field.w_mm(), &rows, level)
}

/// Closed loops around f >= level, closed along the border of the grid where needed; fill them by the even-odd rule.
pub fn region_above(field: &Topography, level: f64) -> Vec<Line> {
    // A border of minus infinity at the place of the outermost nodes closes every loop.
    let pad = |values: &[f64]| {
        let mut padded = vec![values[0]];
        padded.extend_from_slice(values);
        padded.push(values[values.len() - 1]);
        padded
    };
    let (z, w) = (pad(field.z_mm()), pad(field.w_mm()));
    let outside = vec![f64::NEG_INFINITY; z.len()];
    let inside: Vec<Vec<f64>> = field
        .f_um()
        .iter()
        .map(|row| {
            let mut padded = vec![f64::NEG_INFINITY];
            padded.extend_from_slice(row);
            padded.push(f64::NEG_INFINITY);
            padded
        })
        .collect();
    let mut rows = vec![outside.as_slice()];
    rows.extend(inside.iter().map(Vec::as_slice));
    rows.push(outside.as_slice());
    march(&z, &w, &rows, level)
}

/// An edge of the grid: from node (row, column) to the right (false) or up (true).
type Edge = (usize, usize, bool);

fn march(x: &[f64], y: &[f64], rows: &[&[f64]], level: f64) -> Vec<Line> {
    let mut next: BTreeMap<Edge, Edge> = BTreeMap::new();
    for i in 0..y.len() - 1 {
        for j in 0..x.len() - 1 {
            // Counter-clockwise from the lower left; edge k runs from corner k to corner k + 1.
            let corners = [rows[i][j], rows[i][j + 1], rows[i + 1][j + 1], rows[i + 1][j]];
            let edges = [(i, j, false), (i, j + 1, true), (i + 1, j, false), (i, j, true)];
            let above = corners.map(|f| f >= level);
            let leaves = |k: usize| above[k] && !above[(k + 1) % 4];
            let enters = |k: usize| !above[k] && above[(k + 1) % 4];
            let exits: Vec<usize> = (0..4).filter(|&k| leaves(k)).collect();
            let joined = corners.iter().sum::<f64>() / 4.0 >= level;
            for &k in &exits {
                let entry = match exits.len() {
                    1 => (0..4).find(|&m| enters(m)),
                    _ if joined => Some((k + 1) % 4),
                    _ => Some((k + 3) % 4),
                };
                if let Some(entry) = entry {
                    next.insert(edges[k], edges[entry]);
                }
            }
        }
    }
    let crossing = |&(i, j, up): &Edge| {
        let (i2, j2) = if up { (i + 1, j) } else { (i, j + 1) };
        let (a, b) = (rows[i][j], rows[i2][j2]);
        let t = if a.is_infinite() {
            1.0
        } else if b.is_infinite() {
            0.0
        } else {
            ((level - a) / (b - a)).clamp(0.0, 1.0)
        };
        [x[j] + t * (x[j2] - x[j]), y[i] + t * (y[i2] - y[i])]
    };
    chain(next).iter().map(|edges| edges.iter().map(crossing).collect()).collect()
}

/// Chains of edges: first those with an open beginning, then the closed ones.
fn chain(mut next: BTreeMap<Edge, Edge>) -> Vec<Vec<Edge>> {
    let targets: BTreeSet<Edge> = next.values().copied().collect();
    let open: Vec<Edge> = next.keys().filter(|edge| !targets.contains(edge)).copied().collect();
    let mut chains = Vec::new();
    let mut follow = |start: Edge, next: &mut BTreeMap<Edge, Edge>| {
        let mut edges = vec![start];
        let mut here = start;
        while let Some(to) = next.remove(&here) {
            edges.push(to);
            here = to;
        }
        chains.push(edges);
    };
    for start in open {
        follow(start, &mut next);
    }
    while let Some(start) = next.keys().next().copied() {
        follow(start, &mut next);
    }
    chains
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cone() -> Topography {
        let axis: Vec<f64> = (0..=40).map(|k| f64::from(k) * 0.1 - 2.0).collect();
        let f = axis.iter().map(|w| axis.iter().map(|z| -w.hypot(*z)).collect()).collect();
        Topography::new(axis.clone(), axis, f).unwrap()
    }

    fn area(line: &Line) -> f64 {
        line.windows(2).map(|p| 0.5 * (p[0][0] * p[1][1] - p[1][0] * p[0][1])).sum()
    }

    #[test]
    fn a_circle_is_one_closed_line_around_the_summit() {
        let lines = isolines(&cone(), -1.0);
        assert_eq!(lines.len(), 1);
        assert_eq!(lines[0].first(), lines[0].last());
        assert!(lines[0].iter().all(|p| (p[0].hypot(p[1]) - 1.0).abs() < 0.01));
        assert!((area(&lines[0]) - std::f64::consts::PI).abs() < 0.02);
    }

    #[test]
    fn a_region_is_closed_along_the_border() {
        let loops = region_above(&cone(), -10.0);
        assert_eq!(loops.len(), 1);
        assert!((area(&loops[0]) - 16.0).abs() < 1e-9);
        // The circle of radius 2.2 leaves the square in four arcs and cuts off its corners only.
        let cut = region_above(&cone(), -2.2);
        assert_eq!(cut.len(), 1);
        assert!(area(&cut[0]) < 16.0 && area(&cut[0]) > 13.0);
        assert_eq!(isolines(&cone(), -2.2).len(), 4);
    }

    #[test]
    fn nothing_above_gives_no_lines() {
        assert!(isolines(&cone(), 1.0).is_empty());
        assert!(region_above(&cone(), 1.0).is_empty());
    }
}
