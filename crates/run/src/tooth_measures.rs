//! How the thickness of teeth is measured: the span and the balls of the drawing, else those that touch the middle of the flank.

use super::drawing::{ToleranceResult, tolerances};
use super::finding::geometry_finding;
use super::gear::blank_of_job;
use foundation::geometry::{Blank, Gear, GeometryError, OverBalls, OverRolls, Span};
use job::tables::Gear as JobGear;
use job::{Diagnostic, Problem, shown_number};
use report::{Quantity, Sheet};

/// Ball diameter in normal modules that touches near the pitch cylinder of common gears.
const BALL_FACTOR: f64 = 1.728;

/// Teeth spanned and diameters of balls and rolls; each `None` where the gear has no such measure.
#[derive(Clone, Debug, PartialEq)]
pub struct ToothMeasures {
    /// Teeth (internal: spaces) spanned.
    pub span_teeth: Option<u32>,
    /// Diameter of the balls, mm.
    pub ball: Option<f64>,
    /// Diameter of the rolls, mm; none where the drawing names none.
    pub roll: Option<f64>,
    /// The gears at the lower and upper allowance of the drawing's measure.
    pub limits: Option<[Gear; 2]>,
    /// Tolerances of the drawing's class.
    pub tolerances: Option<ToleranceResult>,
}

impl ToothMeasures {
    /// For a gear and its drawing, whose own measures go first: they are what the shop will measure.
    ///
    /// # Errors
    /// A finding on `gear.measured_over` for a span, balls or rolls that this gear cannot be measured with; on `gear.allowances_um` for
    /// allowances that make no gear; on `gear.tolerance_class` for a gear outside the standard.
    pub fn of(drawing: &JobGear, gear: &Gear) -> Result<Self, Diagnostic> {
        let blank = blank_of_job(drawing);
        let wanted = drawing.measured_over.unwrap_or_default();
        if let Some(teeth) = wanted.span_teeth {
            let checked = gear.span(teeth).and_then(|span| blank.check_span(gear, &span));
            checked.map_err(|e| of_measure("span_teeth", teeth.to_string(), &e))?;
        }
        if let Some(ball) = wanted.ball_diameter {
            let checked = gear.over_balls(ball, 0.0).and_then(|balls| blank.check_balls(gear, &balls));
            checked.map_err(|e| of_measure("ball_diameter", shown_number(ball), &e))?;
        }
        if let Some(roll) = wanted.roll_diameter {
            check_roll(drawing, gear, roll)?;
        }
        let drawn = drawing.span.as_ref().filter(|span| gear.span(span.teeth).is_ok()).map(|span| span.teeth);
        let ball = wanted.ball_diameter.or(drawing.over_balls.as_ref().map(|balls| balls.ball));
        let touches = |diameter: &f64| {
            let balls = gear.over_balls(*diameter, 0.0).ok();
            balls.is_some_and(|balls| ball.is_some() || blank.check_balls(gear, &balls).is_ok())
        };
        let limits = drawing.limits().map_err(|e| {
            let finding = geometry_finding(&e, "gear");
            finding
                .field("gear.allowances_um")
                .way_out("compare the allowances with the drawing: they are in um")
        })?;
        Ok(Self {
            span_teeth: wanted.span_teeth.or(drawn).or_else(|| best_span(gear, &blank)),
            ball: Some(ball.unwrap_or(BALL_FACTOR * gear.data().normal_module)).filter(touches),
            roll: wanted.roll_diameter,
            limits,
            tolerances: tolerances(drawing, gear)?,
        })
    }

    /// The size over rolls of a gear.
    pub fn over_rolls(&self, gear: &Gear) -> Option<OverRolls> {
        gear.over_rolls(self.roll?).ok()
    }

    /// Normal tooth thickness on the pitch cylinder, mm; none of a conical gear.
    pub fn normal_thickness(gear: &Gear) -> Option<f64> {
        let arc = gear.transverse_thickness(gear.pitch_radius(), 0.0).ok()?;
        gear.is_cylindrical().then(|| arc * gear.data().helix_angle.cos())
    }

    /// Least and greatest of a measure between the allowances of the drawing.
    pub fn between(&self, of: impl Fn(&Gear) -> Option<f64>) -> Option<[f64; 2]> {
        let [lower, upper] = self.limits.as_ref()?;
        let (a, b) = (of(lower)?, of(upper)?);
        Some([a.min(b), a.max(b)])
    }

    /// The span of a gear.
    pub fn span(&self, gear: &Gear) -> Option<Span> {
        gear.span(self.span_teeth?).ok()
    }

    /// The measure over balls of a gear.
    pub fn over_balls(&self, gear: &Gear) -> Option<OverBalls> {
        gear.over_balls(self.ball?, 0.0).ok()
    }

    /// Tooth thickness and its measures for the first page: of the finished gear, its limits, and before, where the stock is known.
    pub fn sheet(&self, finished: &Gear, before: Option<&Gear>) -> Sheet {
        let mut list = Vec::new();
        let mut row = |name: &str, symbol: &str, of: &dyn Fn(&Gear) -> Option<f64>| {
            let before = before.and_then(of);
            let Some(after) = of(finished) else { return };
            let mut add = |which: &str, value: f64| {
                list.push(Quantity::rounded(&format!("{name}, {which}"), symbol, value, 3, "mm"));
            };
            if let Some(before) = before {
                add("before", before);
            }
            add("finished", after);
            if let Some([least, greatest]) = self.between(of) {
                add("least", least);
                add("greatest", greatest);
            }
        };
        if let Some(teeth) = self.span_teeth {
            row(&format!("span over {teeth} teeth"), "W_k", &|gear| Some(self.span(gear)?.length));
        }
        let external = finished.external_sign() > 0.0;
        let shown = |diameter: f64| report::charts::format_significant(diameter, 5);
        if let Some(ball) = self.ball {
            let name = if external { "size over balls" } else { "size between balls" };
            row(&format!("{name} {} mm", shown(ball)), "M_dK", &|gear| Some(self.over_balls(gear)?.size));
        }
        if let Some(roll) = self.roll {
            let name = if external { "size over rolls" } else { "size between rolls" };
            row(&format!("{name} {} mm", shown(roll)), "M_dR", &|gear| Some(self.over_rolls(gear)?.size));
        }
        row("normal tooth thickness", "s_n", &Self::normal_thickness);
        let sheet = Sheet::new("Tooth thickness", list);
        match before {
            Some(_) => sheet,
            None => sheet.remark("Before machining: not known, the job gives no stock."),
        }
    }
}

/// A measure that the job asks for and the gear does not have.
fn of_measure(key: &str, value: String, error: &GeometryError) -> Diagnostic {
    Diagnostic::of(error).field(format!("gear.measured_over.{key}")).value(value)
}

/// Rolls touch the usable flank, and those of an odd helical gear lie opposite each other on the face width.
fn check_roll(drawing: &JobGear, gear: &Gear, roll: f64) -> Result<(), Diagnostic> {
    let refused = |error: &GeometryError| of_measure("roll_diameter", shown_number(roll), error);
    let rolls = gear.over_rolls(roll).map_err(|e| refused(&e))?;
    let balls = gear.over_balls(roll, 0.0).map_err(|e| refused(&e))?;
    blank_of_job(drawing).check_balls(gear, &balls).map_err(|e| refused(&e))?;
    if rolls.least_face_width <= drawing.face_width {
        return Ok(());
    }
    let message = format!(
        "two rolls cannot lie opposite each other: an odd number of helical teeth needs {:.2} mm of face width for it",
        rolls.least_face_width
    );
    Err(Diagnostic::new(Problem::InvalidGeometry, message)
        .field("gear.measured_over.roll_diameter")
        .value(shown_number(roll))
        .allowed(format!("a face width of {:.2} mm or more", rolls.least_face_width))
        .way_out("measure over balls (gear.measured_over.ball_diameter)"))
}

/// The span whose contact lies nearest to the middle of the usable flank.
fn best_span(gear: &Gear, blank: &Blank) -> Option<u32> {
    let middle = 0.25 * (blank.form_diameter + blank.tip_form_diameter);
    let teeth = gear.data().teeth.unsigned_abs();
    (1..=teeth)
        .filter_map(|k| gear.span(k).ok())
        .filter(|span| blank.check_span(gear, span).is_ok())
        .min_by(|a, b| (a.contact_radius - middle).abs().total_cmp(&(b.contact_radius - middle).abs()))
        .map(|span| span.teeth)
}
