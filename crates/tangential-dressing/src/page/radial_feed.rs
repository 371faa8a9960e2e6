//! Conventional grinding by radial feed beside tangential dressing.

use super::heading;
use crate::workflow::{RadialFeedResult, TangentialFlankResult, TangentialOutcome, TangentialRun};
use foundation::geometry::Flank;
use report::charts::{ChartError, ContourMap, NamedTopography, Topography, contour_map, format_fixed};
use report::{Block, Column, Figure, Table, kebab};

/// Both methods on one flank.
pub(super) struct Compared<'a> {
    flank: Flank,
    radial: &'a RadialFeedResult,
    made: &'a TangentialFlankResult,
    run: &'a TangentialRun,
}

impl<'a> Compared<'a> {
    /// Of the flanks for which the job asks.
    pub fn of(outcome: &'a TangentialOutcome) -> Vec<Self> {
        let of = |flank: Flank| {
            let made = outcome.result.flanks.get(flank.name())?;
            Some(Self {
                flank,
                radial: made.radial_feed.as_ref()?,
                made,
                run: outcome.flanks[flank].as_ref()?,
            })
        };
        Flank::BOTH.into_iter().filter_map(of).collect()
    }

    fn name(&self) -> String {
        heading(&[self.flank.name()])
    }

    /// Twist of the flank as tangential dressing makes it, less that of the target, normal, um.
    fn unwanted_twist_um(&self) -> f64 {
        let f = &self.made.flank;
        f.simulated_characteristics.twist_corner_normal_um - f.target_characteristics.twist_corner_normal_um
    }

    /// Deviations of radial feed and of tangential dressing.
    fn maps(&self) -> Result<Option<[Topography; 2]>, ChartError> {
        let Some(radial) = &self.radial.deviation_um else { return Ok(None) };
        let f = &self.made.flank;
        let grid = |rows: Vec<Vec<f64>>| Topography::new(f.w_mm.clone(), f.z_mm.clone(), rows);
        let own = self.run.simulated.minus(&self.run.target).rows_um();
        Ok(Some([grid(radial.clone())?, grid(own)?]))
    }
}

/// The table, and a picture of each flank; nothing where the job does not ask.
pub(super) fn blocks(flanks: &[Compared<'_>]) -> Result<Vec<Block>, ChartError> {
    if flanks.is_empty() {
        return Ok(Vec::new());
    }
    let or_dash = |x: Option<f64>| x.map_or("–".to_owned(), |x| format_fixed(x, 3));
    let mut blocks = vec![Block::Table(Table {
        caption: "Both methods side by side".to_owned(),
        columns: vec![
            Column::text("Flank"),
            Column::number("Helix crowning, normal", "µm"),
            Column::number("Twist of radial feed, closed form", "µm"),
            Column::number("Twist of radial feed, contact", "µm"),
            Column::number("Twist of tangential dressing", "µm"),
            Column::number("Largest deviation, radial feed", "µm"),
            Column::number("Largest deviation, tangential dressing", "µm"),
        ],
        rows: flanks
            .iter()
            .map(|f| {
                vec![
                    f.name(),
                    format_fixed(f.radial.lead_crowning_normal_um, 3),
                    format_fixed(f.radial.closed_twist_normal_um, 3),
                    or_dash(f.radial.twist_normal_um),
                    format_fixed(f.unwanted_twist_um(), 3),
                    or_dash(f.radial.max_deviation_um),
                    format_fixed(f.made.flank.max_deviation_um, 3),
                ]
            })
            .collect(),
        note: "Twist from the corners, normal, positive = material removed, without what the target itself wants. Radial feed: a worm \
               that does not shift and has no modification along it, the best profile in the dresser, a parabola of the centre \
               distance over the feed."
            .to_owned(),
    })];
    for flank in flanks {
        if let Some(refused) = &flank.radial.refused {
            blocks.push(Block::Paragraph(format!("{}: {}.", flank.name(), refused.text)));
        }
        if let Some([radial, tangential]) = flank.maps()? {
            let map = ContourMap {
                title: format!("Deviation from the target, {}", flank.name().to_lowercase()),
                quantity: "m − f [µm]".into(),
                panels: vec![
                    NamedTopography::new("Radial feed", radial),
                    NamedTopography::new("Tangential dressing", tangential),
                ],
                scale: None,
            };
            let caption = "What each method leaves of the same target, on one scale.";
            let id = format!("deviation-from-the-target-{}", kebab(&flank.name()));
            blocks.push(Block::Figure(Figure::new(id, contour_map(&map)?, caption)));
        }
    }
    Ok(blocks)
}
