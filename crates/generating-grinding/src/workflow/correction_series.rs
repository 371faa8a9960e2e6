//! Dressing corrections as settings carry them: Chebyshev coefficients over the worm position.

use foundation::numerics::Chebyshev;
use std::f64::consts::PI;

/// The coefficients of DK as settings have them: d_phi_S and d_gamma in degrees, d_d and d_v_yA in mm.
pub fn correction_coefficients(corrections: &[Chebyshev; 4]) -> [Vec<f64>; 4] {
    let units = [180.0 / PI, 180.0 / PI, 1.0, 1.0];
    std::array::from_fn(|j| corrections[j].coefficients().iter().map(|c| c * units[j]).collect())
}

/// DK over the worm position from the coefficients of settings: d_phi_S and d_gamma in degrees, d_d and d_v_yA in mm; left out: 0.
pub fn correction_series([from, to]: [f64; 2], coefficients: [&[f64]; 4]) -> [Chebyshev; 4] {
    let units = [PI / 180.0, PI / 180.0, 1.0, 1.0];
    std::array::from_fn(|j| {
        let given = coefficients[j];
        let scaled = if given.is_empty() { vec![0.0] } else { given.iter().map(|c| c * units[j]).collect() };
        Chebyshev::from_coefficients(from, to, scaled)
    })
}
