//! `[stock]` and `[technology]` of a job: stock on the flanks, limits, times and rates, typed and in mm and s.

use crate::job::Job;
use foundation::geometry::{Flank, Sides};
use generating::GrindingSetup;
use grinding_technology::{PartTimes, Rates, RunOut, Stock};
use job::{Diagnostic, Problem, shown_number};
use run::RunFailure;

const UM: f64 = 1e-3;
/// Between areas for roughing and finishing where a job gives nothing, mm.
const ZONE_GAP: f64 = 2.0;

/// A limit of the shop for roughing and for finishing strokes; `None` where it gives none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ShopLimit {
    /// Strokes that leave something.
    pub roughing: Option<f64>,
    /// Strokes that leave nothing.
    pub finishing: Option<f64>,
}

/// What a job asks beside the flank.
#[derive(Clone, Debug)]
pub struct RemovalTask {
    /// On the flanks.
    pub stock: Stock,
    /// Q'_w, mm^3/(mm s).
    pub rates: ShopLimit,
    /// V'_w between two dressings, mm^3/mm.
    pub loads: ShopLimit,
    /// Used between two dressings, mm; `None` for a worm without a stated width.
    pub zone_width: Option<f64>,
    /// Between roughing and finishing, mm.
    pub zone_gap: f64,
    /// Jump from part to part, mm.
    pub step_per_part: f64,
    /// Times of a part beside grinding.
    pub times: Option<PartTimes>,
    /// Last tip diameter and what a dressing takes of the radius, mm.
    pub life: Option<[f64; 2]>,
    /// The shop's rates.
    pub cost: Option<Rates>,
}

impl RemovalTask {
    /// Of a job; `None` without stock.
    ///
    /// # Errors
    /// A finding on `stock.profile` for a diameter below a base circle.
    pub(super) fn of_job(job: &Job, setup: &GrindingSetup) -> Result<Option<Self>, RunFailure> {
        let Some(given) = job.stock.as_ref() else { return Ok(None) };
        let base = Flank::BOTH.map(|flank| 2.0 * setup.pair.work.flank(flank).base_radius);
        let least = base[0].max(base[1]);
        if let Some((k, place)) = given.profile.iter().enumerate().find(|(_, place)| place.diameter < least) {
            let finding = Diagnostic::new(Problem::InvalidNumber, "a diameter below the base circle")
                .field(format!("stock.profile[{k}].diameter"))
                .value(shown_number(place.diameter))
                .allowed(format!(">= {least:.4} mm, the base circle"))
                .way_out("give diameters of the involute profile");
            return Err(RunFailure::bad_input(finding));
        }
        let allowance: Sides<f64> = given.allowance_um.sides().map(|_, um| UM * um);
        let stock = Stock {
            profile: given.profile.iter().map(|place| (place.diameter, UM * place.um)).collect(),
            run_out: given.run_out.map(|run_out| RunOut {
                eccentricity: UM * run_out.eccentricity_um,
                angle: run_out.angle_deg.to_radians(),
            }),
            ..Stock::constant(allowance)
        };
        let technology = job.technology.clone().unwrap_or_default();
        let limits = technology.limits;
        Ok(Some(Self {
            stock,
            rates: ShopLimit { roughing: limits.Qw_roughing, finishing: limits.Qw_finishing },
            loads: ShopLimit { roughing: limits.Vw_roughing, finishing: limits.Vw_finishing },
            zone_width: limits.zone_width.or(job.worm.width),
            zone_gap: limits.zone_gap.unwrap_or(ZONE_GAP),
            step_per_part: technology.step_per_part.unwrap_or(0.0),
            times: technology.times.map(|times| PartTimes {
                load: times.load_s,
                index: times.index_s,
                other: times.other_s,
                dressing_aux: times.dressing_aux_s,
            }),
            life: technology.life.map(|life| [life.last_tip_diameter, life.radial_per_dressing]),
            cost: technology.cost.map(|cost| Rates {
                machine_per_hour: cost.machine_per_hour,
                worm_price: cost.worm_price,
                worm_change: 60.0 * cost.worm_change_min,
                dresser_price: cost.dresser_price,
                dressings_per_dresser: f64::from(cost.dressings_per_dresser),
            }),
        }))
    }
}
