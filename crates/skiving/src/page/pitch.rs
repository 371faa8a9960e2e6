//! Concentricity around the tool and pitch over its teeth.

use super::UncertainFigure;
use report::cells::{fixed, significant, significant_or_none};
use report::charts::{
    ChartError, LineChart, LineFrame, Panel, PolarChart, PolarCurve, Series, Svg, check_length,
    format_significant, line_chart_in, polar_chart,
};
use report::data::{Block, Column, Figure, Table};

/// Pitch and concentricity at one track, tooth by tooth.
#[derive(Clone, Debug, PartialEq)]
pub struct PitchView {
    /// Radius that angles are turned into lengths with, mm.
    pub radius_mm: f64,
    /// f_p,k: from each tooth to the next, um.
    pub single_um: Vec<f64>,
    /// F_p,k: from tooth 0 to each, um.
    pub cumulative_um: Vec<f64>,
    /// Deviation of each tooth's centre, um.
    pub centre_um: Vec<f64>,
    /// Cosine and sine part of the centres' first harmonic, um.
    pub harmonic_um: [f64; 2],
    /// Outlier teeth.
    pub outliers: Vec<usize>,
    /// F_p, f_p,max, eccentricity, wobble and what else there is.
    pub figures: Vec<UncertainFigure>,
}

/// Smallest span of the values, um.
const LEAST_UM: f64 = 1.0;
const TALL: f64 = 130.0;
/// Points of the smooth curve.
const SMOOTH: usize = 180;
/// Directions with a number, about.
const SPOKES: usize = 12;

impl PitchView {
    /// The polar chart.
    pub(super) fn concentricity(&self) -> Result<Vec<Block>, ChartError> {
        self.check()?;
        let caption = "Seen on the rake face. A circle of the first harmonic beside the circle of zero is an eccentric tool; what is left is pitch.";
        Ok(vec![Block::Figure(Figure::new(
            "pitch-and-concentricity-around-the-tool",
            self.polar()?,
            caption,
        ))])
    }

    /// Bars and line over the teeth, and the figures.
    pub(super) fn pitch(&self) -> Result<Vec<Block>, ChartError> {
        self.check()?;
        let caption = format!(
            "At the radius {} mm. Single pitch k goes from tooth k to the next; cumulative pitch counts from tooth 0.",
            fixed("radius of the pitch", self.radius_mm, 4)?
        );
        let mut blocks =
            vec![Block::Figure(Figure::new("pitch-over-the-teeth", self.over_teeth()?, caption))];
        if !self.figures.is_empty() {
            blocks.push(Block::Table(figures_table(&self.figures)?));
        }
        Ok(blocks)
    }

    fn check(&self) -> Result<(), ChartError> {
        let teeth = self.cumulative_um.len();
        check_length("single pitch", teeth, self.single_um.len())?;
        check_length("tooth centres", teeth, self.centre_um.len())
    }

    fn direction(&self, tooth: usize) -> f64 {
        360.0 * tooth as f64 / self.cumulative_um.len() as f64
    }

    fn polar(&self) -> Result<Svg, ChartError> {
        let curve = |name: &str, values: &[f64]| PolarCurve {
            name: name.into(),
            points: values.iter().enumerate().map(|(tooth, um)| [self.direction(tooth), *um]).collect(),
            marked: true,
        };
        let [cosine, sine] = self.harmonic_um;
        let wave = |k: usize| {
            let degrees = 360.0 * k as f64 / SMOOTH as f64;
            let (s, c) = degrees.to_radians().sin_cos();
            [degrees, cosine * c + sine * s]
        };
        let teeth = self.cumulative_um.len();
        let step = teeth.div_ceil(SPOKES).max(1);
        // The last number keeps its distance from the first.
        let numbered = (0..teeth).step_by(step).filter(|tooth| *tooth == 0 || 2 * (teeth - tooth) > step);
        let ring = |tooth: &usize| {
            let um = self.centre_um.get(*tooth)?;
            Some(([self.direction(*tooth), *um], format!("tooth {tooth}")))
        };
        let amplitude = format_significant(cosine.hypot(sine), 3);
        let towards = format_significant(sine.atan2(cosine).to_degrees().rem_euclid(360.0), 4);
        polar_chart(&PolarChart {
            title: "Pitch and concentricity around the tool".into(),
            subtitle: "tooth 0 at the top, teeth counter-clockwise".into(),
            value_title: "deviation along the circle [µm]".into(),
            least_span: LEAST_UM,
            spokes: numbered.map(|tooth| (self.direction(tooth), tooth.to_string())).collect(),
            curves: vec![
                curve("cumulative pitch, from tooth 0", &self.cumulative_um),
                curve("tooth centre", &self.centre_um),
                PolarCurve {
                    name: "first harmonic of the centres".into(),
                    points: (0..SMOOTH).map(wave).collect(),
                    marked: false,
                },
            ],
            rings: self.outliers.iter().filter_map(ring).collect(),
            rings_name: "outlier tooth".into(),
            remarks: vec![
                format!("First harmonic: {amplitude} µm, greatest at {towards}° from tooth 0."),
                "Numbers at the rim are teeth.".into(),
            ],
        })
    }

    fn over_teeth(&self) -> Result<Svg, ChartError> {
        let teeth: Vec<f64> = (0..self.cumulative_um.len()).map(|tooth| tooth as f64).collect();
        let cumulative = Series::new("cumulative pitch F_pk", teeth.clone(), self.cumulative_um.clone());
        let mut lines = vec![cumulative.marked(vec![true; teeth.len()])];
        let rings: Vec<([f64; 2], String)> = self
            .outliers
            .iter()
            .filter_map(|&tooth| {
                Some(([tooth as f64, *self.cumulative_um.get(tooth)?], format!("tooth {tooth}")))
            })
            .collect();
        if !rings.is_empty() {
            lines.push(Series::rings("outlier tooth", rings));
        }
        let single = Series::bars("single pitch f_pk", teeth, self.single_um.clone());
        let chart = LineChart {
            title: "Pitch over the teeth".into(),
            x_title: "tooth".into(),
            panels: vec![
                Panel::linear("single pitch deviation [µm]", LEAST_UM, vec![single]),
                Panel::linear("cumulative pitch deviation [µm]", LEAST_UM, lines),
            ],
        };
        line_chart_in(&chart, &LineFrame { panel_height: Some(TALL), beside: 0.8 })
    }
}

fn figures_table(figures: &[UncertainFigure]) -> Result<Table, ChartError> {
    let row = |figure: &UncertainFigure| {
        Ok(vec![
            figure.name.clone(),
            figure.symbol.clone(),
            significant(&figure.name, figure.value, 4)?,
            figure.unit.clone(),
            significant_or_none(&figure.name, figure.deviation, 2)?,
        ])
    };
    let unknown = figures.iter().any(|figure| figure.deviation.is_none());
    Ok(Table {
        caption: "Figures".into(),
        columns: vec![
            Column::text("Quantity"),
            Column::symbols("Symbol"),
            Column::number("Value", ""),
            Column::text("Unit"),
            Column::number("Standard deviation", ""),
        ],
        rows: figures.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: if unknown { "–: not determined by this measurement.".into() } else { String::new() },
    })
}
