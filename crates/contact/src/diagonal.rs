//! Lines on worm and workpiece, the constant diagonal ratio both ways, and the point map
//! (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).

use super::{ContactError, FlankPair};

/// A direction rho on a flank: lines w sin(rho) + z cos(rho) = const, rho in (-90 deg, 90 deg].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagonalLine {
    /// rho, rad.
    pub rho: f64,
}

/// Feeds coupled by z_V1 = ratio z_V2 + shift_origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagonalRatio {
    /// K_ZV1.
    pub ratio: f64,
    /// z_V01, mm.
    pub shift_origin: f64,
}

/// Where a workpiece point is ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointMap {
    /// Tool shift z_V1, mm.
    pub shift: f64,
    /// Feed z_V2, mm.
    pub feed: f64,
    /// Worm length of roll w_1, mm.
    pub w_1: f64,
    /// Worm position z_1, mm.
    pub z_1: f64,
}

/// What a worm point grinds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkPoint {
    /// Tool shift z_V1, mm.
    pub shift: f64,
    /// Feed z_V2, mm.
    pub feed: f64,
    /// Workpiece length of roll w_2, mm.
    pub w_2: f64,
    /// Workpiece position z_2, mm.
    pub z_2: f64,
}

/// Map of line coordinates X_2 = slope X_1 + offset, and w_1 = p w_2 + q along one worm line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineMap {
    /// a of X_2 = a X_1 + o.
    pub slope: f64,
    /// o, mm.
    pub offset: f64,
}

impl DiagonalLine {
    /// X = w sin(rho) + z cos(rho), mm.
    pub fn coordinate(&self, w: f64, z: f64) -> f64 {
        w * self.rho.sin() + z * self.rho.cos()
    }
}

struct Numbers {
    sg: f64,
    p: f64,
    cos: f64,
}

impl FlankPair {
    fn numbers(&self, line: DiagonalLine, worm: bool) -> Result<Numbers, ContactError> {
        let (c_w, hat_w) = if worm { (self.c_w1, self.hat_w1) } else { (self.c_w2, self.hat_w2) };
        let (sin, cos) = line.rho.sin_cos();
        let sg = sin + c_w * cos;
        if sg.abs() < 1e-12 {
            return Err(ContactError::DirectionIsContactPath { direction_deg: line.rho.to_degrees() });
        }
        Ok(Numbers { sg, p: hat_w * cos / sg, cos })
    }

    /// The worm lines in which axial planes cut the thread at the worm point that grinds length of roll `w_2` (zero feeds):
    /// the direction of dressed lines where nothing better is known
    /// (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).
    pub fn axial_section_line(&self, w_2: f64) -> DiagonalLine {
        let w_1 = self.worm_roll(w_2, 0.0, 0.0);
        let share = (w_1 / self.worm.radius(w_1)).powi(2);
        DiagonalLine { rho: (-self.flank().sign() * share / self.worm.base_helix_angle.tan()).atan() }
    }

    /// Direction of the contact path on worm and workpiece: rho_Ki = s beta_bi, rad
    /// (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).
    pub fn contact_path(&self) -> [DiagonalLine; 2] {
        let s = self.flank().sign();
        [self.worm.base_helix_angle, self.work.base_helix_angle].map(|b| DiagonalLine { rho: s * b })
    }

    /// K_ZV1 that lays lines rho_1 of the worm onto lines rho_2 of the workpiece.
    ///
    /// # Errors
    /// `DirectionIsContactPath`, `DirectionIsProfile`, `DiagonalRatioInfinite`.
    pub fn ratio_of_directions(&self, worm: DiagonalLine, work: DiagonalLine) -> Result<f64, ContactError> {
        let n1 = self.numbers(worm, true)?;
        let n2 = self.numbers(work, false)?;
        let numerator = n1.p * self.c_zv21 + n2.p * self.c_zv22 - self.hat_zv2;
        let denominator = self.hat_zv1 - n1.p * self.c_zv11 - n2.p * self.c_zv12;
        if denominator.abs() < 1e-14 {
            let direction_deg = work.rho.to_degrees();
            return Err(if numerator.abs() < 1e-14 || worm.rho.cos().abs() < 1e-12 {
                ContactError::DirectionIsProfile { direction_deg: worm.rho.to_degrees() }
            } else {
                ContactError::DiagonalRatioInfinite { direction_deg }
            });
        }
        Ok(numerator / denominator)
    }

    /// Direction on the workpiece that lines rho_1 of the worm give at ratio K.
    ///
    /// # Errors
    /// `DirectionIsContactPath`.
    pub fn work_direction(&self, worm: DiagonalLine, ratio: f64) -> Result<DiagonalLine, ContactError> {
        let n1 = self.numbers(worm, true)?;
        let g_1 = self.c_zv11 * ratio + self.c_zv21;
        let g_2 = self.c_zv12 * ratio + self.c_zv22;
        let g_h = self.hat_zv1 * ratio + self.hat_zv2;
        Ok(DiagonalLine {
            rho: direction(self.hat_w2 * g_2 - self.c_w2 * (g_h - n1.p * g_1), g_h - n1.p * g_1),
        })
    }

    /// Direction on the worm that gives lines rho_2 of the workpiece at ratio K.
    ///
    /// # Errors
    /// `DirectionIsContactPath`.
    pub fn worm_direction(&self, work: DiagonalLine, ratio: f64) -> Result<DiagonalLine, ContactError> {
        let n2 = self.numbers(work, false)?;
        let g_1 = self.c_zv11 * ratio + self.c_zv21;
        let g_2 = self.c_zv12 * ratio + self.c_zv22;
        let g_h = self.hat_zv1 * ratio + self.hat_zv2;
        Ok(DiagonalLine {
            rho: direction(self.hat_w1 * g_1 - self.c_w1 * (g_h - n2.p * g_2), g_h - n2.p * g_2),
        })
    }

    /// X_2 = a X_1 + o between the line coordinates of matching directions
    /// (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).
    ///
    /// # Errors
    /// `DirectionIsContactPath`.
    pub fn line_map(
        &self,
        worm: DiagonalLine,
        work: DiagonalLine,
        diagonal: DiagonalRatio,
    ) -> Result<LineMap, ContactError> {
        let n1 = self.numbers(worm, true)?;
        let n2 = self.numbers(work, false)?;
        let e_1 = n1.cos * (self.c_zv11 * diagonal.shift_origin + self.c_c1);
        let e_2 = n2.cos * (self.c_zv12 * diagonal.shift_origin + self.c_c2);
        let e_h = self.hat_zv1 * diagonal.shift_origin + self.hat_c;
        Ok(LineMap {
            slope: -n2.sg * self.hat_w1 / (n1.sg * self.hat_w2),
            offset: n2.sg / self.hat_w2 * (self.hat_w1 * e_1 / n1.sg - e_h) + e_2,
        })
    }

    /// `(p, q)` of w_1 = p w_2 + q along the worm line with coordinate `x_1`.
    ///
    /// # Errors
    /// `DirectionIsContactPath`, `DirectionIsProfile` for cos(rho_1) = 0.
    pub fn roll_along_line(
        &self,
        worm: DiagonalLine,
        x_1: f64,
        diagonal: DiagonalRatio,
    ) -> Result<(f64, f64), ContactError> {
        let n1 = self.numbers(worm, true)?;
        if n1.cos.abs() < 1e-12 {
            return Err(ContactError::DirectionIsProfile { direction_deg: worm.rho.to_degrees() });
        }
        let g_1 = self.c_zv11 * diagonal.ratio + self.c_zv21;
        let g_h = self.hat_zv1 * diagonal.ratio + self.hat_zv2;
        let e_1 = n1.cos * (self.c_zv11 * diagonal.shift_origin + self.c_c1);
        let e_h = self.hat_zv1 * diagonal.shift_origin + self.hat_c;
        let along = if g_h == 0.0 { 0.0 } else { g_h / (n1.cos * g_1) };
        let den = self.hat_w1 - along * n1.sg;
        Ok((-self.hat_w2 / den, -(along * (x_1 - e_1) + e_h) / den))
    }

    /// Feeds and worm point at which the workpiece point (w_2, z_2) is ground.
    ///
    /// # Errors
    /// `FeedDoesNotMoveContact`.
    pub fn point_map(&self, w_2: f64, z_2: f64, diagonal: DiagonalRatio) -> Result<PointMap, ContactError> {
        let g_2 = self.c_zv12 * diagonal.ratio + self.c_zv22;
        if g_2.abs() < 1e-14 {
            return Err(ContactError::FeedDoesNotMoveContact { ratio: diagonal.ratio });
        }
        let feed = (z_2 - self.c_w2 * w_2 - self.c_zv12 * diagonal.shift_origin - self.c_c2) / g_2;
        let shift = diagonal.ratio * feed + diagonal.shift_origin;
        let w_1 = self.worm_roll(w_2, shift, feed);
        Ok(PointMap { shift, feed, w_1, z_1: self.worm_z(w_1, shift, feed) })
    }

    /// Feeds and workpiece point that the worm point (w_1, z_1) grinds: the inverse of [`FlankPair::point_map`].
    ///
    /// # Errors
    /// `FeedDoesNotMoveContact` where the feeds do not move the contact over the worm (a radial motion uses one line of it).
    pub fn work_point(&self, w_1: f64, z_1: f64, diagonal: DiagonalRatio) -> Result<WorkPoint, ContactError> {
        let g_1 = self.c_zv11 * diagonal.ratio + self.c_zv21;
        if g_1.abs() < 1e-14 {
            return Err(ContactError::FeedDoesNotMoveContact { ratio: diagonal.ratio });
        }
        let feed = (z_1 - self.c_w1 * w_1 - self.c_zv11 * diagonal.shift_origin - self.c_c1) / g_1;
        let shift = diagonal.ratio * feed + diagonal.shift_origin;
        let w_2 = self.work_roll(w_1, shift, feed);
        Ok(WorkPoint { shift, feed, w_2, z_2: self.work_z(w_2, shift, feed) })
    }
}

fn direction(numerator: f64, denominator: f64) -> f64 {
    if denominator == 0.0 {
        return std::f64::consts::FRAC_PI_2;
    }
    (numerator / denominator).atan()
}
