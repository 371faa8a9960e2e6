//! What the four components of the dressing correction do to the gear flanks that the worm grinds, and which patterns of both flanks one common
//! correction can remove (`docs/mathematics/inspection.md#correction`). Knows no conditions: exact corrections are found by those of spec
//! 30.
//!
//! No command reaches it: `verify` recomputes the influences of references with it.

use super::CorrectionError;
use dressing::{DressedProfile, DresserTool};
use foundation::geometry::{Flank, Sides};
use foundation::inverse::weighted_least_squares;
use foundation::kinematics::DressingCorrection;
use foundation::numerics::equidistant;
use nalgebra::{DMatrix, DVector};

/// Effect of d_phi_S, d_gamma, d_d, d_v_yA on one gear flank, mm per rad or mm. u runs from the root to the tip of the GEAR.
#[derive(Clone, Debug, PartialEq)]
pub struct FlankDressing {
    /// u of the samples.
    pub u: Vec<f64>,
    /// df_n2 at the samples, per component.
    pub columns: [Vec<f64>; 4],
    /// Mean parabola in the middle of the range.
    pub offset: DressingCorrection,
    /// Its slope over the range, > 0 rising to the tip.
    pub slope: DressingCorrection,
    /// Its height over the chord, > 0 convex.
    pub crowning: DressingCorrection,
}

/// Effects on both flanks of a worm that one motion dresses.
#[derive(Clone, Debug, PartialEq)]
pub struct DressingInfluence {
    /// Per gear flank.
    pub flanks: Sides<FlankDressing>,
}

/// Deviations of both flanks that one would like to remove at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TwoFlankPattern {
    /// Profile slopes of one sense.
    EqualSlopes,
    /// Profile slopes of opposite senses.
    OppositeSlopes,
    /// Profile crownings of one sense.
    EqualCrownings,
    /// Profile crownings of opposite senses.
    OppositeCrownings,
}

/// Singular values below this share of the largest are rounding; the weakest pattern of a usual worm has 1e-6.
const CUT: f64 = 1e-11;

impl DressingInfluence {
    /// At the correction `dk`, sampled evenly over the used range of the worm.
    ///
    /// # Errors
    /// [`CorrectionError::InvalidNumber`] for fewer than three samples; those of [`DressedProfile::at_roll`].
    pub fn new(tool: &DresserTool, dk: DressingCorrection, samples: usize) -> Result<Self, CorrectionError> {
        if samples < 3 {
            let (name, value, allowed) = ("number of samples", samples as f64, "at least 3");
            return Err(CorrectionError::InvalidNumber { name, value, allowed });
        }
        let flanks = Sides::try_from_fn(|flank| FlankDressing::new(tool, flank, dk, samples))?;
        Ok(Self { flanks })
    }

    /// Share of the squares of a pattern about the means of the flanks that one common correction removes, means left free.
    pub fn removable_share(&self, pattern: TwoFlankPattern) -> Option<f64> {
        let wanted = |flank: Flank, u: f64| match pattern {
            TwoFlankPattern::EqualSlopes => u,
            TwoFlankPattern::OppositeSlopes => flank.sign() * u,
            TwoFlankPattern::EqualCrownings => u * u,
            TwoFlankPattern::OppositeCrownings => flank.sign() * u * u,
        };
        let centred = |values: Vec<f64>| {
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            values.into_iter().map(move |x| x - mean)
        };
        let both = |of: &dyn Fn(Flank) -> Vec<f64>| -> Vec<f64> {
            Flank::BOTH.into_iter().flat_map(|flank| centred(of(flank))).collect()
        };
        let target = both(&|flank| self.flanks[flank].u.iter().map(|u| wanted(flank, *u)).collect());
        let columns: Vec<Vec<f64>> =
            (0..4).map(|j| both(&|flank| self.flanks[flank].columns[j].clone())).collect();
        // By the whole effect, mean included: what rounding leaves of a mere offset stays rounding.
        let sizes: [f64; 4] = std::array::from_fn(|j| {
            let squares = self.flanks.iter().flat_map(|(_, side)| &side.columns[j]).map(|x| x * x);
            squares.sum::<f64>().sqrt()
        });
        let matrix =
            DMatrix::from_fn(
                target.len(),
                4,
                |i, j| {
                    if sizes[j] > 0.0 { columns[j][i] / sizes[j] } else { 0.0 }
                },
            );
        let target = DVector::from_vec(target);
        let solved = weighted_least_squares(&matrix, &target, None, CUT)?;
        Some(1.0 - solved.residual.norm_squared() / target.norm_squared())
    }
}

impl FlankDressing {
    fn new(
        tool: &DresserTool,
        flank: Flank,
        dk: DressingCorrection,
        samples: usize,
    ) -> Result<Self, CorrectionError> {
        let range = tool.flanks[flank].range;
        // The small end of the worm's range grinds the gear's tip.
        let rolls = equidistant([range.w_na, range.w_nf], samples);
        let u = equidistant([-1.0, 1.0], samples);
        let points = DressedProfile::new(tool, flank, dk).at_rolls(&rolls)?;
        let columns: [Vec<f64>; 4] = std::array::from_fn(|j| points.iter().map(|p| -p.df_dk[j]).collect());
        let basis = DMatrix::from_fn(samples, 3, |i, k| u[i].powi(k as i32));
        let parabolas: Vec<[f64; 3]> = columns
            .iter()
            .map(|column| {
                let right = DVector::from_column_slice(column);
                // Three different samples or more always determine a parabola.
                weighted_least_squares(&basis, &right, None, CUT)
                    .map_or([f64::NAN; 3], |fit| std::array::from_fn(|k| fit.x[k]))
            })
            .collect();
        Ok(Self {
            u,
            columns,
            offset: std::array::from_fn(|j| parabolas[j][0]),
            slope: std::array::from_fn(|j| 2.0 * parabolas[j][1]),
            crowning: std::array::from_fn(|j| -parabolas[j][2]),
        })
    }
}
