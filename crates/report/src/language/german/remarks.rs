//! German texts: remarks, reasons of a verdict, and what helps.

use super::Text;

pub(super) const TEXTS: &[Text] = &[
    // Drawing, blank, dressing.
    ("backs of blades of 1 mm and less", "Rücken von Schaufeln von 1 mm und weniger"),
    (
        "the profile of the dresser is a curve through measured points: with another measurement the left flank would differ by up to {n} µm (95 %), which no verdict counts",
        "das Profil des Abrichters ist eine Kurve durch gemessene Punkte: mit einer anderen Messung wäre die linke Flanke um bis zu {} µm (95 %) anders, was in kein Urteil eingeht",
    ),
    (
        "the profile of the dresser is a curve through measured points: with another measurement the right flank would differ by up to {n} µm (95 %), which no verdict counts",
        "das Profil des Abrichters ist eine Kurve durch gemessene Punkte: mit einer anderen Messung wäre die rechte Flanke um bis zu {} µm (95 %) anders, was in kein Urteil eingeht",
    ),
    (
        "measure it at more points or with less noise: that is more than a tenth of the tolerance",
        "es an mehr Stellen oder mit weniger Rauschen messen: das ist mehr als ein Zehntel der Toleranz",
    ),
    (
        "none is needed: that is less than a tenth of the tolerance",
        "nichts ist nötig: das ist weniger als ein Zehntel der Toleranz",
    ),
    (
        "dressing now cuts up to {n} µm into the left flank of the worm of {n} mm that is left later, at z = {n} mm; worms down to {n} mm stay whole",
        "das Abrichten schneidet jetzt bis {} µm in die linke Flanke der Schnecke von {} mm, die später bleibt, bei z = {} mm; Schnecken bis {} mm bleiben heil",
    ),
    (
        "dressing now cuts up to {n} µm into the right flank of the worm of {n} mm that is left later, at z = {n} mm; worms down to {n} mm stay whole",
        "das Abrichten schneidet jetzt bis {} µm in die rechte Flanke der Schnecke von {} mm, die später bleibt, bei z = {} mm; Schnecken bis {} mm bleiben heil",
    ),
    (
        "end the life of the worm there (technology.life.last_tip_diameter = {n} now), take a smaller dresser, or design it for a smaller worm (dresser.designed_for)",
        "die Schnecke dort aufbrauchen lassen (technology.life.last_tip_diameter, jetzt {}), einen kleineren Abrichter nehmen oder ihn für eine kleinere Schnecke auslegen (dresser.designed_for)",
    ),
    ("class {n} of ISO 1328-1", "Klasse {} nach ISO 1328-1"),
    (
        "a plan has no pitches and no run-out; `flankwright inspect` judges a measured gear by it",
        "ein Plan hat keine Teilungen und keinen Rundlauf; `flankwright inspect` beurteilt ein gemessenes Rad danach",
    ),
    (
        "the table of the stock leaves out {n} tooth spaces: they get the mean of the others",
        "die Tabelle des Aufmaßes lässt {} Zahnlücken aus: sie erhalten den Mittelwert der anderen",
    ),
    (
        "measure every tooth, or keep some stock more than the measured teeth need",
        "jeden Zahn messen oder etwas mehr Aufmaß vorsehen, als die gemessenen Zähne brauchen",
    ),
    (
        "the overlap of dressing is {n}, the shop asks for {n}",
        "der Überdeckungsgrad des Abrichtens ist {}, der Betrieb verlangt {}",
    ),
    (
        "dress slower (machine.dressing_worm_speed_rpm = {n}) or turn the dresser faster (machine.dresser_speed_rpm)",
        "langsamer abrichten (machine.dressing_worm_speed_rpm = {}) oder den Abrichter schneller drehen (machine.dresser_speed_rpm)",
    ),
    (
        "left flank after stroke {n}, which shifts by a ratio of its own",
        "linke Flanke nach Hub {}, der mit eigenem Verhältnis shiftet",
    ),
    (
        "right flank after stroke {n}, which shifts by a ratio of its own",
        "rechte Flanke nach Hub {}, der mit eigenem Verhältnis shiftet",
    ),
    (
        "left flank after stroke {n}, which has its own area of the worm",
        "linke Flanke nach Hub {}, der einen eigenen Bereich der Schnecke hat",
    ),
    (
        "right flank after stroke {n}, which has its own area of the worm",
        "rechte Flanke nach Hub {}, der einen eigenen Bereich der Schnecke hat",
    ),
    ("{n} µm or more above the finished flank", "mindestens {} µm über der fertigen Flanke"),
    ("up to {n} µm below the finished flank", "bis {} µm unter der fertigen Flanke"),
    (
        "stroke {n} goes {n} um below the finished left flank: its shift leaves another twist than the plan, more than the {n} um that it is to leave",
        "Hub {} geht {} um unter die fertige linke Flanke: sein Shift lässt eine andere Verschränkung stehen als der Plan, mehr als die {} um, die er stehen lassen soll",
    ),
    (
        "stroke {n} goes {n} um below the finished right flank: its shift leaves another twist than the plan, more than the {n} um that it is to leave",
        "Hub {} geht {} um unter die fertige rechte Flanke: sein Shift lässt eine andere Verschränkung stehen als der Plan, mehr als die {} um, die er stehen lassen soll",
    ),
    (
        "stroke {n} goes {n} um below the finished left flank: its area leaves another flank than the plan, more than the {n} um that it is to leave",
        "Hub {} geht {} um unter die fertige linke Flanke: sein Bereich lässt eine andere Flanke stehen als der Plan, mehr als die {} um, die er stehen lassen soll",
    ),
    (
        "stroke {n} goes {n} um below the finished right flank: its area leaves another flank than the plan, more than the {n} um that it is to leave",
        "Hub {} geht {} um unter die fertige rechte Flanke: sein Bereich lässt eine andere Flanke stehen als der Plan, mehr als die {} um, die er stehen lassen soll",
    ),
    ("stock on the left flank", "Aufmaß der linken Flanke"),
    ("stock on the right flank", "Aufmaß der rechten Flanke"),
    ("{n} to {n} µm over the finished flank", "{} bis {} µm über der fertigen Flanke"),
    (
        "material is missing on the left flank, up to {n} um: it does not clean up there",
        "auf der linken Flanke fehlt Material, bis {} um: dort wird sie nicht sauber",
    ),
    (
        "material is missing on the right flank, up to {n} um: it does not clean up there",
        "auf der rechten Flanke fehlt Material, bis {} um: dort wird sie nicht sauber",
    ),
    (
        "raise stock.allowance_um by {n} um or more, or centre the blank (stock.run_out)",
        "stock.allowance_um um mindestens {} um erhöhen oder das Rohteil zentrieren (stock.run_out)",
    ),
    // Items of a verdict: figures and reasons.
    ("{n} of {n} µm", "{} von {} µm"),
    ("{n} µm with the process", "{} µm mit dem Prozess"),
    ("{n} µm apart", "{} µm auseinander"),
    ("{n} mm apart or more", "mindestens {} mm auseinander"),
    ("{n} mm of {} or more, over all blocks", "mindestens {} mm von {}, über alle Sätze"),
    ("determinant ratio {n}, at least {n}", "Determinantenverhältnis {}, mindestens {}"),
    ("left flank: plan against simulation", "linke Flanke: Plan gegen Simulation"),
    ("right flank: plan against simulation", "rechte Flanke: Plan gegen Simulation"),
    ("plan against simulation", "Plan gegen Simulation"),
    ("prediction against simulation", "Vorhersage gegen Simulation"),
    ("closed form against rays", "geschlossene Formel gegen Strahlen"),
    ("tip edge of the worm", "Kopfkante der Schnecke"),
    ("left flank with gearbox and servo", "linke Flanke mit Getriebe und Antrieb"),
    ("right flank with gearbox and servo", "rechte Flanke mit Getriebe und Antrieb"),
    ("dressing of the worm through gearbox and servo", "Abrichten der Schnecke über Getriebe und Antrieb"),
    (
        "[control] is that of grinding; axes of dressing move as commanded",
        "[control] ist die des Schleifens; die Achsen des Abrichtens bewegen sich wie vorgegeben",
    ),
    ("the job does not grind it", "der Auftrag schleift sie nicht"),
    ("the job names no machine", "der Auftrag nennt keine Maschine"),
    ("a roughing stroke goes below the finished flank", "ein Schrupphub geht unter die fertige Flanke"),
    (
        "the job has no [control]; couplings are ideal",
        "der Auftrag hat kein [control]; Kopplungen sind ideal",
    ),
    (
        "the simulation finds the planned fillet; the job gives it no tolerance",
        "die Simulation findet die geplante Fußrundung; der Auftrag gibt ihr keine Toleranz",
    ),
    (
        "no body of the job or of the machine's description stands for it, or its place is not known",
        "kein Körper des Auftrags oder der Maschinenbeschreibung steht dafür, oder sein Ort ist nicht bekannt",
    ),
    ("their clearance is not checked for this process", "ihr Abstand wird für diesen Prozess nicht geprüft"),
    ("the proof does not cover it", "der Nachweis umfasst es nicht"),
    ("programs: dressing of the worm by lines", "Programme: Abrichten der Schnecke in Zeilen"),
    (
        "the lines of a disc in point contact reach the one area of the plan; on several areas no program is written for them, only grinding programs are",
        "die Zeilen einer Scheibe in Punktberührung erreichen den einen Bereich des Plans; auf mehreren Bereichen werden für sie keine Programme geschrieben, nur Schleifprogramme",
    ),
    ("{n} of {n} dressed, from the text", "{} von {} abgerichtet, aus dem Text"),
    ("{n} ground, from the text", "{} geschliffen, aus dem Text"),
    ("{n} of {n} µm from the text", "{} von {} µm aus dem Text"),
    (
        "{n} on each of {n} threads counted, within {n} µm of the plan's, from the text",
        "{} auf jedem von {} Gängen gezählt, innerhalb von {} µm um die des Plans, aus dem Text",
    ),
    ("threads of the worm", "Gänge der Schnecke"),
    ("lines on the left flank of the worm", "Zeilen auf der linken Flanke der Schnecke"),
    ("lines on the right flank of the worm", "Zeilen auf der rechten Flanke der Schnecke"),
    ("finishing areas of the worm", "Schlichtbereiche der Schnecke"),
    ("{} clear of the worm's side in the programs", "{} frei von der Seite der Schnecke in den Programmen"),
    ("surface of the left flank", "Fläche der linken Flanke"),
    ("surface of the right flank", "Fläche der rechten Flanke"),
    // Grinding.
    (
        "plan and simulation of the {} differ by {n} µm, more than a tenth of the tolerance of {n} µm",
        "Plan und Simulation ({}) unterscheiden sich um {} µm, mehr als ein Zehntel der Toleranz von {} µm",
    ),
    (
        "round the edges of reliefs (transition_mm), take smaller amounts, or widen the tolerance",
        "Kanten der Rücknahmen runden (transition_mm), kleinere Beträge nehmen oder die Toleranz erweitern",
    ),
    (
        "the envelope of the {} comes near a fold: determinant ratio {n}, at least {n} is wanted",
        "die Hüllfläche ({}) kommt einer Faltung nahe: Determinantenverhältnis {}, verlangt mindestens {}",
    ),
    (
        "round the edges of reliefs (transition_mm), take smaller amounts or another diagonal ratio, or lower grinding.least_determinant_ratio",
        "Kanten der Rücknahmen runden (transition_mm), kleinere Beträge oder ein anderes Diagonalverhältnis nehmen oder grinding.least_determinant_ratio senken",
    ),
    (
        "the envelope of the {} comes near a fold (ratio {n})",
        "die Hüllfläche ({}) kommt einer Faltung nahe (Verhältnis {})",
    ),
    (
        "reduce the amount or choose another diagonal ratio",
        "den Betrag verringern oder ein anderes Diagonalverhältnis wählen",
    ),
    (
        "gearbox and servo leave up to {n} µm on the {}, together with the process {n} µm; the tolerance is {n} µm",
        "Getriebe und Antrieb lassen bis zu {} µm stehen ({}), zusammen mit dem Prozess {} µm; die Toleranz ist {} µm",
    ),
    (
        "take a stiffer loop (control.servo.bandwidth_hz), finer encoders and scales, or reduce the disturbances; the report shows which of them counts",
        "einen steiferen Regelkreis (control.servo.bandwidth_hz), feinere Geber und Maßstäbe nehmen oder die Störungen verringern; der Bericht zeigt, was davon zählt",
    ),
    (
        "the tip edge of the worm cuts the {} {n} µm deep at the start of the evaluated profile; the tolerance is {n} µm",
        "die Kopfkante der Schnecke schneidet am Anfang des ausgewerteten Profils ({}) {} µm tief ein; die Toleranz ist {} µm",
    ),
    (
        "reduce worm.tip_diameter, raise gear.form_diameter or gear.evaluation.start_diameter, or take more profile shift",
        "worm.tip_diameter verringern, gear.form_diameter oder gear.evaluation.start_diameter erhöhen oder mehr Profilverschiebung nehmen",
    ),
    (
        "this plan leaves {n} µm; the planner found no settings that leave less. That none exist is not shown",
        "dieser Plan lässt {} µm stehen; die Planung fand keine Einstellungen, die weniger lassen. Dass es keine gibt, ist nicht gezeigt",
    ),
    (
        "this plan leaves {n} µm; the planner found no settings that leave less",
        "dieser Plan lässt {} µm stehen; die Planung fand keine Einstellungen, die weniger lassen",
    ),
    ("that none exist is not shown", "dass es keine gibt, ist nicht gezeigt"),
    (
        "set precompensation = true, take smoother modifications, or widen the tolerance",
        "precompensation = true setzen, glattere Modifikationen nehmen oder die Toleranz erweitern",
    ),
    (
        "use diagonal_ratio = \"auto\", take smoother modifications, or widen the tolerance",
        "diagonal_ratio = \"auto\" verwenden, glattere Modifikationen nehmen oder die Toleranz erweitern",
    ),
    (
        "change the settings, or let `plan` find them",
        "die Einstellungen ändern oder von `plan` finden lassen",
    ),
    (
        "from the text of the programs for {} the {} deviates by {n} µm; the tolerance is {n} µm",
        "aus dem Text der Programme für {} weicht die Flanke ({}) um {} µm ab; die Toleranz ist {} µm",
    ),
    (
        "mend what the plan misses; if the plan is met, lower chord_tolerance_um of the control",
        "beheben, was der Plan verfehlt; ist der Plan erreicht, chord_tolerance_um der Steuerung senken",
    ),
    (
        "the feed marks of the {} stand up to {n} µm above the envelope",
        "die Vorschubmarkierungen ({}) stehen bis zu {} µm über der Hüllfläche",
    ),
    ("reduce grinding.feed_per_revolution", "grinding.feed_per_revolution verringern"),
    (
        "the radial feed brings a natural twist along: {}",
        "die Radialzustellung bringt eine natürliche Verschränkung mit: {}",
    ),
    (
        "directed parts of the target ask for diagonal ratio {n} on the left flank and {n} on the right one",
        "gerichtete Teile der Sollflanke verlangen das Diagonalverhältnis {} an der linken und {} an der rechten Flanke",
    ),
    (
        "a worm with {} lays its lines onto both at {n}",
        "eine Schnecke mit {} legt ihre Linien auf beide bei {}",
    ),
    ("or {} (ratio {n})", "oder {} (Verhältnis {})"),
    ("dressed lines shift the values slightly", "abgerichtete Linien verschieben die Werte etwas"),
    (
        "the worm is not checked: `explore` with worm.cone_angle_deg shows whether it can be made",
        "die Schnecke ist nicht geprüft: `explore` mit worm.cone_angle_deg zeigt, ob sie herstellbar ist",
    ),
    (
        "dressed lines shift the values slightly, and the worm is not checked: `explore` with worm.cone_angle_deg shows whether it can be made",
        "abgerichtete Linien verschieben die Werte etwas, und die Schnecke ist nicht geprüft: `explore` mit worm.cone_angle_deg zeigt, ob sie herstellbar ist",
    ),
    (
        "the worm's tip reaches {n} mm of roll beyond the point that grinds the base circle: below the start of the evaluated profile it undercuts the gear; what it takes of the evaluated flank is judged",
        "der Kopf der Schnecke reicht {} mm Wälzlänge über den Punkt hinaus, der den Grundkreis schleift: Unterhalb des ausgewerteten Profils unterschneidet er das Zahnrad; was er von der ausgewerteten Flanke nimmt, ist beurteilt",
    ),
    ("reduce worm.tip_diameter", "worm.tip_diameter verringern"),
    (
        "the worm's tip reaches {n} mm beyond the root circle of the gear",
        "der Kopf der Schnecke reicht {} mm über den Fußkreis des Zahnrads hinaus",
    ),
    (
        "reduce worm.tip_diameter or check gear.root_diameter",
        "worm.tip_diameter verringern oder gear.root_diameter prüfen",
    ),
    (
        "the worm's tip ends {n} mm before the radius that grinds the root form circle",
        "der Kopf der Schnecke endet {} mm vor dem Radius, der den Fuß-Formkreis schleift",
    ),
    ("raise worm.tip_diameter or gear.form_diameter", "worm.tip_diameter oder gear.form_diameter erhöhen"),
    (
        "reduce gear.tip_diameter or gear.profile_shift",
        "gear.tip_diameter oder gear.profile_shift verringern",
    ),
    (
        "no NC programs are written: the job names no machine",
        "keine NC-Programme geschrieben: Der Auftrag nennt keine Maschine",
    ),
    ("no NC programs are written: the target is {}", "keine NC-Programme geschrieben: Das Soll ist {}"),
    (
        "add [machine] with `file = \"machines/....toml\"`, or leave output.programs out",
        "[machine] mit `file = \"machines/....toml\"` ergänzen oder output.programs weglassen",
    ),
    (
        "mend what the verdict names, or set output.programs_of_missed = true: their first lines say it then",
        "beheben, was das Urteil nennt, oder output.programs_of_missed = true setzen: Dann sagen es ihre ersten Zeilen",
    ),
    (
        "the programs feed {n} mm per revolution of the gear",
        "die Programme schieben {} mm je Umdrehung des Zahnrads vor",
    ),
    ("give grinding.feed_per_revolution", "grinding.feed_per_revolution angeben"),
    // Milling.
    (
        "the job does not mill it; that nothing enters it is judged",
        "der Auftrag fräst sie nicht; dass nichts in sie eindringt, ist beurteilt",
    ),
    ("the job mills one space", "der Auftrag fräst eine Lücke"),
    ("stock in spaces {n} to {n}", "Aufmaß in den Lücken {} bis {}"),
    ("{n} of {n} places", "{} von {} Stellen"),
    (
        "a cutter digs in at {n} rays, deeper than they begin",
        "ein Fräser dringt an {} Strahlen tiefer ein, als sie beginnen",
    ),
    ("{n} rays are not met by a cutter", "{} Strahlen trifft kein Fräser"),
    (
        "the cutter digs into the {} at {n} places, deeper than the rays begin",
        "der Fräser dringt ({}) an {} Stellen tiefer ein, als die Strahlen beginnen",
    ),
    ("{n} places of the {} are not reached by the cutter", "{} Stellen ({}) erreicht der Fräser nicht"),
    (
        "the {} deviates by {n} µm, the tolerance is {n} µm",
        "die {} weicht um {} µm ab, die Toleranz ist {} µm",
    ),
    (
        "lay more rows and columns, or allow a larger tolerance",
        "mehr Zeilen und Spalten legen oder eine größere Toleranz zulassen",
    ),
    (
        "lengthen the overrun, or check tilt and contact heights",
        "den Überlauf verlängern oder Neigung und Berührhöhen prüfen",
    ),
    (
        "check tilt and contact heights, or take a thinner cutter",
        "Neigung und Berührhöhen prüfen oder einen dünneren Fräser nehmen",
    ),
    (
        "lay more columns, another contact_height or a smaller tilt, or widen the tolerance",
        "mehr Spalten, eine andere contact_height oder eine kleinere Neigung nehmen oder die Toleranz erweitern",
    ),
    ("{n} µm too deep at most, stock up to {n} µm", "höchstens {} µm zu tief, Aufmaß bis zu {} µm"),
    ("no cutter enters it under {n} rays", "kein Fräser dringt unter {} Strahlen ein"),
    ("{n} mm too deep, space {n}", "{} mm zu tief, Lücke {}"),
    (
        "nothing is predicted between fewer than four columns",
        "zwischen weniger als vier Spalten wird nichts vorhergesagt",
    ),
    (
        "up to {n} mm stay unmilled: the cutter meets the other half there",
        "bis zu {} mm bleiben ungefräst: Der Fräser trifft dort die andere Hälfte",
    ),
    ("{} in the middle of the gear", "{} in der Mitte des Zahnrads"),
    ("flanks of the first space", "Flanken der ersten Lücke"),
    ("{n} µm from those of the plan", "{} µm von denen des Plans"),
    ("whole part and rapid moves", "ganzes Teil und Eilgänge"),
    ("{n} spaces under {n} rays, {n} rapid moves", "{} Lücken unter {} Strahlen, {} Eilgänge"),
    ("tool, holder and spindle against the clamping", "Werkzeug, Halter und Spindel gegen die Spannung"),
    ("{n} mm to {} or more", "mindestens {} mm bis {}"),
    ("flank that the mate needs", "Flanke, die das Gegenrad braucht"),
    ("backs of the blades", "Rücken der Schaufeln"),
    ("shank, holder and spindle in the ring", "Schaft, Halter und Spindel im Ring"),
    ("left flank, which stays as it is", "linke Flanke, die bleibt, wie sie ist"),
    ("right flank, which stays as it is", "rechte Flanke, die bleibt, wie sie ist"),
    (
        "the plan keeps clear of them; a ray would come out on the other side",
        "der Plan hält Abstand von ihnen; ein Strahl käme auf der anderen Seite heraus",
    ),
    (
        "the cutters dig into the drawn {} at {n} of its {n} places",
        "die Fräser dringen in die gezeichnete Form ein ({}): an {} von {} Stellen",
    ),
    (
        "{n} of {n} places of the drawn {} are not reached by the cutters",
        "{} von {} Stellen der gezeichneten Form erreichen die Fräser nicht ({})",
    ),
    (
        "take smaller contact heights or a thinner cutter, or draw the root deeper",
        "kleinere Berührhöhen oder einen dünneren Fräser nehmen oder den Fuß tiefer zeichnen",
    ),
    (
        "lengthen the overrun, or give another cutter for the bottom",
        "den Überlauf verlängern oder einen anderen Fräser für den Grund angeben",
    ),
    (
        "lower the contact heights, take a thinner or shorter cutter, or tilt it more",
        "die Berührhöhen senken, einen dünneren oder kürzeren Fräser nehmen oder ihn stärker neigen",
    ),
    // Skiving.
    ("the tool", "das Werkzeug"),
    (
        "nothing is measured: tracks, poses and the ideal edges are judged",
        "nichts ist gemessen: Spuren, Lagen und die idealen Schneiden sind beurteilt",
    ),
    ("the tracks lie on the flanks' edges", "die Spuren liegen auf den Flankenschneiden"),
    ("the profile is judged for a feed of nothing", "das Profil ist für einen Vorschub null beurteilt"),
    ("poses and turns", "Lagen und Drehungen"),
    ("coupling, law and flank", "Kopplung, Gesetz und Flanke"),
    ("ball and flanks", "Kugel und Flanken"),
    ("ways and switches", "Wege und Schaltstellen"),
    (
        "every measured point within its limits, from the text",
        "jeder Messpunkt innerhalb seiner Grenzen, aus dem Text",
    ),
    ("moves of the programs between the recordings", "Wege der Programme zwischen den Aufnahmen"),
    (
        "retreats and rapids are laid past the beam, and their text is not judged; the first rapid comes from wherever the axes stand",
        "Rückzüge und Eilgänge führen am Strahl vorbei, und ihr Text ist nicht beurteilt; der erste Eilgang kommt von dort, wo die Achsen stehen",
    ),
    (
        "light barrier, holder and spindle have no bodies; poses are checked against the flanks of the tool",
        "Lichtschranke, Halter und Spindel haben keine Körper; Lagen sind gegen die Flanken des Werkzeugs geprüft",
    ),
    (
        "{n} of {n} µm missing on the deepest track in the mean, guard band {n} µm",
        "im Mittel fehlen auf der tiefsten Spur {} von {} µm, Sicherheitsband {} µm",
    ),
    (
        "the tool is worn ({} flank): {n} µm are missing on a track in the mean, {n} µm are allowed",
        "das Werkzeug ist verschlissen (Flanke: {}): Im Mittel fehlen auf einer Spur {} µm, zulässig sind {} µm",
    ),
    (
        "grind the tool again; resharpening.csv tells how deep, with and without broken edges",
        "das Werkzeug nachschleifen; resharpening.csv sagt, wie tief, mit und ohne gebrochene Schneiden",
    ),
    (
        "{n} of {n} µm off the compensation curve (tooth {n}), guard band {n} µm",
        "{} von {} µm neben der Ausgleichskurve (Zahn {}), Sicherheitsband {} µm",
    ),
    (
        "1 edge beyond the limit by less than the guard band",
        "1 Schneide um weniger als das Sicherheitsband jenseits der Grenze",
    ),
    (
        "{n} edges beyond the limit by less than the guard band",
        "{} Schneiden um weniger als das Sicherheitsband jenseits der Grenze",
    ),
    (
        "1 edge of the {} flank leaves the band of {n} µm by more than the measurement scatters ({n} µm), most of all that of tooth {n} ({n} µm off the curve)",
        "1 Schneide (Flanke: {}) verlässt das Band von {} µm um mehr, als die Messung streut ({} µm), am weitesten die von Zahn {} ({} µm neben der Kurve)",
    ),
    (
        "{n} edges of the {} flank leave the band of {n} µm by more than the measurement scatters ({n} µm), most of all that of tooth {n} ({n} µm off the curve)",
        "{} Schneiden (Flanke: {}) verlassen das Band von {} µm um mehr, als die Messung streut ({} µm), am weitesten die von Zahn {} ({} µm neben der Kurve)",
    ),
    (
        "look at these teeth for chips and built-up edges, and measure again",
        "diese Zähne auf Ausbrüche und Aufbauschneiden ansehen und neu messen",
    ),
    (
        "{n} of {n} µm by the mean of the whole teeth, guard band {n} µm",
        "{} von {} µm nach dem Mittel der ganzen Zähne, Sicherheitsband {} µm",
    ),
    ("run-out correction", "Rundlaufkorrektur"),
    ("setting by the measured workpiece", "Einstellung nach dem gemessenen Werkstück"),
    ("prediction within {n} µm of the simulation", "Vorhersage auf {} µm bei der Simulation"),
    (
        "correct a smaller error at a time, or widen the tolerance",
        "weniger Fehler auf einmal korrigieren oder die Toleranz weiten",
    ),
    (
        "prediction and simulation of the {} differ by {n} µm, more than a tenth of the tolerance of {n} µm",
        "Vorhersage und Simulation ({}) unterscheiden sich um {} µm, mehr als ein Zehntel der Toleranz von {} µm",
    ),
    (
        "check the tool against the workpiece: another part of its edge may cut the flank; widen the tolerance, or lay no track on the corner of a relief",
        "das Werkzeug gegen das Werkstück prüfen: Ein anderer Teil seiner Schneide kann die Flanke schneiden; die Toleranz erweitern oder keine Spur auf die Ecke einer Rücknahme legen",
    ),
    (
        "the profile will deviate by {n} µm, the tolerance is {n} µm",
        "das Profil wird um {} µm abweichen, die Toleranz ist {} µm",
    ),
    (
        "apply the correction of the setting: {n} µm remain",
        "die Korrektur der Einstellung anwenden: {} µm bleiben",
    ),
    (
        "apply the correction of the setting ({n} µm remain), or grind the tool again",
        "die Korrektur der Einstellung anwenden ({} µm bleiben) oder das Werkzeug nachschleifen",
    ),
    (
        "check the tool against the workpiece: another part of its edge cuts the flank",
        "das Werkzeug gegen das Werkstück prüfen: Ein anderer Teil seiner Schneide schneidet die Flanke",
    ),
    (
        "{}; it lies beyond its limit by less than the measurement scatters, so that it is neither within nor beyond",
        "{}; es liegt um weniger, als die Messung streut, jenseits der Grenze und ist damit weder innerhalb noch außerhalb",
    ),
    (
        "it lies beyond its limit by less than the measurement scatters, so that it is neither within nor beyond",
        "es liegt um weniger, als die Messung streut, jenseits der Grenze und ist damit weder innerhalb noch außerhalb",
    ),
    (
        "measure more revolutions, at a lower speed, or in both senses: the guard band of {n} µm shrinks with the root of their number",
        "mehr Umdrehungen, langsamer oder in beiden Drehsinnen messen: Das Sicherheitsband von {} µm schrumpft mit der Wurzel ihrer Zahl",
    ),
    ("mounting and correction", "Aufspannung und Korrektur"),
    ("teeth without a switch: {}", "Zähne ohne Schaltpunkt: {}"),
    ("1 tooth", "1 Zahn"),
    ("{n} teeth", "{} Zähne"),
    (
        "{n} of {} did not switch the light barrier on every track: {}",
        "{} von {} schalteten die Lichtschranke nicht auf jeder Spur: {}",
    ),
    (
        "look whether these teeth are broken off, else measure again",
        "nachsehen, ob diese Zähne abgebrochen sind, sonst neu messen",
    ),
    (
        "tooth {n} stands out and does not count for clocking, means, mounting and correction",
        "Zahn {} fällt heraus und zählt nicht für Drehlage, Mittel, Aufspannung und Korrektur",
    ),
    (
        "teeth {} stand out and do not count for clocking, means, mounting and correction",
        "die Zähne {} fallen heraus und zählen nicht für Drehlage, Mittel, Aufspannung und Korrektur",
    ),
    ("look there for chips and built-up edges", "dort nach Ausbrüchen und Aufbauschneiden sehen"),
    ("the correction ends at the limit of {}", "die Korrektur endet an der Grenze von {}"),
    (
        "leave out of `evaluation.settings` what gains little there, or widen `evaluation.limits`",
        "aus `evaluation.settings` weglassen, was dort wenig bringt, oder `evaluation.limits` erweitern",
    ),
    (
        "the chip of tooth {n} ({} edge, {n} µm missing) asks for at least {n} µm off the rake faces; the edges that are not broken ask for {n} µm",
        "der Ausbruch an Zahn {} (Schneide: {}, {} µm fehlen) verlangt mindestens {} µm Abtrag an den Spanflächen; die heilen Schneiden verlangen {} µm",
    ),
    (
        "look how far the chips reach down the clearance faces before grinding; or grind for the whole edges and leave the chips",
        "vor dem Schleifen ansehen, wie weit die Ausbrüche die Freiflächen hinabreichen; oder für die heilen Schneiden schleifen und die Ausbrüche lassen",
    ),
    (
        "the depth of resharpening does not count tooth {n}: without all switches it is not known how deep they are broken",
        "die Nachschlifftiefe zählt Zahn {} nicht: Ohne alle Schaltpunkte ist nicht bekannt, wie tief er gebrochen ist",
    ),
    (
        "the depth of resharpening does not count teeth {}: without all switches it is not known how deep they are broken",
        "die Nachschlifftiefe zählt die Zähne {} nicht: Ohne alle Schaltpunkte ist nicht bekannt, wie tief sie gebrochen sind",
    ),
    (
        "measure these breaks another way, or leave these teeth broken",
        "diese Brüche anders messen oder diese Zähne gebrochen lassen",
    ),
    (
        "one track tells pitch and eccentricity, but little of the profile",
        "eine Spur sagt Teilung und Exzentrizität, aber wenig vom Profil",
    ),
    (
        "{n} tracks tell pitch and eccentricity, but little of the profile",
        "{} Spuren sagen Teilung und Exzentrizität, aber wenig vom Profil",
    ),
    ("measure five tracks or more", "fünf Spuren oder mehr messen"),
    (
        "the tracks do not tell the wobble of this tool from its eccentricity",
        "die Spuren trennen den Taumel dieses Werkzeugs nicht von seiner Exzentrizität",
    ),
    (
        "take the wobble as unknown, or measure it at the shank",
        "den Taumel als unbekannt nehmen oder am Schaft messen",
    ),
    (
        "in one sense the delay of the barrier shifts the clocking of the tool by {n} deg",
        "in einem Drehsinn verschiebt die Verzögerung der Schranke die Drehlage des Werkzeugs um {} deg",
    ),
    (
        "measure in both senses, or do not use the clocking",
        "in beiden Drehsinnen messen oder die Drehlage nicht verwenden",
    ),
    (
        "the last measurement lies off the line of wear ({} flank)",
        "die letzte Messung liegt neben der Verschleißgeraden (Flanke: {})",
    ),
    (
        "do not rely on the forecast: measure again soon",
        "sich nicht auf die Vorhersage verlassen: bald wieder messen",
    ),
    // Electronic gearbox.
    ("no alarm", "kein Alarm"),
    ("{n} of {n} keep to {n} µm", "{} von {} halten {} µm ein"),
    ("{n} N m at most", "höchstens {} N m"),
    ("limits of the error budget", "Grenzen des Fehlerbudgets"),
    (
        "the rotation misses the lead by {n} µm at the flank, {n} µm are allowed",
        "die Drehung verfehlt die Steigung an der Flanke um {} µm, zulässig sind {} µm",
    ),
    (
        "take a finer scale, more pulses per interval or mode = \"no-backlash\", start and stop outside the gear or accelerate more slowly, or allow more",
        "einen feineren Maßstab, mehr Impulse je Intervall oder mode = \"no-backlash\" nehmen, außerhalb des Zahnrads anfahren und halten oder langsamer beschleunigen oder mehr zulassen",
    ),
    (
        "the workpiece misses its angle by {n} µm at the flank, {n} µm are allowed",
        "das Werkstück verfehlt seinen Winkel an der Flanke um {} µm, zulässig sind {} µm",
    ),
    (
        "accelerate more slowly, take a larger bandwidth, a stronger motor or a finer encoder, or allow more",
        "langsamer beschleunigen, eine größere Bandbreite, einen stärkeren Motor oder einen feineren Geber nehmen oder mehr zulassen",
    ),
    (
        "the run ends while {n} corrections are still owed",
        "der Lauf endet, während noch {} Korrekturen ausstehen",
    ),
    (
        "let it end later: a longer `rest_s` or a later `last_tick`",
        "später enden lassen: längeres `rest_s` oder späteres `last_tick`",
    ),
    (
        "in mode one-way both senses of the feed differ by {n} µm at the flank",
        "in der Betriebsart one-way unterscheiden sich die beiden Vorschubsinne an der Flanke um {} µm",
    ),
    (
        "take mode = \"no-backlash\", or grind in one sense only",
        "mode = \"no-backlash\" nehmen oder nur in einem Sinn schleifen",
    ),
    (
        "the motor is at its greatest torque in {n} % of the samples",
        "der Motor ist in {} % der Abtastwerte an seinem größten Moment",
    ),
    (
        "accelerate more slowly, or take a stronger motor or a smaller bandwidth",
        "langsamer beschleunigen oder einen stärkeren Motor oder eine kleinere Bandbreite nehmen",
    ),
    // Measured gears.
    ("measured gear", "gemessenes Zahnrad"),
    ("bands", "Bänder"),
    (
        "neither a job nor a class of ISO 1328-1 was given",
        "weder ein Auftrag noch eine Klasse der ISO 1328-1 wurde angegeben",
    ),
    (
        "its diameter over balls and thickness were not measured",
        "Kugelmaß und Zahndicke wurden nicht gemessen",
    ),
    (
        "{n} warnings of reading say that values of the file were lost",
        "{} Hinweise beim Lesen sagen, dass Werte der Datei verloren gingen",
    ),
    ("lost values", "verlorene Werte"),
    ("look at the warnings; export the file again", "die Hinweise ansehen; die Datei neu ausgeben"),
    (
        "the {} was measured {n} µm off its target (tolerance {n} µm)",
        "die {} liegt nach der Messung {} µm neben dem Soll (Toleranz {} µm)",
    ),
    ("{}: total deviation {n} µm (tolerance {n} µm)", "{}: Gesamtabweichung {} µm (Toleranz {} µm)"),
    ("{n} of {n} traces lie outside their band", "{} von {} Linien liegen außerhalb ihres Bands"),
    ("left flank as a surface", "linke Flanke als Fläche"),
    ("right flank as a surface", "rechte Flanke als Fläche"),
    ("the job does not ask for it", "der Auftrag verlangt es nicht"),
    ("{}: {} is {n} µm, {} allows {n} µm", "{}: {} ist {} µm, {} lässt {} µm zu"),
    (
        "see the sheet for the traces; give the job by which the gear was ground to find which settings correct it",
        "die Linien auf dem Messblatt ansehen; den Auftrag angeben, nach dem das Rad geschliffen wurde, um die korrigierenden Einstellungen zu finden",
    ),
    (
        "tooth {n} of the {} differs from what all share by {n} µm",
        "Zahn {} ({}) weicht um {} µm von dem ab, was alle gemeinsam haben",
    ),
    ("look at that tooth, and measure it again", "diesen Zahn ansehen und neu messen"),
    (
        "profiles and helix traces of the {} disagree by {n} µm where they cross",
        "Profile und Flankenlinien ({}) widersprechen sich am Kreuzungspunkt um {} µm",
    ),
    (
        "look for burrs and dust at the crossings, and measure again",
        "an den Kreuzungen nach Grat und Staub sehen und neu messen",
    ),
    (
        "the surface of the {} goes {n} % of the field beyond the outermost lines, by {}",
        "die Fläche ({}) geht {} % des Felds über die äußersten Linien hinaus, längs {}",
    ),
    ("measure lines nearer to the ends of the field", "Linien näher an den Enden des Felds messen"),
    ("evaluated in the range of the job: {}", "im Bereich des Auftrags ausgewertet: {}"),
    (
        "set `gear.evaluation` of the job to what is to be judged",
        "`gear.evaluation` des Auftrags auf das setzen, was beurteilt werden soll",
    ),
    ("look at the file, or measure again", "die Datei ansehen oder neu messen"),
    (
        "compare with the drawing and with another measurement",
        "mit der Zeichnung und mit einer anderen Messung vergleichen",
    ),
    (
        "see the sheet of the part, and the trends of these characteristics",
        "das Messblatt des Teils und die Trends dieser Merkmale ansehen",
    ),
    ("beyond their limits: {}", "außerhalb ihrer Grenzen: {}"),
    ("line {n}: {}", "Zeile {}: {}"),
];
