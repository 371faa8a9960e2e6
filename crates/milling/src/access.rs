//! Whether tool, holder and spindle have room in an internal gear (end of `docs/mathematics/milling.md#positions-of-five-axes`): as bodies
//! of revolution in the whole ring where holder or spindle are known, else from the tip along the axis to the opposite circle of tooth
//! tips.

use super::{CutterLocation, FlankPlan, MillingError, PlanOptions, Space, WallKind};
use foundation::geometry::Cutter;

/// The ring of an internal gear: the cylinder of its tooth tips between the ends of its face. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ring {
    radius: f64,
    ends: [f64; 2],
}

impl Ring {
    /// The ring around a space; `None` for external teeth.
    fn of(space: &Space) -> Result<Option<Self>, MillingError> {
        let Some(flank) = space.flanks.first() else { return Ok(None) };
        let face = flank.active.face;
        let lead = space.lead.at(0.5 * (face[0] + face[1]))?;
        if lead.base_normal.xy().dot(&lead.point.xy()) >= 0.0 {
            return Ok(None);
        }
        let [_, tip] = flank.active.height_span();
        let ends = face.map(|end| flank.active.surface.point(tip, end));
        let radius = ends[0].xy().norm().min(ends[1].xy().norm());
        Ok(Some(Self { radius, ends: [ends[0].z.min(ends[1].z), ends[0].z.max(ends[1].z)] }))
    }

    /// Free length from the tip along the axis, mm; infinite where the axis leaves the ring through an end of its face by more than
    /// `beside`.
    fn free(&self, at: &CutterLocation, beside: f64) -> f64 {
        let (tip, along) = (at.tip.xy(), at.axis.xy());
        let (a, b) = (along.norm_squared(), tip.dot(&along));
        // Teeth reach inwards to the circle; the tip stands beyond it, so that the far crossing is the greater root.
        let reach = (-b + (b * b - a * (tip.norm_squared() - self.radius * self.radius)).max(0.0).sqrt()) / a;
        let z = at.tip.z + at.axis.z * reach;
        let opposite = (self.ends[0] - beside..=self.ends[1] + beside).contains(&z);
        if opposite { reach } else { f64::INFINITY }
    }
}

/// Largest radius of a tool, mm.
fn widest(cutter: &Cutter) -> f64 {
    cutter.steps().iter().fold(cutter.shape().radius(), |most, step| most.max(step.radius))
}

/// Refuses places of the flanks' and fillets' passes from which the tool would reach the teeth on the other side of an internal gear, or
/// holder and spindle any of its teeth and ends away from the space.
///
/// # Errors
/// [`MillingError::InternalAccess`], [`MillingError::RingMet`]; those of the guide curve.
pub fn check_access(space: &Space, options: &PlanOptions, flanks: &[FlankPlan]) -> Result<(), MillingError> {
    let Some(ring) = Ring::of(space)? else { return Ok(()) };
    let cutter = &options.cutter;
    let (needed, beside) = (cutter.length(), widest(cutter));
    for flank in flanks {
        let refuse = |row: usize, column: usize, at: &CutterLocation| {
            if cutter.is_held() {
                for part in space.walls(WallKind::Ring, options.safety) {
                    let kept = part.patch.keeps(cutter, &at.tip, &at.axis, part.wanted);
                    kept.map_err(|near| MillingError::RingMet {
                        side: flank.side,
                        row,
                        column,
                        from: part.name,
                        clearance: near.value,
                        wanted: part.wanted,
                    })?;
                }
                return Ok(());
            }
            let free = ring.free(at, beside);
            if free >= needed {
                return Ok(());
            }
            Err(MillingError::InternalAccess { side: flank.side, row, column, free, needed })
        };
        for (row, finished) in flank.rows.iter().enumerate() {
            for (column, at) in finished.locations.iter().enumerate() {
                refuse(row, column, at)?;
            }
        }
        for (column, (_, at)) in flank.root.iter().enumerate() {
            refuse(0, column, at)?;
        }
    }
    Ok(())
}
