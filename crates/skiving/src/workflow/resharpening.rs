//! What a measured skiving tool tells those who resharpen it: how much to take off its rake faces, and every edge with its wear, as a
//! table and as a document.

use schemars::JsonSchema;
use serde::Serialize;

use crate::evaluation::{Deviations, Evaluation};
use crate::wear::{Attribution, EdgeState, Growths, Regrind, RegrindCause};
use foundation::geometry::{Flank, Sides};
use job::{Cell, Column, CsvError, CsvTable};

const COLUMNS: [Column; 14] = [
    Column::new("tooth", ""),
    Column::new("flank", ""),
    Column::new("mean_deviation", "um"),
    Column::new("growth", "um"),
    Column::new("residual", "um"),
    Column::new("out_of_band", ""),
    Column::new("depth", "mm"),
    Column::new("decides", ""),
    Column::new("single_pitch", "um"),
    Column::new("cumulative_pitch", "um"),
    Column::new("thickness", "um"),
    Column::new("tool_depth", "mm"),
    Column::new("tool_axial_depth", "mm"),
    Column::new("broken", ""),
];

/// Data for resharpening a tool.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Resharpening {
    /// Depth to take off the rake faces along their normal, until every edge can be rounded like a fresh one, mm; of broken edges the
    /// least that takes away what is seen of their chips.
    pub depth_mm: f64,
    /// The same along the tool's axis, mm.
    pub axial_depth_mm: f64,
    /// What the edges that are not broken ask for.
    pub without_broken: WithoutBroken,
    /// Edges that are broken, the left flank first.
    pub broken: Vec<BrokenEdge>,
    /// Teeth that did not switch the barrier everywhere, from 0: the depth does not count them.
    pub not_covered: Vec<usize>,
    /// The edge that decides; absent where no edge has grown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub decided_by: Option<DecidingEdge>,
    /// Standard deviation of the growths from the noise of the measurement, um.
    pub growth_deviation_um: Sides<f64>,
    /// Whether a shift of the edges was distinguished from their growth; if not, errors of grinding count as growth.
    pub shift_told_from_growth: bool,
    /// Deviation of every track of the resharpened tool in the setting so far, um: it stands back along its clearance faces.
    pub recession_um: Sides<Vec<f64>>,
    /// Eccentricity in x and y of the spindle during the measurement, um.
    pub eccentricity_um: [f64; 2],
    /// Wobble about x and y of the spindle during the measurement, urad.
    pub wobble_urad: [f64; 2],
    /// All teeth, in their order.
    pub teeth: Vec<ToothResharpening>,
}

/// What a tool needs whose chips stay.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WithoutBroken {
    /// Depth along the rake faces' normal, mm.
    pub depth_mm: f64,
    /// The same along the tool's axis, mm.
    pub axial_depth_mm: f64,
}

/// A broken edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BrokenEdge {
    /// Flank of the workpiece that it makes.
    pub flank: Flank,
    /// Its tooth, from 0.
    pub tooth: usize,
    /// Material that is missing on the worst track, normal to the flank, um; 0 where none is, as of a built-up edge.
    pub missing_um: f64,
    /// Depth that takes the chip away, along the rake face's normal, mm: the least by what is seen of it.
    pub depth_mm: f64,
}

/// What an edge asks for a depth for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DecidingCause {
    /// Growth of its rounding.
    Wear,
    /// A chip.
    Chip,
}

/// The edge that asks for most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DecidingEdge {
    /// Flank of the workpiece that it makes.
    pub flank: Flank,
    /// Its tooth, from 0.
    pub tooth: usize,
    /// The track that decides, from 1.
    pub track: usize,
    /// Why.
    pub cause: DecidingCause,
}

/// A tooth.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ToothResharpening {
    /// Its number, from 0.
    pub tooth: usize,
    /// f_p: pitch deviation to the next tooth, um.
    pub single_pitch_um: f64,
    /// F_p,k: pitch deviation from tooth 0, um.
    pub cumulative_pitch_um: f64,
    /// Deviation of its thickness, um.
    pub thickness_um: f64,
    /// Both edges.
    pub edges: Sides<EdgeResharpening>,
}

/// An edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EdgeResharpening {
    /// Mean over the tracks of what deviates without clocking and mounting, um; > 0 is material beyond the nominal edge.
    pub mean_deviation_um: f64,
    /// Growth of its rounding, um; `None` where the measurement does not tell: of broken edges, of the other edge of such a tooth where
    /// a shift is not distinguished from growth, and of teeth without a switch.
    pub growth_um: Option<f64>,
    /// What its tracks deviate beside the growth, root of the mean square, um.
    pub residual_um: Option<f64>,
    /// Depth that it asks for by itself, along the rake face's normal, mm; `None` where the measurement does not tell.
    pub depth_mm: Option<f64>,
    /// Whether it leaves the tolerance band.
    pub out_of_band: bool,
    /// Whether it is broken: an outlier among the others.
    pub broken: bool,
}

/// How every edge is: broken where it is an outlier, not known of `incomplete` teeth, and not known of the other edge of a broken tooth where
/// growth was found with the tooth's position, which takes both edges.
pub(super) fn states(
    evaluation: &Evaluation,
    growths: &Growths,
    incomplete: &[usize],
) -> Sides<Vec<EdgeState>> {
    let of_both_edges = growths.attribution != Attribution::ShiftAndGrowth;
    let state = |flank: Flank, tooth: usize, growth: f64| {
        if incomplete.contains(&tooth) {
            EdgeState::Unknown
        } else if evaluation.standing_out.contains(&(flank, tooth)) {
            EdgeState::Chipped(evaluation.remaining.of[flank].iter().map(|row| -row[tooth]).collect())
        } else if of_both_edges && evaluation.mounting.left_out.contains(&tooth) {
            EdgeState::Unknown
        } else {
            EdgeState::Worn(growth)
        }
    };
    growths
        .growth
        .map(|flank, of| of.iter().enumerate().map(|(k, growth)| state(flank, k, *growth)).collect())
}

impl Resharpening {
    /// The data of one measurement: its evaluation, the growths that were found from it, how its edges are ([`states`]), and the depth
    /// for them. `incomplete` teeth lack a switch.
    pub(super) fn new(
        evaluation: &Evaluation,
        growths: &Growths,
        (states, regrind): (&Sides<Vec<EdgeState>>, &Regrind),
        incomplete: &[usize],
    ) -> Self {
        let mounting = &evaluation.mounting;
        let edge = |flank: Flank, tooth: usize| {
            let state = &states[flank][tooth];
            let worn = matches!(state, EdgeState::Worn(_));
            EdgeResharpening {
                mean_deviation_um: 1e3 * mean(&evaluation.remaining, flank, tooth),
                growth_um: worn.then(|| 1e3 * growths.growth[flank][tooth]),
                residual_um: worn.then(|| 1e3 * growths.residual[flank][tooth]),
                depth_mm: regrind.each[flank][tooth],
                out_of_band: evaluation.profile.out_of_band.contains(&(flank, tooth)),
                broken: matches!(state, EdgeState::Chipped(_)),
            }
        };
        let broken = |(flank, of): (Flank, &Vec<EdgeState>)| {
            let of_tooth = |(tooth, state): (usize, &EdgeState)| match state {
                EdgeState::Chipped(missing) => Some(BrokenEdge {
                    flank,
                    tooth,
                    missing_um: 1e3 * missing.iter().copied().fold(0.0, f64::max),
                    depth_mm: regrind.each[flank][tooth].unwrap_or(0.0),
                }),
                EdgeState::Worn(_) | EdgeState::Unknown => None,
            };
            of.iter().enumerate().filter_map(of_tooth).collect::<Vec<_>>()
        };
        let pitch = &evaluation.pitch;
        let tooth = |tooth: usize| ToothResharpening {
            tooth,
            single_pitch_um: 1e3 * pitch.single[tooth],
            cumulative_pitch_um: 1e3 * pitch.cumulative[tooth],
            thickness_um: 1e3 * pitch.thickness[tooth],
            edges: Sides::from_fn(|flank| edge(flank, tooth)),
        };
        Self {
            depth_mm: regrind.depth,
            axial_depth_mm: regrind.axial_depth,
            without_broken: WithoutBroken {
                depth_mm: regrind.whole.depth,
                axial_depth_mm: regrind.whole.axial_depth,
            },
            broken: states.iter().flat_map(broken).collect(),
            not_covered: incomplete.to_vec(),
            decided_by: regrind.decides.map(|place| DecidingEdge {
                flank: place.flank,
                tooth: place.tooth,
                track: place.track + 1,
                cause: match place.cause {
                    RegrindCause::Wear(_) => DecidingCause::Wear,
                    RegrindCause::Chip(_) => DecidingCause::Chip,
                },
            }),
            growth_deviation_um: growths.deviation.map(|_, deviation| 1e3 * deviation),
            shift_told_from_growth: growths.attribution == Attribution::ShiftAndGrowth,
            recession_um: regrind.recession.map(|_, list| list.iter().map(|f| 1e3 * f).collect()),
            eccentricity_um: mounting.eccentricity.map(|e| 1e3 * e),
            wobble_urad: mounting.wobble.map(|om| 1e6 * om),
            teeth: (0..evaluation.remaining.teeth()).map(tooth).collect(),
        }
    }

    /// The same as a table: one row for every edge, the left one of each tooth first. The depths of the whole tool stand in every row.
    ///
    /// # Errors
    /// [`CsvError`] for a number that is not finite.
    pub fn table(&self) -> Result<CsvTable, CsvError> {
        let mut table = CsvTable::new(&COLUMNS);
        let word = |yes: bool| Cell::Word(if yes { "yes" } else { "no" });
        let known = |number: Option<f64>| number.map_or(Cell::Empty, Cell::Number);
        for tooth in &self.teeth {
            for (flank, edge) in tooth.edges.iter() {
                let decides =
                    self.decided_by.is_some_and(|place| (place.flank, place.tooth) == (flank, tooth.tooth));
                table.push_cells(&[
                    Cell::Number(tooth.tooth as f64),
                    Cell::Word(flank.name()),
                    Cell::Number(edge.mean_deviation_um),
                    known(edge.growth_um),
                    known(edge.residual_um),
                    word(edge.out_of_band),
                    known(edge.depth_mm),
                    word(decides),
                    Cell::Number(tooth.single_pitch_um),
                    Cell::Number(tooth.cumulative_pitch_um),
                    Cell::Number(tooth.thickness_um),
                    Cell::Number(self.depth_mm),
                    Cell::Number(self.axial_depth_mm),
                    word(edge.broken),
                ])?;
            }
        }
        Ok(table)
    }
}

fn mean(remaining: &Deviations, flank: Flank, tooth: usize) -> f64 {
    let tracks = &remaining.of[flank];
    tracks.iter().map(|row| row[tooth]).sum::<f64>() / tracks.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::{Mounting, Pitch, ProfileVerdict};
    use crate::wear::{DecidingPlace, GroundDepth};

    /// Three teeth on two tracks, every number another one.
    fn resharpening() -> Resharpening {
        let deviations = |first: f64| {
            let row = |k: f64| vec![first + 1e-4 * k, first + 2e-4 * k, first - 5e-4 * k];
            Deviations { of: Sides { left: vec![row(1.0), row(3.0)], right: vec![row(-2.0), row(-4.0)] } }
        };
        let evaluation = Evaluation {
            clocking: 0.1,
            clocked: deviations(0.5),
            pitch: Pitch {
                single: vec![1e-3, -2e-3, 1e-3],
                cumulative: vec![0.0, 1e-3, -1e-3],
                largest_single: 2e-3,
                total: 2e-3,
                first_harmonic: [0.0; 2],
                thickness: vec![4e-3, 5e-3, 6e-3],
                centres: Vec::new(),
            },
            mounting: Mounting {
                eccentricity: [6e-3, -4e-3],
                wobble: [1.5e-4, -8e-5],
                deviation_per_noise: [1.0; 4],
                deviation: [1.0; 4],
                constants: Sides::both(Vec::new()),
                left_out: vec![2],
            },
            counting: vec![true, true, false],
            standing_out: vec![(Flank::Left, 2)],
            remaining: deviations(-2e-3),
            profile: ProfileVerdict {
                track_means: Sides::both(Vec::new()),
                curve: Sides::both(Vec::new()),
                out_of_band: vec![(Flank::Left, 2), (Flank::Right, 0)],
                worn: Sides::both(false),
                workpiece: Sides::both(Vec::new()),
            },
        };
        let growths = Growths {
            growth: Sides { left: vec![7e-3, 8e-3, 9e-3], right: vec![1e-2, 6e-3, 5e-3] },
            deviation: Sides { left: 1e-4, right: 2e-4 },
            residual: Sides { left: vec![1e-5; 3], right: vec![2e-5; 3] },
            attribution: Attribution::GrowthAlone { deviation_with_shift: 0.04 },
        };
        let regrind = Regrind {
            depth: 0.0125,
            axial_depth: 0.013,
            whole: GroundDepth { depth: 0.0125, axial_depth: 0.013 },
            decides: Some(DecidingPlace {
                flank: Flank::Right,
                track: 1,
                tooth: 0,
                cause: RegrindCause::Wear(1e-2),
            }),
            each: Sides { left: vec![Some(0.008), None, Some(0.010)], right: vec![Some(0.0125), None, None] },
            recession: Sides { left: vec![-1e-3, -2e-3], right: vec![-3e-3, -4e-3] },
        };
        let states = states(&evaluation, &growths, &[1]);
        Resharpening::new(&evaluation, &growths, (&states, &regrind), &[1])
    }

    /// A broken edge asks for the depth of its chip, the other edge of its tooth and a tooth without a switch for nothing that is known.
    #[test]
    fn every_edge_is_worn_broken_or_not_known() {
        let found = resharpening();
        let of = |tooth: usize, flank: Flank| found.teeth[tooth].edges[flank];
        assert_eq!(found.broken.len(), 1);
        let broken = found.broken[0];
        assert_eq!((broken.flank, broken.tooth, broken.depth_mm), (Flank::Left, 2, 0.010));
        // 2 um and 5 times 0.3 um: tooth 2 on the second track.
        assert!((broken.missing_um - 3.5).abs() < 1e-9, "{broken:?}");
        assert_eq!(found.not_covered, [1]);
        assert!(of(2, Flank::Left).broken && !of(2, Flank::Right).broken);
        assert!(of(0, Flank::Left).growth_um.is_some());
        for (tooth, flank) in [(1, Flank::Left), (1, Flank::Right), (2, Flank::Left), (2, Flank::Right)] {
            assert_eq!((of(tooth, flank).growth_um, of(tooth, flank).residual_um), (None, None));
        }
        let document = serde_json::to_value(&found).unwrap();
        assert_eq!(document["broken"][0]["flank"], "left");
        assert_eq!(document["without_broken"]["axial_depth_mm"], 0.013);
        let table = found.table().unwrap();
        let row: Vec<&str> = table.text().lines().nth(6).unwrap().split(',').collect();
        assert_eq!((row[3], row[6], row[13]), ("", "", "no"), "{row:?}");
    }

    #[test]
    fn the_table_has_a_row_for_every_edge() {
        let table = resharpening().table().unwrap();
        let lines: Vec<&str> = table.text().lines().collect();
        assert_eq!(lines.len(), 7);
        assert_eq!(
            lines[0],
            "tooth,flank,mean_deviation_um,growth_um,residual_um,out_of_band,depth_mm,decides,single_pitch_um,\
             cumulative_pitch_um,thickness_um,tool_depth_mm,tool_axial_depth_mm,broken"
        );
        let cells: Vec<Vec<&str>> = lines[1..].iter().map(|line| line.split(',').collect()).collect();
        let named = |column: usize| cells.iter().map(|row| row[column]).collect::<Vec<_>>();
        assert_eq!(named(0), ["0", "0", "1", "1", "2", "2"]);
        assert_eq!(named(1), ["left", "right", "left", "right", "left", "right"]);
        assert_eq!(named(5), ["no", "yes", "no", "no", "yes", "no"]);
        assert_eq!(named(7), ["no", "yes", "no", "no", "no", "no"]);
        let number = |row: usize, column: usize| cells[row][column].parse::<f64>().unwrap();
        for (row, column, wanted) in [
            (0, 2, -1.8),
            (1, 2, -2.3),
            (4, 2, -3.0),
            (0, 3, 7.0),
            (1, 3, 10.0),
            (1, 4, 0.02),
            (1, 6, 0.0125),
            (4, 6, 0.010),
            (3, 8, -2.0),
            (5, 9, -1.0),
            (5, 10, 6.0),
            (4, 11, 0.0125),
            (4, 12, 0.013),
        ] {
            assert!((number(row, column) - wanted).abs() < 1e-12, "{row} {column}: {}", number(row, column));
        }
    }

    #[test]
    fn the_document_says_what_is_to_be_ground() {
        let document = serde_json::to_value(resharpening()).unwrap();
        assert_eq!(document["depth_mm"], 0.0125);
        assert_eq!(document["axial_depth_mm"], 0.013);
        assert_eq!(
            document["decided_by"],
            serde_json::json!({ "flank": "right", "tooth": 0, "track": 2, "cause": "wear" })
        );
        assert_eq!(document["shift_told_from_growth"], false);
        assert_eq!(document["growth_deviation_um"]["right"], 0.2);
        assert_eq!(document["recession_um"]["right"], serde_json::json!([-3.0, -4.0]));
        assert_eq!(document["eccentricity_um"], serde_json::json!([6.0, -4.0]));
        assert!((document["wobble_urad"][1].as_f64().unwrap() + 80.0).abs() < 1e-9);
        assert_eq!(document["teeth"][2]["edges"]["left"]["out_of_band"], true);
        assert_eq!(document["teeth"][1]["single_pitch_um"], -2.0);
    }

    #[test]
    fn a_number_that_is_none_is_not_written() {
        let mut wrong = resharpening();
        wrong.teeth[1].edges.left.growth_um = Some(f64::NAN);
        assert!(matches!(wrong.table(), Err(CsvError::InvalidNumber { column: "growth", row: 3, .. })));
    }
}
