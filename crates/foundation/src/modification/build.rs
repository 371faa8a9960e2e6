//! From a description to a checked expression tree: ranges, units (um to mm) and the symbols of `docs/mathematics/modifications.md`.

use super::curve::Curve;
use super::error::ModificationError;
use super::field::EvaluationField;
use super::files::{GridTable, ModificationFiles};
use super::formula::{Formula, FormulaError};
use super::limits;
use super::node::Node;
use super::point_cloud::PointCloud;
use super::profile_trace::{LEAST_POINTS, ProfileTrace};
use super::spec::{
    CornerProfile, DirectedSpec, FlankChoice, FormulaSpec, GridSpec, HelixTracesSpec, ModificationSpec,
    PointMethod, PointsSpec, PolynomialSpec, ProfileTraceSpec, Reference, ReliefSpec, TriangularSpec,
    WavinessSpec,
};
use super::traces::Traces;
use super::warning::ModificationWarning;
use super::waviness::Waviness;
use crate::numerics::{CubicSpline, Polynomial2, SplineError, TensorSpline, fit_tensor_spline};

/// um to mm.
const UM: f64 = 1e-3;

/// Share of the evaluation range by which a grid may end short of it: rounding of its coordinates.
const GRID_SLACK: f64 = 0.01;

/// Share of the field beyond the outermost trace from which their continuation is doubtful.
const FAR_FROM_TRACES: f64 = 0.15;

/// Most cells along one direction of a surface fitted to a cloud: finer detail asks for a grid.
const MOST_CELLS: usize = 12;

type Built<T> = Result<T, ModificationError>;

/// Builds nodes for one field and gathers warnings on the way.
pub(super) struct Builder<'a> {
    field: &'a EvaluationField,
    files: &'a dyn ModificationFiles,
    warnings: Vec<ModificationWarning>,
    depth: usize,
}

/// A border towards which a relief grows: x = sign (position - border) + length.
struct Border {
    sign: f64,
    position: f64,
    along_roll: bool,
}

impl<'a> Builder<'a> {
    pub(super) fn new(field: &'a EvaluationField, files: &'a dyn ModificationFiles) -> Self {
        Self { field, files, warnings: Vec::new(), depth: 0 }
    }

    pub(super) fn into_warnings(self) -> Vec<ModificationWarning> {
        self.warnings
    }

    pub(super) fn node(&mut self, spec: &ModificationSpec) -> Built<Node> {
        use ModificationSpec as S;
        let kind = spec.kind();
        let field = *self.field;
        let (w_m, z_m) = (field.roll_middle(), field.face_middle());
        let (half_a, half_b) = (0.5 * field.roll_length(), 0.5 * field.face_length());
        let ([w_f, w_a], [z_1, z_2]) = (field.roll(), field.face());
        let transverse = match spec.reference() {
            Reference::Transverse => 1.0,
            Reference::Normal => 1.0 / field.normal_factor(),
        };
        // The signed amount in mm: f = -C.
        let left = |key: &str, amount_um: f64| {
            number(kind, key, amount_um, limits::AMOUNT_UM).map(|c| -c * transverse * UM)
        };
        let profile = |centre: f64, curve: Curve| Node::Ridge { a: 1.0, b: 0.0, c: -centre, curve };
        let helix = |centre: f64, curve: Curve| Node::Ridge { a: 0.0, b: 1.0, c: -centre, curve };
        let tip = Border { sign: 1.0, position: w_a, along_roll: true };
        let root = Border { sign: -1.0, position: w_f, along_roll: true };
        let face_1 = Border { sign: -1.0, position: z_1, along_roll: false };
        let face_2 = Border { sign: 1.0, position: z_2, along_roll: false };
        Ok(match spec {
            S::ProfileCrowning(s) => {
                profile(w_m, Curve::Parabola { c: left("amount_um", s.amount_um)? / (half_a * half_a) })
            }
            S::ProfileCrowningArc(s) => profile(w_m, arc(kind, -left("amount_um", s.amount_um)?, half_a)?),
            S::ProfileCrowningRadius(s) => {
                profile(0.0, self.over_radius(left("amount_um", s.amount_um)?, true))
            }
            S::ProfileSlopeRadius(s) => {
                profile(0.0, self.over_radius(left("amount_um", s.amount_um)?, false))
            }
            S::HelixCrowning(s) => {
                helix(z_m, Curve::Parabola { c: left("amount_um", s.amount_um)? / (half_b * half_b) })
            }
            S::HelixCrowningArc(s) => helix(z_m, arc(kind, -left("amount_um", s.amount_um)?, half_b)?),
            S::HelixCrowningTwoArc(s) => {
                let apex = inside(kind, "apex_z_mm", s.apex_z_mm, [z_1, z_2])?;
                let [at_1, at_2] = s.amounts_um()?;
                let [key_1, key_2] = s.keys();
                let c_1 = left(key_1, at_1)? / (apex - z_1).powi(2);
                let c_2 = left(key_2, at_2)? / (z_2 - apex).powi(2);
                helix(apex, Curve::TwoParabolas { c_1, c_2 })
            }
            S::ProfileCrowningTwoArc(s) => {
                let apex = inside(kind, "apex_w_mm", s.apex_w_mm, [w_f, w_a])?;
                let c_1 = left("amount_I_um", s.amount_1_um)? / (apex - w_f).powi(2);
                let c_2 = left("amount_II_um", s.amount_2_um)? / (w_a - apex).powi(2);
                profile(apex, Curve::TwoParabolas { c_1, c_2 })
            }
            S::ProfileSlope(s) => {
                profile(w_f, Curve::Line { c: left("amount_um", s.amount_um)? / field.roll_length() })
            }
            S::HelixSlope(s) => {
                helix(z_1, Curve::Line { c: left("amount_um", s.amount_um)? / field.face_length() })
            }
            S::Twist(s) => {
                let c = left("amount_um", s.amount_um)? / (field.roll_length() * field.face_length());
                Node::Polynomial { origin: [w_m, z_m], polynomial: Polynomial2::from_terms([(1, 1, c)]) }
            }
            S::TipRelief(s) => self.relief(kind, s, left("amount_um", s.amount_um)?, tip)?,
            S::RootRelief(s) => self.relief(kind, s, left("amount_um", s.amount_um)?, root)?,
            S::EndReliefI(s) | S::EndReliefNonDatumFace(s) => {
                self.relief(kind, s, left("amount_um", s.amount_um)?, face_1)?
            }
            S::EndReliefII(s) | S::EndReliefDatumFace(s) => {
                self.relief(kind, s, left("amount_um", s.amount_um)?, face_2)?
            }
            S::TriangularEndRelief(s) => self.triangle(kind, s, left("amount_um", s.amount_um)?)?,
            S::DirectedCrowning(s) => self.directed(kind, s, left("amount_um", s.amount_um)?)?,
            S::Waviness(s) => self.waviness(kind, s)?,
            S::Polynomial(s) => polynomial(kind, s)?,
            S::Grid(s) => self.grid(kind, s)?,
            S::Points(s) => self.points(kind, s)?,
            S::HelixTraces(s) => self.traces(kind, s)?,
            S::ProfileTrace(s) => self.profile_trace(kind, s)?,
            S::Formula(s) => self.formula(kind, s)?,
            S::Sum(s) => {
                transverse_only(kind, s.reference)?;
                Node::Sum(self.children(kind, &s.children)?)
            }
            S::Product(s) => {
                transverse_only(kind, s.reference)?;
                Node::Product(self.children(kind, &s.children)?)
            }
            S::Scale(s) => {
                transverse_only(kind, s.reference)?;
                let factor = number(kind, "factor", s.factor, limits::FACTOR)?;
                Node::Scale(factor, Box::new(self.sum(kind, &s.children)?))
            }
            S::Mirror(s) => {
                transverse_only(kind, s.reference)?;
                Node::MirrorZ(Box::new(self.sum(kind, &s.children)?))
            }
        })
    }

    fn children(&mut self, kind: &str, specs: &[ModificationSpec]) -> Built<Vec<Node>> {
        if specs.is_empty() {
            return invalid(kind, "children", "an empty list", "one modification or more");
        }
        if self.depth == limits::NESTING {
            return invalid(kind, "children", "nested too deeply", format!("{} levels", limits::NESTING));
        }
        if let Some(child) = specs.iter().find(|child| child.flank() != FlankChoice::Both) {
            // Which value would a part have on the other flank: 0 in a sum, 1 in a product? Nobody should guess.
            return invalid(
                kind,
                "flank",
                format!("set on the part {:?}", child.kind()),
                "flank beside the outermost kind only",
            );
        }
        self.depth += 1;
        let nodes = specs.iter().map(|child| self.node(child)).collect();
        self.depth -= 1;
        nodes
    }

    fn sum(&mut self, kind: &str, specs: &[ModificationSpec]) -> Built<Node> {
        self.children(kind, specs).map(Node::Sum)
    }

    /// The law over R = sqrt(w^2 + r_b^2): xi = (R - R_m)/(R_a - R_m).
    fn over_radius(&self, c: f64, squared: bool) -> Curve {
        let base_radius = self.field.base_radius();
        let [w_f, w_a] = self.field.roll();
        let sum = w_f.hypot(base_radius) + w_a.hypot(base_radius);
        // R_a - R_f = (w_a^2 - w_f^2)/(R_a + R_f) doesn't cancel when r_b is large.
        let half = 0.5 * (w_a - w_f) * (w_a + w_f) / sum;
        Curve::Radius { c, squared, base_radius, middle: 0.5 * sum, inverse_half: 1.0 / half }
    }

    fn relief(&mut self, kind: &str, s: &ReliefSpec, c: f64, border: Border) -> Built<Node> {
        let length = positive(kind, "length_mm", s.length_mm)?;
        let whole = if border.along_roll { self.field.roll_length() } else { self.field.face_length() };
        self.warn_if_longer(kind, "length_mm", length, whole);
        let transition = not_negative(kind, "transition_mm", s.transition_mm)?;
        let exponent = self.exponent(kind, s.exponent, transition)?;
        let curve = if exponent == 1.0 {
            Curve::Ramp { c: c / length, h: transition }
        } else {
            Curve::Power { c, length, p: exponent }
        };
        let shift = length - border.sign * border.position;
        Ok(if border.along_roll {
            Node::Ridge { a: border.sign, b: 0.0, c: shift, curve }
        } else {
            Node::Ridge { a: 0.0, b: border.sign, c: shift, curve }
        })
    }

    fn triangle(&mut self, kind: &str, s: &TriangularSpec, c: f64) -> Built<Node> {
        let length_w = positive(kind, "length_w_mm", s.length_w_mm)?;
        let length_z = positive(kind, "length_z_mm", s.length_z_mm)?;
        self.warn_if_longer(kind, "length_w_mm", length_w, self.field.roll_length());
        self.warn_if_longer(kind, "length_z_mm", length_z, self.field.face_length());
        let transition = not_negative(kind, "transition", s.transition)?;
        let exponent = self.exponent(kind, s.exponent, transition)?;
        let ([w_f, w_a], [z_1, z_2]) = (self.field.roll(), self.field.face());
        let (a, w_c) = match s.corner_profile {
            CornerProfile::Tip => (1.0 / length_w, w_a),
            CornerProfile::Root => (-1.0 / length_w, w_f),
        };
        let (b, z_c) = if s.corner_face.is_datum() { (1.0 / length_z, z_2) } else { (-1.0 / length_z, z_1) };
        let curve = if exponent == 1.0 {
            Curve::Ramp { c, h: transition }
        } else {
            Curve::Power { c, length: 1.0, p: exponent }
        };
        Ok(Node::Ridge { a, b, c: 1.0 - a * w_c - b * z_c, curve })
    }

    fn directed(&self, kind: &str, s: &DirectedSpec, c: f64) -> Built<Node> {
        let [sin, cos] = direction(kind, s.rho_deg)?;
        let length = self.field.roll_length() * sin.abs() + self.field.face_length() * cos.abs();
        Ok(Node::Ridge {
            a: sin,
            b: cos,
            c: -(sin * self.field.roll_middle() + cos * self.field.face_middle()),
            curve: Curve::Parabola { c: 4.0 * c / (length * length) },
        })
    }

    fn waviness(&self, kind: &str, s: &WavinessSpec) -> Built<Node> {
        transverse_only(kind, s.reference)?;
        let [sin, cos] = direction(kind, s.rho_deg)?;
        let wave_number = std::f64::consts::TAU / positive(kind, "wavelength_mm", s.wavelength_mm)?;
        let amplitude = |key: &str, um: f64| number(kind, key, um, limits::AMOUNT_UM).map(|a| a * UM);
        Ok(Node::Waviness(Waviness {
            wave: [wave_number * sin, wave_number * cos],
            phase: number(kind, "phase_deg", s.phase_deg, limits::ANGLE_DEG)?.to_radians(),
            amplitudes: [
                amplitude("amp_0_um", s.amp_0_um)?,
                amplitude("amp_uu_um", s.amp_uu_um)?,
                amplitude("amp_vv_um", s.amp_vv_um)?,
            ],
            middle: [self.field.roll_middle(), self.field.face_middle()],
            inverse_half: [2.0 / self.field.roll_length(), 2.0 / self.field.face_length()],
        }))
    }

    fn grid(&self, kind: &str, s: &GridSpec) -> Built<Node> {
        transverse_only(kind, s.reference)?;
        let table =
            table(kind, s.file.as_deref(), [&s.w_mm, &s.z_mm], &s.f_um, |file| self.files.grid(file))?;
        covers(kind, "w_mm", &table.w_mm, self.field.roll())?;
        covers(kind, "z_mm", &table.z_mm, self.field.face())?;
        TensorSpline::new(&table.w_mm, &table.z_mm, &table.f)
            .map(|spline| Node::Grid(Box::new(spline)))
            .or_else(|error| not_splined(kind, &error, axis_key))
    }

    fn traces(&mut self, kind: &str, s: &HelixTracesSpec) -> Built<Node> {
        transverse_only(kind, s.reference)?;
        let Table { w_mm, z_mm, f } =
            table(kind, s.file.as_deref(), [&s.w_mm, &s.z_mm], &s.f_um, |file| self.files.traces(file))?;
        if !(2..=3).contains(&w_mm.len()) {
            return invalid(kind, "w_mm", format!("a list of {}", w_mm.len()), "2 or 3 ascending numbers");
        }
        if w_mm.windows(2).any(|pair| pair[1] - pair[0] < limits::TRACE_DISTANCE_MM) {
            let allowed = format!("ascending numbers at least {} mm apart", limits::TRACE_DISTANCE_MM);
            return invalid(kind, "w_mm", format!("{w_mm:?}"), allowed);
        }
        if f.len() != w_mm.len() {
            return invalid(
                kind,
                "f_um",
                format!("{} rows", f.len()),
                "one row per w_mm, one value per z_mm",
            );
        }
        covers(kind, "z_mm", &z_mm, self.field.face())?;
        let splines: Result<Vec<CubicSpline>, SplineError> =
            f.iter().map(|row| CubicSpline::new(&z_mm, row)).collect();
        match splines {
            Ok(splines) => {
                self.warn_if_extrapolated(kind, &w_mm);
                Ok(Node::Traces(Traces { w: w_mm, splines }))
            }
            Err(error) => not_splined(kind, &error, |_| "z_mm"),
        }
    }

    fn warn_if_extrapolated(&mut self, kind: &str, w_mm: &[f64]) {
        let ([w_f, w_a], length) = (self.field.roll(), self.field.roll_length());
        let (Some(first), Some(last)) = (w_mm.first(), w_mm.last()) else { return };
        let beyond = (first - w_f).max(w_a - last);
        if beyond > FAR_FROM_TRACES * length {
            self.warnings.push(ModificationWarning::OutsideTraces {
                kind: kind.into(),
                beyond,
                field_length: length,
            });
        }
    }

    fn formula(&self, kind: &str, s: &FormulaSpec) -> Built<Node> {
        transverse_only(kind, s.reference)?;
        let key = "f_um";
        let formula = Formula::new(&s.f_um, self.field)
            .or_else(|FormulaError { found, allowed }| invalid(kind, key, found, allowed))?;
        if let Some((w, z)) = formula.undefined_at(self.field) {
            return invalid(
                kind,
                key,
                format!("without a finite value, slope or curvature at w = {w} mm, z = {z} mm"),
                "a formula that has them at every place of the evaluation range",
            );
        }
        number(kind, key, formula.largest(self.field), limits::AMOUNT_UM)?;
        Ok(Node::Formula(Box::new(formula)))
    }

    fn points(&self, kind: &str, s: &PointsSpec) -> Built<Node> {
        transverse_only(kind, s.reference)?;
        let points = match &s.file {
            Some(file) if !s.points.is_empty() => {
                return invalid(kind, "file", format!("{file:?} beside points"), "one of the two");
            }
            Some(file) => self.files.points(file).map_err(|reason| unavailable(kind, file, reason))?,
            None => s.points.clone(),
        };
        let points = distinct(kind, points)?;
        let needed = match s.method {
            PointMethod::Linear => 3,
            PointMethod::Spline => 16,
        };
        let too_few = ModificationError::TooFewPoints { kind: kind.into(), count: points.len(), needed };
        if points.len() < needed {
            return Err(too_few);
        }
        let collinear = ModificationError::CollinearPoints { kind: kind.into(), count: points.len() };
        let surface = match s.method {
            PointMethod::Linear => None,
            PointMethod::Spline => {
                if PointCloud::new(&points, None).is_none() {
                    return Err(collinear);
                }
                Some(fit(&points).ok_or(too_few)?)
            }
        };
        PointCloud::new(&points, surface).map(|cloud| Node::Points(Box::new(cloud))).ok_or(collinear)
    }

    fn profile_trace(&self, kind: &str, s: &ProfileTraceSpec) -> Built<Node> {
        transverse_only(kind, s.reference)?;
        let mut points = match &s.file {
            Some(file) if !s.points.is_empty() => {
                return invalid(kind, "file", format!("{file:?} beside points"), "one of the two");
            }
            Some(file) => self.files.profile(file).map_err(|reason| unavailable(kind, file, reason))?,
            None => s.points.clone(),
        };
        for [w, f] in &mut points {
            *w = number(kind, "points", *w, limits::LENGTH_MM)?;
            *f = number(kind, "points", *f, limits::AMOUNT_UM)? * UM;
        }
        if points.len() < LEAST_POINTS {
            let allowed = format!("{LEAST_POINTS} points or more");
            return invalid(kind, "points", format!("a list of {}", points.len()), allowed);
        }
        let noise = match s.noise_um {
            None => None,
            Some(um) if um > 0.0 => Some(number(kind, "noise_um", um, limits::AMOUNT_UM)? * UM),
            Some(um) => return invalid(kind, "noise_um", um.to_string(), "a number above 0"),
        };
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let (w, f): (Vec<f64>, Vec<f64>) = points.into_iter().map(|[w, f]| (w, f)).unzip();
        covers(kind, "points", &w, self.field.roll())?;
        match ProfileTrace::fit(&w, &f, noise) {
            Ok(trace) => Ok(Node::ProfileTrace(Box::new(trace))),
            Err(_) => {
                let value = format!("{} points at few lengths of roll", w.len());
                invalid(kind, "points", value, "points spread over the evaluation range")
            }
        }
    }

    fn exponent(&mut self, kind: &str, exponent: f64, transition: f64) -> Built<f64> {
        if !exponent.is_finite() || !(1.0..=limits::RELIEF_EXPONENT).contains(&exponent) {
            let allowed = format!("1 to {}", limits::RELIEF_EXPONENT);
            return invalid(kind, "exponent", exponent.to_string(), allowed);
        }
        if exponent > 1.0 && transition > 0.0 {
            self.warnings.push(ModificationWarning::TransitionWithoutEffect { kind: kind.into(), exponent });
        }
        Ok(exponent)
    }

    fn warn_if_longer(&mut self, kind: &str, key: &str, length: f64, field_length: f64) {
        if length > field_length {
            self.warnings.push(ModificationWarning::ReliefLongerThanField {
                kind: kind.into(),
                key: key.into(),
                length,
                field_length,
            });
        }
    }
}

/// A table with checked numbers, values in mm.
struct Table {
    w_mm: Vec<f64>,
    z_mm: Vec<f64>,
    f: Vec<Vec<f64>>,
}

/// The table of a spec: its three lists or its file.
fn table(
    kind: &str,
    file: Option<&str>,
    [w_mm, z_mm]: [&[f64]; 2],
    f_um: &[Vec<f64>],
    read: impl FnOnce(&str) -> Result<GridTable, String>,
) -> Built<Table> {
    let given = !(w_mm.is_empty() && z_mm.is_empty() && f_um.is_empty());
    let GridTable { w_mm, z_mm, f_um: mut f } = match file {
        Some(file) if given => {
            return invalid(kind, "file", format!("{file:?} beside w_mm, z_mm, f_um"), "one of the two");
        }
        Some(file) => read(file).map_err(|reason| unavailable(kind, file, reason))?,
        None => GridTable { w_mm: w_mm.to_vec(), z_mm: z_mm.to_vec(), f_um: f_um.to_vec() },
    };
    for (key, axis) in [("w_mm", &w_mm), ("z_mm", &z_mm)] {
        for x in axis {
            number(kind, key, *x, limits::LENGTH_MM)?;
        }
    }
    for value in f.iter_mut().flatten() {
        *value = number(kind, "f_um", *value, limits::AMOUNT_UM)? * UM;
    }
    Ok(Table { w_mm, z_mm, f })
}

/// A cubic continued beyond its knots says nothing about the flank there.
fn covers(kind: &str, key: &str, knots: &[f64], [from, to]: [f64; 2]) -> Built<()> {
    let (Some(first), Some(last)) = (knots.first(), knots.last()) else { return Ok(()) };
    let slack = GRID_SLACK * (to - from);
    if *first > from + slack || *last < to - slack {
        let value = format!("{first} to {last}");
        return invalid(kind, key, value, format!("numbers that cover the evaluation range {from} to {to}"));
    }
    Ok(())
}

fn not_splined<T>(kind: &str, error: &SplineError, key: impl Fn(usize) -> &'static str) -> Built<T> {
    let (key, allowed) = match error {
        SplineError::TooFewKnots { axis, .. } => (key(*axis), "at least 4 ascending numbers"),
        SplineError::NotAscending { axis, .. } | SplineError::KnotNotFinite { axis, .. } => {
            (key(*axis), "ascending numbers")
        }
        SplineError::ShapeMismatch { .. } => ("f_um", "one row per w_mm, one value per z_mm"),
        SplineError::EmptyInterval { .. } | SplineError::EmptySpace { .. } => {
            (key(0), "numbers that span an interval")
        }
        SplineError::ValueNotFinite { .. } | SplineError::RankDeficient { .. } => {
            ("f_um", "values that don't jump between knots next to each other")
        }
    };
    invalid(kind, key, error.to_string(), allowed)
}

/// The circle through the apex and the amount `c` (mm, positive = removed) at distance `half` (mm).
fn arc(kind: &str, c: f64, half: f64) -> Built<Curve> {
    if c.abs() > half {
        return Err(ModificationError::ArcTooDeep {
            kind: kind.into(),
            amount_um: c / UM,
            limit_um: half / UM,
        });
    }
    Ok(Curve::Arc { kappa: 2.0 * c / (half * half + c * c) })
}

fn polynomial(kind: &str, s: &PolynomialSpec) -> Built<Node> {
    transverse_only(kind, s.reference)?;
    let mut terms = Vec::with_capacity(s.terms.len());
    for &(i, j, a) in &s.terms {
        if i > limits::POLYNOMIAL_EXPONENT || j > limits::POLYNOMIAL_EXPONENT {
            let allowed = format!("exponents from 0 to {}", limits::POLYNOMIAL_EXPONENT);
            return invalid(kind, "terms", format!("[{i}, {j}, {a}]"), allowed);
        }
        terms.push((i as usize, j as usize, number(kind, "terms", a, limits::FACTOR)? * UM));
    }
    let origin = [
        number(kind, "w0_mm", s.w0_mm, limits::LENGTH_MM)?,
        number(kind, "z0_mm", s.z0_mm, limits::LENGTH_MM)?,
    ];
    Ok(Node::Polynomial { origin, polynomial: Polynomial2::from_terms(terms) })
}

/// Points in mm, each place once.
fn distinct(kind: &str, points: Vec<[f64; 3]>) -> Built<Vec<[f64; 3]>> {
    let mut checked = Vec::with_capacity(points.len());
    for [w, z, f] in points {
        let w = number(kind, "points", w, limits::LENGTH_MM)?;
        let z = number(kind, "points", z, limits::LENGTH_MM)?;
        let f = number(kind, "points", f, limits::AMOUNT_UM)? * UM;
        // The triangulation refuses coordinates next to zero that no measurement means (and -0).
        let whole = |x: f64| if x.abs() < 1e-12 { 0.0 } else { x };
        checked.push([whole(w), whole(z), f]);
    }
    checked.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    for pair in checked.windows(2) {
        if pair[0][..2] == pair[1][..2] && pair[0][2] != pair[1][2] {
            let [w, z, f] = pair[0];
            let value = format!("{} um and {} um at w = {w} mm, z = {z} mm", f / UM, pair[1][2] / UM);
            return invalid(kind, "points", value, "one value at each place");
        }
    }
    checked.dedup_by(|a, b| a[..2] == b[..2]);
    Ok(checked)
}

/// The finest spline that leaves about four points for each coefficient, no finer than the places along each
/// direction, coarser where the cloud has holes.
fn fit(points: &[[f64; 3]]) -> Option<TensorSpline> {
    let share = (0.5 * (points.len() as f64).sqrt()) as usize;
    let cells = |axis: usize| share.min(places(points, axis)).saturating_sub(3).clamp(1, MOST_CELLS);
    let mut cells = [cells(0), cells(1)];
    loop {
        match fit_tensor_spline(points, cells) {
            Ok(spline) => return Some(spline),
            Err(_) if cells == [1, 1] => return None,
            Err(_) => cells = cells.map(|n| (n - 1).max(1)),
        }
    }
}

/// Number of coordinates along an axis that differ by more than a millionth of the extent.
fn places(points: &[[f64; 3]], axis: usize) -> usize {
    let mut coordinates: Vec<f64> = points.iter().map(|p| p[axis]).collect();
    coordinates.sort_by(f64::total_cmp);
    let extent = coordinates[coordinates.len() - 1] - coordinates[0];
    coordinates.dedup_by(|a, b| *a - *b <= 1e-6 * extent);
    coordinates.len()
}

/// (sin, cos) of a direction in degrees, exact at multiples of 90 degrees, so that a direction along an axis has
/// no trace of the other.
fn direction(kind: &str, rho_deg: f64) -> Built<[f64; 2]> {
    let rho = number(kind, "rho_deg", rho_deg, limits::ANGLE_DEG)?.rem_euclid(360.0);
    Ok(if rho == 0.0 || rho == 180.0 {
        [0.0, if rho == 0.0 { 1.0 } else { -1.0 }]
    } else if rho == 90.0 || rho == 270.0 {
        [if rho == 90.0 { 1.0 } else { -1.0 }, 0.0]
    } else {
        let (sin, cos) = rho_deg.to_radians().sin_cos();
        [sin, cos]
    })
}

fn axis_key(axis: usize) -> &'static str {
    ["w_mm", "z_mm"][axis.min(1)]
}

fn invalid<T>(kind: &str, key: &str, value: impl Into<String>, allowed: impl Into<String>) -> Built<T> {
    Err(ModificationError::InvalidModification {
        kind: kind.into(),
        key: key.into(),
        value: value.into(),
        allowed: allowed.into(),
    })
}

fn unavailable(kind: &str, file: &str, reason: String) -> ModificationError {
    ModificationError::FileUnavailable { kind: kind.into(), file: file.into(), reason }
}

fn number(kind: &str, key: &str, value: f64, limit: f64) -> Built<f64> {
    if value.is_finite() && value.abs() <= limit {
        Ok(value)
    } else {
        Err(ModificationError::InvalidNumber { kind: kind.into(), key: key.into(), value, limit })
    }
}

fn positive(kind: &str, key: &str, value: f64) -> Built<f64> {
    let value = number(kind, key, value, limits::LENGTH_MM)?;
    if value < limits::SHORTEST_MM {
        return invalid(kind, key, value.to_string(), format!("{:e} mm or more", limits::SHORTEST_MM));
    }
    Ok(value)
}

fn not_negative(kind: &str, key: &str, value: f64) -> Built<f64> {
    let value = number(kind, key, value, limits::LENGTH_MM)?;
    if value < 0.0 { invalid(kind, key, value.to_string(), "0 or more") } else { Ok(value) }
}

/// A position between two borders, far enough from both to be divided by its distance.
fn inside(kind: &str, key: &str, value: f64, [low, high]: [f64; 2]) -> Built<f64> {
    let value = number(kind, key, value, limits::LENGTH_MM)?;
    if value - low < limits::SHORTEST_MM || high - value < limits::SHORTEST_MM {
        return invalid(kind, key, value.to_string(), format!("between {low} and {high} mm"));
    }
    Ok(value)
}

/// Kinds without an `amount_*` have nothing that `reference = "normal"` could divide: asking for it is refused
/// rather than ignored.
fn transverse_only(kind: &str, reference: Reference) -> Built<()> {
    match reference {
        Reference::Transverse => Ok(()),
        Reference::Normal => invalid(kind, "reference", "normal", "transverse (this kind has no amount_*)"),
    }
}
