//! The strokes of a run as work for a machine.

use contact::Lever;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{DressingMotion, GeneratingMotion, MotionLaw};
use generating::GrindingSetup;
use nalgebra::Vector3;

/// One dressing stroke of a run.
#[derive(Clone, Debug)]
pub struct DressingWork {
    /// Its name: capital letters, digits, blanks.
    pub name: String,
    /// The motion that finishes the worm.
    pub motion: DressingMotion,
    /// Worm positions v_zS of the working part, mm.
    pub interval: [f64; 2],
    /// Places where the dresser touches at v_zS = 0: point and normal in worm coordinates.
    pub contacts: Vec<(Vector3<f64>, Vector3<f64>)>,
    /// Largest sin(alpha_n): stock per distance where both flanks are dressed at once.
    pub per_distance: f64,
}

/// A law with a share of what it changes over a range; in the middle of it it stays.
pub fn shared(law: &MotionLaw, range: [f64; 2], share: f64) -> MotionLaw {
    let middle = law.value(0.5 * (range[0] + range[1]));
    law.scaled(share).raised((1.0 - share) * middle)
}

/// Levers of the flanks that a stroke grinds.
pub fn levers_of(setup: &GrindingSetup, flanks: &[Flank]) -> Sides<Option<Lever>> {
    Sides::from_fn(|flank| {
        let line = &setup.lines[flank];
        let lever = Lever { sine: line.sin_an.abs(), arm: line.lever.abs() };
        flanks.contains(&flank).then_some(lever)
    })
}

/// One grinding stroke of a run.
#[derive(Clone, Debug)]
pub struct GrindingWork {
    /// Its name.
    pub name: String,
    /// The motion that finishes the flank.
    pub motion: GeneratingMotion,
    /// k_0F of its flanks.
    pub phase: f64,
    /// Feeds z_V2 of the working part, mm.
    pub feeds: [f64; 2],
    /// Of each flank that it grinds.
    pub levers: Sides<Option<Lever>>,
}

impl GrindingWork {
    /// The same stroke with a share of what its corrections change along the face; in the middle of it they are as they were.
    pub fn with_share(&self, share: f64) -> Self {
        let mut work = self.clone();
        for law in [&mut work.motion.delta_d, &mut work.motion.delta_phi_2] {
            *law = shared(law, self.feeds, share);
        }
        work
    }

    /// Largest r_b2 cos(beta_b2) of its flanks, mm/rad.
    pub fn per_turn(&self) -> f64 {
        self.largest(|lever| lever.arm)
    }

    /// Largest sin(alpha_n) of its flanks.
    pub fn per_distance(&self) -> f64 {
        self.largest(|lever| lever.sine)
    }

    fn largest(&self, of: fn(Lever) -> f64) -> f64 {
        self.levers.iter().filter_map(|(_, lever)| lever.map(of)).fold(0.0, f64::max)
    }
}
