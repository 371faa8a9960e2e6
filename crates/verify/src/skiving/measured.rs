//! A tool in front of its beam, measured without noise.

use super::super::given::Checked;
use super::example::SkivingExample;
use foundation::geometry::Sides;
use skiving::evaluation::{Deviations, measured_tool};
use skiving::measuring::{
    BarrierData, Beam, FlankTracks, Noise, RealTool, Sense, Switches, first_order_deviation, readings,
    switches,
};

/// A tool in front of its beam.
pub(super) struct Measured {
    pub example: SkivingExample,
    pub beam: Beam,
    pub tool: RealTool,
    pub flanks: Sides<FlankTracks>,
    pub first_order: Deviations,
    pub deviations: Deviations,
}

impl Measured {
    /// Measures a tool without noise in the positive sense.
    pub fn new(example: SkivingExample, beam: Beam, tool: RealTool) -> Checked<(Self, Switches)> {
        tool.check(example.teeth())?;
        let flanks = example.flanks(&beam)?;
        let data = BarrierData::ideal();
        let switched = switches(&flanks, &beam, &data, &tool)?;
        let seen = readings(&flanks, &switched, &data, &[Sense::Positive], 1, &mut Noise::new(0));
        let deviations = measured_tool(&flanks, &seen, 0.0)?.deviations;
        let first_order = deviations.map(|flank, track, tooth, _| {
            first_order_deviation(&flanks[flank].edge, &tool, &flanks[flank].tracks[track].0, tooth)
        });
        Ok((Self { example, beam, tool, flanks, first_order, deviations }, switched))
    }
}
