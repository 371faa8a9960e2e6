//! 25-modifications: the contact data of its gears, elementary modifications, mapping and lengths at constant ratio.

use super::expected::Expected;
use super::gear_sets::{Hand, Set, entries, named};
use super::ledger::Ledger;
use super::reference::{self, Reference};
use contact::{DiagonalLine, DiagonalRatio, FlankPair};
use foundation::geometry::{Flank, GeometryError};
use foundation::modification::{EvaluationField, Modification, ModificationSpec};
use serde::Deserialize;
use serde_json::Value;

const UM: f64 = 1e-3;

/// The table `gears` states no tolerance of its own: the 1e-9 (mm, deg) of the file's mappings holds for it.
const GEAR_TOLERANCE: f64 = 1e-9;

/// Block `gears`.
pub(super) fn gears(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    for (name, entry) in block.as_object().into_iter().flatten() {
        let mut outer = Expected::new(name, "", entry, ledger);
        outer.informative(&["workpiece", "worm", "centre_distance_mm", "crossed_axes_angle_deg"]);
        if let (Some(mut flanks), Some(set)) =
            (outer.object("flanks", ledger), Set::read(name, entry, ledger))
        {
            bodies(name, &set, ledger);
            for flank in Flank::BOTH {
                let Some(mut side) = flanks.object(flank.name(), ledger) else { continue };
                if let Err(error) = contact_data(&set, flank, &mut side, ledger) {
                    side.refused(&error, ledger);
                }
                side.finish(ledger);
            }
            flanks.finish(ledger);
        }
        outer.finish(ledger);
    }
}

/// What the table says twice: helix and diameter of the worm, and its hand.
fn bodies(name: &str, set: &Set, ledger: &mut Ledger) {
    let (worm, pair) = (&set.worm, &set.pair);
    let diameter = 2.0 * pair.worm.pitch_radius();
    ledger.number(name, "worm.reference_diameter_mm", worm.reference_diameter_mm, diameter, GEAR_TOLERANCE);
    let hand = if worm.beta_deg >= 0.0 { Hand::Right } else { Hand::Left };
    ledger.equal(name, "worm.hand", (worm.hand == Hand::Right).into(), (hand == Hand::Right).into());
}

fn contact_data(
    set: &Set,
    flank: Flank,
    side: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), GeometryError> {
    let f = &set.pair.flanks[flank];
    let [w_f, w_a] = set.roll(flank)?;
    let line = set.worm_line(flank)?;
    let [g_1, g_2] = f.generatrices();
    // E = sum w_i/cos(beta_bi); the phase Phi is k_0F as a length on the base helices: m_n cos(alpha_n)/2 a radian.
    let base_length = f.work.base_radius * f.work.base_helix_angle.cos() / set.pair.work.tooth_count();
    let t_1 = line.rho.tan() + f.c_w1;
    let [_, path_2] = f.contact_path();
    let values = [
        ("r_b1_mm", f.worm.base_radius),
        ("beta_b1_deg", f.worm.base_helix_angle.to_degrees()),
        ("eta_b1_deg", f.worm.base_space_half_angle.to_degrees()),
        ("r_b2_mm", f.work.base_radius),
        ("beta_b2_deg", f.work.base_helix_angle.to_degrees()),
        ("eta_b2_deg", f.work.base_space_half_angle.to_degrees()),
        ("w_f_mm", w_f),
        ("w_a_mm", w_a),
        ("alpha_1_deg", f.operating_alpha_t1().to_degrees()),
        ("alpha_2_deg", f.operating_alpha_t2().to_degrees()),
        ("sin_alpha_n", f.operating_alpha_n.sin()),
        ("C_Fw1", f.c_w1),
        ("C_Fc1_mm", f.c_c1),
        ("C_Fw2", f.c_w2),
        ("C_Fc2_mm", f.c_c2),
        ("E_mm", -f.hat_c),
        ("tan_rho_F1", line.rho.tan()),
        ("T1", f.worm.base_helix_angle.cos() * t_1),
        ("rho_K_deg", path_2.rho.to_degrees()),
        ("tangent_A", f.e_r1.dot(&f.e_r2)),
        ("tangent_B", f.e_r1.dot(&g_2)),
        ("tangent_C", g_1.dot(&f.e_r2)),
        ("tangent_D", g_1.dot(&g_2)),
    ];
    side.numbers(&values, GEAR_TOLERANCE, ledger);
    let pitch = set.pair.work.normal_base_pitch(flank);
    side.periodic("Phi_mm", base_length * f.phase, pitch, GEAR_TOLERANCE, ledger);
    Ok(())
}

/// Block `mapping`.
pub(super) fn mapping(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    entries("mapping", block, ledger, |item, ledger| {
        // How well independent sources agreed when the file was made.
        item.informative(&["measured"]);
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let keys = ["K_ZV1", "z_V01_mm", "tan_rho_F1", "tolerance_mm"];
        let [Some(ratio), Some(shift_origin), Some(tan_rho_1), Some(tolerance)] =
            keys.map(|key| item.given(key, ledger))
        else {
            return Ok(());
        };
        let (Some(w), Some(z)) =
            (item.given_list("points_w_mm", ledger), item.given_list("points_z_mm", ledger))
        else {
            return Ok(());
        };
        let f = &set.pair.flanks[flank];
        let worm = DiagonalLine { rho: tan_rho_1.atan() };
        let work = f.work_direction(worm, ratio)?;
        item.periodic("rho_F2_deg", work.rho.to_degrees(), 180.0, tolerance, ledger);
        let diagonal = DiagonalRatio { ratio, shift_origin };
        let points = w.iter().zip(&z).map(|(&w, &z)| f.point_map(w, z, diagonal));
        let points = points.collect::<Result<Vec<_>, _>>()?;
        let list = |of: &dyn Fn(usize) -> f64| (0..points.len()).map(of).collect::<Vec<f64>>();
        item.list("z_V2_mm", &list(&|k| points[k].feed), tolerance, ledger);
        item.list("w_1_mm", &list(&|k| points[k].w_1), tolerance, ledger);
        item.list("z_1_mm", &list(&|k| points[k].z_1), tolerance, ledger);
        item.list("X_F1_mm", &list(&|k| worm.coordinate(points[k].w_1, points[k].z_1)), tolerance, ledger);
        item.list("X_F2_mm", &list(&|k| work.coordinate(w[k], z[k])), tolerance, ledger);
        Ok(())
    });
}

/// Block `constant_ratio_lengths`.
pub(super) fn constant_ratio_lengths(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    entries("constant_ratio_lengths", block, ledger, |item, ledger| {
        item.informative(&["check_mm"]);
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let (Some(ratio), Some(tolerance)) =
            (item.given("K_ZV1", ledger), item.given("tolerance_mm", ledger))
        else {
            return Ok(());
        };
        let f: &FlankPair = &set.pair.flanks[flank];
        let diagonal = DiagonalRatio { ratio, shift_origin: 0.0 };
        let (roll, face) = (set.roll(flank)?, set.face());
        let area = f.working_area(roll, face, diagonal)?;
        let length = |range: [f64; 2]| range[1] - range[0];
        item.number("worm_length_mm", length(area.z_1), tolerance, ledger);
        item.number("z_V2_travel_mm", length(area.feed), tolerance, ledger);
        let line = set.worm_line(flank)?;
        let pitch = f.line_range(line, roll, face, diagonal)?;
        item.number("area_pitch_mm", length(pitch) / line.rho.cos(), tolerance, ledger);
        Ok(())
    });
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FieldInput {
    w_f: f64,
    w_a: f64,
    #[serde(rename = "z_I")]
    z_1: f64,
    #[serde(rename = "z_II")]
    z_2: f64,
    r_b: f64,
}

/// Block `elementary`.
pub(super) fn elementary(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let mut outer = Expected::new("elementary", "", block, ledger);
    outer.informative(&["flank"]);
    let geometry = outer.take("geometry_mm").unwrap_or(&Value::Null);
    let geometry = reference::read::<FieldInput>("elementary", geometry, ledger);
    let (beta_b, tolerance) = (outer.given("beta_b_deg", ledger), outer.given("tolerance_um", ledger));
    let (w, z) = (outer.given_list("points_w_mm", ledger), outer.given_list("points_z_mm", ledger));
    let items = outer.objects("items", ledger);
    outer.finish(ledger);
    let (Some(g), Some(beta_b), Some(tolerance), Some(w), Some(z)) = (geometry, beta_b, tolerance, w, z)
    else {
        return;
    };
    let field = EvaluationField::new([g.w_f, g.w_a], [g.z_1, g.z_2], g.r_b, beta_b.to_radians());
    let field = match field {
        Ok(field) => field,
        Err(error) => return ledger.fail("elementary", "geometry_mm", Value::Null, error.to_string().into()),
    };
    for mut item in items {
        let spec = item.take("spec").unwrap_or(&Value::Null);
        let built = ModificationSpec::from_json(spec).and_then(|spec| Modification::build(&spec, &field));
        match built {
            Ok(modification) => {
                // A point without a value becomes NaN, which no tolerance lets pass.
                let value = |(&w, &z)| modification.value(w, z).map_or(f64::NAN, |f| f / UM);
                let values: Vec<f64> = w.iter().zip(&z).map(value).collect();
                item.list("f_t_um", &values, tolerance, ledger);
            }
            Err(error) => item.refused(&error, ledger),
        }
        item.finish(ledger);
    }
}
