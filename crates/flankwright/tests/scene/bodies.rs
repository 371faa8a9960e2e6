//! Gears and worms of scenes against the formulas of their flanks.

use super::checks::{vertices, volume};
use flankwright::geometry::Gear;
use flankwright::workflow::scene::Body;
use std::f64::consts::PI;

/// Share of the root radius that the bore takes in every scene.
const BORE: f64 = 0.45;

/// Radii of a toothed body at z = 0 and its faces, mm.
pub struct Extent {
    pub tip: f64,
    pub root: f64,
    pub form: f64,
    pub faces: [f64; 2],
}

/// Every vertex between the begin of the flanks and the tip lies on a flank, all others on the drawn circles.
pub fn on_flanks(name: &str, body: &Body, gear: &Gear, extent: &Extent) {
    let slope = gear.data().cone_angle.tan();
    let base = gear.flanks().iter().map(|(_, f)| f.base_radius).fold(0.0, f64::max);
    let mut seen = 0;
    for point in vertices(body) {
        let (radius, lean) = (point.xy().norm(), point.z * slope);
        let start = (extent.form - lean).max(extent.root - lean).max(base) + 0.03 * gear.data().normal_module;
        assert!(radius < extent.tip - lean + 1e-4, "{name}: {point}");
        assert!(point.z > extent.faces[0] - 1e-4 && point.z < extent.faces[1] + 1e-4, "{name}: {point}");
        if radius < start || radius > extent.tip - lean - 1e-3 {
            continue;
        }
        let off = gear.flanks().map(|_, flank| flank.deviation(&point).f_n.abs());
        assert!(off.left.min(off.right) < 1e-4, "{name}: {point} is {off:?} off");
        seen += 1;
    }
    assert!(seen > 100, "{name}: {seen}");
}

/// The volume lies between that with the spaces empty down to the root and that with them full up to the begin of the flanks.
pub fn holds_its_volume(name: &str, body: &Body, gear: &Gear, extent: &Extent) {
    let slope = gear.data().cone_angle.tan();
    let base = gear.flanks().iter().map(|(_, f)| f.base_radius).fold(0.0, f64::max);
    let [from, to] = extent.faces;
    let sum = |n: usize, [a, b]: [f64; 2], f: &dyn Fn(f64) -> f64| {
        let step = (b - a) / n as f64;
        (0..n).map(|k| f(a + (k as f64 + 0.5) * step)).sum::<f64>() * step
    };
    let root_at = |z: f64| extent.root - z * slope;
    let bore = BORE * root_at(from).min(root_at(to));
    let bounds = [false, true].map(|full| {
        sum(20, [from, to], &|z| {
            let root = root_at(z);
            let (start, tip) = ((extent.form - z * slope).max(root).max(base), extent.tip - z * slope);
            let teeth = |radius: f64| gear.tooth_count() * gear.transverse_thickness(radius, z).unwrap();
            let least = teeth(start) * (start - root);
            let ring = PI * (start * start - root * root);
            PI * (root * root - bore * bore)
                + if full { ring } else { least }
                + sum(200, [start, tip], &teeth)
        })
    });
    let held = volume(body);
    assert!(held > 0.99 * bounds[0] && held < 1.01 * bounds[1], "{name}: {held} not within {bounds:?}");
    assert!(bounds[1] < 1.12 * bounds[0], "{name}: {bounds:?} says nothing");
}
