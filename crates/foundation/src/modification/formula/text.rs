//! The grammar of formulas: from a text to its tokens in the order in which they are computed. Knows no name and no
//! function; `^` binds tighter than a sign, so that -u^2 is -(u^2), and goes from right to left.

use winnow::ascii::{digit0, digit1, multispace0};
use winnow::combinator::{Infix, Prefix, alt, delimited, expression, opt, preceded, repeat, separated};
use winnow::prelude::*;
use winnow::token::{any, one_of, take_while};

use crate::modification::limits;

/// One step of a computation on a stack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Token<'s> {
    /// Puts a number.
    Number(f64),
    /// Puts the value of a name.
    Name(&'s str),
    /// Takes so many arguments, puts the function's value.
    Call(&'s str, usize),
    /// Takes one or two operands, puts the result.
    Operator(Operator),
}

/// What stands between or before operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operator {
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

/// Why a text is no formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum TextError {
    /// More characters than allowed.
    TooLong(usize),
    /// Parentheses and powers of powers deeper than allowed.
    TooDeep,
    /// Not understood from this character (counted from 1) on.
    Unreadable { at: usize, rest: String },
}

/// The tokens of a formula, operands before their operator.
pub(super) fn tokens(text: &str) -> Result<Vec<Token<'_>>, TextError> {
    let length = text.chars().count();
    if length > limits::FORMULA_LENGTH {
        return Err(TextError::TooLong(length));
    }
    if nesting(text) > limits::NESTING {
        return Err(TextError::TooDeep);
    }
    sum.parse(text).map_err(|error| {
        let offset = error.offset().min(text.len());
        let (before, rest) = text.split_at_checked(offset).unwrap_or((text, ""));
        TextError::Unreadable { at: before.chars().count() + 1, rest: rest.chars().take(20).collect() }
    })
}

/// How deep the reader's calls will nest at most: each open parenthesis and each power within a chain of powers is
/// one level. Counted before reading, because a call stack that overflows cannot be caught.
fn nesting(text: &str) -> usize {
    let (mut chains, mut deepest, mut previous) = (vec![0usize], 0, ' ');
    for c in text.chars().filter(|c| !c.is_whitespace()) {
        match c {
            '(' => chains.push(0),
            ')' if chains.len() > 1 => {
                chains.pop();
            }
            '^' => {
                if let Some(chain) = chains.last_mut() {
                    *chain += 1;
                }
            }
            // A sign behind a power belongs to the exponent and does not end the chain.
            '+' | '-' if previous == '^' || previous == '+' || previous == '-' => continue,
            '+' | '-' | '*' | '/' | ',' => {
                if let Some(chain) = chains.last_mut() {
                    *chain = 0;
                }
            }
            _ => {}
        }
        previous = c;
        deepest = deepest.max(chains.len() - 1 + chains.iter().sum::<usize>());
    }
    deepest
}

type Tokens<'s> = Vec<Token<'s>>;

fn sum<'s>(input: &mut &'s str) -> winnow::Result<Tokens<'s>> {
    use Operator::{Add, Divide, Multiply, Negate, Power, Subtract};
    let signs = repeat(1.., preceded(multispace0, one_of(['+', '-'])))
        .fold(|| false, |negative, sign: char| negative != (sign == '-'));
    let sign = signs.map(|negative| {
        Prefix(20, if negative { |_: &mut _, a| Ok(followed(a, Negate)) } else { |_: &mut _, a| Ok(a) })
    });
    let infix = preceded(multispace0, any).verify_map(|c: char| {
        Some(match c {
            '+' => Infix::Left(10, |_: &mut _, a, b| Ok(joined(a, b, Add))),
            '-' => Infix::Left(10, |_: &mut _, a, b| Ok(joined(a, b, Subtract))),
            '*' => Infix::Left(15, |_: &mut _, a, b| Ok(joined(a, b, Multiply))),
            '/' => Infix::Left(15, |_: &mut _, a, b| Ok(joined(a, b, Divide))),
            '^' => Infix::Right(25, |_: &mut _, a, b| Ok(joined(a, b, Power))),
            _ => return None,
        })
    });
    expression(operand).prefix(sign).infix(infix).parse_next(input)
}

fn operand<'s>(input: &mut &'s str) -> winnow::Result<Tokens<'s>> {
    let number = number.map(|x| vec![Token::Number(x)]);
    let enclosed = delimited('(', sum, ')');
    delimited(multispace0, alt((number, named, enclosed)), multispace0).parse_next(input)
}

/// Digits with at most one point, and an exponent; no sign, no words such as `inf`.
fn number(input: &mut &str) -> winnow::Result<f64> {
    let mantissa = alt(((digit1, opt(('.', digit0))).void(), ('.', digit1).void()));
    let exponent = opt((one_of(['e', 'E']), opt(one_of(['+', '-'])), digit1));
    (mantissa, exponent).take().parse_to().parse_next(input)
}

/// A name, or a function with its arguments.
fn named<'s>(input: &mut &'s str) -> winnow::Result<Tokens<'s>> {
    let word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let name = (one_of(|c: char| c.is_ascii_alphabetic()), take_while(0.., word)).take();
    let arguments = delimited('(', separated(1.., sum, ','), ')');
    let (name, arguments): (&'s str, Option<Vec<Tokens<'s>>>) =
        (name, opt(preceded(multispace0, arguments))).parse_next(input)?;
    Ok(match arguments {
        None => vec![Token::Name(name)],
        Some(arguments) => {
            let call = Token::Call(name, arguments.len());
            arguments.into_iter().flatten().chain([call]).collect()
        }
    })
}

fn followed(mut a: Tokens<'_>, operator: Operator) -> Tokens<'_> {
    a.push(Token::Operator(operator));
    a
}

fn joined<'s>(mut a: Tokens<'s>, b: Tokens<'s>, operator: Operator) -> Tokens<'s> {
    a.extend(b);
    followed(a, operator)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The formula with every operation in parentheses.
    fn shown(text: &str) -> String {
        let mut stack: Vec<String> = Vec::new();
        for token in tokens(text).unwrap_or_else(|e| panic!("{text}: {e:?}")) {
            let mut pop = || stack.pop().unwrap();
            let next = match token {
                Token::Number(x) => x.to_string(),
                Token::Name(name) => name.to_string(),
                Token::Call(name, count) => {
                    let mut arguments: Vec<String> = (0..count).map(|_| pop()).collect();
                    arguments.reverse();
                    format!("{name}({})", arguments.join(","))
                }
                Token::Operator(Operator::Negate) => format!("(-{})", pop()),
                Token::Operator(operator) => {
                    let (b, a) = (pop(), pop());
                    let sign = match operator {
                        Operator::Add => '+',
                        Operator::Subtract => '-',
                        Operator::Multiply => '*',
                        Operator::Divide => '/',
                        _ => '^',
                    };
                    format!("({a}{sign}{b})")
                }
            };
            stack.push(next);
        }
        assert_eq!(stack.len(), 1, "{text}");
        stack.pop().unwrap()
    }

    #[test]
    fn operators_bind_as_on_paper() {
        for (text, expected) in [
            ("-u^2", "(-(u^2))"),
            ("2^3^2", "(2^(3^2))"),
            ("2^-u*3", "((2^(-u))*3)"),
            ("1 - 2 - 3", "((1-2)-3)"),
            ("8/4/2*3", "(((8/4)/2)*3)"),
            ("1+2*3^2", "(1+(2*(3^2)))"),
            ("--u - -v", "(u-(-v))"),
            ("1.5e-3*w_f", "(0.0015*w_f)"),
            (".5 + 2. + 1E2", "((0.5+2)+100)"),
            (" max ( u , max(v,\n0) ) ^ 2", "(max(u,max(v,0))^2)"),
            ("-(u+v)*2", "((-(u+v))*2)"),
        ] {
            assert_eq!(shown(text), expected, "{text}");
        }
    }

    #[test]
    fn other_texts_are_refused_with_their_place() {
        for (text, place) in [
            ("2u", 2),
            ("u v", 3),
            ("u*", 3),
            ("(u", 1),
            ("u)", 2),
            ("1e", 2),
            ("", 1),
            ("u²", 2),
            ("\u{e9}+u", 1),
        ] {
            match tokens(text) {
                Err(TextError::Unreadable { at, .. }) => assert!(at.abs_diff(place) <= 2, "{text}: {at}"),
                other => panic!("{text}: {other:?}"),
            }
        }
        for text in ["inf", "nan"] {
            assert_eq!(tokens(text), Ok(vec![Token::Name(text)]));
        }
    }

    #[test]
    fn no_text_exhausts_the_stack() {
        let long = |part: &str| part.repeat(limits::FORMULA_LENGTH / part.len());
        for part in ["(", "sin(", "2^", "2^-", "(2^", "-(", "2^-2*2^(", ")", "max(u,", "^", ","] {
            assert!(tokens(&long(part)).is_err(), "{part}");
            assert!(matches!(tokens(&(long(part) + &long(part) + "1")), Err(TextError::TooLong(_))));
        }
        assert_eq!(tokens(&format!("{}u", long("-")[1..].to_owned())).map(|t| t.len()), Ok(2));
        let sum = long("+u");
        assert_eq!(tokens(&sum).map(|t| t.len()), Ok(limits::FORMULA_LENGTH - 1));
        let deepest = format!("{}u{}", "(".repeat(limits::NESTING), ")".repeat(limits::NESTING));
        assert!(tokens(&deepest).is_ok());
        assert_eq!(tokens(&format!("({deepest})")), Err(TextError::TooDeep));
    }
}
