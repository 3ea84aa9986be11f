<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>ductus::AmbiguityPresenter</name>
    <message>
        <source>What the sketch leaves open</source>
        <translation>Lo que el boceto deja abierto</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>claro</translation>
    </message>
    <message>
        <source>open</source>
        <translation>abierto</translation>
    </message>
    <message>
        <source>Looking for other readings</source>
        <translation>Búsqueda de otras interpretaciones</translation>
    </message>
</context>
<context>
    <name>ductus::ExportDialog</name>
    <message>
        <source>OBJ - with regions as groups</source>
        <translation>OBJ - con las regiones como grupos</translation>
    </message>
    <message>
        <source>PLY - with region numbers</source>
        <translation>PLY - con números de región</translation>
    </message>
    <message>
        <source>STL - for printing</source>
        <translation>STL - para imprimir</translation>
    </message>
    <message>
        <source>GLB - for the web and game engines</source>
        <translation>GLB - para web y motores de juego</translation>
    </message>
    <message>
        <source>OFF - plain</source>
        <translation>OFF - sencillo</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Exportar superficie</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>Keep &amp;regions apart</source>
        <translation>&amp;Mantener separadas las regiones</translation>
    </message>
    <message>
        <source>Add &amp;creases as lines</source>
        <translation>&amp;Añadir los pliegues como líneas</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formato</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Unidad</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportar...</translation>
    </message>
    <message>
        <source>GLB is always in metres.</source>
        <translation>GLB siempre está en metros.</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 in the file, %4 triangles, about %5</source>
        <translation>%1 × %2 × %3 en el archivo, %4 triángulos, unos %5</translation>
    </message>
</context>
<context>
    <name>ductus::MeasuresPanel</name>
    <message>
        <source>metre</source>
        <translation>metro</translation>
    </message>
    <message>
        <source>decimetre</source>
        <translation>decímetro</translation>
    </message>
    <message>
        <source>centimetre</source>
        <translation>centímetro</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>milímetro</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pulgada</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>pie</translation>
    </message>
    <message>
        <source>Half of the strokes&apos; points lie nearer to the surface than this; in brackets: 95 %.</source>
        <translation>La mitad de los puntos de los trazos está más cerca de la superficie que esto; entre paréntesis: el 95 %.</translation>
    </message>
    <message>
        <source>Unit of the sketch</source>
        <translation>Unidad del boceto</translation>
    </message>
    <message>
        <source>What the number 1 of the sketch&apos;s file means. Nothing is scaled.</source>
        <translation>Qué significa el número 1 en el archivo del boceto. No se escala nada.</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Eje vertical</translation>
    </message>
    <message>
        <source>y is up</source>
        <translation>y hacia arriba</translation>
    </message>
    <message>
        <source>z is up</source>
        <translation>z hacia arriba</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>Off the strokes</source>
        <translation>Desviación</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Watertight</source>
        <translation>Estanca</translation>
    </message>
    <message>
        <source>&amp;One unit is a</source>
        <translation>&amp;Una unidad es un</translation>
    </message>
    <message>
        <source>Ax&amp;es</source>
        <translation>&amp;Ejes</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n punto</numerusform>
            <numerusform>%n puntos</numerusform>
        </translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no, it has a border</source>
        <translation>no, tiene un borde</translation>
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
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How closely the first rough skin (the proxy) wraps the strokes: tight finds handles and holes, loose bridges gaps. Technically: alpha of the wrap.</source>
        <translation>Con cuánta fuerza la primera envoltura (el proxy) se ciñe a los trazos: ceñida halla asas y agujeros; holgada salva huecos. Técnicamente: alfa de la envoltura.</translation>
    </message>
    <message>
        <source>loose</source>
        <translation>holgado</translation>
    </message>
    <message>
        <source>tight</source>
        <translation>ceñido</translation>
    </message>
    <message>
        <source>Choose tightness by itself</source>
        <translation>Elegir el ajuste automáticamente</translation>
    </message>
    <message>
        <source>Takes the tightest skin that does not fall in between the strokes.</source>
        <translation>Toma la envoltura más ceñida que no se hunde entre los trazos.</translation>
    </message>
    <message>
        <source>Looseness</source>
        <translation>Holgura</translation>
    </message>
    <message>
        <source>How far the surface may stay away from the strokes. Raise it for wobbly sketches. Technically: epsilon, in percent of the sketch&apos;s diagonal.</source>
        <translation>Cuánto puede alejarse la superficie de los trazos. Auméntelo en bocetos temblorosos. Técnicamente: épsilon, en tanto por ciento de la diagonal del boceto.</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exacto</translation>
    </message>
    <message>
        <source>Simplicity</source>
        <translation>Sencillez</translation>
    </message>
    <message>
        <source>How much few and simple surfaces are preferred to many. Technically: the weight of the label costs, w_simplicity, as a multiple of its default.</source>
        <translation>Cuánto se prefieren pocas superficies simples a muchas. Técnicamente: el peso de los costes de etiqueta, w_simplicity, como múltiplo de su valor predeterminado.</translation>
    </message>
    <message>
        <source>detailed</source>
        <translation>detallado</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>simple</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simetría</translation>
    </message>
    <message>
        <source>Only one half is solved and mirrored, welded exactly in the plane.</source>
        <translation>Solo se calcula una mitad y se refleja, soldada exactamente en el plano.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Find it</source>
        <translation>Buscarla</translation>
    </message>
    <message>
        <source>Mirror left–right (x)</source>
        <translation>Reflejar izquierda–derecha (x)</translation>
    </message>
    <message>
        <source>Mirror along y</source>
        <translation>Reflejar a lo largo de y</translation>
    </message>
    <message>
        <source>Mirror along z</source>
        <translation>Reflejar a lo largo de z</translation>
    </message>
    <message>
        <source>S&amp;ymmetry</source>
        <translation>&amp;Simetría</translation>
    </message>
    <message>
        <source>Change tightness</source>
        <translation>Cambiar el ajuste</translation>
    </message>
    <message>
        <source>Change looseness</source>
        <translation>Cambiar la holgura</translation>
    </message>
    <message>
        <source>Change simplicity</source>
        <translation>Cambiar la sencillez</translation>
    </message>
    <message>
        <source>Change symmetry</source>
        <translation>Cambiar la simetría</translation>
    </message>
    <message>
        <source>Found: %1 % of the strokes mirror, %2 apart.</source>
        <translation>Hallada: el %1 % de los trazos se refleja, con %2 de diferencia.</translation>
    </message>
    <message>
        <source>None was found.</source>
        <translation>No se ha encontrado ninguna.</translation>
    </message>
    <message>
        <source>A plane of its own</source>
        <translation>Un plano propio</translation>
    </message>
</context>
<context>
    <name>ductus::PrintFindings</name>
    <message>
        <source>Watertight, in one piece.</source>
        <translation>Estanca, de una sola pieza.</translation>
    </message>
    <message numerus="yes">
        <source>Watertight, in %n pieces.</source>
        <translation>
            <numerusform>Estanca, en %n pieza.</numerusform>
            <numerusform>Estanca, en %n piezas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not watertight: the surface ends at a border. A printer needs a closed shape, or a sheet that is given a thickness elsewhere.</source>
        <translation>No es estanca: la superficie termina en un borde. Una impresora necesita una forma cerrada, o una lámina a la que se dé grosor en otro programa.</translation>
    </message>
    <message>
        <source>ends here</source>
        <translation>termina aquí</translation>
    </message>
    <message>
        <source>Thinnest wall %1: less than one line of the nozzle, it will be missing. %2 of the surface is as thin.</source>
        <translation>Pared más fina %1: menos que una línea de la boquilla, faltará. El %2 de la superficie es igual de fino.</translation>
    </message>
    <message>
        <source>Thinnest wall %1: less than two lines of the nozzle, it breaks easily. %2 of the surface is as thin.</source>
        <translation>Pared más fina %1: menos que dos líneas de la boquilla, se rompe con facilidad. El %2 de la superficie es igual de fino.</translation>
    </message>
    <message>
        <source>Thinnest wall %1.</source>
        <translation>Pared más fina %1.</translation>
    </message>
    <message>
        <source>Narrowest gap %1: less than one line of the nozzle, it will grow shut.</source>
        <translation>Hueco más estrecho %1: menos que una línea de la boquilla, se cerrará.</translation>
    </message>
    <message>
        <source>Narrowest gap %1.</source>
        <translation>Hueco más estrecho %1.</translation>
    </message>
    <message>
        <source>Nowhere runs through itself.</source>
        <translation>No se atraviesa en ningún sitio.</translation>
    </message>
    <message>
        <source>Runs through itself: slicers may leave holes there.</source>
        <translation>Se atraviesa a sí misma: los laminadores pueden dejar agujeros ahí.</translation>
    </message>
    <message>
        <source>runs through itself</source>
        <translation>se atraviesa a sí misma</translation>
    </message>
    <message>
        <source>Pieces overlap: most slicers join them to one.</source>
        <translation>Hay piezas que se solapan: la mayoría de los laminadores las unen.</translation>
    </message>
    <message>
        <source>pieces overlap</source>
        <translation>piezas solapadas</translation>
    </message>
    <message>
        <source>Less than 1 %</source>
        <translation>Menos del 1 %</translation>
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
        <translation>Lado más largo de la impresión</translation>
    </message>
    <message>
        <source>How long the longest side is to be on the printer. Nothing is scaled; the check asks what would be too thin at that size.</source>
        <translation>Cuánto medirá el lado más largo impreso. No se escala nada; se comprueba qué sería demasiado fino a ese tamaño.</translation>
    </message>
    <message>
        <source>Width of a line of the nozzle</source>
        <translation>Anchura de línea de la boquilla</translation>
    </message>
    <message>
        <source>The width of the lines the printer lays; 0.4 mm is usual.</source>
        <translation>La anchura de las líneas que deposita la impresora; lo habitual es 0,4 mm.</translation>
    </message>
    <message>
        <source>Lon&amp;gest side</source>
        <translation>&amp;Lado más largo</translation>
    </message>
    <message>
        <source>&amp;Nozzle</source>
        <translation>&amp;Boquilla</translation>
    </message>
    <message>
        <source>Checking the print</source>
        <translation>Comprobación de la impresión</translation>
    </message>
    <message>
        <source>Looking at walls and gaps...</source>
        <translation>Examinando paredes y huecos...</translation>
    </message>
    <message>
        <source>Surface the sketch to see whether it can be printed.</source>
        <translation>Cree la superficie del boceto para ver si se puede imprimir.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Show: %1</source>
        <translation>Mostrar: %1</translation>
    </message>
    <message>
        <source>Turns the view to the place and marks it; Esc takes the mark away.</source>
        <translation>Gira la vista hacia el lugar y lo marca; Esc quita la marca.</translation>
    </message>
</context>
<context>
    <name>ductus::ReadingList</name>
    <message>
        <source>&amp;Look for other readings</source>
        <translation>&amp;Buscar otras interpretaciones</translation>
    </message>
    <message>
        <source>Colours where the strokes allow more than one surface, and offers the others (A).</source>
        <translation>Colorea donde los trazos permiten más de una superficie y ofrece las otras (A).</translation>
    </message>
    <message>
        <source>Where strokes are few, they allow more than one surface.</source>
        <translation>Donde hay pocos trazos, permiten más de una superficie.</translation>
    </message>
    <message>
        <source>Trying what else the strokes could mean...</source>
        <translation>Probando qué más podrían significar los trazos...</translation>
    </message>
    <message>
        <source>Surface the sketch to see what it leaves open.</source>
        <translation>Cree la superficie del boceto para ver qué deja abierto.</translation>
    </message>
    <message>
        <source>The strokes say enough: no other surface is nearly as likely.</source>
        <translation>Los trazos bastan: ninguna otra superficie es casi tan probable.</translation>
    </message>
    <message>
        <source>The strokes could also mean this. Choose one, or draw a stroke where the surface is coloured.</source>
        <translation>Los trazos también podrían significar esto. Elija una, o dibuje un trazo donde la superficie está coloreada.</translation>
    </message>
    <message numerus="yes">
        <source>%n regions</source>
        <translation>
            <numerusform>%n región</numerusform>
            <numerusform>%n regiones</numerusform>
        </translation>
    </message>
    <message>
        <source>as likely</source>
        <translation>igual de probable</translation>
    </message>
    <message>
        <source>nearly as likely</source>
        <translation>casi igual de probable</translation>
    </message>
    <message>
        <source>less likely</source>
        <translation>menos probable</translation>
    </message>
    <message>
        <source>Other reading %1: %2, %3</source>
        <translation>Otra interpretación %1: %2, %3</translation>
    </message>
    <message>
        <source>Takes this surface instead. Undo brings the present one back.</source>
        <translation>Toma esta superficie en su lugar. Deshacer recupera la actual.</translation>
    </message>
</context>
<context>
    <name>ductus::RegionList</name>
    <message>
        <source>plane</source>
        <translation>plano</translation>
    </message>
    <message>
        <source>quadric</source>
        <translation>cuádrica</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>cúbica</translation>
    </message>
    <message>
        <source>quartic</source>
        <translation>cuártica</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>superficie</translation>
    </message>
    <message>
        <source>The regions appear here once the sketch is surfaced.</source>
        <translation>Las regiones aparecen aquí cuando se crea la superficie.</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regiones</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>Desvío</translation>
    </message>
    <message>
        <source>Mean distance of its strokes from the region.</source>
        <translation>Distancia media de sus trazos a la región.</translation>
    </message>
    <message>
        <source>Press Enter or right-click to change a region&apos;s kind; the lock keeps it as it is.</source>
        <translation>Pulse Intro o haga clic derecho para cambiar el tipo de una región; el candado la mantiene como está.</translation>
    </message>
    <message>
        <source>Locked: stays as it is. Click to free it.</source>
        <translation>Bloqueada: se queda como está. Haga clic para liberarla.</translation>
    </message>
    <message>
        <source>Click to keep this region as it is.</source>
        <translation>Haga clic para mantener esta región como está.</translation>
    </message>
    <message>
        <source>Make it a %1</source>
        <translation>Convertir en %1</translation>
    </message>
    <message>
        <source>Lock or free it</source>
        <translation>Bloquear o liberar</translation>
    </message>
</context>
<context>
    <name>ductus::SketchDocument</name>
    <message>
        <source>Change role of strokes</source>
        <translation>Cambiar la función de los trazos</translation>
    </message>
    <message>
        <source>New region</source>
        <translation>Nueva región</translation>
    </message>
    <message>
        <source>Merge regions</source>
        <translation>Unir regiones</translation>
    </message>
    <message>
        <source>Draw seam</source>
        <translation>Dibujar costura</translation>
    </message>
    <message>
        <source>Forbid seam</source>
        <translation>Prohibir costura</translation>
    </message>
    <message>
        <source>Split region</source>
        <translation>Dividir región</translation>
    </message>
    <message>
        <source>Lock region</source>
        <translation>Bloquear región</translation>
    </message>
    <message>
        <source>Change surface kind</source>
        <translation>Cambiar el tipo de superficie</translation>
    </message>
    <message>
        <source>Remove scribble</source>
        <translation>Quitar garabato</translation>
    </message>
    <message>
        <source>Remove all scribbles</source>
        <translation>Quitar todos los garabatos</translation>
    </message>
    <message>
        <source>Draw stroke</source>
        <translation>Dibujar trazo</translation>
    </message>
    <message>
        <source>Move stroke</source>
        <translation>Mover trazo</translation>
    </message>
    <message numerus="yes">
        <source>Move %n strokes</source>
        <translation>
            <numerusform>Mover %n trazo</numerusform>
            <numerusform>Mover %n trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>Bend stroke</source>
        <translation>Curvar trazo</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>Eliminar trazo</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n strokes</source>
        <translation>
            <numerusform>Eliminar %n trazo</numerusform>
            <numerusform>Eliminar %n trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>Use proxy from file</source>
        <translation>Usar proxy de un archivo</translation>
    </message>
    <message>
        <source>Make proxy automatically</source>
        <translation>Crear proxy automáticamente</translation>
    </message>
    <message>
        <source>Change unit</source>
        <translation>Cambiar la unidad</translation>
    </message>
    <message>
        <source>Choose another surface</source>
        <translation>Elegir otra superficie</translation>
    </message>
    <message>
        <source>Surface anew</source>
        <translation>Recrear la superficie</translation>
    </message>
    <message>
        <source>Paste strokes</source>
        <translation>Pegar trazos</translation>
    </message>
</context>
<context>
    <name>ductus::SketchPresenter</name>
    <message>
        <source>Drawing the surface</source>
        <translation>Dibujo de la superficie</translation>
    </message>
    <message>
        <source>Strokes to surface</source>
        <translation>De los trazos a la superficie</translation>
    </message>
</context>
<context>
    <name>ductus::SketchView</name>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
</context>
<context>
    <name>ductus::StrokePanel</name>
    <message>
        <source>on the surface</source>
        <translation>en la superficie</translation>
    </message>
    <message>
        <source>border of the surface</source>
        <translation>borde de la superficie</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignorado</translation>
    </message>
    <message>
        <source>inside, not used</source>
        <translation>interior, sin usar</translation>
    </message>
    <message>
        <source>thin tube</source>
        <translation>tubo fino</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>With strokes chosen: what they are for. Otherwise: what the role brush paints.</source>
        <translation>Con trazos elegidos: para qué sirven. Si no: lo que pinta el pincel de función.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Takes the chosen strokes out of the sketch (Del). Undo brings them back.</source>
        <translation>Quita del boceto los trazos elegidos (Supr). Deshacer los recupera.</translation>
    </message>
    <message>
        <source>&amp;Role</source>
        <translation>&amp;Función</translation>
    </message>
    <message>
        <source>Mark as &amp;border</source>
        <translation>&amp;Marcar como borde</translation>
    </message>
    <message>
        <source>Nobody marked these strokes; the surface ends along them because nothing lies beyond. Marked, they stay its border whatever else is drawn.</source>
        <translation>Nadie marcó estos trazos; la superficie termina en ellos porque no hay nada más allá. Marcados, seguirán siendo su borde se dibuje lo que se dibuje.</translation>
    </message>
    <message numerus="yes">
        <source>Border found: the surface ends along %n strokes nobody marked.</source>
        <translation>
            <numerusform>Borde hallado: la superficie termina en %n trazo que nadie marcó.</numerusform>
            <numerusform>Borde hallado: la superficie termina en %n trazos que nadie marcó.</numerusform>
        </translation>
    </message>
    <message>
        <source>No stroke chosen</source>
        <translation>Ningún trazo elegido</translation>
    </message>
    <message>
        <source>One stroke chosen</source>
        <translation>Un trazo elegido</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes chosen</source>
        <translation>
            <numerusform>%n trazo elegido</numerusform>
            <numerusform>%n trazos elegidos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SurfaceButton</name>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Stops and keeps the last surface (Esc).</source>
        <translation>Detiene y conserva la última superficie (Esc).</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>&amp;Actualizar</translation>
    </message>
    <message>
        <source>&amp;Surface it</source>
        <translation>&amp;Crear superficie</translation>
    </message>
    <message>
        <source>Finds the surface the strokes describe (Ctrl+Enter).</source>
        <translation>Halla la superficie que describen los trazos (Ctrl+Intro).</translation>
    </message>
    <message>
        <source>Open a sketch or draw strokes first.</source>
        <translation>Abra un boceto o dibuje primero unos trazos.</translation>
    </message>
    <message numerus="yes">
        <source>Up to date: %n regions</source>
        <translation>
            <numerusform>Al día: %n región</numerusform>
            <numerusform>Al día: %n regiones</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 s</source>
        <translation>, %1 s</translation>
    </message>
    <message>
        <source>The surface is older than the sketch.</source>
        <translation>La superficie es anterior al boceto.</translation>
    </message>
    <message numerus="yes">
        <source>%n points, not surfaced yet.</source>
        <translation>
            <numerusform>%n punto, aún sin superficie.</numerusform>
            <numerusform>%n puntos, aún sin superficie.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes, not surfaced yet.</source>
        <translation>
            <numerusform>%n trazo, aún sin superficie.</numerusform>
            <numerusform>%n trazos, aún sin superficie.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::SurfacerWindow</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>&amp;New sketch</source>
        <translation>&amp;Nuevo boceto</translation>
    </message>
    <message>
        <source>Begins with an empty canvas to draw on.</source>
        <translation>Empieza con un lienzo vacío.</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>Opens a project, or a sketch of another program.</source>
        <translation>Abre un proyecto, o un boceto de otro programa.</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Página de inicio</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the sketch stays open.</source>
        <translation>Muestra ejemplos y archivos recientes; el boceto sigue abierto.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Saves sketch, decisions and surface.</source>
        <translation>Guarda boceto, decisiones y superficie.</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Guardar &amp;como...</translation>
    </message>
    <message>
        <source>Saves under another name.</source>
        <translation>Guarda con otro nombre.</translation>
    </message>
    <message>
        <source>&amp;Export surface...</source>
        <translation>E&amp;xportar superficie...</translation>
    </message>
    <message>
        <source>Writes OBJ, PLY, STL, GLB or OFF for other programs.</source>
        <translation>Escribe OBJ, PLY, STL, GLB u OFF para otros programas.</translation>
    </message>
    <message>
        <source>Send to &amp;LayerPainter</source>
        <translation>&amp;Enviar a LayerPainter</translation>
    </message>
    <message>
        <source>Opens the project in LayerPainter, to paint on the surface.</source>
        <translation>Abre el proyecto en LayerPainter para pintar sobre la superficie.</translation>
    </message>
    <message>
        <source>Save p&amp;icture...</source>
        <translation>Guardar &amp;imagen...</translation>
    </message>
    <message>
        <source>Writes what the canvas shows as a PNG file.</source>
        <translation>Escribe lo que muestra el lienzo en un archivo PNG.</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Guardar imagen</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Save t&amp;urntable...</source>
        <translation>Guardar &amp;vuelta completa...</translation>
    </message>
    <message>
        <source>Writes a round of 72 pictures into a folder, to be made a film of.</source>
        <translation>Escribe una vuelta de 72 imágenes en una carpeta, para hacer con ellas una película.</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Carpeta para las imágenes</translation>
    </message>
    <message>
        <source>&amp;Paste sketch</source>
        <translation>Pegar &amp;boceto</translation>
    </message>
    <message>
        <source>&amp;Delete strokes</source>
        <translation>&amp;Eliminar trazos</translation>
    </message>
    <message>
        <source>Takes the chosen strokes out of the sketch.</source>
        <translation>Quita del boceto los trazos elegidos.</translation>
    </message>
    <message>
        <source>Choose &amp;all strokes</source>
        <translation>Elegir &amp;todos los trazos</translation>
    </message>
    <message>
        <source>So that one act changes them all.</source>
        <translation>Para que un solo acto los cambie todos.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stops what runs, forgets what was begun, goes back to the arrow.</source>
        <translation>Detiene lo que está en curso, olvida lo empezado, vuelve a la flecha.</translation>
    </message>
    <message>
        <source>&amp;Surface it</source>
        <translation>Crear &amp;superficie</translation>
    </message>
    <message>
        <source>Finds the surface the strokes describe.</source>
        <translation>Halla la superficie que describen los trazos.</translation>
    </message>
    <message>
        <source>Surface a&amp;new</source>
        <translation>&amp;Recrear la superficie</translation>
    </message>
    <message>
        <source>Forgets the way here: edited strokes are usually worked into the surface there is.</source>
        <translation>Olvida el camino recorrido: normalmente los trazos editados se integran en la superficie que hay.</translation>
    </message>
    <message>
        <source>&amp;Update by itself</source>
        <translation>&amp;Actualizar automáticamente</translation>
    </message>
    <message>
        <source>After a scribble or a moved slider the surface follows without a click.</source>
        <translation>Tras un garabato o un control deslizante, la superficie sigue sin más clics.</translation>
    </message>
    <message>
        <source>Remove all s&amp;cribbles</source>
        <translation>&amp;Quitar todos los garabatos</translation>
    </message>
    <message>
        <source>Back to the regions found automatically.</source>
        <translation>Vuelve a las regiones halladas automáticamente.</translation>
    </message>
    <message>
        <source>Use &amp;proxy from file...</source>
        <translation>&amp;Usar proxy de un archivo...</translation>
    </message>
    <message>
        <source>Takes a mesh made elsewhere as the rough skin the strokes are read on.</source>
        <translation>Toma una malla hecha en otro sitio como envoltura sobre la que se leen los trazos.</translation>
    </message>
    <message>
        <source>Make proxy &amp;automatically</source>
        <translation>Crear &amp;proxy automáticamente</translation>
    </message>
    <message>
        <source>Forgets the mesh from a file.</source>
        <translation>Olvida la malla de un archivo.</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Seleccionar</translation>
    </message>
    <message>
        <source>Drag turns the view, a click chooses a stroke or region.</source>
        <translation>Arrastrar gira la vista; un clic elige un trazo o una región.</translation>
    </message>
    <message>
        <source>&amp;Role brush</source>
        <translation>&amp;Pincel de función</translation>
    </message>
    <message>
        <source>Paint over strokes to say what they are: border, ignored, ...</source>
        <translation>Pinte sobre los trazos para decir qué son: borde, ignorado, ...</translation>
    </message>
    <message>
        <source>&amp;Draw stroke</source>
        <translation>Dibujar &amp;trazo</translation>
    </message>
    <message>
        <source>Add the stroke that was missing; the surface follows.</source>
        <translation>Añada el trazo que faltaba; la superficie lo sigue.</translation>
    </message>
    <message>
        <source>&amp;New region</source>
        <translation>&amp;Nueva región</translation>
    </message>
    <message>
        <source>Yellow: what you scribble over becomes a surface of its own.</source>
        <translation>Amarillo: lo que garabatee se convierte en una superficie propia.</translation>
    </message>
    <message>
        <source>&amp;Merge regions</source>
        <translation>&amp;Unir regiones</translation>
    </message>
    <message>
        <source>Green: the regions you connect become one.</source>
        <translation>Verde: las regiones que conecte se hacen una.</translation>
    </message>
    <message>
        <source>Red: a crease must run exactly here.</source>
        <translation>Rojo: un pliegue debe pasar justo por aquí.</translation>
    </message>
    <message>
        <source>S&amp;plit region</source>
        <translation>&amp;Dividir región</translation>
    </message>
    <message>
        <source>Orange: cuts a region in two along your line.</source>
        <translation>Naranja: corta una región en dos por su línea.</translation>
    </message>
    <message>
        <source>&amp;Forbid seam</source>
        <translation>P&amp;rohibir costura</translation>
    </message>
    <message>
        <source>Blue: no crease may run here.</source>
        <translation>Azul: aquí no puede haber ningún pliegue.</translation>
    </message>
    <message>
        <source>&amp;Lock region</source>
        <translation>&amp;Bloquear región</translation>
    </message>
    <message>
        <source>A locked region stays as it is, whatever else changes.</source>
        <translation>Una región bloqueada se queda como está, cambie lo que cambie.</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>The length between two points.</source>
        <translation>La longitud entre dos puntos.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Frente</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Detrás</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>D&amp;erecha</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Izquierda</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Arriba</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>A&amp;bajo</translation>
    </message>
    <message>
        <source>Three-&amp;quarter</source>
        <translation>&amp;Tres cuartos</translation>
    </message>
    <message>
        <source>Looks from there.</source>
        <translation>Mira desde ahí.</translation>
    </message>
    <message>
        <source>Fr&amp;ame all</source>
        <translation>&amp;Encuadrar todo</translation>
    </message>
    <message>
        <source>Brings the whole sketch into view.</source>
        <translation>Muestra todo el boceto en la vista.</translation>
    </message>
    <message>
        <source>Comes nearer.</source>
        <translation>Se aproxima.</translation>
    </message>
    <message>
        <source>Zoom o&amp;ut</source>
        <translation>A&amp;lejar</translation>
    </message>
    <message>
        <source>Steps back.</source>
        <translation>Retrocede.</translation>
    </message>
    <message>
        <source>Turn view (%1)</source>
        <translation>Girar la vista (%1)</translation>
    </message>
    <message>
        <source>Turns the view without a mouse.</source>
        <translation>Gira la vista sin ratón.</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>Pe&amp;rspectiva</translation>
    </message>
    <message>
        <source>Far things smaller; off for measuring by eye.</source>
        <translation>Lo lejano más pequeño; desactivada para medir a ojo.</translation>
    </message>
    <message>
        <source>Shows the sketch on top of the surface.</source>
        <translation>Muestra el boceto sobre la superficie.</translation>
    </message>
    <message>
        <source>Turns the view by itself, to look at it from all sides.</source>
        <translation>Gira la vista sola, para mirar por todos los lados.</translation>
    </message>
    <message>
        <source>&amp;Mirror drawn strokes</source>
        <translation>Reflejar &amp;los trazos dibujados</translation>
    </message>
    <message>
        <source>Where the sketch is symmetric a stroke comes with its mirror image.</source>
        <translation>Donde el boceto es simétrico, cada trazo viene con su reflejo.</translation>
    </message>
    <message>
        <source>What the sketch leaves &amp;open</source>
        <translation>Lo &amp;que el boceto deja abierto</translation>
    </message>
    <message>
        <source>Colours where the strokes allow more than one surface; a click there offers the others.</source>
        <translation>Colorea donde los trazos permiten más de una superficie; un clic ahí ofrece las otras.</translation>
    </message>
    <message>
        <source>&amp;Compare with the sketch</source>
        <translation>Comparar con el &amp;boceto</translation>
    </message>
    <message>
        <source>A line to drag: the sketch at its left, the surface at its right.</source>
        <translation>Una línea para arrastrar: el boceto a la izquierda, la superficie a la derecha.</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Superficie</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Herramientas</translation>
    </message>
    <message>
        <source>SketchSurfacer</source>
        <translation>SketchSurfacer</translation>
    </message>
    <message>
        <source>From a 3D sketch to a surface you can print, render or take into CAD.</source>
        <translation>De un boceto 3D a una superficie para imprimir, renderizar o llevar a CAD.</translation>
    </message>
    <message>
        <source>New sketch</source>
        <translation>Nuevo boceto</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Abrir...</translation>
    </message>
    <message>
        <source>Drop a sketch (.curves, .obj, .txt), points (.xyz), a proxy mesh or a project anywhere.</source>
        <translation>Suelte en cualquier lugar un boceto (.curves, .obj, .txt), puntos (.xyz), una malla proxy o un proyecto.</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Sketches and projects (*.ductus *.curves *.obj *.txt *.xyz *.crv);;Proxy meshes (*.ply *.stl *.off *.glb *.obj);;All files (*)</source>
        <translation>Bocetos y proyectos (*.ductus *.curves *.obj *.txt *.xyz *.crv);;Mallas proxy (*.ply *.stl *.off *.glb *.obj);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lectura de %1</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Apertura de %1</translation>
    </message>
    <message>
        <source>The clipboard holds neither strokes nor a path to a file.</source>
        <translation>El portapapeles no contiene trazos ni una ruta de archivo.</translation>
    </message>
    <message>
        <source>Reading the clipboard</source>
        <translation>Lectura del portapapeles</translation>
    </message>
    <message>
        <source>Pasted</source>
        <translation>Pegado</translation>
    </message>
    <message numerus="yes">
        <source>These %n points do not follow one another: they are taken as points of the surface, and creases are found by its shape alone.</source>
        <translation>
            <numerusform>Este %n punto no sigue a otro: se toma como punto de la superficie, y los pliegues se hallan solo por su forma.</numerusform>
            <numerusform>Estos %n puntos no se siguen unos a otros: se toman como puntos de la superficie, y los pliegues se hallan solo por su forma.</numerusform>
        </translation>
    </message>
    <message>
        <source>A stroke looks like a cable and becomes a thin tube. If it is none, select it and set its role to “on the surface”.</source>
        <translation>Un trazo parece un cable y se convierte en un tubo fino. Si no lo es, selecciónelo y asígnele la función «en la superficie».</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes look like cables and become thin tubes. Where one is none, select it and set its role to “on the surface”.</source>
        <translation>
            <numerusform>%n trazo parece un cable y se convierte en un tubo fino. Si no lo es, selecciónelo y asígnele la función «en la superficie».</numerusform>
            <numerusform>%n trazos parecen cables y se convierten en tubos finos. Si alguno no lo es, selecciónelo y asígnele la función «en la superficie».</numerusform>
        </translation>
    </message>
    <message>
        <source>Some of the sketch was skipped: %1</source>
        <translation>Se omitió parte del boceto: %1</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Y %n más.</numerusform>
            <numerusform>Y %n más.</numerusform>
        </translation>
    </message>
    <message>
        <source>A mesh serves as the proxy of a sketch. Open the sketch first, then the mesh.</source>
        <translation>Una malla sirve de proxy a un boceto. Abra primero el boceto y luego la malla.</translation>
    </message>
    <message>
        <source>Reading the proxy</source>
        <translation>Lectura del proxy</translation>
    </message>
    <message>
        <source>%1 is the proxy now.</source>
        <translation>%1 es ahora el proxy.</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>Ductus projects (*.ductus)</source>
        <translation>Proyectos de Ductus (*.ductus)</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Guardar como...</translation>
    </message>
    <message>
        <source>LayerPainter paints on the surface, and there is none yet.</source>
        <translation>LayerPainter pinta sobre la superficie, y aún no hay ninguna.</translation>
    </message>
    <message>
        <source>Surface it</source>
        <translation>Crear superficie</translation>
    </message>
    <message>
        <source>LayerPainter opens %1.</source>
        <translation>LayerPainter abre %1.</translation>
    </message>
    <message>
        <source>LayerPainter reads the saved project, and this one has changes.</source>
        <translation>LayerPainter lee el proyecto guardado, y este tiene cambios.</translation>
    </message>
    <message>
        <source>Save and send</source>
        <translation>Guardar y enviar</translation>
    </message>
    <message>
        <source>Save as and send...</source>
        <translation>Guardar como y enviar...</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Exportar superficie</translation>
    </message>
    <message>
        <source>Exporting the surface</source>
        <translation>Exportación de la superficie</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Exportado a %1.</translation>
    </message>
    <message>
        <source>Writing the picture</source>
        <translation>Escritura de la imagen</translation>
    </message>
    <message>
        <source>The picture is in %1.</source>
        <translation>La imagen está en %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures are in %1.</source>
        <translation>
            <numerusform>%n imagen está en %1.</numerusform>
            <numerusform>%n imágenes están en %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Boceto</translation>
    </message>
    <message>
        <source>The strokes alone.</source>
        <translation>Solo los trazos.</translation>
    </message>
    <message>
        <source>Proxy</source>
        <translation>Proxy</translation>
    </message>
    <message>
        <source>The rough skin the strokes are read on.</source>
        <translation>La envoltura sobre la que se leen los trazos.</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regiones</translation>
    </message>
    <message>
        <source>Which parts are one smooth surface each.</source>
        <translation>Qué partes son cada una una superficie suave.</translation>
    </message>
    <message>
        <source>The finished surface in clay.</source>
        <translation>La superficie terminada, en arcilla.</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Desviación</translation>
    </message>
    <message>
        <source>How far strokes and surface are apart.</source>
        <translation>Cuánto distan los trazos de la superficie.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Other readings</source>
        <translation>Otras interpretaciones</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Trazos</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Medidas</translation>
    </message>
    <message>
        <source>Print check</source>
        <translation>Control de impresión</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Reintentar</translation>
    </message>
    <message>
        <source>Install a graphics driver, or the software one: libgl1-mesa-dri.</source>
        <translation>Instale un controlador gráfico, o el de software: libgl1-mesa-dri.</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueada</translation>
    </message>
    <message>
        <source>%1 % open</source>
        <translation>%1 % abierto</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>trazo %1</translation>
    </message>
    <message>
        <source>border found</source>
        <translation>borde hallado</translation>
    </message>
    <message>
        <source>at most %1 off</source>
        <translation>a %1 como máximo</translation>
    </message>
    <message>
        <source>Surface the sketch first.</source>
        <translation>Cree primero la superficie.</translation>
    </message>
    <message>
        <source>Nothing drawn yet. Press D and draw the first stroke, or drop a sketch here.</source>
        <translation>Aún no hay nada dibujado. Pulse D y dibuje el primer trazo, o suelte aquí un boceto.</translation>
    </message>
    <message>
        <source>&amp;Copy strokes</source>
        <translation>&amp;Copiar trazos</translation>
    </message>
    <message>
        <source>Puts the chosen strokes, or all, on the clipboard, for the other apps of the suite as well.</source>
        <translation>Pone los trazos elegidos, o todos, en el portapapeles, también para las otras aplicaciones de la suite.</translation>
    </message>
    <message>
        <source>Adds strokes copied in this or another app of the suite, or opens text or a file.</source>
        <translation>Añade trazos copiados en esta u otra aplicación de la suite, o abre texto o un archivo.</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes pasted.</source>
        <translation>
            <numerusform>%n trazo pegado.</numerusform>
            <numerusform>%n trazos pegados.</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no strokes to copy yet.</source>
        <translation>Aún no hay trazos que copiar.</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes copied.</source>
        <translation>
            <numerusform>%n trazo copiado.</numerusform>
            <numerusform>%n trazos copiados.</numerusform>
        </translation>
    </message>
    <message>
        <source>Se&amp;am</source>
        <translation>&amp;Costura</translation>
    </message>
    <message>
        <source>&amp;Zoom in</source>
        <translation>&amp;Acercar</translation>
    </message>
    <message>
        <source>St&amp;rokes on the surface</source>
        <translation>Trazos &amp;sobre la superficie</translation>
    </message>
    <message>
        <source>&amp;Turntable</source>
        <translation>&amp;Giro continuo</translation>
    </message>
    <message>
        <source>Loo&amp;k from</source>
        <translation>&amp;Mirar desde</translation>
    </message>
</context>
<context>
    <name>ductus::SurfacingJobs</name>
    <message>
        <source>Surfacing the sketch</source>
        <translation>Creación de la superficie</translation>
    </message>
</context>
<context>
    <name>ductus::ToolBox</name>
    <message>
        <source>There is no region here. Surface the sketch and click one of its regions.</source>
        <translation>Aquí no hay ninguna región. Cree la superficie y haga clic en una de sus regiones.</translation>
    </message>
    <message>
        <source>Drag a handle to bend the stroke; with Ctrl it slides over the surface, the wheel widens the bend. Drag the stroke between handles to move it.</source>
        <translation>Arrastre un tirador para curvar el trazo; con Ctrl se desliza por la superficie, la rueda ensancha la curva. Arrastre entre tiradores para moverlo.</translation>
    </message>
    <message>
        <source>Drag to turn, wheel to zoom. Click a stroke or region to choose it, Shift+drag around several; drag chosen strokes to move them.</source>
        <translation>Arrastre para girar, rueda para zoom. Clic para elegir un trazo o región, Mayús+arrastrar para varios; arrastre los trazos elegidos para moverlos.</translation>
    </message>
    <message>
        <source>Paint over strokes to tell what they mean; the role is chosen in the inspector.</source>
        <translation>Pinte sobre los trazos para decir qué significan; la función se elige en el inspector.</translation>
    </message>
    <message>
        <source>Draw on the surface, or in the air facing you; begin at a stroke to snap to it.</source>
        <translation>Dibuje sobre la superficie, o en el aire frente a usted; empiece en un trazo para engancharse a él.</translation>
    </message>
    <message>
        <source>Scribble over what should be a surface of its own.</source>
        <translation>Garabatee sobre lo que deba ser una superficie propia.</translation>
    </message>
    <message>
        <source>Draw from one region into another: they become one smooth surface.</source>
        <translation>Dibuje de una región a otra: se convierten en una sola superficie suave.</translation>
    </message>
    <message>
        <source>Draw where two surfaces must meet in a crease.</source>
        <translation>Dibuje donde dos superficies deban encontrarse en un pliegue.</translation>
    </message>
    <message>
        <source>Draw across a region to cut it in two.</source>
        <translation>Dibuje a través de una región para cortarla en dos.</translation>
    </message>
    <message>
        <source>Draw along a crease that should not be there.</source>
        <translation>Dibuje a lo largo de un pliegue que no debería existir.</translation>
    </message>
    <message>
        <source>Click a region to keep it as it is; click again to free it.</source>
        <translation>Haga clic en una región para mantenerla como está; otro clic la libera.</translation>
    </message>
    <message>
        <source>Click two points to measure between them.</source>
        <translation>Haga clic en dos puntos para medir entre ellos.</translation>
    </message>
</context>
<context>
    <name>ductus::VtkWidget</name>
    <message>
        <source>This computer&apos;s graphics driver offers no OpenGL 3.2.</source>
        <translation>El controlador gráfico de este equipo no ofrece OpenGL 3.2.</translation>
    </message>
</context>
</TS>
