//! The flanks of a round as pictures: target, process and measurement with one scale, deviations with their own.

use super::flanks::{flanks, measured, topography};
use crate::workflow::{MeasuredFlankResult, RoundResult};
use foundation::geometry::Flank;
use report::cells::flank_title;
use report::charts::{
    ChartError, ContourMap, FlankSections, LevelScale, NamedTopography, ProfileHelixDiagram, SectionTrace,
    Topography, TopographyNet, contour_map, profile_helix_diagram, topography_net,
};
use report::flank_pictures::{net_and_map, range_with_zero};
use report::{Block, Figure};

fn figure(id: &str, svg: report::charts::Svg, caption: &str) -> Block {
    Block::Figure(Figure::new(id, svg, caption))
}

fn panels(
    round: &RoundResult,
    pick: impl Fn(&MeasuredFlankResult) -> Result<Option<Topography>, ChartError>,
) -> Result<Vec<NamedTopography>, ChartError> {
    let mut panels = Vec::new();
    for (flank, of) in flanks(round) {
        if let Some(found) = pick(of)? {
            panels.push(NamedTopography::new(flank_title(flank), found));
        }
    }
    Ok(panels)
}

/// Measured less target, about its mean: material that lies everywhere is thickness.
fn deviation(of: &MeasuredFlankResult) -> Result<Option<Topography>, ChartError> {
    let Some(measured) = measured(of)? else { return Ok(None) };
    let apart = measured.minus(&topography(of, &of.target_um)?)?;
    let count = apart.f_um().iter().flatten().count() as f64;
    let mean = apart.f_um().iter().flatten().sum::<f64>() / count;
    let rows = apart.f_um().iter().map(|row| row.iter().map(|f| f - mean).collect()).collect();
    Topography::new(apart.w_mm().to_vec(), apart.z_mm().to_vec(), rows).map(Some)
}

/// Nets of target, simulated and measured flank with one scale, and the traces through them.
pub(in crate::page) fn stages(round: &RoundResult) -> Result<Vec<Block>, ChartError> {
    let maps = |rows: fn(&MeasuredFlankResult) -> &Vec<Vec<f64>>| {
        panels(round, |of| topography(of, rows(of)).map(Some))
    };
    let stages = [
        ("target", "Target", maps(|of| &of.target_um)?),
        ("planned-analytic", "Planned (analytic)", maps(|of| &of.planned_um)?),
        ("simulated-referee", "Simulated (referee)", maps(|of| &of.simulated_um)?),
        ("measured-mean-of-the-teeth", "Measured, mean of the teeth", panels(round, measured)?),
    ];
    let all = stages.iter().flat_map(|(.., panels)| panels).map(|panel| &panel.topography);
    let range = range_with_zero(all);
    let mut blocks = Vec::new();
    for (id, name, panels) in stages.into_iter().filter(|(.., panels)| !panels.is_empty()) {
        let net = topography_net(&TopographyNet { title: name.to_owned(), panels, range_um: Some(range) })?;
        blocks.push(figure(id, net, ""));
    }
    let columns = flanks(round).filter_map(|(flank, of)| sections(flank, of).transpose());
    let columns: Vec<FlankSections> = columns.collect::<Result<_, ChartError>>()?;
    if !columns.is_empty() {
        let svg = profile_helix_diagram(&ProfileHelixDiagram {
            title: "Target and measurement in sections".to_owned(),
            flanks: columns,
            external: true,
            target_name: "target".to_owned(),
            simulated_name: "measured".to_owned(),
        })?;
        let id = "target-and-measurement-in-sections";
        blocks.push(figure(
            id,
            svg,
            "Mean of the teeth, normal to the flank, one magnification for all traces.",
        ));
    }
    Ok(blocks)
}

fn sections(flank: Flank, of: &MeasuredFlankResult) -> Result<Option<FlankSections>, ChartError> {
    let Some(measured) = measured(of)? else { return Ok(None) };
    let target = topography(of, &of.target_um)?;
    let thirds = |n: usize| [n / 8, n / 2, n - 1 - n / 8];
    Ok(Some(FlankSections {
        flank,
        profile_marks: Vec::new(),
        helix_marks: Vec::new(),
        profiles: thirds(measured.z_mm().len())
            .map(|j| SectionTrace::profile(&measured, Some(&target), j))
            .to_vec(),
        helices: thirds(measured.w_mm().len())
            .map(|i| SectionTrace::helix(&measured, Some(&target), i))
            .to_vec(),
    }))
}

/// Measured less target of the last round, as a contour map; `None` where it does not cover the grid.
pub(in crate::page) fn last_deviation(rounds: &[RoundResult]) -> Result<Option<Figure>, ChartError> {
    let Some(last) = rounds.last() else { return Ok(None) };
    let panels = panels(last, deviation)?;
    if panels.is_empty() {
        return Ok(None);
    }
    let title = "Measured less target".to_owned();
    let svg = contour_map(&ContourMap { title, quantity: "Δf_n [µm]".to_owned(), panels, scale: None })?;
    Ok(Some(Figure::new("measured-less-target-at-the-end", svg, "")))
}

/// Deviations of all rounds, as nets and maps with one scale.
pub(super) fn deviations(rounds: &[RoundResult]) -> Result<Vec<Block>, ChartError> {
    let mut of_rounds = Vec::new();
    for round in rounds {
        let panels = panels(round, deviation)?;
        if !panels.is_empty() {
            of_rounds.push((round.round, panels));
        }
    }
    let all = || of_rounds.iter().flat_map(|(_, panels)| panels).map(|panel| &panel.topography);
    let scale = LevelScale::covering(all());
    let range = range_with_zero(all());
    let several = rounds.len() > 1;
    let mut blocks = Vec::new();
    for (number, panels) in of_rounds {
        let (id, title) = if several {
            (format!("measured-less-target-round-{number}"), format!("Measured less target, round {number}"))
        } else {
            ("measured-less-target".to_owned(), "Measured less target".to_owned())
        };
        blocks.extend(net_and_map(&id, &title, &panels, Some(range), Some(scale), "Δf_n [µm]")?);
    }
    Ok(blocks)
}
