//! The machine side of five-axis milling (`docs/mathematics/milling.md#positions-of-five-axes`): the reference numbers of
//! `50-milling.json`, and the machines of `machines/` under random, singular and too long paths.

use foundation::geometry::CutterShape;
use foundation::kinematics::{Direction, Point, Pose};
use job::machine::read_machine;
use machine::{
    Axis, AxisLimits, AxisSolutions, Joint, Limb, Machine, MachineError, MachineParts, Positions, Station,
    ToolAxis,
};
use motion::MotionError;
use motion::milling::{
    AxisCourse, Change, CutterPlace, DEFAULT_CAP, MillingSetup, PoleStrategy, block_times, choose, leans,
    pole_passages, refine, section_feeds, smoothness, straight_error, straight_runs, tilt_mount,
};
use nalgebra::Vector3;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

type DirectionCase = (&'static str, [f64; 3], &'static [[f64; 2]]);
type SlideCase = (&'static str, [f64; 3], [f64; 2], [f64; 3]);

/// Chain, direction of the tool, both solutions (C, tilt), deg; none beyond reach.
const DIRECTIONS: [DirectionCase; 20] = [
    (
        "AC table",
        [-0.3378536900859549, 0.05823091835896943, 0.9393955738890697],
        &[[-80.22084037092812, 20.049702563553268], [99.77915962907188, -20.049702563553268]],
    ),
    (
        "AC table",
        [-0.5838188809998632, -0.6582295965798222, 0.47527814211725783],
        &[[-138.42847342542777, 61.62253862337324], [41.571526574572246, -61.62253862337324]],
    ),
    (
        "AC table",
        [-0.32044319032514285, 0.16168448100031735, 0.933367178755447],
        &[[-63.226078012581176, 21.034067613666657], [116.77392198741882, -21.034067613666657]],
    ),
    (
        "AC table",
        [-0.6668888421189602, 0.10289295025878235, 0.7380191820300313],
        &[[-81.22910841563352, 42.43704747917714], [98.77089158436648, -42.43704747917714]],
    ),
    (
        "BC table",
        [-0.18542966429787738, -0.5053294478206979, 0.8427680515797957],
        &[[-69.8494855541351, 32.56641620480849], [110.1505144458649, -32.56641620480849]],
    ),
    (
        "BC table",
        [0.2625639371483087, 0.9281113420185848, 0.2639498356234392],
        &[[105.79627899136118, 74.69543879714983], [-74.20372100863882, -74.69543879714983]],
    ),
    (
        "BC table",
        [-0.9919305141589125, -0.07364130699302138, 0.10320277605178609],
        &[[-4.245871811664065, 84.07636934406793], [175.75412818833593, -84.07636934406793]],
    ),
    (
        "BC table",
        [0.5944240847251524, 0.14845413670554197, -0.7903299164233106],
        &[[165.97753613760386, 142.2163533897768], [-14.022463862396146, -142.2163533897768]],
    ),
    (
        "B head, C table",
        [-0.6093254931594864, 0.4505788369240598, 0.6524577803215394],
        &[[36.481869897636095, -49.27283468718784], [-143.5181301023639, 49.27283468718784]],
    ),
    (
        "B head, C table",
        [-0.5222107940121734, -0.0008554448469446057, 0.8528160146428355],
        &[[-0.09385737724436143, -31.48071143436317], [179.90614262275565, 31.48071143436317]],
    ),
    (
        "B head, C table",
        [0.35707497386713555, 0.6679787852792809, 0.6529179163222593],
        &[[118.12719316146972, -49.23803675309609], [-61.8728068385303, 49.23803675309609]],
    ),
    (
        "B head, C table",
        [-0.05649471251197965, -0.1542107260713439, 0.9864215120437803],
        &[[-69.87981841079664, -9.45270241228019], [110.12018158920336, 9.45270241228019]],
    ),
    (
        "CA head",
        [-0.9609686281147863, -0.05919682096220243, 0.2702499438800206],
        &[[93.52503446898129, -74.32085949507369], [-86.47496553101871, 74.32085949507369]],
    ),
    (
        "CA head",
        [-0.9732089790651448, 0.22724063057745414, -0.03501398123235291],
        &[[76.85712646439681, -92.00656349181635], [-103.14287353560319, 92.00656349181635]],
    ),
    (
        "CA head",
        [0.5601785838774429, -0.08157507133338789, 0.8243454748477822],
        &[[-98.28536293401628, -34.47781147962892], [81.71463706598374, 34.47781147962892]],
    ),
    (
        "CA head",
        [0.9325538674309249, 0.2929846469211225, -0.21095800768904258],
        &[[-72.55861093719194, -102.17849984185189], [107.44138906280807, 102.17849984185189]],
    ),
    (
        "CB nutating table",
        [-0.6395537958912855, 0.7405201550949477, 0.20639971429050574],
        &[[-5.015738110678534, 125.95860289806704], [-76.61564055221127, -125.95860289806704]],
    ),
    (
        "CB nutating table",
        [-0.8463625360489211, 0.17731630881540764, 0.5022244360850214],
        &[[-23.31176031067294, 89.74509756020076], [-133.02312725044243, -89.74509756020076]],
    ),
    (
        "CB nutating table",
        [0.8110176408882124, 0.03229079889047036, 0.5841298575446505],
        &[[146.89815667693475, 80.31334939326923], [28.54177041412119, -80.31334939326923]],
    ),
    ("CB nutating table", [-0.7452606480732679, 0.489729298616558, -0.45249506131000705], &[]),
];

/// Chain, tip, C and tilt (deg), positions of X, Y, Z; q_1 = (0, 0, 20), q_2 = (0, 5, -30), pivot 180 mm above the tip.
const SLIDES: [SlideCase; 5] = [
    (
        "AC table",
        [10.382199219063764, 40.762152433073084, 27.17683323748446],
        [-15.469028131762459, -5.913347363719472],
        [20.87807845614529, 42.23931745783997, 23.625630627302307],
    ),
    (
        "BC table",
        [-15.876051637199204, -46.83184031919639, -35.61101470951241],
        [-24.773951483232384, -21.298686673052067],
        [-29.67634163592435, -35.86912608845237, -47.59188193737944],
    ),
    (
        "B head, C table",
        [-22.43425694160748, 9.203965950354245, 56.60279707437056],
        [31.474191429483284, 33.36149300656437],
        [75.04636634780044, -3.8634131448663345, 26.941971983900086],
    ),
    (
        "CA head",
        [31.112220064749593, 11.638527662850777, 50.12307086050953],
        [21.730015151054953, 0.04084395382288933],
        [31.1597265893734, 11.519330836947777, 50.12302512507821],
    ),
    (
        "CB nutating table",
        [-50.74994297993535, -1.3860927497371378, -34.460280559159884],
        [-42.08990390019615, 0.6949889280137577],
        [-38.86579235745463, 32.65668754466232, -34.128102248023175],
    ),
];

/// Directions across the pole; C and A, deg.
const THROUGH_POLE: [([f64; 3], [f64; 2]); 13] = [
    ([0.0, -0.2873478855663454, 0.9578262852211513], [0.0, -16.69924423399364]),
    ([0.0, -0.24253562503633297, 0.9701425001453319], [0.0, -14.03624346792648]),
    ([0.0, -0.19611613513818402, 0.9805806756909201], [0.0, -11.309932474020226]),
    ([0.0, -0.14834045293024462, 0.9889363528682975], [0.0, -8.53076560994814]),
    ([0.0, -0.09950371902099893, 0.9950371902099893], [0.0, -5.710593137499581]),
    ([0.0, -0.049937616943892246, 0.9987523388778446], [0.0, -2.8624052261117856]),
    ([0.0, 0.0, 1.0], [0.0, 0.0]),
    ([0.0, 0.04993761694389222, 0.9987523388778446], [0.0, 2.8624052261117856]),
    ([0.0, 0.0995037190209989, 0.9950371902099893], [0.0, 5.710593137499581]),
    ([0.0, 0.1483404529302446, 0.9889363528682975], [0.0, 8.53076560994814]),
    ([0.0, 0.196116135138184, 0.9805806756909201], [0.0, 11.309932474020226]),
    ([0.0, 0.2425356250363329, 0.9701425001453319], [0.0, 14.03624346792648]),
    ([0.0, 0.2873478855663454, 0.9578262852211513], [0.0, 16.69924423399364]),
];
/// The same, past the pole by 0.02.
const NEAR_POLE: [([f64; 3], [f64; 2]); 13] = [
    (
        [0.019153011712702294, -0.2872951756905344, 0.9576505856351147],
        [-3.8140748342903543, -16.73424225462422],
    ),
    (
        [0.01939919873264418, -0.24248998415805229, 0.9699599366322091],
        [-4.57392125990086, -14.079306913753822],
    ),
    (
        [0.0196078431372549, -0.19607843137254902, 0.9803921568627451],
        [-5.710593137499643, -11.364876967033688],
    ),
    (
        [0.01977485949239793, -0.14831144619298448, 0.9887429746198965],
        [-7.594643368591445, -8.60513526857474],
    ),
    (
        [0.019896804232983473, -0.09948402116491738, 0.9948402116491737],
        [-11.309932474020213, -5.822915528381604],
    ),
    (
        [0.019971062922954537, -0.04992765730738636, 0.9985531461477268],
        [-21.801409486351808, -3.0824947102675657],
    ),
    ([0.01999600119960014, 0.0, 0.9998000599800071], [-90.0, -1.1457628381748015]),
    (
        [0.019971062922954537, 0.04992765730738633, 0.9985531461477268],
        [-158.19859051364818, -3.0824947102675657],
    ),
    (
        [0.019896804232983473, 0.09948402116491735, 0.9948402116491737],
        [-168.6900675259798, -5.822915528381604],
    ),
    (
        [0.01977485949239793, 0.14831144619298445, 0.9887429746198965],
        [-172.40535663140858, -8.60513526857474],
    ),
    (
        [0.0196078431372549, 0.19607843137254896, 0.9803921568627451],
        [-174.28940686250036, -11.364876967033688],
    ),
    (
        [0.01939919873264418, 0.24248998415805223, 0.9699599366322091],
        [-175.42607874009914, -14.079306913753822],
    ),
    (
        [0.019153011712702294, 0.2872951756905344, 0.9576505856351147],
        [-176.18592516570965, -16.73424225462422],
    ),
];

/// The helical row of the reference: u, C and A (deg), X, Y, Z.
const ROW: [(f64, [f64; 2], [f64; 3]); 9] = [
    (
        -10.0,
        [26.32531563267689, 80.7417297139169],
        [-27.76863007168717, -28.728667496379337, 23.432569788818824],
    ),
    (
        -7.5,
        [25.447987997064672, 80.7417297139169],
        [-27.768630071687163, -31.19610038162429, 23.834782365464235],
    ),
    (
        -5.0,
        [24.570660361452454, 80.7417297139169],
        [-27.76863007168717, -33.66353326686924, 24.23699494210966],
    ),
    (
        -2.5,
        [23.693332725840236, 80.7417297139169],
        [-27.76863007168717, -36.1309661521142, 24.639207518755086],
    ),
    (
        0.0,
        [22.81600509022801, 80.7417297139169],
        [-27.768630071687166, -38.59839903735916, 25.041420095400497],
    ),
    (
        2.5,
        [21.938677454615792, 80.7417297139169],
        [-27.76863007168717, -41.06583192260412, 25.443632672045908],
    ),
    (
        5.0,
        [21.061349819003574, 80.7417297139169],
        [-27.76863007168717, -43.533264807849065, 25.84584524869132],
    ),
    (
        7.5,
        [20.184022183391363, 80.7417297139169],
        [-27.768630071687166, -46.00069769309404, 26.24805782533673],
    ),
    (
        10.0,
        [19.306694547779134, 80.7417297139169],
        [-27.768630071687166, -48.46813057833899, 26.65027040198214],
    ),
];
/// Of its blocks: dt (s), feed of the tip (mm/min), F of G93, tip in mid-block without RTCP (mm).
const BLOCKS: [(f64, f64, f64, [f64; 3]); 8] = [
    (
        0.13819300587034483,
        1189.853313448606,
        434.1753739425357,
        [0.0001360535856509415, 0.00214443825971955, 0.0],
    ),
    (
        0.13819300587034486,
        1189.8533134486065,
        434.1753739425356,
        [0.00010320273188835216, 0.002146270072501011, 0.0],
    ),
    (
        0.13819300587034483,
        1189.8533134486065,
        434.1753739425357,
        [7.032768115156074e-05, 0.0021475986695236315, 0.0],
    ),
    (
        0.1381930058703448,
        1189.8533134486067,
        434.17537394253577,
        [3.743614133777662e-05, 0.002148423739257055, 0.0],
    ),
    (
        0.13819300587034486,
        1189.8533134486065,
        434.1753739425356,
        [4.535824212226203e-06, 0.0021487450882489156, 0.0],
    ),
    (
        0.1381930058703448,
        1189.8533134486067,
        434.17537394253577,
        [-2.836555637131255e-05, 0.0021485626412101055, 0.0],
    ),
    (
        0.1381930058703448,
        1189.8533134486072,
        434.17537394253577,
        [-6.126028635389247e-05, 0.0021478764409010864, 0.0],
    ),
    (
        0.13819300587034494,
        1189.8533134486058,
        434.1753739425354,
        [-9.414065321067255e-05, 0.002146686648174523, 0.0],
    ),
];

const ENDLESS: Option<[f64; 2]> = None;

fn vector(xyz: [f64; 3]) -> Vector3<f64> {
    Vector3::from(xyz)
}

fn axis(name: &str, joint: Joint, direction: [f64; 3], point: [f64; 3], travel: Option<[f64; 2]>) -> Axis {
    Axis {
        name: name.into(),
        joint,
        direction: vector(direction),
        point: vector(point),
        travel,
        nc_sign: 1.0,
        limits: AxisLimits {
            velocity: Some(match joint {
                Joint::Linear => 20000.0 / 60.0,
                Joint::Rotary => 60f64.to_radians(),
            }),
            ..AxisLimits::default()
        },
        resolution: None,
    }
}

/// A chain of `docs/mathematics/milling.md#positions-of-five-axes` with axis points q_1 and q_2 and the pivot of a head above the tip;
/// `travels` in rad.
fn chain(name: &str, q: [[f64; 3]; 2], pivot: f64, travels: [Option<[f64; 2]>; 2]) -> Machine {
    let half = 0.5f64.sqrt();
    let head = [0.0, 0.0, pivot];
    let (tool, work, points, tilt): (&[usize], &[usize], _, _) = match name {
        "AC table" => (&[0, 1, 2], &[4, 3], q, [1.0, 0.0, 0.0]),
        "BC table" => (&[0, 1, 2], &[4, 3], q, [0.0, 1.0, 0.0]),
        "CB nutating table" => (&[0, 1, 2], &[4, 3], q, [0.0, half, half]),
        "B head, C table" => (&[0, 1, 2, 4], &[3], [q[0], head], [0.0, 1.0, 0.0]),
        "CA head" => (&[0, 1, 2, 3, 4], &[], [head, head], [1.0, 0.0, 0.0]),
        other => panic!("{other}"),
    };
    let limb = |axes: &[usize]| Limb {
        axes: axes.to_vec(),
        origin: Vector3::zeros(),
        x: Vector3::x(),
        z: Vector3::z(),
    };
    let far = Some([-1e4, 1e4]);
    Machine::new(MachineParts {
        name: name.into(),
        axes: vec![
            axis("X", Joint::Linear, [1.0, 0.0, 0.0], [0.0; 3], far),
            axis("Y", Joint::Linear, [0.0, 1.0, 0.0], [0.0; 3], far),
            axis("Z", Joint::Linear, [0.0, 0.0, 1.0], [0.0; 3], far),
            axis("C", Joint::Rotary, [0.0, 0.0, 1.0], points[0], travels[0]),
            axis("T", Joint::Rotary, tilt, points[1], travels[1]),
        ],
        roles: vec![],
        tool: limb(tool),
        work: limb(work),
        dresser: None,
    })
    .expect("a machine")
}

fn shipped() -> Vec<Machine> {
    ["ac-table", "bc-table", "head-table", "head-head", "nutating-table"].map(shipped_machine).into()
}

fn shipped_machine(name: &str) -> Machine {
    let directory = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines");
    read_machine(&directory.join(format!("five-axis-{name}.toml"))).expect("a shipped machine").machine
}

fn setup(machine: &Machine, tool_length: f64) -> MillingSetup<'_> {
    MillingSetup::new(machine, Pose::identity(), tool_length).expect("two rotary and three linear axes")
}

/// With a tool of 100 mm.
fn milled(machine: &Machine) -> MillingSetup<'_> {
    setup(machine, 100.0)
}

fn place(contact: Vector3<f64>, tip: Vector3<f64>, axis: Vector3<f64>) -> CutterPlace {
    CutterPlace {
        contact: Point::from_vector(contact),
        tip: Point::from_vector(tip),
        axis: Direction::from_vector(axis),
    }
}

/// Places with these directions, 1 mm apart along x.
fn fan(directions: impl IntoIterator<Item = Vector3<f64>>) -> Vec<CutterPlace> {
    let at = |(k, axis): (usize, Vector3<f64>)| {
        let tip = Vector3::new(k as f64, 0.0, 0.0);
        place(tip, tip, axis.normalize())
    };
    directions.into_iter().enumerate().map(at).collect()
}

fn slow(setup: &MillingSetup, places: &[CutterPlace]) -> AxisCourse {
    choose(setup, places, &Positions::default(), PoleStrategy::Slow).expect("a course")
}

/// How far the cutter of a course is off these places: tip (mm), axis.
fn off(setup: &MillingSetup, course: &AxisCourse, places: &[CutterPlace]) -> [f64; 2] {
    let mut worst = [0.0f64; 2];
    for (at, place) in course.nodes.iter().zip(places) {
        let (tip, axis) = setup.stands(at).expect("finite");
        worst[0] = worst[0].max((tip.xyz - place.tip.xyz).amax());
        worst[1] = worst[1].max((axis.xyz - place.axis.xyz).amax());
    }
    worst
}

fn degrees_of(setup: &MillingSetup, at: &Positions) -> [f64; 2] {
    setup.axes().rotary.map(|axis| at[axis].to_degrees())
}

fn same_angle(a: f64, b: f64) -> bool {
    let apart = (a - b) / 360.0;
    (apart - apart.round()).abs() * 360.0 < 1e-8
}

#[test]
fn both_solutions_in_the_order_of_the_reference() {
    for (name, direction, expected) in DIRECTIONS {
        let machine = chain(name, [[0.0; 3]; 2], 0.0, [ENDLESS; 2]);
        let five = machine.five_axes(Station::Work).expect("five axes");
        assert_eq!(five.rotary, [3, 4], "{name}");
        let wanted = ToolAxis {
            tip: Point::new(0.0, 0.0, 0.0),
            axis: Direction::from_vector(vector(direction)),
            reach: Point::new(0.0, 0.0, 0.0),
        };
        match machine.tool_axis(Station::Work, &wanted, None) {
            Ok(AxisSolutions::Positions(found)) => {
                assert_eq!(found.len(), expected.len(), "{name} {direction:?}");
                for (at, angles) in found.iter().zip(expected) {
                    let [c, tilt] = five.rotary.map(|axis| at[axis].to_degrees());
                    assert!(
                        same_angle(c, angles[0]) && same_angle(tilt, angles[1]),
                        "{name}: {c} {tilt} {angles:?}"
                    );
                }
            }
            Err(error) => {
                assert!(expected.is_empty(), "{name}: {error}");
                assert_eq!(error.code(), "unreachable");
            }
            other => panic!("{name}: {other:?}"),
        }
    }
}

#[test]
fn slides_of_all_chains() {
    for (name, tip, angles, expected) in SLIDES {
        let machine = chain(name, [[0.0, 0.0, 20.0], [0.0, 5.0, -30.0]], 180.0, [ENDLESS; 2]);
        let setup = setup(&machine, 0.0);
        let mut at = Positions::default();
        for k in 0..3 {
            at[k] = expected[k];
        }
        [at[3], at[4]] = angles.map(f64::to_radians);
        let (stands, axis) = setup.stands(&at).expect("finite");
        assert!((stands.xyz - vector(tip)).amax() < 1e-9, "{name}: {:?}", stands.xyz);
        let AxisSolutions::Positions(found) =
            setup.solutions(&place(vector(tip), vector(tip), axis.xyz)).expect("in reach")
        else {
            panic!("{name}: no pole here");
        };
        let near =
            |solution: &&Positions| (3..5).all(|k| same_angle(solution[k].to_degrees(), angles[k - 3]));
        let solution = found.iter().find(near).expect("the angles of the reference");
        for k in 0..3 {
            assert!((solution[k] - expected[k]).abs() < 1e-9, "{name}: {}", solution[k]);
        }
    }
}

#[test]
fn the_pole_is_crossed_and_passed_as_in_the_reference() {
    let machine = shipped_machine("ac-table");
    let setup = setup(&machine, 100.0);
    for (expected, inherited) in [(THROUGH_POLE, vec![6]), (NEAR_POLE, vec![])] {
        let places = fan(expected.iter().map(|(axis, _)| vector(*axis)));
        let course = slow(&setup, &places);
        for (at, (_, angles)) in course.nodes.iter().zip(&expected) {
            let found = degrees_of(&setup, at);
            assert!((0..2).all(|k| (found[k] - angles[k]).abs() < 1e-6), "{found:?} {angles:?}");
        }
        assert_eq!((course.inherited, course.rewinds), (inherited, vec![]));
    }
    let course = slow(&setup, &fan(NEAR_POLE.iter().map(|(axis, _)| vector(*axis))));
    let figures = smoothness(&setup, &course.places, &course.nodes);
    let travel = figures.rotary.map(|change| change.travel.to_degrees());
    assert!((travel[0] - 172.37185033141927).abs() < 1e-6 && (travel[1] - 31.17695883289884).abs() < 1e-6);
    assert_eq!(figures.rotary.map(|change| change.reversals), [0, 1]);
}

/// Across the pole, near it, and as little beside it as makes it no pole: on every machine the tool stands where it is wanted.
#[test]
fn every_machine_crosses_its_pole() {
    for machine in shipped() {
        let setup = milled(&machine);
        for aside in [0.0, 1e-12, 1e-8, 1e-4, 0.02] {
            for around in [0.0, 0.4, 2.0] {
                let (sin, cos) = f64::sin_cos(around);
                let across = Vector3::new(cos, sin, 0.0);
                let step = |k: i32| across * (0.05 * f64::from(k)) + Vector3::new(-sin, cos, 0.0) * aside;
                let places = fan((-6..=6).map(|k| step(k) + Vector3::z()));
                let course = slow(&setup, &places);
                let [tip, axis] = off(&setup, &course, &places);
                assert!(tip < 1e-12 && axis < 2e-12, "{} {aside}: {tip:.1e} mm, {axis:.1e}", machine.name());
                assert_eq!(course.inherited.is_empty(), aside >= 1e-8, "{}", machine.name());
                assert!(course.nodes.iter().all(|at| (0..5).all(|k| machine.axes()[k].admits(at[k]))));
            }
        }
    }
}

#[test]
fn passages_near_the_pole_are_told() {
    let machine = shipped_machine("ac-table");
    let setup = setup(&machine, 100.0);
    let near = fan(NEAR_POLE.iter().map(|(axis, _)| vector(*axis)));
    let told = pole_passages(&setup, &near, DEFAULT_CAP).expect("finite");
    assert_eq!(told.len(), 1);
    assert_eq!((told[0].from, told[0].to), (6, 6));
    assert!((told[0].least.tan() - 0.02).abs() < 1e-12, "{told:?}");
    // Left out, the pole is still passed between the places beside it.
    let beside: Vec<_> = near.iter().enumerate().filter(|(k, _)| *k != 6).map(|(_, place)| *place).collect();
    let told = pole_passages(&setup, &beside, DEFAULT_CAP).expect("finite");
    assert_eq!((told[0].from, told[0].to), (5, 6));
    assert!((told[0].least.tan() - 0.02).abs() < 1e-12, "{told:?}");
    // Its opposite is a pole as well; far from both nothing is told.
    let below = fan([Vector3::new(0.01, 0.0, -1.0), Vector3::new(0.5, 0.0, -1.0)]);
    assert_eq!(pole_passages(&setup, &below, DEFAULT_CAP).expect("finite").len(), 1);
    assert!(pole_passages(&setup, &near[..3], DEFAULT_CAP).expect("finite").is_empty());
    // The whole of a path that stays near is one passage.
    let within = fan((0..5).map(|k| Vector3::new(0.001 * f64::from(k), 0.003, 1.0)));
    let told = pole_passages(&setup, &within, DEFAULT_CAP).expect("finite");
    assert_eq!((told.len(), told[0].from, told[0].to), (1, 0, 4));
}

#[test]
fn a_ball_may_hold_the_first_axis_near_the_pole() {
    let machine = shipped_machine("ac-table");
    let setup = setup(&machine, 100.0);
    let places = fan((0..61).map(|k| Vector3::new(0.02, 0.01 * f64::from(k - 30), 1.0)));
    let plain = slow(&setup, &places);
    let radius = 3.0;
    let hold = PoleStrategy::Hold { cutter: CutterShape::ball(radius), cap: DEFAULT_CAP };
    let held = choose(&setup, &places, &Positions::default(), hold).expect("a course");
    let travel = |course: &AxisCourse| smoothness(&setup, &course.places, &course.nodes).rotary[0].travel;
    assert!(travel(&held) < 0.75 * travel(&plain), "{} {}", travel(&held), travel(&plain));
    assert!(held.inherited.len() > 3 && held.inherited.iter().all(|k| (25..36).contains(k)));
    for &k in &held.inherited {
        let c = setup.axes().rotary[0];
        assert_eq!(held.nodes[k][c], held.nodes[k - 1][c]);
        let (is, was) = (&held.places[k], &places[k]);
        assert!(held.axis_errors[k] <= DEFAULT_CAP && held.axis_errors[k] > 0.0);
        assert!(((is.axis.xyz.cross(&was.axis.xyz)).norm() - held.axis_errors[k].sin()).abs() < 1e-12);
        let ball = |p: &CutterPlace| p.tip.xyz + p.axis.xyz * radius;
        assert!((ball(is) - ball(was)).amax() < 1e-12, "the ball has moved");
    }
    assert!(off(&setup, &held, &held.places)[0] < 1e-12);
    let mill = PoleStrategy::Hold { cutter: CutterShape::end_mill(3.0, 1.0), cap: DEFAULT_CAP };
    let refused = choose(&setup, &places, &Positions::default(), mill).expect_err("an end mill");
    assert_eq!((refused.code(), refused.way_out().is_empty()), ("hold-needs-ball", false));
}

#[test]
fn the_mount_is_tilted_by_as_little_as_it_takes() {
    let clearance = 3f64.to_radians();
    for machine in shipped() {
        let setup = setup(&machine, 100.0);
        let places = fan(THROUGH_POLE.iter().map(|(axis, _)| vector(*axis)));
        let tilted = tilt_mount(&setup, &[&places], clearance, 0.5).expect("a tilt");
        assert!((tilted.angle - clearance).abs() < 1e-6, "{}: {}", machine.name(), tilted.angle);
        assert!(tilted.least >= clearance - 1e-9, "{}", tilted.least.to_degrees());
        let again = setup.clamped(tilted.clamping);
        assert!(pole_passages(&again, &places, DEFAULT_CAP).expect("finite").is_empty());
        let course = slow(&again, &places);
        assert!(course.inherited.is_empty() && off(&again, &course, &places)[1] < 1e-12);
    }
    let machine = shipped_machine("ac-table");
    let setup = setup(&machine, 100.0);
    // Everywhere within 20 degrees of the pole.
    let all_around = fan((0..400).map(|k| {
        let (sin, cos) = (0.5 * f64::from(k)).sin_cos();
        Vector3::new(cos, sin, 1.0) * (0.364 * f64::from(k) / 400.0)
            + Vector3::z() * (1.0 - 0.364 * f64::from(k) / 400.0)
    }));
    let refused = tilt_mount(&setup, &[&all_around], clearance, 10f64.to_radians()).expect_err("no way out");
    assert_eq!(refused.code(), "no-tilt");
}

/// The left flank of the reference's helical gear: z 23, m_n 6, 20 and 25 degrees; `docs/mathematics/milling.md`.
struct Helical {
    base_radius: f64,
    base_space: f64,
    lead: f64,
    base_helix: f64,
    root_radius: f64,
    heights: [f64; 2],
}

/// A column of it: point of the guide curve, direction of that curve.
struct Column {
    c: Vector3<f64>,
    t: Vector3<f64>,
    normal: Vector3<f64>,
}

impl Helical {
    fn new() -> Self {
        let (normal_module, teeth, alpha, beta) = (6.0, 23.0, 20f64.to_radians(), 25f64.to_radians());
        let transverse = (alpha.tan() / beta.cos()).atan();
        let r = 0.5 * teeth * normal_module / beta.cos();
        let base_radius = r * transverse.cos();
        let roll = |radius: f64| (radius * radius - base_radius * base_radius).sqrt();
        Self {
            base_radius,
            base_space: PI / (2.0 * teeth) - (transverse.tan() - transverse),
            lead: beta.tan() / r,
            base_helix: (beta.tan() / r * base_radius).atan(),
            root_radius: r - 1.25 * normal_module,
            heights: [roll(71.5), roll(r + normal_module)],
        }
    }

    fn radial(angle: f64) -> Vector3<f64> {
        Vector3::new(angle.sin(), angle.cos(), 0.0)
    }

    fn around(angle: f64) -> Vector3<f64> {
        Vector3::new(angle.cos(), -angle.sin(), 0.0)
    }

    fn phi(&self, w: f64, z: f64) -> f64 {
        w / self.base_radius + self.base_space - self.lead * z
    }

    fn point(&self, w: f64, z: f64) -> Vector3<f64> {
        let phi = self.phi(w, z);
        Self::radial(phi) * self.base_radius - Self::around(phi) * w + Vector3::z() * z
    }

    fn normal(&self, w: f64, z: f64) -> Vector3<f64> {
        let (sin, cos) = self.base_helix.sin_cos();
        -(Self::around(self.phi(w, z)) * cos + Vector3::z() * sin)
    }

    fn along(&self, w: f64, z: f64) -> Vector3<f64> {
        let p = self.point(w, z);
        Vector3::new(-self.lead * p.y, self.lead * p.x, 1.0)
    }

    fn column(&self, u: f64) -> Column {
        let normal = Self::radial(-self.lead * u);
        let c = normal * self.root_radius + Vector3::z() * u;
        let t = Vector3::new(-self.lead * c.y, self.lead * c.x, 1.0).normalize();
        Column { c, t, normal }
    }

    /// b of a column's point of height w.
    fn length(&self, column: &Column, w: f64) -> f64 {
        let mut z = column.c.z;
        for _ in 0..60 {
            let step = (self.point(w, z) - column.c).dot(&column.t) / self.along(w, z).dot(&column.t);
            z -= step;
            if step.abs() < 1e-13 {
                break;
            }
        }
        z
    }

    /// The height in the middle of a column's arc.
    fn middle(&self) -> f64 {
        let column = self.column(0.0);
        let rate = |w: f64| {
            let z = self.length(&column, w);
            let up = Self::radial(self.phi(w, z)) * (w / self.base_radius);
            let along = self.along(w, z);
            (up - along * (up.dot(&column.t) / along.dot(&column.t))).norm()
        };
        let arc = |from: f64, to: f64| {
            let n = 200;
            let h = (to - from) / f64::from(n);
            let weight = |k: i32| if k == 0 || k == n { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
            (0..=n).map(|k| weight(k) * rate(from + h * f64::from(k))).sum::<f64>() * h / 3.0
        };
        let [low, high] = self.heights;
        let (mut a, mut b) = (low, high);
        for _ in 0..60 {
            let m = 0.5 * (a + b);
            if arc(low, m) < arc(m, high) { a = m } else { b = m }
        }
        0.5 * (a + b)
    }

    /// An end mill of radius 2.5 mm that touches 5 mm above its tip.
    fn place(&self, u: f64, w: f64) -> CutterPlace {
        let column = self.column(u);
        let z = self.length(&column, w);
        let (contact, n) = (self.point(w, z), self.normal(w, z));
        let across = n.cross(&column.t).normalize();
        let axis = if across.dot(&column.normal) > 0.0 { across } else { -across };
        place(contact, contact + n * 2.5 - axis * 5.0, axis)
    }
}

fn helical_row() -> (Machine, Vec<CutterPlace>) {
    let q = [[0.0; 3], [0.0, 0.0, -50.0]];
    let machine = chain("AC table", q, 0.0, [Some([-TAU, TAU]), Some([-PI, PI])]);
    let gear = Helical::new();
    let w = gear.middle();
    (machine, ROW.iter().map(|(u, ..)| gear.place(*u, w)).collect())
}

#[test]
fn feed_and_straight_blocks_of_the_helical_row() {
    let (machine, places) = helical_row();
    let setup = setup(&machine, 0.0);
    // The first place of the reference's CL text.
    let first = &places[0];
    assert!((first.tip.xyz - Vector3::new(5.20225, 73.13135, -9.83138)).amax() < 6e-6, "{:?}", first.tip);
    let course = slow(&setup, &places);
    for (at, (_, angles, xyz)) in course.nodes.iter().zip(&ROW) {
        let found = degrees_of(&setup, at);
        assert!((0..2).all(|k| (found[k] - angles[k]).abs() < 1e-7), "{found:?} {angles:?}");
        assert!((0..3).all(|k| (at[k] - xyz[k]).abs() < 1e-7), "{at:?} {xyz:?}");
    }
    let times = block_times(&setup, &course.places, &course.nodes, 1200.0).expect("times");
    for (k, (time, (seconds, tip_feed, inverse, middle))) in times.iter().zip(&BLOCKS).enumerate() {
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-7;
        assert!(near(time.seconds, *seconds) && near(time.tip_feed, *tip_feed), "{time:?}");
        assert!(near(time.inverse_time, *inverse) && time.limit.name() == "feed" && time.share == 1.0);
        let ends = [k, k + 1].map(|k| (&course.places[k], &course.nodes[k]));
        let off = straight_error(&setup, ends).expect("finite");
        assert!((off.middle - vector(*middle)).amax() < 1e-7, "{off:?}");
        assert!(off.tip >= off.middle.norm() && off.tip < 1.1 * off.middle.norm(), "{off:?}");
    }
}

#[test]
fn a_screw_row_is_one_block() {
    let (machine, places) = helical_row();
    let setup = setup(&machine, 0.0);
    let mut course = slow(&setup, &places);
    let runs = straight_runs(&setup, &course, 1e-9, 1e-12).expect("runs");
    assert_eq!((runs.len(), runs[0].from, runs[0].to), (1, 0, 8));
    assert!(runs[0].tip < 1e-12, "{:.1e}", runs[0].tip);
    // The same gear off the table's axis is no screw of its axes.
    let aside = setup.clamped(Pose::tx(30.0));
    assert_eq!(straight_runs(&aside, &slow(&aside, &places), 1e-9, 1e-12).expect("runs").len(), 8);
    // A place moved by a micrometre ends the block.
    course.nodes[4][0] += 1e-3;
    course.places[4].tip.xyz.x += 1e-3;
    let runs = straight_runs(&setup, &course, 1e-9, 1e-12).expect("runs");
    assert!(runs.len() > 1 && runs.iter().all(|run| run.tip <= 1e-9));
    assert_eq!(runs.iter().map(|run| run.to - run.from).sum::<usize>(), 8);
}

#[test]
fn an_axis_that_needs_longer_is_named() {
    let (machine, places) = helical_row();
    let setup = setup(&machine, 0.0);
    let course = slow(&setup, &places);
    // 0.877 degrees at 60 deg/s take 14.6 ms; the slides take 7.4 ms.
    let times = block_times(&setup, &course.places, &course.nodes, 50000.0).expect("times");
    for time in &times {
        assert_eq!(time.limit.name(), "C");
        assert!((time.seconds - 0.8773276356082198 / 60.0).abs() < 1e-9, "{}", time.seconds);
        assert!(time.share < 1.0 && (time.inverse_time * time.seconds - 60.0).abs() < 1e-12);
    }
    // Near the pole C slows the block by far.
    let mill = shipped_machine("ac-table");
    let near = milled(&mill);
    let course = slow(&near, &fan(NEAR_POLE.iter().map(|(axis, _)| vector(*axis))));
    let times = block_times(&near, &course.places, &course.nodes, 3000.0).expect("times");
    assert_eq!(times[5].limit.name(), "C");
    assert!((times[5].seconds - 68.1985905136482 / 360.0).abs() < 1e-9, "{}", times[5].seconds);
    let passages = pole_passages(&near, &course.places, DEFAULT_CAP).expect("finite");
    let sections = section_feeds(&times, &passages, 3000.0);
    // 1 mm of contact in that time.
    assert!((sections[0].feed - 60.0 * 360.0 / 68.1985905136482).abs() < 1e-6, "{sections:?}");
    assert_eq!((sections.len(), sections[0].limit.name()), (1, "C"));
    // Two places that are one; a feed that is none.
    let twice = [course.places[0], course.places[0]];
    let refused = block_times(&near, &twice, &[course.nodes[0]; 2], 1000.0).expect_err("no motion");
    assert_eq!((refused.code(), refused.to_string().contains("1 and 2")), ("no-motion", true));
    for feed in [0.0, -1.0, f64::NAN] {
        let refused = block_times(&near, &course.places, &course.nodes, feed).expect_err("no feed");
        assert_eq!(refused.code(), "invalid-number");
    }
}

/// Figures of the reference's `orientation_comparison`, helical case: column plane and clean parameter lines.
#[test]
fn smoothness_of_the_helical_row() {
    let machine = chain("AC table", [[0.0; 3]; 2], 0.0, [Some([-TAU, TAU]), Some([-PI, PI])]);
    let setup = setup(&machine, 0.0);
    let gear = Helical::new();
    let w = 0.5 * (gear.heights[0] + gear.heights[1]);
    let ends = [-28.026253718254928, 23.735680804209093];
    let column: Vec<CutterPlace> =
        (0..121).map(|k| gear.place(ends[0] + (ends[1] - ends[0]) * f64::from(k) / 120.0, w)).collect();
    let lines: Vec<CutterPlace> = column
        .iter()
        .map(|at| CutterPlace {
            axis: Direction::from_vector(Helical::radial(gear.phi(w, at.contact.xyz.z))),
            ..*at
        })
        .collect();
    let expected = [(column, 0.4870876259883487, 81.79871709145499), (lines, -8.454861406262681, 90.0)];
    for (places, lean, tilt) in expected {
        let course = slow(&setup, &places);
        let figures = smoothness(&setup, &course.places, &course.nodes);
        let [c, a] = figures.rotary;
        assert!((c.travel.to_degrees() - 18.164870251723126).abs() < 1e-6, "{}", c.travel.to_degrees());
        assert!((c.rate.to_degrees() / 0.3185708718825013 - 1.0).abs() < 1e-5);
        assert!(c.second < 1e-12 && a.travel < 1e-12 && a.reversals == 0 && c.reversals == 0);
        assert!((degrees_of(&setup, &course.nodes[0])[1] - tilt).abs() < 1e-6);
        assert!((figures.path - 57.01987173021908).abs() < 1e-6, "{}", figures.path);
        for found in figures.lean {
            assert!((found.to_degrees() - lean).abs() < 1e-4, "{} {lean}", found.to_degrees());
        }
    }
}

#[test]
fn changes_of_a_simple_row() {
    // th = s^2 at unequal steps: slopes at the middles, the second derivative at any steps.
    let s = [0.0, 1.0, 2.0, 4.0];
    let steps: Vec<f64> = s.windows(2).map(|p| p[1] - p[0]).collect();
    let square = Change::new(&s.map(|s: f64| s * s), &steps);
    assert_eq!((square.travel, square.rate, square.reversals), (16.0, 6.0, 0));
    assert!((square.second - 2.0).abs() < 1e-15, "{}", square.second);
    // To and fro; a step of rounding in between turns nothing back.
    let back = Change::new(&[0.0, 0.2, 0.2 - 1e-12, 0.3, 0.1], &[1.0; 4]);
    assert_eq!(back.reversals, 1);
    assert_eq!(Change::new(&[1.0], &[]), Change::default());
    // On a parabola the lean is exact at its ends too: chords of equal length are not needed.
    let axis = Vector3::x();
    let straight: Vec<_> =
        [0.0, 1.0, 5.0].map(|x| place(Vector3::new(x, x, 0.0), Vector3::zeros(), axis)).into();
    assert!(leans(&straight).iter().all(|lean| (lean - PI / 4.0).abs() < 1e-12));
    assert!(leans(&[]).is_empty());
    assert_eq!(leans(&straight[..1]), vec![0.0]);
}

#[test]
fn three_turns_on_two_turns_of_travel_need_a_rewind() {
    let machine = shipped_machine("head-head");
    let setup = setup(&machine, 100.0);
    let spiral = |turns: f64| {
        fan((0..=200).map(move |k| {
            let (sin, cos) = (TAU * turns * f64::from(k) / 200.0).sin_cos();
            Vector3::new(0.5 * cos, 0.5 * sin, 1.0)
        }))
    };
    let fits = slow(&setup, &spiral(1.7));
    assert!(fits.rewinds.is_empty() && fits.cost < TAU * 1.7 + 0.1, "{}", fits.cost);
    // From where its direction begins not even 1.9 turns are left to either end.
    assert!(!slow(&setup, &spiral(1.9)).rewinds.is_empty());
    let too_long = slow(&setup, &spiral(3.0));
    assert!(!too_long.rewinds.is_empty());
    for at in &too_long.nodes {
        let within = |(k, axis): (usize, &Axis)| axis.admits(at[k]);
        assert!(machine.axes().iter().enumerate().all(within));
    }
    // A table without ends does the same without.
    let endless = shipped_machine("ac-table");
    let course = slow(&milled(&endless), &spiral(3.0));
    assert!(course.rewinds.is_empty());
    let c = endless.axis_named("C").expect("C");
    assert!(((course.nodes[200][c] - course.nodes[0][c]).abs() - 3.0 * TAU).abs() < 1e-9);
    // A rewind is not refined; everything else is.
    let refined = refine(&setup, &too_long, 0.1, 0.01).expect("blocks");
    assert_eq!(refined.given.len(), 201);
}

#[test]
fn what_the_travel_does_not_hold_is_told_with_its_place() {
    let machine = shipped_machine("ac-table");
    let setup = setup(&machine, 100.0);
    let tilted = |deg: f64| Vector3::new(0.0, deg.to_radians().sin(), deg.to_radians().cos());
    let from = Positions::default();
    let refused = choose(&setup, &fan([tilted(20.0), tilted(150.0)]), &from, PoleStrategy::Slow)
        .expect_err("A ends at -120");
    let MotionError::Place { place: 2, error: MachineError::AxisLimit { axis, value, excess, from, to, .. } } =
        &refused
    else {
        panic!("{refused}");
    };
    assert!(axis == "A" && (from + 120.0).abs() < 1e-9 && (to - 30.0).abs() < 1e-9, "{refused}");
    assert!((value + 150.0).abs() < 1e-9 && (excess - 30.0).abs() < 1e-9, "{refused}");
    assert_eq!(refused.code(), "axis-limit");
    assert!(refused.way_out().contains('A'));
    // A slide.
    let far = [place(Vector3::zeros(), Vector3::new(0.0, 420.0, 0.0), Vector3::z())];
    let refused = choose(&setup, &far, &Positions::default(), PoleStrategy::Slow).expect_err("Y ends at 300");
    assert!(
        matches!(&refused, MotionError::Place { place: 1, error: MachineError::AxisLimit { axis, excess, .. } }
            if axis == "Y" && (excess - 120.0).abs() < 1e-9),
        "{refused}"
    );
    // A direction beyond the reach of the chain.
    let nutating = shipped_machine("nutating-table");
    let below = fan([Vector3::z(), Vector3::new(0.0, 0.6, -0.8)]);
    let refused = choose(&milled(&nutating), &below, &Positions::default(), PoleStrategy::Slow)
        .expect_err("beyond 90 degrees");
    assert_eq!((refused.code(), refused.to_string().contains("place 2")), ("unreachable", true));
    // A horizontal tool is the last one it reaches, however its direction is rounded.
    let level = fan((0..50).map(|k| Vector3::new(f64::from(k).sin(), f64::from(k).cos(), 0.0)));
    let course = slow(&milled(&nutating), &level);
    assert!(off(&milled(&nutating), &course, &level)[1] < 1e-12);
    // Numbers that are none, an axis that is no direction.
    for axis in [Vector3::new(f64::NAN, 0.0, 1.0), Vector3::new(0.0, 0.0, 2.0), Vector3::zeros()] {
        let bad = [place(Vector3::zeros(), Vector3::zeros(), axis)];
        let refused = choose(&setup, &bad, &Positions::default(), PoleStrategy::Slow).expect_err("bad");
        assert_eq!(refused.code(), "invalid-number");
    }
    assert_eq!(slow(&setup, &[]).nodes, vec![]);
}

/// Directions over the half above the table, as a product of proptest's numbers.
fn direction(tilt: f64, around: f64) -> Vector3<f64> {
    let (sin, cos) = tilt.to_radians().sin_cos();
    Vector3::new(sin * around.cos(), sin * around.sin(), cos)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    /// Forward of inverse is the identity and no travel is exceeded, whatever the path does near the pole.
    #[test]
    fn random_paths_on_all_machines(
        steps in prop::collection::vec((0.0..30.0f64, -4.0..4.0f64, prop::array::uniform3(-40.0..40.0f64)), 1..12),
        length in 20.0..150.0f64,
    ) {
        let places: Vec<CutterPlace> = steps
            .iter()
            .map(|(tilt, around, tip)| place(vector(*tip), vector(*tip), direction(*tilt, *around)))
            .collect();
        for machine in shipped() {
            let setup = setup(&machine, length);
            let course = slow(&setup, &places);
            let [tip, axis] = off(&setup, &course, &places);
            prop_assert!(tip < 1e-12 && axis < 1e-12, "{}: {tip:.1e} mm, {axis:.1e}", machine.name());
            for at in &course.nodes {
                let beyond = machine.axes().iter().enumerate().find(|(k, axis)| !axis.admits(at[*k]));
                prop_assert!(beyond.is_none(), "{}: {beyond:?}", machine.name());
            }
        }
    }

    /// No sequence of solutions and turns is cheaper than the one chosen.
    #[test]
    fn the_course_is_the_cheapest(
        steps in prop::collection::vec((5.0..90.0f64, -4.0..4.0f64), 2..5),
        c_end in 100.0..400.0f64,
        tilt_end in 95.0..170.0f64,
    ) {
        let travels = [c_end, tilt_end].map(|end| Some([-end.to_radians(), (end + 20.0).to_radians()]));
        let machine = chain("AC table", [[0.0; 3]; 2], 0.0, travels);
        let setup = setup(&machine, 0.0);
        let places = fan(steps.iter().map(|(tilt, around)| direction(*tilt, *around)));
        let mut ways: Vec<(Positions, f64)> = vec![(Positions::default(), 0.0)];
        for (k, at) in places.iter().enumerate() {
            let AxisSolutions::Positions(found) = setup.solutions(at).expect("in reach") else { panic!("no pole") };
            let turned = found.iter().flat_map(|solution| {
                (-3..=3).flat_map(move |m| (-3..=3).map(move |n| {
                    let mut at = *solution;
                    at[3] += TAU * f64::from(m);
                    at[4] += TAU * f64::from(n);
                    at
                }))
            });
            let allowed: Vec<Positions> =
                turned.filter(|at| machine.axes()[3].admits(at[3]) && machine.axes()[4].admits(at[4])).collect();
            let weight = if k == 0 { 1e-3 } else { 1.0 };
            ways = ways
                .iter()
                .flat_map(|(from, cost)| allowed.iter().map(move |at| {
                    (*at, cost + weight * ((at[3] - from[3]).abs() + (at[4] - from[4]).abs()))
                }))
                .collect();
        }
        let cheapest = ways.iter().map(|way| way.1).fold(f64::INFINITY, f64::min);
        match choose(&setup, &places, &Positions::default(), PoleStrategy::Slow) {
            Ok(course) => prop_assert!((course.cost - cheapest).abs() < 1e-10, "{} {cheapest}", course.cost),
            Err(error) => {
                prop_assert_eq!(error.code(), "axis-limit");
                prop_assert!(ways.is_empty());
            }
        }
    }

    /// The bound of a straight block holds everywhere on it, and so do the tolerances of a refined course.
    #[test]
    fn straight_blocks_keep_their_bounds(
        ends in prop::array::uniform2((5.0..60.0f64, prop::array::uniform3(-60.0..60.0f64))),
        around in -3.0..3.0f64,
        swing in -0.8..0.8f64,
        tolerance in 1e-3..1e-1f64,
    ) {
        let at = |(tilt, tip): (f64, [f64; 3]), around: f64| place(vector(tip), vector(tip), direction(tilt, around));
        let second = (ends[0].0 + 0.3 * ends[1].0, ends[1].1);
        let places = [at(ends[0], around), at(second, around + swing)];
        for machine in shipped() {
            let setup = setup(&machine, 80.0);
            let Ok(course) = choose(&setup, &places, &Positions::default(), PoleStrategy::Slow) else { continue };
            let worst = |ends: [(&CutterPlace, &Positions); 2]| {
                let mut worst = [0.0f64; 2];
                for k in 0..=50 {
                    let u = f64::from(k) / 50.0;
                    let mut between = Positions::default();
                    for k in 0..5 {
                        between[k] = ends[0].1[k] + u * (ends[1].1[k] - ends[0].1[k]);
                    }
                    let (tip, axis) = setup.stands(&between).expect("finite");
                    let wanted = ends[0].0.towards(ends[1].0, u);
                    worst[0] = worst[0].max((tip.xyz - wanted.tip.xyz).norm());
                    worst[1] = worst[1].max(axis.xyz.cross(&wanted.axis.xyz).norm().asin());
                }
                worst
            };
            let block = [(&course.places[0], &course.nodes[0]), (&course.places[1], &course.nodes[1])];
            let (told, found) = (straight_error(&setup, block).expect("finite"), worst(block));
            prop_assert!(found[0] <= told.tip + 1e-11 && found[1] <= told.axis + 1e-11, "{told:?} {found:?}");
            if !course.rewinds.is_empty() {
                continue;
            }
            let refined = refine(&setup, &course, tolerance, 0.1 * tolerance).expect("blocks");
            prop_assert_eq!(refined.given[1] + 1, refined.nodes.len());
            for k in 1..refined.nodes.len() {
                let ends = [k - 1, k].map(|k| (&refined.places[k], &refined.nodes[k]));
                let [tip, axis] = worst(ends);
                prop_assert!(tip <= tolerance + 1e-11 && axis <= 0.1 * tolerance + 1e-11, "{tip} {axis}");
            }
            prop_assert!(refined.tip <= tolerance && refined.axis <= 0.1 * tolerance);
        }
    }
}
