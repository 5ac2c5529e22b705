<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AccuracyLayer</name>
    <message>
        <source>expected ±, hatched: not visible</source>
        <translation>erwartetes ±, schraffiert: nicht gesehen</translation>
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
        <translation>%1 früher begonnen</translation>
    </message>
    <message>
        <source>started %1 later</source>
        <translation>%1 später begonnen</translation>
    </message>
    <message>
        <source>Kalman/RTS, noise from the data</source>
        <translation>Kalman/RTS, Rauschen aus den Daten</translation>
    </message>
    <message>
        <source>Savitzky–Golay, cubic, 11 points</source>
        <translation>Savitzky–Golay, kubisch, 11 Punkte</translation>
    </message>
    <message>
        <source>differences as in Tracker</source>
        <translation>Differenzen wie in Tracker</translation>
    </message>
    <message>
        <source>none: raw differences</source>
        <translation>keine: rohe Differenzen</translation>
    </message>
    <message>
        <source>%1, set by hand</source>
        <translation>%1, von Hand angegeben</translation>
    </message>
    <message>
        <source>synchronised to %1 by the motion; %2</source>
        <translation>synchron auf %1, aus der Bewegung bestimmt; %2</translation>
    </message>
    <message>
        <source>synchronised to %1 by a flash of light; %2</source>
        <translation>synchron auf %1, aus einem Lichtblitz bestimmt; %2</translation>
    </message>
    <message>
        <source>synchronised to %1 by the cameras&apos; time stamps; %2</source>
        <translation>synchron auf %1, nach den Zeitstempeln der Kameras; %2</translation>
    </message>
    <message>
        <source>assumed to start at the same time</source>
        <translation>als gleichzeitig begonnen angenommen</translation>
    </message>
    <message>
        <source>, clock %1 ppm fast</source>
        <translation>, ihre Uhr geht %1 ppm vor</translation>
    </message>
    <message>
        <source>, clock %1 ppm slow</source>
        <translation>, ihre Uhr geht %1 ppm nach</translation>
    </message>
    <message>
        <source>%1 to %2 ms apart</source>
        <translation>%1 bis %2 ms auseinander</translation>
    </message>
    <message>
        <source>synchronised to %1 by sound; %2</source>
        <translation>synchron auf %1, aus dem Ton bestimmt; %2</translation>
    </message>
</context>
<context>
    <name>AnnotatedFrame</name>
    <message>
        <source>slow motion %1×</source>
        <translation>Zeitlupe %1×</translation>
    </message>
    <message>
        <source>This camera was not recording at this time</source>
        <translation>Diese Kamera nahm zu dieser Zeit nicht auf</translation>
    </message>
    <message>
        <source>This frame cannot be decoded</source>
        <translation>Dieses Bild lässt sich nicht decodieren</translation>
    </message>
</context>
<context>
    <name>Certificate</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeitsvektor</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigungsvektor</translation>
    </message>
    <message>
        <source>Amount of acceleration</source>
        <translation>Betrag der Beschleunigung</translation>
    </message>
    <message>
        <source>Cameras: %1</source>
        <translation>Kameras: %1</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Roboter: %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>Aufgabe: %1</translation>
    </message>
    <message>
        <source>along the course of the task</source>
        <translation>längs der Strecke der Aufgabe</translation>
    </message>
    <message>
        <source>over the floor that the cameras see: straight, a curve, stop and go</source>
        <translation>über den Boden, den die Kameras sehen: geradeaus, eine Kurve, anhalten und anfahren</translation>
    </message>
    <message>
        <source>The views of each camera were rendered with its lens, position, image size and frame rate, written as videos, and imported, synchronised, tracked and analysed as any others.</source>
        <translation>Die Ansicht jeder Kamera wurde mit ihrem Objektiv, ihrer Lage, Bildgröße und Bildrate berechnet, als Video geschrieben und wie jedes andere importiert, synchronisiert, verfolgt und ausgewertet.</translation>
    </message>
    <message>
        <source>A simulation shows what this geometry and this program can do, not what a certain recording did. It has even light, a still camera, a clean floor with the markers, sensor noise of 2 of 255 and an exposure of 8 ms at most, and a robot of simple solids in its colour and size.</source>
        <translation>Eine Simulation zeigt, was diese Geometrie und dieses Programm leisten können, nicht, was eine bestimmte Aufnahme geleistet hat. Sie hat gleichmäßiges Licht, eine ruhige Kamera, einen sauberen Boden mit den Markern, Sensorrauschen von 2 von 255, höchstens 8 ms Belichtung und einen Roboter aus einfachen Körpern in seiner Farbe und Größe.</translation>
    </message>
    <message>
        <source>It does not cover flicker, reflections, deep shadows and people in the view; the look of the real robot, cables and hands; a camera that was moved; markers that were measured wrongly; rolling shutters; and errors of lens calibration and registration beyond the stated ones.</source>
        <translation>Sie erfasst nicht: Flimmern, Spiegelungen, tiefe Schatten und Menschen im Bild; das Aussehen des wirklichen Roboters, Kabel und Hände; eine Kamera, die bewegt wurde; falsch gemessene Marker; Rollverschlüsse; und Fehler von Objektivkalibrierung und Einmessung über die angegebenen hinaus.</translation>
    </message>
    <message>
        <source>The verdict on a trial says which of these were noticed in its recording.</source>
        <translation>Das Urteil über einen Versuch sagt, was davon in seiner Aufnahme bemerkt wurde.</translation>
    </message>
    <message>
        <source>The known run from above</source>
        <translation>Die bekannte Fahrt von oben</translation>
    </message>
    <message>
        <source>dashed: truth; strokes: errors of all runs, enlarged %1 times</source>
        <translation>gestrichelt: Wahrheit; Striche: Fehler aller Fahrten, %1-fach vergrößert</translation>
    </message>
    <message>
        <source>root mean square</source>
        <translation>quadratisches Mittel</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95 % unter</translation>
    </message>
    <message>
        <source>stated ± (σ)</source>
        <translation>angegebenes ± (σ)</translation>
    </message>
    <message>
        <source>truth inside the stated 95 %</source>
        <translation>Wahrheit in den angegebenen 95 %</translation>
    </message>
    <message>
        <source>Errors against the truth</source>
        <translation>Fehler gegenüber der Wahrheit</translation>
    </message>
    <message>
        <source>%1 of %2 frames have a result</source>
        <translation>%1 von %2 Bildern haben ein Ergebnis</translation>
    </message>
    <message>
        <source>Certificate of this set-up</source>
        <translation>Zertifikat dieses Aufbaus</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Positionsfehler</translation>
    </message>
    <message>
        <source>Velocity error</source>
        <translation>Geschwindigkeitsfehler</translation>
    </message>
    <message>
        <source>Acceleration error</source>
        <translation>Beschleunigungsfehler</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Überdeckung</translation>
    </message>
    <message>
        <source>true positions inside the stated 95 %</source>
        <translation>wahre Positionen in den angegebenen 95 %</translation>
    </message>
    <message>
        <source>What was simulated</source>
        <translation>Was simuliert wurde</translation>
    </message>
    <message>
        <source>What a simulation does not cover</source>
        <translation>Was eine Simulation nicht erfasst</translation>
    </message>
    <message>
        <source>%1, error in %2</source>
        <translation>%1, Fehler in %2</translation>
    </message>
    <message>
        <source>a line for each run; dashed: what the first states for 95 %</source>
        <translation>eine Linie je Fahrt; gestrichelt: was die erste für 95 % angibt</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Einmessung</translation>
    </message>
    <message>
        <source>σ on the floor</source>
        <translation>σ am Boden</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>kalibriert</translation>
    </message>
    <message>
        <source>estimated from the floor</source>
        <translation>aus dem Boden geschätzt</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>The views were synchronised by the motion, to %1 ms at worst.</source>
        <translation>Die Ansichten wurden durch die Bewegung synchronisiert, schlechtestenfalls auf %1 ms.</translation>
    </message>
    <message>
        <source>Certificate of this set-up: errors over time</source>
        <translation>Zertifikat dieses Aufbaus: Fehler über der Zeit</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>The cameras</source>
        <translation>Die Kameras</translation>
    </message>
    <message numerus="yes">
        <source>%n simulated run(s) of %1 s and %2 at up to %3, %4.</source>
        <translation>
            <numerusform>%n simulierte Fahrt von %1 s und %2 mit bis zu %3, %4.</numerusform>
            <numerusform>%n simulierte Fahrten von je %1 s und %2 mit bis zu %3, %4.</numerusform>
        </translation>
    </message>
    <message>
        <source>Lens calibration</source>
        <translation>Was vom Objektiv bekannt ist</translation>
    </message>
    <message>
        <source>Simulated %1, Odograph %2. All errors are against the known truth of the simulation.</source>
        <translation>Simuliert %1, Odograph %2. Alle Fehler gelten gegenüber der bekannten Wahrheit der Simulation.</translation>
    </message>
    <message>
        <source>In each run the cameras are a little off from where the project has them, drawn from the stated uncertainty of their registration and lens calibration; so the errors include it.</source>
        <translation>In jeder Fahrt liegen die Kameras ein wenig anders, als das Projekt angibt, gezogen aus der angegebenen Unsicherheit von Einmessung und Objektivkalibrierung; die Fehler enthalten sie also.</translation>
    </message>
</context>
<context>
    <name>ClassReport</name>
    <message>
        <source>Rank: one more than the number of significantly better teams (medians differ by more than 1.96 σ). Teams of the same rank do not differ significantly.</source>
        <translation>Rang: eins mehr als die Zahl der Teams, die zweifelsfrei besser sind (Mediane um mehr als 1,96 σ auseinander); Teams mit gleichem Rang lassen sich nicht unterscheiden.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them.</source>
        <translation>
            <numerusform>%n Versuch ausgelassen: nach einem anderen Parcours ausgewertet; bitte neu auswerten.</numerusform>
            <numerusform>%n Versuche ausgelassen: nach einem anderen Parcours ausgewertet; bitte neu auswerten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2 · Odograph %3</source>
        <translation>Seite %1 von %2 · Odograph %3</translation>
    </message>
    <message>
        <source>Odograph %1</source>
        <translation>Odograph %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>Aufgabe: %1</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>gewertet nach: %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Teams</source>
        <translation>Teams</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Bester</translation>
    </message>
    <message>
        <source>Median of all runs</source>
        <translation>Median aller Fahrten</translation>
    </message>
    <message>
        <source>Middle half of the runs</source>
        <translation>Mittlere Hälfte der Fahrten</translation>
    </message>
    <message>
        <source>The teams</source>
        <translation>Die Teams</translation>
    </message>
    <message>
        <source>each run is a dot; the line is the median of the team</source>
        <translation>jede Fahrt ist ein Punkt; der Strich ist der Median des Teams</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Over the term</source>
        <translation>Im Lauf des Halbjahrs</translation>
    </message>
    <message>
        <source>Its trials</source>
        <translation>Seine Versuche</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Class: %1</source>
        <translation>Klasse: %1</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message numerus="yes">
        <source>of %n team(s)</source>
        <translation>
            <numerusform>von %n Team</numerusform>
            <numerusform>von %n Teams</numerusform>
        </translation>
    </message>
    <message>
        <source>class median %1</source>
        <translation>Klassenmedian %1</translation>
    </message>
    <message>
        <source>Spread of one run</source>
        <translation>Streuung einer Fahrt</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>%n Versuch nicht gezählt: schlechte Ergebnisse.</numerusform>
            <numerusform>%n Versuche nicht gezählt: schlechte Ergebnisse.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! %n Versuch mit zweifelhaften Ergebnissen gezählt.</numerusform>
            <numerusform>! %n Versuche mit zweifelhaften Ergebnissen gezählt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ComparisonExplanation</name>
    <message>
        <source>No difference.</source>
        <translation>Es gibt keinen Unterschied.</translation>
    </message>
    <message>
        <source>Both values are exact: any difference is real.</source>
        <translation>Beide sind exakt, jeder Unterschied ist also ein echter.</translation>
    </message>
    <message>
        <source>%1 σ, above 1.96: without a real difference, chance would give this much in fewer than 5 of 100 cases.</source>
        <translation>Er beträgt %1 σ, mehr als 1,96: Gäbe es keinen Unterschied, brächte der Zufall so viel in weniger als 5 von 100 Fällen hervor.</translation>
    </message>
    <message>
        <source>%1 σ, not above 1.96: the difference is not significant.</source>
        <translation>Er beträgt %1 σ, nicht mehr als 1,96: im Rahmen des Fehlers, ein Unterschied lässt sich also nicht behaupten.</translation>
    </message>
    <message>
        <source>along the task&apos;s reference path</source>
        <translation>längs der Sollbahn der Aufgabe</translation>
    </message>
    <message>
        <source>along the path of %1</source>
        <translation>längs des Wegs von %1</translation>
    </message>
    <message>
        <source>time 0: each passes the start gate</source>
        <translation>Zeitpunkt 0: beide passieren das Starttor</translation>
    </message>
    <message>
        <source>time 0: each begins to move</source>
        <translation>Zeitpunkt 0: beide setzen sich in Bewegung</translation>
    </message>
    <message>
        <source>time 0: each first reaches the same point of the path</source>
        <translation>Zeitpunkt 0: beide erreichen zum ersten Mal dieselbe Stelle des Wegs</translation>
    </message>
    <message>
        <source>time 0: set by hand, to one frame</source>
        <translation>Zeitpunkt 0: von Hand angegeben, auf ein Bild genau</translation>
    </message>
    <message>
        <source>both with the same registrations and robot shape: the calibration uncertainty is common, so only its difference counts</source>
        <translation>beide mit denselben Einmessungen und für denselben Körper: Der Anteil der Kalibrierung ist gemeinsam, nur sein Unterschied zählt</translation>
    </message>
    <message>
        <source>different registrations or robot shapes: the calibration uncertainty counts in full for both</source>
        <translation>nicht mit denselben Einmessungen oder nicht für denselben Körper: Der Anteil der Kalibrierung zählt für beide voll</translation>
    </message>
    <message>
        <source>none</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>%1: %2 minus %3</source>
        <translation>%1: %2 minus %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>only one of the two runs has it</source>
        <translation>nur eine der beiden hat ihn</translation>
    </message>
    <message>
        <source>the value of %1 minus that of %2</source>
        <translation>der Kennwert von %1 minus der von %2</translation>
    </message>
    <message>
        <source>Each: %1</source>
        <translation>Jeweils: %1</translation>
    </message>
    <message>
        <source>√(σ₁² + σ₂²), treated as independent; where the runs share their calibration, its scale uncertainty counts only for the difference</source>
        <translation>√(σ₁² + σ₂²), beide als unabhängig; wo die Fahrten die Kalibrierung gemeinsam haben, bleibt von deren Maßstabsfehler nur der Anteil am Unterschied</translation>
    </message>
    <message>
        <source>not visible at one end</source>
        <translation>an einem Ende nicht gesehen</translation>
    </message>
    <message>
        <source>Sector %1 to %2: %3 minus %4</source>
        <translation>Sektor %1 bis %2: %3 minus %4</translation>
    </message>
    <message>
        <source>begin</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>For each run, the time from its first arrival at one gate to its first arrival at the next, by its position along the common path; waiting counts.</source>
        <translation>Die Zeit jeder Fahrt von der ersten Ankunft am einen Tor bis zur ersten Ankunft am nächsten, nach ihrem Ort auf dem gemeinsamen Weg; Warten zählt mit.</translation>
    </message>
    <message>
        <source>of each arrival: σ of the position along the path divided by the speed; displacements at two gates count as independent</source>
        <translation>jeder Ankunft: σ des Orts längs des Wegs geteilt durch die Geschwindigkeit; die Verschiebungen an zwei Toren gelten als unabhängig</translation>
    </message>
    <message>
        <source>from %1 to %2 along the path</source>
        <translation>von %1 bis %2 des Wegs</translation>
    </message>
    <message>
        <source>Δt of %1 against %2 at %3</source>
        <translation>Δt von %1 gegenüber %2 bei %3</translation>
    </message>
    <message>
        <source>The time of the first arrival at this point of the common path, each from its own time 0: that of %1 minus that of %2. Positive means later.</source>
        <translation>Die Zeit der ersten Ankunft an dieser Stelle des gemeinsamen Wegs, jede vom eigenen Zeitpunkt 0 an: die von %1 minus die von %2. Über 0 ist sie später.</translation>
    </message>
    <message>
        <source>of both arrivals: σ of the position along the path divided by the speed, and of both times 0</source>
        <translation>beider Ankünfte: σ des Orts längs des Wegs geteilt durch die Geschwindigkeit, und beider Zeitpunkte 0</translation>
    </message>
    <message>
        <source>Speed of %1 at %2</source>
        <translation>Geschwindigkeit von %1 bei %2</translation>
    </message>
    <message>
        <source>|v| of the smoothed curve where the run first reaches this point of the common path, interpolated between frames</source>
        <translation>|v| der geglätteten Kurve, wo die Fahrt diese Stelle des gemeinsamen Wegs zum ersten Mal erreicht, zwischen den Bildern interpoliert</translation>
    </message>
    <message>
        <source>σ of the smoothed velocity there, including the calibration&apos;s scale uncertainty</source>
        <translation>σ der geglätteten Geschwindigkeit dort, mit dem Maßstabsfehler der Kalibrierung</translation>
    </message>
    <message>
        <source>none: a run was not measured all the time, and is at least so large</source>
        <translation>keine: ein Lauf wurde nicht durchgehend gemessen und ist mindestens so groß</translation>
    </message>
</context>
<context>
    <name>ComparisonReport</name>
    <message>
        <source>± one σ; grey, ≈: not significant</source>
        <translation>± ein σ; grau, ≈: im Rahmen des Fehlers</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>right − left</source>
        <translation>rechts − links</translation>
    </message>
    <message>
        <source>along the task’s path</source>
        <translation>längs der Sollbahn der Aufgabe</translation>
    </message>
    <message>
        <source>along the path of the left run</source>
        <translation>längs des Wegs der linken Fahrt</translation>
    </message>
    <message>
        <source>aligned by the start gate, %1</source>
        <translation>ausgerichtet am Starttor, %1</translation>
    </message>
    <message>
        <source>aligned by the onset of motion, %1</source>
        <translation>ausgerichtet am Bewegungsbeginn, %1</translation>
    </message>
    <message>
        <source>aligned by a point that both pass, %1</source>
        <translation>ausgerichtet an einer Stelle, die beide passieren, %1</translation>
    </message>
    <message>
        <source>aligned by hand, %1</source>
        <translation>von Hand ausgerichtet, %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>Aufgabe: %1</translation>
    </message>
    <message>
        <source>%1: analysed %2, Odograph %3</source>
        <translation>%1: ausgewertet %2, Odograph %3</translation>
    </message>
    <message>
        <source>Both runs share their calibration: its uncertainty largely cancels.</source>
        <translation>Beide Fahrten haben die Kalibrierung gemeinsam: Soweit das gilt, hebt sich ihr Fehler weg.</translation>
    </message>
    <message>
        <source>The runs have different calibrations: the uncertainties of both count.</source>
        <translation>Die Fahrten haben die Kalibrierung nicht gemeinsam: Die Fehler beider zählen.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>Speed over distance, %1</source>
        <translation>Geschwindigkeit längs des Wegs, %1</translation>
    </message>
    <message>
        <source>with its ±95 % band</source>
        <translation>mit ihrem ±95-%-Band</translation>
    </message>
    <message>
        <source>Time difference, s</source>
        <translation>Zeitdifferenz, s</translation>
    </message>
    <message>
        <source>above 0: the right run is later; grey: not significant</source>
        <translation>über 0: die rechte Fahrt ist später; grau: im Rahmen des Fehlers</translation>
    </message>
    <message>
        <source>Sectors, s</source>
        <translation>Sektoren, s</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>Verdict on %1: %2</source>
        <translation>Urteil über %1: %2</translation>
    </message>
</context>
<context>
    <name>Conflict</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Schlagwörter</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>Mit Stern</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>Archiviert</translation>
    </message>
    <message>
        <source>In the bin</source>
        <translation>Im Papierkorb</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>Mitglieder</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>Pseudonym</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variablen</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation>Auswertungen</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Tore</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>Zonen</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>Wertung</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>(verborgen)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Measured values</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>this version</source>
        <translation>diese Fassung</translation>
    </message>
    <message>
        <source>another version</source>
        <translation>andere Fassung</translation>
    </message>
</context>
<context>
    <name>Explanation</name>
    <message>
        <source>smoothed by Kalman filter and RTS smoother, noise by maximum likelihood (Rauch, Tung, Striebel 1965; Bar-Shalom et al. 2001)</source>
        <translation>geglättet mit Kalman-Filter und RTS-Glätter, Rauschen nach Maximum-Likelihood (Rauch, Tung, Striebel 1965; Bar-Shalom et al. 2001)</translation>
    </message>
    <message>
        <source>smoothed by a cubic through eleven points (Savitzky and Golay 1964)</source>
        <translation>geglättet mit einem Polynom dritten Grades durch elf Punkte (Savitzky und Golay 1964)</translation>
    </message>
    <message>
        <source>differences as in Tracker, positions not smoothed</source>
        <translation>Differenzen wie in Tracker, Orte nicht geglättet</translation>
    </message>
    <message>
        <source>raw differences (Park 2018, eq. 6 to 8), nothing smoothed</source>
        <translation>rohe Differenzen (Park 2018, Gl. 6 bis 8), nichts geglättet</translation>
    </message>
    <message>
        <source>robot %1 high (estimated)</source>
        <translation>Roboter %1 hoch (geschätzt)</translation>
    </message>
    <message>
        <source>robot %1 high</source>
        <translation>Roboter %1 hoch</translation>
    </message>
    <message>
        <source>analysis %1 by Odograph %2</source>
        <translation>Auswertung %1 von Odograph %2</translation>
    </message>
    <message>
        <source>σ of the smoothed velocity there, including the calibration&apos;s scale uncertainty</source>
        <translation>σ der geglätteten Geschwindigkeit dort, mit dem Maßstabsfehler der Kalibrierung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>|v| = √(vx² + vy²) of the smoothed curve at this frame</source>
        <translation>|v| = √(vx² + vy²) der geglätteten Kurve bei diesem Bild</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>a·v/|v| of the smoothed curve at this frame: along the path, negative when braking; |a| while the robot stands still</source>
        <translation>a·v/|v| der geglätteten Kurve bei diesem Bild: längs der Bahn, Bremsen ist also negativ; |a|, solange er steht</translation>
    </message>
    <message>
        <source>σ of the smoothed acceleration there, including the calibration&apos;s scale uncertainty</source>
        <translation>σ der geglätteten Beschleunigung dort, mit dem Maßstabsfehler der Kalibrierung</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>Position X</source>
        <translation>Ort X</translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation>Ort Y</translation>
    </message>
    <message>
        <source>the smoothed curve at this frame</source>
        <translation>die geglättete Kurve bei diesem Bild</translation>
    </message>
    <message>
        <source>σ of the smoothed position, including the calibration&apos;s part</source>
        <translation>σ des geglätteten Orts, mit dem Anteil der Kalibrierung</translation>
    </message>
    <message>
        <source>no view found the robot in this frame: the curve bridges the gap</source>
        <translation>bei diesem Bild fand keine Sicht den Roboter: die Kurve geht darüber hinweg</translation>
    </message>
    <message>
        <source>measured there: %1, %2 ±%3</source>
        <translation>dort gemessen: %1, %2 ±%3</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>durch %1</translation>
    </message>
    <message>
        <source>it is flagged and not used: the curve follows its neighbours</source>
        <translation>er ist markiert und wird nicht verwendet: die Kurve folgt aus den Nachbarn</translation>
    </message>
    <message>
        <source>Jump: the position does not fit the motion before and after (χ² with two degrees of freedom, 99.9 %).</source>
        <translation>Sprung: Der Ort liegt jenseits dessen, was die Bewegung davor und danach zulässt (χ² mit zwei Freiheitsgraden, 99,9 %).</translation>
    </message>
    <message>
        <source>Limit: to get there, the robot had to exceed the speed limit of the task or of the analysis.</source>
        <translation>Grenzwert: Um dorthin zu kommen, müsste er schneller gewesen sein als der Grenzwert der Aufgabe oder der Auswertung.</translation>
    </message>
    <message>
        <source>Limit: to get there, the robot had to exceed the acceleration limit of the task or of the analysis.</source>
        <translation>Grenzwert: Um dorthin zu kommen, müsste er stärker beschleunigt haben als der Grenzwert der Aufgabe oder der Auswertung.</translation>
    </message>
    <message>
        <source>Views disagree: their floor positions differ by more than their uncertainty and their usual disagreement explain (χ², 99.9 %).</source>
        <translation>Sichten uneins: Ihre Orte weichen stärker voneinander ab, als ihre Fehler und ihre übliche Abweichung erklären (χ², 99,9 %).</translation>
    </message>
    <message>
        <source>Low score: the tracker was not sure of what it saw.</source>
        <translation>Geringe Güte: Die Verfolgung war sich nicht sicher, was sie sah.</translation>
    </message>
    <message>
        <source>Lost: no view found the robot.</source>
        <translation>Verloren: Keine Sicht fand den Roboter.</translation>
    </message>
    <message>
        <source>Repeated frame: the camera delivered the same frame twice, so its time is unknown.</source>
        <translation>Wiederholtes Bild: Die Kamera lieferte dasselbe Bild zweimal, daher ist seine Zeit nicht bekannt.</translation>
    </message>
    <message>
        <source>Bridged: the curve crosses a gap without measurements.</source>
        <translation>Überbrückt: Die Kurve geht ohne Messung darüber hinweg.</translation>
    </message>
    <message>
        <source>By hand: a manual override replaces the result of the analysis.</source>
        <translation>Von Hand: Ein Mensch hat entschieden; das geht der Auswertung vor.</translation>
    </message>
    <message>
        <source>How it is computed</source>
        <translation>Wie es berechnet wird</translation>
    </message>
    <message>
        <source>What ± contains (one standard deviation)</source>
        <translation>Was ± enthält (eine Standardabweichung)</translation>
    </message>
    <message>
        <source>What went into it</source>
        <translation>Was eingegangen ist</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>trial %1, robot %2</source>
        <translation>Versuch %1, Roboter %2</translation>
    </message>
    <message>
        <source>%1 of %2 samples used</source>
        <translation>%1 von %2 Messpunkten verwendet</translation>
    </message>
    <message>
        <source>views: %1</source>
        <translation>Sichten: %1</translation>
    </message>
    <message>
        <source>%1: from %2 to %3, at most %4 beyond the edge</source>
        <translation>%1: von %2 bis %3, höchstens %4 jenseits des Rands</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>Spike at %1</source>
        <translation>Ausreißer bei %1</translation>
    </message>
    <message>
        <source>The sample is kept, but not used for the curve.</source>
        <translation>Der Messpunkt bleibt erhalten, wird aber nicht für die Kurve verwendet.</translation>
    </message>
    <message>
        <source>The curve uses the sample nevertheless: its faulty part was left out, or a manual override restored it.</source>
        <translation>Der Messpunkt wird dennoch für die Kurve verwendet: Das Falsche daran wurde ausgelassen, oder ein Mensch hat ihn wiederhergestellt.</translation>
    </message>
    <message>
        <source>the views&apos; floor positions differ by %1 there</source>
        <translation>die Sichten liegen dort %1 auseinander</translation>
    </message>
    <message>
        <source>Of the body where its outline or an imported track shows it: the smoothed heading. Elsewhere the direction of motion: atan2(vy, vx) of the smoothed curve, kept where the robot stands still and continued where it reverses. Anticlockwise from X, without jumps of a whole turn.</source>
        <translation>Die des Rumpfs, wo sein Umriss oder eine importierte Spur sie zeigt: die geglättete Ausrichtung. Sonst die Bewegungsrichtung: atan2(vy, vx) der geglätteten Kurve, beibehalten, wo der Roboter steht, und fortgesetzt, wo er rückwärts fährt. Gegen den Uhrzeigersinn ab X, ohne Sprünge um eine volle Drehung.</translation>
    </message>
    <message>
        <source>of the body: σ of its smoothed heading; of the direction of motion: σ of the velocity across the motion divided by the speed</source>
        <translation>des Rumpfs: σ seiner geglätteten Ausrichtung; der Bewegungsrichtung: σ der Geschwindigkeit quer zur Bewegung geteilt durch die Geschwindigkeit</translation>
    </message>
    <message>
        <source>Of the body where its heading was measured: the rate of the smoothed heading. Elsewhere (vx·ay − vy·ax)/|v|² of the smoothed curve.</source>
        <translation>Die des Rumpfs, wo seine Ausrichtung gemessen wurde: die Rate der geglätteten Ausrichtung. Sonst (vx·ay − vy·ax)/|v|² der geglätteten Kurve.</translation>
    </message>
    <message>
        <source>of the body: σ of the smoothed heading&apos;s rate; of the direction of motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order</source>
        <translation>des Rumpfs: σ der Rate der geglätteten Ausrichtung; der Bewegungsrichtung: σ² = σa²/|v|² + |a|²σv²/|v|⁴, erste Ordnung</translation>
    </message>
    <message>
        <source>of the robot&apos;s body, which was measured</source>
        <translation>des Rumpfs, der gemessen wurde</translation>
    </message>
    <message>
        <source>of the direction of motion</source>
        <translation>der Bewegungsrichtung</translation>
    </message>
    <message>
        <source>Velocity X</source>
        <translation>Geschwindigkeit X</translation>
    </message>
    <message>
        <source>Velocity Y</source>
        <translation>Geschwindigkeit Y</translation>
    </message>
    <message>
        <source>the velocity of the smoothed curve at this frame along that axis</source>
        <translation>die Geschwindigkeit der geglätteten Kurve bei diesem Bild entlang dieser Achse</translation>
    </message>
    <message>
        <source>Lateral acceleration</source>
        <translation>Querbeschleunigung</translation>
    </message>
    <message>
        <source>(vx·ay − vy·ax)/|v| of the smoothed curve at this frame: across the path, positive to the left</source>
        <translation>(vx·ay − vy·ax)/|v| der geglätteten Kurve bei diesem Bild: quer zur Bahn, nach links positiv</translation>
    </message>
    <message>
        <source>σ² = σa² + (a·v/|v|)²σv²/|v|², first order: of the acceleration, and of the direction of motion</source>
        <translation>σ² = σa² + (a·v/|v|)²σv²/|v|², erste Ordnung: von der Beschleunigung und von der Bewegungsrichtung</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Ruck</translation>
    </message>
    <message>
        <source>(a(t₂) − a(t₁))/(t₂ − t₁) along the path, from the smoothed accelerations half of %1 before and after this frame; its length while the robot stands still</source>
        <translation>(a(t₂) − a(t₁))/(t₂ − t₁) längs der Bahn, aus den geglätteten Beschleunigungen eine Hälfte von %1 vor und nach diesem Bild; ihr Betrag, solange der Roboter steht</translation>
    </message>
    <message>
        <source>σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)², ρ the correlation of both errors</source>
        <translation>σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)², ρ die Korrelation beider Fehler</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>Zurückgelegter Weg</translation>
    </message>
    <message>
        <source>the integral of the smoothed speed over the time in which the robot moves, up to this frame</source>
        <translation>das Integral der geglätteten Geschwindigkeit über die Zeit, in der sich der Roboter bewegt, bis zu diesem Bild</translation>
    </message>
    <message>
        <source>of the positions at the ends of each motion, of errors across the path where it turns, and of the calibration&apos;s scale; without what the robot may have done while it was not measured</source>
        <translation>von den Positionen an den Enden jeder Bewegung, von Fehlern quer zur Bahn, wo sie sich krümmt, und vom Maßstab der Kalibrierung; ohne das, was der Roboter getan haben kann, solange er nicht gemessen wurde</translation>
    </message>
    <message>
        <source>Distance from the start</source>
        <translation>Abstand vom Start</translation>
    </message>
    <message>
        <source>the straight line from the first smoothed position to this frame&apos;s</source>
        <translation>die gerade Strecke von der ersten geglätteten Position zu der bei diesem Bild</translation>
    </message>
    <message>
        <source>of both positions along that line, and of the calibration&apos;s scale</source>
        <translation>von beiden Positionen entlang dieser Strecke und vom Maßstab der Kalibrierung</translation>
    </message>
    <message>
        <source>Distance to the nearest robot</source>
        <translation>Abstand zum nächsten Roboter</translation>
    </message>
    <message>
        <source>between the reference points of both robots at this frame&apos;s time, on the smoothed curves</source>
        <translation>zwischen den Bezugspunkten beider Roboter zur Zeit dieses Bildes, auf den geglätteten Kurven</translation>
    </message>
</context>
<context>
    <name>ExplanationDialog</name>
    <message>
        <source>How was this computed?</source>
        <translation>Wie wurde das berechnet?</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
</context>
<context>
    <name>FactExplanations</name>
    <message>
        <source>The time offset at which the robot&apos;s floor tracks from the two views coincide: least squares of r(t) = p₁(t) − p₂((t − offset)(1 + rate)), with a constant shift and a small scale between them, searched in steps of half a frame and refined by Gauss–Newton. The clock rate is used if it exceeds three σ.</source>
        <translation>Der Versatz, bei dem die Spuren des Roboters auf dem Boden, wie die zwei Sichten sie sehen, zusammenfallen: kleinste Quadrate von r(t) = p₁(t) − p₂((t − Versatz)(1 + Gang)), mit einer konstanten Verschiebung und einem kleinen Maßstab dazwischen, in halben Bildern gesucht und mit Gauß–Newton verfeinert. Der Gang der Uhren wird übernommen, wo er über drei σ liegt.</translation>
    </message>
    <message>
        <source>from the curvature of the sum of squares and from the residual, assumed to be correlated over half a second</source>
        <translation>aus der Krümmung der Quadratsumme und dem Residuum, das als über eine halbe Sekunde korreliert gilt</translation>
    </message>
    <message>
        <source>The time offset at which the jumps in brightness in both views coincide: the weighted mean of the pairs. It is used if every other offset is at least 150 times less likely.</source>
        <translation>Der Versatz, bei dem die Lichtsprünge, die beide Sichten sahen, zusammenfallen; übernommen, wenn kein anderer Versatz näher als um den Faktor 150 an seine Likelihood herankommt: das gewichtete Mittel der Paare.</translation>
    </message>
    <message>
        <source>from the pairs and their scatter, plus a tenth of a frame interval per view for its shutter</source>
        <translation>der Paare, ihrer Streuung und, für den Verschluss, ein Zehntel eines Bildabstands je Sicht</translation>
    </message>
    <message>
        <source>Each camera&apos;s time stamps, converted to this computer&apos;s clock by reading the camera&apos;s clock during the recording.</source>
        <translation>Die Zeitstempel jeder Kamera, auf die Uhr dieses Computers bezogen durch Ablesen der Kamerauhr während der Aufnahme.</translation>
    </message>
    <message>
        <source>from both clock conversions</source>
        <translation>beider Bezüge der Uhren</translation>
    </message>
    <message>
        <source>Times at the gates</source>
        <translation>Zeiten an den Toren</translation>
    </message>
    <message>
        <source>When the robot&apos;s reference point crosses the gate&apos;s line between its ends, in the direction of the gate. Between two frames, the smoothed position is the cubic through both positions and velocities. A passage counts if the point was before the line by three σ of the track&apos;s own noise and then is past it by as much.</source>
        <translation>Wenn die Mitte des Roboters die Linie des Tors zwischen dessen Enden in Durchfahrtsrichtung kreuzt: Zwischen zwei Bildern ist der geglättete Ort das Polynom dritten Grades durch beide Orte und Geschwindigkeiten. Passiert ist das Tor, wenn sie um drei σ des Eigenrauschens der Spur vor der Linie war und dann um ebenso viel dahinter ist.</translation>
    </message>
    <message>
        <source>σ of the position across the gate divided by the speed across it, including the calibration&apos;s part</source>
        <translation>σ des Orts quer zum Tor geteilt durch die Geschwindigkeit quer dazu, mit dem Anteil der Kalibrierung</translation>
    </message>
    <message>
        <source>From a passage of the start to one of the finish, or from one passage of a start-finish gate to the next. Of each split, the first passage counts.</source>
        <translation>Von einer Durchfahrt des Starts bis zum Ziel, oder von dem einen Tor bis zum nächsten; bei jeder Zwischenzeit zählt die erste Durchfahrt.</translation>
    </message>
    <message>
        <source>from both passages; the calibration&apos;s uncertainty cancels for a gate passed twice at the same speed</source>
        <translation>beider Durchfahrten; der Fehler der Kalibrierung hebt sich an einem Tor weg, das zweimal mit derselben Geschwindigkeit passiert wird</translation>
    </message>
    <message>
        <source>to %1: %2</source>
        <translation>bis %1: %2</translation>
    </message>
    <message>
        <source>Synchronisation of view %1 with the first</source>
        <translation>Sicht %1 synchron zur ersten</translation>
    </message>
    <message>
        <source>video %1, %2 frames</source>
        <translation>Video %1, %2 Bilder</translation>
    </message>
    <message>
        <source>Height of robot %1</source>
        <translation>Höhe von Roboter %1</translation>
    </message>
    <message>
        <source>The solid (box or cylinder, on the floor or a plate at the robot&apos;s top) whose silhouettes best match the outlines in all views, by weighted least squares at about forty times of the run. If no such solid explains them: the height at which all views give the same floor position.</source>
        <translation>Der Körper (Quader oder Zylinder, auf dem Boden, oder eine Platte oben auf dem Roboter), dessen Silhouetten die Umrisse in allen Sichten sind, nach gewichteten kleinsten Quadraten zu rund vierzig Zeitpunkten der Fahrt; wo kein solcher Körper sie erklärt, die Höhe, bei der alle Sichten den Roboter an denselben Ort setzen.</translation>
    </message>
    <message>
        <source>The time offset at which claps, knocks or whistles in the sound of both views coincide: the weighted mean of the pairs, less the time that sound takes to reach each camera. It is used if every other offset is at least 150 times less likely.</source>
        <translation>Der Versatz, bei dem Klatschen, Klopfen oder Pfiffe im Ton beider Sichten zusammenfallen: das gewichtete Mittel der Paare, ohne die Zeit, die der Schall zu jeder Kamera braucht. Er wird übernommen, wenn jeder andere Versatz mindestens 150-mal weniger wahrscheinlich ist.</translation>
    </message>
    <message>
        <source>from the pairs, from where on the floor the sound may have come, 50 ppm of the time from the start of the recording to the sound, and 2 ms by which each camera may record its sound early or late</source>
        <translation>der Paare, des möglichen Orts des Schalls auf dem Boden, 50 ppm der Zeit vom Beginn der Aufnahme bis zum Ton, und 2 ms, um die jede Kamera ihren Ton zu früh oder zu spät aufnehmen kann</translation>
    </message>
</context>
<context>
    <name>FirstLesson</name>
    <message>
        <source>Play a run</source>
        <translation>Eine Fahrt abspielen</translation>
    </message>
    <message>
        <source>Two cameras filmed a robot. Press Space: both videos, the map and the curves play together. Press Space again to stop.</source>
        <translation>Zwei Kameras haben einem Roboter beim Fahren zugesehen. Drücken Sie die Leertaste: Beide Videos, die Karte und die Kurven laufen synchron. Die Leertaste hält wieder an.</translation>
    </message>
    <message>
        <source>Read a result</source>
        <translation>Einen Kennwert ablesen</translation>
    </message>
    <message>
        <source>Click the speed curve. The bubble shows the speed at that moment and its uncertainty (±). The band around the curve contains the true speed in 95 of 100 cases.</source>
        <translation>Klicken Sie in die Geschwindigkeitskurve. Die Sprechblase nennt die Geschwindigkeit in diesem Moment und ihr ±: wie weit sie danebenliegen kann. Im Band um die Kurve liegt die Wahrheit in 95 von 100 Fällen.</translation>
    </message>
    <message>
        <source>Check the flagged samples</source>
        <translation>Markiertes ansehen</translation>
    </message>
    <message>
        <source>Press Ctrl+Page Up or Ctrl+Page Down until the list of spikes on the right is not empty. A spike is a measurement that cannot be true; the list gives the reason.</source>
        <translation>Gehen Sie mit Strg+Bild auf und Strg+Bild ab durch die Versuche bis zu einem, dessen Liste der Ausreißer rechts nicht leer ist. Ein Ausreißer ist ein Moment, in dem das Gemessene nicht wahr sein kann; die Liste sagt, warum.</translation>
    </message>
    <message>
        <source>Override it</source>
        <translation>Anders entscheiden</translation>
    </message>
    <message>
        <source>Click a spike in the list and watch the videos: was the robot really there? Press U to use the sample nevertheless. Odograph never deletes a measurement.</source>
        <translation>Klicken Sie auf einen Ausreißer in der Liste und sehen Sie die Videos an: War der Roboter wirklich dort? Drücken Sie U, um den Messpunkt trotzdem zu verwenden. Nichts, was gemessen wurde, geht je verloren.</translation>
    </message>
    <message>
        <source>Undo it</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Press Ctrl+Z. Odograph saves every change at once, and you can undo it.</source>
        <translation>Drücken Sie Strg+Z. Was Sie ändern, ist sofort gespeichert und lässt sich zurücknehmen.</translation>
    </message>
    <message>
        <source>Compare two runs</source>
        <translation>Zwei Fahrten vergleichen</translation>
    </message>
    <message>
        <source>Press Ctrl+4. Choose two runs on the right: where was one faster? Grey differences are not significant.</source>
        <translation>Drücken Sie Strg+4. Wählen Sie rechts zwei Fahrten: Wo war eine schneller, und ist das mehr als der Fehler? Was grau ist, ist es nicht.</translation>
    </message>
    <message>
        <source>Find it again</source>
        <translation>Wiederfinden</translation>
    </message>
    <message>
        <source>Press Ctrl+5. History lists the whole year: type a team&apos;s name to search, press Enter to open a run, and see under Teams who made progress.</source>
        <translation>Drücken Sie Strg+5. Der Verlauf enthält das ganze Jahr: Tippen Sie den Namen eines Teams, um zu suchen, öffnen Sie eine Fahrt mit der Eingabetaste, und sehen Sie unter Teams, wer Fortschritte gemacht hat.</translation>
    </message>
    <message>
        <source>That&apos;s it</source>
        <translation>Das war es</translation>
    </message>
    <message>
        <source>For your own robots: create a project (Ctrl+N). Its Start page leads you from the clips of two phones, or from connected cameras, to a first result. F1 explains each page.</source>
        <translation>Mit Ihren eigenen Robotern: Legen Sie ein Projekt an (Strg+N). Seine Seite Start führt Sie von den Videos zweier Handys oder von angeschlossenen Kameras zu einem ersten Ergebnis. F1 erklärt jede Seite.</translation>
    </message>
</context>
<context>
    <name>GuidanceWords</name>
    <message>
        <source>searched</source>
        <translation>durchsucht</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignoriert</translation>
    </message>
    <message>
        <source>%1 marked here</source>
        <translation>%1 hier markiert</translation>
    </message>
    <message>
        <source>%1 set by hand</source>
        <translation>%1 von Hand gesetzt</translation>
    </message>
    <message>
        <source>no robot visible, by hand</source>
        <translation>kein Roboter sichtbar, von Hand</translation>
    </message>
    <message>
        <source>%1 not visible, by hand</source>
        <translation>%1 nicht sichtbar, von Hand</translation>
    </message>
</context>
<context>
    <name>HealthWatch</name>
    <message>
        <source>The project is read-only</source>
        <translation>Das Projekt ist nur lesbar</translation>
    </message>
    <message>
        <source>Opening the cameras…</source>
        <translation>Kameras werden geöffnet…</translation>
    </message>
    <message>
        <source>No camera is running</source>
        <translation>Keine Kamera läuft</translation>
    </message>
    <message>
        <source>No camera sends frames</source>
        <translation>Keine Kamera sendet Bilder</translation>
    </message>
    <message>
        <source>This project is read-only: you cannot record into it.</source>
        <translation>Dieses Projekt ist nur lesbar: Es lässt sich nichts darin aufnehmen.</translation>
    </message>
    <message>
        <source>Register &amp;it in Testbed</source>
        <translation>Im &amp;Messplatz einmessen</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>List of keys</source>
        <translation>Liste der Tasten</translation>
    </message>
    <message>
        <source>About Odograph</source>
        <translation>Über Odograph</translation>
    </message>
    <message>
        <source>Odograph %1</source>
        <translation>Odograph %1</translation>
    </message>
    <message>
        <source>Measures how a mobile robot moved, from the videos of ordinary cameras.

Free software under the GNU General Public License, version 3 or later, without any warranty.

The method follows S. Park, “Computational Vision for Automatic Tracking and Objective Estimation of Mobile Robot Trajectory”, 2018.</source>
        <translation>Misst anhand der Videos gewöhnlicher Kameras, wie sich ein mobiler Roboter bewegt hat.

Freie Software unter der GNU General Public License, Version 3 oder neuer, ohne jede Gewährleistung.

Das Verfahren folgt S. Park, „Computational Vision for Automatic Tracking and Objective Estimation of Mobile Robot Trajectory“, 2018.</translation>
    </message>
</context>
<context>
    <name>HtmlChart</name>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured</source>
        <translation>geglättet, mit ±95-%-Band; Punkte: wie gemessen</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured; shaded: not measured</source>
        <translation>geglättet, mit ±95-%-Band; Punkte: wie gemessen; schattiert: nicht gemessen</translation>
    </message>
    <message>
        <source>Speed, %1</source>
        <translation>Geschwindigkeit, %1</translation>
    </message>
    <message>
        <source>Acceleration along the path, %1</source>
        <translation>Beschleunigung längs der Bahn, %1</translation>
    </message>
</context>
<context>
    <name>HtmlMap</name>
    <message>
        <source>a square: %1</source>
        <translation>ein Kästchen: %1</translation>
    </message>
    <message>
        <source>The run from above</source>
        <translation>Die Fahrt von oben</translation>
    </message>
    <message>
        <source>coloured by speed, from 0 (dark) to %1 (light); ring: start, dot: end</source>
        <translation>gefärbt nach Geschwindigkeit, von 0 (dunkel) bis %1 (hell); Ring: Anfang, Punkt: Ende</translation>
    </message>
    <message>
        <source>Both runs from above</source>
        <translation>Beide Fahrten von oben</translation>
    </message>
    <message>
        <source>in the colours of the runs</source>
        <translation>in den Farben der Fahrten</translation>
    </message>
</context>
<context>
    <name>HtmlPage</name>
    <message>
        <source>Made by Odograph %1; ± is one standard deviation.</source>
        <translation>Erstellt mit Odograph %1; ± ist eine Standardabweichung.</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>Urteil: %1</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>Zwischenzeiten</translation>
    </message>
    <message>
        <source>from the start to</source>
        <translation>vom Start bis</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Fahrt %1</translation>
    </message>
    <message>
        <source>sector to %1</source>
        <translation>Sektor bis %1</translation>
    </message>
    <message>
        <source>No spikes.</source>
        <translation>Keine Ausreißer.</translation>
    </message>
    <message numerus="yes">
        <source>Spikes: %n</source>
        <translation>
            <numerusform>Ausreißer: %n</numerusform>
            <numerusform>Ausreißer: %n</numerusform>
        </translation>
    </message>
    <message>
        <source>reason</source>
        <translation>Grund</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und noch %n</numerusform>
            <numerusform>und noch %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Where this comes from</source>
        <translation>Woher das kommt</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Both runs share their calibration: its uncertainty largely cancels. ≈: not significant.</source>
        <translation>Beide Fahrten teilen ihre Kalibrierung: Deren Unsicherheit hebt sich weitgehend auf. ≈: nicht signifikant.</translation>
    </message>
    <message>
        <source>The runs have different calibrations: the uncertainties of both count. ≈: not significant.</source>
        <translation>Die Fahrten haben verschiedene Kalibrierungen: Die Unsicherheiten beider zählen. ≈: nicht signifikant.</translation>
    </message>
    <message>
        <source>Speed over distance, %1</source>
        <translation>Geschwindigkeit längs des Wegs, %1</translation>
    </message>
    <message>
        <source>with its ±95 % band</source>
        <translation>mit ihrem ±95-%-Band</translation>
    </message>
    <message>
        <source>Time difference, s</source>
        <translation>Zeitdifferenz, s</translation>
    </message>
    <message>
        <source>above 0: the second run is later; grey: not significant</source>
        <translation>über 0: die zweite Fahrt ist später; grau: nicht signifikant</translation>
    </message>
    <message>
        <source>Sectors, s</source>
        <translation>Sektoren, s</translation>
    </message>
</context>
<context>
    <name>Hub</name>
    <message>
        <source>Connected.</source>
        <translation>Verbunden.</translation>
    </message>
    <message>
        <source>Everything had been sent.</source>
        <translation>Es war schon alles gesendet.</translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) sent.</source>
        <translation>
            <numerusform>%n Eintrag gesendet.</numerusform>
            <numerusform>%n Einträge gesendet.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing new at the hub.</source>
        <translation>Nichts Neues am Hub.</translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) received.</source>
        <translation>
            <numerusform>%n Eintrag empfangen.</numerusform>
            <numerusform>%n Einträge empfangen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recordings: %1 copied.</source>
        <translation>Aufnahmen: %1 kopiert.</translation>
    </message>
    <message numerus="yes">
        <source>%n more warning(s).</source>
        <translation>
            <numerusform>%n weitere Warnung.</numerusform>
            <numerusform>%n weitere Warnungen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>Teacher: may change everything</source>
        <translation>Lehrkraft: darf alles ändern</translation>
    </message>
    <message>
        <source>Bench: publishes its own trials, reads those of others</source>
        <translation>Messplatz: veröffentlicht eigene Versuche, liest die anderer</translation>
    </message>
    <message>
        <source>Viewer: reads results only</source>
        <translation>Betrachter: liest nur Ergebnisse</translation>
    </message>
    <message>
        <source>Nothing: all is sent</source>
        <translation>Nichts: alles ist gesendet</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s)</source>
        <translation>
            <numerusform>%n Änderung</numerusform>
            <numerusform>%n Änderungen</numerusform>
        </translation>
    </message>
    <message>
        <source>password needed</source>
        <translation>Passwort nötig</translation>
    </message>
    <message>
        <source>server away</source>
        <translation>Server nicht erreichbar</translation>
    </message>
    <message>
        <source>not accepted</source>
        <translation>nicht angenommen</translation>
    </message>
    <message>
        <source>Hub: %1</source>
        <translation>Hub: %1</translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending, %1</source>
        <translation>
            <numerusform>Hub: %n ausstehend, %1</numerusform>
            <numerusform>Hub: %n ausstehend, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Hub: publishing…</source>
        <translation>Hub: wird veröffentlicht…</translation>
    </message>
    <message>
        <source>Hub: pulling…</source>
        <translation>Hub: wird abgerufen…</translation>
    </message>
    <message>
        <source>Hub: all sent</source>
        <translation>Hub: alles gesendet</translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending</source>
        <translation>
            <numerusform>Hub: %n ausstehend</numerusform>
            <numerusform>Hub: %n ausstehend</numerusform>
        </translation>
    </message>
    <message>
        <source>no answer yet</source>
        <translation>noch keine Antwort</translation>
    </message>
    <message numerus="yes">
        <source>Hub: publishing, %n pending</source>
        <translation>
            <numerusform>Hub: wird veröffentlicht, %n ausstehend</numerusform>
            <numerusform>Hub: wird veröffentlicht, %n ausstehend</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MapPainting</name>
    <message>
        <source>grid %1 %2</source>
        <translation>Raster %1 %2</translation>
    </message>
</context>
<context>
    <name>MatWords</name>
    <message>
        <source>Row %1, sheet %2</source>
        <translation>Reihe %1, Blatt %2</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>This line is %1 long on the whole mat. Measure it.</source>
        <translation>Diese Linie ist auf der ganzen Matte %1 lang. Messen Sie nach.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets. Print at 100 % (actual size). Cut along the dashed lines.</source>
        <translation>Bodenmatte aus %1 × %2 Blättern. Mit 100 % (Originalgröße) drucken. An den gestrichelten Linien abschneiden.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets</source>
        <translation>Bodenmatte aus %1 × %2 Blättern</translation>
    </message>
    <message>
        <source>1. Print all pages at 100 % (actual size), not fitted to the page.</source>
        <translation>1. Drucken Sie alle Seiten mit 100 % (Originalgröße), nicht an die Seite angepasst.</translation>
    </message>
    <message>
        <source>2. Cut each sheet along its dashed lines. Lay it on its neighbours, up to their thin lines, as drawn below, and tape the sheets together.</source>
        <translation>2. Schneiden Sie jedes Blatt an den gestrichelten Linien ab. Legen Sie es bis an die dünnen Linien auf seine Nachbarn, wie unten gezeichnet, und kleben Sie die Blätter zusammen.</translation>
    </message>
    <message>
        <source>3. Measure the line at the lower edge. It should be %1 long; Odograph asks for what you measure.</source>
        <translation>3. Messen Sie die Linie am unteren Rand. Sie sollte %1 lang sein; Odograph fragt nach dem, was Sie messen.</translation>
    </message>
    <message>
        <source>4. Lay the mat flat where every camera sees all of it. The lower left corner is the origin, the lower edge the x axis.</source>
        <translation>4. Legen Sie die Matte flach hin, wo jede Kamera sie ganz sieht. Die linke untere Ecke ist der Ursprung, der untere Rand die x-Achse.</translation>
    </message>
</context>
<context>
    <name>Modes</name>
    <message>
        <source>Testbed</source>
        <translation>Messplatz</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Durchsicht</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
</context>
<context>
    <name>OutputQuestion</name>
    <message>
        <source>%1 is a file of another kind. Replace it?</source>
        <translation>%1 ist eine Datei anderer Art. Soll sie ersetzt werden?</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 ist vorhanden. Soll die Datei ersetzt werden?</translation>
    </message>
</context>
<context>
    <name>OwnChanges</name>
    <message>
        <source>Done: %1. Press Ctrl+Z to undo it.</source>
        <translation>Erledigt: %1. Strg+Z nimmt es zurück.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Rückgängig gemacht: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Wiederholt: %1.</translation>
    </message>
</context>
<context>
    <name>PageMenus</name>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>T&amp;rial</source>
        <translation>&amp;Versuch</translation>
    </message>
    <message>
        <source>&amp;Spikes</source>
        <translation>A&amp;usreißer</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>Ver&amp;lauf</translation>
    </message>
    <message>
        <source>Re&amp;cord</source>
        <translation>Auf&amp;nahme</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Wiedergabe</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>E&amp;xtras</translation>
    </message>
    <message>
        <source>Ran&amp;ge</source>
        <translation>Berei&amp;ch</translation>
    </message>
</context>
<context>
    <name>RangeFacts</name>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>The calibration&apos;s contribution to an angle is unknown and not included.</source>
        <translation>Was die Kalibrierung zu einem Winkel beiträgt, ist nicht bekannt und nicht darin.</translation>
    </message>
    <message>
        <source>Includes the position uncertainty of the calibration.</source>
        <translation>Der Ortsfehler der Kalibrierung ist darin.</translation>
    </message>
    <message>
        <source>Includes the scale uncertainty of the calibration.</source>
        <translation>Der Maßstabsfehler der Kalibrierung ist darin.</translation>
    </message>
    <message>
        <source>Neighbouring points of a smoothed curve have correlated errors. They average out over time, not over frames: with a spectrum of r/(1 + (ω/ω₀)⁶) for the position, ω₀ = √2 σv/σx.</source>
        <translation>Nachbarn auf einer geglätteten Kurve haben ihren Fehler gemeinsam, er mittelt sich also über die Zeit heraus und nicht über die Bilder: mit einem Spektrum r/(1 + (ω/ω₀)⁶) für den Ort, ω₀ = √2 σv/σx.</translation>
    </message>
    <message>
        <source>From the smoothed curve, each value weighted by half the time to both neighbours: mean; median (the curve is below it half of the time); least and most, chosen by value + 2σ and value − 2σ; spread √(mean of the squared distance from the mean).</source>
        <translation>Von der geglätteten Kurve, jeder Wert mit der halben Zeit zu beiden Nachbarn: ihr Mittel, der Median (die Hälfte der Zeit bleibt darunter), das zweifelsfrei Kleinste und Größte (nach dem Wert plus oder minus 2σ) und die Streuung √(Mittel der Abstandsquadrate vom Mittel).</translation>
    </message>
    <message>
        <source>no value here</source>
        <translation>hier kein Wert</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>least</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>most</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>Streuung</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>does not fit: χ² is %1 times what the uncertainties explain</source>
        <translation>nicht seine Form: χ² ist das %1-Fache dessen, was die Fehler erklären</translation>
    </message>
    <message>
        <source>fits; the stated uncertainties are too large: χ² is %1 of its expected value</source>
        <translation>passt; die angegebenen Fehler sind zu groß: χ² beträgt %1 von dem, was sie erwarten lassen</translation>
    </message>
    <message>
        <source>fits: χ² is %1 of its expected value</source>
        <translation>passt: χ² beträgt %1 von dem, was die Fehler erwarten lassen</translation>
    </message>
    <message>
        <source>Fit of %1</source>
        <translation>Anpassung: %1</translation>
    </message>
    <message>
        <source>The polynomial in t − t₀ that minimises Σ(residual/σ)² over %1, t₀ = %2. χ² is that sum divided by its expected value: the number of points minus the degrees of freedom of the coefficients.</source>
        <translation>Das Polynom in t − t₀ mit dem kleinsten Σ(Residuum/σ)² über %1, t₀ = %2. χ² ist diese Summe, geteilt durch das, was die Fehler dafür erwarten lassen: die Zahl der Punkte minus das, was die Koeffizienten aufbrauchen.</translation>
    </message>
    <message>
        <source>the measured positions used</source>
        <translation>die gemessenen Orte, die verwendet werden</translation>
    </message>
    <message>
        <source>the smoothed curve</source>
        <translation>die geglättete Kurve</translation>
    </message>
    <message>
        <source>The larger of two uncertainties: that of the measurements, widened by 1 + 2Σρ for correlated residuals (here ×%1), and that of the smoothed curve, including the errors that persist.</source>
        <translation>Das größere von zweien: das aus den Messungen, um den Faktor 1 + 2Σρ der Residuen verbreitert, wo sie zusammenhängen (hier ×%1), und das der geglätteten Kurve, die weiß, was von deren Fehlern bleibt.</translation>
    </message>
    <message>
        <source>Assumes that the shape is correct; χ² far above 1 shows that it is not. χ² below 1 means that the smoother allows for more motion than the robot made.</source>
        <translation>Dass die Form die wahre ist, wird vorausgesetzt; ein χ² weit über 1 sagt, dass sie es nicht ist. Unter 1 kommt es von einer Glättung, die mehr Bewegung zulässt, als da ist.</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>%1 to %2: %3</source>
        <translation>%1 bis %2: %3</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>slope there</source>
        <translation>Steigung dort</translation>
    </message>
    <message>
        <source>times t²</source>
        <translation>mal t²</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Residuum</translation>
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
        <translation>Störung</translation>
    </message>
    <message>
        <source>slow</source>
        <translation>langsam</translation>
    </message>
    <message>
        <source>lost frames</source>
        <translation>Verluste</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>, %1 ms</source>
        <translation>, %1 ms</translation>
    </message>
    <message>
        <source>; not registered</source>
        <translation>; nicht eingemessen</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>no camera sees it</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>ungesehen</translation>
    </message>
    <message>
        <source>x %1, y %2, %3</source>
        <translation>x %1, y %2, %3</translation>
    </message>
    <message>
        <source>; one camera sees it</source>
        <translation>; eine Kamera sieht ihn</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <source>fair</source>
        <translation>mäßig</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>uneins</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>Synchron</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>%1 MB written</source>
        <translation>%1 MB geschrieben</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Festplatte</translation>
    </message>
    <message>
        <source>Camera %1 is not registered to the floor: it records, but cannot locate robots.</source>
        <translation>Kamera %1 ist nicht zum Boden eingemessen: Sie wird aufgenommen, kann aber nicht sagen, wo ein Roboter ist.</translation>
    </message>
    <message>
        <source>Camera %1 was registered with frames of %2×%3, but now sends another size: it records, but cannot locate robots.</source>
        <translation>Kamera %1 wurde für Bilder von %2×%3 eingemessen, die sie jetzt nicht sendet: Sie wird aufgenommen, kann aber nicht sagen, wo ein Roboter ist.</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>Aufnahme: %1</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>Kamera %1: %2</translation>
    </message>
    <message>
        <source>The disk is barely fast enough: record to a faster one, or with fewer cameras.</source>
        <translation>Die Festplatte ist kaum schnell genug: Nehmen Sie auf eine schnellere auf oder mit weniger Kameras.</translation>
    </message>
    <message>
        <source>The disk is nearly full: %1</source>
        <translation>Die Festplatte ist fast voll: %1</translation>
    </message>
    <message>
        <source>The cameras are not synchronised: set both to the same frame rate.</source>
        <translation>Die Kameras sind nicht synchron: Stellen Sie beide auf dieselbe Bildrate.</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und noch %n</numerusform>
            <numerusform>und noch %n</numerusform>
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
        <translation>Geschwindigkeit, %1</translation>
    </message>
    <message>
        <source>Acceleration along the path, %1</source>
        <translation>Beschleunigung längs der Bahn, %1</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured</source>
        <translation>geglättet, mit ±95-%-Band; Punkte: wie gemessen</translation>
    </message>
    <message>
        <source>No curve: the robot was not detected</source>
        <translation>Keine Kurve: Der Roboter wurde nicht gesehen</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured; shaded: not measured</source>
        <translation>geglättet, mit ±95-%-Band; Punkte: wie gemessen; schattiert: nicht gemessen</translation>
    </message>
</context>
<context>
    <name>ReportMethod</name>
    <message>
        <source>%1: %2 frames at %3/s</source>
        <translation>%1: %2 Bilder mit %3/s</translation>
    </message>
    <message numerus="yes">
        <source>%n missing</source>
        <translation>
            <numerusform>%n fehlt</numerusform>
            <numerusform>%n fehlen</numerusform>
        </translation>
    </message>
    <message>
        <source>lens calibrated to %1 px</source>
        <translation>Objektiv auf %1 px kalibriert</translation>
    </message>
    <message>
        <source>registered to the floor to %1 px, %2</source>
        <translation>zum Boden eingemessen auf %1 px, %2</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>nicht eingemessen</translation>
    </message>
    <message>
        <source>%1 samples: %2 measured, %3 used, %4 flagged, %5 bridged; the views disagree by %6 on average</source>
        <translation>%1 Messpunkte: %2 gemessen, %3 verwendet, %4 markiert, %5 überbrückt; die Sichten weichen im Mittel um %6 voneinander ab</translation>
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
        <translation>Geschwindigkeit, %1</translation>
    </message>
    <message>
        <source>± (σ)</source>
        <translation>± (σ)</translation>
    </message>
    <message>
        <source>acceleration, %1</source>
        <translation>Beschleunigung, %1</translation>
    </message>
    <message>
        <source>flags</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Was gemessen wurde</translation>
    </message>
    <message>
        <source>every sample, smoothed</source>
        <translation>jeder Messpunkt, geglättet</translation>
    </message>
    <message>
        <source>one sample of %1, smoothed; all of them are in the exported file</source>
        <translation>einer von %1 Messpunkten, geglättet; alle stehen in der exportierten Datei</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>smoother: %1</source>
        <translation>Glättung: %1</translation>
    </message>
    <message>
        <source>analysed %1, Odograph %2</source>
        <translation>ausgewertet %1, Odograph %2</translation>
    </message>
    <message>
        <source>%1: method</source>
        <translation>%1: Methode</translation>
    </message>
    <message>
        <source>How the metrics were computed</source>
        <translation>Wie die Kennwerte berechnet wurden</translation>
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
        <translation>Sprung</translation>
    </message>
    <message>
        <source>speed limit</source>
        <translation>Geschwindigkeitsgrenze</translation>
    </message>
    <message>
        <source>acceleration limit</source>
        <translation>Beschleunigungsgrenze</translation>
    </message>
    <message>
        <source>views disagree</source>
        <translation>Sichten uneins</translation>
    </message>
    <message>
        <source>low score</source>
        <translation>geringe Güte</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>duplicate frame</source>
        <translation>doppeltes Bild</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>interpoliert</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
</context>
<context>
    <name>ReportStills</name>
    <message>
        <source>no image: the video cannot be read</source>
        <translation>kein Bild: Das Video kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>no image: the video is missing</source>
        <translation>kein Bild: Das Video fehlt</translation>
    </message>
</context>
<context>
    <name>RobotColours</name>
    <message>
        <source>blue</source>
        <translation>blau</translation>
    </message>
    <message>
        <source>vermilion</source>
        <translation>zinnoberrot</translation>
    </message>
    <message>
        <source>green</source>
        <translation>grün</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>violett</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>orange</translation>
    </message>
    <message>
        <source>sky blue</source>
        <translation>himmelblau</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
</context>
<context>
    <name>RunEvents</name>
    <message>
        <source>First seen, moving already</source>
        <translation>Zuerst gesehen, schon in Bewegung</translation>
    </message>
    <message>
        <source>Starts to move</source>
        <translation>Fährt an</translation>
    </message>
    <message>
        <source>Last seen, still moving</source>
        <translation>Zuletzt gesehen, noch in Bewegung</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Hält an</translation>
    </message>
    <message>
        <source>Top speed, %1</source>
        <translation>Höchstgeschw., %1</translation>
    </message>
    <message>
        <source>Passes %1</source>
        <translation>Passiert %1</translation>
    </message>
    <message>
        <source>Spike: %1</source>
        <translation>Ausreißer: %1</translation>
    </message>
    <message numerus="yes">
        <source>(%n samples)</source>
        <translation>
            <numerusform>(%n Messpunkt)</numerusform>
            <numerusform>(%n Messpunkte)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SceneDisagreement</name>
    <message>
        <source>Only one view at a time: nothing to compare</source>
        <translation>Immer nur eine Sicht zugleich: nichts zu vergleichen</translation>
    </message>
    <message>
        <source>RMS %1, median %2</source>
        <translation>RMS %1, Median %2</translation>
    </message>
    <message>
        <source>expected from the uncertainty: %1</source>
        <translation>nach den Fehlern erwartet: %1</translation>
    </message>
    <message>
        <source>%1 – more than it explains</source>
        <translation>%1 – mehr, als sie erklären</translation>
    </message>
    <message>
        <source>Disagreement of the views</source>
        <translation>Abweichung der Sichten</translation>
    </message>
    <message>
        <source>Each view alone gives a floor position of the robot. The chart shows the distance between these positions in each frame with two views or more (of more than two, the largest distance); RMS is √(mean of the squares). Unused samples are left out.
Expected is √(tr A + tr B + (v·σs)²) from the covariances A and B of two views (pixels and calibration), the speed v and the synchronisation uncertainty σs of the views.
Much more than expected means that a setting is wrong: the views are not synchronised (the distance grows with the speed), a camera has moved or is badly registered (it depends on the position), or the robot&apos;s height is wrong (it points to and from the cameras).</source>
        <translation>Jede Sicht für sich setzt den Roboter an einen Ort auf dem Boden. Gezeigt wird, wie weit diese Orte in jedem Bild auseinanderliegen, in dem zwei oder mehr Sichten ihn sahen (bei mehr als zweien der größte Abstand); RMS ist √(Mittel der Quadrate). Messpunkte, die nicht verwendet werden, sind ausgelassen.
Erwartet ist √(tr A + tr B + (v·σs)²) aus den Kovarianzen A und B zweier Sichten (Pixel und Kalibrierung), der Geschwindigkeit v und der Unsicherheit σs der Synchronisierung.
Viel mehr als erwartet heißt, dass etwas nicht so ist wie angegeben: Die Sichten sind nicht synchron (dann wächst die Abweichung mit der Geschwindigkeit), eine Kamera hat sich bewegt oder ist schlecht eingemessen (dann hängt die Abweichung vom Ort ab), oder die Höhe des Roboters stimmt nicht (dann zeigt die Abweichung zu den Kameras hin oder von ihnen weg).</translation>
    </message>
    <message>
        <source>%1 frames with two views or more; largest %2; views synchronised to %3 ms</source>
        <translation>%1 Bilder von zwei oder mehr Sichten gesehen; größte Abweichung %2; Sichten synchron auf %3 ms</translation>
    </message>
</context>
<context>
    <name>ScoreText</name>
    <message>
        <source>%1: not measured, no points (%2)</source>
        <translation>%1: nicht gemessen, keine Punkte (%2)</translation>
    </message>
    <message>
        <source>%1 %2: %3 points (%4)</source>
        <translation>%1 %2: %3 Punkte (%4)</translation>
    </message>
    <message>
        <source>%1 %2: %3 of %4 points (%5)</source>
        <translation>%1 %2: %3 von %4 Punkten (%5)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>the sum of the points of each line; a line gives points × (metric − none at) / (all at − none at), from 0 to all</source>
        <translation>die Summe der Punkte aller Zeilen; eine Zeile gibt Punkte × (Kennwert − keine bei) / (alle bei − keine bei), von 0 bis alle</translation>
    </message>
    <message>
        <source>for each line, half the difference in points between its metric plus and minus one σ; root of the sum of the squares</source>
        <translation>je Zeile die Hälfte dessen, um das sich ihre Punkte unterscheiden, wenn ihr Kennwert ein σ mehr oder weniger ist; Wurzel aus der Quadratsumme</translation>
    </message>
    <message>
        <source>%1 points off at %2 or less, none off at %3 or more</source>
        <translation>%1 Punkte Abzug bei %2 oder weniger, keiner bei %3 oder mehr</translation>
    </message>
    <message>
        <source>%1 points off at %2 or more, none off at %3 or less</source>
        <translation>%1 Punkte Abzug bei %2 oder mehr, keiner bei %3 oder weniger</translation>
    </message>
    <message>
        <source>%1 points at %2 or less, none at %3 or more</source>
        <translation>%1 Punkte bei %2 oder weniger, keine bei %3 oder mehr</translation>
    </message>
    <message>
        <source>%1 points at %2 or more, none at %3 or less</source>
        <translation>%1 Punkte bei %2 oder mehr, keine bei %3 oder weniger</translation>
    </message>
</context>
<context>
    <name>Scoreboard</name>
    <message>
        <source>Standings</source>
        <translation>Rangliste</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Beste</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letzte</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Fahrten</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>Best run</source>
        <translation>Beste Fahrt</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Verbinde…</translation>
    </message>
    <message>
        <source>Connection lost. Reconnecting…</source>
        <translation>Verbindung unterbrochen. Verbinde erneut…</translation>
    </message>
    <message>
        <source>This page needs JavaScript.</source>
        <translation>Diese Seite braucht JavaScript.</translation>
    </message>
    <message>
        <source>Teams rank by the median of their runs. Teams that do not differ significantly (95 %) share a rank. ±: one standard deviation. ≈: not significantly behind the first.</source>
        <translation>Der Rang folgt aus dem Median der Fahrten. Teams ohne signifikanten Unterschied (95 %) teilen sich einen Rang. ±: eine Standardabweichung. ≈: nicht signifikant hinter dem ersten Team.</translation>
    </message>
    <message>
        <source>No ranks: no trial has a task, and runs of different tasks cannot be compared.</source>
        <translation>Keine Ränge: Kein Versuch hat eine Aufgabe, und Fahrten verschiedener Aufgaben sind nicht vergleichbar.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course.</source>
        <translation>
            <numerusform>%n Versuch ausgelassen: nach einem anderen Parcours ausgewertet.</numerusform>
            <numerusform>%n Versuche ausgelassen: nach einem anderen Parcours ausgewertet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>%n Versuch nicht gezählt: schlechte Ergebnisse.</numerusform>
            <numerusform>%n Versuche nicht gezählt: schlechte Ergebnisse.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! %n Versuch mit zweifelhaften Ergebnissen gezählt.</numerusform>
            <numerusform>! %n Versuche mit zweifelhaften Ergebnissen gezählt.</numerusform>
        </translation>
    </message>
    <message>
        <source>No team has a result yet.</source>
        <translation>Noch kein Team hat ein Ergebnis.</translation>
    </message>
    <message>
        <source>Running now</source>
        <translation>Fährt gerade</translation>
    </message>
    <message>
        <source>The best run from above</source>
        <translation>Die beste Fahrt von oben</translation>
    </message>
    <message>
        <source>a square: %1</source>
        <translation>ein Kästchen: %1</translation>
    </message>
</context>
<context>
    <name>SetupWords</name>
    <message>
        <source>Two phones on tripods are enough. Film the robot with both, import the clips or drop them on this window; or connect cameras.</source>
        <translation>Zwei Handys auf Stativen genügen. Filmen Sie den Roboter mit beiden und importieren Sie die Videos oder ziehen Sie sie auf dieses Fenster; oder schließen Sie Kameras an.</translation>
    </message>
    <message>
        <source>Cameras: %1.</source>
        <translation>Kameras: %1.</translation>
    </message>
    <message>
        <source>Print the mat, tape it together and lay it where every camera sees it while it films: from it Odograph knows where the floor is.</source>
        <translation>Drucken Sie die Matte, kleben Sie sie zusammen und legen Sie sie hin, wo jede Kamera sie beim Filmen sieht: Daraus weiß Odograph, wo der Boden ist.</translation>
    </message>
    <message>
        <source>Positions on the floor: %1.</source>
        <translation>Positionen auf dem Boden: %1.</translation>
    </message>
    <message>
        <source>Not registered yet: %1.</source>
        <translation>Noch nicht eingemessen: %1.</translation>
    </message>
    <message>
        <source>A printed board measures the distortion of the lens; without it positions far from the mat are less exact, and their ± says so.</source>
        <translation>Eine gedruckte Tafel zeigt, wie das Objektiv das Bild verbiegt; ohne sie sind Positionen weit von der Matte weniger genau, und ihr ± sagt es.</translation>
    </message>
    <message>
        <source>Calibrated: %1.</source>
        <translation>Vermessen: %1.</translation>
    </message>
    <message>
        <source>A name is enough: Odograph finds a robot of any look by its motion.</source>
        <translation>Ein Name genügt: Odograph findet einen Roboter, wie er auch aussieht, an seiner Bewegung.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>Robots: %1.</source>
        <translation>Roboter: %1.</translation>
    </message>
    <message>
        <source>Imported clips are tracked here, or record with connected cameras.</source>
        <translation>Hier werden importierte Videos verfolgt; oder nehmen Sie mit angeschlossenen Kameras auf.</translation>
    </message>
    <message>
        <source>%1 is not measured yet.</source>
        <translation>%1 ist noch nicht gemessen.</translation>
    </message>
    <message>
        <source>%1 is measured.</source>
        <translation>%1 ist gemessen.</translation>
    </message>
    <message>
        <source>Path, speed, acceleration and their ±, spikes with reasons: one PDF for each trial, or for the class.</source>
        <translation>Weg, Geschwindigkeit, Beschleunigung mit ihrem ±, Ausreißer mit Gründen: ein PDF für jeden Versuch oder für die Klasse.</translation>
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
        <translation>Tag</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>dot</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>tape crossing</source>
        <translation>Klebebandkreuz</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>crossing fields</source>
        <translation>Felderkreuzung</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
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
        <translation>Schachbrett, %1 × %2 innere Ecken, Quadrate von %3</translation>
    </message>
    <message>
        <source>ChArUco board, %1 × %2 inner corners, squares of %3</source>
        <translation>ChArUco-Tafel, %1 × %2 innere Ecken, Quadrate von %3</translation>
    </message>
    <message>
        <source>Floor marker %1 (tag 36h11 number %2), %3</source>
        <translation>Bodenmarker %1 (Tag 36h11 Nummer %2), %3</translation>
    </message>
    <message>
        <source>Floor marker %1 (ring), %2</source>
        <translation>Bodenmarker %1 (Ring), %2</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size). Glue it flat onto something stiff, measure a square, and enter its side in Odograph.</source>
        <translation>Mit 100 % (tatsächliche Größe) drucken. Flach auf etwas Steifes kleben, ein Quadrat messen und Odograph sagen, was Sie gemessen haben.</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size). Lay it flat; the marker&apos;s position is its middle, where the four lines at the edges point.</source>
        <translation>Mit 100 % (tatsächliche Größe) drucken. Flach hinlegen; der Ort des Markers ist seine Mitte, wohin die vier Striche an den Rändern zeigen.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets</source>
        <translation>Bodenmatte aus %1 × %2 Blättern</translation>
    </message>
</context>
<context>
    <name>TestbedState</name>
    <message>
        <source>standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>rational</source>
        <translation>rational</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>Fischauge</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>Bildgröße</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>%1, f = %2 px</source>
        <translation>%1, f = %2 px</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Board error</source>
        <translation>Tafelfehler</translation>
    </message>
    <message>
        <source>%1 px in %2 images</source>
        <translation>%1 px in %2 Bildern</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>Kontrollfehler</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>On the floor</source>
        <translation>Am Boden</translation>
    </message>
    <message>
        <source>registered %1</source>
        <translation>eingemessen %1</translation>
    </message>
    <message>
        <source>Last check</source>
        <translation>Letzte Prüfung</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3 m high</source>
        <translation>x %1 m, y %2 m, %3 m hoch</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Achtung</translation>
    </message>
    <message>
        <source>not registered: cannot measure positions yet</source>
        <translation>nicht eingemessen: Orte lassen sich noch nicht messen</translation>
    </message>
    <message>
        <source>not calibrated: estimated from the markers</source>
        <translation>nicht kalibriert: aus den Markern geschätzt</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
</context>
<context>
    <name>TrailPainting</name>
    <message>
        <source>0 to %1 %2</source>
        <translation>0 bis %1 %2</translation>
    </message>
</context>
<context>
    <name>TrendPainting</name>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
</context>
<context>
    <name>TrialCurves</name>
    <message>
        <source>No curve yet: track the trial</source>
        <translation>Noch keine Kurve: zuerst den Roboter verfolgen</translation>
    </message>
</context>
<context>
    <name>TrialExport</name>
    <message>
        <source>CSV for programs (*.csv)</source>
        <translation>CSV für Programme (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1.5 (*.csv)</source>
        <translation>CSV für Tabellenkalkulation, 1.5 (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1,5 (*.csv)</source>
        <translation>CSV für Tabellenkalkulation, 1,5 (*.csv)</translation>
    </message>
    <message>
        <source>Tracker text (*.txt)</source>
        <translation>Tracker-Text (*.txt)</translation>
    </message>
    <message>
        <source>TUM trajectory (*.tum)</source>
        <translation>TUM-Trajektorie (*.tum)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Robot:</source>
        <translation>Roboter:</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exportieren</translation>
    </message>
    <message>
        <source>%1 was exported to %2.</source>
        <translation>%1 wurde nach %2 exportiert.</translation>
    </message>
    <message>
        <source>Page to take along (*.html)</source>
        <translation>Seite zum Mitnehmen (*.html)</translation>
    </message>
</context>
<context>
    <name>TrialFacts</name>
    <message>
        <source>%1, %2 high (estimated)</source>
        <translation>%1, %2 hoch (geschätzt)</translation>
    </message>
    <message>
        <source>%1, %2 high</source>
        <translation>%1, %2 hoch</translation>
    </message>
    <message>
        <source>%1: %2×%3, %4 frames</source>
        <translation>%1: %2×%3, %4 Bilder</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Sicht</translation>
    </message>
    <message>
        <source>video missing</source>
        <translation>Video fehlt</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>nicht eingemessen</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>Synchron</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>not synchronised</source>
        <translation>nicht synchronisiert</translation>
    </message>
    <message>
        <source>SHA-256 %1…</source>
        <translation>SHA-256 %1…</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Tore</translation>
    </message>
    <message>
        <source>to %1 %2</source>
        <translation>bis %1 %2</translation>
    </message>
    <message>
        <source>Lap %1</source>
        <translation>Runde %1</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Fahrt %1</translation>
    </message>
    <message>
        <source>off by %1 on average</source>
        <translation>im Mittel %1 daneben</translation>
    </message>
    <message>
        <source>%1 (RMS)</source>
        <translation>%1 (RMS)</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 nach links</translation>
    </message>
    <message>
        <source>%1 of it completed</source>
        <translation>%1 davon geschafft</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>eingehalten</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>analysed with a different course</source>
        <translation>nach anderem Parcours ausgewertet</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>none until you reanalyse the trial: the task has a different course now</source>
        <translation>keine bis zur neuen Auswertung: Die Aufgabe hat jetzt einen anderen Parcours</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Testbed</source>
        <translation>Messplatz</translation>
    </message>
    <message>
        <source>markers “%1”</source>
        <translation>Marker „%1“</translation>
    </message>
    <message>
        <source>Imported</source>
        <translation>Importiert</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Sollbahn</translation>
    </message>
    <message>
        <source>Distance from the path</source>
        <translation>Abstand von der Sollbahn</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>Zonen</translation>
    </message>
    <message>
        <source>Smoother</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Analysed</source>
        <translation>Ausgewertet</translation>
    </message>
    <message>
        <source>%1, Odograph %2</source>
        <translation>%1, Odograph %2</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>rate varies</source>
        <translation>Rate schwankt</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Accept…</source>
        <translation>Akzeptieren…</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>%1 to %2 of %3</source>
        <translation>%1 bis %2 von %3</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>In millimetres</source>
        <translation>In Millimetern</translation>
    </message>
</context>
<context>
    <name>TrialLines</name>
    <message>
        <source>What the synchronisation is worth</source>
        <translation>Was die Synchronität wert ist</translation>
    </message>
    <message>
        <source>σ of the time anywhere in the recording, of the offset and of the clock rate over its length, times the run&apos;s top speed. The remaining time error τ is that of d² = d₀² + τ²v² between the views&apos; distance d and the speed v: least squares over means of half a second.</source>
        <translation>σ der Zeit irgendwo in der Aufnahme, vom Zeitversatz und vom Uhrengang über ihre Länge, mal der Höchstgeschwindigkeit des Versuchs. Der übrige Zeitfehler τ ist der von d² = d₀² + τ²v² zwischen dem Abstand d der Sichten und der Geschwindigkeit v: kleinste Quadrate über Mittel von einer halben Sekunde.</translation>
    </message>
    <message>
        <source>of τ: by the scatter of those means. Blur grows with the speed, too, so τ is at most as stated.</source>
        <translation>von τ: aus der Streuung dieser Mittel. Auch Unschärfe wächst mit der Geschwindigkeit, daher ist τ höchstens so groß wie angegeben.</translation>
    </message>
    <message>
        <source>view %1: %2 frames</source>
        <translation>Sicht %1: %2 Bilder</translation>
    </message>
    <message>
        <source>±%1 at the top speed</source>
        <translation>±%1 bei der Höchstgeschwindigkeit</translation>
    </message>
    <message>
        <source>%1: never inside</source>
        <translation>%1: nie darin</translation>
    </message>
    <message>
        <source>%1: inside for at least %2</source>
        <translation>%1: mindestens %2 darin</translation>
    </message>
    <message>
        <source>%1: inside for %2</source>
        <translation>%1: %2 darin</translation>
    </message>
    <message>
        <source>, from the start</source>
        <translation>, von Anfang an</translation>
    </message>
    <message numerus="yes">
        <source>, entered %n time(s)</source>
        <translation>
            <numerusform>, %n-mal hineingefahren</numerusform>
            <numerusform>, %n-mal hineingefahren</numerusform>
        </translation>
    </message>
    <message>
        <source>, first after %1</source>
        <translation>, zuerst nach %1</translation>
    </message>
</context>
<context>
    <name>TrialReport</name>
    <message>
        <source>class median %1</source>
        <translation>Klassenmedian %1</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>The run from above</source>
        <translation>Die Fahrt von oben</translation>
    </message>
    <message>
        <source>coloured by speed</source>
        <translation>gefärbt nach Geschwindigkeit</translation>
    </message>
    <message>
        <source>The cameras’ views</source>
        <translation>Kamerasichten</translation>
    </message>
    <message>
        <source>at %1, the top speed</source>
        <translation>bei %1, am schnellsten</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>It did not move</source>
        <translation>Er bewegte sich nicht</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>Zwischenzeiten</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Fahrt %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>± one σ</source>
        <translation>± ein σ</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>This trial has not been tracked yet: it has no metrics.</source>
        <translation>In diesem Versuch wurde der Roboter noch nicht verfolgt: Es gibt keine Kennwerte.</translation>
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
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>%1 times in all</source>
        <translation>insgesamt %1-mal</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… und %n weiterer</numerusform>
            <numerusform>… und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Bad results: do not use them.</source>
        <translation>Schlechte Ergebnisse: nicht verwenden.</translation>
    </message>
    <message>
        <source>Doubtful results, which were accepted.</source>
        <translation>Zweifelhafte Ergebnisse, die akzeptiert wurden.</translation>
    </message>
    <message>
        <source>Doubtful results: read the reasons before you use them.</source>
        <translation>Zweifelhafte Ergebnisse: vor der Verwendung die Gründe lesen.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
</context>
<context>
    <name>UncertainIntervals</name>
    <message>
        <source>Which robot? Until %1</source>
        <translation>Welcher Roboter? Bis %1</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>Not measured until %1</source>
        <translation>Nicht gemessen bis %1</translation>
    </message>
    <message>
        <source>not measured (%1 to %2)</source>
        <translation>nicht gemessen (%1 bis %2)</translation>
    </message>
</context>
<context>
    <name>VerdictMark</name>
    <message>
        <source>accepted</source>
        <translation>akzeptiert</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Akzeptiert: %1</translation>
    </message>
    <message>
        <source>all checks passed</source>
        <translation>alle Prüfungen bestanden</translation>
    </message>
</context>
<context>
    <name>WindowTitle</name>
    <message>
        <source>Team %1</source>
        <translation>Team %1</translation>
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
        <translation>eine Konstante</translation>
    </message>
</context>
<context>
    <name>analysis.a_parabola</name>
    <message>
        <source>a parabola</source>
        <translation>eine Parabel</translation>
    </message>
</context>
<context>
    <name>analysis.a_straight_line</name>
    <message>
        <source>a straight line</source>
        <translation>eine Gerade</translation>
    </message>
</context>
<context>
    <name>analysis.align_by_distance</name>
    <message>
        <source>align by distance</source>
        <translation>richten Sie nach dem Weg aus</translation>
    </message>
</context>
<context>
    <name>analysis.align_otherwise</name>
    <message>
        <source>align by motion onset or distance</source>
        <translation>richten Sie nach Bewegungsbeginn oder Weg aus</translation>
    </message>
</context>
<context>
    <name>analysis.check_numbers</name>
    <message>
        <source>check the numbers</source>
        <translation>prüfen Sie die Zahlen</translation>
    </message>
</context>
<context>
    <name>analysis.choose_another_run</name>
    <message>
        <source>choose another run as well</source>
        <translation>wählen Sie noch eine Fahrt</translation>
    </message>
</context>
<context>
    <name>analysis.choose_common_place</name>
    <message>
        <source>choose a position that both runs pass</source>
        <translation>wählen Sie einen Ort, an dem beide Fahrten vorbeikommen</translation>
    </message>
</context>
<context>
    <name>analysis.choose_figure</name>
    <message>
        <source>choose a metric to score</source>
        <translation>wählen Sie, was gewertet wird</translation>
    </message>
</context>
<context>
    <name>analysis.choose_log_of_run</name>
    <message>
        <source>choose the log of this run</source>
        <translation>wählen Sie das Protokoll dieser Fahrt</translation>
    </message>
</context>
<context>
    <name>analysis.choose_longer_range</name>
    <message>
        <source>choose a longer range</source>
        <translation>wählen Sie einen längeren Bereich</translation>
    </message>
</context>
<context>
    <name>analysis.choose_motion</name>
    <message>
        <source>choose a run with motion</source>
        <translation>wählen Sie eine Fahrt mit Bewegung</translation>
    </message>
</context>
<context>
    <name>analysis.choose_same_direction</name>
    <message>
        <source>choose runs in the same direction</source>
        <translation>wählen Sie Fahrten in gleicher Richtung</translation>
    </message>
</context>
<context>
    <name>analysis.choose_same_task</name>
    <message>
        <source>choose runs of the same task</source>
        <translation>wählen Sie Fahrten derselben Aufgabe</translation>
    </message>
</context>
<context>
    <name>analysis.comparison</name>
    <message>
        <source>comparison</source>
        <translation>Vergleich</translation>
    </message>
</context>
<context>
    <name>analysis.comparison_of</name>
    <message>
        <source>comparison of %1</source>
        <translation>Vergleich von %1</translation>
    </message>
</context>
<context>
    <name>analysis.corners_in_order</name>
    <message>
        <source>enter the corners in order, all the way round</source>
        <translation>geben Sie die Ecken der Reihe nach ringsherum an</translation>
    </message>
</context>
<context>
    <name>analysis.corners_off_floor</name>
    <message>
        <source>its corners are not all on a floor of 1 km</source>
        <translation>ihre Ecken liegen nicht auf einem Boden von 1 km</translation>
    </message>
</context>
<context>
    <name>analysis.corners_once</name>
    <message>
        <source>enter each corner once</source>
        <translation>geben Sie jede Ecke einmal an</translation>
    </message>
</context>
<context>
    <name>analysis.corners_too_near</name>
    <message>
        <source>two corners are less than 1 mm apart</source>
        <translation>zwei Ecken liegen weniger als 1 mm auseinander</translation>
    </message>
</context>
<context>
    <name>analysis.draw_coarsely</name>
    <message>
        <source>draw it with fewer corners</source>
        <translation>zeichnen Sie sie gröber</translation>
    </message>
</context>
<context>
    <name>analysis.ends_off_floor</name>
    <message>
        <source>its ends are not both on a floor of 1 km</source>
        <translation>die Enden liegen nicht auf einem Boden von 1 km</translation>
    </message>
</context>
<context>
    <name>analysis.ends_too_near</name>
    <message>
        <source>its ends are less than 1 mm apart</source>
        <translation>die Enden liegen weniger als 1 mm auseinander</translation>
    </message>
</context>
<context>
    <name>analysis.few_corners</name>
    <message>
        <source>it has fewer than three corners</source>
        <translation>sie hat weniger als drei Ecken</translation>
    </message>
</context>
<context>
    <name>analysis.few_points</name>
    <message>
        <source>it has too few points</source>
        <translation>zu wenige Punkte</translation>
    </message>
</context>
<context>
    <name>analysis.finish_is_there</name>
    <message>
        <source>gate &apos;%1&apos; is already the finish</source>
        <translation>Tor &apos;%1&apos; ist schon das Ziel</translation>
    </message>
</context>
<context>
    <name>analysis.fit_of</name>
    <message>
        <source>fit of %1</source>
        <translation>Anpassung (%1)</translation>
    </message>
</context>
<context>
    <name>analysis.formula_best_lap</name>
    <message>
        <source>The shortest lap.</source>
        <translation>Die kürzeste Runde.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_circle_radius</name>
    <message>
        <source>The least-squares circle through the positions of the motion.</source>
        <translation>Der Kreis mit den kleinsten Abstandsquadraten von den Orten der Bewegung.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_bias</name>
    <message>
        <source>The mean of the distance from the reference path, to the left positive.</source>
        <translation>Das Mittel des Abstands von der Sollbahn, nach links positiv.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_max</name>
    <message>
        <source>The largest distance from the reference path.</source>
        <translation>Der größte Abstand von der Sollbahn.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_mean</name>
    <message>
        <source>The distance from the reference path, averaged along the path.</source>
        <translation>Der mittlere Abstand von der Sollbahn, über den Weg.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_rms</name>
    <message>
        <source>√(mean of the squared distance from the reference path), averaged along the path</source>
        <translation>√(Mittel der Abstandsquadrate von der Sollbahn), über den Weg</translation>
    </message>
</context>
<context>
    <name>analysis.formula_duration</name>
    <message>
        <source>From the onset of motion to the last stop. Moving means faster than three σ of the speed, for at least three frames, and further than noise explains; the moment between two frames is interpolated.</source>
        <translation>Vom Bewegungsbeginn bis zum letzten Halt. In Bewegung heißt schneller als drei σ der Geschwindigkeit, mindestens drei Bilder lang, und weiter, als Rauschen erklärt; der Zeitpunkt zwischen zwei Bildern wird interpoliert.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_gate_time</name>
    <message>
        <source>From passing the start gate to passing the finish, each interpolated between frames.</source>
        <translation>Vom Passieren des Starttors bis zum Passieren des Ziels, beides zwischen den Bildern interpoliert.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_laps</name>
    <message>
        <source>Complete laps or runs, counted by the passages of the gates.</source>
        <translation>Vollständige Runden oder Fahrten, gezählt nach den Durchfahrten der Tore.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_accel</name>
    <message>
        <source>The acceleration |a| of the smoothed curve where |a| − 2σ is largest.</source>
        <translation>Die Beschleunigung |a| der geglätteten Kurve, wo |a| − 2σ am größten ist.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_speed</name>
    <message>
        <source>The speed |v| of the smoothed curve where |v| − 2σ is largest. A point does not win only because its uncertainty is large.</source>
        <translation>Die Geschwindigkeit |v| der geglätteten Kurve, wo |v| − 2σ am größten ist, damit ein schlecht bekannter Punkt nicht durch seinen Fehler gewinnt.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_turn_rate</name>
    <message>
        <source>How fast the robot turns, to the left or right, where the amount minus 2σ is largest. Of the body where its heading was measured, also on the spot: the rate of the smoothed heading. Elsewhere of the direction of motion: (vx·ay − vy·ax)/|v|² of the smoothed curve.</source>
        <translation>Wie schnell sich der Roboter dreht, nach links oder rechts, wo der Betrag minus 2σ am größten ist. Die des Rumpfs, wo dessen Ausrichtung gemessen wurde, auch auf der Stelle: die Rate der geglätteten Ausrichtung. Sonst die der Bewegungsrichtung: (vx·ay − vy·ax)/|v|² der geglätteten Kurve.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_mean_lap</name>
    <message>
        <source>The mean of the laps&apos; times.</source>
        <translation>Das Mittel der Rundenzeiten.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_mean_speed</name>
    <message>
        <source>path length / time, both without gaps</source>
        <translation>Weg / Zeit, beide ohne Lücken</translation>
    </message>
</context>
<context>
    <name>analysis.formula_median_speed</name>
    <message>
        <source>The speed that half of the time in motion stays below.</source>
        <translation>Die Geschwindigkeit, unter der die Hälfte der Zeit in Bewegung bleibt.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_moving_time</name>
    <message>
        <source>The time in which it moves: faster than three σ of the speed, and further than noise explains.</source>
        <translation>Die Zeit, in der er sich bewegt: schneller als drei σ der Geschwindigkeit und weiter, als Rauschen erklärt.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_p95_accel</name>
    <message>
        <source>The acceleration that 95 % of the time in motion stays below.</source>
        <translation>Die Beschleunigung, unter der 95 % der Zeit in Bewegung bleiben.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_p95_speed</name>
    <message>
        <source>The speed that 95 % of the time in motion stays below.</source>
        <translation>Die Geschwindigkeit, unter der 95 % der Zeit in Bewegung bleiben.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_path_completed</name>
    <message>
        <source>The share of the reference path that the robot followed.</source>
        <translation>Der Anteil der Sollbahn, dem gefolgt wurde.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_path_length</name>
    <message>
        <source>∫|v|dt while it moves, by the trapezoidal rule over the smoothed speed. A gap that is not bridged adds nothing.</source>
        <translation>∫|v|dt, solange er sich bewegt, nach der Trapezregel über die geglättete Geschwindigkeit. Eine Lücke, die nicht überbrückt ist, trägt nichts bei.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_rms_accel</name>
    <message>
        <source>√(mean of |a|²) while it moves</source>
        <translation>√(Mittel von |a|²), solange er sich bewegt</translation>
    </message>
</context>
<context>
    <name>analysis.formula_rms_speed</name>
    <message>
        <source>√(mean of |v|²) while it moves</source>
        <translation>√(Mittel von |v|²), solange er sich bewegt</translation>
    </message>
</context>
<context>
    <name>analysis.formula_standing_time</name>
    <message>
        <source>time − time in motion</source>
        <translation>Zeit − Zeit in Bewegung</translation>
    </message>
</context>
<context>
    <name>analysis.formula_stops</name>
    <message>
        <source>The pauses between the onset of motion and the last stop, counted where the robot was measured at rest.</source>
        <translation>Die Zahl der Pausen zwischen dem Bewegungsbeginn und dem letzten Halt, in denen der Roboter stehend gemessen wurde.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_straightness</name>
    <message>
        <source>distance from the first to the last position of the motion / path length</source>
        <translation>Abstand vom ersten zum letzten Ort der Bewegung / Weg</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_breaches</name>
    <message>
        <source>How often the robot&apos;s reference point left a zone to stay in or entered a zone to keep out of. It counts if the point is beyond the edge by more than six σ of the track&apos;s noise.</source>
        <translation>Wie oft die Mitte des Roboters eine Zone verließ, in der sie bleiben soll, oder in eine kam, die sie meiden soll. Es zählt, wenn sie um mehr als sechs σ des Eigenrauschens der Spur jenseits des Rands ist.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_depth</name>
    <message>
        <source>The largest distance of the robot&apos;s reference point beyond the edge of a zone.</source>
        <translation>Wie weit die Mitte des Roboters höchstens jenseits des Rands einer Zone war.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_time</name>
    <message>
        <source>The time for which the robot&apos;s reference point was beyond the edge of a zone, interpolated between frames; in two zones at once it counts twice.</source>
        <translation>Die Zeit, in der die Mitte des Roboters jenseits des Rands einer Zone war, zwischen den Bildern interpoliert; in zwei Zonen zugleich zählt sie doppelt.</translation>
    </message>
</context>
<context>
    <name>analysis.gate</name>
    <message>
        <source>gate &apos;%1&apos;</source>
        <translation>Tor &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.give_another_number</name>
    <message>
        <source>choose another number</source>
        <translation>geben Sie eine andere Zahl an</translation>
    </message>
</context>
<context>
    <name>analysis.give_corners</name>
    <message>
        <source>enter the corners of its outline, all the way round</source>
        <translation>geben Sie die Ecken ihres Umrisses an, ringsherum</translation>
    </message>
</context>
<context>
    <name>analysis.give_ends</name>
    <message>
        <source>enter the two ends of the line that the robot passes</source>
        <translation>geben Sie die beiden Enden der Linie an, die zu überfahren ist</translation>
    </message>
</context>
<context>
    <name>analysis.give_limits</name>
    <message>
        <source>enter the largest speed and acceleration that a robot can reach in the task</source>
        <translation>geben Sie die größte Geschwindigkeit und Beschleunigung an, die ein Roboter in der Aufgabe haben kann</translation>
    </message>
</context>
<context>
    <name>analysis.give_log_offset</name>
    <message>
        <source>give the time offset of the log</source>
        <translation>geben Sie den Zeitversatz des Protokolls an</translation>
    </message>
</context>
<context>
    <name>analysis.give_place</name>
    <message>
        <source>enter its position in millimetres</source>
        <translation>geben Sie an, wo es liegt, in Millimetern</translation>
    </message>
</context>
<context>
    <name>analysis.give_points</name>
    <message>
        <source>enter points from 1 to 1000; use a negative number for a penalty</source>
        <translation>geben Sie Punkte von 1 bis 1000 an, für eine Strafe unter null</translation>
    </message>
</context>
<context>
    <name>analysis.give_sizes</name>
    <message>
        <source>enter the sizes in millimetres</source>
        <translation>geben Sie die Größen in Millimetern an</translation>
    </message>
</context>
<context>
    <name>analysis.give_three_numbers</name>
    <message>
        <source>enter three numbers</source>
        <translation>geben Sie drei Zahlen an</translation>
    </message>
</context>
<context>
    <name>analysis.give_two_points</name>
    <message>
        <source>enter at least two points, or three for a closed path</source>
        <translation>geben Sie zwei Punkte oder mehr an, drei bei geschlossener Bahn</translation>
    </message>
</context>
<context>
    <name>analysis.give_two_values</name>
    <message>
        <source>enter two different values; the points rise between them</source>
        <translation>geben Sie zwei Werte an, zwischen denen die Punkte steigen</translation>
    </message>
</context>
<context>
    <name>analysis.join_zones</name>
    <message>
        <source>merge neighbouring zones</source>
        <translation>verbinden Sie nebeneinander liegende Zonen</translation>
    </message>
</context>
<context>
    <name>analysis.keep_what_matters</name>
    <message>
        <source>keep those that matter</source>
        <translation>behalten Sie die wichtigen</translation>
    </message>
</context>
<context>
    <name>analysis.limit_not_positive</name>
    <message>
        <source>a limit is zero or negative</source>
        <translation>ein Grenzwert ist nicht größer als null</translation>
    </message>
</context>
<context>
    <name>analysis.limits</name>
    <message>
        <source>limits of a task</source>
        <translation>Grenzwerte einer Aufgabe</translation>
    </message>
</context>
<context>
    <name>analysis.line_of_scoring</name>
    <message>
        <source>line %1 of the scoring</source>
        <translation>Zeile %1 der Wertung</translation>
    </message>
</context>
<context>
    <name>analysis.little_motion</name>
    <message>
        <source>the robot hardly moves in %1</source>
        <translation>in %1 bewegt sich der Roboter kaum</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_no_common_time</name>
    <message>
        <source>fewer than %1 of its positions have times at which the robot was measured</source>
        <translation>weniger als %1 seiner Positionen fallen in Zeiten, zu denen der Roboter gemessen wurde</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_other_front</name>
    <message>
        <source>the log&apos;s heading is %1 from the measured one throughout: its front or its axes may differ</source>
        <translation>die Ausrichtung im Protokoll weicht durchweg um %1 von der gemessenen ab: Seine Vorderseite oder seine Achsen sind vielleicht andere</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_other_lengths</name>
    <message>
        <source>the log&apos;s lengths are %1 times the measured ones: its unit may be wrong</source>
        <translation>die Längen im Protokoll sind das %1-Fache der gemessenen: Seine Einheit ist vielleicht falsch</translation>
    </message>
</context>
<context>
    <name>analysis.log_is_mirrored</name>
    <message>
        <source>it is the mirror image of the run</source>
        <translation>es ist das Spiegelbild der Fahrt</translation>
    </message>
</context>
<context>
    <name>analysis.log_moves_otherwise</name>
    <message>
        <source>it moves differently: at no time offset do more than %1 of the changes of speed and direction agree</source>
        <translation>es bewegt sich anders: Bei keinem Zeitversatz stimmen mehr als %1 der Änderungen von Geschwindigkeit und Richtung überein</translation>
    </message>
</context>
<context>
    <name>analysis.many_corners</name>
    <message>
        <source>it has more than %1 corners</source>
        <translation>sie hat mehr als %1 Ecken</translation>
    </message>
</context>
<context>
    <name>analysis.many_lines</name>
    <message>
        <source>it has more than %1 lines</source>
        <translation>sie hat mehr als %1 Zeilen</translation>
    </message>
</context>
<context>
    <name>analysis.many_points</name>
    <message>
        <source>it has more than %1 points</source>
        <translation>mehr als %1 Punkte</translation>
    </message>
</context>
<context>
    <name>analysis.many_zones</name>
    <message>
        <source>the task already has %1 zones</source>
        <translation>die Aufgabe hat schon %1 Zonen</translation>
    </message>
</context>
<context>
    <name>analysis.metric_best_lap</name>
    <message>
        <source>Best lap</source>
        <translation>Beste Runde</translation>
    </message>
</context>
<context>
    <name>analysis.metric_circle_radius</name>
    <message>
        <source>Circle&apos;s radius</source>
        <translation>Radius des Kreises</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_bias</name>
    <message>
        <source>Left of the path</source>
        <translation>Links der Bahn</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_max</name>
    <message>
        <source>Off the path (most)</source>
        <translation>Bahnabweichung (max.)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_mean</name>
    <message>
        <source>Off the path (mean)</source>
        <translation>Bahnabweichung (Mittel)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_rms</name>
    <message>
        <source>Off the path (RMS)</source>
        <translation>Bahnabweichung (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_displacement</name>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
</context>
<context>
    <name>analysis.metric_duration</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>analysis.metric_gate_time</name>
    <message>
        <source>Start to finish</source>
        <translation>Start bis Ziel</translation>
    </message>
</context>
<context>
    <name>analysis.metric_gates_passed</name>
    <message>
        <source>Gates passed</source>
        <translation>Passierte Tore</translation>
    </message>
</context>
<context>
    <name>analysis.metric_height</name>
    <message>
        <source>Robot&apos;s height</source>
        <translation>Höhe des Roboters</translation>
    </message>
</context>
<context>
    <name>analysis.metric_laps</name>
    <message>
        <source>Laps</source>
        <translation>Runden</translation>
    </message>
</context>
<context>
    <name>analysis.metric_limit_breaches</name>
    <message>
        <source>Limits broken</source>
        <translation>Grenzwerte verletzt</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_accel</name>
    <message>
        <source>Top acceleration</source>
        <translation>Max. Beschleunigung</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_speed</name>
    <message>
        <source>Top speed</source>
        <translation>Höchstgeschw.</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_turn_rate</name>
    <message>
        <source>Fastest turn</source>
        <translation>Schnellste Drehung</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_lap</name>
    <message>
        <source>Mean lap</source>
        <translation>Mittlere Runde</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_speed</name>
    <message>
        <source>Mean speed</source>
        <translation>Mittlere Geschw.</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_view_disagreement</name>
    <message>
        <source>Views disagree by</source>
        <translation>Abweichung der Sichten</translation>
    </message>
</context>
<context>
    <name>analysis.metric_median_speed</name>
    <message>
        <source>Median speed</source>
        <translation>Mittlere Geschw. (Median)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_moving_time</name>
    <message>
        <source>Time in motion</source>
        <translation>Zeit in Bewegung</translation>
    </message>
</context>
<context>
    <name>analysis.metric_p95_accel</name>
    <message>
        <source>P95 acceleration</source>
        <translation>Beschleunigung (P95)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_p95_speed</name>
    <message>
        <source>P95 speed</source>
        <translation>Geschwindigkeit (P95)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_path_completed</name>
    <message>
        <source>Path completed</source>
        <translation>Bahn geschafft</translation>
    </message>
</context>
<context>
    <name>analysis.metric_path_length</name>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
</context>
<context>
    <name>analysis.metric_rms_accel</name>
    <message>
        <source>Acceleration (RMS)</source>
        <translation>Beschleunigung (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_rms_speed</name>
    <message>
        <source>Speed (RMS)</source>
        <translation>Geschw. (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_score</name>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
</context>
<context>
    <name>analysis.metric_spikes</name>
    <message>
        <source>Spikes</source>
        <translation>Ausreißer</translation>
    </message>
</context>
<context>
    <name>analysis.metric_standing_time</name>
    <message>
        <source>Standing time</source>
        <translation>Standzeit</translation>
    </message>
</context>
<context>
    <name>analysis.metric_stops</name>
    <message>
        <source>Stops</source>
        <translation>Stopps</translation>
    </message>
</context>
<context>
    <name>analysis.metric_straightness</name>
    <message>
        <source>Straightness</source>
        <translation>Geradlinigkeit</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_breaches</name>
    <message>
        <source>Zones broken</source>
        <translation>Zonen verletzt</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_depth</name>
    <message>
        <source>Beyond zones (most)</source>
        <translation>Zonen verletzt (max.)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_time</name>
    <message>
        <source>Time beyond zones</source>
        <translation>Zonen verletzt (Zeit)</translation>
    </message>
</context>
<context>
    <name>analysis.moment_outside</name>
    <message>
        <source>the moment entered for %1 is outside that run</source>
        <translation>der für %1 genannte Zeitpunkt liegt außerhalb</translation>
    </message>
</context>
<context>
    <name>analysis.moments_missing</name>
    <message>
        <source>aligning runs by hand needs a moment in each run</source>
        <translation>zum Ausrichten von Hand wird von jeder Fahrt ein Zeitpunkt gebraucht</translation>
    </message>
</context>
<context>
    <name>analysis.motion_gives_no_offset</name>
    <message>
        <source>the robot never changes its speed or its curvature by more than noise, so any time offset fits</source>
        <translation>der Roboter ändert weder Geschwindigkeit noch Krümmung um mehr als das Rauschen, daher passt jeder Zeitversatz</translation>
    </message>
</context>
<context>
    <name>analysis.name_each_gate</name>
    <message>
        <source>give each gate a name of its own</source>
        <translation>geben Sie jedem Tor einen eigenen Namen</translation>
    </message>
</context>
<context>
    <name>analysis.name_each_zone</name>
    <message>
        <source>give each zone a name of its own</source>
        <translation>geben Sie jeder Zone einen eigenen Namen</translation>
    </message>
</context>
<context>
    <name>analysis.name_twice</name>
    <message>
        <source>the name is used twice</source>
        <translation>den Namen gibt es zweimal</translation>
    </message>
</context>
<context>
    <name>analysis.no_figure</name>
    <message>
        <source>it names no metric</source>
        <translation>sie nennt keinen Kennwert</translation>
    </message>
</context>
<context>
    <name>analysis.no_motion</name>
    <message>
        <source>the robot does not move in %1</source>
        <translation>in %1 bewegt sich der Roboter nicht</translation>
    </message>
</context>
<context>
    <name>analysis.no_onset</name>
    <message>
        <source>the robot of %1 is already moving when it is first seen</source>
        <translation>der Roboter von %1 fährt schon, wenn er zum ersten Mal zu sehen ist</translation>
    </message>
</context>
<context>
    <name>analysis.no_start_gate</name>
    <message>
        <source>%1 does not pass a start gate</source>
        <translation>%1 fährt durch kein Starttor</translation>
    </message>
</context>
<context>
    <name>analysis.no_step_of_delta</name>
    <message>
        <source>no stretch of %1 was measured without a gap, so there is no relative error</source>
        <translation>keine Strecke von %1 wurde ohne Lücke gemessen, daher gibt es keinen relativen Fehler</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_role</name>
    <message>
        <source>gates have no such role</source>
        <translation>diese Rolle gibt es nicht</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_rule</name>
    <message>
        <source>zones have no such rule</source>
        <translation>diese Regel einer Zone gibt es nicht</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_template</name>
    <message>
        <source>no template has this name</source>
        <translation>dieses Muster gibt es nicht</translation>
    </message>
</context>
<context>
    <name>analysis.not_on_tasks_path</name>
    <message>
        <source>%1 shares no part of its path with the task&apos;s path</source>
        <translation>%1 hat kein Stück Weg mit der Sollbahn gemeinsam</translation>
    </message>
</context>
<context>
    <name>analysis.not_seen_there</name>
    <message>
        <source>%1 was not seen at the position used for alignment</source>
        <translation>%1 war am Ort der Ausrichtung nicht zu sehen</translation>
    </message>
</context>
<context>
    <name>analysis.nothing_in_common</name>
    <message>
        <source>%1 shares no part of its path with %2</source>
        <translation>%1 hat kein Stück Weg mit %2 gemeinsam</translation>
    </message>
</context>
<context>
    <name>analysis.number_is_none</name>
    <message>
        <source>one of its values is not a number</source>
        <translation>eine Zahl darin ist keine</translation>
    </message>
</context>
<context>
    <name>analysis.offset_is_ambiguous</name>
    <message>
        <source>its motion repeats itself: time offsets %1 apart agree equally well</source>
        <translation>seine Bewegung wiederholt sich: Um %1 verschiedene Zeitversätze passen gleich gut</translation>
    </message>
</context>
<context>
    <name>analysis.offset_is_uncertain</name>
    <message>
        <source>its time offset is known only to ±%1</source>
        <translation>sein Zeitversatz ist nur auf ±%1 bekannt</translation>
    </message>
</context>
<context>
    <name>analysis.offset_not_found</name>
    <message>
        <source>too little of its motion is also in the run to find the time offset</source>
        <translation>zu wenig seiner Bewegung kommt auch in der Fahrt vor, um den Zeitversatz zu bestimmen</translation>
    </message>
</context>
<context>
    <name>analysis.one_point_too_few</name>
    <message>
        <source>%1 point is too few for it</source>
        <translation>%1 Punkt ist dafür zu wenig</translation>
    </message>
</context>
<context>
    <name>analysis.one_start_and_finish</name>
    <message>
        <source>keep one start and one finish, or one gate with the role start_finish</source>
        <translation>behalten Sie einen Start und ein Ziel, oder ein Tor, das beides ist</translation>
    </message>
</context>
<context>
    <name>analysis.other_direction</name>
    <message>
        <source>%1 runs in the opposite direction to %2</source>
        <translation>%1 fährt den Weg in anderer Richtung als %2</translation>
    </message>
</context>
<context>
    <name>analysis.outline_crosses</name>
    <message>
        <source>its outline crosses itself</source>
        <translation>ihr Umriss kreuzt sich selbst</translation>
    </message>
</context>
<context>
    <name>analysis.path_too_short</name>
    <message>
        <source>it is shorter than 1 mm</source>
        <translation>kürzer als 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.place_no_number</name>
    <message>
        <source>its position is not a number</source>
        <translation>der Ort ist keine Zahl</translation>
    </message>
</context>
<context>
    <name>analysis.points_off_floor</name>
    <message>
        <source>its points are not all on a floor of 1 km</source>
        <translation>die Punkte liegen nicht auf einem Boden von 1 km</translation>
    </message>
</context>
<context>
    <name>analysis.points_out_of_range</name>
    <message>
        <source>its points are 0 or beyond ±1000</source>
        <translation>ihre Punkte sind 0 oder jenseits von 1000</translation>
    </message>
</context>
<context>
    <name>analysis.points_too_few</name>
    <message>
        <source>%1 points are too few for it</source>
        <translation>%1 Punkte sind dafür zu wenig</translation>
    </message>
</context>
<context>
    <name>analysis.reference_path</name>
    <message>
        <source>reference path</source>
        <translation>Sollbahn</translation>
    </message>
</context>
<context>
    <name>analysis.role</name>
    <message>
        <source>role &apos;%1&apos;</source>
        <translation>Rolle &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.rule</name>
    <message>
        <source>rule &apos;%1&apos;</source>
        <translation>Regel &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.same_values</name>
    <message>
        <source>full points and no points have the same value</source>
        <translation>alle Punkte und keine Punkte liegen beim selben Wert</translation>
    </message>
</context>
<context>
    <name>analysis.sample_coarsely</name>
    <message>
        <source>sample it with fewer points</source>
        <translation>tasten Sie sie gröber ab</translation>
    </message>
</context>
<context>
    <name>analysis.scoring</name>
    <message>
        <source>scoring</source>
        <translation>Wertung</translation>
    </message>
</context>
<context>
    <name>analysis.size_too_small</name>
    <message>
        <source>a size is less than 1 mm</source>
        <translation>eine Größe ist kleiner als 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.start_is_there</name>
    <message>
        <source>gate &apos;%1&apos; is already the start</source>
        <translation>Tor &apos;%1&apos; ist schon der Start</translation>
    </message>
</context>
<context>
    <name>analysis.still_in_common_time</name>
    <message>
        <source>the robot does not move in the common time</source>
        <translation>der Roboter bewegt sich in der gemeinsamen Zeit nicht</translation>
    </message>
</context>
<context>
    <name>analysis.takes_two_runs</name>
    <message>
        <source>it needs two runs</source>
        <translation>es braucht zwei Fahrten</translation>
    </message>
</context>
<context>
    <name>analysis.tell_moment_inside</name>
    <message>
        <source>enter one between its first and last frame</source>
        <translation>nennen Sie einen zwischen dem ersten und dem letzten Bild</translation>
    </message>
</context>
<context>
    <name>analysis.tell_moments</name>
    <message>
        <source>enter one for each run</source>
        <translation>nennen Sie für jede einen</translation>
    </message>
</context>
<context>
    <name>analysis.template</name>
    <message>
        <source>template &apos;%1&apos;</source>
        <translation>Muster &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.template_of_task</name>
    <message>
        <source>template of a task</source>
        <translation>Muster einer Aufgabe</translation>
    </message>
</context>
<context>
    <name>analysis.turn_sign</name>
    <message>
        <source>change the sign of one of its coordinates</source>
        <translation>kehren Sie das Vorzeichen einer seiner Koordinaten um</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_best_lap</name>
    <message>
        <source>of its two passages; the calibration uncertainty of a gate passed twice cancels</source>
        <translation>ihrer beiden Durchfahrten; der Fehler der Kalibrierung hebt sich an einem zweimal passierten Tor weg</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_circle_radius</name>
    <message>
        <source>of the scatter of the distances, with their number divided by 1 + 2Σρ for correlated neighbours, and the calibration&apos;s scale uncertainty</source>
        <translation>der Streuung der Abstände, Nachbarn um den Faktor 1 + 2Σρ weniger gezählt, und der Maßstabsfehler der Kalibrierung</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_correlated</name>
    <message>
        <source>the bound for fully correlated errors, and the calibration&apos;s scale uncertainty</source>
        <translation>die Obergrenze für Fehler, die alle in dieselbe Richtung gehen, und der Maßstabsfehler der Kalibrierung</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_bias</name>
    <message>
        <source>of the position across the path, mostly the calibration&apos;s</source>
        <translation>des Orts quer zur Bahn, vor allem der Anteil der Kalibrierung</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_max</name>
    <message>
        <source>of the position across the path, there</source>
        <translation>des Orts quer zur Bahn, dort</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_mean</name>
    <message>
        <source>of the position across the path, and of its noise: the distance has no sign, so noise does not cancel</source>
        <translation>des Orts quer zur Bahn, und seines Rauschens, das dort kein Vorzeichen hat</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_rms</name>
    <message>
        <source>of the position across the path</source>
        <translation>des Orts quer zur Bahn</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_duration</name>
    <message>
        <source>of both moments: σ of the speed divided by its slope there, and how far smoothing blurs them</source>
        <translation>beider Zeitpunkte: σ der Geschwindigkeit geteilt durch ihre Steilheit dort, und wie weit die Glättung sie verwischt</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_gate_time</name>
    <message>
        <source>of both passages: σ of the position across the gate divided by the speed</source>
        <translation>beider Durchfahrten: σ des Orts quer zum Tor geteilt durch die Geschwindigkeit</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_max_turn_rate</name>
    <message>
        <source>of the body: that of the smoothed heading&apos;s rate; of the direction of motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order</source>
        <translation>des Rumpfs: die der Rate der geglätteten Ausrichtung; der Bewegungsrichtung: σ² = σa²/|v|² + |a|²σv²/|v|⁴, erste Ordnung</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_mean_lap</name>
    <message>
        <source>of the first and the last passage, over the number of laps</source>
        <translation>der ersten und der letzten Durchfahrt, geteilt durch die Zahl der Runden</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_mean_speed</name>
    <message>
        <source>of both, treated as independent, and of gaps: from straight through them to the top speed in them</source>
        <translation>beider, als unabhängig angenommen, und der Lücken: von geradeaus hindurch bis zur Höchstgeschwindigkeit darin</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_moving_time</name>
    <message>
        <source>of each start and stop: σ of the speed divided by its slope</source>
        <translation>jedes Anfahrens und Anhaltens: σ der Geschwindigkeit geteilt durch ihre Steilheit</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_of_curve</name>
    <message>
        <source>that of the smoothed curve there, and the calibration&apos;s scale uncertainty</source>
        <translation>das der geglätteten Kurve dort, und der Maßstabsfehler der Kalibrierung</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_of_intervals</name>
    <message>
        <source>of the intervals within 1.5 σ of it, each by its mean</source>
        <translation>der Abschnitte im Abstand von höchstens 1,5 σ davon, jeder mit seinem Mittel</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_path_length</name>
    <message>
        <source>of the end positions, of lateral errors where the path turns, of what the robot could have done where it was bridged, and the calibration&apos;s scale uncertainty</source>
        <translation>der Orte an den Enden, der Fehler quer zur Bahn, wo sie sich krümmt, dessen, was der Roboter in überbrückten Zeiten getan haben kann, und der Maßstabsfehler der Kalibrierung</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_standing_time</name>
    <message>
        <source>of each start and stop</source>
        <translation>jedes Anfahrens und Anhaltens</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_straightness</name>
    <message>
        <source>of the end positions</source>
        <translation>der Orte an den Enden</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_zone_depth</name>
    <message>
        <source>of the position across the edge, there</source>
        <translation>des Orts quer zum Rand, dort</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_zone_time</name>
    <message>
        <source>of each crossing of an edge: σ of the position across it divided by the speed; and the change of the time when the calibration uncertainty shifts the track</source>
        <translation>jedes Zeitpunkts an einem Rand: σ des Orts quer dazu geteilt durch die Geschwindigkeit; und um wie viel die Zeit sich ändert, wenn die Kalibrierung die Spur näher oder weiter setzt</translation>
    </message>
</context>
<context>
    <name>analysis.use_a_rule</name>
    <message>
        <source>use stay_inside or stay_outside</source>
        <translation>verwenden Sie stay_inside oder stay_outside</translation>
    </message>
</context>
<context>
    <name>analysis.use_one_of</name>
    <message>
        <source>use %1</source>
        <translation>verwenden Sie %1</translation>
    </message>
</context>
<context>
    <name>analysis.wrong_poles</name>
    <message>
        <source>a slalom has 1 to 100 poles, not %1</source>
        <translation>ein Slalom hat 1 bis 100 Stangen, nicht %1</translation>
    </message>
</context>
<context>
    <name>analysis.zone</name>
    <message>
        <source>zone &apos;%1&apos;</source>
        <translation>Zone &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>backup.disk_nearly_full</name>
    <message>
        <source>the disk has only %1 left</source>
        <translation>auf dem Datenträger sind nur noch %1 frei</translation>
    </message>
</context>
<context>
    <name>backup.of_project</name>
    <message>
        <source>backup of &apos;%1&apos;</source>
        <translation>Sicherungskopie von „%1“</translation>
    </message>
</context>
<context>
    <name>base.and</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
</context>
<context>
    <name>base.camera</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>Kamera &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.cancelled</name>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
</context>
<context>
    <name>base.cannot_do_this</name>
    <message>
        <source>cannot do this</source>
        <translation>das geht jetzt nicht</translation>
    </message>
</context>
<context>
    <name>base.class</name>
    <message>
        <source>class &apos;%1&apos;</source>
        <translation>Klasse &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.close_other_programs</name>
    <message>
        <source>close other programs and try again</source>
        <translation>schließen Sie andere Programme und versuchen Sie es noch einmal</translation>
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
        <translation>Farbe &apos;%1&apos;</translation>
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
        <translation>Datei &apos;%1&apos;</translation>
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
        <translation>es ist ein Gerät</translation>
    </message>
</context>
<context>
    <name>base.is_folder</name>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
</context>
<context>
    <name>base.is_pipe</name>
    <message>
        <source>it is a named pipe</source>
        <translation>es ist eine benannte Pipe</translation>
    </message>
</context>
<context>
    <name>base.is_socket</name>
    <message>
        <source>it is a socket</source>
        <translation>es ist ein Socket</translation>
    </message>
</context>
<context>
    <name>base.layout</name>
    <message>
        <source>layout &apos;%1&apos;</source>
        <translation>Plan &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.length</name>
    <message>
        <source>length &apos;%1&apos;</source>
        <translation>Länge &apos;%1&apos;</translation>
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
        <translation>nicht von der Form #rrggbb</translation>
    </message>
</context>
<context>
    <name>base.no_files</name>
    <message>
        <source>too many files are open</source>
        <translation>zu viele Dateien sind geöffnet</translation>
    </message>
</context>
<context>
    <name>base.no_length</name>
    <message>
        <source>not a number with the unit mm, cm or m</source>
        <translation>keine Zahl mit der Einheit mm, cm oder m</translation>
    </message>
</context>
<context>
    <name>base.no_memory</name>
    <message>
        <source>this computer does not have enough free memory for it</source>
        <translation>dieser Rechner hat dafür nicht genug freien Arbeitsspeicher</translation>
    </message>
</context>
<context>
    <name>base.no_number</name>
    <message>
        <source>not a finite decimal number</source>
        <translation>keine endliche Dezimalzahl</translation>
    </message>
</context>
<context>
    <name>base.no_thread</name>
    <message>
        <source>this computer cannot start another thread</source>
        <translation>dieser Rechner gibt keinen weiteren Thread her</translation>
    </message>
</context>
<context>
    <name>base.none</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>base.nothing_changed</name>
    <message>
        <source>nothing was changed</source>
        <translation>nichts wurde geändert</translation>
    </message>
</context>
<context>
    <name>base.number</name>
    <message>
        <source>number &apos;%1&apos;</source>
        <translation>Zahl &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.or</name>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
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
        <translation>Roboter &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.robot_in_trial</name>
    <message>
        <source>robot &apos;%1&apos; in trial &apos;%2&apos;</source>
        <translation>Roboter &apos;%1&apos; im Versuch &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>base.saved_is_safe</name>
    <message>
        <source>what was saved is safe</source>
        <translation>was gespeichert war, ist sicher</translation>
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
        <translation>Aufgabe &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.team</name>
    <message>
        <source>team &apos;%1&apos;</source>
        <translation>Team &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.trial</name>
    <message>
        <source>trial &apos;%1&apos;</source>
        <translation>Versuch &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.try_again_and_report</name>
    <message>
        <source>try again, and report it if it happens again</source>
        <translation>versuchen Sie es noch einmal, und melden Sie es, wenn es wieder geschieht</translation>
    </message>
</context>
<context>
    <name>base.unexpected</name>
    <message>
        <source>something unexpected happened (%1)</source>
        <translation>etwas Unerwartetes ist geschehen (%1)</translation>
    </message>
</context>
<context>
    <name>base.view_in_trial</name>
    <message>
        <source>view &apos;%1&apos; in trial &apos;%2&apos;</source>
        <translation>Sicht &apos;%1&apos; im Versuch &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>base.wordless_exception</name>
    <message>
        <source>an unknown exception</source>
        <translation>eine Ausnahme ohne Worte</translation>
    </message>
</context>
<context>
    <name>base.write_colour</name>
    <message>
        <source>write it like #d72328</source>
        <translation>schreiben Sie etwa #d72328</translation>
    </message>
</context>
<context>
    <name>base.write_length</name>
    <message>
        <source>write it like 25mm, 2.5cm or 0.3m</source>
        <translation>schreiben Sie etwa 25mm, 2.5cm oder 0.3m</translation>
    </message>
</context>
<context>
    <name>base.write_number</name>
    <message>
        <source>write it with digits and a point, like 12.5</source>
        <translation>schreiben Sie sie mit Ziffern und Punkt, etwa 12.5</translation>
    </message>
</context>
<context>
    <name>calibration.add_floor_points</name>
    <message>
        <source>add floor points, such as corners of tiles</source>
        <translation>fügen Sie Punkte des Bodens hinzu, etwa Ecken von Fliesen</translation>
    </message>
</context>
<context>
    <name>calibration.all_agree</name>
    <message>
        <source>The markers and the cameras agree with each other.</source>
        <translation>Die Marker und die Kameras stimmen überein.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_changed</name>
    <message>
        <source>The world axes were changed afterwards.</source>
        <translation>Die Achsen der Welt wurden nachher geändert.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_changed_and_scaled</name>
    <message>
        <source>The world axes were changed afterwards, and all lengths multiplied by %1.</source>
        <translation>Die Achsen der Welt wurden nachher geändert, und alle Längen mit %1 multipliziert.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_no_number</name>
    <message>
        <source>the origin or the angle is not a finite number</source>
        <translation>der Ursprung oder der Winkel ist keine endliche Zahl</translation>
    </message>
</context>
<context>
    <name>calibration.axes_not_changed</name>
    <message>
        <source>the axes of layout &apos;%1&apos; cannot be changed</source>
        <translation>die Achsen des Plans &apos;%1&apos; können nicht geändert werden</translation>
    </message>
</context>
<context>
    <name>calibration.best_place</name>
    <message>
        <source>the best camera position</source>
        <translation>der beste Ort für eine Kamera</translation>
    </message>
</context>
<context>
    <name>calibration.board_blurred</name>
    <message>
        <source>the board is blurred</source>
        <translation>die Tafel ist unscharf</translation>
    </message>
</context>
<context>
    <name>calibration.board_cut_off</name>
    <message>
        <source>the board is cut off</source>
        <translation>die Tafel ist abgeschnitten</translation>
    </message>
</context>
<context>
    <name>calibration.board_fills</name>
    <message>
        <source>it fills %1 of the image</source>
        <translation>sie füllt %1 des Bilds</translation>
    </message>
</context>
<context>
    <name>calibration.board_in_one_place</name>
    <message>
        <source>all %1 images show the board in one position, the %2 %3 of the image</source>
        <translation>alle %1 Bilder zeigen die Tafel an einer Stelle (%2, %3 des Bildes)</translation>
    </message>
</context>
<context>
    <name>calibration.board_not_flat</name>
    <message>
        <source>the corners do not match a flat board</source>
        <translation>die Ecken liegen nicht wie auf einer flachen Tafel</translation>
    </message>
</context>
<context>
    <name>calibration.board_not_sharp</name>
    <message>
        <source>the board is not sharp</source>
        <translation>die Tafel ist nicht scharf</translation>
    </message>
</context>
<context>
    <name>calibration.board_of_other_size</name>
    <message>
        <source>this board has %1 inner corners, not %2</source>
        <translation>diese Tafel hat %1 innere Ecken, verlangt war %2</translation>
    </message>
</context>
<context>
    <name>calibration.board_part_seen</name>
    <message>
        <source>only %1 of its %2 inner corners are visible</source>
        <translation>nur %1 ihrer %2 inneren Ecken sind zu sehen</translation>
    </message>
</context>
<context>
    <name>calibration.board_stands_as_before</name>
    <message>
        <source>the board is in the same position as in an earlier image</source>
        <translation>die Tafel steht wie in einem schon aufgenommenen Bild</translation>
    </message>
</context>
<context>
    <name>calibration.board_stands_as_in</name>
    <message>
        <source>the board is in the same position as in %1</source>
        <translation>die Tafel steht wie schon in %1</translation>
    </message>
</context>
<context>
    <name>calibration.board_too_oblique</name>
    <message>
        <source>the board is tilted too far, by %1 degrees</source>
        <translation>die Tafel ist zu schräg zu sehen, unter %1 Grad</translation>
    </message>
</context>
<context>
    <name>calibration.board_too_small</name>
    <message>
        <source>the board is too small</source>
        <translation>die Tafel ist zu klein</translation>
    </message>
</context>
<context>
    <name>calibration.calibrate_to_rely</name>
    <message>
        <source>Calibrate it for reliable positions.</source>
        <translation>Kalibrieren Sie sie, um verlässliche Orte zu bekommen.</translation>
    </message>
</context>
<context>
    <name>calibration.camera_alone_says</name>
    <message>
        <source>Camera &apos;%1&apos; alone measures %2</source>
        <translation>Kamera &apos;%1&apos; allein sagt %2</translation>
    </message>
</context>
<context>
    <name>calibration.camera_below_floor</name>
    <message>
        <source>in this order the camera would be below the floor</source>
        <translation>in dieser Reihenfolge wäre die Kamera unter dem Boden</translation>
    </message>
</context>
<context>
    <name>calibration.camera_moved</name>
    <message>
        <source>%1 has moved %2 = %3</source>
        <translation>%1 hat sich um %2 = %3 bewegt</translation>
    </message>
</context>
<context>
    <name>calibration.camera_sees_elsewhere</name>
    <message>
        <source>%1 sees %2 %3 from where the others see it</source>
        <translation>%1 sieht %2 um %3 neben der Stelle, an der die anderen ihn sehen</translation>
    </message>
</context>
<context>
    <name>calibration.camera_sees_too_few</name>
    <message>
        <source>camera &apos;%1&apos; sees only %2 of the markers</source>
        <translation>Kamera &apos;%1&apos; sieht nur %2 der Marker</translation>
    </message>
</context>
<context>
    <name>calibration.camera_stands_low</name>
    <message>
        <source>The camera would be only %1 above the floor</source>
        <translation>Die Kamera stünde nur %1 über dem Boden</translation>
    </message>
</context>
<context>
    <name>calibration.camera_still</name>
    <message>
        <source>%1 has not moved</source>
        <translation>%1 steht, wo sie eingemessen wurde</translation>
    </message>
</context>
<context>
    <name>calibration.camera_too_high</name>
    <message>
        <source>the camera would be %1 above the floor</source>
        <translation>die Kamera stünde %1 über dem Boden</translation>
    </message>
</context>
<context>
    <name>calibration.camera_too_low</name>
    <message>
        <source>the camera would be only %1 above the floor</source>
        <translation>die Kamera stünde nur %1 über dem Boden</translation>
    </message>
</context>
<context>
    <name>calibration.camera_twice</name>
    <message>
        <source>camera &apos;%1&apos; appears twice</source>
        <translation>Kamera &apos;%1&apos; gibt es zweimal</translation>
    </message>
</context>
<context>
    <name>calibration.camera_upside_down</name>
    <message>
        <source>The camera would be upside down</source>
        <translation>Die Kamera wäre kopfüber</translation>
    </message>
</context>
<context>
    <name>calibration.cameras_of_one_image</name>
    <message>
        <source>%1 and %2 have the same pixels and count as one camera.</source>
        <translation>%1 und %2 haben dieselben Pixel und zählen als eine Kamera.</translation>
    </message>
</context>
<context>
    <name>calibration.cameras_undetermined</name>
    <message>
        <source>the markers do not determine the camera positions</source>
        <translation>die Marker bestimmen nicht, wo die Kameras stehen</translation>
    </message>
</context>
<context>
    <name>calibration.cannot_be_calibrated</name>
    <message>
        <source>the camera cannot be calibrated</source>
        <translation>die Kamera kann nicht kalibriert werden</translation>
    </message>
</context>
<context>
    <name>calibration.centimetres</name>
    <message>
        <source>centimetres</source>
        <translation>Zentimetern</translation>
    </message>
</context>
<context>
    <name>calibration.centre_is_off</name>
    <message>
        <source>The optical centre is %1 off the image&apos;s middle</source>
        <translation>Die optische Mitte liegt %1 neben der Bildmitte</translation>
    </message>
</context>
<context>
    <name>calibration.check_all</name>
    <message>
        <source>check the layout, the labels and the intrinsics</source>
        <translation>prüfen Sie den Plan, die Bezeichnungen und die Objektivdaten</translation>
    </message>
</context>
<context>
    <name>calibration.check_both_lenses</name>
    <message>
        <source>check its pixels and the intrinsics of both cameras</source>
        <translation>prüfen Sie seine Pixel und die Objektivdaten beider Kameras</translation>
    </message>
</context>
<context>
    <name>calibration.check_both_pixels</name>
    <message>
        <source>check its pixels in both images</source>
        <translation>prüfen Sie seine Pixel in beiden Bildern</translation>
    </message>
</context>
<context>
    <name>calibration.check_columns</name>
    <message>
        <source>check which columns belong to which camera</source>
        <translation>prüfen Sie, welche Spalten zu welcher Kamera gehören</translation>
    </message>
</context>
<context>
    <name>calibration.check_first_registration</name>
    <message>
        <source>check the registration of %1 and the pair</source>
        <translation>prüfen Sie die Einmessung von %1 und das Kamerapaar</translation>
    </message>
</context>
<context>
    <name>calibration.check_labels</name>
    <message>
        <source>check these labels</source>
        <translation>prüfen Sie diese Bezeichnungen</translation>
    </message>
</context>
<context>
    <name>calibration.check_layout_places</name>
    <message>
        <source>check the layout&apos;s positions and their unit, cover other round objects, or mark the markers by hand</source>
        <translation>prüfen Sie die Orte des Plans und ihre Einheit, verdecken Sie andere runde Dinge, oder markieren Sie die Marker von Hand</translation>
    </message>
</context>
<context>
    <name>calibration.check_length</name>
    <message>
        <source>Check the length itself, that it is on the floor, and the marker positions.</source>
        <translation>Prüfen Sie die Länge selbst, ob sie auf dem Boden liegt, und die Plätze der Marker.</translation>
    </message>
</context>
<context>
    <name>calibration.check_one_camera</name>
    <message>
        <source>check that all are of one camera, at one zoom and focus</source>
        <translation>prüfen Sie, ob alle von einer Kamera mit einem Zoom und Fokus sind</translation>
    </message>
</context>
<context>
    <name>calibration.check_pictures</name>
    <message>
        <source>check that all images are sharp, of one flat board and of one camera at one zoom and focus</source>
        <translation>prüfen Sie, ob alle Bilder scharf sind, von einer flachen Tafel und von einer Kamera mit einem Zoom und Fokus</translation>
    </message>
</context>
<context>
    <name>calibration.check_pixel_and_lens</name>
    <message>
        <source>check its pixel and the camera&apos;s intrinsics</source>
        <translation>prüfen Sie das Pixel und die Objektivdaten der Kamera</translation>
    </message>
</context>
<context>
    <name>calibration.check_place_and_pixel</name>
    <message>
        <source>check its position and its pixel</source>
        <translation>prüfen Sie seinen Platz und sein Pixel</translation>
    </message>
</context>
<context>
    <name>calibration.check_point_labels</name>
    <message>
        <source>check which label belongs to which point in %1 and in this camera</source>
        <translation>prüfen Sie, welche Bezeichnung in %1 und in dieser Kamera zu welchem Punkt gehört</translation>
    </message>
</context>
<context>
    <name>calibration.check_signs</name>
    <message>
        <source>check the signs of the layout</source>
        <translation>prüfen Sie die Vorzeichen des Plans</translation>
    </message>
</context>
<context>
    <name>calibration.check_tag_places</name>
    <message>
        <source>check the layout&apos;s positions and their unit, or mark the markers by hand</source>
        <translation>prüfen Sie die Positionen des Plans und ihre Einheit, oder markieren Sie die Marker von Hand</translation>
    </message>
</context>
<context>
    <name>calibration.check_unit</name>
    <message>
        <source>check the unit of the layout</source>
        <translation>prüfen Sie die Einheit des Plans</translation>
    </message>
</context>
<context>
    <name>calibration.checking_halves</name>
    <message>
        <source>checking the halves against each other</source>
        <translation>die Hälften werden gegeneinander geprüft</translation>
    </message>
</context>
<context>
    <name>calibration.choose_floor_points</name>
    <message>
        <source>choose points on the floor</source>
        <translation>wählen Sie Punkte des Bodens</translation>
    </message>
</context>
<context>
    <name>calibration.choose_others</name>
    <message>
        <source>choose others</source>
        <translation>wählen Sie andere</translation>
    </message>
</context>
<context>
    <name>calibration.clear_view</name>
    <message>
        <source>clear the view of the markers</source>
        <translation>machen Sie die Sicht auf die Marker frei</translation>
    </message>
</context>
<context>
    <name>calibration.common_and_unknown_markers</name>
    <message>
        <source>they have %1 (%2), and the layout does not contain %3</source>
        <translation>es gibt %1 (%2), und der Plan kennt %3 nicht</translation>
    </message>
</context>
<context>
    <name>calibration.common_markers</name>
    <message>
        <source>they have %1 (%2)</source>
        <translation>es gibt %1 (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.convert_unit</name>
    <message>
        <source>convert its unit.</source>
        <translation>rechnen Sie seine Einheit um.</translation>
    </message>
</context>
<context>
    <name>calibration.corner_left_out</name>
    <message>
        <source>1 outlier corner was left out, in %1.</source>
        <translation>1 herausfallende Ecke wurde weggelassen, in %1.</translation>
    </message>
</context>
<context>
    <name>calibration.corner_no_number</name>
    <message>
        <source>a corner of it is not a number</source>
        <translation>eine Ecke darin ist keine Zahl</translation>
    </message>
</context>
<context>
    <name>calibration.corner_of_many_tags</name>
    <message>
        <source>a corner is that of one tag</source>
        <translation>eine Ecke gehört zu einem einzigen Tag</translation>
    </message>
</context>
<context>
    <name>calibration.corner_unclear</name>
    <message>
        <source>one corner of the board is unclear</source>
        <translation>eine Ecke der Tafel ist nicht zu erkennen</translation>
    </message>
</context>
<context>
    <name>calibration.corners_disagree</name>
    <message>
        <source>%1 of the corners do not agree with the others</source>
        <translation>%1 der Ecken passen nicht zu den anderen</translation>
    </message>
</context>
<context>
    <name>calibration.corners_kept_in</name>
    <message>
        <source>%1 neighbouring outlier corners were kept, in %2</source>
        <translation>%1 nebeneinander herausfallende Ecken wurden behalten, in %2</translation>
    </message>
</context>
<context>
    <name>calibration.corners_kept_most_in</name>
    <message>
        <source>%1 neighbouring outlier corners were kept, most in %2</source>
        <translation>%1 nebeneinander herausfallende Ecken wurden behalten, die meisten in %2</translation>
    </message>
</context>
<context>
    <name>calibration.corners_left_out_in</name>
    <message>
        <source>%1 outlier corners were left out, in %2.</source>
        <translation>%1 herausfallende Ecken wurden weggelassen, in %2.</translation>
    </message>
</context>
<context>
    <name>calibration.corners_left_out_most_in</name>
    <message>
        <source>%1 outlier corners were left out, most in %2.</source>
        <translation>%1 herausfallende Ecken wurden weggelassen, die meisten in %2.</translation>
    </message>
</context>
<context>
    <name>calibration.corners_not_flat</name>
    <message>
        <source>its corners do not match a flat board</source>
        <translation>die Ecken liegen nicht wie auf einer flachen Tafel</translation>
    </message>
</context>
<context>
    <name>calibration.corners_nowhere_near</name>
    <message>
        <source>its corners are %1 from where the other images predict them, theirs %2</source>
        <translation>seine Ecken liegen %1 neben der Vorhersage der anderen Bilder, deren eigene %2</translation>
    </message>
</context>
<context>
    <name>calibration.correct_layout</name>
    <message>
        <source>correct the layout</source>
        <translation>berichtigen Sie den Plan</translation>
    </message>
</context>
<context>
    <name>calibration.correct_pixels</name>
    <message>
        <source>correct the pixels</source>
        <translation>berichtigen Sie die Pixel</translation>
    </message>
</context>
<context>
    <name>calibration.count_corners</name>
    <message>
        <source>count the inner corners, or leave the size out</source>
        <translation>zählen Sie die inneren Ecken, oder lassen Sie die Größe weg</translation>
    </message>
</context>
<context>
    <name>calibration.disagree_in</name>
    <message>
        <source>%1 of the corners disagree, in %2</source>
        <translation>%1 der Ecken widersprechen sich, in %2</translation>
    </message>
</context>
<context>
    <name>calibration.disagree_most_in</name>
    <message>
        <source>%1 of the corners disagree, most in %2</source>
        <translation>%1 der Ecken widersprechen sich, die meisten in %2</translation>
    </message>
</context>
<context>
    <name>calibration.done</name>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
</context>
<context>
    <name>calibration.edges_wide</name>
    <message>
        <source>its edges are %1 pixels wide</source>
        <translation>ihre Kanten sind %1 Pixel breit</translation>
    </message>
</context>
<context>
    <name>calibration.ends_on_one_pixel</name>
    <message>
        <source>both ends are on the same pixel of camera &apos;%1&apos;</source>
        <translation>beide Enden liegen auf einem Pixel der Kamera &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.far_edge</name>
    <message>
        <source>at the far edge</source>
        <translation>am hinteren Rand</translation>
    </message>
</context>
<context>
    <name>calibration.far_left_corner</name>
    <message>
        <source>in the far left corner</source>
        <translation>in der hinteren linken Ecke</translation>
    </message>
</context>
<context>
    <name>calibration.far_right_corner</name>
    <message>
        <source>in the far right corner</source>
        <translation>in der hinteren rechten Ecke</translation>
    </message>
</context>
<context>
    <name>calibration.few_corners_seen</name>
    <message>
        <source>only %1 corners of the board are visible</source>
        <translation>nur %1 Ecken der Tafel sind zu sehen</translation>
    </message>
</context>
<context>
    <name>calibration.fifth_would</name>
    <message>
        <source>add a fifth.</source>
        <translation>ein fünfter täte es.</translation>
    </message>
</context>
<context>
    <name>calibration.find_board_again</name>
    <message>
        <source>detect the board in it again</source>
        <translation>lassen Sie die Tafel darin neu suchen</translation>
    </message>
</context>
<context>
    <name>calibration.first_end_beyond</name>
    <message>
        <source>the first end is at or beyond the horizon of camera &apos;%1&apos;</source>
        <translation>das erste Ende liegt am oder hinter dem Horizont der Kamera &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.fisheye</name>
    <message>
        <source>fisheye</source>
        <translation>Fischauge</translation>
    </message>
</context>
<context>
    <name>calibration.fisheye_lens</name>
    <message>
        <source>Fisheye lens</source>
        <translation>Fischauge</translation>
    </message>
</context>
<context>
    <name>calibration.fit_only_to</name>
    <message>
        <source>the markers fit only to %1</source>
        <translation>die Marker passen nur auf %1</translation>
    </message>
</context>
<context>
    <name>calibration.fits_without</name>
    <message>
        <source>without %1 the others fit to %2: check its position and its pixel</source>
        <translation>ohne %1 passen die anderen auf %2: seine Position und sein Pixel prüfen</translation>
    </message>
</context>
<context>
    <name>calibration.fitting_lens</name>
    <message>
        <source>fitting the lens model to %1 images</source>
        <translation>das Objektiv wird an %1 Bilder angepasst</translation>
    </message>
</context>
<context>
    <name>calibration.flip_image</name>
    <message>
        <source>switch off mirroring in the camera or its program, or flip the file</source>
        <translation>Spiegelung in der Kamera oder ihrem Programm ausschalten oder die Datei spiegeln</translation>
    </message>
</context>
<context>
    <name>calibration.floor_may_be_mirrored</name>
    <message>
        <source>if it is not, v is counted from below, and the labels are mirrored.</source>
        <translation>wenn nicht, zählt v von unten und die Bezeichnungen sind gespiegelt.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_not_registered</name>
    <message>
        <source>the floor cannot be registered</source>
        <translation>der Boden kann nicht eingemessen werden</translation>
    </message>
</context>
<context>
    <name>calibration.floor_part_unseen</name>
    <message>
        <source>%1 of the floor between the markers is out of view.</source>
        <translation>%1 des Bodens zwischen den Markern sind nicht zu sehen.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_unseen</name>
    <message>
        <source>None of the floor between the markers is in view.</source>
        <translation>Vom Boden zwischen den Markern ist nichts zu sehen.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_unsure</name>
    <message>
        <source>the floor uncertainty between the points is too large, ±%1</source>
        <translation>der Boden zwischen den Punkten ist nur auf ±%1 bekannt</translation>
    </message>
</context>
<context>
    <name>calibration.focal_length_groups</name>
    <message>
        <source>%1 give about %2, %3 (such as %4) give about %5</source>
        <translation>%1 etwa %2, %3 (etwa %4) etwa %5</translation>
    </message>
</context>
<context>
    <name>calibration.focal_length_unsure</name>
    <message>
        <source>the images determine the focal length only to %1</source>
        <translation>die Bilder bestimmen die Brennweite nur auf %1</translation>
    </message>
</context>
<context>
    <name>calibration.focal_lengths_differ</name>
    <message>
        <source>The focal lengths across and down differ by %1</source>
        <translation>Die Brennweiten waagrecht und senkrecht unterscheiden sich um %1</translation>
    </message>
</context>
<context>
    <name>calibration.focus_or_light</name>
    <message>
        <source>focus the camera, or give more light</source>
        <translation>stellen Sie die Kamera scharf, oder sorgen Sie für mehr Licht</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_as_well</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model no better (%3)</source>
        <translation>es sagt zurückgehaltene Bilder auf %1 voraus, das Modell „%2“ nicht besser (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_better</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model only to %3</source>
        <translation>es sagt zurückgehaltene Bilder auf %1 voraus, das Modell „%2“ nur auf %3</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_by_chance</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model to %3; the difference may be chance</source>
        <translation>es sagt zurückgehaltene Bilder auf %1 voraus, das Modell „%2“ auf %3, was Zufall sein kann</translation>
    </message>
</context>
<context>
    <name>calibration.four_common_markers</name>
    <message>
        <source>the layout and the image must have four markers in common</source>
        <translation>vier Marker sind nötig, die Plan und Bild gemeinsam haben</translation>
    </message>
</context>
<context>
    <name>calibration.four_markers_unchecked</name>
    <message>
        <source>Four markers are too few to check each other</source>
        <translation>Vier Marker prüfen einander kaum</translation>
    </message>
</context>
<context>
    <name>calibration.four_points_unchecked</name>
    <message>
        <source>Four points are too few to check each other</source>
        <translation>Vier Punkte prüfen einander kaum</translation>
    </message>
</context>
<context>
    <name>calibration.four_shared_points</name>
    <message>
        <source>both cameras must see the same four points or more</source>
        <translation>vier Punkte sind nötig, die beide Kameras sehen</translation>
    </message>
</context>
<context>
    <name>calibration.give_board_size</name>
    <message>
        <source>give at least 3x3, such as 9x6, or leave the size out</source>
        <translation>geben Sie mindestens 3x3 an, etwa 9x6, oder lassen Sie die Größe weg</translation>
    </message>
</context>
<context>
    <name>calibration.give_distance</name>
    <message>
        <source>give a distance of 0 m to 1000 m</source>
        <translation>geben Sie einen Abstand von 0 m bis 1000 m an</translation>
    </message>
</context>
<context>
    <name>calibration.give_field_of_view</name>
    <message>
        <source>give 2° to 150°, and the image size</source>
        <translation>geben Sie 2° bis 150° an, und die Größe der Bilder</translation>
    </message>
</context>
<context>
    <name>calibration.give_height</name>
    <message>
        <source>give a height of 0.05 m to 100 m</source>
        <translation>geben Sie eine Höhe von 0,05 m bis 100 m an</translation>
    </message>
</context>
<context>
    <name>calibration.give_one_of_them</name>
    <message>
        <source>give one of them</source>
        <translation>geben Sie eins davon an</translation>
    </message>
</context>
<context>
    <name>calibration.give_plain_numbers</name>
    <message>
        <source>give plain numbers</source>
        <translation>geben Sie gewöhnliche Zahlen an</translation>
    </message>
</context>
<context>
    <name>calibration.give_positive_number</name>
    <message>
        <source>give a number above 0</source>
        <translation>geben Sie eine Zahl über 0 an</translation>
    </message>
</context>
<context>
    <name>calibration.give_square_size</name>
    <message>
        <source>give a size such as 25mm</source>
        <translation>geben Sie sie etwa als 25mm an</translation>
    </message>
</context>
<context>
    <name>calibration.give_tape_sigma</name>
    <message>
        <source>give about 2 mm</source>
        <translation>geben Sie etwa 2 mm an</translation>
    </message>
</context>
<context>
    <name>calibration.give_taped_length</name>
    <message>
        <source>enter the length measured with a tape</source>
        <translation>geben Sie die mit dem Maßband gemessene Länge an</translation>
    </message>
</context>
<context>
    <name>calibration.glue_board</name>
    <message>
        <source>glue the board onto something stiff</source>
        <translation>kleben Sie die Tafel auf etwas Steifes</translation>
    </message>
</context>
<context>
    <name>calibration.glue_board_flat</name>
    <message>
        <source>glue the board onto something stiff and flat</source>
        <translation>kleben Sie die Tafel auf etwas Steifes und Flaches</translation>
    </message>
</context>
<context>
    <name>calibration.good</name>
    <message>
        <source>Good: %1.</source>
        <translation>Gut: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.grows_beyond</name>
    <message>
        <source>Beyond the markers it grows, to ±%1 within %2 of them.</source>
        <translation>Außerhalb der Marker wächst sie, auf ±%1 im Umkreis von %2.</translation>
    </message>
</context>
<context>
    <name>calibration.halves_contradict</name>
    <message>
        <source>two halves of the images give focal lengths that differ by %1</source>
        <translation>zwei Hälften der Bilder ergeben um %1 verschiedene Brennweiten</translation>
    </message>
</context>
<context>
    <name>calibration.halves_foretell</name>
    <message>
        <source>each half of the images predicts the other to %1</source>
        <translation>jede Hälfte sagt die andere auf %1 voraus</translation>
    </message>
</context>
<context>
    <name>calibration.halves_foretell_apart</name>
    <message>
        <source>each half of the images predicts the other to %1, at most %2 apart on that floor</source>
        <translation>jede Hälfte sagt die andere auf %1 voraus, auf diesem Boden höchstens %2 auseinander</translation>
    </message>
</context>
<context>
    <name>calibration.held_out_markers</name>
    <message>
        <source>Markers that are left out one by one are predicted to %1 RMS.</source>
        <translation>Einzeln weggelassene Marker werden auf %1 RMS vorhergesagt.</translation>
    </message>
</context>
<context>
    <name>calibration.hold_board_closer</name>
    <message>
        <source>hold it closer to the camera</source>
        <translation>halten Sie sie näher an die Kamera</translation>
    </message>
</context>
<context>
    <name>calibration.hold_board_still</name>
    <message>
        <source>hold it still, and focus the camera</source>
        <translation>halten Sie sie still, und stellen Sie die Kamera scharf</translation>
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
        <translation>wurden diese Bilder beschnitten, so müssen es die Videos ebenso sein</translation>
    </message>
</context>
<context>
    <name>calibration.image_mirrored</name>
    <message>
        <source>mirrored left to right they fit to %1: is the image mirrored?</source>
        <translation>seitenverkehrt passen sie auf %1: Ist das Bild gespiegelt?</translation>
    </message>
</context>
<context>
    <name>calibration.image_repeats</name>
    <message>
        <source>1 of %1 images shows the board in the same position as another one, and each position counts once</source>
        <translation>1 von %1 Bildern zeigt die Tafel an derselben Stelle wie ein anderes, und jede Stelle zählt einmal</translation>
    </message>
</context>
<context>
    <name>calibration.images_left_out</name>
    <message>
        <source>Left out: %1.</source>
        <translation>Weggelassen: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.images_left_out_among</name>
    <message>
        <source>%1 images were left out, among them %2.</source>
        <translation>%1 Bilder wurden weggelassen, darunter %2.</translation>
    </message>
</context>
<context>
    <name>calibration.images_repeat</name>
    <message>
        <source>%1 of %2 images show the board in the same position as another one, and each position counts once</source>
        <translation>%1 von %2 Bildern zeigen die Tafel an derselben Stelle wie ein anderes, und jede Stelle zählt einmal</translation>
    </message>
</context>
<context>
    <name>calibration.inches</name>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
</context>
<context>
    <name>calibration.inside</name>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
</context>
<context>
    <name>calibration.inside_expected_error</name>
    <message>
        <source>within the limit of %1 (2.5 σ).</source>
        <translation>innerhalb des erwarteten Fehlers von %1.</translation>
    </message>
</context>
<context>
    <name>calibration.keep_board_clear</name>
    <message>
        <source>keep the board clear and well lit</source>
        <translation>halten Sie die Tafel frei und gut beleuchtet</translation>
    </message>
</context>
<context>
    <name>calibration.keep_whole_board</name>
    <message>
        <source>keep the whole board in view</source>
        <translation>halten Sie die ganze Tafel im Bild</translation>
    </message>
</context>
<context>
    <name>calibration.label_each_marker</name>
    <message>
        <source>give each marker a label of its own</source>
        <translation>geben Sie jedem Marker eine eigene Bezeichnung</translation>
    </message>
</context>
<context>
    <name>calibration.label_each_point</name>
    <message>
        <source>give each point a label of its own</source>
        <translation>geben Sie jedem Punkt eine eigene Bezeichnung</translation>
    </message>
</context>
<context>
    <name>calibration.label_of_layout</name>
    <message>
        <source>label &apos;%1&apos; of the layout</source>
        <translation>Bezeichnung &apos;%1&apos; des Plans</translation>
    </message>
</context>
<context>
    <name>calibration.labels_called</name>
    <message>
        <source>with %1 renamed %2 they fit to %3</source>
        <translation>mit %1 als %2 bezeichnet passen sie auf %3</translation>
    </message>
</context>
<context>
    <name>calibration.labels_exchanged</name>
    <message>
        <source>with %1 and %2 swapped they fit to %3</source>
        <translation>mit %1 und %2 vertauscht passen sie auf %3</translation>
    </message>
</context>
<context>
    <name>calibration.lay_stick_nearer</name>
    <message>
        <source>put the stick on the floor, nearer to the camera</source>
        <translation>legen Sie den Stab auf den Boden, näher an die Kamera</translation>
    </message>
</context>
<context>
    <name>calibration.layout_in_mm</name>
    <message>
        <source>it must be in mm</source>
        <translation>erwartet werden mm</translation>
    </message>
</context>
<context>
    <name>calibration.layout_mirrored</name>
    <message>
        <source>with a reversed Y of the layout they fit to %1: check the signs of the layout, seen from above Y must point to the left of X</source>
        <translation>mit umgekehrtem Y der Markeranordnung passen sie auf %1: Vorzeichen der Anordnung prüfen, von oben gesehen muss Y links von X zeigen</translation>
    </message>
</context>
<context>
    <name>calibration.layout_not_in_mm</name>
    <message>
        <source>if that is wrong, the layout is not in mm</source>
        <translation>wenn das falsch ist, sind die Zahlen des Plans keine mm</translation>
    </message>
</context>
<context>
    <name>calibration.layout_too_small</name>
    <message>
        <source>the layout has %1 markers, four are needed</source>
        <translation>der Plan hat %1 Marker, vier werden gebraucht</translation>
    </message>
</context>
<context>
    <name>calibration.layout_written_mirrored</name>
    <message>
        <source>if the layout was written down mirrored, correct its signs and add it again</source>
        <translation>wenn der Plan gespiegelt notiert wurde, berichtigen Sie seine Vorzeichen und fügen Sie ihn neu hinzu</translation>
    </message>
</context>
<context>
    <name>calibration.leave_one_tag</name>
    <message>
        <source>leave one of them on the floor</source>
        <translation>lassen Sie eines davon auf dem Boden</translation>
    </message>
</context>
<context>
    <name>calibration.leave_out_pictures</name>
    <message>
        <source>leave out these images if the board is bent, cut or covered there.</source>
        <translation>lassen Sie diese Bilder weg, wenn die Tafel dort verbogen, abgeschnitten oder verdeckt ist.</translation>
    </message>
</context>
<context>
    <name>calibration.left_edge</name>
    <message>
        <source>at the left edge</source>
        <translation>am linken Rand</translation>
    </message>
</context>
<context>
    <name>calibration.length_factor</name>
    <message>
        <source>a length factor of %1 is not possible</source>
        <translation>ein Längenfaktor von %1 ergibt keinen Boden</translation>
    </message>
</context>
<context>
    <name>calibration.length_is</name>
    <message>
        <source>The length is %1 ± %2.</source>
        <translation>Die Länge beträgt %1 ± %2.</translation>
    </message>
</context>
<context>
    <name>calibration.length_longer</name>
    <message>
        <source>It is %1 longer than the %2 entered</source>
        <translation>Sie ist %1 länger als die angegebenen %2</translation>
    </message>
</context>
<context>
    <name>calibration.length_shorter</name>
    <message>
        <source>It is %1 shorter than the %2 entered</source>
        <translation>Sie ist %1 kürzer als die angegebenen %2</translation>
    </message>
</context>
<context>
    <name>calibration.length_unmeasured</name>
    <message>
        <source>the length cannot be measured</source>
        <translation>die Länge kann nicht gemessen werden</translation>
    </message>
</context>
<context>
    <name>calibration.length_unseen</name>
    <message>
        <source>no camera shows it</source>
        <translation>keine Kamera wurde angegeben, die sie sieht</translation>
    </message>
</context>
<context>
    <name>calibration.lens_assumed</name>
    <message>
        <source>The lens is not calibrated, and the markers hardly determine it (focal length %1 ± %2): what is not known of it is in the uncertainty.</source>
        <translation>Das Objektiv ist nicht kalibriert, und die Marker bestimmen es kaum (Brennweite %1 ± %2): Was davon nicht bekannt ist, steckt in der Unsicherheit.</translation>
    </message>
</context>
<context>
    <name>calibration.lens_from_floor</name>
    <message>
        <source>The lens is not calibrated: focal length (%1 ± %2) and distortion (k1 %3 ± %4) were estimated from the markers.</source>
        <translation>Das Objektiv ist nicht kalibriert: Brennweite (%1 ± %2) und Verzeichnung (k1 %3 ± %4) wurden aus den Markern geschätzt.</translation>
    </message>
</context>
<context>
    <name>calibration.lens_of_other_camera</name>
    <message>
        <source>with the lens calibration of camera &apos;%1&apos; they fit to %2: are the views swapped?</source>
        <translation>mit der Objektivkalibrierung von Kamera „%1“ passen sie auf %2: Sind die Ansichten vertauscht?</translation>
    </message>
</context>
<context>
    <name>calibration.lens_on_floor</name>
    <message>
        <source>±%1 in the middle and at most ±%2 (%3) on %4, from the lens calibration alone</source>
        <translation>±%1 in der Mitte und schlimmstenfalls ±%2 (%3) auf %4, soweit es am Objektiv liegt</translation>
    </message>
</context>
<context>
    <name>calibration.lens_told</name>
    <message>
        <source>as specified</source>
        <translation>vorgegeben</translation>
    </message>
</context>
<context>
    <name>calibration.lens_unknown_elsewhere</name>
    <message>
        <source>the distortion elsewhere stays unknown</source>
        <translation>wie das Objektiv anderswo verzeichnet, bleibt unbekannt</translation>
    </message>
</context>
<context>
    <name>calibration.likely_unit</name>
    <message>
        <source>its numbers look like %1, with the camera %2 above the floor</source>
        <translation>die Zahlen sehen nach %1 aus, dann stünde sie %2 über dem Boden</translation>
    </message>
</context>
<context>
    <name>calibration.longer</name>
    <message>
        <source>longer</source>
        <translation>länger</translation>
    </message>
</context>
<context>
    <name>calibration.look_at</name>
    <message>
        <source>Check %1</source>
        <translation>Sehen Sie %1 an</translation>
    </message>
</context>
<context>
    <name>calibration.look_at_ends</name>
    <message>
        <source>check that the same ends are marked in each image; if they are, register it again.</source>
        <translation>sehen Sie nach, ob in jedem Bild dieselben Enden markiert sind, und messen Sie sie neu ein, wenn ja.</translation>
    </message>
</context>
<context>
    <name>calibration.look_at_pictures</name>
    <message>
        <source>check these images and leave out those that are blurred, bent or of another board.</source>
        <translation>sehen Sie diese Bilder an und lassen Sie unscharfe, verbogene oder solche einer anderen Tafel weg.</translation>
    </message>
</context>
<context>
    <name>calibration.looking_about</name>
    <message>
        <source>searching around the best position</source>
        <translation>die Umgebung des besten Orts wird abgesucht</translation>
    </message>
</context>
<context>
    <name>calibration.make_larger_layout</name>
    <message>
        <source>make a layout of four markers or more</source>
        <translation>legen Sie einen Plan mit vier oder mehr Markern an</translation>
    </message>
</context>
<context>
    <name>calibration.mark_ends_in_one</name>
    <message>
        <source>mark its ends in at least one image</source>
        <translation>markieren Sie ihre Enden in mindestens einem Bild</translation>
    </message>
</context>
<context>
    <name>calibration.mark_more</name>
    <message>
        <source>mark more of the layout&apos;s markers, by their names in the layout</source>
        <translation>markieren Sie mehr Marker des Plans, unter den Namen des Plans</translation>
    </message>
</context>
<context>
    <name>calibration.mark_there_again</name>
    <message>
        <source>mark it again in that view.</source>
        <translation>markieren Sie ihn dort neu.</translation>
    </message>
</context>
<context>
    <name>calibration.mark_two_ends</name>
    <message>
        <source>mark each end at its own position in the image</source>
        <translation>markieren Sie beide Enden dort, wo sie zu sehen sind</translation>
    </message>
</context>
<context>
    <name>calibration.mark_where_seen</name>
    <message>
        <source>mark each of them at its own position in the image</source>
        <translation>markieren Sie jeden dort, wo er zu sehen ist</translation>
    </message>
</context>
<context>
    <name>calibration.marker_against_lens</name>
    <message>
        <source>this camera&apos;s lens model cannot project %1</source>
        <translation>%1 liegt, wohin das Objektiv dieser Kamera nichts abbilden kann</translation>
    </message>
</context>
<context>
    <name>calibration.marker_beyond_horizon</name>
    <message>
        <source>marker %1 would be at or beyond the horizon</source>
        <translation>Marker %1 läge am oder hinter dem Horizont</translation>
    </message>
</context>
<context>
    <name>calibration.marker_moved</name>
    <message>
        <source>Marker %1 has moved %2 = %3, %4 has not</source>
        <translation>Marker %1 hat sich um %2 = %3 bewegt, %4 nicht</translation>
    </message>
</context>
<context>
    <name>calibration.marker_off_by_all</name>
    <message>
        <source>%1 is %2 off in all cameras</source>
        <translation>%1 liegt nach allen Kameras %2 daneben</translation>
    </message>
</context>
<context>
    <name>calibration.marker_off_by_one</name>
    <message>
        <source>%1 is %2 off in the one camera that sees it</source>
        <translation>%1 liegt nach der einen Kamera, die ihn sieht, %2 daneben</translation>
    </message>
</context>
<context>
    <name>calibration.marker_pixel_no_number</name>
    <message>
        <source>the pixel of marker %1 is not a finite number</source>
        <translation>das Pixel von Marker %1 ist keine endliche Zahl</translation>
    </message>
</context>
<context>
    <name>calibration.marker_place_no_number</name>
    <message>
        <source>the position of marker %1 is not a finite number</source>
        <translation>der Ort von Marker %1 ist keine endliche Zahl</translation>
    </message>
</context>
<context>
    <name>calibration.marker_twice_in_layout</name>
    <message>
        <source>marker %1 appears twice in the layout</source>
        <translation>Marker %1 steht zweimal im Plan</translation>
    </message>
</context>
<context>
    <name>calibration.marker_twice_in_picture</name>
    <message>
        <source>marker %1 appears twice in the image</source>
        <translation>Marker %1 steht zweimal im Bild</translation>
    </message>
</context>
<context>
    <name>calibration.markers_at_one_place</name>
    <message>
        <source>markers %1 and %2 have the same floor position</source>
        <translation>die Marker %1 und %2 liegen an einer Stelle des Bodens</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit</name>
    <message>
        <source>%1 markers fit to %2 RMS (worst %3, %4); floor uncertainty ±%5</source>
        <translation>%1 Marker passen auf %2 RMS (am schlechtesten %3, %4), und der Boden zwischen ihnen ist auf ±%5 bekannt</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit_many_ways</name>
    <message>
        <source>they fit the layout equally well in %1 ways, because it looks the same from several sides</source>
        <translation>auf %1 Arten passen sie gleich gut zum Plan, der von mehreren Seiten gleich aussieht</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit_together</name>
    <message>
        <source>registered jointly with %1: %2 markers fit to %3 RMS; floor uncertainty ±%4</source>
        <translation>zusammen mit %1 passen %2 Marker auf %3 RMS, und der Boden zwischen ihnen ist auf ±%4 bekannt</translation>
    </message>
</context>
<context>
    <name>calibration.markers_found</name>
    <message>
        <source>%1 of %2 were found, four are needed</source>
        <translation>%1 von %2 wurden gefunden, vier sind nötig</translation>
    </message>
</context>
<context>
    <name>calibration.markers_in_place</name>
    <message>
        <source>%1 markers are within %2 = %3 of their positions.</source>
        <translation>%1 Marker liegen innerhalb von %2 = %3 an ihren Plätzen.</translation>
    </message>
</context>
<context>
    <name>calibration.markers_mirrored</name>
    <message>
        <source>the markers are mirrored</source>
        <translation>die Marker sind gespiegelt</translation>
    </message>
</context>
<context>
    <name>calibration.markers_missing</name>
    <message>
        <source>missing: %1</source>
        <translation>es fehlen: %1</translation>
    </message>
</context>
<context>
    <name>calibration.markers_moved</name>
    <message>
        <source>Markers %1 have moved %2 = %3, %4 has not</source>
        <translation>Die Marker %1 haben sich um %2 = %3 bewegt, %4 nicht</translation>
    </message>
</context>
<context>
    <name>calibration.markers_nearly_on_line</name>
    <message>
        <source>the markers are so close to one line (%1 the most) that the floor uncertainty is ±%2</source>
        <translation>die Marker liegen so nahezu auf einer Linie (%1 am meisten), dass der Boden nur auf ±%2 bekannt ist</translation>
    </message>
</context>
<context>
    <name>calibration.markers_not_found</name>
    <message>
        <source>the floor markers cannot be found</source>
        <translation>die Marker auf dem Boden sind nicht zu finden</translation>
    </message>
</context>
<context>
    <name>calibration.markers_not_told_apart</name>
    <message>
        <source>the markers cannot be distinguished</source>
        <translation>die Marker sind nicht zu unterscheiden</translation>
    </message>
</context>
<context>
    <name>calibration.markers_on_one_pixel</name>
    <message>
        <source>markers %1 and %2 are on the same pixel</source>
        <translation>die Marker %1 und %2 liegen auf einem Pixel</translation>
    </message>
</context>
<context>
    <name>calibration.markers_read</name>
    <message>
        <source>%1 of its markers could be read</source>
        <translation>%1 ihrer Marker waren lesbar</translation>
    </message>
</context>
<context>
    <name>calibration.markers_too_close</name>
    <message>
        <source>markers %1 and %2 are only %3 apart, too close for two of four</source>
        <translation>die Marker %1 und %2 liegen nur %3 auseinander, zu nah für zwei von vieren</translation>
    </message>
</context>
<context>
    <name>calibration.measure_again</name>
    <message>
        <source>mark and remeasure them, or add another</source>
        <translation>markieren und messen Sie sie neu, oder fügen Sie einen hinzu</translation>
    </message>
</context>
<context>
    <name>calibration.measure_it_again</name>
    <message>
        <source>remeasure it.</source>
        <translation>messen Sie ihn neu.</translation>
    </message>
</context>
<context>
    <name>calibration.measure_or_mark_again</name>
    <message>
        <source>measure it, or mark it in the image, again.</source>
        <translation>messen Sie ihn neu oder markieren Sie ihn im Bild neu.</translation>
    </message>
</context>
<context>
    <name>calibration.metres</name>
    <message>
        <source>metres</source>
        <translation>Metern</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_corner</name>
    <message>
        <source>±%1 in the middle, ±%2 in the corner near %3.</source>
        <translation>±%1 in der Mitte, ±%2 in der Ecke bei %3.</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_edge</name>
    <message>
        <source>±%1 in the middle, ±%2 at the edge near %3.</source>
        <translation>±%1 in der Mitte, ±%2 am Rand bei %3.</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_near</name>
    <message>
        <source>±%1 in the middle, ±%2 near %3.</source>
        <translation>±%1 in der Mitte, ±%2 bei %3.</translation>
    </message>
</context>
<context>
    <name>calibration.misfit_most_at</name>
    <message>
        <source>%1 RMS, most at %2 (%3)</source>
        <translation>%1 RMS, am meisten bei %2 (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.misfit_unexplained</name>
    <message>
        <source>the %1 markers misfit by %2 (%3), and are too few to identify the wrong one</source>
        <translation>die %1 Marker passen um %2 (%3) nicht und prüfen einander zu wenig, um zu sagen, welcher es ist</translation>
    </message>
</context>
<context>
    <name>calibration.more_pairs</name>
    <message>
        <source>take more pairs, or register %1 better first</source>
        <translation>machen Sie mehr Bildpaare, oder messen Sie zuerst %1 besser ein</translation>
    </message>
</context>
<context>
    <name>calibration.more_pictures</name>
    <message>
        <source>More images (%1 or more) would make it more certain.</source>
        <translation>Mehr Bilder (%1 oder mehr) würden es sicherer machen.</translation>
    </message>
</context>
<context>
    <name>calibration.move_board</name>
    <message>
        <source>move it elsewhere, turn it or tilt it</source>
        <translation>halten Sie sie woanders hin, drehen oder neigen Sie sie</translation>
    </message>
</context>
<context>
    <name>calibration.move_planned_back</name>
    <message>
        <source>move it back or up, or choose a wider lens</source>
        <translation>rücken Sie die Kamera zurück oder höher, oder wählen Sie ein weiteres Objektiv</translation>
    </message>
</context>
<context>
    <name>calibration.name_dictionary</name>
    <message>
        <source>name one like DICT_6X6_250, or leave it out</source>
        <translation>nennen Sie eines wie DICT_6X6_250, oder lassen Sie es weg</translation>
    </message>
</context>
<context>
    <name>calibration.name_each_camera</name>
    <message>
        <source>name each camera once</source>
        <translation>nennen Sie jede Kamera einmal</translation>
    </message>
</context>
<context>
    <name>calibration.name_each_marker</name>
    <message>
        <source>give each marker a name of its own</source>
        <translation>geben Sie jedem Marker einen eigenen Namen</translation>
    </message>
</context>
<context>
    <name>calibration.name_one_marker</name>
    <message>
        <source>name one of %1</source>
        <translation>nennen Sie einen von %1</translation>
    </message>
</context>
<context>
    <name>calibration.name_tag_family</name>
    <message>
        <source>write the family into the labels, such as 36h11:7, or mark a marker by hand</source>
        <translation>schreiben Sie die Familie in die Bezeichnungen, etwa 36h11:7, oder markieren Sie einen Marker von Hand</translation>
    </message>
</context>
<context>
    <name>calibration.name_two_apart</name>
    <message>
        <source>name two at different positions</source>
        <translation>nennen Sie zwei, die auseinander liegen</translation>
    </message>
</context>
<context>
    <name>calibration.near_edge</name>
    <message>
        <source>at the near edge</source>
        <translation>am vorderen Rand</translation>
    </message>
</context>
<context>
    <name>calibration.near_left_corner</name>
    <message>
        <source>in the near left corner</source>
        <translation>in der vorderen linken Ecke</translation>
    </message>
</context>
<context>
    <name>calibration.near_right_corner</name>
    <message>
        <source>in the near right corner</source>
        <translation>in der vorderen rechten Ecke</translation>
    </message>
</context>
<context>
    <name>calibration.no_board_found</name>
    <message>
        <source>no board found</source>
        <translation>keine Tafel gefunden</translation>
    </message>
</context>
<context>
    <name>calibration.no_charuco</name>
    <message>
        <source>the detected markers do not match a ChArUco board</source>
        <translation>die gelesenen Marker liegen nicht wie auf einer ChArUco-Tafel</translation>
    </message>
</context>
<context>
    <name>calibration.no_charuco_of_size</name>
    <message>
        <source>the detected markers do not match a ChArUco board of %1 inner corners</source>
        <translation>die gelesenen Marker liegen nicht wie auf einer ChArUco-Tafel mit %1 inneren Ecken</translation>
    </message>
</context>
<context>
    <name>calibration.no_common_marker</name>
    <message>
        <source>no two of the cameras see the same marker</source>
        <translation>keine zwei der Kameras sehen denselben Marker</translation>
    </message>
</context>
<context>
    <name>calibration.no_dictionary</name>
    <message>
        <source>marker dictionary %1 does not exist</source>
        <translation>es gibt kein Marker-Wörterbuch %1</translation>
    </message>
</context>
<context>
    <name>calibration.no_flat_floor</name>
    <message>
        <source>the markers do not fit a flat floor</source>
        <translation>die Marker passen nicht zu einem ebenen Boden</translation>
    </message>
</context>
<context>
    <name>calibration.no_lens_fits</name>
    <message>
        <source>no lens model fits these images</source>
        <translation>kein Objektiv passt zu diesen Bildern</translation>
    </message>
</context>
<context>
    <name>calibration.no_millimetres</name>
    <message>
        <source>no value in millimetres: this calibration holds for only part of the image</source>
        <translation>keine Angabe in Millimetern, weil diese Objektivdaten nur für einen Teil des Bildes gelten</translation>
    </message>
</context>
<context>
    <name>calibration.no_other_lens</name>
    <message>
        <source>no other model fits</source>
        <translation>kein anderes Modell passt</translation>
    </message>
</context>
<context>
    <name>calibration.no_pair_has_board</name>
    <message>
        <source>none of %1 pairs can be used</source>
        <translation>von %1 Bildpaaren ist keines brauchbar</translation>
    </message>
</context>
<context>
    <name>calibration.no_pose</name>
    <message>
        <source>no pose</source>
        <translation>keine Lage</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_corner</name>
    <message>
        <source>the corners of a tag are tl, tr, br and bl</source>
        <translation>die Ecken eines Tags heißen tl, tr, br und bl</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_marker</name>
    <message>
        <source>it has no marker %1</source>
        <translation>er hat keinen Marker %1</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_tag</name>
    <message>
        <source>%1 has no tag %2</source>
        <translation>%1 hat kein Tag %2</translation>
    </message>
</context>
<context>
    <name>calibration.no_tag_number</name>
    <message>
        <source>&apos;%1&apos; is not the number of a tag</source>
        <translation>&apos;%1&apos; ist keine Nummer eines Tags</translation>
    </message>
</context>
<context>
    <name>calibration.not_all_foretold</name>
    <message>
        <source>not all</source>
        <translation>nicht alle</translation>
    </message>
</context>
<context>
    <name>calibration.not_found_again</name>
    <message>
        <source>Not found again: %1.</source>
        <translation>Nicht wiedergefunden: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_by_pair</name>
    <message>
        <source>the camera cannot be registered by the pair</source>
        <translation>die Kamera kann durch das Paar nicht eingemessen werden</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_through</name>
    <message>
        <source>the camera cannot be registered via another camera</source>
        <translation>die Kamera kann nicht über eine andere eingemessen werden</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_together</name>
    <message>
        <source>the cameras cannot be registered jointly</source>
        <translation>die Kameras können nicht gemeinsam eingemessen werden</translation>
    </message>
</context>
<context>
    <name>calibration.of_other_camera</name>
    <message>
        <source>it is of another camera, zoom or focus</source>
        <translation>es stammt von einer anderen Kamera oder einem anderen Zoom oder Fokus</translation>
    </message>
</context>
<context>
    <name>calibration.other_focal_length</name>
    <message>
        <source>it gives a focal length of %1, the other images %2</source>
        <translation>es ergibt eine Brennweite von %1, die anderen Bilder %2</translation>
    </message>
</context>
<context>
    <name>calibration.other_picking_size</name>
    <message>
        <source>at %1 they fit to %2: were they picked at that size?</source>
        <translation>bei %1 passen sie auf %2: Wurden sie in dieser Größe markiert?</translation>
    </message>
</context>
<context>
    <name>calibration.other_picture_size</name>
    <message>
        <source>it is %1×%2, the other images are %3×%4</source>
        <translation>dieses Bild hat %1×%2, die anderen haben %3×%4</translation>
    </message>
</context>
<context>
    <name>calibration.other_zoom</name>
    <message>
        <source>with a focal length of %1 instead of %2 they fit to %3: has the zoom or the lens changed?</source>
        <translation>mit einer Brennweite von %1 statt %2 passen sie auf %3: Wurde der Zoom oder das Objektiv geändert?</translation>
    </message>
</context>
<context>
    <name>calibration.others_undetermined</name>
    <message>
        <source>the images do not determine any other model</source>
        <translation>die Bilder bestimmen kein anderes Modell</translation>
    </message>
</context>
<context>
    <name>calibration.outside_expected_error</name>
    <message>
        <source>beyond the limit of %1 (2.5 σ).</source>
        <translation>außerhalb des erwarteten Fehlers von %1.</translation>
    </message>
</context>
<context>
    <name>calibration.pair_contradicts</name>
    <message>
        <source>it contradicts the other pairs by %1 RMS</source>
        <translation>es widerspricht den anderen Paaren um %1 RMS</translation>
    </message>
</context>
<context>
    <name>calibration.pair_fits</name>
    <message>
        <source>the cameras are %1 apart (±%2) by %3 pairs, whose corners fit to %4 RMS</source>
        <translation>die Kameras sind %1 voneinander entfernt (±%2), nach %3 Bildpaaren, deren Ecken auf %4 RMS passen</translation>
    </message>
</context>
<context>
    <name>calibration.pair_floor_unsure</name>
    <message>
        <source>the floor uncertainty would be ±%1</source>
        <translation>die Unsicherheit auf dem Boden wäre ±%1</translation>
    </message>
</context>
<context>
    <name>calibration.pair_is_one_image</name>
    <message>
        <source>both are the same image</source>
        <translation>beide sind dasselbe Bild</translation>
    </message>
</context>
<context>
    <name>calibration.pair_lacks_board</name>
    <message>
        <source>the board was not found in &apos;%1&apos;</source>
        <translation>in „%1“ wurde die Tafel nicht gefunden</translation>
    </message>
</context>
<context>
    <name>calibration.pair_lens_usual</name>
    <message>
        <source>A lens calibration has no stated uncertainty: a usual one was assumed.</source>
        <translation>Eine Objektivkalibrierung gibt keine Unsicherheit an: eine übliche wurde angenommen.</translation>
    </message>
</context>
<context>
    <name>calibration.pair_of_cameras</name>
    <message>
        <source>the relative position of the cameras</source>
        <translation>die relative Lage der Kameras</translation>
    </message>
</context>
<context>
    <name>calibration.pair_sees_no_floor</name>
    <message>
        <source>it would see hardly any floor</source>
        <translation>sie sähe kaum etwas vom Boden</translation>
    </message>
</context>
<context>
    <name>calibration.pair_squares</name>
    <message>
        <source>Triangulated, the squares of the board are %1 (standard deviation %2).</source>
        <translation>Trianguliert sind die Felder der Tafel %1 groß (Standardabweichung %2).</translation>
    </message>
</context>
<context>
    <name>calibration.pair_swapped</name>
    <message>
        <source>the images of each camera fit the lens calibration of the other one (%1 instead of %2 RMS)</source>
        <translation>die Bilder jeder Kamera passen zur Objektivkalibrierung der anderen (%1 statt %2 RMS)</translation>
    </message>
</context>
<context>
    <name>calibration.pair_turned</name>
    <message>
        <source>the board looks the same when turned by half, and %1 pairs fit both ways</source>
        <translation>die Tafel sieht um 180° gedreht gleich aus, und %1 Bildpaare passen auf beide Arten</translation>
    </message>
</context>
<context>
    <name>calibration.pair_undetermined</name>
    <message>
        <source>the board positions do not determine it</source>
        <translation>die Lagen der Tafel bestimmen sie nicht</translation>
    </message>
</context>
<context>
    <name>calibration.pair_without_pose</name>
    <message>
        <source>the corners in &apos;%1&apos; determine no pose</source>
        <translation>die Ecken in „%1“ bestimmen keine Lage</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_contradict</name>
    <message>
        <source>the pairs contradict each other (%1 RMS together, %2 in each image alone)</source>
        <translation>die Bildpaare widersprechen einander (%1 RMS zusammen, %2 in jedem Bild für sich)</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_left_out</name>
    <message>
        <source>%1 pairs were not used.</source>
        <translation>%1 Bildpaare wurden nicht verwendet.</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_scatter</name>
    <message>
        <source>The pairs agree less well than the corners would allow, which is in the uncertainty: the board moved between the two frames of a pair, or a lens calibration is less accurate than stated.</source>
        <translation>Die Bildpaare stimmen schlechter überein, als die Ecken erwarten lassen, was in der Unsicherheit enthalten ist: die Tafel hat sich zwischen den beiden Bildern eines Paares bewegt, oder eine Objektivkalibrierung ist ungenauer als angegeben.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_alike</name>
    <message>
        <source>Neighbouring markers err alike, by %1 RMS: check that the floor is flat, and calibrate the lens at the zoom and focus that it records with.</source>
        <translation>Benachbarte Marker weichen gleich ab, um %1 RMS: Prüfen Sie, ob der Boden eben ist, und kalibrieren Sie das Objektiv mit dem Zoom und Fokus, mit denen aufgenommen wird.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_layout</name>
    <message>
        <source>The residuals follow the layout: they disappear with X longer than Y by %1 % and the axes %2° off the right angle; measure both sides and both diagonals of the layout again.</source>
        <translation>Die Abweichungen folgen dem Plan: Sie verschwinden, wenn X um %1 % länger ist als Y und die Achsen um %2° vom rechten Winkel abweichen; messen Sie beide Seiten und beide Diagonalen des Plans nach.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_lens</name>
    <message>
        <source>The residuals follow the lens: %1 of them disappear with another focal length and distortion; calibrate the lens again, at the zoom and focus that it records with.</source>
        <translation>Die Abweichungen folgen dem Objektiv: %1 davon verschwinden mit einer anderen Brennweite und Verzeichnung; kalibrieren Sie das Objektiv neu, mit dem Zoom und Fokus, mit denen aufgenommen wird.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_marker</name>
    <message>
        <source>Marker %1 is %2 from where the others expect it: measure and mark it again.</source>
        <translation>Marker %1 liegt %2 neben dem, was die anderen erwarten lassen: Messen und markieren Sie ihn neu.</translation>
    </message>
</context>
<context>
    <name>calibration.picture_covered</name>
    <message>
        <source>The board covered only %1 of the image</source>
        <translation>Nur %1 des Bildes wurden abgedeckt</translation>
    </message>
</context>
<context>
    <name>calibration.picture_stands_out</name>
    <message>
        <source>its %1 is an outlier.</source>
        <translation>seine %1 fallen heraus.</translation>
    </message>
</context>
<context>
    <name>calibration.picture_too_small</name>
    <message>
        <source>the image is too small</source>
        <translation>das Bild ist zu klein</translation>
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
        <translation>das Bild hat keine Größe</translation>
    </message>
</context>
<context>
    <name>calibration.pictures_fit</name>
    <message>
        <source>%1 images fit to %2, focal length %3 ± %4</source>
        <translation>%1 Bilder passen auf %2, Brennweite %3 ± %4</translation>
    </message>
</context>
<context>
    <name>calibration.pictures_fit_halves_apart</name>
    <message>
        <source>%1 images fit to %2, focal length %3 ± %4, halves at most %5 apart on that floor</source>
        <translation>%1 Bilder passen auf %2, Brennweite %3 ± %4, auf diesem Boden höchstens %5 auseinander</translation>
    </message>
</context>
<context>
    <name>calibration.pixels_not_square</name>
    <message>
        <source>the camera&apos;s pixels are not square, or its images were rescaled</source>
        <translation>die Pixel der Kamera sind nicht quadratisch, oder ihre Bilder wurden skaliert</translation>
    </message>
</context>
<context>
    <name>calibration.place_left</name>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower</name>
    <message>
        <source>lower</source>
        <translation>unten</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower_left</name>
    <message>
        <source>lower left</source>
        <translation>unten links</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower_right</name>
    <message>
        <source>lower right</source>
        <translation>unten rechts</translation>
    </message>
</context>
<context>
    <name>calibration.place_middle</name>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
</context>
<context>
    <name>calibration.place_right</name>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper</name>
    <message>
        <source>upper</source>
        <translation>oben</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper_left</name>
    <message>
        <source>upper left</source>
        <translation>oben links</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper_right</name>
    <message>
        <source>upper right</source>
        <translation>oben rechts</translation>
    </message>
</context>
<context>
    <name>calibration.planned_camera</name>
    <message>
        <source>the planned camera</source>
        <translation>die geplante Kamera</translation>
    </message>
</context>
<context>
    <name>calibration.planned_distance</name>
    <message>
        <source>its distance cannot be %1</source>
        <translation>%1 entfernt kann keine Kamera stehen</translation>
    </message>
</context>
<context>
    <name>calibration.planned_field_of_view</name>
    <message>
        <source>its field of view is %1</source>
        <translation>das Blickfeld ist %1</translation>
    </message>
</context>
<context>
    <name>calibration.planned_height</name>
    <message>
        <source>its height above the floor cannot be %1</source>
        <translation>%1 über dem Boden kann keine Kamera stehen</translation>
    </message>
</context>
<context>
    <name>calibration.planned_not_held</name>
    <message>
        <source>the markers it would see do not determine its pose</source>
        <translation>die Marker, die sie sähe, legen ihre Lage nicht fest</translation>
    </message>
</context>
<context>
    <name>calibration.planned_sees_too_few</name>
    <message>
        <source>it would see only %1 of the layout&apos;s markers (%2), four are needed</source>
        <translation>von dort sähe sie %1 der Marker des Plans (%2), vier werden gebraucht</translation>
    </message>
</context>
<context>
    <name>calibration.point_against_lens</name>
    <message>
        <source>the lens model cannot project point %1</source>
        <translation>Punkt %1 liegt, wohin ihn kein Objektiv abbilden kann</translation>
    </message>
</context>
<context>
    <name>calibration.point_beyond_horizon</name>
    <message>
        <source>point %1 would be at or beyond the horizon</source>
        <translation>Punkt %1 läge am oder hinter dem Horizont</translation>
    </message>
</context>
<context>
    <name>calibration.point_beyond_through</name>
    <message>
        <source>point %1 is at or beyond the horizon of %2</source>
        <translation>Punkt %1 liegt am oder hinter dem Horizont von %2</translation>
    </message>
</context>
<context>
    <name>calibration.point_outside_own</name>
    <message>
        <source>point %1 is outside the image of the camera to register (%2)</source>
        <translation>Punkt %1 liegt außerhalb des Bilds der Kamera, die eingemessen wird (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.point_outside_through</name>
    <message>
        <source>point %1 is outside the image of %2 (%3)</source>
        <translation>Punkt %1 liegt außerhalb des Bilds von %2 (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.point_pixel_no_number</name>
    <message>
        <source>the pixel of point %1 is not a finite number</source>
        <translation>das Pixel von Punkt %1 ist keine endliche Zahl</translation>
    </message>
</context>
<context>
    <name>calibration.point_twice</name>
    <message>
        <source>point %1 appears twice</source>
        <translation>Punkt %1 gibt es zweimal</translation>
    </message>
</context>
<context>
    <name>calibration.points_fit</name>
    <message>
        <source>via %1, %2 floor points fit to %3 RMS (worst %4, %5); floor uncertainty ±%6, of which %8 contributes ±%7</source>
        <translation>über %1 passen %2 Punkte des Bodens auf %3 RMS (am schlechtesten %4, %5), und der Boden zwischen ihnen ist auf ±%6 bekannt, davon kommen ±%7 von %8</translation>
    </message>
</context>
<context>
    <name>calibration.points_mirrored</name>
    <message>
        <source>the points are mirrored between the images of the two cameras</source>
        <translation>die Punkte sind zwischen den Bildern der beiden Kameras gespiegelt</translation>
    </message>
</context>
<context>
    <name>calibration.points_on_one_pixel</name>
    <message>
        <source>points %1 and %2 are on the same pixel</source>
        <translation>die Punkte %1 und %2 liegen auf einem Pixel</translation>
    </message>
</context>
<context>
    <name>calibration.points_undetermined</name>
    <message>
        <source>the points do not determine the camera position</source>
        <translation>die Punkte bestimmen nicht, wo die Kamera steht</translation>
    </message>
</context>
<context>
    <name>calibration.poor</name>
    <message>
        <source>Poor: %1.</source>
        <translation>Schlecht: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.poor_measure_again</name>
    <message>
        <source>Poor, measure the markers again: %1.</source>
        <translation>Schlecht, messen Sie die Marker neu: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.print_is_bent</name>
    <message>
        <source>The board is not flat, it bulges by %1: glue it onto something stiff.</source>
        <translation>Die Tafel ist nicht eben, sie wölbt sich um %1: Kleben Sie sie auf etwas Steifes.</translation>
    </message>
</context>
<context>
    <name>calibration.print_is_stretched</name>
    <message>
        <source>The print&apos;s squares are %1 %2 from row to row than from column to column: measure the squares in both directions.</source>
        <translation>Die Felder des Drucks sind von Zeile zu Zeile %1 %2 als von Spalte zu Spalte: Messen Sie die Felder in beiden Richtungen.</translation>
    </message>
</context>
<context>
    <name>calibration.print_may_be_stretched</name>
    <message>
        <source>measure the squares of the print in both directions, for it may be stretched, and take images with the board turned by 90 degrees</source>
        <translation>messen Sie die Felder des Drucks in beiden Richtungen, denn er kann verzerrt sein, und machen Sie Bilder mit um 90 Grad gedrehter Tafel</translation>
    </message>
</context>
<context>
    <name>calibration.print_was_heeded</name>
    <message>
        <source>The calibration allows for this.</source>
        <translation>Die Kalibrierung berücksichtigt das.</translation>
    </message>
</context>
<context>
    <name>calibration.put_marker_back</name>
    <message>
        <source>move it back, or measure the markers again and register all cameras.</source>
        <translation>legen Sie ihn zurück, oder messen Sie neu und messen Sie alle Kameras neu ein.</translation>
    </message>
</context>
<context>
    <name>calibration.put_markers_back</name>
    <message>
        <source>move them back, or measure the markers again and register all cameras.</source>
        <translation>legen Sie sie zurück, oder messen Sie neu und messen Sie alle Kameras neu ein.</translation>
    </message>
</context>
<context>
    <name>calibration.quarter_turn</name>
    <message>
        <source>turned by a quarter they fit to %1: was the image shown turned?</source>
        <translation>um eine Vierteldrehung gedreht passen sie auf %1: Wurde das Bild gedreht gezeigt?</translation>
    </message>
</context>
<context>
    <name>calibration.rational</name>
    <message>
        <source>rational</source>
        <translation>rationale</translation>
    </message>
</context>
<context>
    <name>calibration.rational_lens</name>
    <message>
        <source>Rational lens</source>
        <translation>Rationales Objektivmodell</translation>
    </message>
</context>
<context>
    <name>calibration.register_before_recording</name>
    <message>
        <source>register it again before you record.</source>
        <translation>messen Sie sie vor der Aufnahme neu ein.</translation>
    </message>
</context>
<context>
    <name>calibration.register_by_more</name>
    <message>
        <source>register it with more of them first</source>
        <translation>messen Sie sie zuerst über mehr davon ein</translation>
    </message>
</context>
<context>
    <name>calibration.register_if_gone</name>
    <message>
        <source>if they are gone or the camera points elsewhere, register it again</source>
        <translation>wenn sie fort sind oder die Kamera woandershin blickt, messen Sie sie neu ein</translation>
    </message>
</context>
<context>
    <name>calibration.register_one_by_one</name>
    <message>
        <source>first register the cameras one by one with this layout</source>
        <translation>messen Sie die Kameras zuerst einzeln über diesen Plan ein</translation>
    </message>
</context>
<context>
    <name>calibration.related_to</name>
    <message>
        <source>via %1 and a board that both see; floor uncertainty ±%2</source>
        <translation>über %1 und eine Tafel, die beide sehen; der Boden ist auf ±%2 bekannt</translation>
    </message>
</context>
<context>
    <name>calibration.reverse_both</name>
    <message>
        <source>reverse both (a half turn), or turn the axes</source>
        <translation>kehren Sie beide um (halbe Drehung), oder drehen Sie die Achsen</translation>
    </message>
</context>
<context>
    <name>calibration.reversed_x_alone</name>
    <message>
        <source>reversing X alone would mirror the floor; no camera above it sees it that way</source>
        <translation>X allein umzukehren würde den Boden spiegeln, und keine Kamera darüber sieht ihn so</translation>
    </message>
</context>
<context>
    <name>calibration.reversed_y_alone</name>
    <message>
        <source>reversing Y alone would mirror the floor; no camera above it sees it that way</source>
        <translation>Y allein umzukehren würde den Boden spiegeln, und keine Kamera darüber sieht ihn so</translation>
    </message>
</context>
<context>
    <name>calibration.right_edge</name>
    <message>
        <source>at the right edge</source>
        <translation>am rechten Rand</translation>
    </message>
</context>
<context>
    <name>calibration.rings_mirrored</name>
    <message>
        <source>%1 rings and dots fit the layout, mirrored</source>
        <translation>%1 Ringe und Punkte passen gespiegelt zur Anordnung</translation>
    </message>
</context>
<context>
    <name>calibration.same_as_other_camera</name>
    <message>
        <source>Camera &apos;%1&apos; sees the markers at the same pixels (to %2): check that the views are not swapped.</source>
        <translation>Kamera „%1“ sieht die Marker an denselben Pixeln (auf %2): prüfen, ob die Ansichten vertauscht sind.</translation>
    </message>
</context>
<context>
    <name>calibration.same_attitude</name>
    <message>
        <source>all %1 images show the board at nearly the same tilt, too little to determine the focal length</source>
        <translation>alle %1 Bilder zeigen die Tafel in fast derselben Lage, was die Brennweite nicht bestimmt</translation>
    </message>
</context>
<context>
    <name>calibration.same_tag_as</name>
    <message>
        <source>it names the same tag as &apos;%1&apos;</source>
        <translation>sie nennt dasselbe Tag wie &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.second_end_beyond</name>
    <message>
        <source>the second end is at or beyond the horizon of camera &apos;%1&apos;</source>
        <translation>das zweite Ende liegt am oder hinter dem Horizont der Kamera &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.see_same_floor</name>
    <message>
        <source>aim them at a common part of the floor</source>
        <translation>lassen Sie sie ein Stück gemeinsamen Bodens sehen</translation>
    </message>
</context>
<context>
    <name>calibration.seen_by_other_camera</name>
    <message>
        <source>camera &apos;%1&apos; sees the markers there, to %2: are the views swapped?</source>
        <translation>Kamera „%1“ sieht die Marker dort, auf %2: Sind die Ansichten vertauscht?</translation>
    </message>
</context>
<context>
    <name>calibration.sees_too_few_anywhere</name>
    <message>
        <source>at this height and field of view, no position within %1 of the markers shows four of them</source>
        <translation>bis %1 um die Marker herum sähe sie mit dieser Höhe und diesem Objektiv nirgends vier davon</translation>
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
        <translation>keine Benennung der %1 Ringe und Punkte passt zum Plan</translation>
    </message>
</context>
<context>
    <name>calibration.shared_points</name>
    <message>
        <source>%1 given</source>
        <translation>es gibt %1</translation>
    </message>
</context>
<context>
    <name>calibration.shorter</name>
    <message>
        <source>shorter</source>
        <translation>kürzer</translation>
    </message>
</context>
<context>
    <name>calibration.show_board_larger</name>
    <message>
        <source>show the board larger, sharp and well lit</source>
        <translation>zeigen Sie die Tafel größer, scharf und gut beleuchtet</translation>
    </message>
</context>
<context>
    <name>calibration.show_board_to_both</name>
    <message>
        <source>show the whole board to both cameras at once, in ten positions or more</source>
        <translation>zeigen Sie beiden Kameras zugleich die ganze Tafel, in zehn Lagen oder mehr</translation>
    </message>
</context>
<context>
    <name>calibration.show_everywhere</name>
    <message>
        <source>show the board in the middle and near each corner of the image, and closer</source>
        <translation>zeigen Sie die Tafel in der Mitte und nahe jeder Ecke des Bildes, und näher</translation>
    </message>
</context>
<context>
    <name>calibration.show_missing_tags</name>
    <message>
        <source>show the missing tags (AprilTag 36h11, numbered from 0 in the layout&apos;s order) or rings, or mark the markers by hand</source>
        <translation>zeigen Sie die fehlenden Tags (AprilTag 36h11, ab 0 in der Reihenfolge des Plans) oder Ringe, oder markieren Sie die Marker von Hand</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_of_board</name>
    <message>
        <source>show more of the board</source>
        <translation>zeigen Sie mehr von der Tafel</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_of_it</name>
    <message>
        <source>show more of it</source>
        <translation>zeigen Sie mehr davon</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_shapes</name>
    <message>
        <source>show more of them, larger or in better light, or mark the markers by hand</source>
        <translation>zeigen Sie mehr davon, größer oder bei besserem Licht, oder markieren Sie die Marker von Hand</translation>
    </message>
</context>
<context>
    <name>calibration.show_near_edges</name>
    <message>
        <source>show the board near its edges too.</source>
        <translation>zeigen Sie die Tafel auch nahe den Rändern.</translation>
    </message>
</context>
<context>
    <name>calibration.show_numbered_tags</name>
    <message>
        <source>show the missing tags (of one family, with the numbers of the labels) or rings, or mark the markers by hand</source>
        <translation>zeigen Sie die fehlenden Tags (einer Familie, mit den Nummern der Bezeichnungen) oder Ringe, oder markieren Sie die Marker von Hand</translation>
    </message>
</context>
<context>
    <name>calibration.show_one_charuco</name>
    <message>
        <source>show one ChArUco board</source>
        <translation>zeigen Sie eine ChArUco-Tafel</translation>
    </message>
</context>
<context>
    <name>calibration.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and well lit</source>
        <translation>zeigen Sie die ganze Tafel, flach, scharf und gut beleuchtet</translation>
    </message>
</context>
<context>
    <name>calibration.spread_markers</name>
    <message>
        <source>spread the markers over the floor</source>
        <translation>verteilen Sie die Marker über den Boden</translation>
    </message>
</context>
<context>
    <name>calibration.spread_or_register_better</name>
    <message>
        <source>spread the points over the floor, or register %1 better first</source>
        <translation>verteilen Sie die Punkte über den Boden, oder messen Sie zuerst %1 besser ein</translation>
    </message>
</context>
<context>
    <name>calibration.spread_points</name>
    <message>
        <source>spread the points over the floor, not along a line</source>
        <translation>verteilen Sie die Punkte über den Boden, nicht entlang einer Linie</translation>
    </message>
</context>
<context>
    <name>calibration.spread_them</name>
    <message>
        <source>spread them over the floor</source>
        <translation>verteilen Sie sie über den Boden</translation>
    </message>
</context>
<context>
    <name>calibration.squares_without_size</name>
    <message>
        <source>the squares have no size</source>
        <translation>die Felder haben keine Größe</translation>
    </message>
</context>
<context>
    <name>calibration.stand_higher</name>
    <message>
        <source>mount it higher or farther away, or choose a wider lens</source>
        <translation>stellen Sie die Kamera höher oder weiter weg, oder wählen Sie ein weiteres Objektiv</translation>
    </message>
</context>
<context>
    <name>calibration.standard</name>
    <message>
        <source>standard</source>
        <translation>Standard</translation>
    </message>
</context>
<context>
    <name>calibration.standard_lens</name>
    <message>
        <source>Standard lens</source>
        <translation>Standardobjektiv</translation>
    </message>
</context>
<context>
    <name>calibration.swap_pair</name>
    <message>
        <source>swap the images of the two cameras</source>
        <translation>vertauschen Sie die Bilder der beiden Kameras</translation>
    </message>
</context>
<context>
    <name>calibration.tag_seen_often</name>
    <message>
        <source>tag %1 (marker %2) appears %3 times</source>
        <translation>Tag %1 (Marker %2) ist %3-mal zu sehen</translation>
    </message>
</context>
<context>
    <name>calibration.tags_fit_by_place_too</name>
    <message>
        <source>the tags fit the layout by the numbers in its labels and, numbered from 0, by its order</source>
        <translation>die Tags passen zum Plan nach den Nummern in seinen Bezeichnungen und, ab 0 nummeriert, nach seiner Reihenfolge</translation>
    </message>
</context>
<context>
    <name>calibration.tags_fit_nowhere</name>
    <message>
        <source>tags with the layout&apos;s numbers are there (%1), but not at its positions</source>
        <translation>Tags mit den Nummern des Plans sind da (%1), aber nicht an seinen Positionen</translation>
    </message>
</context>
<context>
    <name>calibration.tags_mirrored</name>
    <message>
        <source>%1 tags were found, mirrored</source>
        <translation>%1 Tags wurden gespiegelt gefunden</translation>
    </message>
</context>
<context>
    <name>calibration.tags_of_two_families</name>
    <message>
        <source>tags of two families, %1 and %2, fit the layout</source>
        <translation>Tags zweier Familien, %1 und %2, passen zum Plan</translation>
    </message>
</context>
<context>
    <name>calibration.take_at_same_moment</name>
    <message>
        <source>check that the files belong together in this order and were taken at the same moments, and that both lens calibrations belong to these cameras</source>
        <translation>prüfen Sie, ob die Dateien in dieser Reihenfolge zusammengehören und zu denselben Zeitpunkten aufgenommen wurden, und ob beide Objektivkalibrierungen zu diesen Kameras gehören</translation>
    </message>
</context>
<context>
    <name>calibration.take_ten</name>
    <message>
        <source>take ten or more, the board tilted differently in each</source>
        <translation>machen Sie zehn oder mehr, die Tafel jedes Mal anders geneigt</translation>
    </message>
</context>
<context>
    <name>calibration.tape_sigma_not_positive</name>
    <message>
        <source>the σ of the tape measure is not above 0</source>
        <translation>das σ des Maßbands ist nicht größer als 0</translation>
    </message>
</context>
<context>
    <name>calibration.tell_by_hand</name>
    <message>
        <source>mark by hand which of them is %1</source>
        <translation>geben Sie von Hand an, welcher davon %1 ist</translation>
    </message>
</context>
<context>
    <name>calibration.tenths_of_mm</name>
    <message>
        <source>tenths of a mm</source>
        <translation>zehntel mm</translation>
    </message>
</context>
<context>
    <name>calibration.thousandths_of_mm</name>
    <message>
        <source>thousandths of a mm</source>
        <translation>tausendstel mm</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_board</name>
    <message>
        <source>take images with the board tilted by 30 to 45 degrees, to each side</source>
        <translation>machen Sie Bilder mit der um 30 bis 45 Grad geneigten Tafel, nach jeder Seite</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_less</name>
    <message>
        <source>tilt it by 30 to 45 degrees</source>
        <translation>neigen Sie sie um 30 bis 45 Grad</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_or_charuco</name>
    <message>
        <source>show it in more positions with different tilts, or use a ChArUco board</source>
        <translation>zeigen Sie sie in mehr Lagen mit verschiedenen Neigungen, oder nehmen Sie eine ChArUco-Tafel</translation>
    </message>
</context>
<context>
    <name>calibration.told_board_too_small</name>
    <message>
        <source>a board of %1 inner corners is too small</source>
        <translation>eine Tafel mit %1 inneren Ecken ist zu klein</translation>
    </message>
</context>
<context>
    <name>calibration.told_length_not_positive</name>
    <message>
        <source>the entered length is not above 0</source>
        <translation>die angegebene Länge ist nicht größer als 0</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_corners</name>
    <message>
        <source>it has %1 corners of the board, six are needed</source>
        <translation>es zeigt %1 Ecken der Tafel, sechs werden gebraucht</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_found_again</name>
    <message>
        <source>%1 of its %2 markers were found again, two are needed</source>
        <translation>%1 ihrer %2 Marker wurden wiedergefunden, zwei sind nötig</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_pictures</name>
    <message>
        <source>calibration needs three images of the board, %1 can be used</source>
        <translation>drei Bilder der Tafel sind nötig, %1 sind brauchbar</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_shapes</name>
    <message>
        <source>%1 rings or dots were found, four are needed</source>
        <translation>%1 Ringe oder Punkte wurden gefunden, vier sind nötig</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_to_compare</name>
    <message>
        <source>too few images to compare it with other models</source>
        <translation>zu wenige Bilder, um es mit anderen zu vergleichen</translation>
    </message>
</context>
<context>
    <name>calibration.too_frontal</name>
    <message>
        <source>the board faces the camera too directly</source>
        <translation>die Tafel ist zu sehr von vorn zu sehen</translation>
    </message>
</context>
<context>
    <name>calibration.too_small_for_board</name>
    <message>
        <source>the image is too small for a board</source>
        <translation>das Bild ist zu klein für eine Tafel</translation>
    </message>
</context>
<context>
    <name>calibration.two_cameras_needed</name>
    <message>
        <source>layout &apos;%2&apos; has %1 registered camera, two are needed</source>
        <translation>auf dem Plan &apos;%2&apos; gibt es %1 Kamera, zwei sind nötig</translation>
    </message>
</context>
<context>
    <name>calibration.two_directions</name>
    <message>
        <source>both an angle and a pair of markers were given for X</source>
        <translation>für X wurden ein Winkel und ein Paar Marker angegeben</translation>
    </message>
</context>
<context>
    <name>calibration.two_focal_lengths</name>
    <message>
        <source>the images do not agree on one focal length</source>
        <translation>die Bilder verlangen zwei Brennweiten</translation>
    </message>
</context>
<context>
    <name>calibration.two_origins</name>
    <message>
        <source>both a marker and a point were given for the origin</source>
        <translation>für den Ursprung wurden ein Marker und ein Punkt angegeben</translation>
    </message>
</context>
<context>
    <name>calibration.typical_testbed</name>
    <message>
        <source>a %1 × %2 floor seen from %3 above</source>
        <translation>einem Boden von %1 × %2, gesehen aus %3 Höhe</translation>
    </message>
</context>
<context>
    <name>calibration.u_outside</name>
    <message>
        <source>u = %1 of marker %2 is outside the image of %3</source>
        <translation>u = %1 von Marker %2 ist außerhalb des Bildes von %3</translation>
    </message>
</context>
<context>
    <name>calibration.u_v_swapped</name>
    <message>
        <source>with u and v swapped they fit to %1: are these columns swapped?</source>
        <translation>mit vertauschtem u und v passen sie auf %1: Sind diese Spalten vertauscht?</translation>
    </message>
</context>
<context>
    <name>calibration.uncertain</name>
    <message>
        <source>Uncertain: %1.</source>
        <translation>Zweifelhaft: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.unit</name>
    <message>
        <source>unit &apos;%1&apos;</source>
        <translation>Einheit &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.unit_unknown</name>
    <message>
        <source>it is not known</source>
        <translation>das ist nicht bekannt</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_corner</name>
    <message>
        <source>The middle is out of view, ±%1 in the corner near %2.</source>
        <translation>Die Mitte ist nicht zu sehen, ±%1 in der Ecke bei %2.</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_edge</name>
    <message>
        <source>The middle is out of view, ±%1 at the edge near %2.</source>
        <translation>Die Mitte ist nicht zu sehen, ±%1 am Rand bei %2.</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_near</name>
    <message>
        <source>The middle is out of view, ±%1 near %2.</source>
        <translation>Die Mitte ist nicht zu sehen, ±%1 bei %2.</translation>
    </message>
</context>
<context>
    <name>calibration.usable</name>
    <message>
        <source>Usable: %1.</source>
        <translation>Brauchbar: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.use_camera_picture</name>
    <message>
        <source>use an image from the camera</source>
        <translation>verwenden Sie ein Bild der Kamera</translation>
    </message>
</context>
<context>
    <name>calibration.use_camera_pictures</name>
    <message>
        <source>use images from the camera</source>
        <translation>verwenden Sie Bilder der Kamera</translation>
    </message>
</context>
<context>
    <name>calibration.use_known_unit</name>
    <message>
        <source>use mm, cm, m or inch</source>
        <translation>verwenden Sie mm, cm, m oder inch</translation>
    </message>
</context>
<context>
    <name>calibration.use_one_camera</name>
    <message>
        <source>use images of one camera at one zoom and focus</source>
        <translation>verwenden Sie Bilder einer Kamera mit einem Zoom und Fokus</translation>
    </message>
</context>
<context>
    <name>calibration.use_one_resolution</name>
    <message>
        <source>use images of one camera at one resolution</source>
        <translation>verwenden Sie Bilder einer Kamera mit einer Auflösung</translation>
    </message>
</context>
<context>
    <name>calibration.usual_lens</name>
    <message>
        <source>the images leave it open, so square pixels, an optical centre near the middle and a usual distortion were assumed</source>
        <translation>die Bilder lassen es offen, deshalb wurden quadratische Pixel, eine optische Mitte nahe der Bildmitte und eine übliche Verzeichnung angenommen</translation>
    </message>
</context>
<context>
    <name>calibration.v_from_below</name>
    <message>
        <source>v = %1 - v fits to %2: is v counted from below?</source>
        <translation>v = %1 - v passt auf %2: Zählt v von unten?</translation>
    </message>
</context>
<context>
    <name>calibration.v_outside</name>
    <message>
        <source>v = %1 of marker %2 is outside the image of %3</source>
        <translation>v = %1 von Marker %2 ist außerhalb des Bildes von %3</translation>
    </message>
</context>
<context>
    <name>calibration.were_kept</name>
    <message>
        <source>they were kept</source>
        <translation>sie wurden behalten</translation>
    </message>
</context>
<context>
    <name>calibration.whether_moved</name>
    <message>
        <source>cannot determine whether %1 has moved</source>
        <translation>ob sich %1 bewegt hat, ist nicht zu sagen</translation>
    </message>
</context>
<context>
    <name>calibration.without_it_centre</name>
    <message>
        <source>Check %1: without it the optical centre moves by %2.</source>
        <translation>Sehen Sie %1 an: Ohne dieses Bild verschiebt sich die optische Mitte um %2.</translation>
    </message>
</context>
<context>
    <name>calibration.without_it_focal</name>
    <message>
        <source>Check %1: without it the focal length changes by %2.</source>
        <translation>Sehen Sie %1 an: Ohne dieses Bild ändert sich die Brennweite um %2.</translation>
    </message>
</context>
<context>
    <name>calibration.write_tags_as</name>
    <message>
        <source>write a tag as 100 or 36h11:100, its corner as 100.tl, the middle of two as 12+13</source>
        <translation>schreiben Sie ein Tag als 100 oder 36h11:100, seine Ecke als 100.tl, die Mitte von zweien als 12+13</translation>
    </message>
</context>
<context>
    <name>calibration.wrong_by_more</name>
    <message>
        <source>it may be wrong by much more</source>
        <translation>der Fehler kann viel größer sein</translation>
    </message>
</context>
<context>
    <name>calibration.x_without_length</name>
    <message>
        <source>the two markers for the X axis have the same position</source>
        <translation>die Marker, entlang derer X verlaufen soll, liegen an einer Stelle</translation>
    </message>
</context>
<context>
    <name>calibration.y_left_of_x</name>
    <message>
        <source>seen from above, Y must point to the left of X</source>
        <translation>von oben gesehen muss Y nach links von X zeigen</translation>
    </message>
</context>
<context>
    <name>capture.access_to_cameras</name>
    <message>
        <source>Access to cameras</source>
        <translation>Zugriff auf Kameras</translation>
    </message>
</context>
<context>
    <name>capture.all_pictures_damaged</name>
    <message>
        <source>all its frames arrive damaged</source>
        <translation>alle Bilder kommen beschädigt an</translation>
    </message>
</context>
<context>
    <name>capture.answers_but_silent</name>
    <message>
        <source>it answers but sends no frames</source>
        <translation>sie antwortet, sendet aber keine Bilder</translation>
    </message>
</context>
<context>
    <name>capture.answers_but_silent_advice</name>
    <message>
        <source>check its trigger and this computer&apos;s firewall</source>
        <translation>prüfen Sie den Auslöser und die Firewall dieses Computers</translation>
    </message>
</context>
<context>
    <name>capture.aravis_place_missing</name>
    <message>
        <source>it contains neither an address nor a serial number</source>
        <translation>darin steht weder eine Adresse noch eine Seriennummer</translation>
    </message>
</context>
<context>
    <name>capture.aravis_wishes</name>
    <message>
        <source>use rate, exposure_ms, gain, format, size, trigger=software, packet_size or packet_delay_us, as in ?rate=30&amp;size=640x480</source>
        <translation>verwenden Sie rate, exposure_ms, gain, format, size, trigger=software, packet_size oder packet_delay_us, etwa ?rate=30&amp;size=640x480</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_less</name>
    <message>
        <source>choose a smaller size or a lower rate</source>
        <translation>verlangen Sie eine kleinere Größe oder Rate</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_other_mode</name>
    <message>
        <source>choose another size or format</source>
        <translation>verlangen Sie eine andere Größe oder ein anderes Format</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_something_else</name>
    <message>
        <source>use another value, or leave the choice to the camera</source>
        <translation>verlangen Sie etwas anderes, oder überlassen Sie es der Kamera</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_usable_format</name>
    <message>
        <source>choose one of %1</source>
        <translation>verlangen Sie eines von %1</translation>
    </message>
</context>
<context>
    <name>capture.ask_within_sensor</name>
    <message>
        <source>choose a size within that</source>
        <translation>verlangen Sie eine Größe innerhalb davon</translation>
    </message>
</context>
<context>
    <name>capture.automatics_held</name>
    <message>
        <source>exposure, gain, white balance and focus are held</source>
        <translation>Belichtung, Verstärkung, Weißabgleich und Fokus sind festgehalten</translation>
    </message>
</context>
<context>
    <name>capture.automatics_of_camera</name>
    <message>
        <source>Automatic settings, camera %1</source>
        <translation>Automatik, Kamera %1</translation>
    </message>
</context>
<context>
    <name>capture.buffer_enough</name>
    <message>
        <source>up to %1, enough for network cameras</source>
        <translation>bis %1, genug für Netzwerkkameras</translation>
    </message>
</context>
<context>
    <name>capture.buffer_not_known</name>
    <message>
        <source>the system does not report its maximum size (net.core.rmem_max)</source>
        <translation>das System sagt nicht, wie groß er sein darf (net.core.rmem_max)</translation>
    </message>
</context>
<context>
    <name>capture.buffer_small</name>
    <message>
        <source>only %1</source>
        <translation>nur %1</translation>
    </message>
</context>
<context>
    <name>capture.buffer_without_use</name>
    <message>
        <source>%1, too small only for network cameras</source>
        <translation>%1, nur für Netzwerkkameras zu wenig</translation>
    </message>
</context>
<context>
    <name>capture.bus_of_speed_shared</name>
    <message>
        <source>cameras %1 share the bus %2, of %3</source>
        <translation>die Kameras %1 teilen den Bus %2 mit %3</translation>
    </message>
</context>
<context>
    <name>capture.bus_shared</name>
    <message>
        <source>cameras %1 share the bus %2</source>
        <translation>die Kameras %1 teilen den Bus %2</translation>
    </message>
</context>
<context>
    <name>capture.came_back_changed</name>
    <message>
        <source>it came back with another frame size or format</source>
        <translation>sie kam mit Bildern anderer Größe oder anderen Formats wieder</translation>
    </message>
</context>
<context>
    <name>capture.camera_at_address</name>
    <message>
        <source>camera %1</source>
        <translation>Kamera %1</translation>
    </message>
</context>
<context>
    <name>capture.camera_does_not_deliver</name>
    <message>
        <source>a camera sends no frames</source>
        <translation>eine Kamera liefert nicht</translation>
    </message>
</context>
<context>
    <name>capture.cameras_are_listed</name>
    <message>
        <source>odograph cameras lists them</source>
        <translation>„Kameras…“ unter Aufnahme zeigt sie</translation>
    </message>
</context>
<context>
    <name>capture.cameras_will_lose</name>
    <message>
        <source>%1 will lose frames</source>
        <translation>%1 werden Bilder verlieren</translation>
    </message>
</context>
<context>
    <name>capture.cannot_be_opened</name>
    <message>
        <source>it cannot be opened (%1)</source>
        <translation>sie kann nicht geöffnet werden (%1)</translation>
    </message>
</context>
<context>
    <name>capture.check_cable</name>
    <message>
        <source>check its cable</source>
        <translation>prüfen Sie das Kabel</translation>
    </message>
</context>
<context>
    <name>capture.check_cable_and_address</name>
    <message>
        <source>check its cable and address</source>
        <translation>prüfen Sie Kabel und Adresse</translation>
    </message>
</context>
<context>
    <name>capture.check_cable_and_network</name>
    <message>
        <source>check its cable and the network</source>
        <translation>prüfen Sie das Kabel und das Netz</translation>
    </message>
</context>
<context>
    <name>capture.check_power_and_cable</name>
    <message>
        <source>check its power and cable</source>
        <translation>prüfen Sie Strom und Kabel</translation>
    </message>
</context>
<context>
    <name>capture.check_power_and_network</name>
    <message>
        <source>check its power and cable, and that this computer has an address in the camera&apos;s network</source>
        <translation>prüfen Sie Strom und Kabel, und dass dieser Rechner eine Adresse im Netz der Kamera hat</translation>
    </message>
</context>
<context>
    <name>capture.check_usb_rights</name>
    <message>
        <source>check that you may use it (a udev rule), and that no other program does</source>
        <translation>prüfen Sie, ob Sie sie benutzen dürfen (eine udev-Regel) und kein anderes Programm es tut</translation>
    </message>
</context>
<context>
    <name>capture.choose_another_value</name>
    <message>
        <source>choose another one</source>
        <translation>wählen Sie einen anderen</translation>
    </message>
</context>
<context>
    <name>capture.choose_listed</name>
    <message>
        <source>choose a camera that odograph cameras lists</source>
        <translation>wählen Sie eine Kamera, die „Kameras…“ unter Aufnahme zeigt</translation>
    </message>
</context>
<context>
    <name>capture.choose_of_offer</name>
    <message>
        <source>choose one that it offers</source>
        <translation>wählen Sie aus ihrem Angebot</translation>
    </message>
</context>
<context>
    <name>capture.choose_value_between</name>
    <message>
        <source>choose a value between</source>
        <translation>wählen Sie einen Wert dazwischen</translation>
    </message>
</context>
<context>
    <name>capture.close_that_program</name>
    <message>
        <source>close that program</source>
        <translation>schließen Sie jenes Programm</translation>
    </message>
</context>
<context>
    <name>capture.connect_right_camera</name>
    <message>
        <source>reconnect the original camera, or start over with this one</source>
        <translation>schließen Sie die richtige an, oder beginnen Sie mit dieser neu</translation>
    </message>
</context>
<context>
    <name>capture.control_automatic</name>
    <message>
        <source>%1 cannot be set while it is automatic</source>
        <translation>%1 kann nicht eingestellt werden, solange es automatisch ist</translation>
    </message>
</context>
<context>
    <name>capture.control_goes</name>
    <message>
        <source>%1 ranges from %2 to %3</source>
        <translation>%1 geht von %2 bis %3</translation>
    </message>
</context>
<context>
    <name>capture.control_inactive</name>
    <message>
        <source>%1 cannot be set in the camera&apos;s current mode</source>
        <translation>%1 kann jetzt nicht eingestellt werden</translation>
    </message>
</context>
<context>
    <name>capture.control_not_taken</name>
    <message>
        <source>it rejects this value for %1 (%2)</source>
        <translation>dieser Wert von %1 wird nicht angenommen (%2)</translation>
    </message>
</context>
<context>
    <name>capture.control_value_refused</name>
    <message>
        <source>it rejects this value of %1</source>
        <translation>sie lehnt diesen Wert von %1 ab</translation>
    </message>
</context>
<context>
    <name>capture.damaged_advice</name>
    <message>
        <source>try another cable or port, or choose a lower rate or a smaller frame size</source>
        <translation>versuchen Sie ein anderes Kabel oder einen anderen Anschluss, oder verlangen Sie weniger oder kleinere Bilder</translation>
    </message>
</context>
<context>
    <name>capture.dim_light_halves_rate</name>
    <message>
        <source>in dim light a camera halves its rate unless its automatic exposure is off</source>
        <translation>bei wenig Licht halbiert eine Kamera ihre Rate von selbst, wenn die Belichtungsautomatik nicht aus ist</translation>
    </message>
</context>
<context>
    <name>capture.disk_full</name>
    <message>
        <source>its disk has only %1 left, of which %2 are kept free</source>
        <translation>auf der Platte sind nur noch %1 frei, von denen %2 frei bleiben sollen</translation>
    </message>
</context>
<context>
    <name>capture.disk_of</name>
    <message>
        <source>the disk of %1</source>
        <translation>die Platte von %1</translation>
    </message>
</context>
<context>
    <name>capture.disk_too_slow</name>
    <message>
        <source>it is too slow</source>
        <translation>sie ist zu langsam</translation>
    </message>
</context>
<context>
    <name>capture.does_not_answer</name>
    <message>
        <source>it does not answer</source>
        <translation>sie antwortet nicht</translation>
    </message>
</context>
<context>
    <name>capture.does_not_start</name>
    <message>
        <source>it does not start (%1)</source>
        <translation>sie startet nicht (%1)</translation>
    </message>
</context>
<context>
    <name>capture.does_not_start_advice</name>
    <message>
        <source>check its cable, and that no other program uses it</source>
        <translation>prüfen Sie ihr Kabel, und dass kein anderes Programm sie benutzt</translation>
    </message>
</context>
<context>
    <name>capture.end_other_writers</name>
    <message>
        <source>stop other programs that write to it</source>
        <translation>beenden Sie, was sonst darauf schreibt</translation>
    </message>
</context>
<context>
    <name>capture.enlarge_buffer</name>
    <message>
        <source>sudo sysctl -w net.core.rmem_max=%1, and add the same line to /etc/sysctl.d/ to keep it</source>
        <translation>sudo sysctl -w net.core.rmem_max=%1, und dasselbe nach /etc/sysctl.d/, damit es bleibt</translation>
    </message>
</context>
<context>
    <name>capture.expose_for_mains</name>
    <message>
        <source>expose for 10 or 20 ms with mains of 50 Hz, 8.3 or 16.7 ms with 60 Hz</source>
        <translation>belichten Sie 10 oder 20 ms bei 50 Hz Netzfrequenz, 8,3 oder 16,7 ms bei 60 Hz</translation>
    </message>
</context>
<context>
    <name>capture.exposed_for</name>
    <message>
        <source>exposed for %1</source>
        <translation>%1 belichtet</translation>
    </message>
</context>
<context>
    <name>capture.exposure_and_gain</name>
    <message>
        <source>Exposure and gain</source>
        <translation>Belichtung und Verstärkung</translation>
    </message>
</context>
<context>
    <name>capture.exposure_not_taken</name>
    <message>
        <source>it rejects this exposure (%1)</source>
        <translation>sie nimmt diese Belichtung nicht an (%1)</translation>
    </message>
</context>
<context>
    <name>capture.exposure_not_told</name>
    <message>
        <source>it does not report its exposure</source>
        <translation>sie nennt ihre Belichtung nicht</translation>
    </message>
</context>
<context>
    <name>capture.exposure_suits_lamps</name>
    <message>
        <source>exposed for %1, which suits lamps</source>
        <translation>%1 belichtet, das passt zu Lampen</translation>
    </message>
</context>
<context>
    <name>capture.failed</name>
    <message>
        <source>it failed (%1)</source>
        <translation>sie ist ausgefallen (%1)</translation>
    </message>
</context>
<context>
    <name>capture.failed_advice</name>
    <message>
        <source>if this continues, unplug it and plug it in again</source>
        <translation>ziehen Sie sie ab und stecken Sie sie neu ein, wenn das anhält</translation>
    </message>
</context>
<context>
    <name>capture.flicker_filter_off</name>
    <message>
        <source>its filter is off</source>
        <translation>ihr Filter ist aus</translation>
    </message>
</context>
<context>
    <name>capture.flicker_filtered</name>
    <message>
        <source>filtered by the camera (%1)</source>
        <translation>von der Kamera gefiltert (%1)</translation>
    </message>
</context>
<context>
    <name>capture.flicker_of_camera</name>
    <message>
        <source>Lamp flicker, camera %1</source>
        <translation>Lampenflimmern, Kamera %1</translation>
    </message>
</context>
<context>
    <name>capture.forbidden</name>
    <message>
        <source>you may not use it</source>
        <translation>Sie dürfen sie nicht benutzen</translation>
    </message>
</context>
<context>
    <name>capture.forbidden_advice</name>
    <message>
        <source>join the group video (sudo usermod -aG video YOUR-NAME) and log in again</source>
        <translation>treten Sie der Gruppe video bei (sudo usermod -aG video YOUR-NAME) und melden Sie sich neu an</translation>
    </message>
</context>
<context>
    <name>capture.format</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
</context>
<context>
    <name>capture.format_not_told</name>
    <message>
        <source>it does not report its pixel format (%1)</source>
        <translation>sie sagt ihr Pixelformat nicht (%1)</translation>
    </message>
</context>
<context>
    <name>capture.format_not_understood</name>
    <message>
        <source>its pixel format is not supported</source>
        <translation>das Pixelformat wird nicht verstanden</translation>
    </message>
</context>
<context>
    <name>capture.free_after_crash</name>
    <message>
        <source>a camera whose program has crashed is free again after some seconds</source>
        <translation>eine Kamera, deren Programm abgestürzt ist, ist nach einigen Sekunden wieder frei</translation>
    </message>
</context>
<context>
    <name>capture.gain_not_taken</name>
    <message>
        <source>it rejects this gain (%1)</source>
        <translation>sie nimmt diese Verstärkung nicht an (%1)</translation>
    </message>
</context>
<context>
    <name>capture.give_address</name>
    <message>
        <source>give one as v4l2:/dev/video0, aravis:192.168.1.20, sim:A or file:PATH</source>
        <translation>geben Sie eine an wie v4l2:/dev/video0, aravis:192.168.1.20, sim:A oder file:PATH</translation>
    </message>
</context>
<context>
    <name>capture.give_aravis_place</name>
    <message>
        <source>give one as aravis:192.168.1.20 or aravis:SERIAL</source>
        <translation>geben Sie eine an, etwa aravis:192.168.1.20 oder aravis:SERIAL</translation>
    </message>
</context>
<context>
    <name>capture.gives_no_pictures</name>
    <message>
        <source>%1 sends no frames</source>
        <translation>%1 liefert keine Bilder</translation>
    </message>
</context>
<context>
    <name>capture.has_been_away</name>
    <message>
        <source>the connection was lost</source>
        <translation>die Verbindung war unterbrochen</translation>
    </message>
</context>
<context>
    <name>capture.held_while_recording</name>
    <message>
        <source>they are held while recording</source>
        <translation>sie werden bei der Aufnahme festgehalten</translation>
    </message>
</context>
<context>
    <name>capture.in_step</name>
    <message>
        <source>synchronised to %1</source>
        <translation>synchron auf %1</translation>
    </message>
</context>
<context>
    <name>capture.in_step_as_way</name>
    <message>
        <source>at %1 that is %2</source>
        <translation>bei %1 sind das %2</translation>
    </message>
</context>
<context>
    <name>capture.join_video_group</name>
    <message>
        <source>add yourself to the group video (sudo usermod -aG video $USER), then log out and in again</source>
        <translation>nehmen Sie sich in die Gruppe video auf (sudo usermod -aG video $USER), dann melden Sie sich ab und wieder an</translation>
    </message>
</context>
<context>
    <name>capture.keep_awake</name>
    <message>
        <source>keep it awake while it records</source>
        <translation>lassen Sie ihn während der Aufnahme nicht schlafen</translation>
    </message>
</context>
<context>
    <name>capture.kept_before_sleep</name>
    <message>
        <source>the recording up to then is kept</source>
        <translation>was vorher kam, ist erhalten</translation>
    </message>
</context>
<context>
    <name>capture.large_packets</name>
    <message>
        <source>large packets are allowed</source>
        <translation>große Pakete sind erlaubt</translation>
    </message>
</context>
<context>
    <name>capture.largest_picture</name>
    <message>
        <source>its frames have at most %1 pixels</source>
        <translation>die Bilder haben höchstens %1 Pixel</translation>
    </message>
</context>
<context>
    <name>capture.leave_control_out</name>
    <message>
        <source>leave it out</source>
        <translation>lassen Sie es weg</translation>
    </message>
</context>
<context>
    <name>capture.look_again</name>
    <message>
        <source>wait a few seconds, then check again</source>
        <translation>warten Sie einige Sekunden und sehen Sie wieder nach</translation>
    </message>
</context>
<context>
    <name>capture.look_at_cable</name>
    <message>
        <source>check its cable</source>
        <translation>sehen Sie nach dem Kabel</translation>
    </message>
</context>
<context>
    <name>capture.lost_by_slow_machine</name>
    <message>
        <source>%1, %2 lost because this machine is too slow</source>
        <translation>%1, %2 verloren, weil dieser Rechner zu langsam ist</translation>
    </message>
</context>
<context>
    <name>capture.lost_here</name>
    <message>
        <source>%1, %2 lost here</source>
        <translation>%1, %2 hier verloren</translation>
    </message>
</context>
<context>
    <name>capture.lost_on_wire</name>
    <message>
        <source>%1, %2 lost on the wire</source>
        <translation>%1, %2 auf der Leitung verloren</translation>
    </message>
</context>
<context>
    <name>capture.lost_on_wire_and_here</name>
    <message>
        <source>%1, %2 lost (%3 on the wire, %4 here)</source>
        <translation>%1, %2 verloren (%3 auf der Leitung, %4 hier)</translation>
    </message>
</context>
<context>
    <name>capture.machine_slept</name>
    <message>
        <source>it slept for %1 and recorded nothing meanwhile</source>
        <translation>er schlief %1, und inzwischen wurde nichts aufgenommen</translation>
    </message>
</context>
<context>
    <name>capture.make_room</name>
    <message>
        <source>free some disk space, or move the project to another disk</source>
        <translation>schaffen Sie Platz, oder legen Sie das Projekt auf eine andere Platte</translation>
    </message>
</context>
<context>
    <name>capture.mode_not_taken</name>
    <message>
        <source>it rejects %1</source>
        <translation>sie nimmt %1 nicht an</translation>
    </message>
</context>
<context>
    <name>capture.no_automatics</name>
    <message>
        <source>it has none</source>
        <translation>sie hat keine</translation>
    </message>
</context>
<context>
    <name>capture.no_network_camera</name>
    <message>
        <source>no network camera is used</source>
        <translation>keine Netzwerkkamera wird benutzt</translation>
    </message>
</context>
<context>
    <name>capture.no_node</name>
    <message>
        <source>this computer has no USB or built-in camera (/dev/video*)</source>
        <translation>dieser Rechner zeigt keine USB- oder eingebaute Kamera (/dev/video*)</translation>
    </message>
</context>
<context>
    <name>capture.no_node_advice</name>
    <message>
        <source>if one is connected, try another cable and port, without a hub</source>
        <translation>wenn eine angeschlossen ist, versuchen Sie ein anderes Kabel und einen anderen Anschluss, ohne Hub</translation>
    </message>
</context>
<context>
    <name>capture.no_pair_yet</name>
    <message>
        <source>no frames of the cameras have been paired yet</source>
        <translation>noch wurden keine zwei Bilder zusammen aufgenommen</translation>
    </message>
</context>
<context>
    <name>capture.no_picture_came</name>
    <message>
        <source>no frame arrived for half a second</source>
        <translation>eine halbe Sekunde lang kam kein Bild</translation>
    </message>
</context>
<context>
    <name>capture.no_picture_for</name>
    <message>
        <source>no frame has arrived for %1</source>
        <translation>seit %1 kam kein Bild</translation>
    </message>
</context>
<context>
    <name>capture.no_readable_format</name>
    <message>
        <source>it offers no supported format</source>
        <translation>sie hat kein lesbares Format</translation>
    </message>
</context>
<context>
    <name>capture.no_simulated_camera</name>
    <message>
        <source>simulated camera %1 does not exist</source>
        <translation>es gibt keine simulierte Kamera %1</translation>
    </message>
</context>
<context>
    <name>capture.no_software_trigger</name>
    <message>
        <source>it has no software trigger (%1)</source>
        <translation>sie hat keinen Software-Auslöser (%1)</translation>
    </message>
</context>
<context>
    <name>capture.no_such_address</name>
    <message>
        <source>no kind of camera has an address like this</source>
        <translation>keine Kamera hat eine solche Adresse</translation>
    </message>
</context>
<context>
    <name>capture.no_such_control</name>
    <message>
        <source>it has no setting &apos;%1&apos;</source>
        <translation>sie hat nichts namens &apos;%1&apos;, das eingestellt werden könnte</translation>
    </message>
</context>
<context>
    <name>capture.no_such_format</name>
    <message>
        <source>it has no format %1 (%2)</source>
        <translation>ein Format %1 hat sie nicht (%2)</translation>
    </message>
</context>
<context>
    <name>capture.no_usable_format</name>
    <message>
        <source>it offers no supported pixel format</source>
        <translation>sie hat kein Pixelformat, das verstanden wird</translation>
    </message>
</context>
<context>
    <name>capture.no_usb_camera</name>
    <message>
        <source>no USB camera is used</source>
        <translation>keine USB-Kamera wird benutzt</translation>
    </message>
</context>
<context>
    <name>capture.nodes_forbidden</name>
    <message>
        <source>you may not use %1</source>
        <translation>Sie dürfen %1 nicht benutzen</translation>
    </message>
</context>
<context>
    <name>capture.nodes_usable</name>
    <message>
        <source>you may use all %1 video devices</source>
        <translation>Sie dürfen alle %1 Videogeräte benutzen</translation>
    </message>
</context>
<context>
    <name>capture.none_lost</name>
    <message>
        <source>%1, none lost</source>
        <translation>%1, keine verloren</translation>
    </message>
</context>
<context>
    <name>capture.not_offered</name>
    <message>
        <source>it does not offer the requested mode</source>
        <translation>sie bietet das Verlangte nicht an</translation>
    </message>
</context>
<context>
    <name>capture.not_registered</name>
    <message>
        <source>it is not registered to the floor</source>
        <translation>sie ist nicht eingemessen</translation>
    </message>
</context>
<context>
    <name>capture.not_there</name>
    <message>
        <source>it is not connected</source>
        <translation>sie ist nicht da</translation>
    </message>
</context>
<context>
    <name>capture.nothing_lost_yet</name>
    <message>
        <source>nothing is lost yet</source>
        <translation>noch ist nichts verloren</translation>
    </message>
</context>
<context>
    <name>capture.one_camera_in_step</name>
    <message>
        <source>a single camera needs no synchronisation</source>
        <translation>eine Kamera ist immer synchron</translation>
    </message>
</context>
<context>
    <name>capture.one_not_held</name>
    <message>
        <source>%1 still adjusts automatically</source>
        <translation>%1 ändert sich weiter von selbst</translation>
    </message>
</context>
<context>
    <name>capture.open_video_again</name>
    <message>
        <source>open it again to see it from the start</source>
        <translation>öffnen Sie es neu, um es von Anfang an zu sehen</translation>
    </message>
</context>
<context>
    <name>capture.other_camera_in_place</name>
    <message>
        <source>another camera (%1) has replaced it</source>
        <translation>an ihrem Platz ist eine andere Kamera (%1)</translation>
    </message>
</context>
<context>
    <name>capture.other_serial_in_place</name>
    <message>
        <source>another camera (%1) has replaced camera %2</source>
        <translation>an der Stelle der Kamera %2 ist eine andere (%1)</translation>
    </message>
</context>
<context>
    <name>capture.own_usb_buses</name>
    <message>
        <source>each USB camera has its own bus</source>
        <translation>jede USB-Kamera hat einen eigenen Bus</translation>
    </message>
</context>
<context>
    <name>capture.packet_delay_not_taken</name>
    <message>
        <source>it rejects this packet delay (%1)</source>
        <translation>sie nimmt diese Paketverzögerung nicht an (%1)</translation>
    </message>
</context>
<context>
    <name>capture.packet_size</name>
    <message>
        <source>Packet size</source>
        <translation>Paketgröße</translation>
    </message>
</context>
<context>
    <name>capture.packet_size_not_taken</name>
    <message>
        <source>it rejects this packet size (%1)</source>
        <translation>sie nimmt diese Paketgröße nicht an (%1)</translation>
    </message>
</context>
<context>
    <name>capture.part_not_understood</name>
    <message>
        <source>&apos;%1&apos; is not valid</source>
        <translation>&apos;%1&apos; ist nicht verständlich</translation>
    </message>
</context>
<context>
    <name>capture.payload_not_told</name>
    <message>
        <source>it does not report how many bytes a frame has (%1)</source>
        <translation>sie sagt nicht, wie groß ihre Bilder sind (%1)</translation>
    </message>
</context>
<context>
    <name>capture.picture_of_camera</name>
    <message>
        <source>a frame of camera %1</source>
        <translation>ein Bild der Kamera %1</translation>
    </message>
</context>
<context>
    <name>capture.picture_size_of_camera</name>
    <message>
        <source>Frame size, camera %1</source>
        <translation>Bildgröße, Kamera %1</translation>
    </message>
</context>
<context>
    <name>capture.picture_waits_for_disk</name>
    <message>
        <source>a frame has waited %1; the write buffer is %2 full</source>
        <translation>ein Bild hat %1 gewartet, und %2 des Platzes zum Warten sind belegt</translation>
    </message>
</context>
<context>
    <name>capture.pictures_being_lost</name>
    <message>
        <source>frames are being lost</source>
        <translation>Bilder gehen verloren</translation>
    </message>
</context>
<context>
    <name>capture.pictures_incomplete</name>
    <message>
        <source>its frames arrive incomplete</source>
        <translation>die Bilder kommen unvollständig an</translation>
    </message>
</context>
<context>
    <name>capture.pictures_may_pulse</name>
    <message>
        <source>brightness may pulse under lamps</source>
        <translation>Bilder können unter Lampen pulsieren</translation>
    </message>
</context>
<context>
    <name>capture.pictures_without_size</name>
    <message>
        <source>its frames have no size</source>
        <translation>die Bilder haben keine Größe</translation>
    </message>
</context>
<context>
    <name>capture.plug_camera_in_again</name>
    <message>
        <source>plug %1 in again</source>
        <translation>schließen Sie %1 wieder an</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_again</name>
    <message>
        <source>plug it in again</source>
        <translation>schließen Sie sie wieder an</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_or_choose</name>
    <message>
        <source>plug it in, or choose a camera that odograph cameras lists</source>
        <translation>schließen Sie sie an, oder wählen Sie eine von denen, die „Kameras…“ unter Aufnahme zeigt</translation>
    </message>
</context>
<context>
    <name>capture.put_disk_back</name>
    <message>
        <source>reconnect its disk, or move its folder back</source>
        <translation>bringen Sie den Datenträger oder Ordner wieder dorthin, wo er war</translation>
    </message>
</context>
<context>
    <name>capture.rate_not_taken</name>
    <message>
        <source>it rejects this rate (%1)</source>
        <translation>sie nimmt diese Rate nicht an (%1)</translation>
    </message>
</context>
<context>
    <name>capture.rate_too_slow</name>
    <message>
        <source>%1 (too slow)</source>
        <translation>%1 (zu langsam)</translation>
    </message>
</context>
<context>
    <name>capture.rates_differ</name>
    <message>
        <source>the cameras run at %1 and %2</source>
        <translation>die Kameras laufen mit %1 und %2</translation>
    </message>
</context>
<context>
    <name>capture.receive_buffer</name>
    <message>
        <source>Receive buffer</source>
        <translation>Empfangspuffer</translation>
    </message>
</context>
<context>
    <name>capture.receive_buffer_granted</name>
    <message>
        <source>the system keeps only %1 of the network&apos;s packets</source>
        <translation>das System puffert nur %1 der Netzwerkpakete</translation>
    </message>
</context>
<context>
    <name>capture.record_elsewhere</name>
    <message>
        <source>record to another disk, or use fewer cameras</source>
        <translation>nehmen Sie auf eine andere Platte auf, oder mit weniger Kameras</translation>
    </message>
</context>
<context>
    <name>capture.recorded_is_kept</name>
    <message>
        <source>what was recorded so far is kept</source>
        <translation>was bisher aufgenommen wurde, ist erhalten</translation>
    </message>
</context>
<context>
    <name>capture.recorded_is_there</name>
    <message>
        <source>it holds what was recorded so far</source>
        <translation>was bisher aufgenommen wurde, ist dort</translation>
    </message>
</context>
<context>
    <name>capture.recording_file_gone</name>
    <message>
        <source>its file is no longer there</source>
        <translation>ihre Datei ist nicht mehr da</translation>
    </message>
</context>
<context>
    <name>capture.register_in_testbed</name>
    <message>
        <source>register it in Testbed; Odograph needs this to measure where a robot is</source>
        <translation>messen Sie sie im Messplatz ein, sonst können ihre Bilder nicht sagen, wo ein Roboter ist</translation>
    </message>
</context>
<context>
    <name>capture.room_for</name>
    <message>
        <source>remaining recording time %1</source>
        <translation>verbleibende Aufnahmezeit %1</translation>
    </message>
</context>
<context>
    <name>capture.see_own_line</name>
    <message>
        <source>see the line of that camera</source>
        <translation>siehe ihre eigene Zeile</translation>
    </message>
</context>
<context>
    <name>capture.send_less</name>
    <message>
        <source>or set both to MJPEG or to a smaller frame size</source>
        <translation>oder lassen Sie beide MJPEG oder kleinere Bilder senden</translation>
    </message>
</context>
<context>
    <name>capture.send_registered_size</name>
    <message>
        <source>set it to the size it was registered at, or calibrate and register it again</source>
        <translation>lassen Sie sie die Größe der Einmessung senden, oder kalibrieren und messen Sie sie neu ein</translation>
    </message>
</context>
<context>
    <name>capture.sends_no_pictures</name>
    <message>
        <source>it sends no frames</source>
        <translation>sie sendet keine Bilder</translation>
    </message>
</context>
<context>
    <name>capture.serial_advice</name>
    <message>
        <source>check its power and cable; odograph cameras lists those that answer</source>
        <translation>prüfen Sie Strom und Kabel; „Kameras…“ unter Aufnahme zeigt die, die antworten</translation>
    </message>
</context>
<context>
    <name>capture.serial_does_not_answer</name>
    <message>
        <source>no camera of this serial number answers</source>
        <translation>keine Kamera mit dieser Seriennummer antwortet</translation>
    </message>
</context>
<context>
    <name>capture.set_as_before</name>
    <message>
        <source>restore its settings, or start over with size and format in its address</source>
        <translation>stellen Sie sie wie vorher ein, oder beginnen Sie neu mit Größe und Format in ihrer Adresse</translation>
    </message>
</context>
<context>
    <name>capture.set_between</name>
    <message>
        <source>set it to something between</source>
        <translation>stellen Sie etwas dazwischen ein</translation>
    </message>
</context>
<context>
    <name>capture.set_rate_or_trigger</name>
    <message>
        <source>set both to the same rate, or trigger them together</source>
        <translation>stellen Sie beide auf eine Rate, oder lösen Sie sie gemeinsam aus</translation>
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
        <translation>stellen Sie &apos;%1&apos; auf Ihr Stromnetz</translation>
    </message>
</context>
<context>
    <name>capture.set_to_one_rate</name>
    <message>
        <source>set both to the same rate</source>
        <translation>stellen Sie beide auf eine Rate</translation>
    </message>
</context>
<context>
    <name>capture.set_to_something_else</name>
    <message>
        <source>set another value</source>
        <translation>stellen Sie etwas anderes ein</translation>
    </message>
</context>
<context>
    <name>capture.set_width_and_height</name>
    <message>
        <source>set its width and height</source>
        <translation>stellen Sie Breite und Höhe ein</translation>
    </message>
</context>
<context>
    <name>capture.several_not_held</name>
    <message>
        <source>%1 still adjust automatically</source>
        <translation>%1 ändern sich weiter von selbst</translation>
    </message>
</context>
<context>
    <name>capture.simulated_camera</name>
    <message>
        <source>Simulated camera %1</source>
        <translation>Simulierte Kamera %1</translation>
    </message>
</context>
<context>
    <name>capture.size_as_registered</name>
    <message>
        <source>%1, as it was registered</source>
        <translation>%1, wie sie eingemessen wurde</translation>
    </message>
</context>
<context>
    <name>capture.size_not_as_registered</name>
    <message>
        <source>%1, but registered at %2</source>
        <translation>%1, aber bei %2 eingemessen</translation>
    </message>
</context>
<context>
    <name>capture.size_not_taken</name>
    <message>
        <source>it rejects this size (%1)</source>
        <translation>sie nimmt diese Größe nicht an (%1)</translation>
    </message>
</context>
<context>
    <name>capture.size_not_told</name>
    <message>
        <source>it does not report its width and height (%1)</source>
        <translation>sie sagt ihre Größe nicht (%1)</translation>
    </message>
</context>
<context>
    <name>capture.slow_camera</name>
    <message>
        <source>it delivers only %1 frames per second instead of the requested %2</source>
        <translation>sie nimmt nur %1 Bilder je Sekunde von den verlangten %2</translation>
    </message>
</context>
<context>
    <name>capture.slow_camera_advice</name>
    <message>
        <source>give it more light or a shorter exposure, or ask for a lower rate</source>
        <translation>geben Sie ihr mehr Licht oder eine kürzere Belichtung, oder verlangen Sie eine kleinere Rate</translation>
    </message>
</context>
<context>
    <name>capture.small_packets</name>
    <message>
        <source>small packets on %1</source>
        <translation>kleine Pakete auf %1</translation>
    </message>
</context>
<context>
    <name>capture.small_packets_advice</name>
    <message>
        <source>set the MTU of the camera&apos;s network port to 9000 (sudo ip link set dev NAME mtu 9000), if camera and switch support it</source>
        <translation>geben Sie dem Anschluss der Kamera eine MTU von 9000 (sudo ip link set dev NAME mtu 9000), wenn Kamera und Switch es zulassen</translation>
    </message>
</context>
<context>
    <name>capture.step</name>
    <message>
        <source>Synchronisation</source>
        <translation>Synchronität</translation>
    </message>
</context>
<context>
    <name>capture.take_another_camera</name>
    <message>
        <source>use another camera</source>
        <translation>nehmen Sie eine andere Kamera</translation>
    </message>
</context>
<context>
    <name>capture.take_camera_with_format</name>
    <message>
        <source>use a camera that offers one of %1</source>
        <translation>nehmen Sie eine Kamera mit einem von %1</translation>
    </message>
</context>
<context>
    <name>capture.take_off_and_on</name>
    <message>
        <source>unplug it and plug it in again if this continues</source>
        <translation>ziehen Sie sie ab und stecken Sie sie wieder an, wenn es so bleibt</translation>
    </message>
</context>
<context>
    <name>capture.take_simulated_camera</name>
    <message>
        <source>use sim:A or sim:B</source>
        <translation>nehmen Sie sim:A oder sim:B</translation>
    </message>
</context>
<context>
    <name>capture.taken_up_by_itself</name>
    <message>
        <source>Odograph reconnects automatically</source>
        <translation>danach geht es von selbst weiter</translation>
    </message>
</context>
<context>
    <name>capture.the_picture</name>
    <message>
        <source>the frame</source>
        <translation>das Bild</translation>
    </message>
</context>
<context>
    <name>capture.the_recording</name>
    <message>
        <source>the recording %1</source>
        <translation>die Aufnahme %1</translation>
    </message>
</context>
<context>
    <name>capture.there_but_silent</name>
    <message>
        <source>it is connected but sends no frames</source>
        <translation>sie ist da, sendet aber keine Bilder</translation>
    </message>
</context>
<context>
    <name>capture.there_but_silent_advice</name>
    <message>
        <source>check its cable; if this continues, plug it in again</source>
        <translation>sehen Sie nach dem Kabel, oder stecken Sie sie neu ein, wenn das anhält</translation>
    </message>
</context>
<context>
    <name>capture.these_and_others</name>
    <message>
        <source>%1 and others</source>
        <translation>%1 und andere</translation>
    </message>
</context>
<context>
    <name>capture.this_computer</name>
    <message>
        <source>this computer</source>
        <translation>dieser Rechner</translation>
    </message>
</context>
<context>
    <name>capture.turn_automatic_off</name>
    <message>
        <source>turn automatic mode off</source>
        <translation>schalten Sie die Automatik aus</translation>
    </message>
</context>
<context>
    <name>capture.turn_off_at_camera</name>
    <message>
        <source>turn it off in the camera&apos;s own program, or keep the light steady while robots run</source>
        <translation>schalten Sie es im Programm der Kamera aus, oder halten Sie das Licht gleichmäßig, während Roboter fahren</translation>
    </message>
</context>
<context>
    <name>capture.turn_off_automatic_first</name>
    <message>
        <source>first turn off the automatic mode that controls it</source>
        <translation>schalten Sie zuerst die Automatik aus, die es verstellt</translation>
    </message>
</context>
<context>
    <name>capture.unplugged</name>
    <message>
        <source>it was unplugged</source>
        <translation>sie wurde abgezogen</translation>
    </message>
</context>
<context>
    <name>capture.usb_bus_full</name>
    <message>
        <source>its USB bus has no bandwidth left for its frames (the bus is full, not the disk)</source>
        <translation>ihr USB-Bus hat keinen Platz mehr für ihre Bilder (der Bus ist voll, nicht der Datenträger)</translation>
    </message>
</context>
<context>
    <name>capture.usb_bus_full_advice</name>
    <message>
        <source>plug it into a port whose bus no other camera uses, or choose MJPEG, a smaller frame size or a lower rate (?format=MJPG&amp;size=640x480&amp;rate=30)</source>
        <translation>schließen Sie sie an einem eigenen Bus an, oder wählen Sie MJPEG, ein kleineres Bild oder eine kleinere Rate (?format=MJPG&amp;size=640x480&amp;rate=30)</translation>
    </message>
</context>
<context>
    <name>capture.usb_buses</name>
    <message>
        <source>USB buses</source>
        <translation>USB-Busse</translation>
    </message>
</context>
<context>
    <name>capture.use_daylight</name>
    <message>
        <source>or use daylight</source>
        <translation>oder nutzen Sie Tageslicht</translation>
    </message>
</context>
<context>
    <name>capture.use_other_port</name>
    <message>
        <source>plug one into a port on the other side of the computer, or into its own USB card</source>
        <translation>stecken Sie eine an einen Anschluss auf der anderen Seite des Rechners oder an eine eigene Karte</translation>
    </message>
</context>
<context>
    <name>capture.used_by_another_program</name>
    <message>
        <source>another program uses it</source>
        <translation>ein anderes Programm benutzt sie</translation>
    </message>
</context>
<context>
    <name>capture.used_by_program</name>
    <message>
        <source>another program uses it (open in %1)</source>
        <translation>ein anderes Programm benutzt sie (geöffnet in %1)</translation>
    </message>
</context>
<context>
    <name>capture.usual_mains</name>
    <message>
        <source>50 Hz in most countries, 60 Hz in the Americas</source>
        <translation>50 Hz in den meisten Ländern, 60 Hz in Amerika</translation>
    </message>
</context>
<context>
    <name>capture.v4l2_address_example</name>
    <message>
        <source>write it like v4l2:/dev/video0?size=1280x720&amp;rate=30&amp;format=MJPG</source>
        <translation>schreiben Sie zum Beispiel v4l2:/dev/video0?size=1280x720&amp;rate=30&amp;format=MJPG</translation>
    </message>
</context>
<context>
    <name>capture.video_has_ended</name>
    <message>
        <source>the video has ended</source>
        <translation>das Video ist zu Ende</translation>
    </message>
</context>
<context>
    <name>capture.wait_for_it</name>
    <message>
        <source>wait: Odograph is reconnecting</source>
        <translation>warten Sie: es geht von selbst weiter</translation>
    </message>
</context>
<context>
    <name>capture.wait_or_check_cable</name>
    <message>
        <source>wait, or check its cable</source>
        <translation>warten Sie, oder prüfen Sie ihr Kabel</translation>
    </message>
</context>
<context>
    <name>capture.waiting_for_first_picture</name>
    <message>
        <source>waiting for the first frame</source>
        <translation>wartet auf das erste Bild</translation>
    </message>
</context>
<context>
    <name>exchange.accepted</name>
    <message>
        <source>Accepted: %1</source>
        <translation>Akzeptiert: %1</translation>
    </message>
</context>
<context>
    <name>exchange.and_lines_more</name>
    <message>
        <source>and %1 more lines</source>
        <translation>und %1 weitere Zeilen</translation>
    </message>
</context>
<context>
    <name>exchange.archive_library_refused</name>
    <message>
        <source>the archive library failed</source>
        <translation>die Archivbibliothek hat es abgelehnt</translation>
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
        <translation>Bodenachsen: %1 der Datei</translation>
    </message>
</context>
<context>
    <name>exchange.axes_seen</name>
    <message>
        <source>floor axes: %1 of the file, as its %2 stays near %3</source>
        <translation>Bodenachsen: %1 der Datei, da deren %2 nahe %3 bleibt</translation>
    </message>
</context>
<context>
    <name>exchange.axes_unclear</name>
    <message>
        <source>its z varies by %1 while its %2 stays near %3</source>
        <translation>ihr z ändert sich um %1, während ihr %2 nahe %3 bleibt</translation>
    </message>
</context>
<context>
    <name>exchange.begin_roster</name>
    <message>
        <source>begin the file with the line class,team or class,team,pseudonym</source>
        <translation>beginnen Sie die Datei mit der Zeile class,team oder class,team,pseudonym</translation>
    </message>
</context>
<context>
    <name>exchange.begin_with_header_or_tum</name>
    <message>
        <source>begin the file with the line %1, or write lines of %2</source>
        <translation>beginnen Sie die Datei mit der Zeile %1, oder schreiben Sie Zeilen aus %2</translation>
    </message>
</context>
<context>
    <name>exchange.begin_with_line</name>
    <message>
        <source>begin the file with the line %1</source>
        <translation>beginnen Sie die Datei mit der Zeile %1</translation>
    </message>
</context>
<context>
    <name>exchange.break_opened</name>
    <message>
        <source>its positions jump by %1 in line %2 and go on from there: %3 positions around count as not measured, and the path ends at the jump</source>
        <translation>ihre Positionen springen in Zeile %2 um %1 und gehen von dort weiter: %3 Positionen ringsum gelten als nicht gemessen, und der Weg endet am Sprung</translation>
    </message>
</context>
<context>
    <name>exchange.breaks_too_often</name>
    <message>
        <source>its positions jump %1 times and go on from elsewhere</source>
        <translation>ihre Positionen springen %1-mal und gehen anderswo weiter</translation>
    </message>
</context>
<context>
    <name>exchange.cell_not_a_number</name>
    <message>
        <source>%1 &apos;%2&apos; is not a finite number</source>
        <translation>%1 &apos;%2&apos; ist keine endliche Zahl</translation>
    </message>
</context>
<context>
    <name>exchange.cell_of_columns</name>
    <message>
        <source>it has %1 cell where the header has %2</source>
        <translation>%1 Zelle, die Kopfzeile hat %2</translation>
    </message>
</context>
<context>
    <name>exchange.cells_of_columns</name>
    <message>
        <source>it has %1 cells where the header has %2</source>
        <translation>%1 Zellen, die Kopfzeile hat %2</translation>
    </message>
</context>
<context>
    <name>exchange.centre_impossible</name>
    <message>
        <source>the image centre (%1, %2) is far outside the image of %3 × %4 pixels</source>
        <translation>die Bildmitte (%1, %2) liegt weit außerhalb des Bildes von %3 × %4 Pixeln</translation>
    </message>
</context>
<context>
    <name>exchange.check_both_units</name>
    <message>
        <source>choose the units of its times and positions</source>
        <translation>wählen Sie die Einheiten ihrer Zeiten und Positionen</translation>
    </message>
</context>
<context>
    <name>exchange.check_it_is_there</name>
    <message>
        <source>check that it exists and that you may read it</source>
        <translation>prüfen Sie, ob sie da ist und gelesen werden darf</translation>
    </message>
</context>
<context>
    <name>exchange.check_one_run</name>
    <message>
        <source>check that all lines are of one run</source>
        <translation>prüfen Sie, ob alle Zeilen von einer Fahrt sind</translation>
    </message>
</context>
<context>
    <name>exchange.check_right_file</name>
    <message>
        <source>check that it is the right file</source>
        <translation>prüfen Sie, ob es die richtige Datei ist</translation>
    </message>
</context>
<context>
    <name>exchange.check_track_column</name>
    <message>
        <source>check which column says the track of a line</source>
        <translation>prüfen Sie, welche Spalte die Bahn einer Zeile nennt</translation>
    </message>
</context>
<context>
    <name>exchange.check_unit_of_places</name>
    <message>
        <source>check the unit of the positions: m, cm or mm</source>
        <translation>prüfen Sie die Einheit der Orte: m, cm oder mm</translation>
    </message>
</context>
<context>
    <name>exchange.check_unit_of_times</name>
    <message>
        <source>check the unit of the times, and that all lines are of one run</source>
        <translation>prüfen Sie die Einheit der Zeiten, und ob alle Zeilen von einer Fahrt sind</translation>
    </message>
</context>
<context>
    <name>exchange.choose_axes</name>
    <message>
        <source>choose the axes of the floor: %1, or xy if that is right</source>
        <translation>wählen Sie die Bodenachsen: %1, oder xy, wenn das stimmt</translation>
    </message>
</context>
<context>
    <name>exchange.choose_axes_xy</name>
    <message>
        <source>choose the axes x and y</source>
        <translation>wählen Sie die Achsen x und y</translation>
    </message>
</context>
<context>
    <name>exchange.choose_column</name>
    <message>
        <source>choose from %1</source>
        <translation>wählen Sie aus %1</translation>
    </message>
</context>
<context>
    <name>exchange.choose_decimal_sign</name>
    <message>
        <source>choose its decimal sign: point or comma</source>
        <translation>wählen Sie ihr Dezimalzeichen: Punkt oder Komma</translation>
    </message>
</context>
<context>
    <name>exchange.choose_entry</name>
    <message>
        <source>choose one of them</source>
        <translation>wählen Sie eine davon</translation>
    </message>
</context>
<context>
    <name>exchange.choose_likely_unit</name>
    <message>
        <source>choose their unit: m, cm, mm, in, ft or px; %1 is likely</source>
        <translation>wählen Sie ihre Einheit: m, cm, mm, in, ft oder px; wahrscheinlich %1</translation>
    </message>
</context>
<context>
    <name>exchange.choose_longer_track</name>
    <message>
        <source>choose a file with three positions or more</source>
        <translation>wählen Sie eine Datei mit drei oder mehr Orten</translation>
    </message>
</context>
<context>
    <name>exchange.choose_new_folder</name>
    <message>
        <source>choose a folder that does not exist yet</source>
        <translation>wählen Sie einen Ordner, den es noch nicht gibt</translation>
    </message>
</context>
<context>
    <name>exchange.choose_packed_file</name>
    <message>
        <source>choose a file that Odograph has packed; if it is damaged, copy it again</source>
        <translation>wählen Sie eine Datei, die Odograph gepackt hat, und kopieren Sie sie neu, wenn sie beschädigt ist</translation>
    </message>
</context>
<context>
    <name>exchange.choose_style</name>
    <message>
        <source>choose analysis, international or continental</source>
        <translation>wählen Sie analysis, international oder continental</translation>
    </message>
</context>
<context>
    <name>exchange.choose_time_unit</name>
    <message>
        <source>choose their unit: s, ms, us, ns, min, h, d or frame; %1 is likely</source>
        <translation>wählen Sie ihre Einheit: s, ms, us, ns, min, h, d oder frame; wahrscheinlich %1</translation>
    </message>
</context>
<context>
    <name>exchange.choose_unit</name>
    <message>
        <source>choose their unit: m, cm, mm, in, ft or px</source>
        <translation>wählen Sie ihre Einheit: m, cm, mm, in, ft oder px</translation>
    </message>
</context>
<context>
    <name>exchange.close_quotes</name>
    <message>
        <source>close the quotes</source>
        <translation>schließen Sie die Anführungszeichen</translation>
    </message>
</context>
<context>
    <name>exchange.closed_neither</name>
    <message>
        <source>&apos;closed&apos; is neither true nor false</source>
        <translation>&apos;closed&apos; ist weder true noch false</translation>
    </message>
</context>
<context>
    <name>exchange.coefficients_no_row</name>
    <message>
        <source>&apos;distortion_coefficients&apos; is neither a row nor a column</source>
        <translation>&apos;distortion_coefficients&apos; ist weder Zeile noch Spalte</translation>
    </message>
</context>
<context>
    <name>exchange.column_twice</name>
    <message>
        <source>it is named twice</source>
        <translation>sie ist zweimal genannt</translation>
    </message>
</context>
<context>
    <name>exchange.commas_group_thousands</name>
    <message>
        <source>commas separate thousands</source>
        <translation>Kommas trennen Tausender</translation>
    </message>
</context>
<context>
    <name>exchange.confidence_not_used</name>
    <message>
        <source>its confidences are neither from 0 to 1 nor from 0 to 100, and were not used</source>
        <translation>ihre Konfidenzen liegen weder zwischen 0 und 1 noch zwischen 0 und 100 und wurden nicht verwendet</translation>
    </message>
</context>
<context>
    <name>exchange.csv_column</name>
    <message>
        <source>column &apos;%1&apos; of CSV</source>
        <translation>CSV-Spalte &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.csv_style</name>
    <message>
        <source>style &apos;%1&apos; of CSV</source>
        <translation>CSV-Stil &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.cut_line_left_out</name>
    <message>
        <source>the last line, line %1, was left out, because it ends too early</source>
        <translation>die letzte Zeile, Zeile %1, wurde weggelassen, weil sie zu früh endet</translation>
    </message>
</context>
<context>
    <name>exchange.does_not_belong</name>
    <message>
        <source>&apos;%1&apos; does not belong in a packed project</source>
        <translation>&apos;%1&apos; gehört nicht in ein gepacktes Projekt</translation>
    </message>
</context>
<context>
    <name>exchange.entry_is_missing</name>
    <message>
        <source>the entry &apos;%1&apos; is missing</source>
        <translation>der Eintrag &apos;%1&apos; fehlt</translation>
    </message>
</context>
<context>
    <name>exchange.file_too_large</name>
    <message>
        <source>it is larger than %1</source>
        <translation>größer als %1</translation>
    </message>
</context>
<context>
    <name>exchange.fill_in_all_cells</name>
    <message>
        <source>give each line as many cells as the header</source>
        <translation>geben Sie jeder Zeile so viele Zellen wie der Kopfzeile</translation>
    </message>
</context>
<context>
    <name>exchange.fill_in_both</name>
    <message>
        <source>fill in both or none</source>
        <translation>füllen Sie beide oder keines aus</translation>
    </message>
</context>
<context>
    <name>exchange.focal_impossible</name>
    <message>
        <source>no lens has a focal length of %1 at %2 × %3 pixels</source>
        <translation>kein Objektiv hat bei %2 × %3 Pixeln eine Brennweite von %1</translation>
    </message>
</context>
<context>
    <name>exchange.format_has_pixels</name>
    <message>
        <source>%1 writes positions in pixels, which are no lengths</source>
        <translation>%1 schreibt Positionen in Pixeln, und die sind keine Längen</translation>
    </message>
</context>
<context>
    <name>exchange.frame_without_time</name>
    <message>
        <source>it has no time that can be read</source>
        <translation>sie hat keine lesbare Zeit</translation>
    </message>
</context>
<context>
    <name>exchange.frames_without_rate</name>
    <message>
        <source>it has frame numbers in place of times</source>
        <translation>sie hat Bildnummern statt Zeiten</translation>
    </message>
</context>
<context>
    <name>exchange.give_known_units</name>
    <message>
        <source>give times in s or ms and positions in m, cm or mm</source>
        <translation>geben Sie Zeiten in s oder ms und Orte in m, cm oder mm an</translation>
    </message>
</context>
<context>
    <name>exchange.give_lower_confidence</name>
    <message>
        <source>give a lower least confidence</source>
        <translation>geben Sie eine kleinere Mindestkonfidenz an</translation>
    </message>
</context>
<context>
    <name>exchange.give_marker_label</name>
    <message>
        <source>give each marker a label</source>
        <translation>geben Sie jedem Marker eine Bezeichnung</translation>
    </message>
</context>
<context>
    <name>exchange.give_one_path</name>
    <message>
        <source>give one of points_mm, circle, figure_eight or slalom</source>
        <translation>geben Sie points_mm, circle, figure_eight oder slalom an</translation>
    </message>
</context>
<context>
    <name>exchange.give_one_zone</name>
    <message>
        <source>give all corners in order as corners_mm, or two opposite corners as rectangle_mm</source>
        <translation>geben Sie corners_mm ringsherum an, oder zwei gegenüberliegende Ecken als rectangle_mm</translation>
    </message>
</context>
<context>
    <name>exchange.give_pixel_length</name>
    <message>
        <source>give how long a pixel is on the floor, or choose another unit of the positions</source>
        <translation>geben Sie an, wie lang ein Pixel auf dem Boden ist, oder wählen Sie eine andere Einheit der Positionen</translation>
    </message>
</context>
<context>
    <name>exchange.give_point_label</name>
    <message>
        <source>give each point a label</source>
        <translation>geben Sie jedem Punkt eine Bezeichnung</translation>
    </message>
</context>
<context>
    <name>exchange.give_rate</name>
    <message>
        <source>give the frame rate of the camera</source>
        <translation>geben Sie die Bildrate der Kamera an</translation>
    </message>
</context>
<context>
    <name>exchange.give_two_corners</name>
    <message>
        <source>give two opposite corners: [[x, y], [x, y]]</source>
        <translation>geben Sie zwei gegenüberliegende Ecken an: [[x, y], [x, y]]</translation>
    </message>
</context>
<context>
    <name>exchange.has_become_shorter</name>
    <message>
        <source>it has become shorter during packing</source>
        <translation>inzwischen kürzer geworden</translation>
    </message>
</context>
<context>
    <name>exchange.held_left_out</name>
    <message>
        <source>%1 positions that only repeat the last one count as not measured; the first is in line %2</source>
        <translation>%1 Positionen, die nur die letzte wiederholen, gelten als nicht gemessen; die erste steht in Zeile %2</translation>
    </message>
</context>
<context>
    <name>exchange.is_in_it_twice</name>
    <message>
        <source>it contains &apos;%1&apos; twice</source>
        <translation>&apos;%1&apos; ist zweimal darin</translation>
    </message>
</context>
<context>
    <name>exchange.is_no_utf8</name>
    <message>
        <source>it is not a UTF-8 text file</source>
        <translation>es ist keine UTF-8-Textdatei</translation>
    </message>
</context>
<context>
    <name>exchange.is_utf16</name>
    <message>
        <source>it is written in UTF-16</source>
        <translation>in UTF-16 geschrieben</translation>
    </message>
</context>
<context>
    <name>exchange.is_xml</name>
    <message>
        <source>it is written in XML</source>
        <translation>in XML geschrieben</translation>
    </message>
</context>
<context>
    <name>exchange.key_is_no_text</name>
    <message>
        <source>a key is not text, or a bracket is not closed</source>
        <translation>ein Schlüssel ist kein Text, oder eine Klammer ist nicht geschlossen</translation>
    </message>
</context>
<context>
    <name>exchange.key_is_there_twice</name>
    <message>
        <source>the key &apos;%1&apos; appears twice</source>
        <translation>den Schlüssel &apos;%1&apos; gibt es zweimal</translation>
    </message>
</context>
<context>
    <name>exchange.key_not_known</name>
    <message>
        <source>the key &apos;%1&apos; is not known</source>
        <translation>der Schlüssel &apos;%1&apos; ist nicht bekannt</translation>
    </message>
</context>
<context>
    <name>exchange.label_is_empty</name>
    <message>
        <source>the label is empty</source>
        <translation>die Bezeichnung ist leer</translation>
    </message>
</context>
<context>
    <name>exchange.label_is_there</name>
    <message>
        <source>line %2 already has the label &apos;%1&apos;</source>
        <translation>die Bezeichnung &apos;%1&apos; steht schon in Zeile %2</translation>
    </message>
</context>
<context>
    <name>exchange.lacks_column</name>
    <message>
        <source>it lacks the column %1</source>
        <translation>die Spalte %1 fehlt</translation>
    </message>
</context>
<context>
    <name>exchange.lacks_header</name>
    <message>
        <source>it lacks the expected header line</source>
        <translation>die erwartete Kopfzeile fehlt</translation>
    </message>
</context>
<context>
    <name>exchange.leave_out_confidence</name>
    <message>
        <source>leave out the least confidence</source>
        <translation>lassen Sie die kleinste Konfidenz weg</translation>
    </message>
</context>
<context>
    <name>exchange.leave_out_rate</name>
    <message>
        <source>leave out the frame rate</source>
        <translation>lassen Sie die Bildrate weg</translation>
    </message>
</context>
<context>
    <name>exchange.lens_model_not_known</name>
    <message>
        <source>the lens model &apos;%1&apos; is unknown (known models: plumb_bob, rational_polynomial, equidistant)</source>
        <translation>das Objektivmodell &apos;%1&apos; ist nicht bekannt (plumb_bob, rational_polynomial, equidistant sind es)</translation>
    </message>
</context>
<context>
    <name>exchange.line_too_long</name>
    <message>
        <source>it is longer than 8 MiB</source>
        <translation>sie ist länger als 8 MiB</translation>
    </message>
</context>
<context>
    <name>exchange.line_without_class</name>
    <message>
        <source>line %1 has no class for team &apos;%2&apos;</source>
        <translation>Zeile %1 hat keine Klasse zum Team &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.line_without_team</name>
    <message>
        <source>line %1 has no team</source>
        <translation>Zeile %1 hat kein Team</translation>
    </message>
</context>
<context>
    <name>exchange.longer_than_a_week</name>
    <message>
        <source>it is more than a week after the first line</source>
        <translation>das ist mehr als eine Woche nach der ersten Zeile</translation>
    </message>
</context>
<context>
    <name>exchange.marks_left_out</name>
    <message>
        <source>%1 positions that only mark a lost robot (such as 0, 0) count as not measured; the first is in line %2</source>
        <translation>%1 Positionen, die nur einen verlorenen Roboter kennzeichnen (etwa 0, 0), gelten als nicht gemessen; die erste steht in Zeile %2</translation>
    </message>
</context>
<context>
    <name>exchange.matrix_not_3_by_3</name>
    <message>
        <source>&apos;camera_matrix&apos; is not a 3 × 3 matrix</source>
        <translation>&apos;camera_matrix&apos; ist keine 3 × 3-Matrix</translation>
    </message>
</context>
<context>
    <name>exchange.matrix_of_other_form</name>
    <message>
        <source>&apos;camera_matrix&apos; is not of the form fx 0 cx, 0 fy cy, 0 0 1</source>
        <translation>&apos;camera_matrix&apos; hat nicht die Form fx 0 cx, 0 fy cy, 0 0 1</translation>
    </message>
</context>
<context>
    <name>exchange.measured_otherwise</name>
    <message>
        <source>It was analysed with a different course than its task has now.</source>
        <translation>Er wurde nach einem anderen Parcours ausgewertet, als seine Aufgabe jetzt hat.</translation>
    </message>
</context>
<context>
    <name>exchange.mend_lines</name>
    <message>
        <source>correct these lines</source>
        <translation>bessern Sie diese Zeilen aus</translation>
    </message>
</context>
<context>
    <name>exchange.name_column_once</name>
    <message>
        <source>name each column once</source>
        <translation>nennen Sie jede Spalte einmal</translation>
    </message>
</context>
<context>
    <name>exchange.named_track_has_position</name>
    <message>
        <source>track &apos;%1&apos; has %2 position</source>
        <translation>Spur &apos;%1&apos; hat %2 Ort</translation>
    </message>
</context>
<context>
    <name>exchange.named_track_has_positions</name>
    <message>
        <source>track &apos;%1&apos; has %2 positions</source>
        <translation>Spur &apos;%1&apos; hat %2 Orte</translation>
    </message>
</context>
<context>
    <name>exchange.neither_header_nor_tum</name>
    <message>
        <source>it has no header with a time, x and y, and it is not a TUM file</source>
        <translation>eine Kopfzeile mit Zeit, x und y fehlt, und TUM ist es auch nicht</translation>
    </message>
</context>
<context>
    <name>exchange.nested_too_deep</name>
    <message>
        <source>it is nested more than %1 deep</source>
        <translation>die Verschachtelung ist tiefer als %1</translation>
    </message>
</context>
<context>
    <name>exchange.no_anchors</name>
    <message>
        <source>anchors and aliases are not supported</source>
        <translation>Anker und Verweise werden nicht verstanden</translation>
    </message>
</context>
<context>
    <name>exchange.no_confidence</name>
    <message>
        <source>it has no column of confidences</source>
        <translation>sie hat keine Spalte mit Konfidenzen</translation>
    </message>
</context>
<context>
    <name>exchange.no_list_of_numbers</name>
    <message>
        <source>&apos;%1&apos; is not a list of numbers</source>
        <translation>&apos;%1&apos; ist keine Liste von Zahlen</translation>
    </message>
</context>
<context>
    <name>exchange.no_markers</name>
    <message>
        <source>no markers follow the header</source>
        <translation>unter der Kopfzeile stehen keine Marker</translation>
    </message>
</context>
<context>
    <name>exchange.no_project_inside</name>
    <message>
        <source>it contains no project</source>
        <translation>darin ist kein Projekt</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_column</name>
    <message>
        <source>this column does not exist</source>
        <translation>diese Spalte gibt es nicht</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_entry</name>
    <message>
        <source>it holds no camera &apos;%1&apos;, but %2</source>
        <translation>sie enthält keine Kamera „%1“, sondern %2</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_style</name>
    <message>
        <source>this style does not exist</source>
        <translation>diesen Stil gibt es nicht</translation>
    </message>
</context>
<context>
    <name>exchange.no_task</name>
    <message>
        <source>the file holds no task</source>
        <translation>die Datei enthält keine Aufgabe</translation>
    </message>
</context>
<context>
    <name>exchange.no_third_axis</name>
    <message>
        <source>it has no third coordinate</source>
        <translation>sie hat keine dritte Koordinate</translation>
    </message>
</context>
<context>
    <name>exchange.no_time_column</name>
    <message>
        <source>no column of it is called a time</source>
        <translation>keine ihrer Spalten heißt wie eine Zeit</translation>
    </message>
</context>
<context>
    <name>exchange.no_track_has_position</name>
    <message>
        <source>none of its tracks has a position</source>
        <translation>keine der Spuren hat einen Ort</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_toml</name>
    <message>
        <source>it is not valid TOML (%1)</source>
        <translation>sie ist kein gültiges TOML (%1)</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_yaml</name>
    <message>
        <source>it is not valid YAML (%1)</source>
        <translation>es ist kein gültiges YAML (%1)</translation>
    </message>
</context>
<context>
    <name>exchange.none_sure_enough</name>
    <message>
        <source>none of its positions has a confidence of %1</source>
        <translation>keine ihrer Positionen hat eine Konfidenz von %1</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_finite_number</name>
    <message>
        <source>&apos;%1&apos; is not a finite number</source>
        <translation>&apos;%1&apos; ist keine endliche Zahl</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_list</name>
    <message>
        <source>&apos;%1&apos; is not a list in brackets</source>
        <translation>&apos;%1&apos; ist keine Liste in eckigen Klammern</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_point</name>
    <message>
        <source>&apos;%1&apos; is not a point [x, y] in mm</source>
        <translation>&apos;%1&apos; ist kein Punkt [x, y] in mm</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_time</name>
    <message>
        <source>&apos;%1&apos; is not a time</source>
        <translation>&apos;%1&apos; ist keine Zeit</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_whole_number</name>
    <message>
        <source>&apos;%1&apos; is not a whole number from %2 to %3</source>
        <translation>&apos;%1&apos; ist keine ganze Zahl von %2 bis %3</translation>
    </message>
</context>
<context>
    <name>exchange.not_above_zero</name>
    <message>
        <source>&apos;%1&apos; is not above zero</source>
        <translation>&apos;%1&apos; ist nicht größer als null</translation>
    </message>
</context>
<context>
    <name>exchange.not_two_corners</name>
    <message>
        <source>&apos;rectangle_mm&apos; is not two corners</source>
        <translation>&apos;rectangle_mm&apos; hat nicht zwei Ecken</translation>
    </message>
</context>
<context>
    <name>exchange.nothing_imported</name>
    <message>
        <source>nothing was imported</source>
        <translation>nichts wurde importiert</translation>
    </message>
</context>
<context>
    <name>exchange.number_in_two_ways</name>
    <message>
        <source>its numbers can be read in two ways: &apos;%1&apos; with three decimals, or as %2</source>
        <translation>ihre Zahlen lassen sich auf zwei Arten lesen: &apos;%1&apos; mit drei Nachkommastellen oder als %2</translation>
    </message>
</context>
<context>
    <name>exchange.object_expected</name>
    <message>
        <source>it must be an object in braces</source>
        <translation>hier wird ein Objekt in geschweiften Klammern erwartet</translation>
    </message>
</context>
<context>
    <name>exchange.one_error_blank</name>
    <message>
        <source>one of its two uncertainties is blank</source>
        <translation>eine der beiden Unsicherheiten ist leer</translation>
    </message>
</context>
<context>
    <name>exchange.one_place_blank</name>
    <message>
        <source>one of its two coordinates is blank</source>
        <translation>einer der beiden Orte ist leer</translation>
    </message>
</context>
<context>
    <name>exchange.one_time_a_frame</name>
    <message>
        <source>give one time for each frame, in the order of the frames, under a name such as t_s</source>
        <translation>geben Sie für jedes Bild eine Zeit an, in der Reihenfolge der Bilder, unter einem Namen wie t_s</translation>
    </message>
</context>
<context>
    <name>exchange.order_lines</name>
    <message>
        <source>sort the lines by time, with each time only once</source>
        <translation>ordnen Sie die Zeilen nach der Zeit, jede Zeit einmal</translation>
    </message>
</context>
<context>
    <name>exchange.pack</name>
    <message>
        <source>pack &apos;%1&apos;</source>
        <translation>&apos;%1&apos; packen</translation>
    </message>
</context>
<context>
    <name>exchange.packing</name>
    <message>
        <source>packing %1</source>
        <translation>gepackt wird: %1</translation>
    </message>
</context>
<context>
    <name>exchange.path_given_twice</name>
    <message>
        <source>the reference path has more than one shape</source>
        <translation>die Sollbahn ist zweimal angegeben</translation>
    </message>
</context>
<context>
    <name>exchange.path_not_given</name>
    <message>
        <source>the reference path has no shape</source>
        <translation>die Sollbahn ist durch nichts angegeben</translation>
    </message>
</context>
<context>
    <name>exchange.pixel_is</name>
    <message>
        <source>a pixel is %1</source>
        <translation>ein Pixel ist %1 lang</translation>
    </message>
</context>
<context>
    <name>exchange.place_too_far</name>
    <message>
        <source>its position is more than 100 km away</source>
        <translation>der Ort ist mehr als 100 km entfernt</translation>
    </message>
</context>
<context>
    <name>exchange.points_group_thousands</name>
    <message>
        <source>points separate thousands</source>
        <translation>Punkte trennen Tausender</translation>
    </message>
</context>
<context>
    <name>exchange.positions_are_pixels</name>
    <message>
        <source>its positions are in pixels, which are no lengths</source>
        <translation>ihre Positionen sind in Pixeln, und die sind keine Längen</translation>
    </message>
</context>
<context>
    <name>exchange.positions_as_metres</name>
    <message>
        <source>its positions have no unit and were read as metres</source>
        <translation>ihre Positionen haben keine Einheit und wurden als Meter gelesen</translation>
    </message>
</context>
<context>
    <name>exchange.quoted_cell_does_not_end</name>
    <message>
        <source>a quoted cell does not end</source>
        <translation>eine Zelle in Anführungszeichen endet nicht</translation>
    </message>
</context>
<context>
    <name>exchange.rate_beside_times</name>
    <message>
        <source>it has times, and no frame numbers</source>
        <translation>sie hat Zeiten und keine Bildnummern</translation>
    </message>
</context>
<context>
    <name>exchange.reading_line</name>
    <message>
        <source>reading line %1</source>
        <translation>Zeile %1 wird gelesen</translation>
    </message>
</context>
<context>
    <name>exchange.roster</name>
    <message>
        <source>roster &apos;%1&apos;</source>
        <translation>Klassenliste &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.roster_is_empty</name>
    <message>
        <source>it has no team</source>
        <translation>kein Team ist darin</translation>
    </message>
</context>
<context>
    <name>exchange.row_without_time</name>
    <message>
        <source>line %1 was left out, because it has no time</source>
        <translation>Zeile %1 wurde weggelassen, weil sie keine Zeit hat</translation>
    </message>
</context>
<context>
    <name>exchange.rows_without_time</name>
    <message>
        <source>%1 lines were left out, because they have no time; the first is line %2</source>
        <translation>%1 Zeilen wurden weggelassen, weil sie keine Zeit haben; die erste ist Zeile %2</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_csv_utf8</name>
    <message>
        <source>save it again as &quot;CSV UTF-8&quot; or as a UTF-8 text</source>
        <translation>speichern Sie sie neu als &quot;CSV UTF-8&quot; oder als UTF-8-Text</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_utf8</name>
    <message>
        <source>save it again as UTF-8 text</source>
        <translation>speichern Sie sie neu als UTF-8-Text</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_yaml</name>
    <message>
        <source>save the calibration as YAML or JSON</source>
        <translation>speichern Sie die Kalibrierung als YAML oder JSON</translation>
    </message>
</context>
<context>
    <name>exchange.save_with_commas</name>
    <message>
        <source>save it with commas</source>
        <translation>speichern Sie sie mit Kommas</translation>
    </message>
</context>
<context>
    <name>exchange.save_with_commas_and_points</name>
    <message>
        <source>save it with commas, and with a point in its numbers</source>
        <translation>speichern Sie sie mit Kommas und mit Punkt in den Zahlen</translation>
    </message>
</context>
<context>
    <name>exchange.separated_by_semicolons</name>
    <message>
        <source>its columns are separated by semicolons</source>
        <translation>die Spalten sind durch Semikolons getrennt</translation>
    </message>
</context>
<context>
    <name>exchange.several_cameras</name>
    <message>
        <source>it holds several cameras: %1</source>
        <translation>sie enthält mehrere Kameras: %1</translation>
    </message>
</context>
<context>
    <name>exchange.several_documents</name>
    <message>
        <source>it holds more than one document</source>
        <translation>darin steht mehr als ein Dokument</translation>
    </message>
</context>
<context>
    <name>exchange.sides_exchanged</name>
    <message>
        <source>its width and height are exchanged: the image centre (%1, %2) is that of %4 × %3 pixels, not %3 × %4</source>
        <translation>Breite und Höhe sind vertauscht: die Bildmitte (%1, %2) ist die von %4 × %3 Pixeln, nicht von %3 × %4</translation>
    </message>
</context>
<context>
    <name>exchange.sigma_not_above_zero</name>
    <message>
        <source>its uncertainty &apos;%1&apos; is not above zero</source>
        <translation>ihre Unsicherheit &apos;%1&apos; ist nicht größer als null</translation>
    </message>
</context>
<context>
    <name>exchange.sigma_or_blank</name>
    <message>
        <source>give the standard deviation of each position, or leave these cells blank</source>
        <translation>geben Sie die Standardabweichung jeder Position an, oder lassen Sie diese Zellen leer</translation>
    </message>
</context>
<context>
    <name>exchange.slalom_without_length</name>
    <message>
        <source>the slalom ends where it starts</source>
        <translation>der Slalom endet, wo er beginnt</translation>
    </message>
</context>
<context>
    <name>exchange.stamp_left_out</name>
    <message>
        <source>line %1 was left out, because its time repeats or is out of order</source>
        <translation>Zeile %1 wurde weggelassen, weil ihre Zeit sich wiederholt oder nicht in der Reihenfolge ist</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_left_out</name>
    <message>
        <source>%1 lines were left out, because their times repeat or are out of order; the first is line %2</source>
        <translation>%1 Zeilen wurden weggelassen, weil ihre Zeiten sich wiederholen oder nicht in der Reihenfolge sind; die erste ist Zeile %2</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_shared</name>
    <message>
        <source>its times are so coarse that %1 lines share theirs with the line before</source>
        <translation>ihre Zeiten sind so grob, dass %1 Zeilen dieselbe wie die Zeile davor haben</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_spread</name>
    <message>
        <source>its times are rounded to %1; the lines were spread evenly, %2 frames/s</source>
        <translation>ihre Zeiten sind auf %1 gerundet; die Zeilen wurden gleichmäßig verteilt, %2 Bilder/s</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_spread_with_gaps</name>
    <message>
        <source>its times are rounded to %1; the lines were spread evenly, with gaps</source>
        <translation>ihre Zeiten sind auf %1 gerundet; die Zeilen wurden gleichmäßig verteilt, mit Lücken</translation>
    </message>
</context>
<context>
    <name>exchange.team_named_again</name>
    <message>
        <source>line %1 names team &apos;%2&apos; again, as line %3</source>
        <translation>Zeile %1 nennt Team &apos;%2&apos; noch einmal, wie Zeile %3</translation>
    </message>
</context>
<context>
    <name>exchange.time_goes_back</name>
    <message>
        <source>its time is earlier than in the line before</source>
        <translation>die Zeit liegt vor der der Zeile davor</translation>
    </message>
</context>
<context>
    <name>exchange.time_of_no_age</name>
    <message>
        <source>its time is more than a century from 1970</source>
        <translation>ihre Zeit liegt mehr als ein Jahrhundert von 1970 entfernt</translation>
    </message>
</context>
<context>
    <name>exchange.time_repeated</name>
    <message>
        <source>its time is the same as in the line before</source>
        <translation>die Zeit ist die der Zeile davor</translation>
    </message>
</context>
<context>
    <name>exchange.time_steps_too_long</name>
    <message>
        <source>if its times are seconds, the rows are %1 apart and the run is %2 long</source>
        <translation>wenn ihre Zeiten Sekunden sind, liegen die Zeilen %1 auseinander und die Fahrt dauert %2</translation>
    </message>
</context>
<context>
    <name>exchange.time_steps_too_short</name>
    <message>
        <source>its times have no unit, and as seconds the rows would be %1 apart</source>
        <translation>ihre Zeiten haben keine Einheit, und als Sekunden lägen die Zeilen %1 auseinander</translation>
    </message>
</context>
<context>
    <name>exchange.timecode_without_rate</name>
    <message>
        <source>the last part of its times counts frames, up to %1 a second</source>
        <translation>der letzte Teil ihrer Zeiten zählt Bilder, bis zu %1 in der Sekunde</translation>
    </message>
</context>
<context>
    <name>exchange.times_by_rate</name>
    <message>
        <source>all its times are the same; the lines were spread at %1 frames/s</source>
        <translation>alle ihre Zeiten sind gleich; die Zeilen wurden mit %1 Bildern/s verteilt</translation>
    </message>
</context>
<context>
    <name>exchange.times_in_days</name>
    <message>
        <source>times in days, as spreadsheets write them</source>
        <translation>Zeiten in Tagen, wie Tabellenprogramme sie schreiben</translation>
    </message>
</context>
<context>
    <name>exchange.times_in_two_ways</name>
    <message>
        <source>its times can be read in two ways: &apos;%1&apos; with three decimals, or without</source>
        <translation>ihre Zeiten lassen sich auf zwei Arten lesen: &apos;%1&apos; mit drei Nachkommastellen oder ohne</translation>
    </message>
</context>
<context>
    <name>exchange.times_since_1970</name>
    <message>
        <source>times in %1 since 1970</source>
        <translation>Zeiten in %1 seit 1970</translation>
    </message>
</context>
<context>
    <name>exchange.too_fast_as_said</name>
    <message>
        <source>in the units that it gives, the robot would drive at %1</source>
        <translation>in den angegebenen Einheiten führe der Roboter mit %1</translation>
    </message>
</context>
<context>
    <name>exchange.too_fast_in_metres</name>
    <message>
        <source>its positions have no unit, and in metres the robot would drive at %1</source>
        <translation>ihre Positionen haben keine Einheit, und in Metern führe der Roboter mit %1</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_files</name>
    <message>
        <source>it has too many files</source>
        <translation>zu viele Dateien</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_places</name>
    <message>
        <source>the file has more than 1.5 million positions</source>
        <translation>die Datei hat mehr als 1,5 Millionen Orte</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_tracks</name>
    <message>
        <source>the file has more than 1000 tracks</source>
        <translation>die Datei hat mehr als 1000 Bahnen</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_values</name>
    <message>
        <source>it holds more than %1 values</source>
        <translation>darin stehen mehr als %1 Werte</translation>
    </message>
</context>
<context>
    <name>exchange.too_wide_in_metres</name>
    <message>
        <source>its positions have no unit, and in metres the floor would be %1 wide</source>
        <translation>ihre Positionen haben keine Einheit, und in Metern wäre der Boden %1 breit</translation>
    </message>
</context>
<context>
    <name>exchange.track_has_position</name>
    <message>
        <source>the track has %1 position</source>
        <translation>die Spur hat %1 Ort</translation>
    </message>
</context>
<context>
    <name>exchange.track_has_positions</name>
    <message>
        <source>the track has %1 positions</source>
        <translation>die Spur hat %1 Orte</translation>
    </message>
</context>
<context>
    <name>exchange.tum_entries</name>
    <message>
        <source>it has %1 entries instead of the 8 of TUM</source>
        <translation>%1 Einträge statt der 8 von TUM</translation>
    </message>
</context>
<context>
    <name>exchange.tum_entry</name>
    <message>
        <source>it has %1 entry instead of the 8 of TUM</source>
        <translation>%1 Eintrag statt der 8 von TUM</translation>
    </message>
</context>
<context>
    <name>exchange.twins_left_out</name>
    <message>
        <source>%1 lines were left out, because they repeat the line before</source>
        <translation>%1 Zeilen wurden weggelassen, weil sie die Zeile davor wiederholen</translation>
    </message>
</context>
<context>
    <name>exchange.unit_not_known</name>
    <message>
        <source>its column &apos;%1&apos; is in a unit that is not known</source>
        <translation>die Spalte &apos;%1&apos; hat eine unbekannte Einheit</translation>
    </message>
</context>
<context>
    <name>exchange.unpack</name>
    <message>
        <source>unpack &apos;%1&apos;</source>
        <translation>&apos;%1&apos; entpacken</translation>
    </message>
</context>
<context>
    <name>exchange.unpack_into</name>
    <message>
        <source>unpack into &apos;%1&apos;</source>
        <translation>nach &apos;%1&apos; entpacken</translation>
    </message>
</context>
<context>
    <name>exchange.unpacking</name>
    <message>
        <source>unpacking</source>
        <translation>wird entpackt</translation>
    </message>
</context>
<context>
    <name>exchange.unpacks_too_large</name>
    <message>
        <source>it unpacks to more than a hundred times its size</source>
        <translation>es wird beim Entpacken mehr als hundertmal so groß</translation>
    </message>
</context>
<context>
    <name>exchange.unset_stamps</name>
    <message>
        <source>lines left out because their time is 0: %1</source>
        <translation>weggelassene Zeilen, weil ihre Zeit 0 ist: %1</translation>
    </message>
</context>
<context>
    <name>exchange.unsure_left_out</name>
    <message>
        <source>%1 positions with a confidence below %2 count as not measured; the first is in line %3</source>
        <translation>%1 Positionen mit einer Konfidenz unter %2 gelten als nicht gemessen; die erste steht in Zeile %3</translation>
    </message>
</context>
<context>
    <name>exchange.use_calibration_file</name>
    <message>
        <source>use a calibration file as ROS, OpenCV, Kalibr, anipose or PhotonVision writes it</source>
        <translation>verwenden Sie eine Kalibrierdatei, wie ROS, OpenCV, Kalibr, anipose oder PhotonVision sie schreibt</translation>
    </message>
</context>
<context>
    <name>exchange.use_keys</name>
    <message>
        <source>use %1</source>
        <translation>verwenden Sie %1</translation>
    </message>
</context>
<context>
    <name>exchange.wait_for_writers</name>
    <message>
        <source>wait until no program writes to it, and try again</source>
        <translation>warten Sie, bis niemand mehr darin schreibt, und versuchen Sie es noch einmal</translation>
    </message>
</context>
<context>
    <name>exchange.write_class_and_team</name>
    <message>
        <source>write a line with class and team below the header</source>
        <translation>schreiben Sie unter die Kopfzeile eine Zeile mit Klasse und Team</translation>
    </message>
</context>
<context>
    <name>exchange.write_decimal_point</name>
    <message>
        <source>write them with a decimal point</source>
        <translation>schreiben Sie sie mit Dezimalpunkt</translation>
    </message>
</context>
<context>
    <name>exchange.write_digits</name>
    <message>
        <source>write it with digits, like 12.5</source>
        <translation>schreiben Sie die Zeit mit Ziffern, etwa 12.5</translation>
    </message>
</context>
<context>
    <name>exchange.write_digits_or_blank</name>
    <message>
        <source>write it with digits, like 12.5, or leave the cell blank</source>
        <translation>schreiben Sie die Zahl mit Ziffern, etwa 12.5, oder lassen Sie die Stelle leer</translation>
    </message>
</context>
<context>
    <name>exchange.write_finer_times</name>
    <message>
        <source>write the times with more digits, or give the frame rate of an even series</source>
        <translation>schreiben Sie die Zeiten mit mehr Stellen, oder geben Sie die Bildrate einer gleichmäßigen Folge an</translation>
    </message>
</context>
<context>
    <name>exchange.write_line_for_marker</name>
    <message>
        <source>write one line for each marker</source>
        <translation>schreiben Sie eine Zeile je Marker</translation>
    </message>
</context>
<context>
    <name>exchange.write_object_with</name>
    <message>
        <source>write one with %1</source>
        <translation>schreiben Sie eines mit %1</translation>
    </message>
</context>
<context>
    <name>exchange.write_task_as_shown</name>
    <message>
        <source>write the task as odograph task list --json shows one</source>
        <translation>legen Sie die Aufgabe im Messplatz an, oder schreiben Sie die Datei, wie es das Handbuch zeigt</translation>
    </message>
</context>
<context>
    <name>exchange.write_tum_or_header</name>
    <message>
        <source>write %1, or begin the file with the line %2</source>
        <translation>schreiben Sie %1, oder beginnen Sie die Datei mit der Zeile %2</translation>
    </message>
</context>
<context>
    <name>exchange.write_value_for_each</name>
    <message>
        <source>write one value for each of %1</source>
        <translation>schreiben Sie je einen Wert für %1</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_number_of_cells</name>
    <message>
        <source>it has %1 cells instead of %2</source>
        <translation>%1 Zellen statt %2</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_number_of_numbers</name>
    <message>
        <source>&apos;%1&apos; has %2 numbers instead of %3 × %4</source>
        <translation>&apos;%1&apos; hat %2 Zahlen statt %3 × %4</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_poles</name>
    <message>
        <source>&apos;poles&apos; is not a whole number from 1 to 100</source>
        <translation>&apos;poles&apos; ist keine ganze Zahl von 1 bis 100</translation>
    </message>
</context>
<context>
    <name>exchange.zone_given_twice</name>
    <message>
        <source>the zone has more than one shape</source>
        <translation>die Zone ist zweimal angegeben</translation>
    </message>
</context>
<context>
    <name>exchange.zone_not_given</name>
    <message>
        <source>the zone has no shape</source>
        <translation>die Zone ist durch nichts angegeben</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_looked_at</name>
    <message>
        <source>it cannot be accessed (%1)</source>
        <translation>Zugriff nicht möglich (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_read</name>
    <message>
        <source>it cannot be read (%1)</source>
        <translation>Lesen nicht möglich (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_written</name>
    <message>
        <source>it cannot be written (%1)</source>
        <translation>Schreiben nicht möglich (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_write</name>
    <message>
        <source>cannot write &apos;%1&apos;</source>
        <translation>&apos;%1&apos; kann nicht geschrieben werden</translation>
    </message>
</context>
<context>
    <name>files.check_file_is_there</name>
    <message>
        <source>check that the file exists and that you may read it</source>
        <translation>prüfen Sie, ob die Datei da ist und gelesen werden darf</translation>
    </message>
</context>
<context>
    <name>files.check_its_folder</name>
    <message>
        <source>check the free space and the permissions of its folder</source>
        <translation>prüfen Sie den freien Platz und die Rechte seines Ordners</translation>
    </message>
</context>
<context>
    <name>files.check_may_be_read</name>
    <message>
        <source>check that you may read the file</source>
        <translation>prüfen Sie, ob Sie die Datei lesen dürfen</translation>
    </message>
</context>
<context>
    <name>files.check_name</name>
    <message>
        <source>check the name and the folder</source>
        <translation>prüfen Sie Name und Ordner</translation>
    </message>
</context>
<context>
    <name>files.choose_another_file</name>
    <message>
        <source>choose another file</source>
        <translation>wählen Sie eine andere Datei</translation>
    </message>
</context>
<context>
    <name>files.choose_another_folder</name>
    <message>
        <source>choose another folder</source>
        <translation>wählen Sie einen anderen Ordner</translation>
    </message>
</context>
<context>
    <name>files.choose_another_name</name>
    <message>
        <source>choose another name</source>
        <translation>wählen Sie einen anderen Namen</translation>
    </message>
</context>
<context>
    <name>files.choose_folder_with_room</name>
    <message>
        <source>choose a folder that you may write to and that has free space</source>
        <translation>wählen Sie einen Ordner mit Platz, in den Sie schreiben dürfen</translation>
    </message>
</context>
<context>
    <name>files.choose_name_or_folder</name>
    <message>
        <source>choose another name or folder</source>
        <translation>wählen Sie einen anderen Namen oder Ordner</translation>
    </message>
</context>
<context>
    <name>files.choose_shorter_name</name>
    <message>
        <source>choose a shorter name</source>
        <translation>wählen Sie einen kürzeren Namen</translation>
    </message>
</context>
<context>
    <name>files.choose_writable_folder</name>
    <message>
        <source>choose a folder that you may write to</source>
        <translation>wählen Sie einen Ordner, in den Sie schreiben dürfen</translation>
    </message>
</context>
<context>
    <name>files.disk_is_full</name>
    <message>
        <source>the disk is full</source>
        <translation>die Platte ist voll</translation>
    </message>
</context>
<context>
    <name>files.file_is_empty</name>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
</context>
<context>
    <name>files.folder_cannot_be_used</name>
    <message>
        <source>its folder cannot be used (%1)</source>
        <translation>ihr Ordner ist nicht verwendbar (%1)</translation>
    </message>
</context>
<context>
    <name>files.folder_not_writable</name>
    <message>
        <source>the folder &apos;%1&apos; cannot be written to (%2)</source>
        <translation>in den Ordner &apos;%1&apos; kann nicht geschrieben werden (%2)</translation>
    </message>
</context>
<context>
    <name>files.has_no_name</name>
    <message>
        <source>it has no name</source>
        <translation>sie hat keinen Namen</translation>
    </message>
</context>
<context>
    <name>files.is_a_database</name>
    <message>
        <source>it is a database</source>
        <translation>es ist eine Datenbank</translation>
    </message>
</context>
<context>
    <name>files.is_another_project</name>
    <message>
        <source>it is another project</source>
        <translation>es ist ein anderes Projekt</translation>
    </message>
</context>
<context>
    <name>files.is_beside_project</name>
    <message>
        <source>it is the log, the lock or a backup of a project</source>
        <translation>es ist das Protokoll, die Sperre oder eine Sicherungskopie eines Projekts</translation>
    </message>
</context>
<context>
    <name>files.is_in_media_folder</name>
    <message>
        <source>it is in the media folder of project &apos;%1&apos;</source>
        <translation>sie liegt im Medienordner des Projekts &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>files.is_in_some_media_folder</name>
    <message>
        <source>it is in a media folder beside a project</source>
        <translation>sie liegt in einem Medienordner neben einem Projekt</translation>
    </message>
</context>
<context>
    <name>files.is_input</name>
    <message>
        <source>it is an input of the same command</source>
        <translation>sie ist eine Eingabe desselben Aufrufs</translation>
    </message>
</context>
<context>
    <name>files.is_of_another_kind</name>
    <message>
        <source>a file of another kind has that name</source>
        <translation>eine Datei anderer Art hat diesen Namen</translation>
    </message>
</context>
<context>
    <name>files.is_open_project</name>
    <message>
        <source>it is a project that is open here</source>
        <translation>es ist ein Projekt, das hier geöffnet ist</translation>
    </message>
</context>
<context>
    <name>files.is_temporary_name</name>
    <message>
        <source>Odograph uses such names for temporary files</source>
        <translation>Odograph verwendet solche Namen für temporäre Dateien</translation>
    </message>
</context>
<context>
    <name>files.is_the_project</name>
    <message>
        <source>it is the project itself</source>
        <translation>es ist das Projekt selbst</translation>
    </message>
</context>
<context>
    <name>files.is_there_already</name>
    <message>
        <source>it already exists</source>
        <translation>das gibt es schon</translation>
    </message>
</context>
<context>
    <name>files.log_left_beside</name>
    <message>
        <source>its folder has &apos;%1&apos;, the log or journal of another file of this name</source>
        <translation>in seinem Ordner liegt „%1“, das Protokoll oder Journal einer anderen Datei dieses Namens</translation>
    </message>
</context>
<context>
    <name>files.make_folder_first</name>
    <message>
        <source>create the folder first, or choose another one</source>
        <translation>legen Sie den Ordner zuerst an, oder wählen Sie einen anderen</translation>
    </message>
</context>
<context>
    <name>files.make_room</name>
    <message>
        <source>free some disk space and try again</source>
        <translation>schaffen Sie Platz auf der Platte und versuchen Sie es noch einmal</translation>
    </message>
</context>
<context>
    <name>files.move_log_away</name>
    <message>
        <source>choose another name, or move &apos;%1&apos; to another folder first</source>
        <translation>wählen Sie einen anderen Namen, oder verschieben Sie „%1“ zuerst in einen anderen Ordner</translation>
    </message>
</context>
<context>
    <name>files.name_a_file</name>
    <message>
        <source>give a file name</source>
        <translation>nennen Sie eine Datei</translation>
    </message>
</context>
<context>
    <name>files.name_too_long</name>
    <message>
        <source>its name is too long</source>
        <translation>der Name ist zu lang</translation>
    </message>
</context>
<context>
    <name>files.names_a_project</name>
    <message>
        <source>only projects have a name ending in .odo</source>
        <translation>ein Name, der auf .odo endet, ist für ein Projekt</translation>
    </message>
</context>
<context>
    <name>files.no_such_file</name>
    <message>
        <source>the file does not exist</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
</context>
<context>
    <name>files.no_such_folder</name>
    <message>
        <source>folder &apos;%1&apos; does not exist</source>
        <translation>es gibt keinen Ordner &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>files.replace_by_force</name>
    <message>
        <source>choose another name, or replace it with --force</source>
        <translation>wählen Sie einen anderen Namen, oder löschen Sie zuerst die Datei</translation>
    </message>
</context>
<context>
    <name>files.unreadable</name>
    <message>
        <source>it cannot be read</source>
        <translation>Lesen nicht möglich</translation>
    </message>
</context>
<context>
    <name>geometry.add_points</name>
    <message>
        <source>add points</source>
        <translation>fügen Sie Punkte hinzu</translation>
    </message>
</context>
<context>
    <name>geometry.at_one_place</name>
    <message>
        <source>%1 have the same position</source>
        <translation>%1 liegen an einer Stelle</translation>
    </message>
</context>
<context>
    <name>geometry.at_one_place_in_picture</name>
    <message>
        <source>%1 have the same position in the image</source>
        <translation>%1 liegen im Bild an einer Stelle</translation>
    </message>
</context>
<context>
    <name>geometry.beyond_horizon</name>
    <message>
        <source>%1 would be beyond the horizon</source>
        <translation>%1 läge hinter dem Horizont</translation>
    </message>
</context>
<context>
    <name>geometry.bow_tie</name>
    <message>
        <source>the order of the points crosses over like a bow tie</source>
        <translation>die Reihenfolge der Punkte überkreuzt sich wie eine Schleife</translation>
    </message>
</context>
<context>
    <name>geometry.calibrate_again</name>
    <message>
        <source>calibrate the camera again, or import another file</source>
        <translation>kalibrieren Sie die Kamera neu, oder importieren Sie eine andere Datei</translation>
    </message>
</context>
<context>
    <name>geometry.check_points</name>
    <message>
        <source>check which point is which</source>
        <translation>prüfen Sie, welcher Punkt welcher ist</translation>
    </message>
</context>
<context>
    <name>geometry.coordinate_not_finite</name>
    <message>
        <source>a coordinate of %1 is not a finite number</source>
        <translation>eine Koordinate von %1 ist keine endliche Zahl</translation>
    </message>
</context>
<context>
    <name>geometry.correct_it</name>
    <message>
        <source>correct it</source>
        <translation>berichtigen Sie es</translation>
    </message>
</context>
<context>
    <name>geometry.correct_one</name>
    <message>
        <source>correct one of them</source>
        <translation>berichtigen Sie einen davon</translation>
    </message>
</context>
<context>
    <name>geometry.empty_chain</name>
    <message>
        <source>the chain has no links</source>
        <translation>die Kette hat keine Glieder</translation>
    </message>
</context>
<context>
    <name>geometry.focal_not_positive</name>
    <message>
        <source>the focal length %1 is not positive</source>
        <translation>die Brennweite %1 ist nicht positiv</translation>
    </message>
</context>
<context>
    <name>geometry.four_points_needed</name>
    <message>
        <source>four points are needed, %1 given</source>
        <translation>vier Punkte werden gebraucht, %1 sind angegeben</translation>
    </message>
</context>
<context>
    <name>geometry.give_one_link</name>
    <message>
        <source>give at least one</source>
        <translation>geben Sie mindestens eines an</translation>
    </message>
</context>
<context>
    <name>geometry.intrinsics_unusable</name>
    <message>
        <source>these intrinsics cannot be used</source>
        <translation>diese Objektivdaten sind nicht brauchbar</translation>
    </message>
</context>
<context>
    <name>geometry.no_homography</name>
    <message>
        <source>no homography</source>
        <translation>keine Homographie</translation>
    </message>
</context>
<context>
    <name>geometry.on_one_line</name>
    <message>
        <source>%1 lie on one line</source>
        <translation>%1 liegen auf einer Linie</translation>
    </message>
</context>
<context>
    <name>geometry.on_one_line_in_picture</name>
    <message>
        <source>%1 lie on one line in the image</source>
        <translation>%1 liegen im Bild auf einer Linie</translation>
    </message>
</context>
<context>
    <name>geometry.point</name>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
</context>
<context>
    <name>geometry.points_do_not_tell</name>
    <message>
        <source>the points do not determine it</source>
        <translation>die Punkte bestimmen sie nicht</translation>
    </message>
</context>
<context>
    <name>geometry.singular_link</name>
    <message>
        <source>link %1 of %2 of the chain is singular</source>
        <translation>Glied %1 von %2 der Kette ist singulär</translation>
    </message>
</context>
<context>
    <name>geometry.size_not_positive</name>
    <message>
        <source>the image size %1 is not positive</source>
        <translation>die Bildgröße %1 ist nicht positiv</translation>
    </message>
</context>
<context>
    <name>geometry.spread_points</name>
    <message>
        <source>spread the points</source>
        <translation>verteilen Sie die Punkte</translation>
    </message>
</context>
<context>
    <name>geometry.use_four_points</name>
    <message>
        <source>use four points of which no three are in line</source>
        <translation>verwenden Sie vier Punkte, von denen keine drei auf einer Linie liegen</translation>
    </message>
</context>
<context>
    <name>geometry.use_four_points_in_it</name>
    <message>
        <source>use four points in it of which no three are in line</source>
        <translation>verwenden Sie darin vier Punkte, von denen keine drei auf einer Linie liegen</translation>
    </message>
</context>
<context>
    <name>geometry.value_not_finite</name>
    <message>
        <source>one of the values is not a finite number</source>
        <translation>einer der Werte ist keine endliche Zahl</translation>
    </message>
</context>
<context>
    <name>geometry.wrong_coefficients</name>
    <message>
        <source>this lens model does not take %1 distortion coefficients</source>
        <translation>%1 Verzeichnungskoeffizienten gehören nicht zu diesem Objektivmodell</translation>
    </message>
</context>
<context>
    <name>geometry.wrong_covariance_size</name>
    <message>
        <source>the covariance has the wrong size</source>
        <translation>die Kovarianz hat die falsche Größe</translation>
    </message>
</context>
<context>
    <name>odo::AccuracyDialog</name>
    <message>
        <source>may hang &amp;over the floor</source>
        <translation>darf über dem Boden &amp;hängen</translation>
    </message>
    <message>
        <source>&amp;Plan a camera</source>
        <translation>Kamera &amp;planen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Find &amp;best position</source>
        <translation>&amp;Bester Ort</translation>
    </message>
    <message>
        <source>Expected accuracy</source>
        <translation>Erwartete Genauigkeit</translation>
    </message>
    <message>
        <source>Expected accuracy in words</source>
        <translation>Erwartete Genauigkeit in Worten</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Was nicht stimmt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cameras included</source>
        <translation>Kameras, die zählen</translation>
    </message>
    <message>
        <source>All ticked cameras (joint)</source>
        <translation>Alle angekreuzten Kameras</translation>
    </message>
    <message>
        <source>The chosen camera alone</source>
        <translation>Nur die gewählte Kamera</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>An&amp;zeigen</translation>
    </message>
    <message>
        <source>Height of the robo&amp;t</source>
        <translation>Höhe des Robo&amp;ters</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>On a ceiling, for example; a tripod would be in the robots&apos; way</source>
        <translation>Wie unter einer Decke; ein Stativ stünde den Robotern im Weg</translation>
    </message>
    <message>
        <source>Moves the camera to where it, together with the other ticked cameras, minimises the largest uncertainty on the floor</source>
        <translation>Setzt die Kamera dorthin, wo zusammen mit den anderen angekreuzten die ungenaueste Stelle des Bodens am besten bekannt ist</translation>
    </message>
    <message>
        <source>Margin beyond the &amp;markers</source>
        <translation>Raum jenseits der &amp;Marker</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>Geplante Kamera</translation>
    </message>
    <message>
        <source>%1, registered %2</source>
        <translation>%1, eingemessen %2</translation>
    </message>
    <message>
        <source>Planned %1</source>
        <translation>Geplant: %1</translation>
    </message>
    <message>
        <source>%1: %2; %3.</source>
        <translation>%1: %2; %3.</translation>
    </message>
    <message>
        <source>Searching for the best position…</source>
        <translation>Bester Ort wird gesucht…</translation>
    </message>
</context>
<context>
    <name>odo::BackupsDialog</name>
    <message>
        <source>What restoring would change</source>
        <translation>Was das Wiederherstellen ändern würde</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>&amp;Back up now</source>
        <translation>&amp;Jetzt sichern</translation>
    </message>
    <message>
        <source>&amp;Restore this backup</source>
        <translation>Diese &amp;wiederherstellen</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungskopien</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>Ordner der Sicherungskopien</translation>
    </message>
    <message>
        <source>Backups are in %1. They contain everything except the videos.</source>
        <translation>Die Sicherungskopien sind in %1. Sie enthalten alles außer den Videos.</translation>
    </message>
    <message numerus="yes">
        <source>One is made each day on which you open the project, and kept for %n day(s).</source>
        <translation>
            <numerusform>An jedem Tag, an dem Sie das Projekt öffnen, entsteht eine; sie bleibt %n Tag.</numerusform>
            <numerusform>An jedem Tag, an dem Sie das Projekt öffnen, entsteht eine; sie bleibt %n Tage.</numerusform>
        </translation>
    </message>
    <message>
        <source>Daily backups are switched off in the preferences.</source>
        <translation>Tägliche Sicherungskopien sind in den Einstellungen abgeschaltet.</translation>
    </message>
    <message>
        <source>&amp;Open folder</source>
        <translation>&amp;Ordner öffnen</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Changes since this backup</source>
        <translation>Änderungen seit dieser Sicherungskopie</translation>
    </message>
    <message>
        <source>%1, before an update</source>
        <translation>%1, vor einer Umstellung</translation>
    </message>
    <message>
        <source>No backup yet.</source>
        <translation>Noch keine Sicherungskopie.</translation>
    </message>
    <message>
        <source>Reading the backup…</source>
        <translation>Die Sicherungskopie wird gelesen …</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) in this backup.</source>
        <translation>
            <numerusform>%n Versuch in dieser Sicherungskopie.</numerusform>
            <numerusform>%n Versuche in dieser Sicherungskopie.</numerusform>
        </translation>
    </message>
    <message>
        <source>Without: %1</source>
        <translation>Ohne: %1</translation>
    </message>
    <message>
        <source>With, though deleted since: %1</source>
        <translation>Mit, seither gelöscht: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n of its video(s) no longer exist.</source>
        <translation>
            <numerusform>%n seiner Videos gibt es nicht mehr.</numerusform>
            <numerusform>%n seiner Videos gibt es nicht mehr.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring it discards no changes.</source>
        <translation>Sie wiederherzustellen verwirft keine Änderungen.</translation>
    </message>
    <message numerus="yes">
        <source>Restoring it discards %n change(s) made since:</source>
        <translation>
            <numerusform>Sie wiederherzustellen verwirft %n spätere Änderung:</numerusform>
            <numerusform>Sie wiederherzustellen verwirft %n spätere Änderungen:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It brings back %n change(s).</source>
        <translation>
            <numerusform>Sie bringt %n Änderung zurück.</numerusform>
            <numerusform>Sie bringt %n Änderungen zurück.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::Badge</name>
    <message>
        <source>not registered</source>
        <translation>nicht eingemessen</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>um %1 bewegt</translation>
    </message>
    <message>
        <source>marker moved %1</source>
        <translation>Marker um %1 bewegt</translation>
    </message>
    <message>
        <source>markers not found</source>
        <translation>Marker nicht gefunden</translation>
    </message>
</context>
<context>
    <name>odo::BoardCanvas</name>
    <message>
        <source>Image of the board</source>
        <translation>Bild der Tafel</translation>
    </message>
    <message>
        <source>residuals, longest %1 px</source>
        <translation>Residuen, längstes %1 px</translation>
    </message>
</context>
<context>
    <name>odo::BoardImagesPage</name>
    <message>
        <source>Move it to the left of the image</source>
        <translation>Nach links im Bild bewegen</translation>
    </message>
    <message>
        <source>Move it to the right of the image</source>
        <translation>Nach rechts im Bild bewegen</translation>
    </message>
    <message>
        <source>Move it up</source>
        <translation>Nach oben bewegen</translation>
    </message>
    <message>
        <source>Move it down</source>
        <translation>Nach unten bewegen</translation>
    </message>
    <message>
        <source>Closer to the camera</source>
        <translation>Näher an die Kamera</translation>
    </message>
    <message>
        <source>Farther from the camera</source>
        <translation>Weiter weg von der Kamera</translation>
    </message>
    <message>
        <source>Tilt it: the left side away from the camera</source>
        <translation>Neigen: die linke Seite von der Kamera weg</translation>
    </message>
    <message>
        <source>Tilt it: the right side away from the camera</source>
        <translation>Neigen: die rechte Seite von der Kamera weg</translation>
    </message>
    <message>
        <source>Tilt it: the upper side away from the camera</source>
        <translation>Neigen: die obere Seite von der Kamera weg</translation>
    </message>
    <message>
        <source>Tilt it: the lower side away from the camera</source>
        <translation>Neigen: die untere Seite von der Kamera weg</translation>
    </message>
    <message>
        <source>Hold it still</source>
        <translation>Still halten</translation>
    </message>
    <message>
        <source>&amp;Take an image now</source>
        <translation>Bild jetzt &amp;aufnehmen</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>No image from the camera</source>
        <translation>Kein Bild von der Kamera</translation>
    </message>
    <message>
        <source>Rejected images</source>
        <translation>Bilder, die nicht zählen</translation>
    </message>
    <message>
        <source>Coverage of the images</source>
        <translation>Was die Bilder abdecken</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>Zählt nicht</translation>
    </message>
    <message>
        <source>Waiting for the camera…</source>
        <translation>Warten auf die Kamera…</translation>
    </message>
    <message>
        <source>Detecting the board…</source>
        <translation>Tafel wird gesucht…</translation>
    </message>
    <message>
        <source>Hold the board before the camera</source>
        <translation>Halten Sie die Tafel vor die Kamera</translation>
    </message>
    <message>
        <source>Detecting the board</source>
        <translation>Tafel wird gesucht</translation>
    </message>
    <message>
        <source>Odograph takes an image whenever the board is still, sharp and in a new position.</source>
        <translation>Ein Bild wird von selbst aufgenommen, sobald die Tafel ruhig, scharf und an einer neuen Stelle ist.</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>Aufgenommen</translation>
    </message>
    <message>
        <source>Now the dashed outline shows where the board would help most.</source>
        <translation>Jetzt zeigt der gestrichelte Umriss, wo die Tafel am meisten helfen würde.</translation>
    </message>
    <message>
        <source>%1 to go</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>No image accepted</source>
        <translation>Kein Bild zählt</translation>
    </message>
    <message>
        <source>See the reasons on the right. Drop other images here to add them.</source>
        <translation>Die Gründe stehen rechts. Weitere fügen Sie hinzu, indem Sie sie hier ablegen.</translation>
    </message>
    <message>
        <source>All images checked</source>
        <translation>Alle angesehen</translation>
    </message>
    <message>
        <source>They are enough.</source>
        <translation>Sie genügen.</translation>
    </message>
    <message>
        <source>Drop more images here; the bars show what is missing.</source>
        <translation>Weitere Bilder können hier abgelegt werden; die Balken zeigen, was fehlt.</translation>
    </message>
</context>
<context>
    <name>odo::BoardSearchWorker</name>
    <message>
        <source>image %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>none of its images shows a board that is still, sharp and in a new position</source>
        <translation>keines ihrer Bilder zeigt eine Tafel, die ruhig, scharf und an einer neuen Stelle ist</translation>
    </message>
    <message>
        <source>it cannot be read any more</source>
        <translation>es ist nicht mehr lesbar</translation>
    </message>
</context>
<context>
    <name>odo::BoxCanvas</name>
    <message>
        <source>Video frame; arrow keys move the box round the robot, Shift + arrow keys resize it</source>
        <translation>Bild; die Pfeiltasten verschieben den Rahmen um den Roboter, mit Umschalt ändern sie seine Größe</translation>
    </message>
</context>
<context>
    <name>odo::CalibrationResultPage</name>
    <message>
        <source>ordinary</source>
        <translation>gewöhnlich</translation>
    </message>
    <message>
        <source>wide (rational)</source>
        <translation>Weitwinkel (rational)</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>Fischauge</translation>
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
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Berechnung</translation>
    </message>
    <message>
        <source>Automatic choice of the lens model</source>
        <translation>Objektivmodell automatisch</translation>
    </message>
    <message>
        <source>Ordinary lens</source>
        <translation>Gewöhnliches Objektiv</translation>
    </message>
    <message>
        <source>Wide lens (rational model)</source>
        <translation>Weitwinkelobjektiv (rationales Modell)</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>Fischauge</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>Objektivmodell</translation>
    </message>
    <message>
        <source>Select a bar to see its image.</source>
        <translation>Wählen Sie einen Balken, um sein Bild zu sehen.</translation>
    </message>
    <message>
        <source>Appears here after the calibration.</source>
        <translation>Steht hier, sobald das Objektiv bekannt ist.</translation>
    </message>
    <message>
        <source>Image and &amp;residuals</source>
        <translation>Bild und &amp;Residuen</translation>
    </message>
    <message>
        <source>&amp;Straightened</source>
        <translation>&amp;Entzerrt</translation>
    </message>
    <message>
        <source>Error by image</source>
        <translation>Fehler je Bild</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>Lens calibration</source>
        <translation>Was vom Objektiv bekannt ist</translation>
    </message>
    <message>
        <source>Solving…</source>
        <translation>Wird berechnet…</translation>
    </message>
    <message>
        <source>straight edges must be straight</source>
        <translation>gerade Kanten müssen gerade sein</translation>
    </message>
    <message>
        <source>Storing the lens calibration and its images…</source>
        <translation>Objektiv und Bilder werden gespeichert…</translation>
    </message>
    <message>
        <source>The lens calibration was not stored. %1</source>
        <translation>Das Objektiv wurde nicht gespeichert. %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Board error</source>
        <translation>Tafelfehler</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>Kontrollfehler</translation>
    </message>
    <message>
        <source>needs six images</source>
        <translation>braucht sechs Bilder</translation>
    </message>
    <message>
        <source>Corners left out</source>
        <translation>Ausgelassene Ecken</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Brennweite</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Mitte x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Mitte y</translation>
    </message>
    <message>
        <source>above the threshold</source>
        <translation>über der Schwelle</translation>
    </message>
    <message>
        <source>Images left out</source>
        <translation>Ausgelassene Bilder</translation>
    </message>
</context>
<context>
    <name>odo::CalibrationSourcePage</name>
    <message>
        <source>&amp;From the camera: hold up the board, Odograph takes the images</source>
        <translation>&amp;Vor der Kamera: Tafel halten, Bilder werden von selbst aufgenommen</translation>
    </message>
    <message>
        <source>From existing images or a &amp;video</source>
        <translation>Aus eigenen &amp;Bildern oder einem Video</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Prin&amp;t a board…</source>
        <translation>&amp;Tafel drucken…</translation>
    </message>
    <message>
        <source>Show a flat calibration board from many sides to calibrate the lens. Odograph recognises checkerboard and ChArUco boards of any size. Measure one square on the paper: every later length depends on it. Do not refocus or zoom afterwards.</source>
        <translation>Eine ebene Tafel mit Quadraten, von vielen Seiten gesehen, verrät, wie das Objektiv abbildet. Schachbrett oder ChArUco, in jeder Größe: Was es ist, wird erkannt. Messen Sie ein Quadrat auf dem Papier; es entscheidet über jede spätere Länge. Danach darf das Objektiv nicht mehr neu fokussiert oder gezoomt werden.</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>Side of a &amp;square, measured</source>
        <translation>&amp;Quadratseite, gemessen</translation>
    </message>
    <message>
        <source>Source of the board images</source>
        <translation>Woher die Bilder der Tafel kommen</translation>
    </message>
    <message>
        <source>Images and videos of the board</source>
        <translation>Bilder und Videos der Tafel</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>You can also drop files here.</source>
        <translation>Dateien können auch hier abgelegt werden.</translation>
    </message>
    <message>
        <source>Name the camera, such as A.</source>
        <translation>Benennen Sie die Kamera, etwa A.</translation>
    </message>
    <message>
        <source>Connect a camera, or choose existing images.</source>
        <translation>Schließen Sie eine Kamera an, oder wählen Sie vorhandene Bilder.</translation>
    </message>
    <message>
        <source>Add images or a video of the board.</source>
        <translation>Fügen Sie Bilder oder ein Video der Tafel hinzu.</translation>
    </message>
</context>
<context>
    <name>odo::CameraChoiceDialog</name>
    <message>
        <source>Cameras to record with</source>
        <translation>Kameras für die Aufnahme</translation>
    </message>
    <message>
        <source>Device for camera %1</source>
        <translation>Gerät, das Kamera %1 ist</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Einstellungen…</translation>
    </message>
    <message>
        <source>Settings of camera %1</source>
        <translation>Einstellungen von Kamera %1</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>&amp;Search again</source>
        <translation>&amp;Erneut suchen</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>Diese nehmen</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nicht benutzt</translation>
    </message>
    <message>
        <source>in use by another program</source>
        <translation>von einem anderen Programm benutzt</translation>
    </message>
    <message>
        <source>%1 (not connected)</source>
        <translation>%1 (nicht angeschlossen)</translation>
    </message>
    <message>
        <source>Searching for cameras…</source>
        <translation>Kameras werden gesucht…</translation>
    </message>
    <message>
        <source>Choose at least one camera. Two cameras locate a robot more accurately, and if one cannot see it, the other often can.</source>
        <translation>Wählen Sie mindestens eine Kamera. Mit zweien ist der Ort eines Roboters genauer bekannt, auch während eine ihn nicht sieht.</translation>
    </message>
    <message>
        <source>You cannot use one device as two cameras.</source>
        <translation>Ein Gerät kann nicht zwei Kameras sein.</translation>
    </message>
</context>
<context>
    <name>odo::CameraListModel</name>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
    <message>
        <source>calibrated, ±%1 px</source>
        <translation>kalibriert, ±%1 px</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>nicht eingemessen</translation>
    </message>
    <message>
        <source>registered, %1</source>
        <translation>eingemessen, %1</translation>
    </message>
    <message>
        <source>Calibrate the lens, then register the camera to the floor.</source>
        <translation>Kalibrieren Sie das Objektiv, und messen Sie dann die Kamera zum Boden ein.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
</context>
<context>
    <name>odo::CameraPositionDialog</name>
    <message>
        <source>moved %1</source>
        <translation>um %1 bewegt</translation>
    </message>
    <message>
        <source>marker moved %1</source>
        <translation>Marker um %1 bewegt</translation>
    </message>
    <message>
        <source>has not moved</source>
        <translation>nicht bewegt</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>&amp;Prüfen</translation>
    </message>
    <message>
        <source>&amp;Register again…</source>
        <translation>Neu &amp;einmessen…</translation>
    </message>
    <message>
        <source>Check camera positions</source>
        <translation>Kameras prüfen</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>New image</source>
        <translation>Neues Bild</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Registered cameras</source>
        <translation>Eingemessene Kameras</translation>
    </message>
    <message>
        <source>A camera that someone has pushed measures wrong positions without any sign of it. Before the robots run, check each camera&apos;s markers in a new image.</source>
        <translation>Eine angestoßene Kamera misst falsch, und nichts verrät es. Bevor die Roboter fahren, werden die Marker jeder Kamera in einem neuen Bild noch einmal gesucht.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Results of the check</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>New image of camera %1</source>
        <translation>Neues Bild von Kamera %1</translation>
    </message>
    <message>
        <source>Its newest recording</source>
        <translation>Ihre neueste Aufnahme</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>An image or video…</source>
        <translation>Ein Bild oder Video…</translation>
    </message>
    <message>
        <source>detecting…</source>
        <translation>wird gesucht…</translation>
    </message>
    <message>
        <source>undetermined</source>
        <translation>unklar</translation>
    </message>
    <message>
        <source>At least two markers must be visible. The check changes nothing.</source>
        <translation>Mindestens zwei Marker müssen zu sehen sein. Die Prüfung bewegt und ändert nichts.</translation>
    </message>
    <message>
        <source>&amp;Register %1 again…</source>
        <translation>%1 neu &amp;einmessen…</translation>
    </message>
</context>
<context>
    <name>odo::CameraSettingsDialog</name>
    <message>
        <source>set by the camera</source>
        <translation>wie die Kamera es vorgibt</translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation>Bilder/s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Trigger each frame by software, at the same time for all cameras with this setting</source>
        <translation>Jedes Bild einzeln anfordern, damit alle solchen Kameras ihres gleichzeitig aufnehmen</translation>
    </message>
    <message>
        <source>Settings of %1</source>
        <translation>Einstellungen von %1</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Software trigger</source>
        <translation>Softwareauslöser</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Rate</source>
        <translation>Bild&amp;rate</translation>
    </message>
    <message>
        <source>&amp;Exposure</source>
        <translation>B&amp;elichtung</translation>
    </message>
    <message>
        <source>&amp;Trigger</source>
        <translation>&amp;Auslöser</translation>
    </message>
    <message>
        <source>If the camera does not support a setting, a message says so when it opens.</source>
        <translation>Was die Kamera nicht kann, wird beim Öffnen gemeldet.</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>Diese nehmen</translation>
    </message>
    <message>
        <source>best for tracking</source>
        <translation>am besten für die Verfolgung</translation>
    </message>
</context>
<context>
    <name>odo::CameraView</name>
    <message>
        <source>synchronised to %1 ms</source>
        <translation>synchron auf %1 ms</translation>
    </message>
    <message>
        <source>manual offset</source>
        <translation>Versatz von Hand</translation>
    </message>
    <message>
        <source>not synchronised</source>
        <translation>nicht synchronisiert</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Camera image</source>
        <translation>Bild der Kamera</translation>
    </message>
    <message>
        <source>Image of %1</source>
        <translation>Bild von %1</translation>
    </message>
</context>
<context>
    <name>odo::ChangeModel</name>
    <message>
        <source>made</source>
        <translation>ausgeführt</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>rückgängig</translation>
    </message>
    <message>
        <source>redone</source>
        <translation>wiederholt</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
</context>
<context>
    <name>odo::ChangesDialog</name>
    <message>
        <source>Project changes</source>
        <translation>Änderungen am Projekt</translation>
    </message>
    <message>
        <source>No changes yet.</source>
        <translation>Noch wurde nichts geändert.</translation>
    </message>
    <message>
        <source>All changes made in this window and on the command line, newest first. The list includes recordings, imports and tracking, but you cannot undo them.</source>
        <translation>Was geändert wurde, in diesem Fenster und über die Befehlszeile, das Neueste zuerst. Aufnahmen, Importe und Verfolgungen stehen auch dabei; sie lassen sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Search the changes…</source>
        <translation>Änderungen durchsuchen…</translation>
    </message>
    <message>
        <source>Search the changes</source>
        <translation>Änderungen durchsuchen</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
</context>
<context>
    <name>odo::ChartImage</name>
    <message>
        <source>&amp;Copy as image</source>
        <translation>Als Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Save as image…</source>
        <translation>Als Bild &amp;speichern…</translation>
    </message>
    <message>
        <source>SVG images (*.svg)</source>
        <translation>SVG-Bilder (*.svg)</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>Save as image</source>
        <translation>Als Bild speichern</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-Dokumente (*.pdf)</translation>
    </message>
</context>
<context>
    <name>odo::ChartSpan</name>
    <message>
        <source>Charts: show &amp;less</source>
        <translation>Diagramme: &amp;weniger zeigen</translation>
    </message>
    <message>
        <source>Charts: show &amp;more</source>
        <translation>Diagramme: &amp;mehr zeigen</translation>
    </message>
    <message>
        <source>Charts: show &amp;all</source>
        <translation>Diagramme: &amp;alles zeigen</translation>
    </message>
    <message>
        <source>Charts over &amp;distance</source>
        <translation>Diagramme über dem W&amp;eg</translation>
    </message>
</context>
<context>
    <name>odo::CheckTools</name>
    <message>
        <source>&amp;Check camera positions…</source>
        <translation>Kameras &amp;prüfen…</translation>
    </message>
    <message>
        <source>Check camera positions…</source>
        <translation>Kameras prüfen…</translation>
    </message>
    <message>
        <source>Check before the robots run that no camera has moved since its registration</source>
        <translation>Nachsehen, ob jede Kamera noch da steht, wo sie eingemessen wurde, bevor die Roboter fahren</translation>
    </message>
    <message>
        <source>Check a known &amp;length…</source>
        <translation>Bekannte &amp;Länge prüfen…</translation>
    </message>
    <message>
        <source>Check a known length…</source>
        <translation>Bekannte Länge prüfen…</translation>
    </message>
    <message>
        <source>Measure an object of known length in a camera&apos;s image to check the camera&apos;s stated uncertainty</source>
        <translation>Etwas von bekannter Länge im Bild einer Kamera messen und sehen, ob die Kamera so gut ist, wie sie verspricht</translation>
    </message>
    <message>
        <source>&amp;Expected accuracy…</source>
        <translation>Er&amp;wartete Genauigkeit…</translation>
    </message>
    <message>
        <source>Accuracy…</source>
        <translation>Genauigkeit…</translation>
    </message>
    <message>
        <source>Show the expected uncertainty everywhere on the floor, also with planned cameras</source>
        <translation>Sehen, wie genau jede Stelle des Bodens bekannt sein wird, auch mit Kameras, die erst geplant sind</translation>
    </message>
    <message>
        <source>&amp;Older calibrations…</source>
        <translation>Ältere K&amp;alibrierungen…</translation>
    </message>
    <message>
        <source>Revisions…</source>
        <translation>Revisionen…</translation>
    </message>
    <message>
        <source>Show all calibrations and registrations of a camera, switch to an older one, reanalyse trials</source>
        <translation>Alle Kalibrierungen und Einmessungen einer Kamera ansehen, eine ältere wieder gültig machen, Versuche neu auswerten</translation>
    </message>
    <message>
        <source>Cameras checked: see their badges.</source>
        <translation>Die Kameras sind geprüft: siehe ihre Plaketten.</translation>
    </message>
    <message>
        <source>The chosen calibrations and analyses are now current.</source>
        <translation>Kalibrierungen und Versuche sind wie gewählt.</translation>
    </message>
</context>
<context>
    <name>odo::ClassActions</name>
    <message>
        <source>&amp;Tasks…</source>
        <translation>A&amp;ufgaben…</translation>
    </message>
    <message>
        <source>C&amp;lasses and teams…</source>
        <translation>Klassen und &amp;Teams…</translation>
    </message>
    <message>
        <source>R&amp;obots…</source>
        <translation>&amp;Roboter…</translation>
    </message>
    <message>
        <source>Show &amp;standings…</source>
        <translation>Rangliste &amp;zeigen…</translation>
    </message>
</context>
<context>
    <name>odo::ClassesDialog</name>
    <message>
        <source>&amp;New class…</source>
        <translation>&amp;Neue Klasse…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>&amp;Archivieren</translation>
    </message>
    <message>
        <source>Dele&amp;te</source>
        <translation>Lös&amp;chen</translation>
    </message>
    <message>
        <source>New t&amp;eam…</source>
        <translation>Neues T&amp;eam…</translation>
    </message>
    <message>
        <source>&amp;Move to</source>
        <translation>&amp;Verschieben in</translation>
    </message>
    <message>
        <source>Members and r&amp;obots…</source>
        <translation>&amp;Mitglieder und Roboter…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Import roster…</source>
        <translation>Klassenliste &amp;importieren…</translation>
    </message>
    <message>
        <source>Classes and teams</source>
        <translation>Klassen und Teams</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Klassen</translation>
    </message>
    <message>
        <source>Archiving hides a class: History, Record and the standings show its teams and trials only if you choose the class by name</source>
        <translation>Eine archivierte Klasse ist aus dem Weg: Verlauf, Aufnahme und Rangliste zeigen ihre Teams und Versuche nur, wo sie dort mit Namen gewählt ist</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>Pseudonym</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>Mitglieder</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Teams of the class</source>
        <translation>Teams der Klasse</translation>
    </message>
    <message>
        <source>Double-click or press F2 to change a name or a pseudonym</source>
        <translation>Doppelklick oder F2 ändert einen Namen oder ein Pseudonym</translation>
    </message>
    <message numerus="yes">
        <source>%1 (archived, %n team(s))</source>
        <translation>
            <numerusform>%1 (archiviert, %n Team)</numerusform>
            <numerusform>%1 (archiviert, %n Teams)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n team(s))</source>
        <translation>
            <numerusform>%1 (%n Team)</numerusform>
            <numerusform>%1 (%n Teams)</numerusform>
        </translation>
    </message>
    <message>
        <source>Teams without a class</source>
        <translation>Teams ohne Klasse</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>Aus dem &amp;Archiv holen</translation>
    </message>
    <message>
        <source>No class</source>
        <translation>Keine Klasse</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>New class</source>
        <translation>Neue Klasse</translation>
    </message>
    <message>
        <source>Rename class</source>
        <translation>Klasse umbenennen</translation>
    </message>
    <message>
        <source>New team</source>
        <translation>Neues Team</translation>
    </message>
</context>
<context>
    <name>odo::CompareColumn</name>
    <message>
        <source>Time difference</source>
        <translation>Zeitdifferenz</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Sektoren</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>Run compared with the first one</source>
        <translation>Fahrt, die gegen die erste gezeigt wird</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Fahrten</translation>
    </message>
    <message>
        <source>Times from gate to gate</source>
        <translation>Zeiten von Tor zu Tor</translation>
    </message>
    <message>
        <source>Metrics of both runs</source>
        <translation>Kennwerte beider Fahrten</translation>
    </message>
    <message>
        <source>s · drag the gates on the map</source>
        <translation>s · Tore auf der Karte ziehen</translation>
    </message>
    <message>
        <source>grey: not significant</source>
        <translation>grau: im Rahmen des Fehlers</translation>
    </message>
    <message>
        <source>of</source>
        <translation>von</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>Behind at finish</source>
        <translation>Am Ende später</translation>
    </message>
    <message>
        <source>Ahead at finish</source>
        <translation>Am Ende früher</translation>
    </message>
    <message>
        <source>Gap at finish</source>
        <translation>Am Ende</translation>
    </message>
    <message>
        <source>Behind at cursor</source>
        <translation>Hier später</translation>
    </message>
    <message>
        <source>Ahead at cursor</source>
        <translation>Hier früher</translation>
    </message>
    <message>
        <source>Gap at cursor</source>
        <translation>Hier</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
</context>
<context>
    <name>odo::CompareDesk</name>
    <message>
        <source>Top-down map</source>
        <translation>Karte von oben</translation>
    </message>
    <message>
        <source>Floor map with the paths of the runs and the gates of the sectors</source>
        <translation>Karte des Bodens mit den Wegen der Fahrten und den Toren der Sektoren</translation>
    </message>
    <message>
        <source>Drag a gate along the path. Keys: Up and Down select a gate, Left and Right move it</source>
        <translation>Ziehen Sie ein Tor entlang des Wegs; mit den Tasten: Auf und Ab wählen eines, Links und Rechts verschieben es</translation>
    </message>
    <message>
        <source>both runs</source>
        <translation>beide Fahrten</translation>
    </message>
    <message>
        <source>Camera of the first run</source>
        <translation>Kamera der ersten Fahrt</translation>
    </message>
    <message>
        <source>Camera of the second run</source>
        <translation>Kamera der zweiten Fahrt</translation>
    </message>
    <message>
        <source>dashed: the task&apos;s path</source>
        <translation>gestrichelt: Sollbahn der Aufgabe</translation>
    </message>
    <message>
        <source>along the first run&apos;s path</source>
        <translation>längs des Wegs der ersten Fahrt</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erste</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Zweite</translation>
    </message>
</context>
<context>
    <name>odo::ComparePage</name>
    <message>
        <source>These runs cannot be compared</source>
        <translation>Diese Fahrten lassen sich nicht vergleichen</translation>
    </message>
    <message>
        <source>%1. What to do: %2.</source>
        <translation>%1. Abhilfe: %2.</translation>
    </message>
    <message>
        <source>Select two runs</source>
        <translation>Es braucht zwei Fahrten</translation>
    </message>
    <message>
        <source>A comparison shows where one run is faster than the other, and whether the difference is significant. Select two tracked trials, or import another one.</source>
        <translation>Der Vergleich zeigt, wo eine Fahrt schneller ist als eine andere und ob das mehr ist als der Fehler. Wählen Sie zwei Versuche mit verfolgtem Roboter, oder importieren Sie einen weiteren.</translation>
    </message>
    <message>
        <source>Import trial from videos…</source>
        <translation>Versuch aus Videos importieren…</translation>
    </message>
</context>
<context>
    <name>odo::ConflictDialog</name>
    <message>
        <source>Changed here and elsewhere</source>
        <translation>Hier und anderswo geändert</translation>
    </message>
    <message>
        <source>You and another bench changed these. Nothing is lost: the hub keeps the version that is not in force. To bring a value back, enter it here again.</source>
        <translation>Dies haben Sie und ein anderer Messplatz geändert. Nichts geht verloren: Der Hub behält auch die Fassung, die nicht gilt. Um einen Wert zurückzuholen, geben Sie ihn hier wieder ein.</translation>
    </message>
    <message>
        <source>What was changed twice</source>
        <translation>Was zweimal geändert wurde</translation>
    </message>
    <message>
        <source>Values that differ</source>
        <translation>Werte, die sich unterscheiden</translation>
    </message>
    <message>
        <source>&amp;Remove all from this list</source>
        <translation>Alle aus der Liste &amp;entfernen</translation>
    </message>
    <message>
        <source>The version of this project is in force.</source>
        <translation>Es gilt die Fassung dieses Projekts.</translation>
    </message>
    <message>
        <source>The version of the hub is in force. It comes with the next “Pull”.</source>
        <translation>Es gilt die Fassung des Hubs. Sie kommt mit dem nächsten „Abrufen“.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>In this project</source>
        <translation>In diesem Projekt</translation>
    </message>
    <message>
        <source>At the hub</source>
        <translation>Am Hub</translation>
    </message>
</context>
<context>
    <name>odo::ConnectForm</name>
    <message>
        <source>Odograph keeps it until you close the program, and writes it nowhere</source>
        <translation>Odograph merkt es sich, bis Sie das Programm schließen, und schreibt es nirgends auf</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>C&amp;onnect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>Connect this project to the school&apos;s hub. Odograph sends its trials, tasks and class lists there, and you receive those of the other benches. You can measure without the network; Odograph sends later what it could not send.</source>
        <translation>Verbinden Sie dieses Projekt mit dem Hub der Schule. Odograph sendet seine Versuche, Aufgaben und Klassenlisten dorthin, und Sie erhalten die der anderen Messplätze. Messen können Sie auch ohne Netz; Odograph sendet später, was es nicht senden konnte.</translation>
    </message>
    <message>
        <source>Address of the hub</source>
        <translation>Adresse des Hubs</translation>
    </message>
    <message>
        <source>empty: as in ~/.pgpass or PGPASSWORD</source>
        <translation>leer: wie in ~/.pgpass oder PGPASSWORD</translation>
    </message>
    <message>
        <source>optional: a folder that all benches can reach</source>
        <translation>optional: ein Ordner, den alle Messplätze erreichen</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>Ordner für Aufnahmen</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>Durchsuchen: %1</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Adresse:</translation>
    </message>
    <message>
        <source>&amp;Password:</source>
        <translation>&amp;Passwort:</translation>
    </message>
    <message>
        <source>&amp;Recordings:</source>
        <translation>A&amp;ufnahmen:</translation>
    </message>
    <message>
        <source>postgresql://bench1@hub.school.example/school</source>
        <translation>postgresql://messplatz1@hub.schule.example/schule</translation>
    </message>
</context>
<context>
    <name>odo::CoveragePanel</name>
    <message>
        <source>Across</source>
        <translation>Waagrecht</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>Tilted</source>
        <translation>Geneigt</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Abgedeckt</translation>
    </message>
    <message>
        <source>%1 images: enough. More do no harm.</source>
        <translation>%1 Bilder: genug. Mehr schaden nicht.</translation>
    </message>
    <message>
        <source>1 image; take ten or more.</source>
        <translation>1 Bild; zehn oder mehr sind nötig.</translation>
    </message>
    <message>
        <source>%1 images; take ten or more.</source>
        <translation>%1 Bilder; zehn oder mehr sind nötig.</translation>
    </message>
</context>
<context>
    <name>odo::CrashNotice</name>
    <message>
        <source>Odograph ended unexpectedly</source>
        <translation>Odograph wurde unerwartet beendet</translation>
    </message>
    <message>
        <source>Odograph crashed the last time. Saved data is safe. If a recording was cut off, open its project to recover it up to the last second.</source>
        <translation>Beim letzten Mal wurde Odograph durch einen eigenen Fehler beendet. Was gespeichert war, ist sicher. Eine abgebrochene Aufnahme bleibt bis zu ihrer letzten Sekunde erhalten, sobald ihr Projekt wieder geöffnet wird.</translation>
    </message>
    <message>
        <source>Odograph crashed the last time. Saved data is safe.</source>
        <translation>Beim letzten Mal wurde Odograph durch einen eigenen Fehler beendet. Was gespeichert war, ist sicher.</translation>
    </message>
    <message>
        <source>Project:</source>
        <translation>Projekt:</translation>
    </message>
    <message>
        <source>Report:</source>
        <translation>Bericht:</translation>
    </message>
    <message>
        <source>&amp;Open the project</source>
        <translation>Projekt ö&amp;ffnen</translation>
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
        <translation>Anfang</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Only one of the two runs has it</source>
        <translation>Nur eine der beiden hat ihn</translation>
    </message>
    <message>
        <source>%1: significant (95 %)</source>
        <translation>%1: größer als der Fehler (95 %)</translation>
    </message>
    <message>
        <source>%1: not significant (95 %)</source>
        <translation>%1: im Rahmen des Fehlers (95 %), ein Unterschied lässt sich nicht behaupten</translation>
    </message>
    <message>
        <source>significant</source>
        <translation>größer als der Fehler</translation>
    </message>
    <message>
        <source>not significant</source>
        <translation>im Rahmen des Fehlers</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
</context>
<context>
    <name>odo::DistanceChart</name>
    <message>
        <source>Speed over distance</source>
        <translation>Geschwindigkeit längs des Wegs</translation>
    </message>
    <message>
        <source>Time difference over distance</source>
        <translation>Zeitdifferenz längs des Wegs</translation>
    </message>
    <message>
        <source>%1 · smoothed ±95 %</source>
        <translation>%1 · geglättet ±95 %</translation>
    </message>
    <message>
        <source>s · above 0: %2 is later than %1 · ±95 % · grey: not significant</source>
        <translation>s · über 0: %2 ist später als %1 · ±95 % · grau: im Rahmen des Fehlers</translation>
    </message>
    <message>
        <source>s · above 0: later than %1 · ±95 % · grey: not significant</source>
        <translation>s · über 0: später als %1 · ±95 % · grau: im Rahmen des Fehlers</translation>
    </message>
</context>
<context>
    <name>odo::DockGrip</name>
    <message>
        <source>Drag to move, double-click to float</source>
        <translation>Ziehen verschiebt, Doppelklick löst ab</translation>
    </message>
</context>
<context>
    <name>odo::DoctorDialog</name>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Set-up doctor</source>
        <translation>Aufbaudiagnose</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>&amp;Check again</source>
        <translation>&amp;Erneut prüfen</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft…</translation>
    </message>
    <message>
        <source>. What to do: %1.</source>
        <translation>. Was zu tun ist: %1.</translation>
    </message>
    <message>
        <source>Found nothing that would disturb a recording.</source>
        <translation>Es wurde nichts gefunden, was eine Aufnahme stören würde.</translation>
    </message>
    <message>
        <source>Found one problem.</source>
        <translation>Einen Punkt sollten Sie sich ansehen.</translation>
    </message>
    <message>
        <source>Found %1 problems, the worst first.</source>
        <translation>%1 Punkte sollten Sie sich ansehen, der schlimmste zuerst.</translation>
    </message>
</context>
<context>
    <name>odo::EditTrialDialog</name>
    <message>
        <source>Robots in the trial</source>
        <translation>Roboter im Versuch</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>%1 bearbeiten</translation>
    </message>
    <message numerus="yes">
        <source>Edit %n trial(s)</source>
        <translation>
            <numerusform>%n Versuch bearbeiten</numerusform>
            <numerusform>%n Versuche bearbeiten</numerusform>
        </translation>
    </message>
    <message>
        <source>Why it was not changed</source>
        <translation>Warum nichts geändert wurde</translation>
    </message>
    <message>
        <source>&amp;Change</source>
        <translation>Ä&amp;ndern</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>Na&amp;me</translation>
    </message>
    <message>
        <source>T&amp;eam</source>
        <translation>&amp;Team</translation>
    </message>
    <message>
        <source>C&amp;lass</source>
        <translation>K&amp;lasse</translation>
    </message>
    <message>
        <source>&amp;Date and time</source>
        <translation>&amp;Datum und Uhrzeit</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>Auf&amp;gabe</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>&amp;Roboter</translation>
    </message>
    <message>
        <source>separated by commas</source>
        <translation>durch Kommas getrennt</translation>
    </message>
    <message>
        <source>Ta&amp;gs</source>
        <translation>&amp;Schlagwörter</translation>
    </message>
    <message>
        <source>Note&amp;s</source>
        <translation>N&amp;otizen</translation>
    </message>
    <message>
        <source>&amp;Variables</source>
        <translation>&amp;Variablen</translation>
    </message>
    <message>
        <source>&amp;Remove variable</source>
        <translation>Variable &amp;entfernen</translation>
    </message>
    <message>
        <source>The variable %1 is in the table twice. Remove one of the rows.</source>
        <translation>Die Variable %1 steht zweimal in der Tabelle. Entfernen Sie eine der Zeilen.</translation>
    </message>
</context>
<context>
    <name>odo::FileActions</name>
    <message>
        <source>&amp;New project…</source>
        <translation>&amp;Neues Projekt…</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>Projekt ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open &amp;demo lesson…</source>
        <translation>&amp;Demo-Lektion öffnen…</translation>
    </message>
    <message>
        <source>Save a &amp;copy as…</source>
        <translation>&amp;Kopie speichern unter…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>Project.odo</source>
        <translation>Projekt.odo</translation>
    </message>
    <message>
        <source>Odograph projects (*.odo)</source>
        <translation>Odograph-Projekte (*.odo)</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Odograph projects (*.odo);;All files (*)</source>
        <translation>Odograph-Projekte (*.odo);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a folder for the demo lesson</source>
        <translation>Wo soll die Demo-Lektion angelegt werden?</translation>
    </message>
    <message>
        <source>Odograph demo</source>
        <translation>Odograph-Demo</translation>
    </message>
    <message>
        <source>Copy of %1</source>
        <translation>Kopie von %1</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Kopie speichern</translation>
    </message>
    <message>
        <source>Copy saved as %1. Its videos stay where they are.</source>
        <translation>Eine Kopie wurde als %1 gespeichert. Ihre Videos bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>New project from t&amp;his one…</source>
        <translation>Neues Projekt &amp;hieraus…</translation>
    </message>
    <message>
        <source>With its cameras, marker layouts, robots and tasks, without people and trials</source>
        <translation>Mit seinen Kameras, Markerplänen, Robotern und Aufgaben, ohne Personen und Versuche</translation>
    </message>
    <message>
        <source>Open demo lesson</source>
        <translation>Demo-Lektion öffnen</translation>
    </message>
    <message>
        <source>A demo lesson is in %1.</source>
        <translation>In %1 liegt eine Demo-Lektion.</translation>
    </message>
    <message>
        <source>&amp;Open it</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>&amp;Create another…</source>
        <translation>&amp;Weitere anlegen…</translation>
    </message>
    <message>
        <source>&amp;Backups…</source>
        <translation>&amp;Sicherungskopien…</translation>
    </message>
</context>
<context>
    <name>odo::FilmStrip</name>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Herausnehmen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Accepted images</source>
        <translation>Bilder, die zählen</translation>
    </message>
</context>
<context>
    <name>odo::FloorCopy</name>
    <message>
        <source>&amp;Copy floor position</source>
        <translation>Bodenposition &amp;kopieren</translation>
    </message>
</context>
<context>
    <name>odo::FloorMap</name>
    <message>
        <source>Top-down map</source>
        <translation>Karte von oben</translation>
    </message>
    <message>
        <source>Map: &amp;views&apos; disagreement</source>
        <translation>Karte: Ab&amp;weichung der Sichten</translation>
    </message>
    <message>
        <source>Floor map with the robots&apos; trails</source>
        <translation>Karte des Bodens mit den Spuren der Roboter</translation>
    </message>
    <message>
        <source>Colour of the trails on the map</source>
        <translation>Wonach die Spuren der Karte gefärbt sind</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Disagreement</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Disagreement of the views: %1</source>
        <translation>Abweichung der Sichten: %1</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
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
        <translation>Nicht auf dem Boden</translation>
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
        <translation>Skizze des Messplatzes von oben</translation>
    </message>
    <message>
        <source>%1 markers, %2 cameras</source>
        <translation>%1 Marker, %2 Kameras</translation>
    </message>
    <message>
        <source>%1, %2 m high</source>
        <translation>%1, %2 m hoch</translation>
    </message>
    <message>
        <source>This sketch shows markers and cameras once the testbed has a layout or a registered camera.</source>
        <translation>Marker und Kameras werden hier gezeichnet, sobald es einen Markerplan oder eine eingemessene Kamera gibt.</translation>
    </message>
    <message>
        <source>grid %1 m</source>
        <translation>Raster %1 m</translation>
    </message>
</context>
<context>
    <name>odo::FloorSourcePage</name>
    <message>
        <source>Image or video of the markers</source>
        <translation>Bild oder Video der Marker</translation>
    </message>
    <message>
        <source>Markers with known floor positions determine the camera position. Four are enough; a fifth checks them. Do not move the camera afterwards.</source>
        <translation>Marker, deren Orte auf dem Boden bekannt sind, verraten, wo die Kamera steht. Vier genügen, ein fünfter prüft sie. Danach darf die Kamera nicht mehr bewegt werden.</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>Marker &amp;layout</source>
        <translation>&amp;Markerplan</translation>
    </message>
    <message>
        <source>Image of the markers</source>
        <translation>Wo die Marker zu sehen sind</translation>
    </message>
    <message>
        <source>Its lens is calibrated.</source>
        <translation>Ihr Objektiv ist vermessen.</translation>
    </message>
    <message>
        <source>Its lens is not calibrated. Odograph estimates it from the markers, as far as they determine it.</source>
        <translation>Ihr Objektiv ist nicht kalibriert. Odograph schätzt es aus den Markern, soweit diese es bestimmen.</translation>
    </message>
    <message>
        <source>Name the camera, such as A.</source>
        <translation>Benennen Sie die Kamera, etwa A.</translation>
    </message>
    <message>
        <source>Add a marker layout first.</source>
        <translation>Legen Sie zuerst einen Plan der Marker an.</translation>
    </message>
    <message>
        <source>Choose an image or a video of the markers.</source>
        <translation>Wählen Sie ein Bild oder Video der Marker.</translation>
    </message>
</context>
<context>
    <name>odo::FloorWizard</name>
    <message>
        <source>Register camera to the floor</source>
        <translation>Kamera zum Boden einmessen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>The camera and its markers</source>
        <translation>Die Kamera und ihre Marker</translation>
    </message>
    <message>
        <source>The markers in the image</source>
        <translation>Die Marker im Bild</translation>
    </message>
    <message>
        <source>Detecting the markers…</source>
        <translation>Marker werden gesucht…</translation>
    </message>
    <message>
        <source>There is no registration to save yet.</source>
        <translation>Es gibt noch keine Einmessung zum Speichern.</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>die Einmessung</translation>
    </message>
</context>
<context>
    <name>odo::GateTable</name>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>start and finish</source>
        <translation>Start und Ziel</translation>
    </message>
    <message>
        <source>split</source>
        <translation>Zwischenzeit</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Reverse directi&amp;on</source>
        <translation>&amp;Umdrehen</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Tor</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
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
        <translation>Tore in der Reihenfolge, in der sie passiert werden</translation>
    </message>
    <message>
        <source>&amp;Add gate</source>
        <translation>&amp;Tor hinzufügen</translation>
    </message>
    <message>
        <source>Robots pass the selected gate the other way</source>
        <translation>Das gewählte Tor wird in der anderen Richtung passiert</translation>
    </message>
    <message>
        <source>Role of the gate</source>
        <translation>Rolle des Tors</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>Zwischenzeit %1</translation>
    </message>
</context>
<context>
    <name>odo::GeneralPage</name>
    <message>
        <source>Restart Odograph to see the change.</source>
        <translation>Odograph zeigt sie nach dem nächsten Start.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Units of results</source>
        <translation>&amp;Einheiten der Ergebnisse</translation>
    </message>
    <message>
        <source>Floors and targets always use millimetres, as printed. Exported files use the units of their format.</source>
        <translation>Boden und Druckvorlagen werden in Millimetern angegeben, so wie sie gedruckt werden. Exportierte Dateien haben die Einheiten, die ihr Format verlangt.</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Design</translation>
    </message>
    <message>
        <source>&amp;Colours of maps</source>
        <translation>&amp;Farben der Karten</translation>
    </message>
    <message>
        <source>Both remain readable for people with red-green colour blindness and in black-and-white prints.</source>
        <translation>Beide sind auch für Menschen mit Rot-Grün-Schwäche und im Schwarzweißdruck unterscheidbar.</translation>
    </message>
    <message>
        <source>Units of results</source>
        <translation>Einheiten der Ergebnisse</translation>
    </message>
    <message>
        <source>Millimetres and metres: mm, m, m/s</source>
        <translation>Millimeter und Meter: mm, m, m/s</translation>
    </message>
    <message>
        <source>Centimetres: cm, cm/s</source>
        <translation>Zentimeter: cm, cm/s</translation>
    </message>
    <message>
        <source>Inches and feet: in, ft, ft/s</source>
        <translation>Zoll und Fuß: in, ft, ft/s</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>As set on the computer</source>
        <translation>Wie der Computer</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Design</translation>
    </message>
    <message>
        <source>As set on the desktop</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Colours of maps</source>
        <translation>Farben der Karten</translation>
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
        <translation>Projekt an jedem Tag s&amp;ichern, an dem es geöffnet wird</translation>
    </message>
    <message>
        <source>&amp;Days to keep backups</source>
        <translation>&amp;Kopien behalten (Tage)</translation>
    </message>
    <message>
        <source>Backups are beside the project and contain everything except the videos: File ▸ Backups… shows and restores them.</source>
        <translation>Sicherungskopien liegen neben dem Projekt und enthalten alles außer den Videos: Datei ▸ Sicherungskopien… zeigt sie und stellt sie wieder her.</translation>
    </message>
</context>
<context>
    <name>odo::GuidanceTool</name>
    <message>
        <source>&amp;Ignore an area</source>
        <translation>Bereich &amp;ignorieren</translation>
    </message>
    <message>
        <source>Draw an area of a view to ignore, such as a mirror or a screen: click its corners, then press Enter</source>
        <translation>Einen Bereich einer Sicht zeichnen, der ignoriert wird, etwa einen Spiegel oder Bildschirm: seine Ecken anklicken, dann Eingabe drücken</translation>
    </message>
    <message>
        <source>Search only an &amp;area</source>
        <translation>Nur einen Bereich d&amp;urchsuchen</translation>
    </message>
    <message>
        <source>Draw the area of a view in which robots are searched: click its corners, then press Enter</source>
        <translation>Den Bereich einer Sicht zeichnen, in dem Roboter gesucht werden: seine Ecken anklicken, dann Eingabe drücken</translation>
    </message>
    <message>
        <source>&amp;Remove all areas</source>
        <translation>Alle Bereiche ent&amp;fernen</translation>
    </message>
    <message>
        <source>Remove all areas of this trial</source>
        <translation>Alle Bereiche dieses Versuchs entfernen</translation>
    </message>
    <message>
        <source>Remove this ignored area</source>
        <translation>Diesen ignorierten Bereich entfernen</translation>
    </message>
    <message>
        <source>Remove this search area</source>
        <translation>Diesen Suchbereich entfernen</translation>
    </message>
    <message>
        <source>Set %1 here by hand…</source>
        <translation>%1 hier von Hand setzen…</translation>
    </message>
    <message>
        <source>%1 is not visible here in the selected time</source>
        <translation>%1 ist hier in der ausgewählten Zeit nicht sichtbar</translation>
    </message>
    <message>
        <source>%1 is not visible in any view in the selected time</source>
        <translation>%1 ist in der ausgewählten Zeit in keiner Sicht sichtbar</translation>
    </message>
    <message>
        <source>Remove the point set by hand</source>
        <translation>Den von Hand gesetzten Punkt entfernen</translation>
    </message>
    <message>
        <source>It is visible after all</source>
        <translation>Er ist doch sichtbar</translation>
    </message>
    <message>
        <source>Set a point by hand</source>
        <translation>Einen Punkt von Hand setzen</translation>
    </message>
    <message>
        <source>Uncertainty σ of this point, pixels:</source>
        <translation>Unsicherheit σ dieses Punkts, Pixel:</translation>
    </message>
</context>
<context>
    <name>odo::HelpActions</name>
    <message>
        <source>&amp;Help on this page</source>
        <translation>&amp;Hilfe zu dieser Seite</translation>
    </message>
    <message>
        <source>&amp;First lesson</source>
        <translation>&amp;Erste Lektion</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;About Odograph</source>
        <translation>Ü&amp;ber Odograph</translation>
    </message>
</context>
<context>
    <name>odo::HelpPanel</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Close the help (F1)</source>
        <translation>Hilfe schließen (F1)</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>Hilfe schließen</translation>
    </message>
    <message>
        <source>Help on this page</source>
        <translation>Hilfe zu dieser Seite</translation>
    </message>
</context>
<context>
    <name>odo::HistoryActions</name>
    <message>
        <source>Import &amp;roster…</source>
        <translation>&amp;Klassenliste importieren…</translation>
    </message>
    <message>
        <source>Show project &amp;changes…</source>
        <translation>Ä&amp;nderungen am Projekt…</translation>
    </message>
    <message>
        <source>Import a roster: a table with the columns class, team and optionally pseudonym</source>
        <translation>Eine Klassenliste importieren: eine Tabelle mit den Spalten class (Klasse) und team, eventuell pseudonym</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>CSV-Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Roster imported. New teams: %1, changed: %2, unchanged: %3.</source>
        <translation>Die Klassenliste ist importiert. Neue Teams: %1, geändert: %2, wie zuvor: %3.</translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s): choose a folder</source>
        <translation>
            <numerusform>%n Versuch exportieren: Ordner wählen</numerusform>
            <numerusform>%n Versuche exportieren: Ordner wählen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Videos of %n trial(s)</source>
        <translation>
            <numerusform>Video von %n Versuch</numerusform>
            <numerusform>Videos von %n Versuchen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) removed for good.</source>
        <translation>
            <numerusform>%n Versuch endgültig entfernt.</numerusform>
            <numerusform>%n Versuche endgültig entfernt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Removed %1 of %n trial(s) for good; the rest is still in the bin.</source>
        <translation>
            <numerusform>%1 von %n Versuch endgültig entfernt; der Rest ist noch da.</numerusform>
            <numerusform>%1 von %n Versuchen endgültig entfernt; der Rest ist noch da.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 could not be deleted; delete it by hand.</source>
        <translation>%1 ließ sich nicht löschen; löschen Sie es von Hand.</translation>
    </message>
</context>
<context>
    <name>odo::HistoryPage</name>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>Teams by &amp;pseudonym</source>
        <translation>Teams unter &amp;Pseudonym</translation>
    </message>
    <message>
        <source>Tr&amp;ials</source>
        <translation>Ver&amp;suche</translation>
    </message>
    <message>
        <source>Tea&amp;ms</source>
        <translation>&amp;Teams</translation>
    </message>
    <message>
        <source>Trials or teams</source>
        <translation>Versuche oder Teams</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Rea&amp;nalyse</source>
        <translation>&amp;Neu auswerten</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Bericht…</translation>
    </message>
    <message>
        <source>Export &amp;videos…</source>
        <translation>V&amp;ideos exportieren…</translation>
    </message>
    <message>
        <source>Search trials, teams, tasks, tags, notes…</source>
        <translation>Versuche, Teams, Aufgaben, Schlagwörter, Notizen durchsuchen…</translation>
    </message>
    <message>
        <source>Search the trials</source>
        <translation>Versuche durchsuchen</translation>
    </message>
    <message>
        <source>Searc&amp;h</source>
        <translation>Suc&amp;hen</translation>
    </message>
    <message>
        <source>%1 (archived)</source>
        <translation>%1 (archiviert)</translation>
    </message>
    <message>
        <source>Compare the selected trials</source>
        <translation>Die ausgewählten Versuche vergleichen</translation>
    </message>
    <message>
        <source>Select two or more trials (Ctrl+click or Shift+click)</source>
        <translation>Zwei oder mehr Versuche auswählen (Strg oder Umschalt und ein Klick)</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n trial(s)</source>
        <translation>
            <numerusform>%1 von %n Versuch</numerusform>
            <numerusform>%1 von %n Versuchen</numerusform>
        </translation>
    </message>
    <message>
        <source>School hub</source>
        <translation>Schul-Hub</translation>
    </message>
</context>
<context>
    <name>odo::HubActions</name>
    <message>
        <source>School &amp;hub…</source>
        <translation>Schul-&amp;Hub…</translation>
    </message>
</context>
<context>
    <name>odo::HubDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>School hub</source>
        <translation>Schul-Hub</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel the exchange with the hub</source>
        <translation>Den Austausch mit dem Hub abbrechen</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) are not sent yet. They stay in the project.</source>
        <translation>
            <numerusform>%n Änderung ist noch nicht gesendet. Sie bleibt im Projekt.</numerusform>
            <numerusform>%n Änderungen sind noch nicht gesendet. Sie bleiben im Projekt.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Trennen</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Wird verbunden…</translation>
    </message>
    <message>
        <source>Asking the hub…</source>
        <translation>Der Hub wird gefragt…</translation>
    </message>
    <message>
        <source>The project is read-only here, so nothing can be sent or received.</source>
        <translation>Das Projekt ist hier schreibgeschützt, daher kann nichts gesendet oder empfangen werden.</translation>
    </message>
</context>
<context>
    <name>odo::HubExchange</name>
    <message>
        <source>Disconnected. All trials stay in the project.</source>
        <translation>Getrennt. Alle Versuche bleiben im Projekt.</translation>
    </message>
</context>
<context>
    <name>odo::HubPanel</name>
    <message>
        <source>Password of the hub</source>
        <translation>Passwort des Hubs</translation>
    </message>
    <message>
        <source>Copy &amp;recordings, too</source>
        <translation>Auch A&amp;ufnahmen kopieren</translation>
    </message>
    <message>
        <source>&amp;Publish now</source>
        <translation>Jetzt &amp;veröffentlichen</translation>
    </message>
    <message>
        <source>Pu&amp;ll now</source>
        <translation>Jetzt a&amp;brufen</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Trennen</translation>
    </message>
    <message>
        <source>Send to the hub what is pending. Odograph also does this by itself.</source>
        <translation>Ausstehendes an den Hub senden. Odograph tut das auch von selbst.</translation>
    </message>
    <message>
        <source>Receive class lists, tasks and the trials of other benches</source>
        <translation>Klassenlisten, Aufgaben und die Versuche anderer Messplätze empfangen</translation>
    </message>
    <message>
        <source>To and from the school&apos;s folder for recordings; this can take long</source>
        <translation>In den Ordner der Schule für Aufnahmen und von dort; das kann lange dauern</translation>
    </message>
    <message>
        <source>Log &amp;in</source>
        <translation>An&amp;melden</translation>
    </message>
    <message>
        <source>Pass&amp;word:</source>
        <translation>Pass&amp;wort:</translation>
    </message>
    <message>
        <source>How the project is connected</source>
        <translation>Wie das Projekt verbunden ist</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
    <message>
        <source>Hub</source>
        <translation>Hub</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Schema</source>
        <translation>Schema</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Last exchange</source>
        <translation>Letzter Austausch</translation>
    </message>
    <message>
        <source>Still to be sent</source>
        <translation>Noch zu senden</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>No folder: they stay at this bench</source>
        <translation>Kein Ordner: Sie bleiben an diesem Messplatz</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Changed twice: %n…</source>
        <translation>
            <numerusform>&amp;Zweimal geändert: %n…</numerusform>
            <numerusform>&amp;Zweimal geändert: %n…</numerusform>
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
        <translation>zählt</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>does not count</source>
        <translation>zählt nicht</translation>
    </message>
    <message>
        <source>another course</source>
        <translation>anderer Kurs</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Standings</source>
        <translation>Rangliste</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Messplatz</translation>
    </message>
</context>
<context>
    <name>odo::HubRunsPanel</name>
    <message>
        <source>Trials of all benches</source>
        <translation>Versuche aller Messplätze</translation>
    </message>
    <message>
        <source>Search trials and teams…</source>
        <translation>Versuche und Teams suchen…</translation>
    </message>
    <message>
        <source>Search the hub</source>
        <translation>Im Hub suchen</translation>
    </message>
    <message>
        <source>Three letters or more</source>
        <translation>Mindestens drei Buchstaben</translation>
    </message>
    <message>
        <source>Runs at the hub</source>
        <translation>Läufe am Hub</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Wird gesucht…</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n Lauf</numerusform>
            <numerusform>%n Läufe</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the newest %n run(s)</source>
        <translation>
            <numerusform>der neueste Lauf</numerusform>
            <numerusform>die neuesten %n Läufe</numerusform>
        </translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Messplatz</translation>
    </message>
    <message>
        <source>All benches</source>
        <translation>Alle Messplätze</translation>
    </message>
</context>
<context>
    <name>odo::ImageArea</name>
    <message>
        <source>No view</source>
        <translation>Keine Sicht</translation>
    </message>
    <message>
        <source>This camera was not recording at this time</source>
        <translation>Diese Kamera nahm zu dieser Zeit nicht auf</translation>
    </message>
</context>
<context>
    <name>odo::ImageBars</name>
    <message>
        <source>Error of each image, with a threshold</source>
        <translation>Fehler jedes Bilds, mit einer Schwelle</translation>
    </message>
    <message>
        <source>%1: %2 px</source>
        <translation>%1: %2 px</translation>
    </message>
    <message>
        <source>images; rejected above %1 px</source>
        <translation>Bilder; über %1 px zählen sie nicht</translation>
    </message>
</context>
<context>
    <name>odo::ImageChoice</name>
    <message>
        <source>The camera&apos;s &amp;newest recording</source>
        <translation>In der &amp;neuesten Aufnahme der Kamera</translation>
    </message>
    <message>
        <source>The current image of a &amp;connected camera</source>
        <translation>In dem, was eine an&amp;geschlossene Kamera jetzt sieht</translation>
    </message>
    <message>
        <source>An image or a &amp;video</source>
        <translation>In einem &amp;Bild oder Video</translation>
    </message>
</context>
<context>
    <name>odo::ImportLessonDialog</name>
    <message>
        <source>Robots in the trials</source>
        <translation>Roboter in den Versuchen</translation>
    </message>
    <message>
        <source>Import a lesson</source>
        <translation>Unterrichtsstunde importieren</translation>
    </message>
    <message>
        <source>Clips that were recorded at the same time belong to one trial. Untick what is no run; names and teams can be changed.</source>
        <translation>Videos, die zur selben Zeit aufgenommen wurden, gehören zu einem Versuch. Entfernen Sie den Haken bei dem, was keine Fahrt ist; Namen und Teams lassen sich ändern.</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>Auf&amp;gabe</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>&amp;Roboter</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>Kamera der Sicht %1</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Team of row %1</source>
        <translation>Team in Zeile %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>no clip</source>
        <translation>kein Video</translation>
    </message>
    <message>
        <source>Each trial needs a name of its own.</source>
        <translation>Jeder Versuch braucht einen eigenen Namen.</translation>
    </message>
    <message>
        <source>Tick the trials to import.</source>
        <translation>Wählen Sie die Versuche, die importiert werden sollen.</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgenommen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Clip of %1</source>
        <translation>Video von %1</translation>
    </message>
    <message>
        <source>Each column of clips needs a camera.</source>
        <translation>Jede Spalte mit Videos braucht eine Kamera.</translation>
    </message>
    <message>
        <source>Two clips of %1 are of the same camera.</source>
        <translation>Zwei Videos von %1 gehören derselben Kamera.</translation>
    </message>
</context>
<context>
    <name>odo::ImportTracksDialog</name>
    <message>
        <source>Add &amp;robot</source>
        <translation>&amp;Roboter hinzufügen</translation>
    </message>
    <message>
        <source>Import finished tracks</source>
        <translation>Fertige Spuren importieren</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>Auf&amp;gabe</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Robot of track %1</source>
        <translation>Roboter der Spur %1</translation>
    </message>
    <message>
        <source>A new name creates a new robot</source>
        <translation>Ein neuer Name legt einen neuen Roboter an</translation>
    </message>
    <message>
        <source>File of track %1</source>
        <translation>Datei der Spur %1</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>Te&amp;am</translation>
    </message>
    <message>
        <source>Positions measured by another program or exported by Odograph: TUM, CSV, Tracker text and others. Odograph analyses them as a run without video.</source>
        <translation>Positionen, die ein anderes Programm gemessen oder Odograph exportiert hat: TUM, CSV, Tracker-Text und andere. Odograph wertet sie als Fahrt ohne Video aus.</translation>
    </message>
    <message>
        <source>Tracks (*.csv *.txt *.tum *.tsv *.trc);;All files (*)</source>
        <translation>Bahnen (*.csv *.txt *.tum *.tsv *.trc);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>odo::ImportTrialDialog</name>
    <message>
        <source>Robots in the trial</source>
        <translation>Roboter im Versuch</translation>
    </message>
    <message>
        <source>Add &amp;view</source>
        <translation>&amp;Sicht hinzufügen</translation>
    </message>
    <message>
        <source>Camera&apos;s real &amp;rate</source>
        <translation>Wahre &amp;Bildrate</translation>
    </message>
    <message>
        <source>Import trial from videos</source>
        <translation>Versuch aus Videos importieren</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>Te&amp;am</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>Auf&amp;gabe</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>&amp;Roboter</translation>
    </message>
    <message>
        <source>Videos</source>
        <translation>Videos</translation>
    </message>
    <message>
        <source>&amp;Synchronise</source>
        <translation>S&amp;ynchron</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>Videodatei</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source>Camera&apos;s real rate</source>
        <translation>Wahre Bildrate der Kamera</translation>
    </message>
    <message>
        <source>For slow motion: the file plays slower than the camera recorded it</source>
        <translation>Für Zeitlupe: Die Datei läuft langsamer, als die Kamera sie aufgenommen hat</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>Kamera der Sicht %1</translation>
    </message>
    <message>
        <source>Video of view %1</source>
        <translation>Video der Sicht %1</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;All files (*)</source>
        <translation>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Registration of the camera of view %1</source>
        <translation>Einmessung der Kamera der Sicht %1</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>nicht eingegeben</translation>
    </message>
    <message>
        <source>%1 has no time stamps and states no frame rate. Enter the rate of its camera.</source>
        <translation>%1 hat keine Zeitstempel und nennt keine Bildrate. Bitte die Rate der Kamera eingeben.</translation>
    </message>
    <message>
        <source>Chapters of one recording are joined by +; images are given as their folder, or FOLDER/%06d.png, with the rate</source>
        <translation>Kapitel einer Aufnahme werden mit + verbunden; Einzelbilder gibt man als ihren Ordner an oder als FOLDER/%06d.png, mit der Rate</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Versuch %1</translation>
    </message>
</context>
<context>
    <name>odo::IntervalHistogram</name>
    <message>
        <source>Histogram of the frame intervals</source>
        <translation>Histogramm der Bildabstände</translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2: %n interval(s)</source>
        <translation>
            <numerusform>%1 bis %2: %n Abstand</numerusform>
            <numerusform>%1 bis %2: %n Abstände</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>longer than %1: %n interval(s)</source>
        <translation>
            <numerusform>länger als %1: %n Abstand</numerusform>
            <numerusform>länger als %1: %n Abstände</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::IntervalPanel</name>
    <message>
        <source>%1: fewer than two frames</source>
        <translation>%1: weniger als zwei Bilder</translation>
    </message>
    <message>
        <source>%1: frames are %2 apart (%3 frames/s), from %4 to %5</source>
        <translation>%1: Bilder im Abstand von %2 (%3 Bilder/s), von %4 bis %5</translation>
    </message>
    <message>
        <source>jitter %1</source>
        <translation>Schwankung %1</translation>
    </message>
    <message>
        <source>no frame missing</source>
        <translation>kein Bild fehlt</translation>
    </message>
    <message>
        <source>%1 of %2 frames repeat the one before</source>
        <translation>%1 von %2 Bildern wiederholen das vorige</translation>
    </message>
    <message>
        <source>no frame repeated</source>
        <translation>kein Bild wiederholt</translation>
    </message>
    <message>
        <source>Frame intervals</source>
        <translation>Bildabstände</translation>
    </message>
    <message>
        <source>bars by the logarithm of their number</source>
        <translation>Balken nach dem Logarithmus ihrer Anzahl</translation>
    </message>
    <message>
        <source>Frame intervals of the views</source>
        <translation>Bildabstände der Sichten</translation>
    </message>
    <message>
        <source>This trial has no videos.</source>
        <translation>Dieser Versuch hat keine Videos.</translation>
    </message>
    <message numerus="yes">
        <source>%1 missing in %n gap(s)</source>
        <translation>
            <numerusform>%1 fehlen an %n Stelle</numerusform>
            <numerusform>%1 fehlen an %n Stellen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::JobIndicator</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel the running job</source>
        <translation>Laufenden Vorgang abbrechen</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Wird angehalten…</translation>
    </message>
</context>
<context>
    <name>odo::JointDialog</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Uncertainty before</source>
        <translation>Genauigkeit bisher</translation>
    </message>
    <message>
        <source>Uncertainty, joint</source>
        <translation>Genauigkeit gemeinsam</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>Rückt um</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Off by, mm</source>
        <translation>Abweichung, mm</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Register all cameras (joint)</source>
        <translation>Alle Kameras gemeinsam einmessen</translation>
    </message>
    <message>
        <source>This fits all cameras of layout %1 jointly to the markers they were registered with. Cameras that see the same markers then agree better, and wrongly measured markers show up.</source>
        <translation>Die Kameras des Markerplans %1 werden auf einmal neu angepasst, mit den Markern, an denen sie eingemessen wurden: Wo sie dieselben Marker sehen, stimmen sie danach besser überein, und ein falsch gemessener Marker fällt auf.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Uncertainty of the tape measure</source>
        <translation>Fehler des Maßbands</translation>
    </message>
    <message>
        <source>Marker positions &amp;measured to</source>
        <translation>Die Orte der Marker sind &amp;gemessen auf</translation>
    </message>
    <message>
        <source>Fitting the cameras jointly…</source>
        <translation>Kameras werden gemeinsam angepasst…</translation>
    </message>
    <message>
        <source>The joint uncertainty assumes marker positions measured to %1 mm; registering a single camera assumes them exact. Nothing changes until you save; trials keep the registration they were analysed with.</source>
        <translation>Die gemeinsame Genauigkeit rechnet damit, dass die Orte der Marker auf %1 mm gemessen sind; eine für sich eingemessene Kamera nimmt sie als exakt an. Bis Sie speichern, wird nichts geändert; Versuche behalten die Einmessung, mit der sie ausgewertet wurden.</translation>
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
        <translation>neu messen</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>passt</translation>
    </message>
</context>
<context>
    <name>odo::KeysPage</name>
    <message>
        <source>&amp;Use this key</source>
        <translation>Taste &amp;zuweisen</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Keine Taste</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>&amp;Alle auf Standard</translation>
    </message>
    <message>
        <source>Search for a command or a key</source>
        <translation>Einen Befehl oder eine Taste suchen</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>New key for the selected command</source>
        <translation>Neue Taste des gewählten Befehls</translation>
    </message>
    <message>
        <source>Select a command to change its key.</source>
        <translation>Wählen Sie einen Befehl, um ihm eine andere Taste zu geben.</translation>
    </message>
    <message>
        <source>%1 is the key of “%2”. That command would lose it.</source>
        <translation>%1 ist die Taste von „%2“; dieser Befehl hätte dann keine.</translation>
    </message>
    <message>
        <source>Press the new key in the field.</source>
        <translation>Drücken Sie im Feld die neue Taste.</translation>
    </message>
</context>
<context>
    <name>odo::LayoutDialog</name>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>Tabellen (*.csv *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Marker layout</source>
        <translation>Markerplan</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Was nicht stimmt</translation>
    </message>
    <message>
        <source>Enter the floor positions of the markers, measured with a tape in millimetres from the origin. Seen from above, X points right and Y away from you.</source>
        <translation>Wo die Marker auf dem Boden liegen, mit dem Maßband gemessen: Millimeter vom Ursprung. X geht nach rechts, Y von Ihnen weg, von oben gesehen.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Bezeichnung</translation>
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
        <translation>Marker</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>&amp;Achsen</translation>
    </message>
    <message>
        <source>&amp;CSV</source>
        <translation>&amp;CSV</translation>
    </message>
    <message>
        <source>&amp;Origin at the chosen marker</source>
        <translation>&amp;Ursprung beim gewählten Marker</translation>
    </message>
    <message>
        <source>&amp;Quarter turn</source>
        <translation>&amp;Vierteldrehung</translation>
    </message>
    <message>
        <source>&amp;Half turn</source>
        <translation>&amp;Halbe Drehung</translation>
    </message>
    <message>
        <source>Convert from &amp;centimetres</source>
        <translation>Es waren &amp;Zentimeter</translation>
    </message>
    <message>
        <source>Convert from &amp;metres</source>
        <translation>Es waren &amp;Meter</translation>
    </message>
    <message>
        <source>Convert from &amp;inches</source>
        <translation>Es waren Z&amp;oll</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Positions of the markers (label,x_mm,y_mm)</source>
        <translation>Orte der Marker (label,x_mm,y_mm)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>Positions of the markers</source>
        <translation>Orte der Marker</translation>
    </message>
    <message>
        <source>The layout has no name.</source>
        <translation>Der Markerplan hat keinen Namen.</translation>
    </message>
    <message>
        <source>A layout with this name exists, and cameras may use it. Enter another name.</source>
        <translation>Es gibt schon einen Markerplan dieses Namens: Kameras könnten darauf beruhen, er wird daher nicht überschrieben. Geben Sie einen anderen Namen an.</translation>
    </message>
    <message>
        <source>A marker has no label.</source>
        <translation>Ein Marker hat keine Bezeichnung.</translation>
    </message>
    <message>
        <source>Two markers are called %1.</source>
        <translation>Zwei Marker heißen %1.</translation>
    </message>
    <message>
        <source>The position of %1 is not a number.</source>
        <translation>Der Ort von %1 ist keine Zahl.</translation>
    </message>
    <message>
        <source>The layout needs four markers; it has %1.</source>
        <translation>Vier Marker sind nötig, es sind %1.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same position.</source>
        <translation>%1 und %2 liegen am selben Ort.</translation>
    </message>
    <message>
        <source>The markers are nearly on a line and cannot determine the camera position. Move one to the side.</source>
        <translation>Die Marker liegen fast auf einer Geraden: Sie verraten nicht, wo die Kamera steht. Legen Sie einen abseits davon.</translation>
    </message>
</context>
<context>
    <name>odo::LayoutDrawing</name>
    <message>
        <source>Markers from above</source>
        <translation>Marker von oben</translation>
    </message>
    <message>
        <source>grid %1 m</source>
        <translation>Raster %1 m</translation>
    </message>
</context>
<context>
    <name>odo::LengthPage</name>
    <message>
        <source>S&amp;nap to what is near a click</source>
        <translation>Auf &amp;Nahes einrasten</translation>
    </message>
    <message>
        <source>Image with both ends; arrow keys move the selected one, Space snaps it</source>
        <translation>Bild mit beiden Enden; die Pfeiltasten verschieben das gewählte, die Leertaste rastet es ein</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Measured length</source>
        <translation>Gemessene Länge</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>True length</source>
        <translation>Wahre Länge</translation>
    </message>
    <message>
        <source>Unit of the true length</source>
        <translation>Einheit der wahren Länge</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>on the floor</source>
        <translation>liegt auf dem Boden</translation>
    </message>
    <message>
        <source>&amp;True length</source>
        <translation>&amp;Wahre Länge</translation>
    </message>
    <message>
        <source>H&amp;eight</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Seen as</source>
        <translation>Gesehen als</translation>
    </message>
    <message>
        <source>On the floor, mm</source>
        <translation>Am Boden, mm</translation>
    </message>
    <message>
        <source>Ends of the length</source>
        <translation>Enden der Länge</translation>
    </message>
    <message>
        <source>Both ends</source>
        <translation>Beide Enden</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Put an object of known length anywhere on the floor, such as a metre stick or two markers at a known distance, and click both ends. Keys: arrows move an end (Ctrl: fast, Shift: one pixel), Space snaps it.</source>
        <translation>Legen Sie etwas von bekannter Länge irgendwo auf den Boden, einen Meterstab oder zwei Marker mit bekanntem Abstand, und klicken Sie beide Enden an. Mit Tasten: Die Pfeile verschieben ein Ende (Strg: schnell, Umschalt: ein Pixel), die Leertaste rastet es ein.</translation>
    </message>
    <message>
        <source>%1 ± %2 mm</source>
        <translation>%1 ± %2 mm</translation>
    </message>
    <message>
        <source>within uncertainty</source>
        <translation>im Rahmen des erwarteten Fehlers</translation>
    </message>
    <message>
        <source>outside uncertainty</source>
        <translation>größer als der erwartete Fehler</translation>
    </message>
    <message>
        <source> Enter its true length to check the result.</source>
        <translation> Geben Sie die wahre Länge an, um zu sehen, ob das stimmt.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>beyond the horizon</source>
        <translation>jenseits des Horizonts</translation>
    </message>
    <message>
        <source>not set yet</source>
        <translation>noch nicht gesetzt</translation>
    </message>
</context>
<context>
    <name>odo::LengthWizard</name>
    <message>
        <source>Check a known length</source>
        <translation>Bekannte Länge prüfen</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Fertig</translation>
    </message>
    <message>
        <source>Image or video of the length</source>
        <translation>Bild oder Video der Länge</translation>
    </message>
    <message>
        <source>The camera and its image</source>
        <translation>Die Kamera und ihr Bild</translation>
    </message>
    <message>
        <source>Both ends of the length</source>
        <translation>Beide Enden der Länge</translation>
    </message>
    <message>
        <source>Put an object of known length on the floor, away from the markers, to check the camera&apos;s stated uncertainty. This changes nothing.</source>
        <translation>Legen Sie etwas von bekannter Länge auf den Boden, abseits der Marker, und sehen Sie, ob die Kamera es so gut misst, wie sie verspricht. Dabei wird nichts geändert.</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>Image of the length</source>
        <translation>Wo die Länge zu sehen ist</translation>
    </message>
    <message>
        <source>Loading the image…</source>
        <translation>Bild wird geholt…</translation>
    </message>
    <message>
        <source>Choose an image or a video.</source>
        <translation>Wählen Sie ein Bild oder ein Video.</translation>
    </message>
</context>
<context>
    <name>odo::LensWizard</name>
    <message>
        <source>Calibrate camera</source>
        <translation>Kamera kalibrieren</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>The camera and the board</source>
        <translation>Die Kamera und die Tafel</translation>
    </message>
    <message>
        <source>Images of the board</source>
        <translation>Bilder der Tafel</translation>
    </message>
    <message>
        <source>The lens</source>
        <translation>Das Objektiv</translation>
    </message>
    <message>
        <source>At least %1 images that show the board are needed; so far there are %2.</source>
        <translation>Nötig sind mindestens %1 Bilder, die die Tafel zeigen; bisher sind es %2.</translation>
    </message>
    <message>
        <source>There is no lens calibration to save yet.</source>
        <translation>Es gibt noch keine Objektivkalibrierung zum Speichern.</translation>
    </message>
    <message numerus="yes">
        <source>%n image(s) of the board</source>
        <translation>
            <numerusform>%n Bild der Tafel</numerusform>
            <numerusform>%n Bilder der Tafel</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::LessonBar</name>
    <message>
        <source>Ne&amp;xt</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>&amp;Leave the lesson</source>
        <translation>Lektion &amp;verlassen</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Fertig</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>Ü&amp;berspringen</translation>
    </message>
</context>
<context>
    <name>odo::LiveBoard</name>
    <message>
        <source>Top-down map</source>
        <translation>Karte von oben</translation>
    </message>
    <message>
        <source>Health of cameras, map and disk</source>
        <translation>Wie es Kameras, Karte und Festplatte geht</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>Live view of %1</source>
        <translation>Livebild von %1</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>nicht eingemessen</translation>
    </message>
    <message>
        <source>Opening the camera…</source>
        <translation>Kamera wird geöffnet…</translation>
    </message>
    <message>
        <source>live, sent to %1</source>
        <translation>live, gesendet an %1</translation>
    </message>
    <message>
        <source>live</source>
        <translation>live</translation>
    </message>
    <message>
        <source>Waiting for the first frame…</source>
        <translation>Warten auf das erste Bild…</translation>
    </message>
    <message>
        <source>No frames now</source>
        <translation>Gerade kein Bild</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
</context>
<context>
    <name>odo::LiveCameraBox</name>
    <message>
        <source>Connected camera</source>
        <translation>Angeschlossene Kamera</translation>
    </message>
    <message>
        <source>%1, %2×%3</source>
        <translation>%1, %2×%3</translation>
    </message>
    <message>
        <source>Searching for cameras…</source>
        <translation>Kameras werden gesucht…</translation>
    </message>
    <message>
        <source>No camera is connected</source>
        <translation>Keine Kamera ist angeschlossen</translation>
    </message>
</context>
<context>
    <name>odo::LiveMap</name>
    <message>
        <source>Live floor map with the robots</source>
        <translation>Karte des Bodens mit den Robotern während der Fahrt</translation>
    </message>
    <message>
        <source>No camera is registered to the floor: robots cannot be located</source>
        <translation>Keine Kamera ist zum Boden eingemessen, daher lässt sich kein Ort darauf angeben</translation>
    </message>
</context>
<context>
    <name>odo::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Pr&amp;eferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>A recording is running. The change takes effect when you reopen the project.</source>
        <translation>Die Seiten folgen, wenn das Projekt wieder geöffnet wird, denn eine Aufnahme läuft noch.</translation>
    </message>
    <message>
        <source>Restore the backup</source>
        <translation>Sicherungskopie wiederherstellen</translation>
    </message>
    <message>
        <source>Another program deleted, renamed or replaced “%1”. Odograph will rescue its contents when the running job has ended.</source>
        <translation>„%1“ wurde von einem anderen Programm gelöscht, umbenannt oder ersetzt. Der Inhalt wird gerettet, sobald die laufende Arbeit beendet ist.</translation>
    </message>
    <message>
        <source>Another program deleted, renamed or replaced “%1”. Odograph rescued its contents in “%2” and opened that project.</source>
        <translation>„%1“ wurde von einem anderen Programm gelöscht, umbenannt oder ersetzt. Der Inhalt ist in „%2“ gerettet, das jetzt geöffnet ist.</translation>
    </message>
    <message>
        <source>Another program overwrote “%1”. Odograph will open the new contents when the running job has ended.</source>
        <translation>Ein anderes Programm hat „%1“ überschrieben. Was jetzt darin ist, wird geöffnet, sobald die laufende Arbeit beendet ist.</translation>
    </message>
    <message>
        <source>Another program renamed “%1” and its videos. It is now open as “%2”.</source>
        <translation>„%1“ wurde mit seinen Videos von einem anderen Programm umbenannt. Es ist jetzt als „%2“ geöffnet.</translation>
    </message>
    <message>
        <source>Another program overwrote “%1” while it was open. Its earlier contents are gone; the window shows the new ones.</source>
        <translation>Ein anderes Programm hat „%1“ überschrieben, während es offen war: Was vorher darin war, ist verloren. Gezeigt wird, was jetzt darin ist.</translation>
    </message>
    <message>
        <source>C&amp;lass</source>
        <translation>K&amp;lasse</translation>
    </message>
    <message>
        <source>You and another bench changed the same things. Both versions are kept.</source>
        <translation>Sie und ein anderer Messplatz haben dasselbe geändert. Beide Fassungen sind erhalten.</translation>
    </message>
    <message>
        <source>Show both</source>
        <translation>Beide zeigen</translation>
    </message>
</context>
<context>
    <name>odo::MapArea</name>
    <message>
        <source>0 to %1 apart</source>
        <translation>0 bis %1 auseinander</translation>
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
        <translation>&amp;Stern</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>&amp;Archivieren</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Empty the bin…</source>
        <translation>&amp;Papierkorb leeren…</translation>
    </message>
    <message>
        <source>Remove &amp;star</source>
        <translation>&amp;Stern entfernen</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>Aus dem &amp;Archiv holen</translation>
    </message>
    <message>
        <source>Rest&amp;ore</source>
        <translation>&amp;Zurücklegen</translation>
    </message>
    <message>
        <source>Restore the selected trials from the bin (Del)</source>
        <translation>Holt die ausgewählten Versuche aus dem Papierkorb (Entf)</translation>
    </message>
    <message>
        <source>Move the selected trials to the bin (Del); you can restore them</source>
        <translation>Legt die ausgewählten Versuche in den Papierkorb (Entf); sie lassen sich zurücklegen</translation>
    </message>
    <message>
        <source>Empty the bin</source>
        <translation>Papierkorb leeren</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n trial(s) for good?</source>
        <translation>
            <numerusform>%n Versuch endgültig entfernen?</numerusform>
            <numerusform>%n Versuche endgültig entfernen?</numerusform>
        </translation>
    </message>
    <message>
        <source>This removes their videos (%1), measurements and results from the disk. You cannot undo it.</source>
        <translation>Die zugehörigen Videos (%1), Messungen und Ergebnisse werden von der Festplatte entfernt. Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>&amp;Remove for good</source>
        <translation>&amp;Endgültig entfernen</translation>
    </message>
</context>
<context>
    <name>odo::MarkerCanvas</name>
    <message>
        <source>Image with the markers; arrow keys move the selected one</source>
        <translation>Bild mit den Markern; die Pfeiltasten verschieben den gewählten</translation>
    </message>
</context>
<context>
    <name>odo::MarkerPage</name>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Herausnehmen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>Ort, mm</translation>
    </message>
    <message>
        <source>Seen as</source>
        <translation>Gesehen als</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>Select a marker in the table and click its position. The click snaps to what is near it, to a tenth of a pixel.</source>
        <translation>Wählen Sie in der Tabelle einen Marker und klicken Sie dorthin, wo er ist; was nahe beim Klick liegt, wird auf ein Zehntel Pixel genau genommen.</translation>
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
        <translation>nicht gesehen</translation>
    </message>
</context>
<context>
    <name>odo::MatDialog</name>
    <message>
        <source>Find the floor mat</source>
        <translation>Bodenmatte suchen</translation>
    </message>
    <message>
        <source>The mat is searched for in the newest recording of each camera: %1.</source>
        <translation>Die Matte wird in der neuesten Aufnahme jeder Kamera gesucht: %1.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Measure the line at the mat&apos;s lower edge from end mark to end mark. Printers often shrink by 2 to 4 %; what you enter makes up for it.</source>
        <translation>Messen Sie die Linie am unteren Rand der Matte von Endstrich zu Endstrich. Drucker verkleinern oft um 2 bis 4 %; Ihre Eingabe gleicht das aus.</translation>
    </message>
    <message>
        <source>&amp;Check line</source>
        <translation>&amp;Prüflinie</translation>
    </message>
    <message>
        <source>Find the mat</source>
        <translation>Matte suchen</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
</context>
<context>
    <name>odo::MessageBar</name>
    <message>
        <source>Close the message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Abgebrochen. Nichts wurde geändert.</translation>
    </message>
</context>
<context>
    <name>odo::MetricGrid</name>
    <message>
        <source>Metrics</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>No result yet: track the trial</source>
        <translation>Noch kein Ergebnis: zuerst den Roboter verfolgen</translation>
    </message>
</context>
<context>
    <name>odo::MetricModel</name>
    <message>
        <source>Metric</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
</context>
<context>
    <name>odo::ModeBar</name>
    <message>
        <source>Modes</source>
        <translation>Modi</translation>
    </message>
</context>
<context>
    <name>odo::NetworkPage</name>
    <message>
        <source>&amp;Send live positions on the network</source>
        <translation>Live-Orte ins Netz &amp;senden</translation>
    </message>
    <message>
        <source>%1: this computer only</source>
        <translation>%1: nur dieser Rechner</translation>
    </message>
    <message>
        <source>%1: not available now</source>
        <translation>%1: zurzeit nicht da</translation>
    </message>
    <message>
        <source>Positions of the robots that Record tracks, as SSL-Vision packets for your own controllers and programs. The packets contain no names of teams or robots.</source>
        <translation>Die Orte der Roboter, die unter Aufnahme verfolgt werden, als Pakete von SSL-Vision, für Regler und eigene Programme. Namen von Teams oder Robotern sind nicht darin.</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>&amp;Adresse</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>&amp;Interface</source>
        <translation>Sch&amp;nittstelle</translation>
    </message>
    <message>
        <source>Odograph sends nothing.</source>
        <translation>Nichts wird gesendet.</translation>
    </message>
    <message>
        <source>This is not an IPv4 address; enter one such as 224.5.23.2.</source>
        <translation>Das ist keine IPv4-Adresse; schreiben Sie sie wie 224.5.23.2.</translation>
    </message>
    <message>
        <source>They go only to the computer with this address.</source>
        <translation>Sie gehen an den einen Rechner mit dieser Adresse.</translation>
    </message>
    <message>
        <source>They do not leave this computer.</source>
        <translation>Sie verlassen diesen Rechner nicht.</translation>
    </message>
    <message>
        <source>Anyone on that network can read the robots&apos; positions.</source>
        <translation>Wer in diesem Netz ist, kann lesen, wo die Roboter sind.</translation>
    </message>
</context>
<context>
    <name>odo::NumberText</name>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
</context>
<context>
    <name>odo::PathField</name>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>Durchsuchen: %1</translation>
    </message>
    <message>
        <source>Images and videos (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov *.webm);;All files (*)</source>
        <translation>Bilder und Videos (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov *.webm);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>odo::PathSketch</name>
    <message>
        <source>The path from above</source>
        <translation>Der Weg von oben</translation>
    </message>
</context>
<context>
    <name>odo::PickColourDialog</name>
    <message>
        <source>Pick the robot&apos;s colour</source>
        <translation>Farbe des Roboters aus einem Bild</translation>
    </message>
    <message>
        <source>Another &amp;video…</source>
        <translation>Anderes &amp;Video…</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>&amp;Aufnahme</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>&amp;Bild</translation>
    </message>
    <message>
        <source>Choose a video that shows the robot.</source>
        <translation>Wählen Sie ein Video, in dem der Roboter zu sehen ist.</translation>
    </message>
    <message>
        <source>Use this colour</source>
        <translation>Diese Farbe nehmen</translation>
    </message>
    <message>
        <source>Video that shows the robot</source>
        <translation>Video, in dem der Roboter zu sehen ist</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mov *.mkv *.avi *.m4v);;All files (*)</source>
        <translation>Videos (*.mp4 *.mov *.mkv *.avi *.m4v);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>The robot&apos;s colour here: %1. It fills %2 % of the box.</source>
        <translation>Die Farbe des Roboters hier: %1. Sie füllt %2 % des Rahmens.</translation>
    </message>
    <message>
        <source>Draw a tight box round the robot with the mouse, or use the keyboard: arrow keys move the box, Shift + arrow keys resize it.</source>
        <translation>Ziehen Sie mit der Maus einen engen Rahmen um den Roboter; oder mit den Pfeiltasten, die den Rahmen verschieben und mit Umschalt größer oder kleiner machen.</translation>
    </message>
    <message>
        <source>%1, camera %2</source>
        <translation>%1, Kamera %2</translation>
    </message>
</context>
<context>
    <name>odo::PlannedCameraForm</name>
    <message>
        <source>Position x</source>
        <translation>Steht bei x</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>Steht bei y</translation>
    </message>
    <message>
        <source>Height of the camera</source>
        <translation>Höhe der Kamera</translation>
    </message>
    <message>
        <source>Looks at x</source>
        <translation>Blickt auf x</translation>
    </message>
    <message>
        <source>Looks at y</source>
        <translation>Blickt auf y</translation>
    </message>
    <message>
        <source>Viewing direction</source>
        <translation>Richtung, in die sie blickt</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>0° is along X, 90° along Y; the point that the camera looks at turns with it</source>
        <translation>0° ist längs X, 90° längs Y; Drehen dreht den anvisierten Punkt um die Kamera</translation>
    </message>
    <message>
        <source>Across the image width: a webcam has about 60° to 80°, a phone 65°</source>
        <translation>Über die Breite des Bilds: Eine Webcam hat etwa 60° bis 80°, ein Smartphone 65°</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>Größe ihrer Bilder</translation>
    </message>
    <message>
        <source>Po&amp;sition x, y</source>
        <translation>&amp;Steht bei x, y</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Looks at x, y</source>
        <translation>&amp;Blickt auf x, y</translation>
    </message>
    <message>
        <source>D&amp;irection</source>
        <translation>&amp;Richtung</translation>
    </message>
    <message>
        <source>&amp;Field of view</source>
        <translation>Bild&amp;winkel</translation>
    </message>
</context>
<context>
    <name>odo::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Categories of preferences</source>
        <translation>Arten von Einstellungen</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;Allgemein</translation>
    </message>
    <message>
        <source>&amp;Reports</source>
        <translation>&amp;Berichte</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;Network</source>
        <translation>&amp;Netz</translation>
    </message>
</context>
<context>
    <name>odo::ProfileChart</name>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>Position X</source>
        <translation>Ort X</translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation>Ort Y</translation>
    </message>
    <message>
        <source>Quantity of the chart</source>
        <translation>Größe, die das Diagramm zeigt</translation>
    </message>
    <message>
        <source>smoothed ±95 %</source>
        <translation>geglättet ±95 %</translation>
    </message>
    <message>
        <source>measured points</source>
        <translation>gemessene Punkte</translation>
    </message>
    <message>
        <source>1 spike</source>
        <translation>1 Ausreißer</translation>
    </message>
    <message>
        <source>%1 spikes</source>
        <translation>%1 Ausreißer</translation>
    </message>
    <message>
        <source>along the path</source>
        <translation>längs der Bahn</translation>
    </message>
    <message>
        <source>of the motion, anticlockwise from X</source>
        <translation>der Bewegung, gegen den Uhrzeigersinn ab X</translation>
    </message>
    <message>
        <source>anticlockwise positive</source>
        <translation>gegen den Uhrzeigersinn positiv</translation>
    </message>
    <message>
        <source>Chart: %1 over time</source>
        <translation>Diagramm: %1 über der Zeit</translation>
    </message>
    <message>
        <source>Chart: %1 over distance</source>
        <translation>Diagramm: %1 über dem Weg</translation>
    </message>
    <message>
        <source>of the body, anticlockwise from X</source>
        <translation>des Rumpfs, gegen den Uhrzeigersinn ab X</translation>
    </message>
    <message>
        <source>shaded: hidden, ambiguous or not measured</source>
        <translation>schattiert: verdeckt, zweifelhaft oder nicht gemessen</translation>
    </message>
    <message>
        <source>Velocity X</source>
        <translation>Geschwindigkeit X</translation>
    </message>
    <message>
        <source>Velocity Y</source>
        <translation>Geschwindigkeit Y</translation>
    </message>
    <message>
        <source>Lateral acceleration</source>
        <translation>Querbeschleunigung</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Ruck</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>Zurückgelegter Weg</translation>
    </message>
    <message>
        <source>Distance from the start</source>
        <translation>Abstand vom Start</translation>
    </message>
    <message>
        <source>to the left positive</source>
        <translation>nach links positiv</translation>
    </message>
    <message>
        <source>along the path, mean over %1</source>
        <translation>längs der Bahn, Mittel über %1</translation>
    </message>
    <message>
        <source>Distance to the nearest robot</source>
        <translation>Abstand zum nächsten Roboter</translation>
    </message>
</context>
<context>
    <name>odo::RangeActions</name>
    <message>
        <source>Set &amp;start here</source>
        <translation>&amp;Start hier setzen</translation>
    </message>
    <message>
        <source>The results are of the run from this time on; before it nothing counts.</source>
        <translation>Die Ergebnisse gelten für die Fahrt ab diesem Zeitpunkt; davor zählt nichts.</translation>
    </message>
    <message>
        <source>Set &amp;end here</source>
        <translation>&amp;Ende hier setzen</translation>
    </message>
    <message>
        <source>The results are of the run up to this time; after it nothing counts.</source>
        <translation>Die Ergebnisse gelten für die Fahrt bis zu diesem Zeitpunkt; danach zählt nichts.</translation>
    </message>
    <message>
        <source>From first to last &amp;motion</source>
        <translation>Von der ersten bis zur letzten Be&amp;wegung</translation>
    </message>
    <message>
        <source>The results are of the run from when a robot first moves to when it last does.</source>
        <translation>Die Ergebnisse gelten für die Fahrt von der ersten bis zur letzten Bewegung eines Roboters.</translation>
    </message>
    <message>
        <source>&amp;Whole run</source>
        <translation>&amp;Ganze Fahrt</translation>
    </message>
    <message>
        <source>The results are of all of the trial again.</source>
        <translation>Die Ergebnisse gelten wieder für den ganzen Versuch.</translation>
    </message>
</context>
<context>
    <name>odo::RangeCard</name>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Anpassung</translation>
    </message>
    <message>
        <source>Robot of the statistics</source>
        <translation>Roboter, dessen Bereich gezeigt wird</translation>
    </message>
    <message>
        <source>Function to fit to the curve</source>
        <translation>Was an die Kurve angepasst wird</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>Konstante</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>parabola</source>
        <translation>Parabel</translation>
    </message>
    <message>
        <source>Fitted quantity</source>
        <translation>Größe, die angepasst wird</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Statistics of the selection</source>
        <translation>Kennwerte der Auswahl</translation>
    </message>
</context>
<context>
    <name>odo::RecordPage</name>
    <message>
        <source>No camera is connected</source>
        <translation>Keine Kamera ist angeschlossen</translation>
    </message>
    <message>
        <source>Connect one or two cameras, then search again. If a connected camera is not found, run the set-up doctor.</source>
        <translation>Schließen Sie eine oder zwei Kameras an und suchen Sie erneut. Eine, die angeschlossen ist und nicht gefunden wird, ist ein Fall für die Aufbaudiagnose.</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Erneut suchen</translation>
    </message>
    <message>
        <source>Set-up doctor…</source>
        <translation>Aufbaudiagnose…</translation>
    </message>
    <message>
        <source>Choose &amp;cameras…</source>
        <translation>Kamera&amp;s wählen…</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>Kameras…</translation>
    </message>
    <message>
        <source>Assign the connected devices to the cameras of the project</source>
        <translation>Wählen, welches angeschlossene Gerät welche Kamera des Projekts ist</translation>
    </message>
    <message>
        <source>Set-up &amp;doctor…</source>
        <translation>Aufbaud&amp;iagnose…</translation>
    </message>
    <message>
        <source>Doctor…</source>
        <translation>Diagnose…</translation>
    </message>
    <message>
        <source>Check for what makes cameras lose frames or measure wrongly, and get advice</source>
        <translation>Nachsehen, wodurch Kameras Bilder verlieren oder falsch messen, mit Rat</translation>
    </message>
    <message>
        <source>Give the trial a name</source>
        <translation>Geben Sie dem Versuch einen Namen</translation>
    </message>
</context>
<context>
    <name>odo::ReferenceCameraPage</name>
    <message>
        <source>Image or video of the camera to register</source>
        <translation>Bild oder Video der einzumessenden Kamera</translation>
    </message>
    <message>
        <source>Image or video of the registered camera</source>
        <translation>Bild oder Video der eingemessenen Kamera</translation>
    </message>
    <message>
        <source>A camera cannot be registered via itself: choose two different ones.</source>
        <translation>Eine Kamera lässt sich nicht über sich selbst einmessen: Wählen Sie zwei verschiedene.</translation>
    </message>
    <message>
        <source>Camera to register</source>
        <translation>Einzumessende Kamera</translation>
    </message>
    <message>
        <source>Registered camera</source>
        <translation>Eingemessene Kamera</translation>
    </message>
    <message>
        <source>Register a camera that sees no markers by floor points that a registered camera also sees: corners of tiles, ends of tape, screws. Four are enough; six or more, spread over the common area, are better. Do not move either camera afterwards.</source>
        <translation>Eine Kamera, die keine Marker sieht, lässt sich über Punkte des Bodens einmessen, die auch eine eingemessene Kamera sieht: Ecken von Fliesen, Enden von Klebeband, Schrauben. Vier genügen, sechs oder mehr, über den gemeinsamen Teil verteilt, sind besser. Danach darf keine der beiden Kameras bewegt werden.</translation>
    </message>
    <message>
        <source>C&amp;amera to register</source>
        <translation>Einzumessende &amp;Kamera</translation>
    </message>
    <message>
        <source>&amp;Via camera</source>
        <translation>Ü&amp;ber Kamera</translation>
    </message>
    <message>
        <source>Its image</source>
        <translation>Ihr Bild</translation>
    </message>
    <message>
        <source>The registered camera&apos;s image</source>
        <translation>Das Bild der eingemessenen Kamera</translation>
    </message>
    <message>
        <source>Choose an image for each camera.</source>
        <translation>Wählen Sie für jede Kamera ein Bild.</translation>
    </message>
</context>
<context>
    <name>odo::RegisterViaCameraWizard</name>
    <message>
        <source>Register via another camera</source>
        <translation>Über andere Kamera einmessen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Two cameras and their images</source>
        <translation>Zwei Kameras und ihre Bilder</translation>
    </message>
    <message>
        <source>The same points in both images</source>
        <translation>Dieselben Punkte in beiden Bildern</translation>
    </message>
    <message>
        <source>Loading the images…</source>
        <translation>Bilder werden geholt…</translation>
    </message>
    <message>
        <source>There is no registration to save yet.</source>
        <translation>Es gibt noch keine Einmessung zum Speichern.</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>die Einmessung</translation>
    </message>
</context>
<context>
    <name>odo::RegistrationVerdict</name>
    <message>
        <source>Camera position</source>
        <translation>Wo die Kamera steht</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Camera position: x %1 m, y %2 m, %3 m above the floor.</source>
        <translation>Sie steht bei x %1 m, y %2 m, %3 m über dem Boden.</translation>
    </message>
    <message>
        <source>The registration was not stored. %1</source>
        <translation>Die Einmessung wurde nicht gespeichert. %1</translation>
    </message>
</context>
<context>
    <name>odo::ReportActions</name>
    <message>
        <source>The trial %1</source>
        <translation>Der Versuch %1</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Bericht…</translation>
    </message>
    <message>
        <source>The comparison of %1 and %2</source>
        <translation>Der Vergleich von %1 und %2</translation>
    </message>
    <message>
        <source>A class</source>
        <translation>Eine Klasse</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s), a page each</source>
        <translation>
            <numerusform>%n Versuch, je eine Seite</numerusform>
            <numerusform>%n Versuche, je eine Seite</numerusform>
        </translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>PDF-Dateien (*.pdf)</translation>
    </message>
    <message>
        <source>Report saved as %1.</source>
        <translation>Der Bericht ist in %1.</translation>
    </message>
    <message>
        <source>Report sent to printer %1.</source>
        <translation>Der Bericht ist beim Drucker %1.</translation>
    </message>
    <message>
        <source>Over the floor that the cameras see</source>
        <translation>Über den sichtbaren Boden</translation>
    </message>
    <message>
        <source>The simulated run:</source>
        <translation>Die simulierte Fahrt:</translation>
    </message>
    <message>
        <source>Save the certificate</source>
        <translation>Zertifikat speichern</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Zertifikat</translation>
    </message>
    <message>
        <source>Certificate saved as %1.</source>
        <translation>Das Zertifikat ist in %1.</translation>
    </message>
    <message>
        <source>C&amp;ertificate of this set-up…</source>
        <translation>Zert&amp;ifikat dieses Aufbaus…</translation>
    </message>
</context>
<context>
    <name>odo::ReportDialog</name>
    <message>
        <source>A page for each &amp;team</source>
        <translation>Je &amp;Team eine Seite</translation>
    </message>
    <message>
        <source>A second page with the &amp;method</source>
        <translation>Zweite Seite zur &amp;Methode</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>Als PDF &amp;speichern…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken…</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>&amp;Klasse</translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation>&amp;Aufgabe</translation>
    </message>
    <message>
        <source>Most common</source>
        <translation>Die übliche</translation>
    </message>
    <message>
        <source>M&amp;etric</source>
        <translation>K&amp;ennwert</translation>
    </message>
    <message>
        <source>Most informative</source>
        <translation>Was am meisten sagt</translation>
    </message>
    <message>
        <source>Report &amp;of</source>
        <translation>&amp;Bericht über</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>&amp;Papier</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>School, &amp;logo and wording…</source>
        <translation>Schule, &amp;Logo und Text…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Nothing to print yet.</source>
        <translation>Es gibt noch nichts zu drucken.</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n Seite</numerusform>
            <numerusform>%n Seiten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n page(s); the file has all of them.</source>
        <translation>
            <numerusform>Die erste Seite; die Datei hat alle.</numerusform>
            <numerusform>Die ersten %n Seiten; die Datei hat alle.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportPreview</name>
    <message>
        <source>Preview of the pages</source>
        <translation>Vorschau der Seiten</translation>
    </message>
    <message>
        <source>Drawing the pages…</source>
        <translation>Seiten werden gezeichnet…</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n Seite</numerusform>
            <numerusform>%n Seiten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportsPage</name>
    <message>
        <source>&amp;School</source>
        <translation>&amp;Schule</translation>
    </message>
    <message>
        <source>shown at the top of each page</source>
        <translation>steht im Kopf jeder Seite</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg *.svg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.svg)</translation>
    </message>
    <message>
        <source>&amp;Logo</source>
        <translation>&amp;Logo</translation>
    </message>
    <message>
        <source>Preview of the logo</source>
        <translation>Wie das Logo aussieht</translation>
    </message>
    <message>
        <source>&amp;At the bottom</source>
        <translation>&amp;Fußzeile</translation>
    </message>
    <message>
        <source>for example: whom to ask</source>
        <translation>zum Beispiel: wer Fragen beantwortet</translation>
    </message>
</context>
<context>
    <name>odo::ReprocessDialog</name>
    <message>
        <source>none</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>&amp;Reanalyse</source>
        <translation>&amp;Neu auswerten</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>Reanalyse trials</source>
        <translation>Versuche neu auswerten</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Was sich ändert</translation>
    </message>
    <message>
        <source>What changes, in words</source>
        <translation>Was sich ändert, in Worten</translation>
    </message>
    <message>
        <source>What was detected in the videos stays as it is; its floor positions are recomputed with the current registrations. Check what changes, then keep it or not: the older analysis stays in the project too.</source>
        <translation>Was in den Videos gesehen wurde, bleibt, wie es ist; wo es auf dem Boden liegt, wird mit den jetzt gültigen Einmessungen berechnet. Sehen Sie an, was sich ändert, und behalten Sie es oder nicht: Auch die ältere Auswertung bleibt im Projekt.</translation>
    </message>
    <message>
        <source>&amp;Trial</source>
        <translation>&amp;Versuch</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 (measured with an older registration)</source>
        <translation>%1 (mit älterer Einmessung ausgewertet)</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Wird ausgewertet…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Kept: the new analysis of %1 is the current one.</source>
        <translation>Behalten: Die neue Auswertung von %1 ist die aktuelle.</translation>
    </message>
</context>
<context>
    <name>odo::ResidualPlot</name>
    <message>
        <source>Residual against the cut-off</source>
        <translation>Residuum über der Grenzfrequenz</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>selbsttätig</translation>
    </message>
    <message>
        <source>residual analysis</source>
        <translation>Residuenanalyse</translation>
    </message>
    <message>
        <source>a filter of %1 takes away %2</source>
        <translation>ein Filter von %1 nimmt %2 weg</translation>
    </message>
</context>
<context>
    <name>odo::ResultPanel</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Robot whose result is shown</source>
        <translation>Roboter, dessen Ergebnis gezeigt wird</translation>
    </message>
    <message>
        <source>robot “%1”</source>
        <translation>Roboter „%1“</translation>
    </message>
</context>
<context>
    <name>odo::ReviewColumn</name>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Facts of the trial</source>
        <translation>Angaben zum Versuch</translation>
    </message>
    <message>
        <source>This trial has not been tracked yet. Tracking follows the robot through the videos and computes its position and speed.</source>
        <translation>In diesem Versuch wurde der Roboter noch nicht verfolgt. Die Verfolgung folgt ihm durch die Videos und ermittelt, wo er war und wie schnell.</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>Verfolgen…</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>The areas have changed since this trial was tracked. Track it again to use them.</source>
        <translation>Die Bereiche haben sich geändert, seit dieser Versuch verfolgt wurde. Verfolgen Sie ihn erneut, um sie zu verwenden.</translation>
    </message>
</context>
<context>
    <name>odo::ReviewDesk</name>
    <message>
        <source>&amp;Silhouettes of the robots</source>
        <translation>&amp;Silhouetten der Roboter</translation>
    </message>
    <message>
        <source>Outline the detected robots in each view</source>
        <translation>Zeichnet in jeder Sicht den Umriss dessen, was für einen Roboter gehalten wurde</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Zoom to &amp;fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>&amp;Enlarge, or back</source>
        <translation>Sicht ma&amp;ximieren oder zurück</translation>
    </message>
    <message>
        <source>Of the view or map under the mouse</source>
        <translation>Der Sicht oder Karte unter der Maus</translation>
    </message>
    <message>
        <source>Lo&amp;upe on the robot</source>
        <translation>L&amp;upe am Roboter</translation>
    </message>
    <message>
        <source>Show the surroundings of the robot eight times as large as recorded</source>
        <translation>Die Umgebung des Roboters achtmal so groß wie aufgenommen zeigen</translation>
    </message>
</context>
<context>
    <name>odo::ReviewPage</name>
    <message>
        <source>No trials yet</source>
        <translation>Noch keine Versuche</translation>
    </message>
    <message>
        <source>A trial is one run of a robot. Import the videos that your cameras took of it to see it here.</source>
        <translation>Ein Versuch ist eine Fahrt eines Roboters. Importieren Sie die Videos, die Ihre Kameras davon aufgenommen haben, und er wird hier gezeigt.</translation>
    </message>
    <message>
        <source>Import trial from videos…</source>
        <translation>Versuch aus Videos importieren…</translation>
    </message>
    <message>
        <source>Accept doubtful results</source>
        <translation>Zweifelhafte Ergebnisse akzeptieren</translation>
    </message>
    <message>
        <source>Why can these results be used? The reason is shown wherever they are.</source>
        <translation>Warum sind diese Ergebnisse brauchbar? Der Grund steht überall dabei, wo sie erscheinen.</translation>
    </message>
</context>
<context>
    <name>odo::RevisionImage</name>
    <message>
        <source>Source image</source>
        <translation>Bild, aus dem sie entstanden ist</translation>
    </message>
    <message>
        <source>Reading the image…</source>
        <translation>Bild wird gelesen…</translation>
    </message>
    <message>
        <source>Cannot read the image.</source>
        <translation>Das Bild lässt sich nicht lesen.</translation>
    </message>
</context>
<context>
    <name>odo::RevisionsDialog</name>
    <message>
        <source>&amp;Use this one</source>
        <translation>&amp;Diese nehmen</translation>
    </message>
    <message>
        <source>&amp;Register with this calibration</source>
        <translation>Mit diesem Objektiv &amp;einmessen</translation>
    </message>
    <message>
        <source>Reanalyse &amp;trials…</source>
        <translation>Versuche &amp;neu auswerten…</translation>
    </message>
    <message>
        <source>Calibrations and registrations</source>
        <translation>Kalibrierungen und Einmessungen</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Erstellt</translation>
    </message>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Gültig</translation>
    </message>
    <message>
        <source>Revisions</source>
        <translation>Revisionen</translation>
    </message>
    <message>
        <source>Makes the selected revision the current one for new measurements; trials keep theirs</source>
        <translation>Macht die gewählte Revision für alles gültig, was von jetzt an gemessen wird; Versuche behalten ihre</translation>
    </message>
    <message>
        <source>Recomputes the current registration from the same markers, with the current lens calibration</source>
        <translation>Berechnet die gültige Einmessung aus denselben Markern neu, mit dem gültigen Objektiv</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The camera is neither calibrated nor registered yet.</source>
        <translation>Die Kamera ist noch weder kalibriert noch eingemessen.</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Calibration %1</source>
        <translation>Kalibrierung %1</translation>
    </message>
    <message>
        <source>Registration %1</source>
        <translation>Einmessung %1</translation>
    </message>
    <message>
        <source>current</source>
        <translation>gültig</translation>
    </message>
    <message>
        <source>No trial uses it.</source>
        <translation>Kein Versuch wurde damit ausgewertet.</translation>
    </message>
    <message>
        <source>Trials that use it: %1.</source>
        <translation>Damit ausgewertete Versuche: %1.</translation>
    </message>
    <message>
        <source>%1 is now current. The registrations keep the lens calibration that they were made with: register the camera with this one.</source>
        <translation>%1 ist gültig. Die Einmessungen behalten das Objektiv, mit dem sie erstellt wurden: Messen Sie die Kamera mit diesem ein.</translation>
    </message>
    <message>
        <source>%1 is now current. Trials keep theirs until you reanalyse them.</source>
        <translation>%1 ist gültig. Versuche behalten ihre, bis sie neu ausgewertet werden.</translation>
    </message>
    <message>
        <source>Registration %1 is now current: the same markers, with this lens calibration. %2</source>
        <translation>Einmessung %1 ist gültig: dieselben Marker, mit diesem Objektiv. %2</translation>
    </message>
</context>
<context>
    <name>odo::RobotDialog</name>
    <message>
        <source>Add robot</source>
        <translation>Roboter hinzufügen</translation>
    </message>
    <message>
        <source>Estimated from the views</source>
        <translation>Aus den Sichten ermittelt</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Changes while it runs (ramp)</source>
        <translation>Ändert sich während der Fahrt (Rampe)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Height of the robot&apos;s top</source>
        <translation>Höhe der Roboteroberseite</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;Pick from a video…</source>
        <translation>Aus einem &amp;Bild…</translation>
    </message>
    <message>
        <source>&amp;Colour of its top</source>
        <translation>&amp;Farbe der Oberseite</translation>
    </message>
    <message>
        <source>&amp;Drawn in</source>
        <translation>&amp;Gezeichnet in</translation>
    </message>
    <message>
        <source>&amp;Height of its top</source>
        <translation>&amp;Höhe der Oberseite</translation>
    </message>
    <message>
        <source>Colour of the robot&apos;s top</source>
        <translation>Farbe der Roboteroberseite</translation>
    </message>
    <message>
        <source>Change robot</source>
        <translation>Roboter ändern</translation>
    </message>
    <message>
        <source>Its silhouette</source>
        <translation>Unterschied zum Boden</translation>
    </message>
    <message>
        <source>A colour of its own</source>
        <translation>Eigene Farbe</translation>
    </message>
    <message>
        <source>The silhouette works for any robot. A colour of its own helps if several things move.</source>
        <translation>Ein Roboter von beliebigem Aussehen wird daran erkannt, worin er sich vom Boden unterscheidet. Eine eigene Farbe hilft, wo sich mehreres bewegt.</translation>
    </message>
    <message>
        <source>D&amp;etected by</source>
        <translation>&amp;Erkannt an</translation>
    </message>
    <message>
        <source>Colour in charts and maps; the robot itself may have another</source>
        <translation>In Diagrammen und Karten, wie auch immer der Roboter aussieht</translation>
    </message>
    <message>
        <source>Offset from the middle of the robot&apos;s footprint; 0 and 0 is the middle itself.</source>
        <translation>Von der Mitte der Fläche, die der Roboter auf dem Boden einnimmt; 0 und 0 ist die Mitte selbst.</translation>
    </message>
    <message>
        <source> mm forward</source>
        <translation> mm nach vorn</translation>
    </message>
    <message>
        <source>Reference point, forward of the robot&apos;s middle</source>
        <translation>Gemessener Punkt, vor der Mitte des Roboters</translation>
    </message>
    <message>
        <source> mm left</source>
        <translation> mm nach links</translation>
    </message>
    <message>
        <source>Reference point, left of the robot&apos;s middle</source>
        <translation>Gemessener Punkt, links von der Mitte des Roboters</translation>
    </message>
    <message>
        <source>&amp;Reference point</source>
        <translation>Gemessener &amp;Punkt</translation>
    </message>
</context>
<context>
    <name>odo::RobotFootprint</name>
    <message>
        <source>The robot from above, heading to the right</source>
        <translation>Der Roboter von oben, nach rechts gerichtet</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>No size given. Drawn as %1 × %2 mm</source>
        <translation>Keine Größe angegeben. Gezeichnet als %1 × %2 mm</translation>
    </message>
</context>
<context>
    <name>odo::RobotPointing</name>
    <message>
        <source>&amp;Point out a robot</source>
        <translation>Auf einen Roboter &amp;zeigen</translation>
    </message>
    <message>
        <source>Wrong object outlined? Click the robot in a view to track the trial again (%1)</source>
        <translation>Das Falsche ist umrandet: Klicken Sie den Roboter in einem Bild an, dann wird der Versuch neu verfolgt (%1)</translation>
    </message>
    <message>
        <source>This is %1: track it again</source>
        <translation>Das ist %1: neu verfolgen</translation>
    </message>
    <message>
        <source>Find %1 automatically</source>
        <translation>%1 ohne Hilfe suchen</translation>
    </message>
</context>
<context>
    <name>odo::RobotsDialog</name>
    <message>
        <source>estimated from the views</source>
        <translation>aus den Sichten ermittelt</translation>
    </message>
    <message>
        <source>changes while it runs</source>
        <translation>ändert sich während der Fahrt</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Bearbeiten…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Drawn in</source>
        <translation>Gezeichnet in</translation>
    </message>
    <message>
        <source>Height of its top</source>
        <translation>Höhe oben</translation>
    </message>
    <message>
        <source>Length × width</source>
        <translation>Länge × Breite</translation>
    </message>
    <message>
        <source>A new colour or height applies from the next tracking on; earlier results stay as they are.</source>
        <translation>Eine andere Farbe oder Höhe gilt ab der nächsten Verfolgung; was vorher gemessen wurde, bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Latest change</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>its silhouette</source>
        <translation>seiner Silhouette</translation>
    </message>
    <message>
        <source>Detected by</source>
        <translation>Erkannt an</translation>
    </message>
</context>
<context>
    <name>odo::RunCard</name>
    <message>
        <source>Up now</source>
        <translation>Jetzt dran</translation>
    </message>
    <message>
        <source>Robots of this run</source>
        <translation>Roboter, die fahren</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>&amp;Klasse</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>Te&amp;am</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>Auf&amp;gabe</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>&amp;Roboter</translation>
    </message>
    <message>
        <source>Trial &amp;name</source>
        <translation>&amp;Versuchsname</translation>
    </message>
    <message>
        <source>Be&amp;gins</source>
        <translation>&amp;Beginnt</translation>
    </message>
    <message>
        <source>&amp;Laps</source>
        <translation>R&amp;unden</translation>
    </message>
    <message>
        <source>Number of laps</source>
        <translation>Runden bis zum Ende</translation>
    </message>
    <message>
        <source>Team of this run</source>
        <translation>Team, das dran ist</translation>
    </message>
    <message>
        <source>When the recording begins</source>
        <translation>Wie die Aufnahme beginnt</translation>
    </message>
    <message>
        <source>no class</source>
        <translation>keine Klasse</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>no team</source>
        <translation>kein Team</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>sofort</translation>
    </message>
    <message>
        <source>after a countdown of %1 s</source>
        <translation>nach einem Countdown von %1 s</translation>
    </message>
    <message>
        <source>when the robot passes the start</source>
        <translation>wenn der Roboter den Start passiert</translation>
    </message>
</context>
<context>
    <name>odo::RunChooser</name>
    <message>
        <source>start gate</source>
        <translation>Starttor</translation>
    </message>
    <message>
        <source>onset of motion</source>
        <translation>Bewegungsbeginn</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>First run</source>
        <translation>Erste Fahrt</translation>
    </message>
    <message>
        <source>Second run</source>
        <translation>Zweite Fahrt</translation>
    </message>
    <message>
        <source>How to align the runs</source>
        <translation>Der Moment, der als derselbe gilt</translation>
    </message>
    <message>
        <source>Swap the two runs</source>
        <translation>Die zwei Fahrten tauschen</translation>
    </message>
    <message>
        <source>Add more runs</source>
        <translation>Weitere Fahrten</translation>
    </message>
    <message>
        <source>&amp;Shift</source>
        <translation>&amp;Versatz</translation>
    </message>
    <message>
        <source>Distan&amp;ce</source>
        <translation>&amp;Ort</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time shift of the second run; positive: later</source>
        <translation>Wie viel später der Moment der zweiten Fahrt liegt</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>first common point</source>
        <translation>wo alle begonnen haben</translation>
    </message>
    <message>
        <source>Distance along the path at which the runs are aligned</source>
        <translation>An welcher Stelle des Wegs die Fahrten als gleichzeitig gelten</translation>
    </message>
    <message>
        <source>F&amp;irst</source>
        <translation>&amp;Erste</translation>
    </message>
    <message>
        <source>Seco&amp;nd</source>
        <translation>&amp;Zweite</translation>
    </message>
    <message>
        <source>&amp;Align by</source>
        <translation>&amp;Ausrichten an</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automatisch: %1</translation>
    </message>
    <message>
        <source>No more runs</source>
        <translation>Es gibt keine weiteren Fahrten</translation>
    </message>
</context>
<context>
    <name>odo::RunResultCard</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>&amp;Open in Review</source>
        <translation>In &amp;Durchsicht öffnen</translation>
    </message>
    <message>
        <source>The results appear here shortly after the run ends.</source>
        <translation>Die Kennwerte einer Fahrt stehen hier kurz nach ihrem Ende.</translation>
    </message>
    <message>
        <source>Analysing…</source>
        <translation>Wird ausgewertet…</translation>
    </message>
    <message>
        <source>Spikes flagged</source>
        <translation>Markierte Ausreißer</translation>
    </message>
    <message>
        <source>From live tracking. The final results follow shortly, from the recording.</source>
        <translation>Aus der Live-Verfolgung. Die endgültigen Kennwerte kommen gleich aus der Aufnahme.</translation>
    </message>
    <message>
        <source>Final, from every frame of the recording.</source>
        <translation>Endgültig, aus jedem Bild der Aufnahme.</translation>
    </message>
</context>
<context>
    <name>odo::RunResults</name>
    <message>
        <source>%1 is analysed.</source>
        <translation>%1 ist ausgewertet.</translation>
    </message>
    <message>
        <source>Recorded, but not analysed: %1</source>
        <translation>Der Versuch ist aufgenommen, ließ sich aber nicht auswerten: %1</translation>
    </message>
    <message>
        <source>%1 is recorded.</source>
        <translation>%1 ist aufgenommen.</translation>
    </message>
    <message>
        <source>Recording failed: %1</source>
        <translation>Der Versuch ließ sich nicht aufnehmen: %1</translation>
    </message>
</context>
<context>
    <name>odo::ScoreboardDialog</name>
    <message>
        <source>&amp;Copy address</source>
        <translation>Adresse &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Open in browser</source>
        <translation>Im Browser ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Standings as a web page</source>
        <translation>Rangliste als Webseite</translation>
    </message>
    <message>
        <source>Show the standings on a projector or on phones. The page follows the project as long as this window is open.</source>
        <translation>Zeigen Sie die Rangliste auf einem Beamer oder auf Handys. Die Seite folgt dem Projekt, solange dieses Fenster offen ist.</translation>
    </message>
    <message>
        <source>C&amp;lass:</source>
        <translation>K&amp;lasse:</translation>
    </message>
    <message>
        <source>&amp;Task:</source>
        <translation>&amp;Aufgabe:</translation>
    </message>
    <message>
        <source>&amp;Visible to:</source>
        <translation>&amp;Sichtbar für:</translation>
    </message>
    <message>
        <source>Address of the page</source>
        <translation>Adresse der Seite</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>Alle Klassen</translation>
    </message>
    <message>
        <source>Task of the newest trial</source>
        <translation>Aufgabe des neuesten Versuchs</translation>
    </message>
    <message>
        <source>This computer only</source>
        <translation>Nur diesen Computer</translation>
    </message>
    <message>
        <source>All devices in the network</source>
        <translation>Alle Geräte im Netz</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Startet…</translation>
    </message>
    <message>
        <source>Everyone in the network can open this page. It shows the names of teams, classes and tasks, and no others.</source>
        <translation>Alle im Netz können diese Seite öffnen. Sie zeigt nur die Namen von Teams, Klassen und Aufgaben.</translation>
    </message>
    <message>
        <source>Only this computer can open this page.</source>
        <translation>Nur dieser Computer kann diese Seite öffnen.</translation>
    </message>
</context>
<context>
    <name>odo::ScoringTable</name>
    <message>
        <source>Remo&amp;ve line</source>
        <translation>Z&amp;eile entfernen</translation>
    </message>
    <message>
        <source>Each line gives all its points if the metric reaches the first bound, none at the second bound or worse, and a proportional share between them. Negative points are a penalty.</source>
        <translation>Jede Zeile gibt all ihre Punkte, wo der Kennwert an der einen Schranke oder besser ist, keine an der anderen oder schlechter, und dazwischen gleichmäßig verteilt. Punkte unter null sind ein Abzug.</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>All points at</source>
        <translation>Alle Punkte bei</translation>
    </message>
    <message>
        <source>None at</source>
        <translation>Keine bei</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Lines of the scoring</source>
        <translation>Zeilen der Wertung</translation>
    </message>
    <message>
        <source>What the lines mean</source>
        <translation>Was die Zeilen bedeuten</translation>
    </message>
    <message>
        <source>&amp;Add line</source>
        <translation>Zeile &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Scored metric</source>
        <translation>Kennwert, der zählt</translation>
    </message>
    <message>
        <source>Without a line, runs of the task are not scored.</source>
        <translation>Ohne Zeile werden Fahrten der Aufgabe nicht gewertet.</translation>
    </message>
    <message>
        <source>Total: %1 points.</source>
        <translation>Insgesamt %1 Punkte.</translation>
    </message>
</context>
<context>
    <name>odo::SeriesKey</name>
    <message>
        <source>Legend</source>
        <translation>Legende der Linien</translation>
    </message>
    <message>
        <source>%1: click to hide or show</source>
        <translation>%1: klicken zum Aus- oder Einblenden</translation>
    </message>
</context>
<context>
    <name>odo::SharedField</name>
    <message>
        <source>several</source>
        <translation>mehrere</translation>
    </message>
    <message>
        <source>%1: several</source>
        <translation>%1: mehrere</translation>
    </message>
    <message>
        <source>The trials differ here. Press to enter one value for all of them.</source>
        <translation>Die Versuche unterscheiden sich hier. Drücken Sie, um einen Wert für alle einzugeben.</translation>
    </message>
</context>
<context>
    <name>odo::SharedPointsPage</name>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Herausnehmen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Image of the camera to register; arrow keys move the selected point</source>
        <translation>Bild der einzumessenden Kamera; die Pfeiltasten verschieben den gewählten Punkt</translation>
    </message>
    <message>
        <source>Image of the registered camera; arrow keys move the selected point</source>
        <translation>Bild der eingemessenen Kamera; die Pfeiltasten verschieben den gewählten Punkt</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Seen in</source>
        <translation>Gesehen in</translation>
    </message>
    <message>
        <source>On the floor, mm</source>
        <translation>Am Boden, mm</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Floor points</source>
        <translation>Punkte des Bodens</translation>
    </message>
    <message>
        <source>Camera %1, to be registered</source>
        <translation>Kamera %1, einzumessen</translation>
    </message>
    <message>
        <source>Camera %1, registered</source>
        <translation>Kamera %1, eingemessen</translation>
    </message>
    <message>
        <source>P%1</source>
        <comment>a point</comment>
        <translation>P%1</translation>
    </message>
    <message>
        <source>Click a floor point in the left image, then the same point in the right image. A click snaps to what is near it, to a tenth of a pixel; arrow keys move the selected point, Space snaps it.</source>
        <translation>Klicken Sie im linken Bild auf einen Punkt des Bodens, dann im rechten Bild auf denselben. Was nahe bei einem Klick liegt, wird auf ein Zehntel Pixel genau genommen; die Pfeiltasten verschieben den gewählten Punkt, die Leertaste rastet ihn ein.</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>beyond the horizon</source>
        <translation>jenseits des Horizonts</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>both images</source>
        <translation>beide Bilder</translation>
    </message>
    <message>
        <source>left only</source>
        <translation>nur links</translation>
    </message>
    <message>
        <source>right only</source>
        <translation>nur rechts</translation>
    </message>
    <message>
        <source>not set yet</source>
        <translation>noch nicht gesetzt</translation>
    </message>
</context>
<context>
    <name>odo::SmoothingPanel</name>
    <message>
        <source>%1: measured for less than a second</source>
        <translation>%1: weniger als eine Sekunde gemessen</translation>
    </message>
    <message>
        <source>%1: smoothed automatically like a filter with a cut-off of %2; what it takes away is %3 of each coordinate</source>
        <translation>%1: selbsttätig geglättet wie durch ein Filter mit einer Grenzfrequenz von %2; es nimmt %3 von jeder Koordinate weg</translation>
    </message>
    <message>
        <source>%1: the smoother states no cut-off</source>
        <translation>%1: die Glättung nennt keine Grenzfrequenz</translation>
    </message>
    <message>
        <source>Noise of the measurements by their residuals: %1; stated: %2</source>
        <translation>Rauschen der Messungen nach ihren Residuen: %1; angegeben: %2</translation>
    </message>
    <message>
        <source>Cut-off by residual analysis: %1</source>
        <translation>Grenzfrequenz nach der Residuenanalyse: %1</translation>
    </message>
    <message>
        <source>Residual analysis gives no cut-off: the residuals are not those of noise.</source>
        <translation>Die Residuenanalyse ergibt keine Grenzfrequenz: die Residuen sind nicht die von Rauschen.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>residual of a Butterworth filter, by its cut-off</source>
        <translation>Residuum eines Butterworth-Filters über seiner Grenzfrequenz</translation>
    </message>
    <message>
        <source>Smoothing of the robots</source>
        <translation>Glättung der Roboter</translation>
    </message>
    <message>
        <source>No curve yet: track the trial.</source>
        <translation>Noch keine Kurve: verfolgen Sie den Versuch.</translation>
    </message>
</context>
<context>
    <name>odo::SoundChart</name>
    <message>
        <source>Loudness</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Loudness of both views</source>
        <translation>Lautstärke beider Sichten</translation>
    </message>
</context>
<context>
    <name>odo::SpikeActions</name>
    <message>
        <source>&amp;Use sample</source>
        <translation>&amp;Verwenden</translation>
    </message>
    <message>
        <source>Mark the sample at this moment as valid and use it, even if it was flagged</source>
        <translation>Was in diesem Moment gemessen wurde, ist richtig und soll verwendet werden, was auch dagegen spricht</translation>
    </message>
    <message>
        <source>Mark as &amp;spike</source>
        <translation>Als &amp;Ausreißer</translation>
    </message>
    <message>
        <source>Mark the sample at this moment as a spike and do not use it</source>
        <translation>Was in diesem Moment gemessen wurde, ist falsch und soll nicht verwendet werden</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>Auto&amp;matisch</translation>
    </message>
    <message>
        <source>Remove the manual override at this moment</source>
        <translation>Nimmt zurück, was zu diesem Moment von Hand gesagt wurde</translation>
    </message>
</context>
<context>
    <name>odo::SpikeList</name>
    <message>
        <source>Spikes</source>
        <translation>Ausreißer</translation>
    </message>
    <message>
        <source>Spikes with time and reason</source>
        <translation>Ausreißer mit Zeit und Grund</translation>
    </message>
    <message>
        <source>Select all with this &amp;reason</source>
        <translation>Alle mit diesem &amp;Grund auswählen</translation>
    </message>
    <message>
        <source>Select all in the selected ra&amp;nge</source>
        <translation>Alle im ausgewählten &amp;Bereich auswählen</translation>
    </message>
    <message>
        <source>Select all spikes of this robot that have the reason of the selected one</source>
        <translation>Alle Ausreißer dieses Roboters auswählen, die den Grund des ausgewählten haben</translation>
    </message>
    <message>
        <source>Select all spikes of this robot within the selection on the time line</source>
        <translation>Alle Ausreißer dieses Roboters innerhalb der Auswahl auf der Zeitleiste auswählen</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n ausgewählt</numerusform>
            <numerusform>%n ausgewählt</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::SpikeModel</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 flagged</source>
        <translation>%1 markiert</translation>
    </message>
    <message>
        <source>%1 restored</source>
        <translation>%1 wiederhergestellt</translation>
    </message>
    <message>
        <source>used, by hand</source>
        <translation>verwendet, von Hand</translation>
    </message>
    <message>
        <source>%1 (restored by hand)</source>
        <translation>%1 (von Hand wiederhergestellt)</translation>
    </message>
    <message>
        <source>Restored by hand</source>
        <translation>Von Hand wiederhergestellt</translation>
    </message>
    <message>
        <source>Flagged, not used for the curve</source>
        <translation>Markiert, nicht für die Kurve verwendet</translation>
    </message>
    <message>
        <source>Flagged, still used for the curve</source>
        <translation>Markiert, dennoch für die Kurve verwendet</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>%1 ambiguous</source>
        <translation>%1 zweifelhaft</translation>
    </message>
    <message>
        <source>%1 hidden</source>
        <translation>%1 verdeckt</translation>
    </message>
    <message>
        <source>%1 not measured</source>
        <translation>%1 nicht gemessen</translation>
    </message>
</context>
<context>
    <name>odo::StandingsModel</name>
    <message>
        <source>choose a task</source>
        <translation>Aufgabe wählen</translation>
    </message>
    <message>
        <source>needs three trials at different times</source>
        <translation>erst ab drei Zeitpunkten</translation>
    </message>
    <message>
        <source>within the spread (%1)</source>
        <translation>im Rahmen der Streuung (%1)</translation>
    </message>
    <message>
        <source>better: %1</source>
        <translation>besser: %1</translation>
    </message>
    <message>
        <source>worse: %1</source>
        <translation>schlechter: %1</translation>
    </message>
    <message>
        <source>one trial</source>
        <translation>ein Versuch</translation>
    </message>
    <message>
        <source>One more than the number of significantly better teams (medians differ by more than 1.96 σ). Runs of different tasks are not ranked</source>
        <translation>Eins mehr als die Teams, die zweifelsfrei besser sind: Ihre Mediane unterscheiden sich um mehr als 1,96 σ. Fahrten verschiedener Aufgaben werden nicht gereiht</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Bester</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Repeatability: standard deviation of one trial about the line of progress</source>
        <translation>Wiederholbarkeit: Standardabweichung eines Versuchs um die Gerade des Fortschritts</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Change over the term by a straight-line fit; Student&apos;s t-test (95 %) decides if it exceeds the spread</source>
        <translation>Änderung im Lauf des Halbjahrs nach einer Geraden; größer als die Streuung nach Students t-Test, 95 %</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n doubtful</source>
        <translation>
            <numerusform>%1, %n zweifelhaft</numerusform>
            <numerusform>%1, %n zweifelhaft</numerusform>
        </translation>
    </message>
    <message>
        <source>Those with bad results do not count</source>
        <translation>Die mit schlechten Ergebnissen zählen nicht</translation>
    </message>
    <message>
        <source>± from the spread of all teams&apos; trials, at least that of the measurement</source>
        <translation>± aus der Streuung der Versuche aller Teams, mindestens das der Messung</translation>
    </message>
</context>
<context>
    <name>odo::StartActions</name>
    <message>
        <source>Registered to the floor mat: %1.</source>
        <translation>Nach der Bodenmatte eingemessen: %1.</translation>
    </message>
    <message>
        <source>Their newest recordings do not show it: %1.</source>
        <translation>Ihre neuesten Aufnahmen zeigen sie nicht: %1.</translation>
    </message>
</context>
<context>
    <name>odo::StartCard</name>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>&amp;Record or stop</source>
        <translation>&amp;Aufnehmen oder stoppen</translation>
    </message>
    <message>
        <source>Recorded time</source>
        <translation>Aufgenommene Zeit</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Writing the last frames…</source>
        <translation>Letzte Bilder werden geschrieben…</translation>
    </message>
    <message>
        <source>F9 records, F9 stops</source>
        <translation>F9 nimmt auf, F9 stoppt</translation>
    </message>
    <message>
        <source>F9 records, F9 stops; %1</source>
        <translation>F9 nimmt auf, F9 stoppt; %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>Get ready</source>
        <translation>Bereit machen</translation>
    </message>
    <message>
        <source>Waiting for the robot at “%1”. The recording will include the second before</source>
        <translation>Warten auf den Roboter an „%1“; aufgenommen wird ab einer Sekunde davor</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
</context>
<context>
    <name>odo::StartPage</name>
    <message>
        <source>Cameras or clips</source>
        <translation>Kameras oder Videos</translation>
    </message>
    <message>
        <source>Import clips…</source>
        <translation>Videos importieren…</translation>
    </message>
    <message>
        <source>Connect cameras</source>
        <translation>Kameras anschließen</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Find the mat in the clips…</source>
        <translation>Matte in den Videos suchen…</translation>
    </message>
    <message>
        <source>Print a mat…</source>
        <translation>Matte drucken…</translation>
    </message>
    <message>
        <source>Use other markers…</source>
        <translation>Andere Marker verwenden…</translation>
    </message>
    <message>
        <source>Lens (optional)</source>
        <translation>Objektiv (freiwillig)</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Vermessen…</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Add a robot…</source>
        <translation>Roboter hinzufügen…</translation>
    </message>
    <message>
        <source>First run</source>
        <translation>Erste Fahrt</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>Verfolgen…</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>From clips to a first result</source>
        <translation>Von den Videos zum ersten Ergebnis</translation>
    </message>
    <message>
        <source>Steps to a first result</source>
        <translation>Schritte zum ersten Ergebnis</translation>
    </message>
</context>
<context>
    <name>odo::StatusLine</name>
    <message>
        <source>No trial</source>
        <translation>Kein Versuch</translation>
    </message>
    <message>
        <source>Not tracked yet</source>
        <translation>Noch nicht verfolgt</translation>
    </message>
    <message>
        <source>Analysis %1, Odograph %2</source>
        <translation>Auswertung %1, Odograph %2</translation>
    </message>
    <message>
        <source>Units of lengths, speeds and times; change them in the preferences</source>
        <translation>Einheiten von Längen, Geschwindigkeiten und Zeiten; in den Einstellungen zu wählen</translation>
    </message>
    <message>
        <source>No project is open</source>
        <translation>Kein Projekt ist geöffnet</translation>
    </message>
    <message>
        <source>Read only: nothing can be changed</source>
        <translation>Nur lesbar: Nichts lässt sich ändern</translation>
    </message>
    <message>
        <source>All changes saved</source>
        <translation>Alle Änderungen gespeichert</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>The school&apos;s hub</source>
        <translation>Der Hub der Schule</translation>
    </message>
    <message>
        <source>%1. Click for more about the school&apos;s hub</source>
        <translation>%1. Für mehr über den Hub der Schule klicken</translation>
    </message>
</context>
<context>
    <name>odo::StepDialog</name>
    <message>
        <source>&lt; &amp;Back</source>
        <translation>&lt; &amp;Zurück</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>&amp;Next &gt;</source>
        <translation>&amp;Weiter &gt;</translation>
    </message>
    <message>
        <source>Discard %1?</source>
        <translation>%1 verwerfen?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Keep working</source>
        <translation>&amp;Weiterarbeiten</translation>
    </message>
</context>
<context>
    <name>odo::StepRow</name>
    <message>
        <source>Done. %1</source>
        <translation>Erledigt. %1</translation>
    </message>
</context>
<context>
    <name>odo::SynchroniseDialog</name>
    <message>
        <source>Synchronise %1</source>
        <translation>%1 synchronisieren</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>%1 jetzt</translation>
    </message>
    <message>
        <source>&amp;Synchronise</source>
        <translation>&amp;Synchronisieren</translation>
    </message>
    <message>
        <source>Synchronise</source>
        <translation>Synchronisieren</translation>
    </message>
    <message>
        <source>What was tracked in the trial is reanalysed. Choose Undo to return to the synchronisation that it has now.</source>
        <translation>Was im Versuch verfolgt wurde, wird neu ausgewertet. „Rückgängig“ stellt die jetzige Synchronisation wieder her.</translation>
    </message>
    <message>
        <source>The sound of the videos is being read…</source>
        <translation>Der Ton der Videos wird gelesen…</translation>
    </message>
    <message>
        <source>Sound of the first view above, of the other one below. Drag it until both show the same clap at one time; the wheel zooms.</source>
        <translation>Ton der ersten Sicht oben, der anderen unten. Ziehen Sie ihn, bis beide dasselbe Klatschen zur selben Zeit zeigen; das Mausrad vergrößert.</translation>
    </message>
    <message>
        <source>There is no sound in both views to compare.</source>
        <translation>Es gibt nicht in beiden Sichten Ton zum Vergleichen.</translation>
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
        <translation>Innere Ecken längs der Tafel</translation>
    </message>
    <message>
        <source>Inner corners across the board</source>
        <translation>Innere Ecken quer zur Tafel</translation>
    </message>
    <message>
        <source>Print targets</source>
        <translation>Vorlagen drucken</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>Als PDF &amp;speichern…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken…</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>ChArUco-Tafel</translation>
    </message>
    <message>
        <source>Floor markers: tags</source>
        <translation>Bodenmarker: Tags</translation>
    </message>
    <message>
        <source>Floor markers: rings</source>
        <translation>Bodenmarker: Ringe</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
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
        <translation>&amp;Vorlage</translation>
    </message>
    <message>
        <source>Pape&amp;r</source>
        <translation>&amp;Papier</translation>
    </message>
    <message>
        <source>&amp;Inner corners</source>
        <translation>&amp;Innere Ecken</translation>
    </message>
    <message>
        <source>S&amp;quare</source>
        <translation>&amp;Quadrat</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Bezeichnungen</translation>
    </message>
    <message>
        <source>What is printed</source>
        <translation>Was gedruckt wird</translation>
    </message>
    <message>
        <source>One sheet. Afterwards measure a square on the paper: printers often shrink by 2 to 4 %.</source>
        <translation>Ein Blatt. Messen Sie danach ein Quadrat auf dem Papier: Drucker verkleinern oft um 2 bis 4 %.</translation>
    </message>
    <message>
        <source>One sheet for each marker. A tag&apos;s number is the position of its label in the layout.</source>
        <translation>Ein Blatt je Marker. Die Nummer eines Tags ist der Platz seiner Bezeichnung im Markerplan.</translation>
    </message>
    <message>
        <source>Save targets</source>
        <translation>Vorlagen speichern</translation>
    </message>
    <message>
        <source>targets.pdf</source>
        <translation>Druckvorlagen.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Als %1 gespeichert.</translation>
    </message>
    <message>
        <source>Sent to the printer.</source>
        <translation>An den Drucker gesendet.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Sheets in a row of the mat</source>
        <translation>Blätter in einer Reihe der Matte</translation>
    </message>
    <message>
        <source>Rows of the mat</source>
        <translation>Reihen der Matte</translation>
    </message>
    <message>
        <source>Floor mat</source>
        <translation>Bodenmatte</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>&amp;Blätter</translation>
    </message>
    <message>
        <source>A plan and %1 sheets, to be taped together to a mat of %2 × %3 m. Its markers are known: nothing on the floor needs to be measured. The larger the mat, the more exact the floor.</source>
        <translation>Ein Plan und %1 Blätter, die zu einer Matte von %2 × %3 m zusammengeklebt werden. Ihre Marker sind bekannt: Auf dem Boden muss nichts gemessen werden. Je größer die Matte, desto genauer der Boden.</translation>
    </message>
</context>
<context>
    <name>odo::TargetPreview</name>
    <message>
        <source>Preview of the sheets</source>
        <translation>Vorschau der Blätter</translation>
    </message>
</context>
<context>
    <name>odo::TaskCanvas</name>
    <message>
        <source>The task from above</source>
        <translation>Die Aufgabe von oben</translation>
    </message>
    <message>
        <source>Drag a gate or one of its ends, a zone&apos;s edge or corner. Keys: Page Up and Down choose a gate or a zone, arrows move it (Shift: 100 mm, Ctrl: 1 mm), &lt; and &gt; turn it, + and − change its width</source>
        <translation>Ziehen Sie ein Tor oder eines seiner Enden, Rand oder Ecke einer Zone. Tasten: Bild auf und Bild ab wählen ein Tor oder eine Zone, die Pfeile verschieben es (Umschalt: 100 mm, Strg: 1 mm), &lt; und &gt; drehen es, + und − ändern seine Breite</translation>
    </message>
    <message>
        <source>Zone %1, %2: %3 mm</source>
        <translation>Zone %1, %2: %3 mm</translation>
    </message>
    <message>
        <source>No gate or zone is chosen</source>
        <translation>Kein Tor und keine Zone ist gewählt</translation>
    </message>
    <message>
        <source>Gate %1 from %2, %3 to %4, %5</source>
        <translation>Tor %1 von %2, %3 bis %4, %5</translation>
    </message>
</context>
<context>
    <name>odo::TaskEditor</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
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
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>&amp;Course</source>
        <translation>&amp;Parcours</translation>
    </message>
    <message>
        <source>&amp;Zones</source>
        <translation>&amp;Zonen</translation>
    </message>
    <message>
        <source>Sco&amp;ring</source>
        <translation>&amp;Wertung</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Was nicht stimmt</translation>
    </message>
    <message>
        <source>Import &amp;file…</source>
        <translation>Datei &amp;importieren…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Import gates, path, limits and zones from a task file (JSON)</source>
        <translation>Tore, Sollbahn, Grenzwerte und Zonen aus einer Aufgabendatei (JSON) übernehmen</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Speed limi&amp;t</source>
        <translation>Grenz&amp;geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration l&amp;imit</source>
        <translation>Grenz&amp;beschleunigung</translation>
    </message>
    <message>
        <source>No robot in the task can exceed it: a measurement beyond it is a spike</source>
        <translation>Was kein Roboter in der Aufgabe kann: Eine Messung darüber ist ein Ausreißer</translation>
    </message>
    <message>
        <source>Task file</source>
        <translation>Aufgabendatei</translation>
    </message>
    <message>
        <source>Tasks (*.json *.yaml *.yml);;All files (*)</source>
        <translation>Aufgaben (*.json *.yaml *.yml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The task has no name.</source>
        <translation>Die Aufgabe hat keinen Namen.</translation>
    </message>
    <message>
        <source>A task with this name exists. Enter another name.</source>
        <translation>Es gibt schon eine Aufgabe dieses Namens. Geben Sie einen anderen Namen an.</translation>
    </message>
    <message>
        <source>A gate has no name.</source>
        <translation>Ein Tor hat keinen Namen.</translation>
    </message>
    <message>
        <source>A zone has no name.</source>
        <translation>Eine Zone hat keinen Namen.</translation>
    </message>
</context>
<context>
    <name>odo::TasksDialog</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Bearbeiten…</translation>
    </message>
    <message>
        <source>&amp;Copy…</source>
        <translation>&amp;Kopieren…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>&amp;Archivieren</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Reanalyse &amp;them</source>
        <translation>N&amp;eu auswerten</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>What depends on the task</source>
        <translation>Was von der Aufgabe abhängt</translation>
    </message>
    <message>
        <source>Latest change</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>Genutzt von</translation>
    </message>
    <message>
        <source>Archived tasks no longer appear in lists; their trials, results and scores stay as they are</source>
        <translation>Eine archivierte Aufgabe wird nicht mehr angeboten; ihre Versuche, Ergebnisse und Punkte bleiben, wie sie sind</translation>
    </message>
    <message numerus="yes">
        <source>Show %n archived task(s)</source>
        <translation>
            <numerusform>%n archivierte Aufgabe zeigen</numerusform>
            <numerusform>%n archivierte Aufgaben zeigen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>earlier results</source>
        <translation>frühere Ergebnisse</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>%1, archived</source>
        <translation>%1, archiviert</translation>
    </message>
    <message>
        <source>No task yet. New creates one from a template. Its gates, path and scoring define the course and rate the runs.</source>
        <translation>Noch keine Aufgabe. Neu legt eine nach einem Muster an: Ihre Tore, Sollbahn und Wertung sagen, was zu fahren ist und wie gut es war.</translation>
    </message>
    <message numerus="yes">
        <source>Earlier version of the course: %n result(s) still use it.</source>
        <translation>
            <numerusform>Der Parcours, wie er vor der Änderung war: %n danach ausgewertetes Ergebnis behält ihn.</numerusform>
            <numerusform>Der Parcours, wie er vor der Änderung war: %n danach ausgewertete Ergebnisse behalten ihn.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) have this task.</source>
        <translation>
            <numerusform>%n Versuch hat diese Aufgabe.</numerusform>
            <numerusform>%n Versuche haben diese Aufgabe.</numerusform>
        </translation>
    </message>
    <message>
        <source>No trial has this task.</source>
        <translation>Kein Versuch hat diese Aufgabe.</translation>
    </message>
    <message numerus="yes">
        <source>%n of them were measured with another course: their gate times and distances from the path belong to that one, and they have no score until you reanalyse them.</source>
        <translation>
            <numerusform>%n davon ist nach einem anderen Parcours ausgewertet: Zeiten an Toren und Abstände von der Sollbahn gelten für jenen, und Punkte gibt es erst, wenn er neu ausgewertet ist.</numerusform>
            <numerusform>%n davon sind nach einem anderen Parcours ausgewertet: Zeiten an Toren und Abstände von der Sollbahn gelten für jenen, und Punkte gibt es erst, wenn sie neu ausgewertet sind.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is scored by %n metric(s).</source>
        <translation>
            <numerusform>Sie wird nach %n Kennwert gewertet.</numerusform>
            <numerusform>Sie wird nach %n Kennwerten gewertet.</numerusform>
        </translation>
    </message>
    <message>
        <source>It is not scored.</source>
        <translation>Sie wird nicht gewertet.</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>Aus dem &amp;Archiv holen</translation>
    </message>
    <message>
        <source>Trials have this task or were measured with it: it stays to document their metrics</source>
        <translation>Versuche haben diese Aufgabe oder wurden nach ihr ausgewertet: Sie bleibt, damit deren Kennwerte sagen, wonach sie ausgewertet wurden</translation>
    </message>
    <message>
        <source>Deletes the task (Del); Ctrl+Z undoes this</source>
        <translation>Löscht die Aufgabe (Entf); Strg+Z nimmt es zurück</translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) measured with this course stay valid: if you change the course, they keep the earlier version. Reanalyse the trials to update their times and scores.</source>
        <translation>
            <numerusform>%n nach diesem Parcours ausgewertetes Ergebnis bleibt wahr: Ein geänderter Parcours bleibt dafür als frühere Fassung erhalten. Die Versuche gehen auf den neuen über; ihre Zeiten und Punkte folgen, sobald sie neu ausgewertet sind.</numerusform>
            <numerusform>%n nach diesem Parcours ausgewertete Ergebnisse bleiben wahr: Ein geänderter Parcours bleibt dafür als frühere Fassung erhalten. Die Versuche gehen auf den neuen über; ihre Zeiten und Punkte folgen, sobald sie neu ausgewertet sind.</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename task</source>
        <translation>Aufgabe umbenennen</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
</context>
<context>
    <name>odo::TeamDialog</name>
    <message>
        <source>Robots of the team</source>
        <translation>Roboter des Teams</translation>
    </message>
    <message>
        <source>Team %1</source>
        <translation>Team %1</translation>
    </message>
    <message>
        <source>One name per line</source>
        <translation>Ein Name je Zeile</translation>
    </message>
    <message>
        <source>Members of the team, one per line</source>
        <translation>Mitglieder des Teams, eines je Zeile</translation>
    </message>
    <message>
        <source>Record and Import propose these robots for the team&apos;s runs</source>
        <translation>Aufnahme und Import schlagen diese Roboter für die Fahrten des Teams vor</translation>
    </message>
    <message>
        <source>&amp;Members</source>
        <translation>&amp;Mitglieder</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>&amp;Roboter</translation>
    </message>
    <message numerus="yes">
        <source>%n member(s)</source>
        <translation>
            <numerusform>%n Mitglied</numerusform>
            <numerusform>%n Mitglieder</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TeamsPanel</name>
    <message>
        <source>Teams</source>
        <translation>Teams</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>Alle Klassen</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>Jede Aufgabe</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>Standings</source>
        <translation>Rangliste der Teams</translation>
    </message>
    <message>
        <source>%1 (archived)</source>
        <translation>%1 (archiviert)</translation>
    </message>
    <message>
        <source>No team has a result for this metric</source>
        <translation>Kein Team hat hier einen Kennwert</translation>
    </message>
    <message numerus="yes">
        <source>%n team(s)</source>
        <translation>
            <numerusform>%n Team</numerusform>
            <numerusform>%n Teams</numerusform>
        </translation>
    </message>
    <message>
        <source>choose a task to rank them: runs of different tasks cannot be compared</source>
        <translation>für eine Rangliste eine Aufgabe wählen: Fahrten verschiedener Aufgaben lassen sich nicht vergleichen</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them</source>
        <translation>
            <numerusform>%n Versuch ausgelassen: nach einem anderen Parcours ausgewertet; bitte neu auswerten</numerusform>
            <numerusform>%n Versuche ausgelassen: nach einem anderen Parcours ausgewertet; bitte neu auswerten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results</source>
        <translation>
            <numerusform>%n Versuch nicht gezählt: schlechte Ergebnisse</numerusform>
            <numerusform>%n Versuche nicht gezählt: schlechte Ergebnisse</numerusform>
        </translation>
    </message>
    <message>
        <source>teams that do not differ significantly share a rank</source>
        <translation>Teams ohne signifikanten Unterschied teilen sich einen Rang</translation>
    </message>
</context>
<context>
    <name>odo::TemplateForm</name>
    <message>
        <source>Straight line</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Figure eight</source>
        <translation>Acht</translation>
    </message>
    <message>
        <source>Slalom</source>
        <translation>Slalom</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Te&amp;mplate</source>
        <translation>&amp;Muster</translation>
    </message>
    <message>
        <source>Centre &amp;x</source>
        <translation>Mitte &amp;x</translation>
    </message>
    <message>
        <source>Centre &amp;y</source>
        <translation>Mitte &amp;y</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Länge</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>Driving direction: 0° along X, 90° along Y</source>
        <translation>Die Fahrtrichtung: 0° längs X, 90° längs Y</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>&amp;Richtung</translation>
    </message>
    <message>
        <source>&amp;Poles</source>
        <translation>&amp;Stangen</translation>
    </message>
    <message>
        <source>&amp;Gates&apos; width</source>
        <translation>&amp;Torbreite</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Diam&amp;eter</source>
        <translation>&amp;Durchmesser</translation>
    </message>
    <message>
        <source>Start to finis&amp;h</source>
        <translation>Start bis &amp;Ziel</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>S&amp;wing, side to side</source>
        <translation>&amp;Ausschlag quer</translation>
    </message>
</context>
<context>
    <name>odo::TestbedPage</name>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>expected &amp;accuracy</source>
        <translation>erwartete &amp;Genauigkeit</translation>
    </message>
    <message>
        <source>No cameras yet</source>
        <translation>Noch keine Kameras</translation>
    </message>
    <message>
        <source>A testbed is a floor with markers and the cameras that watch it. Start with the lens calibration of the first camera, or with the marker positions.</source>
        <translation>Ein Messplatz ist ein Boden mit Markern und die Kameras, die ihn beobachten. Beginnen Sie mit dem Objektiv der ersten Kamera oder mit den Orten der Marker.</translation>
    </message>
    <message>
        <source>Tas&amp;ks…</source>
        <translation>A&amp;ufgaben…</translation>
    </message>
    <message>
        <source>Courses on this floor: gates, paths, limits, scoring</source>
        <translation>Was auf diesem Boden gefahren wird: Tore, Bahnen, Grenzwerte, Wertung</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Details of the camera</source>
        <translation>Was von der Kamera bekannt ist</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Marker layouts</source>
        <translation>Markerpläne</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>odo::TestbedTools</name>
    <message>
        <source>&amp;Calibrate camera…</source>
        <translation>Kamera &amp;kalibrieren…</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Kalibrieren…</translation>
    </message>
    <message>
        <source>Calibrate a camera with images of a board</source>
        <translation>Objektiv einer Kamera aus Bildern einer Tafel vermessen</translation>
    </message>
    <message>
        <source>&amp;Register camera…</source>
        <translation>Kamera &amp;einmessen…</translation>
    </message>
    <message>
        <source>Register…</source>
        <translation>Einmessen…</translation>
    </message>
    <message>
        <source>Determine a camera&apos;s position from the floor markers</source>
        <translation>Aus den Bodenmarkern finden, wo eine Kamera steht</translation>
    </message>
    <message>
        <source>Register via anot&amp;her camera…</source>
        <translation>Ü&amp;ber andere Kamera einmessen…</translation>
    </message>
    <message>
        <source>Via another…</source>
        <translation>Über andere…</translation>
    </message>
    <message>
        <source>Determine the position of a camera that sees no markers, from floor points that another camera also sees</source>
        <translation>Finden, wo eine Kamera steht, die keine Marker sieht, aus Punkten des Bodens, die auch eine andere Kamera sieht</translation>
    </message>
    <message>
        <source>Re&amp;gister all cameras (joint)…</source>
        <translation>Alle Kameras &amp;gemeinsam einmessen…</translation>
    </message>
    <message>
        <source>All cameras (joint)…</source>
        <translation>Gemeinsam…</translation>
    </message>
    <message>
        <source>Fit all cameras of the selected layout jointly to make them agree, and find wrongly measured markers</source>
        <translation>Die Kameras des gewählten Markerplans auf einmal anpassen, damit sie übereinstimmen, und falsch gemessene Marker finden</translation>
    </message>
    <message>
        <source>&amp;Import lens calibration…</source>
        <translation>&amp;Objektivdaten importieren…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Objektivdaten…</translation>
    </message>
    <message>
        <source>Import a camera&apos;s lens calibration from a ROS or OpenCV YAML file</source>
        <translation>Objektiv einer Kamera aus einer YAML-Datei von ROS oder OpenCV übernehmen</translation>
    </message>
    <message>
        <source>New marker &amp;layout…</source>
        <translation>&amp;Neuer Markerplan…</translation>
    </message>
    <message>
        <source>New layout…</source>
        <translation>Neuer Plan…</translation>
    </message>
    <message>
        <source>Enter the marker positions, from scratch or based on the selected layout</source>
        <translation>Angeben, wo die Marker liegen, von Grund auf oder vom gewählten Markerplan aus</translation>
    </message>
    <message>
        <source>Import &amp;marker layout…</source>
        <translation>&amp;Markerplan importieren…</translation>
    </message>
    <message>
        <source>Import layout…</source>
        <translation>Plan importieren…</translation>
    </message>
    <message>
        <source>Import the marker positions from a table</source>
        <translation>Orte der Marker aus einer Tabelle übernehmen</translation>
    </message>
    <message>
        <source>Print &amp;targets…</source>
        <translation>Vorlagen &amp;drucken…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Drucken…</translation>
    </message>
    <message>
        <source>Calibration boards and floor markers, to scale</source>
        <translation>Tafeln für das Objektiv und Marker für den Boden, maßstabsgetreu</translation>
    </message>
    <message>
        <source>Camera %1 is calibrated. %2</source>
        <translation>Kamera %1 ist kalibriert. %2</translation>
    </message>
    <message>
        <source>Camera %1 is registered. %2</source>
        <translation>Kamera %1 ist eingemessen. %2</translation>
    </message>
    <message>
        <source>Camera %1 is registered via camera %2. %3</source>
        <translation>Kamera %1 ist über Kamera %2 eingemessen. %3</translation>
    </message>
    <message>
        <source>The cameras of layout %1 are registered jointly. %2</source>
        <translation>Die Kameras des Markerplans %1 sind gemeinsam eingemessen. %2</translation>
    </message>
    <message>
        <source>Lens calibration of a camera</source>
        <translation>Objektivdaten einer Kamera</translation>
    </message>
    <message>
        <source>Import lens calibration</source>
        <translation>Objektivdaten importieren</translation>
    </message>
    <message>
        <source>Camera:</source>
        <translation>Kamera:</translation>
    </message>
    <message>
        <source>Lens calibration of camera %1 imported from %2.</source>
        <translation>Das Objektiv von Kamera %1 wurde aus %2 übernommen.</translation>
    </message>
    <message>
        <source>Positions of the markers (label,x_mm,y_mm)</source>
        <translation>Orte der Marker (label,x_mm,y_mm)</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>Tabellen (*.csv *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Layout %1 has %2 markers.</source>
        <translation>Markerplan %1 hat %2 Marker.</translation>
    </message>
    <message>
        <source>Calibrations (*.yaml *.yml *.json *.toml *.ini);;All files (*)</source>
        <translation>Kalibrierungen (*.yaml *.yml *.json *.toml *.ini);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The file holds several cameras. Which one is %1?</source>
        <translation>Die Datei enthält mehrere Kameras. Welche davon ist %1?</translation>
    </message>
</context>
<context>
    <name>odo::TimeSlider</name>
    <message>
        <source>Time of the trial</source>
        <translation>Zeit des Versuchs</translation>
    </message>
</context>
<context>
    <name>odo::Timeline</name>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Wiedergabe oder Pause</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>Ein Bild &amp;zurück</translation>
    </message>
    <message>
        <source>One frame &amp;forward</source>
        <translation>Ein Bild &amp;vor</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>Eine Sekunde zurück</translation>
    </message>
    <message>
        <source>One second forward</source>
        <translation>Eine Sekunde vor</translation>
    </message>
    <message>
        <source>Play backwards, again: faster</source>
        <translation>Rückwärts abspielen, erneut: schneller</translation>
    </message>
    <message>
        <source>&amp;Stop; while held, the keys beside it step one frame</source>
        <translation>&amp;Stopp; gehalten: die Tasten daneben gehen ein Bild weiter</translation>
    </message>
    <message>
        <source>Play forwards, again: faster</source>
        <translation>Vorwärts abspielen, erneut: schneller</translation>
    </message>
    <message>
        <source>To the first frame</source>
        <translation>Zum ersten Bild</translation>
    </message>
    <message>
        <source>To the last frame</source>
        <translation>Zum letzten Bild</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>Schlei&amp;fe</translation>
    </message>
    <message>
        <source>Selection beg&amp;ins here</source>
        <translation>Auswahl &amp;beginnt hier</translation>
    </message>
    <message>
        <source>Selection &amp;ends here</source>
        <translation>Auswahl &amp;endet hier</translation>
    </message>
    <message>
        <source>&amp;Clear the selection</source>
        <translation>Auswahl auf&amp;heben</translation>
    </message>
</context>
<context>
    <name>odo::TimelineBar</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Wiedergabegeschwindigkeit</translation>
    </message>
    <message>
        <source>To the first frame (Home)</source>
        <translation>Zum ersten Bild (Pos1)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>To the last frame (End)</source>
        <translation>Zum letzten Bild (Ende)</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>keine Bilder</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pause (Leertaste)</translation>
    </message>
</context>
<context>
    <name>odo::TrackDialog</name>
    <message>
        <source>Robots to track</source>
        <translation>Zu verfolgende Roboter</translation>
    </message>
    <message>
        <source>Track %1</source>
        <translation>%1 verfolgen</translation>
    </message>
    <message>
        <source>Kalman/RTS, noise from the data (best)</source>
        <translation>Kalman/RTS, Rauschen aus den Daten (am besten)</translation>
    </message>
    <message>
        <source>Savitzky–Golay</source>
        <translation>Savitzky–Golay</translation>
    </message>
    <message>
        <source>Differences as in Tracker</source>
        <translation>Differenzen wie in Tracker</translation>
    </message>
    <message>
        <source>None: raw differences</source>
        <translation>Keine: rohe Differenzen</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>&amp;Roboter</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>&amp;Glättung</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Verfolgen</translation>
    </message>
</context>
<context>
    <name>odo::TrackPreview</name>
    <message>
        <source>%1: too long to be shown before the import</source>
        <translation>%1: zu lang, um vor dem Import gezeigt zu werden</translation>
    </message>
    <message>
        <source>%1, track %2</source>
        <translation>%1, Bahn %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2, %n lines in %3 s</source>
        <translation>
            <numerusform>%1: %2, %n Zeile in %3 s</numerusform>
            <numerusform>%1: %2, %n Zeilen in %3 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrackReadingForm</name>
    <message>
        <source>&amp;Unit of positions</source>
        <translation>&amp;Einheit der Positionen</translation>
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
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Unit of t&amp;imes</source>
        <translation>Einheit der Ze&amp;iten</translation>
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
        <translation>Bildnummern</translation>
    </message>
    <message>
        <source>F&amp;loor axes</source>
        <translation>&amp;Bodenachsen</translation>
    </message>
    <message>
        <source>x and y</source>
        <translation>x und y</translation>
    </message>
    <message>
        <source>x and z</source>
        <translation>x und z</translation>
    </message>
    <message>
        <source>y and z</source>
        <translation>y und z</translation>
    </message>
    <message>
        <source>&amp;Decimal sign</source>
        <translation>&amp;Dezimalzeichen</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>Komma</translation>
    </message>
    <message>
        <source>&amp;Frame rate</source>
        <translation>Bildra&amp;te</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source>Of a file that numbers its frames</source>
        <translation>Einer Datei, die ihre Bilder nummeriert</translation>
    </message>
    <message>
        <source>Length of a &amp;pixel</source>
        <translation>Länge eines &amp;Pixels</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>On the floor, for positions in pixels</source>
        <translation>Auf dem Boden, für Positionen in Pixeln</translation>
    </message>
    <message>
        <source>Least &amp;confidence</source>
        <translation>&amp;Kleinste Konfidenz</translation>
    </message>
    <message>
        <source>Positions with a lower likelihood count as not measured</source>
        <translation>Positionen mit kleinerer Wahrscheinlichkeit gelten als nicht gemessen</translation>
    </message>
    <message>
        <source>Accurac&amp;y</source>
        <translation>Gena&amp;uigkeit</translation>
    </message>
    <message>
        <source>Standard deviation of the positions, slow errors included; scatter alone does not show those</source>
        <translation>Standardabweichung der Positionen mit langsamen Fehlern; die Streuung allein zeigt diese nicht</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>aus der Datei</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Fuß</translation>
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
        <translation>Tage</translation>
    </message>
</context>
<context>
    <name>odo::TransferActions</name>
    <message>
        <source>&amp;Pack into one file…</source>
        <translation>In eine Datei &amp;packen…</translation>
    </message>
    <message>
        <source>&amp;Unpack a packed project…</source>
        <translation>Gepacktes Projekt &amp;entpacken…</translation>
    </message>
    <message>
        <source>Find &amp;lost videos…</source>
        <translation>&amp;Verlorene Videos suchen…</translation>
    </message>
    <message>
        <source>Pack the project with its videos</source>
        <translation>Projekt mit seinen Videos packen</translation>
    </message>
    <message>
        <source>Packed projects (*%1)</source>
        <translation>Gepackte Projekte (*%1)</translation>
    </message>
    <message>
        <source>Project packed into %1. To use it on another computer, choose &quot;Unpack a packed project&quot; there.</source>
        <translation>Das Projekt ist in %1 gepackt. Anderswo wird es mit „Gepacktes Projekt entpacken“ entpackt.</translation>
    </message>
    <message>
        <source>Note: %1.</source>
        <translation>Hinweis: %1.</translation>
    </message>
    <message>
        <source>Unpack a packed project</source>
        <translation>Gepacktes Projekt entpacken</translation>
    </message>
    <message>
        <source>Packed projects (*%1);;All files (*)</source>
        <translation>Gepackte Projekte (*%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a folder for the unpacked project</source>
        <translation>Wohin soll das Projekt entpackt werden?</translation>
    </message>
    <message>
        <source>Choose the folder to search for the lost videos (with subfolders)</source>
        <translation>In oder unter welchem Ordner könnten die verlorenen Videos liegen?</translation>
    </message>
    <message>
        <source>Found %1 of %2 lost videos by their content.</source>
        <translation>%1 von %2 verlorenen Videos wurden anhand ihres Inhalts gefunden.</translation>
    </message>
    <message>
        <source>Find &amp;stray files…</source>
        <translation>Herren&amp;lose Dateien suchen…</translation>
    </message>
    <message>
        <source>Every file in the media folder belongs to a trial, a lens calibration or a floor registration.</source>
        <translation>Jede Datei im Medienordner gehört zu einem Versuch, einer Objektivkalibrierung oder einer Einmessung.</translation>
    </message>
    <message>
        <source>Stray files</source>
        <translation>Herrenlose Dateien</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) in the media folder belong to no trial, lens calibration or floor registration.</source>
        <translation>
            <numerusform>%n Datei im Medienordner gehört zu keinem Versuch, keiner Objektivkalibrierung und keiner Einmessung.</numerusform>
            <numerusform>%n Dateien im Medienordner gehören zu keinem Versuch, keiner Objektivkalibrierung und keiner Einmessung.</numerusform>
        </translation>
    </message>
    <message>
        <source>You can add videos as trials. Removed files are gone for good.</source>
        <translation>Videos können eigene Versuche werden. Entfernte Dateien sind endgültig gelöscht.</translation>
    </message>
    <message>
        <source>&amp;Add videos as trials</source>
        <translation>Videos als Versuche &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove files</source>
        <translation>Dateien &amp;entfernen</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) added. Their names begin with &quot;recovered&quot;.</source>
        <translation>
            <numerusform>%n Versuch hinzugefügt. Sein Name beginnt mit „recovered“.</numerusform>
            <numerusform>%n Versuche hinzugefügt. Ihre Namen beginnen mit „recovered“.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stray file(s) removed.</source>
        <translation>
            <numerusform>%n herrenlose Datei entfernt.</numerusform>
            <numerusform>%n herrenlose Dateien entfernt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other file(s), listed last, stay: missing recordings, projects, and files that are neither videos nor images.</source>
        <translation>
            <numerusform>%n andere Datei, am Ende aufgeführt, bleibt: eine vermisste Aufnahme, ein Projekt oder was weder Video noch Bild ist.</numerusform>
            <numerusform>%n andere Dateien, am Ende aufgeführt, bleiben: vermisste Aufnahmen, Projekte und was weder Video noch Bild ist.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrendChart</name>
    <message>
        <source>Progress of the team</source>
        <translation>Fortschritt des Teams</translation>
    </message>
    <message>
        <source>%1: %2 trials, progress: %3</source>
        <translation>%1: %2 Versuche, Fortschritt: %3</translation>
    </message>
    <message>
        <source>No team is selected</source>
        <translation>Kein Team ist ausgewählt</translation>
    </message>
    <message>
        <source>Select a team to see its results over the term.</source>
        <translation>Wählen Sie ein Team aus, um seine Versuche im Lauf des Halbjahrs zu sehen.</translation>
    </message>
</context>
<context>
    <name>odo::TrialActions</name>
    <message>
        <source>%1 in %2 of %3 frames, spikes flagged: %4</source>
        <translation>%1 in %2 von %3 Bildern, markierte Ausreißer: %4</translation>
    </message>
    <message>
        <source>%1 is tracked: %2.</source>
        <translation>%1 ist verfolgt: %2.</translation>
    </message>
    <message>
        <source>%1 is imported.</source>
        <translation>%1 ist importiert.</translation>
    </message>
    <message>
        <source>&amp;Import trial from videos…</source>
        <translation>Versuch aus Videos &amp;importieren…</translation>
    </message>
    <message>
        <source>Import finished tra&amp;cks…</source>
        <translation>Fertige &amp;Spuren importieren…</translation>
    </message>
    <message>
        <source>&amp;Track…</source>
        <translation>&amp;Verfolgen…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Export &amp;video…</source>
        <translation>Vi&amp;deo exportieren…</translation>
    </message>
    <message>
        <source>Add &amp;robot…</source>
        <translation>&amp;Roboter hinzufügen…</translation>
    </message>
    <message>
        <source>The sample at %1 of %2 is not used. Choose Undo to use it.</source>
        <translation>Der Messpunkt bei %1 von %2 wird nicht verwendet. Rückgängig nimmt es zurück.</translation>
    </message>
    <message>
        <source>The sample at %1 of %2 is used. Choose Undo to reverse this.</source>
        <translation>Der Messpunkt bei %1 von %2 wird verwendet. Rückgängig nimmt es zurück.</translation>
    </message>
    <message>
        <source>Video of %1</source>
        <translation>Video von %1</translation>
    </message>
    <message>
        <source>MP4 videos (*.mp4)</source>
        <translation>MP4-Videos (*.mp4)</translation>
    </message>
    <message>
        <source>Video of %1 saved as %2</source>
        <translation>Das Video von %1 ist da: %2</translation>
    </message>
    <message>
        <source>Robot %1 added.</source>
        <translation>Roboter %1 ist jetzt bekannt.</translation>
    </message>
    <message>
        <source>%1 is synchronised.</source>
        <translation>%1 ist synchronisiert.</translation>
    </message>
    <message>
        <source>S&amp;ynchronise…</source>
        <translation>S&amp;ynchronisieren…</translation>
    </message>
    <message>
        <source>The results of %1 are of its range, %2 to %3. Choose Undo to reverse this.</source>
        <translation>Die Ergebnisse von %1 gelten für seinen Bereich, %2 bis %3. Mit „Rückgängig“ wird das zurückgenommen.</translation>
    </message>
    <message>
        <source>The results of %1 are of the whole run.</source>
        <translation>Die Ergebnisse von %1 gelten für die ganze Fahrt.</translation>
    </message>
    <message>
        <source>E&amp;dit…</source>
        <translation>&amp;Bearbeiten…</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) changed. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>%n Versuch geändert. „Rückgängig“ stellt ihn wieder her.</numerusform>
            <numerusform>%n Versuche geändert. „Rückgängig“ stellt sie wieder her.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are not used. Choose Undo to use them.</source>
        <translation>
            <numerusform>%n Messpunkt von %1 wird nicht verwendet. „Rückgängig“ verwendet ihn wieder.</numerusform>
            <numerusform>%n Messpunkte von %1 werden nicht verwendet. „Rückgängig“ verwendet sie wieder.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are used. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>%n Messpunkt von %1 wird verwendet. „Rückgängig“ nimmt das zurück.</numerusform>
            <numerusform>%n Messpunkte von %1 werden verwendet. „Rückgängig“ nimmt das zurück.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrialChooser</name>
    <message>
        <source>&amp;Previous trial</source>
        <translation>Vor&amp;heriger Versuch</translation>
    </message>
    <message>
        <source>&amp;Next trial</source>
        <translation>&amp;Nächster Versuch</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
</context>
<context>
    <name>odo::TrialColumns</name>
    <message>
        <source>&amp;Columns</source>
        <translation>&amp;Spalten</translation>
    </message>
</context>
<context>
    <name>odo::TrialDetail</name>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Sichten</translation>
    </message>
    <message>
        <source>none: the track was imported</source>
        <translation>keine: Die Spur wurde importiert</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>none: analysed with a different course than its task has now. Reanalyse the trial</source>
        <translation>keine: nach einem anderen Parcours ausgewertet, als seine Aufgabe jetzt hat; bitte neu auswerten</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>none yet: open it and choose Track</source>
        <translation>noch keines: öffnen und Verfolgen wählen</translation>
    </message>
    <message>
        <source>Open in Review</source>
        <translation>In Durchsicht öffnen</translation>
    </message>
    <message>
        <source>Facts of the trial</source>
        <translation>Angaben zum Versuch</translation>
    </message>
    <message>
        <source>Notes of the trial</source>
        <translation>Notizen zum Versuch</translation>
    </message>
    <message>
        <source>What did you change on the robot? What do you want to remember?</source>
        <translation>Was wurde am Roboter geändert? Was soll in Erinnerung bleiben?</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>&amp;Notizen</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>No trials yet</source>
        <translation>Noch keine Versuche</translation>
    </message>
    <message>
        <source>No trial selected</source>
        <translation>Kein Versuch ausgewählt</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
</context>
<context>
    <name>odo::TrialFilterBar</name>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Any class</source>
        <translation>Jede Klasse</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Any team</source>
        <translation>Jedes Team</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>Jede Aufgabe</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Any robot</source>
        <translation>Jeder Roboter</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Any date</source>
        <translation>Jedes Datum</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Letzte 7 Tage</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Letzte 30 Tage</translation>
    </message>
    <message>
        <source>Last 12 months</source>
        <translation>Letzte 12 Monate</translation>
    </message>
    <message>
        <source>Between…</source>
        <translation>Zwischen…</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>Bin</source>
        <translation>Papierkorb</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>Mit Stern</translation>
    </message>
    <message>
        <source>Only starred trials</source>
        <translation>Nur Versuche mit Stern</translation>
    </message>
    <message>
        <source>Show only starred trials</source>
        <translation>Nur Versuche mit Stern zeigen</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>Zweifelhaft</translation>
    </message>
    <message>
        <source>Only trials with doubtful or bad results</source>
        <translation>Nur Versuche mit zweifelhaften oder schlechten Ergebnissen</translation>
    </message>
    <message>
        <source>Show only trials with doubtful or bad results</source>
        <translation>Nur Versuche mit zweifelhaften oder schlechten Ergebnissen zeigen</translation>
    </message>
</context>
<context>
    <name>odo::TrialModel</name>
    <message>
        <source>not tracked</source>
        <translation>nicht verfolgt</translation>
    </message>
    <message>
        <source>reanalyse</source>
        <translation>neu auswerten</translation>
    </message>
    <message>
        <source>starred</source>
        <translation>mit Stern</translation>
    </message>
    <message>
        <source>not starred</source>
        <translation>ohne Stern</translation>
    </message>
    <message>
        <source>Tags, separated by commas: double-click or F2 changes them</source>
        <translation>Schlagwörter, durch Kommas getrennt: Doppelklick oder F2 ändert sie</translation>
    </message>
    <message>
        <source>Star (Ctrl+D)</source>
        <translation>Stern (Strg+D)</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stern</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>Höchstgeschw.</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Schlagwörter</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
</context>
<context>
    <name>odo::TrialTable</name>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
</context>
<context>
    <name>odo::UndoActions</name>
    <message>
        <source>Undone: %1.</source>
        <translation>Rückgängig gemacht: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Wiederholt: %1.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
</context>
<context>
    <name>odo::VariableTable</name>
    <message>
        <source>several</source>
        <translation>mehrere</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Variables of your own</source>
        <translation>Eigene Variablen</translation>
    </message>
    <message>
        <source>What you want to compare runs by: surface, battery, attempt. Text or a number.</source>
        <translation>Wonach Sie Fahrten vergleichen wollen: Untergrund, Akku, Anlauf. Text oder eine Zahl.</translation>
    </message>
</context>
<context>
    <name>odo::VideoDialog</name>
    <message>
        <source>Real time</source>
        <translation>Wie gefahren</translation>
    </message>
    <message>
        <source>Slow motion, 1/2</source>
        <translation>Zeitlupe, 1/2</translation>
    </message>
    <message>
        <source>Slow motion, 1/4</source>
        <translation>Zeitlupe, 1/4</translation>
    </message>
    <message>
        <source>Slow motion, 1/10</source>
        <translation>Zeitlupe, 1/10</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>One video with all camera views, the map and the speed, to show or send. It plays without Odograph.</source>
        <translation>Ein Video mit den Bildern aller Kameras, der Karte und der Geschwindigkeit, zum Zeigen oder Verschicken: Wer es bekommt, braucht kein Odograph.</translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation>&amp;Tempo</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Design</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Ort wählen…</translation>
    </message>
</context>
<context>
    <name>odo::ViewActions</name>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Colours of the &amp;desktop</source>
        <translation>&amp;Farben des Systems</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>&amp;Dunkel</translation>
    </message>
</context>
<context>
    <name>odo::ViewSteps</name>
    <message>
        <source>Same start time</source>
        <translation>Gleichzeitig begonnen</translation>
    </message>
    <message>
        <source>By hand: time offset</source>
        <translation>Von Hand: später begonnen um</translation>
    </message>
    <message>
        <source>How to synchronise view %1 with the first</source>
        <translation>Wie Sicht %1 synchron zur ersten wird</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time offset of view %1</source>
        <translation>Wie viel später Sicht %1 begann</translation>
    </message>
    <message>
        <source>Negative: it started before the first view</source>
        <translation>Unter null: Sie begann früher als die erste Sicht</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Sicht %1</translation>
    </message>
    <message>
        <source>Automatic: motion, flash or sound</source>
        <translation>Automatisch: Bewegung, Lichtblitz oder Ton</translation>
    </message>
    <message>
        <source>By the motion</source>
        <translation>Aus der Bewegung</translation>
    </message>
    <message>
        <source>By a flash of light</source>
        <translation>Aus einem Lichtblitz</translation>
    </message>
    <message>
        <source>By sound</source>
        <translation>Aus dem Ton</translation>
    </message>
    <message>
        <source>A flash: switch the room lights on and off once while all cameras record. Sound: clap twice near the middle of the floor</source>
        <translation>Lichtblitz: Schalten Sie das Raumlicht einmal ein und aus, während alle Kameras aufnehmen. Ton: Klatschen Sie zweimal nahe der Mitte des Bodens</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Wie bisher</translation>
    </message>
</context>
<context>
    <name>odo::WarningBar</name>
    <message>
        <source>Problem</source>
        <translation>Was los ist</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>Beheben</translation>
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
        <translation>Misst anhand der Videos gewöhnlicher Kameras, wie sich ein mobiler Roboter bewegt hat.</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Letzte Projekte</translation>
    </message>
    <message>
        <source>no longer found</source>
        <translation>nicht mehr gefunden</translation>
    </message>
</context>
<context>
    <name>odo::Workspace</name>
    <message>
        <source>%1: %2. It is read-only here; to change it, close it there and reopen it here.</source>
        <translation>%1: %2. Hier lässt es sich nur ansehen; um es zu ändern, schließen Sie es dort und öffnen Sie es hier erneut.</translation>
    </message>
    <message>
        <source>The backup was restored. The damaged file is kept as “%1”.</source>
        <translation>Die Sicherungskopie ist wiederhergestellt. Die beschädigte Datei bleibt als „%1“ erhalten.</translation>
    </message>
    <message>
        <source>“%1” was written before you cancelled. It was not opened.</source>
        <translation>„%1“ war schon geschrieben, als Sie abgebrochen haben. Geöffnet wurde es nicht.</translation>
    </message>
    <message>
        <source>The backup was restored. What the project was before is kept as “%1”.</source>
        <translation>Die Sicherungskopie ist wiederhergestellt. Der vorige Stand des Projekts bleibt als „%1“ erhalten.</translation>
    </message>
</context>
<context>
    <name>odo::ZoneTable</name>
    <message>
        <source>stay inside</source>
        <translation>darin bleiben</translation>
    </message>
    <message>
        <source>keep out</source>
        <translation>meiden</translation>
    </message>
    <message>
        <source>Remo&amp;ve zone</source>
        <translation>Zone &amp;entfernen</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Corners: x y; x y; … in mm</source>
        <translation>Ecken: x y; x y; … in mm</translation>
    </message>
    <message>
        <source>Zones of the floor</source>
        <translation>Zonen des Bodens</translation>
    </message>
    <message>
        <source>Add zone to sta&amp;y in</source>
        <translation>Zone: &amp;darin bleiben</translation>
    </message>
    <message>
        <source>Add zone to &amp;keep out of</source>
        <translation>Zone: &amp;meiden</translation>
    </message>
    <message>
        <source>The robot&apos;s reference point must stay in a zone or keep out of it. Each zone counts separately; you can score how often, how long and how far a robot broke it. Drag corners and edges on the map.</source>
        <translation>Die Mitte des Roboters muss in einer Zone bleiben oder sie meiden. Jede wird für sich beurteilt; wie oft, wie lange und wie weit sie verletzt wurde, kann gewertet werden. Ziehen Sie Ecken und Ränder auf der Karte.</translation>
    </message>
    <message>
        <source>Rule of the zone</source>
        <translation>Regel der Zone</translation>
    </message>
    <message>
        <source>Zone %1</source>
        <translation>Zone %1</translation>
    </message>
</context>
<context>
    <name>project.acceptance_reason</name>
    <message>
        <source>reason for accepting the results</source>
        <translation>Grund, die Ergebnisse zu akzeptieren</translation>
    </message>
</context>
<context>
    <name>project.add_another_layout</name>
    <message>
        <source>add another layout for other markers</source>
        <translation>fügen Sie für andere Marker einen anderen Plan hinzu</translation>
    </message>
</context>
<context>
    <name>project.add_one_first</name>
    <message>
        <source>add one first</source>
        <translation>fügen Sie zuerst eins hinzu</translation>
    </message>
</context>
<context>
    <name>project.add_what_it_refers_to</name>
    <message>
        <source>add what it refers to first</source>
        <translation>fügen Sie zuerst hinzu, worauf es sich bezieht</translation>
    </message>
</context>
<context>
    <name>project.adopt_or_remove</name>
    <message>
        <source>make a trial of it with odograph check P.odo --adopt, or remove it with --remove-strays; the window offers both under &apos;Find stray files…&apos;</source>
        <translation>machen Sie unter „Herrenlose Dateien suchen…“ einen Versuch daraus, oder entfernen Sie sie dort</translation>
    </message>
</context>
<context>
    <name>project.an_analysis</name>
    <message>
        <source>analysis of a trial</source>
        <translation>Auswertung eines Versuchs</translation>
    </message>
</context>
<context>
    <name>project.analyse_again</name>
    <message>
        <source>reanalyse the trial</source>
        <translation>werten Sie den Versuch neu aus</translation>
    </message>
</context>
<context>
    <name>project.analysis_number</name>
    <message>
        <source>analysis %1</source>
        <translation>Auswertung %1</translation>
    </message>
</context>
<context>
    <name>project.analysis_of_project</name>
    <message>
        <source>analysis %1 of the project</source>
        <translation>Auswertung %1 des Projekts</translation>
    </message>
</context>
<context>
    <name>project.another_program_writes</name>
    <message>
        <source>another program is writing to it</source>
        <translation>ein anderes Programm schreibt darin</translation>
    </message>
</context>
<context>
    <name>project.area_few_corners</name>
    <message>
        <source>an area needs at least %1 corners</source>
        <translation>ein Bereich braucht mindestens %1 Ecken</translation>
    </message>
</context>
<context>
    <name>project.area_many_corners</name>
    <message>
        <source>an area has at most %1 corners</source>
        <translation>ein Bereich hat höchstens %1 Ecken</translation>
    </message>
</context>
<context>
    <name>project.area_off_frame</name>
    <message>
        <source>a position is not in the frame</source>
        <translation>eine Position liegt nicht im Bild</translation>
    </message>
</context>
<context>
    <name>project.being_recorded</name>
    <message>
        <source>it is being recorded</source>
        <translation>er wird gerade aufgenommen</translation>
    </message>
</context>
<context>
    <name>project.calibration_of_project</name>
    <message>
        <source>calibration %1 of the project</source>
        <translation>Kalibrierung %1 des Projekts</translation>
    </message>
</context>
<context>
    <name>project.calibration_origin</name>
    <message>
        <source>origin of a calibration</source>
        <translation>Herkunft einer Kalibrierung</translation>
    </message>
</context>
<context>
    <name>project.calibration_picture_of</name>
    <message>
        <source>the calibration image &apos;%1&apos; of camera &apos;%2&apos;</source>
        <translation>das Kalibrierungsbild &apos;%1&apos; der Kamera &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>project.camera_address</name>
    <message>
        <source>address of a camera</source>
        <translation>Adresse einer Kamera</translation>
    </message>
</context>
<context>
    <name>project.cannot_be_written_to</name>
    <message>
        <source>it cannot be written to</source>
        <translation>Schreiben ist dort nicht erlaubt</translation>
    </message>
</context>
<context>
    <name>project.cannot_hold</name>
    <message>
        <source>cannot hold %1</source>
        <translation>%1 kann nicht gesperrt werden</translation>
    </message>
</context>
<context>
    <name>project.cannot_record_into</name>
    <message>
        <source>cannot record into %1</source>
        <translation>in %1 kann nicht aufgenommen werden</translation>
    </message>
</context>
<context>
    <name>project.cannot_remove</name>
    <message>
        <source>cannot remove &apos;%1&apos;</source>
        <translation>&apos;%1&apos; kann nicht entfernt werden</translation>
    </message>
</context>
<context>
    <name>project.change_list</name>
    <message>
        <source>the list of changes</source>
        <translation>die Änderungsliste</translation>
    </message>
</context>
<context>
    <name>project.change_not_noted</name>
    <message>
        <source>the change could not be logged (%1)</source>
        <translation>die Änderung konnte nicht vermerkt werden (%1)</translation>
    </message>
</context>
<context>
    <name>project.change_something_first</name>
    <message>
        <source>change something first</source>
        <translation>ändern Sie zuerst etwas</translation>
    </message>
</context>
<context>
    <name>project.change_words</name>
    <message>
        <source>description of a change</source>
        <translation>Worte einer Änderung</translation>
    </message>
</context>
<context>
    <name>project.changed_since</name>
    <message>
        <source>something it concerns has been changed or used since</source>
        <translation>was sie betrifft, wurde seither geändert oder benutzt</translation>
    </message>
</context>
<context>
    <name>project.check</name>
    <message>
        <source>check of the project</source>
        <translation>Prüfung des Projekts</translation>
    </message>
</context>
<context>
    <name>project.check_disk</name>
    <message>
        <source>check the disk</source>
        <translation>prüfen Sie die Platte</translation>
    </message>
</context>
<context>
    <name>project.check_disk_and_retry</name>
    <message>
        <source>check the disk and try again</source>
        <translation>prüfen Sie die Platte und versuchen Sie es noch einmal</translation>
    </message>
</context>
<context>
    <name>project.check_folder_is_there</name>
    <message>
        <source>check that the folder exists and that you may read it</source>
        <translation>prüfen Sie, ob der Ordner da ist und gelesen werden darf</translation>
    </message>
</context>
<context>
    <name>project.check_its_input</name>
    <message>
        <source>check the input that it was computed from</source>
        <translation>prüfen Sie, woraus er berechnet wurde</translation>
    </message>
</context>
<context>
    <name>project.check_name_or_make</name>
    <message>
        <source>check the name, or create a new project</source>
        <translation>prüfen Sie den Namen, oder legen Sie ein neues Projekt an</translation>
    </message>
</context>
<context>
    <name>project.check_project_folder</name>
    <message>
        <source>check the free space and the permissions of the project&apos;s folder</source>
        <translation>prüfen Sie den freien Platz und die Rechte des Projektordners</translation>
    </message>
</context>
<context>
    <name>project.check_rights</name>
    <message>
        <source>check the permissions of the project&apos;s folder</source>
        <translation>prüfen Sie die Rechte des Projektordners</translation>
    </message>
</context>
<context>
    <name>project.checking</name>
    <message>
        <source>checking %1</source>
        <translation>%1 wird geprüft</translation>
    </message>
</context>
<context>
    <name>project.checking_database</name>
    <message>
        <source>checking the database</source>
        <translation>die Datenbank wird geprüft</translation>
    </message>
</context>
<context>
    <name>project.choose_from_list</name>
    <message>
        <source>choose one from the list</source>
        <translation>eines aus der Liste wählen</translation>
    </message>
</context>
<context>
    <name>project.choose_its_own</name>
    <message>
        <source>choose one of its own (odograph revisions P.odo CAMERA --use), or restore the project from a backup copy</source>
        <translation>wählen Sie eine ihrer eigenen („Ältere Kalibrierungen…“), oder stellen Sie das Projekt aus einer Sicherungskopie wieder her</translation>
    </message>
</context>
<context>
    <name>project.choose_our_file</name>
    <message>
        <source>choose a file that Odograph has written</source>
        <translation>wählen Sie eine Datei, die Odograph geschrieben hat</translation>
    </message>
</context>
<context>
    <name>project.choose_writable_folder</name>
    <message>
        <source>choose a folder that can be written to and has free space</source>
        <translation>wählen Sie einen beschreibbaren Ordner mit Platz</translation>
    </message>
</context>
<context>
    <name>project.class_has_team</name>
    <message>
        <source>a team belongs to it</source>
        <translation>ein Team gehört dazu</translation>
    </message>
</context>
<context>
    <name>project.class_has_teams</name>
    <message>
        <source>%1 teams belong to it</source>
        <translation>%1 Teams gehören dazu</translation>
    </message>
</context>
<context>
    <name>project.close_it_there</name>
    <message>
        <source>close it there first</source>
        <translation>schließen Sie es dort zuerst</translation>
    </message>
</context>
<context>
    <name>project.close_other_program</name>
    <message>
        <source>close the other program and try again</source>
        <translation>schließen Sie das andere Programm und versuchen Sie es noch einmal</translation>
    </message>
</context>
<context>
    <name>project.complete_recording</name>
    <message>
        <source>to complete it, open the project for writing: odograph record P.odo --recover</source>
        <translation>öffnen Sie das Projekt zum Schreiben, dabei wird sie abgeschlossen</translation>
    </message>
</context>
<context>
    <name>project.copy</name>
    <message>
        <source>copy &apos;%1&apos;</source>
        <translation>Kopie &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.copy_again</name>
    <message>
        <source>copy it again from its source, or restore a backup copy</source>
        <translation>kopieren Sie sie noch einmal von ihrer Quelle, oder stellen Sie eine Sicherungskopie wieder her</translation>
    </message>
</context>
<context>
    <name>project.copy_differs</name>
    <message>
        <source>the copy differs from what was written</source>
        <translation>die Kopie weicht vom Geschriebenen ab</translation>
    </message>
</context>
<context>
    <name>project.copy_file_beside</name>
    <message>
        <source>copy the file to the project&apos;s folder</source>
        <translation>kopieren Sie die Datei neben das Projekt</translation>
    </message>
</context>
<context>
    <name>project.copy_of_project</name>
    <message>
        <source>copy of project &apos;%1&apos;</source>
        <translation>Kopie des Projekts &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.copy_sound_backup</name>
    <message>
        <source>copy &apos;%1&apos;, which is intact, to a new name, open that copy and keep the damaged file</source>
        <translation>kopieren Sie „%1“, das unversehrt ist, unter einen neuen Namen, öffnen Sie diese Kopie, und behalten Sie die beschädigte Datei</translation>
    </message>
</context>
<context>
    <name>project.copy_to_another_disk</name>
    <message>
        <source>check the disk, and copy the project to another one</source>
        <translation>prüfen Sie die Platte und kopieren Sie das Projekt auf eine andere</translation>
    </message>
</context>
<context>
    <name>project.copy_to_writable_folder</name>
    <message>
        <source>copy it to a folder that you may write to, and open the copy</source>
        <translation>kopieren Sie es in einen Ordner, in den Sie schreiben dürfen, und öffnen Sie die Kopie</translation>
    </message>
</context>
<context>
    <name>project.copy_with_side_files</name>
    <message>
        <source>copy it with the files beside it to a folder that you may write to, and open the copy</source>
        <translation>kopieren Sie es mit den Dateien daneben in einen Ordner, in den Sie schreiben dürfen, und öffnen Sie die Kopie</translation>
    </message>
</context>
<context>
    <name>project.copy_with_videos</name>
    <message>
        <source>copy it with its videos to a folder that you may write to, and open the copy</source>
        <translation>kopieren Sie es mit seinen Videos in einen Ordner, in den Sie schreiben dürfen, und öffnen Sie die Kopie</translation>
    </message>
</context>
<context>
    <name>project.corners_of</name>
    <message>
        <source>corners of &apos;%1&apos;</source>
        <translation>Ecken von &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.covariance_not_6_by_6</name>
    <message>
        <source>its stored covariance is not a 6 by 6 matrix</source>
        <translation>die gespeicherte Kovarianz ist keine 6 × 6-Matrix</translation>
    </message>
</context>
<context>
    <name>project.database_refused</name>
    <message>
        <source>the database reported an error</source>
        <translation>die Datenbank verweigerte es</translation>
    </message>
</context>
<context>
    <name>project.database_refused_because</name>
    <message>
        <source>the database reported an error (%1)</source>
        <translation>die Datenbank verweigerte es (%1)</translation>
    </message>
</context>
<context>
    <name>project.delete_its_trials</name>
    <message>
        <source>delete its trials permanently first, or archive its class</source>
        <translation>löschen Sie sie zuerst endgültig, oder archivieren Sie seine Klasse</translation>
    </message>
</context>
<context>
    <name>project.disk_error</name>
    <message>
        <source>the disk reported an error, the change was not saved</source>
        <translation>die Platte meldete einen Fehler, die Änderung wurde nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>project.disk_full</name>
    <message>
        <source>the disk is full, the change was not saved</source>
        <translation>die Platte ist voll, die Änderung wurde nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>project.disk_read_only</name>
    <message>
        <source>the disk has become read-only, the change was not saved</source>
        <translation>die Platte ist schreibgeschützt geworden, die Änderung wurde nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>project.disk_unreadable</name>
    <message>
        <source>the disk could not be read; nothing was changed</source>
        <translation>die Platte konnte nicht gelesen werden, und nichts wurde geändert</translation>
    </message>
</context>
<context>
    <name>project.duration_of_recordings_differs</name>
    <message>
        <source>its duration is stored as %1, its recordings last %2</source>
        <translation>als Dauer ist %1 gespeichert, die Aufnahmen dauern %2</translation>
    </message>
</context>
<context>
    <name>project.duration_of_tracks_differs</name>
    <message>
        <source>its duration is stored as %1, its imported tracks last %2</source>
        <translation>als Dauer ist %1 gespeichert, die importierten Spuren dauern %2</translation>
    </message>
</context>
<context>
    <name>project.earlier_step_failed</name>
    <message>
        <source>an earlier step of this change failed</source>
        <translation>ein früherer Schritt dieser Änderung misslang</translation>
    </message>
</context>
<context>
    <name>project.end_recording_first</name>
    <message>
        <source>end its recording first</source>
        <translation>beenden Sie zuerst seine Aufnahme</translation>
    </message>
</context>
<context>
    <name>project.figures_without_task</name>
    <message>
        <source>without it, their metrics would not show which rules applied</source>
        <translation>ihre Kennwerte würden nicht mehr sagen, wonach sie ermittelt wurden</translation>
    </message>
</context>
<context>
    <name>project.file_changed</name>
    <message>
        <source>%1 has changed since it was created</source>
        <translation>%1 wurde seit der Entstehung verändert</translation>
    </message>
</context>
<context>
    <name>project.file_cut_off</name>
    <message>
        <source>the file is incomplete</source>
        <translation>die Datei ist abgeschnitten</translation>
    </message>
</context>
<context>
    <name>project.file_damaged</name>
    <message>
        <source>the file is damaged</source>
        <translation>die Datei ist beschädigt</translation>
    </message>
</context>
<context>
    <name>project.file_lost</name>
    <message>
        <source>its file was deleted, renamed or replaced while it was open; nothing was stored</source>
        <translation>seine Datei wurde gelöscht, umbenannt oder ersetzt, während es offen war; nichts wurde gespeichert</translation>
    </message>
</context>
<context>
    <name>project.file_there_already</name>
    <message>
        <source>a file of that name already exists</source>
        <translation>eine Datei dieses Namens gibt es schon</translation>
    </message>
</context>
<context>
    <name>project.file_unused</name>
    <message>
        <source>no trial, lens calibration or floor registration uses this file</source>
        <translation>kein Versuch, keine Objektivkalibrierung und keine Einmessung verwendet diese Datei</translation>
    </message>
</context>
<context>
    <name>project.find_or_put_back</name>
    <message>
        <source>take it from there with odograph check P.odo --find FOLDER or Find lost videos… in the window, or move it back to its folder</source>
        <translation>holen Sie sie mit „Verlorene Videos suchen…“ von dort, oder legen Sie sie an ihren Platz zurück</translation>
    </message>
</context>
<context>
    <name>project.folder_read_only</name>
    <message>
        <source>its folder cannot be written to</source>
        <translation>in seinen Ordner kann nicht geschrieben werden</translation>
    </message>
</context>
<context>
    <name>project.foreign_log</name>
    <message>
        <source>the log beside it (&apos;%1&apos;) belongs to another file or to another state of this one</source>
        <translation>das Protokoll daneben („%1“) gehört zu einer anderen Datei oder zu einem anderen Stand dieser Datei</translation>
    </message>
</context>
<context>
    <name>project.format_1</name>
    <message>
        <source>the first schema</source>
        <translation>das erste Schema</translation>
    </message>
</context>
<context>
    <name>project.format_10</name>
    <message>
        <source>for a school year: stars, tags, archive, bin, pseudonyms, scoring and the list of changes</source>
        <translation>was ein Schuljahr braucht: Sterne, Schlagwörter, Archiv, Papierkorb, Pseudonyme, Wertung und die Liste der Änderungen</translation>
    </message>
</context>
<context>
    <name>project.format_11</name>
    <message>
        <source>members and robots of teams, zones and the archive of tasks, and imported tracks</source>
        <translation>Mitglieder und Roboter der Teams, Zonen und Archiv der Aufgaben, und importierte Spuren</translation>
    </message>
</context>
<context>
    <name>project.format_12</name>
    <message>
        <source>digests of analyses, and long series in chunks</source>
        <translation>Prüfsummen der Auswertungen, und lange Reihen in Stücken</translation>
    </message>
</context>
<context>
    <name>project.format_13</name>
    <message>
        <source>reference points of robots</source>
        <translation>der Punkt eines Roboters, der gemessen wird</translation>
    </message>
</context>
<context>
    <name>project.format_14</name>
    <message>
        <source>periods with ambiguous robot names</source>
        <translation>wann Roboter gleichen Aussehens nicht zu unterscheiden waren</translation>
    </message>
</context>
<context>
    <name>project.format_15</name>
    <message>
        <source>robots marked by hand in a frame</source>
        <translation>Roboter, die ein Mensch in einem Bild gezeigt hat</translation>
    </message>
</context>
<context>
    <name>project.format_16</name>
    <message>
        <source>messages as codes with their arguments</source>
        <translation>Sätze als Codes mit ihren Argumenten</translation>
    </message>
</context>
<context>
    <name>project.format_17</name>
    <message>
        <source>verdicts, and their acceptance</source>
        <translation>Urteile und ihre Annahme</translation>
    </message>
</context>
<context>
    <name>project.format_18</name>
    <message>
        <source>how the frames of recordings are turned</source>
        <translation>wie die Bilder von Aufnahmen gedreht werden</translation>
    </message>
</context>
<context>
    <name>project.format_19</name>
    <message>
        <source>ranges and variables of trials</source>
        <translation>Bereiche und Variablen von Versuchen</translation>
    </message>
</context>
<context>
    <name>project.format_2</name>
    <message>
        <source>manual overrides of samples</source>
        <translation>Messpunkte, über die von Hand anders entschieden wurde</translation>
    </message>
</context>
<context>
    <name>project.format_20</name>
    <message>
        <source>which observations are in force</source>
        <translation>welche Beobachtungen gelten</translation>
    </message>
</context>
<context>
    <name>project.format_21</name>
    <message>
        <source>guidance of the tracker, and the school&apos;s hub</source>
        <translation>Vorgaben für die Verfolgung und der Hub der Schule</translation>
    </message>
</context>
<context>
    <name>project.format_3</name>
    <message>
        <source>clock rates of the cameras</source>
        <translation>Gang der Kamerauhren</translation>
    </message>
</context>
<context>
    <name>project.format_4</name>
    <message>
        <source>tasks with gates, a reference path and limits</source>
        <translation>Aufgaben mit Toren, Sollbahn und Grenzwerten</translation>
    </message>
</context>
<context>
    <name>project.format_5</name>
    <message>
        <source>synchronisation of each view</source>
        <translation>wie jede Sicht synchronisiert wurde</translation>
    </message>
</context>
<context>
    <name>project.format_6</name>
    <message>
        <source>calibrations with their boards, corners and images</source>
        <translation>Kalibrierungen mit ihren Tafeln, Ecken und Bildern</translation>
    </message>
</context>
<context>
    <name>project.format_7</name>
    <message>
        <source>chosen revisions and registration checks</source>
        <translation>gewählte Revisionen, und Prüfungen von Einmessungen</translation>
    </message>
</context>
<context>
    <name>project.format_8</name>
    <message>
        <source>trials during recording, and the raw times of their frames</source>
        <translation>Versuche während der Aufnahme, und die Rohzeiten ihrer Bilder</translation>
    </message>
</context>
<context>
    <name>project.format_9</name>
    <message>
        <source>images of registrations</source>
        <translation>Bilder der Einmessungen</translation>
    </message>
</context>
<context>
    <name>project.frame_times_of</name>
    <message>
        <source>frame times of &apos;%1&apos;</source>
        <translation>Bildzeiten von &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.frames_in_wrong_order</name>
    <message>
        <source>it ends before it starts</source>
        <translation>das Ende liegt vor dem Anfang</translation>
    </message>
</context>
<context>
    <name>project.give_a_height</name>
    <message>
        <source>enter a height, or have it estimated</source>
        <translation>geben Sie eine Höhe an, oder lassen Sie sie schätzen</translation>
    </message>
</context>
<context>
    <name>project.give_a_name</name>
    <message>
        <source>give the %1 a name</source>
        <translation>geben Sie einen Namen an (%1)</translation>
    </message>
</context>
<context>
    <name>project.give_a_title</name>
    <message>
        <source>give the project a title</source>
        <translation>geben Sie dem Projekt einen Titel</translation>
    </message>
</context>
<context>
    <name>project.give_another_task</name>
    <message>
        <source>give them another task first</source>
        <translation>geben Sie ihnen zuerst eine andere Aufgabe</translation>
    </message>
</context>
<context>
    <name>project.give_fewer_corners</name>
    <message>
        <source>give fewer corners, or two areas</source>
        <translation>geben Sie weniger Ecken an oder zwei Bereiche</translation>
    </message>
</context>
<context>
    <name>project.give_file_a_name</name>
    <message>
        <source>give the file a name</source>
        <translation>geben Sie der Datei einen Namen</translation>
    </message>
</context>
<context>
    <name>project.give_frame_pixels</name>
    <message>
        <source>give positions in pixels of the frame</source>
        <translation>geben Sie Positionen in Pixeln des Bildes an</translation>
    </message>
</context>
<context>
    <name>project.give_frames_in_order</name>
    <message>
        <source>give the start before the end</source>
        <translation>geben Sie den Anfang vor dem Ende an</translation>
    </message>
</context>
<context>
    <name>project.give_members</name>
    <message>
        <source>give the names of the people in the team</source>
        <translation>geben Sie die Namen der Personen im Team an</translation>
    </message>
</context>
<context>
    <name>project.give_more_corners</name>
    <message>
        <source>give more corners</source>
        <translation>geben Sie mehr Ecken an</translation>
    </message>
</context>
<context>
    <name>project.give_robot_size</name>
    <message>
        <source>give length and width in millimetres, like 260x190</source>
        <translation>geben Sie Länge und Breite in Millimetern an, etwa 260x190</translation>
    </message>
</context>
<context>
    <name>project.give_sigma_px</name>
    <message>
        <source>give σ in pixels</source>
        <translation>geben Sie σ in Pixeln an</translation>
    </message>
</context>
<context>
    <name>project.give_whole_truth</name>
    <message>
        <source>give position, velocity and acceleration for each time</source>
        <translation>geben Sie zu jeder Zeit Ort, Geschwindigkeit und Beschleunigung an</translation>
    </message>
</context>
<context>
    <name>project.guidance</name>
    <message>
        <source>guidance of the tracker</source>
        <translation>Vorgaben für die Verfolgung</translation>
    </message>
</context>
<context>
    <name>project.guidance_is_gone</name>
    <message>
        <source>it was removed meanwhile</source>
        <translation>es wurde inzwischen entfernt</translation>
    </message>
</context>
<context>
    <name>project.guidance_too_many</name>
    <message>
        <source>the view already has %1 of them</source>
        <translation>die Sicht hat schon %1 davon</translation>
    </message>
</context>
<context>
    <name>project.has_bytes_of</name>
    <message>
        <source>it has %1 of %2 bytes</source>
        <translation>%1 von %2 Bytes sind da</translation>
    </message>
</context>
<context>
    <name>project.has_characters</name>
    <message>
        <source>it has %1 characters</source>
        <translation>%1 Zeichen</translation>
    </message>
</context>
<context>
    <name>project.has_names</name>
    <message>
        <source>it has %1</source>
        <translation>vorhanden: %1</translation>
    </message>
</context>
<context>
    <name>project.has_none_yet</name>
    <message>
        <source>it has no %1 yet</source>
        <translation>es hat noch nichts dieser Art: %1</translation>
    </message>
</context>
<context>
    <name>project.has_other_size</name>
    <message>
        <source>%1 has %2 bytes instead of %3</source>
        <translation>%1 hat %2 Bytes statt %3</translation>
    </message>
</context>
<context>
    <name>project.has_robots</name>
    <message>
        <source>it has %1 robots</source>
        <translation>er hat %1 Roboter</translation>
    </message>
</context>
<context>
    <name>project.has_views</name>
    <message>
        <source>it has %1 views</source>
        <translation>er hat %1 Sichten</translation>
    </message>
</context>
<context>
    <name>project.height_below_floor</name>
    <message>
        <source>its height is below the floor</source>
        <translation>seine Höhe liegt unter dem Boden</translation>
    </message>
</context>
<context>
    <name>project.height_from_0</name>
    <message>
        <source>give a height of 0 or more</source>
        <translation>geben Sie eine Höhe von 0 oder mehr an</translation>
    </message>
</context>
<context>
    <name>project.height_not_given</name>
    <message>
        <source>it needs a fixed height, but none is given</source>
        <translation>seine Höhe soll vorgegeben sein, aber es gibt keine</translation>
    </message>
</context>
<context>
    <name>project.holds_invisible</name>
    <message>
        <source>it holds an invisible character, %1</source>
        <translation>darin ist ein unsichtbares Zeichen, %1</translation>
    </message>
</context>
<context>
    <name>project.holds_line_break</name>
    <message>
        <source>it holds a line break or another control character</source>
        <translation>darin ist ein Zeilenumbruch oder ein anderes Steuerzeichen</translation>
    </message>
</context>
<context>
    <name>project.ignored_area</name>
    <message>
        <source>ignored area</source>
        <translation>ignorierter Bereich</translation>
    </message>
</context>
<context>
    <name>project.import_another_file</name>
    <message>
        <source>import another file</source>
        <translation>importieren Sie eine andere Datei</translation>
    </message>
</context>
<context>
    <name>project.impossible_format</name>
    <message>
        <source>it claims to have format %1</source>
        <translation>sie gibt das Format %1 an</translation>
    </message>
</context>
<context>
    <name>project.in_synced_folder</name>
    <message>
        <source>it is in a folder that %1 copies while it changes: a copy may contain half a change</source>
        <translation>es liegt in einem Ordner, den %1 kopiert, während es sich ändert, sodass eine Kopie eine halbe Änderung haben kann</translation>
    </message>
</context>
<context>
    <name>project.is_missing</name>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
</context>
<context>
    <name>project.is_missing_recording</name>
    <message>
        <source>this is a missing recording</source>
        <translation>dies ist eine fehlende Aufnahme</translation>
    </message>
</context>
<context>
    <name>project.journal_of_another</name>
    <message>
        <source>the journal beside it names another file</source>
        <translation>das Journal daneben nennt eine andere Datei</translation>
    </message>
</context>
<context>
    <name>project.keep_it</name>
    <message>
        <source>keep it</source>
        <translation>behalten Sie ihn</translation>
    </message>
</context>
<context>
    <name>project.keep_on_own_disk</name>
    <message>
        <source>keep it on a disk of this computer, and pack it to share it</source>
        <translation>halten Sie es auf einer Platte dieses Rechners, und packen Sie es, um es weiterzugeben</translation>
    </message>
</context>
<context>
    <name>project.kind_calibration</name>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
</context>
<context>
    <name>project.kind_camera</name>
    <message>
        <source>camera</source>
        <translation>Kamera</translation>
    </message>
</context>
<context>
    <name>project.kind_class</name>
    <message>
        <source>class</source>
        <translation>Klasse</translation>
    </message>
</context>
<context>
    <name>project.kind_figure</name>
    <message>
        <source>metric</source>
        <translation>Kennwert</translation>
    </message>
</context>
<context>
    <name>project.kind_gate</name>
    <message>
        <source>gate</source>
        <translation>Tor</translation>
    </message>
</context>
<context>
    <name>project.kind_layout</name>
    <message>
        <source>layout</source>
        <translation>Plan</translation>
    </message>
</context>
<context>
    <name>project.kind_lens</name>
    <message>
        <source>lens calibration</source>
        <translation>Objektiv</translation>
    </message>
</context>
<context>
    <name>project.kind_marker</name>
    <message>
        <source>marker</source>
        <translation>Marker</translation>
    </message>
</context>
<context>
    <name>project.kind_member</name>
    <message>
        <source>member</source>
        <translation>Mitglied</translation>
    </message>
</context>
<context>
    <name>project.kind_pseudonym</name>
    <message>
        <source>pseudonym</source>
        <translation>Pseudonym</translation>
    </message>
</context>
<context>
    <name>project.kind_registration</name>
    <message>
        <source>registration</source>
        <translation>Einmessung</translation>
    </message>
</context>
<context>
    <name>project.kind_robot</name>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
</context>
<context>
    <name>project.kind_tag</name>
    <message>
        <source>tag</source>
        <translation>Schlagwort</translation>
    </message>
</context>
<context>
    <name>project.kind_task</name>
    <message>
        <source>task</source>
        <translation>Aufgabe</translation>
    </message>
</context>
<context>
    <name>project.kind_team</name>
    <message>
        <source>team</source>
        <translation>Team</translation>
    </message>
</context>
<context>
    <name>project.kind_track</name>
    <message>
        <source>track</source>
        <translation>Spur</translation>
    </message>
</context>
<context>
    <name>project.kind_trial</name>
    <message>
        <source>trial</source>
        <translation>Versuch</translation>
    </message>
</context>
<context>
    <name>project.kind_variable</name>
    <message>
        <source>variable</source>
        <translation>Variable</translation>
    </message>
</context>
<context>
    <name>project.kind_zone</name>
    <message>
        <source>zone</source>
        <translation>Zone</translation>
    </message>
</context>
<context>
    <name>project.label_twice</name>
    <message>
        <source>the label &apos;%1&apos; appears twice</source>
        <translation>die Bezeichnung &apos;%1&apos; gibt es zweimal</translation>
    </message>
</context>
<context>
    <name>project.leave_it</name>
    <message>
        <source>leave it</source>
        <translation>lassen Sie es dabei</translation>
    </message>
</context>
<context>
    <name>project.leave_one_out</name>
    <message>
        <source>use only one of the two</source>
        <translation>lassen Sie eines von beiden weg</translation>
    </message>
</context>
<context>
    <name>project.leave_out_unseen_markers</name>
    <message>
        <source>remove those that no camera sees</source>
        <translation>lassen Sie die weg, die keine Kamera sieht</translation>
    </message>
</context>
<context>
    <name>project.lengths_differ</name>
    <message>
        <source>samples and profile differ in length</source>
        <translation>Messpunkte und Profil sind verschieden lang</translation>
    </message>
</context>
<context>
    <name>project.lens_kept</name>
    <message>
        <source>the lens calibration remains valid without it</source>
        <translation>die Objektivdaten bleiben auch ohne sie erhalten</translation>
    </message>
</context>
<context>
    <name>project.lens_of_project</name>
    <message>
        <source>lens calibration %1 of the project</source>
        <translation>Objektiv %1 des Projekts</translation>
    </message>
</context>
<context>
    <name>project.lies_in_media</name>
    <message>
        <source>a project is in the media folder of another one</source>
        <translation>ein Projekt liegt im Medienordner eines anderen</translation>
    </message>
</context>
<context>
    <name>project.lists_too_long</name>
    <message>
        <source>%1: more than %2 of one %3: %4</source>
        <translation>%1: mehr als %2 je %3: %4</translation>
    </message>
</context>
<context>
    <name>project.look_for_strays</name>
    <message>
        <source>find stray files</source>
        <translation>Suche nach herrenlosen Dateien</translation>
    </message>
</context>
<context>
    <name>project.look_in</name>
    <message>
        <source>search &apos;%1&apos;</source>
        <translation>Suche in &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.marker_errors_differ</name>
    <message>
        <source>the stored marker errors of registration %1 differ from those of its markers</source>
        <translation>die Markerfehler der Einmessung %1 sind nicht die, die ihre Marker ergeben</translation>
    </message>
</context>
<context>
    <name>project.marker_off_floor</name>
    <message>
        <source>marker &apos;%1&apos; is not within a floor of 1 km</source>
        <translation>Marke &apos;%1&apos; liegt nicht auf einem Boden von 1 km</translation>
    </message>
</context>
<context>
    <name>project.matrix_not_square</name>
    <message>
        <source>its stored matrix of %1 numbers is not square</source>
        <translation>die gespeicherte Matrix aus %1 Zahlen ist nicht quadratisch</translation>
    </message>
</context>
<context>
    <name>project.may_be_used_beside</name>
    <message>
        <source>project &apos;%1&apos; beside it may use them, and cannot be read (%2)</source>
        <translation>das Projekt „%1“ daneben verwendet sie vielleicht und kann nicht gelesen werden (%2)</translation>
    </message>
</context>
<context>
    <name>project.measured_by_task</name>
    <message>
        <source>its rules were used to measure trials</source>
        <translation>Versuche wurden danach ausgewertet</translation>
    </message>
</context>
<context>
    <name>project.measurements_changed</name>
    <message>
        <source>the measurements have changed since robot &apos;%1&apos; was analysed</source>
        <translation>die Messungen haben sich seit der Auswertung des Roboters &apos;%1&apos; geändert</translation>
    </message>
</context>
<context>
    <name>project.metric</name>
    <message>
        <source>metric &apos;%1&apos;</source>
        <translation>Kennwert &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.metric_differs</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is stored as %3, its positions give %4</source>
        <translation>als Kennwert &apos;%1&apos; des Roboters &apos;%2&apos; ist %3 gespeichert, seine Orte ergeben %4</translation>
    </message>
</context>
<context>
    <name>project.metric_missing</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is missing, its positions give %3</source>
        <translation>der Kennwert &apos;%1&apos; des Roboters &apos;%2&apos; fehlt, seine Orte ergeben %3</translation>
    </message>
</context>
<context>
    <name>project.metric_sigma_differs</name>
    <message>
        <source>the standard deviation of metric &apos;%1&apos; of robot &apos;%2&apos; is stored as %3, its positions give %4</source>
        <translation>als Standardabweichung des Kennwerts &apos;%1&apos; des Roboters &apos;%2&apos; ist %3 gespeichert, seine Orte ergeben %4</translation>
    </message>
</context>
<context>
    <name>project.metric_without_source</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is stored, but its positions give none</source>
        <translation>der Kennwert &apos;%1&apos; des Roboters &apos;%2&apos; ist gespeichert, aber seine Orte ergeben keinen</translation>
    </message>
</context>
<context>
    <name>project.more_names</name>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
</context>
<context>
    <name>project.move_file_away</name>
    <message>
        <source>move it to another folder</source>
        <translation>verschieben Sie sie in einen anderen Ordner</translation>
    </message>
</context>
<context>
    <name>project.move_log_away</name>
    <message>
        <source>move the log to another folder to open the file without it, or restore the file that the log belongs to</source>
        <translation>verschieben Sie das Protokoll in einen anderen Ordner, um die Datei ohne es zu öffnen, oder legen Sie die Datei zurück, zu der es gehört</translation>
    </message>
</context>
<context>
    <name>project.move_project_away</name>
    <message>
        <source>move it with its videos to a folder of its own</source>
        <translation>verschieben Sie es mit seinen Videos in einen eigenen Ordner</translation>
    </message>
</context>
<context>
    <name>project.move_teams_first</name>
    <message>
        <source>move its teams to another class first, or archive it</source>
        <translation>verschieben Sie ihre Teams zuerst in eine andere Klasse, oder archivieren Sie sie</translation>
    </message>
</context>
<context>
    <name>project.name_empty</name>
    <message>
        <source>it is empty</source>
        <translation>er ist leer</translation>
    </message>
</context>
<context>
    <name>project.name_of</name>
    <message>
        <source>name of a %1</source>
        <translation>Name (%1)</translation>
    </message>
</context>
<context>
    <name>project.name_robots_once</name>
    <message>
        <source>list each of its robots once</source>
        <translation>nennen Sie jeden Roboter einmal</translation>
    </message>
</context>
<context>
    <name>project.name_taken</name>
    <message>
        <source>the project already has a %1 of that name</source>
        <translation>das Projekt hat schon einen Eintrag „%1“ dieses Namens</translation>
    </message>
</context>
<context>
    <name>project.name_video_file</name>
    <message>
        <source>name the video&apos;s file</source>
        <translation>nennen Sie die Datei des Videos</translation>
    </message>
</context>
<context>
    <name>project.newer_format</name>
    <message>
        <source>it was written by a newer Odograph (format %1, this one knows formats up to %2)</source>
        <translation>geschrieben von einem neueren Odograph (Format %1, dieses kennt Formate bis %2)</translation>
    </message>
</context>
<context>
    <name>project.no_file_but_other</name>
    <message>
        <source>it is a folder or a device, not a file</source>
        <translation>es ist ein Ordner oder Gerät, keine Datei</translation>
    </message>
</context>
<context>
    <name>project.no_file_name</name>
    <message>
        <source>it has no file name</source>
        <translation>der Dateiname fehlt</translation>
    </message>
</context>
<context>
    <name>project.no_ordinary_number</name>
    <message>
        <source>a value to store is too large or not a number</source>
        <translation>ein zu speichernder Wert ist keine Zahl gewöhnlicher Größe</translation>
    </message>
</context>
<context>
    <name>project.no_place_to_rescue_to</name>
    <message>
        <source>its folder is gone, and no home folder exists to rescue it to</source>
        <translation>sein Ordner ist verschwunden, und es gibt keinen persönlichen Ordner, in den es gerettet werden könnte</translation>
    </message>
</context>
<context>
    <name>project.no_samples</name>
    <message>
        <source>it has no samples</source>
        <translation>keine Messpunkte</translation>
    </message>
</context>
<context>
    <name>project.no_sound_backup</name>
    <message>
        <source>no intact backup was found beside it</source>
        <translation>keine unversehrte Sicherungskopie liegt daneben</translation>
    </message>
</context>
<context>
    <name>project.no_such_name</name>
    <message>
        <source>the project has no such %1</source>
        <translation>so etwas gibt es im Projekt nicht: %1</translation>
    </message>
</context>
<context>
    <name>project.no_such_number</name>
    <message>
        <source>it has no %1 with the number %2</source>
        <translation>mit der Nummer %2 gibt es darin nichts: %1</translation>
    </message>
</context>
<context>
    <name>project.not_a_project</name>
    <message>
        <source>it is not a project file</source>
        <translation>es ist keine Projektdatei</translation>
    </message>
</context>
<context>
    <name>project.not_brought_to_format</name>
    <message>
        <source>it could not be converted to format %1 (%2)</source>
        <translation>es konnte nicht auf Format %1 gebracht werden (%2)</translation>
    </message>
</context>
<context>
    <name>project.not_complete_yet</name>
    <message>
        <source>it is not complete yet</source>
        <translation>sie ist noch nicht abgeschlossen</translation>
    </message>
</context>
<context>
    <name>project.not_copied</name>
    <message>
        <source>it could not be copied to be read (%1)</source>
        <translation>es konnte zum Lesen nicht kopiert werden (%1)</translation>
    </message>
</context>
<context>
    <name>project.not_finite</name>
    <message>
        <source>it is not a finite number</source>
        <translation>das ist keine endliche Zahl</translation>
    </message>
</context>
<context>
    <name>project.not_in_bin</name>
    <message>
        <source>it is not in the bin</source>
        <translation>er ist nicht im Papierkorb</translation>
    </message>
</context>
<context>
    <name>project.not_utf8</name>
    <message>
        <source>it is not valid UTF-8 text</source>
        <translation>kein gültiger UTF-8-Text</translation>
    </message>
</context>
<context>
    <name>project.not_visible_span</name>
    <message>
        <source>time in which a robot is not visible</source>
        <translation>Zeit, in der ein Roboter nicht sichtbar ist</translation>
    </message>
</context>
<context>
    <name>project.nothing_to_redo</name>
    <message>
        <source>nothing has been undone</source>
        <translation>nichts wurde zurückgenommen</translation>
    </message>
</context>
<context>
    <name>project.nothing_to_undo</name>
    <message>
        <source>nothing has been changed since the project was opened</source>
        <translation>seit dem Öffnen des Projekts wurde nichts geändert</translation>
    </message>
</context>
<context>
    <name>project.numbers_too_large</name>
    <message>
        <source>%1: numbers beyond %2: %3</source>
        <translation>%1: Zahlen jenseits von %2: %3</translation>
    </message>
</context>
<context>
    <name>project.observations_do_not_fit</name>
    <message>
        <source>view &apos;%1&apos; has %2 frames, but the observations of &apos;%3&apos; (%4) do not fit them</source>
        <translation>Sicht &apos;%1&apos; hat %2 Bilder, aber die Beobachtungen von &apos;%3&apos; (%4) passen nicht dazu</translation>
    </message>
</context>
<context>
    <name>project.observations_of_project</name>
    <message>
        <source>observations %1 of the project</source>
        <translation>Beobachtungen %1 des Projekts</translation>
    </message>
</context>
<context>
    <name>project.older_format</name>
    <message>
        <source>it has the older format %1 and must be updated before Odograph can read it, but %2</source>
        <translation>es hat das ältere Format %1 und muss vor dem Lesen aktualisiert werden, aber %2</translation>
    </message>
</context>
<context>
    <name>project.on_network_disk</name>
    <message>
        <source>it is on a network disk (%1): a recording can stall there, and two computers can damage it</source>
        <translation>es liegt auf einem Netzlaufwerk (%1), wo eine Aufnahme stocken kann und zwei Rechner es beschädigen können</translation>
    </message>
</context>
<context>
    <name>project.open_again</name>
    <message>
        <source>open it again; if you were recording, find stray files (odograph check --adopt)</source>
        <translation>öffnen Sie es erneut; wenn Sie gerade aufgenommen haben, sehen Sie unter „Herrenlose Dateien suchen…“ nach</translation>
    </message>
</context>
<context>
    <name>project.open_elsewhere</name>
    <message>
        <source>it is open in another window</source>
        <translation>es ist in einem anderen Fenster geöffnet</translation>
    </message>
</context>
<context>
    <name>project.open_elsewhere_by</name>
    <message>
        <source>it is open in another window (%1)</source>
        <translation>es ist in einem anderen Fenster geöffnet (%1)</translation>
    </message>
</context>
<context>
    <name>project.open_or_move_that</name>
    <message>
        <source>open that project, or move it to a folder of its own with its videos</source>
        <translation>öffnen Sie jenes Projekt, oder verschieben Sie es mit seinen Videos in einen eigenen Ordner</translation>
    </message>
</context>
<context>
    <name>project.open_with_newer_odograph</name>
    <message>
        <source>open the project with a newer Odograph</source>
        <translation>öffnen Sie das Projekt mit einem neueren Odograph</translation>
    </message>
</context>
<context>
    <name>project.open_with_that_odograph</name>
    <message>
        <source>open it with that version, or update this one</source>
        <translation>öffnen Sie es mit jenem Odograph, oder aktualisieren Sie dieses</translation>
    </message>
</context>
<context>
    <name>project.other_database</name>
    <message>
        <source>it is a database of another program</source>
        <translation>es ist die Datenbank eines anderen Programms</translation>
    </message>
</context>
<context>
    <name>project.other_labels</name>
    <message>
        <source>the labels differ from those of the layout</source>
        <translation>die Bezeichnungen sind nicht die seinen</translation>
    </message>
</context>
<context>
    <name>project.other_tables</name>
    <message>
        <source>its tables are not those of a project</source>
        <translation>seine Tabellen sind nicht die eines Projekts</translation>
    </message>
</context>
<context>
    <name>project.others_calibration_chosen</name>
    <message>
        <source>calibration %1 was chosen for it but belongs to camera &apos;%2&apos;; its own newest one is used</source>
        <translation>für sie wurde Kalibrierung %1 gewählt, die zur Kamera &apos;%2&apos; gehört; verwendet wird ihre neueste eigene</translation>
    </message>
</context>
<context>
    <name>project.others_registration_chosen</name>
    <message>
        <source>registration %1 was chosen for it but belongs to camera &apos;%2&apos;; its own newest one is used</source>
        <translation>für sie wurde Einmessung %1 gewählt, die zur Kamera &apos;%2&apos; gehört; verwendet wird ihre neueste eigene</translation>
    </message>
</context>
<context>
    <name>project.overrides_changed</name>
    <message>
        <source>the manual overrides have changed since robot &apos;%1&apos; was analysed</source>
        <translation>die Entscheidungen von Hand haben sich seit der Auswertung des Roboters &apos;%1&apos; geändert</translation>
    </message>
</context>
<context>
    <name>project.path_cut_off</name>
    <message>
        <source>its reference path ends within a point</source>
        <translation>die Sollbahn endet mitten in einem Punkt</translation>
    </message>
</context>
<context>
    <name>project.path_leaves_folder</name>
    <message>
        <source>its relative path points outside the project&apos;s folder</source>
        <translation>der relative Pfad führt aus dem Ordner des Projekts hinaus</translation>
    </message>
</context>
<context>
    <name>project.picture_name</name>
    <message>
        <source>name of a calibration image</source>
        <translation>Name eines Kalibrierbilds</translation>
    </message>
</context>
<context>
    <name>project.picture_path</name>
    <message>
        <source>path of a calibration image</source>
        <translation>Pfad eines Kalibrierbilds</translation>
    </message>
</context>
<context>
    <name>project.point_by_hand</name>
    <message>
        <source>point set by hand</source>
        <translation>von Hand gesetzter Punkt</translation>
    </message>
</context>
<context>
    <name>project.point_without_sigma</name>
    <message>
        <source>it needs one position and a σ above 0 px</source>
        <translation>nötig sind eine Position und ein σ über 0 px</translation>
    </message>
</context>
<context>
    <name>project.position_no_number</name>
    <message>
        <source>a position or its covariance is not a number</source>
        <translation>ein Ort oder seine Kovarianz ist keine Zahl</translation>
    </message>
</context>
<context>
    <name>project.positions_changed</name>
    <message>
        <source>the stored positions of robot &apos;%1&apos; differ from those of its analysis</source>
        <translation>die Orte des Roboters &apos;%1&apos; sind nicht die, die seine Auswertung ergab</translation>
    </message>
</context>
<context>
    <name>project.project</name>
    <message>
        <source>project &apos;%1&apos;</source>
        <translation>Projekt &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.project_file_damaged</name>
    <message>
        <source>the project file is damaged</source>
        <translation>die Projektdatei ist beschädigt</translation>
    </message>
</context>
<context>
    <name>project.put_back_and_open</name>
    <message>
        <source>move the file back to its folder, and open the project again</source>
        <translation>legen Sie die Datei an ihren Ort zurück, und öffnen Sie das Projekt noch einmal</translation>
    </message>
</context>
<context>
    <name>project.put_back_and_retry</name>
    <message>
        <source>move it back to its folder and try again</source>
        <translation>legen Sie sie an ihren Platz zurück und versuchen Sie es noch einmal</translation>
    </message>
</context>
<context>
    <name>project.put_back_or_find</name>
    <message>
        <source>move the file back to its folder, or find it by its content with odograph check P.odo --find FOLDER or Find lost videos… in the window</source>
        <translation>legen Sie die Datei an ihren Platz zurück, oder suchen Sie sie anhand ihres Inhalts mit „Verlorene Videos suchen…“</translation>
    </message>
</context>
<context>
    <name>project.put_file_back</name>
    <message>
        <source>move the file back to its folder</source>
        <translation>legen Sie die Datei an ihren Platz zurück</translation>
    </message>
</context>
<context>
    <name>project.put_into_bin_first</name>
    <message>
        <source>move it to the bin first</source>
        <translation>legen Sie ihn zuerst in den Papierkorb</translation>
    </message>
</context>
<context>
    <name>project.put_original_back</name>
    <message>
        <source>move the original file back to its folder</source>
        <translation>legen Sie die ursprüngliche Datei wieder an ihren Platz</translation>
    </message>
</context>
<context>
    <name>project.range_changed</name>
    <message>
        <source>the trial&apos;s range has changed since robot &apos;%1&apos; was analysed</source>
        <translation>der Bereich des Versuchs wurde geändert, seit Roboter &apos;%1&apos; ausgewertet wurde</translation>
    </message>
</context>
<context>
    <name>project.range_sentence</name>
    <message>
        <source>Range: %1 to %2 of %3; all results are of this part.</source>
        <translation>Bereich: %1 bis %2 von %3; alle Ergebnisse gelten für diesen Teil.</translation>
    </message>
</context>
<context>
    <name>project.range_without_sample</name>
    <message>
        <source>no sample is within its range</source>
        <translation>in seinem Bereich ist kein Messpunkt</translation>
    </message>
</context>
<context>
    <name>project.raw_times_of</name>
    <message>
        <source>raw times of recording %1</source>
        <translation>Rohzeiten der Aufnahme %1</translation>
    </message>
</context>
<context>
    <name>project.reading</name>
    <message>
        <source>reading %1</source>
        <translation>gelesen wird: %1</translation>
    </message>
</context>
<context>
    <name>project.reading_failed</name>
    <message>
        <source>reading it failed (%1)</source>
        <translation>das Lesen misslang (%1)</translation>
    </message>
</context>
<context>
    <name>project.reason_is_blank</name>
    <message>
        <source>it is blank</source>
        <translation>er ist leer</translation>
    </message>
</context>
<context>
    <name>project.record_another</name>
    <message>
        <source>record another trial</source>
        <translation>nehmen Sie einen anderen Versuch auf</translation>
    </message>
</context>
<context>
    <name>project.recorded_into_now</name>
    <message>
        <source>a trial is being recorded into it now</source>
        <translation>gerade wird ein Versuch darin aufgenommen</translation>
    </message>
</context>
<context>
    <name>project.recording</name>
    <message>
        <source>recording</source>
        <translation>Aufnahme</translation>
    </message>
</context>
<context>
    <name>project.recording_at</name>
    <message>
        <source>recording &apos;%1&apos;</source>
        <translation>Aufnahme &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.recording_cut_off</name>
    <message>
        <source>its recording was cut off</source>
        <translation>seine Aufnahme wurde abgebrochen</translation>
    </message>
</context>
<context>
    <name>project.recording_ended</name>
    <message>
        <source>its recording has ended already</source>
        <translation>seine Aufnahme ist schon beendet</translation>
    </message>
</context>
<context>
    <name>project.recording_kept</name>
    <message>
        <source>its recording has ended, and is kept</source>
        <translation>die Aufnahme ist beendet und wird behalten</translation>
    </message>
</context>
<context>
    <name>project.recording_of_view</name>
    <message>
        <source>the recording of view &apos;%1&apos;</source>
        <translation>die Aufnahme der Sicht &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.recording_path</name>
    <message>
        <source>path of a recording</source>
        <translation>Pfad einer Aufnahme</translation>
    </message>
</context>
<context>
    <name>project.recording_without_file</name>
    <message>
        <source>it has no file</source>
        <translation>dazu fehlt die Datei</translation>
    </message>
</context>
<context>
    <name>project.recordings_changed</name>
    <message>
        <source>the recordings or their synchronisation have changed since robot &apos;%1&apos; was analysed</source>
        <translation>die Aufnahmen oder ihre Synchronisierung haben sich seit der Auswertung des Roboters &apos;%1&apos; geändert</translation>
    </message>
</context>
<context>
    <name>project.redo</name>
    <message>
        <source>redo</source>
        <translation>wiederholen</translation>
    </message>
</context>
<context>
    <name>project.redo_of</name>
    <message>
        <source>redo &apos;%1&apos;</source>
        <translation>&apos;%1&apos; wiederholen</translation>
    </message>
</context>
<context>
    <name>project.reference_too_far</name>
    <message>
        <source>its reference point is more than %1 from its centre</source>
        <translation>sein Bezugspunkt liegt weiter als %1 von seiner Mitte entfernt</translation>
    </message>
</context>
<context>
    <name>project.reference_without_heading</name>
    <message>
        <source>a reference point off its centre needs a heading, but a robot of changing height has none</source>
        <translation>ein Bezugspunkt neben der Mitte braucht eine Ausrichtung, die nicht bekannt ist, wo sich die Höhe ändert</translation>
    </message>
</context>
<context>
    <name>project.refers_to_nothing</name>
    <message>
        <source>it refers to something missing from the project, or a value is missing</source>
        <translation>es bezieht sich auf etwas, das nicht im Projekt ist, oder ein Wert fehlt</translation>
    </message>
</context>
<context>
    <name>project.registration_kept</name>
    <message>
        <source>the registration remains valid without it</source>
        <translation>die Einmessung bleibt auch ohne sie erhalten</translation>
    </message>
</context>
<context>
    <name>project.registration_of_project</name>
    <message>
        <source>registration %1 of the project</source>
        <translation>Einmessung %1 des Projekts</translation>
    </message>
</context>
<context>
    <name>project.registration_picture_of</name>
    <message>
        <source>the image of registration %1 of camera &apos;%2&apos;</source>
        <translation>das Bild der Einmessung %1 der Kamera &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>project.registration_picture_path</name>
    <message>
        <source>path of a registration&apos;s image</source>
        <translation>Pfad des Bilds einer Einmessung</translation>
    </message>
</context>
<context>
    <name>project.registrations_changed</name>
    <message>
        <source>the registrations have changed since robot &apos;%1&apos; was analysed</source>
        <translation>die Einmessungen haben sich seit der Auswertung des Roboters &apos;%1&apos; geändert</translation>
    </message>
</context>
<context>
    <name>project.remove_file_first</name>
    <message>
        <source>choose another name, or remove that file first</source>
        <translation>wählen Sie einen anderen Namen, oder entfernen Sie zuerst jene Datei</translation>
    </message>
</context>
<context>
    <name>project.remove_guidance</name>
    <message>
        <source>remove some first</source>
        <translation>entfernen Sie zuerst einige</translation>
    </message>
</context>
<context>
    <name>project.remove_variables</name>
    <message>
        <source>remove some of its variables</source>
        <translation>einige seiner Variablen entfernen</translation>
    </message>
</context>
<context>
    <name>project.rest_not_read</name>
    <message>
        <source>Odograph does not read the rest; shorten it here, or in the program that wrote the file</source>
        <translation>der Rest wird nicht gelesen; ändern Sie es hier oder dort, wo die Datei herkommt</translation>
    </message>
</context>
<context>
    <name>project.restore_file</name>
    <message>
        <source>restore it from a backup copy</source>
        <translation>stellen Sie es aus einer Sicherungskopie wieder her</translation>
    </message>
</context>
<context>
    <name>project.restore_or_register_again</name>
    <message>
        <source>restore the project from a backup copy, or register the camera again</source>
        <translation>stellen Sie das Projekt aus einer Sicherungskopie wieder her, oder messen Sie die Kamera neu ein</translation>
    </message>
</context>
<context>
    <name>project.restore_or_track_again</name>
    <message>
        <source>restore the project from a backup copy, or track the trial again</source>
        <translation>stellen Sie das Projekt aus einer Sicherungskopie wieder her, oder verfolgen Sie den Versuch noch einmal</translation>
    </message>
</context>
<context>
    <name>project.restore_project</name>
    <message>
        <source>restore the project from a backup copy</source>
        <translation>stellen Sie das Projekt aus einer Sicherungskopie wieder her</translation>
    </message>
</context>
<context>
    <name>project.results_changed</name>
    <message>
        <source>the stored metrics, spikes or settings of robot &apos;%1&apos; differ from those of its analysis</source>
        <translation>die Kennwerte, Ausreißer oder Einstellungen des Roboters &apos;%1&apos; sind nicht die, die seine Auswertung ergab</translation>
    </message>
</context>
<context>
    <name>project.robot_can_be_renamed</name>
    <message>
        <source>you can rename it</source>
        <translation>ein anderer Name ist möglich</translation>
    </message>
</context>
<context>
    <name>project.robot_drove</name>
    <message>
        <source>a trial uses it</source>
        <translation>er fuhr in einem Versuch</translation>
    </message>
</context>
<context>
    <name>project.robot_too_large</name>
    <message>
        <source>it is larger than %1</source>
        <translation>größer als %1</translation>
    </message>
</context>
<context>
    <name>project.robot_twice</name>
    <message>
        <source>it has a robot twice</source>
        <translation>ein Roboter gehört ihm zweimal</translation>
    </message>
</context>
<context>
    <name>project.row_refers_to_nothing</name>
    <message>
        <source>row %1 of &apos;%2&apos; refers to a missing row of &apos;%3&apos;</source>
        <translation>Zeile %1 von &apos;%2&apos; verweist auf eine Zeile von &apos;%3&apos;, die es nicht gibt</translation>
    </message>
</context>
<context>
    <name>project.run_check</name>
    <message>
        <source>run a check of the project</source>
        <translation>prüfen Sie das Projekt</translation>
    </message>
</context>
<context>
    <name>project.say_why</name>
    <message>
        <source>write why the results can be used</source>
        <translation>schreiben Sie, warum die Ergebnisse brauchbar sind</translation>
    </message>
</context>
<context>
    <name>project.school_ask_owner</name>
    <message>
        <source>nothing of it was taken over; ask for it to be published again</source>
        <translation>nichts davon wurde übernommen; lassen Sie es erneut veröffentlichen</translation>
    </message>
</context>
<context>
    <name>project.school_document</name>
    <message>
        <source>document of the hub</source>
        <translation>Dokument des Hubs</translation>
    </message>
</context>
<context>
    <name>project.school_field_wrong</name>
    <message>
        <source>what the hub has of it is damaged: field &apos;%1&apos;</source>
        <translation>was der Hub davon hat, ist beschädigt: Feld „%1“</translation>
    </message>
</context>
<context>
    <name>project.school_names_taken</name>
    <message>
        <source>every name for it is taken here</source>
        <translation>jeder Name dafür ist hier vergeben</translation>
    </message>
</context>
<context>
    <name>project.school_not_readable</name>
    <message>
        <source>what the hub has of it cannot be read</source>
        <translation>was der Hub davon hat, ist nicht lesbar</translation>
    </message>
</context>
<context>
    <name>project.school_publish_again</name>
    <message>
        <source>publish again</source>
        <translation>veröffentlichen Sie erneut</translation>
    </message>
</context>
<context>
    <name>project.school_recordings</name>
    <message>
        <source>recordings of a trial from the hub</source>
        <translation>Aufnahmen eines Versuchs vom Hub</translation>
    </message>
</context>
<context>
    <name>project.school_recordings_wrong</name>
    <message>
        <source>their description is damaged: field &apos;%1&apos;</source>
        <translation>ihre Beschreibung ist beschädigt: Feld „%1“</translation>
    </message>
</context>
<context>
    <name>project.school_rename_yours</name>
    <message>
        <source>rename the trials of that name in this project</source>
        <translation>benennen Sie die Versuche dieses Namens in diesem Projekt um</translation>
    </message>
</context>
<context>
    <name>project.school_row_gone</name>
    <message>
        <source>it is no longer in the project</source>
        <translation>es ist nicht mehr im Projekt</translation>
    </message>
</context>
<context>
    <name>project.search_area</name>
    <message>
        <source>search area</source>
        <translation>Suchbereich</translation>
    </message>
</context>
<context>
    <name>project.series_differ</name>
    <message>
        <source>its series differ in length</source>
        <translation>die Reihen sind verschieden lang</translation>
    </message>
</context>
<context>
    <name>project.series_missing</name>
    <message>
        <source>its series are missing</source>
        <translation>die Reihen fehlen</translation>
    </message>
</context>
<context>
    <name>project.series_of_other_kind</name>
    <message>
        <source>its stored series is not of the expected kind</source>
        <translation>die gespeicherte Reihe ist nicht von der erwarteten Art</translation>
    </message>
</context>
<context>
    <name>project.series_of_other_length</name>
    <message>
        <source>its stored series announces %1 rows but holds %2 bytes</source>
        <translation>die gespeicherte Reihe kündigt %1 Zeilen an, hat aber %2 Bytes</translation>
    </message>
</context>
<context>
    <name>project.size_not_above_0</name>
    <message>
        <source>its size is not above 0</source>
        <translation>seine Größe ist nicht größer als 0</translation>
    </message>
</context>
<context>
    <name>project.spike_without_sample</name>
    <message>
        <source>a spike refers to a missing sample</source>
        <translation>ein Ausreißer verweist auf einen Messpunkt, den es nicht gibt</translation>
    </message>
</context>
<context>
    <name>project.split_recording</name>
    <message>
        <source>split the recording into shorter ones</source>
        <translation>teilen Sie die Aufnahme in kürzere</translation>
    </message>
</context>
<context>
    <name>project.strays_unknown</name>
    <message>
        <source>cannot determine which files belong to no trial</source>
        <translation>welche Dateien zu keinem Versuch gehören, ist nicht zu sagen</translation>
    </message>
</context>
<context>
    <name>project.synchronisation_differs</name>
    <message>
        <source>its stored synchronisation differs from that of its second view</source>
        <translation>die gespeicherte Synchronisierung ist nicht die seiner zweiten Sicht</translation>
    </message>
</context>
<context>
    <name>project.synchronisation_of_one_view</name>
    <message>
        <source>a synchronisation is stored, but it has no second view</source>
        <translation>eine Synchronisierung ist gespeichert, aber er hat keine zweite Sicht</translation>
    </message>
</context>
<context>
    <name>project.take_later_back</name>
    <message>
        <source>undo the later change first, or leave this one</source>
        <translation>nehmen Sie zuerst die spätere Änderung zurück, oder lassen Sie es</translation>
    </message>
</context>
<context>
    <name>project.task_changed</name>
    <message>
        <source>the task has changed since robot &apos;%1&apos; was analysed</source>
        <translation>die Aufgabe hat sich seit der Auswertung des Roboters &apos;%1&apos; geändert</translation>
    </message>
</context>
<context>
    <name>project.task_has_trial</name>
    <message>
        <source>a trial uses it</source>
        <translation>ein Versuch hat sie</translation>
    </message>
</context>
<context>
    <name>project.task_has_trials</name>
    <message>
        <source>%1 trials use it</source>
        <translation>%1 Versuche haben sie</translation>
    </message>
</context>
<context>
    <name>project.team_has_trial</name>
    <message>
        <source>it has a trial</source>
        <translation>ein Versuch gehört ihm</translation>
    </message>
</context>
<context>
    <name>project.team_has_trials</name>
    <message>
        <source>it has %1 trials</source>
        <translation>%1 Versuche gehören ihm</translation>
    </message>
</context>
<context>
    <name>project.texts_too_long</name>
    <message>
        <source>%1: texts of more than %2 characters: %3</source>
        <translation>%1: Texte von mehr als %2 Zeichen: %3</translation>
    </message>
</context>
<context>
    <name>project.times_do_not_rise</name>
    <message>
        <source>its times do not increase</source>
        <translation>die Zeiten steigen nicht</translation>
    </message>
</context>
<context>
    <name>project.title</name>
    <message>
        <source>title of the project</source>
        <translation>Titel des Projekts</translation>
    </message>
</context>
<context>
    <name>project.too_many_markers</name>
    <message>
        <source>it has more than %1 markers</source>
        <translation>er hat mehr als %1 Marken</translation>
    </message>
</context>
<context>
    <name>project.too_many_members</name>
    <message>
        <source>it has more than %1 members</source>
        <translation>es hat mehr als %1 Mitglieder</translation>
    </message>
</context>
<context>
    <name>project.too_many_samples</name>
    <message>
        <source>it has more than %1 samples</source>
        <translation>mehr als %1 Messpunkte</translation>
    </message>
</context>
<context>
    <name>project.too_many_variables</name>
    <message>
        <source>a trial has %1 variables at most</source>
        <translation>ein Versuch hat höchstens %1 Variablen</translation>
    </message>
</context>
<context>
    <name>project.track</name>
    <message>
        <source>track &apos;%1&apos;</source>
        <translation>Spur &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.track_again</name>
    <message>
        <source>track the trial again</source>
        <translation>verfolgen Sie den Versuch noch einmal</translation>
    </message>
</context>
<context>
    <name>project.track_kept</name>
    <message>
        <source>the measured track remains valid without it</source>
        <translation>die gemessene Spur bleibt auch ohne sie erhalten</translation>
    </message>
</context>
<context>
    <name>project.track_reading</name>
    <message>
        <source>reading of a track</source>
        <translation>Lesart einer Spur</translation>
    </message>
</context>
<context>
    <name>project.trial_notes</name>
    <message>
        <source>notes of a trial</source>
        <translation>Notizen eines Versuchs</translation>
    </message>
</context>
<context>
    <name>project.trial_of_project</name>
    <message>
        <source>trial %1 of the project</source>
        <translation>Versuch %1 des Projekts</translation>
    </message>
</context>
<context>
    <name>project.truth</name>
    <message>
        <source>truth of a trial</source>
        <translation>Wahrheit eines Versuchs</translation>
    </message>
</context>
<context>
    <name>project.truth_of_trial</name>
    <message>
        <source>truth of trial %1</source>
        <translation>Wahrheit des Versuchs %1</translation>
    </message>
</context>
<context>
    <name>project.try_again</name>
    <message>
        <source>try again</source>
        <translation>versuchen Sie es noch einmal</translation>
    </message>
</context>
<context>
    <name>project.try_change_again</name>
    <message>
        <source>try the whole change again</source>
        <translation>versuchen Sie die ganze Änderung noch einmal</translation>
    </message>
</context>
<context>
    <name>project.type_name_anew</name>
    <message>
        <source>type the name again</source>
        <translation>tippen Sie den Namen neu</translation>
    </message>
</context>
<context>
    <name>project.type_text_anew</name>
    <message>
        <source>type the text again</source>
        <translation>tippen Sie den Text neu</translation>
    </message>
</context>
<context>
    <name>project.undo</name>
    <message>
        <source>undo</source>
        <translation>rückgängig machen</translation>
    </message>
</context>
<context>
    <name>project.undo_of</name>
    <message>
        <source>undo &apos;%1&apos;</source>
        <translation>&apos;%1&apos; rückgängig machen</translation>
    </message>
</context>
<context>
    <name>project.undo_something_first</name>
    <message>
        <source>undo something first</source>
        <translation>nehmen Sie zuerst etwas zurück</translation>
    </message>
</context>
<context>
    <name>project.unknown_series_layout</name>
    <message>
        <source>its stored series has the unknown layout %1</source>
        <translation>die gespeicherte Reihe hat den unbekannten Aufbau %1</translation>
    </message>
</context>
<context>
    <name>project.unknown_setting</name>
    <message>
        <source>its stored setting &apos;%1&apos; is unknown</source>
        <translation>die gespeicherte Einstellung &apos;%1&apos; ist unbekannt</translation>
    </message>
</context>
<context>
    <name>project.use_at_most</name>
    <message>
        <source>use at most %1</source>
        <translation>verwenden Sie höchstens %1</translation>
    </message>
</context>
<context>
    <name>project.use_one_line</name>
    <message>
        <source>use a name of one line</source>
        <translation>verwenden Sie einen einzeiligen Namen</translation>
    </message>
</context>
<context>
    <name>project.value_too_large</name>
    <message>
        <source>a value is too large to store</source>
        <translation>ein Wert ist zu groß zum Speichern</translation>
    </message>
</context>
<context>
    <name>project.verdict</name>
    <message>
        <source>verdict on a trial</source>
        <translation>Urteil über einen Versuch</translation>
    </message>
</context>
<context>
    <name>project.views_differ</name>
    <message>
        <source>views and registrations differ in number</source>
        <translation>Sichten und Einmessungen sind verschieden viele</translation>
    </message>
</context>
<context>
    <name>project.wait_until_ended</name>
    <message>
        <source>wait until that has ended</source>
        <translation>warten Sie, bis das beendet ist</translation>
    </message>
</context>
<context>
    <name>project.writing_failed</name>
    <message>
        <source>writing it failed (%1)</source>
        <translation>das Schreiben misslang (%1)</translation>
    </message>
</context>
<context>
    <name>project.written_over</name>
    <message>
        <source>another program wrote over its file while it was open; nothing more was stored</source>
        <translation>ein anderes Programm hat seine Datei überschrieben, während es offen war; danach wurde nichts mehr gespeichert</translation>
    </message>
</context>
<context>
    <name>project.zone_cut_off</name>
    <message>
        <source>its zone &apos;%1&apos; ends within a point</source>
        <translation>die Zone &apos;%1&apos; endet mitten in einem Punkt</translation>
    </message>
</context>
<context>
    <name>school.address</name>
    <message>
        <source>address of the school hub</source>
        <translation>Adresse des Schul-Hubs</translation>
    </message>
</context>
<context>
    <name>school.address_characters</name>
    <message>
        <source>it holds a quotation mark, a backslash, a semicolon or a control character</source>
        <translation>sie enthält ein Anführungszeichen, einen umgekehrten Schrägstrich, ein Semikolon oder ein Steuerzeichen</translation>
    </message>
</context>
<context>
    <name>school.address_form</name>
    <message>
        <source>give it as postgresql://user@host/database</source>
        <translation>geben Sie sie als postgresql://user@host/database an</translation>
    </message>
</context>
<context>
    <name>school.ask_administrator</name>
    <message>
        <source>ask the hub&apos;s administrator for the role that may</source>
        <translation>bitten Sie den Administrator des Hubs um die passende Rolle</translation>
    </message>
</context>
<context>
    <name>school.check_connection</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network; what is recorded meanwhile is sent later</source>
        <translation>prüfen Sie die Adresse, die Anmeldung in ~/.pgpass und das Netzwerk; was inzwischen aufgezeichnet wird, wird später gesendet</translation>
    </message>
</context>
<context>
    <name>school.check_server</name>
    <message>
        <source>have the hub&apos;s administrator look at the server</source>
        <translation>bitten Sie den Administrator des Hubs, den Server zu prüfen</translation>
    </message>
</context>
<context>
    <name>school.connect_first</name>
    <message>
        <source>connect it with odograph school connect P.odo postgresql://user@host/database</source>
        <translation>verbinden Sie es zuerst</translation>
    </message>
</context>
<context>
    <name>school.connect_with_media</name>
    <message>
        <source>connect it again with --media FOLDER</source>
        <translation>verbinden Sie es erneut mit einem Medienordner</translation>
    </message>
</context>
<context>
    <name>school.grant_role</name>
    <message>
        <source>have the hub&apos;s administrator grant it one: GRANT bench TO login</source>
        <translation>lassen Sie ihr vom Administrator des Hubs eine geben: GRANT bench TO login</translation>
    </message>
</context>
<context>
    <name>school.hub_subject</name>
    <message>
        <source>school hub &apos;%1&apos;</source>
        <translation>Schul-Hub „%1“</translation>
    </message>
</context>
<context>
    <name>school.install_driver</name>
    <message>
        <source>install the package libqt6sql6-psql</source>
        <translation>installieren Sie das Paket libqt6sql6-psql</translation>
    </message>
</context>
<context>
    <name>school.media</name>
    <message>
        <source>media folder of the school</source>
        <translation>Medienordner der Schule</translation>
    </message>
</context>
<context>
    <name>school.never_answers</name>
    <message>
        <source>the server takes connections and answers none</source>
        <translation>der Server nimmt Verbindungen an und beantwortet keine</translation>
    </message>
</context>
<context>
    <name>school.newer_hub</name>
    <message>
        <source>its schema has version %1, and this Odograph knows up to %2</source>
        <translation>sein Schema hat Version %1, dieses Odograph kennt bis %2</translation>
    </message>
</context>
<context>
    <name>school.no_database</name>
    <message>
        <source>it names no database</source>
        <translation>sie nennt keine Datenbank</translation>
    </message>
</context>
<context>
    <name>school.no_driver</name>
    <message>
        <source>this computer has no driver for PostgreSQL</source>
        <translation>dieser Rechner hat keinen Treiber für PostgreSQL</translation>
    </message>
</context>
<context>
    <name>school.no_hub</name>
    <message>
        <source>the database has no hub</source>
        <translation>die Datenbank hat keinen Hub</translation>
    </message>
</context>
<context>
    <name>school.no_media</name>
    <message>
        <source>the project is connected without one</source>
        <translation>das Projekt ist ohne einen verbunden</translation>
    </message>
</context>
<context>
    <name>school.no_role</name>
    <message>
        <source>the login has none of the roles teacher, bench and viewer</source>
        <translation>die Anmeldung hat keine der Rollen teacher, bench und viewer</translation>
    </message>
</context>
<context>
    <name>school.no_url</name>
    <message>
        <source>it is no address of a PostgreSQL database</source>
        <translation>sie ist keine Adresse einer PostgreSQL-Datenbank</translation>
    </message>
</context>
<context>
    <name>school.not_allowed</name>
    <message>
        <source>the login may not do that (%1)</source>
        <translation>die Anmeldung darf das nicht (%1)</translation>
    </message>
</context>
<context>
    <name>school.not_connected</name>
    <message>
        <source>the project is not connected to one</source>
        <translation>das Projekt ist mit keinem verbunden</translation>
    </message>
</context>
<context>
    <name>school.older_hub</name>
    <message>
        <source>its schema has version %1, and this Odograph needs %2</source>
        <translation>sein Schema hat Version %1, dieses Odograph braucht %2</translation>
    </message>
</context>
<context>
    <name>school.option_unknown</name>
    <message>
        <source>its option &apos;%1&apos; is not known</source>
        <translation>ihre Option „%1“ ist unbekannt</translation>
    </message>
</context>
<context>
    <name>school.options_known</name>
    <message>
        <source>use sslmode, sslrootcert, host or port</source>
        <translation>verwenden Sie sslmode, sslrootcert, host oder port</translation>
    </message>
</context>
<context>
    <name>school.password_elsewhere</name>
    <message>
        <source>leave it out, and put the password into ~/.pgpass or PGPASSWORD</source>
        <translation>lassen Sie es weg und legen Sie das Passwort in ~/.pgpass oder PGPASSWORD ab</translation>
    </message>
</context>
<context>
    <name>school.password_in_url</name>
    <message>
        <source>it holds a password, which others could read</source>
        <translation>sie enthält ein Passwort, das andere lesen könnten</translation>
    </message>
</context>
<context>
    <name>school.password_place</name>
    <message>
        <source>put the correct one into ~/.pgpass or PGPASSWORD</source>
        <translation>geben Sie es hier ein, oder legen Sie es in ~/.pgpass ab</translation>
    </message>
</context>
<context>
    <name>school.password_refused</name>
    <message>
        <source>the server does not accept this login with this password</source>
        <translation>der Server nimmt diese Anmeldung mit diesem Passwort nicht an</translation>
    </message>
</context>
<context>
    <name>school.password_wanted</name>
    <message>
        <source>the server asks for the password of the login</source>
        <translation>der Server verlangt das Passwort der Anmeldung</translation>
    </message>
</context>
<context>
    <name>school.publish_later</name>
    <message>
        <source>try again later; what was not sent yet is kept</source>
        <translation>versuchen Sie es später erneut; was noch nicht gesendet ist, bleibt erhalten</translation>
    </message>
</context>
<context>
    <name>school.publishing</name>
    <message>
        <source>publishing</source>
        <translation>wird veröffentlicht</translation>
    </message>
</context>
<context>
    <name>school.receiving</name>
    <message>
        <source>receiving %1</source>
        <translation>empfängt %1</translation>
    </message>
</context>
<context>
    <name>school.recording_changed</name>
    <message>
        <source>the recording &apos;%1&apos; is missing or has changed, and was left out</source>
        <translation>die Aufnahme „%1“ fehlt oder wurde geändert und wurde ausgelassen</translation>
    </message>
</context>
<context>
    <name>school.recording_elsewhere</name>
    <message>
        <source>trial &apos;%1&apos;, view &apos;%2&apos;: its recording is not in the media folder; bench &apos;%3&apos; has it as &apos;%4&apos;</source>
        <translation>Versuch „%1“, Sicht „%2“: Die Aufnahme ist nicht im Medienordner; Messplatz „%3“ hat sie als „%4“</translation>
    </message>
</context>
<context>
    <name>school.report_to_administrator</name>
    <message>
        <source>show this to the hub&apos;s administrator</source>
        <translation>zeigen Sie dies dem Administrator des Hubs</translation>
    </message>
</context>
<context>
    <name>school.run_init</name>
    <message>
        <source>have its administrator run odograph school init</source>
        <translation>lassen Sie ihn vom Administrator einrichten</translation>
    </message>
</context>
<context>
    <name>school.server_away</name>
    <message>
        <source>the server is away; trying again</source>
        <translation>der Server ist nicht erreichbar; neuer Versuch</translation>
    </message>
</context>
<context>
    <name>school.silent</name>
    <message>
        <source>the server does not answer</source>
        <translation>der Server antwortet nicht</translation>
    </message>
</context>
<context>
    <name>school.sslmode_choices</name>
    <message>
        <source>use disable, allow, prefer, require, verify-ca or verify-full</source>
        <translation>verwenden Sie disable, allow, prefer, require, verify-ca oder verify-full</translation>
    </message>
</context>
<context>
    <name>school.sslmode_unknown</name>
    <message>
        <source>sslmode &apos;%1&apos; is not known</source>
        <translation>sslmode „%1“ ist unbekannt</translation>
    </message>
</context>
<context>
    <name>school.subject</name>
    <message>
        <source>school hub</source>
        <translation>Schul-Hub</translation>
    </message>
</context>
<context>
    <name>school.update_program</name>
    <message>
        <source>update Odograph</source>
        <translation>aktualisieren Sie Odograph</translation>
    </message>
</context>
<context>
    <name>school.waiting</name>
    <message>
        <source>waiting for the server</source>
        <translation>wartet auf den Server</translation>
    </message>
</context>
<context>
    <name>school.went_away</name>
    <message>
        <source>the connection was lost (%1)</source>
        <translation>die Verbindung ging verloren (%1)</translation>
    </message>
</context>
<context>
    <name>simulation.cannot_render</name>
    <message>
        <source>cannot render %1</source>
        <translation>%1 kann nicht gerechnet werden</translation>
    </message>
</context>
<context>
    <name>simulation.lengthen_scene</name>
    <message>
        <source>give the scene a longer duration or start the camera earlier</source>
        <translation>lassen Sie die Szene länger dauern, oder starten Sie die Kamera früher</translation>
    </message>
</context>
<context>
    <name>simulation.no_frame</name>
    <message>
        <source>camera %1 takes no frame during the scene</source>
        <translation>Kamera %1 nimmt kein Bild auf, solange die Szene dauert</translation>
    </message>
</context>
<context>
    <name>simulation.rendering</name>
    <message>
        <source>rendering %1</source>
        <translation>Rechnen von %1</translation>
    </message>
</context>
<context>
    <name>sync.cost</name>
    <message>
        <source>View %1: its times are known to ±%2, which is ±%3 at the top speed of %4</source>
        <translation>Sicht %1: ihre Zeiten sind auf ±%2 bekannt, das sind ±%3 bei der Höchstgeschwindigkeit von %4</translation>
    </message>
</context>
<context>
    <name>sync.cost_of_error</name>
    <message>
        <source>View %1: nothing has measured its time offset; an error of %2 would shift the robot by %3 at the top speed of %4</source>
        <translation>Sicht %1: ihr Zeitversatz wurde nicht gemessen; ein Fehler von %2 würde den Roboter bei der Höchstgeschwindigkeit von %4 um %3 verschieben</translation>
    </message>
</context>
<context>
    <name>sync.drift</name>
    <message>
        <source>Its clock runs %1 ±%2 faster than the first view&apos;s</source>
        <translation>Ihre Uhr geht %1 ±%2 schneller als die der ersten Sicht</translation>
    </message>
</context>
<context>
    <name>sync.known_to</name>
    <message>
        <source>View %1: its times are known to ±%2</source>
        <translation>Sicht %1: ihre Zeiten sind auf ±%2 bekannt</translation>
    </message>
</context>
<context>
    <name>sync.no_residual</name>
    <message>
        <source>The views&apos; disagreement does not grow with the speed: a remaining time error is at most %1, or %2 at the top speed</source>
        <translation>Der Abstand der Sichten wächst nicht mit der Geschwindigkeit: ein übriger Zeitfehler ist höchstens %1, das sind %2 bei der Höchstgeschwindigkeit</translation>
    </message>
</context>
<context>
    <name>sync.not_measured</name>
    <message>
        <source>View %1: nothing has measured its time offset</source>
        <translation>Sicht %1: ihr Zeitversatz wurde nicht gemessen</translation>
    </message>
</context>
<context>
    <name>sync.pairing</name>
    <message>
        <source>Its frames are %1 on average and at most %2 from the first view&apos;s; positions are interpolated to the same times</source>
        <translation>Ihre Bilder sind im Mittel %1 und höchstens %2 von denen der ersten Sicht entfernt; Positionen werden auf dieselben Zeiten interpoliert</translation>
    </message>
</context>
<context>
    <name>sync.residual</name>
    <message>
        <source>The views disagree the more the faster the robot is, as a time error of %1 ±%2 would make them: %3 at the top speed</source>
        <translation>Die Sichten weichen umso mehr voneinander ab, je schneller der Roboter ist, wie bei einem Zeitfehler von %1 ±%2: %3 bei der Höchstgeschwindigkeit</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_flash</name>
    <message>
        <source>%1 by the flash of light</source>
        <translation>%1 aus dem Lichtblitz</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_motion</name>
    <message>
        <source>%1 by the motion</source>
        <translation>%1 aus der Bewegung</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_sound</name>
    <message>
        <source>%1 by the sound</source>
        <translation>%1 aus dem Ton</translation>
    </message>
</context>
<context>
    <name>synchronisation.clap_twice</name>
    <message>
        <source>clap twice near the middle of the floor while both cameras record, or give --sync SECONDS</source>
        <translation>klatschen Sie zweimal nahe der Mitte des Bodens, während beide Kameras aufnehmen, oder geben Sie den Versatz an</translation>
    </message>
</context>
<context>
    <name>synchronisation.clocks_ambiguous</name>
    <message>
        <source>several time offsets, pauses or missing frames explain the views&apos; tracks about equally well</source>
        <translation>mehrere Zeitversätze, Pausen oder fehlende Bilder erklären die Bahnen der Sichten etwa gleich gut</translation>
    </message>
</context>
<context>
    <name>synchronisation.different_runs</name>
    <message>
        <source>the views&apos; tracks match at no time offset, frame rate or pause tried, so the videos may be of different runs</source>
        <translation>die Bahnen der Ansichten passen bei keinem der probierten Zeitversätze, Bildraten und Pausen zusammen; die Videos zeigen vielleicht verschiedene Fahrten</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_disagrees</name>
    <message>
        <source>the motion gives a time offset of %1, the flash of light gives %2; the motion was used</source>
        <translation>die Bewegung ergibt einen Versatz von %1, der genommen wurde, und der Lichtblitz %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_lights</name>
    <message>
        <source>flash the room lights once while both cameras record, or give --sync SECONDS</source>
        <translation>lassen Sie einmal das Raumlicht aufblitzen, während beide Kameras aufnehmen, oder geben Sie den Versatz an</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_or_clap</name>
    <message>
        <source>flash the room lights or clap twice while both cameras record, or give --sync SECONDS</source>
        <translation>lassen Sie das Raumlicht aufblitzen oder klatschen Sie zweimal, während beide Kameras aufnehmen, oder geben Sie den Versatz an</translation>
    </message>
</context>
<context>
    <name>synchronisation.flashes_fit_alike</name>
    <message>
        <source>the flashes of light fit equally well at time offsets of %1 and %2</source>
        <translation>die Lichtblitze passen bei einem Versatz von %1 und von %2 gleich gut</translation>
    </message>
</context>
<context>
    <name>synchronisation.from_flash</name>
    <message>
        <source>measured by a flash of light to only ±%1, because %2</source>
        <translation>aus einem Lichtblitz, nur auf %1, denn %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.from_sound</name>
    <message>
        <source>measured by the sound to only ±%1, because %2</source>
        <translation>aus dem Ton, nur auf ±%1, denn %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.light_flickers</name>
    <message>
        <source>the light flickers</source>
        <translation>das Licht flackert</translation>
    </message>
</context>
<context>
    <name>synchronisation.motion_repeats</name>
    <message>
        <source>the motion repeats itself</source>
        <translation>die Bewegung wiederholt sich</translation>
    </message>
</context>
<context>
    <name>synchronisation.motion_too_even</name>
    <message>
        <source>the robot turned and changed its speed too little to give the time offset</source>
        <translation>der Roboter bog zu wenig ab und änderte seine Geschwindigkeit zu wenig, um den Zeitversatz zu bestimmen</translation>
    </message>
</context>
<context>
    <name>synchronisation.neither_tells</name>
    <message>
        <source>%1, and %2</source>
        <translation>%1, und %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.no_flash</name>
    <message>
        <source>neither view shows a flash of light</source>
        <translation>keine der Sichten zeigt einen Lichtblitz</translation>
    </message>
</context>
<context>
    <name>synchronisation.no_loud_sound</name>
    <message>
        <source>no clap, knock or whistle is heard clearly in both clips</source>
        <translation>kein Klatschen, Klopfen oder Pfiff hebt sich im Ton beider Clips ab</translation>
    </message>
</context>
<context>
    <name>synchronisation.none_tells</name>
    <message>
        <source>%1, %2, and %3</source>
        <translation>%1, %2, und %3</translation>
    </message>
</context>
<context>
    <name>synchronisation.of_clips</name>
    <message>
        <source>synchronisation of the clips</source>
        <translation>Synchronisierung der Videos</translation>
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
        <translation>ein Versatz von %1 und von %2 passt gleich gut</translation>
    </message>
</context>
<context>
    <name>synchronisation.one_flash</name>
    <message>
        <source>only one of the views shows a flash of light</source>
        <translation>nur eine der Sichten zeigt einen Lichtblitz</translation>
    </message>
</context>
<context>
    <name>synchronisation.other_flashes</name>
    <message>
        <source>the flashes of light in the views do not match</source>
        <translation>die Lichtblitze der Sichten gehören nicht zusammen</translation>
    </message>
</context>
<context>
    <name>synchronisation.other_sounds</name>
    <message>
        <source>the loud sounds of the clips do not match</source>
        <translation>die lauten Geräusche der Clips gehören nicht zusammen</translation>
    </message>
</context>
<context>
    <name>synchronisation.robot_ran_straight</name>
    <message>
        <source>the robot ran straight at constant speed, so every time offset fits</source>
        <translation>der Roboter fuhr mit gleichbleibender Geschwindigkeit geradeaus, sodass jeder Zeitversatz passt</translation>
    </message>
</context>
<context>
    <name>synchronisation.robot_rested</name>
    <message>
        <source>the robot stood still, so every time offset fits</source>
        <translation>der Roboter stand still, sodass jeder Zeitversatz passt</translation>
    </message>
</context>
<context>
    <name>synchronisation.robots_disagree</name>
    <message>
        <source>robot %1 gives a time offset of %2, robot %3 gives %4; the second was used</source>
        <translation>Roboter %1 ergibt einen Versatz von %2, Roboter %3 %4, der genommen wurde</translation>
    </message>
</context>
<context>
    <name>synchronisation.seldom_seen</name>
    <message>
        <source>one view saw the robot in fewer than %1 frames</source>
        <translation>eine Sicht sah den Roboter in weniger als %1 Bildern</translation>
    </message>
</context>
<context>
    <name>synchronisation.seldom_together</name>
    <message>
        <source>the views rarely saw the robot at the same time</source>
        <translation>die Sichten sahen den Roboter fast nie zugleich</translation>
    </message>
</context>
<context>
    <name>synchronisation.short_overlap</name>
    <message>
        <source>the views seem to have only %1 in common, which is too short to be sure</source>
        <translation>die Ansichten scheinen nur %1 gemeinsam zu haben, zu wenig, um sicher zu sein</translation>
    </message>
</context>
<context>
    <name>synchronisation.sound_beats</name>
    <message>
        <source>the sound is full of beats that are alike, as in music</source>
        <translation>der Ton ist voll gleicher Schläge, wie in Musik</translation>
    </message>
</context>
<context>
    <name>synchronisation.sounds_fit_alike</name>
    <message>
        <source>the sounds of the clips fit equally well at time offsets of %1 and %2</source>
        <translation>der Ton der Clips passt bei einem Versatz von %1 und von %2 gleich gut</translation>
    </message>
</context>
<context>
    <name>synchronisation.views_distorted</name>
    <message>
        <source>the views show the same run, but with another size or direction: a camera has moved since its registration, or the videos are exchanged</source>
        <translation>die Ansichten zeigen dieselbe Fahrt, aber in anderer Größe oder Richtung: Eine Kamera wurde seit ihrer Registrierung bewegt, oder die Videos sind vertauscht</translation>
    </message>
</context>
<context>
    <name>synchronisation.ways_disagree</name>
    <message>
        <source>the time offsets found disagree: %1; the first was used</source>
        <translation>die gefundenen Versätze widersprechen sich: %1; der erste wurde genommen</translation>
    </message>
</context>
<context>
    <name>tracking.add_robot</name>
    <message>
        <source>add a robot with its colour first</source>
        <translation>fügen Sie zuerst einen Roboter mit seiner Farbe hinzu</translation>
    </message>
</context>
<context>
    <name>tracking.add_without_colour</name>
    <message>
        <source>add the robot without a colour; background subtraction then finds it</source>
        <translation>fügen Sie den Roboter ohne Farbe hinzu, dann wird er daran erkannt, worin er sich vom Boden unterscheidet</translation>
    </message>
</context>
<context>
    <name>tracking.box_is_grey</name>
    <message>
        <source>the robot in it is grey, black or white</source>
        <translation>was sich vom Boden unterscheidet, ist grau, schwarz oder weiß</translation>
    </message>
</context>
<context>
    <name>tracking.box_leaves_nothing</name>
    <message>
        <source>the box leaves no floor around it to compare with</source>
        <translation>der Rahmen lässt nichts vom Boden zum Vergleichen übrig</translation>
    </message>
</context>
<context>
    <name>tracking.box_too_small</name>
    <message>
        <source>the box is too small or outside the image</source>
        <translation>der Rahmen ist zu klein oder außerhalb des Bildes</translation>
    </message>
</context>
<context>
    <name>tracking.box_without_colour</name>
    <message>
        <source>it contains no colour that differs from the floor around it</source>
        <translation>er enthält keine Farbe, die sich vom Boden ringsum unterscheidet</translation>
    </message>
</context>
<context>
    <name>tracking.cannot_track</name>
    <message>
        <source>Cannot track</source>
        <translation>Verfolgen nicht möglich</translation>
    </message>
</context>
<context>
    <name>tracking.cannot_track_robot</name>
    <message>
        <source>Cannot track robot %1</source>
        <translation>Roboter %1 kann nicht verfolgt werden</translation>
    </message>
</context>
<context>
    <name>tracking.colour_in_box</name>
    <message>
        <source>colour in the box</source>
        <translation>Farbe im Rahmen</translation>
    </message>
</context>
<context>
    <name>tracking.colour_is_grey</name>
    <message>
        <source>its colour %1 is grey, and tracking by colour needs a hue that differs from the floor</source>
        <translation>seine Farbe %1 ist grau, und nur der Farbton unterscheidet einen Roboter vom Boden</translation>
    </message>
</context>
<context>
    <name>tracking.draw_box_closely</name>
    <message>
        <source>draw it closely round the robot</source>
        <translation>ziehen Sie ihn eng um den Roboter</translation>
    </message>
</context>
<context>
    <name>tracking.draw_box_larger</name>
    <message>
        <source>draw it round the robot, at least 8 pixels wide and high</source>
        <translation>ziehen Sie ihn um den Roboter, mindestens 8 Pixel breit und hoch</translation>
    </message>
</context>
<context>
    <name>tracking.no_robot_given</name>
    <message>
        <source>no robot is given</source>
        <translation>es ist kein Roboter angegeben</translation>
    </message>
</context>
<context>
    <name>tracking.put_plate_on_it</name>
    <message>
        <source>draw it closely round the robot, or put a plate of another colour on it</source>
        <translation>ziehen Sie ihn eng um den Roboter, oder setzen Sie eine Platte anderer Farbe darauf</translation>
    </message>
</context>
<context>
    <name>tracking.tell_no_colour</name>
    <message>
        <source>set no colour; background subtraction then finds it</source>
        <translation>geben Sie keine Farbe an, dann wird er daran erkannt, worin er sich vom Boden unterscheidet</translation>
    </message>
</context>
<context>
    <name>trajectory.add_view</name>
    <message>
        <source>add a second view, or set one height for the robot</source>
        <translation>fügen Sie eine zweite Sicht hinzu, oder geben Sie dem Roboter eine Höhe</translation>
    </message>
</context>
<context>
    <name>trajectory.analysing_position</name>
    <message>
        <source>analysing position %1</source>
        <translation>Position %1 wird ausgewertet</translation>
    </message>
</context>
<context>
    <name>trajectory.camera_not_registered</name>
    <message>
        <source>camera %1 is not registered to the floor</source>
        <translation>Kamera %1 ist nicht eingemessen</translation>
    </message>
</context>
<context>
    <name>trajectory.cameras_not_registered</name>
    <message>
        <source>cameras %1 are not registered to the floor</source>
        <translation>die Kameras %1 sind nicht eingemessen</translation>
    </message>
</context>
<context>
    <name>trajectory.centre_reference</name>
    <message>
        <source>set its reference point to 0,0 and track again</source>
        <translation>geben Sie ihm den Bezugspunkt 0,0 und verfolgen Sie ihn erneut</translation>
    </message>
</context>
<context>
    <name>trajectory.check_robot_and_light</name>
    <message>
        <source>check that the robot moves in the video, that its colour, if set, matches the video, and that the light is sufficient</source>
        <translation>prüfen Sie, ob sich der Roboter in den Bildern bewegt, ob eine angegebene Farbe die dort sichtbare ist und ob das Licht ausreicht</translation>
    </message>
</context>
<context>
    <name>trajectory.choose_longer_track</name>
    <message>
        <source>choose a track with more positions</source>
        <translation>wählen Sie eine Spur mit mehr Orten</translation>
    </message>
</context>
<context>
    <name>trajectory.choose_longer_video</name>
    <message>
        <source>choose a longer video, or check the robot&apos;s colour and the light</source>
        <translation>wählen Sie ein längeres Video, oder prüfen Sie die Farbe des Roboters und das Licht</translation>
    </message>
</context>
<context>
    <name>trajectory.cut_by_edge</name>
    <message>
        <source>cut by the frame&apos;s edge</source>
        <translation>vom Bildrand abgeschnitten</translation>
    </message>
</context>
<context>
    <name>trajectory.cut_by_frames_edge</name>
    <message>
        <source>cut by the frame&apos;s edge in view %1</source>
        <translation>vom Bildrand abgeschnitten in Sicht %1</translation>
    </message>
</context>
<context>
    <name>trajectory.faster_than_limit</name>
    <message>
        <source>speed above the limit</source>
        <translation>schneller als der Grenzwert</translation>
    </message>
</context>
<context>
    <name>trajectory.figures_of_seen</name>
    <message>
        <source>the metrics cover only the measured part</source>
        <translation>die Kennwerte gelten für den Teil, der zu sehen war</translation>
    </message>
</context>
<context>
    <name>trajectory.frames_that_tell</name>
    <message>
        <source>only %2 of %1 frames give a usable position</source>
        <translation>von %1 Bildern ergeben %2 einen brauchbaren Ort</translation>
    </message>
</context>
<context>
    <name>trajectory.harder_than_limit</name>
    <message>
        <source>acceleration above the limit</source>
        <translation>stärker beschleunigt als der Grenzwert</translation>
    </message>
</context>
<context>
    <name>trajectory.heading_unknown</name>
    <message>
        <source>its reference point is not the centre of its footprint, but its outlines do not show its heading</source>
        <translation>sein Bezugspunkt liegt neben seiner Mitte, aber seine Umrisse verraten seine Ausrichtung nicht</translation>
    </message>
</context>
<context>
    <name>trajectory.hidden_behind</name>
    <message>
        <source>hidden behind %1 in view %2</source>
        <translation>verdeckt von %1 in Sicht %2</translation>
    </message>
</context>
<context>
    <name>trajectory.import_exchanged</name>
    <message>
        <source>import them again, each for its own camera</source>
        <translation>importieren Sie sie erneut, jedes für seine eigene Kamera</translation>
    </message>
</context>
<context>
    <name>trajectory.import_video</name>
    <message>
        <source>import at least one video for it</source>
        <translation>importieren Sie mindestens ein Video dafür</translation>
    </message>
</context>
<context>
    <name>trajectory.jump</name>
    <message>
        <source>jump</source>
        <translation>Sprung</translation>
    </message>
</context>
<context>
    <name>trajectory.jump_of</name>
    <message>
        <source>jump of %1</source>
        <translation>Sprung von %1</translation>
    </message>
</context>
<context>
    <name>trajectory.look_and_register</name>
    <message>
        <source>check the outlines, and register the cameras again</source>
        <translation>sehen Sie sich die Umrisse an und messen Sie die Kameras neu ein</translation>
    </message>
</context>
<context>
    <name>trajectory.move_camera</name>
    <message>
        <source>move or add a camera to cover the whole task</source>
        <translation>versetzen oder ergänzen Sie eine Kamera, so dass die ganze Aufgabe zu sehen ist</translation>
    </message>
</context>
<context>
    <name>trajectory.no_such_smoother</name>
    <message>
        <source>no smoother has this name</source>
        <translation>so heißt keine</translation>
    </message>
</context>
<context>
    <name>trajectory.no_view</name>
    <message>
        <source>the trial has no view</source>
        <translation>der Versuch hat keine Sicht</translation>
    </message>
</context>
<context>
    <name>trajectory.no_view_trusted</name>
    <message>
        <source>none could be trusted</source>
        <translation>keine war verlässlich</translation>
    </message>
</context>
<context>
    <name>trajectory.not_enough_data</name>
    <message>
        <source>not enough data</source>
        <translation>nicht genug Daten</translation>
    </message>
</context>
<context>
    <name>trajectory.not_visible</name>
    <message>
        <source>not visible in view %1</source>
        <translation>nicht sichtbar in Sicht %1</translation>
    </message>
</context>
<context>
    <name>trajectory.occlusion_span</name>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
</context>
<context>
    <name>trajectory.one_outline</name>
    <message>
        <source>outline merged with %1 in view %2</source>
        <translation>ein Umriss mit %1 in Sicht %2</translation>
    </message>
</context>
<context>
    <name>trajectory.only_unregistered</name>
    <message>
        <source>only cameras that are not registered to the floor saw the robot</source>
        <translation>nur nicht eingemessene Kameras sahen den Roboter</translation>
    </message>
</context>
<context>
    <name>trajectory.outline_larger</name>
    <message>
        <source>outline larger than usual in view %1</source>
        <translation>Umriss größer als sonst in Sicht %1</translation>
    </message>
</context>
<context>
    <name>trajectory.outline_smaller</name>
    <message>
        <source>outline smaller than usual in view %1</source>
        <translation>Umriss kleiner als sonst in Sicht %1</translation>
    </message>
</context>
<context>
    <name>trajectory.partly_hidden_behind</name>
    <message>
        <source>partly hidden behind %1 in view %2</source>
        <translation>teilweise verdeckt von %1 in Sicht %2</translation>
    </message>
</context>
<context>
    <name>trajectory.path_not_measured</name>
    <message>
        <source>the robot&apos;s path cannot be measured</source>
        <translation>die Bahn des Roboters kann nicht gemessen werden</translation>
    </message>
</context>
<context>
    <name>trajectory.register_one</name>
    <message>
        <source>run odograph register for at least one of them</source>
        <translation>messen Sie mindestens eine davon ein</translation>
    </message>
</context>
<context>
    <name>trajectory.register_them</name>
    <message>
        <source>run odograph register for them</source>
        <translation>messen Sie sie ein</translation>
    </message>
</context>
<context>
    <name>trajectory.robot_not_found</name>
    <message>
        <source>the robot was not found in any frame of %1</source>
        <translation>der Roboter wurde in keinem Bild von %1 gefunden</translation>
    </message>
</context>
<context>
    <name>trajectory.seldom_together</name>
    <message>
        <source>its height is set to be triangulated, but two registered views rarely saw it at the same time</source>
        <translation>seine Höhe soll trianguliert werden, aber zwei eingemessene Sichten sahen ihn fast nie zugleich</translation>
    </message>
</context>
<context>
    <name>trajectory.smoother</name>
    <message>
        <source>smoother %1</source>
        <translation>Glättung %1</translation>
    </message>
</context>
<context>
    <name>trajectory.spike_by_hand</name>
    <message>
        <source>marked as a spike by hand</source>
        <translation>von Hand als Ausreißer markiert</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_both</name>
    <message>
        <source>spike in position and speed</source>
        <translation>fällt in Ort und Geschwindigkeit heraus</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_position</name>
    <message>
        <source>spike in position</source>
        <translation>fällt im Ort heraus</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_speed</name>
    <message>
        <source>spike in speed</source>
        <translation>fällt in der Geschwindigkeit heraus</translation>
    </message>
</context>
<context>
    <name>trajectory.track_first</name>
    <message>
        <source>track the trial&apos;s videos first</source>
        <translation>verfolgen Sie zuerst die Videos des Versuchs</translation>
    </message>
</context>
<context>
    <name>trajectory.tracker_unsure</name>
    <message>
        <source>the tracker was not sure (score %1)</source>
        <translation>die Verfolgung war unsicher (Güte %1)</translation>
    </message>
</context>
<context>
    <name>trajectory.unmeasured_between</name>
    <message>
        <source>nothing was measured from %1 to %2</source>
        <translation>von %1 bis %2 wurde nichts gemessen</translation>
    </message>
</context>
<context>
    <name>trajectory.unseen_after</name>
    <message>
        <source>no view sees it after %1 (it was at X %2, Y %3)</source>
        <translation>keine Sicht sieht ihn nach %1 (er war bei X %2, Y %3)</translation>
    </message>
</context>
<context>
    <name>trajectory.unseen_between</name>
    <message>
        <source>no view sees it from %1 to %2 (it was at X %3, Y %4)</source>
        <translation>keine Sicht sieht ihn von %1 bis %2 (er war bei X %3, Y %4)</translation>
    </message>
</context>
<context>
    <name>trajectory.use_smoother</name>
    <message>
        <source>use rts, savgol, tracker or none</source>
        <translation>verwenden Sie rts, savgol, tracker oder none</translation>
    </message>
</context>
<context>
    <name>trajectory.view_left_out</name>
    <message>
        <source>one left out</source>
        <translation>eine wurde weggelassen</translation>
    </message>
</context>
<context>
    <name>trajectory.view_without_frame</name>
    <message>
        <source>view %1 has no frame</source>
        <translation>die Sicht %1 hat kein Bild</translation>
    </message>
</context>
<context>
    <name>trajectory.views_apart</name>
    <message>
        <source>the views&apos; floor positions differ by %1</source>
        <translation>die Sichten setzen ihn %1 auseinander</translation>
    </message>
</context>
<context>
    <name>trajectory.views_disagree</name>
    <message>
        <source>views disagree by %1</source>
        <translation>die Sichten weichen um %1 voneinander ab</translation>
    </message>
</context>
<context>
    <name>trajectory.views_exchanged</name>
    <message>
        <source>the videos of %1 and %2 seem to be exchanged: exchanged, they agree</source>
        <translation>die Videos von %1 und %2 scheinen vertauscht zu sein: vertauscht stimmen sie überein</translation>
    </message>
</context>
<context>
    <name>trajectory.why_views_apart</name>
    <message>
        <source>a camera has moved since it was registered, the videos belong to other cameras, or one view follows something else</source>
        <translation>eine Kamera wurde nach dem Einmessen bewegt, die Videos gehören zu anderen Kameras, oder eine Sicht folgt etwas anderem</translation>
    </message>
</context>
<context>
    <name>ui.add_camera</name>
    <message>
        <source>add camera %1</source>
        <translation>Kamera %1 hinzufügen</translation>
    </message>
</context>
<context>
    <name>ui.add_class</name>
    <message>
        <source>add class %1</source>
        <translation>Klasse %1 anlegen</translation>
    </message>
</context>
<context>
    <name>ui.add_layout</name>
    <message>
        <source>add layout %1</source>
        <translation>Markerplan %1 anlegen</translation>
    </message>
</context>
<context>
    <name>ui.add_robot</name>
    <message>
        <source>add robot %1</source>
        <translation>Roboter %1 hinzufügen</translation>
    </message>
</context>
<context>
    <name>ui.add_task</name>
    <message>
        <source>add task %1</source>
        <translation>Aufgabe %1 anlegen</translation>
    </message>
</context>
<context>
    <name>ui.add_team</name>
    <message>
        <source>add team %1</source>
        <translation>Team %1 anlegen</translation>
    </message>
</context>
<context>
    <name>ui.adding_strays</name>
    <message>
        <source>Adding stray videos as trials</source>
        <translation>Herrenlose Videos werden als Versuche hinzugefügt</translation>
    </message>
</context>
<context>
    <name>ui.address_not_here</name>
    <message>
        <source>it is no address of this computer</source>
        <translation>sie ist keine Adresse dieses Computers</translation>
    </message>
</context>
<context>
    <name>ui.and_more</name>
    <message>
        <source>and %1 more</source>
        <translation>und noch %1</translation>
    </message>
</context>
<context>
    <name>ui.annotated_video</name>
    <message>
        <source>annotated video of &apos;%1&apos;</source>
        <translation>Video mit Einblendungen von &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.another_job_runs</name>
    <message>
        <source>another job is running</source>
        <translation>ein anderer Vorgang läuft</translation>
    </message>
</context>
<context>
    <name>ui.archive_class</name>
    <message>
        <source>archive class %1</source>
        <translation>Klasse %1 archivieren</translation>
    </message>
</context>
<context>
    <name>ui.archive_task</name>
    <message>
        <source>archive task %1</source>
        <translation>Aufgabe %1 archivieren</translation>
    </message>
</context>
<context>
    <name>ui.archive_trial</name>
    <message>
        <source>archive %1</source>
        <translation>%1 archivieren</translation>
    </message>
</context>
<context>
    <name>ui.archive_trials</name>
    <message>
        <source>archive %1 trials</source>
        <translation>%1 Versuche archivieren</translation>
    </message>
</context>
<context>
    <name>ui.backup_is_sound</name>
    <message>
        <source>its backup of %1 is intact; it does not contain later changes</source>
        <translation>seine Sicherungskopie vom %1 ist unversehrt; was seitdem getan wurde, ist nicht darin</translation>
    </message>
</context>
<context>
    <name>ui.board_has_corners</name>
    <message>
        <source>a board has 3 to 30 inner corners each way</source>
        <translation>eine Tafel hat 3 bis 30 innere Ecken in jeder Richtung</translation>
    </message>
</context>
<context>
    <name>ui.bring_file_back</name>
    <message>
        <source>move the file back there</source>
        <translation>bringen Sie die Datei an ihren Platz zurück</translation>
    </message>
</context>
<context>
    <name>ui.calibrate_other_first</name>
    <message>
        <source>calibrate the other one, or import a trial with it, first</source>
        <translation>kalibrieren Sie zuerst die andere, oder importieren Sie zuerst einen Versuch mit ihr</translation>
    </message>
</context>
<context>
    <name>ui.camera_named</name>
    <message>
        <source>camera %1</source>
        <translation>Kamera %1</translation>
    </message>
</context>
<context>
    <name>ui.cameras</name>
    <message>
        <source>the cameras</source>
        <translation>die Kameras</translation>
    </message>
</context>
<context>
    <name>ui.cannot_make_another</name>
    <message>
        <source>cannot create another project</source>
        <translation>ein anderes Projekt lässt sich nicht anlegen</translation>
    </message>
</context>
<context>
    <name>ui.cannot_open_another</name>
    <message>
        <source>cannot open another project</source>
        <translation>ein anderes Projekt lässt sich nicht öffnen</translation>
    </message>
</context>
<context>
    <name>ui.change_pseudonym</name>
    <message>
        <source>change the pseudonym of team %1</source>
        <translation>Pseudonym von Team %1 ändern</translation>
    </message>
</context>
<context>
    <name>ui.change_robot</name>
    <message>
        <source>change robot %1</source>
        <translation>Roboter %1 ändern</translation>
    </message>
</context>
<context>
    <name>ui.change_tags</name>
    <message>
        <source>change the tags of %1</source>
        <translation>Schlagwörter von %1 ändern</translation>
    </message>
</context>
<context>
    <name>ui.change_task</name>
    <message>
        <source>change task %1</source>
        <translation>Aufgabe %1 ändern</translation>
    </message>
</context>
<context>
    <name>ui.change_team</name>
    <message>
        <source>change members and robots of team %1</source>
        <translation>Mitglieder und Roboter von Team %1 ändern</translation>
    </message>
</context>
<context>
    <name>ui.charuco_numbered_in_two_ways</name>
    <message>
        <source>programs number a ChArUco board with %1 rows of squares in two different ways</source>
        <translation>eine ChArUco-Tafel mit %1 Quadratreihen wird von verschiedenen Programmen auf zweierlei Weise nummeriert</translation>
    </message>
</context>
<context>
    <name>ui.check_hub</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network</source>
        <translation>prüfen Sie die Adresse, die Anmeldung in ~/.pgpass und das Netzwerk</translation>
    </message>
</context>
<context>
    <name>ui.choose_another_port</name>
    <message>
        <source>choose another port, or 0 for any that is free</source>
        <translation>wählen Sie einen anderen Port, oder 0 für irgendeinen freien</translation>
    </message>
</context>
<context>
    <name>ui.choose_high_port</name>
    <message>
        <source>choose a port of 1024 or more</source>
        <translation>wählen Sie einen Port ab 1024</translation>
    </message>
</context>
<context>
    <name>ui.choose_logo</name>
    <message>
        <source>choose a PNG, JPEG or SVG image</source>
        <translation>wählen Sie ein PNG-, JPEG- oder SVG-Bild</translation>
    </message>
</context>
<context>
    <name>ui.choose_or_make_class</name>
    <message>
        <source>choose one of them, or create it in the workbench</source>
        <translation>wählen Sie eine davon, oder legen Sie sie im Programmfenster an</translation>
    </message>
</context>
<context>
    <name>ui.choose_own_address</name>
    <message>
        <source>choose 127.0.0.1, an address of this computer, or 0.0.0.0 for all of them</source>
        <translation>wählen Sie 127.0.0.1, eine Adresse dieses Computers, oder 0.0.0.0 für alle</translation>
    </message>
</context>
<context>
    <name>ui.choose_recorded</name>
    <message>
        <source>choose one that was recorded</source>
        <translation>wählen Sie einen, der aufgenommen wurde</translation>
    </message>
</context>
<context>
    <name>ui.choose_trial_or_class</name>
    <message>
        <source>choose a trial or a class</source>
        <translation>wählen Sie einen Versuch oder eine Klasse</translation>
    </message>
</context>
<context>
    <name>ui.choose_video_size</name>
    <message>
        <source>choose another, such as 1920x1080</source>
        <translation>wählen Sie eine andere, etwa 1920x1080</translation>
    </message>
</context>
<context>
    <name>ui.choose_video_speed</name>
    <message>
        <source>choose another, such as 0.25</source>
        <translation>wählen Sie eine andere, etwa 0.25</translation>
    </message>
</context>
<context>
    <name>ui.clips_being_read</name>
    <message>
        <source>those dropped before are still being read</source>
        <translation>die vorigen werden noch gelesen</translation>
    </message>
</context>
<context>
    <name>ui.completing_recording</name>
    <message>
        <source>Completing an interrupted recording</source>
        <translation>Abgebrochene Aufnahme wird vervollständigt</translation>
    </message>
</context>
<context>
    <name>ui.connect_camera</name>
    <message>
        <source>connect camera %1</source>
        <translation>Kamera %1 verbinden</translation>
    </message>
</context>
<context>
    <name>ui.delete_class</name>
    <message>
        <source>delete class %1</source>
        <translation>Klasse %1 löschen</translation>
    </message>
</context>
<context>
    <name>ui.delete_robot</name>
    <message>
        <source>delete robot %1</source>
        <translation>Roboter %1 löschen</translation>
    </message>
</context>
<context>
    <name>ui.delete_task</name>
    <message>
        <source>delete task %1</source>
        <translation>Aufgabe %1 löschen</translation>
    </message>
</context>
<context>
    <name>ui.delete_team</name>
    <message>
        <source>delete team %1</source>
        <translation>Team %1 löschen</translation>
    </message>
</context>
<context>
    <name>ui.delete_trial</name>
    <message>
        <source>delete %1</source>
        <translation>%1 löschen</translation>
    </message>
</context>
<context>
    <name>ui.delete_trials</name>
    <message>
        <source>delete %1 trials</source>
        <translation>%1 Versuche löschen</translation>
    </message>
</context>
<context>
    <name>ui.does_not_fit_on</name>
    <message>
        <source>%1 by %2 do not fit on %3</source>
        <translation>%1 mal %2 passen nicht auf %3</translation>
    </message>
</context>
<context>
    <name>ui.drop_again</name>
    <message>
        <source>drop them again in a moment</source>
        <translation>ziehen Sie sie gleich noch einmal herein</translation>
    </message>
</context>
<context>
    <name>ui.dropped_clips</name>
    <message>
        <source>the dropped clips</source>
        <translation>die hereingezogenen Videos</translation>
    </message>
</context>
<context>
    <name>ui.emptying_bin</name>
    <message>
        <source>Emptying the bin</source>
        <translation>Papierkorb wird geleert</translation>
    </message>
</context>
<context>
    <name>ui.export_of</name>
    <message>
        <source>export of %1</source>
        <translation>Export von %1</translation>
    </message>
</context>
<context>
    <name>ui.exported_trials</name>
    <message>
        <source>Exported trials: %1 of %2</source>
        <translation>Exportierte Versuche: %1 von %2</translation>
    </message>
</context>
<context>
    <name>ui.exporting</name>
    <message>
        <source>Exporting %1 (%2 of %3)</source>
        <translation>%1 wird exportiert (%2 von %3)</translation>
    </message>
</context>
<context>
    <name>ui.finding_mat</name>
    <message>
        <source>Finding the floor mat</source>
        <translation>Bodenmatte wird gesucht</translation>
    </message>
</context>
<context>
    <name>ui.floor_mat</name>
    <message>
        <source>floor mat</source>
        <translation>Bodenmatte</translation>
    </message>
</context>
<context>
    <name>ui.give_board_size</name>
    <message>
        <source>give a size such as 9x6</source>
        <translation>geben Sie eine Größe an, etwa 9x6</translation>
    </message>
</context>
<context>
    <name>ui.give_marker_size</name>
    <message>
        <source>give its size, such as 150mm</source>
        <translation>geben Sie seine Größe an, etwa 150mm</translation>
    </message>
</context>
<context>
    <name>ui.give_mat_size</name>
    <message>
        <source>give a size such as 4x3</source>
        <translation>geben Sie eine Größe wie 4x3 an</translation>
    </message>
</context>
<context>
    <name>ui.give_square_side</name>
    <message>
        <source>give the side of a square, such as 25mm</source>
        <translation>geben Sie die Seite eines Quadrats an, etwa 25mm</translation>
    </message>
</context>
<context>
    <name>ui.html_page</name>
    <message>
        <source>page</source>
        <translation>Seite</translation>
    </message>
</context>
<context>
    <name>ui.hub_away</name>
    <message>
        <source>it cannot be reached</source>
        <translation>er ist nicht erreichbar</translation>
    </message>
</context>
<context>
    <name>ui.hub_goes_on</name>
    <message>
        <source>the page shows the last standings until it is back</source>
        <translation>die Seite zeigt die letzte Rangliste, bis er wieder da ist</translation>
    </message>
</context>
<context>
    <name>ui.hub_silent</name>
    <message>
        <source>the server does not answer</source>
        <translation>der Server antwortet nicht</translation>
    </message>
</context>
<context>
    <name>ui.import_or_record_first</name>
    <message>
        <source>import or record one first</source>
        <translation>zuerst einen importieren oder aufnehmen</translation>
    </message>
</context>
<context>
    <name>ui.importing</name>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
</context>
<context>
    <name>ui.importing_trials</name>
    <message>
        <source>Importing %1 (%2 of %3)</source>
        <translation>%1 wird importiert (%2 von %3)</translation>
    </message>
</context>
<context>
    <name>ui.is_printer_ready</name>
    <message>
        <source>check that the printer is ready</source>
        <translation>sehen Sie nach, ob der Drucker bereit ist</translation>
    </message>
</context>
<context>
    <name>ui.job_runs_on_project</name>
    <message>
        <source>a job is running on the project</source>
        <translation>ein Vorgang läuft am Projekt</translation>
    </message>
</context>
<context>
    <name>ui.lens_of_other_size</name>
    <message>
        <source>its size is %1×%2, but the lens was calibrated at %3×%4</source>
        <translation>es hat %1×%2, aber das Objektiv wurde bei %3×%4 gemessen</translation>
    </message>
</context>
<context>
    <name>ui.logo</name>
    <message>
        <source>logo &apos;%1&apos;</source>
        <translation>Logo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.logo_too_large</name>
    <message>
        <source>it is larger than a hundred megapixels</source>
        <translation>es ist größer als hundert Megapixel</translation>
    </message>
</context>
<context>
    <name>ui.look_at_printer</name>
    <message>
        <source>check the printer and its queue, or save the report as PDF</source>
        <translation>sehen Sie nach dem Drucker und seiner Warteschlange, oder speichern Sie den Bericht als PDF</translation>
    </message>
</context>
<context>
    <name>ui.looking_for_lost</name>
    <message>
        <source>Searching for lost videos</source>
        <translation>Verlorene Videos werden gesucht</translation>
    </message>
</context>
<context>
    <name>ui.looking_for_strays</name>
    <message>
        <source>Searching for stray files</source>
        <translation>Herrenlose Dateien werden gesucht</translation>
    </message>
</context>
<context>
    <name>ui.make_marker_smaller</name>
    <message>
        <source>make it at most %1, or use larger paper</source>
        <translation>machen Sie ihn höchstens %1 groß, oder nehmen Sie ein größeres Papier</translation>
    </message>
</context>
<context>
    <name>ui.make_smaller</name>
    <message>
        <source>make it smaller</source>
        <translation>machen Sie es kleiner</translation>
    </message>
</context>
<context>
    <name>ui.make_squares_smaller</name>
    <message>
        <source>make the squares at most %1, or use larger paper</source>
        <translation>machen Sie die Quadrate höchstens %1 groß, oder nehmen Sie ein größeres Papier</translation>
    </message>
</context>
<context>
    <name>ui.making_certificate</name>
    <message>
        <source>Simulating the set-up</source>
        <translation>Der Aufbau wird simuliert</translation>
    </message>
</context>
<context>
    <name>ui.making_demo</name>
    <message>
        <source>Creating the demo lesson</source>
        <translation>Demo-Lektion wird angelegt</translation>
    </message>
</context>
<context>
    <name>ui.making_hashes</name>
    <message>
        <source>Computing the hashes of new recordings</source>
        <translation>Prüfsummen neuer Aufnahmen werden gebildet</translation>
    </message>
</context>
<context>
    <name>ui.making_report</name>
    <message>
        <source>Creating the report</source>
        <translation>Bericht wird erstellt</translation>
    </message>
</context>
<context>
    <name>ui.making_video</name>
    <message>
        <source>Creating the video of %1</source>
        <translation>Video von %1 wird erstellt</translation>
    </message>
</context>
<context>
    <name>ui.making_videos</name>
    <message>
        <source>Creating the video of %1 (%2 of %3)</source>
        <translation>Video von %1 wird erstellt (%2 von %3)</translation>
    </message>
</context>
<context>
    <name>ui.many_trials</name>
    <message>
        <source>many trials</source>
        <translation>viele Versuche</translation>
    </message>
</context>
<context>
    <name>ui.mat_has_sheets</name>
    <message>
        <source>a mat has 1 to %1 sheets in a row and 1 to %2 rows</source>
        <translation>eine Matte hat 1 bis %1 Blätter in einer Reihe und 1 bis %2 Reihen</translation>
    </message>
</context>
<context>
    <name>ui.measuring_again</name>
    <message>
        <source>Reanalysing %1</source>
        <translation>%1 wird neu ausgewertet</translation>
    </message>
</context>
<context>
    <name>ui.measuring_trials_again</name>
    <message>
        <source>Reanalysing %1 (%2 of %3)</source>
        <translation>%1 wird neu ausgewertet (%2 von %3)</translation>
    </message>
</context>
<context>
    <name>ui.mend_and_choose_again</name>
    <message>
        <source>correct the listed errors, then select these trials again</source>
        <translation>beheben, was dort steht, und diese Versuche erneut wählen</translation>
    </message>
</context>
<context>
    <name>ui.move_team</name>
    <message>
        <source>move team %1 to class %2</source>
        <translation>Team %1 in Klasse %2 verschieben</translation>
    </message>
</context>
<context>
    <name>ui.name_one_marker</name>
    <message>
        <source>name at least one, for example O</source>
        <translation>nennen Sie mindestens einen, etwa O</translation>
    </message>
</context>
<context>
    <name>ui.no_camera_registered</name>
    <message>
        <source>no camera is registered yet</source>
        <translation>noch keine Kamera ist eingemessen</translation>
    </message>
</context>
<context>
    <name>ui.no_further_page</name>
    <message>
        <source>it accepts no more pages</source>
        <translation>er nimmt keine weitere Seite an</translation>
    </message>
</context>
<context>
    <name>ui.no_marker_to_print</name>
    <message>
        <source>no marker to print</source>
        <translation>kein Marker ist zu drucken</translation>
    </message>
</context>
<context>
    <name>ui.no_page</name>
    <message>
        <source>it has no page</source>
        <translation>er hat keine Seite</translation>
    </message>
</context>
<context>
    <name>ui.no_project_open</name>
    <message>
        <source>no project is open</source>
        <translation>es ist kein Projekt geöffnet</translation>
    </message>
</context>
<context>
    <name>ui.no_run_with_figure</name>
    <message>
        <source>none of its teams has a run with the metric &apos;%1&apos;</source>
        <translation>keines ihrer Teams hat eine Fahrt mit dem Kennwert &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.no_run_with_figure_in_task</name>
    <message>
        <source>none of its teams has a run with the metric &apos;%1&apos; in the task &apos;%2&apos;</source>
        <translation>keines ihrer Teams hat eine Fahrt mit dem Kennwert &apos;%1&apos; in der Aufgabe &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>ui.no_trial_yet</name>
    <message>
        <source>the project has no trial yet</source>
        <translation>es gibt noch keinen Versuch</translation>
    </message>
</context>
<context>
    <name>ui.not_printed</name>
    <message>
        <source>it could not be printed</source>
        <translation>sie konnte nicht gedruckt werden</translation>
    </message>
</context>
<context>
    <name>ui.nothing_changed_here</name>
    <message>
        <source>no change was made here</source>
        <translation>hier wurde nichts geändert</translation>
    </message>
</context>
<context>
    <name>ui.only_be_read</name>
    <message>
        <source>this project is read-only</source>
        <translation>dieses Projekt ist nur lesbar</translation>
    </message>
</context>
<context>
    <name>ui.only_one_camera</name>
    <message>
        <source>the project has only one camera</source>
        <translation>es gibt nur eine Kamera</translation>
    </message>
</context>
<context>
    <name>ui.only_so_many_charuco_markers</name>
    <message>
        <source>only 250 markers exist for a ChArUco board</source>
        <translation>für eine ChArUco-Tafel gibt es nur 250 Marker</translation>
    </message>
</context>
<context>
    <name>ui.only_so_many_tags</name>
    <message>
        <source>only %1 tags exist</source>
        <translation>es gibt nur %1 Tags</translation>
    </message>
</context>
<context>
    <name>ui.open_its_project</name>
    <message>
        <source>open the project that it belongs to</source>
        <translation>das zugehörige Projekt öffnen</translation>
    </message>
</context>
<context>
    <name>ui.open_project_first</name>
    <message>
        <source>open or create a project first</source>
        <translation>zuerst ein Projekt öffnen oder anlegen</translation>
    </message>
</context>
<context>
    <name>ui.opening</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
</context>
<context>
    <name>ui.packing</name>
    <message>
        <source>Packing the project</source>
        <translation>Projekt wird gepackt</translation>
    </message>
</context>
<context>
    <name>ui.page_of_trial</name>
    <message>
        <source>page of trial &apos;%1&apos;</source>
        <translation>Seite des Versuchs &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.pages_not_taken</name>
    <message>
        <source>it did not accept the pages</source>
        <translation>er hat die Seiten nicht angenommen</translation>
    </message>
</context>
<context>
    <name>ui.painting_floor</name>
    <message>
        <source>drawing the floor</source>
        <translation>der Boden wird gezeichnet</translation>
    </message>
</context>
<context>
    <name>ui.picture</name>
    <message>
        <source>the image</source>
        <translation>das Bild</translation>
    </message>
</context>
<context>
    <name>ui.picture_of</name>
    <message>
        <source>frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
</context>
<context>
    <name>ui.port_in_use</name>
    <message>
        <source>another program uses this port</source>
        <translation>ein anderes Programm benutzt diesen Port</translation>
    </message>
</context>
<context>
    <name>ui.port_not_allowed</name>
    <message>
        <source>the system does not allow this port</source>
        <translation>das System erlaubt diesen Port nicht</translation>
    </message>
</context>
<context>
    <name>ui.preview</name>
    <message>
        <source>preview</source>
        <translation>Vorschau</translation>
    </message>
</context>
<context>
    <name>ui.print_fewer_markers</name>
    <message>
        <source>print fewer markers</source>
        <translation>drucken Sie weniger Marker</translation>
    </message>
</context>
<context>
    <name>ui.printer_not_reached</name>
    <message>
        <source>it cannot be reached</source>
        <translation>er ist nicht erreichbar</translation>
    </message>
</context>
<context>
    <name>ui.printing_on</name>
    <message>
        <source>printing on &apos;%1&apos;</source>
        <translation>Drucken auf „%1“</translation>
    </message>
</context>
<context>
    <name>ui.project_has_classes</name>
    <message>
        <source>the project has %1</source>
        <translation>das Projekt hat %1</translation>
    </message>
</context>
<context>
    <name>ui.project_has_no_class</name>
    <message>
        <source>the project has none</source>
        <translation>das Projekt hat keine</translation>
    </message>
</context>
<context>
    <name>ui.recording_not_there</name>
    <message>
        <source>the recording of camera %1 is not at &apos;%2&apos;</source>
        <translation>die Aufnahme der Kamera %1 ist nicht unter &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>ui.register_one_first</name>
    <message>
        <source>register one that sees the markers first</source>
        <translation>messen Sie zuerst eine ein, die die Marker sieht</translation>
    </message>
</context>
<context>
    <name>ui.registering</name>
    <message>
        <source>Registering camera %1</source>
        <translation>Kamera %1 wird eingemessen</translation>
    </message>
</context>
<context>
    <name>ui.registration_through_another</name>
    <message>
        <source>registration via another camera</source>
        <translation>Einmessung über eine andere Kamera</translation>
    </message>
</context>
<context>
    <name>ui.removing_strays</name>
    <message>
        <source>Removing stray files</source>
        <translation>Herrenlose Dateien werden entfernt</translation>
    </message>
</context>
<context>
    <name>ui.rename_class</name>
    <message>
        <source>rename class %1 to %2</source>
        <translation>Klasse %1 in %2 umbenennen</translation>
    </message>
</context>
<context>
    <name>ui.rename_task</name>
    <message>
        <source>rename task %1 to %2</source>
        <translation>Aufgabe %1 in %2 umbenennen</translation>
    </message>
</context>
<context>
    <name>ui.rename_team</name>
    <message>
        <source>rename team %1 to %2</source>
        <translation>Team %1 in %2 umbenennen</translation>
    </message>
</context>
<context>
    <name>ui.report</name>
    <message>
        <source>report</source>
        <translation>Bericht</translation>
    </message>
</context>
<context>
    <name>ui.report_file</name>
    <message>
        <source>report &apos;%1&apos;</source>
        <translation>Bericht „%1“</translation>
    </message>
</context>
<context>
    <name>ui.report_of_class</name>
    <message>
        <source>report of class &apos;%1&apos;</source>
        <translation>Bericht der Klasse &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.restoring_backup</name>
    <message>
        <source>Restoring the backup</source>
        <translation>Sicherungskopie wird wiederhergestellt</translation>
    </message>
</context>
<context>
    <name>ui.save_copy</name>
    <message>
        <source>save a copy and work on the copy</source>
        <translation>eine Kopie speichern und mit ihr arbeiten</translation>
    </message>
</context>
<context>
    <name>ui.saving_copy</name>
    <message>
        <source>Saving a copy</source>
        <translation>Kopie wird gespeichert</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_address</name>
    <message>
        <source>standings at %1 port %2</source>
        <translation>Rangliste unter %1 Port %2</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_project_gone</name>
    <message>
        <source>it was moved or deleted, so the standings ended</source>
        <translation>sie wurde verschoben oder gelöscht, daher endete die Rangliste</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_start_again</name>
    <message>
        <source>start them with the file&apos;s present name</source>
        <translation>starten Sie sie mit dem jetzigen Namen der Datei</translation>
    </message>
</context>
<context>
    <name>ui.size_is_no_length</name>
    <message>
        <source>its size is not a length</source>
        <translation>die Größe ist keine Länge</translation>
    </message>
</context>
<context>
    <name>ui.star_trial</name>
    <message>
        <source>star %1</source>
        <translation>%1 mit Stern versehen</translation>
    </message>
</context>
<context>
    <name>ui.star_trials</name>
    <message>
        <source>star %1 trials</source>
        <translation>%1 Versuche mit Stern versehen</translation>
    </message>
</context>
<context>
    <name>ui.synchronising</name>
    <message>
        <source>Synchronising %1</source>
        <translation>%1 wird synchronisiert</translation>
    </message>
</context>
<context>
    <name>ui.take_at_that_resolution</name>
    <message>
        <source>use that resolution, or calibrate the lens again</source>
        <translation>nehmen Sie es in jener Auflösung auf, oder messen Sie das Objektiv neu</translation>
    </message>
</context>
<context>
    <name>ui.take_even_rows</name>
    <message>
        <source>use an even number of rows of inner corners, such as 9x6</source>
        <translation>nehmen Sie eine gerade Anzahl von Reihen innerer Ecken, etwa 9x6</translation>
    </message>
</context>
<context>
    <name>ui.take_fewer_squares</name>
    <message>
        <source>use fewer squares</source>
        <translation>nehmen Sie weniger Quadrate</translation>
    </message>
</context>
<context>
    <name>ui.take_team_out</name>
    <message>
        <source>remove team %1 from its class</source>
        <translation>Team %1 aus seiner Klasse nehmen</translation>
    </message>
</context>
<context>
    <name>ui.taking_over_setup</name>
    <message>
        <source>Copying the set-up</source>
        <translation>Der Aufbau wird übernommen</translation>
    </message>
</context>
<context>
    <name>ui.target</name>
    <message>
        <source>target</source>
        <translation>Vorlage</translation>
    </message>
</context>
<context>
    <name>ui.the_range</name>
    <message>
        <source>the range</source>
        <translation>der Bereich</translation>
    </message>
</context>
<context>
    <name>ui.the_sample</name>
    <message>
        <source>the sample</source>
        <translation>der Messpunkt</translation>
    </message>
</context>
<context>
    <name>ui.the_trial</name>
    <message>
        <source>the trial</source>
        <translation>der Versuch</translation>
    </message>
</context>
<context>
    <name>ui.track_or_choose_figure</name>
    <message>
        <source>track its trials, or choose another task or metric</source>
        <translation>verfolgen Sie ihre Versuche, oder wählen Sie eine andere Aufgabe oder einen anderen Kennwert</translation>
    </message>
</context>
<context>
    <name>ui.tracking</name>
    <message>
        <source>Tracking %1</source>
        <translation>%1 wird verfolgt</translation>
    </message>
</context>
<context>
    <name>ui.trial_without_recording</name>
    <message>
        <source>the trial has no recording</source>
        <translation>der Versuch hat keine Aufnahme</translation>
    </message>
</context>
<context>
    <name>ui.trials_imported</name>
    <message>
        <source>Trials imported: %1 of %2</source>
        <translation>Importierte Versuche: %1 von %2</translation>
    </message>
</context>
<context>
    <name>ui.trials_measured_again</name>
    <message>
        <source>Trials reanalysed: %1 of %2</source>
        <translation>Neu ausgewertete Versuche: %1 von %2</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_class</name>
    <message>
        <source>restore class %1 from the archive</source>
        <translation>Klasse %1 aus dem Archiv holen</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_task</name>
    <message>
        <source>restore task %1 from the archive</source>
        <translation>Aufgabe %1 aus dem Archiv holen</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_trial</name>
    <message>
        <source>restore %1 from the archive</source>
        <translation>%1 aus dem Archiv holen</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_trials</name>
    <message>
        <source>restore %1 trials from the archive</source>
        <translation>%1 Versuche aus dem Archiv holen</translation>
    </message>
</context>
<context>
    <name>ui.undelete_trial</name>
    <message>
        <source>restore %1 from the bin</source>
        <translation>%1 aus dem Papierkorb holen</translation>
    </message>
</context>
<context>
    <name>ui.undelete_trials</name>
    <message>
        <source>restore %1 trials from the bin</source>
        <translation>%1 Versuche aus dem Papierkorb holen</translation>
    </message>
</context>
<context>
    <name>ui.undo_in_menu</name>
    <message>
        <source>use the window&apos;s Edit menu to undo earlier changes</source>
        <translation>frühere Änderungen im Menü Bearbeiten des Fensters zurücknehmen</translation>
    </message>
</context>
<context>
    <name>ui.unpacking</name>
    <message>
        <source>Unpacking the project</source>
        <translation>Projekt wird entpackt</translation>
    </message>
</context>
<context>
    <name>ui.unstar_trial</name>
    <message>
        <source>remove the star from %1</source>
        <translation>Stern von %1 entfernen</translation>
    </message>
</context>
<context>
    <name>ui.unstar_trials</name>
    <message>
        <source>remove the star from %1 trials</source>
        <translation>Stern von %1 Versuchen entfernen</translation>
    </message>
</context>
<context>
    <name>ui.video_size_wrong</name>
    <message>
        <source>its size of %1x%2 has an odd number of pixels, or is not between 320x180 and 3840x2160</source>
        <translation>die Größe %1x%2 ist ungerade, oder nicht zwischen 320x180 und 3840x2160</translation>
    </message>
</context>
<context>
    <name>ui.video_speed_wrong</name>
    <message>
        <source>its speed is not between 0.1 and 1</source>
        <translation>die Geschwindigkeit liegt nicht zwischen 0.1 und 1</translation>
    </message>
</context>
<context>
    <name>ui.videos_made</name>
    <message>
        <source>Videos created: %1 of %2</source>
        <translation>Erstellte Videos: %1 von %2</translation>
    </message>
</context>
<context>
    <name>ui.wait_or_cancel</name>
    <message>
        <source>wait until it is done, or cancel it</source>
        <translation>warten, bis er fertig ist, oder ihn abbrechen</translation>
    </message>
</context>
<context>
    <name>ui.write_notes</name>
    <message>
        <source>write notes of %1</source>
        <translation>Notizen zu %1 schreiben</translation>
    </message>
</context>
<context>
    <name>ui.writing_back</name>
    <message>
        <source>writing back</source>
        <translation>Zurückschreiben</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode</name>
    <message>
        <source>cannot decode the video</source>
        <translation>das Video kann nicht dekodiert werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode_all</name>
    <message>
        <source>cannot decode all of a frame</source>
        <translation>ein Bild kann nicht ganz dekodiert werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode_frame</name>
    <message>
        <source>cannot decode frame %1 of %2</source>
        <translation>Bild %1 von %2 kann nicht dekodiert werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_encode</name>
    <message>
        <source>cannot encode the video</source>
        <translation>das Video kann nicht kodiert werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_finish</name>
    <message>
        <source>cannot finish the video %1</source>
        <translation>das Video %1 kann nicht abgeschlossen werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_join</name>
    <message>
        <source>cannot join &apos;%1&apos; to a recording</source>
        <translation>&apos;%1&apos; kann nicht mit einer Aufnahme verbunden werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_open</name>
    <message>
        <source>cannot open the video %1</source>
        <translation>das Video %1 kann nicht geöffnet werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_read_picture</name>
    <message>
        <source>cannot read the image %1</source>
        <translation>das Bild %1 kann nicht gelesen werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_read_sound</name>
    <message>
        <source>cannot read the sound of %1</source>
        <translation>der Ton von %1 kann nicht gelesen werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_show_frame</name>
    <message>
        <source>cannot show frame %1 of %2</source>
        <translation>Bild %1 von %2 kann nicht gezeigt werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_take_image</name>
    <message>
        <source>cannot take &apos;%1&apos; as a frame of a video</source>
        <translation>&apos;%1&apos; kann nicht als Bild eines Videos genommen werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_write</name>
    <message>
        <source>cannot write the video %1</source>
        <translation>das Video %1 kann nicht geschrieben werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_frame</name>
    <message>
        <source>cannot write a frame to the video %1</source>
        <translation>in das Video %1 kann kein Bild geschrieben werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_joined</name>
    <message>
        <source>cannot write the joined recording %1</source>
        <translation>die verbundene Aufnahme %1 kann nicht geschrieben werden</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_recording</name>
    <message>
        <source>cannot write the recording %1</source>
        <translation>die Aufnahme %1 kann nicht geschrieben werden</translation>
    </message>
</context>
<context>
    <name>video.chapter_after_gap</name>
    <message>
        <source>by its recording time %1 are missing between &apos;%2&apos; and it; if so, all times behind that are wrong</source>
        <translation>nach der Aufnahmezeit fehlen %1 zwischen &apos;%2&apos; und dieser Datei; wenn das so ist, sind alle Zeiten dahinter falsch</translation>
    </message>
</context>
<context>
    <name>video.chapter_codec</name>
    <message>
        <source>its codec is %1, that of &apos;%2&apos; is %3</source>
        <translation>ihr Codec ist %1, der von &apos;%2&apos; ist %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_hides_frames</name>
    <message>
        <source>some of its frames are hidden, as an editor does that cuts a video</source>
        <translation>einige ihrer Bilder sind verborgen, wie es ein Schnittprogramm macht, wenn es kürzt</translation>
    </message>
</context>
<context>
    <name>video.chapter_mirrored</name>
    <message>
        <source>its frames and those of &apos;%1&apos; are not mirrored alike</source>
        <translation>ihre Bilder und die von &apos;%1&apos; sind nicht gleich gespiegelt</translation>
    </message>
</context>
<context>
    <name>video.chapter_pixels</name>
    <message>
        <source>its pixel format is %1, that of &apos;%2&apos; is %3</source>
        <translation>ihr Pixelformat ist %1, das von &apos;%2&apos; ist %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_recorded_before</name>
    <message>
        <source>by its recording time it was started before &apos;%1&apos;, behind which it was joined; check the order of the files</source>
        <translation>nach der Aufnahmezeit begann sie vor &apos;%1&apos;, hinter die sie gesetzt wurde; prüfen Sie die Reihenfolge der Dateien</translation>
    </message>
</context>
<context>
    <name>video.chapter_restarts</name>
    <message>
        <source>its time stamps begin again or stand still after %1</source>
        <translation>ihre Zeitstempel beginnen nach %1 von vorn oder bleiben stehen</translation>
    </message>
</context>
<context>
    <name>video.chapter_set_up</name>
    <message>
        <source>its encoder was set up in another way than that of &apos;%1&apos;</source>
        <translation>ihr Encoder war anders eingestellt als der von &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.chapter_size</name>
    <message>
        <source>its frames are %1, those of &apos;%2&apos; are %3</source>
        <translation>ihre Bilder haben %1, die von &apos;%2&apos; %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_turn</name>
    <message>
        <source>its frames are to be turned by %1°, those of &apos;%2&apos; by %3°</source>
        <translation>ihre Bilder sind um %1° zu drehen, die von &apos;%2&apos; um %3°</translation>
    </message>
</context>
<context>
    <name>video.chapter_without_stamps</name>
    <message>
        <source>its frames have no time stamps of their own</source>
        <translation>ihre Bilder haben keine eigenen Zeitstempel</translation>
    </message>
</context>
<context>
    <name>video.chapters_of_one_frame</name>
    <message>
        <source>each of the files has a single frame</source>
        <translation>jede der Dateien hat nur ein Bild</translation>
    </message>
</context>
<context>
    <name>video.check_its_folder</name>
    <message>
        <source>check that its folder may be written to and has free space</source>
        <translation>prüfen Sie, ob sein Ordner beschreibbar ist und Platz hat</translation>
    </message>
</context>
<context>
    <name>video.check_picture_place</name>
    <message>
        <source>check the folder, the free space, and that the name ends in .png or .jpg</source>
        <translation>prüfen Sie den Ordner, den freien Platz, und ob der Name auf .png oder .jpg endet</translation>
    </message>
</context>
<context>
    <name>video.check_room</name>
    <message>
        <source>check the free disk space</source>
        <translation>prüfen Sie, ob auf der Platte Platz ist</translation>
    </message>
</context>
<context>
    <name>video.check_the_folder</name>
    <message>
        <source>check that the folder exists, may be written to and has free space</source>
        <translation>prüfen Sie, ob es den Ordner gibt, ob er beschreibbar ist und Platz hat</translation>
    </message>
</context>
<context>
    <name>video.check_what_was_asked</name>
    <message>
        <source>check the requested size, frame rate and quality</source>
        <translation>prüfen Sie die verlangte Größe, Bildrate und Qualität</translation>
    </message>
</context>
<context>
    <name>video.choose_one_of_these</name>
    <message>
        <source>choose one of these</source>
        <translation>wählen Sie eines davon</translation>
    </message>
</context>
<context>
    <name>video.convert_sound_to_aac</name>
    <message>
        <source>convert its sound to AAC</source>
        <translation>wandeln Sie seinen Ton in AAC um</translation>
    </message>
</context>
<context>
    <name>video.convert_to_h264</name>
    <message>
        <source>convert it to H.264</source>
        <translation>wandeln Sie es in H.264 um</translation>
    </message>
</context>
<context>
    <name>video.convert_to_png</name>
    <message>
        <source>convert it to PNG or JPEG</source>
        <translation>wandeln Sie es in PNG oder JPEG um</translation>
    </message>
</context>
<context>
    <name>video.convert_to_smaller</name>
    <message>
        <source>convert it to a smaller size</source>
        <translation>wandeln Sie es in eine kleinere Größe um</translation>
    </message>
</context>
<context>
    <name>video.convert_to_yuv</name>
    <message>
        <source>convert it to 8-bit YUV, e.g. ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4</source>
        <translation>wandeln Sie es in 8-Bit-YUV um, z. B. mit ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4</translation>
    </message>
</context>
<context>
    <name>video.copy_again</name>
    <message>
        <source>copy it again</source>
        <translation>kopieren Sie es noch einmal</translation>
    </message>
</context>
<context>
    <name>video.copy_chapter_again</name>
    <message>
        <source>copy it from the camera again: what follows it would get wrong times</source>
        <translation>kopieren Sie sie noch einmal von der Kamera: Was folgt, bekäme falsche Zeiten</translation>
    </message>
</context>
<context>
    <name>video.copy_from_camera</name>
    <message>
        <source>copy it from the camera again</source>
        <translation>kopieren Sie noch einmal von der Kamera</translation>
    </message>
</context>
<context>
    <name>video.copy_if_cut_short</name>
    <message>
        <source>copy it from the camera again if it was cut short</source>
        <translation>kopieren Sie noch einmal von der Kamera, wenn etwas abgeschnitten wurde</translation>
    </message>
</context>
<context>
    <name>video.cut_chapter_there</name>
    <message>
        <source>cut it there, and give both parts</source>
        <translation>trennen Sie sie dort und geben Sie beide Teile an</translation>
    </message>
</context>
<context>
    <name>video.data_damaged</name>
    <message>
        <source>its data are damaged</source>
        <translation>die Daten sind beschädigt</translation>
    </message>
</context>
<context>
    <name>video.decoder_not_started</name>
    <message>
        <source>its decoder did not start (%1)</source>
        <translation>der Decoder startet nicht (%1)</translation>
    </message>
</context>
<context>
    <name>video.each_at_its_time</name>
    <message>
        <source>each frame keeps its own time</source>
        <translation>jedes zählt zu seiner eigenen Zeit</translation>
    </message>
</context>
<context>
    <name>video.encoder_not_started</name>
    <message>
        <source>the encoder did not start (%1)</source>
        <translation>der Encoder startet nicht (%1)</translation>
    </message>
</context>
<context>
    <name>video.ends_early</name>
    <message>
        <source>ends early at %1</source>
        <translation>endet vorzeitig bei %1</translation>
    </message>
</context>
<context>
    <name>video.failed_before</name>
    <message>
        <source>writing failed earlier</source>
        <translation>das Schreiben ist schon vorher misslungen</translation>
    </message>
</context>
<context>
    <name>video.file_not_read</name>
    <message>
        <source>the file could not be read</source>
        <translation>die Datei konnte nicht gelesen werden</translation>
    </message>
</context>
<context>
    <name>video.format_differs</name>
    <message>
        <source>its format differs from the video&apos;s</source>
        <translation>das Format ist ein anderes als das des Videos</translation>
    </message>
</context>
<context>
    <name>video.frame_left_out</name>
    <message>
        <source>it is left out</source>
        <translation>wird weggelassen</translation>
    </message>
</context>
<context>
    <name>video.frames_it_has</name>
    <message>
        <source>it has frames 0 to %1</source>
        <translation>es hat die Bilder 0 bis %1</translation>
    </message>
</context>
<context>
    <name>video.frames_left_out</name>
    <message>
        <source>%1 frames left out</source>
        <translation>%1 Bilder weggelassen</translation>
    </message>
</context>
<context>
    <name>video.frames_not_encodable</name>
    <message>
        <source>frames of this size or chroma format cannot be encoded</source>
        <translation>Bilder dieser Größe oder dieses Farbformats können nicht kodiert werden</translation>
    </message>
</context>
<context>
    <name>video.give_another_format</name>
    <message>
        <source>set the camera to another format</source>
        <translation>lassen Sie die Kamera ein anderes Format liefern</translation>
    </message>
</context>
<context>
    <name>video.give_as_images</name>
    <message>
        <source>give images as a folder, with their rate</source>
        <translation>geben Sie Einzelbilder als Ordner an, mit ihrer Rate</translation>
    </message>
</context>
<context>
    <name>video.give_camera_file</name>
    <message>
        <source>give the file that the camera recorded</source>
        <translation>geben Sie die Datei an, die die Kamera aufgenommen hat</translation>
    </message>
</context>
<context>
    <name>video.give_chapter_of_camera</name>
    <message>
        <source>give the file as the camera wrote it</source>
        <translation>geben Sie die Datei an, wie die Kamera sie geschrieben hat</translation>
    </message>
</context>
<context>
    <name>video.give_container</name>
    <message>
        <source>give an MP4, MOV, MKV or AVI file</source>
        <translation>geben Sie eine MP4-, MOV-, MKV- oder AVI-Datei an</translation>
    </message>
</context>
<context>
    <name>video.give_known_ending</name>
    <message>
        <source>give it one of these endings</source>
        <translation>geben Sie ihm eine dieser Endungen</translation>
    </message>
</context>
<context>
    <name>video.give_rate</name>
    <message>
        <source>give the frames per second, e.g. 30</source>
        <translation>geben Sie die Bilder je Sekunde an, z. B. 30</translation>
    </message>
</context>
<context>
    <name>video.give_shorter_clip</name>
    <message>
        <source>give a shorter clip</source>
        <translation>geben Sie einen kürzeren Clip an</translation>
    </message>
</context>
<context>
    <name>video.h264_needs_even</name>
    <message>
        <source>H.264 needs an even width and height, not %1</source>
        <translation>H.264 braucht gerade Breite und Höhe, nicht %1</translation>
    </message>
</context>
<context>
    <name>video.header_not_rewritten</name>
    <message>
        <source>its header could not be rewritten</source>
        <translation>die Kopfdaten konnten nicht neu geschrieben werden</translation>
    </message>
</context>
<context>
    <name>video.header_promises</name>
    <message>
        <source>its header promises %1</source>
        <translation>die Kopfdaten versprechen %1</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_kind</name>
    <message>
        <source>it is not an upright JPEG in colour as the first, &apos;%1&apos;, is</source>
        <translation>es ist kein aufrechtes JPEG in Farbe wie das erste, &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_layout</name>
    <message>
        <source>its colours are stored in another way than those of the first, &apos;%1&apos;</source>
        <translation>die Farben sind anders gespeichert als die des ersten, &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_size</name>
    <message>
        <source>its size is %1, that of the first, &apos;%2&apos;, is %3</source>
        <translation>es hat %1, das erste, &apos;%2&apos;, hat %3</translation>
    </message>
</context>
<context>
    <name>video.install_libavcodec</name>
    <message>
        <source>install Debian&apos;s libavcodec</source>
        <translation>installieren Sie Debians libavcodec</translation>
    </message>
</context>
<context>
    <name>video.install_libx264</name>
    <message>
        <source>install Debian&apos;s libavcodec with libx264</source>
        <translation>installieren Sie Debians libavcodec mit libx264</translation>
    </message>
</context>
<context>
    <name>video.is_finished</name>
    <message>
        <source>it is finished</source>
        <translation>es ist abgeschlossen</translation>
    </message>
</context>
<context>
    <name>video.join_one_recording</name>
    <message>
        <source>join only the files into which a camera has split one recording</source>
        <translation>verbinden Sie nur Dateien, in die eine Kamera eine einzige Aufnahme geteilt hat</translation>
    </message>
</context>
<context>
    <name>video.joining_chapters</name>
    <message>
        <source>joining &apos;%1&apos;</source>
        <translation>&apos;%1&apos; wird verbunden</translation>
    </message>
</context>
<context>
    <name>video.largest_picture</name>
    <message>
        <source>the limit is 50 megapixels and 32000 pixels a side</source>
        <translation>mehr als 50 Megapixel oder 32000 Pixel je Seite werden nicht gelesen</translation>
    </message>
</context>
<context>
    <name>video.leave_out_image</name>
    <message>
        <source>leave it out, or convert all of them in the same way</source>
        <translation>lassen Sie es weg oder wandeln Sie alle auf dieselbe Art um</translation>
    </message>
</context>
<context>
    <name>video.make_smaller</name>
    <message>
        <source>make it smaller</source>
        <translation>machen Sie es kleiner</translation>
    </message>
</context>
<context>
    <name>video.name_a_picture</name>
    <message>
        <source>choose an image</source>
        <translation>nennen Sie ein Bild</translation>
    </message>
</context>
<context>
    <name>video.no_decoder</name>
    <message>
        <source>there is no decoder for %1</source>
        <translation>es gibt keinen Decoder für %1</translation>
    </message>
</context>
<context>
    <name>video.no_encoder</name>
    <message>
        <source>the installed libavcodec has no encoder for it</source>
        <translation>das installierte libavcodec hat keinen Encoder dafür</translation>
    </message>
</context>
<context>
    <name>video.no_ffv1_in_mp4</name>
    <message>
        <source>MP4 cannot contain FFV1</source>
        <translation>FFV1 passt nicht in MP4</translation>
    </message>
</context>
<context>
    <name>video.no_frame_written</name>
    <message>
        <source>no frame was written to it</source>
        <translation>kein Bild wurde hineingeschrieben</translation>
    </message>
</context>
<context>
    <name>video.no_jpeg_layout</name>
    <message>
        <source>JPEG does not support its colour layout</source>
        <translation>diese Anordnung der Farben kennt JPEG nicht</translation>
    </message>
</context>
<context>
    <name>video.no_known_ending</name>
    <message>
        <source>its name ends with neither .mkv nor .mp4</source>
        <translation>der Name endet weder auf .mkv noch auf .mp4</translation>
    </message>
</context>
<context>
    <name>video.no_picture_format</name>
    <message>
        <source>it is not a PNG, JPEG, TIFF, HEIC, WebP, BMP or PNM image</source>
        <translation>es ist kein PNG-, JPEG-, TIFF-, HEIC-, WebP-, BMP- oder PNM-Bild</translation>
    </message>
</context>
<context>
    <name>video.no_sound</name>
    <message>
        <source>it has no sound</source>
        <translation>er hat keinen Ton</translation>
    </message>
</context>
<context>
    <name>video.no_stream</name>
    <message>
        <source>it contains no readable video stream</source>
        <translation>kein lesbarer Videostrom ist darin</translation>
    </message>
</context>
<context>
    <name>video.no_time_scale</name>
    <message>
        <source>its time scale was not found where the muxer should have put it</source>
        <translation>die Zeitskala fehlt an der Stelle, an die der Muxer sie schreiben sollte</translation>
    </message>
</context>
<context>
    <name>video.no_time_stamps</name>
    <message>
        <source>the file has no time stamps</source>
        <translation>die Datei hat keine Zeitstempel</translation>
    </message>
</context>
<context>
    <name>video.no_video_kind</name>
    <message>
        <source>it is not a supported kind of video, or its header is damaged or missing (%1)</source>
        <translation>es ist kein Video lesbarer Art, oder sein Kopf ist beschädigt oder fehlt (%1)</translation>
    </message>
</context>
<context>
    <name>video.no_whole_frame</name>
    <message>
        <source>it contains no complete frame</source>
        <translation>darin ist kein einziges ganzes Bild</translation>
    </message>
</context>
<context>
    <name>video.of_chapter</name>
    <message>
        <source>video &apos;%1&apos;</source>
        <translation>Video &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.packet_damaged</name>
    <message>
        <source>a packet is damaged</source>
        <translation>ein Paket dort ist beschädigt</translation>
    </message>
</context>
<context>
    <name>video.picture</name>
    <message>
        <source>image</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>video.picture_claims_size</name>
    <message>
        <source>its header says that it has %1 pixels</source>
        <translation>darin steht, dass es %1 Pixel sind</translation>
    </message>
</context>
<context>
    <name>video.picture_damaged</name>
    <message>
        <source>its content is damaged or cut short</source>
        <translation>der Inhalt ist beschädigt oder abgeschnitten</translation>
    </message>
</context>
<context>
    <name>video.picture_file_too_large</name>
    <message>
        <source>the file is larger than 200 MB</source>
        <translation>die Datei ist größer als 200 MB</translation>
    </message>
</context>
<context>
    <name>video.picture_format_unknown</name>
    <message>
        <source>its format is unknown</source>
        <translation>das Format ist nicht bekannt</translation>
    </message>
</context>
<context>
    <name>video.picture_named</name>
    <message>
        <source>image &apos;%1&apos;</source>
        <translation>Bild &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.picture_not_coded</name>
    <message>
        <source>a frame cannot be encoded</source>
        <translation>ein Bild kann nicht kodiert werden</translation>
    </message>
</context>
<context>
    <name>video.picture_not_packed</name>
    <message>
        <source>it could not be compressed</source>
        <translation>das Bild konnte nicht gepackt werden</translation>
    </message>
</context>
<context>
    <name>video.pictures_too_large</name>
    <message>
        <source>its frames have more than 100 megapixels or 32000 pixels a side</source>
        <translation>die Bilder haben mehr als 100 Megapixel oder 32000 Pixel je Seite</translation>
    </message>
</context>
<context>
    <name>video.pixel_format_not_read</name>
    <message>
        <source>its pixel format %1 is not supported</source>
        <translation>das Pixelformat %1 wird nicht gelesen</translation>
    </message>
</context>
<context>
    <name>video.put_into_mp4</name>
    <message>
        <source>put each file into MP4 first, e.g. ffmpeg -i FILE -c copy NEW.mp4</source>
        <translation>bringen Sie erst jede Datei in MP4, z. B. ffmpeg -i FILE -c copy NEW.mp4</translation>
    </message>
</context>
<context>
    <name>video.rate_not_positive</name>
    <message>
        <source>its frame rate is not positive</source>
        <translation>die Bildrate ist nicht positiv</translation>
    </message>
</context>
<context>
    <name>video.rate_varies</name>
    <message>
        <source>its frame rate varies: frames are %1 to %2 apart</source>
        <translation>seine Bildrate schwankt, die Bilder liegen %1 bis %2 auseinander</translation>
    </message>
</context>
<context>
    <name>video.reading_chapter</name>
    <message>
        <source>reading &apos;%1&apos;</source>
        <translation>&apos;%1&apos; wird gelesen</translation>
    </message>
</context>
<context>
    <name>video.record_with_sound</name>
    <message>
        <source>switch the camera&apos;s sound on</source>
        <translation>schalten Sie den Ton der Kamera ein</translation>
    </message>
</context>
<context>
    <name>video.report_bug</name>
    <message>
        <source>report this as a bug</source>
        <translation>melden Sie dies als Fehler</translation>
    </message>
</context>
<context>
    <name>video.siting_not_set</name>
    <message>
        <source>the chroma siting could not be set (%1)</source>
        <translation>die Lage der Farbwerte konnte nicht gesetzt werden (%1)</translation>
    </message>
</context>
<context>
    <name>video.size_not_found</name>
    <message>
        <source>its frame size could not be determined</source>
        <translation>die Größe der Bilder ließ sich nicht feststellen</translation>
    </message>
</context>
<context>
    <name>video.sound_left_out</name>
    <message>
        <source>the sound was left out, because the files it is joined with have none or another kind of it</source>
        <translation>der Ton wurde weggelassen, weil die Dateien, mit denen sie verbunden ist, keinen oder einen anderen haben</translation>
    </message>
</context>
<context>
    <name>video.sound_part_used</name>
    <message>
        <source>its undamaged part is used</source>
        <translation>verwendet wird der unbeschädigte Teil</translation>
    </message>
</context>
<context>
    <name>video.sound_too_long</name>
    <message>
        <source>its sound is longer than %1</source>
        <translation>sein Ton ist länger als %1</translation>
    </message>
</context>
<context>
    <name>video.stamps_repeat</name>
    <message>
        <source>their time stamps repeat that of the frame before</source>
        <translation>ihre Zeitstempel wiederholen den des Bilds davor</translation>
    </message>
</context>
<context>
    <name>video.stamps_span</name>
    <message>
        <source>its time stamps span %1</source>
        <translation>die Zeitstempel umfassen %1</translation>
    </message>
</context>
<context>
    <name>video.start_it_again</name>
    <message>
        <source>start it again</source>
        <translation>beginnen Sie es neu</translation>
    </message>
</context>
<context>
    <name>video.start_video_again</name>
    <message>
        <source>start the video again</source>
        <translation>beginnen Sie das Video neu</translation>
    </message>
</context>
<context>
    <name>video.taking_image</name>
    <message>
        <source>taking image %1 of %2</source>
        <translation>Bild %1 von %2 wird übernommen</translation>
    </message>
</context>
<context>
    <name>video.time_not_after</name>
    <message>
        <source>its time is not later than that of the frame before</source>
        <translation>die Zeit liegt nicht nach der des Bilds davor</translation>
    </message>
</context>
<context>
    <name>video.unknown_format_not_read</name>
    <message>
        <source>its pixel format (unknown) is not supported</source>
        <translation>das (unbekannte) Pixelformat wird nicht gelesen</translation>
    </message>
</context>
<context>
    <name>video.use_another_picture</name>
    <message>
        <source>use another image</source>
        <translation>verwenden Sie ein anderes Bild</translation>
    </message>
</context>
<context>
    <name>video.use_mjpeg</name>
    <message>
        <source>use MJPEG or FFV1, or another size</source>
        <translation>verwenden Sie MJPEG oder FFV1, oder eine andere Größe</translation>
    </message>
</context>
<context>
    <name>video.use_mkv</name>
    <message>
        <source>use the ending .mkv</source>
        <translation>verwenden Sie die Endung .mkv</translation>
    </message>
</context>
<context>
    <name>video.use_other_chroma</name>
    <message>
        <source>use 4:2:0, 4:2:2 or 4:4:4</source>
        <translation>verwenden Sie 4:2:0, 4:2:2 oder 4:4:4</translation>
    </message>
</context>
<context>
    <name>video.write_at_least_one</name>
    <message>
        <source>write at least one</source>
        <translation>schreiben Sie mindestens eines</translation>
    </message>
</context>
<context>
    <name>video.write_in_order</name>
    <message>
        <source>write the frames in order, at least a microsecond apart</source>
        <translation>schreiben Sie die Bilder der Reihe nach, mindestens eine Mikrosekunde auseinander</translation>
    </message>
</context>
<context>
    <name>video.write_one_format</name>
    <message>
        <source>write one format to a file</source>
        <translation>schreiben Sie in eine Datei ein Format</translation>
    </message>
</context>
<context>
    <name>workflow.accept_results</name>
    <message>
        <source>accept the results of %1</source>
        <translation>Ergebnisse von %1 akzeptieren</translation>
    </message>
</context>
<context>
    <name>workflow.accuracy_given</name>
    <message>
        <source>accurate to %1, as given</source>
        <translation>auf %1 genau, wie angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.add_layout_of_mat</name>
    <message>
        <source>add layout %1</source>
        <translation>Plan %1 hinzufügen</translation>
    </message>
</context>
<context>
    <name>workflow.add_robot</name>
    <message>
        <source>add one with: odograph robot add PROJECT NAME --colour #rrggbb</source>
        <translation>fügen Sie im Messplatz einen hinzu</translation>
    </message>
</context>
<context>
    <name>workflow.added_with_colour</name>
    <message>
        <source>it was added with the colour %1</source>
        <translation>er wurde mit der Farbe %1 aufgenommen</translation>
    </message>
</context>
<context>
    <name>workflow.address_of_live_positions</name>
    <message>
        <source>address &apos;%1&apos; of live positions</source>
        <translation>Adresse &apos;%1&apos; der Live-Orte</translation>
    </message>
</context>
<context>
    <name>workflow.analyse_it_again</name>
    <message>
        <source>reanalyse it</source>
        <translation>ihn neu auswerten</translation>
    </message>
</context>
<context>
    <name>workflow.analysing</name>
    <message>
        <source>analysing</source>
        <translation>Auswertung</translation>
    </message>
</context>
<context>
    <name>workflow.analysing_robot</name>
    <message>
        <source>analysing %1</source>
        <translation>%1 wird ausgewertet</translation>
    </message>
</context>
<context>
    <name>workflow.another_picture_size</name>
    <message>
        <source>its frames are %1, but the camera was registered at %2</source>
        <translation>ihre Bilder haben %1, aber die Kamera wurde bei %2 eingemessen</translation>
    </message>
</context>
<context>
    <name>workflow.assumed_lens</name>
    <message>
        <source>its lens was neither calibrated nor determined by the floor&apos;s markers</source>
        <translation>ihr Objektiv wurde weder kalibriert noch durch die Marker des Bodens bestimmt</translation>
    </message>
</context>
<context>
    <name>workflow.bad_is_not_accepted</name>
    <message>
        <source>bad results cannot be accepted (%1)</source>
        <translation>schlechte Ergebnisse können nicht akzeptiert werden (%1)</translation>
    </message>
</context>
<context>
    <name>workflow.beyond_limits</name>
    <message>
        <source>%1 of the samples exceed the limits of task &apos;%2&apos;, so the limits were ignored</source>
        <translation>%1 des Gemessenen liegen jenseits der Grenzwerte der Aufgabe &apos;%2&apos;, darum blieben diese außer Betracht</translation>
    </message>
</context>
<context>
    <name>workflow.board_in_no_picture</name>
    <message>
        <source>the board was found in none of %1 images (%2)</source>
        <translation>die Tafel wurde in keinem von %1 Bildern gefunden (%2)</translation>
    </message>
</context>
<context>
    <name>workflow.box_stands_in</name>
    <message>
        <source>the project has none, so a blue box of 260 mm × 190 mm × 60 mm is simulated</source>
        <translation>das Projekt hat keinen, daher wird ein blauer Quader von 260 mm × 190 mm × 60 mm simuliert</translation>
    </message>
</context>
<context>
    <name>workflow.by_layout_and_lens</name>
    <message>
        <source>layout &apos;%1&apos;, lens calibration %2</source>
        <translation>Plan &apos;%1&apos;, Objektiv der Kalibrierung %2</translation>
    </message>
</context>
<context>
    <name>workflow.by_layout_without_lens</name>
    <message>
        <source>layout &apos;%1&apos;, lens not calibrated</source>
        <translation>Plan &apos;%1&apos;, Objektiv nicht kalibriert</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_and_reanalyse</name>
    <message>
        <source>calibrate the lens, register the camera again and reanalyse</source>
        <translation>kalibrieren Sie das Objektiv, messen Sie die Kamera neu ein und werten Sie erneut aus</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_at_its_size</name>
    <message>
        <source>calibrate it at the size it records.</source>
        <translation>kalibrieren Sie sie bei der Größe, in der sie aufnimmt.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_camera</name>
    <message>
        <source>calibrate camera %1</source>
        <translation>Kamera %1 kalibrieren</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_if_touched</name>
    <message>
        <source>if zoom, focus or the camera&apos;s settings have changed since, calibrate it again.</source>
        <translation>wenn seither Zoom, Fokus oder Einstellungen der Kamera verändert wurden, kalibrieren Sie neu.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_it</name>
    <message>
        <source>calibrate it.</source>
        <translation>kalibrieren Sie es.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_lens_first</name>
    <message>
        <source>calibrate the lens first, or choose another calibration</source>
        <translation>kalibrieren Sie zuerst das Objektiv, oder setzen Sie eine andere Kalibrierung in Kraft</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_or_give_picture</name>
    <message>
        <source>calibrate it, import its intrinsics, or give an image or a video as well</source>
        <translation>sie kalibrieren, ihre Objektivkalibrierung importieren oder auch ein Bild oder Video angeben</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_or_import_trial</name>
    <message>
        <source>calibrate it, import its intrinsics, or import a trial with it first</source>
        <translation>kalibrieren Sie sie, importieren Sie ihre Objektivdaten, oder importieren Sie zuerst einen Versuch mit ihr</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_pair</name>
    <message>
        <source>calibrate cameras %1 and %2 as a pair</source>
        <translation>Kameras %1 und %2 als Paar kalibrieren</translation>
    </message>
</context>
<context>
    <name>workflow.calibrated_from_pictures</name>
    <message>
        <source>calibrated from %1 images</source>
        <translation>kalibriert aus %1 Bildern</translation>
    </message>
</context>
<context>
    <name>workflow.calibrating_camera</name>
    <message>
        <source>calibrating camera %1</source>
        <translation>Kamera %1 wird kalibriert</translation>
    </message>
</context>
<context>
    <name>workflow.calibration</name>
    <message>
        <source>calibration %1</source>
        <translation>Kalibrierung %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibration_of_camera</name>
    <message>
        <source>calibration of camera &apos;%1&apos;</source>
        <translation>Kalibrierung der Kamera &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.calibration_picture</name>
    <message>
        <source>calibration image &apos;%1&apos;</source>
        <translation>Kalibrierbild &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.camera</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>Kamera &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.camera_gave_no_picture</name>
    <message>
        <source>camera &apos;%1&apos; delivered no frame</source>
        <translation>Kamera &apos;%1&apos; lieferte kein Bild</translation>
    </message>
</context>
<context>
    <name>workflow.camera_given_twice</name>
    <message>
        <source>camera &apos;%1&apos; or its address &apos;%2&apos; was given twice</source>
        <translation>Kamera &apos;%1&apos; oder ihre Adresse &apos;%2&apos; wurde zweimal angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.camera_given_two_videos</name>
    <message>
        <source>camera &apos;%1&apos; was given two videos</source>
        <translation>für Kamera &apos;%1&apos; wurden zwei Videos angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.camera_moved_during</name>
    <message>
        <source>the camera moved by %1 after %2; what it saw from then on was not measured</source>
        <translation>die Kamera hat sich nach %2 um %1 bewegt; was sie von da an sah, wurde nicht gemessen</translation>
    </message>
</context>
<context>
    <name>workflow.camera_not_on_floor</name>
    <message>
        <source>camera &apos;%1&apos; is not registered to the floor</source>
        <translation>Kamera &apos;%1&apos; ist nicht eingemessen</translation>
    </message>
</context>
<context>
    <name>workflow.camera_not_registered</name>
    <message>
        <source>camera &apos;%1&apos; is not registered</source>
        <translation>Kamera &apos;%1&apos; ist nicht eingemessen</translation>
    </message>
</context>
<context>
    <name>workflow.camera_sees_too_little</name>
    <message>
        <source>the camera sees too little of the floor between the markers for a run</source>
        <translation>die Kamera sieht zu wenig vom Boden zwischen den Markern für eine Fahrt</translation>
    </message>
</context>
<context>
    <name>workflow.cameras_given_one_file</name>
    <message>
        <source>cameras &apos;%1&apos; and &apos;%2&apos; were given the same file, &apos;%3&apos;</source>
        <translation>die Kameras „%1“ und „%2“ bekamen dieselbe Datei, „%3“</translation>
    </message>
</context>
<context>
    <name>workflow.cameras_share_too_little</name>
    <message>
        <source>no two cameras share enough of the floor between the markers for a run</source>
        <translation>keine zwei Kameras sehen gemeinsam genug vom Boden zwischen den Markern für eine Fahrt</translation>
    </message>
</context>
<context>
    <name>workflow.cause_camera_moved</name>
    <message>
        <source>camera %1 seems to have moved by %2 since its registration</source>
        <translation>Kamera %1 scheint sich seit ihrem Einmessen um %2 bewegt zu haben</translation>
    </message>
</context>
<context>
    <name>workflow.cause_camera_moved_at</name>
    <message>
        <source>camera %1 seems to have moved by %2 at %3</source>
        <translation>Kamera %1 scheint sich bei %3 um %2 bewegt zu haben</translation>
    </message>
</context>
<context>
    <name>workflow.cause_cameras_moved</name>
    <message>
        <source>cameras %1 and %2 seem to have moved since their registration</source>
        <translation>die Kameras %1 und %2 scheinen sich seit ihrem Einmessen bewegt zu haben</translation>
    </message>
</context>
<context>
    <name>workflow.cause_clock_rate</name>
    <message>
        <source>the time offset of view %1 seems to change by %2 in each second</source>
        <translation>der Zeitversatz der Sicht %1 scheint sich in jeder Sekunde um %2 zu ändern</translation>
    </message>
</context>
<context>
    <name>workflow.cause_height</name>
    <message>
        <source>the height given for the robot seems wrong by about %1</source>
        <translation>die für den Roboter angegebene Höhe scheint um etwa %1 falsch zu sein</translation>
    </message>
</context>
<context>
    <name>workflow.cause_offset</name>
    <message>
        <source>the time offset of view %1 seems wrong by %2</source>
        <translation>der Zeitversatz der Sicht %1 scheint um %2 falsch zu sein</translation>
    </message>
</context>
<context>
    <name>workflow.cause_or_cause</name>
    <message>
        <source>%1, or %2</source>
        <translation>%1, oder %2</translation>
    </message>
</context>
<context>
    <name>workflow.certificate</name>
    <message>
        <source>certificate</source>
        <translation>Zertifikat</translation>
    </message>
</context>
<context>
    <name>workflow.change_guidance</name>
    <message>
        <source>change the guidance of %1</source>
        <translation>die Vorgaben für %1 ändern</translation>
    </message>
</context>
<context>
    <name>workflow.changed_in_file</name>
    <message>
        <source>they were changed in the file</source>
        <translation>sie wurden in der Datei geändert</translation>
    </message>
</context>
<context>
    <name>workflow.chapter_missing</name>
    <message>
        <source>by their names a file is missing between &apos;%1&apos; and &apos;%2&apos;; if so, all times behind it are wrong</source>
        <translation>nach ihren Namen fehlt eine Datei zwischen &apos;%1&apos; und &apos;%2&apos;; wenn das so ist, sind alle Zeiten dahinter falsch</translation>
    </message>
</context>
<context>
    <name>workflow.chapter_twice</name>
    <message>
        <source>&apos;%1&apos; is given twice</source>
        <translation>&apos;%1&apos; ist zweimal angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.chapters_out_of_order</name>
    <message>
        <source>by their names &apos;%1&apos; comes before &apos;%2&apos;, and was joined behind it; check the order of the files</source>
        <translation>nach ihren Namen kommt &apos;%1&apos; vor &apos;%2&apos; und wurde dahinter gesetzt; prüfen Sie die Reihenfolge der Dateien</translation>
    </message>
</context>
<context>
    <name>workflow.check_cable_and_bandwidth</name>
    <message>
        <source>check the cable, the bandwidth and what else this computer is doing</source>
        <translation>prüfen Sie Kabel, Bandbreite und was dieser Rechner sonst tut</translation>
    </message>
</context>
<context>
    <name>workflow.check_files_and_offset</name>
    <message>
        <source>check the files and the --sync offset</source>
        <translation>prüfen Sie die Dateien und den Versatz</translation>
    </message>
</context>
<context>
    <name>workflow.check_it_is_connected</name>
    <message>
        <source>check that it is connected and not used by another program</source>
        <translation>prüfen Sie, ob sie angeschlossen ist und kein anderes Programm sie benutzt</translation>
    </message>
</context>
<context>
    <name>workflow.check_its_cable</name>
    <message>
        <source>check its cable, and whether another program uses it</source>
        <translation>prüfen Sie ihr Kabel, und ob ein anderes Programm sie benutzt</translation>
    </message>
</context>
<context>
    <name>workflow.check_line_is</name>
    <message>
        <source>its check line is 1000 or 200 mm long; no print is off by so much</source>
        <translation>ihre Prüflinie ist 1000 oder 200 mm lang; so weit daneben liegt kein Druck</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_analyse_again</name>
    <message>
        <source>run odograph check, or reanalyse the trial</source>
        <translation>prüfen Sie das Projekt, oder werten Sie den Versuch noch einmal aus</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_register_again</name>
    <message>
        <source>check that the camera has not moved, or register it again.</source>
        <translation>prüfen Sie, dass sich die Kamera nicht bewegt hat, oder messen Sie sie neu ein.</translation>
    </message>
</context>
<context>
    <name>workflow.check_rate</name>
    <message>
        <source>views are matched by time: check --rate if one is in slow motion</source>
        <translation>die Sichten werden über die Zeit verbunden; prüfen Sie die wahre Bildrate, falls eine in Zeitlupe ist</translation>
    </message>
</context>
<context>
    <name>workflow.check_robot_and_registration</name>
    <message>
        <source>check the robot&apos;s colour and size, and the registrations</source>
        <translation>prüfen Sie Farbe und Größe des Roboters und die Einmessungen</translation>
    </message>
</context>
<context>
    <name>workflow.check_they_are_connected</name>
    <message>
        <source>check that they are connected and not used by another program</source>
        <translation>prüfen Sie, ob sie angeschlossen sind und kein anderes Programm sie benutzt</translation>
    </message>
</context>
<context>
    <name>workflow.check_views_of_one_run</name>
    <message>
        <source>only one view measures the rest, so check that both belong to one run</source>
        <translation>außerhalb misst nur eine Sicht; prüfen Sie, ob beide zu einer Fahrt gehören</translation>
    </message>
</context>
<context>
    <name>workflow.check_whether_moved</name>
    <message>
        <source>check whether camera %1 has moved</source>
        <translation>prüfen, ob sich Kamera %1 bewegt hat</translation>
    </message>
</context>
<context>
    <name>workflow.checking_trials</name>
    <message>
        <source>checks of the trials</source>
        <translation>Prüfung der Versuche</translation>
    </message>
</context>
<context>
    <name>workflow.choose_another_one</name>
    <message>
        <source>choose another one</source>
        <translation>wählen Sie einen anderen</translation>
    </message>
</context>
<context>
    <name>workflow.choose_calibration</name>
    <message>
        <source>choose calibration %1 of camera %2</source>
        <translation>Kalibrierung %1 der Kamera %2 wählen</translation>
    </message>
</context>
<context>
    <name>workflow.choose_folder_for_demo</name>
    <message>
        <source>choose a folder you can write to, with 300 MB free</source>
        <translation>wählen Sie einen beschreibbaren Ordner mit 300 MB Platz</translation>
    </message>
</context>
<context>
    <name>workflow.choose_folder_of_copies</name>
    <message>
        <source>choose the folder where they were copied to</source>
        <translation>wählen Sie den Ordner, in den sie kopiert wurden</translation>
    </message>
</context>
<context>
    <name>workflow.choose_frame</name>
    <message>
        <source>choose one from %1 to %2</source>
        <translation>wählen Sie eines von %1 bis %2</translation>
    </message>
</context>
<context>
    <name>workflow.choose_interface</name>
    <message>
        <source>choose one that `ip link` lists, or lo to stay on this computer</source>
        <translation>wählen Sie eine, die `ip link` nennt, oder lo, um auf diesem Rechner zu bleiben</translation>
    </message>
</context>
<context>
    <name>workflow.choose_measured_frame</name>
    <message>
        <source>choose a frame with a measurement</source>
        <translation>wählen Sie ein Bild mit einer Messung</translation>
    </message>
</context>
<context>
    <name>workflow.choose_metric</name>
    <message>
        <source>choose from %1</source>
        <translation>wählen Sie aus %1</translation>
    </message>
</context>
<context>
    <name>workflow.choose_one_of_them</name>
    <message>
        <source>choose one of them</source>
        <translation>wählen Sie einen davon</translation>
    </message>
</context>
<context>
    <name>workflow.choose_other_group</name>
    <message>
        <source>choose other times or another reason</source>
        <translation>wählen Sie andere Zeiten oder einen anderen Grund</translation>
    </message>
</context>
<context>
    <name>workflow.choose_other_range</name>
    <message>
        <source>choose another range</source>
        <translation>wählen Sie einen anderen Bereich</translation>
    </message>
</context>
<context>
    <name>workflow.choose_range_within</name>
    <message>
        <source>choose a range from 0 to %1</source>
        <translation>wählen Sie einen Bereich von 0 bis %1</translation>
    </message>
</context>
<context>
    <name>workflow.choose_registration</name>
    <message>
        <source>choose registration %1 of camera %2</source>
        <translation>Einmessung %1 der Kamera %2 wählen</translation>
    </message>
</context>
<context>
    <name>workflow.choose_robot_of_trial</name>
    <message>
        <source>choose a robot of the trial</source>
        <translation>wählen Sie einen Roboter des Versuchs</translation>
    </message>
</context>
<context>
    <name>workflow.choose_run_on_layout</name>
    <message>
        <source>choose a run on the same layout</source>
        <translation>einen Lauf auf derselben Anordnung wählen</translation>
    </message>
</context>
<context>
    <name>workflow.choose_seen_task</name>
    <message>
        <source>choose a task on the floor that they see, or leave the task out</source>
        <translation>wählen Sie eine Aufgabe auf dem Boden, den sie sehen, oder lassen Sie die Aufgabe weg</translation>
    </message>
</context>
<context>
    <name>workflow.choose_task_with_course</name>
    <message>
        <source>choose a task that has, or leave the task out</source>
        <translation>wählen Sie eine Aufgabe, die das hat, oder lassen Sie die Aufgabe weg</translation>
    </message>
</context>
<context>
    <name>workflow.choose_time</name>
    <message>
        <source>choose a time from %1 to %2</source>
        <translation>wählen Sie eine Zeit von %1 bis %2</translation>
    </message>
</context>
<context>
    <name>workflow.choose_trial_of_views</name>
    <message>
        <source>choose a trial of two views or more</source>
        <translation>einen Versuch mit mindestens zwei Sichten wählen</translation>
    </message>
</context>
<context>
    <name>workflow.choose_with_robot</name>
    <message>
        <source>choose one with --robot</source>
        <translation>wählen Sie einen davon</translation>
    </message>
</context>
<context>
    <name>workflow.class_without_team</name>
    <message>
        <source>without a team it belongs to no class</source>
        <translation>ohne Team gehört er zu keiner Klasse</translation>
    </message>
</context>
<context>
    <name>workflow.clear_range</name>
    <message>
        <source>remove the range of %1</source>
        <translation>Bereich von %1 aufheben</translation>
    </message>
</context>
<context>
    <name>workflow.clock_jumped</name>
    <message>
        <source>at %1 the clock jumped ahead by %2; later times were corrected</source>
        <translation>bei %1 sprang die Uhr um %2 vor; spätere Zeiten wurden berichtigt</translation>
    </message>
</context>
<context>
    <name>workflow.clock_restarts</name>
    <message>
        <source>its time stamps begin again or stand still after %1: two files were joined, or the camera&apos;s clock was reset</source>
        <translation>ihre Zeitstempel beginnen nach %1 von vorn oder bleiben stehen: Zwei Dateien wurden verbunden, oder die Uhr der Kamera wurde zurückgesetzt</translation>
    </message>
</context>
<context>
    <name>workflow.clocks_differ</name>
    <message>
        <source>the clocks of views &apos;%1&apos; and &apos;%2&apos; differ by %3; speeds and times are by the clock of view &apos;%1&apos;</source>
        <translation>die Uhren der Ansichten „%1“ und „%2“ weichen um %3 voneinander ab; Geschwindigkeiten und Zeiten folgen der Uhr der Ansicht „%1“</translation>
    </message>
</context>
<context>
    <name>workflow.compared_with_itself</name>
    <message>
        <source>a run cannot be compared with itself</source>
        <translation>eine Fahrt kann nicht mit sich selbst verglichen werden</translation>
    </message>
</context>
<context>
    <name>workflow.comparison_of_trial</name>
    <message>
        <source>comparison of trial &apos;%1&apos;</source>
        <translation>Vergleich des Versuchs &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.complete_trial</name>
    <message>
        <source>complete %1, whose recording was cut off</source>
        <translation>%1 vervollständigen, dessen Aufnahme abgebrochen wurde</translation>
    </message>
</context>
<context>
    <name>workflow.completing_recording</name>
    <message>
        <source>completing a recording that was cut off</source>
        <translation>eine abgebrochene Aufnahme wird vervollständigt</translation>
    </message>
</context>
<context>
    <name>workflow.completing_recordings</name>
    <message>
        <source>completing the recordings</source>
        <translation>Vervollständigen der Aufnahmen</translation>
    </message>
</context>
<context>
    <name>workflow.computing_intrinsics</name>
    <message>
        <source>computing the intrinsics</source>
        <translation>Objektivdaten werden berechnet</translation>
    </message>
</context>
<context>
    <name>workflow.computing_pair</name>
    <message>
        <source>computing the relative position</source>
        <translation>die relative Lage wird berechnet</translation>
    </message>
</context>
<context>
    <name>workflow.copied_while_recorded</name>
    <message>
        <source>its recording has not ended</source>
        <translation>seine Aufnahme ist noch nicht beendet</translation>
    </message>
</context>
<context>
    <name>workflow.copy_file_again</name>
    <message>
        <source>copy the file from the camera again</source>
        <translation>kopieren Sie die Datei noch einmal von der Kamera</translation>
    </message>
</context>
<context>
    <name>workflow.copy_of</name>
    <message>
        <source>copy of &apos;%1&apos;</source>
        <translation>Kopie von &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.copy_trial</name>
    <message>
        <source>copy trial %1 to %2</source>
        <translation>Versuch %1 nach %2 kopieren</translation>
    </message>
</context>
<context>
    <name>workflow.copying_project</name>
    <message>
        <source>copying the project</source>
        <translation>Projekt wird kopiert</translation>
    </message>
</context>
<context>
    <name>workflow.corner_off_frame</name>
    <message>
        <source>a corner is outside the frame</source>
        <translation>eine Ecke liegt außerhalb des Bildes</translation>
    </message>
</context>
<context>
    <name>workflow.correct_by_hand</name>
    <message>
        <source>correct %1 by hand</source>
        <translation>%1 von Hand korrigieren</translation>
    </message>
</context>
<context>
    <name>workflow.course_not_seen</name>
    <message>
        <source>the cameras see only %1 of the course of task &apos;%2&apos;</source>
        <translation>die Kameras sehen nur %1 der Strecke der Aufgabe &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.course_of_task</name>
    <message>
        <source>course of task &apos;%1&apos;</source>
        <translation>Strecke der Aufgabe &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.course_seen_in_part</name>
    <message>
        <source>no camera sees %1 of the run whole</source>
        <translation>%1 der Fahrt sieht keine Kamera ganz</translation>
    </message>
</context>
<context>
    <name>workflow.cut_at_restart</name>
    <message>
        <source>cut it there, and import each part as its own trial</source>
        <translation>dort trennen und jeden Teil als eigenen Versuch importieren</translation>
    </message>
</context>
<context>
    <name>workflow.damaged_frames</name>
    <message>
        <source>%1 of its %2 frames, from %3 to %4, are damaged and were not measured</source>
        <translation>%1 ihrer %2 Bilder, von %3 bis %4, sind beschädigt und wurden nicht ausgewertet</translation>
    </message>
</context>
<context>
    <name>workflow.date_to_come</name>
    <message>
        <source>its new date is in the future</source>
        <translation>sein neues Datum liegt in der Zukunft</translation>
    </message>
</context>
<context>
    <name>workflow.demo</name>
    <message>
        <source>demo</source>
        <translation>Demo</translation>
    </message>
</context>
<context>
    <name>workflow.demo_in</name>
    <message>
        <source>demo in &apos;%1&apos;</source>
        <translation>Demo in &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.demo_is_there</name>
    <message>
        <source>%1 already exists</source>
        <translation>%1 gibt es schon</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_name</name>
    <message>
        <source>from %1 to %2 this may be %3 or %4</source>
        <translation>von %1 bis %2 ist zweifelhaft, ob dies %3 oder %4 ist</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_name_unknown</name>
    <message>
        <source>from %1 to %2 this may be %3 or another robot that looks the same</source>
        <translation>von %1 bis %2 ist zweifelhaft, ob dies %3 oder ein anderer Roboter dieses Aussehens ist</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_names</name>
    <message>
        <source>from %1 to %2 (the first of %3 times) this may be %4 or %5</source>
        <translation>von %1 bis %2 (das erste von %3 Malen) ist zweifelhaft, ob dies %4 oder %5 ist</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_names_unknown</name>
    <message>
        <source>from %1 to %2 (the first of %3 times) this may be %4 or another robot that looks the same</source>
        <translation>von %1 bis %2 (das erste von %3 Malen) ist zweifelhaft, ob dies %4 oder ein anderer Roboter dieses Aussehens ist</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_step</name>
    <message>
        <source>it is synchronised only to %1, which is %2 at 1 m/s</source>
        <translation>sie ist nur auf %1 synchron, das sind %2 bei 1 m/s</translation>
    </message>
</context>
<context>
    <name>workflow.edit_trial</name>
    <message>
        <source>edit trial %1</source>
        <translation>Versuch %1 bearbeiten</translation>
    </message>
</context>
<context>
    <name>workflow.edit_trials</name>
    <message>
        <source>edit %1 trials</source>
        <translation>%1 Versuche bearbeiten</translation>
    </message>
</context>
<context>
    <name>workflow.error_estimated</name>
    <message>
        <source>positions to %1, estimated from the track</source>
        <translation>Orte auf %1, aus ihnen geschätzt</translation>
    </message>
</context>
<context>
    <name>workflow.error_stated</name>
    <message>
        <source>positions to %1, as stated in the file</source>
        <translation>Orte auf %1, wie die Datei sagt</translation>
    </message>
</context>
<context>
    <name>workflow.evaluation_of_trial</name>
    <message>
        <source>evaluation of trial &apos;%1&apos;</source>
        <translation>Auswertung des Versuchs &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.export</name>
    <message>
        <source>export of &apos;%1&apos;</source>
        <translation>Export von &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.faster_disk_or_fewer_cameras</name>
    <message>
        <source>record to a faster disk, or fewer cameras at once</source>
        <translation>nehmen Sie auf eine schnellere Platte oder mit weniger Kameras zugleich auf</translation>
    </message>
</context>
<context>
    <name>workflow.file_given_twice</name>
    <message>
        <source>&apos;%1&apos; is given twice</source>
        <translation>„%1“ ist zweimal angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.file_of_another_size</name>
    <message>
        <source>its file has %1 bytes, but had %2 when it was added</source>
        <translation>ihre Datei hat %1 Byte, hatte beim Hinzufügen aber %2</translation>
    </message>
</context>
<context>
    <name>workflow.file_of_other_content</name>
    <message>
        <source>its file has changed since it was added</source>
        <translation>ihre Datei wurde seit dem Hinzufügen verändert</translation>
    </message>
</context>
<context>
    <name>workflow.file_without_picture</name>
    <message>
        <source>it contains no image</source>
        <translation>kein Bild ist darin</translation>
    </message>
</context>
<context>
    <name>workflow.film_progressive</name>
    <message>
        <source>choose a progressive mode of the camera (p, not i)</source>
        <translation>wählen Sie einen progressiven Modus der Kamera (p statt i)</translation>
    </message>
</context>
<context>
    <name>workflow.filmed_at_doubtful_rate</name>
    <message>
        <source>its file says that it was filmed at %1, but its time stamps mean %2</source>
        <translation>laut Datei wurde es mit %1 aufgenommen, aber seine Zeitstempel bedeuten %2</translation>
    </message>
</context>
<context>
    <name>workflow.filmed_at_rate</name>
    <message>
        <source>it was filmed at %1, as its file says, and plays at %2; its times are those of filming</source>
        <translation>laut Datei wurde es mit %1 aufgenommen und läuft mit %2; seine Zeiten sind die der Aufnahme</translation>
    </message>
</context>
<context>
    <name>workflow.first_label_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2, its file says %3, so speeds and times are wrong by %4</source>
        <translation>Ansicht „%1“ wurde mit %2 aufgenommen, ihre Datei nennt %3; Geschwindigkeiten und Zeiten sind daher um %4 falsch</translation>
    </message>
</context>
<context>
    <name>workflow.fitting_cameras_together</name>
    <message>
        <source>fitting %1 cameras jointly</source>
        <translation>%1 Kameras werden gemeinsam eingemessen</translation>
    </message>
</context>
<context>
    <name>workflow.fix_camera</name>
    <message>
        <source>fix the camera, register it again and repeat the run</source>
        <translation>befestigen Sie die Kamera, messen Sie sie erneut ein und wiederholen Sie den Lauf</translation>
    </message>
</context>
<context>
    <name>workflow.floor_has_its_colour</name>
    <message>
        <source>its colour %1 is also the floor&apos;s (%2 of the frame in view %3)</source>
        <translation>seine Farbe %1 ist auch die des Bodens (%2 des Bildes der Sicht %3)</translation>
    </message>
</context>
<context>
    <name>workflow.floor_mat</name>
    <message>
        <source>floor mat</source>
        <translation>Bodenmatte</translation>
    </message>
</context>
<context>
    <name>workflow.folder</name>
    <message>
        <source>folder &apos;%1&apos;</source>
        <translation>Ordner &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.frame_of_file</name>
    <message>
        <source>frame %1 of &apos;%2&apos;</source>
        <translation>Bild %1 von &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.frame_of_trial</name>
    <message>
        <source>frame %1 of trial &apos;%2&apos;</source>
        <translation>Bild %1 des Versuchs &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.frame_rate_of</name>
    <message>
        <source>frame rate of %1</source>
        <translation>Bildrate von %1</translation>
    </message>
</context>
<context>
    <name>workflow.frames_doubled</name>
    <message>
        <source>up to %1 frames repeat for %2; later times were corrected</source>
        <translation>bis %1 wiederholen sich Bilder %2 lang; spätere Zeiten wurden berichtigt</translation>
    </message>
</context>
<context>
    <name>workflow.frames_doubled_unseen</name>
    <message>
        <source>after %1 %2 frames repeat the one before, and its time stamps count them as time; later times were corrected</source>
        <translation>nach %1 wiederholen %2 Bilder das vorige, und die Zeitstempel zählen sie als Zeit; spätere Zeiten wurden berichtigt</translation>
    </message>
</context>
<context>
    <name>workflow.frames_frozen</name>
    <message>
        <source>after %1 %2 frames show the same image while the robot went on; they were not measured</source>
        <translation>nach %1 zeigen %2 Bilder dasselbe, während der Roboter weiterfuhr; sie wurden nicht ausgewertet</translation>
    </message>
</context>
<context>
    <name>workflow.frames_lost</name>
    <message>
        <source>after %1 the frames of %2 are missing, because the camera paused or lost them; later times were corrected</source>
        <translation>nach %1 fehlen die Bilder von %2, weil die Kamera pausierte oder sie verlor; spätere Zeiten wurden berichtigt</translation>
    </message>
</context>
<context>
    <name>workflow.frames_missing</name>
    <message>
        <source>%1 without a frame, where %2 is usual; frames are missing, or its time stamps jump</source>
        <translation>%1 ohne Bild, üblich sind %2; es fehlen Bilder, oder die Zeitstempel springen</translation>
    </message>
</context>
<context>
    <name>workflow.frames_missing_unseen</name>
    <message>
        <source>after %1 %2 frames are missing that its time stamps do not show: the robot moves too far; later times were corrected</source>
        <translation>nach %1 fehlen %2 Bilder, ohne dass die Zeitstempel es zeigen: Der Roboter kommt zu weit; spätere Zeiten wurden berichtigt</translation>
    </message>
</context>
<context>
    <name>workflow.frames_not_decoded</name>
    <message>
        <source>%1 of its %2 frames are damaged and were not measured</source>
        <translation>%1 ihrer %2 Bilder sind beschädigt und wurden nicht ausgewertet</translation>
    </message>
</context>
<context>
    <name>workflow.frames_without_board</name>
    <message>
        <source>%1 frames: %2</source>
        <translation>%1 Frames: %2</translation>
    </message>
</context>
<context>
    <name>workflow.give_another_file</name>
    <message>
        <source>give another file</source>
        <translation>geben Sie eine andere Datei an</translation>
    </message>
</context>
<context>
    <name>workflow.give_another_team</name>
    <message>
        <source>give another team, or change the class of this one</source>
        <translation>geben Sie ein anderes Team an, oder ändern Sie die Klasse von diesem</translation>
    </message>
</context>
<context>
    <name>workflow.give_camera_rate</name>
    <message>
        <source>give the rate at which the camera took the frames</source>
        <translation>geben Sie die Rate an, mit der die Kamera aufgenommen hat</translation>
    </message>
</context>
<context>
    <name>workflow.give_cameras</name>
    <message>
        <source>give one or more, like --camera A=sim:A</source>
        <translation>wählen Sie unter „Kameras…“ eine oder mehrere</translation>
    </message>
</context>
<context>
    <name>workflow.give_chapter_once</name>
    <message>
        <source>give each file once, in their order</source>
        <translation>geben Sie jede Datei einmal an, in ihrer Reihenfolge</translation>
    </message>
</context>
<context>
    <name>workflow.give_class_too</name>
    <message>
        <source>give its class too, or another team</source>
        <translation>geben Sie auch seine Klasse an, oder ein anderes Team</translation>
    </message>
</context>
<context>
    <name>workflow.give_date_of_run</name>
    <message>
        <source>give the date of the run</source>
        <translation>geben Sie das Datum der Fahrt an</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_file_once</name>
    <message>
        <source>give each file once, to its camera</source>
        <translation>geben Sie jede Datei einmal an, bei ihrer Kamera</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_frame_time</name>
    <message>
        <source>give one time for each frame</source>
        <translation>geben Sie für jedes Bild eine Zeit an</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_its_file</name>
    <message>
        <source>give each camera its own video</source>
        <translation>geben Sie jeder Kamera ihr eigenes Video</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_robot_one</name>
    <message>
        <source>give each robot one</source>
        <translation>geben Sie jedem Roboter eine</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_view_its_camera</name>
    <message>
        <source>give each view its own camera</source>
        <translation>geben Sie jeder Sicht ihre eigene Kamera</translation>
    </message>
</context>
<context>
    <name>workflow.give_height_below_camera</name>
    <message>
        <source>give a height below the camera</source>
        <translation>geben Sie eine Höhe unter der Kamera an</translation>
    </message>
</context>
<context>
    <name>workflow.give_limits_of_fastest</name>
    <message>
        <source>give the task the limits of its fastest robot</source>
        <translation>geben Sie der Aufgabe die Grenzwerte ihres schnellsten Roboters</translation>
    </message>
</context>
<context>
    <name>workflow.give_offset_for_each</name>
    <message>
        <source>give one offset for each view but the first, like --sync 0.1,0.2, or use --sync auto</source>
        <translation>geben Sie für jede Sicht außer der ersten einen Versatz an, oder wählen Sie „Aus der Bewegung oder einem Blitz“</translation>
    </message>
</context>
<context>
    <name>workflow.give_one_table</name>
    <message>
        <source>give one table for each view</source>
        <translation>geben Sie für jede Ansicht eine Tabelle an</translation>
    </message>
</context>
<context>
    <name>workflow.give_own_colours</name>
    <message>
        <source>give each its own colour</source>
        <translation>geben Sie jedem eine eigene Farbe</translation>
    </message>
</context>
<context>
    <name>workflow.give_picture_of_that_size</name>
    <message>
        <source>give an image of that size</source>
        <translation>geben Sie ein Bild dieser Größe an</translation>
    </message>
</context>
<context>
    <name>workflow.give_pixels_or_picture</name>
    <message>
        <source>give the markers&apos; pixels, or an image or a video of the floor</source>
        <translation>die Pixel der Marker oder ein Bild oder Video des Bodens angeben</translation>
    </message>
</context>
<context>
    <name>workflow.give_pre_roll</name>
    <message>
        <source>give a pre-roll of 0 to 10 seconds</source>
        <translation>geben Sie einen Vorlauf von 0 bis 10 Sekunden an</translation>
    </message>
</context>
<context>
    <name>workflow.give_range_in_seconds</name>
    <message>
        <source>give its start and end in seconds</source>
        <translation>geben Sie Anfang und Ende in Sekunden an</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_table</name>
    <message>
        <source>give one of them</source>
        <translation>geben Sie eins davon an</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_times</name>
    <message>
        <source>give their rate or a table of their times, like --rate 30 or --times A=stamps.csv</source>
        <translation>geben Sie die tatsächliche Rate der Kamera ein</translation>
    </message>
</context>
<context>
    <name>workflow.give_seconds</name>
    <message>
        <source>give the seconds, such as 10</source>
        <translation>geben Sie die Sekunden an, etwa 10</translation>
    </message>
</context>
<context>
    <name>workflow.give_start_first</name>
    <message>
        <source>give the start first, then a later end</source>
        <translation>geben Sie zuerst den Anfang an, dann ein späteres Ende</translation>
    </message>
</context>
<context>
    <name>workflow.give_table_of_times</name>
    <message>
        <source>give a table of their times, like --times A=stamps.csv</source>
        <translation>nummerieren Sie sie in Einerschritten</translation>
    </message>
</context>
<context>
    <name>workflow.give_task</name>
    <message>
        <source>give %1 the task %2</source>
        <translation>%1 die Aufgabe %2 geben</translation>
    </message>
</context>
<context>
    <name>workflow.give_team</name>
    <message>
        <source>assign %1 to team %2</source>
        <translation>%1 dem Team %2 zuordnen</translation>
    </message>
</context>
<context>
    <name>workflow.give_team_too</name>
    <message>
        <source>give it a team too</source>
        <translation>geben Sie auch ein Team an</translation>
    </message>
</context>
<context>
    <name>workflow.give_times_to_view</name>
    <message>
        <source>name the camera of one of the videos</source>
        <translation>nennen Sie die Kamera eines der Videos</translation>
    </message>
</context>
<context>
    <name>workflow.give_tracks</name>
    <message>
        <source>give one or more, like --track R=run.csv</source>
        <translation>wählen Sie eine oder mehrere</translation>
    </message>
</context>
<context>
    <name>workflow.give_views</name>
    <message>
        <source>give one view or more, like --video A=a.mp4</source>
        <translation>wählen Sie eine Sicht oder mehrere</translation>
    </message>
</context>
<context>
    <name>workflow.guidance_of_view</name>
    <message>
        <source>guidance in view &apos;%1&apos;</source>
        <translation>Vorgaben in Sicht „%1“</translation>
    </message>
</context>
<context>
    <name>workflow.hardly_found</name>
    <message>
        <source>it found robot &apos;%1&apos; in only %2 of the frames in which it should be visible, and the other positions are not checked by a second view</source>
        <translation>sie fand Roboter &apos;%1&apos; nur in %2 der Bilder, in denen er sichtbar sein müsste, und die anderen Positionen prüft keine zweite Sicht</translation>
    </message>
</context>
<context>
    <name>workflow.hardly_possible</name>
    <message>
        <source>a robot hardly moves at %1 with %2; check units and scale</source>
        <translation>ein Roboter bewegt sich kaum mit %1 und %2; prüfen Sie Einheiten und Maßstab</translation>
    </message>
</context>
<context>
    <name>workflow.has_no_two_views</name>
    <message>
        <source>it does not have two views</source>
        <translation>er hat keine zwei Sichten</translation>
    </message>
</context>
<context>
    <name>workflow.height_above_camera</name>
    <message>
        <source>it is only %1 above the floor, but the points would be at %2</source>
        <translation>sie ist nur %1 über dem Boden, aber die Punkte wären auf %2</translation>
    </message>
</context>
<context>
    <name>workflow.image_with_video</name>
    <message>
        <source>one is an image and the other a video</source>
        <translation>die eine ist ein Bild, die andere ein Video</translation>
    </message>
</context>
<context>
    <name>workflow.images</name>
    <message>
        <source>images &apos;%1&apos;</source>
        <translation>Bilder &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.images_missing</name>
    <message>
        <source>missing numbers: %1, the first behind %2; their frames count as lost, and the others keep their times</source>
        <translation>fehlende Nummern: %1, die erste hinter %2; ihre Bilder gelten als verloren, und die anderen behalten ihre Zeiten</translation>
    </message>
</context>
<context>
    <name>workflow.images_share_number</name>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; have the same number</source>
        <translation>&apos;%1&apos; und &apos;%2&apos; haben dieselbe Nummer</translation>
    </message>
</context>
<context>
    <name>workflow.images_without_times</name>
    <message>
        <source>images have no times</source>
        <translation>Einzelbilder haben keine Zeiten</translation>
    </message>
</context>
<context>
    <name>workflow.import_lens</name>
    <message>
        <source>import the lens calibration of camera %1 from %2</source>
        <translation>Objektivdaten der Kamera %1 aus %2 importieren</translation>
    </message>
</context>
<context>
    <name>workflow.import_of_trial</name>
    <message>
        <source>import of trial &apos;%1&apos;</source>
        <translation>Import des Versuchs &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.import_roster</name>
    <message>
        <source>import the roster %1</source>
        <translation>Klassenliste %1 importieren</translation>
    </message>
</context>
<context>
    <name>workflow.import_to_turn</name>
    <message>
        <source>import the video again to measure it as it is shown</source>
        <translation>importieren Sie das Video noch einmal, um es so zu messen, wie es gezeigt wird</translation>
    </message>
</context>
<context>
    <name>workflow.import_trial</name>
    <message>
        <source>import trial %1</source>
        <translation>Versuch %1 importieren</translation>
    </message>
</context>
<context>
    <name>workflow.import_trial_from</name>
    <message>
        <source>import trial %1 from %2</source>
        <translation>Versuch %1 aus %2 importieren</translation>
    </message>
</context>
<context>
    <name>workflow.interface_of_live_positions</name>
    <message>
        <source>interface &apos;%1&apos; of live positions</source>
        <translation>Schnittstelle &apos;%1&apos; der laufenden Orte</translation>
    </message>
</context>
<context>
    <name>workflow.interlaced</name>
    <message>
        <source>it is interlaced: each frame holds two fields taken one after the other, and each is measured at its own time, with half the lines</source>
        <translation>es hat Halbbilder (interlaced): Jedes Bild enthält zwei nacheinander aufgenommene Halbbilder, und jedes wird zu seiner eigenen Zeit gemessen, mit der halben Zeilenzahl</translation>
    </message>
</context>
<context>
    <name>workflow.interlaced_whole</name>
    <message>
        <source>it is interlaced, but was measured by whole frames, of which each shows two moments; import it as a new trial to have each field measured at its own time</source>
        <translation>es hat Halbbilder (interlaced), wurde aber nach ganzen Bildern gemessen, von denen jedes zwei Zeitpunkte zeigt; als neuen Versuch importieren, damit jedes Halbbild zu seiner eigenen Zeit gemessen wird</translation>
    </message>
</context>
<context>
    <name>workflow.intrinsics_of_camera</name>
    <message>
        <source>intrinsics of camera &apos;%1&apos;</source>
        <translation>Objektivdaten der Kamera &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.is_being_recorded</name>
    <message>
        <source>it is being recorded</source>
        <translation>er wird gerade aufgenommen</translation>
    </message>
</context>
<context>
    <name>workflow.join_or_name_camera</name>
    <message>
        <source>give each view a camera of its own, or join the files of one recording with +, like --video A=1.mp4+2.mp4</source>
        <translation>geben Sie jeder Ansicht eine eigene Kamera oder verbinden Sie die Dateien einer Aufnahme mit +</translation>
    </message>
</context>
<context>
    <name>workflow.joined_videos</name>
    <message>
        <source>videos &apos;%1&apos;</source>
        <translation>Videos &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.keeping_pictures</name>
    <message>
        <source>saving the images</source>
        <translation>Bilder werden abgelegt</translation>
    </message>
</context>
<context>
    <name>workflow.label_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2, its file says %3</source>
        <translation>Ansicht „%1“ wurde mit %2 aufgenommen, ihre Datei nennt %3</translation>
    </message>
</context>
<context>
    <name>workflow.labels_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2 (its file says %3), or view &apos;%4&apos; at %5 (its file says %6); speeds and times are by the file of view &apos;%4&apos;</source>
        <translation>Ansicht „%1“ wurde mit %2 aufgenommen (laut Datei %3) oder Ansicht „%4“ mit %5 (laut Datei %6); Geschwindigkeiten und Zeiten folgen der Datei der Ansicht „%4“</translation>
    </message>
</context>
<context>
    <name>workflow.leave_frame</name>
    <message>
        <source>remove the override of frame %1 of %2</source>
        <translation>Bild %1 von %2 dem Programm überlassen</translation>
    </message>
</context>
<context>
    <name>workflow.leave_frames</name>
    <message>
        <source>remove the overrides of %1 samples of %2</source>
        <translation>die Vorgaben für %1 Messpunkte von %2 entfernen</translation>
    </message>
</context>
<context>
    <name>workflow.leave_one_mat</name>
    <message>
        <source>leave one mat on the floor, and use newer files</source>
        <translation>lassen Sie eine Matte auf dem Boden, und nehmen Sie neuere Dateien</translation>
    </message>
</context>
<context>
    <name>workflow.leave_out_trial</name>
    <message>
        <source>remove %1, which recorded nothing</source>
        <translation>%1 weglassen, von dem nichts aufgenommen wurde</translation>
    </message>
</context>
<context>
    <name>workflow.lens_at_other_size</name>
    <message>
        <source>its frames are %1, but the lens was calibrated at %2</source>
        <translation>ihre Bilder haben %1, aber das Objektiv wurde bei %2 kalibriert</translation>
    </message>
</context>
<context>
    <name>workflow.lens_cropped_columns</name>
    <message>
        <source>The lens calibration at %1 was cropped on both sides to %2, as the markers confirm.</source>
        <translation>Die Objektivkalibrierung bei %1 wurde auf beiden Seiten auf %2 beschnitten, wie die Marker bestätigen.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_cropped_rows</name>
    <message>
        <source>The lens calibration at %1 was cropped above and below to %2, as the markers confirm.</source>
        <translation>Die Objektivkalibrierung bei %1 wurde oben und unten auf %2 beschnitten, wie die Marker bestätigen.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_enlarged</name>
    <message>
        <source>The lens calibration at %1 was fitted to %2 by the markers, which show that the image is enlarged by a factor of %3 (± %4).</source>
        <translation>Die Objektivkalibrierung bei %1 wurde anhand der Marker an %2 angepasst; sie zeigen, dass das Bild um den Faktor %3 (± %4) vergrößert ist.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_imported_from</name>
    <message>
        <source>imported from %1</source>
        <translation>importiert aus %1</translation>
    </message>
</context>
<context>
    <name>workflow.lens_never_calibrated</name>
    <message>
        <source>The lens of camera &apos;%1&apos; is neither calibrated nor determined by the floor&apos;s markers</source>
        <translation>Das Objektiv der Kamera &apos;%1&apos; wurde weder kalibriert noch durch die Marker des Bodens bestimmt</translation>
    </message>
</context>
<context>
    <name>workflow.lens_part_unknown</name>
    <message>
        <source>The lens calibration at %1 was cropped to %2, but the markers do not show whether the image is enlarged as well, so its focal length is known only to %3: calibrate the lens at %2, or use more markers.</source>
        <translation>Die Objektivkalibrierung bei %1 wurde auf %2 beschnitten, aber die Marker zeigen nicht, ob das Bild außerdem vergrößert ist; die Brennweite ist daher nur auf %3 bekannt: kalibrieren Sie das Objektiv bei %2, oder verwenden Sie mehr Marker.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_scaled</name>
    <message>
        <source>The lens calibration at %1 was converted to %2.</source>
        <translation>Die Objektivkalibrierung bei %1 wurde auf %2 umgerechnet.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_turned_either_way</name>
    <message>
        <source>Which way the camera was turned since is not known, so the centre of its images is less certain.</source>
        <translation>In welche Richtung die Kamera seitdem gedreht wurde, ist nicht bekannt, daher ist die Mitte ihrer Bilder weniger sicher.</translation>
    </message>
</context>
<context>
    <name>workflow.link_lost_video</name>
    <message>
        <source>link a lost video</source>
        <translation>ein fehlendes Video verknüpfen</translation>
    </message>
</context>
<context>
    <name>workflow.link_lost_videos</name>
    <message>
        <source>link %1 lost videos</source>
        <translation>%1 fehlende Videos verknüpfen</translation>
    </message>
</context>
<context>
    <name>workflow.little_common_time</name>
    <message>
        <source>%1 and %2 long, %3 in common</source>
        <translation>%1 und %2 lang, %3 gemeinsam</translation>
    </message>
</context>
<context>
    <name>workflow.live_positions_to</name>
    <message>
        <source>live positions to %1</source>
        <translation>Live-Orte an %1</translation>
    </message>
</context>
<context>
    <name>workflow.live_tracking</name>
    <message>
        <source>live tracking</source>
        <translation>Verfolgung während der Aufnahme</translation>
    </message>
</context>
<context>
    <name>workflow.look_at_outlines</name>
    <message>
        <source>check the outlines, and set the robot&apos;s colour or keep other objects out of view</source>
        <translation>sehen Sie sich die Umrisse an und geben Sie die Farbe des Roboters an, oder halten Sie andere aus den Bildern</translation>
    </message>
</context>
<context>
    <name>workflow.look_for_lost_videos</name>
    <message>
        <source>search for lost videos</source>
        <translation>Suche nach verlorenen Videos</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_board_in</name>
    <message>
        <source>detecting the board in %1</source>
        <translation>die Tafel wird gesucht in %1</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_board_in_both</name>
    <message>
        <source>detecting the board in %1 and %2</source>
        <translation>die Tafel wird gesucht in %1 und %2</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_files</name>
    <message>
        <source>searching for files</source>
        <translation>Dateien werden gesucht</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_markers_again</name>
    <message>
        <source>detecting the markers again</source>
        <translation>Marker werden wieder gesucht</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_markers_in</name>
    <message>
        <source>detecting the markers in %1</source>
        <translation>Marker werden in %1 gesucht</translation>
    </message>
</context>
<context>
    <name>workflow.looking_through_media</name>
    <message>
        <source>searching the media folder</source>
        <translation>der Medienordner wird durchsucht</translation>
    </message>
</context>
<context>
    <name>workflow.lost_not_packed</name>
    <message>
        <source>the video of camera %1 in trial &apos;%2&apos; is lost and is not in the packed project</source>
        <translation>das Video der Kamera %1 im Versuch &apos;%2&apos; fehlt und ist nicht im gepackten Projekt</translation>
    </message>
</context>
<context>
    <name>workflow.lost_video_not_there</name>
    <message>
        <source>the lost video is not in this folder</source>
        <translation>das fehlende Video ist nicht dort</translation>
    </message>
</context>
<context>
    <name>workflow.lost_videos</name>
    <message>
        <source>lost videos</source>
        <translation>fehlende Videos</translation>
    </message>
</context>
<context>
    <name>workflow.lost_videos_not_there</name>
    <message>
        <source>none of the %1 lost videos is in this folder</source>
        <translation>keins der %1 fehlenden Videos ist dort</translation>
    </message>
</context>
<context>
    <name>workflow.made_through_registration</name>
    <message>
        <source>It was made via registration %1 of the project.</source>
        <translation>Sie wurde über die Einmessung %1 des Projekts gemacht.</translation>
    </message>
</context>
<context>
    <name>workflow.made_with_it_already</name>
    <message>
        <source>it already uses that calibration</source>
        <translation>das ist schon damit gemacht</translation>
    </message>
</context>
<context>
    <name>workflow.making_hash</name>
    <message>
        <source>computing the hash of %1</source>
        <translation>die Prüfsumme wird gebildet: %1</translation>
    </message>
</context>
<context>
    <name>workflow.many_spikes</name>
    <message>
        <source>%1 spikes in %2 positions</source>
        <translation>%1 Ausreißer in %2 Positionen</translation>
    </message>
</context>
<context>
    <name>workflow.map_behind</name>
    <message>
        <source>the map is %1 behind, no frame skipped</source>
        <translation>die Karte hinkt %1 nach, nichts übersprungen</translation>
    </message>
</context>
<context>
    <name>workflow.map_behind_and_skipping</name>
    <message>
        <source>the map is %1 behind, %2 frames skipped</source>
        <translation>die Karte hinkt %1 nach, %2 übersprungen</translation>
    </message>
</context>
<context>
    <name>workflow.mark_spike</name>
    <message>
        <source>mark frame %1 of %2 as a spike</source>
        <translation>Bild %1 von %2 als Ausreißer markieren</translation>
    </message>
</context>
<context>
    <name>workflow.mark_spikes</name>
    <message>
        <source>mark %1 samples of %2 as spikes</source>
        <translation>%1 Messpunkte von %2 als Ausreißer markieren</translation>
    </message>
</context>
<context>
    <name>workflow.markers_for_camera</name>
    <message>
        <source>markers for camera &apos;%1&apos;</source>
        <translation>Marker für Kamera &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.measure_again</name>
    <message>
        <source>reanalyse %1</source>
        <translation>%1 neu auswerten</translation>
    </message>
</context>
<context>
    <name>workflow.measure_check_line</name>
    <message>
        <source>measure the line from end mark to end mark</source>
        <translation>messen Sie die Linie von Endstrich zu Endstrich</translation>
    </message>
</context>
<context>
    <name>workflow.measure_height</name>
    <message>
        <source>measure its height, enter it and reanalyse</source>
        <translation>messen Sie die Höhe, geben Sie sie ein und werten Sie neu aus</translation>
    </message>
</context>
<context>
    <name>workflow.measure_it_again</name>
    <message>
        <source>repeat the analysis</source>
        <translation>messen Sie ihn neu</translation>
    </message>
</context>
<context>
    <name>workflow.measured_as_stored</name>
    <message>
        <source>an earlier version measured its frames as stored, but its file says to turn, mirror or stretch them</source>
        <translation>eine frühere Version hat seine Bilder so gemessen, wie sie gespeichert sind, aber laut Datei sind sie zu drehen, zu spiegeln oder zu strecken</translation>
    </message>
</context>
<context>
    <name>workflow.measured_frames</name>
    <message>
        <source>only %1 of the frames give a position</source>
        <translation>nur %1 der Bilder ergeben eine Position</translation>
    </message>
</context>
<context>
    <name>workflow.measured_in_part</name>
    <message>
        <source>%1 of %2 were measured; lengths, times and maxima are at least as large as stated</source>
        <translation>%1 von %2 wurden gemessen; Längen, Zeiten und Höchstwerte sind mindestens so groß wie angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.metric_named</name>
    <message>
        <source>metric &apos;%1&apos;</source>
        <translation>Kennwert &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.more_frame_steps</name>
    <message>
        <source>up to %1 its frames are wrong at %2 more moments in the same way</source>
        <translation>bis %1 sind ihre Bilder an %2 weiteren Stellen ebenso falsch</translation>
    </message>
</context>
<context>
    <name>workflow.moved_since</name>
    <message>
        <source>it was found moved by %1 since the registration that was used</source>
        <translation>seit dem verwendeten Einmessen wurde eine Verschiebung um %1 festgestellt</translation>
    </message>
</context>
<context>
    <name>workflow.name_another_camera</name>
    <message>
        <source>name another camera that is registered</source>
        <translation>nennen Sie eine andere, eingemessene Kamera</translation>
    </message>
</context>
<context>
    <name>workflow.name_image_series</name>
    <message>
        <source>give a folder with images such as 000001.png, or a pattern such as FOLDER/%1</source>
        <translation>geben Sie einen Ordner mit Bildern wie 000001.png an oder ein Muster wie FOLDER/%1</translation>
    </message>
</context>
<context>
    <name>workflow.name_its_camera</name>
    <message>
        <source>name one of its cameras</source>
        <translation>nennen Sie eine seiner Kameras</translation>
    </message>
</context>
<context>
    <name>workflow.name_its_robot</name>
    <message>
        <source>name one of its robots</source>
        <translation>nennen Sie einen seiner Roboter</translation>
    </message>
</context>
<context>
    <name>workflow.name_one_series</name>
    <message>
        <source>name one of them, like FOLDER/%1</source>
        <translation>nennen Sie eine davon, wie FOLDER/%1</translation>
    </message>
</context>
<context>
    <name>workflow.name_place_in_pixels</name>
    <message>
        <source>give it in pixels from the frame&apos;s top left corner</source>
        <translation>nennen Sie sie in Pixeln von der linken oberen Ecke des Bildes</translation>
    </message>
</context>
<context>
    <name>workflow.name_robot_after_track</name>
    <message>
        <source>give the robot the name of one of them</source>
        <translation>geben Sie dem Roboter den Namen einer davon</translation>
    </message>
</context>
<context>
    <name>workflow.name_time_within_trial</name>
    <message>
        <source>name a time within the trial, in seconds</source>
        <translation>nennen Sie eine Zeit innerhalb des Versuchs, in Sekunden</translation>
    </message>
</context>
<context>
    <name>workflow.name_two_cameras</name>
    <message>
        <source>name two cameras</source>
        <translation>nennen Sie zwei Kameras</translation>
    </message>
</context>
<context>
    <name>workflow.nearly_all_beyond_limits</name>
    <message>
        <source>nearly all samples exceed the limits of task &apos;%1&apos;, so the limits were ignored</source>
        <translation>fast alles Gemessene liegt jenseits der Grenzwerte der Aufgabe &apos;%1&apos;, darum blieben diese außer Betracht</translation>
    </message>
</context>
<context>
    <name>workflow.neither_lens_nor_recording</name>
    <message>
        <source>it has no intrinsics and no recording</source>
        <translation>sie hat keine Objektivdaten und keine Aufnahme</translation>
    </message>
</context>
<context>
    <name>workflow.never_calibrated</name>
    <message>
        <source>it was never calibrated</source>
        <translation>sie wurde nie kalibriert</translation>
    </message>
</context>
<context>
    <name>workflow.new_project</name>
    <message>
        <source>new project</source>
        <translation>neues Projekt</translation>
    </message>
</context>
<context>
    <name>workflow.no_address_with_port</name>
    <message>
        <source>it is not an IPv4 address with a port</source>
        <translation>es ist keine IPv4-Adresse mit Port</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_gave_picture</name>
    <message>
        <source>no camera delivered a frame</source>
        <translation>keine Kamera lieferte ein Bild</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_given</name>
    <message>
        <source>no camera was given</source>
        <translation>keine Kamera wurde angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_registered</name>
    <message>
        <source>no camera is registered to the floor</source>
        <translation>keine Kamera ist zum Boden eingemessen</translation>
    </message>
</context>
<context>
    <name>workflow.no_common_place</name>
    <message>
        <source>The two analyses have no position in common.</source>
        <translation>Kein Ort wurde von beiden Auswertungen gemessen.</translation>
    </message>
</context>
<context>
    <name>workflow.no_common_time</name>
    <message>
        <source>views &apos;%1&apos; and &apos;%2&apos; do not overlap with a time offset of %3</source>
        <translation>die Sichten &apos;%1&apos; und &apos;%2&apos; haben bei einem Versatz von %3 keine gemeinsame Zeit</translation>
    </message>
</context>
<context>
    <name>workflow.no_counterpart</name>
    <message>
        <source>the other camera has no file of its number</source>
        <translation>die andere Kamera hat keine Datei mit dieser Nummer</translation>
    </message>
</context>
<context>
    <name>workflow.no_image_series</name>
    <message>
        <source>there are no numbered images (PNG, JPEG, TIFF, BMP, WebP) of that name</source>
        <translation>es gibt keine nummerierten Bilder (PNG, JPEG, TIFF, BMP, WebP) dieses Namens</translation>
    </message>
</context>
<context>
    <name>workflow.no_live_positions</name>
    <message>
        <source>none of its cameras is registered to the floor, so there are no live positions to send</source>
        <translation>keine der Kameras ist eingemessen, darum gibt es keine Orte zu senden</translation>
    </message>
</context>
<context>
    <name>workflow.no_mat_seen</name>
    <message>
        <source>no file shows four or more of its tags</source>
        <translation>keine Datei zeigt vier oder mehr ihrer Tags</translation>
    </message>
</context>
<context>
    <name>workflow.no_motion</name>
    <message>
        <source>no robot moves in it</source>
        <translation>kein Roboter bewegt sich darin</translation>
    </message>
</context>
<context>
    <name>workflow.no_multicast</name>
    <message>
        <source>interface &apos;%1&apos; does not support multicast</source>
        <translation>Schnittstelle &apos;%1&apos; kann kein Multicast</translation>
    </message>
</context>
<context>
    <name>workflow.no_picture_read</name>
    <message>
        <source>no image could be read</source>
        <translation>kein Bild konnte gelesen werden</translation>
    </message>
</context>
<context>
    <name>workflow.no_picture_then</name>
    <message>
        <source>the view has no frame at that time</source>
        <translation>die Sicht hat zu dieser Zeit kein Bild</translation>
    </message>
</context>
<context>
    <name>workflow.no_pixels_no_picture</name>
    <message>
        <source>it needs pixels, or an image to detect the markers in</source>
        <translation>weder ihre Pixel noch ein Bild zum Suchen wurde angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.no_robot</name>
    <message>
        <source>the project has no robot to track</source>
        <translation>das Projekt hat keinen Roboter, nach dem zu suchen wäre</translation>
    </message>
</context>
<context>
    <name>workflow.no_sample</name>
    <message>
        <source>the analysis has no sample</source>
        <translation>die Auswertung hat keinen Messpunkt</translation>
    </message>
</context>
<context>
    <name>workflow.no_sample_in_group</name>
    <message>
        <source>no sample from %1 to %2 is to be changed</source>
        <translation>von %1 bis %2 ist kein Messpunkt zu ändern</translation>
    </message>
</context>
<context>
    <name>workflow.no_socket</name>
    <message>
        <source>the system could not open a socket</source>
        <translation>dieser Rechner gibt keinen Socket frei</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_frame</name>
    <message>
        <source>this frame does not exist</source>
        <translation>dieses Bild gibt es nicht</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_interface</name>
    <message>
        <source>this computer has no interface of that name</source>
        <translation>dieser Rechner hat keine dieses Namens</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_metric</name>
    <message>
        <source>no trial of the project has it</source>
        <translation>kein Versuch des Projekts hat ihn</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_view</name>
    <message>
        <source>the trial has no such view</source>
        <translation>der Versuch hat keine solche Sicht</translation>
    </message>
</context>
<context>
    <name>workflow.no_times_in_file</name>
    <message>
        <source>it has no time stamps and states no frame rate</source>
        <translation>sie hat keine Zeitstempel und nennt keine Bildrate</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_given</name>
    <message>
        <source>no track was given</source>
        <translation>keine Spur wurde angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_imported</name>
    <message>
        <source>no track of it was imported</source>
        <translation>von ihm wurde keine Spur importiert</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_of_that_name</name>
    <message>
        <source>none of its tracks is called &apos;%1&apos;; it has %2</source>
        <translation>keine der Spuren heißt &apos;%1&apos;; vorhanden: %2</translation>
    </message>
</context>
<context>
    <name>workflow.no_video_given</name>
    <message>
        <source>no video was given</source>
        <translation>kein Video wurde angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.no_video_lost</name>
    <message>
        <source>no video of this project is lost</source>
        <translation>kein Video dieses Projekts fehlt</translation>
    </message>
</context>
<context>
    <name>workflow.none_of_that_number</name>
    <message>
        <source>camera &apos;%1&apos; has no such number</source>
        <translation>Kamera &apos;%1&apos; hat keine mit dieser Nummer</translation>
    </message>
</context>
<context>
    <name>workflow.not_measured_in_range</name>
    <message>
        <source>it contains no sample of robot &apos;%1&apos; (%2 to %3)</source>
        <translation>er enthält keinen Messpunkt von Roboter &apos;%1&apos; (%2 bis %3)</translation>
    </message>
</context>
<context>
    <name>workflow.not_measured_there</name>
    <message>
        <source>the robot has no measurement at that time</source>
        <translation>der Roboter wurde dort nicht gemessen, es gibt nichts zu beurteilen</translation>
    </message>
</context>
<context>
    <name>workflow.not_synchronised</name>
    <message>
        <source>it is not synchronised: the same start time as the first view was assumed, and positions of a moving robot are wrong</source>
        <translation>sie ist nicht synchronisiert, sondern gilt als mit der ersten Sicht begonnen, so dass ein fahrender Roboter nicht dort ist, wo ihn die beiden Sichten sehen</translation>
    </message>
</context>
<context>
    <name>workflow.not_tracked_in_trial</name>
    <message>
        <source>it is not tracked in trial &apos;%1&apos;</source>
        <translation>er wird im Versuch &apos;%1&apos; nicht verfolgt</translation>
    </message>
</context>
<context>
    <name>workflow.not_tracked_yet</name>
    <message>
        <source>it has not been tracked yet</source>
        <translation>er wurde noch nicht verfolgt</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_came</name>
    <message>
        <source>no frame arrived for %1 because %2</source>
        <translation>%1 lang kam nichts, denn %2</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_recorded</name>
    <message>
        <source>nothing was recorded</source>
        <translation>nichts wurde aufgenommen</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_said_there</name>
    <message>
        <source>that frame has no manual override</source>
        <translation>dort wurde nichts von Hand festgelegt</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_stands_out</name>
    <message>
        <source>no foreground object was found at pixel %1,%2 at %3</source>
        <translation>bei %1,%2 hebt sich zur Zeit %3 einige Bilder lang nichts vom Boden ab</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_accept</name>
    <message>
        <source>all checks were passed</source>
        <translation>alle Prüfungen sind bestanden</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_analyse_again</name>
    <message>
        <source>it has not been tracked yet, so it cannot be reanalysed</source>
        <translation>er wurde noch nicht verfolgt, es gibt also nichts neu auszuwerten</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_do</name>
    <message>
        <source>no action is needed</source>
        <translation>es gibt nichts zu tun</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_withdraw</name>
    <message>
        <source>leave it as it is</source>
        <translation>lassen Sie es, wie es ist</translation>
    </message>
</context>
<context>
    <name>workflow.number_files_alike</name>
    <message>
        <source>give as many of each, in the same order, or number their names alike</source>
        <translation>geben Sie von jeder gleich viele in derselben Reihenfolge an, oder nummerieren Sie ihre Namen gleich</translation>
    </message>
</context>
<context>
    <name>workflow.number_images_once</name>
    <message>
        <source>give each image a number of its own</source>
        <translation>geben Sie jedem Bild eine eigene Nummer</translation>
    </message>
</context>
<context>
    <name>workflow.numbers_count_no_frames</name>
    <message>
        <source>their numbers go from %1 to %2, and there are %3 images: they do not count frames</source>
        <translation>ihre Nummern gehen von %1 bis %2, und es sind %3 Bilder: Sie zählen keine Videobilder</translation>
    </message>
</context>
<context>
    <name>workflow.offsets_of_other_count</name>
    <message>
        <source>the number of views is %1, the number of offsets %2</source>
        <translation>angegeben sind %1 Sichten und der Versatz von %2</translation>
    </message>
</context>
<context>
    <name>workflow.old_calibration</name>
    <message>
        <source>The lens calibration of camera &apos;%1&apos; is %2 days old</source>
        <translation>Die Objektivkalibrierung der Kamera &apos;%1&apos; ist %2 Tage alt</translation>
    </message>
</context>
<context>
    <name>workflow.old_registration</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; is %2 days old</source>
        <translation>Die Einmessung der Kamera &apos;%1&apos; ist %2 Tage alt</translation>
    </message>
</context>
<context>
    <name>workflow.one_follows_something_else</name>
    <message>
        <source>one of them tracks another object, or has moved since its registration</source>
        <translation>eine von ihnen folgt etwas anderem oder steht nicht dort, wo sie eingemessen wurde</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_doubled</name>
    <message>
        <source>after %1 a frame repeats the one before, and its time stamps count it as time; later times were corrected</source>
        <translation>nach %1 wiederholt ein Bild das vorige, und die Zeitstempel zählen es als Zeit; spätere Zeiten wurden berichtigt</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_missing</name>
    <message>
        <source>after %1 a frame is missing that its time stamps do not show: the robot moves too far; later times were corrected</source>
        <translation>nach %1 fehlt ein Bild, ohne dass die Zeitstempel es zeigen: Der Roboter kommt zu weit; spätere Zeiten wurden berichtigt</translation>
    </message>
</context>
<context>
    <name>workflow.only_frame</name>
    <message>
        <source>its only frame is 0</source>
        <translation>das einzige ist Bild 0</translation>
    </message>
</context>
<context>
    <name>workflow.open_it_or_elsewhere</name>
    <message>
        <source>open it, or choose another folder</source>
        <translation>öffnen Sie es, oder wählen Sie einen anderen Ordner</translation>
    </message>
</context>
<context>
    <name>workflow.other_sample_judged</name>
    <message>
        <source>another sample was overridden while this one was analysed</source>
        <translation>ein anderer Messpunkt wurde von Hand beurteilt, während dieser ausgewertet wurde</translation>
    </message>
</context>
<context>
    <name>workflow.outside_picture</name>
    <message>
        <source>the position is outside the frame</source>
        <translation>die Stelle liegt außerhalb des Bildes</translation>
    </message>
</context>
<context>
    <name>workflow.pair_like_files</name>
    <message>
        <source>pair images with images and videos with videos</source>
        <translation>paaren Sie Bilder mit Bildern und Videos mit Videos</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_cameras</name>
    <message>
        <source>the relative position of cameras &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>die relative Lage der Kameras &apos;%1&apos; und &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_one_camera</name>
    <message>
        <source>both are the same camera</source>
        <translation>beide sind dieselbe Kamera</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_other_size</name>
    <message>
        <source>&apos;%1&apos; is %2, but the camera was calibrated at %3</source>
        <translation>&apos;%1&apos; hat %2, aber die Kamera wurde bei %3 kalibriert</translation>
    </message>
</context>
<context>
    <name>workflow.paired_files</name>
    <message>
        <source>the files of the two cameras</source>
        <translation>die Dateien der beiden Kameras</translation>
    </message>
</context>
<context>
    <name>workflow.passed_cameras</name>
    <message>
        <source>no camera was found moved</source>
        <translation>bei keiner Kamera wurde eine Verschiebung festgestellt</translation>
    </message>
</context>
<context>
    <name>workflow.passed_decoding</name>
    <message>
        <source>all frames could be decoded</source>
        <translation>alle Bilder ließen sich decodieren</translation>
    </message>
</context>
<context>
    <name>workflow.passed_frames</name>
    <message>
        <source>the frames came at regular intervals</source>
        <translation>die Bilder kamen in gleichmäßigen Abständen</translation>
    </message>
</context>
<context>
    <name>workflow.passed_lens</name>
    <message>
        <source>the lenses are calibrated, or estimated from the floor&apos;s markers</source>
        <translation>die Objektive sind kalibriert oder aus den Markern des Bodens geschätzt</translation>
    </message>
</context>
<context>
    <name>workflow.passed_motion</name>
    <message>
        <source>speeds and accelerations are possible</source>
        <translation>Geschwindigkeiten und Beschleunigungen sind möglich</translation>
    </message>
</context>
<context>
    <name>workflow.passed_names</name>
    <message>
        <source>no robot could be another one</source>
        <translation>kein Roboter könnte ein anderer sein</translation>
    </message>
</context>
<context>
    <name>workflow.passed_precision</name>
    <message>
        <source>positions are precise for the run&apos;s extent</source>
        <translation>die Positionen sind genau für die Ausdehnung des Laufs</translation>
    </message>
</context>
<context>
    <name>workflow.passed_results</name>
    <message>
        <source>the stored results are as computed</source>
        <translation>die gespeicherten Ergebnisse sind die berechneten</translation>
    </message>
</context>
<context>
    <name>workflow.passed_spikes</name>
    <message>
        <source>few positions are spikes</source>
        <translation>wenige Positionen sind Ausreißer</translation>
    </message>
</context>
<context>
    <name>workflow.passed_synchronisation</name>
    <message>
        <source>the views are synchronised</source>
        <translation>die Sichten sind synchronisiert</translation>
    </message>
</context>
<context>
    <name>workflow.passed_time</name>
    <message>
        <source>the robots were measured all the time</source>
        <translation>die Roboter wurden die ganze Zeit gemessen</translation>
    </message>
</context>
<context>
    <name>workflow.passed_views</name>
    <message>
        <source>the views agree</source>
        <translation>die Sichten stimmen überein</translation>
    </message>
</context>
<context>
    <name>workflow.picture_lost_here</name>
    <message>
        <source>1 frame was lost because this computer or its disk was too slow</source>
        <translation>1 Bild ging verloren, weil dieser Rechner oder seine Platte zu langsam war</translation>
    </message>
</context>
<context>
    <name>workflow.picture_lost_on_wire</name>
    <message>
        <source>1 frame was lost between the camera and this program</source>
        <translation>1 Bild ging zwischen Kamera und Programm verloren</translation>
    </message>
</context>
<context>
    <name>workflow.picture_made_too_late</name>
    <message>
        <source>1 frame was lost: this computer was too slow to generate it in time</source>
        <translation>1 Bild ging verloren, weil dieser Rechner zu langsam war, es rechtzeitig zu erzeugen</translation>
    </message>
</context>
<context>
    <name>workflow.picture_size_not_known</name>
    <message>
        <source>the size of its images is not known</source>
        <translation>die Größe ihrer Bilder ist nicht bekannt</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_lost_here</name>
    <message>
        <source>%1 frames were lost because this computer or its disk was too slow</source>
        <translation>%1 Bilder gingen verloren, weil dieser Rechner oder seine Platte zu langsam war</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_lost_on_wire</name>
    <message>
        <source>%1 frames were lost between the camera and this program</source>
        <translation>%1 Bilder gingen zwischen Kamera und Programm verloren</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_made_too_late</name>
    <message>
        <source>%1 frames were lost: this computer was too slow to generate them in time</source>
        <translation>%1 Bilder gingen verloren, weil dieser Rechner zu langsam war, sie rechtzeitig zu erzeugen</translation>
    </message>
</context>
<context>
    <name>workflow.point_out_whole_robot</name>
    <message>
        <source>point it out where the whole robot is visible and moving</source>
        <translation>zeigen Sie ihn dort, wo er ganz zu sehen ist und sich bewegt</translation>
    </message>
</context>
<context>
    <name>workflow.positions_change</name>
    <message>
        <source>Positions change by %1 RMS, at most by %2 (at %3).</source>
        <translation>Die Orte ändern sich um %1 RMS, höchstens um %2 (bei %3).</translation>
    </message>
</context>
<context>
    <name>workflow.positions_rounded</name>
    <message>
        <source>rounded to %1</source>
        <translation>auf %1 gerundet</translation>
    </message>
</context>
<context>
    <name>workflow.positions_uncertain</name>
    <message>
        <source>its positions are known to ±%1 only, in a run over %2</source>
        <translation>seine Positionen sind nur auf ±%1 bekannt, in einem Lauf über %2</translation>
    </message>
</context>
<context>
    <name>workflow.project_file_gone</name>
    <message>
        <source>the project file no longer exists</source>
        <translation>die Datei des Projekts ist nicht mehr da</translation>
    </message>
</context>
<context>
    <name>workflow.project_lost</name>
    <message>
        <source>the project file was deleted, renamed or replaced; recording continues, and its contents will be saved at the end</source>
        <translation>die Datei des Projekts wurde gelöscht, umbenannt oder ersetzt; die Aufnahme geht weiter, und am Ende wird ihr Inhalt gerettet</translation>
    </message>
</context>
<context>
    <name>workflow.project_rescued</name>
    <message>
        <source>the project file was deleted, renamed or replaced; its contents were saved in &apos;%1&apos;, the project from now on</source>
        <translation>die Datei des Projekts wurde inzwischen gelöscht, umbenannt oder ersetzt; ihr Inhalt ist in &apos;%1&apos; gerettet, das von nun an das Projekt ist</translation>
    </message>
</context>
<context>
    <name>workflow.put_axes_elsewhere</name>
    <message>
        <source>change the world axes of layout %1</source>
        <translation>Achsen des Plans %1 verlegen</translation>
    </message>
</context>
<context>
    <name>workflow.put_original_or_import</name>
    <message>
        <source>restore the original file, or import this one as another trial</source>
        <translation>legen Sie die ursprüngliche Datei zurück, oder importieren Sie diese als weiteren Versuch</translation>
    </message>
</context>
<context>
    <name>workflow.put_plate_on_it</name>
    <message>
        <source>put a plate of another colour on it, or set its true colour</source>
        <translation>setzen Sie eine Platte anderer Farbe darauf, oder geben Sie seine wirkliche Farbe an</translation>
    </message>
</context>
<context>
    <name>workflow.range_is_reversed</name>
    <message>
        <source>its start %1 is not before its end %2</source>
        <translation>sein Anfang %1 liegt nicht vor seinem Ende %2</translation>
    </message>
</context>
<context>
    <name>workflow.range_of_trial</name>
    <message>
        <source>range of trial &apos;%1&apos;</source>
        <translation>Bereich von Versuch &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.range_outside_trial</name>
    <message>
        <source>%1 to %2 is not within the trial&apos;s time</source>
        <translation>%1 bis %2 liegt nicht in der Zeit des Versuchs</translation>
    </message>
</context>
<context>
    <name>workflow.range_without_sample</name>
    <message>
        <source>it contains no sample</source>
        <translation>er enthält keinen Messpunkt</translation>
    </message>
</context>
<context>
    <name>workflow.rate_and_times</name>
    <message>
        <source>camera &apos;%1&apos; was given both a frame rate and frame times</source>
        <translation>für Kamera &apos;%1&apos; wurden sowohl eine Bildrate als auch Bildzeiten angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.rate_is_assumed</name>
    <message>
        <source>no recording shows it, so 30 frames/s are simulated</source>
        <translation>keine Aufnahme zeigt sie, daher werden 30 Bilder/s simuliert</translation>
    </message>
</context>
<context>
    <name>workflow.rate_of_header</name>
    <message>
        <source>its header states an even %1</source>
        <translation>ihr Kopf nennt gleichmäßige %1</translation>
    </message>
</context>
<context>
    <name>workflow.reanalyse_tracks</name>
    <message>
        <source>reanalyse them with: odograph track PROJECT TRIAL --again</source>
        <translation>werten Sie sie neu aus</translation>
    </message>
</context>
<context>
    <name>workflow.record</name>
    <message>
        <source>record %1</source>
        <translation>%1 aufnehmen</translation>
    </message>
</context>
<context>
    <name>workflow.record_for_longer</name>
    <message>
        <source>record again, for longer</source>
        <translation>nehmen Sie noch einmal länger auf</translation>
    </message>
</context>
<context>
    <name>workflow.record_it_again</name>
    <message>
        <source>record it again</source>
        <translation>nehmen Sie ihn neu auf</translation>
    </message>
</context>
<context>
    <name>workflow.record_to_faster_disk</name>
    <message>
        <source>record to a faster disk</source>
        <translation>nehmen Sie auf eine schnellere Platte auf</translation>
    </message>
</context>
<context>
    <name>workflow.recorded_at_another_size</name>
    <message>
        <source>The newest recording of camera &apos;%1&apos; is %2, its lens was calibrated at %3</source>
        <translation>Die neueste Aufnahme der Kamera &apos;%1&apos; hat %2, ihr Objektiv wurde bei %3 kalibriert</translation>
    </message>
</context>
<context>
    <name>workflow.recording</name>
    <message>
        <source>recording</source>
        <translation>Aufnahme</translation>
    </message>
</context>
<context>
    <name>workflow.recording_of_trial</name>
    <message>
        <source>recording of trial &apos;%1&apos;</source>
        <translation>Aufnahme des Versuchs &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.recording_of_view</name>
    <message>
        <source>recording of view &apos;%1&apos;</source>
        <translation>Aufnahme der Sicht „%1“</translation>
    </message>
</context>
<context>
    <name>workflow.reference_not_calibrated</name>
    <message>
        <source>camera &apos;%1&apos; was registered without a lens calibration: register it again with it</source>
        <translation>Kamera &apos;%1&apos; wurde ohne Objektivkalibrierung eingemessen: messen Sie sie damit neu ein</translation>
    </message>
</context>
<context>
    <name>workflow.register_a_camera</name>
    <message>
        <source>register the cameras first</source>
        <translation>messen Sie zuerst die Kameras ein</translation>
    </message>
</context>
<context>
    <name>workflow.register_both_again</name>
    <message>
        <source>register both again and reanalyse</source>
        <translation>messen Sie beide erneut ein und werten Sie neu aus</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera</name>
    <message>
        <source>register camera %1</source>
        <translation>Kamera %1 einmessen</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_again</name>
    <message>
        <source>register camera %1 again</source>
        <translation>Kamera %1 neu einmessen</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_anew</name>
    <message>
        <source>register the camera again</source>
        <translation>die Kamera neu registrieren</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_through</name>
    <message>
        <source>register camera %1 via camera %2</source>
        <translation>Kamera %1 über Kamera %2 einmessen</translation>
    </message>
</context>
<context>
    <name>workflow.register_cameras_again</name>
    <message>
        <source>register the cameras again</source>
        <translation>messen Sie die Kameras neu ein</translation>
    </message>
</context>
<context>
    <name>workflow.register_cameras_together</name>
    <message>
        <source>register the cameras of layout %1 jointly</source>
        <translation>Kameras des Plans %1 gemeinsam einmessen</translation>
    </message>
</context>
<context>
    <name>workflow.register_if_other_part</name>
    <message>
        <source>if the camera shows another part of the scene at that size, register it again in a frame of this video</source>
        <translation>wenn die Kamera bei dieser Größe einen anderen Ausschnitt zeigt, messen Sie sie in einem Bild dieses Videos neu ein</translation>
    </message>
</context>
<context>
    <name>workflow.register_in_its_video</name>
    <message>
        <source>register the camera in a frame of this video, to which its lens calibration is then fitted</source>
        <translation>messen Sie die Kamera in einem Bild dieses Videos ein, an das ihre Objektivkalibrierung dann angepasst wird</translation>
    </message>
</context>
<context>
    <name>workflow.register_in_this_video</name>
    <message>
        <source>register the camera again in a frame of this video and reanalyse</source>
        <translation>messen Sie die Kamera in einem Bild dieses Videos neu ein, und werten Sie neu aus</translation>
    </message>
</context>
<context>
    <name>workflow.register_it_again</name>
    <message>
        <source>register it again.</source>
        <translation>messen Sie sie neu ein.</translation>
    </message>
</context>
<context>
    <name>workflow.register_it_first</name>
    <message>
        <source>register it first, with markers or via another camera</source>
        <translation>messen Sie sie zuerst ein, über Marker oder über eine andere Kamera</translation>
    </message>
</context>
<context>
    <name>workflow.register_moved_again</name>
    <message>
        <source>register it again and reanalyse</source>
        <translation>messen Sie sie erneut ein und werten Sie neu aus</translation>
    </message>
</context>
<context>
    <name>workflow.register_or_do_not_send</name>
    <message>
        <source>run odograph register for one of them, or leave --ssl-vision out</source>
        <translation>messen Sie eine davon ein, oder senden Sie keine Positionen</translation>
    </message>
</context>
<context>
    <name>workflow.register_through_it_again</name>
    <message>
        <source>register it via that camera again</source>
        <translation>messen Sie sie über jene Kamera neu ein</translation>
    </message>
</context>
<context>
    <name>workflow.register_upright</name>
    <message>
        <source>register the camera again</source>
        <translation>messen Sie die Kamera neu ein</translation>
    </message>
</context>
<context>
    <name>workflow.registered_as_stored</name>
    <message>
        <source>its frames are turned or mirrored as its file says, but an earlier version registered camera &apos;%1&apos;, perhaps by frames as stored</source>
        <translation>ihre Bilder werden gedreht oder gespiegelt, wie ihre Datei verlangt, aber eine frühere Version hat Kamera &apos;%1&apos; eingemessen, vielleicht nach Bildern, wie sie gespeichert sind</translation>
    </message>
</context>
<context>
    <name>workflow.registered_at_another_size</name>
    <message>
        <source>the image is %1, the camera was registered at %2</source>
        <translation>das Bild hat %1, die Kamera wurde bei %2 eingemessen</translation>
    </message>
</context>
<context>
    <name>workflow.registered_before_calibration</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; was made before its lens was calibrated</source>
        <translation>Die Einmessung der Kamera &apos;%1&apos; wurde gemacht, bevor ihr Objektiv kalibriert war</translation>
    </message>
</context>
<context>
    <name>workflow.registered_on_other_floor</name>
    <message>
        <source>it is registered on another floor, &apos;%1&apos;, and left out</source>
        <translation>sie ist auf einem anderen Boden eingemessen, &apos;%1&apos;, und bleibt außen vor</translation>
    </message>
</context>
<context>
    <name>workflow.registered_through_another</name>
    <message>
        <source>it was registered via another camera</source>
        <translation>sie wurde über eine andere Kamera eingemessen</translation>
    </message>
</context>
<context>
    <name>workflow.registered_with_other_lens</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; uses another lens calibration than the current one</source>
        <translation>Die Einmessung der Kamera &apos;%1&apos; wurde mit einer anderen Kalibrierung als der gültigen gemacht</translation>
    </message>
</context>
<context>
    <name>workflow.registration</name>
    <message>
        <source>registration %1</source>
        <translation>Einmessung %1</translation>
    </message>
</context>
<context>
    <name>workflow.registration_converted</name>
    <message>
        <source>its frames are %1, so the camera&apos;s registration at %2 was converted</source>
        <translation>ihre Bilder haben %1, daher wurde die Einmessung der Kamera bei %2 umgerechnet</translation>
    </message>
</context>
<context>
    <name>workflow.registration_counts_as_exact</name>
    <message>
        <source>its uncertainty is not known, so it counts as exact</source>
        <translation>ihre Unsicherheit ist nicht bekannt, daher gilt sie als genau</translation>
    </message>
</context>
<context>
    <name>workflow.registration_in_older_axes</name>
    <message>
        <source>it has other axes: those of its layout were changed since</source>
        <translation>sie hat andere Achsen: Die ihrer Anordnung wurden seither geändert</translation>
    </message>
</context>
<context>
    <name>workflow.registration_of</name>
    <message>
        <source>registration of %1</source>
        <translation>Einmessung von %1</translation>
    </message>
</context>
<context>
    <name>workflow.registration_of_camera</name>
    <message>
        <source>registration of camera &apos;%1&apos;</source>
        <translation>Einmessung der Kamera &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.registration_through</name>
    <message>
        <source>registration of camera &apos;%1&apos; via &apos;%2&apos;</source>
        <translation>Einmessung der Kamera &apos;%1&apos; über &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.registration_with_lens_in_force</name>
    <message>
        <source>registration of camera &apos;%1&apos; with the current lens calibration</source>
        <translation>Einmessung der Kamera &apos;%1&apos; mit dem gültigen Objektiv</translation>
    </message>
</context>
<context>
    <name>workflow.remove_cause</name>
    <message>
        <source>remove the cause and reanalyse, or record it again</source>
        <translation>beheben Sie die Ursache und werten Sie neu aus, oder nehmen Sie noch einmal auf</translation>
    </message>
</context>
<context>
    <name>workflow.remove_for_good</name>
    <message>
        <source>remove %1 for good</source>
        <translation>%1 endgültig löschen</translation>
    </message>
</context>
<context>
    <name>workflow.remove_strays</name>
    <message>
        <source>remove stray files</source>
        <translation>Entfernen herrenloser Dateien</translation>
    </message>
</context>
<context>
    <name>workflow.removing</name>
    <message>
        <source>removing %1</source>
        <translation>entfernt wird: %1</translation>
    </message>
</context>
<context>
    <name>workflow.rename_trial</name>
    <message>
        <source>rename trial %1 to %2</source>
        <translation>Versuch %1 in %2 umbenennen</translation>
    </message>
</context>
<context>
    <name>workflow.replaced_not_packed</name>
    <message>
        <source>the video of camera %1 in trial &apos;%2&apos; is outside the media folder and has changed since; it is not in the packed project</source>
        <translation>das Video der Kamera %1 im Versuch &apos;%2&apos; liegt anderswo und ist eine andere Datei als früher, und nicht im gepackten Projekt</translation>
    </message>
</context>
<context>
    <name>workflow.results_changed</name>
    <message>
        <source>its results differ from those of its analysis</source>
        <translation>seine Ergebnisse sind nicht die, die seine Auswertung ergeben hat</translation>
    </message>
</context>
<context>
    <name>workflow.robot</name>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
</context>
<context>
    <name>workflow.robot_given_two_tracks</name>
    <message>
        <source>robot &apos;%1&apos; was given two tracks</source>
        <translation>für Roboter &apos;%1&apos; wurden zwei Spuren angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.robot_in_view</name>
    <message>
        <source>robot &apos;%1&apos; in view &apos;%2&apos;</source>
        <translation>Roboter &apos;%1&apos; in Sicht &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.robot_is_new</name>
    <message>
        <source>robot &apos;%1&apos; is new</source>
        <translation>Roboter &apos;%1&apos; ist neu</translation>
    </message>
</context>
<context>
    <name>workflow.robot_leaps</name>
    <message>
        <source>after %1 the robot is suddenly %2 away: frames are missing for an unknown time, or another object was tracked; nothing was measured across it</source>
        <translation>nach %1 ist der Roboter plötzlich %2 entfernt: Es fehlen Bilder für unbekannte Zeit, oder ein anderes Objekt wurde verfolgt; darüber hinweg wurde nichts gemessen</translation>
    </message>
</context>
<context>
    <name>workflow.robot_not_tracked</name>
    <message>
        <source>robot &apos;%1&apos; was not tracked in it, only %2</source>
        <translation>Roboter &apos;%1&apos; wurde darin nicht verfolgt, wohl aber %2</translation>
    </message>
</context>
<context>
    <name>workflow.robot_pointed_out</name>
    <message>
        <source>robot &apos;%1&apos; pointed out in view &apos;%2&apos;</source>
        <translation>Roboter &apos;%1&apos;, gezeigt in Sicht &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.roster_line</name>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
</context>
<context>
    <name>workflow.run_calibrate</name>
    <message>
        <source>calibrate its lens, or import its intrinsics</source>
        <translation>ihr Objektiv kalibrieren oder ihre Objektivkalibrierung importieren</translation>
    </message>
</context>
<context>
    <name>workflow.run_in_older_axes</name>
    <message>
        <source>it has other axes: those of layout &apos;%1&apos; were changed after it was analysed</source>
        <translation>er hat andere Achsen: Die von Anordnung „%1“ wurden nach der Auswertung geändert</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_first</name>
    <message>
        <source>run odograph track first</source>
        <translation>verfolgen Sie zuerst</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_without_again</name>
    <message>
        <source>run odograph track without --again first</source>
        <translation>verfolgen Sie zuerst die Videos des Versuchs</translation>
    </message>
</context>
<context>
    <name>workflow.runs_in_other_axes</name>
    <message>
        <source>it has other axes (layout &apos;%1&apos;) than trial &apos;%2&apos; (layout &apos;%3&apos;)</source>
        <translation>er hat andere Achsen (Anordnung „%1“) als Versuch „%2“ (Anordnung „%3“)</translation>
    </message>
</context>
<context>
    <name>workflow.say_it_again</name>
    <message>
        <source>repeat it for frame %1</source>
        <translation>geben Sie es für Bild %1 noch einmal an</translation>
    </message>
</context>
<context>
    <name>workflow.scene_far_shifted</name>
    <message>
        <source>its scene is shifted by %1 against the image by which its camera was registered</source>
        <translation>ihre Szene ist gegenüber dem Bild um %1 verschoben, mit dem ihre Kamera eingemessen wurde</translation>
    </message>
</context>
<context>
    <name>workflow.scene_mirrored</name>
    <message>
        <source>it is mirrored against the image by which its camera was registered</source>
        <translation>sie ist gegenüber dem Bild gespiegelt, mit dem ihre Kamera eingemessen wurde</translation>
    </message>
</context>
<context>
    <name>workflow.scene_shifted</name>
    <message>
        <source>its scene is shifted by %1 against the image by which its camera was registered, so the camera was moved, and the stated errors were increased by that</source>
        <translation>ihre Szene ist gegenüber dem Bild um %1 verschoben, mit dem ihre Kamera eingemessen wurde; die Kamera wurde also bewegt, und die angegebenen Fehler wurden darum vergrößert</translation>
    </message>
</context>
<context>
    <name>workflow.scene_turned</name>
    <message>
        <source>it is turned by %1 against the image by which its camera was registered</source>
        <translation>sie ist gegenüber dem Bild um %1 gedreht, mit dem ihre Kamera eingemessen wurde</translation>
    </message>
</context>
<context>
    <name>workflow.scene_zoomed</name>
    <message>
        <source>it shows the scene %1 times as large as the image by which its camera was registered</source>
        <translation>sie zeigt die Szene %1-mal so groß wie das Bild, mit dem ihre Kamera eingemessen wurde</translation>
    </message>
</context>
<context>
    <name>workflow.see_flags_by_hand</name>
    <message>
        <source>see the flags by_hand in odograph export</source>
        <translation>die Auswertung zeigt, welche Werte von Hand bestimmt sind</translation>
    </message>
</context>
<context>
    <name>workflow.see_revisions</name>
    <message>
        <source>see the list of its revisions</source>
        <translation>die Liste ihrer Revisionen zeigt, welche es gibt</translation>
    </message>
</context>
<context>
    <name>workflow.set_range</name>
    <message>
        <source>set the range of %1</source>
        <translation>Bereich von %1 setzen</translation>
    </message>
</context>
<context>
    <name>workflow.settling_names</name>
    <message>
        <source>assigning names to the robots</source>
        <translation>Roboter werden zugeordnet</translation>
    </message>
</context>
<context>
    <name>workflow.several_image_series</name>
    <message>
        <source>the folder holds several series: %1 and %2</source>
        <translation>der Ordner enthält mehrere Reihen: %1 und %2</translation>
    </message>
</context>
<context>
    <name>workflow.several_robots</name>
    <message>
        <source>it has several robots</source>
        <translation>er hat mehrere Roboter</translation>
    </message>
</context>
<context>
    <name>workflow.show_mat</name>
    <message>
        <source>print the mat, lay it where the cameras see all of it, and record again</source>
        <translation>drucken Sie die Matte, legen Sie sie hin, wo die Kameras sie ganz sehen, und nehmen Sie noch einmal auf</translation>
    </message>
</context>
<context>
    <name>workflow.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and evenly lit, and check --pattern and --board</source>
        <translation>zeigen Sie die ganze Tafel, flach, scharf und gleichmäßig beleuchtet, und prüfen Sie Muster und Größe</translation>
    </message>
</context>
<context>
    <name>workflow.simulated_robot_not_found</name>
    <message>
        <source>the simulated robot was not found in the simulated views</source>
        <translation>der simulierte Roboter wurde in den simulierten Ansichten nicht gefunden</translation>
    </message>
</context>
<context>
    <name>workflow.simulating_run</name>
    <message>
        <source>simulating run %1 of %2</source>
        <translation>simuliert Fahrt %1 von %2</translation>
    </message>
</context>
<context>
    <name>workflow.slow_errors_not_seen</name>
    <message>
        <source>errors that change slowly are not included</source>
        <translation>Fehler, die sich langsam ändern, sind nicht enthalten</translation>
    </message>
</context>
<context>
    <name>workflow.sought_when_tracked</name>
    <message>
        <source>%1; tracking tries again</source>
        <translation>%1; das Verfolgen versucht es erneut</translation>
    </message>
</context>
<context>
    <name>workflow.sound_of_slow_motion</name>
    <message>
        <source>sound cannot be compared in clips that play in slow motion</source>
        <translation>in Clips, die in Zeitlupe laufen, lässt sich der Ton nicht vergleichen</translation>
    </message>
</context>
<context>
    <name>workflow.sound_unreadable</name>
    <message>
        <source>the sound of view &apos;%1&apos; cannot be read (%2)</source>
        <translation>der Ton der Sicht &apos;%1&apos; kann nicht gelesen werden (%2)</translation>
    </message>
</context>
<context>
    <name>workflow.spikes_change</name>
    <message>
        <source>Spikes: %1 instead of %2.</source>
        <translation>Ausreißer: %1 statt %2.</translation>
    </message>
</context>
<context>
    <name>workflow.stamps_too_dense</name>
    <message>
        <source>its time stamps mean %1, which no camera takes</source>
        <translation>ihre Zeitstempel bedeuten %1, was keine Kamera aufnimmt</translation>
    </message>
</context>
<context>
    <name>workflow.stopped_before_first_frame</name>
    <message>
        <source>it was stopped before the first frame came</source>
        <translation>sie wurde beendet, bevor das erste Bild kam</translation>
    </message>
</context>
<context>
    <name>workflow.synchronisation_of_view</name>
    <message>
        <source>synchronisation of view &apos;%1&apos;</source>
        <translation>Synchronisierung der Sicht &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_again</name>
    <message>
        <source>synchronise the views again and reanalyse</source>
        <translation>synchronisieren Sie die Sichten erneut und werten Sie neu aus</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_for_offset</name>
    <message>
        <source>synchronise it again with odograph trial set --sync auto, or enter the time offset</source>
        <translation>erneut synchronisieren (Versuch ▸ Synchronisieren…) oder den Zeitversatz dort eingeben</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_trial</name>
    <message>
        <source>synchronise %1: %2 (before: %3)</source>
        <translation>%1 synchronisieren: %2 (vorher: %3)</translation>
    </message>
</context>
<context>
    <name>workflow.take_fewer_cameras</name>
    <message>
        <source>close other programs, or use fewer such cameras at once</source>
        <translation>schließen Sie andere Programme, oder nehmen Sie weniger solche Kameras zugleich</translation>
    </message>
</context>
<context>
    <name>workflow.take_over_set_up</name>
    <message>
        <source>copy the set-up of %1</source>
        <translation>Aufbau von %1 übernehmen</translation>
    </message>
</context>
<context>
    <name>workflow.taking_over_set_up</name>
    <message>
        <source>copying the set-up</source>
        <translation>Aufbau wird übernommen</translation>
    </message>
</context>
<context>
    <name>workflow.task_was_changed</name>
    <message>
        <source>its task changed during the analysis</source>
        <translation>seine Aufgabe wurde während der Auswertung geändert</translation>
    </message>
</context>
<context>
    <name>workflow.task_without_course</name>
    <message>
        <source>task &apos;%1&apos; has neither a path nor gates to drive along</source>
        <translation>die Aufgabe &apos;%1&apos; hat weder eine Bahn noch Tore, an denen sich fahren lässt</translation>
    </message>
</context>
<context>
    <name>workflow.team_of_another_class</name>
    <message>
        <source>it belongs to class %1, not to class %2</source>
        <translation>es gehört zur Klasse %1, nicht zur Klasse %2</translation>
    </message>
</context>
<context>
    <name>workflow.through_itself</name>
    <message>
        <source>a camera cannot be registered via itself</source>
        <translation>eine Kamera kann nicht über sich selbst eingemessen werden</translation>
    </message>
</context>
<context>
    <name>workflow.time_of_trial</name>
    <message>
        <source>%1 of trial &apos;%2&apos;</source>
        <translation>%1 des Versuchs &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.times_count_from</name>
    <message>
        <source>its times start at %1</source>
        <translation>die Zeiten zählen ab %1</translation>
    </message>
</context>
<context>
    <name>workflow.times_given_twice</name>
    <message>
        <source>camera &apos;%1&apos; was given two tables of frame times</source>
        <translation>für Kamera &apos;%1&apos; wurden zwei Tabellen mit Bildzeiten angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_no_view</name>
    <message>
        <source>there are frame times for camera &apos;%1&apos;, but no video of it</source>
        <translation>für Kamera &apos;%1&apos; gibt es Bildzeiten, aber kein Video</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_other_count</name>
    <message>
        <source>it has %1 times, but the video of view &apos;%2&apos; has %3 frames</source>
        <translation>sie hat %1 Zeiten, aber das Video der Ansicht &apos;%2&apos; hat %3 Bilder</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_view</name>
    <message>
        <source>time stamps of view &apos;%1&apos;</source>
        <translation>Zeitstempel der Ansicht „%1“</translation>
    </message>
</context>
<context>
    <name>workflow.track</name>
    <message>
        <source>track %1</source>
        <translation>%1 verfolgen</translation>
    </message>
</context>
<context>
    <name>workflow.track_it_first</name>
    <message>
        <source>track it first</source>
        <translation>verfolgen Sie ihn zuerst</translation>
    </message>
</context>
<context>
    <name>workflow.track_of_file</name>
    <message>
        <source>the file&apos;s track &apos;%1&apos;</source>
        <translation>Spur &apos;%1&apos; der Datei</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_another</name>
    <message>
        <source>track it, or choose another</source>
        <translation>verfolgen Sie ihn, oder wählen Sie einen anderen</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_with_robot</name>
    <message>
        <source>track it, or choose another with --robot</source>
        <translation>verfolgen Sie ihn, oder wählen Sie einen anderen</translation>
    </message>
</context>
<context>
    <name>workflow.track_those_seen</name>
    <message>
        <source>track only the robots that are in view (--robot)</source>
        <translation>messen Sie nur die Roboter, die in den Bildern sind</translation>
    </message>
</context>
<context>
    <name>workflow.tracking</name>
    <message>
        <source>tracking</source>
        <translation>Verfolgung</translation>
    </message>
</context>
<context>
    <name>workflow.tracking_picture</name>
    <message>
        <source>tracking, frame %1 of %2</source>
        <translation>Verfolgung, Bild %1 von %2</translation>
    </message>
</context>
<context>
    <name>workflow.tracks_were_imported</name>
    <message>
        <source>its tracks were imported, so it has no video to track</source>
        <translation>seine Spuren wurden importiert, es gibt kein Video zum Verfolgen</translation>
    </message>
</context>
<context>
    <name>workflow.trial_being_recorded</name>
    <message>
        <source>trial &apos;%1&apos; is being recorded</source>
        <translation>Versuch &apos;%1&apos; wird gerade aufgenommen</translation>
    </message>
</context>
<context>
    <name>workflow.trial_is_there</name>
    <message>
        <source>the project already has a trial of that name</source>
        <translation>das Projekt hat einen Versuch dieses Namens</translation>
    </message>
</context>
<context>
    <name>workflow.trial_left_out</name>
    <message>
        <source>nothing of it had reached the disk, and it was removed</source>
        <translation>nichts davon war auf der Platte, er wird weggelassen</translation>
    </message>
</context>
<context>
    <name>workflow.turn_cameras_to_floor</name>
    <message>
        <source>turn the cameras to the same floor, and register them again</source>
        <translation>richten Sie die Kameras auf denselben Boden und messen Sie sie neu ein</translation>
    </message>
</context>
<context>
    <name>workflow.turn_or_flash</name>
    <message>
        <source>turn the robot, or flash the room light, in view of both cameras</source>
        <translation>lassen Sie den Roboter wenden oder das Raumlicht aufblitzen, wo es beide Kameras sehen</translation>
    </message>
</context>
<context>
    <name>workflow.two_mats</name>
    <message>
        <source>the files show mats of different paper</source>
        <translation>die Dateien zeigen Matten auf verschiedenem Papier</translation>
    </message>
</context>
<context>
    <name>workflow.two_views</name>
    <message>
        <source>views &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>Sichten &apos;%1&apos; und &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.unequal_files</name>
    <message>
        <source>%1 files of the first camera cannot be paired with %2 of the second one</source>
        <translation>%1 Dateien der ersten Kamera lassen sich nicht mit %2 der zweiten paaren</translation>
    </message>
</context>
<context>
    <name>workflow.unequal_rates</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_frame_rate</name>
    <message>
        <source>its frame rate is not between 0.1 and 100,000 frames a second</source>
        <translation>die Bildrate liegt nicht zwischen 0,1 und 100.000 Bildern pro Sekunde</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_length</name>
    <message>
        <source>the duration must be above zero and at most a day</source>
        <translation>die Dauer ist null, oder mehr als ein Tag</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_pre_roll</name>
    <message>
        <source>the pre-roll must be from 0 s to 10 s</source>
        <translation>was von vorher behalten wird, ist keine Zeit, oder mehr als 10 s</translation>
    </message>
</context>
<context>
    <name>workflow.use_as_it_is</name>
    <message>
        <source>use the results as they are</source>
        <translation>verwenden Sie die Ergebnisse, wie sie sind</translation>
    </message>
</context>
<context>
    <name>workflow.use_earlier_registration</name>
    <message>
        <source>if it moved before this trial, register it again and reanalyse</source>
        <translation>falls sie sich vor diesem Versuch bewegt hat, messen Sie sie neu ein und werten Sie erneut aus</translation>
    </message>
</context>
<context>
    <name>workflow.use_frame</name>
    <message>
        <source>use frame %1 of %2</source>
        <translation>Bild %1 von %2 verwenden</translation>
    </message>
</context>
<context>
    <name>workflow.use_frames</name>
    <message>
        <source>use %1 samples of %2</source>
        <translation>%1 Messpunkte von %2 verwenden</translation>
    </message>
</context>
<context>
    <name>workflow.use_original_or_register</name>
    <message>
        <source>use the file as the camera wrote it, or register the camera again in a frame of this video</source>
        <translation>verwenden Sie die Datei, wie die Kamera sie geschrieben hat, oder messen Sie die Kamera in einem Bild dieses Videos neu ein</translation>
    </message>
</context>
<context>
    <name>workflow.use_time_before</name>
    <message>
        <source>use the time before that only</source>
        <translation>verwenden Sie nur die Zeit davor</translation>
    </message>
</context>
<context>
    <name>workflow.verdict_on</name>
    <message>
        <source>verdict on trial &apos;%1&apos;</source>
        <translation>Urteil über Versuch „%1“</translation>
    </message>
</context>
<context>
    <name>workflow.video</name>
    <message>
        <source>video &apos;%1&apos;</source>
        <translation>Video &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.video_converted</name>
    <message>
        <source>one frame in %1 repeats the one before, because the video was converted to a higher frame rate; its frames were given the times at which they were taken</source>
        <translation>eines von %1 Bildern wiederholt das vorige, weil das Video in eine höhere Bildrate umgewandelt wurde; die Bilder erhielten die Zeiten, zu denen sie aufgenommen wurden</translation>
    </message>
</context>
<context>
    <name>workflow.video_without_picture</name>
    <message>
        <source>the video has no frame</source>
        <translation>das Video hat kein Bild</translation>
    </message>
</context>
<context>
    <name>workflow.view</name>
    <message>
        <source>view &apos;%1&apos;</source>
        <translation>Sicht &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.view_begun_later</name>
    <message>
        <source>%1 %2 later</source>
        <translation>%1 um %2 später</translation>
    </message>
</context>
<context>
    <name>workflow.view_ended_early</name>
    <message>
        <source>it ended early because %1</source>
        <translation>sie endete vorzeitig, denn %1</translation>
    </message>
</context>
<context>
    <name>workflow.view_is_kept</name>
    <message>
        <source>%1 of %2 view were saved, at most the last second is missing</source>
        <translation>%1 von %2 Sicht sind erhalten, alles bis auf höchstens die letzte Sekunde</translation>
    </message>
</context>
<context>
    <name>workflow.view_left_out</name>
    <message>
        <source>it recorded nothing and was left out</source>
        <translation>sie wird weggelassen, weil nichts von ihr aufgenommen wurde</translation>
    </message>
</context>
<context>
    <name>workflow.view_not_synchronised</name>
    <message>
        <source>%1 not synchronised</source>
        <translation>%1 nicht synchronisiert</translation>
    </message>
</context>
<context>
    <name>workflow.view_without_sound</name>
    <message>
        <source>view &apos;%1&apos; has no sound</source>
        <translation>Sicht &apos;%1&apos; hat keinen Ton</translation>
    </message>
</context>
<context>
    <name>workflow.views_are_kept</name>
    <message>
        <source>%1 of %2 views were saved, at most the last second is missing</source>
        <translation>%1 von %2 Sichten sind erhalten, alles bis auf höchstens die letzte Sekunde</translation>
    </message>
</context>
<context>
    <name>workflow.views_contradict</name>
    <message>
        <source>in %1 of %2 frames the views contradict each other</source>
        <translation>in %1 von %2 Bildern widersprechen sich die Sichten</translation>
    </message>
</context>
<context>
    <name>workflow.views_contradict_by</name>
    <message>
        <source>the views contradict each other by %1</source>
        <translation>die Sichten widersprechen einander um %1</translation>
    </message>
</context>
<context>
    <name>workflow.views_far_apart</name>
    <message>
        <source>in %1 of %2 frames the views show it at positions far apart</source>
        <translation>in %1 von %2 Bildern sehen ihn die Sichten an weit entfernten Orten</translation>
    </message>
</context>
<context>
    <name>workflow.views_put_it_apart</name>
    <message>
        <source>their floor positions differ by %1</source>
        <translation>sie setzen ihn %1 auseinander</translation>
    </message>
</context>
<context>
    <name>workflow.waited_for_disk</name>
    <message>
        <source>frames waited up to %1 for the disk, and none was lost</source>
        <translation>Bilder warteten bis zu %1 auf die Platte, keines ging verloren</translation>
    </message>
</context>
<context>
    <name>workflow.was_not_accepted</name>
    <message>
        <source>nobody accepted it</source>
        <translation>niemand hat es akzeptiert</translation>
    </message>
</context>
<context>
    <name>workflow.why_views_contradict</name>
    <message>
        <source>a camera has moved since its registration, the views are not synchronised, or the robot&apos;s height is wrong</source>
        <translation>eine Kamera wurde nach dem Einmessen bewegt, die Sichten laufen nicht synchron, oder der Roboter ist nicht so hoch wie angegeben</translation>
    </message>
</context>
<context>
    <name>workflow.withdraw_acceptance</name>
    <message>
        <source>withdraw the acceptance of %1</source>
        <translation>Annahme von %1 zurücknehmen</translation>
    </message>
</context>
<context>
    <name>workflow.write_address</name>
    <message>
        <source>write it like 224.5.23.2:10006</source>
        <translation>schreiben Sie etwa 224.5.23.2:10006</translation>
    </message>
</context>
<context>
    <name>workflow.writing_last_pictures</name>
    <message>
        <source>writing the last frames</source>
        <translation>die letzten Bilder werden geschrieben</translation>
    </message>
</context>
<context>
    <name>workflow.written_just_now</name>
    <message>
        <source>another program is writing or removing it</source>
        <translation>gerade schreibt oder entfernt es ein anderes Programm</translation>
    </message>
</context>
</TS>
