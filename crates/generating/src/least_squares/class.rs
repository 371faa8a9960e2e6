//! Which functions a decomposition may use, how fine their splines are and what is made small.

/// Any subset of {C, L, Q, P, K}: f_t = F_C(X) + F_L(X) u + F_Q(X) u^2 + F_P(profile) + F_K(X_K) (`docs/mathematics/modifications.md`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FunctionClass {
    /// F_C(X).
    pub constant: bool,
    /// F_L(X) u.
    pub linear: bool,
    /// F_Q(X) u^2.
    pub quadratic: bool,
    /// F_P, in the dresser.
    pub profile: bool,
    /// F_K(X_K), in the motion.
    pub kinematic: bool,
}

impl FunctionClass {
    /// {C, L, K}: an unmodified dresser.
    pub const CLK: Self =
        Self { constant: true, linear: true, quadratic: false, profile: false, kinematic: true };
    /// {C, L, P, K}: the default for worms dressed by a disc dresser.
    pub const CLPK: Self = Self { profile: true, ..Self::CLK };
    /// {C, L, Q, P, K}.
    pub const ALL: Self = Self { quadratic: true, ..Self::CLPK };
    /// {P, K}: the radial method.
    pub const RADIAL: Self = Self { constant: false, linear: false, ..Self::CLPK };

    /// From letters C, L, Q, P, K in any order; `None` for any other letter, a repeated one or none at all.
    pub fn from_letters(letters: impl IntoIterator<Item = char>) -> Option<Self> {
        let mut class =
            Self { constant: false, linear: false, quadratic: false, profile: false, kinematic: false };
        let none = class;
        for letter in letters {
            let member = match letter {
                'C' => &mut class.constant,
                'L' => &mut class.linear,
                'Q' => &mut class.quadratic,
                'P' => &mut class.profile,
                'K' => &mut class.kinematic,
                _ => return None,
            };
            if std::mem::replace(member, true) {
                return None;
            }
        }
        (class != none).then_some(class)
    }

    /// Whether a function of X is among them.
    pub fn uses_lines(self) -> bool {
        self.constant || self.linear || self.quadratic
    }

    /// Number of functions.
    pub fn functions(self) -> usize {
        [self.constant, self.linear, self.quadratic, self.profile, self.kinematic]
            .into_iter()
            .filter(|&used| used)
            .count()
    }

    /// Dimension of the functions that add up to zero: polynomials, for straight lines in general position and splines
    /// of degree k. At total degree n the class offers one term a function where its own degree allows it, and there are
    /// n + 1 monomials. For k = 3: {C,L,K} 2, {C,L,P,K} 5, {C,L,Q,P,K} 7
    /// (`docs/mathematics/generating-contact.md#decomposition-of-a-target`).
    pub fn ambiguity(self, degree: usize) -> usize {
        let shifted = [
            (self.constant, 0),
            (self.linear, 1),
            (self.quadratic, 2),
            (self.profile, 0),
            (self.kinematic, 0),
        ];
        // From total degree 4 on there are never more terms than monomials.
        (0..4)
            .map(|n| {
                let terms = shifted
                    .iter()
                    .filter(|(used, shift)| *used && n >= *shift && n - *shift <= degree)
                    .count();
                terms.saturating_sub(n + 1)
            })
            .sum()
    }
}

/// Points (w, z) [mm] through which lines of X, of the profile argument and of X_K run along which the target has a kink.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Kinks {
    /// Kinks of F_C, F_L, F_Q.
    pub lines: Vec<[f64; 2]>,
    /// Kinks of F_P.
    pub profile: Vec<[f64; 2]>,
    /// Kinks of F_K.
    pub path: Vec<[f64; 2]>,
}

/// What a fit makes small.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FitNorm {
    /// The sum of squares of (f - fit)/tolerance.
    #[default]
    LeastSquares,
    /// The largest |f - fit|/tolerance.
    Largest,
}

/// How a target is decomposed.
#[derive(Clone, Debug, PartialEq)]
pub struct FitSettings {
    /// Functions used.
    pub class: FunctionClass,
    /// Intervals of every spline.
    pub intervals: usize,
    /// Degree of every spline.
    pub degree: usize,
    /// Where the splines may have kinks.
    pub kinks: Kinks,
    /// What is made small.
    pub norm: FitNorm,
}

impl FitSettings {
    /// Cubic splines of 10 intervals without kinks, least squares.
    pub fn new(class: FunctionClass) -> Self {
        Self { class, intervals: 10, degree: 3, kinks: Kinks::default(), norm: FitNorm::LeastSquares }
    }

    /// Number of coefficients, kinks apart.
    pub(super) fn coefficients(&self) -> usize {
        self.intervals.saturating_add(self.degree).saturating_mul(self.class.functions())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ambiguities_are_those_of_the_specification() {
        let counts = [FunctionClass::CLK, FunctionClass::CLPK, FunctionClass::ALL].map(|c| c.ambiguity(3));
        assert_eq!(counts, [2, 5, 7]);
        assert_eq!(FunctionClass::RADIAL.ambiguity(3), 1);
    }

    #[test]
    fn letters_name_a_class_once() {
        assert_eq!(FunctionClass::from_letters("KLC".chars()), Some(FunctionClass::CLK));
        assert_eq!(FunctionClass::from_letters("CLQPK".chars()), Some(FunctionClass::ALL));
        for bad in ["", "CC", "CX"] {
            assert_eq!(FunctionClass::from_letters(bad.chars()), None);
        }
    }
}
