//! Numbers of one flank that decomposition and mapping need: directions and lengths of spec 25 sections 2 and 3
//! (cylindrical bodies).

use crate::contact::FlankPair;
use crate::geometry::Flank;
use crate::modification::EvaluationField;
use crate::numerics::Jet2;

/// Directions and mapping constants of one flank of a cylindrical pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankLines {
    /// tan(rho_1) of the dressed lines on the worm.
    pub t_1: f64,
    /// t_K = tan(rho_K) of the contact path on the workpiece.
    pub t_k: f64,
    /// T1 = cos b1 (t_1 - s tan b1).
    pub big_t1: f64,
    /// s tan(beta_b1).
    pub worm_path: f64,
    /// cos(beta_b1).
    pub cos_b1: f64,
    /// cos(beta_b2).
    pub cos_b2: f64,
    /// E of R7, mm.
    pub e: f64,
    /// C_c1, mm.
    pub c_c1: f64,
    /// C_c2, mm.
    pub c_c2: f64,
    /// sin of the operating normal pressure angle.
    pub sin_an: f64,
    /// s of the flank.
    pub s: f64,
    /// B_F = r_b2 cos b2, mm: normal displacement per radian of the workpiece.
    pub lever: f64,
    /// Middle of the evaluation field: w_m, mm.
    pub w_m: f64,
    /// Middle of the evaluation field: z_m, mm.
    pub z_m: f64,
    /// Field in w, mm.
    pub roll: [f64; 2],
    /// Field in z, mm.
    pub face: [f64; 2],
}

impl FlankLines {
    /// For a flank pair, its evaluation field and the direction tan(rho_1) of the dressed lines.
    pub fn new(pair: &FlankPair, field: &EvaluationField, t_1: f64) -> Self {
        let s = pair.flank().sign();
        let (b_1, b_2) = (pair.worm.base_helix_angle, pair.work.base_helix_angle);
        Self {
            t_1,
            t_k: s * b_2.tan(),
            big_t1: b_1.cos() * (t_1 - s * b_1.tan()),
            worm_path: s * b_1.tan(),
            cos_b1: b_1.cos(),
            cos_b2: b_2.cos(),
            e: -pair.hat_c,
            c_c1: pair.c_c1,
            c_c2: pair.c_c2,
            sin_an: pair.operating_alpha_n.sin(),
            s,
            lever: pair.work.base_radius * b_2.cos(),
            w_m: field.roll_middle(),
            z_m: field.face_middle(),
            roll: field.roll(),
            face: field.face(),
        }
    }

    /// tan(rho_2) on the workpiece at diagonal ratio K (K != 0).
    pub fn work_direction(&self, ratio: f64) -> f64 {
        self.t_k - self.big_t1 / (ratio * self.cos_b2)
    }

    /// Diagonal ratio for tan(rho_2) = t_2.
    pub fn ratio_of_direction(&self, t_2: f64) -> f64 {
        -self.big_t1 / (self.cos_b2 * (t_2 - self.t_k))
    }

    /// Feed z_V2 at which (w_2, z_2) is ground, mm.
    pub fn feed(&self, w_2: f64, z_2: f64) -> f64 {
        self.c_c2 - self.t_k * w_2 - z_2
    }

    /// Worm point (w_1, z_1) that grinds (w_2, z_2) at z_V1 = K z_V2 + z_V01.
    pub fn worm_point(&self, w_2: f64, z_2: f64, ratio: f64, shift_origin: f64) -> (f64, f64) {
        let w_1 = self.worm_roll(w_2);
        let shift = ratio * self.feed(w_2, z_2) + shift_origin;
        (w_1, self.c_c1 - self.worm_path * w_1 - shift)
    }

    /// Worm roll that grinds workpiece roll w_2 (R7).
    pub fn worm_roll(&self, w_2: f64) -> f64 {
        self.cos_b1 * (self.e - w_2 / self.cos_b2)
    }

    /// The flank.
    pub fn flank(&self) -> Flank {
        if self.s > 0.0 { Flank::Left } else { Flank::Right }
    }

    /// Workpiece roll ground by worm roll w_1.
    pub fn work_roll(&self, w_1: f64) -> f64 {
        self.cos_b2 * (self.e - w_1 / self.cos_b1)
    }

    /// The workpiece point (w_2, z_2) that (w_1, z_1) grinds at z_V1 = K z_V2 + z_V01, as functions of (w_1, z_1); K != 0.
    pub fn work_point(&self, w_1: f64, z_1: f64, ratio: f64, shift_origin: f64) -> [Jet2; 2] {
        let shrink = -self.cos_b2 / self.cos_b1;
        let w_2 = self.work_roll(w_1);
        let feed = (self.c_c1 - self.worm_path * w_1 - z_1 - shift_origin) / ratio;
        let w = Jet2 { f: w_2, fu: shrink, ..Jet2::default() };
        let z = Jet2 {
            f: self.c_c2 - self.t_k * w_2 - feed,
            fu: -self.t_k * shrink + self.worm_path / ratio,
            fv: 1.0 / ratio,
            ..Jet2::default()
        };
        [w, z]
    }

    /// The four corners of the evaluation field.
    pub fn corners(&self) -> [(f64, f64); 4] {
        let ([w0, w1], [z0, z1]) = (self.roll, self.face);
        [(w0, z0), (w0, z1), (w1, z0), (w1, z1)]
    }
}
