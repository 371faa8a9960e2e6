//! What a client asks of measurements, and states about them.

use flankwright::exchange::inspection::{DatumFace, SlopeReference};
use flankwright::exchange::job::Language;
use flankwright::geometry::Sides;
use flankwright::workflow::inspection::{SheetOptions, Statements};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Signs of helix slopes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Signs {
    /// +1 or -1.
    pub left: i8,
    /// +1 or -1.
    pub right: i8,
}

/// What the files of a measurement do not tell, and how its sheets look.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields, default)]
pub struct InspectOptions {
    /// Class of ISO 1328-1 whose tolerances are the limits, 1 to 11.
    pub class: Option<i32>,
    /// Helix traces with the top of the measuring machine upwards.
    pub top_up: bool,
    /// The gear was measured from the other end.
    pub from_other_end: bool,
    /// Signs of helix slopes as the file names the flanks.
    pub slope_signs: Option<Signs>,
    /// `+z` or `-z`.
    pub datum_face: Option<String>,
    /// `face-width` or `range`.
    pub helix_slope_over: Option<String>,
    /// `face-width` or `range`.
    pub profile_slope_over: Option<String>,
    /// The measured gear is the blank before grinding: the stock that it has over the gear of the job, tooth by tooth, as the table `stock.csv` for
    /// the key `stock.map`.
    pub blank: bool,
    /// Language of report, sheets and series, `en` or `de`; without it that of the job, else English.
    pub language: Option<String>,
    /// Puts the parts into the store.
    pub keep: bool,
    /// Their series there.
    pub series: Option<String>,
}

impl InspectOptions {
    /// As the workflow takes them.
    ///
    /// # Errors
    /// What is wrong: the key and what it takes.
    pub fn taken(&self) -> Result<Asked, (&'static str, &'static str)> {
        if self.class.is_some_and(|class| !(1..=11).contains(&class)) {
            return Err(("class", "1 to 11"));
        }
        if self.series.as_ref().is_some_and(|series| series.chars().any(char::is_control)) {
            return Err(("series", "a name without control characters"));
        }
        let over = |key, of: &Option<String>| match of.as_deref() {
            None => Ok(None),
            Some("face-width") => Ok(Some(SlopeReference::FaceWidth)),
            Some("range") => Ok(Some(SlopeReference::Range)),
            Some(_) => Err((key, "\"face-width\" or \"range\"")),
        };
        let datum_face = match self.datum_face.as_deref() {
            None => None,
            Some("+z") => Some(DatumFace::PlusZ),
            Some("-z") => Some(DatumFace::MinusZ),
            Some(_) => return Err(("datum_face", "\"+z\" or \"-z\"")),
        };
        let slope_signs = match self.slope_signs {
            Some(Signs { left: -1 | 1, right: -1 | 1 }) | None => self
                .slope_signs
                .map(|signs| Sides { left: f64::from(signs.left), right: f64::from(signs.right) }),
            Some(_) => return Err(("slope_signs", "1 or -1 for each flank")),
        };
        let statements = Statements {
            other_end: self.from_other_end,
            slope_signs,
            datum_face,
            helix_slope_over: over("helix_slope_over", &self.helix_slope_over)?,
            profile_slope_over: over("profile_slope_over", &self.profile_slope_over)?,
        };
        if self.blank && self.class.is_some() {
            return Err(("class", "nothing with blank: stock is not judged by a class"));
        }
        let sheet =
            SheetOptions { tolerance_class: self.class, top_up: self.top_up, ..SheetOptions::default() };
        Ok(Asked { sheet, statements, language: self.asked_language()? })
    }

    fn asked_language(&self) -> Result<Option<Language>, (&'static str, &'static str)> {
        match self.language.as_deref() {
            None => Ok(None),
            Some("en") => Ok(Some(Language::En)),
            Some("de") => Ok(Some(Language::De)),
            Some(_) => Err(("language", "\"en\" or \"de\"")),
        }
    }

    /// Whether anything is asked for that is about measured gears only.
    pub fn is_about_gears(&self) -> bool {
        Self { language: None, ..self.clone() } != Self::default()
    }

    /// What was stated about a stored part, unless something is stated in its place.
    pub fn with_stated(self, stored: &Statements) -> Self {
        let Self { class, top_up, blank, language, keep, series, .. } = self.clone();
        if self != (Self { class, top_up, blank, language, keep, series, ..Self::default() }) {
            return self;
        }
        let over = |of: Option<SlopeReference>| {
            of.map(|of| match of {
                SlopeReference::FaceWidth => "face-width".to_owned(),
                SlopeReference::Range => "range".to_owned(),
            })
        };
        let face = |face: DatumFace| match face {
            DatumFace::PlusZ => "+z".to_owned(),
            DatumFace::MinusZ => "-z".to_owned(),
        };
        // Signs are 1 or -1.
        let signs = |signs: Sides<f64>| Signs { left: signs.left as i8, right: signs.right as i8 };
        Self {
            from_other_end: stored.other_end,
            slope_signs: stored.slope_signs.map(signs),
            datum_face: stored.datum_face.map(face),
            helix_slope_over: over(stored.helix_slope_over),
            profile_slope_over: over(stored.profile_slope_over),
            ..self
        }
    }
}

/// What is asked of measurements, as the workflow takes it.
#[derive(Clone, Debug)]
pub struct Asked {
    /// How sheets look.
    pub sheet: SheetOptions,
    /// What files do not tell.
    pub statements: Statements,
    /// Language of pages, if not that of the job.
    pub language: Option<Language>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_stated_comes_back_as_options() {
        let statements = Statements {
            other_end: true,
            slope_signs: Some(Sides { left: 1.0, right: -1.0 }),
            datum_face: Some(DatumFace::MinusZ),
            helix_slope_over: Some(SlopeReference::FaceWidth),
            profile_slope_over: Some(SlopeReference::Range),
        };
        let asked = InspectOptions { blank: true, keep: true, ..InspectOptions::default() };
        let options = asked.clone().with_stated(&statements);
        assert_eq!(options.taken().unwrap().statements, statements);
        assert!(options.blank && options.keep);
        // What is stated now holds.
        let now = InspectOptions { datum_face: Some("+z".into()), ..asked };
        assert_eq!(now.clone().with_stated(&statements), now);
    }
}
