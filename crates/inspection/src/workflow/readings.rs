//! Lines of a tooth flank that were measured more than once: every reading holds each line once at the most. Knows no values.

use measured_files::inspection::{Trace, TraceKind};
use std::collections::BTreeMap;

/// Lines nearer than this lie at the same place, mm.
pub(super) const SAME_PLACE: f64 = 1e-3;

/// Splits lines of one tooth flank into readings, in their order: a line that was measured again belongs to the next one.
pub(super) fn readings<T>(lines: impl IntoIterator<Item = T>, trace: impl Fn(&T) -> &Trace) -> Vec<Vec<T>> {
    let mut seen: Vec<(TraceKind, f64, usize)> = Vec::new();
    let mut readings: Vec<Vec<T>> = Vec::new();
    for line in lines {
        let (kind, position) = (trace(&line).kind, trace(&line).position_mm);
        let known = seen.iter_mut().find(|(k, p, _)| *k == kind && (p - position).abs() < SAME_PLACE);
        let turn = match known {
            Some((.., times)) => {
                *times += 1;
                *times
            }
            None => {
                seen.push((kind, position, 0));
                0
            }
        };
        if readings.len() <= turn {
            readings.push(Vec::new());
        }
        readings[turn].push(line);
    }
    readings
}

/// The mean of the values of every tooth, by tooth: teeth count once each, however often they were measured.
pub(super) fn means_of_teeth(values: impl IntoIterator<Item = (u32, f64)>) -> Vec<f64> {
    let mut teeth: BTreeMap<u32, Vec<f64>> = BTreeMap::new();
    for (tooth, value) in values {
        teeth.entry(tooth).or_default().push(value);
    }
    teeth.into_values().map(|values| values.iter().sum::<f64>() / values.len() as f64).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::Flank;
    use measured_files::inspection::Zero;

    #[test]
    fn a_line_that_is_measured_again_belongs_to_the_next_reading() {
        let line = |kind, position_mm: f64| Trace {
            kind,
            tooth: 1,
            flank: Flank::Left,
            tag: String::new(),
            position_mm,
            abscissa_mm: Vec::new(),
            f_um: Vec::new(),
            zero: Zero::Free,
        };
        let lines = [
            line(TraceKind::Profile, 0.0),
            line(TraceKind::Helix, 0.0),
            line(TraceKind::Profile, 5.0),
            line(TraceKind::Profile, 1e-5),
            line(TraceKind::Profile, -1e-5),
            line(TraceKind::Helix, 0.0),
        ];
        let found = readings(lines.iter().enumerate(), |(_, line)| line);
        let numbers: Vec<Vec<usize>> =
            found.iter().map(|r| r.iter().map(|(number, _)| *number).collect()).collect();
        assert_eq!(numbers, [vec![0, 1, 2], vec![3, 5], vec![4]]);
    }
}
