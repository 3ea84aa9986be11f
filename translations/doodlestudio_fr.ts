<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>DirectDrawTool</name>
    <message>
        <source>Canvas %1</source>
        <translation>Toile %1</translation>
    </message>
    <message>
        <source>Add canvas</source>
        <translation>Ajouter une toile</translation>
    </message>
</context>
<context>
    <name>OcclusionTool</name>
    <message>
        <source>Bring in front</source>
        <translation>Passer devant</translation>
    </message>
    <message>
        <source>Put behind</source>
        <translation>Passer derrière</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasFollower</name>
    <message>
        <source>Following the canvas</source>
        <translation>Suivi de la toile</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasList</name>
    <message>
        <source>Canvases</source>
        <translation>Toiles</translation>
    </message>
    <message>
        <source>Duplicate canvas</source>
        <translation>Dupliquer la toile</translation>
    </message>
    <message>
        <source>A second canvas with the same drawings, beside this one.</source>
        <translation>Une seconde toile avec les mêmes dessins, à côté de celle-ci.</translation>
    </message>
    <message>
        <source>Take canvas away</source>
        <translation>Retirer la toile</translation>
    </message>
    <message>
        <source>Takes the canvas and its drawings away.</source>
        <translation>Retire la toile et ses dessins.</translation>
    </message>
    <message>
        <source>Show canvas</source>
        <translation>Afficher la toile</translation>
    </message>
    <message>
        <source>Hide canvas</source>
        <translation>Masquer la toile</translation>
    </message>
    <message>
        <source>Rename canvas</source>
        <translation>Renommer la toile</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 copie</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasPanel</name>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Immobile</translation>
    </message>
    <message>
        <source>The canvas stands still in the scene; only the camera moves past it.</source>
        <translation>La toile reste immobile dans la scène ; seule la caméra passe devant.</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Suit</translation>
    </message>
    <message>
        <source>The canvas follows what is under its middle.</source>
        <translation>La toile suit ce qui se trouve sous son milieu.</translation>
    </message>
    <message>
        <source>Pin here</source>
        <translation>Épingler ici</translation>
    </message>
    <message>
        <source>Holds the canvas where it is in this frame. In between it follows.</source>
        <translation>Maintient la toile là où elle est dans cette image. Entre deux épingles, elle suit.</translation>
    </message>
    <message>
        <source>Straight to the next pin</source>
        <translation>Droit jusqu’à la prochaine épingle</translation>
    </message>
    <message>
        <source>From the pin before this frame to the one after it the canvas goes straight and evenly instead of following what is seen: for where it is hidden too long.</source>
        <translation>De l’épingle précédente à la suivante, la toile va en ligne droite et régulière au lieu de suivre ce qu’on voit : pour là où elle est cachée trop longtemps.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>How far the canvas is from the camera. Nearer things hide it.</source>
        <translation>La distance de la toile à la caméra. Ce qui est plus proche la cache.</translation>
    </message>
    <message>
        <source>Distance from the scene</source>
        <translation>Distance prise de la scène</translation>
    </message>
    <message>
        <source>As far as what is under the middle of the canvas.</source>
        <translation>Aussi loin que ce qui est sous le milieu de la toile.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>The size of the canvas; its corner on the picture does the same.</source>
        <translation>La taille de la toile ; son coin sur l’image fait de même.</translation>
    </message>
    <message>
        <source>Face the camera</source>
        <translation>Face à la caméra</translation>
    </message>
    <message>
        <source>Turns the canvas straight to the camera in this frame.</source>
        <translation>Tourne la toile droit vers la caméra dans cette image.</translation>
    </message>
    <message>
        <source>How it turns while it follows</source>
        <translation>Comment elle tourne en suivant</translation>
    </message>
    <message>
        <source>What the canvas does between the frames in which you turned it.</source>
        <translation>Ce que fait la toile entre les images où vous l’avez tournée.</translation>
    </message>
    <message>
        <source>Turns with the way it goes</source>
        <translation>Tourne avec son trajet</translation>
    </message>
    <message>
        <source>Keeps its direction</source>
        <translation>Garde sa direction</translation>
    </message>
    <message>
        <source>Turns with the thing it is on</source>
        <translation>Tourne avec l’objet</translation>
    </message>
    <message>
        <source>Keeps its direction relative to its path, as a sign on a tram does in a bend.</source>
        <translation>Garde sa direction par rapport à son trajet, comme un panneau sur un tram dans un virage.</translation>
    </message>
    <message>
        <source>Looks where you turned it to, whatever happens.</source>
        <translation>Regarde là où vous l’avez tournée, quoi qu’il arrive.</translation>
    </message>
    <message>
        <source>Turns as the picture turns around its middle, as a hat does on a dancer.</source>
        <translation>Tourne comme l’image tourne autour de son milieu, comme un chapeau sur un danseur.</translation>
    </message>
    <message>
        <source>Change turning</source>
        <translation>Modifier la rotation</translation>
    </message>
    <message>
        <source>Hidden by what is in front</source>
        <translation>Caché par ce qui est devant</translation>
    </message>
    <message>
        <source>Nearer things cover the canvas. Off: it is always seen.</source>
        <translation>Ce qui est plus proche couvre la toile. Désactivé : elle est toujours visible.</translation>
    </message>
    <message>
        <source>Let the scene hide the canvas</source>
        <translation>Laisser la scène cacher la toile</translation>
    </message>
    <message>
        <source>Show the canvas always</source>
        <translation>Toujours montrer la toile</translation>
    </message>
    <message>
        <source>Depth play</source>
        <translation>Jeu de profondeur</translation>
    </message>
    <message>
        <source>More: the canvas shows through what is only a little nearer.</source>
        <translation>Plus : la toile transparaît à travers ce qui n’est qu’un peu plus proche.</translation>
    </message>
    <message>
        <source>Change depth play</source>
        <translation>Modifier le jeu de profondeur</translation>
    </message>
    <message>
        <source>In front here</source>
        <translation>Devant ici</translation>
    </message>
    <message>
        <source>Brush over the picture where the canvas must be seen.</source>
        <translation>Peignez sur l’image là où la toile doit être visible.</translation>
    </message>
    <message>
        <source>Behind here</source>
        <translation>Derrière ici</translation>
    </message>
    <message>
        <source>Brush over the picture where the canvas must be hidden.</source>
        <translation>Peignez sur l’image là où la toile doit être cachée.</translation>
    </message>
    <message>
        <source>Forget what was brushed</source>
        <translation>Oublier les retouches</translation>
    </message>
    <message>
        <source>Only the distance decides again what hides the canvas.</source>
        <translation>Seule la distance décide à nouveau de ce qui cache la toile.</translation>
    </message>
    <message>
        <source>Forget the brush</source>
        <translation>Oublier les retouches</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>How much of the film shows through the drawing.</source>
        <translation>Combien le film transparaît à travers le dessin.</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Changer l’opacité</translation>
    </message>
    <message>
        <source>Let canvas follow</source>
        <translation>Faire suivre la toile</translation>
    </message>
    <message>
        <source>Let canvas stay</source>
        <translation>Immobiliser la toile</translation>
    </message>
    <message>
        <source>Pin canvas</source>
        <translation>Épingler la toile</translation>
    </message>
    <message>
        <source>Go straight</source>
        <translation>Aller en ligne droite</translation>
    </message>
    <message>
        <source>Follow the scene</source>
        <translation>Suivre la scène</translation>
    </message>
    <message>
        <source>Change distance</source>
        <translation>Changer la distance</translation>
    </message>
    <message>
        <source>Size canvas</source>
        <translation>Redimensionner la toile</translation>
    </message>
    <message>
        <source>Drag out a box on the picture: a canvas to draw on will stand there.</source>
        <translation>Tracez un cadre sur l’image : une toile où dessiner s’y placera.</translation>
    </message>
    <message>
        <source>Choose a canvas above or on the picture, or drag out a box for another one.</source>
        <translation>Choisissez une toile ci-dessus ou sur l’image, ou tracez un cadre pour une autre.</translation>
    </message>
    <message>
        <source>Pin it here and follow</source>
        <translation>Épingler ici et suivre</translation>
    </message>
    <message>
        <source>Stands still in the scene.</source>
        <translation>Immobile dans la scène.</translation>
    </message>
    <message numerus="yes">
        <source>Pinned in %n frame(s); drag it where it drifts.</source>
        <translation>
            <numerusform>Épinglée dans %n image ; faites-la glisser là où elle dérive.</numerusform>
            <numerusform>Épinglée dans %n images ; faites-la glisser là où elle dérive.</numerusform>
        </translation>
    </message>
    <message>
        <source>Following...</source>
        <translation>Suivi en cours...</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingHand</name>
    <message>
        <source>Erase</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Move drawing</source>
        <translation>Déplacer le dessin</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dessiner</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplir</translation>
    </message>
    <message>
        <source>Draw arrow</source>
        <translation>Dessiner une flèche</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Écrire</translation>
    </message>
    <message>
        <source>Add sticker</source>
        <translation>Ajouter un autocollant</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingPanel</name>
    <message>
        <source>Pen</source>
        <translation>Stylo</translation>
    </message>
    <message>
        <source>Draws lines; a pen&apos;s pressure makes them wider. (P)</source>
        <translation>Trace des lignes ; la pression du stylet les élargit. (P)</translation>
    </message>
    <message>
        <source>Filled shape</source>
        <translation>Forme pleine</translation>
    </message>
    <message>
        <source>Draw an outline; what is inside is filled. (G)</source>
        <translation>Tracez un contour ; l’intérieur est rempli. (G)</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Flèche</translation>
    </message>
    <message>
        <source>Points at something; draw it as you like. (A)</source>
        <translation>Montre quelque chose ; tracez-la comme vous voulez. (A)</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand. (T)</source>
        <translation>Tapez du texte, puis cliquez là où il doit être. (T)</translation>
    </message>
    <message>
        <source>Sticker</source>
        <translation>Autocollant</translation>
    </message>
    <message>
        <source>Ready-made drawings; drag to say how large. (S)</source>
        <translation>Des dessins tout prêts ; glissez pour donner la taille. (S)</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Gomme</translation>
    </message>
    <message>
        <source>Takes parts of lines away. (E)</source>
        <translation>Enlève des parties de lignes. (E)</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Moves something that was drawn. (V)</source>
        <translation>Déplace quelque chose de dessiné. (V)</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Picture. Puts a picture from a file on the canvas; move it with V.</source>
        <translation>Image. Place une image d’un fichier sur la toile ; déplacez-la avec V.</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand</source>
        <translation>Tapez du texte, puis cliquez là où il doit être</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanc</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Noir</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Jaune</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Vert</translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation>Cyan</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violet</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>Rose</translation>
    </message>
    <message>
        <source>Another colour</source>
        <translation>Autre couleur</translation>
    </message>
    <message>
        <source>Another colour...</source>
        <translation>Autre couleur...</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Of the line, as a share of the canvas. Keys [ and ].</source>
        <translation>De la ligne, en part de la toile. Touches [ et ].</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>How much of the film is seen below the drawing.</source>
        <translation>Combien on voit du film sous le dessin.</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Écrire</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.gif *.svg)</source>
        <translation>Images (*.png *.jpg *.jpeg *.bmp *.gif *.svg)</translation>
    </message>
    <message>
        <source>Insert picture</source>
        <translation>Insérer une image</translation>
    </message>
    <message>
        <source>seen from behind</source>
        <translation>vu de derrière</translation>
    </message>
    <message>
        <source>seen from the side: another frame is better</source>
        <translation>vu de côté : une autre image convient mieux</translation>
    </message>
    <message>
        <source>star</source>
        <translation>étoile</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>cœur</translation>
    </message>
    <message>
        <source>check</source>
        <translation>coche</translation>
    </message>
    <message>
        <source>cross</source>
        <translation>croix</translation>
    </message>
    <message>
        <source>smile</source>
        <translation>sourire</translation>
    </message>
    <message>
        <source>frown</source>
        <translation>moue</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>anneau</translation>
    </message>
    <message>
        <source>bubble</source>
        <translation>bulle</translation>
    </message>
    <message>
        <source>bang</source>
        <translation>exclamation</translation>
    </message>
    <message>
        <source>question</source>
        <translation>interrogation</translation>
    </message>
    <message>
        <source>bulb</source>
        <translation>ampoule</translation>
    </message>
    <message>
        <source>bolt</source>
        <translation>éclair</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingView</name>
    <message>
        <source>Drawing</source>
        <translation>Dessin</translation>
    </message>
    <message>
        <source>Draw straight on the picture: a canvas is made where you begin.
Or choose a canvas to see it from the front.</source>
        <translation>Dessinez directement sur l’image : une toile se crée là où vous commencez.
Ou choisissez une toile pour la voir de face.</translation>
    </message>
</context>
<context>
    <name>ductus::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Choisir...</translation>
    </message>
    <message>
        <source>With the sound of the clip</source>
        <translation>Avec le son du clip</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Montrer dans le dossier</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message numerus="yes">
        <source>%1, about %n s left</source>
        <translation>
            <numerusform>%1, encore %n s environ</numerusform>
            <numerusform>%1, encore %n s environ</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Share</source>
        <translation>&amp;Partager</translation>
    </message>
    <message>
        <source>A film with your drawings (MP4). Plays everywhere: phone, web, projector.</source>
        <translation>Un film avec vos dessins (MP4). Lu partout : téléphone, web, projecteur.</translation>
    </message>
    <message>
        <source>S&amp;lides</source>
        <translation>&amp;Diapositives</translation>
    </message>
    <message>
        <source>A moving picture (GIF) for slides and worksheets. No sound.</source>
        <translation>Une image animée (GIF) pour diapositives et fiches. Sans son.</translation>
    </message>
    <message>
        <source>&amp;Overlay</source>
        <translation>&amp;Superposition</translation>
    </message>
    <message>
        <source>Your drawings alone, see-through (WebM), to lay over the clip in another program.</source>
        <translation>Vos dessins seuls, transparents (WebM), à poser sur le clip dans un autre programme.</translation>
    </message>
    <message>
        <source>%1 with drawings</source>
        <translation>%1 avec dessins</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it, or choose another name.</source>
        <translation>%1 existe déjà. Remplacez-le ou choisissez un autre nom.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Export de %1</translation>
    </message>
    <message numerus="yes">
        <source>Done: %1 (%2 x %3, %n frame(s))</source>
        <translation>
            <numerusform>Terminé : %1 (%2 x %3, %n image)</numerusform>
            <numerusform>Terminé : %1 (%2 x %3, %n images)</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Annulé ; rien n’a été écrit.</translation>
    </message>
    <message>
        <source>It could not be exported: %1</source>
        <translation>L’export a échoué : %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>ductus::FrameStrip</name>
    <message>
        <source>Onion skin</source>
        <translation>Pelure d’oignon</translation>
    </message>
    <message>
        <source>Onion skin (O). The drawings before shine through in red, those after in blue.</source>
        <translation>Pelure d’oignon (O). Les dessins précédents transparaissent en rouge, les suivants en bleu.</translation>
    </message>
    <message>
        <source>Drawings that shine through</source>
        <translation>Dessins qui transparaissent</translation>
    </message>
    <message>
        <source>How many drawings before and after shine through.</source>
        <translation>Combien de dessins avant et après transparaissent.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Tenue</translation>
    </message>
    <message>
        <source>Video frames this drawing is held</source>
        <translation>Images vidéo pendant lesquelles ce dessin reste</translation>
    </message>
    <message>
        <source>For how many frames of the film this drawing is seen.</source>
        <translation>Pendant combien d’images du film ce dessin est visible.</translation>
    </message>
    <message>
        <source>After the last drawing</source>
        <translation>Après le dernier dessin</translation>
    </message>
    <message>
        <source>What comes after the last drawing.</source>
        <translation>Ce qui vient après le dernier dessin.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>En boucle</translation>
    </message>
    <message>
        <source>There and back</source>
        <translation>Aller et retour</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Une fois</translation>
    </message>
    <message>
        <source>Keep the last</source>
        <translation>Garder le dernier</translation>
    </message>
    <message>
        <source>Hold drawing</source>
        <translation>Tenir le dessin</translation>
    </message>
    <message>
        <source>Change repeat</source>
        <translation>Changer la répétition</translation>
    </message>
    <message>
        <source>Add drawing</source>
        <translation>Ajouter un dessin</translation>
    </message>
    <message>
        <source>Duplicate drawing</source>
        <translation>Dupliquer le dessin</translation>
    </message>
    <message>
        <source>Take drawing away</source>
        <translation>Retirer le dessin</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>Dessin %1</translation>
    </message>
    <message>
        <source>Add drawing. An empty one after this: draw the next moment on it.</source>
        <translation>Ajouter un dessin. Un dessin vide après celui-ci : dessinez-y l’instant suivant.</translation>
    </message>
    <message numerus="yes">
        <source>Drawing %1, held for %n frame(s)</source>
        <translation>
            <numerusform>Dessin %1, tenu %n image</numerusform>
            <numerusform>Dessin %1, tenu %n images</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::HandlesTool</name>
    <message>
        <source>Drag the canvas where it must be in this frame: it is pinned there.</source>
        <translation>Faites glisser la toile là où elle doit être dans cette image : elle y est épinglée.</translation>
    </message>
    <message>
        <source>Drag the canvas where it should stand.</source>
        <translation>Faites glisser la toile là où elle doit se tenir.</translation>
    </message>
    <message>
        <source>Drag to make the canvas larger or smaller.</source>
        <translation>Glissez pour agrandir ou réduire la toile.</translation>
    </message>
    <message>
        <source>Drag to turn the canvas in its plane.</source>
        <translation>Glissez pour tourner la toile dans son plan.</translation>
    </message>
    <message>
        <source>Drag the pin of the gauge: the canvas looks where the pin points.</source>
        <translation>Tirez la tige du repère : la toile regarde là où elle pointe.</translation>
    </message>
    <message>
        <source>Click to go to this moment, drag to pin the canvas elsewhere then.</source>
        <translation>Cliquez pour aller à cet instant, glissez pour y épingler la toile ailleurs.</translation>
    </message>
    <message>
        <source>Click to choose this canvas.</source>
        <translation>Cliquez pour choisir cette toile.</translation>
    </message>
    <message>
        <source>Drag out a box: a canvas will stand there in the scene.</source>
        <translation>Tracez un cadre : une toile s’y tiendra dans la scène.</translation>
    </message>
    <message>
        <source>Pin canvas</source>
        <translation>Épingler la toile</translation>
    </message>
    <message>
        <source>Move canvas</source>
        <translation>Déplacer la toile</translation>
    </message>
    <message>
        <source>Size canvas</source>
        <translation>Redimensionner la toile</translation>
    </message>
    <message>
        <source>Turn canvas</source>
        <translation>Tourner la toile</translation>
    </message>
    <message>
        <source>Tilt canvas</source>
        <translation>Incliner la toile</translation>
    </message>
    <message>
        <source>Canvas %1</source>
        <translation>Toile %1</translation>
    </message>
    <message>
        <source>Add canvas</source>
        <translation>Ajouter une toile</translation>
    </message>
</context>
<context>
    <name>ductus::PlayerView</name>
    <message>
        <source>Player</source>
        <translation>Lecteur</translation>
    </message>
</context>
<context>
    <name>ductus::StudioWindow</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Ouvrir...</translation>
    </message>
    <message>
        <source>Opens a clip, a folder of pictures or a project.</source>
        <translation>Ouvre un clip, un dossier d’images ou un projet.</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Page d’accueil</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the clip stays open.</source>
        <translation>Montre exemples et fichiers récents ; le clip reste ouvert.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>E&amp;nregistrer</translation>
    </message>
    <message>
        <source>Saves what was drawn and where; the clip itself stays where it is.</source>
        <translation>Enregistre ce qui est dessiné et où ; le clip lui-même reste où il est.</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Enregistrer &amp;sous...</translation>
    </message>
    <message>
        <source>Saves under another name and goes on there.</source>
        <translation>Enregistre sous un autre nom et continue là.</translation>
    </message>
    <message>
        <source>&amp;Pack the analysis</source>
        <translation>&amp;Inclure l’analyse</translation>
    </message>
    <message>
        <source>Saves how the scene moves in the project as well, so that it opens at once on another computer. Makes the file larger.</source>
        <translation>Enregistre aussi dans le projet comment la scène bouge, pour qu’il s’ouvre aussitôt sur un autre ordinateur. Alourdit le fichier.</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exporter...</translation>
    </message>
    <message>
        <source>Makes a film, a moving picture for slides, or an overlay.</source>
        <translation>Crée un film, une image animée pour diapositives, ou une superposition.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Runs the clip in a loop, or stops it.</source>
        <translation>Joue le clip en boucle, ou l’arrête.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>Image &amp;précédente</translation>
    </message>
    <message>
        <source>Goes to the frame before.</source>
        <translation>Va à l’image précédente.</translation>
    </message>
    <message>
        <source>One frame &amp;on</source>
        <translation>I&amp;mage suivante</translation>
    </message>
    <message>
        <source>Goes to the next frame.</source>
        <translation>Va à l’image suivante.</translation>
    </message>
    <message>
        <source>Goes to the first frame.</source>
        <translation>Va à la première image.</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>À la &amp;fin</translation>
    </message>
    <message>
        <source>Goes to the last frame.</source>
        <translation>Va à la dernière image.</translation>
    </message>
    <message>
        <source>Play back&amp;wards</source>
        <translation>Lire &amp;en arrière</translation>
    </message>
    <message>
        <source>Runs the clip backwards; again: faster.</source>
        <translation>Joue le clip en arrière ; de nouveau : plus vite.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>Stops the clip.</source>
        <translation>Arrête le clip.</translation>
    </message>
    <message>
        <source>Play &amp;forwards</source>
        <translation>L&amp;ire en avant</translation>
    </message>
    <message>
        <source>Runs the clip; again: faster.</source>
        <translation>Joue le clip ; de nouveau : plus vite.</translation>
    </message>
    <message>
        <source>So&amp;und</source>
        <translation>&amp;Son</translation>
    </message>
    <message>
        <source>Lets the clip be heard while it runs.</source>
        <translation>Fait entendre le clip pendant la lecture.</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Toile</translation>
    </message>
    <message>
        <source>&amp;Follow what is here</source>
        <translation>Suivre &amp;ce qui est ici</translation>
    </message>
    <message>
        <source>Pins the canvas to what is under its middle; it follows from then on.</source>
        <translation>Épingle la toile à ce qui est sous son milieu ; dès lors elle le suit.</translation>
    </message>
    <message>
        <source>S&amp;tay here</source>
        <translation>&amp;Rester ici</translation>
    </message>
    <message>
        <source>Lets the canvas stand still in the scene where it is now.</source>
        <translation>Laisse la toile immobile dans la scène, là où elle est.</translation>
    </message>
    <message>
        <source>Face the &amp;camera</source>
        <translation>&amp;Face à la caméra</translation>
    </message>
    <message>
        <source>Turns the canvas straight to the camera in this frame.</source>
        <translation>Tourne la toile droit vers la caméra dans cette image.</translation>
    </message>
    <message>
        <source>&amp;Next keyframe</source>
        <translation>&amp;Image clé suivante</translation>
    </message>
    <message>
        <source>Goes to the next frame in which the canvas is pinned, turned or sized.</source>
        <translation>Va à la prochaine image où la toile est épinglée, tournée ou redimensionnée.</translation>
    </message>
    <message>
        <source>&amp;Previous keyframe</source>
        <translation>Image clé &amp;précédente</translation>
    </message>
    <message>
        <source>Goes to the keyframe before.</source>
        <translation>Va à l’image clé précédente.</translation>
    </message>
    <message>
        <source>&amp;Duplicate canvas</source>
        <translation>&amp;Dupliquer la toile</translation>
    </message>
    <message>
        <source>A second canvas with the same drawings, beside this one.</source>
        <translation>Une seconde toile avec les mêmes dessins, à côté de celle-ci.</translation>
    </message>
    <message>
        <source>Takes the canvas and its drawings away.</source>
        <translation>Retire la toile et ses dessins.</translation>
    </message>
    <message>
        <source>&amp;Look at the scene again</source>
        <translation>Réanalyser la &amp;scène</translation>
    </message>
    <message>
        <source>Finds anew how the camera and all else moves; drawings stay.</source>
        <translation>Retrouve comment bougent la caméra et tout le reste ; les dessins restent.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Interrompre</translation>
    </message>
    <message>
        <source>Gives up what was begun; then the choice.</source>
        <translation>Abandonne ce qui était commencé, puis le choix.</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dessiner</translation>
    </message>
    <message>
        <source>&amp;Pen</source>
        <translation>&amp;Stylo</translation>
    </message>
    <message>
        <source>Draws lines.</source>
        <translation>Trace des lignes.</translation>
    </message>
    <message>
        <source>&amp;Filled shape</source>
        <translation>For&amp;me pleine</translation>
    </message>
    <message>
        <source>Draw an outline; what is inside is filled.</source>
        <translation>Tracez un contour ; l’intérieur est rempli.</translation>
    </message>
    <message>
        <source>&amp;Arrow</source>
        <translation>&amp;Flèche</translation>
    </message>
    <message>
        <source>Points at something.</source>
        <translation>Montre quelque chose.</translation>
    </message>
    <message>
        <source>&amp;Words</source>
        <translation>&amp;Texte</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand.</source>
        <translation>Tapez du texte, puis cliquez là où il doit être.</translation>
    </message>
    <message>
        <source>&amp;Sticker</source>
        <translation>&amp;Autocollant</translation>
    </message>
    <message>
        <source>Ready-made drawings.</source>
        <translation>Des dessins tout prêts.</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>&amp;Gomme</translation>
    </message>
    <message>
        <source>Takes parts of lines away.</source>
        <translation>Enlève des parties de lignes.</translation>
    </message>
    <message>
        <source>&amp;Move a drawing</source>
        <translation>Déplacer u&amp;n dessin</translation>
    </message>
    <message>
        <source>Moves something that was drawn.</source>
        <translation>Déplace quelque chose de dessiné.</translation>
    </message>
    <message>
        <source>W&amp;ider brush</source>
        <translation>&amp;Pinceau plus large</translation>
    </message>
    <message>
        <source>Makes the brush wider.</source>
        <translation>Élargit le pinceau.</translation>
    </message>
    <message>
        <source>&amp;Narrower brush</source>
        <translation>P&amp;inceau plus fin</translation>
    </message>
    <message>
        <source>Makes the brush narrower.</source>
        <translation>Affine le pinceau.</translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation>Pe&amp;lure d’oignon</translation>
    </message>
    <message>
        <source>The drawings before shine through in red, those after in blue.</source>
        <translation>Les dessins précédents transparaissent en rouge, les suivants en bleu.</translation>
    </message>
    <message>
        <source>A&amp;dd drawing</source>
        <translation>A&amp;jouter un dessin</translation>
    </message>
    <message>
        <source>An empty drawing after this one: the next moment of an animation.</source>
        <translation>Un dessin vide après celui-ci : l’instant suivant d’une animation.</translation>
    </message>
    <message>
        <source>D&amp;uplicate drawing</source>
        <translation>D&amp;upliquer le dessin</translation>
    </message>
    <message>
        <source>A copy of this drawing after it, to be changed a little.</source>
        <translation>Une copie de ce dessin après lui, à modifier un peu.</translation>
    </message>
    <message>
        <source>Take drawing awa&amp;y</source>
        <translation>&amp;Retirer le dessin</translation>
    </message>
    <message>
        <source>Takes the present drawing out of the animation.</source>
        <translation>Retire le dessin actuel de l’animation.</translation>
    </message>
    <message>
        <source>Ne&amp;xt drawing</source>
        <translation>&amp;Dessin suivant</translation>
    </message>
    <message>
        <source>Goes to the next drawing of the canvas.</source>
        <translation>Va au dessin suivant de la toile.</translation>
    </message>
    <message>
        <source>P&amp;revious drawing</source>
        <translation>D&amp;essin précédent</translation>
    </message>
    <message>
        <source>Goes to the drawing before.</source>
        <translation>Va au dessin précédent.</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>&amp;Toile</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>D&amp;essiner</translation>
    </message>
    <message>
        <source>Looking at the scene</source>
        <translation>Analyse de la scène</translation>
    </message>
    <message>
        <source>How the scene moves was not in the cache any more and was found again.</source>
        <translation>Le mouvement de la scène n’était plus dans le cache et a été recalculé.</translation>
    </message>
    <message>
        <source>What was found out is kept in the project, as the cache cannot be used: %1</source>
        <translation>Les résultats sont gardés dans le projet, car le cache est inutilisable : %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>The scene was not looked at to the end.</source>
        <translation>L’analyse de la scène n’est pas allée jusqu’au bout.</translation>
    </message>
    <message>
        <source>Canvases cannot follow what moves until it is; it goes on where it was.</source>
        <translation>D’ici là, les toiles ne peuvent pas suivre ce qui bouge ; l’analyse reprend où elle en était.</translation>
    </message>
    <message>
        <source>Look at the scene</source>
        <translation>Analyser la scène</translation>
    </message>
    <message>
        <source>The clip is too long for that: its analysis has %1 megabytes.</source>
        <translation>Le clip est trop long pour cela : son analyse occupe %1 mégaoctets.</translation>
    </message>
    <message>
        <source>DoodleStudio</source>
        <translation>DoodleStudio</translation>
    </message>
    <message>
        <source>Draw into a filmed scene, so that it stays where you put it.</source>
        <translation>Dessinez dans une scène filmée : le dessin reste là où vous le mettez.</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Ouvrir...</translation>
    </message>
    <message>
        <source>Drop a clip, a folder of pictures or a project anywhere.</source>
        <translation>Déposez n’importe où un clip, un dossier d’images ou un projet.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Clips and projects (*.ductus %1);;All files (*)</source>
        <translation>Clips et projets (*.ductus %1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>Find the clip...</source>
        <translation>Retrouver le clip...</translation>
    </message>
    <message>
        <source>Looking where %1 is now</source>
        <translation>Recherche de l’endroit où se trouve %1</translation>
    </message>
    <message>
        <source>The clip was moved and is found again: %1</source>
        <translation>Le clip a été déplacé et a été retrouvé : %1</translation>
    </message>
    <message>
        <source>The clip has the frames and the size of the one this was drawn on, but it is another file.</source>
        <translation>Le clip a le nombre d’images et la taille de celui sur lequel on a dessiné, mais c’est un autre fichier.</translation>
    </message>
    <message>
        <source>If it does not show the same scene, find the right one.</source>
        <translation>S’il ne montre pas la même scène, cherchez le bon.</translation>
    </message>
    <message>
        <source>The clip is another one than this was drawn on.</source>
        <translation>Ce n’est pas le clip sur lequel ceci a été dessiné.</translation>
    </message>
    <message>
        <source>Its number of frames or its size differ.</source>
        <translation>Son nombre d’images ou sa taille diffèrent.</translation>
    </message>
    <message>
        <source>The clip %1 is not where it was.</source>
        <translation>Le clip %1 n’est plus à sa place.</translation>
    </message>
    <message>
        <source>Show where it is now: everything drawn is kept.</source>
        <translation>Indiquez où il est maintenant : tout ce qui est dessiné est conservé.</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Où est %1 ?</translation>
    </message>
    <message>
        <source>Clips (%1);;All files (*)</source>
        <translation>Clips (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Reading the sound</source>
        <translation>Lecture du son</translation>
    </message>
    <message>
        <source>Open a clip first; its film can be exported then.</source>
        <translation>Ouvrez d’abord un clip ; son film pourra alors être exporté.</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Exporté vers %1.</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>Ductus projects (*.ductus)</source>
        <translation>Projets Ductus (*.ductus)</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Enregistrer sous...</translation>
    </message>
    <message>
        <source>&amp;Write down what I do</source>
        <translation>&amp;Noter ce que je fais</translation>
    </message>
    <message>
        <source>Every step and command with its time, from now on; nothing leaves this computer.</source>
        <translation>Chaque étape et commande avec son heure, à partir de maintenant ; rien ne quitte cet ordinateur.</translation>
    </message>
    <message>
        <source>Nothing was written down.</source>
        <translation>Rien n’a été noté.</translation>
    </message>
    <message>
        <source>What you do is written down from now on. Edit &gt; Save what I did keeps it.</source>
        <translation>Ce que vous faites est noté à partir de maintenant. Édition &gt; Enregistrer ce que j’ai fait le conserve.</translation>
    </message>
    <message>
        <source>Save what I &amp;did...</source>
        <translation>&amp;Enregistrer ce que j’ai fait...</translation>
    </message>
    <message>
        <source>A line of JSON for every step: when, what, on which canvas, in which frame.</source>
        <translation>Une ligne JSON par étape : quand, quoi, sur quelle toile, dans quelle image.</translation>
    </message>
    <message>
        <source>Save what I did</source>
        <translation>Enregistrer ce que j’ai fait</translation>
    </message>
    <message>
        <source>Action logs (*.jsonl)</source>
        <translation>Journaux d’actions (*.jsonl)</translation>
    </message>
    <message numerus="yes">
        <source>%n act(s) written to %1.</source>
        <translation>
            <numerusform>%n action écrite dans %1.</numerusform>
            <numerusform>%n actions écrites dans %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>1  Place</source>
        <translation>1  Placer</translation>
    </message>
    <message>
        <source>Put a canvas where the drawing should be.</source>
        <translation>Placez une toile là où le dessin doit être.</translation>
    </message>
    <message>
        <source>2  Pin</source>
        <translation>2  Épingler</translation>
    </message>
    <message>
        <source>Say where the canvas must be; it follows in between.</source>
        <translation>Dites où la toile doit être ; entre-temps elle suit.</translation>
    </message>
    <message>
        <source>3  Draw</source>
        <translation>3  Dessiner</translation>
    </message>
    <message>
        <source>Draw on the canvas, seen from the front.</source>
        <translation>Dessinez sur la toile, vue de face.</translation>
    </message>
    <message>
        <source>Canvases</source>
        <translation>Toiles</translation>
    </message>
    <message>
        <source>This canvas</source>
        <translation>Cette toile</translation>
    </message>
    <message>
        <source>Brush where the canvas must be seen; it counts in the frames around, too.</source>
        <translation>Peignez là où la toile doit être visible ; cela vaut aussi pour les images voisines.</translation>
    </message>
    <message>
        <source>Brush where the canvas must be hidden; it counts in the frames around, too.</source>
        <translation>Peignez là où la toile doit être cachée ; cela vaut aussi pour les images voisines.</translation>
    </message>
    <message>
        <source>Move keyframe</source>
        <translation>Déplacer l’image clé</translation>
    </message>
    <message>
        <source>Take keyframe away</source>
        <translation>Retirer l’image clé</translation>
    </message>
    <message>
        <source>Go &amp;straight to the next keyframe</source>
        <translation>&amp;Aller droit à l’image clé suivante</translation>
    </message>
    <message>
        <source>Go straight</source>
        <translation>Aller en ligne droite</translation>
    </message>
    <message>
        <source>Follow the scene</source>
        <translation>Suivre la scène</translation>
    </message>
    <message>
        <source>&amp;Take keyframe away</source>
        <translation>&amp;Retirer l’image clé</translation>
    </message>
    <message>
        <source>Drag out a box on the picture: a canvas will stand there in the scene.</source>
        <translation>Tracez un cadre sur l’image : une toile s’y tiendra dans la scène.</translation>
    </message>
    <message>
        <source>Go to a frame where the canvas is wrong and drag it back: it is pinned there.</source>
        <translation>Allez à une image où la toile est mal placée et remettez-la en place : elle y est épinglée.</translation>
    </message>
    <message>
        <source>Draw on the canvas from the front, or straight on the picture.</source>
        <translation>Dessinez sur la toile vue de face, ou directement sur l’image.</translation>
    </message>
    <message>
        <source>The scene is being looked at; you can place and draw already.</source>
        <translation>La scène est en cours d’analyse ; vous pouvez déjà placer et dessiner.</translation>
    </message>
    <message>
        <source>The camera&apos;s way was found: canvases stand firmly in the scene.</source>
        <translation>Le trajet de la caméra est trouvé : les toiles tiennent solidement dans la scène.</translation>
    </message>
    <message>
        <source>Positions and distances were measured from how the picture shifts.</source>
        <translation>Positions et distances ont été mesurées d’après le décalage de l’image.</translation>
    </message>
    <message>
        <source>The camera turns on the spot: distances are guessed.</source>
        <translation>La caméra tourne sur place : les distances sont estimées.</translation>
    </message>
    <message>
        <source>Set the distance of a canvas by hand where it hides or shows wrongly.</source>
        <translation>Réglez à la main la distance d’une toile là où elle se cache ou se montre à tort.</translation>
    </message>
    <message>
        <source>The camera stands still: distances are guessed.</source>
        <translation>La caméra est immobile : les distances sont estimées.</translation>
    </message>
    <message>
        <source>Place a pa&amp;inting...</source>
        <translation>Placer &amp;une peinture...</translation>
    </message>
    <message>
        <source>Stands a painting of LayerPainter in the scene: seen by the shot&apos;s camera, hidden by what is before it.</source>
        <translation>Place une peinture de LayerPainter dans la scène : vue par la caméra du plan, cachée par ce qui est devant.</translation>
    </message>
    <message>
        <source>&amp;Update paintings</source>
        <translation>&amp;Mettre à jour les peintures</translation>
    </message>
    <message>
        <source>Takes what has changed in the paintings that stand in the scene; they stay where they are.</source>
        <translation>Reprend ce qui a changé dans les peintures placées dans la scène ; elles restent où elles sont.</translation>
    </message>
    <message>
        <source>&amp;Copy lines</source>
        <translation>C&amp;opier les lignes</translation>
    </message>
    <message>
        <source>Puts the lines of this drawing on the clipboard, for the other apps of the suite as well.</source>
        <translation>Met les lignes de ce dessin dans le presse-papiers, aussi pour les autres applications de la suite.</translation>
    </message>
    <message>
        <source>Draws the strokes on the clipboard on the chosen canvas, whichever app they come from.</source>
        <translation>Dessine les traits du presse-papiers sur la toile choisie, quelle que soit leur application.</translation>
    </message>
    <message>
        <source>Choose a canvas with drawn lines: they are copied then.</source>
        <translation>Choisissez une toile avec des lignes : elles seront copiées.</translation>
    </message>
    <message numerus="yes">
        <source>%n lines copied.</source>
        <translation>
            <numerusform>%n ligne copiée.</numerusform>
            <numerusform>%n lignes copiées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a canvas, or place one: the strokes are drawn on it.</source>
        <translation>Choisissez une toile ou placez-en une : les traits y seront dessinés.</translation>
    </message>
    <message>
        <source>Paste lines</source>
        <translation>Coller les lignes</translation>
    </message>
    <message numerus="yes">
        <source>%n lines pasted.</source>
        <translation>
            <numerusform>%n ligne collée.</numerusform>
            <numerusform>%n lignes collées.</numerusform>
        </translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>La peinture</translation>
    </message>
    <message>
        <source>Open a clip first; a painting can stand in it then.</source>
        <translation>Ouvrez d’abord un clip ; une peinture pourra y prendre place.</translation>
    </message>
    <message>
        <source>Place a painting</source>
        <translation>Placer une peinture</translation>
    </message>
    <message>
        <source>Paintings of LayerPainter (*.ductus)</source>
        <translation>Peintures de LayerPainter (*.ductus)</translation>
    </message>
    <message>
        <source>Open a clip: %1 will stand in it.</source>
        <translation>Ouvrez un clip : %1 y prendra place.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Place painting</source>
        <translation>Placer la peinture</translation>
    </message>
    <message>
        <source>%1 stands in the scene. Move it by its handles.</source>
        <translation>%1 est dans la scène. Déplacez-la par ses poignées.</translation>
    </message>
    <message>
        <source>Looking for changes of the paintings</source>
        <translation>Recherche de changements dans les peintures</translation>
    </message>
    <message>
        <source>No painting stands in this scene.</source>
        <translation>Aucune peinture n’est dans cette scène.</translation>
    </message>
    <message>
        <source>All paintings are as they are in LayerPainter.</source>
        <translation>Toutes les peintures sont telles que dans LayerPainter.</translation>
    </message>
    <message>
        <source>The painting &quot;%1&quot; changed in LayerPainter.</source>
        <translation>La peinture « %1 » a changé dans LayerPainter.</translation>
    </message>
    <message numerus="yes">
        <source>%n paintings changed in LayerPainter.</source>
        <translation>
            <numerusform>%n peinture a changé dans LayerPainter.</numerusform>
            <numerusform>%n peintures ont changé dans LayerPainter.</numerusform>
        </translation>
    </message>
    <message>
        <source>Update? Where they stand and what you drew stays.</source>
        <translation>Mettre à jour ? Leur place et vos dessins restent.</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Mettre à jour</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Pas maintenant</translation>
    </message>
    <message>
        <source>Update painting</source>
        <translation>Mettre à jour la peinture</translation>
    </message>
    <message>
        <source>To the be&amp;ginning</source>
        <translation>Au &amp;début</translation>
    </message>
    <message>
        <source>Ta&amp;ke canvas away</source>
        <translation>Retirer &amp;la toile</translation>
    </message>
    <message>
        <source>Paste &amp;lines</source>
        <translation>&amp;Coller les lignes</translation>
    </message>
</context>
<context>
    <name>ductus::TimelineView</name>
    <message>
        <source>Canvases will stand here, one a row.</source>
        <translation>Les toiles apparaîtront ici, une par ligne.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>being followed...</source>
        <translation>suivi en cours...</translation>
    </message>
    <message>
        <source>stands still in the scene</source>
        <translation>immobile dans la scène</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Son</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Ligne de temps</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source>, then straight to the next</source>
        <translation>, puis droit à la suivante</translation>
    </message>
    <message>
        <source>Pinned here, %1%2. Drag to another frame; Delete takes it away.</source>
        <translation>Épinglée ici, %1%2. Glissez vers une autre image ; Suppr la retire.</translation>
    </message>
    <message>
        <source>Distance set here, %1.</source>
        <translation>Distance fixée ici, %1.</translation>
    </message>
    <message>
        <source>Turned here, %1%2.</source>
        <translation>Tournée ici, %1%2.</translation>
    </message>
    <message>
        <source>Size set here, %1.</source>
        <translation>Taille fixée ici, %1.</translation>
    </message>
    <message>
        <source>Drag to go through the clip. Ctrl and the wheel zoom.</source>
        <translation>Glissez pour parcourir le clip. Ctrl et la molette zooment.</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>Dessin %1</translation>
    </message>
</context>
<context>
    <name>ductus::TransportBar</name>
    <message>
        <source>%1   frame %2 of %3</source>
        <translation>%1   image %2 sur %3</translation>
    </message>
</context>
</TS>
