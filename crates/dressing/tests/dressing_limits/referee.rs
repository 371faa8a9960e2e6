//! The clearance against the rays of the referee: the flank across is dressed by the opposite flank where the land puts it.

use super::setup::{Choice, section};
use dressing::{DressedProfile, DresserSection, DresserTool, SectionPart};
use foundation::geometry::Flank;
use foundation::kinematics::{DressingCorrection, DressingMotion};
use foundation::numerics::Silent;
use referee::{Dressing, RayGrid, dress};

/// The correction that puts the opposite flank of the dresser where a section with this land has it. A shift by delta along the
/// dresser's axis is one of the offset, and the rest along the worm's axis a turn of the worm.
fn moved(
    tool: &DresserTool,
    section: &DresserSection<'_>,
    land: f64,
    dk: &DressingCorrection,
) -> DressingCorrection {
    let profile = &tool.flanks[section.flank().other()].profile;
    let [_, z] = section.point(SectionPart::CounterFlank, 1.0, land).unwrap();
    let delta = z - profile.at(profile.interval().1).z;
    let chain = tool.flanks[section.flank()].chain;
    let (sin, cos) = (chain.crossing_angle + dk[1]).sin_cos();
    [dk[0] + delta / (chain.screw_parameter * cos), dk[1], dk[2], dk[3] - delta * sin / cos]
}

#[test]
fn rays_of_the_flank_across_are_shortened_to_the_clearance() {
    let shapes = [
        (5, 100.0, [17.5, 17.5], 1.0, 123.0),
        (3, 200.0, [20.0, 15.0], -1.0, 90.0),
        (1, 130.0, [16.0, 21.0], 1.0, 180.0),
        (7, 80.0, [20.0, 20.0], -1.0, 60.0),
    ];
    for (threads, diameter, angles, hand, dresser) in shapes {
        let choice = Choice { threads, diameter, angles, hand, dresser, cone: 0.0 };
        let tool = choice.tool();
        for flank in Flank::BOTH {
            // The dresser leans and comes deeper, so that the opposite flank is the first to touch.
            let dk = [0.0, 0.012 * hand, -0.02, 0.6];
            let section = section(&tool, flank, &choice).unwrap();
            let limit = 0.06;
            let land = section.largest_tip_land(&dk, limit, 0.into()).unwrap().unwrap();
            let land = if land == section.full_land() { 0.99 * land } else { land };
            let least = section.counter_flank(&dk, land, 0.into()).unwrap().unwrap();
            assert_eq!(least.part, SectionPart::CounterFlank, "{choice:?} {flank} {least:?}");
            let across = &tool.flanks[flank.other()];
            let at = moved(&tool, &section, land, &dk);
            let range = across.range;
            let shift = DressedProfile::new(&tool, flank.other(), at).at_roll(range.middle()).unwrap().b;
            // The motion that dresses one flank leaves the same clearance everywhere along the worm.
            let motion = DressingMotion::constant(tool.flanks[flank].chain, at);
            let grid = RayGrid::equidistant([range.w_nf, range.w_na], 33, [-1.0, 1.0], 3).unwrap();
            let setup = Dressing {
                worm: &across.worm,
                dresser: &across.profile,
                motion: &motion,
                shift_range: [shift - 15.0, shift + 15.0],
                stock: least.f + 0.3,
            };
            let rays = dress(&setup, &grid, &Silent).unwrap().rays;
            let shortest = rays.iter().flatten().map(|ray| ray.f).fold(f64::INFINITY, f64::min);
            assert!(
                (shortest - least.f).abs() < 2e-4,
                "{choice:?} {flank}: rays {shortest}, section {least:?}, land {land}"
            );
        }
    }
}
