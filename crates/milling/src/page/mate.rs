//! Contact with the mate: the pattern on the developed flank, and the transmission error over the roll.

use report::charts::{
    ChartError, Drawing, DrawingLayer, DrawingLook, DrawingNote, LineChart, Panel, Series, Svg, Topography,
    drawing, format_fixed, format_significant, line_chart, region_above,
};
use report::data::{Block, Column, Figure, Quantity, Table};
use report::kebab;

/// A bevel gear rolled against its mate.
#[derive(Clone, Debug, PartialEq)]
pub struct MateView {
    /// The mate, the axes, the marking.
    pub quantities: Vec<Quantity>,
    /// Thickness of the marking, um.
    pub marking_um: f64,
    /// Flanks of the gear.
    pub flanks: Vec<MateFlankView>,
}

/// Contact on a flank.
#[derive(Clone, Debug, PartialEq)]
pub struct MateFlankView {
    /// Heading, for example `Left flank`.
    pub name: String,
    /// Places on the developed flank, root to tip, each from toe to heel: (along the tooth from the toe, up the profile from where the
    /// active flank begins), mm.
    pub places_mm: Vec<Vec<[f64; 2]>>,
    /// Gaps found by rolling, um; none where the mate never faces the place.
    pub rolled_um: Vec<Vec<Option<f64>>>,
    /// Gaps that both ease-offs say.
    pub ease_off_um: Vec<Vec<Option<f64>>>,
    /// Centre of the rolled pattern on the developed flank, mm.
    pub centre_mm: Option<[f64; 2]>,
    /// Roll of the gear, deg.
    pub roll_deg: Vec<f64>,
    /// Turn of the mate against an even one, at its mean pitch circle, um; < 0: it lags.
    pub transmission_um: Vec<f64>,
    /// The same as both ease-offs say it.
    pub transmission_ease_off_um: Vec<f64>,
    /// Figures: rolled pattern, pattern by the ease-offs.
    pub patterns: [Option<PatternFigures>; 2],
    /// Common area of both patterns over that of either, percent.
    pub overlap_percent: f64,
    /// Peak to peak transmission error: arcsec, and um at the mean pitch circle of the mate.
    pub peak_to_peak: [f64; 2],
}

/// A pattern in percent of the active flank, from root and toe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatternFigures {
    /// Covered share.
    pub area: f64,
    /// Centre: along the tooth, over the height.
    pub centre: [f64; 2],
    /// Ends along the tooth.
    pub length: [f64; 2],
    /// Ends over the height.
    pub height: [f64; 2],
}

impl MateView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = Vec::new();
        for flank in &self.flanks {
            let caption = format!(
                "Places where the gap to the mate is {} µm or less at some roll position, without load, neighbouring pairs of teeth \
                 included. Hatched: found by rolling both wanted flanks. Dashed: what both ease-offs say. {} % are common. \
                 Beyond an edge of the mate a narrow band is marked that no contact line reaches.",
                format_significant(self.marking_um, 3),
                format_fixed(flank.overlap_percent, 1)
            );
            let id = format!("{}-contact-pattern", kebab(&flank.name));
            let svg = drawing(&flank.pattern(self.marking_um)?)?;
            blocks.push(Block::Figure(Figure::new(id, svg, caption)));
        }
        let caption = "Unloaded pair over three mesh periods; < 0: the mate lags behind an even turn.";
        let id = "transmission-error-at-the-mean-pitch-circle-of-the-mate";
        blocks.push(Block::Figure(Figure::new(id, self.transmission()?, caption)));
        blocks.push(Block::Table(self.figures()));
        blocks.push(Block::Table(Table::of_quantities("", &self.quantities)));
        Ok(blocks)
    }

    fn transmission(&self) -> Result<Svg, ChartError> {
        let panel = |flank: &MateFlankView| {
            let line = |name: &str, y: &Vec<f64>| Series::new(name, flank.roll_deg.clone(), y.clone());
            Panel::linear(
                format!("{}: transmission error [µm]", flank.name),
                1e-3,
                vec![
                    line("rolled", &flank.transmission_um),
                    line("by the ease-offs", &flank.transmission_ease_off_um),
                ],
            )
        };
        line_chart(&LineChart {
            title: "Transmission error at the mean pitch circle of the mate".into(),
            x_title: "roll of the gear [deg]".into(),
            panels: self.flanks.iter().map(panel).collect(),
        })
    }

    fn figures(&self) -> Table {
        let percent = |x: f64| format_fixed(x, 1);
        let range = |[from, to]: [f64; 2]| format!("{} to {}", percent(from), percent(to));
        let mut rows = Vec::new();
        for flank in &self.flanks {
            for (source, pattern) in ["rolled", "by the ease-offs"].into_iter().zip(flank.patterns) {
                let mut row = vec![flank.name.clone(), source.into()];
                row.extend(match pattern {
                    Some(p) => [
                        percent(p.area),
                        percent(p.centre[0]),
                        range(p.length),
                        percent(p.centre[1]),
                        range(p.height),
                    ],
                    None => ["0".into(), "none".into(), "none".into(), "none".into(), "none".into()],
                });
                row.extend(if source == "rolled" {
                    flank.peak_to_peak.map(|x| format_significant(x, 3))
                } else {
                    [String::new(), String::new()]
                });
                rows.push(row);
            }
        }
        Table {
            caption: String::new(),
            columns: vec![
                Column::name("Flank"),
                Column::text("Pattern"),
                Column::number("Area", "%"),
                Column::number("Centre along", "%"),
                Column::number("Along", "%"),
                Column::number("Centre up", "%"),
                Column::number("Up", "%"),
                Column::number("Transmission error", "arcsec"),
                Column::number("at the pitch circle", "µm"),
            ],
            rows,
            note: "Percent of the active flank: 0 at toe and root, 100 at heel and tip. The transmission error is peak to peak.".into(),
        }
    }
}

impl MateFlankView {
    fn pattern(&self, marking_um: f64) -> Result<Drawing, ChartError> {
        let (first, last) = (self.places_mm.first(), self.places_mm.last());
        let [root, tip] = [first, last].map(|row| row.cloned().unwrap_or_default());
        let mut outline = root.clone();
        outline.extend(tip.iter().rev());
        let middle = |row: &[[f64; 2]]| row.get(row.len() / 2).copied().unwrap_or_default();
        let end = |k: fn(&Vec<[f64; 2]>) -> Option<&[f64; 2]>| {
            let row = &self.places_mm[self.places_mm.len() / 2];
            k(row).copied().unwrap_or_default()
        };
        let mut notes: Vec<DrawingNote> = [
            (middle(&root), "root"),
            (middle(&tip), "tip"),
            (end(|row| row.first()), "toe"),
            (end(|row| row.last()), "heel"),
        ]
        .map(|(at_mm, text)| DrawingNote { at_mm, text: text.into() })
        .into();
        notes.extend(self.centre_mm.map(|at_mm| DrawingNote { at_mm, text: "centre".into() }));
        let layer = |name: &str, look, lines_mm| DrawingLayer { name: name.into(), look, lines_mm };
        Ok(Drawing {
            title: format!("{}: contact pattern", self.name),
            subtitle: "the flank of a space, developed, seen from outside the material".into(),
            axes: Some([
                "along the tooth, toe to heel [mm]".into(),
                "up the profile, root to tip [mm]".into(),
            ]),
            layers: vec![
                layer("active flank", DrawingLook::Body, vec![outline]),
                layer("rolled", DrawingLook::Material, self.loops(&self.rolled_um, marking_um)?),
                layer("by the ease-offs", DrawingLook::OtherEdge, self.loops(&self.ease_off_um, marking_um)?),
            ],
            notes,
        })
    }

    /// Closed lines round the places that are marked, on the developed flank.
    fn loops(&self, gaps: &[Vec<Option<f64>>], marking_um: f64) -> Result<Vec<Vec<[f64; 2]>>, ChartError> {
        // Where the mate never comes the pattern ends at the last place that it reaches.
        let far = -1e6 * marking_um;
        let nearness: Vec<Vec<f64>> =
            gaps.iter().map(|row| row.iter().map(|gap| gap.map_or(far, |um| -um)).collect()).collect();
        let numbers = |count: usize| (0..count).map(|k| k as f64).collect();
        let columns = nearness.first().map_or(0, Vec::len);
        let field = Topography::new(numbers(nearness.len()), numbers(columns), nearness)?;
        let loops = region_above(&field, -marking_um);
        Ok(loops.iter().map(|ring| ring.iter().map(|at| self.developed(at)).collect()).collect())
    }

    /// A place between the numbers of columns and rows.
    fn developed(&self, [column, row]: &[f64; 2]) -> [f64; 2] {
        let cell = |x: f64, count: usize| {
            let first = (x.floor() as usize).min(count.saturating_sub(2));
            (first, x - first as f64)
        };
        let (i, up) = cell(*row, self.places_mm.len());
        let (j, along) = cell(*column, self.places_mm[i].len());
        [0, 1].map(|k| {
            let on_row = |i: usize| {
                let row = &self.places_mm[i];
                row[j][k] + along * (row[j + 1][k] - row[j][k])
            };
            on_row(i) + up * (on_row(i + 1) - on_row(i))
        })
    }
}
