//! The root in the column plane in the middle of the tooth: flank, straight piece, fillet, bottom, the tool in both passes, and what the
//! rays found there.

use super::outline::outline;
use crate::workflow::{MillingBodies, MillingOutcome, RefereedRoot, RootDeviationResult};
use crate::{FlankPlan, OperationKind};
use report::charts::{ChartError, Drawing, DrawingLayer, DrawingLook, DrawingNote, drawing};
use report::{Block, Figure, Quantity, Table};

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

/// Greatest height of the deviations in the drawing, mm.
const DRAWN: f64 = 0.5;

/// Drawing and figures, if the root is milled.
pub(super) fn blocks(outcome: &MillingOutcome) -> Result<Vec<Block>, ChartError> {
    let (bodies, plan) = (&outcome.prepared.bodies, &outcome.plan);
    let Some((_, with_bottom)) = bodies.options.root else { return Ok(Vec::new()) };
    let mut lines = Lines::default();
    for flank in &plan.flanks {
        add(&mut lines, bodies, flank, with_bottom);
    }
    if lines.flank.is_empty() {
        return Ok(Vec::new());
    }
    let bottom = match lines.lowest[..] {
        _ if !with_bottom => Vec::new(),
        [a, b, ..] => vec![vec![a, b]],
        [[x, y]] => vec![vec![[x, y], [-x, y]]],
        [] => Vec::new(),
    };
    let enlarged = enlargement(&outcome.root);
    let rays = format!("what the rays found, deviation {enlarged} times enlarged");
    let found = outcome.root.iter().map(RefereedRoot::name);
    let found = found.filter_map(|name| outcome.result.root.get_key_value(&name));
    lines.quantities.extend(found.flat_map(|(name, part)| figures(name, part)));
    let layer = |name: &str, look, lines_mm| DrawingLayer { name: name.into(), look, lines_mm };
    let section = Drawing {
        title: "Root in the column plane in the middle of the tooth".into(),
        subtitle: "across and above the guide curve; the tool is cut off at the height of the flank".into(),
        axes: Some(["across the guide curve [mm]".into(), "above the guide curve [mm]".into()]),
        layers: vec![
            layer("tool, bottom pass, at both ends of its travel", DrawingLook::OtherBody, lines.upright),
            layer("tool, fillet pass of the first flank", DrawingLook::Body, lines.tool),
            layer("active flank", DrawingLook::Edge, lines.flank),
            layer("straight piece", DrawingLook::OtherEdge, lines.straight),
            layer("fillet", DrawingLook::DottedEdge, lines.fillet),
            layer("bottom", DrawingLook::Path(1), bottom),
            layer(&rays, DrawingLook::Path(2), deviations(&outcome.root, f64::from(enlarged))),
        ],
        notes: lines.notes,
    };
    let flank_pass = "The side of the tool goes on below the lowest active place, its corner leaves the fillet from q about o.";
    let bottom_pass = " The second pass, axis upright, joins both fillets.";
    let caption = format!("{flank_pass}{}", if with_bottom { bottom_pass } else { "" });
    let svg = drawing(&section)?;
    let figure = Figure::new("root-in-the-column-plane-in-the-middle-of-the-tooth", svg, caption);
    Ok(vec![Block::Figure(figure), Block::Table(Table::of_quantities("", &lines.quantities))])
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
    lines.fillet.push(section.fillet(ARC).into_iter().map(|[at, _]| at).collect());
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

/// Every part in the section in the middle, its points moved along their normals by the enlarged deviations; rays that no cutter meets
/// part the line.
fn deviations(root: &[RefereedRoot], enlarged: f64) -> Vec<Vec<[f64; 2]>> {
    let mut lines = Vec::new();
    for part in root {
        let middle = part.points[part.points.len() / 2].u;
        let mut line = Vec::new();
        for (point, found) in part.points.iter().zip(&part.simulated).filter(|(point, _)| point.u == middle) {
            let [at, normal] = point.in_plane;
            match found {
                Some(mm) => line.push([at[0] + normal[0] * mm * enlarged, at[1] + normal[1] * mm * enlarged]),
                None => lines.push(std::mem::take(&mut line)),
            }
        }
        lines.push(line);
    }
    lines.retain(|line| line.len() > 1);
    lines
}

/// A power of ten by which the largest deviation of the root stays drawable.
fn enlargement(root: &[RefereedRoot]) -> u32 {
    let found = root.iter().flat_map(|part| part.simulated.iter().flatten());
    let most = found.fold(0.0, |most: f64, mm| most.max(mm.abs()));
    [1000, 100, 10].into_iter().find(|enlarged| f64::from(*enlarged) * most <= DRAWN).unwrap_or(1)
}

/// What the rays found on a part.
fn figures(part: &str, result: &RootDeviationResult) -> Vec<Quantity> {
    let name = |what: &str| format!("{}, {what}", part.replace('_', " "));
    let mut list = vec![Quantity::count(&name("rays"), "", result.rays as i64)];
    let um = [
        ("highest stock", result.max_um),
        ("deepest place (or least stock)", result.min_um),
        ("rms", result.rms_um),
        ("prediction off by", result.model_difference_um),
    ];
    list.extend(um.into_iter().filter_map(|(what, um)| Some(Quantity::number(&name(what), "", um?, "µm"))));
    let unmilled: usize = result.unmilled.values().sum();
    if unmilled > 0 {
        list.push(Quantity::count(&name("rays that no cutter meets"), "", unmilled as i64));
    }
    list
}
