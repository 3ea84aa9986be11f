<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>ductus::ActionSearch</name>
    <message>
        <source>Search actions</source>
        <translation>Buscar acciones</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>¿Qué desea hacer?</translation>
    </message>
    <message>
        <source>Found actions</source>
        <translation>Acciones encontradas</translation>
    </message>
    <message>
        <source>Nothing is called like that.</source>
        <translation>Nada se llama así.</translation>
    </message>
</context>
<context>
    <name>ductus::AppearancePage</name>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>Dark or light, as the rest of your desktop.</source>
        <translation>Oscuro o claro, como el resto del escritorio.</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Lets pictures and strokes stand out.</source>
        <translation>Hace resaltar las imágenes y los trazos.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Easier to read in bright rooms and on projectors.</source>
        <translation>Más legible en salas luminosas y con proyector.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Pictures you export do not depend on it.</source>
        <translation>Las imágenes exportadas no dependen de él.</translation>
    </message>
    <message>
        <source>Takes effect when the app is started again.</source>
        <translation>Se aplica la próxima vez que se inicie la aplicación.</translation>
    </message>
</context>
<context>
    <name>ductus::Autosave</name>
    <message>
        <source>Autosaving</source>
        <translation>Guardado automático</translation>
    </message>
</context>
<context>
    <name>ductus::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>it was made by a newer version of Ductus</source>
        <translation>se creó con una versión más reciente de Ductus</translation>
    </message>
</context>
<context>
    <name>ductus::DocumentFiles</name>
    <message>
        <source>the file may not be written</source>
        <translation>el archivo no admite escritura</translation>
    </message>
    <message>
        <source>%1 is open for reading only: %2. Save under another name to keep changes.</source>
        <translation>%1 está abierto solo para lectura: %2. Guárdelo con otro nombre para conservar los cambios.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Apertura de %1</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>Lectura del archivo</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Guardado de %1</translation>
    </message>
    <message>
        <source>Writing the file</source>
        <translation>Escritura del archivo</translation>
    </message>
</context>
<context>
    <name>ductus::EngineWords</name>
    <message>
        <source>Adding a group</source>
        <translation>Añadir un grupo</translation>
    </message>
    <message>
        <source>Adding a layer</source>
        <translation>Añadir una capa</translation>
    </message>
    <message>
        <source>Adding strokes</source>
        <translation>Añadir trazos</translation>
    </message>
    <message>
        <source>Applying a scribble</source>
        <translation>Aplicar un garabato</translation>
    </message>
    <message>
        <source>Applying the look</source>
        <translation>Aplicar el ambiente</translation>
    </message>
    <message>
        <source>Associating strokes</source>
        <translation>Asociar los trazos</translation>
    </message>
    <message>
        <source>Associating strokes with the proxy</source>
        <translation>Asociar los trazos con el proxy</translation>
    </message>
    <message>
        <source>Attracting the proxy</source>
        <translation>Atraer el proxy</translation>
    </message>
    <message>
        <source>Attracting the proxy to the strokes</source>
        <translation>Atraer el proxy hacia los trazos</translation>
    </message>
    <message>
        <source>Baking the painting</source>
        <translation>Calcular los colores de la pintura</translation>
    </message>
    <message>
        <source>Changing how long the frame is shown</source>
        <translation>Cambiar la duración del dibujo</translation>
    </message>
    <message>
        <source>Changing the camera path</source>
        <translation>Cambiar el recorrido de cámara</translation>
    </message>
    <message>
        <source>Changing the canvas</source>
        <translation>Cambiar el lienzo</translation>
    </message>
    <message>
        <source>Changing the keyframe</source>
        <translation>Cambiar el fotograma clave</translation>
    </message>
    <message>
        <source>Changing the layer</source>
        <translation>Cambiar la capa</translation>
    </message>
    <message>
        <source>Changing the mark</source>
        <translation>Cambiar el dibujo</translation>
    </message>
    <message>
        <source>Changing the motion</source>
        <translation>Cambiar el movimiento</translation>
    </message>
    <message>
        <source>Changing the scene</source>
        <translation>Cambiar la escena</translation>
    </message>
    <message>
        <source>Changing the tolerance</source>
        <translation>Cambiar la tolerancia</translation>
    </message>
    <message>
        <source>Checking the painting</source>
        <translation>Comprobar la pintura</translation>
    </message>
    <message>
        <source>Checking the print</source>
        <translation>Comprobar la impresión</translation>
    </message>
    <message>
        <source>Checking the project</source>
        <translation>Comprobar el proyecto</translation>
    </message>
    <message>
        <source>Contouring the smooth surface</source>
        <translation>Contornear la superficie suave</translation>
    </message>
    <message>
        <source>Cutting the stroke</source>
        <translation>Cortar el trazo</translation>
    </message>
    <message>
        <source>Discarding the recovered copy</source>
        <translation>Descartar la copia recuperada</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Dibujar</translation>
    </message>
    <message>
        <source>Drawing other readings</source>
        <translation>Dibujar otras interpretaciones</translation>
    </message>
    <message>
        <source>Drawing the painting</source>
        <translation>Dibujar la pintura</translation>
    </message>
    <message>
        <source>Drawing the samples</source>
        <translation>Dibujar los ejemplos</translation>
    </message>
    <message>
        <source>Drawing the surface</source>
        <translation>Dibujar la superficie</translation>
    </message>
    <message>
        <source>Duplicating strokes</source>
        <translation>Duplicar trazos</translation>
    </message>
    <message>
        <source>Duplicating the layer</source>
        <translation>Duplicar la capa</translation>
    </message>
    <message>
        <source>Entering VR</source>
        <translation>Entrar en RV</translation>
    </message>
    <message>
        <source>Evening out the triangles</source>
        <translation>Igualar los triángulos</translation>
    </message>
    <message>
        <source>Exporting the film</source>
        <translation>Exportar la película</translation>
    </message>
    <message>
        <source>Exporting the painting</source>
        <translation>Exportar la pintura</translation>
    </message>
    <message>
        <source>Exporting the surface</source>
        <translation>Exportar la superficie</translation>
    </message>
    <message>
        <source>Finding how far away things are</source>
        <translation>Hallar las distancias</translation>
    </message>
    <message>
        <source>Finding how the camera moved</source>
        <translation>Hallar el movimiento de la cámara</translation>
    </message>
    <message>
        <source>Finding how the scene moves</source>
        <translation>Hallar el movimiento de la escena</translation>
    </message>
    <message>
        <source>Finding stroke normals</source>
        <translation>Hallar las normales de los trazos</translation>
    </message>
    <message>
        <source>Finding surface patches</source>
        <translation>Hallar las partes de la superficie</translation>
    </message>
    <message>
        <source>Finding what moves by itself</source>
        <translation>Hallar lo que se mueve solo</translation>
    </message>
    <message>
        <source>Fitting a smooth surface</source>
        <translation>Ajustar una superficie suave</translation>
    </message>
    <message>
        <source>Fitting a smooth surface piece by piece</source>
        <translation>Ajustar una superficie suave por partes</translation>
    </message>
    <message>
        <source>Fitting a smooth surface through the strokes</source>
        <translation>Ajustar una superficie suave a los trazos</translation>
    </message>
    <message>
        <source>Fitting changed strokes</source>
        <translation>Ajustar los trazos cambiados</translation>
    </message>
    <message>
        <source>Fitting the final mesh</source>
        <translation>Ajustar la malla final</translation>
    </message>
    <message>
        <source>Fitting the surface</source>
        <translation>Ajustar la superficie</translation>
    </message>
    <message>
        <source>Following the canvas</source>
        <translation>Seguir el lienzo</translation>
    </message>
    <message>
        <source>Following the canvases</source>
        <translation>Seguir los lienzos</translation>
    </message>
    <message>
        <source>Importing the painting</source>
        <translation>Importar la pintura</translation>
    </message>
    <message>
        <source>Importing the surface</source>
        <translation>Importar la superficie</translation>
    </message>
    <message>
        <source>Keeping what was found out about the clip</source>
        <translation>Guardar el análisis del clip</translation>
    </message>
    <message>
        <source>Locking the project</source>
        <translation>Bloquear el proyecto</translation>
    </message>
    <message>
        <source>Looking at the scene</source>
        <translation>Analizar la escena</translation>
    </message>
    <message>
        <source>Looking for cables</source>
        <translation>Buscar cables</translation>
    </message>
    <message>
        <source>Looking for other readings</source>
        <translation>Buscar otras interpretaciones</translation>
    </message>
    <message>
        <source>Looking which clip it is</source>
        <translation>Identificar el clip</translation>
    </message>
    <message>
        <source>Making a proxy</source>
        <translation>Crear un proxy</translation>
    </message>
    <message>
        <source>Making a tube along a stroke</source>
        <translation>Crear un tubo a lo largo de un trazo</translation>
    </message>
    <message>
        <source>Making stacks of the layers</source>
        <translation>Crear pilas con las capas</translation>
    </message>
    <message>
        <source>Measuring how exact the points are</source>
        <translation>Medir la exactitud de los puntos</translation>
    </message>
    <message>
        <source>Measuring walls</source>
        <translation>Medir las paredes</translation>
    </message>
    <message>
        <source>Moving strokes to a layer</source>
        <translation>Mover trazos a una capa</translation>
    </message>
    <message>
        <source>Moving the canvas</source>
        <translation>Mover el lienzo</translation>
    </message>
    <message>
        <source>Moving the canvas in depth</source>
        <translation>Mover el lienzo en profundidad</translation>
    </message>
    <message>
        <source>Moving the keyframe</source>
        <translation>Mover el fotograma clave</translation>
    </message>
    <message>
        <source>Moving the layer</source>
        <translation>Mover la capa</translation>
    </message>
    <message>
        <source>Moving the proxy to the changed strokes</source>
        <translation>Mover el proxy hacia los trazos cambiados</translation>
    </message>
    <message>
        <source>Moving the stack</source>
        <translation>Mover la pila</translation>
    </message>
    <message>
        <source>Opening the clip</source>
        <translation>Abrir el clip</translation>
    </message>
    <message>
        <source>Opening the painting</source>
        <translation>Abrir la pintura</translation>
    </message>
    <message>
        <source>Opening the project</source>
        <translation>Abrir el proyecto</translation>
    </message>
    <message>
        <source>Opening the sample</source>
        <translation>Abrir el ejemplo</translation>
    </message>
    <message>
        <source>Painting in VR</source>
        <translation>Pintar en RV</translation>
    </message>
    <message>
        <source>Pasting strokes</source>
        <translation>Pegar trazos</translation>
    </message>
    <message>
        <source>Pinning the canvas</source>
        <translation>Fijar el lienzo</translation>
    </message>
    <message>
        <source>Placing the canvas</source>
        <translation>Colocar el lienzo</translation>
    </message>
    <message>
        <source>Placing a painting</source>
        <translation>Colocar una pintura</translation>
    </message>
    <message>
        <source>Preparing the frame</source>
        <translation>Preparar el fotograma</translation>
    </message>
    <message>
        <source>Preparing the graphics card</source>
        <translation>Preparar la tarjeta gráfica</translation>
    </message>
    <message>
        <source>Reading a texture</source>
        <translation>Leer una textura</translation>
    </message>
    <message>
        <source>Reading the cameras</source>
        <translation>Leer las cámaras</translation>
    </message>
    <message>
        <source>Reading the clip</source>
        <translation>Leer el clip</translation>
    </message>
    <message>
        <source>Reading the depth maps</source>
        <translation>Leer los mapas de profundidad</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>Leer la malla</translation>
    </message>
    <message>
        <source>Reading the painting</source>
        <translation>Leer la pintura</translation>
    </message>
    <message>
        <source>Reading the picture</source>
        <translation>Leer la imagen</translation>
    </message>
    <message>
        <source>Reading the points</source>
        <translation>Leer los puntos</translation>
    </message>
    <message>
        <source>Reading the project</source>
        <translation>Leer el proyecto</translation>
    </message>
    <message>
        <source>Reading the proxy</source>
        <translation>Leer el proxy</translation>
    </message>
    <message>
        <source>Reading the sketch</source>
        <translation>Leer el boceto</translation>
    </message>
    <message>
        <source>Reading the sketch&apos;s size</source>
        <translation>Leer el tamaño del boceto</translation>
    </message>
    <message>
        <source>Reading the sound</source>
        <translation>Leer el sonido</translation>
    </message>
    <message>
        <source>Reading the sound of the clip</source>
        <translation>Leer el sonido del clip</translation>
    </message>
    <message>
        <source>Reading what was found out about the clip</source>
        <translation>Leer el análisis del clip</translation>
    </message>
    <message>
        <source>Recolouring strokes</source>
        <translation>Recolorear trazos</translation>
    </message>
    <message>
        <source>Remeshing</source>
        <translation>Remallado</translation>
    </message>
    <message>
        <source>Removing strokes</source>
        <translation>Quitar trazos</translation>
    </message>
    <message>
        <source>Removing the canvas</source>
        <translation>Quitar el lienzo</translation>
    </message>
    <message>
        <source>Removing the group</source>
        <translation>Quitar el grupo</translation>
    </message>
    <message>
        <source>Removing the keyframe</source>
        <translation>Quitar el fotograma clave</translation>
    </message>
    <message>
        <source>Removing the layer</source>
        <translation>Quitar la capa</translation>
    </message>
    <message>
        <source>Removing the look</source>
        <translation>Quitar el ambiente</translation>
    </message>
    <message>
        <source>Removing the stack</source>
        <translation>Quitar la pila</translation>
    </message>
    <message>
        <source>Renaming the layer</source>
        <translation>Renombrar la capa</translation>
    </message>
    <message>
        <source>Renaming the look</source>
        <translation>Renombrar el ambiente</translation>
    </message>
    <message>
        <source>Renaming the stack</source>
        <translation>Renombrar la pila</translation>
    </message>
    <message>
        <source>Repairing the mesh</source>
        <translation>Reparar la malla</translation>
    </message>
    <message>
        <source>Restoring the chosen reading</source>
        <translation>Restaurar la interpretación elegida</translation>
    </message>
    <message>
        <source>Saving the project</source>
        <translation>Guardar el proyecto</translation>
    </message>
    <message>
        <source>Segmenting the surface</source>
        <translation>Segmentar la superficie</translation>
    </message>
    <message>
        <source>Surfacing</source>
        <translation>Crear la superficie</translation>
    </message>
    <message>
        <source>Surfacing the points</source>
        <translation>Crear la superficie de los puntos</translation>
    </message>
    <message>
        <source>Surfacing the sketch</source>
        <translation>Crear la superficie del boceto</translation>
    </message>
    <message>
        <source>Trimming the open surface</source>
        <translation>Recortar la superficie abierta</translation>
    </message>
    <message>
        <source>Turning the canvas</source>
        <translation>Girar el lienzo</translation>
    </message>
    <message>
        <source>Unpacking an entry of the project</source>
        <translation>Descomprimir una entrada del proyecto</translation>
    </message>
    <message>
        <source>Uploading the painting</source>
        <translation>Cargar la pintura en la tarjeta gráfica</translation>
    </message>
    <message>
        <source>Wrapping the strokes</source>
        <translation>Envolver los trazos</translation>
    </message>
    <message>
        <source>Writing the action log</source>
        <translation>Escribir el registro de acciones</translation>
    </message>
    <message>
        <source>Writing the film</source>
        <translation>Escribir la película</translation>
    </message>
    <message>
        <source>Writing the mesh</source>
        <translation>Escribir la malla</translation>
    </message>
    <message>
        <source>Writing the picture</source>
        <translation>Escribir la imagen</translation>
    </message>
    <message>
        <source>Writing the project</source>
        <translation>Escribir el proyecto</translation>
    </message>
    <message>
        <source>Writing the sound</source>
        <translation>Escribir el sonido</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>no existe ese archivo</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>el archivo está vacío</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>no se puede abrir el archivo</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>no se puede escribir el archivo</translation>
    </message>
    <message>
        <source>the memory does not suffice for it</source>
        <translation>la memoria no alcanza para ello</translation>
    </message>
    <message>
        <source>this is a PLY mesh</source>
        <translation>es una malla PLY</translation>
    </message>
    <message>
        <source>this is an OFF mesh</source>
        <translation>es una malla OFF</translation>
    </message>
    <message>
        <source>this is an STL mesh</source>
        <translation>es una malla STL</translation>
    </message>
    <message>
        <source>this is a GLB scene</source>
        <translation>es una escena GLB</translation>
    </message>
    <message>
        <source>this is a zip archive</source>
        <translation>es un archivo zip</translation>
    </message>
    <message>
        <source>this is a PNG picture</source>
        <translation>es una imagen PNG</translation>
    </message>
    <message>
        <source>this is JSON</source>
        <translation>es JSON</translation>
    </message>
    <message>
        <source>there is no stroke in it</source>
        <translation>no contiene ningún trazo</translation>
    </message>
    <message>
        <source>there is no sketch in it</source>
        <translation>no contiene ningún boceto</translation>
    </message>
    <message>
        <source>the project holds no painting</source>
        <translation>el proyecto no contiene ninguna pintura</translation>
    </message>
    <message>
        <source>no stroke lies near the proxy mesh</source>
        <translation>ningún trazo está cerca de la malla proxy</translation>
    </message>
    <message>
        <source>the sketch has too few strokes for a surface</source>
        <translation>el boceto tiene muy pocos trazos para una superficie</translation>
    </message>
    <message>
        <source>all strokes lie in one plane</source>
        <translation>todos los trazos están en un plano</translation>
    </message>
    <message>
        <source>the equations are singular</source>
        <translation>las ecuaciones son singulares</translation>
    </message>
    <message>
        <source>no piece could be fitted</source>
        <translation>no se pudo ajustar ninguna parte</translation>
    </message>
    <message>
        <source>the connection to the headset was lost</source>
        <translation>se perdió la conexión con el visor</translation>
    </message>
    <message>
        <source>no headset is connected or it is switched off</source>
        <translation>no hay ningún visor conectado o está apagado</translation>
    </message>
    <message>
        <source>there is no such stack</source>
        <translation>no existe esa pila</translation>
    </message>
    <message>
        <source>there is no such layer</source>
        <translation>no existe esa capa</translation>
    </message>
    <message>
        <source>there is no such look</source>
        <translation>no existe ese ambiente</translation>
    </message>
    <message>
        <source>it is not part of this installation</source>
        <translation>no forma parte de esta instalación</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Compruebe la ruta</translation>
    </message>
    <message>
        <source>Check the name</source>
        <translation>Compruebe el nombre</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Elija otra carpeta</translation>
    </message>
    <message>
        <source>Choose another folder, or make room on the disk</source>
        <translation>Elija otra carpeta o libere espacio en el disco</translation>
    </message>
    <message>
        <source>Make room on the disk</source>
        <translation>Libere espacio en el disco</translation>
    </message>
    <message>
        <source>Free some space and try again</source>
        <translation>Libere espacio e inténtelo de nuevo</translation>
    </message>
    <message>
        <source>Choose a PNG or JPEG file</source>
        <translation>Elija un archivo PNG o JPEG</translation>
    </message>
    <message>
        <source>Choose a file with 3D strokes</source>
        <translation>Elija un archivo con trazos 3D</translation>
    </message>
    <message>
        <source>Choose a file with painted layers</source>
        <translation>Elija un archivo con capas pintadas</translation>
    </message>
    <message>
        <source>Choose it again</source>
        <translation>Elíjalo de nuevo</translation>
    </message>
    <message>
        <source>Correct this line or export the file again</source>
        <translation>Corrija esta línea o exporte de nuevo el archivo</translation>
    </message>
    <message>
        <source>Correct this line or export the mesh again</source>
        <translation>Corrija esta línea o exporte de nuevo la malla</translation>
    </message>
    <message>
        <source>Export the mesh again</source>
        <translation>Exporte de nuevo la malla</translation>
    </message>
    <message>
        <source>Export the sketch again</source>
        <translation>Exporte de nuevo el boceto</translation>
    </message>
    <message>
        <source>The file seems cut off: copy or export it again</source>
        <translation>El archivo parece cortado: cópielo o expórtelo de nuevo</translation>
    </message>
    <message>
        <source>Check that this is a text file</source>
        <translation>Compruebe que es un archivo de texto</translation>
    </message>
    <message>
        <source>Draw more strokes, or give a proxy mesh</source>
        <translation>Dibuje más trazos, o dé una malla proxy</translation>
    </message>
    <message>
        <source>Draw strokes in depth, or give a proxy mesh</source>
        <translation>Dibuje trazos en profundidad, o dé una malla proxy</translation>
    </message>
    <message>
        <source>Give a proxy mesh</source>
        <translation>Dé una malla proxy</translation>
    </message>
    <message>
        <source>Surface the whole sketch anew</source>
        <translation>Cree de nuevo toda la superficie</translation>
    </message>
    <message>
        <source>Check that proxy and sketch have the same position, axes and scale</source>
        <translation>Compruebe que proxy y boceto tengan la misma posición, ejes y escala</translation>
    </message>
    <message>
        <source>Repair the mesh or export it again</source>
        <translation>Repare la malla o expórtela de nuevo</translation>
    </message>
    <message>
        <source>Simplify the mesh first</source>
        <translation>Simplifique antes la malla</translation>
    </message>
    <message>
        <source>Save the project again in Quill</source>
        <translation>Guarde de nuevo el proyecto en Quill</translation>
    </message>
    <message>
        <source>Open the previous version of the file, its name ends in ~</source>
        <translation>Abra la versión anterior del archivo, su nombre termina en ~</translation>
    </message>
    <message>
        <source>Open it in the app that made it</source>
        <translation>Ábralo en la aplicación que lo creó</translation>
    </message>
    <message>
        <source>Open it with the app it was made with</source>
        <translation>Ábralo con la aplicación que lo creó</translation>
    </message>
    <message>
        <source>Install a newer version of Ductus</source>
        <translation>Instale una versión más reciente de Ductus</translation>
    </message>
    <message>
        <source>Update the graphics driver</source>
        <translation>Actualice el controlador gráfico</translation>
    </message>
    <message>
        <source>Update the headset software</source>
        <translation>Actualice el software del visor</translation>
    </message>
    <message>
        <source>Switch the headset on and try again</source>
        <translation>Encienda el visor e inténtelo de nuevo</translation>
    </message>
    <message>
        <source>The painting is still here; connect the headset and enter VR again</source>
        <translation>La pintura sigue aquí; conecte el visor y vuelva a entrar en RV</translation>
    </message>
    <message>
        <source>Choose a stack of this painting</source>
        <translation>Elija una pila de esta pintura</translation>
    </message>
    <message>
        <source>Choose a look of this painting</source>
        <translation>Elija un ambiente de esta pintura</translation>
    </message>
    <message>
        <source>Close other programs or work on a smaller part</source>
        <translation>Cierre otros programas o trabaje en una parte más pequeña</translation>
    </message>
    <message>
        <source>Save your work and report this with the file</source>
        <translation>Guarde su trabajo e informe de esto junto con el archivo</translation>
    </message>
    <message>
        <source>Surface the sketch in SketchSurfacer and save it</source>
        <translation>Cree la superficie en SketchSurfacer y guárdela</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Compruebe sus permisos</translation>
    </message>
    <message>
        <source>Choose a layer of this painting</source>
        <translation>Elija una capa de esta pintura</translation>
    </message>
    <message>
        <source>Choose a project that was saved in LayerPainter</source>
        <translation>Elija un proyecto guardado en LayerPainter</translation>
    </message>
    <message>
        <source>Choose a video that a player on this computer can show, or a folder of pictures</source>
        <translation>Elija un vídeo que este equipo pueda reproducir, o una carpeta de imágenes</translation>
    </message>
    <message>
        <source>Choose a video, or a folder of JPEG or PNG pictures</source>
        <translation>Elija un vídeo, o una carpeta de imágenes JPEG o PNG</translation>
    </message>
    <message>
        <source>Choose another file, or convert it to MP4 (H.264)</source>
        <translation>Elija otro archivo, o conviértalo a MP4 (H.264)</translation>
    </message>
    <message>
        <source>Close it there, or open it read-only</source>
        <translation>Ciérrelo allí, o ábralo solo para lectura</translation>
    </message>
    <message>
        <source>Close the other program</source>
        <translation>Cierre el otro programa</translation>
    </message>
    <message>
        <source>Copy fewer strokes</source>
        <translation>Copie menos trazos</translation>
    </message>
    <message>
        <source>Copy strokes in an app of the suite first</source>
        <translation>Copie primero trazos en una aplicación de la suite</translation>
    </message>
    <message>
        <source>Copy the file to another disk and try again</source>
        <translation>Copie el archivo a otro disco e inténtelo de nuevo</translation>
    </message>
    <message>
        <source>Draw it from border to border of a region, or closed up to a ring</source>
        <translation>Dibújelo de borde a borde de una región, o cerrado en un anillo</translation>
    </message>
    <message>
        <source>Free some space or save to another place</source>
        <translation>Libere espacio o guarde en otro lugar</translation>
    </message>
    <message>
        <source>Give a scale above zero</source>
        <translation>Dé una escala mayor que cero</translation>
    </message>
    <message>
        <source>Give a value inside its range</source>
        <translation>Dé un valor dentro de su intervalo</translation>
    </message>
    <message>
        <source>Go on with what was taken from it</source>
        <translation>Siga con lo que se tomó de él</translation>
    </message>
    <message>
        <source>Install and start the software of your headset, such as SteamVR or Monado, and make it the active OpenXR runtime</source>
        <translation>Instale e inicie el software de su visor, como SteamVR o Monado, y conviértalo en el runtime de OpenXR activo</translation>
    </message>
    <message>
        <source>Install it beside this one, or put its folder into PATH</source>
        <translation>Instálelo junto a este, o ponga su carpeta en PATH</translation>
    </message>
    <message>
        <source>Make it smaller</source>
        <translation>Redúzcala</translation>
    </message>
    <message>
        <source>Make room on the disk or check the folder&apos;s permissions</source>
        <translation>Libere espacio o compruebe los permisos de la carpeta</translation>
    </message>
    <message>
        <source>Mark the strokes along the border of the surface, and no others, as boundary</source>
        <translation>Marque como borde los trazos a lo largo del borde de la superficie, y solo esos</translation>
    </message>
    <message>
        <source>MP4 has no transparency</source>
        <translation>MP4 no admite transparencia</translation>
    </message>
    <message>
        <source>No mirror plane was found; the whole sketch is surfaced.</source>
        <translation>No se encontró plano de simetría; se crea la superficie de todo el boceto.</translation>
    </message>
    <message>
        <source>Open it read-only or save a copy elsewhere</source>
        <translation>Ábralo solo para lectura o guarde una copia en otro lugar</translation>
    </message>
    <message>
        <source>Put it back, or go on with what was taken from it</source>
        <translation>Devuélvalo a su sitio, o siga con lo que se tomó de él</translation>
    </message>
    <message>
        <source>Remove it as a whole</source>
        <translation>Quítela entera</translation>
    </message>
    <message>
        <source>Remove that mask first</source>
        <translation>Quite primero esa máscara</translation>
    </message>
    <message>
        <source>Remove the lock first</source>
        <translation>Quite primero el bloqueo</translation>
    </message>
    <message>
        <source>Remove the whole stack</source>
        <translation>Quite toda la pila</translation>
    </message>
    <message>
        <source>Save it again</source>
        <translation>Guárdelo de nuevo</translation>
    </message>
    <message>
        <source>Save to another disk</source>
        <translation>Guarde en otro disco</translation>
    </message>
    <message>
        <source>Save to another place</source>
        <translation>Guarde en otro lugar</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Guarde con otro nombre</translation>
    </message>
    <message>
        <source>Scale it less</source>
        <translation>Escálelo menos</translation>
    </message>
    <message>
        <source>Show a stack that has strokes</source>
        <translation>Muestre una pila que tenga trazos</translation>
    </message>
    <message>
        <source>Surface it in SketchSurfacer and save it</source>
        <translation>Cree la superficie en SketchSurfacer y guárdela</translation>
    </message>
    <message>
        <source>Unlock it first</source>
        <translation>Desbloquéela primero</translation>
    </message>
    <message>
        <source>a chosen stroke is not in the painting</source>
        <translation>un trazo elegido no está en la pintura</translation>
    </message>
    <message>
        <source>a stack has one substrate</source>
        <translation>una pila tiene un soporte</translation>
    </message>
    <message>
        <source>a stroke would become too large or too small</source>
        <translation>un trazo quedaría demasiado grande o pequeño</translation>
    </message>
    <message>
        <source>a substrate stays with its stack</source>
        <translation>un soporte se queda con su pila</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>todos los puntos están en un plano</translation>
    </message>
    <message>
        <source>another program uses the headset</source>
        <translation>otro programa usa el visor</translation>
    </message>
    <message>
        <source>every painting has a scene stack</source>
        <translation>toda pintura tiene una pila de escena</translation>
    </message>
    <message>
        <source>it does not part a region</source>
        <translation>no divide ninguna región</translation>
    </message>
    <message>
        <source>it has no finished surface now</source>
        <translation>ahora no tiene superficie terminada</translation>
    </message>
    <message>
        <source>it is a mesh</source>
        <translation>es una malla</translation>
    </message>
    <message>
        <source>it is not in its project any more</source>
        <translation>ya no está en su proyecto</translation>
    </message>
    <message>
        <source>it is not there any more</source>
        <translation>ya no existe</translation>
    </message>
    <message>
        <source>it is the only one</source>
        <translation>es el único</translation>
    </message>
    <message>
        <source>it lies far from the surface</source>
        <translation>está lejos de la superficie</translation>
    </message>
    <message>
        <source>it lies in a locked region</source>
        <translation>está en una región bloqueada</translation>
    </message>
    <message>
        <source>it was made by a newer version of Ductus and may only be read</source>
        <translation>se creó con una versión más reciente de Ductus y solo se puede leer</translation>
    </message>
    <message>
        <source>its project is not where it was</source>
        <translation>su proyecto no está donde estaba</translation>
    </message>
    <message>
        <source>its size is not positive</source>
        <translation>su tamaño no es positivo</translation>
    </message>
    <message>
        <source>no frame in it can be decoded</source>
        <translation>no se puede decodificar ningún fotograma</translation>
    </message>
    <message>
        <source>no headset software (OpenXR runtime) was found</source>
        <translation>no se encontró software de visor (runtime de OpenXR)</translation>
    </message>
    <message>
        <source>no layer of it holds strokes</source>
        <translation>ninguna de sus capas contiene trazos</translation>
    </message>
    <message>
        <source>no stack of it is visible</source>
        <translation>ninguna de sus pilas es visible</translation>
    </message>
    <message>
        <source>the boundary strokes enclose nothing on the proxy</source>
        <translation>los trazos de borde no encierran nada en el proxy</translation>
    </message>
    <message>
        <source>the clipboard holds no strokes</source>
        <translation>el portapapeles no contiene trazos</translation>
    </message>
    <message>
        <source>the disk gives back other bytes than were written</source>
        <translation>el disco devuelve otros bytes que los escritos</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>el archivo es de solo lectura</translation>
    </message>
    <message>
        <source>the film has no frames</source>
        <translation>la película no tiene fotogramas</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>no se puede crear la carpeta</translation>
    </message>
    <message>
        <source>the grid would be too fine</source>
        <translation>la rejilla sería demasiado fina</translation>
    </message>
    <message>
        <source>the headset software stopped</source>
        <translation>el software del visor se detuvo</translation>
    </message>
    <message>
        <source>the layer has no such drawing</source>
        <translation>la capa no tiene ese dibujo</translation>
    </message>
    <message>
        <source>the layer is locked</source>
        <translation>la capa está bloqueada</translation>
    </message>
    <message>
        <source>the layers above colour it</source>
        <translation>las capas de encima lo colorean</translation>
    </message>
    <message>
        <source>the memory ran out</source>
        <translation>se agotó la memoria</translation>
    </message>
    <message>
        <source>the painting has no strokes</source>
        <translation>la pintura no tiene trazos</translation>
    </message>
    <message>
        <source>the painting would have too many vertices</source>
        <translation>la pintura tendría demasiados vértices</translation>
    </message>
    <message>
        <source>the pictures differ in size</source>
        <translation>las imágenes difieren en tamaño</translation>
    </message>
    <message>
        <source>the program does not start</source>
        <translation>el programa no se inicia</translation>
    </message>
    <message>
        <source>the program is not installed</source>
        <translation>el programa no está instalado</translation>
    </message>
    <message>
        <source>the project holds no filmed scene</source>
        <translation>el proyecto no contiene ninguna escena filmada</translation>
    </message>
    <message>
        <source>the project holds no finished surface</source>
        <translation>el proyecto no contiene ninguna superficie terminada</translation>
    </message>
    <message>
        <source>the project is not where it was saved</source>
        <translation>el proyecto no está donde se guardó</translation>
    </message>
    <message>
        <source>the scene stack stays above all others</source>
        <translation>la pila de escena queda sobre las demás</translation>
    </message>
    <message>
        <source>the size or the checksum does not match, the file is damaged</source>
        <translation>no coinciden el tamaño o la suma de comprobación, el archivo está dañado</translation>
    </message>
    <message>
        <source>the smooth surface does not end near the strokes</source>
        <translation>la superficie suave no termina cerca de los trazos</translation>
    </message>
    <message>
        <source>the stroke is not in the painting</source>
        <translation>el trazo no está en la pintura</translation>
    </message>
    <message>
        <source>there are no pictures in this folder</source>
        <translation>no hay imágenes en esta carpeta</translation>
    </message>
    <message>
        <source>there are too many of them</source>
        <translation>hay demasiados</translation>
    </message>
    <message>
        <source>there is already one in that frame</source>
        <translation>ya hay uno en ese fotograma</translation>
    </message>
    <message>
        <source>there is no video in it that can be decoded</source>
        <translation>no contiene ningún vídeo que se pueda decodificar</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>no hay memoria suficiente para este archivo</translation>
    </message>
    <message>
        <source>there is not enough memory to write the project</source>
        <translation>no hay memoria suficiente para escribir el proyecto</translation>
    </message>
    <message>
        <source>this field is missing</source>
        <translation>falta este campo</translation>
    </message>
    <message>
        <source>this is a container of another kind, not a Ductus project</source>
        <translation>es un contenedor de otro tipo, no un proyecto de Ductus</translation>
    </message>
    <message>
        <source>this is not a Ductus project</source>
        <translation>no es un proyecto de Ductus</translation>
    </message>
    <message>
        <source>this is not a file</source>
        <translation>no es un archivo</translation>
    </message>
    <message>
        <source>this is not valid JSON</source>
        <translation>no es JSON válido</translation>
    </message>
    <message>
        <source>this picture cannot be decoded</source>
        <translation>no se puede decodificar esta imagen</translation>
    </message>
</context>
<context>
    <name>ductus::FoldingSection</name>
    <message>
        <source>%1, folded</source>
        <translation>%1, plegado</translation>
    </message>
    <message>
        <source>%1, unfolded</source>
        <translation>%1, desplegado</translation>
    </message>
</context>
<context>
    <name>ductus::HelpWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>The manual is missing in this installation: %1.</source>
        <translation>Falta el manual en esta instalación: %1.</translation>
    </message>
</context>
<context>
    <name>ductus::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>Inspector</translation>
    </message>
</context>
<context>
    <name>ductus::JobChip</name>
    <message>
        <source>Running jobs</source>
        <translation>Tareas en curso</translation>
    </message>
    <message>
        <source>What is being worked on. Click for the list.</source>
        <translation>En qué se está trabajando. Haga clic para ver la lista.</translation>
    </message>
    <message>
        <source>Cancel job</source>
        <translation>Cancelar la tarea</translation>
    </message>
    <message>
        <source>Stop this job; what was there before stays.</source>
        <translation>Detiene esta tarea; lo que había antes se conserva.</translation>
    </message>
</context>
<context>
    <name>ductus::JobPopup</name>
    <message>
        <source>Nothing is running.</source>
        <translation>No hay nada en curso.</translation>
    </message>
    <message>
        <source>Running jobs</source>
        <translation>Tareas en curso</translation>
    </message>
</context>
<context>
    <name>ductus::JobRow</name>
    <message>
        <source>Stop this job; what was there before stays.</source>
        <translation>Detiene esta tarea; lo que había antes se conserva.</translation>
    </message>
    <message>
        <source>Cancel %1</source>
        <translation>Cancelar: %1</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Deteniendo</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>En espera</translation>
    </message>
</context>
<context>
    <name>ductus::JobWords</name>
    <message>
        <source>a few seconds</source>
        <translation>unos segundos</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>unos %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>unos %1 min</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation>unas %1 h</translation>
    </message>
    <message>
        <source>Stopping: %1</source>
        <translation>Deteniendo: %1</translation>
    </message>
    <message>
        <source>Waiting: %1</source>
        <translation>En espera: %1</translation>
    </message>
</context>
<context>
    <name>ductus::MainWindowShell</name>
    <message>
        <source>View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>&amp;Inspector</source>
        <translation>&amp;Inspector</translation>
    </message>
    <message>
        <source>Shows or hides the column at the right.</source>
        <translation>Muestra u oculta la columna de la derecha.</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Historial</translation>
    </message>
    <message>
        <source>Lists all edits; a click goes back to one.</source>
        <translation>Lista todas las ediciones; un clic vuelve a una de ellas.</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Pantalla completa</translation>
    </message>
    <message>
        <source>Leaves everything but this window away.</source>
        <translation>Deja solo esta ventana en la pantalla.</translation>
    </message>
    <message>
        <source>Theme as the &amp;system</source>
        <translation>&amp;Tema del sistema</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>Tema &amp;oscuro</translation>
    </message>
    <message>
        <source>&amp;Light theme</source>
        <translation>Tema &amp;claro</translation>
    </message>
    <message>
        <source>Changes the colours of this app, not of your work.</source>
        <translation>Cambia los colores de la aplicación, no los de su trabajo.</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>&amp;Preferencias...</translation>
    </message>
    <message>
        <source>Theme, keys, tablet.</source>
        <translation>Tema, atajos de teclado, tableta.</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>&amp;Search actions...</source>
        <translation>&amp;Buscar acciones...</translation>
    </message>
    <message>
        <source>Type what you want to do; Enter does it.</source>
        <translation>Escriba lo que desea hacer; Intro lo ejecuta.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manual</translation>
    </message>
    <message>
        <source>Opens the manual at what you are working with.</source>
        <translation>Abre el manual por lo que está haciendo.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Closes this window; asks before anything is lost.</source>
        <translation>Cierra esta ventana; pregunta antes de que se pierda algo.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Takes the last edit back.</source>
        <translation>Revierte la última edición.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Does again what was taken back.</source>
        <translation>Repite lo que se deshizo.</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>Ar&amp;chivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Ayuda</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apariencia</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Atajos</translation>
    </message>
    <message>
        <source>Tablet</source>
        <translation>Tableta</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>¿Guardar los cambios de «%1»?</translation>
    </message>
    <message>
        <source>Without saving, what you did since the last save is lost.</source>
        <translation>Si no guarda, se perderá lo hecho desde la última vez.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>&amp;Discard changes</source>
        <translation>&amp;Descartar los cambios</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (solo lectura)</translation>
    </message>
</context>
<context>
    <name>ductus::MessageBar</name>
    <message>
        <source>%1 failed: %2%3.</source>
        <translation>%1: error, %2%3.</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>Close message</source>
        <translation>Cerrar el mensaje</translation>
    </message>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Cerrar este mensaje (Esc)</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n más</numerusform>
            <numerusform>%n más</numerusform>
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
        <translation>Curva de presión</translation>
    </message>
    <message>
        <source>Left and right choose a point, Ctrl with the arrow keys moves it.</source>
        <translation>Izquierda y derecha eligen un punto; Ctrl con las flechas lo mueve.</translation>
    </message>
    <message>
        <source>Drag the points. Left: a light touch, right: pressed hard; up: counts more.</source>
        <translation>Arrastre los puntos. Izquierda: presión ligera; derecha: fuerte; arriba: cuenta más.</translation>
    </message>
</context>
<context>
    <name>ductus::PressureTestField</name>
    <message>
        <source>Test field for the pen</source>
        <translation>Zona de prueba del lápiz</translation>
    </message>
    <message>
        <source>Draw here with your pen to try the curve.</source>
        <translation>Dibuje aquí con el lápiz para probar la curva.</translation>
    </message>
</context>
<context>
    <name>ductus::RecentRow</name>
    <message>
        <source>%1, missing</source>
        <translation>%1, no se encuentra</translation>
    </message>
    <message>
        <source>not there any more</source>
        <translation>ya no está</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Abrir</translation>
    </message>
    <message>
        <source>&amp;Take off this list</source>
        <translation>&amp;Quitar de esta lista</translation>
    </message>
</context>
<context>
    <name>ductus::RecoveryNotice</name>
    <message>
        <source>Today %1</source>
        <translation>Hoy %1</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Trabajo sin guardar</translation>
    </message>
    <message>
        <source>Unsaved work from last time</source>
        <translation>Trabajo sin guardar de la última vez</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Open the unsaved %1</source>
        <translation>Abrir %1 sin guardar</translation>
    </message>
    <message>
        <source>Discard the unsaved %1</source>
        <translation>Descartar %1 sin guardar</translation>
    </message>
</context>
<context>
    <name>ductus::SampleWords</name>
    <message>
        <source>Saloon car</source>
        <translation>Berlina</translation>
    </message>
    <message>
        <source>Symmetric sketch with sharp shoulder, pillars and detail strokes: half is solved and mirrored.</source>
        <translation>Boceto simétrico con hombro marcado, montantes y trazos de detalle: se calcula una mitad y se refleja.</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>Botella</translation>
    </message>
    <message>
        <source>Round shapes with sharp rings: a crease at the shoulder, none along the meridians.</source>
        <translation>Formas redondas con anillos marcados: un pliegue en el hombro, ninguno en los meridianos.</translation>
    </message>
    <message>
        <source>Box with a bevel</source>
        <translation>Caja biselada</translation>
    </message>
    <message>
        <source>Flat faces meet in straight edges although every stroke is a little off.</source>
        <translation>Las caras planas se unen en aristas rectas aunque cada trazo se desvíe un poco.</translation>
    </message>
    <message>
        <source>Folded leaf</source>
        <translation>Hoja doblada</translation>
    </message>
    <message>
        <source>An open shell: boundary strokes say where the surface ends, the midrib is a fold.</source>
        <translation>Una lámina abierta: los trazos de borde dicen dónde acaba la superficie; el nervio es un pliegue.</translation>
    </message>
    <message>
        <source>Computer mouse</source>
        <translation>Ratón de ordenador</translation>
    </message>
    <message>
        <source>A smooth dome with a sharp belt: detail strokes lie on the surface and bend nothing.</source>
        <translation>Una cúpula suave con cinturón marcado: los trazos de detalle están en la superficie y no deforman nada.</translation>
    </message>
    <message>
        <source>Table lamp</source>
        <translation>Lámpara de mesa</translation>
    </message>
    <message>
        <source>Thick and thin parts in one sketch: the stem needs a tight proxy.</source>
        <translation>Partes gruesas y finas en un boceto: el pie necesita un proxy ceñido.</translation>
    </message>
    <message>
        <source>Iron with a handle</source>
        <translation>Plancha con asa</translation>
    </message>
    <message>
        <source>A closed surface with a hole: the proxy must find the way through the handle.</source>
        <translation>Una superficie cerrada con un agujero: el proxy debe hallar el paso por el asa.</translation>
    </message>
    <message>
        <source>Forest path</source>
        <translation>Sendero del bosque</translation>
    </message>
    <message>
        <source>Two looks, day and dawn: light is a layer of strokes, mist a gradient.</source>
        <translation>Dos ambientes, día y alba: la luz es una capa de trazos; la niebla, un degradado.</translation>
    </message>
    <message>
        <source>Over the clouds</source>
        <translation>Sobre las nubes</translation>
    </message>
    <message>
        <source>Shadows are copies of strokes with tolerance; plane and shadow move as one.</source>
        <translation>Las sombras son copias de trazos con tolerancia; avión y sombra se mueven juntos.</translation>
    </message>
    <message>
        <source>Desk by day and night</source>
        <translation>Escritorio de día y de noche</translation>
    </message>
    <message>
        <source>A sunbeam through the window, a lamp for the night: one scene, two looks.</source>
        <translation>Un rayo de sol por la ventana, una lámpara para la noche: una escena, dos ambientes.</translation>
    </message>
    <message>
        <source>Passing box</source>
        <translation>Caja que pasa</translation>
    </message>
    <message>
        <source>A face follows the box behind the post; words and arrow stay in the room.</source>
        <translation>Una cara sigue a la caja tras el poste; texto y flecha se quedan en la sala.</translation>
    </message>
    <message>
        <source>Walk through the room</source>
        <translation>Paseo por la sala</translation>
    </message>
    <message>
        <source>Labels and stickers keep their place in the room while the camera walks in.</source>
        <translation>Rótulos y pegatinas mantienen su sitio mientras la cámara avanza.</translation>
    </message>
    <message>
        <source>One vase, three glazes</source>
        <translation>Un jarrón, tres esmaltes</translation>
    </message>
    <message>
        <source>Ornament is painted once; looks give every layer another colour.</source>
        <translation>El adorno se pinta una vez; los ambientes dan otro color a cada capa.</translation>
    </message>
    <message>
        <source>Campfire</source>
        <translation>Hoguera</translation>
    </message>
    <message>
        <source>Flames are five drawings shown in turn; night and firelight are gradients.</source>
        <translation>Las llamas son cinco dibujos por turno; la noche y el resplandor son degradados.</translation>
    </message>
    <message>
        <source>Lighthouse</source>
        <translation>Faro</translation>
    </message>
    <message>
        <source>Noise makes foam and crests, the beam is clear paint that turns.</source>
        <translation>El ruido hace la espuma y las crestas; el haz es pintura clara que gira.</translation>
    </message>
    <message>
        <source>Koi pond</source>
        <translation>Estanque de kois</translation>
    </message>
    <message>
        <source>Spots reach no further than the fish they touch; shadows swim along.</source>
        <translation>Las manchas no pasan del pez que tocan; las sombras nadan con él.</translation>
    </message>
    <message>
        <source>Pendulum</source>
        <translation>Péndulo</translation>
    </message>
    <message>
        <source>A still camera; the arrow rides on the bob and is drawn anew twelve times a swing.</source>
        <translation>Cámara quieta; la flecha va sobre la pesa y se dibuja de nuevo doce veces por oscilación.</translation>
    </message>
    <message>
        <source>Chalk in the yard</source>
        <translation>Tiza en el patio</translation>
    </message>
    <message>
        <source>Canvases lie on the ground and on the wall and keep their perspective as the camera goes by.</source>
        <translation>Hay lienzos en el suelo y en la pared que mantienen su perspectiva al pasar la cámara.</translation>
    </message>
    <message>
        <source>A ghost in the store</source>
        <translation>Un fantasma en el almacén</translation>
    </message>
    <message>
        <source>Six drawings in a loop; keyframes carry them around the post and behind the boxes.</source>
        <translation>Seis dibujos en bucle; los fotogramas clave los llevan alrededor del poste y tras las cajas.</translation>
    </message>
    <message>
        <source>Over the hills</source>
        <translation>Sobre las colinas</translation>
    </message>
    <message>
        <source>The camera only turns: birds fly by keyframes, one of them behind the house.</source>
        <translation>La cámara solo gira: los pájaros vuelan por fotogramas clave, uno de ellos tras la casa.</translation>
    </message>
</context>
<context>
    <name>ductus::SegmentedSwitch</name>
    <message>
        <source>Hold the key to peek.</source>
        <translation>Mantenga la tecla para echar un vistazo.</translation>
    </message>
</context>
<context>
    <name>ductus::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>ductus::ShortcutsPage</name>
    <message>
        <source>&amp;Use it here instead</source>
        <translation>&amp;Usarlo aquí</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Predeterminado</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Ninguno</translation>
    </message>
    <message>
        <source>Filter by name or keys</source>
        <translation>Filtrar por nombre o teclas</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>Acciones y sus atajos</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Atajo</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Nuevo atajo</translation>
    </message>
    <message>
        <source>Click here and press the new keys.</source>
        <translation>Haga clic aquí y pulse las nuevas teclas.</translation>
    </message>
    <message>
        <source>Conflict</source>
        <translation>Conflicto</translation>
    </message>
    <message>
        <source>Default keys</source>
        <translation>Atajo predeterminado</translation>
    </message>
    <message>
        <source>No keys</source>
        <translation>Sin atajo</translation>
    </message>
    <message>
        <source>Use it here instead</source>
        <translation>Usarlo aquí</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Atajo</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Otras</translation>
    </message>
    <message>
        <source>%1 is taken by: %2.</source>
        <translation>%1 ya lo usa: %2.</translation>
    </message>
</context>
<context>
    <name>ductus::StartPage</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Archivos recientes</translation>
    </message>
    <message>
        <source>Or drop a file anywhere in this window.</source>
        <translation>O suelte un archivo en cualquier lugar de esta ventana.</translation>
    </message>
    <message>
        <source>Files you open will be listed here.</source>
        <translation>Aquí aparecerán los archivos que abra.</translation>
    </message>
</context>
<context>
    <name>ductus::TabletPage</name>
    <message>
        <source>&amp;Straight line</source>
        <translation>&amp;Línea recta</translation>
    </message>
    <message>
        <source>&amp;Clean field</source>
        <translation>Limpiar la &amp;zona</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Presión</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Probar</translation>
    </message>
    <message>
        <source>Raise the left part if you press lightly, lower it if you press hard. The other end of the pen erases.</source>
        <translation>Suba la parte izquierda si presiona poco; bájela si presiona mucho. El otro extremo del lápiz borra.</translation>
    </message>
    <message>
        <source>Straight line</source>
        <translation>Línea recta</translation>
    </message>
    <message>
        <source>Clean field</source>
        <translation>Limpiar la zona</translation>
    </message>
</context>
<context>
    <name>ductus::ToolRail</name>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
</context>
<context>
    <name>ductus::TopRow</name>
    <message>
        <source>Menu</source>
        <translation>Menú</translation>
    </message>
    <message>
        <source>All menus</source>
        <translation>Todos los menús</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Buscar acciones</translation>
    </message>
</context>
<context>
    <name>ductus::UndoPanel</name>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Close history</source>
        <translation>Cerrar el historial</translation>
    </message>
    <message>
        <source>Close the history</source>
        <translation>Cerrar el historial</translation>
    </message>
    <message>
        <source>History of edits</source>
        <translation>Historial de ediciones</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Como se abrió</translation>
    </message>
</context>
<context>
    <name>ductus::UnsavedWork</name>
    <message>
        <source>Looking for unsaved work</source>
        <translation>Búsqueda de trabajo sin guardar</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Apertura de %1</translation>
    </message>
</context>
</TS>
