<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>ductus::ActionSearch</name>
    <message>
        <source>Search actions</source>
        <translation>Chercher une action</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Que voulez-vous faire ?</translation>
    </message>
    <message>
        <source>Found actions</source>
        <translation>Actions trouvées</translation>
    </message>
    <message>
        <source>Nothing is called like that.</source>
        <translation>Rien ne porte ce nom.</translation>
    </message>
</context>
<context>
    <name>ductus::AppearancePage</name>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Dark or light, as the rest of your desktop.</source>
        <translation>Sombre ou clair, comme le reste du bureau.</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Lets pictures and strokes stand out.</source>
        <translation>Fait ressortir les images et les traits.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Easier to read in bright rooms and on projectors.</source>
        <translation>Plus lisible dans une pièce claire ou projeté à l’écran.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Pictures you export do not depend on it.</source>
        <translation>Les images exportées n’en dépendent pas.</translation>
    </message>
    <message>
        <source>Takes effect when the app is started again.</source>
        <translation>Prend effet au prochain démarrage de l’application.</translation>
    </message>
</context>
<context>
    <name>ductus::Autosave</name>
    <message>
        <source>Autosaving</source>
        <translation>Enregistrement automatique</translation>
    </message>
</context>
<context>
    <name>ductus::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>it was made by a newer version of Ductus</source>
        <translation>il a été créé par une version plus récente de Ductus</translation>
    </message>
</context>
<context>
    <name>ductus::DocumentFiles</name>
    <message>
        <source>the file may not be written</source>
        <translation>le fichier n’est pas accessible en écriture</translation>
    </message>
    <message>
        <source>%1 is open for reading only: %2. Save under another name to keep changes.</source>
        <translation>%1 est ouvert en lecture seule : %2. Enregistrez sous un autre nom pour garder les modifications.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>Lecture du fichier</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Enregistrement de %1</translation>
    </message>
    <message>
        <source>Writing the file</source>
        <translation>Écriture du fichier</translation>
    </message>
</context>
<context>
    <name>ductus::EngineWords</name>
    <message>
        <source>Adding a group</source>
        <translation>Ajout d’un groupe</translation>
    </message>
    <message>
        <source>Adding a layer</source>
        <translation>Ajout d’un calque</translation>
    </message>
    <message>
        <source>Adding strokes</source>
        <translation>Ajout de traits</translation>
    </message>
    <message>
        <source>Applying a scribble</source>
        <translation>Application d’un gribouillis</translation>
    </message>
    <message>
        <source>Applying the look</source>
        <translation>Application de l’ambiance</translation>
    </message>
    <message>
        <source>Associating strokes</source>
        <translation>Association des traits</translation>
    </message>
    <message>
        <source>Associating strokes with the proxy</source>
        <translation>Association des traits au proxy</translation>
    </message>
    <message>
        <source>Attracting the proxy</source>
        <translation>Attraction du proxy</translation>
    </message>
    <message>
        <source>Attracting the proxy to the strokes</source>
        <translation>Attraction du proxy vers les traits</translation>
    </message>
    <message>
        <source>Baking the painting</source>
        <translation>Calcul des couleurs de la peinture</translation>
    </message>
    <message>
        <source>Changing how long the frame is shown</source>
        <translation>Changement de la durée du dessin</translation>
    </message>
    <message>
        <source>Changing the camera path</source>
        <translation>Modification du trajet de caméra</translation>
    </message>
    <message>
        <source>Changing the canvas</source>
        <translation>Modification de la toile</translation>
    </message>
    <message>
        <source>Changing the keyframe</source>
        <translation>Modification de l’image clé</translation>
    </message>
    <message>
        <source>Changing the layer</source>
        <translation>Modification du calque</translation>
    </message>
    <message>
        <source>Changing the mark</source>
        <translation>Modification du tracé</translation>
    </message>
    <message>
        <source>Changing the motion</source>
        <translation>Modification du mouvement</translation>
    </message>
    <message>
        <source>Changing the scene</source>
        <translation>Modification de la scène</translation>
    </message>
    <message>
        <source>Changing the tolerance</source>
        <translation>Modification de la tolérance</translation>
    </message>
    <message>
        <source>Checking the painting</source>
        <translation>Contrôle de la peinture</translation>
    </message>
    <message>
        <source>Checking the print</source>
        <translation>Contrôle de l’impression</translation>
    </message>
    <message>
        <source>Checking the project</source>
        <translation>Contrôle du projet</translation>
    </message>
    <message>
        <source>Contouring the smooth surface</source>
        <translation>Extraction de la surface lisse</translation>
    </message>
    <message>
        <source>Cutting the stroke</source>
        <translation>Découpe du trait</translation>
    </message>
    <message>
        <source>Discarding the recovered copy</source>
        <translation>Abandon de la copie récupérée</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Dessin</translation>
    </message>
    <message>
        <source>Drawing other readings</source>
        <translation>Dessin des autres interprétations</translation>
    </message>
    <message>
        <source>Drawing the painting</source>
        <translation>Dessin de la peinture</translation>
    </message>
    <message>
        <source>Drawing the samples</source>
        <translation>Dessin des exemples</translation>
    </message>
    <message>
        <source>Drawing the surface</source>
        <translation>Dessin de la surface</translation>
    </message>
    <message>
        <source>Duplicating strokes</source>
        <translation>Duplication des traits</translation>
    </message>
    <message>
        <source>Duplicating the layer</source>
        <translation>Duplication du calque</translation>
    </message>
    <message>
        <source>Entering VR</source>
        <translation>Passage en RV</translation>
    </message>
    <message>
        <source>Evening out the triangles</source>
        <translation>Régularisation des triangles</translation>
    </message>
    <message>
        <source>Exporting the film</source>
        <translation>Export du film</translation>
    </message>
    <message>
        <source>Exporting the painting</source>
        <translation>Export de la peinture</translation>
    </message>
    <message>
        <source>Exporting the surface</source>
        <translation>Export de la surface</translation>
    </message>
    <message>
        <source>Finding how far away things are</source>
        <translation>Calcul des distances</translation>
    </message>
    <message>
        <source>Finding how the camera moved</source>
        <translation>Calcul du mouvement de la caméra</translation>
    </message>
    <message>
        <source>Finding how the scene moves</source>
        <translation>Calcul du mouvement de la scène</translation>
    </message>
    <message>
        <source>Finding stroke normals</source>
        <translation>Calcul des normales des traits</translation>
    </message>
    <message>
        <source>Finding surface patches</source>
        <translation>Recherche des morceaux de surface</translation>
    </message>
    <message>
        <source>Finding what moves by itself</source>
        <translation>Recherche de ce qui bouge seul</translation>
    </message>
    <message>
        <source>Fitting a smooth surface</source>
        <translation>Ajustement d’une surface lisse</translation>
    </message>
    <message>
        <source>Fitting a smooth surface piece by piece</source>
        <translation>Ajustement d’une surface lisse morceau par morceau</translation>
    </message>
    <message>
        <source>Fitting a smooth surface through the strokes</source>
        <translation>Ajustement d’une surface lisse aux traits</translation>
    </message>
    <message>
        <source>Fitting changed strokes</source>
        <translation>Ajustement des traits modifiés</translation>
    </message>
    <message>
        <source>Fitting the final mesh</source>
        <translation>Ajustement du maillage final</translation>
    </message>
    <message>
        <source>Fitting the surface</source>
        <translation>Ajustement de la surface</translation>
    </message>
    <message>
        <source>Following the canvas</source>
        <translation>Suivi de la toile</translation>
    </message>
    <message>
        <source>Following the canvases</source>
        <translation>Suivi des toiles</translation>
    </message>
    <message>
        <source>Importing the painting</source>
        <translation>Import de la peinture</translation>
    </message>
    <message>
        <source>Importing the surface</source>
        <translation>Import de la surface</translation>
    </message>
    <message>
        <source>Keeping what was found out about the clip</source>
        <translation>Conservation de l’analyse du clip</translation>
    </message>
    <message>
        <source>Locking the project</source>
        <translation>Verrouillage du projet</translation>
    </message>
    <message>
        <source>Looking at the scene</source>
        <translation>Analyse de la scène</translation>
    </message>
    <message>
        <source>Looking for cables</source>
        <translation>Recherche de câbles</translation>
    </message>
    <message>
        <source>Looking for other readings</source>
        <translation>Recherche d’autres interprétations</translation>
    </message>
    <message>
        <source>Looking which clip it is</source>
        <translation>Identification du clip</translation>
    </message>
    <message>
        <source>Making a proxy</source>
        <translation>Création d’un proxy</translation>
    </message>
    <message>
        <source>Making a tube along a stroke</source>
        <translation>Création d’un tube le long d’un trait</translation>
    </message>
    <message>
        <source>Making stacks of the layers</source>
        <translation>Création de piles à partir des calques</translation>
    </message>
    <message>
        <source>Measuring how exact the points are</source>
        <translation>Mesure de la précision des points</translation>
    </message>
    <message>
        <source>Measuring walls</source>
        <translation>Mesure des parois</translation>
    </message>
    <message>
        <source>Moving strokes to a layer</source>
        <translation>Déplacement de traits vers un calque</translation>
    </message>
    <message>
        <source>Moving the canvas</source>
        <translation>Déplacement de la toile</translation>
    </message>
    <message>
        <source>Moving the canvas in depth</source>
        <translation>Déplacement de la toile en profondeur</translation>
    </message>
    <message>
        <source>Moving the keyframe</source>
        <translation>Déplacement de l’image clé</translation>
    </message>
    <message>
        <source>Moving the layer</source>
        <translation>Déplacement du calque</translation>
    </message>
    <message>
        <source>Moving the proxy to the changed strokes</source>
        <translation>Déplacement du proxy vers les traits modifiés</translation>
    </message>
    <message>
        <source>Moving the stack</source>
        <translation>Déplacement de la pile</translation>
    </message>
    <message>
        <source>Opening the clip</source>
        <translation>Ouverture du clip</translation>
    </message>
    <message>
        <source>Opening the painting</source>
        <translation>Ouverture de la peinture</translation>
    </message>
    <message>
        <source>Opening the project</source>
        <translation>Ouverture du projet</translation>
    </message>
    <message>
        <source>Opening the sample</source>
        <translation>Ouverture de l’exemple</translation>
    </message>
    <message>
        <source>Painting in VR</source>
        <translation>Peinture en RV</translation>
    </message>
    <message>
        <source>Pasting strokes</source>
        <translation>Collage de traits</translation>
    </message>
    <message>
        <source>Pinning the canvas</source>
        <translation>Épinglage de la toile</translation>
    </message>
    <message>
        <source>Placing the canvas</source>
        <translation>Placement de la toile</translation>
    </message>
    <message>
        <source>Placing a painting</source>
        <translation>Placement d’une peinture</translation>
    </message>
    <message>
        <source>Preparing the frame</source>
        <translation>Préparation de l’image</translation>
    </message>
    <message>
        <source>Preparing the graphics card</source>
        <translation>Préparation de la carte graphique</translation>
    </message>
    <message>
        <source>Reading a texture</source>
        <translation>Lecture d’une texture</translation>
    </message>
    <message>
        <source>Reading the cameras</source>
        <translation>Lecture des caméras</translation>
    </message>
    <message>
        <source>Reading the clip</source>
        <translation>Lecture du clip</translation>
    </message>
    <message>
        <source>Reading the depth maps</source>
        <translation>Lecture des cartes de profondeur</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>Lecture du maillage</translation>
    </message>
    <message>
        <source>Reading the painting</source>
        <translation>Lecture de la peinture</translation>
    </message>
    <message>
        <source>Reading the picture</source>
        <translation>Lecture de l’image</translation>
    </message>
    <message>
        <source>Reading the points</source>
        <translation>Lecture des points</translation>
    </message>
    <message>
        <source>Reading the project</source>
        <translation>Lecture du projet</translation>
    </message>
    <message>
        <source>Reading the proxy</source>
        <translation>Lecture du proxy</translation>
    </message>
    <message>
        <source>Reading the sketch</source>
        <translation>Lecture du croquis</translation>
    </message>
    <message>
        <source>Reading the sketch&apos;s size</source>
        <translation>Lecture de la taille du croquis</translation>
    </message>
    <message>
        <source>Reading the sound</source>
        <translation>Lecture du son</translation>
    </message>
    <message>
        <source>Reading the sound of the clip</source>
        <translation>Lecture du son du clip</translation>
    </message>
    <message>
        <source>Reading what was found out about the clip</source>
        <translation>Lecture de l’analyse du clip</translation>
    </message>
    <message>
        <source>Recolouring strokes</source>
        <translation>Recoloration des traits</translation>
    </message>
    <message>
        <source>Remeshing</source>
        <translation>Remaillage</translation>
    </message>
    <message>
        <source>Removing strokes</source>
        <translation>Retrait de traits</translation>
    </message>
    <message>
        <source>Removing the canvas</source>
        <translation>Retrait de la toile</translation>
    </message>
    <message>
        <source>Removing the group</source>
        <translation>Retrait du groupe</translation>
    </message>
    <message>
        <source>Removing the keyframe</source>
        <translation>Retrait de l’image clé</translation>
    </message>
    <message>
        <source>Removing the layer</source>
        <translation>Retrait du calque</translation>
    </message>
    <message>
        <source>Removing the look</source>
        <translation>Retrait de l’ambiance</translation>
    </message>
    <message>
        <source>Removing the stack</source>
        <translation>Retrait de la pile</translation>
    </message>
    <message>
        <source>Renaming the layer</source>
        <translation>Changement du nom du calque</translation>
    </message>
    <message>
        <source>Renaming the look</source>
        <translation>Changement du nom de l’ambiance</translation>
    </message>
    <message>
        <source>Renaming the stack</source>
        <translation>Changement du nom de la pile</translation>
    </message>
    <message>
        <source>Repairing the mesh</source>
        <translation>Réparation du maillage</translation>
    </message>
    <message>
        <source>Restoring the chosen reading</source>
        <translation>Rétablissement de l’interprétation choisie</translation>
    </message>
    <message>
        <source>Saving the project</source>
        <translation>Enregistrement du projet</translation>
    </message>
    <message>
        <source>Segmenting the surface</source>
        <translation>Segmentation de la surface</translation>
    </message>
    <message>
        <source>Surfacing</source>
        <translation>Création de la surface</translation>
    </message>
    <message>
        <source>Surfacing the points</source>
        <translation>Création de la surface des points</translation>
    </message>
    <message>
        <source>Surfacing the sketch</source>
        <translation>Création de la surface du croquis</translation>
    </message>
    <message>
        <source>Trimming the open surface</source>
        <translation>Découpe de la surface ouverte</translation>
    </message>
    <message>
        <source>Turning the canvas</source>
        <translation>Rotation de la toile</translation>
    </message>
    <message>
        <source>Unpacking an entry of the project</source>
        <translation>Décompression d’une entrée du projet</translation>
    </message>
    <message>
        <source>Uploading the painting</source>
        <translation>Envoi de la peinture à la carte graphique</translation>
    </message>
    <message>
        <source>Wrapping the strokes</source>
        <translation>Enveloppement des traits</translation>
    </message>
    <message>
        <source>Writing the action log</source>
        <translation>Écriture du journal d’actions</translation>
    </message>
    <message>
        <source>Writing the film</source>
        <translation>Écriture du film</translation>
    </message>
    <message>
        <source>Writing the mesh</source>
        <translation>Écriture du maillage</translation>
    </message>
    <message>
        <source>Writing the picture</source>
        <translation>Écriture de l’image</translation>
    </message>
    <message>
        <source>Writing the project</source>
        <translation>Écriture du projet</translation>
    </message>
    <message>
        <source>Writing the sound</source>
        <translation>Écriture du son</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>le fichier ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>le fichier ne peut pas être écrit</translation>
    </message>
    <message>
        <source>the memory does not suffice for it</source>
        <translation>la mémoire n’y suffit pas</translation>
    </message>
    <message>
        <source>this is a PLY mesh</source>
        <translation>c’est un maillage PLY</translation>
    </message>
    <message>
        <source>this is an OFF mesh</source>
        <translation>c’est un maillage OFF</translation>
    </message>
    <message>
        <source>this is an STL mesh</source>
        <translation>c’est un maillage STL</translation>
    </message>
    <message>
        <source>this is a GLB scene</source>
        <translation>c’est une scène GLB</translation>
    </message>
    <message>
        <source>this is a zip archive</source>
        <translation>c’est une archive zip</translation>
    </message>
    <message>
        <source>this is a PNG picture</source>
        <translation>c’est une image PNG</translation>
    </message>
    <message>
        <source>this is JSON</source>
        <translation>c’est du JSON</translation>
    </message>
    <message>
        <source>there is no stroke in it</source>
        <translation>il ne contient aucun trait</translation>
    </message>
    <message>
        <source>there is no sketch in it</source>
        <translation>il ne contient aucun croquis</translation>
    </message>
    <message>
        <source>the project holds no painting</source>
        <translation>le projet ne contient aucune peinture</translation>
    </message>
    <message>
        <source>no stroke lies near the proxy mesh</source>
        <translation>aucun trait n’est proche du maillage proxy</translation>
    </message>
    <message>
        <source>the sketch has too few strokes for a surface</source>
        <translation>le croquis a trop peu de traits pour une surface</translation>
    </message>
    <message>
        <source>all strokes lie in one plane</source>
        <translation>tous les traits sont dans un même plan</translation>
    </message>
    <message>
        <source>the equations are singular</source>
        <translation>les équations sont singulières</translation>
    </message>
    <message>
        <source>no piece could be fitted</source>
        <translation>aucun morceau n’a pu être ajusté</translation>
    </message>
    <message>
        <source>the connection to the headset was lost</source>
        <translation>la connexion au casque est perdue</translation>
    </message>
    <message>
        <source>no headset is connected or it is switched off</source>
        <translation>aucun casque n’est branché, ou il est éteint</translation>
    </message>
    <message>
        <source>there is no such stack</source>
        <translation>cette pile n’existe pas</translation>
    </message>
    <message>
        <source>there is no such layer</source>
        <translation>ce calque n’existe pas</translation>
    </message>
    <message>
        <source>there is no such look</source>
        <translation>cette ambiance n’existe pas</translation>
    </message>
    <message>
        <source>it is not part of this installation</source>
        <translation>il ne fait pas partie de cette installation</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Vérifiez le chemin</translation>
    </message>
    <message>
        <source>Check the name</source>
        <translation>Vérifiez le nom</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Choisissez un autre dossier</translation>
    </message>
    <message>
        <source>Choose another folder, or make room on the disk</source>
        <translation>Choisissez un autre dossier ou libérez de l’espace disque</translation>
    </message>
    <message>
        <source>Make room on the disk</source>
        <translation>Libérez de l’espace disque</translation>
    </message>
    <message>
        <source>Free some space and try again</source>
        <translation>Libérez de l’espace et réessayez</translation>
    </message>
    <message>
        <source>Choose a PNG or JPEG file</source>
        <translation>Choisissez un fichier PNG ou JPEG</translation>
    </message>
    <message>
        <source>Choose a file with 3D strokes</source>
        <translation>Choisissez un fichier contenant des traits 3D</translation>
    </message>
    <message>
        <source>Choose a file with painted layers</source>
        <translation>Choisissez un fichier avec des calques peints</translation>
    </message>
    <message>
        <source>Choose it again</source>
        <translation>Choisissez-le de nouveau</translation>
    </message>
    <message>
        <source>Correct this line or export the file again</source>
        <translation>Corrigez cette ligne ou exportez de nouveau le fichier</translation>
    </message>
    <message>
        <source>Correct this line or export the mesh again</source>
        <translation>Corrigez cette ligne ou exportez de nouveau le maillage</translation>
    </message>
    <message>
        <source>Export the mesh again</source>
        <translation>Exportez de nouveau le maillage</translation>
    </message>
    <message>
        <source>Export the sketch again</source>
        <translation>Exportez de nouveau le croquis</translation>
    </message>
    <message>
        <source>The file seems cut off: copy or export it again</source>
        <translation>Le fichier semble tronqué : copiez-le ou exportez-le de nouveau</translation>
    </message>
    <message>
        <source>Check that this is a text file</source>
        <translation>Vérifiez qu’il s’agit d’un fichier texte</translation>
    </message>
    <message>
        <source>Draw more strokes, or give a proxy mesh</source>
        <translation>Dessinez plus de traits, ou fournissez un maillage proxy</translation>
    </message>
    <message>
        <source>Draw strokes in depth, or give a proxy mesh</source>
        <translation>Dessinez des traits en profondeur, ou fournissez un maillage proxy</translation>
    </message>
    <message>
        <source>Give a proxy mesh</source>
        <translation>Fournissez un maillage proxy</translation>
    </message>
    <message>
        <source>Surface the whole sketch anew</source>
        <translation>Recréez toute la surface du croquis</translation>
    </message>
    <message>
        <source>Check that proxy and sketch have the same position, axes and scale</source>
        <translation>Vérifiez que proxy et croquis ont mêmes position, axes et échelle</translation>
    </message>
    <message>
        <source>Repair the mesh or export it again</source>
        <translation>Réparez le maillage ou exportez-le de nouveau</translation>
    </message>
    <message>
        <source>Simplify the mesh first</source>
        <translation>Simplifiez d’abord le maillage</translation>
    </message>
    <message>
        <source>Save the project again in Quill</source>
        <translation>Enregistrez de nouveau le projet dans Quill</translation>
    </message>
    <message>
        <source>Open the previous version of the file, its name ends in ~</source>
        <translation>Ouvrez la version précédente du fichier, son nom finit par ~</translation>
    </message>
    <message>
        <source>Open it in the app that made it</source>
        <translation>Ouvrez-le dans l’application qui l’a créé</translation>
    </message>
    <message>
        <source>Open it with the app it was made with</source>
        <translation>Ouvrez-le avec l’application qui l’a créé</translation>
    </message>
    <message>
        <source>Install a newer version of Ductus</source>
        <translation>Installez une version plus récente de Ductus</translation>
    </message>
    <message>
        <source>Update the graphics driver</source>
        <translation>Mettez à jour le pilote graphique</translation>
    </message>
    <message>
        <source>Update the headset software</source>
        <translation>Mettez à jour le logiciel du casque</translation>
    </message>
    <message>
        <source>Switch the headset on and try again</source>
        <translation>Allumez le casque et réessayez</translation>
    </message>
    <message>
        <source>The painting is still here; connect the headset and enter VR again</source>
        <translation>La peinture est toujours là ; rebranchez le casque et revenez en RV</translation>
    </message>
    <message>
        <source>Choose a stack of this painting</source>
        <translation>Choisissez une pile de cette peinture</translation>
    </message>
    <message>
        <source>Choose a look of this painting</source>
        <translation>Choisissez une ambiance de cette peinture</translation>
    </message>
    <message>
        <source>Close other programs or work on a smaller part</source>
        <translation>Fermez d’autres programmes ou travaillez sur une plus petite partie</translation>
    </message>
    <message>
        <source>Save your work and report this with the file</source>
        <translation>Enregistrez votre travail et signalez ceci avec le fichier</translation>
    </message>
    <message>
        <source>Surface the sketch in SketchSurfacer and save it</source>
        <translation>Créez la surface dans SketchSurfacer et enregistrez-la</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Vérifiez ses droits d’accès</translation>
    </message>
    <message>
        <source>Choose a layer of this painting</source>
        <translation>Choisissez un calque de cette peinture</translation>
    </message>
    <message>
        <source>Choose a project that was saved in LayerPainter</source>
        <translation>Choisissez un projet enregistré dans LayerPainter</translation>
    </message>
    <message>
        <source>Choose a video that a player on this computer can show, or a folder of pictures</source>
        <translation>Choisissez une vidéo lisible sur cet ordinateur, ou un dossier d’images</translation>
    </message>
    <message>
        <source>Choose a video, or a folder of JPEG or PNG pictures</source>
        <translation>Choisissez une vidéo, ou un dossier d’images JPEG ou PNG</translation>
    </message>
    <message>
        <source>Choose another file, or convert it to MP4 (H.264)</source>
        <translation>Choisissez un autre fichier, ou convertissez-le en MP4 (H.264)</translation>
    </message>
    <message>
        <source>Close it there, or open it read-only</source>
        <translation>Fermez-le là-bas, ou ouvrez-le en lecture seule</translation>
    </message>
    <message>
        <source>Close the other program</source>
        <translation>Fermez l’autre programme</translation>
    </message>
    <message>
        <source>Copy fewer strokes</source>
        <translation>Copiez moins de traits</translation>
    </message>
    <message>
        <source>Copy strokes in an app of the suite first</source>
        <translation>Copiez d’abord des traits dans une application de la suite</translation>
    </message>
    <message>
        <source>Copy the file to another disk and try again</source>
        <translation>Copiez le fichier sur un autre disque et réessayez</translation>
    </message>
    <message>
        <source>Draw it from border to border of a region, or closed up to a ring</source>
        <translation>Tracez-le d’un bord à l’autre d’une région, ou fermé en anneau</translation>
    </message>
    <message>
        <source>Free some space or save to another place</source>
        <translation>Libérez de l’espace ou enregistrez ailleurs</translation>
    </message>
    <message>
        <source>Give a scale above zero</source>
        <translation>Donnez une échelle supérieure à zéro</translation>
    </message>
    <message>
        <source>Give a value inside its range</source>
        <translation>Donnez une valeur dans les limites</translation>
    </message>
    <message>
        <source>Go on with what was taken from it</source>
        <translation>Continuez avec ce qui en a été repris</translation>
    </message>
    <message>
        <source>Install and start the software of your headset, such as SteamVR or Monado, and make it the active OpenXR runtime</source>
        <translation>Installez et lancez le logiciel de votre casque, tel que SteamVR ou Monado, et faites-en le runtime OpenXR actif</translation>
    </message>
    <message>
        <source>Install it beside this one, or put its folder into PATH</source>
        <translation>Installez-le à côté de celui-ci, ou ajoutez son dossier à PATH</translation>
    </message>
    <message>
        <source>Make it smaller</source>
        <translation>Rendez-la plus petite</translation>
    </message>
    <message>
        <source>Make room on the disk or check the folder&apos;s permissions</source>
        <translation>Libérez de l’espace ou vérifiez les droits du dossier</translation>
    </message>
    <message>
        <source>Mark the strokes along the border of the surface, and no others, as boundary</source>
        <translation>Marquez comme bord les traits le long du bord de la surface, et eux seuls</translation>
    </message>
    <message>
        <source>MP4 has no transparency</source>
        <translation>MP4 n’a pas de transparence</translation>
    </message>
    <message>
        <source>No mirror plane was found; the whole sketch is surfaced.</source>
        <translation>Aucun plan de symétrie trouvé ; toute la surface est calculée.</translation>
    </message>
    <message>
        <source>Open it read-only or save a copy elsewhere</source>
        <translation>Ouvrez-le en lecture seule ou enregistrez une copie ailleurs</translation>
    </message>
    <message>
        <source>Put it back, or go on with what was taken from it</source>
        <translation>Remettez-le en place, ou continuez avec ce qui en a été repris</translation>
    </message>
    <message>
        <source>Remove it as a whole</source>
        <translation>Supprimez-le en entier</translation>
    </message>
    <message>
        <source>Remove that mask first</source>
        <translation>Retirez d’abord ce masque</translation>
    </message>
    <message>
        <source>Remove the lock first</source>
        <translation>Retirez d’abord le verrou</translation>
    </message>
    <message>
        <source>Remove the whole stack</source>
        <translation>Supprimez toute la pile</translation>
    </message>
    <message>
        <source>Save it again</source>
        <translation>Enregistrez-le de nouveau</translation>
    </message>
    <message>
        <source>Save to another disk</source>
        <translation>Enregistrez sur un autre disque</translation>
    </message>
    <message>
        <source>Save to another place</source>
        <translation>Enregistrez à un autre endroit</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Enregistrez sous un autre nom</translation>
    </message>
    <message>
        <source>Scale it less</source>
        <translation>Redimensionnez-le moins</translation>
    </message>
    <message>
        <source>Show a stack that has strokes</source>
        <translation>Affichez une pile qui contient des traits</translation>
    </message>
    <message>
        <source>Surface it in SketchSurfacer and save it</source>
        <translation>Créez la surface dans SketchSurfacer et enregistrez-la</translation>
    </message>
    <message>
        <source>Unlock it first</source>
        <translation>Déverrouillez-le d’abord</translation>
    </message>
    <message>
        <source>a chosen stroke is not in the painting</source>
        <translation>un trait choisi n’est pas dans la peinture</translation>
    </message>
    <message>
        <source>a stack has one substrate</source>
        <translation>une pile a un seul support</translation>
    </message>
    <message>
        <source>a stroke would become too large or too small</source>
        <translation>un trait deviendrait trop grand ou trop petit</translation>
    </message>
    <message>
        <source>a substrate stays with its stack</source>
        <translation>un support reste avec sa pile</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>tous les points sont dans un même plan</translation>
    </message>
    <message>
        <source>another program uses the headset</source>
        <translation>un autre programme utilise le casque</translation>
    </message>
    <message>
        <source>every painting has a scene stack</source>
        <translation>toute peinture a une pile de scène</translation>
    </message>
    <message>
        <source>it does not part a region</source>
        <translation>il ne sépare pas de région</translation>
    </message>
    <message>
        <source>it has no finished surface now</source>
        <translation>il n’a plus de surface finie</translation>
    </message>
    <message>
        <source>it is a mesh</source>
        <translation>c’est un maillage</translation>
    </message>
    <message>
        <source>it is not in its project any more</source>
        <translation>il n’est plus dans son projet</translation>
    </message>
    <message>
        <source>it is not there any more</source>
        <translation>il n’existe plus</translation>
    </message>
    <message>
        <source>it is the only one</source>
        <translation>c’est le seul</translation>
    </message>
    <message>
        <source>it lies far from the surface</source>
        <translation>il est loin de la surface</translation>
    </message>
    <message>
        <source>it lies in a locked region</source>
        <translation>il se trouve dans une région verrouillée</translation>
    </message>
    <message>
        <source>it was made by a newer version of Ductus and may only be read</source>
        <translation>il a été créé par une version plus récente de Ductus et ne peut être que lu</translation>
    </message>
    <message>
        <source>its project is not where it was</source>
        <translation>son projet n’est plus à sa place</translation>
    </message>
    <message>
        <source>its size is not positive</source>
        <translation>sa taille n’est pas positive</translation>
    </message>
    <message>
        <source>no frame in it can be decoded</source>
        <translation>aucune de ses images n’est décodable</translation>
    </message>
    <message>
        <source>no headset software (OpenXR runtime) was found</source>
        <translation>aucun logiciel de casque (runtime OpenXR) n’a été trouvé</translation>
    </message>
    <message>
        <source>no layer of it holds strokes</source>
        <translation>aucun de ses calques ne contient de traits</translation>
    </message>
    <message>
        <source>no stack of it is visible</source>
        <translation>aucune de ses piles n’est visible</translation>
    </message>
    <message>
        <source>the boundary strokes enclose nothing on the proxy</source>
        <translation>les traits de bord n’entourent rien sur le proxy</translation>
    </message>
    <message>
        <source>the clipboard holds no strokes</source>
        <translation>le presse-papiers ne contient pas de traits</translation>
    </message>
    <message>
        <source>the disk gives back other bytes than were written</source>
        <translation>le disque rend d’autres octets que ceux écrits</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>le fichier est en lecture seule</translation>
    </message>
    <message>
        <source>the film has no frames</source>
        <translation>le film n’a pas d’images</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>the grid would be too fine</source>
        <translation>la grille serait trop fine</translation>
    </message>
    <message>
        <source>the headset software stopped</source>
        <translation>le logiciel du casque s’est arrêté</translation>
    </message>
    <message>
        <source>the layer has no such drawing</source>
        <translation>le calque n’a pas ce dessin</translation>
    </message>
    <message>
        <source>the layer is locked</source>
        <translation>le calque est verrouillé</translation>
    </message>
    <message>
        <source>the layers above colour it</source>
        <translation>les calques du dessus le colorent</translation>
    </message>
    <message>
        <source>the memory ran out</source>
        <translation>la mémoire est épuisée</translation>
    </message>
    <message>
        <source>the painting has no strokes</source>
        <translation>la peinture n’a pas de traits</translation>
    </message>
    <message>
        <source>the painting would have too many vertices</source>
        <translation>la peinture aurait trop de sommets</translation>
    </message>
    <message>
        <source>the pictures differ in size</source>
        <translation>les images n’ont pas la même taille</translation>
    </message>
    <message>
        <source>the program does not start</source>
        <translation>le programme ne démarre pas</translation>
    </message>
    <message>
        <source>the program is not installed</source>
        <translation>le programme n’est pas installé</translation>
    </message>
    <message>
        <source>the project holds no filmed scene</source>
        <translation>le projet ne contient aucune scène filmée</translation>
    </message>
    <message>
        <source>the project holds no finished surface</source>
        <translation>le projet ne contient aucune surface finie</translation>
    </message>
    <message>
        <source>the project is not where it was saved</source>
        <translation>le projet n’est pas là où il a été enregistré</translation>
    </message>
    <message>
        <source>the scene stack stays above all others</source>
        <translation>la pile de scène reste au-dessus des autres</translation>
    </message>
    <message>
        <source>the size or the checksum does not match, the file is damaged</source>
        <translation>la taille ou la somme de contrôle ne correspond pas, le fichier est endommagé</translation>
    </message>
    <message>
        <source>the smooth surface does not end near the strokes</source>
        <translation>la surface lisse ne se termine pas près des traits</translation>
    </message>
    <message>
        <source>the stroke is not in the painting</source>
        <translation>le trait n’est pas dans la peinture</translation>
    </message>
    <message>
        <source>there are no pictures in this folder</source>
        <translation>ce dossier ne contient pas d’images</translation>
    </message>
    <message>
        <source>there are too many of them</source>
        <translation>il y en a trop</translation>
    </message>
    <message>
        <source>there is already one in that frame</source>
        <translation>il y en a déjà une dans cette image</translation>
    </message>
    <message>
        <source>there is no video in it that can be decoded</source>
        <translation>il ne contient pas de vidéo décodable</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>la mémoire ne suffit pas pour ce fichier</translation>
    </message>
    <message>
        <source>there is not enough memory to write the project</source>
        <translation>la mémoire ne suffit pas pour écrire le projet</translation>
    </message>
    <message>
        <source>this field is missing</source>
        <translation>ce champ manque</translation>
    </message>
    <message>
        <source>this is a container of another kind, not a Ductus project</source>
        <translation>c’est un conteneur d’un autre type, pas un projet Ductus</translation>
    </message>
    <message>
        <source>this is not a Ductus project</source>
        <translation>ce n’est pas un projet Ductus</translation>
    </message>
    <message>
        <source>this is not a file</source>
        <translation>ce n’est pas un fichier</translation>
    </message>
    <message>
        <source>this is not valid JSON</source>
        <translation>ce n’est pas du JSON valide</translation>
    </message>
    <message>
        <source>this picture cannot be decoded</source>
        <translation>cette image n’est pas décodable</translation>
    </message>
</context>
<context>
    <name>ductus::FoldingSection</name>
    <message>
        <source>%1, folded</source>
        <translation>%1, replié</translation>
    </message>
    <message>
        <source>%1, unfolded</source>
        <translation>%1, déplié</translation>
    </message>
</context>
<context>
    <name>ductus::HelpWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>The manual is missing in this installation: %1.</source>
        <translation>Le manuel manque dans cette installation : %1.</translation>
    </message>
</context>
<context>
    <name>ductus::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
</context>
<context>
    <name>ductus::JobChip</name>
    <message>
        <source>Running jobs</source>
        <translation>Tâches en cours</translation>
    </message>
    <message>
        <source>What is being worked on. Click for the list.</source>
        <translation>Les travaux en cours. Cliquer pour la liste.</translation>
    </message>
    <message>
        <source>Cancel job</source>
        <translation>Annuler la tâche</translation>
    </message>
    <message>
        <source>Stop this job; what was there before stays.</source>
        <translation>Arrête cette tâche ; l’état précédent est conservé.</translation>
    </message>
</context>
<context>
    <name>ductus::JobPopup</name>
    <message>
        <source>Nothing is running.</source>
        <translation>Aucune tâche en cours.</translation>
    </message>
    <message>
        <source>Running jobs</source>
        <translation>Tâches en cours</translation>
    </message>
</context>
<context>
    <name>ductus::JobRow</name>
    <message>
        <source>Stop this job; what was there before stays.</source>
        <translation>Arrête cette tâche ; l’état précédent est conservé.</translation>
    </message>
    <message>
        <source>Cancel %1</source>
        <translation>Annuler : %1</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Arrêt en cours</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>En attente</translation>
    </message>
</context>
<context>
    <name>ductus::JobWords</name>
    <message>
        <source>a few seconds</source>
        <translation>quelques secondes</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>environ %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>environ %1 min</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation>environ %1 h</translation>
    </message>
    <message>
        <source>Stopping: %1</source>
        <translation>Arrêt : %1</translation>
    </message>
    <message>
        <source>Waiting: %1</source>
        <translation>En attente : %1</translation>
    </message>
</context>
<context>
    <name>ductus::MainWindowShell</name>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>&amp;Inspector</source>
        <translation>&amp;Inspecteur</translation>
    </message>
    <message>
        <source>Shows or hides the column at the right.</source>
        <translation>Affiche ou masque la colonne de droite.</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Historique</translation>
    </message>
    <message>
        <source>Lists all edits; a click goes back to one.</source>
        <translation>Liste toutes les modifications ; un clic revient à l’une d’elles.</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>Leaves everything but this window away.</source>
        <translation>Ne laisse que cette fenêtre à l’écran.</translation>
    </message>
    <message>
        <source>Theme as the &amp;system</source>
        <translation>&amp;Thème du système</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>Thème &amp;sombre</translation>
    </message>
    <message>
        <source>&amp;Light theme</source>
        <translation>Thème &amp;clair</translation>
    </message>
    <message>
        <source>Changes the colours of this app, not of your work.</source>
        <translation>Change les couleurs de l’application, pas celles de votre travail.</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>&amp;Préférences...</translation>
    </message>
    <message>
        <source>Theme, keys, tablet.</source>
        <translation>Thème, raccourcis, tablette.</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>&amp;Search actions...</source>
        <translation>&amp;Chercher une action...</translation>
    </message>
    <message>
        <source>Type what you want to do; Enter does it.</source>
        <translation>Tapez ce que vous voulez faire ; Entrée l’exécute.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>Opens the manual at what you are working with.</source>
        <translation>Ouvre le manuel à la page de ce que vous faites.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Closes this window; asks before anything is lost.</source>
        <translation>Ferme cette fenêtre ; demande avant que rien ne se perde.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Takes the last edit back.</source>
        <translation>Défait la dernière modification.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Does again what was taken back.</source>
        <translation>Refait ce qui a été annulé.</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler : %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir : %1</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Aff&amp;ichage</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>Tablet</source>
        <translation>Tablette</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Enregistrer les modifications de « %1 » ?</translation>
    </message>
    <message>
        <source>Without saving, what you did since the last save is lost.</source>
        <translation>Sans enregistrement, ce qui a été fait depuis le dernier enregistrement est perdu.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Discard changes</source>
        <translation>Abandonner &amp;les modifications</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (lecture seule)</translation>
    </message>
</context>
<context>
    <name>ductus::MessageBar</name>
    <message>
        <source>%1 failed: %2%3.</source>
        <translation>%1 : échec, %2%3.</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Close message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Fermer ce message (Échap)</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n autre</numerusform>
            <numerusform>%n autres</numerusform>
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
        <translation>Courbe de pression</translation>
    </message>
    <message>
        <source>Left and right choose a point, Ctrl with the arrow keys moves it.</source>
        <translation>Gauche et droite choisissent un point, Ctrl et les flèches le déplacent.</translation>
    </message>
    <message>
        <source>Drag the points. Left: a light touch, right: pressed hard; up: counts more.</source>
        <translation>Faites glisser les points. À gauche : pression légère, à droite : forte ; plus haut : compte davantage.</translation>
    </message>
</context>
<context>
    <name>ductus::PressureTestField</name>
    <message>
        <source>Test field for the pen</source>
        <translation>Zone d’essai du stylet</translation>
    </message>
    <message>
        <source>Draw here with your pen to try the curve.</source>
        <translation>Dessinez ici au stylet pour essayer la courbe.</translation>
    </message>
</context>
<context>
    <name>ductus::RecentRow</name>
    <message>
        <source>%1, missing</source>
        <translation>%1, introuvable</translation>
    </message>
    <message>
        <source>not there any more</source>
        <translation>n’est plus là</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>&amp;Take off this list</source>
        <translation>&amp;Retirer de cette liste</translation>
    </message>
</context>
<context>
    <name>ductus::RecoveryNotice</name>
    <message>
        <source>Today %1</source>
        <translation>Aujourd’hui %1</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Travail non enregistré</translation>
    </message>
    <message>
        <source>Unsaved work from last time</source>
        <translation>Travail non enregistré de la dernière fois</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Open the unsaved %1</source>
        <translation>Ouvrir %1 non enregistré</translation>
    </message>
    <message>
        <source>Discard the unsaved %1</source>
        <translation>Abandonner %1 non enregistré</translation>
    </message>
</context>
<context>
    <name>ductus::SampleWords</name>
    <message>
        <source>Saloon car</source>
        <translation>Berline</translation>
    </message>
    <message>
        <source>Symmetric sketch with sharp shoulder, pillars and detail strokes: half is solved and mirrored.</source>
        <translation>Croquis symétrique avec épaule vive, montants et traits de détail : une moitié est calculée et reflétée.</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>Bouteille</translation>
    </message>
    <message>
        <source>Round shapes with sharp rings: a crease at the shoulder, none along the meridians.</source>
        <translation>Formes rondes à anneaux vifs : un pli à l’épaule, aucun le long des méridiens.</translation>
    </message>
    <message>
        <source>Box with a bevel</source>
        <translation>Boîte chanfreinée</translation>
    </message>
    <message>
        <source>Flat faces meet in straight edges although every stroke is a little off.</source>
        <translation>Des faces planes se rejoignent en arêtes droites bien que chaque trait soit un peu décalé.</translation>
    </message>
    <message>
        <source>Folded leaf</source>
        <translation>Feuille pliée</translation>
    </message>
    <message>
        <source>An open shell: boundary strokes say where the surface ends, the midrib is a fold.</source>
        <translation>Une coque ouverte : les traits de bord disent où finit la surface, la nervure est un pli.</translation>
    </message>
    <message>
        <source>Computer mouse</source>
        <translation>Souris d’ordinateur</translation>
    </message>
    <message>
        <source>A smooth dome with a sharp belt: detail strokes lie on the surface and bend nothing.</source>
        <translation>Un dôme lisse à ceinture vive : les traits de détail restent sur la surface sans rien déformer.</translation>
    </message>
    <message>
        <source>Table lamp</source>
        <translation>Lampe de table</translation>
    </message>
    <message>
        <source>Thick and thin parts in one sketch: the stem needs a tight proxy.</source>
        <translation>Parties épaisses et minces dans un même croquis : le pied demande un proxy serré.</translation>
    </message>
    <message>
        <source>Iron with a handle</source>
        <translation>Fer à repasser</translation>
    </message>
    <message>
        <source>A closed surface with a hole: the proxy must find the way through the handle.</source>
        <translation>Une surface fermée avec un trou : le proxy doit trouver le passage dans la poignée.</translation>
    </message>
    <message>
        <source>Forest path</source>
        <translation>Sentier en forêt</translation>
    </message>
    <message>
        <source>Two looks, day and dawn: light is a layer of strokes, mist a gradient.</source>
        <translation>Deux ambiances, jour et aube : la lumière est un calque de traits, la brume un dégradé.</translation>
    </message>
    <message>
        <source>Over the clouds</source>
        <translation>Au-dessus des nuages</translation>
    </message>
    <message>
        <source>Shadows are copies of strokes with tolerance; plane and shadow move as one.</source>
        <translation>Les ombres sont des copies de traits avec tolérance ; avion et ombre bougent ensemble.</translation>
    </message>
    <message>
        <source>Desk by day and night</source>
        <translation>Bureau, jour et nuit</translation>
    </message>
    <message>
        <source>A sunbeam through the window, a lamp for the night: one scene, two looks.</source>
        <translation>Un rayon de soleil par la fenêtre, une lampe pour la nuit : une scène, deux ambiances.</translation>
    </message>
    <message>
        <source>Passing box</source>
        <translation>Boîte qui passe</translation>
    </message>
    <message>
        <source>A face follows the box behind the post; words and arrow stay in the room.</source>
        <translation>Un visage suit la boîte derrière le poteau ; texte et flèche restent dans la pièce.</translation>
    </message>
    <message>
        <source>Walk through the room</source>
        <translation>Traversée de la pièce</translation>
    </message>
    <message>
        <source>Labels and stickers keep their place in the room while the camera walks in.</source>
        <translation>Étiquettes et autocollants gardent leur place pendant que la caméra avance.</translation>
    </message>
    <message>
        <source>One vase, three glazes</source>
        <translation>Un vase, trois émaux</translation>
    </message>
    <message>
        <source>Ornament is painted once; looks give every layer another colour.</source>
        <translation>L’ornement n’est peint qu’une fois ; les ambiances donnent une autre couleur à chaque calque.</translation>
    </message>
    <message>
        <source>Campfire</source>
        <translation>Feu de camp</translation>
    </message>
    <message>
        <source>Flames are five drawings shown in turn; night and firelight are gradients.</source>
        <translation>Les flammes sont cinq dessins montrés tour à tour ; nuit et lueur du feu sont des dégradés.</translation>
    </message>
    <message>
        <source>Lighthouse</source>
        <translation>Phare</translation>
    </message>
    <message>
        <source>Noise makes foam and crests, the beam is clear paint that turns.</source>
        <translation>Le bruit fait l’écume et les crêtes, le faisceau est une peinture claire qui tourne.</translation>
    </message>
    <message>
        <source>Koi pond</source>
        <translation>Bassin aux carpes</translation>
    </message>
    <message>
        <source>Spots reach no further than the fish they touch; shadows swim along.</source>
        <translation>Les taches ne dépassent pas le poisson qu’elles touchent ; les ombres nagent avec lui.</translation>
    </message>
    <message>
        <source>Pendulum</source>
        <translation>Pendule</translation>
    </message>
    <message>
        <source>A still camera; the arrow rides on the bob and is drawn anew twelve times a swing.</source>
        <translation>Caméra fixe ; la flèche suit la masse et est redessinée douze fois par oscillation.</translation>
    </message>
    <message>
        <source>Chalk in the yard</source>
        <translation>Craie dans la cour</translation>
    </message>
    <message>
        <source>Canvases lie on the ground and on the wall and keep their perspective as the camera goes by.</source>
        <translation>Des toiles au sol et au mur gardent leur perspective au passage de la caméra.</translation>
    </message>
    <message>
        <source>A ghost in the store</source>
        <translation>Un fantôme dans l’entrepôt</translation>
    </message>
    <message>
        <source>Six drawings in a loop; keyframes carry them around the post and behind the boxes.</source>
        <translation>Six dessins en boucle ; des images clés les mènent autour du poteau et derrière les caisses.</translation>
    </message>
    <message>
        <source>Over the hills</source>
        <translation>Par-delà les collines</translation>
    </message>
    <message>
        <source>The camera only turns: birds fly by keyframes, one of them behind the house.</source>
        <translation>La caméra ne fait que tourner : des oiseaux volent par images clés, l’un derrière la maison.</translation>
    </message>
</context>
<context>
    <name>ductus::SegmentedSwitch</name>
    <message>
        <source>Hold the key to peek.</source>
        <translation>Maintenir la touche pour un coup d’œil.</translation>
    </message>
</context>
<context>
    <name>ductus::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>ductus::ShortcutsPage</name>
    <message>
        <source>&amp;Use it here instead</source>
        <translation>&amp;L’utiliser ici</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Par défaut</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Aucun</translation>
    </message>
    <message>
        <source>Filter by name or keys</source>
        <translation>Filtrer par nom ou touches</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>Actions et leurs raccourcis</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Nouveau raccourci</translation>
    </message>
    <message>
        <source>Click here and press the new keys.</source>
        <translation>Cliquer ici et appuyer sur les nouvelles touches.</translation>
    </message>
    <message>
        <source>Conflict</source>
        <translation>Conflit</translation>
    </message>
    <message>
        <source>Default keys</source>
        <translation>Raccourci par défaut</translation>
    </message>
    <message>
        <source>No keys</source>
        <translation>Aucun raccourci</translation>
    </message>
    <message>
        <source>Use it here instead</source>
        <translation>L’utiliser ici</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Raccourci</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Autres</translation>
    </message>
    <message>
        <source>%1 is taken by: %2.</source>
        <translation>%1 est déjà pris par : %2.</translation>
    </message>
</context>
<context>
    <name>ductus::StartPage</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nouveau</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Ouvrir...</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Accueil</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>Or drop a file anywhere in this window.</source>
        <translation>Ou déposez un fichier n’importe où dans cette fenêtre.</translation>
    </message>
    <message>
        <source>Files you open will be listed here.</source>
        <translation>Les fichiers ouverts apparaîtront ici.</translation>
    </message>
</context>
<context>
    <name>ductus::TabletPage</name>
    <message>
        <source>&amp;Straight line</source>
        <translation>&amp;Ligne droite</translation>
    </message>
    <message>
        <source>&amp;Clean field</source>
        <translation>&amp;Effacer la zone</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Pression</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Essayer</translation>
    </message>
    <message>
        <source>Raise the left part if you press lightly, lower it if you press hard. The other end of the pen erases.</source>
        <translation>Relevez la partie gauche si vous appuyez peu, abaissez-la si vous appuyez fort. L’autre bout du stylet efface.</translation>
    </message>
    <message>
        <source>Straight line</source>
        <translation>Ligne droite</translation>
    </message>
    <message>
        <source>Clean field</source>
        <translation>Effacer la zone</translation>
    </message>
</context>
<context>
    <name>ductus::ToolRail</name>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
</context>
<context>
    <name>ductus::TopRow</name>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>All menus</source>
        <translation>Tous les menus</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Chercher une action</translation>
    </message>
</context>
<context>
    <name>ductus::UndoPanel</name>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Close history</source>
        <translation>Fermer l’historique</translation>
    </message>
    <message>
        <source>Close the history</source>
        <translation>Fermer l’historique</translation>
    </message>
    <message>
        <source>History of edits</source>
        <translation>Historique des modifications</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Tel qu’il a été ouvert</translation>
    </message>
</context>
<context>
    <name>ductus::UnsavedWork</name>
    <message>
        <source>Looking for unsaved work</source>
        <translation>Recherche de travail non enregistré</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
</context>
</TS>
