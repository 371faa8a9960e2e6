//! One stroke of a worm flank as a tool surface: its exact envelope, continued to the unmodified thread in the same parameters, as
//! the exact contact asks. Knows no other stroke and no end of the active area.

use crate::{DressedWorm, DresserTool, FlankDresser, nominal_contact};
use contact::{SurfaceJet, ToolSurface};
use foundation::geometry::Flank;
use foundation::numerics::Chebyshev;

/// The envelope of a stroke over (t, v), or a share of its distance from the unmodified thread.
#[derive(Clone, Debug)]
pub struct StrokeSurface<'a> {
    worm: &'a DressedWorm,
    /// The nominal dresser in nominal kinematics.
    nominal: DressedWorm,
    /// The stroke's dresser, whose `designed` and `range` are those of the stroke.
    seated: &'a FlankDresser,
    share: f64,
}

/// The nominal dresser may work this far beyond the stroke's positions, mm: corrections move the contact along the worm.
const BEYOND: f64 = 500.0;

impl<'a> StrokeSurface<'a> {
    pub(super) fn new(worm: &'a DressedWorm, seated: &'a DresserTool, flank: Flank) -> Self {
        let (from, to) = worm.interval();
        let none = Chebyshev::constant(from - BEYOND, to + BEYOND, 0.0);
        let nominal =
            DressedWorm::new(&seated.plain(), flank, &[none.clone(), none.clone(), none.clone(), none]);
        Self { worm, nominal, seated: &seated.flanks[flank], share: 1.0 }
    }

    /// The unmodified thread where the stroke's (t, v) belongs to: the length of roll w that t is laid on is dressed by the circle
    /// t = w of the nominal dresser, at another worm position.
    fn unmodified(&self, t: f64, v: f64) -> Option<SurfaceJet> {
        let (designed, range) = (&self.seated.designed, &self.seated.range);
        let slope = range.length() / designed.length();
        let w = range.w_nf + (t - designed.w_nf) * slope;
        let line = &self.seated.line;
        let (first, last) = line.interval();
        let inside = (first..=last).contains(&w);
        let nominal = nominal_contact(&self.seated.worm, &self.seated.chain, w).ok()?;
        let own = line.value(w.clamp(first, last));
        let own_slope = if inside { line.derivative().value(w) } else { 0.0 };
        let (q, lean) = (v + nominal.b - own, (nominal.slope - own_slope) * slope);
        let jet = self.nominal.jet(w, q)?;
        Some(SurfaceJet {
            p: jet.p,
            n: jet.n,
            p_p: jet.p_p * slope + jet.p_q * lean,
            p_q: jet.p_q,
            n_p: jet.n_p * slope + jet.n_q * lean,
            n_q: jet.n_q,
        })
    }
}

impl ToolSurface for StrokeSurface<'_> {
    fn jet(&self, t: f64, v: f64) -> Option<SurfaceJet> {
        if self.share == 1.0 {
            return self.worm.jet(t, v);
        }
        let from = self.unmodified(t, v)?;
        if self.share == 0.0 {
            return Some(from);
        }
        let to = self.worm.jet(t, v)?;
        let between = |a: nalgebra::Vector3<f64>, b: nalgebra::Vector3<f64>| a + (b - a) * self.share;
        Some(SurfaceJet {
            p: between(from.p, to.p),
            n: between(from.n, to.n),
            p_p: between(from.p_p, to.p_p),
            p_q: between(from.p_q, to.p_q),
            n_p: between(from.n_p, to.n_p),
            n_q: between(from.n_q, to.n_q),
        })
    }

    fn start(&self, w_1: f64, z_1: f64) -> (f64, f64) {
        self.worm.start(w_1, z_1)
    }

    fn with_share(&self, share: f64) -> Box<dyn ToolSurface + '_> {
        Box::new(Self { share: self.share * share, ..self.clone() })
    }
}
