//! Turns an inspection that was taken from the other end of the gear: what the file calls left is right, and its heights count the other way.
//! The hand of the gear stays, and so does every printed value. Knows no evaluation.

use super::{
    Characteristic, Conditions, CountingDirection, FlankConditions, Inspection, Position, ProfilePositions,
    Quantity, Trace, TraceKind,
};
use foundation::geometry::{Flank, Sides};

impl Inspection {
    /// As seen from +z of the gear. Teeth keep the numbers of the machine, which then run the other way round.
    #[must_use]
    pub fn turned(mut self) -> Self {
        self.conditions = self.conditions.turned();
        self.traces = self.traces.into_iter().map(turned_trace).collect();
        for field in &mut self.topographies {
            field.flank = field.flank.other();
            field.points_mm.iter_mut().for_each(|[_, z]| *z = 0.0 - *z);
        }
        if let Some(pitch) = &mut self.pitch {
            pitch.flanks = swapped(std::mem::take(&mut pitch.flanks));
            pitch.counting = pitch.counting.map(|counting| match counting {
                CountingDirection::Clockwise => CountingDirection::CounterClockwise,
                CountingDirection::CounterClockwise => CountingDirection::Clockwise,
            });
        }
        for circle in [&mut self.circles.root, &mut self.circles.tip].into_iter().flatten() {
            circle.z_mm = 0.0 - circle.z_mm;
        }
        self.results.iter_mut().for_each(turn_result);
        self
    }
}

fn swapped<T>(sides: Sides<T>) -> Sides<T> {
    Sides { left: sides.right, right: sides.left }
}

impl Conditions {
    /// As seen from the other end.
    #[must_use]
    pub fn turned(self) -> Self {
        // 0 - 0 is 0, while -0 would show its sign.
        let minus = |value: Option<f64>| value.map(|z| 0.0 - z);
        let flank = |of: FlankConditions| FlankConditions {
            z_a_mm: minus(of.z_b_mm),
            z_1_mm: minus(of.z_2_mm),
            z_2_mm: minus(of.z_1_mm),
            z_b_mm: minus(of.z_a_mm),
            profiles: ProfilePositions {
                bottom_mm: minus(of.profiles.top_mm),
                middle_mm: minus(of.profiles.middle_mm),
                top_mm: minus(of.profiles.bottom_mm),
            },
            // The printed value stays while the slope is counted towards the other end.
            printed_sign: minus(of.printed_sign),
            ..of
        };
        let flanks = swapped(self.flanks).map(|_, conditions| flank(*conditions));
        Self { flanks, turned: !self.turned, ..self }
    }
}

fn turned_trace(mut trace: Trace) -> Trace {
    trace.flank = trace.flank.other();
    match trace.kind {
        TraceKind::Profile => {
            trace.position_mm = 0.0 - trace.position_mm;
            trace.tag = match trace.tag.as_str() {
                "u" => "o".into(),
                "o" => "u".into(),
                _ => trace.tag,
            };
        }
        TraceKind::Helix => {
            trace.abscissa_mm.reverse();
            trace.abscissa_mm.iter_mut().for_each(|z| *z = 0.0 - *z);
            trace.f_um.reverse();
        }
    }
    trace
}

fn turn_result(of: &mut Quantity) {
    use Characteristic::{
        HelixSlope, ProfileForm, ProfileSlope, ProfileTotal, RootCircle, TipCircle, TipRelief,
    };
    of.meaning.flank = of.meaning.flank.map(Flank::other);
    let characteristic = of.meaning.characteristic;
    if characteristic == HelixSlope {
        of.sigma = of.sigma.map(|sigma| -sigma);
    }
    if matches!(
        characteristic,
        ProfileSlope | ProfileTotal | ProfileForm | TipRelief | RootCircle | TipCircle
    ) {
        of.meaning.position = match of.meaning.position {
            Position::Middle => Position::Middle,
            Position::InnerOrBottom => Position::OuterOrTop,
            Position::OuterOrTop => Position::InnerOrBottom,
        };
    }
}
