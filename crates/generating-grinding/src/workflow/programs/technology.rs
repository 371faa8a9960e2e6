//! How fast a machine works and how the bodies are clamped in it, as a job says.

use super::cylinders::Cylinders;
use super::grinding_stroke::GrindingStroke;
use super::work::GrindingWork;
use crate::workflow::roughing_pass::RoughingPass;
use generating::GrindingSetup;
use grinding_technology::Ground;
use job::tables::{BODY_CLEARANCE, Clamping, ClampingBody, Machine as JobMachine};
use machine::{Mount, Mounts};
use std::f64::consts::TAU;

/// Speeds, clamping and passes. mm, rad, s.
#[derive(Clone, Debug, PartialEq)]
pub struct Technology {
    /// Worm and workpiece.
    pub grinding: Mounts,
    /// Worm and dresser.
    pub dressing: Mounts,
    /// Angle of the dresser's swivel, rad.
    pub swivel: f64,
    /// Speed of the worm while it is dressed, rad/s.
    pub dressing_speed: f64,
    /// Speed of the dresser, rad/s.
    pub dresser_speed: f64,
    /// How far the worm stands off, mm.
    pub clearance: f64,
    /// Strokes of a grinding pass in driving order, at least one; the last one finishes or sparks out.
    pub strokes: Vec<GrindingStroke>,
    /// Stock of the dressing strokes before the last, mm, falling.
    pub dressing_stock: Vec<f64>,
    /// Way before and behind a dressing stroke to leave the worm, mm, for ends of the working part at a distance from the worm's
    /// middle; `None` for a worm without a stated width.
    pub worm_end: Option<f64>,
    /// What the roughing strokes do in each area of the worm kept for them; empty: they use the finishing area.
    pub roughing: Vec<RoughingPass>,
    /// Worm and blank, which a grinding stroke begins and ends clear of each other; `None`: it runs in for its speed only.
    pub cylinders: Option<Cylinders>,
    /// Worm and dresser, which a dressing stroke begins and ends clear of each other; `None` for a worm without a stated width.
    pub dresser: Option<Cylinders>,
    /// What holds the gear.
    pub clamping: Vec<ClampingBody>,
    /// Distance that programs keep from it and from the machine's bodies, mm.
    pub body_clearance: f64,
}

/// Defaults: cutting speed in m/s, speeds in 1/min, clearances in mm, feed in mm per revolution.
const CUTTING_SPEED: f64 = 50.0;
const DRESSING_WORM_SPEED: f64 = 60.0;
const DRESSER_SPEED: f64 = 4000.0;
const CLEARANCE: f64 = 15.0;
const FEED_PER_REVOLUTION: f64 = 0.3;
/// How much further the worm stands off than it reaches into the blank, mm.
const BEYOND_DEPTH: f64 = 2.0;
/// The dresser reaches beyond its middle by this many modules of the worm.
const DRESSER_REACH: f64 = 1.5;

impl Technology {
    /// As the job says, for the worm of a grinding run.
    pub fn of_grinding(job: &JobMachine, setup: &GrindingSetup, feed_per_revolution: Option<f64>) -> Self {
        let hand = if setup.pair.worm.data().helix_angle < 0.0 { -1.0 } else { 1.0 };
        let sizes = (hand, setup.largest_tip_radius, setup.worm_module(), setup.input.worm_width);
        let blank = &setup.input.blank;
        let cylinders = Cylinders {
            worm_radius: setup.largest_tip_radius,
            worm_half_width: setup.input.worm_width.map(|width| 0.5 * width),
            radius: 0.5 * blank.tip_diameter,
            half_width: 0.5 * blank.face_width,
        };
        let own = Self::new(job, sizes, feed_per_revolution);
        // The worm that comes in with its threads in the tooth spaces stands off clear of the blank.
        let depth = cylinders.worm_radius + cylinders.radius - setup.pair.chain.centre_distance;
        let clearance = match job.clearance {
            Some(given) => given,
            None => own.clearance.max(depth + BEYOND_DEPTH),
        };
        Self { cylinders: Some(cylinders), clearance, ..own }
    }

    /// With the dresser of this tip radius as a disc of its reach, for a worm with a stated width.
    pub fn with_dresser(mut self, radius: f64, module: f64) -> Self {
        self.dresser = self.cylinders.filter(|worm| worm.worm_half_width.is_some()).map(|worm| Cylinders {
            radius,
            half_width: DRESSER_REACH * module,
            ..worm
        });
        self
    }

    /// As the job says; `worm` gives hand (+1 right), tip radius, module and width of the worm.
    pub fn new(
        job: &JobMachine,
        (hand, tip_radius, module, width): (f64, f64, f64, Option<f64>),
        feed_per_revolution: Option<f64>,
    ) -> Self {
        let rpm = TAU / 60.0;
        let mount = |clamping: Option<Clamping>, reversed: bool| {
            let clamping = clamping.unwrap_or_default();
            Mount { reversed, axial: clamping.axial, angle: clamping.angle_deg.to_radians() }
        };
        let worm = mount(job.worm, false);
        let um = |list: &[f64]| list.iter().map(|x| x * 1e-3).collect::<Vec<f64>>();
        let worm_speed = job.cutting_speed_m_per_s.unwrap_or(CUTTING_SPEED) * 1e3 / tip_radius;
        let feed = feed_per_revolution.unwrap_or(FEED_PER_REVOLUTION);
        let finishing = (0..=job.spark_out).map(|_| 0.0);
        let left = um(&job.roughing_stock_um).into_iter().chain(finishing);
        Self {
            // |A1| < 90 deg is possible only if r_1 r_2 = -h, and r_A = r_1 (`docs/mathematics/generating-contact.md#machine-chains`).
            grinding: Mounts { tool: worm, counterpart: mount(job.work, hand > 0.0) },
            dressing: Mounts { tool: worm, counterpart: mount(job.dresser, false) },
            swivel: job.swivel_deg.unwrap_or(0.0).to_radians(),
            dressing_speed: job.dressing_worm_speed_rpm.unwrap_or(DRESSING_WORM_SPEED) * rpm,
            dresser_speed: job.dresser_speed_rpm.unwrap_or(DRESSER_SPEED) * rpm,
            clearance: job.clearance.unwrap_or(CLEARANCE),
            strokes: left.map(|left| GrindingStroke::up(left, worm_speed, feed)).collect(),
            dressing_stock: um(&job.dressing_stock_um),
            worm_end: width.map(|width| 0.5 * width + DRESSER_REACH * module),
            roughing: Vec::new(),
            cylinders: None,
            dresser: None,
            clamping: job.clamping.clone(),
            body_clearance: job.body_clearance.unwrap_or(BODY_CLEARANCE),
        }
    }

    /// The stroke that makes the flank.
    pub fn finishing(&self) -> &GrindingStroke {
        let last = self.strokes.len().saturating_sub(1);
        &self.strokes[self.strokes.iter().position(GrindingStroke::finishes).unwrap_or(last)]
    }

    /// The strokes that a work drives for its flanks.
    pub fn strokes_of<'a>(&'a self, work: &'a GrindingWork) -> impl Iterator<Item = &'a GrindingStroke> {
        let grinds =
            |stroke: &&GrindingStroke| stroke.ground.flanks().any(|flank| work.levers[flank].is_some());
        self.strokes.iter().filter(grinds)
    }

    /// Strokes of the job: flanks that are ground one after the other have them each.
    pub fn strokes_of_a_pass(&self) -> usize {
        let mut passes: Vec<Ground> = self.strokes.iter().map(|stroke| stroke.ground).collect();
        passes.dedup();
        self.strokes.len() / passes.len().max(1)
    }

    /// Greatest speed of the worm in any stroke, rad/s.
    pub fn worm_speed(&self) -> f64 {
        self.strokes.iter().map(|stroke| stroke.worm_speed).fold(0.0, f64::max)
    }

    /// Greatest speed of the worm's tip in any stroke, m/s.
    pub fn cutting_speed(&self, tip_radius: f64) -> f64 {
        1e-3 * self.worm_speed() * tip_radius
    }

    /// The least stock that a roughing stroke leaves, mm; infinite without one.
    pub fn least_roughing(&self) -> f64 {
        let left =
            self.strokes.iter().flat_map(|stroke| stroke.ground.flanks().map(|flank| stroke.left[flank]));
        left.filter(|left| *left > 0.0).fold(f64::INFINITY, f64::min)
    }
}
