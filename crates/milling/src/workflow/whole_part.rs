//! The whole part under motions: what they take from any surface of any space, and what they leave on the flanks that they finish.

use super::part_rays::{PartRay, PartSurface};
use super::prepare::MillingBodies;
use foundation::numerics::Progress;
use referee::{MilledRay, Swept, Unmilled};
use run::RunFailure;

/// What is wrong with a surface in a space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FaultKind {
    /// Material of the part is taken.
    Gouge,
    /// More stock is left than may be.
    Stock,
    /// No cutter comes by.
    NotMilled,
}

/// A surface of one space that is not as wanted: the worst of its rays, and how many there are.
#[derive(Clone, Copy, Debug)]
pub(super) struct PartFault {
    pub kind: FaultKind,
    pub surface: PartSurface,
    pub space: usize,
    /// Path and block in it that cut last; none where nothing came by.
    pub by: Option<[usize; 2]>,
    /// How much too deep or too high, mm.
    pub amount: f64,
    /// Where, mm.
    pub place: [f64; 3],
    pub rays: usize,
}

/// A surface with the number of its rays, over all spaces.
#[derive(Clone, Copy, Debug)]
pub(super) struct SurfaceFigures {
    pub surface: PartSurface,
    pub rays: usize,
}

/// The part as motions leave it.
#[derive(Clone, Debug)]
pub(super) struct WholePart {
    pub faults: Vec<PartFault>,
    pub surfaces: Vec<SurfaceFigures>,
    /// Every ray with the path that set it, in the order of the rays.
    pub milled: Vec<Result<MilledRay, Unmilled>>,
}

/// What may be cut off root, tips and ends where the tolerance of the flanks is closer, mm: no key of a job says it.
const BESIDE: f64 = 0.02;

/// How much too deep a surface may be cut, mm.
pub(super) fn allowed(surface: PartSurface, tolerance: f64) -> f64 {
    match surface {
        PartSurface::Flank(_) => tolerance,
        _ => tolerance.max(BESIDE),
    }
}

impl WholePart {
    /// Mills the rays; a flank may be cut deeper by the tolerance (mm), other surfaces by [`BESIDE`] at least.
    ///
    /// # Errors
    /// [`RunFailure`] for motions that the referee cannot follow.
    pub fn of(
        swept: &Swept<'_>,
        rays: &[PartRay],
        tolerance: f64,
        progress: &dyn Progress,
    ) -> Result<Self, RunFailure> {
        let normals: Vec<_> = rays.iter().map(|at| at.ray).collect();
        let milled =
            swept.mill(&normals, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?;
        let setup = swept.setup();
        let mut whole = Self { faults: Vec::new(), surfaces: Vec::new(), milled: milled.rays };
        for k in 0..rays.len() {
            let (at, found) = (&rays[k], whole.milled[k]);
            whole.count(at);
            let fault = match found {
                Ok(ray) if ray.length < -allowed(at.surface, tolerance) => {
                    Some((FaultKind::Gouge, Some([ray.path, ray.block]), -ray.length))
                }
                Ok(ray) if at.stock.is_some_and(|most| ray.length > most) => {
                    Some((FaultKind::Stock, Some([ray.path, ray.block]), ray.length))
                }
                Err(Unmilled::TooDeep { path, block, .. }) => {
                    Some((FaultKind::Gouge, Some([path, block]), setup.depth))
                }
                Err(Unmilled::NotReached) if at.stock.is_some() => {
                    Some((FaultKind::NotMilled, None, setup.stock))
                }
                _ => None,
            };
            if let Some((kind, by, amount)) = fault {
                whole.note(at, kind, by, amount);
            }
        }
        Ok(whole)
    }

    fn count(&mut self, at: &PartRay) {
        match self.surfaces.iter_mut().find(|known| known.surface == at.surface) {
            Some(known) => known.rays += 1,
            None => self.surfaces.push(SurfaceFigures { surface: at.surface, rays: 1 }),
        }
    }

    fn note(&mut self, at: &PartRay, kind: FaultKind, by: Option<[usize; 2]>, amount: f64) {
        let place = at.ray.point.into();
        let same = |known: &&mut PartFault| {
            known.kind == kind && known.surface == at.surface && known.space == at.space
        };
        match self.faults.iter_mut().find(same) {
            Some(known) => {
                known.rays += 1;
                if amount > known.amount {
                    (known.amount, known.by, known.place) = (amount, by, place);
                }
            }
            None => {
                let (surface, space) = (at.surface, at.space);
                self.faults.push(PartFault { kind, surface, space, by, amount, place, rays: 1 });
            }
        }
    }

    /// Faults of a surface.
    pub fn on(&self, surface: PartSurface) -> impl Iterator<Item = &PartFault> {
        self.faults.iter().filter(move |fault| fault.surface == surface)
    }
}

impl PartFault {
    /// In words; `by` says what did it.
    pub fn words(&self, bodies: &MillingBodies, by: &str) -> String {
        let [x, y, z] = self.place;
        let name = self.surface.name(bodies);
        let at = format!("space {}, {name}, at ({x:.3}, {y:.3}, {z:.3}) mm", self.space + 1);
        let rays = format!("{} ray{}", self.rays, if self.rays == 1 { "" } else { "s" });
        match self.kind {
            FaultKind::Gouge => format!("{at}: {by} cuts {:.4} mm too deep ({rays})", self.amount),
            FaultKind::Stock => format!("{at}: {:.4} mm of stock are left ({rays})", self.amount),
            FaultKind::NotMilled => format!("{at}: no cutter comes by ({rays})"),
        }
    }

    /// Its code.
    pub fn code(&self) -> &'static str {
        match (self.kind, self.surface) {
            (FaultKind::Gouge, PartSurface::Floor) => "root-body-gouged",
            (FaultKind::Gouge, PartSurface::Drawn(_)) => "root-gouged",
            (FaultKind::Gouge, PartSurface::Tip | PartSurface::End) => "tooth-gouged",
            (FaultKind::Gouge, PartSurface::Flank(_)) => "flank-gouged",
            (FaultKind::Gouge, PartSurface::Back) => "back-gouged",
            (FaultKind::Stock, _) => "stock-left",
            (FaultKind::NotMilled, _) => "flank-not-milled",
        }
    }
}
