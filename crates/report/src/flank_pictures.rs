//! Flanks as pictures that pages of several processes draw alike. Knows no process.

use super::charts::{
    ChartError, ContourMap, LevelScale, NamedTopography, Topography, TopographyNet, contour_map,
    topography_net,
};
use crate::data::{Block, Figure};

/// Smallest and largest value of all topographies and zero, um.
pub fn range_with_zero<'a>(topographies: impl Iterator<Item = &'a Topography>) -> (f64, f64) {
    topographies.map(Topography::range_um).fold((0.0_f64, 0.0_f64), |(lo, hi), (a, b)| (lo.min(a), hi.max(b)))
}

/// The flanks as nets, and the same as contour maps, whose id ends so.
pub fn net_and_map(
    id: &str,
    name: &str,
    panels: &[NamedTopography],
    range_um: Option<(f64, f64)>,
    scale: Option<LevelScale>,
    quantity: &str,
) -> Result<Vec<Block>, ChartError> {
    let net = topography_net(&TopographyNet { title: name.to_owned(), panels: panels.to_vec(), range_um })?;
    let map = contour_map(&ContourMap {
        title: format!("{name}, contour map"),
        quantity: quantity.to_owned(),
        panels: panels.to_vec(),
        scale,
    })?;
    let figures = [Figure::new(id, net, ""), Figure::new(format!("{id}-contour-map"), map, "")];
    Ok(figures.map(Block::Figure).into())
}
