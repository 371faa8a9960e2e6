//! The bodies that a dressing study compares: the job with one quantity changed, worm and dresser in place.

use crate::job::{Compare, Job, LoadedJob};
use crate::workflow::explore::Refused;
use crate::workflow::prepare::setup_of_job;
use foundation::geometry::Sides;
use generating::GrindingSetup;
use job::tables::OneOrSides;

/// One set of bodies of a study.
pub struct Bodies {
    /// What tells it from the others, for example `d_S = 100 mm`; empty where nothing is compared.
    pub name: String,
    /// The bodies, or why there are none.
    pub setup: Result<GrindingSetup, Refused>,
}

/// Width of a conical worm without a stated one, mm.
const NARROW: f64 = 1.0;

/// A quantity that is changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    Threads(u32),
    WormPitchDiameter(f64),
    DresserTipDiameter(f64),
    /// Of the left flank, degrees; the right one has the angle that meshes beside it.
    PressureAngle(f64),
    /// Degrees.
    ConeAngle(f64),
}

impl Change {
    /// The values that `compare` lists, in its order.
    pub fn all(compare: &Compare) -> Vec<Self> {
        let lengths = |list: &Option<Vec<f64>>, make: fn(f64) -> Self| -> Vec<Self> {
            list.iter().flatten().copied().map(make).collect()
        };
        let mut changes: Vec<Self> = compare.threads.iter().flatten().copied().map(Self::Threads).collect();
        changes.extend(lengths(&compare.worm_pitch_diameter, Self::WormPitchDiameter));
        changes.extend(lengths(&compare.dresser_tip_diameter, Self::DresserTipDiameter));
        changes.extend(lengths(&compare.normal_pressure_angle_deg, Self::PressureAngle));
        changes
    }

    /// Name and value as curves are labelled.
    pub fn name(self) -> String {
        match self {
            Self::Threads(n) => format!("z_S = {n}"),
            Self::WormPitchDiameter(d) => format!("d_S = {d} mm"),
            Self::DresserTipDiameter(d) => format!("d_aA = {d} mm"),
            Self::PressureAngle(a) => format!("α_nS = {a}°"),
            Self::ConeAngle(a) => format!("θ_S = {a}°"),
        }
    }

    /// The job with this change. A worm of another pitch diameter has the tip that belongs to it.
    pub fn of(self, job: &Job) -> Job {
        let mut changed = job.clone();
        match self {
            Self::Threads(n) => changed.worm.threads = n,
            Self::WormPitchDiameter(d) => {
                (changed.worm.pitch_diameter, changed.worm.tip_diameter) = (Some(d), None);
            }
            Self::DresserTipDiameter(d) => {
                if let Some(dresser) = &mut changed.dresser {
                    dresser.tip_diameter = d;
                }
            }
            Self::PressureAngle(a) => {
                let gear = job.gear.normal_pressure_angle_deg.sides();
                changed.worm.normal_pressure_angle_deg = Some(meshing_angles(a, &gear));
            }
            Self::ConeAngle(a) => {
                changed.worm.cone_angle_deg = a;
                // Only the tip at the ends of a conical worm depends on its width.
                changed.worm.width = changed.worm.width.or(Some(NARROW));
            }
        }
        changed
    }
}

impl Bodies {
    /// The bodies of a job with changes.
    pub fn of(loaded: &LoadedJob, changes: &[Change]) -> Result<GrindingSetup, Refused> {
        let mut job = loaded.job.clone();
        for change in changes {
            job = change.of(&job);
        }
        setup_of_job(&job).map_err(Refused::from)
    }

    /// All bodies that a study compares, or the job's own.
    pub fn compared(loaded: &LoadedJob, compare: Option<&Compare>) -> Vec<Self> {
        match compare {
            None => vec![Self { name: String::new(), setup: Self::of(loaded, &[]) }],
            Some(compare) => Change::all(compare)
                .into_iter()
                .map(|change| Self { name: change.name(), setup: Self::of(loaded, &[change]) })
                .collect(),
        }
    }
}

/// The angles of a worm whose left flank has `left`, for a gear of the angles `gear`, degrees: the flanks share one module, and
/// both normal base pitches are those of the gear.
fn meshing_angles(left: f64, gear: &Sides<f64>) -> OneOrSides<f64> {
    if gear.left == gear.right {
        return OneOrSides::Both(left);
    }
    let cosine = |degrees: f64| degrees.to_radians().cos();
    let right = (cosine(left) * cosine(gear.right) / cosine(gear.left)).min(1.0).acos().to_degrees();
    OneOrSides::Each { left, right }
}
