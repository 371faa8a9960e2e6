//! Concentricity around the tool and pitch over its teeth.

use super::spread::spread;
use crate::workflow::{MeasurementResult, SkivingOutcome};
use foundation::geometry::Flank;
use report::cells::{fixed, significant, significant_or_none};
use report::charts::{
    ChartError, LineChart, LineFrame, Panel, PolarChart, PolarCurve, Series, Svg, format_significant,
    line_chart_in, polar_chart,
};
use report::{Block, Column, Figure, Table};

/// Pitch and concentricity at the middle track, tooth by tooth.
struct DrawnPitch<'a> {
    /// Radius that angles are turned into lengths with, mm.
    radius_mm: f64,
    /// f_p,k: from each tooth to the next, um.
    single_um: Vec<f64>,
    /// F_p,k: from tooth 0 to each, um.
    cumulative_um: Vec<f64>,
    /// Deviation of each tooth's centre, um.
    centre_um: Vec<f64>,
    /// Cosine and sine part of the centres' first harmonic, um.
    harmonic_um: [f64; 2],
    /// Outlier teeth.
    outliers: &'a [usize],
}

/// A figure: name, symbol, value, unit, standard deviation where the measurement tells.
type UncertainFigure = (&'static str, &'static str, f64, &'static str, Option<f64>);

/// Smallest span of the values, um.
const LEAST_UM: f64 = 1.0;
const TALL: f64 = 130.0;
/// Points of the smooth curve.
const SMOOTH: usize = 180;
/// Directions with a number, about.
const SPOKES: usize = 12;

/// Concentricity, and pitch; nothing where nothing is measured.
pub(super) fn blocks(outcome: &SkivingOutcome) -> Result<[Vec<Block>; 2], ChartError> {
    let Some((drawn, measured)) = DrawnPitch::of_run(outcome).zip(outcome.result.measurement.as_ref()) else {
        return Ok([Vec::new(), Vec::new()]);
    };
    let caption = "Seen on the rake face. A circle of the first harmonic beside the circle of zero is an eccentric tool; what is left is pitch.";
    let concentricity = Figure::new("pitch-and-concentricity-around-the-tool", drawn.polar()?, caption);
    let caption = format!(
        "At the radius {} mm. Single pitch k goes from tooth k to the next; cumulative pitch counts from tooth 0.",
        fixed("radius of the pitch", drawn.radius_mm, 4)?
    );
    let pitch = Figure::new("pitch-over-the-teeth", drawn.over_teeth()?, caption);
    Ok([
        vec![Block::Figure(concentricity)],
        vec![Block::Figure(pitch), Block::Table(figures(outcome, measured)?)],
    ])
}

impl<'a> DrawnPitch<'a> {
    fn of_run(outcome: &'a SkivingOutcome) -> Option<Self> {
        let evaluation = &outcome.measurement.as_ref()?.evaluation;
        let flanks = &outcome.prepared.bodies.flanks;
        let middle = flanks.left.tracks.len() / 2;
        let radius = |flank: Flank| flanks[flank].tracks[middle].0.radius();
        let radius_mm = 0.5 * (radius(Flank::Left) + radius(Flank::Right));
        let of_angle = |angle: f64| 1e3 * radius_mm * angle;
        let um = |values: &[f64]| -> Vec<f64> { values.iter().map(|mm| 1e3 * mm).collect() };
        let pitch = &evaluation.pitch;
        Some(Self {
            radius_mm,
            single_um: um(&pitch.single),
            cumulative_um: um(&pitch.cumulative),
            centre_um: pitch.centres[middle].iter().map(|angle| of_angle(*angle)).collect(),
            harmonic_um: pitch.first_harmonic.map(of_angle),
            outliers: &evaluation.mounting.left_out,
        })
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

fn figures(outcome: &SkivingOutcome, measured: &MeasurementResult) -> Result<Table, ChartError> {
    let (pitch, mounting) = (&measured.pitch, &measured.mounting);
    let spread = |name: &str| spread(&outcome.result, name);
    let [e, om] = [mounting.eccentricity_sigma_um, mounting.wobble_sigma_urad];
    let figures: [UncertainFigure; 7] = [
        ("total cumulative pitch deviation", "F_p", pitch.total_um, "µm", spread("F_p")),
        ("largest single pitch deviation", "f_pmax", pitch.largest_single_um, "µm", spread("f_p,max")),
        ("first harmonic of the tooth centres", "", pitch.first_harmonic_um, "µm", None),
        ("eccentricity", "e_x", mounting.eccentricity_um[0], "µm", e.map(|sigma| sigma[0])),
        ("eccentricity", "e_y", mounting.eccentricity_um[1], "µm", e.map(|sigma| sigma[1])),
        ("wobble", "ω_x", mounting.wobble_urad[0], "µrad", om.map(|sigma| sigma[0])),
        ("wobble", "ω_y", mounting.wobble_urad[1], "µrad", om.map(|sigma| sigma[1])),
    ];
    let row = |&(name, symbol, value, unit, deviation): &UncertainFigure| {
        Ok(vec![
            name.to_owned(),
            symbol.to_owned(),
            significant(name, value, 4)?,
            unit.to_owned(),
            significant_or_none(name, deviation, 2)?,
        ])
    };
    let unknown = figures.iter().any(|(.., deviation)| deviation.is_none());
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
