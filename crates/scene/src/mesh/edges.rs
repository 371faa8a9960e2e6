//! Whether triangles close: every edge once in each sense.

use super::error::MeshError;

/// Two vertices of an edge in one number, so that edges sort.
fn key(from: u32, to: u32) -> u64 {
    u64::from(from) << 32 | u64::from(to)
}

/// Every edge must be run along once and against once.
pub(super) fn check_closed_edges(triangles: &[[u32; 3]]) -> Result<(), MeshError> {
    let edges = |of: fn(u32, u32) -> u64| {
        let mut keys: Vec<u64> =
            triangles.iter().flat_map(|&[a, b, c]| [of(a, b), of(b, c), of(c, a)]).collect();
        keys.sort_unstable();
        keys
    };
    let along = edges(key);
    let against = edges(|from, to| key(to, from));
    let repeated = along.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0]);
    let unmatched = || along.iter().zip(&against).find(|(a, b)| a != b).map(|(a, b)| *a.min(b));
    let Some(edge) = repeated.or_else(unmatched) else { return Ok(()) };
    let count = |keys: &[u64]| keys.partition_point(|&k| k <= edge) - keys.partition_point(|&k| k < edge);
    Err(MeshError::NotWatertight {
        from: (edge >> 32) as u32,
        to: edge as u32,
        along: count(&along),
        against: count(&against),
    })
}
