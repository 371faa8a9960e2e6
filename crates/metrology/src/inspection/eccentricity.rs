//! How far the axis of the measurement was from that of the teeth, from the pitch of both flanks
//! (`docs/mathematics/inspection.md#pitch-run-out-eccentricity`).
//!
//! An eccentricity is a clamping error: no correction of the process removes it.

use super::InspectionError;
use super::harmonic::angles;
use super::pitch::complete;
use foundation::geometry::{Flank, Gear, Sides};
use foundation::numerics::extremes;
use std::f64::consts::PI;

/// What an eccentricity acts on. rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankAngles {
    /// alpha_t: transverse pressure angle at the reference circle, rad; < 0 for an internal gear, whose flanks lean the other way.
    pub pressure_angle: f64,
    /// sigma: half angle of a tooth at the reference circle, rad.
    pub half_tooth_angle: f64,
}

/// Eccentricity of a gear on its measuring axis. mm; tooth z lies on +x.
#[derive(Clone, Debug, PartialEq)]
pub struct Eccentricity {
    /// e_x, mm.
    pub x: f64,
    /// e_y, mm.
    pub y: f64,
    /// Fp_i without it, mm, their mean 0.
    pub cumulative_without: Sides<Vec<f64>>,
}

impl FlankAngles {
    /// Of a cylindrical gear with equal profile angles.
    pub fn of(gear: &Gear) -> Self {
        Self {
            pressure_angle: gear.external_sign() * gear.transverse_pressure_angle(Flank::Left),
            half_tooth_angle: PI / gear.tooth_count() - gear.pitch_space_half_angle(Flank::Left),
        }
    }

    /// Effects of e_x and e_y on Fp_i at the tooth of angle theta.
    fn effect(&self, flank: Flank, theta: f64) -> [f64; 2] {
        let (sin, cos) = (theta + flank.sign() * (self.half_tooth_angle - self.pressure_angle)).sin_cos();
        [-sin, cos].map(|x| x / self.pressure_angle.cos())
    }
}

impl Eccentricity {
    /// e, mm.
    pub fn amount(&self) -> f64 {
        self.x.hypot(self.y)
    }

    /// Direction of e from +x, rad.
    pub fn direction(&self) -> f64 {
        self.y.atan2(self.x)
    }

    /// Fp without the eccentricity, mm.
    pub fn total_without(&self) -> Sides<f64> {
        self.cumulative_without.map(|_, values| {
            let [least, greatest] = extremes(values.iter().copied());
            greatest - least
        })
    }
}

/// Eccentricity by least squares over the cumulative pitch deviations Fp_i of both flanks, mm, tooth 1 first.
///
/// # Errors
/// [`InspectionError::TooFewTeeth`], [`InspectionError::PitchIncomplete`].
pub fn eccentricity(
    cumulative: &Sides<Vec<f64>>,
    flanks: &FlankAngles,
) -> Result<Eccentricity, InspectionError> {
    let teeth = cumulative.left.len();
    // Over whole revolutions sine, cosine and constants are orthogonal: each column's share stands alone.
    let squares = teeth as f64 / flanks.pressure_angle.cos().powi(2);
    let mut found = [0.0; 2];
    for (flank, values) in cumulative.iter() {
        complete(values, teeth)?;
        for (theta, value) in angles(teeth).zip(values) {
            let effect = flanks.effect(flank, theta);
            (0..2).for_each(|k| found[k] += effect[k] * value / squares);
        }
    }
    let [x, y] = found;
    let cumulative_without = cumulative.map(|flank, values| {
        let mean = values.iter().sum::<f64>() / teeth as f64;
        let without = angles(teeth).zip(values).map(|(theta, value)| {
            let effect = flanks.effect(flank, theta);
            value - mean - effect[0] * x - effect[1] * y
        });
        without.collect()
    });
    Ok(Eccentricity { x, y, cumulative_without })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inspection::{BallContact, run_out_from_pitch};
    use foundation::geometry::GearData;
    use foundation::numerics::{bisect, wrapped_angle};

    const TEETH: u32 = 24;

    fn gear(sign: i32) -> Gear {
        Gear::new(GearData {
            teeth: sign * TEETH as i32,
            normal_module: 3.0,
            pressure_angle: Sides::both(20f64.to_radians()),
            helix_angle: 20f64.to_radians(),
            profile_shift: 0.2,
            cone_angle: 0.0,
        })
        .unwrap()
    }

    /// Fp_i on the reference circle about an axis beside that of the gear: exact intersections of shifted flanks.
    fn shifted(gear: &Gear, e: [f64; 2]) -> Sides<Vec<f64>> {
        let radius = gear.pitch_radius();
        Sides::from_fn(|side| {
            let flank = gear.flank(side);
            // The tooth beside space 0, turned to +x.
            let tooth_at = PI / 2.0 - side.sign() * PI / gear.tooth_count();
            let angle = |theta: f64, e: [f64; 2]| {
                let point = |w: f64| {
                    let p = flank.point(w, 0.0);
                    let (sin, cos) = (theta - tooth_at).sin_cos();
                    [p.x * cos - p.y * sin + e[0], p.x * sin + p.y * cos + e[1]]
                };
                let w = bisect(1.0, 30.0, |w| point(w)[0].hypot(point(w)[1]) - radius).unwrap();
                point(w)[1].atan2(point(w)[0])
            };
            let moved = |theta| radius * wrapped_angle(angle(theta, e) - angle(theta, [0.0; 2]));
            let last = moved(0.0);
            angles(TEETH as usize).map(|theta| moved(theta) - last).collect()
        })
    }

    #[test]
    fn a_shifted_gear_shows_its_eccentricity() {
        for gear in [gear(1), gear(-1)] {
            let flanks = FlankAngles::of(&gear);
            let cumulative = shifted(&gear, [4e-3, -7e-3]);
            let found = eccentricity(&cumulative, &flanks).unwrap();
            assert!(
                (found.x - 4e-3).abs() < 1e-8 && (found.y + 7e-3).abs() < 1e-8,
                "{} {}",
                found.x,
                found.y
            );
            assert!((found.amount() - 65f64.sqrt() * 1e-3).abs() < 1e-8);
            assert!((found.direction() + 7f64.atan2(4.0)).abs() < 1e-5);
            for (_, total) in found.total_without().iter() {
                // What stays is of second order.
                assert!(*total < 4e-6, "{total}");
            }
        }
    }

    #[test]
    fn a_ball_runs_out_by_twice_the_eccentricity() {
        let gear = gear(1);
        let cumulative = shifted(&gear, [0.0, 6e-3]);
        let of = |ball| run_out_from_pitch(&cumulative, &BallContact::of(&gear, ball).unwrap()).unwrap();
        // Nearly: the pitch was measured on the reference circle, the ball touches farther out.
        let run_out = of(5.25);
        assert!((run_out.total - 12e-3).abs() < 1.2e-3, "{}", run_out.total);
        assert_eq!((run_out.of_space.len(), run_out.warning), (TEETH as usize, None));
        assert!(run_out.of_space.iter().sum::<f64>().abs() < 1e-15);
        // The space beyond tooth 6 lies half a pitch behind +y, where the ball goes farthest out.
        let farthest =
            (0..TEETH as usize).max_by(|a, b| run_out.of_space[*a].total_cmp(&run_out.of_space[*b]));
        assert!([4, 5].contains(&farthest.unwrap()), "{farthest:?}");
    }

    #[test]
    fn half_a_pitch_table_is_refused() {
        let flanks = FlankAngles { pressure_angle: 0.4, half_tooth_angle: 0.1 };
        let table = Sides { left: vec![0.0; 8], right: vec![0.0; 7] };
        assert_eq!(eccentricity(&table, &flanks).unwrap_err().code(), "pitch-incomplete");
        let ball = BallContact::of(&gear(1), 5.25).unwrap();
        assert_eq!(run_out_from_pitch(&table, &ball).unwrap_err().code(), "pitch-incomplete");
        let few = Sides::both(vec![0.0; 4]);
        assert_eq!(run_out_from_pitch(&few, &ball).unwrap_err().code(), "too-few-teeth");
        let internal = BallContact { internal: true, ..ball };
        let warned = run_out_from_pitch(&Sides::both(vec![0.0; 8]), &internal).unwrap().warning;
        assert_eq!(warned.unwrap().code(), "run-out-of-internal-gear");
    }
}
