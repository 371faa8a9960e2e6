//! What a drawing says of tooth thickness and quality, as REXS has it: a span or a size over balls with both allowances, and the class of
//! the flanks. Allowances of the normal tooth thickness on the arc have no attribute: the schema knows those of the chord.

use serde::{Deserialize, Serialize};

use super::document::Component;
use super::draft::Draft;
use super::error::RexsError;
use super::gear::RexsGear;
use super::values::{Asked, title};
use super::warning::{RexsWarning, RexsWarningKind};
use foundation::geometry::{Gear, GearData, GeometryError, ThicknessMeasure};
use job::tables::{Allowances, Gear as JobGear, OverBalls, Span};

const UM: f64 = 1e-3;
/// A measure that differs by no more from that of the profile shift is the one that was written, mm.
const SAME_MEASURE: f64 = 2e-3;

const SPAN_TEETH: &str = "number_of_teeth_for_span_measurement";
const SPAN: &str = "span_measurement";
const SPAN_ALLOWANCES: [&str; 2] =
    ["lower_backlash_allowance_referenced_to_span", "upper_backlash_allowance_referenced_to_span"];
const BALL: &str = "diameter_of_measuring_ball_or_pin";
const SIZE: &str = "size_over_balls";
const BALL_ALLOWANCES: [&str; 2] =
    ["lower_backlash_allowance_balls_or_pins", "upper_backlash_allowance_balls_or_pins"];
const CLASS: &str = "global_tolerance_class_iso_1328_2013";

/// A measure of the tooth thickness with its allowances; without them it is that of the profile shift of the gear.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RexsThickness {
    /// What is measured.
    pub measure: RexsMeasure,
    /// Lower and upper allowance of it.
    pub allowances_um: Allowances,
}

/// What allowances of the tooth thickness are stated of.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum RexsMeasure {
    /// The span.
    Span(Span),
    /// The size over (internal: between) balls.
    OverBalls(OverBalls),
}

impl RexsThickness {
    /// That of a job; `None` without allowances, or where they are those of the tooth thickness itself.
    pub(super) fn of_job(gear: &JobGear) -> Option<Self> {
        let allowances_um = gear.allowances_um?;
        let measure = match (gear.span, gear.over_balls) {
            (Some(span), _) => RexsMeasure::Span(span),
            (None, Some(balls)) => RexsMeasure::OverBalls(balls),
            (None, None) => return None,
        };
        Some(Self { measure, allowances_um })
    }

    /// The profile shift of the gear that is made: in the middle between both allowances.
    fn made(&self, nominal: GearData) -> Result<f64, GeometryError> {
        let more = UM * self.allowances_um.middle();
        let measure = match self.measure {
            RexsMeasure::Span(Span { teeth, length }) => {
                ThicknessMeasure::Span { teeth, length: length + more }
            }
            RexsMeasure::OverBalls(OverBalls { ball, size }) => {
                ThicknessMeasure::OverBalls { ball, size: size + more }
            }
        };
        measure.profile_shift(nominal)
    }

    /// Writes it.
    pub(super) fn write(&self, draft: Draft) -> Draft {
        let Allowances { lower, upper } = self.allowances_um;
        match self.measure {
            RexsMeasure::Span(Span { teeth, length }) => draft
                .integer(SPAN_TEETH, i32::try_from(teeth).unwrap_or(i32::MAX))
                .number(SPAN, length)
                .number(SPAN_ALLOWANCES[0], lower)
                .number(SPAN_ALLOWANCES[1], upper),
            RexsMeasure::OverBalls(OverBalls { ball, size }) => draft
                .number(BALL, ball)
                .number(SIZE, size)
                .number(BALL_ALLOWANCES[0], UM * lower)
                .number(BALL_ALLOWANCES[1], UM * upper),
        }
    }

    /// Finds it in a component, that of the span first. `body` is the gear of the stated profile shift. What is not complete is reported and not
    /// used.
    pub(super) fn read(
        component: &Component,
        body: &Gear,
        warnings: &mut Vec<RexsWarning>,
    ) -> Result<Option<Self>, RexsError> {
        let of = Asked(component);
        let mut found = Vec::new();
        for (ids, in_um) in [(SPAN_ALLOWANCES, 1.0), (BALL_ALLOWANCES, 1.0 / UM)] {
            let [lower, upper] = [of.optional(ids[0])?, of.optional(ids[1])?];
            let (lower, upper) = match (lower, upper) {
                (None, None) => continue,
                (Some(lower), Some(upper)) if lower <= upper => (lower * in_um, upper * in_um),
                (Some(_), Some(_)) => {
                    not_taken(component, &format!("{} is above {}", ids[0], ids[1]), warnings);
                    continue;
                }
                (lower, _) => {
                    let missing = if lower.is_none() { ids[0] } else { ids[1] };
                    not_taken(component, &format!("{missing} is missing"), warnings);
                    continue;
                }
            };
            let measure =
                if ids == SPAN_ALLOWANCES { span(&of, body, warnings)? } else { balls(&of, body, warnings)? };
            let Some(measure) = measure else { continue };
            found.push(Self { measure, allowances_um: Allowances { lower, upper } });
        }
        if found.len() > 1 {
            not_taken(component, "those of the span hold", warnings);
        }
        Ok(found.into_iter().next())
    }
}

fn not_taken(component: &Component, why: &str, warnings: &mut Vec<RexsWarning>) {
    let message =
        format!("{} has allowances of the tooth thickness that are not taken: {why}", title(component));
    warnings.push(RexsWarning::new(RexsWarningKind::NotUsed, message));
}

fn span(
    of: &Asked<'_>,
    body: &Gear,
    warnings: &mut Vec<RexsWarning>,
) -> Result<Option<RexsMeasure>, RexsError> {
    if of.optional(SPAN_TEETH)?.is_none() {
        not_taken(of.0, &format!("{SPAN_TEETH} is missing"), warnings);
        return Ok(None);
    }
    let Some(teeth) = u32::try_from(of.integer(SPAN_TEETH)?).ok().filter(|teeth| *teeth > 0) else {
        not_taken(of.0, &format!("{SPAN_TEETH} is not above 0"), warnings);
        return Ok(None);
    };
    let own = body.span(teeth).map(|span| span.length);
    let length = nominal(of, SPAN, own, warnings)?;
    Ok(length.map(|length| RexsMeasure::Span(Span { teeth, length })))
}

fn balls(
    of: &Asked<'_>,
    body: &Gear,
    warnings: &mut Vec<RexsWarning>,
) -> Result<Option<RexsMeasure>, RexsError> {
    let Some(ball) = of.optional(BALL)? else {
        not_taken(of.0, &format!("{BALL} is missing"), warnings);
        return Ok(None);
    };
    let own = body.over_balls(ball, 0.0).map(|found| found.size);
    let size = nominal(of, SIZE, own, warnings)?;
    Ok(size.map(|size| RexsMeasure::OverBalls(OverBalls { ball, size })))
}

/// The measure to which allowances are added: the stated one, as long as the stated profile shift makes it.
fn nominal(
    of: &Asked<'_>,
    id: &'static str,
    own: Result<f64, GeometryError>,
    warnings: &mut Vec<RexsWarning>,
) -> Result<Option<f64>, RexsError> {
    let own = match own {
        Ok(own) => own,
        Err(error) => {
            not_taken(of.0, &error.to_string(), warnings);
            return Ok(None);
        }
    };
    let Some(stated) = of.optional(id)? else { return Ok(Some(own)) };
    if (stated - own).abs() <= SAME_MEASURE {
        return Ok(Some(stated));
    }
    let message = format!(
        "{} states {id} = {stated} mm, its profile shift makes {own:.4} mm; allowances are added to that of the profile shift",
        title(of.0)
    );
    warnings.push(RexsWarning::new(RexsWarningKind::Assumed, message));
    Ok(Some(own))
}

/// Writes a class of ISO 1328-1:2013.
pub(super) fn write_class(draft: Draft, class: Option<i32>) -> Draft {
    match class {
        Some(class) => draft.word(CLASS, &class.to_string()),
        None => draft,
    }
}

/// The class of ISO 1328-1:2013 that a component states.
pub(super) fn read_class(component: &Component) -> Result<Option<i32>, RexsError> {
    let of = Asked(component);
    let Some(word) = of.word(CLASS)? else { return Ok(None) };
    match word.trim().parse() {
        Ok(class @ 1..=11) => Ok(Some(class)),
        _ => Err(RexsError::BadValue {
            component: title(component),
            attribute: CLASS.into(),
            value: word.chars().take(60).collect(),
            allowed: "1 to 11",
        }),
    }
}

impl RexsGear {
    /// The profile shift of the gear that is made: in the middle between the allowances of its thickness, where it has some.
    ///
    /// # Errors
    /// Those of [`ThicknessMeasure::profile_shift`].
    pub fn made_profile_shift(&self) -> Result<f64, GeometryError> {
        match &self.thickness {
            Some(thickness) => thickness.made(*self.body()?.data()),
            None => Ok(self.profile_shift),
        }
    }
}
