//! 20-generating-contact, block `ground_flank`: what modified worm surfaces leave on the workpiece, exactly.

use super::bodies::{Body, ChainInput};
use super::expected::Expected;
use super::ledger::Ledger;
use super::reference::{self, Reference, Tolerances};
use contact::{ContactError, ContactSolution, ExactContact, Measure, ModifiedThread, Pair, Sensitivities};
use foundation::geometry::Flank;
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::numerics::Polynomial2;
use serde::Deserialize;
use serde_json::Value;

const UM: f64 = 1e-3;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    worm: Body,
    work: Body,
    chain: ChainInput,
    #[serde(rename = "z_V1_mm")]
    shift: Law,
    left: Side,
    right: Side,
}

/// sum c_k (z_V2 - origin)^k.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Law {
    coefficients: Vec<f64>,
    #[serde(rename = "z_V2_origin_mm")]
    origin: f64,
    unit: Unit,
}

#[derive(Clone, Copy, Deserialize)]
enum Unit {
    #[serde(rename = "mm/mm^k")]
    Millimetre,
    #[serde(rename = "um/mm^k")]
    Micrometre,
    #[serde(rename = "urad/mm^k")]
    Microradian,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Side {
    #[serde(rename = "Delta_d")]
    delta_d: Law,
    #[serde(rename = "Delta_phi_2")]
    delta_phi_2: Law,
    #[serde(rename = "Delta_gamma")]
    delta_gamma: Law,
    f_n1: Option<ThreadPolynomial>,
}

/// sum a_ij (w_1 - w_0)^i (z_1 - z_0)^j, um.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ThreadPolynomial {
    w_0_mm: f64,
    z_0_mm: f64,
    terms: Vec<(u8, u8, f64)>,
}

impl Law {
    fn law(&self) -> MotionLaw {
        let factor = match self.unit {
            Unit::Millimetre => 1.0,
            Unit::Micrometre => 1e-3,
            Unit::Microradian => 1e-6,
        };
        MotionLaw::polynomial(self.origin, self.coefficients.iter().map(|c| c * factor).collect())
    }
}

impl ThreadPolynomial {
    fn function(&self) -> Polynomial2 {
        let centred =
            Polynomial2::from_terms(self.terms.iter().map(|&(i, j, a)| (i.into(), j.into(), a * UM)));
        centred.shifted(-self.w_0_mm, -self.z_0_mm)
    }
}

impl Input {
    fn pair(&self) -> Result<Pair, ContactError> {
        Pair::new(self.worm.gear()?, self.work.gear()?, self.chain.chain())
    }

    fn side(&self, flank: Flank) -> &Side {
        match flank {
            Flank::Left => &self.left,
            Flank::Right => &self.right,
        }
    }

    fn motion(&self, pair: &Pair, flank: Flank) -> GeneratingMotion {
        let side = self.side(flank);
        GeneratingMotion {
            delta_d: side.delta_d.law(),
            delta_phi_2: side.delta_phi_2.law(),
            delta_gamma: side.delta_gamma.law(),
            ..pair.motion(self.shift.law())
        }
    }
}

/// Block `ground_flank`.
pub(super) fn block(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let tol = Tolerances::of(block);
    let mut outer = Expected::new("ground_flank", "", block, ledger);
    outer.informative(&["about", "tolerance"]);
    let list = outer.take("cases").unwrap_or(&Value::Null);
    outer.finish(ledger);
    for mut case in reference::cases("ground_flank", list, ledger) {
        case.expected.rename(&format!("ground_flank {}", case.name));
        let Some(input) = reference::read::<Input>(&case.name, case.input, ledger) else { continue };
        match input.pair() {
            Ok(pair) => {
                for flank in Flank::BOTH {
                    let Some(mut side) = case.expected.object(flank.name(), ledger) else { continue };
                    if let Err(error) = one(&input, &pair, flank, &mut side, tol, ledger) {
                        side.refused(&error, ledger);
                    }
                    side.finish(ledger);
                }
            }
            Err(error) => case.expected.refused(&error, ledger),
        }
        case.expected.finish(ledger);
    }
}

fn one(
    input: &Input,
    pair: &Pair,
    flank: Flank,
    side: &mut Expected<'_>,
    tol: Tolerances<'_>,
    ledger: &mut Ledger,
) -> Result<(), ContactError> {
    // How well two sources agreed when the file was made.
    side.informative(&["brute_minus_kernel_um"]);
    let (Some(w), Some(z)) = (side.given_list("points_w_mm", ledger), side.given_list("points_z_mm", ledger))
    else {
        return Ok(());
    };
    let points: Vec<(f64, f64)> = w.into_iter().zip(z).collect();
    let function = input
        .side(flank)
        .f_n1
        .as_ref()
        .map_or_else(|| Polynomial2::constant(0.0), ThreadPolynomial::function);
    let thread = ModifiedThread::new(pair.flanks[flank].worm, &function);
    let motion = input.motion(pair, flank);
    let exact = |measure| ExactContact::new(pair, flank, &motion, &thread).with_measure(measure);
    let (ray, arc) = (exact(Measure::Ray), exact(Measure::Arc));
    let solve = |solver: &ExactContact<'_, _>| -> Result<Vec<ContactSolution>, ContactError> {
        points.iter().map(|&(w, z)| solver.solve(w, z)).collect()
    };
    let (by_ray, by_arc) = (solve(&ray)?, solve(&arc)?);
    let list = |of: &dyn Fn(&ContactSolution) -> f64, from: &[ContactSolution]| -> Vec<f64> {
        from.iter().map(of).collect()
    };
    let f_n = list(&|s| s.f_n / UM, &by_ray);
    side.list("f_n2_ray_um", &f_n, tol.get("f_n2_um"), ledger);
    side.list("f_n2_arc_um", &list(&|s| s.f_n / UM, &by_arc), tol.get("f_n2_um"), ledger);
    let contact = tol.get("contact_mm");
    side.list("w_1_mm", &list(&|s| s.tool.0, &by_ray), contact, ledger);
    side.list("z_1_mm", &list(&|s| s.tool.1, &by_ray), contact, ledger);
    side.list("z_V2_mm", &list(&|s| s.feed, &by_ray), contact, ledger);
    let ratio = list(&|s| s.determinant_ratio, &by_ray);
    side.list("determinant_ratio", &ratio, tol.get("determinant_ratio"), ledger);

    let sensitivities: Vec<Sensitivities> = points
        .iter()
        .zip(&by_ray)
        .map(|(&(w, z), at)| ray.sensitivities(w, z, at))
        .collect::<Result<_, _>>()?;
    type Pick = fn(&Sensitivities) -> f64;
    let picks: [(&str, Pick); 5] = [
        ("d_f_d_centre_distance", |s| s.centre_distance),
        ("d_f_d_phi_2_mm_per_rad", |s| s.work_angle),
        ("d_f_d_gamma_mm_per_rad", |s| s.crossed_axes_angle),
        ("d_f_d_z_V1", |s| s.shift),
        ("d_f_d_f_n1", |s| s.tool_modification),
    ];
    for (key, pick) in picks {
        let values: Vec<f64> = sensitivities.iter().map(pick).collect();
        side.list_relative_to_largest(key, &values, tol.get("sensitivity_relative_to_largest"), ledger);
    }
    let cos = pair.flanks[flank].work.base_helix_angle.cos();
    if let Some(twist) = corner_twist(&points, &f_n) {
        side.number("corner_twist_S_transverse_um", twist / cos, tol.get("twist_um"), ledger);
    }
    Ok(())
}

/// S_c of `docs/mathematics/generating-contact.md#what-the-grinding-motion-leaves-to-first-order` from the corners of the field, in the
/// direction and unit of `f`; positive = removed.
fn corner_twist(points: &[(f64, f64)], f: &[f64]) -> Option<f64> {
    let least = |pick: fn(&(f64, f64)) -> f64| points.iter().map(pick).fold(f64::INFINITY, f64::min);
    let greatest = |pick: fn(&(f64, f64)) -> f64| points.iter().map(pick).fold(f64::NEG_INFINITY, f64::max);
    let (w, z) = ([least(|p| p.0), greatest(|p| p.0)], [least(|p| p.1), greatest(|p| p.1)]);
    let at = |i: usize, j: usize| points.iter().position(|&p| p == (w[i], z[j])).map(|k| f[k]);
    Some(-(at(1, 1)? - at(1, 0)? - at(0, 1)? + at(0, 0)?))
}
