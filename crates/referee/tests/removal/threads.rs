//! Any number of threads gives the same bits.

use super::setups::{area, dressing_cases, feeds, field, meshing};
use dressing::dressing_motion;
use foundation::geometry::Flank;
use foundation::kinematics::MotionLaw;
use foundation::numerics::{Polynomial2, Silent};
use referee::{ActiveThreads, Dressing, Grinding, GrindingMode, RayGrid, dress, grind};

fn with_threads<R: Send>(count: usize, work: impl FnOnce() -> R + Send) -> R {
    rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap().install(work)
}

#[test]
fn dressing_does_not_depend_on_the_threads() {
    let case = &dressing_cases()[0];
    let motion = dressing_motion(case.tool.flanks.left.chain, &case.corrections);
    let grid = RayGrid::equidistant([case.range.w_nf, case.range.w_na], 13, [-15.0, 15.0], 17).unwrap();
    let setup = Dressing {
        worm: case.worm.flank(Flank::Left),
        dresser: &case.tool.flanks.left.profile,
        motion: &motion,
        shift_range: [-35.0, 35.0],
        stock: 0.2,
    };
    let run = |threads| with_threads(threads, || dress(&setup, &grid, &Silent).unwrap());
    assert_eq!(run(1), run(2));
}

#[test]
fn grinding_does_not_depend_on_the_threads() {
    let pair = meshing(25, 2.0, 20.0, 20.0, 2, 120.0);
    let motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, 0.7]));
    let flank = Flank::Right;
    let grid = field(&pair.work, flank, 11, 16.0, 13);
    let area = area(&pair, flank, &grid, &motion, [3.0, 6.0]);
    let bump = Polynomial2::from_terms([(0, 2, 2e-5), (1, 1, 1e-5)]).shifted(-area.w[0], 0.0);
    for mode in [GrindingMode::Continuous, GrindingMode::FeedMarks { feed_per_revolution: 0.3, start: 0.1 }] {
        let setup = Grinding {
            worm: pair.worm.flank(flank),
            area,
            modification: &bump,
            work: pair.work.flank(flank),
            motion: &motion,
            feed_range: feeds(&pair, flank, &grid, &motion, 4.0),
            stock: 0.2,
            threads: ActiveThreads::All,
            mode,
        };
        let run = |threads| with_threads(threads, || grind(&setup, &grid, &Silent).unwrap());
        let one = run(1);
        assert!(one.rays.iter().all(Result::is_ok));
        assert_eq!(one, run(2));
    }
}
