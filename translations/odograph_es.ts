<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>AccuracyLayer</name>
    <message>
        <source>expected ±, hatched: not visible</source>
        <translation>± previsto; rayado: no se ve</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>AnalysisWords</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>started %1 earlier</source>
        <translation>iniciada %1 antes</translation>
    </message>
    <message>
        <source>started %1 later</source>
        <translation>iniciada %1 después</translation>
    </message>
    <message>
        <source>Kalman/RTS, noise from the data</source>
        <translation>Kalman/RTS, ruido según los datos</translation>
    </message>
    <message>
        <source>Savitzky–Golay, cubic, 11 points</source>
        <translation>Savitzky–Golay, cúbico, 11 puntos</translation>
    </message>
    <message>
        <source>differences as in Tracker</source>
        <translation>diferencias como en Tracker</translation>
    </message>
    <message>
        <source>none: raw differences</source>
        <translation>ninguno: diferencias directas</translation>
    </message>
    <message>
        <source>%1, set by hand</source>
        <translation>%1, según se indicó a mano</translation>
    </message>
    <message>
        <source>synchronised to %1 by the motion; %2</source>
        <translation>sincronizada a %1 por el movimiento; %2</translation>
    </message>
    <message>
        <source>synchronised to %1 by a flash of light; %2</source>
        <translation>sincronizada a %1 por un destello de luz; %2</translation>
    </message>
    <message>
        <source>synchronised to %1 by the cameras&apos; time stamps; %2</source>
        <translation>sincronizada a %1 por las marcas de tiempo de las cámaras; %2</translation>
    </message>
    <message>
        <source>assumed to start at the same time</source>
        <translation>se supone iniciada a la vez</translation>
    </message>
    <message>
        <source>, clock %1 ppm fast</source>
        <translation>, su reloj adelanta %1 ppm</translation>
    </message>
    <message>
        <source>, clock %1 ppm slow</source>
        <translation>, su reloj atrasa %1 ppm</translation>
    </message>
    <message>
        <source>%1 to %2 ms apart</source>
        <translation>separadas de %1 a %2 ms</translation>
    </message>
    <message>
        <source>synchronised to %1 by sound; %2</source>
        <translation>sincronizada a %1 por el sonido; %2</translation>
    </message>
</context>
<context>
    <name>AnnotatedFrame</name>
    <message>
        <source>slow motion %1×</source>
        <translation>cámara lenta %1×</translation>
    </message>
    <message>
        <source>This camera was not recording at this time</source>
        <translation>Esta cámara no estaba grabando en este momento</translation>
    </message>
    <message>
        <source>This frame cannot be decoded</source>
        <translation>Esta imagen no se puede decodificar</translation>
    </message>
</context>
<context>
    <name>Certificate</name>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Vector velocidad</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Vector aceleración</translation>
    </message>
    <message>
        <source>Amount of acceleration</source>
        <translation>Módulo de la aceleración</translation>
    </message>
    <message>
        <source>Cameras: %1</source>
        <translation>Cámaras: %1</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Robot: %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>Tarea: %1</translation>
    </message>
    <message>
        <source>along the course of the task</source>
        <translation>a lo largo del recorrido de la tarea</translation>
    </message>
    <message>
        <source>over the floor that the cameras see: straight, a curve, stop and go</source>
        <translation>sobre el suelo que ven las cámaras: recta, curva, paradas y arranques</translation>
    </message>
    <message>
        <source>The views of each camera were rendered with its lens, position, image size and frame rate, written as videos, and imported, synchronised, tracked and analysed as any others.</source>
        <translation>La vista de cada cámara se generó con su lente, posición, tamaño de imagen y frecuencia, se escribió como video y se importó, sincronizó, siguió y analizó como cualquier otro.</translation>
    </message>
    <message>
        <source>A simulation shows what this geometry and this program can do, not what a certain recording did. It has even light, a still camera, a clean floor with the markers, sensor noise of 2 of 255 and an exposure of 8 ms at most, and a robot of simple solids in its colour and size.</source>
        <translation>Una simulación muestra lo que pueden esta geometría y este programa, no lo que logró una grabación concreta. Tiene luz uniforme, una cámara quieta, un suelo limpio con los marcadores, ruido del sensor de 2 de 255, una exposición de 8 ms como máximo y un robot de sólidos simples de su color y tamaño.</translation>
    </message>
    <message>
        <source>It does not cover flicker, reflections, deep shadows and people in the view; the look of the real robot, cables and hands; a camera that was moved; markers that were measured wrongly; rolling shutters; and errors of lens calibration and registration beyond the stated ones.</source>
        <translation>No abarca parpadeos, reflejos, sombras profundas ni personas en la vista; el aspecto del robot real, cables y manos; una cámara que se movió; marcadores mal medidos; obturadores rodantes; ni errores de la calibración de la lente y del registro mayores que los declarados.</translation>
    </message>
    <message>
        <source>The verdict on a trial says which of these were noticed in its recording.</source>
        <translation>El veredicto de un ensayo dice cuáles de ellos se notaron en su grabación.</translation>
    </message>
    <message>
        <source>The known run from above</source>
        <translation>El recorrido conocido visto desde arriba</translation>
    </message>
    <message>
        <source>dashed: truth; strokes: errors of all runs, enlarged %1 times</source>
        <translation>discontinua: verdad; trazos: errores de todos los recorridos, ampliados %1 veces</translation>
    </message>
    <message>
        <source>root mean square</source>
        <translation>media cuadrática</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95 % por debajo de</translation>
    </message>
    <message>
        <source>stated ± (σ)</source>
        <translation>± declarado (σ)</translation>
    </message>
    <message>
        <source>truth inside the stated 95 %</source>
        <translation>verdad dentro del 95 % declarado</translation>
    </message>
    <message>
        <source>Errors against the truth</source>
        <translation>Errores respecto a la verdad</translation>
    </message>
    <message>
        <source>%1 of %2 frames have a result</source>
        <translation>%1 de %2 fotogramas tienen resultado</translation>
    </message>
    <message>
        <source>Certificate of this set-up</source>
        <translation>Certificado de este montaje</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Error de posición</translation>
    </message>
    <message>
        <source>Velocity error</source>
        <translation>Error de velocidad</translation>
    </message>
    <message>
        <source>Acceleration error</source>
        <translation>Error de aceleración</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Cobertura</translation>
    </message>
    <message>
        <source>true positions inside the stated 95 %</source>
        <translation>posiciones verdaderas dentro del 95 % declarado</translation>
    </message>
    <message>
        <source>What was simulated</source>
        <translation>Qué se simuló</translation>
    </message>
    <message>
        <source>What a simulation does not cover</source>
        <translation>Qué no abarca una simulación</translation>
    </message>
    <message>
        <source>%1, error in %2</source>
        <translation>%1, error en %2</translation>
    </message>
    <message>
        <source>a line for each run; dashed: what the first states for 95 %</source>
        <translation>una línea por recorrido; discontinua: lo que el primero declara para el 95 %</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Fotogramas</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>σ on the floor</source>
        <translation>σ en el suelo</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>calibrada</translation>
    </message>
    <message>
        <source>estimated from the floor</source>
        <translation>estimada a partir del suelo</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supuesta</translation>
    </message>
    <message>
        <source>The views were synchronised by the motion, to %1 ms at worst.</source>
        <translation>Las vistas se sincronizaron por el movimiento, a %1 ms en el peor caso.</translation>
    </message>
    <message>
        <source>Certificate of this set-up: errors over time</source>
        <translation>Certificado de este montaje: errores en el tiempo</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>The cameras</source>
        <translation>Las cámaras</translation>
    </message>
    <message numerus="yes">
        <source>%n simulated run(s) of %1 s and %2 at up to %3, %4.</source>
        <translation>
            <numerusform>%n recorrido simulado de %1 s y %2 a un máximo de %3, %4.</numerusform>
            <numerusform>%n recorridos simulados de %1 s y %2 a un máximo de %3, %4.</numerusform>
        </translation>
    </message>
    <message>
        <source>Lens calibration</source>
        <translation>Lo que se sabe de la lente</translation>
    </message>
    <message>
        <source>Simulated %1, Odograph %2. All errors are against the known truth of the simulation.</source>
        <translation>Simulado: %1, Odograph %2. Todos los errores son respecto a la verdad conocida de la simulación.</translation>
    </message>
    <message>
        <source>In each run the cameras are a little off from where the project has them, drawn from the stated uncertainty of their registration and lens calibration; so the errors include it.</source>
        <translation>En cada recorrido las cámaras están un poco desviadas de donde indica el proyecto, según la incertidumbre declarada de su registro y de la calibración de la lente; los errores la incluyen.</translation>
    </message>
</context>
<context>
    <name>ClassReport</name>
    <message>
        <source>Rank: one more than the number of significantly better teams (medians differ by more than 1.96 σ). Teams of the same rank do not differ significantly.</source>
        <translation>Puesto: uno más que el número de equipos mejores sin lugar a dudas (medianas separadas más de 1,96 σ); los equipos de un mismo puesto no se pueden distinguir.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them.</source>
        <translation>
            <numerusform>%n ensayo omitido: se midió con otro circuito; vuelva a medirlo.</numerusform>
            <numerusform>%n ensayos omitidos: se midieron con otro circuito; vuelva a medirlos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2 · Odograph %3</source>
        <translation>Página %1 de %2 · Odograph %3</translation>
    </message>
    <message>
        <source>Odograph %1</source>
        <translation>Odograph %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>Tarea: %1</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>según %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>Teams</source>
        <translation>Equipos</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Mejor</translation>
    </message>
    <message>
        <source>Median of all runs</source>
        <translation>Mediana de todos los recorridos</translation>
    </message>
    <message>
        <source>Middle half of the runs</source>
        <translation>Mitad central de los recorridos</translation>
    </message>
    <message>
        <source>The teams</source>
        <translation>Los equipos</translation>
    </message>
    <message>
        <source>each run is a dot; the line is the median of the team</source>
        <translation>cada recorrido es un punto; la línea es la mediana del equipo</translation>
    </message>
    <message>
        <source>#</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>Over the term</source>
        <translation>Durante el periodo</translation>
    </message>
    <message>
        <source>Its trials</source>
        <translation>Sus ensayos</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>Class: %1</source>
        <translation>Clase: %1</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Puesto</translation>
    </message>
    <message numerus="yes">
        <source>of %n team(s)</source>
        <translation>
            <numerusform>de %n equipo</numerusform>
            <numerusform>de %n equipos</numerusform>
        </translation>
    </message>
    <message>
        <source>class median %1</source>
        <translation>mediana clase: %1</translation>
    </message>
    <message>
        <source>Spread of one run</source>
        <translation>Dispersión de un recorrido</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>%n ensayo no contado: resultados malos.</numerusform>
            <numerusform>%n ensayos no contados: resultados malos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! %n ensayo con resultados dudosos contado.</numerusform>
            <numerusform>! %n ensayos con resultados dudosos contados.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ComparisonExplanation</name>
    <message>
        <source>No difference.</source>
        <translation>No hay diferencia.</translation>
    </message>
    <message>
        <source>Both values are exact: any difference is real.</source>
        <translation>Ambos son exactos, de modo que cualquier diferencia es real.</translation>
    </message>
    <message>
        <source>%1 σ, above 1.96: without a real difference, chance would give this much in fewer than 5 of 100 cases.</source>
        <translation>Es de %1 σ, más de 1,96: si no hubiera diferencia, el azar daría una así en menos de 5 de cada 100 casos.</translation>
    </message>
    <message>
        <source>%1 σ, not above 1.96: the difference is not significant.</source>
        <translation>Es de %1 σ, no más de 1,96: queda dentro del error, así que no se puede afirmar ninguna diferencia.</translation>
    </message>
    <message>
        <source>along the task&apos;s reference path</source>
        <translation>a lo largo de la trayectoria de referencia de la tarea</translation>
    </message>
    <message>
        <source>along the path of %1</source>
        <translation>a lo largo del camino de %1</translation>
    </message>
    <message>
        <source>time 0: each passes the start gate</source>
        <translation>tiempo 0: cada uno pasa la puerta de salida</translation>
    </message>
    <message>
        <source>time 0: each begins to move</source>
        <translation>tiempo 0: cada uno empieza a moverse</translation>
    </message>
    <message>
        <source>time 0: each first reaches the same point of the path</source>
        <translation>tiempo 0: cada uno llega por primera vez al mismo lugar del camino</translation>
    </message>
    <message>
        <source>time 0: set by hand, to one frame</source>
        <translation>tiempo 0: indicado a mano, con precisión de un fotograma</translation>
    </message>
    <message>
        <source>both with the same registrations and robot shape: the calibration uncertainty is common, so only its difference counts</source>
        <translation>ambos con los mismos registros y para el mismo sólido: lo que añade la calibración es común y solo cuenta su diferencia</translation>
    </message>
    <message>
        <source>different registrations or robot shapes: the calibration uncertainty counts in full for both</source>
        <translation>no con los mismos registros o no para el mismo sólido: lo que añade la calibración cuenta por completo para ambos</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>%1: %2 minus %3</source>
        <translation>%1: %2 menos %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>only one of the two runs has it</source>
        <translation>solo uno de los dos lo tiene</translation>
    </message>
    <message>
        <source>the value of %1 minus that of %2</source>
        <translation>el indicador de %1 menos el de %2</translation>
    </message>
    <message>
        <source>Each: %1</source>
        <translation>Cada uno: %1</translation>
    </message>
    <message>
        <source>√(σ₁² + σ₂²), treated as independent; where the runs share their calibration, its scale uncertainty counts only for the difference</source>
        <translation>√(σ₁² + σ₂²), ambos como independientes; si los recorridos comparten la calibración, el error de escala de esta aporta solo su parte de la diferencia</translation>
    </message>
    <message>
        <source>not visible at one end</source>
        <translation>no visto en un extremo</translation>
    </message>
    <message>
        <source>Sector %1 to %2: %3 minus %4</source>
        <translation>Sector de %1 a %2: %3 menos %4</translation>
    </message>
    <message>
        <source>begin</source>
        <translation>inicio</translation>
    </message>
    <message>
        <source>end</source>
        <translation>fin</translation>
    </message>
    <message>
        <source>For each run, the time from its first arrival at one gate to its first arrival at the next, by its position along the common path; waiting counts.</source>
        <translation>El tiempo desde la primera llegada a una puerta hasta la primera llegada a la siguiente, en cada recorrido, según su lugar en la trayectoria común; las esperas cuentan.</translation>
    </message>
    <message>
        <source>of each arrival: σ of the position along the path divided by the speed; displacements at two gates count as independent</source>
        <translation>de cada llegada: σ de la posición a lo largo de la trayectoria dividida por la velocidad; los desplazamientos en dos puertas cuentan como independientes</translation>
    </message>
    <message>
        <source>from %1 to %2 along the path</source>
        <translation>de %1 a %2 del camino</translation>
    </message>
    <message>
        <source>Δt of %1 against %2 at %3</source>
        <translation>Δt de %1 frente a %2 en %3</translation>
    </message>
    <message>
        <source>The time of the first arrival at this point of the common path, each from its own time 0: that of %1 minus that of %2. Positive means later.</source>
        <translation>El tiempo de la primera llegada a este lugar de la trayectoria común, cada uno desde su propio tiempo 0: el de %1 menos el de %2. Por encima de 0 llega más tarde.</translation>
    </message>
    <message>
        <source>of both arrivals: σ of the position along the path divided by the speed, and of both times 0</source>
        <translation>de ambas llegadas: σ de la posición a lo largo de la trayectoria dividida por la velocidad, y de ambos tiempos 0</translation>
    </message>
    <message>
        <source>Speed of %1 at %2</source>
        <translation>Velocidad de %1 en %2</translation>
    </message>
    <message>
        <source>|v| of the smoothed curve where the run first reaches this point of the common path, interpolated between frames</source>
        <translation>|v| de la curva suavizada donde el recorrido llega por primera vez a este lugar de la trayectoria común, interpolada entre fotogramas</translation>
    </message>
    <message>
        <source>σ of the smoothed velocity there, including the calibration&apos;s scale uncertainty</source>
        <translation>σ del vector velocidad suavizado allí, con el error de escala de la calibración</translation>
    </message>
    <message>
        <source>none: a run was not measured all the time, and is at least so large</source>
        <translation>ninguna: una vuelta no se midió todo el tiempo y es al menos así de grande</translation>
    </message>
</context>
<context>
    <name>ComparisonReport</name>
    <message>
        <source>± one σ; grey, ≈: not significant</source>
        <translation>± una σ; gris, ≈: dentro del error</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierdo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecho</translation>
    </message>
    <message>
        <source>right − left</source>
        <translation>derecho − izquierdo</translation>
    </message>
    <message>
        <source>along the task’s path</source>
        <translation>a lo largo de la trayectoria de la tarea</translation>
    </message>
    <message>
        <source>along the path of the left run</source>
        <translation>a lo largo del camino del recorrido izquierdo</translation>
    </message>
    <message>
        <source>aligned by the start gate, %1</source>
        <translation>alineados por la puerta de salida, %1</translation>
    </message>
    <message>
        <source>aligned by the onset of motion, %1</source>
        <translation>alineados por el inicio del movimiento, %1</translation>
    </message>
    <message>
        <source>aligned by a point that both pass, %1</source>
        <translation>alineados por un lugar por el que ambos pasan, %1</translation>
    </message>
    <message>
        <source>aligned by hand, %1</source>
        <translation>alineados a mano, %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>Tarea: %1</translation>
    </message>
    <message>
        <source>%1: analysed %2, Odograph %3</source>
        <translation>%1: analizado %2, Odograph %3</translation>
    </message>
    <message>
        <source>Both runs share their calibration: its uncertainty largely cancels.</source>
        <translation>Ambos recorridos comparten la calibración: su error se cancela en la medida en que la comparten.</translation>
    </message>
    <message>
        <source>The runs have different calibrations: the uncertainties of both count.</source>
        <translation>Los recorridos no comparten la calibración: cuentan los errores de ambas.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>Speed over distance, %1</source>
        <translation>Velocidad a lo largo del camino, %1</translation>
    </message>
    <message>
        <source>with its ±95 % band</source>
        <translation>con su banda de ±95 %</translation>
    </message>
    <message>
        <source>Time difference, s</source>
        <translation>Diferencia de tiempo, s</translation>
    </message>
    <message>
        <source>above 0: the right run is later; grey: not significant</source>
        <translation>por encima de 0: el recorrido derecho llega más tarde; gris: dentro del error</translation>
    </message>
    <message>
        <source>Sectors, s</source>
        <translation>Sectores, s</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Indicadores</translation>
    </message>
    <message>
        <source>Verdict on %1: %2</source>
        <translation>Veredicto de %1: %2</translation>
    </message>
</context>
<context>
    <name>Conflict</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tareas</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Etiquetas</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>Destacados</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>Archivado</translation>
    </message>
    <message>
        <source>In the bin</source>
        <translation>En la papelera</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>Miembros</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>Seudónimo</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation>Análisis</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Indicadores</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Puertas</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>Zonas</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>(oculto)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>Measured values</source>
        <translation>Valores medidos</translation>
    </message>
    <message>
        <source>this version</source>
        <translation>esta versión</translation>
    </message>
    <message>
        <source>another version</source>
        <translation>otra versión</translation>
    </message>
</context>
<context>
    <name>Explanation</name>
    <message>
        <source>smoothed by Kalman filter and RTS smoother, noise by maximum likelihood (Rauch, Tung, Striebel 1965; Bar-Shalom et al. 2001)</source>
        <translation>suavizado con filtro de Kalman y suavizador RTS, ruido por máxima verosimilitud (Rauch, Tung, Striebel 1965; Bar-Shalom et al. 2001)</translation>
    </message>
    <message>
        <source>smoothed by a cubic through eleven points (Savitzky and Golay 1964)</source>
        <translation>suavizado con una cúbica por once puntos (Savitzky y Golay 1964)</translation>
    </message>
    <message>
        <source>differences as in Tracker, positions not smoothed</source>
        <translation>diferencias como en Tracker, posiciones sin suavizar</translation>
    </message>
    <message>
        <source>raw differences (Park 2018, eq. 6 to 8), nothing smoothed</source>
        <translation>diferencias directas (Park 2018, ec. 6 a 8), nada suavizado</translation>
    </message>
    <message>
        <source>robot %1 high (estimated)</source>
        <translation>robot de %1 de alto (estimado)</translation>
    </message>
    <message>
        <source>robot %1 high</source>
        <translation>robot de %1 de alto</translation>
    </message>
    <message>
        <source>analysis %1 by Odograph %2</source>
        <translation>análisis %1 con Odograph %2</translation>
    </message>
    <message>
        <source>σ of the smoothed velocity there, including the calibration&apos;s scale uncertainty</source>
        <translation>σ del vector velocidad suavizado allí, con el error de escala de la calibración</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>|v| = √(vx² + vy²) of the smoothed curve at this frame</source>
        <translation>|v| = √(vx² + vy²) de la curva suavizada en este fotograma</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>a·v/|v| of the smoothed curve at this frame: along the path, negative when braking; |a| while the robot stands still</source>
        <translation>a·v/|v| de la curva suavizada en este fotograma: a lo largo de la trayectoria, de modo que al frenar es negativa; |a| mientras está quieto</translation>
    </message>
    <message>
        <source>σ of the smoothed acceleration there, including the calibration&apos;s scale uncertainty</source>
        <translation>σ de la aceleración suavizada allí, con el error de escala de la calibración</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Rumbo</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Velocidad de giro</translation>
    </message>
    <message>
        <source>Position X</source>
        <translation>Posición X</translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation>Posición Y</translation>
    </message>
    <message>
        <source>the smoothed curve at this frame</source>
        <translation>la curva suavizada en este fotograma</translation>
    </message>
    <message>
        <source>σ of the smoothed position, including the calibration&apos;s part</source>
        <translation>σ de la posición suavizada, con la parte de la calibración</translation>
    </message>
    <message>
        <source>no view found the robot in this frame: the curve bridges the gap</source>
        <translation>en este fotograma ninguna vista encontró el robot: la curva puentea el hueco</translation>
    </message>
    <message>
        <source>measured there: %1, %2 ±%3</source>
        <translation>medido allí: %1, %2 ±%3</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>por %1</translation>
    </message>
    <message>
        <source>it is flagged and not used: the curve follows its neighbours</source>
        <translation>está señalada y no se usa: la curva sale de las muestras vecinas</translation>
    </message>
    <message>
        <source>Jump: the position does not fit the motion before and after (χ² with two degrees of freedom, 99.9 %).</source>
        <translation>Salto: la posición está fuera de lo que admite el movimiento anterior y posterior (χ² con dos grados de libertad, 99,9 %).</translation>
    </message>
    <message>
        <source>Limit: to get there, the robot had to exceed the speed limit of the task or of the analysis.</source>
        <translation>Límite: para llegar allí tuvo que ir más rápido que el límite de la tarea o del análisis.</translation>
    </message>
    <message>
        <source>Limit: to get there, the robot had to exceed the acceleration limit of the task or of the analysis.</source>
        <translation>Límite: para llegar allí tuvo que acelerar más que el límite de la tarea o del análisis.</translation>
    </message>
    <message>
        <source>Views disagree: their floor positions differ by more than their uncertainty and their usual disagreement explain (χ², 99.9 %).</source>
        <translation>Las vistas discrepan: sus posiciones difieren más de lo que explican sus errores y su discrepancia habitual (χ², 99,9 %).</translation>
    </message>
    <message>
        <source>Low score: the tracker was not sure of what it saw.</source>
        <translation>Confianza baja: el rastreador no estaba seguro de lo que veía.</translation>
    </message>
    <message>
        <source>Lost: no view found the robot.</source>
        <translation>Perdido: ninguna vista encontró el robot.</translation>
    </message>
    <message>
        <source>Repeated frame: the camera delivered the same frame twice, so its time is unknown.</source>
        <translation>Imagen repetida: la cámara dio dos veces la misma imagen, así que no se conoce su tiempo.</translation>
    </message>
    <message>
        <source>Bridged: the curve crosses a gap without measurements.</source>
        <translation>Puenteado: la curva pasa sin medición.</translation>
    </message>
    <message>
        <source>By hand: a manual override replaces the result of the analysis.</source>
        <translation>A mano: lo decidió una persona, por encima del análisis.</translation>
    </message>
    <message>
        <source>How it is computed</source>
        <translation>Cómo se calcula</translation>
    </message>
    <message>
        <source>What ± contains (one standard deviation)</source>
        <translation>Qué contiene ± (una desviación estándar)</translation>
    </message>
    <message>
        <source>What went into it</source>
        <translation>Con qué se calculó</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Fuente</translation>
    </message>
    <message>
        <source>trial %1, robot %2</source>
        <translation>ensayo %1, robot %2</translation>
    </message>
    <message>
        <source>%1 of %2 samples used</source>
        <translation>%1 de %2 muestras usadas</translation>
    </message>
    <message>
        <source>views: %1</source>
        <translation>vistas: %1</translation>
    </message>
    <message>
        <source>%1: from %2 to %3, at most %4 beyond the edge</source>
        <translation>%1: de %2 a %3, rebasa el borde en %4 como máximo</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 a los %2</translation>
    </message>
    <message>
        <source>Spike at %1</source>
        <translation>Valor atípico a los %1</translation>
    </message>
    <message>
        <source>The sample is kept, but not used for the curve.</source>
        <translation>La muestra se conserva, pero no se usa para la curva.</translation>
    </message>
    <message>
        <source>The curve uses the sample nevertheless: its faulty part was left out, or a manual override restored it.</source>
        <translation>La muestra se usa para la curva de todos modos: se descartó lo que tiene de erróneo o una persona la restauró.</translation>
    </message>
    <message>
        <source>the views&apos; floor positions differ by %1 there</source>
        <translation>las vistas distan %1 allí</translation>
    </message>
    <message>
        <source>Of the body where its outline or an imported track shows it: the smoothed heading. Elsewhere the direction of motion: atan2(vy, vx) of the smoothed curve, kept where the robot stands still and continued where it reverses. Anticlockwise from X, without jumps of a whole turn.</source>
        <translation>El del cuerpo donde su contorno o una trayectoria importada lo muestra: el rumbo suavizado. En lo demás, la dirección del movimiento: atan2(vy, vx) de la curva suavizada, conservada donde el robot está parado y continuada donde va marcha atrás. En sentido antihorario desde X, sin saltos de una vuelta completa.</translation>
    </message>
    <message>
        <source>of the body: σ of its smoothed heading; of the direction of motion: σ of the velocity across the motion divided by the speed</source>
        <translation>del cuerpo: σ de su rumbo suavizado; de la dirección del movimiento: σ del vector velocidad en dirección transversal al movimiento, dividida por la velocidad</translation>
    </message>
    <message>
        <source>Of the body where its heading was measured: the rate of the smoothed heading. Elsewhere (vx·ay − vy·ax)/|v|² of the smoothed curve.</source>
        <translation>La del cuerpo donde se midió su rumbo: la variación del rumbo suavizado. En lo demás, (vx·ay − vy·ax)/|v|² de la curva suavizada.</translation>
    </message>
    <message>
        <source>of the body: σ of the smoothed heading&apos;s rate; of the direction of motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order</source>
        <translation>del cuerpo: σ de la variación del rumbo suavizado; de la dirección del movimiento: σ² = σa²/|v|² + |a|²σv²/|v|⁴, primer orden</translation>
    </message>
    <message>
        <source>of the robot&apos;s body, which was measured</source>
        <translation>del cuerpo del robot, que se midió</translation>
    </message>
    <message>
        <source>of the direction of motion</source>
        <translation>de la dirección del movimiento</translation>
    </message>
    <message>
        <source>Velocity X</source>
        <translation>Velocidad X</translation>
    </message>
    <message>
        <source>Velocity Y</source>
        <translation>Velocidad Y</translation>
    </message>
    <message>
        <source>the velocity of the smoothed curve at this frame along that axis</source>
        <translation>la velocidad de la curva suavizada en este fotograma a lo largo de ese eje</translation>
    </message>
    <message>
        <source>Lateral acceleration</source>
        <translation>Aceleración lateral</translation>
    </message>
    <message>
        <source>(vx·ay − vy·ax)/|v| of the smoothed curve at this frame: across the path, positive to the left</source>
        <translation>(vx·ay − vy·ax)/|v| de la curva suavizada en este fotograma: transversal a la trayectoria, positiva a la izquierda</translation>
    </message>
    <message>
        <source>σ² = σa² + (a·v/|v|)²σv²/|v|², first order: of the acceleration, and of the direction of motion</source>
        <translation>σ² = σa² + (a·v/|v|)²σv²/|v|², primer orden: de la aceleración y de la dirección del movimiento</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Sobreaceleración</translation>
    </message>
    <message>
        <source>(a(t₂) − a(t₁))/(t₂ − t₁) along the path, from the smoothed accelerations half of %1 before and after this frame; its length while the robot stands still</source>
        <translation>(a(t₂) − a(t₁))/(t₂ − t₁) a lo largo de la trayectoria, de las aceleraciones suavizadas la mitad de %1 antes y después de este fotograma; su módulo mientras el robot está parado</translation>
    </message>
    <message>
        <source>σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)², ρ the correlation of both errors</source>
        <translation>σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)², ρ la correlación de ambos errores</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>Distancia recorrida</translation>
    </message>
    <message>
        <source>the integral of the smoothed speed over the time in which the robot moves, up to this frame</source>
        <translation>la integral de la velocidad suavizada en el tiempo en que el robot se mueve, hasta este fotograma</translation>
    </message>
    <message>
        <source>of the positions at the ends of each motion, of errors across the path where it turns, and of the calibration&apos;s scale; without what the robot may have done while it was not measured</source>
        <translation>de las posiciones en los extremos de cada movimiento, de los errores transversales donde la trayectoria gira y de la escala de la calibración; sin lo que el robot haya podido hacer mientras no se medía</translation>
    </message>
    <message>
        <source>Distance from the start</source>
        <translation>Distancia al inicio</translation>
    </message>
    <message>
        <source>the straight line from the first smoothed position to this frame&apos;s</source>
        <translation>la línea recta de la primera posición suavizada a la de este fotograma</translation>
    </message>
    <message>
        <source>of both positions along that line, and of the calibration&apos;s scale</source>
        <translation>de ambas posiciones a lo largo de esa línea y de la escala de la calibración</translation>
    </message>
    <message>
        <source>Distance to the nearest robot</source>
        <translation>Distancia al robot más próximo</translation>
    </message>
    <message>
        <source>between the reference points of both robots at this frame&apos;s time, on the smoothed curves</source>
        <translation>entre los puntos de referencia de ambos robots en el instante de este fotograma, sobre las curvas suavizadas</translation>
    </message>
</context>
<context>
    <name>ExplanationDialog</name>
    <message>
        <source>How was this computed?</source>
        <translation>¿Cómo se calculó esto?</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
</context>
<context>
    <name>FactExplanations</name>
    <message>
        <source>The time offset at which the robot&apos;s floor tracks from the two views coincide: least squares of r(t) = p₁(t) − p₂((t − offset)(1 + rate)), with a constant shift and a small scale between them, searched in steps of half a frame and refined by Gauss–Newton. The clock rate is used if it exceeds three σ.</source>
        <translation>El desfase con el que coinciden las trazas del robot en el suelo, tal como lo ven las dos vistas: mínimos cuadrados de r(t) = p₁(t) − p₂((t − desfase)(1 + deriva)), con un desplazamiento constante y una escala pequeña entre ellas, buscado en medios fotogramas y refinado por Gauss–Newton. La deriva de los relojes se toma en cuenta cuando supera tres σ.</translation>
    </message>
    <message>
        <source>from the curvature of the sum of squares and from the residual, assumed to be correlated over half a second</source>
        <translation>de la curvatura de la suma de cuadrados y del residuo, que se toma como correlacionado durante medio segundo</translation>
    </message>
    <message>
        <source>The time offset at which the jumps in brightness in both views coincide: the weighted mean of the pairs. It is used if every other offset is at least 150 times less likely.</source>
        <translation>El desfase con el que coinciden los saltos de luz que ambas vistas vieron, aceptado si la verosimilitud de cualquier otro desfase es al menos 150 veces menor: la media ponderada de los pares.</translation>
    </message>
    <message>
        <source>from the pairs and their scatter, plus a tenth of a frame interval per view for its shutter</source>
        <translation>de los pares, de su dispersión, y una décima del intervalo entre fotogramas por cada vista, por su obturador</translation>
    </message>
    <message>
        <source>Each camera&apos;s time stamps, converted to this computer&apos;s clock by reading the camera&apos;s clock during the recording.</source>
        <translation>Las marcas de tiempo de cada cámara, referidas al reloj de esta computadora mediante lecturas del de la cámara mientras grababa.</translation>
    </message>
    <message>
        <source>from both clock conversions</source>
        <translation>de ambas relaciones entre los relojes</translation>
    </message>
    <message>
        <source>Times at the gates</source>
        <translation>Tiempos en las puertas</translation>
    </message>
    <message>
        <source>When the robot&apos;s reference point crosses the gate&apos;s line between its ends, in the direction of the gate. Between two frames, the smoothed position is the cubic through both positions and velocities. A passage counts if the point was before the line by three σ of the track&apos;s own noise and then is past it by as much.</source>
        <translation>Cuando el centro del robot cruza la línea de la puerta entre sus extremos, en el sentido en que se pasa la puerta: entre dos fotogramas, la posición suavizada es la cúbica que pasa por ambas posiciones con ambos vectores velocidad. Ha pasado si estuvo antes de la línea en tres σ del ruido propio de la traza y después la rebasa en otro tanto.</translation>
    </message>
    <message>
        <source>σ of the position across the gate divided by the speed across it, including the calibration&apos;s part</source>
        <translation>σ de la posición perpendicular a la puerta dividida por la velocidad perpendicular a ella, con la parte de la calibración</translation>
    </message>
    <message>
        <source>From a passage of the start to one of the finish, or from one passage of a start-finish gate to the next. Of each split, the first passage counts.</source>
        <translation>De un paso por la salida a la meta o, con una sola puerta, de un paso al siguiente; de cada parcial cuenta el primer paso.</translation>
    </message>
    <message>
        <source>from both passages; the calibration&apos;s uncertainty cancels for a gate passed twice at the same speed</source>
        <translation>de ambos pasos; se cancela el error de calibración de una puerta por la que se pasa dos veces a la misma velocidad</translation>
    </message>
    <message>
        <source>to %1: %2</source>
        <translation>hasta %1: %2</translation>
    </message>
    <message>
        <source>Synchronisation of view %1 with the first</source>
        <translation>Vista %1 sincronizada con la primera</translation>
    </message>
    <message>
        <source>video %1, %2 frames</source>
        <translation>video %1, %2 fotogramas</translation>
    </message>
    <message>
        <source>Height of robot %1</source>
        <translation>Altura del robot %1</translation>
    </message>
    <message>
        <source>The solid (box or cylinder, on the floor or a plate at the robot&apos;s top) whose silhouettes best match the outlines in all views, by weighted least squares at about forty times of the run. If no such solid explains them: the height at which all views give the same floor position.</source>
        <translation>El sólido (caja o cilindro sobre el suelo, o una placa en lo alto del robot) cuyas siluetas son los contornos en todas las vistas, por mínimos cuadrados ponderados en unos cuarenta instantes del recorrido; si ningún sólido así los explica, la altura a la que todas las vistas sitúan el robot en el mismo lugar.</translation>
    </message>
    <message>
        <source>The time offset at which claps, knocks or whistles in the sound of both views coincide: the weighted mean of the pairs, less the time that sound takes to reach each camera. It is used if every other offset is at least 150 times less likely.</source>
        <translation>El desfase con el que coinciden las palmadas, los golpes o los silbidos en el sonido de ambas vistas: la media ponderada de los pares, menos el tiempo que el sonido tarda en llegar a cada cámara. Se acepta si cualquier otro desfase es al menos 150 veces menos probable.</translation>
    </message>
    <message>
        <source>from the pairs, from where on the floor the sound may have come, 50 ppm of the time from the start of the recording to the sound, and 2 ms by which each camera may record its sound early or late</source>
        <translation>de los pares, del lugar del suelo del que pudo venir el sonido, 50 ppm del tiempo desde el inicio de la grabación hasta el sonido, y 2 ms que cada cámara puede adelantar o retrasar su sonido</translation>
    </message>
</context>
<context>
    <name>FirstLesson</name>
    <message>
        <source>Play a run</source>
        <translation>Reproducir un recorrido</translation>
    </message>
    <message>
        <source>Two cameras filmed a robot. Press Space: both videos, the map and the curves play together. Press Space again to stop.</source>
        <translation>Dos cámaras observaron cómo se movía un robot. Pulse Espacio: ambos videos, el mapa y las curvas se reproducen sincronizados. Espacio otra vez los detiene.</translation>
    </message>
    <message>
        <source>Read a result</source>
        <translation>Leer un indicador</translation>
    </message>
    <message>
        <source>Click the speed curve. The bubble shows the speed at that moment and its uncertainty (±). The band around the curve contains the true speed in 95 of 100 cases.</source>
        <translation>Haga clic en la curva de velocidad. La burbuja indica la velocidad en ese instante y su ±: cuánto puede desviarse. La banda que rodea la curva contiene el valor verdadero en 95 de cada 100 casos.</translation>
    </message>
    <message>
        <source>Check the flagged samples</source>
        <translation>Mirar lo señalado</translation>
    </message>
    <message>
        <source>Press Ctrl+Page Up or Ctrl+Page Down until the list of spikes on the right is not empty. A spike is a measurement that cannot be true; the list gives the reason.</source>
        <translation>Recorra los ensayos con Ctrl+Re Pág y Ctrl+Av Pág hasta uno cuya lista de valores atípicos, a la derecha, no esté vacía. Un valor atípico es un instante en el que lo medido no puede ser cierto; la lista dice por qué.</translation>
    </message>
    <message>
        <source>Override it</source>
        <translation>Decidir otra cosa</translation>
    </message>
    <message>
        <source>Click a spike in the list and watch the videos: was the robot really there? Press U to use the sample nevertheless. Odograph never deletes a measurement.</source>
        <translation>Haga clic en un valor atípico de la lista y mire los videos: ¿estaba el robot realmente allí? Pulse U para usar la muestra de todos modos. Nada de lo medido se pierde nunca.</translation>
    </message>
    <message>
        <source>Undo it</source>
        <translation>Deshacerlo</translation>
    </message>
    <message>
        <source>Press Ctrl+Z. Odograph saves every change at once, and you can undo it.</source>
        <translation>Pulse Ctrl+Z. Todo cambio se guarda al momento y se puede deshacer.</translation>
    </message>
    <message>
        <source>Compare two runs</source>
        <translation>Comparar dos recorridos</translation>
    </message>
    <message>
        <source>Press Ctrl+4. Choose two runs on the right: where was one faster? Grey differences are not significant.</source>
        <translation>Pulse Ctrl+4. Elija dos recorridos a la derecha: ¿dónde fue más rápido uno, y es eso más que el error? Lo que está en gris no lo es.</translation>
    </message>
    <message>
        <source>Find it again</source>
        <translation>Volver a encontrarlo</translation>
    </message>
    <message>
        <source>Press Ctrl+5. History lists the whole year: type a team&apos;s name to search, press Enter to open a run, and see under Teams who made progress.</source>
        <translation>Pulse Ctrl+5. Historial guarda todo el año: escriba el nombre de un equipo para buscar, abra un recorrido con Intro y vea en Equipos quién ha progresado.</translation>
    </message>
    <message>
        <source>That&apos;s it</source>
        <translation>Eso es todo</translation>
    </message>
    <message>
        <source>For your own robots: create a project (Ctrl+N). Its Start page leads you from the clips of two phones, or from connected cameras, to a first result. F1 explains each page.</source>
        <translation>Con sus propios robots: cree un proyecto (Ctrl+N). Su página Inicio le guía desde los videos de dos teléfonos, o desde cámaras conectadas, hasta un primer resultado. F1 explica cada página.</translation>
    </message>
</context>
<context>
    <name>GuidanceWords</name>
    <message>
        <source>searched</source>
        <translation>buscada</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignorada</translation>
    </message>
    <message>
        <source>%1 marked here</source>
        <translation>%1 marcado aquí</translation>
    </message>
    <message>
        <source>%1 set by hand</source>
        <translation>%1 puesto a mano</translation>
    </message>
    <message>
        <source>no robot visible, by hand</source>
        <translation>ningún robot visible, a mano</translation>
    </message>
    <message>
        <source>%1 not visible, by hand</source>
        <translation>%1 no visible, a mano</translation>
    </message>
</context>
<context>
    <name>HealthWatch</name>
    <message>
        <source>The project is read-only</source>
        <translation>El proyecto es de solo lectura</translation>
    </message>
    <message>
        <source>Opening the cameras…</source>
        <translation>Abriendo las cámaras…</translation>
    </message>
    <message>
        <source>No camera is running</source>
        <translation>No hay cámaras en marcha</translation>
    </message>
    <message>
        <source>No camera sends frames</source>
        <translation>Ninguna cámara envía imágenes</translation>
    </message>
    <message>
        <source>This project is read-only: you cannot record into it.</source>
        <translation>Este proyecto es de solo lectura: no se puede grabar en él.</translation>
    </message>
    <message>
        <source>Register &amp;it in Testbed</source>
        <translation>&amp;Registrarla en Banco</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Keys</source>
        <translation>Atajos</translation>
    </message>
    <message>
        <source>List of keys</source>
        <translation>Lista de atajos</translation>
    </message>
    <message>
        <source>About Odograph</source>
        <translation>Acerca de Odograph</translation>
    </message>
    <message>
        <source>Odograph %1</source>
        <translation>Odograph %1</translation>
    </message>
    <message>
        <source>Measures how a mobile robot moved, from the videos of ordinary cameras.

Free software under the GNU General Public License, version 3 or later, without any warranty.

The method follows S. Park, “Computational Vision for Automatic Tracking and Objective Estimation of Mobile Robot Trajectory”, 2018.</source>
        <translation>Mide cómo se movió un robot móvil a partir de los videos de cámaras corrientes.

Software libre bajo la Licencia Pública General de GNU, versión 3 o posterior, sin garantía alguna.

El método sigue a S. Park, “Computational Vision for Automatic Tracking and Objective Estimation of Mobile Robot Trajectory”, 2018.</translation>
    </message>
</context>
<context>
    <name>HtmlChart</name>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured</source>
        <translation>suavizada, con su banda de ±95 %; puntos: lo medido</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured; shaded: not measured</source>
        <translation>suavizada, con su banda de ±95 %; puntos: lo medido; sombreado: sin medir</translation>
    </message>
    <message>
        <source>Speed, %1</source>
        <translation>Velocidad, %1</translation>
    </message>
    <message>
        <source>Acceleration along the path, %1</source>
        <translation>Aceleración a lo largo de la trayectoria, %1</translation>
    </message>
</context>
<context>
    <name>HtmlMap</name>
    <message>
        <source>a square: %1</source>
        <translation>un cuadro: %1</translation>
    </message>
    <message>
        <source>The run from above</source>
        <translation>El recorrido visto desde arriba</translation>
    </message>
    <message>
        <source>coloured by speed, from 0 (dark) to %1 (light); ring: start, dot: end</source>
        <translation>en color según la velocidad, de 0 (oscuro) a %1 (claro); anillo: inicio, punto: final</translation>
    </message>
    <message>
        <source>Both runs from above</source>
        <translation>Ambos recorridos vistos desde arriba</translation>
    </message>
    <message>
        <source>in the colours of the runs</source>
        <translation>en los colores de los recorridos</translation>
    </message>
</context>
<context>
    <name>HtmlPage</name>
    <message>
        <source>Made by Odograph %1; ± is one standard deviation.</source>
        <translation>Hecho con Odograph %1; ± es una desviación típica.</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>Veredicto: %1</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Indicadores</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>indicador</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidad</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>Parciales</translation>
    </message>
    <message>
        <source>from the start to</source>
        <translation>desde la salida hasta</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Recorrido %1</translation>
    </message>
    <message>
        <source>sector to %1</source>
        <translation>sector hasta %1</translation>
    </message>
    <message>
        <source>No spikes.</source>
        <translation>Sin valores atípicos.</translation>
    </message>
    <message numerus="yes">
        <source>Spikes: %n</source>
        <translation>
            <numerusform>Valores atípicos: %n</numerusform>
            <numerusform>Valores atípicos: %n</numerusform>
        </translation>
    </message>
    <message>
        <source>reason</source>
        <translation>motivo</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>Where this comes from</source>
        <translation>De dónde procede</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>diferencia</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparación</translation>
    </message>
    <message>
        <source>Both runs share their calibration: its uncertainty largely cancels. ≈: not significant.</source>
        <translation>Ambos recorridos comparten su calibración: su incertidumbre se cancela en gran parte. ≈: no significativo.</translation>
    </message>
    <message>
        <source>The runs have different calibrations: the uncertainties of both count. ≈: not significant.</source>
        <translation>Los recorridos tienen calibraciones distintas: cuentan las incertidumbres de ambas. ≈: no significativo.</translation>
    </message>
    <message>
        <source>Speed over distance, %1</source>
        <translation>Velocidad a lo largo del camino, %1</translation>
    </message>
    <message>
        <source>with its ±95 % band</source>
        <translation>con su banda de ±95 %</translation>
    </message>
    <message>
        <source>Time difference, s</source>
        <translation>Diferencia de tiempo, s</translation>
    </message>
    <message>
        <source>above 0: the second run is later; grey: not significant</source>
        <translation>por encima de 0: el segundo recorrido va después; gris: no significativo</translation>
    </message>
    <message>
        <source>Sectors, s</source>
        <translation>Sectores, s</translation>
    </message>
</context>
<context>
    <name>Hub</name>
    <message>
        <source>Connected.</source>
        <translation>Conectado.</translation>
    </message>
    <message>
        <source>Everything had been sent.</source>
        <translation>Ya estaba todo enviado.</translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) sent.</source>
        <translation>
            <numerusform>%n elemento enviado.</numerusform>
            <numerusform>%n elementos enviados.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing new at the hub.</source>
        <translation>No hay nada nuevo en el servidor.</translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) received.</source>
        <translation>
            <numerusform>%n elemento recibido.</numerusform>
            <numerusform>%n elementos recibidos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recordings: %1 copied.</source>
        <translation>Grabaciones: %1 copiados.</translation>
    </message>
    <message numerus="yes">
        <source>%n more warning(s).</source>
        <translation>
            <numerusform>%n advertencia más.</numerusform>
            <numerusform>%n advertencias más.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Teacher: may change everything</source>
        <translation>Docente: puede cambiarlo todo</translation>
    </message>
    <message>
        <source>Bench: publishes its own trials, reads those of others</source>
        <translation>Puesto: publica sus ensayos y lee los de otros</translation>
    </message>
    <message>
        <source>Viewer: reads results only</source>
        <translation>Lector: solo lee resultados</translation>
    </message>
    <message>
        <source>Nothing: all is sent</source>
        <translation>Nada: todo está enviado</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s)</source>
        <translation>
            <numerusform>%n cambio</numerusform>
            <numerusform>%n cambios</numerusform>
        </translation>
    </message>
    <message>
        <source>password needed</source>
        <translation>falta la contraseña</translation>
    </message>
    <message>
        <source>server away</source>
        <translation>sin conexión</translation>
    </message>
    <message>
        <source>not accepted</source>
        <translation>no aceptado</translation>
    </message>
    <message>
        <source>Hub: %1</source>
        <translation>Servidor: %1</translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending, %1</source>
        <translation>
            <numerusform>Servidor: %n pendiente, %1</numerusform>
            <numerusform>Servidor: %n pendientes, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Hub: publishing…</source>
        <translation>Servidor: publicando…</translation>
    </message>
    <message>
        <source>Hub: pulling…</source>
        <translation>Servidor: recibiendo…</translation>
    </message>
    <message>
        <source>Hub: all sent</source>
        <translation>Servidor: todo enviado</translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending</source>
        <translation>
            <numerusform>Servidor: %n pendiente</numerusform>
            <numerusform>Servidor: %n pendientes</numerusform>
        </translation>
    </message>
    <message>
        <source>no answer yet</source>
        <translation>sin respuesta todavía</translation>
    </message>
    <message numerus="yes">
        <source>Hub: publishing, %n pending</source>
        <translation>
            <numerusform>Servidor: publicando, %n pendiente</numerusform>
            <numerusform>Servidor: publicando, %n pendientes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MapPainting</name>
    <message>
        <source>grid %1 %2</source>
        <translation>cuadrícula %1 %2</translation>
    </message>
</context>
<context>
    <name>MatWords</name>
    <message>
        <source>Row %1, sheet %2</source>
        <translation>Fila %1, hoja %2</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>This line is %1 long on the whole mat. Measure it.</source>
        <translation>Esta línea mide %1 en la alfombrilla completa. Mídala.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets. Print at 100 % (actual size). Cut along the dashed lines.</source>
        <translation>Alfombrilla de %1 × %2 hojas. Imprimir al 100 % (tamaño real). Cortar por las líneas discontinuas.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets</source>
        <translation>Alfombrilla de %1 × %2 hojas</translation>
    </message>
    <message>
        <source>1. Print all pages at 100 % (actual size), not fitted to the page.</source>
        <translation>1. Imprima todas las páginas al 100 % (tamaño real), sin ajustarlas a la página.</translation>
    </message>
    <message>
        <source>2. Cut each sheet along its dashed lines. Lay it on its neighbours, up to their thin lines, as drawn below, and tape the sheets together.</source>
        <translation>2. Corte cada hoja por sus líneas discontinuas. Póngala sobre sus vecinas, hasta las líneas finas de estas, como se dibuja abajo, y pegue las hojas entre sí.</translation>
    </message>
    <message>
        <source>3. Measure the line at the lower edge. It should be %1 long; Odograph asks for what you measure.</source>
        <translation>3. Mida la línea del borde inferior. Debería medir %1; Odograph pregunta lo que usted mide.</translation>
    </message>
    <message>
        <source>4. Lay the mat flat where every camera sees all of it. The lower left corner is the origin, the lower edge the x axis.</source>
        <translation>4. Ponga la alfombrilla plana donde cada cámara la vea entera. La esquina inferior izquierda es el origen; el borde inferior, el eje x.</translation>
    </message>
</context>
<context>
    <name>Modes</name>
    <message>
        <source>Testbed</source>
        <translation>Banco</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Revisar</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
</context>
<context>
    <name>OutputQuestion</name>
    <message>
        <source>%1 is a file of another kind. Replace it?</source>
        <translation>%1 es un archivo de otro tipo. ¿Desea sustituirlo?</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 ya existe. ¿Desea sustituirlo?</translation>
    </message>
</context>
<context>
    <name>OwnChanges</name>
    <message>
        <source>Done: %1. Press Ctrl+Z to undo it.</source>
        <translation>Hecho: %1. Ctrl+Z lo revierte.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Deshecho: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Rehecho: %1.</translation>
    </message>
</context>
<context>
    <name>PageMenus</name>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>T&amp;rial</source>
        <translation>En&amp;sayo</translation>
    </message>
    <message>
        <source>&amp;Spikes</source>
        <translation>Atí&amp;picos</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>H&amp;istorial</translation>
    </message>
    <message>
        <source>Re&amp;cord</source>
        <translation>&amp;Grabar</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>Reprodu&amp;cir</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Herramientas</translation>
    </message>
    <message>
        <source>Ran&amp;ge</source>
        <translation>Tra&amp;mo</translation>
    </message>
</context>
<context>
    <name>RangeFacts</name>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>The calibration&apos;s contribution to an angle is unknown and not included.</source>
        <translation>Lo que la calibración añade a un ángulo se desconoce y no está incluido.</translation>
    </message>
    <message>
        <source>Includes the position uncertainty of the calibration.</source>
        <translation>El error de posición de la calibración está incluido.</translation>
    </message>
    <message>
        <source>Includes the scale uncertainty of the calibration.</source>
        <translation>El error de escala de la calibración está incluido.</translation>
    </message>
    <message>
        <source>Neighbouring points of a smoothed curve have correlated errors. They average out over time, not over frames: with a spectrum of r/(1 + (ω/ω₀)⁶) for the position, ω₀ = √2 σv/σx.</source>
        <translation>Los puntos vecinos de una curva suavizada comparten su error, así que este se promedia con el tiempo y no con los fotogramas: con un espectro r/(1 + (ω/ω₀)⁶) para la posición, ω₀ = √2 σv/σx.</translation>
    </message>
    <message>
        <source>From the smoothed curve, each value weighted by half the time to both neighbours: mean; median (the curve is below it half of the time); least and most, chosen by value + 2σ and value − 2σ; spread √(mean of the squared distance from the mean).</source>
        <translation>De la curva suavizada, cada valor con el peso de la mitad del tiempo hasta ambos vecinos: su media, la mediana (la mitad del tiempo queda por debajo), el mínimo y el máximo fuera de duda (por el valor más o menos 2σ) y la dispersión √(media del cuadrado de la distancia a la media).</translation>
    </message>
    <message>
        <source>no value here</source>
        <translation>aquí no hay valor</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 a los %2</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>media</translation>
    </message>
    <message>
        <source>median</source>
        <translation>mediana</translation>
    </message>
    <message>
        <source>least</source>
        <translation>mínimo</translation>
    </message>
    <message>
        <source>most</source>
        <translation>máximo</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>dispersión</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n punto</numerusform>
            <numerusform>%n puntos</numerusform>
        </translation>
    </message>
    <message>
        <source>does not fit: χ² is %1 times what the uncertainties explain</source>
        <translation>no es su forma: χ² es %1 veces lo que explican los errores</translation>
    </message>
    <message>
        <source>fits; the stated uncertainties are too large: χ² is %1 of its expected value</source>
        <translation>encaja; los errores indicados son demasiado grandes: χ² es %1 de lo que hacen esperar</translation>
    </message>
    <message>
        <source>fits: χ² is %1 of its expected value</source>
        <translation>encaja: χ² es %1 de lo que los errores hacen esperar</translation>
    </message>
    <message>
        <source>Fit of %1</source>
        <translation>Ajuste de %1</translation>
    </message>
    <message>
        <source>The polynomial in t − t₀ that minimises Σ(residual/σ)² over %1, t₀ = %2. χ² is that sum divided by its expected value: the number of points minus the degrees of freedom of the coefficients.</source>
        <translation>El polinomio en t − t₀ con el menor Σ(residuo/σ)² sobre %1, t₀ = %2. χ² es esa suma dividida por lo que los errores hacen esperar de ella: el número de puntos menos lo que absorben los coeficientes.</translation>
    </message>
    <message>
        <source>the measured positions used</source>
        <translation>las posiciones medidas que se usan</translation>
    </message>
    <message>
        <source>the smoothed curve</source>
        <translation>la curva suavizada</translation>
    </message>
    <message>
        <source>The larger of two uncertainties: that of the measurements, widened by 1 + 2Σρ for correlated residuals (here ×%1), and that of the smoothed curve, including the errors that persist.</source>
        <translation>El mayor de dos: el de las mediciones, ampliado por 1 + 2Σρ de los residuos donde están correlacionados (aquí ×%1), y el de la curva suavizada, que sabe qué parte de sus errores perdura.</translation>
    </message>
    <message>
        <source>Assumes that the shape is correct; χ² far above 1 shows that it is not. χ² below 1 means that the smoother allows for more motion than the robot made.</source>
        <translation>Se da por supuesto que la forma es la verdadera; un χ² muy por encima de 1 indica que no lo es. Por debajo de 1 se debe a un suavizador que admite más movimiento del que hay.</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 puntos</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>%1 to %2: %3</source>
        <translation>de %1 a %2: %3</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Distancia recorrida</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>a los %1</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>pendiente</translation>
    </message>
    <message>
        <source>slope there</source>
        <translation>pendiente allí</translation>
    </message>
    <message>
        <source>times t²</source>
        <translation>coeficiente de t²</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>residuo</translation>
    </message>
    <message>
        <source>%1 (RMS)</source>
        <translation>%1 (RMS)</translation>
    </message>
</context>
<context>
    <name>RecordHealth</name>
    <message>
        <source>problem</source>
        <translation>fallo</translation>
    </message>
    <message>
        <source>slow</source>
        <translation>lenta</translation>
    </message>
    <message>
        <source>lost frames</source>
        <translation>pérdidas</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bien</translation>
    </message>
    <message>
        <source>, %1 ms</source>
        <translation>, %1 ms</translation>
    </message>
    <message>
        <source>; not registered</source>
        <translation>; sin registrar</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>no camera sees it</source>
        <translation>no se ve</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>no visto</translation>
    </message>
    <message>
        <source>x %1, y %2, %3</source>
        <translation>x %1, y %2, %3</translation>
    </message>
    <message>
        <source>; one camera sees it</source>
        <translation>; lo ve una cámara</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>visto</translation>
    </message>
    <message>
        <source>fair</source>
        <translation>regular</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>desfasadas</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>Sincronía</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En vivo</translation>
    </message>
    <message>
        <source>%1 MB written</source>
        <translation>%1 MB escritos</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Disco</translation>
    </message>
    <message>
        <source>Camera %1 is not registered to the floor: it records, but cannot locate robots.</source>
        <translation>La cámara %1 no está registrada respecto al suelo: se graba, pero no puede indicar dónde está un robot.</translation>
    </message>
    <message>
        <source>Camera %1 was registered with frames of %2×%3, but now sends another size: it records, but cannot locate robots.</source>
        <translation>La cámara %1 se registró para imágenes de %2×%3, que ahora no envía: se graba, pero no puede indicar dónde está un robot.</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>Grabación: %1</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>Cámara %1: %2</translation>
    </message>
    <message>
        <source>The disk is barely fast enough: record to a faster one, or with fewer cameras.</source>
        <translation>El disco es apenas lo bastante rápido: grabe en uno más rápido o con menos cámaras.</translation>
    </message>
    <message>
        <source>The disk is nearly full: %1</source>
        <translation>El disco está casi lleno: %1</translation>
    </message>
    <message>
        <source>The cameras are not synchronised: set both to the same frame rate.</source>
        <translation>Las cámaras no están sincronizadas: ponga ambas a la misma frecuencia.</translation>
    </message>
</context>
<context>
    <name>Remedy</name>
    <message>
        <source>Synchronise…</source>
        <translation>Sincronizar…</translation>
    </message>
    <message>
        <source>Robots…</source>
        <translation>Robots…</translation>
    </message>
    <message>
        <source>Open Testbed</source>
        <translation>Abrir Banco de pruebas</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>Rastrear…</translation>
    </message>
    <message>
        <source>Find lost videos…</source>
        <translation>Buscar videos perdidos…</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
</context>
<context>
    <name>ReportChart</name>
    <message>
        <source>Speed, %1</source>
        <translation>Velocidad, %1</translation>
    </message>
    <message>
        <source>Acceleration along the path, %1</source>
        <translation>Aceleración a lo largo de la trayectoria, %1</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured</source>
        <translation>suavizada, con su banda de ±95 %; puntos: lo medido</translation>
    </message>
    <message>
        <source>No curve: the robot was not detected</source>
        <translation>Sin curva: no se vio el robot</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured; shaded: not measured</source>
        <translation>suavizada, con su banda de ±95 %; puntos: lo medido; sombreado: sin medir</translation>
    </message>
</context>
<context>
    <name>ReportMethod</name>
    <message>
        <source>%1: %2 frames at %3/s</source>
        <translation>%1: %2 fotogramas a %3/s</translation>
    </message>
    <message numerus="yes">
        <source>%n missing</source>
        <translation>
            <numerusform>falta %n</numerusform>
            <numerusform>faltan %n</numerusform>
        </translation>
    </message>
    <message>
        <source>lens calibrated to %1 px</source>
        <translation>lente calibrada a %1 px</translation>
    </message>
    <message>
        <source>registered to the floor to %1 px, %2</source>
        <translation>registrada respecto al suelo a %1 px, %2</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>sin registrar</translation>
    </message>
    <message>
        <source>%1 samples: %2 measured, %3 used, %4 flagged, %5 bridged; the views disagree by %6 on average</source>
        <translation>%1 muestras: %2 medidas, %3 usadas, %4 señaladas, %5 puenteadas; las vistas discrepan %6 en promedio</translation>
    </message>
    <message>
        <source>t, s</source>
        <translation>t, s</translation>
    </message>
    <message>
        <source>x, %1</source>
        <translation>x, %1</translation>
    </message>
    <message>
        <source>y, %1</source>
        <translation>y, %1</translation>
    </message>
    <message>
        <source>speed, %1</source>
        <translation>velocidad, %1</translation>
    </message>
    <message>
        <source>± (σ)</source>
        <translation>± (σ)</translation>
    </message>
    <message>
        <source>acceleration, %1</source>
        <translation>aceleración, %1</translation>
    </message>
    <message>
        <source>flags</source>
        <translation>señales</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Lo que se midió</translation>
    </message>
    <message>
        <source>every sample, smoothed</source>
        <translation>todas las muestras, suavizadas</translation>
    </message>
    <message>
        <source>one sample of %1, smoothed; all of them are in the exported file</source>
        <translation>una de cada %1 muestras, suavizadas; todas están en el archivo exportado</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>smoother: %1</source>
        <translation>suavizador: %1</translation>
    </message>
    <message>
        <source>analysed %1, Odograph %2</source>
        <translation>analizado %1, Odograph %2</translation>
    </message>
    <message>
        <source>%1: method</source>
        <translation>%1: método</translation>
    </message>
    <message>
        <source>How the metrics were computed</source>
        <translation>Cómo se calcularon los indicadores</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>±: %1.</source>
        <translation>±: %1.</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>salto</translation>
    </message>
    <message>
        <source>speed limit</source>
        <translation>límite de velocidad</translation>
    </message>
    <message>
        <source>acceleration limit</source>
        <translation>límite de aceleración</translation>
    </message>
    <message>
        <source>views disagree</source>
        <translation>vistas discrepantes</translation>
    </message>
    <message>
        <source>low score</source>
        <translation>puntuación baja</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdido</translation>
    </message>
    <message>
        <source>duplicate frame</source>
        <translation>fotograma repetido</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>interpolado</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>a mano</translation>
    </message>
</context>
<context>
    <name>ReportStills</name>
    <message>
        <source>no image: the video cannot be read</source>
        <translation>sin imagen: no se puede leer el video</translation>
    </message>
    <message>
        <source>no image: the video is missing</source>
        <translation>sin imagen: falta el video</translation>
    </message>
</context>
<context>
    <name>RobotColours</name>
    <message>
        <source>blue</source>
        <translation>azul</translation>
    </message>
    <message>
        <source>vermilion</source>
        <translation>bermellón</translation>
    </message>
    <message>
        <source>green</source>
        <translation>verde</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>púrpura</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>naranja</translation>
    </message>
    <message>
        <source>sky blue</source>
        <translation>celeste</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
</context>
<context>
    <name>RunEvents</name>
    <message>
        <source>First seen, moving already</source>
        <translation>Visto por primera vez, ya en movimiento</translation>
    </message>
    <message>
        <source>Starts to move</source>
        <translation>Empieza a moverse</translation>
    </message>
    <message>
        <source>Last seen, still moving</source>
        <translation>Visto por última vez, aún en movimiento</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Se detiene</translation>
    </message>
    <message>
        <source>Top speed, %1</source>
        <translation>Velocidad máxima, %1</translation>
    </message>
    <message>
        <source>Passes %1</source>
        <translation>Pasa %1</translation>
    </message>
    <message>
        <source>Spike: %1</source>
        <translation>Valor atípico: %1</translation>
    </message>
    <message numerus="yes">
        <source>(%n samples)</source>
        <translation>
            <numerusform>(%n muestra)</numerusform>
            <numerusform>(%n muestras)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SceneDisagreement</name>
    <message>
        <source>Only one view at a time: nothing to compare</source>
        <translation>Solo una vista a la vez: nada que comparar</translation>
    </message>
    <message>
        <source>RMS %1, median %2</source>
        <translation>RMS %1, mediana %2</translation>
    </message>
    <message>
        <source>expected from the uncertainty: %1</source>
        <translation>esperado por los errores: %1</translation>
    </message>
    <message>
        <source>%1 – more than it explains</source>
        <translation>%1 – más de lo que explican</translation>
    </message>
    <message>
        <source>Disagreement of the views</source>
        <translation>Discrepancia entre vistas</translation>
    </message>
    <message>
        <source>Each view alone gives a floor position of the robot. The chart shows the distance between these positions in each frame with two views or more (of more than two, the largest distance); RMS is √(mean of the squares). Unused samples are left out.
Expected is √(tr A + tr B + (v·σs)²) from the covariances A and B of two views (pixels and calibration), the speed v and the synchronisation uncertainty σs of the views.
Much more than expected means that a setting is wrong: the views are not synchronised (the distance grows with the speed), a camera has moved or is badly registered (it depends on the position), or the robot&apos;s height is wrong (it points to and from the cameras).</source>
        <translation>Cada vista por sí sola sitúa el robot en un lugar del suelo. Se muestra cuánto distan estos lugares en cada fotograma en que lo vieron dos o más vistas (con más de dos, la mayor distancia); RMS es √(media de los cuadrados). Se omiten las muestras que no se usan.
Lo esperado es √(tr A + tr B + (v·σs)²) a partir de las covarianzas A y B de dos vistas (píxeles y calibración), la velocidad v y la sincronía σs de las vistas.
Mucho más de lo esperado significa que algo no es como se indicó: las vistas no están sincronizadas (entonces crece con la velocidad), una cámara se ha movido o está mal registrada (entonces depende del lugar), o la altura del robot es errónea (entonces apunta hacia las cámaras o en sentido contrario).</translation>
    </message>
    <message>
        <source>%1 frames with two views or more; largest %2; views synchronised to %3 ms</source>
        <translation>%1 fotogramas vistos por dos o más vistas; la mayor, %2; vistas sincronizadas a %3 ms</translation>
    </message>
</context>
<context>
    <name>ScoreText</name>
    <message>
        <source>%1: not measured, no points (%2)</source>
        <translation>%1: sin medir, sin puntos (%2)</translation>
    </message>
    <message>
        <source>%1 %2: %3 points (%4)</source>
        <translation>%1 %2: %3 puntos (%4)</translation>
    </message>
    <message>
        <source>%1 %2: %3 of %4 points (%5)</source>
        <translation>%1 %2: %3 de %4 puntos (%5)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>the sum of the points of each line; a line gives points × (metric − none at) / (all at − none at), from 0 to all</source>
        <translation>la suma de los puntos de todas las líneas; una línea da puntos × (indicador − ninguno con) / (todos con − ninguno con), de 0 a todos</translation>
    </message>
    <message>
        <source>for each line, half the difference in points between its metric plus and minus one σ; root of the sum of the squares</source>
        <translation>de cada línea, la mitad de lo que difieren sus puntos si su indicador es una σ mayor o menor; raíz de la suma de los cuadrados</translation>
    </message>
    <message>
        <source>%1 points off at %2 or less, none off at %3 or more</source>
        <translation>se restan %1 puntos con %2 o menos, ninguno con %3 o más</translation>
    </message>
    <message>
        <source>%1 points off at %2 or more, none off at %3 or less</source>
        <translation>se restan %1 puntos con %2 o más, ninguno con %3 o menos</translation>
    </message>
    <message>
        <source>%1 points at %2 or less, none at %3 or more</source>
        <translation>%1 puntos con %2 o menos, ninguno con %3 o más</translation>
    </message>
    <message>
        <source>%1 points at %2 or more, none at %3 or less</source>
        <translation>%1 puntos con %2 o más, ninguno con %3 o menos</translation>
    </message>
</context>
<context>
    <name>Scoreboard</name>
    <message>
        <source>Standings</source>
        <translation>Clasificación</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Mejor</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Último</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Recorridos</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Puesto</translation>
    </message>
    <message>
        <source>Best run</source>
        <translation>Mejor recorrido</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Conectando…</translation>
    </message>
    <message>
        <source>Connection lost. Reconnecting…</source>
        <translation>Conexión perdida. Reconectando…</translation>
    </message>
    <message>
        <source>This page needs JavaScript.</source>
        <translation>Esta página necesita JavaScript.</translation>
    </message>
    <message>
        <source>Teams rank by the median of their runs. Teams that do not differ significantly (95 %) share a rank. ±: one standard deviation. ≈: not significantly behind the first.</source>
        <translation>El puesto se decide por la mediana de los recorridos. Los equipos sin diferencia significativa (95 %) comparten puesto. ±: una desviación estándar. ≈: sin retraso significativo respecto al primero.</translation>
    </message>
    <message>
        <source>No ranks: no trial has a task, and runs of different tasks cannot be compared.</source>
        <translation>Sin puestos: ningún ensayo tiene tarea, y los recorridos de tareas distintas no se pueden comparar.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course.</source>
        <translation>
            <numerusform>%n ensayo omitido: se midió con otro circuito.</numerusform>
            <numerusform>%n ensayos omitidos: se midieron con otro circuito.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>%n ensayo no contado: resultados malos.</numerusform>
            <numerusform>%n ensayos no contados: resultados malos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! %n ensayo con resultados dudosos contado.</numerusform>
            <numerusform>! %n ensayos con resultados dudosos contados.</numerusform>
        </translation>
    </message>
    <message>
        <source>No team has a result yet.</source>
        <translation>Ningún equipo tiene resultado todavía.</translation>
    </message>
    <message>
        <source>Running now</source>
        <translation>En marcha</translation>
    </message>
    <message>
        <source>The best run from above</source>
        <translation>El mejor recorrido desde arriba</translation>
    </message>
    <message>
        <source>a square: %1</source>
        <translation>un cuadro: %1</translation>
    </message>
</context>
<context>
    <name>SetupWords</name>
    <message>
        <source>Two phones on tripods are enough. Film the robot with both, import the clips or drop them on this window; or connect cameras.</source>
        <translation>Bastan dos teléfonos sobre trípodes. Filme el robot con ambos e importe los videos o suéltelos en esta ventana; o conecte cámaras.</translation>
    </message>
    <message>
        <source>Cameras: %1.</source>
        <translation>Cámaras: %1.</translation>
    </message>
    <message>
        <source>Print the mat, tape it together and lay it where every camera sees it while it films: from it Odograph knows where the floor is.</source>
        <translation>Imprima la alfombrilla, péguela y póngala donde cada cámara la vea mientras filma: por ella Odograph sabe dónde está el suelo.</translation>
    </message>
    <message>
        <source>Positions on the floor: %1.</source>
        <translation>Posiciones en el suelo: %1.</translation>
    </message>
    <message>
        <source>Not registered yet: %1.</source>
        <translation>Aún sin registrar: %1.</translation>
    </message>
    <message>
        <source>A printed board measures the distortion of the lens; without it positions far from the mat are less exact, and their ± says so.</source>
        <translation>Un tablero impreso muestra cómo el objetivo curva la imagen; sin él, las posiciones lejos de la alfombrilla son menos exactas, y su ± lo indica.</translation>
    </message>
    <message>
        <source>Calibrated: %1.</source>
        <translation>Calibradas: %1.</translation>
    </message>
    <message>
        <source>A name is enough: Odograph finds a robot of any look by its motion.</source>
        <translation>Basta con un nombre: Odograph encuentra un robot de cualquier aspecto por su movimiento.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>Robots: %1.</source>
        <translation>Robots: %1.</translation>
    </message>
    <message>
        <source>Imported clips are tracked here, or record with connected cameras.</source>
        <translation>Aquí se rastrean los videos importados; o grabe con cámaras conectadas.</translation>
    </message>
    <message>
        <source>%1 is not measured yet.</source>
        <translation>%1 aún no está medido.</translation>
    </message>
    <message>
        <source>%1 is measured.</source>
        <translation>%1 está medido.</translation>
    </message>
    <message>
        <source>Path, speed, acceleration and their ±, spikes with reasons: one PDF for each trial, or for the class.</source>
        <translation>Recorrido, velocidad, aceleración y su ±, picos con sus motivos: un PDF para cada ensayo o para la clase.</translation>
    </message>
</context>
<context>
    <name>ShownMessageWords</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>SnappedMarker</name>
    <message>
        <source>tag</source>
        <translation>AprilTag</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>anillo</translation>
    </message>
    <message>
        <source>dot</source>
        <translation>punto</translation>
    </message>
    <message>
        <source>tape crossing</source>
        <translation>cruce de cintas</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>esquina</translation>
    </message>
    <message>
        <source>crossing fields</source>
        <translation>cruce de casillas</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>a mano</translation>
    </message>
</context>
<context>
    <name>TargetPainter</name>
    <message>
        <source>100 mm</source>
        <translation>100 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Checkerboard, %1 × %2 inner corners, squares of %3</source>
        <translation>Tablero de ajedrez, %1 × %2 esquinas interiores, casillas de %3</translation>
    </message>
    <message>
        <source>ChArUco board, %1 × %2 inner corners, squares of %3</source>
        <translation>Tablero ChArUco, %1 × %2 esquinas interiores, casillas de %3</translation>
    </message>
    <message>
        <source>Floor marker %1 (tag 36h11 number %2), %3</source>
        <translation>Marcador de suelo %1 (AprilTag 36h11 número %2), %3</translation>
    </message>
    <message>
        <source>Floor marker %1 (ring), %2</source>
        <translation>Marcador de suelo %1 (anillo), %2</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size). Glue it flat onto something stiff, measure a square, and enter its side in Odograph.</source>
        <translation>Imprima al 100 % (tamaño real). Péguelo plano sobre algo rígido, mida una casilla e indique a Odograph lo que midió.</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size). Lay it flat; the marker&apos;s position is its middle, where the four lines at the edges point.</source>
        <translation>Imprima al 100 % (tamaño real). Póngalo plano; el lugar del marcador es su centro, adonde apuntan las cuatro líneas de los bordes.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets</source>
        <translation>Alfombrilla de %1 × %2 hojas</translation>
    </message>
</context>
<context>
    <name>TestbedState</name>
    <message>
        <source>standard</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>rational</source>
        <translation>racional</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>ojo de pez</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>Tamaño de imagen</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Lente</translation>
    </message>
    <message>
        <source>%1, f = %2 px</source>
        <translation>%1, f = %2 px</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>Board error</source>
        <translation>Error del tablero</translation>
    </message>
    <message>
        <source>%1 px in %2 images</source>
        <translation>%1 px en %2 imágenes</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>Error de validación</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>On the floor</source>
        <translation>En el suelo</translation>
    </message>
    <message>
        <source>registered %1</source>
        <translation>registrada el %1</translation>
    </message>
    <message>
        <source>Last check</source>
        <translation>Última comprobación</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3 m high</source>
        <translation>x %1 m, y %2 m, %3 m de altura</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marcadores</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Atención</translation>
    </message>
    <message>
        <source>not registered: cannot measure positions yet</source>
        <translation>sin registrar: aún no se pueden medir posiciones</translation>
    </message>
    <message>
        <source>not calibrated: estimated from the markers</source>
        <translation>sin calibrar: estimada a partir de los marcadores</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>sin calibrar</translation>
    </message>
</context>
<context>
    <name>TrailPainting</name>
    <message>
        <source>0 to %1 %2</source>
        <translation>0 a %1 %2</translation>
    </message>
</context>
<context>
    <name>TrendPainting</name>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
</context>
<context>
    <name>TrialCurves</name>
    <message>
        <source>No curve yet: track the trial</source>
        <translation>Aún sin curva: rastree el ensayo</translation>
    </message>
</context>
<context>
    <name>TrialExport</name>
    <message>
        <source>Export %1</source>
        <translation>Exportar %1</translation>
    </message>
    <message>
        <source>%1 was exported to %2.</source>
        <translation>%1 se exportó a %2.</translation>
    </message>
</context>
<context>
    <name>TrialFacts</name>
    <message>
        <source>%1, %2 high (estimated)</source>
        <translation>%1, %2 de alto (estimado)</translation>
    </message>
    <message>
        <source>%1, %2 high</source>
        <translation>%1, %2 de alto</translation>
    </message>
    <message>
        <source>%1: %2×%3, %4 frames</source>
        <translation>%1: %2×%3, %4 fotogramas</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>video missing</source>
        <translation>falta el video</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>sin registrar</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>Sincronía</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>not synchronised</source>
        <translation>sin sincronizar</translation>
    </message>
    <message>
        <source>SHA-256 %1…</source>
        <translation>SHA-256 %1…</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 a los %2</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Puertas</translation>
    </message>
    <message>
        <source>to %1 %2</source>
        <translation>hasta %1 %2</translation>
    </message>
    <message>
        <source>Lap %1</source>
        <translation>Vuelta %1</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Recorrido %1</translation>
    </message>
    <message>
        <source>off by %1 on average</source>
        <translation>desvío de %1 en promedio</translation>
    </message>
    <message>
        <source>%1 (RMS)</source>
        <translation>%1 (RMS)</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>%1 como máximo</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 a la izquierda</translation>
    </message>
    <message>
        <source>%1 of it completed</source>
        <translation>%1 de la trayectoria completado</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>respetadas</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>analysed with a different course</source>
        <translation>medido con otro circuito</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <source>none until you reanalyse the trial: the task has a different course now</source>
        <translation>ninguna hasta que se vuelva a medir: la tarea tiene ahora otro circuito</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Testbed</source>
        <translation>Banco de pruebas</translation>
    </message>
    <message>
        <source>markers “%1”</source>
        <translation>marcadores “%1”</translation>
    </message>
    <message>
        <source>Imported</source>
        <translation>Importado</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trayectoria</translation>
    </message>
    <message>
        <source>Distance from the path</source>
        <translation>Distancia a la trayectoria</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>Zonas</translation>
    </message>
    <message>
        <source>Smoother</source>
        <translation>Suavizador</translation>
    </message>
    <message>
        <source>Analysed</source>
        <translation>Analizado</translation>
    </message>
    <message>
        <source>%1, Odograph %2</source>
        <translation>%1, Odograph %2</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>rate varies</source>
        <translation>frecuencia variable</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Accept…</source>
        <translation>Aceptar…</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Tramo</translation>
    </message>
    <message>
        <source>%1 to %2 of %3</source>
        <translation>de %1 a %2 de %3</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>In millimetres</source>
        <translation>En milímetros</translation>
    </message>
</context>
<context>
    <name>TrialLines</name>
    <message>
        <source>What the synchronisation is worth</source>
        <translation>Lo que vale la sincronía</translation>
    </message>
    <message>
        <source>σ of the time anywhere in the recording, of the offset and of the clock rate over its length, times the run&apos;s top speed. The remaining time error τ is that of d² = d₀² + τ²v² between the views&apos; distance d and the speed v: least squares over means of half a second.</source>
        <translation>σ del tiempo en cualquier punto de la grabación, del desfase y de la marcha del reloj en toda su duración, por la velocidad máxima del ensayo. El error de tiempo restante τ es el de d² = d₀² + τ²v² entre la distancia d de las vistas y la velocidad v: mínimos cuadrados sobre medias de medio segundo.</translation>
    </message>
    <message>
        <source>of τ: by the scatter of those means. Blur grows with the speed, too, so τ is at most as stated.</source>
        <translation>de τ: por la dispersión de esas medias. El desenfoque también crece con la velocidad, así que τ es como mucho lo indicado.</translation>
    </message>
    <message>
        <source>view %1: %2 frames</source>
        <translation>vista %1: %2 fotogramas</translation>
    </message>
    <message>
        <source>±%1 at the top speed</source>
        <translation>±%1 a la velocidad máxima</translation>
    </message>
    <message>
        <source>%1: never inside</source>
        <translation>%1: nunca dentro</translation>
    </message>
    <message>
        <source>%1: inside for at least %2</source>
        <translation>%1: dentro al menos %2</translation>
    </message>
    <message>
        <source>%1: inside for %2</source>
        <translation>%1: dentro %2</translation>
    </message>
    <message>
        <source>, from the start</source>
        <translation>, desde el inicio</translation>
    </message>
    <message numerus="yes">
        <source>, entered %n time(s)</source>
        <translation>
            <numerusform>, %n entrada</numerusform>
            <numerusform>, %n entradas</numerusform>
        </translation>
    </message>
    <message>
        <source>, first after %1</source>
        <translation>, la primera tras %1</translation>
    </message>
</context>
<context>
    <name>TrialReport</name>
    <message>
        <source>class median %1</source>
        <translation>mediana clase: %1</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <source>The run from above</source>
        <translation>El recorrido visto desde arriba</translation>
    </message>
    <message>
        <source>coloured by speed</source>
        <translation>coloreado según la velocidad</translation>
    </message>
    <message>
        <source>The cameras’ views</source>
        <translation>Vistas de las cámaras</translation>
    </message>
    <message>
        <source>at %1, the top speed</source>
        <translation>a los %1, lo más rápido</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>a los %1</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Qué ocurrió</translation>
    </message>
    <message>
        <source>It did not move</source>
        <translation>No se movió</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>Parciales</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Recorrido %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>hasta %1</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Indicadores</translation>
    </message>
    <message>
        <source>± one σ</source>
        <translation>± una σ</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>This trial has not been tracked yet: it has no metrics.</source>
        <translation>Este ensayo aún no se ha rastreado: no hay indicadores.</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>%1 times in all</source>
        <translation>%1 veces en total</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… y %n más</numerusform>
            <numerusform>… y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Bad results: do not use them.</source>
        <translation>Resultados malos: no los use.</translation>
    </message>
    <message>
        <source>Doubtful results, which were accepted.</source>
        <translation>Resultados dudosos que se aceptaron.</translation>
    </message>
    <message>
        <source>Doubtful results: read the reasons before you use them.</source>
        <translation>Resultados dudosos: lea los motivos antes de usarlos.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Tramo</translation>
    </message>
</context>
<context>
    <name>UncertainIntervals</name>
    <message>
        <source>Which robot? Until %1</source>
        <translation>¿Qué robot? Hasta %1</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (de %2 a %3)</translation>
    </message>
    <message>
        <source>Not measured until %1</source>
        <translation>Sin medir hasta %1</translation>
    </message>
    <message>
        <source>not measured (%1 to %2)</source>
        <translation>sin medir (de %1 a %2)</translation>
    </message>
</context>
<context>
    <name>VerdictMark</name>
    <message>
        <source>accepted</source>
        <translation>aceptado</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>dudoso</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>malo</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>superado</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Aceptado: %1</translation>
    </message>
    <message>
        <source>all checks passed</source>
        <translation>todas las comprobaciones superadas</translation>
    </message>
</context>
<context>
    <name>WindowTitle</name>
    <message>
        <source>Team %1</source>
        <translation>Equipo %1</translation>
    </message>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
</context>
<context>
    <name>analysis.a_constant</name>
    <message>
        <source>a constant</source>
        <translation>una constante</translation>
    </message>
</context>
<context>
    <name>analysis.a_parabola</name>
    <message>
        <source>a parabola</source>
        <translation>una parábola</translation>
    </message>
</context>
<context>
    <name>analysis.a_straight_line</name>
    <message>
        <source>a straight line</source>
        <translation>una recta</translation>
    </message>
</context>
<context>
    <name>analysis.align_by_distance</name>
    <message>
        <source>align by distance</source>
        <translation>alinee por distancia</translation>
    </message>
</context>
<context>
    <name>analysis.align_otherwise</name>
    <message>
        <source>align by motion onset or distance</source>
        <translation>alinee por inicio del movimiento o por distancia</translation>
    </message>
</context>
<context>
    <name>analysis.check_numbers</name>
    <message>
        <source>check the numbers</source>
        <translation>compruebe los números</translation>
    </message>
</context>
<context>
    <name>analysis.choose_another_run</name>
    <message>
        <source>choose another run as well</source>
        <translation>elija además otro recorrido</translation>
    </message>
</context>
<context>
    <name>analysis.choose_common_place</name>
    <message>
        <source>choose a position that both runs pass</source>
        <translation>elija un lugar por el que pasen ambos recorridos</translation>
    </message>
</context>
<context>
    <name>analysis.choose_figure</name>
    <message>
        <source>choose a metric to score</source>
        <translation>elija qué se puntúa</translation>
    </message>
</context>
<context>
    <name>analysis.choose_log_of_run</name>
    <message>
        <source>choose the log of this run</source>
        <translation>elija el registro de este recorrido</translation>
    </message>
</context>
<context>
    <name>analysis.choose_longer_range</name>
    <message>
        <source>choose a longer range</source>
        <translation>elija un intervalo más largo</translation>
    </message>
</context>
<context>
    <name>analysis.choose_motion</name>
    <message>
        <source>choose a run with motion</source>
        <translation>elija un recorrido con movimiento</translation>
    </message>
</context>
<context>
    <name>analysis.choose_same_direction</name>
    <message>
        <source>choose runs in the same direction</source>
        <translation>elija recorridos en el mismo sentido</translation>
    </message>
</context>
<context>
    <name>analysis.choose_same_task</name>
    <message>
        <source>choose runs of the same task</source>
        <translation>elija recorridos de la misma tarea</translation>
    </message>
</context>
<context>
    <name>analysis.comparison</name>
    <message>
        <source>comparison</source>
        <translation>comparación</translation>
    </message>
</context>
<context>
    <name>analysis.comparison_of</name>
    <message>
        <source>comparison of %1</source>
        <translation>comparación de %1</translation>
    </message>
</context>
<context>
    <name>analysis.corners_in_order</name>
    <message>
        <source>enter the corners in order, all the way round</source>
        <translation>dé las esquinas en orden, todo alrededor</translation>
    </message>
</context>
<context>
    <name>analysis.corners_off_floor</name>
    <message>
        <source>its corners are not all on a floor of 1 km</source>
        <translation>sus esquinas no están en un suelo de 1 km</translation>
    </message>
</context>
<context>
    <name>analysis.corners_once</name>
    <message>
        <source>enter each corner once</source>
        <translation>dé cada esquina una vez</translation>
    </message>
</context>
<context>
    <name>analysis.corners_too_near</name>
    <message>
        <source>two corners are less than 1 mm apart</source>
        <translation>dos esquinas están a menos de 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.draw_coarsely</name>
    <message>
        <source>draw it with fewer corners</source>
        <translation>dibújela de forma más gruesa</translation>
    </message>
</context>
<context>
    <name>analysis.ends_off_floor</name>
    <message>
        <source>its ends are not both on a floor of 1 km</source>
        <translation>sus extremos no están en un suelo de 1 km</translation>
    </message>
</context>
<context>
    <name>analysis.ends_too_near</name>
    <message>
        <source>its ends are less than 1 mm apart</source>
        <translation>sus extremos están a menos de 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.few_corners</name>
    <message>
        <source>it has fewer than three corners</source>
        <translation>tiene menos de tres esquinas</translation>
    </message>
</context>
<context>
    <name>analysis.few_points</name>
    <message>
        <source>it has too few points</source>
        <translation>tiene muy pocos puntos</translation>
    </message>
</context>
<context>
    <name>analysis.finish_is_there</name>
    <message>
        <source>gate &apos;%1&apos; is already the finish</source>
        <translation>la puerta &apos;%1&apos; ya es la meta</translation>
    </message>
</context>
<context>
    <name>analysis.fit_of</name>
    <message>
        <source>fit of %1</source>
        <translation>ajuste (%1)</translation>
    </message>
</context>
<context>
    <name>analysis.formula_best_lap</name>
    <message>
        <source>The shortest lap.</source>
        <translation>La vuelta más rápida.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_circle_radius</name>
    <message>
        <source>The least-squares circle through the positions of the motion.</source>
        <translation>La circunferencia con la menor suma de cuadrados de las distancias a las posiciones del movimiento.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_bias</name>
    <message>
        <source>The mean of the distance from the reference path, to the left positive.</source>
        <translation>La media de la distancia a la trayectoria de referencia, positiva hacia la izquierda.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_max</name>
    <message>
        <source>The largest distance from the reference path.</source>
        <translation>La mayor distancia a la trayectoria de referencia.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_mean</name>
    <message>
        <source>The distance from the reference path, averaged along the path.</source>
        <translation>La media, a lo largo del camino, de la distancia a la trayectoria de referencia.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_rms</name>
    <message>
        <source>√(mean of the squared distance from the reference path), averaged along the path</source>
        <translation>√(media del cuadrado de la distancia a la trayectoria de referencia), a lo largo del camino</translation>
    </message>
</context>
<context>
    <name>analysis.formula_duration</name>
    <message>
        <source>From the onset of motion to the last stop. Moving means faster than three σ of the speed, for at least three frames, and further than noise explains; the moment between two frames is interpolated.</source>
        <translation>Del inicio del movimiento a la última parada. Moverse significa ir a más de tres σ de la velocidad, durante al menos tres fotogramas, y más lejos de lo que explica el ruido; el instante entre dos fotogramas se interpola.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_gate_time</name>
    <message>
        <source>From passing the start gate to passing the finish, each interpolated between frames.</source>
        <translation>Del paso por la puerta de salida al paso por la meta, ambos interpolados entre fotogramas.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_laps</name>
    <message>
        <source>Complete laps or runs, counted by the passages of the gates.</source>
        <translation>Vueltas o recorridos completos, contados por los pasos por las puertas.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_accel</name>
    <message>
        <source>The acceleration |a| of the smoothed curve where |a| − 2σ is largest.</source>
        <translation>La aceleración |a| de la curva suavizada donde |a| − 2σ es máxima.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_speed</name>
    <message>
        <source>The speed |v| of the smoothed curve where |v| − 2σ is largest. A point does not win only because its uncertainty is large.</source>
        <translation>La velocidad |v| de la curva suavizada donde |v| − 2σ es máxima, para que un punto mal conocido no gane por su error.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_turn_rate</name>
    <message>
        <source>How fast the robot turns, to the left or right, where the amount minus 2σ is largest. Of the body where its heading was measured, also on the spot: the rate of the smoothed heading. Elsewhere of the direction of motion: (vx·ay − vy·ax)/|v|² of the smoothed curve.</source>
        <translation>La rapidez con que gira el robot, a izquierda o derecha, donde su valor menos 2σ es máximo. La del cuerpo donde se midió su rumbo, también sobre el sitio: la variación del rumbo suavizado. En lo demás, la de la dirección del movimiento: (vx·ay − vy·ax)/|v|² de la curva suavizada.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_mean_lap</name>
    <message>
        <source>The mean of the laps&apos; times.</source>
        <translation>La media de los tiempos de las vueltas.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_mean_speed</name>
    <message>
        <source>path length / time, both without gaps</source>
        <translation>distancia recorrida / tiempo, ambos sin las lagunas</translation>
    </message>
</context>
<context>
    <name>analysis.formula_median_speed</name>
    <message>
        <source>The speed that half of the time in motion stays below.</source>
        <translation>La velocidad que no se supera durante la mitad del tiempo en movimiento.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_moving_time</name>
    <message>
        <source>The time in which it moves: faster than three σ of the speed, and further than noise explains.</source>
        <translation>El tiempo durante el cual se mueve: a más de tres σ de la velocidad y más lejos de lo que explica el ruido.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_p95_accel</name>
    <message>
        <source>The acceleration that 95 % of the time in motion stays below.</source>
        <translation>La aceleración que no se supera durante el 95 % del tiempo en movimiento.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_p95_speed</name>
    <message>
        <source>The speed that 95 % of the time in motion stays below.</source>
        <translation>La velocidad que no se supera durante el 95 % del tiempo en movimiento.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_path_completed</name>
    <message>
        <source>The share of the reference path that the robot followed.</source>
        <translation>La parte de la trayectoria de referencia que se siguió.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_path_length</name>
    <message>
        <source>∫|v|dt while it moves, by the trapezoidal rule over the smoothed speed. A gap that is not bridged adds nothing.</source>
        <translation>∫|v|dt mientras se mueve, por la regla del trapecio sobre la velocidad suavizada. Un hueco sin puentear no aporta nada.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_rms_accel</name>
    <message>
        <source>√(mean of |a|²) while it moves</source>
        <translation>√(media de |a|²) mientras se mueve</translation>
    </message>
</context>
<context>
    <name>analysis.formula_rms_speed</name>
    <message>
        <source>√(mean of |v|²) while it moves</source>
        <translation>√(media de |v|²) mientras se mueve</translation>
    </message>
</context>
<context>
    <name>analysis.formula_standing_time</name>
    <message>
        <source>time − time in motion</source>
        <translation>tiempo − tiempo en movimiento</translation>
    </message>
</context>
<context>
    <name>analysis.formula_stops</name>
    <message>
        <source>The pauses between the onset of motion and the last stop, counted where the robot was measured at rest.</source>
        <translation>El número de pausas entre el inicio del movimiento y la última parada en las que el robot se midió parado.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_straightness</name>
    <message>
        <source>distance from the first to the last position of the motion / path length</source>
        <translation>distancia de la primera a la última posición del movimiento / distancia recorrida</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_breaches</name>
    <message>
        <source>How often the robot&apos;s reference point left a zone to stay in or entered a zone to keep out of. It counts if the point is beyond the edge by more than six σ of the track&apos;s noise.</source>
        <translation>Cuántas veces el centro del robot salió de una zona de permanencia o entró en una zona prohibida. Cuenta cuando rebasa el borde en más de seis σ del ruido propio de la traza.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_depth</name>
    <message>
        <source>The largest distance of the robot&apos;s reference point beyond the edge of a zone.</source>
        <translation>Cuánto rebasó como máximo el centro del robot el borde de una zona.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_time</name>
    <message>
        <source>The time for which the robot&apos;s reference point was beyond the edge of a zone, interpolated between frames; in two zones at once it counts twice.</source>
        <translation>El tiempo durante el cual el centro del robot rebasó el borde de una zona, interpolado entre fotogramas; en dos zonas a la vez cuenta doble.</translation>
    </message>
</context>
<context>
    <name>analysis.gate</name>
    <message>
        <source>gate &apos;%1&apos;</source>
        <translation>puerta &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.give_another_number</name>
    <message>
        <source>choose another number</source>
        <translation>dé otro número</translation>
    </message>
</context>
<context>
    <name>analysis.give_corners</name>
    <message>
        <source>enter the corners of its outline, all the way round</source>
        <translation>dé las esquinas de su contorno, todo alrededor</translation>
    </message>
</context>
<context>
    <name>analysis.give_ends</name>
    <message>
        <source>enter the two ends of the line that the robot passes</source>
        <translation>dé los dos extremos de la línea que hay que cruzar</translation>
    </message>
</context>
<context>
    <name>analysis.give_limits</name>
    <message>
        <source>enter the largest speed and acceleration that a robot can reach in the task</source>
        <translation>dé la mayor velocidad y aceleración que un robot puede tener en la tarea</translation>
    </message>
</context>
<context>
    <name>analysis.give_log_offset</name>
    <message>
        <source>give the time offset of the log</source>
        <translation>indique el desfase temporal del registro</translation>
    </message>
</context>
<context>
    <name>analysis.give_place</name>
    <message>
        <source>enter its position in millimetres</source>
        <translation>indique dónde está en milímetros</translation>
    </message>
</context>
<context>
    <name>analysis.give_points</name>
    <message>
        <source>enter points from 1 to 1000; use a negative number for a penalty</source>
        <translation>dé puntos de 1 a 1000, bajo cero para una penalización</translation>
    </message>
</context>
<context>
    <name>analysis.give_sizes</name>
    <message>
        <source>enter the sizes in millimetres</source>
        <translation>dé los tamaños en milímetros</translation>
    </message>
</context>
<context>
    <name>analysis.give_three_numbers</name>
    <message>
        <source>enter three numbers</source>
        <translation>dé tres números</translation>
    </message>
</context>
<context>
    <name>analysis.give_two_points</name>
    <message>
        <source>enter at least two points, or three for a closed path</source>
        <translation>dé dos puntos o más, tres si la trayectoria es cerrada</translation>
    </message>
</context>
<context>
    <name>analysis.give_two_values</name>
    <message>
        <source>enter two different values; the points rise between them</source>
        <translation>dé dos valores entre los que suban los puntos</translation>
    </message>
</context>
<context>
    <name>analysis.join_zones</name>
    <message>
        <source>merge neighbouring zones</source>
        <translation>una zonas que estén una junto a otra</translation>
    </message>
</context>
<context>
    <name>analysis.keep_what_matters</name>
    <message>
        <source>keep those that matter</source>
        <translation>conserve las que importan</translation>
    </message>
</context>
<context>
    <name>analysis.limit_not_positive</name>
    <message>
        <source>a limit is zero or negative</source>
        <translation>un límite no es mayor que cero</translation>
    </message>
</context>
<context>
    <name>analysis.limits</name>
    <message>
        <source>limits of a task</source>
        <translation>límites de una tarea</translation>
    </message>
</context>
<context>
    <name>analysis.line_of_scoring</name>
    <message>
        <source>line %1 of the scoring</source>
        <translation>línea %1 de la puntuación</translation>
    </message>
</context>
<context>
    <name>analysis.little_motion</name>
    <message>
        <source>the robot hardly moves in %1</source>
        <translation>el robot apenas se mueve en %1</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_no_common_time</name>
    <message>
        <source>fewer than %1 of its positions have times at which the robot was measured</source>
        <translation>menos de %1 de sus posiciones corresponden a momentos en que se midió el robot</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_other_front</name>
    <message>
        <source>the log&apos;s heading is %1 from the measured one throughout: its front or its axes may differ</source>
        <translation>el rumbo del registro difiere siempre en %1 del medido: su parte delantera o sus ejes pueden ser otros</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_other_lengths</name>
    <message>
        <source>the log&apos;s lengths are %1 times the measured ones: its unit may be wrong</source>
        <translation>las longitudes del registro son %1 veces las medidas: su unidad puede ser incorrecta</translation>
    </message>
</context>
<context>
    <name>analysis.log_is_mirrored</name>
    <message>
        <source>it is the mirror image of the run</source>
        <translation>es la imagen especular del recorrido</translation>
    </message>
</context>
<context>
    <name>analysis.log_moves_otherwise</name>
    <message>
        <source>it moves differently: at no time offset do more than %1 of the changes of speed and direction agree</source>
        <translation>se mueve de otra forma: con ningún desfase temporal coincide más del %1 de los cambios de velocidad y dirección</translation>
    </message>
</context>
<context>
    <name>analysis.many_corners</name>
    <message>
        <source>it has more than %1 corners</source>
        <translation>tiene más de %1 esquinas</translation>
    </message>
</context>
<context>
    <name>analysis.many_lines</name>
    <message>
        <source>it has more than %1 lines</source>
        <translation>tiene más de %1 líneas</translation>
    </message>
</context>
<context>
    <name>analysis.many_points</name>
    <message>
        <source>it has more than %1 points</source>
        <translation>tiene más de %1 puntos</translation>
    </message>
</context>
<context>
    <name>analysis.many_zones</name>
    <message>
        <source>the task already has %1 zones</source>
        <translation>la tarea ya tiene %1 zonas</translation>
    </message>
</context>
<context>
    <name>analysis.metric_best_lap</name>
    <message>
        <source>Best lap</source>
        <translation>Mejor vuelta</translation>
    </message>
</context>
<context>
    <name>analysis.metric_circle_radius</name>
    <message>
        <source>Circle&apos;s radius</source>
        <translation>Radio del círculo</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_bias</name>
    <message>
        <source>Left of the path</source>
        <translation>Desvío a la izquierda</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_max</name>
    <message>
        <source>Off the path (most)</source>
        <translation>Desvío máximo</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_mean</name>
    <message>
        <source>Off the path (mean)</source>
        <translation>Desvío medio</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_rms</name>
    <message>
        <source>Off the path (RMS)</source>
        <translation>Desvío RMS</translation>
    </message>
</context>
<context>
    <name>analysis.metric_displacement</name>
    <message>
        <source>Displacement</source>
        <translation>Desplazamiento</translation>
    </message>
</context>
<context>
    <name>analysis.metric_duration</name>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
</context>
<context>
    <name>analysis.metric_gate_time</name>
    <message>
        <source>Start to finish</source>
        <translation>De salida a meta</translation>
    </message>
</context>
<context>
    <name>analysis.metric_gates_passed</name>
    <message>
        <source>Gates passed</source>
        <translation>Puertas pasadas</translation>
    </message>
</context>
<context>
    <name>analysis.metric_height</name>
    <message>
        <source>Robot&apos;s height</source>
        <translation>Altura del robot</translation>
    </message>
</context>
<context>
    <name>analysis.metric_laps</name>
    <message>
        <source>Laps</source>
        <translation>Vueltas</translation>
    </message>
</context>
<context>
    <name>analysis.metric_limit_breaches</name>
    <message>
        <source>Limits broken</source>
        <translation>Límites superados</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_accel</name>
    <message>
        <source>Top acceleration</source>
        <translation>Aceleración máxima</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_speed</name>
    <message>
        <source>Top speed</source>
        <translation>Velocidad máxima</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_turn_rate</name>
    <message>
        <source>Fastest turn</source>
        <translation>Giro más rápido</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_lap</name>
    <message>
        <source>Mean lap</source>
        <translation>Vuelta media</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_speed</name>
    <message>
        <source>Mean speed</source>
        <translation>Velocidad media</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_view_disagreement</name>
    <message>
        <source>Views disagree by</source>
        <translation>Discrepancia entre vistas</translation>
    </message>
</context>
<context>
    <name>analysis.metric_median_speed</name>
    <message>
        <source>Median speed</source>
        <translation>Velocidad mediana</translation>
    </message>
</context>
<context>
    <name>analysis.metric_moving_time</name>
    <message>
        <source>Time in motion</source>
        <translation>Tiempo en movimiento</translation>
    </message>
</context>
<context>
    <name>analysis.metric_p95_accel</name>
    <message>
        <source>P95 acceleration</source>
        <translation>Aceleración (P95)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_p95_speed</name>
    <message>
        <source>P95 speed</source>
        <translation>Velocidad (P95)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_path_completed</name>
    <message>
        <source>Path completed</source>
        <translation>Trayectoria completada</translation>
    </message>
</context>
<context>
    <name>analysis.metric_path_length</name>
    <message>
        <source>Path</source>
        <translation>Distancia recorrida</translation>
    </message>
</context>
<context>
    <name>analysis.metric_rms_accel</name>
    <message>
        <source>Acceleration (RMS)</source>
        <translation>Aceleración (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_rms_speed</name>
    <message>
        <source>Speed (RMS)</source>
        <translation>Velocidad (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_score</name>
    <message>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
</context>
<context>
    <name>analysis.metric_spikes</name>
    <message>
        <source>Spikes</source>
        <translation>Valores atípicos</translation>
    </message>
</context>
<context>
    <name>analysis.metric_standing_time</name>
    <message>
        <source>Standing time</source>
        <translation>Tiempo parado</translation>
    </message>
</context>
<context>
    <name>analysis.metric_stops</name>
    <message>
        <source>Stops</source>
        <translation>Paradas</translation>
    </message>
</context>
<context>
    <name>analysis.metric_straightness</name>
    <message>
        <source>Straightness</source>
        <translation>Rectitud</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_breaches</name>
    <message>
        <source>Zones broken</source>
        <translation>Zonas infringidas</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_depth</name>
    <message>
        <source>Beyond zones (most)</source>
        <translation>Infracción máxima</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_time</name>
    <message>
        <source>Time beyond zones</source>
        <translation>Tiempo en infracción</translation>
    </message>
</context>
<context>
    <name>analysis.moment_outside</name>
    <message>
        <source>the moment entered for %1 is outside that run</source>
        <translation>el momento indicado para %1 queda fuera de él</translation>
    </message>
</context>
<context>
    <name>analysis.moments_missing</name>
    <message>
        <source>aligning runs by hand needs a moment in each run</source>
        <translation>para alinearlos a mano hace falta un momento de cada recorrido</translation>
    </message>
</context>
<context>
    <name>analysis.motion_gives_no_offset</name>
    <message>
        <source>the robot never changes its speed or its curvature by more than noise, so any time offset fits</source>
        <translation>el robot nunca cambia su velocidad ni su curvatura más que el ruido, así que cualquier desfase temporal encaja</translation>
    </message>
</context>
<context>
    <name>analysis.name_each_gate</name>
    <message>
        <source>give each gate a name of its own</source>
        <translation>dé a cada puerta un nombre propio</translation>
    </message>
</context>
<context>
    <name>analysis.name_each_zone</name>
    <message>
        <source>give each zone a name of its own</source>
        <translation>dé a cada zona un nombre propio</translation>
    </message>
</context>
<context>
    <name>analysis.name_twice</name>
    <message>
        <source>the name is used twice</source>
        <translation>el nombre está dos veces</translation>
    </message>
</context>
<context>
    <name>analysis.no_figure</name>
    <message>
        <source>it names no metric</source>
        <translation>no nombra ningún indicador</translation>
    </message>
</context>
<context>
    <name>analysis.no_motion</name>
    <message>
        <source>the robot does not move in %1</source>
        <translation>el robot no se mueve en %1</translation>
    </message>
</context>
<context>
    <name>analysis.no_onset</name>
    <message>
        <source>the robot of %1 is already moving when it is first seen</source>
        <translation>el robot de %1 ya está en marcha cuando se le ve por primera vez</translation>
    </message>
</context>
<context>
    <name>analysis.no_start_gate</name>
    <message>
        <source>%1 does not pass a start gate</source>
        <translation>%1 no pasa por ninguna puerta de salida</translation>
    </message>
</context>
<context>
    <name>analysis.no_step_of_delta</name>
    <message>
        <source>no stretch of %1 was measured without a gap, so there is no relative error</source>
        <translation>ningún tramo de %1 se midió sin lagunas, así que no hay error relativo</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_role</name>
    <message>
        <source>gates have no such role</source>
        <translation>no existe ese papel</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_rule</name>
    <message>
        <source>zones have no such rule</source>
        <translation>no existe esa regla de zona</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_template</name>
    <message>
        <source>no template has this name</source>
        <translation>no existe esa plantilla</translation>
    </message>
</context>
<context>
    <name>analysis.not_on_tasks_path</name>
    <message>
        <source>%1 shares no part of its path with the task&apos;s path</source>
        <translation>%1 no tiene ningún tramo de camino en común con la trayectoria de la tarea</translation>
    </message>
</context>
<context>
    <name>analysis.not_seen_there</name>
    <message>
        <source>%1 was not seen at the position used for alignment</source>
        <translation>%1 no se vio en el lugar por el que alinear</translation>
    </message>
</context>
<context>
    <name>analysis.nothing_in_common</name>
    <message>
        <source>%1 shares no part of its path with %2</source>
        <translation>%1 no tiene ningún tramo de camino en común con %2</translation>
    </message>
</context>
<context>
    <name>analysis.number_is_none</name>
    <message>
        <source>one of its values is not a number</source>
        <translation>uno de sus números no lo es</translation>
    </message>
</context>
<context>
    <name>analysis.offset_is_ambiguous</name>
    <message>
        <source>its motion repeats itself: time offsets %1 apart agree equally well</source>
        <translation>su movimiento se repite: desfases temporales separados %1 concuerdan igual de bien</translation>
    </message>
</context>
<context>
    <name>analysis.offset_is_uncertain</name>
    <message>
        <source>its time offset is known only to ±%1</source>
        <translation>su desfase temporal solo se conoce con ±%1</translation>
    </message>
</context>
<context>
    <name>analysis.offset_not_found</name>
    <message>
        <source>too little of its motion is also in the run to find the time offset</source>
        <translation>muy poco de su movimiento está también en el recorrido como para hallar el desfase temporal</translation>
    </message>
</context>
<context>
    <name>analysis.one_point_too_few</name>
    <message>
        <source>%1 point is too few for it</source>
        <translation>%1 punto es muy poco para ello</translation>
    </message>
</context>
<context>
    <name>analysis.one_start_and_finish</name>
    <message>
        <source>keep one start and one finish, or one gate with the role start_finish</source>
        <translation>deje una salida y una meta, o una puerta que sea ambas</translation>
    </message>
</context>
<context>
    <name>analysis.other_direction</name>
    <message>
        <source>%1 runs in the opposite direction to %2</source>
        <translation>%1 hace el camino en sentido contrario a %2</translation>
    </message>
</context>
<context>
    <name>analysis.outline_crosses</name>
    <message>
        <source>its outline crosses itself</source>
        <translation>su contorno se cruza a sí mismo</translation>
    </message>
</context>
<context>
    <name>analysis.path_too_short</name>
    <message>
        <source>it is shorter than 1 mm</source>
        <translation>mide menos de 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.place_no_number</name>
    <message>
        <source>its position is not a number</source>
        <translation>su lugar no es un número</translation>
    </message>
</context>
<context>
    <name>analysis.points_off_floor</name>
    <message>
        <source>its points are not all on a floor of 1 km</source>
        <translation>sus puntos no están en un suelo de 1 km</translation>
    </message>
</context>
<context>
    <name>analysis.points_out_of_range</name>
    <message>
        <source>its points are 0 or beyond ±1000</source>
        <translation>sus puntos son 0, o pasan de 1000</translation>
    </message>
</context>
<context>
    <name>analysis.points_too_few</name>
    <message>
        <source>%1 points are too few for it</source>
        <translation>%1 puntos son pocos para ello</translation>
    </message>
</context>
<context>
    <name>analysis.reference_path</name>
    <message>
        <source>reference path</source>
        <translation>trayectoria de referencia</translation>
    </message>
</context>
<context>
    <name>analysis.role</name>
    <message>
        <source>role &apos;%1&apos;</source>
        <translation>papel &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.rule</name>
    <message>
        <source>rule &apos;%1&apos;</source>
        <translation>regla &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.same_values</name>
    <message>
        <source>full points and no points have the same value</source>
        <translation>todos los puntos y ningún punto están en el mismo valor</translation>
    </message>
</context>
<context>
    <name>analysis.sample_coarsely</name>
    <message>
        <source>sample it with fewer points</source>
        <translation>tome menos puntos</translation>
    </message>
</context>
<context>
    <name>analysis.scoring</name>
    <message>
        <source>scoring</source>
        <translation>puntuación</translation>
    </message>
</context>
<context>
    <name>analysis.size_too_small</name>
    <message>
        <source>a size is less than 1 mm</source>
        <translation>un tamaño es menor de 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.start_is_there</name>
    <message>
        <source>gate &apos;%1&apos; is already the start</source>
        <translation>la puerta &apos;%1&apos; ya es la salida</translation>
    </message>
</context>
<context>
    <name>analysis.still_in_common_time</name>
    <message>
        <source>the robot does not move in the common time</source>
        <translation>el robot no se mueve en el tiempo común</translation>
    </message>
</context>
<context>
    <name>analysis.takes_two_runs</name>
    <message>
        <source>it needs two runs</source>
        <translation>hacen falta dos recorridos</translation>
    </message>
</context>
<context>
    <name>analysis.tell_moment_inside</name>
    <message>
        <source>enter one between its first and last frame</source>
        <translation>indique uno entre su primer y su último fotograma</translation>
    </message>
</context>
<context>
    <name>analysis.tell_moments</name>
    <message>
        <source>enter one for each run</source>
        <translation>indique uno para cada uno</translation>
    </message>
</context>
<context>
    <name>analysis.template</name>
    <message>
        <source>template &apos;%1&apos;</source>
        <translation>plantilla &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.template_of_task</name>
    <message>
        <source>template of a task</source>
        <translation>plantilla de una tarea</translation>
    </message>
</context>
<context>
    <name>analysis.turn_sign</name>
    <message>
        <source>change the sign of one of its coordinates</source>
        <translation>cambie el signo de una de sus coordenadas</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_best_lap</name>
    <message>
        <source>of its two passages; the calibration uncertainty of a gate passed twice cancels</source>
        <translation>de sus dos pasos; el error de calibración de una puerta por la que se pasa dos veces se cancela</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_circle_radius</name>
    <message>
        <source>of the scatter of the distances, with their number divided by 1 + 2Σρ for correlated neighbours, and the calibration&apos;s scale uncertainty</source>
        <translation>de la dispersión de las distancias, con el número efectivo de puntos reducido por 1 + 2Σρ, y el error de escala de la calibración</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_correlated</name>
    <message>
        <source>the bound for fully correlated errors, and the calibration&apos;s scale uncertainty</source>
        <translation>la cota para errores totalmente correlacionados, y el error de escala de la calibración</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_bias</name>
    <message>
        <source>of the position across the path, mostly the calibration&apos;s</source>
        <translation>de la posición transversal a la trayectoria, sobre todo la de la calibración</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_max</name>
    <message>
        <source>of the position across the path, there</source>
        <translation>de la posición transversal a la trayectoria, allí</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_mean</name>
    <message>
        <source>of the position across the path, and of its noise: the distance has no sign, so noise does not cancel</source>
        <translation>de la posición transversal a la trayectoria, y de su ruido, que allí no tiene signo</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_rms</name>
    <message>
        <source>of the position across the path</source>
        <translation>de la posición transversal a la trayectoria</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_duration</name>
    <message>
        <source>of both moments: σ of the speed divided by its slope there, and how far smoothing blurs them</source>
        <translation>de ambos instantes: σ de la velocidad dividida por su pendiente allí, y cuánto los difumina el suavizado</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_gate_time</name>
    <message>
        <source>of both passages: σ of the position across the gate divided by the speed</source>
        <translation>de ambos pasos: σ de la posición perpendicular a la puerta dividida por la velocidad</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_max_turn_rate</name>
    <message>
        <source>of the body: that of the smoothed heading&apos;s rate; of the direction of motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order</source>
        <translation>del cuerpo: la de la variación del rumbo suavizado; de la dirección del movimiento: σ² = σa²/|v|² + |a|²σv²/|v|⁴, primer orden</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_mean_lap</name>
    <message>
        <source>of the first and the last passage, over the number of laps</source>
        <translation>del primer y el último paso, dividido por el número de vueltas</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_mean_speed</name>
    <message>
        <source>of both, treated as independent, and of gaps: from straight through them to the top speed in them</source>
        <translation>de ambos, tomados como independientes, y de las lagunas: desde atravesarlas en línea recta hasta hacerlo a la velocidad máxima</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_moving_time</name>
    <message>
        <source>of each start and stop: σ of the speed divided by its slope</source>
        <translation>de cada arranque y parada: σ de la velocidad dividida por su pendiente</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_of_curve</name>
    <message>
        <source>that of the smoothed curve there, and the calibration&apos;s scale uncertainty</source>
        <translation>el de la curva suavizada allí, y el error de escala de la calibración</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_of_intervals</name>
    <message>
        <source>of the intervals within 1.5 σ of it, each by its mean</source>
        <translation>de los tramos a menos de 1,5 σ de ella, cada uno por su media</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_path_length</name>
    <message>
        <source>of the end positions, of lateral errors where the path turns, of what the robot could have done where it was bridged, and the calibration&apos;s scale uncertainty</source>
        <translation>de las posiciones de los extremos, de los errores transversales a la trayectoria donde esta gira, de lo que el robot pudo hacer en los tramos interpolados, y el error de escala de la calibración</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_standing_time</name>
    <message>
        <source>of each start and stop</source>
        <translation>de cada arranque y parada</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_straightness</name>
    <message>
        <source>of the end positions</source>
        <translation>de las posiciones de los extremos</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_zone_depth</name>
    <message>
        <source>of the position across the edge, there</source>
        <translation>de la posición perpendicular al borde, allí</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_zone_time</name>
    <message>
        <source>of each crossing of an edge: σ of the position across it divided by the speed; and the change of the time when the calibration uncertainty shifts the track</source>
        <translation>de cada instante en un borde: σ de la posición perpendicular a él dividida por la velocidad; y lo que cambia el tiempo cuando la calibración acerca o aleja la traza</translation>
    </message>
</context>
<context>
    <name>analysis.use_a_rule</name>
    <message>
        <source>use stay_inside or stay_outside</source>
        <translation>use stay_inside o stay_outside</translation>
    </message>
</context>
<context>
    <name>analysis.use_one_of</name>
    <message>
        <source>use %1</source>
        <translation>use %1</translation>
    </message>
</context>
<context>
    <name>analysis.wrong_poles</name>
    <message>
        <source>a slalom has 1 to 100 poles, not %1</source>
        <translation>un eslalon tiene de 1 a 100 postes, no %1</translation>
    </message>
</context>
<context>
    <name>analysis.zone</name>
    <message>
        <source>zone &apos;%1&apos;</source>
        <translation>zona &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>backup.disk_nearly_full</name>
    <message>
        <source>the disk has only %1 left</source>
        <translation>al disco solo le quedan %1</translation>
    </message>
</context>
<context>
    <name>backup.of_project</name>
    <message>
        <source>backup of &apos;%1&apos;</source>
        <translation>copia de seguridad de «%1»</translation>
    </message>
</context>
<context>
    <name>base.and</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
</context>
<context>
    <name>base.camera</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>cámara &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.cancelled</name>
    <message>
        <source>cancelled</source>
        <translation>cancelado</translation>
    </message>
</context>
<context>
    <name>base.cannot_do_this</name>
    <message>
        <source>cannot do this</source>
        <translation>esto no se puede hacer ahora</translation>
    </message>
</context>
<context>
    <name>base.class</name>
    <message>
        <source>class &apos;%1&apos;</source>
        <translation>clase &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.close_other_programs</name>
    <message>
        <source>close other programs and try again</source>
        <translation>cierre otros programas e inténtelo de nuevo</translation>
    </message>
</context>
<context>
    <name>base.colon</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>base.colour</name>
    <message>
        <source>colour &apos;%1&apos;</source>
        <translation>color &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.comma</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>base.file</name>
    <message>
        <source>file &apos;%1&apos;</source>
        <translation>archivo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.foreign</name>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
</context>
<context>
    <name>base.is_device</name>
    <message>
        <source>it is a device</source>
        <translation>es un dispositivo</translation>
    </message>
</context>
<context>
    <name>base.is_folder</name>
    <message>
        <source>it is a folder</source>
        <translation>es una carpeta</translation>
    </message>
</context>
<context>
    <name>base.is_pipe</name>
    <message>
        <source>it is a named pipe</source>
        <translation>es una tubería con nombre</translation>
    </message>
</context>
<context>
    <name>base.is_socket</name>
    <message>
        <source>it is a socket</source>
        <translation>es un socket</translation>
    </message>
</context>
<context>
    <name>base.layout</name>
    <message>
        <source>layout &apos;%1&apos;</source>
        <translation>plano &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.length</name>
    <message>
        <source>length &apos;%1&apos;</source>
        <translation>longitud &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.name</name>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
</context>
<context>
    <name>base.no_colour</name>
    <message>
        <source>not of the form #rrggbb</source>
        <translation>no tiene la forma #rrggbb</translation>
    </message>
</context>
<context>
    <name>base.no_files</name>
    <message>
        <source>too many files are open</source>
        <translation>hay demasiados archivos abiertos</translation>
    </message>
</context>
<context>
    <name>base.no_length</name>
    <message>
        <source>not a number with the unit mm, cm or m</source>
        <translation>no es un número con la unidad mm, cm o m</translation>
    </message>
</context>
<context>
    <name>base.no_memory</name>
    <message>
        <source>this computer does not have enough free memory for it</source>
        <translation>este ordenador no tiene suficiente memoria libre para ello</translation>
    </message>
</context>
<context>
    <name>base.no_number</name>
    <message>
        <source>not a finite decimal number</source>
        <translation>no es un número decimal finito</translation>
    </message>
</context>
<context>
    <name>base.no_thread</name>
    <message>
        <source>this computer cannot start another thread</source>
        <translation>este ordenador no da más hilos de ejecución</translation>
    </message>
</context>
<context>
    <name>base.none</name>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
</context>
<context>
    <name>base.nothing_changed</name>
    <message>
        <source>nothing was changed</source>
        <translation>no se cambió nada</translation>
    </message>
</context>
<context>
    <name>base.number</name>
    <message>
        <source>number &apos;%1&apos;</source>
        <translation>número &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.or</name>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
</context>
<context>
    <name>base.quoted_name</name>
    <message>
        <source>&apos;%1&apos;</source>
        <translation>&apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.robot</name>
    <message>
        <source>robot &apos;%1&apos;</source>
        <translation>robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.robot_in_trial</name>
    <message>
        <source>robot &apos;%1&apos; in trial &apos;%2&apos;</source>
        <translation>robot &apos;%1&apos; en el ensayo &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>base.saved_is_safe</name>
    <message>
        <source>what was saved is safe</source>
        <translation>lo que se había guardado está a salvo</translation>
    </message>
</context>
<context>
    <name>base.semicolon</name>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
</context>
<context>
    <name>base.space</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>base.task</name>
    <message>
        <source>task &apos;%1&apos;</source>
        <translation>tarea &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.team</name>
    <message>
        <source>team &apos;%1&apos;</source>
        <translation>equipo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.trial</name>
    <message>
        <source>trial &apos;%1&apos;</source>
        <translation>ensayo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.try_again_and_report</name>
    <message>
        <source>try again, and report it if it happens again</source>
        <translation>inténtelo de nuevo y avise si vuelve a ocurrir</translation>
    </message>
</context>
<context>
    <name>base.unexpected</name>
    <message>
        <source>something unexpected happened (%1)</source>
        <translation>ha ocurrido algo inesperado (%1)</translation>
    </message>
</context>
<context>
    <name>base.view_in_trial</name>
    <message>
        <source>view &apos;%1&apos; in trial &apos;%2&apos;</source>
        <translation>vista &apos;%1&apos; en el ensayo &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>base.wordless_exception</name>
    <message>
        <source>an unknown exception</source>
        <translation>una excepción sin descripción</translation>
    </message>
</context>
<context>
    <name>base.write_colour</name>
    <message>
        <source>write it like #d72328</source>
        <translation>escríbalo como #d72328</translation>
    </message>
</context>
<context>
    <name>base.write_length</name>
    <message>
        <source>write it like 25mm, 2.5cm or 0.3m</source>
        <translation>escríbalo como 25mm, 2.5cm o 0.3m</translation>
    </message>
</context>
<context>
    <name>base.write_number</name>
    <message>
        <source>write it with digits and a point, like 12.5</source>
        <translation>escríbalo con cifras y punto, como 12.5</translation>
    </message>
</context>
<context>
    <name>calibration.add_floor_points</name>
    <message>
        <source>add floor points, such as corners of tiles</source>
        <translation>añada puntos del suelo, como esquinas de baldosas</translation>
    </message>
</context>
<context>
    <name>calibration.all_agree</name>
    <message>
        <source>The markers and the cameras agree with each other.</source>
        <translation>Los marcadores y las cámaras concuerdan entre sí.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_changed</name>
    <message>
        <source>The world axes were changed afterwards.</source>
        <translation>Los ejes del mundo se cambiaron después.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_changed_and_scaled</name>
    <message>
        <source>The world axes were changed afterwards, and all lengths multiplied by %1.</source>
        <translation>Los ejes del mundo se cambiaron después, y todas las longitudes se multiplicaron por %1.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_no_number</name>
    <message>
        <source>the origin or the angle is not a finite number</source>
        <translation>el origen o el ángulo no es un número finito</translation>
    </message>
</context>
<context>
    <name>calibration.axes_not_changed</name>
    <message>
        <source>the axes of layout &apos;%1&apos; cannot be changed</source>
        <translation>no se pueden cambiar los ejes del plano &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.best_place</name>
    <message>
        <source>the best camera position</source>
        <translation>el mejor lugar para una cámara</translation>
    </message>
</context>
<context>
    <name>calibration.board_blurred</name>
    <message>
        <source>the board is blurred</source>
        <translation>el tablero está borroso</translation>
    </message>
</context>
<context>
    <name>calibration.board_cut_off</name>
    <message>
        <source>the board is cut off</source>
        <translation>el tablero está cortado</translation>
    </message>
</context>
<context>
    <name>calibration.board_fills</name>
    <message>
        <source>it fills %1 of the image</source>
        <translation>ocupa el %1 de la imagen</translation>
    </message>
</context>
<context>
    <name>calibration.board_in_one_place</name>
    <message>
        <source>all %1 images show the board in one position, the %2 %3 of the image</source>
        <translation>las %1 imágenes muestran el tablero en un mismo lugar (%2, %3 de la imagen)</translation>
    </message>
</context>
<context>
    <name>calibration.board_not_flat</name>
    <message>
        <source>the corners do not match a flat board</source>
        <translation>las esquinas no están como en un tablero plano</translation>
    </message>
</context>
<context>
    <name>calibration.board_not_sharp</name>
    <message>
        <source>the board is not sharp</source>
        <translation>el tablero no está nítido</translation>
    </message>
</context>
<context>
    <name>calibration.board_of_other_size</name>
    <message>
        <source>this board has %1 inner corners, not %2</source>
        <translation>este tablero tiene %1 esquinas interiores, se pidió %2</translation>
    </message>
</context>
<context>
    <name>calibration.board_part_seen</name>
    <message>
        <source>only %1 of its %2 inner corners are visible</source>
        <translation>solo se ven %1 de sus %2 esquinas interiores</translation>
    </message>
</context>
<context>
    <name>calibration.board_stands_as_before</name>
    <message>
        <source>the board is in the same position as in an earlier image</source>
        <translation>el tablero está igual que en una imagen ya tomada</translation>
    </message>
</context>
<context>
    <name>calibration.board_stands_as_in</name>
    <message>
        <source>the board is in the same position as in %1</source>
        <translation>el tablero está igual que en %1</translation>
    </message>
</context>
<context>
    <name>calibration.board_too_oblique</name>
    <message>
        <source>the board is tilted too far, by %1 degrees</source>
        <translation>el tablero se ve demasiado oblicuo, a %1 grados</translation>
    </message>
</context>
<context>
    <name>calibration.board_too_small</name>
    <message>
        <source>the board is too small</source>
        <translation>el tablero es demasiado pequeño</translation>
    </message>
</context>
<context>
    <name>calibration.calibrate_to_rely</name>
    <message>
        <source>Calibrate it for reliable positions.</source>
        <translation>Calíbrela para obtener posiciones fiables.</translation>
    </message>
</context>
<context>
    <name>calibration.camera_alone_says</name>
    <message>
        <source>Camera &apos;%1&apos; alone measures %2</source>
        <translation>La cámara &apos;%1&apos; por sí sola indica %2</translation>
    </message>
</context>
<context>
    <name>calibration.camera_below_floor</name>
    <message>
        <source>in this order the camera would be below the floor</source>
        <translation>en este orden la cámara estaría bajo el suelo</translation>
    </message>
</context>
<context>
    <name>calibration.camera_moved</name>
    <message>
        <source>%1 has moved %2 = %3</source>
        <translation>%1 se ha movido %2 = %3</translation>
    </message>
</context>
<context>
    <name>calibration.camera_sees_elsewhere</name>
    <message>
        <source>%1 sees %2 %3 from where the others see it</source>
        <translation>%1 ve %2 a %3 de donde lo ven las demás</translation>
    </message>
</context>
<context>
    <name>calibration.camera_sees_too_few</name>
    <message>
        <source>camera &apos;%1&apos; sees only %2 of the markers</source>
        <translation>la cámara &apos;%1&apos; solo ve %2 de los marcadores</translation>
    </message>
</context>
<context>
    <name>calibration.camera_stands_low</name>
    <message>
        <source>The camera would be only %1 above the floor</source>
        <translation>La cámara estaría a solo %1 del suelo</translation>
    </message>
</context>
<context>
    <name>calibration.camera_still</name>
    <message>
        <source>%1 has not moved</source>
        <translation>%1 está donde se registró</translation>
    </message>
</context>
<context>
    <name>calibration.camera_too_high</name>
    <message>
        <source>the camera would be %1 above the floor</source>
        <translation>la cámara estaría a %1 del suelo</translation>
    </message>
</context>
<context>
    <name>calibration.camera_too_low</name>
    <message>
        <source>the camera would be only %1 above the floor</source>
        <translation>la cámara estaría a solo %1 del suelo</translation>
    </message>
</context>
<context>
    <name>calibration.camera_twice</name>
    <message>
        <source>camera &apos;%1&apos; appears twice</source>
        <translation>la cámara &apos;%1&apos; está dos veces</translation>
    </message>
</context>
<context>
    <name>calibration.camera_upside_down</name>
    <message>
        <source>The camera would be upside down</source>
        <translation>La cámara estaría boca abajo</translation>
    </message>
</context>
<context>
    <name>calibration.cameras_of_one_image</name>
    <message>
        <source>%1 and %2 have the same pixels and count as one camera.</source>
        <translation>%1 y %2 tienen los mismos píxeles y cuentan como una sola cámara.</translation>
    </message>
</context>
<context>
    <name>calibration.cameras_undetermined</name>
    <message>
        <source>the markers do not determine the camera positions</source>
        <translation>los marcadores no determinan dónde están las cámaras</translation>
    </message>
</context>
<context>
    <name>calibration.cannot_be_calibrated</name>
    <message>
        <source>the camera cannot be calibrated</source>
        <translation>la cámara no se puede calibrar</translation>
    </message>
</context>
<context>
    <name>calibration.centimetres</name>
    <message>
        <source>centimetres</source>
        <translation>centímetros</translation>
    </message>
</context>
<context>
    <name>calibration.centre_is_off</name>
    <message>
        <source>The optical centre is %1 off the image&apos;s middle</source>
        <translation>El centro óptico está a %1 del centro de la imagen</translation>
    </message>
</context>
<context>
    <name>calibration.check_all</name>
    <message>
        <source>check the layout, the labels and the intrinsics</source>
        <translation>compruebe el plano, los rótulos y los parámetros intrínsecos</translation>
    </message>
</context>
<context>
    <name>calibration.check_both_lenses</name>
    <message>
        <source>check its pixels and the intrinsics of both cameras</source>
        <translation>compruebe sus píxeles y los parámetros intrínsecos de ambas cámaras</translation>
    </message>
</context>
<context>
    <name>calibration.check_both_pixels</name>
    <message>
        <source>check its pixels in both images</source>
        <translation>compruebe sus píxeles en ambas imágenes</translation>
    </message>
</context>
<context>
    <name>calibration.check_columns</name>
    <message>
        <source>check which columns belong to which camera</source>
        <translation>compruebe qué columnas son de qué cámara</translation>
    </message>
</context>
<context>
    <name>calibration.check_first_registration</name>
    <message>
        <source>check the registration of %1 and the pair</source>
        <translation>compruebe el registro de %1 y el par</translation>
    </message>
</context>
<context>
    <name>calibration.check_labels</name>
    <message>
        <source>check these labels</source>
        <translation>compruebe estos rótulos</translation>
    </message>
</context>
<context>
    <name>calibration.check_layout_places</name>
    <message>
        <source>check the layout&apos;s positions and their unit, cover other round objects, or mark the markers by hand</source>
        <translation>compruebe los lugares del plano y su unidad, tape otras cosas redondas, o marque los marcadores a mano</translation>
    </message>
</context>
<context>
    <name>calibration.check_length</name>
    <message>
        <source>Check the length itself, that it is on the floor, and the marker positions.</source>
        <translation>Compruebe la longitud misma, si está en el suelo y los lugares de los marcadores.</translation>
    </message>
</context>
<context>
    <name>calibration.check_one_camera</name>
    <message>
        <source>check that all are of one camera, at one zoom and focus</source>
        <translation>compruebe que todas son de una cámara, con un mismo zoom y enfoque</translation>
    </message>
</context>
<context>
    <name>calibration.check_pictures</name>
    <message>
        <source>check that all images are sharp, of one flat board and of one camera at one zoom and focus</source>
        <translation>compruebe que todas las imágenes son nítidas, de un mismo tablero plano y de una cámara con un mismo zoom y enfoque</translation>
    </message>
</context>
<context>
    <name>calibration.check_pixel_and_lens</name>
    <message>
        <source>check its pixel and the camera&apos;s intrinsics</source>
        <translation>compruebe su píxel y los parámetros intrínsecos de la cámara</translation>
    </message>
</context>
<context>
    <name>calibration.check_place_and_pixel</name>
    <message>
        <source>check its position and its pixel</source>
        <translation>compruebe su lugar y su píxel</translation>
    </message>
</context>
<context>
    <name>calibration.check_point_labels</name>
    <message>
        <source>check which label belongs to which point in %1 and in this camera</source>
        <translation>compruebe qué rótulo corresponde a qué punto en %1 y en esta cámara</translation>
    </message>
</context>
<context>
    <name>calibration.check_signs</name>
    <message>
        <source>check the signs of the layout</source>
        <translation>compruebe los signos del plano</translation>
    </message>
</context>
<context>
    <name>calibration.check_tag_places</name>
    <message>
        <source>check the layout&apos;s positions and their unit, or mark the markers by hand</source>
        <translation>compruebe las posiciones del plano y su unidad, o marque los marcadores a mano</translation>
    </message>
</context>
<context>
    <name>calibration.check_unit</name>
    <message>
        <source>check the unit of the layout</source>
        <translation>compruebe la unidad del plano</translation>
    </message>
</context>
<context>
    <name>calibration.checking_halves</name>
    <message>
        <source>checking the halves against each other</source>
        <translation>comprobando las mitades entre sí</translation>
    </message>
</context>
<context>
    <name>calibration.choose_floor_points</name>
    <message>
        <source>choose points on the floor</source>
        <translation>elija puntos del suelo</translation>
    </message>
</context>
<context>
    <name>calibration.choose_others</name>
    <message>
        <source>choose others</source>
        <translation>elija otras</translation>
    </message>
</context>
<context>
    <name>calibration.clear_view</name>
    <message>
        <source>clear the view of the markers</source>
        <translation>despeje la vista de los marcadores</translation>
    </message>
</context>
<context>
    <name>calibration.common_and_unknown_markers</name>
    <message>
        <source>they have %1 (%2), and the layout does not contain %3</source>
        <translation>hay %1 (%2), y el plano no conoce %3</translation>
    </message>
</context>
<context>
    <name>calibration.common_markers</name>
    <message>
        <source>they have %1 (%2)</source>
        <translation>hay %1 (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.convert_unit</name>
    <message>
        <source>convert its unit.</source>
        <translation>convierta su unidad.</translation>
    </message>
</context>
<context>
    <name>calibration.corner_left_out</name>
    <message>
        <source>1 outlier corner was left out, in %1.</source>
        <translation>se omitió 1 esquina que se aparta, en %1.</translation>
    </message>
</context>
<context>
    <name>calibration.corner_no_number</name>
    <message>
        <source>a corner of it is not a number</source>
        <translation>una de sus esquinas no es un número</translation>
    </message>
</context>
<context>
    <name>calibration.corner_of_many_tags</name>
    <message>
        <source>a corner is that of one tag</source>
        <translation>una esquina es de un solo tag</translation>
    </message>
</context>
<context>
    <name>calibration.corner_unclear</name>
    <message>
        <source>one corner of the board is unclear</source>
        <translation>no se distingue una esquina del tablero</translation>
    </message>
</context>
<context>
    <name>calibration.corners_disagree</name>
    <message>
        <source>%1 of the corners do not agree with the others</source>
        <translation>el %1 de las esquinas no concuerda con las demás</translation>
    </message>
</context>
<context>
    <name>calibration.corners_kept_in</name>
    <message>
        <source>%1 neighbouring outlier corners were kept, in %2</source>
        <translation>se conservaron %1 esquinas contiguas que se apartan, en %2</translation>
    </message>
</context>
<context>
    <name>calibration.corners_kept_most_in</name>
    <message>
        <source>%1 neighbouring outlier corners were kept, most in %2</source>
        <translation>se conservaron %1 esquinas contiguas que se apartan, la mayoría en %2</translation>
    </message>
</context>
<context>
    <name>calibration.corners_left_out_in</name>
    <message>
        <source>%1 outlier corners were left out, in %2.</source>
        <translation>se omitieron %1 esquinas que se apartan, en %2.</translation>
    </message>
</context>
<context>
    <name>calibration.corners_left_out_most_in</name>
    <message>
        <source>%1 outlier corners were left out, most in %2.</source>
        <translation>se omitieron %1 esquinas que se apartan, la mayoría en %2.</translation>
    </message>
</context>
<context>
    <name>calibration.corners_not_flat</name>
    <message>
        <source>its corners do not match a flat board</source>
        <translation>sus esquinas no están como en un tablero plano</translation>
    </message>
</context>
<context>
    <name>calibration.corners_nowhere_near</name>
    <message>
        <source>its corners are %1 from where the other images predict them, theirs %2</source>
        <translation>sus esquinas están a %1 de donde las predicen las demás imágenes; las de estas, a %2</translation>
    </message>
</context>
<context>
    <name>calibration.correct_layout</name>
    <message>
        <source>correct the layout</source>
        <translation>corrija el plano</translation>
    </message>
</context>
<context>
    <name>calibration.correct_pixels</name>
    <message>
        <source>correct the pixels</source>
        <translation>corrija los píxeles</translation>
    </message>
</context>
<context>
    <name>calibration.count_corners</name>
    <message>
        <source>count the inner corners, or leave the size out</source>
        <translation>cuente las esquinas interiores, u omita el tamaño</translation>
    </message>
</context>
<context>
    <name>calibration.disagree_in</name>
    <message>
        <source>%1 of the corners disagree, in %2</source>
        <translation>el %1 de las esquinas discrepan, en %2</translation>
    </message>
</context>
<context>
    <name>calibration.disagree_most_in</name>
    <message>
        <source>%1 of the corners disagree, most in %2</source>
        <translation>el %1 de las esquinas discrepan, la mayoría en %2</translation>
    </message>
</context>
<context>
    <name>calibration.done</name>
    <message>
        <source>done</source>
        <translation>listo</translation>
    </message>
</context>
<context>
    <name>calibration.edges_wide</name>
    <message>
        <source>its edges are %1 pixels wide</source>
        <translation>sus bordes tienen %1 píxeles de ancho</translation>
    </message>
</context>
<context>
    <name>calibration.ends_on_one_pixel</name>
    <message>
        <source>both ends are on the same pixel of camera &apos;%1&apos;</source>
        <translation>ambos extremos están en un mismo píxel de la cámara &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.far_edge</name>
    <message>
        <source>at the far edge</source>
        <translation>en el borde lejano</translation>
    </message>
</context>
<context>
    <name>calibration.far_left_corner</name>
    <message>
        <source>in the far left corner</source>
        <translation>en la esquina izquierda lejana</translation>
    </message>
</context>
<context>
    <name>calibration.far_right_corner</name>
    <message>
        <source>in the far right corner</source>
        <translation>en la esquina derecha lejana</translation>
    </message>
</context>
<context>
    <name>calibration.few_corners_seen</name>
    <message>
        <source>only %1 corners of the board are visible</source>
        <translation>solo se ven %1 esquinas del tablero</translation>
    </message>
</context>
<context>
    <name>calibration.fifth_would</name>
    <message>
        <source>add a fifth.</source>
        <translation>un quinto sí lo haría.</translation>
    </message>
</context>
<context>
    <name>calibration.find_board_again</name>
    <message>
        <source>detect the board in it again</source>
        <translation>haga que se busque de nuevo el tablero en ella</translation>
    </message>
</context>
<context>
    <name>calibration.first_end_beyond</name>
    <message>
        <source>the first end is at or beyond the horizon of camera &apos;%1&apos;</source>
        <translation>el primer extremo está en el horizonte de la cámara &apos;%1&apos; o más allá</translation>
    </message>
</context>
<context>
    <name>calibration.fisheye</name>
    <message>
        <source>fisheye</source>
        <translation>ojo de pez</translation>
    </message>
</context>
<context>
    <name>calibration.fisheye_lens</name>
    <message>
        <source>Fisheye lens</source>
        <translation>Lente ojo de pez</translation>
    </message>
</context>
<context>
    <name>calibration.fit_only_to</name>
    <message>
        <source>the markers fit only to %1</source>
        <translation>los marcadores solo encajan con %1</translation>
    </message>
</context>
<context>
    <name>calibration.fits_without</name>
    <message>
        <source>without %1 the others fit to %2: check its position and its pixel</source>
        <translation>sin %1 los demás encajan con %2: compruebe su posición y su píxel</translation>
    </message>
</context>
<context>
    <name>calibration.fitting_lens</name>
    <message>
        <source>fitting the lens model to %1 images</source>
        <translation>ajustando la lente a %1 imágenes</translation>
    </message>
</context>
<context>
    <name>calibration.flip_image</name>
    <message>
        <source>switch off mirroring in the camera or its program, or flip the file</source>
        <translation>desactive el reflejo en la cámara o su programa, o voltee el archivo</translation>
    </message>
</context>
<context>
    <name>calibration.floor_may_be_mirrored</name>
    <message>
        <source>if it is not, v is counted from below, and the labels are mirrored.</source>
        <translation>si no lo está, v se cuenta desde abajo y las etiquetas están reflejadas.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_not_registered</name>
    <message>
        <source>the floor cannot be registered</source>
        <translation>no se puede registrar el suelo</translation>
    </message>
</context>
<context>
    <name>calibration.floor_part_unseen</name>
    <message>
        <source>%1 of the floor between the markers is out of view.</source>
        <translation>No se ve el %1 del suelo entre los marcadores.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_unseen</name>
    <message>
        <source>None of the floor between the markers is in view.</source>
        <translation>No se ve nada del suelo entre los marcadores.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_unsure</name>
    <message>
        <source>the floor uncertainty between the points is too large, ±%1</source>
        <translation>el suelo entre los puntos se conoce solo a ±%1</translation>
    </message>
</context>
<context>
    <name>calibration.focal_length_groups</name>
    <message>
        <source>%1 give about %2, %3 (such as %4) give about %5</source>
        <translation>%1 unos %2, %3 (como %4) unos %5</translation>
    </message>
</context>
<context>
    <name>calibration.focal_length_unsure</name>
    <message>
        <source>the images determine the focal length only to %1</source>
        <translation>las imágenes determinan la distancia focal solo al %1</translation>
    </message>
</context>
<context>
    <name>calibration.focal_lengths_differ</name>
    <message>
        <source>The focal lengths across and down differ by %1</source>
        <translation>Las distancias focales horizontal y vertical difieren en un %1</translation>
    </message>
</context>
<context>
    <name>calibration.focus_or_light</name>
    <message>
        <source>focus the camera, or give more light</source>
        <translation>enfoque la cámara, o dé más luz</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_as_well</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model no better (%3)</source>
        <translation>predice imágenes reservadas a %1, el modelo %2 no lo hace mejor (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_better</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model only to %3</source>
        <translation>predice imágenes reservadas a %1, el modelo %2 solo a %3</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_by_chance</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model to %3; the difference may be chance</source>
        <translation>predice imágenes reservadas a %1, el modelo %2 a %3, lo que puede ser casualidad</translation>
    </message>
</context>
<context>
    <name>calibration.four_common_markers</name>
    <message>
        <source>the layout and the image must have four markers in common</source>
        <translation>se necesitan cuatro marcadores comunes al plano y a la imagen</translation>
    </message>
</context>
<context>
    <name>calibration.four_markers_unchecked</name>
    <message>
        <source>Four markers are too few to check each other</source>
        <translation>Cuatro marcadores apenas se comprueban entre sí</translation>
    </message>
</context>
<context>
    <name>calibration.four_points_unchecked</name>
    <message>
        <source>Four points are too few to check each other</source>
        <translation>Cuatro puntos apenas se comprueban entre sí</translation>
    </message>
</context>
<context>
    <name>calibration.four_shared_points</name>
    <message>
        <source>both cameras must see the same four points or more</source>
        <translation>se necesitan cuatro puntos que vean ambas cámaras</translation>
    </message>
</context>
<context>
    <name>calibration.give_board_size</name>
    <message>
        <source>give at least 3x3, such as 9x6, or leave the size out</source>
        <translation>dé al menos 3x3, como 9x6, u omita el tamaño</translation>
    </message>
</context>
<context>
    <name>calibration.give_distance</name>
    <message>
        <source>give a distance of 0 m to 1000 m</source>
        <translation>dé una distancia de 0 m a 1000 m</translation>
    </message>
</context>
<context>
    <name>calibration.give_field_of_view</name>
    <message>
        <source>give 2° to 150°, and the image size</source>
        <translation>dé de 2° a 150°, y el tamaño de sus imágenes</translation>
    </message>
</context>
<context>
    <name>calibration.give_height</name>
    <message>
        <source>give a height of 0.05 m to 100 m</source>
        <translation>dé una altura de 0,05 m a 100 m</translation>
    </message>
</context>
<context>
    <name>calibration.give_one_of_them</name>
    <message>
        <source>give one of them</source>
        <translation>dé uno de ellos</translation>
    </message>
</context>
<context>
    <name>calibration.give_plain_numbers</name>
    <message>
        <source>give plain numbers</source>
        <translation>dé números corrientes</translation>
    </message>
</context>
<context>
    <name>calibration.give_positive_number</name>
    <message>
        <source>give a number above 0</source>
        <translation>dé un número mayor que 0</translation>
    </message>
</context>
<context>
    <name>calibration.give_square_size</name>
    <message>
        <source>give a size such as 25mm</source>
        <translation>dé por ejemplo 25mm</translation>
    </message>
</context>
<context>
    <name>calibration.give_tape_sigma</name>
    <message>
        <source>give about 2 mm</source>
        <translation>dé unos 2 mm</translation>
    </message>
</context>
<context>
    <name>calibration.give_taped_length</name>
    <message>
        <source>enter the length measured with a tape</source>
        <translation>dé la longitud medida con una cinta métrica</translation>
    </message>
</context>
<context>
    <name>calibration.glue_board</name>
    <message>
        <source>glue the board onto something stiff</source>
        <translation>pegue el tablero sobre algo rígido</translation>
    </message>
</context>
<context>
    <name>calibration.glue_board_flat</name>
    <message>
        <source>glue the board onto something stiff and flat</source>
        <translation>pegue el tablero sobre algo rígido y plano</translation>
    </message>
</context>
<context>
    <name>calibration.good</name>
    <message>
        <source>Good: %1.</source>
        <translation>Bueno: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.grows_beyond</name>
    <message>
        <source>Beyond the markers it grows, to ±%1 within %2 of them.</source>
        <translation>Más allá de los marcadores crece, hasta ±%1 a menos de %2 de ellos.</translation>
    </message>
</context>
<context>
    <name>calibration.halves_contradict</name>
    <message>
        <source>two halves of the images give focal lengths that differ by %1</source>
        <translation>dos mitades de las imágenes dan distancias focales que difieren en un %1</translation>
    </message>
</context>
<context>
    <name>calibration.halves_foretell</name>
    <message>
        <source>each half of the images predicts the other to %1</source>
        <translation>cada mitad predice la otra a %1</translation>
    </message>
</context>
<context>
    <name>calibration.halves_foretell_apart</name>
    <message>
        <source>each half of the images predicts the other to %1, at most %2 apart on that floor</source>
        <translation>cada mitad predice la otra a %1, con %2 de separación como máximo en ese suelo</translation>
    </message>
</context>
<context>
    <name>calibration.held_out_markers</name>
    <message>
        <source>Markers that are left out one by one are predicted to %1 RMS.</source>
        <translation>Los marcadores que se dejan fuera uno a uno se predicen con %1 RMS.</translation>
    </message>
</context>
<context>
    <name>calibration.hold_board_closer</name>
    <message>
        <source>hold it closer to the camera</source>
        <translation>acérquelo a la cámara</translation>
    </message>
</context>
<context>
    <name>calibration.hold_board_still</name>
    <message>
        <source>hold it still, and focus the camera</source>
        <translation>manténgalo quieto y enfoque la cámara</translation>
    </message>
</context>
<context>
    <name>calibration.image_and_reason</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.image_may_be_cropped</name>
    <message>
        <source>if these images were cropped, the videos must be cropped alike</source>
        <translation>si estas imágenes se recortaron, los vídeos deben recortarse igual</translation>
    </message>
</context>
<context>
    <name>calibration.image_mirrored</name>
    <message>
        <source>mirrored left to right they fit to %1: is the image mirrored?</source>
        <translation>reflejados de izquierda a derecha encajan con %1: ¿está reflejada la imagen?</translation>
    </message>
</context>
<context>
    <name>calibration.image_repeats</name>
    <message>
        <source>1 of %1 images shows the board in the same position as another one, and each position counts once</source>
        <translation>1 de %1 imágenes muestra el tablero en la misma posición que otra, y cada posición cuenta una vez</translation>
    </message>
</context>
<context>
    <name>calibration.images_left_out</name>
    <message>
        <source>Left out: %1.</source>
        <translation>Descartadas: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.images_left_out_among</name>
    <message>
        <source>%1 images were left out, among them %2.</source>
        <translation>Se descartaron %1 imágenes, entre ellas %2.</translation>
    </message>
</context>
<context>
    <name>calibration.images_repeat</name>
    <message>
        <source>%1 of %2 images show the board in the same position as another one, and each position counts once</source>
        <translation>%1 de %2 imágenes muestran el tablero en la misma posición que otra, y cada posición cuenta una vez</translation>
    </message>
</context>
<context>
    <name>calibration.inches</name>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
</context>
<context>
    <name>calibration.inside</name>
    <message>
        <source>inside</source>
        <translation>en el interior</translation>
    </message>
</context>
<context>
    <name>calibration.inside_expected_error</name>
    <message>
        <source>within the limit of %1 (2.5 σ).</source>
        <translation>dentro del error esperado de %1.</translation>
    </message>
</context>
<context>
    <name>calibration.keep_board_clear</name>
    <message>
        <source>keep the board clear and well lit</source>
        <translation>mantenga el tablero despejado y bien iluminado</translation>
    </message>
</context>
<context>
    <name>calibration.keep_whole_board</name>
    <message>
        <source>keep the whole board in view</source>
        <translation>mantenga todo el tablero en la imagen</translation>
    </message>
</context>
<context>
    <name>calibration.label_each_marker</name>
    <message>
        <source>give each marker a label of its own</source>
        <translation>dé a cada marcador un rótulo propio</translation>
    </message>
</context>
<context>
    <name>calibration.label_each_point</name>
    <message>
        <source>give each point a label of its own</source>
        <translation>dé a cada punto un rótulo propio</translation>
    </message>
</context>
<context>
    <name>calibration.label_of_layout</name>
    <message>
        <source>label &apos;%1&apos; of the layout</source>
        <translation>etiqueta &apos;%1&apos; del plano</translation>
    </message>
</context>
<context>
    <name>calibration.labels_called</name>
    <message>
        <source>with %1 renamed %2 they fit to %3</source>
        <translation>llamando a %1 como %2 encajan a %3</translation>
    </message>
</context>
<context>
    <name>calibration.labels_exchanged</name>
    <message>
        <source>with %1 and %2 swapped they fit to %3</source>
        <translation>con %1 y %2 intercambiados encajan a %3</translation>
    </message>
</context>
<context>
    <name>calibration.lay_stick_nearer</name>
    <message>
        <source>put the stick on the floor, nearer to the camera</source>
        <translation>ponga la vara en el suelo, más cerca de la cámara</translation>
    </message>
</context>
<context>
    <name>calibration.layout_in_mm</name>
    <message>
        <source>it must be in mm</source>
        <translation>se da en mm</translation>
    </message>
</context>
<context>
    <name>calibration.layout_mirrored</name>
    <message>
        <source>with a reversed Y of the layout they fit to %1: check the signs of the layout, seen from above Y must point to the left of X</source>
        <translation>con Y de la disposición invertida encajan con %1: compruebe los signos de la disposición; vista desde arriba, Y debe apuntar a la izquierda de X</translation>
    </message>
</context>
<context>
    <name>calibration.layout_not_in_mm</name>
    <message>
        <source>if that is wrong, the layout is not in mm</source>
        <translation>si no es así, los números del plano no son mm</translation>
    </message>
</context>
<context>
    <name>calibration.layout_too_small</name>
    <message>
        <source>the layout has %1 markers, four are needed</source>
        <translation>el plano tiene %1 marcadores, hacen falta cuatro</translation>
    </message>
</context>
<context>
    <name>calibration.layout_written_mirrored</name>
    <message>
        <source>if the layout was written down mirrored, correct its signs and add it again</source>
        <translation>si el plano se anotó en espejo, corrija sus signos y añádalo de nuevo</translation>
    </message>
</context>
<context>
    <name>calibration.leave_one_tag</name>
    <message>
        <source>leave one of them on the floor</source>
        <translation>deje uno de ellos en el suelo</translation>
    </message>
</context>
<context>
    <name>calibration.leave_out_pictures</name>
    <message>
        <source>leave out these images if the board is bent, cut or covered there.</source>
        <translation>omita estas imágenes si el tablero está doblado, cortado o tapado ahí.</translation>
    </message>
</context>
<context>
    <name>calibration.left_edge</name>
    <message>
        <source>at the left edge</source>
        <translation>en el borde izquierdo</translation>
    </message>
</context>
<context>
    <name>calibration.length_factor</name>
    <message>
        <source>a length factor of %1 is not possible</source>
        <translation>un factor de longitud de %1 no da un suelo</translation>
    </message>
</context>
<context>
    <name>calibration.length_is</name>
    <message>
        <source>The length is %1 ± %2.</source>
        <translation>La longitud es %1 ± %2.</translation>
    </message>
</context>
<context>
    <name>calibration.length_longer</name>
    <message>
        <source>It is %1 longer than the %2 entered</source>
        <translation>Es %1 más larga que los %2 indicados</translation>
    </message>
</context>
<context>
    <name>calibration.length_shorter</name>
    <message>
        <source>It is %1 shorter than the %2 entered</source>
        <translation>Es %1 más corta que los %2 indicados</translation>
    </message>
</context>
<context>
    <name>calibration.length_unmeasured</name>
    <message>
        <source>the length cannot be measured</source>
        <translation>no se puede medir la longitud</translation>
    </message>
</context>
<context>
    <name>calibration.length_unseen</name>
    <message>
        <source>no camera shows it</source>
        <translation>no se dio ninguna cámara que la vea</translation>
    </message>
</context>
<context>
    <name>calibration.lens_assumed</name>
    <message>
        <source>The lens is not calibrated, and the markers hardly determine it (focal length %1 ± %2): what is not known of it is in the uncertainty.</source>
        <translation>El objetivo no está calibrado y los marcadores apenas lo determinan (distancia focal %1 ± %2): lo que no se sabe de él está en la incertidumbre.</translation>
    </message>
</context>
<context>
    <name>calibration.lens_from_floor</name>
    <message>
        <source>The lens is not calibrated: focal length (%1 ± %2) and distortion (k1 %3 ± %4) were estimated from the markers.</source>
        <translation>El objetivo no está calibrado: la distancia focal (%1 ± %2) y la distorsión (k1 %3 ± %4) se estimaron a partir de los marcadores.</translation>
    </message>
</context>
<context>
    <name>calibration.lens_of_other_camera</name>
    <message>
        <source>with the lens calibration of camera &apos;%1&apos; they fit to %2: are the views swapped?</source>
        <translation>con la calibración del objetivo de la cámara «%1» encajan con %2: ¿están intercambiadas las vistas?</translation>
    </message>
</context>
<context>
    <name>calibration.lens_on_floor</name>
    <message>
        <source>±%1 in the middle and at most ±%2 (%3) on %4, from the lens calibration alone</source>
        <translation>±%1 en el centro y ±%2 en el peor caso (%3) en %4, en lo que respecta a la lente</translation>
    </message>
</context>
<context>
    <name>calibration.lens_told</name>
    <message>
        <source>as specified</source>
        <translation>indicado</translation>
    </message>
</context>
<context>
    <name>calibration.lens_unknown_elsewhere</name>
    <message>
        <source>the distortion elsewhere stays unknown</source>
        <translation>se desconoce cómo deforma la lente en otros lugares</translation>
    </message>
</context>
<context>
    <name>calibration.likely_unit</name>
    <message>
        <source>its numbers look like %1, with the camera %2 above the floor</source>
        <translation>sus números parecen %1, y entonces estaría a %2 sobre el suelo</translation>
    </message>
</context>
<context>
    <name>calibration.longer</name>
    <message>
        <source>longer</source>
        <translation>más largos</translation>
    </message>
</context>
<context>
    <name>calibration.look_at</name>
    <message>
        <source>Check %1</source>
        <translation>Mire %1</translation>
    </message>
</context>
<context>
    <name>calibration.look_at_ends</name>
    <message>
        <source>check that the same ends are marked in each image; if they are, register it again.</source>
        <translation>mire si están marcados los mismos extremos en cada imagen y, si lo están, regístrela de nuevo.</translation>
    </message>
</context>
<context>
    <name>calibration.look_at_pictures</name>
    <message>
        <source>check these images and leave out those that are blurred, bent or of another board.</source>
        <translation>mire estas imágenes y omita las borrosas, dobladas o de otro tablero.</translation>
    </message>
</context>
<context>
    <name>calibration.looking_about</name>
    <message>
        <source>searching around the best position</source>
        <translation>buscando alrededor del mejor lugar</translation>
    </message>
</context>
<context>
    <name>calibration.make_larger_layout</name>
    <message>
        <source>make a layout of four markers or more</source>
        <translation>haga un plano de cuatro marcadores o más</translation>
    </message>
</context>
<context>
    <name>calibration.mark_ends_in_one</name>
    <message>
        <source>mark its ends in at least one image</source>
        <translation>marque sus extremos en al menos una imagen</translation>
    </message>
</context>
<context>
    <name>calibration.mark_more</name>
    <message>
        <source>mark more of the layout&apos;s markers, by their names in the layout</source>
        <translation>marque más marcadores del plano, con los nombres del plano</translation>
    </message>
</context>
<context>
    <name>calibration.mark_there_again</name>
    <message>
        <source>mark it again in that view.</source>
        <translation>márquelo ahí de nuevo.</translation>
    </message>
</context>
<context>
    <name>calibration.mark_two_ends</name>
    <message>
        <source>mark each end at its own position in the image</source>
        <translation>marque los dos extremos donde se ven</translation>
    </message>
</context>
<context>
    <name>calibration.mark_where_seen</name>
    <message>
        <source>mark each of them at its own position in the image</source>
        <translation>marque cada uno donde se ve</translation>
    </message>
</context>
<context>
    <name>calibration.marker_against_lens</name>
    <message>
        <source>this camera&apos;s lens model cannot project %1</source>
        <translation>%1 está donde la lente de esta cámara no puede haberlo puesto</translation>
    </message>
</context>
<context>
    <name>calibration.marker_beyond_horizon</name>
    <message>
        <source>marker %1 would be at or beyond the horizon</source>
        <translation>el marcador %1 estaría en el horizonte o más allá</translation>
    </message>
</context>
<context>
    <name>calibration.marker_moved</name>
    <message>
        <source>Marker %1 has moved %2 = %3, %4 has not</source>
        <translation>El marcador %1 se ha movido %2 = %3, %4 no</translation>
    </message>
</context>
<context>
    <name>calibration.marker_off_by_all</name>
    <message>
        <source>%1 is %2 off in all cameras</source>
        <translation>%1 está desviado %2 según todas las cámaras</translation>
    </message>
</context>
<context>
    <name>calibration.marker_off_by_one</name>
    <message>
        <source>%1 is %2 off in the one camera that sees it</source>
        <translation>%1 está desviado %2 según la única cámara que lo ve</translation>
    </message>
</context>
<context>
    <name>calibration.marker_pixel_no_number</name>
    <message>
        <source>the pixel of marker %1 is not a finite number</source>
        <translation>el píxel del marcador %1 no es un número finito</translation>
    </message>
</context>
<context>
    <name>calibration.marker_place_no_number</name>
    <message>
        <source>the position of marker %1 is not a finite number</source>
        <translation>el lugar del marcador %1 no es un número finito</translation>
    </message>
</context>
<context>
    <name>calibration.marker_twice_in_layout</name>
    <message>
        <source>marker %1 appears twice in the layout</source>
        <translation>el marcador %1 está dos veces en el plano</translation>
    </message>
</context>
<context>
    <name>calibration.marker_twice_in_picture</name>
    <message>
        <source>marker %1 appears twice in the image</source>
        <translation>el marcador %1 está dos veces en la imagen</translation>
    </message>
</context>
<context>
    <name>calibration.markers_at_one_place</name>
    <message>
        <source>markers %1 and %2 have the same floor position</source>
        <translation>los marcadores %1 y %2 están en un mismo lugar del suelo</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit</name>
    <message>
        <source>%1 markers fit to %2 RMS (worst %3, %4); floor uncertainty ±%5</source>
        <translation>%1 marcadores se ajustan a %2 RMS (el peor %3, %4), y el suelo entre ellos se conoce a ±%5</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit_many_ways</name>
    <message>
        <source>they fit the layout equally well in %1 ways, because it looks the same from several sides</source>
        <translation>se ajustan igual de bien al plano de %1 maneras, ya que se ve igual desde varios lados</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit_together</name>
    <message>
        <source>registered jointly with %1: %2 markers fit to %3 RMS; floor uncertainty ±%4</source>
        <translation>junto con %1, %2 marcadores se ajustan a %3 RMS, y el suelo entre ellos se conoce a ±%4</translation>
    </message>
</context>
<context>
    <name>calibration.markers_found</name>
    <message>
        <source>%1 of %2 were found, four are needed</source>
        <translation>se encontraron %1 de %2, hacen falta cuatro</translation>
    </message>
</context>
<context>
    <name>calibration.markers_in_place</name>
    <message>
        <source>%1 markers are within %2 = %3 of their positions.</source>
        <translation>%1 marcadores están a menos de %2 = %3 de su sitio.</translation>
    </message>
</context>
<context>
    <name>calibration.markers_mirrored</name>
    <message>
        <source>the markers are mirrored</source>
        <translation>los marcadores están en espejo</translation>
    </message>
</context>
<context>
    <name>calibration.markers_missing</name>
    <message>
        <source>missing: %1</source>
        <translation>faltan: %1</translation>
    </message>
</context>
<context>
    <name>calibration.markers_moved</name>
    <message>
        <source>Markers %1 have moved %2 = %3, %4 has not</source>
        <translation>Los marcadores %1 se han movido %2 = %3, %4 no</translation>
    </message>
</context>
<context>
    <name>calibration.markers_nearly_on_line</name>
    <message>
        <source>the markers are so close to one line (%1 the most) that the floor uncertainty is ±%2</source>
        <translation>los marcadores están casi en una línea (%1 los que más), de modo que el suelo solo se conoce a ±%2</translation>
    </message>
</context>
<context>
    <name>calibration.markers_not_found</name>
    <message>
        <source>the floor markers cannot be found</source>
        <translation>no se encuentran los marcadores del suelo</translation>
    </message>
</context>
<context>
    <name>calibration.markers_not_told_apart</name>
    <message>
        <source>the markers cannot be distinguished</source>
        <translation>los marcadores no se distinguen entre sí</translation>
    </message>
</context>
<context>
    <name>calibration.markers_on_one_pixel</name>
    <message>
        <source>markers %1 and %2 are on the same pixel</source>
        <translation>los marcadores %1 y %2 están en un mismo píxel</translation>
    </message>
</context>
<context>
    <name>calibration.markers_read</name>
    <message>
        <source>%1 of its markers could be read</source>
        <translation>se pudieron leer %1 de sus marcadores</translation>
    </message>
</context>
<context>
    <name>calibration.markers_too_close</name>
    <message>
        <source>markers %1 and %2 are only %3 apart, too close for two of four</source>
        <translation>los marcadores %1 y %2 están a solo %3, demasiado cerca para ser dos de cuatro</translation>
    </message>
</context>
<context>
    <name>calibration.measure_again</name>
    <message>
        <source>mark and remeasure them, or add another</source>
        <translation>márquelos y mídalos de nuevo, o añada otro</translation>
    </message>
</context>
<context>
    <name>calibration.measure_it_again</name>
    <message>
        <source>remeasure it.</source>
        <translation>mídalo de nuevo.</translation>
    </message>
</context>
<context>
    <name>calibration.measure_or_mark_again</name>
    <message>
        <source>measure it, or mark it in the image, again.</source>
        <translation>mídalo de nuevo, o márquelo de nuevo en la imagen.</translation>
    </message>
</context>
<context>
    <name>calibration.metres</name>
    <message>
        <source>metres</source>
        <translation>metros</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_corner</name>
    <message>
        <source>±%1 in the middle, ±%2 in the corner near %3.</source>
        <translation>±%1 en el centro, ±%2 en la esquina cercana a %3.</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_edge</name>
    <message>
        <source>±%1 in the middle, ±%2 at the edge near %3.</source>
        <translation>±%1 en el centro, ±%2 en el borde cercano a %3.</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_near</name>
    <message>
        <source>±%1 in the middle, ±%2 near %3.</source>
        <translation>±%1 en el centro, ±%2 cerca de %3.</translation>
    </message>
</context>
<context>
    <name>calibration.misfit_most_at</name>
    <message>
        <source>%1 RMS, most at %2 (%3)</source>
        <translation>%1 RMS, sobre todo en %2 (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.misfit_unexplained</name>
    <message>
        <source>the %1 markers misfit by %2 (%3), and are too few to identify the wrong one</source>
        <translation>los %1 marcadores se desajustan %2 (%3) y se comprueban demasiado poco entre sí para saber cuál de ellos es</translation>
    </message>
</context>
<context>
    <name>calibration.more_pairs</name>
    <message>
        <source>take more pairs, or register %1 better first</source>
        <translation>tome más pares, o registre mejor antes %1</translation>
    </message>
</context>
<context>
    <name>calibration.more_pictures</name>
    <message>
        <source>More images (%1 or more) would make it more certain.</source>
        <translation>Más imágenes (%1 o más) lo harían más seguro.</translation>
    </message>
</context>
<context>
    <name>calibration.move_board</name>
    <message>
        <source>move it elsewhere, turn it or tilt it</source>
        <translation>muévalo, gírelo o inclínelo</translation>
    </message>
</context>
<context>
    <name>calibration.move_planned_back</name>
    <message>
        <source>move it back or up, or choose a wider lens</source>
        <translation>aléjela o súbala, o elija una lente más angular</translation>
    </message>
</context>
<context>
    <name>calibration.name_dictionary</name>
    <message>
        <source>name one like DICT_6X6_250, or leave it out</source>
        <translation>nombre uno como DICT_6X6_250, u omítalo</translation>
    </message>
</context>
<context>
    <name>calibration.name_each_camera</name>
    <message>
        <source>name each camera once</source>
        <translation>nombre cada cámara una sola vez</translation>
    </message>
</context>
<context>
    <name>calibration.name_each_marker</name>
    <message>
        <source>give each marker a name of its own</source>
        <translation>dé a cada marcador un nombre propio</translation>
    </message>
</context>
<context>
    <name>calibration.name_one_marker</name>
    <message>
        <source>name one of %1</source>
        <translation>nombre uno de %1</translation>
    </message>
</context>
<context>
    <name>calibration.name_tag_family</name>
    <message>
        <source>write the family into the labels, such as 36h11:7, or mark a marker by hand</source>
        <translation>escriba la familia en las etiquetas, por ejemplo 36h11:7, o marque un marcador a mano</translation>
    </message>
</context>
<context>
    <name>calibration.name_two_apart</name>
    <message>
        <source>name two at different positions</source>
        <translation>nombre dos que estén separados</translation>
    </message>
</context>
<context>
    <name>calibration.near_edge</name>
    <message>
        <source>at the near edge</source>
        <translation>en el borde cercano</translation>
    </message>
</context>
<context>
    <name>calibration.near_left_corner</name>
    <message>
        <source>in the near left corner</source>
        <translation>en la esquina izquierda cercana</translation>
    </message>
</context>
<context>
    <name>calibration.near_right_corner</name>
    <message>
        <source>in the near right corner</source>
        <translation>en la esquina derecha cercana</translation>
    </message>
</context>
<context>
    <name>calibration.no_board_found</name>
    <message>
        <source>no board found</source>
        <translation>no se encontró ningún tablero</translation>
    </message>
</context>
<context>
    <name>calibration.no_charuco</name>
    <message>
        <source>the detected markers do not match a ChArUco board</source>
        <translation>los marcadores leídos no están como en un tablero ChArUco</translation>
    </message>
</context>
<context>
    <name>calibration.no_charuco_of_size</name>
    <message>
        <source>the detected markers do not match a ChArUco board of %1 inner corners</source>
        <translation>los marcadores leídos no están como en un tablero ChArUco de %1 esquinas interiores</translation>
    </message>
</context>
<context>
    <name>calibration.no_common_marker</name>
    <message>
        <source>no two of the cameras see the same marker</source>
        <translation>ningún par de cámaras ve el mismo marcador</translation>
    </message>
</context>
<context>
    <name>calibration.no_dictionary</name>
    <message>
        <source>marker dictionary %1 does not exist</source>
        <translation>no existe el diccionario de marcadores %1</translation>
    </message>
</context>
<context>
    <name>calibration.no_flat_floor</name>
    <message>
        <source>the markers do not fit a flat floor</source>
        <translation>los marcadores no se ajustan a un suelo plano</translation>
    </message>
</context>
<context>
    <name>calibration.no_lens_fits</name>
    <message>
        <source>no lens model fits these images</source>
        <translation>ninguna lente se ajusta a estas imágenes</translation>
    </message>
</context>
<context>
    <name>calibration.no_millimetres</name>
    <message>
        <source>no value in millimetres: this calibration holds for only part of the image</source>
        <translation>sin valor en milímetros, porque esta lente solo vale para una parte de la imagen</translation>
    </message>
</context>
<context>
    <name>calibration.no_other_lens</name>
    <message>
        <source>no other model fits</source>
        <translation>ningún otro modelo se ajusta</translation>
    </message>
</context>
<context>
    <name>calibration.no_pair_has_board</name>
    <message>
        <source>none of %1 pairs can be used</source>
        <translation>ninguno de %1 pares se puede usar</translation>
    </message>
</context>
<context>
    <name>calibration.no_pose</name>
    <message>
        <source>no pose</source>
        <translation>sin posición</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_corner</name>
    <message>
        <source>the corners of a tag are tl, tr, br and bl</source>
        <translation>las esquinas de un tag son tl, tr, br y bl</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_marker</name>
    <message>
        <source>it has no marker %1</source>
        <translation>no tiene el marcador %1</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_tag</name>
    <message>
        <source>%1 has no tag %2</source>
        <translation>%1 no tiene el tag %2</translation>
    </message>
</context>
<context>
    <name>calibration.no_tag_number</name>
    <message>
        <source>&apos;%1&apos; is not the number of a tag</source>
        <translation>&apos;%1&apos; no es el número de un tag</translation>
    </message>
</context>
<context>
    <name>calibration.not_all_foretold</name>
    <message>
        <source>not all</source>
        <translation>no todas</translation>
    </message>
</context>
<context>
    <name>calibration.not_found_again</name>
    <message>
        <source>Not found again: %1.</source>
        <translation>No encontrados de nuevo: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_by_pair</name>
    <message>
        <source>the camera cannot be registered by the pair</source>
        <translation>la cámara no se puede registrar mediante el par</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_through</name>
    <message>
        <source>the camera cannot be registered via another camera</source>
        <translation>la cámara no se puede registrar mediante otra</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_together</name>
    <message>
        <source>the cameras cannot be registered jointly</source>
        <translation>las cámaras no se pueden registrar juntas</translation>
    </message>
</context>
<context>
    <name>calibration.of_other_camera</name>
    <message>
        <source>it is of another camera, zoom or focus</source>
        <translation>es de otra cámara, otro zoom u otro enfoque</translation>
    </message>
</context>
<context>
    <name>calibration.other_focal_length</name>
    <message>
        <source>it gives a focal length of %1, the other images %2</source>
        <translation>da una distancia focal de %1; las demás imágenes, %2</translation>
    </message>
</context>
<context>
    <name>calibration.other_picking_size</name>
    <message>
        <source>at %1 they fit to %2: were they picked at that size?</source>
        <translation>a %1 encajan con %2: ¿se marcaron con ese tamaño?</translation>
    </message>
</context>
<context>
    <name>calibration.other_picture_size</name>
    <message>
        <source>it is %1×%2, the other images are %3×%4</source>
        <translation>tiene %1×%2, las otras imágenes %3×%4</translation>
    </message>
</context>
<context>
    <name>calibration.other_zoom</name>
    <message>
        <source>with a focal length of %1 instead of %2 they fit to %3: has the zoom or the lens changed?</source>
        <translation>con una distancia focal de %1 en vez de %2 encajan con %3: ¿ha cambiado el zoom o el objetivo?</translation>
    </message>
</context>
<context>
    <name>calibration.others_undetermined</name>
    <message>
        <source>the images do not determine any other model</source>
        <translation>las imágenes no determinan ningún otro modelo</translation>
    </message>
</context>
<context>
    <name>calibration.outside_expected_error</name>
    <message>
        <source>beyond the limit of %1 (2.5 σ).</source>
        <translation>fuera del error esperado de %1.</translation>
    </message>
</context>
<context>
    <name>calibration.pair_contradicts</name>
    <message>
        <source>it contradicts the other pairs by %1 RMS</source>
        <translation>contradice a los demás pares en %1 RMS</translation>
    </message>
</context>
<context>
    <name>calibration.pair_fits</name>
    <message>
        <source>the cameras are %1 apart (±%2) by %3 pairs, whose corners fit to %4 RMS</source>
        <translation>las cámaras están a %1 una de otra (±%2) según %3 pares, cuyas esquinas se ajustan a %4 RMS</translation>
    </message>
</context>
<context>
    <name>calibration.pair_floor_unsure</name>
    <message>
        <source>the floor uncertainty would be ±%1</source>
        <translation>la incertidumbre del suelo sería ±%1</translation>
    </message>
</context>
<context>
    <name>calibration.pair_is_one_image</name>
    <message>
        <source>both are the same image</source>
        <translation>ambas son la misma imagen</translation>
    </message>
</context>
<context>
    <name>calibration.pair_lacks_board</name>
    <message>
        <source>the board was not found in &apos;%1&apos;</source>
        <translation>no se encontró el tablero en «%1»</translation>
    </message>
</context>
<context>
    <name>calibration.pair_lens_usual</name>
    <message>
        <source>A lens calibration has no stated uncertainty: a usual one was assumed.</source>
        <translation>Una calibración de lente no indica su incertidumbre: se supuso una habitual.</translation>
    </message>
</context>
<context>
    <name>calibration.pair_of_cameras</name>
    <message>
        <source>the relative position of the cameras</source>
        <translation>la posición relativa de las cámaras</translation>
    </message>
</context>
<context>
    <name>calibration.pair_sees_no_floor</name>
    <message>
        <source>it would see hardly any floor</source>
        <translation>apenas vería el suelo</translation>
    </message>
</context>
<context>
    <name>calibration.pair_squares</name>
    <message>
        <source>Triangulated, the squares of the board are %1 (standard deviation %2).</source>
        <translation>Triangulados, los cuadros del tablero miden %1 (desviación típica %2).</translation>
    </message>
</context>
<context>
    <name>calibration.pair_swapped</name>
    <message>
        <source>the images of each camera fit the lens calibration of the other one (%1 instead of %2 RMS)</source>
        <translation>las imágenes de cada cámara se ajustan a la calibración de lente de la otra (%1 en lugar de %2 RMS)</translation>
    </message>
</context>
<context>
    <name>calibration.pair_turned</name>
    <message>
        <source>the board looks the same when turned by half, and %1 pairs fit both ways</source>
        <translation>el tablero se ve igual girado 180°, y %1 pares se ajustan de ambas formas</translation>
    </message>
</context>
<context>
    <name>calibration.pair_undetermined</name>
    <message>
        <source>the board positions do not determine it</source>
        <translation>las posiciones del tablero no la determinan</translation>
    </message>
</context>
<context>
    <name>calibration.pair_without_pose</name>
    <message>
        <source>the corners in &apos;%1&apos; determine no pose</source>
        <translation>las esquinas de «%1» no determinan ninguna posición</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_contradict</name>
    <message>
        <source>the pairs contradict each other (%1 RMS together, %2 in each image alone)</source>
        <translation>los pares se contradicen (%1 RMS juntos, %2 en cada imagen por separado)</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_left_out</name>
    <message>
        <source>%1 pairs were not used.</source>
        <translation>%1 pares no se usaron.</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_scatter</name>
    <message>
        <source>The pairs agree less well than the corners would allow, which is in the uncertainty: the board moved between the two frames of a pair, or a lens calibration is less accurate than stated.</source>
        <translation>Los pares concuerdan peor de lo que permiten las esquinas, lo que está incluido en la incertidumbre: el tablero se movió entre las dos imágenes de un par, o una calibración de lente es menos exacta de lo indicado.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_alike</name>
    <message>
        <source>Neighbouring markers err alike, by %1 RMS: check that the floor is flat, and calibrate the lens at the zoom and focus that it records with.</source>
        <translation>Los marcadores vecinos se desvían igual, %1 RMS: compruebe que el suelo es plano y calibre el objetivo con el zoom y el enfoque con que graba.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_layout</name>
    <message>
        <source>The residuals follow the layout: they disappear with X longer than Y by %1 % and the axes %2° off the right angle; measure both sides and both diagonals of the layout again.</source>
        <translation>Las desviaciones siguen al plano: desaparecen si X es un %1 % más largo que Y y los ejes se apartan %2° del ángulo recto; mida de nuevo ambos lados y ambas diagonales del plano.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_lens</name>
    <message>
        <source>The residuals follow the lens: %1 of them disappear with another focal length and distortion; calibrate the lens again, at the zoom and focus that it records with.</source>
        <translation>Las desviaciones siguen al objetivo: %1 de ellas desaparecen con otra distancia focal y distorsión; calibre de nuevo el objetivo con el zoom y el enfoque con que graba.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_marker</name>
    <message>
        <source>Marker %1 is %2 from where the others expect it: measure and mark it again.</source>
        <translation>El marcador %1 está a %2 de donde lo sitúan los demás: mídalo y márquelo de nuevo.</translation>
    </message>
</context>
<context>
    <name>calibration.picture_covered</name>
    <message>
        <source>The board covered only %1 of the image</source>
        <translation>Solo se cubrió el %1 de la imagen</translation>
    </message>
</context>
<context>
    <name>calibration.picture_stands_out</name>
    <message>
        <source>its %1 is an outlier.</source>
        <translation>sus %1 se apartan.</translation>
    </message>
</context>
<context>
    <name>calibration.picture_too_small</name>
    <message>
        <source>the image is too small</source>
        <translation>la imagen es demasiado pequeña</translation>
    </message>
</context>
<context>
    <name>calibration.picture_with_corners</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.picture_without_size</name>
    <message>
        <source>the image has no size</source>
        <translation>la imagen no tiene tamaño</translation>
    </message>
</context>
<context>
    <name>calibration.pictures_fit</name>
    <message>
        <source>%1 images fit to %2, focal length %3 ± %4</source>
        <translation>%1 imágenes se ajustan a %2, distancia focal %3 ± %4</translation>
    </message>
</context>
<context>
    <name>calibration.pictures_fit_halves_apart</name>
    <message>
        <source>%1 images fit to %2, focal length %3 ± %4, halves at most %5 apart on that floor</source>
        <translation>%1 imágenes se ajustan a %2, distancia focal %3 ± %4, con %5 de separación como máximo en ese suelo</translation>
    </message>
</context>
<context>
    <name>calibration.pixels_not_square</name>
    <message>
        <source>the camera&apos;s pixels are not square, or its images were rescaled</source>
        <translation>los píxeles de la cámara no son cuadrados o sus imágenes se reescalaron</translation>
    </message>
</context>
<context>
    <name>calibration.place_left</name>
    <message>
        <source>left</source>
        <translation>izquierdo</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower</name>
    <message>
        <source>lower</source>
        <translation>inferior</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower_left</name>
    <message>
        <source>lower left</source>
        <translation>inferior izquierdo</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower_right</name>
    <message>
        <source>lower right</source>
        <translation>inferior derecho</translation>
    </message>
</context>
<context>
    <name>calibration.place_middle</name>
    <message>
        <source>middle</source>
        <translation>central</translation>
    </message>
</context>
<context>
    <name>calibration.place_right</name>
    <message>
        <source>right</source>
        <translation>derecho</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper</name>
    <message>
        <source>upper</source>
        <translation>superior</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper_left</name>
    <message>
        <source>upper left</source>
        <translation>superior izquierdo</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper_right</name>
    <message>
        <source>upper right</source>
        <translation>superior derecho</translation>
    </message>
</context>
<context>
    <name>calibration.planned_camera</name>
    <message>
        <source>the planned camera</source>
        <translation>la cámara prevista</translation>
    </message>
</context>
<context>
    <name>calibration.planned_distance</name>
    <message>
        <source>its distance cannot be %1</source>
        <translation>no puede estar a %1 de distancia</translation>
    </message>
</context>
<context>
    <name>calibration.planned_field_of_view</name>
    <message>
        <source>its field of view is %1</source>
        <translation>su campo de visión es de %1</translation>
    </message>
</context>
<context>
    <name>calibration.planned_height</name>
    <message>
        <source>its height above the floor cannot be %1</source>
        <translation>no puede estar a %1 sobre el suelo</translation>
    </message>
</context>
<context>
    <name>calibration.planned_not_held</name>
    <message>
        <source>the markers it would see do not determine its pose</source>
        <translation>los marcadores que vería no fijan su posición</translation>
    </message>
</context>
<context>
    <name>calibration.planned_sees_too_few</name>
    <message>
        <source>it would see only %1 of the layout&apos;s markers (%2), four are needed</source>
        <translation>desde ahí vería %1 de los marcadores del plano (%2), hacen falta cuatro</translation>
    </message>
</context>
<context>
    <name>calibration.point_against_lens</name>
    <message>
        <source>the lens model cannot project point %1</source>
        <translation>el punto %1 está donde ninguna lente puede haberlo puesto</translation>
    </message>
</context>
<context>
    <name>calibration.point_beyond_horizon</name>
    <message>
        <source>point %1 would be at or beyond the horizon</source>
        <translation>el punto %1 estaría en el horizonte o más allá</translation>
    </message>
</context>
<context>
    <name>calibration.point_beyond_through</name>
    <message>
        <source>point %1 is at or beyond the horizon of %2</source>
        <translation>el punto %1 está en el horizonte de %2 o más allá</translation>
    </message>
</context>
<context>
    <name>calibration.point_outside_own</name>
    <message>
        <source>point %1 is outside the image of the camera to register (%2)</source>
        <translation>el punto %1 está fuera de la imagen de la cámara por registrar (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.point_outside_through</name>
    <message>
        <source>point %1 is outside the image of %2 (%3)</source>
        <translation>el punto %1 está fuera de la imagen de %2 (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.point_pixel_no_number</name>
    <message>
        <source>the pixel of point %1 is not a finite number</source>
        <translation>el píxel del punto %1 no es un número finito</translation>
    </message>
</context>
<context>
    <name>calibration.point_twice</name>
    <message>
        <source>point %1 appears twice</source>
        <translation>el punto %1 está dos veces</translation>
    </message>
</context>
<context>
    <name>calibration.points_fit</name>
    <message>
        <source>via %1, %2 floor points fit to %3 RMS (worst %4, %5); floor uncertainty ±%6, of which %8 contributes ±%7</source>
        <translation>mediante %1, %2 puntos del suelo se ajustan a %3 RMS (el peor %4, %5), y el suelo entre ellos se conoce a ±%6, de los que ±%7 vienen de %8</translation>
    </message>
</context>
<context>
    <name>calibration.points_mirrored</name>
    <message>
        <source>the points are mirrored between the images of the two cameras</source>
        <translation>los puntos están en espejo entre las imágenes de las dos cámaras</translation>
    </message>
</context>
<context>
    <name>calibration.points_on_one_pixel</name>
    <message>
        <source>points %1 and %2 are on the same pixel</source>
        <translation>los puntos %1 y %2 están en un mismo píxel</translation>
    </message>
</context>
<context>
    <name>calibration.points_undetermined</name>
    <message>
        <source>the points do not determine the camera position</source>
        <translation>los puntos no determinan dónde está la cámara</translation>
    </message>
</context>
<context>
    <name>calibration.poor</name>
    <message>
        <source>Poor: %1.</source>
        <translation>Deficiente: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.poor_measure_again</name>
    <message>
        <source>Poor, measure the markers again: %1.</source>
        <translation>Deficiente, mida de nuevo los marcadores: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.print_is_bent</name>
    <message>
        <source>The board is not flat, it bulges by %1: glue it onto something stiff.</source>
        <translation>El tablero no es plano, se abomba %1: péguelo sobre algo rígido.</translation>
    </message>
</context>
<context>
    <name>calibration.print_is_stretched</name>
    <message>
        <source>The print&apos;s squares are %1 %2 from row to row than from column to column: measure the squares in both directions.</source>
        <translation>Los cuadros de la impresión son un %1 %2 de fila a fila que de columna a columna: mida los cuadros en ambas direcciones.</translation>
    </message>
</context>
<context>
    <name>calibration.print_may_be_stretched</name>
    <message>
        <source>measure the squares of the print in both directions, for it may be stretched, and take images with the board turned by 90 degrees</source>
        <translation>mida los cuadros de la impresión en ambas direcciones, pues puede estar estirada, y tome imágenes con el tablero girado 90 grados</translation>
    </message>
</context>
<context>
    <name>calibration.print_was_heeded</name>
    <message>
        <source>The calibration allows for this.</source>
        <translation>La calibración lo tiene en cuenta.</translation>
    </message>
</context>
<context>
    <name>calibration.put_marker_back</name>
    <message>
        <source>move it back, or measure the markers again and register all cameras.</source>
        <translation>vuelva a ponerlo en su sitio, o mida de nuevo y registre todas las cámaras.</translation>
    </message>
</context>
<context>
    <name>calibration.put_markers_back</name>
    <message>
        <source>move them back, or measure the markers again and register all cameras.</source>
        <translation>vuelva a ponerlos en su sitio, o mida de nuevo y registre todas las cámaras.</translation>
    </message>
</context>
<context>
    <name>calibration.quarter_turn</name>
    <message>
        <source>turned by a quarter they fit to %1: was the image shown turned?</source>
        <translation>girados un cuarto de vuelta encajan con %1: ¿se mostró girada la imagen?</translation>
    </message>
</context>
<context>
    <name>calibration.rational</name>
    <message>
        <source>rational</source>
        <translation>racional</translation>
    </message>
</context>
<context>
    <name>calibration.rational_lens</name>
    <message>
        <source>Rational lens</source>
        <translation>Lente racional</translation>
    </message>
</context>
<context>
    <name>calibration.register_before_recording</name>
    <message>
        <source>register it again before you record.</source>
        <translation>regístrela de nuevo antes de grabar.</translation>
    </message>
</context>
<context>
    <name>calibration.register_by_more</name>
    <message>
        <source>register it with more of them first</source>
        <translation>regístrela antes con más de ellos</translation>
    </message>
</context>
<context>
    <name>calibration.register_if_gone</name>
    <message>
        <source>if they are gone or the camera points elsewhere, register it again</source>
        <translation>si ya no están o la cámara mira a otro lado, regístrela de nuevo</translation>
    </message>
</context>
<context>
    <name>calibration.register_one_by_one</name>
    <message>
        <source>first register the cameras one by one with this layout</source>
        <translation>registre antes las cámaras una a una con este plano</translation>
    </message>
</context>
<context>
    <name>calibration.related_to</name>
    <message>
        <source>via %1 and a board that both see; floor uncertainty ±%2</source>
        <translation>mediante %1 y un tablero que ambas ven; incertidumbre del suelo ±%2</translation>
    </message>
</context>
<context>
    <name>calibration.reverse_both</name>
    <message>
        <source>reverse both (a half turn), or turn the axes</source>
        <translation>invierta ambos (media vuelta), o gire los ejes</translation>
    </message>
</context>
<context>
    <name>calibration.reversed_x_alone</name>
    <message>
        <source>reversing X alone would mirror the floor; no camera above it sees it that way</source>
        <translation>invertir solo X reflejaría el suelo, y ninguna cámara sobre él lo ve así</translation>
    </message>
</context>
<context>
    <name>calibration.reversed_y_alone</name>
    <message>
        <source>reversing Y alone would mirror the floor; no camera above it sees it that way</source>
        <translation>invertir solo Y reflejaría el suelo, y ninguna cámara sobre él lo ve así</translation>
    </message>
</context>
<context>
    <name>calibration.right_edge</name>
    <message>
        <source>at the right edge</source>
        <translation>en el borde derecho</translation>
    </message>
</context>
<context>
    <name>calibration.rings_mirrored</name>
    <message>
        <source>%1 rings and dots fit the layout, mirrored</source>
        <translation>%1 anillos y puntos encajan reflejados en la disposición</translation>
    </message>
</context>
<context>
    <name>calibration.same_as_other_camera</name>
    <message>
        <source>Camera &apos;%1&apos; sees the markers at the same pixels (to %2): check that the views are not swapped.</source>
        <translation>La cámara «%1» ve los marcadores en los mismos píxeles (con %2): compruebe que las vistas no estén intercambiadas.</translation>
    </message>
</context>
<context>
    <name>calibration.same_attitude</name>
    <message>
        <source>all %1 images show the board at nearly the same tilt, too little to determine the focal length</source>
        <translation>las %1 imágenes muestran el tablero casi en la misma postura, lo que no determina la distancia focal</translation>
    </message>
</context>
<context>
    <name>calibration.same_tag_as</name>
    <message>
        <source>it names the same tag as &apos;%1&apos;</source>
        <translation>nombra el mismo tag que &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.second_end_beyond</name>
    <message>
        <source>the second end is at or beyond the horizon of camera &apos;%1&apos;</source>
        <translation>el segundo extremo está en el horizonte de la cámara &apos;%1&apos; o más allá</translation>
    </message>
</context>
<context>
    <name>calibration.see_same_floor</name>
    <message>
        <source>aim them at a common part of the floor</source>
        <translation>haga que vean parte del mismo suelo</translation>
    </message>
</context>
<context>
    <name>calibration.seen_by_other_camera</name>
    <message>
        <source>camera &apos;%1&apos; sees the markers there, to %2: are the views swapped?</source>
        <translation>la cámara «%1» ve ahí los marcadores, con %2: ¿están intercambiadas las vistas?</translation>
    </message>
</context>
<context>
    <name>calibration.sees_too_few_anywhere</name>
    <message>
        <source>at this height and field of view, no position within %1 of the markers shows four of them</source>
        <translation>desde ningún lugar a menos de %1 de los marcadores vería cuatro de ellos con la altura y la lente dadas</translation>
    </message>
</context>
<context>
    <name>calibration.sentence</name>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>calibration.shapes_fit_nowhere</name>
    <message>
        <source>no assignment of the %1 rings and dots fits the layout</source>
        <translation>ninguna forma de nombrar los %1 anillos y puntos se ajusta al plano</translation>
    </message>
</context>
<context>
    <name>calibration.shared_points</name>
    <message>
        <source>%1 given</source>
        <translation>hay %1</translation>
    </message>
</context>
<context>
    <name>calibration.shorter</name>
    <message>
        <source>shorter</source>
        <translation>más cortos</translation>
    </message>
</context>
<context>
    <name>calibration.show_board_larger</name>
    <message>
        <source>show the board larger, sharp and well lit</source>
        <translation>muestre el tablero más grande, nítido y bien iluminado</translation>
    </message>
</context>
<context>
    <name>calibration.show_board_to_both</name>
    <message>
        <source>show the whole board to both cameras at once, in ten positions or more</source>
        <translation>muestre todo el tablero a ambas cámaras a la vez, en diez posiciones o más</translation>
    </message>
</context>
<context>
    <name>calibration.show_everywhere</name>
    <message>
        <source>show the board in the middle and near each corner of the image, and closer</source>
        <translation>muestre el tablero en el centro y cerca de cada esquina de la imagen, y más cerca</translation>
    </message>
</context>
<context>
    <name>calibration.show_missing_tags</name>
    <message>
        <source>show the missing tags (AprilTag 36h11, numbered from 0 in the layout&apos;s order) or rings, or mark the markers by hand</source>
        <translation>muestre los tags que faltan (AprilTag 36h11, numerados desde 0 en el orden del plano) o anillos, o marque los marcadores a mano</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_of_board</name>
    <message>
        <source>show more of the board</source>
        <translation>muestre más del tablero</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_of_it</name>
    <message>
        <source>show more of it</source>
        <translation>muestre más de él</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_shapes</name>
    <message>
        <source>show more of them, larger or in better light, or mark the markers by hand</source>
        <translation>muestre más, más grandes o con mejor luz, o marque los marcadores a mano</translation>
    </message>
</context>
<context>
    <name>calibration.show_near_edges</name>
    <message>
        <source>show the board near its edges too.</source>
        <translation>muestre el tablero también cerca de los bordes.</translation>
    </message>
</context>
<context>
    <name>calibration.show_numbered_tags</name>
    <message>
        <source>show the missing tags (of one family, with the numbers of the labels) or rings, or mark the markers by hand</source>
        <translation>muestre los tags que faltan (de una familia, con los números de las etiquetas) o anillos, o marque los marcadores a mano</translation>
    </message>
</context>
<context>
    <name>calibration.show_one_charuco</name>
    <message>
        <source>show one ChArUco board</source>
        <translation>muestre un tablero ChArUco</translation>
    </message>
</context>
<context>
    <name>calibration.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and well lit</source>
        <translation>muestre todo el tablero, plano, nítido y bien iluminado</translation>
    </message>
</context>
<context>
    <name>calibration.spread_markers</name>
    <message>
        <source>spread the markers over the floor</source>
        <translation>reparta los marcadores por el suelo</translation>
    </message>
</context>
<context>
    <name>calibration.spread_or_register_better</name>
    <message>
        <source>spread the points over the floor, or register %1 better first</source>
        <translation>reparta los puntos por el suelo, o registre mejor antes %1</translation>
    </message>
</context>
<context>
    <name>calibration.spread_points</name>
    <message>
        <source>spread the points over the floor, not along a line</source>
        <translation>reparta los puntos por el suelo, no a lo largo de una línea</translation>
    </message>
</context>
<context>
    <name>calibration.spread_them</name>
    <message>
        <source>spread them over the floor</source>
        <translation>repártalos por el suelo</translation>
    </message>
</context>
<context>
    <name>calibration.squares_without_size</name>
    <message>
        <source>the squares have no size</source>
        <translation>las casillas no tienen tamaño</translation>
    </message>
</context>
<context>
    <name>calibration.stand_higher</name>
    <message>
        <source>mount it higher or farther away, or choose a wider lens</source>
        <translation>colóquela más alta o más lejos, o elija una lente más angular</translation>
    </message>
</context>
<context>
    <name>calibration.standard</name>
    <message>
        <source>standard</source>
        <translation>estándar</translation>
    </message>
</context>
<context>
    <name>calibration.standard_lens</name>
    <message>
        <source>Standard lens</source>
        <translation>Lente estándar</translation>
    </message>
</context>
<context>
    <name>calibration.swap_pair</name>
    <message>
        <source>swap the images of the two cameras</source>
        <translation>intercambie las imágenes de las dos cámaras</translation>
    </message>
</context>
<context>
    <name>calibration.tag_seen_often</name>
    <message>
        <source>tag %1 (marker %2) appears %3 times</source>
        <translation>el tag %1 (marcador %2) se ve %3 veces</translation>
    </message>
</context>
<context>
    <name>calibration.tags_fit_by_place_too</name>
    <message>
        <source>the tags fit the layout by the numbers in its labels and, numbered from 0, by its order</source>
        <translation>los tags se ajustan al plano por los números de sus etiquetas y, numerados desde 0, por su orden</translation>
    </message>
</context>
<context>
    <name>calibration.tags_fit_nowhere</name>
    <message>
        <source>tags with the layout&apos;s numbers are there (%1), but not at its positions</source>
        <translation>hay tags con los números del plano (%1), pero no en sus posiciones</translation>
    </message>
</context>
<context>
    <name>calibration.tags_mirrored</name>
    <message>
        <source>%1 tags were found, mirrored</source>
        <translation>se encontraron %1 etiquetas, reflejadas</translation>
    </message>
</context>
<context>
    <name>calibration.tags_of_two_families</name>
    <message>
        <source>tags of two families, %1 and %2, fit the layout</source>
        <translation>tags de dos familias, %1 y %2, se ajustan al plano</translation>
    </message>
</context>
<context>
    <name>calibration.take_at_same_moment</name>
    <message>
        <source>check that the files belong together in this order and were taken at the same moments, and that both lens calibrations belong to these cameras</source>
        <translation>compruebe que los archivos van juntos en este orden y se tomaron en los mismos momentos, y que ambas calibraciones de lente son de estas cámaras</translation>
    </message>
</context>
<context>
    <name>calibration.take_ten</name>
    <message>
        <source>take ten or more, the board tilted differently in each</source>
        <translation>tome diez o más, con el tablero inclinado de otra forma en cada una</translation>
    </message>
</context>
<context>
    <name>calibration.tape_sigma_not_positive</name>
    <message>
        <source>the σ of the tape measure is not above 0</source>
        <translation>el σ de la cinta métrica no es mayor que 0</translation>
    </message>
</context>
<context>
    <name>calibration.tell_by_hand</name>
    <message>
        <source>mark by hand which of them is %1</source>
        <translation>indique a mano cuál de ellos es %1</translation>
    </message>
</context>
<context>
    <name>calibration.tenths_of_mm</name>
    <message>
        <source>tenths of a mm</source>
        <translation>décimas de mm</translation>
    </message>
</context>
<context>
    <name>calibration.thousandths_of_mm</name>
    <message>
        <source>thousandths of a mm</source>
        <translation>milésimas de mm</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_board</name>
    <message>
        <source>take images with the board tilted by 30 to 45 degrees, to each side</source>
        <translation>tome imágenes con el tablero inclinado de 30 a 45 grados, hacia cada lado</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_less</name>
    <message>
        <source>tilt it by 30 to 45 degrees</source>
        <translation>inclínelo de 30 a 45 grados</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_or_charuco</name>
    <message>
        <source>show it in more positions with different tilts, or use a ChArUco board</source>
        <translation>muéstrelo en más posiciones con distintas inclinaciones, o use un tablero ChArUco</translation>
    </message>
</context>
<context>
    <name>calibration.told_board_too_small</name>
    <message>
        <source>a board of %1 inner corners is too small</source>
        <translation>un tablero de %1 esquinas interiores es demasiado pequeño</translation>
    </message>
</context>
<context>
    <name>calibration.told_length_not_positive</name>
    <message>
        <source>the entered length is not above 0</source>
        <translation>la longitud indicada no es mayor que 0</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_corners</name>
    <message>
        <source>it has %1 corners of the board, six are needed</source>
        <translation>tiene %1 esquinas del tablero, hacen falta seis</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_found_again</name>
    <message>
        <source>%1 of its %2 markers were found again, two are needed</source>
        <translation>se encontraron de nuevo %1 de sus %2 marcadores, hacen falta dos</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_pictures</name>
    <message>
        <source>calibration needs three images of the board, %1 can be used</source>
        <translation>se necesitan tres imágenes del tablero, %1 sirven</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_shapes</name>
    <message>
        <source>%1 rings or dots were found, four are needed</source>
        <translation>se encontraron %1 anillos o puntos, hacen falta cuatro</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_to_compare</name>
    <message>
        <source>too few images to compare it with other models</source>
        <translation>muy pocas imágenes para compararlo con otros</translation>
    </message>
</context>
<context>
    <name>calibration.too_frontal</name>
    <message>
        <source>the board faces the camera too directly</source>
        <translation>el tablero se ve demasiado de frente</translation>
    </message>
</context>
<context>
    <name>calibration.too_small_for_board</name>
    <message>
        <source>the image is too small for a board</source>
        <translation>la imagen es demasiado pequeña para un tablero</translation>
    </message>
</context>
<context>
    <name>calibration.two_cameras_needed</name>
    <message>
        <source>layout &apos;%2&apos; has %1 registered camera, two are needed</source>
        <translation>hay %1 cámara en el plano &apos;%2&apos;, hacen falta dos</translation>
    </message>
</context>
<context>
    <name>calibration.two_directions</name>
    <message>
        <source>both an angle and a pair of markers were given for X</source>
        <translation>para X se dieron un ángulo y un par de marcadores</translation>
    </message>
</context>
<context>
    <name>calibration.two_focal_lengths</name>
    <message>
        <source>the images do not agree on one focal length</source>
        <translation>las imágenes piden dos distancias focales</translation>
    </message>
</context>
<context>
    <name>calibration.two_origins</name>
    <message>
        <source>both a marker and a point were given for the origin</source>
        <translation>para el origen se dieron un marcador y un punto</translation>
    </message>
</context>
<context>
    <name>calibration.typical_testbed</name>
    <message>
        <source>a %1 × %2 floor seen from %3 above</source>
        <translation>un suelo de %1 × %2 visto desde %3 de altura</translation>
    </message>
</context>
<context>
    <name>calibration.u_outside</name>
    <message>
        <source>u = %1 of marker %2 is outside the image of %3</source>
        <translation>u = %1 del marcador %2 está fuera de la imagen de %3</translation>
    </message>
</context>
<context>
    <name>calibration.u_v_swapped</name>
    <message>
        <source>with u and v swapped they fit to %1: are these columns swapped?</source>
        <translation>con u y v intercambiadas encajan con %1: ¿están intercambiadas estas columnas?</translation>
    </message>
</context>
<context>
    <name>calibration.uncertain</name>
    <message>
        <source>Uncertain: %1.</source>
        <translation>Dudoso: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.unit</name>
    <message>
        <source>unit &apos;%1&apos;</source>
        <translation>unidad &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.unit_unknown</name>
    <message>
        <source>it is not known</source>
        <translation>no se conoce</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_corner</name>
    <message>
        <source>The middle is out of view, ±%1 in the corner near %2.</source>
        <translation>El centro no se ve, ±%1 en la esquina cercana a %2.</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_edge</name>
    <message>
        <source>The middle is out of view, ±%1 at the edge near %2.</source>
        <translation>El centro no se ve, ±%1 en el borde cercano a %2.</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_near</name>
    <message>
        <source>The middle is out of view, ±%1 near %2.</source>
        <translation>El centro no se ve, ±%1 cerca de %2.</translation>
    </message>
</context>
<context>
    <name>calibration.usable</name>
    <message>
        <source>Usable: %1.</source>
        <translation>Utilizable: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.use_camera_picture</name>
    <message>
        <source>use an image from the camera</source>
        <translation>use una imagen de la cámara</translation>
    </message>
</context>
<context>
    <name>calibration.use_camera_pictures</name>
    <message>
        <source>use images from the camera</source>
        <translation>use imágenes de la cámara</translation>
    </message>
</context>
<context>
    <name>calibration.use_known_unit</name>
    <message>
        <source>use mm, cm, m or inch</source>
        <translation>use mm, cm, m o inch</translation>
    </message>
</context>
<context>
    <name>calibration.use_one_camera</name>
    <message>
        <source>use images of one camera at one zoom and focus</source>
        <translation>use imágenes de una cámara con un mismo zoom y enfoque</translation>
    </message>
</context>
<context>
    <name>calibration.use_one_resolution</name>
    <message>
        <source>use images of one camera at one resolution</source>
        <translation>use imágenes de una cámara con una misma resolución</translation>
    </message>
</context>
<context>
    <name>calibration.usual_lens</name>
    <message>
        <source>the images leave it open, so square pixels, an optical centre near the middle and a usual distortion were assumed</source>
        <translation>las imágenes no lo determinan, por lo que se supusieron píxeles cuadrados, un centro óptico cerca del centro de la imagen y una distorsión habitual</translation>
    </message>
</context>
<context>
    <name>calibration.v_from_below</name>
    <message>
        <source>v = %1 - v fits to %2: is v counted from below?</source>
        <translation>v = %1 - v encaja con %2: ¿se cuenta v desde abajo?</translation>
    </message>
</context>
<context>
    <name>calibration.v_outside</name>
    <message>
        <source>v = %1 of marker %2 is outside the image of %3</source>
        <translation>v = %1 del marcador %2 está fuera de la imagen de %3</translation>
    </message>
</context>
<context>
    <name>calibration.were_kept</name>
    <message>
        <source>they were kept</source>
        <translation>se conservaron</translation>
    </message>
</context>
<context>
    <name>calibration.whether_moved</name>
    <message>
        <source>cannot determine whether %1 has moved</source>
        <translation>no se puede saber si %1 se ha movido</translation>
    </message>
</context>
<context>
    <name>calibration.without_it_centre</name>
    <message>
        <source>Check %1: without it the optical centre moves by %2.</source>
        <translation>Revise %1: sin ella, el centro óptico se desplaza %2.</translation>
    </message>
</context>
<context>
    <name>calibration.without_it_focal</name>
    <message>
        <source>Check %1: without it the focal length changes by %2.</source>
        <translation>Revise %1: sin ella, la distancia focal cambia en %2.</translation>
    </message>
</context>
<context>
    <name>calibration.write_tags_as</name>
    <message>
        <source>write a tag as 100 or 36h11:100, its corner as 100.tl, the middle of two as 12+13</source>
        <translation>escriba un tag como 100 o 36h11:100, su esquina como 100.tl, el punto medio de dos como 12+13</translation>
    </message>
</context>
<context>
    <name>calibration.wrong_by_more</name>
    <message>
        <source>it may be wrong by much more</source>
        <translation>el error puede ser mucho mayor</translation>
    </message>
</context>
<context>
    <name>calibration.x_without_length</name>
    <message>
        <source>the two markers for the X axis have the same position</source>
        <translation>los marcadores por los que debe ir X están en un mismo lugar</translation>
    </message>
</context>
<context>
    <name>calibration.y_left_of_x</name>
    <message>
        <source>seen from above, Y must point to the left of X</source>
        <translation>visto desde arriba, Y debe apuntar a la izquierda de X</translation>
    </message>
</context>
<context>
    <name>capture.access_to_cameras</name>
    <message>
        <source>Access to cameras</source>
        <translation>Acceso a las cámaras</translation>
    </message>
</context>
<context>
    <name>capture.all_pictures_damaged</name>
    <message>
        <source>all its frames arrive damaged</source>
        <translation>todas sus imágenes llegan dañadas</translation>
    </message>
</context>
<context>
    <name>capture.answers_but_silent</name>
    <message>
        <source>it answers but sends no frames</source>
        <translation>responde, pero no envía imágenes</translation>
    </message>
</context>
<context>
    <name>capture.answers_but_silent_advice</name>
    <message>
        <source>check its trigger and this computer&apos;s firewall</source>
        <translation>revise su disparador y el cortafuegos de esta computadora</translation>
    </message>
</context>
<context>
    <name>capture.aravis_place_missing</name>
    <message>
        <source>it contains neither an address nor a serial number</source>
        <translation>no indica ni una dirección ni un número de serie</translation>
    </message>
</context>
<context>
    <name>capture.aravis_wishes</name>
    <message>
        <source>use rate, exposure_ms, gain, format, size, trigger=software, packet_size or packet_delay_us, as in ?rate=30&amp;size=640x480</source>
        <translation>use rate, exposure_ms, gain, format, size, trigger=software, packet_size o packet_delay_us, como en ?rate=30&amp;size=640x480</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_less</name>
    <message>
        <source>choose a smaller size or a lower rate</source>
        <translation>pida un tamaño o una frecuencia menor</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_other_mode</name>
    <message>
        <source>choose another size or format</source>
        <translation>pida otro tamaño o formato</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_something_else</name>
    <message>
        <source>use another value, or leave the choice to the camera</source>
        <translation>pida otra cosa, o déjelo a la cámara</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_usable_format</name>
    <message>
        <source>choose one of %1</source>
        <translation>pida uno de %1</translation>
    </message>
</context>
<context>
    <name>capture.ask_within_sensor</name>
    <message>
        <source>choose a size within that</source>
        <translation>pida un tamaño que quepa en eso</translation>
    </message>
</context>
<context>
    <name>capture.automatics_held</name>
    <message>
        <source>exposure, gain, white balance and focus are held</source>
        <translation>exposición, ganancia, balance de blancos y enfoque están fijos</translation>
    </message>
</context>
<context>
    <name>capture.automatics_of_camera</name>
    <message>
        <source>Automatic settings, camera %1</source>
        <translation>Automatismos, cámara %1</translation>
    </message>
</context>
<context>
    <name>capture.buffer_enough</name>
    <message>
        <source>up to %1, enough for network cameras</source>
        <translation>hasta %1, suficiente para cámaras de red</translation>
    </message>
</context>
<context>
    <name>capture.buffer_not_known</name>
    <message>
        <source>the system does not report its maximum size (net.core.rmem_max)</source>
        <translation>el sistema no dice qué tamaño puede tener (net.core.rmem_max)</translation>
    </message>
</context>
<context>
    <name>capture.buffer_small</name>
    <message>
        <source>only %1</source>
        <translation>solo %1</translation>
    </message>
</context>
<context>
    <name>capture.buffer_without_use</name>
    <message>
        <source>%1, too small only for network cameras</source>
        <translation>%1, que solo sería poco para cámaras de red</translation>
    </message>
</context>
<context>
    <name>capture.bus_of_speed_shared</name>
    <message>
        <source>cameras %1 share the bus %2, of %3</source>
        <translation>las cámaras %1 comparten el bus %2, de %3</translation>
    </message>
</context>
<context>
    <name>capture.bus_shared</name>
    <message>
        <source>cameras %1 share the bus %2</source>
        <translation>las cámaras %1 comparten el bus %2</translation>
    </message>
</context>
<context>
    <name>capture.came_back_changed</name>
    <message>
        <source>it came back with another frame size or format</source>
        <translation>volvió con imágenes de otro tamaño o formato</translation>
    </message>
</context>
<context>
    <name>capture.camera_at_address</name>
    <message>
        <source>camera %1</source>
        <translation>cámara %1</translation>
    </message>
</context>
<context>
    <name>capture.camera_does_not_deliver</name>
    <message>
        <source>a camera sends no frames</source>
        <translation>una cámara no entrega imágenes</translation>
    </message>
</context>
<context>
    <name>capture.cameras_are_listed</name>
    <message>
        <source>odograph cameras lists them</source>
        <translation>Cámaras… en Grabar las muestra</translation>
    </message>
</context>
<context>
    <name>capture.cameras_will_lose</name>
    <message>
        <source>%1 will lose frames</source>
        <translation>%1 perderá imágenes</translation>
    </message>
</context>
<context>
    <name>capture.cannot_be_opened</name>
    <message>
        <source>it cannot be opened (%1)</source>
        <translation>no se puede abrir (%1)</translation>
    </message>
</context>
<context>
    <name>capture.check_cable</name>
    <message>
        <source>check its cable</source>
        <translation>revise su cable</translation>
    </message>
</context>
<context>
    <name>capture.check_cable_and_address</name>
    <message>
        <source>check its cable and address</source>
        <translation>compruebe su cable y su dirección</translation>
    </message>
</context>
<context>
    <name>capture.check_cable_and_network</name>
    <message>
        <source>check its cable and the network</source>
        <translation>revise su cable y la red</translation>
    </message>
</context>
<context>
    <name>capture.check_power_and_cable</name>
    <message>
        <source>check its power and cable</source>
        <translation>compruebe su alimentación y su cable</translation>
    </message>
</context>
<context>
    <name>capture.check_power_and_network</name>
    <message>
        <source>check its power and cable, and that this computer has an address in the camera&apos;s network</source>
        <translation>compruebe su alimentación y su cable, y que esta computadora tiene una dirección en la red de la cámara</translation>
    </message>
</context>
<context>
    <name>capture.check_usb_rights</name>
    <message>
        <source>check that you may use it (a udev rule), and that no other program does</source>
        <translation>compruebe que puede usarla (una regla de udev) y que ningún otro programa la usa</translation>
    </message>
</context>
<context>
    <name>capture.choose_another_value</name>
    <message>
        <source>choose another one</source>
        <translation>elija otro</translation>
    </message>
</context>
<context>
    <name>capture.choose_listed</name>
    <message>
        <source>choose a camera that odograph cameras lists</source>
        <translation>elija una cámara de las que muestra «Cámaras…» en Grabar</translation>
    </message>
</context>
<context>
    <name>capture.choose_of_offer</name>
    <message>
        <source>choose one that it offers</source>
        <translation>elija de lo que ofrece</translation>
    </message>
</context>
<context>
    <name>capture.choose_value_between</name>
    <message>
        <source>choose a value between</source>
        <translation>elija un valor intermedio</translation>
    </message>
</context>
<context>
    <name>capture.close_that_program</name>
    <message>
        <source>close that program</source>
        <translation>cierre ese programa</translation>
    </message>
</context>
<context>
    <name>capture.connect_right_camera</name>
    <message>
        <source>reconnect the original camera, or start over with this one</source>
        <translation>conecte la que corresponde, o empiece de nuevo con esta</translation>
    </message>
</context>
<context>
    <name>capture.control_automatic</name>
    <message>
        <source>%1 cannot be set while it is automatic</source>
        <translation>%1 no se puede ajustar mientras sea automático</translation>
    </message>
</context>
<context>
    <name>capture.control_goes</name>
    <message>
        <source>%1 ranges from %2 to %3</source>
        <translation>%1 va de %2 a %3</translation>
    </message>
</context>
<context>
    <name>capture.control_inactive</name>
    <message>
        <source>%1 cannot be set in the camera&apos;s current mode</source>
        <translation>%1 no se puede ajustar con la cámara como está ahora</translation>
    </message>
</context>
<context>
    <name>capture.control_not_taken</name>
    <message>
        <source>it rejects this value for %1 (%2)</source>
        <translation>no admite esto para %1 (%2)</translation>
    </message>
</context>
<context>
    <name>capture.control_value_refused</name>
    <message>
        <source>it rejects this value of %1</source>
        <translation>rechaza este valor de %1</translation>
    </message>
</context>
<context>
    <name>capture.damaged_advice</name>
    <message>
        <source>try another cable or port, or choose a lower rate or a smaller frame size</source>
        <translation>pruebe otro cable o puerto, o pida menos imágenes o más pequeñas</translation>
    </message>
</context>
<context>
    <name>capture.dim_light_halves_rate</name>
    <message>
        <source>in dim light a camera halves its rate unless its automatic exposure is off</source>
        <translation>con poca luz una cámara reduce sola su frecuencia a la mitad, salvo que la exposición automática esté desactivada</translation>
    </message>
</context>
<context>
    <name>capture.disk_full</name>
    <message>
        <source>its disk has only %1 left, of which %2 are kept free</source>
        <translation>a su disco solo le quedan %1, de los que %2 se mantienen libres</translation>
    </message>
</context>
<context>
    <name>capture.disk_of</name>
    <message>
        <source>the disk of %1</source>
        <translation>el disco de %1</translation>
    </message>
</context>
<context>
    <name>capture.disk_too_slow</name>
    <message>
        <source>it is too slow</source>
        <translation>es demasiado lento</translation>
    </message>
</context>
<context>
    <name>capture.does_not_answer</name>
    <message>
        <source>it does not answer</source>
        <translation>no responde</translation>
    </message>
</context>
<context>
    <name>capture.does_not_start</name>
    <message>
        <source>it does not start (%1)</source>
        <translation>no arranca (%1)</translation>
    </message>
</context>
<context>
    <name>capture.does_not_start_advice</name>
    <message>
        <source>check its cable, and that no other program uses it</source>
        <translation>compruebe su cable y que ningún otro programa la use</translation>
    </message>
</context>
<context>
    <name>capture.end_other_writers</name>
    <message>
        <source>stop other programs that write to it</source>
        <translation>termine lo que más escriba en él</translation>
    </message>
</context>
<context>
    <name>capture.enlarge_buffer</name>
    <message>
        <source>sudo sysctl -w net.core.rmem_max=%1, and add the same line to /etc/sysctl.d/ to keep it</source>
        <translation>sudo sysctl -w net.core.rmem_max=%1, y ponga lo mismo en /etc/sysctl.d/ para conservarlo</translation>
    </message>
</context>
<context>
    <name>capture.expose_for_mains</name>
    <message>
        <source>expose for 10 or 20 ms with mains of 50 Hz, 8.3 or 16.7 ms with 60 Hz</source>
        <translation>exponga 10 o 20 ms con red de 50 Hz, 8,3 o 16,7 ms con 60 Hz</translation>
    </message>
</context>
<context>
    <name>capture.exposed_for</name>
    <message>
        <source>exposed for %1</source>
        <translation>expuesta %1</translation>
    </message>
</context>
<context>
    <name>capture.exposure_and_gain</name>
    <message>
        <source>Exposure and gain</source>
        <translation>Exposición y ganancia</translation>
    </message>
</context>
<context>
    <name>capture.exposure_not_taken</name>
    <message>
        <source>it rejects this exposure (%1)</source>
        <translation>no admite esta exposición (%1)</translation>
    </message>
</context>
<context>
    <name>capture.exposure_not_told</name>
    <message>
        <source>it does not report its exposure</source>
        <translation>no indica su exposición</translation>
    </message>
</context>
<context>
    <name>capture.exposure_suits_lamps</name>
    <message>
        <source>exposed for %1, which suits lamps</source>
        <translation>expuesta %1, adecuado para lámparas</translation>
    </message>
</context>
<context>
    <name>capture.failed</name>
    <message>
        <source>it failed (%1)</source>
        <translation>falló (%1)</translation>
    </message>
</context>
<context>
    <name>capture.failed_advice</name>
    <message>
        <source>if this continues, unplug it and plug it in again</source>
        <translation>desconéctela y conéctela de nuevo si eso persiste</translation>
    </message>
</context>
<context>
    <name>capture.flicker_filter_off</name>
    <message>
        <source>its filter is off</source>
        <translation>su filtro está desactivado</translation>
    </message>
</context>
<context>
    <name>capture.flicker_filtered</name>
    <message>
        <source>filtered by the camera (%1)</source>
        <translation>filtrado por la cámara (%1)</translation>
    </message>
</context>
<context>
    <name>capture.flicker_of_camera</name>
    <message>
        <source>Lamp flicker, camera %1</source>
        <translation>Parpadeo de lámparas, cámara %1</translation>
    </message>
</context>
<context>
    <name>capture.forbidden</name>
    <message>
        <source>you may not use it</source>
        <translation>no tiene permiso para usarla</translation>
    </message>
</context>
<context>
    <name>capture.forbidden_advice</name>
    <message>
        <source>join the group video (sudo usermod -aG video YOUR-NAME) and log in again</source>
        <translation>únase al grupo video (sudo usermod -aG video YOUR-NAME) y vuelva a entrar</translation>
    </message>
</context>
<context>
    <name>capture.format</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 a los %2</translation>
    </message>
</context>
<context>
    <name>capture.format_not_told</name>
    <message>
        <source>it does not report its pixel format (%1)</source>
        <translation>no dice su formato de píxel (%1)</translation>
    </message>
</context>
<context>
    <name>capture.format_not_understood</name>
    <message>
        <source>its pixel format is not supported</source>
        <translation>su formato de píxel no se entiende</translation>
    </message>
</context>
<context>
    <name>capture.free_after_crash</name>
    <message>
        <source>a camera whose program has crashed is free again after some seconds</source>
        <translation>una cámara cuyo programa se bloqueó vuelve a estar libre tras unos segundos</translation>
    </message>
</context>
<context>
    <name>capture.gain_not_taken</name>
    <message>
        <source>it rejects this gain (%1)</source>
        <translation>no admite esta ganancia (%1)</translation>
    </message>
</context>
<context>
    <name>capture.give_address</name>
    <message>
        <source>give one as v4l2:/dev/video0, aravis:192.168.1.20, sim:A or file:PATH</source>
        <translation>dé una como v4l2:/dev/video0, aravis:192.168.1.20, sim:A o file:PATH</translation>
    </message>
</context>
<context>
    <name>capture.give_aravis_place</name>
    <message>
        <source>give one as aravis:192.168.1.20 or aravis:SERIAL</source>
        <translation>dé una como aravis:192.168.1.20 o aravis:SERIAL</translation>
    </message>
</context>
<context>
    <name>capture.gives_no_pictures</name>
    <message>
        <source>%1 sends no frames</source>
        <translation>%1 no da imágenes</translation>
    </message>
</context>
<context>
    <name>capture.has_been_away</name>
    <message>
        <source>the connection was lost</source>
        <translation>ha estado ausente</translation>
    </message>
</context>
<context>
    <name>capture.held_while_recording</name>
    <message>
        <source>they are held while recording</source>
        <translation>se mantienen fijos al grabar</translation>
    </message>
</context>
<context>
    <name>capture.in_step</name>
    <message>
        <source>synchronised to %1</source>
        <translation>sincronizada a %1</translation>
    </message>
</context>
<context>
    <name>capture.in_step_as_way</name>
    <message>
        <source>at %1 that is %2</source>
        <translation>a %1 son %2</translation>
    </message>
</context>
<context>
    <name>capture.join_video_group</name>
    <message>
        <source>add yourself to the group video (sudo usermod -aG video $USER), then log out and in again</source>
        <translation>añádase al grupo video (sudo usermod -aG video $USER), luego cierre la sesión y vuelva a entrar</translation>
    </message>
</context>
<context>
    <name>capture.keep_awake</name>
    <message>
        <source>keep it awake while it records</source>
        <translation>manténgala despierta mientras graba</translation>
    </message>
</context>
<context>
    <name>capture.kept_before_sleep</name>
    <message>
        <source>the recording up to then is kept</source>
        <translation>lo anterior se conserva</translation>
    </message>
</context>
<context>
    <name>capture.large_packets</name>
    <message>
        <source>large packets are allowed</source>
        <translation>se permiten paquetes grandes</translation>
    </message>
</context>
<context>
    <name>capture.largest_picture</name>
    <message>
        <source>its frames have at most %1 pixels</source>
        <translation>sus imágenes tienen %1 píxeles como máximo</translation>
    </message>
</context>
<context>
    <name>capture.leave_control_out</name>
    <message>
        <source>leave it out</source>
        <translation>omítalo</translation>
    </message>
</context>
<context>
    <name>capture.look_again</name>
    <message>
        <source>wait a few seconds, then check again</source>
        <translation>espere unos segundos y vuelva a mirar</translation>
    </message>
</context>
<context>
    <name>capture.look_at_cable</name>
    <message>
        <source>check its cable</source>
        <translation>revise su cable</translation>
    </message>
</context>
<context>
    <name>capture.lost_by_slow_machine</name>
    <message>
        <source>%1, %2 lost because this machine is too slow</source>
        <translation>%1, %2 perdidos porque esta computadora es demasiado lenta</translation>
    </message>
</context>
<context>
    <name>capture.lost_here</name>
    <message>
        <source>%1, %2 lost here</source>
        <translation>%1, %2 perdidos aquí</translation>
    </message>
</context>
<context>
    <name>capture.lost_on_wire</name>
    <message>
        <source>%1, %2 lost on the wire</source>
        <translation>%1, %2 perdidos en el cable</translation>
    </message>
</context>
<context>
    <name>capture.lost_on_wire_and_here</name>
    <message>
        <source>%1, %2 lost (%3 on the wire, %4 here)</source>
        <translation>%1, %2 perdidos (%3 en el cable, %4 aquí)</translation>
    </message>
</context>
<context>
    <name>capture.machine_slept</name>
    <message>
        <source>it slept for %1 and recorded nothing meanwhile</source>
        <translation>estuvo suspendida %1 y entretanto no se grabó nada</translation>
    </message>
</context>
<context>
    <name>capture.make_room</name>
    <message>
        <source>free some disk space, or move the project to another disk</source>
        <translation>libere espacio, o mueva el proyecto a otro disco</translation>
    </message>
</context>
<context>
    <name>capture.mode_not_taken</name>
    <message>
        <source>it rejects %1</source>
        <translation>no admite %1</translation>
    </message>
</context>
<context>
    <name>capture.no_automatics</name>
    <message>
        <source>it has none</source>
        <translation>no tiene ninguno</translation>
    </message>
</context>
<context>
    <name>capture.no_network_camera</name>
    <message>
        <source>no network camera is used</source>
        <translation>no se usa ninguna cámara de red</translation>
    </message>
</context>
<context>
    <name>capture.no_node</name>
    <message>
        <source>this computer has no USB or built-in camera (/dev/video*)</source>
        <translation>esta computadora no muestra ninguna cámara USB ni integrada (/dev/video*)</translation>
    </message>
</context>
<context>
    <name>capture.no_node_advice</name>
    <message>
        <source>if one is connected, try another cable and port, without a hub</source>
        <translation>si hay una conectada, pruebe otro cable y otro puerto, sin concentrador</translation>
    </message>
</context>
<context>
    <name>capture.no_pair_yet</name>
    <message>
        <source>no frames of the cameras have been paired yet</source>
        <translation>aún no se han tomado dos imágenes a la vez</translation>
    </message>
</context>
<context>
    <name>capture.no_picture_came</name>
    <message>
        <source>no frame arrived for half a second</source>
        <translation>no llegó ninguna imagen durante medio segundo</translation>
    </message>
</context>
<context>
    <name>capture.no_picture_for</name>
    <message>
        <source>no frame has arrived for %1</source>
        <translation>no ha llegado ninguna imagen en %1</translation>
    </message>
</context>
<context>
    <name>capture.no_readable_format</name>
    <message>
        <source>it offers no supported format</source>
        <translation>no tiene ningún formato legible</translation>
    </message>
</context>
<context>
    <name>capture.no_simulated_camera</name>
    <message>
        <source>simulated camera %1 does not exist</source>
        <translation>no hay ninguna cámara simulada %1</translation>
    </message>
</context>
<context>
    <name>capture.no_software_trigger</name>
    <message>
        <source>it has no software trigger (%1)</source>
        <translation>no tiene disparo por software (%1)</translation>
    </message>
</context>
<context>
    <name>capture.no_such_address</name>
    <message>
        <source>no kind of camera has an address like this</source>
        <translation>ninguna cámara tiene esa dirección</translation>
    </message>
</context>
<context>
    <name>capture.no_such_control</name>
    <message>
        <source>it has no setting &apos;%1&apos;</source>
        <translation>no tiene nada llamado &apos;%1&apos; que se pueda ajustar</translation>
    </message>
</context>
<context>
    <name>capture.no_such_format</name>
    <message>
        <source>it has no format %1 (%2)</source>
        <translation>no tiene el formato %1 (%2)</translation>
    </message>
</context>
<context>
    <name>capture.no_usable_format</name>
    <message>
        <source>it offers no supported pixel format</source>
        <translation>no tiene ningún formato de píxel que se entienda</translation>
    </message>
</context>
<context>
    <name>capture.no_usb_camera</name>
    <message>
        <source>no USB camera is used</source>
        <translation>no se usa ninguna cámara USB</translation>
    </message>
</context>
<context>
    <name>capture.nodes_forbidden</name>
    <message>
        <source>you may not use %1</source>
        <translation>no tiene permiso para usar %1</translation>
    </message>
</context>
<context>
    <name>capture.nodes_usable</name>
    <message>
        <source>you may use all %1 video devices</source>
        <translation>puede usar los %1 dispositivos de video</translation>
    </message>
</context>
<context>
    <name>capture.none_lost</name>
    <message>
        <source>%1, none lost</source>
        <translation>%1, ninguno perdido</translation>
    </message>
</context>
<context>
    <name>capture.not_offered</name>
    <message>
        <source>it does not offer the requested mode</source>
        <translation>no ofrece lo que se pidió</translation>
    </message>
</context>
<context>
    <name>capture.not_registered</name>
    <message>
        <source>it is not registered to the floor</source>
        <translation>no está registrada respecto al suelo</translation>
    </message>
</context>
<context>
    <name>capture.not_there</name>
    <message>
        <source>it is not connected</source>
        <translation>no está</translation>
    </message>
</context>
<context>
    <name>capture.nothing_lost_yet</name>
    <message>
        <source>nothing is lost yet</source>
        <translation>aún no se ha perdido nada</translation>
    </message>
</context>
<context>
    <name>capture.one_camera_in_step</name>
    <message>
        <source>a single camera needs no synchronisation</source>
        <translation>una sola cámara siempre está sincronizada</translation>
    </message>
</context>
<context>
    <name>capture.one_not_held</name>
    <message>
        <source>%1 still adjusts automatically</source>
        <translation>%1 sigue cambiando por sí mismo</translation>
    </message>
</context>
<context>
    <name>capture.open_video_again</name>
    <message>
        <source>open it again to see it from the start</source>
        <translation>ábralo de nuevo para verlo desde el principio</translation>
    </message>
</context>
<context>
    <name>capture.other_camera_in_place</name>
    <message>
        <source>another camera (%1) has replaced it</source>
        <translation>otra cámara (%1) está en su lugar</translation>
    </message>
</context>
<context>
    <name>capture.other_serial_in_place</name>
    <message>
        <source>another camera (%1) has replaced camera %2</source>
        <translation>otra cámara (%1) está en el lugar de la cámara %2</translation>
    </message>
</context>
<context>
    <name>capture.own_usb_buses</name>
    <message>
        <source>each USB camera has its own bus</source>
        <translation>cada cámara USB tiene un bus propio</translation>
    </message>
</context>
<context>
    <name>capture.packet_delay_not_taken</name>
    <message>
        <source>it rejects this packet delay (%1)</source>
        <translation>no admite este retardo de paquete (%1)</translation>
    </message>
</context>
<context>
    <name>capture.packet_size</name>
    <message>
        <source>Packet size</source>
        <translation>Tamaño de paquete</translation>
    </message>
</context>
<context>
    <name>capture.packet_size_not_taken</name>
    <message>
        <source>it rejects this packet size (%1)</source>
        <translation>no admite este tamaño de paquete (%1)</translation>
    </message>
</context>
<context>
    <name>capture.part_not_understood</name>
    <message>
        <source>&apos;%1&apos; is not valid</source>
        <translation>no se entiende &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>capture.payload_not_told</name>
    <message>
        <source>it does not report how many bytes a frame has (%1)</source>
        <translation>no dice qué tamaño tienen sus imágenes (%1)</translation>
    </message>
</context>
<context>
    <name>capture.picture_of_camera</name>
    <message>
        <source>a frame of camera %1</source>
        <translation>una imagen de la cámara %1</translation>
    </message>
</context>
<context>
    <name>capture.picture_size_of_camera</name>
    <message>
        <source>Frame size, camera %1</source>
        <translation>Tamaño de imagen, cámara %1</translation>
    </message>
</context>
<context>
    <name>capture.picture_waits_for_disk</name>
    <message>
        <source>a frame has waited %1; the write buffer is %2 full</source>
        <translation>una imagen ha esperado %1 por él, y está ocupado el %2 del espacio de espera</translation>
    </message>
</context>
<context>
    <name>capture.pictures_being_lost</name>
    <message>
        <source>frames are being lost</source>
        <translation>se están perdiendo imágenes</translation>
    </message>
</context>
<context>
    <name>capture.pictures_incomplete</name>
    <message>
        <source>its frames arrive incomplete</source>
        <translation>sus imágenes llegan incompletas</translation>
    </message>
</context>
<context>
    <name>capture.pictures_may_pulse</name>
    <message>
        <source>brightness may pulse under lamps</source>
        <translation>las imágenes pueden pulsar bajo lámparas</translation>
    </message>
</context>
<context>
    <name>capture.pictures_without_size</name>
    <message>
        <source>its frames have no size</source>
        <translation>sus imágenes no tienen tamaño</translation>
    </message>
</context>
<context>
    <name>capture.plug_camera_in_again</name>
    <message>
        <source>plug %1 in again</source>
        <translation>conecte de nuevo %1</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_again</name>
    <message>
        <source>plug it in again</source>
        <translation>conéctela de nuevo</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_or_choose</name>
    <message>
        <source>plug it in, or choose a camera that odograph cameras lists</source>
        <translation>conéctela, o elija una de las que muestra «Cámaras…» en Grabar</translation>
    </message>
</context>
<context>
    <name>capture.put_disk_back</name>
    <message>
        <source>reconnect its disk, or move its folder back</source>
        <translation>vuelva a poner su disco o carpeta donde estaba</translation>
    </message>
</context>
<context>
    <name>capture.rate_not_taken</name>
    <message>
        <source>it rejects this rate (%1)</source>
        <translation>no admite esta frecuencia (%1)</translation>
    </message>
</context>
<context>
    <name>capture.rate_too_slow</name>
    <message>
        <source>%1 (too slow)</source>
        <translation>%1 (demasiado lento)</translation>
    </message>
</context>
<context>
    <name>capture.rates_differ</name>
    <message>
        <source>the cameras run at %1 and %2</source>
        <translation>las cámaras funcionan a %1 y %2</translation>
    </message>
</context>
<context>
    <name>capture.receive_buffer</name>
    <message>
        <source>Receive buffer</source>
        <translation>Búfer de recepción</translation>
    </message>
</context>
<context>
    <name>capture.receive_buffer_granted</name>
    <message>
        <source>the system keeps only %1 of the network&apos;s packets</source>
        <translation>el sistema guarda solo %1 de los paquetes de la red</translation>
    </message>
</context>
<context>
    <name>capture.record_elsewhere</name>
    <message>
        <source>record to another disk, or use fewer cameras</source>
        <translation>grabe en otro disco, o con menos cámaras</translation>
    </message>
</context>
<context>
    <name>capture.recorded_is_kept</name>
    <message>
        <source>what was recorded so far is kept</source>
        <translation>lo grabado hasta ahora se conserva</translation>
    </message>
</context>
<context>
    <name>capture.recorded_is_there</name>
    <message>
        <source>it holds what was recorded so far</source>
        <translation>lo grabado hasta ahora está allí</translation>
    </message>
</context>
<context>
    <name>capture.recording_file_gone</name>
    <message>
        <source>its file is no longer there</source>
        <translation>su archivo ya no está</translation>
    </message>
</context>
<context>
    <name>capture.register_in_testbed</name>
    <message>
        <source>register it in Testbed; Odograph needs this to measure where a robot is</source>
        <translation>regístrela en Banco, o sus imágenes no podrán decir dónde está un robot</translation>
    </message>
</context>
<context>
    <name>capture.room_for</name>
    <message>
        <source>remaining recording time %1</source>
        <translation>tiempo de grabación restante: %1</translation>
    </message>
</context>
<context>
    <name>capture.see_own_line</name>
    <message>
        <source>see the line of that camera</source>
        <translation>vea su propia línea</translation>
    </message>
</context>
<context>
    <name>capture.send_less</name>
    <message>
        <source>or set both to MJPEG or to a smaller frame size</source>
        <translation>o haga que ambas envíen MJPEG, o imágenes más pequeñas</translation>
    </message>
</context>
<context>
    <name>capture.send_registered_size</name>
    <message>
        <source>set it to the size it was registered at, or calibrate and register it again</source>
        <translation>haga que envíe el tamaño con que se registró, o calíbrela y regístrela de nuevo</translation>
    </message>
</context>
<context>
    <name>capture.sends_no_pictures</name>
    <message>
        <source>it sends no frames</source>
        <translation>no envía imágenes</translation>
    </message>
</context>
<context>
    <name>capture.serial_advice</name>
    <message>
        <source>check its power and cable; odograph cameras lists those that answer</source>
        <translation>compruebe su alimentación y su cable; Cámaras… en Grabar muestra las que responden</translation>
    </message>
</context>
<context>
    <name>capture.serial_does_not_answer</name>
    <message>
        <source>no camera of this serial number answers</source>
        <translation>ninguna cámara con ese número de serie responde</translation>
    </message>
</context>
<context>
    <name>capture.set_as_before</name>
    <message>
        <source>restore its settings, or start over with size and format in its address</source>
        <translation>ajústela como antes, o empiece de nuevo con tamaño y formato en su dirección</translation>
    </message>
</context>
<context>
    <name>capture.set_between</name>
    <message>
        <source>set it to something between</source>
        <translation>póngalo en algo intermedio</translation>
    </message>
</context>
<context>
    <name>capture.set_rate_or_trigger</name>
    <message>
        <source>set both to the same rate, or trigger them together</source>
        <translation>ponga ambas a la misma frecuencia, o dispárelas juntas</translation>
    </message>
</context>
<context>
    <name>capture.set_receive_buffer</name>
    <message>
        <source>sysctl -w net.core.rmem_max=%1</source>
        <translation>sysctl -w net.core.rmem_max=%1</translation>
    </message>
</context>
<context>
    <name>capture.set_to_mains</name>
    <message>
        <source>set &apos;%1&apos; to your mains frequency</source>
        <translation>ajuste &apos;%1&apos; a su red eléctrica</translation>
    </message>
</context>
<context>
    <name>capture.set_to_one_rate</name>
    <message>
        <source>set both to the same rate</source>
        <translation>ponga ambas a la misma frecuencia</translation>
    </message>
</context>
<context>
    <name>capture.set_to_something_else</name>
    <message>
        <source>set another value</source>
        <translation>póngalo en otra cosa</translation>
    </message>
</context>
<context>
    <name>capture.set_width_and_height</name>
    <message>
        <source>set its width and height</source>
        <translation>ajuste su ancho y su alto</translation>
    </message>
</context>
<context>
    <name>capture.several_not_held</name>
    <message>
        <source>%1 still adjust automatically</source>
        <translation>%1 siguen cambiando por sí mismos</translation>
    </message>
</context>
<context>
    <name>capture.simulated_camera</name>
    <message>
        <source>Simulated camera %1</source>
        <translation>Cámara simulada %1</translation>
    </message>
</context>
<context>
    <name>capture.size_as_registered</name>
    <message>
        <source>%1, as it was registered</source>
        <translation>%1, como se registró</translation>
    </message>
</context>
<context>
    <name>capture.size_not_as_registered</name>
    <message>
        <source>%1, but registered at %2</source>
        <translation>%1, pero registrada a %2</translation>
    </message>
</context>
<context>
    <name>capture.size_not_taken</name>
    <message>
        <source>it rejects this size (%1)</source>
        <translation>no admite este tamaño (%1)</translation>
    </message>
</context>
<context>
    <name>capture.size_not_told</name>
    <message>
        <source>it does not report its width and height (%1)</source>
        <translation>no dice su tamaño (%1)</translation>
    </message>
</context>
<context>
    <name>capture.slow_camera</name>
    <message>
        <source>it delivers only %1 frames per second instead of the requested %2</source>
        <translation>solo toma %1 imágenes por segundo de las %2 pedidas</translation>
    </message>
</context>
<context>
    <name>capture.slow_camera_advice</name>
    <message>
        <source>give it more light or a shorter exposure, or ask for a lower rate</source>
        <translation>dele más luz o una exposición más corta, o pida una frecuencia menor</translation>
    </message>
</context>
<context>
    <name>capture.small_packets</name>
    <message>
        <source>small packets on %1</source>
        <translation>paquetes pequeños en %1</translation>
    </message>
</context>
<context>
    <name>capture.small_packets_advice</name>
    <message>
        <source>set the MTU of the camera&apos;s network port to 9000 (sudo ip link set dev NAME mtu 9000), if camera and switch support it</source>
        <translation>dé al puerto de la cámara una MTU de 9000 (sudo ip link set dev NAME mtu 9000), si la cámara y el conmutador lo admiten</translation>
    </message>
</context>
<context>
    <name>capture.step</name>
    <message>
        <source>Synchronisation</source>
        <translation>Sincronía</translation>
    </message>
</context>
<context>
    <name>capture.take_another_camera</name>
    <message>
        <source>use another camera</source>
        <translation>use otra cámara</translation>
    </message>
</context>
<context>
    <name>capture.take_camera_with_format</name>
    <message>
        <source>use a camera that offers one of %1</source>
        <translation>use una cámara que tenga uno de %1</translation>
    </message>
</context>
<context>
    <name>capture.take_off_and_on</name>
    <message>
        <source>unplug it and plug it in again if this continues</source>
        <translation>desconéctela y conéctela de nuevo si sigue así</translation>
    </message>
</context>
<context>
    <name>capture.take_simulated_camera</name>
    <message>
        <source>use sim:A or sim:B</source>
        <translation>use sim:A o sim:B</translation>
    </message>
</context>
<context>
    <name>capture.taken_up_by_itself</name>
    <message>
        <source>Odograph reconnects automatically</source>
        <translation>se retoma por sí sola</translation>
    </message>
</context>
<context>
    <name>capture.the_picture</name>
    <message>
        <source>the frame</source>
        <translation>la imagen</translation>
    </message>
</context>
<context>
    <name>capture.the_recording</name>
    <message>
        <source>the recording %1</source>
        <translation>la grabación %1</translation>
    </message>
</context>
<context>
    <name>capture.there_but_silent</name>
    <message>
        <source>it is connected but sends no frames</source>
        <translation>está ahí pero no envía imágenes</translation>
    </message>
</context>
<context>
    <name>capture.there_but_silent_advice</name>
    <message>
        <source>check its cable; if this continues, plug it in again</source>
        <translation>revise su cable, o conéctela de nuevo si eso persiste</translation>
    </message>
</context>
<context>
    <name>capture.these_and_others</name>
    <message>
        <source>%1 and others</source>
        <translation>%1 y otros</translation>
    </message>
</context>
<context>
    <name>capture.this_computer</name>
    <message>
        <source>this computer</source>
        <translation>esta computadora</translation>
    </message>
</context>
<context>
    <name>capture.turn_automatic_off</name>
    <message>
        <source>turn automatic mode off</source>
        <translation>desactive el automatismo</translation>
    </message>
</context>
<context>
    <name>capture.turn_off_at_camera</name>
    <message>
        <source>turn it off in the camera&apos;s own program, or keep the light steady while robots run</source>
        <translation>desactívelo en el programa de la cámara, o mantenga la luz constante mientras corren los robots</translation>
    </message>
</context>
<context>
    <name>capture.turn_off_automatic_first</name>
    <message>
        <source>first turn off the automatic mode that controls it</source>
        <translation>desactive antes el automatismo que lo mueve</translation>
    </message>
</context>
<context>
    <name>capture.unplugged</name>
    <message>
        <source>it was unplugged</source>
        <translation>se desconectó</translation>
    </message>
</context>
<context>
    <name>capture.usb_bus_full</name>
    <message>
        <source>its USB bus has no bandwidth left for its frames (the bus is full, not the disk)</source>
        <translation>su bus USB no tiene espacio para sus imágenes (está lleno el bus, no el disco)</translation>
    </message>
</context>
<context>
    <name>capture.usb_bus_full_advice</name>
    <message>
        <source>plug it into a port whose bus no other camera uses, or choose MJPEG, a smaller frame size or a lower rate (?format=MJPG&amp;size=640x480&amp;rate=30)</source>
        <translation>conéctela donde no comparta bus con otra cámara, o elija MJPEG, una imagen menor o una frecuencia menor (?format=MJPG&amp;size=640x480&amp;rate=30)</translation>
    </message>
</context>
<context>
    <name>capture.usb_buses</name>
    <message>
        <source>USB buses</source>
        <translation>Buses USB</translation>
    </message>
</context>
<context>
    <name>capture.use_daylight</name>
    <message>
        <source>or use daylight</source>
        <translation>o use luz natural</translation>
    </message>
</context>
<context>
    <name>capture.use_other_port</name>
    <message>
        <source>plug one into a port on the other side of the computer, or into its own USB card</source>
        <translation>conecte una a un puerto del otro lado de la computadora, o a una tarjeta propia</translation>
    </message>
</context>
<context>
    <name>capture.used_by_another_program</name>
    <message>
        <source>another program uses it</source>
        <translation>otro programa la usa</translation>
    </message>
</context>
<context>
    <name>capture.used_by_program</name>
    <message>
        <source>another program uses it (open in %1)</source>
        <translation>otro programa la usa (abierta en %1)</translation>
    </message>
</context>
<context>
    <name>capture.usual_mains</name>
    <message>
        <source>50 Hz in most countries, 60 Hz in the Americas</source>
        <translation>50 Hz en la mayoría de los países, 60 Hz en América</translation>
    </message>
</context>
<context>
    <name>capture.v4l2_address_example</name>
    <message>
        <source>write it like v4l2:/dev/video0?size=1280x720&amp;rate=30&amp;format=MJPG</source>
        <translation>escriba por ejemplo v4l2:/dev/video0?size=1280x720&amp;rate=30&amp;format=MJPG</translation>
    </message>
</context>
<context>
    <name>capture.video_has_ended</name>
    <message>
        <source>the video has ended</source>
        <translation>el video ha terminado</translation>
    </message>
</context>
<context>
    <name>capture.wait_for_it</name>
    <message>
        <source>wait: Odograph is reconnecting</source>
        <translation>espere: se retoma</translation>
    </message>
</context>
<context>
    <name>capture.wait_or_check_cable</name>
    <message>
        <source>wait, or check its cable</source>
        <translation>espere, o compruebe su cable</translation>
    </message>
</context>
<context>
    <name>capture.waiting_for_first_picture</name>
    <message>
        <source>waiting for the first frame</source>
        <translation>esperando la primera imagen</translation>
    </message>
</context>
<context>
    <name>exchange.accepted</name>
    <message>
        <source>Accepted: %1</source>
        <translation>Aceptado: %1</translation>
    </message>
</context>
<context>
    <name>exchange.and_lines_more</name>
    <message>
        <source>and %1 more lines</source>
        <translation>y %1 líneas más</translation>
    </message>
</context>
<context>
    <name>exchange.archive_library_refused</name>
    <message>
        <source>the archive library failed</source>
        <translation>la biblioteca de archivos se negó</translation>
    </message>
</context>
<context>
    <name>exchange.at_line</name>
    <message>
        <source>%1:%2</source>
        <translation>%1:%2</translation>
    </message>
</context>
<context>
    <name>exchange.axes_given</name>
    <message>
        <source>floor axes: %1 of the file</source>
        <translation>ejes del suelo: %1 del archivo</translation>
    </message>
</context>
<context>
    <name>exchange.axes_seen</name>
    <message>
        <source>floor axes: %1 of the file, as its %2 stays near %3</source>
        <translation>ejes del suelo: %1 del archivo, ya que su %2 se mantiene cerca de %3</translation>
    </message>
</context>
<context>
    <name>exchange.axes_unclear</name>
    <message>
        <source>its z varies by %1 while its %2 stays near %3</source>
        <translation>su z varía %1 mientras que su %2 se mantiene cerca de %3</translation>
    </message>
</context>
<context>
    <name>exchange.begin_roster</name>
    <message>
        <source>begin the file with the line class,team or class,team,pseudonym</source>
        <translation>empiece el archivo con la línea class,team o class,team,pseudonym</translation>
    </message>
</context>
<context>
    <name>exchange.begin_with_header_or_tum</name>
    <message>
        <source>begin the file with the line %1, or write lines of %2</source>
        <translation>empiece el archivo con la línea %1, o escriba líneas de %2</translation>
    </message>
</context>
<context>
    <name>exchange.begin_with_line</name>
    <message>
        <source>begin the file with the line %1</source>
        <translation>empiece el archivo con la línea %1</translation>
    </message>
</context>
<context>
    <name>exchange.break_opened</name>
    <message>
        <source>its positions jump by %1 in line %2 and go on from there: %3 positions around count as not measured, and the path ends at the jump</source>
        <translation>sus posiciones saltan %1 en la línea %2 y siguen desde allí: %3 posiciones alrededor cuentan como no medidas y el recorrido termina en el salto</translation>
    </message>
</context>
<context>
    <name>exchange.breaks_too_often</name>
    <message>
        <source>its positions jump %1 times and go on from elsewhere</source>
        <translation>sus posiciones saltan %1 veces y siguen en otro lugar</translation>
    </message>
</context>
<context>
    <name>exchange.cell_not_a_number</name>
    <message>
        <source>%1 &apos;%2&apos; is not a finite number</source>
        <translation>%1 &apos;%2&apos; no es un número finito</translation>
    </message>
</context>
<context>
    <name>exchange.cell_of_columns</name>
    <message>
        <source>it has %1 cell where the header has %2</source>
        <translation>tiene %1 celda donde la cabecera tiene %2</translation>
    </message>
</context>
<context>
    <name>exchange.cells_of_columns</name>
    <message>
        <source>it has %1 cells where the header has %2</source>
        <translation>tiene %1 celdas donde la cabecera tiene %2</translation>
    </message>
</context>
<context>
    <name>exchange.centre_impossible</name>
    <message>
        <source>the image centre (%1, %2) is far outside the image of %3 × %4 pixels</source>
        <translation>el centro de la imagen (%1, %2) queda muy fuera de la imagen de %3 × %4 píxeles</translation>
    </message>
</context>
<context>
    <name>exchange.check_both_units</name>
    <message>
        <source>choose the units of its times and positions</source>
        <translation>elija las unidades de sus tiempos y posiciones</translation>
    </message>
</context>
<context>
    <name>exchange.check_it_is_there</name>
    <message>
        <source>check that it exists and that you may read it</source>
        <translation>compruebe que está ahí y se puede leer</translation>
    </message>
</context>
<context>
    <name>exchange.check_one_run</name>
    <message>
        <source>check that all lines are of one run</source>
        <translation>compruebe que todas las líneas son de un mismo recorrido</translation>
    </message>
</context>
<context>
    <name>exchange.check_right_file</name>
    <message>
        <source>check that it is the right file</source>
        <translation>compruebe que es el archivo correcto</translation>
    </message>
</context>
<context>
    <name>exchange.check_track_column</name>
    <message>
        <source>check which column says the track of a line</source>
        <translation>compruebe qué columna indica la trayectoria de una línea</translation>
    </message>
</context>
<context>
    <name>exchange.check_unit_of_places</name>
    <message>
        <source>check the unit of the positions: m, cm or mm</source>
        <translation>compruebe la unidad de los lugares: m, cm o mm</translation>
    </message>
</context>
<context>
    <name>exchange.check_unit_of_times</name>
    <message>
        <source>check the unit of the times, and that all lines are of one run</source>
        <translation>compruebe la unidad de los tiempos, y que todas las líneas son de un mismo recorrido</translation>
    </message>
</context>
<context>
    <name>exchange.choose_axes</name>
    <message>
        <source>choose the axes of the floor: %1, or xy if that is right</source>
        <translation>elija los ejes del suelo: %1, o xy si es lo correcto</translation>
    </message>
</context>
<context>
    <name>exchange.choose_axes_xy</name>
    <message>
        <source>choose the axes x and y</source>
        <translation>elija los ejes x e y</translation>
    </message>
</context>
<context>
    <name>exchange.choose_column</name>
    <message>
        <source>choose from %1</source>
        <translation>elija entre %1</translation>
    </message>
</context>
<context>
    <name>exchange.choose_decimal_sign</name>
    <message>
        <source>choose its decimal sign: point or comma</source>
        <translation>elija su signo decimal: punto o coma</translation>
    </message>
</context>
<context>
    <name>exchange.choose_entry</name>
    <message>
        <source>choose one of them</source>
        <translation>elija una de ellas</translation>
    </message>
</context>
<context>
    <name>exchange.choose_likely_unit</name>
    <message>
        <source>choose their unit: m, cm, mm, in, ft or px; %1 is likely</source>
        <translation>elija su unidad: m, cm, mm, in, ft o px; lo más probable es %1</translation>
    </message>
</context>
<context>
    <name>exchange.choose_longer_track</name>
    <message>
        <source>choose a file with three positions or more</source>
        <translation>elija un archivo con tres posiciones o más</translation>
    </message>
</context>
<context>
    <name>exchange.choose_new_folder</name>
    <message>
        <source>choose a folder that does not exist yet</source>
        <translation>elija una carpeta que aún no exista</translation>
    </message>
</context>
<context>
    <name>exchange.choose_packed_file</name>
    <message>
        <source>choose a file that Odograph has packed; if it is damaged, copy it again</source>
        <translation>elija un archivo empaquetado por Odograph, y cópielo de nuevo si está dañado</translation>
    </message>
</context>
<context>
    <name>exchange.choose_style</name>
    <message>
        <source>choose analysis, international or continental</source>
        <translation>elija analysis, international o continental</translation>
    </message>
</context>
<context>
    <name>exchange.choose_time_unit</name>
    <message>
        <source>choose their unit: s, ms, us, ns, min, h, d or frame; %1 is likely</source>
        <translation>elija su unidad: s, ms, us, ns, min, h, d o frame; lo más probable es %1</translation>
    </message>
</context>
<context>
    <name>exchange.choose_unit</name>
    <message>
        <source>choose their unit: m, cm, mm, in, ft or px</source>
        <translation>elija su unidad: m, cm, mm, in, ft o px</translation>
    </message>
</context>
<context>
    <name>exchange.close_quotes</name>
    <message>
        <source>close the quotes</source>
        <translation>cierre las comillas</translation>
    </message>
</context>
<context>
    <name>exchange.closed_neither</name>
    <message>
        <source>&apos;closed&apos; is neither true nor false</source>
        <translation>&apos;closed&apos; no es ni true ni false</translation>
    </message>
</context>
<context>
    <name>exchange.coefficients_no_row</name>
    <message>
        <source>&apos;distortion_coefficients&apos; is neither a row nor a column</source>
        <translation>&apos;distortion_coefficients&apos; no es ni una fila ni una columna</translation>
    </message>
</context>
<context>
    <name>exchange.column_twice</name>
    <message>
        <source>it is named twice</source>
        <translation>está nombrada dos veces</translation>
    </message>
</context>
<context>
    <name>exchange.commas_group_thousands</name>
    <message>
        <source>commas separate thousands</source>
        <translation>las comas separan millares</translation>
    </message>
</context>
<context>
    <name>exchange.confidence_not_used</name>
    <message>
        <source>its confidences are neither from 0 to 1 nor from 0 to 100, and were not used</source>
        <translation>sus valores de confianza no van de 0 a 1 ni de 0 a 100 y no se usaron</translation>
    </message>
</context>
<context>
    <name>exchange.csv_column</name>
    <message>
        <source>column &apos;%1&apos; of CSV</source>
        <translation>columna &apos;%1&apos; de CSV</translation>
    </message>
</context>
<context>
    <name>exchange.csv_style</name>
    <message>
        <source>style &apos;%1&apos; of CSV</source>
        <translation>estilo &apos;%1&apos; de CSV</translation>
    </message>
</context>
<context>
    <name>exchange.cut_line_left_out</name>
    <message>
        <source>the last line, line %1, was left out, because it ends too early</source>
        <translation>se omitió la última línea, la %1, porque termina demasiado pronto</translation>
    </message>
</context>
<context>
    <name>exchange.does_not_belong</name>
    <message>
        <source>&apos;%1&apos; does not belong in a packed project</source>
        <translation>&apos;%1&apos; no corresponde a un proyecto empaquetado</translation>
    </message>
</context>
<context>
    <name>exchange.entry_is_missing</name>
    <message>
        <source>the entry &apos;%1&apos; is missing</source>
        <translation>falta la entrada &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.file_too_large</name>
    <message>
        <source>it is larger than %1</source>
        <translation>ocupa más de %1</translation>
    </message>
</context>
<context>
    <name>exchange.fill_in_all_cells</name>
    <message>
        <source>give each line as many cells as the header</source>
        <translation>dé a cada línea tantas celdas como la cabecera</translation>
    </message>
</context>
<context>
    <name>exchange.fill_in_both</name>
    <message>
        <source>fill in both or none</source>
        <translation>rellene ambos o ninguno</translation>
    </message>
</context>
<context>
    <name>exchange.focal_impossible</name>
    <message>
        <source>no lens has a focal length of %1 at %2 × %3 pixels</source>
        <translation>ningún objetivo tiene una distancia focal de %1 con %2 × %3 píxeles</translation>
    </message>
</context>
<context>
    <name>exchange.format_has_pixels</name>
    <message>
        <source>%1 writes positions in pixels, which are no lengths</source>
        <translation>%1 escribe posiciones en píxeles, que no son longitudes</translation>
    </message>
</context>
<context>
    <name>exchange.frame_without_time</name>
    <message>
        <source>it has no time that can be read</source>
        <translation>no tiene ningún tiempo legible</translation>
    </message>
</context>
<context>
    <name>exchange.frames_without_rate</name>
    <message>
        <source>it has frame numbers in place of times</source>
        <translation>tiene números de fotograma en lugar de tiempos</translation>
    </message>
</context>
<context>
    <name>exchange.give_known_units</name>
    <message>
        <source>give times in s or ms and positions in m, cm or mm</source>
        <translation>dé los tiempos en s o ms y los lugares en m, cm o mm</translation>
    </message>
</context>
<context>
    <name>exchange.give_lower_confidence</name>
    <message>
        <source>give a lower least confidence</source>
        <translation>indique una confianza mínima menor</translation>
    </message>
</context>
<context>
    <name>exchange.give_marker_label</name>
    <message>
        <source>give each marker a label</source>
        <translation>dé un rótulo a cada marcador</translation>
    </message>
</context>
<context>
    <name>exchange.give_one_path</name>
    <message>
        <source>give one of points_mm, circle, figure_eight or slalom</source>
        <translation>dé uno de points_mm, circle, figure_eight o slalom</translation>
    </message>
</context>
<context>
    <name>exchange.give_one_zone</name>
    <message>
        <source>give all corners in order as corners_mm, or two opposite corners as rectangle_mm</source>
        <translation>dé corners_mm, todo alrededor, o dos esquinas opuestas como rectangle_mm</translation>
    </message>
</context>
<context>
    <name>exchange.give_pixel_length</name>
    <message>
        <source>give how long a pixel is on the floor, or choose another unit of the positions</source>
        <translation>indique cuánto mide un píxel en el suelo o elija otra unidad para las posiciones</translation>
    </message>
</context>
<context>
    <name>exchange.give_point_label</name>
    <message>
        <source>give each point a label</source>
        <translation>dé un rótulo a cada punto</translation>
    </message>
</context>
<context>
    <name>exchange.give_rate</name>
    <message>
        <source>give the frame rate of the camera</source>
        <translation>indique la frecuencia de imagen de la cámara</translation>
    </message>
</context>
<context>
    <name>exchange.give_two_corners</name>
    <message>
        <source>give two opposite corners: [[x, y], [x, y]]</source>
        <translation>dé dos esquinas opuestas: [[x, y], [x, y]]</translation>
    </message>
</context>
<context>
    <name>exchange.has_become_shorter</name>
    <message>
        <source>it has become shorter during packing</source>
        <translation>entretanto se ha acortado</translation>
    </message>
</context>
<context>
    <name>exchange.held_left_out</name>
    <message>
        <source>%1 positions that only repeat the last one count as not measured; the first is in line %2</source>
        <translation>%1 posiciones que solo repiten la última cuentan como no medidas; la primera está en la línea %2</translation>
    </message>
</context>
<context>
    <name>exchange.is_in_it_twice</name>
    <message>
        <source>it contains &apos;%1&apos; twice</source>
        <translation>&apos;%1&apos; está dos veces en él</translation>
    </message>
</context>
<context>
    <name>exchange.is_no_utf8</name>
    <message>
        <source>it is not a UTF-8 text file</source>
        <translation>no es un archivo de texto UTF-8</translation>
    </message>
</context>
<context>
    <name>exchange.is_utf16</name>
    <message>
        <source>it is written in UTF-16</source>
        <translation>está escrito en UTF-16</translation>
    </message>
</context>
<context>
    <name>exchange.is_xml</name>
    <message>
        <source>it is written in XML</source>
        <translation>está escrito en XML</translation>
    </message>
</context>
<context>
    <name>exchange.key_is_no_text</name>
    <message>
        <source>a key is not text, or a bracket is not closed</source>
        <translation>una clave no es un texto o falta cerrar un paréntesis</translation>
    </message>
</context>
<context>
    <name>exchange.key_is_there_twice</name>
    <message>
        <source>the key &apos;%1&apos; appears twice</source>
        <translation>la clave &apos;%1&apos; está dos veces</translation>
    </message>
</context>
<context>
    <name>exchange.key_not_known</name>
    <message>
        <source>the key &apos;%1&apos; is not known</source>
        <translation>la clave &apos;%1&apos; no se conoce</translation>
    </message>
</context>
<context>
    <name>exchange.label_is_empty</name>
    <message>
        <source>the label is empty</source>
        <translation>el rótulo está vacío</translation>
    </message>
</context>
<context>
    <name>exchange.label_is_there</name>
    <message>
        <source>line %2 already has the label &apos;%1&apos;</source>
        <translation>el rótulo &apos;%1&apos; ya está en la línea %2</translation>
    </message>
</context>
<context>
    <name>exchange.lacks_column</name>
    <message>
        <source>it lacks the column %1</source>
        <translation>le falta la columna %1</translation>
    </message>
</context>
<context>
    <name>exchange.lacks_header</name>
    <message>
        <source>it lacks the expected header line</source>
        <translation>le falta la línea de cabecera esperada</translation>
    </message>
</context>
<context>
    <name>exchange.leave_out_confidence</name>
    <message>
        <source>leave out the least confidence</source>
        <translation>omita la confianza mínima</translation>
    </message>
</context>
<context>
    <name>exchange.leave_out_rate</name>
    <message>
        <source>leave out the frame rate</source>
        <translation>omita la frecuencia de imagen</translation>
    </message>
</context>
<context>
    <name>exchange.lens_model_not_known</name>
    <message>
        <source>the lens model &apos;%1&apos; is unknown (known models: plumb_bob, rational_polynomial, equidistant)</source>
        <translation>el modelo de lente &apos;%1&apos; no se conoce (sí plumb_bob, rational_polynomial, equidistant)</translation>
    </message>
</context>
<context>
    <name>exchange.line_too_long</name>
    <message>
        <source>it is longer than 8 MiB</source>
        <translation>tiene más de 8 MiB</translation>
    </message>
</context>
<context>
    <name>exchange.line_without_class</name>
    <message>
        <source>line %1 has no class for team &apos;%2&apos;</source>
        <translation>la línea %1 no tiene clase para el equipo &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.line_without_team</name>
    <message>
        <source>line %1 has no team</source>
        <translation>la línea %1 no tiene equipo</translation>
    </message>
</context>
<context>
    <name>exchange.longer_than_a_week</name>
    <message>
        <source>it is more than a week after the first line</source>
        <translation>es más de una semana después de la primera línea</translation>
    </message>
</context>
<context>
    <name>exchange.marks_left_out</name>
    <message>
        <source>%1 positions that only mark a lost robot (such as 0, 0) count as not measured; the first is in line %2</source>
        <translation>%1 posiciones que solo marcan un robot perdido (como 0, 0) cuentan como no medidas; la primera está en la línea %2</translation>
    </message>
</context>
<context>
    <name>exchange.matrix_not_3_by_3</name>
    <message>
        <source>&apos;camera_matrix&apos; is not a 3 × 3 matrix</source>
        <translation>&apos;camera_matrix&apos; no es una matriz de 3 × 3</translation>
    </message>
</context>
<context>
    <name>exchange.matrix_of_other_form</name>
    <message>
        <source>&apos;camera_matrix&apos; is not of the form fx 0 cx, 0 fy cy, 0 0 1</source>
        <translation>&apos;camera_matrix&apos; no tiene la forma fx 0 cx, 0 fy cy, 0 0 1</translation>
    </message>
</context>
<context>
    <name>exchange.measured_otherwise</name>
    <message>
        <source>It was analysed with a different course than its task has now.</source>
        <translation>Se analizó con un circuito distinto del que tiene ahora su tarea.</translation>
    </message>
</context>
<context>
    <name>exchange.mend_lines</name>
    <message>
        <source>correct these lines</source>
        <translation>corrija estas líneas</translation>
    </message>
</context>
<context>
    <name>exchange.name_column_once</name>
    <message>
        <source>name each column once</source>
        <translation>nombre cada columna una vez</translation>
    </message>
</context>
<context>
    <name>exchange.named_track_has_position</name>
    <message>
        <source>track &apos;%1&apos; has %2 position</source>
        <translation>la traza &apos;%1&apos; tiene %2 posición</translation>
    </message>
</context>
<context>
    <name>exchange.named_track_has_positions</name>
    <message>
        <source>track &apos;%1&apos; has %2 positions</source>
        <translation>la traza &apos;%1&apos; tiene %2 posiciones</translation>
    </message>
</context>
<context>
    <name>exchange.neither_header_nor_tum</name>
    <message>
        <source>it has no header with a time, x and y, and it is not a TUM file</source>
        <translation>no tiene cabecera con tiempo, x e y, y tampoco es TUM</translation>
    </message>
</context>
<context>
    <name>exchange.nested_too_deep</name>
    <message>
        <source>it is nested more than %1 deep</source>
        <translation>está anidado a más de %1 niveles</translation>
    </message>
</context>
<context>
    <name>exchange.no_anchors</name>
    <message>
        <source>anchors and aliases are not supported</source>
        <translation>no se admiten anclas ni alias</translation>
    </message>
</context>
<context>
    <name>exchange.no_confidence</name>
    <message>
        <source>it has no column of confidences</source>
        <translation>no tiene una columna de confianza</translation>
    </message>
</context>
<context>
    <name>exchange.no_list_of_numbers</name>
    <message>
        <source>&apos;%1&apos; is not a list of numbers</source>
        <translation>&apos;%1&apos; no es una lista de números</translation>
    </message>
</context>
<context>
    <name>exchange.no_markers</name>
    <message>
        <source>no markers follow the header</source>
        <translation>no hay marcadores debajo de la cabecera</translation>
    </message>
</context>
<context>
    <name>exchange.no_project_inside</name>
    <message>
        <source>it contains no project</source>
        <translation>no contiene ningún proyecto</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_column</name>
    <message>
        <source>this column does not exist</source>
        <translation>no existe esa columna</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_entry</name>
    <message>
        <source>it holds no camera &apos;%1&apos;, but %2</source>
        <translation>no contiene ninguna cámara «%1», sino %2</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_style</name>
    <message>
        <source>this style does not exist</source>
        <translation>no existe ese estilo</translation>
    </message>
</context>
<context>
    <name>exchange.no_task</name>
    <message>
        <source>the file holds no task</source>
        <translation>el archivo no contiene ninguna tarea</translation>
    </message>
</context>
<context>
    <name>exchange.no_third_axis</name>
    <message>
        <source>it has no third coordinate</source>
        <translation>no tiene una tercera coordenada</translation>
    </message>
</context>
<context>
    <name>exchange.no_time_column</name>
    <message>
        <source>no column of it is called a time</source>
        <translation>ninguna de sus columnas se llama como un tiempo</translation>
    </message>
</context>
<context>
    <name>exchange.no_track_has_position</name>
    <message>
        <source>none of its tracks has a position</source>
        <translation>ninguna de sus trazas tiene una posición</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_toml</name>
    <message>
        <source>it is not valid TOML (%1)</source>
        <translation>no es TOML válido (%1)</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_yaml</name>
    <message>
        <source>it is not valid YAML (%1)</source>
        <translation>no es YAML válido (%1)</translation>
    </message>
</context>
<context>
    <name>exchange.none_sure_enough</name>
    <message>
        <source>none of its positions has a confidence of %1</source>
        <translation>ninguna de sus posiciones tiene una confianza de %1</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_finite_number</name>
    <message>
        <source>&apos;%1&apos; is not a finite number</source>
        <translation>&apos;%1&apos; no es un número finito</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_list</name>
    <message>
        <source>&apos;%1&apos; is not a list in brackets</source>
        <translation>&apos;%1&apos; no es una lista entre corchetes</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_point</name>
    <message>
        <source>&apos;%1&apos; is not a point [x, y] in mm</source>
        <translation>&apos;%1&apos; no es un punto [x, y] en mm</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_time</name>
    <message>
        <source>&apos;%1&apos; is not a time</source>
        <translation>&apos;%1&apos; no es un tiempo</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_whole_number</name>
    <message>
        <source>&apos;%1&apos; is not a whole number from %2 to %3</source>
        <translation>&apos;%1&apos; no es un número entero de %2 a %3</translation>
    </message>
</context>
<context>
    <name>exchange.not_above_zero</name>
    <message>
        <source>&apos;%1&apos; is not above zero</source>
        <translation>&apos;%1&apos; no es mayor que cero</translation>
    </message>
</context>
<context>
    <name>exchange.not_two_corners</name>
    <message>
        <source>&apos;rectangle_mm&apos; is not two corners</source>
        <translation>&apos;rectangle_mm&apos; no son dos esquinas</translation>
    </message>
</context>
<context>
    <name>exchange.nothing_imported</name>
    <message>
        <source>nothing was imported</source>
        <translation>no se importó nada</translation>
    </message>
</context>
<context>
    <name>exchange.number_in_two_ways</name>
    <message>
        <source>its numbers can be read in two ways: &apos;%1&apos; with three decimals, or as %2</source>
        <translation>sus números se pueden leer de dos maneras: &apos;%1&apos; con tres decimales o como %2</translation>
    </message>
</context>
<context>
    <name>exchange.object_expected</name>
    <message>
        <source>it must be an object in braces</source>
        <translation>aquí se espera un objeto entre llaves</translation>
    </message>
</context>
<context>
    <name>exchange.one_error_blank</name>
    <message>
        <source>one of its two uncertainties is blank</source>
        <translation>uno de sus dos errores está en blanco</translation>
    </message>
</context>
<context>
    <name>exchange.one_place_blank</name>
    <message>
        <source>one of its two coordinates is blank</source>
        <translation>uno de sus dos lugares está en blanco</translation>
    </message>
</context>
<context>
    <name>exchange.one_time_a_frame</name>
    <message>
        <source>give one time for each frame, in the order of the frames, under a name such as t_s</source>
        <translation>indique un tiempo por fotograma, en el orden de los fotogramas, con un nombre como t_s</translation>
    </message>
</context>
<context>
    <name>exchange.order_lines</name>
    <message>
        <source>sort the lines by time, with each time only once</source>
        <translation>ponga las líneas en orden de tiempo, cada tiempo una vez</translation>
    </message>
</context>
<context>
    <name>exchange.pack</name>
    <message>
        <source>pack &apos;%1&apos;</source>
        <translation>empaquetar &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.packing</name>
    <message>
        <source>packing %1</source>
        <translation>empaquetando %1</translation>
    </message>
</context>
<context>
    <name>exchange.path_given_twice</name>
    <message>
        <source>the reference path has more than one shape</source>
        <translation>la trayectoria de referencia se da dos veces</translation>
    </message>
</context>
<context>
    <name>exchange.path_not_given</name>
    <message>
        <source>the reference path has no shape</source>
        <translation>la trayectoria de referencia no se da con nada</translation>
    </message>
</context>
<context>
    <name>exchange.pixel_is</name>
    <message>
        <source>a pixel is %1</source>
        <translation>un píxel mide %1</translation>
    </message>
</context>
<context>
    <name>exchange.place_too_far</name>
    <message>
        <source>its position is more than 100 km away</source>
        <translation>su lugar está a más de 100 km</translation>
    </message>
</context>
<context>
    <name>exchange.points_group_thousands</name>
    <message>
        <source>points separate thousands</source>
        <translation>los puntos separan millares</translation>
    </message>
</context>
<context>
    <name>exchange.positions_are_pixels</name>
    <message>
        <source>its positions are in pixels, which are no lengths</source>
        <translation>sus posiciones están en píxeles, que no son longitudes</translation>
    </message>
</context>
<context>
    <name>exchange.positions_as_metres</name>
    <message>
        <source>its positions have no unit and were read as metres</source>
        <translation>sus posiciones no tienen unidad y se leyeron como metros</translation>
    </message>
</context>
<context>
    <name>exchange.quoted_cell_does_not_end</name>
    <message>
        <source>a quoted cell does not end</source>
        <translation>una celda entre comillas no termina</translation>
    </message>
</context>
<context>
    <name>exchange.rate_beside_times</name>
    <message>
        <source>it has times, and no frame numbers</source>
        <translation>tiene tiempos, no números de fotograma</translation>
    </message>
</context>
<context>
    <name>exchange.reading_line</name>
    <message>
        <source>reading line %1</source>
        <translation>leyendo la línea %1</translation>
    </message>
</context>
<context>
    <name>exchange.roster</name>
    <message>
        <source>roster &apos;%1&apos;</source>
        <translation>lista de clase &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.roster_is_empty</name>
    <message>
        <source>it has no team</source>
        <translation>no tiene ningún equipo</translation>
    </message>
</context>
<context>
    <name>exchange.row_without_time</name>
    <message>
        <source>line %1 was left out, because it has no time</source>
        <translation>se omitió la línea %1 porque no tiene tiempo</translation>
    </message>
</context>
<context>
    <name>exchange.rows_without_time</name>
    <message>
        <source>%1 lines were left out, because they have no time; the first is line %2</source>
        <translation>se omitieron %1 líneas porque no tienen tiempo; la primera es la línea %2</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_csv_utf8</name>
    <message>
        <source>save it again as &quot;CSV UTF-8&quot; or as a UTF-8 text</source>
        <translation>guárdelo de nuevo como &quot;CSV UTF-8&quot; o como texto UTF-8</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_utf8</name>
    <message>
        <source>save it again as UTF-8 text</source>
        <translation>guárdelo de nuevo como texto UTF-8</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_yaml</name>
    <message>
        <source>save the calibration as YAML or JSON</source>
        <translation>guarde la calibración como YAML o JSON</translation>
    </message>
</context>
<context>
    <name>exchange.save_with_commas</name>
    <message>
        <source>save it with commas</source>
        <translation>guárdelo con comas</translation>
    </message>
</context>
<context>
    <name>exchange.save_with_commas_and_points</name>
    <message>
        <source>save it with commas, and with a point in its numbers</source>
        <translation>guárdelo con comas, y con punto en sus números</translation>
    </message>
</context>
<context>
    <name>exchange.separated_by_semicolons</name>
    <message>
        <source>its columns are separated by semicolons</source>
        <translation>sus columnas están separadas por punto y coma</translation>
    </message>
</context>
<context>
    <name>exchange.several_cameras</name>
    <message>
        <source>it holds several cameras: %1</source>
        <translation>contiene varias cámaras: %1</translation>
    </message>
</context>
<context>
    <name>exchange.several_documents</name>
    <message>
        <source>it holds more than one document</source>
        <translation>contiene más de un documento</translation>
    </message>
</context>
<context>
    <name>exchange.sides_exchanged</name>
    <message>
        <source>its width and height are exchanged: the image centre (%1, %2) is that of %4 × %3 pixels, not %3 × %4</source>
        <translation>el ancho y el alto están intercambiados: el centro de la imagen (%1, %2) es el de %4 × %3 píxeles, no el de %3 × %4</translation>
    </message>
</context>
<context>
    <name>exchange.sigma_not_above_zero</name>
    <message>
        <source>its uncertainty &apos;%1&apos; is not above zero</source>
        <translation>su incertidumbre &apos;%1&apos; no es mayor que cero</translation>
    </message>
</context>
<context>
    <name>exchange.sigma_or_blank</name>
    <message>
        <source>give the standard deviation of each position, or leave these cells blank</source>
        <translation>indique la desviación típica de cada posición o deje vacías estas celdas</translation>
    </message>
</context>
<context>
    <name>exchange.slalom_without_length</name>
    <message>
        <source>the slalom ends where it starts</source>
        <translation>el eslalon termina donde empieza</translation>
    </message>
</context>
<context>
    <name>exchange.stamp_left_out</name>
    <message>
        <source>line %1 was left out, because its time repeats or is out of order</source>
        <translation>se omitió la línea %1 porque su tiempo se repite o está desordenado</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_left_out</name>
    <message>
        <source>%1 lines were left out, because their times repeat or are out of order; the first is line %2</source>
        <translation>se omitieron %1 líneas porque sus tiempos se repiten o están desordenados; la primera es la línea %2</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_shared</name>
    <message>
        <source>its times are so coarse that %1 lines share theirs with the line before</source>
        <translation>sus tiempos son tan gruesos que %1 líneas comparten el de la línea anterior</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_spread</name>
    <message>
        <source>its times are rounded to %1; the lines were spread evenly, %2 frames/s</source>
        <translation>sus tiempos están redondeados a %1; las líneas se repartieron por igual, %2 fotogramas/s</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_spread_with_gaps</name>
    <message>
        <source>its times are rounded to %1; the lines were spread evenly, with gaps</source>
        <translation>sus tiempos están redondeados a %1; las líneas se repartieron por igual, con huecos</translation>
    </message>
</context>
<context>
    <name>exchange.team_named_again</name>
    <message>
        <source>line %1 names team &apos;%2&apos; again, as line %3</source>
        <translation>la línea %1 nombra otra vez el equipo &apos;%2&apos;, como la línea %3</translation>
    </message>
</context>
<context>
    <name>exchange.time_goes_back</name>
    <message>
        <source>its time is earlier than in the line before</source>
        <translation>su tiempo es anterior al de la línea anterior</translation>
    </message>
</context>
<context>
    <name>exchange.time_of_no_age</name>
    <message>
        <source>its time is more than a century from 1970</source>
        <translation>su tiempo dista más de un siglo de 1970</translation>
    </message>
</context>
<context>
    <name>exchange.time_repeated</name>
    <message>
        <source>its time is the same as in the line before</source>
        <translation>su tiempo es el de la línea anterior</translation>
    </message>
</context>
<context>
    <name>exchange.time_steps_too_long</name>
    <message>
        <source>if its times are seconds, the rows are %1 apart and the run is %2 long</source>
        <translation>si sus tiempos son segundos, las líneas distan %1 y el recorrido dura %2</translation>
    </message>
</context>
<context>
    <name>exchange.time_steps_too_short</name>
    <message>
        <source>its times have no unit, and as seconds the rows would be %1 apart</source>
        <translation>sus tiempos no tienen unidad, y en segundos las líneas distarían %1</translation>
    </message>
</context>
<context>
    <name>exchange.timecode_without_rate</name>
    <message>
        <source>the last part of its times counts frames, up to %1 a second</source>
        <translation>la última parte de sus tiempos cuenta fotogramas, hasta %1 por segundo</translation>
    </message>
</context>
<context>
    <name>exchange.times_by_rate</name>
    <message>
        <source>all its times are the same; the lines were spread at %1 frames/s</source>
        <translation>todos sus tiempos son iguales; las líneas se repartieron a %1 fotogramas/s</translation>
    </message>
</context>
<context>
    <name>exchange.times_in_days</name>
    <message>
        <source>times in days, as spreadsheets write them</source>
        <translation>tiempos en días, como los escriben las hojas de cálculo</translation>
    </message>
</context>
<context>
    <name>exchange.times_in_two_ways</name>
    <message>
        <source>its times can be read in two ways: &apos;%1&apos; with three decimals, or without</source>
        <translation>sus tiempos se pueden leer de dos maneras: &apos;%1&apos; con tres decimales o sin ellos</translation>
    </message>
</context>
<context>
    <name>exchange.times_since_1970</name>
    <message>
        <source>times in %1 since 1970</source>
        <translation>tiempos en %1 desde 1970</translation>
    </message>
</context>
<context>
    <name>exchange.too_fast_as_said</name>
    <message>
        <source>in the units that it gives, the robot would drive at %1</source>
        <translation>en las unidades que indica, el robot iría a %1</translation>
    </message>
</context>
<context>
    <name>exchange.too_fast_in_metres</name>
    <message>
        <source>its positions have no unit, and in metres the robot would drive at %1</source>
        <translation>sus posiciones no tienen unidad, y en metros el robot iría a %1</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_files</name>
    <message>
        <source>it has too many files</source>
        <translation>tiene demasiados archivos</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_places</name>
    <message>
        <source>the file has more than 1.5 million positions</source>
        <translation>el archivo tiene más de 1,5 millones de posiciones</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_tracks</name>
    <message>
        <source>the file has more than 1000 tracks</source>
        <translation>el archivo tiene más de 1000 trayectorias</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_values</name>
    <message>
        <source>it holds more than %1 values</source>
        <translation>contiene más de %1 valores</translation>
    </message>
</context>
<context>
    <name>exchange.too_wide_in_metres</name>
    <message>
        <source>its positions have no unit, and in metres the floor would be %1 wide</source>
        <translation>sus posiciones no tienen unidad, y en metros el suelo mediría %1 de ancho</translation>
    </message>
</context>
<context>
    <name>exchange.track_has_position</name>
    <message>
        <source>the track has %1 position</source>
        <translation>la traza tiene %1 posición</translation>
    </message>
</context>
<context>
    <name>exchange.track_has_positions</name>
    <message>
        <source>the track has %1 positions</source>
        <translation>la traza tiene %1 posiciones</translation>
    </message>
</context>
<context>
    <name>exchange.tum_entries</name>
    <message>
        <source>it has %1 entries instead of the 8 of TUM</source>
        <translation>tiene %1 entradas en lugar de las 8 de TUM</translation>
    </message>
</context>
<context>
    <name>exchange.tum_entry</name>
    <message>
        <source>it has %1 entry instead of the 8 of TUM</source>
        <translation>tiene %1 entrada en lugar de las 8 de TUM</translation>
    </message>
</context>
<context>
    <name>exchange.twins_left_out</name>
    <message>
        <source>%1 lines were left out, because they repeat the line before</source>
        <translation>se omitieron %1 líneas porque repiten la anterior</translation>
    </message>
</context>
<context>
    <name>exchange.unit_not_known</name>
    <message>
        <source>its column &apos;%1&apos; is in a unit that is not known</source>
        <translation>su columna &apos;%1&apos; está en una unidad desconocida</translation>
    </message>
</context>
<context>
    <name>exchange.unpack</name>
    <message>
        <source>unpack &apos;%1&apos;</source>
        <translation>desempaquetar &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.unpack_into</name>
    <message>
        <source>unpack into &apos;%1&apos;</source>
        <translation>desempaquetar en &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.unpacking</name>
    <message>
        <source>unpacking</source>
        <translation>desempaquetando</translation>
    </message>
</context>
<context>
    <name>exchange.unpacks_too_large</name>
    <message>
        <source>it unpacks to more than a hundred times its size</source>
        <translation>al desempaquetarlo ocupa más de cien veces su tamaño</translation>
    </message>
</context>
<context>
    <name>exchange.unset_stamps</name>
    <message>
        <source>lines left out because their time is 0: %1</source>
        <translation>líneas omitidas porque su tiempo es 0: %1</translation>
    </message>
</context>
<context>
    <name>exchange.unsure_left_out</name>
    <message>
        <source>%1 positions with a confidence below %2 count as not measured; the first is in line %3</source>
        <translation>%1 posiciones con una confianza inferior a %2 cuentan como no medidas; la primera está en la línea %3</translation>
    </message>
</context>
<context>
    <name>exchange.use_calibration_file</name>
    <message>
        <source>use a calibration file as ROS, OpenCV, Kalibr, anipose or PhotonVision writes it</source>
        <translation>use un archivo de calibración como los que escriben ROS, OpenCV, Kalibr, anipose o PhotonVision</translation>
    </message>
</context>
<context>
    <name>exchange.use_keys</name>
    <message>
        <source>use %1</source>
        <translation>use %1</translation>
    </message>
</context>
<context>
    <name>exchange.wait_for_writers</name>
    <message>
        <source>wait until no program writes to it, and try again</source>
        <translation>espere a que nadie escriba en él e inténtelo de nuevo</translation>
    </message>
</context>
<context>
    <name>exchange.write_class_and_team</name>
    <message>
        <source>write a line with class and team below the header</source>
        <translation>escriba bajo la cabecera una línea con clase y equipo</translation>
    </message>
</context>
<context>
    <name>exchange.write_decimal_point</name>
    <message>
        <source>write them with a decimal point</source>
        <translation>escríbalos con punto decimal</translation>
    </message>
</context>
<context>
    <name>exchange.write_digits</name>
    <message>
        <source>write it with digits, like 12.5</source>
        <translation>escríbalo con cifras, como 12.5</translation>
    </message>
</context>
<context>
    <name>exchange.write_digits_or_blank</name>
    <message>
        <source>write it with digits, like 12.5, or leave the cell blank</source>
        <translation>escríbalo con cifras, como 12.5, o deje el lugar en blanco</translation>
    </message>
</context>
<context>
    <name>exchange.write_finer_times</name>
    <message>
        <source>write the times with more digits, or give the frame rate of an even series</source>
        <translation>escriba los tiempos con más cifras o indique la frecuencia de imagen de una serie uniforme</translation>
    </message>
</context>
<context>
    <name>exchange.write_line_for_marker</name>
    <message>
        <source>write one line for each marker</source>
        <translation>escriba una línea por marcador</translation>
    </message>
</context>
<context>
    <name>exchange.write_object_with</name>
    <message>
        <source>write one with %1</source>
        <translation>escriba uno con %1</translation>
    </message>
</context>
<context>
    <name>exchange.write_task_as_shown</name>
    <message>
        <source>write the task as odograph task list --json shows one</source>
        <translation>cree la tarea en Banco, o escriba el archivo como lo muestra el manual</translation>
    </message>
</context>
<context>
    <name>exchange.write_tum_or_header</name>
    <message>
        <source>write %1, or begin the file with the line %2</source>
        <translation>escriba %1, o empiece el archivo con la línea %2</translation>
    </message>
</context>
<context>
    <name>exchange.write_value_for_each</name>
    <message>
        <source>write one value for each of %1</source>
        <translation>escriba un valor para cada uno de %1</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_number_of_cells</name>
    <message>
        <source>it has %1 cells instead of %2</source>
        <translation>tiene %1 celdas en lugar de %2</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_number_of_numbers</name>
    <message>
        <source>&apos;%1&apos; has %2 numbers instead of %3 × %4</source>
        <translation>&apos;%1&apos; tiene %2 números en lugar de %3 × %4</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_poles</name>
    <message>
        <source>&apos;poles&apos; is not a whole number from 1 to 100</source>
        <translation>&apos;poles&apos; no es un número entero de 1 a 100</translation>
    </message>
</context>
<context>
    <name>exchange.zone_given_twice</name>
    <message>
        <source>the zone has more than one shape</source>
        <translation>la zona se da dos veces</translation>
    </message>
</context>
<context>
    <name>exchange.zone_not_given</name>
    <message>
        <source>the zone has no shape</source>
        <translation>la zona no se da con nada</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_looked_at</name>
    <message>
        <source>it cannot be accessed (%1)</source>
        <translation>no se puede examinar (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_read</name>
    <message>
        <source>it cannot be read (%1)</source>
        <translation>no se puede leer (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_written</name>
    <message>
        <source>it cannot be written (%1)</source>
        <translation>no se puede escribir (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_write</name>
    <message>
        <source>cannot write &apos;%1&apos;</source>
        <translation>no se puede escribir &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>files.check_file_is_there</name>
    <message>
        <source>check that the file exists and that you may read it</source>
        <translation>compruebe que el archivo está ahí y se puede leer</translation>
    </message>
</context>
<context>
    <name>files.check_its_folder</name>
    <message>
        <source>check the free space and the permissions of its folder</source>
        <translation>compruebe el espacio libre y los permisos de su carpeta</translation>
    </message>
</context>
<context>
    <name>files.check_may_be_read</name>
    <message>
        <source>check that you may read the file</source>
        <translation>compruebe que puede leer el archivo</translation>
    </message>
</context>
<context>
    <name>files.check_name</name>
    <message>
        <source>check the name and the folder</source>
        <translation>compruebe el nombre y la carpeta</translation>
    </message>
</context>
<context>
    <name>files.choose_another_file</name>
    <message>
        <source>choose another file</source>
        <translation>elija otro archivo</translation>
    </message>
</context>
<context>
    <name>files.choose_another_folder</name>
    <message>
        <source>choose another folder</source>
        <translation>elija otra carpeta</translation>
    </message>
</context>
<context>
    <name>files.choose_another_name</name>
    <message>
        <source>choose another name</source>
        <translation>elija otro nombre</translation>
    </message>
</context>
<context>
    <name>files.choose_folder_with_room</name>
    <message>
        <source>choose a folder that you may write to and that has free space</source>
        <translation>elija una carpeta con espacio en la que pueda escribir</translation>
    </message>
</context>
<context>
    <name>files.choose_name_or_folder</name>
    <message>
        <source>choose another name or folder</source>
        <translation>elija otro nombre u otra carpeta</translation>
    </message>
</context>
<context>
    <name>files.choose_shorter_name</name>
    <message>
        <source>choose a shorter name</source>
        <translation>elija un nombre más corto</translation>
    </message>
</context>
<context>
    <name>files.choose_writable_folder</name>
    <message>
        <source>choose a folder that you may write to</source>
        <translation>elija una carpeta en la que pueda escribir</translation>
    </message>
</context>
<context>
    <name>files.disk_is_full</name>
    <message>
        <source>the disk is full</source>
        <translation>el disco está lleno</translation>
    </message>
</context>
<context>
    <name>files.file_is_empty</name>
    <message>
        <source>the file is empty</source>
        <translation>el archivo está vacío</translation>
    </message>
</context>
<context>
    <name>files.folder_cannot_be_used</name>
    <message>
        <source>its folder cannot be used (%1)</source>
        <translation>no se puede usar su carpeta (%1)</translation>
    </message>
</context>
<context>
    <name>files.folder_not_writable</name>
    <message>
        <source>the folder &apos;%1&apos; cannot be written to (%2)</source>
        <translation>no se puede escribir en la carpeta &apos;%1&apos; (%2)</translation>
    </message>
</context>
<context>
    <name>files.has_no_name</name>
    <message>
        <source>it has no name</source>
        <translation>no tiene nombre</translation>
    </message>
</context>
<context>
    <name>files.is_a_database</name>
    <message>
        <source>it is a database</source>
        <translation>es una base de datos</translation>
    </message>
</context>
<context>
    <name>files.is_another_project</name>
    <message>
        <source>it is another project</source>
        <translation>es otro proyecto</translation>
    </message>
</context>
<context>
    <name>files.is_beside_project</name>
    <message>
        <source>it is the log, the lock or a backup of a project</source>
        <translation>es el registro, el bloqueo o una copia de seguridad de un proyecto</translation>
    </message>
</context>
<context>
    <name>files.is_in_media_folder</name>
    <message>
        <source>it is in the media folder of project &apos;%1&apos;</source>
        <translation>está en la carpeta de medios del proyecto &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>files.is_in_some_media_folder</name>
    <message>
        <source>it is in a media folder beside a project</source>
        <translation>está en una carpeta de medios junto a un proyecto</translation>
    </message>
</context>
<context>
    <name>files.is_input</name>
    <message>
        <source>it is an input of the same command</source>
        <translation>es una entrada de la misma llamada</translation>
    </message>
</context>
<context>
    <name>files.is_of_another_kind</name>
    <message>
        <source>a file of another kind has that name</source>
        <translation>un archivo de otro tipo tiene ese nombre</translation>
    </message>
</context>
<context>
    <name>files.is_open_project</name>
    <message>
        <source>it is a project that is open here</source>
        <translation>es un proyecto que está abierto aquí</translation>
    </message>
</context>
<context>
    <name>files.is_temporary_name</name>
    <message>
        <source>Odograph uses such names for temporary files</source>
        <translation>Odograph usa esos nombres para archivos temporales</translation>
    </message>
</context>
<context>
    <name>files.is_the_project</name>
    <message>
        <source>it is the project itself</source>
        <translation>es el propio proyecto</translation>
    </message>
</context>
<context>
    <name>files.is_there_already</name>
    <message>
        <source>it already exists</source>
        <translation>ya existe</translation>
    </message>
</context>
<context>
    <name>files.log_left_beside</name>
    <message>
        <source>its folder has &apos;%1&apos;, the log or journal of another file of this name</source>
        <translation>su carpeta contiene «%1», el registro o diario de otro archivo con este nombre</translation>
    </message>
</context>
<context>
    <name>files.make_folder_first</name>
    <message>
        <source>create the folder first, or choose another one</source>
        <translation>cree antes la carpeta, o elija otra</translation>
    </message>
</context>
<context>
    <name>files.make_room</name>
    <message>
        <source>free some disk space and try again</source>
        <translation>libere espacio en el disco e inténtelo de nuevo</translation>
    </message>
</context>
<context>
    <name>files.move_log_away</name>
    <message>
        <source>choose another name, or move &apos;%1&apos; to another folder first</source>
        <translation>elija otro nombre o mueva antes «%1» a otra carpeta</translation>
    </message>
</context>
<context>
    <name>files.name_a_file</name>
    <message>
        <source>give a file name</source>
        <translation>indique un archivo</translation>
    </message>
</context>
<context>
    <name>files.name_too_long</name>
    <message>
        <source>its name is too long</source>
        <translation>su nombre es demasiado largo</translation>
    </message>
</context>
<context>
    <name>files.names_a_project</name>
    <message>
        <source>only projects have a name ending in .odo</source>
        <translation>un nombre que termina en .odo es para un proyecto</translation>
    </message>
</context>
<context>
    <name>files.no_such_file</name>
    <message>
        <source>the file does not exist</source>
        <translation>no existe ese archivo</translation>
    </message>
</context>
<context>
    <name>files.no_such_folder</name>
    <message>
        <source>folder &apos;%1&apos; does not exist</source>
        <translation>no existe la carpeta &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>files.replace_by_force</name>
    <message>
        <source>choose another name, or replace it with --force</source>
        <translation>elija otro nombre, o elimine antes el archivo</translation>
    </message>
</context>
<context>
    <name>files.unreadable</name>
    <message>
        <source>it cannot be read</source>
        <translation>no se puede leer</translation>
    </message>
</context>
<context>
    <name>geometry.add_points</name>
    <message>
        <source>add points</source>
        <translation>añada puntos</translation>
    </message>
</context>
<context>
    <name>geometry.at_one_place</name>
    <message>
        <source>%1 have the same position</source>
        <translation>%1 están en un mismo lugar</translation>
    </message>
</context>
<context>
    <name>geometry.at_one_place_in_picture</name>
    <message>
        <source>%1 have the same position in the image</source>
        <translation>%1 están en un mismo lugar de la imagen</translation>
    </message>
</context>
<context>
    <name>geometry.beyond_horizon</name>
    <message>
        <source>%1 would be beyond the horizon</source>
        <translation>%1 estaría más allá del horizonte</translation>
    </message>
</context>
<context>
    <name>geometry.bow_tie</name>
    <message>
        <source>the order of the points crosses over like a bow tie</source>
        <translation>el orden de los puntos se cruza como una pajarita</translation>
    </message>
</context>
<context>
    <name>geometry.calibrate_again</name>
    <message>
        <source>calibrate the camera again, or import another file</source>
        <translation>calibre la cámara de nuevo, o importe otro archivo</translation>
    </message>
</context>
<context>
    <name>geometry.check_points</name>
    <message>
        <source>check which point is which</source>
        <translation>compruebe qué punto es cuál</translation>
    </message>
</context>
<context>
    <name>geometry.coordinate_not_finite</name>
    <message>
        <source>a coordinate of %1 is not a finite number</source>
        <translation>una coordenada de %1 no es un número finito</translation>
    </message>
</context>
<context>
    <name>geometry.correct_it</name>
    <message>
        <source>correct it</source>
        <translation>corríjalo</translation>
    </message>
</context>
<context>
    <name>geometry.correct_one</name>
    <message>
        <source>correct one of them</source>
        <translation>corrija uno de ellos</translation>
    </message>
</context>
<context>
    <name>geometry.empty_chain</name>
    <message>
        <source>the chain has no links</source>
        <translation>la cadena no tiene eslabones</translation>
    </message>
</context>
<context>
    <name>geometry.focal_not_positive</name>
    <message>
        <source>the focal length %1 is not positive</source>
        <translation>la distancia focal %1 no es positiva</translation>
    </message>
</context>
<context>
    <name>geometry.four_points_needed</name>
    <message>
        <source>four points are needed, %1 given</source>
        <translation>hacen falta cuatro puntos, se dieron %1</translation>
    </message>
</context>
<context>
    <name>geometry.give_one_link</name>
    <message>
        <source>give at least one</source>
        <translation>dé al menos uno</translation>
    </message>
</context>
<context>
    <name>geometry.intrinsics_unusable</name>
    <message>
        <source>these intrinsics cannot be used</source>
        <translation>estos parámetros intrínsecos no se pueden usar</translation>
    </message>
</context>
<context>
    <name>geometry.no_homography</name>
    <message>
        <source>no homography</source>
        <translation>sin homografía</translation>
    </message>
</context>
<context>
    <name>geometry.on_one_line</name>
    <message>
        <source>%1 lie on one line</source>
        <translation>%1 están en una línea</translation>
    </message>
</context>
<context>
    <name>geometry.on_one_line_in_picture</name>
    <message>
        <source>%1 lie on one line in the image</source>
        <translation>%1 están en una línea de la imagen</translation>
    </message>
</context>
<context>
    <name>geometry.point</name>
    <message>
        <source>point %1</source>
        <translation>punto %1</translation>
    </message>
</context>
<context>
    <name>geometry.points_do_not_tell</name>
    <message>
        <source>the points do not determine it</source>
        <translation>los puntos no la determinan</translation>
    </message>
</context>
<context>
    <name>geometry.singular_link</name>
    <message>
        <source>link %1 of %2 of the chain is singular</source>
        <translation>el eslabón %1 de %2 de la cadena es singular</translation>
    </message>
</context>
<context>
    <name>geometry.size_not_positive</name>
    <message>
        <source>the image size %1 is not positive</source>
        <translation>el tamaño de imagen %1 no es positivo</translation>
    </message>
</context>
<context>
    <name>geometry.spread_points</name>
    <message>
        <source>spread the points</source>
        <translation>separe los puntos</translation>
    </message>
</context>
<context>
    <name>geometry.use_four_points</name>
    <message>
        <source>use four points of which no three are in line</source>
        <translation>use cuatro puntos de los que no haya tres en línea</translation>
    </message>
</context>
<context>
    <name>geometry.use_four_points_in_it</name>
    <message>
        <source>use four points in it of which no three are in line</source>
        <translation>use en él cuatro puntos de los que no haya tres en línea</translation>
    </message>
</context>
<context>
    <name>geometry.value_not_finite</name>
    <message>
        <source>one of the values is not a finite number</source>
        <translation>uno de los valores no es un número finito</translation>
    </message>
</context>
<context>
    <name>geometry.wrong_coefficients</name>
    <message>
        <source>this lens model does not take %1 distortion coefficients</source>
        <translation>%1 coeficientes de distorsión no corresponden a este modelo de lente</translation>
    </message>
</context>
<context>
    <name>geometry.wrong_covariance_size</name>
    <message>
        <source>the covariance has the wrong size</source>
        <translation>la covarianza tiene un tamaño incorrecto</translation>
    </message>
</context>
<context>
    <name>odo::AccuracyDialog</name>
    <message>
        <source>may hang &amp;over the floor</source>
        <translation>puede &amp;colgar sobre el suelo</translation>
    </message>
    <message>
        <source>&amp;Plan a camera</source>
        <translation>&amp;Planificar cámara</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>Find &amp;best position</source>
        <translation>&amp;Mejor lugar</translation>
    </message>
    <message>
        <source>Expected accuracy</source>
        <translation>Exactitud prevista</translation>
    </message>
    <message>
        <source>Expected accuracy in words</source>
        <translation>Exactitud prevista en palabras</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Qué está mal</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Cameras included</source>
        <translation>Cámaras que cuentan</translation>
    </message>
    <message>
        <source>All ticked cameras (joint)</source>
        <translation>Todas las cámaras marcadas juntas</translation>
    </message>
    <message>
        <source>The chosen camera alone</source>
        <translation>Solo la cámara elegida</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>M&amp;ostrar</translation>
    </message>
    <message>
        <source>Height of the robo&amp;t</source>
        <translation>Altura del &amp;robot</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>On a ceiling, for example; a tripod would be in the robots&apos; way</source>
        <translation>Como bajo un techo; un trípode estorbaría a los robots</translation>
    </message>
    <message>
        <source>Moves the camera to where it, together with the other ticked cameras, minimises the largest uncertainty on the floor</source>
        <translation>Pone la cámara donde, con las demás marcadas, mejor se conoce el peor lugar del suelo</translation>
    </message>
    <message>
        <source>Margin beyond the &amp;markers</source>
        <translation>Margen &amp;fuera de los marcadores</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>Cámara planificada</translation>
    </message>
    <message>
        <source>%1, registered %2</source>
        <translation>%1, registrada: %2</translation>
    </message>
    <message>
        <source>Planned %1</source>
        <translation>Planificada %1</translation>
    </message>
    <message>
        <source>%1: %2; %3.</source>
        <translation>%1: %2; %3.</translation>
    </message>
    <message>
        <source>Searching for the best position…</source>
        <translation>Buscando el mejor lugar…</translation>
    </message>
</context>
<context>
    <name>odo::BackupsDialog</name>
    <message>
        <source>What restoring would change</source>
        <translation>Qué cambiaría al restaurar</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>&amp;Back up now</source>
        <translation>&amp;Hacer copia ahora</translation>
    </message>
    <message>
        <source>&amp;Restore this backup</source>
        <translation>&amp;Restaurar esta copia</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Copias de seguridad</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>Carpeta de las copias</translation>
    </message>
    <message>
        <source>Backups are in %1. They contain everything except the videos.</source>
        <translation>Las copias están en %1. Contienen todo salvo los vídeos.</translation>
    </message>
    <message numerus="yes">
        <source>One is made each day on which you open the project, and kept for %n day(s).</source>
        <translation>
            <numerusform>Se hace una cada día que abre el proyecto y se conserva %n día.</numerusform>
            <numerusform>Se hace una cada día que abre el proyecto y se conserva %n días.</numerusform>
        </translation>
    </message>
    <message>
        <source>Daily backups are switched off in the preferences.</source>
        <translation>Las copias diarias están desactivadas en las preferencias.</translation>
    </message>
    <message>
        <source>&amp;Open folder</source>
        <translation>&amp;Abrir carpeta</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Changes since this backup</source>
        <translation>Cambios desde esta copia</translation>
    </message>
    <message>
        <source>%1, before an update</source>
        <translation>%1, antes de una actualización</translation>
    </message>
    <message>
        <source>No backup yet.</source>
        <translation>Aún no hay copias.</translation>
    </message>
    <message>
        <source>Reading the backup…</source>
        <translation>Leyendo la copia…</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) in this backup.</source>
        <translation>
            <numerusform>%n ensayo en esta copia.</numerusform>
            <numerusform>%n ensayos en esta copia.</numerusform>
        </translation>
    </message>
    <message>
        <source>Without: %1</source>
        <translation>Sin: %1</translation>
    </message>
    <message>
        <source>With, though deleted since: %1</source>
        <translation>Con, borrados después: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n of its video(s) no longer exist.</source>
        <translation>
            <numerusform>%n de sus vídeos ya no existe.</numerusform>
            <numerusform>%n de sus vídeos ya no existen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring it discards no changes.</source>
        <translation>Restaurarla no descarta ningún cambio.</translation>
    </message>
    <message numerus="yes">
        <source>Restoring it discards %n change(s) made since:</source>
        <translation>
            <numerusform>Restaurarla descarta %n cambio posterior:</numerusform>
            <numerusform>Restaurarla descarta %n cambios posteriores:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It brings back %n change(s).</source>
        <translation>
            <numerusform>Recupera %n cambio.</numerusform>
            <numerusform>Recupera %n cambios.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::Badge</name>
    <message>
        <source>not registered</source>
        <translation>sin registrar</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>movida %1</translation>
    </message>
    <message>
        <source>marker moved %1</source>
        <translation>marcador movido %1</translation>
    </message>
    <message>
        <source>markers not found</source>
        <translation>marcadores no encontrados</translation>
    </message>
</context>
<context>
    <name>odo::BoardCanvas</name>
    <message>
        <source>Image of the board</source>
        <translation>Imagen del tablero</translation>
    </message>
    <message>
        <source>residuals, longest %1 px</source>
        <translation>residuos, el mayor de %1 px</translation>
    </message>
</context>
<context>
    <name>odo::BoardImagesPage</name>
    <message>
        <source>Move it to the left of the image</source>
        <translation>Muévalo hacia la izquierda de la imagen</translation>
    </message>
    <message>
        <source>Move it to the right of the image</source>
        <translation>Muévalo hacia la derecha de la imagen</translation>
    </message>
    <message>
        <source>Move it up</source>
        <translation>Muévalo hacia arriba</translation>
    </message>
    <message>
        <source>Move it down</source>
        <translation>Muévalo hacia abajo</translation>
    </message>
    <message>
        <source>Closer to the camera</source>
        <translation>Más cerca de la cámara</translation>
    </message>
    <message>
        <source>Farther from the camera</source>
        <translation>Más lejos de la cámara</translation>
    </message>
    <message>
        <source>Tilt it: the left side away from the camera</source>
        <translation>Inclínelo: el lado izquierdo alejándose de la cámara</translation>
    </message>
    <message>
        <source>Tilt it: the right side away from the camera</source>
        <translation>Inclínelo: el lado derecho alejándose de la cámara</translation>
    </message>
    <message>
        <source>Tilt it: the upper side away from the camera</source>
        <translation>Inclínelo: el lado superior alejándose de la cámara</translation>
    </message>
    <message>
        <source>Tilt it: the lower side away from the camera</source>
        <translation>Inclínelo: el lado inferior alejándose de la cámara</translation>
    </message>
    <message>
        <source>Hold it still</source>
        <translation>Manténgalo quieto</translation>
    </message>
    <message>
        <source>&amp;Take an image now</source>
        <translation>&amp;Tomar imagen ahora</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Qué hacer</translation>
    </message>
    <message>
        <source>No image from the camera</source>
        <translation>Sin imagen de la cámara</translation>
    </message>
    <message>
        <source>Rejected images</source>
        <translation>Imágenes que no cuentan</translation>
    </message>
    <message>
        <source>Coverage of the images</source>
        <translation>Lo que cubren las imágenes</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>No cuentan</translation>
    </message>
    <message>
        <source>Waiting for the camera…</source>
        <translation>Esperando a la cámara…</translation>
    </message>
    <message>
        <source>Detecting the board…</source>
        <translation>Buscando el tablero…</translation>
    </message>
    <message>
        <source>Hold the board before the camera</source>
        <translation>Sostenga el tablero ante la cámara</translation>
    </message>
    <message>
        <source>Detecting the board</source>
        <translation>Buscando el tablero</translation>
    </message>
    <message>
        <source>Odograph takes an image whenever the board is still, sharp and in a new position.</source>
        <translation>Se toma una imagen automáticamente cada vez que el tablero está quieto, nítido y en un lugar nuevo.</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>Tomada</translation>
    </message>
    <message>
        <source>Now the dashed outline shows where the board would help most.</source>
        <translation>Ahora el contorno discontinuo muestra dónde sería más útil el tablero.</translation>
    </message>
    <message>
        <source>%1 to go</source>
        <translation>faltan %1</translation>
    </message>
    <message>
        <source>No image accepted</source>
        <translation>Ninguna imagen cuenta</translation>
    </message>
    <message>
        <source>See the reasons on the right. Drop other images here to add them.</source>
        <translation>Los motivos están a la derecha. Añada otras soltándolas aquí.</translation>
    </message>
    <message>
        <source>All images checked</source>
        <translation>Todas revisadas</translation>
    </message>
    <message>
        <source>They are enough.</source>
        <translation>Son suficientes.</translation>
    </message>
    <message>
        <source>Drop more images here; the bars show what is missing.</source>
        <translation>Se pueden soltar más imágenes aquí; las barras muestran lo que falta.</translation>
    </message>
</context>
<context>
    <name>odo::BoardSearchWorker</name>
    <message>
        <source>image %1</source>
        <translation>imagen %1</translation>
    </message>
    <message>
        <source>none of its images shows a board that is still, sharp and in a new position</source>
        <translation>en ninguna de sus imágenes hay un tablero quieto, nítido y nuevo</translation>
    </message>
    <message>
        <source>it cannot be read any more</source>
        <translation>ya no se puede leer</translation>
    </message>
</context>
<context>
    <name>odo::BoxCanvas</name>
    <message>
        <source>Video frame; arrow keys move the box round the robot, Shift + arrow keys resize it</source>
        <translation>Imagen; las flechas mueven el recuadro del robot, con Mayús cambian su tamaño</translation>
    </message>
</context>
<context>
    <name>odo::CalibrationResultPage</name>
    <message>
        <source>ordinary</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>wide (rational)</source>
        <translation>gran angular (racional)</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>ojo de pez</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 ± %2 px</source>
        <translation>%1 ± %2 px</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Calculando</translation>
    </message>
    <message>
        <source>Automatic choice of the lens model</source>
        <translation>Modelo de lente elegido automáticamente</translation>
    </message>
    <message>
        <source>Ordinary lens</source>
        <translation>Lente normal</translation>
    </message>
    <message>
        <source>Wide lens (rational model)</source>
        <translation>Gran angular (modelo racional)</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>Ojo de pez</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>Modelo de lente</translation>
    </message>
    <message>
        <source>Select a bar to see its image.</source>
        <translation>Elija una barra para ver su imagen.</translation>
    </message>
    <message>
        <source>Appears here after the calibration.</source>
        <translation>Aparece aquí cuando se conoce la lente.</translation>
    </message>
    <message>
        <source>Image and &amp;residuals</source>
        <translation>Imagen y &amp;residuos</translation>
    </message>
    <message>
        <source>&amp;Straightened</source>
        <translation>Sin &amp;distorsión</translation>
    </message>
    <message>
        <source>Error by image</source>
        <translation>Error por imagen</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Lente</translation>
    </message>
    <message>
        <source>Lens calibration</source>
        <translation>Lo que se sabe de la lente</translation>
    </message>
    <message>
        <source>Solving…</source>
        <translation>Calculando…</translation>
    </message>
    <message>
        <source>straight edges must be straight</source>
        <translation>los bordes rectos deben verse rectos</translation>
    </message>
    <message>
        <source>Storing the lens calibration and its images…</source>
        <translation>Guardando la lente y sus imágenes…</translation>
    </message>
    <message>
        <source>The lens calibration was not stored. %1</source>
        <translation>La lente no se guardó. %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Board error</source>
        <translation>Error del tablero</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>Error de validación</translation>
    </message>
    <message>
        <source>needs six images</source>
        <translation>requiere seis imágenes</translation>
    </message>
    <message>
        <source>Corners left out</source>
        <translation>Esquinas omitidas</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Distancia focal</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Centro x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Centro y</translation>
    </message>
    <message>
        <source>above the threshold</source>
        <translation>por encima del umbral</translation>
    </message>
    <message>
        <source>Images left out</source>
        <translation>Imágenes omitidas</translation>
    </message>
</context>
<context>
    <name>odo::CalibrationSourcePage</name>
    <message>
        <source>&amp;From the camera: hold up the board, Odograph takes the images</source>
        <translation>An&amp;te la cámara: sostenga el tablero y las imágenes se toman automáticamente</translation>
    </message>
    <message>
        <source>From existing images or a &amp;video</source>
        <translation>De &amp;imágenes o un video ya tomados</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Prin&amp;t a board…</source>
        <translation>Im&amp;primir tablero…</translation>
    </message>
    <message>
        <source>Show a flat calibration board from many sides to calibrate the lens. Odograph recognises checkerboard and ChArUco boards of any size. Measure one square on the paper: every later length depends on it. Do not refocus or zoom afterwards.</source>
        <translation>Un tablero plano de casillas, visto desde muchos lados, revela cómo proyecta la lente. De ajedrez o ChArUco, de cualquier tamaño: se reconoce automáticamente. Mida una casilla en el papel; de ella dependen todas las longitudes posteriores. Después no se debe cambiar el enfoque ni el zoom de la lente.</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>Cá&amp;mara</translation>
    </message>
    <message>
        <source>Side of a &amp;square, measured</source>
        <translation>Lado de una &amp;casilla, medido</translation>
    </message>
    <message>
        <source>Source of the board images</source>
        <translation>De dónde vienen las imágenes del tablero</translation>
    </message>
    <message>
        <source>Images and videos of the board</source>
        <translation>Imágenes y videos del tablero</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>Aña&amp;dir…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>You can also drop files here.</source>
        <translation>También se pueden soltar archivos aquí.</translation>
    </message>
    <message>
        <source>Name the camera, such as A.</source>
        <translation>Dé un nombre a la cámara, como A.</translation>
    </message>
    <message>
        <source>Connect a camera, or choose existing images.</source>
        <translation>Conecte una cámara o elija imágenes existentes.</translation>
    </message>
    <message>
        <source>Add images or a video of the board.</source>
        <translation>Añada imágenes o un vídeo del tablero.</translation>
    </message>
</context>
<context>
    <name>odo::CameraChoiceDialog</name>
    <message>
        <source>Cameras to record with</source>
        <translation>Cámaras para grabar</translation>
    </message>
    <message>
        <source>Device for camera %1</source>
        <translation>Dispositivo de la cámara %1</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Ajustes…</translation>
    </message>
    <message>
        <source>Settings of camera %1</source>
        <translation>Ajustes de la cámara %1</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>&amp;Search again</source>
        <translation>&amp;Buscar otra vez</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>Usar estas</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>no se usa</translation>
    </message>
    <message>
        <source>in use by another program</source>
        <translation>en uso por otro programa</translation>
    </message>
    <message>
        <source>%1 (not connected)</source>
        <translation>%1 (no conectada)</translation>
    </message>
    <message>
        <source>Searching for cameras…</source>
        <translation>Buscando cámaras…</translation>
    </message>
    <message>
        <source>Choose at least one camera. Two cameras locate a robot more accurately, and if one cannot see it, the other often can.</source>
        <translation>Elija al menos una cámara. Con dos se conoce mejor la posición de un robot, y también mientras una no lo ve.</translation>
    </message>
    <message>
        <source>You cannot use one device as two cameras.</source>
        <translation>Un dispositivo no puede ser dos cámaras.</translation>
    </message>
</context>
<context>
    <name>odo::CameraListModel</name>
    <message>
        <source>not calibrated</source>
        <translation>sin calibrar</translation>
    </message>
    <message>
        <source>calibrated, ±%1 px</source>
        <translation>calibrada, ±%1 px</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>sin registrar</translation>
    </message>
    <message>
        <source>registered, %1</source>
        <translation>registrada, %1</translation>
    </message>
    <message>
        <source>Calibrate the lens, then register the camera to the floor.</source>
        <translation>Calibre la lente y después registre la cámara respecto al suelo.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Lente</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
</context>
<context>
    <name>odo::CameraPositionDialog</name>
    <message>
        <source>moved %1</source>
        <translation>movida %1</translation>
    </message>
    <message>
        <source>marker moved %1</source>
        <translation>marcador movido %1</translation>
    </message>
    <message>
        <source>has not moved</source>
        <translation>no se ha movido</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>&amp;Comprobar</translation>
    </message>
    <message>
        <source>&amp;Register again…</source>
        <translation>&amp;Registrar de nuevo…</translation>
    </message>
    <message>
        <source>Check camera positions</source>
        <translation>Comprobar las cámaras</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>New image</source>
        <translation>Imagen nueva</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Registered cameras</source>
        <translation>Cámaras registradas</translation>
    </message>
    <message>
        <source>A camera that someone has pushed measures wrong positions without any sign of it. Before the robots run, check each camera&apos;s markers in a new image.</source>
        <translation>Una cámara que recibió un empujón mide mal y nada lo delata. Antes de los recorridos se vuelven a buscar los marcadores de cada cámara en una imagen nueva.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Results of the check</source>
        <translation>Lo que se encontró</translation>
    </message>
    <message>
        <source>New image of camera %1</source>
        <translation>Imagen nueva de la cámara %1</translation>
    </message>
    <message>
        <source>Its newest recording</source>
        <translation>Su última grabación</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Sin comprobar</translation>
    </message>
    <message>
        <source>An image or video…</source>
        <translation>Una imagen o un video…</translation>
    </message>
    <message>
        <source>detecting…</source>
        <translation>buscando…</translation>
    </message>
    <message>
        <source>undetermined</source>
        <translation>sin respuesta</translation>
    </message>
    <message>
        <source>At least two markers must be visible. The check changes nothing.</source>
        <translation>Deben verse al menos dos marcadores. La comprobación no mueve ni cambia nada.</translation>
    </message>
    <message>
        <source>&amp;Register %1 again…</source>
        <translation>&amp;Registrar %1 de nuevo…</translation>
    </message>
</context>
<context>
    <name>odo::CameraSettingsDialog</name>
    <message>
        <source>set by the camera</source>
        <translation>como lo tenga la cámara</translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation>fotogramas/s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Trigger each frame by software, at the same time for all cameras with this setting</source>
        <translation>Pedir cada imagen, para que todas estas cámaras capturen a la vez</translation>
    </message>
    <message>
        <source>Settings of %1</source>
        <translation>Ajustes de %1</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frecuencia</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposición</translation>
    </message>
    <message>
        <source>Software trigger</source>
        <translation>Disparo por software</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formato</translation>
    </message>
    <message>
        <source>&amp;Rate</source>
        <translation>&amp;Frecuencia</translation>
    </message>
    <message>
        <source>&amp;Exposure</source>
        <translation>&amp;Exposición</translation>
    </message>
    <message>
        <source>&amp;Trigger</source>
        <translation>&amp;Disparo</translation>
    </message>
    <message>
        <source>If the camera does not support a setting, a message says so when it opens.</source>
        <translation>Lo que la cámara no pueda hacer se indica al abrirla.</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>Usar estos</translation>
    </message>
    <message>
        <source>best for tracking</source>
        <translation>lo mejor para rastrear</translation>
    </message>
</context>
<context>
    <name>odo::CameraView</name>
    <message>
        <source>synchronised to %1 ms</source>
        <translation>sincronizada a %1 ms</translation>
    </message>
    <message>
        <source>manual offset</source>
        <translation>desfase a mano</translation>
    </message>
    <message>
        <source>not synchronised</source>
        <translation>sin sincronizar</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Camera image</source>
        <translation>Imagen de la cámara</translation>
    </message>
    <message>
        <source>Image of %1</source>
        <translation>Imagen de %1</translation>
    </message>
</context>
<context>
    <name>odo::ChangeModel</name>
    <message>
        <source>made</source>
        <translation>hecho</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>deshecho</translation>
    </message>
    <message>
        <source>redone</source>
        <translation>rehecho</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Cuándo</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Cómo</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
</context>
<context>
    <name>odo::ChangesDialog</name>
    <message>
        <source>Project changes</source>
        <translation>Cambios del proyecto</translation>
    </message>
    <message>
        <source>No changes yet.</source>
        <translation>Aún no se ha cambiado nada.</translation>
    </message>
    <message>
        <source>All changes made in this window and on the command line, newest first. The list includes recordings, imports and tracking, but you cannot undo them.</source>
        <translation>Lo que se cambió, en esta ventana y por la línea de comandos, lo más reciente primero. También constan grabaciones, importaciones y rastreos; no se pueden deshacer.</translation>
    </message>
    <message>
        <source>Search the changes…</source>
        <translation>Buscar en los cambios…</translation>
    </message>
    <message>
        <source>Search the changes</source>
        <translation>Buscar en los cambios</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Cambios</translation>
    </message>
</context>
<context>
    <name>odo::ChartImage</name>
    <message>
        <source>&amp;Copy as image</source>
        <translation>&amp;Copiar como imagen</translation>
    </message>
    <message>
        <source>&amp;Save as image…</source>
        <translation>&amp;Guardar como imagen…</translation>
    </message>
    <message>
        <source>SVG images (*.svg)</source>
        <translation>Imágenes SVG (*.svg)</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>Imágenes PNG (*.png)</translation>
    </message>
    <message>
        <source>Save as image</source>
        <translation>Guardar como imagen</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documentos PDF (*.pdf)</translation>
    </message>
</context>
<context>
    <name>odo::ChartSpan</name>
    <message>
        <source>Charts: show &amp;less</source>
        <translation>Gráficas: mostrar &amp;menos</translation>
    </message>
    <message>
        <source>Charts: show &amp;more</source>
        <translation>Gráficas: mostrar má&amp;s</translation>
    </message>
    <message>
        <source>Charts: show &amp;all</source>
        <translation>Gráficas: mostrar &amp;todo</translation>
    </message>
    <message>
        <source>Charts over &amp;distance</source>
        <translation>Gráficas según la &amp;distancia</translation>
    </message>
</context>
<context>
    <name>odo::CheckTools</name>
    <message>
        <source>&amp;Check camera positions…</source>
        <translation>&amp;Comprobar las cámaras…</translation>
    </message>
    <message>
        <source>Check camera positions…</source>
        <translation>Comprobar las cámaras…</translation>
    </message>
    <message>
        <source>Check before the robots run that no camera has moved since its registration</source>
        <translation>Mirar si cada cámara sigue donde se registró, antes de los recorridos</translation>
    </message>
    <message>
        <source>Check a known &amp;length…</source>
        <translation>Comprobar una &amp;longitud…</translation>
    </message>
    <message>
        <source>Check a known length…</source>
        <translation>Comprobar una longitud…</translation>
    </message>
    <message>
        <source>Measure an object of known length in a camera&apos;s image to check the camera&apos;s stated uncertainty</source>
        <translation>Medir algo de longitud conocida en la imagen de una cámara y ver si la cámara es tan buena como promete</translation>
    </message>
    <message>
        <source>&amp;Expected accuracy…</source>
        <translation>&amp;Exactitud prevista…</translation>
    </message>
    <message>
        <source>Accuracy…</source>
        <translation>Exactitud…</translation>
    </message>
    <message>
        <source>Show the expected uncertainty everywhere on the floor, also with planned cameras</source>
        <translation>Ver con qué exactitud se conocerá cada lugar del suelo, también con cámaras solo planificadas</translation>
    </message>
    <message>
        <source>&amp;Older calibrations…</source>
        <translation>Calibraciones &amp;anteriores…</translation>
    </message>
    <message>
        <source>Revisions…</source>
        <translation>Revisiones…</translation>
    </message>
    <message>
        <source>Show all calibrations and registrations of a camera, switch to an older one, reanalyse trials</source>
        <translation>Ver todas las calibraciones y registros de una cámara, volver a usar uno anterior, volver a medir ensayos</translation>
    </message>
    <message>
        <source>Cameras checked: see their badges.</source>
        <translation>Cámaras comprobadas: vea sus distintivos.</translation>
    </message>
    <message>
        <source>The chosen calibrations and analyses are now current.</source>
        <translation>Las calibraciones y los ensayos quedan como se eligió.</translation>
    </message>
</context>
<context>
    <name>odo::ClassActions</name>
    <message>
        <source>&amp;Tasks…</source>
        <translation>Tarea&amp;s…</translation>
    </message>
    <message>
        <source>C&amp;lasses and teams…</source>
        <translation>Clases &amp;y equipos…</translation>
    </message>
    <message>
        <source>R&amp;obots…</source>
        <translation>Ro&amp;bots…</translation>
    </message>
    <message>
        <source>Show &amp;standings…</source>
        <translation>Mostrar cla&amp;sificación…</translation>
    </message>
</context>
<context>
    <name>odo::ClassesDialog</name>
    <message>
        <source>&amp;New class…</source>
        <translation>&amp;Nueva clase…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Renombrar…</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>&amp;Archivar</translation>
    </message>
    <message>
        <source>Dele&amp;te</source>
        <translation>E&amp;liminar</translation>
    </message>
    <message>
        <source>New t&amp;eam…</source>
        <translation>Nuevo &amp;equipo…</translation>
    </message>
    <message>
        <source>&amp;Move to</source>
        <translation>&amp;Mover a</translation>
    </message>
    <message>
        <source>Members and r&amp;obots…</source>
        <translation>Miembros y r&amp;obots…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>El&amp;iminar</translation>
    </message>
    <message>
        <source>&amp;Import roster…</source>
        <translation>Im&amp;portar lista…</translation>
    </message>
    <message>
        <source>Classes and teams</source>
        <translation>Clases y equipos</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Lo que se hizo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Clases</translation>
    </message>
    <message>
        <source>Archiving hides a class: History, Record and the standings show its teams and trials only if you choose the class by name</source>
        <translation>Una clase archivada no estorba: Historial, Grabar y la clasificación muestran sus equipos y ensayos solo si allí se elige por su nombre</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>Seudónimo</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>Miembros</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Teams of the class</source>
        <translation>Equipos de la clase</translation>
    </message>
    <message>
        <source>Double-click or press F2 to change a name or a pseudonym</source>
        <translation>Doble clic o F2 cambia un nombre o un seudónimo</translation>
    </message>
    <message numerus="yes">
        <source>%1 (archived, %n team(s))</source>
        <translation>
            <numerusform>%1 (archivada, %n equipo)</numerusform>
            <numerusform>%1 (archivada, %n equipos)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n team(s))</source>
        <translation>
            <numerusform>%1 (%n equipo)</numerusform>
            <numerusform>%1 (%n equipos)</numerusform>
        </translation>
    </message>
    <message>
        <source>Teams without a class</source>
        <translation>Equipos sin clase</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>Des&amp;archivar</translation>
    </message>
    <message>
        <source>No class</source>
        <translation>Sin clase</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
    <message>
        <source>New class</source>
        <translation>Nueva clase</translation>
    </message>
    <message>
        <source>Rename class</source>
        <translation>Renombrar clase</translation>
    </message>
    <message>
        <source>New team</source>
        <translation>Nuevo equipo</translation>
    </message>
</context>
<context>
    <name>odo::CompareColumn</name>
    <message>
        <source>Time difference</source>
        <translation>Diferencia de tiempo</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Sectores</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Indicadores</translation>
    </message>
    <message>
        <source>Run compared with the first one</source>
        <translation>Recorrido que se muestra frente al primero</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Recorridos</translation>
    </message>
    <message>
        <source>Times from gate to gate</source>
        <translation>Tiempos de puerta a puerta</translation>
    </message>
    <message>
        <source>Metrics of both runs</source>
        <translation>Indicadores de ambos recorridos</translation>
    </message>
    <message>
        <source>s · drag the gates on the map</source>
        <translation>s · arrastre las puertas en el mapa</translation>
    </message>
    <message>
        <source>grey: not significant</source>
        <translation>gris: dentro del error</translation>
    </message>
    <message>
        <source>of</source>
        <translation>de</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>Behind at finish</source>
        <translation>Más tarde al final</translation>
    </message>
    <message>
        <source>Ahead at finish</source>
        <translation>Antes al final</translation>
    </message>
    <message>
        <source>Gap at finish</source>
        <translation>Al final</translation>
    </message>
    <message>
        <source>Behind at cursor</source>
        <translation>Más tarde aquí</translation>
    </message>
    <message>
        <source>Ahead at cursor</source>
        <translation>Antes aquí</translation>
    </message>
    <message>
        <source>Gap at cursor</source>
        <translation>Aquí</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
</context>
<context>
    <name>odo::CompareDesk</name>
    <message>
        <source>Top-down map</source>
        <translation>Mapa en planta</translation>
    </message>
    <message>
        <source>Floor map with the paths of the runs and the gates of the sectors</source>
        <translation>Mapa del suelo con los caminos de los recorridos y las puertas de los sectores</translation>
    </message>
    <message>
        <source>Drag a gate along the path. Keys: Up and Down select a gate, Left and Right move it</source>
        <translation>Arrastre una puerta a lo largo del camino; con el teclado: Arriba y Abajo eligen una, Izquierda y Derecha la mueven</translation>
    </message>
    <message>
        <source>both runs</source>
        <translation>ambos recorridos</translation>
    </message>
    <message>
        <source>Camera of the first run</source>
        <translation>Cámara del primer recorrido</translation>
    </message>
    <message>
        <source>Camera of the second run</source>
        <translation>Cámara del segundo recorrido</translation>
    </message>
    <message>
        <source>dashed: the task&apos;s path</source>
        <translation>discontinua: la trayectoria de la tarea</translation>
    </message>
    <message>
        <source>along the first run&apos;s path</source>
        <translation>a lo largo del camino del primer recorrido</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Primero</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Segundo</translation>
    </message>
</context>
<context>
    <name>odo::ComparePage</name>
    <message>
        <source>These runs cannot be compared</source>
        <translation>Estos recorridos no se pueden comparar</translation>
    </message>
    <message>
        <source>%1. What to do: %2.</source>
        <translation>%1. Qué hacer: %2.</translation>
    </message>
    <message>
        <source>Select two runs</source>
        <translation>Hacen falta dos recorridos</translation>
    </message>
    <message>
        <source>A comparison shows where one run is faster than the other, and whether the difference is significant. Select two tracked trials, or import another one.</source>
        <translation>La comparación muestra dónde un recorrido es más rápido que otro y si eso es más que el error. Elija dos ensayos ya rastreados o importe otro.</translation>
    </message>
    <message>
        <source>Import trial from videos…</source>
        <translation>Importar ensayo de videos…</translation>
    </message>
</context>
<context>
    <name>odo::ConflictDialog</name>
    <message>
        <source>Changed here and elsewhere</source>
        <translation>Cambiado aquí y en otro lugar</translation>
    </message>
    <message>
        <source>You and another bench changed these. Nothing is lost: the hub keeps the version that is not in force. To bring a value back, enter it here again.</source>
        <translation>Usted y otro puesto han cambiado esto. No se pierde nada: el servidor conserva la versión que no está en vigor. Para recuperar un valor, introdúzcalo aquí de nuevo.</translation>
    </message>
    <message>
        <source>What was changed twice</source>
        <translation>Lo que se cambió dos veces</translation>
    </message>
    <message>
        <source>Values that differ</source>
        <translation>Valores que difieren</translation>
    </message>
    <message>
        <source>&amp;Remove all from this list</source>
        <translation>&amp;Quitar todos de la lista</translation>
    </message>
    <message>
        <source>The version of this project is in force.</source>
        <translation>Está en vigor la versión de este proyecto.</translation>
    </message>
    <message>
        <source>The version of the hub is in force. It comes with the next “Pull”.</source>
        <translation>Está en vigor la versión del servidor. Llegará con el próximo «Recibir».</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>In this project</source>
        <translation>En este proyecto</translation>
    </message>
    <message>
        <source>At the hub</source>
        <translation>En el servidor</translation>
    </message>
</context>
<context>
    <name>odo::ConnectForm</name>
    <message>
        <source>Odograph keeps it until you close the program, and writes it nowhere</source>
        <translation>Odograph la recuerda hasta que cierre el programa y no la guarda en ningún sitio</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Contraseña</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Examinar…</translation>
    </message>
    <message>
        <source>C&amp;onnect</source>
        <translation>Co&amp;nectar</translation>
    </message>
    <message>
        <source>Connect this project to the school&apos;s hub. Odograph sends its trials, tasks and class lists there, and you receive those of the other benches. You can measure without the network; Odograph sends later what it could not send.</source>
        <translation>Conecte este proyecto con el servidor de la escuela. Odograph envía allí sus ensayos, tareas y listas de clase, y usted recibe los de los otros puestos. Puede medir sin red; Odograph envía más tarde lo que no pudo enviar.</translation>
    </message>
    <message>
        <source>Address of the hub</source>
        <translation>Dirección del servidor</translation>
    </message>
    <message>
        <source>empty: as in ~/.pgpass or PGPASSWORD</source>
        <translation>vacía: la de ~/.pgpass o PGPASSWORD</translation>
    </message>
    <message>
        <source>optional: a folder that all benches can reach</source>
        <translation>opcional: una carpeta accesible para todos los puestos</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>Carpeta de grabaciones</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>Examinar: %1</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Dirección:</translation>
    </message>
    <message>
        <source>&amp;Password:</source>
        <translation>&amp;Contraseña:</translation>
    </message>
    <message>
        <source>&amp;Recordings:</source>
        <translation>&amp;Grabaciones:</translation>
    </message>
    <message>
        <source>postgresql://bench1@hub.school.example/school</source>
        <translation>postgresql://puesto1@servidor.escuela.example/escuela</translation>
    </message>
</context>
<context>
    <name>odo::CoveragePanel</name>
    <message>
        <source>Across</source>
        <translation>Horizontal</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Cercanía</translation>
    </message>
    <message>
        <source>Tilted</source>
        <translation>Inclinación</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Cobertura</translation>
    </message>
    <message>
        <source>%1 images: enough. More do no harm.</source>
        <translation>%1 imágenes: suficientes. Más no estorban.</translation>
    </message>
    <message>
        <source>1 image; take ten or more.</source>
        <translation>1 imagen; hacen falta diez o más.</translation>
    </message>
    <message>
        <source>%1 images; take ten or more.</source>
        <translation>%1 imágenes; hacen falta diez o más.</translation>
    </message>
</context>
<context>
    <name>odo::CrashNotice</name>
    <message>
        <source>Odograph ended unexpectedly</source>
        <translation>Odograph terminó de forma inesperada</translation>
    </message>
    <message>
        <source>Odograph crashed the last time. Saved data is safe. If a recording was cut off, open its project to recover it up to the last second.</source>
        <translation>La última vez, Odograph terminó por un fallo propio. Lo guardado está a salvo. Una grabación interrumpida se conserva hasta su último segundo en cuanto se vuelve a abrir su proyecto.</translation>
    </message>
    <message>
        <source>Odograph crashed the last time. Saved data is safe.</source>
        <translation>La última vez, Odograph terminó por un fallo propio. Lo guardado está a salvo.</translation>
    </message>
    <message>
        <source>Project:</source>
        <translation>Proyecto:</translation>
    </message>
    <message>
        <source>Report:</source>
        <translation>Informe:</translation>
    </message>
    <message>
        <source>&amp;Open the project</source>
        <translation>&amp;Abrir el proyecto</translation>
    </message>
</context>
<context>
    <name>odo::DifferenceModel</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>begin</source>
        <translation>inicio</translation>
    </message>
    <message>
        <source>end</source>
        <translation>fin</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>Only one of the two runs has it</source>
        <translation>Solo uno de los dos lo tiene</translation>
    </message>
    <message>
        <source>%1: significant (95 %)</source>
        <translation>%1: mayor que el error (95 %)</translation>
    </message>
    <message>
        <source>%1: not significant (95 %)</source>
        <translation>%1: dentro del error (95 %), no se puede afirmar ninguna diferencia</translation>
    </message>
    <message>
        <source>significant</source>
        <translation>mayor que el error</translation>
    </message>
    <message>
        <source>not significant</source>
        <translation>dentro del error</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
</context>
<context>
    <name>odo::DistanceChart</name>
    <message>
        <source>Speed over distance</source>
        <translation>Velocidad a lo largo del camino</translation>
    </message>
    <message>
        <source>Time difference over distance</source>
        <translation>Diferencia de tiempo a lo largo del camino</translation>
    </message>
    <message>
        <source>%1 · smoothed ±95 %</source>
        <translation>%1 · suavizada ±95 %</translation>
    </message>
    <message>
        <source>s · above 0: %2 is later than %1 · ±95 % · grey: not significant</source>
        <translation>s · por encima de 0: %2 llega más tarde que %1 · ±95 % · gris: dentro del error</translation>
    </message>
    <message>
        <source>s · above 0: later than %1 · ±95 % · grey: not significant</source>
        <translation>s · por encima de 0: más tarde que %1 · ±95 % · gris: dentro del error</translation>
    </message>
</context>
<context>
    <name>odo::DockGrip</name>
    <message>
        <source>Drag to move, double-click to float</source>
        <translation>Arrastrar para mover; doble clic para desacoplar</translation>
    </message>
</context>
<context>
    <name>odo::DoctorDialog</name>
    <message>
        <source>good</source>
        <translation>bien</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>advertencia</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>mal</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>se desconoce</translation>
    </message>
    <message>
        <source>Set-up doctor</source>
        <translation>Diagnóstico del montaje</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Lo que se encontró</translation>
    </message>
    <message>
        <source>&amp;Check again</source>
        <translation>&amp;Revisar otra vez</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Revisando…</translation>
    </message>
    <message>
        <source>. What to do: %1.</source>
        <translation>. Qué hacer: %1.</translation>
    </message>
    <message>
        <source>Found nothing that would disturb a recording.</source>
        <translation>No se encontró nada que perturbe una grabación.</translation>
    </message>
    <message>
        <source>Found one problem.</source>
        <translation>Hay un punto que revisar.</translation>
    </message>
    <message>
        <source>Found %1 problems, the worst first.</source>
        <translation>Hay %1 puntos que revisar, el peor primero.</translation>
    </message>
</context>
<context>
    <name>odo::EditTrialDialog</name>
    <message>
        <source>Robots in the trial</source>
        <translation>Robots del ensayo</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>Editar %1</translation>
    </message>
    <message numerus="yes">
        <source>Edit %n trial(s)</source>
        <translation>
            <numerusform>Editar %n ensayo</numerusform>
            <numerusform>Editar %n ensayos</numerusform>
        </translation>
    </message>
    <message>
        <source>Why it was not changed</source>
        <translation>Por qué no se cambió</translation>
    </message>
    <message>
        <source>&amp;Change</source>
        <translation>Ca&amp;mbiar</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>T&amp;eam</source>
        <translation>&amp;Equipo</translation>
    </message>
    <message>
        <source>C&amp;lass</source>
        <translation>C&amp;lase</translation>
    </message>
    <message>
        <source>&amp;Date and time</source>
        <translation>&amp;Fecha y hora</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>&amp;Tarea</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>R&amp;obots</translation>
    </message>
    <message>
        <source>separated by commas</source>
        <translation>separadas por comas</translation>
    </message>
    <message>
        <source>Ta&amp;gs</source>
        <translation>Eti&amp;quetas</translation>
    </message>
    <message>
        <source>Note&amp;s</source>
        <translation>Not&amp;as</translation>
    </message>
    <message>
        <source>&amp;Variables</source>
        <translation>&amp;Variables</translation>
    </message>
    <message>
        <source>&amp;Remove variable</source>
        <translation>El&amp;iminar variable</translation>
    </message>
    <message>
        <source>The variable %1 is in the table twice. Remove one of the rows.</source>
        <translation>La variable %1 está dos veces en la tabla. Elimine una de las filas.</translation>
    </message>
</context>
<context>
    <name>odo::ExportDialog</name>
    <message>
        <source>&amp;Keep as…</source>
        <translation>&amp;Conservar como…</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>&amp;Preajuste</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>&amp;Robot</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formato</translation>
    </message>
    <message>
        <source>CSV for programs (*.csv)</source>
        <translation>CSV para programas (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1.5 (*.csv)</source>
        <translation>CSV para hojas de cálculo, 1.5 (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1,5 (*.csv)</source>
        <translation>CSV para hojas de cálculo, 1,5 (*.csv)</translation>
    </message>
    <message>
        <source>Tracker text (*.txt)</source>
        <translation>Texto de Tracker (*.txt)</translation>
    </message>
    <message>
        <source>TUM trajectory (*.tum)</source>
        <translation>Trayectoria TUM (*.tum)</translation>
    </message>
    <message>
        <source>Page to take along (*.html)</source>
        <translation>Página para llevar (*.html)</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Columnas</translation>
    </message>
    <message>
        <source>&amp;Columns</source>
        <translation>C&amp;olumnas</translation>
    </message>
    <message>
        <source>&amp;Lengths in</source>
        <translation>&amp;Longitudes en</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>&amp;Ejes</translation>
    </message>
    <message>
        <source>Of the floor&apos;s markers</source>
        <translation>De los marcadores del suelo</translation>
    </message>
    <message>
        <source>From the start, X in its direction</source>
        <translation>Desde la salida, X en su dirección</translation>
    </message>
    <message>
        <source>Par&amp;t of the run</source>
        <translation>Par&amp;te del recorrido</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Elegir un archivo…</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>Elegir una carpeta…</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>Its range, which counts</source>
        <translation>Su tramo, que cuenta</translation>
    </message>
    <message>
        <source>The whole run</source>
        <translation>Todo el recorrido</translation>
    </message>
    <message>
        <source>What counts of each</source>
        <translation>Lo que cuenta de cada uno</translation>
    </message>
    <message>
        <source>The selection, %1 to %2</source>
        <translation>La selección, de %1 a %2</translation>
    </message>
    <message>
        <source>As last time</source>
        <translation>Como la última vez</translation>
    </message>
    <message>
        <source>Keep these choices</source>
        <translation>Conservar estas opciones</translation>
    </message>
    <message>
        <source>Name of the preset:</source>
        <translation>Nombre del preajuste:</translation>
    </message>
</context>
<context>
    <name>odo::FileActions</name>
    <message>
        <source>&amp;New project…</source>
        <translation>&amp;Nuevo proyecto…</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>&amp;Abrir proyecto…</translation>
    </message>
    <message>
        <source>Open &amp;demo lesson…</source>
        <translation>Abrir lección &amp;demo…</translation>
    </message>
    <message>
        <source>Save a &amp;copy as…</source>
        <translation>Guardar &amp;copia como…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Vaciar esta lista</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Nuevo proyecto</translation>
    </message>
    <message>
        <source>Project.odo</source>
        <translation>Proyecto.odo</translation>
    </message>
    <message>
        <source>Odograph projects (*.odo)</source>
        <translation>Proyectos de Odograph (*.odo)</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Abrir proyecto</translation>
    </message>
    <message>
        <source>Odograph projects (*.odo);;All files (*)</source>
        <translation>Proyectos de Odograph (*.odo);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Choose a folder for the demo lesson</source>
        <translation>¿Dónde crear la lección demo?</translation>
    </message>
    <message>
        <source>Odograph demo</source>
        <translation>Demo de Odograph</translation>
    </message>
    <message>
        <source>Copy of %1</source>
        <translation>Copia de %1</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Guardar copia</translation>
    </message>
    <message>
        <source>Copy saved as %1. Its videos stay where they are.</source>
        <translation>Se guardó una copia como %1. Sus videos quedan donde están.</translation>
    </message>
    <message>
        <source>New project from t&amp;his one…</source>
        <translation>Proyecto nuevo a partir de e&amp;ste…</translation>
    </message>
    <message>
        <source>With its cameras, marker layouts, robots and tasks, without people and trials</source>
        <translation>Con sus cámaras, planos de marcadores, robots y tareas, sin personas ni ensayos</translation>
    </message>
    <message>
        <source>Open demo lesson</source>
        <translation>Abrir lección demo</translation>
    </message>
    <message>
        <source>A demo lesson is in %1.</source>
        <translation>Hay una lección demo en %1.</translation>
    </message>
    <message>
        <source>&amp;Open it</source>
        <translation>&amp;Abrirla</translation>
    </message>
    <message>
        <source>&amp;Create another…</source>
        <translation>&amp;Crear otra…</translation>
    </message>
    <message>
        <source>&amp;Backups…</source>
        <translation>Copias de se&amp;guridad…</translation>
    </message>
</context>
<context>
    <name>odo::FilmStrip</name>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Accepted images</source>
        <translation>Imágenes que cuentan</translation>
    </message>
</context>
<context>
    <name>odo::FloorCopy</name>
    <message>
        <source>&amp;Copy floor position</source>
        <translation>&amp;Copiar la posición en el suelo</translation>
    </message>
</context>
<context>
    <name>odo::FloorMap</name>
    <message>
        <source>Top-down map</source>
        <translation>Mapa en planta</translation>
    </message>
    <message>
        <source>Map: &amp;views&apos; disagreement</source>
        <translation>Mapa: discrepancia entre &amp;vistas</translation>
    </message>
    <message>
        <source>Floor map with the robots&apos; trails</source>
        <translation>Mapa del suelo con las estelas de los robots</translation>
    </message>
    <message>
        <source>Colour of the trails on the map</source>
        <translation>Qué colorea las estelas del mapa</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Disagreement</source>
        <translation>Discrepancia</translation>
    </message>
    <message>
        <source>Disagreement of the views: %1</source>
        <translation>Discrepancia entre vistas: %1</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>color</translation>
    </message>
</context>
<context>
    <name>odo::FloorReadOut</name>
    <message>
        <source>x %1 · y %2</source>
        <translation>x %1 · y %2</translation>
    </message>
    <message>
        <source>Not on the floor</source>
        <translation>No está en el suelo</translation>
    </message>
    <message>
        <source>u %1 · v %2 px</source>
        <translation>u %1 · v %2 px</translation>
    </message>
</context>
<context>
    <name>odo::FloorSketch</name>
    <message>
        <source>Sketch of the testbed from above</source>
        <translation>Croquis del banco de pruebas visto desde arriba</translation>
    </message>
    <message>
        <source>%1 markers, %2 cameras</source>
        <translation>%1 marcadores, %2 cámaras</translation>
    </message>
    <message>
        <source>%1, %2 m high</source>
        <translation>%1, a %2 m de altura</translation>
    </message>
    <message>
        <source>This sketch shows markers and cameras once the testbed has a layout or a registered camera.</source>
        <translation>Los marcadores y las cámaras se dibujan aquí en cuanto hay un plano o una cámara registrada.</translation>
    </message>
    <message>
        <source>grid %1 m</source>
        <translation>cuadrícula de %1 m</translation>
    </message>
</context>
<context>
    <name>odo::FloorSourcePage</name>
    <message>
        <source>Image or video of the markers</source>
        <translation>Imagen o video de los marcadores</translation>
    </message>
    <message>
        <source>Markers with known floor positions determine the camera position. Four are enough; a fifth checks them. Do not move the camera afterwards.</source>
        <translation>Los marcadores cuyos lugares en el suelo se conocen indican dónde está la cámara. Bastan cuatro; un quinto los comprueba. Después no se debe mover la cámara.</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>Cá&amp;mara</translation>
    </message>
    <message>
        <source>Marker &amp;layout</source>
        <translation>&amp;Plano de marcadores</translation>
    </message>
    <message>
        <source>Image of the markers</source>
        <translation>Dónde se ven los marcadores</translation>
    </message>
    <message>
        <source>Its lens is calibrated.</source>
        <translation>Su lente está medida.</translation>
    </message>
    <message>
        <source>Its lens is not calibrated. Odograph estimates it from the markers, as far as they determine it.</source>
        <translation>Su objetivo no está calibrado. Odograph lo estima a partir de los marcadores, hasta donde estos lo determinan.</translation>
    </message>
    <message>
        <source>Name the camera, such as A.</source>
        <translation>Dé un nombre a la cámara, como A.</translation>
    </message>
    <message>
        <source>Add a marker layout first.</source>
        <translation>Añada primero un plano de marcadores.</translation>
    </message>
    <message>
        <source>Choose an image or a video of the markers.</source>
        <translation>Elija una imagen o un vídeo de los marcadores.</translation>
    </message>
</context>
<context>
    <name>odo::FloorWizard</name>
    <message>
        <source>Register camera to the floor</source>
        <translation>Registrar cámara respecto al suelo</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>The camera and its markers</source>
        <translation>La cámara y sus marcadores</translation>
    </message>
    <message>
        <source>The markers in the image</source>
        <translation>Los marcadores en la imagen</translation>
    </message>
    <message>
        <source>Detecting the markers…</source>
        <translation>Buscando los marcadores…</translation>
    </message>
    <message>
        <source>There is no registration to save yet.</source>
        <translation>Aún no hay ningún registro que guardar.</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>el registro</translation>
    </message>
</context>
<context>
    <name>odo::FrameAligner</name>
    <message>
        <source>&amp;Move both frames together</source>
        <translation>&amp;Mover ambos fotogramas a la vez</translation>
    </message>
    <message>
        <source>Together they show what is now taken for the same moment. Remove the tick, and move one frame until both show the same moment, such as a wheel that begins to turn.</source>
        <translation>Juntos muestran lo que ahora se toma por el mismo momento. Quite la marca y mueva un fotograma hasta que ambos muestren el mismo momento, por ejemplo una rueda que empieza a girar.</translation>
    </message>
</context>
<context>
    <name>odo::FramePanel</name>
    <message>
        <source>Frame of camera %1</source>
        <translation>Fotograma de la cámara %1</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>%1: frame %2, %3</source>
        <translation>%1: fotograma %2, %3</translation>
    </message>
</context>
<context>
    <name>odo::GateTable</name>
    <message>
        <source>start</source>
        <translation>salida</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>meta</translation>
    </message>
    <message>
        <source>start and finish</source>
        <translation>salida y meta</translation>
    </message>
    <message>
        <source>split</source>
        <translation>parcial</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>Reverse directi&amp;on</source>
        <translation>O&amp;tro sentido</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Puerta</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>x₁, mm</source>
        <translation>x₁, mm</translation>
    </message>
    <message>
        <source>y₁, mm</source>
        <translation>y₁, mm</translation>
    </message>
    <message>
        <source>x₂, mm</source>
        <translation>x₂, mm</translation>
    </message>
    <message>
        <source>y₂, mm</source>
        <translation>y₂, mm</translation>
    </message>
    <message>
        <source>Gates in passing order</source>
        <translation>Puertas en el orden en que se pasan</translation>
    </message>
    <message>
        <source>&amp;Add gate</source>
        <translation>Añadi&amp;r puerta</translation>
    </message>
    <message>
        <source>Robots pass the selected gate the other way</source>
        <translation>La puerta elegida se pasa en el otro sentido</translation>
    </message>
    <message>
        <source>Role of the gate</source>
        <translation>Función de la puerta</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>Parcial %1</translation>
    </message>
</context>
<context>
    <name>odo::GeneralPage</name>
    <message>
        <source>Restart Odograph to see the change.</source>
        <translation>Odograph lo muestra cuando se inicia de nuevo.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>&amp;Units of results</source>
        <translation>&amp;Unidades de resultados</translation>
    </message>
    <message>
        <source>Floors and targets always use millimetres, as printed. Exported files use the units of their format.</source>
        <translation>Los suelos y los patrones se definen en milímetros, tal como se imprimen. Los archivos exportados llevan las unidades que pide su formato.</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>T&amp;ema</translation>
    </message>
    <message>
        <source>&amp;Colours of maps</source>
        <translation>&amp;Colores de los mapas</translation>
    </message>
    <message>
        <source>Both remain readable for people with red-green colour blindness and in black-and-white prints.</source>
        <translation>Ambas escalas las distinguen las personas que no ven el rojo o el verde, y también valen en una impresión sin colores.</translation>
    </message>
    <message>
        <source>Units of results</source>
        <translation>Unidades de resultados</translation>
    </message>
    <message>
        <source>Millimetres and metres: mm, m, m/s</source>
        <translation>Milímetros y metros: mm, m, m/s</translation>
    </message>
    <message>
        <source>Centimetres: cm, cm/s</source>
        <translation>Centímetros: cm, cm/s</translation>
    </message>
    <message>
        <source>Inches and feet: in, ft, ft/s</source>
        <translation>Pulgadas y pies: in, ft, ft/s</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>As set on the computer</source>
        <translation>Como el equipo</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>As set on the desktop</source>
        <translation>Como el escritorio</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Colours of maps</source>
        <translation>Colores de los mapas</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>&amp;Back up a project on each day you open it</source>
        <translation>Hacer una co&amp;pia del proyecto cada día que se abre</translation>
    </message>
    <message>
        <source>&amp;Days to keep backups</source>
        <translation>&amp;Días que se conservan</translation>
    </message>
    <message>
        <source>Backups are beside the project and contain everything except the videos: File ▸ Backups… shows and restores them.</source>
        <translation>Las copias están junto al proyecto y contienen todo salvo los vídeos: Archivo ▸ Copias de seguridad… las muestra y restaura.</translation>
    </message>
</context>
<context>
    <name>odo::GuidanceTool</name>
    <message>
        <source>&amp;Ignore an area</source>
        <translation>&amp;Ignorar una zona</translation>
    </message>
    <message>
        <source>Draw an area of a view to ignore, such as a mirror or a screen: click its corners, then press Enter</source>
        <translation>Dibujar una zona de una vista que se ignora, como un espejo o una pantalla: haga clic en sus esquinas y pulse Intro</translation>
    </message>
    <message>
        <source>Search only an &amp;area</source>
        <translation>Buscar solo en un&amp;a zona</translation>
    </message>
    <message>
        <source>Draw the area of a view in which robots are searched: click its corners, then press Enter</source>
        <translation>Dibujar la zona de una vista en la que se buscan robots: haga clic en sus esquinas y pulse Intro</translation>
    </message>
    <message>
        <source>&amp;Remove all areas</source>
        <translation>&amp;Quitar todas las zonas</translation>
    </message>
    <message>
        <source>Remove all areas of this trial</source>
        <translation>Quitar todas las zonas de este ensayo</translation>
    </message>
    <message>
        <source>Remove this ignored area</source>
        <translation>Quitar esta zona ignorada</translation>
    </message>
    <message>
        <source>Remove this search area</source>
        <translation>Quitar esta zona de búsqueda</translation>
    </message>
    <message>
        <source>Set %1 here by hand…</source>
        <translation>Poner %1 aquí a mano…</translation>
    </message>
    <message>
        <source>%1 is not visible here in the selected time</source>
        <translation>%1 no es visible aquí en el tiempo seleccionado</translation>
    </message>
    <message>
        <source>%1 is not visible in any view in the selected time</source>
        <translation>%1 no es visible en ninguna vista en el tiempo seleccionado</translation>
    </message>
    <message>
        <source>Remove the point set by hand</source>
        <translation>Quitar el punto puesto a mano</translation>
    </message>
    <message>
        <source>It is visible after all</source>
        <translation>Sí es visible</translation>
    </message>
    <message>
        <source>Set a point by hand</source>
        <translation>Poner un punto a mano</translation>
    </message>
    <message>
        <source>Uncertainty σ of this point, pixels:</source>
        <translation>Incertidumbre σ de este punto, píxeles:</translation>
    </message>
</context>
<context>
    <name>odo::HelpActions</name>
    <message>
        <source>&amp;Help on this page</source>
        <translation>&amp;Ayuda de esta página</translation>
    </message>
    <message>
        <source>&amp;First lesson</source>
        <translation>&amp;Primera lección</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>A&amp;tajos</translation>
    </message>
    <message>
        <source>&amp;About Odograph</source>
        <translation>Acerca &amp;de Odograph</translation>
    </message>
</context>
<context>
    <name>odo::HelpPanel</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Close the help (F1)</source>
        <translation>Cerrar la ayuda (F1)</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>Cerrar la ayuda</translation>
    </message>
    <message>
        <source>Help on this page</source>
        <translation>Ayuda de esta página</translation>
    </message>
</context>
<context>
    <name>odo::HistoryActions</name>
    <message>
        <source>Import &amp;roster…</source>
        <translation>Importar lis&amp;ta…</translation>
    </message>
    <message>
        <source>Show project &amp;changes…</source>
        <translation>&amp;Cambios del proyecto…</translation>
    </message>
    <message>
        <source>Import a roster: a table with the columns class, team and optionally pseudonym</source>
        <translation>Importar una lista de clase: una tabla con las columnas class y team, y opcionalmente pseudonym</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>Tablas CSV (*.csv)</translation>
    </message>
    <message>
        <source>Roster imported. New teams: %1, changed: %2, unchanged: %3.</source>
        <translation>Lista de clase importada. Equipos nuevos: %1, cambiados: %2, como antes: %3.</translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s): choose a folder</source>
        <translation>
            <numerusform>Exportar %n ensayo: elija una carpeta</numerusform>
            <numerusform>Exportar %n ensayos: elija una carpeta</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Videos of %n trial(s)</source>
        <translation>
            <numerusform>Videos de %n ensayo</numerusform>
            <numerusform>Videos de %n ensayos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) removed for good.</source>
        <translation>
            <numerusform>%n ensayo eliminado definitivamente.</numerusform>
            <numerusform>%n ensayos eliminados definitivamente.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Removed %1 of %n trial(s) for good; the rest is still in the bin.</source>
        <translation>
            <numerusform>%1 de %n ensayo eliminado definitivamente; el resto sigue ahí.</numerusform>
            <numerusform>%1 de %n ensayos eliminados definitivamente; el resto sigue ahí.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 could not be deleted; delete it by hand.</source>
        <translation>No se pudo eliminar %1; elimínelo a mano.</translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s)</source>
        <translation>
            <numerusform>Exportar %n ensayo</numerusform>
            <numerusform>Exportar %n ensayos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HistoryPage</name>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Comparar</translation>
    </message>
    <message>
        <source>Teams by &amp;pseudonym</source>
        <translation>Equipos por se&amp;udónimo</translation>
    </message>
    <message>
        <source>Tr&amp;ials</source>
        <translation>Ensay&amp;os</translation>
    </message>
    <message>
        <source>Tea&amp;ms</source>
        <translation>E&amp;quipos</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
    <message>
        <source>Rea&amp;nalyse</source>
        <translation>Volver a &amp;medir</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportar…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Informe…</translation>
    </message>
    <message>
        <source>Export &amp;videos…</source>
        <translation>Exportar &amp;videos…</translation>
    </message>
    <message>
        <source>Search trials, teams, tasks, tags, notes…</source>
        <translation>Buscar ensayos, equipos, tareas, etiquetas, notas…</translation>
    </message>
    <message>
        <source>Search the trials</source>
        <translation>Buscar en los ensayos</translation>
    </message>
    <message>
        <source>Searc&amp;h</source>
        <translation>&amp;Buscar</translation>
    </message>
    <message>
        <source>%1 (archived)</source>
        <translation>%1 (archivada)</translation>
    </message>
    <message>
        <source>Compare the selected trials</source>
        <translation>Comparar los ensayos seleccionados</translation>
    </message>
    <message>
        <source>Select two or more trials (Ctrl+click or Shift+click)</source>
        <translation>Seleccione dos ensayos o más (Ctrl o Mayús y clic)</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n ensayo</numerusform>
            <numerusform>%n ensayos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n trial(s)</source>
        <translation>
            <numerusform>%1 de %n ensayo</numerusform>
            <numerusform>%1 de %n ensayos</numerusform>
        </translation>
    </message>
    <message>
        <source>School hub</source>
        <translation>Servidor de la escuela</translation>
    </message>
    <message>
        <source>Res&amp;ults</source>
        <translation>Res&amp;ultados</translation>
    </message>
    <message>
        <source>Trials, results or teams</source>
        <translation>Ensayos, resultados o equipos</translation>
    </message>
</context>
<context>
    <name>odo::HubActions</name>
    <message>
        <source>School &amp;hub…</source>
        <translation>Ser&amp;vidor de la escuela…</translation>
    </message>
</context>
<context>
    <name>odo::HubDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>School hub</source>
        <translation>Servidor de la escuela</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Lo que se hizo</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Cancel the exchange with the hub</source>
        <translation>Cancelar el intercambio con el servidor</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Desconectar</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) are not sent yet. They stay in the project.</source>
        <translation>
            <numerusform>%n cambio no se ha enviado todavía. Queda en el proyecto.</numerusform>
            <numerusform>%n cambios no se han enviado todavía. Quedan en el proyecto.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Desconectar</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Conectando…</translation>
    </message>
    <message>
        <source>Asking the hub…</source>
        <translation>Consultando el servidor…</translation>
    </message>
    <message>
        <source>The project is read-only here, so nothing can be sent or received.</source>
        <translation>Aquí el proyecto es de solo lectura, así que no se puede enviar ni recibir nada.</translation>
    </message>
</context>
<context>
    <name>odo::HubExchange</name>
    <message>
        <source>Disconnected. All trials stay in the project.</source>
        <translation>Desconectado. Todos los ensayos quedan en el proyecto.</translation>
    </message>
</context>
<context>
    <name>odo::HubPanel</name>
    <message>
        <source>Password of the hub</source>
        <translation>Contraseña del servidor</translation>
    </message>
    <message>
        <source>Copy &amp;recordings, too</source>
        <translation>Copiar también las &amp;grabaciones</translation>
    </message>
    <message>
        <source>&amp;Publish now</source>
        <translation>&amp;Publicar ahora</translation>
    </message>
    <message>
        <source>Pu&amp;ll now</source>
        <translation>&amp;Recibir ahora</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Desconectar</translation>
    </message>
    <message>
        <source>Send to the hub what is pending. Odograph also does this by itself.</source>
        <translation>Enviar al servidor lo pendiente. Odograph también lo hace por sí solo.</translation>
    </message>
    <message>
        <source>Receive class lists, tasks and the trials of other benches</source>
        <translation>Recibir listas de clase, tareas y los ensayos de otros puestos</translation>
    </message>
    <message>
        <source>To and from the school&apos;s folder for recordings; this can take long</source>
        <translation>Hacia y desde la carpeta de grabaciones de la escuela; puede tardar</translation>
    </message>
    <message>
        <source>Log &amp;in</source>
        <translation>&amp;Iniciar sesión</translation>
    </message>
    <message>
        <source>Pass&amp;word:</source>
        <translation>C&amp;ontraseña:</translation>
    </message>
    <message>
        <source>How the project is connected</source>
        <translation>Cómo está conectado el proyecto</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Conexión</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>todavía no</translation>
    </message>
    <message>
        <source>Hub</source>
        <translation>Servidor</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rol</translation>
    </message>
    <message>
        <source>Schema</source>
        <translation>Esquema</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Versión %1</translation>
    </message>
    <message>
        <source>Last exchange</source>
        <translation>Último intercambio</translation>
    </message>
    <message>
        <source>Still to be sent</source>
        <translation>Pendiente de enviar</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Grabaciones</translation>
    </message>
    <message>
        <source>No folder: they stay at this bench</source>
        <translation>Sin carpeta: se quedan en este puesto</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Changed twice: %n…</source>
        <translation>
            <numerusform>Cambiado dos &amp;veces: %n…</numerusform>
            <numerusform>Cambiados dos &amp;veces: %n…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::HubRunsModel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>cuenta</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>dudoso</translation>
    </message>
    <message>
        <source>does not count</source>
        <translation>no cuenta</translation>
    </message>
    <message>
        <source>another course</source>
        <translation>otro recorrido</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Standings</source>
        <translation>Clasificación</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Puesto</translation>
    </message>
</context>
<context>
    <name>odo::HubRunsPanel</name>
    <message>
        <source>Trials of all benches</source>
        <translation>Ensayos de todos los puestos</translation>
    </message>
    <message>
        <source>Search trials and teams…</source>
        <translation>Buscar ensayos y equipos…</translation>
    </message>
    <message>
        <source>Search the hub</source>
        <translation>Buscar en el servidor</translation>
    </message>
    <message>
        <source>Three letters or more</source>
        <translation>Tres letras o más</translation>
    </message>
    <message>
        <source>Runs at the hub</source>
        <translation>Recorridos en el servidor</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Buscando…</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n recorrido</numerusform>
            <numerusform>%n recorridos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the newest %n run(s)</source>
        <translation>
            <numerusform>el recorrido más reciente</numerusform>
            <numerusform>los %n recorridos más recientes</numerusform>
        </translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Puesto</translation>
    </message>
    <message>
        <source>All benches</source>
        <translation>Todos los puestos</translation>
    </message>
</context>
<context>
    <name>odo::ImageArea</name>
    <message>
        <source>No view</source>
        <translation>Sin vista</translation>
    </message>
    <message>
        <source>This camera was not recording at this time</source>
        <translation>Esta cámara no estaba grabando en este momento</translation>
    </message>
</context>
<context>
    <name>odo::ImageBars</name>
    <message>
        <source>Error of each image, with a threshold</source>
        <translation>Error de cada imagen, con un umbral</translation>
    </message>
    <message>
        <source>%1: %2 px</source>
        <translation>%1: %2 px</translation>
    </message>
    <message>
        <source>images; rejected above %1 px</source>
        <translation>imágenes; por encima de %1 px no cuentan</translation>
    </message>
</context>
<context>
    <name>odo::ImageChoice</name>
    <message>
        <source>The camera&apos;s &amp;newest recording</source>
        <translation>En la última g&amp;rabación de la cámara</translation>
    </message>
    <message>
        <source>The current image of a &amp;connected camera</source>
        <translation>En lo que ve ahora una cámara &amp;conectada</translation>
    </message>
    <message>
        <source>An image or a &amp;video</source>
        <translation>En una &amp;imagen o un video</translation>
    </message>
</context>
<context>
    <name>odo::ImportLessonDialog</name>
    <message>
        <source>Robots in the trials</source>
        <translation>Robots en los ensayos</translation>
    </message>
    <message>
        <source>Import a lesson</source>
        <translation>Importar una clase</translation>
    </message>
    <message>
        <source>Clips that were recorded at the same time belong to one trial. Untick what is no run; names and teams can be changed.</source>
        <translation>Los videos grabados al mismo tiempo pertenecen a un ensayo. Desmarque lo que no es un recorrido; los nombres y equipos se pueden cambiar.</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>&amp;Tarea</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>R&amp;obots</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>Cámara de la vista %1</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
    <message>
        <source>Team of row %1</source>
        <translation>Equipo de la fila %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>no clip</source>
        <translation>sin video</translation>
    </message>
    <message>
        <source>Each trial needs a name of its own.</source>
        <translation>Cada ensayo necesita un nombre propio.</translation>
    </message>
    <message>
        <source>Tick the trials to import.</source>
        <translation>Marque los ensayos que desea importar.</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Grabado</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Clip of %1</source>
        <translation>Video de %1</translation>
    </message>
    <message>
        <source>Each column of clips needs a camera.</source>
        <translation>Cada columna de videos necesita una cámara.</translation>
    </message>
    <message>
        <source>Two clips of %1 are of the same camera.</source>
        <translation>Dos videos de %1 son de la misma cámara.</translation>
    </message>
</context>
<context>
    <name>odo::ImportTracksDialog</name>
    <message>
        <source>Add &amp;robot</source>
        <translation>Añadir &amp;robot</translation>
    </message>
    <message>
        <source>Import finished tracks</source>
        <translation>Importar trazas terminadas</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>&amp;Tarea</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Trazas</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Robot of track %1</source>
        <translation>Robot de la traza %1</translation>
    </message>
    <message>
        <source>A new name creates a new robot</source>
        <translation>Un nombre nuevo crea un robot nuevo</translation>
    </message>
    <message>
        <source>File of track %1</source>
        <translation>Archivo de la traza %1</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>Equi&amp;po</translation>
    </message>
    <message>
        <source>Positions measured by another program or exported by Odograph: TUM, CSV, Tracker text and others. Odograph analyses them as a run without video.</source>
        <translation>Posiciones medidas por otro programa o exportadas por Odograph: TUM, CSV, texto de Tracker y otros. Odograph las analiza como un recorrido sin vídeo.</translation>
    </message>
    <message>
        <source>Tracks (*.csv *.txt *.tum *.tsv *.trc);;All files (*)</source>
        <translation>Trayectorias (*.csv *.txt *.tum *.tsv *.trc);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>odo::ImportTrialDialog</name>
    <message>
        <source>Robots in the trial</source>
        <translation>Robots del ensayo</translation>
    </message>
    <message>
        <source>Add &amp;view</source>
        <translation>Añadir &amp;vista</translation>
    </message>
    <message>
        <source>Camera&apos;s real &amp;rate</source>
        <translation>&amp;Frecuencia real</translation>
    </message>
    <message>
        <source>Import trial from videos</source>
        <translation>Importar ensayo de videos</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>&amp;Equipo</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>&amp;Tarea</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>R&amp;obots</translation>
    </message>
    <message>
        <source>Videos</source>
        <translation>Videos</translation>
    </message>
    <message>
        <source>&amp;Synchronise</source>
        <translation>&amp;Sincronía</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>Archivo de video</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> fotogramas/s</translation>
    </message>
    <message>
        <source>Camera&apos;s real rate</source>
        <translation>Frecuencia real</translation>
    </message>
    <message>
        <source>For slow motion: the file plays slower than the camera recorded it</source>
        <translation>Para cámara lenta: el archivo se reproduce más despacio de lo que la cámara grabó</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>Cámara de la vista %1</translation>
    </message>
    <message>
        <source>Video of view %1</source>
        <translation>Video de la vista %1</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;All files (*)</source>
        <translation>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Registration of the camera of view %1</source>
        <translation>Registro de la cámara de la vista %1</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>sin indicar</translation>
    </message>
    <message>
        <source>%1 has no time stamps and states no frame rate. Enter the rate of its camera.</source>
        <translation>%1 no tiene marcas de tiempo ni indica la frecuencia de imágenes. Introduzca la de su cámara.</translation>
    </message>
    <message>
        <source>Chapters of one recording are joined by +; images are given as their folder, or FOLDER/%06d.png, with the rate</source>
        <translation>Los capítulos de una grabación se unen con +; las imágenes se indican con su carpeta, o FOLDER/%06d.png, y la frecuencia</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Ensayo %1</translation>
    </message>
</context>
<context>
    <name>odo::IntervalHistogram</name>
    <message>
        <source>Histogram of the frame intervals</source>
        <translation>Histograma de los intervalos entre fotogramas</translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2: %n interval(s)</source>
        <translation>
            <numerusform>%1 a %2: %n intervalo</numerusform>
            <numerusform>%1 a %2: %n intervalos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>longer than %1: %n interval(s)</source>
        <translation>
            <numerusform>más de %1: %n intervalo</numerusform>
            <numerusform>más de %1: %n intervalos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::IntervalPanel</name>
    <message>
        <source>%1: fewer than two frames</source>
        <translation>%1: menos de dos fotogramas</translation>
    </message>
    <message>
        <source>%1: frames are %2 apart (%3 frames/s), from %4 to %5</source>
        <translation>%1: fotogramas cada %2 (%3 fotogramas/s), de %4 a %5</translation>
    </message>
    <message>
        <source>jitter %1</source>
        <translation>fluctuación %1</translation>
    </message>
    <message>
        <source>no frame missing</source>
        <translation>no falta ningún fotograma</translation>
    </message>
    <message>
        <source>%1 of %2 frames repeat the one before</source>
        <translation>%1 de %2 fotogramas repiten el anterior</translation>
    </message>
    <message>
        <source>no frame repeated</source>
        <translation>ningún fotograma repetido</translation>
    </message>
    <message>
        <source>Frame intervals</source>
        <translation>Intervalos entre fotogramas</translation>
    </message>
    <message>
        <source>bars by the logarithm of their number</source>
        <translation>barras según el logaritmo de su número</translation>
    </message>
    <message>
        <source>Frame intervals of the views</source>
        <translation>Intervalos entre fotogramas de las vistas</translation>
    </message>
    <message>
        <source>This trial has no videos.</source>
        <translation>Este ensayo no tiene vídeos.</translation>
    </message>
    <message numerus="yes">
        <source>%1 missing in %n gap(s)</source>
        <translation>
            <numerusform>faltan %1 en %n lugar</numerusform>
            <numerusform>faltan %1 en %n lugares</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::JobIndicator</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Cancel the running job</source>
        <translation>Cancelar el trabajo en curso</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Deteniendo…</translation>
    </message>
</context>
<context>
    <name>odo::JointDialog</name>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Uncertainty before</source>
        <translation>Error antes</translation>
    </message>
    <message>
        <source>Uncertainty, joint</source>
        <translation>Error conjunto</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>Se mueve</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marcador</translation>
    </message>
    <message>
        <source>Off by, mm</source>
        <translation>Desvío, mm</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marcadores</translation>
    </message>
    <message>
        <source>Register all cameras (joint)</source>
        <translation>Registrar todas las cámaras juntas</translation>
    </message>
    <message>
        <source>This fits all cameras of layout %1 jointly to the markers they were registered with. Cameras that see the same markers then agree better, and wrongly measured markers show up.</source>
        <translation>Las cámaras del plano %1 se vuelven a ajustar a la vez, con los marcadores con los que se registraron: donde ven los mismos marcadores concuerdan mejor después, y se descubre un marcador mal medido.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Uncertainty of the tape measure</source>
        <translation>Error de la cinta métrica</translation>
    </message>
    <message>
        <source>Marker positions &amp;measured to</source>
        <translation>Los marcadores se &amp;midieron con error de</translation>
    </message>
    <message>
        <source>Fitting the cameras jointly…</source>
        <translation>Ajustando las cámaras juntas…</translation>
    </message>
    <message>
        <source>The joint uncertainty assumes marker positions measured to %1 mm; registering a single camera assumes them exact. Nothing changes until you save; trials keep the registration they were analysed with.</source>
        <translation>El error conjunto cuenta con que los lugares de los marcadores se midieron con un error de %1 mm, mientras que una cámara registrada por sí sola los toma por exactos. Nada cambia antes de guardar; los ensayos conservan el registro con el que se analizaron.</translation>
    </message>
    <message>
        <source>±%1 mm</source>
        <translation>±%1 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>check its position</source>
        <translation>vuelva a medirlo</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>encaja</translation>
    </message>
</context>
<context>
    <name>odo::KeysPage</name>
    <message>
        <source>&amp;Use this key</source>
        <translation>&amp;Usar este atajo</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Sin atajo</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>Restablecer t&amp;odo</translation>
    </message>
    <message>
        <source>Search for a command or a key</source>
        <translation>Buscar un comando o un atajo</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Comandos y sus atajos</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Atajo</translation>
    </message>
    <message>
        <source>New key for the selected command</source>
        <translation>Nuevo atajo del comando elegido</translation>
    </message>
    <message>
        <source>Select a command to change its key.</source>
        <translation>Elija un comando para darle otro atajo.</translation>
    </message>
    <message>
        <source>%1 is the key of “%2”. That command would lose it.</source>
        <translation>%1 es el atajo de “%2”, que se quedaría sin ninguno.</translation>
    </message>
    <message>
        <source>Press the new key in the field.</source>
        <translation>Pulse el nuevo atajo en el campo.</translation>
    </message>
</context>
<context>
    <name>odo::LayoutDialog</name>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>Tablas (*.csv *.txt);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Marker layout</source>
        <translation>Plano de marcadores</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Qué está mal</translation>
    </message>
    <message>
        <source>Enter the floor positions of the markers, measured with a tape in millimetres from the origin. Seen from above, X points right and Y away from you.</source>
        <translation>Dónde están los marcadores en el suelo, medidos con cinta métrica: milímetros desde el origen. X va hacia la derecha e Y se aleja de usted, visto desde arriba.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Rótulo</translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation>x, mm</translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation>y, mm</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marcadores</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Añadir</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>&amp;Ejes</translation>
    </message>
    <message>
        <source>&amp;CSV</source>
        <translation>&amp;CSV</translation>
    </message>
    <message>
        <source>&amp;Origin at the chosen marker</source>
        <translation>&amp;Origen en el marcador elegido</translation>
    </message>
    <message>
        <source>&amp;Quarter turn</source>
        <translation>&amp;Cuarto de vuelta</translation>
    </message>
    <message>
        <source>&amp;Half turn</source>
        <translation>&amp;Media vuelta</translation>
    </message>
    <message>
        <source>Convert from &amp;centimetres</source>
        <translation>Eran cen&amp;tímetros</translation>
    </message>
    <message>
        <source>Convert from &amp;metres</source>
        <translation>Eran m&amp;etros</translation>
    </message>
    <message>
        <source>Convert from &amp;inches</source>
        <translation>Eran &amp;pulgadas</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importar…</translation>
    </message>
    <message>
        <source>Positions of the markers (label,x_mm,y_mm)</source>
        <translation>Lugares de los marcadores (label,x_mm,y_mm)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Positions of the markers</source>
        <translation>Lugares de los marcadores</translation>
    </message>
    <message>
        <source>The layout has no name.</source>
        <translation>El plano no tiene nombre.</translation>
    </message>
    <message>
        <source>A layout with this name exists, and cameras may use it. Enter another name.</source>
        <translation>Ya hay un plano con ese nombre: puede haber cámaras que se basen en él, así que no se sobrescribe. Indique otro nombre.</translation>
    </message>
    <message>
        <source>A marker has no label.</source>
        <translation>Hay un marcador sin rótulo.</translation>
    </message>
    <message>
        <source>Two markers are called %1.</source>
        <translation>Dos marcadores se llaman %1.</translation>
    </message>
    <message>
        <source>The position of %1 is not a number.</source>
        <translation>El lugar de %1 no es un número.</translation>
    </message>
    <message>
        <source>The layout needs four markers; it has %1.</source>
        <translation>Hacen falta cuatro marcadores; hay %1.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same position.</source>
        <translation>%1 y %2 están en el mismo lugar.</translation>
    </message>
    <message>
        <source>The markers are nearly on a line and cannot determine the camera position. Move one to the side.</source>
        <translation>Los marcadores están casi en línea recta: así no indican dónde está la cámara. Desplace uno hacia un lado.</translation>
    </message>
</context>
<context>
    <name>odo::LayoutDrawing</name>
    <message>
        <source>Markers from above</source>
        <translation>Marcadores desde arriba</translation>
    </message>
    <message>
        <source>grid %1 m</source>
        <translation>cuadrícula de %1 m</translation>
    </message>
</context>
<context>
    <name>odo::LengthPage</name>
    <message>
        <source>S&amp;nap to what is near a click</source>
        <translation>Tomar lo que está &amp;cerca del clic</translation>
    </message>
    <message>
        <source>Image with both ends; arrow keys move the selected one, Space snaps it</source>
        <translation>Imagen con ambos extremos; las flechas mueven el elegido, Espacio lo ajusta</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Measured length</source>
        <translation>Longitud medida</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>se desconoce</translation>
    </message>
    <message>
        <source>True length</source>
        <translation>Longitud real</translation>
    </message>
    <message>
        <source>Unit of the true length</source>
        <translation>Unidad de la longitud real</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>on the floor</source>
        <translation>está en el suelo</translation>
    </message>
    <message>
        <source>&amp;True length</source>
        <translation>Longitud &amp;real</translation>
    </message>
    <message>
        <source>H&amp;eight</source>
        <translation>Al&amp;tura</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Extremo</translation>
    </message>
    <message>
        <source>Seen as</source>
        <translation>Visto como</translation>
    </message>
    <message>
        <source>On the floor, mm</source>
        <translation>En el suelo, mm</translation>
    </message>
    <message>
        <source>Ends of the length</source>
        <translation>Extremos de la longitud</translation>
    </message>
    <message>
        <source>Both ends</source>
        <translation>Ambos extremos</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Qué es</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>Put an object of known length anywhere on the floor, such as a metre stick or two markers at a known distance, and click both ends. Keys: arrows move an end (Ctrl: fast, Shift: one pixel), Space snaps it.</source>
        <translation>Ponga algo de longitud conocida en cualquier lugar del suelo, una regla de un metro o dos marcadores a distancia conocida, y haga clic en ambos extremos. Con el teclado: las flechas mueven un extremo (Ctrl: rápido, Mayús: un píxel), Espacio lo ajusta.</translation>
    </message>
    <message>
        <source>%1 ± %2 mm</source>
        <translation>%1 ± %2 mm</translation>
    </message>
    <message>
        <source>within uncertainty</source>
        <translation>dentro del error previsto</translation>
    </message>
    <message>
        <source>outside uncertainty</source>
        <translation>fuera del error previsto</translation>
    </message>
    <message>
        <source> Enter its true length to check the result.</source>
        <translation> Indique su longitud real para ver si es correcto.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>beyond the horizon</source>
        <translation>más allá del horizonte</translation>
    </message>
    <message>
        <source>not set yet</source>
        <translation>aún sin colocar</translation>
    </message>
</context>
<context>
    <name>odo::LengthWizard</name>
    <message>
        <source>Check a known length</source>
        <translation>Comprobar una longitud conocida</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Listo</translation>
    </message>
    <message>
        <source>Image or video of the length</source>
        <translation>Imagen o video de la longitud</translation>
    </message>
    <message>
        <source>The camera and its image</source>
        <translation>La cámara y su imagen</translation>
    </message>
    <message>
        <source>Both ends of the length</source>
        <translation>Ambos extremos de la longitud</translation>
    </message>
    <message>
        <source>Put an object of known length on the floor, away from the markers, to check the camera&apos;s stated uncertainty. This changes nothing.</source>
        <translation>Ponga en el suelo algo de longitud conocida, lejos de los marcadores, y vea si la cámara lo mide tan bien como promete. Esto no cambia nada.</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>Cá&amp;mara</translation>
    </message>
    <message>
        <source>Image of the length</source>
        <translation>Dónde se ve la longitud</translation>
    </message>
    <message>
        <source>Loading the image…</source>
        <translation>Obteniendo la imagen…</translation>
    </message>
    <message>
        <source>Choose an image or a video.</source>
        <translation>Elija una imagen o un vídeo.</translation>
    </message>
</context>
<context>
    <name>odo::LensWizard</name>
    <message>
        <source>Calibrate camera</source>
        <translation>Calibrar cámara</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>The camera and the board</source>
        <translation>La cámara y el tablero</translation>
    </message>
    <message>
        <source>Images of the board</source>
        <translation>Imágenes del tablero</translation>
    </message>
    <message>
        <source>The lens</source>
        <translation>La lente</translation>
    </message>
    <message>
        <source>At least %1 images that show the board are needed; so far there are %2.</source>
        <translation>Se necesitan al menos %1 imágenes que muestren el tablero; por ahora hay %2.</translation>
    </message>
    <message>
        <source>There is no lens calibration to save yet.</source>
        <translation>Aún no hay ninguna calibración del objetivo que guardar.</translation>
    </message>
    <message numerus="yes">
        <source>%n image(s) of the board</source>
        <translation>
            <numerusform>%n imagen del tablero</numerusform>
            <numerusform>%n imágenes del tablero</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::LessonBar</name>
    <message>
        <source>Ne&amp;xt</source>
        <translation>Siguie&amp;nte</translation>
    </message>
    <message>
        <source>&amp;Leave the lesson</source>
        <translation>&amp;Dejar la lección</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>paso %1 de %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hecho</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Terminar</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>Siguie&amp;nte</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>&amp;Omitir</translation>
    </message>
</context>
<context>
    <name>odo::LiveBoard</name>
    <message>
        <source>Top-down map</source>
        <translation>Mapa en planta</translation>
    </message>
    <message>
        <source>Health of cameras, map and disk</source>
        <translation>Estado de las cámaras, el mapa y el disco</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>Live view of %1</source>
        <translation>Imagen en vivo de %1</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>sin registrar</translation>
    </message>
    <message>
        <source>Opening the camera…</source>
        <translation>Abriendo la cámara…</translation>
    </message>
    <message>
        <source>live, sent to %1</source>
        <translation>en vivo, enviado a %1</translation>
    </message>
    <message>
        <source>live</source>
        <translation>en vivo</translation>
    </message>
    <message>
        <source>Waiting for the first frame…</source>
        <translation>Esperando la primera imagen…</translation>
    </message>
    <message>
        <source>No frames now</source>
        <translation>Ahora sin imagen</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 fotogramas/s</translation>
    </message>
</context>
<context>
    <name>odo::LiveCameraBox</name>
    <message>
        <source>Connected camera</source>
        <translation>Cámara conectada</translation>
    </message>
    <message>
        <source>%1, %2×%3</source>
        <translation>%1, %2×%3</translation>
    </message>
    <message>
        <source>Searching for cameras…</source>
        <translation>Buscando cámaras…</translation>
    </message>
    <message>
        <source>No camera is connected</source>
        <translation>No hay cámaras conectadas</translation>
    </message>
</context>
<context>
    <name>odo::LiveMap</name>
    <message>
        <source>Live floor map with the robots</source>
        <translation>Mapa del suelo con los robots en movimiento</translation>
    </message>
    <message>
        <source>No camera is registered to the floor: robots cannot be located</source>
        <translation>Ninguna cámara está registrada respecto al suelo, así que no se puede indicar ningún lugar en él</translation>
    </message>
</context>
<context>
    <name>odo::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>Pr&amp;eferences…</source>
        <translation>&amp;Preferencias…</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>A recording is running. The change takes effect when you reopen the project.</source>
        <translation>Las páginas se actualizan al volver a abrir el proyecto, pues hay una grabación en curso.</translation>
    </message>
    <message>
        <source>Restore the backup</source>
        <translation>Restaurar la copia de seguridad</translation>
    </message>
    <message>
        <source>Another program deleted, renamed or replaced “%1”. Odograph will rescue its contents when the running job has ended.</source>
        <translation>Otro programa eliminó, renombró o sustituyó «%1». Su contenido se rescatará en cuanto termine el trabajo en curso.</translation>
    </message>
    <message>
        <source>Another program deleted, renamed or replaced “%1”. Odograph rescued its contents in “%2” and opened that project.</source>
        <translation>Otro programa eliminó, renombró o sustituyó «%1». Su contenido se ha rescatado en «%2», que ahora está abierto.</translation>
    </message>
    <message>
        <source>Another program overwrote “%1”. Odograph will open the new contents when the running job has ended.</source>
        <translation>Otro programa ha sobrescrito «%1». Lo que contiene ahora se abrirá en cuanto termine el trabajo en curso.</translation>
    </message>
    <message>
        <source>Another program renamed “%1” and its videos. It is now open as “%2”.</source>
        <translation>Otro programa ha cambiado el nombre de «%1» junto con sus vídeos. Ahora está abierto como «%2».</translation>
    </message>
    <message>
        <source>Another program overwrote “%1” while it was open. Its earlier contents are gone; the window shows the new ones.</source>
        <translation>Otro programa ha sobrescrito «%1» mientras estaba abierto: lo que contenía antes se ha perdido. Se muestra lo que contiene ahora.</translation>
    </message>
    <message>
        <source>C&amp;lass</source>
        <translation>C&amp;lase</translation>
    </message>
    <message>
        <source>You and another bench changed the same things. Both versions are kept.</source>
        <translation>Usted y otro puesto han cambiado lo mismo. Se conservan ambas versiones.</translation>
    </message>
    <message>
        <source>Show both</source>
        <translation>Mostrar ambas</translation>
    </message>
    <message>
        <source>Table saved as %1.</source>
        <translation>Tabla guardada como %1.</translation>
    </message>
</context>
<context>
    <name>odo::MapArea</name>
    <message>
        <source>0 to %1 apart</source>
        <translation>separación de 0 a %1</translation>
    </message>
    <message>
        <source>x %1 · y %2</source>
        <translation>x %1 · y %2</translation>
    </message>
</context>
<context>
    <name>odo::MarkActions</name>
    <message>
        <source>&amp;Star</source>
        <translation>D&amp;estacar</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>&amp;Archivar</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>E&amp;liminar</translation>
    </message>
    <message>
        <source>&amp;Empty the bin…</source>
        <translation>Vaciar &amp;papelera…</translation>
    </message>
    <message>
        <source>Remove &amp;star</source>
        <translation>Quitar &amp;estrella</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>Des&amp;archivar</translation>
    </message>
    <message>
        <source>Rest&amp;ore</source>
        <translation>Recupera&amp;r</translation>
    </message>
    <message>
        <source>Restore the selected trials from the bin (Del)</source>
        <translation>Saca de la papelera los ensayos seleccionados (Supr)</translation>
    </message>
    <message>
        <source>Move the selected trials to the bin (Del); you can restore them</source>
        <translation>Lleva a la papelera los ensayos seleccionados (Supr); se pueden recuperar</translation>
    </message>
    <message>
        <source>Empty the bin</source>
        <translation>Vaciar la papelera</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n trial(s) for good?</source>
        <translation>
            <numerusform>¿Eliminar definitivamente %n ensayo?</numerusform>
            <numerusform>¿Eliminar definitivamente %n ensayos?</numerusform>
        </translation>
    </message>
    <message>
        <source>This removes their videos (%1), measurements and results from the disk. You cannot undo it.</source>
        <translation>Sus videos (%1), mediciones y resultados se borran del disco. No se puede deshacer.</translation>
    </message>
    <message>
        <source>&amp;Remove for good</source>
        <translation>&amp;Eliminar definitivamente</translation>
    </message>
</context>
<context>
    <name>odo::MarkerCanvas</name>
    <message>
        <source>Image with the markers; arrow keys move the selected one</source>
        <translation>Imagen con los marcadores; las flechas mueven el elegido</translation>
    </message>
</context>
<context>
    <name>odo::MarkerPage</name>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marcador</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>Lugar, mm</translation>
    </message>
    <message>
        <source>Seen as</source>
        <translation>Visto como</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marcadores</translation>
    </message>
    <message>
        <source>found</source>
        <translation>encontrado</translation>
    </message>
    <message>
        <source>Select a marker in the table and click its position. The click snaps to what is near it, to a tenth of a pixel.</source>
        <translation>Elija un marcador en la tabla y haga clic donde esté; lo que haya cerca del clic se localiza hasta la décima de píxel.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>no se ve</translation>
    </message>
</context>
<context>
    <name>odo::MatDialog</name>
    <message>
        <source>Find the floor mat</source>
        <translation>Buscar la alfombrilla</translation>
    </message>
    <message>
        <source>The mat is searched for in the newest recording of each camera: %1.</source>
        <translation>La alfombrilla se busca en la grabación más reciente de cada cámara: %1.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Measure the line at the mat&apos;s lower edge from end mark to end mark. Printers often shrink by 2 to 4 %; what you enter makes up for it.</source>
        <translation>Mida la línea del borde inferior de la alfombrilla de marca a marca. Las impresoras suelen reducir entre un 2 y un 4 %; lo que introduce lo compensa.</translation>
    </message>
    <message>
        <source>&amp;Check line</source>
        <translation>Línea de &amp;control</translation>
    </message>
    <message>
        <source>Find the mat</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>sin medir</translation>
    </message>
</context>
<context>
    <name>odo::MessageBar</name>
    <message>
        <source>Close the message</source>
        <translation>Cerrar el mensaje</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>odo::MessagePanel</name>
    <message>
        <source>No messages.</source>
        <translation>No hay mensajes.</translation>
    </message>
    <message>
        <source>Dismiss &amp;all</source>
        <translation>Descartar &amp;todos</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>Close the list of messages</source>
        <translation>Cerrar la lista de mensajes</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Cerrar (Esc)</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n times</source>
        <translation>
            <numerusform>%1, %n vez</numerusform>
            <numerusform>%1, %n veces</numerusform>
        </translation>
    </message>
    <message>
        <source>Dismiss: %1</source>
        <translation>Descartar: %1</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Descartar</translation>
    </message>
</context>
<context>
    <name>odo::MetricGrid</name>
    <message>
        <source>Metrics</source>
        <translation>Indicadores</translation>
    </message>
    <message>
        <source>No result yet: track the trial</source>
        <translation>Aún sin resultado: rastree el ensayo</translation>
    </message>
</context>
<context>
    <name>odo::MetricModel</name>
    <message>
        <source>Metric</source>
        <translation>Indicador</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
</context>
<context>
    <name>odo::ModeBar</name>
    <message>
        <source>Modes</source>
        <translation>Modos</translation>
    </message>
</context>
<context>
    <name>odo::NetworkPage</name>
    <message>
        <source>&amp;Send live positions on the network</source>
        <translation>&amp;Enviar posiciones en vivo por la red</translation>
    </message>
    <message>
        <source>%1: this computer only</source>
        <translation>%1: solo esta máquina</translation>
    </message>
    <message>
        <source>%1: not available now</source>
        <translation>%1: ahora no está</translation>
    </message>
    <message>
        <source>Positions of the robots that Record tracks, as SSL-Vision packets for your own controllers and programs. The packets contain no names of teams or robots.</source>
        <translation>Las posiciones de los robots que sigue Grabar, como paquetes de SSL-Vision, para controladores y programas propios. No contienen nombres de equipos ni de robots.</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>&amp;Dirección</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Puerto</translation>
    </message>
    <message>
        <source>&amp;Interface</source>
        <translation>Inter&amp;faz</translation>
    </message>
    <message>
        <source>Odograph sends nothing.</source>
        <translation>No se envía nada.</translation>
    </message>
    <message>
        <source>This is not an IPv4 address; enter one such as 224.5.23.2.</source>
        <translation>No es una dirección IPv4; escríbala como 224.5.23.2.</translation>
    </message>
    <message>
        <source>They go only to the computer with this address.</source>
        <translation>Van a la única máquina que tiene esta dirección.</translation>
    </message>
    <message>
        <source>They do not leave this computer.</source>
        <translation>No salen de esta máquina.</translation>
    </message>
    <message>
        <source>Anyone on that network can read the robots&apos; positions.</source>
        <translation>Cualquiera que esté en esa red puede leer dónde están los robots.</translation>
    </message>
</context>
<context>
    <name>odo::NumberText</name>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
</context>
<context>
    <name>odo::PathField</name>
    <message>
        <source>Browse…</source>
        <translation>Examinar…</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>Examinar: %1</translation>
    </message>
    <message>
        <source>Images and videos (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov *.webm);;All files (*)</source>
        <translation>Imágenes y videos (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov *.webm);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>odo::PathSketch</name>
    <message>
        <source>The path from above</source>
        <translation>El recorrido desde arriba</translation>
    </message>
</context>
<context>
    <name>odo::PickColourDialog</name>
    <message>
        <source>Pick the robot&apos;s colour</source>
        <translation>Color del robot desde una imagen</translation>
    </message>
    <message>
        <source>Another &amp;video…</source>
        <translation>Otro &amp;video…</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>&amp;Grabación</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>&amp;Fotograma</translation>
    </message>
    <message>
        <source>Choose a video that shows the robot.</source>
        <translation>Elija un video en el que se vea el robot.</translation>
    </message>
    <message>
        <source>Use this colour</source>
        <translation>Tomar este color</translation>
    </message>
    <message>
        <source>Video that shows the robot</source>
        <translation>Video en el que se ve el robot</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mov *.mkv *.avi *.m4v);;All files (*)</source>
        <translation>Videos (*.mp4 *.mov *.mkv *.avi *.m4v);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>The robot&apos;s colour here: %1. It fills %2 % of the box.</source>
        <translation>El color del robot aquí: %1. Llena el %2 % del recuadro.</translation>
    </message>
    <message>
        <source>Draw a tight box round the robot with the mouse, or use the keyboard: arrow keys move the box, Shift + arrow keys resize it.</source>
        <translation>Dibuje con el ratón un recuadro ceñido al robot; o con las flechas, que mueven el recuadro y, con Mayús, lo agrandan o reducen.</translation>
    </message>
    <message>
        <source>%1, camera %2</source>
        <translation>%1, cámara %2</translation>
    </message>
</context>
<context>
    <name>odo::PlannedCameraForm</name>
    <message>
        <source>Position x</source>
        <translation>Situada en x</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>Situada en y</translation>
    </message>
    <message>
        <source>Height of the camera</source>
        <translation>Altura de la cámara</translation>
    </message>
    <message>
        <source>Looks at x</source>
        <translation>Mira a x</translation>
    </message>
    <message>
        <source>Looks at y</source>
        <translation>Mira a y</translation>
    </message>
    <message>
        <source>Viewing direction</source>
        <translation>Dirección en la que mira</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Campo visual</translation>
    </message>
    <message>
        <source>0° is along X, 90° along Y; the point that the camera looks at turns with it</source>
        <translation>0° es a lo largo de X, 90° a lo largo de Y; al girarla, el punto al que mira gira alrededor de la cámara</translation>
    </message>
    <message>
        <source>Across the image width: a webcam has about 60° to 80°, a phone 65°</source>
        <translation>A lo ancho de la imagen: una webcam tiene unos 60° a 80°, un teléfono 65°</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>Tamaño de sus imágenes</translation>
    </message>
    <message>
        <source>Po&amp;sition x, y</source>
        <translation>&amp;Situada en x, y</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Altura</translation>
    </message>
    <message>
        <source>&amp;Looks at x, y</source>
        <translation>M&amp;ira a x, y</translation>
    </message>
    <message>
        <source>D&amp;irection</source>
        <translation>&amp;Dirección</translation>
    </message>
    <message>
        <source>&amp;Field of view</source>
        <translation>Campo &amp;visual</translation>
    </message>
</context>
<context>
    <name>odo::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>Categories of preferences</source>
        <translation>Tipos de preferencias</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;General</translation>
    </message>
    <message>
        <source>&amp;Reports</source>
        <translation>&amp;Informes</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>A&amp;tajos</translation>
    </message>
    <message>
        <source>&amp;Network</source>
        <translation>&amp;Red</translation>
    </message>
</context>
<context>
    <name>odo::PresentWindow</name>
    <message>
        <source>Presentation</source>
        <translation>Presentación</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>No trial</source>
        <translation>Ningún ensayo</translation>
    </message>
    <message>
        <source>Speed now</source>
        <translation>Velocidad ahora</translation>
    </message>
    <message>
        <source>Not tracked yet</source>
        <translation>Aún sin rastrear</translation>
    </message>
</context>
<context>
    <name>odo::ProfileChart</name>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Rumbo</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Velocidad de giro</translation>
    </message>
    <message>
        <source>Position X</source>
        <translation>Posición X</translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation>Posición Y</translation>
    </message>
    <message>
        <source>Quantity of the chart</source>
        <translation>Magnitud que muestra la gráfica</translation>
    </message>
    <message>
        <source>smoothed ±95 %</source>
        <translation>suavizada ±95 %</translation>
    </message>
    <message>
        <source>measured points</source>
        <translation>puntos medidos</translation>
    </message>
    <message>
        <source>1 spike</source>
        <translation>1 valor atípico</translation>
    </message>
    <message>
        <source>%1 spikes</source>
        <translation>%1 valores atípicos</translation>
    </message>
    <message>
        <source>along the path</source>
        <translation>a lo largo de la trayectoria</translation>
    </message>
    <message>
        <source>of the motion, anticlockwise from X</source>
        <translation>del movimiento, antihorario desde X</translation>
    </message>
    <message>
        <source>anticlockwise positive</source>
        <translation>antihorario positivo</translation>
    </message>
    <message>
        <source>Chart: %1 over time</source>
        <translation>Gráfica: %1 según el tiempo</translation>
    </message>
    <message>
        <source>Chart: %1 over distance</source>
        <translation>Gráfica: %1 según la distancia</translation>
    </message>
    <message>
        <source>of the body, anticlockwise from X</source>
        <translation>del cuerpo, antihorario desde X</translation>
    </message>
    <message>
        <source>shaded: hidden, ambiguous or not measured</source>
        <translation>sombreado: oculto, en duda o sin medir</translation>
    </message>
    <message>
        <source>Velocity X</source>
        <translation>Velocidad X</translation>
    </message>
    <message>
        <source>Velocity Y</source>
        <translation>Velocidad Y</translation>
    </message>
    <message>
        <source>Lateral acceleration</source>
        <translation>Aceleración lateral</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Sobreaceleración</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>Distancia recorrida</translation>
    </message>
    <message>
        <source>Distance from the start</source>
        <translation>Distancia al inicio</translation>
    </message>
    <message>
        <source>to the left positive</source>
        <translation>positiva a la izquierda</translation>
    </message>
    <message>
        <source>along the path, mean over %1</source>
        <translation>a lo largo de la trayectoria, media en %1</translation>
    </message>
    <message>
        <source>Distance to the nearest robot</source>
        <translation>Distancia al robot más próximo</translation>
    </message>
</context>
<context>
    <name>odo::RangeActions</name>
    <message>
        <source>Set &amp;start here</source>
        <translation>Fijar el &amp;inicio aquí</translation>
    </message>
    <message>
        <source>The results are of the run from this time on; before it nothing counts.</source>
        <translation>Los resultados son del recorrido a partir de este momento; lo anterior no cuenta.</translation>
    </message>
    <message>
        <source>Set &amp;end here</source>
        <translation>Fijar el &amp;final aquí</translation>
    </message>
    <message>
        <source>The results are of the run up to this time; after it nothing counts.</source>
        <translation>Los resultados son del recorrido hasta este momento; lo posterior no cuenta.</translation>
    </message>
    <message>
        <source>From first to last &amp;motion</source>
        <translation>Del primer al último &amp;movimiento</translation>
    </message>
    <message>
        <source>The results are of the run from when a robot first moves to when it last does.</source>
        <translation>Los resultados son del recorrido desde el primer hasta el último movimiento de un robot.</translation>
    </message>
    <message>
        <source>&amp;Whole run</source>
        <translation>Recorrido &amp;completo</translation>
    </message>
    <message>
        <source>The results are of all of the trial again.</source>
        <translation>Los resultados vuelven a ser de todo el ensayo.</translation>
    </message>
</context>
<context>
    <name>odo::RangeCard</name>
    <message>
        <source>&amp;Fit</source>
        <translation>A&amp;juste</translation>
    </message>
    <message>
        <source>Robot of the statistics</source>
        <translation>Robot cuyo intervalo se muestra</translation>
    </message>
    <message>
        <source>Function to fit to the curve</source>
        <translation>Lo que se ajusta a la curva</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>constante</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>recta</translation>
    </message>
    <message>
        <source>parabola</source>
        <translation>parábola</translation>
    </message>
    <message>
        <source>Fitted quantity</source>
        <translation>Magnitud que se ajusta</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Selección</translation>
    </message>
    <message>
        <source>Statistics of the selection</source>
        <translation>Indicadores de la selección</translation>
    </message>
</context>
<context>
    <name>odo::RecordPage</name>
    <message>
        <source>No camera is connected</source>
        <translation>No hay cámaras conectadas</translation>
    </message>
    <message>
        <source>Connect one or two cameras, then search again. If a connected camera is not found, run the set-up doctor.</source>
        <translation>Conecte una cámara, o dos, y busque otra vez. Una cámara conectada que no aparece es un caso para el diagnóstico.</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Buscar otra vez</translation>
    </message>
    <message>
        <source>Set-up doctor…</source>
        <translation>Diagnóstico…</translation>
    </message>
    <message>
        <source>Choose &amp;cameras…</source>
        <translation>Elegir &amp;cámaras…</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>Cámaras…</translation>
    </message>
    <message>
        <source>Assign the connected devices to the cameras of the project</source>
        <translation>Elegir qué dispositivo conectado es cada cámara del proyecto</translation>
    </message>
    <message>
        <source>Set-up &amp;doctor…</source>
        <translation>&amp;Diagnóstico…</translation>
    </message>
    <message>
        <source>Doctor…</source>
        <translation>Diagnóstico…</translation>
    </message>
    <message>
        <source>Check for what makes cameras lose frames or measure wrongly, and get advice</source>
        <translation>Buscar qué hace que las cámaras pierdan imágenes o midan mal, con consejos</translation>
    </message>
    <message>
        <source>Give the trial a name</source>
        <translation>Dé un nombre al ensayo</translation>
    </message>
</context>
<context>
    <name>odo::ReferenceCameraPage</name>
    <message>
        <source>Image or video of the camera to register</source>
        <translation>Imagen o video de la cámara por registrar</translation>
    </message>
    <message>
        <source>Image or video of the registered camera</source>
        <translation>Imagen o video de la cámara registrada</translation>
    </message>
    <message>
        <source>A camera cannot be registered via itself: choose two different ones.</source>
        <translation>Una cámara no se puede registrar mediante sí misma: elija dos distintas.</translation>
    </message>
    <message>
        <source>Camera to register</source>
        <translation>Cámara por registrar</translation>
    </message>
    <message>
        <source>Registered camera</source>
        <translation>Cámara registrada</translation>
    </message>
    <message>
        <source>Register a camera that sees no markers by floor points that a registered camera also sees: corners of tiles, ends of tape, screws. Four are enough; six or more, spread over the common area, are better. Do not move either camera afterwards.</source>
        <translation>Una cámara que no ve marcadores se puede registrar con puntos del suelo que también ve una cámara registrada: esquinas de baldosas, extremos de cinta, tornillos. Bastan cuatro; seis o más repartidos por la parte común son mejores. Después no se debe mover ninguna de las dos cámaras.</translation>
    </message>
    <message>
        <source>C&amp;amera to register</source>
        <translation>Cá&amp;mara por registrar</translation>
    </message>
    <message>
        <source>&amp;Via camera</source>
        <translation>Median&amp;te la cámara</translation>
    </message>
    <message>
        <source>Its image</source>
        <translation>Su imagen</translation>
    </message>
    <message>
        <source>The registered camera&apos;s image</source>
        <translation>La imagen de la cámara registrada</translation>
    </message>
    <message>
        <source>Choose an image for each camera.</source>
        <translation>Elija una imagen para cada cámara.</translation>
    </message>
</context>
<context>
    <name>odo::RegisterViaCameraWizard</name>
    <message>
        <source>Register via another camera</source>
        <translation>Registrar mediante otra cámara</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Two cameras and their images</source>
        <translation>Dos cámaras y sus imágenes</translation>
    </message>
    <message>
        <source>The same points in both images</source>
        <translation>Los mismos puntos en ambas imágenes</translation>
    </message>
    <message>
        <source>Loading the images…</source>
        <translation>Obteniendo las imágenes…</translation>
    </message>
    <message>
        <source>There is no registration to save yet.</source>
        <translation>Aún no hay ningún registro que guardar.</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>el registro</translation>
    </message>
</context>
<context>
    <name>odo::RegistrationVerdict</name>
    <message>
        <source>Camera position</source>
        <translation>Dónde está la cámara</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Camera position: x %1 m, y %2 m, %3 m above the floor.</source>
        <translation>Está en x %1 m, y %2 m, a %3 m sobre el suelo.</translation>
    </message>
    <message>
        <source>The registration was not stored. %1</source>
        <translation>El registro no se guardó. %1</translation>
    </message>
</context>
<context>
    <name>odo::ReportActions</name>
    <message>
        <source>The trial %1</source>
        <translation>El ensayo %1</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Informe…</translation>
    </message>
    <message>
        <source>The comparison of %1 and %2</source>
        <translation>La comparación de %1 y %2</translation>
    </message>
    <message>
        <source>A class</source>
        <translation>Una clase</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s), a page each</source>
        <translation>
            <numerusform>%n ensayo, una página cada uno</numerusform>
            <numerusform>%n ensayos, una página cada uno</numerusform>
        </translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Guardar el informe</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>Archivos PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report saved as %1.</source>
        <translation>El informe está en %1.</translation>
    </message>
    <message>
        <source>Report sent to printer %1.</source>
        <translation>El informe está en la impresora %1.</translation>
    </message>
    <message>
        <source>Over the floor that the cameras see</source>
        <translation>Sobre el suelo que ven las cámaras</translation>
    </message>
    <message>
        <source>The simulated run:</source>
        <translation>El recorrido simulado:</translation>
    </message>
    <message>
        <source>Save the certificate</source>
        <translation>Guardar el certificado</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificado</translation>
    </message>
    <message>
        <source>Certificate saved as %1.</source>
        <translation>El certificado está en %1.</translation>
    </message>
    <message>
        <source>C&amp;ertificate of this set-up…</source>
        <translation>Cer&amp;tificado de este montaje…</translation>
    </message>
</context>
<context>
    <name>odo::ReportDialog</name>
    <message>
        <source>A page for each &amp;team</source>
        <translation>Una página por &amp;equipo</translation>
    </message>
    <message>
        <source>A second page with the &amp;method</source>
        <translation>Segunda página con el &amp;método</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>&amp;Guardar como PDF…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Imprimir…</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>&amp;Clase</translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation>&amp;Tarea</translation>
    </message>
    <message>
        <source>Most common</source>
        <translation>La habitual</translation>
    </message>
    <message>
        <source>M&amp;etric</source>
        <translation>I&amp;ndicador</translation>
    </message>
    <message>
        <source>Most informative</source>
        <translation>El más revelador</translation>
    </message>
    <message>
        <source>Report &amp;of</source>
        <translation>Informe &amp;de</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>&amp;Papel</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Carta</translation>
    </message>
    <message>
        <source>School, &amp;logo and wording…</source>
        <translation>Escuela, &amp;logotipo y textos…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Nothing to print yet.</source>
        <translation>Aún no hay nada que imprimir.</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n página</numerusform>
            <numerusform>%n páginas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n page(s); the file has all of them.</source>
        <translation>
            <numerusform>La primera página; el archivo las tiene todas.</numerusform>
            <numerusform>Las primeras %n páginas; el archivo las tiene todas.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportPreview</name>
    <message>
        <source>Preview of the pages</source>
        <translation>Vista previa de las páginas</translation>
    </message>
    <message>
        <source>Drawing the pages…</source>
        <translation>Dibujando las páginas…</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n página</numerusform>
            <numerusform>%n páginas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportsPage</name>
    <message>
        <source>&amp;School</source>
        <translation>E&amp;scuela</translation>
    </message>
    <message>
        <source>shown at the top of each page</source>
        <translation>aparece en la cabecera de cada página</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logotipo</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg *.svg)</source>
        <translation>Imágenes (*.png *.jpg *.jpeg *.svg)</translation>
    </message>
    <message>
        <source>&amp;Logo</source>
        <translation>&amp;Logotipo</translation>
    </message>
    <message>
        <source>Preview of the logo</source>
        <translation>Cómo se ve el logotipo</translation>
    </message>
    <message>
        <source>&amp;At the bottom</source>
        <translation>Al &amp;pie</translation>
    </message>
    <message>
        <source>for example: whom to ask</source>
        <translation>por ejemplo: quién responde preguntas</translation>
    </message>
</context>
<context>
    <name>odo::ReprocessDialog</name>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>&amp;Reanalyse</source>
        <translation>Volver a &amp;medir</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Conservar</translation>
    </message>
    <message>
        <source>Reanalyse trials</source>
        <translation>Volver a medir ensayos</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Indicador</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Lo que cambia</translation>
    </message>
    <message>
        <source>What changes, in words</source>
        <translation>Lo que cambia, en palabras</translation>
    </message>
    <message>
        <source>What was detected in the videos stays as it is; its floor positions are recomputed with the current registrations. Check what changes, then keep it or not: the older analysis stays in the project too.</source>
        <translation>Lo que se vio en los videos queda como está; su lugar en el suelo se calcula con los registros vigentes ahora. Vea lo que cambia y después consérvelo o no: el análisis anterior también queda en el proyecto.</translation>
    </message>
    <message>
        <source>&amp;Trial</source>
        <translation>&amp;Ensayo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>%1 (measured with an older registration)</source>
        <translation>%1 (medido con un registro anterior)</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Midiendo…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Kept: the new analysis of %1 is the current one.</source>
        <translation>Conservado: el nuevo análisis de %1 es el actual.</translation>
    </message>
</context>
<context>
    <name>odo::ResidualPlot</name>
    <message>
        <source>Residual against the cut-off</source>
        <translation>Residuo según el corte</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>residual analysis</source>
        <translation>análisis de residuos</translation>
    </message>
    <message>
        <source>a filter of %1 takes away %2</source>
        <translation>un filtro de %1 quita %2</translation>
    </message>
</context>
<context>
    <name>odo::ResultPanel</name>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Robot whose result is shown</source>
        <translation>Robot cuyo resultado se muestra</translation>
    </message>
    <message>
        <source>robot “%1”</source>
        <translation>robot “%1”</translation>
    </message>
</context>
<context>
    <name>odo::ResultStatisticsModel</name>
    <message>
        <source>Metric</source>
        <translation>Indicador</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Number of values: runs without bad results, lower bounds or another course</source>
        <translation>Número de valores: recorridos sin resultados malos, cotas inferiores ni otro trazado</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Recorridos</translation>
    </message>
    <message>
        <source>Mean ± its standard error (SD / √runs)</source>
        <translation>Media ± su error estándar (DE / √recorridos)</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>Standard deviation of one run</source>
        <translation>Desviación estándar de un recorrido</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>DE</translation>
    </message>
    <message>
        <source>Coefficient of variation: SD as a part of the mean</source>
        <translation>Coeficiente de variación: DE como parte de la media</translation>
    </message>
    <message>
        <source>CV %</source>
        <translation>CV %</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Mínimo</translation>
    </message>
    <message>
        <source>Most</source>
        <translation>Máximo</translation>
    </message>
</context>
<context>
    <name>odo::ResultsModel</name>
    <message>
        <source>not tracked</source>
        <translation>sin rastrear</translation>
    </message>
    <message>
        <source>Not used in means: a lower bound, a bad result, or another course</source>
        <translation>No cuenta en las medias: cota inferior, mal resultado u otro trazado</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
</context>
<context>
    <name>odo::ResultsPanel</name>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Group by</source>
        <translation>Agrupar por</translation>
    </message>
    <message>
        <source>Results of the trials</source>
        <translation>Resultados de los ensayos</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Estadística</translation>
    </message>
    <message>
        <source>Any class</source>
        <translation>Cualquier clase</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>Cualquier tarea</translation>
    </message>
    <message>
        <source>No groups</source>
        <translation>Sin grupos</translation>
    </message>
    <message>
        <source>Search…</source>
        <translation>Buscar…</translation>
    </message>
    <message>
        <source>Search the results</source>
        <translation>Buscar en los resultados</translation>
    </message>
    <message>
        <source>Trials, teams, robots, tags and variables with all of these words</source>
        <translation>Ensayos, equipos, robots, etiquetas y variables con todas estas palabras</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Indicadores</translation>
    </message>
    <message>
        <source>Which metrics are shown</source>
        <translation>Qué indicadores se muestran</translation>
    </message>
    <message>
        <source>&amp;Save table…</source>
        <translation>&amp;Guardar tabla…</translation>
    </message>
    <message>
        <source>&amp;Copy with headings</source>
        <translation>&amp;Copiar con encabezados</translation>
    </message>
    <message>
        <source>By team</source>
        <translation>Por equipo</translation>
    </message>
    <message>
        <source>By class</source>
        <translation>Por clase</translation>
    </message>
    <message>
        <source>By task</source>
        <translation>Por tarea</translation>
    </message>
    <message>
        <source>By robot</source>
        <translation>Por robot</translation>
    </message>
    <message>
        <source>By %1</source>
        <translation>Por %1</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n recorrido</numerusform>
            <numerusform>%n recorridos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n run(s)</source>
        <translation>
            <numerusform>%1 de %n recorrido</numerusform>
            <numerusform>%1 de %n recorridos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Statistics of %n run(s) shown</source>
        <translation>
            <numerusform>Estadística de %n recorrido mostrado</numerusform>
            <numerusform>Estadística de %n recorridos mostrados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Statistics of %n selected run(s)</source>
        <translation>
            <numerusform>Estadística de %n recorrido seleccionado</numerusform>
            <numerusform>Estadística de %n recorridos seleccionados</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>Guardar la tabla</translation>
    </message>
    <message>
        <source>Workbook with statistics (*.xlsx)</source>
        <translation>Libro con estadística (*.xlsx)</translation>
    </message>
    <message>
        <source>CSV for programs (*.csv)</source>
        <translation>CSV para programas (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1.5 (*.csv)</source>
        <translation>CSV para hojas de cálculo, 1.5 (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1,5 (*.csv)</source>
        <translation>CSV para hojas de cálculo, 1,5 (*.csv)</translation>
    </message>
</context>
<context>
    <name>odo::ReviewColumn</name>
    <message>
        <source>Trial</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>Facts of the trial</source>
        <translation>Datos del ensayo</translation>
    </message>
    <message>
        <source>This trial has not been tracked yet. Tracking follows the robot through the videos and computes its position and speed.</source>
        <translation>Este ensayo aún no se ha rastreado. El rastreo sigue al robot a través de los videos y calcula dónde estuvo y a qué velocidad.</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>Rastrear…</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>The areas have changed since this trial was tracked. Track it again to use them.</source>
        <translation>Las zonas han cambiado desde que se siguió este ensayo. Vuelva a seguirlo para usarlas.</translation>
    </message>
</context>
<context>
    <name>odo::ReviewDesk</name>
    <message>
        <source>&amp;Silhouettes of the robots</source>
        <translation>&amp;Siluetas de los robots</translation>
    </message>
    <message>
        <source>Outline the detected robots in each view</source>
        <translation>Dibuja en cada vista el contorno de lo que se tomó por un robot</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Acerca&amp;r</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>A&amp;lejar</translation>
    </message>
    <message>
        <source>Zoom to &amp;fit</source>
        <translation>A&amp;justar</translation>
    </message>
    <message>
        <source>&amp;Enlarge, or back</source>
        <translation>Ma&amp;ximizar vista, o volver</translation>
    </message>
    <message>
        <source>Of the view or map under the mouse</source>
        <translation>De la vista o el mapa bajo el ratón</translation>
    </message>
    <message>
        <source>Lo&amp;upe on the robot</source>
        <translation>L&amp;upa sobre el robot</translation>
    </message>
    <message>
        <source>Show the surroundings of the robot eight times as large as recorded</source>
        <translation>Mostrar el entorno del robot ocho veces más grande que en la grabación</translation>
    </message>
    <message>
        <source>&amp;Present</source>
        <translation>&amp;Presentar</translation>
    </message>
    <message>
        <source>Team, map, speed and result in large type, on a second screen if there is one</source>
        <translation>Equipo, mapa, velocidad y resultado en letra grande, en una segunda pantalla si la hay</translation>
    </message>
</context>
<context>
    <name>odo::ReviewPage</name>
    <message>
        <source>No trials yet</source>
        <translation>Aún no hay ensayos</translation>
    </message>
    <message>
        <source>A trial is one run of a robot. Import the videos that your cameras took of it to see it here.</source>
        <translation>Un ensayo es un recorrido de un robot. Importe los videos que sus cámaras tomaron de él y se mostrará aquí.</translation>
    </message>
    <message>
        <source>Import trial from videos…</source>
        <translation>Importar ensayo de videos…</translation>
    </message>
    <message>
        <source>Accept doubtful results</source>
        <translation>Aceptar resultados dudosos</translation>
    </message>
    <message>
        <source>Why can these results be used? The reason is shown wherever they are.</source>
        <translation>¿Por qué se pueden usar estos resultados? El motivo se muestra dondequiera que aparezcan.</translation>
    </message>
</context>
<context>
    <name>odo::RevisionImage</name>
    <message>
        <source>Source image</source>
        <translation>Imagen a partir de la cual se hizo</translation>
    </message>
    <message>
        <source>Reading the image…</source>
        <translation>Leyendo la imagen…</translation>
    </message>
    <message>
        <source>Cannot read the image.</source>
        <translation>La imagen no se puede leer.</translation>
    </message>
</context>
<context>
    <name>odo::RevisionsDialog</name>
    <message>
        <source>&amp;Use this one</source>
        <translation>&amp;Usar esta</translation>
    </message>
    <message>
        <source>&amp;Register with this calibration</source>
        <translation>&amp;Registrar con esta lente</translation>
    </message>
    <message>
        <source>Reanalyse &amp;trials…</source>
        <translation>&amp;Volver a medir ensayos…</translation>
    </message>
    <message>
        <source>Calibrations and registrations</source>
        <translation>Calibraciones y registros</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Hecho</translation>
    </message>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Vigente</translation>
    </message>
    <message>
        <source>Revisions</source>
        <translation>Revisiones</translation>
    </message>
    <message>
        <source>Makes the selected revision the current one for new measurements; trials keep theirs</source>
        <translation>Pone en vigor la revisión elegida para lo que se mida desde ahora; los ensayos conservan la suya</translation>
    </message>
    <message>
        <source>Recomputes the current registration from the same markers, with the current lens calibration</source>
        <translation>Calcula de nuevo el registro vigente con los mismos marcadores y la lente vigente</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>Cá&amp;mara</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>The camera is neither calibrated nor registered yet.</source>
        <translation>La cámara aún no está calibrada ni registrada.</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Calibration %1</source>
        <translation>Calibración %1</translation>
    </message>
    <message>
        <source>Registration %1</source>
        <translation>Registro %1</translation>
    </message>
    <message>
        <source>current</source>
        <translation>vigente</translation>
    </message>
    <message>
        <source>No trial uses it.</source>
        <translation>Ningún ensayo se midió con ella.</translation>
    </message>
    <message>
        <source>Trials that use it: %1.</source>
        <translation>Ensayos medidos con ella: %1.</translation>
    </message>
    <message>
        <source>%1 is now current. The registrations keep the lens calibration that they were made with: register the camera with this one.</source>
        <translation>Vigente ahora: %1. Los registros conservan la lente con la que se hicieron: registre la cámara con esta.</translation>
    </message>
    <message>
        <source>%1 is now current. Trials keep theirs until you reanalyse them.</source>
        <translation>Vigente ahora: %1. Los ensayos conservan la suya hasta que se vuelvan a medir.</translation>
    </message>
    <message>
        <source>Registration %1 is now current: the same markers, with this lens calibration. %2</source>
        <translation>El registro %1 está vigente: los mismos marcadores, con esta lente. %2</translation>
    </message>
</context>
<context>
    <name>odo::RobotDialog</name>
    <message>
        <source>Add robot</source>
        <translation>Añadir robot</translation>
    </message>
    <message>
        <source>Estimated from the views</source>
        <translation>Hallada con las vistas</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medida</translation>
    </message>
    <message>
        <source>Changes while it runs (ramp)</source>
        <translation>Cambia durante el recorrido (rampa)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Height of the robot&apos;s top</source>
        <translation>Altura de la cara superior del robot</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>&amp;Pick from a video…</source>
        <translation>De una &amp;imagen…</translation>
    </message>
    <message>
        <source>&amp;Colour of its top</source>
        <translation>&amp;Color de la cara superior</translation>
    </message>
    <message>
        <source>&amp;Drawn in</source>
        <translation>&amp;Dibujado en</translation>
    </message>
    <message>
        <source>&amp;Height of its top</source>
        <translation>&amp;Altura superior</translation>
    </message>
    <message>
        <source>Colour of the robot&apos;s top</source>
        <translation>Color de la cara superior del robot</translation>
    </message>
    <message>
        <source>Change robot</source>
        <translation>Cambiar robot</translation>
    </message>
    <message>
        <source>Its silhouette</source>
        <translation>Lo que lo distingue del suelo</translation>
    </message>
    <message>
        <source>A colour of its own</source>
        <translation>Un color propio</translation>
    </message>
    <message>
        <source>The silhouette works for any robot. A colour of its own helps if several things move.</source>
        <translation>Un robot de cualquier aspecto se encuentra por lo que lo distingue del suelo. Un color propio ayuda cuando se mueven varias cosas.</translation>
    </message>
    <message>
        <source>D&amp;etected by</source>
        <translation>&amp;Se encuentra por</translation>
    </message>
    <message>
        <source>Colour in charts and maps; the robot itself may have another</source>
        <translation>En gráficos y mapas, sea cual sea el aspecto del robot</translation>
    </message>
    <message>
        <source>Offset from the middle of the robot&apos;s footprint; 0 and 0 is the middle itself.</source>
        <translation>Desde el centro de lo que el robot cubre del suelo; 0 y 0 es el propio centro.</translation>
    </message>
    <message>
        <source> mm forward</source>
        <translation> mm adelante</translation>
    </message>
    <message>
        <source>Reference point, forward of the robot&apos;s middle</source>
        <translation>Punto medido, por delante del centro del robot</translation>
    </message>
    <message>
        <source> mm left</source>
        <translation> mm a la izquierda</translation>
    </message>
    <message>
        <source>Reference point, left of the robot&apos;s middle</source>
        <translation>Punto medido, a la izquierda del centro del robot</translation>
    </message>
    <message>
        <source>&amp;Reference point</source>
        <translation>&amp;Punto medido</translation>
    </message>
</context>
<context>
    <name>odo::RobotFootprint</name>
    <message>
        <source>The robot from above, heading to the right</source>
        <translation>El robot visto desde arriba, orientado a la derecha</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>No size given. Drawn as %1 × %2 mm</source>
        <translation>Sin tamaño indicado. Dibujado como %1 × %2 mm</translation>
    </message>
</context>
<context>
    <name>odo::RobotPointing</name>
    <message>
        <source>&amp;Point out a robot</source>
        <translation>&amp;Señalar un robot</translation>
    </message>
    <message>
        <source>Wrong object outlined? Click the robot in a view to track the trial again (%1)</source>
        <translation>Está marcado algo equivocado: haga clic en el robot en una imagen y el ensayo se seguirá de nuevo (%1)</translation>
    </message>
    <message>
        <source>This is %1: track it again</source>
        <translation>Este es %1: seguirlo de nuevo</translation>
    </message>
    <message>
        <source>Find %1 automatically</source>
        <translation>Buscar %1 sin ayuda</translation>
    </message>
</context>
<context>
    <name>odo::RobotsDialog</name>
    <message>
        <source>estimated from the views</source>
        <translation>hallada con las vistas</translation>
    </message>
    <message>
        <source>changes while it runs</source>
        <translation>cambia durante el recorrido</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Añadir…</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Editar…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>E&amp;liminar</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Drawn in</source>
        <translation>Dibujado en</translation>
    </message>
    <message>
        <source>Height of its top</source>
        <translation>Altura superior</translation>
    </message>
    <message>
        <source>Length × width</source>
        <translation>Largo × ancho</translation>
    </message>
    <message>
        <source>A new colour or height applies from the next tracking on; earlier results stay as they are.</source>
        <translation>Otro color u otra altura cuentan desde el próximo rastreo; lo medido antes queda como está.</translation>
    </message>
    <message>
        <source>Latest change</source>
        <translation>Lo que se hizo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>its silhouette</source>
        <translation>su silueta</translation>
    </message>
    <message>
        <source>Detected by</source>
        <translation>Se encuentra por</translation>
    </message>
</context>
<context>
    <name>odo::RunCard</name>
    <message>
        <source>Up now</source>
        <translation>En turno</translation>
    </message>
    <message>
        <source>Robots of this run</source>
        <translation>Robots en movimiento</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>&amp;Clase</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>Equi&amp;po</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>&amp;Tarea</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>R&amp;obots</translation>
    </message>
    <message>
        <source>Trial &amp;name</source>
        <translation>&amp;Nombre del ensayo</translation>
    </message>
    <message>
        <source>Be&amp;gins</source>
        <translation>&amp;Inicio</translation>
    </message>
    <message>
        <source>&amp;Laps</source>
        <translation>V&amp;ueltas</translation>
    </message>
    <message>
        <source>Number of laps</source>
        <translation>Vueltas hasta que termina</translation>
    </message>
    <message>
        <source>Team of this run</source>
        <translation>Equipo en turno</translation>
    </message>
    <message>
        <source>When the recording begins</source>
        <translation>Cómo empieza la grabación</translation>
    </message>
    <message>
        <source>no class</source>
        <translation>sin clase</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>no team</source>
        <translation>sin equipo</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>al momento</translation>
    </message>
    <message>
        <source>after a countdown of %1 s</source>
        <translation>tras una cuenta regresiva de %1 s</translation>
    </message>
    <message>
        <source>when the robot passes the start</source>
        <translation>cuando el robot pasa la salida</translation>
    </message>
</context>
<context>
    <name>odo::RunChooser</name>
    <message>
        <source>start gate</source>
        <translation>puerta de salida</translation>
    </message>
    <message>
        <source>onset of motion</source>
        <translation>inicio del movimiento</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>a mano</translation>
    </message>
    <message>
        <source>First run</source>
        <translation>Primer recorrido</translation>
    </message>
    <message>
        <source>Second run</source>
        <translation>Segundo recorrido</translation>
    </message>
    <message>
        <source>How to align the runs</source>
        <translation>El instante que cuenta como el mismo</translation>
    </message>
    <message>
        <source>Swap the two runs</source>
        <translation>Intercambiar los dos recorridos</translation>
    </message>
    <message>
        <source>Add more runs</source>
        <translation>Más recorridos</translation>
    </message>
    <message>
        <source>&amp;Shift</source>
        <translation>&amp;Desfase</translation>
    </message>
    <message>
        <source>Distan&amp;ce</source>
        <translation>&amp;Lugar</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time shift of the second run; positive: later</source>
        <translation>Cuánto más tarde está el instante del segundo recorrido</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>first common point</source>
        <translation>donde todos han empezado</translation>
    </message>
    <message>
        <source>Distance along the path at which the runs are aligned</source>
        <translation>En qué punto del camino se considera que los recorridos están en el mismo instante</translation>
    </message>
    <message>
        <source>F&amp;irst</source>
        <translation>&amp;Primero</translation>
    </message>
    <message>
        <source>Seco&amp;nd</source>
        <translation>Se&amp;gundo</translation>
    </message>
    <message>
        <source>&amp;Align by</source>
        <translation>Al&amp;inear por</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automático: %1</translation>
    </message>
    <message>
        <source>No more runs</source>
        <translation>No hay más recorridos</translation>
    </message>
</context>
<context>
    <name>odo::RunResultCard</name>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>&amp;Open in Review</source>
        <translation>A&amp;brir en Revisar</translation>
    </message>
    <message>
        <source>The results appear here shortly after the run ends.</source>
        <translation>Los indicadores de un recorrido aparecen aquí un momento después de que termina.</translation>
    </message>
    <message>
        <source>Analysing…</source>
        <translation>Midiendo…</translation>
    </message>
    <message>
        <source>Spikes flagged</source>
        <translation>Atípicos señalados</translation>
    </message>
    <message>
        <source>From live tracking. The final results follow shortly, from the recording.</source>
        <translation>Del rastreo en vivo. Los indicadores definitivos vienen de la grabación, en un momento.</translation>
    </message>
    <message>
        <source>Final, from every frame of the recording.</source>
        <translation>Definitivos, de todas las imágenes de la grabación.</translation>
    </message>
</context>
<context>
    <name>odo::RunResults</name>
    <message>
        <source>%1 is analysed.</source>
        <translation>%1 está medido.</translation>
    </message>
    <message>
        <source>Recorded, but not analysed: %1</source>
        <translation>Está grabado, pero no se pudo medir: %1</translation>
    </message>
    <message>
        <source>%1 is recorded.</source>
        <translation>%1 está grabado.</translation>
    </message>
    <message>
        <source>Recording failed: %1</source>
        <translation>No se pudo grabar: %1</translation>
    </message>
</context>
<context>
    <name>odo::SampleModel</name>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>± Speed</source>
        <translation>± Velocidad</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>± Acceleration</source>
        <translation>± Aceleración</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Rumbo</translation>
    </message>
    <message>
        <source>± Heading</source>
        <translation>± Rumbo</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Velocidad de giro</translation>
    </message>
    <message>
        <source>± Turn rate</source>
        <translation>± Velocidad de giro</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>Distancia recorrida</translation>
    </message>
    <message>
        <source>Measured x</source>
        <translation>x medida</translation>
    </message>
    <message>
        <source>Measured y</source>
        <translation>y medida</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>Flags</source>
        <translation>Marcas</translation>
    </message>
</context>
<context>
    <name>odo::SampleTable</name>
    <message>
        <source>Data</source>
        <translation>Datos</translation>
    </message>
    <message>
        <source>Samples of the run</source>
        <translation>Muestras del recorrido</translation>
    </message>
    <message>
        <source>&amp;Copy with headings</source>
        <translation>&amp;Copiar con encabezados</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Columnas</translation>
    </message>
    <message>
        <source>Which columns are shown</source>
        <translation>Qué columnas se muestran</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n muestra</numerusform>
            <numerusform>%n muestras</numerusform>
        </translation>
    </message>
    <message>
        <source>Not tracked yet</source>
        <translation>Aún sin rastrear</translation>
    </message>
</context>
<context>
    <name>odo::ScoreboardDialog</name>
    <message>
        <source>&amp;Copy address</source>
        <translation>&amp;Copiar dirección</translation>
    </message>
    <message>
        <source>&amp;Open in browser</source>
        <translation>&amp;Abrir en el navegador</translation>
    </message>
    <message>
        <source>Standings as a web page</source>
        <translation>Clasificación como página web</translation>
    </message>
    <message>
        <source>Show the standings on a projector or on phones. The page follows the project as long as this window is open.</source>
        <translation>Muestre la clasificación en un proyector o en teléfonos. La página sigue al proyecto mientras esta ventana esté abierta.</translation>
    </message>
    <message>
        <source>C&amp;lass:</source>
        <translation>C&amp;lase:</translation>
    </message>
    <message>
        <source>&amp;Task:</source>
        <translation>&amp;Tarea:</translation>
    </message>
    <message>
        <source>&amp;Visible to:</source>
        <translation>&amp;Visible para:</translation>
    </message>
    <message>
        <source>Address of the page</source>
        <translation>Dirección de la página</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>Todas las clases</translation>
    </message>
    <message>
        <source>Task of the newest trial</source>
        <translation>Tarea del ensayo más reciente</translation>
    </message>
    <message>
        <source>This computer only</source>
        <translation>Solo este equipo</translation>
    </message>
    <message>
        <source>All devices in the network</source>
        <translation>Todos los equipos de la red</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Iniciando…</translation>
    </message>
    <message>
        <source>Everyone in the network can open this page. It shows the names of teams, classes and tasks, and no others.</source>
        <translation>Cualquiera en la red puede abrir esta página. Solo muestra nombres de equipos, clases y tareas.</translation>
    </message>
    <message>
        <source>Only this computer can open this page.</source>
        <translation>Solo este equipo puede abrir esta página.</translation>
    </message>
</context>
<context>
    <name>odo::ScoringTable</name>
    <message>
        <source>Remo&amp;ve line</source>
        <translation>&amp;Quitar línea</translation>
    </message>
    <message>
        <source>Each line gives all its points if the metric reaches the first bound, none at the second bound or worse, and a proportional share between them. Negative points are a penalty.</source>
        <translation>Cada línea da todos sus puntos si el indicador está en un límite o mejor, ninguno si está en el otro o peor, y en proporción entre ambos. Los puntos por debajo de cero son una penalización.</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Indicador</translation>
    </message>
    <message>
        <source>All points at</source>
        <translation>Todos con</translation>
    </message>
    <message>
        <source>None at</source>
        <translation>Ninguno con</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Lines of the scoring</source>
        <translation>Líneas de la puntuación</translation>
    </message>
    <message>
        <source>What the lines mean</source>
        <translation>Qué significan las líneas</translation>
    </message>
    <message>
        <source>&amp;Add line</source>
        <translation>Añadi&amp;r línea</translation>
    </message>
    <message>
        <source>Scored metric</source>
        <translation>Indicador que cuenta</translation>
    </message>
    <message>
        <source>Without a line, runs of the task are not scored.</source>
        <translation>Sin ninguna línea, los recorridos de la tarea no se puntúan.</translation>
    </message>
    <message>
        <source>Total: %1 points.</source>
        <translation>En total, %1 puntos.</translation>
    </message>
</context>
<context>
    <name>odo::SeriesKey</name>
    <message>
        <source>Legend</source>
        <translation>Leyenda de las líneas</translation>
    </message>
    <message>
        <source>%1: click to hide or show</source>
        <translation>%1: haga clic para ocultar o mostrar</translation>
    </message>
</context>
<context>
    <name>odo::SharedField</name>
    <message>
        <source>several</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>%1: several</source>
        <translation>%1: varios</translation>
    </message>
    <message>
        <source>The trials differ here. Press to enter one value for all of them.</source>
        <translation>Los ensayos difieren aquí. Pulse para introducir un valor para todos.</translation>
    </message>
</context>
<context>
    <name>odo::SharedPointsPage</name>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Image of the camera to register; arrow keys move the selected point</source>
        <translation>Imagen de la cámara por registrar; las flechas mueven el punto elegido</translation>
    </message>
    <message>
        <source>Image of the registered camera; arrow keys move the selected point</source>
        <translation>Imagen de la cámara registrada; las flechas mueven el punto elegido</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Seen in</source>
        <translation>Visto en</translation>
    </message>
    <message>
        <source>On the floor, mm</source>
        <translation>En el suelo, mm</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Floor points</source>
        <translation>Puntos del suelo</translation>
    </message>
    <message>
        <source>Camera %1, to be registered</source>
        <translation>Cámara %1, por registrar</translation>
    </message>
    <message>
        <source>Camera %1, registered</source>
        <translation>Cámara %1, registrada</translation>
    </message>
    <message>
        <source>P%1</source>
        <comment>a point</comment>
        <translation>P%1</translation>
    </message>
    <message>
        <source>Click a floor point in the left image, then the same point in the right image. A click snaps to what is near it, to a tenth of a pixel; arrow keys move the selected point, Space snaps it.</source>
        <translation>Haga clic en un punto del suelo en la imagen izquierda y después en el mismo en la derecha. Lo que haya cerca del clic se localiza hasta la décima de píxel; las flechas mueven el punto elegido, Espacio lo ajusta.</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>beyond the horizon</source>
        <translation>más allá del horizonte</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>both images</source>
        <translation>ambas imágenes</translation>
    </message>
    <message>
        <source>left only</source>
        <translation>solo izquierda</translation>
    </message>
    <message>
        <source>right only</source>
        <translation>solo derecha</translation>
    </message>
    <message>
        <source>not set yet</source>
        <translation>aún sin colocar</translation>
    </message>
</context>
<context>
    <name>odo::SmoothingPanel</name>
    <message>
        <source>%1: measured for less than a second</source>
        <translation>%1: medido menos de un segundo</translation>
    </message>
    <message>
        <source>%1: smoothed automatically like a filter with a cut-off of %2; what it takes away is %3 of each coordinate</source>
        <translation>%1: suavizado automáticamente como con un filtro de corte %2; quita %3 de cada coordenada</translation>
    </message>
    <message>
        <source>%1: the smoother states no cut-off</source>
        <translation>%1: el suavizado no indica ningún corte</translation>
    </message>
    <message>
        <source>Noise of the measurements by their residuals: %1; stated: %2</source>
        <translation>Ruido de las medidas según sus residuos: %1; indicado: %2</translation>
    </message>
    <message>
        <source>Cut-off by residual analysis: %1</source>
        <translation>Corte según el análisis de residuos: %1</translation>
    </message>
    <message>
        <source>Residual analysis gives no cut-off: the residuals are not those of noise.</source>
        <translation>El análisis de residuos no da ningún corte: los residuos no son los de un ruido.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>residual of a Butterworth filter, by its cut-off</source>
        <translation>residuo de un filtro Butterworth según su corte</translation>
    </message>
    <message>
        <source>Smoothing of the robots</source>
        <translation>Suavizado de los robots</translation>
    </message>
    <message>
        <source>No curve yet: track the trial.</source>
        <translation>Aún no hay curva: rastree el ensayo.</translation>
    </message>
</context>
<context>
    <name>odo::SoundChart</name>
    <message>
        <source>Loudness</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Loudness of both views</source>
        <translation>Volumen de ambas vistas</translation>
    </message>
</context>
<context>
    <name>odo::SpikeActions</name>
    <message>
        <source>&amp;Use sample</source>
        <translation>&amp;Usar</translation>
    </message>
    <message>
        <source>Mark the sample at this moment as valid and use it, even if it was flagged</source>
        <translation>Lo medido en este instante es correcto y debe usarse, aunque haya indicios en contra</translation>
    </message>
    <message>
        <source>Mark as &amp;spike</source>
        <translation>Es atí&amp;pico</translation>
    </message>
    <message>
        <source>Mark the sample at this moment as a spike and do not use it</source>
        <translation>Lo medido en este instante es erróneo y no debe usarse</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automático</translation>
    </message>
    <message>
        <source>Remove the manual override at this moment</source>
        <translation>Revierte lo que se indicó a mano en este instante</translation>
    </message>
</context>
<context>
    <name>odo::SpikeList</name>
    <message>
        <source>Spikes</source>
        <translation>Valores atípicos</translation>
    </message>
    <message>
        <source>Spikes with time and reason</source>
        <translation>Valores atípicos con tiempo y motivo</translation>
    </message>
    <message>
        <source>Select all with this &amp;reason</source>
        <translation>Seleccionar todos con este &amp;motivo</translation>
    </message>
    <message>
        <source>Select all in the selected ra&amp;nge</source>
        <translation>Seleccionar todos en el tra&amp;mo seleccionado</translation>
    </message>
    <message>
        <source>Select all spikes of this robot that have the reason of the selected one</source>
        <translation>Seleccionar todos los atípicos de este robot que tienen el motivo del seleccionado</translation>
    </message>
    <message>
        <source>Select all spikes of this robot within the selection on the time line</source>
        <translation>Seleccionar todos los atípicos de este robot dentro de la selección de la línea de tiempo</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n seleccionado</numerusform>
            <numerusform>%n seleccionados</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::SpikeModel</name>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>%1 flagged</source>
        <translation>%1 señalados</translation>
    </message>
    <message>
        <source>%1 restored</source>
        <translation>%1 restaurados</translation>
    </message>
    <message>
        <source>used, by hand</source>
        <translation>usada, a mano</translation>
    </message>
    <message>
        <source>%1 (restored by hand)</source>
        <translation>%1 (restaurado a mano)</translation>
    </message>
    <message>
        <source>Restored by hand</source>
        <translation>Restaurado a mano</translation>
    </message>
    <message>
        <source>Flagged, not used for the curve</source>
        <translation>Señalado, no se usa para la curva</translation>
    </message>
    <message>
        <source>Flagged, still used for the curve</source>
        <translation>Señalado, aún se usa para la curva</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>%1 ambiguous</source>
        <translation>%1 en duda</translation>
    </message>
    <message>
        <source>%1 hidden</source>
        <translation>%1 con ocultación</translation>
    </message>
    <message>
        <source>%1 not measured</source>
        <translation>%1 sin medir</translation>
    </message>
</context>
<context>
    <name>odo::StandingsModel</name>
    <message>
        <source>choose a task</source>
        <translation>elija una tarea</translation>
    </message>
    <message>
        <source>needs three trials at different times</source>
        <translation>desde tres momentos distintos</translation>
    </message>
    <message>
        <source>within the spread (%1)</source>
        <translation>dentro de la dispersión (%1)</translation>
    </message>
    <message>
        <source>better: %1</source>
        <translation>mejor: %1</translation>
    </message>
    <message>
        <source>worse: %1</source>
        <translation>peor: %1</translation>
    </message>
    <message>
        <source>one trial</source>
        <translation>un ensayo</translation>
    </message>
    <message>
        <source>One more than the number of significantly better teams (medians differ by more than 1.96 σ). Runs of different tasks are not ranked</source>
        <translation>Uno más que los equipos mejores sin lugar a dudas: sus medianas difieren más de 1,96 σ. Los recorridos de tareas distintas no se clasifican</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Puesto</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Mejor</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>Repeatability: standard deviation of one trial about the line of progress</source>
        <translation>Repetibilidad: desviación estándar de un ensayo respecto a la recta de progreso</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Dispersión</translation>
    </message>
    <message>
        <source>Change over the term by a straight-line fit; Student&apos;s t-test (95 %) decides if it exceeds the spread</source>
        <translation>Cambio a lo largo del periodo según una recta; más allá de la dispersión según la prueba t de Student, 95 %</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n doubtful</source>
        <translation>
            <numerusform>%1, %n dudoso</numerusform>
            <numerusform>%1, %n dudosos</numerusform>
        </translation>
    </message>
    <message>
        <source>Those with bad results do not count</source>
        <translation>Los que tienen resultados malos no cuentan</translation>
    </message>
    <message>
        <source>± from the spread of all teams&apos; trials, at least that of the measurement</source>
        <translation>± según la dispersión de los ensayos de todos los equipos, como mínimo el de la medición</translation>
    </message>
</context>
<context>
    <name>odo::StartActions</name>
    <message>
        <source>Registered to the floor mat: %1.</source>
        <translation>Registradas con la alfombrilla: %1.</translation>
    </message>
    <message>
        <source>Their newest recordings do not show it: %1.</source>
        <translation>Sus grabaciones más recientes no la muestran: %1.</translation>
    </message>
</context>
<context>
    <name>odo::StartCard</name>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
    <message>
        <source>&amp;Record or stop</source>
        <translation>&amp;Grabar o detener</translation>
    </message>
    <message>
        <source>Recorded time</source>
        <translation>Tiempo grabado</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>Writing the last frames…</source>
        <translation>Escribiendo las últimas imágenes…</translation>
    </message>
    <message>
        <source>F9 records, F9 stops</source>
        <translation>F9 graba, F9 detiene</translation>
    </message>
    <message>
        <source>F9 records, F9 stops; %1</source>
        <translation>F9 graba, F9 detiene; %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anular</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>en %1</translation>
    </message>
    <message>
        <source>Get ready</source>
        <translation>Prepárese</translation>
    </message>
    <message>
        <source>Waiting for the robot at “%1”. The recording will include the second before</source>
        <translation>Esperando al robot en “%1”; se graba desde un segundo antes</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
</context>
<context>
    <name>odo::StartPage</name>
    <message>
        <source>Cameras or clips</source>
        <translation>Cámaras o videos</translation>
    </message>
    <message>
        <source>Import clips…</source>
        <translation>Importar videos…</translation>
    </message>
    <message>
        <source>Connect cameras</source>
        <translation>Conectar cámaras</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>Find the mat in the clips…</source>
        <translation>Buscar la alfombrilla en los videos…</translation>
    </message>
    <message>
        <source>Print a mat…</source>
        <translation>Imprimir una alfombrilla…</translation>
    </message>
    <message>
        <source>Use other markers…</source>
        <translation>Usar otros marcadores…</translation>
    </message>
    <message>
        <source>Lens (optional)</source>
        <translation>Objetivo (opcional)</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Calibrar…</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Add a robot…</source>
        <translation>Añadir un robot…</translation>
    </message>
    <message>
        <source>First run</source>
        <translation>Primer recorrido</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>Rastrear…</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Informe…</translation>
    </message>
    <message>
        <source>From clips to a first result</source>
        <translation>De los videos al primer resultado</translation>
    </message>
    <message>
        <source>Steps to a first result</source>
        <translation>Pasos hasta un primer resultado</translation>
    </message>
</context>
<context>
    <name>odo::StatusLine</name>
    <message>
        <source>No trial</source>
        <translation>Sin ensayo</translation>
    </message>
    <message>
        <source>Not tracked yet</source>
        <translation>Aún sin rastrear</translation>
    </message>
    <message>
        <source>Analysis %1, Odograph %2</source>
        <translation>Análisis %1, Odograph %2</translation>
    </message>
    <message>
        <source>Units of lengths, speeds and times; change them in the preferences</source>
        <translation>Unidades de longitudes, velocidades y tiempos; se eligen en las preferencias</translation>
    </message>
    <message>
        <source>No project is open</source>
        <translation>No hay ningún proyecto abierto</translation>
    </message>
    <message>
        <source>Read only: nothing can be changed</source>
        <translation>Solo lectura: no se puede cambiar nada</translation>
    </message>
    <message>
        <source>All changes saved</source>
        <translation>Todos los cambios guardados</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Guardando…</translation>
    </message>
    <message>
        <source>The school&apos;s hub</source>
        <translation>El servidor de la escuela</translation>
    </message>
    <message>
        <source>%1. Click for more about the school&apos;s hub</source>
        <translation>%1. Haga clic para saber más del servidor de la escuela</translation>
    </message>
</context>
<context>
    <name>odo::StepDialog</name>
    <message>
        <source>&lt; &amp;Back</source>
        <translation>&lt; &amp;Atrás</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>paso %1 de %2</translation>
    </message>
    <message>
        <source>&amp;Next &gt;</source>
        <translation>&amp;Siguiente &gt;</translation>
    </message>
    <message>
        <source>Discard %1?</source>
        <translation>¿Descartar %1?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Descartar</translation>
    </message>
    <message>
        <source>&amp;Keep working</source>
        <translation>&amp;Seguir</translation>
    </message>
</context>
<context>
    <name>odo::StepRow</name>
    <message>
        <source>Done. %1</source>
        <translation>Hecho. %1</translation>
    </message>
</context>
<context>
    <name>odo::SynchroniseDialog</name>
    <message>
        <source>Synchronise %1</source>
        <translation>Sincronizar %1</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>%1 ahora</translation>
    </message>
    <message>
        <source>&amp;Synchronise</source>
        <translation>&amp;Sincronizar</translation>
    </message>
    <message>
        <source>Synchronise</source>
        <translation>Sincronizar</translation>
    </message>
    <message>
        <source>What was tracked in the trial is reanalysed. Choose Undo to return to the synchronisation that it has now.</source>
        <translation>Lo que se siguió en el ensayo se analiza de nuevo. «Deshacer» devuelve la sincronización actual.</translation>
    </message>
    <message>
        <source>The sound of the videos is being read…</source>
        <translation>Leyendo el sonido de los vídeos…</translation>
    </message>
    <message>
        <source>Sound of the first view above, of the other one below. Drag it until both show the same clap at one time; the wheel zooms.</source>
        <translation>Sonido de la primera vista arriba, de la otra abajo. Arrástrelo hasta que ambos muestren la misma palmada al mismo tiempo; la rueda amplía.</translation>
    </message>
    <message>
        <source>There is no sound in both views to compare.</source>
        <translation>No hay sonido en ambas vistas que comparar.</translation>
    </message>
    <message>
        <source>Frames or sound</source>
        <translation>Fotogramas o sonido</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>&amp;Fotogramas</translation>
    </message>
    <message>
        <source>S&amp;ound</source>
        <translation>S&amp;onido</translation>
    </message>
</context>
<context>
    <name>odo::TargetDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Inner corners along the board</source>
        <translation>Esquinas interiores a lo largo del tablero</translation>
    </message>
    <message>
        <source>Inner corners across the board</source>
        <translation>Esquinas interiores a lo ancho del tablero</translation>
    </message>
    <message>
        <source>Print targets</source>
        <translation>Imprimir patrones</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>&amp;Guardar como PDF…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Imprimir…</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>Tablero de ajedrez</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>Tablero ChArUco</translation>
    </message>
    <message>
        <source>Floor markers: tags</source>
        <translation>Marcadores de suelo: AprilTags</translation>
    </message>
    <message>
        <source>Floor markers: rings</source>
        <translation>Marcadores de suelo: anillos</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Carta</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>&amp;Target</source>
        <translation>&amp;Patrón</translation>
    </message>
    <message>
        <source>Pape&amp;r</source>
        <translation>Pape&amp;l</translation>
    </message>
    <message>
        <source>&amp;Inner corners</source>
        <translation>Esqui&amp;nas interiores</translation>
    </message>
    <message>
        <source>S&amp;quare</source>
        <translation>&amp;Casilla</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Tamaño</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Rótulos</translation>
    </message>
    <message>
        <source>What is printed</source>
        <translation>Lo que se imprime</translation>
    </message>
    <message>
        <source>One sheet. Afterwards measure a square on the paper: printers often shrink by 2 to 4 %.</source>
        <translation>Una hoja. Después mida una casilla en el papel: las impresoras suelen reducir de un 2 a un 4 %.</translation>
    </message>
    <message>
        <source>One sheet for each marker. A tag&apos;s number is the position of its label in the layout.</source>
        <translation>Una hoja por marcador. El número de un AprilTag es la posición de su rótulo en el plano.</translation>
    </message>
    <message>
        <source>Save targets</source>
        <translation>Guardar patrones</translation>
    </message>
    <message>
        <source>targets.pdf</source>
        <translation>patrones.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Guardado como %1.</translation>
    </message>
    <message>
        <source>Sent to the printer.</source>
        <translation>Enviado a la impresora.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Sheets in a row of the mat</source>
        <translation>Hojas en una fila de la alfombrilla</translation>
    </message>
    <message>
        <source>Rows of the mat</source>
        <translation>Filas de la alfombrilla</translation>
    </message>
    <message>
        <source>Floor mat</source>
        <translation>Alfombrilla</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>&amp;Hojas</translation>
    </message>
    <message>
        <source>A plan and %1 sheets, to be taped together to a mat of %2 × %3 m. Its markers are known: nothing on the floor needs to be measured. The larger the mat, the more exact the floor.</source>
        <translation>Un plano y %1 hojas, que se pegan para formar una alfombrilla de %2 × %3 m. Sus marcadores son conocidos: no hay que medir nada en el suelo. Cuanto mayor es la alfombrilla, más exacto es el suelo.</translation>
    </message>
</context>
<context>
    <name>odo::TargetPreview</name>
    <message>
        <source>Preview of the sheets</source>
        <translation>Vista previa de las hojas</translation>
    </message>
</context>
<context>
    <name>odo::TaskCanvas</name>
    <message>
        <source>The task from above</source>
        <translation>La tarea vista desde arriba</translation>
    </message>
    <message>
        <source>Drag a gate or one of its ends, a zone&apos;s edge or corner. Keys: Page Up and Down choose a gate or a zone, arrows move it (Shift: 100 mm, Ctrl: 1 mm), &lt; and &gt; turn it, + and − change its width</source>
        <translation>Arrastre una puerta o uno de sus extremos, el borde o la esquina de una zona. Teclas: Re Pág y Av Pág eligen una puerta o una zona, las flechas la mueven (Mayús: 100 mm, Ctrl: 1 mm), &lt; y &gt; la giran, + y − cambian su ancho</translation>
    </message>
    <message>
        <source>Zone %1, %2: %3 mm</source>
        <translation>Zona %1, %2: %3 mm</translation>
    </message>
    <message>
        <source>No gate or zone is chosen</source>
        <translation>No hay ninguna puerta ni zona elegida</translation>
    </message>
    <message>
        <source>Gate %1 from %2, %3 to %4, %5</source>
        <translation>Puerta %1 de %2, %3 a %4, %5</translation>
    </message>
</context>
<context>
    <name>odo::TaskEditor</name>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source> m/s²</source>
        <translation> m/s²</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>&amp;Course</source>
        <translation>&amp;Circuito</translation>
    </message>
    <message>
        <source>&amp;Zones</source>
        <translation>&amp;Zonas</translation>
    </message>
    <message>
        <source>Sco&amp;ring</source>
        <translation>&amp;Puntuación</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Qué está mal</translation>
    </message>
    <message>
        <source>Import &amp;file…</source>
        <translation>Importar arc&amp;hivo…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Import gates, path, limits and zones from a task file (JSON)</source>
        <translation>Tomar puertas, trayectoria, límites y zonas de un archivo de tarea (JSON)</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>Speed limi&amp;t</source>
        <translation>Límite de &amp;velocidad</translation>
    </message>
    <message>
        <source>Acceleration l&amp;imit</source>
        <translation>Límite de ac&amp;eleración</translation>
    </message>
    <message>
        <source>No robot in the task can exceed it: a measurement beyond it is a spike</source>
        <translation>Lo que ningún robot puede hacer en la tarea: una medición que lo supere es un valor atípico</translation>
    </message>
    <message>
        <source>Task file</source>
        <translation>Archivo de tarea</translation>
    </message>
    <message>
        <source>Tasks (*.json *.yaml *.yml);;All files (*)</source>
        <translation>Tareas (*.json *.yaml *.yml);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The task has no name.</source>
        <translation>La tarea no tiene nombre.</translation>
    </message>
    <message>
        <source>A task with this name exists. Enter another name.</source>
        <translation>Ya hay una tarea con ese nombre. Indique otro nombre.</translation>
    </message>
    <message>
        <source>A gate has no name.</source>
        <translation>Hay una puerta sin nombre.</translation>
    </message>
    <message>
        <source>A zone has no name.</source>
        <translation>Hay una zona sin nombre.</translation>
    </message>
</context>
<context>
    <name>odo::TasksDialog</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nueva</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Editar…</translation>
    </message>
    <message>
        <source>&amp;Copy…</source>
        <translation>&amp;Copiar…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Renombrar…</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>&amp;Archivar</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>E&amp;liminar</translation>
    </message>
    <message>
        <source>Reanalyse &amp;them</source>
        <translation>&amp;Volver a medirlos</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tareas</translation>
    </message>
    <message>
        <source>What depends on the task</source>
        <translation>Lo que depende de la tarea</translation>
    </message>
    <message>
        <source>Latest change</source>
        <translation>Lo que se hizo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Plantilla</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>Usada por</translation>
    </message>
    <message>
        <source>Archived tasks no longer appear in lists; their trials, results and scores stay as they are</source>
        <translation>Una tarea archivada ya no se ofrece; sus ensayos, resultados y puntuaciones quedan como están</translation>
    </message>
    <message numerus="yes">
        <source>Show %n archived task(s)</source>
        <translation>
            <numerusform>Mostrar %n tarea archivada</numerusform>
            <numerusform>Mostrar %n tareas archivadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n ensayo</numerusform>
            <numerusform>%n ensayos</numerusform>
        </translation>
    </message>
    <message>
        <source>earlier results</source>
        <translation>resultados anteriores</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>%1, archived</source>
        <translation>%1, archivada</translation>
    </message>
    <message>
        <source>No task yet. New creates one from a template. Its gates, path and scoring define the course and rate the runs.</source>
        <translation>Aún no hay tareas. Nueva crea una a partir de una plantilla: sus puertas, trayectoria y puntuación dicen qué hay que recorrer y lo bien que se hizo.</translation>
    </message>
    <message numerus="yes">
        <source>Earlier version of the course: %n result(s) still use it.</source>
        <translation>
            <numerusform>El circuito tal como era antes de cambiarlo: lo conserva %n resultado medido con él.</numerusform>
            <numerusform>El circuito tal como era antes de cambiarlo: lo conservan %n resultados medidos con él.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) have this task.</source>
        <translation>
            <numerusform>%n ensayo tiene esta tarea.</numerusform>
            <numerusform>%n ensayos tienen esta tarea.</numerusform>
        </translation>
    </message>
    <message>
        <source>No trial has this task.</source>
        <translation>Ningún ensayo tiene esta tarea.</translation>
    </message>
    <message numerus="yes">
        <source>%n of them were measured with another course: their gate times and distances from the path belong to that one, and they have no score until you reanalyse them.</source>
        <translation>
            <numerusform>%n de ellos se midió con otro circuito: los tiempos en las puertas y las distancias a la trayectoria son de aquel, y no hay puntuación hasta que se vuelva a medir.</numerusform>
            <numerusform>%n de ellos se midieron con otro circuito: los tiempos en las puertas y las distancias a la trayectoria son de aquel, y no hay puntuación hasta que se vuelvan a medir.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is scored by %n metric(s).</source>
        <translation>
            <numerusform>Se puntúa con %n indicador.</numerusform>
            <numerusform>Se puntúa con %n indicadores.</numerusform>
        </translation>
    </message>
    <message>
        <source>It is not scored.</source>
        <translation>No se puntúa.</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>Des&amp;archivar</translation>
    </message>
    <message>
        <source>Trials have this task or were measured with it: it stays to document their metrics</source>
        <translation>Hay ensayos con esta tarea o medidos con ella: se conserva, para que sus indicadores digan con qué se midieron</translation>
    </message>
    <message>
        <source>Deletes the task (Del); Ctrl+Z undoes this</source>
        <translation>Elimina la tarea (Supr); Ctrl+Z la recupera</translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) measured with this course stay valid: if you change the course, they keep the earlier version. Reanalyse the trials to update their times and scores.</source>
        <translation>
            <numerusform>%n resultado medido con este circuito sigue siendo válido: si el circuito se cambia, se conserva para él como versión anterior. Los ensayos pasan al nuevo; sus tiempos y puntuaciones llegan cuando se vuelven a medir.</numerusform>
            <numerusform>%n resultados medidos con este circuito siguen siendo válidos: si el circuito se cambia, se conserva para ellos como versión anterior. Los ensayos pasan al nuevo; sus tiempos y puntuaciones llegan cuando se vuelven a medir.</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename task</source>
        <translation>Renombrar tarea</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
</context>
<context>
    <name>odo::TeamDialog</name>
    <message>
        <source>Robots of the team</source>
        <translation>Robots del equipo</translation>
    </message>
    <message>
        <source>Team %1</source>
        <translation>Equipo %1</translation>
    </message>
    <message>
        <source>One name per line</source>
        <translation>Un nombre en cada línea</translation>
    </message>
    <message>
        <source>Members of the team, one per line</source>
        <translation>Miembros del equipo, uno en cada línea</translation>
    </message>
    <message>
        <source>Record and Import propose these robots for the team&apos;s runs</source>
        <translation>Grabar y la importación proponen estos robots para los recorridos del equipo</translation>
    </message>
    <message>
        <source>&amp;Members</source>
        <translation>&amp;Miembros</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>&amp;Robots</translation>
    </message>
    <message numerus="yes">
        <source>%n member(s)</source>
        <translation>
            <numerusform>%n miembro</numerusform>
            <numerusform>%n miembros</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TeamsPanel</name>
    <message>
        <source>Teams</source>
        <translation>Equipos</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>Todas las clases</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>Cualquier tarea</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Indicador</translation>
    </message>
    <message>
        <source>Standings</source>
        <translation>Clasificación de los equipos</translation>
    </message>
    <message>
        <source>%1 (archived)</source>
        <translation>%1 (archivada)</translation>
    </message>
    <message>
        <source>No team has a result for this metric</source>
        <translation>Ningún equipo tiene un indicador aquí</translation>
    </message>
    <message numerus="yes">
        <source>%n team(s)</source>
        <translation>
            <numerusform>%n equipo</numerusform>
            <numerusform>%n equipos</numerusform>
        </translation>
    </message>
    <message>
        <source>choose a task to rank them: runs of different tasks cannot be compared</source>
        <translation>elija una tarea para clasificarlos: los recorridos de tareas distintas no se pueden comparar</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them</source>
        <translation>
            <numerusform>%n ensayo omitido: se midió con otro circuito; vuelva a medirlo</numerusform>
            <numerusform>%n ensayos omitidos: se midieron con otro circuito; vuelva a medirlos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results</source>
        <translation>
            <numerusform>%n ensayo no contado: resultados malos</numerusform>
            <numerusform>%n ensayos no contados: resultados malos</numerusform>
        </translation>
    </message>
    <message>
        <source>teams that do not differ significantly share a rank</source>
        <translation>los equipos sin diferencia significativa comparten puesto</translation>
    </message>
</context>
<context>
    <name>odo::TemplateForm</name>
    <message>
        <source>Straight line</source>
        <translation>Línea recta</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Círculo</translation>
    </message>
    <message>
        <source>Figure eight</source>
        <translation>Ocho</translation>
    </message>
    <message>
        <source>Slalom</source>
        <translation>Eslalon</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Te&amp;mplate</source>
        <translation>Plant&amp;illa</translation>
    </message>
    <message>
        <source>Centre &amp;x</source>
        <translation>Centro &amp;x</translation>
    </message>
    <message>
        <source>Centre &amp;y</source>
        <translation>Centro &amp;y</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Longitud</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Ancho</translation>
    </message>
    <message>
        <source>Driving direction: 0° along X, 90° along Y</source>
        <translation>El sentido en que se recorre: 0° a lo largo de X, 90° a lo largo de Y</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>&amp;Dirección</translation>
    </message>
    <message>
        <source>&amp;Poles</source>
        <translation>P&amp;ostes</translation>
    </message>
    <message>
        <source>&amp;Gates&apos; width</source>
        <translation>Ancho de p&amp;uertas</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Diam&amp;eter</source>
        <translation>Diá&amp;metro</translation>
    </message>
    <message>
        <source>Start to finis&amp;h</source>
        <translation>De &amp;salida a meta</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>A&amp;ltura</translation>
    </message>
    <message>
        <source>S&amp;wing, side to side</source>
        <translation>Vaivén l&amp;ateral</translation>
    </message>
</context>
<context>
    <name>odo::TestbedPage</name>
    <message>
        <source>From above</source>
        <translation>Desde arriba</translation>
    </message>
    <message>
        <source>expected &amp;accuracy</source>
        <translation>exac&amp;titud prevista</translation>
    </message>
    <message>
        <source>No cameras yet</source>
        <translation>Aún no hay cámaras</translation>
    </message>
    <message>
        <source>A testbed is a floor with markers and the cameras that watch it. Start with the lens calibration of the first camera, or with the marker positions.</source>
        <translation>Un banco de pruebas es un suelo con marcadores y las cámaras que lo observan. Empiece por la lente de la primera cámara o por los lugares de los marcadores.</translation>
    </message>
    <message>
        <source>Tas&amp;ks…</source>
        <translation>Ta&amp;reas…</translation>
    </message>
    <message>
        <source>Courses on this floor: gates, paths, limits, scoring</source>
        <translation>Lo que se recorre en este suelo: puertas, trayectorias, límites, puntuación</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Details of the camera</source>
        <translation>Lo que se sabe de la cámara</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Marker layouts</source>
        <translation>Planos de marcadores</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Cámara %1</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Imagen</translation>
    </message>
</context>
<context>
    <name>odo::TestbedTools</name>
    <message>
        <source>&amp;Calibrate camera…</source>
        <translation>Cal&amp;ibrar cámara…</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Calibrar…</translation>
    </message>
    <message>
        <source>Calibrate a camera with images of a board</source>
        <translation>Medir la lente de una cámara con imágenes de un tablero</translation>
    </message>
    <message>
        <source>&amp;Register camera…</source>
        <translation>&amp;Registrar cámara…</translation>
    </message>
    <message>
        <source>Register…</source>
        <translation>Registrar…</translation>
    </message>
    <message>
        <source>Determine a camera&apos;s position from the floor markers</source>
        <translation>Hallar dónde está una cámara con los marcadores del suelo</translation>
    </message>
    <message>
        <source>Register via anot&amp;her camera…</source>
        <translation>Registrar &amp;mediante otra cámara…</translation>
    </message>
    <message>
        <source>Via another…</source>
        <translation>Mediante otra…</translation>
    </message>
    <message>
        <source>Determine the position of a camera that sees no markers, from floor points that another camera also sees</source>
        <translation>Hallar dónde está una cámara que no ve marcadores, con puntos del suelo que también ve otra cámara</translation>
    </message>
    <message>
        <source>Re&amp;gister all cameras (joint)…</source>
        <translation>Registrar todas las cámaras &amp;juntas…</translation>
    </message>
    <message>
        <source>All cameras (joint)…</source>
        <translation>Todas juntas…</translation>
    </message>
    <message>
        <source>Fit all cameras of the selected layout jointly to make them agree, and find wrongly measured markers</source>
        <translation>Ajustar a la vez las cámaras del plano elegido, para que concuerden, y descubrir marcadores mal medidos</translation>
    </message>
    <message>
        <source>&amp;Import lens calibration…</source>
        <translation>Importar parámetros i&amp;ntrínsecos…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Importar lente…</translation>
    </message>
    <message>
        <source>Import a camera&apos;s lens calibration from a ROS or OpenCV YAML file</source>
        <translation>Tomar la lente de una cámara de un archivo YAML de ROS u OpenCV</translation>
    </message>
    <message>
        <source>New marker &amp;layout…</source>
        <translation>Nuevo &amp;plano de marcadores…</translation>
    </message>
    <message>
        <source>New layout…</source>
        <translation>Nuevo plano…</translation>
    </message>
    <message>
        <source>Enter the marker positions, from scratch or based on the selected layout</source>
        <translation>Indicar dónde están los marcadores, desde cero o a partir del plano elegido</translation>
    </message>
    <message>
        <source>Import &amp;marker layout…</source>
        <translation>Importar plan&amp;o de marcadores…</translation>
    </message>
    <message>
        <source>Import layout…</source>
        <translation>Importar plano…</translation>
    </message>
    <message>
        <source>Import the marker positions from a table</source>
        <translation>Tomar los lugares de los marcadores de una tabla</translation>
    </message>
    <message>
        <source>Print &amp;targets…</source>
        <translation>Imprimir pa&amp;trones…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Imprimir…</translation>
    </message>
    <message>
        <source>Calibration boards and floor markers, to scale</source>
        <translation>Tableros para la lente y marcadores para el suelo, a escala</translation>
    </message>
    <message>
        <source>Camera %1 is calibrated. %2</source>
        <translation>La cámara %1 está calibrada. %2</translation>
    </message>
    <message>
        <source>Camera %1 is registered. %2</source>
        <translation>La cámara %1 está registrada. %2</translation>
    </message>
    <message>
        <source>Camera %1 is registered via camera %2. %3</source>
        <translation>La cámara %1 está registrada mediante la cámara %2. %3</translation>
    </message>
    <message>
        <source>The cameras of layout %1 are registered jointly. %2</source>
        <translation>Las cámaras del plano %1 están registradas juntas. %2</translation>
    </message>
    <message>
        <source>Lens calibration of a camera</source>
        <translation>Parámetros intrínsecos de una cámara</translation>
    </message>
    <message>
        <source>Import lens calibration</source>
        <translation>Importar parámetros intrínsecos</translation>
    </message>
    <message>
        <source>Camera:</source>
        <translation>Cámara:</translation>
    </message>
    <message>
        <source>Lens calibration of camera %1 imported from %2.</source>
        <translation>La lente de la cámara %1 se tomó de %2.</translation>
    </message>
    <message>
        <source>Positions of the markers (label,x_mm,y_mm)</source>
        <translation>Lugares de los marcadores (label,x_mm,y_mm)</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>Tablas (*.csv *.txt);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Layout %1 has %2 markers.</source>
        <translation>El plano %1 tiene %2 marcadores.</translation>
    </message>
    <message>
        <source>Calibrations (*.yaml *.yml *.json *.toml *.ini);;All files (*)</source>
        <translation>Calibraciones (*.yaml *.yml *.json *.toml *.ini);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The file holds several cameras. Which one is %1?</source>
        <translation>El archivo contiene varias cámaras. ¿Cuál de ellas es %1?</translation>
    </message>
</context>
<context>
    <name>odo::TimeSlider</name>
    <message>
        <source>Time of the trial</source>
        <translation>Tiempo del ensayo</translation>
    </message>
</context>
<context>
    <name>odo::Timeline</name>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Reproducir o pausar</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>Un fotograma &amp;atrás</translation>
    </message>
    <message>
        <source>One frame &amp;forward</source>
        <translation>Un fotograma a&amp;delante</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>Un segundo atrás</translation>
    </message>
    <message>
        <source>One second forward</source>
        <translation>Un segundo adelante</translation>
    </message>
    <message>
        <source>Play backwards, again: faster</source>
        <translation>Reproducir hacia atrás; otra vez: más rápido</translation>
    </message>
    <message>
        <source>&amp;Stop; while held, the keys beside it step one frame</source>
        <translation>De&amp;tener; si se mantiene, las dos contiguas mueven un fotograma</translation>
    </message>
    <message>
        <source>Play forwards, again: faster</source>
        <translation>Reproducir hacia delante; otra vez: más rápido</translation>
    </message>
    <message>
        <source>To the first frame</source>
        <translation>Al primer fotograma</translation>
    </message>
    <message>
        <source>To the last frame</source>
        <translation>Al último fotograma</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Bucle</translation>
    </message>
    <message>
        <source>Selection beg&amp;ins here</source>
        <translation>&amp;Inicio de la selección aquí</translation>
    </message>
    <message>
        <source>Selection &amp;ends here</source>
        <translation>&amp;Fin de la selección aquí</translation>
    </message>
    <message>
        <source>&amp;Clear the selection</source>
        <translation>&amp;Quitar la selección</translation>
    </message>
</context>
<context>
    <name>odo::TimelineBar</name>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Velocidad de reproducción</translation>
    </message>
    <message>
        <source>To the first frame (Home)</source>
        <translation>Al primer fotograma (Inicio)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Reproducir (Espacio)</translation>
    </message>
    <message>
        <source>To the last frame (End)</source>
        <translation>Al último fotograma (Fin)</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>sin fotogramas</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>fotograma %1 de %2</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pausa (Espacio)</translation>
    </message>
</context>
<context>
    <name>odo::TrackDialog</name>
    <message>
        <source>Robots to track</source>
        <translation>Robots que seguir</translation>
    </message>
    <message>
        <source>Track %1</source>
        <translation>Rastrear %1</translation>
    </message>
    <message>
        <source>Kalman/RTS, noise from the data (best)</source>
        <translation>Kalman/RTS, ruido según los datos (el mejor)</translation>
    </message>
    <message>
        <source>Savitzky–Golay</source>
        <translation>Savitzky–Golay</translation>
    </message>
    <message>
        <source>Differences as in Tracker</source>
        <translation>Diferencias como en Tracker</translation>
    </message>
    <message>
        <source>None: raw differences</source>
        <translation>Ninguno: diferencias directas</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>R&amp;obots</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>&amp;Suavizado</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Rastrear</translation>
    </message>
</context>
<context>
    <name>odo::TrackPreview</name>
    <message>
        <source>%1: too long to be shown before the import</source>
        <translation>%1: demasiado largo para mostrarlo antes de importar</translation>
    </message>
    <message>
        <source>%1, track %2</source>
        <translation>%1, trayectoria %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2, %n lines in %3 s</source>
        <translation>
            <numerusform>%1: %2, %n línea en %3 s</numerusform>
            <numerusform>%1: %2, %n líneas en %3 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrackReadingForm</name>
    <message>
        <source>&amp;Unit of positions</source>
        <translation>&amp;Unidad de las posiciones</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>píxeles</translation>
    </message>
    <message>
        <source>Unit of t&amp;imes</source>
        <translation>Unidad de los t&amp;iempos</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>µs</translation>
    </message>
    <message>
        <source>ns</source>
        <translation>ns</translation>
    </message>
    <message>
        <source>frame numbers</source>
        <translation>números de fotograma</translation>
    </message>
    <message>
        <source>F&amp;loor axes</source>
        <translation>Ejes del sue&amp;lo</translation>
    </message>
    <message>
        <source>x and y</source>
        <translation>x e y</translation>
    </message>
    <message>
        <source>x and z</source>
        <translation>x y z</translation>
    </message>
    <message>
        <source>y and z</source>
        <translation>y y z</translation>
    </message>
    <message>
        <source>&amp;Decimal sign</source>
        <translation>Signo &amp;decimal</translation>
    </message>
    <message>
        <source>point</source>
        <translation>punto</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>coma</translation>
    </message>
    <message>
        <source>&amp;Frame rate</source>
        <translation>&amp;Frecuencia de imagen</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> fotogramas/s</translation>
    </message>
    <message>
        <source>Of a file that numbers its frames</source>
        <translation>De un archivo que numera sus fotogramas</translation>
    </message>
    <message>
        <source>Length of a &amp;pixel</source>
        <translation>Lon&amp;gitud de un píxel</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>On the floor, for positions in pixels</source>
        <translation>En el suelo, para posiciones en píxeles</translation>
    </message>
    <message>
        <source>Least &amp;confidence</source>
        <translation>&amp;Confianza mínima</translation>
    </message>
    <message>
        <source>Positions with a lower likelihood count as not measured</source>
        <translation>Las posiciones con menor probabilidad cuentan como no medidas</translation>
    </message>
    <message>
        <source>Accurac&amp;y</source>
        <translation>E&amp;xactitud</translation>
    </message>
    <message>
        <source>Standard deviation of the positions, slow errors included; scatter alone does not show those</source>
        <translation>Desviación típica de las posiciones, incluidos los errores lentos; la dispersión sola no los muestra</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>del archivo</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pies</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>days</source>
        <translation>días</translation>
    </message>
</context>
<context>
    <name>odo::TransferActions</name>
    <message>
        <source>&amp;Pack into one file…</source>
        <translation>&amp;Empaquetar en un archivo…</translation>
    </message>
    <message>
        <source>&amp;Unpack a packed project…</source>
        <translation>Dese&amp;mpaquetar proyecto…</translation>
    </message>
    <message>
        <source>Find &amp;lost videos…</source>
        <translation>Buscar videos &amp;perdidos…</translation>
    </message>
    <message>
        <source>Pack the project with its videos</source>
        <translation>Empaquetar el proyecto con sus videos</translation>
    </message>
    <message>
        <source>Packed projects (*%1)</source>
        <translation>Proyectos empaquetados (*%1)</translation>
    </message>
    <message>
        <source>Project packed into %1. To use it on another computer, choose &quot;Unpack a packed project&quot; there.</source>
        <translation>El proyecto está empaquetado en %1. En otro lugar se desempaqueta con “Desempaquetar proyecto”.</translation>
    </message>
    <message>
        <source>Note: %1.</source>
        <translation>Nota: %1.</translation>
    </message>
    <message>
        <source>Unpack a packed project</source>
        <translation>Desempaquetar proyecto</translation>
    </message>
    <message>
        <source>Packed projects (*%1);;All files (*)</source>
        <translation>Proyectos empaquetados (*%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Choose a folder for the unpacked project</source>
        <translation>¿Dónde desempaquetar el proyecto?</translation>
    </message>
    <message>
        <source>Choose the folder to search for the lost videos (with subfolders)</source>
        <translation>¿En qué carpeta, o por debajo de cuál, pueden estar los videos perdidos?</translation>
    </message>
    <message>
        <source>Found %1 of %2 lost videos by their content.</source>
        <translation>Se encontraron %1 de %2 videos perdidos, por su contenido.</translation>
    </message>
    <message>
        <source>Find &amp;stray files…</source>
        <translation>Buscar archivos s&amp;ueltos…</translation>
    </message>
    <message>
        <source>Every file in the media folder belongs to a trial, a lens calibration or a floor registration.</source>
        <translation>Cada archivo de la carpeta de medios pertenece a un ensayo, una calibración de la lente o un registro al suelo.</translation>
    </message>
    <message>
        <source>Stray files</source>
        <translation>Archivos sueltos</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) in the media folder belong to no trial, lens calibration or floor registration.</source>
        <translation>
            <numerusform>%n archivo de la carpeta de medios no pertenece a ningún ensayo, calibración de la lente ni registro al suelo.</numerusform>
            <numerusform>%n archivos de la carpeta de medios no pertenecen a ningún ensayo, calibración de la lente ni registro al suelo.</numerusform>
        </translation>
    </message>
    <message>
        <source>You can add videos as trials. Removed files are gone for good.</source>
        <translation>Los videos pueden convertirse en ensayos propios. Los archivos eliminados se pierden definitivamente.</translation>
    </message>
    <message>
        <source>&amp;Add videos as trials</source>
        <translation>&amp;Añadir videos como ensayos</translation>
    </message>
    <message>
        <source>&amp;Remove files</source>
        <translation>&amp;Eliminar archivos</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) added. Their names begin with &quot;recovered&quot;.</source>
        <translation>
            <numerusform>%n ensayo añadido. Su nombre empieza por «recovered».</numerusform>
            <numerusform>%n ensayos añadidos. Sus nombres empiezan por «recovered».</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stray file(s) removed.</source>
        <translation>
            <numerusform>%n archivo suelto eliminado.</numerusform>
            <numerusform>%n archivos sueltos eliminados.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other file(s), listed last, stay: missing recordings, projects, and files that are neither videos nor images.</source>
        <translation>
            <numerusform>%n archivo más, al final de la lista, se queda: una grabación perdida, un proyecto o algo que no es ni vídeo ni imagen.</numerusform>
            <numerusform>%n archivos más, al final de la lista, se quedan: grabaciones perdidas, proyectos y lo que no es ni vídeo ni imagen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrendChart</name>
    <message>
        <source>Progress of the team</source>
        <translation>Progreso del equipo</translation>
    </message>
    <message>
        <source>%1: %2 trials, progress: %3</source>
        <translation>%1: %2 ensayos, progreso: %3</translation>
    </message>
    <message>
        <source>No team is selected</source>
        <translation>Ningún equipo seleccionado</translation>
    </message>
    <message>
        <source>Select a team to see its results over the term.</source>
        <translation>Seleccione un equipo para ver sus ensayos a lo largo del periodo.</translation>
    </message>
</context>
<context>
    <name>odo::TrialActions</name>
    <message>
        <source>%1 in %2 of %3 frames, spikes flagged: %4</source>
        <translation>%1 en %2 de %3 fotogramas, atípicos señalados: %4</translation>
    </message>
    <message>
        <source>%1 is tracked: %2.</source>
        <translation>%1 está rastreado: %2.</translation>
    </message>
    <message>
        <source>%1 is imported.</source>
        <translation>%1 está importado.</translation>
    </message>
    <message>
        <source>&amp;Import trial from videos…</source>
        <translation>&amp;Importar ensayo de videos…</translation>
    </message>
    <message>
        <source>Import finished tra&amp;cks…</source>
        <translation>Importar &amp;trazas terminadas…</translation>
    </message>
    <message>
        <source>&amp;Track…</source>
        <translation>&amp;Rastrear…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Export &amp;video…</source>
        <translation>Exportar &amp;video…</translation>
    </message>
    <message>
        <source>Add &amp;robot…</source>
        <translation>Añadir r&amp;obot…</translation>
    </message>
    <message>
        <source>The sample at %1 of %2 is not used. Choose Undo to use it.</source>
        <translation>La muestra a los %1 de %2 no se usa. Deshacer lo revierte.</translation>
    </message>
    <message>
        <source>The sample at %1 of %2 is used. Choose Undo to reverse this.</source>
        <translation>La muestra a los %1 de %2 se usa. Deshacer lo revierte.</translation>
    </message>
    <message>
        <source>Video of %1</source>
        <translation>Video de %1</translation>
    </message>
    <message>
        <source>MP4 videos (*.mp4)</source>
        <translation>Videos MP4 (*.mp4)</translation>
    </message>
    <message>
        <source>Video of %1 saved as %2</source>
        <translation>El video de %1 está listo: %2</translation>
    </message>
    <message>
        <source>Robot %1 added.</source>
        <translation>Se añadió el robot %1.</translation>
    </message>
    <message>
        <source>%1 is synchronised.</source>
        <translation>%1 está sincronizado.</translation>
    </message>
    <message>
        <source>S&amp;ynchronise…</source>
        <translation>S&amp;incronizar…</translation>
    </message>
    <message>
        <source>The results of %1 are of its range, %2 to %3. Choose Undo to reverse this.</source>
        <translation>Los resultados de %1 son de su tramo, de %2 a %3. Elija Deshacer para revertirlo.</translation>
    </message>
    <message>
        <source>The results of %1 are of the whole run.</source>
        <translation>Los resultados de %1 son de todo el recorrido.</translation>
    </message>
    <message>
        <source>E&amp;dit…</source>
        <translation>E&amp;ditar…</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) changed. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>%n ensayo cambiado. Elija Deshacer para revertirlo.</numerusform>
            <numerusform>%n ensayos cambiados. Elija Deshacer para revertirlo.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are not used. Choose Undo to use them.</source>
        <translation>
            <numerusform>%n muestra de %1 no se usa. Elija Deshacer para usarla.</numerusform>
            <numerusform>%n muestras de %1 no se usan. Elija Deshacer para usarlas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are used. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>%n muestra de %1 se usa. Elija Deshacer para revertirlo.</numerusform>
            <numerusform>%n muestras de %1 se usan. Elija Deshacer para revertirlo.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrialChooser</name>
    <message>
        <source>&amp;Previous trial</source>
        <translation>Ensayo &amp;anterior</translation>
    </message>
    <message>
        <source>&amp;Next trial</source>
        <translation>Ensayo &amp;siguiente</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Ensayo</translation>
    </message>
</context>
<context>
    <name>odo::TrialColumns</name>
    <message>
        <source>&amp;Columns</source>
        <translation>&amp;Columnas</translation>
    </message>
</context>
<context>
    <name>odo::TrialDetail</name>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>none: the track was imported</source>
        <translation>ninguna: la traza se importó</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <source>none: analysed with a different course than its task has now. Reanalyse the trial</source>
        <translation>ninguna: se midió con un circuito distinto del que tiene ahora su tarea; vuelva a medirlo</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>none yet: open it and choose Track</source>
        <translation>aún ninguno: ábralo y elija Rastrear</translation>
    </message>
    <message>
        <source>Open in Review</source>
        <translation>Abrir en Revisar</translation>
    </message>
    <message>
        <source>Facts of the trial</source>
        <translation>Datos del ensayo</translation>
    </message>
    <message>
        <source>Notes of the trial</source>
        <translation>Notas del ensayo</translation>
    </message>
    <message>
        <source>What did you change on the robot? What do you want to remember?</source>
        <translation>¿Qué se cambió en el robot? ¿Qué conviene recordar?</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>&amp;Notas</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>No trials yet</source>
        <translation>Aún no hay ensayos</translation>
    </message>
    <message>
        <source>No trial selected</source>
        <translation>Ningún ensayo seleccionado</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
</context>
<context>
    <name>odo::TrialFilterBar</name>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Any class</source>
        <translation>Cualquier clase</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Any team</source>
        <translation>Cualquier equipo</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>Cualquier tarea</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Any robot</source>
        <translation>Cualquier robot</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Any date</source>
        <translation>Cualquier fecha</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Hoy</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Últimos 7 días</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Últimos 30 días</translation>
    </message>
    <message>
        <source>Last 12 months</source>
        <translation>Últimos 12 meses</translation>
    </message>
    <message>
        <source>Between…</source>
        <translation>Entre…</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Dónde</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivados</translation>
    </message>
    <message>
        <source>Bin</source>
        <translation>Papelera</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>Destacados</translation>
    </message>
    <message>
        <source>Only starred trials</source>
        <translation>Solo ensayos destacados</translation>
    </message>
    <message>
        <source>Show only starred trials</source>
        <translation>Mostrar solo los ensayos destacados</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>Dudosos</translation>
    </message>
    <message>
        <source>Only trials with doubtful or bad results</source>
        <translation>Solo ensayos con resultados dudosos o malos</translation>
    </message>
    <message>
        <source>Show only trials with doubtful or bad results</source>
        <translation>Mostrar solo ensayos con resultados dudosos o malos</translation>
    </message>
</context>
<context>
    <name>odo::TrialModel</name>
    <message>
        <source>not tracked</source>
        <translation>sin rastrear</translation>
    </message>
    <message>
        <source>reanalyse</source>
        <translation>volver a medir</translation>
    </message>
    <message>
        <source>starred</source>
        <translation>destacado</translation>
    </message>
    <message>
        <source>not starred</source>
        <translation>no destacado</translation>
    </message>
    <message>
        <source>Tags, separated by commas: double-click or F2 changes them</source>
        <translation>Etiquetas, separadas por comas: doble clic o F2 las cambia</translation>
    </message>
    <message>
        <source>Star (Ctrl+D)</source>
        <translation>Estrella (Ctrl+D)</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Estrella</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Ensayo</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>Vel. máxima</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Etiquetas</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
</context>
<context>
    <name>odo::TrialTable</name>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
</context>
<context>
    <name>odo::UndoActions</name>
    <message>
        <source>Undone: %1.</source>
        <translation>Deshecho: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Rehecho: %1.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
</context>
<context>
    <name>odo::VariableTable</name>
    <message>
        <source>several</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Variables of your own</source>
        <translation>Variables propias</translation>
    </message>
    <message>
        <source>What you want to compare runs by: surface, battery, attempt. Text or a number.</source>
        <translation>Aquello por lo que quiere comparar recorridos: superficie, batería, intento. Texto o un número.</translation>
    </message>
</context>
<context>
    <name>odo::VideoDialog</name>
    <message>
        <source>Real time</source>
        <translation>A velocidad real</translation>
    </message>
    <message>
        <source>Slow motion, 1/2</source>
        <translation>Cámara lenta, 1/2</translation>
    </message>
    <message>
        <source>Slow motion, 1/4</source>
        <translation>Cámara lenta, 1/4</translation>
    </message>
    <message>
        <source>Slow motion, 1/10</source>
        <translation>Cámara lenta, 1/10</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>One video with all camera views, the map and the speed, to show or send. It plays without Odograph.</source>
        <translation>Un video con las imágenes de todas las cámaras, el mapa y la velocidad, para mostrarlo o enviarlo: quien lo recibe no necesita Odograph.</translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation>&amp;Velocidad</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>T&amp;amaño</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Elegir un lugar…</translation>
    </message>
</context>
<context>
    <name>odo::ViewActions</name>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Restablecer disposición</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Pantalla completa</translation>
    </message>
    <message>
        <source>Colours of the &amp;desktop</source>
        <translation>Colores del &amp;escritorio</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>&amp;Oscuro</translation>
    </message>
</context>
<context>
    <name>odo::ViewSteps</name>
    <message>
        <source>Same start time</source>
        <translation>Iniciadas a la vez</translation>
    </message>
    <message>
        <source>By hand: time offset</source>
        <translation>A mano: iniciada después en</translation>
    </message>
    <message>
        <source>How to synchronise view %1 with the first</source>
        <translation>Cómo se sincroniza la vista %1 con la primera</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time offset of view %1</source>
        <translation>Cuánto después se inició la vista %1</translation>
    </message>
    <message>
        <source>Negative: it started before the first view</source>
        <translation>Por debajo de cero: se inició antes que la primera vista</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>Automatic: motion, flash or sound</source>
        <translation>Automático: movimiento, destello o sonido</translation>
    </message>
    <message>
        <source>By the motion</source>
        <translation>Por el movimiento</translation>
    </message>
    <message>
        <source>By a flash of light</source>
        <translation>Por un destello de luz</translation>
    </message>
    <message>
        <source>By sound</source>
        <translation>Por el sonido</translation>
    </message>
    <message>
        <source>A flash: switch the room lights on and off once while all cameras record. Sound: clap twice near the middle of the floor</source>
        <translation>Destello: encienda y apague una vez las luces de la sala mientras graban todas las cámaras. Sonido: dé dos palmadas cerca del centro del suelo</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Como está</translation>
    </message>
</context>
<context>
    <name>odo::WarningBar</name>
    <message>
        <source>Problem</source>
        <translation>Qué ocurre</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>Corregirlo</translation>
    </message>
</context>
<context>
    <name>odo::WelcomePage</name>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
    <message>
        <source>Measures how a mobile robot moved, from the videos of ordinary cameras.</source>
        <translation>Mide cómo se movió un robot móvil a partir de los videos de cámaras corrientes.</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Proyectos recientes</translation>
    </message>
    <message>
        <source>no longer found</source>
        <translation>ya no se encuentra</translation>
    </message>
</context>
<context>
    <name>odo::WindowMessages</name>
    <message>
        <source>&amp;Messages</source>
        <translation>&amp;Mensajes</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n mensaje</numerusform>
            <numerusform>%n mensajes</numerusform>
        </translation>
    </message>
    <message>
        <source>No messages.</source>
        <translation>No hay mensajes.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Cancelado. No se cambió nada.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Mostrar en la carpeta</translation>
    </message>
</context>
<context>
    <name>odo::Workspace</name>
    <message>
        <source>%1: %2. It is read-only here; to change it, close it there and reopen it here.</source>
        <translation>%1: %2. Aquí solo se puede consultar; para modificarlo, ciérrelo allí y vuelva a abrirlo aquí.</translation>
    </message>
    <message>
        <source>The backup was restored. The damaged file is kept as “%1”.</source>
        <translation>La copia de seguridad se ha restaurado. El archivo dañado se conserva como «%1».</translation>
    </message>
    <message>
        <source>“%1” was written before you cancelled. It was not opened.</source>
        <translation>«%1» ya estaba escrito cuando se canceló. No se abrió.</translation>
    </message>
    <message>
        <source>The backup was restored. What the project was before is kept as “%1”.</source>
        <translation>La copia de seguridad se ha restaurado. El estado anterior del proyecto se conserva como «%1».</translation>
    </message>
</context>
<context>
    <name>odo::ZoneTable</name>
    <message>
        <source>stay inside</source>
        <translation>permanecer dentro</translation>
    </message>
    <message>
        <source>keep out</source>
        <translation>no entrar</translation>
    </message>
    <message>
        <source>Remo&amp;ve zone</source>
        <translation>&amp;Quitar zona</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>Zona</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regla</translation>
    </message>
    <message>
        <source>Corners: x y; x y; … in mm</source>
        <translation>Esquinas: x y; x y; … en mm</translation>
    </message>
    <message>
        <source>Zones of the floor</source>
        <translation>Zonas del suelo</translation>
    </message>
    <message>
        <source>Add zone to sta&amp;y in</source>
        <translation>Añadir zona de pe&amp;rmanencia</translation>
    </message>
    <message>
        <source>Add zone to &amp;keep out of</source>
        <translation>Añadir zona prohi&amp;bida</translation>
    </message>
    <message>
        <source>The robot&apos;s reference point must stay in a zone or keep out of it. Each zone counts separately; you can score how often, how long and how far a robot broke it. Drag corners and edges on the map.</source>
        <translation>El centro del robot debe permanecer en una zona o no entrar en ella. Cada una se juzga por separado; cuántas veces, cuánto tiempo y en cuánto se infringió se puede puntuar. Arrastre esquinas y bordes en el mapa.</translation>
    </message>
    <message>
        <source>Rule of the zone</source>
        <translation>Regla de la zona</translation>
    </message>
    <message>
        <source>Zone %1</source>
        <translation>Zona %1</translation>
    </message>
</context>
<context>
    <name>project.acceptance_reason</name>
    <message>
        <source>reason for accepting the results</source>
        <translation>motivo para aceptar los resultados</translation>
    </message>
</context>
<context>
    <name>project.add_another_layout</name>
    <message>
        <source>add another layout for other markers</source>
        <translation>añada otro plano para otros marcadores</translation>
    </message>
</context>
<context>
    <name>project.add_one_first</name>
    <message>
        <source>add one first</source>
        <translation>añada uno antes</translation>
    </message>
</context>
<context>
    <name>project.add_what_it_refers_to</name>
    <message>
        <source>add what it refers to first</source>
        <translation>añada primero aquello a lo que se refiere</translation>
    </message>
</context>
<context>
    <name>project.adopt_or_remove</name>
    <message>
        <source>make a trial of it with odograph check P.odo --adopt, or remove it with --remove-strays; the window offers both under &apos;Find stray files…&apos;</source>
        <translation>conviértalo en un ensayo o elimínelo en «Buscar archivos sueltos…»</translation>
    </message>
</context>
<context>
    <name>project.an_analysis</name>
    <message>
        <source>analysis of a trial</source>
        <translation>análisis de un ensayo</translation>
    </message>
</context>
<context>
    <name>project.analyse_again</name>
    <message>
        <source>reanalyse the trial</source>
        <translation>vuelva a analizar el ensayo</translation>
    </message>
</context>
<context>
    <name>project.analysis_number</name>
    <message>
        <source>analysis %1</source>
        <translation>análisis %1</translation>
    </message>
</context>
<context>
    <name>project.analysis_of_project</name>
    <message>
        <source>analysis %1 of the project</source>
        <translation>análisis %1 del proyecto</translation>
    </message>
</context>
<context>
    <name>project.another_program_writes</name>
    <message>
        <source>another program is writing to it</source>
        <translation>otro programa está escribiendo en él</translation>
    </message>
</context>
<context>
    <name>project.area_few_corners</name>
    <message>
        <source>an area needs at least %1 corners</source>
        <translation>una zona necesita al menos %1 esquinas</translation>
    </message>
</context>
<context>
    <name>project.area_many_corners</name>
    <message>
        <source>an area has at most %1 corners</source>
        <translation>una zona tiene como máximo %1 esquinas</translation>
    </message>
</context>
<context>
    <name>project.area_off_frame</name>
    <message>
        <source>a position is not in the frame</source>
        <translation>una posición no está en el fotograma</translation>
    </message>
</context>
<context>
    <name>project.being_recorded</name>
    <message>
        <source>it is being recorded</source>
        <translation>se está grabando</translation>
    </message>
</context>
<context>
    <name>project.calibration_of_project</name>
    <message>
        <source>calibration %1 of the project</source>
        <translation>calibración %1 del proyecto</translation>
    </message>
</context>
<context>
    <name>project.calibration_origin</name>
    <message>
        <source>origin of a calibration</source>
        <translation>origen de una calibración</translation>
    </message>
</context>
<context>
    <name>project.calibration_picture_of</name>
    <message>
        <source>the calibration image &apos;%1&apos; of camera &apos;%2&apos;</source>
        <translation>la imagen de calibración &apos;%1&apos; de la cámara &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>project.camera_address</name>
    <message>
        <source>address of a camera</source>
        <translation>dirección de una cámara</translation>
    </message>
</context>
<context>
    <name>project.cannot_be_written_to</name>
    <message>
        <source>it cannot be written to</source>
        <translation>no se puede escribir en él</translation>
    </message>
</context>
<context>
    <name>project.cannot_hold</name>
    <message>
        <source>cannot hold %1</source>
        <translation>no se puede bloquear %1</translation>
    </message>
</context>
<context>
    <name>project.cannot_record_into</name>
    <message>
        <source>cannot record into %1</source>
        <translation>no se puede grabar en %1</translation>
    </message>
</context>
<context>
    <name>project.cannot_remove</name>
    <message>
        <source>cannot remove &apos;%1&apos;</source>
        <translation>no se puede eliminar &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.change_list</name>
    <message>
        <source>the list of changes</source>
        <translation>la lista de cambios</translation>
    </message>
</context>
<context>
    <name>project.change_not_noted</name>
    <message>
        <source>the change could not be logged (%1)</source>
        <translation>no se pudo anotar el cambio (%1)</translation>
    </message>
</context>
<context>
    <name>project.change_something_first</name>
    <message>
        <source>change something first</source>
        <translation>cambie algo antes</translation>
    </message>
</context>
<context>
    <name>project.change_words</name>
    <message>
        <source>description of a change</source>
        <translation>palabras de un cambio</translation>
    </message>
</context>
<context>
    <name>project.changed_since</name>
    <message>
        <source>something it concerns has been changed or used since</source>
        <translation>aquello a lo que afecta se ha cambiado o usado desde entonces</translation>
    </message>
</context>
<context>
    <name>project.check</name>
    <message>
        <source>check of the project</source>
        <translation>comprobación del proyecto</translation>
    </message>
</context>
<context>
    <name>project.check_disk</name>
    <message>
        <source>check the disk</source>
        <translation>compruebe el disco</translation>
    </message>
</context>
<context>
    <name>project.check_disk_and_retry</name>
    <message>
        <source>check the disk and try again</source>
        <translation>compruebe el disco e inténtelo de nuevo</translation>
    </message>
</context>
<context>
    <name>project.check_folder_is_there</name>
    <message>
        <source>check that the folder exists and that you may read it</source>
        <translation>compruebe que la carpeta está ahí y se puede leer</translation>
    </message>
</context>
<context>
    <name>project.check_its_input</name>
    <message>
        <source>check the input that it was computed from</source>
        <translation>compruebe los datos de los que se calculó</translation>
    </message>
</context>
<context>
    <name>project.check_name_or_make</name>
    <message>
        <source>check the name, or create a new project</source>
        <translation>compruebe el nombre, o cree un proyecto nuevo</translation>
    </message>
</context>
<context>
    <name>project.check_project_folder</name>
    <message>
        <source>check the free space and the permissions of the project&apos;s folder</source>
        <translation>compruebe el espacio libre y los permisos de la carpeta del proyecto</translation>
    </message>
</context>
<context>
    <name>project.check_rights</name>
    <message>
        <source>check the permissions of the project&apos;s folder</source>
        <translation>compruebe los permisos de la carpeta del proyecto</translation>
    </message>
</context>
<context>
    <name>project.checking</name>
    <message>
        <source>checking %1</source>
        <translation>comprobando %1</translation>
    </message>
</context>
<context>
    <name>project.checking_database</name>
    <message>
        <source>checking the database</source>
        <translation>comprobando la base de datos</translation>
    </message>
</context>
<context>
    <name>project.choose_from_list</name>
    <message>
        <source>choose one from the list</source>
        <translation>elija uno de la lista</translation>
    </message>
</context>
<context>
    <name>project.choose_its_own</name>
    <message>
        <source>choose one of its own (odograph revisions P.odo CAMERA --use), or restore the project from a backup copy</source>
        <translation>elija una propia (Calibraciones anteriores…), o restaure el proyecto desde una copia de seguridad</translation>
    </message>
</context>
<context>
    <name>project.choose_our_file</name>
    <message>
        <source>choose a file that Odograph has written</source>
        <translation>elija un archivo escrito por Odograph</translation>
    </message>
</context>
<context>
    <name>project.choose_writable_folder</name>
    <message>
        <source>choose a folder that can be written to and has free space</source>
        <translation>elija una carpeta con espacio en la que se pueda escribir</translation>
    </message>
</context>
<context>
    <name>project.class_has_team</name>
    <message>
        <source>a team belongs to it</source>
        <translation>un equipo pertenece a ella</translation>
    </message>
</context>
<context>
    <name>project.class_has_teams</name>
    <message>
        <source>%1 teams belong to it</source>
        <translation>%1 equipos pertenecen a ella</translation>
    </message>
</context>
<context>
    <name>project.close_it_there</name>
    <message>
        <source>close it there first</source>
        <translation>ciérrelo allí primero</translation>
    </message>
</context>
<context>
    <name>project.close_other_program</name>
    <message>
        <source>close the other program and try again</source>
        <translation>cierre el otro programa e inténtelo de nuevo</translation>
    </message>
</context>
<context>
    <name>project.complete_recording</name>
    <message>
        <source>to complete it, open the project for writing: odograph record P.odo --recover</source>
        <translation>abra el proyecto para escritura, lo que lo completa</translation>
    </message>
</context>
<context>
    <name>project.copy</name>
    <message>
        <source>copy &apos;%1&apos;</source>
        <translation>copia &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.copy_again</name>
    <message>
        <source>copy it again from its source, or restore a backup copy</source>
        <translation>cópielo de nuevo desde su origen, o restaure una copia de seguridad</translation>
    </message>
</context>
<context>
    <name>project.copy_differs</name>
    <message>
        <source>the copy differs from what was written</source>
        <translation>la copia difiere de lo escrito</translation>
    </message>
</context>
<context>
    <name>project.copy_file_beside</name>
    <message>
        <source>copy the file to the project&apos;s folder</source>
        <translation>copie el archivo junto al proyecto</translation>
    </message>
</context>
<context>
    <name>project.copy_of_project</name>
    <message>
        <source>copy of project &apos;%1&apos;</source>
        <translation>copia del proyecto &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.copy_sound_backup</name>
    <message>
        <source>copy &apos;%1&apos;, which is intact, to a new name, open that copy and keep the damaged file</source>
        <translation>copie «%1», que está íntegro, con un nombre nuevo y abra esa copia, y conserve el archivo dañado</translation>
    </message>
</context>
<context>
    <name>project.copy_to_another_disk</name>
    <message>
        <source>check the disk, and copy the project to another one</source>
        <translation>compruebe el disco y copie el proyecto a otro</translation>
    </message>
</context>
<context>
    <name>project.copy_to_writable_folder</name>
    <message>
        <source>copy it to a folder that you may write to, and open the copy</source>
        <translation>cópielo a una carpeta en la que pueda escribir y abra la copia</translation>
    </message>
</context>
<context>
    <name>project.copy_with_side_files</name>
    <message>
        <source>copy it with the files beside it to a folder that you may write to, and open the copy</source>
        <translation>cópielo, con los archivos que están junto a él, a una carpeta en la que pueda escribir y abra la copia</translation>
    </message>
</context>
<context>
    <name>project.copy_with_videos</name>
    <message>
        <source>copy it with its videos to a folder that you may write to, and open the copy</source>
        <translation>cópielo con sus videos a una carpeta en la que pueda escribir y abra la copia</translation>
    </message>
</context>
<context>
    <name>project.corners_of</name>
    <message>
        <source>corners of &apos;%1&apos;</source>
        <translation>esquinas de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.covariance_not_6_by_6</name>
    <message>
        <source>its stored covariance is not a 6 by 6 matrix</source>
        <translation>su covarianza guardada no es una matriz de 6 por 6</translation>
    </message>
</context>
<context>
    <name>project.database_refused</name>
    <message>
        <source>the database reported an error</source>
        <translation>la base de datos lo rechazó</translation>
    </message>
</context>
<context>
    <name>project.database_refused_because</name>
    <message>
        <source>the database reported an error (%1)</source>
        <translation>la base de datos lo rechazó (%1)</translation>
    </message>
</context>
<context>
    <name>project.delete_its_trials</name>
    <message>
        <source>delete its trials permanently first, or archive its class</source>
        <translation>elimínelos antes definitivamente, o archive su clase</translation>
    </message>
</context>
<context>
    <name>project.disk_error</name>
    <message>
        <source>the disk reported an error, the change was not saved</source>
        <translation>el disco comunicó un error, el cambio no se guardó</translation>
    </message>
</context>
<context>
    <name>project.disk_full</name>
    <message>
        <source>the disk is full, the change was not saved</source>
        <translation>el disco está lleno, el cambio no se guardó</translation>
    </message>
</context>
<context>
    <name>project.disk_read_only</name>
    <message>
        <source>the disk has become read-only, the change was not saved</source>
        <translation>el disco ha pasado a ser de solo lectura, el cambio no se guardó</translation>
    </message>
</context>
<context>
    <name>project.disk_unreadable</name>
    <message>
        <source>the disk could not be read; nothing was changed</source>
        <translation>no se pudo leer el disco, y no se cambió nada</translation>
    </message>
</context>
<context>
    <name>project.duration_of_recordings_differs</name>
    <message>
        <source>its duration is stored as %1, its recordings last %2</source>
        <translation>su duración guardada es %1, sus grabaciones duran %2</translation>
    </message>
</context>
<context>
    <name>project.duration_of_tracks_differs</name>
    <message>
        <source>its duration is stored as %1, its imported tracks last %2</source>
        <translation>su duración guardada es %1, sus trazas importadas duran %2</translation>
    </message>
</context>
<context>
    <name>project.earlier_step_failed</name>
    <message>
        <source>an earlier step of this change failed</source>
        <translation>falló un paso anterior de este cambio</translation>
    </message>
</context>
<context>
    <name>project.end_recording_first</name>
    <message>
        <source>end its recording first</source>
        <translation>termine antes su grabación</translation>
    </message>
</context>
<context>
    <name>project.figures_without_task</name>
    <message>
        <source>without it, their metrics would not show which rules applied</source>
        <translation>sus indicadores ya no dirían con qué se midieron</translation>
    </message>
</context>
<context>
    <name>project.file_changed</name>
    <message>
        <source>%1 has changed since it was created</source>
        <translation>%1 se modificó después de su creación</translation>
    </message>
</context>
<context>
    <name>project.file_cut_off</name>
    <message>
        <source>the file is incomplete</source>
        <translation>el archivo está truncado</translation>
    </message>
</context>
<context>
    <name>project.file_damaged</name>
    <message>
        <source>the file is damaged</source>
        <translation>el archivo está dañado</translation>
    </message>
</context>
<context>
    <name>project.file_lost</name>
    <message>
        <source>its file was deleted, renamed or replaced while it was open; nothing was stored</source>
        <translation>su archivo se ha borrado, renombrado o sustituido mientras estaba abierto; no se ha guardado nada</translation>
    </message>
</context>
<context>
    <name>project.file_there_already</name>
    <message>
        <source>a file of that name already exists</source>
        <translation>ya existe un archivo con ese nombre</translation>
    </message>
</context>
<context>
    <name>project.file_unused</name>
    <message>
        <source>no trial, lens calibration or floor registration uses this file</source>
        <translation>ningún ensayo, calibración de la lente ni registro al suelo usa este archivo</translation>
    </message>
</context>
<context>
    <name>project.find_or_put_back</name>
    <message>
        <source>take it from there with odograph check P.odo --find FOLDER or Find lost videos… in the window, or move it back to its folder</source>
        <translation>recupérela de ahí con «Buscar videos perdidos…», o devuélvala a su lugar</translation>
    </message>
</context>
<context>
    <name>project.folder_read_only</name>
    <message>
        <source>its folder cannot be written to</source>
        <translation>no se puede escribir en su carpeta</translation>
    </message>
</context>
<context>
    <name>project.foreign_log</name>
    <message>
        <source>the log beside it (&apos;%1&apos;) belongs to another file or to another state of this one</source>
        <translation>el registro que está a su lado («%1») pertenece a otro archivo o a otro estado de este</translation>
    </message>
</context>
<context>
    <name>project.format_1</name>
    <message>
        <source>the first schema</source>
        <translation>el primer esquema</translation>
    </message>
</context>
<context>
    <name>project.format_10</name>
    <message>
        <source>for a school year: stars, tags, archive, bin, pseudonyms, scoring and the list of changes</source>
        <translation>lo que necesita un año escolar: estrellas, etiquetas, archivo, papelera, seudónimos, puntuación y la lista de cambios</translation>
    </message>
</context>
<context>
    <name>project.format_11</name>
    <message>
        <source>members and robots of teams, zones and the archive of tasks, and imported tracks</source>
        <translation>miembros y robots de los equipos, zonas y archivo de tareas, y trazas importadas</translation>
    </message>
</context>
<context>
    <name>project.format_12</name>
    <message>
        <source>digests of analyses, and long series in chunks</source>
        <translation>resúmenes criptográficos de los análisis, y series largas en bloques</translation>
    </message>
</context>
<context>
    <name>project.format_13</name>
    <message>
        <source>reference points of robots</source>
        <translation>el punto del robot que se mide</translation>
    </message>
</context>
<context>
    <name>project.format_14</name>
    <message>
        <source>periods with ambiguous robot names</source>
        <translation>cuándo no se podían distinguir robots del mismo aspecto</translation>
    </message>
</context>
<context>
    <name>project.format_15</name>
    <message>
        <source>robots marked by hand in a frame</source>
        <translation>robots que una persona señaló en una imagen</translation>
    </message>
</context>
<context>
    <name>project.format_16</name>
    <message>
        <source>messages as codes with their arguments</source>
        <translation>frases como códigos con sus argumentos</translation>
    </message>
</context>
<context>
    <name>project.format_17</name>
    <message>
        <source>verdicts, and their acceptance</source>
        <translation>veredictos y su aceptación</translation>
    </message>
</context>
<context>
    <name>project.format_18</name>
    <message>
        <source>how the frames of recordings are turned</source>
        <translation>cómo se giran los fotogramas de las grabaciones</translation>
    </message>
</context>
<context>
    <name>project.format_19</name>
    <message>
        <source>ranges and variables of trials</source>
        <translation>tramos y variables de los ensayos</translation>
    </message>
</context>
<context>
    <name>project.format_2</name>
    <message>
        <source>manual overrides of samples</source>
        <translation>muestras decididas a mano</translation>
    </message>
</context>
<context>
    <name>project.format_20</name>
    <message>
        <source>which observations are in force</source>
        <translation>qué observaciones están vigentes</translation>
    </message>
</context>
<context>
    <name>project.format_21</name>
    <message>
        <source>guidance of the tracker, and the school&apos;s hub</source>
        <translation>indicaciones para el seguimiento y el nodo de la escuela</translation>
    </message>
</context>
<context>
    <name>project.format_3</name>
    <message>
        <source>clock rates of the cameras</source>
        <translation>frecuencias de los relojes de las cámaras</translation>
    </message>
</context>
<context>
    <name>project.format_4</name>
    <message>
        <source>tasks with gates, a reference path and limits</source>
        <translation>tareas con puertas, una trayectoria de referencia y límites</translation>
    </message>
</context>
<context>
    <name>project.format_5</name>
    <message>
        <source>synchronisation of each view</source>
        <translation>cómo se sincronizó cada vista</translation>
    </message>
</context>
<context>
    <name>project.format_6</name>
    <message>
        <source>calibrations with their boards, corners and images</source>
        <translation>calibraciones con sus tableros, esquinas e imágenes</translation>
    </message>
</context>
<context>
    <name>project.format_7</name>
    <message>
        <source>chosen revisions and registration checks</source>
        <translation>revisiones elegidas, y comprobaciones de registros</translation>
    </message>
</context>
<context>
    <name>project.format_8</name>
    <message>
        <source>trials during recording, and the raw times of their frames</source>
        <translation>ensayos mientras se graban, y los tiempos sin procesar de sus imágenes</translation>
    </message>
</context>
<context>
    <name>project.format_9</name>
    <message>
        <source>images of registrations</source>
        <translation>imágenes de registros</translation>
    </message>
</context>
<context>
    <name>project.frame_times_of</name>
    <message>
        <source>frame times of &apos;%1&apos;</source>
        <translation>tiempos de los fotogramas de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.frames_in_wrong_order</name>
    <message>
        <source>it ends before it starts</source>
        <translation>termina antes de empezar</translation>
    </message>
</context>
<context>
    <name>project.give_a_height</name>
    <message>
        <source>enter a height, or have it estimated</source>
        <translation>dé una altura, o deje que se estime</translation>
    </message>
</context>
<context>
    <name>project.give_a_name</name>
    <message>
        <source>give the %1 a name</source>
        <translation>dé un nombre (%1)</translation>
    </message>
</context>
<context>
    <name>project.give_a_title</name>
    <message>
        <source>give the project a title</source>
        <translation>dé un título al proyecto</translation>
    </message>
</context>
<context>
    <name>project.give_another_task</name>
    <message>
        <source>give them another task first</source>
        <translation>deles antes otra tarea</translation>
    </message>
</context>
<context>
    <name>project.give_fewer_corners</name>
    <message>
        <source>give fewer corners, or two areas</source>
        <translation>indique menos esquinas o dos zonas</translation>
    </message>
</context>
<context>
    <name>project.give_file_a_name</name>
    <message>
        <source>give the file a name</source>
        <translation>dé un nombre al archivo</translation>
    </message>
</context>
<context>
    <name>project.give_frame_pixels</name>
    <message>
        <source>give positions in pixels of the frame</source>
        <translation>indique posiciones en píxeles del fotograma</translation>
    </message>
</context>
<context>
    <name>project.give_frames_in_order</name>
    <message>
        <source>give the start before the end</source>
        <translation>indique el inicio antes del final</translation>
    </message>
</context>
<context>
    <name>project.give_members</name>
    <message>
        <source>give the names of the people in the team</source>
        <translation>dé los nombres de las personas del equipo</translation>
    </message>
</context>
<context>
    <name>project.give_more_corners</name>
    <message>
        <source>give more corners</source>
        <translation>indique más esquinas</translation>
    </message>
</context>
<context>
    <name>project.give_robot_size</name>
    <message>
        <source>give length and width in millimetres, like 260x190</source>
        <translation>dé largo y ancho en milímetros, como 260x190</translation>
    </message>
</context>
<context>
    <name>project.give_sigma_px</name>
    <message>
        <source>give σ in pixels</source>
        <translation>indique σ en píxeles</translation>
    </message>
</context>
<context>
    <name>project.give_whole_truth</name>
    <message>
        <source>give position, velocity and acceleration for each time</source>
        <translation>dé posición, velocidad y aceleración para cada tiempo</translation>
    </message>
</context>
<context>
    <name>project.guidance</name>
    <message>
        <source>guidance of the tracker</source>
        <translation>indicaciones para el seguimiento</translation>
    </message>
</context>
<context>
    <name>project.guidance_is_gone</name>
    <message>
        <source>it was removed meanwhile</source>
        <translation>se ha quitado entretanto</translation>
    </message>
</context>
<context>
    <name>project.guidance_too_many</name>
    <message>
        <source>the view already has %1 of them</source>
        <translation>la vista ya tiene %1</translation>
    </message>
</context>
<context>
    <name>project.has_bytes_of</name>
    <message>
        <source>it has %1 of %2 bytes</source>
        <translation>tiene %1 de %2 bytes</translation>
    </message>
</context>
<context>
    <name>project.has_characters</name>
    <message>
        <source>it has %1 characters</source>
        <translation>tiene %1 caracteres</translation>
    </message>
</context>
<context>
    <name>project.has_names</name>
    <message>
        <source>it has %1</source>
        <translation>tiene %1</translation>
    </message>
</context>
<context>
    <name>project.has_none_yet</name>
    <message>
        <source>it has no %1 yet</source>
        <translation>aún no tiene: %1</translation>
    </message>
</context>
<context>
    <name>project.has_other_size</name>
    <message>
        <source>%1 has %2 bytes instead of %3</source>
        <translation>%1 tiene %2 bytes en lugar de %3</translation>
    </message>
</context>
<context>
    <name>project.has_robots</name>
    <message>
        <source>it has %1 robots</source>
        <translation>tiene %1 robots</translation>
    </message>
</context>
<context>
    <name>project.has_views</name>
    <message>
        <source>it has %1 views</source>
        <translation>tiene %1 vistas</translation>
    </message>
</context>
<context>
    <name>project.height_below_floor</name>
    <message>
        <source>its height is below the floor</source>
        <translation>su altura está por debajo del suelo</translation>
    </message>
</context>
<context>
    <name>project.height_from_0</name>
    <message>
        <source>give a height of 0 or more</source>
        <translation>dé una altura de 0 o más</translation>
    </message>
</context>
<context>
    <name>project.height_not_given</name>
    <message>
        <source>it needs a fixed height, but none is given</source>
        <translation>su altura debe indicarse, pero no se da</translation>
    </message>
</context>
<context>
    <name>project.holds_invisible</name>
    <message>
        <source>it holds an invisible character, %1</source>
        <translation>contiene un carácter invisible, %1</translation>
    </message>
</context>
<context>
    <name>project.holds_line_break</name>
    <message>
        <source>it holds a line break or another control character</source>
        <translation>contiene un salto de línea u otro carácter de control</translation>
    </message>
</context>
<context>
    <name>project.ignored_area</name>
    <message>
        <source>ignored area</source>
        <translation>zona ignorada</translation>
    </message>
</context>
<context>
    <name>project.import_another_file</name>
    <message>
        <source>import another file</source>
        <translation>importe otro archivo</translation>
    </message>
</context>
<context>
    <name>project.impossible_format</name>
    <message>
        <source>it claims to have format %1</source>
        <translation>dice tener el formato %1</translation>
    </message>
</context>
<context>
    <name>project.in_synced_folder</name>
    <message>
        <source>it is in a folder that %1 copies while it changes: a copy may contain half a change</source>
        <translation>está en una carpeta que %1 copia mientras cambia, de modo que una copia puede tener medio cambio</translation>
    </message>
</context>
<context>
    <name>project.is_missing</name>
    <message>
        <source>%1 is missing</source>
        <translation>falta %1</translation>
    </message>
</context>
<context>
    <name>project.is_missing_recording</name>
    <message>
        <source>this is a missing recording</source>
        <translation>es una grabación perdida</translation>
    </message>
</context>
<context>
    <name>project.journal_of_another</name>
    <message>
        <source>the journal beside it names another file</source>
        <translation>el diario que está a su lado nombra otro archivo</translation>
    </message>
</context>
<context>
    <name>project.keep_it</name>
    <message>
        <source>keep it</source>
        <translation>consérvelo</translation>
    </message>
</context>
<context>
    <name>project.keep_on_own_disk</name>
    <message>
        <source>keep it on a disk of this computer, and pack it to share it</source>
        <translation>guárdelo en un disco de este ordenador, y empaquételo para compartirlo</translation>
    </message>
</context>
<context>
    <name>project.kind_calibration</name>
    <message>
        <source>calibration</source>
        <translation>calibración</translation>
    </message>
</context>
<context>
    <name>project.kind_camera</name>
    <message>
        <source>camera</source>
        <translation>cámara</translation>
    </message>
</context>
<context>
    <name>project.kind_class</name>
    <message>
        <source>class</source>
        <translation>clase</translation>
    </message>
</context>
<context>
    <name>project.kind_figure</name>
    <message>
        <source>metric</source>
        <translation>indicador</translation>
    </message>
</context>
<context>
    <name>project.kind_gate</name>
    <message>
        <source>gate</source>
        <translation>puerta</translation>
    </message>
</context>
<context>
    <name>project.kind_layout</name>
    <message>
        <source>layout</source>
        <translation>plano</translation>
    </message>
</context>
<context>
    <name>project.kind_lens</name>
    <message>
        <source>lens calibration</source>
        <translation>lente</translation>
    </message>
</context>
<context>
    <name>project.kind_marker</name>
    <message>
        <source>marker</source>
        <translation>marcador</translation>
    </message>
</context>
<context>
    <name>project.kind_member</name>
    <message>
        <source>member</source>
        <translation>miembro</translation>
    </message>
</context>
<context>
    <name>project.kind_pseudonym</name>
    <message>
        <source>pseudonym</source>
        <translation>seudónimo</translation>
    </message>
</context>
<context>
    <name>project.kind_registration</name>
    <message>
        <source>registration</source>
        <translation>registro</translation>
    </message>
</context>
<context>
    <name>project.kind_robot</name>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
</context>
<context>
    <name>project.kind_tag</name>
    <message>
        <source>tag</source>
        <translation>etiqueta</translation>
    </message>
</context>
<context>
    <name>project.kind_task</name>
    <message>
        <source>task</source>
        <translation>tarea</translation>
    </message>
</context>
<context>
    <name>project.kind_team</name>
    <message>
        <source>team</source>
        <translation>equipo</translation>
    </message>
</context>
<context>
    <name>project.kind_track</name>
    <message>
        <source>track</source>
        <translation>traza</translation>
    </message>
</context>
<context>
    <name>project.kind_trial</name>
    <message>
        <source>trial</source>
        <translation>ensayo</translation>
    </message>
</context>
<context>
    <name>project.kind_variable</name>
    <message>
        <source>variable</source>
        <translation>variable</translation>
    </message>
</context>
<context>
    <name>project.kind_zone</name>
    <message>
        <source>zone</source>
        <translation>zona</translation>
    </message>
</context>
<context>
    <name>project.label_twice</name>
    <message>
        <source>the label &apos;%1&apos; appears twice</source>
        <translation>el rótulo &apos;%1&apos; está dos veces</translation>
    </message>
</context>
<context>
    <name>project.leave_it</name>
    <message>
        <source>leave it</source>
        <translation>déjelo así</translation>
    </message>
</context>
<context>
    <name>project.leave_one_out</name>
    <message>
        <source>use only one of the two</source>
        <translation>deje fuera uno de los dos</translation>
    </message>
</context>
<context>
    <name>project.leave_out_unseen_markers</name>
    <message>
        <source>remove those that no camera sees</source>
        <translation>omita las que ninguna cámara ve</translation>
    </message>
</context>
<context>
    <name>project.lengths_differ</name>
    <message>
        <source>samples and profile differ in length</source>
        <translation>muestras y perfil difieren en longitud</translation>
    </message>
</context>
<context>
    <name>project.lens_kept</name>
    <message>
        <source>the lens calibration remains valid without it</source>
        <translation>la lente se conserva sin ella</translation>
    </message>
</context>
<context>
    <name>project.lens_of_project</name>
    <message>
        <source>lens calibration %1 of the project</source>
        <translation>lente %1 del proyecto</translation>
    </message>
</context>
<context>
    <name>project.lies_in_media</name>
    <message>
        <source>a project is in the media folder of another one</source>
        <translation>un proyecto está en la carpeta de medios de otro</translation>
    </message>
</context>
<context>
    <name>project.lists_too_long</name>
    <message>
        <source>%1: more than %2 of one %3: %4</source>
        <translation>%1: más de %2 de un mismo %3: %4</translation>
    </message>
</context>
<context>
    <name>project.look_for_strays</name>
    <message>
        <source>find stray files</source>
        <translation>buscar archivos sueltos</translation>
    </message>
</context>
<context>
    <name>project.look_in</name>
    <message>
        <source>search &apos;%1&apos;</source>
        <translation>buscar en &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.marker_errors_differ</name>
    <message>
        <source>the stored marker errors of registration %1 differ from those of its markers</source>
        <translation>los errores de los marcadores del registro %1 no son los que dan sus marcadores</translation>
    </message>
</context>
<context>
    <name>project.marker_off_floor</name>
    <message>
        <source>marker &apos;%1&apos; is not within a floor of 1 km</source>
        <translation>la marca &apos;%1&apos; no está en un suelo de 1 km</translation>
    </message>
</context>
<context>
    <name>project.matrix_not_square</name>
    <message>
        <source>its stored matrix of %1 numbers is not square</source>
        <translation>su matriz guardada de %1 números no es cuadrada</translation>
    </message>
</context>
<context>
    <name>project.may_be_used_beside</name>
    <message>
        <source>project &apos;%1&apos; beside it may use them, and cannot be read (%2)</source>
        <translation>el proyecto «%1» que está junto a él puede usarlos y no se puede leer (%2)</translation>
    </message>
</context>
<context>
    <name>project.measured_by_task</name>
    <message>
        <source>its rules were used to measure trials</source>
        <translation>se midieron ensayos con ella</translation>
    </message>
</context>
<context>
    <name>project.measurements_changed</name>
    <message>
        <source>the measurements have changed since robot &apos;%1&apos; was analysed</source>
        <translation>las mediciones han cambiado desde que se analizó el robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.metric</name>
    <message>
        <source>metric &apos;%1&apos;</source>
        <translation>indicador &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.metric_differs</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is stored as %3, its positions give %4</source>
        <translation>el indicador &apos;%1&apos; del robot &apos;%2&apos; está guardado como %3, sus posiciones dan %4</translation>
    </message>
</context>
<context>
    <name>project.metric_missing</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is missing, its positions give %3</source>
        <translation>falta el indicador &apos;%1&apos; del robot &apos;%2&apos;, sus posiciones dan %3</translation>
    </message>
</context>
<context>
    <name>project.metric_sigma_differs</name>
    <message>
        <source>the standard deviation of metric &apos;%1&apos; of robot &apos;%2&apos; is stored as %3, its positions give %4</source>
        <translation>la desviación estándar del indicador &apos;%1&apos; del robot &apos;%2&apos; está guardada como %3, sus posiciones dan %4</translation>
    </message>
</context>
<context>
    <name>project.metric_without_source</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is stored, but its positions give none</source>
        <translation>el indicador &apos;%1&apos; del robot &apos;%2&apos; está guardado, pero sus posiciones no dan ninguno</translation>
    </message>
</context>
<context>
    <name>project.more_names</name>
    <message>
        <source>%1 more</source>
        <translation>%1 más</translation>
    </message>
</context>
<context>
    <name>project.move_file_away</name>
    <message>
        <source>move it to another folder</source>
        <translation>muévalo a otra carpeta</translation>
    </message>
</context>
<context>
    <name>project.move_log_away</name>
    <message>
        <source>move the log to another folder to open the file without it, or restore the file that the log belongs to</source>
        <translation>mueva el registro a otra carpeta para abrir el archivo sin él, o vuelva a poner el archivo al que pertenece</translation>
    </message>
</context>
<context>
    <name>project.move_project_away</name>
    <message>
        <source>move it with its videos to a folder of its own</source>
        <translation>muévalo con sus videos a una carpeta propia</translation>
    </message>
</context>
<context>
    <name>project.move_teams_first</name>
    <message>
        <source>move its teams to another class first, or archive it</source>
        <translation>pase antes sus equipos a otra clase, o archívela</translation>
    </message>
</context>
<context>
    <name>project.name_empty</name>
    <message>
        <source>it is empty</source>
        <translation>está vacío</translation>
    </message>
</context>
<context>
    <name>project.name_of</name>
    <message>
        <source>name of a %1</source>
        <translation>nombre (%1)</translation>
    </message>
</context>
<context>
    <name>project.name_robots_once</name>
    <message>
        <source>list each of its robots once</source>
        <translation>nombre cada robot una vez</translation>
    </message>
</context>
<context>
    <name>project.name_taken</name>
    <message>
        <source>the project already has a %1 of that name</source>
        <translation>el proyecto ya tiene un elemento «%1» con ese nombre</translation>
    </message>
</context>
<context>
    <name>project.name_video_file</name>
    <message>
        <source>name the video&apos;s file</source>
        <translation>nombre el archivo del video</translation>
    </message>
</context>
<context>
    <name>project.newer_format</name>
    <message>
        <source>it was written by a newer Odograph (format %1, this one knows formats up to %2)</source>
        <translation>lo escribió un Odograph más reciente (formato %1, este conoce formatos hasta %2)</translation>
    </message>
</context>
<context>
    <name>project.no_file_but_other</name>
    <message>
        <source>it is a folder or a device, not a file</source>
        <translation>es una carpeta o un dispositivo, no un archivo</translation>
    </message>
</context>
<context>
    <name>project.no_file_name</name>
    <message>
        <source>it has no file name</source>
        <translation>no tiene nombre de archivo</translation>
    </message>
</context>
<context>
    <name>project.no_ordinary_number</name>
    <message>
        <source>a value to store is too large or not a number</source>
        <translation>un valor que se iba a guardar no es un número de tamaño normal</translation>
    </message>
</context>
<context>
    <name>project.no_place_to_rescue_to</name>
    <message>
        <source>its folder is gone, and no home folder exists to rescue it to</source>
        <translation>su carpeta ha desaparecido y no hay carpeta personal donde rescatarlo</translation>
    </message>
</context>
<context>
    <name>project.no_samples</name>
    <message>
        <source>it has no samples</source>
        <translation>no tiene muestras</translation>
    </message>
</context>
<context>
    <name>project.no_sound_backup</name>
    <message>
        <source>no intact backup was found beside it</source>
        <translation>no hay ninguna copia de seguridad íntegra a su lado</translation>
    </message>
</context>
<context>
    <name>project.no_such_name</name>
    <message>
        <source>the project has no such %1</source>
        <translation>no existe en el proyecto: %1</translation>
    </message>
</context>
<context>
    <name>project.no_such_number</name>
    <message>
        <source>it has no %1 with the number %2</source>
        <translation>no contiene %1 con el número %2</translation>
    </message>
</context>
<context>
    <name>project.not_a_project</name>
    <message>
        <source>it is not a project file</source>
        <translation>no es un archivo de proyecto</translation>
    </message>
</context>
<context>
    <name>project.not_brought_to_format</name>
    <message>
        <source>it could not be converted to format %1 (%2)</source>
        <translation>no se pudo llevar al formato %1 (%2)</translation>
    </message>
</context>
<context>
    <name>project.not_complete_yet</name>
    <message>
        <source>it is not complete yet</source>
        <translation>aún no está completo</translation>
    </message>
</context>
<context>
    <name>project.not_copied</name>
    <message>
        <source>it could not be copied to be read (%1)</source>
        <translation>no se pudo copiar para leerlo (%1)</translation>
    </message>
</context>
<context>
    <name>project.not_finite</name>
    <message>
        <source>it is not a finite number</source>
        <translation>no es un número finito</translation>
    </message>
</context>
<context>
    <name>project.not_in_bin</name>
    <message>
        <source>it is not in the bin</source>
        <translation>no está en la papelera</translation>
    </message>
</context>
<context>
    <name>project.not_utf8</name>
    <message>
        <source>it is not valid UTF-8 text</source>
        <translation>no es texto UTF-8 válido</translation>
    </message>
</context>
<context>
    <name>project.not_visible_span</name>
    <message>
        <source>time in which a robot is not visible</source>
        <translation>tiempo en que un robot no es visible</translation>
    </message>
</context>
<context>
    <name>project.nothing_to_redo</name>
    <message>
        <source>nothing has been undone</source>
        <translation>no se ha deshecho nada</translation>
    </message>
</context>
<context>
    <name>project.nothing_to_undo</name>
    <message>
        <source>nothing has been changed since the project was opened</source>
        <translation>no se ha cambiado nada desde que se abrió el proyecto</translation>
    </message>
</context>
<context>
    <name>project.numbers_too_large</name>
    <message>
        <source>%1: numbers beyond %2: %3</source>
        <translation>%1: números más allá de %2: %3</translation>
    </message>
</context>
<context>
    <name>project.observations_do_not_fit</name>
    <message>
        <source>view &apos;%1&apos; has %2 frames, but the observations of &apos;%3&apos; (%4) do not fit them</source>
        <translation>la vista &apos;%1&apos; tiene %2 fotogramas, pero las observaciones de &apos;%3&apos; (%4) no corresponden a ellos</translation>
    </message>
</context>
<context>
    <name>project.observations_of_project</name>
    <message>
        <source>observations %1 of the project</source>
        <translation>observaciones %1 del proyecto</translation>
    </message>
</context>
<context>
    <name>project.older_format</name>
    <message>
        <source>it has the older format %1 and must be updated before Odograph can read it, but %2</source>
        <translation>tiene el formato anterior %1 y debe actualizarse antes de leerse, pero %2</translation>
    </message>
</context>
<context>
    <name>project.on_network_disk</name>
    <message>
        <source>it is on a network disk (%1): a recording can stall there, and two computers can damage it</source>
        <translation>está en un disco de red (%1), donde una grabación puede detenerse y dos ordenadores pueden dañarlo</translation>
    </message>
</context>
<context>
    <name>project.open_again</name>
    <message>
        <source>open it again; if you were recording, find stray files (odograph check --adopt)</source>
        <translation>ábralo de nuevo; si estaba grabando, mire en «Buscar archivos sueltos…»</translation>
    </message>
</context>
<context>
    <name>project.open_elsewhere</name>
    <message>
        <source>it is open in another window</source>
        <translation>está abierto en otra ventana</translation>
    </message>
</context>
<context>
    <name>project.open_elsewhere_by</name>
    <message>
        <source>it is open in another window (%1)</source>
        <translation>está abierto en otra ventana (%1)</translation>
    </message>
</context>
<context>
    <name>project.open_or_move_that</name>
    <message>
        <source>open that project, or move it to a folder of its own with its videos</source>
        <translation>abra ese proyecto o muévalo con sus vídeos a una carpeta propia</translation>
    </message>
</context>
<context>
    <name>project.open_with_newer_odograph</name>
    <message>
        <source>open the project with a newer Odograph</source>
        <translation>abra el proyecto con un Odograph más reciente</translation>
    </message>
</context>
<context>
    <name>project.open_with_that_odograph</name>
    <message>
        <source>open it with that version, or update this one</source>
        <translation>ábralo con ese Odograph, o actualice este</translation>
    </message>
</context>
<context>
    <name>project.other_database</name>
    <message>
        <source>it is a database of another program</source>
        <translation>es una base de datos de otro programa</translation>
    </message>
</context>
<context>
    <name>project.other_labels</name>
    <message>
        <source>the labels differ from those of the layout</source>
        <translation>los rótulos no son los que tiene</translation>
    </message>
</context>
<context>
    <name>project.other_tables</name>
    <message>
        <source>its tables are not those of a project</source>
        <translation>sus tablas no son las de un proyecto</translation>
    </message>
</context>
<context>
    <name>project.others_calibration_chosen</name>
    <message>
        <source>calibration %1 was chosen for it but belongs to camera &apos;%2&apos;; its own newest one is used</source>
        <translation>para ella se eligió la calibración %1, que es de la cámara &apos;%2&apos;; se usa la propia más reciente</translation>
    </message>
</context>
<context>
    <name>project.others_registration_chosen</name>
    <message>
        <source>registration %1 was chosen for it but belongs to camera &apos;%2&apos;; its own newest one is used</source>
        <translation>para ella se eligió el registro %1, que es de la cámara &apos;%2&apos;; se usa el propio más reciente</translation>
    </message>
</context>
<context>
    <name>project.overrides_changed</name>
    <message>
        <source>the manual overrides have changed since robot &apos;%1&apos; was analysed</source>
        <translation>las decisiones hechas a mano han cambiado desde que se analizó el robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.path_cut_off</name>
    <message>
        <source>its reference path ends within a point</source>
        <translation>su trayectoria de referencia termina en medio de un punto</translation>
    </message>
</context>
<context>
    <name>project.path_leaves_folder</name>
    <message>
        <source>its relative path points outside the project&apos;s folder</source>
        <translation>su ruta relativa sale de la carpeta del proyecto</translation>
    </message>
</context>
<context>
    <name>project.picture_name</name>
    <message>
        <source>name of a calibration image</source>
        <translation>nombre de una imagen de calibración</translation>
    </message>
</context>
<context>
    <name>project.picture_path</name>
    <message>
        <source>path of a calibration image</source>
        <translation>ruta de una imagen de calibración</translation>
    </message>
</context>
<context>
    <name>project.point_by_hand</name>
    <message>
        <source>point set by hand</source>
        <translation>punto puesto a mano</translation>
    </message>
</context>
<context>
    <name>project.point_without_sigma</name>
    <message>
        <source>it needs one position and a σ above 0 px</source>
        <translation>necesita una posición y un σ mayor que 0 px</translation>
    </message>
</context>
<context>
    <name>project.position_no_number</name>
    <message>
        <source>a position or its covariance is not a number</source>
        <translation>una posición o su covarianza no es un número</translation>
    </message>
</context>
<context>
    <name>project.positions_changed</name>
    <message>
        <source>the stored positions of robot &apos;%1&apos; differ from those of its analysis</source>
        <translation>las posiciones del robot &apos;%1&apos; no son las que dio su análisis</translation>
    </message>
</context>
<context>
    <name>project.project</name>
    <message>
        <source>project &apos;%1&apos;</source>
        <translation>proyecto &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.project_file_damaged</name>
    <message>
        <source>the project file is damaged</source>
        <translation>el archivo del proyecto está dañado</translation>
    </message>
</context>
<context>
    <name>project.put_back_and_open</name>
    <message>
        <source>move the file back to its folder, and open the project again</source>
        <translation>devuelva el archivo a su lugar y abra de nuevo el proyecto</translation>
    </message>
</context>
<context>
    <name>project.put_back_and_retry</name>
    <message>
        <source>move it back to its folder and try again</source>
        <translation>devuélvalo a su sitio e inténtelo de nuevo</translation>
    </message>
</context>
<context>
    <name>project.put_back_or_find</name>
    <message>
        <source>move the file back to its folder, or find it by its content with odograph check P.odo --find FOLDER or Find lost videos… in the window</source>
        <translation>devuelva el archivo a su lugar, o búsquelo por su contenido con «Buscar videos perdidos…»</translation>
    </message>
</context>
<context>
    <name>project.put_file_back</name>
    <message>
        <source>move the file back to its folder</source>
        <translation>devuelva el archivo a su lugar</translation>
    </message>
</context>
<context>
    <name>project.put_into_bin_first</name>
    <message>
        <source>move it to the bin first</source>
        <translation>póngalo antes en la papelera</translation>
    </message>
</context>
<context>
    <name>project.put_original_back</name>
    <message>
        <source>move the original file back to its folder</source>
        <translation>vuelva a poner el archivo original en su sitio</translation>
    </message>
</context>
<context>
    <name>project.range_changed</name>
    <message>
        <source>the trial&apos;s range has changed since robot &apos;%1&apos; was analysed</source>
        <translation>el tramo del ensayo ha cambiado desde que se analizó el robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.range_sentence</name>
    <message>
        <source>Range: %1 to %2 of %3; all results are of this part.</source>
        <translation>Tramo: de %1 a %2 de %3; todos los resultados son de esta parte.</translation>
    </message>
</context>
<context>
    <name>project.range_without_sample</name>
    <message>
        <source>no sample is within its range</source>
        <translation>ninguna muestra está dentro de su tramo</translation>
    </message>
</context>
<context>
    <name>project.raw_times_of</name>
    <message>
        <source>raw times of recording %1</source>
        <translation>tiempos sin procesar de la grabación %1</translation>
    </message>
</context>
<context>
    <name>project.reading</name>
    <message>
        <source>reading %1</source>
        <translation>leyendo %1</translation>
    </message>
</context>
<context>
    <name>project.reading_failed</name>
    <message>
        <source>reading it failed (%1)</source>
        <translation>falló la lectura (%1)</translation>
    </message>
</context>
<context>
    <name>project.reason_is_blank</name>
    <message>
        <source>it is blank</source>
        <translation>está en blanco</translation>
    </message>
</context>
<context>
    <name>project.record_another</name>
    <message>
        <source>record another trial</source>
        <translation>grabe otro ensayo</translation>
    </message>
</context>
<context>
    <name>project.recorded_into_now</name>
    <message>
        <source>a trial is being recorded into it now</source>
        <translation>se está grabando un ensayo en él ahora mismo</translation>
    </message>
</context>
<context>
    <name>project.recording</name>
    <message>
        <source>recording</source>
        <translation>grabando</translation>
    </message>
</context>
<context>
    <name>project.recording_at</name>
    <message>
        <source>recording &apos;%1&apos;</source>
        <translation>grabación &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.recording_cut_off</name>
    <message>
        <source>its recording was cut off</source>
        <translation>su grabación se interrumpió</translation>
    </message>
</context>
<context>
    <name>project.recording_ended</name>
    <message>
        <source>its recording has ended already</source>
        <translation>su grabación ya terminó</translation>
    </message>
</context>
<context>
    <name>project.recording_kept</name>
    <message>
        <source>its recording has ended, and is kept</source>
        <translation>su grabación ha terminado y se conserva</translation>
    </message>
</context>
<context>
    <name>project.recording_of_view</name>
    <message>
        <source>the recording of view &apos;%1&apos;</source>
        <translation>la grabación de la vista &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.recording_path</name>
    <message>
        <source>path of a recording</source>
        <translation>ruta de una grabación</translation>
    </message>
</context>
<context>
    <name>project.recording_without_file</name>
    <message>
        <source>it has no file</source>
        <translation>no tiene archivo</translation>
    </message>
</context>
<context>
    <name>project.recordings_changed</name>
    <message>
        <source>the recordings or their synchronisation have changed since robot &apos;%1&apos; was analysed</source>
        <translation>las grabaciones o su sincronización han cambiado desde que se analizó el robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.redo</name>
    <message>
        <source>redo</source>
        <translation>rehacer</translation>
    </message>
</context>
<context>
    <name>project.redo_of</name>
    <message>
        <source>redo &apos;%1&apos;</source>
        <translation>rehacer &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.reference_too_far</name>
    <message>
        <source>its reference point is more than %1 from its centre</source>
        <translation>su punto de referencia está a más de %1 de su centro</translation>
    </message>
</context>
<context>
    <name>project.reference_without_heading</name>
    <message>
        <source>a reference point off its centre needs a heading, but a robot of changing height has none</source>
        <translation>un punto de referencia fuera del centro necesita un rumbo, que no se conoce donde cambia la altura</translation>
    </message>
</context>
<context>
    <name>project.refers_to_nothing</name>
    <message>
        <source>it refers to something missing from the project, or a value is missing</source>
        <translation>se refiere a algo que no está en el proyecto, o falta un valor</translation>
    </message>
</context>
<context>
    <name>project.registration_kept</name>
    <message>
        <source>the registration remains valid without it</source>
        <translation>el registro se conserva sin ella</translation>
    </message>
</context>
<context>
    <name>project.registration_of_project</name>
    <message>
        <source>registration %1 of the project</source>
        <translation>registro %1 del proyecto</translation>
    </message>
</context>
<context>
    <name>project.registration_picture_of</name>
    <message>
        <source>the image of registration %1 of camera &apos;%2&apos;</source>
        <translation>la imagen del registro %1 de la cámara &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>project.registration_picture_path</name>
    <message>
        <source>path of a registration&apos;s image</source>
        <translation>ruta de la imagen de un registro</translation>
    </message>
</context>
<context>
    <name>project.registrations_changed</name>
    <message>
        <source>the registrations have changed since robot &apos;%1&apos; was analysed</source>
        <translation>los registros han cambiado desde que se analizó el robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.remove_file_first</name>
    <message>
        <source>choose another name, or remove that file first</source>
        <translation>elija otro nombre, o elimine antes ese archivo</translation>
    </message>
</context>
<context>
    <name>project.remove_guidance</name>
    <message>
        <source>remove some first</source>
        <translation>quite primero algunos</translation>
    </message>
</context>
<context>
    <name>project.remove_variables</name>
    <message>
        <source>remove some of its variables</source>
        <translation>elimine algunas de sus variables</translation>
    </message>
</context>
<context>
    <name>project.rest_not_read</name>
    <message>
        <source>Odograph does not read the rest; shorten it here, or in the program that wrote the file</source>
        <translation>el resto no se lee; cámbielo aquí o donde se hizo el archivo</translation>
    </message>
</context>
<context>
    <name>project.restore_file</name>
    <message>
        <source>restore it from a backup copy</source>
        <translation>restáurelo desde una copia de seguridad</translation>
    </message>
</context>
<context>
    <name>project.restore_or_register_again</name>
    <message>
        <source>restore the project from a backup copy, or register the camera again</source>
        <translation>restaure el proyecto desde una copia de seguridad, o registre de nuevo la cámara</translation>
    </message>
</context>
<context>
    <name>project.restore_or_track_again</name>
    <message>
        <source>restore the project from a backup copy, or track the trial again</source>
        <translation>restaure el proyecto desde una copia de seguridad, o rastree de nuevo el ensayo</translation>
    </message>
</context>
<context>
    <name>project.restore_project</name>
    <message>
        <source>restore the project from a backup copy</source>
        <translation>restaure el proyecto desde una copia de seguridad</translation>
    </message>
</context>
<context>
    <name>project.results_changed</name>
    <message>
        <source>the stored metrics, spikes or settings of robot &apos;%1&apos; differ from those of its analysis</source>
        <translation>los indicadores, valores atípicos o ajustes del robot &apos;%1&apos; no son los que dio su análisis</translation>
    </message>
</context>
<context>
    <name>project.robot_can_be_renamed</name>
    <message>
        <source>you can rename it</source>
        <translation>se le puede dar otro nombre</translation>
    </message>
</context>
<context>
    <name>project.robot_drove</name>
    <message>
        <source>a trial uses it</source>
        <translation>corrió en un ensayo</translation>
    </message>
</context>
<context>
    <name>project.robot_too_large</name>
    <message>
        <source>it is larger than %1</source>
        <translation>ocupa más de %1</translation>
    </message>
</context>
<context>
    <name>project.robot_twice</name>
    <message>
        <source>it has a robot twice</source>
        <translation>un robot le pertenece dos veces</translation>
    </message>
</context>
<context>
    <name>project.row_refers_to_nothing</name>
    <message>
        <source>row %1 of &apos;%2&apos; refers to a missing row of &apos;%3&apos;</source>
        <translation>la fila %1 de &apos;%2&apos; se refiere a una fila de &apos;%3&apos; que no está</translation>
    </message>
</context>
<context>
    <name>project.run_check</name>
    <message>
        <source>run a check of the project</source>
        <translation>ejecute una comprobación del proyecto</translation>
    </message>
</context>
<context>
    <name>project.say_why</name>
    <message>
        <source>write why the results can be used</source>
        <translation>escriba por qué se pueden usar los resultados</translation>
    </message>
</context>
<context>
    <name>project.school_ask_owner</name>
    <message>
        <source>nothing of it was taken over; ask for it to be published again</source>
        <translation>no se ha tomado nada; pida que se publique de nuevo</translation>
    </message>
</context>
<context>
    <name>project.school_document</name>
    <message>
        <source>document of the hub</source>
        <translation>documento del servidor</translation>
    </message>
</context>
<context>
    <name>project.school_field_wrong</name>
    <message>
        <source>what the hub has of it is damaged: field &apos;%1&apos;</source>
        <translation>lo que el servidor tiene de ello está dañado: campo «%1»</translation>
    </message>
</context>
<context>
    <name>project.school_names_taken</name>
    <message>
        <source>every name for it is taken here</source>
        <translation>todos los nombres posibles ya están en uso aquí</translation>
    </message>
</context>
<context>
    <name>project.school_not_readable</name>
    <message>
        <source>what the hub has of it cannot be read</source>
        <translation>lo que el servidor tiene de ello no se puede leer</translation>
    </message>
</context>
<context>
    <name>project.school_publish_again</name>
    <message>
        <source>publish again</source>
        <translation>publique de nuevo</translation>
    </message>
</context>
<context>
    <name>project.school_recordings</name>
    <message>
        <source>recordings of a trial from the hub</source>
        <translation>grabaciones de un ensayo del servidor</translation>
    </message>
</context>
<context>
    <name>project.school_recordings_wrong</name>
    <message>
        <source>their description is damaged: field &apos;%1&apos;</source>
        <translation>su descripción está dañada: campo «%1»</translation>
    </message>
</context>
<context>
    <name>project.school_rename_yours</name>
    <message>
        <source>rename the trials of that name in this project</source>
        <translation>cambie el nombre de los ensayos de ese nombre en este proyecto</translation>
    </message>
</context>
<context>
    <name>project.school_row_gone</name>
    <message>
        <source>it is no longer in the project</source>
        <translation>ya no está en el proyecto</translation>
    </message>
</context>
<context>
    <name>project.search_area</name>
    <message>
        <source>search area</source>
        <translation>zona de búsqueda</translation>
    </message>
</context>
<context>
    <name>project.series_differ</name>
    <message>
        <source>its series differ in length</source>
        <translation>sus series difieren en longitud</translation>
    </message>
</context>
<context>
    <name>project.series_missing</name>
    <message>
        <source>its series are missing</source>
        <translation>faltan sus series</translation>
    </message>
</context>
<context>
    <name>project.series_of_other_kind</name>
    <message>
        <source>its stored series is not of the expected kind</source>
        <translation>su serie guardada no es del tipo esperado</translation>
    </message>
</context>
<context>
    <name>project.series_of_other_length</name>
    <message>
        <source>its stored series announces %1 rows but holds %2 bytes</source>
        <translation>su serie guardada anuncia %1 filas pero contiene %2 bytes</translation>
    </message>
</context>
<context>
    <name>project.size_not_above_0</name>
    <message>
        <source>its size is not above 0</source>
        <translation>su tamaño no es mayor que 0</translation>
    </message>
</context>
<context>
    <name>project.spike_without_sample</name>
    <message>
        <source>a spike refers to a missing sample</source>
        <translation>un valor atípico se refiere a una muestra que no está</translation>
    </message>
</context>
<context>
    <name>project.split_recording</name>
    <message>
        <source>split the recording into shorter ones</source>
        <translation>divida la grabación en otras más cortas</translation>
    </message>
</context>
<context>
    <name>project.strays_unknown</name>
    <message>
        <source>cannot determine which files belong to no trial</source>
        <translation>no se puede saber qué archivos no pertenecen a ningún ensayo</translation>
    </message>
</context>
<context>
    <name>project.synchronisation_differs</name>
    <message>
        <source>its stored synchronisation differs from that of its second view</source>
        <translation>su sincronización guardada no es la de su segunda vista</translation>
    </message>
</context>
<context>
    <name>project.synchronisation_of_one_view</name>
    <message>
        <source>a synchronisation is stored, but it has no second view</source>
        <translation>hay una sincronización guardada, pero no tiene segunda vista</translation>
    </message>
</context>
<context>
    <name>project.take_later_back</name>
    <message>
        <source>undo the later change first, or leave this one</source>
        <translation>deshaga primero el cambio posterior, o déjelo</translation>
    </message>
</context>
<context>
    <name>project.task_changed</name>
    <message>
        <source>the task has changed since robot &apos;%1&apos; was analysed</source>
        <translation>la tarea ha cambiado desde que se analizó el robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.task_has_trial</name>
    <message>
        <source>a trial uses it</source>
        <translation>un ensayo la tiene</translation>
    </message>
</context>
<context>
    <name>project.task_has_trials</name>
    <message>
        <source>%1 trials use it</source>
        <translation>%1 ensayos la tienen</translation>
    </message>
</context>
<context>
    <name>project.team_has_trial</name>
    <message>
        <source>it has a trial</source>
        <translation>un ensayo es suyo</translation>
    </message>
</context>
<context>
    <name>project.team_has_trials</name>
    <message>
        <source>it has %1 trials</source>
        <translation>%1 ensayos son suyos</translation>
    </message>
</context>
<context>
    <name>project.texts_too_long</name>
    <message>
        <source>%1: texts of more than %2 characters: %3</source>
        <translation>%1: textos de más de %2 caracteres: %3</translation>
    </message>
</context>
<context>
    <name>project.times_do_not_rise</name>
    <message>
        <source>its times do not increase</source>
        <translation>sus tiempos no crecen</translation>
    </message>
</context>
<context>
    <name>project.title</name>
    <message>
        <source>title of the project</source>
        <translation>título del proyecto</translation>
    </message>
</context>
<context>
    <name>project.too_many_markers</name>
    <message>
        <source>it has more than %1 markers</source>
        <translation>tiene más de %1 marcas</translation>
    </message>
</context>
<context>
    <name>project.too_many_members</name>
    <message>
        <source>it has more than %1 members</source>
        <translation>tiene más de %1 miembros</translation>
    </message>
</context>
<context>
    <name>project.too_many_samples</name>
    <message>
        <source>it has more than %1 samples</source>
        <translation>tiene más de %1 muestras</translation>
    </message>
</context>
<context>
    <name>project.too_many_variables</name>
    <message>
        <source>a trial has %1 variables at most</source>
        <translation>un ensayo tiene como máximo %1 variables</translation>
    </message>
</context>
<context>
    <name>project.track</name>
    <message>
        <source>track &apos;%1&apos;</source>
        <translation>traza &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.track_again</name>
    <message>
        <source>track the trial again</source>
        <translation>rastree de nuevo el ensayo</translation>
    </message>
</context>
<context>
    <name>project.track_kept</name>
    <message>
        <source>the measured track remains valid without it</source>
        <translation>la traza medida se conserva sin ella</translation>
    </message>
</context>
<context>
    <name>project.track_reading</name>
    <message>
        <source>reading of a track</source>
        <translation>lectura de una traza</translation>
    </message>
</context>
<context>
    <name>project.trial_notes</name>
    <message>
        <source>notes of a trial</source>
        <translation>notas de un ensayo</translation>
    </message>
</context>
<context>
    <name>project.trial_of_project</name>
    <message>
        <source>trial %1 of the project</source>
        <translation>ensayo %1 del proyecto</translation>
    </message>
</context>
<context>
    <name>project.truth</name>
    <message>
        <source>truth of a trial</source>
        <translation>verdad de un ensayo</translation>
    </message>
</context>
<context>
    <name>project.truth_of_trial</name>
    <message>
        <source>truth of trial %1</source>
        <translation>verdad del ensayo %1</translation>
    </message>
</context>
<context>
    <name>project.try_again</name>
    <message>
        <source>try again</source>
        <translation>inténtelo de nuevo</translation>
    </message>
</context>
<context>
    <name>project.try_change_again</name>
    <message>
        <source>try the whole change again</source>
        <translation>intente de nuevo todo el cambio</translation>
    </message>
</context>
<context>
    <name>project.type_name_anew</name>
    <message>
        <source>type the name again</source>
        <translation>escriba el nombre de nuevo</translation>
    </message>
</context>
<context>
    <name>project.type_text_anew</name>
    <message>
        <source>type the text again</source>
        <translation>escriba el texto de nuevo</translation>
    </message>
</context>
<context>
    <name>project.undo</name>
    <message>
        <source>undo</source>
        <translation>deshacer</translation>
    </message>
</context>
<context>
    <name>project.undo_of</name>
    <message>
        <source>undo &apos;%1&apos;</source>
        <translation>deshacer &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.undo_something_first</name>
    <message>
        <source>undo something first</source>
        <translation>deshaga algo antes</translation>
    </message>
</context>
<context>
    <name>project.unknown_series_layout</name>
    <message>
        <source>its stored series has the unknown layout %1</source>
        <translation>su serie guardada tiene la disposición desconocida %1</translation>
    </message>
</context>
<context>
    <name>project.unknown_setting</name>
    <message>
        <source>its stored setting &apos;%1&apos; is unknown</source>
        <translation>su ajuste guardado &apos;%1&apos; es desconocido</translation>
    </message>
</context>
<context>
    <name>project.use_at_most</name>
    <message>
        <source>use at most %1</source>
        <translation>use como máximo %1</translation>
    </message>
</context>
<context>
    <name>project.use_one_line</name>
    <message>
        <source>use a name of one line</source>
        <translation>use un nombre de una línea</translation>
    </message>
</context>
<context>
    <name>project.value_too_large</name>
    <message>
        <source>a value is too large to store</source>
        <translation>un valor es demasiado grande para guardarlo</translation>
    </message>
</context>
<context>
    <name>project.verdict</name>
    <message>
        <source>verdict on a trial</source>
        <translation>veredicto de un ensayo</translation>
    </message>
</context>
<context>
    <name>project.views_differ</name>
    <message>
        <source>views and registrations differ in number</source>
        <translation>vistas y registros difieren en número</translation>
    </message>
</context>
<context>
    <name>project.wait_until_ended</name>
    <message>
        <source>wait until that has ended</source>
        <translation>espere a que termine</translation>
    </message>
</context>
<context>
    <name>project.writing_failed</name>
    <message>
        <source>writing it failed (%1)</source>
        <translation>falló la escritura (%1)</translation>
    </message>
</context>
<context>
    <name>project.written_over</name>
    <message>
        <source>another program wrote over its file while it was open; nothing more was stored</source>
        <translation>otro programa ha sobrescrito su archivo mientras estaba abierto; no se ha guardado nada más</translation>
    </message>
</context>
<context>
    <name>project.zone_cut_off</name>
    <message>
        <source>its zone &apos;%1&apos; ends within a point</source>
        <translation>su zona &apos;%1&apos; termina en medio de un punto</translation>
    </message>
</context>
<context>
    <name>school.address</name>
    <message>
        <source>address of the school hub</source>
        <translation>dirección del servidor de la escuela</translation>
    </message>
</context>
<context>
    <name>school.address_characters</name>
    <message>
        <source>it holds a quotation mark, a backslash, a semicolon or a control character</source>
        <translation>contiene una comilla, una barra inversa, un punto y coma o un carácter de control</translation>
    </message>
</context>
<context>
    <name>school.address_form</name>
    <message>
        <source>give it as postgresql://user@host/database</source>
        <translation>indíquela como postgresql://user@host/database</translation>
    </message>
</context>
<context>
    <name>school.ask_administrator</name>
    <message>
        <source>ask the hub&apos;s administrator for the role that may</source>
        <translation>pida al administrador del servidor el rol que pueda</translation>
    </message>
</context>
<context>
    <name>school.check_connection</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network; what is recorded meanwhile is sent later</source>
        <translation>compruebe la dirección, el usuario en ~/.pgpass y la red; lo que se grabe mientras tanto se enviará más tarde</translation>
    </message>
</context>
<context>
    <name>school.check_server</name>
    <message>
        <source>have the hub&apos;s administrator look at the server</source>
        <translation>pida al administrador que revise el servidor</translation>
    </message>
</context>
<context>
    <name>school.connect_first</name>
    <message>
        <source>connect it with odograph school connect P.odo postgresql://user@host/database</source>
        <translation>conéctelo primero</translation>
    </message>
</context>
<context>
    <name>school.connect_with_media</name>
    <message>
        <source>connect it again with --media FOLDER</source>
        <translation>conéctelo de nuevo con una carpeta de medios</translation>
    </message>
</context>
<context>
    <name>school.grant_role</name>
    <message>
        <source>have the hub&apos;s administrator grant it one: GRANT bench TO login</source>
        <translation>pida al administrador del servidor que le dé uno: GRANT bench TO login</translation>
    </message>
</context>
<context>
    <name>school.hub_subject</name>
    <message>
        <source>school hub &apos;%1&apos;</source>
        <translation>servidor de la escuela «%1»</translation>
    </message>
</context>
<context>
    <name>school.install_driver</name>
    <message>
        <source>install the package libqt6sql6-psql</source>
        <translation>instale el paquete libqt6sql6-psql</translation>
    </message>
</context>
<context>
    <name>school.media</name>
    <message>
        <source>media folder of the school</source>
        <translation>carpeta de medios de la escuela</translation>
    </message>
</context>
<context>
    <name>school.never_answers</name>
    <message>
        <source>the server takes connections and answers none</source>
        <translation>el servidor acepta conexiones y no responde a ninguna</translation>
    </message>
</context>
<context>
    <name>school.newer_hub</name>
    <message>
        <source>its schema has version %1, and this Odograph knows up to %2</source>
        <translation>su esquema tiene la versión %1 y este Odograph conoce hasta la %2</translation>
    </message>
</context>
<context>
    <name>school.no_database</name>
    <message>
        <source>it names no database</source>
        <translation>no nombra ninguna base de datos</translation>
    </message>
</context>
<context>
    <name>school.no_driver</name>
    <message>
        <source>this computer has no driver for PostgreSQL</source>
        <translation>este ordenador no tiene controlador para PostgreSQL</translation>
    </message>
</context>
<context>
    <name>school.no_hub</name>
    <message>
        <source>the database has no hub</source>
        <translation>la base de datos no está preparada</translation>
    </message>
</context>
<context>
    <name>school.no_media</name>
    <message>
        <source>the project is connected without one</source>
        <translation>el proyecto está conectado sin una</translation>
    </message>
</context>
<context>
    <name>school.no_role</name>
    <message>
        <source>the login has none of the roles teacher, bench and viewer</source>
        <translation>el usuario no tiene ninguno de los roles teacher, bench y viewer</translation>
    </message>
</context>
<context>
    <name>school.no_url</name>
    <message>
        <source>it is no address of a PostgreSQL database</source>
        <translation>no es la dirección de una base de datos PostgreSQL</translation>
    </message>
</context>
<context>
    <name>school.not_allowed</name>
    <message>
        <source>the login may not do that (%1)</source>
        <translation>este usuario no puede hacerlo (%1)</translation>
    </message>
</context>
<context>
    <name>school.not_connected</name>
    <message>
        <source>the project is not connected to one</source>
        <translation>el proyecto no está conectado a ninguno</translation>
    </message>
</context>
<context>
    <name>school.older_hub</name>
    <message>
        <source>its schema has version %1, and this Odograph needs %2</source>
        <translation>su esquema tiene la versión %1 y este Odograph necesita la %2</translation>
    </message>
</context>
<context>
    <name>school.option_unknown</name>
    <message>
        <source>its option &apos;%1&apos; is not known</source>
        <translation>su opción «%1» no se conoce</translation>
    </message>
</context>
<context>
    <name>school.options_known</name>
    <message>
        <source>use sslmode, sslrootcert, host or port</source>
        <translation>use sslmode, sslrootcert, host o port</translation>
    </message>
</context>
<context>
    <name>school.password_elsewhere</name>
    <message>
        <source>leave it out, and put the password into ~/.pgpass or PGPASSWORD</source>
        <translation>omítala y guarde la contraseña en ~/.pgpass o PGPASSWORD</translation>
    </message>
</context>
<context>
    <name>school.password_in_url</name>
    <message>
        <source>it holds a password, which others could read</source>
        <translation>contiene una contraseña que otros podrían leer</translation>
    </message>
</context>
<context>
    <name>school.password_place</name>
    <message>
        <source>put the correct one into ~/.pgpass or PGPASSWORD</source>
        <translation>introdúzcala aquí o guárdela en ~/.pgpass</translation>
    </message>
</context>
<context>
    <name>school.password_refused</name>
    <message>
        <source>the server does not accept this login with this password</source>
        <translation>el servidor no acepta este usuario con esta contraseña</translation>
    </message>
</context>
<context>
    <name>school.password_wanted</name>
    <message>
        <source>the server asks for the password of the login</source>
        <translation>el servidor pide la contraseña del usuario</translation>
    </message>
</context>
<context>
    <name>school.publish_later</name>
    <message>
        <source>try again later; what was not sent yet is kept</source>
        <translation>inténtelo más tarde; lo que aún no se ha enviado se conserva</translation>
    </message>
</context>
<context>
    <name>school.publishing</name>
    <message>
        <source>publishing</source>
        <translation>publicando</translation>
    </message>
</context>
<context>
    <name>school.receiving</name>
    <message>
        <source>receiving %1</source>
        <translation>recibiendo %1</translation>
    </message>
</context>
<context>
    <name>school.recording_changed</name>
    <message>
        <source>the recording &apos;%1&apos; is missing or has changed, and was left out</source>
        <translation>la grabación «%1» falta o ha cambiado y se ha omitido</translation>
    </message>
</context>
<context>
    <name>school.recording_elsewhere</name>
    <message>
        <source>trial &apos;%1&apos;, view &apos;%2&apos;: its recording is not in the media folder; bench &apos;%3&apos; has it as &apos;%4&apos;</source>
        <translation>ensayo «%1», vista «%2»: su grabación no está en la carpeta de medios; el puesto «%3» la tiene como «%4»</translation>
    </message>
</context>
<context>
    <name>school.report_to_administrator</name>
    <message>
        <source>show this to the hub&apos;s administrator</source>
        <translation>muestre esto al administrador del servidor</translation>
    </message>
</context>
<context>
    <name>school.run_init</name>
    <message>
        <source>have its administrator run odograph school init</source>
        <translation>pida al administrador que la prepare</translation>
    </message>
</context>
<context>
    <name>school.server_away</name>
    <message>
        <source>the server is away; trying again</source>
        <translation>el servidor no responde; se intenta de nuevo</translation>
    </message>
</context>
<context>
    <name>school.silent</name>
    <message>
        <source>the server does not answer</source>
        <translation>el servidor no responde</translation>
    </message>
</context>
<context>
    <name>school.sslmode_choices</name>
    <message>
        <source>use disable, allow, prefer, require, verify-ca or verify-full</source>
        <translation>use disable, allow, prefer, require, verify-ca o verify-full</translation>
    </message>
</context>
<context>
    <name>school.sslmode_unknown</name>
    <message>
        <source>sslmode &apos;%1&apos; is not known</source>
        <translation>sslmode «%1» no se conoce</translation>
    </message>
</context>
<context>
    <name>school.subject</name>
    <message>
        <source>school hub</source>
        <translation>servidor de la escuela</translation>
    </message>
</context>
<context>
    <name>school.update_program</name>
    <message>
        <source>update Odograph</source>
        <translation>actualice Odograph</translation>
    </message>
</context>
<context>
    <name>school.waiting</name>
    <message>
        <source>waiting for the server</source>
        <translation>esperando al servidor</translation>
    </message>
</context>
<context>
    <name>school.went_away</name>
    <message>
        <source>the connection was lost (%1)</source>
        <translation>se perdió la conexión (%1)</translation>
    </message>
</context>
<context>
    <name>simulation.cannot_render</name>
    <message>
        <source>cannot render %1</source>
        <translation>no se puede generar %1</translation>
    </message>
</context>
<context>
    <name>simulation.lengthen_scene</name>
    <message>
        <source>give the scene a longer duration or start the camera earlier</source>
        <translation>dé a la escena más duración o inicie antes la cámara</translation>
    </message>
</context>
<context>
    <name>simulation.no_frame</name>
    <message>
        <source>camera %1 takes no frame during the scene</source>
        <translation>la cámara %1 no toma ningún fotograma mientras dura la escena</translation>
    </message>
</context>
<context>
    <name>simulation.rendering</name>
    <message>
        <source>rendering %1</source>
        <translation>generación de %1</translation>
    </message>
</context>
<context>
    <name>sync.cost</name>
    <message>
        <source>View %1: its times are known to ±%2, which is ±%3 at the top speed of %4</source>
        <translation>Vista %1: sus tiempos se conocen con ±%2, es decir, ±%3 a la velocidad máxima de %4</translation>
    </message>
</context>
<context>
    <name>sync.cost_of_error</name>
    <message>
        <source>View %1: nothing has measured its time offset; an error of %2 would shift the robot by %3 at the top speed of %4</source>
        <translation>Vista %1: nada ha medido su desfase; un error de %2 desplazaría el robot %3 a la velocidad máxima de %4</translation>
    </message>
</context>
<context>
    <name>sync.drift</name>
    <message>
        <source>Its clock runs %1 ±%2 faster than the first view&apos;s</source>
        <translation>Su reloj va %1 ±%2 más rápido que el de la primera vista</translation>
    </message>
</context>
<context>
    <name>sync.known_to</name>
    <message>
        <source>View %1: its times are known to ±%2</source>
        <translation>Vista %1: sus tiempos se conocen con ±%2</translation>
    </message>
</context>
<context>
    <name>sync.no_residual</name>
    <message>
        <source>The views&apos; disagreement does not grow with the speed: a remaining time error is at most %1, or %2 at the top speed</source>
        <translation>El desacuerdo de las vistas no crece con la velocidad: el error de tiempo restante es como mucho %1, o %2 a la velocidad máxima</translation>
    </message>
</context>
<context>
    <name>sync.not_measured</name>
    <message>
        <source>View %1: nothing has measured its time offset</source>
        <translation>Vista %1: nada ha medido su desfase</translation>
    </message>
</context>
<context>
    <name>sync.pairing</name>
    <message>
        <source>Its frames are %1 on average and at most %2 from the first view&apos;s; positions are interpolated to the same times</source>
        <translation>Sus fotogramas están a %1 de media y como mucho a %2 de los de la primera vista; las posiciones se interpolan a los mismos tiempos</translation>
    </message>
</context>
<context>
    <name>sync.residual</name>
    <message>
        <source>The views disagree the more the faster the robot is, as a time error of %1 ±%2 would make them: %3 at the top speed</source>
        <translation>Las vistas discrepan más cuanto más rápido va el robot, como con un error de tiempo de %1 ±%2: %3 a la velocidad máxima</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_flash</name>
    <message>
        <source>%1 by the flash of light</source>
        <translation>%1 por el destello de luz</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_motion</name>
    <message>
        <source>%1 by the motion</source>
        <translation>%1 por el movimiento</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_sound</name>
    <message>
        <source>%1 by the sound</source>
        <translation>%1 por el sonido</translation>
    </message>
</context>
<context>
    <name>synchronisation.clap_twice</name>
    <message>
        <source>clap twice near the middle of the floor while both cameras record, or give --sync SECONDS</source>
        <translation>dé dos palmadas cerca del centro del suelo mientras graban ambas cámaras, o indique el desfase</translation>
    </message>
</context>
<context>
    <name>synchronisation.clocks_ambiguous</name>
    <message>
        <source>several time offsets, pauses or missing frames explain the views&apos; tracks about equally well</source>
        <translation>varios desfases, pausas o fotogramas perdidos explican casi igual de bien las trayectorias de las vistas</translation>
    </message>
</context>
<context>
    <name>synchronisation.different_runs</name>
    <message>
        <source>the views&apos; tracks match at no time offset, frame rate or pause tried, so the videos may be of different runs</source>
        <translation>las trayectorias de las vistas no coinciden con ningún desfase, frecuencia o pausa probados, por lo que los vídeos pueden ser de recorridos distintos</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_disagrees</name>
    <message>
        <source>the motion gives a time offset of %1, the flash of light gives %2; the motion was used</source>
        <translation>el movimiento indica un desfase de %1, que fue el tomado, y el destello de luz %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_lights</name>
    <message>
        <source>flash the room lights once while both cameras record, or give --sync SECONDS</source>
        <translation>destelle una vez las luces de la sala mientras graban ambas cámaras, o indique el desfase</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_or_clap</name>
    <message>
        <source>flash the room lights or clap twice while both cameras record, or give --sync SECONDS</source>
        <translation>destelle las luces de la sala o dé dos palmadas mientras graban ambas cámaras, o indique el desfase</translation>
    </message>
</context>
<context>
    <name>synchronisation.flashes_fit_alike</name>
    <message>
        <source>the flashes of light fit equally well at time offsets of %1 and %2</source>
        <translation>los destellos de luz encajan por igual con desfases de %1 y %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.from_flash</name>
    <message>
        <source>measured by a flash of light to only ±%1, because %2</source>
        <translation>por un destello de luz, solo a %1, pues %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.from_sound</name>
    <message>
        <source>measured by the sound to only ±%1, because %2</source>
        <translation>por el sonido, solo a ±%1, pues %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.light_flickers</name>
    <message>
        <source>the light flickers</source>
        <translation>la luz parpadea</translation>
    </message>
</context>
<context>
    <name>synchronisation.motion_repeats</name>
    <message>
        <source>the motion repeats itself</source>
        <translation>el movimiento se repite</translation>
    </message>
</context>
<context>
    <name>synchronisation.motion_too_even</name>
    <message>
        <source>the robot turned and changed its speed too little to give the time offset</source>
        <translation>el robot giró y cambió de velocidad demasiado poco para determinar el desfase</translation>
    </message>
</context>
<context>
    <name>synchronisation.neither_tells</name>
    <message>
        <source>%1, and %2</source>
        <translation>%1, y %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.no_flash</name>
    <message>
        <source>neither view shows a flash of light</source>
        <translation>ninguna vista muestra un destello de luz</translation>
    </message>
</context>
<context>
    <name>synchronisation.no_loud_sound</name>
    <message>
        <source>no clap, knock or whistle is heard clearly in both clips</source>
        <translation>ninguna palmada, golpe o silbido destaca en el sonido de ambos clips</translation>
    </message>
</context>
<context>
    <name>synchronisation.none_tells</name>
    <message>
        <source>%1, %2, and %3</source>
        <translation>%1, %2, y %3</translation>
    </message>
</context>
<context>
    <name>synchronisation.of_clips</name>
    <message>
        <source>synchronisation of the clips</source>
        <translation>sincronización de los videos</translation>
    </message>
</context>
<context>
    <name>synchronisation.offset</name>
    <message>
        <source>%1 ±%2</source>
        <translation>%1 ±%2</translation>
    </message>
</context>
<context>
    <name>synchronisation.offsets_fit_alike</name>
    <message>
        <source>time offsets of %1 and %2 fit equally well</source>
        <translation>desfases de %1 y %2 encajan por igual</translation>
    </message>
</context>
<context>
    <name>synchronisation.one_flash</name>
    <message>
        <source>only one of the views shows a flash of light</source>
        <translation>solo una de las vistas muestra un destello de luz</translation>
    </message>
</context>
<context>
    <name>synchronisation.other_flashes</name>
    <message>
        <source>the flashes of light in the views do not match</source>
        <translation>los destellos de luz de las vistas no se corresponden</translation>
    </message>
</context>
<context>
    <name>synchronisation.other_sounds</name>
    <message>
        <source>the loud sounds of the clips do not match</source>
        <translation>los sonidos fuertes de los clips no se corresponden</translation>
    </message>
</context>
<context>
    <name>synchronisation.robot_ran_straight</name>
    <message>
        <source>the robot ran straight at constant speed, so every time offset fits</source>
        <translation>el robot avanzó en línea recta a velocidad constante, por lo que cualquier desfase encaja</translation>
    </message>
</context>
<context>
    <name>synchronisation.robot_rested</name>
    <message>
        <source>the robot stood still, so every time offset fits</source>
        <translation>el robot estuvo parado, por lo que cualquier desfase encaja</translation>
    </message>
</context>
<context>
    <name>synchronisation.robots_disagree</name>
    <message>
        <source>robot %1 gives a time offset of %2, robot %3 gives %4; the second was used</source>
        <translation>el robot %1 indica un desfase de %2, el robot %3 %4, que fue el tomado</translation>
    </message>
</context>
<context>
    <name>synchronisation.seldom_seen</name>
    <message>
        <source>one view saw the robot in fewer than %1 frames</source>
        <translation>una vista vio el robot en menos de %1 imágenes</translation>
    </message>
</context>
<context>
    <name>synchronisation.seldom_together</name>
    <message>
        <source>the views rarely saw the robot at the same time</source>
        <translation>las vistas casi nunca vieron el robot a la vez</translation>
    </message>
</context>
<context>
    <name>synchronisation.short_overlap</name>
    <message>
        <source>the views seem to have only %1 in common, which is too short to be sure</source>
        <translation>las vistas parecen tener solo %1 en común, demasiado poco para estar seguro</translation>
    </message>
</context>
<context>
    <name>synchronisation.sound_beats</name>
    <message>
        <source>the sound is full of beats that are alike, as in music</source>
        <translation>el sonido está lleno de golpes iguales, como en la música</translation>
    </message>
</context>
<context>
    <name>synchronisation.sounds_fit_alike</name>
    <message>
        <source>the sounds of the clips fit equally well at time offsets of %1 and %2</source>
        <translation>los sonidos de los clips encajan por igual con desfases de %1 y %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.views_distorted</name>
    <message>
        <source>the views show the same run, but with another size or direction: a camera has moved since its registration, or the videos are exchanged</source>
        <translation>las vistas muestran el mismo recorrido, pero con otro tamaño u otra dirección: una cámara se movió desde su registro o los vídeos están intercambiados</translation>
    </message>
</context>
<context>
    <name>synchronisation.ways_disagree</name>
    <message>
        <source>the time offsets found disagree: %1; the first was used</source>
        <translation>los desfases hallados no concuerdan: %1; se tomó el primero</translation>
    </message>
</context>
<context>
    <name>tracking.add_robot</name>
    <message>
        <source>add a robot with its colour first</source>
        <translation>añada antes un robot con su color</translation>
    </message>
</context>
<context>
    <name>tracking.add_without_colour</name>
    <message>
        <source>add the robot without a colour; background subtraction then finds it</source>
        <translation>añada el robot sin color, para que se encuentre por lo que lo distingue del suelo</translation>
    </message>
</context>
<context>
    <name>tracking.box_is_grey</name>
    <message>
        <source>the robot in it is grey, black or white</source>
        <translation>lo que difiere del suelo de alrededor es gris, negro o blanco</translation>
    </message>
</context>
<context>
    <name>tracking.box_leaves_nothing</name>
    <message>
        <source>the box leaves no floor around it to compare with</source>
        <translation>el recuadro no deja nada del suelo para comparar</translation>
    </message>
</context>
<context>
    <name>tracking.box_too_small</name>
    <message>
        <source>the box is too small or outside the image</source>
        <translation>el recuadro es demasiado pequeño o está fuera de la imagen</translation>
    </message>
</context>
<context>
    <name>tracking.box_without_colour</name>
    <message>
        <source>it contains no colour that differs from the floor around it</source>
        <translation>no contiene ningún color distinto del suelo de alrededor</translation>
    </message>
</context>
<context>
    <name>tracking.cannot_track</name>
    <message>
        <source>Cannot track</source>
        <translation>No se puede rastrear</translation>
    </message>
</context>
<context>
    <name>tracking.cannot_track_robot</name>
    <message>
        <source>Cannot track robot %1</source>
        <translation>No se puede rastrear el robot %1</translation>
    </message>
</context>
<context>
    <name>tracking.colour_in_box</name>
    <message>
        <source>colour in the box</source>
        <translation>color en el recuadro</translation>
    </message>
</context>
<context>
    <name>tracking.colour_is_grey</name>
    <message>
        <source>its colour %1 is grey, and tracking by colour needs a hue that differs from the floor</source>
        <translation>su color %1 es gris, y solo el tono distingue un robot del suelo</translation>
    </message>
</context>
<context>
    <name>tracking.draw_box_closely</name>
    <message>
        <source>draw it closely round the robot</source>
        <translation>dibújelo ceñido al robot</translation>
    </message>
</context>
<context>
    <name>tracking.draw_box_larger</name>
    <message>
        <source>draw it round the robot, at least 8 pixels wide and high</source>
        <translation>dibújelo alrededor del robot, de al menos 8 píxeles de ancho y alto</translation>
    </message>
</context>
<context>
    <name>tracking.no_robot_given</name>
    <message>
        <source>no robot is given</source>
        <translation>no se indica ningún robot</translation>
    </message>
</context>
<context>
    <name>tracking.put_plate_on_it</name>
    <message>
        <source>draw it closely round the robot, or put a plate of another colour on it</source>
        <translation>dibújelo ceñido al robot, o póngale una placa de otro color</translation>
    </message>
</context>
<context>
    <name>tracking.tell_no_colour</name>
    <message>
        <source>set no colour; background subtraction then finds it</source>
        <translation>no indique ningún color, para que se encuentre por lo que lo distingue del suelo</translation>
    </message>
</context>
<context>
    <name>trajectory.add_view</name>
    <message>
        <source>add a second view, or set one height for the robot</source>
        <translation>añada una segunda vista, o dé al robot una altura</translation>
    </message>
</context>
<context>
    <name>trajectory.analysing_position</name>
    <message>
        <source>analysing position %1</source>
        <translation>analizando la posición %1</translation>
    </message>
</context>
<context>
    <name>trajectory.camera_not_registered</name>
    <message>
        <source>camera %1 is not registered to the floor</source>
        <translation>la cámara %1 no está registrada respecto al suelo</translation>
    </message>
</context>
<context>
    <name>trajectory.cameras_not_registered</name>
    <message>
        <source>cameras %1 are not registered to the floor</source>
        <translation>las cámaras %1 no están registradas respecto al suelo</translation>
    </message>
</context>
<context>
    <name>trajectory.centre_reference</name>
    <message>
        <source>set its reference point to 0,0 and track again</source>
        <translation>dele el punto de referencia 0,0 y vuelva a seguirlo</translation>
    </message>
</context>
<context>
    <name>trajectory.check_robot_and_light</name>
    <message>
        <source>check that the robot moves in the video, that its colour, if set, matches the video, and that the light is sufficient</source>
        <translation>compruebe que el robot se mueve en las imágenes, que un color indicado es el que tiene allí y que la luz es suficiente</translation>
    </message>
</context>
<context>
    <name>trajectory.choose_longer_track</name>
    <message>
        <source>choose a track with more positions</source>
        <translation>elija una traza con más posiciones</translation>
    </message>
</context>
<context>
    <name>trajectory.choose_longer_video</name>
    <message>
        <source>choose a longer video, or check the robot&apos;s colour and the light</source>
        <translation>elija un video más largo, o compruebe el color del robot y la luz</translation>
    </message>
</context>
<context>
    <name>trajectory.cut_by_edge</name>
    <message>
        <source>cut by the frame&apos;s edge</source>
        <translation>cortado por el borde de la imagen</translation>
    </message>
</context>
<context>
    <name>trajectory.cut_by_frames_edge</name>
    <message>
        <source>cut by the frame&apos;s edge in view %1</source>
        <translation>cortado por el borde de la imagen en la vista %1</translation>
    </message>
</context>
<context>
    <name>trajectory.faster_than_limit</name>
    <message>
        <source>speed above the limit</source>
        <translation>más rápido que el límite</translation>
    </message>
</context>
<context>
    <name>trajectory.figures_of_seen</name>
    <message>
        <source>the metrics cover only the measured part</source>
        <translation>los indicadores son de la parte que se vio</translation>
    </message>
</context>
<context>
    <name>trajectory.frames_that_tell</name>
    <message>
        <source>only %2 of %1 frames give a usable position</source>
        <translation>de %1 fotogramas, %2 dan una posición utilizable</translation>
    </message>
</context>
<context>
    <name>trajectory.harder_than_limit</name>
    <message>
        <source>acceleration above the limit</source>
        <translation>aceleración mayor que el límite</translation>
    </message>
</context>
<context>
    <name>trajectory.heading_unknown</name>
    <message>
        <source>its reference point is not the centre of its footprint, but its outlines do not show its heading</source>
        <translation>su punto de referencia está fuera de su centro, pero sus contornos no indican su rumbo</translation>
    </message>
</context>
<context>
    <name>trajectory.hidden_behind</name>
    <message>
        <source>hidden behind %1 in view %2</source>
        <translation>oculto tras %1 en la vista %2</translation>
    </message>
</context>
<context>
    <name>trajectory.import_exchanged</name>
    <message>
        <source>import them again, each for its own camera</source>
        <translation>impórtelos de nuevo, cada uno para su propia cámara</translation>
    </message>
</context>
<context>
    <name>trajectory.import_video</name>
    <message>
        <source>import at least one video for it</source>
        <translation>importe al menos un video para él</translation>
    </message>
</context>
<context>
    <name>trajectory.jump</name>
    <message>
        <source>jump</source>
        <translation>salto</translation>
    </message>
</context>
<context>
    <name>trajectory.jump_of</name>
    <message>
        <source>jump of %1</source>
        <translation>salto de %1</translation>
    </message>
</context>
<context>
    <name>trajectory.look_and_register</name>
    <message>
        <source>check the outlines, and register the cameras again</source>
        <translation>mire los contornos y vuelva a registrar las cámaras</translation>
    </message>
</context>
<context>
    <name>trajectory.move_camera</name>
    <message>
        <source>move or add a camera to cover the whole task</source>
        <translation>mueva o añada una cámara para que se vea toda la tarea</translation>
    </message>
</context>
<context>
    <name>trajectory.no_such_smoother</name>
    <message>
        <source>no smoother has this name</source>
        <translation>no hay ninguno con ese nombre</translation>
    </message>
</context>
<context>
    <name>trajectory.no_view</name>
    <message>
        <source>the trial has no view</source>
        <translation>el ensayo no tiene ninguna vista</translation>
    </message>
</context>
<context>
    <name>trajectory.no_view_trusted</name>
    <message>
        <source>none could be trusted</source>
        <translation>ninguna era fiable</translation>
    </message>
</context>
<context>
    <name>trajectory.not_enough_data</name>
    <message>
        <source>not enough data</source>
        <translation>datos insuficientes</translation>
    </message>
</context>
<context>
    <name>trajectory.not_visible</name>
    <message>
        <source>not visible in view %1</source>
        <translation>no visible en la vista %1</translation>
    </message>
</context>
<context>
    <name>trajectory.occlusion_span</name>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (de %2 a %3)</translation>
    </message>
</context>
<context>
    <name>trajectory.one_outline</name>
    <message>
        <source>outline merged with %1 in view %2</source>
        <translation>un solo contorno con %1 en la vista %2</translation>
    </message>
</context>
<context>
    <name>trajectory.only_unregistered</name>
    <message>
        <source>only cameras that are not registered to the floor saw the robot</source>
        <translation>solo vieron el robot cámaras no registradas respecto al suelo</translation>
    </message>
</context>
<context>
    <name>trajectory.outline_larger</name>
    <message>
        <source>outline larger than usual in view %1</source>
        <translation>contorno mayor de lo habitual en la vista %1</translation>
    </message>
</context>
<context>
    <name>trajectory.outline_smaller</name>
    <message>
        <source>outline smaller than usual in view %1</source>
        <translation>contorno menor de lo habitual en la vista %1</translation>
    </message>
</context>
<context>
    <name>trajectory.partly_hidden_behind</name>
    <message>
        <source>partly hidden behind %1 in view %2</source>
        <translation>parcialmente oculto tras %1 en la vista %2</translation>
    </message>
</context>
<context>
    <name>trajectory.path_not_measured</name>
    <message>
        <source>the robot&apos;s path cannot be measured</source>
        <translation>no se puede medir la trayectoria del robot</translation>
    </message>
</context>
<context>
    <name>trajectory.register_one</name>
    <message>
        <source>run odograph register for at least one of them</source>
        <translation>registre al menos una de ellas</translation>
    </message>
</context>
<context>
    <name>trajectory.register_them</name>
    <message>
        <source>run odograph register for them</source>
        <translation>regístrelas</translation>
    </message>
</context>
<context>
    <name>trajectory.robot_not_found</name>
    <message>
        <source>the robot was not found in any frame of %1</source>
        <translation>el robot no se encontró en ninguna imagen de %1</translation>
    </message>
</context>
<context>
    <name>trajectory.seldom_together</name>
    <message>
        <source>its height is set to be triangulated, but two registered views rarely saw it at the same time</source>
        <translation>su altura debe triangularse, pero dos vistas registradas casi nunca lo vieron a la vez</translation>
    </message>
</context>
<context>
    <name>trajectory.smoother</name>
    <message>
        <source>smoother %1</source>
        <translation>suavizador %1</translation>
    </message>
</context>
<context>
    <name>trajectory.spike_by_hand</name>
    <message>
        <source>marked as a spike by hand</source>
        <translation>marcado como atípico a mano</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_both</name>
    <message>
        <source>spike in position and speed</source>
        <translation>se aparta en posición y velocidad</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_position</name>
    <message>
        <source>spike in position</source>
        <translation>se aparta en posición</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_speed</name>
    <message>
        <source>spike in speed</source>
        <translation>se aparta en velocidad</translation>
    </message>
</context>
<context>
    <name>trajectory.track_first</name>
    <message>
        <source>track the trial&apos;s videos first</source>
        <translation>rastree antes los videos del ensayo</translation>
    </message>
</context>
<context>
    <name>trajectory.tracker_unsure</name>
    <message>
        <source>the tracker was not sure (score %1)</source>
        <translation>el rastreador no estaba seguro (puntuación %1)</translation>
    </message>
</context>
<context>
    <name>trajectory.unmeasured_between</name>
    <message>
        <source>nothing was measured from %1 to %2</source>
        <translation>no se midió nada de %1 a %2</translation>
    </message>
</context>
<context>
    <name>trajectory.unseen_after</name>
    <message>
        <source>no view sees it after %1 (it was at X %2, Y %3)</source>
        <translation>ninguna vista lo ve después de %1 (estaba en X %2, Y %3)</translation>
    </message>
</context>
<context>
    <name>trajectory.unseen_between</name>
    <message>
        <source>no view sees it from %1 to %2 (it was at X %3, Y %4)</source>
        <translation>ninguna vista lo ve de %1 a %2 (estaba en X %3, Y %4)</translation>
    </message>
</context>
<context>
    <name>trajectory.use_smoother</name>
    <message>
        <source>use rts, savgol, tracker or none</source>
        <translation>use rts, savgol, tracker o none</translation>
    </message>
</context>
<context>
    <name>trajectory.view_left_out</name>
    <message>
        <source>one left out</source>
        <translation>se omitió una</translation>
    </message>
</context>
<context>
    <name>trajectory.view_without_frame</name>
    <message>
        <source>view %1 has no frame</source>
        <translation>la vista %1 no tiene fotogramas</translation>
    </message>
</context>
<context>
    <name>trajectory.views_apart</name>
    <message>
        <source>the views&apos; floor positions differ by %1</source>
        <translation>las vistas lo sitúan a %1 de distancia</translation>
    </message>
</context>
<context>
    <name>trajectory.views_disagree</name>
    <message>
        <source>views disagree by %1</source>
        <translation>las vistas discrepan en %1</translation>
    </message>
</context>
<context>
    <name>trajectory.views_exchanged</name>
    <message>
        <source>the videos of %1 and %2 seem to be exchanged: exchanged, they agree</source>
        <translation>los vídeos de %1 y %2 parecen estar intercambiados: intercambiados, concuerdan</translation>
    </message>
</context>
<context>
    <name>trajectory.why_views_apart</name>
    <message>
        <source>a camera has moved since it was registered, the videos belong to other cameras, or one view follows something else</source>
        <translation>una cámara se movió después de registrarla, los vídeos son de otras cámaras o una vista sigue otra cosa</translation>
    </message>
</context>
<context>
    <name>ui.add_camera</name>
    <message>
        <source>add camera %1</source>
        <translation>añadir la cámara %1</translation>
    </message>
</context>
<context>
    <name>ui.add_class</name>
    <message>
        <source>add class %1</source>
        <translation>añadir la clase %1</translation>
    </message>
</context>
<context>
    <name>ui.add_layout</name>
    <message>
        <source>add layout %1</source>
        <translation>añadir el plano %1</translation>
    </message>
</context>
<context>
    <name>ui.add_robot</name>
    <message>
        <source>add robot %1</source>
        <translation>añadir el robot %1</translation>
    </message>
</context>
<context>
    <name>ui.add_task</name>
    <message>
        <source>add task %1</source>
        <translation>añadir la tarea %1</translation>
    </message>
</context>
<context>
    <name>ui.add_team</name>
    <message>
        <source>add team %1</source>
        <translation>añadir el equipo %1</translation>
    </message>
</context>
<context>
    <name>ui.adding_strays</name>
    <message>
        <source>Adding stray videos as trials</source>
        <translation>Añadiendo videos sueltos como ensayos</translation>
    </message>
</context>
<context>
    <name>ui.address_not_here</name>
    <message>
        <source>it is no address of this computer</source>
        <translation>no es una dirección de este equipo</translation>
    </message>
</context>
<context>
    <name>ui.and_more</name>
    <message>
        <source>and %1 more</source>
        <translation>y %1 más</translation>
    </message>
</context>
<context>
    <name>ui.annotated_video</name>
    <message>
        <source>annotated video of &apos;%1&apos;</source>
        <translation>video con anotaciones de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.another_job_runs</name>
    <message>
        <source>another job is running</source>
        <translation>hay otro trabajo en curso</translation>
    </message>
</context>
<context>
    <name>ui.archive_class</name>
    <message>
        <source>archive class %1</source>
        <translation>archivar la clase %1</translation>
    </message>
</context>
<context>
    <name>ui.archive_task</name>
    <message>
        <source>archive task %1</source>
        <translation>archivar la tarea %1</translation>
    </message>
</context>
<context>
    <name>ui.archive_trial</name>
    <message>
        <source>archive %1</source>
        <translation>archivar %1</translation>
    </message>
</context>
<context>
    <name>ui.archive_trials</name>
    <message>
        <source>archive %1 trials</source>
        <translation>archivar %1 ensayos</translation>
    </message>
</context>
<context>
    <name>ui.backup_is_sound</name>
    <message>
        <source>its backup of %1 is intact; it does not contain later changes</source>
        <translation>su copia de seguridad del %1 está íntegra; lo hecho desde entonces no está en ella</translation>
    </message>
</context>
<context>
    <name>ui.board_has_corners</name>
    <message>
        <source>a board has 3 to 30 inner corners each way</source>
        <translation>un tablero tiene de 3 a 30 esquinas interiores en cada sentido</translation>
    </message>
</context>
<context>
    <name>ui.bring_file_back</name>
    <message>
        <source>move the file back there</source>
        <translation>devuelva el archivo a su lugar</translation>
    </message>
</context>
<context>
    <name>ui.calibrate_other_first</name>
    <message>
        <source>calibrate the other one, or import a trial with it, first</source>
        <translation>calibre antes la otra, o importe antes un ensayo con ella</translation>
    </message>
</context>
<context>
    <name>ui.camera_named</name>
    <message>
        <source>camera %1</source>
        <translation>cámara %1</translation>
    </message>
</context>
<context>
    <name>ui.cameras</name>
    <message>
        <source>the cameras</source>
        <translation>las cámaras</translation>
    </message>
</context>
<context>
    <name>ui.cannot_make_another</name>
    <message>
        <source>cannot create another project</source>
        <translation>no se puede crear otro proyecto</translation>
    </message>
</context>
<context>
    <name>ui.cannot_open_another</name>
    <message>
        <source>cannot open another project</source>
        <translation>no se puede abrir otro proyecto</translation>
    </message>
</context>
<context>
    <name>ui.change_pseudonym</name>
    <message>
        <source>change the pseudonym of team %1</source>
        <translation>cambiar el seudónimo del equipo %1</translation>
    </message>
</context>
<context>
    <name>ui.change_robot</name>
    <message>
        <source>change robot %1</source>
        <translation>cambiar el robot %1</translation>
    </message>
</context>
<context>
    <name>ui.change_tags</name>
    <message>
        <source>change the tags of %1</source>
        <translation>cambiar las etiquetas de %1</translation>
    </message>
</context>
<context>
    <name>ui.change_task</name>
    <message>
        <source>change task %1</source>
        <translation>cambiar la tarea %1</translation>
    </message>
</context>
<context>
    <name>ui.change_team</name>
    <message>
        <source>change members and robots of team %1</source>
        <translation>cambiar los miembros y robots del equipo %1</translation>
    </message>
</context>
<context>
    <name>ui.charuco_numbered_in_two_ways</name>
    <message>
        <source>programs number a ChArUco board with %1 rows of squares in two different ways</source>
        <translation>un tablero ChArUco de %1 filas de casillas se numera de dos maneras según el programa</translation>
    </message>
</context>
<context>
    <name>ui.check_hub</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network</source>
        <translation>compruebe la dirección, el usuario en ~/.pgpass y la red</translation>
    </message>
</context>
<context>
    <name>ui.choose_another_port</name>
    <message>
        <source>choose another port, or 0 for any that is free</source>
        <translation>elija otro puerto, o 0 para cualquiera libre</translation>
    </message>
</context>
<context>
    <name>ui.choose_high_port</name>
    <message>
        <source>choose a port of 1024 or more</source>
        <translation>elija un puerto a partir de 1024</translation>
    </message>
</context>
<context>
    <name>ui.choose_logo</name>
    <message>
        <source>choose a PNG, JPEG or SVG image</source>
        <translation>elija una imagen PNG, JPEG o SVG</translation>
    </message>
</context>
<context>
    <name>ui.choose_or_make_class</name>
    <message>
        <source>choose one of them, or create it in the workbench</source>
        <translation>elija una de ellas, o créela en la ventana</translation>
    </message>
</context>
<context>
    <name>ui.choose_own_address</name>
    <message>
        <source>choose 127.0.0.1, an address of this computer, or 0.0.0.0 for all of them</source>
        <translation>elija 127.0.0.1, una dirección de este equipo, o 0.0.0.0 para todas</translation>
    </message>
</context>
<context>
    <name>ui.choose_recorded</name>
    <message>
        <source>choose one that was recorded</source>
        <translation>elija uno que se haya grabado</translation>
    </message>
</context>
<context>
    <name>ui.choose_trial_or_class</name>
    <message>
        <source>choose a trial or a class</source>
        <translation>elija un ensayo o una clase</translation>
    </message>
</context>
<context>
    <name>ui.choose_video_size</name>
    <message>
        <source>choose another, such as 1920x1080</source>
        <translation>elija otro, como 1920x1080</translation>
    </message>
</context>
<context>
    <name>ui.choose_video_speed</name>
    <message>
        <source>choose another, such as 0.25</source>
        <translation>elija otra, como 0.25</translation>
    </message>
</context>
<context>
    <name>ui.clips_being_read</name>
    <message>
        <source>those dropped before are still being read</source>
        <translation>los anteriores aún se están leyendo</translation>
    </message>
</context>
<context>
    <name>ui.completing_recording</name>
    <message>
        <source>Completing an interrupted recording</source>
        <translation>Completando una grabación interrumpida</translation>
    </message>
</context>
<context>
    <name>ui.connect_camera</name>
    <message>
        <source>connect camera %1</source>
        <translation>conectar la cámara %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_class</name>
    <message>
        <source>delete class %1</source>
        <translation>eliminar la clase %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_robot</name>
    <message>
        <source>delete robot %1</source>
        <translation>eliminar el robot %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_task</name>
    <message>
        <source>delete task %1</source>
        <translation>eliminar la tarea %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_team</name>
    <message>
        <source>delete team %1</source>
        <translation>eliminar el equipo %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_trial</name>
    <message>
        <source>delete %1</source>
        <translation>eliminar %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_trials</name>
    <message>
        <source>delete %1 trials</source>
        <translation>eliminar %1 ensayos</translation>
    </message>
</context>
<context>
    <name>ui.does_not_fit_on</name>
    <message>
        <source>%1 by %2 do not fit on %3</source>
        <translation>%1 por %2 no caben en %3</translation>
    </message>
</context>
<context>
    <name>ui.drop_again</name>
    <message>
        <source>drop them again in a moment</source>
        <translation>suéltelos de nuevo en un momento</translation>
    </message>
</context>
<context>
    <name>ui.dropped_clips</name>
    <message>
        <source>the dropped clips</source>
        <translation>los videos soltados</translation>
    </message>
</context>
<context>
    <name>ui.emptying_bin</name>
    <message>
        <source>Emptying the bin</source>
        <translation>Vaciando la papelera</translation>
    </message>
</context>
<context>
    <name>ui.export_of</name>
    <message>
        <source>export of %1</source>
        <translation>exportación de %1</translation>
    </message>
</context>
<context>
    <name>ui.exported_trials</name>
    <message>
        <source>Exported trials: %1 of %2</source>
        <translation>Ensayos exportados: %1 de %2</translation>
    </message>
</context>
<context>
    <name>ui.exporting</name>
    <message>
        <source>Exporting %1 (%2 of %3)</source>
        <translation>Exportando %1 (%2 de %3)</translation>
    </message>
</context>
<context>
    <name>ui.finding_mat</name>
    <message>
        <source>Finding the floor mat</source>
        <translation>Buscando la alfombrilla</translation>
    </message>
</context>
<context>
    <name>ui.floor_mat</name>
    <message>
        <source>floor mat</source>
        <translation>alfombrilla</translation>
    </message>
</context>
<context>
    <name>ui.give_board_size</name>
    <message>
        <source>give a size such as 9x6</source>
        <translation>dé un tamaño como 9x6</translation>
    </message>
</context>
<context>
    <name>ui.give_marker_size</name>
    <message>
        <source>give its size, such as 150mm</source>
        <translation>dé su tamaño, como 150mm</translation>
    </message>
</context>
<context>
    <name>ui.give_mat_size</name>
    <message>
        <source>give a size such as 4x3</source>
        <translation>indique un tamaño como 4x3</translation>
    </message>
</context>
<context>
    <name>ui.give_square_side</name>
    <message>
        <source>give the side of a square, such as 25mm</source>
        <translation>dé el lado de una casilla, como 25mm</translation>
    </message>
</context>
<context>
    <name>ui.html_page</name>
    <message>
        <source>page</source>
        <translation>página</translation>
    </message>
</context>
<context>
    <name>ui.hub_away</name>
    <message>
        <source>it cannot be reached</source>
        <translation>no se puede acceder a él</translation>
    </message>
</context>
<context>
    <name>ui.hub_goes_on</name>
    <message>
        <source>the page shows the last standings until it is back</source>
        <translation>la página muestra la última clasificación hasta que vuelva</translation>
    </message>
</context>
<context>
    <name>ui.hub_silent</name>
    <message>
        <source>the server does not answer</source>
        <translation>el servidor no responde</translation>
    </message>
</context>
<context>
    <name>ui.import_or_record_first</name>
    <message>
        <source>import or record one first</source>
        <translation>importe o grabe uno primero</translation>
    </message>
</context>
<context>
    <name>ui.importing</name>
    <message>
        <source>Importing %1</source>
        <translation>Importando %1</translation>
    </message>
</context>
<context>
    <name>ui.importing_trials</name>
    <message>
        <source>Importing %1 (%2 of %3)</source>
        <translation>Importando %1 (%2 de %3)</translation>
    </message>
</context>
<context>
    <name>ui.is_printer_ready</name>
    <message>
        <source>check that the printer is ready</source>
        <translation>mire si la impresora está lista</translation>
    </message>
</context>
<context>
    <name>ui.job_runs_on_project</name>
    <message>
        <source>a job is running on the project</source>
        <translation>hay un trabajo en curso en el proyecto</translation>
    </message>
</context>
<context>
    <name>ui.lens_of_other_size</name>
    <message>
        <source>its size is %1×%2, but the lens was calibrated at %3×%4</source>
        <translation>es de %1×%2, pero la lente se midió a %3×%4</translation>
    </message>
</context>
<context>
    <name>ui.logo</name>
    <message>
        <source>logo &apos;%1&apos;</source>
        <translation>logotipo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.logo_too_large</name>
    <message>
        <source>it is larger than a hundred megapixels</source>
        <translation>tiene más de cien megapíxeles</translation>
    </message>
</context>
<context>
    <name>ui.look_at_printer</name>
    <message>
        <source>check the printer and its queue, or save the report as PDF</source>
        <translation>mire la impresora y su cola, o guarde el informe como PDF</translation>
    </message>
</context>
<context>
    <name>ui.looking_for_lost</name>
    <message>
        <source>Searching for lost videos</source>
        <translation>Buscando videos perdidos</translation>
    </message>
</context>
<context>
    <name>ui.looking_for_strays</name>
    <message>
        <source>Searching for stray files</source>
        <translation>Buscando archivos sueltos</translation>
    </message>
</context>
<context>
    <name>ui.make_marker_smaller</name>
    <message>
        <source>make it at most %1, or use larger paper</source>
        <translation>hágalo de %1 como máximo, o tome un papel más grande</translation>
    </message>
</context>
<context>
    <name>ui.make_smaller</name>
    <message>
        <source>make it smaller</source>
        <translation>hágala más pequeña</translation>
    </message>
</context>
<context>
    <name>ui.make_squares_smaller</name>
    <message>
        <source>make the squares at most %1, or use larger paper</source>
        <translation>haga las casillas de %1 como máximo, o tome un papel más grande</translation>
    </message>
</context>
<context>
    <name>ui.making_certificate</name>
    <message>
        <source>Simulating the set-up</source>
        <translation>Simulando el montaje</translation>
    </message>
</context>
<context>
    <name>ui.making_demo</name>
    <message>
        <source>Creating the demo lesson</source>
        <translation>Creando la lección demo</translation>
    </message>
</context>
<context>
    <name>ui.making_hashes</name>
    <message>
        <source>Computing the hashes of new recordings</source>
        <translation>Calculando los hashes de las grabaciones nuevas</translation>
    </message>
</context>
<context>
    <name>ui.making_report</name>
    <message>
        <source>Creating the report</source>
        <translation>Creando el informe</translation>
    </message>
</context>
<context>
    <name>ui.making_video</name>
    <message>
        <source>Creating the video of %1</source>
        <translation>Creando el video de %1</translation>
    </message>
</context>
<context>
    <name>ui.making_videos</name>
    <message>
        <source>Creating the video of %1 (%2 of %3)</source>
        <translation>Creando el video de %1 (%2 de %3)</translation>
    </message>
</context>
<context>
    <name>ui.many_trials</name>
    <message>
        <source>many trials</source>
        <translation>muchos ensayos</translation>
    </message>
</context>
<context>
    <name>ui.mat_has_sheets</name>
    <message>
        <source>a mat has 1 to %1 sheets in a row and 1 to %2 rows</source>
        <translation>una alfombrilla tiene de 1 a %1 hojas por fila y de 1 a %2 filas</translation>
    </message>
</context>
<context>
    <name>ui.measuring_again</name>
    <message>
        <source>Reanalysing %1</source>
        <translation>Volviendo a medir %1</translation>
    </message>
</context>
<context>
    <name>ui.measuring_trials_again</name>
    <message>
        <source>Reanalysing %1 (%2 of %3)</source>
        <translation>Volviendo a medir %1 (%2 de %3)</translation>
    </message>
</context>
<context>
    <name>ui.mend_and_choose_again</name>
    <message>
        <source>correct the listed errors, then select these trials again</source>
        <translation>corrija lo que se indica allí y vuelva a elegir estos ensayos</translation>
    </message>
</context>
<context>
    <name>ui.move_team</name>
    <message>
        <source>move team %1 to class %2</source>
        <translation>mover el equipo %1 a la clase %2</translation>
    </message>
</context>
<context>
    <name>ui.name_one_marker</name>
    <message>
        <source>name at least one, for example O</source>
        <translation>nombre al menos uno, como O</translation>
    </message>
</context>
<context>
    <name>ui.no_camera_registered</name>
    <message>
        <source>no camera is registered yet</source>
        <translation>aún no hay ninguna cámara registrada</translation>
    </message>
</context>
<context>
    <name>ui.no_further_page</name>
    <message>
        <source>it accepts no more pages</source>
        <translation>no acepta más páginas</translation>
    </message>
</context>
<context>
    <name>ui.no_marker_to_print</name>
    <message>
        <source>no marker to print</source>
        <translation>no hay ningún marcador que imprimir</translation>
    </message>
</context>
<context>
    <name>ui.no_page</name>
    <message>
        <source>it has no page</source>
        <translation>no tiene ninguna página</translation>
    </message>
</context>
<context>
    <name>ui.no_project_open</name>
    <message>
        <source>no project is open</source>
        <translation>no hay ningún proyecto abierto</translation>
    </message>
</context>
<context>
    <name>ui.no_run_with_figure</name>
    <message>
        <source>none of its teams has a run with the metric &apos;%1&apos;</source>
        <translation>ninguno de sus equipos tiene un recorrido con el indicador &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.no_run_with_figure_in_task</name>
    <message>
        <source>none of its teams has a run with the metric &apos;%1&apos; in the task &apos;%2&apos;</source>
        <translation>ninguno de sus equipos tiene un recorrido con el indicador &apos;%1&apos; en la tarea &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>ui.no_trial_yet</name>
    <message>
        <source>the project has no trial yet</source>
        <translation>aún no hay ningún ensayo</translation>
    </message>
</context>
<context>
    <name>ui.not_printed</name>
    <message>
        <source>it could not be printed</source>
        <translation>no se pudo imprimir</translation>
    </message>
</context>
<context>
    <name>ui.nothing_changed_here</name>
    <message>
        <source>no change was made here</source>
        <translation>aquí no se cambió nada</translation>
    </message>
</context>
<context>
    <name>ui.only_be_read</name>
    <message>
        <source>this project is read-only</source>
        <translation>este proyecto es de solo lectura</translation>
    </message>
</context>
<context>
    <name>ui.only_one_camera</name>
    <message>
        <source>the project has only one camera</source>
        <translation>solo hay una cámara</translation>
    </message>
</context>
<context>
    <name>ui.only_so_many_charuco_markers</name>
    <message>
        <source>only 250 markers exist for a ChArUco board</source>
        <translation>solo hay 250 marcadores para un tablero ChArUco</translation>
    </message>
</context>
<context>
    <name>ui.only_so_many_tags</name>
    <message>
        <source>only %1 tags exist</source>
        <translation>solo hay %1 AprilTags</translation>
    </message>
</context>
<context>
    <name>ui.open_its_project</name>
    <message>
        <source>open the project that it belongs to</source>
        <translation>abra el proyecto al que pertenece</translation>
    </message>
</context>
<context>
    <name>ui.open_project_first</name>
    <message>
        <source>open or create a project first</source>
        <translation>primero abra o cree un proyecto</translation>
    </message>
</context>
<context>
    <name>ui.opening</name>
    <message>
        <source>Opening %1</source>
        <translation>Abriendo %1</translation>
    </message>
</context>
<context>
    <name>ui.packing</name>
    <message>
        <source>Packing the project</source>
        <translation>Empaquetando el proyecto</translation>
    </message>
</context>
<context>
    <name>ui.page_of_trial</name>
    <message>
        <source>page of trial &apos;%1&apos;</source>
        <translation>página del ensayo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.pages_not_taken</name>
    <message>
        <source>it did not accept the pages</source>
        <translation>no ha aceptado las páginas</translation>
    </message>
</context>
<context>
    <name>ui.painting_floor</name>
    <message>
        <source>drawing the floor</source>
        <translation>dibujando el suelo</translation>
    </message>
</context>
<context>
    <name>ui.picture</name>
    <message>
        <source>the image</source>
        <translation>la imagen</translation>
    </message>
</context>
<context>
    <name>ui.picture_of</name>
    <message>
        <source>frame %1 of %2</source>
        <translation>imagen %1 de %2</translation>
    </message>
</context>
<context>
    <name>ui.port_in_use</name>
    <message>
        <source>another program uses this port</source>
        <translation>otro programa usa este puerto</translation>
    </message>
</context>
<context>
    <name>ui.port_not_allowed</name>
    <message>
        <source>the system does not allow this port</source>
        <translation>el sistema no permite este puerto</translation>
    </message>
</context>
<context>
    <name>ui.preview</name>
    <message>
        <source>preview</source>
        <translation>vista previa</translation>
    </message>
</context>
<context>
    <name>ui.print_fewer_markers</name>
    <message>
        <source>print fewer markers</source>
        <translation>imprima menos marcadores</translation>
    </message>
</context>
<context>
    <name>ui.printer_not_reached</name>
    <message>
        <source>it cannot be reached</source>
        <translation>no se puede acceder a ella</translation>
    </message>
</context>
<context>
    <name>ui.printing_on</name>
    <message>
        <source>printing on &apos;%1&apos;</source>
        <translation>impresión en «%1»</translation>
    </message>
</context>
<context>
    <name>ui.project_has_classes</name>
    <message>
        <source>the project has %1</source>
        <translation>el proyecto tiene %1</translation>
    </message>
</context>
<context>
    <name>ui.project_has_no_class</name>
    <message>
        <source>the project has none</source>
        <translation>el proyecto no tiene ninguna</translation>
    </message>
</context>
<context>
    <name>ui.recording_not_there</name>
    <message>
        <source>the recording of camera %1 is not at &apos;%2&apos;</source>
        <translation>la grabación de la cámara %1 no está en &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>ui.register_one_first</name>
    <message>
        <source>register one that sees the markers first</source>
        <translation>registre antes una que vea los marcadores</translation>
    </message>
</context>
<context>
    <name>ui.registering</name>
    <message>
        <source>Registering camera %1</source>
        <translation>Registrando la cámara %1</translation>
    </message>
</context>
<context>
    <name>ui.registration_through_another</name>
    <message>
        <source>registration via another camera</source>
        <translation>registro mediante otra cámara</translation>
    </message>
</context>
<context>
    <name>ui.removing_strays</name>
    <message>
        <source>Removing stray files</source>
        <translation>Eliminando archivos sueltos</translation>
    </message>
</context>
<context>
    <name>ui.rename_class</name>
    <message>
        <source>rename class %1 to %2</source>
        <translation>renombrar la clase %1 como %2</translation>
    </message>
</context>
<context>
    <name>ui.rename_task</name>
    <message>
        <source>rename task %1 to %2</source>
        <translation>renombrar la tarea %1 como %2</translation>
    </message>
</context>
<context>
    <name>ui.rename_team</name>
    <message>
        <source>rename team %1 to %2</source>
        <translation>renombrar el equipo %1 como %2</translation>
    </message>
</context>
<context>
    <name>ui.report</name>
    <message>
        <source>report</source>
        <translation>informe</translation>
    </message>
</context>
<context>
    <name>ui.report_file</name>
    <message>
        <source>report &apos;%1&apos;</source>
        <translation>informe «%1»</translation>
    </message>
</context>
<context>
    <name>ui.report_of_class</name>
    <message>
        <source>report of class &apos;%1&apos;</source>
        <translation>informe de la clase &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.restoring_backup</name>
    <message>
        <source>Restoring the backup</source>
        <translation>Restaurando la copia de seguridad</translation>
    </message>
</context>
<context>
    <name>ui.save_again</name>
    <message>
        <source>save it again in a moment</source>
        <translation>guárdela de nuevo en un momento</translation>
    </message>
</context>
<context>
    <name>ui.save_copy</name>
    <message>
        <source>save a copy and work on the copy</source>
        <translation>guarde una copia y trabaje en ella</translation>
    </message>
</context>
<context>
    <name>ui.saving_copy</name>
    <message>
        <source>Saving a copy</source>
        <translation>Guardando la copia</translation>
    </message>
</context>
<context>
    <name>ui.saving_table</name>
    <message>
        <source>saving the table</source>
        <translation>guardar la tabla</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_address</name>
    <message>
        <source>standings at %1 port %2</source>
        <translation>clasificación en %1 puerto %2</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_project_gone</name>
    <message>
        <source>it was moved or deleted, so the standings ended</source>
        <translation>se movió o eliminó, por lo que la clasificación terminó</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_start_again</name>
    <message>
        <source>start them with the file&apos;s present name</source>
        <translation>iníciela con el nombre actual del archivo</translation>
    </message>
</context>
<context>
    <name>ui.size_is_no_length</name>
    <message>
        <source>its size is not a length</source>
        <translation>su tamaño no es una longitud</translation>
    </message>
</context>
<context>
    <name>ui.star_trial</name>
    <message>
        <source>star %1</source>
        <translation>destacar %1</translation>
    </message>
</context>
<context>
    <name>ui.star_trials</name>
    <message>
        <source>star %1 trials</source>
        <translation>destacar %1 ensayos</translation>
    </message>
</context>
<context>
    <name>ui.synchronising</name>
    <message>
        <source>Synchronising %1</source>
        <translation>Sincronizando %1</translation>
    </message>
</context>
<context>
    <name>ui.table_being_saved</name>
    <message>
        <source>another table is still being saved</source>
        <translation>todavía se está guardando otra tabla</translation>
    </message>
</context>
<context>
    <name>ui.take_at_that_resolution</name>
    <message>
        <source>use that resolution, or calibrate the lens again</source>
        <translation>tómela con esa resolución, o mida de nuevo la lente</translation>
    </message>
</context>
<context>
    <name>ui.take_even_rows</name>
    <message>
        <source>use an even number of rows of inner corners, such as 9x6</source>
        <translation>tome un número par de filas de esquinas interiores, como 9x6</translation>
    </message>
</context>
<context>
    <name>ui.take_fewer_squares</name>
    <message>
        <source>use fewer squares</source>
        <translation>tome menos casillas</translation>
    </message>
</context>
<context>
    <name>ui.take_team_out</name>
    <message>
        <source>remove team %1 from its class</source>
        <translation>sacar el equipo %1 de su clase</translation>
    </message>
</context>
<context>
    <name>ui.taking_over_setup</name>
    <message>
        <source>Copying the set-up</source>
        <translation>Se toma la configuración</translation>
    </message>
</context>
<context>
    <name>ui.target</name>
    <message>
        <source>target</source>
        <translation>patrón</translation>
    </message>
</context>
<context>
    <name>ui.the_range</name>
    <message>
        <source>the range</source>
        <translation>el tramo</translation>
    </message>
</context>
<context>
    <name>ui.the_sample</name>
    <message>
        <source>the sample</source>
        <translation>la muestra</translation>
    </message>
</context>
<context>
    <name>ui.the_trial</name>
    <message>
        <source>the trial</source>
        <translation>el ensayo</translation>
    </message>
</context>
<context>
    <name>ui.track_or_choose_figure</name>
    <message>
        <source>track its trials, or choose another task or metric</source>
        <translation>rastree sus ensayos, o elija otra tarea u otro indicador</translation>
    </message>
</context>
<context>
    <name>ui.tracking</name>
    <message>
        <source>Tracking %1</source>
        <translation>Rastreando %1</translation>
    </message>
</context>
<context>
    <name>ui.trial_without_recording</name>
    <message>
        <source>the trial has no recording</source>
        <translation>el ensayo no tiene ninguna grabación</translation>
    </message>
</context>
<context>
    <name>ui.trials_imported</name>
    <message>
        <source>Trials imported: %1 of %2</source>
        <translation>Ensayos importados: %1 de %2</translation>
    </message>
</context>
<context>
    <name>ui.trials_measured_again</name>
    <message>
        <source>Trials reanalysed: %1 of %2</source>
        <translation>Ensayos vueltos a medir: %1 de %2</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_class</name>
    <message>
        <source>restore class %1 from the archive</source>
        <translation>desarchivar la clase %1</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_task</name>
    <message>
        <source>restore task %1 from the archive</source>
        <translation>desarchivar la tarea %1</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_trial</name>
    <message>
        <source>restore %1 from the archive</source>
        <translation>desarchivar %1</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_trials</name>
    <message>
        <source>restore %1 trials from the archive</source>
        <translation>desarchivar %1 ensayos</translation>
    </message>
</context>
<context>
    <name>ui.undelete_trial</name>
    <message>
        <source>restore %1 from the bin</source>
        <translation>sacar %1 de la papelera</translation>
    </message>
</context>
<context>
    <name>ui.undelete_trials</name>
    <message>
        <source>restore %1 trials from the bin</source>
        <translation>sacar %1 ensayos de la papelera</translation>
    </message>
</context>
<context>
    <name>ui.undo_in_menu</name>
    <message>
        <source>use the window&apos;s Edit menu to undo earlier changes</source>
        <translation>los cambios anteriores se deshacen en el menú Editar de la ventana</translation>
    </message>
</context>
<context>
    <name>ui.unpacking</name>
    <message>
        <source>Unpacking the project</source>
        <translation>Desempaquetando el proyecto</translation>
    </message>
</context>
<context>
    <name>ui.unstar_trial</name>
    <message>
        <source>remove the star from %1</source>
        <translation>quitar la estrella a %1</translation>
    </message>
</context>
<context>
    <name>ui.unstar_trials</name>
    <message>
        <source>remove the star from %1 trials</source>
        <translation>quitar la estrella a %1 ensayos</translation>
    </message>
</context>
<context>
    <name>ui.video_size_wrong</name>
    <message>
        <source>its size of %1x%2 has an odd number of pixels, or is not between 320x180 and 3840x2160</source>
        <translation>su tamaño de %1x%2 es impar, o no está entre 320x180 y 3840x2160</translation>
    </message>
</context>
<context>
    <name>ui.video_speed_wrong</name>
    <message>
        <source>its speed is not between 0.1 and 1</source>
        <translation>su velocidad no está entre 0,1 y 1</translation>
    </message>
</context>
<context>
    <name>ui.videos_made</name>
    <message>
        <source>Videos created: %1 of %2</source>
        <translation>Videos creados: %1 de %2</translation>
    </message>
</context>
<context>
    <name>ui.wait_or_cancel</name>
    <message>
        <source>wait until it is done, or cancel it</source>
        <translation>espere a que termine o cancélelo</translation>
    </message>
</context>
<context>
    <name>ui.write_notes</name>
    <message>
        <source>write notes of %1</source>
        <translation>escribir las notas de %1</translation>
    </message>
</context>
<context>
    <name>ui.writing_back</name>
    <message>
        <source>writing back</source>
        <translation>escribiendo de vuelta</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode</name>
    <message>
        <source>cannot decode the video</source>
        <translation>no se puede descodificar el vídeo</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode_all</name>
    <message>
        <source>cannot decode all of a frame</source>
        <translation>no se puede decodificar un fotograma entero</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode_frame</name>
    <message>
        <source>cannot decode frame %1 of %2</source>
        <translation>no se puede decodificar el fotograma %1 de %2</translation>
    </message>
</context>
<context>
    <name>video.cannot_encode</name>
    <message>
        <source>cannot encode the video</source>
        <translation>no se puede codificar el video</translation>
    </message>
</context>
<context>
    <name>video.cannot_finish</name>
    <message>
        <source>cannot finish the video %1</source>
        <translation>no se puede terminar el video %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_join</name>
    <message>
        <source>cannot join &apos;%1&apos; to a recording</source>
        <translation>no se puede unir &apos;%1&apos; a una grabación</translation>
    </message>
</context>
<context>
    <name>video.cannot_open</name>
    <message>
        <source>cannot open the video %1</source>
        <translation>no se puede abrir el video %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_read_picture</name>
    <message>
        <source>cannot read the image %1</source>
        <translation>no se puede leer la imagen %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_read_sound</name>
    <message>
        <source>cannot read the sound of %1</source>
        <translation>no se puede leer el sonido de %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_show_frame</name>
    <message>
        <source>cannot show frame %1 of %2</source>
        <translation>no se puede mostrar el fotograma %1 de %2</translation>
    </message>
</context>
<context>
    <name>video.cannot_take_image</name>
    <message>
        <source>cannot take &apos;%1&apos; as a frame of a video</source>
        <translation>no se puede tomar &apos;%1&apos; como fotograma de un video</translation>
    </message>
</context>
<context>
    <name>video.cannot_write</name>
    <message>
        <source>cannot write the video %1</source>
        <translation>no se puede escribir el video %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_frame</name>
    <message>
        <source>cannot write a frame to the video %1</source>
        <translation>no se puede escribir un fotograma en el video %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_joined</name>
    <message>
        <source>cannot write the joined recording %1</source>
        <translation>no se puede escribir la grabación unida %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_recording</name>
    <message>
        <source>cannot write the recording %1</source>
        <translation>no se puede escribir la grabación %1</translation>
    </message>
</context>
<context>
    <name>video.chapter_after_gap</name>
    <message>
        <source>by its recording time %1 are missing between &apos;%2&apos; and it; if so, all times behind that are wrong</source>
        <translation>según su hora de grabación faltan %1 entre &apos;%2&apos; y él; si es así, todos los tiempos posteriores son erróneos</translation>
    </message>
</context>
<context>
    <name>video.chapter_codec</name>
    <message>
        <source>its codec is %1, that of &apos;%2&apos; is %3</source>
        <translation>su códec es %1, el de &apos;%2&apos; es %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_hides_frames</name>
    <message>
        <source>some of its frames are hidden, as an editor does that cuts a video</source>
        <translation>algunos de sus fotogramas están ocultos, como hace un editor al recortar un video</translation>
    </message>
</context>
<context>
    <name>video.chapter_mirrored</name>
    <message>
        <source>its frames and those of &apos;%1&apos; are not mirrored alike</source>
        <translation>sus fotogramas y los de &apos;%1&apos; no están reflejados del mismo modo</translation>
    </message>
</context>
<context>
    <name>video.chapter_pixels</name>
    <message>
        <source>its pixel format is %1, that of &apos;%2&apos; is %3</source>
        <translation>su formato de píxel es %1, el de &apos;%2&apos; es %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_recorded_before</name>
    <message>
        <source>by its recording time it was started before &apos;%1&apos;, behind which it was joined; check the order of the files</source>
        <translation>según su hora de grabación empezó antes que &apos;%1&apos;, tras el cual se unió; compruebe el orden de los archivos</translation>
    </message>
</context>
<context>
    <name>video.chapter_restarts</name>
    <message>
        <source>its time stamps begin again or stand still after %1</source>
        <translation>sus marcas de tiempo empiezan de nuevo o se detienen tras %1</translation>
    </message>
</context>
<context>
    <name>video.chapter_set_up</name>
    <message>
        <source>its encoder was set up in another way than that of &apos;%1&apos;</source>
        <translation>su codificador estaba configurado de otro modo que el de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.chapter_size</name>
    <message>
        <source>its frames are %1, those of &apos;%2&apos; are %3</source>
        <translation>sus fotogramas son de %1, los de &apos;%2&apos; de %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_turn</name>
    <message>
        <source>its frames are to be turned by %1°, those of &apos;%2&apos; by %3°</source>
        <translation>sus fotogramas deben girarse %1°, los de &apos;%2&apos; %3°</translation>
    </message>
</context>
<context>
    <name>video.chapter_without_stamps</name>
    <message>
        <source>its frames have no time stamps of their own</source>
        <translation>sus fotogramas no tienen marcas de tiempo propias</translation>
    </message>
</context>
<context>
    <name>video.chapters_of_one_frame</name>
    <message>
        <source>each of the files has a single frame</source>
        <translation>cada archivo tiene un solo fotograma</translation>
    </message>
</context>
<context>
    <name>video.check_its_folder</name>
    <message>
        <source>check that its folder may be written to and has free space</source>
        <translation>compruebe que se puede escribir en su carpeta y que tiene espacio</translation>
    </message>
</context>
<context>
    <name>video.check_picture_place</name>
    <message>
        <source>check the folder, the free space, and that the name ends in .png or .jpg</source>
        <translation>compruebe la carpeta, el espacio libre, y que el nombre termina en .png o .jpg</translation>
    </message>
</context>
<context>
    <name>video.check_room</name>
    <message>
        <source>check the free disk space</source>
        <translation>compruebe que hay espacio en el disco</translation>
    </message>
</context>
<context>
    <name>video.check_the_folder</name>
    <message>
        <source>check that the folder exists, may be written to and has free space</source>
        <translation>compruebe que la carpeta existe, se puede escribir en ella y tiene espacio</translation>
    </message>
</context>
<context>
    <name>video.check_what_was_asked</name>
    <message>
        <source>check the requested size, frame rate and quality</source>
        <translation>compruebe el tamaño, la frecuencia y la calidad pedidos</translation>
    </message>
</context>
<context>
    <name>video.choose_one_of_these</name>
    <message>
        <source>choose one of these</source>
        <translation>elija uno de estos</translation>
    </message>
</context>
<context>
    <name>video.convert_sound_to_aac</name>
    <message>
        <source>convert its sound to AAC</source>
        <translation>convierta su sonido a AAC</translation>
    </message>
</context>
<context>
    <name>video.convert_to_h264</name>
    <message>
        <source>convert it to H.264</source>
        <translation>conviértalo a H.264</translation>
    </message>
</context>
<context>
    <name>video.convert_to_png</name>
    <message>
        <source>convert it to PNG or JPEG</source>
        <translation>conviértala a PNG o JPEG</translation>
    </message>
</context>
<context>
    <name>video.convert_to_smaller</name>
    <message>
        <source>convert it to a smaller size</source>
        <translation>conviértalo a un tamaño menor</translation>
    </message>
</context>
<context>
    <name>video.convert_to_yuv</name>
    <message>
        <source>convert it to 8-bit YUV, e.g. ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4</source>
        <translation>conviértalo a YUV de 8 bits, p. ej. ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4</translation>
    </message>
</context>
<context>
    <name>video.copy_again</name>
    <message>
        <source>copy it again</source>
        <translation>cópiela de nuevo</translation>
    </message>
</context>
<context>
    <name>video.copy_chapter_again</name>
    <message>
        <source>copy it from the camera again: what follows it would get wrong times</source>
        <translation>cópielo de nuevo de la cámara: lo que sigue tendría tiempos erróneos</translation>
    </message>
</context>
<context>
    <name>video.copy_from_camera</name>
    <message>
        <source>copy it from the camera again</source>
        <translation>cópielo de nuevo de la cámara</translation>
    </message>
</context>
<context>
    <name>video.copy_if_cut_short</name>
    <message>
        <source>copy it from the camera again if it was cut short</source>
        <translation>cópielo de nuevo de la cámara si quedó truncado</translation>
    </message>
</context>
<context>
    <name>video.cut_chapter_there</name>
    <message>
        <source>cut it there, and give both parts</source>
        <translation>córtelo ahí e indique ambas partes</translation>
    </message>
</context>
<context>
    <name>video.data_damaged</name>
    <message>
        <source>its data are damaged</source>
        <translation>sus datos están dañados</translation>
    </message>
</context>
<context>
    <name>video.decoder_not_started</name>
    <message>
        <source>its decoder did not start (%1)</source>
        <translation>su decodificador no arrancó (%1)</translation>
    </message>
</context>
<context>
    <name>video.each_at_its_time</name>
    <message>
        <source>each frame keeps its own time</source>
        <translation>cada una cuenta en su propio instante</translation>
    </message>
</context>
<context>
    <name>video.encoder_not_started</name>
    <message>
        <source>the encoder did not start (%1)</source>
        <translation>el codificador no arrancó (%1)</translation>
    </message>
</context>
<context>
    <name>video.ends_early</name>
    <message>
        <source>ends early at %1</source>
        <translation>termina antes de tiempo en %1</translation>
    </message>
</context>
<context>
    <name>video.failed_before</name>
    <message>
        <source>writing failed earlier</source>
        <translation>la escritura ya había fallado antes</translation>
    </message>
</context>
<context>
    <name>video.file_not_read</name>
    <message>
        <source>the file could not be read</source>
        <translation>no se pudo leer el archivo</translation>
    </message>
</context>
<context>
    <name>video.format_differs</name>
    <message>
        <source>its format differs from the video&apos;s</source>
        <translation>su formato difiere del del video</translation>
    </message>
</context>
<context>
    <name>video.frame_left_out</name>
    <message>
        <source>it is left out</source>
        <translation>se omite</translation>
    </message>
</context>
<context>
    <name>video.frames_it_has</name>
    <message>
        <source>it has frames 0 to %1</source>
        <translation>tiene los fotogramas 0 a %1</translation>
    </message>
</context>
<context>
    <name>video.frames_left_out</name>
    <message>
        <source>%1 frames left out</source>
        <translation>%1 fotogramas omitidos</translation>
    </message>
</context>
<context>
    <name>video.frames_not_encodable</name>
    <message>
        <source>frames of this size or chroma format cannot be encoded</source>
        <translation>no se pueden codificar fotogramas de este tamaño o formato de croma</translation>
    </message>
</context>
<context>
    <name>video.give_another_format</name>
    <message>
        <source>set the camera to another format</source>
        <translation>haga que la cámara dé otro formato</translation>
    </message>
</context>
<context>
    <name>video.give_as_images</name>
    <message>
        <source>give images as a folder, with their rate</source>
        <translation>indique las imágenes como carpeta, con su frecuencia</translation>
    </message>
</context>
<context>
    <name>video.give_camera_file</name>
    <message>
        <source>give the file that the camera recorded</source>
        <translation>dé el archivo que grabó la cámara</translation>
    </message>
</context>
<context>
    <name>video.give_chapter_of_camera</name>
    <message>
        <source>give the file as the camera wrote it</source>
        <translation>indique el archivo tal como lo escribió la cámara</translation>
    </message>
</context>
<context>
    <name>video.give_container</name>
    <message>
        <source>give an MP4, MOV, MKV or AVI file</source>
        <translation>dé un archivo MP4, MOV, MKV o AVI</translation>
    </message>
</context>
<context>
    <name>video.give_known_ending</name>
    <message>
        <source>give it one of these endings</source>
        <translation>dele una de estas terminaciones</translation>
    </message>
</context>
<context>
    <name>video.give_rate</name>
    <message>
        <source>give the frames per second, e.g. 30</source>
        <translation>dé los fotogramas por segundo, p. ej. 30</translation>
    </message>
</context>
<context>
    <name>video.give_shorter_clip</name>
    <message>
        <source>give a shorter clip</source>
        <translation>indique un clip más corto</translation>
    </message>
</context>
<context>
    <name>video.h264_needs_even</name>
    <message>
        <source>H.264 needs an even width and height, not %1</source>
        <translation>H.264 necesita ancho y alto pares, no %1</translation>
    </message>
</context>
<context>
    <name>video.header_not_rewritten</name>
    <message>
        <source>its header could not be rewritten</source>
        <translation>no se pudo reescribir su cabecera</translation>
    </message>
</context>
<context>
    <name>video.header_promises</name>
    <message>
        <source>its header promises %1</source>
        <translation>su cabecera promete %1</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_kind</name>
    <message>
        <source>it is not an upright JPEG in colour as the first, &apos;%1&apos;, is</source>
        <translation>no es un JPEG en color y derecho como la primera, &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_layout</name>
    <message>
        <source>its colours are stored in another way than those of the first, &apos;%1&apos;</source>
        <translation>sus colores están guardados de otro modo que los de la primera, &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_size</name>
    <message>
        <source>its size is %1, that of the first, &apos;%2&apos;, is %3</source>
        <translation>su tamaño es %1, el de la primera, &apos;%2&apos;, es %3</translation>
    </message>
</context>
<context>
    <name>video.install_libavcodec</name>
    <message>
        <source>install Debian&apos;s libavcodec</source>
        <translation>instale el libavcodec de Debian</translation>
    </message>
</context>
<context>
    <name>video.install_libx264</name>
    <message>
        <source>install Debian&apos;s libavcodec with libx264</source>
        <translation>instale el libavcodec de Debian con libx264</translation>
    </message>
</context>
<context>
    <name>video.is_finished</name>
    <message>
        <source>it is finished</source>
        <translation>está terminado</translation>
    </message>
</context>
<context>
    <name>video.join_one_recording</name>
    <message>
        <source>join only the files into which a camera has split one recording</source>
        <translation>una solo los archivos en que una cámara dividió una misma grabación</translation>
    </message>
</context>
<context>
    <name>video.joining_chapters</name>
    <message>
        <source>joining &apos;%1&apos;</source>
        <translation>uniendo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.largest_picture</name>
    <message>
        <source>the limit is 50 megapixels and 32000 pixels a side</source>
        <translation>no se leen más de 50 megapíxeles o 32000 píxeles por lado</translation>
    </message>
</context>
<context>
    <name>video.leave_out_image</name>
    <message>
        <source>leave it out, or convert all of them in the same way</source>
        <translation>omítala o convierta todas del mismo modo</translation>
    </message>
</context>
<context>
    <name>video.make_smaller</name>
    <message>
        <source>make it smaller</source>
        <translation>hágala más pequeña</translation>
    </message>
</context>
<context>
    <name>video.name_a_picture</name>
    <message>
        <source>choose an image</source>
        <translation>indique una imagen</translation>
    </message>
</context>
<context>
    <name>video.no_decoder</name>
    <message>
        <source>there is no decoder for %1</source>
        <translation>no hay decodificador para %1</translation>
    </message>
</context>
<context>
    <name>video.no_encoder</name>
    <message>
        <source>the installed libavcodec has no encoder for it</source>
        <translation>el libavcodec instalado no tiene codificador para ello</translation>
    </message>
</context>
<context>
    <name>video.no_ffv1_in_mp4</name>
    <message>
        <source>MP4 cannot contain FFV1</source>
        <translation>FFV1 no cabe en MP4</translation>
    </message>
</context>
<context>
    <name>video.no_frame_written</name>
    <message>
        <source>no frame was written to it</source>
        <translation>no se escribió ningún fotograma en él</translation>
    </message>
</context>
<context>
    <name>video.no_jpeg_layout</name>
    <message>
        <source>JPEG does not support its colour layout</source>
        <translation>JPEG no tiene su disposición de colores</translation>
    </message>
</context>
<context>
    <name>video.no_known_ending</name>
    <message>
        <source>its name ends with neither .mkv nor .mp4</source>
        <translation>su nombre no termina en .mkv ni en .mp4</translation>
    </message>
</context>
<context>
    <name>video.no_picture_format</name>
    <message>
        <source>it is not a PNG, JPEG, TIFF, HEIC, WebP, BMP or PNM image</source>
        <translation>no es una imagen PNG, JPEG, TIFF, HEIC, WebP, BMP ni PNM</translation>
    </message>
</context>
<context>
    <name>video.no_sound</name>
    <message>
        <source>it has no sound</source>
        <translation>no tiene sonido</translation>
    </message>
</context>
<context>
    <name>video.no_stream</name>
    <message>
        <source>it contains no readable video stream</source>
        <translation>no contiene ninguna pista de video legible</translation>
    </message>
</context>
<context>
    <name>video.no_time_scale</name>
    <message>
        <source>its time scale was not found where the muxer should have put it</source>
        <translation>no se halló su escala de tiempo donde el multiplexor debía ponerla</translation>
    </message>
</context>
<context>
    <name>video.no_time_stamps</name>
    <message>
        <source>the file has no time stamps</source>
        <translation>el archivo no tiene marcas de tiempo</translation>
    </message>
</context>
<context>
    <name>video.no_video_kind</name>
    <message>
        <source>it is not a supported kind of video, or its header is damaged or missing (%1)</source>
        <translation>no es un video de un tipo legible, o su cabecera está dañada o falta (%1)</translation>
    </message>
</context>
<context>
    <name>video.no_whole_frame</name>
    <message>
        <source>it contains no complete frame</source>
        <translation>no contiene ni un fotograma entero</translation>
    </message>
</context>
<context>
    <name>video.of_chapter</name>
    <message>
        <source>video &apos;%1&apos;</source>
        <translation>video &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.packet_damaged</name>
    <message>
        <source>a packet is damaged</source>
        <translation>un paquete ahí está dañado</translation>
    </message>
</context>
<context>
    <name>video.picture</name>
    <message>
        <source>image</source>
        <translation>imagen</translation>
    </message>
</context>
<context>
    <name>video.picture_claims_size</name>
    <message>
        <source>its header says that it has %1 pixels</source>
        <translation>dice que tiene %1 píxeles</translation>
    </message>
</context>
<context>
    <name>video.picture_damaged</name>
    <message>
        <source>its content is damaged or cut short</source>
        <translation>su contenido está dañado o truncado</translation>
    </message>
</context>
<context>
    <name>video.picture_file_too_large</name>
    <message>
        <source>the file is larger than 200 MB</source>
        <translation>el archivo ocupa más de 200 MB</translation>
    </message>
</context>
<context>
    <name>video.picture_format_unknown</name>
    <message>
        <source>its format is unknown</source>
        <translation>su formato no se conoce</translation>
    </message>
</context>
<context>
    <name>video.picture_named</name>
    <message>
        <source>image &apos;%1&apos;</source>
        <translation>imagen &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.picture_not_coded</name>
    <message>
        <source>a frame cannot be encoded</source>
        <translation>no se puede codificar una imagen</translation>
    </message>
</context>
<context>
    <name>video.picture_not_packed</name>
    <message>
        <source>it could not be compressed</source>
        <translation>no se pudo comprimir</translation>
    </message>
</context>
<context>
    <name>video.pictures_too_large</name>
    <message>
        <source>its frames have more than 100 megapixels or 32000 pixels a side</source>
        <translation>sus imágenes tienen más de 100 megapíxeles o 32000 píxeles por lado</translation>
    </message>
</context>
<context>
    <name>video.pixel_format_not_read</name>
    <message>
        <source>its pixel format %1 is not supported</source>
        <translation>su formato de píxel %1 no se lee</translation>
    </message>
</context>
<context>
    <name>video.put_into_mp4</name>
    <message>
        <source>put each file into MP4 first, e.g. ffmpeg -i FILE -c copy NEW.mp4</source>
        <translation>ponga antes cada archivo en MP4, p. ej. ffmpeg -i FILE -c copy NEW.mp4</translation>
    </message>
</context>
<context>
    <name>video.rate_not_positive</name>
    <message>
        <source>its frame rate is not positive</source>
        <translation>su frecuencia de fotogramas no es positiva</translation>
    </message>
</context>
<context>
    <name>video.rate_varies</name>
    <message>
        <source>its frame rate varies: frames are %1 to %2 apart</source>
        <translation>su frecuencia de imagen varía, entre imágenes hay de %1 a %2</translation>
    </message>
</context>
<context>
    <name>video.reading_chapter</name>
    <message>
        <source>reading &apos;%1&apos;</source>
        <translation>leyendo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.record_with_sound</name>
    <message>
        <source>switch the camera&apos;s sound on</source>
        <translation>active el sonido de la cámara</translation>
    </message>
</context>
<context>
    <name>video.report_bug</name>
    <message>
        <source>report this as a bug</source>
        <translation>comuníquelo como un error</translation>
    </message>
</context>
<context>
    <name>video.siting_not_set</name>
    <message>
        <source>the chroma siting could not be set (%1)</source>
        <translation>no se pudo fijar la posición del croma (%1)</translation>
    </message>
</context>
<context>
    <name>video.size_not_found</name>
    <message>
        <source>its frame size could not be determined</source>
        <translation>no se pudo averiguar el tamaño de sus imágenes</translation>
    </message>
</context>
<context>
    <name>video.sound_left_out</name>
    <message>
        <source>the sound was left out, because the files it is joined with have none or another kind of it</source>
        <translation>se omitió el sonido, porque los archivos a los que se une no lo tienen o lo tienen de otro tipo</translation>
    </message>
</context>
<context>
    <name>video.sound_part_used</name>
    <message>
        <source>its undamaged part is used</source>
        <translation>se usa la parte intacta</translation>
    </message>
</context>
<context>
    <name>video.sound_too_long</name>
    <message>
        <source>its sound is longer than %1</source>
        <translation>su sonido dura más de %1</translation>
    </message>
</context>
<context>
    <name>video.stamps_repeat</name>
    <message>
        <source>their time stamps repeat that of the frame before</source>
        <translation>sus marcas de tiempo repiten la del fotograma anterior</translation>
    </message>
</context>
<context>
    <name>video.stamps_span</name>
    <message>
        <source>its time stamps span %1</source>
        <translation>sus marcas de tiempo abarcan %1</translation>
    </message>
</context>
<context>
    <name>video.start_it_again</name>
    <message>
        <source>start it again</source>
        <translation>empiécelo de nuevo</translation>
    </message>
</context>
<context>
    <name>video.start_video_again</name>
    <message>
        <source>start the video again</source>
        <translation>empiece de nuevo el video</translation>
    </message>
</context>
<context>
    <name>video.taking_image</name>
    <message>
        <source>taking image %1 of %2</source>
        <translation>tomando la imagen %1 de %2</translation>
    </message>
</context>
<context>
    <name>video.time_not_after</name>
    <message>
        <source>its time is not later than that of the frame before</source>
        <translation>su tiempo no es posterior al del fotograma anterior</translation>
    </message>
</context>
<context>
    <name>video.unknown_format_not_read</name>
    <message>
        <source>its pixel format (unknown) is not supported</source>
        <translation>su formato de píxel (desconocido) no se lee</translation>
    </message>
</context>
<context>
    <name>video.use_another_picture</name>
    <message>
        <source>use another image</source>
        <translation>use otra imagen</translation>
    </message>
</context>
<context>
    <name>video.use_mjpeg</name>
    <message>
        <source>use MJPEG or FFV1, or another size</source>
        <translation>use MJPEG o FFV1, u otro tamaño</translation>
    </message>
</context>
<context>
    <name>video.use_mkv</name>
    <message>
        <source>use the ending .mkv</source>
        <translation>use la terminación .mkv</translation>
    </message>
</context>
<context>
    <name>video.use_other_chroma</name>
    <message>
        <source>use 4:2:0, 4:2:2 or 4:4:4</source>
        <translation>use 4:2:0, 4:2:2 o 4:4:4</translation>
    </message>
</context>
<context>
    <name>video.write_at_least_one</name>
    <message>
        <source>write at least one</source>
        <translation>escriba al menos uno</translation>
    </message>
</context>
<context>
    <name>video.write_in_order</name>
    <message>
        <source>write the frames in order, at least a microsecond apart</source>
        <translation>escriba los fotogramas en orden, con al menos un microsegundo entre ellos</translation>
    </message>
</context>
<context>
    <name>video.write_one_format</name>
    <message>
        <source>write one format to a file</source>
        <translation>escriba un solo formato en un archivo</translation>
    </message>
</context>
<context>
    <name>workflow.accept_results</name>
    <message>
        <source>accept the results of %1</source>
        <translation>aceptar los resultados de %1</translation>
    </message>
</context>
<context>
    <name>workflow.accuracy_given</name>
    <message>
        <source>accurate to %1, as given</source>
        <translation>con una exactitud de %1, según lo indicado</translation>
    </message>
</context>
<context>
    <name>workflow.add_layout_of_mat</name>
    <message>
        <source>add layout %1</source>
        <translation>añadir el plano %1</translation>
    </message>
</context>
<context>
    <name>workflow.add_robot</name>
    <message>
        <source>add one with: odograph robot add PROJECT NAME --colour #rrggbb</source>
        <translation>añada uno en Banco</translation>
    </message>
</context>
<context>
    <name>workflow.added_with_colour</name>
    <message>
        <source>it was added with the colour %1</source>
        <translation>se añadió con el color %1</translation>
    </message>
</context>
<context>
    <name>workflow.address_of_live_positions</name>
    <message>
        <source>address &apos;%1&apos; of live positions</source>
        <translation>dirección &apos;%1&apos; de posiciones en vivo</translation>
    </message>
</context>
<context>
    <name>workflow.analyse_it_again</name>
    <message>
        <source>reanalyse it</source>
        <translation>vuelva a analizarlo</translation>
    </message>
</context>
<context>
    <name>workflow.analysing</name>
    <message>
        <source>analysing</source>
        <translation>analizando</translation>
    </message>
</context>
<context>
    <name>workflow.analysing_robot</name>
    <message>
        <source>analysing %1</source>
        <translation>analizando %1</translation>
    </message>
</context>
<context>
    <name>workflow.another_picture_size</name>
    <message>
        <source>its frames are %1, but the camera was registered at %2</source>
        <translation>sus fotogramas son de %1, pero la cámara se registró a %2</translation>
    </message>
</context>
<context>
    <name>workflow.assumed_lens</name>
    <message>
        <source>its lens was neither calibrated nor determined by the floor&apos;s markers</source>
        <translation>su objetivo no se calibró ni lo determinan los marcadores del suelo</translation>
    </message>
</context>
<context>
    <name>workflow.bad_is_not_accepted</name>
    <message>
        <source>bad results cannot be accepted (%1)</source>
        <translation>los resultados malos no se pueden aceptar (%1)</translation>
    </message>
</context>
<context>
    <name>workflow.beyond_limits</name>
    <message>
        <source>%1 of the samples exceed the limits of task &apos;%2&apos;, so the limits were ignored</source>
        <translation>el %1 de lo medido supera los límites de la tarea &apos;%2&apos;, por lo que se omitieron</translation>
    </message>
</context>
<context>
    <name>workflow.board_in_no_picture</name>
    <message>
        <source>the board was found in none of %1 images (%2)</source>
        <translation>no se encontró el tablero en ninguna de %1 imágenes (%2)</translation>
    </message>
</context>
<context>
    <name>workflow.box_stands_in</name>
    <message>
        <source>the project has none, so a blue box of 260 mm × 190 mm × 60 mm is simulated</source>
        <translation>el proyecto no tiene ninguno, así que se simula una caja azul de 260 mm × 190 mm × 60 mm</translation>
    </message>
</context>
<context>
    <name>workflow.by_layout_and_lens</name>
    <message>
        <source>layout &apos;%1&apos;, lens calibration %2</source>
        <translation>plano &apos;%1&apos;, lente de la calibración %2</translation>
    </message>
</context>
<context>
    <name>workflow.by_layout_without_lens</name>
    <message>
        <source>layout &apos;%1&apos;, lens not calibrated</source>
        <translation>plano &apos;%1&apos;, lente sin calibrar</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_and_reanalyse</name>
    <message>
        <source>calibrate the lens, register the camera again and reanalyse</source>
        <translation>calibre el objetivo, registre la cámara de nuevo y vuelva a analizar</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_at_its_size</name>
    <message>
        <source>calibrate it at the size it records.</source>
        <translation>calíbrela con el tamaño con que graba.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_camera</name>
    <message>
        <source>calibrate camera %1</source>
        <translation>calibrar la cámara %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_if_touched</name>
    <message>
        <source>if zoom, focus or the camera&apos;s settings have changed since, calibrate it again.</source>
        <translation>si desde entonces se tocaron el zoom, el enfoque o los ajustes de la cámara, calíbrela de nuevo.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_it</name>
    <message>
        <source>calibrate it.</source>
        <translation>calíbrela.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_lens_first</name>
    <message>
        <source>calibrate the lens first, or choose another calibration</source>
        <translation>calibre antes la lente, o ponga en vigor otra calibración</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_or_give_picture</name>
    <message>
        <source>calibrate it, import its intrinsics, or give an image or a video as well</source>
        <translation>calíbrela, importe sus parámetros intrínsecos o indique también una imagen o un vídeo</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_or_import_trial</name>
    <message>
        <source>calibrate it, import its intrinsics, or import a trial with it first</source>
        <translation>calíbrela, importe sus parámetros intrínsecos, o importe antes un ensayo con ella</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_pair</name>
    <message>
        <source>calibrate cameras %1 and %2 as a pair</source>
        <translation>calibrar las cámaras %1 y %2 como par</translation>
    </message>
</context>
<context>
    <name>workflow.calibrated_from_pictures</name>
    <message>
        <source>calibrated from %1 images</source>
        <translation>calibrada con %1 imágenes</translation>
    </message>
</context>
<context>
    <name>workflow.calibrating_camera</name>
    <message>
        <source>calibrating camera %1</source>
        <translation>calibrando la cámara %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibration</name>
    <message>
        <source>calibration %1</source>
        <translation>calibración %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibration_of_camera</name>
    <message>
        <source>calibration of camera &apos;%1&apos;</source>
        <translation>calibración de la cámara &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.calibration_picture</name>
    <message>
        <source>calibration image &apos;%1&apos;</source>
        <translation>imagen de calibración &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.camera</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>cámara &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.camera_gave_no_picture</name>
    <message>
        <source>camera &apos;%1&apos; delivered no frame</source>
        <translation>la cámara &apos;%1&apos; no dio ninguna imagen</translation>
    </message>
</context>
<context>
    <name>workflow.camera_given_twice</name>
    <message>
        <source>camera &apos;%1&apos; or its address &apos;%2&apos; was given twice</source>
        <translation>la cámara &apos;%1&apos; o su dirección &apos;%2&apos; se dio dos veces</translation>
    </message>
</context>
<context>
    <name>workflow.camera_given_two_videos</name>
    <message>
        <source>camera &apos;%1&apos; was given two videos</source>
        <translation>a la cámara &apos;%1&apos; se le dieron dos videos</translation>
    </message>
</context>
<context>
    <name>workflow.camera_moved_during</name>
    <message>
        <source>the camera moved by %1 after %2; what it saw from then on was not measured</source>
        <translation>la cámara se movió %1 después de %2; lo que vio desde entonces no se midió</translation>
    </message>
</context>
<context>
    <name>workflow.camera_not_on_floor</name>
    <message>
        <source>camera &apos;%1&apos; is not registered to the floor</source>
        <translation>la cámara &apos;%1&apos; no está registrada respecto al suelo</translation>
    </message>
</context>
<context>
    <name>workflow.camera_not_registered</name>
    <message>
        <source>camera &apos;%1&apos; is not registered</source>
        <translation>la cámara &apos;%1&apos; no está registrada</translation>
    </message>
</context>
<context>
    <name>workflow.camera_sees_too_little</name>
    <message>
        <source>the camera sees too little of the floor between the markers for a run</source>
        <translation>la cámara ve demasiado poco suelo entre los marcadores para un recorrido</translation>
    </message>
</context>
<context>
    <name>workflow.cameras_given_one_file</name>
    <message>
        <source>cameras &apos;%1&apos; and &apos;%2&apos; were given the same file, &apos;%3&apos;</source>
        <translation>las cámaras «%1» y «%2» recibieron el mismo archivo, «%3»</translation>
    </message>
</context>
<context>
    <name>workflow.cameras_share_too_little</name>
    <message>
        <source>no two cameras share enough of the floor between the markers for a run</source>
        <translation>ningún par de cámaras comparte suficiente suelo entre los marcadores para un recorrido</translation>
    </message>
</context>
<context>
    <name>workflow.cause_camera_moved</name>
    <message>
        <source>camera %1 seems to have moved by %2 since its registration</source>
        <translation>la cámara %1 parece haberse movido %2 desde su registro</translation>
    </message>
</context>
<context>
    <name>workflow.cause_camera_moved_at</name>
    <message>
        <source>camera %1 seems to have moved by %2 at %3</source>
        <translation>la cámara %1 parece haberse movido %2 a los %3</translation>
    </message>
</context>
<context>
    <name>workflow.cause_cameras_moved</name>
    <message>
        <source>cameras %1 and %2 seem to have moved since their registration</source>
        <translation>las cámaras %1 y %2 parecen haberse movido desde su registro</translation>
    </message>
</context>
<context>
    <name>workflow.cause_clock_rate</name>
    <message>
        <source>the time offset of view %1 seems to change by %2 in each second</source>
        <translation>el desfase de tiempo de la vista %1 parece cambiar %2 cada segundo</translation>
    </message>
</context>
<context>
    <name>workflow.cause_height</name>
    <message>
        <source>the height given for the robot seems wrong by about %1</source>
        <translation>la altura indicada del robot parece errónea en unos %1</translation>
    </message>
</context>
<context>
    <name>workflow.cause_offset</name>
    <message>
        <source>the time offset of view %1 seems wrong by %2</source>
        <translation>el desfase de tiempo de la vista %1 parece erróneo en %2</translation>
    </message>
</context>
<context>
    <name>workflow.cause_or_cause</name>
    <message>
        <source>%1, or %2</source>
        <translation>%1, o %2</translation>
    </message>
</context>
<context>
    <name>workflow.certificate</name>
    <message>
        <source>certificate</source>
        <translation>certificado</translation>
    </message>
</context>
<context>
    <name>workflow.change_guidance</name>
    <message>
        <source>change the guidance of %1</source>
        <translation>cambiar las indicaciones de %1</translation>
    </message>
</context>
<context>
    <name>workflow.changed_in_file</name>
    <message>
        <source>they were changed in the file</source>
        <translation>se modificaron en el archivo</translation>
    </message>
</context>
<context>
    <name>workflow.chapter_missing</name>
    <message>
        <source>by their names a file is missing between &apos;%1&apos; and &apos;%2&apos;; if so, all times behind it are wrong</source>
        <translation>según sus nombres falta un archivo entre &apos;%1&apos; y &apos;%2&apos;; si es así, todos los tiempos posteriores son erróneos</translation>
    </message>
</context>
<context>
    <name>workflow.chapter_twice</name>
    <message>
        <source>&apos;%1&apos; is given twice</source>
        <translation>&apos;%1&apos; se indicó dos veces</translation>
    </message>
</context>
<context>
    <name>workflow.chapters_out_of_order</name>
    <message>
        <source>by their names &apos;%1&apos; comes before &apos;%2&apos;, and was joined behind it; check the order of the files</source>
        <translation>según sus nombres &apos;%1&apos; va antes que &apos;%2&apos;, y se unió detrás; compruebe el orden de los archivos</translation>
    </message>
</context>
<context>
    <name>workflow.check_cable_and_bandwidth</name>
    <message>
        <source>check the cable, the bandwidth and what else this computer is doing</source>
        <translation>compruebe el cable, el ancho de banda y qué más hace esta computadora</translation>
    </message>
</context>
<context>
    <name>workflow.check_files_and_offset</name>
    <message>
        <source>check the files and the --sync offset</source>
        <translation>compruebe los archivos y el desfase</translation>
    </message>
</context>
<context>
    <name>workflow.check_it_is_connected</name>
    <message>
        <source>check that it is connected and not used by another program</source>
        <translation>compruebe que está conectada y que otro programa no la usa</translation>
    </message>
</context>
<context>
    <name>workflow.check_its_cable</name>
    <message>
        <source>check its cable, and whether another program uses it</source>
        <translation>compruebe su cable y si otro programa la usa</translation>
    </message>
</context>
<context>
    <name>workflow.check_line_is</name>
    <message>
        <source>its check line is 1000 or 200 mm long; no print is off by so much</source>
        <translation>su línea de control mide 1000 o 200 mm; ninguna impresión se desvía tanto</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_analyse_again</name>
    <message>
        <source>run odograph check, or reanalyse the trial</source>
        <translation>compruebe el proyecto, o analice de nuevo el ensayo</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_register_again</name>
    <message>
        <source>check that the camera has not moved, or register it again.</source>
        <translation>compruebe que la cámara no se haya movido, o regístrela de nuevo.</translation>
    </message>
</context>
<context>
    <name>workflow.check_rate</name>
    <message>
        <source>views are matched by time: check --rate if one is in slow motion</source>
        <translation>las vistas se unen por el tiempo; compruebe la frecuencia real si una está en cámara lenta</translation>
    </message>
</context>
<context>
    <name>workflow.check_robot_and_registration</name>
    <message>
        <source>check the robot&apos;s colour and size, and the registrations</source>
        <translation>compruebe el color y el tamaño del robot, y los registros</translation>
    </message>
</context>
<context>
    <name>workflow.check_they_are_connected</name>
    <message>
        <source>check that they are connected and not used by another program</source>
        <translation>compruebe que están conectadas y que otro programa no las usa</translation>
    </message>
</context>
<context>
    <name>workflow.check_views_of_one_run</name>
    <message>
        <source>only one view measures the rest, so check that both belong to one run</source>
        <translation>fuera de eso solo mide una vista, así que compruebe que ambas sean de un mismo recorrido</translation>
    </message>
</context>
<context>
    <name>workflow.check_whether_moved</name>
    <message>
        <source>check whether camera %1 has moved</source>
        <translation>comprobar si la cámara %1 se ha movido</translation>
    </message>
</context>
<context>
    <name>workflow.checking_trials</name>
    <message>
        <source>checks of the trials</source>
        <translation>comprobación de los ensayos</translation>
    </message>
</context>
<context>
    <name>workflow.choose_another_one</name>
    <message>
        <source>choose another one</source>
        <translation>elija otro</translation>
    </message>
</context>
<context>
    <name>workflow.choose_calibration</name>
    <message>
        <source>choose calibration %1 of camera %2</source>
        <translation>elegir la calibración %1 de la cámara %2</translation>
    </message>
</context>
<context>
    <name>workflow.choose_folder_for_demo</name>
    <message>
        <source>choose a folder you can write to, with 300 MB free</source>
        <translation>elija una carpeta en la que pueda escribir, con 300 MB libres</translation>
    </message>
</context>
<context>
    <name>workflow.choose_folder_of_copies</name>
    <message>
        <source>choose the folder where they were copied to</source>
        <translation>elija la carpeta donde se copiaron</translation>
    </message>
</context>
<context>
    <name>workflow.choose_frame</name>
    <message>
        <source>choose one from %1 to %2</source>
        <translation>elija uno de %1 a %2</translation>
    </message>
</context>
<context>
    <name>workflow.choose_interface</name>
    <message>
        <source>choose one that `ip link` lists, or lo to stay on this computer</source>
        <translation>elija una que nombre `ip link`, o lo para quedarse en esta computadora</translation>
    </message>
</context>
<context>
    <name>workflow.choose_measured_frame</name>
    <message>
        <source>choose a frame with a measurement</source>
        <translation>elija un fotograma con una medición</translation>
    </message>
</context>
<context>
    <name>workflow.choose_metric</name>
    <message>
        <source>choose from %1</source>
        <translation>elija entre %1</translation>
    </message>
</context>
<context>
    <name>workflow.choose_one_of_them</name>
    <message>
        <source>choose one of them</source>
        <translation>elija uno de ellos</translation>
    </message>
</context>
<context>
    <name>workflow.choose_other_group</name>
    <message>
        <source>choose other times or another reason</source>
        <translation>elija otros tiempos u otro motivo</translation>
    </message>
</context>
<context>
    <name>workflow.choose_other_range</name>
    <message>
        <source>choose another range</source>
        <translation>elija otro tramo</translation>
    </message>
</context>
<context>
    <name>workflow.choose_range_within</name>
    <message>
        <source>choose a range from 0 to %1</source>
        <translation>elija un tramo de 0 a %1</translation>
    </message>
</context>
<context>
    <name>workflow.choose_registration</name>
    <message>
        <source>choose registration %1 of camera %2</source>
        <translation>elegir el registro %1 de la cámara %2</translation>
    </message>
</context>
<context>
    <name>workflow.choose_robot_of_trial</name>
    <message>
        <source>choose a robot of the trial</source>
        <translation>elija un robot del ensayo</translation>
    </message>
</context>
<context>
    <name>workflow.choose_run_on_layout</name>
    <message>
        <source>choose a run on the same layout</source>
        <translation>elija un recorrido en la misma disposición</translation>
    </message>
</context>
<context>
    <name>workflow.choose_seen_task</name>
    <message>
        <source>choose a task on the floor that they see, or leave the task out</source>
        <translation>elija una tarea en el suelo que ven, o no indique ninguna</translation>
    </message>
</context>
<context>
    <name>workflow.choose_task_with_course</name>
    <message>
        <source>choose a task that has, or leave the task out</source>
        <translation>elija una tarea que los tenga, o no indique ninguna</translation>
    </message>
</context>
<context>
    <name>workflow.choose_time</name>
    <message>
        <source>choose a time from %1 to %2</source>
        <translation>elija un tiempo de %1 a %2</translation>
    </message>
</context>
<context>
    <name>workflow.choose_trial_of_views</name>
    <message>
        <source>choose a trial of two views or more</source>
        <translation>elija un ensayo de dos vistas o más</translation>
    </message>
</context>
<context>
    <name>workflow.choose_with_robot</name>
    <message>
        <source>choose one with --robot</source>
        <translation>elija uno de ellos</translation>
    </message>
</context>
<context>
    <name>workflow.class_without_team</name>
    <message>
        <source>without a team it belongs to no class</source>
        <translation>sin equipo no pertenece a ninguna clase</translation>
    </message>
</context>
<context>
    <name>workflow.clear_range</name>
    <message>
        <source>remove the range of %1</source>
        <translation>quitar el tramo de %1</translation>
    </message>
</context>
<context>
    <name>workflow.clock_jumped</name>
    <message>
        <source>at %1 the clock jumped ahead by %2; later times were corrected</source>
        <translation>en %1 el reloj saltó hacia delante %2; los tiempos posteriores se corrigieron</translation>
    </message>
</context>
<context>
    <name>workflow.clock_restarts</name>
    <message>
        <source>its time stamps begin again or stand still after %1: two files were joined, or the camera&apos;s clock was reset</source>
        <translation>sus marcas de tiempo empiezan de nuevo o se detienen tras %1: se unieron dos archivos o se reinició el reloj de la cámara</translation>
    </message>
</context>
<context>
    <name>workflow.clocks_differ</name>
    <message>
        <source>the clocks of views &apos;%1&apos; and &apos;%2&apos; differ by %3; speeds and times are by the clock of view &apos;%1&apos;</source>
        <translation>los relojes de las vistas «%1» y «%2» difieren en %3; las velocidades y los tiempos siguen el reloj de la vista «%1»</translation>
    </message>
</context>
<context>
    <name>workflow.compared_with_itself</name>
    <message>
        <source>a run cannot be compared with itself</source>
        <translation>un recorrido no se puede comparar consigo mismo</translation>
    </message>
</context>
<context>
    <name>workflow.comparison_of_trial</name>
    <message>
        <source>comparison of trial &apos;%1&apos;</source>
        <translation>comparación del ensayo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.complete_trial</name>
    <message>
        <source>complete %1, whose recording was cut off</source>
        <translation>completar %1, cuya grabación se interrumpió</translation>
    </message>
</context>
<context>
    <name>workflow.completing_recording</name>
    <message>
        <source>completing a recording that was cut off</source>
        <translation>completando una grabación interrumpida</translation>
    </message>
</context>
<context>
    <name>workflow.completing_recordings</name>
    <message>
        <source>completing the recordings</source>
        <translation>completar las grabaciones</translation>
    </message>
</context>
<context>
    <name>workflow.computing_intrinsics</name>
    <message>
        <source>computing the intrinsics</source>
        <translation>calculando los parámetros intrínsecos</translation>
    </message>
</context>
<context>
    <name>workflow.computing_pair</name>
    <message>
        <source>computing the relative position</source>
        <translation>calculando la posición relativa</translation>
    </message>
</context>
<context>
    <name>workflow.copied_while_recorded</name>
    <message>
        <source>its recording has not ended</source>
        <translation>su grabación no ha terminado</translation>
    </message>
</context>
<context>
    <name>workflow.copy_file_again</name>
    <message>
        <source>copy the file from the camera again</source>
        <translation>copie el archivo de la cámara otra vez</translation>
    </message>
</context>
<context>
    <name>workflow.copy_of</name>
    <message>
        <source>copy of &apos;%1&apos;</source>
        <translation>copia de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.copy_trial</name>
    <message>
        <source>copy trial %1 to %2</source>
        <translation>copiar el ensayo %1 como %2</translation>
    </message>
</context>
<context>
    <name>workflow.copying_project</name>
    <message>
        <source>copying the project</source>
        <translation>copiando el proyecto</translation>
    </message>
</context>
<context>
    <name>workflow.corner_off_frame</name>
    <message>
        <source>a corner is outside the frame</source>
        <translation>una esquina está fuera del fotograma</translation>
    </message>
</context>
<context>
    <name>workflow.correct_by_hand</name>
    <message>
        <source>correct %1 by hand</source>
        <translation>corregir %1 a mano</translation>
    </message>
</context>
<context>
    <name>workflow.course_not_seen</name>
    <message>
        <source>the cameras see only %1 of the course of task &apos;%2&apos;</source>
        <translation>las cámaras solo ven el %1 del recorrido de la tarea &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.course_of_task</name>
    <message>
        <source>course of task &apos;%1&apos;</source>
        <translation>recorrido de la tarea &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.course_seen_in_part</name>
    <message>
        <source>no camera sees %1 of the run whole</source>
        <translation>ninguna cámara ve entero el %1 del recorrido</translation>
    </message>
</context>
<context>
    <name>workflow.cut_at_restart</name>
    <message>
        <source>cut it there, and import each part as its own trial</source>
        <translation>córtelo ahí e importe cada parte como un ensayo propio</translation>
    </message>
</context>
<context>
    <name>workflow.damaged_frames</name>
    <message>
        <source>%1 of its %2 frames, from %3 to %4, are damaged and were not measured</source>
        <translation>%1 de sus %2 fotogramas, de %3 a %4, están dañados y no se midieron</translation>
    </message>
</context>
<context>
    <name>workflow.date_to_come</name>
    <message>
        <source>its new date is in the future</source>
        <translation>su nueva fecha está en el futuro</translation>
    </message>
</context>
<context>
    <name>workflow.demo</name>
    <message>
        <source>demo</source>
        <translation>demo</translation>
    </message>
</context>
<context>
    <name>workflow.demo_in</name>
    <message>
        <source>demo in &apos;%1&apos;</source>
        <translation>demo en &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.demo_is_there</name>
    <message>
        <source>%1 already exists</source>
        <translation>%1 ya existe</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_name</name>
    <message>
        <source>from %1 to %2 this may be %3 or %4</source>
        <translation>de %1 a %2 es dudoso si se trata de %3 o de %4</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_name_unknown</name>
    <message>
        <source>from %1 to %2 this may be %3 or another robot that looks the same</source>
        <translation>de %1 a %2 es dudoso si se trata de %3 o de otro robot del mismo aspecto</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_names</name>
    <message>
        <source>from %1 to %2 (the first of %3 times) this may be %4 or %5</source>
        <translation>de %1 a %2 (la primera de %3 veces) es dudoso si se trata de %4 o de %5</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_names_unknown</name>
    <message>
        <source>from %1 to %2 (the first of %3 times) this may be %4 or another robot that looks the same</source>
        <translation>de %1 a %2 (la primera de %3 veces) es dudoso si se trata de %4 o de otro robot del mismo aspecto</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_step</name>
    <message>
        <source>it is synchronised only to %1, which is %2 at 1 m/s</source>
        <translation>está sincronizada solo a %1, que son %2 a 1 m/s</translation>
    </message>
</context>
<context>
    <name>workflow.edit_trial</name>
    <message>
        <source>edit trial %1</source>
        <translation>editar el ensayo %1</translation>
    </message>
</context>
<context>
    <name>workflow.edit_trials</name>
    <message>
        <source>edit %1 trials</source>
        <translation>editar %1 ensayos</translation>
    </message>
</context>
<context>
    <name>workflow.error_estimated</name>
    <message>
        <source>positions to %1, estimated from the track</source>
        <translation>posiciones a %1, estimado a partir de ellas</translation>
    </message>
</context>
<context>
    <name>workflow.error_stated</name>
    <message>
        <source>positions to %1, as stated in the file</source>
        <translation>posiciones a %1, según el archivo</translation>
    </message>
</context>
<context>
    <name>workflow.evaluation_of_trial</name>
    <message>
        <source>evaluation of trial &apos;%1&apos;</source>
        <translation>evaluación del ensayo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.export</name>
    <message>
        <source>export of &apos;%1&apos;</source>
        <translation>exportación de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.faster_disk_or_fewer_cameras</name>
    <message>
        <source>record to a faster disk, or fewer cameras at once</source>
        <translation>grabe en un disco más rápido, o con menos cámaras a la vez</translation>
    </message>
</context>
<context>
    <name>workflow.file_given_twice</name>
    <message>
        <source>&apos;%1&apos; is given twice</source>
        <translation>«%1» se indicó dos veces</translation>
    </message>
</context>
<context>
    <name>workflow.file_of_another_size</name>
    <message>
        <source>its file has %1 bytes, but had %2 when it was added</source>
        <translation>su archivo tiene %1 bytes, pero tenía %2 al añadirse</translation>
    </message>
</context>
<context>
    <name>workflow.file_of_other_content</name>
    <message>
        <source>its file has changed since it was added</source>
        <translation>su archivo ha cambiado desde que se añadió</translation>
    </message>
</context>
<context>
    <name>workflow.file_without_picture</name>
    <message>
        <source>it contains no image</source>
        <translation>no tiene ninguna imagen</translation>
    </message>
</context>
<context>
    <name>workflow.film_progressive</name>
    <message>
        <source>choose a progressive mode of the camera (p, not i)</source>
        <translation>elija un modo progresivo de la cámara (p, no i)</translation>
    </message>
</context>
<context>
    <name>workflow.filmed_at_doubtful_rate</name>
    <message>
        <source>its file says that it was filmed at %1, but its time stamps mean %2</source>
        <translation>su archivo indica que se grabó a %1, pero sus marcas de tiempo significan %2</translation>
    </message>
</context>
<context>
    <name>workflow.filmed_at_rate</name>
    <message>
        <source>it was filmed at %1, as its file says, and plays at %2; its times are those of filming</source>
        <translation>según su archivo se grabó a %1 y se reproduce a %2; sus tiempos son los de la grabación</translation>
    </message>
</context>
<context>
    <name>workflow.first_label_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2, its file says %3, so speeds and times are wrong by %4</source>
        <translation>la vista «%1» se grabó a %2, su archivo indica %3, por lo que velocidades y tiempos tienen un error del %4</translation>
    </message>
</context>
<context>
    <name>workflow.fitting_cameras_together</name>
    <message>
        <source>fitting %1 cameras jointly</source>
        <translation>ajustando %1 cámaras juntas</translation>
    </message>
</context>
<context>
    <name>workflow.fix_camera</name>
    <message>
        <source>fix the camera, register it again and repeat the run</source>
        <translation>fije la cámara, regístrela de nuevo y repita la carrera</translation>
    </message>
</context>
<context>
    <name>workflow.floor_has_its_colour</name>
    <message>
        <source>its colour %1 is also the floor&apos;s (%2 of the frame in view %3)</source>
        <translation>su color %1 es también el del suelo (%2 de la imagen de la vista %3)</translation>
    </message>
</context>
<context>
    <name>workflow.floor_mat</name>
    <message>
        <source>floor mat</source>
        <translation>alfombrilla</translation>
    </message>
</context>
<context>
    <name>workflow.folder</name>
    <message>
        <source>folder &apos;%1&apos;</source>
        <translation>carpeta &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.frame_of_file</name>
    <message>
        <source>frame %1 of &apos;%2&apos;</source>
        <translation>fotograma %1 de &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.frame_of_trial</name>
    <message>
        <source>frame %1 of trial &apos;%2&apos;</source>
        <translation>fotograma %1 del ensayo &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.frame_rate_of</name>
    <message>
        <source>frame rate of %1</source>
        <translation>frecuencia de %1</translation>
    </message>
</context>
<context>
    <name>workflow.frames_doubled</name>
    <message>
        <source>up to %1 frames repeat for %2; later times were corrected</source>
        <translation>hasta %1 los fotogramas se repiten durante %2; los tiempos posteriores se corrigieron</translation>
    </message>
</context>
<context>
    <name>workflow.frames_doubled_unseen</name>
    <message>
        <source>after %1 %2 frames repeat the one before, and its time stamps count them as time; later times were corrected</source>
        <translation>después de %1 %2 fotogramas repiten el anterior y sus marcas de tiempo los cuentan como tiempo; los tiempos posteriores se corrigieron</translation>
    </message>
</context>
<context>
    <name>workflow.frames_frozen</name>
    <message>
        <source>after %1 %2 frames show the same image while the robot went on; they were not measured</source>
        <translation>después de %1, %2 fotogramas muestran la misma imagen mientras el robot seguía; no se midieron</translation>
    </message>
</context>
<context>
    <name>workflow.frames_lost</name>
    <message>
        <source>after %1 the frames of %2 are missing, because the camera paused or lost them; later times were corrected</source>
        <translation>después de %1 faltan los fotogramas de %2, porque la cámara hizo una pausa o los perdió; los tiempos posteriores se corrigieron</translation>
    </message>
</context>
<context>
    <name>workflow.frames_missing</name>
    <message>
        <source>%1 without a frame, where %2 is usual; frames are missing, or its time stamps jump</source>
        <translation>%1 sin fotograma, cuando lo habitual es %2; faltan fotogramas o saltan sus marcas de tiempo</translation>
    </message>
</context>
<context>
    <name>workflow.frames_missing_unseen</name>
    <message>
        <source>after %1 %2 frames are missing that its time stamps do not show: the robot moves too far; later times were corrected</source>
        <translation>después de %1 faltan %2 fotogramas que sus marcas de tiempo no muestran: el robot avanza demasiado; los tiempos posteriores se corrigieron</translation>
    </message>
</context>
<context>
    <name>workflow.frames_not_decoded</name>
    <message>
        <source>%1 of its %2 frames are damaged and were not measured</source>
        <translation>%1 de sus %2 fotogramas están dañados y no se midieron</translation>
    </message>
</context>
<context>
    <name>workflow.frames_without_board</name>
    <message>
        <source>%1 frames: %2</source>
        <translation>%1 fotogramas: %2</translation>
    </message>
</context>
<context>
    <name>workflow.give_another_file</name>
    <message>
        <source>give another file</source>
        <translation>dé otro archivo</translation>
    </message>
</context>
<context>
    <name>workflow.give_another_team</name>
    <message>
        <source>give another team, or change the class of this one</source>
        <translation>indique otro equipo o cambie la clase de este</translation>
    </message>
</context>
<context>
    <name>workflow.give_camera_rate</name>
    <message>
        <source>give the rate at which the camera took the frames</source>
        <translation>indique la frecuencia con la que la cámara tomó los fotogramas</translation>
    </message>
</context>
<context>
    <name>workflow.give_cameras</name>
    <message>
        <source>give one or more, like --camera A=sim:A</source>
        <translation>elija una o más en «Cámaras…»</translation>
    </message>
</context>
<context>
    <name>workflow.give_chapter_once</name>
    <message>
        <source>give each file once, in their order</source>
        <translation>indique cada archivo una vez, en su orden</translation>
    </message>
</context>
<context>
    <name>workflow.give_class_too</name>
    <message>
        <source>give its class too, or another team</source>
        <translation>indique también su clase, u otro equipo</translation>
    </message>
</context>
<context>
    <name>workflow.give_date_of_run</name>
    <message>
        <source>give the date of the run</source>
        <translation>indique la fecha del recorrido</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_file_once</name>
    <message>
        <source>give each file once, to its camera</source>
        <translation>indique cada archivo una vez, con su cámara</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_frame_time</name>
    <message>
        <source>give one time for each frame</source>
        <translation>indique un tiempo por fotograma</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_its_file</name>
    <message>
        <source>give each camera its own video</source>
        <translation>dé a cada cámara su propio video</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_robot_one</name>
    <message>
        <source>give each robot one</source>
        <translation>dé una a cada robot</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_view_its_camera</name>
    <message>
        <source>give each view its own camera</source>
        <translation>dé a cada vista su propia cámara</translation>
    </message>
</context>
<context>
    <name>workflow.give_height_below_camera</name>
    <message>
        <source>give a height below the camera</source>
        <translation>indique una altura por debajo de la cámara</translation>
    </message>
</context>
<context>
    <name>workflow.give_limits_of_fastest</name>
    <message>
        <source>give the task the limits of its fastest robot</source>
        <translation>dé a la tarea los límites de su robot más rápido</translation>
    </message>
</context>
<context>
    <name>workflow.give_offset_for_each</name>
    <message>
        <source>give one offset for each view but the first, like --sync 0.1,0.2, or use --sync auto</source>
        <translation>dé un desfase por cada vista salvo la primera, o elija «Por el movimiento o un destello»</translation>
    </message>
</context>
<context>
    <name>workflow.give_one_table</name>
    <message>
        <source>give one table for each view</source>
        <translation>indique una tabla por vista</translation>
    </message>
</context>
<context>
    <name>workflow.give_own_colours</name>
    <message>
        <source>give each its own colour</source>
        <translation>dé a cada uno un color propio</translation>
    </message>
</context>
<context>
    <name>workflow.give_picture_of_that_size</name>
    <message>
        <source>give an image of that size</source>
        <translation>dé una imagen de ese tamaño</translation>
    </message>
</context>
<context>
    <name>workflow.give_pixels_or_picture</name>
    <message>
        <source>give the markers&apos; pixels, or an image or a video of the floor</source>
        <translation>indique los píxeles de los marcadores, o una imagen o un vídeo del suelo</translation>
    </message>
</context>
<context>
    <name>workflow.give_pre_roll</name>
    <message>
        <source>give a pre-roll of 0 to 10 seconds</source>
        <translation>dé un prerregistro de 0 a 10 segundos</translation>
    </message>
</context>
<context>
    <name>workflow.give_range_in_seconds</name>
    <message>
        <source>give its start and end in seconds</source>
        <translation>indique su inicio y su final en segundos</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_table</name>
    <message>
        <source>give one of them</source>
        <translation>indique uno de los dos</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_times</name>
    <message>
        <source>give their rate or a table of their times, like --rate 30 or --times A=stamps.csv</source>
        <translation>indique la frecuencia real de la cámara</translation>
    </message>
</context>
<context>
    <name>workflow.give_seconds</name>
    <message>
        <source>give the seconds, such as 10</source>
        <translation>dé los segundos, como 10</translation>
    </message>
</context>
<context>
    <name>workflow.give_start_first</name>
    <message>
        <source>give the start first, then a later end</source>
        <translation>indique primero el inicio y después un final posterior</translation>
    </message>
</context>
<context>
    <name>workflow.give_table_of_times</name>
    <message>
        <source>give a table of their times, like --times A=stamps.csv</source>
        <translation>numérelas de una en una</translation>
    </message>
</context>
<context>
    <name>workflow.give_task</name>
    <message>
        <source>give %1 the task %2</source>
        <translation>dar a %1 la tarea %2</translation>
    </message>
</context>
<context>
    <name>workflow.give_team</name>
    <message>
        <source>assign %1 to team %2</source>
        <translation>asignar %1 al equipo %2</translation>
    </message>
</context>
<context>
    <name>workflow.give_team_too</name>
    <message>
        <source>give it a team too</source>
        <translation>indique también un equipo</translation>
    </message>
</context>
<context>
    <name>workflow.give_times_to_view</name>
    <message>
        <source>name the camera of one of the videos</source>
        <translation>indique la cámara de uno de los videos</translation>
    </message>
</context>
<context>
    <name>workflow.give_tracks</name>
    <message>
        <source>give one or more, like --track R=run.csv</source>
        <translation>elija una o más</translation>
    </message>
</context>
<context>
    <name>workflow.give_views</name>
    <message>
        <source>give one view or more, like --video A=a.mp4</source>
        <translation>elija una vista o más</translation>
    </message>
</context>
<context>
    <name>workflow.guidance_of_view</name>
    <message>
        <source>guidance in view &apos;%1&apos;</source>
        <translation>indicaciones en la vista «%1»</translation>
    </message>
</context>
<context>
    <name>workflow.hardly_found</name>
    <message>
        <source>it found robot &apos;%1&apos; in only %2 of the frames in which it should be visible, and the other positions are not checked by a second view</source>
        <translation>encontró el robot &apos;%1&apos; solo en %2 de los fotogramas en los que debería verse, y ninguna segunda vista comprueba las demás posiciones</translation>
    </message>
</context>
<context>
    <name>workflow.hardly_possible</name>
    <message>
        <source>a robot hardly moves at %1 with %2; check units and scale</source>
        <translation>un robot difícilmente se mueve a %1 con %2; revise las unidades y la escala</translation>
    </message>
</context>
<context>
    <name>workflow.has_no_two_views</name>
    <message>
        <source>it does not have two views</source>
        <translation>no tiene dos vistas</translation>
    </message>
</context>
<context>
    <name>workflow.height_above_camera</name>
    <message>
        <source>it is only %1 above the floor, but the points would be at %2</source>
        <translation>está a solo %1 sobre el suelo, pero los puntos estarían a %2</translation>
    </message>
</context>
<context>
    <name>workflow.image_with_video</name>
    <message>
        <source>one is an image and the other a video</source>
        <translation>uno es una imagen y el otro un vídeo</translation>
    </message>
</context>
<context>
    <name>workflow.images</name>
    <message>
        <source>images &apos;%1&apos;</source>
        <translation>imágenes &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.images_missing</name>
    <message>
        <source>missing numbers: %1, the first behind %2; their frames count as lost, and the others keep their times</source>
        <translation>números que faltan: %1, el primero tras el %2; sus fotogramas cuentan como perdidos y los demás conservan sus tiempos</translation>
    </message>
</context>
<context>
    <name>workflow.images_share_number</name>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; have the same number</source>
        <translation>&apos;%1&apos; y &apos;%2&apos; tienen el mismo número</translation>
    </message>
</context>
<context>
    <name>workflow.images_without_times</name>
    <message>
        <source>images have no times</source>
        <translation>las imágenes no tienen tiempos</translation>
    </message>
</context>
<context>
    <name>workflow.import_lens</name>
    <message>
        <source>import the lens calibration of camera %1 from %2</source>
        <translation>importar la lente de la cámara %1 de %2</translation>
    </message>
</context>
<context>
    <name>workflow.import_of_trial</name>
    <message>
        <source>import of trial &apos;%1&apos;</source>
        <translation>importación del ensayo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.import_roster</name>
    <message>
        <source>import the roster %1</source>
        <translation>importar la lista de clase %1</translation>
    </message>
</context>
<context>
    <name>workflow.import_to_turn</name>
    <message>
        <source>import the video again to measure it as it is shown</source>
        <translation>importe el vídeo de nuevo para medirlo tal como se muestra</translation>
    </message>
</context>
<context>
    <name>workflow.import_trial</name>
    <message>
        <source>import trial %1</source>
        <translation>importar el ensayo %1</translation>
    </message>
</context>
<context>
    <name>workflow.import_trial_from</name>
    <message>
        <source>import trial %1 from %2</source>
        <translation>importar el ensayo %1 de %2</translation>
    </message>
</context>
<context>
    <name>workflow.interface_of_live_positions</name>
    <message>
        <source>interface &apos;%1&apos; of live positions</source>
        <translation>interfaz &apos;%1&apos; de las posiciones en vivo</translation>
    </message>
</context>
<context>
    <name>workflow.interlaced</name>
    <message>
        <source>it is interlaced: each frame holds two fields taken one after the other, and each is measured at its own time, with half the lines</source>
        <translation>es entrelazado: cada fotograma contiene dos campos tomados uno tras otro, y cada uno se mide en su propio instante, con la mitad de líneas</translation>
    </message>
</context>
<context>
    <name>workflow.interlaced_whole</name>
    <message>
        <source>it is interlaced, but was measured by whole frames, of which each shows two moments; import it as a new trial to have each field measured at its own time</source>
        <translation>es entrelazado, pero se midió por fotogramas enteros, cada uno de los cuales muestra dos instantes; impórtelo como un ensayo nuevo para que cada campo se mida en su propio instante</translation>
    </message>
</context>
<context>
    <name>workflow.intrinsics_of_camera</name>
    <message>
        <source>intrinsics of camera &apos;%1&apos;</source>
        <translation>parámetros intrínsecos de la cámara &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.is_being_recorded</name>
    <message>
        <source>it is being recorded</source>
        <translation>se está grabando</translation>
    </message>
</context>
<context>
    <name>workflow.join_or_name_camera</name>
    <message>
        <source>give each view a camera of its own, or join the files of one recording with +, like --video A=1.mp4+2.mp4</source>
        <translation>dé a cada vista su propia cámara, o una los archivos de una grabación con +</translation>
    </message>
</context>
<context>
    <name>workflow.joined_videos</name>
    <message>
        <source>videos &apos;%1&apos;</source>
        <translation>videos &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.keeping_pictures</name>
    <message>
        <source>saving the images</source>
        <translation>guardando las imágenes</translation>
    </message>
</context>
<context>
    <name>workflow.label_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2, its file says %3</source>
        <translation>la vista «%1» se grabó a %2, su archivo indica %3</translation>
    </message>
</context>
<context>
    <name>workflow.labels_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2 (its file says %3), or view &apos;%4&apos; at %5 (its file says %6); speeds and times are by the file of view &apos;%4&apos;</source>
        <translation>la vista «%1» se grabó a %2 (su archivo indica %3), o la vista «%4» a %5 (su archivo indica %6); las velocidades y los tiempos siguen el archivo de la vista «%4»</translation>
    </message>
</context>
<context>
    <name>workflow.leave_frame</name>
    <message>
        <source>remove the override of frame %1 of %2</source>
        <translation>dejar el fotograma %1 de %2 al programa</translation>
    </message>
</context>
<context>
    <name>workflow.leave_frames</name>
    <message>
        <source>remove the overrides of %1 samples of %2</source>
        <translation>quitar las decisiones sobre %1 muestras de %2</translation>
    </message>
</context>
<context>
    <name>workflow.leave_one_mat</name>
    <message>
        <source>leave one mat on the floor, and use newer files</source>
        <translation>deje una sola alfombrilla en el suelo y use archivos más recientes</translation>
    </message>
</context>
<context>
    <name>workflow.leave_out_trial</name>
    <message>
        <source>remove %1, which recorded nothing</source>
        <translation>omitir %1, del que no se grabó nada</translation>
    </message>
</context>
<context>
    <name>workflow.lens_at_other_size</name>
    <message>
        <source>its frames are %1, but the lens was calibrated at %2</source>
        <translation>sus fotogramas son de %1, pero la lente se calibró a %2</translation>
    </message>
</context>
<context>
    <name>workflow.lens_cropped_columns</name>
    <message>
        <source>The lens calibration at %1 was cropped on both sides to %2, as the markers confirm.</source>
        <translation>La calibración de la lente a %1 se recortó por ambos lados a %2, como confirman los marcadores.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_cropped_rows</name>
    <message>
        <source>The lens calibration at %1 was cropped above and below to %2, as the markers confirm.</source>
        <translation>La calibración de la lente a %1 se recortó por arriba y por abajo a %2, como confirman los marcadores.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_enlarged</name>
    <message>
        <source>The lens calibration at %1 was fitted to %2 by the markers, which show that the image is enlarged by a factor of %3 (± %4).</source>
        <translation>La calibración de la lente a %1 se ajustó a %2 con los marcadores, que muestran que la imagen está ampliada por un factor de %3 (± %4).</translation>
    </message>
</context>
<context>
    <name>workflow.lens_imported_from</name>
    <message>
        <source>imported from %1</source>
        <translation>importada de %1</translation>
    </message>
</context>
<context>
    <name>workflow.lens_never_calibrated</name>
    <message>
        <source>The lens of camera &apos;%1&apos; is neither calibrated nor determined by the floor&apos;s markers</source>
        <translation>El objetivo de la cámara &apos;%1&apos; no está calibrado ni lo determinan los marcadores del suelo</translation>
    </message>
</context>
<context>
    <name>workflow.lens_part_unknown</name>
    <message>
        <source>The lens calibration at %1 was cropped to %2, but the markers do not show whether the image is enlarged as well, so its focal length is known only to %3: calibrate the lens at %2, or use more markers.</source>
        <translation>La calibración de la lente a %1 se recortó a %2, pero los marcadores no muestran si la imagen está además ampliada, así que su distancia focal solo se conoce con un %3: calibre la lente a %2 o use más marcadores.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_scaled</name>
    <message>
        <source>The lens calibration at %1 was converted to %2.</source>
        <translation>La calibración de la lente a %1 se convirtió a %2.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_turned_either_way</name>
    <message>
        <source>Which way the camera was turned since is not known, so the centre of its images is less certain.</source>
        <translation>No se sabe hacia qué lado se giró la cámara desde entonces, así que el centro de sus imágenes es menos seguro.</translation>
    </message>
</context>
<context>
    <name>workflow.link_lost_video</name>
    <message>
        <source>link a lost video</source>
        <translation>vincular un video perdido</translation>
    </message>
</context>
<context>
    <name>workflow.link_lost_videos</name>
    <message>
        <source>link %1 lost videos</source>
        <translation>vincular %1 videos perdidos</translation>
    </message>
</context>
<context>
    <name>workflow.little_common_time</name>
    <message>
        <source>%1 and %2 long, %3 in common</source>
        <translation>%1 y %2 de duración, %3 en común</translation>
    </message>
</context>
<context>
    <name>workflow.live_positions_to</name>
    <message>
        <source>live positions to %1</source>
        <translation>posiciones en vivo a %1</translation>
    </message>
</context>
<context>
    <name>workflow.live_tracking</name>
    <message>
        <source>live tracking</source>
        <translation>seguimiento en directo</translation>
    </message>
</context>
<context>
    <name>workflow.look_at_outlines</name>
    <message>
        <source>check the outlines, and set the robot&apos;s colour or keep other objects out of view</source>
        <translation>mire los contornos e indique el color del robot, o deje a los demás fuera de las imágenes</translation>
    </message>
</context>
<context>
    <name>workflow.look_for_lost_videos</name>
    <message>
        <source>search for lost videos</source>
        <translation>buscar videos perdidos</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_board_in</name>
    <message>
        <source>detecting the board in %1</source>
        <translation>buscando el tablero en %1</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_board_in_both</name>
    <message>
        <source>detecting the board in %1 and %2</source>
        <translation>buscando el tablero en %1 y %2</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_files</name>
    <message>
        <source>searching for files</source>
        <translation>buscando archivos</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_markers_again</name>
    <message>
        <source>detecting the markers again</source>
        <translation>buscando los marcadores de nuevo</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_markers_in</name>
    <message>
        <source>detecting the markers in %1</source>
        <translation>buscando los marcadores en %1</translation>
    </message>
</context>
<context>
    <name>workflow.looking_through_media</name>
    <message>
        <source>searching the media folder</source>
        <translation>examinando la carpeta de medios</translation>
    </message>
</context>
<context>
    <name>workflow.lost_not_packed</name>
    <message>
        <source>the video of camera %1 in trial &apos;%2&apos; is lost and is not in the packed project</source>
        <translation>el video de la cámara %1 en el ensayo &apos;%2&apos; se perdió y no está en el proyecto empaquetado</translation>
    </message>
</context>
<context>
    <name>workflow.lost_video_not_there</name>
    <message>
        <source>the lost video is not in this folder</source>
        <translation>el video perdido no está ahí</translation>
    </message>
</context>
<context>
    <name>workflow.lost_videos</name>
    <message>
        <source>lost videos</source>
        <translation>videos perdidos</translation>
    </message>
</context>
<context>
    <name>workflow.lost_videos_not_there</name>
    <message>
        <source>none of the %1 lost videos is in this folder</source>
        <translation>ninguno de los %1 videos perdidos está ahí</translation>
    </message>
</context>
<context>
    <name>workflow.made_through_registration</name>
    <message>
        <source>It was made via registration %1 of the project.</source>
        <translation>Se hizo mediante el registro %1 del proyecto.</translation>
    </message>
</context>
<context>
    <name>workflow.made_with_it_already</name>
    <message>
        <source>it already uses that calibration</source>
        <translation>ya se hizo con ella</translation>
    </message>
</context>
<context>
    <name>workflow.making_hash</name>
    <message>
        <source>computing the hash of %1</source>
        <translation>calculando la suma de comprobación de %1</translation>
    </message>
</context>
<context>
    <name>workflow.many_spikes</name>
    <message>
        <source>%1 spikes in %2 positions</source>
        <translation>%1 valores atípicos en %2 posiciones</translation>
    </message>
</context>
<context>
    <name>workflow.map_behind</name>
    <message>
        <source>the map is %1 behind, no frame skipped</source>
        <translation>el mapa va %1 por detrás, nada omitido</translation>
    </message>
</context>
<context>
    <name>workflow.map_behind_and_skipping</name>
    <message>
        <source>the map is %1 behind, %2 frames skipped</source>
        <translation>el mapa va %1 por detrás, %2 omitidos</translation>
    </message>
</context>
<context>
    <name>workflow.mark_spike</name>
    <message>
        <source>mark frame %1 of %2 as a spike</source>
        <translation>marcar el fotograma %1 de %2 como atípico</translation>
    </message>
</context>
<context>
    <name>workflow.mark_spikes</name>
    <message>
        <source>mark %1 samples of %2 as spikes</source>
        <translation>marcar %1 muestras de %2 como atípicas</translation>
    </message>
</context>
<context>
    <name>workflow.markers_for_camera</name>
    <message>
        <source>markers for camera &apos;%1&apos;</source>
        <translation>marcadores para la cámara &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.measure_again</name>
    <message>
        <source>reanalyse %1</source>
        <translation>volver a medir %1</translation>
    </message>
</context>
<context>
    <name>workflow.measure_check_line</name>
    <message>
        <source>measure the line from end mark to end mark</source>
        <translation>mida la línea de marca a marca</translation>
    </message>
</context>
<context>
    <name>workflow.measure_height</name>
    <message>
        <source>measure its height, enter it and reanalyse</source>
        <translation>mida su altura, introdúzcala y reanalice</translation>
    </message>
</context>
<context>
    <name>workflow.measure_it_again</name>
    <message>
        <source>repeat the analysis</source>
        <translation>mídalo de nuevo</translation>
    </message>
</context>
<context>
    <name>workflow.measured_as_stored</name>
    <message>
        <source>an earlier version measured its frames as stored, but its file says to turn, mirror or stretch them</source>
        <translation>una versión anterior midió sus fotogramas tal como están guardados, pero su archivo indica girarlos, reflejarlos o estirarlos</translation>
    </message>
</context>
<context>
    <name>workflow.measured_frames</name>
    <message>
        <source>only %1 of the frames give a position</source>
        <translation>solo %1 de los fotogramas dan una posición</translation>
    </message>
</context>
<context>
    <name>workflow.measured_in_part</name>
    <message>
        <source>%1 of %2 were measured; lengths, times and maxima are at least as large as stated</source>
        <translation>se midieron %1 de %2; longitudes, tiempos y máximos son al menos los indicados</translation>
    </message>
</context>
<context>
    <name>workflow.metric_named</name>
    <message>
        <source>metric &apos;%1&apos;</source>
        <translation>indicador &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.more_frame_steps</name>
    <message>
        <source>up to %1 its frames are wrong at %2 more moments in the same way</source>
        <translation>hasta %1 sus fotogramas son incorrectos en %2 momentos más de la misma manera</translation>
    </message>
</context>
<context>
    <name>workflow.moved_since</name>
    <message>
        <source>it was found moved by %1 since the registration that was used</source>
        <translation>se comprobó que se movió %1 desde el registro utilizado</translation>
    </message>
</context>
<context>
    <name>workflow.name_another_camera</name>
    <message>
        <source>name another camera that is registered</source>
        <translation>indique otra cámara que esté registrada</translation>
    </message>
</context>
<context>
    <name>workflow.name_image_series</name>
    <message>
        <source>give a folder with images such as 000001.png, or a pattern such as FOLDER/%1</source>
        <translation>indique una carpeta con imágenes como 000001.png, o un patrón como FOLDER/%1</translation>
    </message>
</context>
<context>
    <name>workflow.name_its_camera</name>
    <message>
        <source>name one of its cameras</source>
        <translation>indique una de sus cámaras</translation>
    </message>
</context>
<context>
    <name>workflow.name_its_robot</name>
    <message>
        <source>name one of its robots</source>
        <translation>indique uno de sus robots</translation>
    </message>
</context>
<context>
    <name>workflow.name_one_series</name>
    <message>
        <source>name one of them, like FOLDER/%1</source>
        <translation>indique una de ellas, como FOLDER/%1</translation>
    </message>
</context>
<context>
    <name>workflow.name_place_in_pixels</name>
    <message>
        <source>give it in pixels from the frame&apos;s top left corner</source>
        <translation>indíquelo en píxeles desde la esquina superior izquierda de la imagen</translation>
    </message>
</context>
<context>
    <name>workflow.name_robot_after_track</name>
    <message>
        <source>give the robot the name of one of them</source>
        <translation>dé al robot el nombre de una de ellas</translation>
    </message>
</context>
<context>
    <name>workflow.name_time_within_trial</name>
    <message>
        <source>name a time within the trial, in seconds</source>
        <translation>indique un momento dentro del ensayo, en segundos</translation>
    </message>
</context>
<context>
    <name>workflow.name_two_cameras</name>
    <message>
        <source>name two cameras</source>
        <translation>indique dos cámaras</translation>
    </message>
</context>
<context>
    <name>workflow.nearly_all_beyond_limits</name>
    <message>
        <source>nearly all samples exceed the limits of task &apos;%1&apos;, so the limits were ignored</source>
        <translation>casi todo lo medido supera los límites de la tarea &apos;%1&apos;, por lo que se omitieron</translation>
    </message>
</context>
<context>
    <name>workflow.neither_lens_nor_recording</name>
    <message>
        <source>it has no intrinsics and no recording</source>
        <translation>no tiene parámetros intrínsecos ni grabación</translation>
    </message>
</context>
<context>
    <name>workflow.never_calibrated</name>
    <message>
        <source>it was never calibrated</source>
        <translation>nunca se calibró</translation>
    </message>
</context>
<context>
    <name>workflow.new_project</name>
    <message>
        <source>new project</source>
        <translation>proyecto nuevo</translation>
    </message>
</context>
<context>
    <name>workflow.no_address_with_port</name>
    <message>
        <source>it is not an IPv4 address with a port</source>
        <translation>no es una dirección IPv4 con puerto</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_gave_picture</name>
    <message>
        <source>no camera delivered a frame</source>
        <translation>ninguna cámara dio una imagen</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_given</name>
    <message>
        <source>no camera was given</source>
        <translation>no se dio ninguna cámara</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_registered</name>
    <message>
        <source>no camera is registered to the floor</source>
        <translation>ninguna cámara está registrada respecto al suelo</translation>
    </message>
</context>
<context>
    <name>workflow.no_common_place</name>
    <message>
        <source>The two analyses have no position in common.</source>
        <translation>Ningún lugar fue medido por ambos análisis.</translation>
    </message>
</context>
<context>
    <name>workflow.no_common_time</name>
    <message>
        <source>views &apos;%1&apos; and &apos;%2&apos; do not overlap with a time offset of %3</source>
        <translation>las vistas &apos;%1&apos; y &apos;%2&apos; no tienen tiempo en común con un desfase de %3</translation>
    </message>
</context>
<context>
    <name>workflow.no_counterpart</name>
    <message>
        <source>the other camera has no file of its number</source>
        <translation>la otra cámara no tiene un archivo con ese número</translation>
    </message>
</context>
<context>
    <name>workflow.no_image_series</name>
    <message>
        <source>there are no numbered images (PNG, JPEG, TIFF, BMP, WebP) of that name</source>
        <translation>no hay imágenes numeradas (PNG, JPEG, TIFF, BMP, WebP) con ese nombre</translation>
    </message>
</context>
<context>
    <name>workflow.no_live_positions</name>
    <message>
        <source>none of its cameras is registered to the floor, so there are no live positions to send</source>
        <translation>ninguna de sus cámaras está registrada respecto al suelo, así que no hay posiciones en vivo que enviar</translation>
    </message>
</context>
<context>
    <name>workflow.no_mat_seen</name>
    <message>
        <source>no file shows four or more of its tags</source>
        <translation>ningún archivo muestra cuatro o más de sus etiquetas</translation>
    </message>
</context>
<context>
    <name>workflow.no_motion</name>
    <message>
        <source>no robot moves in it</source>
        <translation>ningún robot se mueve en él</translation>
    </message>
</context>
<context>
    <name>workflow.no_multicast</name>
    <message>
        <source>interface &apos;%1&apos; does not support multicast</source>
        <translation>la interfaz &apos;%1&apos; no admite multidifusión</translation>
    </message>
</context>
<context>
    <name>workflow.no_picture_read</name>
    <message>
        <source>no image could be read</source>
        <translation>no se pudo leer ninguna imagen</translation>
    </message>
</context>
<context>
    <name>workflow.no_picture_then</name>
    <message>
        <source>the view has no frame at that time</source>
        <translation>la vista no tiene ninguna imagen en ese momento</translation>
    </message>
</context>
<context>
    <name>workflow.no_pixels_no_picture</name>
    <message>
        <source>it needs pixels, or an image to detect the markers in</source>
        <translation>no se dieron ni sus píxeles ni una imagen donde buscar</translation>
    </message>
</context>
<context>
    <name>workflow.no_robot</name>
    <message>
        <source>the project has no robot to track</source>
        <translation>el proyecto no tiene ningún robot que buscar</translation>
    </message>
</context>
<context>
    <name>workflow.no_sample</name>
    <message>
        <source>the analysis has no sample</source>
        <translation>el análisis no tiene ninguna muestra</translation>
    </message>
</context>
<context>
    <name>workflow.no_sample_in_group</name>
    <message>
        <source>no sample from %1 to %2 is to be changed</source>
        <translation>de %1 a %2 no hay ninguna muestra que cambiar</translation>
    </message>
</context>
<context>
    <name>workflow.no_socket</name>
    <message>
        <source>the system could not open a socket</source>
        <translation>esta computadora no da ningún socket</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_frame</name>
    <message>
        <source>this frame does not exist</source>
        <translation>no existe ese fotograma</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_interface</name>
    <message>
        <source>this computer has no interface of that name</source>
        <translation>esta computadora no tiene ninguna con ese nombre</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_metric</name>
    <message>
        <source>no trial of the project has it</source>
        <translation>ningún ensayo del proyecto lo tiene</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_view</name>
    <message>
        <source>the trial has no such view</source>
        <translation>el ensayo no tiene esa vista</translation>
    </message>
</context>
<context>
    <name>workflow.no_times_in_file</name>
    <message>
        <source>it has no time stamps and states no frame rate</source>
        <translation>no tiene marcas de tiempo ni indica la frecuencia de imágenes</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_given</name>
    <message>
        <source>no track was given</source>
        <translation>no se dio ninguna traza</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_imported</name>
    <message>
        <source>no track of it was imported</source>
        <translation>no se importó ninguna traza de él</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_of_that_name</name>
    <message>
        <source>none of its tracks is called &apos;%1&apos;; it has %2</source>
        <translation>ninguna de sus trazas se llama &apos;%1&apos;; tiene %2</translation>
    </message>
</context>
<context>
    <name>workflow.no_video_given</name>
    <message>
        <source>no video was given</source>
        <translation>no se dio ningún video</translation>
    </message>
</context>
<context>
    <name>workflow.no_video_lost</name>
    <message>
        <source>no video of this project is lost</source>
        <translation>no falta ningún video de este proyecto</translation>
    </message>
</context>
<context>
    <name>workflow.none_of_that_number</name>
    <message>
        <source>camera &apos;%1&apos; has no such number</source>
        <translation>la cámara &apos;%1&apos; no tiene ninguna con ese número</translation>
    </message>
</context>
<context>
    <name>workflow.not_measured_in_range</name>
    <message>
        <source>it contains no sample of robot &apos;%1&apos; (%2 to %3)</source>
        <translation>no contiene ninguna muestra del robot &apos;%1&apos; (de %2 a %3)</translation>
    </message>
</context>
<context>
    <name>workflow.not_measured_there</name>
    <message>
        <source>the robot has no measurement at that time</source>
        <translation>el robot no se midió ahí, así que no hay nada que juzgar</translation>
    </message>
</context>
<context>
    <name>workflow.not_synchronised</name>
    <message>
        <source>it is not synchronised: the same start time as the first view was assumed, and positions of a moving robot are wrong</source>
        <translation>no está sincronizada sino tomada como iniciada con la primera vista, de modo que un robot en movimiento no está donde lo sitúan las dos vistas</translation>
    </message>
</context>
<context>
    <name>workflow.not_tracked_in_trial</name>
    <message>
        <source>it is not tracked in trial &apos;%1&apos;</source>
        <translation>no se sigue en el ensayo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.not_tracked_yet</name>
    <message>
        <source>it has not been tracked yet</source>
        <translation>aún no se ha rastreado</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_came</name>
    <message>
        <source>no frame arrived for %1 because %2</source>
        <translation>no llegó nada durante %1, porque %2</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_recorded</name>
    <message>
        <source>nothing was recorded</source>
        <translation>no se grabó nada</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_said_there</name>
    <message>
        <source>that frame has no manual override</source>
        <translation>ahí no se dijo nada a mano</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_stands_out</name>
    <message>
        <source>no foreground object was found at pixel %1,%2 at %3</source>
        <translation>nada se distingue del suelo en %1,%2 a los %3 durante algunas imágenes</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_accept</name>
    <message>
        <source>all checks were passed</source>
        <translation>se superaron todas las comprobaciones</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_analyse_again</name>
    <message>
        <source>it has not been tracked yet, so it cannot be reanalysed</source>
        <translation>aún no se ha rastreado, así que no hay nada que volver a analizar</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_do</name>
    <message>
        <source>no action is needed</source>
        <translation>no hay nada que hacer</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_withdraw</name>
    <message>
        <source>leave it as it is</source>
        <translation>déjelo como está</translation>
    </message>
</context>
<context>
    <name>workflow.number_files_alike</name>
    <message>
        <source>give as many of each, in the same order, or number their names alike</source>
        <translation>indique el mismo número de cada una, en el mismo orden, o numere sus nombres igual</translation>
    </message>
</context>
<context>
    <name>workflow.number_images_once</name>
    <message>
        <source>give each image a number of its own</source>
        <translation>dé a cada imagen un número propio</translation>
    </message>
</context>
<context>
    <name>workflow.numbers_count_no_frames</name>
    <message>
        <source>their numbers go from %1 to %2, and there are %3 images: they do not count frames</source>
        <translation>sus números van de %1 a %2 y hay %3 imágenes: no cuentan fotogramas</translation>
    </message>
</context>
<context>
    <name>workflow.offsets_of_other_count</name>
    <message>
        <source>the number of views is %1, the number of offsets %2</source>
        <translation>se dieron %1 vistas y los desfases de %2</translation>
    </message>
</context>
<context>
    <name>workflow.old_calibration</name>
    <message>
        <source>The lens calibration of camera &apos;%1&apos; is %2 days old</source>
        <translation>La calibración de la lente de la cámara &apos;%1&apos; tiene %2 días</translation>
    </message>
</context>
<context>
    <name>workflow.old_registration</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; is %2 days old</source>
        <translation>El registro al suelo de la cámara &apos;%1&apos; tiene %2 días</translation>
    </message>
</context>
<context>
    <name>workflow.one_follows_something_else</name>
    <message>
        <source>one of them tracks another object, or has moved since its registration</source>
        <translation>una de ellas sigue otra cosa, o no está donde se registró</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_doubled</name>
    <message>
        <source>after %1 a frame repeats the one before, and its time stamps count it as time; later times were corrected</source>
        <translation>después de %1 un fotograma repite el anterior y sus marcas de tiempo lo cuentan como tiempo; los tiempos posteriores se corrigieron</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_missing</name>
    <message>
        <source>after %1 a frame is missing that its time stamps do not show: the robot moves too far; later times were corrected</source>
        <translation>después de %1 falta un fotograma que sus marcas de tiempo no muestran: el robot avanza demasiado; los tiempos posteriores se corrigieron</translation>
    </message>
</context>
<context>
    <name>workflow.only_frame</name>
    <message>
        <source>its only frame is 0</source>
        <translation>el único es el fotograma 0</translation>
    </message>
</context>
<context>
    <name>workflow.open_it_or_elsewhere</name>
    <message>
        <source>open it, or choose another folder</source>
        <translation>ábralo, o elija otra carpeta</translation>
    </message>
</context>
<context>
    <name>workflow.other_sample_judged</name>
    <message>
        <source>another sample was overridden while this one was analysed</source>
        <translation>otra muestra se juzgó a mano mientras se analizaba esta</translation>
    </message>
</context>
<context>
    <name>workflow.outside_picture</name>
    <message>
        <source>the position is outside the frame</source>
        <translation>el lugar está fuera de la imagen</translation>
    </message>
</context>
<context>
    <name>workflow.pair_like_files</name>
    <message>
        <source>pair images with images and videos with videos</source>
        <translation>empareje imágenes con imágenes y vídeos con vídeos</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_cameras</name>
    <message>
        <source>the relative position of cameras &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>la posición relativa de las cámaras &apos;%1&apos; y &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_one_camera</name>
    <message>
        <source>both are the same camera</source>
        <translation>ambas son la misma cámara</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_other_size</name>
    <message>
        <source>&apos;%1&apos; is %2, but the camera was calibrated at %3</source>
        <translation>&apos;%1&apos; es de %2, pero la cámara se calibró a %3</translation>
    </message>
</context>
<context>
    <name>workflow.paired_files</name>
    <message>
        <source>the files of the two cameras</source>
        <translation>los archivos de las dos cámaras</translation>
    </message>
</context>
<context>
    <name>workflow.passed_cameras</name>
    <message>
        <source>no camera was found moved</source>
        <translation>no se encontró ninguna cámara movida</translation>
    </message>
</context>
<context>
    <name>workflow.passed_decoding</name>
    <message>
        <source>all frames could be decoded</source>
        <translation>todos los fotogramas se pudieron descodificar</translation>
    </message>
</context>
<context>
    <name>workflow.passed_frames</name>
    <message>
        <source>the frames came at regular intervals</source>
        <translation>los fotogramas llegaron a intervalos regulares</translation>
    </message>
</context>
<context>
    <name>workflow.passed_lens</name>
    <message>
        <source>the lenses are calibrated, or estimated from the floor&apos;s markers</source>
        <translation>los objetivos están calibrados o estimados a partir de los marcadores del suelo</translation>
    </message>
</context>
<context>
    <name>workflow.passed_motion</name>
    <message>
        <source>speeds and accelerations are possible</source>
        <translation>las velocidades y aceleraciones son posibles</translation>
    </message>
</context>
<context>
    <name>workflow.passed_names</name>
    <message>
        <source>no robot could be another one</source>
        <translation>ningún robot podría ser otro</translation>
    </message>
</context>
<context>
    <name>workflow.passed_precision</name>
    <message>
        <source>positions are precise for the run&apos;s extent</source>
        <translation>las posiciones son precisas para la extensión del recorrido</translation>
    </message>
</context>
<context>
    <name>workflow.passed_results</name>
    <message>
        <source>the stored results are as computed</source>
        <translation>los resultados guardados son los calculados</translation>
    </message>
</context>
<context>
    <name>workflow.passed_spikes</name>
    <message>
        <source>few positions are spikes</source>
        <translation>pocas posiciones son valores atípicos</translation>
    </message>
</context>
<context>
    <name>workflow.passed_synchronisation</name>
    <message>
        <source>the views are synchronised</source>
        <translation>las vistas están sincronizadas</translation>
    </message>
</context>
<context>
    <name>workflow.passed_time</name>
    <message>
        <source>the robots were measured all the time</source>
        <translation>los robots se midieron todo el tiempo</translation>
    </message>
</context>
<context>
    <name>workflow.passed_views</name>
    <message>
        <source>the views agree</source>
        <translation>las vistas concuerdan</translation>
    </message>
</context>
<context>
    <name>workflow.picture_lost_here</name>
    <message>
        <source>1 frame was lost because this computer or its disk was too slow</source>
        <translation>se perdió 1 imagen porque esta computadora o su disco eran demasiado lentos</translation>
    </message>
</context>
<context>
    <name>workflow.picture_lost_on_wire</name>
    <message>
        <source>1 frame was lost between the camera and this program</source>
        <translation>se perdió 1 imagen entre la cámara y este programa</translation>
    </message>
</context>
<context>
    <name>workflow.picture_made_too_late</name>
    <message>
        <source>1 frame was lost: this computer was too slow to generate it in time</source>
        <translation>se perdió 1 imagen porque esta computadora era demasiado lenta para generarla a tiempo</translation>
    </message>
</context>
<context>
    <name>workflow.picture_size_not_known</name>
    <message>
        <source>the size of its images is not known</source>
        <translation>no se conoce el tamaño de sus imágenes</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_lost_here</name>
    <message>
        <source>%1 frames were lost because this computer or its disk was too slow</source>
        <translation>se perdieron %1 imágenes porque esta computadora o su disco eran demasiado lentos</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_lost_on_wire</name>
    <message>
        <source>%1 frames were lost between the camera and this program</source>
        <translation>se perdieron %1 imágenes entre la cámara y este programa</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_made_too_late</name>
    <message>
        <source>%1 frames were lost: this computer was too slow to generate them in time</source>
        <translation>se perdieron %1 imágenes porque esta computadora era demasiado lenta para generarlas a tiempo</translation>
    </message>
</context>
<context>
    <name>workflow.point_out_whole_robot</name>
    <message>
        <source>point it out where the whole robot is visible and moving</source>
        <translation>señálelo donde se vea entero y se mueva</translation>
    </message>
</context>
<context>
    <name>workflow.positions_change</name>
    <message>
        <source>Positions change by %1 RMS, at most by %2 (at %3).</source>
        <translation>Las posiciones cambian %1 RMS, como máximo %2 (a los %3).</translation>
    </message>
</context>
<context>
    <name>workflow.positions_rounded</name>
    <message>
        <source>rounded to %1</source>
        <translation>redondeadas a %1</translation>
    </message>
</context>
<context>
    <name>workflow.positions_uncertain</name>
    <message>
        <source>its positions are known to ±%1 only, in a run over %2</source>
        <translation>sus posiciones solo se conocen con ±%1, en un recorrido de %2</translation>
    </message>
</context>
<context>
    <name>workflow.project_file_gone</name>
    <message>
        <source>the project file no longer exists</source>
        <translation>el archivo del proyecto ya no está</translation>
    </message>
</context>
<context>
    <name>workflow.project_lost</name>
    <message>
        <source>the project file was deleted, renamed or replaced; recording continues, and its contents will be saved at the end</source>
        <translation>el archivo del proyecto se ha borrado, renombrado o sustituido; la grabación continúa y su contenido se rescata al final</translation>
    </message>
</context>
<context>
    <name>workflow.project_rescued</name>
    <message>
        <source>the project file was deleted, renamed or replaced; its contents were saved in &apos;%1&apos;, the project from now on</source>
        <translation>el archivo del proyecto se ha borrado, renombrado o sustituido entretanto; su contenido se ha rescatado en &apos;%1&apos;, que es el proyecto a partir de ahora</translation>
    </message>
</context>
<context>
    <name>workflow.put_axes_elsewhere</name>
    <message>
        <source>change the world axes of layout %1</source>
        <translation>poner los ejes del plano %1 en otro lugar</translation>
    </message>
</context>
<context>
    <name>workflow.put_original_or_import</name>
    <message>
        <source>restore the original file, or import this one as another trial</source>
        <translation>restaure el archivo original o importe este como otro ensayo</translation>
    </message>
</context>
<context>
    <name>workflow.put_plate_on_it</name>
    <message>
        <source>put a plate of another colour on it, or set its true colour</source>
        <translation>póngale una placa de otro color, o indique el color que tiene en realidad</translation>
    </message>
</context>
<context>
    <name>workflow.range_is_reversed</name>
    <message>
        <source>its start %1 is not before its end %2</source>
        <translation>su inicio %1 no es anterior a su final %2</translation>
    </message>
</context>
<context>
    <name>workflow.range_of_trial</name>
    <message>
        <source>range of trial &apos;%1&apos;</source>
        <translation>tramo del ensayo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.range_outside_trial</name>
    <message>
        <source>%1 to %2 is not within the trial&apos;s time</source>
        <translation>de %1 a %2 no está dentro del tiempo del ensayo</translation>
    </message>
</context>
<context>
    <name>workflow.range_without_sample</name>
    <message>
        <source>it contains no sample</source>
        <translation>no contiene ninguna muestra</translation>
    </message>
</context>
<context>
    <name>workflow.rate_and_times</name>
    <message>
        <source>camera &apos;%1&apos; was given both a frame rate and frame times</source>
        <translation>a la cámara &apos;%1&apos; se le dieron una frecuencia de imágenes y también tiempos de fotogramas</translation>
    </message>
</context>
<context>
    <name>workflow.rate_is_assumed</name>
    <message>
        <source>no recording shows it, so 30 frames/s are simulated</source>
        <translation>ninguna grabación la muestra, así que se simulan 30 fotogramas/s</translation>
    </message>
</context>
<context>
    <name>workflow.rate_of_header</name>
    <message>
        <source>its header states an even %1</source>
        <translation>su cabecera indica %1 constantes</translation>
    </message>
</context>
<context>
    <name>workflow.reanalyse_tracks</name>
    <message>
        <source>reanalyse them with: odograph track PROJECT TRIAL --again</source>
        <translation>analícelas de nuevo</translation>
    </message>
</context>
<context>
    <name>workflow.record</name>
    <message>
        <source>record %1</source>
        <translation>grabar %1</translation>
    </message>
</context>
<context>
    <name>workflow.record_for_longer</name>
    <message>
        <source>record again, for longer</source>
        <translation>grabe de nuevo, durante más tiempo</translation>
    </message>
</context>
<context>
    <name>workflow.record_it_again</name>
    <message>
        <source>record it again</source>
        <translation>grábelo de nuevo</translation>
    </message>
</context>
<context>
    <name>workflow.record_to_faster_disk</name>
    <message>
        <source>record to a faster disk</source>
        <translation>grabe en un disco más rápido</translation>
    </message>
</context>
<context>
    <name>workflow.recorded_at_another_size</name>
    <message>
        <source>The newest recording of camera &apos;%1&apos; is %2, its lens was calibrated at %3</source>
        <translation>La grabación más reciente de la cámara &apos;%1&apos; es de %2, su lente se calibró a %3</translation>
    </message>
</context>
<context>
    <name>workflow.recording</name>
    <message>
        <source>recording</source>
        <translation>grabando</translation>
    </message>
</context>
<context>
    <name>workflow.recording_of_trial</name>
    <message>
        <source>recording of trial &apos;%1&apos;</source>
        <translation>grabación del ensayo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.recording_of_view</name>
    <message>
        <source>recording of view &apos;%1&apos;</source>
        <translation>grabación de la vista «%1»</translation>
    </message>
</context>
<context>
    <name>workflow.reference_not_calibrated</name>
    <message>
        <source>camera &apos;%1&apos; was registered without a lens calibration: register it again with it</source>
        <translation>la cámara &apos;%1&apos; se registró sin calibración de lente: regístrela de nuevo con ella</translation>
    </message>
</context>
<context>
    <name>workflow.register_a_camera</name>
    <message>
        <source>register the cameras first</source>
        <translation>registre primero las cámaras</translation>
    </message>
</context>
<context>
    <name>workflow.register_both_again</name>
    <message>
        <source>register both again and reanalyse</source>
        <translation>registre ambas de nuevo y reanalice</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera</name>
    <message>
        <source>register camera %1</source>
        <translation>registrar la cámara %1</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_again</name>
    <message>
        <source>register camera %1 again</source>
        <translation>registrar de nuevo la cámara %1</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_anew</name>
    <message>
        <source>register the camera again</source>
        <translation>registre de nuevo la cámara</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_through</name>
    <message>
        <source>register camera %1 via camera %2</source>
        <translation>registrar la cámara %1 mediante la cámara %2</translation>
    </message>
</context>
<context>
    <name>workflow.register_cameras_again</name>
    <message>
        <source>register the cameras again</source>
        <translation>vuelva a registrar las cámaras</translation>
    </message>
</context>
<context>
    <name>workflow.register_cameras_together</name>
    <message>
        <source>register the cameras of layout %1 jointly</source>
        <translation>registrar juntas las cámaras del plano %1</translation>
    </message>
</context>
<context>
    <name>workflow.register_if_other_part</name>
    <message>
        <source>if the camera shows another part of the scene at that size, register it again in a frame of this video</source>
        <translation>si la cámara muestra otra parte de la escena a ese tamaño, regístrela de nuevo en un fotograma de este vídeo</translation>
    </message>
</context>
<context>
    <name>workflow.register_in_its_video</name>
    <message>
        <source>register the camera in a frame of this video, to which its lens calibration is then fitted</source>
        <translation>registre la cámara en un fotograma de este vídeo, al que se ajusta entonces la calibración de su lente</translation>
    </message>
</context>
<context>
    <name>workflow.register_in_this_video</name>
    <message>
        <source>register the camera again in a frame of this video and reanalyse</source>
        <translation>registre de nuevo la cámara en un fotograma de este vídeo y vuelva a analizar</translation>
    </message>
</context>
<context>
    <name>workflow.register_it_again</name>
    <message>
        <source>register it again.</source>
        <translation>regístrela de nuevo.</translation>
    </message>
</context>
<context>
    <name>workflow.register_it_first</name>
    <message>
        <source>register it first, with markers or via another camera</source>
        <translation>regístrela antes, con marcadores o mediante otra cámara</translation>
    </message>
</context>
<context>
    <name>workflow.register_moved_again</name>
    <message>
        <source>register it again and reanalyse</source>
        <translation>regístrela de nuevo y reanalice</translation>
    </message>
</context>
<context>
    <name>workflow.register_or_do_not_send</name>
    <message>
        <source>run odograph register for one of them, or leave --ssl-vision out</source>
        <translation>registre una de ellas, o no envíe posiciones</translation>
    </message>
</context>
<context>
    <name>workflow.register_through_it_again</name>
    <message>
        <source>register it via that camera again</source>
        <translation>regístrela de nuevo mediante esa cámara</translation>
    </message>
</context>
<context>
    <name>workflow.register_upright</name>
    <message>
        <source>register the camera again</source>
        <translation>registre de nuevo la cámara</translation>
    </message>
</context>
<context>
    <name>workflow.registered_as_stored</name>
    <message>
        <source>its frames are turned or mirrored as its file says, but an earlier version registered camera &apos;%1&apos;, perhaps by frames as stored</source>
        <translation>sus fotogramas se giran o se reflejan como indica su archivo, pero una versión anterior registró la cámara &apos;%1&apos;, quizá con fotogramas tal como están guardados</translation>
    </message>
</context>
<context>
    <name>workflow.registered_at_another_size</name>
    <message>
        <source>the image is %1, the camera was registered at %2</source>
        <translation>la imagen es de %1, la cámara se registró a %2</translation>
    </message>
</context>
<context>
    <name>workflow.registered_before_calibration</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; was made before its lens was calibrated</source>
        <translation>El registro al suelo de la cámara &apos;%1&apos; se hizo antes de calibrar su lente</translation>
    </message>
</context>
<context>
    <name>workflow.registered_on_other_floor</name>
    <message>
        <source>it is registered on another floor, &apos;%1&apos;, and left out</source>
        <translation>está registrada en otro suelo, &apos;%1&apos;, y se omite</translation>
    </message>
</context>
<context>
    <name>workflow.registered_through_another</name>
    <message>
        <source>it was registered via another camera</source>
        <translation>se registró mediante otra cámara</translation>
    </message>
</context>
<context>
    <name>workflow.registered_with_other_lens</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; uses another lens calibration than the current one</source>
        <translation>El registro al suelo de la cámara &apos;%1&apos; se hizo con otra calibración de su lente que la vigente</translation>
    </message>
</context>
<context>
    <name>workflow.registration</name>
    <message>
        <source>registration %1</source>
        <translation>registro %1</translation>
    </message>
</context>
<context>
    <name>workflow.registration_converted</name>
    <message>
        <source>its frames are %1, so the camera&apos;s registration at %2 was converted</source>
        <translation>sus fotogramas son de %1, así que el registro de la cámara a %2 se convirtió</translation>
    </message>
</context>
<context>
    <name>workflow.registration_counts_as_exact</name>
    <message>
        <source>its uncertainty is not known, so it counts as exact</source>
        <translation>no se conoce su incertidumbre, así que cuenta como exacto</translation>
    </message>
</context>
<context>
    <name>workflow.registration_in_older_axes</name>
    <message>
        <source>it has other axes: those of its layout were changed since</source>
        <translation>tiene otros ejes: los de su disposición se han cambiado desde entonces</translation>
    </message>
</context>
<context>
    <name>workflow.registration_of</name>
    <message>
        <source>registration of %1</source>
        <translation>registro de %1</translation>
    </message>
</context>
<context>
    <name>workflow.registration_of_camera</name>
    <message>
        <source>registration of camera &apos;%1&apos;</source>
        <translation>registro de la cámara &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.registration_through</name>
    <message>
        <source>registration of camera &apos;%1&apos; via &apos;%2&apos;</source>
        <translation>registro de la cámara &apos;%1&apos; mediante &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.registration_with_lens_in_force</name>
    <message>
        <source>registration of camera &apos;%1&apos; with the current lens calibration</source>
        <translation>registro de la cámara &apos;%1&apos; con la lente vigente</translation>
    </message>
</context>
<context>
    <name>workflow.remove_cause</name>
    <message>
        <source>remove the cause and reanalyse, or record it again</source>
        <translation>elimine la causa y vuelva a analizar, o grabe de nuevo</translation>
    </message>
</context>
<context>
    <name>workflow.remove_for_good</name>
    <message>
        <source>remove %1 for good</source>
        <translation>eliminar %1 definitivamente</translation>
    </message>
</context>
<context>
    <name>workflow.remove_strays</name>
    <message>
        <source>remove stray files</source>
        <translation>eliminar archivos sueltos</translation>
    </message>
</context>
<context>
    <name>workflow.removing</name>
    <message>
        <source>removing %1</source>
        <translation>eliminando %1</translation>
    </message>
</context>
<context>
    <name>workflow.rename_trial</name>
    <message>
        <source>rename trial %1 to %2</source>
        <translation>renombrar el ensayo %1 como %2</translation>
    </message>
</context>
<context>
    <name>workflow.replaced_not_packed</name>
    <message>
        <source>the video of camera %1 in trial &apos;%2&apos; is outside the media folder and has changed since; it is not in the packed project</source>
        <translation>el video de la cámara %1 en el ensayo &apos;%2&apos; está en otro lugar y es otro archivo que antes, y no está en el proyecto empaquetado</translation>
    </message>
</context>
<context>
    <name>workflow.results_changed</name>
    <message>
        <source>its results differ from those of its analysis</source>
        <translation>sus resultados no son los que dio su análisis</translation>
    </message>
</context>
<context>
    <name>workflow.robot</name>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
</context>
<context>
    <name>workflow.robot_given_two_tracks</name>
    <message>
        <source>robot &apos;%1&apos; was given two tracks</source>
        <translation>al robot &apos;%1&apos; se le dieron dos trazas</translation>
    </message>
</context>
<context>
    <name>workflow.robot_in_view</name>
    <message>
        <source>robot &apos;%1&apos; in view &apos;%2&apos;</source>
        <translation>robot &apos;%1&apos; en la vista &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.robot_is_new</name>
    <message>
        <source>robot &apos;%1&apos; is new</source>
        <translation>el robot &apos;%1&apos; es nuevo</translation>
    </message>
</context>
<context>
    <name>workflow.robot_leaps</name>
    <message>
        <source>after %1 the robot is suddenly %2 away: frames are missing for an unknown time, or another object was tracked; nothing was measured across it</source>
        <translation>después de %1 el robot está de pronto a %2: faltan fotogramas durante un tiempo desconocido o se siguió otro objeto; a través de ese punto no se midió nada</translation>
    </message>
</context>
<context>
    <name>workflow.robot_not_tracked</name>
    <message>
        <source>robot &apos;%1&apos; was not tracked in it, only %2</source>
        <translation>el robot &apos;%1&apos; no fue rastreado en él, pero sí %2</translation>
    </message>
</context>
<context>
    <name>workflow.robot_pointed_out</name>
    <message>
        <source>robot &apos;%1&apos; pointed out in view &apos;%2&apos;</source>
        <translation>robot &apos;%1&apos; señalado en la vista &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.roster_line</name>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
</context>
<context>
    <name>workflow.run_calibrate</name>
    <message>
        <source>calibrate its lens, or import its intrinsics</source>
        <translation>calibre su objetivo o importe sus parámetros intrínsecos</translation>
    </message>
</context>
<context>
    <name>workflow.run_in_older_axes</name>
    <message>
        <source>it has other axes: those of layout &apos;%1&apos; were changed after it was analysed</source>
        <translation>tiene otros ejes: los de la disposición «%1» se cambiaron después de analizarlo</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_first</name>
    <message>
        <source>run odograph track first</source>
        <translation>rastree antes</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_without_again</name>
    <message>
        <source>run odograph track without --again first</source>
        <translation>rastree antes los videos del ensayo</translation>
    </message>
</context>
<context>
    <name>workflow.runs_in_other_axes</name>
    <message>
        <source>it has other axes (layout &apos;%1&apos;) than trial &apos;%2&apos; (layout &apos;%3&apos;)</source>
        <translation>tiene otros ejes (disposición «%1») que el ensayo «%2» (disposición «%3»)</translation>
    </message>
</context>
<context>
    <name>workflow.say_it_again</name>
    <message>
        <source>repeat it for frame %1</source>
        <translation>indíquelo otra vez para el fotograma %1</translation>
    </message>
</context>
<context>
    <name>workflow.scene_far_shifted</name>
    <message>
        <source>its scene is shifted by %1 against the image by which its camera was registered</source>
        <translation>su escena está desplazada %1 respecto a la imagen con la que se registró su cámara</translation>
    </message>
</context>
<context>
    <name>workflow.scene_mirrored</name>
    <message>
        <source>it is mirrored against the image by which its camera was registered</source>
        <translation>está reflejada respecto a la imagen con la que se registró su cámara</translation>
    </message>
</context>
<context>
    <name>workflow.scene_shifted</name>
    <message>
        <source>its scene is shifted by %1 against the image by which its camera was registered, so the camera was moved, and the stated errors were increased by that</source>
        <translation>su escena está desplazada %1 respecto a la imagen con la que se registró su cámara; la cámara se ha movido, y los errores indicados se aumentaron en esa medida</translation>
    </message>
</context>
<context>
    <name>workflow.scene_turned</name>
    <message>
        <source>it is turned by %1 against the image by which its camera was registered</source>
        <translation>está girada %1 respecto a la imagen con la que se registró su cámara</translation>
    </message>
</context>
<context>
    <name>workflow.scene_zoomed</name>
    <message>
        <source>it shows the scene %1 times as large as the image by which its camera was registered</source>
        <translation>muestra la escena %1 veces más grande que la imagen con la que se registró su cámara</translation>
    </message>
</context>
<context>
    <name>workflow.see_flags_by_hand</name>
    <message>
        <source>see the flags by_hand in odograph export</source>
        <translation>la revisión marca las muestras corregidas a mano</translation>
    </message>
</context>
<context>
    <name>workflow.see_revisions</name>
    <message>
        <source>see the list of its revisions</source>
        <translation>vea en sus revisiones las que hay</translation>
    </message>
</context>
<context>
    <name>workflow.set_range</name>
    <message>
        <source>set the range of %1</source>
        <translation>fijar el tramo de %1</translation>
    </message>
</context>
<context>
    <name>workflow.settling_names</name>
    <message>
        <source>assigning names to the robots</source>
        <translation>determinando qué robot es cuál</translation>
    </message>
</context>
<context>
    <name>workflow.several_image_series</name>
    <message>
        <source>the folder holds several series: %1 and %2</source>
        <translation>la carpeta contiene varias series: %1 y %2</translation>
    </message>
</context>
<context>
    <name>workflow.several_robots</name>
    <message>
        <source>it has several robots</source>
        <translation>tiene varios robots</translation>
    </message>
</context>
<context>
    <name>workflow.show_mat</name>
    <message>
        <source>print the mat, lay it where the cameras see all of it, and record again</source>
        <translation>imprima la alfombrilla, póngala donde las cámaras la vean entera y grabe de nuevo</translation>
    </message>
</context>
<context>
    <name>workflow.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and evenly lit, and check --pattern and --board</source>
        <translation>muestre todo el tablero, plano, nítido y con luz uniforme, y compruebe el patrón y el tamaño</translation>
    </message>
</context>
<context>
    <name>workflow.simulated_robot_not_found</name>
    <message>
        <source>the simulated robot was not found in the simulated views</source>
        <translation>el robot simulado no se encontró en las vistas simuladas</translation>
    </message>
</context>
<context>
    <name>workflow.simulating_run</name>
    <message>
        <source>simulating run %1 of %2</source>
        <translation>simulando el recorrido %1 de %2</translation>
    </message>
</context>
<context>
    <name>workflow.slow_errors_not_seen</name>
    <message>
        <source>errors that change slowly are not included</source>
        <translation>los errores que cambian lentamente no están incluidos</translation>
    </message>
</context>
<context>
    <name>workflow.sought_when_tracked</name>
    <message>
        <source>%1; tracking tries again</source>
        <translation>%1; el seguimiento lo intenta de nuevo</translation>
    </message>
</context>
<context>
    <name>workflow.sound_of_slow_motion</name>
    <message>
        <source>sound cannot be compared in clips that play in slow motion</source>
        <translation>el sonido no se puede comparar en clips a cámara lenta</translation>
    </message>
</context>
<context>
    <name>workflow.sound_unreadable</name>
    <message>
        <source>the sound of view &apos;%1&apos; cannot be read (%2)</source>
        <translation>no se puede leer el sonido de la vista &apos;%1&apos; (%2)</translation>
    </message>
</context>
<context>
    <name>workflow.spikes_change</name>
    <message>
        <source>Spikes: %1 instead of %2.</source>
        <translation>Valores atípicos: %1 en lugar de %2.</translation>
    </message>
</context>
<context>
    <name>workflow.stamps_too_dense</name>
    <message>
        <source>its time stamps mean %1, which no camera takes</source>
        <translation>sus marcas de tiempo significan %1, que ninguna cámara toma</translation>
    </message>
</context>
<context>
    <name>workflow.stopped_before_first_frame</name>
    <message>
        <source>it was stopped before the first frame came</source>
        <translation>se detuvo antes de que llegara el primer fotograma</translation>
    </message>
</context>
<context>
    <name>workflow.synchronisation_of_view</name>
    <message>
        <source>synchronisation of view &apos;%1&apos;</source>
        <translation>sincronización de la vista &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_again</name>
    <message>
        <source>synchronise the views again and reanalyse</source>
        <translation>sincronice las vistas de nuevo y reanalice</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_for_offset</name>
    <message>
        <source>synchronise it again with odograph trial set --sync auto, or enter the time offset</source>
        <translation>sincronícela de nuevo (Ensayo ▸ Sincronizar…) o introduzca allí el desfase</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_trial</name>
    <message>
        <source>synchronise %1: %2 (before: %3)</source>
        <translation>sincronizar %1: %2 (antes: %3)</translation>
    </message>
</context>
<context>
    <name>workflow.take_fewer_cameras</name>
    <message>
        <source>close other programs, or use fewer such cameras at once</source>
        <translation>cierre otros programas, o use menos cámaras de este tipo a la vez</translation>
    </message>
</context>
<context>
    <name>workflow.take_over_set_up</name>
    <message>
        <source>copy the set-up of %1</source>
        <translation>tomar el montaje de %1</translation>
    </message>
</context>
<context>
    <name>workflow.taking_over_set_up</name>
    <message>
        <source>copying the set-up</source>
        <translation>tomando el montaje</translation>
    </message>
</context>
<context>
    <name>workflow.task_was_changed</name>
    <message>
        <source>its task changed during the analysis</source>
        <translation>su tarea se cambió mientras se medía</translation>
    </message>
</context>
<context>
    <name>workflow.task_without_course</name>
    <message>
        <source>task &apos;%1&apos; has neither a path nor gates to drive along</source>
        <translation>la tarea &apos;%1&apos; no tiene trayectoria ni puertas que recorrer</translation>
    </message>
</context>
<context>
    <name>workflow.team_of_another_class</name>
    <message>
        <source>it belongs to class %1, not to class %2</source>
        <translation>pertenece a la clase %1, no a la clase %2</translation>
    </message>
</context>
<context>
    <name>workflow.through_itself</name>
    <message>
        <source>a camera cannot be registered via itself</source>
        <translation>una cámara no se puede registrar mediante sí misma</translation>
    </message>
</context>
<context>
    <name>workflow.time_of_trial</name>
    <message>
        <source>%1 of trial &apos;%2&apos;</source>
        <translation>%1 del ensayo &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.times_count_from</name>
    <message>
        <source>its times start at %1</source>
        <translation>sus tiempos cuentan desde %1</translation>
    </message>
</context>
<context>
    <name>workflow.times_given_twice</name>
    <message>
        <source>camera &apos;%1&apos; was given two tables of frame times</source>
        <translation>a la cámara &apos;%1&apos; se le dieron dos tablas de tiempos de fotogramas</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_no_view</name>
    <message>
        <source>there are frame times for camera &apos;%1&apos;, but no video of it</source>
        <translation>hay tiempos de fotogramas para la cámara &apos;%1&apos;, pero ningún video suyo</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_other_count</name>
    <message>
        <source>it has %1 times, but the video of view &apos;%2&apos; has %3 frames</source>
        <translation>tiene %1 tiempos, pero el video de la vista &apos;%2&apos; tiene %3 fotogramas</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_view</name>
    <message>
        <source>time stamps of view &apos;%1&apos;</source>
        <translation>marcas de tiempo de la vista «%1»</translation>
    </message>
</context>
<context>
    <name>workflow.track</name>
    <message>
        <source>track %1</source>
        <translation>rastrear %1</translation>
    </message>
</context>
<context>
    <name>workflow.track_it_first</name>
    <message>
        <source>track it first</source>
        <translation>rastréelo antes</translation>
    </message>
</context>
<context>
    <name>workflow.track_of_file</name>
    <message>
        <source>the file&apos;s track &apos;%1&apos;</source>
        <translation>traza &apos;%1&apos; del archivo</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_another</name>
    <message>
        <source>track it, or choose another</source>
        <translation>rastréelo, o elija otro</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_with_robot</name>
    <message>
        <source>track it, or choose another with --robot</source>
        <translation>rastréelo, o elija otro</translation>
    </message>
</context>
<context>
    <name>workflow.track_those_seen</name>
    <message>
        <source>track only the robots that are in view (--robot)</source>
        <translation>siga solo los robots que están en las imágenes</translation>
    </message>
</context>
<context>
    <name>workflow.tracking</name>
    <message>
        <source>tracking</source>
        <translation>rastreo</translation>
    </message>
</context>
<context>
    <name>workflow.tracking_picture</name>
    <message>
        <source>tracking, frame %1 of %2</source>
        <translation>rastreo, imagen %1 de %2</translation>
    </message>
</context>
<context>
    <name>workflow.tracks_were_imported</name>
    <message>
        <source>its tracks were imported, so it has no video to track</source>
        <translation>sus trazas se importaron, así que no hay video que rastrear</translation>
    </message>
</context>
<context>
    <name>workflow.trial_being_recorded</name>
    <message>
        <source>trial &apos;%1&apos; is being recorded</source>
        <translation>el ensayo &apos;%1&apos; se está grabando</translation>
    </message>
</context>
<context>
    <name>workflow.trial_is_there</name>
    <message>
        <source>the project already has a trial of that name</source>
        <translation>el proyecto tiene un ensayo con ese nombre</translation>
    </message>
</context>
<context>
    <name>workflow.trial_left_out</name>
    <message>
        <source>nothing of it had reached the disk, and it was removed</source>
        <translation>nada había llegado al disco, y se omite</translation>
    </message>
</context>
<context>
    <name>workflow.turn_cameras_to_floor</name>
    <message>
        <source>turn the cameras to the same floor, and register them again</source>
        <translation>oriente las cámaras al mismo suelo y regístrelas de nuevo</translation>
    </message>
</context>
<context>
    <name>workflow.turn_or_flash</name>
    <message>
        <source>turn the robot, or flash the room light, in view of both cameras</source>
        <translation>haga girar el robot, o destelle la luz de la sala, donde lo vean ambas cámaras</translation>
    </message>
</context>
<context>
    <name>workflow.two_mats</name>
    <message>
        <source>the files show mats of different paper</source>
        <translation>los archivos muestran alfombrillas de papel distinto</translation>
    </message>
</context>
<context>
    <name>workflow.two_views</name>
    <message>
        <source>views &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>vistas &apos;%1&apos; y &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.unequal_files</name>
    <message>
        <source>%1 files of the first camera cannot be paired with %2 of the second one</source>
        <translation>%1 archivos de la primera cámara no se pueden emparejar con %2 de la segunda</translation>
    </message>
</context>
<context>
    <name>workflow.unequal_rates</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_frame_rate</name>
    <message>
        <source>its frame rate is not between 0.1 and 100,000 frames a second</source>
        <translation>su frecuencia no está entre 0,1 y 100 000 fotogramas por segundo</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_length</name>
    <message>
        <source>the duration must be above zero and at most a day</source>
        <translation>no duraría nada, o más de un día</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_pre_roll</name>
    <message>
        <source>the pre-roll must be from 0 s to 10 s</source>
        <translation>lo que se guarda de antes no es un tiempo, o es más de 10 s</translation>
    </message>
</context>
<context>
    <name>workflow.use_as_it_is</name>
    <message>
        <source>use the results as they are</source>
        <translation>use los resultados tal como están</translation>
    </message>
</context>
<context>
    <name>workflow.use_earlier_registration</name>
    <message>
        <source>if it moved before this trial, register it again and reanalyse</source>
        <translation>si se movió antes de este ensayo, regístrela de nuevo y vuelva a analizar</translation>
    </message>
</context>
<context>
    <name>workflow.use_frame</name>
    <message>
        <source>use frame %1 of %2</source>
        <translation>usar el fotograma %1 de %2</translation>
    </message>
</context>
<context>
    <name>workflow.use_frames</name>
    <message>
        <source>use %1 samples of %2</source>
        <translation>usar %1 muestras de %2</translation>
    </message>
</context>
<context>
    <name>workflow.use_original_or_register</name>
    <message>
        <source>use the file as the camera wrote it, or register the camera again in a frame of this video</source>
        <translation>use el archivo tal como lo escribió la cámara, o registre de nuevo la cámara en un fotograma de este vídeo</translation>
    </message>
</context>
<context>
    <name>workflow.use_time_before</name>
    <message>
        <source>use the time before that only</source>
        <translation>use solo el tiempo anterior</translation>
    </message>
</context>
<context>
    <name>workflow.verdict_on</name>
    <message>
        <source>verdict on trial &apos;%1&apos;</source>
        <translation>veredicto del ensayo «%1»</translation>
    </message>
</context>
<context>
    <name>workflow.video</name>
    <message>
        <source>video &apos;%1&apos;</source>
        <translation>video &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.video_converted</name>
    <message>
        <source>one frame in %1 repeats the one before, because the video was converted to a higher frame rate; its frames were given the times at which they were taken</source>
        <translation>uno de cada %1 fotogramas repite el anterior, porque el vídeo se convirtió a una frecuencia de fotogramas mayor; sus fotogramas recibieron los tiempos en que se tomaron</translation>
    </message>
</context>
<context>
    <name>workflow.video_without_picture</name>
    <message>
        <source>the video has no frame</source>
        <translation>el video no tiene ninguna imagen</translation>
    </message>
</context>
<context>
    <name>workflow.view</name>
    <message>
        <source>view &apos;%1&apos;</source>
        <translation>vista &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.view_begun_later</name>
    <message>
        <source>%1 %2 later</source>
        <translation>%1 %2 más tarde</translation>
    </message>
</context>
<context>
    <name>workflow.view_ended_early</name>
    <message>
        <source>it ended early because %1</source>
        <translation>terminó antes de tiempo, porque %1</translation>
    </message>
</context>
<context>
    <name>workflow.view_is_kept</name>
    <message>
        <source>%1 of %2 view were saved, at most the last second is missing</source>
        <translation>se conservan %1 de %2 vista, todo salvo como mucho el último segundo</translation>
    </message>
</context>
<context>
    <name>workflow.view_left_out</name>
    <message>
        <source>it recorded nothing and was left out</source>
        <translation>se omite, porque no se grabó nada de ella</translation>
    </message>
</context>
<context>
    <name>workflow.view_not_synchronised</name>
    <message>
        <source>%1 not synchronised</source>
        <translation>%1 sin sincronizar</translation>
    </message>
</context>
<context>
    <name>workflow.view_without_sound</name>
    <message>
        <source>view &apos;%1&apos; has no sound</source>
        <translation>la vista &apos;%1&apos; no tiene sonido</translation>
    </message>
</context>
<context>
    <name>workflow.views_are_kept</name>
    <message>
        <source>%1 of %2 views were saved, at most the last second is missing</source>
        <translation>se conservan %1 de %2 vistas, todo salvo como mucho el último segundo</translation>
    </message>
</context>
<context>
    <name>workflow.views_contradict</name>
    <message>
        <source>in %1 of %2 frames the views contradict each other</source>
        <translation>en %1 de %2 imágenes las vistas se contradicen</translation>
    </message>
</context>
<context>
    <name>workflow.views_contradict_by</name>
    <message>
        <source>the views contradict each other by %1</source>
        <translation>las vistas se contradicen en %1</translation>
    </message>
</context>
<context>
    <name>workflow.views_far_apart</name>
    <message>
        <source>in %1 of %2 frames the views show it at positions far apart</source>
        <translation>en %1 de %2 imágenes las vistas lo sitúan en lugares muy separados</translation>
    </message>
</context>
<context>
    <name>workflow.views_put_it_apart</name>
    <message>
        <source>their floor positions differ by %1</source>
        <translation>lo sitúan a %1 de distancia</translation>
    </message>
</context>
<context>
    <name>workflow.waited_for_disk</name>
    <message>
        <source>frames waited up to %1 for the disk, and none was lost</source>
        <translation>las imágenes esperaron hasta %1 al disco y ninguna se perdió</translation>
    </message>
</context>
<context>
    <name>workflow.was_not_accepted</name>
    <message>
        <source>nobody accepted it</source>
        <translation>nadie lo aceptó</translation>
    </message>
</context>
<context>
    <name>workflow.why_views_contradict</name>
    <message>
        <source>a camera has moved since its registration, the views are not synchronised, or the robot&apos;s height is wrong</source>
        <translation>una cámara se movió después de registrarla, las vistas no están sincronizadas o la altura del robot no es la indicada</translation>
    </message>
</context>
<context>
    <name>workflow.withdraw_acceptance</name>
    <message>
        <source>withdraw the acceptance of %1</source>
        <translation>retirar la aceptación de %1</translation>
    </message>
</context>
<context>
    <name>workflow.write_address</name>
    <message>
        <source>write it like 224.5.23.2:10006</source>
        <translation>escríbala como 224.5.23.2:10006</translation>
    </message>
</context>
<context>
    <name>workflow.writing_last_pictures</name>
    <message>
        <source>writing the last frames</source>
        <translation>escribiendo las últimas imágenes</translation>
    </message>
</context>
<context>
    <name>workflow.written_just_now</name>
    <message>
        <source>another program is writing or removing it</source>
        <translation>otro programa lo está escribiendo o eliminando ahora mismo</translation>
    </message>
</context>
</TS>
