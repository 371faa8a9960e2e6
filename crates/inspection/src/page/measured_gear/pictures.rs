//! The flanks of a round as pictures: target, process and measurement with one scale, deviations with their own.

use super::data::{FlankView, RoundView};
use foundation::geometry::Flank;
use report::cells::flank_title;
use report::charts::{
    ChartError, FlankSections, LevelScale, NamedTopography, ProfileHelixDiagram, SectionTrace, Topography,
    TopographyNet, profile_helix_diagram, topography_net,
};
use report::data::{Block, Figure};
use report::flank_pictures::{net_and_map, range_with_zero};

fn figure(id: &str, svg: report::charts::Svg, caption: &str) -> Block {
    Block::Figure(Figure::new(id, svg, caption))
}

fn panels(
    round: &RoundView,
    pick: impl Fn(&FlankView) -> Result<Option<Topography>, ChartError>,
) -> Result<Vec<NamedTopography>, ChartError> {
    let mut panels = Vec::new();
    for (flank, view) in round.flanks.iter() {
        if let Some(found) = view.as_ref().map(&pick).transpose()?.flatten() {
            panels.push(NamedTopography::new(flank_title(flank), found));
        }
    }
    Ok(panels)
}

/// Measured less target, about its mean: material that lies everywhere is thickness.
fn deviation(flank: &FlankView) -> Result<Option<Topography>, ChartError> {
    let Some(measured) = &flank.measured else { return Ok(None) };
    let apart = measured.minus(&flank.target)?;
    let count = apart.f_um().iter().flatten().count() as f64;
    let mean = apart.f_um().iter().flatten().sum::<f64>() / count;
    let rows = apart.f_um().iter().map(|row| row.iter().map(|f| f - mean).collect()).collect();
    Topography::new(apart.w_mm().to_vec(), apart.z_mm().to_vec(), rows).map(Some)
}

/// Nets of target, simulated and measured flank with one scale, and the traces through them.
pub(super) fn stages(round: &RoundView) -> Result<Vec<Block>, ChartError> {
    let stages = [
        ("target", "Target", panels(round, |flank| Ok(Some(flank.target.clone())))?),
        ("planned-analytic", "Planned (analytic)", panels(round, |flank| Ok(Some(flank.planned.clone())))?),
        (
            "simulated-referee",
            "Simulated (referee)",
            panels(round, |flank| Ok(Some(flank.simulated.clone())))?,
        ),
        (
            "measured-mean-of-the-teeth",
            "Measured, mean of the teeth",
            panels(round, |flank| Ok(flank.measured.clone()))?,
        ),
    ];
    let all = stages.iter().flat_map(|(.., panels)| panels).map(|panel| &panel.topography);
    let range = range_with_zero(all);
    let mut blocks = Vec::new();
    for (id, name, panels) in stages.into_iter().filter(|(.., panels)| !panels.is_empty()) {
        let net = topography_net(&TopographyNet { title: name.to_owned(), panels, range_um: Some(range) })?;
        blocks.push(figure(id, net, ""));
    }
    let columns: Vec<FlankSections> =
        round.flanks.iter().filter_map(|(flank, view)| sections(flank, view.as_ref()?)).collect();
    if !columns.is_empty() {
        let svg = profile_helix_diagram(&ProfileHelixDiagram {
            title: "Target and measurement in sections".to_owned(),
            flanks: columns,
            target_name: "target".to_owned(),
            simulated_name: "measured".to_owned(),
        })?;
        let id = "target-and-measurement-in-sections";
        blocks.push(figure(id, svg, "Mean of the teeth, normal to the flank, one scale for all traces."));
    }
    Ok(blocks)
}

fn sections(flank: Flank, view: &FlankView) -> Option<FlankSections> {
    let measured = view.measured.as_ref()?;
    let thirds = |n: usize| [n / 8, n / 2, n - 1 - n / 8];
    Some(FlankSections {
        name: flank_title(flank).to_owned(),
        profiles: thirds(measured.z_mm().len())
            .map(|j| SectionTrace::profile(measured, Some(&view.target), j))
            .to_vec(),
        helices: thirds(measured.w_mm().len())
            .map(|i| SectionTrace::helix(measured, Some(&view.target), i))
            .to_vec(),
    })
}

/// Deviations of all rounds, as nets and maps with one scale.
pub(super) fn deviations(rounds: &[RoundView]) -> Result<Vec<Block>, ChartError> {
    let mut of_rounds = Vec::new();
    for round in rounds {
        let panels = panels(round, deviation)?;
        if !panels.is_empty() {
            of_rounds.push((round.number, panels));
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
