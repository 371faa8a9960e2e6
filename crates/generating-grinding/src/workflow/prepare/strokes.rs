//! `[dressing.strokes]` and `dresser.others` of a job as the strokes of its bodies. Knows no plan.

use super::tools::dresser_profile;
use crate::job::{DresserModification, LoadedJob};
use crate::workflow::generating_finding;
use foundation::geometry::Sides;
use generating::{
    AreaOfDresser, DressedSection, DresserChoice, GivenDresser, GrindingSetup, StrokeChoice, StrokeLayout,
};
use run::RunFailure;

/// The strokes of a job; `None` where the worm is dressed in one.
///
/// # Errors
/// [`RunFailure`] with a finding on `dressing.strokes` or on the modification of a dresser.
pub fn strokes_of_job(loaded: &LoadedJob, setup: &GrindingSetup) -> Result<Option<StrokeLayout>, RunFailure> {
    let (Some(strokes), Some(dresser)) = (&loaded.job.dressing.strokes, &loaded.job.dresser) else {
        return Ok(None);
    };
    let given =
        |tip_diameter: f64, pitch_diameter: Option<f64>, modification: &DresserModification, place: &str| {
            let specs = modification.given().unwrap_or_default();
            let carries = Sides::try_from_fn(|flank| {
                dresser_profile(loaded, specs, flank, &setup.fields[flank], (place, "the target"))
                    .map(|made| made.terms())
            });
            let choice = DresserChoice { tip_diameter, pitch_diameter, designed_for: None };
            carries.map(|carries| GivenDresser { choice, carries }).map_err(RunFailure::bad_input)
        };
    let (tip, pitch) = (dresser.tip_diameter, dresser.pitch_diameter);
    let mut dressers = vec![given(tip, pitch, &dresser.modification, "dresser.modification")?];
    for (k, other) in dresser.others.iter().enumerate() {
        let place = format!("dresser.others[{k}].modification");
        dressers.push(given(other.tip_diameter, other.pitch_diameter, &other.modification, &place)?);
    }
    // The job counts from 1; that its numbers name something has been checked.
    let areas = strokes
        .areas
        .iter()
        .map(|area| AreaOfDresser { dresser: area.dresser.saturating_sub(1), from: area.from, to: area.to })
        .collect();
    let sections = strokes
        .sections
        .iter()
        .map(|section| DressedSection { to: section.to.law(1.0), area: section.area.saturating_sub(1) })
        .collect();
    let choice = StrokeChoice { dressers, areas, sections, overlap: strokes.overlap };
    StrokeLayout::new(setup, &choice)
        .map(Some)
        .map_err(|e| generating_finding::on_field(&e, "dressing.strokes"))
}
