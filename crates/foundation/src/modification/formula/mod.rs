//! A modification given as a formula in the coordinates of the field: read once, then computed with exact first and
//! second derivatives. Knows no job and no other modification.

mod calculus;
mod function;
mod knowledge;
mod text;

use calculus::{View, chain, mean, power, quotient};
use function::Function;
use knowledge::Known;
use text::{Operator, TextError, Token, tokens};

use super::field::EvaluationField;
use super::limits;
use super::smoothness::Smoothness;
use crate::numerics::{Jet2, Polynomial2};

/// Names of coordinates and of constants of the field.
const NAMES: [&str; 9] = ["w", "z", "u", "v", "w_f", "w_a", "z_I", "z_II", "pi"];

/// The functions of two arguments or more, and the one with a kink.
const KINKED: [&str; 3] = ["abs", "min", "max"];

/// A formula that cannot be used: what was found and what is allowed.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FormulaError {
    pub found: String,
    pub allowed: String,
}

/// One step of the computation on a stack.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Step {
    Constant(f64),
    /// (w - middle) factor.
    Roll {
        middle: f64,
        factor: f64,
    },
    /// (z - middle) factor.
    Face {
        middle: f64,
        factor: f64,
    },
    Operator(Operator),
    Function(Function),
    Absolute,
    /// Of so many arguments.
    Minimum(usize),
    /// Of so many arguments.
    Maximum(usize),
}

/// A formula over one field, in um.
#[derive(Clone, Debug)]
pub(super) struct Formula {
    steps: Vec<Step>,
    smoothness: Smoothness,
    polynomial: Option<Polynomial2>,
}

impl Formula {
    /// Reads a formula for a field; it is not yet known whether it has a value everywhere.
    pub(super) fn new(text: &str, field: &EvaluationField) -> Result<Self, FormulaError> {
        let tokens = tokens(text).map_err(|error| unreadable(&error))?;
        let steps = tokens.into_iter().map(|token| step(token, field)).collect::<Result<Vec<_>, _>>()?;
        let known = known(&steps, field);
        Ok(Self { steps, smoothness: known.smoothness, polynomial: known.polynomial })
    }

    /// The first place of a net over the field where the formula has no finite value, slope or curvature.
    pub(super) fn undefined_at(&self, field: &EvaluationField) -> Option<(f64, f64)> {
        net(field).find(|&(w, z)| !self.jet(w, z).is_finite())
    }

    /// The largest value on a net over the field, um.
    pub(super) fn largest(&self, field: &EvaluationField) -> f64 {
        net(field).map(|(w, z)| self.value(w, z).abs()).fold(0.0, f64::max)
    }

    /// Value in um; not finite where the formula has none.
    pub(super) fn value(&self, w: f64, z: f64) -> f64 {
        self.seen(w, z, &mut View { direction: None, kink: false }).f
    }

    /// Value and derivatives in um and mm; at kinks the mean of the one-sided ones.
    pub(super) fn jet(&self, w: f64, z: f64) -> Jet2 {
        let mut view = View { direction: None, kink: false };
        let jet = self.seen(w, z, &mut view);
        if !view.kink {
            return jet;
        }
        // Four sides of a kink along w, along z or along both; the slope lies along no line that anybody draws.
        const SLOPE: f64 = 0.618_033_988_749_894_9;
        mean(
            [[1.0, SLOPE], [-1.0, -SLOPE], [1.0, -SLOPE], [-1.0, SLOPE]]
                .map(|direction| self.seen(w, z, &mut View { direction: Some(direction), kink: false })),
        )
    }

    pub(super) fn smoothness(&self) -> Smoothness {
        self.smoothness
    }

    /// In (w - w_m, z - z_m), um, if the formula is a polynomial of moderate degree.
    pub(super) fn polynomial(&self) -> Option<&Polynomial2> {
        self.polynomial.as_ref()
    }

    pub(super) fn depends_on_profile_only(&self) -> bool {
        !self.steps.iter().any(|step| matches!(step, Step::Face { .. }))
    }

    fn seen(&self, w: f64, z: f64, view: &mut View) -> Jet2 {
        let mut stack: Vec<Jet2> = Vec::with_capacity(8);
        for step in &self.steps {
            let next = match *step {
                Step::Constant(c) => Jet2::constant(c),
                Step::Roll { middle, factor } => Jet2 { fu: factor, ..Jet2::constant((w - middle) * factor) },
                Step::Face { middle, factor } => Jet2 { fv: factor, ..Jet2::constant((z - middle) * factor) },
                Step::Operator(Operator::Negate) => -taken(&mut stack),
                Step::Operator(operator) => {
                    let (b, a) = (taken(&mut stack), taken(&mut stack));
                    match operator {
                        Operator::Add => a + b,
                        Operator::Subtract => a + -b,
                        Operator::Multiply => a * b,
                        Operator::Divide => quotient(a, b),
                        Operator::Power => power(a, b),
                        Operator::Negate => -b,
                    }
                }
                Step::Function(function) => {
                    let x = taken(&mut stack);
                    chain(x, function.derivatives(x.f))
                }
                Step::Absolute => {
                    let x = taken(&mut stack);
                    view.absolute(x)
                }
                Step::Minimum(count) => {
                    let first = taken(&mut stack);
                    (1..count).fold(first, |least, _| view.minimum(least, taken(&mut stack)))
                }
                Step::Maximum(count) => {
                    let first = taken(&mut stack);
                    (1..count).fold(first, |most, _| view.maximum(most, taken(&mut stack)))
                }
            };
            stack.push(next);
        }
        taken(&mut stack)
    }
}

/// The operand on top; the grammar puts one there before each step that takes it.
fn taken(stack: &mut Vec<Jet2>) -> Jet2 {
    stack.pop().unwrap_or(Jet2::constant(f64::NAN))
}

/// Places at which a formula is tried: 65 x 65 with the borders.
fn net(field: &EvaluationField) -> impl Iterator<Item = (f64, f64)> {
    const LAST: u32 = 64;
    let ([w_f, w_a], [z_1, z_2]) = (field.roll(), field.face());
    let at = |from: f64, to: f64, i: u32| {
        let share = f64::from(i) / f64::from(LAST);
        from * (1.0 - share) + to * share
    };
    (0..=LAST).flat_map(move |i| (0..=LAST).map(move |j| (at(w_f, w_a, i), at(z_1, z_2, j))))
}

fn step(token: Token<'_>, field: &EvaluationField) -> Result<Step, FormulaError> {
    let ([w_f, w_a], [z_1, z_2]) = (field.roll(), field.face());
    Ok(match token {
        Token::Number(x) if x.is_finite() => Step::Constant(x),
        Token::Number(_) => {
            return Err(refused("a number that is too large".into(), "numbers up to 1e308".into()));
        }
        Token::Operator(operator) => Step::Operator(operator),
        Token::Name(name) => match name {
            "w" => Step::Roll { middle: 0.0, factor: 1.0 },
            "z" => Step::Face { middle: 0.0, factor: 1.0 },
            "u" => Step::Roll { middle: field.roll_middle(), factor: 2.0 / field.roll_length() },
            "v" => Step::Face { middle: field.face_middle(), factor: 2.0 / field.face_length() },
            "w_f" => Step::Constant(w_f),
            "w_a" => Step::Constant(w_a),
            "z_I" => Step::Constant(z_1),
            "z_II" => Step::Constant(z_2),
            "pi" => Step::Constant(std::f64::consts::PI),
            _ => return Err(unknown_name(name)),
        },
        Token::Call(name, count) => {
            let function = Function::ALL.iter().find(|(known, _)| *known == name);
            match (name, count, function) {
                ("min", 2.., _) => Step::Minimum(count),
                ("max", 2.., _) => Step::Maximum(count),
                ("abs", 1, _) => Step::Absolute,
                (_, 1, Some((_, function))) => Step::Function(*function),
                ("min" | "max", ..) => return Err(arguments(name, count, "2 or more")),
                ("abs", ..) | (_, _, Some(_)) => return Err(arguments(name, count, "1")),
                _ => return Err(unknown_name(name)),
            }
        }
    })
}

fn known(steps: &[Step], field: &EvaluationField) -> Known {
    let mut stack: Vec<Known> = Vec::new();
    // The grammar leaves no step without operands; what is not known stands for nothing.
    let take = |stack: &mut Vec<Known>| stack.pop().unwrap_or(Known::constant(f64::NAN));
    let coordinate = |[low, high]: [f64; 2], middle: f64, factor: f64, along_roll: bool| {
        let offset = factor * (0.5 * (low + high) - middle);
        let polynomial = if along_roll {
            Polynomial2::linear(factor, 0.0, offset)
        } else {
            Polynomial2::linear(0.0, factor, offset)
        };
        Known::smooth([(low - middle) * factor, (high - middle) * factor], Some(polynomial))
    };
    for step in steps {
        let next = match *step {
            Step::Constant(c) => Known::constant(c),
            Step::Roll { middle, factor } => coordinate(field.roll(), middle, factor, true),
            Step::Face { middle, factor } => coordinate(field.face(), middle, factor, false),
            Step::Operator(Operator::Negate) => take(&mut stack).negated(),
            Step::Operator(operator) => {
                let (b, a) = (take(&mut stack), take(&mut stack));
                match operator {
                    Operator::Add => a.plus(b),
                    Operator::Subtract => a.plus(b.negated()),
                    Operator::Multiply => a.times(b),
                    Operator::Divide => a.over(b),
                    Operator::Power => a.raised(b),
                    Operator::Negate => b.negated(),
                }
            }
            Step::Function(function) => take(&mut stack).applied(function),
            Step::Absolute => take(&mut stack).absolute(),
            Step::Minimum(count) => {
                let first = take(&mut stack);
                (1..count).fold(first, |least, _| least.minimum(take(&mut stack)))
            }
            Step::Maximum(count) => {
                let first = take(&mut stack);
                (1..count).fold(first, |most, _| most.maximum(take(&mut stack)))
            }
        };
        stack.push(next);
    }
    take(&mut stack)
}

fn refused(found: String, allowed: String) -> FormulaError {
    FormulaError { found, allowed }
}

fn unreadable(error: &TextError) -> FormulaError {
    match error {
        TextError::TooLong(length) => refused(
            format!("a text of {length} characters"),
            format!("up to {} characters", limits::FORMULA_LENGTH),
        ),
        TextError::TooDeep => refused(
            "nested too deeply".into(),
            format!("{} levels of parentheses and powers of powers", limits::NESTING),
        ),
        TextError::Unreadable { at, rest } => {
            let rest = if rest.trim().is_empty() { "its end".into() } else { format!("{rest:?}") };
            refused(
                format!("not understood near character {at}, at {rest}"),
                "numbers, names, + - * / ^, parentheses and functions, every * written".into(),
            )
        }
    }
}

fn unknown_name(name: &str) -> FormulaError {
    let name: String = name.chars().take(40).collect();
    let functions = Function::ALL.iter().map(|(name, _)| *name).chain(KINKED);
    refused(
        format!("using the unknown name {name:?}"),
        format!(
            "the names {} and the functions {}",
            NAMES.join(", "),
            functions.collect::<Vec<_>>().join(", ")
        ),
    )
}

fn arguments(name: &str, count: usize, allowed: &str) -> FormulaError {
    refused(format!("calling {name} with {count} arguments"), format!("{name} with {allowed}"))
}
