//! K-bands of a job: whether measured traces without the target lie within them.

use super::evaluate::{Design, transverse_samples};
use super::result::BandResult;
use foundation::geometry::Gear;
use generating_grinding::job::{Band, Inspection as InspectionTable};
use job::{Diagnostic, Problem};
use measured_files::inspection::{Inspection, TraceKind};
use metrology::inspection::{BandFit, InspectionError, KBand};
use run::RunFailure;

/// The bands of a job, of profiles and of helix traces, and how traces are laid into them.
#[derive(Clone, Debug, Default)]
pub struct Bands {
    pub(super) profile: Option<(KBand, BandFit)>,
    pub(super) helix: Option<(KBand, BandFit)>,
}

impl Bands {
    /// # Errors
    /// [`RunFailure::BadInput`] for a band whose lists have other lengths, do not ascend, or cross.
    pub(super) fn of_table(table: &InspectionTable) -> Result<Self, RunFailure> {
        Ok(Self {
            profile: table.profile_band.as_ref().map(|b| band(b, "inspection.profile_band")).transpose()?,
            helix: table.helix_band.as_ref().map(|b| band(b, "inspection.helix_band")).transpose()?,
        })
    }

    /// What the band of its kind says of a trace, by its number in the inspection; `None` without a band.
    ///
    /// # Errors
    /// A trace that the band does not cover enough of, or that cannot be evaluated.
    pub(super) fn judge(
        &self,
        inspection: &Inspection,
        gear: &Gear,
        number: usize,
        design: Option<Design<'_>>,
    ) -> Option<Result<BandResult, InspectionError>> {
        let trace = &inspection.traces[number];
        let (band, fit) = match trace.kind {
            TraceKind::Profile => self.profile.as_ref()?,
            TraceKind::Helix => self.helix.as_ref()?,
        };
        let samples = transverse_samples(inspection, gear, trace, design);
        Some(samples.and_then(|samples| band.judge(&samples, *fit)).map(|found| BandResult {
            passed: found.passed(),
            margin_um: 1e3 * found.margin,
            shift_um: 1e3 * found.shift,
        }))
    }
}

fn band(of: &Band, field: &str) -> Result<(KBand, BandFit), RunFailure> {
    let wrong = |message: String, allowed: &str| {
        let finding =
            Diagnostic::new(Problem::InvalidTable, message).field(field.to_owned()).allowed(allowed);
        RunFailure::bad_input(finding.way_out("give one lower and one upper limit for every place"))
    };
    let count = of.at_mm.len();
    if of.lower_um.len() != count || of.upper_um.len() != count {
        let message =
            format!("{count} places, {} lower and {} upper limits", of.lower_um.len(), of.upper_um.len());
        return Err(wrong(message, "lists of one length"));
    }
    if let (Some(held), [first, .., last]) = (of.held_at_mm, &of.at_mm[..])
        && !(*first..=*last).contains(&held)
    {
        let message = format!("the trace is to be held at {held} mm, outside its band");
        let finding = Diagnostic::new(Problem::InvalidNumber, message)
            .field(format!("{field}.held_at_mm"))
            .value(held)
            .allowed(format!("{first} to {last}, the places of the band"));
        return Err(RunFailure::bad_input(
            finding.way_out("choose a place within the band, or leave it out"),
        ));
    }
    let mm = |um: &[f64]| um.iter().map(|um| 1e-3 * um).collect::<Vec<f64>>();
    let made = KBand::new(&of.at_mm, &mm(&of.lower_um), &mm(&of.upper_um))
        .map_err(|error| RunFailure::bad_input(Diagnostic::of(&error).field(field.to_owned())))?;
    Ok((made, of.held_at_mm.map_or(BandFit::Free, BandFit::Fixed)))
}
