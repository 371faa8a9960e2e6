//! One line of text as bytes: places, numbers as exact decimals. Knows no dialect. The writers have nothing of this.

use super::error::{ReadError, ReadProblem};

/// Digits of one number after leading zeros: what an i64 holds.
const DIGITS: u8 = 18;
/// Characters of one number, leading zeros included.
const CHARACTERS: usize = 64;

/// A decimal number as it stands in the text: mantissa / 10^decimals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Decimal {
    pub mantissa: i64,
    pub decimals: u8,
    /// Whether a point stands in it.
    pub pointed: bool,
}

/// Powers of ten that an f64 holds exactly.
const EXACT: [f64; 19] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18];

impl Decimal {
    /// The nearest f64.
    pub fn value(self) -> f64 {
        let power = EXACT[usize::from(self.decimals.min(DIGITS))];
        if self.mantissa.unsigned_abs() <= 1 << 53 {
            // Both are exact, so that the quotient is rounded once.
            return self.mantissa as f64 / power;
        }
        // The standard library rounds the digits correctly.
        format!("{}e-{}", self.mantissa, self.decimals).parse().unwrap_or(self.mantissa as f64 / power)
    }

    /// The exact sum; none beyond an i64.
    pub fn plus(self, other: Self) -> Option<Self> {
        let decimals = self.decimals.max(other.decimals);
        let aligned = |number: Self| {
            number.mantissa.checked_mul(10i64.checked_pow(u32::from(decimals - number.decimals))?)
        };
        Some(Self { mantissa: aligned(self)?.checked_add(aligned(other)?)?, decimals, pointed: true })
    }

    /// Inches as millimetres, exactly; none beyond an i64.
    pub fn inches(self) -> Option<Self> {
        Some(Self {
            mantissa: self.mantissa.checked_mul(254)?,
            decimals: self.decimals + 1,
            pointed: self.pointed,
        })
    }

    /// The integer, if it is one below 10^9 and not negative.
    pub fn count(self) -> Option<u32> {
        let value = self.value();
        (value.fract() == 0.0 && (0.0..1e9).contains(&value)).then_some(value as u32)
    }
}

/// A line and a place in it.
pub(super) struct Scan<'a> {
    pub bytes: &'a [u8],
    pub at: usize,
    pub line: usize,
}

impl<'a> Scan<'a> {
    pub fn new(bytes: &'a [u8], line: usize) -> Self {
        Self { bytes, at: 0, line }
    }

    pub fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    pub fn skip_blanks(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t')) {
            self.at += 1;
        }
    }

    /// Takes a byte if it comes next, after blanks.
    pub fn take(&mut self, byte: u8) -> bool {
        self.skip_blanks();
        let there = self.peek() == Some(byte);
        self.at += usize::from(there);
        there
    }

    /// A fault of the word from `start` up to here.
    pub fn fault(&self, problem: ReadProblem, start: usize, allowed: &'static str) -> ReadError {
        let end = self.at.max(start + 1).min(self.bytes.len()).min(start + 40);
        let word = self.bytes.get(start.min(end)..end).unwrap_or_default();
        ReadError { line: self.line, column: start + 1, problem, word: shown(word), allowed }
    }

    /// A number: sign, digits, point, digits; no exponent.
    pub fn number(&mut self) -> Result<Decimal, ReadError> {
        self.skip_blanks();
        let start = self.at;
        let sign = self.peek();
        let negative = sign == Some(b'-');
        let mut at = start + usize::from(matches!(sign, Some(b'-' | b'+')));
        let (mut mantissa, mut digits, mut decimals, mut pointed, mut any) = (0i64, 0u8, 0u8, false, false);
        while let Some(&byte) = self.bytes.get(at) {
            match byte {
                b'0'..=b'9' => {
                    any = true;
                    if digits > 0 || byte != b'0' {
                        digits += 1;
                    }
                    decimals += u8::from(pointed);
                    if digits > DIGITS || decimals > DIGITS || at - start > CHARACTERS {
                        self.at = at;
                        return Err(self.fault(ReadProblem::NumberTooLong, start, "18 digits"));
                    }
                    mantissa = mantissa * 10 + i64::from(byte - b'0');
                }
                b'.' if !pointed => pointed = true,
                _ => break,
            }
            at += 1;
        }
        self.at = at;
        if !any {
            return Err(self.fault(
                ReadProblem::BadNumber,
                start,
                "a number such as -12.5, without exponent",
            ));
        }
        Ok(Decimal { mantissa: if negative { -mantissa } else { mantissa }, decimals, pointed })
    }
}

/// Bytes as a message may show them.
pub(super) fn shown(bytes: &[u8]) -> Box<str> {
    bytes.escape_ascii().to_string().into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn number(text: &str) -> Result<Decimal, ReadError> {
        Scan::new(text.as_bytes(), 1).number()
    }

    #[test]
    fn numbers_are_read_as_controls_read_them() {
        for (text, value) in
            [(".5", 0.5), ("5.", 5.0), ("+3", 3.0), ("00001.50", 1.5), ("-0.25", -0.25), ("-0", 0.0)]
        {
            assert_eq!(number(text).unwrap().value(), value, "{text}");
        }
        for text in ["", ".", "-", "+.", "X", "--1"] {
            assert_eq!(number(text).unwrap_err().problem, ReadProblem::BadNumber, "{text}");
        }
        assert_eq!(number(&"9".repeat(200)).unwrap_err().problem, ReadProblem::NumberTooLong);
        assert_eq!(
            number(&format!("0.{}", "0".repeat(200))).unwrap_err().problem,
            ReadProblem::NumberTooLong
        );
    }

    #[test]
    fn sums_are_exact() {
        let sum = number("14647.3000001").unwrap().plus(number("-0.30").unwrap()).unwrap();
        assert_eq!((sum.mantissa, sum.decimals), (146_470_000_001, 7));
        assert_eq!(number("1.5").unwrap().inches().unwrap().value(), 38.1);
        assert_eq!(number("9".repeat(18).as_str()).unwrap().plus(number("0.000000000000001").unwrap()), None);
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn a_number_is_the_nearest_one(mantissa in -999_999_999_999_999_999i64..=999_999_999_999_999_999, point in 0usize..18) {
            let digits = format!("{:018}", mantissa.abs());
            let text = format!("{}{}.{}", if mantissa < 0 { "-" } else { "" }, &digits[..point], &digits[point..]);
            prop_assert_eq!(number(&text).unwrap().value(), text.parse::<f64>().unwrap());
        }
    }
}
