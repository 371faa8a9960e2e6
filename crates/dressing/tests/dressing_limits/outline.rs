//! The section as a picture shows it: the flanks are the worm's, and the boundary of the dresser is as far from them as the
//! clearances say.

use super::setup::{Choice, section};
use dressing::{SectionOutline, SectionPart, ShownWorm};
use foundation::geometry::{Flank, Sides};

/// The outline of an example with a land of 1 mm, in which the opposite flank collides on left flanks.
fn outline(choice: &Choice, flank: Flank, left_out: u32) -> SectionOutline {
    let tool = choice.tool();
    let section = section(&tool, flank, choice).unwrap();
    let radius = 0.5 * choice.diameter;
    let shown = ShownWorm {
        flanks: Sides::from_fn(|flank| choice.flank(flank)),
        left_out,
        radii: [radius - 4.3, radius + 3.2],
        b: 0.0,
    };
    section.outline(&[-0.061, -0.108 * choice.hand, -2.7, 11.7], 1.0, &shown).unwrap()
}

/// Axial position of a line at a radius.
fn at_radius(line: &[[f64; 2]], radius: f64) -> Option<f64> {
    line.windows(2).find_map(|pair| {
        let ([x_0, r_0], [x_1, r_1]) = (pair[0], pair[1]);
        let share = (radius - r_0) / (r_1 - r_0);
        (0.0..=1.0).contains(&share).then_some(x_0 + share * (x_1 - x_0))
    })
}

#[test]
fn distances_in_the_plane_are_the_clearances() {
    for hand in [1.0, -1.0] {
        let choice = Choice { hand, ..Choice::EXAMPLE };
        for flank in Flank::BOTH {
            let shown = outline(&choice, flank, 0);
            for (side, at) in shown.closest.iter() {
                let (clearance, [dresser, foot]) = at.unwrap();
                let worm = choice.flank(side);
                let (sin, cos) = worm.flank.base_helix_angle.sin_cos();
                // Both ends of the ray lie where they should, and are its length apart.
                let on_flank = at_radius(&shown.space[side], foot[1]).unwrap();
                assert!((on_flank - foot[0]).abs() < 1e-4, "{foot:?} {on_flank}");
                assert!((worm.flank.radius(clearance.w) - foot[1]).abs() < 1e-9);
                let root = |r: f64| (r * r - worm.flank.base_radius.powi(2)).sqrt();
                assert!((root(dresser[1]) - root(foot[1]) - clearance.f * cos).abs() < 1e-9);
                // No point of the boundary is nearer than the least clearance, and one is as near.
                let outward = if shown.space[side][0][0] > 0.0 { 1.0 } else { -1.0 };
                let mut least = f64::INFINITY;
                for (_, line) in &shown.dresser {
                    for point in line {
                        let Some(there) = at_radius(&shown.space[side], point[1]) else { continue };
                        let f = outward * (there - point[0]) * sin.abs();
                        let w = root(point[1]) - f * cos;
                        if w >= worm.range.w_nf && w <= worm.range.w_na {
                            least = least.min(f);
                        }
                    }
                }
                assert!((least - clearance.f).abs() < 0.03, "{hand} {flank} {side}: {least} {clearance:?}");
            }
        }
    }
}

#[test]
fn the_boundary_runs_around_the_tip() {
    let shown = outline(&Choice::EXAMPLE, Flank::Left, 0);
    let parts: Vec<SectionPart> = shown.dresser.iter().map(|(part, _)| *part).collect();
    let mut wanted = SectionPart::ALL.to_vec();
    if parts[0] != SectionPart::ActiveFlank {
        wanted.reverse();
    }
    assert_eq!(parts, wanted);
    let points: Vec<[f64; 2]> = shown.dresser.iter().flat_map(|(_, line)| line.clone()).collect();
    let jump = points.windows(2).map(|p| (p[0][0] - p[1][0]).hypot(p[0][1] - p[1][1])).fold(0.0, f64::max);
    assert!(jump < 0.6, "{jump}");
    // The land is as wide as it is, up to the lead that the tilted disc has against the worm.
    let land: Vec<f64> = shown
        .dresser
        .iter()
        .filter(|(part, _)| *part == SectionPart::TipLand)
        .flat_map(|(_, line)| line.iter().map(|p| p[0]))
        .collect();
    let width = land.iter().fold(f64::MIN, |m, x| m.max(*x)) - land.iter().fold(f64::MAX, |m, x| m.min(*x));
    assert!((0.95..1.8).contains(&width), "{width}");
    // The space stands in the middle; a inactive thread widens it by an axial pitch.
    let wide = outline(&Choice::EXAMPLE, Flank::Left, 1);
    let gap = |shown: &SectionOutline| (shown.space.left[80][0] - shown.space.right[80][0]).abs();
    let worm = Choice::EXAMPLE.worm();
    let pitch = 2.0 * std::f64::consts::PI * worm.screw_parameter(Flank::Left).abs() / worm.tooth_count();
    assert!((gap(&wide) - gap(&shown) - pitch).abs() < 1e-9);
    assert!((shown.space.left[80][0] + shown.space.right[80][0]).abs() < 1e-9);
}
