//! The mate of a job's gear as what rolls against it, flank by flank.

use super::bevel_offset::{MATE, Wanted, heights};
use super::bevel_pair::BevelPair;
use super::body::with_offset;
use super::conical::flank_surface;
use super::cylindrical::{Teeth, rolls};
use crate::job::{BevelFlank, LoadedMillingJob, Mate, MillingGear};
use contact::{Arrangement, ConjugateFlanks, ContactError, RolledGear, RolledPair};
use foundation::geometry::{
    BevelGear, EaseOff, EaseOffAmounts, Flank, Gear, Helicoid, NormalOffset, Sides, Surface,
};
use foundation::numerics::equidistant;
use job::{Diagnostic, Problem, shown_number};
use run::{RunFailure, gear_of_job, geometry_finding};
use std::sync::Arc;

/// The mate of the gear that is milled. Lengths in mm.
#[derive(Clone, Debug)]
pub struct MatePair {
    /// What it is.
    pub kind: MateKind,
    /// Its number of teeth.
    pub teeth: u32,
    /// How it stands to the gear.
    pub arrangement: Arrangement,
    /// Its flanks.
    pub sides: Sides<PairSide>,
    /// Radius at which its turns are stated as ways, mm: of its pitch cone in the middle of the face, or of its working pitch circle.
    pub radius: f64,
    /// Thickness of the marking compound, um.
    pub marking_um: f64,
    /// Roll positions for each mesh period.
    pub roll_positions: usize,
}

/// What a mate is.
#[derive(Clone, Debug)]
pub enum MateKind {
    /// A bevel gear: both gears, the one that is milled first.
    Conical(Box<[BevelGear; 2]>),
    /// A cylindrical gear.
    Cylindrical {
        /// Centre distance, mm.
        centre_distance: f64,
        /// Circumferential backlash at the working pitch circle of the mate, mm.
        backlash: f64,
    },
}

/// One flank of the gear and that of the mate which it touches.
#[derive(Clone, Debug)]
pub struct PairSide {
    /// Both nominal flanks.
    pub conjugate: ConjugateFlanks,
    /// What both have beside them.
    pub offsets: [Arc<dyn NormalOffset>; 2],
    /// The flank that is wanted of the gear, and that of the mate.
    pub gears: [RolledGear; 2],
    /// Both nominal flanks as bodies.
    pub nominal: RolledPair,
}

/// An offset, or one of nothing over the heights and lengths of its flank.
fn or_none(
    offset: Option<Arc<dyn NormalOffset>>,
    [heights, lengths]: [[f64; 2]; 2],
) -> Result<Arc<dyn NormalOffset>, RunFailure> {
    if let Some(offset) = offset {
        return Ok(offset);
    }
    let offset = EaseOff::new(EaseOffAmounts::default(), heights, lengths)
        .map_err(|error| RunFailure::bad_input(geometry_finding(&error, "mate")))?;
    Ok(Arc::new(offset))
}

fn on_mate(error: &ContactError) -> RunFailure {
    RunFailure::bad_input(Diagnostic::of(error).field("mate"))
}

impl MatePair {
    /// Of a bevel gear.
    ///
    /// # Errors
    /// [`RunFailure`] for a mate that is no gear.
    pub(super) fn conical(
        loaded: &LoadedMillingJob,
        BevelPair { gears, flank: form }: &BevelPair,
    ) -> Result<Option<Self>, RunFailure> {
        let Some(mate) = &loaded.job.mate else { return Ok(None) };
        let wanted = [
            Wanted::of_job(&loaded.job),
            Wanted {
                ease_off: mate.ease_off,
                modifications: mate.modifications.as_deref().unwrap_or_default(),
                beside: &[],
                keys: MATE,
            },
        ];
        let data = gears.each_ref().map(|gear| *gear.data());
        let arrangement = Arrangement::Crossing { shaft_angle: data[0].pitch_angle + data[1].pitch_angle };
        let side = |flank: Flank| {
            let conjugate = match form {
                BevelFlank::SphericalInvolute => ConjugateFlanks::involute(gears.clone(), flank),
                BevelFlank::Octoid => {
                    ConjugateFlanks::octoid(gears.clone(), flank).map_err(|error| on_mate(&error))?
                }
            };
            let offset = |k: usize| wanted[k].offset(loaded, &gears[k], *form, flank);
            let offsets = [offset(0)?, offset(1)?];
            let surface = |k: usize, offset| flank_surface(&gears[k], *form, flank, offset);
            let rolled = |k: usize, offset| -> Result<RolledGear, RunFailure> {
                let heights = heights(&gears[k], *form, flank)
                    .map_err(|error| RunFailure::bad_input(geometry_finding(&error, wanted[k].keys.gear)))?;
                let surface = surface(k, offset);
                Ok(RolledGear { surface, heights, lengths: gears[k].face(), teeth: data[k].teeth })
            };
            let nominal = [rolled(0, None)?, rolled(1, None)?];
            let spans = nominal.each_ref().map(|gear| [gear.heights, gear.lengths]);
            let gears = [rolled(0, offsets[0].clone())?, rolled(1, offsets[1].clone())?];
            let nominal = RolledPair::new(nominal, arrangement, flank).map_err(|error| on_mate(&error))?;
            let [own, other] = offsets;
            let offsets = [or_none(own, spans[0])?, or_none(other, spans[1])?];
            Ok::<_, RunFailure>(PairSide { conjugate, offsets, gears, nominal })
        };
        Ok(Some(Self {
            kind: MateKind::Conical(Box::new(gears.clone())),
            teeth: data[1].teeth,
            arrangement,
            sides: Sides::try_from_fn(side)?,
            radius: gears[1].mean_distance() * data[1].pitch_angle.sin(),
            marking_um: mate.marking_um,
            roll_positions: mate.roll_positions,
        }))
    }

    /// Of a cylindrical gear; `None` without a mate.
    ///
    /// # Errors
    /// [`RunFailure`] for a mate that is no gear or does not mesh with this one.
    pub(super) fn cylindrical(
        loaded: &LoadedMillingJob,
        own: &MillingGear,
    ) -> Result<Option<Self>, RunFailure> {
        let Some(mate) = &loaded.job.mate else { return Ok(None) };
        // A checked job has both.
        let (Some(drawing), Some(centre_distance)) = (&mate.gear, mate.centre_distance) else {
            return Ok(None);
        };
        let made = |drawing, table: &str| {
            gear_of_job(drawing).map_err(|finding| {
                let field = finding.field.as_deref().map_or(table.into(), |field| match table {
                    "mate" => format!("mate.{field}"),
                    _ => field.to_owned(),
                });
                RunFailure::bad_input(finding.field(field))
            })
        };
        let gears = [made(&own.drawing, "gear")?, made(drawing, "mate")?];
        let arrangement = if gears.iter().any(|gear| gear.external_sign() < 0.0) {
            Arrangement::Inside { centre_distance, first_is_ring: own.drawing.teeth < 0 }
        } else {
            Arrangement::Outside { centre_distance }
        };
        let lists = [loaded.job.target.modifications.as_deref(), mate.modifications.as_deref()];
        let drawings = [&own.drawing, drawing];
        let side = |flank: Flank| {
            // The left flank of a gear inside of a ring meets a right one.
            let other = if matches!(arrangement, Arrangement::Inside { .. }) { flank.other() } else { flank };
            let bases = [Helicoid::new(&gears[0], flank), Helicoid::new(&gears[1], other)];
            let keys = [("gear", "target.modifications"), ("mate.gear", "mate.modifications")];
            let teeth = |k: usize| Teeth { loaded, drawing: drawings[k], gear: gears[k], keys: keys[k] };
            let heights =
                [rolls(drawings[0], &bases[0], "gear")?, rolls(drawings[1], &bases[1], "mate.gear")?];
            let faces = drawings.map(|drawing| [-0.5 * drawing.face_width, 0.5 * drawing.face_width]);
            let conjugate = ConjugateFlanks::cylindrical(bases.each_ref(), arrangement, heights, faces)
                .map_err(|error| {
                    RunFailure::bad_input(Diagnostic::of(&error).field("mate.centre_distance"))
                })?;
            let offset = |k: usize| teeth(k).wanted(&bases[k], lists[k].unwrap_or_default());
            let offsets = [offset(0)?, offset(1)?];
            let rolled = |k: usize, offset: Option<Arc<dyn NormalOffset>>| {
                let surface: Arc<dyn Surface> = with_offset(bases[k], offset);
                RolledGear {
                    surface,
                    heights: heights[k],
                    lengths: faces[k],
                    teeth: drawings[k].teeth.unsigned_abs(),
                }
            };
            let nominal = RolledPair::new([rolled(0, None), rolled(1, None)], arrangement, flank)
                .map_err(|error| on_mate(&error))?;
            let place = touching(&conjugate, faces[0])
                .ok_or_else(|| on_mate(&ContactError::FlanksDoNotMesh { flank }))?;
            let nominal = nominal
                .without_play(place, conjugate.roll(place))
                .ok_or_else(|| on_mate(&ContactError::FlanksDoNotMesh { flank }))?;
            let gears = [0, 1].map(|k| rolled(k, offsets[k].clone()));
            let [own, other] = offsets;
            let offsets = [or_none(own, [heights[0], faces[0]])?, or_none(other, [heights[1], faces[1]])?];
            Ok::<_, RunFailure>(PairSide { conjugate, offsets, gears, nominal })
        };
        let sides = Sides::try_from_fn(side)?;
        let radius = working_radius(&gears, centre_distance);
        let pitch = std::f64::consts::TAU / f64::from(drawing.teeth.unsigned_abs());
        let play: f64 = sides.iter().map(|(_, side)| side.nominal.play()).sum();
        let backlash = radius * (play - pitch * (play / pitch).round());
        if backlash < 0.0 {
            return Err(jammed(mate, backlash));
        }
        Ok(Some(Self {
            kind: MateKind::Cylindrical { centre_distance, backlash },
            teeth: drawing.teeth.unsigned_abs(),
            arrangement,
            sides,
            radius,
            marking_um: mate.marking_um,
            roll_positions: mate.roll_positions,
        }))
    }
}

/// A place of the first flank that touches one of the second, the middle of all of them.
fn touching(conjugate: &ConjugateFlanks, face: [f64; 2]) -> Option<[f64; 2]> {
    /// Heights looked at.
    const HEIGHTS: usize = 201;
    let middle = 0.5 * (face[0] + face[1]);
    let places = equidistant(conjugate.heights()[0], HEIGHTS).into_iter().map(|height| [height, middle]);
    let found: Vec<[f64; 2]> = places.filter(|place| conjugate.touches(*place)).collect();
    found.get(found.len() / 2).copied()
}

/// Radius of the mate's working pitch circle, mm.
fn working_radius([own, mate]: &[Gear; 2], centre_distance: f64) -> f64 {
    let teeth = [own, mate].map(Gear::tooth_count).map(f64::abs);
    let of_distance = if own.external_sign() * mate.external_sign() > 0.0 {
        teeth[0] + teeth[1]
    } else {
        (teeth[1] - teeth[0]).abs()
    };
    centre_distance * teeth[1] / of_distance
}

fn jammed(mate: &Mate, backlash: f64) -> RunFailure {
    let distance = mate.centre_distance.unwrap_or_default();
    RunFailure::bad_input(
        Diagnostic::new(
            Problem::InvalidGeometry,
            format!("the teeth of both gears jam: their backlash is {:.1} um", 1e3 * backlash),
        )
        .field("mate.centre_distance")
        .value(shown_number(distance))
        .allowed("a distance at which the flanks have backlash")
        .way_out("compare the distance and the thickness of both gears' teeth with the drawings"),
    )
}
