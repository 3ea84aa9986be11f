<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>DirectDrawTool</name>
    <message>
        <source>Canvas %1</source>
        <translation>Lienzo %1</translation>
    </message>
    <message>
        <source>Add canvas</source>
        <translation>Añadir lienzo</translation>
    </message>
</context>
<context>
    <name>OcclusionTool</name>
    <message>
        <source>Bring in front</source>
        <translation>Traer delante</translation>
    </message>
    <message>
        <source>Put behind</source>
        <translation>Poner detrás</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasFollower</name>
    <message>
        <source>Following the canvas</source>
        <translation>Seguimiento del lienzo</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasList</name>
    <message>
        <source>Canvases</source>
        <translation>Lienzos</translation>
    </message>
    <message>
        <source>Duplicate canvas</source>
        <translation>Duplicar lienzo</translation>
    </message>
    <message>
        <source>A second canvas with the same drawings, beside this one.</source>
        <translation>Un segundo lienzo con los mismos dibujos, junto a este.</translation>
    </message>
    <message>
        <source>Take canvas away</source>
        <translation>Quitar lienzo</translation>
    </message>
    <message>
        <source>Takes the canvas and its drawings away.</source>
        <translation>Quita el lienzo y sus dibujos.</translation>
    </message>
    <message>
        <source>Show canvas</source>
        <translation>Mostrar lienzo</translation>
    </message>
    <message>
        <source>Hide canvas</source>
        <translation>Ocultar lienzo</translation>
    </message>
    <message>
        <source>Rename canvas</source>
        <translation>Renombrar lienzo</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 copia</translation>
    </message>
</context>
<context>
    <name>ductus::CanvasPanel</name>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Quieto</translation>
    </message>
    <message>
        <source>The canvas stands still in the scene; only the camera moves past it.</source>
        <translation>El lienzo está quieto en la escena; solo la cámara pasa ante él.</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Sigue</translation>
    </message>
    <message>
        <source>The canvas follows what is under its middle.</source>
        <translation>El lienzo sigue lo que hay bajo su centro.</translation>
    </message>
    <message>
        <source>Pin here</source>
        <translation>Fijar aquí</translation>
    </message>
    <message>
        <source>Holds the canvas where it is in this frame. In between it follows.</source>
        <translation>Mantiene el lienzo donde está en este fotograma. Entre medias, sigue.</translation>
    </message>
    <message>
        <source>Straight to the next pin</source>
        <translation>Recto hasta la siguiente fijación</translation>
    </message>
    <message>
        <source>From the pin before this frame to the one after it the canvas goes straight and evenly instead of following what is seen: for where it is hidden too long.</source>
        <translation>De la fijación anterior a la siguiente, el lienzo va recto y uniforme en vez de seguir lo que se ve: para donde está oculto demasiado tiempo.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>How far the canvas is from the camera. Nearer things hide it.</source>
        <translation>A qué distancia de la cámara está el lienzo. Lo más cercano lo oculta.</translation>
    </message>
    <message>
        <source>Distance from the scene</source>
        <translation>Distancia según la escena</translation>
    </message>
    <message>
        <source>As far as what is under the middle of the canvas.</source>
        <translation>Tan lejos como lo que hay bajo el centro del lienzo.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>The size of the canvas; its corner on the picture does the same.</source>
        <translation>El tamaño del lienzo; su esquina en la imagen hace lo mismo.</translation>
    </message>
    <message>
        <source>Face the camera</source>
        <translation>De cara a la cámara</translation>
    </message>
    <message>
        <source>Turns the canvas straight to the camera in this frame.</source>
        <translation>Gira el lienzo de frente a la cámara en este fotograma.</translation>
    </message>
    <message>
        <source>How it turns while it follows</source>
        <translation>Cómo gira mientras sigue</translation>
    </message>
    <message>
        <source>What the canvas does between the frames in which you turned it.</source>
        <translation>Qué hace el lienzo entre los fotogramas en que lo giró.</translation>
    </message>
    <message>
        <source>Turns with the way it goes</source>
        <translation>Gira con su recorrido</translation>
    </message>
    <message>
        <source>Keeps its direction</source>
        <translation>Mantiene su dirección</translation>
    </message>
    <message>
        <source>Turns with the thing it is on</source>
        <translation>Gira con el objeto</translation>
    </message>
    <message>
        <source>Keeps its direction relative to its path, as a sign on a tram does in a bend.</source>
        <translation>Mantiene su dirección respecto a su recorrido, como el rótulo de un tranvía en una curva.</translation>
    </message>
    <message>
        <source>Looks where you turned it to, whatever happens.</source>
        <translation>Mira hacia donde lo giró, pase lo que pase.</translation>
    </message>
    <message>
        <source>Turns as the picture turns around its middle, as a hat does on a dancer.</source>
        <translation>Gira como gira la imagen alrededor de su centro, como el sombrero de un bailarín.</translation>
    </message>
    <message>
        <source>Change turning</source>
        <translation>Cambiar el giro</translation>
    </message>
    <message>
        <source>Hidden by what is in front</source>
        <translation>Oculto por lo que hay delante</translation>
    </message>
    <message>
        <source>Nearer things cover the canvas. Off: it is always seen.</source>
        <translation>Lo más cercano cubre el lienzo. Desactivado: se ve siempre.</translation>
    </message>
    <message>
        <source>Let the scene hide the canvas</source>
        <translation>Dejar que la escena oculte el lienzo</translation>
    </message>
    <message>
        <source>Show the canvas always</source>
        <translation>Mostrar siempre el lienzo</translation>
    </message>
    <message>
        <source>Depth play</source>
        <translation>Holgura de profundidad</translation>
    </message>
    <message>
        <source>More: the canvas shows through what is only a little nearer.</source>
        <translation>Más: el lienzo se ve a través de lo que está solo un poco más cerca.</translation>
    </message>
    <message>
        <source>Change depth play</source>
        <translation>Cambiar la holgura de profundidad</translation>
    </message>
    <message>
        <source>In front here</source>
        <translation>Delante aquí</translation>
    </message>
    <message>
        <source>Brush over the picture where the canvas must be seen.</source>
        <translation>Pinte sobre la imagen donde el lienzo deba verse.</translation>
    </message>
    <message>
        <source>Behind here</source>
        <translation>Detrás aquí</translation>
    </message>
    <message>
        <source>Brush over the picture where the canvas must be hidden.</source>
        <translation>Pinte sobre la imagen donde el lienzo deba ocultarse.</translation>
    </message>
    <message>
        <source>Forget what was brushed</source>
        <translation>Olvidar lo pintado</translation>
    </message>
    <message>
        <source>Only the distance decides again what hides the canvas.</source>
        <translation>Solo la distancia decide de nuevo qué oculta el lienzo.</translation>
    </message>
    <message>
        <source>Forget the brush</source>
        <translation>Olvidar lo pintado</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>How much of the film shows through the drawing.</source>
        <translation>Cuánto se ve la película a través del dibujo.</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Cambiar la opacidad</translation>
    </message>
    <message>
        <source>Let canvas follow</source>
        <translation>Hacer que el lienzo siga</translation>
    </message>
    <message>
        <source>Let canvas stay</source>
        <translation>Dejar quieto el lienzo</translation>
    </message>
    <message>
        <source>Pin canvas</source>
        <translation>Fijar lienzo</translation>
    </message>
    <message>
        <source>Go straight</source>
        <translation>Ir en línea recta</translation>
    </message>
    <message>
        <source>Follow the scene</source>
        <translation>Seguir la escena</translation>
    </message>
    <message>
        <source>Change distance</source>
        <translation>Cambiar la distancia</translation>
    </message>
    <message>
        <source>Size canvas</source>
        <translation>Cambiar tamaño del lienzo</translation>
    </message>
    <message>
        <source>Drag out a box on the picture: a canvas to draw on will stand there.</source>
        <translation>Arrastre un recuadro en la imagen: ahí habrá un lienzo para dibujar.</translation>
    </message>
    <message>
        <source>Choose a canvas above or on the picture, or drag out a box for another one.</source>
        <translation>Elija un lienzo arriba o en la imagen, o arrastre un recuadro para otro.</translation>
    </message>
    <message>
        <source>Pin it here and follow</source>
        <translation>Fijar aquí y seguir</translation>
    </message>
    <message>
        <source>Stands still in the scene.</source>
        <translation>Quieto en la escena.</translation>
    </message>
    <message numerus="yes">
        <source>Pinned in %n frame(s); drag it where it drifts.</source>
        <translation>
            <numerusform>Fijado en %n fotograma; arrástrelo donde se desvíe.</numerusform>
            <numerusform>Fijado en %n fotogramas; arrástrelo donde se desvíe.</numerusform>
        </translation>
    </message>
    <message>
        <source>Following...</source>
        <translation>Siguiendo...</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingHand</name>
    <message>
        <source>Erase</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Move drawing</source>
        <translation>Mover dibujo</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dibujar</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Rellenar</translation>
    </message>
    <message>
        <source>Draw arrow</source>
        <translation>Dibujar flecha</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Escribir</translation>
    </message>
    <message>
        <source>Add sticker</source>
        <translation>Añadir pegatina</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingPanel</name>
    <message>
        <source>Pen</source>
        <translation>Lápiz</translation>
    </message>
    <message>
        <source>Draws lines; a pen&apos;s pressure makes them wider. (P)</source>
        <translation>Dibuja líneas; la presión del lápiz las ensancha. (P)</translation>
    </message>
    <message>
        <source>Filled shape</source>
        <translation>Forma rellena</translation>
    </message>
    <message>
        <source>Draw an outline; what is inside is filled. (G)</source>
        <translation>Dibuje un contorno; el interior se rellena. (G)</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Flecha</translation>
    </message>
    <message>
        <source>Points at something; draw it as you like. (A)</source>
        <translation>Señala algo; dibújela como quiera. (A)</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand. (T)</source>
        <translation>Escriba un texto y haga clic donde deba estar. (T)</translation>
    </message>
    <message>
        <source>Sticker</source>
        <translation>Pegatina</translation>
    </message>
    <message>
        <source>Ready-made drawings; drag to say how large. (S)</source>
        <translation>Dibujos ya hechos; arrastre para dar el tamaño. (S)</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Goma</translation>
    </message>
    <message>
        <source>Takes parts of lines away. (E)</source>
        <translation>Quita partes de las líneas. (E)</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Moves something that was drawn. (V)</source>
        <translation>Mueve algo dibujado. (V)</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Picture. Puts a picture from a file on the canvas; move it with V.</source>
        <translation>Imagen. Pone una imagen de un archivo en el lienzo; muévala con V.</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand</source>
        <translation>Escriba un texto y haga clic donde deba estar</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanco</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Negro</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rojo</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Naranja</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Amarillo</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Verde</translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation>Cian</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Azul</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violeta</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>Rosa</translation>
    </message>
    <message>
        <source>Another colour</source>
        <translation>Otro color</translation>
    </message>
    <message>
        <source>Another colour...</source>
        <translation>Otro color...</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Of the line, as a share of the canvas. Keys [ and ].</source>
        <translation>De la línea, como parte del lienzo. Teclas [ y ].</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>How much of the film is seen below the drawing.</source>
        <translation>Cuánto se ve de la película bajo el dibujo.</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Escribir</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.gif *.svg)</source>
        <translation>Imágenes (*.png *.jpg *.jpeg *.bmp *.gif *.svg)</translation>
    </message>
    <message>
        <source>Insert picture</source>
        <translation>Insertar imagen</translation>
    </message>
    <message>
        <source>seen from behind</source>
        <translation>visto por detrás</translation>
    </message>
    <message>
        <source>seen from the side: another frame is better</source>
        <translation>visto de lado: otro fotograma es mejor</translation>
    </message>
    <message>
        <source>star</source>
        <translation>estrella</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>corazón</translation>
    </message>
    <message>
        <source>check</source>
        <translation>marca</translation>
    </message>
    <message>
        <source>cross</source>
        <translation>cruz</translation>
    </message>
    <message>
        <source>smile</source>
        <translation>sonrisa</translation>
    </message>
    <message>
        <source>frown</source>
        <translation>ceño</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>anillo</translation>
    </message>
    <message>
        <source>bubble</source>
        <translation>bocadillo</translation>
    </message>
    <message>
        <source>bang</source>
        <translation>exclamación</translation>
    </message>
    <message>
        <source>question</source>
        <translation>interrogación</translation>
    </message>
    <message>
        <source>bulb</source>
        <translation>bombilla</translation>
    </message>
    <message>
        <source>bolt</source>
        <translation>rayo</translation>
    </message>
</context>
<context>
    <name>ductus::DrawingView</name>
    <message>
        <source>Drawing</source>
        <translation>Dibujo</translation>
    </message>
    <message>
        <source>Draw straight on the picture: a canvas is made where you begin.
Or choose a canvas to see it from the front.</source>
        <translation>Dibuje directamente en la imagen: se crea un lienzo donde empiece.
O elija un lienzo para verlo de frente.</translation>
    </message>
</context>
<context>
    <name>ductus::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Elegir...</translation>
    </message>
    <message>
        <source>With the sound of the clip</source>
        <translation>Con el sonido del clip</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Mostrar en la carpeta</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message numerus="yes">
        <source>%1, about %n s left</source>
        <translation>
            <numerusform>%1, queda aproximadamente %n s</numerusform>
            <numerusform>%1, quedan unos %n s</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Share</source>
        <translation>&amp;Compartir</translation>
    </message>
    <message>
        <source>A film with your drawings (MP4). Plays everywhere: phone, web, projector.</source>
        <translation>Una película con sus dibujos (MP4). Se reproduce en todas partes: móvil, web, proyector.</translation>
    </message>
    <message>
        <source>S&amp;lides</source>
        <translation>&amp;Diapositivas</translation>
    </message>
    <message>
        <source>A moving picture (GIF) for slides and worksheets. No sound.</source>
        <translation>Una imagen animada (GIF) para diapositivas y fichas. Sin sonido.</translation>
    </message>
    <message>
        <source>&amp;Overlay</source>
        <translation>&amp;Superposición</translation>
    </message>
    <message>
        <source>Your drawings alone, see-through (WebM), to lay over the clip in another program.</source>
        <translation>Solo sus dibujos, transparentes (WebM), para superponerlos al clip en otro programa.</translation>
    </message>
    <message>
        <source>%1 with drawings</source>
        <translation>%1 con dibujos</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it, or choose another name.</source>
        <translation>%1 ya existe. Reemplácelo o elija otro nombre.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exportación de %1</translation>
    </message>
    <message numerus="yes">
        <source>Done: %1 (%2 x %3, %n frame(s))</source>
        <translation>
            <numerusform>Listo: %1 (%2 x %3, %n fotograma)</numerusform>
            <numerusform>Listo: %1 (%2 x %3, %n fotogramas)</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Cancelado; no se ha escrito nada.</translation>
    </message>
    <message>
        <source>It could not be exported: %1</source>
        <translation>No se pudo exportar: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>ductus::FrameStrip</name>
    <message>
        <source>Onion skin</source>
        <translation>Papel cebolla</translation>
    </message>
    <message>
        <source>Onion skin (O). The drawings before shine through in red, those after in blue.</source>
        <translation>Papel cebolla (O). Los dibujos anteriores se traslucen en rojo; los siguientes, en azul.</translation>
    </message>
    <message>
        <source>Drawings that shine through</source>
        <translation>Dibujos que se traslucen</translation>
    </message>
    <message>
        <source>How many drawings before and after shine through.</source>
        <translation>Cuántos dibujos anteriores y posteriores se traslucen.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Video frames this drawing is held</source>
        <translation>Fotogramas que dura este dibujo</translation>
    </message>
    <message>
        <source>For how many frames of the film this drawing is seen.</source>
        <translation>Durante cuántos fotogramas de la película se ve este dibujo.</translation>
    </message>
    <message>
        <source>After the last drawing</source>
        <translation>Tras el último dibujo</translation>
    </message>
    <message>
        <source>What comes after the last drawing.</source>
        <translation>Qué viene después del último dibujo.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Bucle</translation>
    </message>
    <message>
        <source>There and back</source>
        <translation>Ida y vuelta</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Una vez</translation>
    </message>
    <message>
        <source>Keep the last</source>
        <translation>Mantener el último</translation>
    </message>
    <message>
        <source>Hold drawing</source>
        <translation>Duración del dibujo</translation>
    </message>
    <message>
        <source>Change repeat</source>
        <translation>Cambiar la repetición</translation>
    </message>
    <message>
        <source>Add drawing</source>
        <translation>Añadir dibujo</translation>
    </message>
    <message>
        <source>Duplicate drawing</source>
        <translation>Duplicar dibujo</translation>
    </message>
    <message>
        <source>Take drawing away</source>
        <translation>Quitar dibujo</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>Dibujo %1</translation>
    </message>
    <message>
        <source>Add drawing. An empty one after this: draw the next moment on it.</source>
        <translation>Añadir dibujo. Uno vacío después de este: dibuje en él el momento siguiente.</translation>
    </message>
    <message numerus="yes">
        <source>Drawing %1, held for %n frame(s)</source>
        <translation>
            <numerusform>Dibujo %1, dura %n fotograma</numerusform>
            <numerusform>Dibujo %1, dura %n fotogramas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::HandlesTool</name>
    <message>
        <source>Drag the canvas where it must be in this frame: it is pinned there.</source>
        <translation>Arrastre el lienzo a donde deba estar en este fotograma: ahí queda fijado.</translation>
    </message>
    <message>
        <source>Drag the canvas where it should stand.</source>
        <translation>Arrastre el lienzo a donde deba estar.</translation>
    </message>
    <message>
        <source>Drag to make the canvas larger or smaller.</source>
        <translation>Arrastre para agrandar o reducir el lienzo.</translation>
    </message>
    <message>
        <source>Drag to turn the canvas in its plane.</source>
        <translation>Arrastre para girar el lienzo en su plano.</translation>
    </message>
    <message>
        <source>Drag the pin of the gauge: the canvas looks where the pin points.</source>
        <translation>Arrastre la aguja del indicador: el lienzo mira adonde apunta.</translation>
    </message>
    <message>
        <source>Click to go to this moment, drag to pin the canvas elsewhere then.</source>
        <translation>Clic para ir a este momento; arrastre para fijar entonces el lienzo en otro lugar.</translation>
    </message>
    <message>
        <source>Click to choose this canvas.</source>
        <translation>Haga clic para elegir este lienzo.</translation>
    </message>
    <message>
        <source>Drag out a box: a canvas will stand there in the scene.</source>
        <translation>Arrastre un recuadro: ahí habrá un lienzo en la escena.</translation>
    </message>
    <message>
        <source>Pin canvas</source>
        <translation>Fijar lienzo</translation>
    </message>
    <message>
        <source>Move canvas</source>
        <translation>Mover lienzo</translation>
    </message>
    <message>
        <source>Size canvas</source>
        <translation>Cambiar tamaño del lienzo</translation>
    </message>
    <message>
        <source>Turn canvas</source>
        <translation>Girar lienzo</translation>
    </message>
    <message>
        <source>Tilt canvas</source>
        <translation>Inclinar lienzo</translation>
    </message>
    <message>
        <source>Canvas %1</source>
        <translation>Lienzo %1</translation>
    </message>
    <message>
        <source>Add canvas</source>
        <translation>Añadir lienzo</translation>
    </message>
</context>
<context>
    <name>ductus::PlayerView</name>
    <message>
        <source>Player</source>
        <translation>Reproductor</translation>
    </message>
</context>
<context>
    <name>ductus::StudioWindow</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>Opens a clip, a folder of pictures or a project.</source>
        <translation>Abre un clip, una carpeta de imágenes o un proyecto.</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Página de inicio</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the clip stays open.</source>
        <translation>Muestra ejemplos y archivos recientes; el clip sigue abierto.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Saves what was drawn and where; the clip itself stays where it is.</source>
        <translation>Guarda qué se dibujó y dónde; el clip sigue donde está.</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Guardar &amp;como...</translation>
    </message>
    <message>
        <source>Saves under another name and goes on there.</source>
        <translation>Guarda con otro nombre y continúa ahí.</translation>
    </message>
    <message>
        <source>&amp;Pack the analysis</source>
        <translation>&amp;Incluir el análisis</translation>
    </message>
    <message>
        <source>Saves how the scene moves in the project as well, so that it opens at once on another computer. Makes the file larger.</source>
        <translation>Guarda también en el proyecto cómo se mueve la escena, para que se abra al instante en otro equipo. Agranda el archivo.</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportar...</translation>
    </message>
    <message>
        <source>Makes a film, a moving picture for slides, or an overlay.</source>
        <translation>Crea una película, una imagen animada para diapositivas o una superposición.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>Runs the clip in a loop, or stops it.</source>
        <translation>Reproduce el clip en bucle, o lo detiene.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>&amp;Un fotograma atrás</translation>
    </message>
    <message>
        <source>Goes to the frame before.</source>
        <translation>Va al fotograma anterior.</translation>
    </message>
    <message>
        <source>One frame &amp;on</source>
        <translation>Un &amp;fotograma adelante</translation>
    </message>
    <message>
        <source>Goes to the next frame.</source>
        <translation>Va al fotograma siguiente.</translation>
    </message>
    <message>
        <source>Goes to the first frame.</source>
        <translation>Va al primer fotograma.</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>&amp;Al final</translation>
    </message>
    <message>
        <source>Goes to the last frame.</source>
        <translation>Va al último fotograma.</translation>
    </message>
    <message>
        <source>Play back&amp;wards</source>
        <translation>Reproducir &amp;hacia atrás</translation>
    </message>
    <message>
        <source>Runs the clip backwards; again: faster.</source>
        <translation>Reproduce el clip hacia atrás; de nuevo: más rápido.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>Stops the clip.</source>
        <translation>Detiene el clip.</translation>
    </message>
    <message>
        <source>Play &amp;forwards</source>
        <translation>R&amp;eproducir hacia delante</translation>
    </message>
    <message>
        <source>Runs the clip; again: faster.</source>
        <translation>Reproduce el clip; de nuevo: más rápido.</translation>
    </message>
    <message>
        <source>So&amp;und</source>
        <translation>&amp;Sonido</translation>
    </message>
    <message>
        <source>Lets the clip be heard while it runs.</source>
        <translation>Deja oír el clip mientras se reproduce.</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>&amp;Follow what is here</source>
        <translation>&amp;Seguir lo que hay aquí</translation>
    </message>
    <message>
        <source>Pins the canvas to what is under its middle; it follows from then on.</source>
        <translation>Fija el lienzo a lo que hay bajo su centro; desde entonces lo sigue.</translation>
    </message>
    <message>
        <source>S&amp;tay here</source>
        <translation>&amp;Quedarse aquí</translation>
    </message>
    <message>
        <source>Lets the canvas stand still in the scene where it is now.</source>
        <translation>Deja el lienzo quieto en la escena, donde está ahora.</translation>
    </message>
    <message>
        <source>Face the &amp;camera</source>
        <translation>&amp;De cara a la cámara</translation>
    </message>
    <message>
        <source>Turns the canvas straight to the camera in this frame.</source>
        <translation>Gira el lienzo de frente a la cámara en este fotograma.</translation>
    </message>
    <message>
        <source>&amp;Next keyframe</source>
        <translation>Siguiente fotograma &amp;clave</translation>
    </message>
    <message>
        <source>Goes to the next frame in which the canvas is pinned, turned or sized.</source>
        <translation>Va al siguiente fotograma en que el lienzo se fija, gira o cambia de tamaño.</translation>
    </message>
    <message>
        <source>&amp;Previous keyframe</source>
        <translation>&amp;Fotograma clave anterior</translation>
    </message>
    <message>
        <source>Goes to the keyframe before.</source>
        <translation>Va al fotograma clave anterior.</translation>
    </message>
    <message>
        <source>&amp;Duplicate canvas</source>
        <translation>D&amp;uplicar lienzo</translation>
    </message>
    <message>
        <source>A second canvas with the same drawings, beside this one.</source>
        <translation>Un segundo lienzo con los mismos dibujos, junto a este.</translation>
    </message>
    <message>
        <source>Takes the canvas and its drawings away.</source>
        <translation>Quita el lienzo y sus dibujos.</translation>
    </message>
    <message>
        <source>&amp;Look at the scene again</source>
        <translation>&amp;Volver a analizar la escena</translation>
    </message>
    <message>
        <source>Finds anew how the camera and all else moves; drawings stay.</source>
        <translation>Halla de nuevo cómo se mueven la cámara y lo demás; los dibujos se quedan.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Gives up what was begun; then the choice.</source>
        <translation>Abandona lo empezado; luego, la selección.</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dibujar</translation>
    </message>
    <message>
        <source>&amp;Pen</source>
        <translation>&amp;Lápiz</translation>
    </message>
    <message>
        <source>Draws lines.</source>
        <translation>Dibuja líneas.</translation>
    </message>
    <message>
        <source>&amp;Filled shape</source>
        <translation>Forma &amp;rellena</translation>
    </message>
    <message>
        <source>Draw an outline; what is inside is filled.</source>
        <translation>Dibuje un contorno; el interior se rellena.</translation>
    </message>
    <message>
        <source>&amp;Arrow</source>
        <translation>&amp;Flecha</translation>
    </message>
    <message>
        <source>Points at something.</source>
        <translation>Señala algo.</translation>
    </message>
    <message>
        <source>&amp;Words</source>
        <translation>&amp;Texto</translation>
    </message>
    <message>
        <source>Type words, then click where they should stand.</source>
        <translation>Escriba un texto y haga clic donde deba estar.</translation>
    </message>
    <message>
        <source>&amp;Sticker</source>
        <translation>&amp;Pegatina</translation>
    </message>
    <message>
        <source>Ready-made drawings.</source>
        <translation>Dibujos ya hechos.</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>&amp;Goma</translation>
    </message>
    <message>
        <source>Takes parts of lines away.</source>
        <translation>Quita partes de las líneas.</translation>
    </message>
    <message>
        <source>&amp;Move a drawing</source>
        <translation>Mover &amp;un dibujo</translation>
    </message>
    <message>
        <source>Moves something that was drawn.</source>
        <translation>Mueve algo dibujado.</translation>
    </message>
    <message>
        <source>W&amp;ider brush</source>
        <translation>P&amp;incel más ancho</translation>
    </message>
    <message>
        <source>Makes the brush wider.</source>
        <translation>Ensancha el pincel.</translation>
    </message>
    <message>
        <source>&amp;Narrower brush</source>
        <translation>Pincel &amp;más fino</translation>
    </message>
    <message>
        <source>Makes the brush narrower.</source>
        <translation>Estrecha el pincel.</translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation>Papel &amp;cebolla</translation>
    </message>
    <message>
        <source>The drawings before shine through in red, those after in blue.</source>
        <translation>Los dibujos anteriores se traslucen en rojo; los siguientes, en azul.</translation>
    </message>
    <message>
        <source>A&amp;dd drawing</source>
        <translation>&amp;Añadir dibujo</translation>
    </message>
    <message>
        <source>An empty drawing after this one: the next moment of an animation.</source>
        <translation>Un dibujo vacío después de este: el momento siguiente de una animación.</translation>
    </message>
    <message>
        <source>D&amp;uplicate drawing</source>
        <translation>&amp;Duplicar dibujo</translation>
    </message>
    <message>
        <source>A copy of this drawing after it, to be changed a little.</source>
        <translation>Una copia de este dibujo detrás de él, para cambiarla un poco.</translation>
    </message>
    <message>
        <source>Take drawing awa&amp;y</source>
        <translation>&amp;Quitar dibujo</translation>
    </message>
    <message>
        <source>Takes the present drawing out of the animation.</source>
        <translation>Quita el dibujo actual de la animación.</translation>
    </message>
    <message>
        <source>Ne&amp;xt drawing</source>
        <translation>Dibujo &amp;siguiente</translation>
    </message>
    <message>
        <source>Goes to the next drawing of the canvas.</source>
        <translation>Va al siguiente dibujo del lienzo.</translation>
    </message>
    <message>
        <source>P&amp;revious drawing</source>
        <translation>Di&amp;bujo anterior</translation>
    </message>
    <message>
        <source>Goes to the drawing before.</source>
        <translation>Va al dibujo anterior.</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>&amp;Lienzo</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>&amp;Dibujar</translation>
    </message>
    <message>
        <source>Looking at the scene</source>
        <translation>Análisis de la escena</translation>
    </message>
    <message>
        <source>How the scene moves was not in the cache any more and was found again.</source>
        <translation>El movimiento de la escena ya no estaba en la caché y se ha vuelto a hallar.</translation>
    </message>
    <message>
        <source>What was found out is kept in the project, as the cache cannot be used: %1</source>
        <translation>Lo hallado se guarda en el proyecto, ya que la caché no se puede usar: %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Reintentar</translation>
    </message>
    <message>
        <source>The scene was not looked at to the end.</source>
        <translation>La escena no se analizó hasta el final.</translation>
    </message>
    <message>
        <source>Canvases cannot follow what moves until it is; it goes on where it was.</source>
        <translation>Hasta entonces los lienzos no pueden seguir lo que se mueve; continúa donde se quedó.</translation>
    </message>
    <message>
        <source>Look at the scene</source>
        <translation>Analizar la escena</translation>
    </message>
    <message>
        <source>The clip is too long for that: its analysis has %1 megabytes.</source>
        <translation>El clip es demasiado largo para eso: su análisis ocupa %1 megabytes.</translation>
    </message>
    <message>
        <source>DoodleStudio</source>
        <translation>DoodleStudio</translation>
    </message>
    <message>
        <source>Draw into a filmed scene, so that it stays where you put it.</source>
        <translation>Dibuje en una escena filmada, y se queda donde lo ponga.</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Abrir...</translation>
    </message>
    <message>
        <source>Drop a clip, a folder of pictures or a project anywhere.</source>
        <translation>Suelte en cualquier lugar un clip, una carpeta de imágenes o un proyecto.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Clips and projects (*.ductus %1);;All files (*)</source>
        <translation>Clips y proyectos (*.ductus %1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Apertura de %1</translation>
    </message>
    <message>
        <source>Find the clip...</source>
        <translation>Buscar el clip...</translation>
    </message>
    <message>
        <source>Looking where %1 is now</source>
        <translation>Buscando dónde está ahora %1</translation>
    </message>
    <message>
        <source>The clip was moved and is found again: %1</source>
        <translation>El clip se había movido y se ha vuelto a encontrar: %1</translation>
    </message>
    <message>
        <source>The clip has the frames and the size of the one this was drawn on, but it is another file.</source>
        <translation>El clip tiene los fotogramas y el tamaño de aquel sobre el que se dibujó, pero es otro archivo.</translation>
    </message>
    <message>
        <source>If it does not show the same scene, find the right one.</source>
        <translation>Si no muestra la misma escena, busque el correcto.</translation>
    </message>
    <message>
        <source>The clip is another one than this was drawn on.</source>
        <translation>No es el clip sobre el que se dibujó esto.</translation>
    </message>
    <message>
        <source>Its number of frames or its size differ.</source>
        <translation>Difieren su número de fotogramas o su tamaño.</translation>
    </message>
    <message>
        <source>The clip %1 is not where it was.</source>
        <translation>El clip %1 no está donde estaba.</translation>
    </message>
    <message>
        <source>Show where it is now: everything drawn is kept.</source>
        <translation>Indique dónde está ahora: todo lo dibujado se conserva.</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>¿Dónde está %1?</translation>
    </message>
    <message>
        <source>Clips (%1);;All files (*)</source>
        <translation>Clips (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Reading the sound</source>
        <translation>Lectura del sonido</translation>
    </message>
    <message>
        <source>Open a clip first; its film can be exported then.</source>
        <translation>Abra primero un clip; entonces podrá exportar su película.</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Exportado a %1.</translation>
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
        <source>&amp;Write down what I do</source>
        <translation>&amp;Anotar lo que hago</translation>
    </message>
    <message>
        <source>Every step and command with its time, from now on; nothing leaves this computer.</source>
        <translation>Cada paso y orden con su hora, desde ahora; nada sale de este equipo.</translation>
    </message>
    <message>
        <source>Nothing was written down.</source>
        <translation>No se ha anotado nada.</translation>
    </message>
    <message>
        <source>What you do is written down from now on. Edit &gt; Save what I did keeps it.</source>
        <translation>Lo que haga se anota desde ahora. Editar &gt; Guardar lo que hice lo conserva.</translation>
    </message>
    <message>
        <source>Save what I &amp;did...</source>
        <translation>&amp;Guardar lo que hice...</translation>
    </message>
    <message>
        <source>A line of JSON for every step: when, what, on which canvas, in which frame.</source>
        <translation>Una línea de JSON por paso: cuándo, qué, en qué lienzo, en qué fotograma.</translation>
    </message>
    <message>
        <source>Save what I did</source>
        <translation>Guardar lo que hice</translation>
    </message>
    <message>
        <source>Action logs (*.jsonl)</source>
        <translation>Registros de acciones (*.jsonl)</translation>
    </message>
    <message numerus="yes">
        <source>%n act(s) written to %1.</source>
        <translation>
            <numerusform>%n acción escrita en %1.</numerusform>
            <numerusform>%n acciones escritas en %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>1  Place</source>
        <translation>1  Colocar</translation>
    </message>
    <message>
        <source>Put a canvas where the drawing should be.</source>
        <translation>Ponga un lienzo donde deba estar el dibujo.</translation>
    </message>
    <message>
        <source>2  Pin</source>
        <translation>2  Fijar</translation>
    </message>
    <message>
        <source>Say where the canvas must be; it follows in between.</source>
        <translation>Diga dónde debe estar el lienzo; entre medias, sigue.</translation>
    </message>
    <message>
        <source>3  Draw</source>
        <translation>3  Dibujar</translation>
    </message>
    <message>
        <source>Draw on the canvas, seen from the front.</source>
        <translation>Dibuje en el lienzo, visto de frente.</translation>
    </message>
    <message>
        <source>Canvases</source>
        <translation>Lienzos</translation>
    </message>
    <message>
        <source>This canvas</source>
        <translation>Este lienzo</translation>
    </message>
    <message>
        <source>Brush where the canvas must be seen; it counts in the frames around, too.</source>
        <translation>Pinte donde el lienzo deba verse; también vale en los fotogramas cercanos.</translation>
    </message>
    <message>
        <source>Brush where the canvas must be hidden; it counts in the frames around, too.</source>
        <translation>Pinte donde el lienzo deba ocultarse; también vale en los fotogramas cercanos.</translation>
    </message>
    <message>
        <source>Move keyframe</source>
        <translation>Mover fotograma clave</translation>
    </message>
    <message>
        <source>Take keyframe away</source>
        <translation>Quitar fotograma clave</translation>
    </message>
    <message>
        <source>Go &amp;straight to the next keyframe</source>
        <translation>&amp;Ir recto al siguiente fotograma clave</translation>
    </message>
    <message>
        <source>Go straight</source>
        <translation>Ir en línea recta</translation>
    </message>
    <message>
        <source>Follow the scene</source>
        <translation>Seguir la escena</translation>
    </message>
    <message>
        <source>&amp;Take keyframe away</source>
        <translation>&amp;Quitar fotograma clave</translation>
    </message>
    <message>
        <source>Drag out a box on the picture: a canvas will stand there in the scene.</source>
        <translation>Arrastre un recuadro en la imagen: ahí habrá un lienzo en la escena.</translation>
    </message>
    <message>
        <source>Go to a frame where the canvas is wrong and drag it back: it is pinned there.</source>
        <translation>Vaya a un fotograma donde el lienzo esté mal y arrástrelo a su sitio: ahí queda fijado.</translation>
    </message>
    <message>
        <source>Draw on the canvas from the front, or straight on the picture.</source>
        <translation>Dibuje en el lienzo de frente, o directamente en la imagen.</translation>
    </message>
    <message>
        <source>The scene is being looked at; you can place and draw already.</source>
        <translation>La escena se está analizando; ya puede colocar y dibujar.</translation>
    </message>
    <message>
        <source>The camera&apos;s way was found: canvases stand firmly in the scene.</source>
        <translation>Se halló el recorrido de la cámara: los lienzos están firmes en la escena.</translation>
    </message>
    <message>
        <source>Positions and distances were measured from how the picture shifts.</source>
        <translation>Las posiciones y distancias se midieron por cómo se desplaza la imagen.</translation>
    </message>
    <message>
        <source>The camera turns on the spot: distances are guessed.</source>
        <translation>La cámara gira en el sitio: las distancias son estimadas.</translation>
    </message>
    <message>
        <source>Set the distance of a canvas by hand where it hides or shows wrongly.</source>
        <translation>Ajuste a mano la distancia de un lienzo donde se oculte o se muestre mal.</translation>
    </message>
    <message>
        <source>The camera stands still: distances are guessed.</source>
        <translation>La cámara está quieta: las distancias son estimadas.</translation>
    </message>
    <message>
        <source>Place a pa&amp;inting...</source>
        <translation>Colocar &amp;una pintura...</translation>
    </message>
    <message>
        <source>Stands a painting of LayerPainter in the scene: seen by the shot&apos;s camera, hidden by what is before it.</source>
        <translation>Pone una pintura de LayerPainter en la escena: vista por la cámara de la toma, oculta por lo que está delante.</translation>
    </message>
    <message>
        <source>&amp;Update paintings</source>
        <translation>Ac&amp;tualizar pinturas</translation>
    </message>
    <message>
        <source>Takes what has changed in the paintings that stand in the scene; they stay where they are.</source>
        <translation>Toma lo que ha cambiado en las pinturas de la escena; se quedan donde están.</translation>
    </message>
    <message>
        <source>&amp;Copy lines</source>
        <translation>C&amp;opiar líneas</translation>
    </message>
    <message>
        <source>Puts the lines of this drawing on the clipboard, for the other apps of the suite as well.</source>
        <translation>Pone las líneas de este dibujo en el portapapeles, también para las otras aplicaciones de la suite.</translation>
    </message>
    <message>
        <source>Draws the strokes on the clipboard on the chosen canvas, whichever app they come from.</source>
        <translation>Dibuja los trazos del portapapeles en el lienzo elegido, vengan de la aplicación que vengan.</translation>
    </message>
    <message>
        <source>Choose a canvas with drawn lines: they are copied then.</source>
        <translation>Elija un lienzo con líneas dibujadas: entonces se copiarán.</translation>
    </message>
    <message numerus="yes">
        <source>%n lines copied.</source>
        <translation>
            <numerusform>%n línea copiada.</numerusform>
            <numerusform>%n líneas copiadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a canvas, or place one: the strokes are drawn on it.</source>
        <translation>Elija un lienzo, o coloque uno: los trazos se dibujan en él.</translation>
    </message>
    <message>
        <source>Paste lines</source>
        <translation>Pegar líneas</translation>
    </message>
    <message numerus="yes">
        <source>%n lines pasted.</source>
        <translation>
            <numerusform>%n línea pegada.</numerusform>
            <numerusform>%n líneas pegadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>La pintura</translation>
    </message>
    <message>
        <source>Open a clip first; a painting can stand in it then.</source>
        <translation>Abra primero un clip; entonces podrá colocar en él una pintura.</translation>
    </message>
    <message>
        <source>Place a painting</source>
        <translation>Colocar una pintura</translation>
    </message>
    <message>
        <source>Paintings of LayerPainter (*.ductus)</source>
        <translation>Pinturas de LayerPainter (*.ductus)</translation>
    </message>
    <message>
        <source>Open a clip: %1 will stand in it.</source>
        <translation>Abra un clip: %1 estará en él.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lectura de %1</translation>
    </message>
    <message>
        <source>Place painting</source>
        <translation>Colocar pintura</translation>
    </message>
    <message>
        <source>%1 stands in the scene. Move it by its handles.</source>
        <translation>%1 está en la escena. Muévala por sus tiradores.</translation>
    </message>
    <message>
        <source>Looking for changes of the paintings</source>
        <translation>Búsqueda de cambios en las pinturas</translation>
    </message>
    <message>
        <source>No painting stands in this scene.</source>
        <translation>No hay ninguna pintura en esta escena.</translation>
    </message>
    <message>
        <source>All paintings are as they are in LayerPainter.</source>
        <translation>Todas las pinturas están como en LayerPainter.</translation>
    </message>
    <message>
        <source>The painting &quot;%1&quot; changed in LayerPainter.</source>
        <translation>La pintura «%1» cambió en LayerPainter.</translation>
    </message>
    <message numerus="yes">
        <source>%n paintings changed in LayerPainter.</source>
        <translation>
            <numerusform>%n pintura cambió en LayerPainter.</numerusform>
            <numerusform>%n pinturas cambiaron en LayerPainter.</numerusform>
        </translation>
    </message>
    <message>
        <source>Update? Where they stand and what you drew stays.</source>
        <translation>¿Actualizar? Su sitio y lo que dibujó se quedan.</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Actualizar</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Ahora no</translation>
    </message>
    <message>
        <source>Update painting</source>
        <translation>Actualizar pintura</translation>
    </message>
    <message>
        <source>To the be&amp;ginning</source>
        <translation>Al &amp;principio</translation>
    </message>
    <message>
        <source>Ta&amp;ke canvas away</source>
        <translation>Quitar &amp;lienzo</translation>
    </message>
    <message>
        <source>Paste &amp;lines</source>
        <translation>P&amp;egar líneas</translation>
    </message>
</context>
<context>
    <name>ductus::TimelineView</name>
    <message>
        <source>Canvases will stand here, one a row.</source>
        <translation>Aquí estarán los lienzos, uno por fila.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>being followed...</source>
        <translation>siguiendo...</translation>
    </message>
    <message>
        <source>stands still in the scene</source>
        <translation>quieto en la escena</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Sonido</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>fotograma %1</translation>
    </message>
    <message>
        <source>, then straight to the next</source>
        <translation>, luego recto al siguiente</translation>
    </message>
    <message>
        <source>Pinned here, %1%2. Drag to another frame; Delete takes it away.</source>
        <translation>Fijado aquí, %1%2. Arrastre a otro fotograma; Supr lo quita.</translation>
    </message>
    <message>
        <source>Distance set here, %1.</source>
        <translation>Distancia fijada aquí, %1.</translation>
    </message>
    <message>
        <source>Turned here, %1%2.</source>
        <translation>Girado aquí, %1%2.</translation>
    </message>
    <message>
        <source>Size set here, %1.</source>
        <translation>Tamaño fijado aquí, %1.</translation>
    </message>
    <message>
        <source>Drag to go through the clip. Ctrl and the wheel zoom.</source>
        <translation>Arrastre para recorrer el clip. Ctrl y la rueda amplían.</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>Dibujo %1</translation>
    </message>
</context>
<context>
    <name>ductus::TransportBar</name>
    <message>
        <source>%1   frame %2 of %3</source>
        <translation>%1   fotograma %2 de %3</translation>
    </message>
</context>
</TS>
