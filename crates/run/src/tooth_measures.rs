//! How the thickness of teeth is measured: the span and the balls of the drawing, else those that touch the middle of the flank.

use super::gear::blank_of_job;
use foundation::geometry::{Blank, Gear, OverBalls, Span};
use job::tables::Gear as JobGear;
use report::{Quantity, Sheet};

/// Ball diameter in normal modules that touches near the pitch cylinder of common gears.
const BALL_FACTOR: f64 = 1.728;

/// Teeth spanned and diameter of the balls; each `None` where the gear has no such measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToothMeasures {
    /// Teeth (internal: spaces) spanned.
    pub span_teeth: Option<u32>,
    /// Diameter of the balls, mm.
    pub ball: Option<f64>,
}

impl ToothMeasures {
    /// For a gear and its drawing, whose own measure goes first: it is what the shop will measure.
    pub fn of(drawing: &JobGear, gear: &Gear) -> Self {
        let blank = blank_of_job(drawing);
        let drawn = drawing.span.as_ref().filter(|span| gear.span(span.teeth).is_ok()).map(|span| span.teeth);
        let ball = drawing.over_balls.as_ref().map(|balls| balls.ball);
        let touches = |diameter: &f64| {
            let balls = gear.over_balls(*diameter, 0.0).ok();
            balls.is_some_and(|balls| ball.is_some() || blank.check_balls(gear, &balls).is_ok())
        };
        Self {
            span_teeth: drawn.or_else(|| best_span(gear, &blank)),
            ball: Some(ball.unwrap_or(BALL_FACTOR * gear.data().normal_module)).filter(touches),
        }
    }

    /// The span of a gear.
    pub fn span(&self, gear: &Gear) -> Option<Span> {
        gear.span(self.span_teeth?).ok()
    }

    /// The measure over balls of a gear.
    pub fn over_balls(&self, gear: &Gear) -> Option<OverBalls> {
        gear.over_balls(self.ball?, 0.0).ok()
    }

    /// Tooth thickness and its measures for the first page: of the finished gear, and before, where the stock is known.
    pub fn sheet(&self, finished: &Gear, before: Option<&Gear>) -> Sheet {
        let mut list = Vec::new();
        let mut row = |name: &str, symbol: &str, of: &dyn Fn(&Gear) -> Option<f64>| {
            let before = before.and_then(of);
            let Some(after) = of(finished) else { return };
            match before {
                Some(before) => {
                    list.push(Quantity::rounded(&format!("{name}, before"), symbol, before, 3, "mm"));
                    list.push(Quantity::rounded(&format!("{name}, finished"), symbol, after, 3, "mm"));
                }
                None => list.push(Quantity::rounded(&format!("{name}, finished"), symbol, after, 3, "mm")),
            }
        };
        if let Some(teeth) = self.span_teeth {
            row(&format!("span over {teeth} teeth"), "W_k", &|gear| Some(self.span(gear)?.length));
        }
        if let Some(ball) = self.ball {
            let name = if finished.external_sign() > 0.0 { "size over balls" } else { "size between balls" };
            let ball = report::charts::format_significant(ball, 5);
            row(&format!("{name} {ball} mm"), "M_dK", &|gear| Some(self.over_balls(gear)?.size));
        }
        row("normal tooth thickness", "s_n", &|gear| {
            let arc = gear.transverse_thickness(gear.pitch_radius(), 0.0).ok()?;
            gear.is_cylindrical().then(|| arc * gear.data().helix_angle.cos())
        });
        let sheet = Sheet::new("Tooth thickness", list);
        match before {
            Some(_) => sheet,
            None => sheet.remark("Before machining: not known, the job gives no stock."),
        }
    }
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
