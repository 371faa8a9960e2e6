//! Involute gears of a job as spaces to be milled: cylindrical ones, or with a cone angle; one space, or the two halves of a double-helical gear
//! (`docs/mathematics/milling.md#flanks-as-patches`).

use super::body::{Body, CLEARANCE, floor, join_halves, part, with_offset};
use super::lands::lands;
use super::walls::{below_root_body, ring, root_body, root_in_ring};
use crate::job::{LoadedMillingJob, MillingGear};
use crate::workflow::finding::failure;
use crate::{
    ActiveFlank, Along, HeightLimits, HelixOnCone, HelixOnCylinder, Kink, LeadCurve, MirroredLead,
    Retraction, RollOnCone, Space, SpaceFlank, Tapered, lead_through_row,
};
use foundation::geometry::{Flank, Gear, GeometryError, Helicoid, Mirrored, NormalOffset, Sides, Surface};
use foundation::modification::{EvaluationField, Modification, ModificationSpec};
use foundation::numerics::equidistant;
use job::tables::Gear as Drawing;
use job::{Diagnostic, Problem, shown_number};
use run::{
    ModifiedFlank, RunFailure, blank_of_job, gear_of_job, geometry_finding, job_files, modification_finding,
    specs_of_flank,
};
use std::sync::Arc;

/// A gear with all that its halves have in common.
pub(super) struct Teeth<'a> {
    pub loaded: &'a LoadedMillingJob,
    pub drawing: &'a Drawing,
    pub gear: Gear,
    /// Where its drawing and its modifications stand in the job.
    pub keys: (&'static str, &'static str),
}

/// Where the teeth of a half lie.
#[derive(Clone, Copy)]
struct Extent {
    /// Ends of its teeth, mm.
    face: [f64; 2],
    /// z_0 of a double-helical gear, and the side of it on which the teeth lie.
    kink: Option<Kink>,
}

impl Extent {
    /// The plane in which the teeth are mirrored: those towards -z are the image of those towards +z.
    fn mirror(&self) -> Option<f64> {
        self.kink.filter(|kink| kink.side < 0.0).map(|kink| kink.length)
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
    let sign = gear.external_sign();
    // The flanks of a conical gear have helices of their own; the middle of the space lies between them.
    let twist = 0.5 * Flank::BOTH.map(|side| Helicoid::new(&gear, side).twist()).iter().sum::<f64>();
    let taper = Taper::of(&gear);
    if taper.slope != 0.0 && taper.at(root, half.copysign(-taper.slope)) <= 0.0 {
        return Err(closed_root(drawing));
    }
    let teeth = Teeth { loaded, drawing, gear, keys: ("gear", "target.modifications") };
    let extents: Vec<Extent> = match given.double_helical {
        None => vec![Extent { face: [-half, half], kink: None }],
        Some(halves) => {
            let both = halves.faces(drawing.face_width).into_iter().zip([1.0, -1.0]);
            let kink = |side| Kink { length: halves.apex, side, along: Along::Axis };
            both.map(|(face, side)| Extent { face, kink: Some(kink(side)) }).collect()
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
    let helix: Arc<dyn LeadCurve> = match taper.slope {
        0.0 => Arc::new(HelixOnCylinder { radius, turn_per_length: twist, external_sign: sign }),
        slope => Arc::new(HelixOnCone { radius, slope, turn_per_length: twist }),
    };
    let spaces_of = |(extent, flanks): (&Extent, &Vec<SpaceFlank>)| {
        let place = |z: f64| {
            let in_upper = extent.mirror().map_or(z, |plane| 2.0 * plane - z);
            [taper.at(tip, z), z, -twist * in_upper]
        };
        // Between the edges of a land that tapers the turn is linear in pieces.
        let pieces = if taper.slope == 0.0 { 1 } else { LAND_PIECES };
        let lands = lands(flanks, spaces, &equidistant(extent.face, pieces + 1), place, sign);
        let mut space = part(job.milling.skew_deg, flanks.clone(), helix.clone(), spaces, lands);
        let below = below_root_body(job.milling.root.as_ref(), sign * (radius - root));
        let (foot, ends) = (root - sign * below, [-half, half]);
        if sign < 0.0 {
            let turns = ends.map(|z| place(z)[2]);
            space.walls.push(root_in_ring(foot, ends, turns, space.pitch));
            space.walls.extend(ring([tip, other], ends, turns, space.pitch));
        } else {
            space.walls.push(root_body(ends.map(|z| [taper.at(foot, z), z])));
        }
        if let Some(plane) = extent.mirror() {
            let lead: Arc<dyn LeadCurve> = Arc::new(MirroredLead { curve: space.lead, plane });
            space.lead = lead;
        }
        space
    };
    let mut parts: Vec<Space> = extents.iter().zip(&flanks).map(spaces_of).collect();
    join_halves(&mut parts);
    let retraction = match (sign > 0.0, taper.slope) {
        (false, _) => Retraction::Inside(tip - CLEARANCE),
        (true, 0.0) => Retraction::Outside(tip + CLEARANCE),
        (true, slope) => {
            Retraction::OutsideCone { half_angle: slope.atan(), distance: CLEARANCE, apex: -tip / slope }
        }
    };
    let unknown = Vec::new();
    Ok(Body {
        parts,
        spaces,
        retraction,
        unknown,
        blank: [[taper.at(tip, -half), -half], [taper.at(tip, half), half], [other, half], [other, -half]],
        floor: floor([-half, half].map(|z| [taper.at(root, z), z]), sign),
    })
}

/// Pieces of a conical gear's land.
const LAND_PIECES: usize = 8;

/// How the radii of a gear change along its axis: those of root, form and tip alike.
#[derive(Clone, Copy)]
struct Taper {
    /// mm for each mm towards +z; 0 of a cylindrical gear.
    slope: f64,
}

impl Taper {
    fn of(gear: &Gear) -> Self {
        // Not the negative zero of a cylindrical gear.
        let angle = gear.data().cone_angle;
        Self { slope: if angle == 0.0 { 0.0 } else { -angle.tan() } }
    }

    /// A radius at z = 0, at another position.
    fn at(&self, radius: f64, z: f64) -> f64 {
        radius + self.slope * z
    }
}

/// A root cone with its apex inside of the face.
fn closed_root(drawing: &Drawing) -> RunFailure {
    let text = "the root cone of the gear comes to its apex within the face";
    let finding = Diagnostic::new(Problem::InvalidGeometry, text)
        .field("gear.cone_angle_deg")
        .value(shown_number(drawing.cone_angle_deg))
        .allowed("an angle with which the root cone stays open all over the face");
    RunFailure::bad_input(
        finding.way_out("compare cone angle, root diameter and face width with the drawing"),
    )
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
        let surface = with_offset(base, self.offset(&base, side, extent)?);
        let taper = Taper::of(&self.gear);
        if taper.slope != 0.0 {
            let cones = self.cones(&base, taper, extent.face)?;
            let surface = Arc::new(Tapered::new(surface, cones));
            let heights = HeightLimits::Constant([0.0, 1.0]);
            return Ok(SpaceFlank {
                side,
                active: ActiveFlank { surface, heights, face: extent.face, kink: None },
            });
        }
        base.check_tip(0.5 * self.drawing.tip_diameter).map_err(|error| on_gear(&error))?;
        let heights = rolls(self.drawing, &base, "gear")?;
        let surface: Arc<dyn Surface> = match extent.mirror() {
            Some(plane) => Arc::new(Mirrored::new(surface, plane)),
            None => surface,
        };
        let heights = HeightLimits::Constant(heights);
        let active = ActiveFlank { surface, heights, face: extent.face, kink: extent.kink };
        Ok(SpaceFlank { side, active })
    }

    /// Form and tip cone on a flank of a conical gear.
    fn cones(&self, base: &Helicoid, taper: Taper, face: [f64; 2]) -> Result<[RollOnCone; 2], RunFailure> {
        let cone = |diameter: f64| {
            let on_face = |z: f64| base.length_of_roll(taper.at(0.5 * diameter, z)).map(|_| ());
            face.into_iter().try_for_each(on_face).map_err(|error| on_gear(&error))?;
            RollOnCone::new(0.5 * diameter, taper.slope, base.base_radius(), face).ok_or_else(|| {
                let least =
                    face.map(|z| taper.at(0.5 * diameter, z)).into_iter().fold(f64::INFINITY, f64::min);
                on_gear(&GeometryError::RadiusBelowBaseCircle {
                    flank: base.flank().flank,
                    radius: least,
                    base_radius: base.base_radius(),
                })
            })
        };
        Ok([cone(self.drawing.root_form_diameter())?, cone(self.drawing.tip_diameter)?])
    }

    /// What the job wants of the flank beside the involute. Of a double-helical gear modifications are those of a half over its own
    /// teeth, seen as in the half towards +z.
    fn offset(
        &self,
        base: &Helicoid,
        side: Flank,
        extent: &Extent,
    ) -> Result<Option<Arc<dyn NormalOffset>>, RunFailure> {
        let range = self.drawing.evaluation_range();
        let ends = match (extent.kink, extent.mirror()) {
            (None, _) => [range.z_start, range.z_end],
            (Some(_), None) => extent.face,
            (Some(_), Some(plane)) => [2.0 * plane - extent.face[1], 2.0 * plane - extent.face[0]],
        };
        let wanted = modification(self.loaded, self.drawing, (base, side), ends, true)?;
        Ok(wanted.map(|of| Arc::new(ModifiedFlank::new(of)) as Arc<dyn NormalOffset>))
    }

    /// What these modifications make of a flank, without what its paths are planned with beside them.
    pub fn wanted(
        &self,
        base: &Helicoid,
        specs: &[ModificationSpec],
    ) -> Result<Option<Arc<dyn NormalOffset>>, RunFailure> {
        if specs.is_empty() {
            return Ok(None);
        }
        let range = self.drawing.evaluation_range();
        let field = field(self.drawing, base, [range.z_start, range.z_end], self.keys.0)?;
        let of = Modification::of_entries(specs, base.flank().flank, &field, &job_files(self.loaded));
        let of = of.map_err(|(index, error)| {
            let key = format!("{}[{index}]", self.keys.1);
            RunFailure::bad_input(modification_finding(&error, &key))
        })?;
        Ok(Some(Arc::new(ModifiedFlank::new(of))))
    }
}

/// Lengths of roll of the active flank at root and tip, mm.
pub(super) fn rolls(drawing: &Drawing, base: &Helicoid, table: &str) -> Result<[f64; 2], RunFailure> {
    let roll = |diameter: f64| {
        let found = base.length_of_roll(0.5 * diameter);
        found.map_err(|error| RunFailure::bad_input(geometry_finding(&error, table)))
    };
    Ok([roll(drawing.root_form_diameter())?, roll(drawing.tip_diameter)?])
}

/// Where modifications of a flank are evaluated.
fn field(
    drawing: &Drawing,
    base: &Helicoid,
    ends: [f64; 2],
    table: &str,
) -> Result<EvaluationField, RunFailure> {
    let rolls = evaluated_rolls(drawing, base)?;
    EvaluationField::new(rolls, ends, base.base_radius(), base.base_helix_angle())
        .map_err(|error| RunFailure::bad_input(modification_finding(&error, table)))
}

/// What the job wants of a flank beside the involute, over its evaluated profile and these ends along the axis; with what its paths are
/// planned with beside that, or without.
fn modification(
    loaded: &LoadedMillingJob,
    drawing: &Drawing,
    (base, side): (&Helicoid, Flank),
    ends: [f64; 2],
    compensated: bool,
) -> Result<Option<Modification>, RunFailure> {
    let mut specs = loaded.job.target.modifications.clone().unwrap_or_default();
    if let Some(beside) = loaded.job.compensation.as_ref().filter(|_| compensated) {
        specs.extend(beside.modifications.iter().cloned());
    }
    if specs.is_empty() {
        return Ok(None);
    }
    let field = field(drawing, base, ends, "gear")?;
    specs_of_flank(loaded, &specs, side, &field).map(Some).map_err(RunFailure::bad_input)
}

/// Lengths of roll between which a profile is evaluated, mm.
fn evaluated_rolls(drawing: &Drawing, base: &Helicoid) -> Result<[f64; 2], RunFailure> {
    let range = drawing.evaluation_range();
    let roll = |diameter: f64| base.length_of_roll(0.5 * diameter).map_err(|error| on_gear(&error));
    let [start, end] = [roll(range.start_diameter)?, roll(range.end_diameter)?];
    Ok([start.min(end), start.max(end)])
}

/// What is wanted of a flank of a cylindrical gear, and where it is evaluated: lengths of roll and positions along the axis, mm.
#[derive(Clone, Debug)]
pub struct WantedFlank {
    /// Beside the involute.
    pub modification: Option<Modification>,
    /// The same with the compensation that paths are planned with.
    pub planned: Option<Modification>,
    /// Evaluated lengths of roll.
    pub rolls: [f64; 2],
    /// Evaluated positions.
    pub ends: [f64; 2],
    /// Lengths of roll of the whole flank that is milled.
    pub active: [f64; 2],
}

/// The wanted flanks of a cylindrical gear without halves.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn wanted_flanks(
    loaded: &LoadedMillingJob,
    given: &MillingGear,
) -> Result<Sides<WantedFlank>, RunFailure> {
    let drawing = &given.drawing;
    let gear = gear_of_job(drawing).map_err(RunFailure::bad_input)?;
    let range = drawing.evaluation_range();
    let ends = [range.z_start, range.z_end];
    let of = |side: Flank| {
        let base = Helicoid::new(&gear, side);
        let roll = |diameter: f64| base.length_of_roll(0.5 * diameter).map_err(|error| on_gear(&error));
        let [form, tip] = [roll(drawing.root_form_diameter())?, roll(drawing.tip_diameter)?];
        Ok(WantedFlank {
            modification: modification(loaded, drawing, (&base, side), ends, false)?,
            planned: modification(loaded, drawing, (&base, side), ends, true)?,
            rolls: evaluated_rolls(drawing, &base)?,
            ends,
            active: [form.min(tip), form.max(tip)],
        })
    };
    Ok(Sides { left: of(Flank::Left)?, right: of(Flank::Right)? })
}
