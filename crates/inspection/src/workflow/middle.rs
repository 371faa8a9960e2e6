//! What holds in the middle of a field, of lines that lie beside each other. Knows no values but places and numbers.

/// A line nearer to the middle than this share of the field stands for it.
const NEAR: f64 = 0.05;

/// The value in the middle of a field from lines (place, value): that of the line that lies there, else between the two beside it, else
/// that of the nearest. `None` without a line.
pub(super) fn at_middle(lines: &[(f64, f64)], [from, to]: [f64; 2]) -> Option<f64> {
    let middle = 0.5 * (from + to);
    let away = |(place, _): &(f64, f64)| (place - middle).abs();
    let nearest = *lines.iter().min_by(|a, b| away(a).total_cmp(&away(b)))?;
    if away(&nearest) <= NEAR * (to - from) {
        return Some(nearest.1);
    }
    let beside = |below: bool| {
        let lines = lines.iter().filter(|(place, _)| (*place < middle) == below);
        lines.min_by(|a, b| away(a).total_cmp(&away(b)))
    };
    Some(match (beside(true), beside(false)) {
        (Some((a, f)), Some((b, g))) => f + (g - f) * (middle - a) / (b - a),
        _ => nearest.1,
    })
}

/// Which of a tooth's lines, ascending by place, is the middle one: `None` of those that lie towards the ends alone. A line by itself is
/// the middle one, unless `all`, the outermost places of all teeth, show it to be an outer one.
pub(super) fn middle_line(places: &[f64], all: [f64; 2]) -> Option<usize> {
    let [first, last] = if places.len() > 1 { [places[0], places[places.len() - 1]] } else { all };
    let half = 0.5 * (first + last);
    let away = |k: &usize| (places[*k] - half).abs();
    let nearest = (0..places.len()).min_by(|a, b| away(a).total_cmp(&away(b)))?;
    (away(&nearest) <= 0.25 * (last - first)).then_some(nearest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_is_that_of_the_field() {
        let field = [-20.0, 20.0];
        assert_eq!(at_middle(&[(-16.0, 1.0), (0.02, 5.0), (16.0, 2.0)], field), Some(5.0));
        assert_eq!(at_middle(&[(-16.0, 1.0), (16.0, 2.0)], field), Some(1.5));
        assert_eq!(at_middle(&[(-16.0, 1.0), (8.0, 4.0)], field), Some(3.0));
        assert_eq!(at_middle(&[(8.0, 4.0), (16.0, 2.0)], field), Some(4.0));
        assert_eq!(at_middle(&[], field), None);
    }

    #[test]
    fn outer_lines_are_no_middle() {
        assert_eq!(middle_line(&[-16.0, 0.02, 16.0], [-16.0, 16.1]), Some(1));
        assert_eq!(middle_line(&[-16.0, 16.0], [-16.0, 16.0]), None);
        assert_eq!(middle_line(&[0.02], [-16.0, 16.0]), Some(0));
        assert_eq!(middle_line(&[15.9], [-16.0, 16.0]), None);
        assert_eq!(middle_line(&[3.0], [3.0, 3.0]), Some(0));
    }
}
