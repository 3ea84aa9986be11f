<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ductus::ActionSearch</name>
    <message>
        <source>Search actions</source>
        <translation>Aktionen suchen</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>Found actions</source>
        <translation>Gefundene Aktionen</translation>
    </message>
    <message>
        <source>Nothing is called like that.</source>
        <translation>Nichts heißt so.</translation>
    </message>
</context>
<context>
    <name>ductus::AppearancePage</name>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Dark or light, as the rest of your desktop.</source>
        <translation>Dunkel oder hell wie der übrige Desktop.</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Lets pictures and strokes stand out.</source>
        <translation>Bringt Bilder und Striche zur Geltung.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Easier to read in bright rooms and on projectors.</source>
        <translation>Leichter zu lesen in hellen Räumen und auf Projektoren.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Pictures you export do not depend on it.</source>
        <translation>Exportierte Bilder hängen nicht davon ab.</translation>
    </message>
    <message>
        <source>Takes effect when the app is started again.</source>
        <translation>Gilt ab dem nächsten Start des Programms.</translation>
    </message>
</context>
<context>
    <name>ductus::Autosave</name>
    <message>
        <source>Autosaving</source>
        <translation>Automatisches Speichern</translation>
    </message>
</context>
<context>
    <name>ductus::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>it was made by a newer version of Ductus</source>
        <translation>sie stammt aus einer neueren Version von Ductus</translation>
    </message>
</context>
<context>
    <name>ductus::DocumentFiles</name>
    <message>
        <source>the file may not be written</source>
        <translation>die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>%1 is open for reading only: %2. Save under another name to keep changes.</source>
        <translation>%1 ist nur zum Lesen geöffnet: %2. Speichern Sie unter einem anderen Namen, um Änderungen zu behalten.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Öffnen von %1</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>Lesen der Datei</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Speichern von %1</translation>
    </message>
    <message>
        <source>Writing the file</source>
        <translation>Schreiben der Datei</translation>
    </message>
</context>
<context>
    <name>ductus::EngineWords</name>
    <message>
        <source>Adding a group</source>
        <translation>Hinzufügen einer Gruppe</translation>
    </message>
    <message>
        <source>Adding a layer</source>
        <translation>Hinzufügen einer Ebene</translation>
    </message>
    <message>
        <source>Adding strokes</source>
        <translation>Hinzufügen von Strichen</translation>
    </message>
    <message>
        <source>Applying a scribble</source>
        <translation>Anwenden einer Kritzelei</translation>
    </message>
    <message>
        <source>Applying the look</source>
        <translation>Anwenden des Looks</translation>
    </message>
    <message>
        <source>Associating strokes</source>
        <translation>Zuordnen der Striche</translation>
    </message>
    <message>
        <source>Associating strokes with the proxy</source>
        <translation>Zuordnen der Striche zum Proxy</translation>
    </message>
    <message>
        <source>Attracting the proxy</source>
        <translation>Heranziehen des Proxys</translation>
    </message>
    <message>
        <source>Attracting the proxy to the strokes</source>
        <translation>Heranziehen des Proxys an die Striche</translation>
    </message>
    <message>
        <source>Baking the painting</source>
        <translation>Einbrennen der Farben</translation>
    </message>
    <message>
        <source>Changing how long the frame is shown</source>
        <translation>Ändern der Anzeigedauer</translation>
    </message>
    <message>
        <source>Changing the camera path</source>
        <translation>Ändern der Kamerafahrt</translation>
    </message>
    <message>
        <source>Changing the canvas</source>
        <translation>Ändern der Leinwand</translation>
    </message>
    <message>
        <source>Changing the keyframe</source>
        <translation>Ändern des Keyframes</translation>
    </message>
    <message>
        <source>Changing the layer</source>
        <translation>Ändern der Ebene</translation>
    </message>
    <message>
        <source>Changing the mark</source>
        <translation>Ändern des Gezeichneten</translation>
    </message>
    <message>
        <source>Changing the motion</source>
        <translation>Ändern der Bewegung</translation>
    </message>
    <message>
        <source>Changing the scene</source>
        <translation>Ändern der Szene</translation>
    </message>
    <message>
        <source>Changing the tolerance</source>
        <translation>Ändern der Toleranz</translation>
    </message>
    <message>
        <source>Checking the painting</source>
        <translation>Prüfen des Gemäldes</translation>
    </message>
    <message>
        <source>Checking the print</source>
        <translation>Druckprüfung</translation>
    </message>
    <message>
        <source>Checking the project</source>
        <translation>Prüfen des Projekts</translation>
    </message>
    <message>
        <source>Contouring the smooth surface</source>
        <translation>Konturieren der glatten Fläche</translation>
    </message>
    <message>
        <source>Cutting the stroke</source>
        <translation>Zerschneiden des Strichs</translation>
    </message>
    <message>
        <source>Discarding the recovered copy</source>
        <translation>Verwerfen der wiederhergestellten Kopie</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Drawing other readings</source>
        <translation>Zeichnen anderer Deutungen</translation>
    </message>
    <message>
        <source>Drawing the painting</source>
        <translation>Zeichnen des Gemäldes</translation>
    </message>
    <message>
        <source>Drawing the samples</source>
        <translation>Zeichnen der Beispiele</translation>
    </message>
    <message>
        <source>Drawing the surface</source>
        <translation>Zeichnen der Fläche</translation>
    </message>
    <message>
        <source>Duplicating strokes</source>
        <translation>Duplizieren von Strichen</translation>
    </message>
    <message>
        <source>Duplicating the layer</source>
        <translation>Duplizieren der Ebene</translation>
    </message>
    <message>
        <source>Entering VR</source>
        <translation>Wechsel in VR</translation>
    </message>
    <message>
        <source>Evening out the triangles</source>
        <translation>Ausgleichen der Dreiecke</translation>
    </message>
    <message>
        <source>Exporting the film</source>
        <translation>Exportieren des Films</translation>
    </message>
    <message>
        <source>Exporting the painting</source>
        <translation>Exportieren des Gemäldes</translation>
    </message>
    <message>
        <source>Exporting the surface</source>
        <translation>Exportieren der Fläche</translation>
    </message>
    <message>
        <source>Finding how far away things are</source>
        <translation>Bestimmen der Entfernungen</translation>
    </message>
    <message>
        <source>Finding how the camera moved</source>
        <translation>Bestimmen der Kamerabewegung</translation>
    </message>
    <message>
        <source>Finding how the scene moves</source>
        <translation>Bestimmen der Bewegung der Szene</translation>
    </message>
    <message>
        <source>Finding stroke normals</source>
        <translation>Bestimmen der Strichnormalen</translation>
    </message>
    <message>
        <source>Finding surface patches</source>
        <translation>Suche nach Flächenstücken</translation>
    </message>
    <message>
        <source>Finding what moves by itself</source>
        <translation>Suche nach selbst Bewegtem</translation>
    </message>
    <message>
        <source>Fitting a smooth surface</source>
        <translation>Anpassen einer glatten Fläche</translation>
    </message>
    <message>
        <source>Fitting a smooth surface piece by piece</source>
        <translation>Anpassen einer glatten Fläche Stück für Stück</translation>
    </message>
    <message>
        <source>Fitting a smooth surface through the strokes</source>
        <translation>Anpassen einer glatten Fläche an die Striche</translation>
    </message>
    <message>
        <source>Fitting changed strokes</source>
        <translation>Anpassen geänderter Striche</translation>
    </message>
    <message>
        <source>Fitting the final mesh</source>
        <translation>Anpassen des endgültigen Netzes</translation>
    </message>
    <message>
        <source>Fitting the surface</source>
        <translation>Anpassen der Fläche</translation>
    </message>
    <message>
        <source>Following the canvas</source>
        <translation>Verfolgen der Leinwand</translation>
    </message>
    <message>
        <source>Following the canvases</source>
        <translation>Verfolgen der Leinwände</translation>
    </message>
    <message>
        <source>Importing the painting</source>
        <translation>Importieren des Gemäldes</translation>
    </message>
    <message>
        <source>Importing the surface</source>
        <translation>Importieren der Fläche</translation>
    </message>
    <message>
        <source>Keeping what was found out about the clip</source>
        <translation>Aufbewahren der Clip-Analyse</translation>
    </message>
    <message>
        <source>Locking the project</source>
        <translation>Sperren des Projekts</translation>
    </message>
    <message>
        <source>Looking at the scene</source>
        <translation>Untersuchen der Szene</translation>
    </message>
    <message>
        <source>Looking for cables</source>
        <translation>Suche nach Kabeln</translation>
    </message>
    <message>
        <source>Looking for other readings</source>
        <translation>Suche nach anderen Deutungen</translation>
    </message>
    <message>
        <source>Looking which clip it is</source>
        <translation>Erkennen des Clips</translation>
    </message>
    <message>
        <source>Making a proxy</source>
        <translation>Erzeugen eines Proxys</translation>
    </message>
    <message>
        <source>Making a tube along a stroke</source>
        <translation>Erzeugen einer Röhre entlang eines Strichs</translation>
    </message>
    <message>
        <source>Making stacks of the layers</source>
        <translation>Bilden von Stapeln aus den Ebenen</translation>
    </message>
    <message>
        <source>Measuring how exact the points are</source>
        <translation>Messen der Punktgenauigkeit</translation>
    </message>
    <message>
        <source>Measuring walls</source>
        <translation>Messen der Wände</translation>
    </message>
    <message>
        <source>Moving strokes to a layer</source>
        <translation>Verschieben von Strichen in eine Ebene</translation>
    </message>
    <message>
        <source>Moving the canvas</source>
        <translation>Verschieben der Leinwand</translation>
    </message>
    <message>
        <source>Moving the canvas in depth</source>
        <translation>Verschieben der Leinwand in die Tiefe</translation>
    </message>
    <message>
        <source>Moving the keyframe</source>
        <translation>Verschieben des Keyframes</translation>
    </message>
    <message>
        <source>Moving the layer</source>
        <translation>Verschieben der Ebene</translation>
    </message>
    <message>
        <source>Moving the proxy to the changed strokes</source>
        <translation>Nachführen des Proxys zu den geänderten Strichen</translation>
    </message>
    <message>
        <source>Moving the stack</source>
        <translation>Verschieben des Stapels</translation>
    </message>
    <message>
        <source>Opening the clip</source>
        <translation>Öffnen des Clips</translation>
    </message>
    <message>
        <source>Opening the painting</source>
        <translation>Öffnen des Gemäldes</translation>
    </message>
    <message>
        <source>Opening the project</source>
        <translation>Öffnen des Projekts</translation>
    </message>
    <message>
        <source>Opening the sample</source>
        <translation>Öffnen des Beispiels</translation>
    </message>
    <message>
        <source>Painting in VR</source>
        <translation>Malen in VR</translation>
    </message>
    <message>
        <source>Pasting strokes</source>
        <translation>Einfügen von Strichen</translation>
    </message>
    <message>
        <source>Pinning the canvas</source>
        <translation>Anheften der Leinwand</translation>
    </message>
    <message>
        <source>Placing the canvas</source>
        <translation>Platzieren der Leinwand</translation>
    </message>
    <message>
        <source>Placing a painting</source>
        <translation>Platzieren eines Gemäldes</translation>
    </message>
    <message>
        <source>Preparing the frame</source>
        <translation>Vorbereiten des Bildes</translation>
    </message>
    <message>
        <source>Preparing the graphics card</source>
        <translation>Vorbereiten der Grafikkarte</translation>
    </message>
    <message>
        <source>Reading a texture</source>
        <translation>Lesen einer Textur</translation>
    </message>
    <message>
        <source>Reading the cameras</source>
        <translation>Lesen der Kameras</translation>
    </message>
    <message>
        <source>Reading the clip</source>
        <translation>Lesen des Clips</translation>
    </message>
    <message>
        <source>Reading the depth maps</source>
        <translation>Lesen der Tiefenkarten</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>Lesen des Netzes</translation>
    </message>
    <message>
        <source>Reading the painting</source>
        <translation>Lesen des Gemäldes</translation>
    </message>
    <message>
        <source>Reading the picture</source>
        <translation>Lesen des Bildes</translation>
    </message>
    <message>
        <source>Reading the points</source>
        <translation>Lesen der Punkte</translation>
    </message>
    <message>
        <source>Reading the project</source>
        <translation>Lesen des Projekts</translation>
    </message>
    <message>
        <source>Reading the proxy</source>
        <translation>Lesen des Proxys</translation>
    </message>
    <message>
        <source>Reading the sketch</source>
        <translation>Lesen der Skizze</translation>
    </message>
    <message>
        <source>Reading the sketch&apos;s size</source>
        <translation>Lesen der Größe der Skizze</translation>
    </message>
    <message>
        <source>Reading the sound</source>
        <translation>Lesen des Tons</translation>
    </message>
    <message>
        <source>Reading the sound of the clip</source>
        <translation>Lesen des Tons des Clips</translation>
    </message>
    <message>
        <source>Reading what was found out about the clip</source>
        <translation>Lesen der Clip-Analyse</translation>
    </message>
    <message>
        <source>Recolouring strokes</source>
        <translation>Umfärben von Strichen</translation>
    </message>
    <message>
        <source>Remeshing</source>
        <translation>Neuvernetzen</translation>
    </message>
    <message>
        <source>Removing strokes</source>
        <translation>Entfernen von Strichen</translation>
    </message>
    <message>
        <source>Removing the canvas</source>
        <translation>Entfernen der Leinwand</translation>
    </message>
    <message>
        <source>Removing the group</source>
        <translation>Entfernen der Gruppe</translation>
    </message>
    <message>
        <source>Removing the keyframe</source>
        <translation>Entfernen des Keyframes</translation>
    </message>
    <message>
        <source>Removing the layer</source>
        <translation>Entfernen der Ebene</translation>
    </message>
    <message>
        <source>Removing the look</source>
        <translation>Entfernen des Looks</translation>
    </message>
    <message>
        <source>Removing the stack</source>
        <translation>Entfernen des Stapels</translation>
    </message>
    <message>
        <source>Renaming the layer</source>
        <translation>Umbenennen der Ebene</translation>
    </message>
    <message>
        <source>Renaming the look</source>
        <translation>Umbenennen des Looks</translation>
    </message>
    <message>
        <source>Renaming the stack</source>
        <translation>Umbenennen des Stapels</translation>
    </message>
    <message>
        <source>Repairing the mesh</source>
        <translation>Reparieren des Netzes</translation>
    </message>
    <message>
        <source>Restoring the chosen reading</source>
        <translation>Wiederherstellen der gewählten Deutung</translation>
    </message>
    <message>
        <source>Saving the project</source>
        <translation>Speichern des Projekts</translation>
    </message>
    <message>
        <source>Segmenting the surface</source>
        <translation>Segmentieren der Fläche</translation>
    </message>
    <message>
        <source>Surfacing</source>
        <translation>Erzeugen der Fläche</translation>
    </message>
    <message>
        <source>Surfacing the points</source>
        <translation>Erzeugen der Fläche aus Punkten</translation>
    </message>
    <message>
        <source>Surfacing the sketch</source>
        <translation>Erzeugen der Fläche aus der Skizze</translation>
    </message>
    <message>
        <source>Trimming the open surface</source>
        <translation>Beschneiden der offenen Fläche</translation>
    </message>
    <message>
        <source>Turning the canvas</source>
        <translation>Drehen der Leinwand</translation>
    </message>
    <message>
        <source>Unpacking an entry of the project</source>
        <translation>Entpacken eines Projekteintrags</translation>
    </message>
    <message>
        <source>Uploading the painting</source>
        <translation>Laden des Gemäldes in die Grafikkarte</translation>
    </message>
    <message>
        <source>Wrapping the strokes</source>
        <translation>Umhüllen der Striche</translation>
    </message>
    <message>
        <source>Writing the action log</source>
        <translation>Schreiben des Aktionsprotokolls</translation>
    </message>
    <message>
        <source>Writing the film</source>
        <translation>Schreiben des Films</translation>
    </message>
    <message>
        <source>Writing the mesh</source>
        <translation>Schreiben des Netzes</translation>
    </message>
    <message>
        <source>Writing the picture</source>
        <translation>Schreiben des Bildes</translation>
    </message>
    <message>
        <source>Writing the project</source>
        <translation>Schreiben des Projekts</translation>
    </message>
    <message>
        <source>Writing the sound</source>
        <translation>Schreiben des Tons</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>die Datei lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>die Datei lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the memory does not suffice for it</source>
        <translation>der Speicher reicht dafür nicht</translation>
    </message>
    <message>
        <source>this is a PLY mesh</source>
        <translation>dies ist ein PLY-Netz</translation>
    </message>
    <message>
        <source>this is an OFF mesh</source>
        <translation>dies ist ein OFF-Netz</translation>
    </message>
    <message>
        <source>this is an STL mesh</source>
        <translation>dies ist ein STL-Netz</translation>
    </message>
    <message>
        <source>this is a GLB scene</source>
        <translation>dies ist eine GLB-Szene</translation>
    </message>
    <message>
        <source>this is a zip archive</source>
        <translation>dies ist ein Zip-Archiv</translation>
    </message>
    <message>
        <source>this is a PNG picture</source>
        <translation>dies ist ein PNG-Bild</translation>
    </message>
    <message>
        <source>this is JSON</source>
        <translation>dies ist JSON</translation>
    </message>
    <message>
        <source>there is no stroke in it</source>
        <translation>sie enthält keinen Strich</translation>
    </message>
    <message>
        <source>there is no sketch in it</source>
        <translation>es enthält keine Skizze</translation>
    </message>
    <message>
        <source>the project holds no painting</source>
        <translation>das Projekt enthält kein Gemälde</translation>
    </message>
    <message>
        <source>no stroke lies near the proxy mesh</source>
        <translation>kein Strich liegt nahe am Proxy-Netz</translation>
    </message>
    <message>
        <source>the sketch has too few strokes for a surface</source>
        <translation>die Skizze hat zu wenige Striche für eine Fläche</translation>
    </message>
    <message>
        <source>all strokes lie in one plane</source>
        <translation>alle Striche liegen in einer Ebene</translation>
    </message>
    <message>
        <source>the equations are singular</source>
        <translation>die Gleichungen sind singulär</translation>
    </message>
    <message>
        <source>no piece could be fitted</source>
        <translation>kein Stück ließ sich anpassen</translation>
    </message>
    <message>
        <source>the connection to the headset was lost</source>
        <translation>die Verbindung zum Headset ist abgebrochen</translation>
    </message>
    <message>
        <source>no headset is connected or it is switched off</source>
        <translation>kein Headset ist angeschlossen, oder es ist ausgeschaltet</translation>
    </message>
    <message>
        <source>there is no such stack</source>
        <translation>diesen Stapel gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such layer</source>
        <translation>diese Ebene gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such look</source>
        <translation>diesen Look gibt es nicht</translation>
    </message>
    <message>
        <source>it is not part of this installation</source>
        <translation>es gehört nicht zu dieser Installation</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Prüfen Sie den Pfad</translation>
    </message>
    <message>
        <source>Check the name</source>
        <translation>Prüfen Sie den Namen</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>Choose another folder, or make room on the disk</source>
        <translation>Wählen Sie einen anderen Ordner oder schaffen Sie Platz auf dem Datenträger</translation>
    </message>
    <message>
        <source>Make room on the disk</source>
        <translation>Schaffen Sie Platz auf dem Datenträger</translation>
    </message>
    <message>
        <source>Free some space and try again</source>
        <translation>Schaffen Sie Platz und versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>Choose a PNG or JPEG file</source>
        <translation>Wählen Sie eine PNG- oder JPEG-Datei</translation>
    </message>
    <message>
        <source>Choose a file with 3D strokes</source>
        <translation>Wählen Sie eine Datei mit 3D-Strichen</translation>
    </message>
    <message>
        <source>Choose a file with painted layers</source>
        <translation>Wählen Sie eine Datei mit bemalten Ebenen</translation>
    </message>
    <message>
        <source>Choose it again</source>
        <translation>Wählen Sie es erneut</translation>
    </message>
    <message>
        <source>Correct this line or export the file again</source>
        <translation>Berichtigen Sie diese Zeile oder exportieren Sie die Datei erneut</translation>
    </message>
    <message>
        <source>Correct this line or export the mesh again</source>
        <translation>Berichtigen Sie diese Zeile oder exportieren Sie das Netz erneut</translation>
    </message>
    <message>
        <source>Export the mesh again</source>
        <translation>Exportieren Sie das Netz erneut</translation>
    </message>
    <message>
        <source>Export the sketch again</source>
        <translation>Exportieren Sie die Skizze erneut</translation>
    </message>
    <message>
        <source>The file seems cut off: copy or export it again</source>
        <translation>Die Datei scheint abgeschnitten: Kopieren oder exportieren Sie sie erneut</translation>
    </message>
    <message>
        <source>Check that this is a text file</source>
        <translation>Prüfen Sie, ob dies eine Textdatei ist</translation>
    </message>
    <message>
        <source>Draw more strokes, or give a proxy mesh</source>
        <translation>Zeichnen Sie mehr Striche oder geben Sie ein Proxy-Netz an</translation>
    </message>
    <message>
        <source>Draw strokes in depth, or give a proxy mesh</source>
        <translation>Zeichnen Sie Striche in die Tiefe oder geben Sie ein Proxy-Netz an</translation>
    </message>
    <message>
        <source>Give a proxy mesh</source>
        <translation>Geben Sie ein Proxy-Netz an</translation>
    </message>
    <message>
        <source>Surface the whole sketch anew</source>
        <translation>Erzeugen Sie die ganze Fläche neu</translation>
    </message>
    <message>
        <source>Check that proxy and sketch have the same position, axes and scale</source>
        <translation>Prüfen Sie, ob Proxy und Skizze gleiche Lage, Achsen und Größe haben</translation>
    </message>
    <message>
        <source>Repair the mesh or export it again</source>
        <translation>Reparieren Sie das Netz oder exportieren Sie es erneut</translation>
    </message>
    <message>
        <source>Simplify the mesh first</source>
        <translation>Vereinfachen Sie zuerst das Netz</translation>
    </message>
    <message>
        <source>Save the project again in Quill</source>
        <translation>Speichern Sie das Projekt in Quill erneut</translation>
    </message>
    <message>
        <source>Open the previous version of the file, its name ends in ~</source>
        <translation>Öffnen Sie die vorige Fassung der Datei, ihr Name endet auf ~</translation>
    </message>
    <message>
        <source>Open it in the app that made it</source>
        <translation>Öffnen Sie es in dem Programm, das es erzeugt hat</translation>
    </message>
    <message>
        <source>Open it with the app it was made with</source>
        <translation>Öffnen Sie es mit dem Programm, das es erzeugt hat</translation>
    </message>
    <message>
        <source>Install a newer version of Ductus</source>
        <translation>Installieren Sie eine neuere Version von Ductus</translation>
    </message>
    <message>
        <source>Update the graphics driver</source>
        <translation>Aktualisieren Sie den Grafiktreiber</translation>
    </message>
    <message>
        <source>Update the headset software</source>
        <translation>Aktualisieren Sie die Headset-Software</translation>
    </message>
    <message>
        <source>Switch the headset on and try again</source>
        <translation>Schalten Sie das Headset ein und versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>The painting is still here; connect the headset and enter VR again</source>
        <translation>Das Gemälde ist noch da; schließen Sie das Headset an und wechseln Sie erneut in VR</translation>
    </message>
    <message>
        <source>Choose a stack of this painting</source>
        <translation>Wählen Sie einen Stapel dieses Gemäldes</translation>
    </message>
    <message>
        <source>Choose a look of this painting</source>
        <translation>Wählen Sie einen Look dieses Gemäldes</translation>
    </message>
    <message>
        <source>Close other programs or work on a smaller part</source>
        <translation>Schließen Sie andere Programme oder bearbeiten Sie einen kleineren Teil</translation>
    </message>
    <message>
        <source>Save your work and report this with the file</source>
        <translation>Speichern Sie Ihre Arbeit und melden Sie dies mit der Datei</translation>
    </message>
    <message>
        <source>Surface the sketch in SketchSurfacer and save it</source>
        <translation>Erzeugen Sie die Fläche in SketchSurfacer und speichern Sie sie</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Prüfen Sie seine Rechte</translation>
    </message>
    <message>
        <source>Choose a layer of this painting</source>
        <translation>Wählen Sie eine Ebene dieses Gemäldes</translation>
    </message>
    <message>
        <source>Choose a project that was saved in LayerPainter</source>
        <translation>Wählen Sie ein in LayerPainter gespeichertes Projekt</translation>
    </message>
    <message>
        <source>Choose a video that a player on this computer can show, or a folder of pictures</source>
        <translation>Wählen Sie ein Video, das dieser Rechner abspielen kann, oder einen Bilderordner</translation>
    </message>
    <message>
        <source>Choose a video, or a folder of JPEG or PNG pictures</source>
        <translation>Wählen Sie ein Video oder einen Ordner mit JPEG- oder PNG-Bildern</translation>
    </message>
    <message>
        <source>Choose another file, or convert it to MP4 (H.264)</source>
        <translation>Wählen Sie eine andere Datei oder wandeln Sie sie in MP4 (H.264) um</translation>
    </message>
    <message>
        <source>Close it there, or open it read-only</source>
        <translation>Schließen Sie es dort oder öffnen Sie es nur zum Lesen</translation>
    </message>
    <message>
        <source>Close the other program</source>
        <translation>Schließen Sie das andere Programm</translation>
    </message>
    <message>
        <source>Copy fewer strokes</source>
        <translation>Kopieren Sie weniger Striche</translation>
    </message>
    <message>
        <source>Copy strokes in an app of the suite first</source>
        <translation>Kopieren Sie zuerst Striche in einem Programm der Suite</translation>
    </message>
    <message>
        <source>Copy the file to another disk and try again</source>
        <translation>Kopieren Sie die Datei auf einen anderen Datenträger und versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>Draw it from border to border of a region, or closed up to a ring</source>
        <translation>Zeichnen Sie sie von Rand zu Rand einer Region oder zum Ring geschlossen</translation>
    </message>
    <message>
        <source>Free some space or save to another place</source>
        <translation>Schaffen Sie Platz oder speichern Sie an einem anderen Ort</translation>
    </message>
    <message>
        <source>Give a scale above zero</source>
        <translation>Geben Sie eine Größe über null an</translation>
    </message>
    <message>
        <source>Give a value inside its range</source>
        <translation>Geben Sie einen Wert innerhalb des Bereichs an</translation>
    </message>
    <message>
        <source>Go on with what was taken from it</source>
        <translation>Machen Sie mit dem Übernommenen weiter</translation>
    </message>
    <message>
        <source>Install and start the software of your headset, such as SteamVR or Monado, and make it the active OpenXR runtime</source>
        <translation>Installieren und starten Sie die Software Ihres Headsets, etwa SteamVR oder Monado, und machen Sie sie zur aktiven OpenXR-Runtime</translation>
    </message>
    <message>
        <source>Install it beside this one, or put its folder into PATH</source>
        <translation>Installieren Sie es neben diesem oder nehmen Sie seinen Ordner in PATH auf</translation>
    </message>
    <message>
        <source>Make it smaller</source>
        <translation>Machen Sie es kleiner</translation>
    </message>
    <message>
        <source>Make room on the disk or check the folder&apos;s permissions</source>
        <translation>Schaffen Sie Platz oder prüfen Sie die Rechte des Ordners</translation>
    </message>
    <message>
        <source>Mark the strokes along the border of the surface, and no others, as boundary</source>
        <translation>Markieren Sie die Striche am Rand der Fläche, und nur diese, als Rand</translation>
    </message>
    <message>
        <source>MP4 has no transparency</source>
        <translation>MP4 kennt keine Transparenz</translation>
    </message>
    <message>
        <source>No mirror plane was found; the whole sketch is surfaced.</source>
        <translation>Keine Spiegelebene gefunden; die ganze Skizze wird zur Fläche.</translation>
    </message>
    <message>
        <source>Open it read-only or save a copy elsewhere</source>
        <translation>Öffnen Sie es nur zum Lesen oder speichern Sie eine Kopie an anderem Ort</translation>
    </message>
    <message>
        <source>Put it back, or go on with what was taken from it</source>
        <translation>Legen Sie es zurück oder machen Sie mit dem Übernommenen weiter</translation>
    </message>
    <message>
        <source>Remove it as a whole</source>
        <translation>Entfernen Sie es im Ganzen</translation>
    </message>
    <message>
        <source>Remove that mask first</source>
        <translation>Entfernen Sie zuerst diese Maske</translation>
    </message>
    <message>
        <source>Remove the lock first</source>
        <translation>Heben Sie zuerst die Sperre auf</translation>
    </message>
    <message>
        <source>Remove the whole stack</source>
        <translation>Entfernen Sie den ganzen Stapel</translation>
    </message>
    <message>
        <source>Save it again</source>
        <translation>Speichern Sie es erneut</translation>
    </message>
    <message>
        <source>Save to another disk</source>
        <translation>Speichern Sie auf einem anderen Datenträger</translation>
    </message>
    <message>
        <source>Save to another place</source>
        <translation>Speichern Sie an einem anderen Ort</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Speichern Sie unter einem anderen Namen</translation>
    </message>
    <message>
        <source>Scale it less</source>
        <translation>Skalieren Sie weniger</translation>
    </message>
    <message>
        <source>Show a stack that has strokes</source>
        <translation>Zeigen Sie einen Stapel mit Strichen</translation>
    </message>
    <message>
        <source>Surface it in SketchSurfacer and save it</source>
        <translation>Erzeugen Sie die Fläche in SketchSurfacer und speichern Sie sie</translation>
    </message>
    <message>
        <source>Unlock it first</source>
        <translation>Entsperren Sie sie zuerst</translation>
    </message>
    <message>
        <source>a chosen stroke is not in the painting</source>
        <translation>ein gewählter Strich ist nicht im Gemälde</translation>
    </message>
    <message>
        <source>a stack has one substrate</source>
        <translation>ein Stapel hat einen Malgrund</translation>
    </message>
    <message>
        <source>a stroke would become too large or too small</source>
        <translation>ein Strich würde zu groß oder zu klein</translation>
    </message>
    <message>
        <source>a substrate stays with its stack</source>
        <translation>ein Malgrund bleibt bei seinem Stapel</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>alle Punkte liegen in einer Ebene</translation>
    </message>
    <message>
        <source>another program uses the headset</source>
        <translation>ein anderes Programm benutzt das Headset</translation>
    </message>
    <message>
        <source>every painting has a scene stack</source>
        <translation>jedes Gemälde hat einen Szenenstapel</translation>
    </message>
    <message>
        <source>it does not part a region</source>
        <translation>sie teilt keine Region</translation>
    </message>
    <message>
        <source>it has no finished surface now</source>
        <translation>es hat jetzt keine fertige Fläche</translation>
    </message>
    <message>
        <source>it is a mesh</source>
        <translation>es ist ein Netz</translation>
    </message>
    <message>
        <source>it is not in its project any more</source>
        <translation>es ist nicht mehr in seinem Projekt</translation>
    </message>
    <message>
        <source>it is not there any more</source>
        <translation>es ist nicht mehr da</translation>
    </message>
    <message>
        <source>it is the only one</source>
        <translation>es ist das einzige</translation>
    </message>
    <message>
        <source>it lies far from the surface</source>
        <translation>sie liegt fern von der Fläche</translation>
    </message>
    <message>
        <source>it lies in a locked region</source>
        <translation>sie liegt in einer gesperrten Region</translation>
    </message>
    <message>
        <source>it was made by a newer version of Ductus and may only be read</source>
        <translation>es stammt aus einer neueren Version von Ductus und darf nur gelesen werden</translation>
    </message>
    <message>
        <source>its project is not where it was</source>
        <translation>sein Projekt ist nicht mehr, wo es war</translation>
    </message>
    <message>
        <source>its size is not positive</source>
        <translation>seine Größe ist nicht positiv</translation>
    </message>
    <message>
        <source>no frame in it can be decoded</source>
        <translation>kein Bild darin lässt sich dekodieren</translation>
    </message>
    <message>
        <source>no headset software (OpenXR runtime) was found</source>
        <translation>es wurde keine Headset-Software (OpenXR-Runtime) gefunden</translation>
    </message>
    <message>
        <source>no layer of it holds strokes</source>
        <translation>keine seiner Ebenen enthält Striche</translation>
    </message>
    <message>
        <source>no stack of it is visible</source>
        <translation>keiner seiner Stapel ist sichtbar</translation>
    </message>
    <message>
        <source>the boundary strokes enclose nothing on the proxy</source>
        <translation>die Randstriche umschließen nichts auf dem Proxy</translation>
    </message>
    <message>
        <source>the clipboard holds no strokes</source>
        <translation>die Zwischenablage enthält keine Striche</translation>
    </message>
    <message>
        <source>the disk gives back other bytes than were written</source>
        <translation>der Datenträger gibt andere Bytes zurück als geschrieben</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>the film has no frames</source>
        <translation>der Film hat keine Bilder</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>der Ordner lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>the grid would be too fine</source>
        <translation>das Gitter würde zu fein</translation>
    </message>
    <message>
        <source>the headset software stopped</source>
        <translation>die Headset-Software wurde beendet</translation>
    </message>
    <message>
        <source>the layer has no such drawing</source>
        <translation>die Ebene hat diese Zeichnung nicht</translation>
    </message>
    <message>
        <source>the layer is locked</source>
        <translation>die Ebene ist gesperrt</translation>
    </message>
    <message>
        <source>the layers above colour it</source>
        <translation>die Ebenen darüber färben ihn</translation>
    </message>
    <message>
        <source>the memory ran out</source>
        <translation>der Speicher ist erschöpft</translation>
    </message>
    <message>
        <source>the painting has no strokes</source>
        <translation>das Gemälde hat keine Striche</translation>
    </message>
    <message>
        <source>the painting would have too many vertices</source>
        <translation>das Gemälde hätte zu viele Punkte</translation>
    </message>
    <message>
        <source>the pictures differ in size</source>
        <translation>die Bilder sind verschieden groß</translation>
    </message>
    <message>
        <source>the program does not start</source>
        <translation>das Programm startet nicht</translation>
    </message>
    <message>
        <source>the program is not installed</source>
        <translation>das Programm ist nicht installiert</translation>
    </message>
    <message>
        <source>the project holds no filmed scene</source>
        <translation>das Projekt enthält keine gefilmte Szene</translation>
    </message>
    <message>
        <source>the project holds no finished surface</source>
        <translation>das Projekt enthält keine fertige Fläche</translation>
    </message>
    <message>
        <source>the project is not where it was saved</source>
        <translation>das Projekt ist nicht mehr, wo es gespeichert wurde</translation>
    </message>
    <message>
        <source>the scene stack stays above all others</source>
        <translation>der Szenenstapel bleibt über allen anderen</translation>
    </message>
    <message>
        <source>the size or the checksum does not match, the file is damaged</source>
        <translation>Größe oder Prüfsumme stimmen nicht, die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the smooth surface does not end near the strokes</source>
        <translation>die glatte Fläche endet nicht bei den Strichen</translation>
    </message>
    <message>
        <source>the stroke is not in the painting</source>
        <translation>der Strich ist nicht im Gemälde</translation>
    </message>
    <message>
        <source>there are no pictures in this folder</source>
        <translation>in diesem Ordner sind keine Bilder</translation>
    </message>
    <message>
        <source>there are too many of them</source>
        <translation>es sind zu viele</translation>
    </message>
    <message>
        <source>there is already one in that frame</source>
        <translation>in diesem Bild ist schon einer</translation>
    </message>
    <message>
        <source>there is no video in it that can be decoded</source>
        <translation>sie enthält kein dekodierbares Video</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>für diese Datei reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>there is not enough memory to write the project</source>
        <translation>für das Schreiben des Projekts reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>this field is missing</source>
        <translation>dieses Feld fehlt</translation>
    </message>
    <message>
        <source>this is a container of another kind, not a Ductus project</source>
        <translation>dies ist ein anderer Container, kein Ductus-Projekt</translation>
    </message>
    <message>
        <source>this is not a Ductus project</source>
        <translation>dies ist kein Ductus-Projekt</translation>
    </message>
    <message>
        <source>this is not a file</source>
        <translation>dies ist keine Datei</translation>
    </message>
    <message>
        <source>this is not valid JSON</source>
        <translation>dies ist kein gültiges JSON</translation>
    </message>
    <message>
        <source>this picture cannot be decoded</source>
        <translation>dieses Bild lässt sich nicht dekodieren</translation>
    </message>
</context>
<context>
    <name>ductus::FoldingSection</name>
    <message>
        <source>%1, folded</source>
        <translation>%1, eingeklappt</translation>
    </message>
    <message>
        <source>%1, unfolded</source>
        <translation>%1, ausgeklappt</translation>
    </message>
</context>
<context>
    <name>ductus::HelpWindow</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>The manual is missing in this installation: %1.</source>
        <translation>In dieser Installation fehlt das Handbuch: %1.</translation>
    </message>
</context>
<context>
    <name>ductus::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
</context>
<context>
    <name>ductus::JobChip</name>
    <message>
        <source>Running jobs</source>
        <translation>Laufende Aufgaben</translation>
    </message>
    <message>
        <source>What is being worked on. Click for the list.</source>
        <translation>Woran gearbeitet wird. Ein Klick zeigt die Liste.</translation>
    </message>
    <message>
        <source>Cancel job</source>
        <translation>Aufgabe abbrechen</translation>
    </message>
    <message>
        <source>Stop this job; what was there before stays.</source>
        <translation>Hält diese Aufgabe an; was vorher da war, bleibt.</translation>
    </message>
</context>
<context>
    <name>ductus::JobPopup</name>
    <message>
        <source>Nothing is running.</source>
        <translation>Zurzeit läuft nichts.</translation>
    </message>
    <message>
        <source>Running jobs</source>
        <translation>Laufende Aufgaben</translation>
    </message>
</context>
<context>
    <name>ductus::JobRow</name>
    <message>
        <source>Stop this job; what was there before stays.</source>
        <translation>Hält diese Aufgabe an; was vorher da war, bleibt.</translation>
    </message>
    <message>
        <source>Cancel %1</source>
        <translation>Abbrechen: %1</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Wird angehalten</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
</context>
<context>
    <name>ductus::JobWords</name>
    <message>
        <source>a few seconds</source>
        <translation>ein paar Sekunden</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>etwa %1 min</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation>etwa %1 h</translation>
    </message>
    <message>
        <source>Stopping: %1</source>
        <translation>Wird angehalten: %1</translation>
    </message>
    <message>
        <source>Waiting: %1</source>
        <translation>Wartet: %1</translation>
    </message>
</context>
<context>
    <name>ductus::MainWindowShell</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>&amp;Inspector</source>
        <translation>&amp;Inspektor</translation>
    </message>
    <message>
        <source>Shows or hides the column at the right.</source>
        <translation>Zeigt oder verbirgt die Spalte rechts.</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>V&amp;erlauf</translation>
    </message>
    <message>
        <source>Lists all edits; a click goes back to one.</source>
        <translation>Listet alle Änderungen auf; ein Klick geht zu einer zurück.</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Leaves everything but this window away.</source>
        <translation>Lässt nur dieses Fenster auf dem Bildschirm.</translation>
    </message>
    <message>
        <source>Theme as the &amp;system</source>
        <translation>&amp;Farbschema des Systems</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>&amp;Dunkles Farbschema</translation>
    </message>
    <message>
        <source>&amp;Light theme</source>
        <translation>&amp;Helles Farbschema</translation>
    </message>
    <message>
        <source>Changes the colours of this app, not of your work.</source>
        <translation>Ändert die Farben des Programms, nicht die Ihrer Arbeit.</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>&amp;Einstellungen...</translation>
    </message>
    <message>
        <source>Theme, keys, tablet.</source>
        <translation>Farbschema, Tastenkürzel, Grafiktablett.</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Search actions...</source>
        <translation>&amp;Aktionen suchen...</translation>
    </message>
    <message>
        <source>Type what you want to do; Enter does it.</source>
        <translation>Eintippen, was zu tun ist; die Eingabetaste tut es.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>Opens the manual at what you are working with.</source>
        <translation>Öffnet das Handbuch bei dem, woran Sie arbeiten.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Closes this window; asks before anything is lost.</source>
        <translation>Schließt dieses Fenster; fragt, bevor etwas verloren geht.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Takes the last edit back.</source>
        <translation>Nimmt die letzte Änderung zurück.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Does again what was taken back.</source>
        <translation>Stellt wieder her, was zurückgenommen wurde.</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>A&amp;nsicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Tablet</source>
        <translation>Grafiktablett</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>Without saving, what you did since the last save is lost.</source>
        <translation>Ohne Speichern geht verloren, was seit dem letzten Speichern getan wurde.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard changes</source>
        <translation>Änderungen &amp;verwerfen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (schreibgeschützt)</translation>
    </message>
</context>
<context>
    <name>ductus::MessageBar</name>
    <message>
        <source>%1 failed: %2%3.</source>
        <translation>%1 fehlgeschlagen: %2%3.</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Close message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Diese Meldung schließen (Esc)</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n weitere</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>.</source>
        <comment>ends a sentence</comment>
        <translation>.</translation>
    </message>
</context>
<context>
    <name>ductus::PressureCurveEditor</name>
    <message>
        <source>Pressure curve</source>
        <translation>Druckkurve</translation>
    </message>
    <message>
        <source>Left and right choose a point, Ctrl with the arrow keys moves it.</source>
        <translation>Links und rechts wählen einen Punkt, Strg mit den Pfeiltasten verschiebt ihn.</translation>
    </message>
    <message>
        <source>Drag the points. Left: a light touch, right: pressed hard; up: counts more.</source>
        <translation>Punkte ziehen. Links: leichter Druck, rechts: fester; nach oben: zählt mehr.</translation>
    </message>
</context>
<context>
    <name>ductus::PressureTestField</name>
    <message>
        <source>Test field for the pen</source>
        <translation>Testfeld für den Stift</translation>
    </message>
    <message>
        <source>Draw here with your pen to try the curve.</source>
        <translation>Zeichnen Sie hier mit dem Stift, um die Kurve zu prüfen.</translation>
    </message>
</context>
<context>
    <name>ductus::RecentRow</name>
    <message>
        <source>%1, missing</source>
        <translation>%1, fehlt</translation>
    </message>
    <message>
        <source>not there any more</source>
        <translation>nicht mehr da</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Take off this list</source>
        <translation>&amp;Von dieser Liste nehmen</translation>
    </message>
</context>
<context>
    <name>ductus::RecoveryNotice</name>
    <message>
        <source>Today %1</source>
        <translation>Heute %1</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Nicht gespeicherte Arbeit</translation>
    </message>
    <message>
        <source>Unsaved work from last time</source>
        <translation>Nicht gespeicherte Arbeit vom letzten Mal</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Open the unsaved %1</source>
        <translation>Nicht gespeichertes %1 öffnen</translation>
    </message>
    <message>
        <source>Discard the unsaved %1</source>
        <translation>Nicht gespeichertes %1 verwerfen</translation>
    </message>
</context>
<context>
    <name>ductus::SampleWords</name>
    <message>
        <source>Saloon car</source>
        <translation>Limousine</translation>
    </message>
    <message>
        <source>Symmetric sketch with sharp shoulder, pillars and detail strokes: half is solved and mirrored.</source>
        <translation>Symmetrische Skizze mit scharfer Schulter, Säulen und Detailstrichen: Eine Hälfte wird berechnet und gespiegelt.</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>Flasche</translation>
    </message>
    <message>
        <source>Round shapes with sharp rings: a crease at the shoulder, none along the meridians.</source>
        <translation>Runde Formen mit scharfen Ringen: ein Knick an der Schulter, keiner entlang der Meridiane.</translation>
    </message>
    <message>
        <source>Box with a bevel</source>
        <translation>Kasten mit Fase</translation>
    </message>
    <message>
        <source>Flat faces meet in straight edges although every stroke is a little off.</source>
        <translation>Ebene Flächen treffen sich in geraden Kanten, obwohl jeder Strich ein wenig danebenliegt.</translation>
    </message>
    <message>
        <source>Folded leaf</source>
        <translation>Gefaltetes Blatt</translation>
    </message>
    <message>
        <source>An open shell: boundary strokes say where the surface ends, the midrib is a fold.</source>
        <translation>Eine offene Schale: Randstriche sagen, wo die Fläche endet, die Mittelrippe ist eine Falte.</translation>
    </message>
    <message>
        <source>Computer mouse</source>
        <translation>Computermaus</translation>
    </message>
    <message>
        <source>A smooth dome with a sharp belt: detail strokes lie on the surface and bend nothing.</source>
        <translation>Eine glatte Kuppel mit scharfem Gürtel: Detailstriche liegen auf der Fläche und verbiegen nichts.</translation>
    </message>
    <message>
        <source>Table lamp</source>
        <translation>Tischlampe</translation>
    </message>
    <message>
        <source>Thick and thin parts in one sketch: the stem needs a tight proxy.</source>
        <translation>Dicke und dünne Teile in einer Skizze: Der Fuß braucht einen straffen Proxy.</translation>
    </message>
    <message>
        <source>Iron with a handle</source>
        <translation>Bügeleisen mit Griff</translation>
    </message>
    <message>
        <source>A closed surface with a hole: the proxy must find the way through the handle.</source>
        <translation>Eine geschlossene Fläche mit Loch: Der Proxy muss den Weg durch den Griff finden.</translation>
    </message>
    <message>
        <source>Forest path</source>
        <translation>Waldweg</translation>
    </message>
    <message>
        <source>Two looks, day and dawn: light is a layer of strokes, mist a gradient.</source>
        <translation>Zwei Looks, Tag und Morgengrauen: Licht ist eine Ebene aus Strichen, Nebel ein Verlauf.</translation>
    </message>
    <message>
        <source>Over the clouds</source>
        <translation>Über den Wolken</translation>
    </message>
    <message>
        <source>Shadows are copies of strokes with tolerance; plane and shadow move as one.</source>
        <translation>Schatten sind Kopien von Strichen mit Toleranz; Flugzeug und Schatten bewegen sich gemeinsam.</translation>
    </message>
    <message>
        <source>Desk by day and night</source>
        <translation>Schreibtisch bei Tag und Nacht</translation>
    </message>
    <message>
        <source>A sunbeam through the window, a lamp for the night: one scene, two looks.</source>
        <translation>Ein Sonnenstrahl durchs Fenster, eine Lampe für die Nacht: eine Szene, zwei Looks.</translation>
    </message>
    <message>
        <source>Passing box</source>
        <translation>Vorbeiziehender Kasten</translation>
    </message>
    <message>
        <source>A face follows the box behind the post; words and arrow stay in the room.</source>
        <translation>Ein Gesicht folgt dem Kasten hinter den Pfosten; Text und Pfeil bleiben im Raum.</translation>
    </message>
    <message>
        <source>Walk through the room</source>
        <translation>Gang durch den Raum</translation>
    </message>
    <message>
        <source>Labels and stickers keep their place in the room while the camera walks in.</source>
        <translation>Beschriftungen und Sticker behalten ihren Platz, während die Kamera hineingeht.</translation>
    </message>
    <message>
        <source>One vase, three glazes</source>
        <translation>Eine Vase, drei Glasuren</translation>
    </message>
    <message>
        <source>Ornament is painted once; looks give every layer another colour.</source>
        <translation>Das Ornament ist einmal gemalt; Looks geben jeder Ebene eine andere Farbe.</translation>
    </message>
    <message>
        <source>Campfire</source>
        <translation>Lagerfeuer</translation>
    </message>
    <message>
        <source>Flames are five drawings shown in turn; night and firelight are gradients.</source>
        <translation>Flammen sind fünf Zeichnungen im Wechsel; Nacht und Feuerschein sind Verläufe.</translation>
    </message>
    <message>
        <source>Lighthouse</source>
        <translation>Leuchtturm</translation>
    </message>
    <message>
        <source>Noise makes foam and crests, the beam is clear paint that turns.</source>
        <translation>Rauschen macht Schaum und Kämme, der Strahl ist helle Farbe, die sich dreht.</translation>
    </message>
    <message>
        <source>Koi pond</source>
        <translation>Koiteich</translation>
    </message>
    <message>
        <source>Spots reach no further than the fish they touch; shadows swim along.</source>
        <translation>Flecken reichen nicht weiter als der Fisch, den sie berühren; Schatten schwimmen mit.</translation>
    </message>
    <message>
        <source>Pendulum</source>
        <translation>Pendel</translation>
    </message>
    <message>
        <source>A still camera; the arrow rides on the bob and is drawn anew twelve times a swing.</source>
        <translation>Eine stille Kamera; der Pfeil sitzt auf dem Pendelkörper und ist zwölfmal je Schwung neu gezeichnet.</translation>
    </message>
    <message>
        <source>Chalk in the yard</source>
        <translation>Kreide im Hof</translation>
    </message>
    <message>
        <source>Canvases lie on the ground and on the wall and keep their perspective as the camera goes by.</source>
        <translation>Leinwände liegen auf dem Boden und an der Wand und behalten ihre Perspektive, während die Kamera vorbeizieht.</translation>
    </message>
    <message>
        <source>A ghost in the store</source>
        <translation>Ein Gespenst im Lager</translation>
    </message>
    <message>
        <source>Six drawings in a loop; keyframes carry them around the post and behind the boxes.</source>
        <translation>Sechs Zeichnungen in einer Schleife; Keyframes führen sie um den Pfosten und hinter die Kisten.</translation>
    </message>
    <message>
        <source>Over the hills</source>
        <translation>Über die Hügel</translation>
    </message>
    <message>
        <source>The camera only turns: birds fly by keyframes, one of them behind the house.</source>
        <translation>Die Kamera dreht sich nur: Vögel fliegen nach Keyframes, einer davon hinter dem Haus.</translation>
    </message>
</context>
<context>
    <name>ductus::SegmentedSwitch</name>
    <message>
        <source>Hold the key to peek.</source>
        <translation>Taste halten, um kurz hinzusehen.</translation>
    </message>
</context>
<context>
    <name>ductus::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>ductus::ShortcutsPage</name>
    <message>
        <source>&amp;Use it here instead</source>
        <translation>Stattdessen &amp;hier verwenden</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Standard</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keines</translation>
    </message>
    <message>
        <source>Filter by name or keys</source>
        <translation>Nach Name oder Tasten filtern</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>Aktionen und ihre Tastenkürzel</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Neues Tastenkürzel</translation>
    </message>
    <message>
        <source>Click here and press the new keys.</source>
        <translation>Hier klicken und die neuen Tasten drücken.</translation>
    </message>
    <message>
        <source>Conflict</source>
        <translation>Konflikt</translation>
    </message>
    <message>
        <source>Default keys</source>
        <translation>Standardkürzel</translation>
    </message>
    <message>
        <source>No keys</source>
        <translation>Kein Tastenkürzel</translation>
    </message>
    <message>
        <source>Use it here instead</source>
        <translation>Stattdessen hier verwenden</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Sonstige</translation>
    </message>
    <message>
        <source>%1 is taken by: %2.</source>
        <translation>%1 gehört schon zu: %2.</translation>
    </message>
</context>
<context>
    <name>ductus::StartPage</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnete Dateien</translation>
    </message>
    <message>
        <source>Or drop a file anywhere in this window.</source>
        <translation>Oder eine Datei irgendwo in dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>Files you open will be listed here.</source>
        <translation>Geöffnete Dateien werden hier aufgeführt.</translation>
    </message>
</context>
<context>
    <name>ductus::TabletPage</name>
    <message>
        <source>&amp;Straight line</source>
        <translation>&amp;Gerade Linie</translation>
    </message>
    <message>
        <source>&amp;Clean field</source>
        <translation>&amp;Feld leeren</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Ausprobieren</translation>
    </message>
    <message>
        <source>Raise the left part if you press lightly, lower it if you press hard. The other end of the pen erases.</source>
        <translation>Den linken Teil anheben, wenn Sie leicht drücken, senken, wenn Sie fest drücken. Das andere Ende des Stifts radiert.</translation>
    </message>
    <message>
        <source>Straight line</source>
        <translation>Gerade Linie</translation>
    </message>
    <message>
        <source>Clean field</source>
        <translation>Feld leeren</translation>
    </message>
</context>
<context>
    <name>ductus::ToolRail</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
</context>
<context>
    <name>ductus::TopRow</name>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>All menus</source>
        <translation>Alle Menüs</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Aktionen suchen</translation>
    </message>
</context>
<context>
    <name>ductus::UndoPanel</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Close history</source>
        <translation>Verlauf schließen</translation>
    </message>
    <message>
        <source>Close the history</source>
        <translation>Den Verlauf schließen</translation>
    </message>
    <message>
        <source>History of edits</source>
        <translation>Verlauf der Änderungen</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Wie geöffnet</translation>
    </message>
</context>
<context>
    <name>ductus::UnsavedWork</name>
    <message>
        <source>Looking for unsaved work</source>
        <translation>Suche nach nicht gespeicherter Arbeit</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Öffnen von %1</translation>
    </message>
</context>
</TS>
