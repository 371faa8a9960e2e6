//! Teeth to look at: incomplete ones, those that leave the band or stand out, and the largest of the others on each flank.

use super::shown_teeth::ShownTeeth;
use foundation::geometry::Flank;
use foundation::numerics::power_series;
use report::cells::{NONE, fixed};
use report::charts::{ChartError, format_significant};
use report::{Column, Table};

/// Rows of each kind in the table.
const WORST: usize = 12;

/// A tooth to look at.
pub(super) struct WorstTooth {
    pub tooth: usize,
    /// Flank, number of the track with the largest distance from the compensation curve, and that distance, um; none for a whole tooth.
    pub edge: Option<(Flank, usize, f64)>,
    /// What is the matter.
    pub why: &'static str,
}

impl WorstTooth {
    /// Incomplete teeth, then teeth by their largest distance from the compensation curve.
    pub fn all(teeth: &ShownTeeth<'_>) -> Vec<Self> {
        let (bodies, evaluation) = (teeth.bodies, &teeth.measurement.evaluation);
        let mut all: Vec<(usize, (Flank, usize, f64))> = Vec::new();
        for flank in Flank::BOTH {
            for tooth in 0..bodies.teeth() {
                let off = |track: usize| {
                    let curve = power_series(&evaluation.profile.curve[flank], teeth.place(flank, track))[0];
                    1e3 * (evaluation.remaining.of[flank][track][tooth] - curve)
                };
                let tracks = (0..teeth.tracks(flank)).map(|track| (flank, track, off(track)));
                let found = tracks.max_by(|a, b| a.2.abs().total_cmp(&b.2.abs()));
                all.extend(found.map(|edge| (tooth, edge)));
            }
        }
        all.sort_by(|(_, a), (_, b)| b.2.abs().total_cmp(&a.2.abs()));
        let incomplete = teeth.measurement.measured.incomplete();
        all.retain(|(tooth, _)| !incomplete.contains(tooth));
        let out = |flank: Flank, tooth: usize| evaluation.profile.out_of_band.contains(&(flank, tooth));
        let left_out = |tooth: usize| evaluation.mounting.left_out.contains(&tooth);
        let lacking = incomplete.iter().take(WORST).map(|&tooth| Self {
            tooth,
            edge: None,
            why: "did not switch on every track; the lines show the mean tooth where it lacks",
        });
        let mut rows: Vec<Self> = lacking.collect();
        let marked = all.iter().filter(|(tooth, (flank, ..))| out(*flank, *tooth) || left_out(*tooth));
        rows.extend(marked.take(WORST).map(|&(tooth, edge)| Self {
            tooth,
            edge: Some(edge),
            why: match (out(edge.0, tooth), left_out(tooth)) {
                (true, true) => "out of the band; left out of means, mounting and correction",
                (true, false) => "out of the band",
                _ => "outlier; left out of means, mounting and correction",
            },
        }));
        for flank in Flank::BOTH {
            let mut others = all
                .iter()
                .filter(|(tooth, (of, ..))| *of == flank && !out(flank, *tooth) && !left_out(*tooth));
            rows.extend(others.next().map(|&(tooth, edge)| Self {
                tooth,
                edge: Some(edge),
                why: "largest of the others on its flank",
            }));
        }
        rows
    }
}

/// The teeth with what is the matter.
pub(super) fn table(worst: &[WorstTooth], band_um: f64) -> Result<Table, ChartError> {
    let row = |worst: &WorstTooth| {
        let [flank, track, off] = match worst.edge {
            Some((flank, track, off)) => [
                flank.to_string(),
                (track + 1).to_string(),
                fixed("distance from the compensation curve", off, 2)?,
            ],
            None => ["both".into(), NONE.into(), NONE.into()],
        };
        Ok(vec![worst.tooth.to_string(), flank, track, off, worst.why.to_owned()])
    };
    Ok(Table {
        caption: "Teeth to look at".into(),
        columns: vec![
            Column::number("Tooth", ""),
            Column::text("Flank"),
            Column::number("Track", ""),
            Column::number("From the curve", "µm"),
            Column::text("Why"),
        ],
        rows: worst.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: format!(
            "Tolerance band D = {} µm about the compensation curve.",
            format_significant(band_um, 4)
        ),
    })
}
