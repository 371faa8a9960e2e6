//! 20-generating-contact, block `equal_diagonal_ratio`: cone angles of the worm that make the diagonal ratio the same on
//! both flanks.

use super::bodies::{BaseTolerances, Body, base_data};
use super::expected::Expected;
use super::ledger::Ledger;
use super::reference::{self, Reference, Tolerances};
use contact::DiagonalLine;
use foundation::geometry::{Sides, WormChoice};
use generating::{EqualRatio, EqualRatioSearch, GeneratingError, Lever, generatrix};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    work: Body,
    z_1: i32,
    #[serde(rename = "d_S_mm")]
    d_s_mm: f64,
    hand: f64,
    rho_2_left_deg: f64,
    rho_2_right_deg: f64,
    search_limit_deg: f64,
    rho_1: WormLines,
}

/// Where the worm's lines run.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum WormLines {
    Generatrix,
}

impl Input {
    fn search(&self) -> Result<EqualRatio, GeneratingError> {
        let work = self.work.gear()?;
        let worm = WormChoice {
            threads: self.z_1,
            hand: self.hand,
            pitch_diameter: Some(self.d_s_mm),
            tip_diameter: None,
            pressure_angle: None,
            profile_shift: 0.0,
            cone_angle: 0.0,
        };
        let line = |deg: f64| DiagonalLine { rho: deg.to_radians() };
        let worm_line = match self.rho_1 {
            WormLines::Generatrix => &generatrix,
        };
        let search = EqualRatioSearch {
            work: &work,
            worm,
            work_lines: Sides { left: line(self.rho_2_left_deg), right: line(self.rho_2_right_deg) },
            worm_line,
        };
        let limit = self.search_limit_deg.to_radians();
        search.search(Lever::ConeAngle, [-limit, limit])
    }
}

/// Block `equal_diagonal_ratio`.
pub(super) fn equal_diagonal_ratio(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let tol = file.tolerances();
    for mut case in reference::cases("equal_diagonal_ratio", block, ledger) {
        let Some(input) = reference::read::<Input>(&case.name, case.input, ledger) else { continue };
        match input.search().and_then(|found| Ok((found.start.clone()?, found))) {
            Ok((start, found)) => one(&mut case.expected, start, &found, tol, ledger),
            Err(error) => case.expected.refused(&error, ledger),
        }
        case.expected.finish(ledger);
    }
}

fn one(
    expected: &mut Expected<'_>,
    start: Sides<f64>,
    found: &EqualRatio,
    tol: Tolerances<'_>,
    ledger: &mut Ledger,
) {
    let ratios = [("K_left_at_theta_0", start.left), ("K_right_at_theta_0", start.right)];
    expected.numbers(&ratios, tol.get("K_ZV1"), ledger);
    let angles: Vec<f64> = found.roots.iter().map(|root| root.value.to_degrees()).collect();
    expected.list("theta_1_deg", &angles, tol.get("theta_1_deg"), ledger);
    // The other quantities are those of the smallest cone angle; without one the file must not expect any.
    let Some(root) = found.roots.first() else { return };
    expected.number("K_ZV1", root.ratio, tol.get("K_ZV1"), ledger);
    expected.number("gamma_deg", root.design.crossed_axes_angle.to_degrees(), tol.get("rho_deg"), ledger);
    if let Some(mut worm) = expected.object("worm", ledger) {
        let base = BaseTolerances {
            length: tol.get("contact_mm"),
            angle_deg: tol.get("rho_deg"),
            ratio: tol.get("coefficient"),
        };
        base_data(&mut worm, &root.design.worm, base, ledger);
        worm.finish(ledger);
    }
}
