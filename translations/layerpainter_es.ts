<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Erase</source>
        <translation>Borrar</translation>
    </message>
</context>
<context>
    <name>ductus::BrushPanel</name>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Half the width of a stroke in the painting&apos;s unit. Keys [ and ].</source>
        <translation>La mitad de la anchura de un trazo en la unidad de la pintura. Teclas [ y ].</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Section of strokes</source>
        <translation>Sección de los trazos</translation>
    </message>
    <message>
        <source>The shape of a stroke cut across.</source>
        <translation>La forma de un trazo cortado a través.</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Redonda</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Cuadrada</translation>
    </message>
    <message>
        <source>Ribbon</source>
        <translation>Cinta</translation>
    </message>
    <message>
        <source>Where strokes go</source>
        <translation>Dónde van los trazos</translation>
    </message>
    <message>
        <source>On surface</source>
        <translation>En superficie</translation>
    </message>
    <message>
        <source>Strokes lie on what is under the pointer.</source>
        <translation>Los trazos se posan sobre lo que hay bajo el puntero.</translation>
    </message>
    <message>
        <source>On plane</source>
        <translation>En un plano</translation>
    </message>
    <message>
        <source>Strokes lie on a plane through the point the view turns around.</source>
        <translation>Los trazos se posan en un plano que pasa por el punto alrededor del cual gira la vista.</translation>
    </message>
</context>
<context>
    <name>ductus::ColourField</name>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Left and right: how colourful; up and down: how bright. The bar at the right: the hue.</source>
        <translation>Izquierda y derecha: lo vivo del color; arriba y abajo: el brillo. La barra de la derecha: el tono.</translation>
    </message>
</context>
<context>
    <name>ductus::ColourList</name>
    <message>
        <source>Layers that colour this point</source>
        <translation>Capas que colorean este punto</translation>
    </message>
    <message>
        <source>The point&apos;s colour with this layer and all below. Click: work in this layer.</source>
        <translation>El color del punto con esta capa y todas las de debajo. Clic: trabajar en esta capa.</translation>
    </message>
    <message>
        <source>Paint with %1</source>
        <translation>Pintar con %1</translation>
    </message>
    <message>
        <source> %1 %</source>
        <translation> %1 %</translation>
    </message>
    <message>
        <source>, whole scene</source>
        <translation>, toda la escena</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>forma</translation>
    </message>
</context>
<context>
    <name>ductus::ColourPanel</name>
    <message>
        <source>Colour %1</source>
        <translation>Color %1</translation>
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
        <translation>Pequeño, 640 × 360</translation>
    </message>
    <message>
        <source>Square, 1080 × 1080</source>
        <translation>Cuadrado, 1080 × 1080</translation>
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
        <translation>Exportar película</translation>
    </message>
    <message>
        <source>&amp;Seen</source>
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <source>From where the film looks at the painting.</source>
        <translation>Desde dónde mira la película a la pintura.</translation>
    </message>
    <message>
        <source>Once around, from the present view</source>
        <translation>Una vuelta, desde la vista actual</translation>
    </message>
    <message>
        <source>Along the camera path</source>
        <translation>A lo largo del recorrido de la cámara</translation>
    </message>
    <message>
        <source>From the present view</source>
        <translation>Desde la vista actual</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>A&amp;mbiente</translation>
    </message>
    <message>
        <source>Which look the film shows.</source>
        <translation>Qué ambiente muestra la película.</translation>
    </message>
    <message>
        <source>As shown now</source>
        <translation>Como se muestra ahora</translation>
    </message>
    <message>
        <source>All looks, a film each</source>
        <translation>Todos los ambientes, una película por cada uno</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Tipo</translation>
    </message>
    <message>
        <source>MP4 plays everywhere; WebM and pictures keep transparency.</source>
        <translation>MP4 se reproduce en todas partes; WebM y las imágenes conservan la transparencia.</translation>
    </message>
    <message>
        <source>MP4 - plays everywhere</source>
        <translation>MP4 - se reproduce en todas partes</translation>
    </message>
    <message>
        <source>WebM - for the web, can be transparent</source>
        <translation>WebM - para la web, puede ser transparente</translation>
    </message>
    <message>
        <source>GIF - a small loop</source>
        <translation>GIF - un pequeño bucle</translation>
    </message>
    <message>
        <source>Folder of PNG pictures</source>
        <translation>Carpeta de imágenes PNG</translation>
    </message>
    <message>
        <source>S&amp;ize</source>
        <translation>T&amp;amaño</translation>
    </message>
    <message>
        <source>Pixels of a frame.</source>
        <translation>Píxeles de un fotograma.</translation>
    </message>
    <message>
        <source>&amp;Frames a second</source>
        <translation>&amp;Fotogramas por segundo</translation>
    </message>
    <message>
        <source>25 suits films, 12 a hand-drawn loop.</source>
        <translation>25 va bien para películas, 12 para un bucle dibujado a mano.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>How long the film is; double click: as long as the painting moves.</source>
        <translation>Cuánto dura la película; doble clic: mientras se mueva la pintura.</translation>
    </message>
    <message>
        <source>&amp;Without background</source>
        <translation>&amp;Sin fondo</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportar...</translation>
    </message>
    <message>
        <source>MP4 has no transparency; choose WebM, GIF or PNG.</source>
        <translation>MP4 no admite transparencia; elija WebM, GIF o PNG.</translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n fotograma</numerusform>
            <numerusform>%n fotogramas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n films</source>
        <translation>
            <numerusform> en %n película</numerusform>
            <numerusform> en %n películas</numerusform>
        </translation>
    </message>
    <message>
        <source>, drawn in the background; you can go on painting.</source>
        <translation>, dibujados en segundo plano; puede seguir pintando.</translation>
    </message>
</context>
<context>
    <name>ductus::HeadsetWindow</name>
    <message>
        <source>Paint in &amp;VR</source>
        <translation>Pintar &amp;en RV</translation>
    </message>
    <message>
        <source>The painting in a headset, with the same layers and tools; again leaves it.</source>
        <translation>La pintura en un visor, con las mismas capas y herramientas; de nuevo para salir.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>VR</source>
        <translation>RV</translation>
    </message>
    <message>
        <source>Paint in VR</source>
        <translation>Pintar en RV</translation>
    </message>
    <message>
        <source>The painting is in the headset. This window shows what the left eye sees.</source>
        <translation>La pintura está en el visor. Esta ventana muestra lo que ve el ojo izquierdo.</translation>
    </message>
</context>
<context>
    <name>ductus::KeyTrack</name>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>&lt;b&gt;Time&lt;/b&gt;&lt;br&gt;Drag to see the painting at another moment; diamonds are keys of the camera (above) and of layers (below).</source>
        <translation>&lt;b&gt;Tiempo&lt;/b&gt;&lt;br&gt;Arrastre para ver la pintura en otro momento; los rombos son claves de la cámara (arriba) y de las capas (abajo).</translation>
    </message>
</context>
<context>
    <name>ductus::LayerPanel</name>
    <message>
        <source>Find layers</source>
        <translation>Buscar capas</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplicar</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Pantalla</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superponer</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Sumar</translation>
    </message>
    <message>
        <source>Darken</source>
        <translation>Oscurecer</translation>
    </message>
    <message>
        <source>Lighten</source>
        <translation>Aclarar</translation>
    </message>
    <message>
        <source>Colour dodge</source>
        <translation>Sobreexponer color</translation>
    </message>
    <message>
        <source>Colour burn</source>
        <translation>Subexponer color</translation>
    </message>
    <message>
        <source>Hard light</source>
        <translation>Luz fuerte</translation>
    </message>
    <message>
        <source>Soft light</source>
        <translation>Luz suave</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>Exclusion</source>
        <translation>Exclusión</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Tono</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturación</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Luminosity</source>
        <translation>Luminosidad</translation>
    </message>
    <message>
        <source>Add stack</source>
        <translation>Añadir pila</translation>
    </message>
    <message>
        <source>A new shape to paint on, with layers of its own.</source>
        <translation>Una forma nueva sobre la que pintar, con capas propias.</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Añadir capa</translation>
    </message>
    <message>
        <source>Its strokes colour the shape below them.</source>
        <translation>Sus trazos colorean la forma de debajo.</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Duplicar capa</translation>
    </message>
    <message>
        <source>A copy with all strokes, right above.</source>
        <translation>Una copia con todos los trazos, justo encima.</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>Eliminar capa</translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>Deshacer la recupera.</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>How strongly the layer shows.</source>
        <translation>Con cuánta fuerza se muestra la capa.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Fusión</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Modo de fusión</translation>
    </message>
    <message>
        <source>How its colour is mixed with what is below: Multiply darkens, Screen lightens, Overlay does both.</source>
        <translation>Cómo se mezcla su color con lo de debajo: Multiplicar oscurece, Pantalla aclara, Superponer hace ambas cosas.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>Tolerance: how far from its strokes the layer still colours. 0: only inside them.</source>
        <translation>Tolerancia: hasta qué distancia de sus trazos colorea la capa. 0: solo dentro de ellos.</translation>
    </message>
    <message>
        <source>Stack %1</source>
        <translation>Pila %1</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Capa %1</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 copia</translation>
    </message>
</context>
<context>
    <name>ductus::LayerTree</name>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ocultar</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Desbloquear</translation>
    </message>
    <message>
        <source>Lock: nothing changes it</source>
        <translation>Bloquear: nada la cambia</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n trazo</numerusform>
            <numerusform>%n trazos</numerusform>
        </translation>
    </message>
    <message>
        <source>Its layers colour everything, after all others.</source>
        <translation>Sus capas colorean todo, después de todas las demás.</translation>
    </message>
</context>
<context>
    <name>ductus::LooksBar</name>
    <message>
        <source>Looks</source>
        <translation>Ambientes</translation>
    </message>
    <message>
        <source>Keep this look</source>
        <translation>Guardar este ambiente</translation>
    </message>
    <message>
        <source>&lt;b&gt;Keep this look&lt;/b&gt;&lt;br&gt;Remembers what all layers are now: visible, how strong, how mixed.</source>
        <translation>&lt;b&gt;Guardar este ambiente&lt;/b&gt;&lt;br&gt;Recuerda cómo están ahora todas las capas: visibilidad, intensidad, fusión.</translation>
    </message>
    <message>
        <source>Look %1</source>
        <translation>Ambiente %1</translation>
    </message>
    <message>
        <source>Shows this look; right click to update, rename or delete it.</source>
        <translation>Muestra este ambiente; clic derecho para actualizarlo, renombrarlo o eliminarlo.</translation>
    </message>
    <message>
        <source>Update from the present</source>
        <translation>Actualizar con el estado actual</translation>
    </message>
    <message>
        <source>Rename...</source>
        <translation>Renombrar...</translation>
    </message>
    <message>
        <source>Rename look</source>
        <translation>Renombrar ambiente</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
</context>
<context>
    <name>ductus::MaskList</name>
    <message>
        <source>Gradient</source>
        <translation>Degradado</translation>
    </message>
    <message>
        <source>Round gradient</source>
        <translation>Degradado radial</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textura</translation>
    </message>
    <message>
        <source>Inside %1</source>
        <translation>Dentro de %1</translation>
    </message>
    <message>
        <source>Outside %1</source>
        <translation>Fuera de %1</translation>
    </message>
    <message>
        <source>Add mask</source>
        <translation>Añadir máscara</translation>
    </message>
    <message>
        <source>&lt;b&gt;Add mask&lt;/b&gt;&lt;br&gt;Masks weaken the layer in places; gradients are drawn with the gradient tool (D).</source>
        <translation>&lt;b&gt;Añadir máscara&lt;/b&gt;&lt;br&gt;Las máscaras atenúan la capa en algunos sitios; los degradados se trazan con la herramienta de degradado (D).</translation>
    </message>
    <message>
        <source>, inside out</source>
        <translation>, invertida</translation>
    </message>
    <message>
        <source>Mask of the layer. Click: on and off. With Shift: inside out. With Ctrl: remove.</source>
        <translation>Máscara de la capa. Clic: activar y desactivar. Con Mayús: invertir. Con Ctrl: quitar.</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Grano</translation>
    </message>
    <message>
        <source>How large the spots of the noise are, in the painting&apos;s unit.</source>
        <translation>El tamaño de las manchas del ruido, en la unidad de la pintura.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Cantidad</translation>
    </message>
    <message>
        <source>Where the noise begins to show: 0 everywhere, 1 nowhere.</source>
        <translation>Dónde empieza a verse el ruido: 0 en todas partes, 1 en ninguna.</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Suavidad</translation>
    </message>
    <message>
        <source>How soft the borders of the spots are.</source>
        <translation>Lo suaves que son los bordes de las manchas.</translation>
    </message>
    <message>
        <source>Texture from pictures...</source>
        <translation>Textura a partir de imágenes...</translation>
    </message>
    <message>
        <source>Inside strokes of</source>
        <translation>Dentro de los trazos de</translation>
    </message>
    <message>
        <source>Outside strokes of</source>
        <translation>Fuera de los trazos de</translation>
    </message>
    <message>
        <source>Slices of a texture, or one picture</source>
        <translation>Cortes de una textura, o una imagen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Imágenes (*.png *.jpg *.jpeg)</translation>
    </message>
</context>
<context>
    <name>ductus::MotionBar</name>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Plays motion, drawings and camera path; again stops. Key Space.</source>
        <translation>Reproduce movimiento, dibujos y recorrido de cámara; de nuevo, se detiene. Barra espaciadora.</translation>
    </message>
    <message>
        <source>Keep view</source>
        <translation>Guardar vista</translation>
    </message>
    <message>
        <source>Where you look from now becomes a key of the camera path, here in time.</source>
        <translation>La vista actual se convierte en una clave del recorrido de cámara, en este instante.</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Quitar clave</translation>
    </message>
    <message>
        <source>Takes away the camera&apos;s key under the playhead.</source>
        <translation>Quita la clave de la cámara bajo el cabezal.</translation>
    </message>
    <message>
        <source>Through the camera</source>
        <translation>Por la cámara</translation>
    </message>
    <message>
        <source>The view follows the camera path while time goes on.</source>
        <translation>La vista sigue el recorrido de la cámara mientras pasa el tiempo.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Bucle</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>After this time all begins again; 0: no loop.</source>
        <translation>Tras este tiempo todo vuelve a empezar; 0: sin bucle.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
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
        <translation>Lo que se mueve</translation>
    </message>
    <message>
        <source>Arm %1</source>
        <translation>Armar %1</translation>
    </message>
    <message>
        <source>While armed, what the transform tool drags becomes keys of all of it.</source>
        <translation>Mientras esté armado, lo que arrastre la herramienta de transformación se convierte en claves de todo ello.</translation>
    </message>
    <message>
        <source>Keys of %1</source>
        <translation>Claves de %1</translation>
    </message>
    <message>
        <source>Set key of %1</source>
        <translation>Fijar clave de %1</translation>
    </message>
    <message>
        <source>Keeps where it is now as a key, here in time.</source>
        <translation>Guarda dónde está ahora como clave, en este instante.</translation>
    </message>
    <message>
        <source>Remove key of %1</source>
        <translation>Quitar clave de %1</translation>
    </message>
    <message>
        <source>Takes away its key under the playhead.</source>
        <translation>Quita su clave bajo el cabezal.</translation>
    </message>
</context>
<context>
    <name>ductus::PainterWindow</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Capa</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>&amp;New painting</source>
        <translation>&amp;Nueva pintura</translation>
    </message>
    <message>
        <source>Begins with an empty canvas and one stack.</source>
        <translation>Empieza con un lienzo vacío y una pila.</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>Opens a project, a Quill or .tilt painting, or a mesh.</source>
        <translation>Abre un proyecto, una pintura de Quill o .tilt, o una malla.</translation>
    </message>
    <message>
        <source>&amp;Import into painting...</source>
        <translation>&amp;Importar en la pintura...</translation>
    </message>
    <message>
        <source>The strokes of another painting or a mesh join this one; dropping a file does the same.</source>
        <translation>Los trazos de otra pintura o una malla se unen a esta; soltar un archivo hace lo mismo.</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Página de inicio</translation>
    </message>
    <message>
        <source>Shows samples and recent files; the painting stays open.</source>
        <translation>Muestra ejemplos y archivos recientes; la pintura sigue abierta.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Saves the painting with layers and looks.</source>
        <translation>Guarda la pintura con capas y ambientes.</translation>
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
        <source>&amp;Export picture...</source>
        <translation>Exp&amp;ortar imagen...</translation>
    </message>
    <message>
        <source>Writes what the canvas shows as a PNG file.</source>
        <translation>Escribe lo que muestra el lienzo en un archivo PNG.</translation>
    </message>
    <message>
        <source>Export &amp;film...</source>
        <translation>E&amp;xportar película...</translation>
    </message>
    <message>
        <source>A turntable, the camera path or the motion as MP4, WebM, GIF or pictures.</source>
        <translation>Una vuelta completa, el recorrido de cámara o el movimiento como MP4, WebM, GIF o imágenes.</translation>
    </message>
    <message>
        <source>Export &amp;mesh...</source>
        <translation>&amp;Exportar malla...</translation>
    </message>
    <message>
        <source>A GLB file whose vertices have the colours of all layers, for the web.</source>
        <translation>Un archivo GLB cuyos vértices tienen los colores de todas las capas, para la web.</translation>
    </message>
    <message>
        <source>Save action &amp;log...</source>
        <translation>Guardar &amp;registro de acciones...</translation>
    </message>
    <message>
        <source>Everything done so far, a line each; layerpainter replay plays it again.</source>
        <translation>Todo lo hecho hasta ahora, una línea cada cosa; layerpainter replay lo repite.</translation>
    </message>
    <message>
        <source>&amp;Delete strokes</source>
        <translation>El&amp;iminar trazos</translation>
    </message>
    <message>
        <source>Takes the chosen strokes away.</source>
        <translation>Quita los trazos elegidos.</translation>
    </message>
    <message>
        <source>Copies of the chosen strokes in the active layer: how highlights and shadows are made.</source>
        <translation>Copias de los trazos elegidos en la capa activa: así se hacen luces y sombras.</translation>
    </message>
    <message>
        <source>&amp;Move to layer</source>
        <translation>&amp;Mover a la capa</translation>
    </message>
    <message>
        <source>The chosen strokes go into the active layer.</source>
        <translation>Los trazos elegidos pasan a la capa activa.</translation>
    </message>
    <message>
        <source>Gives the chosen strokes the present colour.</source>
        <translation>Da a los trazos elegidos el color actual.</translation>
    </message>
    <message>
        <source>Choose &amp;all of layer</source>
        <translation>Ele&amp;gir todo en la capa</translation>
    </message>
    <message>
        <source>All strokes of the active layer.</source>
        <translation>Todos los trazos de la capa activa.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Forgets what was begun, then the choice, then the tool.</source>
        <translation>Olvida lo empezado, luego la selección, luego la herramienta.</translation>
    </message>
    <message>
        <source>Add &amp;stack</source>
        <translation>&amp;Añadir pila</translation>
    </message>
    <message>
        <source>A new shape to paint on, with layers of its own.</source>
        <translation>Una forma nueva sobre la que pintar, con capas propias.</translation>
    </message>
    <message>
        <source>Add &amp;layer</source>
        <translation>Añadir &amp;capa</translation>
    </message>
    <message>
        <source>Its strokes colour the shape below them.</source>
        <translation>Sus trazos colorean la forma de debajo.</translation>
    </message>
    <message>
        <source>&amp;Duplicate layer</source>
        <translation>&amp;Duplicar capa</translation>
    </message>
    <message>
        <source>A copy with all strokes, right above.</source>
        <translation>Una copia con todos los trazos, justo encima.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renombrar</translation>
    </message>
    <message>
        <source>Another name for stack or layer.</source>
        <translation>Otro nombre para la pila o la capa.</translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>Deshacer la recupera.</translation>
    </message>
    <message>
        <source>Back to the painting&apos;s own view.</source>
        <translation>Vuelve a la vista propia de la pintura.</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Movimiento</translation>
    </message>
    <message>
        <source>Shows the timeline of motion and camera.</source>
        <translation>Muestra la línea de tiempo del movimiento y la cámara.</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>Plays motion, drawings and camera path; again stops.</source>
        <translation>Reproduce movimiento, dibujos y recorrido de cámara; de nuevo, se detiene.</translation>
    </message>
    <message>
        <source>&amp;Keep view as key</source>
        <translation>&amp;Guardar vista como clave</translation>
    </message>
    <message>
        <source>Where you look from becomes a key of the camera path at the present time.</source>
        <translation>La vista actual se convierte en una clave del recorrido de cámara en el instante presente.</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>Pincel &amp;más grande</translation>
    </message>
    <message>
        <source>Wider strokes.</source>
        <translation>Trazos más anchos.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>&amp;Smaller brush</source>
        <translation>&amp;Pincel más pequeño</translation>
    </message>
    <message>
        <source>Finer strokes.</source>
        <translation>Trazos más finos.</translation>
    </message>
    <message>
        <source>&amp;Turn view</source>
        <translation>&amp;Girar la vista</translation>
    </message>
    <message>
        <source>Drag turns the view. With other tools: the right button.</source>
        <translation>Arrastrar gira la vista. Con otras herramientas: el botón derecho.</translation>
    </message>
    <message>
        <source>Drag to turn, wheel to zoom, middle button or Shift to pan.</source>
        <translation>Arrastre para girar, rueda para zoom, botón central o Mayús para desplazar.</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Seleccionar</translation>
    </message>
    <message>
        <source>A click chooses a stroke, Shift adds, a drag chooses a box, with Ctrl a lasso.</source>
        <translation>Un clic elige un trazo, Mayús añade, arrastrar elige un recuadro, con Ctrl un lazo.</translation>
    </message>
    <message>
        <source>Click a stroke, or drag a box over strokes of the active layer. Ctrl+D copies them into the active layer.</source>
        <translation>Haga clic en un trazo, o arrastre un recuadro sobre trazos de la capa activa. Ctrl+D los copia en la capa activa.</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Mover</translation>
    </message>
    <message>
        <source>Moves, turns and scales the chosen strokes.</source>
        <translation>Mueve, gira y escala los trazos elegidos.</translation>
    </message>
    <message>
        <source>Drag the chosen strokes; the ring turns them (with Shift upright), the square scales them.</source>
        <translation>Arrastre los trazos elegidos; el anillo los gira (con Mayús, en vertical), el cuadrado los escala.</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>&amp;Pintar</translation>
    </message>
    <message>
        <source>Paints into the active layer: a shape in stacks, colour in layers.</source>
        <translation>Pinta en la capa activa: una forma en las pilas, color en las capas.</translation>
    </message>
    <message>
        <source>Paint on the surface or in the air. Shift draws straight, [ and ] change the size.</source>
        <translation>Pinte sobre la superficie o en el aire. Mayús traza recto, [ y ] cambian el tamaño.</translation>
    </message>
    <message>
        <source>&amp;Erase</source>
        <translation>&amp;Borrar</translation>
    </message>
    <message>
        <source>Takes strokes of the active layer away; with Shift only the touched parts.</source>
        <translation>Quita trazos de la capa activa; con Mayús, solo las partes tocadas.</translation>
    </message>
    <message>
        <source>Drag over strokes of the active layer. With Shift only the touched parts go.</source>
        <translation>Arrastre sobre trazos de la capa activa. Con Mayús solo desaparecen las partes tocadas.</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Degradado</translation>
    </message>
    <message>
        <source>Fades the active layer along a drag.</source>
        <translation>Desvanece la capa activa a lo largo de un arrastre.</translation>
    </message>
    <message>
        <source>Drag from where the layer is full to where it fades out. With Shift around a point.</source>
        <translation>Arrastre desde donde la capa está llena hasta donde se desvanece. Con Mayús, alrededor de un punto.</translation>
    </message>
    <message>
        <source>&amp;What colours this</source>
        <translation>&amp;Qué colorea esto</translation>
    </message>
    <message>
        <source>A click lists the layers that colour a point.</source>
        <translation>Un clic lista las capas que colorean un punto.</translation>
    </message>
    <message>
        <source>Click on the painting: the list shows which layers colour this point, the topmost first.</source>
        <translation>Haga clic en la pintura: la lista muestra qué capas colorean este punto, la superior primero.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>Ca&amp;pa</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>P&amp;incel</translation>
    </message>
    <message>
        <source>There is nothing to export yet; paint or open something first.</source>
        <translation>Aún no hay nada que exportar; pinte o abra algo primero.</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exportación de %1</translation>
    </message>
    <message>
        <source>Exported to %1, %2 x %3 pixels.</source>
        <translation>Exportado a %1, %2 x %3 píxeles.</translation>
    </message>
    <message>
        <source>There is nothing to film yet; paint or open something first.</source>
        <translation>Aún no hay nada que filmar; pinte o abra algo primero.</translation>
    </message>
    <message>
        <source>Export film</source>
        <translation>Exportar película</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Carpetas (*)</translation>
    </message>
    <message>
        <source>The film %1 is ready.</source>
        <translation>La película %1 está lista.</translation>
    </message>
    <message numerus="yes">
        <source>%n films are ready.</source>
        <translation>
            <numerusform>%n película está lista.</numerusform>
            <numerusform>%n películas están listas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Mostrar en la carpeta</translation>
    </message>
    <message>
        <source>Export mesh</source>
        <translation>Exportar malla</translation>
    </message>
    <message>
        <source>Meshes with colours (*.glb)</source>
        <translation>Mallas con colores (*.glb)</translation>
    </message>
    <message>
        <source>Exported %L1 triangles with their colours to %2.</source>
        <translation>%L1 triángulos exportados con sus colores a %2.</translation>
    </message>
    <message>
        <source>LayerPainter</source>
        <translation>LayerPainter</translation>
    </message>
    <message>
        <source>Light, shadow and mood for 3D paintings, layer by layer.</source>
        <translation>Luz, sombra y ambiente para pinturas 3D, capa a capa.</translation>
    </message>
    <message>
        <source>New painting</source>
        <translation>Nueva pintura</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Abrir...</translation>
    </message>
    <message>
        <source>Drop a Quill or .tilt painting, a mesh or a project anywhere.</source>
        <translation>Suelte en cualquier lugar una pintura de Quill o .tilt, una malla o un proyecto.</translation>
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
        <source>Paintings and meshes (*.ductus *.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;All files (*)</source>
        <translation>Pinturas y mallas (*.ductus *.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lectura de %1</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Paintings and meshes (*.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Surfaces of SketchSurfacer (*.ductus)</source>
        <translation>Pinturas y mallas (*.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Superficies de SketchSurfacer (*.ductus)</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes joined the painting</source>
        <translation>
            <numerusform>%n trazo se unió a la pintura</numerusform>
            <numerusform>%n trazos se unieron a la pintura</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n stacks.</source>
        <translation>
            <numerusform> en %n pila.</numerusform>
            <numerusform> en %n pilas.</numerusform>
        </translation>
    </message>
    <message>
        <source> Of drawings frame by frame the first came along.</source>
        <translation> De los dibujos fotograma a fotograma vino el primero.</translation>
    </message>
    <message>
        <source>Some of it was skipped: %1</source>
        <translation>Se omitió una parte: %1</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Y %n más.</numerusform>
            <numerusform>Y %n más.</numerusform>
        </translation>
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
        <source>Save action log</source>
        <translation>Guardar registro de acciones</translation>
    </message>
    <message>
        <source>Action logs (*.jsonl)</source>
        <translation>Registros de acciones (*.jsonl)</translation>
    </message>
    <message numerus="yes">
        <source>The log of %n actions is saved.</source>
        <translation>
            <numerusform>El registro de %n acción está guardado.</numerusform>
            <numerusform>El registro de %n acciones está guardado.</numerusform>
        </translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Choose strokes first; the copies go into the active layer.</source>
        <translation>Elija primero trazos; las copias van a la capa activa.</translation>
    </message>
    <message>
        <source>&amp;Update surfaces</source>
        <translation>Ac&amp;tualizar superficies</translation>
    </message>
    <message>
        <source>Takes what has changed in the sketches the surfaces were made from; your layers stay.</source>
        <translation>Toma lo que ha cambiado en los bocetos de los que salieron las superficies; sus capas se quedan.</translation>
    </message>
    <message>
        <source>&amp;Copy strokes</source>
        <translation>&amp;Copiar trazos</translation>
    </message>
    <message>
        <source>Puts the chosen strokes on the clipboard, for this app and the others of the suite.</source>
        <translation>Pone los trazos elegidos en el portapapeles, para esta aplicación y las otras de la suite.</translation>
    </message>
    <message>
        <source>&amp;Paste strokes</source>
        <translation>Pegar &amp;trazos</translation>
    </message>
    <message>
        <source>Draws the strokes on the clipboard into the active layer, whichever app they come from.</source>
        <translation>Dibuja los trazos del portapapeles en la capa activa, vengan de la aplicación que vengan.</translation>
    </message>
    <message>
        <source>Send strokes to S&amp;ketchSurfacer</source>
        <translation>En&amp;viar trazos a SketchSurfacer</translation>
    </message>
    <message>
        <source>Makes a sketch of the chosen strokes, or of the active layer, and opens it in SketchSurfacer.</source>
        <translation>Hace un boceto con los trazos elegidos, o con la capa activa, y lo abre en SketchSurfacer.</translation>
    </message>
    <message>
        <source>Send to &amp;DoodleStudio</source>
        <translation>Enviar a &amp;DoodleStudio</translation>
    </message>
    <message>
        <source>Opens DoodleStudio, where this painting can stand in a filmed scene.</source>
        <translation>Abre DoodleStudio, donde esta pintura puede estar en una escena filmada.</translation>
    </message>
    <message>
        <source>Choose strokes first: they are copied then.</source>
        <translation>Elija primero trazos: entonces se copiarán.</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes copied.</source>
        <translation>
            <numerusform>%n trazo copiado.</numerusform>
            <numerusform>%n trazos copiados.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes pasted.</source>
        <translation>
            <numerusform>%n trazo pegado.</numerusform>
            <numerusform>%n trazos pegados.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose strokes, or a layer with strokes: they become the sketch.</source>
        <translation>Elija trazos, o una capa con trazos: se convertirán en el boceto.</translation>
    </message>
    <message>
        <source>Save the sketch as</source>
        <translation>Guardar el boceto como</translation>
    </message>
    <message>
        <source> sketch</source>
        <translation> boceto</translation>
    </message>
    <message>
        <source>sketch</source>
        <translation>boceto</translation>
    </message>
    <message>
        <source>Writing the sketch</source>
        <translation>Escritura del boceto</translation>
    </message>
    <message>
        <source>There is nothing painted yet.</source>
        <translation>Aún no hay nada pintado.</translation>
    </message>
    <message>
        <source>DoodleStudio reads the saved painting, and this one has changes.</source>
        <translation>DoodleStudio lee la pintura guardada, y esta tiene cambios.</translation>
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
        <source>DoodleStudio</source>
        <translation>DoodleStudio</translation>
    </message>
    <message>
        <source>SketchSurfacer</source>
        <translation>SketchSurfacer</translation>
    </message>
    <message>
        <source>%1 opens %2.</source>
        <translation>%1 abre %2.</translation>
    </message>
    <message>
        <source>The surface</source>
        <translation>La superficie</translation>
    </message>
    <message>
        <source>Looking for changes of the sketches</source>
        <translation>Búsqueda de cambios en los bocetos</translation>
    </message>
    <message>
        <source>No surface of this painting comes from a sketch.</source>
        <translation>Ninguna superficie de esta pintura viene de un boceto.</translation>
    </message>
    <message>
        <source>All surfaces are as their sketches are.</source>
        <translation>Todas las superficies están como sus bocetos.</translation>
    </message>
    <message>
        <source>The surface of &quot;%1&quot; changed in SketchSurfacer.</source>
        <translation>La superficie de «%1» cambió en SketchSurfacer.</translation>
    </message>
    <message numerus="yes">
        <source>%n surfaces changed in SketchSurfacer.</source>
        <translation>
            <numerusform>%n superficie cambió en SketchSurfacer.</numerusform>
            <numerusform>%n superficies cambiaron en SketchSurfacer.</numerusform>
        </translation>
    </message>
    <message>
        <source>Update? Your layers, strokes and masks stay.</source>
        <translation>¿Actualizar? Sus capas, trazos y máscaras se quedan.</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Actualizar</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Ahora no</translation>
    </message>
    <message numerus="yes">
        <source>%n surfaces are as in their sketches now.</source>
        <translation>
            <numerusform>%n superficie está ahora como en su boceto.</numerusform>
            <numerusform>%n superficies están ahora como en sus bocetos.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is open in another program: this painting is saved in a file of its own and stays linked to the surface.</source>
        <translation>%1 está abierto en otro programa: esta pintura se guarda en un archivo propio y sigue vinculada a la superficie.</translation>
    </message>
    <message>
        <source>Duplicate &amp;into layer</source>
        <translation>Duplicar en &amp;la capa</translation>
    </message>
    <message>
        <source>Rec&amp;olour</source>
        <translation>R&amp;ecolorear</translation>
    </message>
    <message>
        <source>D&amp;elete layer</source>
        <translation>&amp;Eliminar capa</translation>
    </message>
    <message>
        <source>Fr&amp;ame all</source>
        <translation>E&amp;ncuadrar todo</translation>
    </message>
</context>
<context>
    <name>ductus::PaintingDocument</name>
    <message>
        <source>Add stack</source>
        <translation>Añadir pila</translation>
    </message>
    <message>
        <source>Delete stack</source>
        <translation>Eliminar pila</translation>
    </message>
    <message>
        <source>Move stack</source>
        <translation>Mover pila</translation>
    </message>
    <message>
        <source>Rename stack</source>
        <translation>Renombrar pila</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Añadir capa</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>Eliminar capa</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Mover capa</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Duplicar capa</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>Renombrar capa</translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation>Bloquear capa</translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation>Desbloquear capa</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Mostrar capa</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Ocultar capa</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Cambiar la opacidad</translation>
    </message>
    <message>
        <source>Change blend mode</source>
        <translation>Cambiar el modo de fusión</translation>
    </message>
    <message>
        <source>Change masks</source>
        <translation>Cambiar las máscaras</translation>
    </message>
    <message>
        <source>Change layer colour</source>
        <translation>Cambiar el color de la capa</translation>
    </message>
    <message>
        <source>Change tolerance</source>
        <translation>Cambiar la tolerancia</translation>
    </message>
    <message>
        <source>Move layer in time</source>
        <translation>Mover la capa en el tiempo</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Pintar</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>Eliminar trazo</translation>
    </message>
    <message>
        <source>Delete %1 strokes</source>
        <translation>Eliminar %1 trazos</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Move stroke to layer</source>
        <translation>Mover trazo a la capa</translation>
    </message>
    <message>
        <source>Move %1 strokes to layer</source>
        <translation>Mover %1 trazos a la capa</translation>
    </message>
    <message>
        <source>Duplicate stroke</source>
        <translation>Duplicar trazo</translation>
    </message>
    <message>
        <source>Duplicate %1 strokes</source>
        <translation>Duplicar %1 trazos</translation>
    </message>
    <message>
        <source>Move stroke</source>
        <translation>Mover trazo</translation>
    </message>
    <message>
        <source>Move %1 strokes</source>
        <translation>Mover %1 trazos</translation>
    </message>
    <message>
        <source>Recolour stroke</source>
        <translation>Recolorear trazo</translation>
    </message>
    <message>
        <source>Recolour %1 strokes</source>
        <translation>Recolorear %1 trazos</translation>
    </message>
    <message>
        <source>Add look</source>
        <translation>Añadir ambiente</translation>
    </message>
    <message>
        <source>Update look</source>
        <translation>Actualizar ambiente</translation>
    </message>
    <message>
        <source>Switch look</source>
        <translation>Cambiar de ambiente</translation>
    </message>
    <message>
        <source>Rename look</source>
        <translation>Renombrar ambiente</translation>
    </message>
    <message>
        <source>Delete look</source>
        <translation>Eliminar ambiente</translation>
    </message>
    <message>
        <source>Change scene</source>
        <translation>Cambiar la escena</translation>
    </message>
    <message>
        <source>Change camera path</source>
        <translation>Cambiar el recorrido de cámara</translation>
    </message>
    <message>
        <source>Add motion group</source>
        <translation>Añadir grupo de movimiento</translation>
    </message>
    <message>
        <source>Change motion</source>
        <translation>Cambiar el movimiento</translation>
    </message>
    <message>
        <source>Delete motion group</source>
        <translation>Eliminar grupo de movimiento</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Update surface</source>
        <translation>Actualizar superficie</translation>
    </message>
</context>
<context>
    <name>ductus::PaintingView</name>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
</context>
<context>
    <name>ductus::PictureDialog</name>
    <message>
        <source>Export picture</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> píxeles</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 píxeles</translation>
    </message>
    <message>
        <source>Without background</source>
        <translation>Sin fondo</translation>
    </message>
    <message>
        <source>&lt;b&gt;Without background&lt;/b&gt;&lt;br&gt;Where nothing is painted the picture is transparent, to be put on something else.</source>
        <translation>&lt;b&gt;Sin fondo&lt;/b&gt;&lt;br&gt;Donde no hay nada pintado la imagen es transparente, para ponerla sobre otra cosa.</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Anchura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportar...</translation>
    </message>
</context>
<context>
    <name>ductus::PointColours</name>
    <message>
        <source>Looking which layers colour this</source>
        <translation>Búsqueda de las capas que colorean esto</translation>
    </message>
</context>
<context>
    <name>ductus::RoomPanels</name>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Brush and colour</source>
        <translation>Pincel y color</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>Zurdo</translation>
    </message>
    <message>
        <source>The left hand paints, the right one holds the panels.</source>
        <translation>La mano izquierda pinta, la derecha sostiene los paneles.</translation>
    </message>
    <message>
        <source>Leave VR</source>
        <translation>Salir de la RV</translation>
    </message>
</context>
</TS>
