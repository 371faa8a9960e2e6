//! Measurements in the grammar of Klingelnberg files: a spur gear of module 2 with 23 teeth.

use std::fmt::Write;

/// An .mka file of a part; its slopes depend on the number.
pub fn mka(number: u32) -> String {
    let mut text = String::from(
        "HEADER KS.MK.FILE\nTYPE STI\nUNITS mm\nANGLE decimal\nPROFILE diameter\nLANGUAGE 0 DEU\nUNDEFINED -2147483.648\n\n",
    );
    for (code, line) in [
        (2, "Datum: 01.02.26"),
        (6, "Zeichnungsnr: Z-17"),
        (8, "Benennung: Ring"),
        (21, "Normalmodul mn: 2"),
        (22, "Zaehnezahl z: 23"),
        (23, "Schraegungswinkel: 0"),
        (24, "Eingriffswinkel alpha: 20"),
        (25, "Profilverschiebung xm: .5"),
        (26, "Zahnbreite: 20"),
        (41, "Start Messbereich da: 44"),
        (42, "Start der Auswertestrecke d1: 44.5"),
        (43, "Ende der Auswertestrecke d2: 49"),
        (44, "Ende der Messstrecke de: 49.5"),
        (46, "Flankenlinienmesskreis: 46.5"),
        (61, "Messanfang ba: 0"),
        (62, "Auswerteanfang b1: 1"),
        (63, "Auswerteende b2: 19"),
        (64, "Messende be: 20"),
        (65, "Lage des Profils: 10"),
        (164, "Seitendefinition :ZSDEF: 0"),
        (165, "Reference fHb :R_FHB: 1 : L: + : R: -"),
        (178, "Vorzeichen Flankenlinie :LVORZ: 1: DIN"),
        (179, "Bezugslaenge Flankenlinie :BZGFL: 1: Z"),
        (180, "Bezugslaenge Profil :BZGPR: 0: M1-M2"),
        (183, "Schnitt :SCHNT: 0"),
    ] {
        let _ = writeln!(text, "{code:<4}:{line}");
    }
    let _ = writeln!(
        text,
        "3   :Zeit: {:02}:{:02}:31   /   {:02}:{:02}:28",
        8 + number / 60,
        number % 60,
        9 + number / 60,
        number % 60
    );
    let _ = writeln!(text, "7   :ME: {number}");
    let amount = 2.0 + f64::from(number % 17) * 0.25;
    for (section, place) in [("Flankenlinie:", "x= 8.953"), ("Profil:", "z= 10")] {
        let _ = writeln!(text, "{section}");
        for (tooth, flank) in [(1, "links"), (1, "rechts"), (12, "links"), (12, "rechts")] {
            let _ = writeln!(text, "Zahn-Nr.: {tooth} {flank} / 60  Werte  {place}");
            for i in 0..60 {
                let x = f64::from(i) / 59.0;
                let f = amount * (x - 0.5) - f64::from(tooth) * 0.1 * x * (1.0 - x);
                let _ = write!(text, " {f:.3}");
                if i % 12 == 11 {
                    text.push('\n');
                }
            }
        }
    }
    text
}
