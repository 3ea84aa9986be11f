<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Erase</source>
        <translation>Effacer</translation>
    </message>
</context>
<context>
    <name>ductus::BrushPanel</name>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Half the width of a stroke in the painting&apos;s unit. Keys [ and ].</source>
        <translation>La demi-largeur d’un trait dans l’unité de la peinture. Touches [ et ].</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Section of strokes</source>
        <translation>Section des traits</translation>
    </message>
    <message>
        <source>The shape of a stroke cut across.</source>
        <translation>La forme d’un trait coupé en travers.</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Ronde</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Carrée</translation>
    </message>
    <message>
        <source>Ribbon</source>
        <translation>Ruban</translation>
    </message>
    <message>
        <source>Where strokes go</source>
        <translation>Où vont les traits</translation>
    </message>
    <message>
        <source>On surface</source>
        <translation>Sur la surface</translation>
    </message>
    <message>
        <source>Strokes lie on what is under the pointer.</source>
        <translation>Les traits se posent sur ce qui est sous le pointeur.</translation>
    </message>
    <message>
        <source>On plane</source>
        <translation>Sur un plan</translation>
    </message>
    <message>
        <source>Strokes lie on a plane through the point the view turns around.</source>
        <translation>Les traits se posent sur un plan passant par le point autour duquel la vue tourne.</translation>
    </message>
</context>
<context>
    <name>ductus::ColourField</name>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Left and right: how colourful; up and down: how bright. The bar at the right: the hue.</source>
        <translation>Gauche et droite : la saturation ; haut et bas : la clarté. La barre à droite : la teinte.</translation>
    </message>
</context>
<context>
    <name>ductus::ColourList</name>
    <message>
        <source>Layers that colour this point</source>
        <translation>Calques qui colorent ce point</translation>
    </message>
    <message>
        <source>The point&apos;s colour with this layer and all below. Click: work in this layer.</source>
        <translation>La couleur du point avec ce calque et tous ceux du dessous. Clic : travailler dans ce calque.</translation>
    </message>
    <message>
        <source>Paint with %1</source>
        <translation>Peindre avec %1</translation>
    </message>
    <message>
        <source> %1 %</source>
        <translation> %1 %</translation>
    </message>
    <message>
        <source>, whole scene</source>
        <translation>, toute la scène</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>forme</translation>
    </message>
</context>
<context>
    <name>ductus::ColourPanel</name>
    <message>
        <source>Colour %1</source>
        <translation>Couleur %1</translation>
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
        <translation>Petit, 640 × 360</translation>
    </message>
    <message>
        <source>Square, 1080 × 1080</source>
        <translation>Carré, 1080 × 1080</translation>
    </message>
    <message>
        <source>Upright, 1080 × 1920</source>
        <translation>Vertical, 1080 × 1920</translation>
    </message>
    <message>
        <source>4K, 3840 × 2160</source>
        <translation>4K, 3840 × 2160</translation>
    </message>
    <message>
        <source>Export film</source>
        <translation>Exporter un film</translation>
    </message>
    <message>
        <source>&amp;Seen</source>
        <translation>&amp;Point de vue</translation>
    </message>
    <message>
        <source>From where the film looks at the painting.</source>
        <translation>D’où le film regarde la peinture.</translation>
    </message>
    <message>
        <source>Once around, from the present view</source>
        <translation>Un tour complet, depuis la vue actuelle</translation>
    </message>
    <message>
        <source>Along the camera path</source>
        <translation>Le long du trajet de la caméra</translation>
    </message>
    <message>
        <source>From the present view</source>
        <translation>Depuis la vue actuelle</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>A&amp;mbiance</translation>
    </message>
    <message>
        <source>Which look the film shows.</source>
        <translation>L’ambiance que montre le film.</translation>
    </message>
    <message>
        <source>As shown now</source>
        <translation>Comme affichée</translation>
    </message>
    <message>
        <source>All looks, a film each</source>
        <translation>Toutes les ambiances, un film chacune</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Type</translation>
    </message>
    <message>
        <source>MP4 plays everywhere; WebM and pictures keep transparency.</source>
        <translation>MP4 est lu partout ; WebM et les images gardent la transparence.</translation>
    </message>
    <message>
        <source>MP4 - plays everywhere</source>
        <translation>MP4 - lu partout</translation>
    </message>
    <message>
        <source>WebM - for the web, can be transparent</source>
        <translation>WebM - pour le web, peut être transparent</translation>
    </message>
    <message>
        <source>GIF - a small loop</source>
        <translation>GIF - une petite boucle</translation>
    </message>
    <message>
        <source>Folder of PNG pictures</source>
        <translation>Dossier d’images PNG</translation>
    </message>
    <message>
        <source>S&amp;ize</source>
        <translation>T&amp;aille</translation>
    </message>
    <message>
        <source>Pixels of a frame.</source>
        <translation>Les pixels d’une image.</translation>
    </message>
    <message>
        <source>&amp;Frames a second</source>
        <translation>&amp;Images par seconde</translation>
    </message>
    <message>
        <source>25 suits films, 12 a hand-drawn loop.</source>
        <translation>25 convient aux films, 12 à une boucle dessinée à la main.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>How long the film is; double click: as long as the painting moves.</source>
        <translation>La durée du film ; double-clic : aussi longtemps que la peinture bouge.</translation>
    </message>
    <message>
        <source>&amp;Without background</source>
        <translation>&amp;Sans arrière-plan</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exporter...</translation>
    </message>
    <message>
        <source>MP4 has no transparency; choose WebM, GIF or PNG.</source>
        <translation>MP4 n’a pas de transparence ; choisissez WebM, GIF ou PNG.</translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n image</numerusform>
            <numerusform>%n images</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n films</source>
        <translation>
            <numerusform> dans %n film</numerusform>
            <numerusform> dans %n films</numerusform>
        </translation>
    </message>
    <message>
        <source>, drawn in the background; you can go on painting.</source>
        <translation>, calculées en arrière-plan ; vous pouvez continuer à peindre.</translation>
    </message>
</context>
<context>
    <name>ductus::HeadsetWindow</name>
    <message>
        <source>Paint in &amp;VR</source>
        <translation>Peindre &amp;en RV</translation>
    </message>
    <message>
        <source>The painting in a headset, with the same layers and tools; again leaves it.</source>
        <translation>La peinture dans un casque, avec les mêmes calques et outils ; un nouveau clic le quitte.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>VR</source>
        <translation>RV</translation>
    </message>
    <message>
        <source>Paint in VR</source>
        <translation>Peindre en RV</translation>
    </message>
    <message>
        <source>The painting is in the headset. This window shows what the left eye sees.</source>
        <translation>La peinture est dans le casque. Cette fenêtre montre ce que voit l’œil gauche.</translation>
    </message>
</context>
<context>
    <name>ductus::KeyTrack</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>&lt;b&gt;Time&lt;/b&gt;&lt;br&gt;Drag to see the painting at another moment; diamonds are keys of the camera (above) and of layers (below).</source>
        <translation>&lt;b&gt;Temps&lt;/b&gt;&lt;br&gt;Faites glisser pour voir la peinture à un autre moment ; les losanges sont les clés de la caméra (en haut) et des calques (en bas).</translation>
    </message>
</context>
<context>
    <name>ductus::LayerPanel</name>
    <message>
        <source>Find layers</source>
        <translation>Trouver des calques</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplier</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Écran</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Incrustation</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Addition</translation>
    </message>
    <message>
        <source>Darken</source>
        <translation>Obscurcir</translation>
    </message>
    <message>
        <source>Lighten</source>
        <translation>Éclaircir</translation>
    </message>
    <message>
        <source>Colour dodge</source>
        <translation>Densité couleur −</translation>
    </message>
    <message>
        <source>Colour burn</source>
        <translation>Densité couleur +</translation>
    </message>
    <message>
        <source>Hard light</source>
        <translation>Lumière dure</translation>
    </message>
    <message>
        <source>Soft light</source>
        <translation>Lumière douce</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>Exclusion</source>
        <translation>Exclusion</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Teinte</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturation</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Luminosity</source>
        <translation>Luminosité</translation>
    </message>
    <message>
        <source>Add stack</source>
        <translation>Ajouter une pile</translation>
    </message>
    <message>
        <source>A new shape to paint on, with layers of its own.</source>
        <translation>Une nouvelle forme sur laquelle peindre, avec ses propres calques.</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Ajouter un calque</translation>
    </message>
    <message>
        <source>Its strokes colour the shape below them.</source>
        <translation>Ses traits colorent la forme en dessous.</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Dupliquer le calque</translation>
    </message>
    <message>
        <source>A copy with all strokes, right above.</source>
        <translation>Une copie avec tous les traits, juste au-dessus.</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>Supprimer le calque</translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>Annuler le ramène.</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>How strongly the layer shows.</source>
        <translation>L’intensité avec laquelle le calque apparaît.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Fusion</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Mode de fusion</translation>
    </message>
    <message>
        <source>How its colour is mixed with what is below: Multiply darkens, Screen lightens, Overlay does both.</source>
        <translation>Comment sa couleur se mêle à ce qui est dessous : Multiplier assombrit, Écran éclaircit, Incrustation fait les deux.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Portée</translation>
    </message>
    <message>
        <source>Tolerance: how far from its strokes the layer still colours. 0: only inside them.</source>
        <translation>Tolérance : jusqu’où, autour de ses traits, le calque colore encore. 0 : seulement à l’intérieur.</translation>
    </message>
    <message>
        <source>Stack %1</source>
        <translation>Pile %1</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Calque %1</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 copie</translation>
    </message>
</context>
<context>
    <name>ductus::LayerTree</name>
    <message>
        <source>Layers</source>
        <translation>Calques</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Déverrouiller</translation>
    </message>
    <message>
        <source>Lock: nothing changes it</source>
        <translation>Verrouiller : rien ne le change</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n trait</numerusform>
            <numerusform>%n traits</numerusform>
        </translation>
    </message>
    <message>
        <source>Its layers colour everything, after all others.</source>
        <translation>Ses calques colorent tout, après tous les autres.</translation>
    </message>
</context>
<context>
    <name>ductus::LooksBar</name>
    <message>
        <source>Looks</source>
        <translation>Ambiances</translation>
    </message>
    <message>
        <source>Keep this look</source>
        <translation>Garder cette ambiance</translation>
    </message>
    <message>
        <source>&lt;b&gt;Keep this look&lt;/b&gt;&lt;br&gt;Remembers what all layers are now: visible, how strong, how mixed.</source>
        <translation>&lt;b&gt;Garder cette ambiance&lt;/b&gt;&lt;br&gt;Retient l’état de tous les calques : visibilité, intensité, fusion.</translation>
    </message>
    <message>
        <source>Look %1</source>
        <translation>Ambiance %1</translation>
    </message>
    <message>
        <source>Shows this look; right click to update, rename or delete it.</source>
        <translation>Affiche cette ambiance ; clic droit pour la mettre à jour, la renommer ou la supprimer.</translation>
    </message>
    <message>
        <source>Update from the present</source>
        <translation>Mettre à jour avec l’état actuel</translation>
    </message>
    <message>
        <source>Rename...</source>
        <translation>Renommer...</translation>
    </message>
    <message>
        <source>Rename look</source>
        <translation>Renommer l’ambiance</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
</context>
<context>
    <name>ductus::MaskList</name>
    <message>
        <source>Gradient</source>
        <translation>Dégradé</translation>
    </message>
    <message>
        <source>Round gradient</source>
        <translation>Dégradé radial</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Texture</translation>
    </message>
    <message>
        <source>Inside %1</source>
        <translation>Dans %1</translation>
    </message>
    <message>
        <source>Outside %1</source>
        <translation>Hors de %1</translation>
    </message>
    <message>
        <source>Add mask</source>
        <translation>Ajouter un masque</translation>
    </message>
    <message>
        <source>&lt;b&gt;Add mask&lt;/b&gt;&lt;br&gt;Masks weaken the layer in places; gradients are drawn with the gradient tool (D).</source>
        <translation>&lt;b&gt;Ajouter un masque&lt;/b&gt;&lt;br&gt;Les masques affaiblissent le calque par endroits ; les dégradés se tracent avec l’outil dégradé (D).</translation>
    </message>
    <message>
        <source>, inside out</source>
        <translation>, inversé</translation>
    </message>
    <message>
        <source>Mask of the layer. Click: on and off. With Shift: inside out. With Ctrl: remove.</source>
        <translation>Masque du calque. Clic : activer ou désactiver. Avec Maj : inverser. Avec Ctrl : retirer.</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Grain</translation>
    </message>
    <message>
        <source>How large the spots of the noise are, in the painting&apos;s unit.</source>
        <translation>La taille des taches du bruit, dans l’unité de la peinture.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Quantité</translation>
    </message>
    <message>
        <source>Where the noise begins to show: 0 everywhere, 1 nowhere.</source>
        <translation>Où le bruit commence à paraître : 0 partout, 1 nulle part.</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Douceur</translation>
    </message>
    <message>
        <source>How soft the borders of the spots are.</source>
        <translation>La douceur des bords des taches.</translation>
    </message>
    <message>
        <source>Texture from pictures...</source>
        <translation>Texture à partir d’images...</translation>
    </message>
    <message>
        <source>Inside strokes of</source>
        <translation>Dans les traits de</translation>
    </message>
    <message>
        <source>Outside strokes of</source>
        <translation>Hors des traits de</translation>
    </message>
    <message>
        <source>Slices of a texture, or one picture</source>
        <translation>Coupes d’une texture, ou une seule image</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Images (*.png *.jpg *.jpeg)</translation>
    </message>
</context>
<context>
    <name>ductus::MotionBar</name>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Plays motion, drawings and camera path; again stops. Key Space.</source>
        <translation>Joue mouvement, dessins et trajet de caméra ; de nouveau : arrêt. Touche Espace.</translation>
    </message>
    <message>
        <source>Keep view</source>
        <translation>Garder la vue</translation>
    </message>
    <message>
        <source>Where you look from now becomes a key of the camera path, here in time.</source>
        <translation>La vue actuelle devient une clé du trajet de caméra, à cet instant.</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Retirer la clé</translation>
    </message>
    <message>
        <source>Takes away the camera&apos;s key under the playhead.</source>
        <translation>Retire la clé de la caméra sous la tête de lecture.</translation>
    </message>
    <message>
        <source>Through the camera</source>
        <translation>Par la caméra</translation>
    </message>
    <message>
        <source>The view follows the camera path while time goes on.</source>
        <translation>La vue suit le trajet de la caméra au fil du temps.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>After this time all begins again; 0: no loop.</source>
        <translation>Après ce temps, tout recommence ; 0 : pas de boucle.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
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
        <translation>Ce qui bouge</translation>
    </message>
    <message>
        <source>Arm %1</source>
        <translation>Armer %1</translation>
    </message>
    <message>
        <source>While armed, what the transform tool drags becomes keys of all of it.</source>
        <translation>Tant que c’est armé, ce que déplace l’outil de transformation devient des clés pour l’ensemble.</translation>
    </message>
    <message>
        <source>Keys of %1</source>
        <translation>Clés de %1</translation>
    </message>
    <message>
        <source>Set key of %1</source>
        <translation>Poser une clé pour %1</translation>
    </message>
    <message>
        <source>Keeps where it is now as a key, here in time.</source>
        <translation>Garde la position actuelle comme clé, à cet instant.</translation>
    </message>
    <message>
        <source>Remove key of %1</source>
        <translation>Retirer la clé de %1</translation>
    </message>
    <message>
        <source>Takes away its key under the playhead.</source>
        <translation>Retire sa clé sous la tête de lecture.</translation>
    </message>
</context>
<context>
    <name>ductus::PainterWindow</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Calque</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>&amp;New painting</source>
        <translation>&amp;Nouvelle peinture</translation>
    </message>
    <message>
        <source>Begins with an empty canvas and one stack.</source>
        <translation>Commence par une toile vide et une pile.</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Ouvrir...</translation>
    </message>
    <message>
        <source>Opens a project, a Quill or .tilt painting, or a mesh.</source>
        <translation>Ouvre un projet, une peinture Quill ou .tilt, ou un maillage.</translation>
    </message>
    <message>
        <source>&amp;Import into painting...</source>
        <translation>&amp;Importer dans la peinture...</translation>
    </message>
    <message>
        <source>The strokes of another painting or a mesh join this one; dropping a file does the same.</source>
        <translation>Les traits d’une autre peinture ou un maillage rejoignent celle-ci ; déposer un fichier fait de même.</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Page d’accueil</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the painting stays open.</source>
        <translation>Montre exemples et fichiers récents ; la peinture reste ouverte.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Saves the painting with layers and looks.</source>
        <translation>Enregistre la peinture avec calques et ambiances.</translation>
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
        <source>&amp;Export picture...</source>
        <translation>Exporter &amp;l’image...</translation>
    </message>
    <message>
        <source>Writes what the canvas shows as a PNG file.</source>
        <translation>Écrit ce que montre la toile dans un fichier PNG.</translation>
    </message>
    <message>
        <source>Export &amp;film...</source>
        <translation>Exporter &amp;un film...</translation>
    </message>
    <message>
        <source>A turntable, the camera path or the motion as MP4, WebM, GIF or pictures.</source>
        <translation>Une rotation, le trajet de caméra ou le mouvement en MP4, WebM, GIF ou images.</translation>
    </message>
    <message>
        <source>Export &amp;mesh...</source>
        <translation>Exporter le &amp;maillage...</translation>
    </message>
    <message>
        <source>A GLB file whose vertices have the colours of all layers, for the web.</source>
        <translation>Un fichier GLB dont les sommets ont les couleurs de tous les calques, pour le web.</translation>
    </message>
    <message>
        <source>Save action &amp;log...</source>
        <translation>En&amp;registrer le journal d’actions...</translation>
    </message>
    <message>
        <source>Everything done so far, a line each; layerpainter replay plays it again.</source>
        <translation>Tout ce qui a été fait, une ligne par action ; layerpainter replay le rejoue.</translation>
    </message>
    <message>
        <source>&amp;Delete strokes</source>
        <translation>&amp;Supprimer les traits</translation>
    </message>
    <message>
        <source>Takes the chosen strokes away.</source>
        <translation>Enlève les traits choisis.</translation>
    </message>
    <message>
        <source>Copies of the chosen strokes in the active layer: how highlights and shadows are made.</source>
        <translation>Des copies des traits choisis dans le calque actif : c’est ainsi qu’on fait lumières et ombres.</translation>
    </message>
    <message>
        <source>&amp;Move to layer</source>
        <translation>&amp;Déplacer vers le calque</translation>
    </message>
    <message>
        <source>The chosen strokes go into the active layer.</source>
        <translation>Les traits choisis passent dans le calque actif.</translation>
    </message>
    <message>
        <source>Gives the chosen strokes the present colour.</source>
        <translation>Donne aux traits choisis la couleur actuelle.</translation>
    </message>
    <message>
        <source>Choose &amp;all of layer</source>
        <translation>Choisir &amp;tout le calque</translation>
    </message>
    <message>
        <source>All strokes of the active layer.</source>
        <translation>Tous les traits du calque actif.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Interrompre</translation>
    </message>
    <message>
        <source>Forgets what was begun, then the choice, then the tool.</source>
        <translation>Oublie ce qui était commencé, puis le choix, puis l’outil.</translation>
    </message>
    <message>
        <source>Add &amp;stack</source>
        <translation>&amp;Ajouter une pile</translation>
    </message>
    <message>
        <source>A new shape to paint on, with layers of its own.</source>
        <translation>Une nouvelle forme sur laquelle peindre, avec ses propres calques.</translation>
    </message>
    <message>
        <source>Add &amp;layer</source>
        <translation>Ajouter &amp;un calque</translation>
    </message>
    <message>
        <source>Its strokes colour the shape below them.</source>
        <translation>Ses traits colorent la forme en dessous.</translation>
    </message>
    <message>
        <source>&amp;Duplicate layer</source>
        <translation>&amp;Dupliquer le calque</translation>
    </message>
    <message>
        <source>A copy with all strokes, right above.</source>
        <translation>Une copie avec tous les traits, juste au-dessus.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renommer</translation>
    </message>
    <message>
        <source>Another name for stack or layer.</source>
        <translation>Un autre nom pour la pile ou le calque.</translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>Annuler le ramène.</translation>
    </message>
    <message>
        <source>Back to the painting&apos;s own view.</source>
        <translation>Retour à la vue propre de la peinture.</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Mouvement</translation>
    </message>
    <message>
        <source>Shows the timeline of motion and camera.</source>
        <translation>Affiche la ligne de temps du mouvement et de la caméra.</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Plays motion, drawings and camera path; again stops.</source>
        <translation>Joue mouvement, dessins et trajet de caméra ; de nouveau : arrêt.</translation>
    </message>
    <message>
        <source>&amp;Keep view as key</source>
        <translation>&amp;Garder la vue comme clé</translation>
    </message>
    <message>
        <source>Where you look from becomes a key of the camera path at the present time.</source>
        <translation>La vue actuelle devient une clé du trajet de caméra à l’instant présent.</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>Pinceau plus &amp;large</translation>
    </message>
    <message>
        <source>Wider strokes.</source>
        <translation>Des traits plus larges.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>&amp;Smaller brush</source>
        <translation>&amp;Pinceau plus fin</translation>
    </message>
    <message>
        <source>Finer strokes.</source>
        <translation>Des traits plus fins.</translation>
    </message>
    <message>
        <source>&amp;Turn view</source>
        <translation>&amp;Tourner la vue</translation>
    </message>
    <message>
        <source>Drag turns the view. With other tools: the right button.</source>
        <translation>Glisser tourne la vue. Avec les autres outils : le bouton droit.</translation>
    </message>
    <message>
        <source>Drag to turn, wheel to zoom, middle button or Shift to pan.</source>
        <translation>Glisser pour tourner, molette pour zoomer, bouton du milieu ou Maj pour déplacer.</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Sélection</translation>
    </message>
    <message>
        <source>A click chooses a stroke, Shift adds, a drag chooses a box, with Ctrl a lasso.</source>
        <translation>Un clic choisit un trait, Maj ajoute, glisser trace un rectangle, avec Ctrl un lasso.</translation>
    </message>
    <message>
        <source>Click a stroke, or drag a box over strokes of the active layer. Ctrl+D copies them into the active layer.</source>
        <translation>Cliquez sur un trait, ou tracez un rectangle sur des traits du calque actif. Ctrl+D les copie dans le calque actif.</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>Dép&amp;lacer</translation>
    </message>
    <message>
        <source>Moves, turns and scales the chosen strokes.</source>
        <translation>Déplace, tourne et redimensionne les traits choisis.</translation>
    </message>
    <message>
        <source>Drag the chosen strokes; the ring turns them (with Shift upright), the square scales them.</source>
        <translation>Faites glisser les traits choisis ; l’anneau les tourne (avec Maj, droits), le carré change leur taille.</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>&amp;Peindre</translation>
    </message>
    <message>
        <source>Paints into the active layer: a shape in stacks, colour in layers.</source>
        <translation>Peint dans le calque actif : une forme dans les piles, de la couleur dans les calques.</translation>
    </message>
    <message>
        <source>Paint on the surface or in the air. Shift draws straight, [ and ] change the size.</source>
        <translation>Peignez sur la surface ou dans l’air. Maj trace droit, [ et ] changent la taille.</translation>
    </message>
    <message>
        <source>&amp;Erase</source>
        <translation>&amp;Effacer</translation>
    </message>
    <message>
        <source>Takes strokes of the active layer away; with Shift only the touched parts.</source>
        <translation>Enlève des traits du calque actif ; avec Maj, seulement les parties touchées.</translation>
    </message>
    <message>
        <source>Drag over strokes of the active layer. With Shift only the touched parts go.</source>
        <translation>Passez sur des traits du calque actif. Avec Maj, seules les parties touchées disparaissent.</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Dégradé</translation>
    </message>
    <message>
        <source>Fades the active layer along a drag.</source>
        <translation>Estompe le calque actif le long d’un glissé.</translation>
    </message>
    <message>
        <source>Drag from where the layer is full to where it fades out. With Shift around a point.</source>
        <translation>Glissez de l’endroit où le calque est plein vers celui où il s’estompe. Avec Maj, autour d’un point.</translation>
    </message>
    <message>
        <source>&amp;What colours this</source>
        <translation>&amp;Ce qui colore ceci</translation>
    </message>
    <message>
        <source>A click lists the layers that colour a point.</source>
        <translation>Un clic liste les calques qui colorent un point.</translation>
    </message>
    <message>
        <source>Click on the painting: the list shows which layers colour this point, the topmost first.</source>
        <translation>Cliquez sur la peinture : la liste montre quels calques colorent ce point, le plus haut d’abord.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Calque</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinceau</translation>
    </message>
    <message>
        <source>There is nothing to export yet; paint or open something first.</source>
        <translation>Rien à exporter encore ; peignez ou ouvrez d’abord quelque chose.</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Exporter l’image</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Export de %1</translation>
    </message>
    <message>
        <source>Exported to %1, %2 x %3 pixels.</source>
        <translation>Exporté vers %1, %2 x %3 pixels.</translation>
    </message>
    <message>
        <source>There is nothing to film yet; paint or open something first.</source>
        <translation>Rien à filmer encore ; peignez ou ouvrez d’abord quelque chose.</translation>
    </message>
    <message>
        <source>Export film</source>
        <translation>Exporter un film</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Dossiers (*)</translation>
    </message>
    <message>
        <source>The film %1 is ready.</source>
        <translation>Le film %1 est prêt.</translation>
    </message>
    <message numerus="yes">
        <source>%n films are ready.</source>
        <translation>
            <numerusform>%n film est prêt.</numerusform>
            <numerusform>%n films sont prêts.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Montrer dans le dossier</translation>
    </message>
    <message>
        <source>Export mesh</source>
        <translation>Exporter le maillage</translation>
    </message>
    <message>
        <source>Meshes with colours (*.glb)</source>
        <translation>Maillages avec couleurs (*.glb)</translation>
    </message>
    <message>
        <source>Exported %L1 triangles with their colours to %2.</source>
        <translation>%L1 triangles exportés avec leurs couleurs vers %2.</translation>
    </message>
    <message>
        <source>LayerPainter</source>
        <translation>LayerPainter</translation>
    </message>
    <message>
        <source>Light, shadow and mood for 3D paintings, layer by layer.</source>
        <translation>Lumière, ombre et ambiance pour peintures 3D, calque par calque.</translation>
    </message>
    <message>
        <source>New painting</source>
        <translation>Nouvelle peinture</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Ouvrir...</translation>
    </message>
    <message>
        <source>Drop a Quill or .tilt painting, a mesh or a project anywhere.</source>
        <translation>Déposez n’importe où une peinture Quill ou .tilt, un maillage ou un projet.</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Paintings and meshes (*.ductus *.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;All files (*)</source>
        <translation>Peintures et maillages (*.ductus *.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Paintings and meshes (*.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Surfaces of SketchSurfacer (*.ductus)</source>
        <translation>Peintures et maillages (*.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Surfaces de SketchSurfacer (*.ductus)</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes joined the painting</source>
        <translation>
            <numerusform>%n trait a rejoint la peinture</numerusform>
            <numerusform>%n traits ont rejoint la peinture</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n stacks.</source>
        <translation>
            <numerusform> dans %n pile.</numerusform>
            <numerusform> dans %n piles.</numerusform>
        </translation>
    </message>
    <message>
        <source> Of drawings frame by frame the first came along.</source>
        <translation> Des dessins image par image, seul le premier est venu.</translation>
    </message>
    <message>
        <source>Some of it was skipped: %1</source>
        <translation>Une partie a été ignorée : %1</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Et %n autre.</numerusform>
            <numerusform>Et %n autres.</numerusform>
        </translation>
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
        <source>Save action log</source>
        <translation>Enregistrer le journal d’actions</translation>
    </message>
    <message>
        <source>Action logs (*.jsonl)</source>
        <translation>Journaux d’actions (*.jsonl)</translation>
    </message>
    <message numerus="yes">
        <source>The log of %n actions is saved.</source>
        <translation>
            <numerusform>Le journal de %n action est enregistré.</numerusform>
            <numerusform>Le journal de %n actions est enregistré.</numerusform>
        </translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Calques</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Choose strokes first; the copies go into the active layer.</source>
        <translation>Choisissez d’abord des traits ; les copies vont dans le calque actif.</translation>
    </message>
    <message>
        <source>&amp;Update surfaces</source>
        <translation>Mettre à &amp;jour les surfaces</translation>
    </message>
    <message>
        <source>Takes what has changed in the sketches the surfaces were made from; your layers stay.</source>
        <translation>Reprend ce qui a changé dans les croquis d’où viennent les surfaces ; vos calques restent.</translation>
    </message>
    <message>
        <source>&amp;Copy strokes</source>
        <translation>Copier &amp;les traits</translation>
    </message>
    <message>
        <source>Puts the chosen strokes on the clipboard, for this app and the others of the suite.</source>
        <translation>Met les traits choisis dans le presse-papiers, pour cette application et les autres de la suite.</translation>
    </message>
    <message>
        <source>&amp;Paste strokes</source>
        <translation>&amp;Coller les traits</translation>
    </message>
    <message>
        <source>Draws the strokes on the clipboard into the active layer, whichever app they come from.</source>
        <translation>Dessine les traits du presse-papiers dans le calque actif, quelle que soit leur application.</translation>
    </message>
    <message>
        <source>Send strokes to S&amp;ketchSurfacer</source>
        <translation>Envoyer les &amp;traits à SketchSurfacer</translation>
    </message>
    <message>
        <source>Makes a sketch of the chosen strokes, or of the active layer, and opens it in SketchSurfacer.</source>
        <translation>Fait un croquis des traits choisis, ou du calque actif, et l’ouvre dans SketchSurfacer.</translation>
    </message>
    <message>
        <source>Send to &amp;DoodleStudio</source>
        <translation>Envoyer à &amp;DoodleStudio</translation>
    </message>
    <message>
        <source>Opens DoodleStudio, where this painting can stand in a filmed scene.</source>
        <translation>Ouvre DoodleStudio, où cette peinture peut prendre place dans une scène filmée.</translation>
    </message>
    <message>
        <source>Choose strokes first: they are copied then.</source>
        <translation>Choisissez d’abord des traits : ils seront copiés.</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes copied.</source>
        <translation>
            <numerusform>%n trait copié.</numerusform>
            <numerusform>%n traits copiés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes pasted.</source>
        <translation>
            <numerusform>%n trait collé.</numerusform>
            <numerusform>%n traits collés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose strokes, or a layer with strokes: they become the sketch.</source>
        <translation>Choisissez des traits, ou un calque qui en contient : ils deviendront le croquis.</translation>
    </message>
    <message>
        <source>Save the sketch as</source>
        <translation>Enregistrer le croquis sous</translation>
    </message>
    <message>
        <source> sketch</source>
        <translation> croquis</translation>
    </message>
    <message>
        <source>sketch</source>
        <translation>croquis</translation>
    </message>
    <message>
        <source>Writing the sketch</source>
        <translation>Écriture du croquis</translation>
    </message>
    <message>
        <source>There is nothing painted yet.</source>
        <translation>Rien n’est encore peint.</translation>
    </message>
    <message>
        <source>DoodleStudio reads the saved painting, and this one has changes.</source>
        <translation>DoodleStudio lit la peinture enregistrée, et celle-ci a des modifications.</translation>
    </message>
    <message>
        <source>Save and send</source>
        <translation>Enregistrer et envoyer</translation>
    </message>
    <message>
        <source>Save as and send...</source>
        <translation>Enregistrer sous et envoyer...</translation>
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
        <translation>%1 ouvre %2.</translation>
    </message>
    <message>
        <source>The surface</source>
        <translation>La surface</translation>
    </message>
    <message>
        <source>Looking for changes of the sketches</source>
        <translation>Recherche de changements dans les croquis</translation>
    </message>
    <message>
        <source>No surface of this painting comes from a sketch.</source>
        <translation>Aucune surface de cette peinture ne vient d’un croquis.</translation>
    </message>
    <message>
        <source>All surfaces are as their sketches are.</source>
        <translation>Toutes les surfaces correspondent à leurs croquis.</translation>
    </message>
    <message>
        <source>The surface of &quot;%1&quot; changed in SketchSurfacer.</source>
        <translation>La surface de « %1 » a changé dans SketchSurfacer.</translation>
    </message>
    <message numerus="yes">
        <source>%n surfaces changed in SketchSurfacer.</source>
        <translation>
            <numerusform>%n surface a changé dans SketchSurfacer.</numerusform>
            <numerusform>%n surfaces ont changé dans SketchSurfacer.</numerusform>
        </translation>
    </message>
    <message>
        <source>Update? Your layers, strokes and masks stay.</source>
        <translation>Mettre à jour ? Vos calques, traits et masques restent.</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Mettre à jour</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Pas maintenant</translation>
    </message>
    <message numerus="yes">
        <source>%n surfaces are as in their sketches now.</source>
        <translation>
            <numerusform>%n surface correspond maintenant à son croquis.</numerusform>
            <numerusform>%n surfaces correspondent maintenant à leurs croquis.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is open in another program: this painting is saved in a file of its own and stays linked to the surface.</source>
        <translation>%1 est ouvert dans un autre programme : cette peinture est enregistrée dans son propre fichier et reste liée à la surface.</translation>
    </message>
    <message>
        <source>Duplicate &amp;into layer</source>
        <translation>D&amp;upliquer dans le calque</translation>
    </message>
    <message>
        <source>Rec&amp;olour</source>
        <translation>R&amp;ecolorer</translation>
    </message>
    <message>
        <source>D&amp;elete layer</source>
        <translation>&amp;Supprimer le calque</translation>
    </message>
    <message>
        <source>Fr&amp;ame all</source>
        <translation>T&amp;out cadrer</translation>
    </message>
</context>
<context>
    <name>ductus::PaintingDocument</name>
    <message>
        <source>Add stack</source>
        <translation>Ajouter une pile</translation>
    </message>
    <message>
        <source>Delete stack</source>
        <translation>Supprimer la pile</translation>
    </message>
    <message>
        <source>Move stack</source>
        <translation>Déplacer la pile</translation>
    </message>
    <message>
        <source>Rename stack</source>
        <translation>Renommer la pile</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Ajouter un calque</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>Supprimer le calque</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Déplacer le calque</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Dupliquer le calque</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>Renommer le calque</translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation>Verrouiller le calque</translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation>Déverrouiller le calque</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Afficher le calque</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Masquer le calque</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Changer l’opacité</translation>
    </message>
    <message>
        <source>Change blend mode</source>
        <translation>Changer le mode de fusion</translation>
    </message>
    <message>
        <source>Change masks</source>
        <translation>Modifier les masques</translation>
    </message>
    <message>
        <source>Change layer colour</source>
        <translation>Changer la couleur du calque</translation>
    </message>
    <message>
        <source>Change tolerance</source>
        <translation>Changer la tolérance</translation>
    </message>
    <message>
        <source>Move layer in time</source>
        <translation>Déplacer le calque dans le temps</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Peindre</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>Supprimer le trait</translation>
    </message>
    <message>
        <source>Delete %1 strokes</source>
        <translation>Supprimer %1 traits</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Move stroke to layer</source>
        <translation>Déplacer le trait vers le calque</translation>
    </message>
    <message>
        <source>Move %1 strokes to layer</source>
        <translation>Déplacer %1 traits vers le calque</translation>
    </message>
    <message>
        <source>Duplicate stroke</source>
        <translation>Dupliquer le trait</translation>
    </message>
    <message>
        <source>Duplicate %1 strokes</source>
        <translation>Dupliquer %1 traits</translation>
    </message>
    <message>
        <source>Move stroke</source>
        <translation>Déplacer le trait</translation>
    </message>
    <message>
        <source>Move %1 strokes</source>
        <translation>Déplacer %1 traits</translation>
    </message>
    <message>
        <source>Recolour stroke</source>
        <translation>Recolorer le trait</translation>
    </message>
    <message>
        <source>Recolour %1 strokes</source>
        <translation>Recolorer %1 traits</translation>
    </message>
    <message>
        <source>Add look</source>
        <translation>Ajouter une ambiance</translation>
    </message>
    <message>
        <source>Update look</source>
        <translation>Mettre à jour l’ambiance</translation>
    </message>
    <message>
        <source>Switch look</source>
        <translation>Changer d’ambiance</translation>
    </message>
    <message>
        <source>Rename look</source>
        <translation>Renommer l’ambiance</translation>
    </message>
    <message>
        <source>Delete look</source>
        <translation>Supprimer l’ambiance</translation>
    </message>
    <message>
        <source>Change scene</source>
        <translation>Modifier la scène</translation>
    </message>
    <message>
        <source>Change camera path</source>
        <translation>Modifier le trajet de la caméra</translation>
    </message>
    <message>
        <source>Add motion group</source>
        <translation>Ajouter un groupe de mouvement</translation>
    </message>
    <message>
        <source>Change motion</source>
        <translation>Modifier le mouvement</translation>
    </message>
    <message>
        <source>Delete motion group</source>
        <translation>Supprimer le groupe de mouvement</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Update surface</source>
        <translation>Mettre à jour la surface</translation>
    </message>
</context>
<context>
    <name>ductus::PaintingView</name>
    <message>
        <source>Canvas</source>
        <translation>Toile</translation>
    </message>
</context>
<context>
    <name>ductus::PictureDialog</name>
    <message>
        <source>Export picture</source>
        <translation>Exporter l’image</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> pixels</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 pixels</translation>
    </message>
    <message>
        <source>Without background</source>
        <translation>Sans arrière-plan</translation>
    </message>
    <message>
        <source>&lt;b&gt;Without background&lt;/b&gt;&lt;br&gt;Where nothing is painted the picture is transparent, to be put on something else.</source>
        <translation>&lt;b&gt;Sans arrière-plan&lt;/b&gt;&lt;br&gt;Là où rien n’est peint, l’image est transparente, pour la poser sur autre chose.</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exporter...</translation>
    </message>
</context>
<context>
    <name>ductus::PointColours</name>
    <message>
        <source>Looking which layers colour this</source>
        <translation>Recherche des calques qui colorent ce point</translation>
    </message>
</context>
<context>
    <name>ductus::RoomPanels</name>
    <message>
        <source>Layers</source>
        <translation>Calques</translation>
    </message>
    <message>
        <source>Brush and colour</source>
        <translation>Pinceau et couleur</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>Gaucher</translation>
    </message>
    <message>
        <source>The left hand paints, the right one holds the panels.</source>
        <translation>La main gauche peint, la droite tient les panneaux.</translation>
    </message>
    <message>
        <source>Leave VR</source>
        <translation>Quitter la RV</translation>
    </message>
</context>
</TS>
