//! Run-out that a ball would show, from the pitch of both flanks (`docs/mathematics/inspection.md#pitch-run-out-eccentricity`).

use super::pitch::complete;
use super::{InspectionError, InspectionWarning};
use foundation::geometry::{Flank, Gear, Sides};
use foundation::numerics::extremes;

/// Where a ball touches in the spaces of a gear. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallContact {
    /// d: reference diameter (not that of the pitch measurement), mm.
    pub reference_diameter: f64,
    /// d_K: diameter of the circle of the ball's centres, mm.
    pub centre_diameter: f64,
    /// alpha_K: transverse pressure angle there, rad.
    pub pressure_angle: f64,
    /// Whether the gear is internal.
    pub internal: bool,
}

/// Run-out. mm
#[derive(Clone, Debug, PartialEq)]
pub struct RunOut {
    /// Fr_i: radial position of the ball in each space less the mean; space i follows tooth i.
    pub of_space: Vec<f64>,
    /// Fr: greatest less least.
    pub total: f64,
    /// Reservation about the sign rule of internal gears.
    pub warning: Option<InspectionWarning>,
}

impl BallContact {
    /// Of a ball of this diameter, mm, in a gear with its measured profile shift.
    ///
    /// # Errors
    /// Those of [`Gear::over_balls`].
    pub fn of(gear: &Gear, ball: f64) -> Result<Self, InspectionError> {
        let radius = gear.over_balls(ball, 0.0)?.centre_radius;
        Ok(Self {
            reference_diameter: 2.0 * gear.pitch_radius(),
            centre_diameter: 2.0 * radius,
            pressure_angle: (gear.flank(Flank::Left).base_radius / radius).acos(),
            internal: gear.external_sign() < 0.0,
        })
    }
}

/// Run-out from the cumulative pitch deviations Fp_i of both flanks, mm, tooth 1 first.
///
/// # Errors
/// [`InspectionError::TooFewTeeth`], [`InspectionError::PitchIncomplete`].
pub fn run_out_from_pitch(
    cumulative: &Sides<Vec<f64>>,
    ball: &BallContact,
) -> Result<RunOut, InspectionError> {
    let teeth = cumulative.left.len();
    complete(&cumulative.left, teeth)?;
    complete(&cumulative.right, teeth)?;
    // A space lies between the left flank of its tooth and the right flank of the next.
    let next = cumulative.right.iter().cycle().skip(1);
    let narrowing: Vec<f64> = cumulative.left.iter().zip(next).map(|(left, right)| left - right).collect();
    let factor = ball.centre_diameter / (2.0 * ball.reference_diameter * ball.pressure_angle.tan());
    let mean = narrowing.iter().sum::<f64>() / teeth as f64;
    let of_space: Vec<f64> = narrowing.iter().map(|e| factor * (e - mean)).collect();
    let [least, greatest] = extremes(of_space.iter().copied());
    let warning = ball.internal.then_some(InspectionWarning::RunOutOfInternalGear);
    Ok(RunOut { of_space, total: greatest - least, warning })
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::GearData;

    #[test]
    fn a_ball_stands_out_of_a_narrow_space_as_it_does_of_a_gear_of_narrow_spaces() {
        let gear = |profile_shift| {
            Gear::new(GearData {
                teeth: 31,
                normal_module: 2.5,
                pressure_angle: Sides::both(20f64.to_radians()),
                helix_angle: 15f64.to_radians(),
                profile_shift,
                cone_angle: 0.0,
            })
            .unwrap()
        };
        let (wide, narrow) = (gear(0.3), gear(0.3 + 1e-4));
        // Arc by which a space is narrower on the reference circle, on both flanks together.
        let half_angle = |gear: &Gear| gear.pitch_space_half_angle(Flank::Left);
        let arc = 2.0 * wide.pitch_radius() * (half_angle(&wide) - half_angle(&narrow));
        let radius = |gear: &Gear| gear.over_balls(4.5, 0.0).unwrap().centre_radius;
        let out = radius(&narrow) - radius(&wide);
        // The left flank of tooth 7 stands into its space.
        let mut table = Sides::both(vec![0.0; 31]);
        table.left[6] = arc;
        let run_out = run_out_from_pitch(&table, &BallContact::of(&wide, 4.5).unwrap()).unwrap();
        assert!((run_out.total / out - 1.0).abs() < 1e-3, "{} {out}", run_out.total);
        let farthest = (0..31).max_by(|a, b| run_out.of_space[*a].total_cmp(&run_out.of_space[*b]));
        assert_eq!(farthest, Some(6));
        // The right flank of tooth 8 standing back widens the same space.
        let mut table = Sides::both(vec![0.0; 31]);
        table.right[7] = arc;
        let run_out = run_out_from_pitch(&table, &BallContact::of(&wide, 4.5).unwrap()).unwrap();
        let nearest = (0..31).min_by(|a, b| run_out.of_space[*a].total_cmp(&run_out.of_space[*b]));
        assert_eq!(nearest, Some(6));
    }
}
