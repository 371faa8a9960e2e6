//! The evaluation field: the rectangle of a flank on which a modification is defined and judged.

use super::error::ModificationError;
use super::limits;

/// Name under which the field reports its errors.
const KIND: &str = "evaluation field";

/// w in [w_f, w_a] (length of roll from start to end of the active profile), z in [z_I, z_II] (face I = lower z),
/// with base radius and base helix angle of the flank (`docs/mathematics/modifications.md`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EvaluationField {
    roll: [f64; 2],
    face: [f64; 2],
    base_radius: f64,
    base_helix_angle: f64,
}

impl EvaluationField {
    /// `roll` = [w_f, w_a] mm, `face` = [z_I, z_II] mm, `base_radius` r_b mm, `base_helix_angle` beta_b rad.
    ///
    /// # Errors
    /// `InvalidNumber` for numbers that are not finite or absurdly large, `InvalidModification` for an empty
    /// range, w_f < 0, r_b <= 0 and abs(beta_b) of 89 degrees or more.
    pub fn new(
        roll: [f64; 2],
        face: [f64; 2],
        base_radius: f64,
        base_helix_angle: f64,
    ) -> Result<Self, ModificationError> {
        let [w_f, w_a] = roll;
        let [z_1, z_2] = face;
        let numbers = [
            ("w_f", w_f),
            ("w_a", w_a),
            ("z_I", z_1),
            ("z_II", z_2),
            ("r_b", base_radius),
            ("beta_b", base_helix_angle),
        ];
        for (key, value) in numbers {
            if !value.is_finite() || value.abs() > limits::LENGTH_MM {
                return Err(ModificationError::InvalidNumber {
                    kind: KIND.into(),
                    key: key.into(),
                    value,
                    limit: limits::LENGTH_MM,
                });
            }
        }
        let refuse = |key: &str, value: f64, allowed: String| {
            Err(ModificationError::InvalidModification {
                kind: KIND.into(),
                key: key.into(),
                value: value.to_string(),
                allowed,
            })
        };
        if w_f < 0.0 {
            return refuse("w_f", w_f, "0 mm or more".into());
        }
        if w_a - w_f < limits::SHORTEST_MM {
            return refuse("w_f", w_f, format!("less than w_a = {w_a} mm"));
        }
        if z_2 - z_1 < limits::SHORTEST_MM {
            return refuse("z_I", z_1, format!("less than z_II = {z_2} mm"));
        }
        if base_radius < limits::SHORTEST_MM {
            return refuse("r_b", base_radius, "more than 0 mm".into());
        }
        if base_helix_angle.abs() >= 89f64.to_radians() {
            return refuse("beta_b", base_helix_angle, "between -89 and 89 degrees (in rad)".into());
        }
        Ok(Self { roll, face, base_radius, base_helix_angle })
    }

    /// [w_f, w_a], mm.
    pub fn roll(&self) -> [f64; 2] {
        self.roll
    }

    /// [z_I, z_II], mm.
    pub fn face(&self) -> [f64; 2] {
        self.face
    }

    /// r_b, mm.
    pub fn base_radius(&self) -> f64 {
        self.base_radius
    }

    /// beta_b, rad.
    pub fn base_helix_angle(&self) -> f64 {
        self.base_helix_angle
    }

    /// L_a = w_a - w_f, mm.
    pub fn roll_length(&self) -> f64 {
        self.roll[1] - self.roll[0]
    }

    /// L_b = z_II - z_I, mm.
    pub fn face_length(&self) -> f64 {
        self.face[1] - self.face[0]
    }

    /// w_m, mm.
    pub fn roll_middle(&self) -> f64 {
        0.5 * (self.roll[0] + self.roll[1])
    }

    /// z_m, mm.
    pub fn face_middle(&self) -> f64 {
        0.5 * (self.face[0] + self.face[1])
    }

    /// cos(beta_b): f_n = f_t cos(beta_b) turns a transverse into a normal value.
    pub fn normal_factor(&self) -> f64 {
        self.base_helix_angle.cos()
    }
}
