//! A grinding motion over the feed as curves, and their chart.

use foundation::kinematics::GeneratingMotion;
use foundation::numerics::equidistant;
use report::charts::{ChartError, LineChart, Panel, Series, Svg, line_chart};

/// Corrections of a grinding motion over the axial feed; lists of equal length.
#[derive(Clone, Debug, PartialEq)]
pub struct GrindingMotion {
    /// Flanks that it grinds, for example "both flanks".
    pub flanks: String,
    /// Axial feed z_V2, mm.
    pub z_v2_mm: Vec<f64>,
    /// Shift of the worm z_V1, mm.
    pub z_v1_mm: Vec<f64>,
    /// Change of the centre distance, um.
    pub delta_d_um: Vec<f64>,
    /// Additional rotation of the workpiece, urad.
    pub delta_phi_2_urad: Vec<f64>,
    /// Change of the crossed-axes angle, degree.
    pub delta_gamma_deg: Vec<f64>,
}

impl GrindingMotion {
    /// Of a motion over its stroke, at `rows` feeds.
    pub fn over(flanks: &str, motion: &GeneratingMotion, feed_range: [f64; 2], rows: usize) -> Self {
        let feeds: Vec<f64> = equidistant(feed_range, rows);
        Self {
            z_v1_mm: feeds.iter().map(|&v| motion.shift.value(v)).collect(),
            delta_d_um: feeds.iter().map(|&v| motion.delta_d.value(v) * 1e3).collect(),
            delta_phi_2_urad: feeds.iter().map(|&v| motion.delta_phi_2.value(v) * 1e6).collect(),
            delta_gamma_deg: feeds.iter().map(|&v| motion.delta_gamma.value(v).to_degrees()).collect(),
            flanks: flanks.to_owned(),
            z_v2_mm: feeds,
        }
    }
}

/// The grinding motion over the feed, a panel for each axis.
///
/// # Errors
/// [`ChartError`] for motions that are not finite or of different length, or without any motion.
pub fn grinding_motion_chart(motions: &[GrindingMotion]) -> Result<Svg, ChartError> {
    let swivels = motions.iter().any(|m| m.delta_gamma_deg.iter().any(|&x| x != 0.0));
    let panel = |title: &str, least_span: f64, pick: fn(&GrindingMotion) -> &Vec<f64>| {
        let series =
            motions.iter().map(|m| Series::new(&m.flanks, m.z_v2_mm.clone(), pick(m).clone())).collect();
        Panel::linear(title, least_span, series)
    };
    let mut panels = vec![
        panel("Worm shift z_V1 [mm]", 0.1, |m| &m.z_v1_mm),
        panel("Centre distance Δd [µm]", 0.01, |m| &m.delta_d_um),
        panel("Workpiece rotation Δφ_2 [µrad]", 0.1, |m| &m.delta_phi_2_urad),
    ];
    if swivels {
        panels.push(panel("Crossed-axes angle Δγ [°]", 1e-4, |m| &m.delta_gamma_deg));
    }
    line_chart(&LineChart {
        title: "Grinding motion over the axial feed".to_owned(),
        x_title: "z_V2 [mm]".to_owned(),
        panels,
    })
}
