//! Closed curves around a body of revolution: values in all directions about a circle of zero.

use super::axes::{Frame, TICK_SIZE};
use super::error::{ChartError, check_count, check_values};
use super::line_marks::{draw_marker, draw_ring, draw_rings, marked};
use super::palette::{FAINT, INK, series_style};
use super::scale::Axis;
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::text::text_width;

/// A polar chart. Directions count from the top, counter-clockwise, deg.
#[derive(Clone, Debug, PartialEq)]
pub struct PolarChart {
    /// Heading.
    pub title: String,
    /// Line below it, for example from where the view is.
    pub subtitle: String,
    /// Quantity and unit of the distance from the circle of zero, for example `deviation [µm]`.
    pub value_title: String,
    /// Smallest span of the values: noise below it stays a circle. 0 = no limit.
    pub least_span: f64,
    /// Directions that are named at the rim.
    pub spokes: Vec<(f64, String)>,
    /// The curves.
    pub curves: Vec<PolarCurve>,
    /// Places [direction, value] with a ring and a text; the name of the first is that of all in the legend.
    pub rings: Vec<([f64; 2], String)>,
    /// What the rings mean.
    pub rings_name: String,
    /// Lines of text beside the chart.
    pub remarks: Vec<String>,
}

/// A curve, closed from its last point to its first.
#[derive(Clone, Debug, PartialEq)]
pub struct PolarCurve {
    /// Name in the legend.
    pub name: String,
    /// [direction in deg, value].
    pub points: Vec<[f64; 2]>,
    /// Whether it carries markers; a smooth curve does not.
    pub marked: bool,
}

const WIDTH: f64 = 880.0;
const TOP: f64 = 52.0;
const RADIUS: f64 = 206.0;
/// Radius of the least value, as a share of the greatest.
const INNER: f64 = 0.25;
/// Room about the rim for the names of the spokes.
const RIM: f64 = 26.0;
/// Where the column beside the chart begins, and the height of its rows.
const ASIDE: f64 = 540.0;
const ROW: f64 = 20.0;
const LEGEND_LINE: f64 = 40.0;
const SMALL: f64 = 11.0;

/// Draws curves about a circle of zero.
///
/// # Errors
/// [`ChartError`] without curves, for a curve of fewer than three points, and for values that are not finite.
pub fn polar_chart(chart: &PolarChart) -> Result<Svg, ChartError> {
    check(chart)?;
    let values = chart.curves.iter().flat_map(|curve| &curve.points).map(|p| p[1]).chain([0.0]);
    let (lo, hi) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v), hi.max(v)));
    let field = Field {
        centre: [RIM + 14.0 + RADIUS, TOP + RIM + RADIUS],
        axis: Axis::rounded(lo, hi, 5, chart.least_span),
    };
    let rows = (chart.curves.len() + chart.remarks.len() + 4) as f64;
    let height = (TOP + 2.0 * (RIM + RADIUS) + 6.0).max(TOP + rows * ROW);
    let mut canvas = Canvas::new(WIDTH, height, &chart.title);
    canvas.heading(&chart.subtitle);
    field.draw_net(&mut canvas, &chart.spokes);
    for (k, curve) in chart.curves.iter().enumerate() {
        field.draw_curve(&mut canvas, k, curve);
    }
    field.draw_values(&mut canvas);
    let [x, y] = field.centre;
    let frame = Frame { left: x - RADIUS, top: y - RADIUS, width: 2.0 * RADIUS, height: 2.0 * RADIUS };
    let places: Vec<[f64; 2]> = chart.rings.iter().map(|(p, _)| field.place(p)).collect();
    let texts: Vec<String> = chart.rings.iter().map(|(_, text)| text.clone()).collect();
    draw_rings(&mut canvas, &frame, &places, &texts);
    draw_column(&mut canvas, chart);
    Ok(canvas.finish())
}

fn check(chart: &PolarChart) -> Result<(), ChartError> {
    check_count(&chart.title, chart.curves.len(), 1)?;
    check_values(&chart.value_title, &[chart.least_span])?;
    for curve in &chart.curves {
        check_count(&curve.name, curve.points.len(), 3)?;
        check_values(&curve.name, curve.points.as_flattened())?;
    }
    for (direction, name) in &chart.spokes {
        check_values(&format!("direction {name}"), &[*direction])?;
    }
    chart.rings.iter().try_for_each(|(place, text)| check_values(&format!("place {text}"), place))
}

/// The circle that is drawn in.
struct Field {
    centre: [f64; 2],
    axis: Axis,
}

impl Field {
    fn radius(&self, share: f64) -> f64 {
        RADIUS * (INNER + (1.0 - INNER) * share)
    }

    fn at(&self, degrees: f64, radius: f64) -> [f64; 2] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [self.centre[0] - radius * sin, self.centre[1] - radius * cos]
    }

    fn place(&self, [degrees, value]: &[f64; 2]) -> [f64; 2] {
        self.at(*degrees, self.radius(self.axis.share(*value)))
    }

    fn draw_net(&self, canvas: &mut Canvas, spokes: &[(f64, String)]) {
        for (share, _) in self.axis.ticks() {
            canvas.disc(self.centre, self.radius(share), "none", Stroke::solid(FAINT, 0.7));
        }
        for (degrees, name) in spokes {
            let ends = [self.at(*degrees, RADIUS * INNER), self.at(*degrees, RADIUS + 4.0)];
            canvas.line(ends[0], ends[1], Stroke::solid(FAINT, 0.8));
            let [x, y] = self.at(*degrees, RADIUS + 16.0);
            canvas.text([x, y + 4.2], name, TextStyle::new(TICK_SIZE, Anchor::Middle));
        }
        canvas.disc(self.centre, RADIUS, "none", Stroke::solid(INK, 0.9));
        canvas.disc(self.centre, self.radius(self.axis.share(0.0)), "none", Stroke::solid(INK, 1.6));
    }

    fn draw_curve(&self, canvas: &mut Canvas, number: usize, curve: &PolarCurve) {
        let style = series_style(number);
        let mut places: Vec<[f64; 2]> = curve.points.iter().map(|p| self.place(p)).collect();
        let markers = if curve.marked { marked(places.len(), number) } else { Vec::new() };
        let at: Vec<[f64; 2]> = markers.into_iter().map(|k| places[k]).collect();
        places.extend(places.first().copied());
        canvas.polylines(&[places], Stroke { color: style.color, width: 1.8, dash: style.dash });
        at.into_iter().for_each(|at| draw_marker(canvas, at, &style, None));
    }

    /// Values of the circles, to the right of the centre, over the curves.
    fn draw_values(&self, canvas: &mut Canvas) {
        for (share, label) in self.axis.ticks() {
            let [x, y] = [self.centre[0] + self.radius(share), self.centre[1]];
            let style = TextStyle::new(SMALL, Anchor::Middle).halo();
            let style = if label == "0" { style.bold() } else { style };
            canvas.text([x, y + 4.0], &label, style);
        }
    }
}

/// What the circles count, the legend and the remarks, beside the chart.
fn draw_column(canvas: &mut Canvas, chart: &PolarChart) {
    let plain = TextStyle::new(TICK_SIZE, Anchor::Start);
    let mut y = TOP + RIM + 6.0;
    canvas.text([ASIDE, y], &chart.value_title, plain.bold());
    y += ROW;
    canvas.line([ASIDE, y - 4.2], [ASIDE + 34.0, y - 4.2], Stroke::solid(INK, 1.6));
    canvas.text([ASIDE + LEGEND_LINE, y], "zero; outside it > 0", plain);
    for (k, curve) in chart.curves.iter().enumerate() {
        y += ROW;
        let style = series_style(k);
        let stroke = Stroke { color: style.color, width: 1.8, dash: style.dash };
        canvas.line([ASIDE, y - 4.2], [ASIDE + 34.0, y - 4.2], stroke);
        if curve.marked {
            draw_marker(canvas, [ASIDE + 17.0, y - 4.2], &style, None);
        }
        canvas.text([ASIDE + LEGEND_LINE, y], &curve.name, plain);
    }
    if !chart.rings.is_empty() {
        y += ROW;
        draw_ring(canvas, [ASIDE + 17.0, y - 4.2]);
        canvas.text([ASIDE + LEGEND_LINE, y], &chart.rings_name, plain);
    }
    y += 0.5 * ROW;
    for remark in &chart.remarks {
        for line in wrapped(remark, WIDTH - ASIDE) {
            y += 0.85 * ROW;
            canvas.text([ASIDE, y], &line, plain);
        }
    }
}

/// A text in lines no wider than `room`, as far as its words allow.
fn wrapped(text: &str, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if text_width(&format!("{line} {word}"), TICK_SIZE) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(values: &[f64]) -> PolarChart {
        let turn = 360.0 / values.len() as f64;
        PolarChart {
            title: "Concentricity".into(),
            subtitle: String::new(),
            value_title: "deviation [µm]".into(),
            least_span: 0.0,
            spokes: vec![(0.0, "0".into()), (90.0, "10".into())],
            curves: vec![PolarCurve {
                name: "centre".into(),
                points: values.iter().enumerate().map(|(k, v)| [k as f64 * turn, *v]).collect(),
                marked: true,
            }],
            rings: vec![([90.0, values[1]], "tooth 10".into())],
            rings_name: "outlier".into(),
            remarks: vec!["eccentricity 9.4 µm".into()],
        }
    }

    #[test]
    fn values_go_outwards_counter_clockwise_from_the_top() {
        let field = Field { centre: [0.0, 0.0], axis: Axis::rounded(-10.0, 10.0, 4, 0.0) };
        let [x, y] = field.place(&[0.0, 10.0]);
        assert!(x.abs() < 1e-9 && (y + RADIUS).abs() < 1e-9, "{x} {y}");
        let [x, y] = field.place(&[90.0, -10.0]);
        assert!((x + INNER * RADIUS).abs() < 1e-9 && y.abs() < 1e-9, "{x} {y}");
    }

    #[test]
    fn names_circles_curves_and_rings() {
        let text = polar_chart(&chart(&[5.0, -3.0, 2.0, 0.0])).unwrap().to_string();
        for part in ["Concentricity", "deviation [µm]", "centre", "tooth 10", "outlier", "9.4 µm", ">−2<"]
        {
            assert!(text.contains(part), "{part} in {text}");
        }
    }

    #[test]
    fn refuses_what_is_no_number_and_what_is_no_curve() {
        let error = polar_chart(&chart(&[5.0, f64::NAN, 2.0])).unwrap_err();
        assert_eq!(error.code(), "invalid-number");
        assert!(error.to_string().contains("centre"), "{error}");
        assert_eq!(polar_chart(&chart(&[5.0, 1.0])).unwrap_err().code(), "too-few-values");
    }

    #[test]
    fn long_remarks_are_broken_between_words() {
        let lines = wrapped("one two three four five six seven", text_width("one two three", TICK_SIZE));
        assert_eq!(lines[0], "one two three");
        assert_eq!(lines.join(" "), "one two three four five six seven");
    }
}
