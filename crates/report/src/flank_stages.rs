//! The flank as wanted, as planned and as simulated: nets, contour maps, and the profile and helix diagram. Knows no process.

use crate::cells::flank_title;
use crate::charts::{
    ChartError, ContourMap, FlankSections, LevelScale, NamedTopography, ProfileHelixDiagram, RangeMark,
    SectionTrace, Svg, Topography, contour_map, profile_helix_diagram,
};
use crate::data::{Block, Figure};
use crate::flank_pictures::{net_and_map, range_with_zero};
use foundation::geometry::{Flank, Sides};

/// A flank over its grid, normal, um, positive = material left standing.
#[derive(Clone, Debug, PartialEq)]
pub struct FlankStages {
    /// What is wanted.
    pub target: Topography,
    /// What the analytic model says.
    pub planned: Topography,
    /// What the referee left; the deviation is taken from it, from `planned` if it is absent.
    pub simulated: Option<Topography>,
    /// Where evaluated profiles end, and their parts without reliefs; empty: at the ends of the grid.
    pub profile_marks: Vec<RangeMark>,
    /// The same of helix traces.
    pub helix_marks: Vec<RangeMark>,
    /// Profile traces with their values; empty: three sections without values are drawn.
    pub profiles: Vec<SectionTrace>,
    /// Helix traces with their values; empty: three sections without values are drawn.
    pub helices: Vec<SectionTrace>,
}

/// The flanks of a page; `None` for one that is not made.
pub type DrawnFlanks = Sides<Option<FlankStages>>;

/// What comes out: by the referee, else by the model.
fn outcome(flank: &FlankStages) -> &Topography {
    flank.simulated.as_ref().unwrap_or(&flank.planned)
}

fn panels(flanks: &DrawnFlanks, pick: impl Fn(&FlankStages) -> Option<Topography>) -> Vec<NamedTopography> {
    flanks
        .iter()
        .filter_map(|(side, flank)| {
            flank.as_ref().and_then(&pick).map(|t| NamedTopography::new(flank_title(side), t))
        })
        .collect()
}

const INTRODUCTION: &str = "All values are normal to the flank, positive where material is left standing. Target, \
     planned and simulated flank share one scale; the deviation, what comes out minus target, has its own. w is the length of \
     roll; face II is the datum face and lies at the greatest z, face I lies opposite at the least: left and right are the flanks \
     that a viewer sees who looks at the datum face. Drawings often call the datum face I.";

/// A picture of both flanks by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlankPicture {
    /// What is wanted, a contour map.
    Target,
    /// What the model says, a contour map on the scale of the target.
    Planned,
    /// What comes out minus the target, a contour map.
    Deviation,
    /// The profile and helix diagram.
    Sections,
}

/// One picture as it stands in the report; `None` without anything to draw.
///
/// # Errors
/// [`ChartError`] for traces that are not finite or of different length.
pub fn flank_picture(flanks: &DrawnFlanks, picture: FlankPicture) -> Result<Option<Svg>, ChartError> {
    let map = |name: &str, panels: Vec<NamedTopography>, scale, quantity: &str| {
        let map = ContourMap { title: name.to_owned(), quantity: quantity.to_owned(), panels, scale };
        if map.panels.is_empty() { Ok(None) } else { contour_map(&map).map(Some) }
    };
    let target = panels(flanks, |flank| Some(flank.target.clone()));
    let planned = panels(flanks, |flank| Some(flank.planned.clone()));
    let scale = LevelScale::covering(target.iter().chain(&planned).map(|panel| &panel.topography));
    match picture {
        FlankPicture::Target => map("Target", target, Some(scale), "f_n [µm]"),
        FlankPicture::Planned => map("Planned (analytic)", planned, Some(scale), "f_n [µm]"),
        FlankPicture::Deviation => map("Deviation from the target", deviations(flanks)?, None, "Δf_n [µm]"),
        FlankPicture::Sections => {
            let svg = flank_diagram(flanks)?.into_iter().find_map(|block| match block {
                Block::Figure(figure) => Some(figure.svg),
                _ => None,
            });
            Ok(svg)
        }
    }
}

/// The picture of the first page: what comes out minus the target; `None` without flanks.
///
/// # Errors
/// [`ChartError`] for flanks on different grids.
pub fn first_picture(flanks: &DrawnFlanks) -> Result<Option<Figure>, ChartError> {
    let svg = flank_picture(flanks, FlankPicture::Deviation)?;
    Ok(svg.map(|svg| Figure::new("deviation-of-the-flanks", svg, "")))
}

fn deviations(flanks: &DrawnFlanks) -> Result<Vec<NamedTopography>, ChartError> {
    let mut deviations = Vec::new();
    for (side, flank) in flanks.iter() {
        let Some(flank) = flank else { continue };
        deviations.push(NamedTopography::new(flank_title(side), outcome(flank).minus(&flank.target)?));
    }
    Ok(deviations)
}

/// Nets and maps of target, planned and simulated flank with one scale, of the deviation with its own.
///
/// # Errors
/// [`ChartError`] for values that cannot be drawn.
pub fn flank_figures(flanks: &DrawnFlanks) -> Result<Vec<Block>, ChartError> {
    let stages = [
        ("target", "Target", panels(flanks, |flank| Some(flank.target.clone()))),
        ("planned-analytic", "Planned (analytic)", panels(flanks, |flank| Some(flank.planned.clone()))),
        ("simulated-referee", "Simulated (referee)", panels(flanks, |flank| flank.simulated.clone())),
    ];
    let all = || stages.iter().flat_map(|(.., panels)| panels).map(|panel| &panel.topography);
    let scale = LevelScale::covering(all());
    let range = range_with_zero(all());
    if all().next().is_none() {
        return Ok(Vec::new());
    }
    let mut blocks = vec![Block::Paragraph(INTRODUCTION.to_owned())];
    for (id, name, panels) in stages.iter().filter(|(.., panels)| !panels.is_empty()) {
        blocks.extend(net_and_map(id, name, panels, Some(range), Some(scale), "f_n [µm]")?);
    }
    let deviation = deviations(flanks)?;
    if !deviation.is_empty() {
        let (id, name) = ("deviation-from-the-target", "Deviation from the target");
        blocks.extend(net_and_map(id, name, &deviation, None, None, "Δf_n [µm]")?);
    }
    Ok(blocks)
}

/// Profile and helix traces of both flanks.
///
/// # Errors
/// [`ChartError`] for traces that are not finite or of different length.
pub fn flank_diagram(flanks: &DrawnFlanks) -> Result<Vec<Block>, ChartError> {
    let columns: Vec<FlankSections> = flanks
        .iter()
        .filter_map(|(side, flank)| flank.as_ref().map(|flank| sections(side, flank)))
        .filter(|sections| !sections.profiles.is_empty() || !sections.helices.is_empty())
        .collect();
    if columns.is_empty() {
        return Ok(Vec::new());
    }
    let simulated =
        flanks.iter().any(|(_, flank)| flank.as_ref().is_some_and(|flank| flank.simulated.is_some()));
    let svg = profile_helix_diagram(&ProfileHelixDiagram {
        title: "Profile and helix diagram".to_owned(),
        flanks: columns,
        external: true,
        target_name: "target".to_owned(),
        simulated_name: if simulated { "simulated" } else { "planned" }.to_owned(),
    })?;
    let caption = "Values normal to the flank, one magnification for all traces; it holds on paper of A4. Face II: datum face, greatest z; face I: opposite, least z.";
    Ok(vec![Block::Figure(Figure::new("profile-and-helix-diagram", svg, caption))])
}

fn sections(side: Flank, flank: &FlankStages) -> FlankSections {
    let made = outcome(flank);
    let given = |traces: &[SectionTrace], cut: &dyn Fn(&Topography) -> Vec<SectionTrace>| match traces {
        [] => cut(made),
        _ => traces.to_vec(),
    };
    FlankSections {
        flank: side,
        profile_marks: marks(&flank.profile_marks, made.w_mm()),
        helix_marks: marks(&flank.helix_marks, made.z_mm()),
        profiles: given(&flank.profiles, &|made| {
            let places = three_places(made.z_mm());
            places.into_iter().map(|j| SectionTrace::profile(made, Some(&flank.target), j)).collect()
        }),
        helices: given(&flank.helices, &|made| {
            let places = three_places(made.w_mm());
            places.into_iter().map(|i| SectionTrace::helix(made, Some(&flank.target), i)).collect()
        }),
    }
}

/// The marks that are given, else the ends of the grid, which is the evaluated field.
fn marks(given: &[RangeMark], grid: &[f64]) -> Vec<RangeMark> {
    match (given, grid) {
        ([], [first, .., last]) => {
            [*first, *last].map(|at_mm| RangeMark { at_mm, ends_range: true }).to_vec()
        }
        _ => given.to_vec(),
    }
}

/// Indices near one eighth, the middle and seven eighths of a grid, without repetition.
fn three_places(values: &[f64]) -> Vec<usize> {
    let (first, last) = (values[0], values[values.len() - 1]);
    let mut places: Vec<usize> = [0.125, 0.5, 0.875]
        .into_iter()
        .map(|share| {
            let wanted = first + share * (last - first);
            values.partition_point(|v| *v < wanted - 1e-9 * (last - first)).min(values.len() - 1)
        })
        .collect();
    places.dedup();
    places
}
