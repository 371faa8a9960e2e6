//! Where the conditions of dressing lay the profile of a given dresser on the worm: a radius map or a stretch moves it from where it was
//! designed for, and may move it otherwise over the width (`docs/mathematics/dressing.md#conditions`). Cylinders only. Knows no target.

use super::policy::DressingRows;
use super::{GeneratingError, GrindingSetup, WormTip};
use dressing::{
    ConditionSolver, DressedProfile, DresserTool, DressingError, FlankDresser, PitchPlace, RowAlong,
    RowsAlong, solve_rows_at,
};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::numerics::{Chebyshev, Jet2};

/// The length of roll for which the dresser was designed where it dresses (w_1, z_1) of one flank, mm: a polynomial in w and q.
#[derive(Clone, Debug)]
pub struct MovedProfile {
    /// Coefficients of Chebyshev polynomials in q as series over w.
    over_roll: Vec<Chebyshev>,
    /// Interval of q.
    q: [f64; 2],
    /// Worm z in use.
    used: [f64; 2],
    /// Worm z over w of the line in which the dresser touches, and in the middle of the profile.
    line: Chebyshev,
    middle: f64,
}

/// The places are known this far in q: the dressed length goes on beyond the length in use.
const REACH: f64 = 1.2;
/// Nodes in q and w: laws over the width are polynomials of up to fifth degree, and along the profile places are nearly straight.
const NODES: [usize; 2] = [13, 9];
/// Share of the used profile by which places are known beyond it.
const BEYOND: f64 = 0.12;

/// A dresser with the head part that rows ask for.
///
/// # Errors
/// [`DressingError::InvalidNumber`] for a tip that has no conjugate.
pub(super) fn with_head_for(
    tool: DresserTool,
    rows: &[RowAlong],
    tip_radius: f64,
) -> Result<DresserTool, DressingError> {
    let heads = rows.iter().filter_map(|row| match row {
        RowAlong::Head { position, .. } => Some(position.abs()),
        _ => None,
    });
    match heads.reduce(f64::max) {
        Some(farthest) => tool.with_head(tip_radius, farthest + HEAD_HALF),
        None => Ok(tool),
    }
}

/// The head part of a dresser reaches over this beyond the places on the worm's tip that it is asked for, mm.
const HEAD_HALF: f64 = 1.5;

/// Length of roll of the worm at which the dresser was designed to dress with its profile parameter t.
pub(super) fn worm_roll_of(dresser: &FlankDresser, t: f64) -> f64 {
    dresser.range.w_nf + (t - dresser.designed.w_nf) * (dresser.range.length() / dresser.designed.length())
}

impl MovedProfile {
    /// Whether rows lay the profile of a dresser elsewhere than it was designed for.
    pub fn is_asked_by(rows: &DressingRows) -> bool {
        let moves = |row: &RowAlong| {
            matches!(row, RowAlong::Map { .. } | RowAlong::Stretch { .. }) && !row.is_met_uncorrected()
        };
        rows.rows().iter().any(moves)
    }

    /// On both flanks under rows that move the profile, for a plain dresser and a shift; `None` where they leave it in its place.
    ///
    /// # Errors
    /// [`GeneratingError::NotDressed`]; those of the rows where they cannot be met.
    pub fn of_rows(
        setup: &GrindingSetup,
        rows: DressingRows,
        shift: &MotionLaw,
        which: &[Flank],
    ) -> Result<Sides<Option<Self>>, GeneratingError> {
        if !Self::is_asked_by(&rows) {
            return Ok(Sides { left: None, right: None });
        }
        let plain = setup.dresser()?.plain();
        let tool = with_head_for(plain, rows.rows(), setup.worm_tip_radius)?;
        let tip = WormTip::new(setup, &setup.pair.motion(shift.clone()))?;
        let used = Sides::from_fn(|flank| setup.lines[flank].occupation(shift));
        let nothing = |places: &[Option<PitchPlace>]| vec![0.0; places.len()];
        Sides::try_from_fn(|flank| {
            if !which.contains(&flank) {
                return Ok(None);
            }
            let height = |z: f64| tip.radius(z);
            let conditions =
                RowsAlong { tool: &tool, flank, rows: *rows.set(), used, wanted: &nothing, tip: &height };
            Self::new(setup, &conditions).map(Some)
        })
    }

    fn new(setup: &GrindingSetup, conditions: &RowsAlong<'_>) -> Result<Self, GeneratingError> {
        let (tool, flank) = (conditions.tool, conditions.flank);
        let dresser = &tool.flanks[flank];
        let (range, used) = (dresser.range, conditions.used[flank]);
        let middle = dresser.line.value(range.middle());
        let solver = ConditionSolver::new(tool, setup.worm_pitch_radius);
        let [in_q, in_w] = NODES;
        let beyond = BEYOND * range.length();
        let (from, to) = (range.w_nf - beyond, range.w_na + beyond);
        // The rows as known from the middle outwards, each from its neighbour.
        let at = Chebyshev::nodes(-REACH, REACH, in_q);
        let mut dks = vec![[0.0; 4]; in_q];
        let solve = |k: usize, start: &[f64; 4]| {
            let z = 0.5 * (used[0] + used[1]) + 0.5 * at[k] * (used[1] - used[0]);
            solve_rows_at(&solver, middle - z, start, conditions)
        };
        let half = in_q / 2;
        dks[half] = solve(half, &[0.0; 4])?;
        for k in half + 1..in_q {
            dks[k] = solve(k, &dks[k - 1])?;
        }
        for k in (0..half).rev() {
            dks[k] = solve(k, &dks[k + 1])?;
        }
        let own = |dk: &[f64; 4]| -> Result<Vec<f64>, DressingError> {
            let profile = DressedProfile::new(tool, flank, *dk);
            let rolls = Chebyshev::nodes(from, to, in_w).into_iter();
            rolls.map(|w| Ok(worm_roll_of(dresser, profile.at_roll(w)?.t))).collect()
        };
        let rows = dks.iter().map(own).collect::<Result<Vec<_>, _>>()?;
        // Series in q at each node of w, and each of their coefficients over w.
        let columns: Vec<Chebyshev> = (0..in_w)
            .map(|i| {
                Chebyshev::interpolate(-REACH, REACH, &rows.iter().map(|row| row[i]).collect::<Vec<_>>())
            })
            .collect();
        let coefficient = |k: usize| -> Vec<f64> {
            columns.iter().map(|c| c.coefficients().get(k).copied().unwrap_or(0.0)).collect()
        };
        let over_roll = (0..in_q).map(|k| Chebyshev::interpolate(from, to, &coefficient(k))).collect();
        Ok(Self { over_roll, q: [-REACH, REACH], used, line: dresser.line.clone(), middle })
    }

    /// The designed length of roll at (w_1, z_1) with its derivatives, mm.
    pub fn jet(&self, w: f64, z: f64) -> Jet2 {
        let [from, to] = self.used;
        let rate = 2.0 / (to - from);
        let [line, slope, bend] = self.line.jet(w);
        let stands = z - line + self.middle;
        // q is known on its interval only; beyond it the places go on as they end.
        let q = (rate * stands - (from + to) / (to - from)).clamp(self.q[0], self.q[1]);
        let over_w: Vec<[f64; 3]> = self.over_roll.iter().map(|c| c.jet(w)).collect();
        let series = |k: usize| {
            let coefficients = over_w.iter().map(|c| c[k]).collect();
            Chebyshev::from_coefficients(self.q[0], self.q[1], coefficients).jet(q)
        };
        let ([f, f_q, f_qq], [f_w, f_wq, _], [f_ww, ..]) = (series(0), series(1), series(2));
        let (q_w, q_ww, q_z) = (-rate * slope, -rate * bend, rate);
        Jet2 {
            f,
            fu: f_w + f_q * q_w,
            fv: f_q * q_z,
            fuu: f_ww + 2.0 * f_wq * q_w + f_qq * q_w * q_w + f_q * q_ww,
            fuv: (f_wq + f_qq * q_w) * q_z,
            fvv: f_qq * q_z * q_z,
        }
    }

    /// The designed length of roll at (w_1, z_1), mm.
    pub fn own_roll(&self, w: f64, z: f64) -> f64 {
        self.jet(w, z).f
    }
}
