//! German texts: nC programs and axes in reports.

use super::Text;

pub(super) const TEXTS: &[Text] = &[
    (
        "A reader that shares no code with the writers read the text of each program. The axes that it found were carried through the machine to the bodies, and the referee dressed and ground the flank once more with these motions alone. Its largest deviation from the target stands above and, per flank, below.",
        "Ein Leser, der mit den Schreibern keinen Code gemeinsam hat, las den Text jedes Programms. Die gefundenen Achsen wurden über die Maschine zu den Körpern geführt, und die unabhängige Simulation richtete ab und schliff die Flanke noch einmal allein mit diesen Bewegungen. Ihre größte Abweichung von der Sollflanke steht oben und, je Flanke, unten.",
    ),
    ("Proven from the program text", "Aus dem Programmtext nachgewiesen"),
    ("Controls", "Steuerungen"),
    ("Difference from the run", "Unterschied zum Lauf"),
    ("Difference explained", "Erklärter Unterschied"),
    ("Chord deviation", "Sehnenfehler"),
    ("Rounding", "Rundung"),
    (
        "Largest values over the flank. Difference: the flank from the text against the flank that the motions of this report leave. Explained: what chords and the rounding of the numbers may do to it, dressing and grinding together; with a larger difference no program would have been written.",
        "Größte Werte über der Flanke. Unterschied: die Flanke aus dem Text gegen die, welche die Bewegungen dieses Berichts hinterlassen. Erklärt: was Sehnen und das Runden der Zahlen bewirken dürfen, Abrichten und Schleifen zusammen; bei größerem Unterschied wäre kein Programm geschrieben worden.",
    ),
    ("Programs for the machine {}", "Programme für die Maschine {}"),
    ("Job", "Aufgabe"),
    ("Blocks", "Sätze"),
    ("Cycle time", "Zykluszeit"),
    (
        "Blocks: those that move axes. Cycle time: all moves with their ramps within the limits of the axes, without loading and changing tools. The workpiece is clamped with its +z into the −z of its spindle (datum face down; the datum face is face II, at upper z).",
        "Sätze: solche, die Achsen bewegen. Zykluszeit: alle Bewegungen mit ihren Rampen innerhalb der Grenzen der Achsen, ohne Laden und Werkzeugwechsel. Das Werkstück ist mit seinem +z ins −z seiner Spindel gespannt (Bezugsstirnfläche unten; sie ist Stirnfläche II, bei größerem z).",
    ),
    (
        "Blocks: those that move axes. Cycle time: all moves with their ramps within the limits of the axes, without loading and changing tools. The workpiece is clamped with its +z along that of its spindle (datum face up; the datum face is face II, at upper z).",
        "Sätze: solche, die Achsen bewegen. Zykluszeit: alle Bewegungen mit ihren Rampen innerhalb der Grenzen der Achsen, ohne Laden und Werkzeugwechsel. Das Werkstück ist mit seinem +z längs dem seiner Spindel gespannt (Bezugsstirnfläche oben; sie ist Stirnfläche II, bei größerem z).",
    ),
    ("dressing the left flank by lines", "Abrichten der linken Flanke, zeilenweise"),
    ("dressing the right flank by lines", "Abrichten der rechten Flanke, zeilenweise"),
    ("grinding", "Schleifen"),
    ("Passes of {}: {}", "Durchgänge, {}: {}"),
    ("Pass", "Durchgang"),
    ("Driven from .. to", "Gefahren von .. bis"),
    ("Braked", "Gebremst"),
    (
        "From .. to and speed are those of the {}, run-in and run-out included; time is that of one drive. Braked: share of the wanted speed, and the limit that forbids more. Chord deviation: how far the straight blocks leave the course, seen on the flank. Rounding: what the digits of the numbers may add.",
        "Von .. bis und Geschwindigkeit sind die von {}, An- und Überlauf eingeschlossen; Zeit ist die einer Fahrt. Gebremst: Anteil der gewünschten Geschwindigkeit und die Grenze, die mehr verbietet. Sehnenfehler: wie weit die geraden Sätze den Verlauf verlassen, auf der Flanke gesehen. Rundung: was die Stellen der Zahlen hinzufügen können.",
    ),
    (
        "worm position v_zS, the speed being the least along a line",
        "Schneckenlage v_zS, die Geschwindigkeit die kleinste längs einer Zeile",
    ),
    ("worm position v_zS", "Schneckenlage v_zS"),
    ("feed z_V2", "Vorschub z_V2"),
    ("Drawn and listed: the program of {}.", "Gezeichnet und aufgeführt: das Programm für {}."),
    (
        "Drawn and listed: the program of {}. That of {} drive the axes alike.",
        "Gezeichnet und aufgeführt: das Programm für {}. Das für {} fährt die Achsen ebenso.",
    ),
    (
        "Drawn and listed: the program of {}. Those of {} drive the axes alike.",
        "Gezeichnet und aufgeführt: das Programm für {}. Die für {} fahren die Achsen ebenso.",
    ),
    (
        "Drawn and listed: the program of {}. That of {} drive the axes alike. The programs of {} drive the same axes with blocks of their own; their times stand above.",
        "Gezeichnet und aufgeführt: das Programm für {}. Das für {} fährt die Achsen ebenso. Die Programme für {} fahren dieselben Achsen mit eigenen Sätzen; ihre Zeiten stehen oben.",
    ),
    (
        "Drawn and listed: the program of {}. The programs of {} drive the same axes with blocks of their own; their times stand above.",
        "Gezeichnet und aufgeführt: das Programm für {}. Die Programme für {} fahren dieselben Achsen mit eigenen Sätzen; ihre Zeiten stehen oben.",
    ),
    (
        "Not drawn, because the machine file gives no limits and they jump: {}.",
        "Nicht gezeichnet, weil die Maschinendatei keine Grenzen gibt und sie springen: {}.",
    ),
    ("Axes that move in {}", "Bewegte Achsen beim {}"),
    ("Axis", "Achse"),
    ("Word", "Wort"),
    ("From", "Von"),
    ("to", "bis"),
    ("To", "Bis"),
    ("Way", "Weg"),
    ("Largest velocity", "Größte Geschwindigkeit"),
    ("Largest acceleration", "Größte Beschleunigung"),
    ("of limit", "der Grenze"),
    ("The share is that of the machine's limit.", "Der Anteil ist der an der Grenze der Maschine."),
    ("The share is that of the machine's limit. {}", "Der Anteil ist der an der Grenze der Maschine. {}"),
    ("Standing still: {}.", "In Ruhe: {}."),
    ("Turning as a spindle: {}.", "Als Spindel drehend: {}."),
    ("Standing still: {}. Turning as a spindle: {}.", "In Ruhe: {}. Als Spindel drehend: {}."),
    (
        "Positions count as the machine file does; the control counts {} the other way.",
        "Positionen zählen wie in der Maschinendatei; die Steuerung zählt {} andersherum.",
    ),
    (
        "Positions count as the machine file does; the control counts {} the other way. {}",
        "Positionen zählen wie in der Maschinendatei; die Steuerung zählt {} andersherum. {}",
    ),
];
