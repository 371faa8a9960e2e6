//! How fast a machine works and how the bodies are clamped in it, as a job says.

use super::cylinders::Cylinders;
use foundation::kinematics::MotionLaw;
use generating::GrindingSetup;
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
    /// Speed of the worm while it grinds, rad/s.
    pub worm_speed: f64,
    /// Speed of the worm while it is dressed, rad/s.
    pub dressing_speed: f64,
    /// Speed of the dresser, rad/s.
    pub dresser_speed: f64,
    /// Feed z_V2 per revolution of the workpiece, mm.
    pub feed_per_revolution: f64,
    /// How far the worm stands off, mm.
    pub clearance: f64,
    /// Stock of the roughing strokes, mm, falling.
    pub roughing: Vec<f64>,
    /// Strokes without infeed.
    pub spark_out: usize,
    /// Stock of the dressing strokes before the last, mm, falling.
    pub dressing_stock: Vec<f64>,
    /// Way before and behind a dressing stroke to leave the worm, mm, for ends of the working part at a distance from the worm's
    /// middle; `None` for a worm without a stated width.
    pub worm_end: Option<f64>,
    /// z_V1 over z_V2 of the roughing strokes, one for each area of the worm kept for them; empty: they use the finishing area.
    pub roughing_shift: Vec<MotionLaw>,
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
        Self { cylinders: Some(cylinders), ..Self::new(job, sizes, feed_per_revolution) }
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
        let um = |list: &[f64]| list.iter().map(|x| x * 1e-3).collect();
        Self {
            // |A1| < 90 deg is possible only if r_1 r_2 = -h, and r_A = r_1 (`docs/mathematics/generating-contact.md#machine-chains`).
            grinding: Mounts { tool: worm, counterpart: mount(job.work, hand > 0.0) },
            dressing: Mounts { tool: worm, counterpart: mount(job.dresser, false) },
            swivel: job.swivel_deg.unwrap_or(0.0).to_radians(),
            worm_speed: job.cutting_speed_m_per_s.unwrap_or(CUTTING_SPEED) * 1e3 / tip_radius,
            dressing_speed: job.dressing_worm_speed_rpm.unwrap_or(DRESSING_WORM_SPEED) * rpm,
            dresser_speed: job.dresser_speed_rpm.unwrap_or(DRESSER_SPEED) * rpm,
            feed_per_revolution: feed_per_revolution.unwrap_or(FEED_PER_REVOLUTION),
            clearance: job.clearance.unwrap_or(CLEARANCE),
            roughing: um(&job.roughing_stock_um),
            spark_out: job.spark_out as usize,
            dressing_stock: um(&job.dressing_stock_um),
            worm_end: width.map(|width| 0.5 * width + DRESSER_REACH * module),
            roughing_shift: Vec::new(),
            cylinders: None,
            dresser: None,
            clamping: job.clamping.clone(),
            body_clearance: job.body_clearance.unwrap_or(BODY_CLEARANCE),
        }
    }
}
