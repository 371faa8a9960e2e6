//! Relations of one flank when the diagonal ratio varies: z_V1 = F(z_V2), strictly monotone
//! (`docs/mathematics/planning.md#variable-diagonal-ratio`, R20). Cylindrical bodies. Knows no target and no plan.
//!
//! No command reaches it: `verify` recomputes references of variable ratios with it.

use super::{FlankLines, GeneratingError};
use foundation::kinematics::{InverseLaw, MotionLaw};
use foundation::numerics::Jet2;

/// One flank under z_V1 = F(z_V2): where the lines of the worm lie on the workpiece.
#[derive(Clone, Copy, Debug)]
pub struct VariableRatio<'a> {
    lines: &'a FlankLines,
    shift: &'a InverseLaw,
}

impl FlankLines {
    /// cos(rho_1).
    pub fn cos_rho_1(&self) -> f64 {
        1.0 / self.t_1.hypot(1.0)
    }

    /// X_1 of the worm line through (w_1, z_1), mm.
    pub fn worm_line(&self, w_1: f64, z_1: f64) -> f64 {
        self.cos_rho_1() * (self.t_1 * w_1 + z_1)
    }

    /// Tool shift z_V1 at which the worm line X_1 touches at length of roll w_2 (right side of R20), mm.
    pub fn shift_of_line(&self, w_2: f64, x_1: f64) -> f64 {
        self.c_c1 + self.big_t1 * (self.e - w_2 / self.cos_b2) - x_1 / self.cos_rho_1()
    }

    /// X_1 = F_X1(w_2, z_2): the worm line that grinds (w_2, z_2) when z_V1 = F(z_V2), with derivatives in (w_2, z_2), mm.
    pub fn line_coordinate(&self, shift: &MotionLaw, w_2: f64, z_2: f64) -> Jet2 {
        let c_1 = self.cos_rho_1();
        let [f, f1, f2] = shift.jet(self.path_feed(w_2, z_2));
        // The feed is c_c2 - t_K w - z; all else is linear in w.
        let moved = Jet2::ridge([f, -f1, f2], self.t_k, 1.0) * -c_1;
        let still = c_1 * (self.c_c1 + self.big_t1 * (self.e - w_2 / self.cos_b2));
        let slope = -c_1 * self.big_t1 / self.cos_b2;
        moved + Jet2 { f: still, fu: slope, ..Jet2::default() }
    }

    /// Displacement (dw, dz) on the workpiece of the curve of one worm line against that of another whose X_1 is smaller by
    /// `difference`: along the contact path, whatever F is. mm.
    ///
    /// # Errors
    /// `WormDirectionDegenerate` when the dressed lines run along the contact path of the worm (T1 = 0).
    pub fn curve_displacement(&self, difference: f64) -> Result<[f64; 2], GeneratingError> {
        self.check_worm_direction()?;
        let delta = -self.cos_b2 * difference / (self.cos_rho_1() * self.big_t1);
        Ok([delta, -self.t_k * delta])
    }

    pub(super) fn check_worm_direction(&self) -> Result<(), GeneratingError> {
        // T1 is of the size of 1; the limit is that of the degenerate direction on the workpiece
        // (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).
        if self.big_t1.abs() < 1e-6 {
            return Err(GeneratingError::WormDirectionDegenerate {
                flank: self.flank(),
                direction_deg: self.t_1.atan().to_degrees(),
            });
        }
        Ok(())
    }
}

impl<'a> VariableRatio<'a> {
    /// A flank whose worm lines are `lines`, with the tool shift `shift` as an invertible law of the feed.
    pub fn new(lines: &'a FlankLines, shift: &'a InverseLaw) -> Self {
        Self { lines, shift }
    }

    /// `[z_2, dz_2/dw_2, d2z_2/dw_2^2]` of the curve that the worm line X_1 grinds, at length of roll w_2, mm.
    ///
    /// # Errors
    /// `Law` (`OutsideRange`) where the curve leaves the interval on which F is known.
    pub fn curve(&self, w_2: f64, x_1: f64) -> Result<[f64; 3], GeneratingError> {
        let lines = self.lines;
        let step = -lines.big_t1 / lines.cos_b2;
        let [feed, feed_1, feed_2] = self.shift.jet(lines.shift_of_line(w_2, x_1))?;
        Ok([lines.path_feed(w_2, feed), -lines.t_k - feed_1 * step, -feed_2 * step * step])
    }

    /// Local diagonal ratio F' at (w_2, z_2).
    pub fn local_ratio(&self, w_2: f64, z_2: f64) -> f64 {
        self.shift.law().jet(self.lines.path_feed(w_2, z_2))[1]
    }

    /// Local direction t_2 = tan(rho_2) = -dz_2/dw_2 of the curve through (w_2, z_2).
    pub fn local_direction(&self, w_2: f64, z_2: f64) -> f64 {
        self.lines.work_direction(self.local_ratio(w_2, z_2))
    }

    /// X_1 of the worm line that grinds (w_2, z_2), mm.
    pub fn line_coordinate(&self, w_2: f64, z_2: f64) -> f64 {
        self.lines.line_coordinate(self.shift.law(), w_2, z_2).f
    }

    /// The worm point (w_1, z_1) that grinds (w_2, z_2), mm.
    pub fn worm_point(&self, w_2: f64, z_2: f64) -> (f64, f64) {
        self.lines.worm_point(w_2, z_2, self.shift.law())
    }
}
