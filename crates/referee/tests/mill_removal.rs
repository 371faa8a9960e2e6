//! The referee of milling against closed forms, against dense sampling of the motion, and with input that is none.

use foundation::geometry::{Cutter, CutterShape, ShankStep, in_tool};
use foundation::numerics::Silent;
use nalgebra::Vector3;
use proptest::prelude::*;
use referee::{
    CutterPart, CutterPlace, MillPath, MilledRays, Milling, NormalRay, RemovalError, Unmilled, mill,
};

const STOCK: f64 = 1.0;
const DEPTH: f64 = 1.0;

fn v(x: f64, y: f64, z: f64) -> Vector3<f64> {
    Vector3::new(x, y, z)
}

fn cutter(shape: CutterShape) -> Cutter {
    Cutter::new(shape, 60.0, vec![]).expect("cutter")
}

fn path(places: &[(Vector3<f64>, Vector3<f64>)]) -> MillPath {
    let places = places.iter().map(|&(tip, axis)| CutterPlace { tip, axis: axis.normalize() }).collect();
    MillPath { cutter: 0, places }
}

fn milled(cutter: &Cutter, paths: &[MillPath], rays: &[NormalRay]) -> MilledRays {
    let cutters = std::slice::from_ref(cutter);
    mill(&Milling { cutters, paths, stock: STOCK, depth: DEPTH }, rays, &Silent).expect("usable")
}

/// The place at a fraction of a block, as `docs/mathematics/milling.md#the-referee` has it.
fn between(from: &CutterPlace, to: &CutterPlace, t: f64) -> CutterPlace {
    CutterPlace { tip: from.tip.lerp(&to.tip, t), axis: from.axis.lerp(&to.axis, t).normalize() }
}

/// The first entry of a ray into the whole cutter at one place, by steps of the distance alone; the stock where there is none.
fn entry(cutter: &Cutter, at: &CutterPlace, ray: &NormalRay) -> f64 {
    let mut length = -DEPTH;
    for _ in 0..2_000_000 {
        let [rho, z] = in_tool(&(ray.point + ray.normal * length), &at.tip, &at.axis);
        let d = cutter.distance(rho, z);
        if d < 1e-13 {
            return length;
        }
        length += d;
        if length > STOCK {
            return STOCK;
        }
    }
    length
}

/// The lowest entry that sampling every block finds, and sampling anew around each sample that is no higher than its
/// neighbours. It meets the ray at the place it names, so the true lowest entry is never higher.
fn brute_force(cutter: &Cutter, paths: &[MillPath], ray: &NormalRay, samples: usize) -> f64 {
    let mut best = STOCK;
    for ends in paths.iter().flat_map(|path| path.places.windows(2)) {
        let at = |t: f64| entry(cutter, &between(&ends[0], &ends[1], t), ray);
        let table: Vec<f64> = (0..=samples).map(|i| at(i as f64 / samples as f64)).collect();
        for i in 0..=samples {
            best = best.min(table[i]);
            let neighbours = [i.saturating_sub(1), (i + 1).min(samples)];
            if table[i] < STOCK && neighbours.iter().all(|&n| table[i] <= table[n]) {
                best = best.min(sampled_anew(&at, neighbours.map(|n| n as f64 / samples as f64)));
            }
        }
    }
    best
}

/// The lowest of ever denser samples between two places. A section (golden or other) would not do: beside a short cut the
/// entry is the stock everywhere, and of two equal values neither tells where the cut lies.
fn sampled_anew(f: &dyn Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    const STEPS: usize = 12;
    let mut best = STOCK;
    while high - low > 1e-9 {
        let at = |i: usize| low + (high - low) * i as f64 / STEPS as f64;
        let values: Vec<f64> = (0..=STEPS).map(|i| f(at(i))).collect();
        let lowest = (0..=STEPS).min_by(|&i, &j| values[i].total_cmp(&values[j])).expect("samples");
        best = best.min(values[lowest]);
        (low, high) = (at(lowest.saturating_sub(1)), at((lowest + 1).min(STEPS)));
    }
    best
}

/// Compares every ray with dense sampling; returns how many were cut. An entry that is found is proven by its place: it
/// may lie below the samples, which can miss a cut shorter than their distance, never above them.
fn compare(cutter: &Cutter, paths: &[MillPath], rays: &[NormalRay], samples: usize) -> usize {
    let result = milled(cutter, paths, rays);
    let mut cut = 0;
    for (ray, found) in rays.iter().zip(&result.rays) {
        let sampled = brute_force(cutter, paths, ray, samples);
        let entry_at = |path: usize, block: usize, fraction: f64| {
            let places = &paths[path].places;
            entry(cutter, &between(&places[block], &places[block + 1], fraction), ray)
        };
        match *found {
            Ok(found) => {
                cut += 1;
                assert!(found.length < sampled + 1e-9, "{ray:?}: {found:?}, sampled {sampled}");
                let at_its_place = entry_at(found.path, found.block, found.fraction);
                assert!((at_its_place - found.length).abs() < 1e-10, "{found:?}, but {at_its_place}");
            }
            Err(Unmilled::NotReached) => assert!(sampled > STOCK - 1e-9, "{ray:?} sampled {sampled}"),
            Err(Unmilled::TooDeep { path, block, fraction, .. }) => {
                assert_eq!(entry_at(path, block, fraction), -DEPTH, "{ray:?}");
            }
            Err(Unmilled::NotSettled) => panic!("{ray:?} did not settle, sampled {sampled}"),
        }
    }
    cut
}

#[test]
fn rows_of_a_ball_leave_their_scallop() {
    let (radius, distance) = (3.0f64, 1.0);
    let ball = cutter(CutterShape::ball(radius));
    let rows: Vec<MillPath> = (0..3)
        .map(|i| {
            let y = distance * f64::from(i);
            path(&[(v(-10.0, y, 0.0), Vector3::z()), (v(10.0, y, 0.0), Vector3::z())])
        })
        .collect();
    for i in 0..=80 {
        let y = distance * f64::from(i) / 40.0;
        let ray = NormalRay { point: v(0.37, y, 0.0), normal: Vector3::z() };
        let result = milled(&ball, &rows, &[ray]);
        let found = result.rays[0].expect("cut");
        let off = (y - distance * (y / distance).round()).abs();
        let exact = radius - (radius * radius - off * off).sqrt();
        assert!((found.length - exact).abs() < 1e-10, "{y}: {} {exact}", found.length);
        if off < 0.49 * distance {
            assert_eq!((found.path, found.block), ((y / distance).round() as usize, 0));
            assert!((found.fraction - (10.37 / 20.0)).abs() < 1e-4);
        }
    }
    let cusp = NormalRay { point: v(0.0, 0.5, 0.0), normal: Vector3::z() };
    let height = milled(&ball, &rows, &[cusp]).lengths().expect("cut")[0];
    assert!((height - (3.0 - 8.75f64.sqrt())).abs() < 1e-10);
}

#[test]
fn side_of_a_cylinder_on_a_plane_leaves_nothing_and_its_steps_are_named() {
    let steps = vec![ShankStep { radius: 2.7, from: 20.0 }];
    let cutter = Cutter::new(CutterShape::end_mill(2.5, 1.0), 12.0, steps).expect("cutter");
    // The plane y = 0, material below; the tool lies along z and moves along x.
    let paths = [path(&[(v(-5.0, 2.5, -3.0), Vector3::z()), (v(5.0, 2.5, -3.0), Vector3::z())])];
    let rays = [0.0, 7.0, 18.0, -2.5].map(|z| NormalRay { point: v(1.0, 0.0, z), normal: Vector3::y() });
    let found = milled(&cutter, &paths, &rays).rays;
    let lengths: Vec<f64> = found.iter().map(|ray| ray.expect("cut").length).collect();
    let corner = 1.0 - (1.0f64 - 0.25).sqrt();
    for (length, exact) in lengths.iter().zip([0.0, 0.0, -0.2, corner]) {
        assert!((length - exact).abs() < 1e-10, "{length} {exact}");
    }
    assert_eq!(found[0].expect("cut").part, CutterPart::Edges);
    assert_eq!(found[2].expect("cut").part, CutterPart::Shank(0));
}

/// `spur_exact_stock` of the reference: rows of a straight cutter on the flank of m 8, z 20, 20 deg; columns w, stock in um.
const SPUR_STOCK: [(f64, f64); 8] = [
    (12.245667185293279, 1.2281044993220205),
    (13.326309425730019, 5.21151978257715),
    (14.406951666166757, 1.5258677450397091),
    (17.648878387476973, 6.9985578050337764),
    (21.97144734922393, 8.785595827490404),
    (28.455300791844362, 0.0),
    (39.26172319621125, 15.933747917316907),
    (44.664934398395445, 4.652376441214962),
];

#[test]
fn rows_on_a_spur_flank_leave_the_closed_form() {
    let base_radius = 75.17540966287268;
    let rows: Vec<f64> = (0..9)
        .map(|i| 11.16502494485654 + f64::from(i) / 8.0 * (45.74557663883218 - 11.16502494485654))
        .collect();
    // s = +1, z-independent: e_r and u at the roll angle, normal -u, the axis along e_r tangent to the flank.
    let flank = |w: f64| {
        let phi: f64 = w / base_radius + 0.06363543247240838;
        let (e_r, u) = (v(phi.sin(), phi.cos(), 0.0), v(phi.cos(), -phi.sin(), 0.0));
        (e_r * base_radius - u * w, e_r, -u)
    };
    let end_mill = cutter(CutterShape::end_mill(3.0, 1.5));
    let paths: Vec<MillPath> = rows
        .iter()
        .map(|&w| {
            let (point, axis, normal) = flank(w);
            let tip = point + normal * 3.0 - axis * 6.16;
            path(&[-35.0, -11.0, 9.0, 35.0].map(|z| (tip + Vector3::z() * z, axis)))
        })
        .collect();
    let ray = |w: f64, z: f64| {
        let (point, _, normal) = flank(w);
        NormalRay { point: point + Vector3::z() * z, normal }
    };
    for z in [0.0, 3.1, -11.0] {
        let lengths = milled(&end_mill, &paths, &SPUR_STOCK.map(|(w, _)| ray(w, z))).lengths().expect("cut");
        for (length, (w, um)) in lengths.iter().zip(SPUR_STOCK) {
            assert!((length * 1e3 - um).abs() < 2e-7, "w = {w}: {} um, reference {um}", length * 1e3);
        }
    }
    for i in 0..=400 {
        let w = rows[0] + f64::from(i) / 400.0 * (rows[8] - rows[0]);
        let exact = rows
            .iter()
            .map(|w_i| {
                let d = (w - w_i) / base_radius;
                w_i * (1.0 / d.cos() - 1.0) + base_radius * (d.tan() - d)
            })
            .fold(f64::INFINITY, f64::min);
        let length = milled(&end_mill, &paths, &[ray(w, 0.4)]).lengths().expect("cut")[0];
        assert!((length - exact).abs() < 2e-10, "w = {w}: {length} {exact}");
    }
}

fn bodies() -> Vec<Cutter> {
    let shanks = vec![ShankStep { radius: 2.0, from: 9.0 }, ShankStep { radius: 6.0, from: 15.0 }];
    let cone = CutterShape::Conical { radius: 1.5, half_angle: 0.2, corner_radius: 0.6 };
    let sharp = CutterShape::Conical { radius: 2.0, half_angle: 0.1, corner_radius: 0.0 };
    vec![
        cutter(CutterShape::end_mill(2.5, 0.8)),
        cutter(CutterShape::end_mill(2.5, 0.0)),
        cutter(cone),
        cutter(sharp),
        cutter(CutterShape::Barrel { radius: 3.0, height: 8.0, profile_radius: 40.0 }),
        cutter(CutterShape::ball(2.0)),
        Cutter::new(CutterShape::end_mill(2.2, 1.0), 8.0, shanks).expect("cutter"),
    ]
}

#[test]
fn every_body_agrees_with_dense_sampling() {
    // A wavy path over the plane z = 0 with a leaning, turning axis.
    let place = |i: usize| {
        let s = i as f64;
        (
            v(1.7 * s - 4.0, (0.9 * s).sin(), 0.3 * (1.3 * s).cos() - 0.1),
            v(0.4 * (0.7 * s).sin(), 0.3 + 0.2 * s.cos(), 1.0),
        )
    };
    let paths = [path(&[0, 1, 2, 3, 4].map(place))];
    let mut rays = Vec::new();
    for i in 0..8 {
        for j in 0..5 {
            let (x, y) = (f64::from(i) - 3.7, 0.9 * f64::from(j) - 1.9);
            rays.push(NormalRay { point: v(x, y, 0.0), normal: v(0.1 * x, -0.05 * y, 1.0).normalize() });
        }
    }
    for (i, cutter) in bodies().iter().enumerate() {
        let cut = compare(cutter, &paths, &rays, 60);
        // The barrel goes on below its tip and covers the begin of most rays.
        assert!(cut >= 10 || i == 4, "body {i}: {cut} rays cut");
    }
}

#[test]
fn the_side_of_a_barrel_agrees_with_dense_sampling() {
    let barrel = cutter(CutterShape::Barrel { radius: 3.0, height: 8.0, profile_radius: 40.0 });
    let paths = [path(&[
        (v(-3.0, 3.0, -8.0), v(0.0, 0.05, 1.0)),
        (v(-1.0, 2.9, -8.0), v(0.1, -0.05, 1.0)),
        (v(2.0, 3.1, -7.0), v(-0.1, 0.0, 1.0)),
    ])];
    let rays: Vec<NormalRay> = (0..40)
        .map(|i| {
            let (x, z) = (0.8 * f64::from(i % 8) - 3.3, 1.1 * f64::from(i / 8) - 2.2);
            NormalRay { point: v(x, 0.0, z), normal: v(0.0, 1.0, 0.1 * z).normalize() }
        })
        .collect();
    assert!(compare(&barrel, &paths, &rays, 60) > 25);
}

#[test]
fn a_tool_that_turns_gouges_in_the_middle_of_its_block() {
    // Both ends touch the plane y = 0 with the side of the cutter 10 mm above the tip; the chord between them dips below it, by the
    // turn of the axis.
    let end_mill = cutter(CutterShape::end_mill(2.5, 0.5));
    let lean = |angle: f64| v(0.0, angle.sin(), angle.cos());
    let touching = |x: f64, angle: f64| {
        let axis = lean(angle);
        (v(x, 0.0, 0.0) + v(0.0, angle.cos(), -angle.sin()) * 2.5 - axis * 10.0, axis)
    };
    let paths = [path(&[touching(-1.0, -0.2), touching(1.0, 0.2)])];
    let ray = NormalRay { point: v(0.0, 0.0, 0.0), normal: Vector3::y() };
    let found = milled(&end_mill, &paths, &[ray]).rays[0].expect("cut");
    // In the middle the axis is upright; the tips of both ends stand at the same y = 2.5 cos 0.2 - 10 sin(+-0.2).
    let middle = 2.5 * 0.2f64.cos() - 2.5;
    assert!((found.length - middle).abs() < 1e-3 && found.length < -0.04, "{} {middle}", found.length);
    assert!((found.fraction - 0.5).abs() < 0.05, "{}", found.fraction);
    assert_eq!(compare(&end_mill, &paths, &[ray], 400), 1);
}

#[test]
fn two_dips_of_one_block_are_both_seen() {
    // The axis swings by 100 deg while the tip passes: the cutter meets the ray, leaves it and meets it again.
    let end_mill = cutter(CutterShape::end_mill(1.0, 0.2));
    let paths = [path(&[(v(-2.0, -0.4, 0.0), v(-1.0, 0.0, 0.6)), (v(2.0, 0.4, 0.0), v(1.0, 0.1, 0.6))])];
    let rays: Vec<NormalRay> = (0..30)
        .map(|i| NormalRay {
            point: v(0.3 * f64::from(i) - 4.5, 0.2, 0.4),
            normal: v(0.0, 0.2, 1.0).normalize(),
        })
        .collect();
    assert!(compare(&end_mill, &paths, &rays, 600) > 5);
}

#[test]
fn a_ray_that_leaves_the_cutter_below_the_flank_keeps_its_first_entry() {
    // A thin cutter crosses the ray wholly below the surface: the material above it does not count.
    let thin = cutter(CutterShape::end_mill(0.1, 0.05));
    let paths = [path(&[(v(-4.0, 0.0, -0.6), Vector3::x()), (v(-3.0, 0.0, -0.5), Vector3::x())])];
    let ray = NormalRay { point: v(0.0, 0.02, 0.0), normal: Vector3::z() };
    let exact = -0.6 - (0.01f64 - 0.0004).sqrt();
    let found = milled(&thin, &paths, &[ray]).rays[0].expect("cut");
    assert!((found.length - exact).abs() < 1e-10, "{} {exact}", found.length);
    assert_eq!(found.fraction, 0.0);
}

fn direction(tilt: f64, around: f64) -> Vector3<f64> {
    v(tilt.sin() * around.cos(), tilt.sin() * around.sin(), tilt.cos())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_blocks_agree_with_dense_sampling(
        body in 0usize..7,
        places in prop::collection::vec(
            (-4.0..4.0f64, -4.0..4.0f64, -0.5..1.0f64, 0.0..0.6f64, 0.0..6.3f64), 2..6),
        rays in prop::collection::vec((-3.0..3.0f64, -3.0..3.0f64, 0.0..0.5f64, 0.0..6.3f64), 1..5),
    ) {
        let places: Vec<_> =
            places.iter().map(|&(x, y, z, tilt, around)| (v(x, y, z), direction(tilt, around))).collect();
        let rays: Vec<NormalRay> = rays
            .iter()
            .map(|&(x, y, tilt, around)| NormalRay { point: v(x, y, 0.0), normal: direction(tilt, around) })
            .collect();
        compare(&bodies()[body], &[path(&places)], &rays, 150);
    }
}

/// Several rows over a cylinder along y of radius 50 mm, the axis turning with its normal.
fn rows_around(count: usize) -> Vec<MillPath> {
    let row = |y: f64| {
        path(&std::array::from_fn::<_, 30, _>(|i| {
            let angle = 0.02 * (i as f64 - 14.5);
            (v(50.0 * angle.sin(), y, 50.0 * angle.cos() - 50.0), v(angle.sin(), 0.1, angle.cos()))
        }))
    };
    (0..count).map(|i| row(0.7 * i as f64)).collect()
}

fn rays_around() -> Vec<NormalRay> {
    (0..400)
        .map(|i| {
            let (angle, y) = (0.02 * (f64::from(i % 20) - 9.3), 0.3 * f64::from(i / 20));
            let normal = v(angle.sin(), 0.0, angle.cos());
            NormalRay { point: normal * 50.0 + v(0.0, y, -50.0), normal }
        })
        .collect()
}

#[test]
fn threads_do_not_change_a_bit() {
    let torus = cutter(CutterShape::end_mill(2.5, 1.0));
    let (paths, rays) = (rows_around(9), rays_around());
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| milled(&torus, &paths, &rays))
    };
    let (one, two) = (run(1), run(2));
    assert_eq!(one, two);
    let bits = |all: &MilledRays| all.lengths().expect("cut").iter().map(|l| l.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&one), bits(&two));
    assert_eq!((one.statistics.rays, one.statistics.blocks), (400, 9 * 29));
    // The tree rules out nearly all of the pairs.
    assert!(one.statistics.searched < 400 * 9 * 29 / 4, "{:?}", one.statistics);
    assert!(one.error_um < 1e-6);
}

#[test]
fn paths_are_not_joined_and_a_ray_without_a_cut_says_so() {
    let ball = cutter(CutterShape::ball(2.0));
    let standing = |x: f64| path(&[(v(x, 0.0, 0.0), Vector3::z())]);
    let ray = |x: f64| NormalRay { point: v(x, 0.0, 0.0), normal: Vector3::z() };
    let result = milled(&ball, &[standing(-5.0), standing(5.0)], &[ray(0.0), ray(-5.0), ray(5.5)]);
    assert_eq!(result.rays[0], Err(Unmilled::NotReached));
    assert_eq!(result.rays[1].map(|r| (r.path, r.block, r.fraction)), Ok((0, 0, 0.5)));
    assert_eq!(result.rays[2].map(|r| r.path), Ok(1));
    let error = result.lengths().expect_err("one has no length");
    assert_eq!(error, RemovalError::RayNotMilled { index: 0, reason: Unmilled::NotReached, count: 1 });
    assert_eq!(error.code(), "ray-not-milled");
    // Joined, the middle is cut.
    let joined = path(&[(v(-5.0, 0.0, 0.0), Vector3::z()), (v(5.0, 0.0, 0.0), Vector3::z())]);
    assert!(milled(&ball, &[joined], &[ray(0.0)]).lengths().expect("cut")[0].abs() < 1e-10);
    // Sunk below the begin of the ray.
    let sunk = path(&[(v(0.0, 0.0, -1.5), Vector3::z())]);
    let deep = milled(&ball, &[standing(0.0), sunk], &[ray(0.0)]).rays[0].expect_err("too deep");
    assert!(matches!(deep, Unmilled::TooDeep { path: 1, block: 0, part: CutterPart::Edges, .. }), "{deep:?}");
}

#[test]
fn each_path_has_its_own_cutter() {
    let cutters = [cutter(CutterShape::ball(2.0)), cutter(CutterShape::end_mill(3.0, 0.0))];
    let mut second = path(&[(v(9.0, 0.0, 0.25), Vector3::z()), (v(12.0, 0.0, 0.25), Vector3::z())]);
    second.cutter = 1;
    let first = path(&[(v(-1.0, 0.0, 0.0), Vector3::z()), (v(1.0, 0.0, 0.0), Vector3::z())]);
    let rays = [0.5, 10.0].map(|x| NormalRay { point: v(x, 0.0, 0.0), normal: Vector3::z() });
    let setup = Milling { cutters: &cutters, paths: &[first, second], stock: STOCK, depth: DEPTH };
    let lengths = mill(&setup, &rays, &Silent).expect("usable").lengths().expect("cut");
    assert!(lengths[0].abs() < 1e-10 && (lengths[1] - 0.25).abs() < 1e-10, "{lengths:?}");
}

#[test]
fn unusable_input_is_named() {
    let cutters = [cutter(CutterShape::ball(2.0))];
    let good = path(&[(v(0.0, 0.0, 0.0), Vector3::z()), (v(1.0, 0.0, 0.0), Vector3::z())]);
    let ray = NormalRay { point: v(0.0, 0.0, 0.0), normal: Vector3::z() };
    let code = |paths: &[MillPath], ray: NormalRay, stock: f64, depth: f64| {
        let error = mill(&Milling { cutters: &cutters, paths, stock, depth }, &[ray], &Silent);
        let error = error.expect_err("unusable");
        assert!(!error.way_out().is_empty());
        error.code()
    };
    let with = |places: Vec<CutterPlace>| vec![good.clone(), MillPath { cutter: 0, places }];
    let at = |tip, axis| CutterPlace { tip, axis };
    assert_eq!(code(&[], ray, 1.0, 1.0), "empty-milling-path");
    assert_eq!(code(&with(vec![]), ray, 1.0, 1.0), "empty-milling-path");
    assert_eq!(code(&[MillPath { cutter: 1, ..good.clone() }], ray, 1.0, 1.0), "unknown-cutter");
    let nowhere = with(vec![at(v(0.0, f64::NAN, 0.0), Vector3::z())]);
    assert_eq!(code(&nowhere, ray, 1.0, 1.0), "invalid-cutter-place");
    let long = with(vec![at(v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.1))]);
    assert_eq!(code(&long, ray, 1.0, 1.0), "invalid-cutter-place");
    let nan_axis = with(vec![at(v(0.0, 0.0, 0.0), v(0.0, 0.0, f64::NAN))]);
    assert_eq!(code(&nan_axis, ray, 1.0, 1.0), "invalid-cutter-place");
    let back = with(vec![at(v(0.0, 0.0, 0.0), Vector3::z()), at(v(0.0, 0.0, 1.0), -Vector3::z())]);
    assert_eq!(code(&back, ray, 1.0, 1.0), "axis-turns-back");
    let good = [good];
    let no_normal = NormalRay { normal: v(0.0, 0.0, 0.0), ..ray };
    assert_eq!(code(&good, no_normal, 1.0, 1.0), "invalid-ray");
    let no_point = NormalRay { point: v(f64::INFINITY, 0.0, 0.0), ..ray };
    assert_eq!(code(&good, no_point, 1.0, 1.0), "invalid-ray");
    assert_eq!(code(&good, ray, f64::NAN, 1.0), "invalid-number");
    assert_eq!(code(&good, ray, 1.0, 0.0), "invalid-number");
    let none = mill(&Milling { cutters: &cutters, paths: &good, stock: 1.0, depth: 1.0 }, &[], &Silent);
    assert!(none.expect("no ray is no error").rays.is_empty());
}
