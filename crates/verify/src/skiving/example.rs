//! A tool, its workpiece and a beam by name.

use super::super::given::Checked;
use super::super::reference::Reference;
use foundation::geometry::{
    ConeRake, EdgeRounding, Flank, Gear, GearData, NormalOffset, OffsetBounds, PlaneRake, RakeFace, Sides,
    SkivingTool,
};
use foundation::numerics::Jet2;
use nalgebra::Vector3;
use serde::Deserialize;
use serde_json::Value;
use skiving::measuring::{Beam, FlankTracks, PoseKind, measuring_poses};
use skiving::{MeasuringTrack, PairData, SkivingPair, VirtualEdge, default_track_places};
use std::sync::Arc;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ExampleInput {
    z2: i32,
    m_n: f64,
    alpha_n_deg: f64,
    beta2_deg: f64,
    x2: f64,
    z1: u32,
    beta1_deg: f64,
    #[serde(rename = "z_V1")]
    tool_shift: f64,
    rake_kind: String,
    rake_deg: f64,
    step_deg: f64,
    rho_e: f64,
    clearance_deg: f64,
    rake_chamfer_b: f64,
    rake_chamfer_deg: f64,
    clear_chamfer_deg: f64,
    crown_um: f64,
    r_from: f64,
    r_to: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct BeamInput {
    #[serde(rename = "M")]
    point: [f64; 3],
    delta_deg: f64,
    eps_deg: f64,
    #[serde(rename = "r_L")]
    radius: f64,
}

/// f_n = -C x^2 over the range of the edge, mm.
#[derive(Debug)]
struct Crown {
    amount: f64,
    range: [f64; 2],
}

impl NormalOffset for Crown {
    fn jet(&self, w: f64, _: f64) -> Jet2 {
        let [from, to] = self.range;
        let slope = 2.0 / (to - from);
        let x = (2.0 * w - from - to) / (to - from);
        Jet2 {
            fu: -2.0 * self.amount * x * slope,
            fuu: -2.0 * self.amount * slope * slope,
            ..Jet2::constant(-self.amount * x * x)
        }
    }

    fn bounds(&self, _: [f64; 2], _: [f64; 2]) -> OffsetBounds {
        let slope = 2.0 / (self.range[1] - self.range[0]);
        let amount = self.amount.abs();
        OffsetBounds {
            value: amount,
            by_height: 2.0 * amount * slope,
            by_length: 0.0,
            second: [2.0 * amount * slope * slope, 0.0, 0.0],
        }
    }
}

/// A named example: both edges and its beam.
pub(super) struct SkivingExample {
    pub edges: Sides<VirtualEdge>,
    pub beam: Beam,
}

/// Reads a beam.
pub(super) fn beam(value: &Value) -> Checked<Beam> {
    let input = BeamInput::deserialize(value)?;
    let tilts = [input.delta_deg.to_radians(), input.eps_deg.to_radians()];
    Ok(Beam::new(Vector3::from(input.point), tilts, input.radius)?)
}

impl ExampleInput {
    pub(super) fn rounding(&self) -> EdgeRounding {
        EdgeRounding {
            radius: self.rho_e,
            clearance_angle: self.clearance_deg.to_radians(),
            rake_chamfer_width: self.rake_chamfer_b,
            rake_chamfer_angle: self.rake_chamfer_deg.to_radians(),
            clearance_chamfer_angle: self.clear_chamfer_deg.to_radians(),
        }
    }

    fn pair(&self) -> Checked<SkivingPair> {
        let (rake, step) = (self.rake_deg.to_radians(), self.step_deg.to_radians());
        let face = match self.rake_kind.as_str() {
            "plane" => |rake, step, radius| Arc::new(PlaneRake::new(rake, step, radius)) as Arc<dyn RakeFace>,
            "cone" => |rake, _, radius| Arc::new(ConeRake::new(rake, radius)) as Arc<dyn RakeFace>,
            other => return Err(format!("rake_kind: {other:?} is unknown; known: plane | cone").into()),
        };
        let helix = self.beta1_deg.to_radians();
        let tool = SkivingTool::new(self.z1, helix, self.m_n, |r| face(rake, step, r), self.rounding())?;
        let gear = Gear::new(GearData {
            teeth: self.z2,
            normal_module: self.m_n,
            pressure_angle: Sides::both(self.alpha_n_deg.to_radians()),
            helix_angle: self.beta2_deg.to_radians(),
            profile_shift: self.x2,
            cone_angle: 0.0,
        })?;
        Ok(SkivingPair::new(tool, gear, PairData { tool_shift: self.tool_shift, ..PairData::default() })?)
    }

    pub(super) fn edge(&self, pair: &SkivingPair, flank: Flank) -> Checked<VirtualEdge> {
        let plain = pair.flank_between(flank, [self.r_from, self.r_to])?;
        let amount = 1e-3 * self.crown_um;
        let range = plain.range();
        let wanted = match amount {
            0.0 => plain,
            _ => plain.modified(Arc::new(Crown { amount, range }), [-1.0, 1.0])?,
        };
        Ok(VirtualEdge::new(pair, wanted)?)
    }
}

impl SkivingExample {
    /// The example of that name.
    pub fn named(reference: &Reference<'_>, name: &str) -> Checked<Self> {
        let value = reference.root.get("examples").and_then(|examples| examples.get(name));
        Self::of(value.ok_or_else(|| format!("the file has no example {name:?}"))?)
    }

    pub(super) fn of(value: &Value) -> Checked<Self> {
        let input = ExampleInput::deserialize(&value["input"])?;
        let pair = input.pair()?;
        let edges = Sides::try_from_fn(|flank| input.edge(&pair, flank))?;
        Ok(Self { edges, beam: beam(&value["beam"])? })
    }

    /// The tracks of both flanks with tangent poses.
    pub fn flanks(&self, beam: &Beam) -> Checked<Sides<FlankTracks>> {
        Sides::try_from_fn(|flank| {
            let edge = &self.edges[flank];
            let tracks = default_track_places().into_iter().enumerate().map(|(number, place)| {
                let track = MeasuringTrack::new(edge, place)?;
                let poses = measuring_poses(&track, beam, PoseKind::Tangent, (flank, number))?;
                Ok((track, poses[0]))
            });
            Ok(FlankTracks { edge: edge.clone(), tracks: tracks.collect::<Checked<_>>()? })
        })
    }

    /// Number of teeth of the tool.
    pub fn teeth(&self) -> usize {
        self.edges.left.pair().tool().teeth() as usize
    }
}
