//! Measured parts made for tests and benches: a spur gear with known deviations in the grammar of .mka files.

use foundation::geometry::{Flank, Sides};
use std::f64::consts::TAU;
use std::fmt::Write;

/// Samples of a trace.
pub const SAMPLES: usize = 480;
/// Normal module, face width, pressure angle of the gear.
pub const MODULE: f64 = 2.0;
pub const WIDTH: f64 = 20.0;
/// Diameters: start and end of the measurement, of the evaluation.
const DIAMETERS: [f64; 4] = [1.93, 1.95, 2.12, 2.14];
/// Evaluated part of the face.
const FACE: [f64; 2] = [1.0, 19.0];

/// What a part is made like. Deviations in um, > 0 material.
#[derive(Clone)]
pub struct MadePart {
    pub name: String,
    pub drawing: String,
    pub date: String,
    pub time: String,
    pub teeth: u32,
    /// Teeth with traces.
    pub traced: Vec<u32>,
    /// Slope of material rising to the tip, to the top, over the evaluated range.
    pub profile_slope: Sides<f64>,
    pub helix_slope: Sides<f64>,
    pub crowning: f64,
    /// Amplitude of a wave over every trace.
    pub wave: f64,
    /// Amplitude of the eccentricity in the pitches.
    pub eccentricity: f64,
    /// Samples of every trace that were not measured.
    pub undefined: std::ops::Range<usize>,
    /// Whether the positions of the probe are in the file.
    pub positions: bool,
    pub pitch: bool,
    pub seed: u64,
}

impl MadePart {
    pub fn new(name: &str, seed: u64) -> Self {
        Self {
            name: name.into(),
            drawing: "Z-17".into(),
            date: "01.02.26".into(),
            time: "08:21:31   /   08:34:28".into(),
            teeth: 23,
            traced: vec![1, 8, 16],
            profile_slope: Sides { left: 2.0, right: -1.5 },
            helix_slope: Sides { left: 3.0, right: 1.0 },
            crowning: 2.5,
            wave: 0.6,
            eccentricity: 3.0,
            undefined: 0..0,
            positions: true,
            pitch: true,
            seed,
        }
    }

    /// Reference diameter.
    fn reference(&self) -> f64 {
        MODULE * f64::from(self.teeth)
    }

    fn base(&self) -> f64 {
        0.5 * self.reference() * 20f64.to_radians().cos()
    }

    /// Start and end of the measurement, start and end of the evaluation, mm of diameter: 44.3 and 49.3 for 23 teeth.
    fn diameters(&self) -> [f64; 4] {
        let far = self.reference() - 23.0 * MODULE;
        [DIAMETERS[0], DIAMETERS[1], DIAMETERS[2], DIAMETERS[3]].map(|share| 23.0 * share + far)
    }

    /// Length of roll at a diameter.
    fn roll(&self, diameter: f64) -> f64 {
        (0.25 * diameter * diameter - self.base().powi(2)).sqrt()
    }

    pub fn text(&self) -> String {
        let mut text = self.header();
        for tooth in &self.traced {
            for flank in Flank::BOTH {
                self.helix(&mut text, *tooth, flank);
            }
        }
        for tooth in &self.traced {
            for flank in Flank::BOTH {
                self.profile(&mut text, *tooth, flank);
            }
        }
        if self.pitch {
            self.pitches(&mut text);
        }
        if self.positions {
            self.probe(&mut text);
        }
        text
    }

    fn header(&self) -> String {
        let [start, from, to, end] = self.diameters();
        let two = |value: f64| format!("{value:.3}      {value:.3}");
        let lines = [
            (1, "Protokolldaten für Zahnrad (STI 5.0.0)".to_owned()),
            (2, format!("Datum.............: {}", self.date)),
            (3, format!("Zeit..............: {}", self.time)),
            (6, format!("Zeichnungsnr......: {}", self.drawing)),
            (7, format!("ME/Seite/KS/LZ....: {}", self.name)),
            (8, "Benennung.........: Prüfrad".into()),
            (21, format!("Normalmodul mn................  [mm]....:  {MODULE}::L- :R-")),
            (22, format!("Zähnezahl z.............................: {}     Außenverzahnung", self.teeth)),
            (23, "Schrägungswinkel ß  ..........  [Grad]..:  0".into()),
            (24, "Eingriffswinkel alpha ........  [Grad]..: 20".into()),
            (25, "Profilverschiebungsfaktor x ............:   .1".into()),
            (26, format!("Zahnbreite ...................  [mm]....: {WIDTH}")),
            (41, format!("Start Messbereich...............da  [mm]..:  {}", two(start))),
            (42, format!("Start der Auswertestrecke.......d1  [mm]..:  {}", two(from))),
            (43, format!("Ende der Auswertestrecke........d2  [mm]..:  {}", two(to))),
            (44, format!("Ende der Messstrecke............de  [mm]..:  {}", two(end))),
            (46, format!("Flankenlinienmesskreis  [mm]..:  {}", two(self.reference()))),
            (47, format!("Teilungsmesskreis =46 (Kugel-Ø =3.5) [mm]..:  {:.3}", self.reference())),
            (61, format!("Messanfang (unten)..............ba  [mm]..:  {}", two(0.0))),
            (62, format!("Auswerteanfang..................b1  [mm]..:  {}", two(FACE[0]))),
            (63, format!("Auswerteende....................b2  [mm]..:  {}", two(FACE[1]))),
            (64, format!("Messende (oben).................be  [mm]..:  {}", two(WIDTH))),
            (65, "Lage des Profils auf der Zahnbreite.. [mm]..:   10".into()),
            (161, "Zaehlrichtung 0-im Uhrzeigersinn     :ZRICH: 1".into()),
            (164, "Seitendefinition: 0-VDI/DIN / 1-USA  :ZSDEF: 0".into()),
            (165, "Reference fHb: 0-VDI / 1-DIN / 2- +-+ :R_FHB: 1 : L: + : R: -".into()),
            (178, "Vorzeichen Flankenlinie 0-VDI,1-DIN  :LVORZ: 1: DIN".into()),
            (179, "Bezugslaenge Flankenlinie fHß        :BZGFL: 1: Z".into()),
            (180, "Bezugslaenge Profil       fHa        :BZGPR: 0: M1-M2".into()),
            (183, "Schnitt: 0-Stirn, 1-Normal, 2-Achs   :SCHNT: 0".into()),
        ];
        let mut text = String::from(
            "HEADER KS.MK.FILE\r\nTYPE      STI                ! Gear\r\nVERSION   10.0 /2            ! Version\r\n\
             SEPARATOR :                  ! Columns\r\nUNITS     mm                 ! Units\r\n\
             ANGLE     decimal            ! Angle\r\nPROFILE   diameter           ! Graph\r\n\
             LANGUAGE  0 DEU              ! Language\r\nUNDEFINED -2147483.648       ! Undefined\r\n\
             FILTER LEAD:    F:S 2\r\nFILTER PROFILE: F:S 2\r\n\r\n",
        );
        for (code, line) in lines {
            let _ = write!(text, "  {code:<4}:{line:<98}\r\n");
        }
        text
    }

    fn helix(&self, text: &mut String, tooth: u32, flank: Flank) {
        let roll = self.roll(self.reference());
        let _ = write!(
            text,
            "Flankenlinie:\r\nZahn-Nr.: {tooth} {} / {SAMPLES}  Werte  x= {roll:.3}\r\n",
            side(flank)
        );
        let [from, to] = FACE;
        self.values(text, flank, u64::from(tooth), |share| {
            let u = (2.0 * share * WIDTH - from - to) / (to - from);
            (0.5 * self.helix_slope[flank] * u, u)
        });
    }

    fn profile(&self, text: &mut String, tooth: u32, flank: Flank) {
        let _ = write!(text, "Profil:\r\nZahn-Nr.: {tooth} {} / {SAMPLES}  Werte  z= 10\r\n", side(flank));
        let [start, from, to, end] = self.diameters().map(|d| self.roll(d));
        self.values(text, flank, 1000 + u64::from(tooth), |share| {
            let u = (2.0 * (start + share * (end - start)) - from - to) / (to - from);
            (0.5 * self.profile_slope[flank] * u, u)
        });
    }

    /// Samples as the file counts them: one turning direction for both flanks, another zero for every tooth.
    fn values(&self, text: &mut String, flank: Flank, number: u64, line: impl Fn(f64) -> (f64, f64)) {
        let zero = 8.0 * noise(self.seed, number);
        for k in 0..SAMPLES {
            let (slope, u) = line(k as f64 / (SAMPLES - 1) as f64);
            let wave = self.wave * (7.0 * u + f64::from(number as u32)).sin();
            let rough = 0.1 * noise(self.seed, 10_000 * number + k as u64);
            let f = zero + slope - self.crowning * u * u + wave + rough;
            let value = if self.undefined.contains(&k) { -2_147_483.648 } else { -flank.sign() * f };
            let _ = write!(text, "{value:>13.3}");
            if k % 12 == 11 {
                text.push_str("\r\n");
            }
        }
        text.push_str("\r\n");
    }

    /// Pitch deviations in whole nm, so that they close exactly.
    pub fn single_pitches(&self, flank: Flank) -> Vec<f64> {
        let z = self.teeth as usize;
        let cumulative = |k: usize| {
            let wave = self.eccentricity * (TAU * k as f64 / z as f64 + 0.3 * flank.sign()).sin();
            let rough = if k.is_multiple_of(z) {
                0.0
            } else {
                0.4 * noise(self.seed, 500 * (k + 1) as u64 + flank as u64)
            };
            (1e3 * (wave + rough)).round()
        };
        let last = cumulative(z) - cumulative(0);
        assert!(last == 0.0, "one revolution closes");
        (0..z).map(|k| 1e-3 * (cumulative(k + 1) - cumulative(k))).collect()
    }

    fn pitches(&self, text: &mut String) {
        for (flank, word) in [(Flank::Left, "linke"), (Flank::Right, "rechte")] {
            let _ = write!(
                text,
                "        {word} Zahnflanke\r\n        Zahn-Nr.          fp           Fp           Fr\r\n\r\n"
            );
            let mut sum = 0.0;
            for (k, fp) in self.single_pitches(flank).into_iter().enumerate() {
                sum += fp;
                let run_out = self.eccentricity * (TAU * k as f64 / f64::from(self.teeth)).cos();
                let _ = write!(text, "{:>8}{fp:>19.3}{sum:>13.3}{run_out:>12.3}                 \r\n", k + 1);
            }
            text.push_str("\r\n");
        }
    }

    /// Centres of the probe's ball on exact flanks, turned by the table.
    fn probe(&self, text: &mut String) {
        let z = self.teeth;
        text.push_str("Teilung: \r\nZ-Nr. Seite       PHI        X          Y          Z          \r\n");
        let radius = 0.5 * self.reference();
        for j in 0..z {
            for flank in [Flank::Right, Flank::Left] {
                let x = -0.12 * flank.sign();
                let y = (radius * radius - x * x).sqrt();
                let roll = (radius.powi(2) - self.base().powi(2)).sqrt() / self.base();
                let phi =
                    x.atan2(y) - flank.sign() * (roll - roll.atan()) - TAU * f64::from(j) / f64::from(z);
                let number = (2 * z - j) % z + 1;
                let letter = if flank == Flank::Left { "L" } else { "R" };
                let _ = write!(
                    text,
                    "{number:>3}   {letter} {:>15.4}{x:>11.4}{y:>11.4}{:>11.4}\r\n",
                    phi.to_degrees(),
                    87.23
                );
            }
        }
    }
}

fn side(flank: Flank) -> &'static str {
    if flank == Flank::Left { "links" } else { "rechts" }
}

/// A number from -1 to 1 that looks like chance and is always the same.
pub fn noise(seed: u64, place: u64) -> f64 {
    let mut x = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ place.wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x ^= x >> 31;
    x = x.wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^= x >> 29;
    x = x.wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x ^= x >> 32;
    2.0 * (x >> 11) as f64 / (1_u64 << 53) as f64 - 1.0
}
