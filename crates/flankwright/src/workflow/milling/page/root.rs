//! The root in the column plane in the middle of the tooth: flank, straight piece, fillet, bottom, and the tool in both passes.

use super::outline::outline;
use crate::numerics::equidistant;
use crate::process::milling::{FlankPlan, MillingPlan, OperationKind, RootSection};
use crate::report::Quantity;
use crate::report::charts::{Drawing, DrawingLayer, DrawingLook, DrawingNote};
use crate::report::milling::Titled;
use crate::workflow::milling::MillingBodies;

/// Points of the fillet.
const ARC: usize = 17;

/// Lines of the root drawing as they come together.
#[derive(Default)]
struct Lines {
    flank: Vec<Vec<[f64; 2]>>,
    straight: Vec<Vec<[f64; 2]>>,
    fillet: Vec<Vec<[f64; 2]>>,
    tool: Vec<Vec<[f64; 2]>>,
    upright: Vec<Vec<[f64; 2]>>,
    notes: Vec<DrawingNote>,
    quantities: Vec<Quantity>,
    lowest: Vec<[f64; 2]>,
}

/// The drawing, if the root is milled.
pub(super) fn root(bodies: &MillingBodies, plan: &MillingPlan) -> Option<Titled> {
    let (_, with_bottom) = bodies.options.root?;
    let mut lines = Lines::default();
    for flank in &plan.flanks {
        add(&mut lines, bodies, flank, with_bottom);
    }
    if lines.flank.is_empty() {
        return None;
    }
    let bottom = match lines.lowest[..] {
        _ if !with_bottom => Vec::new(),
        [a, b, ..] => vec![vec![a, b]],
        [[x, y]] => vec![vec![[x, y], [-x, y]]],
        [] => Vec::new(),
    };
    let layer = |name: &str, look, lines_mm| DrawingLayer { name: name.into(), look, lines_mm };
    let drawing = Drawing {
        title: "Root in the column plane in the middle of the tooth".into(),
        subtitle: "across and above the lead curve; the tool is cut off at the height of the flank".into(),
        axes: Some(["across the lead curve [mm]".into(), "above the lead curve [mm]".into()]),
        layers: vec![
            layer("tool, bottom pass, at both ends of its travel", DrawingLook::OtherBody, lines.upright),
            layer("tool, fillet pass of the first flank", DrawingLook::Body, lines.tool),
            layer("active flank", DrawingLook::Edge, lines.flank),
            layer("straight piece", DrawingLook::OtherEdge, lines.straight),
            layer("fillet", DrawingLook::DottedEdge, lines.fillet),
            layer("bottom", DrawingLook::Path(1), bottom),
        ],
        notes: lines.notes,
    };
    let flank_pass = "The side of the tool goes on below the lowest active place, its corner leaves the fillet from q about o.";
    let bottom_pass = " The second pass, axis upright, joins both fillets.";
    let caption = format!("{flank_pass}{}", if with_bottom { bottom_pass } else { "" });
    Some(Titled { drawing, caption, quantities: lines.quantities })
}

fn add(lines: &mut Lines, bodies: &MillingBodies, flank: &FlankPlan, with_bottom: bool) {
    let middle = flank.root.len() / 2;
    let (Some((section, location)), Some(column)) =
        (flank.root.get(middle), flank.lines.path.columns.get(middle))
    else {
        return;
    };
    let lead = &column.lead;
    let active: Vec<[f64; 2]> = column.places.iter().map(|place| lead.in_plane(&place.jet.point)).collect();
    let top = active.iter().map(|p| p[1]).fold(f64::NEG_INFINITY, f64::max);
    let along = [location.axis.dot(&lead.abscissa()), location.axis.dot(&lead.base_normal)];
    let tip = lead.in_plane(&location.tip);
    let cutter = bodies.options.cutter_of(OperationKind::Fillet(flank.side));
    let height = ((top - tip[1]) / along[1]).clamp(section.contact_height, cutter.cutting_length());
    // The tools of both flanks would hide each other.
    if lines.tool.is_empty() {
        lines.tool.push(outline(cutter.shape(), height, tip, along));
    }
    lines.flank.push(active);
    lines.straight.push(vec![section.lowest_active, section.fillet_start]);
    lines.fillet.push(fillet(section));
    lines.lowest.push(section.lowest);
    if lines.notes.is_empty() {
        for (at_mm, text) in [
            (section.lowest_active, "lowest active place"),
            (section.fillet_start, "q"),
            (section.fillet_centre, "o"),
            (section.lowest, "lowest place"),
        ] {
            lines.notes.push(DrawingNote { at_mm, text: text.into() });
        }
    }
    let name = |what: &str| format!("{}, {what}", flank.side);
    lines.quantities.extend([
        Quantity::number(&name("lean of the axis"), "ν", section.lean.to_degrees(), "deg"),
        Quantity::number(&name("straight piece"), "h_b", section.straight, "mm"),
        Quantity::number(&name("angle of the fillet"), "", section.fillet_angle.to_degrees(), "deg"),
        Quantity::number(&name("contact height of the pass"), "h", section.contact_height, "mm"),
        Quantity::number(&name("half width between the lowest places"), "", section.half_width, "mm"),
    ]);
    let second = bodies.options.cutter_of(OperationKind::Bottom);
    let radius = outline(second.shape(), second.cutting_length(), [0.0; 2], [0.0, 1.0])
        .iter()
        .map(|p| p[0])
        .fold(0.0, f64::max);
    if !with_bottom {
        return;
    }
    if let Ok(pass) = section.bottom_pass(lead.u, radius) {
        let aside = pass.half_travel.copysign(section.lowest[0]);
        let height = (top - pass.height).min(second.cutting_length());
        lines.upright.push(outline(second.shape(), height, [aside, pass.height], [0.0, 1.0]));
        lines.quantities.push(Quantity::number(
            &name("half travel of the bottom pass"),
            "x_c",
            pass.half_travel,
            "mm",
        ));
    }
}

/// The arc from the straight piece to the lowest place.
fn fillet(section: &RootSection) -> Vec<[f64; 2]> {
    let [x, y] = section.fillet_centre;
    let from = [section.fillet_start[0] - x, section.fillet_start[1] - y];
    let radius = from[0].hypot(from[1]);
    let begin = from[1].atan2(from[0]);
    // To straight below, on the shorter way.
    let mut end = -std::f64::consts::FRAC_PI_2;
    if begin - end > std::f64::consts::PI {
        end += std::f64::consts::TAU;
    }
    let place = |angle: f64| [x + radius * angle.cos(), y + radius * angle.sin()];
    equidistant([begin, end], ARC).into_iter().map(place).collect()
}
