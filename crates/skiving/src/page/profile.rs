//! The profile that the measured tool will leave on the workpiece.

use foundation::geometry::{Flank, Sides};
use report::cells::flank_title;
use report::charts::{ChartError, LineChart, LineFrame, Panel, Series, line_chart_in};
use report::data::{Block, Figure};

/// Profiles to come.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfileView {
    /// Of both flanks.
    pub flanks: Sides<FlankProfile>,
}

/// The profile of a flank: deviations normal to it, > 0 = material left, um. Lists are as long as the lengths of roll, or empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlankProfile {
    /// w, mm, ascending.
    pub roll_mm: Vec<f64>,
    /// Prediction for the mean tooth.
    pub mean_um: Vec<f64>,
    /// Least over the teeth.
    pub least_um: Vec<f64>,
    /// Greatest over the teeth.
    pub greatest_um: Vec<f64>,
    /// Mean tooth after the change of the setting.
    pub corrected_um: Vec<f64>,
    /// What the simulation of the removal found: [w in mm, um].
    pub simulated: Vec<[f64; 2]>,
    /// Least and greatest deviation that is allowed.
    pub tolerance_um: Option<[f64; 2]>,
}

const TALL: f64 = 170.0;
const LEAST_UM: f64 = 0.5;

impl ProfileView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let panel = |flank: Flank| {
            let title = format!("{}: f_n [µm]", flank_title(flank));
            Panel::linear(title, LEAST_UM, self.flanks[flank].series())
        };
        let chart = LineChart {
            title: "Profile of the workpiece to come".into(),
            x_title: "length of roll w [mm]".into(),
            panels: Flank::BOTH.map(panel).into_iter().collect(),
        };
        let svg = line_chart_in(&chart, &LineFrame { panel_height: Some(TALL), beside: 0.0 })?;
        let caption = "Deviation normal to the flank, positive is material left. Least and greatest: over the single \
                       teeth of the tool.";
        Ok(vec![Block::Figure(Figure::new("profile-of-the-workpiece-to-come", svg, caption))])
    }
}

impl FlankProfile {
    fn series(&self) -> Vec<Series> {
        let lines = [
            ("mean tooth, predicted", &self.mean_um),
            ("after the correction", &self.corrected_um),
            ("least tooth", &self.least_um),
            ("greatest tooth", &self.greatest_um),
        ];
        let mut series: Vec<Series> = lines
            .into_iter()
            .filter(|(_, values)| !values.is_empty())
            .map(|(name, values)| Series::new(name, self.roll_mm.clone(), values.clone()))
            .collect();
        if !self.simulated.is_empty() {
            let (x, y) = self.simulated.iter().map(|[w, um]| (*w, *um)).unzip();
            series.push(Series::points("mean tooth, simulated", x, y));
        }
        if let (Some(limits), Some(from), Some(to)) =
            (self.tolerance_um, self.roll_mm.first(), self.roll_mm.last())
        {
            series.extend(limits.map(|um| Series::limit("tolerance", vec![*from, *to], vec![um; 2])));
        }
        series
    }
}
