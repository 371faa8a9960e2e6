//! What a line chart shows: panels of lines over a common abscissa, with their marks.

/// A chart of lines.
#[derive(Clone, Debug, PartialEq)]
pub struct LineChart {
    /// Heading of the chart.
    pub title: String,
    /// Quantity and unit of the abscissa, for example `z_V2 [mm]`.
    pub x_title: String,
    /// Panels from top to bottom; all share the abscissa.
    pub panels: Vec<Panel>,
}

/// One quantity of a line chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Quantity and unit, for example `Δd [µm]`.
    pub y_title: String,
    /// Smallest span of the ordinate in its unit: noise below it stays a flat line. 0 = no limit.
    pub least_span: f64,
    /// Linear or logarithmic ordinate.
    pub scale: YScale,
    /// Lines; equal names in different panels share style and legend entry.
    pub series: Vec<Series>,
}

impl Panel {
    /// A panel with a linear ordinate.
    pub fn linear(y_title: impl Into<String>, least_span: f64, series: Vec<Series>) -> Self {
        Self { y_title: y_title.into(), least_span, scale: YScale::Linear, series }
    }
}

/// Scale of an ordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum YScale {
    /// Equal steps.
    Linear,
    /// Decades; values that are not positive are drawn at the lower edge.
    Logarithmic,
}

/// One line.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Abscissae.
    pub x: Vec<f64>,
    /// Ordinates, as many as abscissae.
    pub y: Vec<f64>,
    /// What is drawn at its points.
    pub marks: Marks,
}

/// What a line shows at its points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Marks {
    /// A marker at a few of them, so that the line stays visible.
    Few,
    /// A marker at each, filled or open; as many as points.
    Each(Vec<bool>),
    /// A marker at each, and no line between them.
    Points,
    /// None, though the line has a style of its own.
    Bare,
    /// None: the line is a level that others are compared with, thin and solid.
    Level,
    /// None: the line is a limit of others, thin and dashed.
    Limit,
    /// A bar from zero to each, and no line between them.
    Bars,
    /// A text at each, no line between them and no place in the legend; as many as points.
    Texts(Vec<String>),
    /// A ring about each and a text beside it, and no line between them; as many as points. Texts that find no room are left out.
    Rings(Vec<String>),
}

impl Series {
    /// A line through the points (x, y).
    pub fn new(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, marks: Marks::Few }
    }

    /// With a marker at every point, filled or open.
    pub fn marked(self, filled: Vec<bool>) -> Self {
        Self { marks: Marks::Each(filled), ..self }
    }

    /// Without markers.
    pub fn bare(self) -> Self {
        Self { marks: Marks::Bare, ..self }
    }

    /// Points (x, y) that nothing joins.
    pub fn points(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, marks: Marks::Points }
    }

    /// A level over a range of the abscissa that other lines are compared with.
    pub fn level(name: impl Into<String>, x: [f64; 2], y: f64) -> Self {
        Self { name: name.into(), x: x.to_vec(), y: vec![y; 2], marks: Marks::Level }
    }

    /// A limit that others keep to or leave, through the points (x, y).
    pub fn limit(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, marks: Marks::Limit }
    }

    /// Bars from zero to the points (x, y).
    pub fn bars(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, marks: Marks::Bars }
    }

    /// Rings about points [x, y] of other lines, each with its text.
    pub fn rings(name: impl Into<String>, points: Vec<([f64; 2], String)>) -> Self {
        let (at, texts): (Vec<[f64; 2]>, Vec<String>) = points.into_iter().unzip();
        let [x, y] = [0, 1].map(|k| at.iter().map(|at| at[k]).collect());
        Self { name: name.into(), x, y, marks: Marks::Rings(texts) }
    }

    /// Texts centred at points [x, y]; the name is for errors only.
    pub fn texts(name: impl Into<String>, points: Vec<([f64; 2], String)>) -> Self {
        let Self { name, x, y, marks } = Self::rings(name, points);
        let marks = if let Marks::Rings(texts) = marks { Marks::Texts(texts) } else { marks };
        Self { name, x, y, marks }
    }
}

/// How the panels of a line chart are laid out where the usual way does not serve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineFrame {
    /// Height of a panel, points; the usual one depends on the number of panels.
    pub panel_height: Option<f64>,
    /// Room beside the first and the last abscissa, in units of the abscissa.
    pub beside: f64,
}
