//! The pairs of `docs/mathematics/skiving.md#how-it-is-verified`: an internal ring with a spur tool, a gear with a stepped helical tool, a
//! crowned one with a cone as rake face, chamfers and a tilted beam.

use foundation::geometry::{
    ConeRake, EdgeRounding, Flank, Gear, GearData, NormalOffset, OffsetBounds, PlaneRake, RakeFace, Sides,
    SkivingTool,
};
use foundation::numerics::Jet2;
use nalgebra::Vector3;
use skiving::measuring::{Beam, FlankTracks, PoseKind, measuring_poses};
use skiving::{MeasuringTrack, PairData, SkivedFlank, SkivingPair, VirtualEdge, default_track_places};
use std::sync::Arc;

/// A pair by its drawing data, mm and deg.
#[derive(Clone, Copy)]
pub struct Sample {
    pub teeth: [i32; 2],
    pub module: f64,
    pub pressure_angle: f64,
    pub helix: [f64; 2],
    pub profile_shift: f64,
    pub tool_shift: f64,
    pub cone: bool,
    pub rake: f64,
    pub step: f64,
    pub rounding: [f64; 5],
    pub crowning: f64,
    pub radii: [f64; 2],
    pub tilt: [f64; 2],
}

pub const RING: Sample = Sample {
    teeth: [41, -85],
    module: 2.0,
    pressure_angle: 20.0,
    helix: [0.0, 20.0],
    profile_shift: 0.0,
    tool_shift: 0.0,
    cone: false,
    rake: 5.0,
    step: 0.0,
    rounding: [0.03, 8.0, 0.0, 0.0, 0.0],
    crowning: 0.0,
    radii: [88.7, 92.4],
    tilt: [0.0, 0.0],
};

pub const STEPPED: Sample = Sample {
    teeth: [75, 47],
    module: 1.5,
    helix: [10.0, 15.0],
    tool_shift: 2.0,
    rake: 8.0,
    step: 10.0,
    radii: [35.4, 37.9],
    ..RING
};

pub const CROWNED: Sample = Sample {
    teeth: [75, 50],
    module: 1.5,
    helix: [20.0, 0.0],
    profile_shift: 0.1,
    cone: true,
    rake: 6.0,
    rounding: [0.05, 9.0, 0.05, 10.0, 3.0],
    crowning: 0.008,
    radii: [36.4, 38.9],
    tilt: [12.0, 0.3],
    ..RING
};

/// f_n = -C x^2 over the edge.
#[derive(Debug)]
struct Crown {
    amount: f64,
    range: [f64; 2],
}

impl NormalOffset for Crown {
    fn jet(&self, w: f64, _: f64) -> Jet2 {
        let [from, to] = self.range;
        let (slope, x) = (2.0 / (to - from), (2.0 * w - from - to) / (to - from));
        let bend = -2.0 * self.amount * slope * slope;
        Jet2 { fu: -2.0 * self.amount * x * slope, fuu: bend, ..Jet2::constant(-self.amount * x * x) }
    }

    fn bounds(&self, _: [f64; 2], _: [f64; 2]) -> OffsetBounds {
        OffsetBounds { value: 1.0, by_height: 1.0, by_length: 0.0, second: [1.0, 0.0, 0.0] }
    }
}

impl Sample {
    pub fn rounding(&self) -> EdgeRounding {
        let [radius, clearance, width, rake_chamfer, clearance_chamfer] = self.rounding;
        EdgeRounding {
            radius,
            clearance_angle: clearance.to_radians(),
            rake_chamfer_width: width,
            rake_chamfer_angle: rake_chamfer.to_radians(),
            clearance_chamfer_angle: clearance_chamfer.to_radians(),
        }
    }

    pub fn tool(&self) -> SkivingTool {
        let (rake, step, cone) = (self.rake.to_radians(), self.step.to_radians(), self.cone);
        let face = move |radius: f64| -> Arc<dyn RakeFace> {
            if cone {
                Arc::new(ConeRake::new(rake, radius))
            } else {
                Arc::new(PlaneRake::new(rake, step, radius))
            }
        };
        let teeth = self.teeth[0].unsigned_abs();
        SkivingTool::new(teeth, self.helix[0].to_radians(), self.module, face, self.rounding()).unwrap()
    }

    pub fn gear(&self) -> Gear {
        Gear::new(GearData {
            teeth: self.teeth[1],
            normal_module: self.module,
            pressure_angle: Sides::both(self.pressure_angle.to_radians()),
            helix_angle: self.helix[1].to_radians(),
            profile_shift: self.profile_shift,
            cone_angle: 0.0,
        })
        .unwrap()
    }

    pub fn setting(&self) -> PairData {
        PairData { tool_shift: self.tool_shift, ..PairData::default() }
    }

    pub fn pair(&self) -> SkivingPair {
        SkivingPair::new(self.tool(), self.gear(), self.setting()).unwrap()
    }

    pub fn flank(&self, pair: &SkivingPair, flank: Flank) -> SkivedFlank {
        let plain = pair.flank_between(flank, self.radii).unwrap();
        if self.crowning == 0.0 {
            return plain;
        }
        let range = plain.range();
        plain.modified(Arc::new(Crown { amount: self.crowning, range }), [-5.0, 5.0]).unwrap()
    }

    pub fn edges(&self) -> Sides<VirtualEdge> {
        let pair = self.pair();
        Sides::from_fn(|flank| VirtualEdge::new(&pair, self.flank(&pair, flank)).unwrap())
    }

    pub fn beam(&self) -> Beam {
        Beam::new(Vector3::new(300.0, 20.0, 150.0), self.tilt.map(f64::to_radians), 0.05).unwrap()
    }

    pub fn flanks(&self) -> Sides<FlankTracks> {
        self.flanks_at(&default_track_places())
    }

    /// With tracks at places of one's own.
    pub fn flanks_at(&self, places: &[f64]) -> Sides<FlankTracks> {
        let beam = self.beam();
        self.edges().map(|flank, edge| {
            let track = |(number, place): (usize, &f64)| {
                let track = MeasuringTrack::new(edge, *place).unwrap();
                let poses = measuring_poses(&track, &beam, PoseKind::Tangent, (flank, number)).unwrap();
                (track, poses[0])
            };
            let tracks = places.iter().enumerate().map(track).collect();
            FlankTracks { edge: edge.clone(), tracks }
        })
    }
}
