//! The dresser of the job on other worms: over the pitch diameter, which shrinks with every dressing, or over the pressure angle
//! (`docs/mathematics/dressing.md#conditions`).

use super::bodies::{Bodies, Change};
use crate::job::{Compare, LoadedJob, Steps};
use crate::workflow::explore::Refused;
use dressing::{
    DresserSection, DresserTool, DressingError, StretchAngle, ThreadSpace, WormSeat, angle_of_least_stretch,
    cone_without_stretch, fit_profile_along, profile_error, uncorrected_profile,
};
use foundation::geometry::{Flank, Sides};
use generating::{GeneratingError, GrindingSetup};
use schemars::JsonSchema;
use serde::Serialize;

/// The dresser on one worm.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WormPoint {
    /// Pitch diameter of the worm (mm) or its pressure angle (deg).
    pub value: f64,
    /// Profile crowning on the gear that comes about without corrections of crossing angle and offset; absent where these do not
    /// meet both ends of the profile, as on a worm of another pressure angle.
    pub uncorrected_crowning_um: Option<f64>,
    /// Relative profile stretch with corrections.
    pub stretch: f64,
    /// Correction of the worm angle.
    #[serde(rename = "d_phi_S_deg")]
    pub d_phi_s_deg: f64,
    /// Correction of the crossing angle.
    pub d_gamma_deg: f64,
    /// Correction of the centre distance.
    pub d_d_mm: f64,
    /// Correction of the offset.
    #[serde(rename = "d_v_yA_mm")]
    pub d_v_ya_mm: f64,
    /// Largest distance of the dressed profile from the involute with corrections, normal.
    pub error_um: f64,
    /// Largest tip land that clears the opposite flank; absent where none does.
    pub largest_tip_land_mm: Option<f64>,
    /// Pressure angle of the worm at which the profile is not stretched; absent where none is near.
    pub angle_without_stretch_deg: Option<f64>,
    /// The worm of this diameter for both flanks of an asymmetric gear at once; absent over other quantities and for symmetric
    /// gears, whose flanks share the angle above.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub both_flanks: Option<BothFlanks>,
}

/// The worm on which the dresser works without stretch on both flanks of an asymmetric gear.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BothFlanks {
    /// The cylindrical worm on which the larger stretch is least; absent where none is near.
    pub cylindrical: Option<WormOfLeastStretch>,
    /// The conical worm that stretches neither flank; absent where none is near.
    pub conical: Option<WormOfLeastStretch>,
}

/// A worm and what it leaves of the stretch.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WormOfLeastStretch {
    /// Cone angle.
    pub cone_angle_deg: f64,
    /// Normal pressure angle of the left flank; the right one follows from the module that both share.
    pub pressure_angle_left_deg: f64,
    /// Relative profile stretch of the left flank.
    pub stretch_left: f64,
    /// Relative profile stretch of the right flank.
    pub stretch_right: f64,
}

/// The dresser on worms of one number of threads, or whatever else is compared.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WormCurve {
    /// What tells the bodies from the others; empty where nothing is compared.
    pub bodies: String,
    /// Points in ascending order.
    pub points: Vec<WormPoint>,
    /// Worms on which the dresser does not work, with the reason.
    pub missing: Vec<(f64, Refused)>,
}

impl WormCurve {
    /// The curve in one line.
    pub fn summary(&self) -> String {
        let (Some(first), Some(last)) = (self.points.first(), self.points.last()) else {
            return match self.missing.first() {
                Some((_, refused)) => format!("{}: {}", refused.code, refused.text),
                None => "no worm".into(),
            };
        };
        format!(
            "at {} / {}: stretch {:.2} / {:.2} %{}",
            first.value,
            last.value,
            100.0 * first.stretch,
            100.0 * last.stretch,
            if self.missing.is_empty() {
                String::new()
            } else {
                format!("; {} worms fail", self.missing.len())
            }
        )
    }
}

/// Bracket on either side of the worm's own pressure angle in which P = 0 is sought, degrees (`docs/mathematics/dressing.md#conditions`).
const BRACKET_DEG: f64 = 2.0;

/// What runs along the abscissa.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// The pitch diameter of the worm.
    Diameter,
    /// The normal pressure angle of the worm's left flank.
    PressureAngle,
}

impl Along {
    fn change(self, value: f64) -> Change {
        match self {
            Self::Diameter => Change::WormPitchDiameter(value),
            Self::PressureAngle => Change::PressureAngle(value),
        }
    }

    /// The value of the worm for which the dresser is made.
    fn own(self, setup: &GrindingSetup) -> f64 {
        match self {
            Self::Diameter => 2.0 * setup.worm_pitch_radius,
            Self::PressureAngle => setup.pair.worm.data().pressure_angle.left.to_degrees(),
        }
    }
}

/// All curves of a study.
pub struct Study<'a> {
    /// The job.
    pub loaded: &'a LoadedJob,
    /// The flank.
    pub flank: Flank,
    /// What varies.
    pub along: Along,
    /// Its values.
    pub steps: Steps,
    /// Pitch diameter of the worms of a study over the pressure angle, where it is not that of the dresser's own worm.
    pub diameter: Option<f64>,
}

impl Study<'_> {
    /// Changes that make the curves; one empty list where nothing is compared.
    pub fn curves(compare: Option<&Compare>) -> Vec<Vec<Change>> {
        compare.map_or_else(
            || vec![Vec::new()],
            |compare| Change::all(compare).into_iter().map(|change| vec![change]).collect(),
        )
    }

    /// The curve of bodies with changes.
    pub fn curve(&self, changes: &[Change]) -> WormCurve {
        let bodies = changes.first().map_or_else(String::new, |change| change.name());
        let mut curve = WormCurve { bodies, points: Vec::new(), missing: Vec::new() };
        let own = Bodies::of(self.loaded, changes);
        let dresser = match own.as_ref().map(|setup| (setup, setup.dresser())) {
            Ok((setup, Ok(dresser))) => (setup, dresser),
            Ok((_, Err(error))) => return self.none(curve, &Refused::from(&error)),
            Err(refused) => return self.none(curve, refused),
        };
        for value in self.steps.values() {
            match self.point(changes, dresser.0, dresser.1, value) {
                Ok(point) => curve.points.push(point),
                Err(refused) => curve.missing.push((value, refused)),
            }
        }
        curve
    }

    fn none(&self, mut curve: WormCurve, refused: &Refused) -> WormCurve {
        curve.missing = self.steps.values().map(|value| (value, refused.clone())).collect();
        curve
    }

    /// The worm of the study with further changes, as it sits under the dresser.
    fn seat(&self, changes: &[Change], more: &[Change]) -> Result<(WormSeat, GrindingSetup), Refused> {
        let mut all = changes.to_vec();
        all.extend(self.diameter.map(Change::WormPitchDiameter));
        all.extend(more);
        let setup = Bodies::of(self.loaded, &all)?;
        let plain = setup.dresser().map_err(|error| Refused::from(&error))?;
        let seat = WormSeat {
            worm: setup.pair.worm,
            tip_radius: setup.worm_tip_radius,
            chains: Sides::from_fn(|flank| plain.flanks[flank].chain),
            ranges: Sides::from_fn(|flank| plain.flanks[flank].range),
        };
        Ok((seat, setup))
    }

    fn point(
        &self,
        changes: &[Change],
        own: &GrindingSetup,
        dresser: &DresserTool,
        value: f64,
    ) -> Result<WormPoint, Refused> {
        let flank = self.flank;
        let (seat, setup) = self.seat(changes, &[self.along.change(value)])?;
        let refused = |error: DressingError| Refused::from(&GeneratingError::from(error));
        // On the way from the dresser's own worm a worm that does not exist ends the way.
        let (from, own_diameter) = (self.along.own(own), 2.0 * own.worm_pitch_radius);
        let path = |share: f64| {
            let mut more = vec![self.along.change(from + share * (value - from))];
            if let Some(diameter) = self.diameter {
                more.push(Change::WormPitchDiameter(own_diameter + share * (diameter - own_diameter)));
            }
            self.seat(changes, &more)
                .map(|(seat, _)| seat)
                .map_err(|_| DressingError::NoConjugate { flank, w: dresser.flanks[flank].range.middle() })
        };
        let fit = fit_profile_along(dresser, flank, &path, 0.0).map_err(refused)?;
        let tool = dresser.on_worm(&seat).map_err(refused)?;
        let radius = seat.reference_radius();
        let uncorrected = uncorrected_profile(&tool, flank, radius).ok();
        let (error, _) = profile_error(&tool, flank, fit.dk, 0.0).map_err(refused)?;
        let tip = self.loaded.job.dresser.as_ref().map_or(0.0, |d| 0.5 * d.tip_diameter);
        let land = DresserSection::new(&tool, flank, tip)
            .and_then(|section| section.largest_tip_land(&fit.dk, 0.0, ThreadSpace::default()))
            .map_err(refused)?;
        let over_diameter = self.along == Along::Diameter;
        let by_angle =
            over_diameter.then_some(ByAngle { study: self, changes, dresser, own, diameter: value });
        let asymmetric = {
            let angles = setup.pair.work.data().pressure_angle;
            angles.left != angles.right
        };
        Ok(WormPoint {
            value,
            uncorrected_crowning_um: uncorrected.map(|(_, f)| -f / setup.lines[flank].cos_b2 * 1e3),
            stretch: fit.stretch,
            d_phi_s_deg: fit.dk[0].to_degrees(),
            d_gamma_deg: fit.dk[1].to_degrees(),
            d_d_mm: fit.dk[2],
            d_v_ya_mm: fit.dk[3],
            error_um: error * 1e3,
            largest_tip_land_mm: land,
            angle_without_stretch_deg: by_angle.as_ref().and_then(ByAngle::without_stretch),
            both_flanks: by_angle.as_ref().filter(|_| asymmetric).map(ByAngle::both_flanks),
        })
    }
}

/// Worms of one diameter over their angles.
struct ByAngle<'a> {
    study: &'a Study<'a>,
    changes: &'a [Change],
    dresser: &'a DresserTool,
    own: &'a GrindingSetup,
    diameter: f64,
}

impl ByAngle<'_> {
    /// The worm of a pressure angle of the left flank and a cone angle, rad.
    fn seat(&self, angle: f64, cone_angle: f64) -> Result<WormSeat, DressingError> {
        let more = [
            Change::WormPitchDiameter(self.diameter),
            Change::PressureAngle(angle.to_degrees()),
            Change::ConeAngle(cone_angle.to_degrees()),
        ];
        self.study.seat(self.changes, &more).map(|(seat, _)| seat).map_err(|_| {
            let flank = self.study.flank;
            DressingError::NoConjugate { flank, w: self.dresser.flanks[flank].range.middle() }
        })
    }

    /// The cylindrical worm of least stretch on the `flanks`.
    fn least(&self, flanks: &[Flank]) -> Option<StretchAngle> {
        let own = self.own.pair.worm.data().pressure_angle.left.to_degrees();
        let bracket = [own - BRACKET_DEG, own + BRACKET_DEG].map(f64::to_radians);
        angle_of_least_stretch(self.dresser, flanks, &|angle| self.seat(angle, 0.0), bracket).ok()
    }

    /// The pressure angle without stretch on the flank of the study, degrees.
    fn without_stretch(&self) -> Option<f64> {
        let flank = self.study.flank;
        let seat = self.seat(self.least(&[flank])?.angle, 0.0).ok()?;
        Some(seat.worm.data().pressure_angle[flank].to_degrees())
    }

    fn both_flanks(&self) -> BothFlanks {
        let cylindrical = self.least(&Flank::BOTH);
        // Without a cylindrical worm the dresser's own angle is where to begin.
        let own = self.own.pair.worm.data().pressure_angle.left;
        let start = cylindrical.map_or(own, |least| least.angle);
        let conical = cone_without_stretch(self.dresser, &|angle, cone| self.seat(angle, cone), start).ok();
        let worm = |angle: f64, cone: f64, stretch: Sides<f64>| WormOfLeastStretch {
            cone_angle_deg: cone.to_degrees(),
            pressure_angle_left_deg: angle.to_degrees(),
            stretch_left: stretch.left,
            stretch_right: stretch.right,
        };
        BothFlanks {
            cylindrical: cylindrical.and_then(|least| {
                let (left, right) = least.stretch.left.zip(least.stretch.right)?;
                Some(worm(least.angle, 0.0, Sides { left, right }))
            }),
            conical: conical.map(|found| worm(found.angle, found.cone_angle, found.stretch)),
        }
    }
}
