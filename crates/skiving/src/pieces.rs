//! Where a profile modification is smooth: reliefs, arcs and grids have places at which their slope or their bend jumps. Between them the
//! edge is analytic, and each piece has series of its own.

use super::SkivedFlank;
use foundation::numerics::{Chebyshev, equidistant};

/// Nodes of a trial series, and places at which it is compared with what it stands for.
const NODES: usize = 25;
const PLACES: usize = 48;
/// Share of a stretch at its ends that is not compared: a jump there belongs to the neighbour.
const ENDS: f64 = 1e-4;
/// What a series may miss, in shares of the greatest value over the flank: value, slope and bend alike.
const RESOLVED: f64 = 1e-9;
/// Length of a stretch that holds a jump, in shares of the flank; a place is located as sharply.
const SHARP: f64 = 1e-6;
/// How far the halves of a stretch reach over each other, in shares of it: a jump in the middle lies inside one of them.
const OVERLAP: f64 = 0.01;
/// Jumps of one flank; more are no profile any more.
const MOST: usize = 400;

/// The stretches of a flank between jumps of its modification, ascending; the whole range where there are none.
pub(super) fn pieces(flank: &SkivedFlank) -> Vec<[f64; 2]> {
    let range = flank.range();
    if !flank.is_modified() {
        return vec![range];
    }
    let length = range[1] - range[0];
    let scale = equidistant(range, PLACES)
        .into_iter()
        .map(|w| flank.modification_jet(w))
        .fold([f64::MIN_POSITIVE; 3], |scale, jet| std::array::from_fn(|k| f64::max(scale[k], jet[k].abs())));
    let mut jumps = Vec::new();
    let mut open = vec![range];
    while let Some([from, to]) = open.pop() {
        if jumps.len() > MOST || is_smooth(flank, [from, to], &scale) {
            continue;
        }
        let middle = 0.5 * (from + to);
        if to - from < SHARP * length {
            jumps.push(middle);
            continue;
        }
        let over = OVERLAP * (to - from);
        open.extend([[from, middle + over], [middle - over, to]]);
    }
    jumps.sort_by(f64::total_cmp);
    // Neighbours that both hold a jump tell it twice.
    jumps.dedup_by(|next, kept| *next - *kept < 4.0 * SHARP * length);
    let inside = |w: &f64| (range[0] + ENDS * length..=range[1] - ENDS * length).contains(w);
    let mut ends = vec![range[0]];
    ends.extend(jumps.into_iter().filter(inside));
    ends.push(range[1]);
    ends.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// Whether series through a few places tell value, slope and bend of the modification everywhere on a stretch.
fn is_smooth(flank: &SkivedFlank, [from, to]: [f64; 2], scale: &[f64; 3]) -> bool {
    let nodes: Vec<[f64; 3]> =
        Chebyshev::nodes(from, to, NODES).into_iter().map(|w| flank.modification_jet(w)).collect();
    let series: [Chebyshev; 3] = std::array::from_fn(|k| {
        let values: Vec<f64> = nodes.iter().map(|jet| jet[k]).collect();
        Chebyshev::interpolate(from, to, &values)
    });
    let inset = ENDS * (to - from);
    equidistant([from + inset, to - inset], PLACES).into_iter().all(|w| {
        let jet = flank.modification_jet(w);
        (0..3).all(|k| (series[k].value(w) - jet[k]).abs() <= RESOLVED * scale[k])
    })
}
