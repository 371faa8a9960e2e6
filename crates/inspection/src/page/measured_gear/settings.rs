//! Settings of grinding and dressing in words, and what a correction changes on the machine.

use crate::workflow::CorrectionResult;
use report::Quantity;

/// A setting in words.
pub(super) fn words(name: &str) -> String {
    match name.rsplit_once('_').map_or(name, |(name, _)| name) {
        "d0" => "centre distance".into(),
        "d1" => "centre distance, linear over the feed".into(),
        "d2" => "centre distance, quadratic over the feed".into(),
        "phi0" => "angle of the workpiece".into(),
        "phi1" => "angle of the workpiece, linear over the feed".into(),
        "phi2" => "angle of the workpiece, quadratic over the feed".into(),
        other => other.replace('_', " ") + " of the worm",
    }
}

/// The unit of a setting or an axis, by the ending of its name.
pub(super) fn unit(name: &str) -> &str {
    match name.rsplit_once('_').map_or("", |(_, unit)| unit) {
        "um" => "µm",
        "deg" => "°",
        other => other,
    }
}

/// Changes of feed coefficients that move no point by as much are not shown, um.
const SHOWN_UM: f64 = 1e-3;

/// Half a face, mm, turns coefficients into what they move at its ends.
pub(super) fn change_on_the_machine(of: &CorrectionResult, half_mm: f64) -> Vec<Quantity> {
    let mut rows = Vec::new();
    for (symbol, unit, coefficients) in
        [("Δd", "µm", &of.machine.delta_d_um), ("Δφ_2", "µrad", &of.machine.delta_phi_2_urad)]
    {
        for (k, value) in coefficients.iter().enumerate() {
            let shown = (value * half_mm.powi(i32::try_from(k).unwrap_or(0))).abs() > SHOWN_UM;
            if !shown {
                continue;
            }
            let power = match k {
                0 => unit.to_owned(),
                1 => format!("{unit}/mm"),
                2 => format!("{unit}/mm²"),
                3 => format!("{unit}/mm³"),
                _ => format!("{unit}/mm⁴"),
            };
            rows.push(Quantity::number(
                &format!("coefficient of z_V2 to the power {k}"),
                symbol,
                *value,
                &power,
            ));
        }
    }
    for (flank, axes) in &of.machine.dressing {
        let named = [("Δφ_S", "deg"), ("Δγ", "deg"), ("Δd", "mm"), ("Δv_yA", "mm")];
        for ((symbol, unit), value) in named.into_iter().zip(axes) {
            rows.push(Quantity::number(
                &format!("dressing the {flank} flank, at most"),
                symbol,
                *value,
                unit,
            ));
        }
    }
    rows
}
