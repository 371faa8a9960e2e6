//! Pitch and run-out over the teeth.

use super::Filling;
use super::head::direction;
use crate::page::sheet::{RunOutStrip, SheetPitch, SheetPitchFlank, SheetValue};
use foundation::geometry::{Flank, Sides};
use metrology::inspection::{Harmonic, ToleranceQuantity};
use report::charts::format_fixed;

impl Filling<'_> {
    pub(super) fn pitch(&self) -> SheetPitch {
        let measured = self.inspection.pitch.as_ref();
        let words = [
            measured.and_then(|pitch| pitch.diameter_mm).map(|d| format!("on d = {} mm", format_fixed(d, 3))),
            measured
                .and_then(|pitch| pitch.counting)
                .map(|counting| format!("teeth {}", direction(counting))),
            measured.map(|_| "Fp against the last tooth; dashed: eccentricity".to_owned()),
        ];
        SheetPitch {
            words: words.into_iter().flatten().collect::<Vec<String>>().join("; "),
            flanks: Sides::from_fn(|flank| self.pitch_of(flank)),
            run_out: self.run_out(),
        }
    }

    fn pitch_of(&self, flank: Flank) -> Option<SheetPitchFlank> {
        let measured = self.inspection.pitch.as_ref()?.flanks[flank].as_ref()?;
        let pitch = self.gear.pitch.as_ref();
        let of = pitch.and_then(|pitch| pitch.flanks[flank].as_ref());
        let um = |list: &[f64]| list.iter().map(|mm| 1e3 * mm).collect::<Vec<f64>>();
        let single_um: Vec<f64> = measured.fp_um.iter().copied().map(no_infinity).collect();
        let cumulative_um = match of {
            Some(of) => um(&of.cumulative),
            None if measured.cumulative_um.len() == single_um.len() => {
                measured.cumulative_um.iter().copied().map(no_infinity).collect()
            }
            None => Vec::new(),
        };
        let eccentric = pitch.and_then(|pitch| pitch.eccentricity.as_ref());
        let eccentric_um = match (of, eccentric) {
            (Some(of), Some(found)) => {
                let without = &found.cumulative_without[flank];
                of.cumulative.iter().zip(without).map(|(with, without)| 1e3 * (with - without)).collect()
            }
            _ => Vec::new(),
        };
        let value = |symbol: &str, mm: Option<f64>| SheetValue::new(symbol, mm.map(|mm| 1e3 * mm), "µm", 1);
        use metrology::inspection::ToleranceQuantity as Q;
        let mut values = vec![
            self.judged("f_p", Q::SinglePitch, of.map(|p| p.single)),
            value("f_u", of.map(|p| p.neighbours)),
            value("R_p", pitch.and_then(|pitch| pitch.printed_range[flank])),
            self.judged("F_p", Q::TotalPitch, of.map(|p| p.total)),
            value("F_pk", of.map(|p| p.sector)),
        ];
        if let Some(found) = eccentric {
            values.push(value("F_p − e", Some(found.total_without()[flank])));
        }
        let sector = of.map(|of| [of.sector_pitches, worst_sector(&single_um, of.sector_pitches)]);
        Some(SheetPitchFlank { single_um, cumulative_um, eccentric_um, sector, values })
    }

    fn run_out(&self) -> RunOutStrip {
        let pitch = self.gear.pitch.as_ref();
        let found = pitch.and_then(|pitch| pitch.run_out.as_ref());
        let stated = self.inspection.run_out.as_ref();
        let of_space_um: Vec<f64> = match (found, stated) {
            (Some(found), _) => found.of_space.iter().map(|mm| 1e3 * mm).collect(),
            (None, Some(stated)) => stated.fr_um.iter().copied().map(no_infinity).collect(),
            (None, None) => Vec::new(),
        };
        let whole = of_space_um.len() > 2 && of_space_um.iter().all(|v| v.is_finite());
        let eccentric_um =
            if whole { Harmonic::of(&of_space_um).values(of_space_um.len()) } else { Vec::new() };
        let mut values = vec![self.judged("F_r", ToleranceQuantity::RunOut, found.map(|r| r.total))];
        if found.is_none() && whole {
            let [least, greatest] = foundation::numerics::extremes(of_space_um.iter().copied());
            values[0] = self.judged("F_r", ToleranceQuantity::RunOut, Some(1e-3 * (greatest - least)));
        }
        let range = pitch.and_then(|pitch| pitch.thickness_variation);
        values.push(SheetValue::new("R_s", range.map(|mm| 1e3 * mm), "µm", 1));
        if let Some(e) = pitch.and_then(|pitch| pitch.eccentricity.as_ref()) {
            values.push(SheetValue::new("e", Some(1e3 * e.amount()), "µm", 1));
            values.push(SheetValue::new("e from +x", Some(e.direction().to_degrees()), "°", 1));
        }
        RunOutStrip { of_space_um, eccentric_um, values }
    }
}

/// What is no number of a measurement leaves a gap.
fn no_infinity(value: f64) -> f64 {
    if value.abs() < 1e9 { value } else { f64::NAN }
}

/// Behind which tooth the sector of so many pitches with the largest deviation begins.
fn worst_sector(single: &[f64], pitches: usize) -> usize {
    let teeth = single.len();
    let mut sums = vec![0.0];
    for k in 0..2 * teeth {
        sums.push(sums[k] + single[k % teeth]);
    }
    let size = |behind: usize| (sums[behind + pitches] - sums[behind]).abs();
    (0..teeth).fold(0, |worst, behind| if size(behind) > size(worst) + 1e-9 { behind } else { worst })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_sector_may_pass_the_last_tooth() {
        assert_eq!(worst_sector(&[3.0, -1.0, 2.0, -5.0, 0.0, 1.0], 2), 3);
        assert_eq!(worst_sector(&[3.0, -1.0, -4.0, 0.0, -1.0, 3.0], 2), 5);
        assert_eq!(worst_sector(&[0.0; 5], 2), 0);
    }
}
