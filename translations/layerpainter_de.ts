<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
</context>
<context>
    <name>ductus::BrushPanel</name>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Half the width of a stroke in the painting&apos;s unit. Keys [ and ].</source>
        <translation>Die halbe Breite eines Strichs in der Einheit des Gemäldes. Tasten [ und ].</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Querschnitt</translation>
    </message>
    <message>
        <source>Section of strokes</source>
        <translation>Querschnitt der Striche</translation>
    </message>
    <message>
        <source>The shape of a stroke cut across.</source>
        <translation>Die Form eines quer geschnittenen Strichs.</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Ribbon</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>Where strokes go</source>
        <translation>Wohin Striche kommen</translation>
    </message>
    <message>
        <source>On surface</source>
        <translation>Auf Fläche</translation>
    </message>
    <message>
        <source>Strokes lie on what is under the pointer.</source>
        <translation>Striche liegen auf dem, was unter dem Zeiger ist.</translation>
    </message>
    <message>
        <source>On plane</source>
        <translation>Frei im Raum</translation>
    </message>
    <message>
        <source>Strokes lie on a plane through the point the view turns around.</source>
        <translation>Striche liegen auf einer ebenen Fläche durch den Punkt, um den sich die Ansicht dreht.</translation>
    </message>
</context>
<context>
    <name>ductus::ColourField</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Left and right: how colourful; up and down: how bright. The bar at the right: the hue.</source>
        <translation>Links und rechts: wie kräftig; oben und unten: wie hell. Der Balken rechts: der Farbton.</translation>
    </message>
</context>
<context>
    <name>ductus::ColourList</name>
    <message>
        <source>Layers that colour this point</source>
        <translation>Ebenen, die diesen Punkt färben</translation>
    </message>
    <message>
        <source>The point&apos;s colour with this layer and all below. Click: work in this layer.</source>
        <translation>Die Farbe des Punkts mit dieser Ebene und allen darunter. Klick: in dieser Ebene arbeiten.</translation>
    </message>
    <message>
        <source>Paint with %1</source>
        <translation>Mit %1 malen</translation>
    </message>
    <message>
        <source> %1 %</source>
        <translation> %1 %</translation>
    </message>
    <message>
        <source>, whole scene</source>
        <translation>, ganze Szene</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
</context>
<context>
    <name>ductus::ColourPanel</name>
    <message>
        <source>Colour %1</source>
        <translation>Farbe %1</translation>
    </message>
</context>
<context>
    <name>ductus::FilmDialog</name>
    <message>
        <source>Full HD, 1920 × 1080</source>
        <translation>Full HD, 1920 × 1080</translation>
    </message>
    <message>
        <source>HD, 1280 × 720</source>
        <translation>HD, 1280 × 720</translation>
    </message>
    <message>
        <source>Small, 640 × 360</source>
        <translation>Klein, 640 × 360</translation>
    </message>
    <message>
        <source>Square, 1080 × 1080</source>
        <translation>Quadratisch, 1080 × 1080</translation>
    </message>
    <message>
        <source>Upright, 1080 × 1920</source>
        <translation>Hochformat, 1080 × 1920</translation>
    </message>
    <message>
        <source>4K, 3840 × 2160</source>
        <translation>4K, 3840 × 2160</translation>
    </message>
    <message>
        <source>Export film</source>
        <translation>Film exportieren</translation>
    </message>
    <message>
        <source>&amp;Seen</source>
        <translation>&amp;Blickpunkt</translation>
    </message>
    <message>
        <source>From where the film looks at the painting.</source>
        <translation>Von wo der Film auf das Gemälde blickt.</translation>
    </message>
    <message>
        <source>Once around, from the present view</source>
        <translation>Einmal herum, ab der jetzigen Ansicht</translation>
    </message>
    <message>
        <source>Along the camera path</source>
        <translation>Entlang der Kamerafahrt</translation>
    </message>
    <message>
        <source>From the present view</source>
        <translation>Aus der jetzigen Ansicht</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>&amp;Look</translation>
    </message>
    <message>
        <source>Which look the film shows.</source>
        <translation>Welchen Look der Film zeigt.</translation>
    </message>
    <message>
        <source>As shown now</source>
        <translation>Wie jetzt gezeigt</translation>
    </message>
    <message>
        <source>All looks, a film each</source>
        <translation>Alle Looks, je ein Film</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Art</translation>
    </message>
    <message>
        <source>MP4 plays everywhere; WebM and pictures keep transparency.</source>
        <translation>MP4 läuft überall; WebM und Bilder behalten die Transparenz.</translation>
    </message>
    <message>
        <source>MP4 - plays everywhere</source>
        <translation>MP4 - läuft überall</translation>
    </message>
    <message>
        <source>WebM - for the web, can be transparent</source>
        <translation>WebM - fürs Web, kann transparent sein</translation>
    </message>
    <message>
        <source>GIF - a small loop</source>
        <translation>GIF - eine kleine Schleife</translation>
    </message>
    <message>
        <source>Folder of PNG pictures</source>
        <translation>Ordner mit PNG-Bildern</translation>
    </message>
    <message>
        <source>S&amp;ize</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Pixels of a frame.</source>
        <translation>Pixel eines Bildes.</translation>
    </message>
    <message>
        <source>&amp;Frames a second</source>
        <translation>Bilder &amp;pro Sekunde</translation>
    </message>
    <message>
        <source>25 suits films, 12 a hand-drawn loop.</source>
        <translation>25 passt für Filme, 12 für eine handgezeichnete Schleife.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>How long the film is; double click: as long as the painting moves.</source>
        <translation>Wie lang der Film ist; Doppelklick: solange sich das Gemälde bewegt.</translation>
    </message>
    <message>
        <source>&amp;Without background</source>
        <translation>&amp;Ohne Hintergrund</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportieren...</translation>
    </message>
    <message>
        <source>MP4 has no transparency; choose WebM, GIF or PNG.</source>
        <translation>MP4 kennt keine Transparenz; wählen Sie WebM, GIF oder PNG.</translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n films</source>
        <translation>
            <numerusform> in %n Film</numerusform>
            <numerusform> in %n Filmen</numerusform>
        </translation>
    </message>
    <message>
        <source>, drawn in the background; you can go on painting.</source>
        <translation>, im Hintergrund gezeichnet; Sie können weitermalen.</translation>
    </message>
</context>
<context>
    <name>ductus::HeadsetWindow</name>
    <message>
        <source>Paint in &amp;VR</source>
        <translation>In VR &amp;malen</translation>
    </message>
    <message>
        <source>The painting in a headset, with the same layers and tools; again leaves it.</source>
        <translation>Das Gemälde im Headset, mit denselben Ebenen und Werkzeugen; nochmals beendet es.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>VR</source>
        <translation>VR</translation>
    </message>
    <message>
        <source>Paint in VR</source>
        <translation>In VR malen</translation>
    </message>
    <message>
        <source>The painting is in the headset. This window shows what the left eye sees.</source>
        <translation>Das Gemälde ist im Headset. Dieses Fenster zeigt, was das linke Auge sieht.</translation>
    </message>
</context>
<context>
    <name>ductus::KeyTrack</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>&lt;b&gt;Time&lt;/b&gt;&lt;br&gt;Drag to see the painting at another moment; diamonds are keys of the camera (above) and of layers (below).</source>
        <translation>&lt;b&gt;Zeit&lt;/b&gt;&lt;br&gt;Ziehen zeigt das Gemälde zu einem anderen Zeitpunkt; Rauten sind Keyframes der Kamera (oben) und der Ebenen (unten).</translation>
    </message>
</context>
<context>
    <name>ductus::LayerPanel</name>
    <message>
        <source>Find layers</source>
        <translation>Ebenen suchen</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplizieren</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Überlagern</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Addieren</translation>
    </message>
    <message>
        <source>Darken</source>
        <translation>Abdunkeln</translation>
    </message>
    <message>
        <source>Lighten</source>
        <translation>Aufhellen</translation>
    </message>
    <message>
        <source>Colour dodge</source>
        <translation>Farbig abwedeln</translation>
    </message>
    <message>
        <source>Colour burn</source>
        <translation>Farbig nachbelichten</translation>
    </message>
    <message>
        <source>Hard light</source>
        <translation>Hartes Licht</translation>
    </message>
    <message>
        <source>Soft light</source>
        <translation>Weiches Licht</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Exclusion</source>
        <translation>Ausschluss</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Luminosity</source>
        <translation>Leuchtkraft</translation>
    </message>
    <message>
        <source>Add stack</source>
        <translation>Stapel hinzufügen</translation>
    </message>
    <message>
        <source>A new shape to paint on, with layers of its own.</source>
        <translation>Eine neue Form zum Bemalen, mit eigenen Ebenen.</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Its strokes colour the shape below them.</source>
        <translation>Ihre Striche färben die Form darunter.</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Ebene duplizieren</translation>
    </message>
    <message>
        <source>A copy with all strokes, right above.</source>
        <translation>Eine Kopie mit allen Strichen, gleich darüber.</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>Ebene löschen</translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>Rückgängig holt sie zurück.</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How strongly the layer shows.</source>
        <translation>Wie stark die Ebene erscheint.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Mischmodus</translation>
    </message>
    <message>
        <source>How its colour is mixed with what is below: Multiply darkens, Screen lightens, Overlay does both.</source>
        <translation>Wie sich ihre Farbe mit dem Darunter mischt: Multiplizieren dunkelt ab, Bildschirm hellt auf, Überlagern tut beides.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Tolerance: how far from its strokes the layer still colours. 0: only inside them.</source>
        <translation>Toleranz: wie weit um ihre Striche die Ebene noch färbt. 0: nur darin.</translation>
    </message>
    <message>
        <source>Stack %1</source>
        <translation>Stapel %1</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Ebene %1</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 Kopie</translation>
    </message>
</context>
<context>
    <name>ductus::LayerTree</name>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Lock: nothing changes it</source>
        <translation>Sperren: nichts ändert sie</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n Strich</numerusform>
            <numerusform>%n Striche</numerusform>
        </translation>
    </message>
    <message>
        <source>Its layers colour everything, after all others.</source>
        <translation>Seine Ebenen färben alles, nach allen anderen.</translation>
    </message>
</context>
<context>
    <name>ductus::LooksBar</name>
    <message>
        <source>Looks</source>
        <translation>Looks</translation>
    </message>
    <message>
        <source>Keep this look</source>
        <translation>Diesen Look behalten</translation>
    </message>
    <message>
        <source>&lt;b&gt;Keep this look&lt;/b&gt;&lt;br&gt;Remembers what all layers are now: visible, how strong, how mixed.</source>
        <translation>&lt;b&gt;Diesen Look behalten&lt;/b&gt;&lt;br&gt;Merkt sich, wie alle Ebenen jetzt sind: sichtbar, wie stark, wie gemischt.</translation>
    </message>
    <message>
        <source>Look %1</source>
        <translation>Look %1</translation>
    </message>
    <message>
        <source>Shows this look; right click to update, rename or delete it.</source>
        <translation>Zeigt diesen Look; Rechtsklick zum Aktualisieren, Umbenennen oder Löschen.</translation>
    </message>
    <message>
        <source>Update from the present</source>
        <translation>Mit dem jetzigen Zustand aktualisieren</translation>
    </message>
    <message>
        <source>Rename...</source>
        <translation>Umbenennen...</translation>
    </message>
    <message>
        <source>Rename look</source>
        <translation>Look umbenennen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
</context>
<context>
    <name>ductus::MaskList</name>
    <message>
        <source>Gradient</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Round gradient</source>
        <translation>Kreisverlauf</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Inside %1</source>
        <translation>Innerhalb von %1</translation>
    </message>
    <message>
        <source>Outside %1</source>
        <translation>Außerhalb von %1</translation>
    </message>
    <message>
        <source>Add mask</source>
        <translation>Maske hinzufügen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Add mask&lt;/b&gt;&lt;br&gt;Masks weaken the layer in places; gradients are drawn with the gradient tool (D).</source>
        <translation>&lt;b&gt;Maske hinzufügen&lt;/b&gt;&lt;br&gt;Masken schwächen die Ebene stellenweise ab; Verläufe zieht man mit dem Verlaufswerkzeug (D).</translation>
    </message>
    <message>
        <source>, inside out</source>
        <translation>, umgekehrt</translation>
    </message>
    <message>
        <source>Mask of the layer. Click: on and off. With Shift: inside out. With Ctrl: remove.</source>
        <translation>Maske der Ebene. Klick: ein und aus. Mit Umschalt: umkehren. Mit Strg: entfernen.</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Körnung</translation>
    </message>
    <message>
        <source>How large the spots of the noise are, in the painting&apos;s unit.</source>
        <translation>Wie groß die Flecken des Rauschens sind, in der Einheit des Gemäldes.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Menge</translation>
    </message>
    <message>
        <source>Where the noise begins to show: 0 everywhere, 1 nowhere.</source>
        <translation>Ab wo das Rauschen erscheint: 0 überall, 1 nirgends.</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>How soft the borders of the spots are.</source>
        <translation>Wie weich die Ränder der Flecken sind.</translation>
    </message>
    <message>
        <source>Texture from pictures...</source>
        <translation>Textur aus Bildern...</translation>
    </message>
    <message>
        <source>Inside strokes of</source>
        <translation>Innerhalb der Striche von</translation>
    </message>
    <message>
        <source>Outside strokes of</source>
        <translation>Außerhalb der Striche von</translation>
    </message>
    <message>
        <source>Slices of a texture, or one picture</source>
        <translation>Schnitte einer Textur oder ein Bild</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg)</translation>
    </message>
</context>
<context>
    <name>ductus::MotionBar</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Plays motion, drawings and camera path; again stops. Key Space.</source>
        <translation>Spielt Bewegung, Zeichnungen und Kamerafahrt ab; nochmals hält an. Leertaste.</translation>
    </message>
    <message>
        <source>Keep view</source>
        <translation>Ansicht behalten</translation>
    </message>
    <message>
        <source>Where you look from now becomes a key of the camera path, here in time.</source>
        <translation>Ihr jetziger Blick wird hier in der Zeit ein Keyframe der Kamerafahrt.</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Keyframe entfernen</translation>
    </message>
    <message>
        <source>Takes away the camera&apos;s key under the playhead.</source>
        <translation>Nimmt den Keyframe der Kamera an der Abspielposition weg.</translation>
    </message>
    <message>
        <source>Through the camera</source>
        <translation>Durch die Kamera</translation>
    </message>
    <message>
        <source>The view follows the camera path while time goes on.</source>
        <translation>Die Ansicht folgt der Kamerafahrt, während die Zeit läuft.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>After this time all begins again; 0: no loop.</source>
        <translation>Nach dieser Zeit beginnt alles von vorn; 0: keine Schleife.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>%1 / %2 s</source>
        <translation>%1 / %2 s</translation>
    </message>
</context>
<context>
    <name>ductus::MotionTracks</name>
    <message>
        <source>What moves</source>
        <translation>Was sich bewegt</translation>
    </message>
    <message>
        <source>Arm %1</source>
        <translation>%1 scharf stellen</translation>
    </message>
    <message>
        <source>While armed, what the transform tool drags becomes keys of all of it.</source>
        <translation>Solange scharf gestellt, wird alles, was das Transformationswerkzeug zieht, zu Keyframes des Ganzen.</translation>
    </message>
    <message>
        <source>Keys of %1</source>
        <translation>Keyframes von %1</translation>
    </message>
    <message>
        <source>Set key of %1</source>
        <translation>Keyframe für %1 setzen</translation>
    </message>
    <message>
        <source>Keeps where it is now as a key, here in time.</source>
        <translation>Behält, wo es jetzt ist, hier in der Zeit als Keyframe.</translation>
    </message>
    <message>
        <source>Remove key of %1</source>
        <translation>Keyframe von %1 entfernen</translation>
    </message>
    <message>
        <source>Takes away its key under the playhead.</source>
        <translation>Nimmt den Keyframe an der Abspielposition weg.</translation>
    </message>
</context>
<context>
    <name>ductus::PainterWindow</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>&amp;New painting</source>
        <translation>&amp;Neues Gemälde</translation>
    </message>
    <message>
        <source>Begins with an empty canvas and one stack.</source>
        <translation>Beginnt mit einer leeren Leinwand und einem Stapel.</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Opens a project, a Quill or .tilt painting, or a mesh.</source>
        <translation>Öffnet ein Projekt, ein Quill- oder .tilt-Gemälde oder ein Netz.</translation>
    </message>
    <message>
        <source>&amp;Import into painting...</source>
        <translation>In &amp;das Gemälde importieren...</translation>
    </message>
    <message>
        <source>The strokes of another painting or a mesh join this one; dropping a file does the same.</source>
        <translation>Die Striche eines anderen Gemäldes oder ein Netz kommen zu diesem hinzu; ebenso, wenn man eine Datei hereinzieht.</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Startseite</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the painting stays open.</source>
        <translation>Zeigt Beispiele und zuletzt geöffnete Dateien; das Gemälde bleibt offen.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>S&amp;peichern</translation>
    </message>
    <message>
        <source>Saves the painting with layers and looks.</source>
        <translation>Speichert das Gemälde mit Ebenen und Looks.</translation>
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
        <source>&amp;Export picture...</source>
        <translation>B&amp;ild exportieren...</translation>
    </message>
    <message>
        <source>Writes what the canvas shows as a PNG file.</source>
        <translation>Schreibt, was die Leinwand zeigt, als PNG-Datei.</translation>
    </message>
    <message>
        <source>Export &amp;film...</source>
        <translation>Fi&amp;lm exportieren...</translation>
    </message>
    <message>
        <source>A turntable, the camera path or the motion as MP4, WebM, GIF or pictures.</source>
        <translation>Eine Drehansicht, die Kamerafahrt oder die Bewegung als MP4, WebM, GIF oder Bilder.</translation>
    </message>
    <message>
        <source>Export &amp;mesh...</source>
        <translation>Netz &amp;exportieren...</translation>
    </message>
    <message>
        <source>A GLB file whose vertices have the colours of all layers, for the web.</source>
        <translation>Eine GLB-Datei, deren Punkte die Farben aller Ebenen haben, fürs Web.</translation>
    </message>
    <message>
        <source>Save action &amp;log...</source>
        <translation>A&amp;ktionsprotokoll speichern...</translation>
    </message>
    <message>
        <source>Everything done so far, a line each; layerpainter replay plays it again.</source>
        <translation>Alles bisher Getane, je eine Zeile; layerpainter replay spielt es wieder ab.</translation>
    </message>
    <message>
        <source>&amp;Delete strokes</source>
        <translation>&amp;Striche löschen</translation>
    </message>
    <message>
        <source>Takes the chosen strokes away.</source>
        <translation>Nimmt die gewählten Striche weg.</translation>
    </message>
    <message>
        <source>Copies of the chosen strokes in the active layer: how highlights and shadows are made.</source>
        <translation>Kopien der gewählten Striche in der aktiven Ebene: So entstehen Lichter und Schatten.</translation>
    </message>
    <message>
        <source>&amp;Move to layer</source>
        <translation>&amp;In die Ebene verschieben</translation>
    </message>
    <message>
        <source>The chosen strokes go into the active layer.</source>
        <translation>Die gewählten Striche kommen in die aktive Ebene.</translation>
    </message>
    <message>
        <source>Gives the chosen strokes the present colour.</source>
        <translation>Gibt den gewählten Strichen die jetzige Farbe.</translation>
    </message>
    <message>
        <source>Choose &amp;all of layer</source>
        <translation>&amp;Alles in der Ebene wählen</translation>
    </message>
    <message>
        <source>All strokes of the active layer.</source>
        <translation>Alle Striche der aktiven Ebene.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Forgets what was begun, then the choice, then the tool.</source>
        <translation>Vergisst Begonnenes, dann die Auswahl, dann das Werkzeug.</translation>
    </message>
    <message>
        <source>Add &amp;stack</source>
        <translation>&amp;Stapel hinzufügen</translation>
    </message>
    <message>
        <source>A new shape to paint on, with layers of its own.</source>
        <translation>Eine neue Form zum Bemalen, mit eigenen Ebenen.</translation>
    </message>
    <message>
        <source>Add &amp;layer</source>
        <translation>Ebene &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Its strokes colour the shape below them.</source>
        <translation>Ihre Striche färben die Form darunter.</translation>
    </message>
    <message>
        <source>&amp;Duplicate layer</source>
        <translation>Ebene &amp;duplizieren</translation>
    </message>
    <message>
        <source>A copy with all strokes, right above.</source>
        <translation>Eine Kopie mit allen Strichen, gleich darüber.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Another name for stack or layer.</source>
        <translation>Ein anderer Name für Stapel oder Ebene.</translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>Rückgängig holt sie zurück.</translation>
    </message>
    <message>
        <source>Back to the painting&apos;s own view.</source>
        <translation>Zurück zur eigenen Ansicht des Gemäldes.</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Bewegung</translation>
    </message>
    <message>
        <source>Shows the timeline of motion and camera.</source>
        <translation>Zeigt die Zeitleiste von Bewegung und Kamera.</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>Ab&amp;spielen</translation>
    </message>
    <message>
        <source>Plays motion, drawings and camera path; again stops.</source>
        <translation>Spielt Bewegung, Zeichnungen und Kamerafahrt ab; nochmals hält an.</translation>
    </message>
    <message>
        <source>&amp;Keep view as key</source>
        <translation>Ansicht als &amp;Keyframe behalten</translation>
    </message>
    <message>
        <source>Where you look from becomes a key of the camera path at the present time.</source>
        <translation>Ihr jetziger Blick wird ein Keyframe der Kamerafahrt zur jetzigen Zeit.</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>&amp;Größerer Pinsel</translation>
    </message>
    <message>
        <source>Wider strokes.</source>
        <translation>Breitere Striche.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>&amp;Smaller brush</source>
        <translation>&amp;Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>Finer strokes.</source>
        <translation>Feinere Striche.</translation>
    </message>
    <message>
        <source>&amp;Turn view</source>
        <translation>Ansicht &amp;drehen</translation>
    </message>
    <message>
        <source>Drag turns the view. With other tools: the right button.</source>
        <translation>Ziehen dreht die Ansicht. Mit anderen Werkzeugen: rechte Taste.</translation>
    </message>
    <message>
        <source>Drag to turn, wheel to zoom, middle button or Shift to pan.</source>
        <translation>Ziehen dreht, das Rad zoomt, mittlere Taste oder Umschalt verschiebt.</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>A click chooses a stroke, Shift adds, a drag chooses a box, with Ctrl a lasso.</source>
        <translation>Ein Klick wählt einen Strich, Umschalt fügt hinzu, Ziehen wählt ein Rechteck, mit Strg ein Lasso.</translation>
    </message>
    <message>
        <source>Click a stroke, or drag a box over strokes of the active layer. Ctrl+D copies them into the active layer.</source>
        <translation>Einen Strich anklicken oder ein Rechteck über Striche der aktiven Ebene ziehen. Strg+D kopiert sie in die aktive Ebene.</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>V&amp;erschieben</translation>
    </message>
    <message>
        <source>Moves, turns and scales the chosen strokes.</source>
        <translation>Verschiebt, dreht und skaliert die gewählten Striche.</translation>
    </message>
    <message>
        <source>Drag the chosen strokes; the ring turns them (with Shift upright), the square scales them.</source>
        <translation>Die gewählten Striche ziehen; der Ring dreht sie (mit Umschalt aufrecht), das Quadrat skaliert sie.</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>&amp;Malen</translation>
    </message>
    <message>
        <source>Paints into the active layer: a shape in stacks, colour in layers.</source>
        <translation>Malt in die aktive Ebene: in Stapeln eine Form, in Ebenen Farbe.</translation>
    </message>
    <message>
        <source>Paint on the surface or in the air. Shift draws straight, [ and ] change the size.</source>
        <translation>Auf der Fläche oder in der Luft malen. Umschalt zeichnet gerade, [ und ] ändern die Größe.</translation>
    </message>
    <message>
        <source>&amp;Erase</source>
        <translation>&amp;Radieren</translation>
    </message>
    <message>
        <source>Takes strokes of the active layer away; with Shift only the touched parts.</source>
        <translation>Nimmt Striche der aktiven Ebene weg; mit Umschalt nur die berührten Teile.</translation>
    </message>
    <message>
        <source>Drag over strokes of the active layer. With Shift only the touched parts go.</source>
        <translation>Über Striche der aktiven Ebene ziehen. Mit Umschalt verschwinden nur die berührten Teile.</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>Fades the active layer along a drag.</source>
        <translation>Blendet die aktive Ebene entlang eines Zuges aus.</translation>
    </message>
    <message>
        <source>Drag from where the layer is full to where it fades out. With Shift around a point.</source>
        <translation>Von dort ziehen, wo die Ebene voll ist, dorthin, wo sie ausläuft. Mit Umschalt um einen Punkt.</translation>
    </message>
    <message>
        <source>&amp;What colours this</source>
        <translation>&amp;Was färbt dies</translation>
    </message>
    <message>
        <source>A click lists the layers that colour a point.</source>
        <translation>Ein Klick listet die Ebenen auf, die einen Punkt färben.</translation>
    </message>
    <message>
        <source>Click on the painting: the list shows which layers colour this point, the topmost first.</source>
        <translation>Auf das Gemälde klicken: Die Liste zeigt, welche Ebenen diesen Punkt färben, die oberste zuerst.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Ebene</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinsel</translation>
    </message>
    <message>
        <source>There is nothing to export yet; paint or open something first.</source>
        <translation>Es gibt noch nichts zu exportieren; malen oder öffnen Sie zuerst etwas.</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exportieren von %1</translation>
    </message>
    <message>
        <source>Exported to %1, %2 x %3 pixels.</source>
        <translation>Exportiert nach %1, %2 x %3 Pixel.</translation>
    </message>
    <message>
        <source>There is nothing to film yet; paint or open something first.</source>
        <translation>Es gibt noch nichts zu filmen; malen oder öffnen Sie zuerst etwas.</translation>
    </message>
    <message>
        <source>Export film</source>
        <translation>Film exportieren</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Ordner (*)</translation>
    </message>
    <message>
        <source>The film %1 is ready.</source>
        <translation>Der Film %1 ist fertig.</translation>
    </message>
    <message numerus="yes">
        <source>%n films are ready.</source>
        <translation>
            <numerusform>%n Film ist fertig.</numerusform>
            <numerusform>%n Filme sind fertig.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Export mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>Meshes with colours (*.glb)</source>
        <translation>Netze mit Farben (*.glb)</translation>
    </message>
    <message>
        <source>Exported %L1 triangles with their colours to %2.</source>
        <translation>%L1 Dreiecke mit ihren Farben exportiert nach %2.</translation>
    </message>
    <message>
        <source>LayerPainter</source>
        <translation>LayerPainter</translation>
    </message>
    <message>
        <source>Light, shadow and mood for 3D paintings, layer by layer.</source>
        <translation>Licht, Schatten und Stimmung für 3D-Gemälde, Ebene für Ebene.</translation>
    </message>
    <message>
        <source>New painting</source>
        <translation>Neues Gemälde</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Öffnen...</translation>
    </message>
    <message>
        <source>Drop a Quill or .tilt painting, a mesh or a project anywhere.</source>
        <translation>Ziehen Sie ein Quill- oder .tilt-Gemälde, ein Netz oder ein Projekt irgendwohin.</translation>
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
        <source>Paintings and meshes (*.ductus *.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;All files (*)</source>
        <translation>Gemälde und Netze (*.ductus *.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lesen von %1</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Paintings and meshes (*.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Surfaces of SketchSurfacer (*.ductus)</source>
        <translation>Gemälde und Netze (*.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Flächen von SketchSurfacer (*.ductus)</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes joined the painting</source>
        <translation>
            <numerusform>%n Strich kam zum Gemälde hinzu</numerusform>
            <numerusform>%n Striche kamen zum Gemälde hinzu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n stacks.</source>
        <translation>
            <numerusform> in %n Stapel.</numerusform>
            <numerusform> in %n Stapeln.</numerusform>
        </translation>
    </message>
    <message>
        <source> Of drawings frame by frame the first came along.</source>
        <translation> Von Einzelbild-Zeichnungen kam die erste mit.</translation>
    </message>
    <message>
        <source>Some of it was skipped: %1</source>
        <translation>Ein Teil davon wurde übergangen: %1</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Und %n weiteres.</numerusform>
            <numerusform>Und %n weitere.</numerusform>
        </translation>
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
        <source>Save action log</source>
        <translation>Aktionsprotokoll speichern</translation>
    </message>
    <message>
        <source>Action logs (*.jsonl)</source>
        <translation>Aktionsprotokolle (*.jsonl)</translation>
    </message>
    <message numerus="yes">
        <source>The log of %n actions is saved.</source>
        <translation>
            <numerusform>Das Protokoll mit %n Aktion ist gespeichert.</numerusform>
            <numerusform>Das Protokoll mit %n Aktionen ist gespeichert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Choose strokes first; the copies go into the active layer.</source>
        <translation>Wählen Sie zuerst Striche; die Kopien kommen in die aktive Ebene.</translation>
    </message>
    <message>
        <source>&amp;Update surfaces</source>
        <translation>Flä&amp;chen aktualisieren</translation>
    </message>
    <message>
        <source>Takes what has changed in the sketches the surfaces were made from; your layers stay.</source>
        <translation>Übernimmt, was sich in den Skizzen der Flächen geändert hat; Ihre Ebenen bleiben.</translation>
    </message>
    <message>
        <source>&amp;Copy strokes</source>
        <translation>Striche &amp;kopieren</translation>
    </message>
    <message>
        <source>Puts the chosen strokes on the clipboard, for this app and the others of the suite.</source>
        <translation>Legt die gewählten Striche in die Zwischenablage, für dieses und die anderen Programme der Suite.</translation>
    </message>
    <message>
        <source>&amp;Paste strokes</source>
        <translation>S&amp;triche einfügen</translation>
    </message>
    <message>
        <source>Draws the strokes on the clipboard into the active layer, whichever app they come from.</source>
        <translation>Zeichnet die Striche der Zwischenablage in die aktive Ebene, aus welchem Programm sie auch kommen.</translation>
    </message>
    <message>
        <source>Send strokes to S&amp;ketchSurfacer</source>
        <translation>S&amp;triche an SketchSurfacer senden</translation>
    </message>
    <message>
        <source>Makes a sketch of the chosen strokes, or of the active layer, and opens it in SketchSurfacer.</source>
        <translation>Macht aus den gewählten Strichen oder der aktiven Ebene eine Skizze und öffnet sie in SketchSurfacer.</translation>
    </message>
    <message>
        <source>Send to &amp;DoodleStudio</source>
        <translation>&amp;An DoodleStudio senden</translation>
    </message>
    <message>
        <source>Opens DoodleStudio, where this painting can stand in a filmed scene.</source>
        <translation>Öffnet DoodleStudio, wo dieses Gemälde in einer gefilmten Szene stehen kann.</translation>
    </message>
    <message>
        <source>Choose strokes first: they are copied then.</source>
        <translation>Wählen Sie zuerst Striche: Sie werden dann kopiert.</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes copied.</source>
        <translation>
            <numerusform>%n Strich kopiert.</numerusform>
            <numerusform>%n Striche kopiert.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes pasted.</source>
        <translation>
            <numerusform>%n Strich eingefügt.</numerusform>
            <numerusform>%n Striche eingefügt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose strokes, or a layer with strokes: they become the sketch.</source>
        <translation>Wählen Sie Striche oder eine Ebene mit Strichen: Sie werden zur Skizze.</translation>
    </message>
    <message>
        <source>Save the sketch as</source>
        <translation>Skizze speichern unter</translation>
    </message>
    <message>
        <source> sketch</source>
        <translation> Skizze</translation>
    </message>
    <message>
        <source>sketch</source>
        <translation>Skizze</translation>
    </message>
    <message>
        <source>Writing the sketch</source>
        <translation>Schreiben der Skizze</translation>
    </message>
    <message>
        <source>There is nothing painted yet.</source>
        <translation>Es ist noch nichts gemalt.</translation>
    </message>
    <message>
        <source>DoodleStudio reads the saved painting, and this one has changes.</source>
        <translation>DoodleStudio liest das gespeicherte Gemälde, und dieses hat Änderungen.</translation>
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
        <source>DoodleStudio</source>
        <translation>DoodleStudio</translation>
    </message>
    <message>
        <source>SketchSurfacer</source>
        <translation>SketchSurfacer</translation>
    </message>
    <message>
        <source>%1 opens %2.</source>
        <translation>%1 öffnet %2.</translation>
    </message>
    <message>
        <source>The surface</source>
        <translation>Die Fläche</translation>
    </message>
    <message>
        <source>Looking for changes of the sketches</source>
        <translation>Suche nach Änderungen der Skizzen</translation>
    </message>
    <message>
        <source>No surface of this painting comes from a sketch.</source>
        <translation>Keine Fläche dieses Gemäldes stammt aus einer Skizze.</translation>
    </message>
    <message>
        <source>All surfaces are as their sketches are.</source>
        <translation>Alle Flächen entsprechen ihren Skizzen.</translation>
    </message>
    <message>
        <source>The surface of &quot;%1&quot; changed in SketchSurfacer.</source>
        <translation>Die Fläche von „%1“ hat sich in SketchSurfacer geändert.</translation>
    </message>
    <message numerus="yes">
        <source>%n surfaces changed in SketchSurfacer.</source>
        <translation>
            <numerusform>%n Fläche hat sich in SketchSurfacer geändert.</numerusform>
            <numerusform>%n Flächen haben sich in SketchSurfacer geändert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Update? Your layers, strokes and masks stay.</source>
        <translation>Aktualisieren? Ihre Ebenen, Striche und Masken bleiben.</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message numerus="yes">
        <source>%n surfaces are as in their sketches now.</source>
        <translation>
            <numerusform>%n Fläche entspricht jetzt ihrer Skizze.</numerusform>
            <numerusform>%n Flächen entsprechen jetzt ihren Skizzen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is open in another program: this painting is saved in a file of its own and stays linked to the surface.</source>
        <translation>%1 ist in einem anderen Programm geöffnet: Dieses Gemälde wird in einer eigenen Datei gespeichert und bleibt mit der Fläche verknüpft.</translation>
    </message>
    <message>
        <source>Duplicate &amp;into layer</source>
        <translation>In &amp;die Ebene duplizieren</translation>
    </message>
    <message>
        <source>Rec&amp;olour</source>
        <translation>&amp;Umfärben</translation>
    </message>
    <message>
        <source>D&amp;elete layer</source>
        <translation>&amp;Ebene löschen</translation>
    </message>
    <message>
        <source>Fr&amp;ame all</source>
        <translation>&amp;Alles einpassen</translation>
    </message>
</context>
<context>
    <name>ductus::PaintingDocument</name>
    <message>
        <source>Add stack</source>
        <translation>Stapel hinzufügen</translation>
    </message>
    <message>
        <source>Delete stack</source>
        <translation>Stapel löschen</translation>
    </message>
    <message>
        <source>Move stack</source>
        <translation>Stapel verschieben</translation>
    </message>
    <message>
        <source>Rename stack</source>
        <translation>Stapel umbenennen</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>Ebene löschen</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Ebene duplizieren</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>Ebene umbenennen</translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation>Ebene sperren</translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation>Ebene entsperren</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Ebene zeigen</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Ebene verbergen</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Deckkraft ändern</translation>
    </message>
    <message>
        <source>Change blend mode</source>
        <translation>Mischmodus ändern</translation>
    </message>
    <message>
        <source>Change masks</source>
        <translation>Masken ändern</translation>
    </message>
    <message>
        <source>Change layer colour</source>
        <translation>Ebenenfarbe ändern</translation>
    </message>
    <message>
        <source>Change tolerance</source>
        <translation>Toleranz ändern</translation>
    </message>
    <message>
        <source>Move layer in time</source>
        <translation>Ebene in der Zeit verschieben</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>Strich löschen</translation>
    </message>
    <message>
        <source>Delete %1 strokes</source>
        <translation>%1 Striche löschen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Move stroke to layer</source>
        <translation>Strich in Ebene verschieben</translation>
    </message>
    <message>
        <source>Move %1 strokes to layer</source>
        <translation>%1 Striche in Ebene verschieben</translation>
    </message>
    <message>
        <source>Duplicate stroke</source>
        <translation>Strich duplizieren</translation>
    </message>
    <message>
        <source>Duplicate %1 strokes</source>
        <translation>%1 Striche duplizieren</translation>
    </message>
    <message>
        <source>Move stroke</source>
        <translation>Strich verschieben</translation>
    </message>
    <message>
        <source>Move %1 strokes</source>
        <translation>%1 Striche verschieben</translation>
    </message>
    <message>
        <source>Recolour stroke</source>
        <translation>Strich umfärben</translation>
    </message>
    <message>
        <source>Recolour %1 strokes</source>
        <translation>%1 Striche umfärben</translation>
    </message>
    <message>
        <source>Add look</source>
        <translation>Look hinzufügen</translation>
    </message>
    <message>
        <source>Update look</source>
        <translation>Look aktualisieren</translation>
    </message>
    <message>
        <source>Switch look</source>
        <translation>Look wechseln</translation>
    </message>
    <message>
        <source>Rename look</source>
        <translation>Look umbenennen</translation>
    </message>
    <message>
        <source>Delete look</source>
        <translation>Look löschen</translation>
    </message>
    <message>
        <source>Change scene</source>
        <translation>Szene ändern</translation>
    </message>
    <message>
        <source>Change camera path</source>
        <translation>Kamerafahrt ändern</translation>
    </message>
    <message>
        <source>Add motion group</source>
        <translation>Bewegungsgruppe hinzufügen</translation>
    </message>
    <message>
        <source>Change motion</source>
        <translation>Bewegung ändern</translation>
    </message>
    <message>
        <source>Delete motion group</source>
        <translation>Bewegungsgruppe löschen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Update surface</source>
        <translation>Fläche aktualisieren</translation>
    </message>
</context>
<context>
    <name>ductus::PaintingView</name>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
</context>
<context>
    <name>ductus::PictureDialog</name>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> Pixel</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 Pixel</translation>
    </message>
    <message>
        <source>Without background</source>
        <translation>Ohne Hintergrund</translation>
    </message>
    <message>
        <source>&lt;b&gt;Without background&lt;/b&gt;&lt;br&gt;Where nothing is painted the picture is transparent, to be put on something else.</source>
        <translation>&lt;b&gt;Ohne Hintergrund&lt;/b&gt;&lt;br&gt;Wo nichts gemalt ist, bleibt das Bild durchsichtig, um es über etwas anderes zu legen.</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportieren...</translation>
    </message>
</context>
<context>
    <name>ductus::PointColours</name>
    <message>
        <source>Looking which layers colour this</source>
        <translation>Suche nach den färbenden Ebenen</translation>
    </message>
</context>
<context>
    <name>ductus::RoomPanels</name>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Brush and colour</source>
        <translation>Pinsel und Farbe</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>Linkshändig</translation>
    </message>
    <message>
        <source>The left hand paints, the right one holds the panels.</source>
        <translation>Die linke Hand malt, die rechte hält die Bedienfelder.</translation>
    </message>
    <message>
        <source>Leave VR</source>
        <translation>VR verlassen</translation>
    </message>
</context>
</TS>
