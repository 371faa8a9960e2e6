//! Options of a writer, and what it gives back. Knows no grammar.

use crate::NcError;

/// Decimals of the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decimals {
    /// Of lengths in mm: 3 to 9.
    pub mm: u8,
    /// Of angles in degrees: 3 to 9.
    pub deg: u8,
    /// Of inverse-time feeds: 3 to 9; four more below F1, so that long blocks keep their time. Below 6 a block keeps its time to
    /// half a unit of the feed's last digit only.
    pub feed: u8,
}

impl Decimals {
    /// What `docs/mathematics/programs.md#cutters` has for five-axis milling: 0.1 um, 1e-5 deg, a thousandth of the feed.
    pub const MILLING: Self = Self { mm: 4, deg: 5, feed: 3 };
}

impl Default for Decimals {
    fn default() -> Self {
        Self { mm: 6, deg: 7, feed: 6 }
    }
}

/// Decimals of what only blocks under tip control have (`docs/mathematics/programs.md#cutters`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TipDecimals {
    /// Of the speed of the tip in mm/min: 1 to 6.
    pub speed: u8,
    /// Of the components of a direction: 4 to 9.
    pub direction: u8,
}

impl Default for TipDecimals {
    fn default() -> Self {
        Self { speed: 1, direction: 6 }
    }
}

/// Where the words G93 and G94 stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FeedWords {
    /// Where the kind of the feed changes.
    #[default]
    OnChange,
    /// In every straight block of axis values, G94 beside G0; under tip control where the kind changes.
    AxisBlocks,
}

/// Options of the writers (`docs/mathematics/programs.md`).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WriteOptions {
    /// Decimals of the numbers.
    pub decimals: Decimals,
    /// Decimals of what only blocks under tip control have.
    pub tip_decimals: TipDecimals,
    /// Where the words G93 and G94 stand.
    pub feed_words: FeedWords,
    /// Numbers N of the straight blocks: so much the first, and so much more each further one; 1 to 1000.
    pub line_numbers: Option<u32>,
    /// Rotary axes of the control count modulo 360 deg: they are moved by increments below one turn. Blocks of a turn or more
    /// are refused; [`crate::split_turns`] divides them.
    pub incremental_rotary: bool,
    /// For LinuxCNC.
    pub linuxcnc: LinuxCncOptions,
    /// For Fanuc.
    pub fanuc: FanucOptions,
}

/// Options for LinuxCNC.
#[derive(Clone, Debug, PartialEq)]
pub struct LinuxCncOptions {
    /// Acceleration limit of each axis, mm/s^2 or rad/s^2, in the order of the program's axes; what is absent is not judged.
    pub accelerations: Vec<f64>,
    /// Servo period of the control, s.
    pub servo_period: f64,
    /// Only the letters X Y Z A B C and spindle 0, as the stand-alone interpreter `rs274` takes them.
    pub stand_alone: bool,
    /// Makes gears possible: a HAL netlist beside the program.
    pub hal: Option<HalOptions>,
}

impl Default for LinuxCncOptions {
    fn default() -> Self {
        Self { accelerations: Vec::new(), servo_period: 1e-3, stand_alone: false, hal: None }
    }
}

/// Options of the HAL netlist of a gear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalOptions {
    /// Largest distance between a coupled follower and its wanted place before the guard opens, rad or mm as the follower.
    pub following_error: f64,
}

/// Options for Fanuc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FanucOptions {
    /// The number after O: 1 to 99999999.
    pub program_number: u32,
    /// Switches the contour mode on at the begin and off at the end.
    pub contour_mode: bool,
}

impl Default for FanucOptions {
    fn default() -> Self {
        Self { program_number: 1, contour_mode: false }
    }
}

impl WriteOptions {
    /// Checks the ranges.
    pub(super) fn check(&self) -> Result<(), NcError> {
        let bad = |reason: &str| Err(NcError::BadHeader { reason: reason.into() });
        let decimals = self.decimals;
        if !(3..=9).contains(&decimals.mm)
            || !(3..=9).contains(&decimals.deg)
            || !(3..=9).contains(&decimals.feed)
        {
            return bad("decimals; allowed: 3 to 9 for mm, deg and the feed");
        }
        let tip = self.tip_decimals;
        if !(1..=6).contains(&tip.speed) || !(4..=9).contains(&tip.direction) {
            return bad("decimals of tip control; allowed: 1 to 6 for the speed, 4 to 9 for the direction");
        }
        if self.line_numbers.is_some_and(|step| !(1..=1000).contains(&step)) {
            return bad("step of the line numbers; allowed: 1 to 1000");
        }
        let linuxcnc = &self.linuxcnc;
        let positive = |value: f64| value > 0.0 && value.is_finite();
        if !linuxcnc.accelerations.iter().all(|&a| positive(a)) || !positive(linuxcnc.servo_period) {
            return bad("accelerations and servo period; allowed: finite numbers above 0");
        }
        if linuxcnc.hal.is_some_and(|hal| !positive(hal.following_error) || hal.following_error < 1e-9) {
            return bad("following error of the HAL guard; allowed: from 1e-9");
        }
        if !(1..=99_999_999).contains(&self.fanuc.program_number) {
            return bad("program number; allowed: 1 to 99999999");
        }
        Ok(())
    }
}

/// A program in a control's language.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    /// The program: ASCII with LF.
    pub text: String,
    /// The netlist that runs the gears (LinuxCNC with [`HalOptions`]).
    pub hal: Option<String>,
    /// What rounding did.
    pub rounding: Rounding,
    /// What the control will not keep.
    pub warnings: Vec<Warning>,
}

/// Largest changes by rounding the numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rounding {
    /// Half a unit of the last digit of lengths, mm.
    pub linear: f64,
    /// Half a unit of the last digit of angles, rad.
    pub rotary: f64,
    /// Change of the ratio of a lead term, rad/mm: times the travel it is an angle of the follower. 0 without such a term.
    pub lead_ratio: f64,
}

/// What a control will not keep although it takes the program.
#[derive(Clone, Debug, PartialEq)]
pub enum Warning {
    /// Blocks shorter than the control can run them (`docs/mathematics/programs.md#the-independent-reader`): they take longer than
    /// programmed.
    TimeNotKept {
        /// How many.
        count: usize,
        /// The block that misses most, counted from 1.
        worst_block: usize,
        /// Its programmed time, s.
        duration: f64,
        /// The least time that the control needs, s.
        least: f64,
    },
}

impl Warning {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::TimeNotKept { .. } => "nc-time-not-kept",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::TimeNotKept { .. } => {
                "take longer blocks, a longer time, or one straight block for the whole stroke"
            }
        }
    }
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::TimeNotKept { count, worst_block, duration, least } => write!(
                f,
                "{count} blocks take longer than programmed; block {worst_block} needs {least:.6} s instead of {duration:.6} s"
            ),
        }
    }
}
