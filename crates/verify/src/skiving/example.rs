//! Block `examples`: a tool, its workpiece and a beam by name.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::edges::check_edges;
use super::poses::check_poses;
use foundation::geometry::{
    ConeRake, EdgeRounding, Flank, Gear, GearData, NormalOffset, OffsetBounds, PlaneRake, RakeFace, Sides,
    SkivingTool,
};
use foundation::numerics::Jet2;
use nalgebra::Vector3;
use serde::Deserialize;
use serde_json::Value;
use skiving::measuring::{Beam, FlankTracks, PoseKind, measuring_poses};
use skiving::{
    MeasuringTrack, PairData, SkivingPair, VirtualEdge, default_track_places, setting_sensitivity,
};
use std::sync::Arc;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ExampleInput {
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
    fn rounding(&self) -> EdgeRounding {
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

    fn edge(&self, pair: &SkivingPair, flank: Flank) -> Checked<VirtualEdge> {
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

    fn of(value: &Value) -> Checked<Self> {
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

/// Block `examples`.
pub(crate) fn examples(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_object() else {
        return ledger.fail(
            "examples",
            "",
            block.clone(),
            "an object of named examples is needed here".into(),
        );
    };
    for (name, value) in list {
        let mut expected = Expected::new(name, "", value, ledger);
        expected.informative(&["input", "beam"]);
        check_object(expected, ledger, |expected, ledger| check_example(reference, value, expected, ledger));
    }
}

fn check_example(
    reference: &Reference<'_>,
    value: &Value,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let example = SkivingExample::of(value)?;
    let input = ExampleInput::deserialize(&value["input"])?;
    let tolerances = reference.tolerances();
    if let Some(derived) = expected.object("derived", ledger) {
        check_object(derived, ledger, |derived, ledger| {
            check_derived(
                &example,
                derived,
                [tolerances.get("length_mm"), tolerances.get("angle_deg")],
                ledger,
            );
            Ok(())
        });
    }
    let sharp = EdgeRounding { radius: 0.0, rake_chamfer_width: 0.0, ..input.rounding() };
    let pair = example.edges.left.pair();
    let sharp = pair.with_tool(pair.tool().with_rounding(sharp)?)?;
    for flank in Flank::BOTH {
        let edge = &example.edges[flank];
        let sharp = input.edge(&sharp, flank)?;
        if let Some(object) = expected.peek("edges") {
            check_edges(&tolerances, edge, &sharp, &object[flank.name()], ledger)?;
        }
        if let Some(object) = expected.peek("poses") {
            check_poses(&tolerances, &example, flank, &object[flank.name()], ledger)?;
        }
        if let Some(object) = expected.peek("sensitivity") {
            let mut rows = Expected::new(expected.case(), "sensitivity", object, ledger);
            let tracks = default_track_places().into_iter().map(|place| MeasuringTrack::new(edge, place));
            let motion = pair.motion();
            let of = |track: MeasuringTrack| setting_sensitivity(motion, &track.contact);
            let actual: Vec<f64> = tracks.map(|track| track.map(of)).collect::<Result<Vec<_>, _>>()?.concat();
            rows.table(flank.name(), (&actual, 4), tolerances.get("sensitivity"), ledger);
        }
    }
    for key in ["edges", "poses", "sensitivity"] {
        sides_only(expected, key, ledger);
    }
    Ok(())
}

/// Both flanks of a key have been checked; nothing else may stand there.
fn sides_only(expected: &mut Expected<'_>, key: &str, ledger: &mut Ledger) {
    if let Some(mut object) = expected.object(key, ledger) {
        object.informative(&["left", "right"]);
        object.finish(ledger);
    }
}

fn check_derived(
    example: &SkivingExample,
    derived: &mut Expected<'_>,
    [mm, degrees]: [f64; 2],
    ledger: &mut Ledger,
) {
    let edge = &example.edges.left;
    let pair = edge.pair();
    let (tool, gear, motion) = (pair.tool(), pair.gear(), pair.motion());
    let helicoid = edge.flank().helicoid();
    let [from, to] = edge.flank().range();
    derived.numbers(
        &[
            ("s_I", helicoid.external_sign()),
            ("r2", gear.pitch_radius()),
            ("r_b2", helicoid.base_radius()),
            ("helix_rad_per_mm", helicoid.twist()),
            ("r1", tool.pitch_radius()),
            ("d", motion.centre_distance),
            ("ratio_i21", motion.ratio),
            ("w_from", from),
            ("w_to", to),
            ("centre_depth_h_c", tool.rounding().depth()),
            ("cutting_sense_omega1", edge.cutting_direction()),
        ],
        mm,
        ledger,
    );
    for (key, angle) in [
        ("alpha_t_deg", gear.transverse_pressure_angle(Flank::Left)),
        ("beta_b2_deg", helicoid.base_helix_angle()),
        ("eta_b2_deg", helicoid.base_space_half_angle()),
        ("gamma_deg", motion.crossed_axes_angle),
        ("phi_20_deg", motion.work_angle),
        ("phi_10_deg", motion.tool_angle),
    ] {
        derived.periodic(key, angle.to_degrees(), 360.0, degrees, ledger);
    }
}
