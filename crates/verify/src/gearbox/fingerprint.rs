//! The hash by which files give long pulse trains: FNV-1a of 64 bits (`docs/mathematics/gearbox.md#limits`).

/// Hash of what was added so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fingerprint(u64);

impl Fingerprint {
    pub const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    /// A pulse: its tick as eight bytes, least first, then its sign as one.
    pub fn add(&mut self, tick: u64, sign: i64) {
        let sign: u8 = if sign < 0 { 0xff } else { 1 };
        for byte in tick.to_le_bytes().into_iter().chain([sign]) {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }

    /// 16 hexadecimal digits.
    pub fn text(self) -> String {
        format!("{:016x}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Fingerprint;

    #[test]
    fn single_bytes_hash_as_published() {
        // FNV-1a of nine bytes, computed byte by byte from the definition: offset, then xor and multiply.
        let mut hash = Fingerprint::EMPTY;
        assert_eq!(hash.text(), "cbf29ce484222325");
        hash.add(0x0807_0605_0403_0201, -1);
        let bytes = [1u8, 2, 3, 4, 5, 6, 7, 8, 255];
        let expected = bytes
            .iter()
            .fold(0xcbf2_9ce4_8422_2325u64, |h, b| (h ^ u64::from(*b)).wrapping_mul(1_099_511_628_211));
        assert_eq!(hash.text(), format!("{expected:016x}"));
    }
}
