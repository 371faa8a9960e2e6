//! Tables of a file: pitches of a flank side, positions of the probe, circles, printed values.

use super::super::tables::ProbePosition;
use super::number::{leading_numbers, number, only_numbers};
use super::{Circles, PitchRow};
use foundation::geometry::Flank;

/// What a printed value is replaced by: not measured, not available.
const NO_VALUE: [f64; 2] = [-9999.0, 8999.0];

/// The columns that a table of pitches has.
pub(super) const PITCH_COLUMNS: [&str; 3] = ["fp", "Fp", "Fr"];

/// `linke Zahnflanke` or `rechte Zahnflanke`.
pub(super) fn pitch_heading(line: &str) -> Option<Flank> {
    let mut words = line.split_whitespace();
    let flank = match (words.next()?, words.next()?) {
        ("linke", "Zahnflanke") => Flank::Left,
        ("rechte", "Zahnflanke") => Flank::Right,
        _ => return None,
    };
    words.next().is_none().then_some(flank)
}

/// Column titles of a table of pitches, behind `Zahn-Nr.`; each one of the known ones.
pub(super) fn pitch_columns(line: &str) -> Option<Vec<usize>> {
    let mut words = line.split_whitespace();
    if words.next()? != "Zahn-Nr." {
        return None;
    }
    let columns: Option<Vec<usize>> =
        words.map(|word| PITCH_COLUMNS.iter().position(|title| *title == word)).collect();
    columns.filter(|list| !list.is_empty())
}

/// A row of a table of pitches; `defined` turns the value for undefined into NaN.
pub(super) fn pitch_row(line: &str, columns: &[usize], defined: impl Fn(f64) -> f64) -> Option<PitchRow> {
    let numbers = only_numbers(line)?;
    let (tooth, values) = numbers.split_first()?;
    if values.len() != columns.len() {
        return None;
    }
    let mut of = [f64::NAN; 3];
    for (column, value) in columns.iter().zip(values) {
        of[*column] = defined(*value);
    }
    Some(PitchRow { tooth: whole(*tooth)?, fp: of[0], cumulative: of[1], run_out: of[2] })
}

/// `Teilung:` and the titles of its columns.
pub(super) fn is_position_heading(line: &str) -> bool {
    line.trim() == "Teilung:"
}

/// `Z-Nr. Seite PHI X Y Z`.
pub(super) fn is_position_titles(line: &str) -> bool {
    line.split_whitespace().eq(["Z-Nr.", "Seite", "PHI", "X", "Y", "Z"])
}

/// A row of probe positions.
pub(super) fn position_row(line: &str) -> Option<ProbePosition> {
    let mut words = line.split_whitespace();
    let tooth = whole(number(words.next()?)?)?;
    let flank = match words.next()? {
        "L" => Flank::Left,
        "R" => Flank::Right,
        _ => return None,
    };
    let rest: Option<Vec<f64>> = words.map(number).collect();
    let [angle_deg, x, y, z] = rest?.try_into().ok()?;
    Some(ProbePosition { number: tooth, flank, angle_deg, centre_mm: [x, y, z] })
}

/// `Fusskreisdurchmesser / Hoehe : 8.5` with whatever became of sharp s and umlaut; the diameters follow in lines of their own.
pub(super) fn circle_heading(line: &str) -> Option<Circles> {
    let (title, height) = line.trim().rsplit_once(':')?;
    let (word, behind) = title.split_once('/')?;
    if !behind.trim_start().starts_with('H') {
        return None;
    }
    let start = word.trim_end().strip_suffix("kreisdurchmesser")?;
    let tip = match start {
        "Kopf" => true,
        start if start.starts_with("Fu") && start.chars().count() <= 5 => false,
        _ => return None,
    };
    Some(Circles { tip, height_mm: *leading_numbers(height).first()?, diameters_mm: Vec::new() })
}

/// `10111 : label : 12.5`: the code and the value, `None` where there is none.
pub(super) fn result(line: &str) -> Option<(u32, Option<f64>)> {
    let (code, rest) = line.trim().split_once(':')?;
    let code = code.trim_end();
    if code.len() != 5 || !code.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let (_, value) = rest.split_once(':')?;
    let value = number(value.trim())?;
    Some((code.parse().ok()?, Some(value).filter(|v| !NO_VALUE.contains(v))))
}

/// A number of a tooth.
fn whole(value: f64) -> Option<u32> {
    (value >= 0.0 && value <= f64::from(u32::MAX) && value.fract() == 0.0).then_some(value as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_pitches_follow_their_titles() {
        assert_eq!(pitch_heading("   linke Zahnflanke   "), Some(Flank::Left));
        assert_eq!(pitch_heading("rechte Zahnflanke x"), None);
        assert_eq!(pitch_columns(" Zahn-Nr.  fp  Fp  Fr"), Some(vec![0, 1, 2]));
        assert_eq!(pitch_columns(" Zahn-Nr.  fp  Fx"), None);
        let row = pitch_row(" 2 -.5 8", &[0, 2], |v| if v == 8.0 { f64::NAN } else { v }).unwrap();
        assert_eq!((row.tooth, row.fp), (2, -0.5));
        assert!(row.cumulative.is_nan() && row.run_out.is_nan());
        for line in ["2 1", "2.5 1 2", "-1 1 2", "2 1 2 3", "x 1 2"] {
            assert_eq!(pitch_row(line, &[0, 1], |v| v), None, "{line}");
        }
    }

    #[test]
    fn circles_survive_lost_letters() {
        for line in ["Fußkreisdurchmesser / Höhe :     8.500", "Fu\u{fffd}kreisdurchmesser / H?he : 8.5"] {
            let circle = circle_heading(line).unwrap();
            assert!(!circle.tip && circle.height_mm == 8.5);
        }
        assert!(circle_heading("Kopfkreisdurchmesser / Höhe : 1").unwrap().tip);
        assert_eq!(circle_heading("27 :Kopfkreisdurchmesser da ......  [mm]....: 52.924"), None);
    }

    #[test]
    fn positions_and_values() {
        let row = position_row("  2   L     -3.2133     -.1200    25.5256    87.2284").unwrap();
        assert_eq!((row.number, row.flank, row.angle_deg), (2, Flank::Left, -3.2133));
        assert_eq!(row.centre_mm, [-0.12, 25.5256, 87.2284]);
        assert_eq!(position_row("2 L 1 2 3"), None);
        assert_eq!(result("26511 : Fuß  u 1u            :-9999.0"), Some((26511, None)));
        assert_eq!(result("26450 : V Fuß                : 8999.0"), Some((26450, None)));
        assert_eq!(result("34610 : WK                   :   16.826"), Some((34610, Some(16.826))));
        for line in ["3461 : WK : 1", "34610 : WK : x", "34610 : WK", "346101 : WK : 1"] {
            assert_eq!(result(line), None, "{line}");
        }
    }
}
