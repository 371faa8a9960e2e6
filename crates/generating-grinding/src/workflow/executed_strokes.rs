//! The strokes of a worm flank as they are driven: from a plan or from `[settings.strokes]`, and back into settings. Knows no
//! referee and no report.

use super::correction_series::{correction_coefficients, correction_series};
use crate::job::{Settings, StrokeSettings, StrokeTables};
use crate::workflow::generating_finding;
use dressing::{ActiveArea, dressing_motion};
use foundation::geometry::Flank;
use foundation::kinematics::DressingMotion;
use foundation::numerics::Chebyshev;
use generating::{GeneratingError, StrokeLayout, StrokePlace, StrokedFlank};
use job::{Diagnostic, Problem};
use run::RunFailure;

/// One stroke.
#[derive(Clone, Debug)]
pub struct ExecutedStroke {
    /// What dresses which lengths of roll.
    pub place: StrokePlace,
    /// DK over v: rad, rad, mm, mm.
    pub corrections: [Chebyshev; 4],
    /// The motion that these corrections make.
    pub motion: DressingMotion,
    /// Worm positions v_zS that are driven, mm.
    pub driven: [f64; 2],
}

/// All strokes of a flank.
#[derive(Clone, Debug)]
pub struct ExecutedStrokes {
    /// The strokes.
    pub strokes: Vec<ExecutedStroke>,
    /// Lengths of roll and worm z that they finish together, mm.
    pub area: ([f64; 2], [f64; 2]),
}

impl ExecutedStrokes {
    /// Of a dressed flank; `None` for a dresser that is not there.
    pub fn of_flank(layout: &StrokeLayout, flank: Flank, stroked: &StrokedFlank) -> Option<Self> {
        let strokes = stroked.places.iter().zip(stroked.worm.strokes()).map(|(&place, along)| {
            let chain = layout.dressers.get(place.dresser)?.flanks[flank].chain;
            let corrections = along.corrections.clone();
            let motion = dressing_motion(chain, &corrections);
            let (from, to) = corrections[0].interval();
            Some(ExecutedStroke { place, corrections, motion, driven: [from, to] })
        });
        Some(Self { strokes: strokes.collect::<Option<_>>()?, area: stroked.area })
    }

    /// The strokes as settings carry them.
    pub fn settings(&self) -> Vec<StrokeSettings> {
        let of = |stroke: &ExecutedStroke| {
            let (v_from_mm, v_to_mm) = stroke.corrections[0].interval();
            let [d_phi_s_deg, d_gamma_deg, d_d_mm, d_v_ya_mm] = correction_coefficients(&stroke.corrections);
            StrokeSettings {
                dresser: stroke.place.dresser + 1,
                area_mm: stroke.place.area.part(),
                touching_mm: stroke.place.area.touching(),
                range_mm: stroke.place.range,
                v_from_mm,
                v_to_mm,
                d_phi_s_deg,
                d_gamma_deg,
                d_d_mm,
                d_v_ya_mm,
            }
        };
        self.strokes.iter().map(of).collect()
    }
}

/// The strokes of one flank that stand in settings.
///
/// # Errors
/// [`RunFailure`] for settings without strokes, strokes that leave stock, numbers that are none.
pub fn strokes_of_settings(
    settings: &Settings,
    layout: &StrokeLayout,
    flank: Flank,
) -> Result<StrokedFlank, RunFailure> {
    let StrokeTables { left, right } = &settings.strokes;
    let given = match flank {
        Flank::Left => left,
        Flank::Right => right,
    };
    let field = format!("settings.strokes.{flank}");
    if given.is_empty() {
        let finding = Diagnostic::new(
            Problem::MissingKey,
            format!("the strokes of the {flank} worm flank are missing"),
        )
        .field(field)
        .allowed("one entry for each stroke")
        .way_out("plan the job: `flankwright plan` writes them into settings.json");
        return Err(RunFailure::bad_input(finding));
    }
    let mut strokes = Vec::with_capacity(given.len());
    for (k, stroke) in given.iter().enumerate() {
        let area = ActiveArea::new(stroke.area_mm, stroke.touching_mm)
            .map_err(|e| generating_finding::on_field(&GeneratingError::from(e), &format!("{field}[{k}]")))?;
        let place = StrokePlace {
            dresser: stroke.dresser.saturating_sub(1),
            area,
            range: stroke.range_mm,
            over_face: None,
        };
        let coefficients: [&[f64]; 4] =
            [&stroke.d_phi_s_deg, &stroke.d_gamma_deg, &stroke.d_d_mm, &stroke.d_v_ya_mm];
        strokes.push((place, correction_series([stroke.v_from_mm, stroke.v_to_mm], coefficients)));
    }
    StrokedFlank::of_corrections(layout, flank, strokes).map_err(|e| generating_finding::on_field(&e, &field))
}
