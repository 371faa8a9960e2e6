//! From an evaluated characteristic to its entry in the document.

use super::result::{SeriesCapability, SeriesCharacteristic, SeriesFigures, SeriesFinding, SeriesTrend};
use metrology::inspection::{CharacteristicSeries, InspectionWarning, RuleFinding, SeriesEvaluation};
use report::charts::format_significant;

/// The entry of a characteristic.
pub(super) fn characteristic(series: &CharacteristicSeries) -> SeriesCharacteristic {
    let mut remarks = series.notes.clone();
    let figures = match &series.evaluation {
        Ok(found) => Some(figures(series, found)),
        Err(error) => {
            remarks.push(format!("no statistics: {error}; {}", error.way_out()));
            None
        }
    };
    if let Ok(found) = &series.evaluation {
        let limited = series.limits.lower().is_some() || series.limits.upper().is_some();
        if limited && found.capability.cpk.is_none() {
            remarks.push("no capability: all parts are equal".into());
        }
        // Without limits there is no capability that could be doubtful.
        let told = found.warnings.iter().filter(|_| limited);
        remarks.extend(told.map(|warning| told_in(&series.unit, warning)));
        let jumped = found.findings.iter().any(|finding| finding.parts[0] < finding.parts[1]);
        if limited && jumped && found.capability.cpk.is_some() {
            remarks.push(
                "the level is not constant: Cp and Cpk describe these parts, they do not foretell others"
                    .into(),
            );
        }
    }
    SeriesCharacteristic {
        key: series.key.clone(),
        unit: series.unit.clone(),
        lower_limit: series.limits.lower(),
        upper_limit: series.limits.upper(),
        n: series.values.len(),
        parts: series.parts.iter().map(|place| place + 1).collect(),
        values: series.values.clone(),
        figures,
        remarks,
    }
}

/// A warning with the unit that the statistics do not know.
fn told_in(unit: &str, warning: &InspectionWarning) -> String {
    let InspectionWarning::TrendSignificant { slope, probability } = warning else {
        return warning.to_string();
    };
    format!(
        "the values drift by {} {unit} a part (probability by chance {}): capability means nothing then",
        format_significant(*slope, 3),
        format_significant(*probability, 2)
    )
}

fn figures(series: &CharacteristicSeries, found: &SeriesEvaluation) -> SeriesFigures {
    let (all, short) = (&found.capability, &found.short_term);
    let capability = all.cpk.map(|cpk| SeriesCapability {
        cp: all.cp,
        cp_interval_95: all.cp_interval_95,
        cpk,
        cpk_interval_95: all.cpk_interval_95,
        cpk_lower_95: all.cpk_lower_95,
        cp_mr: short.cp,
        cpk_mr: short.cpk,
        outside_ppm: all.outside_share.map(|share| 1e6 * share),
        one_sided: series.limits.lower().is_none() || series.limits.upper().is_none(),
    });
    let number = |place: usize| series.parts.get(place).map_or(0, |part| part + 1);
    let finding = |finding: &RuleFinding| SeriesFinding {
        rule: finding.rule.code(),
        meaning: finding.rule.words(),
        first: number(finding.parts[0]),
        last: number(finding.parts[1]),
    };
    SeriesFigures {
        mean: found.mean,
        mean_interval_95: found.mean_interval_95,
        s: found.deviation,
        s_interval_95: found.deviation_interval_95,
        min: found.least,
        max: found.greatest,
        range: found.range(),
        sigma_mr: found.control.sigma,
        control_limits: [found.control.lower(), found.control.upper()],
        moving_range: [found.control.mean_moving_range, found.control.moving_range_upper],
        capability,
        trend: found.trend.map(|trend| SeriesTrend {
            per_part: trend.slope,
            standard_error: trend.standard_error,
            interval_95: trend.slope_interval_95,
            start: trend.start,
            p: trend.probability,
        }),
        special_causes: found.findings.iter().map(finding).collect(),
    }
}
