//! The drawn root of the space at any place along the tooth, and what the passes of the root leave on it.

use super::finish::least_height;
use super::meeting::Line;
use super::sweep::Sweep;
use super::{
    ActiveFlank, ColumnPlane, CutterLocation, LeadPoint, MilledSide, MillingError, MillingPlan,
    OperationKind, Orientation, PlanOptions, RootDepth, RootSection, Space, SpaceFlank,
};
use foundation::geometry::{Cutter, CutterShape, SurfaceJet};
use foundation::numerics::equidistant;
use nalgebra::Vector3;

/// Points of a straight piece or a fillet that limit roughing: a cutter between two of them comes nearer by hundredths of the distance of
/// a tenth of a millimetre that they have.
const LIMITS: usize = 41;

/// A part of the drawn root.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootPart {
    /// The fillet below a flank.
    Fillet(MilledSide),
    /// Between both fillets.
    Bottom,
}

/// A point of the drawn root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RootPoint {
    /// Which part it belongs to.
    pub part: RootPart,
    /// Lead parameter of its column plane.
    pub u: f64,
    /// Abscissa and ordinate of the point and of its normal out of the material, in the column plane; mm.
    pub in_plane: [[f64; 2]; 2],
    /// The point, mm.
    pub point: Vector3<f64>,
    /// The normal, a unit vector.
    pub normal: Vector3<f64>,
}

/// The passes of the root as they are run.
#[derive(Clone, Debug)]
pub struct RootModel {
    passes: Vec<Sweep>,
}

/// The section of the root in the column plane of a lead point, below the lowest active point of a flank there.
///
/// # Errors
/// [`MillingError::RootTool`] for a cutter that is no end mill; those of locations and sections.
pub fn drawn_section(
    lead: &LeadPoint,
    lowest: &SurfaceJet,
    options: &PlanOptions,
    orientation: Orientation,
    depth: RootDepth,
) -> Result<RootSection, MillingError> {
    let shape = options.cutter.shape();
    let CutterShape::Conical { corner_radius, half_angle: 0.0, .. } = *shape else {
        return Err(MillingError::RootTool);
    };
    let length = options.cutter.cutting_length();
    // The axis is the same at every contact height.
    let axis = CutterLocation::new(lowest, lead, shape, length, least_height(shape), orientation)?.axis;
    RootSection::new(lead, &lowest.point, &lowest.normal, &axis, corner_radius, length, depth)
}

/// The drawn root in the column plane at a lead parameter: `counts` points on each fillet and on the bottom, if it is milled. Empty
/// without a pass of the root.
///
/// # Errors
/// Those of guide curve, columns and sections.
pub fn drawn_root(
    space: &Space,
    options: &PlanOptions,
    u: f64,
    counts: [usize; 2],
) -> Result<Vec<RootPoint>, MillingError> {
    let Some((depth, with_bottom)) = options.root else { return Ok(Vec::new()) };
    let lead = space.lead.at(u)?;
    let in_space = |[x, y]: [f64; 2]| lead.abscissa() * x + lead.base_normal * y;
    let place = |part, in_plane: [[f64; 2]; 2]| RootPoint {
        part,
        u,
        in_plane,
        point: lead.point + in_space(in_plane[0]),
        normal: in_space(in_plane[1]),
    };
    let (mut points, mut ends) = (Vec::new(), Vec::new());
    for flank in space.flanks.iter().filter(|flank| options.sides.contains(&flank.side)) {
        let lowest = lowest_active(&flank.active.extended(), &lead)?;
        let section = drawn_section(&lead, &lowest, options, options.orientation_on(flank.side()), depth)?;
        points.extend(
            section.fillet(counts[0]).into_iter().map(|at| place(RootPart::Fillet(flank.side()), at)),
        );
        ends.push(section.lowest);
    }
    if let (true, Some(&first)) = (with_bottom, ends.first()) {
        // With one flank only, the other end is mirrored.
        let last = ends.get(1).copied().unwrap_or([-first[0], first[1]]);
        let [from, to] = if first[0] < last[0] { [first, last] } else { [last, first] };
        let way = [to[0] - from[0], to[1] - from[1]];
        let length = way[0].hypot(way[1]);
        let normal = if length > 0.0 { [-way[1] / length, way[0] / length] } else { [0.0, 1.0] };
        let at = |share: f64| [from[0] + way[0] * share, from[1] + way[1] * share];
        let shares = equidistant([0.0, 1.0], counts[1]);
        points.extend(shares.into_iter().map(|share| place(RootPart::Bottom, [at(share), normal])));
    }
    Ok(points)
}

/// Points of the drawn root in the column plane at a lead parameter, below both flanks of the space: the straight pieces and the fillets,
/// for cutters that have to keep away from them. Empty without a pass of the root.
///
/// # Errors
/// Those of [`drawn_root`].
pub fn root_limits(space: &Space, options: &PlanOptions, u: f64) -> Result<Vec<Vector3<f64>>, MillingError> {
    let lead = space.lead.at(u)?;
    let below = space.flanks.iter().map(|flank| drawn_below(flank, options, &lead));
    Ok(below.collect::<Result<Vec<_>, _>>()?.concat())
}

/// As [`root_limits`], below one flank in the column plane of a lead point.
pub(super) fn drawn_below(
    flank: &SpaceFlank,
    options: &PlanOptions,
    lead: &LeadPoint,
) -> Result<Vec<Vector3<f64>>, MillingError> {
    let Some((depth, _)) = options.root else { return Ok(Vec::new()) };
    let lowest = lowest_active(&flank.active.extended(), lead)?;
    let section = drawn_section(lead, &lowest, options, options.orientation_on(flank.side()), depth)?;
    let [from, to] = [section.lowest_active, section.fillet_start];
    let straight = equidistant([0.0, 1.0], LIMITS).into_iter();
    let straight = straight.map(|share| [0, 1].map(|k| from[k] + (to[k] - from[k]) * share));
    let fillet = section.fillet(LIMITS).into_iter().map(|[point, _]| point);
    let in_space = |[x, y]: [f64; 2]| lead.point + lead.abscissa() * x + lead.base_normal * y;
    Ok(straight.chain(fillet).map(in_space).collect())
}

/// The lowest active point of a flank in the column plane of a lead point.
fn lowest_active(flank: &ActiveFlank, lead: &LeadPoint) -> Result<SurfaceJet, MillingError> {
    let plane = ColumnPlane::new(flank, *lead);
    let [root, _] = plane.heights()?;
    Ok(plane.section(root, lead.u)?.jet)
}

impl RootModel {
    /// The passes of a plan; `None` without any.
    pub fn new(plan: &MillingPlan, options: &PlanOptions) -> Option<Self> {
        let columns = &plan.flanks.iter().find(|flank| !flank.root.is_empty())?.lines.path.columns;
        let mut passes = Vec::new();
        let mut run =
            |cutter: &Cutter, places: &mut dyn Iterator<Item = (f64, Vector3<f64>, Vector3<f64>)>| {
                // The end face reaches as far along the tooth as it is wide.
                passes.extend(Sweep::new(cutter.shape(), places, cutter.shape().radius()));
            };
        for flank in &plan.flanks {
            let at = flank.lines.path.columns.iter().map(|column| column.lead.u);
            let mut places = at.zip(&flank.root).map(|(u, (_, location))| (u, location.tip, location.axis));
            run(options.cutter_of(OperationKind::Fillet(flank.side)), &mut places);
        }
        for operation in plan.operations.iter().filter(|operation| operation.kind == OperationKind::Bottom) {
            for path in &operation.paths {
                // Bottom passes stand at the columns of the first flank, in their order.
                let at = columns.iter().map(|column| column.lead.u);
                let mut places = at.zip(&path.places).map(|(u, place)| (u, place.tip, place.axis));
                run(options.cutter_of(operation.kind), &mut places);
            }
        }
        Some(Self { passes })
    }

    /// What the passes leave on the normal of a point, mm, > 0 stock; `None` where none of them comes by.
    pub fn stock(&self, at: &RootPoint) -> Option<f64> {
        let line = Line { point: at.point, direction: at.normal };
        let lowest = self.passes.iter().filter_map(|pass| pass.lowest(&line, at.u));
        lowest.map(|lowest| lowest.length).reduce(f64::min)
    }
}
