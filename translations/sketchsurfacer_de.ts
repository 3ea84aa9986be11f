<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ductus::AmbiguityPresenter</name>
    <message>
        <source>What the sketch leaves open</source>
        <translation>Was die Skizze offenlässt</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>eindeutig</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>Looking for other readings</source>
        <translation>Suche nach anderen Deutungen</translation>
    </message>
</context>
<context>
    <name>ductus::ExportDialog</name>
    <message>
        <source>OBJ - with regions as groups</source>
        <translation>OBJ - mit Regionen als Gruppen</translation>
    </message>
    <message>
        <source>PLY - with region numbers</source>
        <translation>PLY - mit Regionsnummern</translation>
    </message>
    <message>
        <source>STL - for printing</source>
        <translation>STL - zum Drucken</translation>
    </message>
    <message>
        <source>GLB - for the web and game engines</source>
        <translation>GLB - für Web und Spiele-Engines</translation>
    </message>
    <message>
        <source>OFF - plain</source>
        <translation>OFF - schlicht</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Fläche exportieren</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Keep &amp;regions apart</source>
        <translation>&amp;Regionen getrennt lassen</translation>
    </message>
    <message>
        <source>Add &amp;creases as lines</source>
        <translation>&amp;Knicke als Linien hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Einheit</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>E&amp;xportieren...</translation>
    </message>
    <message>
        <source>GLB is always in metres.</source>
        <translation>GLB ist immer in Metern.</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 in the file, %4 triangles, about %5</source>
        <translation>%1 × %2 × %3 in der Datei, %4 Dreiecke, etwa %5</translation>
    </message>
</context>
<context>
    <name>ductus::MeasuresPanel</name>
    <message>
        <source>metre</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>decimetre</source>
        <translation>Dezimeter</translation>
    </message>
    <message>
        <source>centimetre</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Half of the strokes&apos; points lie nearer to the surface than this; in brackets: 95 %.</source>
        <translation>Die Hälfte der Strichpunkte liegt näher an der Fläche; in Klammern: 95 %.</translation>
    </message>
    <message>
        <source>Unit of the sketch</source>
        <translation>Einheit der Skizze</translation>
    </message>
    <message>
        <source>What the number 1 of the sketch&apos;s file means. Nothing is scaled.</source>
        <translation>Was die Zahl 1 in der Datei der Skizze bedeutet. Skaliert wird nichts.</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Hochachse</translation>
    </message>
    <message>
        <source>y is up</source>
        <translation>y nach oben</translation>
    </message>
    <message>
        <source>z is up</source>
        <translation>z nach oben</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Off the strokes</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Flächeninhalt</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Watertight</source>
        <translation>Wasserdicht</translation>
    </message>
    <message>
        <source>&amp;One unit is a</source>
        <translation>&amp;Eine Einheit ist ein</translation>
    </message>
    <message>
        <source>Ax&amp;es</source>
        <translation>&amp;Achsen</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no, it has a border</source>
        <translation>nein, sie hat einen Rand</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
    <message>
        <source>%1 m³</source>
        <translation>%1 m³</translation>
    </message>
</context>
<context>
    <name>ductus::ParameterPanel</name>
    <message>
        <source>Tightness</source>
        <translation>Straffheit</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How closely the first rough skin (the proxy) wraps the strokes: tight finds handles and holes, loose bridges gaps. Technically: alpha of the wrap.</source>
        <translation>Wie eng die erste grobe Hülle (der Proxy) um die Striche liegt: straff findet Griffe und Löcher, locker überbrückt Lücken. Technisch: Alpha der Hülle.</translation>
    </message>
    <message>
        <source>loose</source>
        <translation>locker</translation>
    </message>
    <message>
        <source>tight</source>
        <translation>straff</translation>
    </message>
    <message>
        <source>Choose tightness by itself</source>
        <translation>Straffheit automatisch wählen</translation>
    </message>
    <message>
        <source>Takes the tightest skin that does not fall in between the strokes.</source>
        <translation>Nimmt die straffste Hülle, die nicht zwischen die Striche einfällt.</translation>
    </message>
    <message>
        <source>Looseness</source>
        <translation>Spielraum</translation>
    </message>
    <message>
        <source>How far the surface may stay away from the strokes. Raise it for wobbly sketches. Technically: epsilon, in percent of the sketch&apos;s diagonal.</source>
        <translation>Wie weit die Fläche von den Strichen abweichen darf. Für zittrige Skizzen erhöhen. Technisch: Epsilon, in Prozent der Diagonale der Skizze.</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>Simplicity</source>
        <translation>Einfachheit</translation>
    </message>
    <message>
        <source>How much few and simple surfaces are preferred to many. Technically: the weight of the label costs, w_simplicity, as a multiple of its default.</source>
        <translation>Wie sehr wenige, einfache Flächen vielen vorgezogen werden. Technisch: das Gewicht der Label-Kosten, w_simplicity, als Vielfaches des Standardwerts.</translation>
    </message>
    <message>
        <source>detailed</source>
        <translation>detailliert</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>einfach</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Only one half is solved and mirrored, welded exactly in the plane.</source>
        <translation>Nur eine Hälfte wird berechnet und gespiegelt, in der Symmetrieebene exakt verschweißt.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Find it</source>
        <translation>Selbst finden</translation>
    </message>
    <message>
        <source>Mirror left–right (x)</source>
        <translation>Links–rechts spiegeln (x)</translation>
    </message>
    <message>
        <source>Mirror along y</source>
        <translation>Entlang y spiegeln</translation>
    </message>
    <message>
        <source>Mirror along z</source>
        <translation>Entlang z spiegeln</translation>
    </message>
    <message>
        <source>S&amp;ymmetry</source>
        <translation>&amp;Symmetrie</translation>
    </message>
    <message>
        <source>Change tightness</source>
        <translation>Straffheit ändern</translation>
    </message>
    <message>
        <source>Change looseness</source>
        <translation>Spielraum ändern</translation>
    </message>
    <message>
        <source>Change simplicity</source>
        <translation>Einfachheit ändern</translation>
    </message>
    <message>
        <source>Change symmetry</source>
        <translation>Symmetrie ändern</translation>
    </message>
    <message>
        <source>Found: %1 % of the strokes mirror, %2 apart.</source>
        <translation>Gefunden: %1 % der Striche spiegeln sich, Abstand %2.</translation>
    </message>
    <message>
        <source>None was found.</source>
        <translation>Es wurde keine gefunden.</translation>
    </message>
    <message>
        <source>A plane of its own</source>
        <translation>Eine eigene Spiegelebene</translation>
    </message>
</context>
<context>
    <name>ductus::PrintFindings</name>
    <message>
        <source>Watertight, in one piece.</source>
        <translation>Wasserdicht, aus einem Stück.</translation>
    </message>
    <message numerus="yes">
        <source>Watertight, in %n pieces.</source>
        <translation>
            <numerusform>Wasserdicht, aus %n Stück.</numerusform>
            <numerusform>Wasserdicht, aus %n Stücken.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not watertight: the surface ends at a border. A printer needs a closed shape, or a sheet that is given a thickness elsewhere.</source>
        <translation>Nicht wasserdicht: Die Fläche endet an einem Rand. Ein Drucker braucht eine geschlossene Form oder ein Blatt, das anderswo eine Dicke bekommt.</translation>
    </message>
    <message>
        <source>ends here</source>
        <translation>endet hier</translation>
    </message>
    <message>
        <source>Thinnest wall %1: less than one line of the nozzle, it will be missing. %2 of the surface is as thin.</source>
        <translation>Dünnste Wand %1: weniger als eine Düsenlinie, sie wird fehlen. %2 der Fläche sind so dünn.</translation>
    </message>
    <message>
        <source>Thinnest wall %1: less than two lines of the nozzle, it breaks easily. %2 of the surface is as thin.</source>
        <translation>Dünnste Wand %1: weniger als zwei Düsenlinien, sie bricht leicht. %2 der Fläche sind so dünn.</translation>
    </message>
    <message>
        <source>Thinnest wall %1.</source>
        <translation>Dünnste Wand %1.</translation>
    </message>
    <message>
        <source>Narrowest gap %1: less than one line of the nozzle, it will grow shut.</source>
        <translation>Engster Spalt %1: weniger als eine Düsenlinie, er wächst zu.</translation>
    </message>
    <message>
        <source>Narrowest gap %1.</source>
        <translation>Engster Spalt %1.</translation>
    </message>
    <message>
        <source>Nowhere runs through itself.</source>
        <translation>Durchdringt sich nirgends.</translation>
    </message>
    <message>
        <source>Runs through itself: slicers may leave holes there.</source>
        <translation>Durchdringt sich selbst: Slicer lassen dort vielleicht Löcher.</translation>
    </message>
    <message>
        <source>runs through itself</source>
        <translation>durchdringt sich</translation>
    </message>
    <message>
        <source>Pieces overlap: most slicers join them to one.</source>
        <translation>Stücke überlappen: Die meisten Slicer vereinen sie.</translation>
    </message>
    <message>
        <source>pieces overlap</source>
        <translation>Stücke überlappen</translation>
    </message>
    <message>
        <source>Less than 1 %</source>
        <translation>Weniger als 1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>ductus::PrintPanel</name>
    <message>
        <source>Longest side of the print</source>
        <translation>Längste Seite des Drucks</translation>
    </message>
    <message>
        <source>How long the longest side is to be on the printer. Nothing is scaled; the check asks what would be too thin at that size.</source>
        <translation>Wie lang die längste Seite gedruckt sein soll. Skaliert wird nichts; geprüft wird, was bei dieser Größe zu dünn wäre.</translation>
    </message>
    <message>
        <source>Width of a line of the nozzle</source>
        <translation>Breite einer Düsenlinie</translation>
    </message>
    <message>
        <source>The width of the lines the printer lays; 0.4 mm is usual.</source>
        <translation>Die Breite der Linien, die der Drucker legt; üblich sind 0,4 mm.</translation>
    </message>
    <message>
        <source>Lon&amp;gest side</source>
        <translation>&amp;Längste Seite</translation>
    </message>
    <message>
        <source>&amp;Nozzle</source>
        <translation>&amp;Düse</translation>
    </message>
    <message>
        <source>Checking the print</source>
        <translation>Druckprüfung</translation>
    </message>
    <message>
        <source>Looking at walls and gaps...</source>
        <translation>Wände und Spalte werden geprüft...</translation>
    </message>
    <message>
        <source>Surface the sketch to see whether it can be printed.</source>
        <translation>Erzeugen Sie die Fläche, um zu sehen, ob sie sich drucken lässt.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show: %1</source>
        <translation>Zeigen: %1</translation>
    </message>
    <message>
        <source>Turns the view to the place and marks it; Esc takes the mark away.</source>
        <translation>Dreht die Ansicht zur Stelle und markiert sie; Esc nimmt die Markierung weg.</translation>
    </message>
</context>
<context>
    <name>ductus::ReadingList</name>
    <message>
        <source>&amp;Look for other readings</source>
        <translation>&amp;Andere Deutungen suchen</translation>
    </message>
    <message>
        <source>Colours where the strokes allow more than one surface, and offers the others (A).</source>
        <translation>Färbt, wo die Striche mehr als eine Fläche zulassen, und bietet die anderen an (A).</translation>
    </message>
    <message>
        <source>Where strokes are few, they allow more than one surface.</source>
        <translation>Wo Striche selten sind, lassen sie mehr als eine Fläche zu.</translation>
    </message>
    <message>
        <source>Trying what else the strokes could mean...</source>
        <translation>Was könnten die Striche noch bedeuten...</translation>
    </message>
    <message>
        <source>Surface the sketch to see what it leaves open.</source>
        <translation>Erzeugen Sie die Fläche, um zu sehen, was die Skizze offenlässt.</translation>
    </message>
    <message>
        <source>The strokes say enough: no other surface is nearly as likely.</source>
        <translation>Die Striche sagen genug: Keine andere Fläche ist annähernd so wahrscheinlich.</translation>
    </message>
    <message>
        <source>The strokes could also mean this. Choose one, or draw a stroke where the surface is coloured.</source>
        <translation>Die Striche könnten auch dies bedeuten. Wählen Sie eine Fläche oder zeichnen Sie einen Strich, wo sie gefärbt ist.</translation>
    </message>
    <message numerus="yes">
        <source>%n regions</source>
        <translation>
            <numerusform>%n Region</numerusform>
            <numerusform>%n Regionen</numerusform>
        </translation>
    </message>
    <message>
        <source>as likely</source>
        <translation>ebenso wahrscheinlich</translation>
    </message>
    <message>
        <source>nearly as likely</source>
        <translation>fast so wahrscheinlich</translation>
    </message>
    <message>
        <source>less likely</source>
        <translation>weniger wahrscheinlich</translation>
    </message>
    <message>
        <source>Other reading %1: %2, %3</source>
        <translation>Andere Deutung %1: %2, %3</translation>
    </message>
    <message>
        <source>Takes this surface instead. Undo brings the present one back.</source>
        <translation>Nimmt stattdessen diese Fläche. Rückgängig holt die jetzige zurück.</translation>
    </message>
</context>
<context>
    <name>ductus::RegionList</name>
    <message>
        <source>plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>quadric</source>
        <translation>Quadrik</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>Kubik</translation>
    </message>
    <message>
        <source>quartic</source>
        <translation>Quartik</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>The regions appear here once the sketch is surfaced.</source>
        <translation>Die Regionen erscheinen hier, sobald die Fläche erzeugt ist.</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regionen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Mean distance of its strokes from the region.</source>
        <translation>Mittlerer Abstand ihrer Striche von der Region.</translation>
    </message>
    <message>
        <source>Press Enter or right-click to change a region&apos;s kind; the lock keeps it as it is.</source>
        <translation>Eingabetaste oder Rechtsklick ändert die Art einer Region; das Schloss lässt sie, wie sie ist.</translation>
    </message>
    <message>
        <source>Locked: stays as it is. Click to free it.</source>
        <translation>Gesperrt: bleibt, wie sie ist. Ein Klick gibt sie frei.</translation>
    </message>
    <message>
        <source>Click to keep this region as it is.</source>
        <translation>Klicken, damit diese Region bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Make it a %1</source>
        <translation>Ändern in: %1</translation>
    </message>
    <message>
        <source>Lock or free it</source>
        <translation>Sperren oder freigeben</translation>
    </message>
</context>
<context>
    <name>ductus::SketchDocument</name>
    <message>
        <source>Change role of strokes</source>
        <translation>Rolle von Strichen ändern</translation>
    </message>
    <message>
        <source>New region</source>
        <translation>Neue Region</translation>
    </message>
    <message>
        <source>Merge regions</source>
        <translation>Regionen vereinen</translation>
    </message>
    <message>
        <source>Draw seam</source>
        <translation>Naht zeichnen</translation>
    </message>
    <message>
        <source>Forbid seam</source>
        <translation>Naht verbieten</translation>
    </message>
    <message>
        <source>Split region</source>
        <translation>Region teilen</translation>
    </message>
    <message>
        <source>Lock region</source>
        <translation>Region sperren</translation>
    </message>
    <message>
        <source>Change surface kind</source>
        <translation>Flächenart ändern</translation>
    </message>
    <message>
        <source>Remove scribble</source>
        <translation>Kritzelei entfernen</translation>
    </message>
    <message>
        <source>Remove all scribbles</source>
        <translation>Alle Kritzeleien entfernen</translation>
    </message>
    <message>
        <source>Draw stroke</source>
        <translation>Strich zeichnen</translation>
    </message>
    <message>
        <source>Move stroke</source>
        <translation>Strich verschieben</translation>
    </message>
    <message numerus="yes">
        <source>Move %n strokes</source>
        <translation>
            <numerusform>%n Strich verschieben</numerusform>
            <numerusform>%n Striche verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Bend stroke</source>
        <translation>Strich biegen</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>Strich löschen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n strokes</source>
        <translation>
            <numerusform>%n Strich löschen</numerusform>
            <numerusform>%n Striche löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>Use proxy from file</source>
        <translation>Proxy aus Datei verwenden</translation>
    </message>
    <message>
        <source>Make proxy automatically</source>
        <translation>Proxy automatisch erzeugen</translation>
    </message>
    <message>
        <source>Change unit</source>
        <translation>Einheit ändern</translation>
    </message>
    <message>
        <source>Choose another surface</source>
        <translation>Andere Fläche wählen</translation>
    </message>
    <message>
        <source>Surface anew</source>
        <translation>Fläche neu erzeugen</translation>
    </message>
    <message>
        <source>Paste strokes</source>
        <translation>Striche einfügen</translation>
    </message>
</context>
<context>
    <name>ductus::SketchPresenter</name>
    <message>
        <source>Drawing the surface</source>
        <translation>Zeichnen der Fläche</translation>
    </message>
    <message>
        <source>Strokes to surface</source>
        <translation>Striche zur Fläche</translation>
    </message>
</context>
<context>
    <name>ductus::SketchView</name>
    <message>
        <source>Canvas</source>
        <translation>Zeichenfläche</translation>
    </message>
</context>
<context>
    <name>ductus::StrokePanel</name>
    <message>
        <source>on the surface</source>
        <translation>auf der Fläche</translation>
    </message>
    <message>
        <source>border of the surface</source>
        <translation>Rand der Fläche</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignoriert</translation>
    </message>
    <message>
        <source>inside, not used</source>
        <translation>innen, nicht verwendet</translation>
    </message>
    <message>
        <source>thin tube</source>
        <translation>dünne Röhre</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>With strokes chosen: what they are for. Otherwise: what the role brush paints.</source>
        <translation>Bei gewählten Strichen: wozu sie da sind. Sonst: was der Rollenpinsel malt.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Takes the chosen strokes out of the sketch (Del). Undo brings them back.</source>
        <translation>Nimmt die gewählten Striche aus der Skizze (Entf). Rückgängig holt sie zurück.</translation>
    </message>
    <message>
        <source>&amp;Role</source>
        <translation>&amp;Rolle</translation>
    </message>
    <message>
        <source>Mark as &amp;border</source>
        <translation>&amp;Als Rand markieren</translation>
    </message>
    <message>
        <source>Nobody marked these strokes; the surface ends along them because nothing lies beyond. Marked, they stay its border whatever else is drawn.</source>
        <translation>Niemand hat diese Striche markiert; die Fläche endet an ihnen, weil dahinter nichts liegt. Markiert bleiben sie ihr Rand, was auch gezeichnet wird.</translation>
    </message>
    <message numerus="yes">
        <source>Border found: the surface ends along %n strokes nobody marked.</source>
        <translation>
            <numerusform>Rand gefunden: Die Fläche endet an %n Strich, den niemand markiert hat.</numerusform>
            <numerusform>Rand gefunden: Die Fläche endet an %n Strichen, die niemand markiert hat.</numerusform>
        </translation>
    </message>
    <message>
        <source>No stroke chosen</source>
        <translation>Kein Strich gewählt</translation>
    </message>
    <message>
        <source>One stroke chosen</source>
        <translation>Ein Strich gewählt</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes chosen</source>
        <translation>
            <numerusform>%n Strich gewählt</numerusform>
            <numerusform>%n Striche gewählt</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SurfaceButton</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stops and keeps the last surface (Esc).</source>
        <translation>Hält an und behält die letzte Fläche (Esc).</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>&amp;Aktualisieren</translation>
    </message>
    <message>
        <source>&amp;Surface it</source>
        <translation>&amp;Fläche erzeugen</translation>
    </message>
    <message>
        <source>Finds the surface the strokes describe (Ctrl+Enter).</source>
        <translation>Findet die Fläche, die die Striche beschreiben (Strg+Eingabe).</translation>
    </message>
    <message>
        <source>Open a sketch or draw strokes first.</source>
        <translation>Öffnen Sie eine Skizze oder zeichnen Sie zuerst Striche.</translation>
    </message>
    <message numerus="yes">
        <source>Up to date: %n regions</source>
        <translation>
            <numerusform>Aktuell: %n Region</numerusform>
            <numerusform>Aktuell: %n Regionen</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 s</source>
        <translation>, %1 s</translation>
    </message>
    <message>
        <source>The surface is older than the sketch.</source>
        <translation>Die Fläche ist älter als die Skizze.</translation>
    </message>
    <message numerus="yes">
        <source>%n points, not surfaced yet.</source>
        <translation>
            <numerusform>%n Punkt, noch keine Fläche.</numerusform>
            <numerusform>%n Punkte, noch keine Fläche.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes, not surfaced yet.</source>
        <translation>
            <numerusform>%n Strich, noch keine Fläche.</numerusform>
            <numerusform>%n Striche, noch keine Fläche.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SurfacerWindow</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>&amp;New sketch</source>
        <translation>&amp;Neue Skizze</translation>
    </message>
    <message>
        <source>Begins with an empty canvas to draw on.</source>
        <translation>Beginnt mit einer leeren Zeichenfläche.</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Opens a project, or a sketch of another program.</source>
        <translation>Öffnet ein Projekt oder die Skizze eines anderen Programms.</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Startseite</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the sketch stays open.</source>
        <translation>Zeigt Beispiele und zuletzt geöffnete Dateien; die Skizze bleibt offen.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>S&amp;peichern</translation>
    </message>
    <message>
        <source>Saves sketch, decisions and surface.</source>
        <translation>Speichert Skizze, Entscheidungen und Fläche.</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>Saves under another name.</source>
        <translation>Speichert unter einem anderen Namen.</translation>
    </message>
    <message>
        <source>&amp;Export surface...</source>
        <translation>Fläche &amp;exportieren...</translation>
    </message>
    <message>
        <source>Writes OBJ, PLY, STL, GLB or OFF for other programs.</source>
        <translation>Schreibt OBJ, PLY, STL, GLB oder OFF für andere Programme.</translation>
    </message>
    <message>
        <source>Send to &amp;LayerPainter</source>
        <translation>&amp;An LayerPainter senden</translation>
    </message>
    <message>
        <source>Opens the project in LayerPainter, to paint on the surface.</source>
        <translation>Öffnet das Projekt in LayerPainter, um auf der Fläche zu malen.</translation>
    </message>
    <message>
        <source>Save p&amp;icture...</source>
        <translation>B&amp;ild speichern...</translation>
    </message>
    <message>
        <source>Writes what the canvas shows as a PNG file.</source>
        <translation>Schreibt, was die Zeichenfläche zeigt, als PNG-Datei.</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Save t&amp;urntable...</source>
        <translation>&amp;Drehansicht speichern...</translation>
    </message>
    <message>
        <source>Writes a round of 72 pictures into a folder, to be made a film of.</source>
        <translation>Schreibt eine Runde von 72 Bildern in einen Ordner, um daraus einen Film zu machen.</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Ordner für die Bilder</translation>
    </message>
    <message>
        <source>&amp;Paste sketch</source>
        <translation>&amp;Skizze einfügen</translation>
    </message>
    <message>
        <source>&amp;Delete strokes</source>
        <translation>Striche &amp;löschen</translation>
    </message>
    <message>
        <source>Takes the chosen strokes out of the sketch.</source>
        <translation>Nimmt die gewählten Striche aus der Skizze.</translation>
    </message>
    <message>
        <source>Choose &amp;all strokes</source>
        <translation>&amp;Alle Striche wählen</translation>
    </message>
    <message>
        <source>So that one act changes them all.</source>
        <translation>Damit eine Aktion alle ändert.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops what runs, forgets what was begun, goes back to the arrow.</source>
        <translation>Hält an, was läuft, vergisst Begonnenes, kehrt zum Pfeil zurück.</translation>
    </message>
    <message>
        <source>&amp;Surface it</source>
        <translation>Fläche &amp;erzeugen</translation>
    </message>
    <message>
        <source>Finds the surface the strokes describe.</source>
        <translation>Findet die Fläche, die die Striche beschreiben.</translation>
    </message>
    <message>
        <source>Surface a&amp;new</source>
        <translation>Fläche &amp;neu erzeugen</translation>
    </message>
    <message>
        <source>Forgets the way here: edited strokes are usually worked into the surface there is.</source>
        <translation>Vergisst den Weg hierher: Sonst werden geänderte Striche in die vorhandene Fläche eingearbeitet.</translation>
    </message>
    <message>
        <source>&amp;Update by itself</source>
        <translation>&amp;Selbsttätig aktualisieren</translation>
    </message>
    <message>
        <source>After a scribble or a moved slider the surface follows without a click.</source>
        <translation>Nach einer Kritzelei oder einem Regler folgt die Fläche ohne Klick.</translation>
    </message>
    <message>
        <source>Remove all s&amp;cribbles</source>
        <translation>&amp;Alle Kritzeleien entfernen</translation>
    </message>
    <message>
        <source>Back to the regions found automatically.</source>
        <translation>Zurück zu den automatisch gefundenen Regionen.</translation>
    </message>
    <message>
        <source>Use &amp;proxy from file...</source>
        <translation>&amp;Proxy aus Datei verwenden...</translation>
    </message>
    <message>
        <source>Takes a mesh made elsewhere as the rough skin the strokes are read on.</source>
        <translation>Nimmt ein anderswo erstelltes Netz als grobe Hülle, auf der die Striche gelesen werden.</translation>
    </message>
    <message>
        <source>Make proxy &amp;automatically</source>
        <translation>P&amp;roxy automatisch erzeugen</translation>
    </message>
    <message>
        <source>Forgets the mesh from a file.</source>
        <translation>Vergisst das Netz aus der Datei.</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>Drag turns the view, a click chooses a stroke or region.</source>
        <translation>Ziehen dreht die Ansicht, ein Klick wählt Strich oder Region.</translation>
    </message>
    <message>
        <source>&amp;Role brush</source>
        <translation>R&amp;ollenpinsel</translation>
    </message>
    <message>
        <source>Paint over strokes to say what they are: border, ignored, ...</source>
        <translation>Über Striche malen, um zu sagen, was sie sind: Rand, ignoriert, ...</translation>
    </message>
    <message>
        <source>&amp;Draw stroke</source>
        <translation>Strich &amp;zeichnen</translation>
    </message>
    <message>
        <source>Add the stroke that was missing; the surface follows.</source>
        <translation>Den fehlenden Strich ergänzen; die Fläche folgt.</translation>
    </message>
    <message>
        <source>&amp;New region</source>
        <translation>Neue &amp;Region</translation>
    </message>
    <message>
        <source>Yellow: what you scribble over becomes a surface of its own.</source>
        <translation>Gelb: Was Sie überkritzeln, wird eine eigene Fläche.</translation>
    </message>
    <message>
        <source>&amp;Merge regions</source>
        <translation>Regionen &amp;vereinen</translation>
    </message>
    <message>
        <source>Green: the regions you connect become one.</source>
        <translation>Grün: Die Regionen, die Sie verbinden, werden eine.</translation>
    </message>
    <message>
        <source>Red: a crease must run exactly here.</source>
        <translation>Rot: Genau hier muss ein Knick verlaufen.</translation>
    </message>
    <message>
        <source>S&amp;plit region</source>
        <translation>Region &amp;teilen</translation>
    </message>
    <message>
        <source>Orange: cuts a region in two along your line.</source>
        <translation>Orange: schneidet eine Region entlang Ihrer Linie in zwei.</translation>
    </message>
    <message>
        <source>&amp;Forbid seam</source>
        <translation>Na&amp;ht verbieten</translation>
    </message>
    <message>
        <source>Blue: no crease may run here.</source>
        <translation>Blau: Hier darf kein Knick verlaufen.</translation>
    </message>
    <message>
        <source>&amp;Lock region</source>
        <translation>Region &amp;sperren</translation>
    </message>
    <message>
        <source>A locked region stays as it is, whatever else changes.</source>
        <translation>Eine gesperrte Region bleibt, was sich auch sonst ändert.</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>The length between two points.</source>
        <translation>Die Länge zwischen zwei Punkten.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorne</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Three-&amp;quarter</source>
        <translation>&amp;Dreiviertel</translation>
    </message>
    <message>
        <source>Looks from there.</source>
        <translation>Blickt von dort.</translation>
    </message>
    <message>
        <source>Fr&amp;ame all</source>
        <translation>&amp;Alles einpassen</translation>
    </message>
    <message>
        <source>Brings the whole sketch into view.</source>
        <translation>Bringt die ganze Skizze ins Bild.</translation>
    </message>
    <message>
        <source>Comes nearer.</source>
        <translation>Geht näher heran.</translation>
    </message>
    <message>
        <source>Zoom o&amp;ut</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Steps back.</source>
        <translation>Tritt zurück.</translation>
    </message>
    <message>
        <source>Turn view (%1)</source>
        <translation>Ansicht drehen (%1)</translation>
    </message>
    <message>
        <source>Turns the view without a mouse.</source>
        <translation>Dreht die Ansicht ohne Maus.</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>Far things smaller; off for measuring by eye.</source>
        <translation>Fernes kleiner; ausgeschaltet zum Messen nach Augenmaß.</translation>
    </message>
    <message>
        <source>Shows the sketch on top of the surface.</source>
        <translation>Zeigt die Skizze über der Fläche.</translation>
    </message>
    <message>
        <source>Turns the view by itself, to look at it from all sides.</source>
        <translation>Dreht die Ansicht von selbst, um alles von allen Seiten zu sehen.</translation>
    </message>
    <message>
        <source>&amp;Mirror drawn strokes</source>
        <translation>&amp;Gezeichnete Striche spiegeln</translation>
    </message>
    <message>
        <source>Where the sketch is symmetric a stroke comes with its mirror image.</source>
        <translation>Wo die Skizze symmetrisch ist, entsteht ein Strich mit seinem Spiegelbild.</translation>
    </message>
    <message>
        <source>What the sketch leaves &amp;open</source>
        <translation>&amp;Was die Skizze offenlässt</translation>
    </message>
    <message>
        <source>Colours where the strokes allow more than one surface; a click there offers the others.</source>
        <translation>Färbt, wo die Striche mehr als eine Fläche zulassen; ein Klick bietet dort die anderen an.</translation>
    </message>
    <message>
        <source>&amp;Compare with the sketch</source>
        <translation>&amp;Mit der Skizze vergleichen</translation>
    </message>
    <message>
        <source>A line to drag: the sketch at its left, the surface at its right.</source>
        <translation>Eine Linie zum Ziehen: links die Skizze, rechts die Fläche.</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Fläche</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>SketchSurfacer</source>
        <translation>SketchSurfacer</translation>
    </message>
    <message>
        <source>From a 3D sketch to a surface you can print, render or take into CAD.</source>
        <translation>Von der 3D-Skizze zur Fläche zum Drucken, Rendern oder für CAD.</translation>
    </message>
    <message>
        <source>New sketch</source>
        <translation>Neue Skizze</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Öffnen...</translation>
    </message>
    <message>
        <source>Drop a sketch (.curves, .obj, .txt), points (.xyz), a proxy mesh or a project anywhere.</source>
        <translation>Ziehen Sie eine Skizze (.curves, .obj, .txt), Punkte (.xyz), ein Proxy-Netz oder ein Projekt irgendwohin.</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Sketches and projects (*.ductus *.curves *.obj *.txt *.xyz *.crv);;Proxy meshes (*.ply *.stl *.off *.glb *.obj);;All files (*)</source>
        <translation>Skizzen und Projekte (*.ductus *.curves *.obj *.txt *.xyz *.crv);;Proxy-Netze (*.ply *.stl *.off *.glb *.obj);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lesen von %1</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Öffnen von %1</translation>
    </message>
    <message>
        <source>The clipboard holds neither strokes nor a path to a file.</source>
        <translation>Die Zwischenablage enthält weder Striche noch einen Dateipfad.</translation>
    </message>
    <message>
        <source>Reading the clipboard</source>
        <translation>Lesen der Zwischenablage</translation>
    </message>
    <message>
        <source>Pasted</source>
        <translation>Eingefügt</translation>
    </message>
    <message numerus="yes">
        <source>These %n points do not follow one another: they are taken as points of the surface, and creases are found by its shape alone.</source>
        <translation>
            <numerusform>Dieser %n Punkt hat keine Folge: Er gilt als Punkt der Fläche, und Knicke werden allein an ihrer Form gefunden.</numerusform>
            <numerusform>Diese %n Punkte folgen nicht aufeinander: Sie gelten als Punkte der Fläche, und Knicke werden allein an ihrer Form gefunden.</numerusform>
        </translation>
    </message>
    <message>
        <source>A stroke looks like a cable and becomes a thin tube. If it is none, select it and set its role to “on the surface”.</source>
        <translation>Ein Strich sieht wie ein Kabel aus und wird eine dünne Röhre. Ist er keins, wählen Sie ihn und geben Sie ihm die Rolle „auf der Fläche“.</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes look like cables and become thin tubes. Where one is none, select it and set its role to “on the surface”.</source>
        <translation>
            <numerusform>%n Strich sieht wie ein Kabel aus und wird eine dünne Röhre. Ist er keins, wählen Sie ihn und geben Sie ihm die Rolle „auf der Fläche“.</numerusform>
            <numerusform>%n Striche sehen wie Kabel aus und werden dünne Röhren. Ist einer keins, wählen Sie ihn und geben Sie ihm die Rolle „auf der Fläche“.</numerusform>
        </translation>
    </message>
    <message>
        <source>Some of the sketch was skipped: %1</source>
        <translation>Ein Teil der Skizze wurde übergangen: %1</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Und %n weiteres.</numerusform>
            <numerusform>Und %n weitere.</numerusform>
        </translation>
    </message>
    <message>
        <source>A mesh serves as the proxy of a sketch. Open the sketch first, then the mesh.</source>
        <translation>Ein Netz dient als Proxy einer Skizze. Öffnen Sie zuerst die Skizze, dann das Netz.</translation>
    </message>
    <message>
        <source>Reading the proxy</source>
        <translation>Lesen des Proxys</translation>
    </message>
    <message>
        <source>%1 is the proxy now.</source>
        <translation>%1 ist jetzt der Proxy.</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Ductus projects (*.ductus)</source>
        <translation>Ductus-Projekte (*.ductus)</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Speichern unter...</translation>
    </message>
    <message>
        <source>LayerPainter paints on the surface, and there is none yet.</source>
        <translation>LayerPainter malt auf der Fläche, und es gibt noch keine.</translation>
    </message>
    <message>
        <source>Surface it</source>
        <translation>Fläche erzeugen</translation>
    </message>
    <message>
        <source>LayerPainter opens %1.</source>
        <translation>LayerPainter öffnet %1.</translation>
    </message>
    <message>
        <source>LayerPainter reads the saved project, and this one has changes.</source>
        <translation>LayerPainter liest das gespeicherte Projekt, und dieses hat Änderungen.</translation>
    </message>
    <message>
        <source>Save and send</source>
        <translation>Speichern und senden</translation>
    </message>
    <message>
        <source>Save as and send...</source>
        <translation>Speichern unter und senden...</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Fläche exportieren</translation>
    </message>
    <message>
        <source>Exporting the surface</source>
        <translation>Exportieren der Fläche</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Exportiert nach %1.</translation>
    </message>
    <message>
        <source>Writing the picture</source>
        <translation>Schreiben des Bildes</translation>
    </message>
    <message>
        <source>The picture is in %1.</source>
        <translation>Das Bild ist in %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures are in %1.</source>
        <translation>
            <numerusform>%n Bild ist in %1.</numerusform>
            <numerusform>%n Bilder sind in %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Skizze</translation>
    </message>
    <message>
        <source>The strokes alone.</source>
        <translation>Nur die Striche.</translation>
    </message>
    <message>
        <source>Proxy</source>
        <translation>Proxy</translation>
    </message>
    <message>
        <source>The rough skin the strokes are read on.</source>
        <translation>Die grobe Hülle, auf der die Striche gelesen werden.</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regionen</translation>
    </message>
    <message>
        <source>Which parts are one smooth surface each.</source>
        <translation>Welche Teile je eine glatte Fläche sind.</translation>
    </message>
    <message>
        <source>The finished surface in clay.</source>
        <translation>Die fertige Fläche in Ton.</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>How far strokes and surface are apart.</source>
        <translation>Wie weit Striche und Fläche auseinanderliegen.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Other readings</source>
        <translation>Andere Deutungen</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>Print check</source>
        <translation>Druckprüfung</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Install a graphics driver, or the software one: libgl1-mesa-dri.</source>
        <translation>Installieren Sie einen Grafiktreiber oder den Software-Treiber: libgl1-mesa-dri.</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>%1 % open</source>
        <translation>%1 % offen</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>Strich %1</translation>
    </message>
    <message>
        <source>border found</source>
        <translation>Rand gefunden</translation>
    </message>
    <message>
        <source>at most %1 off</source>
        <translation>höchstens %1 daneben</translation>
    </message>
    <message>
        <source>Surface the sketch first.</source>
        <translation>Erzeugen Sie zuerst die Fläche.</translation>
    </message>
    <message>
        <source>Nothing drawn yet. Press D and draw the first stroke, or drop a sketch here.</source>
        <translation>Noch nichts gezeichnet. Drücken Sie D und zeichnen Sie den ersten Strich, oder ziehen Sie eine Skizze hierher.</translation>
    </message>
    <message>
        <source>&amp;Copy strokes</source>
        <translation>Striche &amp;kopieren</translation>
    </message>
    <message>
        <source>Puts the chosen strokes, or all, on the clipboard, for the other apps of the suite as well.</source>
        <translation>Legt die gewählten Striche, oder alle, in die Zwischenablage, auch für die anderen Programme der Suite.</translation>
    </message>
    <message>
        <source>Adds strokes copied in this or another app of the suite, or opens text or a file.</source>
        <translation>Fügt Striche hinzu, die hier oder in einem anderen Programm der Suite kopiert wurden, oder öffnet Text oder eine Datei.</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes pasted.</source>
        <translation>
            <numerusform>%n Strich eingefügt.</numerusform>
            <numerusform>%n Striche eingefügt.</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no strokes to copy yet.</source>
        <translation>Es gibt noch keine Striche zum Kopieren.</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes copied.</source>
        <translation>
            <numerusform>%n Strich kopiert.</numerusform>
            <numerusform>%n Striche kopiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Se&amp;am</source>
        <translation>&amp;Naht</translation>
    </message>
    <message>
        <source>&amp;Zoom in</source>
        <translation>Ve&amp;rgrößern</translation>
    </message>
    <message>
        <source>St&amp;rokes on the surface</source>
        <translation>&amp;Striche auf der Fläche</translation>
    </message>
    <message>
        <source>&amp;Turntable</source>
        <translation>Dreha&amp;nsicht</translation>
    </message>
    <message>
        <source>Loo&amp;k from</source>
        <translation>&amp;Blick von</translation>
    </message>
</context>
<context>
    <name>ductus::SurfacingJobs</name>
    <message>
        <source>Surfacing the sketch</source>
        <translation>Erzeugen der Fläche</translation>
    </message>
</context>
<context>
    <name>ductus::ToolBox</name>
    <message>
        <source>There is no region here. Surface the sketch and click one of its regions.</source>
        <translation>Hier ist keine Region. Erzeugen Sie die Fläche und klicken Sie eine ihrer Regionen an.</translation>
    </message>
    <message>
        <source>Drag a handle to bend the stroke; with Ctrl it slides over the surface, the wheel widens the bend. Drag the stroke between handles to move it.</source>
        <translation>Einen Griff ziehen biegt den Strich; mit Strg gleitet er über die Fläche, das Rad weitet die Biegung. Zwischen den Griffen gezogen, wandert der Strich.</translation>
    </message>
    <message>
        <source>Drag to turn, wheel to zoom. Click a stroke or region to choose it, Shift+drag around several; drag chosen strokes to move them.</source>
        <translation>Ziehen dreht, das Rad zoomt. Ein Klick wählt Strich oder Region, Umschalt+Ziehen mehrere; gewählte Striche lassen sich durch Ziehen verschieben.</translation>
    </message>
    <message>
        <source>Paint over strokes to tell what they mean; the role is chosen in the inspector.</source>
        <translation>Über Striche malen sagt, was sie bedeuten; die Rolle wird im Inspektor gewählt.</translation>
    </message>
    <message>
        <source>Draw on the surface, or in the air facing you; begin at a stroke to snap to it.</source>
        <translation>Auf der Fläche zeichnen oder frei in der Luft; an einem Strich begonnen, rastet er dort ein.</translation>
    </message>
    <message>
        <source>Scribble over what should be a surface of its own.</source>
        <translation>Überkritzeln, was eine eigene Fläche sein soll.</translation>
    </message>
    <message>
        <source>Draw from one region into another: they become one smooth surface.</source>
        <translation>Von einer Region in eine andere zeichnen: Sie werden eine glatte Fläche.</translation>
    </message>
    <message>
        <source>Draw where two surfaces must meet in a crease.</source>
        <translation>Zeichnen, wo zwei Flächen in einem Knick zusammenstoßen müssen.</translation>
    </message>
    <message>
        <source>Draw across a region to cut it in two.</source>
        <translation>Quer durch eine Region zeichnen schneidet sie in zwei.</translation>
    </message>
    <message>
        <source>Draw along a crease that should not be there.</source>
        <translation>An einem Knick entlang zeichnen, den es nicht geben soll.</translation>
    </message>
    <message>
        <source>Click a region to keep it as it is; click again to free it.</source>
        <translation>Eine Region anklicken, damit sie bleibt, wie sie ist; ein zweiter Klick gibt sie frei.</translation>
    </message>
    <message>
        <source>Click two points to measure between them.</source>
        <translation>Zwei Punkte anklicken, um dazwischen zu messen.</translation>
    </message>
</context>
<context>
    <name>ductus::VtkWidget</name>
    <message>
        <source>This computer&apos;s graphics driver offers no OpenGL 3.2.</source>
        <translation>Der Grafiktreiber dieses Rechners bietet kein OpenGL 3.2.</translation>
    </message>
</context>
</TS>
