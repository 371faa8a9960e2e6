//! How a job mills its flanks: rows and columns, orientation, contact, order.

use super::cutters::Cutters;
use crate::job::{
    ContactHeight, CutSense, GridChoice, Lead, MilledRoot, MillingJob, RootBottom, RowDistances, RowSequence,
    Traversal,
};
use crate::{
    Bottom, CutDirection, DensityLimits, DistanceLimits, HeightRule, LeadArc, Lines, Orientation,
    PlanOptions, RootDepth, RowOrder, SpacingLaw, Traverse,
};

/// What the default overrun adds to the cutter's radius, mm (`docs/mathematics/milling.md#columns-and-rows`).
const BESIDE: f64 = 1.0;

/// How a cutter comes to rows or leaves them: as a table says, else on a quarter circle where the job has one.
fn lead_arc(given: Option<Lead>, quarter: Option<f64>) -> Option<LeadArc> {
    let own = given.map(|lead| LeadArc {
        radius: lead.radius,
        angle: lead.angle_deg.to_radians(),
        straight: lead.straight,
    });
    own.or(quarter.map(LeadArc::quarter))
}

/// The options of a job with its cutters.
pub(super) fn options(job: &MillingJob, cutters: Cutters) -> PlanOptions {
    let milling = &job.milling;
    let lines = match milling.grid() {
        GridChoice::Counts { rows, columns } => Lines::Counted { rows, columns },
        GridChoice::Limits { density: d, scallop_um, chord_um } => Lines::Limited {
            limits: DensityLimits {
                row: DistanceLimits {
                    greatest: d.row_max,
                    least: d.row_min,
                    greatest_mean: d.row_max_mean,
                    least_mean: d.row_min_mean,
                },
                column: DistanceLimits {
                    greatest: d.column_max,
                    least: d.column_min,
                    greatest_mean: d.column_max_mean,
                    least_mean: d.column_min_mean,
                },
            },
            scallop: scallop_um.map(|um| 1e-3 * um),
            chord: chord_um.map(|um| 1e-3 * um),
        },
    };
    let direction = match milling.direction {
        CutSense::Climb => CutDirection::Climb,
        CutSense::Conventional => CutDirection::Conventional,
    };
    let depth = |root: &MilledRoot| match root.depth() {
        RootBottom::Height(height) => RootDepth::Bottom(height),
        RootBottom::Straight(straight) => RootDepth::Straight(straight),
    };
    PlanOptions {
        cutter: cutters.finishing,
        bottom_cutter: cutters.bottom,
        roughing_cutter: cutters.roughing,
        lines,
        spacing: match milling.row_spacing {
            RowDistances::Arc => SpacingLaw::Arc,
            RowDistances::Parameter => SpacingLaw::Parameter,
            RowDistances::Scallop => SpacingLaw::Scallop,
        },
        orientation: Orientation {
            tilt: milling.tilt_deg.to_radians(),
            lead_angle: milling.lead_angle_deg.to_radians(),
        },
        tilt_at_tip: milling.tilt_at_tip_deg.filter(|tilt| *tilt != milling.tilt_deg).map(f64::to_radians),
        heights: match &milling.contact_height {
            Some(ContactHeight::Fixed(height)) => HeightRule::Fixed(*height),
            Some(ContactHeight::Ramp(ramp)) => HeightRule::Ramp([ramp.from, ramp.to]),
            Some(ContactHeight::Rows(heights)) => HeightRule::Free(heights.clone()),
            // Of a cutter without a straight side: its contact follows from the axis.
            None => HeightRule::Fixed(0.0),
        },
        overrun: milling.overrun.unwrap_or(0.5 * job.cutter.diameter + BESIDE),
        safety: milling.safety_distance,
        traverse: match milling.traverse {
            Traversal::OneWay => Traverse::OneWay(direction),
            Traversal::Zigzag => Traverse::Zigzag(direction),
        },
        order: match milling.order {
            RowSequence::TipToRoot => RowOrder::TipToRoot,
            RowSequence::RootToTip => RowOrder::RootToTip,
        },
        root: milling.root.as_ref().map(|root| (depth(root), root.bottom_pass)),
        bottom: milling.root.as_ref().map(|root| match root.depth() {
            RootBottom::Height(height) => Bottom::Level(height),
            RootBottom::Straight(straight) => Bottom::BelowFlank(straight),
        }),
        roughing: milling.roughing.as_ref().map(|r| [r.allowance, r.step_down, r.step_over]),
        leads: [milling.lead_in, milling.lead_out].map(|given| lead_arc(given, milling.approach_radius)),
        sides: job.flanks(),
    }
}
