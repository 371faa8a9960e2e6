//! Bodies of revolution that stand anywhere: cylinders and frusta of cones between two discs on one axis, and how far two of them are
//! apart.

use nalgebra::{Matrix3, Vector3};

/// A cylinder or a frustum of a cone: the convex hull of two discs on one axis. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnedBody {
    /// Middles of its end discs.
    ends: [Vector3<f64>; 2],
    /// Direction from the first to the second, a unit vector.
    axis: Vector3<f64>,
    /// Radii of the discs.
    radii: [f64; 2],
}

/// What a distance is known to, mm.
const ACCURACY: f64 = 1e-4;
/// Below this distance two bodies are one in the other, mm.
const TOUCH: f64 = 1e-7;
/// Share of a direction across the axis below which it counts as along the axis.
const ALONG: f64 = 1e-9;
/// Most corners that are looked for. Discs are round, so that each corner brings the search a share of the way: some thirty do for bodies
/// a metre long.
const MOST_CORNERS: usize = 500;

impl TurnedBody {
    /// A body between the middles of its end discs. `None` for ends in one place and for numbers that are not finite or radii below 0.
    pub fn new(ends: [Vector3<f64>; 2], radii: [f64; 2]) -> Option<Self> {
        let length = (ends[1] - ends[0]).norm();
        let sound = length.is_finite() && length > 0.0 && radii.iter().all(|r| r.is_finite() && *r >= 0.0);
        sound.then(|| Self { ends, axis: (ends[1] - ends[0]) / length, radii })
    }

    /// A body about +z, between two positions on it.
    pub fn about_z([from, to]: [f64; 2], radii: [f64; 2]) -> Option<Self> {
        Self::new([from, to].map(|z| Vector3::new(0.0, 0.0, z)), radii)
    }

    /// The body turned and moved.
    pub fn moved(&self, rotation: &Matrix3<f64>, translation: &Vector3<f64>) -> Self {
        let ends = self.ends.map(|end| rotation * end + translation);
        Self { ends, axis: rotation * self.axis, radii: self.radii }
    }

    /// No point of the body is farther from `place` than this, mm.
    pub fn reach(&self, place: &Vector3<f64>) -> f64 {
        let of = |k: usize| (self.ends[k] - place).norm() + self.radii[k];
        of(0).max(of(1))
    }

    fn middle(&self) -> Vector3<f64> {
        0.5 * (self.ends[0] + self.ends[1])
    }

    /// A point of the body that lies farthest in a direction.
    fn farthest(&self, direction: &Vector3<f64>) -> Vector3<f64> {
        let square = |to: &Vector3<f64>| to - self.axis * self.axis.dot(to);
        let across = square(direction);
        let length = across.norm();
        // Where little is left of the direction, rounding takes it off the square to the axis: once more.
        let outwards = if length > ALONG * direction.norm() {
            square(&(across / length)).normalize()
        } else {
            Vector3::zeros()
        };
        let [first, second] = [0, 1].map(|k| self.ends[k] + outwards * self.radii[k]);
        if first.dot(direction) > second.dot(direction) { first } else { second }
    }

    /// Least distance of two bodies, mm; 0 where one reaches into the other. What it says may be less than the distance by 1e-4 mm,
    /// never more; beyond `enough` it says any value from there up to the distance.
    ///
    /// The difference of all points of both is convex; its point nearest to zero is looked for by its corners in the direction of zero
    /// (Gilbert, Johnson and Keerthi). Each corner bounds the distance from below.
    pub fn distance(&self, other: &Self, enough: f64) -> f64 {
        let mut to = self.middle() - other.middle();
        let mut corners: Vec<Vector3<f64>> = Vec::with_capacity(4);
        let mut least: f64 = 0.0;
        for _ in 0..MOST_CORNERS {
            let length = to.norm();
            if length < TOUCH {
                return 0.0;
            }
            let corner = self.farthest(&-to) - other.farthest(&to);
            least = least.max(to.dot(&corner) / length);
            if least >= enough || length - least < ACCURACY {
                return least;
            }
            corners.push(corner);
            to = nearest_to_zero(&mut corners);
        }
        least
    }
}

/// The point nearest to zero of the convex hull of at most four points; keeps those on whose hull it lies.
fn nearest_to_zero(corners: &mut Vec<Vector3<f64>>) -> Vector3<f64> {
    let mut best = (f64::INFINITY, Vector3::zeros(), 0);
    for chosen in 1..1usize << corners.len() {
        let of: Vec<&Vector3<f64>> = corners
            .iter()
            .enumerate()
            .filter(|(k, _)| chosen >> k & 1 == 1)
            .map(|(_, corner)| corner)
            .collect();
        let Some(point) = foot_in(&of) else { continue };
        let length = point.norm_squared();
        if length < best.0 {
            best = (length, point, chosen);
        }
    }
    let (_, point, chosen) = best;
    let mut number = 0;
    corners.retain(|_| {
        number += 1;
        chosen >> (number - 1) & 1 == 1
    });
    point
}

/// The foot of the perpendicular from zero on the plane of all these points, where it lies in their hull.
fn foot_in(points: &[&Vector3<f64>]) -> Option<Vector3<f64>> {
    let (first, others) = points.split_first()?;
    // Rows that no point needs are those of the unit matrix.
    let mut edges = Matrix3::zeros();
    for (k, point) in others.iter().enumerate() {
        edges.set_column(k, &(*point - *first));
    }
    let mut products = edges.transpose() * edges;
    for k in others.len()..3 {
        products[(k, k)] = 1.0;
    }
    let shares = products.try_inverse()? * (edges.transpose() * -*first);
    let inside = shares.iter().all(|share| *share >= 0.0) && shares.sum() <= 1.0;
    inside.then(|| *first + edges * shares)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Rotation3;

    fn turned(about: [f64; 3], by: [f64; 3], body: TurnedBody) -> TurnedBody {
        let rotation = Rotation3::from_scaled_axis(Vector3::from(about));
        body.moved(rotation.matrix(), &Vector3::from(by))
    }

    fn cylinder(length: f64, radius: f64) -> TurnedBody {
        TurnedBody::about_z([-0.5 * length, 0.5 * length], [radius; 2]).unwrap()
    }

    fn near(distance: f64, expected: f64) {
        assert!((expected - 2e-4..=expected + 1e-9).contains(&distance), "{distance}, expected {expected}");
    }

    #[test]
    fn distances_that_are_known_are_found() {
        let (worm, nut) = (cylinder(100.0, 90.0), cylinder(30.0, 25.0));
        // Side by side, one above the other, crossed, and rim to rim.
        near(worm.distance(&turned([0.0; 3], [120.0, 0.0, 0.0], nut), f64::INFINITY), 5.0);
        near(worm.distance(&turned([0.0; 3], [10.0, 0.0, 70.0], nut), f64::INFINITY), 5.0);
        near(worm.distance(&turned([1.5, 0.0, 0.0], [123.0, 0.0, 4.0], nut), f64::INFINITY), 8.0);
        near(worm.distance(&turned([0.0; 3], [118.0, 0.0, 69.0], nut), f64::INFINITY), 5.0);
        // A cone: its slant side faces the cylinder.
        let cone = TurnedBody::about_z([0.0, 40.0], [10.0, 40.0]).unwrap();
        near(worm.distance(&turned([0.0; 3], [0.0, 132.0, 0.0], cone), f64::INFINITY), 2.0);
        assert_eq!(worm.distance(&turned([1.0, 0.2, 0.0], [100.0, 0.0, 10.0], nut), f64::INFINITY), 0.0);
    }

    /// A rod that points at the axis of a nut: the direction of its end is that of its axis but for rounding.
    #[test]
    fn rods_that_point_at_a_nut_are_as_far_as_their_ends() {
        let nut = TurnedBody::about_z([7.0, 25.0], [60.0; 2]).unwrap();
        for k in 0..40 {
            let (sin, cos) = f64::from(9 * k).to_radians().sin_cos();
            for z in [7.5, 8.0, 9.0, 10.5] {
                let at = |radius: f64| Vector3::new(radius * sin, radius * cos, z);
                let rod = TurnedBody::new([at(71.5), at(170.0)], [0.5; 2]).unwrap();
                near(rod.distance(&nut, f64::INFINITY), 11.5);
                near(nut.distance(&rod, f64::INFINITY), 11.5);
            }
        }
    }

    /// Points on both surfaces never lie nearer to each other than the stated distance, and some lie as near.
    #[test]
    fn no_points_lie_nearer_than_the_distance() {
        let points = |body: &TurnedBody| -> Vec<Vector3<f64>> {
            let aside = body.axis.cross(&Vector3::new(0.31, 0.52, 0.79)).normalize();
            let other = body.axis.cross(&aside);
            let mut points = Vec::new();
            for along in 0..=24 {
                let u = along as f64 / 24.0;
                let radius = body.radii[0] + u * (body.radii[1] - body.radii[0]);
                let at = body.ends[0] + (body.ends[1] - body.ends[0]) * u;
                points.extend((0..72).flat_map(|k| {
                    let (sin, cos) = (k as f64 * std::f64::consts::TAU / 72.0).sin_cos();
                    let rings =
                        if along == 0 || along == 24 { vec![0.0, 0.25, 0.5, 0.75, 1.0] } else { vec![1.0] };
                    rings.into_iter().map(move |share| at + (aside * cos + other * sin) * radius * share)
                }));
            }
            points
        };
        let cone = TurnedBody::about_z([-20.0, 50.0], [30.0, 12.0]).unwrap();
        for k in 0..12 {
            let x = f64::from(k);
            let other = turned(
                [0.4 * x, 0.9 - 0.3 * x, 0.7],
                [70.0 + 3.0 * x, 20.0 - 9.0 * x, 8.0 * x],
                cylinder(60.0, 18.0),
            );
            let distance = cone.distance(&other, f64::INFINITY);
            let (ours, theirs) = (points(&cone), points(&other));
            let pairs = ours.iter().flat_map(|a| theirs.iter().map(move |b| (a - b).norm()));
            let nearest = pairs.fold(f64::INFINITY, f64::min);
            assert!(distance <= nearest + 1e-9 && nearest < distance + 2.5, "{k}: {distance}, {nearest}");
            assert!((distance - other.distance(&cone, f64::INFINITY)).abs() < 2e-4);
            assert!(cone.distance(&other, 0.5 * distance) >= 0.5 * distance);
        }
    }
}
