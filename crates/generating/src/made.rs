//! The flank of a tool that no dresser profiles: the modification that a plan asks of it, as a table that can be made, measured
//! and handed on. The table's spline is the tool from here on; whatever it misses of the wanted function shows in the flank.

use super::{GeneratingError, GrindingSetup, IdealPlan, IdealWorm};
use contact::{ThreadFunction, ToolSurface};
use foundation::geometry::Flank;
use foundation::numerics::{SplineError, TensorSpline, equidistant};

/// One flank of a made tool: f_n1 on a grid of (w_1, z_1), normal, > 0 material left, with the C2 spline through it. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeFlank {
    /// Lengths of roll w_1, ascending.
    pub w: Vec<f64>,
    /// Positions z_1, ascending.
    pub z: Vec<f64>,
    /// f_n1 `[w][z]`.
    pub f: Vec<Vec<f64>>,
    /// The spline through them.
    pub spline: TensorSpline,
}

/// Spacing of the first table over profile and width, mm.
const SPACING: [f64; 2] = [1.0, 2.0];
/// The spline may miss the wanted function by this much in the middles of cells, mm.
const TOLERANCE: f64 = 1e-6;
/// Most nodes along one axis: kinks of the target end the halving here.
const MOST_NODES: [usize; 2] = [65, 385];
/// Share of the used profile by which the table goes beyond it at each end: the contact shifts with the modification.
const PROFILE_MARGIN: f64 = 0.08;

impl MadeFlank {
    /// From a table as it stands in a file.
    ///
    /// # Errors
    /// [`SplineError`] for axes that do not ascend, fewer than four nodes and numbers that are not finite.
    pub fn from_table(w: Vec<f64>, z: Vec<f64>, f: Vec<Vec<f64>>) -> Result<Self, SplineError> {
        let spline = TensorSpline::new(&w, &z, &f)?;
        Ok(Self { w, z, f, spline })
    }

    /// The table of one flank of a plan, reaching `margin` beyond the occupied width at each end.
    ///
    /// # Errors
    /// [`GeneratingError::ToolBelowBase`]; [`GeneratingError::ToolUndefined`] where the wanted function has no value.
    pub fn of_plan(
        setup: &GrindingSetup,
        plan: &IdealPlan,
        flank: Flank,
        margin: f64,
    ) -> Result<Self, GeneratingError> {
        let worm = plan.worms[flank].as_ref().ok_or(GeneratingError::NoFlank)?;
        let rolls = worm.lines.worm_rolls(&worm.shift);
        let beyond = PROFILE_MARGIN * (rolls[1] - rolls[0]);
        if rolls[0].is_nan() || rolls[0] <= 0.0 {
            return Err(GeneratingError::ToolBelowBase { flank, w_1: rolls[0] });
        }
        // Half of what is left above the base circle, where the margin would reach below it.
        let from = (rolls[0] - beyond).max(0.5 * rolls[0]);
        let occupied = setup.lines[flank].occupation(&worm.shift);
        let span = [[from, rolls[1] + beyond], [occupied[0] - margin, occupied[1] + margin]];
        Self::table(worm, flank, span)
    }

    fn table(worm: &IdealWorm, flank: Flank, span: [[f64; 2]; 2]) -> Result<Self, GeneratingError> {
        let value = |w: f64, z: f64| {
            worm.jet(w, z).map(|jet| jet.f).ok_or(GeneratingError::ToolUndefined { flank, w_1: w, z_1: z })
        };
        let mut nodes: [usize; 2] =
            std::array::from_fn(|k| ((span[k][1] - span[k][0]) / SPACING[k]).ceil().max(4.0) as usize + 1);
        loop {
            let (w, z) = (equidistant(span[0], nodes[0]), equidistant(span[1], nodes[1]));
            let f = w
                .iter()
                .map(|&w| z.iter().map(|&z| value(w, z)).collect::<Result<Vec<f64>, _>>())
                .collect::<Result<Vec<_>, _>>()?;
            let spline = TensorSpline::new(&w, &z, &f).map_err(|_| GeneratingError::ToolUndefined {
                flank,
                w_1: w[0],
                z_1: z[0],
            })?;
            // Middles of the edges of the cells tell which axis is too coarse.
            let mut missed = [0.0f64; 2];
            for i in 0..w.len() - 1 {
                for &z in &z {
                    let middle = 0.5 * (w[i] + w[i + 1]);
                    missed[0] = missed[0].max((spline.value(middle, z) - value(middle, z)?).abs());
                }
            }
            for &w in &w {
                for j in 0..z.len() - 1 {
                    let middle = 0.5 * (z[j] + z[j + 1]);
                    missed[1] = missed[1].max((spline.value(w, middle) - value(w, middle)?).abs());
                }
            }
            let coarse: [bool; 2] =
                std::array::from_fn(|k| missed[k] > TOLERANCE && 2 * nodes[k] - 1 <= MOST_NODES[k]);
            if coarse == [false; 2] {
                return Ok(Self { w, z, f, spline });
            }
            for k in 0..2 {
                if coarse[k] {
                    nodes[k] = 2 * nodes[k] - 1;
                }
            }
        }
    }

    /// The tool surface on the unmodified flank of the worm.
    pub fn surface(&self, setup: &GrindingSetup, flank: Flank) -> impl ToolSurface + '_ {
        contact::ModifiedThread::new(setup.pair.flanks[flank].worm, &self.spline)
    }
}
