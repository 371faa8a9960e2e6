//! A small writer of .mka and .mew files: a spur gear with known deviations, in both dialects and all encodings.

use std::fmt::Write;

/// A file to be made.
pub(super) struct Made {
    pub header: Vec<(u16, String)>,
    pub curves: Vec<String>,
    pub results: Vec<(u32, String)>,
    pub values: bool,
}

/// Teeth of the gear.
pub(super) const TEETH: u32 = 23;
/// Face width, mm.
pub(super) const WIDTH: f64 = 20.0;

impl Made {
    /// A spur gear of module 2 with 23 teeth, complete header, no data.
    pub fn gear() -> Self {
        let two = |a: &str, b: &str| format!("{a}        {b}");
        let header = vec![
            (2, "Datum.............: 01.02.26".into()),
            (3, "Zeit..............: 08:21:31   /   08:34:28".into()),
            (6, "Zeichnungsnr......: Z-17".into()),
            (7, "ME/Seite/KS/LZ....: 4711".into()),
            (8, "Benennung.........: Prüfrad".into()),
            (20, "Zahnrad-Daten                    links       rechts".into()),
            (21, "Normalmodul mn................  [mm]....:  2::L- :R-".into()),
            (22, format!("Zähnezahl z.............................: {TEETH}     Außenverzahnung")),
            (23, "Schrägungswinkel ß  ..........  [Grad]..:  0".into()),
            (24, "Eingriffswinkel alpha ........  [Grad]..: 20".into()),
            (25, "Profilverschiebung xm.........  [mm]....:   .5".into()),
            (26, format!("Zahnbreite ...................  [mm]....: {WIDTH}")),
            (28, "Kugeldurchmesser .............  [mm]....:  3.5".into()),
            (281, "Messzähnezahl=..........................:  3".into()),
            (41, format!("Start Messbereich...............da  [mm]..:  {}", two("44", "44.2"))),
            (42, format!("Start der Auswertestrecke.......d1  [mm]..:  {}", two("44.5", "44.5"))),
            (43, format!("Ende der Auswertestrecke........d2  [mm]..:  {}", two("49", "49"))),
            (431, format!("Start Kopfrücknahme.............dk1 [mm]..:  {}", two("48.6", "48.6"))),
            (432, format!("Ende Kopfrücknahme..............dk2 [mm]..:  {}", two("49.4", "49.4"))),
            (44, format!("Ende der Messstrecke............de  [mm]..:  {}", two("49.5", "49.5"))),
            (46, "Flankenlinienmesskreis  V-Kreis = 46 [mm]..:  46.5".into()),
            (47, "Teilungsmesskreis =46 (Kugel-Ø =3.5) [mm]..:  46".into()),
            (61, format!("Messanfang (unten)..............ba  [mm]..:  {}", two("0", "0"))),
            (62, format!("Auswerteanfang..................b1  [mm]..:  {}", two("1", "1.5"))),
            (63, format!("Auswerteende....................b2  [mm]..:  {}", two("19", "18.5"))),
            (64, format!("Messende (oben).................be  [mm]..:  {}", two("20", "20"))),
            (65, "Lage des Profils auf der Zahnbreite.. [mm]..:   10".into()),
            (82, "Winkelabw. links:         FHAL:5 : -5 : 0:   2.2".into()),
            (101, "Kugeltaster Ø      [Profil/Flanke]  [mm]..: .5 : (#5) :".into()),
            (161, "Zaehlrichtung 0-im Uhrzeigersinn     :ZRICH: 1".into()),
            (164, "Seitendefinition: 0-VDI/DIN / 1-USA  :ZSDEF: 0".into()),
            (165, "Reference fHb: 0-VDI / 1-DIN / 2- +-+ :R_FHB: 1 : L: + : R: -".into()),
            (178, "Vorzeichen Flankenlinie 0-VDI,1-DIN  :LVORZ: 1: DIN".into()),
            (179, "Bezugslaenge Flankenlinie fHß        :BZGFL: 1: Z".into()),
            (180, "Bezugslaenge Profil       fHa        :BZGPR: 0: M1-M2".into()),
            (183, "Schnitt: 0-Stirn, 1-Normal, 2-Achs   :SCHNT: 0".into()),
            (210, "fp  links             : 100 : 6".into()),
        ];
        Self { header, curves: Vec::new(), results: Vec::new(), values: false }
    }

    /// The same with a curve: a heading and values of the file, twelve a line.
    pub fn curve(mut self, section: &str, heading: &str, values: &[f64]) -> Self {
        let mut text = format!("{section}\r\n{heading}\r\n");
        for row in values.chunks(12) {
            for value in row {
                if value.is_nan() {
                    text.push_str(" -2147483.648");
                } else {
                    // As the machine writes it: no leading zero.
                    let short = format!("{value:.3}").replacen("0.", ".", usize::from(value.abs() < 1.0));
                    let _ = write!(text, "{short:>13}");
                }
            }
            text.push_str("\r\n");
        }
        self.curves.push(text);
        self
    }

    /// The same with any lines behind the header.
    pub fn lines(mut self, text: &str) -> Self {
        self.curves.push(text.replace('\n', "\r\n"));
        self
    }

    /// The same with another header line; an empty text takes it out.
    pub fn with(mut self, code: u16, text: &str) -> Self {
        self.header.retain(|(known, _)| *known != code);
        if !text.is_empty() {
            self.header.push((code, text.to_owned()));
            self.header.sort_by_key(|(code, _)| *code);
        }
        self
    }

    /// A file of printed values.
    pub fn printing(mut self, results: &[(u32, &str)]) -> Self {
        self.values = true;
        self.results = results.iter().map(|(code, text)| (*code, (*text).to_owned())).collect();
        self
    }

    /// The whole text with CRLF.
    pub fn text(&self) -> String {
        let kind = if self.values { "KS.MW.FILE" } else { "KS.MK.FILE" };
        let mut text = format!(
            "HEADER {kind}\r\nTYPE      STI                ! Gear\r\nVERSION   10.0 /2            ! Version\r\n\
             SEPARATOR :                  ! Columns\r\nUNITS     mm                 ! Units\r\n\
             ANGLE     decimal            ! Angle\r\nPROFILE   diameter           ! Graph\r\n\
             LANGUAGE  0 DEU              ! Language\r\nUNDEFINED -2147483.648       ! Undefined\r\n\
             FILTER LEAD:    F:S 2\r\nFILTER PROFILE: F:S 2\r\n\r\n"
        );
        for (code, line) in &self.header {
            let _ = write!(text, "  {code:<4}:{line}      \r\n");
        }
        for curve in &self.curves {
            text.push_str(curve);
            text.push_str("\r\n");
        }
        for (code, value) in &self.results {
            let _ = write!(text, "{code} : label 99 : {value}\r\n");
        }
        text
    }
}

/// Every character of these texts has a place in Latin-1.
pub(super) fn latin1(text: &str) -> Vec<u8> {
    text.chars().map(|c| u8::try_from(u32::from(c)).expect("a character of Latin-1")).collect()
}
