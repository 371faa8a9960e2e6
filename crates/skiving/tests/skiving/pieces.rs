//! Edges of profiles with reliefs, arcs and grids: pieces between the places at which slope or bend jump, under the referee.

use super::samples::{RING, STEPPED};
use foundation::geometry::{Flank, NormalOffset, OffsetBounds};
use foundation::numerics::Jet2;
use nalgebra::Vector3;
use referee::Skiving;
use skiving::{MeasuringTrack, VirtualEdge};
use std::sync::Arc;

/// How the modification goes on behind its corner, mm of roll.
#[derive(Clone, Copy, Debug)]
enum Shape {
    /// A relief by a straight line: the slope jumps.
    Straight,
    /// By a parabola: the bend jumps.
    Parabola,
    /// By a cube: the change of the bend jumps, as between the pieces of a spline.
    Cube,
}

#[derive(Debug)]
struct Relief {
    shape: Shape,
    corner: f64,
    end: f64,
    amount: f64,
}

impl NormalOffset for Relief {
    fn jet(&self, w: f64, _: f64) -> Jet2 {
        let length = self.end - self.corner;
        let x = (w - self.corner) / length;
        if x <= 0.0 {
            return Jet2::constant(0.0);
        }
        let [f, fu, fuu] = match self.shape {
            Shape::Straight => [x, 1.0, 0.0],
            Shape::Parabola => [x * x, 2.0 * x, 2.0],
            Shape::Cube => [x * x * x, 3.0 * x * x, 6.0 * x],
        };
        let scaled = |value: f64, power: i32| -self.amount * value / length.powi(power);
        Jet2 { fu: scaled(fu, 1), fuu: scaled(fuu, 2), ..Jet2::constant(scaled(f, 0)) }
    }

    fn bounds(&self, _: [f64; 2], _: [f64; 2]) -> OffsetBounds {
        OffsetBounds { value: 1.0, by_height: 1.0, by_length: 0.0, second: [f64::INFINITY; 3] }
    }
}

/// Every piece of the edge leaves what its contact says, an external gear and a ring, whatever jumps and wherever; also in the middle.
#[test]
fn reliefs_are_cut_by_pieces_of_an_edge() {
    for (sample, share) in [(RING, 0.5), (STEPPED, 0.63), (STEPPED, 0.5)] {
        let pair = sample.pair();
        for flank in Flank::BOTH {
            for shape in [Shape::Straight, Shape::Parabola, Shape::Cube] {
                let plain = pair.flank_between(flank, sample.radii).unwrap();
                let [from, to] = plain.range();
                let corner = from + share * (to - from);
                let relief = Relief { shape, corner, end: to, amount: 12e-3 };
                let wanted = plain.modified(Arc::new(relief), [-5.0, 5.0]).unwrap();
                let edge = VirtualEdge::new(&pair, wanted).unwrap();
                let ends: Vec<f64> = edge.pieces().iter().map(|piece| piece.range()[0]).collect();
                let found = ends.iter().map(|end| (end - corner).abs()).fold(f64::INFINITY, f64::min);
                assert!(
                    found < 1e-5 * (to - from) && ends.len() <= 4,
                    "{flank} {shape:?}: {ends:?} {corner}"
                );
                let motion = *pair.motion();
                let radius = pair.tool().rounding().radius;
                let ball = |w: f64| (edge.section(w).centre, radius);
                for x in [-0.8, -0.2, 0.62, 0.9] {
                    let track = MeasuringTrack::new(&edge, x).unwrap();
                    let piece = edge.piece(track.contact.w).range();
                    let skiving = Skiving {
                        law: None,
                        flank: edge.flank().helicoid().flank(),
                        motion: &motion,
                        edge: &ball,
                        places: [piece[0] + 1e-9, piece[1]],
                        tool_angles: [motion.tool_angle - 0.22, motion.tool_angle + 0.22],
                    };
                    let left = skiving.profile(&[track.contact.w]).unwrap()[0].unwrap().left;
                    let off = left - track.contact.modification;
                    assert!(off.abs() < 0.1e-3, "{flank} {shape:?} {x}: {off}");
                    let tangent: Vector3<f64> = track.section.tangent;
                    assert!(tangent.dot(&track.contact.normal).abs() < 1e-8, "{flank} {shape:?} {x}");
                }
            }
        }
    }
}
