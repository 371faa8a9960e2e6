//! Sizes, judged quantities and warnings.

use super::Filling;
use crate::page::sheet::{SheetFoot, SheetSize, SheetValue};
use crate::workflow::result::class_in_words;
use measured_files::inspection::{Circle, Size};
use metrology::inspection::{TeethSummary, ToleranceQuantity};
use report::charts::{format_fixed, format_significant};

impl Filling<'_> {
    pub(super) fn foot(&self, undrawn: Vec<String>) -> SheetFoot {
        SheetFoot {
            sizes: self.sizes(),
            results: self.results(),
            overall: self.overall(),
            warnings: self.warnings(undrawn),
        }
    }

    fn sizes(&self) -> Vec<SheetSize> {
        let thickness = &self.inspection.thickness;
        let teeth = thickness.span_teeth.map_or_else(String::new, |k| format!(", k = {k}"));
        let ball = thickness.ball_diameter_mm;
        let ball = ball.map_or_else(String::new, |d| format!(", ball {} mm", format_significant(d, 5)));
        let mut sizes: Vec<SheetSize> = Vec::new();
        let mut add = |name: String, size: Option<Size>| {
            sizes.extend(size.map(|size| SheetSize {
                name,
                mean_mm: size.mean_mm,
                least_mm: size.least_mm,
                largest_mm: size.largest_mm,
            }));
        };
        add(format!("W_k{teeth}"), thickness.span);
        add(format!("M_dK{ball}"), thickness.over_balls);
        let circles = &self.inspection.circles;
        add(circle_name("root circle", circles.root.as_ref()), circles.root.as_ref().and_then(spread));
        add(circle_name("tip circle", circles.tip.as_ref()), circles.tip.as_ref().and_then(spread));
        sizes
    }

    /// The worst value of each quantity.
    fn results(&self) -> Vec<SheetValue> {
        let of = |quantity: ToleranceQuantity| {
            let values = self.gear.judged.iter().filter(|of| of.quantity == quantity).map(|of| of.value);
            let worst = values.reduce(|a, b| if b.abs() > a.abs() { b } else { a })?;
            Some(self.judged(symbol(quantity), quantity, Some(worst)))
        };
        ToleranceQuantity::ALL.into_iter().filter_map(of).collect()
    }

    fn overall(&self) -> String {
        let Some(classes) = self.gear.classes.as_ref().filter(|classes| !classes.each.is_empty()) else {
            return String::new();
        };
        let reached = class_in_words(classes.overall);
        match self.options.tolerance_class {
            None if self.gear.is_whole(self.inspection) => format!("worst class {reached}"),
            None => format!("worst class {reached}, of what could be evaluated"),
            Some(wanted) => {
                let kept = classes.overall.is_some_and(|class| class <= wanted);
                let verdict = match (kept, self.gear.is_whole(self.inspection)) {
                    (true, true) => "kept",
                    (true, false) => "kept as far as evaluated",
                    (false, _) => "EXCEEDED",
                };
                format!("class {wanted} {verdict}, worst class {reached}")
            }
        }
    }

    fn warnings(&self, undrawn: Vec<String>) -> Vec<String> {
        let read = self.inspection.warnings.iter().map(|warning| {
            let line = warning.line.map_or_else(String::new, |line| format!("line {line}: "));
            line + &warning.message
        });
        let left_out =
            self.gear.left_out.0.iter().map(|(what, error)| format!("{what}: not evaluated, {error}"));
        let doubts = [
            self.gear.thickness.warning.as_ref(),
            self.gear.pitch.as_ref().and_then(|pitch| pitch.run_out.as_ref()?.warning.as_ref()),
        ];
        let doubts = doubts.into_iter().flatten().map(ToString::to_string);
        read.chain(left_out).chain(doubts).chain(undrawn).collect()
    }
}

fn symbol(quantity: ToleranceQuantity) -> &'static str {
    match quantity {
        ToleranceQuantity::SinglePitch => "f_p",
        ToleranceQuantity::TotalPitch => "F_p",
        ToleranceQuantity::ProfileSlope => "f_Hα mean",
        ToleranceQuantity::ProfileForm => "f_fα",
        ToleranceQuantity::ProfileTotal => "F_α",
        ToleranceQuantity::HelixSlope => "f_Hβ mean",
        ToleranceQuantity::HelixForm => "f_fβ",
        ToleranceQuantity::HelixTotal => "F_β",
        ToleranceQuantity::RunOut => "F_r",
        ToleranceQuantity::NeighbouringPitch => "f_u",
        ToleranceQuantity::SectorPitch => "F_pz8",
    }
}

fn circle_name(word: &str, circle: Option<&Circle>) -> String {
    circle.map_or_else(|| word.to_owned(), |c| format!("{word}, z {} mm", format_fixed(c.z_mm, 2)))
}

/// Mean, least and largest of the diameters that were measured.
fn spread(circle: &Circle) -> Option<Size> {
    let measured: Vec<f64> = circle.diameters_mm.iter().copied().filter(|d| d.is_finite()).collect();
    let of = TeethSummary::of(&measured).ok()?;
    Some(Size { mean_mm: Some(of.mean), least_mm: Some(of.least), largest_mm: Some(of.greatest) })
}
