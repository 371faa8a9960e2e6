//! Cylindrical gears of a job as spaces to be milled: one, or the two halves of a double-helical gear
//! (`docs/mathematics/milling.md#flanks-as-patches`).

use super::body::{Body, CLEARANCE, floor, part, with_offset};
use super::lands::lands;
use super::walls::{below_root_body, ring, root_cylinder, root_in_ring};
use crate::job::{LoadedMillingJob, MillingGear};
use crate::workflow::finding::failure;
use crate::{
    ActiveFlank, HeightLimits, HelixOnCylinder, LeadCurve, MirroredLead, Retraction, Space, SpaceFlank,
    lead_through_row,
};
use foundation::geometry::{Flank, Gear, Helicoid, Mirrored, NormalOffset, Surface};
use foundation::modification::EvaluationField;
use job::tables::Gear as Drawing;
use run::{
    ModifiedFlank, RunFailure, blank_of_job, gear_of_job, geometry_finding, modification_finding,
    specs_of_flank,
};
use std::sync::Arc;

/// The gear with all that its halves have in common.
struct Teeth<'a> {
    loaded: &'a LoadedMillingJob,
    drawing: &'a Drawing,
    gear: Gear,
    /// Tip radius, mm.
    tip: f64,
}

/// Where the teeth of a half lie.
#[derive(Clone, Copy)]
struct Extent {
    /// Ends of its teeth, mm.
    face: [f64; 2],
    /// z_0 of a double-helical gear, mm, and the side of it on which the teeth lie.
    kink: Option<(f64, f64)>,
}

impl Extent {
    /// The plane in which the teeth are mirrored: those towards -z are the image of those towards +z.
    fn mirror(&self) -> Option<f64> {
        self.kink.filter(|(_, side)| *side < 0.0).map(|(plane, _)| plane)
    }
}

/// The gear of a job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub(super) fn cylindrical(loaded: &LoadedMillingJob, given: &MillingGear) -> Result<Body, RunFailure> {
    let (job, drawing) = (&loaded.job, &given.drawing);
    let gear = gear_of_job(drawing).map_err(RunFailure::bad_input)?;
    blank_of_job(drawing).check(&gear).map_err(|error| on_gear(&error))?;
    let half = 0.5 * drawing.face_width;
    let [tip, root] = [drawing.tip_diameter, drawing.root_diameter].map(|diameter| 0.5 * diameter);
    let spaces = drawing.teeth.unsigned_abs() as usize;
    let base = Helicoid::new(&gear, Flank::Left);
    let (sign, twist) = (base.external_sign(), base.twist());
    let teeth = Teeth { loaded, drawing, gear, tip };
    let extents: Vec<Extent> = match given.double_helical {
        None => vec![Extent { face: [-half, half], kink: None }],
        Some(halves) => {
            let both = halves.faces(drawing.face_width).into_iter().zip([1.0, -1.0]);
            both.map(|(face, side)| Extent { face, kink: Some((halves.apex, side)) }).collect()
        }
    };
    let flanks = extents.iter().map(|extent| teeth.flanks(extent)).collect::<Result<Vec<_>, _>>()?;
    let mut radius = root;
    let other = if sign > 0.0 { 0.3 * root } else { root + 4.0 * drawing.normal_module };
    if let Some(row) = job.milling.lead_through_row {
        let rows = job.milling.rows.unwrap_or(row + 1);
        let on_root = HelixOnCylinder { radius: root, turn_per_length: twist, external_sign: sign };
        let first = flanks[0][0].active.extended();
        radius = lead_through_row(&first, &on_root, row, rows).map_err(|error| failure(&error))?;
    }
    let helix = Arc::new(HelixOnCylinder { radius, turn_per_length: twist, external_sign: sign });
    let spaces_of = |(extent, flanks): (&Extent, &Vec<SpaceFlank>)| {
        let place = |z: f64| {
            let in_upper = extent.mirror().map_or(z, |plane| 2.0 * plane - z);
            [tip, z, -twist * in_upper]
        };
        let lands = lands(flanks, spaces, &extent.face, place, sign);
        let mut space = part(job.milling.skew_deg, flanks.clone(), helix.clone(), spaces, lands);
        let below = below_root_body(job.milling.root.as_ref(), sign * (radius - root));
        let (foot, ends) = (root - sign * below, [-half, half]);
        if sign < 0.0 {
            let turns = ends.map(|z| place(z)[2]);
            space.walls.push(root_in_ring(foot, ends, turns, space.pitch));
            space.walls.extend(ring([tip, other], ends, turns, space.pitch));
        } else {
            space.walls.push(root_cylinder(foot, ends));
        }
        if let Some(plane) = extent.mirror() {
            let lead: Arc<dyn LeadCurve> = Arc::new(MirroredLead { curve: space.lead, plane });
            space.lead = lead;
        }
        space
    };
    let mut parts: Vec<Space> = extents.iter().zip(&flanks).map(spaces_of).collect();
    if let [upper, lower] = parts.as_mut_slice() {
        upper.other_half.clone_from(&lower.flanks);
        lower.other_half.clone_from(&upper.flanks);
        let own = upper.lands.clone();
        upper.lands.extend(&lower.lands);
        lower.lands.extend(own);
    }
    let retraction =
        if sign > 0.0 { Retraction::Outside(tip + CLEARANCE) } else { Retraction::Inside(tip - CLEARANCE) };
    let unknown = Vec::new();
    Ok(Body {
        parts,
        spaces,
        retraction,
        unknown,
        blank: [[tip, -half], [tip, half], [other, half], [other, -half]],
        floor: floor([[root, -half], [root, half]], sign),
    })
}

fn on_gear(error: &foundation::geometry::GeometryError) -> RunFailure {
    RunFailure::bad_input(geometry_finding(error, "gear"))
}

impl Teeth<'_> {
    /// Both flanks of a space in one half, or of the whole gear.
    fn flanks(&self, extent: &Extent) -> Result<Vec<SpaceFlank>, RunFailure> {
        Flank::BOTH.into_iter().map(|side| self.flank(side, extent)).collect()
    }

    fn flank(&self, side: Flank, extent: &Extent) -> Result<SpaceFlank, RunFailure> {
        let base = Helicoid::new(&self.gear, side);
        base.check_tip(self.tip).map_err(|error| on_gear(&error))?;
        let roll = |radius: f64| base.length_of_roll(radius).map_err(|error| on_gear(&error));
        let heights = [roll(0.5 * self.drawing.root_form_diameter())?, roll(self.tip)?];
        let surface = with_offset(base, self.offset(&base, side, extent)?);
        let surface: Arc<dyn Surface> = match extent.mirror() {
            Some(plane) => Arc::new(Mirrored::new(surface, plane)),
            None => surface,
        };
        let heights = HeightLimits::Constant(heights);
        let active = ActiveFlank { surface, heights, face: extent.face, kink: extent.kink };
        Ok(SpaceFlank { side, active })
    }

    /// What the job wants of the flank beside the involute. Of a double-helical gear modifications are those of a half over its own
    /// teeth, seen as in the half towards +z.
    fn offset(
        &self,
        base: &Helicoid,
        side: Flank,
        extent: &Extent,
    ) -> Result<Option<Arc<dyn NormalOffset>>, RunFailure> {
        let specs = self.loaded.job.target.modifications.as_deref().unwrap_or_default();
        if specs.is_empty() {
            return Ok(None);
        }
        let range = self.drawing.evaluation_range();
        let roll = |diameter: f64| base.length_of_roll(0.5 * diameter).map_err(|error| on_gear(&error));
        let [start, end] = [roll(range.start_diameter)?, roll(range.end_diameter)?];
        let ends = match (extent.kink, extent.mirror()) {
            (None, _) => [range.z_start, range.z_end],
            (Some(_), None) => extent.face,
            (Some(_), Some(plane)) => [2.0 * plane - extent.face[1], 2.0 * plane - extent.face[0]],
        };
        let rolls = [start.min(end), start.max(end)];
        let field = EvaluationField::new(rolls, ends, base.base_radius(), base.base_helix_angle())
            .map_err(|error| RunFailure::bad_input(modification_finding(&error, "gear")))?;
        let modification = specs_of_flank(self.loaded, specs, side, &field).map_err(RunFailure::bad_input)?;
        Ok(Some(Arc::new(ModifiedFlank::new(modification))))
    }
}
