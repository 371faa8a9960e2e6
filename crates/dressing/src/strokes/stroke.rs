//! One stroke of dressing in several strokes: a part of a dresser's flank laid on a part of the worm's profile by a correction
//! of its own (`docs/mathematics/dressing.md`). Knows no other stroke.

use crate::{
    Condition, ConditionSolver, DressedProfile, DresserTool, DressingError, FlankDresser, GeometricRange,
    pitch_rolls,
};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;

/// What of a dresser's flank cuts in a stroke, by the parameter t of its profile, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ActiveArea {
    part: [f64; 2],
    touching: [f64; 2],
}

impl ActiveArea {
    /// `part` = [t_a, t_b] is laid on the range of a stroke, t_b exactly on its end. `touching` is all that touches the worm: at
    /// least the part, and at each end so much more as neighbouring strokes are to overlap.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] for numbers that are not finite or do not ascend.
    pub fn new(part: [f64; 2], touching: [f64; 2]) -> Result<Self, DressingError> {
        let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
        if !(part[0].is_finite() && part[0] > 0.0) {
            return invalid("start t_a of the active part", part[0], "a finite number above 0");
        }
        if !(part[1].is_finite() && part[1] > part[0]) {
            return invalid("end t_b of the active part", part[1], "a finite number above t_a");
        }
        if !(touching[0].is_finite() && touching[0] <= part[0]) {
            return invalid("start of what touches the worm", touching[0], "a finite number up to t_a");
        }
        if !(touching[1].is_finite() && touching[1] >= part[1]) {
            return invalid("end of what touches the worm", touching[1], "a finite number from t_b on");
        }
        Ok(Self { part, touching })
    }

    /// The part of a dresser's profile between two shares of the range that it was designed for, 0 at w_NfS and 1 at w_NaS, which
    /// gives half of the overlap (mm on the worm in use) to each neighbour.
    ///
    /// # Errors
    /// Those of [`ActiveArea::new`].
    pub fn of_shares(dresser: &FlankDresser, shares: [f64; 2], overlap: f64) -> Result<Self, DressingError> {
        let (designed, range) = (dresser.designed, dresser.range);
        let part = shares.map(|share| designed.w_nf + share * designed.length());
        let excess = 0.5 * overlap * designed.length() / range.length();
        Self::new(part, [part[0] - excess, part[1] + excess])
    }

    /// [t_a, t_b].
    pub fn part(&self) -> [f64; 2] {
        self.part
    }

    /// What touches the worm.
    pub fn touching(&self) -> [f64; 2] {
        self.touching
    }

    /// Refuses an area that the dresser's profile does not have.
    pub(crate) fn check(&self, tool: &DresserTool, flank: Flank) -> Result<(), DressingError> {
        let profile = &tool.flanks[flank].profile;
        match self.touching.into_iter().find(|&t| !profile.covers(t)) {
            None => Ok(()),
            Some(value) => Err(DressingError::InvalidNumber {
                field: "end of the active area of the dresser",
                value,
                allowed: "within the profile of the dresser",
            }),
        }
    }

    /// The dresser with the active part as its designed range, to be laid on `range` of the worm: pitch points, radius map and
    /// start values of all calculations then are those of the stroke.
    pub(crate) fn seated(&self, tool: &DresserTool, flank: Flank, range: [f64; 2]) -> DresserTool {
        let mut seated = tool.clone();
        seated.flanks[flank].designed = GeometricRange { w_nf: self.part[0], w_na: self.part[1] };
        seated.flanks[flank].range = GeometricRange { w_nf: range[0], w_na: range[1] };
        seated
    }
}

/// A stroke to be made.
#[derive(Clone, Copy, Debug)]
pub struct Stroke<'a> {
    /// The dresser, in nominal kinematics on the worm.
    pub tool: &'a DresserTool,
    /// What of it cuts.
    pub area: ActiveArea,
    /// Lengths of roll [w_a, w_b] of the worm on which the active part is laid, mm.
    pub range: [f64; 2],
}

/// A stroke with its correction.
#[derive(Clone, Debug)]
pub struct DressedStroke {
    /// DK against the nominal kinematics of the stroke's dresser.
    pub dk: DressingCorrection,
    /// Lengths of roll that what touches the worm dresses, mm.
    pub covers: [f64; 2],
    pub(crate) seated: DresserTool,
    flank: Flank,
}

/// Refuses a range of lengths of roll that is none.
pub(crate) fn check_range(range: [f64; 2]) -> Result<(), DressingError> {
    let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
    if !(range[0].is_finite() && range[0] > 0.0) {
        return invalid("start w_a of a range of the worm", range[0], "a finite length of roll above 0");
    }
    if !(range[1].is_finite() && range[1] > range[0]) {
        return invalid("end w_b of a range of the worm", range[1], "a finite length of roll above w_a");
    }
    Ok(())
}

/// First step of the way from the place where the dresser needs no correction, and the shortest before it is given up.
const FIRST_STEP: f64 = 0.25;
const LEAST_STEP: f64 = 1e-3;

/// The rows of a stroke: three pitch points and the end of the part on the end of the range.
fn rows(seated: &DresserTool, flank: Flank, f: [f64; 3]) -> [Condition; 4] {
    let rolls = pitch_rolls(seated, flank);
    let point = |i: usize| Condition::Point { flank, w: rolls[i], f: f[i] };
    let (t, w) = (seated.flanks[flank].designed.w_na, rolls[2]);
    [point(0), point(1), point(2), Condition::Map { flank, t, w }]
}

impl Stroke<'_> {
    /// Correction at which f(w_a), f(middle), f(w_b) = `f` (mm normal) and t_b dresses w_b: from `start` directly; where that fails
    /// from DK = 0, which dresses a range of its own, by moving that range to the wanted one.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] for the range or f; [`DressingError::NoZero`] with the reached share of the way, and what else
    /// [`ConditionSolver::solve`] says.
    pub fn solve(
        &self,
        flank: Flank,
        reference_radius: f64,
        f: [f64; 3],
        start: &DressingCorrection,
    ) -> Result<DressingCorrection, DressingError> {
        self.area.check(self.tool, flank)?;
        check_range(self.range)?;
        if let Some(&value) = f.iter().find(|f| !f.is_finite()) {
            let field = "wanted modification at a pitch point";
            return Err(DressingError::InvalidNumber { field, value, allowed: "a finite number" });
        }
        let at = |range: [f64; 2], f: [f64; 3], start: &DressingCorrection| {
            let seated = self.area.seated(self.tool, flank, range);
            ConditionSolver::new(&seated, reference_radius).solve(&rows(&seated, flank, f), start)
        };
        let direct = at(self.range, f, start);
        let refusal = match direct {
            Err(
                e @ (DressingError::NoZero { .. }
                | DressingError::NoContact { .. }
                | DressingError::OutOfDresser { .. }),
            ) => e,
            other => return other,
        };
        let nominal = DressedProfile::new(self.tool, flank, [0.0; 4]);
        let [a, b] = self.area.part;
        let home = [nominal.at_parameter(a)?.w, nominal.at_parameter(b)?.w];
        let seated = self.area.seated(self.tool, flank, home);
        let there = DressedProfile::new(&seated, flank, [0.0; 4]);
        let rolls = pitch_rolls(&seated, flank);
        let f_home = [there.at_roll(rolls[0])?.f, there.at_roll(rolls[1])?.f, there.at_roll(rolls[2])?.f];
        let between = |x: f64, y: f64, share: f64| x + share * (y - x);
        let (mut reached, mut step, mut dk) = (0.0, FIRST_STEP, [0.0; 4]);
        while step >= LEAST_STEP {
            let share = f64::min(reached + step, 1.0);
            let range = [0, 1].map(|k| between(home[k], self.range[k], share));
            let wanted = [0, 1, 2].map(|k| between(f_home[k], f[k], share));
            match at(range, wanted, &dk) {
                Ok(found) => {
                    (reached, dk) = (share, found);
                    if reached >= 1.0 {
                        return Ok(dk);
                    }
                    step *= 1.5;
                }
                Err(_) => step *= 0.5,
            }
        }
        Err(match refusal {
            DressingError::NoZero { flank, v, reason, .. } => {
                DressingError::NoZero { flank, v, fraction: reached, reason }
            }
            other => other,
        })
    }

    /// The stroke at a given correction.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] for the area, the range or the correction; [`DressingError::NoContact`] for an end of the active
    /// area without contact; [`DressingError::OutOfDresser`] where w does not rise over it.
    pub fn at(&self, flank: Flank, dk: DressingCorrection) -> Result<DressedStroke, DressingError> {
        self.area.check(self.tool, flank)?;
        check_range(self.range)?;
        crate::axes::deviation::check_correction("dressing correction", &dk)?;
        let seated = self.area.seated(self.tool, flank, self.range);
        let profile = DressedProfile::new(&seated, flank, dk);
        let [from, to] = self.area.touching;
        let covers = [profile.at_parameter(from)?.w, profile.at_parameter(to)?.w];
        if covers[0] >= covers[1] {
            return Err(DressingError::OutOfDresser { flank, w: covers[0], from, to });
        }
        Ok(DressedStroke { dk, covers, seated, flank })
    }
}

impl DressedStroke {
    /// The profile that the stroke dresses.
    pub fn profile(&self) -> DressedProfile<'_> {
        DressedProfile::new(&self.seated, self.flank, self.dk)
    }
}
