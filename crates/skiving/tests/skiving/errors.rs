//! Every error of `docs/mathematics/skiving.md#limits`, provoked.

use super::samples::{CROWNED, RING, STEPPED, Sample};
use foundation::geometry::{
    EdgeRounding, Flank, Gear, GearData, Helicoid, NormalOffset, OffsetBounds, Sides,
};
use foundation::numerics::Jet2;
use nalgebra::Vector3;
use skiving::evaluation::{ProfileOptions, evaluate, measured_tool};
use skiving::measuring::{
    Approach, Barrier, BarrierData, Beam, BeamLine, Calibration, EdgeErrors, Mandrel, Noise, Observation,
    PoseKind, PoseLimits, RealTool, Sense, conventional_reading, measuring_poses, reached_pose, readings,
    switches,
};
use skiving::{
    Kinematics, MeasuringTrack, PairData, Setting, SettingLimits, SkivedFlank, SkivingError, SkivingPair,
    VirtualEdge, fit_setting,
};
use std::sync::Arc;

fn code<T>(made: Result<T, SkivingError>) -> &'static str {
    let error = made.err().expect("an error");
    assert!(!error.way_out().is_empty() && !error.to_string().is_empty());
    error.code()
}

fn edge(sample: &Sample, pair: &SkivingPair) -> Result<VirtualEdge, SkivingError> {
    VirtualEdge::new(pair, sample.flank(pair, Flank::Left))
}

fn pair_of(sample: &Sample, rounding: EdgeRounding) -> SkivingPair {
    let pair = sample.pair();
    pair.with_tool(pair.tool().with_rounding(rounding).unwrap()).unwrap()
}

#[test]
fn numbers_and_bodies() {
    let gear = |teeth: i32, angle: f64, helix: f64| {
        let data = GearData {
            teeth,
            pressure_angle: Sides::both(angle.to_radians()),
            helix_angle: helix.to_radians(),
            ..*RING.gear().data()
        };
        SkivingPair::new(RING.tool(), Gear::new(data).unwrap(), PairData::default())
    };
    assert_eq!(code(gear(2, 20.0, 20.0)), "invalid-number");
    assert_eq!(code(gear(-85, 46.0, 20.0)), "invalid-number");
    assert_eq!(code(gear(-85, 20.0, 61.0)), "invalid-number");
    // A spur tool for a spur gear does not skive, and shapes no helical one.
    assert_eq!(code(gear(-85, 20.0, 0.0)), "axes-parallel");
    let shaping = PairData { kinematics: Kinematics::Shaping, ..PairData::default() };
    assert_eq!(code(SkivingPair::new(RING.tool(), RING.gear(), shaping)), "axes-crossed");
    let set = |setting: PairData| SkivingPair::new(RING.tool(), RING.gear(), setting);
    let distance = |d: f64| set(PairData { centre_distance: Some(d), ..PairData::default() });
    assert_eq!(code(distance(49.0)), "invalid-centre-distance");
    assert_eq!(code(distance(f64::NAN)), "invalid-number");
    let rounding = |radius: f64| RING.tool().with_rounding(EdgeRounding { radius, ..RING.rounding() });
    assert_eq!(rounding(-0.01).unwrap_err().code(), "invalid-number");
    assert_eq!(rounding(f64::NAN).unwrap_err().code(), "invalid-number");
    let beam = |radius: f64, tilt: f64| Beam::new(Vector3::zeros(), [tilt, 0.0], radius);
    assert_eq!(code(beam(0.0, 0.0)), "invalid-number");
    assert_eq!(code(beam(0.05, 1.6)), "invalid-number");
}

#[test]
fn flanks() {
    let pair = RING.pair();
    assert_eq!(code(pair.flank_between(Flank::Left, [80.0, 92.0])), "radius-below-base-circle");
    let helicoid = Helicoid::new(pair.gear(), Flank::Left);
    assert_eq!(code(SkivedFlank::new(helicoid, [0.0, 30.0])), "below-base-circle");
    assert_eq!(code(SkivedFlank::new(helicoid, [30.0, 20.0])), "invalid-number");
    #[derive(Debug)]
    struct Slope;
    impl NormalOffset for Slope {
        fn jet(&self, _: f64, z: f64) -> Jet2 {
            Jet2 { fv: 1e-4, ..Jet2::constant(1e-4 * z) }
        }
        fn bounds(&self, _: [f64; 2], _: [f64; 2]) -> OffsetBounds {
            OffsetBounds { value: 1.0, by_height: 0.0, by_length: 1e-4, second: [0.0; 3] }
        }
    }
    let leaning = RING.flank(&pair, Flank::Left).modified(Arc::new(Slope), [-5.0, 5.0]);
    assert_eq!(code(leaning), "lead-modification-not-supported");
}

#[test]
fn edges() {
    let set = |setting: PairData| {
        let pair = SkivingPair::new(RING.tool(), RING.gear(), setting).unwrap();
        code(edge(&RING, &pair))
    };
    // Axes so near to each other that the tool does not reach the flank; axes crossed the other way.
    assert_eq!(set(PairData { centre_distance: Some(-30.0), ..PairData::default() }), "no-contact");
    let crossed = PairData { crossed_axes_angle: Some(-0.34), ..PairData::default() };
    assert_eq!(set(crossed), "rounding-too-large");
    let wide = EdgeRounding { radius: 30.0, ..RING.rounding() };
    assert_eq!(code(edge(&RING, &pair_of(&RING, wide))), "rounding-too-large");
    let chamfered = EdgeRounding { clearance_chamfer_angle: 60f64.to_radians(), ..CROWNED.rounding() };
    assert_eq!(code(edge(&CROWNED, &pair_of(&CROWNED, chamfered))), "contact-off-rounding");
    let steep = Sample { rake: 80.0, ..STEPPED };
    assert_eq!(code(edge(&steep, &steep.pair())), "cutting-direction-ambiguous");
    // Three teeth of a watch: L = z1 m_n cos(alpha_t)/(2 cos(beta)) cos(beta_b) is below a tenth of a millimetre.
    let watch = Sample {
        teeth: [3, 47],
        module: 0.05,
        tool_shift: 0.0,
        radii: [1.18, 1.26],
        rounding: [1e-4, 8.0, 0.0, 0.0, 0.0],
        ..STEPPED
    };
    assert_eq!(code(edge(&watch, &watch.pair())), "lever-too-small");
}

#[test]
fn poses() {
    let edges = CROWNED.edges();
    let track = MeasuringTrack::new(&edges.left, 0.0).unwrap();
    assert_eq!(code(MeasuringTrack::new(&edges.left, 1.5)), "invalid-number");
    // The flank direction stands along the axis only where it is made to.
    let mut upright = track;
    upright.contact.flank_direction = Vector3::z();
    let poses =
        |track: &MeasuringTrack, beam: &Beam, kind| measuring_poses(track, beam, kind, (Flank::Left, 0));
    assert_eq!(code(poses(&upright, &CROWNED.beam(), PoseKind::AlongFlank)), "degenerate-flank-direction");
    // The normal looks along the beam's tilt, so that no swivel lays the beam across it.
    let mut facing = track;
    facing.contact.normal = Vector3::new(1e-6, 1.0, 0.0).normalize();
    facing.contact.tool_angle = std::f64::consts::PI;
    assert_eq!(code(poses(&facing, &CROWNED.beam(), PoseKind::Tangent)), "pose-not-reachable");
}

#[test]
fn machines() {
    let (edges, beam) = (CROWNED.edges(), CROWNED.beam());
    let track = MeasuringTrack::new(&edges.left, 0.0).unwrap();
    let reached = |limits: PoseLimits, beam: &Beam| {
        reached_pose(&edges, &track, beam, PoseKind::Tangent, &limits, (Flank::Left, 2))
    };
    let free = PoseLimits::default();
    let pose = reached(free, &beam).unwrap();
    let near = |x: f64| [x + 1.0, x + 2.0];
    let x = PoseLimits { position: [near(pose.position.x), free.position[1], free.position[2]], ..free };
    assert_eq!(code(reached(x, &beam)), "axis-limit");
    // The swivel ends short: the tool turns instead, if the beam still lies on the flank closely enough.
    let short = PoseLimits { swivel: [pose.swivel + 0.01, 1.0], ..free };
    let held = reached(short, &beam).unwrap();
    assert_eq!(held.swivel, pose.swivel + 0.01);
    assert!(held.beam_in_tool.dot(&track.contact.normal).abs() < 1e-12);
    assert_eq!(code(reached(PoseLimits { off_flank: 0.1, ..free }, &beam)), "pose-not-reachable");
    assert_eq!(code(reached(free, &Beam { radius: 1.2, ..beam })), "shadowed");
}

#[test]
fn touches() {
    let flanks = STEPPED.flanks();
    let beam = STEPPED.beam();
    let tracks = &flanks.right.tracks;
    let (track, pose) = &tracks[0];
    let barrier = Barrier { beam: &beam, pose };
    let touch = |tool: &RealTool| barrier.touch(&flanks.right.edge, tool, track, 0, beam.radius);
    let mut tool = RealTool::ideal(75);
    tool.broken[0] = true;
    assert_eq!(code(touch(&tool)), "no-trigger");
    // An edge that grows steeply towards its end is met there.
    let mut tool = RealTool::ideal(75);
    tool.edges.right[0] = EdgeErrors { profile: vec![0.0, -2.0], growth: vec![] };
    let refused = code(touch(&tool));
    assert!(["edge-end-touched", "body-touched", "no-trigger"].contains(&refused), "{refused}");
    // The usual way lays the beam on the clearance face of a flank that leans outwards.
    let usual = conventional_reading(&flanks.right.edge, &RealTool::ideal(75), track, &beam, 0);
    assert_eq!(code(usual), "body-touched");
    let tilted = conventional_reading(&flanks.right.edge, &RealTool::ideal(75), track, &CROWNED.beam(), 0);
    assert_eq!(code(tilted), "invalid-number");
}

#[test]
fn evaluations() {
    let flanks = RING.flanks();
    let ideal = RealTool::ideal(41);
    let (beam, data) = (RING.beam(), BarrierData::ideal());
    let read = |tool: &RealTool| {
        let switched = switches(&flanks, &beam, &data, tool).unwrap();
        readings(&flanks, &switched, &data, &[Sense::Positive], 1, &mut Noise::new(1))
    };
    let mut broken = ideal.clone();
    broken.broken[..21].fill(true);
    assert_eq!(code(measured_tool(&flanks, &read(&broken), 0.0)), "trigger-count-mismatch");
    assert_eq!(code(measured_tool(&flanks, &[], 0.0)), "trigger-count-mismatch");
    let mut seen = read(&ideal);
    seen[5].angle += 0.7 * std::f64::consts::PI / 41.0;
    assert_eq!(code(measured_tool(&flanks, &seen, 0.0)), "ambiguous-tooth");
    seen[5].angle = seen[6].angle;
    assert_eq!(code(measured_tool(&flanks, &seen, 0.0)), "ambiguous-tooth");
    seen[5].angle = f64::NAN;
    assert_eq!(code(measured_tool(&flanks, &seen, 0.0)), "invalid-number");
    let measured = measured_tool(&flanks, &read(&ideal), 0.0).unwrap().deviations;
    let judged =
        |degree, band| evaluate(&flanks, &measured, &ProfileOptions { degree, band, wear_limit: 0.01 });
    assert_eq!(code(judged(5, 0.01)), "too-few-tracks");
    assert_eq!(code(judged(2, 0.0)), "invalid-number");
    let mut other = ideal.clone();
    other.pitch.pop();
    assert_eq!(code(other.check(41)), "invalid-number");
    other.pitch.push(f64::INFINITY);
    assert_eq!(code(other.check(41)), "invalid-number");
    let fit = |deviation: f64, limit: f64| {
        let limits = SettingLimits { of: [limit; 4] };
        fit_setting(&[[1.0; 4]], &[deviation], &Setting::USUAL, &limits)
    };
    assert_eq!(code(fit(f64::NAN, 1.0)), "invalid-number");
    assert_eq!(code(fit(0.1, 0.0)), "invalid-number");
}

#[test]
fn calibrations() {
    let mandrel = Mandrel { radius: 10.0, height: 4.0 };
    let line = BeamLine::from_numbers([268.0, 19.4, 0.21, 0.004, 0.05]);
    let seen = |z: f64, along: Approach, side: f64| {
        let at = line.at(z + 2.0);
        let axis = if along == Approach::X { Vector3::x() } else { Vector3::y() };
        let from = Vector3::new(at.x + 0.3, at.y + 0.1, z);
        let place = mandrel.switch(&line, &from, &(axis * side), [15.0, 0.0]).unwrap();
        Observation { place, along }
    };
    let at = |z: f64| [seen(z, Approach::Y, 1.0), seen(z, Approach::Y, -1.0), seen(z, Approach::X, 1.0)];
    let all = [at(148.0), at(208.0)].concat();
    let found =
        Calibration::fit(&mandrel, &all, &Calibration::start(&mandrel, &all, 0.08, true).unwrap()).unwrap();
    for (a, b) in found.line.numbers().into_iter().zip(line.numbers()) {
        assert!((a - b).abs() < 1e-10, "{:?}", found.line);
    }
    let fit = |observations: &[Observation]| Calibration::fit(&mandrel, observations, &line);
    assert_eq!(code(fit(&all[..4])), "calibration-singular");
    assert_eq!(code(fit(&[at(148.0), at(148.0)].concat())), "calibration-singular");
    // Without a single approach in X the beam's x is not told from its radius.
    let only_y: Vec<_> =
        [at(148.0), at(178.0), at(208.0)].concat().into_iter().filter(|o| o.along == Approach::Y).collect();
    assert!(fit(&only_y).is_err() || fit(&only_y).unwrap().deviations_at(150.0)[0] > 5.0);
    // An upright beam in line with the mandrel: every direction parts them alike.
    let upright = BeamLine::from_numbers([268.0, 19.4, 0.0, 0.0, 0.05]);
    assert_eq!(mandrel.gap(&upright, &Vector3::new(268.0, 19.4, 100.0)).value, -10.05);
    let mut wrong = all;
    wrong[0].place.x = f64::NAN;
    assert_eq!(code(fit(&wrong)), "invalid-number");
}
