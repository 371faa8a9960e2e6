//! Worms whose flanks are no involute helicoids: straight in the axial section (ZA), in the normal section of the space (ZN), or made by a disc
//! with straight sides (ZK). Each is a screw surface of the same lead; here is its distance from the involute worm of equal lead, pressure
//! angle and thickness at the pitch cylinder, over the length of roll (`docs/mathematics/dressing.md#worms-that-are-no-involutes`).

use super::{DresserAxes, DressingError, WormScrew, touch};
use foundation::geometry::{Flank, Gear, InvoluteFlank, MeridianPoint};
use foundation::numerics::{brent, gradient_of, variables};
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// Form of a worm's flanks, by the letters of ISO 10828.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WormForm {
    /// ZA: straight in the axial section.
    Axial,
    /// ZN: straight in the normal section of the space.
    Normal,
    /// ZK: the envelope of a disc with straight sides that stands in the space under the lead angle.
    Disc {
        /// Diameter of the disc where it touches the worm's pitch cylinder, mm.
        diameter: f64,
    },
}

/// A curve that the screw of the worm carries over its flank: parameter from the pitch cylinder on, mm, and an offset that settles the
/// thickness, mm.
enum Generator {
    Line { through: Vector3<f64>, across: Vector3<f64>, along: Vector3<f64> },
    Disc { axes: DresserAxes<f64>, screw: f64, radius: f64, slope: f64, side: f64 },
}

impl Generator {
    fn point(&self, u: f64, offset: f64) -> Option<Vector3<f64>> {
        match self {
            Self::Line { through, across, along } => Some(through + across * offset + along * u),
            Self::Disc { axes, screw, radius, slope, side } => {
                // Heights on the disc run against the radius of the worm.
                let s = -u;
                let length = slope.hypot(1.0);
                let meridian = MeridianPoint {
                    r: radius + s,
                    z: side * (offset - s * slope),
                    n_r: slope / length,
                    n_z: side / length,
                };
                let contact = touch(&meridian, axes, &WormScrew::steady(*screw))?;
                Some(contact.on_worm(-FRAC_PI_2, 0.0).0)
            }
        }
    }
}

/// Accuracy of parameters, mm.
const ACCURACY: f64 = 1e-13;
/// A parameter is looked for this far around the radius that belongs to it, mm, and farther where it is not there.
const AROUND: f64 = 0.5;
const WIDER: usize = 8;

impl WormForm {
    /// Normal distance of a flank of this form from that of the involute worm, mm, at lengths of roll; positive where the worm has more
    /// material. At the pitch cylinder it is 0.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] for a cone, for a disc that does not touch the flank, and for lengths of roll that the form does not
    /// reach.
    pub fn distances(&self, worm: &Gear, flank: Flank, rolls: &[f64]) -> Result<Vec<f64>, DressingError> {
        let invalid = |field, value, allowed| DressingError::InvalidNumber { field, value, allowed };
        if !worm.is_cylindrical() {
            let cone = worm.data().cone_angle.to_degrees();
            return Err(invalid("cone angle of a worm that is no involute", cone, "0 deg"));
        }
        let involute = worm.flank(flank);
        let pitch = worm.pitch_radius();
        let w_pitch = involute.length_of_roll(pitch)?;
        let generator = self.generator(worm, involute, w_pitch);
        let usual = 0.25 * std::f64::consts::PI * worm.data().normal_module;
        // Further out or in straight flanks meet: thread or space have no width there.
        let highest = usual / worm.data().pressure_angle[flank].tan();
        let at = |w: f64, offset: f64| {
            let height = w.hypot(involute.base_radius) - pitch;
            if height.abs() > highest {
                return None;
            }
            let foot = |u: f64| generator.point(u, offset).map(|point| involute.deviation(&point));
            let mut around = AROUND;
            for _ in 0..WIDER {
                let ends = [height - around, height + around];
                let off = |u: f64| foot(u).map(|foot| foot.w - w).filter(|off| off.is_finite());
                if let [Some(low), Some(high)] = ends.map(off)
                    && let Some(u) = brent(ends, [low, high], ACCURACY, off)
                {
                    return foot(u).map(|foot| foot.f_n);
                }
                around *= 1.4;
            }
            None
        };
        let unreached =
            |w: f64| invalid("length of roll of a worm that is no involute", w, "one that its form reaches");
        let offset = match self {
            Self::Axial => 0.0,
            Self::Normal | Self::Disc { .. } => {
                let off = |offset: f64| at(w_pitch, offset);
                let ends = [0.6 * usual, 1.4 * usual];
                let [low, high] = ends.map(|end| off(end).unwrap_or(f64::NAN));
                brent(ends, [low, high], ACCURACY, off).ok_or_else(|| unreached(w_pitch))?
            }
        };
        rolls.iter().map(|&w| at(w, offset).ok_or_else(|| unreached(w))).collect()
    }

    fn generator(&self, worm: &Gear, involute: &InvoluteFlank, w_pitch: f64) -> Generator {
        let pitch = worm.pitch_radius();
        let place = involute.point(w_pitch, 0.0);
        let z = Vector3::z();
        match self {
            Self::Axial => {
                // In the plane of the axis and in the tangent plane at the pitch cylinder.
                let around = z.cross(&place);
                let along = involute.normal(w_pitch, 0.0).cross(&around);
                let along = along * (along.dot(&place)).signum() / along.norm();
                Generator::Line {
                    through: place,
                    across: Vector3::zeros(),
                    along: along * (pitch / along.dot(&place)),
                }
            }
            Self::Normal => {
                // The middle of the space lies on +y at z = 0; the helix through it, by the screw of the flank.
                let [roll, along_z] = variables([w_pitch, 0.0]);
                let moved = involute.point(roll, along_z);
                let rate = moved.map(|x| gradient_of(&x)[1]);
                let turn = (place.x * rate.y - place.y * rate.x) / (pitch * pitch);
                let middle = Vector3::y() * pitch;
                let helix = (z + z.cross(&middle) * turn).normalize();
                let across = helix.cross(&Vector3::y());
                let across = across * across.dot(&(place - middle)).signum();
                let slope = worm.data().pressure_angle[involute.flank].tan();
                // A space is wider outside.
                Generator::Line { through: middle, across, along: Vector3::y() + across * slope }
            }
            Self::Disc { diameter } => {
                let (screw, helix) = (worm.screw_parameter(involute.flank), worm.data().helix_angle);
                let crossing = helix - helix.signum() * FRAC_PI_2;
                Generator::Disc {
                    axes: DresserAxes::kinematic(crossing, pitch + 0.5 * diameter, 0.0),
                    screw,
                    radius: 0.5 * diameter,
                    slope: worm.data().pressure_angle[involute.flank].tan(),
                    side: involute.s() * screw.signum(),
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::{GearData, Sides};

    fn worm(threads: i32, hand: f64) -> Gear {
        let pitch_radius = 60.0;
        let module = 3.0;
        let lead = (f64::from(threads) * module / (2.0 * pitch_radius)).asin();
        Gear::new(GearData {
            teeth: threads,
            normal_module: module,
            pressure_angle: Sides { left: 20f64.to_radians(), right: 22f64.to_radians() },
            helix_angle: hand * (FRAC_PI_2 - lead),
            profile_shift: 0.0,
            cone_angle: 0.0,
        })
        .unwrap()
    }

    /// Points of the form on a flank over radii from 57 to 63 mm, in one place along the thread.
    fn points(form: WormForm, worm: &Gear, flank: Flank) -> Vec<Vector3<f64>> {
        let involute = worm.flank(flank);
        let rolls: Vec<f64> =
            (0..13).map(|i| involute.length_of_roll(57.0 + 0.5 * f64::from(i)).unwrap()).collect();
        let f = form.distances(worm, flank, &rolls).unwrap();
        rolls.iter().zip(f).map(|(&w, f)| involute.point(w, 0.0) + involute.normal(w, 0.0) * f).collect()
    }

    /// Turns a point along the screw, rad.
    fn screwed(worm: &Gear, point: &Vector3<f64>, turn: f64) -> Vector3<f64> {
        let (sin, cos) = turn.sin_cos();
        let z = turn * worm.screw_parameter(Flank::Left);
        Vector3::new(cos * point.x - sin * point.y, sin * point.x + cos * point.y, point.z + z)
    }

    /// By how much a point of the space on +y turns along the screw into the half plane of +y, rad.
    fn into_middle(point: &Vector3<f64>) -> f64 {
        point.x.atan2(point.y)
    }

    /// Axis of a tool that stands in the space on +y under the lead angle: across the helix through (0, 60, 0).
    fn across_helix(worm: &Gear) -> [Vector3<f64>; 2] {
        let helix = Vector3::new(-60.0 / worm.screw_parameter(Flank::Left), 0.0, 1.0).normalize();
        [helix, helix.cross(&Vector3::y())]
    }

    /// Largest distance of points (x, y) from the straight line through the first and the last of them.
    fn bend(points: &[[f64; 2]]) -> f64 {
        let ([x0, y0], [x1, y1]) = (points[0], points[points.len() - 1]);
        let length = (x1 - x0).hypot(y1 - y0);
        let off = |[x, y]: &[f64; 2]| ((x - x0) * (y1 - y0) - (y - y0) * (x1 - x0)).abs() / length;
        points.iter().map(off).fold(0.0, f64::max)
    }

    const WORMS: [(i32, f64); 3] = [(1, 1.0), (5, 1.0), (4, -1.0)];

    #[test]
    fn a_za_worm_is_straight_in_the_axial_section() {
        for (threads, hand) in WORMS {
            let worm = worm(threads, hand);
            for flank in Flank::BOTH {
                let form = points(WormForm::Axial, &worm, flank);
                let section: Vec<[f64; 2]> = form
                    .iter()
                    .map(|p| {
                        let moved = screwed(&worm, p, into_middle(p));
                        assert!(moved.x.abs() < 1e-12 && moved.y > 0.0);
                        [moved.y, moved.z]
                    })
                    .collect();
                assert!(bend(&section) < 1e-10, "{threads} {hand} {flank}: {}", bend(&section));
                let slope = (section[12][1] - section[0][1]) / (section[12][0] - section[0][0]);
                let lead = FRAC_PI_2 - worm.data().helix_angle.abs();
                let axial = worm.data().pressure_angle[flank].tan() / lead.cos();
                assert!((slope.abs() - axial).abs() < 1e-9, "{flank}: {slope} {axial}");
            }
        }
    }

    #[test]
    fn a_zn_worm_is_straight_in_the_normal_section_of_its_space() {
        for (threads, hand) in WORMS {
            let worm = worm(threads, hand);
            let [helix, across] = across_helix(&worm);
            for flank in Flank::BOTH {
                let form = points(WormForm::Normal, &worm, flank);
                let section: Vec<[f64; 2]> = form
                    .iter()
                    .map(|point| {
                        // Along the screw into the plane across the helix through the middle of the space.
                        let off = |turn: f64| helix.dot(&screwed(&worm, point, turn));
                        let middle = into_middle(point);
                        let ends = [middle - 0.5, middle + 0.5];
                        let turn = brent(ends, ends.map(off), 1e-15, |turn| Some(off(turn))).unwrap();
                        let at = screwed(&worm, point, turn);
                        [at.y, across.dot(&at)]
                    })
                    .collect();
                assert!(bend(&section) < 1e-9, "{threads} {hand} {flank}: {}", bend(&section));
                let slope = (section[12][1] - section[0][1]) / (section[12][0] - section[0][0]);
                assert!((slope.abs() - worm.data().pressure_angle[flank].tan()).abs() < 1e-9);
            }
        }
    }

    /// The disc of a ZK worm touches it in every height and cuts it nowhere: the least clearance over its way along the thread is 0.
    #[test]
    fn a_zk_worm_is_what_a_straight_disc_leaves() {
        let diameter = 120.0;
        for (threads, hand) in WORMS {
            let worm = worm(threads, hand);
            let [_, axis] = across_helix(&worm);
            let centre = Vector3::new(0.0, 60.0 + 0.5 * diameter, 0.0);
            for flank in Flank::BOTH {
                let form = points(WormForm::Disc { diameter }, &worm, flank);
                let slope = worm.data().pressure_angle[flank].tan();
                // Height of a point over the side of the disc, up to a constant that all have: how wide the disc is.
                let over = |point: &Vector3<f64>, turn: f64| {
                    let moved = screwed(&worm, point, turn);
                    let arm = moved - centre;
                    let z = arm.dot(&axis);
                    let r = (arm - axis * z).norm();
                    z.abs() + (r - 0.5 * diameter) * slope
                };
                let least = |point: &Vector3<f64>| {
                    // About the place before the disc.
                    let scan = (-1000..=1000).map(|k| into_middle(point) + f64::from(k) * 5e-4);
                    let at = scan.min_by(|a, b| over(point, *a).total_cmp(&over(point, *b))).unwrap();
                    let fine = (-500..=500).map(|k| at + f64::from(k) * 1e-6);
                    fine.map(|turn| over(point, turn)).fold(f64::INFINITY, f64::min)
                };
                let all: Vec<f64> = form.iter().map(least).collect();
                for clearance in &all {
                    assert!((clearance - all[6]).abs() < 1e-8, "{threads} {hand} {flank}: {all:?}");
                }
            }
        }
    }

    #[test]
    fn forms_meet_the_involute_at_the_pitch_cylinder_and_leave_it_beside_it() {
        for form in [WormForm::Axial, WormForm::Normal, WormForm::Disc { diameter: 120.0 }] {
            let worm = worm(4, 1.0);
            for flank in Flank::BOTH {
                let involute = worm.flank(flank);
                let rolls = [57.0, 60.0, 63.0].map(|r| involute.length_of_roll(r).unwrap());
                let f = form.distances(&worm, flank, &rolls).unwrap();
                assert!(f[1].abs() < 1e-11, "{form:?} {flank}: {f:?}");
                assert!(f[0].abs() > 1e-5 && f[2].abs() > 1e-5, "{form:?} {flank}: {f:?}");
            }
        }
    }

    #[test]
    fn what_a_form_does_not_reach_is_refused_by_name() {
        let error = WormForm::Axial.distances(&worm(1, 1.0), Flank::Left, &[1e4]).unwrap_err();
        assert!(error.to_string().contains("length of roll"), "{error}");
    }
}
