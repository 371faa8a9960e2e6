//! One flank of a run: planned, refereed, and radial feed beside it.

use super::prepare::TangentialPrepared;
use super::referee::{DrivenMotions, Refereed, referee};
use super::result::{RadialFeedResult, TangentialFlankResult};
use super::settings::SettledPass;
use crate::{
    Fit, FitGrid, Judged, RollGrid, TangentialError, TangentialFlank, TangentialSettings, TangentialStrokes,
};
use contact::Measure;
use foundation::geometry::Flank;
use foundation::numerics::Progress;
use generating_grinding::workflow::result::FlankResult;
use metrology::Topography;
use run::{CharacteristicsUm, RunFailure};
use verdict::Remark;

/// One flank as run.
pub struct TangentialRun {
    /// Flanks of its pass.
    pub pass: Vec<Flank>,
    /// All values.
    pub settings: TangentialSettings,
    /// What the axes do.
    pub strokes: TangentialStrokes,
    /// What is wanted, normal, mm.
    pub target: Topography,
    /// What the exact contact gives, in the measure of the job.
    pub planned: Topography,
    /// What the rays left, in the measure of the job.
    pub simulated: Topography,
    /// Largest difference of rays and exact contact, mm.
    pub model_difference: f64,
    /// The same on the sample without a surface between the stages, mm.
    pub sample_difference: f64,
    /// The referee's own account.
    pub refereed: Refereed,
}

fn topography(judged: &Judged, f: Vec<f64>) -> Topography {
    Topography { w: judged.grid.w.clone(), z: judged.grid.z.clone(), f }
}

pub(super) fn run_flank(
    ready: &TangentialPrepared,
    judged: &Judged,
    pass: &SettledPass,
    progress: &dyn Progress,
) -> Result<TangentialRun, RunFailure> {
    let failed = |e: TangentialError| RunFailure::from(&e);
    // Rays measure along the normal. A job that measures on the arc is proven there all the same: what the rays differ by from
    // the plan along the normals is added to the plan on the arcs.
    let along_normals =
        TangentialFlank::new(&ready.model, judged.flank, &pass.flanks, &pass.settings, Measure::Ray);
    let strokes = along_normals.strokes(&judged.points);
    let planned = topography(judged, judged.points.iter().map(|p| p.deviation).collect());
    let wanted = judged.points.iter().zip(&judged.error).map(|(p, e)| p.deviation - e).collect();
    let target = topography(judged, wanted);
    let driven = DrivenMotions::of_flank(&along_normals, &strokes)?;
    let refereed = referee(&along_normals, &strokes, &driven, &target, progress)?;
    let rays = &refereed.verdict.simulated;
    let (difference, simulated) = match ready.rules.measure {
        Measure::Ray => (rays.minus(&planned), rays.clone()),
        Measure::Arc => {
            let normal = topography(judged, along_normals.deviations(&judged.grid).map_err(failed)?);
            let difference = rays.minus(&normal);
            let f = planned.f.iter().zip(&difference.f).map(|(p, d)| p + d).collect();
            (difference, Topography { f, ..planned.clone() })
        }
    };
    let (sample, lengths) = &refereed.sample;
    let grid = RollGrid { w: sample.w().to_vec(), z: sample.z().to_vec() };
    let at_sample = along_normals.deviations(&grid).map_err(failed)?;
    let sample_difference = lengths.iter().zip(&at_sample).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    Ok(TangentialRun {
        pass: pass.flanks.clone(),
        settings: pass.settings.clone(),
        strokes,
        target,
        planned,
        simulated,
        model_difference: difference.largest(),
        sample_difference,
        refereed,
    })
}

pub(super) fn flank_result(
    ready: &TangentialPrepared,
    judged: &Judged,
    run: &TangentialRun,
    radial_feed: Option<RadialFeedResult>,
) -> TangentialFlankResult {
    let cos_b = ready.model.pair.work.flank(judged.flank).base_helix_angle.cos();
    let deviation = run.simulated.minus(&run.target);
    let largest = deviation.largest() * 1e3;
    TangentialFlankResult {
        flank: FlankResult {
            w_mm: run.target.w.clone(),
            z_mm: run.target.z.clone(),
            target_um: run.target.rows_um(),
            planned_um: run.planned.rows_um(),
            simulated_um: run.simulated.rows_um(),
            max_deviation_um: largest,
            tolerance_share: largest / ready.tolerance_um,
            rms_deviation_um: deviation.rms() * 1e3,
            model_difference_um: run.model_difference * 1e3,
            referee_error_um: run.refereed.verdict.grinding.error_um,
            feed_mark_um: None,
            line_dressing: None,
            target_characteristics: CharacteristicsUm::of(&run.target, cos_b),
            simulated_characteristics: CharacteristicsUm::of(&run.simulated, cos_b),
            traces: Vec::new(),
            outside_class_um: 0.0,
            planned_between_um: None,
            least_determinant_ratio: judged.least_ratio(),
        },
        dresser_position_mm: run.strokes.positions,
        dressing_stroke_mm: run.strokes.dressing,
        feed_stroke_mm: run.strokes.feed,
        worm_occupation_mm: run.strokes.worm_faces,
        sample_difference_um: run.sample_difference * 1e3,
        sample_error_um: run.refereed.sample_error_um,
        radial_feed,
    }
}

/// Radial feed beside it: twist by formula and by contact, and the whole target as far as it goes.
pub(super) fn radial_feed(
    ready: &TangentialPrepared,
    pass: &SettledPass,
    flank: Flank,
    fitted: &Result<(TangentialSettings, Fit), TangentialError>,
    target: &Topography,
) -> RadialFeedResult {
    let cos_b = ready.model.pair.work.flank(flank).base_helix_angle.cos();
    let crowning = CharacteristicsUm::of(target, cos_b).helix_crowning_um * cos_b * 1e-3;
    let plain = ready.model.radial_feed(flank, crowning, ready.rules.measure, FitGrid::Radii(5));
    let whole = fitted.as_ref().map_err(Clone::clone).and_then(|(settings, _)| {
        let ground = TangentialFlank::new(&ready.model, flank, &pass.flanks, settings, ready.rules.measure);
        let grid = RollGrid { w: target.w.clone(), z: target.z.clone() };
        Ok(Topography { f: ground.deviations(&grid)?, ..target.clone() }.minus(target))
    });
    let refused = plain.as_ref().err().or(whole.as_ref().err()).map(|error| Remark {
        code: error.code(),
        text: format!("radial feed cannot make this: {error}"),
        way_out: error.way_out().into(),
    });
    RadialFeedResult {
        lead_crowning_normal_um: crowning * 1e3,
        // The closed form counts material left, the product material removed.
        closed_twist_normal_um: -crowning * ready.model.natural_twist(flank) * 1e3,
        twist_normal_um: plain.ok().map(|r| -r.twist * 1e3),
        max_deviation_um: whole.as_ref().ok().map(|d| d.largest() * 1e3),
        deviation_um: whole.as_ref().ok().map(Topography::rows_um),
        refused,
    }
}
