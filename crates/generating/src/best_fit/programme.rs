//! The command of one flank as a convex programme: the smoothest functions that come near what is wanted where the tool touches, within what
//! the envelope and the axes allow (`docs/mathematics/best-fit.md#the-programme`).

use super::bases::{Bases, Kind, Place};
use super::envelope::{Envelope, Section};
use super::within::{LARGEST_BEND, Within};
use foundation::inverse::{Affine, Band, ConeOptimum, ConeProgramme};
use nalgebra::{DMatrix, DVector, Matrix2, Vector2};

/// What is meant by the functions, and how far they may be curved over the gap. A bend of 0 costs nothing: crests at a determinant ratio of 0.6,
/// hollows that leave a flank of half the gap's curvature. A bend of 0.3, the largest within the limits, allows a determinant ratio of 0.3 and
/// a flank of 0.7 of the gap's curvature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature {
    /// Least and largest at no bend.
    free: [f64; 2],
    /// What a bend of 1 adds to these.
    by_bend: [f64; 2],
}

impl Curvature {
    /// Of a command, where the tool touches.
    pub const COMMAND: Self = Self { free: [-0.4, 1.0], by_bend: [-1.0, 4.4] };
    /// Of the flank that is left; x of the flank is x/(1 - x) of its command.
    pub const FLANK: Self = Self { free: [-0.67, 0.5], by_bend: [-5.5, 0.67] };

    /// Of the flank that is left: all that a contact of a least determinant ratio can leave.
    pub fn possible(least_determinant: f64) -> Self {
        Self { free: [1.0 - least_determinant.recip(), 1.0], by_bend: [0.0, 0.0] }
    }
}

/// What an excess of 1, the tolerance, adds to the largest bend.
const BEND_BY_EXCESS: f64 = 0.1;
/// Price of the bend against smoothness.
const BEND: f64 = 500.0;
/// Share of the limits of the axes that costs nothing, in first order; a bend adds to it.
const AXES: f64 = 0.5;
/// Length of roll on the worm by which contacts stay off its ends for nothing, mm; a bend takes it away. Contacts that are further than the second
/// number from an end without modification do not come there.
const OFF_THE_ENDS: f64 = 0.3;
const FAR_FROM_ENDS: f64 = 4.0;
/// Price of the excess against smoothness.
const EXCESS: f64 = 1e3;
/// Weight of the second differences against that of the third, and of the coefficients of F_K and F_L themselves: choose among equal
/// decompositions.
const STRAIGHT: f64 = 1e-3;
const TRAVEL: f64 = 1e-5;
const RIDGE: f64 = 1e-9;
/// Weight of the second differences beyond the flank.
const BEYOND: f64 = 10.0;
/// A quadratic form that weighs nothing, for programmes without one; mm^2 of coefficients in tolerances.
const NO_FORM: f64 = 1e-9;
/// Largest distance of places at which curvatures are bounded where it is looked at closely, and of those at which a command is judged, in knots.
const CLOSENESS: f64 = 1.5;
const JUDGED: f64 = 0.5;
/// Parts into which a distance between places is divided, at most.
const MOST_BETWEEN: f64 = 16.0;
/// Accuracy of the interior points.
const ACCURACY: f64 = 1e-6;

/// How the axes answer to the functions, each share 1 at its limit, by 1 mm of the function, transverse.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AxisShares {
    /// Of F_C and F_L, for each correction of the dressing motion.
    pub lines: Vec<[f64; 2]>,
    /// Of F_K, for the motion of grinding.
    pub path: f64,
}

impl AxisShares {
    /// Every sum of coefficients that is the share of an axis.
    pub fn each(&self, bases: &Bases, mut take: impl FnMut(&[(usize, f64)])) {
        let block = |kind: Kind| bases.blocks.iter().find(|block| block.kind == kind);
        if let (Some(constant), Some(linear)) = (block(Kind::Constant), block(Kind::Linear)) {
            for [by_constant, by_linear] in &self.lines {
                for k in 0..constant.basis.count() {
                    take(&[(constant.first + k, *by_constant), (linear.first + k, *by_linear)]);
                }
            }
        }
        if let Some(path) = block(Kind::Kinematic) {
            (0..path.basis.count()).for_each(|k| take(&[(path.first + k, self.path)]));
        }
    }
}

/// How far the worm goes in its profile, as lengths of roll on it, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Reach {
    /// Where it ends.
    pub limits: [f64; 2],
    /// What touches each row of the grid where nothing is modified.
    pub unmodified: Vec<f64>,
}

/// What is to be commanded on one flank.
pub struct FlankProgramme<'a> {
    /// Contact.
    pub envelope: &'a Envelope<'a>,
    /// Functions.
    pub bases: &'a Bases,
    /// Where the tool touches, with the contact there: a grid, row by row.
    pub places: &'a [(Place, Section)],
    /// Places beside the flank, where the tool must not cut ahead of its contact.
    pub beside: &'a [(Place, Section)],
    /// Points of a row.
    pub row: usize,
    /// The command that is wanted at each of them, transverse, mm.
    pub wanted: &'a [f64],
    /// The tightest tolerance over that of each place.
    pub weights: &'a [f64],
    /// The tolerance is transverse, and the tightest.
    pub within: &'a Within,
    /// Share of the tolerance below which smoothness counts more than nearness.
    pub near: f64,
    /// What the functions are.
    pub curvature: Curvature,
    /// The axes.
    pub axes: &'a AxisShares,
    /// How far the worm goes, where contacts are kept on it.
    pub reach: Option<&'a Reach>,
    /// The command that the places were found for.
    pub held: Option<Held<'a>>,
    /// Where else the curvature is bounded: commands that were tried nearly folded there.
    pub folded: &'a [(Place, Section)],
}

/// A command near which the next one stays, where the tool would touch elsewhere: that is what the programme does not know.
#[derive(Clone, Copy, Debug)]
pub struct Held<'a> {
    /// Coefficients, mm.
    pub coefficients: &'a [f64],
    /// Price of what is not known, in the mean over the flank, in tolerances.
    pub price: f64,
}

/// Limits that a lower bound knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Those of the curvature, which keep the envelope unbroken.
    pub envelope: bool,
    /// Those of the axes.
    pub axes: bool,
}

impl FlankProgramme<'_> {
    /// Coefficients, mm, and what they cost: no more than `near` where nothing is difficult, 1 about at the tolerance. `None` if the programme cannot be solved.
    pub fn solve(&self) -> Option<(Vec<f64>, f64)> {
        let columns = self.bases.columns();
        let mut programme =
            ConeProgramme { cost: vec![0.0; columns + 2], common: 2, ..ConeProgramme::default() };
        let (excess, bend) = (columns, columns + 1);
        programme.cost[excess] = EXCESS;
        programme.cost[bend] = BEND;
        for own in [excess, bend] {
            programme.positive.push(Affine { entries: vec![(own, 1.0)], constant: 0.0 });
        }
        let room = vec![(bend, -1.0), (excess, BEND_BY_EXCESS)];
        programme.positive.push(Affine { entries: room, constant: self.within.bend });
        self.stay_near(self.near, &mut programme);
        self.keep_envelope(&mut programme)?;
        self.keep_reach(&mut programme);
        self.keep_axes(&mut programme);
        self.be_smooth(&mut programme);
        self.stay_where_it_touches(&mut programme);
        let ConeOptimum { mut x, .. } = programme.solve(ACCURACY)?;
        let cost = self.near + x.get(excess)?.max(0.0) + x.get(bend)?.max(0.0);
        x.truncate(columns);
        x.iter_mut().for_each(|x| *x *= self.within.tolerance);
        Some((x, cost))
    }

    /// A lower bound of what any functions of the class leave of what is wanted at these places, in tolerances, within the limits of the axes and of
    /// the curvature at no bend. `None` if the programme cannot be solved.
    pub fn least_excess(&self, limits: Limits) -> Option<f64> {
        let columns = self.bases.columns();
        let mut programme =
            ConeProgramme { cost: vec![0.0; columns + 2], common: 2, ..ConeProgramme::default() };
        let (excess, bend) = (columns, columns + 1);
        programme.cost[excess] = 1.0;
        programme.positive.push(Affine { entries: vec![(excess, 1.0)], constant: 0.0 });
        // As far as the axes may go; the curvature knows no bend.
        for (sign, constant) in [(1.0, 0.0), (-1.0, 1.0 - AXES)] {
            programme.positive.push(Affine { entries: vec![(bend, sign)], constant });
        }
        self.stay_near(0.0, &mut programme);
        if limits.envelope {
            self.keep_envelope(&mut programme)?;
        }
        if limits.axes {
            self.keep_axes(&mut programme);
        }
        programme.quadratic.extend((0..columns + 2).map(|k| (k, k, NO_FORM)));
        programme.solve(ACCURACY).map(|optimum| optimum.bound.max(0.0))
    }

    /// What the programme costs at most: as much as with these coefficients, mm, which leave `off`, in tolerances. `None` where they are beyond
    /// the limits. Does not know the ends of the worm.
    pub fn cost_of(&self, x: &[f64], off: f64) -> Option<f64> {
        let excess = (off - self.near).max(0.0);
        let mut bend: f64 = 0.0;
        self.axes.each(self.bases, |entries| {
            let share: f64 = entries.iter().map(|&(k, share)| share * x[k]).sum();
            bend = bend.max(share.abs() - AXES);
        });
        for at in &self.bounded() {
            for (side, curved) in self.curvature(x, at)?.into_iter().enumerate() {
                bend = bend.max((curved - self.curvature.free[side]) / self.curvature.by_bend[side]);
            }
        }
        (bend <= self.within.bend + BEND_BY_EXCESS * excess).then_some(self.near + excess + bend)
    }

    /// Extremes of the curvature of functions with these coefficients, mm, over that of the gap.
    fn curvature(&self, x: &[f64], (place, section): &(Place, Section)) -> Option<[f64; 2]> {
        let [a, b, c] = self.envelope.curvature_rows(section, self.bases, place)?;
        let value = |row: &[(usize, f64)]| row.iter().map(|&(k, by)| by * x[k]).sum::<f64>();
        let [a, b, c] = [value(&a), value(&b), value(&c)];
        let (middle, half) = (0.5 * (a + c), f64::hypot(0.5 * (a - c), b));
        Some([middle - half, middle + half])
    }

    /// Determinant ratios of a command, mm, where the tool touches and between: in the direction in which it is least. `None` where the gap is
    /// not open.
    pub fn determinants(&self, x: &[f64]) -> Option<Vec<((Place, Section), f64)>> {
        let at = self.thinned().map(|(_, at)| *at).chain(self.between(JUDGED));
        at.map(|at| Some((at, 1.0 + self.curvature(x, &at)?[0]))).collect()
    }

    /// |wanted - f| <= near + excess, in tolerances of the place.
    fn stay_near(&self, near: f64, programme: &mut ConeProgramme) {
        let excess = self.bases.columns();
        let mut row = Vec::new();
        for (((place, _), wanted), weight) in self.places.iter().zip(self.wanted).zip(self.weights) {
            let wanted = weight * wanted / self.within.tolerance;
            self.bases.row(place, &mut row);
            let entries = row.iter().map(|&(k, a)| (k, -weight * a)).collect();
            let room = Affine { entries: vec![(excess, 1.0)], constant: near };
            programme.strips.push([room, Affine { entries, constant: wanted }]);
        }
    }

    /// Points that tell enough of curvatures and slopes of splines of fewer pieces: every second of every second row, or as on a chessboard.
    fn thinned(&self) -> impl Iterator<Item = (usize, &(Place, Section))> {
        let (row, closely) = (self.row, self.within.closely);
        let thinned = move |&(k, _): &(usize, _)| {
            let (i, j) = (k / row, k % row);
            (i + j).is_multiple_of(2) && (closely || i.is_multiple_of(2))
        };
        self.places.iter().enumerate().filter(thinned)
    }

    /// Places at which the curvature is bounded.
    fn bounded(&self) -> Vec<(Place, Section)> {
        let mut bounded: Vec<(Place, Section)> = self.thinned().map(|(_, at)| *at).collect();
        if self.within.closely {
            bounded.extend(self.between(CLOSENESS));
        }
        bounded.extend(self.beside);
        bounded.extend(self.folded);
        bounded
    }

    /// Places between neighbours among the thinned ones that a crest has drawn apart, by more knots than `closeness`: a short piece of the flank
    /// is ground by a long one of the tool there.
    fn between(&self, closeness: f64) -> Vec<(Place, Section)> {
        let mut between = Vec::new();
        for (k, (from, section)) in self.thinned() {
            let in_row = k % self.row + 2 < self.row;
            for next in [in_row.then_some(k + 2), Some(k + 2 * self.row)].into_iter().flatten() {
                let Some((to, there)) = self.places.get(next) else { continue };
                let parts = (self.bases.apart(from, to) / closeness).ceil().min(MOST_BETWEEN);
                let mut share = parts.recip();
                while share < 1.0 - 0.5 / parts {
                    let section = if share < 0.5 { section } else { there };
                    between.push((from.towards(to, share), *section));
                    share += parts.recip();
                }
            }
        }
        between
    }

    /// The tool touches where it still has its profile: the place on the worm moves with the slopes of the command at the foot.
    fn keep_reach(&self, programme: &mut ConeProgramme) {
        let bend = self.bases.columns() + 1;
        let Some(Reach { limits, unmodified }) = self.reach else { return };
        for (k, (place, section)) in self.thinned() {
            let at = unmodified[k / self.row];
            for (room, sign) in [(at - limits[0], 1.0), (limits[1] - at, -1.0)] {
                if room > FAR_FROM_ENDS {
                    continue;
                }
                let moves = self.envelope.reach_row(section, self.bases, place);
                let by = sign * self.within.tolerance;
                let mut entries: Vec<(usize, f64)> = moves.into_iter().map(|(k, a)| (k, by * a)).collect();
                entries.push((bend, OFF_THE_ENDS / LARGEST_BEND));
                programme.positive.push(Affine { entries, constant: room - OFF_THE_ENDS });
            }
        }
    }

    /// Both eigenvalues of the curvature over that of the gap between their limits.
    fn keep_envelope(&self, programme: &mut ConeProgramme) -> Option<()> {
        let bend = self.bases.columns() + 1;
        for (place, section) in &self.bounded() {
            let [a, b, c] = self.envelope.curvature_rows(section, self.bases, place)?;
            let scaled = |row: &[(usize, f64)], by: f64| -> Vec<(usize, f64)> {
                row.iter().map(|&(k, x)| (k, x * by * self.within.tolerance)).collect()
            };
            let joined = |mut left: Vec<(usize, f64)>, right: Vec<(usize, f64)>| {
                left.extend(right);
                left
            };
            // A crest's command is curved against the gap: its least eigenvalue is bounded from below.
            let end = |side: usize| Affine {
                entries: vec![(bend, self.curvature.by_bend[side].abs())],
                constant: self.curvature.free[side].abs(),
            };
            programme.bands.push(Band {
                middle: joined(scaled(&a, 0.5), scaled(&c, 0.5)),
                others: [joined(scaled(&a, 0.5), scaled(&c, -0.5)), scaled(&b, 1.0)],
                ends: [end(0), end(1)],
            });
        }
        Some(())
    }

    /// The shares of the axes within their limits: B-splines lie within their coefficients.
    fn keep_axes(&self, programme: &mut ConeProgramme) {
        let bend = self.bases.columns() + 1;
        self.axes.each(self.bases, |entries| {
            let room = Affine { entries: vec![(bend, 1.0)], constant: AXES };
            let entries = entries.iter().map(|&(k, share)| (k, share * self.within.tolerance)).collect();
            programme.strips.push([room, Affine { entries, constant: 0.0 }]);
        });
    }

    /// Mean squares of third differences, and what chooses among equals.
    fn be_smooth(&self, programme: &mut ConeProgramme) {
        for block in &self.bases.blocks {
            let travel = match block.kind {
                Kind::Kinematic | Kind::Linear => TRAVEL,
                Kind::Constant | Kind::Profile => 0.0,
            };
            block.differences(&[-1.0, 3.0, -3.0, 1.0], 1.0, &mut programme.quadratic);
            block.differences(&[1.0, -2.0, 1.0], STRAIGHT, &mut programme.quadratic);
            block.straight_beyond(BEYOND, &mut programme.quadratic);
            block.differences(&[1.0], travel + RIDGE, &mut programme.quadratic);
        }
    }

    /// A change of the command by delta leaves less than delta: by grad(delta) H^-1 grad(delta)/2, as the contact moves.
    fn stay_where_it_touches(&self, programme: &mut ConeProgramme) {
        let Some(Held { coefficients, price }) = self.held else { return };
        let columns = self.bases.columns();
        let mut form = DMatrix::<f64>::zeros(columns, columns);
        let count = self.thinned().count().max(1) as f64;
        for (_, (place, section)) in self.thinned() {
            let slopes = self.envelope.slope_rows(section, self.bases, place);
            let by = section.inverse * (price * self.within.tolerance * section.cos / count);
            for (i, (column, slope)) in slopes.iter().enumerate() {
                let moved = by * slope;
                for (other, along) in &slopes[..=i] {
                    // `slopes` ascends: the lower triangle.
                    form[(*column, *other)] += moved.dot(along);
                }
            }
        }
        form.fill_upper_triangle_with_lower_triangle();
        let held = DVector::from_iterator(columns, coefficients.iter().map(|x| x / self.within.tolerance));
        for (cost, pull) in programme.cost.iter_mut().zip((&form * held).iter()) {
            *cost -= pull;
        }
        let entries = (0..columns).flat_map(|j| (0..=j).map(move |i| (i, j)));
        let entries = entries.map(|(i, j)| (i, j, form[(i, j)])).filter(|(.., value)| *value != 0.0);
        programme.quadratic.extend(entries);
    }
}

impl Envelope<'_> {
    /// The row of the step of the length of roll on the worm that a command asks for where the tool touches, by the coefficients in mm.
    fn reach_row(&self, section: &Section, bases: &Bases, place: &Place) -> Vec<(usize, f64)> {
        let answer = -section.reach * section.inverse * section.cos;
        let slopes = self.slope_rows(section, bases, place);
        slopes.into_iter().map(|(k, slope)| (k, (answer * slope)[0])).collect()
    }

    /// The slopes of the functions over the displacement of the contact, by the coefficients in mm.
    fn slope_rows(&self, section: &Section, bases: &Bases, place: &Place) -> Vec<(usize, Vector2<f64>)> {
        let (worm, path) = (section.worm.transpose(), section.path.transpose());
        let [x, _, along] = self.jets(place.w, 0.0);
        let (u, u_w) = bases.factor(place.w);
        let along_lines = worm * Vector2::new(x.fu, x.fv);
        let by_w: Vector2<f64> = worm.column(0).into();
        let mut rows = Vec::new();
        for block in &bases.blocks {
            let (first, jets) = block.jets(block.argument(place));
            rows.extend(jets.into_iter().enumerate().map(|(k, [f, f1, _])| {
                let slope: Vector2<f64> = match block.kind {
                    Kind::Constant => along_lines * f1,
                    Kind::Linear => along_lines * (f1 * u) + by_w * (f * u_w),
                    Kind::Profile => by_w * f1,
                    Kind::Kinematic => path * (f1 * along.fv),
                };
                (first + k, slope)
            }));
        }
        rows
    }

    /// The rows of the symmetric matrix (xx, xy, yy) whose eigenvalues are the curvatures of the functions over those of the gap, by the
    /// coefficients in mm. `None` where the gap is not open in all directions.
    pub fn curvature_rows(
        &self,
        section: &Section,
        bases: &Bases,
        place: &Place,
    ) -> Option<[Vec<(usize, f64)>; 3]> {
        let root = section.h.cholesky()?.l().try_inverse()?;
        let (worm, path) = (root * section.worm.transpose(), root * section.path.transpose());
        let mut rows: [Vec<(usize, f64)>; 3] = Default::default();
        let w = place.w;
        // Straight coordinates: their slopes are the same everywhere.
        let [x, _, along] = self.jets(w, 0.0);
        for block in &bases.blocks {
            let (first, jets) = block.jets(block.argument(place));
            let (u, u_w) = bases.factor(w);
            for (k, [_, f1, f2]) in jets.into_iter().enumerate() {
                let own = Matrix2::new(x.fu * x.fu, x.fu * x.fv, x.fu * x.fv, x.fv * x.fv) * f2;
                let form = match block.kind {
                    Kind::Constant => worm * own * worm.transpose(),
                    Kind::Linear => {
                        let tilt = Matrix2::new(2.0 * x.fu, x.fv, x.fv, 0.0) * (f1 * u_w);
                        worm * (own * u + tilt) * worm.transpose()
                    }
                    Kind::Profile => {
                        let by_w: Vector2<f64> = worm.column(0).into();
                        by_w * by_w.transpose() * f2
                    }
                    // F_K depends on zeta: X_K = c_K zeta.
                    Kind::Kinematic => path * path.transpose() * (f2 * along.fv * along.fv),
                };
                for (row, value) in rows.iter_mut().zip([form[(0, 0)], form[(0, 1)], form[(1, 1)]]) {
                    row.push((first + k, value * section.cos));
                }
            }
        }
        Some(rows)
    }
}
