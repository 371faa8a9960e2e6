//! German texts: stock, strokes, load of the worm, time and cost of grinding.

use super::Text;

pub(super) const TEXTS: &[Text] = &[
    ("Strokes", "Hübe"),
    ("Stroke", "Hub"),
    ("Depth of cut", "Schnitttiefe"),
    ("Feed", "Vorschub"),
    ("Sense", "Sinn"),
    ("Approach", "Anlaufweg"),
    ("Travel", "Weg"),
    ("Volume", "Volumen"),
    ("Largest rate Q_w", "Größtes Q_w"),
    ("Largest Q'_w", "Größtes Q'_w"),
    ("Contact length", "Kontaktlänge"),
    (
        "Stock of all spaces: {} mm³. Depth of cut, Q'_w and contact length are the largest over both flanks; the approach is the way before the contact lines on which stock is ground already.",
        "Aufmaß aller Lücken: {} mm³. Schnitttiefe, Q'_w und Kontaktlänge sind die größten beider Flanken; der Anlaufweg ist der Weg vor den Berührlinien, auf dem schon Aufmaß abgetragen wird.",
    ),
    (
        "Each stroke from its first contact on; ways between strokes are left out.",
        "Jeder Hub ab der ersten Berührung; Wege zwischen den Hüben sind ausgelassen.",
    ),
    ("Removal rate", "Zeitspanvolumen"),
    ("Time in contact [s]", "Zeit im Kontakt [s]"),
    ("{n} roughing", "{} Schruppen"),
    ("{n} finishing", "{} Schlichten"),
    ("{n} spark-out", "{} Ausfunken"),
    (
        "What each millimetre of the worm's width has removed, the largest over the profile; parts between two dressings: {}.",
        "Was jeder Millimeter der Schneckenbreite abgetragen hat, das größte über dem Profil; Teile zwischen zwei Abrichtvorgängen: {}.",
    ),
    ("Load of the worm", "Belastung der Schnecke"),
    ("Place on the worm z_1 [mm]", "Stelle auf der Schnecke z_1 [mm]"),
    ("Removed volume [mm³/mm]", "Abgetragenes Volumen [mm³/mm]"),
    ("Worm, time and cost", "Schnecke, Zeit und Kosten"),
    ("Stock of all spaces", "Aufmaß aller Lücken"),
    ("Parts if the width were used at its best", "Teile bei bester Nutzung der Breite"),
    ("Dressings per worm", "Abrichtvorgänge je Schnecke"),
    ("Parts per worm", "Teile je Schnecke"),
    ("Grinding", "Schleifen"),
    ("Beside grinding", "Nebenzeiten"),
    ("Cost of the machine", "Kosten der Maschine"),
    ("Cost of the worm", "Kosten der Schnecke"),
    ("Cost of the dresser", "Kosten des Abrichters"),
    ("Cost of changing the worm", "Kosten des Schneckenwechsels"),
    ("Figures over the shop's limits", "Kennzahlen zu den Grenzen des Betriebs"),
    (
        "The limits are the shop's own (grit, coolant, steel, dressing): a share above 1 says harder than what it calls safe, not burnt. No temperature is given.",
        "Die Grenzen sind die des Betriebs (Korn, Kühlschmierstoff, Stahl, Abrichten): Ein Anteil über 1 heißt härter, als er für sicher hält, nicht verbrannt. Eine Temperatur wird nicht angegeben.",
    ),
];
