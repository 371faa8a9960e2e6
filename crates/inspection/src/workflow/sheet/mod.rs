//! Fills the inspection sheet: from an inspection and its evaluation to the data that `crate::page::sheet` draws. mm become um
//! here, places along the face distances from the datum face.

mod foot;
mod head;
mod pitch;
mod topography;
mod traces;

use super::evaluate::EvaluatedGear;
use super::run::GearInspection;
use crate::page::sheet::{self, SheetData, SheetLimits, SheetPage, SheetValue};
use foundation::geometry::Sides;
use job::tables::Language;
use measured_files::inspection::{DatumFace, Inspection, TraceKind};
use metrology::inspection::{BandFit, KBand, ToleranceQuantity, reached_class};
use report::charts::ChartError;
use run::page_language;

/// What the user decides about a sheet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SheetOptions {
    /// Language of the sheet; [`inspection_sheet`] takes that of the inspection.
    pub language: Language,
    /// Class of ISO 1328-1:2013 that the gear has to reach; without one no limits are printed.
    pub tolerance_class: Option<i32>,
    /// Helix traces with the top of the measuring machine upwards (`oben up`) instead of the datum face downwards.
    pub top_up: bool,
    /// What was stated about the measurement.
    pub stated: Vec<String>,
    /// What the deviations are counted from, where it is not the involute.
    pub reference: Option<String>,
    /// Bands for the profiles in the transverse section, against the length of roll.
    pub profile_bands: Sides<Option<(KBand, BandFit)>>,
    /// Bands for the helix traces in the transverse section, against z.
    pub helix_bands: Sides<Option<(KBand, BandFit)>>,
}

impl SheetOptions {
    fn bands(&self, kind: TraceKind) -> &Sides<Option<(KBand, BandFit)>> {
        match kind {
            TraceKind::Profile => &self.profile_bands,
            TraceKind::Helix => &self.helix_bands,
        }
    }
}

/// Draws the sheet of a measured gear.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn sheet_pages(
    inspection: &Inspection,
    gear: &EvaluatedGear,
    options: &SheetOptions,
) -> Result<Vec<SheetPage>, ChartError> {
    sheet::sheet_pages(&sheet_data(inspection, gear, options))
}

/// The sheet of a measured gear as an HTML file of its own, one page of paper each. Where the part was judged against a job it shows
/// the deviations from the target, curves and figures alike, and says so.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn inspection_sheet(found: &GearInspection, options: &SheetOptions) -> Result<String, ChartError> {
    // What the part was judged by is what its sheet shows.
    let tolerance_class = found.result.tolerance_class.or(options.tolerance_class);
    let (language, stated) = (found.language, found.result.stated.clone());
    let options = &SheetOptions { language, stated, tolerance_class, ..options.clone() };
    let pages = match &found.against_target {
        None => sheet_pages(&found.inspection, &found.gear, options)?,
        Some(less) => {
            let reference = Some(format!("target of the job {}", found.result.job));
            let options = SheetOptions {
                reference,
                profile_bands: Sides::both(found.bands.profile.clone()),
                helix_bands: Sides::both(found.bands.helix.clone()),
                ..options.clone()
            };
            sheet_pages(&less.0, &less.1, &options)?
        }
    };
    let title = head::title(&found.inspection);
    let title = if title.is_empty() { &found.result.job } else { &title };
    let language = page_language(language);
    Ok(sheet::sheet_html(&format!("{} {title}", language.say("Inspection sheet")), language, &pages))
}

/// What stands on the sheet of a measured gear.
pub fn sheet_data(inspection: &Inspection, gear: &EvaluatedGear, options: &SheetOptions) -> SheetData {
    let sheet = Filling { inspection, gear, options, face: Face::of(inspection) };
    let (mut rows, undrawn) = sheet.rows();
    let further = rows.split_off(2);
    let mut rows = rows.into_iter();
    let empty = |kind| sheet.empty_row(kind);
    SheetData {
        language: page_language(options.language),
        title: head::title(inspection),
        product: concat!("flankwright ", env!("CARGO_PKG_VERSION")).into(),
        head: sheet.head(),
        profiles: rows.next().unwrap_or_else(|| empty(TraceKind::Profile)),
        helices: rows.next().unwrap_or_else(|| empty(TraceKind::Helix)),
        further,
        pitch: sheet.pitch(),
        foot: sheet.foot(undrawn),
        topographies: sheet.topographies(),
    }
}

/// What the sheet is filled from.
struct Filling<'a> {
    inspection: &'a Inspection,
    gear: &'a EvaluatedGear,
    options: &'a SheetOptions,
    face: Face,
}

/// How places along the face are counted on the sheet.
#[derive(Clone, Copy)]
struct Face {
    datum: DatumFace,
    width: Option<f64>,
}

impl Face {
    fn of(inspection: &Inspection) -> Self {
        Self { datum: inspection.conditions.datum_face, width: inspection.gear.face_width_mm }
    }

    /// Distance of a height z from the datum face; z itself without a face width.
    fn distance(self, z: f64) -> f64 {
        self.width.map_or(z, |b| self.datum.distance(z, b))
    }

    /// Whether that distance grows with z.
    fn rises(self) -> bool {
        self.width.is_none() || self.datum == DatumFace::MinusZ
    }

    fn symbol(self) -> &'static str {
        if self.width.is_some() { "ξ" } else { "z" }
    }

    fn datum_name(self) -> &'static str {
        match self.datum {
            DatumFace::PlusZ => "+z",
            DatumFace::MinusZ => "−z",
        }
    }
}

impl Filling<'_> {
    /// Limits of a quantity in um where a class is asked for.
    fn limits(&self, quantity: ToleranceQuantity, both_sides: bool) -> SheetLimits {
        let limit = self.options.tolerance_class.and_then(|class| {
            let tolerances = self.gear.tolerances.as_ref()?;
            Some(1e3 * tolerances.rounded(quantity, class).ok()?)
        });
        match limit {
            None => SheetLimits::default(),
            Some(limit) if both_sides => SheetLimits::both_sides(limit),
            Some(limit) => SheetLimits::upper(limit),
        }
    }

    /// A value in mm that is judged by its magnitude, with its limit and class, in um.
    fn judged(&self, symbol: &str, quantity: ToleranceQuantity, value: Option<f64>) -> SheetValue {
        let class = value.zip(self.gear.tolerances.as_ref()).map(|(value, tolerances)| {
            match reached_class(tolerances, quantity, value) {
                Ok(Some(class)) => format!("cl. {class}"),
                Ok(None) => "cl. > 11".into(),
                Err(_) => String::new(),
            }
        });
        SheetValue {
            limits: self.limits(quantity, is_slope(quantity)),
            class: class.unwrap_or_default(),
            ..SheetValue::new(symbol, value.map(|mm| 1e3 * mm), "µm", 1)
        }
    }
}

fn is_slope(quantity: ToleranceQuantity) -> bool {
    matches!(quantity, ToleranceQuantity::ProfileSlope | ToleranceQuantity::HelixSlope)
}
