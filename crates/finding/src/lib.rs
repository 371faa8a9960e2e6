//! What an error or a remark says beside its message: a stable code and a way out. [`Finding`] is the trait and the derive macro;
//! message, code and way out stand together at the variant that they belong to.
//!
//! ```
//! use finding::Finding;
//! use thiserror::Error;
//!
//! /// Why a tooth has no flank.
//! #[derive(Debug, Error, Finding)]
//! enum FlankError {
//!     /// A radius below the base circle.
//!     #[error("radius {radius} mm lies below the base circle")]
//!     #[finding(code = "radius-below-base-circle", bad_input)]
//!     #[way_out("raise the diameter above {:.3} mm", 2.0 * base_radius)]
//!     BelowBaseCircle { radius: f64, base_radius: f64 },
//!     /// Nothing is left at the tip.
//!     #[error("the tooth is pointed")]
//!     #[finding(code = "tooth-pointed")]
//!     #[way_out("reduce the tip diameter or the profile shift")]
//!     ToothPointed,
//! }
//!
//! /// Why a gear is none.
//! #[derive(Debug, Error, Finding)]
//! enum GearError {
//!     /// A flank is none.
//!     #[error(transparent)]
//!     #[finding(transparent, bad_input = _0.is_bad_input())]
//!     Flank(#[from] FlankError),
//!     /// A flank is missing.
//!     #[error("the {0} flank is missing")]
//!     #[finding(code = "no-flank", bad_input)]
//!     #[way_out("describe the {0} flank")]
//!     NoFlank(&'static str),
//! }
//!
//! let low = GearError::from(FlankError::BelowBaseCircle { radius: 9.0, base_radius: 9.5 });
//! assert_eq!((low.code(), low.is_bad_input()), ("radius-below-base-circle", true));
//! assert_eq!(low.way_out(), "raise the diameter above 19.000 mm");
//! assert_eq!(GearError::NoFlank("left").way_out(), "describe the left flank");
//! assert!(!FlankError::ToothPointed.is_bad_input());
//!
//! // Code that serves every finding takes the trait.
//! fn line(finding: &impl Finding) -> String {
//!     format!("{finding} [{}]: {}", finding.code(), finding.way_out())
//! }
//! assert!(line(&FlankError::ToothPointed).starts_with("the tooth is pointed [tooth-pointed]: reduce"));
//! ```
//!
//! # Attributes of a variant
//!
//! | attribute | meaning |
//! |---|---|
//! | `#[finding(code = "kebab-case")]` | the code; an expression in place of the text is computed from the fields |
//! | `#[finding(transparent)]` | code and way out are those of the only field |
//! | `#[finding(transparent = field)]` | the same of a field among others |
//! | `#[finding(.., bad_input)]`, `#[finding(.., bad_input = condition)]` | the input itself is wrong, always or on a condition |
//! | `#[way_out("text")]`, `#[way_out("text {field} {:.3}", expression)]` | the way out, formatted as by [`format!`] |
//! | `#[way_out(with = expression)]` | the way out as what makes a `Cow<'static, str>` |
//!
//! Fields have their names, those of a tuple are `_0`, `_1` in expressions and `{0}`, `{1}` in texts; all of them are references. A
//! `#[way_out]` beside `transparent` replaces that of the field. Methods `code` and `way_out` are made of the enum itself as well,
//! so that a caller imports nothing, and `is_bad_input` if a variant has `bad_input`; the others are then limits of the bodies.
//!
//! A variant without a code does not compile:
//!
//! ```compile_fail
//! #[derive(Debug, thiserror::Error, finding::Finding)]
//! enum FlankError {
//!     #[error("the tooth is pointed")]
//!     #[way_out("reduce the tip diameter")]
//!     ToothPointed,
//! }
//! ```
//!
//! One without a way out neither:
//!
//! ```compile_fail
//! #[derive(Debug, thiserror::Error, finding::Finding)]
//! enum FlankError {
//!     #[error("the tooth is pointed")]
//!     #[finding(code = "tooth-pointed")]
//!     ToothPointed,
//! }
//! ```

use std::borrow::Cow;
use std::fmt;

pub use finding_derive::Finding;

/// An error or a remark with its code and its way out; its message is its `Display`.
pub trait Finding: fmt::Display {
    /// Stable kebab-case code.
    fn code(&self) -> &'static str;

    /// What the user can do about it, in one sentence.
    fn way_out(&self) -> Cow<'static, str>;
}
