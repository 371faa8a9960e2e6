//! A surface through profiles and leads of ONE tooth flank. It cannot see what vanishes on all traces: one profile and one lead tell nothing
//! of the twist, and oblique waves between the traces are lost or reach several times their size at the corners. A reconstructed
//! surface is therefore a type of its own and never a measurement of the field.

use super::{ArealError, ArealField, Trace};
use crate::Topography;

/// Whether traces of one flank share their zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zeros {
    /// Every trace has its own: the offsets are fitted where traces cross.
    Free,
    /// All have the same.
    Absolute,
}

/// How far profiles and leads disagree where they cross, mm. For absolute zeros the traces are taken as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mismatch {
    /// Root mean square over all crossings.
    pub rms: f64,
    /// Largest.
    pub largest: f64,
}

/// Warning: a surface is wanted far beyond its outermost traces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideTraces {
    /// "lengths of roll" or "axial positions".
    pub along: &'static str,
    /// How far beyond, as share of the field.
    pub share: f64,
}

/// A surface through traces. With free zeros its mean has no meaning: the middle profile keeps its zero, all else follows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Reconstruction {
    profiles: Vec<Trace>,
    leads: Vec<Trace>,
    /// p_j and h_i, mm.
    offsets: [Vec<f64>; 2],
    /// c_ij, row-major `[i][j]`.
    crossings: Vec<f64>,
    /// Mismatch at the crossings; `None` with absolute zeros.
    pub mismatch: Option<Mismatch>,
}

/// Traces nearer than this stand at the same place, mm.
const SAME_PLACE: f64 = 1e-6;
/// Share of the field beyond the outermost traces that still goes without a warning.
const BEYOND: f64 = 0.15;

/// Lagrange polynomials on `nodes` at x.
fn lagrange(nodes: &[Trace], x: f64) -> Vec<f64> {
    let at = |k: usize| nodes[k].position;
    (0..nodes.len())
        .map(|k| (0..nodes.len()).filter(|&m| m != k).map(|m| (x - at(m)) / (at(k) - at(m))).product())
        .collect()
}

fn check_places(direction: &'static str, traces: &[Trace]) -> Result<(), ArealError> {
    for (k, trace) in traces.iter().enumerate() {
        let same = |other: &&Trace| (other.position - trace.position).abs() < SAME_PLACE;
        if let Some(other) = traces[..k].iter().find(same) {
            let (first, second) = (other.position, trace.position);
            return Err(ArealError::DuplicateTrace { direction, first, second });
        }
    }
    Ok(())
}

fn crossing(direction: &'static str, trace: &Trace, at: f64) -> Result<f64, ArealError> {
    let [from, to] = trace.range();
    let none = ArealError::TracesDoNotCross { direction, position: trace.position, from, to, crossing: at };
    trace.value(at).ok_or(none)
}

impl Reconstruction {
    /// From profiles (over w, at their z) and leads (over z, at their w) of one tooth flank.
    ///
    /// # Errors
    /// [`ArealError::TooFewTraces`], [`ArealError::DuplicateTrace`], [`ArealError::TracesDoNotCross`].
    pub fn new(profiles: Vec<Trace>, leads: Vec<Trace>, zeros: Zeros) -> Result<Self, ArealError> {
        let (k, l) = (profiles.len(), leads.len());
        if k == 0 || l == 0 {
            return Err(ArealError::TooFewTraces { profiles: k, leads: l });
        }
        check_places("profiles", &profiles)?;
        check_places("leads", &leads)?;
        let mut pairs = Vec::with_capacity(k * l);
        for lead in &leads {
            for profile in &profiles {
                let (p, h) =
                    (crossing("profile", profile, lead.position)?, crossing("lead", lead, profile.position)?);
                pairs.push([p, h]);
            }
        }
        let at = |i: usize, j: usize| pairs[i * k + j];
        let (mut p, mut h) = (vec![0.0; k], vec![0.0; l]);
        if zeros == Zeros::Free {
            // All profiles cross all leads, so the least squares are means of the differences.
            let apart = |i: usize, j: usize| at(i, j)[0] - at(i, j)[1];
            let mean_of = |j: usize| (0..l).map(|i| apart(i, j)).sum::<f64>() / l as f64;
            let held = mean_of(k / 2);
            (0..k).for_each(|j| p[j] = held - mean_of(j));
            (0..l).for_each(|i| h[i] = (0..k).map(|j| apart(i, j) + p[j]).sum::<f64>() / k as f64);
        }
        let shifted = |i: usize, j: usize| [at(i, j)[0] + p[j], at(i, j)[1] + h[i]];
        let (mut crossings, mut apart) = (Vec::with_capacity(k * l), Vec::with_capacity(k * l));
        for i in 0..l {
            for j in 0..k {
                let [a, b] = shifted(i, j);
                crossings.push(0.5 * (a + b));
                apart.push(a - b);
            }
        }
        let mismatch = (zeros == Zeros::Free).then(|| Mismatch {
            rms: foundation::numerics::root_mean_square(&apart),
            largest: apart.iter().fold(0.0, |m: f64, x| m.max(x.abs())),
        });
        Ok(Self { profiles, leads, offsets: [p, h], crossings, mismatch })
    }

    /// Offsets that were added to the profiles and to the leads, mm.
    pub fn offsets(&self) -> &[Vec<f64>; 2] {
        &self.offsets
    }

    /// The surface at (w, z), mm; `None` beyond the ends of a trace.
    pub fn value(&self, w: f64, z: f64) -> Option<f64> {
        let (over_z, over_w) = (lagrange(&self.profiles, z), lagrange(&self.leads, w));
        let [p, h] = &self.offsets;
        let mut f = 0.0;
        for (j, profile) in self.profiles.iter().enumerate() {
            f += (profile.value(w)? + p[j]) * over_z[j];
        }
        for (i, lead) in self.leads.iter().enumerate() {
            f += (lead.value(z)? + h[i]) * over_w[i];
            for (j, l) in over_z.iter().enumerate() {
                f -= self.crossings[i * over_z.len() + j] * over_w[i] * l;
            }
        }
        Some(f)
    }

    /// The surface on a grid; NaN beyond the ends of a trace.
    ///
    /// # Errors
    /// [`ArealError::OtherShape`] for fewer than two places in a direction.
    pub fn on_grid(&self, w: Vec<f64>, z: Vec<f64>) -> Result<Topography, ArealError> {
        let f = w.iter().flat_map(|&w| z.iter().map(move |&z| (w, z)));
        let f = f.map(|(w, z)| self.value(w, z).unwrap_or(f64::NAN)).collect();
        let found = w.len().min(z.len());
        Topography::new(w, z, f).ok_or(ArealError::OtherShape { name: "places of a grid", found, wanted: 2 })
    }

    /// Where evaluation over `field` goes far beyond the outermost traces.
    pub fn outside(&self, field: &ArealField) -> Vec<OutsideTraces> {
        let beyond = |along, traces: &[Trace], [from, to]: [f64; 2]| {
            let reach = traces
                .iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], t| [a.min(t.position), b.max(t.position)]);
            let share = (reach[0] - from).max(to - reach[1]) / (to - from);
            (share > BEYOND).then_some(OutsideTraces { along, share })
        };
        let found = [
            beyond("axial positions", &self.profiles, field.face()),
            beyond("lengths of roll", &self.leads, field.roll()),
        ];
        found.into_iter().flatten().collect()
    }
}
