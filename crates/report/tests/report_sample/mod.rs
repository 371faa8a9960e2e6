//! Made-up flanks and axes that the tests of charts draw.

use foundation::geometry::Flank;
use report::charts::{AxisChart, AxisChartLimits, Topography};

const COS_BETA_B: f64 = 0.837;

/// `count` equidistant values with both ends.
pub fn spread(lo: f64, hi: f64, count: usize) -> Vec<f64> {
    (0..count).map(|k| lo + (hi - lo) * k as f64 / (count - 1) as f64).collect()
}

/// A topography on 41 x 41 points over w 4.1 .. 22.9 mm, z -20 .. 20 mm.
pub fn field(f: impl Fn(f64, f64) -> f64) -> Topography {
    let (w, z) = (spread(4.1, 22.9, 41), spread(-20.0, 20.0, 41));
    let values = w.iter().map(|&w| z.iter().map(|&z| f(w, z)).collect()).collect();
    Topography::new(w, z, values).unwrap()
}

/// Crowning 20 um and profile crowning 5 um, normal.
pub fn crowned(w: f64, z: f64) -> f64 {
    -(20.0 * (z / 20.0).powi(2) + 5.0 * ((w - 13.5) / 9.4).powi(2)) * COS_BETA_B
}

/// A smooth error of 0.003 um.
pub fn ripple(w: f64, z: f64, side: Flank) -> f64 {
    0.003 * (0.31 * z + side.sign()).sin() * (0.55 * w - 0.04 * z).cos() + 0.0004 * side.sign()
}

/// An axis that runs to and fro `turns` times over 10 s on `rows` instants, by `stroke` about `middle`.
pub fn swinging(rows: usize, turns: f64, middle: f64, stroke: f64) -> AxisChart {
    let time_s = spread(0.0, 10.0, rows);
    let rate = 2.0 * std::f64::consts::PI * turns / 10.0;
    let over = |f: &dyn Fn(f64) -> f64| time_s.iter().map(|&t| f(rate * t)).collect::<Vec<f64>>();
    AxisChart {
        axis: "X1".into(),
        word: "X".into(),
        unit: "mm".into(),
        position: over(&|u| middle - stroke * u.cos()),
        velocity: over(&|u| stroke * rate * u.sin()),
        acceleration: over(&|u| stroke * rate * rate * u.cos()),
        limits: AxisChartLimits {
            travel: Some([-420.0, -20.0]),
            velocity: Some(250.0),
            acceleration: Some(2500.0),
        },
        time_s,
    }
}
