//! Size over rolls: cylinders in two opposite tooth spaces, measured between parallel faces
//! (`docs/mathematics/involute-gears.md#thickness-and-its-measures`).

use super::{Gear, GeometryError};
use std::f64::consts::PI;

/// Size over (internal: between) two rolls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverRolls {
    /// Diameter of the rolls D_M, mm.
    pub roll: f64,
    /// Radius at which the roll's axis passes the axis of the gear, mm.
    pub centre_radius: f64,
    /// M_dR, mm.
    pub size: f64,
    /// Face width that both rolls need to lie opposite each other, mm.
    pub least_face_width: f64,
}

impl Gear {
    /// Size over two rolls of the diameter `roll`.
    ///
    /// A roll touches a space where a ball of its diameter does. On a spur gear the two rolls are parallel to the axis and read what balls
    /// read. On an external helical gear a roll slides along its space: the two are brought opposite each other, which moves them apart along
    /// the axis by half an axial pitch where the number of teeth is odd, and read 2 r_K + D_M.
    ///
    /// # Errors
    /// [`GeometryError::RollsUndefined`] for a conical gear and an internal helical gear, whose spaces take no straight roll;
    /// those of [`Gear::over_balls`].
    pub fn over_rolls(&self, roll: f64) -> Result<OverRolls, GeometryError> {
        let helical = self.data().helix_angle != 0.0;
        let external = self.external_sign() > 0.0;
        if !self.is_cylindrical() {
            return Err(GeometryError::RollsUndefined { reason: "the gear is conical" });
        }
        if helical && !external {
            return Err(GeometryError::RollsUndefined { reason: "the gear is internal and helical" });
        }
        let balls = self.over_balls(roll, 0.0)?;
        if !helical {
            let (centre_radius, size) = (balls.centre_radius, balls.size);
            return Ok(OverRolls { roll, centre_radius, size, least_face_width: 0.0 });
        }
        let odd = self.data().teeth % 2 != 0;
        let axial_pitch = PI * self.data().normal_module / self.data().helix_angle.sin().abs();
        Ok(OverRolls {
            roll,
            centre_radius: balls.centre_radius,
            size: 2.0 * balls.centre_radius + roll,
            least_face_width: if odd { 0.5 * axial_pitch } else { 0.0 },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Flank, GearData, Sides};
    use super::*;

    fn gear(teeth: i32, helix_deg: f64) -> Gear {
        Gear::new(GearData {
            teeth,
            normal_module: 2.0,
            pressure_angle: Sides::both(20f64.to_radians()),
            helix_angle: helix_deg.to_radians(),
            profile_shift: 0.1,
            cone_angle: 0.0,
        })
        .unwrap()
    }

    #[test]
    fn spur_gears_read_what_balls_read() {
        for teeth in [24, 25, -60, -61] {
            let gear = gear(teeth, 0.0);
            let (rolls, balls) = (gear.over_rolls(3.5).unwrap(), gear.over_balls(3.5, 0.0).unwrap());
            assert_eq!((rolls.size, rolls.least_face_width), (balls.size, 0.0), "{teeth}");
        }
    }

    /// Balls centred along the roll's straight axis: none comes nearer to a flank than the one in the middle, which touches both, so the roll
    /// lies in the space without cutting it.
    #[test]
    fn a_straight_roll_lies_in_the_space_of_a_helical_gear() {
        let roll = 3.5;
        for (teeth, helix) in [(25, 31.0), (24, -18.0), (61, 44.0)] {
            let gear = gear(teeth, helix);
            let radius = gear.over_rolls(roll).unwrap().centre_radius;
            let along = (radius * gear.flank(Flank::Left).twist_per_length()).atan();
            let room = |t: f64| {
                let (z, across) = (t * along.cos(), t * along.sin());
                let (r, angle) = (radius.hypot(across), across.atan2(radius));
                // The space at this height, less what the ball takes, to both sides of its middle.
                Flank::BOTH.map(|side| {
                    let f = gear.flank(side);
                    let taken = 0.5 * roll / (f.base_radius * f.base_helix_angle.cos());
                    let half = gear.space_half_angle(side, r, 0.0) - taken;
                    let off = angle - z * f.twist_per_length();
                    half - f.s() * off
                })
            };
            for k in -40..=40 {
                let t = 0.25 * f64::from(k);
                let least = room(t).into_iter().fold(f64::INFINITY, f64::min);
                assert!(least > -1e-12, "{teeth} {helix} at {t}: {least}");
                if k == 0 {
                    let [left, right] = room(t);
                    assert!(left.abs() < 1e-9 && right.abs() < 1e-9, "{left} {right}");
                }
            }
        }
    }

    /// Two rolls as lines in space: opposite each other they are apart by half an axial pitch, and the distance of the parallel faces on both
    /// is the largest there.
    #[test]
    fn odd_helical_gears_have_rolls_opposite_each_other() {
        let gear = gear(25, 30.0);
        let rolls = gear.over_rolls(3.5).unwrap();
        let twist = gear.flank(Flank::Left).twist_per_length();
        // Rolls slide along their spaces by turning with them: which heights bring the second opposite the first?
        let pitch = 2.0 * PI / 25.0;
        let apart = (PI - 12.0 * pitch) / twist;
        assert!((apart.abs() - rolls.least_face_width).abs() < 1e-9, "{apart}");
        assert!((rolls.size - 2.0 * rolls.centre_radius - 3.5).abs() < 1e-12);
        assert!(rolls.size > gear.over_balls(3.5, 0.0).unwrap().size);
        assert!(matches!(gear.over_rolls(-1.0), Err(GeometryError::InvalidNumber { field: "ball", .. })));
        let internal = Gear::new(GearData { teeth: -60, ..*gear.data() }).unwrap();
        assert!(matches!(internal.over_rolls(3.5), Err(GeometryError::RollsUndefined { .. })));
    }
}
