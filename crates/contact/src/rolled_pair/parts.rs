//! The separate parts of a contact pattern: places that are marked and hang together along rows and columns.

use super::{ContactPattern, FlankPlaces, GapField};

/// The parts of a pattern, the largest first, each as a pattern of its own; those below `least` of the flank's area are left out.
pub fn parts(
    field: &GapField,
    marking: f64,
    places: &FlankPlaces,
    areas: &[f64],
    least: f64,
) -> Vec<ContactPattern> {
    let columns = places.lengths.len();
    let mut of_part = vec![usize::MAX; field.gaps.len()];
    let mut count = 0;
    for first in 0..field.gaps.len() {
        if field.gaps[first] > marking || of_part[first] != usize::MAX {
            continue;
        }
        of_part[first] = count;
        let mut open = vec![first];
        while let Some(at) = open.pop() {
            let column = at % columns;
            let beside = [
                at.checked_sub(columns),
                Some(at + columns).filter(|next| *next < field.gaps.len()),
                (column > 0).then(|| at - 1),
                (column + 1 < columns).then_some(at + 1),
            ];
            for next in beside.into_iter().flatten() {
                if field.gaps[next] <= marking && of_part[next] == usize::MAX {
                    of_part[next] = count;
                    open.push(next);
                }
            }
        }
        count += 1;
    }
    let alone = |part: usize| {
        // What belongs to another part is open here, so that ends between places are found as before.
        let gap = |(gap, of): (&f64, &usize)| {
            if *of == part || *gap > marking { *gap } else { f64::INFINITY }
        };
        GapField { gaps: field.gaps.iter().zip(&of_part).map(gap).collect() }
    };
    let of_part = |part| ContactPattern::of(&alone(part), marking, places, areas);
    let mut parts: Vec<ContactPattern> =
        (0..count).filter_map(of_part).filter(|part| part.area >= least).collect();
    parts.sort_by(|a, b| b.area.total_cmp(&a.area));
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_islands_are_two_parts_and_specks_are_none() {
        let places = FlankPlaces {
            heights: (0..5).map(f64::from).collect(),
            lengths: (0..9).map(f64::from).collect(),
        };
        let mut gaps = vec![9.0; 45];
        for (i, j) in [(1, 1), (1, 2), (2, 1), (2, 2), (3, 2), (2, 6), (3, 6), (0, 8)] {
            gaps[9 * i + j] = 1.0;
        }
        let field = GapField { gaps };
        let found = parts(&field, 5.0, &places, &[1.0; 45], 0.03);
        assert_eq!(found.len(), 2);
        assert!((found[0].area - 5.0 / 45.0).abs() < 1e-12 && (found[1].area - 2.0 / 45.0).abs() < 1e-12);
        assert!((found[1].centre[1] - 6.0 / 8.0).abs() < 1e-12, "{found:?}");
        assert_eq!(parts(&field, 5.0, &places, &[1.0; 45], 0.0).len(), 3);
        assert!(parts(&field, 0.5, &places, &[1.0; 45], 0.0).is_empty());
    }
}
