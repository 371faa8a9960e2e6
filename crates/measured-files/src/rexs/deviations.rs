//! Measured profiles and helix traces as components of REXS; the number of the tooth stands in the component's name.

use super::document::Component;
use super::draft::Draft;
use super::error::RexsError;
use super::flank::FlankPlace;
use super::values::{Asked, title};
use super::warning::{RexsWarning, RexsWarningKind};
use crate::inspection::{Trace, TraceKind, Zero};

/// What stands before the number of the tooth.
const TOOTH: &str = "tooth ";

/// The name of a trace's component.
pub(super) fn name(trace: &Trace) -> String {
    format!("{TOOTH}{}{}", trace.tooth, trace.tag)
}

/// Number of the tooth and tag of a name.
fn tooth(name: &str) -> Option<(u32, String)> {
    let rest = name.trim().strip_prefix(TOOTH)?;
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    let tag = &rest[digits..];
    let letters = tag.chars().count() <= 8 && tag.chars().all(char::is_alphabetic);
    Some((rest[..digits].parse().ok()?, tag.to_owned())).filter(|_| letters)
}

/// The component of a trace; undefined samples are left out and reported.
pub(super) fn write(trace: &Trace, place: &FlankPlace, warnings: &mut Vec<RexsWarning>) -> Draft {
    let samples = trace.abscissa_mm.iter().zip(&trace.f_um).filter(|(a, f)| a.is_finite() && f.is_finite());
    let mut pairs: Vec<(f64, f64)> = samples.map(|(a, f)| (*a, 1e-3 * f)).collect();
    let left_out = trace.f_um.len() - pairs.len();
    if left_out > 0 {
        let message = format!("{left_out} undefined samples of {}, {} flank", name(trace), trace.flank);
        warnings.push(RexsWarning::new(RexsWarningKind::Lost, message));
    }
    let profile = trace.kind == TraceKind::Profile;
    for (at, _) in &mut pairs {
        *at = if profile { place.diameter(*at) } else { place.distance(*at) };
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (places, amounts): (Vec<f64>, Vec<f64>) = pairs.into_iter().unzip();
    if profile {
        Draft::new("profile_deviation")
            .list("diameters_of_profile_deviation", places)
            .list("profile_deviation_amounts", amounts)
            .number("position_of_profile_deviation", place.distance(trace.position_mm))
    } else {
        Draft::new("helix_deviation")
            .list("coordinates_of_helix_deviation", places)
            .list("helix_deviation_amounts", amounts)
            .number("diameter_of_helix_deviation", place.diameter(trace.position_mm))
    }
}

/// The trace of a component; `None` for another type.
pub(super) fn read(
    component: &Component,
    place: &FlankPlace,
    warnings: &mut Vec<RexsWarning>,
) -> Result<Option<Trace>, RexsError> {
    let of = Asked(component);
    let (kind, places, amounts, position) = match component.kind.as_str() {
        "profile_deviation" => {
            let id = "diameters_of_profile_deviation";
            let places = of.needed_list(id)?;
            let places: Result<Vec<f64>, _> = places.iter().map(|d| place.roll(component, id, *d)).collect();
            let position = place.height(of.number("position_of_profile_deviation")?);
            (TraceKind::Profile, places?, of.needed_list("profile_deviation_amounts")?, position)
        }
        "helix_deviation" => {
            let places = of.needed_list("coordinates_of_helix_deviation")?;
            let id = "diameter_of_helix_deviation";
            let position = place.roll(component, id, of.number(id)?)?;
            let places = places.iter().map(|xi| place.height(*xi)).collect();
            (TraceKind::Helix, places, of.needed_list("helix_deviation_amounts")?, position)
        }
        _ => return Ok(None),
    };
    if places.len() != amounts.len() || places.is_empty() {
        let what = format!("{} places and {} amounts", places.len(), amounts.len());
        return Err(RexsError::ArrayLength { component: title(component), what });
    }
    if component.sign.is_none() {
        let message =
            format!("{} does not say what positive deviations mean; material is taken", title(component));
        warnings.push(RexsWarning::new(RexsWarningKind::SignAssumed, message));
    }
    let (tooth, tag) = component.name.as_deref().and_then(tooth).unwrap_or_else(|| {
        let message = format!("the name of {} holds no number of a tooth; 0 stands in", title(component));
        warnings.push(RexsWarning::new(RexsWarningKind::Assumed, message));
        (0, String::new())
    });
    let mut pairs: Vec<(f64, f64)> = places.into_iter().zip(amounts).collect();
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (abscissa_mm, f_um) = pairs.into_iter().map(|(a, f)| (a, 1e3 * f)).unzip();
    let flank = place.involute.flank;
    Ok(Some(Trace { kind, tooth, flank, tag, position_mm: position, abscissa_mm, f_um, zero: Zero::Free }))
}
