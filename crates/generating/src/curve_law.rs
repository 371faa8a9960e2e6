//! Wanted curves of worm lines on the flank and the tool shift that lays a worm line onto one
//! (`docs/mathematics/planning.md#variable-diagonal-ratio`). Knows no target.

use super::{FlankLines, GeneratingError};
use foundation::kinematics::{InverseLaw, LawError, MotionLaw, PiecewisePolynomial};

/// Equidistant places at which a curve is turned into F. Values and slopes are exact there, so that the cubics between them miss
/// F by h^4/384 F'''': 2e-9 mm at most for the curves of figures 25 and 26 (h = 35 um).
const PLACES: usize = 4000;

/// A curve z*(w) on the workpiece flank. mm.
#[derive(Clone, Debug, PartialEq)]
pub enum CurveLaw {
    /// z* = slope (w - origin) + amplitude sin((w - origin)/phase_length).
    LineSine {
        /// Slope.
        slope: f64,
        /// w_0, mm.
        origin: f64,
        /// a, mm.
        amplitude: f64,
        /// p, mm: one period is 2 pi p.
        phase_length: f64,
    },
    /// z* rises with `slope` up to w_t - h, is level at z_e from w_t + h on; a parabola between them. C1.
    LineBlend {
        /// Slope.
        slope: f64,
        /// w_t, mm.
        turn: f64,
        /// h, mm.
        half_length: f64,
        /// z_e, mm.
        level: f64,
    },
    /// Any law, for example one through tabulated points ([`MotionLaw::spline`], [`MotionLaw::monotone`]).
    Law(MotionLaw),
}

impl CurveLaw {
    /// `[z*, dz*/dw, d2z*/dw2]` at w.
    pub fn jet(&self, w: f64) -> [f64; 3] {
        match self {
            Self::LineSine { slope, origin, amplitude, phase_length } => {
                let x = w - origin;
                let (sin, cos) = (x / phase_length).sin_cos();
                let swing = amplitude / phase_length;
                [slope * x + amplitude * sin, slope + swing * cos, -swing / phase_length * sin]
            }
            Self::LineBlend { slope, turn, half_length, level } => {
                let (x, h) = (w - turn, *half_length);
                if x < -h {
                    [level + slope * x, *slope, 0.0]
                } else if x > h {
                    [*level, 0.0, 0.0]
                } else {
                    let rest = x - h;
                    let bend = -slope / (4.0 * h);
                    [level + bend * rest * rest, 2.0 * bend * rest, 2.0 * bend]
                }
            }
            Self::Law(law) => law.jet(w),
        }
    }

    /// Places where the second derivative jumps.
    fn breaks(&self) -> Vec<f64> {
        match self {
            Self::LineBlend { turn, half_length, .. } => vec![turn - half_length, turn + half_length],
            Self::Law(MotionLaw::Pieces(pieces)) => pieces.breaks().to_vec(),
            _ => Vec::new(),
        }
    }

    fn check(&self) -> Result<(), GeneratingError> {
        let finite = |field, value: f64| number(field, value, value.is_finite(), "a finite number");
        match *self {
            Self::LineSine { slope, origin, amplitude, phase_length } => {
                finite("slope", slope)?;
                finite("w_0", origin)?;
                finite("a", amplitude)?;
                number("p", phase_length, phase_length.is_finite() && phase_length > 0.0, "> 0 mm")
            }
            Self::LineBlend { slope, turn, half_length, level } => {
                finite("slope", slope)?;
                finite("w_t", turn)?;
                finite("z_e", level)?;
                number("h", half_length, half_length.is_finite() && half_length > 0.0, "> 0 mm")
            }
            Self::Law(_) => Ok(()),
        }
    }
}

pub(super) fn number(
    field: &'static str,
    value: f64,
    good: bool,
    allowed: &'static str,
) -> Result<(), GeneratingError> {
    if good { Ok(()) } else { Err(GeneratingError::InvalidNumber { field, value, allowed }) }
}

/// The curve that a worm line is to grind, with the stretch over which it is given.
#[derive(Clone, Debug, PartialEq)]
pub struct WantedCurve {
    /// The curve.
    pub law: CurveLaw,
    /// X_1 of the worm line that is to grind it, mm.
    pub line: f64,
    /// Length of roll from and to, mm. It reaches beyond the flank, even below 0, where w is only a parameter of the curve.
    pub roll: [f64; 2],
}

impl WantedCurve {
    /// The tool shift z_V1 = F(z_V2) that lays the worm line onto this curve of a flank, with its inverse. F is a cubic between
    /// the places of a table with the exact slopes of the curve, limited as Fritsch and Carlson ask for.
    ///
    /// # Errors
    /// `InvalidNumber`, `WormDirectionDegenerate`, `CurveNotAFunction` where the curve runs along the contact path or turns
    /// against it, `RangeNotCovered` when it does not reach over all corners of the field.
    pub fn shift(&self, lines: &FlankLines) -> Result<InverseLaw, GeneratingError> {
        self.law.check()?;
        lines.check_worm_direction()?;
        number("X_1", self.line, self.line.is_finite(), "a finite number")?;
        let [from, to] = self.roll;
        number("w_from", from, from.is_finite(), "a finite number")?;
        number("w_to", to, to.is_finite() && to > from, "above w_from")?;
        let mut rows = self.rows(lines)?;
        let rising = rows[rows.len() - 1][0] > rows[0][0];
        if !rising {
            rows.reverse();
        }
        let column = |k: usize| rows.iter().map(|row| row[k]).collect::<Vec<f64>>();
        let covered = [rows[0][0], rows[rows.len() - 1][0]];
        let feeds = lines.corners().map(|(w, z)| lines.path_feed(w, z));
        let needed = [
            feeds.into_iter().fold(f64::INFINITY, f64::min),
            feeds.into_iter().fold(f64::NEG_INFINITY, f64::max),
        ];
        if covered[0] > needed[0] || covered[1] < needed[1] {
            return Err(GeneratingError::RangeNotCovered { flank: lines.flank(), covered, needed });
        }
        let law = PiecewisePolynomial::monotone_with_slopes(&column(0), &column(1), &column(2))?;
        Ok(InverseLaw::new(MotionLaw::Pieces(law), covered)?)
    }

    /// `[z_V2, z_V1, dz_V1/dz_V2]` along the curve, with w; z_V2 rises or falls throughout.
    fn rows(&self, lines: &FlankLines) -> Result<Vec<[f64; 3]>, GeneratingError> {
        let [from, to] = self.roll;
        let even = (0..=PLACES).map(|k| from + (to - from) * k as f64 / PLACES as f64);
        let mut places: Vec<f64> = even.collect();
        places.extend(self.law.breaks().into_iter().filter(|w| (from..to).contains(w)));
        places.sort_by(f64::total_cmp);
        // Two places at one are one.
        let least = 1e-6 * (to - from) / PLACES as f64;
        places.dedup_by(|a, b| *a - *b < least);
        let mut sign = 0.0;
        let mut rows: Vec<[f64; 3]> = Vec::with_capacity(places.len());
        for w in places {
            let [z, slope, _] = self.law.jet(w);
            // -dz_V2/dw: how fast the curve crosses the contact paths.
            let across = lines.t_k + slope;
            let feed = lines.path_feed(w, z);
            let turned = across.abs() < 1e-6 || across * sign < 0.0;
            let stuck = rows.last().is_some_and(|row| (feed - row[0]) * sign >= 0.0);
            // Written so that NaN is no function either.
            if turned || stuck || !(across.is_finite() && feed.is_finite()) {
                return Err(GeneratingError::CurveNotAFunction { flank: lines.flank(), w });
            }
            sign = across.signum();
            let ratio = lines.big_t1 / (lines.cos_b2 * across);
            rows.push([feed, lines.shift_of_line(w, self.line), ratio]);
        }
        Ok(rows)
    }
}

impl From<LawError> for GeneratingError {
    fn from(error: LawError) -> Self {
        Self::Law(error)
    }
}
