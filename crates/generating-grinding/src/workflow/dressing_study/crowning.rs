//! Corrections, axial position and profile stretch over the profile crowning of the gear (`docs/mathematics/dressing.md#conditions`), by
//! the three-point method with the radius map.

use super::bodies::Bodies;
use crate::job::Steps;
use crate::workflow::explore::Refused;
use dressing::{
    ConditionSolver, ContactLine, CrowningEnd, CrowningLimits, CrowningRows, DressedProfile, DresserSection,
    DresserTool, DressingError, PathReason, ThreadSpace, profile_error, stretch, three_points_with_map,
};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;
use generating::{GeneratingError, GrindingSetup};
use schemars::JsonSchema;
use serde::Serialize;

/// Dressing for one profile crowning.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CrowningPoint {
    /// Profile crowning on the gear, transverse, positive = convex.
    pub crowning_um: f64,
    /// Correction of the worm angle.
    #[serde(rename = "d_phi_S_deg")]
    pub d_phi_s_deg: f64,
    /// Correction of the crossing angle.
    pub d_gamma_deg: f64,
    /// Correction of the centre distance.
    pub d_d_mm: f64,
    /// Correction of the offset.
    #[serde(rename = "d_v_yA_mm")]
    pub d_v_ya_mm: f64,
    /// Axial position at which the contact line passes through the middle of the profile at worm z = 0.
    #[serde(rename = "v_zS_mm")]
    pub v_zs_mm: f64,
    /// Relative profile stretch.
    pub stretch: f64,
    /// Direction of the contact line.
    pub rho_deg: f64,
    /// Largest deviation of the dressed profile from the parabola, normal to the flank.
    pub deviation_um: f64,
}

/// One end of a curve, where it ends before the study does.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CurveEnd {
    /// The last crowning reached.
    pub crowning_um: f64,
    /// What is there: fold, contact lost, out of dresser, limit of an axis, tip land; else the code of an error.
    pub reason: String,
}

/// The points of one set of bodies.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CrowningCurve {
    /// What tells the bodies from the others; empty where nothing is compared.
    pub bodies: String,
    /// Points in ascending order of the crowning.
    pub points: Vec<CrowningPoint>,
    /// Why there are no smaller crownings.
    pub least: Option<CurveEnd>,
    /// Why there are no larger crownings.
    pub most: Option<CurveEnd>,
    /// Smallest and largest crowning at which a dresser with the tip land of the job clears the opposite flank; absent without a
    /// tip land, or where the study gives the crownings.
    pub with_tip_land: Option<[CurveEnd; 2]>,
    /// Why there is no curve at all.
    pub refused: Option<Refused>,
}

impl CrowningCurve {
    /// Where the curve runs from and to, in one line.
    pub fn summary(&self) -> String {
        if let Some(refused) = &self.refused {
            return format!("{}: {}", refused.code, refused.text);
        }
        let (Some(first), Some(last)) = (self.points.first(), self.points.last()) else {
            return "no point of the study can be made".into();
        };
        let why =
            |end: &Option<CurveEnd>| end.as_ref().map_or(String::new(), |end| format!(" ({})", end.reason));
        format!(
            "crowning {:.4}{} .. {:.4} um{}; stretch {:.2} .. {:.2} %",
            first.crowning_um,
            why(&self.least),
            last.crowning_um,
            why(&self.most),
            100.0 * first.stretch,
            100.0 * last.stretch
        )
    }
}

/// One flank of a dresser and what crowning means for it.
pub struct Task<'a> {
    /// Dresser and worm.
    pub tool: &'a DresserTool,
    /// The flank.
    pub flank: Flank,
    /// Pitch radius of the worm, mm.
    pub radius: f64,
    /// cos(beta_b) of the gear: transverse to normal.
    pub cos: f64,
}

impl<'a> Task<'a> {
    /// The task for bodies, or why there is none.
    pub fn new(bodies: &'a Bodies, flank: Flank) -> Result<(Self, &'a GrindingSetup), Refused> {
        let setup = bodies.setup.as_ref().map_err(Clone::clone)?;
        let tool = setup.dresser().map_err(|error| Refused::from(&error))?;
        let task = Self { tool, flank, radius: setup.worm_pitch_radius, cos: setup.lines[flank].cos_b2 };
        Ok((task, setup))
    }

    /// f_n of the worm at the middle of the profile for a profile crowning c on the gear, mm (`docs/mathematics/dressing.md`, decision on
    /// (19)).
    fn middle(&self, crowning: f64) -> f64 {
        -crowning * self.cos
    }

    /// DK of the three-point rows for a crowning, mm.
    pub fn solve(
        &self,
        crowning: f64,
        start: &DressingCorrection,
    ) -> Result<DressingCorrection, DressingError> {
        let rows = three_points_with_map(&self.tool.flanks[self.flank], [0.0, self.middle(crowning), 0.0]);
        ConditionSolver::new(self.tool, self.radius).solve(&rows, start)
    }

    /// The figures of a correction that makes a crowning, mm.
    pub fn point(&self, crowning: f64, dk: DressingCorrection) -> Result<CrowningPoint, DressingError> {
        let flank = self.flank;
        let range = self.tool.flanks[flank].range;
        let profile = DressedProfile::new(self.tool, flank, dk);
        let (deviation, _) = profile_error(self.tool, flank, dk, self.middle(crowning))?;
        Ok(CrowningPoint {
            crowning_um: crowning * 1e3,
            d_phi_s_deg: dk[0].to_degrees(),
            d_gamma_deg: dk[1].to_degrees(),
            d_d_mm: dk[2],
            d_v_ya_mm: dk[3],
            v_zs_mm: profile.at_roll(range.middle())?.b,
            stretch: stretch(self.tool, flank, dk)?,
            rho_deg: ContactLine::fit(self.tool, flank, dk)?.rho.to_degrees(),
            deviation_um: deviation * 1e3,
        })
    }
}

/// The curve of one set of bodies over the given crownings, each direction from the crowning nearest to 0, or over all that can
/// be made; there also with a tip land (mm) that must clear the opposite flank.
pub fn curve(bodies: &Bodies, flank: Flank, steps: Option<&Steps>, tip_land: Option<f64>) -> CrowningCurve {
    let none = |refused: Refused| CrowningCurve {
        bodies: bodies.name.clone(),
        points: Vec::new(),
        least: None,
        most: None,
        with_tip_land: None,
        refused: Some(refused),
    };
    let (task, setup) = match Task::new(bodies, flank) {
        Ok(found) => found,
        Err(refused) => return none(refused),
    };
    let Some(steps) = steps else {
        return whole(bodies, &task, setup, tip_land).unwrap_or_else(|error| none(Refused::from(&error)));
    };
    let values: Vec<f64> = steps.values().map(|um| um * 1e-3).collect();
    let (below, above): (Vec<f64>, Vec<f64>) = values.into_iter().partition(|&c| c < 0.0);
    let (mut points, least) = branch(&task, below.into_iter().rev());
    points.reverse();
    let (upper, most) = branch(&task, above.into_iter());
    points.extend(upper);
    CrowningCurve { bodies: bodies.name.clone(), points, least, most, with_tip_land: None, refused: None }
}

/// The curve over all crownings that can be made, followed both ways from none (`docs/mathematics/dressing.md#conditions`).
fn whole(
    bodies: &Bodies,
    task: &Task<'_>,
    setup: &GrindingSetup,
    tip_land: Option<f64>,
) -> Result<CrowningCurve, GeneratingError> {
    let gear_helix = setup.pair.work.flank(task.flank).base_helix_angle;
    let rows = CrowningRows::new(&task.tool.flanks[task.flank], task.radius, gear_helix);
    let range = rows.range(&CrowningLimits::default())?;
    let end = |end: CrowningEnd| CurveEnd { crowning_um: end.crowning * 1e3, reason: end.reason.to_string() };
    let mut points = Vec::with_capacity(range.path.len());
    for at in &range.path {
        points.push(task.point(at.crowning, at.dk)?);
    }
    let with_tip_land = match (tip_land, &setup.input.dresser) {
        (Some(land), Some(choice)) => {
            let section = DresserSection::new(task.tool, task.flank, 0.5 * choice.tip_diameter)?;
            // Only the sign decides; a dresser far off counts as clear by a millimetre.
            let clearance = |dk: &DressingCorrection| {
                let at = section.counter_flank_clearance(dk, land, ThreadSpace::default());
                at.map_or(f64::NAN, |f| f.min(1.0))
            };
            let limits = CrowningLimits { margin: Some(&clearance), ..CrowningLimits::default() };
            let spared = rows.range(&limits)?;
            let named = |at: CrowningEnd| match at.reason {
                PathReason::Limit => CurveEnd { reason: "tip land".into(), ..end(at) },
                _ => end(at),
            };
            Some([named(spared.smallest), named(spared.largest)])
        }
        _ => None,
    };
    Ok(CrowningCurve {
        bodies: bodies.name.clone(),
        points,
        least: Some(end(range.smallest)),
        most: Some(end(range.largest)),
        with_tip_land,
        refused: None,
    })
}

/// Points one after the other, each from its neighbour, as far as they can be made.
fn branch(task: &Task<'_>, crownings: impl Iterator<Item = f64>) -> (Vec<CrowningPoint>, Option<CurveEnd>) {
    let (mut dk, mut points) = ([0.0; 4], Vec::new());
    for c in crownings {
        match task.solve(c, &dk).and_then(|solved| Ok((solved, task.point(c, solved)?))) {
            Ok((solved, point)) => {
                dk = solved;
                points.push(point);
            }
            Err(error) => {
                let reached = points.last().map_or(0.0, |p: &CrowningPoint| p.crowning_um);
                let reason = match error {
                    DressingError::NoZero { reason, .. } => reason.code().to_string(),
                    other => other.code().to_string(),
                };
                return (points, Some(CurveEnd { crowning_um: reached, reason }));
            }
        }
    }
    (points, None)
}
