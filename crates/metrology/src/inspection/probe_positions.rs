//! Pitch of both flanks from the raw positions of the probe (`docs/mathematics/inspection.md#pitch-run-out-eccentricity`).

use super::error::usable;
use super::pitch::complete;
use super::{InspectionError, PitchDeviations};
use foundation::geometry::{Flank, Gear, Sides};
use foundation::numerics::wrapped_angle;
use std::f64::consts::TAU;

/// Where the probe touched a tooth. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProbePosition {
    /// Flank.
    pub flank: Flank,
    /// Number in the list of positions (Z-Nr), which runs against that of the pitch table.
    pub number: usize,
    /// Angle of the rotary table, rad.
    pub table_angle: f64,
    /// X of the ball's centre, mm.
    pub x: f64,
    /// Y of the ball's centre, mm.
    pub y: f64,
}

/// Pitch deviations on a circle of `diameter`, mm, from the positions of all teeth on both flanks. Teeth are those of the pitch table,
/// which counts counter-clockwise seen from +z; > 0: displaced in that direction.
///
/// # Errors
/// [`InspectionError::UnverifiedSetting`] for an internal gear; [`InspectionError::PitchIncomplete`] unless every tooth was touched once
/// on either flank, [`InspectionError::TooFewTeeth`], [`InspectionError::InvalidNumber`], [`InspectionError::BelowBaseCircle`].
pub fn pitch_from_positions(
    positions: &[ProbePosition],
    gear: &Gear,
    diameter: f64,
) -> Result<Sides<PitchDeviations>, InspectionError> {
    if gear.external_sign() < 0.0 {
        return Err(InspectionError::UnverifiedSetting { setting: "probing of an internal gear" });
    }
    usable("diameter of the pitch measurement", diameter, diameter > 0.0, "> 0 mm")?;
    let teeth = gear.data().teeth.unsigned_abs() as usize;
    Sides::try_from_fn(|flank| {
        let of_flank = positions.iter().filter(|p| p.flank == flank).copied().collect();
        PitchDeviations::from_cumulative(&cumulative(of_flank, gear, diameter)?, teeth)
    })
}

/// Fp_i of one flank, mm, tooth 1 first.
fn cumulative(
    mut positions: Vec<ProbePosition>,
    gear: &Gear,
    diameter: f64,
) -> Result<Vec<f64>, InspectionError> {
    let teeth = gear.data().teeth.unsigned_abs() as usize;
    positions.sort_by(|a, b| b.table_angle.total_cmp(&a.table_angle));
    let mut of_tooth = vec![f64::NAN; teeth];
    let mut first = None;
    for (j, position) in positions.iter().enumerate() {
        let angle = tooth_angle(position, gear)? - TAU * j as f64 / teeth as f64;
        let error = wrapped_angle(angle - *first.get_or_insert(angle));
        // Tooth (2 - number) modulo z, of which tooth z is the last.
        let tooth = (teeth + 1 - position.number % teeth) % teeth;
        of_tooth[tooth] = -diameter / 2.0 * error;
    }
    if positions.len() > teeth {
        return Err(InspectionError::PitchIncomplete { found: positions.len(), teeth });
    }
    complete(&of_tooth, teeth)?;
    let last = of_tooth[teeth - 1];
    Ok(of_tooth.iter().map(|f| f - last).collect())
}

/// Angle of the involute's origin in the gear, clockwise, rad; that of the ball's offset curve differs by the same for all teeth.
fn tooth_angle(position: &ProbePosition, gear: &Gear) -> Result<f64, InspectionError> {
    for (field, value) in [("X", position.x), ("Y", position.y), ("table angle", position.table_angle)] {
        usable(field, value, true, "a finite number")?;
    }
    let flank = gear.flank(position.flank);
    let (radius, base) = (position.x.hypot(position.y), flank.base_radius);
    if radius < base {
        let (diameter, base_diameter) = (2.0 * radius, 2.0 * base);
        return Err(InspectionError::BelowBaseCircle { flank: position.flank, diameter, base_diameter });
    }
    let roll = ((radius - base) * (radius + base)).sqrt() / base;
    Ok(position.x.atan2(position.y) - position.table_angle - flank.s() * (roll - roll.atan()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::GearData;

    const TEETH: usize = 17;

    fn gear() -> Gear {
        Gear::new(GearData {
            teeth: TEETH as i32,
            normal_module: 2.0,
            pressure_angle: Sides::both(20f64.to_radians()),
            helix_angle: 0.0,
            profile_shift: 0.1,
            cone_angle: 0.0,
        })
        .unwrap()
    }

    /// Wanted Fp_i, mm: 0 at the last tooth.
    fn wanted(flank: Flank, tooth: usize) -> f64 {
        let t = (tooth % TEETH) as f64;
        5e-3 * (t * (1.0 + 0.3 * flank.sign())).sin()
    }

    /// A ball on the flanks of a gear with these deviations, at other heights of each tooth, with a table that turns unevenly.
    fn probed(diameter: f64) -> Vec<ProbePosition> {
        let gear = gear();
        let mut positions = Vec::new();
        for flank in Flank::BOTH {
            for j in 0..TEETH {
                // The table's tooth j + 1 counts against the sense in which the gear is turned.
                let (number, tooth) = (j + 1, (2 * TEETH - j) % TEETH + 1);
                let f = gear.flank(flank);
                let w = 5.0 + 0.01 * (3.0 * j as f64).sin();
                let centre = f.point(w, 0.0) + 0.75 * f.normal(w, 0.0);
                let share = TAU * j as f64 / TEETH as f64;
                let table_angle = 1e-3 * (j as f64).cos() - share;
                // Turned clockwise by the table and the tooth's place, counter-clockwise by its deviation.
                let turn = table_angle + share - wanted(flank, tooth) / (diameter / 2.0);
                let (sin, cos) = turn.sin_cos();
                let (x, y) = (centre.x * cos + centre.y * sin, centre.y * cos - centre.x * sin);
                positions.push(ProbePosition { flank, number, table_angle, x, y });
            }
        }
        positions
    }

    #[test]
    fn the_pitch_of_a_probed_gear_is_found() {
        let mut positions = probed(34.0);
        positions.reverse(); // their order does not matter
        let found = pitch_from_positions(&positions, &gear(), 34.0).unwrap();
        for (flank, deviations) in found.iter() {
            for (k, fp) in deviations.cumulative().iter().enumerate() {
                let want = wanted(flank, k + 1);
                assert!((fp - want).abs() < 1e-12, "{flank} tooth {}: {fp} {want}", k + 1);
            }
        }
    }

    #[test]
    fn missing_and_doubled_teeth_are_told() {
        let code =
            |positions: &[ProbePosition]| pitch_from_positions(positions, &gear(), 34.0).unwrap_err().code();
        let all = probed(34.0);
        assert_eq!(code(&all[1..]), "pitch-incomplete");
        assert_eq!(code(&[]), "pitch-incomplete");
        let changed = |change: &dyn Fn(&mut ProbePosition)| {
            let mut positions = all.clone();
            change(&mut positions[3]);
            positions
        };
        assert_eq!(code(&changed(&|p| p.number = 1)), "pitch-incomplete");
        assert_eq!(code(&changed(&|p| p.x = f64::NAN)), "invalid-number");
        assert_eq!(code(&changed(&|p| p.y = 1.0)), "below-base-circle");
        let doubled: Vec<ProbePosition> = all.iter().chain(&all[..1]).copied().collect();
        assert_eq!(code(&doubled), "pitch-incomplete");
    }
}
