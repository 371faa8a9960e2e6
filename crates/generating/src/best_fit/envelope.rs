//! Where a planned flank is really ground, and what has to be commanded there (`docs/mathematics/best-fit.md#where-the-tool-touches`).

use super::super::least_squares::{Arguments, DiagonalCoordinates, FlankCoordinates, WormFunctions};
use super::super::{FlankLines, GrindingSetup};
use super::bases::Place;
use foundation::geometry::Flank;
use foundation::kinematics::MotionLaw;
use foundation::numerics::Jet2;
use nalgebra::{Matrix2, RowVector2, Vector2};

/// Second-order contact of one flank, the same all along the face width of a cylinder.
pub struct Envelope<'a> {
    setup: &'a GrindingSetup,
    lines: &'a FlankLines,
    coordinates: DiagonalCoordinates,
    shift: MotionLaw,
    ratio: f64,
    flank: Flank,
}

/// The contact at one length of roll.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// Relative curvature over (dw_2, dz_V2).
    pub h: Matrix2<f64>,
    /// Its inverse.
    pub inverse: Matrix2<f64>,
    /// Workpiece coordinates (w, z) under the worm's foot by the displacement.
    pub worm: Matrix2<f64>,
    /// Displacement by the step (w_1, z_1) on the worm; zero where the worm does not tell.
    back: Matrix2<f64>,
    /// Step of the length of roll on the worm by the displacement.
    pub reach: RowVector2<f64>,
    /// zeta by the displacement.
    pub path: RowVector2<f64>,
    /// cos b2.
    pub cos: f64,
}

/// A place of the planned flank with its foot.
#[derive(Clone, Copy, Debug)]
pub struct Foot {
    /// Where the functions are asked for what is ground here.
    pub place: Place,
    /// Length of roll at which it is ground.
    pub w: f64,
    /// The command there is the flank less this, transverse, mm.
    pub lift: f64,
    /// Extremes of the curvature of the planned flank over that of the gap: below 1 or the envelope breaks; x makes the determinant ratio
    /// 1/(1 - x) along that direction.
    pub curvature: [f64; 2],
}

impl<'a> Envelope<'a> {
    /// For one flank under a constant ratio.
    pub fn new(
        setup: &'a GrindingSetup,
        flank: Flank,
        coordinates: DiagonalCoordinates,
        shift: MotionLaw,
        ratio: f64,
    ) -> Self {
        Self { setup, lines: &setup.lines[flank], coordinates, shift, ratio, flank }
    }

    /// The coordinates of the functions.
    pub fn coordinates(&self) -> DiagonalCoordinates {
        self.coordinates
    }

    /// X, the argument of the profile and X_K with derivatives.
    pub fn jets(&self, w: f64, z: f64) -> [Jet2; 3] {
        self.coordinates.jets(w, z)
    }

    /// The contact at length of roll w; `None` where the gap has no curvature.
    pub fn section(&self, w: f64) -> Option<Section> {
        let pair = &self.setup.pair.flanks[self.flank];
        let z = self.lines.z_m;
        let (w_1, z_1) = self.lines.worm_point(w, z, &self.shift);
        if !(w_1 > 0.0 && w > 0.0) {
            return None;
        }
        let curvature = pair.relative_curvature(w_1, w, self.ratio);
        let inverse = curvature.h.try_inverse()?;
        let moves = curvature.worm_moves();
        let back = moves.try_inverse().unwrap_or_else(Matrix2::zeros);
        let worm = if self.ratio == 0.0 {
            // Without shift the worm carries its profile only.
            let slope = self.lines.work_roll_slope();
            Matrix2::new(moves[(0, 0)] * slope, moves[(0, 1)] * slope, 0.0, 0.0)
        } else {
            let [at_w, at_z] = self.lines.work_point(w_1, z_1, &self.shift);
            Matrix2::new(at_w.fu, at_w.fv, at_z.fu, at_z.fv) * moves
        };
        let [by_shift, by_feed] = self.lines.work_feeds;
        let path = RowVector2::new(0.0, by_shift * self.ratio + by_feed);
        let reach = RowVector2::new(moves[(0, 0)], moves[(0, 1)]);
        Some(Section { h: curvature.h, inverse, back, worm, reach, path, cos: self.lines.cos_b2 })
    }

    /// Length of roll on the worm opposite length of roll w, without modification.
    pub fn worm_roll(&self, w: f64) -> f64 {
        self.lines.worm_point(w, self.lines.z_m, &self.shift).0
    }

    /// Length of roll at which (w, z) is ground when the worm touches it at (w_1, z_1).
    pub fn roll_of_contact(&self, section: &Section, (w, z): (f64, f64), (w_1, z_1): (f64, f64)) -> f64 {
        let nominal = self.lines.worm_point(w, z, &self.shift);
        w + (section.back * Vector2::new(w_1 - nominal.0, z_1 - nominal.1)).x
    }

    /// Arguments for a worm foot under (w, z) of the workpiece and a path coordinate zeta = z + t_K w.
    pub fn place(&self, w: f64, z: f64, zeta: f64) -> Place {
        let worm = self.coordinates.arguments(w, z);
        let path = self.coordinates.arguments(self.lines.w_m, zeta - self.lines.t_k * self.lines.w_m).path;
        Place { w, at: Arguments { path, ..worm } }
    }

    /// The place of the unmodified contact.
    pub fn unmoved(&self, w: f64, z: f64) -> Place {
        Place { w, at: self.coordinates.arguments(w, z) }
    }

    /// The place where a contact of the worm stands: worm point (w_1, z_1) and feed z_V2.
    pub fn place_of_contact(&self, (w_1, z_1): (f64, f64), feed: f64) -> Place {
        let [w, z] = self.lines.work_point(w_1, z_1, &self.shift);
        let [by_shift, by_feed] = self.lines.work_feeds;
        let zeta = by_shift * self.shift.value(feed) + by_feed * feed + self.lines.c_c2;
        if self.ratio == 0.0 {
            // Any z will do: nothing depends on the worm's lines.
            return self.place(self.lines.work_roll(w_1), self.lines.z_m, zeta);
        }
        self.place(w.f, z.f, zeta)
    }

    /// The foot of (w, z) for a planned flank of functions `f`.
    pub fn foot(&self, section: &Section, f: &WormFunctions, w: f64, z: f64) -> Foot {
        let [x, profile, path] = self.coordinates.jets(w, z);
        let own = f.profile_jet(profile.f);
        let carried = f.dressing_jet(w, x) + Jet2 { f: own[0], fu: own[1], fuu: own[2], ..Jet2::default() };
        let jet = f.kinematic_jet(path.f);
        // F_K depends on zeta = z + t_K w: X_K = c_K zeta.
        let c_k = path.fv;
        let (slope, bend) = (jet[1] * c_k, jet[2] * c_k * c_k);
        let gradient = section.worm.transpose() * Vector2::new(carried.fu, carried.fv)
            + section.path.transpose() * slope;
        let hessian = section.worm.transpose()
            * Matrix2::new(carried.fuu, carried.fuv, carried.fuv, carried.fvv)
            * section.worm
            + section.path.transpose() * section.path * bend;
        let moved = -(section.inverse * gradient) * section.cos;
        let lift = 0.5 * moved.dot(&(section.h * moved)) / section.cos;
        let on_worm = section.worm * moved;
        let along = (section.path * moved)[0];
        let zeta = z + self.lines.t_k * w + along;
        let place = self.place(w + on_worm.x, z + on_worm.y, zeta);
        // Eigenvalues of a symmetric form over another: real.
        let relative = section.inverse * hessian * section.cos;
        let (half, determinant) = (0.5 * relative.trace(), relative.determinant());
        let root = (half * half - determinant).max(0.0).sqrt();
        Foot { place, w: w + moved.x, lift, curvature: [half - root, half + root] }
    }
}
