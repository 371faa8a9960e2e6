//! What a part costs by the shop's rates.

use super::TechnologyError;
use super::error::{in_range, positive};

/// The shop's rates, in its currency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates {
    /// Machine with its operator, per hour.
    pub machine_per_hour: f64,
    /// A worm.
    pub worm_price: f64,
    /// Time to change it, s.
    pub worm_change: f64,
    /// A dresser.
    pub dresser_price: f64,
    /// Dressings that it lasts.
    pub dressings_per_dresser: f64,
}

/// Cost of one part by its origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CostPerPart {
    /// Time of the machine.
    pub machine: f64,
    /// Share of the worm.
    pub worm: f64,
    /// Share of the dresser.
    pub dresser: f64,
    /// Share of the time to change the worm.
    pub change: f64,
}

impl CostPerPart {
    /// All of it.
    pub fn total(&self) -> f64 {
        self.machine + self.worm + self.dresser + self.change
    }
}

/// What time and dressings cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CostGoal {
    /// Machine, per second.
    pub per_second: f64,
    /// Shares of worm, its change and dresser in the parts between two dressings.
    pub per_dressing: f64,
}

impl CostGoal {
    /// Of a part that takes `part` seconds.
    pub fn per_part(&self, part: f64, parts_per_dressing: f64) -> f64 {
        self.per_second * part + self.per_dressing / parts_per_dressing
    }
}

impl Rates {
    /// For a worm that grinds as many parts as so many dressings of the new one.
    pub fn goal(&self, full_dressings: f64) -> CostGoal {
        let per_second = self.machine_per_hour / 3600.0;
        let worm = (self.worm_price + self.worm_change * per_second) / full_dressings;
        CostGoal { per_second, per_dressing: worm + self.dresser_price / self.dressings_per_dresser }
    }

    /// Of a part that takes `part` seconds.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn per_part(
        &self,
        part: f64,
        parts_per_dressing: f64,
        parts_per_worm: f64,
    ) -> Result<CostPerPart, TechnologyError> {
        for (field, value) in [
            ("cost.machine_per_hour", self.machine_per_hour),
            ("cost.worm_price", self.worm_price),
            ("cost.worm_change_min", self.worm_change / 60.0),
            ("cost.dresser_price", self.dresser_price),
        ] {
            in_range(field, value, value >= 0.0, ">= 0")?;
        }
        positive("cost.dressings_per_dresser", self.dressings_per_dresser)?;
        positive("parts_per_dressing", parts_per_dressing)?;
        positive("parts_per_worm", parts_per_worm)?;
        let per_second = self.machine_per_hour / 3600.0;
        Ok(CostPerPart {
            machine: part * per_second,
            worm: self.worm_price / parts_per_worm,
            dresser: self.dresser_price / (self.dressings_per_dresser * parts_per_dressing),
            change: self.worm_change * per_second / parts_per_worm,
        })
    }
}
