//! Values that a measuring machine printed, and what their codes of five digits mean.

use serde::{Deserialize, Serialize};

use super::Section;
use foundation::geometry::Flank;

/// What was evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Characteristic {
    /// Helix slope deviation f_Hbeta.
    HelixSlope,
    /// Total helix deviation F_beta.
    HelixTotal,
    /// Helix form deviation f_fbeta.
    HelixForm,
    /// Profile slope deviation f_Halpha.
    ProfileSlope,
    /// Total profile deviation F_alpha.
    ProfileTotal,
    /// Profile form deviation f_falpha.
    ProfileForm,
    /// Tip relief f_Ko, negative where material is relieved.
    TipRelief,
    /// Root circle.
    RootCircle,
    /// Tip circle.
    TipCircle,
    /// Single pitch deviation f_p.
    SinglePitch,
    /// Difference of adjacent pitches f_u.
    AdjacentPitch,
    /// Range of the pitches R_p.
    PitchRange,
    /// Total cumulative pitch deviation F_p.
    CumulativePitch,
    /// Cumulative pitch deviation of a sector, F_pz/8.
    SectorPitch,
    /// Run-out F_r.
    RunOut,
    /// Range of the tooth thickness R_s.
    ThicknessRange,
    /// Measure over balls M_dK.
    OverBalls,
    /// Span W_k.
    Span,
    /// A code whose meaning is not known.
    Unknown,
}

/// Which of three lines of a flank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Position {
    /// The middle one.
    Middle,
    /// Inner helix (f) or lower profile (u).
    InnerOrBottom,
    /// Outer helix (k) or upper profile (o).
    OuterOrTop,
}

/// Of what a value is the statistic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Statistic {
    /// Of one measured tooth: which in the order of measuring, from 1.
    Tooth(u8),
    /// Mean over the teeth.
    Mean,
    /// Largest minus smallest.
    Range,
    /// Largest.
    Max,
    /// Smallest.
    Min,
    /// The value of the whole gear.
    Gear,
}

/// The unit of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Unit {
    /// Micrometre.
    Um,
    /// Millimetre.
    Mm,
}

/// What a code of five digits stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct ResultCode {
    /// What was evaluated.
    pub characteristic: Characteristic,
    /// On which line.
    pub position: Position,
    /// On which flank; `None` where both together give the value.
    pub flank: Option<Flank>,
    /// Of what it is the statistic.
    pub statistic: Statistic,
}

impl ResultCode {
    /// The meaning of a code c g g a i. The label beside it is never looked at.
    pub fn of(code: u32) -> Self {
        let unknown = Self {
            characteristic: Characteristic::Unknown,
            position: Position::Middle,
            flank: None,
            statistic: Statistic::Gear,
        };
        match code / 10_000 {
            class @ (1 | 2) => Self::of_line(class, code % 10_000).unwrap_or(unknown),
            3 => Self::of_gear(code).unwrap_or(unknown),
            _ => unknown,
        }
    }

    fn of_line(class: u32, rest: u32) -> Option<Self> {
        let (group, a, i) = (rest / 100, rest / 10 % 10, rest % 10);
        let helix = class == 1;
        let either = |of_helix, of_profile| if helix { of_helix } else { of_profile };
        let (characteristic, first) = match group {
            1..=3 => (either(Characteristic::HelixSlope, Characteristic::ProfileSlope), 1),
            4..=6 => (either(Characteristic::HelixTotal, Characteristic::ProfileTotal), 4),
            7..=9 => (either(Characteristic::HelixForm, Characteristic::ProfileForm), 7),
            16..=18 if !helix => (Characteristic::TipRelief, 16),
            64..=66 if !helix => (Characteristic::RootCircle, 64),
            67..=69 if !helix => (Characteristic::TipCircle, 67),
            _ => return None,
        };
        let position =
            [Position::Middle, Position::InnerOrBottom, Position::OuterOrTop][(group - first) as usize];
        let (left, statistic) = match a {
            1 | 2 => (a == 1, Statistic::Tooth(i as u8)),
            3 | 4 => (a == 3, Statistic::Mean),
            5 | 6 => (a == 5, Statistic::Range),
            7 | 8 => (a == 7, Statistic::Max),
            _ => (a == 9, Statistic::Min),
        };
        // A circle has no flank; the digit only keeps the lines of a file apart.
        let circle = matches!(characteristic, Characteristic::RootCircle | Characteristic::TipCircle);
        let flank = (!circle).then_some(if left { Flank::Left } else { Flank::Right });
        Some(Self { characteristic, position, flank, statistic })
    }

    fn of_gear(code: u32) -> Option<Self> {
        let flank = match code / 10 % 10 {
            1 => Some(Flank::Left),
            2 => Some(Flank::Right),
            _ => None,
        };
        let of = |characteristic, flank, statistic| {
            Some(Self { characteristic, position: Position::Middle, flank, statistic })
        };
        let pitch = |characteristic| flank.and_then(|flank| of(characteristic, Some(flank), Statistic::Gear));
        match code / 100 {
            301 => pitch(Characteristic::SinglePitch),
            304 => pitch(Characteristic::AdjacentPitch),
            307 => pitch(Characteristic::PitchRange),
            310 => pitch(Characteristic::CumulativePitch),
            313 => pitch(Characteristic::SectorPitch),
            316 => of(Characteristic::RunOut, None, Statistic::Gear),
            319 => of(Characteristic::ThicknessRange, None, Statistic::Gear),
            328 => of(Characteristic::OverBalls, None, Statistic::Mean),
            331 => of(Characteristic::OverBalls, None, Statistic::Min),
            334 => of(Characteristic::OverBalls, None, Statistic::Max),
            346 => of(Characteristic::Span, None, Statistic::Mean),
            349 => of(Characteristic::Span, None, Statistic::Min),
            352 => of(Characteristic::Span, None, Statistic::Max),
            _ => None,
        }
    }

    /// The unit in which files print the value.
    pub fn unit(&self) -> Unit {
        use Characteristic::{OverBalls, RootCircle, Span, TipCircle};
        match self.characteristic {
            RootCircle | TipCircle | OverBalls | Span => Unit::Mm,
            _ => Unit::Um,
        }
    }
}

/// A value that was printed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quantity {
    /// Its code in the file.
    pub code: u32,
    /// What the code stands for.
    #[serde(flatten)]
    pub meaning: ResultCode,
    /// The value as printed; `None` if it was not measured or is not available.
    pub value: Option<f64>,
    /// Its unit.
    pub unit: Unit,
    /// sigma_F of a slope: printed value = sigma_F times the slope of the material.
    pub sigma: Option<f64>,
    /// Length to which a slope refers, mm.
    pub reference_length_mm: Option<f64>,
    /// The section it stands in.
    pub section: Section,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_mean_what_the_specification_lists() {
        let of = |code| {
            let c = ResultCode::of(code);
            (c.characteristic, c.position, c.flank, c.statistic)
        };
        use {Characteristic as C, Position as P, Statistic as S};
        let (left, right) = (Some(Flank::Left), Some(Flank::Right));
        assert_eq!(of(10112), (C::HelixSlope, P::Middle, left, S::Tooth(2)));
        assert_eq!(of(10523), (C::HelixTotal, P::InnerOrBottom, right, S::Tooth(3)));
        assert_eq!(of(10960), (C::HelixForm, P::OuterOrTop, right, S::Range));
        assert_eq!(of(20130), (C::ProfileSlope, P::Middle, left, S::Mean));
        assert_eq!(of(20400), (C::ProfileTotal, P::Middle, right, S::Min));
        assert_eq!(of(20490), (C::ProfileTotal, P::Middle, left, S::Min));
        assert_eq!(of(21680), (C::TipRelief, P::Middle, right, S::Max));
        assert_eq!(of(26430), (C::RootCircle, P::Middle, None, S::Mean));
        assert_eq!(of(26740), (C::TipCircle, P::Middle, None, S::Mean));
        assert_eq!(of(30120), (C::SinglePitch, P::Middle, right, S::Gear));
        assert_eq!(of(31310), (C::SectorPitch, P::Middle, left, S::Gear));
        assert_eq!(of(31610), (C::RunOut, P::Middle, None, S::Gear));
        assert_eq!(of(33110), (C::OverBalls, P::Middle, None, S::Min));
        assert_eq!(of(35210), (C::Span, P::Middle, None, S::Max));
        assert_eq!(ResultCode::of(34610).unit(), Unit::Mm);
        for unknown in [0, 99_999, 15_000, 30_100, 30_190, 39_999, 40_000] {
            assert_eq!(of(unknown).0, C::Unknown, "{unknown}");
        }
    }
}
