//! Of a case: what follows from its drawing, points and normals of the flank, the range of its column planes.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, compare_vectors, list, tolerance};
use super::super::ledger::Ledger;
use super::body::Body;
use super::case::MilledCase;
use foundation::geometry::FlankLine;

/// Limits in height and the quantities of section 1; `mm` and `unit` are the tolerances of lengths and of angles.
pub(super) fn derived(
    case: &MilledCase,
    [mm, unit]: [f64; 2],
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let [root, tip] = case.heights();
    let height = if matches!(case.body, Body::Cylinder { .. }) { mm } else { unit };
    expected.numbers(&[("a_root", root), ("a_tip", tip)], height, ledger);
    let Some(mut derived) = expected.object("derived", ledger) else { return };
    match &case.body {
        Body::Cylinder { helicoid, radii: [tip, root] } => {
            let lengths =
                [("r", helicoid.pitch_radius()), ("rb", helicoid.base_radius()), ("ra", *tip), ("rf", *root)];
            derived.numbers(&lengths, mm, ledger);
            let angles = [
                ("etab", helicoid.base_space_half_angle()),
                ("bb", helicoid.base_helix_angle()),
                ("k", helicoid.twist()),
            ];
            derived.numbers(&angles, unit, ledger);
        }
        Body::Bevel(gear) => {
            derived.numbers(&[("Re", gear.outer_distance()), ("Rm", gear.mean_distance())], mm, ledger);
            let angles = [
                ("etab", gear.base_space_half_angle()),
                ("db", gear.base_angle()),
                ("d0", gear.root_angle()),
                ("da", gear.tip_angle()),
                ("xip", gear.pitch_roll()),
            ];
            derived.numbers(&angles, unit, ledger);
            if let FlankLine::Circular(circle) = gear.line() {
                derived.number("E", circle.centre_distance(), mm, ledger);
            }
        }
        Body::Blade => {}
    }
    derived.finish(ledger);
}

/// The range of column planes.
pub(super) fn range(case: &MilledCase, expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked {
    let [from, to] = case.range()?;
    let Some(mut object) = expected.object("lead_range", ledger) else { return Ok(()) };
    let tolerance = tolerance(&mut object, "tolerance", ledger);
    object.numbers(&[("u_min", from), ("u_max", to)], tolerance, ledger);
    object.finish(ledger);
    Ok(())
}

/// Points and normals.
pub(super) fn points(case: &MilledCase, expected: &mut Expected<'_>, ledger: &mut Ledger) {
    let Some(object) = expected.object("flank_points", ledger) else { return };
    check_object(object, ledger, |object, ledger| {
        let tolerances =
            [tolerance(object, "tolerance_mm", ledger), tolerance(object, "tolerance_n", ledger)];
        let (a, b) = (list(object, "a", ledger)?, list(object, "b", ledger)?);
        if a.len() != b.len() || a.is_empty() {
            return Err("a and b: as many heights as lengths are needed here".into());
        }
        let jets: Vec<_> = a.iter().zip(&b).map(|(&a, &b)| case.flank.surface.jet(a, b)).collect();
        let points: Vec<_> = jets.iter().map(|jet| jet.point).collect();
        let normals: Vec<_> = jets.iter().map(|jet| jet.normal).collect();
        compare_vectors(object, "P_mm", &points, tolerances[0], ledger);
        compare_vectors(object, "n", &normals, tolerances[1], ledger);
        Ok(())
    });
}
