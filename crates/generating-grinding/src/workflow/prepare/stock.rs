//! `[stock]` of a job: what stands on the flanks, typed and in mm.

use crate::job::{HobMarks as JobHob, LoadedJob, Stock as JobStock};
use crate::stock_file::read_stock;
use foundation::geometry::{Flank, Sides};
use generating::GrindingSetup;
use grinding_technology::{Bodies, HobMarks, RunOut, Stock, StockTerm, TechnologyError, hob_mark_height};
use job::tables::OneOrSides;
use job::{Diagnostic, Problem, shown_number};
use run::RunFailure;

const UM: f64 = 1e-3;

/// Stock, and what its table does not have.
pub(super) struct StockOnGear {
    pub stock: Stock,
    /// Tooth spaces without rows, on the flank that lacks most.
    pub spaces_left_out: usize,
}

/// The stock of a job.
///
/// # Errors
/// A finding on `stock.profile` for a diameter below a base circle, on `stock.map` for a table that cannot be read, on `stock.hob` for a
/// hob that does not make the gear.
pub(super) fn stock_of_job(
    loaded: &LoadedJob,
    given: &JobStock,
    setup: &GrindingSetup,
) -> Result<StockOnGear, RunFailure> {
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
    let allowance = given.allowance_um.unwrap_or(OneOrSides::Both(0.0));
    let mut stock = Stock {
        profile: given.profile.iter().map(|place| (place.diameter, UM * place.um)).collect(),
        run_out: given.run_out.map(|run_out| RunOut {
            eccentricity: UM * run_out.eccentricity_um,
            angle: run_out.angle_deg.to_radians(),
        }),
        terms: given
            .terms
            .iter()
            .map(|term| StockTerm { i: term.i, j: term.j, amount: UM * term.um, flank: term.flank })
            .collect(),
        pitch: given.pitch_um.as_ref().map(|pitch| {
            let mm = |list: &[f64]| list.iter().map(|um| UM * um).collect();
            Sides { left: mm(&pitch.left), right: mm(&pitch.right) }
        }),
        hob: given.hob.map(|hob| marks(hob, setup)).transpose()?,
        ..Stock::constant(allowance.sides().map(|_, um| UM * um))
    };
    let mut spaces_left_out = 0;
    if let Some(file) = &given.map {
        let spaces = loaded.job.gear.teeth.unsigned_abs() as usize;
        let table = read_stock(&loaded.beside(file), spaces).map_err(|error| {
            let finding = Diagnostic::new(Problem::InvalidTable, error.to_string());
            let finding = finding.field("stock.map").value(format!("{file:?}"));
            RunFailure::bad_input(
                finding
                    .allowed("a table with the columns flank, w_mm, z_mm, um and, where wanted, space")
                    .way_out(
                        "correct the table, or let `flankwright inspect BLANK --job JOB --blank` write one",
                    ),
            )
        })?;
        spaces_left_out = table.left_out.left.max(table.left_out.right);
        stock.map = table.flanks;
    }
    Ok(StockOnGear { stock, spaces_left_out })
}

/// Worm and gear of a setup as what stock is worked out with.
///
/// # Errors
/// [`TechnologyError::CylindricalOnly`] for cones; contact below a base circle.
pub fn bodies_on_stock(setup: &GrindingSetup) -> Result<Bodies, TechnologyError> {
    let roll = Sides::from_fn(|flank| setup.fields[flank].roll());
    Bodies::new(setup.pair.clone(), setup.largest_tip_radius, setup.input.blank.face_width, roll)
}

/// Feed marks of the hob, by their height or by the hob.
fn marks(hob: JobHob, setup: &GrindingSetup) -> Result<HobMarks, RunFailure> {
    let JobHob { feed, height_um, tip_diameter, threads, origin } = hob;
    let height = match (height_um, tip_diameter.zip(threads)) {
        (Some(um), _) => UM * um,
        (None, Some((tip_diameter, threads))) => {
            // A job's range bounds the threads.
            let height = bodies_on_stock(setup)
                .and_then(|bodies| hob_mark_height(&bodies, (threads as i32, tip_diameter), feed));
            match height {
                Ok(height) => height,
                // Stock is not worked out for cones, which a remark says.
                Err(TechnologyError::CylindricalOnly { .. }) => 0.0,
                Err(error) => {
                    let finding = Diagnostic::with_code(error.code(), error.to_string());
                    return Err(RunFailure::bad_input(
                        finding
                            .field("stock.hob.tip_diameter")
                            .value(shown_number(tip_diameter))
                            .allowed("a hob that meshes with the gear")
                            .way_out("give tip diameter and threads of the hob, or height_um"),
                    ));
                }
            }
        }
        (None, None) => 0.0,
    };
    Ok(HobMarks { feed, height, origin })
}
