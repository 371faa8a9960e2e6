//! German texts: why bodies do not make a flank, and what helps.

use super::Text;

pub(super) const TEXTS: &[Text] = &[
    (
        "the {} flank has no conjugate dresser at length of roll {n} mm",
        "die Flanke ({}) hat keinen konjugierten Abrichter bei Wälzlänge {} mm",
    ),
    (
        "the dresser circle at profile parameter {n} mm does not touch the {} flank of the worm",
        "der Kreis des Abrichters bei Profilparameter {} mm berührt die Schneckenflanke ({}) nicht",
    ),
    (
        "length of roll {n} mm of the {} worm flank needs dresser profile outside [{n}, {n}] mm",
        "Wälzlänge {} mm der Schneckenflanke ({}) braucht Abrichterprofil außerhalb von [{}, {}] mm",
    ),
    (
        "no dressing correction fulfils the conditions on the {} flank at v_zS = {n} mm; reached {n} percent ({})",
        "keine Zusatzbewegung beim Abrichten erfüllt die Bedingungen an der Flanke ({}) bei v_zS = {} mm; erreicht {} Prozent ({})",
    ),
    (
        "{} = {n} {} on the {} flank exceeds its limit {n} {}",
        "{} = {} {} an der Flanke ({}) überschreitet die Grenze {} {}",
    ),
    (
        "the profile of the {} flank is stretched by P = {n}, beyond {n}",
        "das Profil der Flanke ({}) ist um P = {} gestreckt, mehr als {}",
    ),
    (
        "the {} flank misses the wanted profile by {n} µm between the pitch points, more than {n} µm",
        "die Flanke ({}) verfehlt das verlangte Profil zwischen den Wälzpunkten um {} µm, mehr als {} µm",
    ),
    (
        "the {} flank needs the dresser's profile between radii {n} and {n} mm; it has {n} to {n} mm",
        "die Flanke ({}) braucht das Abrichterprofil zwischen den Radien {} und {} mm; es reicht von {} bis {} mm",
    ),
    (
        "dressing the {} flank a tip land of {n} mm touches the opposite flank; at most {n} mm fit",
        "beim Abrichten der Flanke ({}) berührt eine Kopfbreite von {} mm die Gegenflanke; höchstens {} mm passen",
    ),
    (
        "dressing the {} flank a tip land of {n} mm touches the opposite flank; no land is narrow enough",
        "beim Abrichten der Flanke ({}) berührt eine Kopfbreite von {} mm die Gegenflanke; keine ist schmal genug",
    ),
    (
        "dressing the {} flank cuts {n} mm into the worm of {n} mm pitch diameter at z = {n} mm",
        "das Abrichten der Flanke ({}) schneidet {} mm in die Schnecke mit Teilkreisdurchmesser {} mm bei z = {} mm",
    ),
    (
        "the plan needs {n} mm of worm width, the worm has {n} mm (diagonal ratio {n})",
        "der Plan braucht {} mm Schneckenbreite, die Schnecke hat {} mm (Diagonalverhältnis {})",
    ),
    (
        "diagonal ratio {n} leaves no line on the {} worm flank that could carry the modification",
        "Diagonalverhältnis {} lässt auf der Schneckenflanke ({}) keine Linie, die die Modifikation tragen könnte",
    ),
    (
        "the envelope of the {} flank nearly folds (determinant ratio {n}, allowed from {n})",
        "die Hüllfläche der Flanke ({}) faltet sich beinahe (Determinantenverhältnis {}, zulässig ab {})",
    ),
    (
        "diagonal ratio {n} misses the target by {n} µm on an ideal worm; allowed: {n} µm",
        "Diagonalverhältnis {} verfehlt die Sollflanke an der idealen Schnecke um {} µm; zulässig: {} µm",
    ),
    ("limit of an axis", "Grenze einer Achse"),
];
