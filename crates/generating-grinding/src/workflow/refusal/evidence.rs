//! What a refused job of generating grinding shows: the candidates that planning judged, and pictures of what limits.

use super::super::execution::Execution;
use super::super::prepare::{GivenSettings, Prepared, prepare};
use super::super::result::CandidateResult;
use crate::job::LoadedJob;
use crate::workflow::programs::beyond_travel::BeyondTravel;
use crate::workflow::programs::of_grinding::beyond_travel_of_grinding;
use crate::workflow::removal::put_on_stock;
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use generating::{Candidate, FeedLaw, GeneratingError};
use job::Diagnostic;
use report::charts::{
    ChartError, LineChart, Panel, Series, YScale, axis_chart, format_significant, line_chart,
};
use report::{Block, Column, Figure, Table};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;

/// A ratio that could not be judged.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FailedRatio {
    /// K.
    pub diagonal_ratio: f64,
    /// Code of the reason.
    pub code: &'static str,
    /// The reason.
    pub text: String,
}

/// What was found on the way to a refusal.
pub struct Evidence {
    prepared: Prepared,
    candidates: Vec<Candidate>,
    failed: Vec<(f64, GeneratingError)>,
    tolerance_um: f64,
    /// The ratio that the job gives.
    given: Option<f64>,
    /// Axes of the machine whose travel does not suffice, where that is what refused the job.
    beyond: Vec<BeyondTravel>,
}

/// Places at which a curve is drawn.
const PLACES: usize = 41;
/// Ordinates that differ by more than this factor are drawn in decades.
const DECADES: f64 = 50.0;

impl Evidence {
    /// Goes the way of planning again. A job whose bodies cannot even be put together shows none.
    pub fn of_job(loaded: &LoadedJob, finding: &Diagnostic) -> Option<Self> {
        let mut prepared = prepare(loaded).and_then(|prepared| prepared.on_machine(loaded)).ok()?;
        let (execution, candidates, failed) = match GivenSettings::of_job(loaded, &prepared).ok()? {
            // Settings were run, nothing was chosen.
            Some(settings) => (Execution::of_settings(&prepared, &settings).ok(), Vec::new(), Vec::new()),
            None => match prepared.task().plan_or_tried() {
                Ok(plan) => {
                    let execution = Execution::of_plan(&prepared, &plan);
                    (Some(execution), plan.choice.candidates, plan.choice.failed)
                }
                Err(refused) => (None, refused.candidates, refused.failed),
            },
        };
        let beyond = match execution.filter(|_| finding.code == "axis-limit" && is_of_machine(finding)) {
            Some(execution) => {
                put_on_stock(&mut prepared, &execution).ok()?;
                beyond_travel_of_grinding(&prepared, &execution)
            }
            None => Vec::new(),
        };
        let tolerance_um = prepared.tolerance.tightest() * 1e3;
        let given = prepared.rules.given_ratio;
        Some(Self { prepared, candidates, failed, tolerance_um, given, beyond })
    }

    /// The candidates in the order in which they were judged.
    fn judged(&self) -> Vec<CandidateResult> {
        self.candidates.iter().map(CandidateResult::of).collect()
    }

    /// Ratios that could not be judged.
    fn not_judged(&self) -> Vec<FailedRatio> {
        self.failed
            .iter()
            .map(|(ratio, error)| FailedRatio {
                diagonal_ratio: *ratio,
                code: error.code(),
                text: error.to_string(),
            })
            .collect()
    }

    /// The pictures of what limits.
    ///
    /// # Errors
    /// A number that is not finite.
    pub fn figures(&self, finding: &Diagnostic) -> Result<Vec<Figure>, ChartError> {
        let mut figures = Vec::new();
        if !is_of_machine(finding) {
            figures.extend(self.over_the_ratio(finding.code)?);
        }
        for of in &self.beyond {
            let Some(chart) = &of.chart else { continue };
            let ([a, b], [from, to]) = (of.needed, of.travel);
            let caption = format!(
                "{} over {} as the bodies need it, on a machine with longer ways: {a:.1} to {b:.1} {}. Its travel is {from:.1} to {to:.1} {}.",
                of.axis, of.file, of.unit, of.unit
            );
            figures.push(Figure::new(chart.id(), axis_chart(chart)?, caption));
        }
        figures.extend(self.reach()?);
        Ok(figures)
    }

    /// What the candidates need over the ratio, with the limit that refuses them.
    fn over_the_ratio(&self, code: &str) -> Result<Option<Figure>, ChartError> {
        if let ("worm-too-short", Some(width)) = (code, self.prepared.setup.input.worm_width) {
            return self.width_needed(width).map(Some);
        }
        if self.candidates.len() < 2 {
            return Ok(None);
        }
        let quantity = match code {
            "axis-limit" => Quantity {
                id: "share-of-the-axis-limits-of-planning-that-each-diagonal-ratio-needs",
                title: "Share of the axis limits of planning that each diagonal ratio needs",
                ordinate: "largest share",
                value: Candidate::score,
                limit: 1.0,
                limit_name: "limit",
            },
            _ => Quantity {
                id: "residual-of-each-diagonal-ratio-on-an-ideal-worm",
                title: "Residual of each diagonal ratio on an ideal worm",
                ordinate: "largest residual [µm]",
                value: |c| c.error * 1e3,
                limit: self.tolerance_um / 2.0,
                limit_name: "half the tolerance",
            },
        };
        quantity.figure(&self.candidates).map(Some)
    }

    /// The width of the worm that a ratio needs, which follows from the bodies alone.
    fn width_needed(&self, width: f64) -> Result<Figure, ChartError> {
        let setup = &self.prepared.setup;
        let which: Vec<Flank> =
            Flank::BOTH.into_iter().filter(|&flank| self.prepared.targets[flank].is_some()).collect();
        let tried =
            self.candidates.iter().map(|c| c.ratio).chain(self.failed.iter().map(|(ratio, _)| *ratio));
        let most = tried.chain(self.given).map(f64::abs).fold(1.0, f64::max);
        let ratios = equidistant([-most, most], PLACES);
        let needed = |&ratio: &f64| {
            let [from, to] = setup.occupation(&FeedLaw::Ratio(ratio).law(setup, &which), &which);
            to - from + 2.0 * setup.run_in()
        };
        let series = vec![
            Series::new("needed", ratios.clone(), ratios.iter().map(needed).collect()).bare(),
            Series::limit("width of the worm", vec![-most, most], vec![width; 2]),
        ];
        let svg = line_chart(&LineChart {
            title: "Width of the worm that each diagonal ratio needs".into(),
            x_title: "diagonal ratio K".into(),
            panels: vec![Panel::linear("width [mm]", 0.0, series)],
        })?;
        let id = "width-of-the-worm-that-each-diagonal-ratio-needs";
        Ok(Figure::new(id, svg, "Run-in and run-out included."))
    }

    /// The diameter of the worm that grinds each diameter of the gear, beside its tip and root.
    fn reach(&self) -> Result<Option<Figure>, ChartError> {
        let setup = &self.prepared.setup;
        if !(setup.pair.worm.is_cylindrical() && setup.pair.work.is_cylindrical()) {
            return Ok(None);
        }
        let [from, to, ..] = setup.input.evaluation;
        let diameters = equidistant([from, to], PLACES);
        let mut series: Vec<Series> = Vec::new();
        for flank in Flank::BOTH.into_iter().filter(|&flank| self.prepared.targets[flank].is_some()) {
            let pair = &setup.pair.flanks[flank];
            let needed: Option<Vec<f64>> = diameters
                .iter()
                .map(|d| {
                    let w = pair.work.length_of_roll(d / 2.0).ok()?;
                    Some(2.0 * pair.worm.radius(pair.worm_roll(w, 0.0, 0.0)))
                })
                .collect();
            let Some(needed) = needed else { continue };
            series.push(Series::new(format!("{flank} flank"), diameters.clone(), needed).bare());
        }
        if series.is_empty() {
            return Ok(None);
        }
        for (name, radius) in
            [("tip of the worm", setup.worm_tip_radius), ("root of the worm", setup.worm_root_radius)]
        {
            series.push(Series::limit(name, vec![from, to], vec![2.0 * radius; 2]));
        }
        let svg = line_chart(&LineChart {
            title: "Reach of the worm".into(),
            x_title: "diameter of the gear [mm]".into(),
            panels: vec![Panel::linear("diameter of the worm [mm]", 0.0, series)],
        })?;
        let caption = "Diameter of the worm that grinds each evaluated diameter of the gear, without modification; a modification moves it a little.";
        Ok(Some(Figure::new("reach-of-the-worm", svg, caption)))
    }
}

/// Whether the machine refuses the job, not its bodies.
fn is_of_machine(finding: &Diagnostic) -> bool {
    finding.field.as_deref().is_some_and(|field| field.starts_with("machine"))
}

/// A figure of the candidates with its limit.
struct Quantity {
    id: &'static str,
    title: &'static str,
    ordinate: &'static str,
    value: fn(&Candidate) -> f64,
    limit: f64,
    limit_name: &'static str,
}

impl Quantity {
    fn figure(&self, candidates: &[Candidate]) -> Result<Figure, ChartError> {
        let mut places: Vec<&'static str> = candidates.iter().map(|c| c.place.name()).collect();
        places.sort_unstable();
        places.dedup();
        let mut series = Vec::new();
        for place in &places {
            let mut points: Vec<(f64, f64, bool)> = candidates
                .iter()
                .filter(|c| c.place.name() == *place)
                .map(|c| (c.ratio, (self.value)(c), c.refusal.is_none()))
                .collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            points.dedup_by(|b, a| b.0 == a.0);
            let name = if places.len() > 1 { format!("crowning by {place}") } else { "candidates".into() };
            let x = points.iter().map(|p| p.0).collect();
            let y = points.iter().map(|p| p.1).collect();
            series.push(Series::new(name, x, y).marked(points.iter().map(|p| p.2).collect()));
        }
        let values = || series.iter().flat_map(|s: &Series| &s.y).copied();
        let (least, most) = (values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max));
        let scale =
            if most > DECADES * least.max(f64::MIN_POSITIVE) { YScale::Logarithmic } else { YScale::Linear };
        let ratios = || series.iter().flat_map(|s| &s.x).copied();
        let ends = [ratios().fold(f64::INFINITY, f64::min), ratios().fold(f64::NEG_INFINITY, f64::max)];
        series.push(Series::limit(self.limit_name, ends.to_vec(), vec![self.limit; 2]));
        let svg = line_chart(&LineChart {
            title: self.title.into(),
            x_title: "diagonal ratio K".into(),
            panels: vec![Panel { scale, ..Panel::linear(self.ordinate, 0.0, series) }],
        })?;
        Ok(Figure::new(self.id, svg, "Filled: allowed; open: refused. The table tells why."))
    }
}

impl run::Evidence for Evidence {
    fn candidates(&self) -> Value {
        serde_json::to_value(self.judged()).unwrap_or_default()
    }

    fn failed(&self) -> Value {
        serde_json::to_value(self.not_judged()).unwrap_or_default()
    }

    fn figures(&self, finding: &Diagnostic) -> Result<Vec<Figure>, ChartError> {
        Evidence::figures(self, finding)
    }

    fn tried(&self) -> Vec<Block> {
        candidates(self)
    }
}

fn candidates(evidence: &Evidence) -> Vec<Block> {
    let judged = evidence.judged();
    let failed = evidence.not_judged();
    let mut rows: Vec<Vec<String>> = judged
        .iter()
        .map(|c| {
            vec![
                format_significant(c.diagonal_ratio, 6),
                c.profile_crowning_by.to_owned(),
                format_significant(c.score, 3),
                format_significant(c.worm_occupation_mm, 5),
                format_significant(c.ideal_error_um, 4),
                c.refused.clone().unwrap_or_else(|| "allowed".to_owned()),
            ]
        })
        .collect();
    rows.extend(failed.iter().map(|f| {
        let none = || "–".to_owned();
        vec![format_significant(f.diagonal_ratio, 6), none(), none(), none(), none(), f.text.clone()]
    }));
    if rows.is_empty() {
        return Vec::new();
    }
    vec![Block::Table(Table {
        caption: String::new(),
        columns: vec![
            Column::number("K", ""),
            Column::text("Profile crowning by"),
            Column::number("Share of the axis limits", ""),
            Column::number("Worm used", "mm"),
            Column::number("Residual", "µm"),
            Column::text("Verdict"),
        ],
        rows,
        note: "Residual: largest deviation that an ideal worm leaves on the planning grid.".to_owned(),
    })]
}
