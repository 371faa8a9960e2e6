//! A profile dressed in several strokes by the active areas of a dresser (`docs/mathematics/dressing.md#conditions`).

use super::bodies::Bodies;
use super::crowning::Task;
use crate::job::StrokeStudy;
use crate::workflow::explore::Refused;
use dressing::{ActiveArea, DressingError, MultiStroke, ProfileSection, Stroke, divide};
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use generating::GeneratingError;
use schemars::JsonSchema;
use serde::Serialize;

/// One stroke: what it dresses and with which correction.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StrokeFigures {
    /// Number of the active area, from 1.
    pub area: usize,
    /// Lengths of roll on the worm that it dresses.
    pub from_mm: f64,
    /// See `from_mm`.
    pub to_mm: f64,
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
    /// Its own profile: lengths of roll.
    pub w_mm: Vec<f64>,
    /// Normal modification there, positive = material left.
    pub f_n_um: Vec<f64>,
}

/// A profile dressed in strokes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StrokeCurve {
    /// What tells the bodies from the others; empty where nothing is compared.
    pub bodies: String,
    /// The strokes in ascending order of w.
    pub strokes: Vec<StrokeFigures>,
    /// Lengths of roll of the finished profile.
    pub w_mm: Vec<f64>,
    /// Its normal modification: the least of all strokes.
    pub f_n_um: Vec<f64>,
    /// The wanted one.
    pub wanted_um: Vec<f64>,
    /// Largest distance from the wanted profile; absent where stock stays.
    pub deviation_um: Option<f64>,
    /// Why there is no profile.
    pub refused: Option<Refused>,
}

impl StrokeCurve {
    /// The figures of the curve in one line.
    pub fn summary(&self) -> String {
        match (&self.refused, self.deviation_um) {
            (Some(refused), _) => format!("{}: {}", refused.code, refused.text),
            (None, deviation) => format!(
                "{} strokes, deviation from the wanted profile {:.4} um",
                self.strokes.len(),
                deviation.unwrap_or(f64::NAN)
            ),
        }
    }
}

/// Points of a stroke and of the finished profile.
const STROKE_POINTS: usize = 17;
const PROFILE_POINTS: usize = 201;

/// The strokes of one set of bodies.
pub fn curve(bodies: &Bodies, flank: Flank, study: &StrokeStudy) -> StrokeCurve {
    let mut curve = StrokeCurve {
        bodies: bodies.name.clone(),
        strokes: Vec::new(),
        w_mm: Vec::new(),
        f_n_um: Vec::new(),
        wanted_um: Vec::new(),
        deviation_um: None,
        refused: None,
    };
    let made = Task::new(bodies, flank).and_then(|(task, _)| {
        fill(&task, study, &mut curve).map_err(|error| Refused::from(&GeneratingError::from(error)))
    });
    curve.refused = made.err();
    curve
}

fn fill(task: &Task<'_>, study: &StrokeStudy, curve: &mut StrokeCurve) -> Result<(), DressingError> {
    let dresser = &task.tool.flanks[task.flank];
    let range = dresser.range;
    let on_worm = |share: f64| range.w_nf + share * range.length();
    let areas: Vec<ActiveArea> = study
        .areas
        .iter()
        .map(|area| ActiveArea::of_shares(dresser, [area.from, area.to], study.overlap))
        .collect::<Result<_, _>>()?;
    let starts = std::iter::once(0.0).chain(study.sections.iter().map(|s| s.to));
    let sections: Vec<ProfileSection<'_>> = study
        .sections
        .iter()
        .zip(starts)
        .filter_map(|(section, start)| {
            let area = *areas.get(section.area.checked_sub(1)?)?;
            Some(ProfileSection { tool: task.tool, area, range: [on_worm(start), on_worm(section.to)] })
        })
        .collect();
    let divided = divide(&sections, task.flank, study.overlap)?;
    let strokes: Vec<Stroke<'_>> = divided.iter().map(|(_, stroke)| *stroke).collect();
    let wanted = |w: f64| wanted_um(study, (w - range.w_nf) / range.length()) * 1e-3;
    let dressed = MultiStroke::solve(&strokes, task.flank, task.radius, &wanted)?;
    for ((section, _), made) in divided.iter().zip(dressed.strokes()) {
        let w = equidistant(made.covers, STROKE_POINTS);
        let points = made.profile().at_rolls(&w)?;
        let [d_phi, d_gamma, d_d, d_v] = made.dk;
        curve.strokes.push(StrokeFigures {
            area: study.sections[*section].area,
            from_mm: made.covers[0],
            to_mm: made.covers[1],
            d_phi_s_deg: d_phi.to_degrees(),
            d_gamma_deg: d_gamma.to_degrees(),
            d_d_mm: d_d,
            d_v_ya_mm: d_v,
            w_mm: w,
            f_n_um: points.iter().map(|p| p.f * 1e3).collect(),
        });
    }
    dressed.check_cover([range.w_nf, range.w_na])?;
    let w = equidistant([range.w_nf, range.w_na], PROFILE_POINTS);
    let points = dressed.at_rolls(&w)?;
    curve.f_n_um = points.iter().map(|p| p.point.f * 1e3).collect();
    curve.wanted_um = w.iter().map(|&w| wanted(w) * 1e3).collect();
    curve.w_mm = w;
    let apart = curve.f_n_um.iter().zip(&curve.wanted_um).map(|(f, g)| (f - g).abs());
    curve.deviation_um = Some(apart.fold(0.0, f64::max));
    Ok(())
}

/// The wanted modification at a share of the used profile, um: the parabola of its section, of the outer ones beyond the profile too.
fn wanted_um(study: &StrokeStudy, share: f64) -> f64 {
    let (mut from, mut start) = (0.0, study.start_um);
    let last = study.sections.len().saturating_sub(1);
    for (k, section) in study.sections.iter().enumerate() {
        if share <= section.to || k == last {
            let x = (share - from) / (section.to - from);
            let bow = section.middle_um - 0.5 * (start + section.end_um);
            return start + x * (section.end_um - start) + 4.0 * bow * x * (1.0 - x);
        }
        (from, start) = (section.to, section.end_um);
    }
    start
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::StrokeSection;

    #[test]
    fn the_wanted_profile_meets_its_points() {
        let section = |to, middle_um, end_um| StrokeSection { to, middle_um, end_um, area: 1 };
        let study = StrokeStudy {
            areas: Vec::new(),
            start_um: 4.0,
            sections: vec![section(0.25, 1.5, 0.0), section(1.0, -1.0, 0.5)],
            overlap: 0.0,
        };
        for (share, um) in [(0.0, 4.0), (0.125, 1.5), (0.25, 0.0), (0.625, -1.0), (1.0, 0.5)] {
            assert!((wanted_um(&study, share) - um).abs() < 1e-14, "{share}");
        }
        // Beyond its ends the profile goes on as the parabola of the outer section: equal second differences.
        let second =
            |x: f64| wanted_um(&study, x) - 2.0 * wanted_um(&study, x - 0.1) + wanted_um(&study, x - 0.2);
        assert!((second(1.1) - second(0.9)).abs() < 1e-12);
    }
}
