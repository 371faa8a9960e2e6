//! The formulas of time that servo runs give as texts, e.g. `0.8 sin(2 pi 50 t) - 3 (t > 1 s)`: sums, products (also
//! without a sign between the factors), quotients, whole powers, sine, cosine, and comparisons, which are 1 or 0. Names
//! are `t`, `pi`, the parameters of the run, and the units s, rad, Hz and Nm, which are 1.

use foundation::numerics::Scalar;
use std::collections::BTreeMap;

/// A formula of the time t.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Formula {
    Number(f64),
    Time,
    Negative(Box<Formula>),
    Sum(Box<Formula>, Box<Formula>),
    Difference(Box<Formula>, Box<Formula>),
    Product(Box<Formula>, Box<Formula>),
    Quotient(Box<Formula>, Box<Formula>),
    Power(Box<Formula>, i32),
    Sine(Box<Formula>),
    Cosine(Box<Formula>),
    /// 1 where the first exceeds the second, or (with `true`) equals it.
    Exceeds(Box<Formula>, Box<Formula>, bool),
}

impl Formula {
    /// Reads a text; `parameters` are the names that stand for numbers.
    pub fn parse(text: &str, parameters: &BTreeMap<&str, f64>) -> Result<Self, String> {
        if text.len() > LONGEST {
            return Err(format!("a formula of {} characters; allowed: up to {LONGEST}", text.len()));
        }
        let tokens = tokens(text)?;
        let mut reader = Reader { text, tokens, at: 0, depth: 0, parameters };
        let formula = reader.sum()?;
        match reader.peek() {
            None => Ok(formula),
            Some(token) => Err(reader.unexpected(&format!("{token:?}"))),
        }
    }

    /// Value at a time; with a dual number the derivatives by it.
    pub fn value<T: Scalar>(&self, t: T) -> T {
        match self {
            Self::Number(x) => T::from(*x),
            Self::Time => t,
            Self::Negative(a) => -a.value(t),
            Self::Sum(a, b) => a.value(t) + b.value(t),
            Self::Difference(a, b) => a.value(t) - b.value(t),
            Self::Product(a, b) => a.value(t) * b.value(t),
            Self::Quotient(a, b) => a.value(t) / b.value(t),
            Self::Power(a, n) => a.value(t).powi(*n),
            Self::Sine(a) => a.value(t).sin(),
            Self::Cosine(a) => a.value(t).cos(),
            Self::Exceeds(a, b, or_equal) => {
                let (a, b) = (a.value(t).re(), b.value(t).re());
                T::from(f64::from(a > b || (*or_equal && a == b)))
            }
        }
    }

    /// Times of the steps, where t is compared with a number.
    pub fn steps(&self) -> Vec<f64> {
        match self {
            Self::Number(_) | Self::Time => Vec::new(),
            Self::Negative(a) | Self::Power(a, _) | Self::Sine(a) | Self::Cosine(a) => a.steps(),
            Self::Exceeds(a, b, _) if **a == Self::Time => vec![b.value(0.0)],
            Self::Exceeds(a, b, _) if **b == Self::Time => vec![a.value(0.0)],
            Self::Sum(a, b)
            | Self::Difference(a, b)
            | Self::Product(a, b)
            | Self::Quotient(a, b)
            | Self::Exceeds(a, b, _) => [a.steps(), b.steps()].concat(),
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(f64),
    Name(String),
    Sign(char),
    /// `>=` or `<=`, by its first character.
    OrEqual(char),
}

fn tokens(text: &str) -> Result<Vec<Token>, String> {
    let characters: Vec<char> = text.chars().collect();
    let mut found = Vec::new();
    let mut at = 0;
    let run = |from: usize, good: &dyn Fn(char) -> bool| {
        from + characters[from..].iter().take_while(|c| good(**c)).count()
    };
    while let Some(&c) = characters.get(at) {
        let end = if c.is_whitespace() {
            at + 1
        } else if c.is_ascii_digit() || c == '.' {
            let digits = |from| run(from, &|c| c.is_ascii_digit() || c == '.');
            let mut end = digits(at);
            // An exponent only where digits follow: `3 exp` is no number.
            if matches!(characters.get(end), Some('e' | 'E')) {
                let sign = usize::from(matches!(characters.get(end + 1), Some('+' | '-')));
                let power = digits(end + 1 + sign);
                if power > end + 1 + sign {
                    end = power;
                }
            }
            let word: String = characters[at..end].iter().collect();
            let number = word.parse().map_err(|_| format!("`{word}` in `{text}` is no number"))?;
            found.push(Token::Number(number));
            end
        } else if c.is_alphabetic() || c == '_' {
            let end = run(at, &|c| c.is_alphanumeric() || c == '_');
            found.push(Token::Name(characters[at..end].iter().collect()));
            end
        } else if matches!(c, '<' | '>') && characters.get(at + 1) == Some(&'=') {
            found.push(Token::OrEqual(c));
            at + 2
        } else if "+-*/^()<>".contains(c) {
            found.push(Token::Sign(c));
            at + 1
        } else {
            return Err(format!("the character `{c}` in `{text}` is not known"));
        };
        at = end;
    }
    Ok(found)
}

/// Longer or deeper texts are refused before the stack ends.
const LONGEST: usize = 1000;
const DEEPEST: usize = 64;

struct Reader<'a> {
    text: &'a str,
    tokens: Vec<Token>,
    at: usize,
    depth: usize,
    parameters: &'a BTreeMap<&'a str, f64>,
}

impl Reader<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    /// Takes the next token if it is this sign.
    fn sign(&mut self, sign: char) -> bool {
        let found = self.peek() == Some(&Token::Sign(sign));
        self.at += usize::from(found);
        found
    }

    fn unexpected(&self, what: &str) -> String {
        format!("the formula `{}` is not understood at its part {} ({what})", self.text, self.at + 1)
    }

    fn sum(&mut self) -> Result<Formula, String> {
        let mut left = self.product()?;
        loop {
            if self.sign('+') {
                left = Formula::Sum(left.into(), self.product()?.into());
            } else if self.sign('-') {
                left = Formula::Difference(left.into(), self.product()?.into());
            } else {
                return Ok(left);
            }
        }
    }

    fn product(&mut self) -> Result<Formula, String> {
        let mut left = self.factor()?;
        loop {
            if self.sign('*') {
                left = Formula::Product(left.into(), self.factor()?.into());
            } else if self.sign('/') {
                left = Formula::Quotient(left.into(), self.factor()?.into());
            } else if matches!(self.peek(), Some(Token::Number(_) | Token::Name(_) | Token::Sign('('))) {
                left = Formula::Product(left.into(), self.factor()?.into());
            } else {
                return Ok(left);
            }
        }
    }

    fn factor(&mut self) -> Result<Formula, String> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(format!("the formula `{}` is nested more than {DEEPEST} deep", self.text));
        }
        let factor = if self.sign('-') {
            Formula::Negative(self.factor()?.into())
        } else {
            let base = self.atom()?;
            if self.sign('^') { Formula::Power(base.into(), self.exponent()?) } else { base }
        };
        self.depth -= 1;
        Ok(factor)
    }

    fn exponent(&mut self) -> Result<i32, String> {
        match self.peek() {
            Some(&Token::Number(n)) if n.fract() == 0.0 && n <= 16.0 => {
                self.at += 1;
                Ok(n as i32)
            }
            _ => Err(self.unexpected("a whole exponent up to 16 is needed")),
        }
    }

    fn atom(&mut self) -> Result<Formula, String> {
        let Some(token) = self.peek().cloned() else { return Err(self.unexpected("it ends too early")) };
        match token {
            Token::Number(x) => {
                self.at += 1;
                Ok(Formula::Number(x))
            }
            Token::Name(name) => self.name(&name),
            Token::Sign('(') => self.parenthesis(),
            Token::Sign(c) | Token::OrEqual(c) => Err(self.unexpected(&format!("`{c}`"))),
        }
    }

    fn name(&mut self, name: &str) -> Result<Formula, String> {
        if let Some(&value) = self.parameters.get(name) {
            self.at += 1;
            return Ok(Formula::Number(value));
        }
        let known = match name {
            "t" => Formula::Time,
            "pi" => Formula::Number(std::f64::consts::PI),
            "s" | "rad" | "Hz" | "Nm" => Formula::Number(1.0),
            "sin" | "cos" => {
                self.at += 1;
                if self.peek() != Some(&Token::Sign('(')) {
                    return Err(self.unexpected("a parenthesis is needed after sin and cos"));
                }
                let argument = self.parenthesis()?.into();
                return Ok(if name == "sin" { Formula::Sine(argument) } else { Formula::Cosine(argument) });
            }
            _ => return Err(self.unexpected(&format!("the name `{name}` is not known"))),
        };
        self.at += 1;
        Ok(known)
    }

    /// A sum or a comparison of two, in parentheses.
    fn parenthesis(&mut self) -> Result<Formula, String> {
        self.at += 1;
        let left = self.sum()?;
        let comparison = match self.peek() {
            Some(&Token::Sign(c @ ('<' | '>'))) => Some((c, false)),
            Some(&Token::OrEqual(c)) => Some((c, true)),
            _ => None,
        };
        let inside = match comparison {
            Some((c, or_equal)) => {
                self.at += 1;
                let right = self.sum()?;
                let (more, less) = if c == '>' { (left, right) } else { (right, left) };
                Formula::Exceeds(more.into(), less.into(), or_equal)
            }
            None => left,
        };
        if self.sign(')') { Ok(inside) } else { Err(self.unexpected("`)` is missing")) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::Dual2_64;
    use std::f64::consts::TAU;

    fn parse(text: &str) -> Result<Formula, String> {
        Formula::parse(text, &BTreeMap::from([("w0", 23.5)]))
    }

    #[test]
    fn texts_of_runs() {
        let torque = parse("0.8 sin(2 pi 50 t) - 3 (t > 1 s)").unwrap();
        for t in [0.0, 0.123, 1.0, 1.01] {
            let direct = 0.8 * (TAU * 50.0 * t).sin() - if t > 1.0 { 3.0 } else { 0.0 };
            assert_eq!(torque.value(t), direct, "{t}");
        }
        assert_eq!(torque.steps(), [1.0]);
        assert_eq!(parse("w0*t").unwrap().value(2.0), 47.0);
        assert_eq!(parse("-t^2/2 + 1.5e-3 (0.5 s >= t) (t < 2)").unwrap().value(0.5), -0.1235);
        assert_eq!(parse("2 (t <= 0.25) + 1.5 Nm").unwrap().steps(), [0.25]);
        assert_eq!(parse("2(3)cos(0 t)").unwrap().value(7.0), 6.0);
        assert_eq!(parse("-(1 - 2) - 3").unwrap().value(0.0), -2.0);
    }

    #[test]
    fn derivatives_are_exact() {
        let formula = parse("w0 t + 0.01 cos(3 t) + t^3").unwrap();
        let at = formula.value(Dual2_64::from_re(0.4).derivative());
        assert!((at.v1 - (23.5 - 0.03 * 1.2f64.sin() + 0.48)).abs() < 1e-13);
        assert!((at.v2 - (-0.09 * 1.2f64.cos() + 2.4)).abs() < 1e-13);
    }

    #[test]
    fn what_is_not_known_is_named() {
        for (text, part) in [
            ("w1*t", "`w1`"),
            ("3 tan(t)", "`tan`"),
            ("sin t", "parenthesis"),
            ("3 (t > 1", "`)`"),
            ("3 +", "too early"),
            ("3 % t", "`%`"),
            ("t^0.5", "exponent"),
            ("1.2.3", "1.2.3"),
            ("", "too early"),
            ("t > 1", "Sign"),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.contains(part), "{text}: {error}");
        }
        for many in ["(", "-"] {
            assert!(parse(&many.repeat(1000)).unwrap_err().contains("deep"));
        }
        assert!(parse(&"+1".repeat(501)).unwrap_err().contains("characters"));
    }
}
