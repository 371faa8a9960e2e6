//! Conditions that vary along the worm: the four rows as functions of the worm position and of where the dresser touches
//! (`docs/mathematics/dressing.md#conditions`).
//!
//! Rows by laws (`RowAlong`) are kept for pitch points and maps that move over the width: no command reaches them yet.

use crate::Condition;
use foundation::geometry::Flank;

/// Four conditions at every worm position.
pub trait ConditionsAlong {
    /// The conditions at worm position v (mm). `b` holds for each row that is a pitch point the worm z (mm) of the place that it
    /// stands on, as far as it is known; for the other rows it says nothing.
    fn at(&self, v: f64, b: &[f64; 4]) -> [Condition; 4];
}

impl<F: Fn(f64, &[f64; 4]) -> [Condition; 4]> ConditionsAlong for F {
    fn at(&self, v: f64, b: &[f64; 4]) -> [Condition; 4] {
        self(v, b)
    }
}

/// A function of one or two lengths, mm.
type Law<'a> = &'a (dyn Fn(f64) -> f64 + 'a);
type Surface<'a> = &'a (dyn Fn(f64, f64) -> f64 + 'a);

/// One condition whose numbers vary along the worm. Pitch points of both flanks may be mixed: each stands on its own place b.
#[derive(Clone, Copy)]
pub enum RowAlong<'a> {
    /// Pitch point at length of roll w(b) with modification f(w, b).
    Point {
        /// Flank.
        flank: Flank,
        /// Length of roll over worm z.
        w: Law<'a>,
        /// Wanted f_n over length of roll and worm z.
        f: Surface<'a>,
    },
    /// Radius map: dresser parameter t(v) dresses length of roll w(v).
    Map {
        /// Flank.
        flank: Flank,
        /// Dresser parameter over the worm position.
        t: Law<'a>,
        /// Length of roll over the worm position.
        w: Law<'a>,
    },
    /// Head height: the head profile at t_H(v) dresses radius r(v).
    Head {
        /// Parameter of the head profile over the worm position.
        t: Law<'a>,
        /// Radius over the worm position.
        r: Law<'a>,
    },
    /// Correction j is x(v).
    Fixed {
        /// Component of DK.
        j: usize,
        /// Its value over the worm position, rad or mm.
        x: Law<'a>,
    },
}

impl ConditionsAlong for [RowAlong<'_>; 4] {
    fn at(&self, v: f64, b: &[f64; 4]) -> [Condition; 4] {
        std::array::from_fn(|i| match self[i] {
            RowAlong::Point { flank, w, f } => {
                let w = w(b[i]);
                Condition::Point { flank, w, f: f(w, b[i]) }
            }
            RowAlong::Map { flank, t, w } => Condition::Map { flank, t: t(v), w: w(v) },
            RowAlong::Head { t, r } => Condition::Head { t: t(v), r: r(v) },
            RowAlong::Fixed { j, x } => Condition::Fixed { j, x: x(v) },
        })
    }
}
