//! A measuring machine in front of a simulated gear: profiles and helix traces of some teeth, each with a zero of its own, with the gear
//! off its centre, teeth that differ and readings that scatter. Knows no evaluation.

use super::super::drawn::DrawnGear;
use foundation::geometry::{Flank, Gear, Sides};
use foundation::numerics::Noise;
use generating_grinding::job::SimulatedMeasurement;
use measured_files::inspection::{Inspection, Trace, TraceKind, Zero};
use metrology::Topography;
use std::f64::consts::TAU;

/// Zeros of traces lie within this of each other, um.
const ZEROS: f64 = 5.0;

/// Measures the flanks that were ground; `round` begins the random numbers anew.
pub(super) fn measured(
    drawn: &DrawnGear,
    gear: &Gear,
    flanks: &Sides<Option<Topography>>,
    of: &SimulatedMeasurement,
    round: usize,
) -> Inspection {
    let mut noise = Noise::new(of.seed.wrapping_mul(1 << 16).wrapping_add(round as u64));
    let mut inspection = Inspection::of_gear(drawn.gear);
    inspection.conditions = drawn.conditions.clone();
    let teeth = drawn.gear.teeth.unsigned_abs();
    let count = of.teeth.min(teeth);
    for number in 0..count {
        // Teeth are numbered from 1; tooth 1 lies on +y.
        let tooth = 1 + number * teeth / count;
        for (flank, found) in flanks.iter() {
            let Some(found) = found else { continue };
            let own = Tooth::drawn(tooth, teeth, flank, gear, of, &mut noise);
            inspection.traces.extend(own.traces(found, of, &mut noise));
        }
    }
    super::super::files::tag(&mut inspection.traces);
    inspection
}

/// What one tooth flank has of its own.
struct Tooth<'a> {
    tooth: u32,
    angle: f64,
    flank: Flank,
    gear: &'a Gear,
    eccentricity: [f64; 2],
    /// Slopes and crownings over u and v, um.
    own: [f64; 4],
    /// cos(beta_b).
    cos: f64,
}

impl<'a> Tooth<'a> {
    fn drawn(
        tooth: u32,
        teeth: u32,
        flank: Flank,
        gear: &'a Gear,
        of: &SimulatedMeasurement,
        noise: &mut Noise,
    ) -> Self {
        let own = [(); 4].map(|()| of.tooth_um * noise.normal());
        let angle = TAU * f64::from(tooth - 1) / f64::from(teeth);
        let cos = gear.flank(flank).base_helix_angle.cos();
        Self { tooth, angle, flank, gear, eccentricity: of.eccentricity_um, own, cos }
    }

    /// Profiles and helix traces on lines of the grid.
    fn traces(&self, found: &Topography, of: &SimulatedMeasurement, noise: &mut Noise) -> Vec<Trace> {
        let mut traces = Vec::new();
        for j in spread(of.profiles, found.z.len()) {
            let f = (0..found.w.len()).map(|i| self.at(found, i, j)).collect();
            traces.push(self.trace(TraceKind::Profile, found.z[j], &found.w, f, of, noise));
        }
        for i in spread(of.helices, found.w.len()) {
            let f = (0..found.z.len()).map(|j| self.at(found, i, j)).collect();
            traces.push(self.trace(TraceKind::Helix, found.w[i], &found.z, f, of, noise));
        }
        traces
    }

    fn trace(
        &self,
        kind: TraceKind,
        position_mm: f64,
        abscissa: &[f64],
        f: Vec<f64>,
        of: &SimulatedMeasurement,
        noise: &mut Noise,
    ) -> Trace {
        let zero = ZEROS * (2.0 * noise.uniform() - 1.0);
        let f_um = f.into_iter().map(|f| f + zero + of.noise_um * noise.normal()).collect();
        let (tooth, flank, tag, zero) = (self.tooth, self.flank, String::new(), Zero::Free);
        Trace { kind, tooth, flank, tag, position_mm, abscissa_mm: abscissa.to_vec(), f_um, zero }
    }

    /// Transverse deviation of this tooth at a point of the grid, um.
    fn at(&self, found: &Topography, i: usize, j: usize) -> f64 {
        let unit = |x: &[f64], k: usize| match x {
            [first, .., last] => (2.0 * x[k] - first - last) / (last - first),
            _ => 0.0,
        };
        let (u, v) = (unit(&found.w, i), unit(&found.z, j));
        let own =
            self.own[0] * u + self.own[1] * v + self.own[2] * (1.0 - u * u) + self.own[3] * (1.0 - v * v);
        (1e3 * found.at(i, j) + self.displaced(found.w[i], found.z[j]) + own) / self.cos
    }

    /// Normal deviation that the displacement of the gear brings at a point of the tooth, um.
    fn displaced(&self, w: f64, z: f64) -> f64 {
        let normal = self.gear.flank(self.flank).normal(w, z);
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = [normal.x * cos - normal.y * sin, normal.x * sin + normal.y * cos];
        self.eccentricity[0] * x + self.eccentricity[1] * y
    }
}

/// Lines of a grid for `count` traces: one in the middle, more from a tenth to nine tenths of the way.
fn spread(count: usize, lines: usize) -> Vec<usize> {
    let last = lines.saturating_sub(1) as f64;
    let place = |k: usize| if count < 2 { 0.5 } else { 0.1 + 0.8 * k as f64 / (count - 1) as f64 };
    let mut found: Vec<usize> = (0..count).map(|k| (last * place(k)).round() as usize).collect();
    found.dedup();
    found
}
