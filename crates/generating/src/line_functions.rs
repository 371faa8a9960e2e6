//! What the lines of a worm carry when the diagonal ratio varies: three functions of X_1, and the ideal worm made of them
//! (`docs/mathematics/planning.md#variable-diagonal-ratio`). Knows neither dresser nor job.
//!
//! No command reaches it: `verify` recomputes references of variable ratios with it.

use super::{FlankLines, GeneratingError, VariableRatio};
use contact::ThreadFunction;
use foundation::kinematics::MotionLaw;
use foundation::numerics::Jet2;

/// F_1C, F_1L, F_1Q of one worm line in powers of w_1 - w_1m: transverse modification of the worm, mm, mm/mm, mm/mm^2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineFunctions {
    /// w_1m, mm: powers of the raw w_1 (some 100 mm) would cancel to the last digits.
    pub centre: f64,
    /// F_1C, F_1L, F_1Q about the centre.
    pub centred: [f64; 3],
}

impl LineFunctions {
    /// The parabola over w_1 that grinds the values `f_t` (transverse, mm) at three different lengths of roll of the workpiece
    /// along the curve of one worm line.
    ///
    /// # Errors
    /// `InvalidNumber` when two lengths of roll are equal or a value is not finite.
    pub fn through(lines: &FlankLines, w_2: [f64; 3], f_t: [f64; 3]) -> Result<Self, GeneratingError> {
        let centre = lines.worm_roll(lines.w_m);
        let x = w_2.map(|w| lines.worm_roll(w) - centre);
        let y = f_t.map(|f| -lines.cos_b2 / lines.cos_b1 * f);
        let first = (y[1] - y[0]) / (x[1] - x[0]);
        let second = ((y[2] - y[1]) / (x[2] - x[1]) - first) / (x[2] - x[0]);
        if !second.is_finite() {
            let allowed = "three different lengths of roll with finite values";
            return Err(GeneratingError::InvalidNumber { field: "w_2", value: w_2[1], allowed });
        }
        // Newton's form about the centre.
        let linear = first - second * (x[0] + x[1]);
        Ok(Self { centre, centred: [y[0] - first * x[0] + second * x[0] * x[1], linear, second] })
    }

    /// The parabola of the worm line X_1 through a wanted flank f_t(w, z) (transverse, mm), from its values at the start, the
    /// middle and the end of the profile along the curve of that line.
    ///
    /// # Errors
    /// `Law` where the curve leaves the interval on which F is known, and errors of `f_t`.
    pub fn of_flank(
        flank: &VariableRatio<'_>,
        lines: &FlankLines,
        x_1: f64,
        f_t: impl Fn(f64, f64) -> Result<f64, GeneratingError>,
    ) -> Result<Self, GeneratingError> {
        let w_2 = [lines.roll[0], lines.w_m, lines.roll[1]];
        let mut values = [0.0; 3];
        for (value, w) in values.iter_mut().zip(w_2) {
            *value = f_t(w, flank.curve(w, x_1)?[0])?;
        }
        Self::through(lines, w_2, values)
    }

    /// F_1C, F_1L, F_1Q in powers of w_1 itself.
    pub fn raw(&self) -> [f64; 3] {
        let [c, l, q] = self.centred;
        let m = self.centre;
        [c - m * (l - m * q), l - 2.0 * m * q, q]
    }

    /// f_t1 at w_1, mm.
    pub fn value(&self, w_1: f64) -> f64 {
        let ([c, l, q], x) = (self.centred, w_1 - self.centre);
        c + x * (l + x * q)
    }
}

/// An ideal worm whose lines carry F_1C(X_1) + F_1L(X_1) x + F_1Q(X_1) x^2, x = w_1 - centre: f_n1 = cos b1 times that.
#[derive(Clone, Debug, PartialEq)]
pub struct LineWorm {
    /// Numbers of the flank.
    pub lines: FlankLines,
    /// w_1m, mm.
    pub centre: f64,
    /// F_1C, F_1L, F_1Q over X_1. The exact contact wants them C2 (`docs/mathematics/generating-contact.md#exact-contact`); where the
    /// second derivative of one jumps, its Newton steps lose their order but end at the same flank.
    pub functions: [MotionLaw; 3],
}

impl ThreadFunction for LineWorm {
    fn jet(&self, w_1: f64, z_1: f64) -> Option<Jet2> {
        let c_1 = self.lines.cos_rho_1();
        let x_1 = self.lines.worm_line(w_1, z_1);
        let [c, l, q] = [0, 1, 2].map(|k| Jet2::ridge(self.functions[k].jet(x_1), c_1 * self.lines.t_1, c_1));
        let roll = Jet2 { f: w_1 - self.centre, fu: 1.0, ..Jet2::default() };
        Some((c + (l + q * roll) * roll) * self.lines.cos_b1)
    }
}
