//! The conventional way to crown a lead: the centre distance follows a parabola over the feed, and the flank twists
//! (`docs/mathematics/tangential-dressing.md#radial-feed`).

use super::channel::{Channel, Variable};
use super::model::TangentialModel;
use super::settings::TangentialSettings;
use super::target::FitGrid;
use super::{TangentialError, TangentialFlank};
use contact::Measure;
use foundation::geometry::Flank;

/// What radial feed leaves of a helix crowning. mm; normal to the flank.
#[derive(Clone, Debug, PartialEq)]
pub struct RadialFeed {
    /// The flank.
    pub flank: Flank,
    /// Helix crowning asked for.
    pub crowning: f64,
    /// Twist of material left, closed form of first order.
    pub closed_twist: f64,
    /// The same from the simulated corners; the excess is the shift of the contact near the base circle.
    pub twist: f64,
    /// Material left on the grid asked for, row-major `[w][z]`.
    pub deviations: Vec<f64>,
}

impl TangentialModel {
    /// Twist of conventional helix crowning per crowning, material left, of a flank: first order.
    pub fn natural_twist(&self, flank: Flank) -> f64 {
        let pair = &self.pair.flanks[flank];
        let [from, to] = self.rolls(flank);
        // z = (c_w2 w + c_c2 - z_g)/c_zv22, whose square has the mixed term.
        8.0 * pair.c_w2 / (pair.c_zv22 * pair.c_zv22) * (to - from) / self.input().face_width
    }

    /// The settings of conventional helix crowning of a flank by `crowning` (mm, normal, material removed at the ends): the tool does not
    /// shift, the worm is plain.
    pub fn radial_feed_settings(&self, flank: Flank, crowning: f64) -> TangentialSettings {
        let mut settings = TangentialSettings::default();
        // dm/dd = sin(alpha_n) of the flank's own rack (`docs/mathematics/tangential-dressing.md#channels-and-variables`).
        let by_distance = self.pair.flanks[flank].operating_alpha_n.sin();
        let amount = -crowning / (by_distance * self.scales.effect(Channel::CentreDistance));
        settings.set(&Variable::power(Channel::CentreDistance, 2), amount);
        settings.set(&Variable::shift_ratio(), -self.shift_ratio);
        settings
    }

    /// The flank that radial feed leaves.
    ///
    /// # Errors
    /// [`TangentialError::Undercut`] where the crowning is too much near the base circle.
    pub fn radial_feed(
        &self,
        flank: Flank,
        crowning: f64,
        measure: Measure,
        grid: FitGrid,
    ) -> Result<RadialFeed, TangentialError> {
        let settings = self.radial_feed_settings(flank, crowning);
        let ground = TangentialFlank::new(self, flank, &[flank], &settings, measure);
        let grid = grid.of(self, flank);
        let deviations = ground.deviations(&grid)?;
        let (rows, columns) = (grid.w.len(), grid.z.len());
        let at = |i: usize, j: usize| deviations[i * columns + j];
        let twist = (at(rows - 1, columns - 1) - at(rows - 1, 0)) - (at(0, columns - 1) - at(0, 0));
        Ok(RadialFeed {
            flank,
            crowning,
            closed_twist: crowning * self.natural_twist(flank),
            twist,
            deviations,
        })
    }
}
