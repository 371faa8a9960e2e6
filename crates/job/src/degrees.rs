//! Angles in degrees as text, read and written so that the radians come back bit for bit. A number of degrees in double precision
//! cannot name every number of radians; a text with more digits, turned into radians with twice the precision, can.

/// Twice the precision: a number and what it lacks.
#[derive(Clone, Copy)]
struct Double(f64, f64);

const RADIANS_PER_DEGREE: Double = Double(0.017_453_292_519_943_295, 2.948_652_270_870_168_7e-19);
const DEGREES_PER_RADIAN: Double = Double(57.295_779_513_082_32, -1.987_849_567_057_628_3e-15);

/// Digits of a text that are kept: as many as 128 bits hold with room to spare.
const MOST_DIGITS: usize = 30;
/// Powers of ten beyond which a text is taken in single precision; no angle comes near.
const FARTHEST: i32 = 60;
/// The greatest power of ten that a number holds exactly.
const EXACT_POWER: i32 = 22;

impl Double {
    fn times(self, other: Self) -> Self {
        let high = self.0 * other.0;
        let low = self.0.mul_add(other.0, -high) + (self.0 * other.1 + self.1 * other.0);
        Self::sum(high, low)
    }

    fn over(self, divisor: f64) -> Self {
        let first = self.0 / divisor;
        let rest = (-first).mul_add(divisor, self.0) + self.1;
        Self::sum(first, rest / divisor)
    }

    /// Of a number and a smaller one.
    fn sum(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self(sum, low - (sum - high))
    }

    fn of_integer(value: u128) -> Self {
        let high = value as f64;
        let low = if high as u128 > value {
            -((high as u128 - value) as f64)
        } else {
            (value - high as u128) as f64
        };
        Self(high, low)
    }

    fn times_power_of_ten(mut self, mut exponent: i32) -> Self {
        while exponent != 0 {
            let step = exponent.clamp(-EXACT_POWER, EXACT_POWER);
            let power = 10f64.powi(step.abs());
            self = if step > 0 { self.times(Self(power, 0.0)) } else { self.over(power) };
            exponent -= step;
        }
        self
    }
}

/// Radians of a text in degrees; `None` if it is no finite number.
pub fn radians_of(text: &str) -> Option<f64> {
    let single = text.parse::<f64>().ok().filter(|x| x.is_finite())?;
    let Some((digits, exponent)) = decimal(text).filter(|(_, exponent)| exponent.abs() <= FARTHEST) else {
        return Some(single.to_radians());
    };
    let degrees = Double::of_integer(digits).times_power_of_ten(exponent);
    Some(degrees.times(RADIANS_PER_DEGREE).0.copysign(single))
}

/// Text in degrees from which [`radians_of`] makes the same radians; as short as it can be. Exact for angles above 1e-30.
pub fn degrees_text(radians: f64) -> String {
    let plain = radians.to_degrees().to_string();
    if radians_of(&plain) == Some(radians) {
        return plain;
    }
    let degrees = Double(radians.abs(), 0.0).times(DEGREES_PER_RADIAN);
    let places = degrees.0.log10().floor() as i32;
    let sign = if radians < 0.0 { "-" } else { "" };
    let longer = (18..=21).map(|digits| {
        let exponent = digits - 1 - places;
        let scaled = degrees.times_power_of_ten(exponent);
        let whole = (scaled.0 as i128 + scaled.1.round() as i128).to_string();
        format!("{sign}{}", with_point(&whole, exponent))
    });
    longer.into_iter().find(|text| radians_of(text) == Some(radians)).unwrap_or(plain)
}

/// Digits and power of ten of a text that is a number.
fn decimal(text: &str) -> Option<(u128, i32)> {
    let text = text.trim_start_matches(['+', '-']);
    let (mantissa, power) = match text.find(['e', 'E']) {
        Some(at) => (&text[..at], text[at + 1..].parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let (mut value, mut kept, mut exponent) =
        (0u128, 0, power.checked_sub(i32::try_from(fraction.len()).ok()?)?);
    for digit in whole.bytes().chain(fraction.bytes()) {
        if kept < MOST_DIGITS {
            value = 10 * value + u128::from(digit.checked_sub(b'0')?);
            kept += usize::from(value > 0);
        } else {
            exponent = exponent.checked_add(1)?;
        }
    }
    Some((value, exponent))
}

/// A whole number over a power of ten, as a decimal number.
fn with_point(whole: &str, exponent: i32) -> String {
    let Ok(places) = usize::try_from(exponent) else { return format!("{whole}e{}", -exponent) };
    let padded = format!("{whole:0>width$}", width = places + 1);
    let (front, back) = padded.split_at(padded.len() - places);
    if back.is_empty() { front.to_owned() } else { format!("{front}.{back}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::numerics::Noise;

    #[test]
    fn every_angle_comes_back_bit_for_bit() {
        let mut noise = Noise::new(3);
        let mut longer = 0;
        for k in 0..20_000 {
            let size = [1.0, std::f64::consts::PI, 100.0, 1e-3, 1e-12, 1e9][k % 6];
            let angle = size * (2.0 * noise.uniform() - 1.0);
            let text = degrees_text(angle);
            assert_eq!(radians_of(&text).map(f64::to_bits), Some(angle.to_bits()), "{angle:e} {text}");
            longer += usize::from(text.parse::<f64>().unwrap().to_radians() != angle);
        }
        // What this module is for.
        assert!(longer > 1000, "{longer}");
        for angle in [0.0, -0.0, 1.0, -std::f64::consts::PI, f64::EPSILON, 1e-25] {
            assert_eq!(radians_of(&degrees_text(angle)).map(f64::to_bits), Some(angle.to_bits()), "{angle}");
        }
    }

    #[test]
    fn texts_of_every_form_are_read() {
        let right = std::f64::consts::FRAC_PI_2;
        for text in [
            "90",
            "90.",
            "+90.0",
            "9e1",
            "9.0E+1",
            "0.09e3",
            "900e-1",
            "090.000000000000000000000000000000000",
        ] {
            assert_eq!(radians_of(text), Some(right), "{text}");
        }
        assert_eq!(radians_of("-90"), Some(-right));
        assert_eq!(radians_of(".5"), Some(0.5f64.to_radians()));
        assert_eq!(radians_of("1e-200"), Some(1e-200f64.to_radians()));
        for text in ["", "nan", "inf", "-inf", "1e999", "90 deg", "0x10", "1,5", "--1", "1e", "1.2.3"] {
            assert_eq!(radians_of(text), None, "{text}");
        }
    }

    #[test]
    fn short_where_short_will_do() {
        assert_eq!(degrees_text(90f64.to_radians()), "90");
        assert_eq!(degrees_text(-0.25f64.to_radians()), "-0.25");
    }
}
