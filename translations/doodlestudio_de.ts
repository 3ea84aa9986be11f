<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>DirectDrawTool</name>
    <message>
        <source>Canvas %1</source>
        <translation>Leinwand %1</translation>
    </message>
    <message>
        <source>Add canvas</source>
        <translation>Leinwand hinzufügen</translation>
    </message>
</context>
<context>
    <name>OcclusionTool</name>
    <message>
        <source>Bring in front</source>
        <translation>Nach vorn holen</translation>
    </message>
    <message>
        <source>Put behind</source>
        <translation>Nach hinten stellen</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasFollower</name>
    <message>
        <source>Following the canvas</source>
        <translation>Verfolgen der Leinwand</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasList</name>
    <message>
        <source>Canvases</source>
        <translation>Leinwände</translation>
    </message>
    <message>
        <source>Duplicate canvas</source>
        <translation>Leinwand duplizieren</translation>
    </message>
    <message>
        <source>A second canvas with the same drawings, beside this one.</source>
        <translation>Eine zweite Leinwand mit denselben Zeichnungen, neben dieser.</translation>
    </message>
    <message>
        <source>Take canvas away</source>
        <translation>Leinwand entfernen</translation>
    </message>
    <message>
        <source>Takes the canvas and its drawings away.</source>
        <translation>Entfernt die Leinwand und ihre Zeichnungen.</translation>
    </message>
    <message>
        <source>Show canvas</source>
        <translation>Leinwand zeigen</translation>
    </message>
    <message>
        <source>Hide canvas</source>
        <translation>Leinwand verbergen</translation>
    </message>
    <message>
        <source>Rename canvas</source>
        <translation>Leinwand umbenennen</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 Kopie</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasPanel</name>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Bleibt</translation>
    </message>
    <message>
        <source>The canvas stands still in the scene; only the camera moves past it.</source>
        <translation>Die Leinwand steht in der Szene still; nur die Kamera zieht vorbei.</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Folgt</translation>
    </message>
    <message>
        <source>The canvas follows what is under its middle.</source>
        <translation>Die Leinwand folgt dem, was unter ihrer Mitte ist.</translation>
    </message>
    <message>
        <source>Pin here</source>
        <translation>Hier anheften</translation>
    </message>
    <message>
        <source>Holds the canvas where it is in this frame. In between it follows.</source>
        <translation>Hält die Leinwand, wo sie in diesem Bild ist. Dazwischen folgt sie.</translation>
    </message>
    <message>
        <source>Straight to the next pin</source>
        <translation>Gerade bis zum nächsten Stift</translation>
    </message>
    <message>
        <source>From the pin before this frame to the one after it the canvas goes straight and evenly instead of following what is seen: for where it is hidden too long.</source>
        <translation>Vom Stift vor diesem Bild bis zu dem danach läuft die Leinwand gerade und gleichmäßig, statt dem Gesehenen zu folgen: für Stellen, an denen sie zu lange verdeckt ist.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>How far the canvas is from the camera. Nearer things hide it.</source>
        <translation>Wie weit die Leinwand von der Kamera entfernt ist. Näheres verdeckt sie.</translation>
    </message>
    <message>
        <source>Distance from the scene</source>
        <translation>Entfernung aus der Szene</translation>
    </message>
    <message>
        <source>As far as what is under the middle of the canvas.</source>
        <translation>So weit wie das, was unter der Mitte der Leinwand ist.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>The size of the canvas; its corner on the picture does the same.</source>
        <translation>Die Größe der Leinwand; ihre Ecke im Bild tut dasselbe.</translation>
    </message>
    <message>
        <source>Face the camera</source>
        <translation>Zur Kamera drehen</translation>
    </message>
    <message>
        <source>Turns the canvas straight to the camera in this frame.</source>
        <translation>Dreht die Leinwand in diesem Bild gerade zur Kamera.</translation>
    </message>
    <message>
        <source>How it turns while it follows</source>
        <translation>Wie sie sich beim Folgen dreht</translation>
    </message>
    <message>
        <source>What the canvas does between the frames in which you turned it.</source>
        <translation>Was die Leinwand zwischen den Bildern tut, in denen Sie sie gedreht haben.</translation>
    </message>
    <message>
        <source>Turns with the way it goes</source>
        <translation>Dreht sich mit dem Weg</translation>
    </message>
    <message>
        <source>Keeps its direction</source>
        <translation>Behält die Richtung</translation>
    </message>
    <message>
        <source>Turns with the thing it is on</source>
        <translation>Dreht sich mit dem Ding</translation>
    </message>
    <message>
        <source>Keeps its direction relative to its path, as a sign on a tram does in a bend.</source>
        <translation>Behält die Richtung zum Weg, wie ein Schild an einer Straßenbahn in der Kurve.</translation>
    </message>
    <message>
        <source>Looks where you turned it to, whatever happens.</source>
        <translation>Blickt dorthin, wohin Sie sie gedreht haben, was auch geschieht.</translation>
    </message>
    <message>
        <source>Turns as the picture turns around its middle, as a hat does on a dancer.</source>
        <translation>Dreht sich, wie sich das Bild um ihre Mitte dreht, wie ein Hut auf einem Tänzer.</translation>
    </message>
    <message>
        <source>Change turning</source>
        <translation>Drehung ändern</translation>
    </message>
    <message>
        <source>Hidden by what is in front</source>
        <translation>Von Vorderem verdeckt</translation>
    </message>
    <message>
        <source>Nearer things cover the canvas. Off: it is always seen.</source>
        <translation>Näheres verdeckt die Leinwand. Aus: Sie ist immer zu sehen.</translation>
    </message>
    <message>
        <source>Let the scene hide the canvas</source>
        <translation>Leinwand von der Szene verdecken lassen</translation>
    </message>
    <message>
        <source>Show the canvas always</source>
        <translation>Leinwand immer zeigen</translation>
    </message>
    <message>
        <source>Depth play</source>
        <translation>Tiefenspiel</translation>
    </message>
    <message>
        <source>More: the canvas shows through what is only a little nearer.</source>
        <translation>Mehr: Die Leinwand scheint durch, was nur wenig näher ist.</translation>
    </message>
    <message>
        <source>Change depth play</source>
        <translation>Tiefenspiel ändern</translation>
    </message>
    <message>
        <source>In front here</source>
        <translation>Hier davor</translation>
    </message>
    <message>
        <source>Brush over the picture where the canvas must be seen.</source>
        <translation>Über das Bild malen, wo die Leinwand zu sehen sein muss.</translation>
    </message>
    <message>
        <source>Behind here</source>
        <translation>Hier dahinter</translation>
    </message>
    <message>
        <source>Brush over the picture where the canvas must be hidden.</source>
        <translation>Über das Bild malen, wo die Leinwand verdeckt sein muss.</translation>
    </message>
    <message>
        <source>Forget what was brushed</source>
        <translation>Gemaltes vergessen</translation>
    </message>
    <message>
        <source>Only the distance decides again what hides the canvas.</source>
        <translation>Nur die Entfernung entscheidet wieder, was die Leinwand verdeckt.</translation>
    </message>
    <message>
        <source>Forget the brush</source>
        <translation>Gemaltes vergessen</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How much of the film shows through the drawing.</source>
        <translation>Wie sehr der Film durch die Zeichnung scheint.</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Deckkraft ändern</translation>
    </message>
    <message>
        <source>Let canvas follow</source>
        <translation>Leinwand folgen lassen</translation>
    </message>
    <message>
        <source>Let canvas stay</source>
        <translation>Leinwand stehen lassen</translation>
    </message>
    <message>
        <source>Pin canvas</source>
        <translation>Leinwand anheften</translation>
    </message>
    <message>
        <source>Go straight</source>
        <translation>Gerade laufen</translation>
    </message>
    <message>
        <source>Follow the scene</source>
        <translation>Der Szene folgen</translation>
    </message>
    <message>
        <source>Change distance</source>
        <translation>Entfernung ändern</translation>
    </message>
    <message>
        <source>Size canvas</source>
        <translation>Größe der Leinwand ändern</translation>
    </message>
    <message>
        <source>Drag out a box on the picture: a canvas to draw on will stand there.</source>
        <translation>Ziehen Sie im Bild einen Rahmen auf: Dort steht dann eine Leinwand zum Zeichnen.</translation>
    </message>
    <message>
        <source>Choose a canvas above or on the picture, or drag out a box for another one.</source>
        <translation>Wählen Sie eine Leinwand oben oder im Bild, oder ziehen Sie einen Rahmen für eine neue auf.</translation>
    </message>
    <message>
        <source>Pin it here and follow</source>
        <translation>Hier anheften und folgen</translation>
    </message>
    <message>
        <source>Stands still in the scene.</source>
        <translation>Steht still in der Szene.</translation>
    </message>
    <message numerus="yes">
        <source>Pinned in %n frame(s); drag it where it drifts.</source>
        <translation>
            <numerusform>In %n Bild angeheftet; ziehen Sie sie zurecht, wo sie abdriftet.</numerusform>
            <numerusform>In %n Bildern angeheftet; ziehen Sie sie zurecht, wo sie abdriftet.</numerusform>
        </translation>
    </message>
    <message>
        <source>Following...</source>
        <translation>Wird verfolgt...</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingHand</name>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Move drawing</source>
        <translation>Zeichnung verschieben</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Draw arrow</source>
        <translation>Pfeil zeichnen</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Add sticker</source>
        <translation>Sticker hinzufügen</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingPanel</name>
    <message>
        <source>Pen</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>Draws lines; a pen&apos;s pressure makes them wider. (P)</source>
        <translation>Zeichnet Linien; Stiftdruck macht sie breiter. (P)</translation>
    </message>
    <message>
        <source>Filled shape</source>
        <translation>Gefüllte Form</translation>
    </message>
    <message>
        <source>Draw an outline; what is inside is filled. (G)</source>
        <translation>Einen Umriss zeichnen; das Innere wird gefüllt. (G)</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>Points at something; draw it as you like. (A)</source>
        <translation>Zeigt auf etwas; zeichnen Sie ihn, wie Sie mögen. (A)</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand. (T)</source>
        <translation>Text eintippen, dann klicken, wo er stehen soll. (T)</translation>
    </message>
    <message>
        <source>Sticker</source>
        <translation>Sticker</translation>
    </message>
    <message>
        <source>Ready-made drawings; drag to say how large. (S)</source>
        <translation>Fertige Zeichnungen; Ziehen bestimmt die Größe. (S)</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Radierer</translation>
    </message>
    <message>
        <source>Takes parts of lines away. (E)</source>
        <translation>Nimmt Teile von Linien weg. (E)</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Moves something that was drawn. (V)</source>
        <translation>Verschiebt etwas Gezeichnetes. (V)</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Picture. Puts a picture from a file on the canvas; move it with V.</source>
        <translation>Bild. Setzt ein Bild aus einer Datei auf die Leinwand; verschieben mit V.</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand</source>
        <translation>Text eintippen, dann klicken, wo er stehen soll</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation>Cyan</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violett</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>Rosa</translation>
    </message>
    <message>
        <source>Another colour</source>
        <translation>Andere Farbe</translation>
    </message>
    <message>
        <source>Another colour...</source>
        <translation>Andere Farbe...</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Of the line, as a share of the canvas. Keys [ and ].</source>
        <translation>Der Linie, als Anteil der Leinwand. Tasten [ und ].</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>How much of the film is seen below the drawing.</source>
        <translation>Wie viel vom Film unter der Zeichnung zu sehen ist.</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.gif *.svg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.bmp *.gif *.svg)</translation>
    </message>
    <message>
        <source>Insert picture</source>
        <translation>Bild einfügen</translation>
    </message>
    <message>
        <source>seen from behind</source>
        <translation>von hinten gesehen</translation>
    </message>
    <message>
        <source>seen from the side: another frame is better</source>
        <translation>von der Seite gesehen: ein anderes Bild passt besser</translation>
    </message>
    <message>
        <source>star</source>
        <translation>Stern</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>Herz</translation>
    </message>
    <message>
        <source>check</source>
        <translation>Häkchen</translation>
    </message>
    <message>
        <source>cross</source>
        <translation>Kreuz</translation>
    </message>
    <message>
        <source>smile</source>
        <translation>lachendes Gesicht</translation>
    </message>
    <message>
        <source>frown</source>
        <translation>trauriges Gesicht</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>bubble</source>
        <translation>Sprechblase</translation>
    </message>
    <message>
        <source>bang</source>
        <translation>Ausrufezeichen</translation>
    </message>
    <message>
        <source>question</source>
        <translation>Fragezeichen</translation>
    </message>
    <message>
        <source>bulb</source>
        <translation>Glühbirne</translation>
    </message>
    <message>
        <source>bolt</source>
        <translation>Blitz</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingView</name>
    <message>
        <source>Drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>Draw straight on the picture: a canvas is made where you begin.
Or choose a canvas to see it from the front.</source>
        <translation>Zeichnen Sie direkt ins Bild: Wo Sie beginnen, entsteht eine Leinwand.
Oder wählen Sie eine Leinwand, um sie von vorn zu sehen.</translation>
    </message>
</context>
<context>
    <name>ductus::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>With the sound of the clip</source>
        <translation>Mit dem Ton des Clips</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message numerus="yes">
        <source>%1, about %n s left</source>
        <translation>
            <numerusform>%1, noch etwa %n s</numerusform>
            <numerusform>%1, noch etwa %n s</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Share</source>
        <translation>&amp;Teilen</translation>
    </message>
    <message>
        <source>A film with your drawings (MP4). Plays everywhere: phone, web, projector.</source>
        <translation>Ein Film mit Ihren Zeichnungen (MP4). Läuft überall: Handy, Web, Beamer.</translation>
    </message>
    <message>
        <source>S&amp;lides</source>
        <translation>&amp;Folien</translation>
    </message>
    <message>
        <source>A moving picture (GIF) for slides and worksheets. No sound.</source>
        <translation>Ein bewegtes Bild (GIF) für Folien und Arbeitsblätter. Ohne Ton.</translation>
    </message>
    <message>
        <source>&amp;Overlay</source>
        <translation>Ü&amp;berlagerung</translation>
    </message>
    <message>
        <source>Your drawings alone, see-through (WebM), to lay over the clip in another program.</source>
        <translation>Nur Ihre Zeichnungen, durchsichtig (WebM), um sie in einem anderen Programm über den Clip zu legen.</translation>
    </message>
    <message>
        <source>%1 with drawings</source>
        <translation>%1 mit Zeichnungen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it, or choose another name.</source>
        <translation>%1 gibt es schon. Ersetzen Sie es oder wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exportieren von %1</translation>
    </message>
    <message numerus="yes">
        <source>Done: %1 (%2 x %3, %n frame(s))</source>
        <translation>
            <numerusform>Fertig: %1 (%2 x %3, %n Bild)</numerusform>
            <numerusform>Fertig: %1 (%2 x %3, %n Bilder)</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Abgebrochen; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>It could not be exported: %1</source>
        <translation>Der Export ist fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>ductus::FrameStrip</name>
    <message>
        <source>Onion skin</source>
        <translation>Zwiebelhaut</translation>
    </message>
    <message>
        <source>Onion skin (O). The drawings before shine through in red, those after in blue.</source>
        <translation>Zwiebelhaut (O). Die Zeichnungen davor scheinen rot durch, die danach blau.</translation>
    </message>
    <message>
        <source>Drawings that shine through</source>
        <translation>Durchscheinende Zeichnungen</translation>
    </message>
    <message>
        <source>How many drawings before and after shine through.</source>
        <translation>Wie viele Zeichnungen davor und danach durchscheinen.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Video frames this drawing is held</source>
        <translation>Bilder, die diese Zeichnung steht</translation>
    </message>
    <message>
        <source>For how many frames of the film this drawing is seen.</source>
        <translation>Wie viele Bilder des Films diese Zeichnung zu sehen ist.</translation>
    </message>
    <message>
        <source>After the last drawing</source>
        <translation>Nach der letzten Zeichnung</translation>
    </message>
    <message>
        <source>What comes after the last drawing.</source>
        <translation>Was nach der letzten Zeichnung kommt.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>There and back</source>
        <translation>Hin und zurück</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Einmal</translation>
    </message>
    <message>
        <source>Keep the last</source>
        <translation>Letzte behalten</translation>
    </message>
    <message>
        <source>Hold drawing</source>
        <translation>Dauer der Zeichnung</translation>
    </message>
    <message>
        <source>Change repeat</source>
        <translation>Wiederholung ändern</translation>
    </message>
    <message>
        <source>Add drawing</source>
        <translation>Zeichnung hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate drawing</source>
        <translation>Zeichnung duplizieren</translation>
    </message>
    <message>
        <source>Take drawing away</source>
        <translation>Zeichnung entfernen</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>Zeichnung %1</translation>
    </message>
    <message>
        <source>Add drawing. An empty one after this: draw the next moment on it.</source>
        <translation>Zeichnung hinzufügen. Eine leere nach dieser: Zeichnen Sie darauf den nächsten Moment.</translation>
    </message>
    <message numerus="yes">
        <source>Drawing %1, held for %n frame(s)</source>
        <translation>
            <numerusform>Zeichnung %1, %n Bild lang</numerusform>
            <numerusform>Zeichnung %1, %n Bilder lang</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::HandlesTool</name>
    <message>
        <source>Drag the canvas where it must be in this frame: it is pinned there.</source>
        <translation>Die Leinwand dorthin ziehen, wo sie in diesem Bild sein muss: Dort wird sie angeheftet.</translation>
    </message>
    <message>
        <source>Drag the canvas where it should stand.</source>
        <translation>Die Leinwand dorthin ziehen, wo sie stehen soll.</translation>
    </message>
    <message>
        <source>Drag to make the canvas larger or smaller.</source>
        <translation>Ziehen macht die Leinwand größer oder kleiner.</translation>
    </message>
    <message>
        <source>Drag to turn the canvas in its plane.</source>
        <translation>Ziehen dreht die Leinwand in ihrer Ebene.</translation>
    </message>
    <message>
        <source>Drag the pin of the gauge: the canvas looks where the pin points.</source>
        <translation>Den Stift der Anzeige ziehen: Die Leinwand blickt, wohin er zeigt.</translation>
    </message>
    <message>
        <source>Click to go to this moment, drag to pin the canvas elsewhere then.</source>
        <translation>Klicken springt zu diesem Moment, Ziehen heftet die Leinwand dann anderswo an.</translation>
    </message>
    <message>
        <source>Click to choose this canvas.</source>
        <translation>Klicken wählt diese Leinwand.</translation>
    </message>
    <message>
        <source>Drag out a box: a canvas will stand there in the scene.</source>
        <translation>Einen Rahmen aufziehen: Dort steht dann eine Leinwand in der Szene.</translation>
    </message>
    <message>
        <source>Pin canvas</source>
        <translation>Leinwand anheften</translation>
    </message>
    <message>
        <source>Move canvas</source>
        <translation>Leinwand verschieben</translation>
    </message>
    <message>
        <source>Size canvas</source>
        <translation>Größe der Leinwand ändern</translation>
    </message>
    <message>
        <source>Turn canvas</source>
        <translation>Leinwand drehen</translation>
    </message>
    <message>
        <source>Tilt canvas</source>
        <translation>Leinwand neigen</translation>
    </message>
    <message>
        <source>Canvas %1</source>
        <translation>Leinwand %1</translation>
    </message>
    <message>
        <source>Add canvas</source>
        <translation>Leinwand hinzufügen</translation>
    </message>
</context>
<context>
    <name>ductus::PlayerView</name>
    <message>
        <source>Player</source>
        <translation>Player</translation>
    </message>
</context>
<context>
    <name>ductus::StudioWindow</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Opens a clip, a folder of pictures or a project.</source>
        <translation>Öffnet einen Clip, einen Ordner mit Bildern oder ein Projekt.</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Startseite</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the clip stays open.</source>
        <translation>Zeigt Beispiele und zuletzt geöffnete Dateien; der Clip bleibt offen.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>S&amp;peichern</translation>
    </message>
    <message>
        <source>Saves what was drawn and where; the clip itself stays where it is.</source>
        <translation>Speichert, was gezeichnet wurde und wo; der Clip selbst bleibt, wo er ist.</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>Saves under another name and goes on there.</source>
        <translation>Speichert unter einem anderen Namen und macht dort weiter.</translation>
    </message>
    <message>
        <source>&amp;Pack the analysis</source>
        <translation>&amp;Analyse einpacken</translation>
    </message>
    <message>
        <source>Saves how the scene moves in the project as well, so that it opens at once on another computer. Makes the file larger.</source>
        <translation>Speichert auch im Projekt, wie sich die Szene bewegt, damit es auf einem anderen Rechner sofort aufgeht. Macht die Datei größer.</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportieren...</translation>
    </message>
    <message>
        <source>Makes a film, a moving picture for slides, or an overlay.</source>
        <translation>Erzeugt einen Film, ein bewegtes Bild für Folien oder eine Überlagerung.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Runs the clip in a loop, or stops it.</source>
        <translation>Spielt den Clip in einer Schleife oder hält ihn an.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>Ein &amp;Bild zurück</translation>
    </message>
    <message>
        <source>Goes to the frame before.</source>
        <translation>Geht zum vorigen Bild.</translation>
    </message>
    <message>
        <source>One frame &amp;on</source>
        <translation>&amp;Ein Bild weiter</translation>
    </message>
    <message>
        <source>Goes to the next frame.</source>
        <translation>Geht zum nächsten Bild.</translation>
    </message>
    <message>
        <source>Goes to the first frame.</source>
        <translation>Geht zum ersten Bild.</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>&amp;Zum Ende</translation>
    </message>
    <message>
        <source>Goes to the last frame.</source>
        <translation>Geht zum letzten Bild.</translation>
    </message>
    <message>
        <source>Play back&amp;wards</source>
        <translation>&amp;Rückwärts abspielen</translation>
    </message>
    <message>
        <source>Runs the clip backwards; again: faster.</source>
        <translation>Spielt den Clip rückwärts; nochmals: schneller.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>A&amp;nhalten</translation>
    </message>
    <message>
        <source>Stops the clip.</source>
        <translation>Hält den Clip an.</translation>
    </message>
    <message>
        <source>Play &amp;forwards</source>
        <translation>&amp;Vorwärts abspielen</translation>
    </message>
    <message>
        <source>Runs the clip; again: faster.</source>
        <translation>Spielt den Clip; nochmals: schneller.</translation>
    </message>
    <message>
        <source>So&amp;und</source>
        <translation>&amp;Ton</translation>
    </message>
    <message>
        <source>Lets the clip be heard while it runs.</source>
        <translation>Lässt den Clip beim Abspielen hören.</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>&amp;Follow what is here</source>
        <translation>Dem &amp;folgen, was hier ist</translation>
    </message>
    <message>
        <source>Pins the canvas to what is under its middle; it follows from then on.</source>
        <translation>Heftet die Leinwand an das, was unter ihrer Mitte ist; von da an folgt sie.</translation>
    </message>
    <message>
        <source>S&amp;tay here</source>
        <translation>&amp;Hier bleiben</translation>
    </message>
    <message>
        <source>Lets the canvas stand still in the scene where it is now.</source>
        <translation>Lässt die Leinwand in der Szene stehen, wo sie jetzt ist.</translation>
    </message>
    <message>
        <source>Face the &amp;camera</source>
        <translation>&amp;Zur Kamera drehen</translation>
    </message>
    <message>
        <source>Turns the canvas straight to the camera in this frame.</source>
        <translation>Dreht die Leinwand in diesem Bild gerade zur Kamera.</translation>
    </message>
    <message>
        <source>&amp;Next keyframe</source>
        <translation>&amp;Nächster Keyframe</translation>
    </message>
    <message>
        <source>Goes to the next frame in which the canvas is pinned, turned or sized.</source>
        <translation>Geht zum nächsten Bild, in dem die Leinwand angeheftet, gedreht oder skaliert wird.</translation>
    </message>
    <message>
        <source>&amp;Previous keyframe</source>
        <translation>&amp;Voriger Keyframe</translation>
    </message>
    <message>
        <source>Goes to the keyframe before.</source>
        <translation>Geht zum Keyframe davor.</translation>
    </message>
    <message>
        <source>&amp;Duplicate canvas</source>
        <translation>Leinwand &amp;duplizieren</translation>
    </message>
    <message>
        <source>A second canvas with the same drawings, beside this one.</source>
        <translation>Eine zweite Leinwand mit denselben Zeichnungen, neben dieser.</translation>
    </message>
    <message>
        <source>Takes the canvas and its drawings away.</source>
        <translation>Entfernt die Leinwand und ihre Zeichnungen.</translation>
    </message>
    <message>
        <source>&amp;Look at the scene again</source>
        <translation>&amp;Szene neu untersuchen</translation>
    </message>
    <message>
        <source>Finds anew how the camera and all else moves; drawings stay.</source>
        <translation>Findet neu, wie sich Kamera und alles andere bewegt; Zeichnungen bleiben.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Gives up what was begun; then the choice.</source>
        <translation>Gibt Begonnenes auf, dann die Auswahl.</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>&amp;Pen</source>
        <translation>&amp;Stift</translation>
    </message>
    <message>
        <source>Draws lines.</source>
        <translation>Zeichnet Linien.</translation>
    </message>
    <message>
        <source>&amp;Filled shape</source>
        <translation>&amp;Gefüllte Form</translation>
    </message>
    <message>
        <source>Draw an outline; what is inside is filled.</source>
        <translation>Einen Umriss zeichnen; das Innere wird gefüllt.</translation>
    </message>
    <message>
        <source>&amp;Arrow</source>
        <translation>&amp;Pfeil</translation>
    </message>
    <message>
        <source>Points at something.</source>
        <translation>Zeigt auf etwas.</translation>
    </message>
    <message>
        <source>&amp;Words</source>
        <translation>&amp;Text</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand.</source>
        <translation>Text eintippen, dann klicken, wo er stehen soll.</translation>
    </message>
    <message>
        <source>&amp;Sticker</source>
        <translation>St&amp;icker</translation>
    </message>
    <message>
        <source>Ready-made drawings.</source>
        <translation>Fertige Zeichnungen.</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>&amp;Radierer</translation>
    </message>
    <message>
        <source>Takes parts of lines away.</source>
        <translation>Nimmt Teile von Linien weg.</translation>
    </message>
    <message>
        <source>&amp;Move a drawing</source>
        <translation>Zeic&amp;hnung verschieben</translation>
    </message>
    <message>
        <source>Moves something that was drawn.</source>
        <translation>Verschiebt etwas Gezeichnetes.</translation>
    </message>
    <message>
        <source>W&amp;ider brush</source>
        <translation>&amp;Breiterer Pinsel</translation>
    </message>
    <message>
        <source>Makes the brush wider.</source>
        <translation>Macht den Pinsel breiter.</translation>
    </message>
    <message>
        <source>&amp;Narrower brush</source>
        <translation>S&amp;chmalerer Pinsel</translation>
    </message>
    <message>
        <source>Makes the brush narrower.</source>
        <translation>Macht den Pinsel schmaler.</translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation>Z&amp;wiebelhaut</translation>
    </message>
    <message>
        <source>The drawings before shine through in red, those after in blue.</source>
        <translation>Die Zeichnungen davor scheinen rot durch, die danach blau.</translation>
    </message>
    <message>
        <source>A&amp;dd drawing</source>
        <translation>&amp;Zeichnung hinzufügen</translation>
    </message>
    <message>
        <source>An empty drawing after this one: the next moment of an animation.</source>
        <translation>Eine leere Zeichnung nach dieser: der nächste Moment einer Animation.</translation>
    </message>
    <message>
        <source>D&amp;uplicate drawing</source>
        <translation>Zeichnung &amp;duplizieren</translation>
    </message>
    <message>
        <source>A copy of this drawing after it, to be changed a little.</source>
        <translation>Eine Kopie dieser Zeichnung danach, um sie ein wenig zu ändern.</translation>
    </message>
    <message>
        <source>Take drawing awa&amp;y</source>
        <translation>Zeichnung &amp;entfernen</translation>
    </message>
    <message>
        <source>Takes the present drawing out of the animation.</source>
        <translation>Nimmt die jetzige Zeichnung aus der Animation.</translation>
    </message>
    <message>
        <source>Ne&amp;xt drawing</source>
        <translation>&amp;Nächste Zeichnung</translation>
    </message>
    <message>
        <source>Goes to the next drawing of the canvas.</source>
        <translation>Geht zur nächsten Zeichnung der Leinwand.</translation>
    </message>
    <message>
        <source>P&amp;revious drawing</source>
        <translation>&amp;Vorige Zeichnung</translation>
    </message>
    <message>
        <source>Goes to the drawing before.</source>
        <translation>Geht zur Zeichnung davor.</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>&amp;Leinwand</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>&amp;Zeichnen</translation>
    </message>
    <message>
        <source>Looking at the scene</source>
        <translation>Untersuchen der Szene</translation>
    </message>
    <message>
        <source>How the scene moves was not in the cache any more and was found again.</source>
        <translation>Wie sich die Szene bewegt, war nicht mehr im Cache und wurde neu gefunden.</translation>
    </message>
    <message>
        <source>What was found out is kept in the project, as the cache cannot be used: %1</source>
        <translation>Das Gefundene wird im Projekt behalten, da der Cache nicht nutzbar ist: %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>The scene was not looked at to the end.</source>
        <translation>Die Szene wurde nicht zu Ende untersucht.</translation>
    </message>
    <message>
        <source>Canvases cannot follow what moves until it is; it goes on where it was.</source>
        <translation>Bis dahin können Leinwände Bewegtem nicht folgen; es geht weiter, wo es aufhörte.</translation>
    </message>
    <message>
        <source>Look at the scene</source>
        <translation>Szene untersuchen</translation>
    </message>
    <message>
        <source>The clip is too long for that: its analysis has %1 megabytes.</source>
        <translation>Der Clip ist dafür zu lang: Seine Analyse hat %1 Megabyte.</translation>
    </message>
    <message>
        <source>DoodleStudio</source>
        <translation>DoodleStudio</translation>
    </message>
    <message>
        <source>Draw into a filmed scene, so that it stays where you put it.</source>
        <translation>In eine gefilmte Szene zeichnen, sodass es bleibt, wo man es hinsetzt.</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Öffnen...</translation>
    </message>
    <message>
        <source>Drop a clip, a folder of pictures or a project anywhere.</source>
        <translation>Ziehen Sie einen Clip, einen Bilderordner oder ein Projekt irgendwohin.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Clips and projects (*.ductus %1);;All files (*)</source>
        <translation>Clips und Projekte (*.ductus %1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Öffnen von %1</translation>
    </message>
    <message>
        <source>Find the clip...</source>
        <translation>Clip suchen...</translation>
    </message>
    <message>
        <source>Looking where %1 is now</source>
        <translation>Suche, wo %1 jetzt ist</translation>
    </message>
    <message>
        <source>The clip was moved and is found again: %1</source>
        <translation>Der Clip wurde verschoben und ist wiedergefunden: %1</translation>
    </message>
    <message>
        <source>The clip has the frames and the size of the one this was drawn on, but it is another file.</source>
        <translation>Der Clip hat so viele Bilder und ist so groß wie der, auf den gezeichnet wurde, ist aber eine andere Datei.</translation>
    </message>
    <message>
        <source>If it does not show the same scene, find the right one.</source>
        <translation>Wenn er nicht dieselbe Szene zeigt, suchen Sie den richtigen.</translation>
    </message>
    <message>
        <source>The clip is another one than this was drawn on.</source>
        <translation>Das ist ein anderer Clip als der, auf den gezeichnet wurde.</translation>
    </message>
    <message>
        <source>Its number of frames or its size differ.</source>
        <translation>Anzahl der Bilder oder Größe weichen ab.</translation>
    </message>
    <message>
        <source>The clip %1 is not where it was.</source>
        <translation>Der Clip %1 ist nicht mehr, wo er war.</translation>
    </message>
    <message>
        <source>Show where it is now: everything drawn is kept.</source>
        <translation>Zeigen Sie, wo er jetzt ist: Alles Gezeichnete bleibt erhalten.</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Wo ist %1?</translation>
    </message>
    <message>
        <source>Clips (%1);;All files (*)</source>
        <translation>Clips (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading the sound</source>
        <translation>Lesen des Tons</translation>
    </message>
    <message>
        <source>Open a clip first; its film can be exported then.</source>
        <translation>Öffnen Sie zuerst einen Clip; dann lässt sich sein Film exportieren.</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Exportiert nach %1.</translation>
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
        <source>&amp;Write down what I do</source>
        <translation>Mitschreiben, was &amp;ich tue</translation>
    </message>
    <message>
        <source>Every step and command with its time, from now on; nothing leaves this computer.</source>
        <translation>Jeder Schritt und Befehl mit seiner Zeit, ab jetzt; nichts verlässt diesen Rechner.</translation>
    </message>
    <message>
        <source>Nothing was written down.</source>
        <translation>Es wurde nichts mitgeschrieben.</translation>
    </message>
    <message>
        <source>What you do is written down from now on. Edit &gt; Save what I did keeps it.</source>
        <translation>Was Sie tun, wird ab jetzt mitgeschrieben. Bearbeiten &gt; Mitschrift speichern hebt es auf.</translation>
    </message>
    <message>
        <source>Save what I &amp;did...</source>
        <translation>&amp;Mitschrift speichern...</translation>
    </message>
    <message>
        <source>A line of JSON for every step: when, what, on which canvas, in which frame.</source>
        <translation>Eine Zeile JSON je Schritt: wann, was, auf welcher Leinwand, in welchem Bild.</translation>
    </message>
    <message>
        <source>Save what I did</source>
        <translation>Mitschrift speichern</translation>
    </message>
    <message>
        <source>Action logs (*.jsonl)</source>
        <translation>Aktionsprotokolle (*.jsonl)</translation>
    </message>
    <message numerus="yes">
        <source>%n act(s) written to %1.</source>
        <translation>
            <numerusform>%n Aktion nach %1 geschrieben.</numerusform>
            <numerusform>%n Aktionen nach %1 geschrieben.</numerusform>
        </translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>1  Place</source>
        <translation>1  Platzieren</translation>
    </message>
    <message>
        <source>Put a canvas where the drawing should be.</source>
        <translation>Eine Leinwand dorthin stellen, wo die Zeichnung sein soll.</translation>
    </message>
    <message>
        <source>2  Pin</source>
        <translation>2  Anheften</translation>
    </message>
    <message>
        <source>Say where the canvas must be; it follows in between.</source>
        <translation>Sagen, wo die Leinwand sein muss; dazwischen folgt sie.</translation>
    </message>
    <message>
        <source>3  Draw</source>
        <translation>3  Zeichnen</translation>
    </message>
    <message>
        <source>Draw on the canvas, seen from the front.</source>
        <translation>Auf die Leinwand zeichnen, von vorn gesehen.</translation>
    </message>
    <message>
        <source>Canvases</source>
        <translation>Leinwände</translation>
    </message>
    <message>
        <source>This canvas</source>
        <translation>Diese Leinwand</translation>
    </message>
    <message>
        <source>Brush where the canvas must be seen; it counts in the frames around, too.</source>
        <translation>Malen, wo die Leinwand zu sehen sein muss; es gilt auch in den Bildern ringsum.</translation>
    </message>
    <message>
        <source>Brush where the canvas must be hidden; it counts in the frames around, too.</source>
        <translation>Malen, wo die Leinwand verdeckt sein muss; es gilt auch in den Bildern ringsum.</translation>
    </message>
    <message>
        <source>Move keyframe</source>
        <translation>Keyframe verschieben</translation>
    </message>
    <message>
        <source>Take keyframe away</source>
        <translation>Keyframe entfernen</translation>
    </message>
    <message>
        <source>Go &amp;straight to the next keyframe</source>
        <translation>&amp;Gerade zum nächsten Keyframe</translation>
    </message>
    <message>
        <source>Go straight</source>
        <translation>Gerade laufen</translation>
    </message>
    <message>
        <source>Follow the scene</source>
        <translation>Der Szene folgen</translation>
    </message>
    <message>
        <source>&amp;Take keyframe away</source>
        <translation>&amp;Keyframe entfernen</translation>
    </message>
    <message>
        <source>Drag out a box on the picture: a canvas will stand there in the scene.</source>
        <translation>Ziehen Sie im Bild einen Rahmen auf: Dort steht dann eine Leinwand in der Szene.</translation>
    </message>
    <message>
        <source>Go to a frame where the canvas is wrong and drag it back: it is pinned there.</source>
        <translation>Gehen Sie zu einem Bild, in dem die Leinwand falsch steht, und ziehen Sie sie zurück: Dort wird sie angeheftet.</translation>
    </message>
    <message>
        <source>Draw on the canvas from the front, or straight on the picture.</source>
        <translation>Zeichnen Sie auf die Leinwand von vorn oder direkt ins Bild.</translation>
    </message>
    <message>
        <source>The scene is being looked at; you can place and draw already.</source>
        <translation>Die Szene wird untersucht; platzieren und zeichnen können Sie schon.</translation>
    </message>
    <message>
        <source>The camera&apos;s way was found: canvases stand firmly in the scene.</source>
        <translation>Der Weg der Kamera ist gefunden: Leinwände stehen fest in der Szene.</translation>
    </message>
    <message>
        <source>Positions and distances were measured from how the picture shifts.</source>
        <translation>Positionen und Entfernungen sind aus der Verschiebung des Bildes gemessen.</translation>
    </message>
    <message>
        <source>The camera turns on the spot: distances are guessed.</source>
        <translation>Die Kamera dreht sich auf der Stelle: Entfernungen sind geschätzt.</translation>
    </message>
    <message>
        <source>Set the distance of a canvas by hand where it hides or shows wrongly.</source>
        <translation>Stellen Sie die Entfernung einer Leinwand von Hand ein, wo sie falsch verdeckt oder sichtbar ist.</translation>
    </message>
    <message>
        <source>The camera stands still: distances are guessed.</source>
        <translation>Die Kamera steht still: Entfernungen sind geschätzt.</translation>
    </message>
    <message>
        <source>Place a pa&amp;inting...</source>
        <translation>B&amp;ild platzieren...</translation>
    </message>
    <message>
        <source>Stands a painting of LayerPainter in the scene: seen by the shot&apos;s camera, hidden by what is before it.</source>
        <translation>Stellt ein Gemälde aus LayerPainter in die Szene: von der Kamera der Aufnahme gesehen, verdeckt von dem, was davor ist.</translation>
    </message>
    <message>
        <source>&amp;Update paintings</source>
        <translation>&amp;Gemälde aktualisieren</translation>
    </message>
    <message>
        <source>Takes what has changed in the paintings that stand in the scene; they stay where they are.</source>
        <translation>Übernimmt, was sich in den Gemälden der Szene geändert hat; sie bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>&amp;Copy lines</source>
        <translation>Linien &amp;kopieren</translation>
    </message>
    <message>
        <source>Puts the lines of this drawing on the clipboard, for the other apps of the suite as well.</source>
        <translation>Legt die Linien dieser Zeichnung in die Zwischenablage, auch für die anderen Programme der Suite.</translation>
    </message>
    <message>
        <source>Draws the strokes on the clipboard on the chosen canvas, whichever app they come from.</source>
        <translation>Zeichnet die Striche der Zwischenablage auf die gewählte Leinwand, aus welchem Programm sie auch kommen.</translation>
    </message>
    <message>
        <source>Choose a canvas with drawn lines: they are copied then.</source>
        <translation>Wählen Sie eine Leinwand mit Linien: Sie werden dann kopiert.</translation>
    </message>
    <message numerus="yes">
        <source>%n lines copied.</source>
        <translation>
            <numerusform>%n Linie kopiert.</numerusform>
            <numerusform>%n Linien kopiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a canvas, or place one: the strokes are drawn on it.</source>
        <translation>Wählen oder platzieren Sie eine Leinwand: Die Striche werden darauf gezeichnet.</translation>
    </message>
    <message>
        <source>Paste lines</source>
        <translation>Linien einfügen</translation>
    </message>
    <message numerus="yes">
        <source>%n lines pasted.</source>
        <translation>
            <numerusform>%n Linie eingefügt.</numerusform>
            <numerusform>%n Linien eingefügt.</numerusform>
        </translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>Das Gemälde</translation>
    </message>
    <message>
        <source>Open a clip first; a painting can stand in it then.</source>
        <translation>Öffnen Sie zuerst einen Clip; dann kann ein Gemälde darin stehen.</translation>
    </message>
    <message>
        <source>Place a painting</source>
        <translation>Gemälde platzieren</translation>
    </message>
    <message>
        <source>Paintings of LayerPainter (*.ductus)</source>
        <translation>Gemälde aus LayerPainter (*.ductus)</translation>
    </message>
    <message>
        <source>Open a clip: %1 will stand in it.</source>
        <translation>Öffnen Sie einen Clip: %1 wird darin stehen.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lesen von %1</translation>
    </message>
    <message>
        <source>Place painting</source>
        <translation>Gemälde platzieren</translation>
    </message>
    <message>
        <source>%1 stands in the scene. Move it by its handles.</source>
        <translation>%1 steht in der Szene. An den Griffen lässt es sich bewegen.</translation>
    </message>
    <message>
        <source>Looking for changes of the paintings</source>
        <translation>Suche nach Änderungen der Gemälde</translation>
    </message>
    <message>
        <source>No painting stands in this scene.</source>
        <translation>In dieser Szene steht kein Gemälde.</translation>
    </message>
    <message>
        <source>All paintings are as they are in LayerPainter.</source>
        <translation>Alle Gemälde sind wie in LayerPainter.</translation>
    </message>
    <message>
        <source>The painting &quot;%1&quot; changed in LayerPainter.</source>
        <translation>Das Gemälde „%1“ hat sich in LayerPainter geändert.</translation>
    </message>
    <message numerus="yes">
        <source>%n paintings changed in LayerPainter.</source>
        <translation>
            <numerusform>%n Gemälde hat sich in LayerPainter geändert.</numerusform>
            <numerusform>%n Gemälde haben sich in LayerPainter geändert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Update? Where they stand and what you drew stays.</source>
        <translation>Aktualisieren? Wo sie stehen und was Sie gezeichnet haben, bleibt.</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Update painting</source>
        <translation>Gemälde aktualisieren</translation>
    </message>
    <message>
        <source>To the be&amp;ginning</source>
        <translation>Z&amp;um Anfang</translation>
    </message>
    <message>
        <source>Ta&amp;ke canvas away</source>
        <translation>&amp;Leinwand entfernen</translation>
    </message>
    <message>
        <source>Paste &amp;lines</source>
        <translation>&amp;Linien einfügen</translation>
    </message>
</context>
<context>
    <name>ductus::TimelineView</name>
    <message>
        <source>Canvases will stand here, one a row.</source>
        <translation>Hier werden die Leinwände stehen, eine je Zeile.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>being followed...</source>
        <translation>wird verfolgt...</translation>
    </message>
    <message>
        <source>stands still in the scene</source>
        <translation>steht still in der Szene</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>, then straight to the next</source>
        <translation>, dann gerade zum nächsten</translation>
    </message>
    <message>
        <source>Pinned here, %1%2. Drag to another frame; Delete takes it away.</source>
        <translation>Hier angeheftet, %1%2. In ein anderes Bild ziehen; Entf nimmt es weg.</translation>
    </message>
    <message>
        <source>Distance set here, %1.</source>
        <translation>Entfernung hier gesetzt, %1.</translation>
    </message>
    <message>
        <source>Turned here, %1%2.</source>
        <translation>Hier gedreht, %1%2.</translation>
    </message>
    <message>
        <source>Size set here, %1.</source>
        <translation>Größe hier gesetzt, %1.</translation>
    </message>
    <message>
        <source>Drag to go through the clip. Ctrl and the wheel zoom.</source>
        <translation>Ziehen geht durch den Clip. Strg mit dem Rad zoomt.</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>Zeichnung %1</translation>
    </message>
</context>
<context>
    <name>ductus::TransportBar</name>
    <message>
        <source>%1   frame %2 of %3</source>
        <translation>%1   Bild %2 von %3</translation>
    </message>
</context>
</TS>
