//! German texts: how results were verified: the two calculations, rays, control.

use super::Text;

pub(super) const TEXTS: &[Text] = &[
    (
        "The planned flank is the exact contact of the worm as dressed with the workpiece, solved point by point.",
        "Die geplante Flanke ist die genaue Berührung der abgerichteten Schnecke mit dem Werkstück, Punkt für Punkt gelöst.",
    ),
    (
        "The simulated flank comes from a second calculation that shares no formula with the first: normal rays of the worm are shortened by the dresser over the real dressing motion, a smooth surface through their ends is the worm, and normal rays of the workpiece are shortened by that worm over the real grinding motion. Only the shapes, the chain of axes and the motions are common to both; the plan only tells on which part of the worm the rays stand.",
        "Die simulierte Flanke stammt aus einer zweiten Rechnung, die mit der ersten keine Formel gemeinsam hat: Normalenstrahlen der Schnecke werden vom Abrichter über die wirkliche Abrichtbewegung verkürzt, eine glatte Fläche durch ihre Enden ist die Schnecke, und Normalenstrahlen des Werkstücks werden von dieser Schnecke über die wirkliche Schleifbewegung verkürzt. Nur die Formen, die Kette der Achsen und die Bewegungen sind beiden gemeinsam; der Plan gibt nur an, auf welchem Teil der Schnecke die Strahlen stehen.",
    ),
    (
        "Material removal by normal rays (referee)",
        "Materialabtrag durch Normalenstrahlen (unabhängige Simulation)",
    ),
    ("Stage", "Stufe"),
    ("Rays", "Strahlen"),
    ("Poses", "Stellungen"),
    ("Own discretisation error", "Eigener Diskretisierungsfehler"),
    ("dresser against worm", "Abrichter gegen Schnecke"),
    ("worm against workpiece", "Schnecke gegen Werkstück"),
    ("disc on its lines against worm, a sample", "Scheibe auf ihren Zeilen gegen Schnecke, Stichprobe"),
    (
        "The simulated flank is the envelope, as an endlessly slow feed leaves it. At the feed of the job the marks stand above it by up to: {}.",
        "Die simulierte Flanke ist die Hüllfläche, wie ein unendlich langsamer Vorschub sie lässt. Beim Vorschub des Auftrags stehen die Vorschubmarkierungen darüber um bis zu: {}.",
    ),
    ("left flank {} um", "linke Flanke {} um"),
    ("right flank {} um", "rechte Flanke {} um"),
    ("left flank {} um, right flank {} um", "linke Flanke {} um, rechte Flanke {} um"),
    (
        "The stroke was simulated with the control of the job instead of ideal couplings: scales and encoders are counted, the gearbox sums the counts, the servo follows with inertia, friction and disturbances. The figures are what that alone leaves, normal to the flank, positive where material is left standing; with constant parts removed, as centring the tooth space does.",
        "Der Hub wurde mit der Steuerung des Auftrags statt mit idealen Kopplungen simuliert: Maßstäbe und Drehgeber werden gezählt, das Getriebe summiert, der Antrieb folgt mit Trägheit, Reibung und Störungen. Die Zahlen sind, was das allein hinterlässt, normal zur Flanke, positiv, wo Material steht; ohne konstante Anteile, wie nach dem Einmitten.",
    ),
    ("What gearbox and servo leave", "Was Getriebe und Antrieb hinterlassen"),
    ("Deviation from the target with it", "Abweichung von der Sollflanke damit"),
    ("Single pitch", "Einzelteilung"),
    ("Cumulative pitch", "Gesamtteilung"),
    ("Closed form against rays in time", "Formel gegen Strahlen über der Zeit"),
    ("Greatest torque", "Größtes Drehmoment"),
    ("At the torque limit", "An der Momentengrenze"),
    (
        "Over all teeth. The last but two: rays of the flank in the motion that was really driven less those in the ideal one, on {} places.",
        "Über alle Zähne. Die drittletzte Spalte: Strahlen der Flanke in der wirklich gefahrenen Bewegung minus denen in der idealen, an {} Stellen.",
    ),
    (
        "Every point of the flank keeps the error of the moment in which it is ground.",
        "Jeder Punkt der Flanke behält den Fehler des Augenblicks, in dem er geschliffen wird.",
    ),
    (
        "Error of the workpiece's angle over the stroke, as it would stand on the flank",
        "Fehler des Werkstückwinkels über dem Hub, wie er auf der Flanke stünde",
    ),
    (
        "Deviation of the first tooth by gearbox and servo",
        "Abweichung des ersten Zahns durch Getriebe und Antrieb",
    ),
    (
        "Errors at the frequency of the threads stand as waves along lines of equal rotation, slower ones as waves over the face width.",
        "Fehler in der Frequenz der Gänge stehen als Wellen längs Linien gleicher Drehung, langsamere als Wellen über der Zahnbreite.",
    ),
    (
        "Profile traces of some teeth by gearbox and servo",
        "Profillinien einiger Zähne durch Getriebe und Antrieb",
    ),
    (
        "Helix traces of some teeth by gearbox and servo",
        "Flankenlinien einiger Zähne durch Getriebe und Antrieb",
    ),
    ("At mid face width.", "In der Mitte der Zahnbreite."),
    ("At the middle of the roll.", "In der Mitte der Wälzlänge."),
    (
        "Mean deviation of each tooth by gearbox and servo",
        "Mittlere Abweichung jedes Zahns durch Getriebe und Antrieb",
    ),
    (
        "Errors once per turn of the workpiece stay with the tooth: they are pitch deviations.",
        "Fehler einmal je Werkstückumdrehung bleiben beim Zahn: Sie sind Teilungsabweichungen.",
    ),
    ("speed of the worm", "Drehzahl der Schnecke"),
    ("speed of the workpiece", "Drehzahl des Werkstücks"),
    ("speed of the feed", "Vorschubgeschwindigkeit"),
    ("pitch of the feed's scale", "Teilung des Vorschubmaßstabs"),
    ("flank per part of the setpoint", "Flanke je Teil des Sollwerts"),
    ("flank per count of the workpiece's encoder", "Flanke je Schritt des Werkstückdrehgebers"),
    ("rounding of the feed's ratio", "Rundung des Vorschubverhältnisses"),
    ("frequency of the threads", "Frequenz der Gänge"),
    ("flank per torque at that frequency", "Flanke je Drehmoment bei dieser Frequenz"),
    ("{}, error at the flank [µm]", "{}, Fehler an der Flanke [µm]"),
    ("setpoint of the gearbox", "Sollwert des Getriebes"),
    ("mean f_n [µm]", "mittleres f_n [µm]"),
];
