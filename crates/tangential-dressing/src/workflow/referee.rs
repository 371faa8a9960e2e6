//! The referee's run on a flank of tangential dressing: rays of the worm against the dresser, rays of the gear against the worm that
//! those left; and a sample that asks the dresser at every point. Only bodies and motions enter here.

use crate::{TangentialFlank, TangentialStrokes};
use foundation::kinematics::{DressingMotion, GeneratingMotion};
use foundation::numerics::{Progress, Silent};
use generating_grinding::workflow::referee::{RayedWorm, StageReport, Verdict, rayed, stock};
use metrology::Topography;
use referee::{
    ActiveThreads, Dressing, ExactWorm, Grinding, GrindingMode, RayGrid, RemovalError, WormArea,
    WormModification, dress_in_strokes, grind,
};
use run::RunFailure;

/// Distance of the outermost worm rays from the ends of the dressed length, mm.
const WORM_MARGIN: f64 = 0.5;
/// Points of the sample over the profile and over the face.
const SAMPLE: usize = 5;

/// Both calculations beside the plan.
pub struct Refereed {
    /// The flank by rays.
    pub verdict: Verdict,
    /// Lengths of roll, axial positions and lengths left of a sample, mm, by rays without a surface between the stages.
    pub sample: (RayGrid, Vec<f64>),
    /// Bound of the sample's own error, um.
    pub sample_error_um: f64,
    /// The worm that the rays of the gear met.
    pub worm: RayedWorm,
}

/// Motions that are really driven.
pub struct DrivenMotions {
    /// Dresser against worm.
    pub dressing: DressingMotion,
    /// v_zS from where to where, mm.
    pub shift_range: [f64; 2],
    /// Worm against workpiece.
    pub grinding: GeneratingMotion,
    /// z_V2 from where to where, mm.
    pub feed: [f64; 2],
}

impl DrivenMotions {
    /// Those of the flank's own settings.
    ///
    /// # Errors
    /// A dressing motion that is none.
    pub fn of_flank(flank: &TangentialFlank<'_>, strokes: &TangentialStrokes) -> Result<Self, RunFailure> {
        let (dressing, shift_range) =
            flank.dressing_motion(strokes.dressing).map_err(|e| RunFailure::from(&e))?;
        Ok(Self { dressing, shift_range, grinding: flank.motion().clone(), feed: strokes.feed })
    }
}

/// Lengths of rays over the worm flank that a dressing motion leaves, on a grid of so many over the profile and along the worm, mm.
///
/// # Errors
/// Those of the stage.
pub fn worm_rays(
    flank: &TangentialFlank<'_>,
    strokes: &TangentialStrokes,
    (motion, shift_range): (&DressingMotion, [f64; 2]),
    target: &Topography,
    [over_profile, along_worm]: [usize; 2],
) -> Result<Vec<f64>, RunFailure> {
    let dresser = flank.dresser();
    let stock = stock(flank.worm(), target.largest().max(strokes.worm_modification));
    let stage = Dressing { worm: flank.worm(), dresser: &dresser, motion, shift_range, stock };
    let [from, to] = strokes.worm_faces;
    let faces = [from + WORM_MARGIN, to - WORM_MARGIN];
    RayGrid::equidistant(strokes.worm_rolls, over_profile, faces, along_worm)
        .and_then(|grid| dress_in_strokes(&[stage], &grid, &Silent)?.lengths())
        .map_err(|e| RunFailure::of_removal(&e, "machine"))
}

/// Runs both stages.
///
/// # Errors
/// Those of the stages.
pub fn referee(
    flank: &TangentialFlank<'_>,
    strokes: &TangentialStrokes,
    driven: &DrivenMotions,
    target: &Topography,
    progress: &dyn Progress,
) -> Result<Refereed, RunFailure> {
    let (motion, shift_range) = (&driven.dressing, driven.shift_range);
    let refused = |e: RemovalError| RunFailure::of_removal(&e, "grinding");
    let dresser = flank.dresser();
    let stock = stock(flank.worm(), target.largest().max(strokes.worm_modification));
    let stage = Dressing { worm: flank.worm(), dresser: &dresser, motion, shift_range, stock };
    let [from, to] = strokes.worm_faces;
    let dressed = rayed(&[stage], strokes.worm_rolls, [from + WORM_MARGIN, to - WORM_MARGIN], progress)
        .map_err(refused)?;
    let exact = ExactWorm::new(&stage, dressed.surface.clone()).map_err(refused)?;
    let run =
        |area: WormArea, modification: &dyn WormModification, grid: &RayGrid, progress: &dyn Progress| {
            let grinding = Grinding {
                worm: flank.worm(),
                area,
                modification,
                work: flank.work(),
                motion: &driven.grinding,
                feed_range: driven.feed,
                stock,
                threads: ActiveThreads::All,
                mode: GrindingMode::Continuous,
            };
            grind(&grinding, grid, progress)
        };
    let grid = RayGrid::new(target.w.clone(), target.z.clone()).map_err(refused)?;
    let ground = run(dressed.area, &dressed.surface, &grid, progress).map_err(refused)?;
    let ends = |x: &[f64]| [x[0], x[x.len() - 1]];
    let sample = RayGrid::equidistant(ends(&target.w), SAMPLE, ends(&target.z), SAMPLE).map_err(refused)?;
    let asked = run(dressed.area, &exact, &sample, &Silent).map_err(refused)?;
    Ok(Refereed {
        verdict: Verdict {
            simulated: Topography { f: ground.lengths().map_err(refused)?, ..target.clone() },
            dressing: Some(StageReport {
                statistics: dressed.statistics,
                error_um: dressed.surface.error_um,
            }),
            grinding: StageReport { statistics: ground.statistics, error_um: ground.error_um },
            feed_mark: None,
            dressed: None,
        },
        sample_error_um: asked.error_um,
        sample: (sample, asked.lengths().map_err(refused)?),
        worm: dressed,
    })
}
