<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
<name>EdgeScan</name>
<message><source>CONNECTING</source><translation>CONECTANDO</translation></message>
<message><source>LIVE</source><translation>EN VIVO</translation></message>
<message><source>STALE</source><translation>ANTICUADO</translation></message>
<message><source>STALE %1</source><translation>ANTICUADO %1</translation></message>
<message><source>NOT CONNECTED</source><translation>SIN CONEXIÓN</translation></message>
<message><source>LOST %1</source><translation>PERDIDO %1</translation></message>
<message><source>STOPPED</source><translation>DETENIDO</translation></message>
<message><source>STOPPED %1</source><translation>DETENIDO %1</translation></message>
<message><source>%1, COUNTERS IN DOUBT</source><translation>%1, CONTADORES DUDOSOS</translation></message>
<message><source>INCOMPLETE %1 lines</source><translation>INCOMPLETO %1 líneas</translation></message>
<message><source>%1 lost: %2</source><translation>%1 perdidas: %2</translation></message>
<message><source>%1 lines</source><translation>%1 líneas</translation></message>
<message><source>no return %1 %</source><translation>sin retorno %1 %</translation></message>
<message><source>COUNTERS IN DOUBT</source><translation>CONTADORES DUDOSOS</translation></message>
<message><source>MOUNTING ASSUMED</source><translation>MONTAJE SUPUESTO</translation></message>
<message><source>MOUNTING FROM RANGES</source><translation>MONTAJE SEGÚN DISTANCIAS</translation></message>
<message><source>FIRST ANGLE ASSUMED</source><translation>PRIMER ÁNGULO SUPUESTO</translation></message>
<message><source>STEP ASSUMED %1°</source><translation>PASO SUPUESTO %1°</translation></message>
<message><source>START ASSUMED</source><translation>INICIO SUPUESTO</translation></message>
<message><source>1 remark</source><translation>1 observación</translation></message>
<message><source>%1 remarks</source><translation>%1 observaciones</translation></message>
<message><source>%1 earlier in this sweep</source><translation>%1 antes en este barrido</translation></message>
<message><source>WINDOW TOO DIRTY</source><translation>VENTANA DEMASIADO SUCIA</translation></message>
<message><source>WINDOW DIRTY</source><translation>VENTANA SUCIA</translation></message>
<message><source>DEVICE ERROR</source><translation>ERROR DEL EQUIPO</translation></message>
<message><source>pose %1 old</source><translation>pose de hace %1</translation></message>
<message><source>%1 left</source><translation>faltan %1</translation></message>
<message><source>%1, %2 ago</source><translation>%1, hace %2</translation></message>
<message><source>recording %1 MB, %2</source><translation>grabación %1 MB, %2</translation></message>
<message><source>recording %1 MB</source><translation>grabación %1 MB</translation></message>
<message><source>RECORDING ENDED: %1</source><translation>GRABACIÓN TERMINADA: %1</translation></message>
<message><source>RECORDING HAS GAPS: %1</source><translation>LA GRABACIÓN TIENE HUECOS: %1</translation></message>
<message><source>%1; other cells: points of one moved to the grid of the other</source><translation>%1; otras celdas: puntos de uno llevados a la cuadrícula del otro</translation></message>
<message><source>one scan with two settings</source><translation>un escaneo con dos ajustes</translation></message>
<message><source>lined up by their poses</source><translation>alineados por sus poses</translation></message>
<message><source>lined up by given positions of the scanner, not in the mine grid</source><translation>alineados por posiciones dadas del escáner, no en la cuadrícula de la mina</translation></message>
<message><source>no pose: lined up by their surfaces</source><translation>sin pose: alineados por sus superficies</translation></message>
<message><source>not resolved</source><translation>no resuelto</translation></message>
<message><source>sweep %1</source><translation>barrido %1</translation></message>
<message><source>demo draw-bell after the blast</source><translation>campana de demostración tras la tronadura</translation></message>
<message><source>demo draw-bell</source><translation>campana de demostración</translation></message>
<message><source>there is not enough memory for this scan</source><translation>no hay memoria suficiente para este escaneo</translation></message>
<message><source>close other programs or open a smaller scan</source><translation>cierre otros programas o abra un escaneo más pequeño</translation></message>
<message><source>there is not enough memory to show the scan in its place</source><translation>no hay memoria suficiente para mostrar el escaneo en su lugar</translation></message>
<message><source>there is not enough memory for this layer</source><translation>no hay memoria suficiente para esta capa</translation></message>
<message><source>there is not enough memory for a second picture</source><translation>no hay memoria suficiente para una segunda imagen</translation></message>
<message><source>there is not enough memory for a second scan</source><translation>no hay memoria suficiente para un segundo escaneo</translation></message>
<message><source>there is not enough memory for these scans</source><translation>no hay memoria suficiente para estos escaneos</translation></message>
<message><source>there is not enough memory to play this recording</source><translation>no hay memoria suficiente para reproducir esta grabación</translation></message>
<message><source>hide or remove other layers, or choose a smaller scan</source><translation>oculte o quite otras capas, o elija un escaneo más pequeño</translation></message>
<message><source>close other programs or choose a smaller scan</source><translation>cierre otros programas o elija un escaneo más pequeño</translation></message>
<message><source>close other programs or choose a smaller one</source><translation>cierre otros programas o elija uno más pequeño</translation></message>
<message><source>close other programs or use fewer scans</source><translation>cierre otros programas o use menos escaneos</translation></message>
<message><source>close other programs or use a smaller scan</source><translation>cierre otros programas o use un escaneo más pequeño</translation></message>
<message><source>another program has changed this file, so it was not removed</source><translation>otro programa cambió este archivo, así que no se quitó</translation></message>
<message><source>open the scan again to see its edits</source><translation>abra el escaneo de nuevo para ver sus cambios</translation></message>
<message><source>it could not be opened (%1)</source><translation>no se pudo abrir (%1)</translation></message>
<message><source>auto is not a number</source><translation>auto no es un número</translation></message>
<message><source>tick auto next to the box</source><translation>marque auto junto al campo</translation></message>
<message><source>the layer has another content than when it was placed</source><translation>la capa tiene otro contenido que cuando se colocó</translation></message>
<message><source>remove it and add it again</source><translation>quítela y añádala de nuevo</translation></message>
<message><source>it is not a regular file, so settings are not read and nothing of this window is stored</source><translation>no es un archivo normal: los ajustes no se leen y nada de esta ventana se guarda</translation></message>
<message><source>remove it and start again</source><translation>elimínelo e inicie de nuevo</translation></message>
<message><source>not all settings in this file can be read</source><translation>no todos los ajustes de este archivo se pueden leer</translation></message>
<message><source>what it held is in </source><translation>lo que contenía está en </translation></message>
<message><source>choose another scan</source><translation>elija otro escaneo</translation></message>
<message><source> (line </source><translation> (línea </translation></message>
<message><source>Both are one scan: the files are the same.</source><translation>Ambos son un solo escaneo: los archivos son iguales.</translation></message>
<message><source>Near and far leave no depth between them: the gray image is blank and has no edge.</source><translation>Cerca y lejos no dejan profundidad entre ellos: la imagen gris está vacía y no tiene bordes.</translation></message>
<message><source> edge cells lie on filled ranges and are not in this file; %1 writes them.</source><translation> celdas de borde están en distancias rellenadas y no están en este archivo; %1 las escribe.</translation></message>
<message><source>OUT OF SPEC: whether the surfaces of "%1" fit cannot be seen.</source><translation>FUERA DE TOLERANCIA: no se puede ver si las superficies de "%1" encajan.</translation></message>
<message><source>OUT OF SPEC: the surfaces of "%1" are %2 mm from those of the first scan at best.</source><translation>FUERA DE TOLERANCIA: las superficies de "%1" están en el mejor caso a %2 mm de las del primer escaneo.</translation></message>
<message><source>OUT OF SPEC: the base moved while "%1" was taken: one place fits it badly.</source><translation>FUERA DE TOLERANCIA: la base se movió mientras se tomaba "%1": un solo lugar encaja mal.</translation></message>
<message><source>OUT OF SPEC: without a pose of both, the two scans are lined up by their surfaces alone.</source><translation>FUERA DE TOLERANCIA: sin pose de ambos, los dos escaneos se alinean solo por sus superficies.</translation></message>
<message><source>OUT OF SPEC: the surfaces of the two scans do not lie where their poses put them: %1 apart, and %2 if one is moved by </source><translation>FUERA DE TOLERANCIA: las superficies de los dos escaneos no están donde las ponen sus poses: a %1, y a %2 si uno se mueve </translation></message>
<message><source>OUT OF SPEC: the surfaces of the two scans lie %1 apart at best, so most of the place changed or they are not scans of one place. No areas of change are given.</source><translation>FUERA DE TOLERANCIA: las superficies de los dos escaneos están en el mejor caso a %1: casi todo cambió o no son escaneos de un mismo lugar. No se dan áreas de cambio.</translation></message>
<message><source>OUT OF SPEC: whether the poses fit cannot be seen, </source><translation>FUERA DE TOLERANCIA: no se puede ver si las poses encajan, </translation></message>
<message><source>OUT OF SPEC: the poses do not fit the surfaces, so the earlier scan was moved by its surfaces, by </source><translation>FUERA DE TOLERANCIA: las poses no encajan con las superficies, así que el escaneo anterior se movió por sus superficies, </translation></message>
<message><source>Scan &gt; Straighten Beams</source><translation>Escaneo &gt; Enderezar los haces</translation></message>
<message><source>Scan &gt; Keep Repeated Values</source><translation>Escaneo &gt; Conservar los valores repetidos</translation></message>
<message><source>the coordinates in the export dialog</source><translation>las coordenadas del diálogo de exportación</translation></message>
<message><source>the points behind others in the export dialog</source><translation>los puntos detrás de otros del diálogo de exportación</translation></message>
<message><source>the filled cells in the export dialog</source><translation>las celdas rellenadas del diálogo de exportación</translation></message>
<message><source>the comments in the export dialog</source><translation>los comentarios del diálogo de exportación</translation></message>
<message><source>the filling of gaps in the Edges panel</source><translation>el relleno de huecos del panel de aristas</translation></message>
<message><source>the outlines in the picture</source><translation>los contornos en la imagen</translation></message>
<message><source>“%1” in Scan &gt; How the Scan Is Read</source><translation>«%1» en Escaneo &gt; Cómo se lee el escaneo</translation></message>
<message><source>the angles of beams and lines and the axis in Scan &gt; How the Scan Is Read</source><translation>los ángulos de haces y líneas y el eje en Escaneo &gt; Cómo se lee el escaneo</translation></message>
<message><source>%1 to %2</source><translation>%1 a %2</translation></message>
<message><source>valid</source><translation>válida</translation></message>
<message><source>no return</source><translation>sin retorno</translation></message>
<message><source>device status</source><translation>estado del equipo</translation></message>
<message><source>out of window</source><translation>fuera de la ventana</translation></message>
<message><source>masked</source><translation>enmascaradas</translation></message>
<message><source>lost</source><translation>perdidas</translation></message>
<message><source>Scan &gt; Sweep… takes what is right.</source><translation>Escaneo &gt; Barrido… admite lo correcto.</translation></message>
<message><source>▲ mounting from the ranges</source><translation>▲ montaje según las distancias</translation></message>
<message><source>▲ step assumed</source><translation>▲ paso supuesto</translation></message>
<message><source>▲ mounting assumed</source><translation>▲ montaje supuesto</translation></message>
<message><source>1 target</source><translation>1 objetivo</translation></message>
<message><source>%1 targets</source><translation>%1 objetivos</translation></message>
<message><source>1 rock</source><translation>1 roca</translation></message>
<message><source>%1 rocks</source><translation>%1 rocas</translation></message>
<message><source>Fold this panel to the edge of the window</source><translation>Plegar este panel al costado de la ventana</translation></message>
<message><source>Folded panels</source><translation>Paneles plegados</translation></message>
<message><source>Open %1</source><translation>Abrir %1</translation></message>
<message><source>Open folder</source><translation>Abrir la carpeta</translation></message>
<message><source>Details</source><translation>Detalles</translation></message>
<message><source>Copy</source><translation>Copiar</translation></message>
<message><source>Close</source><translation>Cerrar</translation></message>
<message><source>Shows the next of the notes that were not closed</source><translation>Muestra la siguiente de las notas que no se cerraron</translation></message>
<message><source>Error</source><translation>Error</translation></message>
<message><source>Note</source><translation>Nota</translation></message>
<message><source>Done</source><translation>Listo</translation></message>
<message><source>%1 of %2</source><translation>%1 de %2</translation></message>
<message><source>%1 MB</source><translation>%1 MB</translation></message>
<message><source>%1 kB</source><translation>%1 kB</translation></message>
<message><source>Saved %1%2, %3.</source><translation>Guardado %1%2, %3.</translation></message>
<message><source>Open</source><translation>Abrir</translation></message>
<message><source>No program of this computer opened %1.</source><translation>Ningún programa de este equipo abrió %1.</translation></message>
<message><source>Undo</source><translation>Deshacer</translation></message>
<message><source>Removed: %1.</source><translation>Quitado: %1.</translation></message>
<message><source>Done again: %1.</source><translation>Rehecho: %1.</translation></message>
<message><source>Undone: %1.</source><translation>Deshecho: %1.</translation></message>
<message><source>It is back.</source><translation>Está de nuevo.</translation></message>
<message><source>Redo</source><translation>Rehacer</translation></message>
<message><source>Double-click: in exchange for the cloud, and back</source><translation>Doble clic: en lugar de la nube, y de vuelta</translation></message>
<message><source>All views again</source><translation>Todas las vistas de nuevo</translation></message>
<message><source>This view alone</source><translation>Esta vista sola</translation></message>
<message><source>Replace the file?</source><translation>¿Reemplazar el archivo?</translation></message>
<message><source>There is a file of this name already:</source><translation>Ya existe un archivo con este nombre:</translation></message>
<message><source>There are files of these names already:</source><translation>Ya existen archivos con estos nombres:</translation></message>
<message><source>Replace</source><translation>Reemplazar</translation></message>
<message><source>... and %1 lines more</source><translation>... y %1 líneas más</translation></message>
<message><source>&amp;Night</source><translation>&amp;Noche</translation></message>
<message><source>&amp;Day</source><translation>&amp;Día</translation></message>
<message><source>&amp;Control-Room Gray</source><translation>&amp;Gris de sala de control</translation></message>
<message><source>right-click &gt; hold a finger on | clicked &gt; tapped | clicks &gt; taps | click &gt; tap</source><translation>haga clic derecho en &gt; mantenga el dedo en | haga clic en ella &gt; tóquela | haga clic en &gt; toque | haga clic &gt; toque | hacer clic en &gt; tocar | en la que hizo clic &gt; que tocó | clics &gt; toques | clic &gt; toque</translation></message>
<message><source>OK</source><translation>Aceptar</translation></message>
<message><source>Save</source><translation>Guardar</translation></message>
<message><source>&amp;Yes</source><translation>&amp;Sí</translation></message>
<message><source>&amp;No</source><translation>&amp;No</translation></message>
<message><source>Apply</source><translation>Aplicar</translation></message>
<message><source>Cu&amp;t</source><translation>Cor&amp;tar</translation></message>
<message><source>&amp;Copy</source><translation>&amp;Copiar</translation></message>
<message><source>&amp;Paste</source><translation>&amp;Pegar</translation></message>
<message><source>Select All</source><translation>Seleccionar todo</translation></message>
<message><source>Discard</source><translation>Descartar</translation></message>
<message><source>Delete</source><translation>Eliminar</translation></message>
<message><source>&amp;Step up</source><translation>&amp;Aumentar</translation></message>
<message><source>Step &amp;down</source><translation>&amp;Disminuir</translation></message>
<message><source>Copy &amp;Link Location</source><translation>Copiar la dirección del en&amp;lace</translation></message>
<message><source>Float</source><translation>Separar</translation></message>
<message><source>Shift</source><translation>Mayús</translation></message>
<message><source>Del</source><translation>Supr</translation></message>
<message><source>PgUp</source><translation>RePág</translation></message>
<message><source>PgDown</source><translation>AvPág</translation></message>
<message><source>Cancel</source><translation>Cancelar</translation></message>
<message><source>Look in:</source><translation>Buscar en:</translation></message>
<message><source>Back</source><translation>Atrás</translation></message>
<message><source>Forward</source><translation>Adelante</translation></message>
<message><source>Go back</source><translation>Retroceder</translation></message>
<message><source>Go forward</source><translation>Ir adelante</translation></message>
<message><source>Parent Directory</source><translation>Carpeta superior</translation></message>
<message><source>Go to the parent directory</source><translation>Ir a la carpeta superior</translation></message>
<message><source>Create New Folder</source><translation>Crear carpeta</translation></message>
<message><source>Create a New Folder</source><translation>Crear una carpeta nueva</translation></message>
<message><source>List View</source><translation>Vista de lista</translation></message>
<message><source>Change to list view mode</source><translation>Cambiar a la vista de lista</translation></message>
<message><source>Detail View</source><translation>Vista detallada</translation></message>
<message><source>Change to detail view mode</source><translation>Cambiar a la vista detallada</translation></message>
<message><source>Sidebar</source><translation>Barra lateral</translation></message>
<message><source>List of places and bookmarks</source><translation>Lista de lugares y marcadores</translation></message>
<message><source>Files</source><translation>Archivos</translation></message>
<message><source>File &amp;name:</source><translation>&amp;Nombre del archivo:</translation></message>
<message><source>Files of type:</source><translation>Tipo de archivos:</translation></message>
<message><source>Directory:</source><translation>Carpeta:</translation></message>
<message><source>&amp;Open</source><translation>&amp;Abrir</translation></message>
<message><source>&amp;Save</source><translation>&amp;Guardar</translation></message>
<message><source>&amp;Choose</source><translation>&amp;Elegir</translation></message>
<message><source>&amp;Rename</source><translation>&amp;Cambiar nombre</translation></message>
<message><source>&amp;Delete</source><translation>&amp;Eliminar</translation></message>
<message><source>Show &amp;hidden files</source><translation>Mostrar archivos &amp;ocultos</translation></message>
<message><source>&amp;New Folder</source><translation>Carpeta &amp;nueva</translation></message>
<message><source>Name</source><translation>Nombre</translation></message>
<message><source>Size</source><translation>Tamaño</translation></message>
<message><source>Type</source><translation>Tipo</translation></message>
<message><source>Date Modified</source><translation>Modificado</translation></message>
<message><source>Computer</source><translation>Equipo</translation></message>
<message><source>Drive</source><translation>Unidad</translation></message>
<message><source>All Files (*)</source><translation>Todos los archivos (*)</translation></message>
<message><source>Show </source><translation>Mostrar </translation></message>
<message><source>Scroll Left</source><translation>Desplazar a la izquierda</translation></message>
<message><source>Scroll Right</source><translation>Desplazar a la derecha</translation></message>
<message><source>▲ AUDIT LOG: %1</source><translation>▲ REGISTRO DE AUDITORÍA: %1</translation></message>
<message><source>The audit log is written again; no line is missing.</source><translation>El registro de auditoría se escribe de nuevo; no falta ninguna línea.</translation></message>
<message><source>▲ AUDIT LOG: what is done is not noted (%1)</source><translation>▲ REGISTRO DE AUDITORÍA: lo que se hace no se anota (%1)</translation></message>
<message><source>The two pictures could not be compared (%1); keep a smaller scan.</source><translation>No se pudieron comparar las dos imágenes (%1); conserve un escaneo más pequeño.</translation></message>
<message><source>There is no picture to keep yet: open a scan first.</source><translation>Todavía no hay imagen que conservar: abra primero un escaneo.</translation></message>
<message><source>Keep as A</source><translation>Guardar como A</translation></message>
<message><source>Forget A</source><translation>Olvidar A</translation></message>
<message><source>The comparison ended: B, %1, is on the screen.</source><translation>La comparación terminó: B, %1, está en la pantalla.</translation></message>
<message><source>Open A</source><translation>Abrir A</translation></message>
<message><source>The comparison ended: A was forgotten.</source><translation>La comparación terminó: se olvidó A.</translation></message>
<message><source>A was forgotten: the demo and %1 are not of one place.</source><translation>Se olvidó A: la demo y %1 no son de un mismo lugar.</translation></message>
<message><source>The comparison ended, because another scan was opened.</source><translation>La comparación terminó porque se abrió otro escaneo.</translation></message>
<message><source>There is nothing to compare with it yet: open the later scan first.</source><translation>Todavía no hay nada con qué compararla: abra primero el escaneo posterior.</translation></message>
<message><source>Reading %1 as A</source><translation>Leyendo %1 como A</translation></message>
<message><source>the demo</source><translation>la demo</translation></message>
<message><source>Cancelled; what was on the screen stays.</source><translation>Cancelado; lo que estaba en pantalla se queda.</translation></message>
<message><source>Choose the earlier scan, A; the scan on the screen is the later one, B</source><translation>Elija el escaneo anterior, A; el de la pantalla es el posterior, B</translation></message>
<message><source>A and B are exchanged when both are files: keep a scan as A and open another one.</source><translation>A y B se intercambian si ambos son archivos: conserve un escaneo como A y abra otro.</translation></message>
<message><source>A was not restored: %1 has changed since.</source><translation>A no se recuperó: el contenido de %1 cambió desde entonces.</translation></message>
<message><source>Compare with Earlier Scan</source><translation>Comparar con un escaneo anterior</translation></message>
<message><source>Comparing with A</source><translation>Comparando con A</translation></message>
<message><source>Line Up by Surfaces</source><translation>Alinear por las superficies</translation></message>
<message><source>gained, lost and kept</source><translation>ganados, perdidos y conservados</translation></message>
<message><source>A and what is on the screen are the same, or are still being compared.</source><translation>A y la pantalla son iguales, o aún se están comparando.</translation></message>
<message><source>Nothing is kept as A yet: Edges &gt; Compare A/B &gt; Keep This as A.</source><translation>Todavía no hay nada conservado como A: Bordes &gt; Comparar A/B &gt; Conservar esto como A.</translation></message>
<message><source>The surfaces of the two scans do not fit, so no areas of change are given.</source><translation>Las superficies de los dos escaneos no encajan, así que no se dan áreas de cambio.</translation></message>
<message><source>No surface came nearer or went farther: keep a scan as A and open another one.</source><translation>Ninguna superficie se acercó ni se alejó: conserve un escaneo como A y abra otro.</translation></message>
<message><source>region %1 of %2, the largest by area: %3 by %4 m ± %5 m,
now at %7 m; %6 m² at the nearer surface, without its border of one cell</source><translation>región %1 de %2, la mayor en área: %3 por %4 m ± %5 m,
ahora a %7 m; %6 m² en la superficie más cercana, sin su borde de una celda</translation></message>
<message><source>region %1 of %2: %3 by %4 m ± %5 m,
now at %7 m; %6 m² at the nearer surface, without its border of one cell</source><translation>región %1 de %2: %3 en %4 m ± %5 m,
ahora a %7 m; %6 m² en la superficie más cercana, sin su borde de una celda</translation></message>
<message><source>farther</source><translation>más lejos</translation></message>
<message><source>nearer</source><translation>más cerca</translation></message>
<message><source>when the sweep has ended</source><translation>cuando termine el barrido</translation></message>
<message><source>could not be computed:
%1</source><translation>no se pudo calcular:
%1</translation></message>
<message><source>by confidence</source><translation>por confianza</translation></message>
<message><source>Its strength is %1. An edge reaches the Edge strength %2 at one place, and %3 along the rest.</source><translation>Su fuerza es %1. Un borde alcanza la Fuerza del borde %2 en un lugar, y %3 en el resto.</translation></message>
<message><source>Its strength %1 is above the Edge strength %2.</source><translation>Su fuerza %1 supera la Fuerza del borde %2.</translation></message>
<message><source>Its strength %1 is below the Edge strength %2, but it continues an edge that reaches %3 at line %4, beam %5. Such a cell needs only %6.</source><translation>Su fuerza %1 es menor que la Fuerza del borde %2, pero continúa un borde que llega a %3 en la línea %4, haz %5. A una celda así le basta %6.</translation></message>
<message><source>This is an edge, but it is left out: only borders of rocks are shown.</source><translation>Es un borde, pero se omite: solo se muestran contornos de rocas.</translation></message>
<message><source>The surface changes here, but as much or more in the cell next to it, line %1, beam %2: an edge is one cell wide.</source><translation>La superficie cambia aquí, pero tanto o más en la celda vecina, línea %1, haz %2: un borde tiene una celda de ancho.</translation></message>
<message><source>In the direction of that cell their strengths are %1 and %2.</source><translation>En la dirección de esa celda sus fuerzas son %1 y %2.</translation></message>
<message><source>The surface changes too little here to be an edge.</source><translation>La superficie cambia demasiado poco aquí para ser un borde.</translation></message>
<message><source>The surface changes here, but no place of this change is strong enough for an edge.</source><translation>La superficie cambia aquí, pero ningún lugar de este cambio basta para un borde.</translation></message>
<message><source>The surface changes here, but this edge is shorter than the minimum length.</source><translation>La superficie cambia aquí, pero este borde es más corto que la longitud mínima.</translation></message>
<message><source>The surface changes here, but another cell of it is the edge.</source><translation>La superficie cambia aquí, pero otra celda de ese cambio es el borde.</translation></message>
<message><source>Nothing was measured here.</source><translation>Aquí no se midió nada.</translation></message>
<message><source>One surface ends here in front of another.</source><translation>Aquí termina una superficie delante de otra.</translation></message>
<message><source>The surface bends outwards here, as at the corner of a rock.</source><translation>La superficie se dobla hacia fuera aquí, como en la esquina de una roca.</translation></message>
<message><source>The surface bends inwards here, as where two rocks meet.</source><translation>La superficie se dobla hacia dentro aquí, como donde se tocan dos rocas.</translation></message>
<message><source>The measured surface ends here.</source><translation>Aquí termina la superficie medida.</translation></message>
<message><source>Edges of this class do not depend on Edge strength.</source><translation>Los bordes de esta clase no dependen de la Fuerza del borde.</translation></message>
<message><source>The surface changes strongly here.</source><translation>La superficie cambia mucho aquí.</translation></message>
<message><source>The reason could not be found (%1).</source><translation>No se pudo determinar la razón (%1).</translation></message>
<message><source>&amp;Why is this cell an edge or not?</source><translation>¿&amp;Por qué esta celda es un borde, o no?</translation></message>
<message><source>Finding the reason …</source><translation>Buscando la razón …</translation></message>
<message><source>under the pointer</source><translation>bajo el puntero</translation></message>
<message><source>the pinned target, under the pointer</source><translation>el objetivo fijado, bajo el puntero</translation></message>
<message><source>under the pointer, not the pinned target</source><translation>bajo el puntero, no el objetivo fijado</translation></message>
<message><source>the pinned target</source><translation>el objetivo fijado</translation></message>
<message><source>the nearest edge</source><translation>el borde más cercano</translation></message>
<message><source>the near side of your click at %1</source><translation>el lado cercano de su clic en %1</translation></message>
<message><source>the target that you clicked</source><translation>el objetivo en el que hizo clic</translation></message>
<message><source>the cell that you clicked</source><translation>la celda en la que hizo clic</translation></message>
<message><source>Cell: %1 (%2)</source><translation>Celda: %1 (%2)</translation></message>
<message><source>Why: click a cell</source><translation>Por qué: haga clic en una celda</translation></message>
<message><source>
The strongest cell of its chain is marked in all views; zoomed in, the chain is framed.</source><translation>
La celda más fuerte de su cadena está marcada en todas las vistas; al ampliar, la cadena aparece enmarcada.</translation></message>
<message><source>Clicked</source><translation>Clic</translation></message>
<message><source>Why</source><translation>Por qué</translation></message>
<message><source>strongest</source><translation>la más fuerte</translation></message>
<message><source>the demo after the blast</source><translation>la demo tras la tronadura</translation></message>
<message><source>%1, scan %2</source><translation>%1, escaneo %2</translation></message>
<message><source>the first: the others are placed against it</source><translation>el primero: los demás se colocan respecto a él</translation></message>
<message><source>OUT OF SPEC, residual %1 mm</source><translation>FUERA DE TOLERANCIA, residuo %1 mm</translation></message>
<message><source>registered, residual %1 mm</source><translation>registrado, residuo %1 mm</translation></message>
<message><source>placed by targets, %1 mm apart</source><translation>colocado por objetivos, separación %1 mm</translation></message>
<message><source>placed by pose</source><translation>colocado por la pose</translation></message>
<message><source>The layer could not be read (%1).</source><translation>No se pudo leer la capa (%1).</translation></message>
<message><source>Where is the layer now?</source><translation>¿Dónde está ahora la capa?</translation></message>
<message><source>This point is of the layer %1: make it active to measure in it.</source><translation>Este punto es de la capa %1: actívela para medir en ella.</translation></message>
<message><source>Make Active</source><translation>Activar</translation></message>
<message><source>Add scans as layers</source><translation>Añadir escaneos como capas</translation></message>
<message><source>Layers are scans of files: open the first one, or record the sweep and open its recording.</source><translation>Las capas son escaneos de archivos: abra el primero, o grabe el barrido y abra la grabación.</translation></message>
<message><source>A cloud has at most %1 layers: remove some first.</source><translation>Una nube tiene como máximo %1 capas: quite alguna primero.</translation></message>
<message><source>Add a Layer</source><translation>Añadir una capa</translation></message>
<message><source>Remove the Layer</source><translation>Quitar la capa</translation></message>
<message><source>Show the Layer</source><translation>Mostrar la capa</translation></message>
<message><source>Hide the Layer</source><translation>Ocultar la capa</translation></message>
<message><source>Locate the Layer</source><translation>Localizar la capa</translation></message>
<message><source>Three places are needed that both scans show: pin them here as targets 1, 2 and 3, make %1 active, pin the same places there in the same order, and come back.</source><translation>Hacen falta tres lugares visibles en ambos escaneos: márquelos aquí como objetivos 1, 2 y 3, active %1, marque allí los mismos lugares en el mismo orden y vuelva.</translation></message>
<message><source>Reading the layer %1</source><translation>Leyendo la capa %1</translation></message>
<message><source>Cancelled</source><translation>Cancelado</translation></message>
<message><source>The same scan is a layer already: remove one of the two.</source><translation>El mismo escaneo ya es una capa: quite una de las dos.</translation></message>
<message><source>Layer %1: %2</source><translation>Capa %1: %2</translation></message>
<message><source>%1 points · %2 of memory</source><translation>%1 puntos · %2 de memoria</translation></message>
<message><source>active</source><translation>activa</translation></message>
<message><source>▲ active, not placed</source><translation>▲ activa, sin colocar</translation></message>
<message><source>▲ not placed</source><translation>▲ sin colocar</translation></message>
<message><source>▲ not read</source><translation>▲ no leída</translation></message>
<message><source>being read</source><translation>leyendo</translation></message>
<message><source>▲ not placed against the active one</source><translation>▲ sin colocar respecto a la activa</translation></message>
<message><source>Target %1: %2 mm apart</source><translation>Objetivo %1: a %2 mm</translation></message>
<message><source>sweep %1: %2 lines</source><translation>barrido %1: %2 líneas</translation></message>
<message><source>sweep %1: %2/%3 lines, complete</source><translation>barrido %1: %2/%3 líneas, completo</translation></message>
<message><source>sweep %1: %2/%3 lines, partial</source><translation>barrido %1: %2/%3 líneas, parcial</translation></message>
<message><source>How the stepper turns the scanner is not known.</source><translation>No se sabe cómo gira el motor el escáner.</translation></message>
<message><source>How the stepper turns the scanner is not known. Edges are found all the same, but the shape of the cloud is assumed until you give it.</source><translation>No se sabe cómo gira el motor el escáner. Los bordes se encuentran igual, pero la forma de la nube es supuesta hasta que usted lo indique.</translation></message>
<message><source>There is no host to connect to: type the scanner's name or address.</source><translation>No hay host al que conectarse: escriba el nombre o la dirección del escáner.</translation></message>
<message><source>%1 cannot be connected to: type the scanner's name or address, or ws://ROBOT for a robot with ROS.</source><translation>No es posible conectarse a %1: escriba el nombre o la dirección del escáner, o ws://ROBOT para un robot con ROS.</translation></message>
<message><source>It begins with the sweep under way: %1 lines of it came before Record.</source><translation>Empieza con el barrido en curso: %1 líneas de él llegaron antes de Grabar.</translation></message>
<message><source>Give it…</source><translation>Indicarlo…</translation></message>
<message><source>The first %1 lines of this sweep are too old to be moved to their new places.</source><translation>Las primeras %1 líneas de este barrido son demasiado antiguas para moverlas a su nuevo lugar.</translation></message>
<message><source>The recording in progress has the old mounting and steps. Correct them with Scan &gt; How the Scan Is Read after you open it, or start another recording.</source><translation>La grabación que se está escribiendo indica el montaje y los pasos antiguos: corríjala con Escaneo &gt; Cómo se lee el escaneo al abrirla, o comience otra.</translation></message>
<message><source>last line %1</source><translation>última línea %1</translation></message>
<message><source>last line %1 at %2 UTC</source><translation>última línea %1 a las %2 UTC</translation></message>
<message><source>trying to connect again</source><translation>intentando conectar otra vez</translation></message>
<message><source>Waiting for the first line</source><translation>Se espera la primera línea</translation></message>
<message><source>▲ The shape is assumed: give the step in Scan &gt; Sweep…</source><translation>▲ La forma es supuesta: indique el paso en Escaneo &gt; Barrido…</translation></message>
<message><source>▲ The direction of the cloud is assumed: give the first line in Scan &gt; Sweep…</source><translation>▲ La dirección de la nube es supuesta: indique la primera línea en Escaneo &gt; Barrido…</translation></message>
<message><source>▲ The ranges show the mounting: confirm it in Scan &gt; Sweep…</source><translation>▲ Las distancias muestran el montaje: confírmelo en Escaneo &gt; Barrido…</translation></message>
<message><source>▲ The shape is assumed: give mounting and step in Scan &gt; Sweep…</source><translation>▲ La forma es supuesta: indique montaje y paso en Escaneo &gt; Barrido…</translation></message>
<message><source>Sweep %1 is held on the screen. Follow shows its newest lines.</source><translation>El barrido %1 está retenido en la pantalla. Seguir muestra sus líneas más recientes.</translation></message>
<message><source>Sweep %1 is held on the screen. Follow shows sweep %2, which grows now.</source><translation>El barrido %1 está retenido en la pantalla. Seguir muestra el barrido %2, que crece ahora.</translation></message>
<message><source>Sweep %1 is a part: %2 of %3 lines.</source><translation>El barrido %1 es parcial: %2 de %3 líneas.</translation></message>
<message><source>On the screen: %1</source><translation>En la pantalla: %1</translation></message>
<message><source>%1 was held with %2 lines when the connection ended.</source><translation>%1 estaba retenido con %2 líneas cuando terminó la conexión.</translation></message>
<message><source>%1 is a part: %2 of %3 lines. The scanner was in the middle of it when EdgeScan connected.</source><translation>%1 es parcial: %2 de %3 líneas. El escáner estaba en medio de este barrido cuando EdgeScan se conectó.</translation></message>
<message><source>The next sweep replaces it.</source><translation>El barrido siguiente lo sustituye.</translation></message>
<message><source>%1 has ended: %2 lines. How many lines a sweep has is not known.</source><translation>%1 ha terminado: %2 líneas. No se sabe cuántas líneas tiene un barrido.</translation></message>
<message><source>%1 is complete: %2 lines.</source><translation>%1 está completo: %2 líneas.</translation></message>
<message><source>%1 has ended.</source><translation>%1 terminó.</translation></message>
<message><source>Held. Follow shows the next ones, until Hold.</source><translation>Retenido. Seguir muestra los siguientes, hasta Retener.</translation></message>
<message><source>Folder for recordings</source><translation>Carpeta de grabaciones</translation></message>
<message><source>Scan %1</source><translation>Escaneo %1</translation></message>
<message><source>Edges and rocks are candidates: geometry only, one viewpoint. What is hidden behind a surface was not measured.</source><translation>Los bordes y las rocas son candidatos: solo geometría, un punto de vista. Lo que está oculto detrás de una superficie no se midió.</translation></message>
<message><source>Warnings</source><translation>Advertencias</translation></message>
<message><source>None was raised when this file was read.</source><translation>No hubo ninguna al leer este archivo.</translation></message>
<message><source>and %1 more in the record.</source><translation>y %1 más en el registro.</translation></message>
<message><source>Remark</source><translation>Observación</translation></message>
<message><source>What, when, by whom</source><translation>Qué, cuándo, por quién</translation></message>
<message><source>Site</source><translation>Lugar</translation></message>
<message><source>File</source><translation>Archivo</translation></message>
<message><source>Format</source><translation>Formato</translation></message>
<message><source>Grid</source><translation>Cuadrícula</translation></message>
<message><source>Distances</source><translation>Distancias</translation></message>
<message><source>%1 to %2 measured; gray levels from %3 to %4</source><translation>medidas de %1 a %2; niveles de gris de %3 a %4</translation></message>
<message><source>none was measured</source><translation>no se midió ninguna</translation></message>
<message><source>Scanned</source><translation>Escaneado</translation></message>
<message><source>the file does not say</source><translation>el archivo no lo dice</translation></message>
<message><source>%1 (as the pose says)</source><translation>%1 (según la pose)</translation></message>
<message><source>Scanner</source><translation>Escáner</translation></message>
<message><source>serial %1</source><translation>número de serie %1</translation></message>
<message><source>Uncertainty</source><translation>Incertidumbre</translation></message>
<message><source>ranges ± %1 m at %2 m, ± %3 m at %4 m (two standard deviations)</source><translation>distancias ± %1 m a %2 m, ± %3 m a %4 m (dos desviaciones típicas)</translation></message>
<message><source>%1; the pose does not say its own</source><translation>%1; la pose no indica la suya</translation></message>
<message><source>Edges</source><translation>Bordes</translation></message>
<message><source>%1 cells, %2 % of those measured</source><translation>%1 celdas, %2 % de las medidas</translation></message>
<message><source>Method</source><translation>Método</translation></message>
<message><source>Report by</source><translation>Informe de</translation></message>
<message><source>not said</source><translation>no indicado</translation></message>
<message><source>Made</source><translation>Hecho</translation></message>
<message><source>Where</source><translation>Dónde</translation></message>
<message><source>Position</source><translation>Posición</translation></message>
<message><source>not known: no pose</source><translation>desconocida: sin pose</translation></message>
<message><source>E %1, N %2, RL %3 m (scanner)</source><translation>E %1, N %2, RL %3 m (escáner)</translation></message>
<message><source>Frame</source><translation>Marco</translation></message>
<message><source>scanner's own frame; no pose was given</source><translation>el del escáner; no se dio ninguna pose</translation></message>
<message><source>mine grid%1</source><translation>rejilla de la mina%1</translation></message>
<message><source>Robot</source><translation>Robot</translation></message>
<message><source>the pose does not say</source><translation>la pose no lo dice</translation></message>
<message><source>Pose</source><translation>Pose</translation></message>
<message><source>at a time that it does not say</source><translation>a una hora que no indica</translation></message>
<message><source>%1, the start of the scan is not known</source><translation>%1, el inicio del escaneo no se conoce</translation></message>
<message><source>%1 s before the start of the scan</source><translation>%1 s antes del inicio del escaneo</translation></message>
<message><source>%1 s after the start of the scan</source><translation>%1 s después del inicio del escaneo</translation></message>
<message><source>Turning view</source><translation>Vista giratoria</translation></message>
<message><source>Drag to turn, wheel or two fingers to come nearer, click a point for its numbers. Keys: arrows turn, + and - come nearer, Shift and arrows shift, Enter picks what is in the middle, Home goes back. Shown, evenly chosen: %1 and %2.</source><translation>Arrastre para girar, rueda o dos dedos para acercarse, clic en un punto para ver sus números. Teclas: las flechas giran, + y - acercan, Mayús y flechas desplazan, Intro elige lo que está en el centro, Inicio vuelve. Mostrados, elegidos por igual: %1 y %2.</translation></message>
<message><source>Turn</source><translation>Girar</translation></message>
<message><source>Edges only</source><translation>Solo bordes</translation></message>
<message><source>Nearer</source><translation>Más cerca</translation></message>
<message><source>Farther</source><translation>Más lejos</translation></message>
<message><source>Larger points</source><translation>Puntos más grandes</translation></message>
<message><source>From the start</source><translation>Desde el inicio</translation></message>
<message><source>No point there.</source><translation>Ahí no hay ningún punto.</translation></message>
<message><source>Line %1, beam %2: range %3 mm, %4; %5 m.</source><translation>Línea %1, haz %2: distancia %3 mm, %4; %5 m.</translation></message>
<message><source>Beam at %1 degrees, line at %2 degrees.</source><translation>Haz a %1 grados, línea a %2 grados.</translation></message>
<message><source>Rock %1: visible %2 x %3 m, ± %4 m, at %5 m; candidate - geometry only, one viewpoint.</source><translation>Roca %1: visible %2 x %3 m, ± %4 m, a %5 m; candidata: solo geometría, un punto de vista.</translation></message>
<message><source>This browser has no WebGL; the pictures below show the same.</source><translation>Este navegador no tiene WebGL; las imágenes de abajo muestran lo mismo.</translation></message>
<message><source>no edge</source><translation>sin borde</translation></message>
<message><source>edge</source><translation>borde</translation></message>
<message><source>jump</source><translation>salto</translation></message>
<message><source>convex fold</source><translation>pliegue convexo</translation></message>
<message><source>concave fold</source><translation>pliegue cóncavo</translation></message>
<message><source>data border</source><translation>límite de los datos</translation></message>
<message><source>outline before a void</source><translation>contorno ante un vacío</translation></message>
<message><source>void rim</source><translation>borde de un vacío</translation></message>
<message><source>Logo</source><translation>Logotipo</translation></message>
<message><source>Size curve of the visible rocks: share of the rocks over their visible width b</source><translation>Curva de tamaños de las rocas visibles: proporción de las rocas según su ancho visible b</translation></message>
<message><source>Ranges as gray levels, line by line</source><translation>Distancias como niveles de gris, línea por línea</translation></message>
<message><source>Edges on darkened gray levels</source><translation>Bordes sobre niveles de gris oscurecidos</translation></message>
<message><source>The points in perspective, seen from behind the scanner</source><translation>Los puntos en perspectiva, vistos desde detrás del escáner</translation></message>
<message><source>The rocks in perspective, seen from behind the scanner</source><translation>Las rocas en perspectiva, vistas desde detrás del escáner</translation></message>
<message><source>Rocks as coloured faces on gray levels</source><translation>Rocas como caras de color sobre niveles de gris</translation></message>
<message><source>Targets and measures on gray levels</source><translation>Objetivos y medidas sobre niveles de gris</translation></message>
<message><source>What changed, on the grid of this scan</source><translation>Lo que cambió, en la cuadrícula de este escaneo</translation></message>
<message><source>Points of the scan in three dimensions; arrow keys turn, plus and minus come nearer, Enter picks</source><translation>Puntos del escaneo en tres dimensiones; las flechas giran, más y menos acercan y alejan, Intro elige</translation></message>
<message><source>%1 of %2 points</source><translation>%1 de %2 puntos</translation></message>
<message><source>%1 points</source><translation>%1 puntos</translation></message>
<message><source>%1 of %2 edge cells</source><translation>%1 de %2 celdas de borde</translation></message>
<message><source>%1 edge cells</source><translation>%1 celdas de borde</translation></message>
<message><source>Pictures</source><translation>Imágenes</translation></message>
<message><source>equal ratios</source><translation>razones iguales</translation></message>
<message><source>Gray levels: black is %1 and nearer, or nothing came back; white is %2 and farther. Across: %3; down: %4.</source><translation>Niveles de gris: negro es %1 y más cerca, o nada volvió; blanco es %2 y más lejos. A lo ancho: %3; hacia abajo: %4.</translation></message>
<message><source>Edges. Across: %1; down: %2.</source><translation>Bordes. A lo ancho: %1; hacia abajo: %2.</translation></message>
<message><source>%1 beams, %2 to %3 degrees</source><translation>%1 haces, %2 a %3 grados</translation></message>
<message><source>%1 lines, %2 to %3 degrees</source><translation>%1 líneas, %2 a %3 grados</translation></message>
<message><source>%1 beams</source><translation>%1 haces</translation></message>
<message><source>edge (%1)</source><translation>borde (%1)</translation></message>
<message><source>jump (%1)</source><translation>salto (%1)</translation></message>
<message><source>convex fold (%1)</source><translation>pliegue convexo (%1)</translation></message>
<message><source>concave fold (%1)</source><translation>pliegue cóncavo (%1)</translation></message>
<message><source>data border (%1)</source><translation>límite de datos (%1)</translation></message>
<message><source>outline before a void (%1)</source><translation>contorno ante un vacío (%1)</translation></message>
<message><source>void rim (%1)</source><translation>borde de vacío (%1)</translation></message>
<message><source>%1 of the edge cells are likely the border of a rock (30 % likely and more), %2 are folds within a rock, %3 are unknown.</source><translation>%1 de las celdas de borde son probablemente el límite de una roca (30 % y más), %2 son pliegues dentro de una roca, %3 se desconocen.</translation></message>
<message><source>%1 m at the middle of the cloud</source><translation>%1 m en el centro de la nube</translation></message>
<message><source>The points, edges in their colours.</source><translation>Los puntos, los bordes en sus colores.</translation></message>
<message><source>Rocks</source><translation>Rocas</translation></message>
<message><source>%1 rocks, each a candidate - geometry only, one viewpoint.</source><translation>%1 rocas, cada una candidata: solo geometría, un punto de vista.</translation></message>
<message><source>Sizes of the visible rocks</source><translation>Tamaños de las rocas visibles</translation></message>
<message><source>visible width b [m]</source><translation>ancho visible b [m]</translation></message>
<message><source>rocks that are not wider</source><translation>rocas que no son más anchas</translation></message>
<message><source>largest %1</source><translation>mayor %1</translation></message>
<message><source>%1 % over %2</source><translation>%1 % sobre %2</translation></message>
<message><source>The rocks with the largest visible width b</source><translation>Las rocas de mayor ancho visible b</translation></message>
<message><source>On a narrow screen only the rocks of the table have their numbers.</source><translation>En una pantalla estrecha solo las rocas de la tabla tienen sus números.</translation></message>
<message><source>Completeness</source><translation>Integridad</translation></message>
<message><source>INCOMPLETE</source><translation>INCOMPLETO</translation></message>
<message><source>%1 of %2 lines, %3 cells.</source><translation>%1 de %2 líneas, %3 celdas.</translation></message>
<message><source>measured</source><translation>medidas</translation></message>
<message><source>status of the scanner</source><translation>estado del escáner</translation></message>
<message><source>outside the range window</source><translation>fuera de la ventana de distancias</translation></message>
<message><source>lost line</source><translation>línea perdida</translation></message>
<message><source>Settings</source><translation>Ajustes</translation></message>
<message><source>File and program</source><translation>Archivo y programa</translation></message>
<message><source>auto: %1</source><translation>auto: %1</translation></message>
<message><source>%1 cells</source><translation>%1 celdas</translation></message>
<message><source>%1 steps</source><translation>%1 pasos</translation></message>
<message><source>%1 % of range</source><translation>%1 % de la distancia</translation></message>
<message><source>%1 % of high</source><translation>%1 % del alto</translation></message>
<message><source>changed from the default</source><translation>distinto del valor usual</translation></message>
<message><source>The command that makes this report as a page for browsers</source><translation>La orden que hace este informe como página para navegadores</translation></message>
<message><source>SHA-256 of the file</source><translation>SHA-256 del archivo</translation></message>
<message><source>SHA-256 of the grid</source><translation>SHA-256 de la rejilla</translation></message>
<message><source>SHA-256 of the edge mask</source><translation>SHA-256 de la máscara de bordes</translation></message>
<message><source>none</source><translation>ninguno</translation></message>
<message><source>Program</source><translation>Programa</translation></message>
<message><source>EdgeScan %1, commit %2</source><translation>EdgeScan %1, commit %2</translation></message>
<message><source>The whole record</source><translation>El registro completo</translation></message>
<message><source>Targets and measures</source><translation>Objetivos y medidas</translation></message>
<message><source>Target</source><translation>Objetivo</translation></message>
<message><source>Name and note</source><translation>Nombre y nota</translation></message>
<message><source>Cell</source><translation>Celda</translation></message>
<message><source>Where, and its edge now</source><translation>Dónde, y su borde ahora</translation></message>
<message><source>Also on its card when it was pinned</source><translation>También en su ficha cuando se fijó</translation></message>
<message><source>Pinned</source><translation>Fijado</translation></message>
<message><source>Measured</source><translation>Mediciones</translation></message>
<message><source>Result, ± two standard deviations</source><translation>Resultado, ± dos desviaciones típicas</translation></message>
<message><source>From</source><translation>De</translation></message>
<message><source>no cell of this scan</source><translation>no es una celda de este escaneo</translation></message>
<message><source>its cells hold no points now</source><translation>sus celdas no tienen puntos ahora</translation></message>
<message><source>M%1 %2</source><translation>M%1 %2</translation></message>
<message><source>E, N, RL: %1</source><translation>E, N, RL: %1</translation></message>
<message><source>Distance: %1</source><translation>Distancia: %1</translation></message>
<message><source>Dip / direction: %1</source><translation>Buzamiento / dirección: %1</translation></message>
<message><source>Edge: %1</source><translation>Borde: %1</translation></message>
<message><source>Resolves: %1</source><translation>Resolución: %1</translation></message>
<message><source>Surface: %1</source><translation>Superficie: %1</translation></message>
<message><source>From the boom: %1</source><translation>Al brazo: %1</translation></message>
<message><source>Confidence: %1</source><translation>Confianza: %1</translation></message>
<message><source>%1° ± %2° off the beam</source><translation>a %1° ± %2° del haz</translation></message>
<message><source>%1 · surface %2° off square</source><translation>%1 · superficie a %2° de la perpendicular</translation></message>
<message><source>%1 % of %2 settings</source><translation>%1 % de %2 ajustes</translation></message>
<message><source>raw grid</source><translation>cuadrícula sin procesar</translation></message>
<message><source>%1, strength %2</source><translation>%1, fuerza %2</translation></message>
<message><source>no plane fits</source><translation>ningún plano se ajusta</translation></message>
<message><source>▲ no pose</source><translation>▲ sin pose</translation></message>
<message><source>nothing was measured in this cell</source><translation>en esta celda no se midió nada</translation></message>
<message><source>Before and after</source><translation>Antes y después</translation></message>
<message><source>▲ OUT OF SPEC: the warnings below say why.</source><translation>▲ FUERA DE TOLERANCIA: las advertencias de abajo dicen por qué.</translation></message>
<message><source>Before: %1. Surfaces and edges that this scan shows otherwise; what is hidden in one of the two is not a change.</source><translation>Antes: %1. Superficies y bordes que este escaneo muestra de otro modo; lo que está oculto en uno de los dos no es un cambio.</translation></message>
<message><source>+ edge gained, or surface nearer</source><translation>+ borde ganado, o superficie más cerca</translation></message>
<message><source>− edge lost, or surface farther</source><translation>− borde perdido, o superficie más lejos</translation></message>
<message><source>= edge kept</source><translation>= borde conservado</translation></message>
<message><source>%1 has an uncertain outline (hatched); %2 pieces are too small to be shown as rocks</source><translation>%1 tiene un contorno incierto (rayado); %2 piezas son demasiado pequeñas para mostrarse como rocas</translation></message>
<message><source>%1 have an uncertain outline (hatched); %2 pieces are too small to be shown as rocks</source><translation>%1 tienen un contorno incierto (rayado); %2 piezas son demasiado pequeñas para mostrarse como rocas</translation></message>
<message><source>, %1 are outside the region of interest</source><translation>, %1 están fuera de la región de interés</translation></message>
<message><source>; %1 change was made by hand</source><translation>; %1 cambio se hizo a mano</translation></message>
<message><source>; %1 changes were made by hand</source><translation>; %1 cambios se hicieron a mano</translation></message>
<message><source>Level %1 of -4 (fine) to 4 (coarse).</source><translation>Nivel %1 de -4 (fino) a 4 (grueso).</translation></message>
<message><source>Visible width b: P20 %1 m, P50 %2 m, P80 %3 m (20, 50 and 80 % of the rocks are not wider), largest %4 m</source><translation>Ancho visible b: P20 %1 m, P50 %2 m, P80 %3 m (20, 50 y 80 % de las rocas no son más anchas), mayor %4 m</translation></message>
<message><source>; %1 % over the site's %2 m</source><translation>; %1 % sobre los %2 m del lugar</translation></message>
<message><source>by number of visible rocks; hidden parts make it finer than the pile is, by 40 % and more</source><translation>por número de rocas visibles; por las partes ocultas es más fina que la pila, en un 40 % y más</translation></message>
<message><source>Rocks as faces, uncertain ones hatched. Colours only separate neighbours. The numbers are those of the table, the drawing and the files.</source><translation>Rocas como caras, las inciertas rayadas. Los colores solo separan vecinas. Los números son los de la tabla, el dibujo y los archivos.</translation></message>
<message><source>The rocks on the points.</source><translation>Las rocas sobre los puntos.</translation></message>
<message><source>%1 numbers of smaller rocks have no room and are left out.</source><translation>%1 números de rocas menores no caben y faltan.</translation></message>
<message><source>The %1 largest (visible width b) of %2 rocks; the export of rocks as a table lists all.</source><translation>Las %1 mayores (ancho visible b) de %2 rocas; la exportación de las rocas como tabla las tiene todas.</translation></message>
<message><source>The %1 largest (visible width b) of %2 rocks; %3 more are over the site's %4; the export of rocks as a table lists all.</source><translation>Las %1 mayores (ancho visible b) de %2 rocas; otras %3 superan los %4 del lugar; la exportación de las rocas como tabla las tiene todas.</translation></message>
<message><source>E, N, RL: mean of the visible points, in the mine grid</source><translation>E, N, RL: media de los puntos visibles, en la rejilla de la mina</translation></message>
<message><source>x, y, z: mean of the visible points, in the scanner's frame.</source><translation>x, y, z: media de los puntos visibles, en el sistema del escáner.</translation></message>
<message><source>a and b: visible spans across the line of sight; hidden parts are not counted. Distance: median of its ranges. Area: visible, across the beams. In front: share of the outline where the rock is the nearer side. Contacts and free height: at least. Arch: largest angle at the rock between two that it touches; ↓ it hangs below the line between them. p: chance that the outline is right; ▲ below 0.85, hatched.</source><translation>a y b: luces visibles transversales a la línea de visión; las partes ocultas no cuentan. Distancia: mediana de sus distancias. Área: visible, transversal a los haces. Delante: parte del contorno donde la roca es el lado más cercano. Contactos y altura libre: al menos. Arco: mayor ángulo en la roca entre dos que toca; ↓ cuelga bajo la línea entre ellas. p: probabilidad de que el contorno sea correcto; ▲ menor que 0,85, rayado.</translation></message>
<message><source>Without a pose, up is the scanner's z axis, which is assumed: free height and ↓ are measured along it.</source><translation>Sin pose, hacia arriba es el eje z del escáner, que se supone: la altura libre y ↓ se miden a lo largo de él.</translation></message>
<message><source>Number with ▲: merged by hand of parts that do not touch.</source><translation>Número con ▲: unida a mano de partes que no se tocan.</translation></message>
<message><source>The targets by their numbers, and what was measured. Black is near, or nothing came back.</source><translation>Los objetivos por sus números, y lo que se midió. Negro es cerca, o nada volvió.</translation></message>
<message><source>%1 value has no room in the picture; the table has all.</source><translation>%1 valor no cabe en la imagen; la tabla los tiene todos.</translation></message>
<message><source>%1 values have no room in the picture; the table has all.</source><translation>%1 valores no caben en la imagen; la tabla los tiene todos.</translation></message>
<message><source>; other cells: points of one moved to the grid of the other</source><translation>; otras celdas: puntos de uno llevados a la rejilla del otro</translation></message>
<message><source>edges: %1 + gained, %2 - lost, %3 kept, %4 not seen by the other</source><translation>bordes: %1 + ganados, %2 - perdidos, %3 conservados, %4 no vistos por el otro</translation></message>
<message><source>cells: %1 nearer, %2 farther, %3 same, %4 no range now, %5 no range before</source><translation>celdas: %1 más cerca, %2 más lejos, %3 iguales, %4 sin distancia ahora, %5 sin distancia antes</translation></message>
<message><source>median difference</source><translation>diferencia mediana</translation></message>
<message><source>a change is more than %1 standard deviations: %2 mm at 5 m, %3 mm at 10 m</source><translation>un cambio es más de %1 desviaciones típicas: %2 mm a 5 m, %3 mm a 10 m</translation></message>
<message><source>%1 regions of %2 cells and more, visible surface from one viewpoint</source><translation>%1 regiones de %2 celdas y más, superficie visible desde un punto de vista</translation></message>
<message><source>View %1 is stored.</source><translation>La vista %1 está guardada.</translation></message>
<message><source>There is no view %1 yet: Ctrl+%1 stores the present one.</source><translation>Aún no hay una vista %1: Ctrl+%1 guarda la actual.</translation></message>
<message><source>There is nothing to report yet: open a scan first.</source><translation>Todavía no hay nada que informar: primero abra un escaneo.</translation></message>
<message><source>Report</source><translation>Informe</translation></message>
<message><source>Page for any browser (*.html)</source><translation>Página para cualquier navegador (*.html)</translation></message>
<message><source>PDF (*.pdf)</source><translation>PDF (*.pdf)</translation></message>
<message><source>Making the report %1</source><translation>Creando el informe %1</translation></message>
<message><source>pages to print</source><translation>páginas para imprimir</translation></message>
<message><source>a page for any browser</source><translation>una página para cualquier navegador</translation></message>
<message><source>The report could not be made (%1).</source><translation>No se pudo hacer el informe (%1).</translation></message>
<message><source>RL [m]</source><translation>RL [m]</translation></message>
<message><source>above the scanner [m]</source><translation>sobre el escáner [m]</translation></message>
<message><source>The section could not be computed (%1).</source><translation>No se pudo calcular la sección (%1).</translation></message>
<message><source>Se&amp;ction</source><translation>Se&amp;cción</translation></message>
<message><source>Measure a distance first: a section goes through its two ends.</source><translation>Mida primero una distancia: la sección pasa por sus dos extremos.</translation></message>
<message><source>Select a rock first: show the rocks and click on the face of one.</source><translation>Seleccione primero una roca: muestre las rocas y haga clic en la cara de una.</translation></message>
<message><source>The plane of the section meets no surface: choose two other cells.</source><translation>El plano de la sección no corta ninguna superficie: elija otras dos celdas.</translation></message>
<message><source>Vertical plane, true scale; dash-dotted in the views.</source><translation>Plano vertical, escala real; en las vistas, línea de trazo y punto.</translation></message>
<message><source>Rocks have their colours.</source><translation>Las rocas tienen sus colores.</translation></message>
<message><source>▲ no pose: up is the scanner's z</source><translation>▲ sin pose: arriba es el z del escáner</translation></message>
<message><source>The rocks are still being computed: export the section again in a moment.</source><translation>Las rocas aún se están calculando: exporte de nuevo la sección en un momento.</translation></message>
<message><source>Export Section</source><translation>Exportar la sección</translation></message>
<message><source>Drawing (*.dxf)</source><translation>Dibujo (*.dxf)</translation></message>
<message><source>Table (*.csv)</source><translation>Tabla (*.csv)</translation></message>
<message><source>Picture (*.png)</source><translation>Imagen (*.png)</translation></message>
<message><source>class %1 on</source><translation>clase %1 activada</translation></message>
<message><source>class %1 off</source><translation>clase %1 desactivada</translation></message>
<message><source>%1 %2 to %3</source><translation>%1 de %2 a %3</translation></message>
<message><source>settings</source><translation>ajustes</translation></message>
<message><source>This scan is flat and quiet: with the preset Smooth walls low steps far away are edges too.</source><translation>Este escaneo es plano y con poco ruido: con el preajuste Paredes lisas también son bordes los escalones bajos lejanos.</translation></message>
<message><source>Use It</source><translation>Usarlo</translation></message>
<message><source>Open preset</source><translation>Abrir un preajuste</translation></message>
<message><source>EdgeScan presets (*.json)</source><translation>Preajustes de EdgeScan (*.json)</translation></message>
<message><source>Save preset</source><translation>Guardar el preajuste</translation></message>
<message><source>%1 is not a preset and stays as it is: choose another name.</source><translation>%1 no es un preajuste y queda como está: elija otro nombre.</translation></message>
<message><source>a section</source><translation>una sección</translation></message>
<message><source>a section of %1</source><translation>una sección de %1</translation></message>
<message><source>%1 edge points</source><translation>%1 puntos de borde</translation></message>
<message><source>Nothing is selected yet: drag a box (B) or a lasso (L) over a view first.</source><translation>Todavía no hay nada seleccionado: primero trace un recuadro (B) o un lazo (L) sobre una vista.</translation></message>
<message><source>There is nothing to export yet: open a scan first.</source><translation>Todavía no hay nada que exportar: primero abra un escaneo.</translation></message>
<message><source>Export %1 points</source><translation>Exportar %1 puntos</translation></message>
<message><source>Export targets: %1</source><translation>Exportar objetivos: %1</translation></message>
<message><source>Export</source><translation>Exportar</translation></message>
<message><source>Save screenshot</source><translation>Guardar la captura de pantalla</translation></message>
<message><source>PNG picture (*.png)</source><translation>Imagen PNG (*.png)</translation></message>
<message><source>a picture of the window</source><translation>una imagen de la ventana</translation></message>
<message><source>There is no file on the screen that could be read in another way: open one first.</source><translation>No hay en pantalla ningún archivo que se pueda leer de otra manera: primero abra uno.</translation></message>
<message><source>All supported (%1)</source><translation>Todos los formatos admitidos (%1)</translation></message>
<message><source>All files (*)</source><translation>Todos los archivos (*)</translation></message>
<message><source>Open scan</source><translation>Abrir un escaneo</translation></message>
<message><source>This is the last scan of the series or folder.</source><translation>Este es el último escaneo de la serie o de la carpeta.</translation></message>
<message><source>This is the first scan of the series or folder.</source><translation>Este es el primer escaneo de la serie o de la carpeta.</translation></message>
<message><source>Straighten Beams</source><translation>Enderezar los haces</translation></message>
<message><source>Beams as Recorded</source><translation>Haces tal como se grabaron</translation></message>
<message><source>Keep Repeated Values</source><translation>Conservar los valores repetidos</translation></message>
<message><source>Repeated Values as No Return</source><translation>Valores repetidos como sin retorno</translation></message>
<message><source>Read it in another way…</source><translation>Leerlo de otra manera…</translation></message>
<message><source>How the Scan Is Read</source><translation>Cómo se lee el escaneo</translation></message>
<message><source>%1 was moved or removed. Its picture stays on the screen.</source><translation>%1 se movió o se eliminó. Su imagen queda en la pantalla.</translation></message>
<message><source>%1 was written again. The picture shows what was in it before.</source><translation>%1 se escribió de nuevo. La imagen muestra lo que contenía antes.</translation></message>
<message><source>Read again</source><translation>Leer de nuevo</translation></message>
<message><source>%1, a pose of 3DTK, is not read with the scan: type the place of the scanner at Scan &gt; Pose and Mounting.</source><translation>%1, una pose de 3DTK, no se lee con el escaneo: escriba el lugar del escáner en Escaneo &gt; Pose y montaje.</translation></message>
<message><source>Straighten beams</source><translation>Enderezar los haces</translation></message>
<message><source>Keep as measured</source><translation>Conservar como medido</translation></message>
<message><source>No file yet; demos are not listed</source><translation>Ningún archivo todavía; las demos no figuran aquí</translation></message>
<message><source>Clear</source><translation>Borrar</translation></message>
<message><source> (%1 of %2)</source><translation> (%1 de %2)</translation></message>
<message><source>Does this look right?</source><translation>¿Parece correcto?</translation></message>
<message><source>On the screen, not yet adopted: %1</source><translation>En pantalla, aún no adoptado: %1</translation></message>
<message><source>The scanner looks forward: what is above it without a pose is now in front of it. If it looks up into a bell, choose “up” on the page Mounting.</source><translation>El escáner mira hacia delante: lo que sin pose está por encima de él ahora está delante. Si mira hacia arriba dentro de una campana, elija «hacia arriba» en la página Montaje.</translation></message>
<message><source>The mounting looks up, but pitch and roll turn it to the side: type 0 and 0 for a level boom, or choose “forward” on the page Mounting.</source><translation>El montaje mira hacia arriba, pero cabeceo y alabeo lo giran hacia un lado: escriba 0 y 0 para un brazo nivelado, o elija «hacia delante» en la página Montaje.</translation></message>
<message><source>The mounting looks up, but %1 % of the points are lower than the scanner: correct pitch and roll, or choose another direction on the page Mounting.</source><translation>El montaje mira hacia arriba, pero el %1 % de los puntos está más bajo que el escáner: corrija cabeceo y alabeo, o elija otra dirección en la página Montaje.</translation></message>
<message><source>Scanner at E %1, N %2, RL %3 m. </source><translation>Escáner en E %1, N %2, RL %3 m. </translation></message>
<message><source>It looks %1° below the horizon. </source><translation>Mira %1° por debajo del horizonte. </translation></message>
<message><source>It looks %1° above the horizon. </source><translation>Mira %1° por encima del horizonte. </translation></message>
<message><source>Its points: </source><translation>Sus puntos: </translation></message>
<message><source>It failed (%1); close other programs or use a smaller scan.</source><translation>Falló (%1); cierre otros programas o use un escaneo más pequeño.</translation></message>
<message><source>Store Pose</source><translation>Guardar la pose</translation></message>
<message><source>Remove Pose</source><translation>Quitar la pose</translation></message>
<message><source>Open a scan first.</source><translation>Abra primero un escaneo.</translation></message>
<message><source>The picture does not come from a file, so its pose cannot be stored: open a scan or a recording.</source><translation>La imagen no viene de un archivo, así que su pose no se puede guardar: abra un escaneo o una grabación.</translation></message>
<message><source>Store the mounting</source><translation>Guardar el montaje</translation></message>
<message><source>Name of the scanner</source><translation>Nombre del escáner</translation></message>
<message><source>The robot's calibration</source><translation>La calibración del robot</translation></message>
<message><source>Calibration (*.json)</source><translation>Calibración (*.json)</translation></message>
<message><source>The pose that was stored with the scan is removed.</source><translation>La pose guardada con el escaneo se ha eliminado.</translation></message>
<message><source>The pose is stored with the scan, in %1; it replaced the one that was there.</source><translation>La pose se guardó con el escaneo, en %1; reemplazó la que había.</translation></message>
<message><source>The pose is stored with the scan, in %1.</source><translation>La pose se guardó con el escaneo, en %1.</translation></message>
<message><source>The pose could not be stored (%1).</source><translation>No se pudo guardar la pose (%1).</translation></message>
<message><source>, %1 min ago</source><translation>, hace %1 min</translation></message>
<message><source>, %1 h ago</source><translation>, hace %1 h</translation></message>
<message><source>, %1 days ago</source><translation>, hace %1 días</translation></message>
<message><source>Placed by %1</source><translation>Ubicado por %1</translation></message>
<message><source>HELD, %1 of %2 lines</source><translation>RETENIDO, %1 de %2 líneas</translation></message>
<message><source>HELD, whole sweep</source><translation>RETENIDO, barrido entero</translation></message>
<message><source>HELD, sweep %1 grows</source><translation>RETENIDO, el barrido %1 crece</translation></message>
<message><source>HELD</source><translation>RETENIDO</translation></message>
<message><source>HELD, 1 line behind</source><translation>RETENIDO, 1 línea atrás</translation></message>
<message><source>HELD, %1 lines behind</source><translation>RETENIDO, %1 líneas atrás</translation></message>
<message><source> · no time</source><translation> · sin hora</translation></message>
<message><source>What the scanner sends now, with the time of its newest line. %1</source><translation>Lo que el escáner envía ahora, con la hora de su línea más reciente. %1</translation></message>
<message><source>The connection to the scanner has ended: the time is that of the newest line</source><translation>El escáner ya no está conectado: la hora es la de la línea más reciente</translation></message>
<message><source>The scanner goes on, this picture does not: the time is that of its newest line</source><translation>El escáner continúa, esta imagen no: la hora es la de su línea más reciente</translation></message>
<message><source>NO PICTURE</source><translation>SIN IMAGEN</translation></message>
<message><source>RECORDED</source><translation>GRABADO</translation></message>
<message><source>Last line, by %1</source><translation>Última línea, según %1</translation></message>
<message><source>FILE</source><translation>ARCHIVO</translation></message>
<message><source>no time</source><translation>sin hora</translation></message>
<message><source>The file does not say when it was measured</source><translation>El archivo no dice cuándo se midió</translation></message>
<message><source>First line, by %1</source><translation>Primera línea, según %1</translation></message>
<message><source>COARSE PICTURE</source><translation>IMAGEN PRELIMINAR</translation></message>
<message><source>Some points of the scan that is being opened.</source><translation>Algunos puntos del escaneo que se está abriendo.</translation></message>
<message><source>OLD PICTURE</source><translation>IMAGEN ANTERIOR</translation></message>
<message><source>Another scan is being opened. This is the picture before it.</source><translation>Se está abriendo otro escaneo. Esta es la imagen anterior.</translation></message>
<message><source>%1 Edits of rocks are not stored until then.</source><translation>%1 Hasta entonces no se guardan las ediciones de las rocas.</translation></message>
<message><source>Edits of rocks are not stored: %1</source><translation>Las ediciones de las rocas no se guardan: %1</translation></message>
<message><source>Split: click the part that is a rock of its own (wheel: smaller or larger)</source><translation>Dividir: haga clic en la parte que es otra roca (rueda: menor o mayor)</translation></message>
<message><source>Merge: drag a line across the rocks, or click the one that belongs to the selected rock</source><translation>Fusionar: trace una línea sobre las rocas, o haga clic en la que pertenece a la roca seleccionada</translation></message>
<message><source>Cut: drag a line through the rock, or click both its ends</source><translation>Cortar: trace una línea a través de la roca, o haga clic en sus dos extremos</translation></message>
<message><source>Region: drag a line around it</source><translation>Región: trace una línea alrededor</translation></message>
<message><source>the whole piece as it is</source><translation>el trozo entero tal como está</translation></message>
<message><source>a click splits it off</source><translation>un clic lo separa</translation></message>
<message><source>larger than the rock: a click merges it</source><translation>mayor que la roca: un clic lo fusiona</translation></message>
<message><source>no smaller and no larger part</source><translation>no hay parte menor ni mayor</translation></message>
<message><source>wheel: larger (this is the smallest part)</source><translation>rueda: mayor (esta es la parte más pequeña)</translation></message>
<message><source>wheel: smaller (this is the largest piece)</source><translation>rueda: menor (esta es la pieza más grande)</translation></message>
<message><source>wheel: smaller or larger</source><translation>rueda: menor o mayor</translation></message>
<message><source>%1 cells, %2</source><translation>%1 celdas, %2</translation></message>
<message><source>Nothing was split: click on a rock, on the part that is a rock of its own.</source><translation>No se dividió nada: haga clic en una roca, en la parte que es una roca aparte.</translation></message>
<message><source>The rocks are still being computed: split again when they are here.</source><translation>Las rocas aún se están calculando: divida de nuevo cuando estén aquí.</translation></message>
<message><source>split of a rock</source><translation>división de una roca</translation></message>
<message><source>Nothing was split: this rock is one piece without a line that separates parts. Cut along a Line splits it where you draw.</source><translation>No se dividió nada: esta roca es de un solo trozo y nada distingue sus partes. Cortar a lo largo de una línea la divide donde usted dibuje.</translation></message>
<message><source>merge of rocks</source><translation>fusión de rocas</translation></message>
<message><source>Click the other end of the line, past the other side of the rock.</source><translation>Haga clic en el otro extremo de la línea, más allá del otro lado de la roca.</translation></message>
<message><source>cut of a rock</source><translation>corte de una roca</translation></message>
<message><source>Nothing was cut: draw the line through a rock, from one side to the other. Each part needs %1 cells.</source><translation>No se cortó nada: trace la línea a través de una roca, de un lado al otro. Cada parte necesita %1 celdas.</translation></message>
<message><source>Nothing was merged: draw the line from one rock over the crack into the next.</source><translation>No se fusionó nada: trace la línea de una roca a la siguiente, por encima de la grieta.</translation></message>
<message><source>There is no region yet: draw the line round what counts, in one of the images.</source><translation>Todavía no hay región: trace la línea alrededor de lo que cuenta, en una de las imágenes.</translation></message>
<message><source>region of interest</source><translation>región de interés</translation></message>
<message><source>Open Session</source><translation>Abrir la sesión</translation></message>
<message><source>The session's edits of rocks replaced those that were stored next to the scan; Ctrl+Z brings them back.</source><translation>Las correcciones de rocas de la sesión reemplazaron a las guardadas junto al escaneo; Ctrl+Z las devuelve.</translation></message>
<message><source>No rock changed, so nothing is to be undone. Click on another part of the rock, or draw across the whole of it, past its outline.</source><translation>Ninguna roca cambió, así que no hay nada que deshacer. Haga clic en otra parte de la roca, o dibuje a través de toda ella, más allá de su contorno.</translation></message>
<message><source>Nothing was merged: this is one rock already.</source><translation>No se unió nada: ya es una sola roca.</translation></message>
<message><source>mark as a rock</source><translation>marca de roca</translation></message>
<message><source>mark as not a rock</source><translation>marca de no roca</translation></message>
<message><source>There is nothing to export yet: show the rocks of a scan first.</source><translation>Todavía no hay nada que exportar: primero muestre las rocas de un escaneo.</translation></message>
<message><source>Export %1 of %2</source><translation>Exportar %1 de %2</translation></message>
<message><source>Export %1</source><translation>Exportar %1</translation></message>
<message><source>%1 was not written: give it one of the endings %2.</source><translation>%1 no se escribió: dele una de las extensiones %2.</translation></message>
<message><source>%1 waits for the rocks</source><translation>%1 espera las rocas</translation></message>
<message><source>%1 was not written: its rocks are not known.</source><translation>%1 no se escribió: no se conocen sus rocas.</translation></message>
<message><source>the rock could not be cut (%1); close other programs.</source><translation>no se pudo cortar la roca (%1); cierre otros programas.</translation></message>
<message><source>the rocks could not be computed (%1); close other programs or open a smaller scan.</source><translation>no se pudieron calcular las rocas (%1); cierre otros programas o abra un escaneo más pequeño.</translation></message>
<message><source>Another window changed the rocks of this scan. The changes of both windows are kept.</source><translation>Otra ventana ha cambiado las rocas de este escaneo. Se conservan los cambios de ambas ventanas.</translation></message>
<message><source>▲ of the first %1 lines</source><translation>▲ de las primeras %1 líneas</translation></message>
<message><source>▲ of the picture before; being computed again</source><translation>▲ de la imagen anterior; se está calculando de nuevo</translation></message>
<message><source>being computed …</source><translation>en cálculo …</translation></message>
<message><source>No rock was found here: choose Pin to set a target.</source><translation>Aquí no hay ninguna roca: elija Fijar para poner un objetivo.</translation></message>
<message><source>This Is a Roc&amp;k</source><translation>Esto es una &amp;roca</translation></message>
<message><source>&amp;Rock %1</source><translation>&amp;Roca %1</translation></message>
<message><source>Se&amp;lect</source><translation>Se&amp;leccionar</translation></message>
<message><source>&amp;Merge with Selected Rocks</source><translation>&amp;Unir con las rocas seleccionadas</translation></message>
<message><source>&amp;Split Here</source><translation>&amp;Dividir aquí</translation></message>
<message><source>&amp;Cut along a Line</source><translation>&amp;Cortar a lo largo de una línea</translation></message>
<message><source>&amp;Wall, Not a Rock</source><translation>&amp;Pared, no es una roca</translation></message>
<message><source>&amp;Export Rocks…</source><translation>&amp;Exportar las rocas…</translation></message>
<message><source>Rock %1 has the largest visible width b, %2 m. Rock 1 has the largest visible area.</source><translation>La roca %1 tiene el mayor ancho visible b, %2 m. La roca 1 tiene la mayor área visible.</translation></message>
<message><source>No rock has a smaller visible width b.</source><translation>Ninguna roca tiene un ancho visible b menor.</translation></message>
<message><source>EdgeScan sessions (*%1)</source><translation>Sesiones de EdgeScan (*%1)</translation></message>
<message><source>JSON files (*.json)</source><translation>Archivos JSON (*.json)</translation></message>
<message><source>The session is not saved (%1).</source><translation>La sesión no se guarda (%1).</translation></message>
<message><source>The session is not saved: %1</source><translation>La sesión no se guarda: %1</translation></message>
<message><source>from now on saved as it changes</source><translation>desde ahora se guarda con cada cambio</translation></message>
<message><source>There is nothing to save yet: open a scan first. To store a live sweep, record it.</source><translation>Aún no hay nada que guardar: abra antes un escaneo. Un barrido en vivo se conserva grabándolo.</translation></message>
<message><source>Save session</source><translation>Guardar sesión</translation></message>
<message><source>%1 is not a session and stays as it is: choose another name.</source><translation>%1 no es una sesión y queda como está: elija otro nombre.</translation></message>
<message><source>Open session</source><translation>Abrir sesión</translation></message>
<message><source>Screenshots (*.png)</source><translation>Capturas de pantalla (*.png)</translation></message>
<message><source>%1: this is not a session; choose a session, or a screenshot that carries one.</source><translation>%1: esto no es una sesión; elija una sesión, o una captura de pantalla que lleve una.</translation></message>
<message><source>%1: the scan of this session was not found. It was moved, or its disk is missing. Settings and view are restored. The rest needs the scan.</source><translation>%1: no se encontró el escaneo de esta sesión. Se movió, o falta su disco. Los ajustes y la vista se han restaurado. El resto necesita el escaneo.</translation></message>
<message><source>Locate…</source><translation>Localizar…</translation></message>
<message><source>Where is the scan now?</source><translation>¿Dónde está ahora el escaneo?</translation></message>
<message><source>The session %1 is not changed: this is another scan.</source><translation>La sesión %1 no se modifica: este es otro escaneo.</translation></message>
<message><source>%1 is not the scan of this session: its content differs. Settings and view are restored; targets, selection, marks, rocks, A and the camera are not.</source><translation>%1 no es el escaneo de esta sesión: su contenido es distinto. Los ajustes y la vista se han restaurado; los objetivos, la selección, las marcas, las rocas, A y la cámara no.</translation></message>
<message><source>measurements: %1</source><translation>mediciones: %1</translation></message>
<message><source>edits of rocks: %1</source><translation>correcciones de rocas: %1</translation></message>
<message><source>settings, view</source><translation>ajustes, vista</translation></message>
<message><source>Restored: %1. Undo begins here.</source><translation>Restaurado: %1. Deshacer empieza aquí.</translation></message>
<message><source>There is no session to go on with yet: open a scan first.</source><translation>Aún no hay ninguna sesión que continuar: abra antes un escaneo.</translation></message>
<message><source>EdgeScan ended without being closed. What was on the screen at %1 is stored.</source><translation>EdgeScan terminó sin cerrarse. Lo que había en pantalla el %1 se ha guardado.</translation></message>
<message><source>Go on where I was</source><translation>Continuar donde estaba</translation></message>
<message><source>Nothing could be proposed (%1).</source><translation>No se pudo proponer nada (%1).</translation></message>
<message><source>This &amp;is an edge</source><translation>Esto &amp;es un borde</translation></message>
<message><source>This is &amp;not an edge</source><translation>Esto &amp;no es un borde</translation></message>
<message><source>Point at a cell or click one first; then say whether an edge is there.</source><translation>Señale o haga clic primero en una celda; diga luego si hay un borde.</translation></message>
<message><source>This cell was not marked: there are %1 marks, clear some first.</source><translation>Esta celda no se marcó: ya hay %1 marcas, borre antes algunas.</translation></message>
<message><source>Mark as an Edge</source><translation>Marca de borde</translation></message>
<message><source>Mark as Not an Edge</source><translation>Marca de no borde</translation></message>
<message><source>the mark “edge” at line %1, beam %2</source><translation>la marca «borde» en la línea %1, haz %2</translation></message>
<message><source>the mark “not an edge” at line %1, beam %2</source><translation>la marca «sin borde» en la línea %1, haz %2</translation></message>
<message><source>Clear the Marks</source><translation>Borrar las marcas</translation></message>
<message><source>all marks, %1 “edge” and %2 “not an edge”</source><translation>todas las marcas, %1 «borde» y %2 «sin borde»</translation></message>
<message><source>✓ edge</source><translation>✓ borde</translation></message>
<message><source>✕ not an edge</source><translation>✕ sin borde</translation></message>
<message><source>Nothing is marked yet: right-click a cell and mark it as an edge, or as not an edge.</source><translation>Todavía no hay nada marcado: haga clic derecho en una celda y márquela como borde o como no borde.</translation></message>
<message><source>The sweep is still growing: wait for its end, or hold it.</source><translation>El barrido todavía crece: espere su final, o deténgalo.</translation></message>
<message><source>Finding settings for these marks: method %1 of %2 …</source><translation>Buscando ajustes para estas marcas: método %1 de %2 …</translation></message>
<message><source>Settings for These Marks</source><translation>Ajustes para estas marcas</translation></message>
<message><source>%1 of %2 methods agree with all marks.</source><translation>%1 de %2 métodos concuerdan con todas las marcas.</translation></message>
<message><source>No setting separates these marks. Those that get most of them right come first.</source><translation>Ningún ajuste separa estas marcas. Los que aciertan en la mayoría van primero.</translation></message>
<message><source>click one end</source><translation>haga clic en un extremo</translation></message>
<message><source>click the other end</source><translation>haga clic en el otro extremo</translation></message>
<message><source>click the lower cell</source><translation>haga clic en la celda más baja</translation></message>
<message><source>click the higher cell</source><translation>haga clic en la celda más alta</translation></message>
<message><source>click the end of one side</source><translation>haga clic en el extremo de un lado</translation></message>
<message><source>click where the sides meet</source><translation>haga clic donde se juntan los lados</translation></message>
<message><source>click the end of the other side</source><translation>haga clic en el extremo del otro lado</translation></message>
<message><source>click one end of a</source><translation>haga clic en un extremo de a</translation></message>
<message><source>click the other end of a</source><translation>haga clic en el otro extremo de a</translation></message>
<message><source>click one end of b</source><translation>haga clic en un extremo de b</translation></message>
<message><source>click the other end of b</source><translation>haga clic en el otro extremo de b</translation></message>
<message><source>click into the opening, or the near rock at one side</source><translation>haga clic en la abertura, o en la roca cercana de un lado</translation></message>
<message><source>click the rock at the other side</source><translation>haga clic en la roca del otro lado</translation></message>
<message><source>the throat could not be measured (%1); close other programs.</source><translation>no se pudo medir la garganta (%1); cierre otros programas.</translation></message>
<message><source>Nothing was measured within %1 cells of this click, so no length ends there: click nearer to a surface.</source><translation>No se midió nada a menos de %1 celdas de este clic, así que ninguna longitud termina allí: haga clic más cerca de una superficie.</translation></message>
<message><source>Clicks next to this one find a throat of %1 to %2 m: zoom in, or click on the rock at both sides.</source><translation>Clics junto a este encuentran una garganta de %1 a %2 m: acerque la vista, o haga clic en la roca de ambos lados.</translation></message>
<message><source>Clicks next to these find a throat of %1 to %2 m: zoom in and click on the rock at both sides, or once into the middle of the opening.</source><translation>Clics junto a estos encuentran una garganta de %1 a %2 m: acerque la vista y haga clic en la roca de ambos lados, o una vez en el medio de la abertura.</translation></message>
<message><source>The last click is in an opening and measures all of it: the click before does not count.</source><translation>El último clic está en una abertura y la mide entera: el clic anterior no cuenta.</translation></message>
<message><source>No opening between these two clicks: click the rock at both sides of one. Distance measures over a rock.</source><translation>No hay abertura entre estos dos clics: haga clic en la roca a ambos lados de una. Distancia mide sobre una roca.</translation></message>
<message><source>A click went through the opening, so the rim in front of it was taken: check both ends of the line.</source><translation>Un clic pasó por la abertura, así que se tomó el borde de delante: compruebe los dos extremos de la línea.</translation></message>
<message><source>An end of this measurement is %1 m behind the surface under its line: check where its ends are, and click again on the near side if that was meant.</source><translation>Un extremo de esta medición está %1 m detrás de la superficie bajo su línea: compruebe dónde están sus extremos y haga clic de nuevo en el lado cercano si era ese.</translation></message>
<message><source> · the last click took target %1, at %2 m</source><translation> · el último clic tomó el objetivo %1, a %2 m</translation></message>
<message><source> · the last click took the near side, at %1 m</source><translation> · el último clic tomó el lado cercano, a %1 m</translation></message>
<message><source> · the last click is at %1 m</source><translation> · el último clic está a %1 m</translation></message>
<message><source>Throat width: the narrowest way is being searched …</source><translation>Ancho de la garganta: se busca el paso más estrecho …</translation></message>
<message><source>Nothing was selected (%1).</source><translation>No se seleccionó nada (%1).</translation></message>
<message><source>Select Nothing</source><translation>No seleccionar nada</translation></message>
<message><source>Select</source><translation>Seleccionar</translation></message>
<message><source>This cell is not an edge, so it is on no chain of edges: choose one that is.</source><translation>Esta celda no es un borde, así que no está en ninguna cadena de bordes: elija una que lo sea.</translation></message>
<message><source>This cell is not on a rock: choose a cell on a coloured face.</source><translation>Esta celda no está en una roca: elija una celda sobre una cara coloreada.</translation></message>
<message><source>Rocks are not shown, so none can be selected: show them first.</source><translation>Las rocas no se muestran, así que no se puede seleccionar ninguna: muéstrelas primero.</translation></message>
<message><source>Hide</source><translation>Ocultar</translation></message>
<message><source>Isolate</source><translation>Aislar</translation></message>
<message><source>Show All</source><translation>Mostrar todo</translation></message>
<message><source>%1 cells selected, %2 points, %3 edge cells</source><translation>%1 celdas seleccionadas, %2 puntos, %3 celdas de borde</translation></message>
<message><source>▲ %1 cells hidden</source><translation>▲ %1 celdas ocultas</translation></message>
<message><source>&amp;Isolate</source><translation>A&amp;islar</translation></message>
<message><source>&amp;Select</source><translation>Se&amp;leccionar</translation></message>
<message><source>Edge &amp;Chain Here</source><translation>&amp;Cadena de bordes aquí</translation></message>
<message><source>&amp;Rock Here</source><translation>&amp;Roca aquí</translation></message>
<message><source>&amp;Hide Selected</source><translation>&amp;Ocultar la selección</translation></message>
<message><source>&amp;Isolate Selected</source><translation>&amp;Aislar la selección</translation></message>
<message><source>Show &amp;All</source><translation>&amp;Mostrar todo</translation></message>
<message><source>&amp;Export Selected…</source><translation>E&amp;xportar la selección…</translation></message>
<message><source>There is no cell here: nothing more is hidden.</source><translation>No hay ninguna celda ahí: no se oculta nada más.</translation></message>
<message><source>▲ The sweep grows. The cells that are there now are hidden. New lines are shown at every range.</source><translation>▲ El barrido continúa. Se ocultan las celdas que están allí ahora. Las líneas nuevas se muestran a cualquier distancia.</translation></message>
<message><source>Range Gate</source><translation>Ventana de distancia</translation></message>
<message><source>No range is known there: click a cell, or point at one that has a range, first.</source><translation>No se conoce distancia ahí: haga clic o señale primero una celda que la tenga.</translation></message>
<message><source>Clip to Box</source><translation>Recortar a una caja</translation></message>
<message><source>The targets could not be stored (%1).</source><translation>No se pudieron guardar los objetivos (%1).</translation></message>
<message><source>Your targets are not stored: %1</source><translation>Sus objetivos no se guardaron: %1</translation></message>
<message><source>The targets could not be computed (%1).</source><translation>No se pudieron calcular los objetivos (%1).</translation></message>
<message><source>Targets and measurements of the previous scan: %1. They are stored with it, as its edits of rocks are: open it again to see them.</source><translation>Objetivos y mediciones del escaneo anterior: %1. Están guardados con él, igual que sus correcciones de rocas: ábralo de nuevo para verlos.</translation></message>
<message><source>Not stored: EdgeScan was started without its settings.</source><translation>No guardado: EdgeScan se inició sin sus ajustes.</translation></message>
<message><source>Not stored yet. Targets of a live sweep are stored when you open its recording, those of a part of a recording when its whole sweep is shown.</source><translation>Aún sin guardar. Los objetivos de un barrido en vivo se guardan cuando abre su grabación; los de una parte de una grabación, cuando se muestra su barrido entero.</translation></message>
<message><source>▲ Not stored: the targets of this scan were refused.</source><translation>▲ No se guarda: los objetivos de este escaneo fueron rechazados.</translation></message>
<message><source>Another window has this scan open, too. Targets and edits of rocks of both are stored together.</source><translation>Otra ventana también tiene abierto este escaneo. Los objetivos y las ediciones de rocas de ambas se guardan juntos.</translation></message>
<message><source>This cell was not pinned: there are %1 targets, remove some first.</source><translation>Esta celda no se fijó: hay %1 objetivos, primero quite algunos.</translation></message>
<message><source>new target %1</source><translation>nuevo objetivo %1</translation></message>
<message><source>Target %1 is locked and stays: unlock it to remove it.</source><translation>El objetivo %1 está bloqueado y se queda: desbloquéelo para quitarlo.</translation></message>
<message><source>removal of target %1</source><translation>supresión del objetivo %1</translation></message>
<message><source>Target %1</source><translation>Objetivo %1</translation></message>
<message><source>removal of all targets</source><translation>supresión de todos los objetivos</translation></message>
<message><source>Targets %1</source><translation>Objetivos %1</translation></message>
<message><source>1 locked target stays.</source><translation>Queda 1 objetivo bloqueado.</translation></message>
<message><source>%1 locked targets stay.</source><translation>Quedan %1 objetivos bloqueados.</translation></message>
<message><source>lock of target %1</source><translation>bloqueo del objetivo %1</translation></message>
<message><source>unlocking of target %1</source><translation>desbloqueo del objetivo %1</translation></message>
<message><source>This was not stored: there are %1 measurements, remove some first.</source><translation>Esto no se guardó: hay %1 mediciones, primero quite algunas.</translation></message>
<message><source>new measurement</source><translation>nueva medición</translation></message>
<message><source>removal of measurement M%1</source><translation>supresión de la medición M%1</translation></message>
<message><source>Another window changed the targets or measurements of this scan. Both are kept; of two with one number, yours has the next free one.</source><translation>Otra ventana ha cambiado los objetivos o las medidas de este escaneo. Se conservan ambos; de dos con el mismo número, el suyo tiene el siguiente libre.</translation></message>
<message><source>rock %1</source><translation>roca %1</translation></message>
<message><source>end %1 is target %2</source><translation>el extremo %1 es el objetivo %2</translation></message>
<message><source>moved here from line %1, beam %2</source><translation>movido aquí desde línea %1, haz %2</translation></message>
<message><source>up is assumed</source><translation>se supone dónde es arriba</translation></message>
<message><source>a cell of it has no range</source><translation>una de sus celdas no tiene distancia</translation></message>
<message><source>locked</source><translation>bloqueado</translation></message>
<message><source>Pinned %1</source><translation>Fijado %1</translation></message>
<message><source>%1 warnings</source><translation>%1 advertencias</translation></message>
<message><source>Target %1 is on the clipboard, as text.</source><translation>El objetivo %1 está en el portapapeles, como texto.</translation></message>
<message><source>On the clipboard, as a table for a spreadsheet: %1.</source><translation>En el portapapeles, como tabla para una hoja de cálculo: %1.</translation></message>
<message><source>Na&amp;me…</source><translation>No&amp;mbre…</translation></message>
<message><source>Meas&amp;ure from Here</source><translation>Medir desde aq&amp;uí</translation></message>
<message><source>Na&amp;me of Target %1…</source><translation>No&amp;mbre del objetivo %1…</translation></message>
<message><source>No&amp;te on Target %1…</source><translation>No&amp;ta sobre el objetivo %1…</translation></message>
<message><source>Unloc&amp;k Target %1</source><translation>&amp;Desbloquear el objetivo %1</translation></message>
<message><source>Loc&amp;k Target %1</source><translation>&amp;Bloquear el objetivo %1</translation></message>
<message><source>Remo&amp;ve Target %1</source><translation>&amp;Quitar el objetivo %1</translation></message>
<message><source>Name of a rock</source><translation>Nombre de una roca</translation></message>
<message><source>Name of target %1, which is on this rock:</source><translation>Nombre del objetivo %1, que está en esta roca:</translation></message>
<message><source>Name of this rock. A new target on it, number %1, holds the name:</source><translation>Nombre de esta roca. Un nuevo objetivo sobre ella, número %1, lleva el nombre:</translation></message>
<message><source>Name of a target</source><translation>Nombre de un objetivo</translation></message>
<message><source>Name of target %1:</source><translation>Nombre del objetivo %1:</translation></message>
<message><source>Nothing to name yet: pin a cell, or choose a target.</source><translation>No hay objetivo que nombrar: fije una celda o elija un objetivo.</translation></message>
<message><source>Note on a target</source><translation>Nota sobre un objetivo</translation></message>
<message><source>Note on target %1:</source><translation>Nota sobre el objetivo %1:</translation></message>
<message><source>name of target %1</source><translation>nombre del objetivo %1</translation></message>
<message><source>note of target %1</source><translation>nota del objetivo %1</translation></message>
<message><source>Open a scan: Ctrl+O, or drop a file here</source><translation>Abrir un escaneo: Ctrl+O, o suelte un archivo aquí</translation></message>
<message><source>Coarse picture of %1 million cells, the rest is coming</source><translation>Imagen preliminar de %1 millones de celdas, falta el resto</translation></message>
<message><source>The edges come with the rest of the scan</source><translation>Los bordes llegan con el resto del escaneo</translation></message>
<message><source>The scanner did not measure this place, or its point is hidden. Click the rock next to it.</source><translation>El escáner no midió este lugar, o su punto está oculto. Haga clic en la roca de al lado.</translation></message>
<message><source>A is shown; go back to B to pin or to measure.</source><translation>Se muestra A; vuelva a B para fijar o medir.</translation></message>
<message><source>Cells can be clicked when the whole scan is here: this is a coarse picture of it.</source><translation>Se puede hacer clic en las celdas cuando el escaneo está completo: esta es una imagen preliminar.</translation></message>
<message><source>&amp;Pin this cell</source><translation>&amp;Fijar esta celda</translation></message>
<message><source>&amp;Fly to this point</source><translation>&amp;Volar a este punto</translation></message>
<message><source>View from &amp;scanner</source><translation>Vista desde el &amp;escáner</translation></message>
<message><source>F&amp;it the cloud</source><translation>Enc&amp;uadrar la nube</translation></message>
<message><source>Fit the &amp;images</source><translation>Encuadrar las &amp;imágenes</translation></message>
<message><source>box of %1 × %2 cells: %3 points, %4 edge cells</source><translation>recuadro de %1 × %2 celdas: %3 puntos, %4 celdas de borde</translation></message>
<message><source>, ranges %1 to %2 m</source><translation>, distancias de %1 a %2 m</translation></message>
<message><source>%1: it failed (%2); close other programs or use a smaller scan.</source><translation>%1: falló (%2); cierre otros programas o use un escaneo más pequeño.</translation></message>
<message><source>the edges could not be computed (%1); close other programs or open a smaller scan.</source><translation>no se pudieron calcular los bordes (%1); cierre otros programas o abra un escaneo más pequeño.</translation></message>
<message><source>Opening %1</source><translation>Abriendo %1</translation></message>
<message><source>Making the demo draw-bell</source><translation>Creando la campana de demostración</translation></message>
<message><source>Saving %1</source><translation>Guardando %1</translation></message>
<message><source>writing</source><translation>escribiendo</translation></message>
<message><source>being cancelled</source><translation>cancelando</translation></message>
<message><source>opened</source><translation>abierto</translation></message>
<message><source>reading</source><translation>lectura</translation></message>
<message><source>unpacking</source><translation>descompresión</translation></message>
<message><source>grid</source><translation>cuadrícula</translation></message>
<message><source>placing the points</source><translation>colocación de los puntos</translation></message>
<message><source>finding edges</source><translation>búsqueda de aristas</translation></message>
<message><source>drawing</source><translation>dibujo</translation></message>
<message><source>Menu</source><translation>Menú</translation></message>
<message><source>Connect</source><translation>Conectar</translation></message>
<message><source>Hold to leave</source><translation>Mantener: salir</translation></message>
<message><source>Hold for one second to leave cab mode</source><translation>Mantener un segundo para salir del modo cabina</translation></message>
<message><source>End of the menu</source><translation>Fin del menú</translation></message>
<message><source>Delete the last letter</source><translation>Borrar la última letra</translation></message>
<message><source>Enter</source><translation>Intro</translation></message>
<message><source>Close the keys</source><translation>Cerrar las teclas</translation></message>
<message><source>Capital letter</source><translation>Mayúscula</translation></message>
<message><source>Space</source><translation>Espacio</translation></message>
<message><source>+ edges gained</source><translation>+ bordes ganados</translation></message>
<message><source>− edges lost</source><translation>− bordes perdidos</translation></message>
<message><source>edges kept</source><translation>bordes que siguen</translation></message>
<message><source>? edges not seen</source><translation>? bordes no vistos</translation></message>
<message><source>surface nearer</source><translation>superficie más cerca</translation></message>
<message><source>surface farther</source><translation>superficie más lejos</translation></message>
<message><source>A has %1 edge cells: %2 lost, %3 next to edges of B, %4 without a point of B</source><translation>A tiene %1 celdas de borde: %2 perdidas, %3 junto a bordes de B, %4 sin punto de B</translation></message>
<message><source>B has %1 edge cells: %2 gained, %3 kept, %4 without a point of A</source><translation>B tiene %1 celdas de borde: %2 nuevas, %3 conservadas, %4 sin punto de A</translation></message>
<message><source>▲ OUT OF SPEC</source><translation>▲ FUERA DE TOLERANCIA</translation></message>
<message><source>colour by distance from A</source><translation>color según la distancia a A</translation></message>
<message><source>cells</source><translation>celdas</translation></message>
<message><source>Other points have the colours of rocks</source><translation>Los demás puntos tienen los colores de las rocas</translation></message>
<message><source>Previous changed region</source><translation>Región cambiada anterior</translation></message>
<message><source>Next changed region</source><translation>Siguiente región cambiada</translation></message>
<message><source>End</source><translation>Terminar</translation></message>
<message><source>Ends the comparison: A is forgotten</source><translation>Termina la comparación: se olvida A</translation></message>
<message><source>Shows A; hold \ for a short look</source><translation>Muestra A; mantenga \ para verla un momento</translation></message>
<message><source>Difference</source><translation>Diferencia</translation></message>
<message><source>Shows B with what changed since A</source><translation>Muestra B con lo que cambió desde A</translation></message>
<message><source>Shows B alone</source><translation>Muestra solo B</translation></message>
<message><source>comparing …</source><translation>comparando …</translation></message>
<message><source>comparing …
Gray counts are older.</source><translation>comparando …
Las cifras grises son anteriores.</translation></message>
<message><source>not compared with the scan on the screen</source><translation>sin comparar con el escaneo en pantalla</translation></message>
<message><source>nothing to compare with yet:
change a setting, or open another scan</source><translation>nada con qué comparar todavía:
cambie un ajuste o abra otro escaneo</translation></message>
<message><source>median difference along the beams %1 mm
a change is more than %2 mm at 5 m</source><translation>diferencia mediana a lo largo de los haces %1 mm
un cambio supera %2 mm a 5 m</translation></message>
<message><source>median distance to the points of A %1
%2 are farther than %3</source><translation>distancia mediana a los puntos de A %1
%2 están a más de %3</translation></message>
<message><source>Next</source><translation>Siguiente</translation></message>
<message><source>Folds the legend</source><translation>Pliega la leyenda</translation></message>
<message><source>Unfolds the legend</source><translation>Despliega la leyenda</translation></message>
<message><source>Changes: %1</source><translation>Cambios: %1</translation></message>
<message><source>A, after: %1</source><translation>A, después: %1</translation></message>
<message><source>A, before: %1</source><translation>A, antes: %1</translation></message>
<message><source>B, before: %1</source><translation>B, antes: %1</translation></message>
<message><source>B, after: %1</source><translation>B, después: %1</translation></message>
<message><source>A: %1</source><translation>A: %1</translation></message>
<message><source>at all of them</source><translation>con todos</translation></message>
<message><source>below %1 %</source><translation>menos de %1 %</translation></message>
<message><source>%1 % and more</source><translation>%1 % y más</translation></message>
<message><source>Confidence of edges</source><translation>Confianza de los bordes</translation></message>
<message><source>Edges that fewer of the nearby settings find are left out of the views. Exports have all of them.</source><translation>Los bordes que hallan menos ajustes cercanos se omiten en las vistas; las exportaciones los contienen todos.</translation></message>
<message><source>Least confidence shown</source><translation>Confianza mínima mostrada</translation></message>
<message><source>Shown: %1 % and more</source><translation>Se muestra: %1 % y más</translation></message>
<message><source>Shown: all</source><translation>Se muestra: todo</translation></message>
<message><source>computing: %1 %</source><translation>calculando: %1 %</translation></message>
<message><source>share of %1 nearby settings that find the edge</source><translation>parte de los %1 ajustes próximos que encuentran el borde</translation></message>
<message><source>No command has these words, or it cannot be used now.</source><translation>Ningún comando tiene estas palabras, o no se puede usar ahora.</translation></message>
<message><source>Commands</source><translation>Comandos</translation></message>
<message><source>A few letters of a command</source><translation>Algunas letras de un comando</translation></message>
<message><source>For the program that will read it</source><translation>Para el programa que lo leerá</translation></message>
<message><source>Only what is selected (%1 cells)</source><translation>Solo lo seleccionado (%1 celdas)</translation></message>
<message><source>Also the points that lie behind the nearest of their cell (%1 in the scan)</source><translation>También los puntos situados detrás del más cercano de su celda (%1 en el escaneo)</translation></message>
<message><source>Choose File…</source><translation>Elegir archivo…</translation></message>
<message><source>What</source><translation>Contenido</translation></message>
<message><source>It draws edge lines: choose the edge points above.</source><translation>Dibuja líneas de bordes: elija arriba los puntos de borde.</translation></message>
<message><source>Targets are written as a table or a drawing.</source><translation>Los objetivos se escriben como tabla o dibujo.</translation></message>
<message><source>The file holds x, y and z in metres from the scanner.</source><translation>El archivo contiene x, y y z en metros desde el escáner.</translation></message>
<message><source>The file holds metres from E %1, N %2, RL %3: a program that does not add these shows small numbers.</source><translation>El archivo contiene metros desde E %1, N %2, RL %3: un programa que no los suma muestra números pequeños.</translation></message>
<message><source>The file holds Easting, Northing and RL in metres.</source><translation>El archivo contiene las coordenadas este y norte y el RL en metros.</translation></message>
<message><source>Choose local metres for %1: numbers of 4 bytes would round them to steps of %2 mm.</source><translation>Elija metros locales para %1: los números de 4 bytes los redondearían a pasos de %2 mm.</translation></message>
<message><source>Numbers count from the scanner, along its own axes.</source><translation>Los números cuentan desde el escáner, a lo largo de sus propios ejes.</translation></message>
<message><source>Small numbers: metres east, north and up from an origin near the scan. To get mine coordinates, add the origin, which is in the header or in the record of the file.</source><translation>Números pequeños: metros al este, al norte y hacia arriba desde un origen cercano al escaneo. Para tener coordenadas de mina, sume el origen, que está en el encabezado o en el registro del archivo.</translation></message>
<message><source>Each point has its whole Easting, Northing and RL, as on the plans of the mine.</source><translation>Cada punto tiene su Este, Norte y RL completos, como en los planos de la mina.</translation></message>
<message><source>The column elevation_m is the RL.</source><translation>La columna elevation_m es la RL.</translation></message>
<message><source>The file holds metres from an origin near the scan, because %1 programs round mine coordinates. EdgeScan adds the origin of the header when it opens the file; other programs show the small numbers.</source><translation>El archivo contiene metros desde un origen cerca del escaneo, porque los programas de %1 redondean las coordenadas de mina. EdgeScan suma el origen de la cabecera al abrir el archivo; otros programas muestran los números pequeños.</translation></message>
<message><source>Coordinates</source><translation>Coordenadas</translation></message>
<message><source>Mine grid: Easting, Northing, RL</source><translation>Coordenadas de la mina: E, N, RL</translation></message>
<message><source>Local metres from an origin in the mine grid</source><translation>Metros locales desde un origen en coordenadas de la mina</translation></message>
<message><source>Scanner frame, as measured</source><translation>Sistema del escáner, tal como se midió</translation></message>
<message><source>No mine grid: %1. Scan &gt; Pose and Mounting takes a pose and a calibration.</source><translation>Sin coordenadas mina: %1. Escaneo &gt; Pose y montaje acepta una pose y una calibración.</translation></message>
<message><source>%1 × %2 pixels</source><translation>%1 × %2 píxeles</translation></message>
<message><source>Lines through %1 edge points will be saved.</source><translation>Se guardarán líneas que pasan por %1 puntos de borde.</translation></message>
<message><source>%1 points will be saved.</source><translation>Se guardarán %1 puntos.</translation></message>
<message><source>%1 will be saved.</source><translation>Se guardará: %1.</translation></message>
<message><source>%1 cells will be saved.</source><translation>Se guardarán %1 celdas.</translation></message>
<message><source>doubtful</source><translation>dudoso</translation></message>
<message><source>detected</source><translation>deducido</translation></message>
<message><source>assumed</source><translation>supuesto</translation></message>
<message><source>given by you</source><translation>como se indicó</translation></message>
<message><source>from the file</source><translation>según el archivo</translation></message>
<message><source>Does This Look Right?</source><translation>¿Parece correcto?</translation></message>
<message><source>&amp;Close</source><translation>&amp;Cerrar</translation></message>
<message><source>&amp;Adopt</source><translation>&amp;Adoptar</translation></message>
<message><source>or</source><translation>o</translation></message>
<message><source>%1: there is no other way to read it.</source><translation>%1: no hay otra forma de leerlo.</translation></message>
<message><source>%1: something contradicts how it was read.</source><translation>%1: algo contradice cómo se leyó.</translation></message>
<message><source>%1: assumed (%2), and the scan itself does not contradict it.</source><translation>%1: supuesto (%2), y el propio escaneo no lo contradice.</translation></message>
<message><source>%1: nothing contradicts how it was read.</source><translation>%1: nada contradice cómo se leyó.</translation></message>
<message><source>Click another reading to see the scan read that way. Adopt takes it, and Ctrl+Z undoes that. Close restores the former reading.</source><translation>Haga clic en otra lectura para ver el escaneo leído así. Adoptar la toma, y Ctrl+Z lo deshace. Cerrar restaura la lectura anterior.</translation></message>
<message><source>grid north</source><translation>norte de la cuadrícula</translation></message>
<message><source>true north</source><translation>norte verdadero</translation></message>
<message><source>the vertical</source><translation>la vertical</translation></message>
<message><source>the robot's z axis</source><translation>el eje z del robot</translation></message>
<message><source>forward</source><translation>hacia delante</translation></message>
<message><source>up</source><translation>hacia arriba</translation></message>
<message><source>down</source><translation>hacia abajo</translation></message>
<message><source>by three angles</source><translation>según tres ángulos</translation></message>
<message><source>by nine numbers</source><translation>según nueve números</translation></message>
<message><source>two elevations</source><translation>dos elevaciones</translation></message>
<message><source>pitch and roll</source><translation>cabeceo y alabeo</translation></message>
<message><source>Pose and Mounting</source><translation>Pose y montaje</translation></message>
<message><source>Mounting</source><translation>Montaje</translation></message>
<message><source>&amp;Store with the Scan</source><translation>&amp;Guardar con el escaneo</translation></message>
<message><source>&amp;Remove Pose</source><translation>&amp;Quitar la pose</translation></message>
<message><source>&amp;Fill In</source><translation>&amp;Rellenar</translation></message>
<message><source>A line of the survey: point, E, N, RL, and heading, pitch and roll if it has them. E is easting, N northing, RL the height above the mine's zero: a higher place has a larger RL.</source><translation>Una línea del levantamiento: punto, E, N, RL, y rumbo, cabeceo y alabeo si los tiene. E es la coordenada este, N la norte, RL la altura sobre el cero de la mina: un lugar más alto tiene un RL mayor.</translation></message>
<message><source>How the scanner is mounted, under a name for the next scan. An empty field has the value shown in it.</source><translation>Cómo está montado el escáner, con un nombre para el próximo escaneo. Un campo vacío tiene el valor que muestra.</translation></message>
<message><source>Store &amp;As…</source><translation>Guardar &amp;como…</translation></message>
<message><source>For&amp;get</source><translation>&amp;Olvidar</translation></message>
<message><source>From Fi&amp;le…</source><translation>De un &amp;archivo…</translation></message>
<message><source>✕ missing</source><translation>✕ falta</translation></message>
<message><source>Nominal mounting</source><translation>Montaje nominal</translation></message>
<message><source>Settings for these marks</source><translation>Ajustes para estas marcas</translation></message>
<message><source>Click a row to see it. Adopt takes it. Close restores the former settings.</source><translation>Haga clic en una fila para verla. Adoptar la toma. Cerrar restaura los ajustes anteriores.</translation></message>
<message><source>Range gate</source><translation>Ventana de distancia</translation></message>
<message><source>Draw cells from</source><translation>Dibujar celdas desde</translation></message>
<message><source>to</source><translation>hasta</translation></message>
<message><source>All others are hidden in all views. Edges, counts and exports stay as they are.</source><translation>Todas las demás se ocultan en todas las vistas. Bordes, cuentas y exportaciones quedan como están.</translation></message>
<message><source>An empty field: from the file, or detected. The file itself is not changed.</source><translation>Un campo vacío: según el archivo, o detectado. El archivo mismo no se modifica.</translation></message>
<message><source>Read Again</source><translation>Leer de nuevo</translation></message>
<message><source>as in the file</source><translation>como en el archivo</translation></message>
<message><source>Choose…</source><translation>Elegir…</translation></message>
<message><source>in the report</source><translation>en el informe</translation></message>
<message><source>HTML: a page for any browser</source><translation>HTML: una página para cualquier navegador</translation></message>
<message><source>PDF: pages to print and to file</source><translation>PDF: páginas para imprimir y archivar</translation></message>
<message><source>Author</source><translation>Autor</translation></message>
<message><source>Logo (PNG)</source><translation>Logotipo (PNG)</translation></message>
<message><source>SHA-256</source><translation>SHA-256</translation></message>
<message><source>Scan lines</source><translation>Líneas de escaneo</translation></message>
<message><source>Beams</source><translation>Haces</translation></message>
<message><source>Cells</source><translation>Celdas</translation></message>
<message><source>with a range</source><translation>con distancia</translation></message>
<message><source>Ranges [m]</source><translation>Distancias [m]</translation></message>
<message><source>smallest</source><translation>la menor</translation></message>
<message><source>largest</source><translation>la mayor</translation></message>
<message><source>Unit of the file [mm]</source><translation>Unidad del archivo [mm]</translation></message>
<message><source>Geometry</source><translation>Geometría</translation></message>
<message><source>Mounting of the stepper</source><translation>Montaje del motor paso a paso</translation></message>
<message><source>Beam angles [°]</source><translation>Ángulos de los haces [°]</translation></message>
<message><source>Line angles [°]</source><translation>Ángulos de las líneas [°]</translation></message>
<message><source>Intensity</source><translation>Intensidad</translation></message>
<message><source>Maker</source><translation>Fabricante</translation></message>
<message><source>Model</source><translation>Modelo</translation></message>
<message><source>Serial number</source><translation>Número de serie</translation></message>
<message><source>Firmware</source><translation>Firmware</translation></message>
<message><source>Begin (UTC)</source><translation>Inicio (UTC)</translation></message>
<message><source>End (UTC)</source><translation>Fin (UTC)</translation></message>
<message><source>Clock</source><translation>Reloj</translation></message>
<message><source>Window of the scanner</source><translation>Ventana del escáner</translation></message>
<message><source>Echo filter</source><translation>Filtro de ecos</translation></message>
<message><source>Lines of the sweep</source><translation>Líneas del barrido</translation></message>
<message><source>first</source><translation>primera</translation></message>
<message><source>last</source><translation>última</translation></message>
<message><source>number</source><translation>número</translation></message>
<message><source>step</source><translation>paso</translation></message>
<message><source>uneven</source><translation>desigual</translation></message>
<message><source>Direction of the stepper</source><translation>Sentido del motor</translation></message>
<message><source>Points behind others</source><translation>Puntos detrás de otros</translation></message>
<message><source>Points of the list</source><translation>Puntos de la lista</translation></message>
<message><source>in the file</source><translation>en el archivo</translation></message>
<message><source>without a cell</source><translation>sin celda</translation></message>
<message><source>Scanner at [m]</source><translation>Escáner en [m]</translation></message>
<message><source>Origin E, N, RL [m]</source><translation>Origen E, N, RL [m]</translation></message>
<message><source>Source</source><translation>Origen</translation></message>
<message><source>Begin of the scan</source><translation>Inicio del escaneo</translation></message>
<message><source>End of the scan</source><translation>Fin del escaneo</translation></message>
<message><source>Time of the pose</source><translation>Hora de la pose</translation></message>
<message><source>Age of the pose [s]</source><translation>Edad de la pose [s]</translation></message>
<message><source>Out of spec</source><translation>Fuera de tolerancias</translation></message>
<message><source>Poses</source><translation>Poses</translation></message>
<message><source>Boom</source><translation>Pluma</translation></message>
<message><source>Pivot [m]</source><translation>Pivote [m]</translation></message>
<message><source>Head [m]</source><translation>Cabeza [m]</translation></message>
<message><source>scanner</source><translation>escáner</translation></message>
<message><source>beam x line angles</source><translation>ángulos de haces x líneas</translation></message>
<message><source>organised points</source><translation>puntos organizados</translation></message>
<message><source>spin</source><translation>spin</translation></message>
<message><source>sweep</source><translation>sweep</translation></message>
<message><source>yes</source><translation>sí</translation></message>
<message><source>no</source><translation>no</translation></message>
<message><source>and %1 more</source><translation>y %1 más</translation></message>
<message><source>&lt;h3&gt;Mouse in the cloud&lt;/h3&gt;Left drag turns, middle drag or Shift+left drag pans, right drag or wheel zooms, Ctrl+left drag rolls; double-click or middle click sets the centre of rotation; Alt+wheel point size, Ctrl+wheel near clip, Ctrl+Shift+wheel far clip.&lt;h3&gt;Mouse in the images&lt;/h3&gt;Left or middle drag pans, wheel zooms, right drag changes the display levels, double-click fits; Shift+drag looks closer.&lt;h3&gt;Mouse in all views&lt;/h3&gt;A click pins a target; while rocks are shown, it selects the rock there, and Shift+click pins. Ctrl+click selects one more rock. A right click opens the menu of the cell.</source><translation>&lt;h3&gt;Mouse en la nube de puntos&lt;/h3&gt;Arrastrar con el izquierdo gira, con el central o Mayús+izquierdo desplaza, con el derecho o la rueda acerca y aleja, Ctrl+izquierdo inclina; doble clic o clic central fija el centro de rotación; Alt+rueda tamaño de los puntos, Ctrl+rueda plano de corte cercano, Ctrl+Mayús+rueda plano de corte lejano.&lt;h3&gt;Mouse en las imágenes&lt;/h3&gt;Arrastrar con el izquierdo o el central desplaza, la rueda acerca y aleja, arrastrar con el derecho cambia los niveles mostrados, doble clic ajusta; Mayús+arrastrar mira de cerca.&lt;h3&gt;Mouse en todas las vistas&lt;/h3&gt;Un clic fija un objetivo; mientras se muestran las rocas, selecciona la roca que está ahí, y Mayús+clic fija. Ctrl+clic selecciona una roca más. Un clic derecho abre el menú de la celda.</translation></message>
<message><source>Keys</source><translation>Teclas</translation></message>
<message><source>Keys and mouse</source><translation>Teclado y mouse</translation></message>
<message><source>Scan</source><translation>Escaneo</translation></message>
<message><source>About EdgeScan</source><translation>Acerca de EdgeScan</translation></message>
<message><source>&lt;h3&gt;EdgeScan %1&lt;/h3&gt;Finds the edges of rocks in a laser range scan and shows them in the cloud.&lt;br&gt;It shows geometry from one viewpoint. It does not judge any rock.&lt;br&gt;&lt;br&gt;Licence: BSD-3-Clause&lt;br&gt;Drawn by %2</source><translation>&lt;h3&gt;EdgeScan %1&lt;/h3&gt;Encuentra los bordes de las rocas en un escaneo láser de distancias y los muestra en la nube de puntos.&lt;br&gt;Lo que muestra es geometría vista desde un solo punto; no es un juicio sobre ninguna roca.&lt;br&gt;&lt;br&gt;Licencia: BSD-3-Clause&lt;br&gt;Dibujado por %2</translation></message>
<message><source>along the line</source><translation>a lo largo de la línea</translation></message>
<message><source>across the lines</source><translation>a través de las líneas</translation></message>
<message><source>%1: %2 m wide, %3 m deep (drawn × %4), near is below</source><translation>%1: %2 m de ancho, %3 m de fondo (dibujado × %4), lo cercano está abajo</translation></message>
<message><source>; ▲ ▼: points beyond it</source><translation>; ▲ ▼: puntos más allá</translation></message>
<message><source>Numbers</source><translation>Números</translation></message>
<message><source>Why the edge %1 cells away?</source><translation>¿Por qué el borde a %1 celdas?</translation></message>
<message><source>More</source><translation>Más</translation></message>
<message><source>Why is this cell an edge or not?</source><translation>¿Por qué esta celda es un borde, o no?</translation></message>
<message><source>The points across the cell, and a line through the nearest of either side.</source><translation>Los puntos a través de la celda, y una recta por los más cercanos de cada lado.</translation></message>
<message><source>The verdict in the method's terms, the points across the cell, and the numbers</source><translation>El veredicto en los términos del método, los puntos a través de la celda y los números</translation></message>
<message><source>Less</source><translation>Menos</translation></message>
<message><source>Why the edge next to it?</source><translation>¿Por qué el borde de al lado?</translation></message>
<message><source>stones boulders fragments sizes</source><translation>piedras bloques bolos fragmentos tamaños</translation></message>
<message><source>export csv table list of rocks dxf outlines</source><translation>exportar csv tabla lista de rocas dxf contornos</translation></message>
<message><source>wider widest biggest boulder oversize</source><translation>más ancha mayor bolo sobretamaño</translation></message>
<message><source>export csv table edge list points</source><translation>exportar csv tabla lista de bordes puntos</translation></message>
<message><source>export csv table all points las</source><translation>exportar csv tabla todos los puntos las</translation></message>
<message><source>export csv table pins measurements</source><translation>exportar csv tabla marcas medidas</translation></message>
<message><source>print pdf paper page</source><translation>imprimir pdf papel página</translation></message>
<message><source>picture image of the window</source><translation>imagen captura de la ventana</translation></message>
<message><source>refresh read again</source><translation>actualizar leer de nuevo</translation></message>
<message><source>compare before after change difference</source><translation>comparar antes después cambio diferencia</translation></message>
<message><source>off</source><translation>desactivado</translation></message>
<message><source>on</source><translation>activado</translation></message>
<message><source>Add a Scan as a Layer…</source><translation>Añadir un escaneo como capa…</translation></message>
<message><source>Remove</source><translation>Quitar</translation></message>
<message><source>Place by Targets</source><translation>Colocar por objetivos</translation></message>
<message><source>Shows the image and the edges of this scan; the others stay in the cloud</source><translation>Muestra la imagen y los bordes de este escaneo; los demás quedan en la nube</translation></message>
<message><source>Pin the same three places in both scans as targets with the same numbers: they bring the layer to its place</source><translation>Marque los mismos tres lugares en ambos escaneos como objetivos con los mismos números: llevan la capa a su sitio</translation></message>
<message><source>ANOTHER PICTURE</source><translation>OTRA IMAGEN</translation></message>
<message><source>CONNECTED, another picture is shown</source><translation>CONECTADO, se muestra otra imagen</translation></message>
<message><source>now sweep %1: %2</source><translation>ahora barrido %1: %2</translation></message>
<message><source>sweep %1: %2</source><translation>barrido %1: %2</translation></message>
<message><source>Lines whose telegrams did not arrive: dashes in the images</source><translation>Líneas cuyos telegramas no llegaron: guiones en las imágenes</translation></message>
<message><source>Port</source><translation>Puerto</translation></message>
<message><source>EdgeScan sends only read requests and one subscription to the scanner</source><translation>Al escáner solo se le envían lecturas y una suscripción</translation></message>
<message><source>Record</source><translation>Grabar</translation></message>
<message><source>Write every telegram to a new file, unchanged, as it arrives</source><translation>Escribir cada telegrama en un archivo nuevo, sin tocarlo, a medida que llega</translation></message>
<message><source>Keep last minute</source><translation>Conservar el último minuto</translation></message>
<message><source>Write what arrived during the last minute to a new file</source><translation>Escribir en un archivo nuevo lo que llegó durante el último minuto</translation></message>
<message><source>Hold</source><translation>Retener</translation></message>
<message><source>The picture stays as it is while the scanner goes on.</source><translation>La imagen queda como está mientras el escáner continúa.</translation></message>
<message><source>Follow</source><translation>Seguir</translation></message>
<message><source>The picture grows with the scanner.</source><translation>La imagen crece con el escáner.</translation></message>
<message><source>scanner, or ws://ROBOT</source><translation>escáner, o ws://ROBOT</translation></message>
<message><source>Name or address of the scanner; ws://ROBOT is a robot with ROS on which foxglove_bridge runs</source><translation>Nombre o dirección del escáner; ws://ROBOT es un robot con ROS en el que funciona foxglove_bridge</translation></message>
<message><source>Name or address of the scanner</source><translation>Nombre o dirección del escáner</translation></message>
<message><source>Port of the scanner</source><translation>Puerto del escáner</translation></message>
<message><source>Sweep…</source><translation>Barrido…</translation></message>
<message><source>Lines of a sweep, step per line, mounting</source><translation>Líneas de un barrido, paso por línea, montaje</translation></message>
<message><source>Stop</source><translation>Detener</translation></message>
<message><source>Stop recording</source><translation>Detener la grabación</translation></message>
<message><source>Show another sweep…</source><translation>Mostrar otro barrido…</translation></message>
<message><source>Show %1</source><translation>Mostrar: %1</translation></message>
<message><source>%1 is written, but the disk has not confirmed the last %2 kB: keep the power on until it is idle.</source><translation>%1 está escrito, pero el disco no ha confirmado los últimos %2 kB: no corte la alimentación hasta que esté inactivo.</translation></message>
<message><source>Lines of the sweep. A red mark is a line that did not arrive.</source><translation>Líneas del barrido; una marca roja es una línea que nunca llegó</translation></message>
<message><source>not known</source><translation>desconocido</translation></message>
<message><source>not known (%1° assumed)</source><translation>no se sabe (%1° supuesto)</translation></message>
<message><source>Does not turn while a line is measured</source><translation>Se detiene mientras se mide una línea</translation></message>
<message><source>Where the stepper begins. The cloud turns with it, its shape is the same.</source><translation>Donde empieza el motor. La nube gira con él, su forma es la misma.</translation></message>
<message><source>0: no encoder; the lines are placed by the stepper's step</source><translation>0: sin encoder; las líneas se ubican según el paso del motor</translation></message>
<message><source>spin: like a wheel, about its viewing direction</source><translation>spin: como una rueda, en torno a su dirección de visión</translation></message>
<message><source>sweep: nodding, about the line from beam 0° to 180°</source><translation>sweep: cabeceando, en torno a la línea del haz 0° al 180°</translation></message>
<message><source>The numbers are in the stepper's program or data sheet. Leave out what you do not know.</source><translation>Los números están en el programa o la ficha técnica del motor paso a paso. Deje lo que no sepa.</translation></message>
<message><source>The scanner turns</source><translation>El escáner gira</translation></message>
<message><source>Lines of a whole sweep</source><translation>Líneas de un barrido completo</translation></message>
<message><source>Turn of a whole sweep</source><translation>Giro de un barrido entero</translation></message>
<message><source>Step per line</source><translation>Paso por línea</translation></message>
<message><source>Angle of the first line</source><translation>Ángulo de la primera línea</translation></message>
<message><source>Encoder counts per degree</source><translation>Cuentas del encoder por grado</translation></message>
<message><source>not known (spin assumed until the ranges show it)</source><translation>no se sabe (spin supuesto hasta que las distancias lo muestren)</translation></message>
<message><source>not known (the ranges show spin)</source><translation>no se sabe (las distancias muestran spin)</translation></message>
<message><source>not known (the ranges show sweep)</source><translation>no se sabe (las distancias muestran sweep)</translation></message>
<message><source>needs the number of lines</source><translation>requiere el número de líneas</translation></message>
<message><source>Play</source><translation>Reproducir</translation></message>
<message><source>Space plays and pauses; Left and Right step by a line, with Shift by ten</source><translation>Espacio reproduce y pausa; Izquierda y Derecha avanzan una línea, con Mayús diez</translation></message>
<message><source>RECORDED · line %2/%3 at %1</source><translation>GRABADO · línea %2/%3 a %1</translation></message>
<message><source> · recorded sweep %1 of %2</source><translation> · barrido grabado %1 de %2</translation></message>
<message><source>Pause</source><translation>Pausar</translation></message>
<message><source>%1; messages: %2, per second: %3</source><translation>%1; mensajes: %2, por segundo: %3</translation></message>
<message><source>Topics…</source><translation>Tópicos…</translation></message>
<message><source>What the robot offers, and which laser the scan comes from</source><translation>Lo que ofrece el robot, y de qué láser viene el escaneo</translation></message>
<message><source>The robot has not offered a topic yet.</source><translation>El robot aún no ha ofrecido ningún tópico.</translation></message>
<message><source>clouds of %1 points</source><translation>nubes de %1 puntos</translation></message>
<message><source>clouds of a scanner</source><translation>nubes de un escáner</translation></message>
<message><source>lines of %1 beams</source><translation>líneas de %1 haces</translation></message>
<message><source>lines of a laser</source><translation>líneas de un láser</translation></message>
<message><source>Angle of each line</source><translation>Ángulo de cada línea</translation></message>
<message><source>from the transforms, or from the joint that turned furthest</source><translation>según las transformaciones, o la articulación que más giró</translation></message>
<message><source>from the joint %1</source><translation>según la articulación %1</translation></message>
<message><source>Topics that are not used: %1</source><translation>Tópicos que no se usan: %1</translation></message>
<message><source>A part of rock %1 (%2 cells) is not shown as a rock: </source><translation>Una parte de la roca %1 (%2 celdas) no se muestra como roca: </translation></message>
<message><source>it is smaller than “Smallest rock” (%1 cells). Lower that number to see it.</source><translation>es menor que «Roca más pequeña» (%1 celdas). Baje ese número para verla.</translation></message>
<message><source>it is outside the region of interest. Clear the region to see it.</source><translation>está fuera de la región de interés. Borre la región para verla.</translation></message>
<message><source>its confidence is %1, and a rock needs %2. Click it and choose “Not a Rock, or a Rock Again” to show it.</source><translation>su confianza es %1, y una roca necesita %2. Haga clic en ella y elija «No es roca, o sí lo es» para mostrarla.</translation></message>
<message><source>it is behind “Farthest rock” (%1 m). Raise that number to see it.</source><translation>está más allá de «Roca más lejana» (%1 m). Suba ese número para verla.</translation></message>
<message><source>it looks like a wall. Click it and choose “Not a Rock, or a Rock Again” to show it.</source><translation>parece una pared. Haga clic en ella y elija «No es roca, o sí lo es» para mostrarla.</translation></message>
<message><source>Merged: rocks %1 are rock %2 now.</source><translation>Fusionadas: las rocas %1 son ahora la roca %2.</translation></message>
<message><source>Cut: rock %1 is now rocks %2.</source><translation>Cortada: la roca %1 es ahora las rocas %2.</translation></message>
<message><source>Split: rock %1 is now rocks %2.</source><translation>Dividida: la roca %1 es ahora las rocas %2.</translation></message>
<message><source>Rocks %1 and %2 do not touch: their nearest cells are %3 m apart.</source><translation>Las rocas %1 y %2 no se tocan: sus celdas más próximas están a %3 m una de otra.</translation></message>
<message><source>Rock %1 and a part that was not a rock do not touch: their nearest cells are %2 m apart.</source><translation>La roca %1 y una parte que no era una roca no se tocan: sus celdas más próximas están a %2 m una de otra.</translation></message>
<message><source>They are merged as rock %1.</source><translation>Están fusionadas como roca %1.</translation></message>
<message><source>at least %1</source><translation>al menos %1</translation></message>
<message><source>something that is not a rock</source><translation>algo que no es una roca</translation></message>
<message><source>none seen</source><translation>nada a la vista</translation></message>
<message><source>at least 1: rock %1</source><translation>al menos 1: roca %1</translation></message>
<message><source>at least %1: rocks %2</source><translation>al menos %1: rocas %2</translation></message>
<message><source>, between rocks %1 and %2</source><translation>, entre las rocas %1 y %2</translation></message>
<message><source>, hangs below</source><translation>, cuelga por debajo</translation></message>
<message><source>nothing was measured here, or no piece fits</source><translation>aquí no se midió nada, o ningún trozo corresponde</translation></message>
<message><source>fines: too few cells to be shown as a rock</source><translation>finos: muy pocas celdas para mostrarlos como una roca</translation></message>
<message><source>outside the region of interest</source><translation>fuera de la región de interés</translation></message>
<message><source>marked by hand as not a rock</source><translation>marcada a mano como no roca</translation></message>
<message><source>too uncertain to be shown as a rock</source><translation>demasiado incierto para mostrarse como roca</translation></message>
<message><source>wall, floor, or too far away</source><translation>pared, piso, o demasiado lejos</translation></message>
<message><source>Name…</source><translation>Nombre…</translation></message>
<message><source>Section</source><translation>Sección</translation></message>
<message><source>Split</source><translation>Dividir</translation></message>
<message><source>Cut</source><translation>Cortar</translation></message>
<message><source>Merge</source><translation>Fusionar</translation></message>
<message><source>Not a Rock</source><translation>No es roca</translation></message>
<message><source>Deselect this rock</source><translation>Deseleccionar esta roca</translation></message>
<message><source>Hidden parts are not counted.</source><translation>Las partes ocultas no se cuentan.</translation></message>
<message><source>Then click the part of the rock that is a rock of its own; the wheel takes a smaller or a larger part (S)</source><translation>Luego haga clic en la parte de la roca que es una roca aparte; la rueda toma una parte más pequeña o más grande (S)</translation></message>
<message><source>Then draw a line through the rock, from one side to the other (X)</source><translation>Después trace una línea a través de la roca, de un lado al otro (X)</translation></message>
<message><source>A target on this rock holds its name (F2)</source><translation>Un objetivo en esta roca lleva su nombre (F2)</translation></message>
<message><source>The vertical plane through the rock, along its longest visible width</source><translation>El plano vertical por la roca, a lo largo de su mayor anchura visible</translation></message>
<message><source>The selected rocks are one; Ctrl+click selects several (M)</source><translation>Las rocas seleccionadas son una sola; Ctrl+clic selecciona varias (M)</translation></message>
<message><source>%1, and %2 more selected</source><translation>%1, y %2 más seleccionadas</translation></message>
<message><source>▲ uncertain outline: hatched</source><translation>▲ contorno incierto: rayado</translation></message>
<message><source>may be one with %1: Merge joins them</source><translation>puede ser una sola con %1: Fusionar las junta</translation></message>
<message><source>a rock by hand: marked or cut</source><translation>una roca a mano: marcada o cortada</translation></message>
<message><source>A Rock</source><translation>Es roca</translation></message>
<message><source>This is a wall, a floor or something else (N)</source><translation>Esto es una pared, un piso u otra cosa (N)</translation></message>
<message><source>This is a rock (N)</source><translation>Sí es una roca (N)</translation></message>
<message><source>Rock %1</source><translation>Roca %1</translation></message>
<message><source>visible spans a × b</source><translation>extensiones visibles a × b</translation></message>
<message><source>distance, median</source><translation>distancia, mediana</translation></message>
<message><source>visible area</source><translation>área visible</translation></message>
<message><source>%1 m²</source><translation>%1 m²</translation></message>
<message><source>in front</source><translation>delante</translation></message>
<message><source>%1 % of its outline</source><translation>%1 % de su contorno</translation></message>
<message><source>behind rocks</source><translation>detrás de las rocas</translation></message>
<message><source>visible contacts</source><translation>contactos visibles</translation></message>
<message><source>free height below</source><translation>altura libre debajo</translation></message>
<message><source>arch angle</source><translation>ángulo del arco</translation></message>
<message><source>the scanner's z axis, assumed</source><translation>el eje z del escáner, supuesto</translation></message>
<message><source>confidence p</source><translation>confianza p</translation></message>
<message><source>pinned target</source><translation>objetivo fijado</translation></message>
<message><source>Not a rock</source><translation>No es roca</translation></message>
<message><source>because</source><translation>porque</translation></message>
<message><source>▲ %1 parts that do not touch, %2 m apart</source><translation>▲ %1 partes que no se tocan, a %2 m</translation></message>
<message><source>%1 and %2</source><translation>%1 y %2</translation></message>
<message><source>≈ may be one with %1</source><translation>≈ puede ser una sola con %1</translation></message>
<message><source>%1 · visible a × b: %2 × %3 m ± %4 m · at %5 m</source><translation>%1 · a × b visible: %2 × %3 m ± %4 m · a %5 m</translation></message>
<message><source> · ▲ uncertain outline</source><translation> · ▲ contorno incierto</translation></message>
<message><source>hide uncertain</source><translation>ocultar inciertas</translation></message>
<message><source>Export…</source><translation>Exportar…</translation></message>
<message><source>Rocks with a smaller visible width b are left out of the table, and in the views only their outline is drawn</source><translation>Las rocas de menor ancho visible b no están en la tabla, y en las vistas solo se dibuja su contorno</translation></message>
<message><source>b at least</source><translation>b al menos</translation></message>
<message><source>Rocks with a confidence p below 0.85, which are hatched, are left out of the table, and in the views only their outline is drawn</source><translation>Las rocas con una confianza p menor que 0,85, que están rayadas, no están en la tabla, y en las vistas solo se dibuja su contorno</translation></message>
<message><source>%1 of %2 rocks</source><translation>%1 de %2 rocas</translation></message>
<message><source>, %1 of them uncertain (hatched)</source><translation>, %1 de ellas inciertas (achuradas)</translation></message>
<message><source>&amp;Shown Rocks (%1)…</source><translation>&amp;Rocas mostradas (%1)…</translation></message>
<message><source>&amp;All Rocks (%1)…</source><translation>&amp;Todas las rocas (%1)…</translation></message>
<message><source>fine</source><translation>fino</translation></message>
<message><source>coarse</source><translation>grueso</translation></message>
<message><source>%1, %2 of them uncertain (hatched); %3 pieces too small to be a rock</source><translation>%1, %2 de ellas inciertas (achuradas); %3 trozos demasiado pequeños para ser una roca</translation></message>
<message><source>; %1 changed by hand</source><translation>; %1 cambiadas a mano</translation></message>
<message><source>; %1 pieces outside the region of interest are left out</source><translation>; se omiten %1 trozos fuera de la región de interés</translation></message>
<message><source>A click selects a rock (Ctrl+click one more); the tool Pin (P) sets a target (Shift+click).</source><translation>Un clic elige una roca (Ctrl+clic una más); la herramienta Fijar (P) fija un objetivo (Mayús+clic).</translation></message>
<message><source>▲ %1 % over %2 m</source><translation>▲ %1 % sobre %2 m</translation></message>
<message><source>Visible width b by count: P20 %1, P50 %2, P80 %3 (20, 50, 80 % of the rocks are not wider), largest %4 m%5. Hidden parts make this finer than the pile is, by 40 % and more.</source><translation>Ancho visible b por cantidad: P20 %1, P50 %2, P80 %3 (20, 50, 80 % de las rocas no son más anchas), la mayor %4 m%5. Las partes ocultas hacen que esto sea más fino que la pila, en 40 % y más.</translation></message>
<message><source>Size curve</source><translation>Curva granulométrica</translation></message>
<message><source>Visible width b by count: 50 % of the rocks are not wider than P50. Hidden parts make this finer than the pile is, by 40 % and more.</source><translation>Ancho visible b por cantidad: 50 % de las rocas no son más anchas que P50. Las partes ocultas hacen que esto sea más fino que la pila, en 40 % y más.</translation></message>
<message><source>%1 % of the rocks have a visible width of %2 m at most</source><translation>%1 % de las rocas tienen un ancho visible de %2 m como máximo</translation></message>
<message><source>no rocks to count</source><translation>ninguna roca que contar</translation></message>
<message><source>Export Section…</source><translation>Exportar la sección…</translation></message>
<message><source>Wheel: zoom; drag: move; two clicks: a length</source><translation>Rueda: zoom; arrastrar: mover; dos clics: una longitud</translation></message>
<message><source>Zoom in</source><translation>Acercar</translation></message>
<message><source>Zoom out</source><translation>Alejar</translation></message>
<message><source>Fit</source><translation>Encuadrar</translation></message>
<message><source>Zoom to what the section is about</source><translation>Encuadrar aquello de lo que trata la sección</translation></message>
<message><source>All</source><translation>Todo</translation></message>
<message><source>Zoom to all points of the section</source><translation>Encuadrar todos los puntos de la sección</translation></message>
<message><source>▲ This click is not on a line: click nearer to one.</source><translation>▲ Este clic no está en una línea: haga clic más cerca de una.</translation></message>
<message><source>Click on the other end of the length.</source><translation>Haga clic en el otro extremo de la longitud.</translation></message>
<message><source>This length is stored with the measurements. Two more clicks measure another.</source><translation>Esta longitud está guardada con las mediciones. Dos clics más miden otra.</translation></message>
<message><source>Two clicks on the lines measure a length.</source><translation>Dos clics en las líneas miden una longitud.</translation></message>
<message><source>▲ %1 points are outside: All shows them.</source><translation>▲ %1 puntos quedan fuera: Todo los muestra.</translation></message>
<message><source>Edge points, green: %1.</source><translation>Puntos de borde, en verde: %1.</translation></message>
<message><source>along the section [m]</source><translation>a lo largo de la sección [m]</translation></message>
<message><source>✕ INCOMPLETE</source><translation>✕ INCOMPLETO</translation></message>
<message><source>Open a scan…</source><translation>Abrir un escaneo…</translation></message>
<message><source>Connect to the scanner…</source><translation>Conectar con el escáner…</translation></message>
<message><source>Go on with the last session</source><translation>Seguir con la última sesión</translation></message>
<message><source>Demo draw-bell</source><translation>Campana de demostración</translation></message>
<message><source>no scanner, no files needed</source><translation>sin escáner, sin archivos</translation></message>
<message><source>Demo before and after a blast</source><translation>Demostración antes y después de una tronadura</translation></message>
<message><source>both, and what changed between them</source><translation>ambos, y lo que cambió entre ellos</translation></message>
<message><source>Recent</source><translation>Recientes</translation></message>
<message><source>Scans that were open are listed here.</source><translation>Aquí se listan los escaneos que estuvieron abiertos.</translation></message>
<message><source>The edges of rocks in a laser range scan</source><translation>Los bordes de las rocas en un escaneo láser de distancias</translation></message>
<message><source>Reads raw grids, recordings (.mcap), ROS bags, PCD, PLY, E57, LAS, PTX, CSV, XYZ and others.</source><translation>Lee rejillas sin procesar, grabaciones (.mcap), bags de ROS, PCD, PLY, E57, LAS, PTX, CSV, XYZ y otros.</translation></message>
<message><source>EdgeScan sends only read requests and one subscription to the scanner.</source><translation>Solo envía al escáner lecturas y una suscripción.</translation></message>
<message><source>Cab mode</source><translation>Modo cabina</translation></message>
<message><source>a file on this computer or on a stick</source><translation>un archivo de este equipo o de una memoria USB</translation></message>
<message><source>Ctrl+O, or drop files anywhere in this window</source><translation>Ctrl+O, o suelte archivos en esta ventana</translation></message>
<message><source>a SICK LMS, or a robot with ROS as ws://ROBOT</source><translation>un SICK LMS, o un robot con ROS como ws://ROBOT</translation></message>
<message><source>Ctrl+L; a SICK LMS, or a robot with ROS as ws://ROBOT</source><translation>Ctrl+L; un SICK LMS, o un robot con ROS como ws://ROBOT</translation></message>
<message><source>✕ not found: it was moved, or its disk is missing. Locate…</source><translation>✕ no encontrado: se movió, o falta su disco. Localizar…</translation></message>
<message><source>there is none yet</source><translation>aún no hay ninguna</translation></message>
<message><source>%1, %2, %3 UTC</source><translation>%1, %2, %3 UTC</translation></message>
<message><source>Open a scan or connect the scanner. The demo needs neither: it is a hung-up draw-bell.</source><translation>Abra un escaneo o conecte el escáner. La demostración no necesita ninguno: es una campana colgada.</translation></message>
<message><source>Open the demo</source><translation>Abrir la demostración</translation></message>
<message><source>Drag turns the cloud, the middle button moves it, the wheel zooms. A click marks a cell in cloud, range image and edge map; its card has distance and coordinates.</source><translation>Arrastrar gira la nube, el botón central la mueve, la rueda amplía. Un clic marca una celda en la nube, la imagen de distancias y el mapa de bordes; su ficha da distancia y coordenadas.</translation></message>
<message><source>View from the scanner</source><translation>Ver desde el escáner</translation></message>
<message><source>Change Edge strength first. The curve under it shows the number of edge cells for every value. Where it is flat, the edges depend little on it.</source><translation>Ajuste primero la fuerza de los bordes. La curva de abajo muestra cuántos bordes hay para cada valor; donde es plana, los bordes dependen poco del ajuste.</translation></message>
<message><source>Show the edges panel</source><translation>Mostrar el panel de bordes</translation></message>
<message><source>EdgeScan finds rocks from the edges, with visible sizes and a confidence. The table lists them. A click selects a rock in all views.</source><translation>EdgeScan encuentra las rocas a partir de los bordes, con su tamaño visible y una confianza. La tabla las muestra. Un clic elige una roca en todas las vistas.</translation></message>
<message><source>Show the rocks</source><translation>Mostrar las rocas</translation></message>
<message><source>The tools above measure and compare scans. File exports edges, clouds and a report. Help shows all keys, and this tour again.</source><translation>Las herramientas de arriba miden y comparan escaneos. Archivo exporta bordes, nubes y un informe. Ayuda muestra todas las teclas, y también este recorrido.</translation></message>
<message><source>Show the keys</source><translation>Mostrar las teclas</translation></message>
<message><source>End the tour</source><translation>Terminar el recorrido</translation></message>
<message><source>was %1</source><translation>antes: %1</translation></message>
<message><source>Measure</source><translation>Medir</translation></message>
<message><source>Its name: keystone, left shoulder …</source><translation>Su nombre: clave, apoyo izquierdo …</translation></message>
<message><source>Your note on it, stored with its name</source><translation>Su nota sobre él, guardada con su nombre</translation></message>
<message><source>Lock</source><translation>Bloquear</translation></message>
<message><source>Locked: Del and Remove All do not remove it</source><translation>Bloqueado: Supr y Quitar todos no lo quitan</translation></message>
<message><source>Remove this target</source><translation>Quitar este objetivo</translation></message>
<message><source>Locked</source><translation>Bloqueado</translation></message>
<message><source>Target %1: %2</source><translation>Objetivo %1: %2</translation></message>
<message><source>X, Y, Z</source><translation>X, Y, Z</translation></message>
<message><source>Metres in the frame of the scan</source><translation>Metros en el sistema del escaneo</translation></message>
<message><source>E, N, RL</source><translation>E, N, RL</translation></message>
<message><source>Easting, Northing and RL (height) in the mine grid, in metres</source><translation>Este, norte y RL (altura) en coordenadas de la mina, en metros</translation></message>
<message><source>Rock, visible</source><translation>Roca, visible</translation></message>
<message><source>none here</source><translation>ninguna aquí</translation></message>
<message><source>Length a and width b of its visible part. Hidden parts are not included.</source><translation>Largo a y ancho b de su parte visible. Las partes ocultas no cuentan.</translation></message>
<message><source>Resolves</source><translation>Resolución</translation></message>
<message><source>The smallest thing seen reliably here: %1 to the next beam, and a beam of %2 as an LMS511 has it in high resolution</source><translation>Lo más pequeño que se ve de manera fiable aquí: %1 hasta el haz vecino, y un haz de %2 como el de un LMS511 en alta resolución</translation></message>
<message><source>Surface</source><translation>Superficie</translation></message>
<message><source>Between its normal and the beam: 0° faces the scanner. A plane through %1 cells, relief %2</source><translation>Entre su normal y el haz: 0° mira de frente al escáner. Un plano por %1 celdas, relieve %2</translation></message>
<message><source>Dip / direction</source><translation>Manteo / dirección</translation></message>
<message><source>Of the plane to the horizon, and clockwise from grid north the way it falls</source><translation>Del plano respecto al horizonte, y en sentido horario desde el norte de la cuadrícula, hacia donde cae</translation></message>
<message><source>From the boom</source><translation>Al brazo</translation></message>
<message><source>To the straight line from the boom's pivot to the head, where they were when this was measured; 0° off square: the boom points straight at the surface</source><translation>Hasta la recta del pivote del brazo a la cabeza, donde estaban al medir; 0°: el brazo apunta de frente a la superficie</translation></message>
<message><source>line %1 · beam %2</source><translation>línea %1 · haz %2</translation></message>
<message><source>Line angle %1°, beam angle %2°</source><translation>Ángulo de la línea %1°, ángulo del haz %2°</translation></message>
<message><source>, strength %1</source><translation>, fuerza %1</translation></message>
<message><source>Edge</source><translation>Borde</translation></message>
<message><source>Strength 1 is at the threshold; Why says more</source><translation>La fuerza 1 está en el umbral; Por qué dice más</translation></message>
<message><source>Share of nearby settings that find this edge too, computed after each change. It shows how much the edge depends on the settings, not whether a rock is there.</source><translation>Parte de los ajustes próximos que encuentran también este borde, calculada después de cada cambio. Muestra cuánto depende el borde de los ajustes, no si hay una roca.</translation></message>
<message><source>large scan: show Edge Confidence</source><translation>escaneo grande: muestre la confianza de los bordes</translation></message>
<message><source>%1 m behind a jump where no edge is drawn (a slip of the stepper looks the same); measured on its near side</source><translation>%1 m detrás de un salto donde no hay ningún borde dibujado (un deslizamiento del motor paso a paso se ve igual); medido en su lado cercano</translation></message>
<message><source>%1 m behind an edge; measured on its near side</source><translation>%1 m detrás de un borde; medido en su lado cercano</translation></message>
<message><source>a beam between two surfaces; measured on the nearer one</source><translation>un haz entre dos superficies; medido en la más cercana</translation></message>
<message><source>one echo in front of all around it, as from dust; measured at the nearest cell behind it</source><translation>un solo eco delante de todo lo que lo rodea, como de polvo; medido en la celda más cercana detrás de él</translation></message>
<message><source>nothing was measured there; measured at the nearest cell</source><translation>allí no se midió nada; medido en la celda más cercana</translation></message>
<message><source>nothing was measured within %1 cells</source><translation>no se midió nada a menos de %1 celdas</translation></message>
<message><source>▲ a nearer surface is also within %1 cells: zoom in if that was meant</source><translation>▲ también hay una superficie más cercana a menos de %1 celdas: amplíe si era esa</translation></message>
<message><source>± not known</source><translation>± desconocido</translation></message>
<message><source>E %1  N %2
RL %3 m</source><translation>E %1  N %2
RL %3 m</translation></message>
<message><source>x %1  y %2  z %3 m</source><translation>x %1  y %2  z %3 m</translation></message>
<message><source>E %1 N %2 RL %3</source><translation>E %1 N %2 RL %3</translation></message>
<message><source>Distance [m]</source><translation>Distancia [m]</translation></message>
<message><source>Line</source><translation>Línea</translation></message>
<message><source>Beam</source><translation>Haz</translation></message>
<message><source>Distance</source><translation>Distancia</translation></message>
<message><source>Two standard deviations of the noise of this scan along the beam. Errors that the scanner makes everywhere are not included.</source><translation>Dos desviaciones estándar del ruido de este escaneo a lo largo del haz. Los errores que el escáner comete en todas partes no están incluidos.</translation></message>
<message><source>A click near an edge means its near side; with Shift it means the very cell</source><translation>Un clic cerca de un borde se refiere a su lado cercano; con Mayús, a la celda misma</translation></message>
<message><source>from</source><translation>desde</translation></message>
<message><source>scanner, line of sight</source><translation>escáner, línea de visión</translation></message>
<message><source>Picture</source><translation>Imagen</translation></message>
<message><source>Confidence</source><translation>Confianza</translation></message>
<message><source>Copy All</source><translation>Copiar todos</translation></message>
<message><source>Remove All</source><translation>Quitar todos</translation></message>
<message><source>The positions of all targets as a table with units, for a spreadsheet</source><translation>Las posiciones de todos los objetivos como tabla con unidades, para una hoja de cálculo</translation></message>
<message><source>All but those that are locked</source><translation>Todos menos los que están bloqueados</translation></message>
<message><source>A vertical section through the selected measurement, or through the last one</source><translation>Una sección vertical por la medición seleccionada, o por la última</translation></message>
<message><source>The selected measurement</source><translation>La medición elegida</translation></message>
<message><source>Click a cell in any view to pin it.</source><translation>Haga clic en una celda de cualquier vista para fijarla.</translation></message>
<message><source>Number of edge cells at every threshold, from the least to the most on a logarithmic scale. Hatched: the widest range over which at most a fifth of them disappears. The vertical line is the threshold in use.</source><translation>Número de celdas de borde en cada umbral, del menor al mayor en escala logarítmica. Rayado: el tramo más ancho en que desaparece un quinto de ellas como máximo. La línea vertical es el umbral en uso.</translation></message>
<message><source>counting the edge cells …</source><translation>contando las celdas de borde …</translation></message>
<message><source> · steady from %1 to %2</source><translation> · varía poco de %1 a %2</translation></message>
<message><source>Without %1:</source><translation>Sin %1:</translation></message>
<message><source>Without %1 classes:</source><translation>Sin %1 clases:</translation></message>
<message><source>other classes take some of its cells, and chains get shorter: fewer edges, here and in files</source><translation>otras clases toman parte de sus celdas y las cadenas se acortan: menos bordes, aquí y en archivos</translation></message>
<message><source>Classes</source><translation>Clases</translation></message>
<message><source>How likely an edge is the border of a rock; where that is unknown, it is drawn like one.</source><translation>La probabilidad de que un borde sea el contorno de una roca; donde se desconoce, se dibuja como un contorno.</translation></message>
<message><source>Without one class the other numbers change too: a cell has one class, and a weak cell counts where it continues a strong one of any class.</source><translation>Sin una clase cambian también los otros números: una celda tiene una sola clase, y una celda débil cuenta donde continúa una fuerte de cualquier clase.</translation></message>
<message><source>With a higher edge strength this number can rise: cells that were jumps or folds before count here.</source><translation>Con una fuerza del borde mayor este número puede subir: las celdas que ya no son saltos ni pliegues cuentan aquí.</translation></message>
<message><source>Colours by class</source><translation>Colores por clase</translation></message>
<message><source>Each class in its own colour, or all edges in one: C</source><translation>Cada clase en su color, o todos los bordes en uno: C</translation></message>
<message><source>Rocks cover them in the cloud</source><translation>Las rocas los cubren en la nube</translation></message>
<message><source>Rocks &gt; Edges over Rocks draws them over the rocks; the images show them.</source><translation>Rocas &gt; Bordes sobre las rocas los dibuja encima; las imágenes los muestran.</translation></message>
<message><source>Striped green in the images; no beam measured these cells, and the cloud does not show them.</source><translation>Rayado de verde en las imágenes; nadie midió estas celdas, y la nube no las muestra.</translation></message>
<message><source>Rock border, %1 % and more: %2</source><translation>Contorno de roca, %1 % y más: %2</translation></message>
<message><source>Perhaps, %1 to 69 %: %2</source><translation>Quizá, %1 a 69 %: %2</translation></message>
<message><source>Fold in a rock, %1 to 29 %: %2</source><translation>Pliegue en una roca, %1 a 29 %: %2</translation></message>
<message><source>Fold in a rock, below 30 %: %1</source><translation>Pliegue en una roca, menos de 30 %: %1</translation></message>
<message><source>Violet stripes in the images: no return, outside of the range window, or masked. The status bar counts each.</source><translation>Rayas violetas en las imágenes: sin retorno, fuera de la ventana de distancias o enmascarado. La barra de estado cuenta cada caso.</translation></message>
<message><source>Dark red stripes in the images: the scanner sent a status code in place of a range.</source><translation>Rayas rojo oscuro en las imágenes: el escáner envió un código de estado en lugar de una distancia.</translation></message>
<message><source>Laser ray to the marked cell</source><translation>Rayo láser a la celda marcada</translation></message>
<message><source>No return: %1</source><translation>Sin retorno: %1</translation></message>
<message><source>No range: %1</source><translation>Sin distancia: %1</translation></message>
<message><source>Status code: %1</source><translation>Código de estado: %1</translation></message>
<message><source>▥ Filled, not measured: %1</source><translation>▥ Rellenadas, no medidas: %1</translation></message>
<message><source>Edges, under rocks</source><translation>Bordes, bajo rocas</translation></message>
<message><source>Draws the edge points over the rocks</source><translation>Dibuja los puntos de borde sobre las rocas</translation></message>
<message><source>Edge points on and off: E</source><translation>Puntos de borde visibles o no: E</translation></message>
<message><source>%1 mm at %2 m</source><translation>%1 mm a %2 m</translation></message>
<message><source>neighbours err alike, as in a depth camera</source><translation>los vecinos yerran igual, como en una cámara de profundidad</translation></message>
<message><source>each cell errs for itself, in steps of the file</source><translation>cada celda yerra por sí sola, en pasos del archivo</translation></message>
<message><source>each cell errs for itself</source><translation>cada celda yerra por sí sola</translation></message>
<message><source>Noise in use: %1; sigma %2, %3, %4.</source><translation>Ruido en uso: %1; sigma %2, %3, %4.</translation></message>
<message><source>Folds have to exceed %1.</source><translation>Los pliegues deben superar %1.</translation></message>
<message><source>Rough scan: around half of the folds %1 % of the cells fold, so a fold must exceed its surroundings.</source><translation>Escaneo rugoso: alrededor de la mitad de los pliegues, el %1 % de las celdas están plegadas, así que un pliegue debe superar su entorno.</translation></message>
<message><source>Advanced</source><translation>Avanzado</translation></message>
<message><source>Default</source><translation>Inicial</translation></message>
<message><source>For most scans of rock</source><translation>Para casi todo escaneo de roca</translation></message>
<message><source>Percent of range</source><translation>Porcentaje de la distancia</translation></message>
<message><source>Steps in percent of the range</source><translation>Saltos en % de la distancia</translation></message>
<message><source>Thesis</source><translation>Tesis</translation></message>
<message><source>To compare with the thesis</source><translation>Para comparar con la tesis</translation></message>
<message><source>Thesis, contrast</source><translation>Tesis, contraste</translation></message>
<message><source>The thesis, with more contrast</source><translation>La tesis, con más contraste</translation></message>
<message><source>Smooth walls</source><translation>Paredes lisas</translation></message>
<message><source>For flat walls with low steps</source><translation>Paredes planas, saltos bajos</translation></message>
<message><source>Version 4</source><translation>Versión 4</translation></message>
<message><source>To compare with version 4</source><translation>Para comparar con la versión 4</translation></message>
<message><source>Version 3</source><translation>Versión 3</translation></message>
<message><source>To compare with version 3</source><translation>Para comparar con la versión 3</translation></message>
<message><source>Open…</source><translation>Abrir…</translation></message>
<message><source>Open a preset file</source><translation>Abrir un archivo de preajuste</translation></message>
<message><source>Save…</source><translation>Guardar…</translation></message>
<message><source>Save these settings as a preset file</source><translation>Guardar estos ajustes como archivo de preajuste</translation></message>
<message><source>Preset</source><translation>Preajuste</translation></message>
<message><source>The steps in depth that reach the thresholds, computed from the kernels: the smaller number for a step that runs diagonally, the larger one along lines or beams. A depth such as 0.5 m can be typed into the box above; with logarithmic gray levels it is taken at the range given here, and a share such as 5 % holds at every range.</source><translation>Los escalones de profundidad que alcanzan los umbrales, calculados a partir de los kernels: el número menor para un escalón en diagonal, el mayor para uno a lo largo de líneas o haces. En el campo de arriba se puede escribir una profundidad como 0.5 m; con niveles de gris logarítmicos se toma a la distancia que se da aquí, y una proporción como 5 % vale a cualquier distancia.</translation></message>
<message><source>Locked: the upper threshold is 3 times the lower one, as in the thesis. Click to open the lock.</source><translation>Bloqueado: el umbral superior es 3 veces el inferior, como en la tesis. Haga clic para abrir el bloqueo.</translation></message>
<message><source>Locked 1 : 3</source><translation>Bloqueado 1 : 3</translation></message>
<message><source>Unlocked</source><translation>Desbloqueado</translation></message>
<message><source>Strong from  %1 % of range</source><translation>Fuerte desde  %1 % de la distancia</translation></message>
<message><source>Upper threshold  %1</source><translation>Umbral superior  %1</translation></message>
<message><source>  (no gradient reaches it)</source><translation>  (ningún gradiente lo alcanza)</translation></message>
<message><source>• modified</source><translation>• modificado</translation></message>
<message><source>In files and on the command line its name is %1</source><translation>En los archivos y en la línea de comandos se llama %1</translation></message>
<message><source>From a file</source><translation>De un archivo</translation></message>
<message><source>computing …</source><translation>calculando …</translation></message>
<message><source>
%1 to %2 %3</source><translation>
%1 a %2 %3</translation></message>
<message><source>
Double-click: back to the preset</source><translation>
Doble clic: volver al preajuste</translation></message>
<message><source>less: %1</source><translation>menos: %1</translation></message>
<message><source>more: %1</source><translation>más: %1</translation></message>
<message><source>More edges</source><translation>Más bordes</translation></message>
<message><source>Fewer edges</source><translation>Menos bordes</translation></message>
<message><source>%1: %2; %3. The value stays as it was.</source><translation>%1: %2; %3. El valor queda como estaba.</translation></message>
<message><source>auto</source><translation>auto</translation></message>
<message><source>Back to %1, the value of the preset</source><translation>Volver a %1, el valor del preajuste</translation></message>
<message><source>Ends of the range window</source><translation>Extremos de la ventana de distancias</translation></message>
<message><source>Drag an end, or Left and Right for the far one, with Shift for the near one; a double-click makes it automatic</source><translation>Arrastre un extremo, o Izquierda y Derecha para el lejano, con Mayús para el cercano; un doble clic la hace automática</translation></message>
<message><source>Gray</source><translation>Gris</translation></message>
<message><source>Auto</source><translation>Auto</translation></message>
<message><source>Black and white as the method scales the ranges</source><translation>Negro y blanco según la escala de distancias del método</translation></message>
<message><source>The window stays as it is when another scan is opened</source><translation>La ventana queda como está al abrir otro escaneo</translation></message>
<message><source>%1 to %2 m</source><translation>de %1 a %2 m</translation></message>
<message><source>automatic: %1</source><translation>automático: %1</translation></message>
<message><source>filled, not measured: %1 m ± %2 m</source><translation>rellenada, no medida: %1 m ± %2 m</translation></message>
<message><source>range %1 m</source><translation>distancia %1 m</translation></message>
<message><source>device status %1</source><translation>estado del equipo %1</translation></message>
<message><source>E %1  N %2  RL %3</source><translation>E %1  N %2  RL %3</translation></message>
<message><source>EDGE</source><translation>BORDE</translation></message>
<message><source>not an edge</source><translation>no es un borde</translation></message>
<message><source>line %1  beam %2</source><translation>línea %1  haz %2</translation></message>
<message><source>  at %1° / %2°</source><translation>  a %1° / %2°</translation></message>
<message><source>  gray %1</source><translation>  gris %1</translation></message>
<message><source>Without a pose, coordinates count from the scanner, not from the mine grid. Scan &gt; Pose and Mounting… takes one.</source><translation>Sin pose, las coordenadas se cuentan desde el escáner, no desde la cuadrícula de la mina. Escaneo &gt; Pose y montaje… toma una.</translation></message>
<message><source>Pinned:</source><translation>Fijado:</translation></message>
<message><source>Pinned nearby:</source><translation>Fijado cerca:</translation></message>
<message><source>OUT OF SPEC</source><translation>FUERA DE TOLERANCIA</translation></message>
<message><source> · origin E %1 N %2 RL %3</source><translation> · origen E %1 N %2 RL %3</translation></message>
<message><source>A click opens the pose, to change or remove it.</source><translation>Un clic abre la pose, para cambiarla o quitarla.</translation></message>
<message><source>first line %1</source><translation>primera línea %1</translation></message>
<message><source>%1 no return</source><translation>%1 sin retorno</translation></message>
<message><source> · %1 status</source><translation> · %1 estado del equipo</translation></message>
<message><source> · %1 filled</source><translation> · %1 rellenadas</translation></message>
<message><source>Edges found in %1 ms</source><translation>Bordes encontrados en %1 ms</translation></message>
<message><source>%1 cells · edges pending</source><translation>%1 celdas · bordes pendientes</translation></message>
<message><source>edges pending</source><translation>bordes pendientes</translation></message>
<message><source>%1: %2 instead of %3</source><translation>%1: %2 en vez de %3</translation></message>
<message><source>default settings</source><translation>ajustes predeterminados</translation></message>
<message><source>settings: %1 changed</source><translation>ajustes: %1 modificado(s)</translation></message>
<message><source>%1 changed</source><translation>%1 modificado(s)</translation></message>
<message><source>Set of default settings: %1</source><translation>Conjunto de ajustes predeterminados: %1</translation></message>
<message><source>Reset %1</source><translation>Restablecer %1</translation></message>
<message><source>Reset all</source><translation>Restablecer todo</translation></message>
<message><source>All settings are those of the default set.</source><translation>Todos los ajustes son los del conjunto predeterminado.</translation></message>
<message><source>Ctrl+D restores the default settings.</source><translation>Ctrl+D restaura los ajustes predeterminados.</translation></message>
<message><source>1 warning</source><translation>1 advertencia</translation></message>
<message><source>Acknowledged.</source><translation>Vistas.</translation></message>
<message><source>Shows the warnings of this scan and acknowledges them. They remain in records and screenshots.</source><translation>Muestra las advertencias de este escaneo y las marca como vistas. Permanecen en los registros y las capturas de pantalla.</translation></message>
<message><source>no scan open</source><translation>ningún escaneo abierto</translation></message>
<message><source>no point to show: all %1 points are hidden; Measure &gt; Show All shows them</source><translation>ningún punto que mostrar: los %1 puntos están ocultos; Medir &gt; Mostrar todo los muestra</translation></message>
<message><source>no point to show: no cell of this scan has a valid range</source><translation>ningún punto que mostrar: ninguna celda de este escaneo tiene una distancia válida</translation></message>
<message><source>There is no OpenGL on this display, so the 3D view cannot draw.</source><translation>No hay OpenGL en esta pantalla: la vista 3D no puede dibujar.</translation></message>
<message><source>OpenGL is installed but does not start on this display, so the 3D view cannot draw.</source><translation>OpenGL está instalado pero no arranca en esta pantalla: la vista 3D no puede dibujar.</translation></message>
<message><source>The 3D view needs OpenGL 3.2; this display offers %1.%2 (%3).</source><translation>La vista 3D necesita OpenGL 3.2; esta pantalla ofrece %1.%2 (%3).</translation></message>
<message><source>The bar has this length at the median distance of the points in view. The distance counts from the scanner.</source><translation>La barra tiene esta longitud a la distancia mediana de los puntos a la vista. La distancia se cuenta desde el escáner.</translation></message>
<message><source>grid %1</source><translation>cuadrícula %1</translation></message>
<message><source>%1 at %2 m</source><translation>%1 a %2 m</translation></message>
<message><source>Range [m]</source><translation>Distancia [m]</translation></message>
<message><source>Height above the scanner [m]</source><translation>Altura sobre el escáner [m]</translation></message>
<message><source>Front</source><translation>Frente</translation></message>
<message><source>Left</source><translation>Izq.</translation></message>
<message><source>Right</source><translation>Der.</translation></message>
<message><source>Top</source><translation>Arriba</translation></message>
<message><source>Bottom</source><translation>Abajo</translation></message>
<message><source>Click a face: look at the cloud from there</source><translation>Clic en una cara: mirar la nube desde ahí</translation></message>
<message><source>Without a pose, up is the scanner's z</source><translation>Sin pose, arriba es el eje z del escáner</translation></message>
<message><source>Show the whole images</source><translation>Mostrar las imágenes enteras</translation></message>
<message><source>Zoomed %1 × · Fit</source><translation>Ampliado %1 × · Encuadrar</translation></message>
<message><source>Tune</source><translation>Ajustes</translation></message>
<message><source>Back to the cloud</source><translation>Volver a la nube</translation></message>
<message><source>Hold it for one second to leave.</source><translation>Manténgalo 1 s para salir.</translation></message>
<message><source>No scan</source><translation>Ningún escaneo</translation></message>
<message><source>Open one, or connect to a scanner</source><translation>Abra uno, o conecte un escáner</translation></message>
<message><source>%1 of %2 lines</source><translation>%1 de %2 líneas</translation></message>
<message><source> · %1 % no return</source><translation> · %1 % sin retorno</translation></message>
<message><source>Range image</source><translation>Imagen de distancias</translation></message>
<message><source>Edge map</source><translation>Mapa de bordes</translation></message>
<message><source>Cloud</source><translation>Nube de puntos</translation></message>
<message><source>Small picture</source><translation>Imagen pequeña</translation></message>
<message><source>Rock…</source><translation>Roca…</translation></message>
<message><source>What can be done with rocks</source><translation>Qué se puede hacer con las rocas</translation></message>
<message><source>Views</source><translation>Vistas</translation></message>
<message><source>Take the last point back</source><translation>Retirar el último punto</translation></message>
<message><source>Targets</source><translation>Objetivos</translation></message>
<message><source>Layers</source><translation>Capas</translation></message>
<message><source>Rock Table</source><translation>Tabla de rocas</translation></message>
<message><source>Hide panel</source><translation>Ocultar panel</translation></message>
<message><source>turned by %1°</source><translation>giradas %1°</translation></message>
<message><source>mirrored</source><translation>reflejadas</translation></message>
<message><source>gray %1 to %2 m</source><translation>gris %1 a %2 m</translation></message>
<message><source>up to line %1</source><translation>hasta la línea %1</translation></message>
<message><source>by class</source><translation>por clase</translation></message>
<message><source>growing</source><translation>creciendo</translation></message>
<message><source>%1 % of the points drawn</source><translation>%1 % de puntos dibujados</translation></message>
<message><source>turntable</source><translation>plato giratorio</translation></message>
<message><source>free rotation</source><translation>rotación libre</translation></message>
<message><source>orthographic</source><translation>ortográfica</translation></message>
<message><source>perspective</source><translation>perspectiva</translation></message>
<message><source>coarse picture</source><translation>imagen preliminar</translation></message>
<message><source>Warnings of this scan:
</source><translation>Advertencias de este escaneo:
</translation></message>
<message><source>&amp;Legends at the Side</source><translation>&amp;Leyendas al lado</translation></message>
<message><source>view of the cloud</source><translation>vista de la nube</translation></message>
<message><source>Letters outside a field are keys; these changed: %1.</source><translation>Las letras fuera de un campo son teclas; estas cambiaron: %1.</translation></message>
<message><source>Opening another scan · still shown: </source><translation>Abriendo otro escaneo · aún en pantalla: </translation></message>
<message><source>The manual is not installed. Its texts are in the folder docs of the source, page %1.</source><translation>El manual no está instalado. Sus textos están en la carpeta docs del código fuente, página %1.</translation></message>
<message><source>No browser opened the manual. It is the file %1.</source><translation>Ningún navegador abrió el manual. Es el archivo %1.</translation></message>
<message><source>Compare &amp;A/B</source><translation>Comparar &amp;A/B</translation></message>
<message><source>&amp;Keep This as A</source><translation>&amp;Conservar esto como A</translation></message>
<message><source>&amp;Compare with Earlier Scan…</source><translation>Co&amp;mparar con un escaneo anterior…</translation></message>
<message><source>Exchange A and &amp;B</source><translation>Intercambiar A y &amp;B</translation></message>
<message><source>&amp;Demo before and after a Blast</source><translation>&amp;Demostración antes y después de una tronadura</translation></message>
<message><source>Show &amp;A</source><translation>Mostrar &amp;A</translation></message>
<message><source>Show What &amp;Changed</source><translation>Mostrar lo que cam&amp;bió</translation></message>
<message><source>&amp;Colour by Distance from A</source><translation>&amp;Color según la distancia a A</translation></message>
<message><source>&amp;Next Changed Region</source><translation>&amp;Siguiente región cambiada</translation></message>
<message><source>&amp;Previous Changed Region</source><translation>Región cambiada a&amp;nterior</translation></message>
<message><source>&amp;Forget A</source><translation>&amp;Olvidar A</translation></message>
<message><source>Edge Con&amp;fidence</source><translation>Con&amp;fianza de los bordes</translation></message>
<message><source>Colours and sizes of edges by how many settings near these find them too</source><translation>Colores y tamaños de los bordes según cuántos ajustes cercanos los hallan también</translation></message>
<message><source>“%1” has ended; a click selects a rock again.</source><translation>«%1» ha terminado; un clic vuelve a elegir una roca.</translation></message>
<message><source>“%1” has ended; a click pins again.</source><translation>«%1» ha terminado; un clic vuelve a fijar.</translation></message>
<message><source>&amp;Edges over Rocks</source><translation>Bor&amp;des sobre las rocas</translation></message>
<message><source>&amp;Rocks</source><translation>&amp;Rocas</translation></message>
<message><source>&amp;Show Rocks</source><translation>&amp;Mostrar rocas</translation></message>
<message><source>&amp;Largest Rock by Width b</source><translation>Roca con el m&amp;ayor ancho b</translation></message>
<message><source>Next Sm&amp;aller Rock by Width b</source><translation>&amp;Siguiente roca de menor ancho b</translation></message>
<message><source>&amp;Merge Rocks</source><translation>F&amp;usionar rocas</translation></message>
<message><source>S&amp;plit a Rock</source><translation>Di&amp;vidir una roca</translation></message>
<message><source>Merge al&amp;ong a Line</source><translation>Fus&amp;ionar a lo largo de una línea</translation></message>
<message><source>C&amp;ut along a Line</source><translation>&amp;Cortar a lo largo de una línea</translation></message>
<message><source>&amp;Not a Rock, or a Rock Again</source><translation>&amp;No es roca, o sí lo es</translation></message>
<message><source>Na&amp;me This Rock…</source><translation>&amp;Nombre de esta roca…</translation></message>
<message><source>&amp;Finer</source><translation>Más &amp;fino</translation></message>
<message><source>&amp;Coarser</source><translation>Más &amp;grueso</translation></message>
<message><source>Draw Region of &amp;Interest</source><translation>Dibu&amp;jar la región de interés</translation></message>
<message><source>Clear Re&amp;gion of Interest</source><translation>&amp;Borrar la región de interés</translation></message>
<message><source>E&amp;xport Rocks…</source><translation>E&amp;xportar rocas…</translation></message>
<message><source>slope, grade and length of a straight line</source><translation>inclinación, pendiente y longitud de una recta</translation></message>
<message><source>&amp;Measure</source><translation>&amp;Medir</translation></message>
<message><source>&amp;Pin</source><translation>&amp;Fijar</translation></message>
<message><source>&amp;Distance</source><translation>&amp;Distancia</translation></message>
<message><source>&amp;Vertical</source><translation>&amp;Vertical</translation></message>
<message><source>&amp;Angle</source><translation>Á&amp;ngulo</translation></message>
<message><source>&amp;Spans a × b</source><translation>&amp;Extensiones a × b</translation></message>
<message><source>Along S&amp;urface</source><translation>Por la &amp;superficie</translation></message>
<message><source>Thr&amp;oat Width</source><translation>Ancho de &amp;garganta</translation></message>
<message><source>Se&amp;ction through the Measurement</source><translation>Se&amp;cción por la medición</translation></message>
<message><source>Section th&amp;rough the Rock</source><translation>Sección po&amp;r la roca</translation></message>
<message><source>&amp;Box</source><translation>Rec&amp;uadro</translation></message>
<message><source>&amp;Lasso</source><translation>&amp;Lazo</translation></message>
<message><source>Na&amp;me This Target</source><translation>Nom&amp;brar este objetivo</translation></message>
<message><source>Remove This Tar&amp;get</source><translation>&amp;Quitar este objetivo</translation></message>
<message><source>Remove All &amp;Targets</source><translation>Quitar &amp;todos los objetivos</translation></message>
<message><source>&amp;Copy This Target</source><translation>&amp;Copiar este objetivo</translation></message>
<message><source>Sho&amp;w All</source><translation>&amp;Mostrar todo</translation></message>
<message><source>Clip to Bo&amp;x round Selected</source><translation>Recortar a una &amp;caja en torno a la selección</translation></message>
<message><source>&amp;Range Gate…</source><translation>&amp;Ventana de distancia…</translation></message>
<message><source>Hide &amp;Farther than This Cell</source><translation>Ocultar lo que está más &amp;lejos que esta celda</translation></message>
<message><source>Hide Nearer than This Cell</source><translation>Ocultar lo que está más cerca que esta celda</translation></message>
<message><source>&amp;Zoom to Selected</source><translation>&amp;Zoom a la selección</translation></message>
<message><source>Select &amp;Nothing</source><translation>No selecc&amp;ionar nada</translation></message>
<message><source>There are no targets yet: pin a cell first.</source><translation>Aún no hay objetivos: fije primero una celda.</translation></message>
<message><source>Edge &amp;Drawing (DXF)…</source><translation>&amp;Dibujo de bordes (DXF)…</translation></message>
<message><source>&amp;Selected Cells…</source><translation>Celdas &amp;seleccionadas…</translation></message>
<message><source>Open &amp;Recent</source><translation>Abrir &amp;reciente</translation></message>
<message><source>&amp;File</source><translation>&amp;Archivo</translation></message>
<message><source>&amp;Open…</source><translation>&amp;Abrir…</translation></message>
<message><source>Open &amp;Demo Draw-Bell</source><translation>Abrir la campana de &amp;demostración</translation></message>
<message><source>Demo before and after a &amp;Blast</source><translation>Demo antes y después de una &amp;tronadura</translation></message>
<message><source>&amp;Connect to Scanner…</source><translation>&amp;Conectar al escáner…</translation></message>
<message><source>Re&amp;load</source><translation>Recar&amp;gar</translation></message>
<message><source>&amp;Export</source><translation>&amp;Exportar</translation></message>
<message><source>Re&amp;port…</source><translation>&amp;Informe…</translation></message>
<message><source>&amp;Screenshot…</source><translation>Captura de &amp;pantalla…</translation></message>
<message><source>&amp;Copy as Command</source><translation>Copiar como co&amp;mando</translation></message>
<message><source>&amp;Quit</source><translation>&amp;Salir</translation></message>
<message><source>&amp;Undo</source><translation>&amp;Deshacer</translation></message>
<message><source>&amp;Redo</source><translation>&amp;Rehacer</translation></message>
<message><source>&amp;Edit</source><translation>&amp;Edición</translation></message>
<message><source>&amp;Copy Probe Values</source><translation>&amp;Copiar valores bajo el cursor</translation></message>
<message><source>&amp;Edge Points</source><translation>&amp;Puntos de borde</translation></message>
<message><source>Edges &amp;by Class</source><translation>Bordes por &amp;clase</translation></message>
<message><source>Edges &amp;over Range Image</source><translation>Bordes so&amp;bre la imagen de distancias</translation></message>
<message><source>&amp;Colour-Blind Edge Colours</source><translation>Colores de borde para dal&amp;tónicos</translation></message>
<message><source>I&amp;mages</source><translation>I&amp;mágenes</translation></message>
<message><source>True &amp;Angle Aspect</source><translation>Proporción an&amp;gular real</translation></message>
<message><source>Turn by a &amp;Quarter</source><translation>Girar un &amp;cuarto a la derecha</translation></message>
<message><source>Turn by a &amp;Half</source><translation>Dar media &amp;vuelta</translation></message>
<message><source>&amp;Mirror</source><translation>&amp;Reflejar</translation></message>
<message><source>Loo&amp;k from</source><translation>&amp;Mirar desde</translation></message>
<message><source>From &amp;Scanner</source><translation>Desde el &amp;escáner</translation></message>
<message><source>&amp;Front</source><translation>De &amp;frente</translation></message>
<message><source>&amp;Back</source><translation>Desde &amp;atrás</translation></message>
<message><source>&amp;Right</source><translation>&amp;Derecha</translation></message>
<message><source>&amp;Left</source><translation>&amp;Izquierda</translation></message>
<message><source>&amp;Top (from Above)</source><translation>Desde arri&amp;ba</translation></message>
<message><source>Botto&amp;m (from Below)</source><translation>Desde aba&amp;jo</translation></message>
<message><source>&amp;Isometric</source><translation>Iso&amp;métrica</translation></message>
<message><source>Sto&amp;red Views</source><translation>&amp;Vistas guardadas</translation></message>
<message><source>View &amp;%1</source><translation>Vista &amp;%1</translation></message>
<message><source>Store as View &amp;%1</source><translation>Guardar como vista &amp;%1</translation></message>
<message><source>Clou&amp;d</source><translation>&amp;Nube de puntos</translation></message>
<message><source>&amp;Orthographic</source><translation>&amp;Ortográfica</translation></message>
<message><source>T&amp;urntable</source><translation>Plato &amp;giratorio</translation></message>
<message><source>&amp;Dim Cloud under Edges</source><translation>Ate&amp;nuar la nube bajo los bordes</translation></message>
<message><source>Depth S&amp;hading</source><translation>&amp;Sombreado por profundidad</translation></message>
<message><source>&amp;Ground Grid</source><translation>Cuadrícula del &amp;suelo</translation></message>
<message><source>Vie&amp;w Cube</source><translation>&amp;Cubo de vistas</translation></message>
<message><source>Point Size &amp;+</source><translation>Tamaño de los puntos &amp;+</translation></message>
<message><source>Point Size &amp;-</source><translation>Tamaño de los puntos &amp;-</translation></message>
<message><source>Point Size by &amp;Spacing</source><translation>Tamaño de los puntos según el e&amp;spaciado</translation></message>
<message><source>&amp;Panels</source><translation>&amp;Paneles</translation></message>
<message><source>&amp;View</source><translation>&amp;Ver</translation></message>
<message><source>Fit All Vi&amp;ews</source><translation>&amp;Encuadrar todas las vistas</translation></message>
<message><source>&amp;Zoom In</source><translation>A&amp;cercar</translation></message>
<message><source>Zoom O&amp;ut</source><translation>A&amp;lejar</translation></message>
<message><source>Fl&amp;y to Point under Cursor</source><translation>&amp;Volar al punto bajo el cursor</translation></message>
<message><source>Reset &amp;Layout</source><translation>Restab&amp;lecer la disposición</translation></message>
<message><source>Full Scree&amp;n</source><translation>Pantalla com&amp;pleta</translation></message>
<message><source>P&amp;ose and Mounting…</source><translation>Pose &amp;y montaje…</translation></message>
<message><source>&amp;Scan</source><translation>E&amp;scaneo</translation></message>
<message><source>&amp;Next Scan</source><translation>Escaneo &amp;siguiente</translation></message>
<message><source>Pre&amp;vious Scan</source><translation>Escaneo &amp;anterior</translation></message>
<message><source>&amp;Add a Scan as a Layer…</source><translation>&amp;Añadir un escaneo como capa…</translation></message>
<message><source>&amp;Record</source><translation>&amp;Grabar</translation></message>
<message><source>&amp;Keep Last Minute</source><translation>&amp;Conservar el último minuto</translation></message>
<message><source>S&amp;weep…</source><translation>&amp;Barrido…</translation></message>
<message><source>&amp;Hold First Sweep of a Connection at Its End</source><translation>Co&amp;ngelar el primer barrido de una conexión al final</translation></message>
<message><source>Recordings &amp;Folder…</source><translation>Car&amp;peta de grabaciones…</translation></message>
<message><source>P&amp;lay or Pause</source><translation>&amp;Reproducir o pausar</translation></message>
<message><source>Next Line</source><translation>Línea siguiente</translation></message>
<message><source>Previous Line</source><translation>Línea anterior</translation></message>
<message><source>Ten Lines Forward</source><translation>Diez líneas adelante</translation></message>
<message><source>Ten Lines Back</source><translation>Diez líneas atrás</translation></message>
<message><source>&amp;Straighten Beams</source><translation>&amp;Enderezar los haces</translation></message>
<message><source>Keep Repeate&amp;d Values</source><translation>Conservar los valores repeti&amp;dos</translation></message>
<message><source>&amp;How the Scan Is Read…</source><translation>Có&amp;mo se lee el escaneo…</translation></message>
<message><source>Does This Look &amp;Right?</source><translation>¿Pa&amp;rece correcto?</translation></message>
<message><source>&amp;Properties…</source><translation>Propie&amp;dades…</translation></message>
<message><source>&amp;Presets</source><translation>Prea&amp;justes</translation></message>
<message><source>&amp;Save…</source><translation>&amp;Guardar…</translation></message>
<message><source>&amp;Edges</source><translation>&amp;Bordes</translation></message>
<message><source>&amp;Lock upper = 3 × lower</source><translation>&amp;Bloquear superior = 3 × inferior</translation></message>
<message><source>&amp;Only Rock Borders</source><translation>S&amp;olo contornos de roca</translation></message>
<message><source>This &amp;Is an Edge</source><translation>Esto &amp;es un borde</translation></message>
<message><source>This Is &amp;Not an Edge</source><translation>Esto &amp;no es un borde</translation></message>
<message><source>Settings for These &amp;Marks…</source><translation>Ajustes para estas &amp;marcas…</translation></message>
<message><source>Clear the Mar&amp;ks</source><translation>Borrar las mar&amp;cas</translation></message>
<message><source>&amp;Why Is This Cell an Edge or Not?</source><translation>¿Por &amp;qué esta celda es un borde, o no?</translation></message>
<message><source>&amp;Reset to Preset</source><translation>&amp;Volver al preajuste</translation></message>
<message><source>Restore the &amp;Default Settings</source><translation>Restaurar los ajustes pre&amp;determinados</translation></message>
<message><source>&amp;Help</source><translation>A&amp;yuda</translation></message>
<message><source>&amp;Find a Command…</source><translation>&amp;Buscar un comando…</translation></message>
<message><source>&amp;Manual</source><translation>&amp;Manual</translation></message>
<message><source>&amp;Keys and Mouse</source><translation>&amp;Teclado y mouse</translation></message>
<message><source>&amp;Tour</source><translation>&amp;Recorrido</translation></message>
<message><source>&amp;About EdgeScan</source><translation>&amp;Acerca de EdgeScan</translation></message>
<message><source>Open Sess&amp;ion…</source><translation>Abrir ses&amp;ión…</translation></message>
<message><source>&amp;Save Session As…</source><translation>Guardar &amp;sesión como…</translation></message>
<message><source>Go on with the &amp;Last Session</source><translation>Continuar la ú&amp;ltima sesión</translation></message>
<message><source>Tools</source><translation>Herramientas</translation></message>
<message><source>Pin</source><translation>Fijar</translation></message>
<message><source>Scanner view</source><translation>Vista escáner</translation></message>
<message><source>Cab</source><translation>Cabina</translation></message>
<message><source>A/B</source><translation>A/B</translation></message>
<message><source>&amp;Theme</source><translation>&amp;Tema</translation></message>
<message><source>Lan&amp;guage</source><translation>Id&amp;ioma</translation></message>
<message><source>The window uses this language from the next start on.</source><translation>La ventana habla este idioma desde su próximo inicio.</translation></message>
<message><source>Restart Now</source><translation>Reiniciar ahora</translation></message>
<message><source>&amp;Mouse</source><translation>Mo&amp;use</translation></message>
<message><source>&amp;Default: middle pans, right zooms</source><translation>&amp;Predeterminado: el central desplaza, el derecho acerca y aleja</translation></message>
<message><source>&amp;CloudCompare: right pans, middle zooms</source><translation>&amp;CloudCompare: el derecho desplaza, el central acerca y aleja</translation></message>
<message><source>&amp;Wheel the other way</source><translation>&amp;Rueda en sentido inverso</translation></message>
<message><source>By &amp;Intensity</source><translation>Por &amp;intensidad</translation></message>
<message><source>By &amp;Intensity (this scan has none)</source><translation>Por &amp;intensidad (este escaneo no la tiene)</translation></message>
<message><source>Cloud C&amp;olour</source><translation>C&amp;olor de la nube</translation></message>
<message><source>G&amp;ray</source><translation>&amp;Gris</translation></message>
<message><source>By &amp;Range</source><translation>Por &amp;distancia</translation></message>
<message><source>By &amp;Height</source><translation>Por &amp;altura</translation></message>
<message><source>By &amp;Line</source><translation>Por &amp;línea</translation></message>
<message><source>&amp;Sizes of Views</source><translation>&amp;Tamaños de las vistas</translation></message>
<message><source>&amp;Next Sizes of Views</source><translation>&amp;Siguientes tamaños de las vistas</translation></message>
<message><source>&amp;Balanced</source><translation>&amp;Equilibrado</translation></message>
<message><source>&amp;Images Large</source><translation>&amp;Imágenes grandes</translation></message>
<message><source>&amp;Cloud Large</source><translation>&amp;Nube grande</translation></message>
<message><source>C&amp;ab Mode</source><translation>Modo c&amp;abina</translation></message>
<message><source>Next Sweep</source><translation>Barrido siguiente</translation></message>
<message><source>Undo brings %1 back with its targets and measurements: the next sweep replaced it.</source><translation>Deshacer recupera %1 con sus objetivos y mediciones: el barrido siguiente lo sustituyó.</translation></message>
<message><source>%1 is no longer compared as A, because it may be of another place. Undo (Ctrl+Z) brings it back.</source><translation>%1 ya no se compara como A, porque puede ser de otro lugar. Deshacer (Ctrl+Z) lo recupera.</translation></message>
<message><source>The window has no room for the images next to this panel: they come back when you fold it.</source><translation>La ventana no tiene sitio para las imágenes junto a este panel: vuelven cuando usted lo pliega.</translation></message>
<message><source>Close EdgeScan?</source><translation>¿Cerrar EdgeScan?</translation></message>
<message><source>A recording is being written.</source><translation>Se está escribiendo una grabación.</translation></message>
<message><source>A file is still being written.</source><translation>Todavía se está escribiendo un archivo.</translation></message>
<message><source>Your targets and your edits of rocks are not stored.</source><translation>Sus objetivos y sus ediciones de rocas no están guardados.</translation></message>
<message><source>Your targets are not stored.</source><translation>Sus objetivos no están guardados.</translation></message>
<message><source>Your edits of rocks are not stored.</source><translation>Sus ediciones de rocas no están guardadas.</translation></message>
<message><source>This ends the program.</source><translation>Esto termina el programa.</translation></message>
<message><source>Closing ends the recording. What was recorded so far remains in its file.</source><translation>Al cerrar termina la grabación. Lo grabado hasta ahora queda en su archivo.</translation></message>
<message><source>Closing waits until it is complete.</source><translation>El cierre espera hasta que esté completo.</translation></message>
<message><source>The disk refused them. EdgeScan tries again as it closes; what it cannot write then is lost.</source><translation>El disco los rechazó. EdgeScan lo intenta otra vez al cerrarse; lo que entonces no pueda escribir se pierde.</translation></message>
<message><source>To leave cab mode only, cancel, then hold the button “Hold to leave” for one second.</source><translation>Para salir solo del modo cabina, cancele y mantenga un segundo el botón «Mantener: salir».</translation></message>
<message><source>End the Recording and Close</source><translation>Terminar la grabación y cerrar</translation></message>
<message><source>Close EdgeScan</source><translation>Cerrar EdgeScan</translation></message>
<message><source>The tour has ended; Help &gt; Tour begins it again.</source><translation>El recorrido ha terminado; Ayuda &gt; Recorrido lo empieza de nuevo.</translation></message>
<message><source>Drawing with edge lines</source><translation>Dibujo con las líneas de los bordes</translation></message>
<message><source>E57</source><translation>E57</translation></message>
<message><source>Range picture</source><translation>Imagen de distancias</translation></message>
<message><source>LAS point cloud</source><translation>Nube de puntos LAS</translation></message>
<message><source>numpy array</source><translation>Matriz numpy</translation></message>
<message><source>Wavefront OBJ</source><translation>OBJ de Wavefront</translation></message>
<message><source>Point Cloud Library</source><translation>Point Cloud Library (PCL)</translation></message>
<message><source>Polygon file</source><translation>Archivo de polígonos</translation></message>
<message><source>Point list</source><translation>Lista de puntos</translation></message>
<message><source>Point table</source><translation>Tabla de puntos</translation></message>
<message><source>3DTK scan</source><translation>Escaneo 3DTK</translation></message>
<message><source>Leica PTX</source><translation>Leica PTX</translation></message>
<message><source>Range or point table</source><translation>Tabla de distancias o de puntos</translation></message>
<message><source>Raw grid</source><translation>Cuadrícula sin procesar</translation></message>
<message><source>Recording</source><translation>Grabación</translation></message>
<message><source>How edges are found: jumps and folds of the surface, parts of these, or Canny on gray levels as in the thesis, or one of the other detectors the thesis compares.</source><translation>Cómo se encuentran los bordes: saltos y pliegues de la superficie, partes de estos, o Canny en niveles de gris como en la tesis, o uno de los otros detectores que la tesis compara.</translation></message>
<message><source>Edges shown</source><translation>Bordes mostrados</translation></message>
<message><source>Only edges that are likely the border of a rock are shown and exported; folds within a rock are left out.</source><translation>Solo se muestran y exportan los bordes que probablemente son el contorno de una roca; los pliegues dentro de una roca se omiten.</translation></message>
<message><source>Border from</source><translation>Contorno desde</translation></message>
<message><source>How likely an edge must be the border of a rock to be shown among the rock borders.</source><translation>La probabilidad de que un borde sea el contorno de una roca, desde la que se muestra entre los contornos de rocas.</translation></message>
<message><source>Edge strength</source><translation>Fuerza del borde</translation></message>
<message><source>How strong an edge must be, so higher finds fewer: 1 is the jump and the crease angle below, 2 is twice that.</source><translation>Qué fuerza debe tener un borde (más fuerza, menos bordes): 1 es el salto y el ángulo de pliegue de abajo, 2 es el doble.</translation></message>
<message><source>Jump</source><translation>Salto</translation></message>
<message><source>Smallest step in depth that is an edge, near the scanner; auto takes 30 mm and more where the ranges are noisy.</source><translation>Menor escalón de profundidad que es un borde, cerca del escáner; auto toma 30 mm, y más donde las distancias tienen ruido.</translation></message>
<message><source>Jump growth</source><translation>Crecimiento del salto</translation></message>
<message><source>% of range</source><translation>% dist.</translation></message>
<message><source>What the smallest step grows by with the distance.</source><translation>Cuánto crece el menor escalón con la distancia.</translation></message>
<message><source>Crease angle</source><translation>Ángulo de pliegue</translation></message>
<message><source>Smallest fold of the surface that is an edge.</source><translation>Menor pliegue de la superficie que es un borde.</translation></message>
<message><source>Minimum length</source><translation>Longitud mínima</translation></message>
<message><source>Shorter chains of edge cells are dropped. At a void each class is chained by itself: a rim in two classes is two chains.</source><translation>Las cadenas más cortas de celdas de borde se descartan. En un vacío, cada clase forma sus propias cadenas: un borde en dos clases son dos cadenas.</translation></message>
<message><source>Which edges count: jumps in depth, convex folds (ridges), concave folds (contacts between rocks), the near side of a void with something farther behind it, and the rim of an open void; and where the data end, which is not an edge.</source><translation>Qué bordes cuentan: saltos de profundidad, pliegues convexos (crestas), pliegues cóncavos (contactos entre rocas), el lado cercano de un vacío con algo más lejos detrás y el borde de un vacío abierto; y, lo que no es un borde, donde terminan los datos.</translation></message>
<message><source>Hysteresis low</source><translation>Histéresis, umbral bajo</translation></message>
<message><source>% of high</source><translation>% del alto</translation></message>
<message><source>Weaker cells of this strength are edges where they continue a strong one.</source><translation>Las celdas más débiles, de esta fuerza, son bordes donde continúan una fuerte.</translation></message>
<message><source>Grazing tolerance</source><translation>Tolerancia rasante</translation></message>
<message><source>steps</source><translation>pasos</translation></message>
<message><source>How far out of place a beam may be before a grazing surface shows a jump: 0.1 for a motor sweep, 1 for interlaced beams.</source><translation>Cuánto puede estar fuera de lugar un haz antes de que una superficie rasante muestre un salto: 0.1 para un barrido motorizado, 1 para haces entrelazados.</translation></message>
<message><source>Allow for slips</source><translation>Tener en cuenta los deslizamientos</translation></message>
<message><source>Beams interlaced from two passes and lines at which the stepper slipped are recognised and taken into account.</source><translation>Los haces entrelazados de dos pasadas y las líneas en que el motor paso a paso patinó se reconocen y se tienen en cuenta.</translation></message>
<message><source>Allow for turns</source><translation>Tener en cuenta los retrocesos</translation></message>
<message><source>At the first and last lines of a sweep a stepper may still swing back, so that every surface seems to fold there; such folds are left out.</source><translation>En las primeras y últimas líneas de un barrido, el motor puede retroceder todavía, y toda superficie parece plegarse allí; esos pliegues se descartan.</translation></message>
<message><source>Range noise at 5 m</source><translation>Ruido de distancia a 5 m</translation></message>
<message><source>Sigma of the ranges at 5 m; auto measures it in the scan.</source><translation>Sigma de las distancias a 5 m; auto lo mide en el escaneo.</translation></message>
<message><source>Noise from cell to cell</source><translation>Ruido de celda a celda</translation></message>
<message><source>Whether each cell errs for itself, as with a laser, or neighbours err alike, as with a depth camera whose depth comes in steps: folds then have to exceed what such steps look like.</source><translation>Si cada celda yerra por sí misma, como con un láser, o si las vecinas yerran juntas, como con una cámara de profundidad cuya profundidad viene en escalones: los pliegues deben entonces superar lo que parecen tales escalones.</translation></message>
<message><source>Rules</source><translation>Reglas</translation></message>
<message><source>How noise is measured and where the rim of a void ends: as today, or as in default set 4, which also has a rule for rough scans.</source><translation>Cómo se mide el ruido y dónde acaba el borde de un vacío: como hoy, o como en el conjunto predeterminado 4, que tiene además una regla para escaneos rugosos.</translation></message>
<message><source>Rough scans</source><translation>Escaneos rugosos</translation></message>
<message><source>Only by the rules of default set 4. Where half of the folds are on surfaces that fold everywhere, such as heaps of small boulders, a fold counts only if it exceeds its surroundings.</source><translation>Solo con las reglas del conjunto predeterminado 4. Donde la mitad de los pliegues están en superficies plegadas por todas partes, como montones de piedras pequeñas, un pliegue cuenta solo si supera su entorno.</translation></message>
<message><source>Fill gaps</source><translation>Rellenar huecos</translation></message>
<message><source>Gaps up to this width are filled from their surroundings, never across a jump. Filled cells are marked and never count as measured. 0 switches filling off.</source><translation>Los huecos de hasta este ancho se rellenan con lo que los rodea, nunca sobre un salto; las celdas rellenadas se marcan y no cuentan como medidas. 0 no rellena ninguno.</translation></message>
<message><source>Edges in gaps</source><translation>Bordes en huecos</translation></message>
<message><source>Filled cells take part in finding edges, and may be edges that no beam measured.</source><translation>Las celdas rellenadas participan en la búsqueda de bordes, y pueden ser bordes que nadie midió.</translation></message>
<message><source>Lower threshold</source><translation>Umbral inferior</translation></message>
<message><source>levels</source><translation>niveles</translation></message>
<message><source>A cell with a gradient above this is an edge: with Canny if a chain of such cells leads to a strong one, with detectors of one threshold always.</source><translation>Una celda con un gradiente superior a este es un borde: con Canny si una cadena de tales celdas lleva a una fuerte, con los detectores de un umbral siempre.</translation></message>
<message><source>Step</source><translation>Escalón</translation></message>
<message><source>A straight step of this share of the range is a weak edge, one of about ratio times that a strong one.</source><translation>Un escalón recto de esta proporción de la distancia es un borde débil, uno de alrededor de la razón por eso es uno fuerte.</translation></message>
<message><source>Ratio upper : lower</source><translation>Razón superior : inferior</translation></message>
<message><source>Upper threshold as a multiple of the lower one; the thesis keeps 3.</source><translation>Umbral superior como múltiplo del inferior; la tesis mantiene 3.</translation></message>
<message><source>Gaussian kernel</source><translation>Kernel gaussiano</translation></message>
<message><source>Size of the smoothing kernel; 1 switches smoothing off.</source><translation>Tamaño del kernel de suavizado; 1 desactiva el suavizado.</translation></message>
<message><source>Gaussian sigma</source><translation>Sigma gaussiano</translation></message>
<message><source>Width of the smoothing; auto takes it from the kernel size.</source><translation>Ancho del suavizado; auto lo toma del tamaño del kernel.</translation></message>
<message><source>Gray scaling</source><translation>Escala de grises</translation></message>
<message><source>How ranges become gray levels: as the thesis prints it, evenly from near to far, or by equal ratios from near to far.</source><translation>Cómo las distancias se convierten en niveles de gris: como lo imprime la tesis, de manera uniforme de cerca a lejos, o por razones iguales de cerca a lejos.</translation></message>
<message><source>Near</source><translation>Cerca</translation></message>
<message><source>Range drawn as gray 0; auto takes it from the scan. Not used by thesis scaling.</source><translation>Distancia dibujada como gris 0; auto la toma del escaneo. No se usa con la escala de la tesis.</translation></message>
<message><source>Far</source><translation>Lejos</translation></message>
<message><source>Range drawn as gray 255; auto takes it from the scan. Not used by thesis scaling.</source><translation>Distancia dibujada como gris 255; auto la toma del escaneo. No se usa con la escala de la tesis.</translation></message>
<message><source>Mask missing data</source><translation>Enmascarar datos faltantes</translation></message>
<message><source>Keeps cells without a range out of smoothing and gradient, so that the border of a hole is not an edge.</source><translation>Deja las celdas sin distancia fuera del suavizado y del gradiente, para que el límite de un hueco no sea un borde.</translation></message>
<message><source>Mask isolated cells</source><translation>Enmascarar celdas aisladas</translation></message>
<message><source>With missing data masked: a cell that fewer than 2 of its 8 neighbours agree with (dust) counts as missing.</source><translation>Con los datos faltantes enmascarados: una celda con la que concuerdan menos de 2 de sus 8 vecinas (polvo) cuenta como faltante.</translation></message>
<message><source>Sobel aperture</source><translation>Apertura de Sobel</translation></message>
<message><source>Size of the gradient operator; larger ones need thresholds many times higher.</source><translation>Tamaño del operador de gradiente; los más grandes necesitan umbrales muchas veces mayores.</translation></message>
<message><source>Gradient norm</source><translation>Norma del gradiente</translation></message>
<message><source>How the two gradient components become one magnitude.</source><translation>Cómo las dos componentes del gradiente se convierten en una magnitud.</translation></message>
<message><source>Laplacian mask</source><translation>Máscara del laplaciano</translation></message>
<message><source>Which mask approximates the Laplacian of Gaussian.</source><translation>Qué máscara representa el laplaciano de gaussiana.</translation></message>
<message><source>All edges</source><translation>Todos</translation></message>
<message><source>Rock borders</source><translation>De rocas</translation></message>
<message><source>Even</source><translation>Uniforme</translation></message>
<message><source>Logarithmic</source><translation>Logarítmica</translation></message>
<message><source>1 (off)</source><translation>1 (desactivado)</translation></message>
<message><source>L1  |gx| + |gy|</source><translation>L1  |gx| + |gy|</translation></message>
<message><source>L2  sqrt(gx² + gy²)</source><translation>L2 √(gx² + gy²)</translation></message>
<message><source>4 neighbours</source><translation>4 vecinas</translation></message>
<message><source>8 neighbours</source><translation>8 vecinas</translation></message>
<message><source>of default set 4</source><translation>del conjunto 4</translation></message>
<message><source>of today</source><translation>de hoy</translation></message>
<message><source>as measured</source><translation>según lo medido</translation></message>
<message><source>laser</source><translation>láser</translation></message>
<message><source>depth camera</source><translation>cámara 3D</translation></message>
<message><source>EdgeScan+</source><translation>EdgeScan+</translation></message>
<message><source>Rock outlines</source><translation>Contornos de rocas</translation></message>
<message><source>Jumps</source><translation>Saltos</translation></message>
<message><source>Canny (thesis)</source><translation>Canny (tesis)</translation></message>
<message><source>Canny on log range</source><translation>Canny, log(distancia)</translation></message>
<message><source>Roberts</source><translation>Roberts</translation></message>
<message><source>Sobel</source><translation>Sobel</translation></message>
<message><source>Prewitt</source><translation>Prewitt</translation></message>
<message><source>Kirsch</source><translation>Kirsch</translation></message>
<message><source>Robinson</source><translation>Robinson</translation></message>
<message><source>Marr-Hildreth</source><translation>Marr-Hildreth</translation></message>
<message><source>Laplacian (LoG)</source><translation>Laplaciano (LoG)</translation></message>
<message><source>EdgeScan+: jumps in depth and folds of the surface, with thresholds that follow the noise of the scan.</source><translation>EdgeScan+: saltos de profundidad y pliegues de la superficie, con umbrales que siguen el ruido del escaneo.</translation></message>
<message><source>Canny on logarithmic gray levels, so that a step counts in percent of its range; missing data masked, so that a hole has no edge.</source><translation>Canny sobre niveles de gris logarítmicos: un escalón cuenta en porcentaje de su distancia; los datos ausentes se enmascaran, así que un hueco no tiene borde.</translation></message>
<message><source>The thesis to the letter: 255 / (Smax - Smin), 3x3 Gaussian, 1:3, holes are black.</source><translation>La tesis al pie de la letra: 255 / (Smax - Smin), gaussiana 3x3, 1:3, los huecos son negros.</translation></message>
<message><source>As the thesis, but the gray levels run from the nearest to the farthest range.</source><translation>Como la tesis, pero los niveles de gris van de la distancia más cercana a la más lejana.</translation></message>
<message><source>As default, for flat and quiet surfaces: low steps are edges far away too.</source><translation>Como default, para superficies planas y con poco ruido: los escalones bajos son bordes también de lejos.</translation></message>
<message><source>The default settings of version 4: the noise includes relief, rims end where a surface slants by 70 degrees, and on a scan of rough surfaces folds must exceed their surroundings.</source><translation>Los ajustes predeterminados de la versión 4: el ruido incluye el relieve, los bordes de vacíos acaban donde una superficie se inclina 70 grados, y en un escaneo rugoso los pliegues deben superar su entorno.</translation></message>
<message><source>The default settings of version 3: no rims of open voids, chains of five cells and more, rough scans and turns of the stepper as any other.</source><translation>Los ajustes predeterminados de la versión 3: sin bordes de vacíos abiertos, cadenas de cinco celdas o más, sin atender a escaneos rugosos ni a retrocesos del motor.</translation></message>
<message><source>Fine to coarse</source><translation>Fino a grueso</translation></message>
<message><source>How easily pieces are joined into one rock. Lower: more and smaller rocks. Higher: fewer and larger rocks.</source><translation>Con qué facilidad los trozos se unen en una roca. Más bajo: más rocas y más pequeñas. Más alto: menos rocas y más grandes.</translation></message>
<message><source>Smallest rock</source><translation>Roca más pequeña</translation></message>
<message><source>Pieces with fewer measured cells are fines, not rocks.</source><translation>Los trozos de menos celdas medidas son finos y no rocas.</translation></message>
<message><source>Farthest rock</source><translation>Roca más lejana</translation></message>
<message><source>A region farther away is not a rock.</source><translation>Lo que está más lejos no es una roca.</translation></message>
<message><source>Rarely longer than</source><translation>Rara vez más largo que</translation></message>
<message><source>Longer pieces need better evidence that they are rocks and not walls. The length is about the visible length a.</source><translation>Los trozos más largos necesitan mejores señales de ser una roca y no una pared. El largo es aproximadamente el largo visible a.</translation></message>
<message><source>Oversize</source><translation>Sobretamaño</translation></message>
<message><source>The share of rocks whose visible width is larger is reported; 0 reports none.</source><translation>Se indica la proporción de rocas cuyo ancho visible es mayor; 0 no indica ninguna.</translation></message>
<message><source>Easting E [m]</source><translation>Este E [m]</translation></message>
<message><source>Northing N [m]</source><translation>Norte N [m]</translation></message>
<message><source>Datum</source><translation>Datum</translation></message>
<message><source>XYZ and CSV with all columns, and the grid and the record in comment lines: GIS and spreadsheet programs may refuse them</source><translation>XYZ y CSV con todas las columnas, y la cuadrícula y el registro en líneas de comentario: los SIG y las planillas de cálculo pueden rechazarlos</translation></message>
<message><source>PCD in mine coordinates with numbers of 8 bytes, which PCL and Open3D do not read; else metres from an origin in a comment</source><translation>PCD en coordenadas mina con números de 8 bytes, que PCL y Open3D no leen; si no, en metros desde un origen en un comentario</translation></message>
<message><source>DXF of release 2000 instead of release 12</source><translation>DXF de versión 2000 en vez de versión 12</translation></message>
<message><source>DXF: also the edge lines of two points only</source><translation>DXF: también las líneas de borde de solo dos puntos</translation></message>
<message><source>PCD, PLY and CSV: also the cells that were filled and not measured, which the field filled_sd_mm marks</source><translation>PCD, PLY y CSV: también las celdas rellenadas y no medidas, que el campo filled_sd_mm marca</translation></message>
<message><source>PCD, PLY and CSV: the field confidence, how many percent of nearby settings find the edge too; 0 where there is none</source><translation>PCD, PLY y CSV: el campo confidence, qué porcentaje de ajustes cercanos halla también el borde; 0 donde no hay</translation></message>
<message><source>PCD, PLY and CSV: the field border, how likely each edge is the border of a rock, in percent; NaN where unknown and where no edge is</source><translation>PCD, PLY y CSV: el campo border, la probabilidad de que cada borde sea el contorno de una roca, en porcentaje; NaN donde se desconoce y donde no hay borde</translation></message>
<message><source>&amp;Edge Cloud…</source><translation>Nube de &amp;bordes…</translation></message>
<message><source>Edge points (%1)</source><translation>Puntos de borde (%1)</translation></message>
<message><source>&amp;Full Cloud…</source><translation>Nube &amp;completa…</translation></message>
<message><source>All points, with a field for edges (%1)</source><translation>Todos los puntos, con un campo para los bordes (%1)</translation></message>
<message><source>Edge &amp;Image…</source><translation>&amp;Imagen de bordes…</translation></message>
<message><source>Edge map as a picture, %1</source><translation>Mapa de bordes como imagen, %1</translation></message>
<message><source>&amp;Gray Image…</source><translation>Imagen en &amp;grises…</translation></message>
<message><source>Gray image, %1</source><translation>Imagen en grises, %1</translation></message>
<message><source>&amp;Range Image…</source><translation>Imagen de &amp;distancias…</translation></message>
<message><source>Ranges in millimetres as a picture of 16 bits, %1</source><translation>Distancias en milímetros como imagen de 16 bits, %1</translation></message>
<message><source>&amp;Targets…</source><translation>&amp;Objetivos…</translation></message>
<message><source>Targets (%1)</source><translation>Objetivos (%1)</translation></message>
<message><source>Report with settings and edits</source><translation>Informe con ajustes y ediciones</translation></message>
<message><source>Table, one row per rock</source><translation>Tabla, una fila por roca</translation></message>
<message><source>Labels as a 16-bit picture</source><translation>Etiquetas como imagen de 16 bits</translation></message>
<message><source>Outlines in space</source><translation>Contornos en el espacio</translation></message>
<message><source>Outlines in the mine grid</source><translation>Contornos en coordenadas mina</translation></message>
<message><source>Convex hulls of the visible points</source><translation>Envolventes convexas de los puntos visibles</translation></message>
<message><source>Rock</source><translation>Roca</translation></message>
<message><source>The number: without edits, 1 is the largest visible area</source><translation>El número: sin ediciones, 1 es la mayor área visible</translation></message>
<message><source>visible length a [m]</source><translation>largo visible a [m]</translation></message>
<message><source>Largest visible span across the line of sight; hidden parts are not counted</source><translation>Mayor extensión visible transversal a la línea de visión; las partes ocultas no cuentan</translation></message>
<message><source>size: visible width b [m]</source><translation>tamaño: ancho visible b [m]</translation></message>
<message><source>Size of the rock: smallest visible span across the line of sight; hidden parts are not counted</source><translation>Tamaño de la roca: menor extensión visible transversal a la línea de visión; las partes ocultas no cuentan</translation></message>
<message><source>± of a and b [m]</source><translation>± de a y b [m]</translation></message>
<message><source>Of a and b: spacing of the points and width of the beam, twice</source><translation>De a y b: espaciado de los puntos y ancho del haz, dos veces</translation></message>
<message><source>distance [m]</source><translation>distancia [m]</translation></message>
<message><source>From the scanner: median of its ranges</source><translation>Desde el escáner: mediana de sus distancias</translation></message>
<message><source>area [m²]</source><translation>área [m²]</translation></message>
<message><source>Visible area across the beams</source><translation>Área visible transversal a los haces</translation></message>
<message><source>in front [%]</source><translation>delante [%]</translation></message>
<message><source>Share of its outline where it is the nearer side</source><translation>Parte de su contorno donde es el lado más cercano</translation></message>
<message><source>contacts (≥)</source><translation>contactos (≥)</translation></message>
<message><source>Rocks that it is seen to touch: at least these</source><translation>Rocas que se ve que toca: al menos estas</translation></message>
<message><source>free below [m]</source><translation>libre debajo [m]</translation></message>
<message><source>Free height under its lowest visible point: at least this; what sent nothing back is never free; without a pose, up is the scanner's z axis</source><translation>Altura libre bajo su punto visible más bajo: al menos esta; lo que no devolvió nada nunca está libre; sin pose, hacia arriba es el eje z del escáner</translation></message>
<message><source>arch [°] ± 25</source><translation>arco [°] ± 25</translation></message>
<message><source>Largest angle at it between two rocks that it touches; ↓: it hangs below the line between them; without a pose, up is the scanner's z axis</source><translation>Mayor ángulo en ella entre dos rocas que toca; ↓: cuelga por debajo de la línea que las une; sin pose, hacia arriba es el eje z del escáner</translation></message>
<message><source>Chance that its outline is right; ▲ and hatched: below 0.85</source><translation>Probabilidad de que su contorno sea correcto; ▲ y achurado: menos de 0.85</translation></message>
<message><source>candidate - geometry only, one viewpoint</source><translation>candidato - solo geometría, un solo punto de vista</translation></message>
<message><source>Unit</source><translation>Unidad</translation></message>
<message><source>Line angles</source><translation>Ángulos de las líneas</translation></message>
<message><source>Order of the lines</source><translation>Orden de las líneas</translation></message>
<message><source>straightened</source><translation>enderezados</translation></message>
<message><source>where their angles say</source><translation>donde dicen sus ángulos</translation></message>
<message><source>as they were recorded</source><translation>tal como se grabaron</translation></message>
<message><source>straightened by the scan's own surfaces</source><translation>enderezados según las propias superficies del escaneo</translation></message>
<message><source>millimetres, so that half of the ranges are below %1 m</source><translation>milímetros, de modo que la mitad de las distancias es inferior a %1 m</translation></message>
<message><source>millimetres: half of the ranges are below %1 m</source><translation>milímetros: la mitad de las distancias es inferior a %1 m</translation></message>
<message><source>centimetres, so that half of the ranges are below %1 m</source><translation>centímetros, de modo que la mitad de las distancias es inferior a %1 m</translation></message>
<message><source>centimetres: half of the ranges are below %1 m</source><translation>centímetros: la mitad de las distancias es inferior a %1 m</translation></message>
<message><source>metres, so that half of the ranges are below %1 m</source><translation>metros, de modo que la mitad de las distancias es inferior a %1 m</translation></message>
<message><source>metres: half of the ranges are below %1 m</source><translation>metros: la mitad de las distancias es inferior a %1 m</translation></message>
<message><source>%2 mm, so that half of the ranges are below %1 m</source><translation>%2 mm, de modo que la mitad de las distancias es inferior a %1 m</translation></message>
<message><source>In the unit that was taken half of the ranges are below %1 m, which is unusual for a scan of rocks.</source><translation>En la unidad que se tomó, la mitad de las distancias es inferior a %1 m, lo que no es habitual en un escaneo de rocas.</translation></message>
<message><source>spin: the stepper turns about the viewing direction; %1 of %2 flat pieces lie on three planes</source><translation>spin: el motor paso a paso gira en torno a la dirección de visión; %1 de %2 trozos planos están en tres planos</translation></message>
<message><source>spin, about the viewing direction: %1 of %2 flat pieces lie on three planes</source><translation>spin, en torno a la dirección de visión: %1 de %2 trozos planos están en tres planos</translation></message>
<message><source>Walls bend with mounting spin: %1 of %2 flat pieces lie on three planes, with sweep %3 do.</source><translation>Las paredes se curvan con el montaje spin: %1 de %2 trozos planos están en tres planos, con sweep son %3.</translation></message>
<message><source>The ranges do not fit mounting spin: from line to line they stay the same at beams 0 and 180 degrees, as with sweep.</source><translation>Las distancias no concuerdan con el montaje spin: de línea a línea son iguales en los haces de 0 y 180 grados, como con sweep.</translation></message>
<message><source>sweep: the stepper turns about the 0/180 degree line; %1 of %2 flat pieces lie on three planes</source><translation>sweep: el motor paso a paso gira en torno a la línea 0/180 grados; %1 de %2 trozos planos están en tres planos</translation></message>
<message><source>sweep, about the 0/180 degree line: %1 of %2 flat pieces lie on three planes</source><translation>sweep, en torno a la línea 0/180 grados: %1 de %2 trozos planos están en tres planos</translation></message>
<message><source>Walls bend with mounting sweep: %1 of %2 flat pieces lie on three planes, with spin %3 do.</source><translation>Las paredes se curvan con el montaje sweep: %1 de %2 trozos planos están en tres planos, con spin son %3.</translation></message>
<message><source>The ranges do not fit mounting sweep: from line to line they stay the same at beam 90 degrees, as with spin.</source><translation>Las distancias no concuerdan con el montaje sweep: de línea a línea son iguales en el haz de 90 grados, como con spin.</translation></message>
<message><source>a step of %3 degrees, %4 in all: %1 of %2 flat pieces lie on three planes</source><translation>un paso de %3 grados, %4 en total: %1 de %2 trozos planos están en tres planos</translation></message>
<message><source>Walls bend at the line angles that were taken: %1 of %2 flat pieces lie on three planes, other steps give more.</source><translation>Las paredes se curvan con los ángulos de línea que se tomaron: %1 de %2 trozos planos están en tres planos, otros pasos dan más.</translation></message>
<message><source>a step of %3 degrees, %4 in all; %1 of %2 flat pieces lie on three planes</source><translation>un paso de %3 grados, %4 en total; %1 de %2 trozos planos están en tres planos</translation></message>
<message><source>a step of %3 degrees, %4 in all; rough rock cannot show it: choose how far the motor turned in all</source><translation>un paso de %3 grados, %4 en total; la roca rugosa no puede mostrarlo: elija cuánto giró el motor en total</translation></message>
<message><source>line angles from %1 to %2 degrees; ranges cannot show whether left and right are exchanged</source><translation>ángulos de las líneas de %1 a %2 grados; ninguna distancia dice si izquierda y derecha están intercambiadas</translation></message>
<message><source>the other way round: left and right exchanged</source><translation>al revés: izquierda y derecha intercambiadas</translation></message>
<message><source>%1 lines of %2 beams, found from the directions of the points</source><translation>%1 líneas de %2 haces, halladas por las direcciones de los puntos</translation></message>
<message><source>projected onto cells of %1 degrees; %2 % of the points are behind others of their cell</source><translation>proyectado en celdas de %1 grados; el %2 % de los puntos está detrás de otros de su celda</translation></message>
<message><source>%1 % of the points are behind others of their cell: the cells are coarse, or the sensor was at another place.</source><translation>El %1 % de los puntos está detrás de otros de su celda: las celdas son gruesas, o el sensor estaba en otro lugar.</translation></message>
<message><source>cells of %1 degrees</source><translation>celdas de %1 grados</translation></message>
<message><source>Topic</source><translation>Tópico</translation></message>
<message><source>Sweep</source><translation>Barrido</translation></message>
<message><source>%1: lines of %2 beams; messages: %3, per second: %4</source><translation>%1: líneas de %2 haces; mensajes: %3, por segundo: %4</translation></message>
<message><source>%1: clouds of %2 points; messages: %3, per second: %4</source><translation>%1: nubes de %2 puntos; mensajes: %3, por segundo: %4</translation></message>
<message><source>from %1</source><translation>según %1</translation></message>
<message><source>sweep %1 of the topic, counted from 0; the topic holds %2</source><translation>barrido %1 del tópico, contado desde 0; el tópico contiene %2</translation></message>
<message><source>sweep %1, counted from 0</source><translation>barrido %1, contado desde 0</translation></message>
<message><source>Beams and lines</source><translation>Haces y líneas</translation></message>
<message><source>the threshold %1</source><translation>el umbral %1</translation></message>
<message><source>the lower threshold %1</source><translation>el umbral inferior %1</translation></message>
<message><source>the upper threshold %1</source><translation>el umbral superior %1</translation></message>
<message><source>it is an edge, but only %1 % likely the border of a rock, and only those from %2 % on are shown (%3)</source><translation>es un borde, pero solo con un %1 % de probabilidad el contorno de una roca, y solo se muestran los que tienen %2 % o más (%3)</translation></message>
<message><source>%1 the fold at %2 next to it is stronger (%3 against %4), and an edge is one cell wide</source><translation>%1 el pliegue en %2, a su lado, es más fuerte (%3 frente a %4), y un borde tiene una celda de ancho</translation></message>
<message><source>%1 the fold at %2 next to it is as strong (%3 against %4), and an edge is one cell wide</source><translation>%1 el pliegue en %2, a su lado, es igual de fuerte (%3 frente a %4), y un borde tiene una celda de ancho</translation></message>
<message><source>%1 next to it is stronger (%2), and an edge is one cell wide</source><translation>%1, a su lado, es más fuerte (%2), y un borde tiene una celda de ancho</translation></message>
<message><source>%1 next to it is as strong (%2), and an edge is one cell wide</source><translation>%1, a su lado, es igual de fuerte (%2), y un borde tiene una celda de ancho</translation></message>
<message><source>the step of %1 m belongs to %2, which is the nearer cell</source><translation>el escalón de %1 m pertenece a %2, que es la celda más cercana</translation></message>
<message><source>%1 is below %2</source><translation>%1 está por debajo de %2</translation></message>
<message><source>%1 does not exceed %2</source><translation>%1 no supera %2</translation></message>
<message><source>%1, and %2 next to it is stronger</source><translation>%1, y %2, a su lado, es más fuerte</translation></message>
<message><source>%1 is above %2, but no chain of such cells leads to one above %3</source><translation>%1 está por encima de %2, pero ninguna cadena de celdas así lleva a una por encima de %3</translation></message>
<message><source>its chain has 1 cell, fewer than the minimum length %1</source><translation>su cadena tiene 1 celda, menos que el largo mínimo %1</translation></message>
<message><source>its chain has %1 cells, fewer than the minimum length %2</source><translation>su cadena tiene %1 celdas, menos que el largo mínimo %2</translation></message>
<message><source>%1 is enough where it continues its chain</source><translation>%1 basta donde continúa su cadena</translation></message>
<message><source>%1 is above %2, and 1 cell on, at %3, its chain reaches %4</source><translation>%1 está por encima de %2, y 1 celda más allá, en %3, su cadena alcanza %4</translation></message>
<message><source>%1 is above %2, and %3 cells on, at %4, its chain reaches %5</source><translation>%1 está por encima de %2, y %3 celdas más allá, en %4, su cadena alcanza %5</translation></message>
<message><source>it is a single cell and takes no part</source><translation>es una celda aislada y no cuenta</translation></message>
<message><source>it has no range</source><translation>no tiene distancia</translation></message>
<message><source>the strength %1 of its %2</source><translation>la fuerza %1 de su clase “%2”</translation></message>
<message><source>its strength %1</source><translation>su fuerza %1</translation></message>
<message><source>%1 is above %2</source><translation>%1 está por encima de %2</translation></message>
<message><source>it is next to missing data, and such borders are a class that was chosen</source><translation>está junto a datos que faltan, y esos límites son una clase elegida</translation></message>
<message><source>the surface ends here before missing data, and what is behind them is farther away</source><translation>la superficie termina aquí ante datos que faltan, y lo que hay detrás está más lejos</translation></message>
<message><source>the surface ends here at an open void, from which nothing came back</source><translation>la superficie termina aquí en un vacío abierto, del que nada volvió</translation></message>
<message><source> (raised: beams are interlaced)</source><translation> (aumentada: los haces están entrelazados)</translation></message>
<message><source>relief %1</source><translation>relieve %1</translation></message>
<message><source>Step in depth: %1 m to %2 (%3; this cell is the nearer one), limit %4: strength %5.</source><translation>Escalón en profundidad: %1 m hasta %2 (%3; esta celda es la más cercana), límite %4: fuerza %5.</translation></message>
<message><source>Step in depth: %1 m to %2 (%3; that cell is the nearer one), limit %4: strength %5.</source><translation>Escalón en profundidad: %1 m hasta %2 (%3; la otra celda es la más cercana), límite %4: fuerza %5.</translation></message>
<message><source>%1 degrees, which noise alone may look like (%2 %3)</source><translation>%1 grados, lo que el ruido por sí solo puede parecer (%2 %3)</translation></message>
<message><source>%1 degrees = %2</source><translation>%1 grados = %2</translation></message>
<message><source>; %1 % of it counts, for the two sides do not meet at the cell</source><translation>; cuenta un %1 %, pues los dos lados no se encuentran en la celda</translation></message>
<message><source>Fold: %1 degrees convex, outwards (%2), limit %3: strength %4.</source><translation>Pliegue: %1 grados, convexo, hacia fuera (%2), límite %3: fuerza %4.</translation></message>
<message><source>Fold: %1 degrees concave, inwards (%2), limit %3: strength %4.</source><translation>Pliegue: %1 grados, cóncavo, hacia dentro (%2), límite %3: fuerza %4.</translation></message>
<message><source>Rough scan: %1 % of what is within 15 degrees folds, so a fold must be %2 times as strong here.</source><translation>Escaneo rugoso: el %1 % de lo que está a menos de 15 grados está plegado, así que un pliegue debe ser %2 veces más fuerte aquí.</translation></message>
<message><source>Rough scan: %1 % of what is within 15 degrees folds; a fold counts as elsewhere.</source><translation>Escaneo rugoso: el %1 % de lo que está a menos de 15 grados está plegado; un pliegue cuenta como en otras partes.</translation></message>
<message><source>No range of its own: the gap is filled from both sides, and edges go round it by the cells next to it.</source><translation>Sin distancia propia: el hueco se rellena desde ambos lados, y los bordes lo rodean por las celdas vecinas.</translation></message>
<message><source>No range of its own: the gap was filled on request, and its cells take part like measured ones.</source><translation>Sin distancia propia: el hueco se rellenó a petición, y sus celdas cuentan como las medidas.</translation></message>
<message><source>The edge of a cell without a range next to it goes round by this one.</source><translation>El borde de una celda vecina sin distancia pasa por esta.</translation></message>
<message><source>Nothing is known here: no step and no fold is measured next to missing data.</source><translation>Aquí no se sabe nada: junto a datos que faltan no se mide ni escalón ni pliegue.</translation></message>
<message><source>Mixed pixel: its range is between two surfaces. For edges it counts as %1 m, the one nearer to its range.</source><translation>Píxel mixto: su distancia está entre dos superficies. Para los bordes cuenta como %1 m, la más próxima a su distancia.</translation></message>
<message><source>Together with the other way %1.</source><translation>Junto con la otra dirección: %1.</translation></message>
<message><source>Range noise used: sigma %1 m here, %2 m at 5 m.</source><translation>Ruido de distancia usado: sigma %1 m aquí, %2 m a 5 m.</translation></message>
<message><source>Neighbours err alike, so for folds it counts as %1 m here.</source><translation>Los vecinos yerran igual, así que para los pliegues cuenta como %1 m aquí.</translation></message>
<message><source>Noisy ranges are smoothed, so for folds it counts as %1 m here.</source><translation>Las distancias ruidosas se suavizan, así que para los pliegues cuenta como %1 m aquí.</translation></message>
<message><source>%1: strength %2 as %3</source><translation>%1: fuerza %2 como %3</translation></message>
<message><source>%1: strength %2</source><translation>%1: fuerza %2</translation></message>
<message><source> (along the line %1, across the lines %2, direction %3 degrees)</source><translation> (a lo largo de la línea %1, a través de las líneas %2, dirección %3 grados)</translation></message>
<message><source> (direction %1 degrees)</source><translation> (dirección %1 grados)</translation></message>
<message><source>; %1 %2, %3 %4 % of it: weak from %5, strong from %6</source><translation>; %1 %2, %3 %4 % de ella: débil desde %5, fuerte desde %6</translation></message>
<message><source>, threshold %1</source><translation>, umbral %1</translation></message>
<message><source>, thresholds %1 and %2</source><translation>, umbrales %1 y %2</translation></message>
<message><source>Chain: 1 cell, strongest at %1 (%2).</source><translation>Cadena: 1 celda, la más fuerte en %1 (%2).</translation></message>
<message><source>Chain: %1 cells, strongest at %2 (%3).</source><translation>Cadena: %1 celdas, la más fuerte en %2 (%3).</translation></message>
<message><source>It is unknown if it is the border of a rock: the grid ends nearby, ranges are missing, or neighbours err alike.</source><translation>No se sabe si es el contorno de una roca: la cuadrícula acaba cerca, faltan distancias, o los vecinos yerran igual.</translation></message>
<message><source>It is %1 % likely the border of a rock, and not a fold within one.</source><translation>Con un %1 % de probabilidad es el contorno de una roca, y no un pliegue dentro de una.</translation></message>
<message><source>%1 (for it)</source><translation>%1 (a favor)</translation></message>
<message><source>%1 (against it)</source><translation>%1 (en contra)</translation></message>
<message><source>What decided that: %1.</source><translation>Lo que lo decide: %1.</translation></message>
<message><source>Left out: %1.</source><translation>Omitido: %1.</translation></message>
<message><source>Edge: %1; no value of %2 makes it one.</source><translation>Borde: %1; ningún valor de “%2” la hace borde.</translation></message>
<message><source>No edge: %1; no value of %2 makes it one.</source><translation>No es borde: %1; ningún valor de “%2” la hace borde.</translation></message>
<message><source>Edge: %1; as part of its chain it remains an edge at each %2, up to the largest: %3.</source><translation>Borde: %1; como parte de su cadena sigue siendo borde con cada %2, hasta el mayor valor: %3.</translation></message>
<message><source>Edge: %1; this remains an edge at each %2, up to the largest: %3.</source><translation>Borde: %1; sigue siendo borde con cada %2, hasta el mayor valor: %3.</translation></message>
<message><source>Edge: %1; as part of its chain it disappears only if you set %2 above %3.</source><translation>Borde: %1; como parte de su cadena solo desaparece si usted pone %2 por encima de %3.</translation></message>
<message><source>Edge: %1; it disappears if you set %2 above %3, because its chain is then shorter than the minimum length %4.</source><translation>Borde: %1; desaparece si usted pone %2 por encima de %3, porque entonces su cadena es más corta que la longitud mínima %4.</translation></message>
<message><source>Edge: %1; it disappears if you set %2 above %3.</source><translation>Borde: %1; desaparece si usted pone %2 por encima de %3.</translation></message>
<message><source>No edge: %1; this becomes an edge when %2 is %3 or less.</source><translation>No es borde: %1; pasa a ser un borde cuando %2 es %3 o menos.</translation></message>
<message><source>%1: range %2 m</source><translation>%1: distancia %2 m</translation></message>
<message><source>, gray %1</source><translation>, gris %1</translation></message>
<message><source>, smoothed %1</source><translation>, suavizado %1</translation></message>
<message><source>, class %1</source><translation>, clase %1</translation></message>
<message><source>steps in depth around it</source><translation>los saltos de profundidad a su alrededor</translation></message>
<message><source>its own fold</source><translation>su propio pliegue</translation></message>
<message><source>the surface across the edge</source><translation>la superficie a través del borde</translation></message>
<message><source>the surface along the edge</source><translation>la superficie a lo largo del borde</translation></message>
<message><source>its height over the surroundings</source><translation>su altura sobre el entorno</translation></message>
<message><source>folds around it</source><translation>los pliegues a su alrededor</translation></message>
<message><source>distance and noise</source><translation>la distancia y el ruido</translation></message>
<message><source>end %1 not on an edge</source><translation>extremo %1 fuera de un borde</translation></message>
<message><source>%1 ends not on an edge</source><translation>%1 extremos fuera de un borde</translation></message>
<message><source>1 end was moved to the near side</source><translation>1 extremo se movió al lado cercano</translation></message>
<message><source>%1 ends were moved to the near side</source><translation>%1 extremos se movieron al lado cercano</translation></message>
<message><source>▲ a nearer surface is within %1 cells of a click</source><translation>▲ hay una superficie más cercana a menos de %1 celdas de un clic</translation></message>
<message><source>▲ longer than the %1 m between the clicks: the sides of the throat are up to %2 m from them</source><translation>▲ más largo que los %1 m entre los clics: los lados de la garganta están hasta a %2 m de ellos</translation></message>
<message><source>▲ its ends are up to %1 m from the clicks: check that it is the opening that was meant</source><translation>▲ sus extremos están como máximo a %1 m de los clics: compruebe que es la abertura deseada</translation></message>
<message><source>its ends are up to %1 m from the clicks</source><translation>sus extremos están como máximo a %1 m de los clics</translation></message>
<message><source>▲ a click went through this throat, %1 m behind it: the rim in front was taken</source><translation>▲ un clic pasó por esta garganta, %1 m detrás de ella: se tomó el borde de delante</translation></message>
<message><source>▲ no beam came back between its ends: this may be an opening, or dark or wet rock</source><translation>▲ ningún haz volvió entre sus extremos: puede ser una abertura, o roca oscura o mojada</translation></message>
<message><source>▲ one end is %1 m farther away than the other</source><translation>▲ un extremo está %1 m más lejos que el otro</translation></message>
<message><source>across the middle of the opening</source><translation>por el medio de la abertura</translation></message>
<message><source>across the opening between the clicks, turned by %1° from their line</source><translation>a través de la abertura entre los clics, girado %1° respecto de su línea</translation></message>
<message><source>between the two sides that were clicked</source><translation>entre los dos lados en los que se hizo clic</translation></message>
<message><source>▲ clicks %1 away find %2 to %3 m: zoom in and click again</source><translation>▲ clics a %1 encuentran de %2 a %3 m: acérquese y haga clic de nuevo</translation></message>
<message><source>clicks %1 away find %2 to %3 m</source><translation>clics a %1 de ahí encuentran de %2 a %3 m</translation></message>
<message><source>ranges %1 m</source><translation>distancias %1 m</translation></message>
<message><source>slope %1° ± %2°, grade %3 %</source><translation>inclinación %1° ± %2°, pendiente %3 %</translation></message>
<message><source>slope %1° ± %2°</source><translation>inclinación %1° ± %2°</translation></message>
<message><source>a side is below what is resolved there</source><translation>un lado es menor que lo que allí se resuelve</translation></message>
<message><source>jumps that are part of it: %1</source><translation>saltos incluidos: %1</translation></message>
<message><source>▲ an end is %1 m behind the surface next to it</source><translation>▲ un extremo está %1 m detrás de la superficie vecina</translation></message>
<message><source>between its ends the surface is up to %1 m farther away</source><translation>entre sus extremos la superficie está hasta %1 m más lejos</translation></message>
<message><source>between its ends the surface is up to %1 m nearer</source><translation>entre sus extremos la superficie está hasta %1 m más cerca</translation></message>
<message><source>no pose: up is the scanner's z</source><translation>sin pose: arriba es el eje z del escáner</translation></message>
<message><source>Vertical Difference</source><translation>Diferencia vertical</translation></message>
<message><source>Angle</source><translation>Ángulo</translation></message>
<message><source>Spans a × b</source><translation>Extensiones a × b</translation></message>
<message><source>Along the Surface</source><translation>Por la superficie</translation></message>
<message><source>Throat Width</source><translation>Ancho de garganta</translation></message>
<message><source>Length in a Section</source><translation>Longitud en una sección</translation></message>
</context>
<context>
<name>core</name>
<message><source>the JSON holds too many keys</source><translation>el JSON contiene demasiadas claves</translation></message>
<message><source>the key "%1" appears twice in the same object of the JSON</source><translation>la clave «%1» aparece dos veces en el mismo objeto del JSON</translation></message>
<message><source>the JSON holds a number that no computer can store</source><translation>el JSON contiene un número que ningún ordenador puede guardar</translation></message>
<message><source>the JSON is damaged or cut off here</source><translation>el JSON está dañado o cortado aquí</translation></message>
<message><source>correct the file or choose another</source><translation>corrija el archivo o elija otro</translation></message>
<message><source>%1: byte %2</source><translation>%1: byte %2</translation></message>
<message><source>check line %1, column %2; write 217.4 for 217,4</source><translation>revise la línea %1, columna %2; escriba 217.4 en lugar de 217,4</translation></message>
<message><source>check line %1, column %2</source><translation>revise la línea %1, columna %2</translation></message>
<message><source>this JSON is nested too deep</source><translation>este JSON está anidado a demasiada profundidad</translation></message>
<message><source>this JSON is too large: %1, and %2 are read</source><translation>este JSON es demasiado grande: %1, y se leen %2</translation></message>
<message><source>choose another file</source><translation>elija otro archivo</translation></message>
<message><source>the file is empty</source><translation>el archivo está vacío</translation></message>
<message><source>copy it again or choose another</source><translation>cópielo de nuevo o elija otro</translation></message>
<message><source>%n byte behind %1 was not read.</source><translation>%n byte detrás de %1 no se leyó.</translation></message>
<message><source>%n bytes behind %1 were not read.</source><translation>%n bytes detrás de %1 no se leyeron.</translation></message>
<message><source>this is the address of a file on another computer, %1</source><translation>esta es la dirección de un archivo en otro ordenador, %1</translation></message>
<message><source>copy the file to this one, or give its path in a folder that is shared</source><translation>copie el archivo a este, o dé su ruta en una carpeta compartida</translation></message>
<message><source>this is the address of a robot's bridge and not a file</source><translation>es una dirección del puente de un robot y no un archivo</translation></message>
<message><source>use it with record, or in the window with Connect to Scanner</source><translation>úsela con record, o en la ventana con Conectar al escáner</translation></message>
<message><source>this address has a % without the two digits of a byte</source><translation>esta dirección tiene un % sin las dos cifras de un byte</translation></message>
<message><source>write % as %25, or give the path</source><translation>escriba % como %25, o dé la ruta</translation></message>
<message><source>this address names no file</source><translation>esta dirección no nombra ningún archivo</translation></message>
<message><source>give its path</source><translation>dé su ruta</translation></message>
<message><source>this file was read as an input</source><translation>este archivo se leyó como entrada</translation></message>
<message><source>this is the file that was read as an input under the name %1</source><translation>este es el archivo que se leyó como entrada con el nombre %1</translation></message>
<message><source>choose another name</source><translation>elija otro nombre</translation></message>
<message><source>nothing (null)</source><translation>nada (null)</translation></message>
<message><source>a list [...]</source><translation>una lista [...]</translation></message>
<message><source>an object {...}</source><translation>un objeto {...}</translation></message>
<message><source>holds %1 where a number is needed</source><translation>contiene %1 donde se necesita un número</translation></message>
<message><source>holds a number out of all reason</source><translation>contiene un número fuera de toda razón</translation></message>
<message><source>%1 or more</source><translation>%1 o más</translation></message>
<message><source>%1 or less</source><translation>%1 o menos</translation></message>
<message><source>from %1 to %2</source><translation>de %1 a %2</translation></message>
<message><source>is %1 and must be %2</source><translation>es %1 y debe ser %2</translation></message>
<message><source>is missing</source><translation>falta</translation></message>
<message><source>must be a whole number from %1 to %2</source><translation>debe ser un número entero de %1 a %2</translation></message>
<message><source>must be true or false</source><translation>debe ser true o false</translation></message>
<message><source>must be text</source><translation>debe ser texto</translation></message>
<message><source>must be %1</source><translation>debe ser %1</translation></message>
<message><source>must be a list of numbers</source><translation>debe ser una lista de números</translation></message>
<message><source>must hold %1 numbers</source><translation>debe contener %1 números</translation></message>
<message><source>must hold three numbers</source><translation>debe contener tres números</translation></message>
<message><source>must hold three rows of three numbers</source><translation>debe contener tres filas de tres números</translation></message>
<message><source>is not a rotation: its rows are not perpendicular and of length 1</source><translation>no es una rotación: sus filas no son perpendiculares y de longitud 1</translation></message>
<message><source>mirrors instead of turning: its determinant is -1</source><translation>refleja en vez de girar: su determinante es -1</translation></message>
<message><source>must be a time in UTC like "2026-11-20T10:15:30.250Z"</source><translation>debe ser una hora UTC como "2026-11-20T10:15:30.250Z"</translation></message>
<message><source>must be a list of texts</source><translation>debe ser una lista de textos</translation></message>
<message><source>must be an object {...}</source><translation>debe ser un objeto {...}</translation></message>
<message><source>must be a list of objects {...}</source><translation>debe ser una lista de objetos {...}</translation></message>
<message><source>is not a key here, but "%1" is: units belong to the name</source><translation>no es una clave aquí, pero «%1» sí: las unidades son parte del nombre</translation></message>
<message><source>is not a key here; known are %1</source><translation>no es una clave aquí; se conocen %1</translation></message>
<message><source>"format": "%1"</source><translation>"format": "%1"</translation></message>
<message><source>the JSON holds no object</source><translation>el JSON no contiene ningún objeto</translation></message>
<message><source>choose a file with %1</source><translation>elija un archivo con %1</translation></message>
<message><source>"format" is missing</source><translation>falta "format"</translation></message>
<message><source>"format" is "%1", not "%2"</source><translation>"format" es «%1», no «%2»</translation></message>
<message><source>%n byte</source><translation>%n byte</translation></message>
<message><source>%n bytes</source><translation>%n bytes</translation></message>
<message><source>needs %1 of memory, %2 are free</source><translation>necesita %1 de memoria, hay %2 libres</translation></message>
<message><source>close other programs or open a smaller file</source><translation>cierre otros programas o abra un archivo más pequeño</translation></message>
<message><source>this is not a file of the kind %1, so it was not replaced</source><translation>este no es un archivo de la clase %1, por eso no se ha sustituido</translation></message>
<message><source>this is a file of the kind %1, so it was not replaced</source><translation>este es un archivo de la clase %1, por eso no se ha sustituido</translation></message>
<message><source>no scanner reaches farther than 1,000 km</source><translation>ningún escáner alcanza más de 1,000 km</translation></message>
<message><source>unit of counts and numbers</source><translation>unidad de las cuentas y los números</translation></message>
<message><source>from a nanometre to a kilometre</source><translation>de un nanómetro a un kilómetro</translation></message>
<message><source>angle of a beam, a heading or a mounting</source><translation>ángulo de un haz, de un rumbo o de un montaje</translation></message>
<message><source>degrees</source><translation>grados</translation></message>
<message><source>one turn</source><translation>una vuelta</translation></message>
<message><source>angle of a line</source><translation>ángulo de una línea</translation></message>
<message><source>a stepper that turns on for days</source><translation>un motor paso a paso que gira durante días</translation></message>
<message><source>step from beam to beam or line to line</source><translation>paso de haz a haz o de línea a línea</translation></message>
<message><source>not 0: two beams never look the same way</source><translation>no 0: dos haces nunca miran en la misma dirección</translation></message>
<message><source>cell of a projected cloud</source><translation>celda de una nube proyectada</translation></message>
<message><source>finer than any scanner, coarser than any use</source><translation>más fina que la de cualquier escáner, más gruesa que para cualquier uso</translation></message>
<message><source>tilt, pitch</source><translation>inclinación, cabeceo</translation></message>
<message><source>beyond it, it is the other way round</source><translation>más allá está al revés</translation></message>
<message><source>roll, convergence</source><translation>alabeo, convergencia</translation></message>
<message><source>half a turn</source><translation>media vuelta</translation></message>
<message><source>easting, northing, place of a sensor</source><translation>este, norte, lugar de un sensor</translation></message>
<message><source>more than the way round the earth</source><translation>más que la vuelta a la Tierra</translation></message>
<message><source>deeper than any mine, higher than any mountain</source><translation>más profundo que cualquier mina, más alto que cualquier montaña</translation></message>
<message><source>lever arm on a robot</source><translation>brazo de palanca en un robot</translation></message>
<message><source>nothing on a robot is farther away</source><translation>nada en un robot está más lejos</translation></message>
<message><source>coordinate, in the file's own unit</source><translation>coordenada, en la unidad propia del archivo</translation></message>
<message><source>the way round the earth in tenths of a millimetre</source><translation>la vuelta a la Tierra en décimas de milímetro</translation></message>
<message><source>scale of a mine grid</source><translation>escala de una cuadrícula de mina</translation></message>
<message><source>map projections stay within a hundredth</source><translation>las proyecciones cartográficas quedan dentro de una centésima</translation></message>
<message><source>lines, beams</source><translation>líneas, haces</translation></message>
<message><source>more than a day of scanning</source><translation>más de un día de escaneo</translation></message>
<message><source>this pipe cannot be read: </source><translation>no se puede leer este conducto: </translation></message>
<message><source>save what it gives to a file and open that</source><translation>guarde lo que da en un archivo y ábralo</translation></message>
<message><source>this is a keyboard, not a scan</source><translation>esto es un teclado, no un escaneo</translation></message>
<message><source>give a file, or pipe one in</source><translation>dé un archivo, o conéctelo por un conducto</translation></message>
<message><source>cancelled</source><translation>cancelado</translation></message>
<message><source>no program writes into this pipe</source><translation>ningún programa escribe en este conducto</translation></message>
<message><source>start the program that fills it, then open it again</source><translation>inicie el programa que lo llena y ábralo de nuevo</translation></message>
<message><source>this is a device, not a scan</source><translation>esto es un dispositivo, no un escaneo</translation></message>
<message><source>choose a file</source><translation>elija un archivo</translation></message>
<message><source>the file cannot be opened: </source><translation>no se puede abrir el archivo: </translation></message>
<message><source>check the path</source><translation>compruebe la ruta</translation></message>
<message><source>this is not a regular file</source><translation>esto no es un archivo normal</translation></message>
<message><source>the file cannot be read: </source><translation>no se puede leer el archivo: </translation></message>
<message><source>check the disk and the path</source><translation>compruebe el disco y la ruta</translation></message>
<message><source>the folder to write into does not exist</source><translation>la carpeta de destino no existe</translation></message>
<message><source>make the folder or choose another</source><translation>cree la carpeta o elija otra</translation></message>
<message><source>the folder to write into is not a folder</source><translation>la carpeta de destino no es una carpeta</translation></message>
<message><source>choose another folder</source><translation>elija otra carpeta</translation></message>
<message><source>writing here is not allowed</source><translation>no está permitido escribir aquí</translation></message>
<message><source>choose another folder or ask for the right to write</source><translation>elija otra carpeta o pida permiso para escribir</translation></message>
<message><source>the disk can only be read</source><translation>el disco es de solo lectura</translation></message>
<message><source>the disk is full, so this file was not written</source><translation>el disco está lleno, por eso este archivo no se ha escrito</translation></message>
<message><source>free some space or choose another disk</source><translation>libere espacio o elija otro disco</translation></message>
<message><source>the file would be larger than the limit set for it</source><translation>el archivo sería mayor que el límite fijado para él</translation></message>
<message><source>choose another disk or raise the limit</source><translation>elija otro disco o suba el límite</translation></message>
<message><source>this is a folder, not a file</source><translation>es una carpeta, no un archivo</translation></message>
<message><source>give a file name</source><translation>indique un nombre de archivo</translation></message>
<message><source>this link leads in a circle</source><translation>este enlace lleva en círculo</translation></message>
<message><source>give the file itself</source><translation>dé el archivo mismo</translation></message>
<message><source>the file name is too long</source><translation>el nombre del archivo es demasiado largo</translation></message>
<message><source>choose a shorter name</source><translation>elija un nombre más corto</translation></message>
<message><source>the file cannot be written: </source><translation>no se puede escribir el archivo: </translation></message>
<message><source>choose another folder or disk</source><translation>elija otra carpeta u otro disco</translation></message>
<message><source>what was read back is not what was written, so this file was not written</source><translation>lo que se volvió a leer no es lo que se escribió, así que este archivo no se escribió</translation></message>
<message><source>check the disk and try again</source><translation>compruebe el disco e inténtelo de nuevo</translation></message>
<message><source>there is no such file; a name with other bytes than UTF-8 does not come through a file dialog</source><translation>no existe tal archivo; un nombre con otros bytes que UTF-8 no pasa por un diálogo de archivos</translation></message>
<message><source>give the name on the command line, drag the file into the window, or rename it</source><translation>dé el nombre en la línea de comandos, arrastre el archivo a la ventana o cámbiele el nombre</translation></message>
<message><source>there is no such file</source><translation>no existe ese archivo</translation></message>
<message><source>check the spelling and the folder</source><translation>compruebe el nombre y la carpeta</translation></message>
<message><source>reading this file is not allowed</source><translation>no se permite leer este archivo</translation></message>
<message><source>ask its owner for the right to read it</source><translation>pida a su dueño permiso para leerlo</translation></message>
<message><source>choose a file inside it</source><translation>elija un archivo dentro de ella</translation></message>
<message><source>the file cannot be read: %1</source><translation>no se puede leer el archivo: %1</translation></message>
<message><source>this file is read-only, so it was not replaced</source><translation>este archivo es de solo lectura, por eso no se ha sustituido</translation></message>
<message><source>allow writing with chmod u+w, or choose another name</source><translation>permita la escritura con chmod u+w o elija otro nombre</translation></message>
<message><source>this file belongs to another user, who does not allow writing, so it was not replaced</source><translation>este archivo pertenece a otro usuario, que no permite escribir en él; por eso no se ha sustituido</translation></message>
<message><source>choose another name, or ask its owner</source><translation>elija otro nombre o pregunte a su propietario</translation></message>
<message><source>; already in place: </source><translation>; ya en su sitio: </translation></message>
<message><source>no program reads from this pipe</source><translation>ningún programa lee de este conducto</translation></message>
<message><source>start what reads from it first, or choose a file</source><translation>inicie primero lo que lee de él, o elija un archivo</translation></message>
<message><source>what reads from this pipe takes nothing</source><translation>lo que lee de este conducto no acepta nada</translation></message>
<message><source>start it again, or choose a file</source><translation>inícielo de nuevo, o elija un archivo</translation></message>
<message><source>what reads from this pipe has ended</source><translation>lo que lee de este conducto ha terminado</translation></message>
<message><source>there is no file name to write to</source><translation>no hay nombre de archivo en el que escribir</translation></message>
<message><source>this is a link that belongs to another user</source><translation>esto es un enlace que pertenece a otro usuario</translation></message>
<message><source>give the file it leads to, or another name</source><translation>dé el archivo al que lleva, u otro nombre</translation></message>
<message><source>two results cannot have one file</source><translation>dos resultados no pueden tener un mismo archivo</translation></message>
<message><source>give each a name of its own</source><translation>dé a cada uno un nombre propio</translation></message>
<message><source>it was cancelled, so nothing was written</source><translation>se canceló, así que no se escribió nada</translation></message>
<message><source>save it again</source><translation>guárdelo otra vez</translation></message>
<message><source>the file cannot be removed (%1)</source><translation>el archivo no se puede quitar (%1)</translation></message>
<message><source>check the rights of its folder</source><translation>compruebe los permisos de su carpeta</translation></message>
<message><source>this is a file and not a folder</source><translation>esto es un archivo y no una carpeta</translation></message>
<message><source>give the name of a folder</source><translation>indique el nombre de una carpeta</translation></message>
<message><source>the folder cannot be made (%1)</source><translation>no se puede crear la carpeta (%1)</translation></message>
<message><source>this is a device or a pipe, not a file</source><translation>esto es un dispositivo o un conducto, no un archivo</translation></message>
<message><source>the file is too large for what it should be: %1, and at most %2 are read</source><translation>el archivo es demasiado grande para lo que debería ser: %1, y se leen como mucho %2</translation></message>
<message><source>choose one that can be written to</source><translation>elija uno en el que se pueda escribir</translation></message>
<message><source>it is compressed with %1 and damaged or cut off</source><translation>está comprimido con %1 y está dañado o cortado</translation></message>
<message><source>copy the file again</source><translation>copie de nuevo el archivo</translation></message>
<message><source>this program was built without %1, which this recording is compressed with</source><translation>este programa se compiló sin %1, con lo que está comprimida esta grabación</translation></message>
<message><source>unpack it with "mcap compress --compression none" or "rosbag decompress", or install lib%1 and build again</source><translation>descomprímalo con "mcap compress --compression none" o "rosbag decompress", o instale lib%1 y compile de nuevo</translation></message>
<message><source>it is compressed with "%1", which is not known here</source><translation>está comprimido con «%1», que aquí no se conoce</translation></message>
<message><source>unpack it with the program that wrote it</source><translation>descomprímalo con el programa que lo escribió</translation></message>
<message><source>other bytes follow the packed data</source><translation>siguen otros bytes a los datos comprimidos</translation></message>
<message><source>unpacked this is more than %1, far more than a scan of its size can be</source><translation>descomprimido esto es más de %1, mucho más de lo que puede ser un escaneo de su tamaño</translation></message>
<message><source>unpack it by hand and look at it</source><translation>descomprímalo a mano y revíselo</translation></message>
<message><source>there is not enough memory for this file</source><translation>no hay memoria suficiente para este archivo</translation></message>
<message><source>the packed data are damaged%1</source><translation>los datos comprimidos están dañados%1</translation></message>
<message><source>the packed data end too early</source><translation>los datos comprimidos terminan demasiado pronto</translation></message>
<message><source>copy the file again, it may be cut off</source><translation>copie de nuevo el archivo, puede estar cortado</translation></message>
<message><source>this ZIP archive has no directory at its end</source><translation>este archivo ZIP no tiene directorio al final</translation></message>
<message><source>the directory of this ZIP archive is damaged</source><translation>el directorio de este archivo ZIP está dañado</translation></message>
<message><source>this ZIP archive does not begin where its directory says: other bytes are before it or in it</source><translation>este archivo ZIP no empieza donde indica su directorio: hay otros bytes delante o dentro</translation></message>
<message><source>this part of the archive is encrypted</source><translation>esta parte del archivo está cifrada</translation></message>
<message><source>save it without a password</source><translation>guárdelo sin contraseña</translation></message>
<message><source>this part of the archive is packed by method %1</source><translation>esta parte del archivo está comprimida con el método %1</translation></message>
<message><source>pack it with DEFLATE, as usual</source><translation>comprímalo con DEFLATE, como es habitual</translation></message>
<message><source>this part of the archive is not where its directory says</source><translation>esta parte del archivo no está donde indica su directorio</translation></message>
<message><source>unpacked this is %1, far more than a scan of its size can be</source><translation>descomprimido son %1, mucho más de lo que puede ser un escaneo de ese tamaño</translation></message>
<message><source>this part of the archive is damaged: its length or its checksum does not fit</source><translation>esta parte del archivo está dañada: su longitud o su suma de control no coincide</translation></message>
<message><source>the points are said to begin at byte %1, which is not in the file</source><translation>los puntos empezarían en el byte %1, que no está en el archivo</translation></message>
<message><source>no list of points begins where the E57 file says</source><translation>ninguna lista de puntos empieza donde indica el archivo E57</translation></message>
<message><source>export the file again</source><translation>exporte de nuevo el archivo</translation></message>
<message><source>the header of the points does not fit the file</source><translation>la cabecera de los puntos no corresponde al archivo</translation></message>
<message><source>a packet of points %1</source><translation>un paquete de puntos %1</translation></message>
<message><source>is too short</source><translation>es demasiado corto</translation></message>
<message><source>holds %1 and the file describes %2</source><translation>contiene %1 y el archivo describe %2</translation></message>
<message><source>%n column</source><translation>%n columna</translation></message>
<message><source>%n columns</source><translation>%n columnas</translation></message>
<message><source>ends within its header</source><translation>termina dentro de su encabezado</translation></message>
<message><source>promises more bytes than it has</source><translation>anuncia más bytes de los que tiene</translation></message>
<message><source>a packet of points is of kind %1, which E57 does not have</source><translation>un paquete de puntos es del tipo %1, que E57 no tiene</translation></message>
<message><source>a packet of points says that it has %1 bytes, which are not there</source><translation>un paquete de puntos dice que tiene %1 bytes, que no están</translation></message>
<message><source>the file promises %1 and has %2 bytes for them</source><translation>el archivo anuncia %1 y tiene %2 bytes para ellos</translation></message>
<message><source>%n point</source><translation>%n punto</translation></message>
<message><source>%n points</source><translation>%n puntos</translation></message>
<message><source>the file promises %1 and the column %2 ends after %3</source><translation>el archivo anuncia %1 y la columna %2 termina después de %3</translation></message>
<message><source>the file ends within its E57 header</source><translation>el archivo termina dentro de su cabecera E57</translation></message>
<message><source>this is E57 version %1.%2, and version 1 is known</source><translation>esto es E57 versión %1.%2, y se conoce la versión 1</translation></message>
<message><source>export it as E57 version 1.0</source><translation>expórtelo como E57 versión 1.0</translation></message>
<message><source>the E57 header says that pages have %1 bytes</source><translation>la cabecera E57 indica páginas de %1 bytes</translation></message>
<message><source>%1: byte 40</source><translation>%1: byte 40</translation></message>
<message><source>the E57 header promises %1 bytes and the file holds %2</source><translation>el encabezado E57 anuncia %1 bytes y el archivo contiene %2</translation></message>
<message><source>the columns of points in this E57 file are nested too deep</source><translation>las columnas de puntos de este archivo E57 están demasiado anidadas</translation></message>
<message><source>the limits of the column %1 in this E57 file are not possible</source><translation>los límites de la columna %1 de este archivo E57 no son posibles</translation></message>
<message><source>scan %1 of this E57 file does not say where its points are and how many</source><translation>el escaneo %1 de este archivo E57 no indica dónde están sus puntos ni cuántos son</translation></message>
<message><source>the E57 header says that the XML part is at byte %1 and has %2 bytes, which are not in the file</source><translation>el encabezado E57 dice que la parte XML está en el byte %1 y tiene %2 bytes, que no están en el archivo</translation></message>
<message><source>%1: byte 24</source><translation>%1: byte 24</translation></message>
<message><source>the XML part of this E57 file cannot be read: </source><translation>no se puede leer la parte XML de este archivo E57: </translation></message>
<message><source>the XML part of this E57 file has no e57Root</source><translation>la parte XML de este archivo E57 no tiene e57Root</translation></message>
<message><source>page %1 of %2 of this E57 file is damaged: its checksum does not fit</source><translation>la página %1 de %2 de este archivo E57 está dañada: su suma de control no coincide</translation></message>
<message><source>this E57 file ends before something that it names</source><translation>este archivo E57 termina antes de algo que nombra</translation></message>
<message><source>a file of this name exists already and a recording overwrites nothing</source><translation>ya existe un archivo con este nombre y una grabación no sobrescribe nada</translation></message>
<message><source>the folder to record into does not exist</source><translation>la carpeta en la que grabar no existe</translation></message>
<message><source>recording here is not allowed</source><translation>aquí no está permitido grabar</translation></message>
<message><source>the disk is full, nothing is recorded</source><translation>el disco está lleno, no se graba nada</translation></message>
<message><source>the recording cannot be started: </source><translation>no se puede empezar la grabación: </translation></message>
<message><source>the disk is full, the recording ends here</source><translation>el disco está lleno, la grabación termina aquí</translation></message>
<message><source>free some space and start a new recording</source><translation>libere espacio y empiece una grabación nueva</translation></message>
<message><source>the file has reached the limit set for its size, the recording ends here</source><translation>el archivo ha alcanzado el límite fijado para su tamaño, la grabación termina aquí</translation></message>
<message><source>start a new recording</source><translation>empiece una grabación nueva</translation></message>
<message><source>the recording ends here: </source><translation>la grabación termina aquí: </translation></message>
<message><source>check the disk and start a new recording</source><translation>compruebe el disco y empiece una grabación nueva</translation></message>
<message><source>the disk reports that it lost some of what was recorded: </source><translation>el disco informa de que perdió parte de lo grabado: </translation></message>
<message><source>check the disk, and start a new recording on another one</source><translation>compruebe el disco, y empiece una grabación nueva en otro</translation></message>
<message><source>bytes %1 to %2 are damaged and were left out</source><translation>los bytes %1 a %2 están dañados y se dejaron fuera</translation></message>
<message><source>%1 more places are damaged or were left out</source><translation>%1 lugares más están dañados o se dejaron fuera</translation></message>
<message><source>it is not a whole chunk</source><translation>no es un bloque completo</translation></message>
<message><source>its checksum does not fit</source><translation>su suma de verificación no coincide</translation></message>
<message><source>it promises to unpack to %1, more than a file of this size holds</source><translation>anuncia que se descomprime en %1, más de lo que contiene un archivo de este tamaño</translation></message>
<message><source>the chunk at byte %1 was left out: %2</source><translation>el bloque en el byte %1 se dejó fuera: %2</translation></message>
<message><source>the end of the recording</source><translation>el final de la grabación</translation></message>
<message><source>the file says that it holds %1 and %2 could be read</source><translation>el archivo dice que contiene %1 y se pudieron leer %2</translation></message>
<message><source>%n message</source><translation>%n mensaje</translation></message>
<message><source>%n messages</source><translation>%n mensajes</translation></message>
<message><source>this is not an MCAP recording of a known version</source><translation>no es una grabación MCAP de una versión conocida</translation></message>
<message><source>choose a recording</source><translation>elija una grabación</translation></message>
<message><source>unknown reason</source><translation>motivo desconocido</translation></message>
<message><source>out of memory</source><translation>sin memoria suficiente</translation></message>
<message><source>the file ends too early</source><translation>el archivo termina demasiado pronto</translation></message>
<message><source>there are no cells to make a picture of</source><translation>no hay celdas de las que hacer una imagen</translation></message>
<message><source>open a scan first</source><translation>primero abra un escaneo</translation></message>
<message><source>the picture cannot be made: </source><translation>no se puede hacer la imagen: </translation></message>
<message><source>free some memory</source><translation>libere memoria</translation></message>
<message><source>the picture cannot be read: </source><translation>no se puede leer la imagen: </translation></message>
<message><source>save it again as PNG</source><translation>guárdela de nuevo como PNG</translation></message>
<message><source>the picture has %1 x %2 pixels; at most %3 are taken</source><translation>la imagen tiene %1 x %2 píxeles; se aceptan como mucho %3</translation></message>
<message><source>make the picture smaller</source><translation>haga la imagen más pequeña</translation></message>
<message><source>this is not a readable PNG picture: </source><translation>esto no es una imagen PNG legible: </translation></message>
<message><source>save the mask again as PNG</source><translation>guarde de nuevo la máscara como PNG</translation></message>
<message><source>this picture has 16 bits per pixel where 8 are needed</source><translation>esta imagen tiene 16 bits por píxel donde se necesitan 8</translation></message>
<message><source>save the mask as 8-bit gray</source><translation>guarde la máscara en gris de 8 bits</translation></message>
<message><source>the picture promises more pixels than the file can hold</source><translation>la imagen anuncia más píxeles de los que el archivo puede contener</translation></message>
<message><source>export it again</source><translation>expórtelo de nuevo</translation></message>
<message><source>this build has no robots: it reads no ROS bags, no VLP-16, no Ouster and no Foxglove bridge</source><translation>esta versión no tiene robots: no lee bags de ROS, ni VLP-16, ni Ouster, ni puente Foxglove</translation></message>
<message><source>use a build with robots (EDGESCAN_ROBOTS)</source><translation>use una versión con robots (EDGESCAN_ROBOTS)</translation></message>
<message><source>this is not a whole DXF group</source><translation>esto no es un grupo DXF completo</translation></message>
<message><source>this coordinate is not a number</source><translation>esta coordenada no es un número</translation></message>
<message><source>reading points</source><translation>lectura de los puntos</translation></message>
<message><source>%n point shares its row and column with a nearer one, which was taken (several returns of one beam).</source><translation>%n punto comparte su fila y su columna con uno más cercano, que se tomó (varios retornos de un haz).</translation></message>
<message><source>%n points share their row and column with a nearer one, which was taken (several returns of one beam).</source><translation>%n puntos comparten su fila y su columna con uno más cercano, que se tomó (varios retornos de un haz).</translation></message>
<message><source>this E57 file holds no scan, only %1</source><translation>este archivo E57 no contiene ningún escaneo, solo %1</translation></message>
<message><source>%n picture</source><translation>%n imagen</translation></message>
<message><source>%n pictures</source><translation>%n imágenes</translation></message>
<message><source>this E57 file holds no scan</source><translation>este archivo E57 no contiene ningún escaneo</translation></message>
<message><source>The file holds %1 scans; this is number %2, --scan chooses another.</source><translation>El archivo contiene %1 escaneos; este es el número %2, --scan elige otro.</translation></message>
<message><source>The first %1 of these scans hold no point with a return.</source><translation>Los primeros %1 de estos escaneos no tienen ningún punto con retorno.</translation></message>
<message><source>The rows and columns that the file gives its points make no grid and were not used.</source><translation>Las filas y columnas que el archivo da a sus puntos no forman una cuadrícula y no se usaron.</translation></message>
<message><source>The file does not say which way the scan lines run: its columns were taken as lines, its rows as beams.</source><translation>El archivo no dice en qué sentido van las líneas: sus columnas se tomaron como líneas, sus filas como haces.</translation></message>
<message><source>scan %1 of this E57 file</source><translation>el escaneo %1 de este archivo E57</translation></message>
<message><source>%1 holds no points</source><translation>%1 no contiene puntos</translation></message>
<message><source>choose another scan or file</source><translation>elija otro escaneo o archivo</translation></message>
<message><source>%1 has neither cartesian nor spherical coordinates, only %2</source><translation>%1 no tiene coordenadas cartesianas ni esféricas, solo %2</translation></message>
<message><source>export it with coordinates</source><translation>expórtelo con coordenadas</translation></message>
<message><source>The angles of the points were taken as degrees, because no elevation in radians is so large.</source><translation>Los ángulos de los puntos se tomaron como grados, porque ninguna elevación en radianes es tan grande.</translation></message>
<message><source>%n point has a range below 0 and counts as no return.</source><translation>%n punto tiene una distancia menor que 0 y cuenta como sin retorno.</translation></message>
<message><source>%n points have a range below 0 and count as no return.</source><translation>%n puntos tienen una distancia menor que 0 y cuentan como sin retorno.</translation></message>
<message><source>%n point is marked as invalid in the file and counts as no return.</source><translation>%n punto está marcado como no válido en el archivo y cuenta como sin retorno.</translation></message>
<message><source>%n points are marked as invalid in the file and count as no return.</source><translation>%n puntos están marcados como no válidos en el archivo y cuentan como sin retorno.</translation></message>
<message><source>What else a point of this file has is not read: %1.</source><translation>Lo demás que tiene un punto de este archivo no se lee: %1.</translation></message>
<message><source>The pictures of this file (%1) are not read.</source><translation>Las imágenes de este archivo (%1) no se leen.</translation></message>
<message><source>the end that the header gives</source><translation>el final que da el encabezado</translation></message>
<message><source>The pose in the file is not a rotation and shift, so the scan stays in the scanner's frame.</source><translation>La pose del archivo no es una rotación y traslación, así que el escaneo queda en el sistema del escáner.</translation></message>
<message><source>choose a scan file</source><translation>elija un archivo de escaneo</translation></message>
<message><source>it may be what a site sent instead of the file: download the file again, or choose a scan file</source><translation>quizá un sitio la envió en lugar del archivo: descargue de nuevo el archivo o elija un archivo de escaneo</translation></message>
<message><source>unpack it and open the scan in it</source><translation>descomprímalo y abra el escaneo que contiene</translation></message>
<message><source>save its points as PLY in MeshLab</source><translation>guarde sus puntos como PLY en MeshLab</translation></message>
<message><source>choose the scan that it was made from</source><translation>elija el escaneo del que se hizo</translation></message>
<message><source>save the ranges as .npy or .csv</source><translation>guarde las distancias como .npy o .csv</translation></message>
<message><source>this is a JPEG picture, not a scan</source><translation>es una imagen JPEG, no un escaneo</translation></message>
<message><source>this is a GIF picture, not a scan</source><translation>es una imagen GIF, no un escaneo</translation></message>
<message><source>this is a picture, sound or film (RIFF), not a scan</source><translation>es una imagen, un sonido o una película (RIFF), no un escaneo</translation></message>
<message><source>this is a picture or film, not a scan</source><translation>es una imagen o una película, no un escaneo</translation></message>
<message><source>this is a Photoshop picture, not a scan</source><translation>es una imagen de Photoshop, no un escaneo</translation></message>
<message><source>this is a program, not a scan</source><translation>es un programa, no un escaneo</translation></message>
<message><source>this is a PDF document, not a scan</source><translation>es un documento PDF, no un escaneo</translation></message>
<message><source>this is a ZIP archive, not a scan</source><translation>es un archivo comprimido ZIP, no un escaneo</translation></message>
<message><source>this is a gzip archive in another one, not a scan</source><translation>es un archivo gzip dentro de otro, no un escaneo</translation></message>
<message><source>this is an xz archive, not a scan</source><translation>es un archivo xz, no un escaneo</translation></message>
<message><source>unpack it (xz -d) and open the scan in it</source><translation>descomprímalo (xz -d) y abra el escaneo que contiene</translation></message>
<message><source>this is a bzip2 archive, not a scan</source><translation>es un archivo bzip2, no un escaneo</translation></message>
<message><source>unpack it (bzip2 -d) and open the scan in it</source><translation>descomprímalo (bzip2 -d) y abra el escaneo que contiene</translation></message>
<message><source>this is a zstd archive, not a scan</source><translation>es un archivo zstd, no un escaneo</translation></message>
<message><source>unpack it (zstd -d) and open the scan in it</source><translation>descomprímalo (zstd -d) y abra el escaneo que contiene</translation></message>
<message><source>this is a 7-Zip archive, not a scan</source><translation>es un archivo 7-Zip, no un escaneo</translation></message>
<message><source>this is a RAR archive, not a scan</source><translation>es un archivo RAR, no un escaneo</translation></message>
<message><source>this is an HDF5 file, which is not read</source><translation>es un archivo HDF5, que no se lee</translation></message>
<message><source>this is a MATLAB file, which is not read</source><translation>es un archivo de MATLAB, que no se lee</translation></message>
<message><source>save the ranges with writematrix(ranges, 'scan.csv')</source><translation>guarde las distancias con writematrix(ranges, 'scan.csv')</translation></message>
<message><source>this is an old Office document, not a scan</source><translation>es un documento antiguo de Office, no un escaneo</translation></message>
<message><source>save the table as .csv</source><translation>guarde la tabla como .csv</translation></message>
<message><source>this is a Parquet table, which is not read</source><translation>es una tabla Parquet, que no se lee</translation></message>
<message><source>this is an Arrow table, which is not read</source><translation>es una tabla Arrow, que no se lee</translation></message>
<message><source>this is a glTF model, which is not read</source><translation>es un modelo glTF, que no se lee</translation></message>
<message><source>save it as PLY in Blender or MeshLab</source><translation>guárdelo como PLY en Blender o MeshLab</translation></message>
<message><source>this is a STEP model, not a scan</source><translation>es un modelo STEP, no un escaneo</translation></message>
<message><source>this is an FBX model, which is not read</source><translation>es un modelo FBX, que no se lee</translation></message>
<message><source>save it as PLY in Blender</source><translation>guárdelo como PLY en Blender</translation></message>
<message><source>this is a web page (HTML), not a scan</source><translation>es una página web (HTML), no un escaneo</translation></message>
<message><source>this is an SVG picture, not a scan</source><translation>es una imagen SVG, no un escaneo</translation></message>
<message><source>this is an XML document, not a scan</source><translation>es un documento XML, no un escaneo</translation></message>
<message><source>this is a text document (RTF), not a scan</source><translation>es un documento de texto (RTF), no un escaneo</translation></message>
<message><source>this is a PostScript document, not a scan</source><translation>es un documento PostScript, no un escaneo</translation></message>
<message><source>this is a file of VTK, which is not read</source><translation>es un archivo de VTK, que no se lee</translation></message>
<message><source>save its points as PLY, or as CSV from ParaView's table</source><translation>guarde sus puntos como PLY, o como CSV desde la tabla de ParaView</translation></message>
<message><source>this is an OFF mesh, which is not read</source><translation>es una malla OFF, que no se lee</translation></message>
<message><source>this is a VRML scene, which is not read</source><translation>es una escena VRML, que no se lee</translation></message>
<message><source>this is a table of rocks, not a scan</source><translation>es una tabla de rocas, no un escaneo</translation></message>
<message><source>this is a raster of heights (Esri ASCII grid), not a scan</source><translation>es un ráster de alturas (cuadrícula ASCII de Esri), no un escaneo</translation></message>
<message><source>this is a raster of heights (Surfer grid), not a scan</source><translation>es un ráster de alturas (cuadrícula de Surfer), no un escaneo</translation></message>
<message><source>export it as E57 with FARO SCENE</source><translation>expórtelo como E57 con FARO SCENE</translation></message>
<message><source>export it as E57 or LAS with RiSCAN PRO, or with RIEGL's rdbconvert</source><translation>expórtelo como E57 o LAS con RiSCAN PRO, o con rdbconvert de RIEGL</translation></message>
<message><source>export it as E57 with Z+F LaserControl</source><translation>expórtelo como E57 con Z+F LaserControl</translation></message>
<message><source>export it as E57 or PTX with Leica Cyclone</source><translation>expórtelo como E57 o PTX con Leica Cyclone</translation></message>
<message><source>export it as E57 with Autodesk ReCap</source><translation>expórtelo como E57 con Autodesk ReCap</translation></message>
<message><source>this is a FARO scan (FLS), which is not read</source><translation>es un escaneo FARO (FLS), que no se lee</translation></message>
<message><source>this is a FARO workspace, which is not read</source><translation>es un espacio de trabajo FARO, que no se lee</translation></message>
<message><source>this is a FARO project, which is not read</source><translation>es un proyecto FARO, que no se lee</translation></message>
<message><source>this is a RIEGL stream (RXP), which is not read</source><translation>es un flujo RIEGL (RXP), que no se lee</translation></message>
<message><source>this is a RIEGL database, which is not read</source><translation>es una base de datos RIEGL, que no se lee</translation></message>
<message><source>this is a RIEGL database (RDBX), which is not read</source><translation>es una base de datos RIEGL (RDBX), que no se lee</translation></message>
<message><source>this is a RIEGL scan (3DD), which is not read</source><translation>es un escaneo RIEGL (3DD), que no se lee</translation></message>
<message><source>this is a Z+F scan (ZFS), which is not read</source><translation>es un escaneo Z+F (ZFS), que no se lee</translation></message>
<message><source>this is a Z+F project (ZFPRJ), which is not read</source><translation>es un proyecto Z+F (ZFPRJ), que no se lee</translation></message>
<message><source>this is a Z+F scan (ZFC), which is not read</source><translation>es un escaneo Z+F (ZFC), que no se lee</translation></message>
<message><source>this is a Leica LGS project, which is not read</source><translation>es un proyecto Leica LGS, que no se lee</translation></message>
<message><source>this is a Leica LGSx project, which is not read</source><translation>es un proyecto Leica LGSx, que no se lee</translation></message>
<message><source>this is a Leica Cyclone database, which is not read</source><translation>es una base de datos Leica Cyclone, que no se lee</translation></message>
<message><source>this is an Autodesk ReCap project, which is not read</source><translation>es un proyecto Autodesk ReCap, que no se lee</translation></message>
<message><source>this is an Autodesk ReCap scan, which is not read</source><translation>es un escaneo Autodesk ReCap, que no se lee</translation></message>
<message><source>this is a Trimble scan (TZF), which is not read</source><translation>es un escaneo Trimble (TZF), que no se lee</translation></message>
<message><source>export it as E57 with Trimble RealWorks</source><translation>expórtelo como E57 con Trimble RealWorks</translation></message>
<message><source>this is a Topcon scan (CL3), which is not read</source><translation>es un escaneo Topcon (CL3), que no se lee</translation></message>
<message><source>export it as E57 or PTX with Topcon's program</source><translation>expórtelo como E57 o PTX con el programa de Topcon</translation></message>
<message><source>this is a Topcon scan (CLR), which is not read</source><translation>es un escaneo Topcon (CLR), que no se lee</translation></message>
<message><source>this is a Pointools cloud (POD), which is not read</source><translation>es una nube Pointools (POD), que no se lee</translation></message>
<message><source>export it as LAS with Bentley's program</source><translation>expórtelo como LAS con el programa de Bentley</translation></message>
<message><source>this is a Python pickle, which only Python can open</source><translation>es un pickle de Python, que solo Python puede abrir</translation></message>
<message><source>this is a ROS bag that does not begin like one</source><translation>es un bag de ROS que no empieza como tal</translation></message>
<message><source>copy it again</source><translation>cópiela de nuevo</translation></message>
<message><source>this is a ROS 2 bag that does not begin like one</source><translation>es un bag de ROS 2 que no empieza como tal</translation></message>
<message><source>this is a binary file without a telegram of a SICK scanner in it</source><translation>es un archivo binario sin telegrama de un escáner SICK</translation></message>
<message><source>save points as PCD or PLY; a capture of telegrams holds the bytes as they came from the scanner</source><translation>guarde los puntos como PCD o PLY; una captura de telegramas contiene los bytes tal como llegaron del escáner</translation></message>
<message><source>this is a BMP picture, not a scan</source><translation>es una imagen BMP, no un escaneo</translation></message>
<message><source>this is a drawing (DXF), which is not read</source><translation>es un dibujo (DXF), que no se lee</translation></message>
<message><source>choose the scan, or save the points of the drawing as CSV, LAS or PLY</source><translation>elija el escaneo, o guarde los puntos del dibujo como CSV, LAS o PLY</translation></message>
<message><source>this is an Excel workbook, not a table of text</source><translation>es un libro de Excel, no una tabla de texto</translation></message>
<message><source>save the sheet as .csv</source><translation>guarde la hoja como .csv</translation></message>
<message><source>this is an OpenDocument spreadsheet, not a table of text</source><translation>es una hoja de cálculo OpenDocument, no una tabla de texto</translation></message>
<message><source>this is a numpy archive, which is not read</source><translation>es un archivo numpy, que no se lee</translation></message>
<message><source>save the array of ranges or points as .npy</source><translation>guarde la matriz de distancias o puntos como .npy</translation></message>
<message><source>this is a ROS bag, and %1</source><translation>esto es un bag de ROS, y %1</translation></message>
<message><source>Network capture</source><translation>Captura de red</translation></message>
<message><source>The picture asks to be turned or mirrored when it is shown (orientation %1): its rows were taken as scan lines as they are stored.</source><translation>La imagen pide girarse o reflejarse al mostrarse (orientación %1): sus filas se tomaron como líneas tal como están guardadas.</translation></message>
<message><source>the picture promises more pixels than a file of %1 holds of a scan</source><translation>la imagen anuncia más píxeles de los que contiene de un escaneo un archivo de %1</translation></message>
<message><source>a pixel</source><translation>un píxel</translation></message>
<message><source>%n pixel holds no range (negative, not a number, or too far) and was taken as no return.</source><translation>%n píxel no contiene distancia (negativo, no numérico o demasiado lejos) y se tomó como sin retorno.</translation></message>
<message><source>%n pixels hold no range (negative, not a number, or too far) and were taken as no return.</source><translation>%n píxeles no contienen distancia (negativos, no numéricos o demasiado lejos) y se tomaron como sin retorno.</translation></message>
<message><source>Unit taken as millimetres, as range pictures have it.</source><translation>Unidad tomada como milímetros, como en las imágenes de distancias.</translation></message>
<message><source>this TIFF picture has %1 of %2 bits, and ranges need one of 16 bits or of 4-byte floats</source><translation>esta imagen TIFF tiene %1 de %2 bits, y las distancias necesitan uno de 16 bits o de números de 4 bytes</translation></message>
<message><source>%n channel</source><translation>%n canal</translation></message>
<message><source>%n channels</source><translation>%n canales</translation></message>
<message><source>choose a scan, or a range picture of 16 bits per pixel</source><translation>elija un escaneo, o una imagen de distancias de 16 bits por píxel</translation></message>
<message><source>this TIFF picture is stored in tiles</source><translation>esta imagen TIFF está guardada en mosaicos</translation></message>
<message><source>save it in strips</source><translation>guárdela en tiras</translation></message>
<message><source>the picture has no pixels</source><translation>la imagen no tiene píxeles</translation></message>
<message><source>the TIFF picture is damaged or of a kind that cannot be read</source><translation>la imagen TIFF está dañada o es de un tipo que no se puede leer</translation></message>
<message><source>reading the picture</source><translation>lectura de la imagen</translation></message>
<message><source>The file holds %1 (pages); the first was read.</source><translation>El archivo contiene %1 (páginas); se leyó la primera.</translation></message>
<message><source>the picture</source><translation>la imagen</translation></message>
<message><source>this is a TIFF picture, and this build of the program cannot read TIFF</source><translation>esto es una imagen TIFF, y esta versión del programa no puede leer TIFF</translation></message>
<message><source>save the ranges as PNG of 16 bits</source><translation>guarde las distancias como PNG de 16 bits</translation></message>
<message><source>this is a PNG picture of %1 bit gray, and ranges need 16 bit gray</source><translation>es una imagen PNG de %1 bits en gris, y las distancias necesitan 16 bits en gris</translation></message>
<message><source>this is a PNG picture of %1 bit colour, and ranges need 16 bit gray</source><translation>es una imagen PNG de %1 bits en color, y las distancias necesitan 16 bits en gris</translation></message>
<message><source>The picture is animated; the first frame was read.</source><translation>La imagen es animada; se leyó el primer cuadro.</translation></message>
<message><source>The picture does not end with IEND: the file was cut off behind its pixels.</source><translation>La imagen no termina con IEND: el archivo se cortó detrás de sus píxeles.</translation></message>
<message><source>this is a PNG picture that cannot be read: </source><translation>es una imagen PNG que no se puede leer: </translation></message>
<message><source>close other programs</source><translation>cierre otros programas</translation></message>
<message><source>the file ends within its LAS header</source><translation>el archivo termina dentro de su encabezado LAS</translation></message>
<message><source>this is LAS version %1.%2, and versions up to 1.4 are known</source><translation>esto es LAS versión %1.%2, y se conocen las versiones hasta 1.4</translation></message>
<message><source>save it as LAS 1.2 or 1.4</source><translation>guárdelo como LAS 1.2 o 1.4</translation></message>
<message><source>the LAS header says it is %1 bytes long</source><translation>el encabezado LAS dice que tiene %1 bytes</translation></message>
<message><source>the scale or offset in the LAS header is not a number that coordinates can have</source><translation>la escala o el desplazamiento del encabezado LAS no es un número que puedan tener unas coordenadas</translation></message>
<message><source>points of format %1 with %2 bytes are none that LAS knows</source><translation>LAS no conoce puntos del formato %1 con %2 bytes</translation></message>
<message><source>the file holds no points</source><translation>el archivo no contiene puntos</translation></message>
<message><source>the points begin at byte %1, which is not in the file</source><translation>los puntos empiezan en el byte %1, que no está en el archivo</translation></message>
<message><source>the header promises %1 of %2 bytes and the file holds %3 bytes of them</source><translation>el encabezado anuncia %1 de %2 bytes y el archivo contiene %3 bytes de ellos</translation></message>
<message><source>The end of the file is damaged or missing: %1 of %2 records behind the points cannot be read. A grid, cell states or a place in the mine that they held are lost; copy the file again.</source><translation>El final del archivo está dañado o falta: %1 de %2 registros detrás de los puntos no se pueden leer. Una cuadrícula, estados de celdas o un lugar en la mina que contenían se han perdido; copie de nuevo el archivo.</translation></message>
<message><source>the %1 that the header promises</source><translation>los %1 que anuncia el encabezado</translation></message>
<message><source>the last record</source><translation>el último registro</translation></message>
<message><source>The waveforms of this file were not read.</source><translation>Las formas de onda de este archivo no se leyeron.</translation></message>
<message><source>describes a scan of %1 valid cells and holds %2</source><translation>describe un escaneo de %1 celdas válidas y contiene %2</translation></message>
<message><source>save the scan again</source><translation>guarde de nuevo el escaneo</translation></message>
<message><source>x and y of this file are degrees of longitude and latitude, as its coordinate system says, and points need metres</source><translation>x e y de este archivo son grados de longitud y latitud, según su sistema de coordenadas, y los puntos necesitan metros</translation></message>
<message><source>export it in a projected coordinate system such as UTM</source><translation>expórtelo en un sistema de coordenadas proyectado como UTM</translation></message>
<message><source>The coordinate system of the file is %1, without its unit: metres were taken. --unit says another one.</source><translation>El sistema de coordenadas del archivo es %1, sin su unidad: se tomaron metros. --unit indica otra.</translation></message>
<message><source>The coordinate system of the file gives lengths in %1 of %2 mm: they were converted.</source><translation>El sistema de coordenadas del archivo da las longitudes en %1 de %2 mm: se convirtieron.</translation></message>
<message><source>Heights of the file have another unit than x and y, %1 mm: they were converted.</source><translation>Las alturas del archivo tienen otra unidad que x e y, %1 mm: se convirtieron.</translation></message>
<message><source>%n point is marked as withheld in the file and counts as no return.</source><translation>%n punto está marcado como excluido en el archivo y cuenta como sin retorno.</translation></message>
<message><source>%n points are marked as withheld in the file and count as no return.</source><translation>%n puntos están marcados como excluidos en el archivo y cuentan como sin retorno.</translation></message>
<message><source>there are no points to save</source><translation>no hay puntos que guardar</translation></message>
<message><source>choose other cells or settings</source><translation>elija otras celdas u otros ajustes</translation></message>
<message><source>LAS holds 2147 km in whole millimetres, and these points lie farther apart</source><translation>LAS abarca 2147 km en milímetros enteros, y estos puntos están más separados</translation></message>
<message><source>save them as .pcd or .ply</source><translation>guárdelos como .pcd o .ply</translation></message>
<message><source>LASzip gives no reason</source><translation>LASzip no da ningún motivo</translation></message>
<message><source>this LAZ file cannot be unpacked: %1</source><translation>este archivo LAZ no se puede descomprimir: %1</translation></message>
<message><source>the header promises %1, more than a file of %2 holds of a scan</source><translation>el encabezado anuncia %1, más de lo que un archivo de %2 contiene de un escaneo</translation></message>
<message><source>copy it again, or save it as .las</source><translation>cópielo de nuevo, o guárdelo como .las</translation></message>
<message><source>the header promises %1 and the file ends after %2 (%3)</source><translation>el encabezado anuncia %1 y el archivo termina después de %2 (%3)</translation></message>
<message><source>this LAZ file is damaged or cut off</source><translation>este archivo LAZ está dañado o cortado</translation></message>
<message><source>this LAZ file cannot be unpacked: </source><translation>este archivo LAZ no se puede descomprimir: </translation></message>
<message><source>this LAZ file cannot be unpacked: it ends too early</source><translation>este archivo LAZ no se puede descomprimir: termina demasiado pronto</translation></message>
<message><source>this LAS file is compressed (LAZ), and this build of the program was made without LASzip</source><translation>este archivo LAS está comprimido (LAZ), y esta versión del programa se compiló sin LASzip</translation></message>
<message><source>save it uncompressed as .las, with CloudCompare or "laszip -i IN.laz -o OUT.las"</source><translation>guárdelo sin comprimir como .las, con CloudCompare o "laszip -i IN.laz -o OUT.las"</translation></message>
<message><source>reading ranges</source><translation>lectura de las distancias</translation></message>
<message><source>the array at [%1, %2]</source><translation>la matriz en [%1, %2]</translation></message>
<message><source>The first three of %1 columns were taken as x, y and z; the others are not read.</source><translation>Las tres primeras de %1 columnas se tomaron como x, y y z; las demás no se leen.</translation></message>
<message><source>the records of this numpy array have no x, y and z, only %1</source><translation>los registros de esta matriz numpy no tienen x, y y z, solo %1</translation></message>
<message><source>save points with fields x, y and z</source><translation>guarde los puntos con campos x, y y z</translation></message>
<message><source>the fields of this numpy array have different byte orders</source><translation>los campos de esta matriz numpy tienen distintos órdenes de bytes</translation></message>
<message><source>save it again with one</source><translation>guárdela de nuevo con uno solo</translation></message>
<message><source>a numpy array of shape %1 is larger than any scan</source><translation>una matriz numpy de forma %1 es mayor que cualquier escaneo</translation></message>
<message><source>split it</source><translation>divídala</translation></message>
<message><source>a numpy array of shape %1 may be points the wrong way round, or three lines of ranges</source><translation>una matriz numpy de forma %1 pueden ser puntos con los ejes cambiados, o tres líneas de distancias</translation></message>
<message><source>save points as (n, 3), which is points.T, or give --beam-start --beam-step --line-start --line-step --axis</source><translation>guarde los puntos como (n, 3), que es points.T, o indique --beam-start --beam-step --line-start --line-step --axis</translation></message>
<message><source>a numpy array of shape %1 is neither ranges (lines, beams) nor points (n, 3) or (lines, beams, 3)</source><translation>una matriz numpy de forma %1 no es ni distancias (líneas, haces) ni puntos (n, 3) o (líneas, haces, 3)</translation></message>
<message><source>save it in one of these shapes</source><translation>guárdela en una de estas formas</translation></message>
<message><source>The file holds more than one array (numpy.save more than once); the first was read.</source><translation>El archivo contiene más de una matriz (numpy.save más de una vez); se leyó la primera.</translation></message>
<message><source>the array</source><translation>la matriz</translation></message>
<message><source>Python objects, which only Python can open</source><translation>objetos de Python, que solo Python puede abrir</translation></message>
<message><source>true and false</source><translation>verdadero y falso</translation></message>
<message><source>complex numbers</source><translation>números complejos</translation></message>
<message><source>dates or times</source><translation>fechas u horas</translation></message>
<message><source>values of type %1</source><translation>valores del tipo %1</translation></message>
<message><source>save the array again with numpy.save</source><translation>guarde de nuevo la matriz con numpy.save</translation></message>
<message><source>the file ends within its numpy header</source><translation>el archivo termina dentro de su encabezado numpy</translation></message>
<message><source>this is version %1 of numpy's format</source><translation>esta es la versión %1 del formato de numpy</translation></message>
<message><source>the numpy header does not say type, order and shape</source><translation>el encabezado numpy no dice tipo, orden y forma</translation></message>
<message><source>the numpy header promises an array of shape %1</source><translation>el encabezado numpy anuncia una matriz de forma %1</translation></message>
<message><source>this numpy array holds %1</source><translation>esta matriz numpy contiene %1</translation></message>
<message><source>save it as an array of numbers (ranges.astype(numpy.float32))</source><translation>guárdela como matriz de números (ranges.astype(numpy.float32))</translation></message>
<message><source>this numpy array of shape %1 is empty</source><translation>esta matriz numpy de forma %1 está vacía</translation></message>
<message><source>the numpy header promises an array of shape %1, %2 of %3 bytes, and the file holds %4 bytes of them</source><translation>el encabezado numpy anuncia una matriz de forma %1, %2 de %3 bytes, y el archivo contiene %4 bytes de ellos</translation></message>
<message><source>%n item</source><translation>%n elemento</translation></message>
<message><source>%n items</source><translation>%n elementos</translation></message>
<message><source>this vertex does not hold three numbers</source><translation>este vértice no contiene tres números</translation></message>
<message><source>copy the file again, it may be cut off here</source><translation>copie de nuevo el archivo, puede estar cortado aquí</translation></message>
<message><source>this OBJ file has no vertices</source><translation>este archivo OBJ no tiene vértices</translation></message>
<message><source>%n line holds no words of OBJ and was not read, the first is line %1.</source><translation>%n línea no tiene palabras de OBJ y no se leyó, la primera es la línea %1.</translation></message>
<message><source>%n lines hold no words of OBJ and were not read, the first is line %1.</source><translation>%n líneas no tienen palabras de OBJ y no se leyeron, la primera es la línea %1.</translation></message>
<message><source>this header line of the PCD file is not understood</source><translation>no se entiende esta línea del encabezado del archivo PCD</translation></message>
<message><source>compare it with a PCD file of version 0.7</source><translation>compárelo con un archivo PCD de versión 0.7</translation></message>
<message><source>the PCD header has no DATA line</source><translation>el encabezado PCD no tiene línea DATA</translation></message>
<message><source>the PCD header names %1 and gives %2, %3 and %4</source><translation>el encabezado PCD nombra %1 y da %2, %3 y %4</translation></message>
<message><source>%n field</source><translation>%n campo</translation></message>
<message><source>%n fields</source><translation>%n campos</translation></message>
<message><source>%n size</source><translation>%n tamaño</translation></message>
<message><source>%n sizes</source><translation>%n tamaños</translation></message>
<message><source>%n type</source><translation>%n tipo</translation></message>
<message><source>%n types</source><translation>%n tipos</translation></message>
<message><source>%n count</source><translation>%n cuenta</translation></message>
<message><source>%n counts</source><translation>%n cuentas</translation></message>
<message><source>the header promises more points than any file holds</source><translation>el encabezado anuncia más puntos de los que contiene ningún archivo</translation></message>
<message><source>the header promises %1 and %2 x %3 of them</source><translation>el encabezado anuncia %1 y %2 x %3 de ellos</translation></message>
<message><source>the field %1 has a type or size that PCD does not know</source><translation>el campo %1 tiene un tipo o un tamaño que PCD no conoce</translation></message>
<message><source>one point would take more than a megabyte</source><translation>un punto ocuparía más de un megabyte</translation></message>
<message><source>the PCD file has no fields x, y and z</source><translation>el archivo PCD no tiene campos x, y y z</translation></message>
<message><source>export the file with coordinates</source><translation>exporte el archivo con coordenadas</translation></message>
<message><source>the file ends before its compressed points</source><translation>el archivo termina antes de sus puntos comprimidos</translation></message>
<message><source>promises %1 compressed bytes and holds %2</source><translation>anuncia %1 bytes comprimidos y contiene %2</translation></message>
<message><source>promises that %1 unpack to %2, which no scan does</source><translation>anuncia que %1 se descomprimen en %2, lo que ningún escaneo hace</translation></message>
<message><source>export the file again, uncompressed</source><translation>exporte de nuevo el archivo, sin comprimir</translation></message>
<message><source>the compressed points are damaged</source><translation>los puntos comprimidos están dañados</translation></message>
<message><source>the points</source><translation>los puntos</translation></message>
<message><source>the encoding "%1" is not ascii, binary or binary_compressed</source><translation>la codificación «%1» no es ascii, binary ni binary_compressed</translation></message>
<message><source>this header line of the PLY file is not understood</source><translation>no se entiende esta línea del encabezado del archivo PLY</translation></message>
<message><source>the PLY header has no end_header line</source><translation>el encabezado PLY no tiene línea end_header</translation></message>
<message><source>the file ends before its vertices</source><translation>el archivo termina antes de sus vértices</translation></message>
<message><source>the header promises %1</source><translation>el encabezado anuncia %1</translation></message>
<message><source>check the file</source><translation>compruebe el archivo</translation></message>
<message><source>the PLY file has no vertices</source><translation>el archivo PLY no tiene vértices</translation></message>
<message><source>The lists that each vertex of this file has were not read.</source><translation>Las listas que tiene cada vértice de este archivo no se leyeron.</translation></message>
<message><source>the header promises %1 and the file ends after %2</source><translation>el encabezado anuncia %1 y el archivo termina después de %2</translation></message>
<message><source>%n vertex</source><translation>%n vértice</translation></message>
<message><source>%n vertices</source><translation>%n vértices</translation></message>
<message><source>the format "%1" is none that PLY knows</source><translation>PLY no conoce el formato «%1»</translation></message>
<message><source>the header promises %1 and the file holds %2 bytes of them</source><translation>el encabezado anuncia %1 y el archivo contiene %2 bytes de ellos</translation></message>
<message><source>the file is cut off in its last vertex</source><translation>el archivo está cortado en su último vértice</translation></message>
<message><source>Each vertex has a byte that the header does not name, as PCL writes it behind colours: it was skipped.</source><translation>Cada vértice tiene un byte que el encabezado no nombra, como lo escribe PCL detrás de los colores: se omitió.</translation></message>
<message><source>the vertices have no x, y and z</source><translation>los vértices no tienen x, y y z</translation></message>
<message><source>Only the vertices were read, not what follows them: %1.</source><translation>Solo se leyeron los vértices, no lo que los sigue: %1.</translation></message>
<message><source>say which columns are easting (x), northing (y) and elevation (z), by number or name: --columns 2,1,3</source><translation>diga qué columnas son este (x), norte (y) y elevación (z), por número o nombre: --columns 2,1,3</translation></message>
<message><source>--columns %1 does not name three different ones of its %2%3</source><translation>--columns %1 no nombra tres distintas de sus %2%3</translation></message>
<message><source>give three numbers from 1, or three names, such as --columns 2,1,3</source><translation>dé tres números desde 1, o tres nombres, como --columns 2,1,3</translation></message>
<message><source>holds %1 where a point needs three</source><translation>contiene %1 donde un punto necesita tres</translation></message>
<message><source>%n number</source><translation>%n número</translation></message>
<message><source>%n numbers</source><translation>%n números</translation></message>
<message><source>choose a point list or a table of ranges</source><translation>elija una lista de puntos o una tabla de distancias</translation></message>
<message><source>its heading names %1 (%2), and points need x, y and z in metres</source><translation>su título nombra %1 (%2), y los puntos necesitan x, y y z en metros</translation></message>
<message><source>write x, y and z, or ranges as a table with a row per scan line; or </source><translation>escriba x, y y z, o distancias como tabla con una fila por línea; o </translation></message>
<message><source>its heading names axes (%1), and not all of x, y and z are understood</source><translation>su encabezado nombra ejes (%1), y no se entienden todos los x, y y z</translation></message>
<message><source>its heading names no x, y and z that are understood (%1)</source><translation>su encabezado no nombra x, y y z que se entiendan (%1)</translation></message>
<message><source>the second to the fourth</source><translation>de la segunda a la cuarta</translation></message>
<message><source>the third to the fifth</source><translation>de la tercera a la quinta</translation></message>
<message><source>the fourth to the sixth</source><translation>de la cuarta a la sexta</translation></message>
<message><source>the fifth to the seventh</source><translation>de la quinta a la séptima</translation></message>
<message><source>the first holds</source><translation>la primera contiene</translation></message>
<message><source>the first two hold</source><translation>las dos primeras contienen</translation></message>
<message><source>the first three hold</source><translation>las tres primeras contienen</translation></message>
<message><source>the first four hold</source><translation>las cuatro primeras contienen</translation></message>
<message><source>No heading names the columns: the first two were taken for row and column of the grid, the third to the fifth for x, y and z.</source><translation>Ningún encabezado nombra las columnas: las dos primeras se tomaron como fila y columna de la cuadrícula, de la tercera a la quinta como x, y y z.</translation></message>
<message><source>No heading names the columns: %1 were taken for x, y and z, as %2 whole numbers only.</source><translation>Ningún título nombra las columnas: como x, y y z se tomaron %1, pues %2 solo números enteros.</translation></message>
<message><source>The header names no x, y and z: the first three columns were taken for them (%1, %2, %3).</source><translation>El encabezado no nombra x, y ni z: se tomaron para ello las tres primeras columnas (%1, %2, %3).</translation></message>
<message><source>The heading does not name as many columns as there are (%1): the first three were taken for x, y and z.</source><translation>El encabezado no nombra tantas columnas como hay (%1): las tres primeras se tomaron como x, y y z.</translation></message>
<message><source>this is neither text nor any scan format that is known</source><translation>esto no es ni texto ni ningún formato de escaneo conocido</translation></message>
<message><source>begins a further list, behind the %1 of the first</source><translation>empieza otra lista, después de los %1 de la primera</translation></message>
<message><source>save each scan in a file of its own</source><translation>guarde cada escaneo en un archivo propio</translation></message>
<message><source>holds %1 where a point needs %2</source><translation>contiene %1 donde un punto necesita %2</translation></message>
<message><source>the file may be cut off here, copy it again</source><translation>el archivo puede estar cortado aquí, cópielo de nuevo</translation></message>
<message><source>promises %1 and holds %2</source><translation>anuncia %1 y contiene %2</translation></message>
<message><source>scan %1 of this PTX file promises %2 of %3, and the file ends before them</source><translation>el escaneo %1 de este archivo PTX anuncia %2 de %3, y el archivo termina antes</translation></message>
<message><source>behind the %1 of %2 that the header promises there are more</source><translation>después de los %1 de %2 que anuncia el encabezado hay más</translation></message>
<message><source>scan %1 has no PTX header here</source><translation>el escaneo %1 no tiene aquí encabezado PTX</translation></message>
<message><source>the scan of this PTX file holds 0 points</source><translation>el escaneo de este archivo PTX contiene 0 puntos</translation></message>
<message><source>the %1 scans of this PTX file hold 0 points</source><translation>los %1 escaneos de este archivo PTX contienen 0 puntos</translation></message>
<message><source>the header promises %1 and the file holds %2</source><translation>el encabezado anuncia %1 y el archivo contiene %2</translation></message>
<message><source>The matrix of the header has the scanner's place in its last column and not in its last row: it was read by columns.</source><translation>La matriz del encabezado tiene el lugar del escáner en su última columna y no en su última fila: se leyó por columnas.</translation></message>
<message><source>Lines 4 to 6 of the header turn the scanner to another side than its matrix: the matrix was used.</source><translation>Las líneas 4 a 6 del encabezado giran el escáner hacia otro lado que su matriz: se usó la matriz.</translation></message>
<message><source>Line 3 of the header puts the scanner %1 m from the place that its matrix gives: the matrix was used.</source><translation>La línea 3 del encabezado pone el escáner a %1 m del lugar que da su matriz: se usó la matriz.</translation></message>
<message><source>Behind the last of these scans there is text that is none.</source><translation>Detrás del último de estos escaneos hay texto que no lo es.</translation></message>
<message><source>PTX holds one point per cell, and points behind the nearest of their cell were asked for</source><translation>PTX contiene un punto por celda, y se pidieron también los puntos detrás del más cercano de su celda</translation></message>
<message><source>use .pcd, .ply, .csv, .xyz, .las or .obj for them</source><translation>use para ellos .pcd, .ply, .csv, .xyz, .las u .obj</translation></message>
<message><source>column %1 holds %2, so this is not a table of ranges</source><translation>la columna %1 contiene %2, así que esto no es una tabla de distancias</translation></message>
<message><source>for a list of points call its columns x, y and z in a first row, and leave out --beam-step and --line-step</source><translation>para una lista de puntos llame a sus columnas x, y y z en una primera fila, y deje fuera --beam-step y --line-step</translation></message>
<message><source>; or save it with a row per scan line: it has as many rows as an LMS511 has beams</source><translation>; o guárdela con una fila por línea: tiene tantas filas como haces un LMS511</translation></message>
<message><source>holds %1 where the first line holds %2</source><translation>contiene %1 donde la primera línea contiene %2</translation></message>
<message><source>%n range</source><translation>%n distancia</translation></message>
<message><source>%n ranges</source><translation>%n distancias</translation></message>
<message><source>copy or export the file again</source><translation>copie o exporte de nuevo el archivo</translation></message>
<message><source>%n column is not ranges, by the header, and not read: %1.</source><translation>%n columna no son distancias, según el encabezado, y no se leyó: %1.</translation></message>
<message><source>%n columns are not ranges, by the header, and not read: %1.</source><translation>%n columnas no son distancias, según el encabezado, y no se leyeron: %1.</translation></message>
<message><source>The angles of the beams were taken from the header: %1 to %2 degrees.</source><translation>Los ángulos de los haces se tomaron del encabezado: de %1 a %2 grados.</translation></message>
<message><source>The angles of the lines were taken from the first column: %1 to %2 degrees.</source><translation>Los ángulos de las líneas se tomaron de la primera columna: de %1 a %2 grados.</translation></message>
<message><source>Unit taken from a comment of the file: %1 mm per number.</source><translation>Unidad tomada de un comentario del archivo: %1 mm por unidad.</translation></message>
<message><source>line %1, beam %2</source><translation>línea %1, haz %2</translation></message>
<message><source> infinite ranges were taken as no return.</source><translation> distancias infinitas se tomaron como sin retorno.</translation></message>
<message><source> ranges below 0, all the same number, were taken as no return.</source><translation> distancias menores que 0, todas el mismo número, se tomaron como sin retorno.</translation></message>
<message><source> ranges longer than any scanner reaches were taken as no return.</source><translation> distancias más largas que el alcance de cualquier escáner se tomaron como sin retorno.</translation></message>
<message><source>%1 holds %2, which is not a range</source><translation>%1 contiene %2, que no es una distancia</translation></message>
<message><source>check that these are ranges; points need columns x, y and z</source><translation>compruebe que sean distancias; los puntos necesitan columnas x, y y z</translation></message>
<message><source>cells hold %1 in the numbers of the file</source><translation>celdas contienen %1 en los números del archivo</translation></message>
<message><source>give %1</source><translation>indique %1</translation></message>
<message><source>: those of an LMS511 were taken where none were given (beams from -5 degrees by 1/6 degree, lines from 0 by 0.18 degree, axis spin).</source><translation>: donde no se dieron se tomaron los de un LMS511 (haces desde -5 grados cada 1/6 de grado, líneas desde 0 cada 0.18 grados, eje spin).</translation></message>
<message><source>The ranges reach %1 km: check %2.</source><translation>Las distancias llegan a %1 km: revise %2.</translation></message>
<message><source>All ranges are below 100 mm, so they may be metres: check %1.</source><translation>Todas las distancias están por debajo de 100 mm, así que pueden ser metros: revise %1.</translation></message>
<message><source>All %1 lines are at one angle: check the step from line to line.</source><translation>Las %1 líneas están todas en un mismo ángulo: revise el paso de línea a línea.</translation></message>
<message><source>a table of %1 per line does not say its angles</source><translation>una tabla de %1 por línea no dice sus ángulos</translation></message>
<message><source>The table does not say its angles</source><translation>La tabla no dice sus ángulos</translation></message>
<message><source>a picture of %1 per line does not say its angles</source><translation>una imagen de %1 por línea no dice sus ángulos</translation></message>
<message><source>The picture does not say its angles</source><translation>La imagen no dice sus ángulos</translation></message>
<message><source>a numpy array of %1 per line does not say its angles</source><translation>una matriz numpy de %1 por línea no dice sus ángulos</translation></message>
<message><source>The numpy array does not say its angles</source><translation>La matriz numpy no dice sus ángulos</translation></message>
<message><source>%1 lines x %2 beams</source><translation>%1 líneas x %2 haces</translation></message>
<message><source>holds %1 bytes where %2 need %3</source><translation>contiene %1 bytes donde %2 necesitan %3</translation></message>
<message><source>check lines and beams in the .json file</source><translation>revise líneas y haces en el archivo .json</translation></message>
<message><source>"beam_deg" is missing</source><translation>falta "beam_deg"</translation></message>
<message><source>"line_deg" is missing</source><translation>falta "line_deg"</translation></message>
<message><source>"axis" is missing</source><translation>falta "axis"</translation></message>
<message><source>add it to the .json file, or give --beam-start --beam-step --line-start --line-step --axis</source><translation>añádalo al archivo .json, o indique --beam-start --beam-step --line-start --line-step --axis</translation></message>
<message><source>"%1" is not a key of a raw grid and was not used: check its spelling.</source><translation>"%1" no es una clave de una cuadrícula en bruto y no se usó: revise su ortografía.</translation></message>
<message><source>the file names the counts of missing returns</source><translation>el archivo indica las cuentas de los retornos que faltan</translation></message>
<message><source>The data file %1 is missing; %2 was read in its place.</source><translation>Falta el archivo de datos %1; en su lugar se leyó %2.</translation></message>
<message><source>counts alone are not a raw grid</source><translation>unas cuentas solas no son una cuadrícula sin procesar</translation></message>
<message><source>give the description before them</source><translation>indique la descripción antes que ellas</translation></message>
<message><source>these counts need their description %1 next to them, and it cannot be read</source><translation>estos valores necesitan su descripción %1 al lado, y no se puede leer</translation></message>
<message><source>copy it into the same folder</source><translation>cópiela en la misma carpeta</translation></message>
<message><source>save it as PCD, which carries every scan</source><translation>guárdelo como PCD, que admite cualquier escaneo</translation></message>
<message><source>a raw grid needs beam and line angles and this cloud has none</source><translation>una cuadrícula sin procesar necesita ángulos de haces y de líneas y esta nube no los tiene</translation></message>
<message><source>a raw grid holds whole counts of its unit up to 65535, and the range at %1 is none or means no return</source><translation>una cuadrícula sin procesar contiene cuentas enteras de su unidad hasta 65535, y la distancia en %1 no lo es o significa sin retorno</translation></message>
<message><source>%1, and %2</source><translation>%1, y %2</translation></message>
<message><source>a point of a string needs its number, northing, easting and elevation</source><translation>un punto de una cadena necesita su número, norte, este y elevación</translation></message>
<message><source>copy the file again, it may be cut off or damaged here</source><translation>copie de nuevo el archivo, puede estar cortado o dañado aquí</translation></message>
<message><source>a Surpac string file is text, and this is none</source><translation>un archivo de cadenas de Surpac es texto, y este no lo es</translation></message>
<message><source>Surpac strings</source><translation>Líneas de Surpac</translation></message>
<message><source>this Surpac file has no points</source><translation>este archivo Surpac no tiene puntos</translation></message>
<message><source>The file does not end with END: it may have been cut off; compare it with the original.</source><translation>El archivo no termina con END: puede estar cortado; compárelo con el original.</translation></message>
<message><source>Descriptions of points (D1 and further) are not read.</source><translation>Las descripciones de los puntos (D1 y siguientes) no se leen.</translation></message>
<message><source>%n line behind END was not read.</source><translation>%n línea detrás de END no se leyó.</translation></message>
<message><source>%n lines behind END were not read.</source><translation>%n líneas detrás de END no se leyeron.</translation></message>
<message><source>open the scan as the scanner stored it, or with its record</source><translation>abra el escaneo tal como lo guardó el escáner, o con su registro</translation></message>
<message><source>finding the axis</source><translation>búsqueda del eje</translation></message>
<message><source>they do not follow each other in scan lines that turn about an axis elsewhere</source><translation>no se siguen en líneas que giran alrededor de un eje en otro lugar</translation></message>
<message><source>Each line has every %1th beam only, in turn: %2 lines that follow each other were put side by side.</source><translation>Cada línea solo tiene un haz de cada %1, por turno: %2 líneas seguidas se pusieron lado a lado.</translation></message>
<message><source>the %1 points do not lie on beam x line angles about the origin:</source><translation>los %1 puntos no están en ángulos haz x línea alrededor del origen:</translation></message>
<message><source>about %1 no scan lines can be recognised</source><translation>alrededor de %1 no se reconocen líneas de escaneo</translation></message>
<message><source>about %1 %2 % lie on the best %3</source><translation>alrededor de %1 el %2 % está en los mejores %3</translation></message>
<message><source>%n line angles</source><translation>%n ángulos de línea</translation></message>
<message><source>%n beam angles</source><translation>%n ángulos de haz</translation></message>
<message><source> (99 % are needed)</source><translation> (se necesita el 99 %)</translation></message>
<message><source>The list was not a full grid in order: %1 lines x %2 beams were recovered from the angles of its points.</source><translation>La lista no era una cuadrícula completa en orden: se recuperaron %1 líneas x %2 haces a partir de los ángulos de sus puntos.</translation></message>
<message><source> lines repeated the line before and were left out.</source><translation> líneas repetían la línea anterior y se dejaron fuera.</translation></message>
<message><source> points stood in the list before, as when a driver stores lines twice, and were taken once.</source><translation> puntos ya estaban en la lista, como cuando un controlador guarda líneas dos veces, y se tomaron una vez.</translation></message>
<message><source> lines or beams without any point were put back empty, to keep the steps even.</source><translation> líneas o haces sin ningún punto se repusieron vacíos, para mantener pasos iguales.</translation></message>
<message><source> points belong to no single cell of the grid (on the rotation axis, or off the grid) and were left out.</source><translation> puntos no pertenecen a una sola celda de la cuadrícula (en el eje de rotación, o fuera de la cuadrícula) y se dejaron fuera.</translation></message>
<message><source> points lay in a cell with a nearer one, which was taken.</source><translation> puntos estaban en una celda con uno más cercano, que se tomó.</translation></message>
<message><source>The line angles are uneven: steps from %1 to %2 degrees, kept as they are.</source><translation>Los ángulos de las líneas son desiguales: pasos de %1 a %2 grados, conservados como están.</translation></message>
<message><source>The lines turn about the file's y axis, which became z: x is the file's z, y its x, z its y.</source><translation>Las líneas giran alrededor del eje y del archivo, que pasó a ser z: x es la z del archivo, y su x, z su y.</translation></message>
<message><source>holds %1 with a return, too few to find a scanner's grid</source><translation>contiene %1 con retorno, muy pocos para encontrar la cuadrícula de un escáner</translation></message>
<message><source>check that the file is complete</source><translation>compruebe que el archivo esté completo</translation></message>
<message><source>holds more points than can be put on a grid</source><translation>contiene más puntos de los que caben en una cuadrícula</translation></message>
<message><source>split the file</source><translation>divida el archivo</translation></message>
<message><source>finding the grid</source><translation>búsqueda de la cuadrícula</translation></message>
<message><source>open the scan as the scanner stored it, with its origin at the scanner</source><translation>abra el escaneo tal como lo guardó el escáner, con el origen en el escáner</translation></message>
<message><source>%1 x %2 degrees</source><translation>%1 x %2 grados</translation></message>
<message><source>cells of %1 degrees over %2 would be %3 million cells</source><translation>celdas de %1 grados sobre %2 serían %3 millones de celdas</translation></message>
<message><source>give a larger --grid-step</source><translation>indique un --grid-step mayor</translation></message>
<message><source>all %1 points lie in one direction from there, within %2 and %3 to %4 away</source><translation>los %1 puntos están todos en una sola dirección desde allí, dentro de %2 y a %3 a %4</translation></message>
<message><source>%n point in, seen over %1 x %2 degrees; %3 of %4 cells filled (fill ratio %5 %; of the cells around a filled one %6 %), %7 attached to a cell with a nearer one</source><translation>%n punto incluido, visto sobre %1 x %2 grados; %3 de %4 celdas llenas (grado de llenado %5 %; de las celdas en torno a una llena el %6 %), %7 asignado a una celda con otro más cercano</translation></message>
<message><source>%n points in, seen over %1 x %2 degrees; %3 of %4 cells filled (fill ratio %5 %; of the cells around a filled one %6 %), %7 attached to a cell with a nearer one</source><translation>%n puntos incluidos, vistos sobre %1 x %2 grados; %3 de %4 celdas llenas (grado de llenado %5 %; de las celdas en torno a una llena el %6 %), %7 asignados a una celda con otro más cercano</translation></message>
<message><source>%n point far from all others left out</source><translation>%n punto lejos de todos los demás dejado fuera</translation></message>
<message><source>%n points far from all others left out</source><translation>%n puntos lejos de todos los demás dejados fuera</translation></message>
<message><source>a grid step of %1 degrees makes no grid</source><translation>un paso de cuadrícula de %1 grados no da ninguna cuadrícula</translation></message>
<message><source>give --grid-step between 0 and 45 degrees</source><translation>indique --grid-step entre 0 y 45 grados</translation></message>
<message><source>only %1 a return, too few to make a grid of them</source><translation>solo %1 retorno, muy pocos para hacer una cuadrícula</translation></message>
<message><source>%n point has</source><translation>%n punto tiene</translation></message>
<message><source>%n points have</source><translation>%n puntos tienen</translation></message>
<message><source>projecting the points</source><translation>proyección de los puntos</translation></message>
<message><source>seen from there the points make no picture: %1</source><translation>vistos desde allí los puntos no forman una imagen: %1</translation></message>
<message><source>give a larger --grid-step, or another --sensor</source><translation>indique un --grid-step mayor, u otro --sensor</translation></message>
<message><source>The file lists only points: </source><translation>El archivo contiene solo puntos: </translation></message>
<message><source>give --sensor X,Y,Z, the place in metres that the scan was taken from</source><translation>indique --sensor X,Y,Z,, el lugar en metros desde donde se tomó el escaneo</translation></message>
<message><source>Unit taken as millimetres</source><translation>Unidad tomada como milímetros</translation></message>
<message><source>Unit taken as centimetres</source><translation>Unidad tomada como centímetros</translation></message>
<message><source>Unit taken as metres</source><translation>Unidad tomada como metros</translation></message>
<message><source>Ranges beyond 1,000 m: if the file is in millimetres, give --unit mm.</source><translation>Distancias de más de 1000 m: si el archivo está en milímetros, indique --unit mm.</translation></message>
<message><source>, in which every range is a whole number of millimetres.</source><translation>, unidad en la que cada distancia es un número entero de milímetros.</translation></message>
<message><source>, from the size of the numbers.</source><translation>, por el tamaño de los números.</translation></message>
<message><source>a recording is being written already</source><translation>ya se está escribiendo una grabación</translation></message>
<message><source>stop it first</source><translation>deténgala primero</translation></message>
<message><source> ranges are range_min or range_max of their messages, repeat, and were taken as no return.</source><translation> distancias son el range_min o el range_max de sus mensajes, se repiten y se tomaron como sin retorno.</translation></message>
<message><source>no return </source><translation>sin retorno </translation></message>
<message><source>sweep complete</source><translation>barrido completo</translation></message>
<message><source>sweep ended</source><translation>barrido terminado</translation></message>
<message><source>window clean</source><translation>ventana limpia</translation></message>
<message><source> earlier in this sweep</source><translation> antes en este barrido</translation></message>
<message><source> scan telegrams since the start could not be decoded, so their lines are lost: </source><translation> telegramas de escaneo desde el inicio no se pudieron descodificar, así que sus líneas se han perdido: </translation></message>
<message><source> bytes since the start were not a telegram and were skipped.</source><translation> bytes desde el inicio no eran un telegrama y se omitieron.</translation></message>
<message><source>The sweep has ended; no line has come since.</source><translation>El barrido ha terminado; desde entonces no ha llegado ninguna línea.</translation></message>
<message><source>device ok</source><translation>equipo en orden</translation></message>
<message><source>DEVICE ERROR earlier in this sweep</source><translation>ERROR DEL APARATO antes en este barrido</translation></message>
<message><source>pose of unknown age</source><translation>pose de edad desconocida</translation></message>
<message><source>beam %1 of %2 would be at %3 degrees</source><translation>el haz %1 de %2 estaría a %3 grados</translation></message>
<message><source>line %1 of %2 would be at %3 degrees</source><translation>la línea %1 de %2 estaría a %3 grados</translation></message>
<message><source>give angles from %1 to %2 degrees</source><translation>indique ángulos de %1 a %2 grados</translation></message>
<message><source>a calibration alone gives no place</source><translation>una calibración sola no da un lugar</translation></message>
<message><source>give --pose POSE.json too</source><translation>indique también --pose POSE.json</translation></message>
<message><source>the format %1 does not have it</source><translation>el formato %1 no lo tiene</translation></message>
<message><source>%1 points lie farther than %2 from the sensor and were taken as no return: --sensor X,Y,Z says where it stood.</source><translation>%1 puntos están a más de %2 del sensor y se tomaron como sin retorno: --sensor X,Y,Z dice dónde estaba.</translation></message>
<message><source>%1 cannot be a measured %2: %3 to %4</source><translation>%1 no puede ser un valor medido de %2: de %3 a %4</translation></message>
<message><source>%1 at %5 cannot be a measured %2: %3 to %4</source><translation>%1 en %5 no puede ser un valor medido de %2: de %3 a %4</translation></message>
<message><source>check the unit and the numbers of the file</source><translation>compruebe la unidad y los números del archivo</translation></message>
<message><source>beam %1</source><translation>haz %1</translation></message>
<message><source>line %1</source><translation>línea %1</translation></message>
<message><source>the skew of beam %1</source><translation>el desfase del haz %1</translation></message>
<message><source>all %1 beams look the same way</source><translation>los %1 haces miran todos en la misma dirección</translation></message>
<message><source>give the step from beam to beam</source><translation>indique el paso de haz a haz</translation></message>
<message><source>all points are within %1 m of each other and at least %2 m away from the scanner, which no scanner measures</source><translation>todos los puntos están a menos de %1 m entre sí y al menos a %2 m del escáner, lo que ningún escáner mide</translation></message>
<message><source>give --sensor X,Y,Z, the place in metres that the scan was taken from, or check --unit</source><translation>indique --sensor X,Y,Z, el lugar en metros desde donde se tomó el escaneo, o compruebe --unit</translation></message>
<message><source>The sensor's place was found from the ranges that the file holds with its points.</source><translation>El lugar del sensor se halló a partir de las distancias que el archivo contiene con sus puntos.</translation></message>
<message><source>The columns of lines and beams hold no grid and were not used.</source><translation>Las columnas de líneas y haces no contienen ninguna cuadrícula y no se usaron.</translation></message>
<message><source>too few points</source><translation>muy pocos puntos</translation></message>
<message><source>left-handed points</source><translation>puntos de mano izquierda</translation></message>
<message><source>their scan lines turn about another axis than --axis says</source><translation>sus líneas de escaneo giran alrededor de otro eje que el de --axis</translation></message>
<message><source>their scan lines turn about an axis through the origin</source><translation>sus líneas de escaneo giran alrededor de un eje por el origen</translation></message>
<message><source>another grid</source><translation>otra cuadrícula</translation></message>
<message><source>about the axis of their scan lines they are on no common beams</source><translation>alrededor del eje de sus líneas de escaneo no están en haces comunes</translation></message>
<message><source>Lines and beams were exchanged: only that way the lines make fans about one axis.</source><translation>Líneas y haces se intercambiaron: solo así las líneas forman abanicos alrededor de un eje.</translation></message>
<message><source>The rows of the file make no fans about one axis as they are stored: %1, and only that way the lines make fans.</source><translation>Las filas del archivo, tal como están, no forman abanicos alrededor de un eje: %1, y solo así las líneas forman abanicos.</translation></message>
<message><source>they were taken as beams, and the columns as lines</source><translation>se tomaron como haces, y las columnas como líneas</translation></message>
<message><source>its counts of rows and columns were exchanged</source><translation>se intercambiaron sus números de filas y columnas</translation></message>
<message><source>its points were taken row by row, where the header says column by column</source><translation>sus puntos se tomaron fila por fila, donde el encabezado dice columna por columna</translation></message>
<message><source>No cell of this scan has a range that was measured: check the file, the topic and the limits of the range.</source><translation>Ninguna celda de este escaneo tiene una distancia medida: revise el archivo, el topic y los límites de distancia.</translation></message>
<message><source>this folder holds several scans</source><translation>esta carpeta contiene varios escaneos</translation></message>
<message><source>open one of them, or use edgescan-cli batch</source><translation>abra uno de ellos, o use edgescan-cli batch</translation></message>
<message><source>The pose in %1 replaces that in %2.</source><translation>La pose de %1 reemplaza la de %2.</translation></message>
<message><source>The folder holds %1 besides this recording: name one file, or use edgescan-cli batch.</source><translation>La carpeta contiene %1 además de esta grabación: nombre un archivo, o use edgescan-cli batch.</translation></message>
<message><source>%n scan</source><translation>%n escaneo</translation></message>
<message><source>%n scans</source><translation>%n escaneos</translation></message>
<message><source>a cell has the state %1, which does not exist</source><translation>una celda tiene el estado %1, que no existe</translation></message>
<message><source>describes %1 and holds %2</source><translation>describe %1 y contiene %2</translation></message>
<message><source>describes %1 but has no columns range_mm and state</source><translation>describe %1 pero no tiene las columnas range_mm y state</translation></message>
<message><source>save the scan again, or remove the comment lines</source><translation>guarde de nuevo el escaneo, o quite las líneas de comentario</translation></message>
<message><source>--unit does not apply: this program saved the file, in metres</source><translation>--unit no se aplica: este programa guardó el archivo, en metros</translation></message>
<message><source>leave --unit out</source><translation>deje fuera --unit</translation></message>
<message><source>a valid cell has a number that is not a range</source><translation>una celda válida tiene un número que no es una distancia</translation></message>
<message><source>the description in the comment lines has no angles</source><translation>la descripción en las líneas de comentario no tiene ángulos</translation></message>
<message><source>%n point was filled and not measured, as filled_sd_mm says: it was taken as no return.</source><translation>%n punto se rellenó y no se midió, como dice filled_sd_mm: se tomó como sin retorno.</translation></message>
<message><source>%n points were filled and not measured, as filled_sd_mm says: they were taken as no return.</source><translation>%n puntos se rellenaron y no se midieron, como dice filled_sd_mm: se tomaron como sin retorno.</translation></message>
<message><source>the file gives the grid of its cells</source><translation>el archivo da la cuadrícula de sus celdas</translation></message>
<message><source>The matrix of the %1 file was not used: its points are in another frame than the scanner's.</source><translation>La matriz del archivo %1 no se usó: sus puntos están en otro sistema que el del escáner.</translation></message>
<message><source>%1 cells hold status codes of an LMS2xx from %2 on instead of a range and were taken as such.</source><translation>%1 celdas contienen códigos de estado de un LMS2xx desde %2 en vez de una distancia y se tomaron como tales.</translation></message>
<message><source>The coordinates are rounded, and every point fits a whole number of millimetres along its beam: these were taken as ranges.</source><translation>Las coordenadas están redondeadas y cada punto cae en un número entero de milímetros a lo largo de su haz: estos se tomaron como distancias.</translation></message>
<message><source>The file's coordinates are left-handed and were turned right-handed: y is mirrored.</source><translation>Las coordenadas del archivo son levógiras y se hicieron dextrógiras: y está reflejada.</translation></message>
<message><source>%1 of %2 cells of the grid that was found have no point and count as no return.</source><translation>%1 de %2 celdas de la cuadrícula encontrada no tienen punto y cuentan como sin retorno.</translation></message>
<message><source>the origin, because no sensor position is known (--sensor X,Y,Z gives it)</source><translation>el origen, porque no se conoce ninguna posición del sensor (--sensor X,Y,Z la da)</translation></message>
<message><source>the sensor position given, (%1, %2, %3) m</source><translation>la posición del sensor indicada, (%1, %2, %3) m</translation></message>
<message><source>the sensor position in the file, (%1, %2, %3) m</source><translation>la posición del sensor en el archivo, (%1, %2, %3) m</translation></message>
<message><source>The points lie on no scanner grid and were projected about %1: %2.</source><translation>Los puntos no están en ninguna cuadrícula de escáner y se proyectaron tomando como centro %1: %2.</translation></message>
<message><source>The points were projected about %1: %2.</source><translation>Los puntos se proyectaron tomando como centro %1: %2.</translation></message>
<message><source>The cells have the given %1 degrees</source><translation>Las celdas tienen los %1 grados indicados</translation></message>
<message><source>The cells have %1 degrees, from the spacing of the points</source><translation>Las celdas tienen %1 grados, por la separación de los puntos</translation></message>
<message><source>, along lines that were recognised in the cloud.</source><translation>, a lo largo de líneas que se reconocieron en la nube.</translation></message>
<message><source>Edges of a projected cloud differ from those of its scan: a file with the points in the order of the scanner, or with its record, has the grid of the scan.</source><translation>Los bordes de una nube proyectada difieren de los de su escaneo: un archivo con los puntos en el orden del escáner, o con su registro, tiene la cuadrícula del escaneo.</translation></message>
<message><source>projected about %1: %2</source><translation>proyectados tomando como centro %1: %2</translation></message>
<message><source>The axis of the scan lines is %1 (in the numbers of the file) from the sensor position that was known.</source><translation>El eje de las líneas del escaneo está a %1 (en los números del archivo) de la posición conocida del sensor.</translation></message>
<message><source>%n point is a later return of a pulse, as the file says: the first returns make the grid</source><translation>%n punto es un retorno posterior de un pulso, según el archivo: los primeros retornos forman la cuadrícula</translation></message>
<message><source>%n points are later returns of a pulse, as the file says: the first returns make the grid</source><translation>%n puntos son retornos posteriores de un pulso, según el archivo: los primeros retornos forman la cuadrícula</translation></message>
<message><source>, and %1</source><translation>, y %1</translation></message>
<message><source>%n other was attached to its cell</source><translation>%n otro se asignó a su celda</translation></message>
<message><source>%n others were attached to their cells</source><translation>%n otros se asignaron a sus celdas</translation></message>
<message><source>%n other has no cell of its own and was left out</source><translation>%n otro no tiene celda propia y se dejó fuera</translation></message>
<message><source>%n others have no cell of their own and were left out</source><translation>%n otros no tienen celda propia y se dejaron fuera</translation></message>
<message><source>%1 lines, %2 beams and mounting %3 were found from them.</source><translation>%1 líneas, %2 haces y el montaje %3 se encontraron a partir de ellos.</translation></message>
<message><source>--unit does not apply: the file holds ranges that give the unit of its points</source><translation>--unit no se aplica: el archivo contiene distancias que dan la unidad de sus puntos</translation></message>
<message><source>the last scan line is not complete and the last row has no line end: the file was cut off</source><translation>la última línea del escaneo está incompleta y la última fila no tiene fin de línea: el archivo se cortó</translation></message>
<message><source>the file is in another frame than the scanner's, and %1 of its points share their line and beam with another</source><translation>el archivo está en otro marco que el del escáner, y %1 de sus puntos comparten línea y haz con otro</translation></message>
<message><source>The grid has as many lines and beams as the points name, %1 x %2: a line or beam behind the last point is not in the file.</source><translation>La cuadrícula tiene tantas líneas y haces como nombran los puntos, %1 x %2: una línea o un haz detrás del último punto no está en el archivo.</translation></message>
<message><source>the points have a grid</source><translation>los puntos tienen una cuadrícula</translation></message>
<message><source>The list holds returns only: a line or beam at the border without any return is not in it.</source><translation>La lista solo contiene retornos: una línea o un haz del borde sin ningún retorno no está en ella.</translation></message>
<message><source>points are one and the same,%1</source><translation>puntos son uno y el mismo,%1</translation></message>
<message><source>points are %1 (in the numbers of the file) from the sensor</source><translation>puntos están a %1 (en los números del archivo) del sensor</translation></message>
<message><source>its numbers are rounded to %1, and its points are within %2 of each other</source><translation>sus números están redondeados a %1, y sus puntos distan entre sí %2 como máximo</translation></message>
<message><source>write the coordinates again with all their decimals</source><translation>escriba de nuevo las coordenadas con todos sus decimales</translation></message>
<message><source>its numbers were rounded to %1 digits, so that those near %2 step by %3: the digits that place the points are lost</source><translation>sus números se redondearon a %1 cifras, así que los cercanos a %2 van en pasos de %3: las cifras que ubican los puntos se han perdido</translation></message>
<message><source>write the coordinates again with all their decimals, as numbers and not in the form 1.23E+06</source><translation>escriba de nuevo las coordenadas con todos sus decimales, como números y no en la forma 1.23E+06</translation></message>
<message><source>%1 numbers per line without names are a table of ranges only with its angles; as points, %2</source><translation>%1 números por línea sin nombres son una tabla de distancias solo con sus ángulos; como puntos, %2</translation></message>
<message><source>give --beam-start --beam-step --line-start --line-step --axis, or name the columns x, y and z</source><translation>indique --beam-start --beam-step --line-start --line-step --axis, o nombre las columnas x, y y z</translation></message>
<message><source>%1 of the %2 of the file have no cell of their own.</source><translation>%1 de los %2 del archivo no tienen celda propia.</translation></message>
<message><source>the file holds 0 points with a return, out of %1</source><translation>el archivo contiene 0 puntos con retorno, de %1</translation></message>
<message><source>choose another file, or copy it again</source><translation>elija otro archivo, o cópielo de nuevo</translation></message>
<message><source>Numbers up to %1 in this file have a resolution of about %2: it was written with 4-byte floats.</source><translation>En este archivo, los números hasta %1 tienen una resolución de unos %2: se escribió con flotantes de 4 bytes.</translation></message>
<message><source>%n point with infinite or absurdly large coordinates was taken as no return.</source><translation>%n punto con coordenadas infinitas o absurdamente grandes se tomó como sin retorno.</translation></message>
<message><source>%n points with infinite or absurdly large coordinates were taken as no return.</source><translation>%n puntos con coordenadas infinitas o absurdamente grandes se tomaron como sin retorno.</translation></message>
<message><source>the pose could not be removed (%1)</source><translation>no se pudo quitar la pose (%1)</translation></message>
<message><source>remove the file by hand</source><translation>quite el archivo a mano</translation></message>
<message><source>the file name has no extension that names a format</source><translation>el nombre del archivo no tiene una extensión que nombre un formato</translation></message>
<message><source>"%1" is not a format that can be written</source><translation>«%1» no es un formato que se pueda escribir</translation></message>
<message><source>use %1</source><translation>use %1</translation></message>
<message><source>the edge mask has %1 x %2 cells and the scan %3 x %4</source><translation>la máscara de bordes tiene %1 x %2 celdas y el escaneo %3 x %4</translation></message>
<message><source>detect the edges of this scan again</source><translation>detecte de nuevo los bordes de este escaneo</translation></message>
<message><source>the scan has no pose, so its place in the mine grid is not known</source><translation>el escaneo no tiene pose, así que no se conoce su lugar en la cuadrícula de la mina</translation></message>
<message><source>give a pose and the robot's calibration, or save in the scanner's frame</source><translation>indique una pose y la calibración del robot, o guarde en el sistema del escáner</translation></message>
<message><source>the scan has no cells</source><translation>el escaneo no tiene celdas</translation></message>
<message><source>a raw grid or a recording holds ranges and no coordinates</source><translation>una cuadrícula sin procesar o una grabación contiene distancias y no coordenadas</translation></message>
<message><source>save it without a frame, or as %1</source><translation>guárdelo sin marco, o como %1</translation></message>
<message><source>%n point behind the nearest of its cell is not in this file: --include-attached saves all points.</source><translation>%n punto detrás del más cercano de su celda no está en este archivo: --include-attached guarda todos los puntos.</translation></message>
<message><source>%n points behind the nearest of their cell are not in this file: --include-attached saves all points.</source><translation>%n puntos detrás del más cercano de su celda no están en este archivo: --include-attached guarda todos los puntos.</translation></message>
<message><source>The file holds points and no grid: %1 cells without a range are not in it.</source><translation>El archivo contiene puntos y ninguna cuadrícula: %1 celdas sin distancia no están en él.</translation></message>
<message><source>This file knows only points and no returns: %1 cells of other states become no returns.</source><translation>Este archivo solo conoce puntos y celdas sin retorno: %1 celdas de otros estados pasan a ser sin retorno.</translation></message>
<message><source>The file holds numbers only: keep %1.provenance.json next to it, which holds the grid, or write it with --comments.</source><translation>El archivo contiene solo números: guarde junto a él %1.provenance.json, que contiene la cuadrícula, o escríbalo con --comments.</translation></message>
<message><source>The file does not hold the intensities: .pcd, .ply, .las, .ptx and .csv do.</source><translation>El archivo no contiene las intensidades: .pcd, .ply, .las, .ptx y .csv sí.</translation></message>
<message><source>The file rounds the points to whole steps of %1 mm.</source><translation>El archivo redondea los puntos a pasos enteros de %1 mm.</translation></message>
<message><source>The file is in the scanner's frame and does not hold the scan's place in the mine: --frame mine gives mine coordinates.</source><translation>El archivo está en el marco del escáner y no contiene el lugar del escaneo en la mina: --frame mine da coordenadas de mina.</translation></message>
<message><source>The file has room for one place of the scanner, and this scanner moved by up to %1 mm: without %2.provenance.json its ranges are as much off; its points are exact.</source><translation>El archivo tiene sitio para un lugar del escáner, y este escáner se movió hasta %1 mm: sin %2.provenance.json sus distancias difieren en lo mismo; sus puntos son exactos.</translation></message>
<message><source>This file is an export of edge points, not a scan: all other cells count as no return. Open the scan to find edges.</source><translation>Este archivo es una exportación de puntos de arista, no un escaneo: todas las demás celdas cuentan como sin retorno. Abra el escaneo para buscar aristas.</translation></message>
<message><source>was written for another one</source><translation>se escribió para otro</translation></message>
<message><source>describes no grid</source><translation>no describe ninguna cuadrícula</translation></message>
<message><source>does not list the cells of the points</source><translation>no enumera las celdas de los puntos</translation></message>
<message><source>has a grid for which there is not enough memory</source><translation>tiene una cuadrícula para la que no hay bastante memoria</translation></message>
<message><source>describes a grid without angles and without a sensor</source><translation>describe una cuadrícula sin ángulos y sin sensor</translation></message>
<message><source>lists other cells than the file has points</source><translation>enumera otras celdas que los puntos que tiene el archivo</translation></message>
<message><source>does not hold the place of the scan in the mine</source><translation>no contiene el lugar del escaneo en la mina</translation></message>
<message><source>cannot be read (%1)</source><translation>no se puede leer (%1)</translation></message>
<message><source>The record next to the file %1, so the grid in it was not used.</source><translation>El registro junto al archivo no sirve (%1), así que no se usó su cuadrícula.</translation></message>
<message><source>lists a cell twice</source><translation>enumera una celda dos veces</translation></message>
<message><source>The file puts the sensor %1 away from its points, which are all within %2 of each other (in its own numbers): no scanner measures so, and the place was not used.</source><translation>El archivo pone el sensor a %1 de sus puntos, que están todos a menos de %2 entre sí (en sus propios números): ningún escáner mide así, y ese lugar no se usó.</translation></message>
<message><source>the %1 points of its grid lie in one direction from the origin, within %2 degrees and up to %3 away: the scanner stood elsewhere</source><translation>los %1 puntos de su cuadrícula están en una sola dirección desde el origen, dentro de %2 grados y hasta %3: el escáner estaba en otro lugar</translation></message>
<message><source>Unit taken as metres, in which the numbers fit the sensor position given.</source><translation>Se tomó el metro como unidad, con el que los números concuerdan con la posición del sensor indicada.</translation></message>
<message><source>Unit taken as millimetres, in which the numbers fit the sensor position given.</source><translation>Se tomó el milímetro como unidad, con el que los números concuerdan con la posición del sensor indicada.</translation></message>
<message><source>numbers up to %1 in this file have a resolution of about %2</source><translation>los números hasta %1 de este archivo tienen una resolución de unos %2</translation></message>
<message><source>The text has two bytes per character (UTF-16) and was read as such.</source><translation>El texto tiene dos bytes por carácter (UTF-16) y se leyó así.</translation></message>
<message><source>The text has four bytes per character (UTF-32) and was read as such.</source><translation>El texto tiene cuatro bytes por carácter (UTF-32) y se leyó así.</translation></message>
<message><source>%n byte of zero (NUL) follows the last row, as a power cut leaves them: rows that were not written are missing.</source><translation>%n byte cero (NUL) sigue a la última fila, como los deja un corte de luz: faltan las filas que no se escribieron.</translation></message>
<message><source>%n bytes of zero (NUL) follow the last row, as a power cut leaves them: rows that were not written are missing.</source><translation>%n bytes cero (NUL) siguen a la última fila, como los deja un corte de luz: faltan las filas que no se escribieron.</translation></message>
<message><source>the file holds only zeros (NUL), as a power cut leaves them</source><translation>el archivo solo contiene ceros (NUL), como los deja un corte de corriente</translation></message>
<message><source>copy it again from the scanner</source><translation>cópielo de nuevo desde el escáner</translation></message>
<message><source>The matrix in the file is not a rotation and shift, so the scan stays in the scanner's frame.</source><translation>La matriz del archivo no es una rotación y traslación, así que el escaneo queda en el sistema del escáner.</translation></message>
<message><source>The %1 file puts the scanner at %2, %3, %4 m, which is not a place on earth, so the scan stays in the scanner's frame.</source><translation>El archivo %1 pone el escáner en %2, %3, %4 m, que no es un lugar de la tierra, así que el escaneo queda en el sistema del escáner.</translation></message>
<message><source>as the %1 file has it</source><translation>como lo tiene el archivo %1</translation></message>
<message><source>the header of %1</source><translation>el encabezado de %1</translation></message>
<message><source>The place is the one written in the %1 file: whether that is the mine grid, who registered it knows.</source><translation>El lugar es el escrito en el archivo %1: si eso es la cuadrícula de la mina, lo sabe quien lo registró.</translation></message>
<message><source>The points are in another frame than the scanner's. Their scan lines turn about one axis, at %1, %2, %3 m, and the mirror is %4 off the axis</source><translation>Los puntos están en otro marco que el del escáner. Sus líneas de escaneo giran alrededor de un eje, en %1, %2, %3 m, y el espejo está a %4 del eje</translation></message>
<message><source>; the grid has the scale %1</source><translation>; la cuadrícula tiene la escala %1</translation></message>
<message><source>%1. The points fit lines and beams within %2.</source><translation>%1. Los puntos encajan en líneas y haces con un error de %2.</translation></message>
<message><source>That is more than the rounding of the numbers explains, %1 mm: ranges may be off, and edges may differ from those of the scan. The record of the file, or the scan as it was measured, has them exactly.</source><translation>Es más de lo que explica el redondeo de los números, %1 mm: las distancias pueden estar desviadas y los bordes diferir de los del escaneo. El registro del archivo, o el escaneo tal como se midió, los tiene exactos.</translation></message>
<message><source>the scan lines of the points</source><translation>las líneas de escaneo de los puntos</translation></message>
<message><source>The place was found from the scan lines of the points: whether their frame is the mine grid, the file does not say.</source><translation>El lugar se encontró a partir de las líneas de escaneo de los puntos: el archivo no dice si su marco es la cuadrícula de la mina.</translation></message>
<message><source>copy the capture again</source><translation>copie de nuevo la captura</translation></message>
<message><source>the capture ends within its header</source><translation>la captura termina dentro de su encabezado</translation></message>
<message><source>is too short for a packet</source><translation>es demasiado corto para un paquete</translation></message>
<message><source>names an interface that the capture does not describe</source><translation>nombra una interfaz que la captura no describe</translation></message>
<message><source>promises more bytes of a packet than it has</source><translation>anuncia más bytes de un paquete de los que tiene</translation></message>
<message><source>a block of this PCAPNG capture %1</source><translation>un bloque de esta captura PCAPNG %1</translation></message>
<message><source>says that it has %1 bytes</source><translation>dice que tiene %1 bytes</translation></message>
<message><source>is too short for an interface</source><translation>es demasiado corto para una interfaz</translation></message>
<message><source>this is not a capture of network packets</source><translation>no es una captura de paquetes de red</translation></message>
<message><source>The capture was cut off: everything up to the cut is here.</source><translation>La captura se cortó: todo hasta el corte está aquí.</translation></message>
<message><source>%n packet has a time before 1970 or after 2262 and count as of 1970.</source><translation>%n paquete tiene una hora anterior a 1970 o posterior a 2262 y cuenta como de 1970.</translation></message>
<message><source>%n packets have a time before 1970 or after 2262 and count as of 1970.</source><translation>%n paquetes tienen una hora anterior a 1970 o posterior a 2262 y cuentan como de 1970.</translation></message>
<message><source>%n byte that the scanner sent is missing in the capture, in %1: the telegrams there are lost.</source><translation>%n byte que envió el escáner falta en la captura (%1): los telegramas de ahí se han perdido.</translation></message>
<message><source>%n bytes that the scanner sent are missing in the capture, in %1: the telegrams there are lost.</source><translation>%n bytes que envió el escáner faltan en la captura (%1): los telegramas de ahí se han perdido.</translation></message>
<message><source>%n place</source><translation>%n lugar</translation></message>
<message><source>%n places</source><translation>%n lugares</translation></message>
<message><source>%n byte that the scanner sent belongs to no whole telegram.</source><translation>%n byte que envió el escáner no pertenece a ningún telegrama entero.</translation></message>
<message><source>%n bytes that the scanner sent belong to no whole telegram.</source><translation>%n bytes que envió el escáner no pertenecen a ningún telegrama entero.</translation></message>
<message><source>%n packet came out of order and %1 brought bytes again; they were put in order.</source><translation>%n paquete llegó desordenado y %1 trajeron bytes de nuevo; se pusieron en orden.</translation></message>
<message><source>%n packets came out of order and %1 brought bytes again; they were put in order.</source><translation>%n paquetes llegaron desordenados y %1 trajeron bytes de nuevo; se pusieron en orden.</translation></message>
<message><source>%n fragment of IP packets were not put together.</source><translation>%n fragmento de paquetes IP no se unió.</translation></message>
<message><source>%n fragments of IP packets were not put together.</source><translation>%n fragmentos de paquetes IP no se unieron.</translation></message>
<message><source>putting packets together</source><translation>unión de los paquetes</translation></message>
<message><source>this capture holds no scan telegram of a SICK scanner, and %1</source><translation>esta captura no contiene ningún telegrama de escaneo de un escáner SICK, y %1</translation></message>
<message><source>this capture holds %1, %2 of them TCP, and no scan telegram of a SICK scanner and no packet of a VLP-16 or an Ouster</source><translation>esta captura contiene %1, %2 de ellos TCP, y ningún telegrama de escaneo de un escáner SICK ni ningún paquete de un VLP-16 o un Ouster</translation></message>
<message><source>%n packet</source><translation>%n paquete</translation></message>
<message><source>%n packets</source><translation>%n paquetes</translation></message>
<message><source>capture the connection to the scanner's port (2111 or 2112) while it scans</source><translation>capture la conexión al puerto del escáner (2111 o 2112) mientras escanea</translation></message>
<message><source>%n other sender has some too</source><translation>%n otro emisor también tiene</translation></message>
<message><source>%n other senders have some too</source><translation>%n otros emisores también tienen</translation></message>
<message><source>The capture holds %1 streams; that of %2 with %3 was opened, and %4.</source><translation>La captura contiene %1 flujos; se abrió el de %2 con %3, y %4.</translation></message>
<message><source>The capture holds %1 streams; that of %2 with %3 was opened.</source><translation>La captura contiene %1 flujos; se abrió el de %2 con %3.</translation></message>
<message><source>%n scan telegram</source><translation>%n telegrama de escaneo</translation></message>
<message><source>%n scan telegrams</source><translation>%n telegramas de escaneo</translation></message>
<message><source>finding telegrams</source><translation>búsqueda de telegramas</translation></message>
<message><source>these are %1 of a SICK device and none is a scan</source><translation>estos son %1 de un aparato SICK y ninguno es un escaneo</translation></message>
<message><source>%n telegram</source><translation>%n telegrama</translation></message>
<message><source>%n telegrams</source><translation>%n telegramas</translation></message>
<message><source>capture while the scanner sends scans (sEN LMDscandata 1)</source><translation>capture mientras el escáner envía escaneos (sEN LMDscandata 1)</translation></message>
<message><source>CoLa stream</source><translation>Flujo CoLa</translation></message>
<message><source>%n byte of the stream belongs to no whole telegram.</source><translation>%n byte del flujo no pertenece a ningún telegrama entero.</translation></message>
<message><source>%n bytes of the stream belong to no whole telegram.</source><translation>%n bytes del flujo no pertenecen a ningún telegrama entero.</translation></message>
<message><source>radians</source><translation>radianes</translation></message>
<message><source>hundredths of a degree</source><translation>centésimas de grado</translation></message>
<message><source>thousandths of a degree</source><translation>milésimas de grado</translation></message>
<message><source>milliradians</source><translation>milirradianes</translation></message>
<message><source>%1 (azimuth) and %2 (elevation)</source><translation>%1 (acimut) y %2 (elevación)</translation></message>
<message><source>angles in %1, azimuths %2</source><translation>ángulos en %1, acimuts %2</translation></message>
<message><source>angles taken as %1, azimuths %2</source><translation>ángulos tomados como %1, acimuts %2</translation></message>
<message><source>clockwise from y</source><translation>en sentido horario desde y</translation></message>
<message><source>counter-clockwise from x</source><translation>en sentido antihorario desde x</translation></message>
<message><source>Points were computed from the columns of angles and ranges, with %1 and heights from the zenith.</source><translation>Los puntos se calcularon a partir de las columnas de ángulos y distancias, con %1 y alturas desde el cenit.</translation></message>
<message><source>Points were computed from the columns of angles and ranges, with %1.</source><translation>Los puntos se calcularon a partir de las columnas de ángulos y distancias, con %1.</translation></message>
<message><source>degrees of latitude and longitude</source><translation>grados de latitud y longitud</translation></message>
<message><source>angles and no ranges</source><translation>ángulos y no distancias</translation></message>
<message><source>angles and ranges</source><translation>ángulos y distancias</translation></message>
<message><source>two coordinates of a point and not the third</source><translation>dos coordenadas de un punto y no la tercera</translation></message>
<message><source>compare it with docs/reference/formats.md, "Raw grid"</source><translation>compárelo con docs/reference/formats.md, "Raw grid"</translation></message>
<message><source>this is a drawing of rocks (GeoJSON) and not a scan</source><translation>esto es un dibujo de rocas (GeoJSON) y no un escaneo</translation></message>
<message><source>open its scan</source><translation>abra su escaneo</translation></message>
<message><source>this is a preset and not a scan</source><translation>esto es un preajuste y no un escaneo</translation></message>
<message><source>choose it in the panel Edges, or give it with --preset</source><translation>elíjalo en el panel Bordes, o indíquelo con --preset</translation></message>
<message><source>this is a report of detect and not a scan</source><translation>esto es un informe de detect y no un escaneo</translation></message>
<message><source>this is a report of rocks and not a scan</source><translation>esto es un informe de rocks y no un escaneo</translation></message>
<message><source>this is a pose and not a scan</source><translation>esto es una pose y no un escaneo</translation></message>
<message><source>open its scan and give it with --pose</source><translation>abra su escaneo e indíquelo con --pose</translation></message>
<message><source>this is a calibration and not a scan</source><translation>esto es una calibración y no un escaneo</translation></message>
<message><source>open its scan and give it with --calibration</source><translation>abra su escaneo e indíquelo con --calibration</translation></message>
<message><source>this is a file of targets and not a scan</source><translation>esto es un archivo de objetivos y no un escaneo</translation></message>
<message><source>this is edits of rocks and not a scan</source><translation>esto es una edición de rocas y no un escaneo</translation></message>
<message><source>open its scan, or give it with --edits</source><translation>abra su escaneo, o indíquelas con --edits</translation></message>
<message><source>this is a record of an export and not a scan</source><translation>esto es un registro de una exportación y no un escaneo</translation></message>
<message><source>open its scan, or check it with edgescan-cli verify</source><translation>abra su escaneo, o compruébelo con edgescan-cli verify</translation></message>
<message><source>must hold counts</source><translation>debe contener cuentas</translation></message>
<message><source>holds %1, and there are %2</source><translation>contiene %1, y hay %2</translation></message>
<message><source>needs start and step</source><translation>necesita start y step</translation></message>
<message><source>holds %1, %2 are needed</source><translation>contiene %1, se necesitan %2</translation></message>
<message><source>%n angle</source><translation>%n ángulo</translation></message>
<message><source>%n angles</source><translation>%n ángulos</translation></message>
<message><source>must be 1 or -1</source><translation>debe ser 1 o -1</translation></message>
<message><source>must be a list</source><translation>debe ser una lista</translation></message>
<message><source>must hold ["state", first cell, cells]</source><translation>debe contener ["state", primera celda, celdas]</translation></message>
<message><source>leaves the grid</source><translation>se sale de la cuadrícula</translation></message>
<message><source>names cell %1 twice</source><translation>nombra dos veces la celda %1</translation></message>
<message><source>must name a file in the same folder</source><translation>debe nombrar un archivo de la misma carpeta</translation></message>
<message><source>save the scan again, or remove "acquisition"</source><translation>guarde de nuevo el escaneo, o quite "acquisition"</translation></message>
<message><source>"acquisition" must be an object {...}</source><translation>"acquisition" debe ser un objeto {...}</translation></message>
<message><source>must be greater than 0</source><translation>debe ser mayor que 0</translation></message>
<message><source>the header promises %1 of %2 bytes and the file holds %3 bytes of them, which is more</source><translation>el encabezado anuncia %1 de %2 bytes y el archivo contiene %3 bytes de ellos, que es más</translation></message>
<message><source>The last %1 of %2 points hold zeros in all bytes, as a power cut leaves them where a file was not written to its end: they count as no return.</source><translation>Los últimos %1 de %2 puntos contienen ceros en todos los bytes, como los deja un corte de corriente cuando un archivo no se escribió hasta el final: cuentan como sin retorno.</translation></message>
<message><source>holds %1 where the header promises %2</source><translation>contiene %1 donde el encabezado anuncia %2</translation></message>
<message><source>the header promises %1, and more text follows them here</source><translation>el encabezado anuncia %1, y aquí sigue más texto</translation></message>
<message><source>, which repeats exactly and is far apart from the rest, as nothing measured is: taken as no return</source><translation>, que se repite exactamente y está lejos del resto, como nada medido lo está: se tomó como sin retorno</translation></message>
<message><source> (--keep-repeated takes it as measured).</source><translation> (--keep-repeated lo toma como medido).</translation></message>
<message><source>holds decimal commas in quotes between commas</source><translation>contiene comas decimales entre comillas y entre comas</translation></message>
<message><source>save the table with semicolons, or with decimal points</source><translation>guarde la tabla con punto y coma, o con puntos decimales</translation></message>
<message><source>holds decimal commas between commas</source><translation>contiene comas decimales entre comas</translation></message>
<message><source>The last row has no line end: the file may have been cut off there; compare it with the original.</source><translation>La última fila no tiene fin de línea: el archivo puede estar cortado ahí; compárelo con el original.</translation></message>
<message><source>save the file with plain numbers, without separators of thousands</source><translation>guarde el archivo con números simples, sin separadores de miles</translation></message>
<message><source>holds %1 in a column whose numbers have three digits behind their mark or no mark at all, so that it may separate decimals or thousands</source><translation>contiene %1 en una columna cuyos números tienen tres cifras detrás de su signo o ningún signo, de modo que puede separar decimales o millares</translation></message>
<message><source>save the file with the same count of decimals in each number, or without separators of thousands</source><translation>guarde el archivo con el mismo número de decimales en cada número, o sin separadores de millares</translation></message>
<message><source>holds %1, a number whose thousands are set apart</source><translation>contiene %1, un número con los millares separados</translation></message>
<message><source>holds bytes of zero, as a file does that was not written to its end</source><translation>contiene bytes cero, como un archivo que no se escribió hasta el final</translation></message>
<message><source>copy the file or export it again</source><translation>copie o exporte de nuevo el archivo</translation></message>
<message><source>%1 has a decimal comma</source><translation>%1 tiene una coma decimal</translation></message>
<message><source>save the file with decimal points</source><translation>guarde el archivo con puntos decimales</translation></message>
<message><source>%1 is more than one number between two separators</source><translation>%1 es más de un número entre dos separadores</translation></message>
<message><source>correct the line or export the file again</source><translation>corrija la línea o exporte de nuevo el archivo</translation></message>
<message><source>%1 is not a number</source><translation>%1 no es un número</translation></message>
<message><source>%1 is below x, y or z and is not a number</source><translation>%1 está debajo de x, y o z y no es un número</translation></message>
<message><source>save the file with plain numbers in these columns, without units or marks</source><translation>guarde el archivo con números simples en estas columnas, sin unidades ni signos</translation></message>
<message><source>there are words among the numbers of its rows, and no heading names x, y and z</source><translation>hay palabras entre los números de sus filas, y ningún encabezado nombra x, y y z</translation></message>
<message><source>write a first row with the names of the columns, such as id,x,y,z,code</source><translation>escriba una primera fila con los nombres de las columnas, como id,x,y,z,code</translation></message>
<message><source>its numbers are separated by "%1", which separates none here</source><translation>sus números están separados por «%1», que aquí no separa ninguno</translation></message>
<message><source>save the file with commas, semicolons, tabs or blanks between its numbers</source><translation>guarde el archivo con comas, puntos y comas, tabuladores o espacios entre sus números</translation></message>
<message><source>this is text without a row of numbers, so no scan</source><translation>es texto sin una fila de números, así que no es un escaneo</translation></message>
<message><source>choose a scan: E57, LAS, PTX, PCD, PLY, OBJ, CSV, XYZ, .3d, .str, .npy, a raw grid (.json), a range picture (.png, .tif), a recording (.mcap), a ROS bag or a network capture (.pcap)</source><translation>elija un escaneo: E57, LAS, PTX, PCD, PLY, OBJ, CSV, XYZ, .3d, .str, .npy, una cuadrícula sin procesar (.json), una imagen de distancias (.png, .tif), una grabación (.mcap), un bag de ROS o una captura de red (.pcap)</translation></message>
<message><source>The recording describes another grid than its telegrams make: the telegrams count.</source><translation>La grabación describe otra cuadrícula que la de sus telegramas: cuentan los telegramas.</translation></message>
<message><source>The recording was cut off: everything up to the cut is here.</source><translation>La grabación se cortó: todo hasta el corte está aquí.</translation></message>
<message><source>%1 times in the recording are after %2 and were read as this time.</source><translation>%1 tiempos de la grabación son posteriores a %2 y se leyeron como ese tiempo.</translation></message>
<message><source>this MCAP file holds nothing that a laser scanner sent</source><translation>este archivo MCAP no contiene nada que enviara un escáner láser</translation></message>
<message><source>choose a recording of a sweep</source><translation>elija la grabación de un barrido</translation></message>
<message><source>nothing that a laser scanner sent can be read in this MCAP file%1</source><translation>en este archivo MCAP no se puede leer nada que haya enviado un escáner láser%1</translation></message>
<message><source>, and %1 more</source><translation>, y %1 más</translation></message>
<message><source>the recording's "%1" is "%2", which cannot be used.</source><translation>«%1» de la grabación es «%2», que no se puede usar.</translation></message>
<message><source>%n reading of inclinometer or TALIN cannot be used.</source><translation>%n lectura del inclinómetro o de TALIN no se puede usar.</translation></message>
<message><source>%n readings of inclinometer or TALIN cannot be used.</source><translation>%n lecturas del inclinómetro o de TALIN no se pueden usar.</translation></message>
<message><source>the recording's own readings</source><translation>las lecturas propias de la grabación</translation></message>
<message><source>The recording holds readings of TALIN and does not say where the boom pointed (boom_azimuth_deg).</source><translation>La grabación contiene lecturas de TALIN y no dice adónde apuntaba la pluma (boom_azimuth_deg).</translation></message>
<message><source>the recording</source><translation>la grabación</translation></message>
<message><source> with %1</source><translation> con %1</translation></message>
<message><source>a pose needs the robot's calibration, and the recording holds none</source><translation>una pose necesita la calibración del robot, y la grabación no contiene ninguna</translation></message>
<message><source>give --calibration ROBOT.json too</source><translation>indique también --calibration ROBOT.json</translation></message>
<message><source>a calibration needs a pose, and the recording holds none that can be used</source><translation>una calibración necesita una pose, y la grabación no contiene ninguna utilizable</translation></message>
<message><source>The recording holds poses and not how the robot is built: --calibration ROBOT.json places the scan.</source><translation>La grabación contiene poses pero no cómo está construido el robot: --calibration ROBOT.json ubica el escaneo.</translation></message>
<message><source>The pose in %1 replaces those of the recording.</source><translation>La pose de %1 reemplaza las de la grabación.</translation></message>
<message><source>The recording's pose cannot be used: %1.</source><translation>La pose de la grabación no se puede usar: %1.</translation></message>
<message><source>--unit does not apply: the telegrams of a recording say their unit themselves</source><translation>--unit no se aplica: los telegramas de una grabación dicen ellos mismos su unidad</translation></message>
<message><source>one sweep</source><translation>un barrido</translation></message>
<message><source>%1 sweeps</source><translation>%1 barridos</translation></message>
<message><source>the %1 scan telegrams in this recording hold no line of ranges</source><translation>los %1 telegramas de escaneo de esta grabación no contienen ninguna línea de distancias</translation></message>
<message><source>no scan telegram in this recording can be decoded%1</source><translation>ningún telegrama de escaneo de esta grabación se puede decodificar%1</translation></message>
<message><source>this recording holds no scan telegram%1</source><translation>esta grabación no contiene ningún telegrama de escaneo%1</translation></message>
<message><source>choose another recording</source><translation>elija otra grabación</translation></message>
<message><source>The recording holds %1 sweeps; sweep %2 was opened; no other has more lines.</source><translation>La grabación contiene %1 barridos; se abrió el barrido %2; ningún otro tiene más líneas.</translation></message>
<message><source>%1 scan telegrams could not be decoded: %2.</source><translation>%1 telegramas de escaneo no se pudieron decodificar: %2.</translation></message>
<message><source>%n message holds bytes that are not a whole telegram: what was in it is lost.</source><translation>%n mensaje contiene bytes que no son un telegrama entero: su contenido se ha perdido.</translation></message>
<message><source>%n messages hold bytes that are not a whole telegram: what was in them is lost.</source><translation>%n mensajes contienen bytes que no son un telegrama entero: su contenido se ha perdido.</translation></message>
<message><source>INCOMPLETE: %1 lines are there, how many there were is not known.</source><translation>INCOMPLETO: hay %1 líneas, no se sabe cuántas eran.</translation></message>
<message><source>a recording holds whole counts of its unit up to 65535, and the range at line %1, beam %2 is none</source><translation>una grabación contiene cuentas enteras de su unidad hasta 65535, y la distancia en la línea %1, haz %2 no lo es</translation></message>
<message><source>a recording needs beam and line angles and this cloud has none</source><translation>una grabación necesita ángulos de haces y de líneas y esta nube no los tiene</translation></message>
<message><source>a recording holds at most %1 lines of %2 beams</source><translation>una grabación contiene como mucho %1 líneas de %2 haces</translation></message>
<message><source>telegrams cannot describe this scan</source><translation>los telegramas no pueden describir este escaneo</translation></message>
<message><source>the disk is %1 s behind (%2 MB)</source><translation>el disco lleva %1 s de retraso (%2 MB)</translation></message>
<message><source>the disk is slower than the scanner, telegrams are missing in the recording</source><translation>el disco es más lento que el escáner, faltan telegramas en la grabación</translation></message>
<message><source>record on another disk</source><translation>grabe en otro disco</translation></message>
<message><source>the disk did not take the end of the recording, what it has is cut off</source><translation>el disco no aceptó el final de la grabación, lo que tiene está cortado</translation></message>
<message><source>check the disk; the file opens with what was written</source><translation>compruebe el disco; el archivo se abre con lo que se escribió</translation></message>
<message><source>The bag is cut off or damaged at byte %1: the last %2.</source><translation>El bag está cortado o dañado en el byte %1: los últimos %2.</translation></message>
<message><source>%n byte was not read</source><translation>%n byte no se leyó</translation></message>
<message><source>%n bytes were not read</source><translation>%n bytes no se leyeron</translation></message>
<message><source>%n chunk is damaged and was left out (%1).</source><translation>%n bloque está dañado y se dejó fuera (%1).</translation></message>
<message><source>%n chunks are damaged and were left out (%1).</source><translation>%n bloques están dañados y se dejaron fuera (%1).</translation></message>
<message><source>%n message belongs to no topic of the bag and was left out.</source><translation>%n mensaje no pertenece a ningún topic del bag y se dejó fuera.</translation></message>
<message><source>%n messages belong to no topic of the bag and were left out.</source><translation>%n mensajes no pertenecen a ningún topic del bag y se dejaron fuera.</translation></message>
<message><source>its records do not end with it</source><translation>sus registros no terminan con él</translation></message>
<message><source>it is a ROS bag of another version than 2.0</source><translation>es un bag de ROS de una versión distinta de 2.0</translation></message>
<message><source>convert it with "rosbag migrate"</source><translation>conviértalo con «rosbag migrate»</translation></message>
<message><source>it promises to unpack to more than a bag of this size holds</source><translation>anuncia que se descomprime en más de lo que contiene un bag de este tamaño</translation></message>
<message><source>The bag was cut off: everything up to the cut is here.</source><translation>El bag se cortó: todo hasta el corte está aquí.</translation></message>
<message><source>%n message is compressed and damaged and was left out.</source><translation>%n mensaje está comprimido y dañado y se dejó fuera.</translation></message>
<message><source>%n messages are compressed and damaged and were left out.</source><translation>%n mensajes están comprimidos y dañados y se dejaron fuera.</translation></message>
<message><source>this SQLite database is damaged: its tables give more than the file can hold</source><translation>esta base de datos SQLite está dañada: sus tablas dan más de lo que el archivo puede contener</translation></message>
<message><source>this SQLite database is not a ROS bag: "%1" is not a plain table</source><translation>esta base de datos SQLite no es un bag de ROS: «%1» no es una tabla simple</translation></message>
<message><source>this SQLite database is cut off or damaged: its tables cannot be read</source><translation>esta base SQLite está cortada o dañada: no se pueden leer sus tablas</translation></message>
<message><source>this SQLite database is not a ROS bag: it has no table of topics</source><translation>esta base SQLite no es un bag de ROS: no tiene tabla de topics</translation></message>
<message><source>The database is cut off or damaged (%1): messages behind the first %2 were not read.</source><translation>La base de datos está cortada o dañada (%1): los mensajes tras los primeros %2 no se leyeron.</translation></message>
<message><source>this SQLite database cannot be opened</source><translation>no se puede abrir esta base SQLite</translation></message>
<message><source>%n byte behind the end of the database was not read.</source><translation>%n byte detrás del final de la base de datos no se leyó.</translation></message>
<message><source>%n bytes behind the end of the database were not read.</source><translation>%n bytes detrás del final de la base de datos no se leyeron.</translation></message>
<message><source>this is a ROS 2 bag in SQLite, and this program was built without SQLite</source><translation>esto es un bag de ROS 2 en SQLite, y este programa se compiló sin SQLite</translation></message>
<message><source>convert it with "ros2 bag convert" to MCAP, or install libsqlite3-dev and build again</source><translation>conviértalo con "ros2 bag convert" a MCAP, o instale libsqlite3-dev y compile de nuevo</translation></message>
<message><source>The log %1 of the recorder could not be read: its messages are not in the scan.</source><translation>El registro %1 del grabador no se pudo leer: sus mensajes no están en el escaneo.</translation></message>
<message><source>The recorder was not ended: its newest messages were read from %1.</source><translation>El grabador no se terminó: sus mensajes más nuevos se leyeron de %1.</translation></message>
<message><source>The recorder was ended within a change: the database was read as it was before it, by %1.</source><translation>El grabador terminó en medio de un cambio: la base de datos se leyó como estaba antes, por medio de %1.</translation></message>
<message><source>The log %1 of the recorder ends with %2 pages that are not whole: their messages are not in the scan.</source><translation>El registro %1 del grabador termina con %2 páginas incompletas: sus mensajes no están en el escaneo.</translation></message>
<message><source>The log %1 belongs to several databases and was not read: the last change may be in part.</source><translation>El registro %1 pertenece a varias bases de datos y no se leyó: el último cambio puede estar a medias.</translation></message>
<message><source>the log %1 cannot be read: the folder for temporary files is missing</source><translation>no se puede leer el registro %1: falta la carpeta de archivos temporales</translation></message>
<message><source>set TMPDIR to a folder</source><translation>ponga una carpeta en TMPDIR</translation></message>
<message><source>it is longer than a megabyte</source><translation>ocupa más de un megabyte</translation></message>
<message><source>a line of "=" is not followed by "MSG:"</source><translation>a una línea de "=" no le sigue "MSG:"</translation></message>
<message><source>it names more than 1000 types</source><translation>nombra más de 1000 tipos</translation></message>
<message><source>the type %1 is not defined</source><translation>el tipo %1 no está definido</translation></message>
<message><source>a type contains itself, or types are nested more than 32 deep</source><translation>un tipo se contiene a sí mismo, o hay tipos anidados a más de 32 niveles</translation></message>
<message><source>the definition of the message type %1 cannot be read: %2</source><translation>no se puede leer la definición del tipo de mensaje %1: %2</translation></message>
<message><source>record the bag again, or convert it with the program that wrote it</source><translation>grabe de nuevo el bag, o conviértalo con el programa que lo escribió</translation></message>
<message><source>a line has a type and no name: "%1"</source><translation>una línea tiene un tipo y no un nombre: "%1"</translation></message>
<message><source>a field has no name: "%1"</source><translation>un campo no tiene nombre: "%1"</translation></message>
<message><source>the length of "%1" is not a number</source><translation>la longitud de «%1» no es un número</translation></message>
<message><source>a message of type %1 is encoded in a way that is not read (PLAIN_CDR and PLAIN_CDR2 are)</source><translation>un mensaje del tipo %1 está codificado de un modo que no se lee (PLAIN_CDR y PLAIN_CDR2 sí)</translation></message>
<message><source>record it with another middleware, or convert the bag</source><translation>grábelo con otro middleware, o convierta el bag</translation></message>
<message><source>a message of type %1 ends too early or does not fit its definition</source><translation>un mensaje del tipo %1 termina demasiado pronto o no se ajusta a su definición</translation></message>
<message><source>copy the bag again</source><translation>copie de nuevo el bag</translation></message>
<message><source>the bridge closed the connection</source><translation>el puente cerró la conexión</translation></message>
<message><source>the bridge sends a message of more than 64 MB</source><translation>el puente envía un mensaje de más de 64 MB</translation></message>
<message><source>choose another topic</source><translation>elija otro topic</translation></message>
<message><source>the connection broke (%1)</source><translation>la conexión se interrumpió (%1)</translation></message>
<message><source>check power, cable and the address, and that this computer is in the robot's network</source><translation>compruebe la alimentación, el cable y la dirección, y que este ordenador está en la red del robot</translation></message>
<message><source>check the port (8765) and that foxglove_bridge runs on the robot</source><translation>compruebe el puerto (8765) y que foxglove_bridge funciona en el robot</translation></message>
<message><source>what answers there is not a Foxglove bridge</source><translation>lo que responde allí no es un puente Foxglove</translation></message>
<message><source>check the port (8765) and that foxglove_bridge runs there; a scanner of SICK is HOST without ws://</source><translation>compruebe el puerto (8765) y que allí funciona foxglove_bridge; un escáner de SICK es HOST sin ws://</translation></message>
<message><source>the connection is closed</source><translation>la conexión está cerrada</translation></message>
<message><source>the subscription cannot be sent (%1)</source><translation>no se puede enviar la suscripción (%1)</translation></message>
<message><source>check the network</source><translation>compruebe la red</translation></message>
<message><source>%1 accepts the connection; asking for its topics.</source><translation>%1 acepta la conexión; preguntando por sus topics.</translation></message>
<message><source>the bridge says: %1</source><translation>el puente dice: %1</translation></message>
<message><source>check foxglove_bridge on the robot</source><translation>compruebe foxglove_bridge en el robot</translation></message>
<message><source>the bridge offers no topics</source><translation>el puente no ofrece ningún topic</translation></message>
<message><source>check that the robot's programs run</source><translation>compruebe que los programas del robot funcionan</translation></message>
<message><source>no scan line of %1 for %2</source><translation>ninguna línea de escaneo de %1 en %2</translation></message>
<message><source>check whether the laser runs and publishes this topic</source><translation>compruebe si el láser funciona y publica este topic</translation></message>
<message><source>the bridge describes its topics in a text of more than 4 MB</source><translation>el puente describe sus topics en un texto de más de 4 MB</translation></message>
<message><source>choose another bridge, or let it offer fewer topics</source><translation>elija otro puente, o haga que ofrezca menos topics</translation></message>
<message><source>what it sends is not the Foxglove WebSocket protocol</source><translation>lo que envía no es el protocolo WebSocket de Foxglove</translation></message>
<message><source>check the port (8765) and that foxglove_bridge runs there</source><translation>compruebe el puerto (8765) y que allí funciona foxglove_bridge</translation></message>
<message><source>%1 and others</source><translation>%1 y otros</translation></message>
<message><source>lines come, but their angle is not known: %1</source><translation>llegan líneas, pero no se conoce su ángulo: %1</translation></message>
<message><source>give the joint that turns the laser (--joint), or the step from line to line (--line-step)</source><translation>indique la articulación que gira el láser (--joint), o el paso de línea a línea (--line-step)</translation></message>
<message><source>there is not enough memory for this cloud</source><translation>no hay memoria suficiente para esta nube</translation></message>
<message><source>the bridge offers no topic of a laser (sensor_msgs/LaserScan or PointCloud2)%1</source><translation>el puente no ofrece ningún topic de un láser (sensor_msgs/LaserScan o PointCloud2)%1</translation></message>
<message><source>check that the laser's driver runs</source><translation>compruebe que el controlador del láser funciona</translation></message>
<message><source>the bridge offers no topic of a laser called "%1"</source><translation>el puente no ofrece ningún topic de un láser llamado «%1»</translation></message>
<message><source>choose one of %1</source><translation>elija uno de %1</translation></message>
<message><source>GUESS: the topic %1 was taken; --topic chooses another: %2.</source><translation>SUPOSICIÓN: se tomó el topic %1; --topic elige otro: %2.</translation></message>
<message><source>%1 messages of the topic %2 are in the bag twice: each was read once.</source><translation>%1 mensajes del topic %2 están dos veces en el bag: cada uno se leyó una vez.</translation></message>
<message><source>it is not a file of a bag</source><translation>no es un archivo de un bag</translation></message>
<message><source>The part %1 of the bag could not be read (%2): its messages are not in the scan.</source><translation>La parte %1 del bag no se pudo leer (%2): sus mensajes no están en el escaneo.</translation></message>
<message><source>The part %1 of the bag is missing: its messages are not in the scan.</source><translation>Falta la parte %1 del bag: sus mensajes no están en el escaneo.</translation></message>
<message><source>metadata.yaml does not name %1, a part of the bag by its name: its messages are not in the scan.</source><translation>metadata.yaml no nombra %1, que por su nombre es una parte del bag: sus mensajes no están en el escaneo.</translation></message>
<message><source>metadata.yaml names %1, whose name is not that of a file of messages (.mcap, .db3, .bag): it was not read.</source><translation>metadata.yaml nombra %1, cuyo nombre no es el de un archivo de mensajes (.mcap, .db3, .bag): no se leyó.</translation></message>
<message><source>no part of the bag is there</source><translation>no está ninguna parte del bag</translation></message>
<message><source>this is not the metadata of an Ouster: beam angles or columns of a frame are missing</source><translation>estos no son los metadatos de un Ouster: faltan los ángulos de los haces o las columnas de un cuadro</translation></message>
<message><source>save the sensor's metadata again</source><translation>guarde de nuevo los metadatos del sensor</translation></message>
<message><source>the capture</source><translation>la captura</translation></message>
<message><source>%1 turns</source><translation>%1 vueltas</translation></message>
<message><source>The capture holds %1 turns of the scanner; turn %2, counted from 0, was opened. --scan chooses another.</source><translation>La captura contiene %1 vueltas del escáner; se abrió la vuelta %2, contada desde 0. --scan elige otra.</translation></message>
<message><source>%n packet came out of order and was put in the order of the scanner's clock.</source><translation>%n paquete llegó desordenado y se puso en el orden del reloj del escáner.</translation></message>
<message><source>%n packets came out of order and were put in the order of the scanner's clock.</source><translation>%n paquetes llegaron desordenados y se pusieron en el orden del reloj del escáner.</translation></message>
<message><source>%n packet is missing in part in the capture: its lines are lost.</source><translation>%n paquete falta en parte en la captura: sus líneas se han perdido.</translation></message>
<message><source>%n packets are missing in part in the capture: their lines are lost.</source><translation>%n paquetes faltan en parte en la captura: sus líneas se han perdido.</translation></message>
<message><source>%n packet is in the capture twice: it was read once.</source><translation>%n paquete está dos veces en la captura: se leyó una vez.</translation></message>
<message><source>%n packets are in the capture twice: each was read once.</source><translation>%n paquetes están dos veces en la captura: cada uno se leyó una vez.</translation></message>
<message><source>The capture holds packets of %1 scanners; the one with most of them was opened.</source><translation>La captura contiene paquetes de %1 escáneres; se abrió el que más tiene.</translation></message>
<message><source>The scanner sent two returns for each beam: the strongest ones are here, and %1 left out.</source><translation>El escáner envió dos retornos por haz: aquí están los más fuertes, y quedaron fuera %1.</translation></message>
<message><source>%n other of the capture was</source><translation>%n otro de la captura</translation></message>
<message><source>%n others of the capture were</source><translation>%n otros de la captura</translation></message>
<message><source>The beams of a VLP-16 begin up to 11 mm above and below its middle: points are that far off.</source><translation>Los haces de un VLP-16 empiezan hasta 11 mm por encima y por debajo de su centro: los puntos están desviados otro tanto.</translation></message>
<message><source>the packets of an Ouster do not say the angles of its beams</source><translation>los paquetes de un Ouster no dicen los ángulos de sus haces</translation></message>
<message><source>save the sensor's metadata as %1 next to the capture</source><translation>guarde los metadatos del sensor como %1 junto a la captura</translation></message>
<message><source>no packet of the capture fits the sensor of %1</source><translation>ningún paquete de la captura corresponde al sensor de %1</translation></message>
<message><source>save the metadata of the sensor that was captured</source><translation>guarde los metadatos del sensor que se capturó</translation></message>
<message><source>The beams of an Ouster begin some centimetres away from its axis, and the ranges are as measured: points are that far off.</source><translation>Los haces de un Ouster empiezan a unos centímetros de su eje, y las distancias son las medidas: los puntos están desviados otro tanto.</translation></message>
<message><source>%n line of the turn is missing in the capture and is shown as lost.</source><translation>%n línea de la vuelta falta en la captura y se muestra como perdida.</translation></message>
<message><source>%n lines of the turn are missing in the capture and are shown as lost.</source><translation>%n líneas de la vuelta faltan en la captura y se muestran como perdidas.</translation></message>
<message><source>the capturing computer's clock, carried on by the scanner's</source><translation>el reloj del ordenador que capturó, continuado por el del escáner</translation></message>
<message><source>The cloud is of a scanner with several beams: its rings are the beams, and its firings the lines.</source><translation>La nube es de un escáner de varios haces: sus anillos son los haces, y sus disparos las líneas.</translation></message>
<message><source>the cloud has no fields x, y and z</source><translation>la nube no tiene campos x, y y z</translation></message>
<message><source>the cloud promises %1 x %2 points of %3 bytes and holds %4 bytes</source><translation>la nube anuncia %1 x %2 puntos de %3 bytes y contiene %4 bytes</translation></message>
<message><source>choose another topic or message</source><translation>elija otro topic u otro mensaje</translation></message>
<message><source>the topic %1</source><translation>el topic %1</translation></message>
<message><source>one cloud</source><translation>una nube</translation></message>
<message><source>%1 clouds</source><translation>%1 nubes</translation></message>
<message><source>The bag holds no definition of its messages: that of the ROS 2 release of 2022 was ASSUMED.</source><translation>El bag no contiene la definición de sus mensajes: se SUPUSO la de ROS 2 de 2022.</translation></message>
<message><source>The topic %1 holds a cloud in each message; message %2, counted from 0, was opened. --scan chooses another.</source><translation>El topic %1 contiene una nube en cada mensaje; se abrió el mensaje %2, contado desde 0. --scan elige otro.</translation></message>
<message><source>no file of messages that metadata.yaml names is in this folder: %1%2</source><translation>ningún archivo de mensajes que nombra metadata.yaml está en esta carpeta: %1%2</translation></message>
<message><source> and %1 more</source><translation> y %1 más</translation></message>
<message><source>copy the files of the bag into it</source><translation>copie en ella los archivos del bag</translation></message>
<message><source>this folder holds %1 of several bags</source><translation>esta carpeta contiene %1 de varios bags</translation></message>
<message><source>%n file</source><translation>%n archivo</translation></message>
<message><source>%n files</source><translation>%n archivos</translation></message>
<message><source>open one of them, as %1</source><translation>abra uno de ellos, como %1</translation></message>
<message><source>This file is part %1 of %2 of a bag. Open %3 for all of it.</source><translation>Este archivo es la parte %1 de %2 de un bag. Abra %3 para tenerlo entero.</translation></message>
<message><source>%n message of the topic was left out: %1.</source><translation>%n mensaje del topic se dejó fuera: %1.</translation></message>
<message><source>%n messages of the topic were left out: %1.</source><translation>%n mensajes del topic se dejaron fuera: %1.</translation></message>
<message><source>%n message has a time_increment that cannot be: the beams of a line count as measured at once.</source><translation>%n mensaje tiene un time_increment imposible: los haces de una línea cuentan como medidos a la vez.</translation></message>
<message><source>%n messages have a time_increment that cannot be: the beams of a line count as measured at once.</source><translation>%n mensajes tienen un time_increment imposible: los haces de una línea cuentan como medidos a la vez.</translation></message>
<message><source>%n line came out of order and was put in the order of its stamp</source><translation>%n línea llegó desordenada y se puso en el orden de su hora</translation></message>
<message><source>%n lines came out of order and were put in the order of their stamps</source><translation>%n líneas llegaron desordenadas y se pusieron en el orden de sus horas</translation></message>
<message><source>%n message of the topic is in the bag twice, with the same stamp and ranges: it was read once.</source><translation>%n mensaje del topic está dos veces en el bag, con la misma hora y las mismas distancias: se leyó una vez.</translation></message>
<message><source>%n messages of the topic are in the bag twice, with the same stamp and ranges: each was read once.</source><translation>%n mensajes del topic están dos veces en el bag, con la misma hora y las mismas distancias: cada uno se leyó una vez.</translation></message>
<message><source>In %1 angle_max is not where angle_min and angle_increment put the last beam: angle_increment was used, and the beams may be mirrored or turned.</source><translation>En %1 angle_max no está donde angle_min y angle_increment ponen el último haz: se usó angle_increment, y los haces pueden estar reflejados o girados.</translation></message>
<message><source>%n message of joints is damaged and was left out.</source><translation>%n mensaje de articulaciones está dañado y se dejó fuera.</translation></message>
<message><source>%n messages of joints are damaged and were left out.</source><translation>%n mensajes de articulaciones están dañados y se dejaron fuera.</translation></message>
<message><source>GUESS: the angle of each line comes from %1.</source><translation>SUPOSICIÓN: el ángulo de cada línea viene de %1.</translation></message>
<message><source>A joint does not say how the laser is mounted on it. ASSUMED: the axis (%1). Give --axis where that is wrong.</source><translation>Una articulación no dice cómo está montado el láser en ella. SUPUESTO: el eje (%1). Indique --axis donde eso no sea correcto.</translation></message>
<message><source>sweep, by the name of the joint</source><translation>sweep, por el nombre de la articulación</translation></message>
<message><source>The axis is %1 degrees out of the plane of the fan: points are that far off.</source><translation>El eje está a %1 grados fuera del plano del abanico: los puntos están desviados otro tanto.</translation></message>
<message><source>The laser is %1 mm off its axis: ranges are as measured, and points are as if it were on the axis.</source><translation>El láser está a %1 mm de su eje: las distancias son las medidas, y los puntos como si estuviera en el eje.</translation></message>
<message><source>%n line was measured before the first or after the last angle and was left out.</source><translation>%n línea se midió antes del primer ángulo o después del último y se dejó fuera.</translation></message>
<message><source>%n lines were measured before the first or after the last angle and were left out.</source><translation>%n líneas se midieron antes del primer ángulo o después del último y se dejaron fuera.</translation></message>
<message><source>%n line was measured while the laser did not turn and was left out.</source><translation>%n línea se midió mientras el láser no giraba y se dejó fuera.</translation></message>
<message><source>%n lines were measured while the laser did not turn and were left out.</source><translation>%n líneas se midieron mientras el láser no giraba y se dejaron fuera.</translation></message>
<message><source>the laser did not turn while it measured</source><translation>el láser no giró mientras medía</translation></message>
<message><source>choose another topic, or give the joint that turns it</source><translation>elija otro topic o indique la articulación que lo gira</translation></message>
<message><source>assembling lines</source><translation>componiendo líneas</translation></message>
<message><source>no line of the topic %1 could be placed</source><translation>no se pudo colocar ninguna línea del topic %1</translation></message>
<message><source>The topic holds %1 sweeps; sweep %2, counted from 0, was opened. --scan chooses another.</source><translation>El topic contiene %1 barridos; se abrió el barrido %2, contado desde 0. --scan elige otro.</translation></message>
<message><source>the stamps of the messages</source><translation>las marcas de tiempo de los mensajes</translation></message>
<message><source>%1 x %2 points with %3</source><translation>%1 x %2 puntos con %3</translation></message>
<message><source>%1turn rates and accelerations, which are not used: transforms and joints turn the laser</source><translation>%1velocidades de giro y aceleraciones, que no se usan: giran el láser las transformaciones y las articulaciones</translation></message>
<message><source>scan lines of %1 beams</source><translation>líneas de escaneo de %1 haces</translation></message>
<message><source>poses in the frame %1</source><translation>poses en el marco %1</translation></message>
<message><source> at %1 Hz</source><translation> a %1 Hz</translation></message>
<message><source>no topic of this %1 is a laser's%2%3</source><translation>ningún topic de este %1 es de un láser%2%3</translation></message>
<message><source>choose another bag</source><translation>elija otro bag</translation></message>
<message><source>the bag has no topic "%1"</source><translation>el bag no tiene ningún topic «%1»</translation></message>
<message><source>the topic %1 holds no scan</source><translation>el topic %1 no contiene ningún escaneo</translation></message>
<message><source> messages of transforms are damaged and were left out.</source><translation> mensajes de transformaciones están dañados y se dejaron fuera.</translation></message>
<message><source> transforms of the bag have no rotation, no name or no finite numbers and were left out.</source><translation> transformaciones del bag no tienen rotación, nombre o números finitos y se dejaron fuera.</translation></message>
<message><source> transforms name another parent for their frame than the first one and were left out.</source><translation> transformaciones nombran otro padre de su sistema que la primera y se dejaron fuera.</translation></message>
<message><source> transforms of the bag are of more frames than any robot has and were left out.</source><translation> transformaciones del bag son de más sistemas de los que tiene un robot y se dejaron fuera.</translation></message>
<message><source>The transforms of the bag form a loop at the frame %1.</source><translation>Las transformaciones del bag forman un bucle en el marco %1.</translation></message>
<message><source>The transforms of the bag form a chain of more than %1 frames: those above are not used.</source><translation>Las transformaciones del bag forman una cadena de más de %1 sistemas: los de arriba no se usan.</translation></message>
<message><source>ranges of the topic are %1 m, the range_min of their messages</source><translation>distancias del tema son %1 m, el range_min de sus mensajes</translation></message>
<message><source>ranges of the topic are %1 m</source><translation>distancias del topic son %1 m</translation></message>
<message><source>it has no beams or no stamp</source><translation>no tiene haces o no tiene marca de tiempo</translation></message>
<message><source>its angle_increment does not give the step between beams</source><translation>su angle_increment no da el paso entre haces</translation></message>
<message><source>its angle_min or angle_increment puts beams outside of one turn</source><translation>su angle_min o angle_increment pone haces fuera de una vuelta</translation></message>
<message><source>no message of the topic %1 is a line of ranges%2</source><translation>ningún mensaje del topic %1 es una línea de distancias%2</translation></message>
<message><source>GUESS: the poses of the topic %1 are those of the frame %2.</source><translation>SUPOSICIÓN: las poses del topic %1 son las del marco %2.</translation></message>
<message><source>The transforms put the scanner at %1, %2, %3 m, where nothing on earth is: the scan stays in the scanner's frame.</source><translation>Las transformaciones ponen el escáner en %1, %2, %3 m, donde no hay nada en la tierra: el escaneo queda en el sistema del escáner.</translation></message>
<message><source>the frame %1 of the bag</source><translation>el marco %1 del bag</translation></message>
<message><source>the transforms of the bag</source><translation>las transformaciones del bag</translation></message>
<message><source>GUESS: the frame %1 of the bag is taken as the mine grid, with x to the east, y to the north and z up.</source><translation>SUPOSICIÓN: el sistema %1 del bag se toma como cuadrícula de la mina, con x al este, y al norte y z hacia arriba.</translation></message>
<message><source>the transform of the frame %1 in %2</source><translation>la transformación del marco %1 en %2</translation></message>
<message><source>%1 turns about more than one axis (%2 degrees off)</source><translation>%1 gira alrededor de más de un eje (diferencia de %2 grados)</translation></message>
<message><source>choose another topic, or give the joint that turns the laser</source><translation>elija otro topic, o indique la articulación que gira el láser</translation></message>
<message><source>%1 turns the laser in the plane of its own fan: that is not a sweep</source><translation>%1 gira el láser en el plano de su propio abanico: eso no es un barrido</translation></message>
<message><source>no transform turns the laser's frame %1 while it measures</source><translation>ninguna transformación gira el sistema %1 del láser mientras mide</translation></message>
<message><source>give the joint that turns it (--joint), or the step from line to line (--line-step) and the axis (--axis)</source><translation>indique la articulación que lo gira (--joint), o el paso de línea a línea (--line-step) y el eje (--axis)</translation></message>
<message><source>no joint turned while the laser measured</source><translation>ninguna articulación giró mientras el láser medía</translation></message>
<message><source>there is no joint called %1</source><translation>no hay ninguna articulación llamada %1</translation></message>
<message><source>give the step from line to line (--line-step), or choose another topic</source><translation>indique el paso de línea a línea (--line-step), o elija otro topic</translation></message>
<message><source>the joint %1</source><translation>la articulación %1</translation></message>
<message><source>there are too many topics</source><translation>hay demasiados topics</translation></message>
<message><source>a line came out of order</source><translation>una línea llegó fuera de orden</translation></message>
<message><source>the angle of a line is not known</source><translation>no se conoce el ángulo de una línea</translation></message>
<message><source>the laser did not turn yet</source><translation>el láser aún no giró</translation></message>
<message><source>%1 degrees</source><translation>%1 grados</translation></message>
<message><source>, %1 times its uncertainty</source><translation>, %1 veces su incertidumbre</translation></message>
<message><source>odd beams lie %1 ahead of even ones%2</source><translation>los haces impares están %1 por delante de los pares%2</translation></message>
<message><source>odd beams lie %1 behind even ones%2</source><translation>los haces impares están %1 por detrás de los pares%2</translation></message>
<message><source>, %1 times the usual unevenness of its steps</source><translation>, %1 veces la irregularidad habitual de sus pasos</translation></message>
<message><source>the stepper slipped at %1 (first at line %2, by up to %3%4)</source><translation>el motor paso a paso perdió pasos en %1 (la primera vez en la línea %2, hasta %3%4)</translation></message>
<message><source>%n line</source><translation>%n línea</translation></message>
<message><source>%n lines</source><translation>%n líneas</translation></message>
<message><source>the beams of %1 lines in turn lie %2 and %3 degrees ahead of where they should be%4</source><translation>los haces de %1 líneas están por turno %2 y %3 grados por delante de donde deberían%4</translation></message>
<message><source> At %1 of the first and last lines the stepper still swung back: folds there are left out.</source><translation> En %1 de las primeras y últimas líneas el motor paso a paso aún oscilaba: los pliegues de ahí se dejan fuera.</translation></message>
<message><source>Not measured at the angles that the file gives: </source><translation>No medido en los ángulos que da el archivo: </translation></message>
<message><source>Not straightened: the scan has no lines with angles.</source><translation>No enderezado: el escaneo no tiene líneas con ángulos.</translation></message>
<message><source>Straightened: %1, and were put side by side: %2 lines make one.</source><translation>Enderezado: %1, y se pusieron una al lado de otra: %2 líneas forman una.</translation></message>
<message><source>Straightened: no interlaced beams and no slips were found; the angles stay.</source><translation>Enderezado: no se hallaron haces entrelazados ni deslizamientos; los ángulos quedan.</translation></message>
<message><source>%n slip was seen in every second beam only, and is left as it is.</source><translation>%n deslizamiento se vio solo en uno de cada dos haces y se deja como está.</translation></message>
<message><source>%n slips were seen in every second beam only, and are left as they are.</source><translation>%n deslizamientos se vieron solo en uno de cada dos haces y se dejan como están.</translation></message>
<message><source>; edges across the lines are combed: --straighten (Scan &gt; Straighten Beams) puts these lines side by side as one.</source><translation>; los bordes que cruzan las líneas quedan dentados: --straighten (Scan &gt; Straighten Beams) pone estas líneas lado a lado como una.</translation></message>
<message><source>; EdgeScan+ allows for it, but the cloud does not: --straighten (Scan &gt; Straighten Beams) corrects the angles.</source><translation>; EdgeScan+ lo tiene en cuenta, pero la nube no: --straighten (Scan &gt; Straighten Beams) corrige los ángulos.</translation></message>
<message><source>has no direction</source><translation>no tiene dirección</translation></message>
<message><source>and "head_in_robot_m" exclude each other</source><translation>y "head_in_robot_m" se excluyen</translation></message>
<message><source>compare it with the example in docs/reference/coordinates.md</source><translation>compárelo con el ejemplo de docs/reference/coordinates.md</translation></message>
<message><source>the inclinometer's two axes cannot be raised by %1 and %2 degrees at once</source><translation>los dos ejes del inclinómetro no pueden levantarse %1 y %2 grados a la vez</translation></message>
<message><source>check whether it reads pitch and roll instead of the elevations of its axes</source><translation>compruebe si lee cabeceo y alabeo en vez de las elevaciones de sus ejes</translation></message>
<message><source>a boom slewed by %1 degrees on this robot cannot be raised by %2</source><translation>un brazo girado %1 grados en este robot no puede levantarse %2</translation></message>
<message><source>check the slew angle and the inclinometer</source><translation>compruebe el ángulo de giro y el inclinómetro</translation></message>
<message><source>RL, positive up [m]</source><translation>RL, positivo hacia arriba [m]</translation></message>
<message><source>Heading, clockwise from north [degrees]</source><translation>Rumbo, desde el norte en sentido horario [grados]</translation></message>
<message><source>North of the heading</source><translation>Norte del rumbo</translation></message>
<message><source>Tilt: pitch, nose up [degrees]</source><translation>Inclinación: cabeceo, morro arriba [grados]</translation></message>
<message><source>Tilt: roll, right side down [degrees]</source><translation>Inclinación: alabeo, lado derecho abajo [grados]</translation></message>
<message><source>Zone or EPSG code</source><translation>Zona o código EPSG</translation></message>
<message><source>Azimuth of the boom, positive to the left [degrees]</source><translation>Acimut del brazo, positivo hacia la izquierda [grados]</translation></message>
<message><source>Robot's pitch, nose up [degrees]</source><translation>Cabeceo del robot, morro arriba [grados]</translation></message>
<message><source>Robot's roll, right side down [degrees]</source><translation>Alabeo del robot, lado derecho abajo [grados]</translation></message>
<message><source>Name of robot or scanner</source><translation>Nombre del robot o del escáner</translation></message>
<message><source>Boresight: roll, pitch, yaw [degrees]</source><translation>Alineación: alabeo, cabeceo, guiñada [grados]</translation></message>
<message><source>Lever arm of TALIN in the robot: forward, left, up [m]</source><translation>Brazo de palanca del TALIN en el robot: adelante, izquierda, arriba [m]</translation></message>
<message><source>Lever arm of the head in the robot: forward, left, up [m]</source><translation>Brazo de palanca del cabezal en el robot: adelante, izquierda, arriba [m]</translation></message>
<message><source>Pivot of a boom in the robot, in place of the head [m]</source><translation>Pivote de un brazo en el robot, en lugar del cabezal [m]</translation></message>
<message><source>From pivot to head [m]</source><translation>Del pivote al cabezal [m]</translation></message>
<message><source>The boom's azimuth turns about</source><translation>El acimut del brazo gira alrededor de</translation></message>
<message><source>The scanner looks</source><translation>El escáner mira</translation></message>
<message><source>Looking direction: roll, pitch, yaw [degrees]</source><translation>Dirección de la mirada: alabeo, cabeceo, guiñada [grados]</translation></message>
<message><source>Looking direction: nine numbers by rows</source><translation>Dirección de la mirada: nueve números por filas</translation></message>
<message><source>Axis of the stepper from the inclinometer [m]</source><translation>Eje del motor desde el inclinómetro [m]</translation></message>
<message><source>Tilt is given as</source><translation>La inclinación se da como</translation></message>
<message><source>Scanner on the stepper: roll, pitch, yaw [degrees]</source><translation>Escáner sobre el motor: alabeo, cabeceo, guiñada [grados]</translation></message>
<message><source>Scanner on the stepper: x, y, z [m]</source><translation>Escáner sobre el motor: x, y, z [m]</translation></message>
<message><source>Axis of the stepper</source><translation>Eje del motor</translation></message>
<message><source>Zero of the stepper [degrees]</source><translation>Cero del motor [grados]</translation></message>
<message><source>Direction of the stepper, 1 or -1</source><translation>Sentido del motor, 1 o -1</translation></message>
<message><source>Step from line to line [degrees]</source><translation>Paso de línea a línea [grados]</translation></message>
<message><source>Beam at the time stamp of a line [degrees]</source><translation>Haz en la marca de tiempo de una línea [grados]</translation></message>
<message><source>Grid convergence [degrees]</source><translation>Convergencia de la cuadrícula [grados]</translation></message>
<message><source>Scale of the grid</source><translation>Escala de la cuadrícula</translation></message>
<message><source>Largest change of tilt during a sweep [degrees]</source><translation>Mayor cambio de inclinación durante un barrido [grados]</translation></message>
<message><source>Largest age of a pose [s]</source><translation>Mayor antigüedad de una pose [s]</translation></message>
<message><source>%1 is missing.</source><translation>%1 falta.</translation></message>
<message><source>%1: "%2" is not a number.</source><translation>%1: «%2» no es un número.</translation></message>
<message><source>%1: "%2" is not three numbers.</source><translation>%1: «%2» no son tres números.</translation></message>
<message><source>%1: "%2" is not nine numbers.</source><translation>%1: «%2» no son nueve números.</translation></message>
<message><source>the file must hold an object {...}</source><translation>el archivo debe contener un objeto {...}</translation></message>
<message><source>choose a pose or calibration file</source><translation>elija un archivo de pose o de calibración</translation></message>
<message><source>the pose is of robot "%1" and the calibration of "%2"</source><translation>la pose es del robot «%1» y la calibración de «%2»</translation></message>
<message><source>give the calibration of the robot that made the scan</source><translation>indique la calibración del robot que hizo el escaneo</translation></message>
<message><source>the scan turns about %1 and the stepper of the calibration about another axis, %2 degrees away</source><translation>el escaneo gira alrededor de %1 y el motor paso a paso de la calibración alrededor de otro eje, a %2 grados</translation></message>
<message><source>x (sweep)</source><translation>x (sweep)</translation></message>
<message><source>z (spin)</source><translation>z (spin)</translation></message>
<message><source>open the scan with the right --axis, or correct "stepper.axis" of the calibration: [0, 0, 1] for a spin, [1, 0, 0] for a sweep</source><translation>abra el escaneo con el --axis correcto, o corrija "stepper.axis" de la calibración: [0, 0, 1] para spin, [1, 0, 0] para sweep</translation></message>
<message><source>%1 line times do not fit a scan of %2 lines</source><translation>%1 tiempos de línea no corresponden a un escaneo de %2 líneas</translation></message>
<message><source>give the times of this scan</source><translation>indique los tiempos de este escaneo</translation></message>
<message><source>OUT OF SPEC: </source><translation>FUERA DE TOLERANCIA: </translation></message>
<message><source>The pose carries no time, so its age is not known.</source><translation>La pose no tiene hora, así que no se conoce su edad.</translation></message>
<message><source>The start of the scan is not known, so the age of the pose is not either.</source><translation>No se conoce el inicio del escaneo, así que tampoco la edad de la pose.</translation></message>
<message><source>the pose is %1 s older than the start of the scan.</source><translation>la pose es %1 s más antigua que el comienzo del escaneo.</translation></message>
<message><source>the tilt of the head changed by %1 degrees while it scanned, more than %2.</source><translation>la inclinación del cabezal cambió %1 grados durante el escaneo, más de %2.</translation></message>
<message><source>The calibration does not give %1, so 0 is used: add what is missing (Scan &gt; Pose and Mounting, page Mounting).</source><translation>La calibración no da %1; se usa 0: añada lo que falta (Escaneo &gt; Pose y montaje, página Montaje).</translation></message>
<message><source>%1 of %2 lines were measured before the first or after the last pose and were given the nearest one.</source><translation>%1 de %2 líneas se midieron antes de la primera o después de la última pose y recibieron la más cercana.</translation></message>
<message><source>the poses move the base at %1 m/s between two lines, faster than any machine under ground.</source><translation>las poses mueven la base a %1 m/s entre dos líneas, más rápido que cualquier máquina bajo tierra.</translation></message>
<message><source>the zone "%1" does not exist: UTM has zones 1 to 60.</source><translation>la zona "%1" no existe: UTM tiene las zonas 1 a 60.</translation></message>
<message><source>an easting of %1 m is outside of every UTM zone: check whether easting and northing are exchanged.</source><translation>una coordenada este de %1 m está fuera de toda zona UTM: compruebe si este y norte están intercambiados.</translation></message>
<message><source>there is no pose</source><translation>no hay pose</translation></message>
<message><source>give readings of inclinometer and TALIN</source><translation>indique lecturas de inclinómetro y TALIN</translation></message>
<message><source>the angles of the stepper are assumed, so E, N and RL may be wrong: give mounting, step and angle of the first line.</source><translation>los ángulos del motor paso a paso están supuestos, así que E, N y RL pueden ser erróneos: indique el montaje, el paso y el ángulo de la primera línea.</translation></message>
<message><source>the base moved and the times of the lines are not known</source><translation>la base se movió y no se conocen los tiempos de las líneas</translation></message>
<message><source>add "scan_start" and "scan_end" to the pose file</source><translation>añada "scan_start" y "scan_end" al archivo de pose</translation></message>
<message><source>a pose needs the robot's calibration</source><translation>una pose necesita la calibración del robot</translation></message>
<message><source>--calibration replaces the calibration in %1.</source><translation>--calibration sustituye la calibración de %1.</translation></message>
<message><source>The pose in %1 replaces the place that the file gives: E %2, N %3 m in place of E %4, N %5 m.</source><translation>La pose de %1 reemplaza el lugar que da el archivo: E %2, N %3 m en vez de E %4, N %5 m.</translation></message>
<message><source>mine grid</source><translation>coordenadas mina</translation></message>
<message><source>local metres from the mine grid origin</source><translation>metros locales desde el origen de la cuadrícula de la mina</translation></message>
<message><source>save the scan again, or remove "placement"</source><translation>guarde de nuevo el escaneo, o quite "placement"</translation></message>
<message><source>must not be where the pivot is</source><translation>no debe estar donde está el pivote</translation></message>
<message><source>"placement" must be an object {...}</source><translation>"placement" debe ser un objeto {...}</translation></message>
<message><source>must be a rotation and a translation, twelve numbers</source><translation>debe ser una rotación y una traslación, doce números</translation></message>
<message><source>must hold one pose or %1, one per line</source><translation>debe contener una pose o %1, una por línea</translation></message>
<message><source>must hold rotations and translations, twelve numbers each</source><translation>debe contener rotaciones y traslaciones, doce números cada una</translation></message>
<message><source>and "%1" exclude each other</source><translation>y «%1» se excluyen</translation></message>
<message><source>needs a "time" in every reading when "sweep" is "moving"</source><translation>necesita un "time" en cada lectura cuando "sweep" es "moving"</translation></message>
<message><source>must be in the order of time</source><translation>debe estar en el orden del tiempo</translation></message>
<message><source>comes before "scan_start"</source><translation>viene antes de "scan_start"</translation></message>
<message><source>; a scanner that hangs has "viewing": "down" in its calibration</source><translation>; un escáner que cuelga tiene "viewing": "down" en su calibración</translation></message>
<message><source>; a magnetic bearing is converted as the same page says</source><translation>; un rumbo magnético se convierte como dice la misma página</translation></message>
<message><source>this is a pose of 3DTK and not of EdgeScan</source><translation>esta es una pose de 3DTK y no de EdgeScan</translation></message>
<message><source>give a pose file as in docs/reference/coordinates.md</source><translation>indique un archivo de pose como en docs/reference/coordinates.md</translation></message>
<message><source>write easting, northing and level, such as 498765.432; 5150123.456; 287.654</source><translation>escriba este, norte y nivel, como 498765.432; 5150123.456; 287.654</translation></message>
<message><source>the line holds %1 and a place has three, with a heading four, with pitch and roll six</source><translation>la línea contiene %1 y un lugar tiene tres, con rumbo cuatro, con cabeceo y alabeo seis</translation></message>
<message><source>the line is empty</source><translation>la línea está vacía</translation></message>
<message><source>%1 may be one number with a comma for thousands, or two numbers</source><translation>%1 puede ser un número con coma de millares, o dos números</translation></message>
<message><source>leave that comma out, or write blanks between the numbers</source><translation>quite esa coma, o escriba espacios entre los números</translation></message>
<message><source>the first of four whole numbers may be the point's or the easting</source><translation>el primero de cuatro números enteros puede ser el del punto o el este</translation></message>
<message><source>leave the point's number out, or write decimals</source><translation>quite el número del punto, o escriba decimales</translation></message>
<message><source>How a motor turned the scanner was not said in full. ASSUMED: </source><translation>No se indicó del todo cómo un motor giró el escáner. SUPUESTO: </translation></message>
<message><source>the axis (</source><translation>el eje (</translation></message>
<message><source>, seen in the ranges)</source><translation>, visto en las distancias)</translation></message>
<message><source>the step from line to line (</source><translation>el paso de línea a línea (</translation></message>
<message><source>the angle of the first line (</source><translation>el ángulo de la primera línea (</translation></message>
<message><source>the file gives points and not angles</source><translation>el archivo da puntos y no ángulos</translation></message>
<message><source>scan of a file</source><translation>escaneo de un archivo</translation></message>
<message><source>no file holds more</source><translation>ningún archivo contiene más</translation></message>
<message><source>Angle of the first beam [degrees]</source><translation>Ángulo del primer haz [grados]</translation></message>
<message><source>Angle from beam to beam [degrees]</source><translation>Ángulo de un haz al siguiente [grados]</translation></message>
<message><source>Angle of the first line [degrees]</source><translation>Ángulo de la primera línea [grados]</translation></message>
<message><source>Angle from line to line [degrees]</source><translation>Ángulo de una línea a la siguiente [grados]</translation></message>
<message><source>Unit of the numbers in the file; replaces the one that the file gives</source><translation>Unidad de los números del archivo; sustituye a la que da el archivo</translation></message>
<message><source>Millimetres per number in the file</source><translation>Milímetros por número del archivo</translation></message>
<message><source>Cells of a cloud that is projected [degrees]; else from the spacing of its points</source><translation>Celdas de una nube que se proyecta [grados]; si no, según el espaciado de sus puntos</translation></message>
<message><source>What the stepper turns about: spin (viewing direction) or sweep (0/180 degree line)</source><translation>En torno a qué gira el motor paso a paso: spin (dirección de visión) o sweep (línea 0/180 grados)</translation></message>
<message><source>Place of the scanner for a cloud without a grid, as X,Y,Z [m]</source><translation>Lugar del escáner para una nube sin cuadrícula, como X,Y,Z [m]</translation></message>
<message><source>Points without a scanner grid: project them about the sensor (auto), do so without looking for a grid (always), or refuse them (never)</source><translation>Puntos que no están en ninguna cuadrícula de escáner: proyectarlos en torno al sensor (auto), hacerlo sin buscar una cuadrícula (always), o rechazarlos (never)</translation></message>
<message><source>Correct the angles of beams that were interlaced from two passes, and of lines at which the stepper slipped</source><translation>Corregir los ángulos de los haces entrelazados de dos pasadas, y de las líneas en que el motor paso a paso patinó</translation></message>
<message><source>Which scan of a file that holds several, from 0</source><translation>Qué escaneo de un archivo que contiene varios, desde 0</translation></message>
<message><source>Topic of a ROS bag that is the scan; otherwise a laser that is turned</source><translation>Tema (topic) de un bag de ROS que es el escaneo; si no, un láser que gira</translation></message>
<message><source>Joint of a ROS bag that turns the laser; otherwise from the transforms</source><translation>Articulación (joint) de un bag de ROS que gira el láser; si no, la dan las transformaciones</translation></message>
<message><source>Columns of x, y and z in a list of points, by number from 1 or by name: 2,1,3</source><translation>Columnas de x, y y z en una lista de puntos, por número desde 1 o por nombre: 2,1,3</translation></message>
<message><source>Take a value or point that repeats exactly, far apart from the rest, as measured and not as no return</source><translation>Tomar un valor o punto que se repite exactamente, lejos del resto, como medido y no como sin retorno</translation></message>
<message><source>Pose file of the scan; a recording may hold its own</source><translation>Archivo de pose del escaneo; una grabación puede contener el suyo</translation></message>
<message><source>Calibration file of the robot; a recording may hold its own</source><translation>Archivo de calibración del robot; una grabación puede contener el suyo</translation></message>
<message><source>must not be 0</source><translation>no debe ser 0</translation></message>
<message><source>%1, or a number of %2</source><translation>%1, o un número de %2</translation></message>
<message><source>"%1" is not one of its values</source><translation>«%1» no es uno de sus valores</translation></message>
<message><source>from %1 to %2%3</source><translation>de %1 a %2%3</translation></message>
<message><source>give three numbers %1: X,Y,Z</source><translation>indique tres números %1: X,Y,Z</translation></message>
<message><source>give a whole number %1</source><translation>indique un número entero %1</translation></message>
<message><source>give a number %1</source><translation>indique un número %1</translation></message>
<message><source> that is not 0</source><translation> que no sea 0</translation></message>
<message><source>"%1" is not three numbers</source><translation>«%1» no son tres números</translation></message>
<message><source>"%1" is not a number</source><translation>«%1» no es un número</translation></message>
<message><source>%1 is out of reason for a %2</source><translation>%1 está fuera de lo razonable para %2</translation></message>
<message><source>%1 holds %2</source><translation>%1 contiene %2</translation></message>
<message><source>--scan %1</source><translation>--scan %1</translation></message>
<message><source>use --scan 0</source><translation>use --scan 0</translation></message>
<message><source>use --scan 0 to %1</source><translation>use --scan de 0 a %1</translation></message>
<message><source>--%1 %2 replaces %3, which the file gives.</source><translation>--%1 %2 sustituye %3, que da el archivo.</translation></message>
<message><source>--%1 has no effect: %2; leave it out.</source><translation>--%1 no tiene efecto: %2; déjelo fuera.</translation></message>
<message><source>what the scan was opened with is damaged</source><translation>con lo que se abrió el escaneo está dañado</translation></message>
<message><source>export again</source><translation>exporte de nuevo</translation></message>
<message><source>verify with the version that made the export</source><translation>verifique con la versión que hizo la exportación</translation></message>
<message><source>the file</source><translation>el archivo</translation></message>
<message><source>one scan</source><translation>un escaneo</translation></message>
<message><source>%1 scans</source><translation>%1 escaneos</translation></message>
<message><source>the scanner</source><translation>el escáner</translation></message>
<message><source>the scanner's answer to %1</source><translation>la respuesta del escáner a %1</translation></message>
<message><source>the code of a refusal</source><translation>el código de un rechazo</translation></message>
<message><source>the number of sectors</source><translation>el número de sectores</translation></message>
<message><source>the angle step</source><translation>el paso angular</translation></message>
<message><source>the start angle</source><translation>el ángulo inicial</translation></message>
<message><source>the stop angle</source><translation>el ángulo final</translation></message>
<message><source>the value</source><translation>el valor</translation></message>
<message><source>the text</source><translation>el texto</translation></message>
<message><source>the scan frequency</source><translation>la frecuencia de escaneo</translation></message>
<message><source>the channels</source><translation>los canales</translation></message>
<message><source>the remission switch</source><translation>el interruptor de remisión</translation></message>
<message><source>the remission width</source><translation>el ancho de remisión</translation></message>
<message><source>the unit</source><translation>la unidad</translation></message>
<message><source>the encoders</source><translation>los codificadores</translation></message>
<message><source>the position switch</source><translation>el interruptor de posición</translation></message>
<message><source>the name switch</source><translation>el interruptor de nombre</translation></message>
<message><source>the comment switch</source><translation>el interruptor de comentario</translation></message>
<message><source>the time switch</source><translation>el interruptor de tiempo</translation></message>
<message><source>the output interval</source><translation>el intervalo de salida</translation></message>
<message><source>the name</source><translation>el nombre</translation></message>
<message><source>the version</source><translation>la versión</translation></message>
<message><source>the state</source><translation>el estado</translation></message>
<message><source>the temperature range</source><translation>el margen de temperatura</translation></message>
<message><source>the time</source><translation>la hora</translation></message>
<message><source>the date</source><translation>la fecha</translation></message>
<message><source>this is not an answer of a scanner</source><translation>esto no es una respuesta de un escáner</translation></message>
<message><source>byte 0 of the telegram</source><translation>byte 0 del telegrama</translation></message>
<message><source>an answer without a name</source><translation>una respuesta sin nombre</translation></message>
<message><source>byte 4 of the telegram</source><translation>byte 4 del telegrama</translation></message>
<message><source>access to the method is denied, log in first</source><translation>el acceso al método está denegado, inicie sesión primero</translation></message>
<message><source>the method is not known</source><translation>no se conoce el método</translation></message>
<message><source>the variable is not known</source><translation>no se conoce la variable</translation></message>
<message><source>not possible now, or a value is out of its range</source><translation>no es posible ahora, o un valor está fuera de su intervalo</translation></message>
<message><source>the arguments are wrong in number or form</source><translation>los argumentos son erróneos en número o forma</translation></message>
<message><source>unknown error</source><translation>error desconocido</translation></message>
<message><source>the telegram is too long</source><translation>el telegrama es demasiado largo</translation></message>
<message><source>the telegram is too short</source><translation>el telegrama es demasiado corto</translation></message>
<message><source>the type is not known</source><translation>no se conoce el tipo</translation></message>
<message><source>writing the variable is denied, log in first</source><translation>escribir la variable está denegado, inicie sesión primero</translation></message>
<message><source>the command is not known to the name server</source><translation>el servidor de nombres no conoce el comando</translation></message>
<message><source>the CoLa command is not known</source><translation>no se conoce el comando CoLa</translation></message>
<message><source>the method is still busy</source><translation>el método aún está ocupado</translation></message>
<message><source>an array is out of its bounds</source><translation>una tabla se sale de sus límites</translation></message>
<message><source>the event is not known</source><translation>no se conoce el evento</translation></message>
<message><source>a CoLa A value is too large</source><translation>un valor CoLa A es demasiado grande</translation></message>
<message><source>a CoLa A character is invalid</source><translation>un carácter CoLa A no es válido</translation></message>
<message><source>no message</source><translation>ningún mensaje</translation></message>
<message><source>no answer</source><translation>ninguna respuesta</translation></message>
<message><source>internal error</source><translation>error interno</translation></message>
<message><source>hub address is corrupted</source><translation>la dirección del hub está dañada</translation></message>
<message><source>hub address cannot be decoded</source><translation>la dirección del hub no se puede decodificar</translation></message>
<message><source>hub address is out of range</source><translation>la dirección del hub está fuera de su intervalo</translation></message>
<message><source>hub address expected</source><translation>se esperaba la dirección del hub</translation></message>
<message><source>asynchronous methods are suppressed</source><translation>los métodos asíncronos están suprimidos</translation></message>
<message><source>complex arrays are not supported</source><translation>no se admiten tablas complejas</translation></message>
<message><source>a reason that is not documented</source><translation>un motivo que no está documentado</translation></message>
<message><source>byte %1 of the telegram</source><translation>byte %1 del telegrama</translation></message>
<message><source>is cut off</source><translation>está cortado</translation></message>
<message><source>is not a number of %1 bits</source><translation>no es un número de %1 bits</translation></message>
<message><source>does not end after %1 characters</source><translation>no termina después de %1 caracteres</translation></message>
<message><source>are cut off</source><translation>están cortados</translation></message>
<message><source>bridges with encryption are not supported</source><translation>no se admiten puentes con cifrado</translation></message>
<message><source>write ws://HOST or ws://HOST:PORT</source><translation>escriba ws://HOST o ws://HOST:PORT</translation></message>
<message><source>"%1://" is not known here</source><translation>aquí no se conoce «%1://»</translation></message>
<message><source>write HOST or HOST:PORT for a scanner, ws://HOST or ws://HOST:PORT for a robot's Foxglove bridge</source><translation>escriba HOST o HOST:PORT para un escáner, ws://HOST o ws://HOST:PORT para el puente Foxglove de un robot</translation></message>
<message><source>what follows the bracket is not a port</source><translation>lo que sigue al corchete no es un puerto</translation></message>
<message><source>there is no port behind the colon</source><translation>no hay ningún puerto detrás de los dos puntos</translation></message>
<message><source>there is no host</source><translation>no hay host</translation></message>
<message><source>"%1" is not a port</source><translation>«%1» no es un puerto</translation></message>
<message><source>give a number from 1 to 65535</source><translation>indique un número de 1 a 65535</translation></message>
<message><source>no scanner is given</source><translation>no se ha indicado ningún escáner</translation></message>
<message><source>give its IP address or host name</source><translation>indique su dirección IP o su nombre de host</translation></message>
<message><source>the host name is not known</source><translation>el nombre de host es desconocido</translation></message>
<message><source>check its spelling or use the scanner's IP address</source><translation>compruebe cómo está escrito o use la dirección IP del escáner</translation></message>
<message><source>the name server does not answer</source><translation>el servidor de nombres no responde</translation></message>
<message><source>use the scanner's IP address</source><translation>use la dirección IP del escáner</translation></message>
<message><source>nothing answers there</source><translation>nada responde en esa dirección</translation></message>
<message><source>the connection is refused</source><translation>la conexión es rechazada</translation></message>
<message><source>there is no way to this address</source><translation>no hay ruta hacia esta dirección</translation></message>
<message><source>check the cable and the network settings of this computer</source><translation>compruebe el cable y los ajustes de red de este equipo</translation></message>
<message><source>cannot connect (%1)</source><translation>no se puede conectar (%1)</translation></message>
<message><source>check the address and the network settings of this computer</source><translation>compruebe la dirección y los ajustes de red de este equipo</translation></message>
<message><source>check power, cable and the address, and that this computer is in the scanner's network</source><translation>compruebe la alimentación, el cable y la dirección, y que este equipo esté en la red del escáner</translation></message>
<message><source>check the port (2111 or 2112) and that no other program holds the scanner</source><translation>compruebe el puerto (2111 o 2112) y que ningún otro programa ocupe el escáner</translation></message>
<message><source>a command cannot be sent (%1)</source><translation>no se puede enviar un comando (%1)</translation></message>
<message><source>check the cable</source><translation>compruebe el cable</translation></message>
<message><source>the scanner closed the connection</source><translation>el escáner cerró la conexión</translation></message>
<message><source>check that a scanner of SICK answers there; a robot's Foxglove bridge is ws://HOST</source><translation>compruebe que allí responde un escáner de SICK; el puente Foxglove de un robot es ws://HOST</translation></message>
<message><source>the name of a channel</source><translation>el nombre de un canal</translation></message>
<message><source>the scale of a channel</source><translation>la escala de un canal</translation></message>
<message><source>the offset of a channel</source><translation>el desplazamiento de un canal</translation></message>
<message><source>the start angle of a channel</source><translation>el ángulo inicial de un canal</translation></message>
<message><source>the angle step of a channel</source><translation>el paso angular de un canal</translation></message>
<message><source>the number of values of a channel</source><translation>el número de valores de un canal</translation></message>
<message><source>the values of a channel</source><translation>los valores de un canal</translation></message>
<message><source>the number of channels</source><translation>el número de canales</translation></message>
<message><source>the device number</source><translation>el número del aparato</translation></message>
<message><source>the serial number</source><translation>el número de serie</translation></message>
<message><source>the device status</source><translation>el estado del aparato</translation></message>
<message><source>the telegram counter</source><translation>el contador de telegramas</translation></message>
<message><source>the scan counter</source><translation>el contador de escaneos</translation></message>
<message><source>the time since start-up</source><translation>el tiempo desde el arranque</translation></message>
<message><source>the time of transmission</source><translation>la hora de transmisión</translation></message>
<message><source>the digital inputs</source><translation>las entradas digitales</translation></message>
<message><source>the digital outputs</source><translation>las salidas digitales</translation></message>
<message><source>the layer angle</source><translation>el ángulo de la capa</translation></message>
<message><source>the measurement frequency</source><translation>la frecuencia de medición</translation></message>
<message><source>the number of encoders</source><translation>el número de codificadores</translation></message>
<message><source>an encoder position</source><translation>una posición de codificador</translation></message>
<message><source>an encoder speed</source><translation>una velocidad de codificador</translation></message>
<message><source>the position</source><translation>la posición</translation></message>
<message><source>the rotation</source><translation>la rotación</translation></message>
<message><source>the rotation type</source><translation>el tipo de rotación</translation></message>
<message><source>the year</source><translation>el año</translation></message>
<message><source>the date and time</source><translation>la fecha y la hora</translation></message>
<message><source>the microsecond</source><translation>el microsegundo</translation></message>
<message><source>the event type</source><translation>el tipo de evento</translation></message>
<message><source>the event's encoder</source><translation>el codificador del evento</translation></message>
<message><source>the event's time</source><translation>la hora del evento</translation></message>
<message><source>the event's angle</source><translation>el ángulo del evento</translation></message>
<message><source>the position flag</source><translation>el indicador de posición</translation></message>
<message><source>the name flag</source><translation>el indicador de nombre</translation></message>
<message><source>the device name</source><translation>el nombre del aparato</translation></message>
<message><source>the comment flag</source><translation>el indicador de comentario</translation></message>
<message><source>the comment</source><translation>el comentario</translation></message>
<message><source>the time flag</source><translation>el indicador de hora</translation></message>
<message><source>the event flag</source><translation>el indicador de evento</translation></message>
<message><source>the offset of the channel %1 is %2, which no scanner uses</source><translation>el desplazamiento del canal %1 es %2, que ningún escáner usa</translation></message>
<message><source>the scale of the channel %1 is %2, which no scanner uses</source><translation>la escala del canal %1 es %2, que ningún escáner usa</translation></message>
<message><source>the scan telegram</source><translation>el telegrama de escaneo</translation></message>
<message><source>this is not a scan telegram (LMDscandata)</source><translation>esto no es un telegrama de escaneo (LMDscandata)</translation></message>
<message><source>firmware %1</source><translation>firmware %1</translation></message>
<message><source>%1 degrees from %2 to %3</source><translation>%1 grados de %2 a %3</translation></message>
<message><source>something accepts the connection but does not answer in CoLa</source><translation>algo acepta la conexión pero no responde en CoLa</translation></message>
<message><source>check that it is a SICK scanner and the port is 2111 or 2112</source><translation>compruebe que es un escáner SICK y que el puerto es 2111 o 2112</translation></message>
<message><source>no answer to "%1"</source><translation>ninguna respuesta a «%1»</translation></message>
<message><source>check the connection</source><translation>compruebe la conexión</translation></message>
<message><source>no line was received</source><translation>no se recibió ninguna línea</translation></message>
<message><source>check that foxglove_bridge runs there; a scanner of SICK is HOST without ws://</source><translation>compruebe que allí funciona foxglove_bridge; un escáner de SICK es HOST sin ws://</translation></message>
<message><source>check cable, address and port</source><translation>compruebe el cable, la dirección y el puerto</translation></message>
<message><source>%1: disconnected.</source><translation>%1: desconectado.</translation></message>
<message><source>%1 Trying again in %2.</source><translation>%1 Nuevo intento en %2.</translation></message>
<message><source>Connecting to %1.</source><translation>Conectando con %1.</translation></message>
<message><source> is sending.</source><translation> envía.</translation></message>
<message><source> is sending again.</source><translation> vuelve a enviar.</translation></message>
<message><source>%1: no scan for %2.</source><translation>%1: ningún escaneo desde hace %2.</translation></message>
<message><source>%1 accepts the connection; asking what it is.</source><translation>%1 acepta la conexión; preguntando qué es.</translation></message>
<message><source>the scanner refuses to send scans: %1</source><translation>el escáner se niega a enviar escaneos: %1</translation></message>
<message><source>check what else uses it</source><translation>compruebe qué más lo usa</translation></message>
<message><source>no scan for %1</source><translation>ningún escaneo en %1</translation></message>
<message><source>check the cable and whether the scanner's mirror turns</source><translation>compruebe el cable y que el espejo del escáner gire</translation></message>
<message><source>A telegram came late and was put into its line</source><translation>Un telegrama llegó tarde y se puso en su línea</translation></message>
<message><source>telegrams came late and were put into their lines</source><translation>telegramas llegaron tarde y se pusieron en sus líneas</translation></message>
<message><source>A telegram came after its sweep had ended</source><translation>Un telegrama llegó después del final de su barrido</translation></message>
<message><source>telegrams came after their sweep had ended</source><translation>telegramas llegaron después del final de su barrido</translation></message>
<message><source>: not used</source><translation>: no se usó</translation></message>
<message><source>A telegram had other beams than the sweep, or was of another layer of the scanner</source><translation>Un telegrama tenía otros haces que el barrido, o era de otra capa del escáner</translation></message>
<message><source>telegrams had other beams than the sweep, or were of another layer of the scanner</source><translation>telegramas tenían otros haces que el barrido, o eran de otra capa del escáner</translation></message>
<message><source>: no lines of this sweep</source><translation>: no son líneas de este barrido</translation></message>
<message><source>A telegram held no ranges</source><translation>Un telegrama no contenía distancias</translation></message>
<message><source>telegrams held no ranges</source><translation>telegramas no contenían distancias</translation></message>
<message><source>: their lines are lost</source><translation>: sus líneas se han perdido</translation></message>
<message><source>The scanner's counters jumped ahead once</source><translation>Los contadores del escáner saltaron hacia delante una vez</translation></message>
<message><source>times the scanner's counters jumped ahead</source><translation>veces los contadores del escáner saltaron hacia delante</translation></message>
<message><source>, by more lines than its clock allows: whether lines were lost there is not known</source><translation>, más líneas de las que permite su reloj: no se sabe si allí se perdieron líneas</translation></message>
<message><source>One of the scanner's counters was set back</source><translation>Uno de los contadores del escáner se atrasó</translation></message>
<message><source>times one of the scanner's counters was set back</source><translation>veces se atrasó uno de los contadores del escáner</translation></message>
<message><source>: lost lines there are counted by the other one and the clock</source><translation>: las líneas perdidas de ahí se cuentan por el otro y el reloj</translation></message>
<message><source>The scanner's counters stood still for a line</source><translation>Los contadores del escáner se pararon durante una línea</translation></message>
<message><source>times the scanner's counters stood still from line to line</source><translation>veces los contadores del escáner se pararon de una línea a otra</translation></message>
<message><source>: lost lines cannot be counted there</source><translation>: ahí no se pueden contar las líneas perdidas</translation></message>
<message><source>The scanner's clock was set while its counters ran on</source><translation>El reloj del escáner se ajustó mientras sus contadores seguían</translation></message>
<message><source>times the scanner's clock was set while its counters ran on</source><translation>veces el reloj del escáner se ajustó mientras sus contadores seguían</translation></message>
<message><source>: the times of lines there are reckoned</source><translation>: las horas de las líneas de ahí son calculadas</translation></message>
<message><source>The scanner's clock stood still for a line</source><translation>El reloj del escáner se paró durante una línea</translation></message>
<message><source>times the scanner's clock stood still from line to line</source><translation>veces el reloj del escáner se paró de una línea a otra</translation></message>
<message><source>The scanner paused for more than a second</source><translation>El escáner hizo una pausa de más de un segundo</translation></message>
<message><source>times the scanner paused for more than a second</source><translation>veces el escáner hizo una pausa de más de un segundo</translation></message>
<message><source>, and its counters know of no lost line</source><translation>, y sus contadores no conocen ninguna línea perdida</translation></message>
<message><source>The scanner restarted</source><translation>El escáner se reinició</translation></message>
<message><source>times the scanner restarted</source><translation>veces se reinició el escáner</translation></message>
<message><source>: lines lost meanwhile are counted by this computer's clock</source><translation>: las líneas perdidas entretanto se cuentan por el reloj de esta computadora</translation></message>
<message><source>A telegram brought other echoes than the first one</source><translation>Un telegrama trajo otros ecos que el primero</translation></message>
<message><source>telegrams brought other echoes than the first one</source><translation>telegramas trajeron otros ecos que el primero</translation></message>
<message><source>: their ranges may be of another echo</source><translation>: sus distancias pueden ser de otro eco</translation></message>
<message><source>The telegrams come from another scanner</source><translation>Los telegramas vienen de otro escáner</translation></message>
<message><source>times the telegrams came from another scanner</source><translation>veces los telegramas vinieron de otro escáner</translation></message>
<message><source>: the sweep is not of one device</source><translation>: el barrido no es de un solo aparato</translation></message>
<message><source>A line was lost between two sweeps</source><translation>Una línea se perdió entre dos barridos</translation></message>
<message><source>lines were lost between two sweeps</source><translation>líneas se perdieron entre dos barridos</translation></message>
<message><source> (first at line </source><translation> (primero en la línea </translation></message>
<message><source> (%1 by the counters)</source><translation> (%1 según los contadores)</translation></message>
<message><source>the recording computer's clock, carried on by the scanner's</source><translation>el reloj del ordenador que grabó, continuado por el del escáner</translation></message>
<message><source> from line %1 on</source><translation> desde la línea %1</translation></message>
<message><source>window too dirty to measure through</source><translation>ventana demasiado sucia para medir a través</translation></message>
<message><source>dirty window</source><translation>ventana sucia</translation></message>
<message><source>none reported</source><translation>ninguna comunicada</translation></message>
<message><source>first echo that the scanner sent</source><translation>primer eco que envió el escáner</translation></message>
<message><source>last echo that the scanner sent</source><translation>último eco que envió el escáner</translation></message>
<message><source>, the motor turning on while a line is measured)</source><translation>, el motor sigue girando mientras se mide una línea)</translation></message>
<message><source>%1. Give %2 where that is wrong.</source><translation>%1. Indique %2 donde eso no sea correcto.</translation></message>
<message><source>lines %1 and others</source><translation>líneas %1 y otras</translation></message>
<message><source>lines %1</source><translation>líneas %1</translation></message>
<message><source>The encoder count of the first line received is taken as the first angle of the sweep.</source><translation>La cuenta del codificador en la primera línea recibida se toma como primer ángulo del barrido.</translation></message>
<message><source>The first line received is taken as line 0 of the sweep.</source><translation>La primera línea recibida se toma como línea 0 del barrido.</translation></message>
<message><source>Telegrams were lost: %1 (%2 in all).</source><translation>Se perdieron telegramas: %1 (%2 en total).</translation></message>
<message><source>Telegrams had fewer beams than the sweep, the others are lost: %1 (%2 in all).</source><translation>Algunos telegramas tenían menos haces que el barrido, los demás se perdieron: %1 (%2 en total).</translation></message>
<message><source>The line angles are computed from time alone: a change of speed bends the cloud.</source><translation>Los ángulos de las líneas se calculan solo con el tiempo: un cambio de velocidad curva la nube.</translation></message>
<message><source>The telegrams carry encoder counts, but the number of counts per degree was not given: angles do not follow them.</source><translation>Los telegramas llevan cuentas del codificador, pero no se indicó cuántas hay por grado: los ángulos no las siguen.</translation></message>
<message><source>The scanner lost its encoder count when it restarted: the line angles after that are computed.</source><translation>El escáner perdió la cuenta del codificador al reiniciarse: los ángulos de las líneas siguientes se calculan.</translation></message>
<message><source> (from line %1 on).</source><translation> (desde la línea %1).</translation></message>
<message><source>The scanner reported an error or was not ready</source><translation>El escáner comunicó un error o no estaba listo</translation></message>
<message><source>The scanner reported a window too dirty to measure through</source><translation>El escáner comunicó una ventana demasiado sucia para medir</translation></message>
<message><source>The scanner reported a dirty window</source><translation>El escáner comunicó una ventana sucia</translation></message>
</context>
</TS>
