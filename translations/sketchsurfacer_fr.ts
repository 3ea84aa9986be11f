<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>ductus::AmbiguityPresenter</name>
    <message>
        <source>What the sketch leaves open</source>
        <translation>Ce que le croquis laisse ouvert</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>clair</translation>
    </message>
    <message>
        <source>open</source>
        <translation>ouvert</translation>
    </message>
    <message>
        <source>Looking for other readings</source>
        <translation>Recherche d’autres interprétations</translation>
    </message>
</context>
<context>
    <name>ductus::ExportDialog</name>
    <message>
        <source>OBJ - with regions as groups</source>
        <translation>OBJ - régions en groupes</translation>
    </message>
    <message>
        <source>PLY - with region numbers</source>
        <translation>PLY - avec numéros de région</translation>
    </message>
    <message>
        <source>STL - for printing</source>
        <translation>STL - pour l’impression</translation>
    </message>
    <message>
        <source>GLB - for the web and game engines</source>
        <translation>GLB - pour le web et les moteurs de jeu</translation>
    </message>
    <message>
        <source>OFF - plain</source>
        <translation>OFF - simple</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Exporter la surface</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centimètres</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
    <message>
        <source>Keep &amp;regions apart</source>
        <translation>&amp;Garder les régions séparées</translation>
    </message>
    <message>
        <source>Add &amp;creases as lines</source>
        <translation>&amp;Ajouter les plis sous forme de lignes</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Unité</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exporter...</translation>
    </message>
    <message>
        <source>GLB is always in metres.</source>
        <translation>GLB est toujours en mètres.</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 in the file, %4 triangles, about %5</source>
        <translation>%1 × %2 × %3 dans le fichier, %4 triangles, environ %5</translation>
    </message>
</context>
<context>
    <name>ductus::MeasuresPanel</name>
    <message>
        <source>metre</source>
        <translation>mètre</translation>
    </message>
    <message>
        <source>decimetre</source>
        <translation>décimètre</translation>
    </message>
    <message>
        <source>centimetre</source>
        <translation>centimètre</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>millimètre</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>pied</translation>
    </message>
    <message>
        <source>Half of the strokes&apos; points lie nearer to the surface than this; in brackets: 95 %.</source>
        <translation>La moitié des points des traits est plus proche de la surface que cela ; entre parenthèses : 95 %.</translation>
    </message>
    <message>
        <source>Unit of the sketch</source>
        <translation>Unité du croquis</translation>
    </message>
    <message>
        <source>What the number 1 of the sketch&apos;s file means. Nothing is scaled.</source>
        <translation>Ce que signifie le nombre 1 dans le fichier du croquis. Rien n’est mis à l’échelle.</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Axe vertical</translation>
    </message>
    <message>
        <source>y is up</source>
        <translation>y vers le haut</translation>
    </message>
    <message>
        <source>z is up</source>
        <translation>z vers le haut</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>Off the strokes</source>
        <translation>Écart aux traits</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Watertight</source>
        <translation>Étanche</translation>
    </message>
    <message>
        <source>&amp;One unit is a</source>
        <translation>&amp;Une unité vaut un</translation>
    </message>
    <message>
        <source>Ax&amp;es</source>
        <translation>&amp;Axes</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no, it has a border</source>
        <translation>non, elle a un bord</translation>
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
        <translation>Serrage</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How closely the first rough skin (the proxy) wraps the strokes: tight finds handles and holes, loose bridges gaps. Technically: alpha of the wrap.</source>
        <translation>À quel point la première enveloppe grossière (le proxy) colle aux traits : serrée, elle trouve anses et trous ; lâche, elle comble les vides. Techniquement : l’alpha de l’enveloppe.</translation>
    </message>
    <message>
        <source>loose</source>
        <translation>lâche</translation>
    </message>
    <message>
        <source>tight</source>
        <translation>serré</translation>
    </message>
    <message>
        <source>Choose tightness by itself</source>
        <translation>Choisir le serrage automatiquement</translation>
    </message>
    <message>
        <source>Takes the tightest skin that does not fall in between the strokes.</source>
        <translation>Prend l’enveloppe la plus serrée qui ne s’enfonce pas entre les traits.</translation>
    </message>
    <message>
        <source>Looseness</source>
        <translation>Souplesse</translation>
    </message>
    <message>
        <source>How far the surface may stay away from the strokes. Raise it for wobbly sketches. Technically: epsilon, in percent of the sketch&apos;s diagonal.</source>
        <translation>À quelle distance des traits la surface peut rester. À augmenter pour les croquis tremblés. Techniquement : epsilon, en pour cent de la diagonale du croquis.</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exact</translation>
    </message>
    <message>
        <source>Simplicity</source>
        <translation>Simplicité</translation>
    </message>
    <message>
        <source>How much few and simple surfaces are preferred to many. Technically: the weight of the label costs, w_simplicity, as a multiple of its default.</source>
        <translation>À quel point peu de surfaces simples sont préférées à beaucoup. Techniquement : le poids des coûts d’étiquette, w_simplicity, en multiple de sa valeur par défaut.</translation>
    </message>
    <message>
        <source>detailed</source>
        <translation>détaillé</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>simple</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>Only one half is solved and mirrored, welded exactly in the plane.</source>
        <translation>Seule une moitié est calculée puis reflétée, soudée exactement dans le plan.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Find it</source>
        <translation>La trouver</translation>
    </message>
    <message>
        <source>Mirror left–right (x)</source>
        <translation>Miroir gauche–droite (x)</translation>
    </message>
    <message>
        <source>Mirror along y</source>
        <translation>Miroir suivant y</translation>
    </message>
    <message>
        <source>Mirror along z</source>
        <translation>Miroir suivant z</translation>
    </message>
    <message>
        <source>S&amp;ymmetry</source>
        <translation>&amp;Symétrie</translation>
    </message>
    <message>
        <source>Change tightness</source>
        <translation>Modifier le serrage</translation>
    </message>
    <message>
        <source>Change looseness</source>
        <translation>Modifier la souplesse</translation>
    </message>
    <message>
        <source>Change simplicity</source>
        <translation>Modifier la simplicité</translation>
    </message>
    <message>
        <source>Change symmetry</source>
        <translation>Modifier la symétrie</translation>
    </message>
    <message>
        <source>Found: %1 % of the strokes mirror, %2 apart.</source>
        <translation>Trouvée : %1 % des traits se reflètent, à %2 près.</translation>
    </message>
    <message>
        <source>None was found.</source>
        <translation>Aucune n’a été trouvée.</translation>
    </message>
    <message>
        <source>A plane of its own</source>
        <translation>Un plan particulier</translation>
    </message>
</context>
<context>
    <name>ductus::PrintFindings</name>
    <message>
        <source>Watertight, in one piece.</source>
        <translation>Étanche, d’une seule pièce.</translation>
    </message>
    <message numerus="yes">
        <source>Watertight, in %n pieces.</source>
        <translation>
            <numerusform>Étanche, en %n pièce.</numerusform>
            <numerusform>Étanche, en %n pièces.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not watertight: the surface ends at a border. A printer needs a closed shape, or a sheet that is given a thickness elsewhere.</source>
        <translation>Non étanche : la surface se termine à un bord. Une imprimante demande une forme fermée, ou une feuille à laquelle on donne ailleurs une épaisseur.</translation>
    </message>
    <message>
        <source>ends here</source>
        <translation>se termine ici</translation>
    </message>
    <message>
        <source>Thinnest wall %1: less than one line of the nozzle, it will be missing. %2 of the surface is as thin.</source>
        <translation>Paroi la plus mince %1 : moins d’une ligne de la buse, elle manquera. %2 de la surface sont aussi minces.</translation>
    </message>
    <message>
        <source>Thinnest wall %1: less than two lines of the nozzle, it breaks easily. %2 of the surface is as thin.</source>
        <translation>Paroi la plus mince %1 : moins de deux lignes de la buse, elle casse facilement. %2 de la surface sont aussi minces.</translation>
    </message>
    <message>
        <source>Thinnest wall %1.</source>
        <translation>Paroi la plus mince %1.</translation>
    </message>
    <message>
        <source>Narrowest gap %1: less than one line of the nozzle, it will grow shut.</source>
        <translation>Fente la plus étroite %1 : moins d’une ligne de la buse, elle se bouchera.</translation>
    </message>
    <message>
        <source>Narrowest gap %1.</source>
        <translation>Fente la plus étroite %1.</translation>
    </message>
    <message>
        <source>Nowhere runs through itself.</source>
        <translation>Ne se traverse nulle part.</translation>
    </message>
    <message>
        <source>Runs through itself: slicers may leave holes there.</source>
        <translation>Se traverse elle-même : les trancheurs peuvent y laisser des trous.</translation>
    </message>
    <message>
        <source>runs through itself</source>
        <translation>se traverse elle-même</translation>
    </message>
    <message>
        <source>Pieces overlap: most slicers join them to one.</source>
        <translation>Des pièces se recouvrent : la plupart des trancheurs les réunissent.</translation>
    </message>
    <message>
        <source>pieces overlap</source>
        <translation>pièces superposées</translation>
    </message>
    <message>
        <source>Less than 1 %</source>
        <translation>Moins de 1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>ductus::PrintPanel</name>
    <message>
        <source>Longest side of the print</source>
        <translation>Plus grand côté de l’impression</translation>
    </message>
    <message>
        <source>How long the longest side is to be on the printer. Nothing is scaled; the check asks what would be too thin at that size.</source>
        <translation>La longueur du plus grand côté une fois imprimé. Rien n’est mis à l’échelle ; le contrôle cherche ce qui serait trop mince à cette taille.</translation>
    </message>
    <message>
        <source>Width of a line of the nozzle</source>
        <translation>Largeur d’une ligne de la buse</translation>
    </message>
    <message>
        <source>The width of the lines the printer lays; 0.4 mm is usual.</source>
        <translation>La largeur des lignes que dépose l’imprimante ; 0,4 mm est courant.</translation>
    </message>
    <message>
        <source>Lon&amp;gest side</source>
        <translation>&amp;Plus grand côté</translation>
    </message>
    <message>
        <source>&amp;Nozzle</source>
        <translation>&amp;Buse</translation>
    </message>
    <message>
        <source>Checking the print</source>
        <translation>Contrôle de l’impression</translation>
    </message>
    <message>
        <source>Looking at walls and gaps...</source>
        <translation>Examen des parois et des fentes...</translation>
    </message>
    <message>
        <source>Surface the sketch to see whether it can be printed.</source>
        <translation>Créez la surface du croquis pour savoir si elle est imprimable.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Show: %1</source>
        <translation>Montrer : %1</translation>
    </message>
    <message>
        <source>Turns the view to the place and marks it; Esc takes the mark away.</source>
        <translation>Tourne la vue vers l’endroit et le marque ; Échap retire la marque.</translation>
    </message>
</context>
<context>
    <name>ductus::ReadingList</name>
    <message>
        <source>&amp;Look for other readings</source>
        <translation>&amp;Chercher d’autres interprétations</translation>
    </message>
    <message>
        <source>Colours where the strokes allow more than one surface, and offers the others (A).</source>
        <translation>Colore les endroits où les traits permettent plus d’une surface et propose les autres (A).</translation>
    </message>
    <message>
        <source>Where strokes are few, they allow more than one surface.</source>
        <translation>Là où les traits sont rares, ils permettent plus d’une surface.</translation>
    </message>
    <message>
        <source>Trying what else the strokes could mean...</source>
        <translation>Recherche de ce que les traits pourraient aussi vouloir dire...</translation>
    </message>
    <message>
        <source>Surface the sketch to see what it leaves open.</source>
        <translation>Créez la surface du croquis pour voir ce qu’il laisse ouvert.</translation>
    </message>
    <message>
        <source>The strokes say enough: no other surface is nearly as likely.</source>
        <translation>Les traits suffisent : aucune autre surface n’est presque aussi probable.</translation>
    </message>
    <message>
        <source>The strokes could also mean this. Choose one, or draw a stroke where the surface is coloured.</source>
        <translation>Les traits pourraient aussi vouloir dire ceci. Choisissez une surface, ou dessinez un trait là où elle est colorée.</translation>
    </message>
    <message numerus="yes">
        <source>%n regions</source>
        <translation>
            <numerusform>%n région</numerusform>
            <numerusform>%n régions</numerusform>
        </translation>
    </message>
    <message>
        <source>as likely</source>
        <translation>aussi probable</translation>
    </message>
    <message>
        <source>nearly as likely</source>
        <translation>presque aussi probable</translation>
    </message>
    <message>
        <source>less likely</source>
        <translation>moins probable</translation>
    </message>
    <message>
        <source>Other reading %1: %2, %3</source>
        <translation>Autre interprétation %1 : %2, %3</translation>
    </message>
    <message>
        <source>Takes this surface instead. Undo brings the present one back.</source>
        <translation>Prend cette surface à la place. Annuler ramène l’actuelle.</translation>
    </message>
</context>
<context>
    <name>ductus::RegionList</name>
    <message>
        <source>plane</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>quadric</source>
        <translation>quadrique</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>cubique</translation>
    </message>
    <message>
        <source>quartic</source>
        <translation>quartique</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>surface</translation>
    </message>
    <message>
        <source>The regions appear here once the sketch is surfaced.</source>
        <translation>Les régions apparaissent ici une fois la surface créée.</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Régions</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Mean distance of its strokes from the region.</source>
        <translation>Distance moyenne de ses traits à la région.</translation>
    </message>
    <message>
        <source>Press Enter or right-click to change a region&apos;s kind; the lock keeps it as it is.</source>
        <translation>Entrée ou clic droit pour changer le type d’une région ; le cadenas la garde telle quelle.</translation>
    </message>
    <message>
        <source>Locked: stays as it is. Click to free it.</source>
        <translation>Verrouillée : reste telle quelle. Cliquer pour la libérer.</translation>
    </message>
    <message>
        <source>Click to keep this region as it is.</source>
        <translation>Cliquer pour garder cette région telle quelle.</translation>
    </message>
    <message>
        <source>Make it a %1</source>
        <translation>Changer en : %1</translation>
    </message>
    <message>
        <source>Lock or free it</source>
        <translation>Verrouiller ou libérer</translation>
    </message>
</context>
<context>
    <name>ductus::SketchDocument</name>
    <message>
        <source>Change role of strokes</source>
        <translation>Changer le rôle des traits</translation>
    </message>
    <message>
        <source>New region</source>
        <translation>Nouvelle région</translation>
    </message>
    <message>
        <source>Merge regions</source>
        <translation>Fusionner les régions</translation>
    </message>
    <message>
        <source>Draw seam</source>
        <translation>Tracer une couture</translation>
    </message>
    <message>
        <source>Forbid seam</source>
        <translation>Interdire une couture</translation>
    </message>
    <message>
        <source>Split region</source>
        <translation>Diviser la région</translation>
    </message>
    <message>
        <source>Lock region</source>
        <translation>Verrouiller la région</translation>
    </message>
    <message>
        <source>Change surface kind</source>
        <translation>Changer le type de surface</translation>
    </message>
    <message>
        <source>Remove scribble</source>
        <translation>Retirer le gribouillis</translation>
    </message>
    <message>
        <source>Remove all scribbles</source>
        <translation>Retirer tous les gribouillis</translation>
    </message>
    <message>
        <source>Draw stroke</source>
        <translation>Dessiner un trait</translation>
    </message>
    <message>
        <source>Move stroke</source>
        <translation>Déplacer le trait</translation>
    </message>
    <message numerus="yes">
        <source>Move %n strokes</source>
        <translation>
            <numerusform>Déplacer %n trait</numerusform>
            <numerusform>Déplacer %n traits</numerusform>
        </translation>
    </message>
    <message>
        <source>Bend stroke</source>
        <translation>Courber le trait</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>Supprimer le trait</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n strokes</source>
        <translation>
            <numerusform>Supprimer %n trait</numerusform>
            <numerusform>Supprimer %n traits</numerusform>
        </translation>
    </message>
    <message>
        <source>Use proxy from file</source>
        <translation>Utiliser un proxy d’un fichier</translation>
    </message>
    <message>
        <source>Make proxy automatically</source>
        <translation>Créer le proxy automatiquement</translation>
    </message>
    <message>
        <source>Change unit</source>
        <translation>Changer l’unité</translation>
    </message>
    <message>
        <source>Choose another surface</source>
        <translation>Choisir une autre surface</translation>
    </message>
    <message>
        <source>Surface anew</source>
        <translation>Recréer la surface</translation>
    </message>
    <message>
        <source>Paste strokes</source>
        <translation>Coller des traits</translation>
    </message>
</context>
<context>
    <name>ductus::SketchPresenter</name>
    <message>
        <source>Drawing the surface</source>
        <translation>Dessin de la surface</translation>
    </message>
    <message>
        <source>Strokes to surface</source>
        <translation>Des traits à la surface</translation>
    </message>
</context>
<context>
    <name>ductus::SketchView</name>
    <message>
        <source>Canvas</source>
        <translation>Toile</translation>
    </message>
</context>
<context>
    <name>ductus::StrokePanel</name>
    <message>
        <source>on the surface</source>
        <translation>sur la surface</translation>
    </message>
    <message>
        <source>border of the surface</source>
        <translation>bord de la surface</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignoré</translation>
    </message>
    <message>
        <source>inside, not used</source>
        <translation>intérieur, non utilisé</translation>
    </message>
    <message>
        <source>thin tube</source>
        <translation>tube fin</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>With strokes chosen: what they are for. Otherwise: what the role brush paints.</source>
        <translation>Si des traits sont choisis : à quoi ils servent. Sinon : ce que peint le pinceau de rôle.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Takes the chosen strokes out of the sketch (Del). Undo brings them back.</source>
        <translation>Retire du croquis les traits choisis (Suppr). Annuler les ramène.</translation>
    </message>
    <message>
        <source>&amp;Role</source>
        <translation>&amp;Rôle</translation>
    </message>
    <message>
        <source>Mark as &amp;border</source>
        <translation>&amp;Marquer comme bord</translation>
    </message>
    <message>
        <source>Nobody marked these strokes; the surface ends along them because nothing lies beyond. Marked, they stay its border whatever else is drawn.</source>
        <translation>Personne n’a marqué ces traits ; la surface s’y termine parce que rien ne se trouve au-delà. Marqués, ils en restent le bord quoi qu’on dessine.</translation>
    </message>
    <message numerus="yes">
        <source>Border found: the surface ends along %n strokes nobody marked.</source>
        <translation>
            <numerusform>Bord trouvé : la surface se termine le long de %n trait que personne n’a marqué.</numerusform>
            <numerusform>Bord trouvé : la surface se termine le long de %n traits que personne n’a marqués.</numerusform>
        </translation>
    </message>
    <message>
        <source>No stroke chosen</source>
        <translation>Aucun trait choisi</translation>
    </message>
    <message>
        <source>One stroke chosen</source>
        <translation>Un trait choisi</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes chosen</source>
        <translation>
            <numerusform>%n trait choisi</numerusform>
            <numerusform>%n traits choisis</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SurfaceButton</name>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stops and keeps the last surface (Esc).</source>
        <translation>Arrête et garde la dernière surface (Échap).</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>&amp;Mettre à jour</translation>
    </message>
    <message>
        <source>&amp;Surface it</source>
        <translation>&amp;Créer la surface</translation>
    </message>
    <message>
        <source>Finds the surface the strokes describe (Ctrl+Enter).</source>
        <translation>Trouve la surface que décrivent les traits (Ctrl+Entrée).</translation>
    </message>
    <message>
        <source>Open a sketch or draw strokes first.</source>
        <translation>Ouvrez un croquis ou dessinez d’abord des traits.</translation>
    </message>
    <message numerus="yes">
        <source>Up to date: %n regions</source>
        <translation>
            <numerusform>À jour : %n région</numerusform>
            <numerusform>À jour : %n régions</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 s</source>
        <translation>, %1 s</translation>
    </message>
    <message>
        <source>The surface is older than the sketch.</source>
        <translation>La surface est plus ancienne que le croquis.</translation>
    </message>
    <message numerus="yes">
        <source>%n points, not surfaced yet.</source>
        <translation>
            <numerusform>%n point, pas encore de surface.</numerusform>
            <numerusform>%n points, pas encore de surface.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes, not surfaced yet.</source>
        <translation>
            <numerusform>%n trait, pas encore de surface.</numerusform>
            <numerusform>%n traits, pas encore de surface.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SurfacerWindow</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>&amp;New sketch</source>
        <translation>&amp;Nouveau croquis</translation>
    </message>
    <message>
        <source>Begins with an empty canvas to draw on.</source>
        <translation>Commence par une toile vide.</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Ouvrir...</translation>
    </message>
    <message>
        <source>Opens a project, or a sketch of another program.</source>
        <translation>Ouvre un projet, ou un croquis d’un autre programme.</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Page d’accueil</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the sketch stays open.</source>
        <translation>Montre exemples et fichiers récents ; le croquis reste ouvert.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Saves sketch, decisions and surface.</source>
        <translation>Enregistre croquis, décisions et surface.</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Enregistrer &amp;sous...</translation>
    </message>
    <message>
        <source>Saves under another name.</source>
        <translation>Enregistre sous un autre nom.</translation>
    </message>
    <message>
        <source>&amp;Export surface...</source>
        <translation>E&amp;xporter la surface...</translation>
    </message>
    <message>
        <source>Writes OBJ, PLY, STL, GLB or OFF for other programs.</source>
        <translation>Écrit OBJ, PLY, STL, GLB ou OFF pour d’autres programmes.</translation>
    </message>
    <message>
        <source>Send to &amp;LayerPainter</source>
        <translation>En&amp;voyer à LayerPainter</translation>
    </message>
    <message>
        <source>Opens the project in LayerPainter, to paint on the surface.</source>
        <translation>Ouvre le projet dans LayerPainter pour peindre sur la surface.</translation>
    </message>
    <message>
        <source>Save p&amp;icture...</source>
        <translation>Enregistrer &amp;l’image...</translation>
    </message>
    <message>
        <source>Writes what the canvas shows as a PNG file.</source>
        <translation>Écrit ce que montre la toile dans un fichier PNG.</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>Save t&amp;urntable...</source>
        <translation>Enregistrer &amp;une rotation...</translation>
    </message>
    <message>
        <source>Writes a round of 72 pictures into a folder, to be made a film of.</source>
        <translation>Écrit un tour de 72 images dans un dossier, pour en faire un film.</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Dossier des images</translation>
    </message>
    <message>
        <source>&amp;Paste sketch</source>
        <translation>&amp;Coller le croquis</translation>
    </message>
    <message>
        <source>&amp;Delete strokes</source>
        <translation>&amp;Supprimer les traits</translation>
    </message>
    <message>
        <source>Takes the chosen strokes out of the sketch.</source>
        <translation>Retire du croquis les traits choisis.</translation>
    </message>
    <message>
        <source>Choose &amp;all strokes</source>
        <translation>C&amp;hoisir tous les traits</translation>
    </message>
    <message>
        <source>So that one act changes them all.</source>
        <translation>Pour qu’une seule action les change tous.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Interrompre</translation>
    </message>
    <message>
        <source>Stops what runs, forgets what was begun, goes back to the arrow.</source>
        <translation>Arrête ce qui tourne, oublie ce qui était commencé, revient à la flèche.</translation>
    </message>
    <message>
        <source>&amp;Surface it</source>
        <translation>Créer &amp;la surface</translation>
    </message>
    <message>
        <source>Finds the surface the strokes describe.</source>
        <translation>Trouve la surface que décrivent les traits.</translation>
    </message>
    <message>
        <source>Surface a&amp;new</source>
        <translation>&amp;Recréer la surface</translation>
    </message>
    <message>
        <source>Forgets the way here: edited strokes are usually worked into the surface there is.</source>
        <translation>Oublie le chemin parcouru : d’ordinaire, les traits modifiés sont intégrés à la surface existante.</translation>
    </message>
    <message>
        <source>&amp;Update by itself</source>
        <translation>&amp;Mettre à jour automatiquement</translation>
    </message>
    <message>
        <source>After a scribble or a moved slider the surface follows without a click.</source>
        <translation>Après un gribouillis ou un réglage, la surface suit sans clic.</translation>
    </message>
    <message>
        <source>Remove all s&amp;cribbles</source>
        <translation>Retirer &amp;tous les gribouillis</translation>
    </message>
    <message>
        <source>Back to the regions found automatically.</source>
        <translation>Retour aux régions trouvées automatiquement.</translation>
    </message>
    <message>
        <source>Use &amp;proxy from file...</source>
        <translation>&amp;Utiliser un proxy d’un fichier...</translation>
    </message>
    <message>
        <source>Takes a mesh made elsewhere as the rough skin the strokes are read on.</source>
        <translation>Prend un maillage fait ailleurs comme enveloppe grossière sur laquelle lire les traits.</translation>
    </message>
    <message>
        <source>Make proxy &amp;automatically</source>
        <translation>Créer le &amp;proxy automatiquement</translation>
    </message>
    <message>
        <source>Forgets the mesh from a file.</source>
        <translation>Oublie le maillage d’un fichier.</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Sélection</translation>
    </message>
    <message>
        <source>Drag turns the view, a click chooses a stroke or region.</source>
        <translation>Glisser tourne la vue, un clic choisit un trait ou une région.</translation>
    </message>
    <message>
        <source>&amp;Role brush</source>
        <translation>&amp;Pinceau de rôle</translation>
    </message>
    <message>
        <source>Paint over strokes to say what they are: border, ignored, ...</source>
        <translation>Peignez sur les traits pour dire ce qu’ils sont : bord, ignoré, ...</translation>
    </message>
    <message>
        <source>&amp;Draw stroke</source>
        <translation>&amp;Dessiner un trait</translation>
    </message>
    <message>
        <source>Add the stroke that was missing; the surface follows.</source>
        <translation>Ajoutez le trait qui manquait ; la surface suit.</translation>
    </message>
    <message>
        <source>&amp;New region</source>
        <translation>&amp;Nouvelle région</translation>
    </message>
    <message>
        <source>Yellow: what you scribble over becomes a surface of its own.</source>
        <translation>Jaune : ce que vous gribouillez devient une surface à part.</translation>
    </message>
    <message>
        <source>&amp;Merge regions</source>
        <translation>&amp;Fusionner les régions</translation>
    </message>
    <message>
        <source>Green: the regions you connect become one.</source>
        <translation>Vert : les régions que vous reliez n’en font plus qu’une.</translation>
    </message>
    <message>
        <source>Red: a crease must run exactly here.</source>
        <translation>Rouge : un pli doit passer exactement ici.</translation>
    </message>
    <message>
        <source>S&amp;plit region</source>
        <translation>Diviser &amp;la région</translation>
    </message>
    <message>
        <source>Orange: cuts a region in two along your line.</source>
        <translation>Orange : coupe une région en deux le long de votre ligne.</translation>
    </message>
    <message>
        <source>&amp;Forbid seam</source>
        <translation>&amp;Interdire une couture</translation>
    </message>
    <message>
        <source>Blue: no crease may run here.</source>
        <translation>Bleu : aucun pli ne peut passer ici.</translation>
    </message>
    <message>
        <source>&amp;Lock region</source>
        <translation>&amp;Verrouiller la région</translation>
    </message>
    <message>
        <source>A locked region stays as it is, whatever else changes.</source>
        <translation>Une région verrouillée reste telle quelle, quoi qu’il change.</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <source>The length between two points.</source>
        <translation>La longueur entre deux points.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Face</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Arrière</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>D&amp;roite</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Gauche</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Dessus</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>D&amp;essous</translation>
    </message>
    <message>
        <source>Three-&amp;quarter</source>
        <translation>&amp;Trois quarts</translation>
    </message>
    <message>
        <source>Looks from there.</source>
        <translation>Regarde depuis là.</translation>
    </message>
    <message>
        <source>Fr&amp;ame all</source>
        <translation>T&amp;out cadrer</translation>
    </message>
    <message>
        <source>Brings the whole sketch into view.</source>
        <translation>Met tout le croquis dans la vue.</translation>
    </message>
    <message>
        <source>Comes nearer.</source>
        <translation>S’approche.</translation>
    </message>
    <message>
        <source>Zoom o&amp;ut</source>
        <translation>&amp;Zoom arrière</translation>
    </message>
    <message>
        <source>Steps back.</source>
        <translation>Recule.</translation>
    </message>
    <message>
        <source>Turn view (%1)</source>
        <translation>Tourner la vue (%1)</translation>
    </message>
    <message>
        <source>Turns the view without a mouse.</source>
        <translation>Tourne la vue sans souris.</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>P&amp;erspective</translation>
    </message>
    <message>
        <source>Far things smaller; off for measuring by eye.</source>
        <translation>Le lointain plus petit ; désactivée pour mesurer à l’œil.</translation>
    </message>
    <message>
        <source>Shows the sketch on top of the surface.</source>
        <translation>Montre le croquis par-dessus la surface.</translation>
    </message>
    <message>
        <source>Turns the view by itself, to look at it from all sides.</source>
        <translation>Fait tourner la vue pour la regarder de tous côtés.</translation>
    </message>
    <message>
        <source>&amp;Mirror drawn strokes</source>
        <translation>Refléter &amp;les traits dessinés</translation>
    </message>
    <message>
        <source>Where the sketch is symmetric a stroke comes with its mirror image.</source>
        <translation>Là où le croquis est symétrique, un trait vient avec son reflet.</translation>
    </message>
    <message>
        <source>What the sketch leaves &amp;open</source>
        <translation>Ce &amp;que le croquis laisse ouvert</translation>
    </message>
    <message>
        <source>Colours where the strokes allow more than one surface; a click there offers the others.</source>
        <translation>Colore les endroits où les traits permettent plus d’une surface ; un clic y propose les autres.</translation>
    </message>
    <message>
        <source>&amp;Compare with the sketch</source>
        <translation>Co&amp;mparer au croquis</translation>
    </message>
    <message>
        <source>A line to drag: the sketch at its left, the surface at its right.</source>
        <translation>Une ligne à faire glisser : le croquis à gauche, la surface à droite.</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Surface</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Outils</translation>
    </message>
    <message>
        <source>SketchSurfacer</source>
        <translation>SketchSurfacer</translation>
    </message>
    <message>
        <source>From a 3D sketch to a surface you can print, render or take into CAD.</source>
        <translation>Du croquis 3D à une surface à imprimer, à rendre ou à reprendre en CAO.</translation>
    </message>
    <message>
        <source>New sketch</source>
        <translation>Nouveau croquis</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Ouvrir...</translation>
    </message>
    <message>
        <source>Drop a sketch (.curves, .obj, .txt), points (.xyz), a proxy mesh or a project anywhere.</source>
        <translation>Déposez n’importe où un croquis (.curves, .obj, .txt), des points (.xyz), un maillage proxy ou un projet.</translation>
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
        <source>Sketches and projects (*.ductus *.curves *.obj *.txt *.xyz *.crv);;Proxy meshes (*.ply *.stl *.off *.glb *.obj);;All files (*)</source>
        <translation>Croquis et projets (*.ductus *.curves *.obj *.txt *.xyz *.crv);;Maillages proxy (*.ply *.stl *.off *.glb *.obj);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>The clipboard holds neither strokes nor a path to a file.</source>
        <translation>Le presse-papiers ne contient ni traits ni chemin de fichier.</translation>
    </message>
    <message>
        <source>Reading the clipboard</source>
        <translation>Lecture du presse-papiers</translation>
    </message>
    <message>
        <source>Pasted</source>
        <translation>Collé</translation>
    </message>
    <message numerus="yes">
        <source>These %n points do not follow one another: they are taken as points of the surface, and creases are found by its shape alone.</source>
        <translation>
            <numerusform>Ce %n point n’a pas de suite : il est pris comme point de la surface, et les plis sont trouvés par sa seule forme.</numerusform>
            <numerusform>Ces %n points ne se suivent pas : ils sont pris comme points de la surface, et les plis sont trouvés par sa seule forme.</numerusform>
        </translation>
    </message>
    <message>
        <source>A stroke looks like a cable and becomes a thin tube. If it is none, select it and set its role to “on the surface”.</source>
        <translation>Un trait ressemble à un câble et devient un tube fin. Si ce n’en est pas un, sélectionnez-le et donnez-lui le rôle « sur la surface ».</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes look like cables and become thin tubes. Where one is none, select it and set its role to “on the surface”.</source>
        <translation>
            <numerusform>%n trait ressemble à un câble et devient un tube fin. Si ce n’en est pas un, sélectionnez-le et donnez-lui le rôle « sur la surface ».</numerusform>
            <numerusform>%n traits ressemblent à des câbles et deviennent des tubes fins. Si l’un d’eux n’en est pas un, sélectionnez-le et donnez-lui le rôle « sur la surface ».</numerusform>
        </translation>
    </message>
    <message>
        <source>Some of the sketch was skipped: %1</source>
        <translation>Une partie du croquis a été ignorée : %1</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Et %n autre.</numerusform>
            <numerusform>Et %n autres.</numerusform>
        </translation>
    </message>
    <message>
        <source>A mesh serves as the proxy of a sketch. Open the sketch first, then the mesh.</source>
        <translation>Un maillage sert de proxy à un croquis. Ouvrez d’abord le croquis, puis le maillage.</translation>
    </message>
    <message>
        <source>Reading the proxy</source>
        <translation>Lecture du proxy</translation>
    </message>
    <message>
        <source>%1 is the proxy now.</source>
        <translation>%1 est maintenant le proxy.</translation>
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
        <source>LayerPainter paints on the surface, and there is none yet.</source>
        <translation>LayerPainter peint sur la surface, et il n’y en a pas encore.</translation>
    </message>
    <message>
        <source>Surface it</source>
        <translation>Créer la surface</translation>
    </message>
    <message>
        <source>LayerPainter opens %1.</source>
        <translation>LayerPainter ouvre %1.</translation>
    </message>
    <message>
        <source>LayerPainter reads the saved project, and this one has changes.</source>
        <translation>LayerPainter lit le projet enregistré, et celui-ci a des modifications.</translation>
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
        <source>Export surface</source>
        <translation>Exporter la surface</translation>
    </message>
    <message>
        <source>Exporting the surface</source>
        <translation>Export de la surface</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Exporté vers %1.</translation>
    </message>
    <message>
        <source>Writing the picture</source>
        <translation>Écriture de l’image</translation>
    </message>
    <message>
        <source>The picture is in %1.</source>
        <translation>L’image est dans %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures are in %1.</source>
        <translation>
            <numerusform>%n image est dans %1.</numerusform>
            <numerusform>%n images sont dans %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Croquis</translation>
    </message>
    <message>
        <source>The strokes alone.</source>
        <translation>Les traits seuls.</translation>
    </message>
    <message>
        <source>Proxy</source>
        <translation>Proxy</translation>
    </message>
    <message>
        <source>The rough skin the strokes are read on.</source>
        <translation>L’enveloppe grossière sur laquelle les traits sont lus.</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Régions</translation>
    </message>
    <message>
        <source>Which parts are one smooth surface each.</source>
        <translation>Quelles parties forment chacune une surface lisse.</translation>
    </message>
    <message>
        <source>The finished surface in clay.</source>
        <translation>La surface finie en argile.</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>How far strokes and surface are apart.</source>
        <translation>La distance entre traits et surface.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Other readings</source>
        <translation>Autres interprétations</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Print check</source>
        <translation>Contrôle d’impression</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Install a graphics driver, or the software one: libgl1-mesa-dri.</source>
        <translation>Installez un pilote graphique, ou le pilote logiciel : libgl1-mesa-dri.</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillée</translation>
    </message>
    <message>
        <source>%1 % open</source>
        <translation>%1 % ouvert</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>trait %1</translation>
    </message>
    <message>
        <source>border found</source>
        <translation>bord trouvé</translation>
    </message>
    <message>
        <source>at most %1 off</source>
        <translation>écart de %1 au plus</translation>
    </message>
    <message>
        <source>Surface the sketch first.</source>
        <translation>Créez d’abord la surface.</translation>
    </message>
    <message>
        <source>Nothing drawn yet. Press D and draw the first stroke, or drop a sketch here.</source>
        <translation>Rien n’est dessiné. Appuyez sur D et dessinez le premier trait, ou déposez ici un croquis.</translation>
    </message>
    <message>
        <source>&amp;Copy strokes</source>
        <translation>Copier les &amp;traits</translation>
    </message>
    <message>
        <source>Puts the chosen strokes, or all, on the clipboard, for the other apps of the suite as well.</source>
        <translation>Met les traits choisis, ou tous, dans le presse-papiers, aussi pour les autres applications de la suite.</translation>
    </message>
    <message>
        <source>Adds strokes copied in this or another app of the suite, or opens text or a file.</source>
        <translation>Ajoute des traits copiés dans cette application ou une autre de la suite, ou ouvre un texte ou un fichier.</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes pasted.</source>
        <translation>
            <numerusform>%n trait collé.</numerusform>
            <numerusform>%n traits collés.</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no strokes to copy yet.</source>
        <translation>Il n’y a pas encore de traits à copier.</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes copied.</source>
        <translation>
            <numerusform>%n trait copié.</numerusform>
            <numerusform>%n traits copiés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Se&amp;am</source>
        <translation>&amp;Couture</translation>
    </message>
    <message>
        <source>&amp;Zoom in</source>
        <translation>Zoom &amp;avant</translation>
    </message>
    <message>
        <source>St&amp;rokes on the surface</source>
        <translation>Traits sur &amp;la surface</translation>
    </message>
    <message>
        <source>&amp;Turntable</source>
        <translation>&amp;Rotation continue</translation>
    </message>
    <message>
        <source>Loo&amp;k from</source>
        <translation>Regarder &amp;depuis</translation>
    </message>
</context>
<context>
    <name>ductus::SurfacingJobs</name>
    <message>
        <source>Surfacing the sketch</source>
        <translation>Création de la surface du croquis</translation>
    </message>
</context>
<context>
    <name>ductus::ToolBox</name>
    <message>
        <source>There is no region here. Surface the sketch and click one of its regions.</source>
        <translation>Il n’y a pas de région ici. Créez la surface et cliquez sur une de ses régions.</translation>
    </message>
    <message>
        <source>Drag a handle to bend the stroke; with Ctrl it slides over the surface, the wheel widens the bend. Drag the stroke between handles to move it.</source>
        <translation>Tirez une poignée pour courber le trait ; avec Ctrl il glisse sur la surface, la molette élargit la courbure. Tirez le trait entre les poignées pour le déplacer.</translation>
    </message>
    <message>
        <source>Drag to turn, wheel to zoom. Click a stroke or region to choose it, Shift+drag around several; drag chosen strokes to move them.</source>
        <translation>Glisser pour tourner, molette pour zoomer. Cliquez sur un trait ou une région pour le choisir, Maj+glisser pour en entourer plusieurs ; faites glisser les traits choisis pour les déplacer.</translation>
    </message>
    <message>
        <source>Paint over strokes to tell what they mean; the role is chosen in the inspector.</source>
        <translation>Peignez sur les traits pour dire ce qu’ils veulent dire ; le rôle se choisit dans l’inspecteur.</translation>
    </message>
    <message>
        <source>Draw on the surface, or in the air facing you; begin at a stroke to snap to it.</source>
        <translation>Dessinez sur la surface, ou dans l’air face à vous ; partez d’un trait pour vous y accrocher.</translation>
    </message>
    <message>
        <source>Scribble over what should be a surface of its own.</source>
        <translation>Gribouillez sur ce qui doit être une surface à part.</translation>
    </message>
    <message>
        <source>Draw from one region into another: they become one smooth surface.</source>
        <translation>Tracez d’une région à l’autre : elles deviennent une seule surface lisse.</translation>
    </message>
    <message>
        <source>Draw where two surfaces must meet in a crease.</source>
        <translation>Tracez là où deux surfaces doivent se rencontrer en un pli.</translation>
    </message>
    <message>
        <source>Draw across a region to cut it in two.</source>
        <translation>Tracez en travers d’une région pour la couper en deux.</translation>
    </message>
    <message>
        <source>Draw along a crease that should not be there.</source>
        <translation>Tracez le long d’un pli qui ne devrait pas exister.</translation>
    </message>
    <message>
        <source>Click a region to keep it as it is; click again to free it.</source>
        <translation>Cliquez sur une région pour la garder telle quelle ; recliquez pour la libérer.</translation>
    </message>
    <message>
        <source>Click two points to measure between them.</source>
        <translation>Cliquez sur deux points pour mesurer entre eux.</translation>
    </message>
</context>
<context>
    <name>ductus::VtkWidget</name>
    <message>
        <source>This computer&apos;s graphics driver offers no OpenGL 3.2.</source>
        <translation>Le pilote graphique de cet ordinateur n’offre pas OpenGL 3.2.</translation>
    </message>
</context>
</TS>
