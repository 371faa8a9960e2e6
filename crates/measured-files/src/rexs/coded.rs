//! Lists of numbers as Base64 of their bytes, little endian: float64, float32, int32.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// The numbers of a coded list; `None` if the code is unknown, the text no Base64, the length no multiple, or a number not finite.
pub(super) fn decode(code: &str, text: &str) -> Option<Vec<f64>> {
    let packed: String = text.split_whitespace().collect();
    let bytes = STANDARD.decode(packed).ok()?;
    let list: Vec<f64> = match code {
        "float64" => pieces(&bytes)?.map(f64::from_le_bytes).collect(),
        "float32" => pieces(&bytes)?.map(|b| f64::from(f32::from_le_bytes(b))).collect(),
        "int32" => pieces(&bytes)?.map(|b| f64::from(i32::from_le_bytes(b))).collect(),
        _ => return None,
    };
    list.iter().all(|v| v.is_finite()).then_some(list)
}

fn pieces<const N: usize>(bytes: &[u8]) -> Option<impl Iterator<Item = [u8; N]>> {
    let (pieces, rest) = bytes.as_chunks::<N>();
    rest.is_empty().then(|| pieces.iter().copied())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_codes_are_read() {
        let of = |bytes: &[u8]| STANDARD.encode(bytes);
        let doubles: Vec<u8> = [1.5f64, -0.25].iter().flat_map(|v| v.to_le_bytes()).collect();
        let floats: Vec<u8> = [0.1f32].iter().flat_map(|v| v.to_le_bytes()).collect();
        let whole: Vec<u8> = [7i32, -8].iter().flat_map(|v| v.to_le_bytes()).collect();
        assert_eq!(decode("float64", &of(&doubles)), Some(vec![1.5, -0.25]));
        assert_eq!(decode("float32", &of(&floats)), Some(vec![f64::from(0.1f32)]));
        assert_eq!(decode("int32", &format!(" {}\n", of(&whole))), Some(vec![7.0, -8.0]));
        assert_eq!(decode("float64", ""), Some(vec![]));
        assert_eq!(decode("float64", &of(&doubles[..15])), None);
        assert_eq!(decode("float16", &of(&doubles)), None);
        assert_eq!(decode("float64", "###"), None);
        assert_eq!(decode("float64", &of(&f64::NAN.to_le_bytes())), None);
    }
}
