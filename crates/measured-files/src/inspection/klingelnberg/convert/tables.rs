//! Pitches, run-out, thickness, circles and printed values of the files.

use super::super::PitchRow;
use super::super::settings::Settings;
use super::{Place, defined, plausible_values};

use crate::inspection::{
    Characteristic, Circle, Circles, Conditions, FlankPitch, InspectionError, InspectionWarning, Pitch,
    Quantity, ResultCode, RunOut, Size, Thickness, TraceKind, WarningKind,
};
use foundation::geometry::{Flank, Sides};

impl Place<'_> {
    fn teeth(&self) -> usize {
        self.gear.teeth.unsigned_abs() as usize
    }

    pub fn pitch(&self, settings: &Settings, warnings: &mut Vec<InspectionWarning>) -> Option<Pitch> {
        let flanks = Sides::from_fn(|flank| self.flank_pitch(flank, warnings));
        let positions = self.file.positions.clone();
        let any = flanks.left.is_some() || flanks.right.is_some() || !positions.is_empty();
        any.then(|| Pitch {
            flanks,
            diameter_mm: self.number(47).filter(|d| *d > 0.0),
            counting: settings.counting,
            positions,
        })
    }

    /// The rows of a side, each at its tooth; what has no row stays undefined.
    fn flank_pitch(&self, flank: Flank, warnings: &mut Vec<InspectionWarning>) -> Option<FlankPitch> {
        let rows = &self.file.pitch[flank];
        if rows.is_empty() {
            return None;
        }
        let by_tooth = self.by_tooth(rows);
        let filled = by_tooth.iter().flatten().count();
        if filled != self.teeth() || rows.len() != self.teeth() {
            let message = format!(
                "the {flank} flanks have {} rows of pitches for {filled} of {} teeth; the last row of a tooth holds",
                rows.len(),
                self.teeth()
            );
            warnings.push(InspectionWarning::new(WarningKind::PitchIncomplete, message));
        }
        let mut of = |value: fn(&PitchRow) -> f64| {
            let values = by_tooth.iter().map(|row| row.as_ref().map_or(f64::NAN, value));
            plausible_values(values, &format!("the pitches of the {flank} flanks"), None, warnings)
        };
        Some(FlankPitch { fp_um: of(|row| row.fp), cumulative_um: of(|row| row.cumulative) })
    }

    fn by_tooth(&self, rows: &[PitchRow]) -> Vec<Option<PitchRow>> {
        let mut list = vec![None; self.teeth()];
        for row in rows {
            if let Some(place) = (row.tooth as usize).checked_sub(1).and_then(|k| list.get_mut(k)) {
                *place = Some(*row);
            }
        }
        list
    }

    /// Run-out stands in the tables of both sides, the same values; the first that has one holds.
    pub fn run_out(&self) -> Option<RunOut> {
        let of = |flank: Flank| -> Vec<f64> {
            let rows = self.by_tooth(&self.file.pitch[flank]);
            rows.iter().map(|row| row.as_ref().map_or(f64::NAN, |row| defined(row.run_out))).collect()
        };
        let fr_um = Flank::BOTH.map(of).into_iter().find(|list| list.iter().any(|v| v.is_finite()))?;
        Some(RunOut { fr_um, ball_diameter_mm: self.number(28).filter(|d| *d > 0.0) })
    }

    pub fn thickness(&self) -> Thickness {
        let value = |code: u32| self.file.results.get(&code).copied().flatten();
        let size = |[mean, least, largest]: [u32; 3]| {
            let size = Size { mean_mm: value(mean), least_mm: value(least), largest_mm: value(largest) };
            [size.mean_mm, size.least_mm, size.largest_mm].iter().any(Option::is_some).then_some(size)
        };
        let teeth = self.number(281).filter(|k| k.fract() == 0.0 && (1.0..=1e4).contains(k));
        Thickness {
            span: size([34610, 34910, 35210]),
            span_teeth: teeth.map(|k| k as u32),
            over_balls: size([32810, 33110, 33410]),
            ball_diameter_mm: self.number(28).filter(|d| *d > 0.0),
        }
    }

    pub fn circles(&self) -> Result<Circles, InspectionError> {
        let mut circles = Circles::default();
        for circle in &self.file.circles {
            let found = Circle {
                z_mm: self.height(circle.height_mm)?,
                diameters_mm: circle.diameters_mm.iter().copied().map(defined).collect(),
            };
            let place = if circle.tip { &mut circles.tip } else { &mut circles.root };
            *place = Some(found);
        }
        Ok(circles)
    }

    /// Printed values with the signs and lengths they refer to.
    pub fn results(&self, conditions: &Conditions) -> Vec<Quantity> {
        let quantity = |(&code, &value): (&u32, &Option<f64>)| {
            let meaning = ResultCode::of(code);
            let kind = match meaning.characteristic {
                Characteristic::HelixSlope => Some(TraceKind::Helix),
                Characteristic::ProfileSlope => Some(TraceKind::Profile),
                _ => None,
            };
            let slope = kind.zip(meaning.flank);
            let sigma = slope.and_then(|(kind, flank)| match kind {
                TraceKind::Helix => conditions.flanks[flank].printed_sign,
                TraceKind::Profile => Some(1.0),
            });
            let reference_length_mm = slope.and_then(|(kind, flank)| {
                conditions.reference_length(kind, flank, self.gear.face_width_mm).ok()
            });
            let section = conditions.section;
            Quantity { code, meaning, value, unit: meaning.unit(), sigma, reference_length_mm, section }
        };
        self.file.results.iter().map(quantity).collect()
    }
}
