//! A gear as a closed mesh: involute flanks as they are drawn, tip and root as arcs, a bore for the eye; a worm by its threads. Knows
//! no motion.

use super::threaded::threaded;
use super::toothed::{BORE, LEAST_FILLET, Radii, Toothed, circle, roll};
use crate::mesh::{MeshError, Section, TriangleMesh, swept};
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Points of a flank from root to tip: at most, and of a gear with hundreds of teeth.
const PROFILE: [usize; 2] = [4, 10];
/// Points between a flank's begin and the root.
const FILLET: usize = 3;
/// Sections at least.
const SECTIONS: usize = 13;
/// Sections of a gear with more teeth than the triangles suffice for.
const LEAST_SECTIONS: usize = 5;
/// Turn from section to section, and from point to point of an arc, at most: 5 deg and 6 deg.
const TWIST: f64 = TAU / 72.0;
const ARC: f64 = TAU / 60.0;
/// Triangles of the walls at most, where the sections that are needed at least allow it.
const MOST_TRIANGLES: usize = 56_000;
/// Corners of the bore, and its radius as a share of the least root radius.
const BORE_CORNERS: usize = 30;
/// Teeth that lean more than this are threads: 45 deg.
const STEEP: f64 = TAU / 8.0;
/// How a fillet is drawn: its width as a share of its height, at most this share of half the space.
const FILLET_WIDTH: f64 = 0.6;
const FILLET_SHARE: f64 = 0.6;

/// Points of the parts of a section.
#[derive(Clone, Copy)]
struct Counts {
    profile: usize,
    fillet: usize,
    root: usize,
    tip: usize,
}

impl Toothed<'_> {
    /// The body.
    ///
    /// # Errors
    /// [`MeshError`] for one that cannot be: pointed teeth, no material.
    pub fn mesh(&self) -> Result<TriangleMesh, MeshError> {
        if self.gear.data().helix_angle.abs() > STEEP {
            return threaded(self);
        }
        let spaces = self.gear.tooth_count() as usize;
        let [from, to] = self.faces;
        let counts = self.counts(0.5 * (from + to));
        let per_section =
            spaces * (2 * (counts.profile + counts.fillet) + counts.root + counts.tip) + BORE_CORNERS;
        let twist =
            Flank::BOTH.map(|f| self.gear.flank(f).twist_per_length().abs()).into_iter().fold(0.0, f64::max);
        let wanted = SECTIONS.max((twist * (to - from) / TWIST).ceil() as usize + 1);
        let sections = wanted.min(MOST_TRIANGLES / (2 * per_section) + 1).max(LEAST_SECTIONS);
        let ends = [from, to].map(|z| self.radii(z).root);
        let bore = BORE * ends[0].min(ends[1]);
        let made: Vec<Section> = equidistant(self.faces, sections)
            .into_iter()
            .map(|z| Section {
                outline: self.outline(z, spaces, counts),
                holes: vec![circle(bore, z, BORE_CORNERS)],
            })
            .collect();
        swept(&made)
    }

    /// Points of the parts, from the section in the middle.
    fn counts(&self, z: f64) -> Counts {
        let Radii { tip, start, root } = self.radii(z);
        let pitch = TAU / self.gear.tooth_count();
        let inner = |angle: f64| (angle / ARC).ceil().clamp(1.0, 60.0) as usize;
        let fillet = if start > root { FILLET } else { 0 };
        let (root, tip) = (inner(self.space(start, z)), inner(pitch - self.space(tip, z)));
        // What a tooth may have, so that the least number of sections suffices for a smooth gear.
        let affordable = MOST_TRIANGLES as f64 / (2.0 * SECTIONS as f64 * self.gear.tooth_count());
        let profile = (affordable as usize).saturating_sub(2 * fillet + root + tip) / 2;
        Counts { profile: profile.clamp(PROFILE[0], PROFILE[1]), fillet, root, tip }
    }

    /// All teeth of a section, one space after the other.
    fn outline(&self, z: f64, spaces: usize, counts: Counts) -> Vec<Vector3<f64>> {
        let Radii { tip, mut start, root } = self.radii(z);
        if counts.fillet > 0 {
            start = start.max(root + LEAST_FILLET * self.gear.data().normal_module);
        }
        let pitch = TAU / spaces as f64;
        let side = |flank: Flank| -> Vec<(f64, f64)> {
            let [from, to] = [start, tip].map(|radius| roll(self.gear, flank, radius));
            let f = self.gear.flank(flank);
            let place = |w: f64| {
                let radius = f.radius(w);
                (radius, self.polar(flank, radius, z))
            };
            equidistant([from, to], counts.profile).into_iter().map(place).collect()
        };
        let (left, right) = (side(Flank::Left), side(Flank::Right));
        let ends = [left[0].1, right[0].1];
        let middle = 0.5 * (ends[0] + ends[1]);
        let half = 0.5 * (ends[0] - ends[1]);
        let height = start - root;
        let width = (FILLET_WIDTH * height / root).min(FILLET_SHARE * half);
        // A quarter of an ellipse from the flank down to the root.
        let fillet = |sense: f64, k: usize| {
            let (sin, cos) = (FRAC_PI_2 * (k + 1) as f64 / counts.fillet as f64).sin_cos();
            (start - height * sin, middle + sense * (half - width * (1.0 - cos)))
        };
        let deepest = if counts.fillet > 0 { half - width } else { half };
        let mut space: Vec<(f64, f64)> = left.iter().rev().copied().collect();
        space.extend((0..counts.fillet).map(|k| fillet(1.0, k)));
        let floor = if counts.fillet > 0 { root } else { start };
        space.extend((0..counts.root).map(|k| {
            let share = (k + 1) as f64 / (counts.root + 1) as f64;
            (floor, middle + deepest * (1.0 - 2.0 * share))
        }));
        space.extend((0..counts.fillet).rev().map(|k| fillet(-1.0, k)));
        space.extend(right.iter().copied());
        // The land up to the next space, which lies on the side of the right flank.
        let (last, next) = (right[counts.profile - 1].1, left[counts.profile - 1].1 - pitch);
        space.extend((0..counts.tip).map(|k| {
            let share = (k + 1) as f64 / (counts.tip + 1) as f64;
            (tip, last + share * (next - last))
        }));
        let of_space = |k: usize| {
            let turn = pitch * k as f64;
            space.iter().map(move |&(radius, angle)| {
                let (sin, cos) = (angle - turn).sin_cos();
                Vector3::new(radius * sin, radius * cos, z)
            })
        };
        (0..spaces).flat_map(of_space).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::{Gear, GearData, Sides};

    fn gear(teeth: i32, helix_deg: f64, cone_deg: f64) -> Gear {
        Gear::new(GearData {
            teeth,
            normal_module: 3.0,
            pressure_angle: Sides::both(20f64.to_radians()),
            helix_angle: helix_deg.to_radians(),
            profile_shift: 0.1,
            cone_angle: cone_deg.to_radians(),
        })
        .unwrap()
    }

    fn body(gear: &Gear, addendum: f64, dedendum: f64, length: f64) -> Toothed<'_> {
        let pitch = gear.pitch_radius();
        let root = pitch - dedendum;
        Toothed { gear, tip: pitch + addendum, root, form: root + 0.4, faces: [-0.4 * length, 0.6 * length] }
    }

    #[test]
    fn gears_of_any_number_of_teeth_are_closed_bodies() {
        for teeth in [5, 7, 19, 60, 150, 300] {
            for (helix, cone) in [(0.0, 0.0), (-30.0, 0.0), (17.0, 4.0)] {
                let gear = gear(teeth, helix, cone);
                let mesh = body(&gear, 3.3, 3.4, 25.0).mesh().unwrap();
                assert!(mesh.triangles.len() < 62_000, "{teeth}: {}", mesh.triangles.len());
            }
        }
    }

    #[test]
    fn worms_of_both_hands_are_closed_bodies_on_their_threads() {
        for (threads, helix, cone, length) in [
            (1, 88.0, 0.0, 160.0),
            (3, -86.0, 0.0, 90.0),
            (7, 80.0, 0.0, 40.0),
            (2, -87.0, 3.0, 70.0),
            (1, 89.0, -4.0, 30.0),
        ] {
            let gear = gear(threads, helix, cone);
            let worm = Toothed { form: gear.pitch_radius() - 3.7, ..body(&gear, 3.0, 3.7, length) };
            let mesh = worm.mesh().unwrap();
            assert!(mesh.triangles.len() < 62_000, "{threads}: {}", mesh.triangles.len());
            let off = |point: &Vector3<f64>| {
                let [l, r] = Flank::BOTH.map(|flank| gear.flank(flank).deviation(point).f_n.abs());
                l.min(r)
            };
            let between = |p: &&Vector3<f64>| {
                let Radii { tip, root, .. } = worm.radii(p.z);
                (root + 1e-6..tip - 1e-6).contains(&p.xy().norm())
            };
            let on_threads: Vec<f64> = mesh
                .vertices
                .iter()
                .filter(between)
                .filter(|p| p.xy().norm() > 0.6 * worm.root)
                .map(off)
                .collect();
            assert!(on_threads.len() > 1000, "{threads}: {}", on_threads.len());
            assert!(
                on_threads.iter().all(|off| *off < 1e-8),
                "{threads}: {:?}",
                on_threads.iter().copied().fold(0.0, f64::max)
            );
        }
    }

    #[test]
    fn teeth_and_spaces_that_run_to_a_point_are_cut_before() {
        let gear = gear(12, 10.0, 0.0);
        let mesh = body(&gear, 7.5, 3.0, 20.0).mesh().unwrap();
        let reach = mesh.vertices.iter().map(|p| p.xy().norm()).fold(0.0, f64::max);
        assert!(reach < gear.pitch_radius() + 7.0 && reach > gear.pitch_radius() + 2.0, "{reach}");
        body(&gear, 3.0, 9.0, 20.0).mesh().unwrap();
    }
}
