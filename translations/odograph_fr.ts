<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AccuracyLayer</name>
    <message>
        <source>expected ±, hatched: not visible</source>
        <translation>± attendu, hachures&#xa0;: non vu</translation>
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
        <translation>commencée %1 plus tôt</translation>
    </message>
    <message>
        <source>started %1 later</source>
        <translation>commencée %1 plus tard</translation>
    </message>
    <message>
        <source>Kalman/RTS, noise from the data</source>
        <translation>Kalman/RTS, bruit d’après les données</translation>
    </message>
    <message>
        <source>Savitzky–Golay, cubic, 11 points</source>
        <translation>Savitzky–Golay, cubique, 11 points</translation>
    </message>
    <message>
        <source>differences as in Tracker</source>
        <translation>différences comme dans Tracker</translation>
    </message>
    <message>
        <source>none: raw differences</source>
        <translation>aucun&#xa0;: différences brutes</translation>
    </message>
    <message>
        <source>%1, set by hand</source>
        <translation>%1, indiqué à la main</translation>
    </message>
    <message>
        <source>synchronised to %1 by the motion; %2</source>
        <translation>synchronisée à %1 près, d’après le mouvement&#xa0;; %2</translation>
    </message>
    <message>
        <source>synchronised to %1 by a flash of light; %2</source>
        <translation>synchronisée à %1 près, d’après un éclair de lumière&#xa0;; %2</translation>
    </message>
    <message>
        <source>synchronised to %1 by the cameras&apos; time stamps; %2</source>
        <translation>synchronisée à %1 près, par l’horodatage des caméras&#xa0;; %2</translation>
    </message>
    <message>
        <source>assumed to start at the same time</source>
        <translation>supposée commencée en même temps</translation>
    </message>
    <message>
        <source>, clock %1 ppm fast</source>
        <translation>, horloge trop rapide de %1 ppm</translation>
    </message>
    <message>
        <source>, clock %1 ppm slow</source>
        <translation>, horloge trop lente de %1 ppm</translation>
    </message>
    <message>
        <source>%1 to %2 ms apart</source>
        <translation>espacées de %1 à %2 ms</translation>
    </message>
    <message>
        <source>synchronised to %1 by sound; %2</source>
        <translation>synchronisée à %1 près, d’après le son&#xa0;; %2</translation>
    </message>
</context>
<context>
    <name>AnnotatedFrame</name>
    <message>
        <source>slow motion %1×</source>
        <translation>ralenti %1×</translation>
    </message>
    <message>
        <source>This camera was not recording at this time</source>
        <translation>Cette caméra n’enregistrait pas à cet instant</translation>
    </message>
    <message>
        <source>This frame cannot be decoded</source>
        <translation>Cette image ne peut pas être décodée</translation>
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
        <translation>Vecteur vitesse</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Vecteur accélération</translation>
    </message>
    <message>
        <source>Amount of acceleration</source>
        <translation>Norme de l’accélération</translation>
    </message>
    <message>
        <source>Cameras: %1</source>
        <translation>Caméras&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Robot&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>Épreuve&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>along the course of the task</source>
        <translation>le long du parcours de l’épreuve</translation>
    </message>
    <message>
        <source>over the floor that the cameras see: straight, a curve, stop and go</source>
        <translation>sur le sol que voient les caméras&#xa0;: ligne droite, courbe, arrêts et départs</translation>
    </message>
    <message>
        <source>The views of each camera were rendered with its lens, position, image size and frame rate, written as videos, and imported, synchronised, tracked and analysed as any others.</source>
        <translation>La vue de chaque caméra a été calculée avec son objectif, sa position, sa taille d’image et sa cadence, écrite en vidéo, puis importée, synchronisée, suivie et analysée comme toute autre.</translation>
    </message>
    <message>
        <source>A simulation shows what this geometry and this program can do, not what a certain recording did. It has even light, a still camera, a clean floor with the markers, sensor noise of 2 of 255 and an exposure of 8 ms at most, and a robot of simple solids in its colour and size.</source>
        <translation>Une simulation montre ce que peuvent cette géométrie et ce programme, non ce qu’a donné un enregistrement particulier. Elle a une lumière uniforme, une caméra immobile, un sol propre avec les repères, un bruit de capteur de 2 sur 255, une pose de 8 ms au plus et un robot de solides simples, de sa couleur et de sa taille.</translation>
    </message>
    <message>
        <source>It does not cover flicker, reflections, deep shadows and people in the view; the look of the real robot, cables and hands; a camera that was moved; markers that were measured wrongly; rolling shutters; and errors of lens calibration and registration beyond the stated ones.</source>
        <translation>Elle ne couvre pas les scintillements, les reflets, les ombres profondes et les personnes dans l’image&#xa0;; l’aspect du robot réel, les câbles et les mains&#xa0;; une caméra déplacée&#xa0;; des repères mal mesurés&#xa0;; les obturateurs déroulants&#xa0;; ni les erreurs d’étalonnage et de localisation au-delà de celles indiquées.</translation>
    </message>
    <message>
        <source>The verdict on a trial says which of these were noticed in its recording.</source>
        <translation>Le verdict sur un essai dit lesquels ont été remarqués dans son enregistrement.</translation>
    </message>
    <message>
        <source>The known run from above</source>
        <translation>Le passage connu vu de dessus</translation>
    </message>
    <message>
        <source>dashed: truth; strokes: errors of all runs, enlarged %1 times</source>
        <translation>tirets&#xa0;: vérité&#xa0;; traits&#xa0;: erreurs de tous les passages, agrandies&#xa0;%1 fois</translation>
    </message>
    <message>
        <source>root mean square</source>
        <translation>moyenne quadratique</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95&#xa0;% sous</translation>
    </message>
    <message>
        <source>stated ± (σ)</source>
        <translation>± indiqué (σ)</translation>
    </message>
    <message>
        <source>truth inside the stated 95 %</source>
        <translation>vérité dans les 95&#xa0;% indiqués</translation>
    </message>
    <message>
        <source>Errors against the truth</source>
        <translation>Erreurs par rapport à la vérité</translation>
    </message>
    <message>
        <source>%1 of %2 frames have a result</source>
        <translation>%1 images sur&#xa0;%2 ont un résultat</translation>
    </message>
    <message>
        <source>Certificate of this set-up</source>
        <translation>Certificat de cette installation</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Erreur de position</translation>
    </message>
    <message>
        <source>Velocity error</source>
        <translation>Erreur de vitesse</translation>
    </message>
    <message>
        <source>Acceleration error</source>
        <translation>Erreur d’accélération</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Couverture</translation>
    </message>
    <message>
        <source>true positions inside the stated 95 %</source>
        <translation>positions vraies dans les 95&#xa0;% indiqués</translation>
    </message>
    <message>
        <source>What was simulated</source>
        <translation>Ce qui a été simulé</translation>
    </message>
    <message>
        <source>What a simulation does not cover</source>
        <translation>Ce qu’une simulation ne couvre pas</translation>
    </message>
    <message>
        <source>%1, error in %2</source>
        <translation>%1, erreur en&#xa0;%2</translation>
    </message>
    <message>
        <source>a line for each run; dashed: what the first states for 95 %</source>
        <translation>une ligne par passage&#xa0;; tirets&#xa0;: ce que le premier indique pour 95&#xa0;%</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Localisation</translation>
    </message>
    <message>
        <source>σ on the floor</source>
        <translation>σ au sol</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>étalonné</translation>
    </message>
    <message>
        <source>estimated from the floor</source>
        <translation>estimé d’après le sol</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supposé</translation>
    </message>
    <message>
        <source>The views were synchronised by the motion, to %1 ms at worst.</source>
        <translation>Les vues ont été synchronisées par le mouvement, à&#xa0;%1 ms près au pire.</translation>
    </message>
    <message>
        <source>Certificate of this set-up: errors over time</source>
        <translation>Certificat de cette installation&#xa0;: erreurs dans le temps</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>The cameras</source>
        <translation>Les caméras</translation>
    </message>
    <message numerus="yes">
        <source>%n simulated run(s) of %1 s and %2 at up to %3, %4.</source>
        <translation>
            <numerusform>%n passage simulé de %1 s et %2, à %3 au plus, %4.</numerusform>
            <numerusform>%n passages simulés de %1 s et %2, à %3 au plus, %4.</numerusform>
        </translation>
    </message>
    <message>
        <source>Lens calibration</source>
        <translation>Ce que l’on sait de l’objectif</translation>
    </message>
    <message>
        <source>Simulated %1, Odograph %2. All errors are against the known truth of the simulation.</source>
        <translation>Simulé le&#xa0;%1, Odograph&#xa0;%2. Toutes les erreurs sont par rapport à la vérité connue de la simulation.</translation>
    </message>
    <message>
        <source>In each run the cameras are a little off from where the project has them, drawn from the stated uncertainty of their registration and lens calibration; so the errors include it.</source>
        <translation>À chaque passage, les caméras sont un peu à côté de leur place dans le projet, tirées selon l’incertitude indiquée de leur localisation et de l’étalonnage de l’objectif&#xa0;; les erreurs la comprennent.</translation>
    </message>
</context>
<context>
    <name>ClassReport</name>
    <message>
        <source>Rank: one more than the number of significantly better teams (medians differ by more than 1.96 σ). Teams of the same rank do not differ significantly.</source>
        <translation>Rang&#xa0;: un de plus que le nombre d’équipes sûrement meilleures (médianes distantes de plus de 1,96 σ)&#xa0;; les équipes de même rang ne peuvent pas être départagées.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them.</source>
        <translation>
            <numerusform>%n essai exclu&#xa0;: mesuré sur un autre parcours&#xa0;; remesurez-le.</numerusform>
            <numerusform>%n essais exclus&#xa0;: mesurés sur un autre parcours&#xa0;; remesurez-les.</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2 · Odograph %3</source>
        <translation>Page %1 sur %2 · Odograph %3</translation>
    </message>
    <message>
        <source>Odograph %1</source>
        <translation>Odograph %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>Épreuve&#xa0;: %1</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>selon&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>du %1 au %2</translation>
    </message>
    <message>
        <source>Teams</source>
        <translation>Équipes</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>sur %1</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Meilleur</translation>
    </message>
    <message>
        <source>Median of all runs</source>
        <translation>Médiane de tous les passages</translation>
    </message>
    <message>
        <source>Middle half of the runs</source>
        <translation>Moitié centrale des passages</translation>
    </message>
    <message>
        <source>The teams</source>
        <translation>Les équipes</translation>
    </message>
    <message>
        <source>each run is a dot; the line is the median of the team</source>
        <translation>chaque point est un passage&#xa0;; le trait est la médiane de l’équipe</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>Over the term</source>
        <translation>Au fil du temps</translation>
    </message>
    <message>
        <source>Its trials</source>
        <translation>Ses essais</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Class: %1</source>
        <translation>Classe&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message numerus="yes">
        <source>of %n team(s)</source>
        <translation>
            <numerusform>sur %n équipe</numerusform>
            <numerusform>sur %n équipes</numerusform>
        </translation>
    </message>
    <message>
        <source>class median %1</source>
        <translation>médiane classe&#xa0;: %1</translation>
    </message>
    <message>
        <source>Spread of one run</source>
        <translation>Dispersion d’un passage</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>%n essai non compté : résultats mauvais.</numerusform>
            <numerusform>%n essais non comptés : résultats mauvais.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! %n essai aux résultats douteux compté.</numerusform>
            <numerusform>! %n essais aux résultats douteux comptés.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ComparisonExplanation</name>
    <message>
        <source>No difference.</source>
        <translation>Il n’y a pas de différence.</translation>
    </message>
    <message>
        <source>Both values are exact: any difference is real.</source>
        <translation>Les deux sont exacts&#xa0;: la moindre différence en est une.</translation>
    </message>
    <message>
        <source>%1 σ, above 1.96: without a real difference, chance would give this much in fewer than 5 of 100 cases.</source>
        <translation>Elle vaut %1 σ, plus de 1,96&#xa0;: s’il n’y avait pas de différence, le hasard en donnerait autant dans moins de 5 cas sur 100.</translation>
    </message>
    <message>
        <source>%1 σ, not above 1.96: the difference is not significant.</source>
        <translation>Elle vaut %1 σ, pas plus de 1,96&#xa0;: elle est dans la marge d’erreur et l’on ne peut conclure à aucune différence.</translation>
    </message>
    <message>
        <source>along the task&apos;s reference path</source>
        <translation>le long du tracé de référence de l’épreuve</translation>
    </message>
    <message>
        <source>along the path of %1</source>
        <translation>le long du trajet de %1</translation>
    </message>
    <message>
        <source>time 0: each passes the start gate</source>
        <translation>temps 0&#xa0;: chacun franchit la porte de départ</translation>
    </message>
    <message>
        <source>time 0: each begins to move</source>
        <translation>temps 0&#xa0;: chacun se met en mouvement</translation>
    </message>
    <message>
        <source>time 0: each first reaches the same point of the path</source>
        <translation>temps 0&#xa0;: chacun arrive pour la première fois au même endroit du trajet</translation>
    </message>
    <message>
        <source>time 0: set by hand, to one frame</source>
        <translation>temps 0&#xa0;: indiqué à la main, à une image près</translation>
    </message>
    <message>
        <source>both with the same registrations and robot shape: the calibration uncertainty is common, so only its difference counts</source>
        <translation>tous deux avec les mêmes localisations et pour le même solide&#xa0;: la part de l’étalonnage est commune, seule sa différence compte</translation>
    </message>
    <message>
        <source>different registrations or robot shapes: the calibration uncertainty counts in full for both</source>
        <translation>pas avec les mêmes localisations, ou pas pour le même solide&#xa0;: la part de l’étalonnage compte en entier pour les deux</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>%1: %2 minus %3</source>
        <translation>%1&#xa0;: %2 moins %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>only one of the two runs has it</source>
        <translation>un seul des deux l’a</translation>
    </message>
    <message>
        <source>the value of %1 minus that of %2</source>
        <translation>la valeur de %1 moins celle de %2</translation>
    </message>
    <message>
        <source>Each: %1</source>
        <translation>Chacun&#xa0;: %1</translation>
    </message>
    <message>
        <source>√(σ₁² + σ₂²), treated as independent; where the runs share their calibration, its scale uncertainty counts only for the difference</source>
        <translation>√(σ₁² + σ₂²), les deux étant indépendants&#xa0;; si les passages partagent leur étalonnage, l’erreur d’échelle de celui-ci ne laisse que sa part de la différence</translation>
    </message>
    <message>
        <source>not visible at one end</source>
        <translation>non vu à une extrémité</translation>
    </message>
    <message>
        <source>Sector %1 to %2: %3 minus %4</source>
        <translation>Secteur de %1 à %2&#xa0;: %3 moins %4</translation>
    </message>
    <message>
        <source>begin</source>
        <translation>début</translation>
    </message>
    <message>
        <source>end</source>
        <translation>fin</translation>
    </message>
    <message>
        <source>For each run, the time from its first arrival at one gate to its first arrival at the next, by its position along the common path; waiting counts.</source>
        <translation>Le temps de la première arrivée à une porte à la première arrivée à la suivante, pour chaque passage, d’après sa place sur le tracé commun&#xa0;; les attentes comptent.</translation>
    </message>
    <message>
        <source>of each arrival: σ of the position along the path divided by the speed; displacements at two gates count as independent</source>
        <translation>de chaque arrivée&#xa0;: σ de la place le long du tracé, divisé par la vitesse&#xa0;; les déplacements à deux portes sont pris comme indépendants</translation>
    </message>
    <message>
        <source>from %1 to %2 along the path</source>
        <translation>de %1 à %2 du trajet</translation>
    </message>
    <message>
        <source>Δt of %1 against %2 at %3</source>
        <translation>Δt de %1 par rapport à %2 à %3</translation>
    </message>
    <message>
        <source>The time of the first arrival at this point of the common path, each from its own time 0: that of %1 minus that of %2. Positive means later.</source>
        <translation>Le temps de la première arrivée à cet endroit du tracé commun, chacun depuis son propre temps 0&#xa0;: celui de %1 moins celui de %2. Au-dessus de 0, il est en retard.</translation>
    </message>
    <message>
        <source>of both arrivals: σ of the position along the path divided by the speed, and of both times 0</source>
        <translation>des deux arrivées&#xa0;: σ de la place le long du tracé, divisé par la vitesse, et des deux temps 0</translation>
    </message>
    <message>
        <source>Speed of %1 at %2</source>
        <translation>Vitesse de %1 à %2</translation>
    </message>
    <message>
        <source>|v| of the smoothed curve where the run first reaches this point of the common path, interpolated between frames</source>
        <translation>|v| de la courbe lissée là où le passage arrive pour la première fois à cet endroit du tracé commun, interpolée entre les images</translation>
    </message>
    <message>
        <source>σ of the smoothed velocity there, including the calibration&apos;s scale uncertainty</source>
        <translation>σ de la vitesse lissée à cet endroit, avec l’erreur d’échelle de l’étalonnage</translation>
    </message>
    <message>
        <source>none: a run was not measured all the time, and is at least so large</source>
        <translation>aucune : un parcours n’a pas été mesuré tout le temps, et vaut au moins autant</translation>
    </message>
</context>
<context>
    <name>ComparisonReport</name>
    <message>
        <source>± one σ; grey, ≈: not significant</source>
        <translation>± un σ&#xa0;; gris, ≈&#xa0;: dans la marge d’erreur</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>right − left</source>
        <translation>droite − gauche</translation>
    </message>
    <message>
        <source>along the task’s path</source>
        <translation>le long du tracé de l’épreuve</translation>
    </message>
    <message>
        <source>along the path of the left run</source>
        <translation>le long du trajet du passage de gauche</translation>
    </message>
    <message>
        <source>aligned by the start gate, %1</source>
        <translation>alignés sur la porte de départ, %1</translation>
    </message>
    <message>
        <source>aligned by the onset of motion, %1</source>
        <translation>alignés sur le début du mouvement, %1</translation>
    </message>
    <message>
        <source>aligned by a point that both pass, %1</source>
        <translation>alignés sur un endroit où passent les deux, %1</translation>
    </message>
    <message>
        <source>aligned by hand, %1</source>
        <translation>alignés à la main, %1</translation>
    </message>
    <message>
        <source>Task: %1</source>
        <translation>Épreuve&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: analysed %2, Odograph %3</source>
        <translation>%1&#xa0;: analysé le %2, Odograph %3</translation>
    </message>
    <message>
        <source>Both runs share their calibration: its uncertainty largely cancels.</source>
        <translation>Les deux passages partagent leur étalonnage&#xa0;: son erreur se compense dans la mesure où ils le partagent.</translation>
    </message>
    <message>
        <source>The runs have different calibrations: the uncertainties of both count.</source>
        <translation>Les passages ne partagent pas leur étalonnage&#xa0;: les erreurs des deux comptent.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>Speed over distance, %1</source>
        <translation>Vitesse le long du trajet, %1</translation>
    </message>
    <message>
        <source>with its ±95 % band</source>
        <translation>avec sa bande à ±95&#xa0;%</translation>
    </message>
    <message>
        <source>Time difference, s</source>
        <translation>Écart de temps, s</translation>
    </message>
    <message>
        <source>above 0: the right run is later; grey: not significant</source>
        <translation>au-dessus de 0&#xa0;: le passage de droite est en retard&#xa0;; gris&#xa0;: dans la marge d’erreur</translation>
    </message>
    <message>
        <source>Sectors, s</source>
        <translation>Secteurs, s</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Grandeurs</translation>
    </message>
    <message>
        <source>Verdict on %1: %2</source>
        <translation>Verdict sur %1 : %2</translation>
    </message>
</context>
<context>
    <name>Conflict</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Épreuve</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Épreuves</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>Avec étoile</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>Archivé</translation>
    </message>
    <message>
        <source>In the bin</source>
        <translation>Dans la corbeille</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>Membres</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>Pseudonyme</translation>
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
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation>Analyses</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Grandeurs</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Portes</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>Zones</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>Barème</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>(masqué)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Measured values</source>
        <translation>Valeurs mesurées</translation>
    </message>
    <message>
        <source>this version</source>
        <translation>cette version</translation>
    </message>
    <message>
        <source>another version</source>
        <translation>une autre version</translation>
    </message>
</context>
<context>
    <name>Explanation</name>
    <message>
        <source>smoothed by Kalman filter and RTS smoother, noise by maximum likelihood (Rauch, Tung, Striebel 1965; Bar-Shalom et al. 2001)</source>
        <translation>lissé par filtre de Kalman et lisseur RTS, bruit par maximum de vraisemblance (Rauch, Tung, Striebel 1965&#xa0;; Bar-Shalom et al. 2001)</translation>
    </message>
    <message>
        <source>smoothed by a cubic through eleven points (Savitzky and Golay 1964)</source>
        <translation>lissé par une cubique sur onze points (Savitzky et Golay 1964)</translation>
    </message>
    <message>
        <source>differences as in Tracker, positions not smoothed</source>
        <translation>différences comme dans Tracker, positions non lissées</translation>
    </message>
    <message>
        <source>raw differences (Park 2018, eq. 6 to 8), nothing smoothed</source>
        <translation>différences brutes (Park 2018, éq. 6 à 8), rien n’est lissé</translation>
    </message>
    <message>
        <source>robot %1 high (estimated)</source>
        <translation>robot haut de %1 (estimé)</translation>
    </message>
    <message>
        <source>robot %1 high</source>
        <translation>robot haut de %1</translation>
    </message>
    <message>
        <source>analysis %1 by Odograph %2</source>
        <translation>analyse %1 par Odograph %2</translation>
    </message>
    <message>
        <source>σ of the smoothed velocity there, including the calibration&apos;s scale uncertainty</source>
        <translation>σ de la vitesse lissée à cet instant, avec l’erreur d’échelle de l’étalonnage</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>|v| = √(vx² + vy²) of the smoothed curve at this frame</source>
        <translation>|v| = √(vx² + vy²) de la courbe lissée à cette image</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>a·v/|v| of the smoothed curve at this frame: along the path, negative when braking; |a| while the robot stands still</source>
        <translation>a·v/|v| de la courbe lissée à cette image&#xa0;: le long de la trajectoire, donc négative au freinage&#xa0;; |a| à l’arrêt</translation>
    </message>
    <message>
        <source>σ of the smoothed acceleration there, including the calibration&apos;s scale uncertainty</source>
        <translation>σ de l’accélération lissée à cet instant, avec l’erreur d’échelle de l’étalonnage</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Cap</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Vitesse angulaire</translation>
    </message>
    <message>
        <source>Position X</source>
        <translation>Position X</translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation>Position Y</translation>
    </message>
    <message>
        <source>the smoothed curve at this frame</source>
        <translation>la courbe lissée à cette image</translation>
    </message>
    <message>
        <source>σ of the smoothed position, including the calibration&apos;s part</source>
        <translation>σ de la position lissée, avec la part de l’étalonnage</translation>
    </message>
    <message>
        <source>no view found the robot in this frame: the curve bridges the gap</source>
        <translation>à cette image, aucune vue n’a trouvé le robot&#xa0;: la courbe passe par-dessus</translation>
    </message>
    <message>
        <source>measured there: %1, %2 ±%3</source>
        <translation>mesuré ici&#xa0;: %1, %2 ±%3</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>par %1</translation>
    </message>
    <message>
        <source>it is flagged and not used: the curve follows its neighbours</source>
        <translation>il est signalé et inutilisé&#xa0;: la courbe vient de ses voisins</translation>
    </message>
    <message>
        <source>Jump: the position does not fit the motion before and after (χ² with two degrees of freedom, 99.9 %).</source>
        <translation>Saut&#xa0;: l’endroit est au-delà de ce que permet le mouvement avant et après (χ² à deux degrés de liberté, 99,9&#xa0;%).</translation>
    </message>
    <message>
        <source>Limit: to get there, the robot had to exceed the speed limit of the task or of the analysis.</source>
        <translation>Limite&#xa0;: pour y arriver, il aurait fallu aller plus vite que la limite de l’épreuve ou de l’analyse.</translation>
    </message>
    <message>
        <source>Limit: to get there, the robot had to exceed the acceleration limit of the task or of the analysis.</source>
        <translation>Limite&#xa0;: pour y arriver, il aurait fallu accélérer plus fort que la limite de l’épreuve ou de l’analyse.</translation>
    </message>
    <message>
        <source>Views disagree: their floor positions differ by more than their uncertainty and their usual disagreement explain (χ², 99.9 %).</source>
        <translation>Désaccord des vues&#xa0;: leurs positions diffèrent de plus que ne l’expliquent leurs erreurs et leur désaccord habituel (χ², 99,9&#xa0;%).</translation>
    </message>
    <message>
        <source>Low score: the tracker was not sure of what it saw.</source>
        <translation>Score faible&#xa0;: le suivi n’était pas sûr de ce qu’il voyait.</translation>
    </message>
    <message>
        <source>Lost: no view found the robot.</source>
        <translation>Perdu&#xa0;: aucune vue n’a trouvé le robot.</translation>
    </message>
    <message>
        <source>Repeated frame: the camera delivered the same frame twice, so its time is unknown.</source>
        <translation>Image répétée&#xa0;: la caméra a donné deux fois la même image, son instant n’est donc pas connu.</translation>
    </message>
    <message>
        <source>Bridged: the curve crosses a gap without measurements.</source>
        <translation>Comblé&#xa0;: la courbe passe par-dessus sans mesure.</translation>
    </message>
    <message>
        <source>By hand: a manual override replaces the result of the analysis.</source>
        <translation>À la main&#xa0;: une personne en a décidé, contre l’analyse.</translation>
    </message>
    <message>
        <source>How it is computed</source>
        <translation>Comment c’est calculé</translation>
    </message>
    <message>
        <source>What ± contains (one standard deviation)</source>
        <translation>Ce que ± contient (un écart-type)</translation>
    </message>
    <message>
        <source>What went into it</source>
        <translation>Ce qui y est entré</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>trial %1, robot %2</source>
        <translation>essai %1, robot %2</translation>
    </message>
    <message>
        <source>%1 of %2 samples used</source>
        <translation>%1 échantillons sur %2 utilisés</translation>
    </message>
    <message>
        <source>views: %1</source>
        <translation>vues&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: from %2 to %3, at most %4 beyond the edge</source>
        <translation>%1&#xa0;: de %2 à %3, au plus %4 au-delà du bord</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Spike at %1</source>
        <translation>Pic aberrant à %1</translation>
    </message>
    <message>
        <source>The sample is kept, but not used for the curve.</source>
        <translation>L’échantillon est conservé, mais n’est pas utilisé pour la courbe.</translation>
    </message>
    <message>
        <source>The curve uses the sample nevertheless: its faulty part was left out, or a manual override restored it.</source>
        <translation>L’échantillon est tout de même utilisé pour la courbe&#xa0;: ce qui est faux en a été exclu, ou une personne l’a rétabli.</translation>
    </message>
    <message>
        <source>the views&apos; floor positions differ by %1 there</source>
        <translation>les vues y sont distantes de %1</translation>
    </message>
    <message>
        <source>Of the body where its outline or an imported track shows it: the smoothed heading. Elsewhere the direction of motion: atan2(vy, vx) of the smoothed curve, kept where the robot stands still and continued where it reverses. Anticlockwise from X, without jumps of a whole turn.</source>
        <translation>Celui du corps là où son contour ou une trajectoire importée le montre : le cap lissé. Ailleurs, la direction du mouvement : atan2(vy, vx) de la courbe lissée, conservée là où le robot est à l’arrêt et prolongée là où il recule. Dans le sens trigonométrique depuis X, sans sauts d’un tour.</translation>
    </message>
    <message>
        <source>of the body: σ of its smoothed heading; of the direction of motion: σ of the velocity across the motion divided by the speed</source>
        <translation>du corps : σ de son cap lissé ; de la direction du mouvement : σ de la vitesse en travers du mouvement, divisé par la vitesse</translation>
    </message>
    <message>
        <source>Of the body where its heading was measured: the rate of the smoothed heading. Elsewhere (vx·ay − vy·ax)/|v|² of the smoothed curve.</source>
        <translation>Celle du corps là où son cap a été mesuré : la variation du cap lissé. Ailleurs (vx·ay − vy·ax)/|v|² de la courbe lissée.</translation>
    </message>
    <message>
        <source>of the body: σ of the smoothed heading&apos;s rate; of the direction of motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order</source>
        <translation>du corps : σ de la variation du cap lissé ; de la direction du mouvement : σ² = σa²/|v|² + |a|²σv²/|v|⁴, au premier ordre</translation>
    </message>
    <message>
        <source>of the robot&apos;s body, which was measured</source>
        <translation>du corps du robot, qui a été mesuré</translation>
    </message>
    <message>
        <source>of the direction of motion</source>
        <translation>de la direction du mouvement</translation>
    </message>
    <message>
        <source>Velocity X</source>
        <translation>Vitesse X</translation>
    </message>
    <message>
        <source>Velocity Y</source>
        <translation>Vitesse Y</translation>
    </message>
    <message>
        <source>the velocity of the smoothed curve at this frame along that axis</source>
        <translation>la vitesse de la courbe lissée à cette image selon cet axe</translation>
    </message>
    <message>
        <source>Lateral acceleration</source>
        <translation>Accélération latérale</translation>
    </message>
    <message>
        <source>(vx·ay − vy·ax)/|v| of the smoothed curve at this frame: across the path, positive to the left</source>
        <translation>(vx·ay − vy·ax)/|v| de la courbe lissée à cette image : en travers de la trajectoire, positive à gauche</translation>
    </message>
    <message>
        <source>σ² = σa² + (a·v/|v|)²σv²/|v|², first order: of the acceleration, and of the direction of motion</source>
        <translation>σ² = σa² + (a·v/|v|)²σv²/|v|², premier ordre : de l’accélération et de la direction du mouvement</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>À-coup</translation>
    </message>
    <message>
        <source>(a(t₂) − a(t₁))/(t₂ − t₁) along the path, from the smoothed accelerations half of %1 before and after this frame; its length while the robot stands still</source>
        <translation>(a(t₂) − a(t₁))/(t₂ − t₁) le long de la trajectoire, des accélérations lissées une moitié de %1 avant et après cette image ; sa norme tant que le robot est à l’arrêt</translation>
    </message>
    <message>
        <source>σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)², ρ the correlation of both errors</source>
        <translation>σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)², ρ la corrélation des deux erreurs</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>Distance parcourue</translation>
    </message>
    <message>
        <source>the integral of the smoothed speed over the time in which the robot moves, up to this frame</source>
        <translation>l’intégrale de la vitesse lissée sur le temps où le robot se déplace, jusqu’à cette image</translation>
    </message>
    <message>
        <source>of the positions at the ends of each motion, of errors across the path where it turns, and of the calibration&apos;s scale; without what the robot may have done while it was not measured</source>
        <translation>des positions aux extrémités de chaque mouvement, des erreurs transversales là où la trajectoire tourne et de l’échelle de l’étalonnage ; sans ce que le robot a pu faire pendant qu’il n’était pas mesuré</translation>
    </message>
    <message>
        <source>Distance from the start</source>
        <translation>Distance au départ</translation>
    </message>
    <message>
        <source>the straight line from the first smoothed position to this frame&apos;s</source>
        <translation>la ligne droite de la première position lissée à celle de cette image</translation>
    </message>
    <message>
        <source>of both positions along that line, and of the calibration&apos;s scale</source>
        <translation>des deux positions selon cette ligne et de l’échelle de l’étalonnage</translation>
    </message>
    <message>
        <source>Distance to the nearest robot</source>
        <translation>Distance au robot le plus proche</translation>
    </message>
    <message>
        <source>between the reference points of both robots at this frame&apos;s time, on the smoothed curves</source>
        <translation>entre les points de référence des deux robots à l’instant de cette image, sur les courbes lissées</translation>
    </message>
</context>
<context>
    <name>ExplanationDialog</name>
    <message>
        <source>How was this computed?</source>
        <translation>Comment est-ce calculé&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
</context>
<context>
    <name>FactExplanations</name>
    <message>
        <source>The time offset at which the robot&apos;s floor tracks from the two views coincide: least squares of r(t) = p₁(t) − p₂((t − offset)(1 + rate)), with a constant shift and a small scale between them, searched in steps of half a frame and refined by Gauss–Newton. The clock rate is used if it exceeds three σ.</source>
        <translation>Le décalage pour lequel les trajectoires du robot au sol, telles que les deux vues le voient, coïncident&#xa0;: moindres carrés de r(t) = p₁(t) − p₂((t − décalage)(1 + dérive)), avec entre elles une translation constante et une petite différence d’échelle, cherché par demi-images et affiné par Gauss–Newton. La dérive des horloges est retenue si elle dépasse trois σ.</translation>
    </message>
    <message>
        <source>from the curvature of the sum of squares and from the residual, assumed to be correlated over half a second</source>
        <translation>de la courbure de la somme des carrés et du résidu, supposé corrélé sur une demi-seconde</translation>
    </message>
    <message>
        <source>The time offset at which the jumps in brightness in both views coincide: the weighted mean of the pairs. It is used if every other offset is at least 150 times less likely.</source>
        <translation>Le décalage pour lequel les sauts de lumière vus par les deux vues coïncident, retenu si aucun autre décalage n’atteint le 150e de sa vraisemblance&#xa0;: la moyenne pondérée des paires.</translation>
    </message>
    <message>
        <source>from the pairs and their scatter, plus a tenth of a frame interval per view for its shutter</source>
        <translation>des paires, de leur dispersion, plus un dixième d’intervalle d’image par vue, pour son obturateur</translation>
    </message>
    <message>
        <source>Each camera&apos;s time stamps, converted to this computer&apos;s clock by reading the camera&apos;s clock during the recording.</source>
        <translation>L’horodatage de chaque caméra, rapporté à l’horloge de cet ordinateur par des lectures de celle de la caméra pendant l’enregistrement.</translation>
    </message>
    <message>
        <source>from both clock conversions</source>
        <translation>des deux relations entre horloges</translation>
    </message>
    <message>
        <source>Times at the gates</source>
        <translation>Temps aux portes</translation>
    </message>
    <message>
        <source>When the robot&apos;s reference point crosses the gate&apos;s line between its ends, in the direction of the gate. Between two frames, the smoothed position is the cubic through both positions and velocities. A passage counts if the point was before the line by three σ of the track&apos;s own noise and then is past it by as much.</source>
        <translation>L’instant où le centre du robot coupe la ligne de la porte entre ses extrémités, dans le sens où la porte se franchit&#xa0;: entre deux images, la position lissée est la cubique définie par les deux positions et les deux vitesses. La porte est franchie s’il était avant la ligne de trois σ du bruit propre à la trajectoire, puis après elle d’autant.</translation>
    </message>
    <message>
        <source>σ of the position across the gate divided by the speed across it, including the calibration&apos;s part</source>
        <translation>σ de la position en travers de la porte, divisé par la vitesse en travers de celle-ci, avec la part de l’étalonnage</translation>
    </message>
    <message>
        <source>From a passage of the start to one of the finish, or from one passage of a start-finish gate to the next. Of each split, the first passage counts.</source>
        <translation>D’un franchissement du départ à l’arrivée, ou d’une porte à la suivante&#xa0;; pour chaque intermédiaire, le premier franchissement compte.</translation>
    </message>
    <message>
        <source>from both passages; the calibration&apos;s uncertainty cancels for a gate passed twice at the same speed</source>
        <translation>des deux franchissements&#xa0;; l’erreur d’étalonnage d’une porte franchie deux fois à la même vitesse se compense</translation>
    </message>
    <message>
        <source>to %1: %2</source>
        <translation>jusqu’à %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Synchronisation of view %1 with the first</source>
        <translation>Vue %1 synchronisée avec la première</translation>
    </message>
    <message>
        <source>video %1, %2 frames</source>
        <translation>vidéo %1, %2 images</translation>
    </message>
    <message>
        <source>Height of robot %1</source>
        <translation>Hauteur du robot %1</translation>
    </message>
    <message>
        <source>The solid (box or cylinder, on the floor or a plate at the robot&apos;s top) whose silhouettes best match the outlines in all views, by weighted least squares at about forty times of the run. If no such solid explains them: the height at which all views give the same floor position.</source>
        <translation>Le solide (boîte ou cylindre, au sol, ou plaque au sommet du robot) dont les contours de toutes les vues sont les silhouettes, par moindres carrés pondérés à une quarantaine d’instants du passage&#xa0;; si aucun solide de ce genre ne les explique, la hauteur à laquelle toutes les vues placent le robot au même endroit.</translation>
    </message>
    <message>
        <source>The time offset at which claps, knocks or whistles in the sound of both views coincide: the weighted mean of the pairs, less the time that sound takes to reach each camera. It is used if every other offset is at least 150 times less likely.</source>
        <translation>Le décalage pour lequel les claquements de mains, les coups ou les sifflets dans le son des deux vues coïncident&#xa0;: la moyenne pondérée des paires, moins le temps que le son met à atteindre chaque caméra. Il est retenu si tout autre décalage est au moins 150 fois moins probable.</translation>
    </message>
    <message>
        <source>from the pairs, from where on the floor the sound may have come, 50 ppm of the time from the start of the recording to the sound, and 2 ms by which each camera may record its sound early or late</source>
        <translation>des paires, de l’endroit du sol d’où le son a pu venir, de 50 ppm du temps entre le début de l’enregistrement et le son, et de 2 ms dont chaque caméra peut avancer ou retarder son son</translation>
    </message>
</context>
<context>
    <name>FirstLesson</name>
    <message>
        <source>Play a run</source>
        <translation>Lire un passage</translation>
    </message>
    <message>
        <source>Two cameras filmed a robot. Press Space: both videos, the map and the curves play together. Press Space again to stop.</source>
        <translation>Deux caméras ont regardé rouler un robot. Appuyez sur Espace&#xa0;: les deux vidéos, la carte et les courbes avancent ensemble. Espace de nouveau arrête.</translation>
    </message>
    <message>
        <source>Read a result</source>
        <translation>Lire une valeur</translation>
    </message>
    <message>
        <source>Click the speed curve. The bubble shows the speed at that moment and its uncertainty (±). The band around the curve contains the true speed in 95 of 100 cases.</source>
        <translation>Cliquez dans la courbe de vitesse. La bulle donne la vitesse à cet instant et son ±&#xa0;: de combien elle peut être fausse. La bande autour de la courbe contient la vérité dans 95 cas sur 100.</translation>
    </message>
    <message>
        <source>Check the flagged samples</source>
        <translation>Voir ce qui est signalé</translation>
    </message>
    <message>
        <source>Press Ctrl+Page Up or Ctrl+Page Down until the list of spikes on the right is not empty. A spike is a measurement that cannot be true; the list gives the reason.</source>
        <translation>Parcourez les essais avec Ctrl+Page précédente et Ctrl+Page suivante jusqu’à un essai dont la liste de pics, à droite, n’est pas vide. Un pic aberrant est un instant où ce qui a été mesuré ne peut pas être vrai&#xa0;; la liste dit pourquoi.</translation>
    </message>
    <message>
        <source>Override it</source>
        <translation>En décider autrement</translation>
    </message>
    <message>
        <source>Click a spike in the list and watch the videos: was the robot really there? Press U to use the sample nevertheless. Odograph never deletes a measurement.</source>
        <translation>Cliquez sur un pic dans la liste et regardez les vidéos&#xa0;: le robot était-il vraiment là&#xa0;? Appuyez sur U pour utiliser quand même l’échantillon. Rien de ce qui a été mesuré n’est jamais perdu.</translation>
    </message>
    <message>
        <source>Undo it</source>
        <translation>Revenir en arrière</translation>
    </message>
    <message>
        <source>Press Ctrl+Z. Odograph saves every change at once, and you can undo it.</source>
        <translation>Appuyez sur Ctrl+Z. Tout ce que vous modifiez est enregistré aussitôt, et peut être annulé.</translation>
    </message>
    <message>
        <source>Compare two runs</source>
        <translation>Comparer deux passages</translation>
    </message>
    <message>
        <source>Press Ctrl+4. Choose two runs on the right: where was one faster? Grey differences are not significant.</source>
        <translation>Appuyez sur Ctrl+4. Choisissez deux passages à droite&#xa0;: où l’un était-il plus rapide, et l’écart dépasse-t-il la marge d’erreur&#xa0;? Ce qui est gris, non.</translation>
    </message>
    <message>
        <source>Find it again</source>
        <translation>Le retrouver</translation>
    </message>
    <message>
        <source>Press Ctrl+5. History lists the whole year: type a team&apos;s name to search, press Enter to open a run, and see under Teams who made progress.</source>
        <translation>Appuyez sur Ctrl+5. «&#xa0;Historique&#xa0;» garde toute l’année&#xa0;: tapez le nom d’une équipe pour chercher, ouvrez un passage avec Entrée, et voyez sous «&#xa0;Équipes&#xa0;» qui a progressé.</translation>
    </message>
    <message>
        <source>That&apos;s it</source>
        <translation>C’est tout</translation>
    </message>
    <message>
        <source>For your own robots: create a project (Ctrl+N). Its Start page leads you from the clips of two phones, or from connected cameras, to a first result. F1 explains each page.</source>
        <translation>Avec vos propres robots : créez un projet (Ctrl+N). Sa page Départ vous guide des vidéos de deux téléphones, ou de caméras connectées, à un premier résultat. F1 explique chaque page.</translation>
    </message>
</context>
<context>
    <name>GuidanceWords</name>
    <message>
        <source>searched</source>
        <translation>explorée</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignorée</translation>
    </message>
    <message>
        <source>%1 marked here</source>
        <translation>%1 marqué ici</translation>
    </message>
    <message>
        <source>%1 set by hand</source>
        <translation>%1 placé à la main</translation>
    </message>
    <message>
        <source>no robot visible, by hand</source>
        <translation>aucun robot visible, à la main</translation>
    </message>
    <message>
        <source>%1 not visible, by hand</source>
        <translation>%1 non visible, à la main</translation>
    </message>
</context>
<context>
    <name>HealthWatch</name>
    <message>
        <source>The project is read-only</source>
        <translation>Le projet ne peut qu’être lu</translation>
    </message>
    <message>
        <source>Opening the cameras…</source>
        <translation>Ouverture des caméras…</translation>
    </message>
    <message>
        <source>No camera is running</source>
        <translation>Aucune caméra ne tourne</translation>
    </message>
    <message>
        <source>No camera sends frames</source>
        <translation>Aucune caméra n’envoie d’images</translation>
    </message>
    <message>
        <source>This project is read-only: you cannot record into it.</source>
        <translation>Ce projet ne peut qu’être lu&#xa0;: rien ne peut y être enregistré.</translation>
    </message>
    <message>
        <source>Register &amp;it in Testbed</source>
        <translation>La locali&amp;ser dans «&#xa0;Banc&#xa0;»</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Keys</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>List of keys</source>
        <translation>Liste des raccourcis</translation>
    </message>
    <message>
        <source>About Odograph</source>
        <translation>À propos d’Odograph</translation>
    </message>
    <message>
        <source>Odograph %1</source>
        <translation>Odograph %1</translation>
    </message>
    <message>
        <source>Measures how a mobile robot moved, from the videos of ordinary cameras.

Free software under the GNU General Public License, version 3 or later, without any warranty.

The method follows S. Park, “Computational Vision for Automatic Tracking and Objective Estimation of Mobile Robot Trajectory”, 2018.</source>
        <translation>Mesure comment un robot mobile s’est déplacé, à partir des vidéos de caméras ordinaires.

Logiciel libre sous la licence publique générale GNU, version 3 ou ultérieure, sans aucune garantie.

La méthode suit S. Park, «&#xa0;Computational Vision for Automatic Tracking and Objective Estimation of Mobile Robot Trajectory&#xa0;», 2018.</translation>
    </message>
</context>
<context>
    <name>HtmlChart</name>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured</source>
        <translation>lissé, avec sa bande à ±95&#xa0;%&#xa0;; points&#xa0;: valeurs mesurées</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured; shaded: not measured</source>
        <translation>lissé, avec sa bande à ±95&#xa0;%&#xa0;; points&#xa0;: valeurs mesurées&#xa0;; ombré&#xa0;: non mesuré</translation>
    </message>
    <message>
        <source>Speed, %1</source>
        <translation>Vitesse, %1</translation>
    </message>
    <message>
        <source>Acceleration along the path, %1</source>
        <translation>Accélération le long de la trajectoire, %1</translation>
    </message>
</context>
<context>
    <name>HtmlMap</name>
    <message>
        <source>a square: %1</source>
        <translation>un carreau&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>The run from above</source>
        <translation>Le passage vu de dessus</translation>
    </message>
    <message>
        <source>coloured by speed, from 0 (dark) to %1 (light); ring: start, dot: end</source>
        <translation>coloré selon la vitesse, de 0 (foncé) à&#xa0;%1 (clair)&#xa0;; anneau&#xa0;: début, point&#xa0;: fin</translation>
    </message>
    <message>
        <source>Both runs from above</source>
        <translation>Les deux passages vus de dessus</translation>
    </message>
    <message>
        <source>in the colours of the runs</source>
        <translation>aux couleurs des passages</translation>
    </message>
</context>
<context>
    <name>HtmlPage</name>
    <message>
        <source>Made by Odograph %1; ± is one standard deviation.</source>
        <translation>Fait avec Odograph&#xa0;%1&#xa0;; ± est un écart type.</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>Verdict&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Grandeurs</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>grandeur</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>Intermédiaires</translation>
    </message>
    <message>
        <source>from the start to</source>
        <translation>du départ à</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Passage %1</translation>
    </message>
    <message>
        <source>sector to %1</source>
        <translation>secteur jusqu’à&#xa0;%1</translation>
    </message>
    <message>
        <source>No spikes.</source>
        <translation>Aucun pic aberrant.</translation>
    </message>
    <message numerus="yes">
        <source>Spikes: %n</source>
        <translation>
            <numerusform>Pics aberrants : %n</numerusform>
            <numerusform>Pics aberrants : %n</numerusform>
        </translation>
    </message>
    <message>
        <source>reason</source>
        <translation>raison</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n de plus</numerusform>
            <numerusform>et %n de plus</numerusform>
        </translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Where this comes from</source>
        <translation>D’où cela vient</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <source>Both runs share their calibration: its uncertainty largely cancels. ≈: not significant.</source>
        <translation>Les deux passages partagent leur étalonnage&#xa0;: son incertitude s’annule en grande partie. ≈&#xa0;: non significatif.</translation>
    </message>
    <message>
        <source>The runs have different calibrations: the uncertainties of both count. ≈: not significant.</source>
        <translation>Les passages ont des étalonnages différents&#xa0;: les incertitudes des deux comptent. ≈&#xa0;: non significatif.</translation>
    </message>
    <message>
        <source>Speed over distance, %1</source>
        <translation>Vitesse le long du trajet, %1</translation>
    </message>
    <message>
        <source>with its ±95 % band</source>
        <translation>avec sa bande à ±95&#xa0;%</translation>
    </message>
    <message>
        <source>Time difference, s</source>
        <translation>Écart de temps, s</translation>
    </message>
    <message>
        <source>above 0: the second run is later; grey: not significant</source>
        <translation>au-dessus de 0&#xa0;: le second passage est plus tard&#xa0;; gris&#xa0;: non significatif</translation>
    </message>
    <message>
        <source>Sectors, s</source>
        <translation>Secteurs, s</translation>
    </message>
</context>
<context>
    <name>Hub</name>
    <message>
        <source>Connected.</source>
        <translation>Connecté.</translation>
    </message>
    <message>
        <source>Everything had been sent.</source>
        <translation>Tout était déjà envoyé.</translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) sent.</source>
        <translation>
            <numerusform>%n élément envoyé.</numerusform>
            <numerusform>%n éléments envoyés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing new at the hub.</source>
        <translation>Rien de nouveau sur le serveur.</translation>
    </message>
    <message numerus="yes">
        <source>%n item(s) received.</source>
        <translation>
            <numerusform>%n élément reçu.</numerusform>
            <numerusform>%n éléments reçus.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recordings: %1 copied.</source>
        <translation>Enregistrements&#xa0;: %1 copiés.</translation>
    </message>
    <message numerus="yes">
        <source>%n more warning(s).</source>
        <translation>
            <numerusform>%n autre avertissement.</numerusform>
            <numerusform>%n autres avertissements.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Teacher: may change everything</source>
        <translation>Enseignant&#xa0;: peut tout modifier</translation>
    </message>
    <message>
        <source>Bench: publishes its own trials, reads those of others</source>
        <translation>Poste&#xa0;: publie ses essais, lit ceux des autres</translation>
    </message>
    <message>
        <source>Viewer: reads results only</source>
        <translation>Lecteur&#xa0;: lit seulement les résultats</translation>
    </message>
    <message>
        <source>Nothing: all is sent</source>
        <translation>Rien&#xa0;: tout est envoyé</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s)</source>
        <translation>
            <numerusform>%n modification</numerusform>
            <numerusform>%n modifications</numerusform>
        </translation>
    </message>
    <message>
        <source>password needed</source>
        <translation>mot de passe requis</translation>
    </message>
    <message>
        <source>server away</source>
        <translation>injoignable</translation>
    </message>
    <message>
        <source>not accepted</source>
        <translation>non accepté</translation>
    </message>
    <message>
        <source>Hub: %1</source>
        <translation>Serveur&#xa0;: %1</translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending, %1</source>
        <translation>
            <numerusform>Serveur&#xa0;: %n en attente, %1</numerusform>
            <numerusform>Serveur&#xa0;: %n en attente, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Hub: publishing…</source>
        <translation>Serveur&#xa0;: publication…</translation>
    </message>
    <message>
        <source>Hub: pulling…</source>
        <translation>Serveur&#xa0;: réception…</translation>
    </message>
    <message>
        <source>Hub: all sent</source>
        <translation>Serveur&#xa0;: tout est envoyé</translation>
    </message>
    <message numerus="yes">
        <source>Hub: %n pending</source>
        <translation>
            <numerusform>Serveur&#xa0;: %n en attente</numerusform>
            <numerusform>Serveur&#xa0;: %n en attente</numerusform>
        </translation>
    </message>
    <message>
        <source>no answer yet</source>
        <translation>pas encore de réponse</translation>
    </message>
    <message numerus="yes">
        <source>Hub: publishing, %n pending</source>
        <translation>
            <numerusform>Serveur&#xa0;: publication, %n en attente</numerusform>
            <numerusform>Serveur&#xa0;: publication, %n en attente</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MapPainting</name>
    <message>
        <source>grid %1 %2</source>
        <translation>grille de %1 %2</translation>
    </message>
</context>
<context>
    <name>MatWords</name>
    <message>
        <source>Row %1, sheet %2</source>
        <translation>Rangée %1, feuille %2</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>This line is %1 long on the whole mat. Measure it.</source>
        <translation>Cette ligne fait %1 sur le tapis entier. Mesurez-la.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets. Print at 100 % (actual size). Cut along the dashed lines.</source>
        <translation>Tapis de sol de %1 × %2 feuilles. Imprimer à 100 % (taille réelle). Couper le long des tirets.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets</source>
        <translation>Tapis de sol de %1 × %2 feuilles</translation>
    </message>
    <message>
        <source>1. Print all pages at 100 % (actual size), not fitted to the page.</source>
        <translation>1. Imprimez toutes les pages à 100 % (taille réelle), sans les ajuster à la page.</translation>
    </message>
    <message>
        <source>2. Cut each sheet along its dashed lines. Lay it on its neighbours, up to their thin lines, as drawn below, and tape the sheets together.</source>
        <translation>2. Coupez chaque feuille le long de ses lignes en tirets. Posez-la sur ses voisines, jusqu’à leurs lignes fines, comme dessiné ci-dessous, et collez les feuilles ensemble.</translation>
    </message>
    <message>
        <source>3. Measure the line at the lower edge. It should be %1 long; Odograph asks for what you measure.</source>
        <translation>3. Mesurez la ligne au bord inférieur. Elle devrait faire %1 ; Odograph demande ce que vous mesurez.</translation>
    </message>
    <message>
        <source>4. Lay the mat flat where every camera sees all of it. The lower left corner is the origin, the lower edge the x axis.</source>
        <translation>4. Posez le tapis à plat là où chaque caméra le voit en entier. Le coin inférieur gauche est l’origine, le bord inférieur l’axe x.</translation>
    </message>
</context>
<context>
    <name>Modes</name>
    <message>
        <source>Testbed</source>
        <translation>Banc</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Filmer</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Examiner</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
</context>
<context>
    <name>OutputQuestion</name>
    <message>
        <source>%1 is a file of another kind. Replace it?</source>
        <translation>%1 est un fichier d’un autre type. Le remplacer ?</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 existe déjà. Le remplacer ?</translation>
    </message>
</context>
<context>
    <name>OwnChanges</name>
    <message>
        <source>Done: %1. Press Ctrl+Z to undo it.</source>
        <translation>Fait&#xa0;: %1. Ctrl+Z l’annule.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Annulé&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Rétabli&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>PageMenus</name>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>T&amp;rial</source>
        <translation>&amp;Essai</translation>
    </message>
    <message>
        <source>&amp;Spikes</source>
        <translation>&amp;Pics</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Historique</translation>
    </message>
    <message>
        <source>Re&amp;cord</source>
        <translation>Fil&amp;mer</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Outils</translation>
    </message>
    <message>
        <source>Ran&amp;ge</source>
        <translation>Pla&amp;ge</translation>
    </message>
</context>
<context>
    <name>RangeFacts</name>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 à %2</translation>
    </message>
    <message>
        <source>The calibration&apos;s contribution to an angle is unknown and not included.</source>
        <translation>Ce que l’étalonnage ajoute à un angle n’est pas connu et n’y est pas compris.</translation>
    </message>
    <message>
        <source>Includes the position uncertainty of the calibration.</source>
        <translation>L’erreur de position de l’étalonnage y est comprise.</translation>
    </message>
    <message>
        <source>Includes the scale uncertainty of the calibration.</source>
        <translation>L’erreur d’échelle de l’étalonnage y est comprise.</translation>
    </message>
    <message>
        <source>Neighbouring points of a smoothed curve have correlated errors. They average out over time, not over frames: with a spectrum of r/(1 + (ω/ω₀)⁶) for the position, ω₀ = √2 σv/σx.</source>
        <translation>Les points voisins d’une courbe lissée partagent leur erreur&#xa0;: la moyenne la réduit donc selon le temps et non selon les images, avec pour la position un spectre en r/(1 + (ω/ω₀)⁶), ω₀ = √2 σv/σx.</translation>
    </message>
    <message>
        <source>From the smoothed curve, each value weighted by half the time to both neighbours: mean; median (the curve is below it half of the time); least and most, chosen by value + 2σ and value − 2σ; spread √(mean of the squared distance from the mean).</source>
        <translation>De la courbe lissée, chaque valeur comptant pour la moitié du temps jusqu’à ses deux voisines&#xa0;: sa moyenne, sa médiane (la moitié du temps se passe en dessous), le minimum et le maximum certains (d’après la valeur plus ou moins 2σ), et la dispersion √(moyenne du carré de la distance à la moyenne).</translation>
    </message>
    <message>
        <source>no value here</source>
        <translation>pas de valeur ici</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>median</source>
        <translation>médiane</translation>
    </message>
    <message>
        <source>least</source>
        <translation>minimum</translation>
    </message>
    <message>
        <source>most</source>
        <translation>maximum</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>dispersion</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message>
        <source>does not fit: χ² is %1 times what the uncertainties explain</source>
        <translation>pas cette forme&#xa0;: χ² vaut %1 fois ce que les erreurs expliquent</translation>
    </message>
    <message>
        <source>fits; the stated uncertainties are too large: χ² is %1 of its expected value</source>
        <translation>concorde&#xa0;; les erreurs annoncées sont trop grandes&#xa0;: χ² vaut %1 fois ce qu’elles laissent attendre</translation>
    </message>
    <message>
        <source>fits: χ² is %1 of its expected value</source>
        <translation>concorde&#xa0;: χ² vaut %1 fois ce que les erreurs laissent attendre</translation>
    </message>
    <message>
        <source>Fit of %1</source>
        <translation>Ajustement&#xa0;: %1</translation>
    </message>
    <message>
        <source>The polynomial in t − t₀ that minimises Σ(residual/σ)² over %1, t₀ = %2. χ² is that sum divided by its expected value: the number of points minus the degrees of freedom of the coefficients.</source>
        <translation>Le polynôme en t − t₀ de plus petit Σ(résidu/σ)² sur %1, t₀ = %2. χ² est cette somme, divisée par ce que les erreurs en laissent attendre&#xa0;: le nombre de points moins ce que prennent les coefficients.</translation>
    </message>
    <message>
        <source>the measured positions used</source>
        <translation>les positions mesurées utilisées</translation>
    </message>
    <message>
        <source>the smoothed curve</source>
        <translation>la courbe lissée</translation>
    </message>
    <message>
        <source>The larger of two uncertainties: that of the measurements, widened by 1 + 2Σρ for correlated residuals (here ×%1), and that of the smoothed curve, including the errors that persist.</source>
        <translation>Le plus grand des deux&#xa0;: celui des mesures, élargi du facteur 1 + 2Σρ des résidus s’ils sont corrélés (ici ×%1), et celui de la courbe lissée, qui sait ce qui persiste de leurs erreurs.</translation>
    </message>
    <message>
        <source>Assumes that the shape is correct; χ² far above 1 shows that it is not. χ² below 1 means that the smoother allows for more motion than the robot made.</source>
        <translation>On suppose que la forme est la vraie&#xa0;; un χ² bien supérieur à 1 dit que non. Inférieur à 1, il vient d’un lissage qui admet plus de mouvement qu’il n’y en a.</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>%1 to %2: %3</source>
        <translation>%1 à %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustement</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>à %1</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>pente</translation>
    </message>
    <message>
        <source>slope there</source>
        <translation>pente en ce point</translation>
    </message>
    <message>
        <source>times t²</source>
        <translation>facteur de t²</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>résidu</translation>
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
        <translation>panne</translation>
    </message>
    <message>
        <source>slow</source>
        <translation>lent</translation>
    </message>
    <message>
        <source>lost frames</source>
        <translation>pertes</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bon</translation>
    </message>
    <message>
        <source>, %1 ms</source>
        <translation>, %1 ms</translation>
    </message>
    <message>
        <source>; not registered</source>
        <translation>&#xa0;; non localisée</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>no camera sees it</source>
        <translation>non vu</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>non vu</translation>
    </message>
    <message>
        <source>x %1, y %2, %3</source>
        <translation>x %1, y %2, %3</translation>
    </message>
    <message>
        <source>; one camera sees it</source>
        <translation>&#xa0;; une caméra le voit</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>vu</translation>
    </message>
    <message>
        <source>fair</source>
        <translation>passable</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>décalé</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>Synchro</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En direct</translation>
    </message>
    <message>
        <source>%1 MB written</source>
        <translation>%1 Mo écrits</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Disque</translation>
    </message>
    <message>
        <source>Camera %1 is not registered to the floor: it records, but cannot locate robots.</source>
        <translation>La caméra %1 n’est pas localisée par rapport au sol&#xa0;: elle est enregistrée, mais ne peut pas dire où se trouve un robot.</translation>
    </message>
    <message>
        <source>Camera %1 was registered with frames of %2×%3, but now sends another size: it records, but cannot locate robots.</source>
        <translation>La caméra %1 a été localisée pour des images de %2×%3, qu’elle n’envoie pas en ce moment&#xa0;: elle est enregistrée, mais ne peut pas dire où se trouve un robot.</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>Enregistrement&#xa0;: %1</translation>
    </message>
    <message>
        <source>Camera %1: %2</source>
        <translation>Caméra %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>The disk is barely fast enough: record to a faster one, or with fewer cameras.</source>
        <translation>Le disque est à peine assez rapide&#xa0;: enregistrez sur un disque plus rapide, ou avec moins de caméras.</translation>
    </message>
    <message>
        <source>The disk is nearly full: %1</source>
        <translation>Le disque est presque plein&#xa0;: %1</translation>
    </message>
    <message>
        <source>The cameras are not synchronised: set both to the same frame rate.</source>
        <translation>Les caméras ne sont pas synchronisées&#xa0;: réglez-les toutes deux à la même cadence.</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n de plus</numerusform>
            <numerusform>et %n de plus</numerusform>
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
        <translation>Vitesse, %1</translation>
    </message>
    <message>
        <source>Acceleration along the path, %1</source>
        <translation>Accélération le long de la trajectoire, %1</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured</source>
        <translation>lissé, avec sa bande à ±95&#xa0;%&#xa0;; points&#xa0;: valeurs mesurées</translation>
    </message>
    <message>
        <source>No curve: the robot was not detected</source>
        <translation>Pas de courbe&#xa0;: le robot n’a pas été vu</translation>
    </message>
    <message>
        <source>smoothed, with its ±95 % band; dots: as measured; shaded: not measured</source>
        <translation>lissé, avec sa bande à ±95&#xa0;%&#xa0;; points&#xa0;: valeurs mesurées&#xa0;; ombré&#xa0;: non mesuré</translation>
    </message>
</context>
<context>
    <name>ReportMethod</name>
    <message>
        <source>%1: %2 frames at %3/s</source>
        <translation>%1&#xa0;: %2 images à %3/s</translation>
    </message>
    <message numerus="yes">
        <source>%n missing</source>
        <translation>
            <numerusform>%n manquante</numerusform>
            <numerusform>%n manquantes</numerusform>
        </translation>
    </message>
    <message>
        <source>lens calibrated to %1 px</source>
        <translation>objectif étalonné à %1 px près</translation>
    </message>
    <message>
        <source>registered to the floor to %1 px, %2</source>
        <translation>localisée par rapport au sol à %1 px près, %2</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>non localisée</translation>
    </message>
    <message>
        <source>%1 samples: %2 measured, %3 used, %4 flagged, %5 bridged; the views disagree by %6 on average</source>
        <translation>%1 échantillons&#xa0;: %2 mesurés, %3 utilisés, %4 signalés, %5 comblés&#xa0;; désaccord moyen des vues&#xa0;: %6</translation>
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
        <translation>vitesse, %1</translation>
    </message>
    <message>
        <source>± (σ)</source>
        <translation>± (σ)</translation>
    </message>
    <message>
        <source>acceleration, %1</source>
        <translation>accélération, %1</translation>
    </message>
    <message>
        <source>flags</source>
        <translation>signalé</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Ce qui a été mesuré</translation>
    </message>
    <message>
        <source>every sample, smoothed</source>
        <translation>tous les échantillons, lissés</translation>
    </message>
    <message>
        <source>one sample of %1, smoothed; all of them are in the exported file</source>
        <translation>un échantillon sur %1, lissé&#xa0;; tous sont dans le fichier exporté</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>smoother: %1</source>
        <translation>lissage&#xa0;: %1</translation>
    </message>
    <message>
        <source>analysed %1, Odograph %2</source>
        <translation>analysé le %1, Odograph %2</translation>
    </message>
    <message>
        <source>%1: method</source>
        <translation>%1&#xa0;: méthode</translation>
    </message>
    <message>
        <source>How the metrics were computed</source>
        <translation>Comment les grandeurs sont calculées</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>±: %1.</source>
        <translation>±&#xa0;: %1.</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>saut</translation>
    </message>
    <message>
        <source>speed limit</source>
        <translation>limite de vitesse</translation>
    </message>
    <message>
        <source>acceleration limit</source>
        <translation>limite d’accélération</translation>
    </message>
    <message>
        <source>views disagree</source>
        <translation>désaccord des vues</translation>
    </message>
    <message>
        <source>low score</source>
        <translation>score faible</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>duplicate frame</source>
        <translation>image répétée</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>interpolé</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
</context>
<context>
    <name>ReportStills</name>
    <message>
        <source>no image: the video cannot be read</source>
        <translation>pas d’image&#xa0;: la vidéo ne peut pas être lue</translation>
    </message>
    <message>
        <source>no image: the video is missing</source>
        <translation>pas d’image&#xa0;: la vidéo manque</translation>
    </message>
</context>
<context>
    <name>RobotColours</name>
    <message>
        <source>blue</source>
        <translation>bleu</translation>
    </message>
    <message>
        <source>vermilion</source>
        <translation>vermillon</translation>
    </message>
    <message>
        <source>green</source>
        <translation>vert</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>violet</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>orange</translation>
    </message>
    <message>
        <source>sky blue</source>
        <translation>bleu ciel</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
</context>
<context>
    <name>RunEvents</name>
    <message>
        <source>First seen, moving already</source>
        <translation>Apparaît, déjà en mouvement</translation>
    </message>
    <message>
        <source>Starts to move</source>
        <translation>Se met en mouvement</translation>
    </message>
    <message>
        <source>Last seen, still moving</source>
        <translation>Disparaît, encore en mouvement</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>S’arrête</translation>
    </message>
    <message>
        <source>Top speed, %1</source>
        <translation>Vitesse max., %1</translation>
    </message>
    <message>
        <source>Passes %1</source>
        <translation>Franchit %1</translation>
    </message>
    <message>
        <source>Spike: %1</source>
        <translation>Pic aberrant&#xa0;: %1</translation>
    </message>
    <message numerus="yes">
        <source>(%n samples)</source>
        <translation>
            <numerusform>(%n échantillon)</numerusform>
            <numerusform>(%n échantillons)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SceneDisagreement</name>
    <message>
        <source>Only one view at a time: nothing to compare</source>
        <translation>Une seule vue à la fois&#xa0;: rien à comparer</translation>
    </message>
    <message>
        <source>RMS %1, median %2</source>
        <translation>RMS %1, médiane %2</translation>
    </message>
    <message>
        <source>expected from the uncertainty: %1</source>
        <translation>attendu d’après les erreurs&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 – more than it explains</source>
        <translation>%1 – plus qu’elles n’expliquent</translation>
    </message>
    <message>
        <source>Disagreement of the views</source>
        <translation>Désaccord des vues</translation>
    </message>
    <message>
        <source>Each view alone gives a floor position of the robot. The chart shows the distance between these positions in each frame with two views or more (of more than two, the largest distance); RMS is √(mean of the squares). Unused samples are left out.
Expected is √(tr A + tr B + (v·σs)²) from the covariances A and B of two views (pixels and calibration), the speed v and the synchronisation uncertainty σs of the views.
Much more than expected means that a setting is wrong: the views are not synchronised (the distance grows with the speed), a camera has moved or is badly registered (it depends on the position), or the robot&apos;s height is wrong (it points to and from the cameras).</source>
        <translation>Chaque vue place à elle seule le robot à un endroit du sol. On montre la distance entre ces endroits à chaque image où au moins deux vues l’ont vu (la plus grande s’il y en a plus de deux)&#xa0;; la RMS est √(moyenne des carrés). Les échantillons non utilisés sont exclus.
La valeur attendue est √(tr A + tr B + (v·σs)²), avec les covariances A et B de deux vues (pixels et étalonnage), la vitesse v et la synchronisation σs des vues.
Bien plus qu’attendu signifie que quelque chose n’est pas comme indiqué&#xa0;: les vues ne sont pas synchronisées (le désaccord croît alors avec la vitesse), une caméra a bougé ou est mal localisée (il dépend alors de l’endroit), ou la hauteur du robot est fausse (il est alors dirigé vers les caméras ou à l’opposé).</translation>
    </message>
    <message>
        <source>%1 frames with two views or more; largest %2; views synchronised to %3 ms</source>
        <translation>%1 images où au moins deux vues l’ont vu&#xa0;; maximum %2&#xa0;; vues synchronisées à %3 ms près</translation>
    </message>
</context>
<context>
    <name>ScoreText</name>
    <message>
        <source>%1: not measured, no points (%2)</source>
        <translation>%1&#xa0;: non mesuré, aucun point (%2)</translation>
    </message>
    <message>
        <source>%1 %2: %3 points (%4)</source>
        <translation>%1 %2&#xa0;: %3 points (%4)</translation>
    </message>
    <message>
        <source>%1 %2: %3 of %4 points (%5)</source>
        <translation>%1 %2&#xa0;: %3 points sur %4 (%5)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>sur %1</translation>
    </message>
    <message>
        <source>the sum of the points of each line; a line gives points × (metric − none at) / (all at − none at), from 0 to all</source>
        <translation>la somme des points de chaque ligne&#xa0;; une ligne donne points × (valeur − aucun à) / (tous à − aucun à), de 0 à tous</translation>
    </message>
    <message>
        <source>for each line, half the difference in points between its metric plus and minus one σ; root of the sum of the squares</source>
        <translation>de chaque ligne, la moitié de ce dont ses points changent quand sa valeur est plus grande ou plus petite d’un σ&#xa0;; racine de la somme des carrés</translation>
    </message>
    <message>
        <source>%1 points off at %2 or less, none off at %3 or more</source>
        <translation>%1 points retirés à %2 ou moins, aucun à %3 ou plus</translation>
    </message>
    <message>
        <source>%1 points off at %2 or more, none off at %3 or less</source>
        <translation>%1 points retirés à %2 ou plus, aucun à %3 ou moins</translation>
    </message>
    <message>
        <source>%1 points at %2 or less, none at %3 or more</source>
        <translation>%1 points à %2 ou moins, aucun à %3 ou plus</translation>
    </message>
    <message>
        <source>%1 points at %2 or more, none at %3 or less</source>
        <translation>%1 points à %2 ou plus, aucun à %3 ou moins</translation>
    </message>
</context>
<context>
    <name>Scoreboard</name>
    <message>
        <source>Standings</source>
        <translation>Classement</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Meilleur</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Dernier</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Parcours</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>Best run</source>
        <translation>Meilleur parcours</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Connexion…</translation>
    </message>
    <message>
        <source>Connection lost. Reconnecting…</source>
        <translation>Connexion perdue. Reconnexion…</translation>
    </message>
    <message>
        <source>This page needs JavaScript.</source>
        <translation>Cette page nécessite JavaScript.</translation>
    </message>
    <message>
        <source>Teams rank by the median of their runs. Teams that do not differ significantly (95 %) share a rank. ±: one standard deviation. ≈: not significantly behind the first.</source>
        <translation>Le rang est donné par la médiane des parcours. Les équipes sans différence significative (95 %) partagent un rang. ± : un écart-type. ≈ : pas de retard significatif sur la première.</translation>
    </message>
    <message>
        <source>No ranks: no trial has a task, and runs of different tasks cannot be compared.</source>
        <translation>Pas de rangs : aucun essai n’a d’épreuve, et les parcours d’épreuves différentes ne sont pas comparables.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course.</source>
        <translation>
            <numerusform>%n essai exclu&#xa0;: mesuré sur un autre parcours.</numerusform>
            <numerusform>%n essais exclus&#xa0;: mesurés sur un autre parcours.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results.</source>
        <translation>
            <numerusform>%n essai non compté : résultats mauvais.</numerusform>
            <numerusform>%n essais non comptés : résultats mauvais.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>! %n trial(s) with doubtful results counted.</source>
        <translation>
            <numerusform>! %n essai aux résultats douteux compté.</numerusform>
            <numerusform>! %n essais aux résultats douteux comptés.</numerusform>
        </translation>
    </message>
    <message>
        <source>No team has a result yet.</source>
        <translation>Aucune équipe n’a encore de résultat.</translation>
    </message>
    <message>
        <source>Running now</source>
        <translation>En cours</translation>
    </message>
    <message>
        <source>The best run from above</source>
        <translation>Le meilleur parcours vu d’en haut</translation>
    </message>
    <message>
        <source>a square: %1</source>
        <translation>un carreau : %1</translation>
    </message>
</context>
<context>
    <name>SetupWords</name>
    <message>
        <source>Two phones on tripods are enough. Film the robot with both, import the clips or drop them on this window; or connect cameras.</source>
        <translation>Deux téléphones sur trépied suffisent. Filmez le robot avec les deux, importez les vidéos ou déposez-les sur cette fenêtre ; ou connectez des caméras.</translation>
    </message>
    <message>
        <source>Cameras: %1.</source>
        <translation>Caméras : %1.</translation>
    </message>
    <message>
        <source>Print the mat, tape it together and lay it where every camera sees it while it films: from it Odograph knows where the floor is.</source>
        <translation>Imprimez le tapis, collez-le et posez-le là où chaque caméra le voit pendant qu’elle filme : par lui, Odograph sait où est le sol.</translation>
    </message>
    <message>
        <source>Positions on the floor: %1.</source>
        <translation>Positions au sol : %1.</translation>
    </message>
    <message>
        <source>Not registered yet: %1.</source>
        <translation>Pas encore localisées : %1.</translation>
    </message>
    <message>
        <source>A printed board measures the distortion of the lens; without it positions far from the mat are less exact, and their ± says so.</source>
        <translation>Une mire imprimée montre comment l’objectif courbe l’image ; sans elle, les positions loin du tapis sont moins exactes, et leur ± le dit.</translation>
    </message>
    <message>
        <source>Calibrated: %1.</source>
        <translation>Étalonnées : %1.</translation>
    </message>
    <message>
        <source>A name is enough: Odograph finds a robot of any look by its motion.</source>
        <translation>Un nom suffit : Odograph trouve un robot de n’importe quel aspect par son mouvement.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 autres</translation>
    </message>
    <message>
        <source>Robots: %1.</source>
        <translation>Robots : %1.</translation>
    </message>
    <message>
        <source>Imported clips are tracked here, or record with connected cameras.</source>
        <translation>Ici, les vidéos importées sont suivies ; ou filmez avec des caméras connectées.</translation>
    </message>
    <message>
        <source>%1 is not measured yet.</source>
        <translation>%1 n’est pas encore mesuré.</translation>
    </message>
    <message>
        <source>%1 is measured.</source>
        <translation>%1 est mesuré.</translation>
    </message>
    <message>
        <source>Path, speed, acceleration and their ±, spikes with reasons: one PDF for each trial, or for the class.</source>
        <translation>Trajet, vitesse, accélération et leur ±, pics et leurs raisons : un PDF par essai, ou pour la classe.</translation>
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
        <translation>tag</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>anneau</translation>
    </message>
    <message>
        <source>dot</source>
        <translation>point</translation>
    </message>
    <message>
        <source>tape crossing</source>
        <translation>croix d’adhésif</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>coin</translation>
    </message>
    <message>
        <source>crossing fields</source>
        <translation>croix de damier</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
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
        <translation>Damier, %1 × %2 coins intérieurs, carrés de %3</translation>
    </message>
    <message>
        <source>ChArUco board, %1 × %2 inner corners, squares of %3</source>
        <translation>Mire ChArUco, %1 × %2 coins intérieurs, carrés de %3</translation>
    </message>
    <message>
        <source>Floor marker %1 (tag 36h11 number %2), %3</source>
        <translation>Marqueur au sol %1 (tag 36h11 numéro %2), %3</translation>
    </message>
    <message>
        <source>Floor marker %1 (ring), %2</source>
        <translation>Marqueur au sol %1 (anneau), %2</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size). Glue it flat onto something stiff, measure a square, and enter its side in Odograph.</source>
        <translation>Imprimez à 100&#xa0;% (taille réelle). Collez bien à plat sur un support rigide, mesurez un carré, et indiquez à Odograph ce que vous avez mesuré.</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size). Lay it flat; the marker&apos;s position is its middle, where the four lines at the edges point.</source>
        <translation>Imprimez à 100&#xa0;% (taille réelle). Posez à plat&#xa0;; la place du marqueur est son centre, là où pointent les quatre traits des bords.</translation>
    </message>
    <message>
        <source>Floor mat of %1 × %2 sheets</source>
        <translation>Tapis de sol de %1 × %2 feuilles</translation>
    </message>
</context>
<context>
    <name>TestbedState</name>
    <message>
        <source>standard</source>
        <translation>standard</translation>
    </message>
    <message>
        <source>rational</source>
        <translation>rationnel</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>fisheye</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>Taille de l’image</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Objectif</translation>
    </message>
    <message>
        <source>%1, f = %2 px</source>
        <translation>%1, f = %2 px</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Board error</source>
        <translation>Erreur sur la mire</translation>
    </message>
    <message>
        <source>%1 px in %2 images</source>
        <translation>%1 px sur %2 photos</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>Erreur de validation</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>On the floor</source>
        <translation>Au sol</translation>
    </message>
    <message>
        <source>registered %1</source>
        <translation>localisée le %1</translation>
    </message>
    <message>
        <source>Last check</source>
        <translation>Dernier contrôle</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Place</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3 m high</source>
        <translation>x %1 m, y %2 m, hauteur %3 m</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Attention</translation>
    </message>
    <message>
        <source>not registered: cannot measure positions yet</source>
        <translation>non localisée&#xa0;: les positions ne peuvent pas encore être mesurées</translation>
    </message>
    <message>
        <source>not calibrated: estimated from the markers</source>
        <translation>non étalonnée : estimée d’après les marqueurs</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>non étalonnée</translation>
    </message>
</context>
<context>
    <name>TrailPainting</name>
    <message>
        <source>0 to %1 %2</source>
        <translation>0 à %1 %2</translation>
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
        <translation>Pas encore de courbe&#xa0;: suivez l’essai</translation>
    </message>
</context>
<context>
    <name>TrialExport</name>
    <message>
        <source>CSV for programs (*.csv)</source>
        <translation>CSV pour programmes (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1.5 (*.csv)</source>
        <translation>CSV pour tableurs, 1.5 (*.csv)</translation>
    </message>
    <message>
        <source>CSV for spreadsheets, 1,5 (*.csv)</source>
        <translation>CSV pour tableurs, 1,5 (*.csv)</translation>
    </message>
    <message>
        <source>Tracker text (*.txt)</source>
        <translation>Texte Tracker (*.txt)</translation>
    </message>
    <message>
        <source>TUM trajectory (*.tum)</source>
        <translation>Trajectoire TUM (*.tum)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Robot:</source>
        <translation>Robot&#xa0;:</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>Exporter %1</translation>
    </message>
    <message>
        <source>%1 was exported to %2.</source>
        <translation>%1 a été exporté vers %2.</translation>
    </message>
    <message>
        <source>Page to take along (*.html)</source>
        <translation>Page à emporter (*.html)</translation>
    </message>
</context>
<context>
    <name>TrialFacts</name>
    <message>
        <source>%1, %2 high (estimated)</source>
        <translation>%1, haut de %2 (estimé)</translation>
    </message>
    <message>
        <source>%1, %2 high</source>
        <translation>%1, haut de %2</translation>
    </message>
    <message>
        <source>%1: %2×%3, %4 frames</source>
        <translation>%1&#xa0;: %2×%3, %4 images</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>video missing</source>
        <translation>vidéo manquante</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>non localisée</translation>
    </message>
    <message>
        <source>Synchronisation</source>
        <translation>Synchro</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>not synchronised</source>
        <translation>non synchronisée</translation>
    </message>
    <message>
        <source>SHA-256 %1…</source>
        <translation>SHA-256 %1…</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Portes</translation>
    </message>
    <message>
        <source>to %1 %2</source>
        <translation>jusqu’à %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Lap %1</source>
        <translation>Tour %1</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Passage %1</translation>
    </message>
    <message>
        <source>off by %1 on average</source>
        <translation>écart moyen de %1</translation>
    </message>
    <message>
        <source>%1 (RMS)</source>
        <translation>%1 (RMS)</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>%1 au plus</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 vers la gauche</translation>
    </message>
    <message>
        <source>%1 of it completed</source>
        <translation>accompli à %1</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>respectées</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Épreuve</translation>
    </message>
    <message>
        <source>analysed with a different course</source>
        <translation>mesuré sur un autre parcours</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Score</translation>
    </message>
    <message>
        <source>none until you reanalyse the trial: the task has a different course now</source>
        <translation>aucun avant d’être remesuré&#xa0;: l’épreuve a maintenant un autre parcours</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Testbed</source>
        <translation>Banc d’essai</translation>
    </message>
    <message>
        <source>markers “%1”</source>
        <translation>marqueurs «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Imported</source>
        <translation>Importé</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Tracé</translation>
    </message>
    <message>
        <source>Distance from the path</source>
        <translation>Écart au tracé</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>Zones</translation>
    </message>
    <message>
        <source>Smoother</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>Analysed</source>
        <translation>Analysé</translation>
    </message>
    <message>
        <source>%1, Odograph %2</source>
        <translation>%1, Odograph %2</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>rate varies</source>
        <translation>cadence variable</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Accept…</source>
        <translation>Accepter…</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Plage</translation>
    </message>
    <message>
        <source>%1 to %2 of %3</source>
        <translation>de %1 à %2 sur %3</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>In millimetres</source>
        <translation>En millimètres</translation>
    </message>
</context>
<context>
    <name>TrialLines</name>
    <message>
        <source>What the synchronisation is worth</source>
        <translation>Ce que vaut la synchronisation</translation>
    </message>
    <message>
        <source>σ of the time anywhere in the recording, of the offset and of the clock rate over its length, times the run&apos;s top speed. The remaining time error τ is that of d² = d₀² + τ²v² between the views&apos; distance d and the speed v: least squares over means of half a second.</source>
        <translation>σ du temps en tout point de l’enregistrement, du décalage et de la marche de l’horloge sur sa durée, multiplié par la vitesse maximale de l’essai. L’erreur de temps restante τ est celle de d² = d₀² + τ²v² entre la distance d des vues et la vitesse v : moindres carrés sur des moyennes d’une demi-seconde.</translation>
    </message>
    <message>
        <source>of τ: by the scatter of those means. Blur grows with the speed, too, so τ is at most as stated.</source>
        <translation>de τ : par la dispersion de ces moyennes. Le flou augmente aussi avec la vitesse, donc τ est au plus la valeur indiquée.</translation>
    </message>
    <message>
        <source>view %1: %2 frames</source>
        <translation>vue %1 : %2 images</translation>
    </message>
    <message>
        <source>±%1 at the top speed</source>
        <translation>±%1 à la vitesse maximale</translation>
    </message>
    <message>
        <source>%1: never inside</source>
        <translation>%1 : jamais dedans</translation>
    </message>
    <message>
        <source>%1: inside for at least %2</source>
        <translation>%1 : dedans au moins %2</translation>
    </message>
    <message>
        <source>%1: inside for %2</source>
        <translation>%1 : dedans %2</translation>
    </message>
    <message>
        <source>, from the start</source>
        <translation>, dès le début</translation>
    </message>
    <message numerus="yes">
        <source>, entered %n time(s)</source>
        <translation>
            <numerusform>, %n entrée</numerusform>
            <numerusform>, %n entrées</numerusform>
        </translation>
    </message>
    <message>
        <source>, first after %1</source>
        <translation>, la première après %1</translation>
    </message>
</context>
<context>
    <name>TrialReport</name>
    <message>
        <source>class median %1</source>
        <translation>médiane classe&#xa0;: %1</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Score</translation>
    </message>
    <message>
        <source>The run from above</source>
        <translation>Le passage vu de dessus</translation>
    </message>
    <message>
        <source>coloured by speed</source>
        <translation>coloré selon la vitesse</translation>
    </message>
    <message>
        <source>The cameras’ views</source>
        <translation>Les vues des caméras</translation>
    </message>
    <message>
        <source>at %1, the top speed</source>
        <translation>à %1, au plus vite</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>à %1</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Ce qui s’est passé</translation>
    </message>
    <message>
        <source>It did not move</source>
        <translation>Il n’a pas bougé</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>Intermédiaires</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Passage %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>jusqu’à %1</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Grandeurs</translation>
    </message>
    <message>
        <source>± one σ</source>
        <translation>± un σ</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>This trial has not been tracked yet: it has no metrics.</source>
        <translation>Cet essai n’a pas encore été suivi&#xa0;: il n’y a pas de valeurs.</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Épreuve</translation>
    </message>
    <message>
        <source>%1 times in all</source>
        <translation>%1 fois en tout</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… et %n autre</numerusform>
            <numerusform>… et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Bad results: do not use them.</source>
        <translation>Résultats mauvais : ne les utilisez pas.</translation>
    </message>
    <message>
        <source>Doubtful results, which were accepted.</source>
        <translation>Résultats douteux, qui ont été acceptés.</translation>
    </message>
    <message>
        <source>Doubtful results: read the reasons before you use them.</source>
        <translation>Résultats douteux : lisez les raisons avant de les utiliser.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Plage</translation>
    </message>
</context>
<context>
    <name>UncertainIntervals</name>
    <message>
        <source>Which robot? Until %1</source>
        <translation>Quel robot&#xa0;? Jusqu’à %1</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (de %2 à %3)</translation>
    </message>
    <message>
        <source>Not measured until %1</source>
        <translation>Non mesuré jusqu’à %1</translation>
    </message>
    <message>
        <source>not measured (%1 to %2)</source>
        <translation>non mesuré (de %1 à %2)</translation>
    </message>
</context>
<context>
    <name>VerdictMark</name>
    <message>
        <source>accepted</source>
        <translation>accepté</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>douteux</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>mauvais</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>réussi</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Accepté : %1</translation>
    </message>
    <message>
        <source>all checks passed</source>
        <translation>tous les contrôles réussis</translation>
    </message>
</context>
<context>
    <name>WindowTitle</name>
    <message>
        <source>Team %1</source>
        <translation>Équipe %1</translation>
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
        <translation>une constante</translation>
    </message>
</context>
<context>
    <name>analysis.a_parabola</name>
    <message>
        <source>a parabola</source>
        <translation>une parabole</translation>
    </message>
</context>
<context>
    <name>analysis.a_straight_line</name>
    <message>
        <source>a straight line</source>
        <translation>une droite</translation>
    </message>
</context>
<context>
    <name>analysis.align_by_distance</name>
    <message>
        <source>align by distance</source>
        <translation>alignez sur la distance</translation>
    </message>
</context>
<context>
    <name>analysis.align_otherwise</name>
    <message>
        <source>align by motion onset or distance</source>
        <translation>alignez sur le début du mouvement ou la distance</translation>
    </message>
</context>
<context>
    <name>analysis.check_numbers</name>
    <message>
        <source>check the numbers</source>
        <translation>vérifiez les nombres</translation>
    </message>
</context>
<context>
    <name>analysis.choose_another_run</name>
    <message>
        <source>choose another run as well</source>
        <translation>choisissez aussi un autre passage</translation>
    </message>
</context>
<context>
    <name>analysis.choose_common_place</name>
    <message>
        <source>choose a position that both runs pass</source>
        <translation>choisissez un endroit par où passent les deux passages</translation>
    </message>
</context>
<context>
    <name>analysis.choose_figure</name>
    <message>
        <source>choose a metric to score</source>
        <translation>choisissez ce qui est noté</translation>
    </message>
</context>
<context>
    <name>analysis.choose_log_of_run</name>
    <message>
        <source>choose the log of this run</source>
        <translation>choisissez le journal de ce passage</translation>
    </message>
</context>
<context>
    <name>analysis.choose_longer_range</name>
    <message>
        <source>choose a longer range</source>
        <translation>choisissez une plage plus longue</translation>
    </message>
</context>
<context>
    <name>analysis.choose_motion</name>
    <message>
        <source>choose a run with motion</source>
        <translation>choisissez un passage avec du mouvement</translation>
    </message>
</context>
<context>
    <name>analysis.choose_same_direction</name>
    <message>
        <source>choose runs in the same direction</source>
        <translation>choisissez des passages dans le même sens</translation>
    </message>
</context>
<context>
    <name>analysis.choose_same_task</name>
    <message>
        <source>choose runs of the same task</source>
        <translation>choisissez des passages de la même épreuve</translation>
    </message>
</context>
<context>
    <name>analysis.comparison</name>
    <message>
        <source>comparison</source>
        <translation>comparaison</translation>
    </message>
</context>
<context>
    <name>analysis.comparison_of</name>
    <message>
        <source>comparison of %1</source>
        <translation>comparaison de %1</translation>
    </message>
</context>
<context>
    <name>analysis.corners_in_order</name>
    <message>
        <source>enter the corners in order, all the way round</source>
        <translation>donnez les coins dans l’ordre, tout autour</translation>
    </message>
</context>
<context>
    <name>analysis.corners_off_floor</name>
    <message>
        <source>its corners are not all on a floor of 1 km</source>
        <translation>ses coins ne sont pas sur un sol de 1 km</translation>
    </message>
</context>
<context>
    <name>analysis.corners_once</name>
    <message>
        <source>enter each corner once</source>
        <translation>donnez chaque coin une fois</translation>
    </message>
</context>
<context>
    <name>analysis.corners_too_near</name>
    <message>
        <source>two corners are less than 1 mm apart</source>
        <translation>deux coins sont à moins de 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.draw_coarsely</name>
    <message>
        <source>draw it with fewer corners</source>
        <translation>dessinez-la plus grossièrement</translation>
    </message>
</context>
<context>
    <name>analysis.ends_off_floor</name>
    <message>
        <source>its ends are not both on a floor of 1 km</source>
        <translation>ses extrémités ne sont pas sur un sol de 1 km</translation>
    </message>
</context>
<context>
    <name>analysis.ends_too_near</name>
    <message>
        <source>its ends are less than 1 mm apart</source>
        <translation>ses extrémités sont à moins de 1 mm l’une de l’autre</translation>
    </message>
</context>
<context>
    <name>analysis.few_corners</name>
    <message>
        <source>it has fewer than three corners</source>
        <translation>elle a moins de trois coins</translation>
    </message>
</context>
<context>
    <name>analysis.few_points</name>
    <message>
        <source>it has too few points</source>
        <translation>trop peu de points</translation>
    </message>
</context>
<context>
    <name>analysis.finish_is_there</name>
    <message>
        <source>gate &apos;%1&apos; is already the finish</source>
        <translation>la porte &apos;%1&apos; est déjà l’arrivée</translation>
    </message>
</context>
<context>
    <name>analysis.fit_of</name>
    <message>
        <source>fit of %1</source>
        <translation>ajustement (%1)</translation>
    </message>
</context>
<context>
    <name>analysis.formula_best_lap</name>
    <message>
        <source>The shortest lap.</source>
        <translation>Le tour le plus court.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_circle_radius</name>
    <message>
        <source>The least-squares circle through the positions of the motion.</source>
        <translation>Le cercle dont les carrés des distances aux points du mouvement ont la plus petite somme.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_bias</name>
    <message>
        <source>The mean of the distance from the reference path, to the left positive.</source>
        <translation>La moyenne de la distance au tracé de référence, comptée positive à gauche.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_max</name>
    <message>
        <source>The largest distance from the reference path.</source>
        <translation>La plus grande distance au tracé de référence.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_mean</name>
    <message>
        <source>The distance from the reference path, averaged along the path.</source>
        <translation>La distance moyenne au tracé de référence, sur tout le trajet.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_cross_track_rms</name>
    <message>
        <source>√(mean of the squared distance from the reference path), averaged along the path</source>
        <translation>√(moyenne du carré de la distance au tracé de référence), sur tout le trajet</translation>
    </message>
</context>
<context>
    <name>analysis.formula_duration</name>
    <message>
        <source>From the onset of motion to the last stop. Moving means faster than three σ of the speed, for at least three frames, and further than noise explains; the moment between two frames is interpolated.</source>
        <translation>Du début du mouvement au dernier arrêt. Être en mouvement, c’est aller plus vite que trois σ de la vitesse, pendant au moins trois images, et plus loin que le bruit ne l’explique&#xa0;; l’instant entre deux images est interpolé.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_gate_time</name>
    <message>
        <source>From passing the start gate to passing the finish, each interpolated between frames.</source>
        <translation>Du franchissement de la porte de départ à celui de l’arrivée, chacun interpolé entre les images.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_laps</name>
    <message>
        <source>Complete laps or runs, counted by the passages of the gates.</source>
        <translation>Tours ou passages complets, comptés par les franchissements des portes.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_accel</name>
    <message>
        <source>The acceleration |a| of the smoothed curve where |a| − 2σ is largest.</source>
        <translation>L’accélération |a| de la courbe lissée là où |a| − 2σ est maximal.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_speed</name>
    <message>
        <source>The speed |v| of the smoothed curve where |v| − 2σ is largest. A point does not win only because its uncertainty is large.</source>
        <translation>La vitesse |v| de la courbe lissée là où |v| − 2σ est maximal, pour qu’un point mal connu ne l’emporte pas par son erreur.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_max_turn_rate</name>
    <message>
        <source>How fast the robot turns, to the left or right, where the amount minus 2σ is largest. Of the body where its heading was measured, also on the spot: the rate of the smoothed heading. Elsewhere of the direction of motion: (vx·ay − vy·ax)/|v|² of the smoothed curve.</source>
        <translation>La vitesse à laquelle le robot tourne, dans un sens ou dans l’autre, là où sa valeur moins 2σ est maximale. Celle du corps là où son cap a été mesuré, aussi sur place : la variation du cap lissé. Ailleurs, celle de la direction du mouvement : (vx·ay − vy·ax)/|v|² de la courbe lissée.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_mean_lap</name>
    <message>
        <source>The mean of the laps&apos; times.</source>
        <translation>La moyenne des temps au tour.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_mean_speed</name>
    <message>
        <source>path length / time, both without gaps</source>
        <translation>distance parcourue / temps, tous deux sans les trous</translation>
    </message>
</context>
<context>
    <name>analysis.formula_median_speed</name>
    <message>
        <source>The speed that half of the time in motion stays below.</source>
        <translation>La vitesse qui n’est pas dépassée pendant la moitié du temps en mouvement.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_moving_time</name>
    <message>
        <source>The time in which it moves: faster than three σ of the speed, and further than noise explains.</source>
        <translation>Le temps pendant lequel il est en mouvement&#xa0;: plus vite que trois σ de la vitesse et plus loin que le bruit ne l’explique.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_p95_accel</name>
    <message>
        <source>The acceleration that 95 % of the time in motion stays below.</source>
        <translation>L’accélération qui n’est pas dépassée pendant 95&#xa0;% du temps en mouvement.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_p95_speed</name>
    <message>
        <source>The speed that 95 % of the time in motion stays below.</source>
        <translation>La vitesse qui n’est pas dépassée pendant 95&#xa0;% du temps en mouvement.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_path_completed</name>
    <message>
        <source>The share of the reference path that the robot followed.</source>
        <translation>La part du tracé de référence qui a été suivie.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_path_length</name>
    <message>
        <source>∫|v|dt while it moves, by the trapezoidal rule over the smoothed speed. A gap that is not bridged adds nothing.</source>
        <translation>∫|v|dt pendant le mouvement, par la méthode des trapèzes sur la vitesse lissée. Un trou non comblé n&apos;ajoute rien.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_rms_accel</name>
    <message>
        <source>√(mean of |a|²) while it moves</source>
        <translation>√(moyenne de |a|²) pendant le mouvement</translation>
    </message>
</context>
<context>
    <name>analysis.formula_rms_speed</name>
    <message>
        <source>√(mean of |v|²) while it moves</source>
        <translation>√(moyenne de |v|²) pendant le mouvement</translation>
    </message>
</context>
<context>
    <name>analysis.formula_standing_time</name>
    <message>
        <source>time − time in motion</source>
        <translation>temps − temps en mouvement</translation>
    </message>
</context>
<context>
    <name>analysis.formula_stops</name>
    <message>
        <source>The pauses between the onset of motion and the last stop, counted where the robot was measured at rest.</source>
        <translation>Le nombre de pauses entre le début du mouvement et le dernier arrêt où le robot a été mesuré à l’arrêt.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_straightness</name>
    <message>
        <source>distance from the first to the last position of the motion / path length</source>
        <translation>distance du premier au dernier point du mouvement / distance parcourue</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_breaches</name>
    <message>
        <source>How often the robot&apos;s reference point left a zone to stay in or entered a zone to keep out of. It counts if the point is beyond the edge by more than six σ of the track&apos;s noise.</source>
        <translation>Combien de fois le centre du robot a quitté une zone où rester, ou est entré dans une zone à éviter. Cela compte s’il dépasse le bord de plus de six σ du bruit propre à la trajectoire.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_depth</name>
    <message>
        <source>The largest distance of the robot&apos;s reference point beyond the edge of a zone.</source>
        <translation>De combien, au plus, le centre du robot a dépassé le bord d’une zone.</translation>
    </message>
</context>
<context>
    <name>analysis.formula_zone_time</name>
    <message>
        <source>The time for which the robot&apos;s reference point was beyond the edge of a zone, interpolated between frames; in two zones at once it counts twice.</source>
        <translation>Le temps pendant lequel le centre du robot était au-delà du bord d’une zone, interpolé entre les images&#xa0;; dans deux zones à la fois, il compte double.</translation>
    </message>
</context>
<context>
    <name>analysis.gate</name>
    <message>
        <source>gate &apos;%1&apos;</source>
        <translation>porte &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.give_another_number</name>
    <message>
        <source>choose another number</source>
        <translation>donnez un autre nombre</translation>
    </message>
</context>
<context>
    <name>analysis.give_corners</name>
    <message>
        <source>enter the corners of its outline, all the way round</source>
        <translation>donnez les coins de son contour, tout autour</translation>
    </message>
</context>
<context>
    <name>analysis.give_ends</name>
    <message>
        <source>enter the two ends of the line that the robot passes</source>
        <translation>donnez les deux extrémités de la ligne à franchir</translation>
    </message>
</context>
<context>
    <name>analysis.give_limits</name>
    <message>
        <source>enter the largest speed and acceleration that a robot can reach in the task</source>
        <translation>donnez la vitesse et l’accélération maximales d’un robot dans l’épreuve</translation>
    </message>
</context>
<context>
    <name>analysis.give_log_offset</name>
    <message>
        <source>give the time offset of the log</source>
        <translation>indiquez le décalage temporel du journal</translation>
    </message>
</context>
<context>
    <name>analysis.give_place</name>
    <message>
        <source>enter its position in millimetres</source>
        <translation>donnez sa place en millimètres</translation>
    </message>
</context>
<context>
    <name>analysis.give_points</name>
    <message>
        <source>enter points from 1 to 1000; use a negative number for a penalty</source>
        <translation>donnez des points de 1 à 1000, négatifs pour une pénalité</translation>
    </message>
</context>
<context>
    <name>analysis.give_sizes</name>
    <message>
        <source>enter the sizes in millimetres</source>
        <translation>donnez les tailles en millimètres</translation>
    </message>
</context>
<context>
    <name>analysis.give_three_numbers</name>
    <message>
        <source>enter three numbers</source>
        <translation>donnez trois nombres</translation>
    </message>
</context>
<context>
    <name>analysis.give_two_points</name>
    <message>
        <source>enter at least two points, or three for a closed path</source>
        <translation>donnez deux points ou plus, trois si le tracé est fermé</translation>
    </message>
</context>
<context>
    <name>analysis.give_two_values</name>
    <message>
        <source>enter two different values; the points rise between them</source>
        <translation>donnez deux valeurs, entre lesquelles les points montent</translation>
    </message>
</context>
<context>
    <name>analysis.join_zones</name>
    <message>
        <source>merge neighbouring zones</source>
        <translation>réunissez des zones voisines</translation>
    </message>
</context>
<context>
    <name>analysis.keep_what_matters</name>
    <message>
        <source>keep those that matter</source>
        <translation>gardez celles qui comptent</translation>
    </message>
</context>
<context>
    <name>analysis.limit_not_positive</name>
    <message>
        <source>a limit is zero or negative</source>
        <translation>une limite n’est pas supérieure à zéro</translation>
    </message>
</context>
<context>
    <name>analysis.limits</name>
    <message>
        <source>limits of a task</source>
        <translation>limites d’une épreuve</translation>
    </message>
</context>
<context>
    <name>analysis.line_of_scoring</name>
    <message>
        <source>line %1 of the scoring</source>
        <translation>ligne %1 du barème</translation>
    </message>
</context>
<context>
    <name>analysis.little_motion</name>
    <message>
        <source>the robot hardly moves in %1</source>
        <translation>le robot bouge à peine dans %1</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_no_common_time</name>
    <message>
        <source>fewer than %1 of its positions have times at which the robot was measured</source>
        <translation>moins de %1 de ses positions correspondent à des instants où le robot a été mesuré</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_other_front</name>
    <message>
        <source>the log&apos;s heading is %1 from the measured one throughout: its front or its axes may differ</source>
        <translation>le cap du journal diffère constamment de %1 du cap mesuré&#xa0;: son avant ou ses axes sont peut-être différents</translation>
    </message>
</context>
<context>
    <name>analysis.log_has_other_lengths</name>
    <message>
        <source>the log&apos;s lengths are %1 times the measured ones: its unit may be wrong</source>
        <translation>les longueurs du journal sont %1 fois celles mesurées&#xa0;: son unité est peut-être fausse</translation>
    </message>
</context>
<context>
    <name>analysis.log_is_mirrored</name>
    <message>
        <source>it is the mirror image of the run</source>
        <translation>c’est l’image miroir du passage</translation>
    </message>
</context>
<context>
    <name>analysis.log_moves_otherwise</name>
    <message>
        <source>it moves differently: at no time offset do more than %1 of the changes of speed and direction agree</source>
        <translation>il se déplace autrement&#xa0;: quel que soit le décalage temporel, pas plus de %1 des changements de vitesse et de direction ne concordent</translation>
    </message>
</context>
<context>
    <name>analysis.many_corners</name>
    <message>
        <source>it has more than %1 corners</source>
        <translation>elle a plus de %1 coins</translation>
    </message>
</context>
<context>
    <name>analysis.many_lines</name>
    <message>
        <source>it has more than %1 lines</source>
        <translation>il a plus de %1 lignes</translation>
    </message>
</context>
<context>
    <name>analysis.many_points</name>
    <message>
        <source>it has more than %1 points</source>
        <translation>plus de %1 points</translation>
    </message>
</context>
<context>
    <name>analysis.many_zones</name>
    <message>
        <source>the task already has %1 zones</source>
        <translation>l’épreuve a déjà %1 zones</translation>
    </message>
</context>
<context>
    <name>analysis.metric_best_lap</name>
    <message>
        <source>Best lap</source>
        <translation>Meilleur tour</translation>
    </message>
</context>
<context>
    <name>analysis.metric_circle_radius</name>
    <message>
        <source>Circle&apos;s radius</source>
        <translation>Rayon du cercle</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_bias</name>
    <message>
        <source>Left of the path</source>
        <translation>À gauche du tracé</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_max</name>
    <message>
        <source>Off the path (most)</source>
        <translation>Écart au tracé (max.)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_mean</name>
    <message>
        <source>Off the path (mean)</source>
        <translation>Écart au tracé (moyen)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_cross_track_rms</name>
    <message>
        <source>Off the path (RMS)</source>
        <translation>Écart au tracé (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_displacement</name>
    <message>
        <source>Displacement</source>
        <translation>Déplacement</translation>
    </message>
</context>
<context>
    <name>analysis.metric_duration</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
</context>
<context>
    <name>analysis.metric_gate_time</name>
    <message>
        <source>Start to finish</source>
        <translation>Du départ à l’arrivée</translation>
    </message>
</context>
<context>
    <name>analysis.metric_gates_passed</name>
    <message>
        <source>Gates passed</source>
        <translation>Portes franchies</translation>
    </message>
</context>
<context>
    <name>analysis.metric_height</name>
    <message>
        <source>Robot&apos;s height</source>
        <translation>Hauteur du robot</translation>
    </message>
</context>
<context>
    <name>analysis.metric_laps</name>
    <message>
        <source>Laps</source>
        <translation>Tours</translation>
    </message>
</context>
<context>
    <name>analysis.metric_limit_breaches</name>
    <message>
        <source>Limits broken</source>
        <translation>Limites enfreintes</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_accel</name>
    <message>
        <source>Top acceleration</source>
        <translation>Accélération max.</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_speed</name>
    <message>
        <source>Top speed</source>
        <translation>Vitesse max.</translation>
    </message>
</context>
<context>
    <name>analysis.metric_max_turn_rate</name>
    <message>
        <source>Fastest turn</source>
        <translation>Rotation max.</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_lap</name>
    <message>
        <source>Mean lap</source>
        <translation>Tour moyen</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_speed</name>
    <message>
        <source>Mean speed</source>
        <translation>Vitesse moyenne</translation>
    </message>
</context>
<context>
    <name>analysis.metric_mean_view_disagreement</name>
    <message>
        <source>Views disagree by</source>
        <translation>Désaccord des vues</translation>
    </message>
</context>
<context>
    <name>analysis.metric_median_speed</name>
    <message>
        <source>Median speed</source>
        <translation>Vitesse médiane</translation>
    </message>
</context>
<context>
    <name>analysis.metric_moving_time</name>
    <message>
        <source>Time in motion</source>
        <translation>Temps en mouvement</translation>
    </message>
</context>
<context>
    <name>analysis.metric_p95_accel</name>
    <message>
        <source>P95 acceleration</source>
        <translation>Accélération (P95)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_p95_speed</name>
    <message>
        <source>P95 speed</source>
        <translation>Vitesse (P95)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_path_completed</name>
    <message>
        <source>Path completed</source>
        <translation>Tracé accompli</translation>
    </message>
</context>
<context>
    <name>analysis.metric_path_length</name>
    <message>
        <source>Path</source>
        <translation>Distance</translation>
    </message>
</context>
<context>
    <name>analysis.metric_rms_accel</name>
    <message>
        <source>Acceleration (RMS)</source>
        <translation>Accélération (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_rms_speed</name>
    <message>
        <source>Speed (RMS)</source>
        <translation>Vitesse (RMS)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_score</name>
    <message>
        <source>Score</source>
        <translation>Score</translation>
    </message>
</context>
<context>
    <name>analysis.metric_spikes</name>
    <message>
        <source>Spikes</source>
        <translation>Pics aberrants</translation>
    </message>
</context>
<context>
    <name>analysis.metric_standing_time</name>
    <message>
        <source>Standing time</source>
        <translation>Temps à l’arrêt</translation>
    </message>
</context>
<context>
    <name>analysis.metric_stops</name>
    <message>
        <source>Stops</source>
        <translation>Arrêts</translation>
    </message>
</context>
<context>
    <name>analysis.metric_straightness</name>
    <message>
        <source>Straightness</source>
        <translation>Rectitude</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_breaches</name>
    <message>
        <source>Zones broken</source>
        <translation>Zones enfreintes</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_depth</name>
    <message>
        <source>Beyond zones (most)</source>
        <translation>Hors zones (max.)</translation>
    </message>
</context>
<context>
    <name>analysis.metric_zone_time</name>
    <message>
        <source>Time beyond zones</source>
        <translation>Temps hors zones</translation>
    </message>
</context>
<context>
    <name>analysis.moment_outside</name>
    <message>
        <source>the moment entered for %1 is outside that run</source>
        <translation>l’instant donné pour %1 est en dehors</translation>
    </message>
</context>
<context>
    <name>analysis.moments_missing</name>
    <message>
        <source>aligning runs by hand needs a moment in each run</source>
        <translation>pour les aligner à la main, il faut un instant de chaque passage</translation>
    </message>
</context>
<context>
    <name>analysis.motion_gives_no_offset</name>
    <message>
        <source>the robot never changes its speed or its curvature by more than noise, so any time offset fits</source>
        <translation>le robot ne change jamais sa vitesse ni sa courbure de plus que le bruit, donc n’importe quel décalage temporel convient</translation>
    </message>
</context>
<context>
    <name>analysis.name_each_gate</name>
    <message>
        <source>give each gate a name of its own</source>
        <translation>donnez à chaque porte son propre nom</translation>
    </message>
</context>
<context>
    <name>analysis.name_each_zone</name>
    <message>
        <source>give each zone a name of its own</source>
        <translation>donnez à chaque zone son propre nom</translation>
    </message>
</context>
<context>
    <name>analysis.name_twice</name>
    <message>
        <source>the name is used twice</source>
        <translation>le nom y est deux fois</translation>
    </message>
</context>
<context>
    <name>analysis.no_figure</name>
    <message>
        <source>it names no metric</source>
        <translation>elle ne nomme aucune grandeur</translation>
    </message>
</context>
<context>
    <name>analysis.no_motion</name>
    <message>
        <source>the robot does not move in %1</source>
        <translation>le robot ne bouge pas dans %1</translation>
    </message>
</context>
<context>
    <name>analysis.no_onset</name>
    <message>
        <source>the robot of %1 is already moving when it is first seen</source>
        <translation>le robot de %1 roule déjà quand il est vu pour la première fois</translation>
    </message>
</context>
<context>
    <name>analysis.no_start_gate</name>
    <message>
        <source>%1 does not pass a start gate</source>
        <translation>%1 ne franchit pas de porte de départ</translation>
    </message>
</context>
<context>
    <name>analysis.no_step_of_delta</name>
    <message>
        <source>no stretch of %1 was measured without a gap, so there is no relative error</source>
        <translation>aucun tronçon de %1 n’a été mesuré sans trou, il n’y a donc pas d’erreur relative</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_role</name>
    <message>
        <source>gates have no such role</source>
        <translation>ce rôle n’existe pas</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_rule</name>
    <message>
        <source>zones have no such rule</source>
        <translation>cette règle de zone n’existe pas</translation>
    </message>
</context>
<context>
    <name>analysis.no_such_template</name>
    <message>
        <source>no template has this name</source>
        <translation>ce modèle n’existe pas</translation>
    </message>
</context>
<context>
    <name>analysis.not_on_tasks_path</name>
    <message>
        <source>%1 shares no part of its path with the task&apos;s path</source>
        <translation>%1 n’a aucune portion de trajet commune avec le tracé de l’épreuve</translation>
    </message>
</context>
<context>
    <name>analysis.not_seen_there</name>
    <message>
        <source>%1 was not seen at the position used for alignment</source>
        <translation>%1 n’a pas été vu à l’endroit de l’alignement</translation>
    </message>
</context>
<context>
    <name>analysis.nothing_in_common</name>
    <message>
        <source>%1 shares no part of its path with %2</source>
        <translation>%1 n’a aucune portion de trajet commune avec %2</translation>
    </message>
</context>
<context>
    <name>analysis.number_is_none</name>
    <message>
        <source>one of its values is not a number</source>
        <translation>un de ses nombres n’en est pas un</translation>
    </message>
</context>
<context>
    <name>analysis.offset_is_ambiguous</name>
    <message>
        <source>its motion repeats itself: time offsets %1 apart agree equally well</source>
        <translation>son mouvement se répète&#xa0;: des décalages temporels distants de %1 concordent aussi bien</translation>
    </message>
</context>
<context>
    <name>analysis.offset_is_uncertain</name>
    <message>
        <source>its time offset is known only to ±%1</source>
        <translation>son décalage temporel n’est connu qu’à ±%1 près</translation>
    </message>
</context>
<context>
    <name>analysis.offset_not_found</name>
    <message>
        <source>too little of its motion is also in the run to find the time offset</source>
        <translation>trop peu de son mouvement se retrouve dans le passage pour déterminer le décalage temporel</translation>
    </message>
</context>
<context>
    <name>analysis.one_point_too_few</name>
    <message>
        <source>%1 point is too few for it</source>
        <translation>%1 point est trop peu pour cela</translation>
    </message>
</context>
<context>
    <name>analysis.one_start_and_finish</name>
    <message>
        <source>keep one start and one finish, or one gate with the role start_finish</source>
        <translation>gardez un départ et une arrivée, ou une porte qui soit les deux</translation>
    </message>
</context>
<context>
    <name>analysis.other_direction</name>
    <message>
        <source>%1 runs in the opposite direction to %2</source>
        <translation>%1 fait le trajet dans l’autre sens que %2</translation>
    </message>
</context>
<context>
    <name>analysis.outline_crosses</name>
    <message>
        <source>its outline crosses itself</source>
        <translation>son contour se croise</translation>
    </message>
</context>
<context>
    <name>analysis.path_too_short</name>
    <message>
        <source>it is shorter than 1 mm</source>
        <translation>moins de 1 mm de long</translation>
    </message>
</context>
<context>
    <name>analysis.place_no_number</name>
    <message>
        <source>its position is not a number</source>
        <translation>sa place n’est pas un nombre</translation>
    </message>
</context>
<context>
    <name>analysis.points_off_floor</name>
    <message>
        <source>its points are not all on a floor of 1 km</source>
        <translation>ses points ne sont pas sur un sol de 1 km</translation>
    </message>
</context>
<context>
    <name>analysis.points_out_of_range</name>
    <message>
        <source>its points are 0 or beyond ±1000</source>
        <translation>ses points sont 0, ou au-delà de 1000</translation>
    </message>
</context>
<context>
    <name>analysis.points_too_few</name>
    <message>
        <source>%1 points are too few for it</source>
        <translation>%1 points ne suffisent pas</translation>
    </message>
</context>
<context>
    <name>analysis.reference_path</name>
    <message>
        <source>reference path</source>
        <translation>tracé de référence</translation>
    </message>
</context>
<context>
    <name>analysis.role</name>
    <message>
        <source>role &apos;%1&apos;</source>
        <translation>rôle &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.rule</name>
    <message>
        <source>rule &apos;%1&apos;</source>
        <translation>règle &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.same_values</name>
    <message>
        <source>full points and no points have the same value</source>
        <translation>tous les points et aucun point sont à la même valeur</translation>
    </message>
</context>
<context>
    <name>analysis.sample_coarsely</name>
    <message>
        <source>sample it with fewer points</source>
        <translation>échantillonnez-le plus grossièrement</translation>
    </message>
</context>
<context>
    <name>analysis.scoring</name>
    <message>
        <source>scoring</source>
        <translation>barème</translation>
    </message>
</context>
<context>
    <name>analysis.size_too_small</name>
    <message>
        <source>a size is less than 1 mm</source>
        <translation>une taille est inférieure à 1 mm</translation>
    </message>
</context>
<context>
    <name>analysis.start_is_there</name>
    <message>
        <source>gate &apos;%1&apos; is already the start</source>
        <translation>la porte &apos;%1&apos; est déjà le départ</translation>
    </message>
</context>
<context>
    <name>analysis.still_in_common_time</name>
    <message>
        <source>the robot does not move in the common time</source>
        <translation>le robot ne bouge pas pendant le temps commun</translation>
    </message>
</context>
<context>
    <name>analysis.takes_two_runs</name>
    <message>
        <source>it needs two runs</source>
        <translation>il faut deux passages</translation>
    </message>
</context>
<context>
    <name>analysis.tell_moment_inside</name>
    <message>
        <source>enter one between its first and last frame</source>
        <translation>donnez-en un entre sa première et sa dernière image</translation>
    </message>
</context>
<context>
    <name>analysis.tell_moments</name>
    <message>
        <source>enter one for each run</source>
        <translation>donnez-en un pour chacun</translation>
    </message>
</context>
<context>
    <name>analysis.template</name>
    <message>
        <source>template &apos;%1&apos;</source>
        <translation>modèle &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>analysis.template_of_task</name>
    <message>
        <source>template of a task</source>
        <translation>modèle d’une épreuve</translation>
    </message>
</context>
<context>
    <name>analysis.turn_sign</name>
    <message>
        <source>change the sign of one of its coordinates</source>
        <translation>changez le signe d’une de ses coordonnées</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_best_lap</name>
    <message>
        <source>of its two passages; the calibration uncertainty of a gate passed twice cancels</source>
        <translation>de ses deux franchissements&#xa0;; l’erreur d’étalonnage d’une porte franchie deux fois se compense</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_circle_radius</name>
    <message>
        <source>of the scatter of the distances, with their number divided by 1 + 2Σρ for correlated neighbours, and the calibration&apos;s scale uncertainty</source>
        <translation>de la dispersion des distances, le nombre de points voisins étant réduit du facteur 1 + 2Σρ, et l’erreur d’échelle de l’étalonnage</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_correlated</name>
    <message>
        <source>the bound for fully correlated errors, and the calibration&apos;s scale uncertainty</source>
        <translation>la borne pour des erreurs toutes de même sens, et l’erreur d’échelle de l’étalonnage</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_bias</name>
    <message>
        <source>of the position across the path, mostly the calibration&apos;s</source>
        <translation>de la position en travers du tracé, surtout la part de l’étalonnage</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_max</name>
    <message>
        <source>of the position across the path, there</source>
        <translation>de la position en travers du tracé, à cet endroit</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_mean</name>
    <message>
        <source>of the position across the path, and of its noise: the distance has no sign, so noise does not cancel</source>
        <translation>de la position en travers du tracé, et de son bruit, qui n’y a pas de signe</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_cross_track_rms</name>
    <message>
        <source>of the position across the path</source>
        <translation>de la position en travers du tracé</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_duration</name>
    <message>
        <source>of both moments: σ of the speed divided by its slope there, and how far smoothing blurs them</source>
        <translation>des deux instants&#xa0;: σ de la vitesse, divisé par sa pente à cet instant, et l’étalement dû au lissage</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_gate_time</name>
    <message>
        <source>of both passages: σ of the position across the gate divided by the speed</source>
        <translation>des deux franchissements&#xa0;: σ de la position en travers de la porte, divisé par la vitesse</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_max_turn_rate</name>
    <message>
        <source>of the body: that of the smoothed heading&apos;s rate; of the direction of motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order</source>
        <translation>du corps : celle de la variation du cap lissé ; de la direction du mouvement : σ² = σa²/|v|² + |a|²σv²/|v|⁴, au premier ordre</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_mean_lap</name>
    <message>
        <source>of the first and the last passage, over the number of laps</source>
        <translation>du premier et du dernier franchissement, divisé par le nombre de tours</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_mean_speed</name>
    <message>
        <source>of both, treated as independent, and of gaps: from straight through them to the top speed in them</source>
        <translation>des deux, pris comme indépendants, et des trous&#xa0;: depuis une traversée en ligne droite jusqu’à la vitesse maximale</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_moving_time</name>
    <message>
        <source>of each start and stop: σ of the speed divided by its slope</source>
        <translation>de chaque démarrage et arrêt&#xa0;: σ de la vitesse, divisé par sa pente</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_of_curve</name>
    <message>
        <source>that of the smoothed curve there, and the calibration&apos;s scale uncertainty</source>
        <translation>celui de la courbe lissée à cet endroit, et l’erreur d’échelle de l’étalonnage</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_of_intervals</name>
    <message>
        <source>of the intervals within 1.5 σ of it, each by its mean</source>
        <translation>des intervalles à moins de 1,5 σ de cette valeur, chacun par sa moyenne</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_path_length</name>
    <message>
        <source>of the end positions, of lateral errors where the path turns, of what the robot could have done where it was bridged, and the calibration&apos;s scale uncertainty</source>
        <translation>des positions des extrémités, des erreurs en travers de la trajectoire là où elle tourne, de ce que le robot a pu faire dans les intervalles interpolés, et l’erreur d’échelle de l’étalonnage</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_standing_time</name>
    <message>
        <source>of each start and stop</source>
        <translation>de chaque démarrage et arrêt</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_straightness</name>
    <message>
        <source>of the end positions</source>
        <translation>des positions des extrémités</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_zone_depth</name>
    <message>
        <source>of the position across the edge, there</source>
        <translation>de la position en travers du bord, à cet endroit</translation>
    </message>
</context>
<context>
    <name>analysis.uncertainty_zone_time</name>
    <message>
        <source>of each crossing of an edge: σ of the position across it divided by the speed; and the change of the time when the calibration uncertainty shifts the track</source>
        <translation>de chaque instant à un bord&#xa0;: σ de la position en travers de celui-ci, divisé par la vitesse&#xa0;; et ce dont le temps change quand l’étalonnage rapproche ou éloigne la trajectoire</translation>
    </message>
</context>
<context>
    <name>analysis.use_a_rule</name>
    <message>
        <source>use stay_inside or stay_outside</source>
        <translation>utilisez stay_inside ou stay_outside</translation>
    </message>
</context>
<context>
    <name>analysis.use_one_of</name>
    <message>
        <source>use %1</source>
        <translation>utilisez %1</translation>
    </message>
</context>
<context>
    <name>analysis.wrong_poles</name>
    <message>
        <source>a slalom has 1 to 100 poles, not %1</source>
        <translation>un slalom a 1 à 100 piquets, pas %1</translation>
    </message>
</context>
<context>
    <name>analysis.zone</name>
    <message>
        <source>zone &apos;%1&apos;</source>
        <translation>zone &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>backup.disk_nearly_full</name>
    <message>
        <source>the disk has only %1 left</source>
        <translation>il ne reste que %1 sur le disque</translation>
    </message>
</context>
<context>
    <name>backup.of_project</name>
    <message>
        <source>backup of &apos;%1&apos;</source>
        <translation>copie de sauvegarde de « %1 »</translation>
    </message>
</context>
<context>
    <name>base.and</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
</context>
<context>
    <name>base.camera</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>caméra &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.cancelled</name>
    <message>
        <source>cancelled</source>
        <translation>annulé</translation>
    </message>
</context>
<context>
    <name>base.cannot_do_this</name>
    <message>
        <source>cannot do this</source>
        <translation>impossible de faire cela maintenant</translation>
    </message>
</context>
<context>
    <name>base.class</name>
    <message>
        <source>class &apos;%1&apos;</source>
        <translation>classe &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.close_other_programs</name>
    <message>
        <source>close other programs and try again</source>
        <translation>fermez d’autres programmes et réessayez</translation>
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
        <translation>couleur &apos;%1&apos;</translation>
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
        <translation>fichier &apos;%1&apos;</translation>
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
        <translation>c’est un périphérique</translation>
    </message>
</context>
<context>
    <name>base.is_folder</name>
    <message>
        <source>it is a folder</source>
        <translation>c’est un dossier</translation>
    </message>
</context>
<context>
    <name>base.is_pipe</name>
    <message>
        <source>it is a named pipe</source>
        <translation>c’est un tube nommé</translation>
    </message>
</context>
<context>
    <name>base.is_socket</name>
    <message>
        <source>it is a socket</source>
        <translation>c’est un socket</translation>
    </message>
</context>
<context>
    <name>base.layout</name>
    <message>
        <source>layout &apos;%1&apos;</source>
        <translation>plan &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.length</name>
    <message>
        <source>length &apos;%1&apos;</source>
        <translation>longueur &apos;%1&apos;</translation>
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
        <translation>pas de la forme #rrggbb</translation>
    </message>
</context>
<context>
    <name>base.no_files</name>
    <message>
        <source>too many files are open</source>
        <translation>trop de fichiers sont ouverts</translation>
    </message>
</context>
<context>
    <name>base.no_length</name>
    <message>
        <source>not a number with the unit mm, cm or m</source>
        <translation>pas un nombre avec l’unité mm, cm ou m</translation>
    </message>
</context>
<context>
    <name>base.no_memory</name>
    <message>
        <source>this computer does not have enough free memory for it</source>
        <translation>cet ordinateur n&apos;a pas assez de mémoire libre pour cela</translation>
    </message>
</context>
<context>
    <name>base.no_number</name>
    <message>
        <source>not a finite decimal number</source>
        <translation>pas un nombre décimal fini</translation>
    </message>
</context>
<context>
    <name>base.no_thread</name>
    <message>
        <source>this computer cannot start another thread</source>
        <translation>cet ordinateur n&apos;accorde plus de fil d&apos;exécution</translation>
    </message>
</context>
<context>
    <name>base.none</name>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
</context>
<context>
    <name>base.nothing_changed</name>
    <message>
        <source>nothing was changed</source>
        <translation>rien n’a été changé</translation>
    </message>
</context>
<context>
    <name>base.number</name>
    <message>
        <source>number &apos;%1&apos;</source>
        <translation>nombre &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.or</name>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
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
        <translation>robot &apos;%1&apos; dans l’essai &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>base.saved_is_safe</name>
    <message>
        <source>what was saved is safe</source>
        <translation>ce qui était enregistré est à l&apos;abri</translation>
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
        <translation>épreuve &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.team</name>
    <message>
        <source>team &apos;%1&apos;</source>
        <translation>équipe &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.trial</name>
    <message>
        <source>trial &apos;%1&apos;</source>
        <translation>essai &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>base.try_again_and_report</name>
    <message>
        <source>try again, and report it if it happens again</source>
        <translation>réessayez et signalez-le si cela se reproduit</translation>
    </message>
</context>
<context>
    <name>base.unexpected</name>
    <message>
        <source>something unexpected happened (%1)</source>
        <translation>un événement inattendu s’est produit (%1)</translation>
    </message>
</context>
<context>
    <name>base.view_in_trial</name>
    <message>
        <source>view &apos;%1&apos; in trial &apos;%2&apos;</source>
        <translation>vue &apos;%1&apos; dans l’essai &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>base.wordless_exception</name>
    <message>
        <source>an unknown exception</source>
        <translation>une exception sans message</translation>
    </message>
</context>
<context>
    <name>base.write_colour</name>
    <message>
        <source>write it like #d72328</source>
        <translation>écrivez-la comme #d72328</translation>
    </message>
</context>
<context>
    <name>base.write_length</name>
    <message>
        <source>write it like 25mm, 2.5cm or 0.3m</source>
        <translation>écrivez-le comme 25mm, 2.5cm ou 0.3m</translation>
    </message>
</context>
<context>
    <name>base.write_number</name>
    <message>
        <source>write it with digits and a point, like 12.5</source>
        <translation>écrivez-le avec des chiffres et un point, comme 12.5</translation>
    </message>
</context>
<context>
    <name>calibration.add_floor_points</name>
    <message>
        <source>add floor points, such as corners of tiles</source>
        <translation>ajoutez des points du sol, tels que des coins de carreaux</translation>
    </message>
</context>
<context>
    <name>calibration.all_agree</name>
    <message>
        <source>The markers and the cameras agree with each other.</source>
        <translation>Les marqueurs et les caméras concordent.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_changed</name>
    <message>
        <source>The world axes were changed afterwards.</source>
        <translation>Les axes du monde ont été changés ensuite.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_changed_and_scaled</name>
    <message>
        <source>The world axes were changed afterwards, and all lengths multiplied by %1.</source>
        <translation>Les axes du monde ont été changés ensuite, et toutes les longueurs multipliées par %1.</translation>
    </message>
</context>
<context>
    <name>calibration.axes_no_number</name>
    <message>
        <source>the origin or the angle is not a finite number</source>
        <translation>l’origine ou l’angle n’est pas un nombre fini</translation>
    </message>
</context>
<context>
    <name>calibration.axes_not_changed</name>
    <message>
        <source>the axes of layout &apos;%1&apos; cannot be changed</source>
        <translation>les axes du plan &apos;%1&apos; ne peuvent pas être changés</translation>
    </message>
</context>
<context>
    <name>calibration.best_place</name>
    <message>
        <source>the best camera position</source>
        <translation>la meilleure place pour une caméra</translation>
    </message>
</context>
<context>
    <name>calibration.board_blurred</name>
    <message>
        <source>the board is blurred</source>
        <translation>la mire est floue</translation>
    </message>
</context>
<context>
    <name>calibration.board_cut_off</name>
    <message>
        <source>the board is cut off</source>
        <translation>la mire est coupée</translation>
    </message>
</context>
<context>
    <name>calibration.board_fills</name>
    <message>
        <source>it fills %1 of the image</source>
        <translation>elle remplit %1 de l’image</translation>
    </message>
</context>
<context>
    <name>calibration.board_in_one_place</name>
    <message>
        <source>all %1 images show the board in one position, the %2 %3 of the image</source>
        <translation>les %1 photos montrent la mire à une seule place (%2, %3 de l’image)</translation>
    </message>
</context>
<context>
    <name>calibration.board_not_flat</name>
    <message>
        <source>the corners do not match a flat board</source>
        <translation>les coins ne sont pas placés comme sur une mire plane</translation>
    </message>
</context>
<context>
    <name>calibration.board_not_sharp</name>
    <message>
        <source>the board is not sharp</source>
        <translation>la mire n’est pas nette</translation>
    </message>
</context>
<context>
    <name>calibration.board_of_other_size</name>
    <message>
        <source>this board has %1 inner corners, not %2</source>
        <translation>cette mire a %1 coins intérieurs, %2 était demandé</translation>
    </message>
</context>
<context>
    <name>calibration.board_part_seen</name>
    <message>
        <source>only %1 of its %2 inner corners are visible</source>
        <translation>seuls %1 de ses %2 coins intérieurs sont vus</translation>
    </message>
</context>
<context>
    <name>calibration.board_stands_as_before</name>
    <message>
        <source>the board is in the same position as in an earlier image</source>
        <translation>la mire est placée comme dans une photo déjà prise</translation>
    </message>
</context>
<context>
    <name>calibration.board_stands_as_in</name>
    <message>
        <source>the board is in the same position as in %1</source>
        <translation>la mire est placée comme déjà dans %1</translation>
    </message>
</context>
<context>
    <name>calibration.board_too_oblique</name>
    <message>
        <source>the board is tilted too far, by %1 degrees</source>
        <translation>la mire est vue trop en biais, à %1 degrés</translation>
    </message>
</context>
<context>
    <name>calibration.board_too_small</name>
    <message>
        <source>the board is too small</source>
        <translation>la mire est trop petite</translation>
    </message>
</context>
<context>
    <name>calibration.calibrate_to_rely</name>
    <message>
        <source>Calibrate it for reliable positions.</source>
        <translation>Étalonnez-la pour des positions fiables.</translation>
    </message>
</context>
<context>
    <name>calibration.camera_alone_says</name>
    <message>
        <source>Camera &apos;%1&apos; alone measures %2</source>
        <translation>La caméra &apos;%1&apos; seule donne %2</translation>
    </message>
</context>
<context>
    <name>calibration.camera_below_floor</name>
    <message>
        <source>in this order the camera would be below the floor</source>
        <translation>vue dans cet ordre, la caméra serait sous le sol</translation>
    </message>
</context>
<context>
    <name>calibration.camera_moved</name>
    <message>
        <source>%1 has moved %2 = %3</source>
        <translation>%1 a bougé de %2 = %3</translation>
    </message>
</context>
<context>
    <name>calibration.camera_sees_elsewhere</name>
    <message>
        <source>%1 sees %2 %3 from where the others see it</source>
        <translation>%1 voit %2 à %3 de là où les autres le voient</translation>
    </message>
</context>
<context>
    <name>calibration.camera_sees_too_few</name>
    <message>
        <source>camera &apos;%1&apos; sees only %2 of the markers</source>
        <translation>la caméra &apos;%1&apos; ne voit que %2 des marqueurs</translation>
    </message>
</context>
<context>
    <name>calibration.camera_stands_low</name>
    <message>
        <source>The camera would be only %1 above the floor</source>
        <translation>La caméra ne serait qu’à %1 du sol</translation>
    </message>
</context>
<context>
    <name>calibration.camera_still</name>
    <message>
        <source>%1 has not moved</source>
        <translation>%1 est là où elle a été localisée</translation>
    </message>
</context>
<context>
    <name>calibration.camera_too_high</name>
    <message>
        <source>the camera would be %1 above the floor</source>
        <translation>la caméra serait à %1 du sol</translation>
    </message>
</context>
<context>
    <name>calibration.camera_too_low</name>
    <message>
        <source>the camera would be only %1 above the floor</source>
        <translation>la caméra ne serait qu’à %1 du sol</translation>
    </message>
</context>
<context>
    <name>calibration.camera_twice</name>
    <message>
        <source>camera &apos;%1&apos; appears twice</source>
        <translation>la caméra &apos;%1&apos; y est deux fois</translation>
    </message>
</context>
<context>
    <name>calibration.camera_upside_down</name>
    <message>
        <source>The camera would be upside down</source>
        <translation>La caméra serait à l’envers</translation>
    </message>
</context>
<context>
    <name>calibration.cameras_of_one_image</name>
    <message>
        <source>%1 and %2 have the same pixels and count as one camera.</source>
        <translation>%1 et %2 ont les mêmes pixels et comptent comme une seule caméra.</translation>
    </message>
</context>
<context>
    <name>calibration.cameras_undetermined</name>
    <message>
        <source>the markers do not determine the camera positions</source>
        <translation>les marqueurs ne déterminent pas où sont les caméras</translation>
    </message>
</context>
<context>
    <name>calibration.cannot_be_calibrated</name>
    <message>
        <source>the camera cannot be calibrated</source>
        <translation>la caméra ne peut pas être étalonnée</translation>
    </message>
</context>
<context>
    <name>calibration.centimetres</name>
    <message>
        <source>centimetres</source>
        <translation>centimètres</translation>
    </message>
</context>
<context>
    <name>calibration.centre_is_off</name>
    <message>
        <source>The optical centre is %1 off the image&apos;s middle</source>
        <translation>Le centre optique est à %1 du milieu de l’image</translation>
    </message>
</context>
<context>
    <name>calibration.check_all</name>
    <message>
        <source>check the layout, the labels and the intrinsics</source>
        <translation>vérifiez le plan, les libellés et les paramètres intrinsèques</translation>
    </message>
</context>
<context>
    <name>calibration.check_both_lenses</name>
    <message>
        <source>check its pixels and the intrinsics of both cameras</source>
        <translation>vérifiez ses pixels et les paramètres intrinsèques des deux caméras</translation>
    </message>
</context>
<context>
    <name>calibration.check_both_pixels</name>
    <message>
        <source>check its pixels in both images</source>
        <translation>vérifiez ses pixels dans les deux images</translation>
    </message>
</context>
<context>
    <name>calibration.check_columns</name>
    <message>
        <source>check which columns belong to which camera</source>
        <translation>vérifiez quelles colonnes vont avec quelle caméra</translation>
    </message>
</context>
<context>
    <name>calibration.check_first_registration</name>
    <message>
        <source>check the registration of %1 and the pair</source>
        <translation>vérifiez la localisation de %1 et la paire</translation>
    </message>
</context>
<context>
    <name>calibration.check_labels</name>
    <message>
        <source>check these labels</source>
        <translation>vérifiez ces libellés</translation>
    </message>
</context>
<context>
    <name>calibration.check_layout_places</name>
    <message>
        <source>check the layout&apos;s positions and their unit, cover other round objects, or mark the markers by hand</source>
        <translation>vérifiez les places du plan et leur unité, masquez les autres objets ronds, ou pointez les marqueurs à la main</translation>
    </message>
</context>
<context>
    <name>calibration.check_length</name>
    <message>
        <source>Check the length itself, that it is on the floor, and the marker positions.</source>
        <translation>Vérifiez la longueur elle-même, si elle est posée au sol, et les places des marqueurs.</translation>
    </message>
</context>
<context>
    <name>calibration.check_one_camera</name>
    <message>
        <source>check that all are of one camera, at one zoom and focus</source>
        <translation>vérifiez que toutes sont d’une même caméra, au même zoom et à la même mise au point</translation>
    </message>
</context>
<context>
    <name>calibration.check_pictures</name>
    <message>
        <source>check that all images are sharp, of one flat board and of one camera at one zoom and focus</source>
        <translation>vérifiez que toutes les photos sont nettes, d’une même mire plate et d’une caméra au même zoom et à la même mise au point</translation>
    </message>
</context>
<context>
    <name>calibration.check_pixel_and_lens</name>
    <message>
        <source>check its pixel and the camera&apos;s intrinsics</source>
        <translation>vérifiez son pixel et les paramètres intrinsèques de la caméra</translation>
    </message>
</context>
<context>
    <name>calibration.check_place_and_pixel</name>
    <message>
        <source>check its position and its pixel</source>
        <translation>vérifiez sa place et son pixel</translation>
    </message>
</context>
<context>
    <name>calibration.check_point_labels</name>
    <message>
        <source>check which label belongs to which point in %1 and in this camera</source>
        <translation>vérifiez quel libellé va à quel point dans %1 et dans cette caméra</translation>
    </message>
</context>
<context>
    <name>calibration.check_signs</name>
    <message>
        <source>check the signs of the layout</source>
        <translation>vérifiez les signes du plan</translation>
    </message>
</context>
<context>
    <name>calibration.check_tag_places</name>
    <message>
        <source>check the layout&apos;s positions and their unit, or mark the markers by hand</source>
        <translation>vérifiez les positions du plan et leur unité, ou pointez les marqueurs à la main</translation>
    </message>
</context>
<context>
    <name>calibration.check_unit</name>
    <message>
        <source>check the unit of the layout</source>
        <translation>vérifiez l’unité du plan</translation>
    </message>
</context>
<context>
    <name>calibration.checking_halves</name>
    <message>
        <source>checking the halves against each other</source>
        <translation>contrôle des moitiés l’une par l’autre</translation>
    </message>
</context>
<context>
    <name>calibration.choose_floor_points</name>
    <message>
        <source>choose points on the floor</source>
        <translation>choisissez des points du sol</translation>
    </message>
</context>
<context>
    <name>calibration.choose_others</name>
    <message>
        <source>choose others</source>
        <translation>choisissez-en d’autres</translation>
    </message>
</context>
<context>
    <name>calibration.clear_view</name>
    <message>
        <source>clear the view of the markers</source>
        <translation>dégagez la vue des marqueurs</translation>
    </message>
</context>
<context>
    <name>calibration.common_and_unknown_markers</name>
    <message>
        <source>they have %1 (%2), and the layout does not contain %3</source>
        <translation>il y en a %1 (%2), et le plan ne connaît pas %3</translation>
    </message>
</context>
<context>
    <name>calibration.common_markers</name>
    <message>
        <source>they have %1 (%2)</source>
        <translation>il y en a %1 (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.convert_unit</name>
    <message>
        <source>convert its unit.</source>
        <translation>convertissez son unité.</translation>
    </message>
</context>
<context>
    <name>calibration.corner_left_out</name>
    <message>
        <source>1 outlier corner was left out, in %1.</source>
        <translation>1 coin qui s’écarte a été écarté, dans %1.</translation>
    </message>
</context>
<context>
    <name>calibration.corner_no_number</name>
    <message>
        <source>a corner of it is not a number</source>
        <translation>un de ses coins n’est pas un nombre</translation>
    </message>
</context>
<context>
    <name>calibration.corner_of_many_tags</name>
    <message>
        <source>a corner is that of one tag</source>
        <translation>un coin est celui d’un seul tag</translation>
    </message>
</context>
<context>
    <name>calibration.corner_unclear</name>
    <message>
        <source>one corner of the board is unclear</source>
        <translation>un coin de la mire ne se distingue pas</translation>
    </message>
</context>
<context>
    <name>calibration.corners_disagree</name>
    <message>
        <source>%1 of the corners do not agree with the others</source>
        <translation>%1 des coins ne concordent pas avec les autres</translation>
    </message>
</context>
<context>
    <name>calibration.corners_kept_in</name>
    <message>
        <source>%1 neighbouring outlier corners were kept, in %2</source>
        <translation>%1 coins voisins qui s’écartent ont été gardés, dans %2</translation>
    </message>
</context>
<context>
    <name>calibration.corners_kept_most_in</name>
    <message>
        <source>%1 neighbouring outlier corners were kept, most in %2</source>
        <translation>%1 coins voisins qui s’écartent ont été gardés, surtout dans %2</translation>
    </message>
</context>
<context>
    <name>calibration.corners_left_out_in</name>
    <message>
        <source>%1 outlier corners were left out, in %2.</source>
        <translation>%1 coins qui s’écartent ont été écartés, dans %2.</translation>
    </message>
</context>
<context>
    <name>calibration.corners_left_out_most_in</name>
    <message>
        <source>%1 outlier corners were left out, most in %2.</source>
        <translation>%1 coins qui s’écartent ont été écartés, surtout dans %2.</translation>
    </message>
</context>
<context>
    <name>calibration.corners_not_flat</name>
    <message>
        <source>its corners do not match a flat board</source>
        <translation>ses coins ne sont pas placés comme sur une mire plane</translation>
    </message>
</context>
<context>
    <name>calibration.corners_nowhere_near</name>
    <message>
        <source>its corners are %1 from where the other images predict them, theirs %2</source>
        <translation>ses coins sont à %1 de la prédiction des autres images, les leurs à %2</translation>
    </message>
</context>
<context>
    <name>calibration.correct_layout</name>
    <message>
        <source>correct the layout</source>
        <translation>corrigez le plan</translation>
    </message>
</context>
<context>
    <name>calibration.correct_pixels</name>
    <message>
        <source>correct the pixels</source>
        <translation>corrigez les pixels</translation>
    </message>
</context>
<context>
    <name>calibration.count_corners</name>
    <message>
        <source>count the inner corners, or leave the size out</source>
        <translation>comptez les coins intérieurs, ou omettez la taille</translation>
    </message>
</context>
<context>
    <name>calibration.disagree_in</name>
    <message>
        <source>%1 of the corners disagree, in %2</source>
        <translation>%1 des coins ne concordent pas, dans %2</translation>
    </message>
</context>
<context>
    <name>calibration.disagree_most_in</name>
    <message>
        <source>%1 of the corners disagree, most in %2</source>
        <translation>%1 des coins ne concordent pas, surtout dans %2</translation>
    </message>
</context>
<context>
    <name>calibration.done</name>
    <message>
        <source>done</source>
        <translation>terminé</translation>
    </message>
</context>
<context>
    <name>calibration.edges_wide</name>
    <message>
        <source>its edges are %1 pixels wide</source>
        <translation>ses bords font %1 pixels de large</translation>
    </message>
</context>
<context>
    <name>calibration.ends_on_one_pixel</name>
    <message>
        <source>both ends are on the same pixel of camera &apos;%1&apos;</source>
        <translation>les deux extrémités sont sur le même pixel de la caméra &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.far_edge</name>
    <message>
        <source>at the far edge</source>
        <translation>au bord éloigné</translation>
    </message>
</context>
<context>
    <name>calibration.far_left_corner</name>
    <message>
        <source>in the far left corner</source>
        <translation>dans le coin gauche éloigné</translation>
    </message>
</context>
<context>
    <name>calibration.far_right_corner</name>
    <message>
        <source>in the far right corner</source>
        <translation>dans le coin droit éloigné</translation>
    </message>
</context>
<context>
    <name>calibration.few_corners_seen</name>
    <message>
        <source>only %1 corners of the board are visible</source>
        <translation>seuls %1 coins de la mire sont vus</translation>
    </message>
</context>
<context>
    <name>calibration.fifth_would</name>
    <message>
        <source>add a fifth.</source>
        <translation>un cinquième le ferait.</translation>
    </message>
</context>
<context>
    <name>calibration.find_board_again</name>
    <message>
        <source>detect the board in it again</source>
        <translation>faites-y rechercher la mire à nouveau</translation>
    </message>
</context>
<context>
    <name>calibration.first_end_beyond</name>
    <message>
        <source>the first end is at or beyond the horizon of camera &apos;%1&apos;</source>
        <translation>la première extrémité est à l’horizon de la caméra &apos;%1&apos; ou au-delà</translation>
    </message>
</context>
<context>
    <name>calibration.fisheye</name>
    <message>
        <source>fisheye</source>
        <translation>fisheye</translation>
    </message>
</context>
<context>
    <name>calibration.fisheye_lens</name>
    <message>
        <source>Fisheye lens</source>
        <translation>Objectif fisheye</translation>
    </message>
</context>
<context>
    <name>calibration.fit_only_to</name>
    <message>
        <source>the markers fit only to %1</source>
        <translation>les marqueurs ne conviennent qu’à %1 près</translation>
    </message>
</context>
<context>
    <name>calibration.fits_without</name>
    <message>
        <source>without %1 the others fit to %2: check its position and its pixel</source>
        <translation>sans %1 les autres conviennent à %2 près : vérifier sa position et son pixel</translation>
    </message>
</context>
<context>
    <name>calibration.fitting_lens</name>
    <message>
        <source>fitting the lens model to %1 images</source>
        <translation>ajustement de l’objectif à %1 photos</translation>
    </message>
</context>
<context>
    <name>calibration.flip_image</name>
    <message>
        <source>switch off mirroring in the camera or its program, or flip the file</source>
        <translation>désactiver le miroir de la caméra ou de son programme, ou retourner le fichier</translation>
    </message>
</context>
<context>
    <name>calibration.floor_may_be_mirrored</name>
    <message>
        <source>if it is not, v is counted from below, and the labels are mirrored.</source>
        <translation>sinon, v est compté depuis le bas et les étiquettes sont en miroir.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_not_registered</name>
    <message>
        <source>the floor cannot be registered</source>
        <translation>le sol ne peut pas être localisé</translation>
    </message>
</context>
<context>
    <name>calibration.floor_part_unseen</name>
    <message>
        <source>%1 of the floor between the markers is out of view.</source>
        <translation>%1 du sol entre les marqueurs ne sont pas vus.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_unseen</name>
    <message>
        <source>None of the floor between the markers is in view.</source>
        <translation>Rien du sol entre les marqueurs n’est vu.</translation>
    </message>
</context>
<context>
    <name>calibration.floor_unsure</name>
    <message>
        <source>the floor uncertainty between the points is too large, ±%1</source>
        <translation>le sol entre les points n’est connu qu’à ±%1</translation>
    </message>
</context>
<context>
    <name>calibration.focal_length_groups</name>
    <message>
        <source>%1 give about %2, %3 (such as %4) give about %5</source>
        <translation>%1 environ %2, %3 (dont %4) environ %5</translation>
    </message>
</context>
<context>
    <name>calibration.focal_length_unsure</name>
    <message>
        <source>the images determine the focal length only to %1</source>
        <translation>les photos ne déterminent la distance focale qu’à %1</translation>
    </message>
</context>
<context>
    <name>calibration.focal_lengths_differ</name>
    <message>
        <source>The focal lengths across and down differ by %1</source>
        <translation>Les distances focales horizontale et verticale diffèrent de %1</translation>
    </message>
</context>
<context>
    <name>calibration.focus_or_light</name>
    <message>
        <source>focus the camera, or give more light</source>
        <translation>faites la mise au point, ou donnez plus de lumière</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_as_well</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model no better (%3)</source>
        <translation>il prédit les photos mises à part à %1, le modèle %2 pas mieux (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_better</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model only to %3</source>
        <translation>il prédit les photos mises à part à %1, le modèle %2 seulement à %3</translation>
    </message>
</context>
<context>
    <name>calibration.foretells_by_chance</name>
    <message>
        <source>it predicts held-out images to %1, the %2 model to %3; the difference may be chance</source>
        <translation>il prédit les photos mises à part à %1, le modèle %2 à %3, ce qui peut être un hasard</translation>
    </message>
</context>
<context>
    <name>calibration.four_common_markers</name>
    <message>
        <source>the layout and the image must have four markers in common</source>
        <translation>il faut quatre marqueurs communs au plan et à l’image</translation>
    </message>
</context>
<context>
    <name>calibration.four_markers_unchecked</name>
    <message>
        <source>Four markers are too few to check each other</source>
        <translation>Quatre marqueurs ne se contrôlent guère</translation>
    </message>
</context>
<context>
    <name>calibration.four_points_unchecked</name>
    <message>
        <source>Four points are too few to check each other</source>
        <translation>Quatre points ne se contrôlent guère</translation>
    </message>
</context>
<context>
    <name>calibration.four_shared_points</name>
    <message>
        <source>both cameras must see the same four points or more</source>
        <translation>il faut quatre points vus par les deux caméras</translation>
    </message>
</context>
<context>
    <name>calibration.give_board_size</name>
    <message>
        <source>give at least 3x3, such as 9x6, or leave the size out</source>
        <translation>donnez au moins 3x3, comme 9x6, ou omettez la taille</translation>
    </message>
</context>
<context>
    <name>calibration.give_distance</name>
    <message>
        <source>give a distance of 0 m to 1000 m</source>
        <translation>donnez une distance de 0 m à 1000 m</translation>
    </message>
</context>
<context>
    <name>calibration.give_field_of_view</name>
    <message>
        <source>give 2° to 150°, and the image size</source>
        <translation>donnez de 2° à 150°, et la taille de ses images</translation>
    </message>
</context>
<context>
    <name>calibration.give_height</name>
    <message>
        <source>give a height of 0.05 m to 100 m</source>
        <translation>donnez une hauteur de 0,05 m à 100 m</translation>
    </message>
</context>
<context>
    <name>calibration.give_one_of_them</name>
    <message>
        <source>give one of them</source>
        <translation>donnez l’un d’eux</translation>
    </message>
</context>
<context>
    <name>calibration.give_plain_numbers</name>
    <message>
        <source>give plain numbers</source>
        <translation>donnez des nombres ordinaires</translation>
    </message>
</context>
<context>
    <name>calibration.give_positive_number</name>
    <message>
        <source>give a number above 0</source>
        <translation>donnez un nombre supérieur à 0</translation>
    </message>
</context>
<context>
    <name>calibration.give_square_size</name>
    <message>
        <source>give a size such as 25mm</source>
        <translation>donnez-la comme 25mm</translation>
    </message>
</context>
<context>
    <name>calibration.give_tape_sigma</name>
    <message>
        <source>give about 2 mm</source>
        <translation>donnez environ 2 mm</translation>
    </message>
</context>
<context>
    <name>calibration.give_taped_length</name>
    <message>
        <source>enter the length measured with a tape</source>
        <translation>donnez la longueur mesurée au mètre ruban</translation>
    </message>
</context>
<context>
    <name>calibration.glue_board</name>
    <message>
        <source>glue the board onto something stiff</source>
        <translation>collez la mire sur un support rigide</translation>
    </message>
</context>
<context>
    <name>calibration.glue_board_flat</name>
    <message>
        <source>glue the board onto something stiff and flat</source>
        <translation>collez la mire sur un support rigide et plat</translation>
    </message>
</context>
<context>
    <name>calibration.good</name>
    <message>
        <source>Good: %1.</source>
        <translation>Bon&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.grows_beyond</name>
    <message>
        <source>Beyond the markers it grows, to ±%1 within %2 of them.</source>
        <translation>Au-delà des marqueurs, elle augmente jusqu’à ±%1 à moins de %2 d’eux.</translation>
    </message>
</context>
<context>
    <name>calibration.halves_contradict</name>
    <message>
        <source>two halves of the images give focal lengths that differ by %1</source>
        <translation>deux moitiés des photos donnent des distances focales différant de %1</translation>
    </message>
</context>
<context>
    <name>calibration.halves_foretell</name>
    <message>
        <source>each half of the images predicts the other to %1</source>
        <translation>chaque moitié prédit l’autre à %1</translation>
    </message>
</context>
<context>
    <name>calibration.halves_foretell_apart</name>
    <message>
        <source>each half of the images predicts the other to %1, at most %2 apart on that floor</source>
        <translation>chaque moitié prédit l’autre à %1, à %2 l’une de l’autre au pire sur ce sol</translation>
    </message>
</context>
<context>
    <name>calibration.held_out_markers</name>
    <message>
        <source>Markers that are left out one by one are predicted to %1 RMS.</source>
        <translation>Les marqueurs écartés un à un sont prédits à %1 RMS.</translation>
    </message>
</context>
<context>
    <name>calibration.hold_board_closer</name>
    <message>
        <source>hold it closer to the camera</source>
        <translation>tenez-la plus près de la caméra</translation>
    </message>
</context>
<context>
    <name>calibration.hold_board_still</name>
    <message>
        <source>hold it still, and focus the camera</source>
        <translation>tenez-la immobile, et faites la mise au point</translation>
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
        <translation>si ces images ont été recadrées, les vidéos doivent l’être de la même façon</translation>
    </message>
</context>
<context>
    <name>calibration.image_mirrored</name>
    <message>
        <source>mirrored left to right they fit to %1: is the image mirrored?</source>
        <translation>inversés de gauche à droite ils conviennent à %1 près : l’image est-elle en miroir ?</translation>
    </message>
</context>
<context>
    <name>calibration.image_repeats</name>
    <message>
        <source>1 of %1 images shows the board in the same position as another one, and each position counts once</source>
        <translation>1 photo sur %1 montre la mire dans la même position qu’une autre, et chaque position compte une fois</translation>
    </message>
</context>
<context>
    <name>calibration.images_left_out</name>
    <message>
        <source>Left out: %1.</source>
        <translation>Écartées : %1.</translation>
    </message>
</context>
<context>
    <name>calibration.images_left_out_among</name>
    <message>
        <source>%1 images were left out, among them %2.</source>
        <translation>%1 images ont été écartées, dont %2.</translation>
    </message>
</context>
<context>
    <name>calibration.images_repeat</name>
    <message>
        <source>%1 of %2 images show the board in the same position as another one, and each position counts once</source>
        <translation>%1 photos sur %2 montrent la mire dans la même position qu’une autre, et chaque position compte une fois</translation>
    </message>
</context>
<context>
    <name>calibration.inches</name>
    <message>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
</context>
<context>
    <name>calibration.inside</name>
    <message>
        <source>inside</source>
        <translation>à l’intérieur</translation>
    </message>
</context>
<context>
    <name>calibration.inside_expected_error</name>
    <message>
        <source>within the limit of %1 (2.5 σ).</source>
        <translation>dans l’erreur attendue de %1.</translation>
    </message>
</context>
<context>
    <name>calibration.keep_board_clear</name>
    <message>
        <source>keep the board clear and well lit</source>
        <translation>gardez la mire dégagée et bien éclairée</translation>
    </message>
</context>
<context>
    <name>calibration.keep_whole_board</name>
    <message>
        <source>keep the whole board in view</source>
        <translation>gardez toute la mire dans l’image</translation>
    </message>
</context>
<context>
    <name>calibration.label_each_marker</name>
    <message>
        <source>give each marker a label of its own</source>
        <translation>donnez à chaque marqueur son propre libellé</translation>
    </message>
</context>
<context>
    <name>calibration.label_each_point</name>
    <message>
        <source>give each point a label of its own</source>
        <translation>donnez à chaque point son propre libellé</translation>
    </message>
</context>
<context>
    <name>calibration.label_of_layout</name>
    <message>
        <source>label &apos;%1&apos; of the layout</source>
        <translation>libellé &apos;%1&apos; du plan</translation>
    </message>
</context>
<context>
    <name>calibration.labels_called</name>
    <message>
        <source>with %1 renamed %2 they fit to %3</source>
        <translation>avec %1 nommés %2, ils conviennent à %3</translation>
    </message>
</context>
<context>
    <name>calibration.labels_exchanged</name>
    <message>
        <source>with %1 and %2 swapped they fit to %3</source>
        <translation>avec %1 et %2 échangés, ils conviennent à %3</translation>
    </message>
</context>
<context>
    <name>calibration.lay_stick_nearer</name>
    <message>
        <source>put the stick on the floor, nearer to the camera</source>
        <translation>posez la règle au sol, plus près de la caméra</translation>
    </message>
</context>
<context>
    <name>calibration.layout_in_mm</name>
    <message>
        <source>it must be in mm</source>
        <translation>il est donné en mm</translation>
    </message>
</context>
<context>
    <name>calibration.layout_mirrored</name>
    <message>
        <source>with a reversed Y of the layout they fit to %1: check the signs of the layout, seen from above Y must point to the left of X</source>
        <translation>avec Y de la disposition inversé ils conviennent à %1 près : vérifier les signes de la disposition ; vu d’en haut, Y doit pointer à gauche de X</translation>
    </message>
</context>
<context>
    <name>calibration.layout_not_in_mm</name>
    <message>
        <source>if that is wrong, the layout is not in mm</source>
        <translation>si c’est faux, les nombres du plan ne sont pas des mm</translation>
    </message>
</context>
<context>
    <name>calibration.layout_too_small</name>
    <message>
        <source>the layout has %1 markers, four are needed</source>
        <translation>le plan a %1 marqueurs, il en faut quatre</translation>
    </message>
</context>
<context>
    <name>calibration.layout_written_mirrored</name>
    <message>
        <source>if the layout was written down mirrored, correct its signs and add it again</source>
        <translation>si le plan a été noté en miroir, corrigez ses signes et ajoutez-le à nouveau</translation>
    </message>
</context>
<context>
    <name>calibration.leave_one_tag</name>
    <message>
        <source>leave one of them on the floor</source>
        <translation>n’en laissez qu’un au sol</translation>
    </message>
</context>
<context>
    <name>calibration.leave_out_pictures</name>
    <message>
        <source>leave out these images if the board is bent, cut or covered there.</source>
        <translation>écartez ces photos si la mire y est déformée, coupée ou masquée.</translation>
    </message>
</context>
<context>
    <name>calibration.left_edge</name>
    <message>
        <source>at the left edge</source>
        <translation>au bord gauche</translation>
    </message>
</context>
<context>
    <name>calibration.length_factor</name>
    <message>
        <source>a length factor of %1 is not possible</source>
        <translation>un facteur de longueur de %1 ne donne pas de sol</translation>
    </message>
</context>
<context>
    <name>calibration.length_is</name>
    <message>
        <source>The length is %1 ± %2.</source>
        <translation>La longueur est %1 ± %2.</translation>
    </message>
</context>
<context>
    <name>calibration.length_longer</name>
    <message>
        <source>It is %1 longer than the %2 entered</source>
        <translation>Elle est plus longue de %1 que les %2 indiqués</translation>
    </message>
</context>
<context>
    <name>calibration.length_shorter</name>
    <message>
        <source>It is %1 shorter than the %2 entered</source>
        <translation>Elle est plus courte de %1 que les %2 indiqués</translation>
    </message>
</context>
<context>
    <name>calibration.length_unmeasured</name>
    <message>
        <source>the length cannot be measured</source>
        <translation>la longueur ne peut pas être mesurée</translation>
    </message>
</context>
<context>
    <name>calibration.length_unseen</name>
    <message>
        <source>no camera shows it</source>
        <translation>aucune caméra qui la voit n’a été donnée</translation>
    </message>
</context>
<context>
    <name>calibration.lens_assumed</name>
    <message>
        <source>The lens is not calibrated, and the markers hardly determine it (focal length %1 ± %2): what is not known of it is in the uncertainty.</source>
        <translation>L’objectif n’est pas étalonné et les marqueurs le déterminent à peine (distance focale %1 ± %2) : ce que l’on n’en sait pas est dans l’incertitude.</translation>
    </message>
</context>
<context>
    <name>calibration.lens_from_floor</name>
    <message>
        <source>The lens is not calibrated: focal length (%1 ± %2) and distortion (k1 %3 ± %4) were estimated from the markers.</source>
        <translation>L’objectif n’est pas étalonné : la distance focale (%1 ± %2) et la distorsion (k1 %3 ± %4) ont été estimées d’après les marqueurs.</translation>
    </message>
</context>
<context>
    <name>calibration.lens_of_other_camera</name>
    <message>
        <source>with the lens calibration of camera &apos;%1&apos; they fit to %2: are the views swapped?</source>
        <translation>avec l’étalonnage de l’objectif de la caméra « %1 » ils conviennent à %2 près : les vues sont-elles échangées ?</translation>
    </message>
</context>
<context>
    <name>calibration.lens_on_floor</name>
    <message>
        <source>±%1 in the middle and at most ±%2 (%3) on %4, from the lens calibration alone</source>
        <translation>±%1 au milieu et ±%2 au pire (%3) sur %4, pour ce qui tient à l’objectif</translation>
    </message>
</context>
<context>
    <name>calibration.lens_told</name>
    <message>
        <source>as specified</source>
        <translation>indiqué</translation>
    </message>
</context>
<context>
    <name>calibration.lens_unknown_elsewhere</name>
    <message>
        <source>the distortion elsewhere stays unknown</source>
        <translation>la distorsion ailleurs reste inconnue</translation>
    </message>
</context>
<context>
    <name>calibration.likely_unit</name>
    <message>
        <source>its numbers look like %1, with the camera %2 above the floor</source>
        <translation>ses nombres semblent être des %1, elle serait alors à %2 au-dessus du sol</translation>
    </message>
</context>
<context>
    <name>calibration.longer</name>
    <message>
        <source>longer</source>
        <translation>plus longs</translation>
    </message>
</context>
<context>
    <name>calibration.look_at</name>
    <message>
        <source>Check %1</source>
        <translation>Regardez %1</translation>
    </message>
</context>
<context>
    <name>calibration.look_at_ends</name>
    <message>
        <source>check that the same ends are marked in each image; if they are, register it again.</source>
        <translation>regardez si les mêmes extrémités sont pointées dans chaque image et, si oui, localisez-la à nouveau.</translation>
    </message>
</context>
<context>
    <name>calibration.look_at_pictures</name>
    <message>
        <source>check these images and leave out those that are blurred, bent or of another board.</source>
        <translation>regardez ces photos et écartez celles qui sont floues, déformées ou d’une autre mire.</translation>
    </message>
</context>
<context>
    <name>calibration.looking_about</name>
    <message>
        <source>searching around the best position</source>
        <translation>recherche autour de la meilleure place</translation>
    </message>
</context>
<context>
    <name>calibration.make_larger_layout</name>
    <message>
        <source>make a layout of four markers or more</source>
        <translation>faites un plan de quatre marqueurs ou plus</translation>
    </message>
</context>
<context>
    <name>calibration.mark_ends_in_one</name>
    <message>
        <source>mark its ends in at least one image</source>
        <translation>pointez ses extrémités dans au moins une image</translation>
    </message>
</context>
<context>
    <name>calibration.mark_more</name>
    <message>
        <source>mark more of the layout&apos;s markers, by their names in the layout</source>
        <translation>pointez davantage de marqueurs du plan, sous les noms du plan</translation>
    </message>
</context>
<context>
    <name>calibration.mark_there_again</name>
    <message>
        <source>mark it again in that view.</source>
        <translation>pointez-le là à nouveau.</translation>
    </message>
</context>
<context>
    <name>calibration.mark_two_ends</name>
    <message>
        <source>mark each end at its own position in the image</source>
        <translation>pointez les deux extrémités là où elles sont vues</translation>
    </message>
</context>
<context>
    <name>calibration.mark_where_seen</name>
    <message>
        <source>mark each of them at its own position in the image</source>
        <translation>pointez chacun là où il est vu</translation>
    </message>
</context>
<context>
    <name>calibration.marker_against_lens</name>
    <message>
        <source>this camera&apos;s lens model cannot project %1</source>
        <translation>%1 est là où l’objectif de cette caméra ne peut pas l’avoir mis</translation>
    </message>
</context>
<context>
    <name>calibration.marker_beyond_horizon</name>
    <message>
        <source>marker %1 would be at or beyond the horizon</source>
        <translation>le marqueur %1 serait à l’horizon ou au-delà</translation>
    </message>
</context>
<context>
    <name>calibration.marker_moved</name>
    <message>
        <source>Marker %1 has moved %2 = %3, %4 has not</source>
        <translation>Le marqueur %1 a bougé de %2 = %3, %4 non</translation>
    </message>
</context>
<context>
    <name>calibration.marker_off_by_all</name>
    <message>
        <source>%1 is %2 off in all cameras</source>
        <translation>%1 est décalé de %2 selon toutes les caméras</translation>
    </message>
</context>
<context>
    <name>calibration.marker_off_by_one</name>
    <message>
        <source>%1 is %2 off in the one camera that sees it</source>
        <translation>%1 est décalé de %2 selon la seule caméra qui le voit</translation>
    </message>
</context>
<context>
    <name>calibration.marker_pixel_no_number</name>
    <message>
        <source>the pixel of marker %1 is not a finite number</source>
        <translation>le pixel du marqueur %1 n’est pas un nombre fini</translation>
    </message>
</context>
<context>
    <name>calibration.marker_place_no_number</name>
    <message>
        <source>the position of marker %1 is not a finite number</source>
        <translation>la place du marqueur %1 n’est pas un nombre fini</translation>
    </message>
</context>
<context>
    <name>calibration.marker_twice_in_layout</name>
    <message>
        <source>marker %1 appears twice in the layout</source>
        <translation>le marqueur %1 est deux fois dans le plan</translation>
    </message>
</context>
<context>
    <name>calibration.marker_twice_in_picture</name>
    <message>
        <source>marker %1 appears twice in the image</source>
        <translation>le marqueur %1 est deux fois dans l’image</translation>
    </message>
</context>
<context>
    <name>calibration.markers_at_one_place</name>
    <message>
        <source>markers %1 and %2 have the same floor position</source>
        <translation>les marqueurs %1 et %2 sont au même endroit du sol</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit</name>
    <message>
        <source>%1 markers fit to %2 RMS (worst %3, %4); floor uncertainty ±%5</source>
        <translation>%1 marqueurs s’ajustent à %2 RMS (le pire %3, %4), et le sol entre eux est connu à ±%5</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit_many_ways</name>
    <message>
        <source>they fit the layout equally well in %1 ways, because it looks the same from several sides</source>
        <translation>ils s’ajustent aussi bien au plan de %1 façons, car il est identique vu de plusieurs côtés</translation>
    </message>
</context>
<context>
    <name>calibration.markers_fit_together</name>
    <message>
        <source>registered jointly with %1: %2 markers fit to %3 RMS; floor uncertainty ±%4</source>
        <translation>avec %1, %2 marqueurs s’ajustent à %3 RMS, et le sol entre eux est connu à ±%4</translation>
    </message>
</context>
<context>
    <name>calibration.markers_found</name>
    <message>
        <source>%1 of %2 were found, four are needed</source>
        <translation>%1 sur %2 ont été trouvés, il en faut quatre</translation>
    </message>
</context>
<context>
    <name>calibration.markers_in_place</name>
    <message>
        <source>%1 markers are within %2 = %3 of their positions.</source>
        <translation>%1 marqueurs sont à moins de %2 = %3 de leur place.</translation>
    </message>
</context>
<context>
    <name>calibration.markers_mirrored</name>
    <message>
        <source>the markers are mirrored</source>
        <translation>les marqueurs sont en miroir</translation>
    </message>
</context>
<context>
    <name>calibration.markers_missing</name>
    <message>
        <source>missing: %1</source>
        <translation>manquent&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>calibration.markers_moved</name>
    <message>
        <source>Markers %1 have moved %2 = %3, %4 has not</source>
        <translation>Les marqueurs %1 ont bougé de %2 = %3, %4 non</translation>
    </message>
</context>
<context>
    <name>calibration.markers_nearly_on_line</name>
    <message>
        <source>the markers are so close to one line (%1 the most) that the floor uncertainty is ±%2</source>
        <translation>les marqueurs sont presque alignés (surtout %1), si bien que le sol n’est connu qu’à ±%2</translation>
    </message>
</context>
<context>
    <name>calibration.markers_not_found</name>
    <message>
        <source>the floor markers cannot be found</source>
        <translation>les marqueurs du sol sont introuvables</translation>
    </message>
</context>
<context>
    <name>calibration.markers_not_told_apart</name>
    <message>
        <source>the markers cannot be distinguished</source>
        <translation>les marqueurs ne se distinguent pas</translation>
    </message>
</context>
<context>
    <name>calibration.markers_on_one_pixel</name>
    <message>
        <source>markers %1 and %2 are on the same pixel</source>
        <translation>les marqueurs %1 et %2 sont sur le même pixel</translation>
    </message>
</context>
<context>
    <name>calibration.markers_read</name>
    <message>
        <source>%1 of its markers could be read</source>
        <translation>%1 de ses marqueurs ont pu être lus</translation>
    </message>
</context>
<context>
    <name>calibration.markers_too_close</name>
    <message>
        <source>markers %1 and %2 are only %3 apart, too close for two of four</source>
        <translation>les marqueurs %1 et %2 ne sont qu’à %3 l’un de l’autre, trop proches pour deux sur quatre</translation>
    </message>
</context>
<context>
    <name>calibration.measure_again</name>
    <message>
        <source>mark and remeasure them, or add another</source>
        <translation>pointez-les et mesurez-les à nouveau, ou ajoutez-en un</translation>
    </message>
</context>
<context>
    <name>calibration.measure_it_again</name>
    <message>
        <source>remeasure it.</source>
        <translation>mesurez-le à nouveau.</translation>
    </message>
</context>
<context>
    <name>calibration.measure_or_mark_again</name>
    <message>
        <source>measure it, or mark it in the image, again.</source>
        <translation>mesurez-le, ou pointez-le dans l’image, à nouveau.</translation>
    </message>
</context>
<context>
    <name>calibration.metres</name>
    <message>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_corner</name>
    <message>
        <source>±%1 in the middle, ±%2 in the corner near %3.</source>
        <translation>±%1 au milieu, ±%2 dans le coin près de %3.</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_edge</name>
    <message>
        <source>±%1 in the middle, ±%2 at the edge near %3.</source>
        <translation>±%1 au milieu, ±%2 au bord près de %3.</translation>
    </message>
</context>
<context>
    <name>calibration.middle_and_near</name>
    <message>
        <source>±%1 in the middle, ±%2 near %3.</source>
        <translation>±%1 au milieu, ±%2 près de %3.</translation>
    </message>
</context>
<context>
    <name>calibration.misfit_most_at</name>
    <message>
        <source>%1 RMS, most at %2 (%3)</source>
        <translation>%1 RMS, surtout en %2 (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.misfit_unexplained</name>
    <message>
        <source>the %1 markers misfit by %2 (%3), and are too few to identify the wrong one</source>
        <translation>les %1 marqueurs s’écartent de %2 (%3) et se contrôlent trop peu pour dire lequel</translation>
    </message>
</context>
<context>
    <name>calibration.more_pairs</name>
    <message>
        <source>take more pairs, or register %1 better first</source>
        <translation>prenez plus de paires, ou localisez mieux %1 d’abord</translation>
    </message>
</context>
<context>
    <name>calibration.more_pictures</name>
    <message>
        <source>More images (%1 or more) would make it more certain.</source>
        <translation>Davantage de photos (%1 ou plus) le rendraient plus sûr.</translation>
    </message>
</context>
<context>
    <name>calibration.move_board</name>
    <message>
        <source>move it elsewhere, turn it or tilt it</source>
        <translation>déplacez-la, tournez-la ou inclinez-la</translation>
    </message>
</context>
<context>
    <name>calibration.move_planned_back</name>
    <message>
        <source>move it back or up, or choose a wider lens</source>
        <translation>reculez-la ou montez-la, ou choisissez un objectif plus large</translation>
    </message>
</context>
<context>
    <name>calibration.name_dictionary</name>
    <message>
        <source>name one like DICT_6X6_250, or leave it out</source>
        <translation>nommez-en un comme DICT_6X6_250, ou omettez-le</translation>
    </message>
</context>
<context>
    <name>calibration.name_each_camera</name>
    <message>
        <source>name each camera once</source>
        <translation>nommez chaque caméra une fois</translation>
    </message>
</context>
<context>
    <name>calibration.name_each_marker</name>
    <message>
        <source>give each marker a name of its own</source>
        <translation>donnez à chaque marqueur son propre nom</translation>
    </message>
</context>
<context>
    <name>calibration.name_one_marker</name>
    <message>
        <source>name one of %1</source>
        <translation>nommez-en un parmi %1</translation>
    </message>
</context>
<context>
    <name>calibration.name_tag_family</name>
    <message>
        <source>write the family into the labels, such as 36h11:7, or mark a marker by hand</source>
        <translation>écrivez la famille dans les libellés, par exemple 36h11:7, ou pointez un marqueur à la main</translation>
    </message>
</context>
<context>
    <name>calibration.name_two_apart</name>
    <message>
        <source>name two at different positions</source>
        <translation>nommez-en deux qui soient écartés</translation>
    </message>
</context>
<context>
    <name>calibration.near_edge</name>
    <message>
        <source>at the near edge</source>
        <translation>au bord proche</translation>
    </message>
</context>
<context>
    <name>calibration.near_left_corner</name>
    <message>
        <source>in the near left corner</source>
        <translation>dans le coin gauche proche</translation>
    </message>
</context>
<context>
    <name>calibration.near_right_corner</name>
    <message>
        <source>in the near right corner</source>
        <translation>dans le coin droit proche</translation>
    </message>
</context>
<context>
    <name>calibration.no_board_found</name>
    <message>
        <source>no board found</source>
        <translation>aucune mire trouvée</translation>
    </message>
</context>
<context>
    <name>calibration.no_charuco</name>
    <message>
        <source>the detected markers do not match a ChArUco board</source>
        <translation>les marqueurs lus ne sont pas placés comme sur une mire ChArUco</translation>
    </message>
</context>
<context>
    <name>calibration.no_charuco_of_size</name>
    <message>
        <source>the detected markers do not match a ChArUco board of %1 inner corners</source>
        <translation>les marqueurs lus ne sont pas placés comme sur une mire ChArUco de %1 coins intérieurs</translation>
    </message>
</context>
<context>
    <name>calibration.no_common_marker</name>
    <message>
        <source>no two of the cameras see the same marker</source>
        <translation>aucune paire de caméras ne voit le même marqueur</translation>
    </message>
</context>
<context>
    <name>calibration.no_dictionary</name>
    <message>
        <source>marker dictionary %1 does not exist</source>
        <translation>il n’y a pas de dictionnaire de marqueurs %1</translation>
    </message>
</context>
<context>
    <name>calibration.no_flat_floor</name>
    <message>
        <source>the markers do not fit a flat floor</source>
        <translation>les marqueurs ne s’ajustent pas à un sol plan</translation>
    </message>
</context>
<context>
    <name>calibration.no_lens_fits</name>
    <message>
        <source>no lens model fits these images</source>
        <translation>aucun objectif ne convient à ces photos</translation>
    </message>
</context>
<context>
    <name>calibration.no_millimetres</name>
    <message>
        <source>no value in millimetres: this calibration holds for only part of the image</source>
        <translation>pas de valeur en millimètres, car cet objectif ne vaut que pour une partie de l’image</translation>
    </message>
</context>
<context>
    <name>calibration.no_other_lens</name>
    <message>
        <source>no other model fits</source>
        <translation>aucun autre modèle ne convient</translation>
    </message>
</context>
<context>
    <name>calibration.no_pair_has_board</name>
    <message>
        <source>none of %1 pairs can be used</source>
        <translation>aucune des %1 paires n’est utilisable</translation>
    </message>
</context>
<context>
    <name>calibration.no_pose</name>
    <message>
        <source>no pose</source>
        <translation>pas de pose</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_corner</name>
    <message>
        <source>the corners of a tag are tl, tr, br and bl</source>
        <translation>les coins d’un tag sont tl, tr, br et bl</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_marker</name>
    <message>
        <source>it has no marker %1</source>
        <translation>il n’a pas de marqueur %1</translation>
    </message>
</context>
<context>
    <name>calibration.no_such_tag</name>
    <message>
        <source>%1 has no tag %2</source>
        <translation>%1 n’a pas de tag %2</translation>
    </message>
</context>
<context>
    <name>calibration.no_tag_number</name>
    <message>
        <source>&apos;%1&apos; is not the number of a tag</source>
        <translation>&apos;%1&apos; n’est pas un numéro de tag</translation>
    </message>
</context>
<context>
    <name>calibration.not_all_foretold</name>
    <message>
        <source>not all</source>
        <translation>pas toutes</translation>
    </message>
</context>
<context>
    <name>calibration.not_found_again</name>
    <message>
        <source>Not found again: %1.</source>
        <translation>Non retrouvés&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_by_pair</name>
    <message>
        <source>the camera cannot be registered by the pair</source>
        <translation>la caméra ne peut pas être localisée par la paire</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_through</name>
    <message>
        <source>the camera cannot be registered via another camera</source>
        <translation>la caméra ne peut pas être localisée par une autre</translation>
    </message>
</context>
<context>
    <name>calibration.not_registered_together</name>
    <message>
        <source>the cameras cannot be registered jointly</source>
        <translation>les caméras ne peuvent pas être localisées ensemble</translation>
    </message>
</context>
<context>
    <name>calibration.of_other_camera</name>
    <message>
        <source>it is of another camera, zoom or focus</source>
        <translation>elle vient d’une autre caméra, d’un autre zoom ou d’une autre mise au point</translation>
    </message>
</context>
<context>
    <name>calibration.other_focal_length</name>
    <message>
        <source>it gives a focal length of %1, the other images %2</source>
        <translation>elle donne une distance focale de %1, les autres images %2</translation>
    </message>
</context>
<context>
    <name>calibration.other_picking_size</name>
    <message>
        <source>at %1 they fit to %2: were they picked at that size?</source>
        <translation>en %1 ils conviennent à %2 près : ont-ils été relevés à cette taille ?</translation>
    </message>
</context>
<context>
    <name>calibration.other_picture_size</name>
    <message>
        <source>it is %1×%2, the other images are %3×%4</source>
        <translation>elle fait %1×%2, les autres photos %3×%4</translation>
    </message>
</context>
<context>
    <name>calibration.other_zoom</name>
    <message>
        <source>with a focal length of %1 instead of %2 they fit to %3: has the zoom or the lens changed?</source>
        <translation>avec une focale de %1 au lieu de %2 ils conviennent à %3 près : le zoom ou l’objectif a-t-il changé ?</translation>
    </message>
</context>
<context>
    <name>calibration.others_undetermined</name>
    <message>
        <source>the images do not determine any other model</source>
        <translation>les images ne déterminent aucun autre modèle</translation>
    </message>
</context>
<context>
    <name>calibration.outside_expected_error</name>
    <message>
        <source>beyond the limit of %1 (2.5 σ).</source>
        <translation>hors de l’erreur attendue de %1.</translation>
    </message>
</context>
<context>
    <name>calibration.pair_contradicts</name>
    <message>
        <source>it contradicts the other pairs by %1 RMS</source>
        <translation>elle contredit les autres paires de %1 RMS</translation>
    </message>
</context>
<context>
    <name>calibration.pair_fits</name>
    <message>
        <source>the cameras are %1 apart (±%2) by %3 pairs, whose corners fit to %4 RMS</source>
        <translation>les caméras sont distantes de %1 (±%2) d’après %3 paires, dont les coins s’ajustent à %4 RMS</translation>
    </message>
</context>
<context>
    <name>calibration.pair_floor_unsure</name>
    <message>
        <source>the floor uncertainty would be ±%1</source>
        <translation>l’incertitude au sol serait de ±%1</translation>
    </message>
</context>
<context>
    <name>calibration.pair_is_one_image</name>
    <message>
        <source>both are the same image</source>
        <translation>les deux sont la même image</translation>
    </message>
</context>
<context>
    <name>calibration.pair_lacks_board</name>
    <message>
        <source>the board was not found in &apos;%1&apos;</source>
        <translation>la mire n’a pas été trouvée dans « %1 »</translation>
    </message>
</context>
<context>
    <name>calibration.pair_lens_usual</name>
    <message>
        <source>A lens calibration has no stated uncertainty: a usual one was assumed.</source>
        <translation>Un étalonnage d’objectif n’indique pas son incertitude : une valeur usuelle a été supposée.</translation>
    </message>
</context>
<context>
    <name>calibration.pair_of_cameras</name>
    <message>
        <source>the relative position of the cameras</source>
        <translation>la position relative des caméras</translation>
    </message>
</context>
<context>
    <name>calibration.pair_sees_no_floor</name>
    <message>
        <source>it would see hardly any floor</source>
        <translation>elle ne verrait presque pas le sol</translation>
    </message>
</context>
<context>
    <name>calibration.pair_squares</name>
    <message>
        <source>Triangulated, the squares of the board are %1 (standard deviation %2).</source>
        <translation>Triangulés, les carrés de la mire mesurent %1 (écart type %2).</translation>
    </message>
</context>
<context>
    <name>calibration.pair_swapped</name>
    <message>
        <source>the images of each camera fit the lens calibration of the other one (%1 instead of %2 RMS)</source>
        <translation>les images de chaque caméra correspondent à l’étalonnage d’objectif de l’autre (%1 au lieu de %2 RMS)</translation>
    </message>
</context>
<context>
    <name>calibration.pair_turned</name>
    <message>
        <source>the board looks the same when turned by half, and %1 pairs fit both ways</source>
        <translation>la mire est identique tournée de 180°, et %1 paires s’ajustent des deux façons</translation>
    </message>
</context>
<context>
    <name>calibration.pair_undetermined</name>
    <message>
        <source>the board positions do not determine it</source>
        <translation>les positions de la mire ne la déterminent pas</translation>
    </message>
</context>
<context>
    <name>calibration.pair_without_pose</name>
    <message>
        <source>the corners in &apos;%1&apos; determine no pose</source>
        <translation>les coins dans « %1 » ne déterminent aucune position</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_contradict</name>
    <message>
        <source>the pairs contradict each other (%1 RMS together, %2 in each image alone)</source>
        <translation>les paires se contredisent (%1 RMS ensemble, %2 dans chaque image seule)</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_left_out</name>
    <message>
        <source>%1 pairs were not used.</source>
        <translation>%1 paires n’ont pas été utilisées.</translation>
    </message>
</context>
<context>
    <name>calibration.pairs_scatter</name>
    <message>
        <source>The pairs agree less well than the corners would allow, which is in the uncertainty: the board moved between the two frames of a pair, or a lens calibration is less accurate than stated.</source>
        <translation>Les paires concordent moins bien que les coins ne le permettraient, ce que l’incertitude contient : la mire a bougé entre les deux images d’une paire, ou un étalonnage d’objectif est moins précis qu’indiqué.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_alike</name>
    <message>
        <source>Neighbouring markers err alike, by %1 RMS: check that the floor is flat, and calibrate the lens at the zoom and focus that it records with.</source>
        <translation>Les marqueurs voisins s’écartent de la même façon, de %1 RMS : vérifiez que le sol est plan et étalonnez l’objectif au zoom et à la mise au point de l’enregistrement.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_layout</name>
    <message>
        <source>The residuals follow the layout: they disappear with X longer than Y by %1 % and the axes %2° off the right angle; measure both sides and both diagonals of the layout again.</source>
        <translation>Les écarts suivent le plan : ils disparaissent si X est plus long que Y de %1 % et si les axes s’écartent de %2° de l’angle droit ; mesurez à nouveau les deux côtés et les deux diagonales du plan.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_lens</name>
    <message>
        <source>The residuals follow the lens: %1 of them disappear with another focal length and distortion; calibrate the lens again, at the zoom and focus that it records with.</source>
        <translation>Les écarts suivent l’objectif : %1 disparaissent avec une autre distance focale et une autre distorsion ; étalonnez à nouveau l’objectif, au zoom et à la mise au point de l’enregistrement.</translation>
    </message>
</context>
<context>
    <name>calibration.pattern_marker</name>
    <message>
        <source>Marker %1 is %2 from where the others expect it: measure and mark it again.</source>
        <translation>Le marqueur %1 est à %2 de l’endroit où les autres le situent : mesurez-le et marquez-le à nouveau.</translation>
    </message>
</context>
<context>
    <name>calibration.picture_covered</name>
    <message>
        <source>The board covered only %1 of the image</source>
        <translation>Seulement %1 de l’image ont été couverts</translation>
    </message>
</context>
<context>
    <name>calibration.picture_stands_out</name>
    <message>
        <source>its %1 is an outlier.</source>
        <translation>ses %1 sortent du lot.</translation>
    </message>
</context>
<context>
    <name>calibration.picture_too_small</name>
    <message>
        <source>the image is too small</source>
        <translation>l’image est trop petite</translation>
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
        <translation>l’image n’a pas de taille</translation>
    </message>
</context>
<context>
    <name>calibration.pictures_fit</name>
    <message>
        <source>%1 images fit to %2, focal length %3 ± %4</source>
        <translation>%1 photos s’ajustent à %2, distance focale %3 ± %4</translation>
    </message>
</context>
<context>
    <name>calibration.pictures_fit_halves_apart</name>
    <message>
        <source>%1 images fit to %2, focal length %3 ± %4, halves at most %5 apart on that floor</source>
        <translation>%1 photos s’ajustent à %2, distance focale %3 ± %4, à %5 l’une de l’autre au pire sur ce sol</translation>
    </message>
</context>
<context>
    <name>calibration.pixels_not_square</name>
    <message>
        <source>the camera&apos;s pixels are not square, or its images were rescaled</source>
        <translation>les pixels de la caméra ne sont pas carrés, ou ses images ont été redimensionnées</translation>
    </message>
</context>
<context>
    <name>calibration.place_left</name>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower</name>
    <message>
        <source>lower</source>
        <translation>en bas</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower_left</name>
    <message>
        <source>lower left</source>
        <translation>en bas à gauche</translation>
    </message>
</context>
<context>
    <name>calibration.place_lower_right</name>
    <message>
        <source>lower right</source>
        <translation>en bas à droite</translation>
    </message>
</context>
<context>
    <name>calibration.place_middle</name>
    <message>
        <source>middle</source>
        <translation>au milieu</translation>
    </message>
</context>
<context>
    <name>calibration.place_right</name>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper</name>
    <message>
        <source>upper</source>
        <translation>en haut</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper_left</name>
    <message>
        <source>upper left</source>
        <translation>en haut à gauche</translation>
    </message>
</context>
<context>
    <name>calibration.place_upper_right</name>
    <message>
        <source>upper right</source>
        <translation>en haut à droite</translation>
    </message>
</context>
<context>
    <name>calibration.planned_camera</name>
    <message>
        <source>the planned camera</source>
        <translation>la caméra prévue</translation>
    </message>
</context>
<context>
    <name>calibration.planned_distance</name>
    <message>
        <source>its distance cannot be %1</source>
        <translation>elle ne peut pas être à %1 de distance</translation>
    </message>
</context>
<context>
    <name>calibration.planned_field_of_view</name>
    <message>
        <source>its field of view is %1</source>
        <translation>son champ de vision est de %1</translation>
    </message>
</context>
<context>
    <name>calibration.planned_height</name>
    <message>
        <source>its height above the floor cannot be %1</source>
        <translation>elle ne peut pas être à %1 au-dessus du sol</translation>
    </message>
</context>
<context>
    <name>calibration.planned_not_held</name>
    <message>
        <source>the markers it would see do not determine its pose</source>
        <translation>les marqueurs qu’elle verrait ne fixent pas sa position</translation>
    </message>
</context>
<context>
    <name>calibration.planned_sees_too_few</name>
    <message>
        <source>it would see only %1 of the layout&apos;s markers (%2), four are needed</source>
        <translation>de là, elle verrait %1 des marqueurs du plan (%2), il en faut quatre</translation>
    </message>
</context>
<context>
    <name>calibration.point_against_lens</name>
    <message>
        <source>the lens model cannot project point %1</source>
        <translation>le point %1 est là où aucun objectif ne peut l’avoir mis</translation>
    </message>
</context>
<context>
    <name>calibration.point_beyond_horizon</name>
    <message>
        <source>point %1 would be at or beyond the horizon</source>
        <translation>le point %1 serait à l’horizon ou au-delà</translation>
    </message>
</context>
<context>
    <name>calibration.point_beyond_through</name>
    <message>
        <source>point %1 is at or beyond the horizon of %2</source>
        <translation>le point %1 est à l’horizon de %2 ou au-delà</translation>
    </message>
</context>
<context>
    <name>calibration.point_outside_own</name>
    <message>
        <source>point %1 is outside the image of the camera to register (%2)</source>
        <translation>le point %1 est hors de l’image de la caméra à localiser (%2)</translation>
    </message>
</context>
<context>
    <name>calibration.point_outside_through</name>
    <message>
        <source>point %1 is outside the image of %2 (%3)</source>
        <translation>le point %1 est hors de l’image de %2 (%3)</translation>
    </message>
</context>
<context>
    <name>calibration.point_pixel_no_number</name>
    <message>
        <source>the pixel of point %1 is not a finite number</source>
        <translation>le pixel du point %1 n’est pas un nombre fini</translation>
    </message>
</context>
<context>
    <name>calibration.point_twice</name>
    <message>
        <source>point %1 appears twice</source>
        <translation>le point %1 y est deux fois</translation>
    </message>
</context>
<context>
    <name>calibration.points_fit</name>
    <message>
        <source>via %1, %2 floor points fit to %3 RMS (worst %4, %5); floor uncertainty ±%6, of which %8 contributes ±%7</source>
        <translation>par %1, %2 points du sol s’ajustent à %3 RMS (le pire %4, %5), et le sol entre eux est connu à ±%6, dont ±%7 viennent de %8</translation>
    </message>
</context>
<context>
    <name>calibration.points_mirrored</name>
    <message>
        <source>the points are mirrored between the images of the two cameras</source>
        <translation>les points sont en miroir entre les images des deux caméras</translation>
    </message>
</context>
<context>
    <name>calibration.points_on_one_pixel</name>
    <message>
        <source>points %1 and %2 are on the same pixel</source>
        <translation>les points %1 et %2 sont sur le même pixel</translation>
    </message>
</context>
<context>
    <name>calibration.points_undetermined</name>
    <message>
        <source>the points do not determine the camera position</source>
        <translation>les points ne déterminent pas où est la caméra</translation>
    </message>
</context>
<context>
    <name>calibration.poor</name>
    <message>
        <source>Poor: %1.</source>
        <translation>Médiocre&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.poor_measure_again</name>
    <message>
        <source>Poor, measure the markers again: %1.</source>
        <translation>Médiocre, mesurez à nouveau les marqueurs&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.print_is_bent</name>
    <message>
        <source>The board is not flat, it bulges by %1: glue it onto something stiff.</source>
        <translation>La mire n’est pas plane, elle est bombée de %1 : collez-la sur un support rigide.</translation>
    </message>
</context>
<context>
    <name>calibration.print_is_stretched</name>
    <message>
        <source>The print&apos;s squares are %1 %2 from row to row than from column to column: measure the squares in both directions.</source>
        <translation>Les cases de l’impression sont %1 %2 d’une ligne à l’autre que d’une colonne à l’autre : mesurez les cases dans les deux directions.</translation>
    </message>
</context>
<context>
    <name>calibration.print_may_be_stretched</name>
    <message>
        <source>measure the squares of the print in both directions, for it may be stretched, and take images with the board turned by 90 degrees</source>
        <translation>mesurez les cases de l’impression dans les deux directions, car elle peut être étirée, et prenez des images avec la mire tournée de 90 degrés</translation>
    </message>
</context>
<context>
    <name>calibration.print_was_heeded</name>
    <message>
        <source>The calibration allows for this.</source>
        <translation>L’étalonnage en tient compte.</translation>
    </message>
</context>
<context>
    <name>calibration.put_marker_back</name>
    <message>
        <source>move it back, or measure the markers again and register all cameras.</source>
        <translation>remettez-le en place, ou mesurez à nouveau et localisez toutes les caméras.</translation>
    </message>
</context>
<context>
    <name>calibration.put_markers_back</name>
    <message>
        <source>move them back, or measure the markers again and register all cameras.</source>
        <translation>remettez-les en place, ou mesurez à nouveau et localisez toutes les caméras.</translation>
    </message>
</context>
<context>
    <name>calibration.quarter_turn</name>
    <message>
        <source>turned by a quarter they fit to %1: was the image shown turned?</source>
        <translation>tournés d’un quart ils conviennent à %1 près : l’image était-elle tournée ?</translation>
    </message>
</context>
<context>
    <name>calibration.rational</name>
    <message>
        <source>rational</source>
        <translation>rationnel</translation>
    </message>
</context>
<context>
    <name>calibration.rational_lens</name>
    <message>
        <source>Rational lens</source>
        <translation>Objectif rationnel</translation>
    </message>
</context>
<context>
    <name>calibration.register_before_recording</name>
    <message>
        <source>register it again before you record.</source>
        <translation>localisez-la à nouveau avant de filmer.</translation>
    </message>
</context>
<context>
    <name>calibration.register_by_more</name>
    <message>
        <source>register it with more of them first</source>
        <translation>localisez-la d’abord par davantage d’entre eux</translation>
    </message>
</context>
<context>
    <name>calibration.register_if_gone</name>
    <message>
        <source>if they are gone or the camera points elsewhere, register it again</source>
        <translation>s’ils ont disparu ou si la caméra regarde ailleurs, localisez-la à nouveau</translation>
    </message>
</context>
<context>
    <name>calibration.register_one_by_one</name>
    <message>
        <source>first register the cameras one by one with this layout</source>
        <translation>localisez d’abord les caméras une à une par ce plan</translation>
    </message>
</context>
<context>
    <name>calibration.related_to</name>
    <message>
        <source>via %1 and a board that both see; floor uncertainty ±%2</source>
        <translation>par %1 et une mire que les deux voient ; incertitude au sol ±%2</translation>
    </message>
</context>
<context>
    <name>calibration.reverse_both</name>
    <message>
        <source>reverse both (a half turn), or turn the axes</source>
        <translation>inversez les deux (un demi-tour), ou tournez les axes</translation>
    </message>
</context>
<context>
    <name>calibration.reversed_x_alone</name>
    <message>
        <source>reversing X alone would mirror the floor; no camera above it sees it that way</source>
        <translation>inverser X seul mettrait le sol en miroir, et aucune caméra au-dessus ne le voit ainsi</translation>
    </message>
</context>
<context>
    <name>calibration.reversed_y_alone</name>
    <message>
        <source>reversing Y alone would mirror the floor; no camera above it sees it that way</source>
        <translation>inverser Y seul mettrait le sol en miroir, et aucune caméra au-dessus ne le voit ainsi</translation>
    </message>
</context>
<context>
    <name>calibration.right_edge</name>
    <message>
        <source>at the right edge</source>
        <translation>au bord droit</translation>
    </message>
</context>
<context>
    <name>calibration.rings_mirrored</name>
    <message>
        <source>%1 rings and dots fit the layout, mirrored</source>
        <translation>%1 anneaux et points conviennent à la disposition, en miroir</translation>
    </message>
</context>
<context>
    <name>calibration.same_as_other_camera</name>
    <message>
        <source>Camera &apos;%1&apos; sees the markers at the same pixels (to %2): check that the views are not swapped.</source>
        <translation>La caméra « %1 » voit les marqueurs aux mêmes pixels (à %2 près) : vérifier que les vues ne sont pas échangées.</translation>
    </message>
</context>
<context>
    <name>calibration.same_attitude</name>
    <message>
        <source>all %1 images show the board at nearly the same tilt, too little to determine the focal length</source>
        <translation>les %1 photos montrent la mire presque dans la même orientation, ce qui ne détermine pas la distance focale</translation>
    </message>
</context>
<context>
    <name>calibration.same_tag_as</name>
    <message>
        <source>it names the same tag as &apos;%1&apos;</source>
        <translation>il désigne le même tag que &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.second_end_beyond</name>
    <message>
        <source>the second end is at or beyond the horizon of camera &apos;%1&apos;</source>
        <translation>la seconde extrémité est à l’horizon de la caméra &apos;%1&apos; ou au-delà</translation>
    </message>
</context>
<context>
    <name>calibration.see_same_floor</name>
    <message>
        <source>aim them at a common part of the floor</source>
        <translation>faites-leur voir une partie commune du sol</translation>
    </message>
</context>
<context>
    <name>calibration.seen_by_other_camera</name>
    <message>
        <source>camera &apos;%1&apos; sees the markers there, to %2: are the views swapped?</source>
        <translation>la caméra « %1 » voit les marqueurs là, à %2 près : les vues sont-elles échangées ?</translation>
    </message>
</context>
<context>
    <name>calibration.sees_too_few_anywhere</name>
    <message>
        <source>at this height and field of view, no position within %1 of the markers shows four of them</source>
        <translation>à moins de %1 des marqueurs, nulle part elle n’en verrait quatre à cette hauteur et avec cet objectif</translation>
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
        <translation>aucune façon de nommer les %1 anneaux et pastilles ne convient au plan</translation>
    </message>
</context>
<context>
    <name>calibration.shared_points</name>
    <message>
        <source>%1 given</source>
        <translation>il y en a %1</translation>
    </message>
</context>
<context>
    <name>calibration.shorter</name>
    <message>
        <source>shorter</source>
        <translation>plus courts</translation>
    </message>
</context>
<context>
    <name>calibration.show_board_larger</name>
    <message>
        <source>show the board larger, sharp and well lit</source>
        <translation>montrez la mire plus grande, nette et bien éclairée</translation>
    </message>
</context>
<context>
    <name>calibration.show_board_to_both</name>
    <message>
        <source>show the whole board to both cameras at once, in ten positions or more</source>
        <translation>montrez toute la mire aux deux caméras à la fois, dans dix positions ou plus</translation>
    </message>
</context>
<context>
    <name>calibration.show_everywhere</name>
    <message>
        <source>show the board in the middle and near each corner of the image, and closer</source>
        <translation>montrez la mire au milieu et près de chaque coin de l’image, et de plus près</translation>
    </message>
</context>
<context>
    <name>calibration.show_missing_tags</name>
    <message>
        <source>show the missing tags (AprilTag 36h11, numbered from 0 in the layout&apos;s order) or rings, or mark the markers by hand</source>
        <translation>montrez les tags manquants (AprilTag 36h11, numérotés à partir de 0 dans l’ordre du plan) ou des anneaux, ou pointez les marqueurs à la main</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_of_board</name>
    <message>
        <source>show more of the board</source>
        <translation>montrez davantage de la mire</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_of_it</name>
    <message>
        <source>show more of it</source>
        <translation>montrez-en davantage</translation>
    </message>
</context>
<context>
    <name>calibration.show_more_shapes</name>
    <message>
        <source>show more of them, larger or in better light, or mark the markers by hand</source>
        <translation>montrez-en davantage, plus grands ou mieux éclairés, ou pointez les marqueurs à la main</translation>
    </message>
</context>
<context>
    <name>calibration.show_near_edges</name>
    <message>
        <source>show the board near its edges too.</source>
        <translation>montrez la mire aussi près des bords.</translation>
    </message>
</context>
<context>
    <name>calibration.show_numbered_tags</name>
    <message>
        <source>show the missing tags (of one family, with the numbers of the labels) or rings, or mark the markers by hand</source>
        <translation>montrez les tags manquants (d’une même famille, avec les numéros des libellés) ou des anneaux, ou pointez les marqueurs à la main</translation>
    </message>
</context>
<context>
    <name>calibration.show_one_charuco</name>
    <message>
        <source>show one ChArUco board</source>
        <translation>montrez une seule mire ChArUco</translation>
    </message>
</context>
<context>
    <name>calibration.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and well lit</source>
        <translation>montrez toute la mire, plate, nette et bien éclairée</translation>
    </message>
</context>
<context>
    <name>calibration.spread_markers</name>
    <message>
        <source>spread the markers over the floor</source>
        <translation>répartissez les marqueurs sur le sol</translation>
    </message>
</context>
<context>
    <name>calibration.spread_or_register_better</name>
    <message>
        <source>spread the points over the floor, or register %1 better first</source>
        <translation>répartissez les points sur le sol, ou localisez mieux %1 d’abord</translation>
    </message>
</context>
<context>
    <name>calibration.spread_points</name>
    <message>
        <source>spread the points over the floor, not along a line</source>
        <translation>répartissez les points sur le sol, pas le long d’une ligne</translation>
    </message>
</context>
<context>
    <name>calibration.spread_them</name>
    <message>
        <source>spread them over the floor</source>
        <translation>répartissez-les sur le sol</translation>
    </message>
</context>
<context>
    <name>calibration.squares_without_size</name>
    <message>
        <source>the squares have no size</source>
        <translation>les cases n’ont pas de taille</translation>
    </message>
</context>
<context>
    <name>calibration.stand_higher</name>
    <message>
        <source>mount it higher or farther away, or choose a wider lens</source>
        <translation>placez-la plus haut ou plus loin, ou choisissez un objectif plus large</translation>
    </message>
</context>
<context>
    <name>calibration.standard</name>
    <message>
        <source>standard</source>
        <translation>standard</translation>
    </message>
</context>
<context>
    <name>calibration.standard_lens</name>
    <message>
        <source>Standard lens</source>
        <translation>Objectif standard</translation>
    </message>
</context>
<context>
    <name>calibration.swap_pair</name>
    <message>
        <source>swap the images of the two cameras</source>
        <translation>échangez les images des deux caméras</translation>
    </message>
</context>
<context>
    <name>calibration.tag_seen_often</name>
    <message>
        <source>tag %1 (marker %2) appears %3 times</source>
        <translation>le tag %1 (marqueur %2) est vu %3 fois</translation>
    </message>
</context>
<context>
    <name>calibration.tags_fit_by_place_too</name>
    <message>
        <source>the tags fit the layout by the numbers in its labels and, numbered from 0, by its order</source>
        <translation>les tags s’ajustent au plan par les numéros de ses libellés et, numérotés à partir de 0, par son ordre</translation>
    </message>
</context>
<context>
    <name>calibration.tags_fit_nowhere</name>
    <message>
        <source>tags with the layout&apos;s numbers are there (%1), but not at its positions</source>
        <translation>des tags portant les numéros du plan sont là (%1), mais pas à ses positions</translation>
    </message>
</context>
<context>
    <name>calibration.tags_mirrored</name>
    <message>
        <source>%1 tags were found, mirrored</source>
        <translation>%1 tags ont été trouvés, en miroir</translation>
    </message>
</context>
<context>
    <name>calibration.tags_of_two_families</name>
    <message>
        <source>tags of two families, %1 and %2, fit the layout</source>
        <translation>des tags de deux familles, %1 et %2, s’ajustent au plan</translation>
    </message>
</context>
<context>
    <name>calibration.take_at_same_moment</name>
    <message>
        <source>check that the files belong together in this order and were taken at the same moments, and that both lens calibrations belong to these cameras</source>
        <translation>vérifiez que les fichiers vont ensemble dans cet ordre et ont été pris aux mêmes instants, et que les deux étalonnages d’objectif sont ceux de ces caméras</translation>
    </message>
</context>
<context>
    <name>calibration.take_ten</name>
    <message>
        <source>take ten or more, the board tilted differently in each</source>
        <translation>prenez-en dix ou plus, la mire inclinée différemment à chaque fois</translation>
    </message>
</context>
<context>
    <name>calibration.tape_sigma_not_positive</name>
    <message>
        <source>the σ of the tape measure is not above 0</source>
        <translation>le σ du mètre ruban n’est pas supérieur à 0</translation>
    </message>
</context>
<context>
    <name>calibration.tell_by_hand</name>
    <message>
        <source>mark by hand which of them is %1</source>
        <translation>indiquez à la main lequel est %1</translation>
    </message>
</context>
<context>
    <name>calibration.tenths_of_mm</name>
    <message>
        <source>tenths of a mm</source>
        <translation>dixièmes de mm</translation>
    </message>
</context>
<context>
    <name>calibration.thousandths_of_mm</name>
    <message>
        <source>thousandths of a mm</source>
        <translation>millièmes de mm</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_board</name>
    <message>
        <source>take images with the board tilted by 30 to 45 degrees, to each side</source>
        <translation>prenez des photos avec la mire inclinée de 30 à 45 degrés, de chaque côté</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_less</name>
    <message>
        <source>tilt it by 30 to 45 degrees</source>
        <translation>inclinez-la de 30 à 45 degrés</translation>
    </message>
</context>
<context>
    <name>calibration.tilt_or_charuco</name>
    <message>
        <source>show it in more positions with different tilts, or use a ChArUco board</source>
        <translation>montrez-la dans plus de positions avec des inclinaisons différentes, ou utilisez une mire ChArUco</translation>
    </message>
</context>
<context>
    <name>calibration.told_board_too_small</name>
    <message>
        <source>a board of %1 inner corners is too small</source>
        <translation>une mire de %1 coins intérieurs est trop petite</translation>
    </message>
</context>
<context>
    <name>calibration.told_length_not_positive</name>
    <message>
        <source>the entered length is not above 0</source>
        <translation>la longueur indiquée n’est pas supérieure à 0</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_corners</name>
    <message>
        <source>it has %1 corners of the board, six are needed</source>
        <translation>elle a %1 coins de la mire, il en faut six</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_found_again</name>
    <message>
        <source>%1 of its %2 markers were found again, two are needed</source>
        <translation>%1 de ses %2 marqueurs ont été retrouvés, il en faut deux</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_pictures</name>
    <message>
        <source>calibration needs three images of the board, %1 can be used</source>
        <translation>il faut trois photos de la mire, %1 sont utilisables</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_shapes</name>
    <message>
        <source>%1 rings or dots were found, four are needed</source>
        <translation>%1 anneaux ou pastilles ont été trouvés, il en faut quatre</translation>
    </message>
</context>
<context>
    <name>calibration.too_few_to_compare</name>
    <message>
        <source>too few images to compare it with other models</source>
        <translation>trop peu de photos pour le comparer à d’autres</translation>
    </message>
</context>
<context>
    <name>calibration.too_frontal</name>
    <message>
        <source>the board faces the camera too directly</source>
        <translation>la mire est vue trop de face</translation>
    </message>
</context>
<context>
    <name>calibration.too_small_for_board</name>
    <message>
        <source>the image is too small for a board</source>
        <translation>l’image est trop petite pour une mire</translation>
    </message>
</context>
<context>
    <name>calibration.two_cameras_needed</name>
    <message>
        <source>layout &apos;%2&apos; has %1 registered camera, two are needed</source>
        <translation>il y a %1 caméra sur le plan &apos;%2&apos;, il en faut deux</translation>
    </message>
</context>
<context>
    <name>calibration.two_directions</name>
    <message>
        <source>both an angle and a pair of markers were given for X</source>
        <translation>un angle et une paire de marqueurs ont été donnés pour X</translation>
    </message>
</context>
<context>
    <name>calibration.two_focal_lengths</name>
    <message>
        <source>the images do not agree on one focal length</source>
        <translation>les photos demandent deux distances focales</translation>
    </message>
</context>
<context>
    <name>calibration.two_origins</name>
    <message>
        <source>both a marker and a point were given for the origin</source>
        <translation>un marqueur et un point ont été donnés pour l’origine</translation>
    </message>
</context>
<context>
    <name>calibration.typical_testbed</name>
    <message>
        <source>a %1 × %2 floor seen from %3 above</source>
        <translation>un sol de %1 × %2 vu de %3 de haut</translation>
    </message>
</context>
<context>
    <name>calibration.u_outside</name>
    <message>
        <source>u = %1 of marker %2 is outside the image of %3</source>
        <translation>u = %1 du marqueur %2 est hors de l’image de %3</translation>
    </message>
</context>
<context>
    <name>calibration.u_v_swapped</name>
    <message>
        <source>with u and v swapped they fit to %1: are these columns swapped?</source>
        <translation>avec u et v échangés ils conviennent à %1 près : ces colonnes sont-elles échangées ?</translation>
    </message>
</context>
<context>
    <name>calibration.uncertain</name>
    <message>
        <source>Uncertain: %1.</source>
        <translation>Douteux : %1.</translation>
    </message>
</context>
<context>
    <name>calibration.unit</name>
    <message>
        <source>unit &apos;%1&apos;</source>
        <translation>unité &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>calibration.unit_unknown</name>
    <message>
        <source>it is not known</source>
        <translation>ce n’est pas connu</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_corner</name>
    <message>
        <source>The middle is out of view, ±%1 in the corner near %2.</source>
        <translation>Le milieu n’est pas vu, ±%1 dans le coin près de %2.</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_edge</name>
    <message>
        <source>The middle is out of view, ±%1 at the edge near %2.</source>
        <translation>Le milieu n’est pas vu, ±%1 au bord près de %2.</translation>
    </message>
</context>
<context>
    <name>calibration.unseen_middle_near</name>
    <message>
        <source>The middle is out of view, ±%1 near %2.</source>
        <translation>Le milieu n’est pas vu, ±%1 près de %2.</translation>
    </message>
</context>
<context>
    <name>calibration.usable</name>
    <message>
        <source>Usable: %1.</source>
        <translation>Utilisable&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>calibration.use_camera_picture</name>
    <message>
        <source>use an image from the camera</source>
        <translation>utilisez une image de la caméra</translation>
    </message>
</context>
<context>
    <name>calibration.use_camera_pictures</name>
    <message>
        <source>use images from the camera</source>
        <translation>utilisez des images de la caméra</translation>
    </message>
</context>
<context>
    <name>calibration.use_known_unit</name>
    <message>
        <source>use mm, cm, m or inch</source>
        <translation>utilisez mm, cm, m ou inch</translation>
    </message>
</context>
<context>
    <name>calibration.use_one_camera</name>
    <message>
        <source>use images of one camera at one zoom and focus</source>
        <translation>utilisez des photos d’une caméra au même zoom et à la même mise au point</translation>
    </message>
</context>
<context>
    <name>calibration.use_one_resolution</name>
    <message>
        <source>use images of one camera at one resolution</source>
        <translation>utilisez des photos d’une même caméra à une même résolution</translation>
    </message>
</context>
<context>
    <name>calibration.usual_lens</name>
    <message>
        <source>the images leave it open, so square pixels, an optical centre near the middle and a usual distortion were assumed</source>
        <translation>les images ne le déterminent pas, on a donc supposé des pixels carrés, un centre optique proche du milieu de l’image et une distorsion habituelle</translation>
    </message>
</context>
<context>
    <name>calibration.v_from_below</name>
    <message>
        <source>v = %1 - v fits to %2: is v counted from below?</source>
        <translation>v = %1 - v convient à %2 près : v est-il compté depuis le bas ?</translation>
    </message>
</context>
<context>
    <name>calibration.v_outside</name>
    <message>
        <source>v = %1 of marker %2 is outside the image of %3</source>
        <translation>v = %1 du marqueur %2 est hors de l’image de %3</translation>
    </message>
</context>
<context>
    <name>calibration.were_kept</name>
    <message>
        <source>they were kept</source>
        <translation>ils ont été gardés</translation>
    </message>
</context>
<context>
    <name>calibration.whether_moved</name>
    <message>
        <source>cannot determine whether %1 has moved</source>
        <translation>impossible de dire si %1 a bougé</translation>
    </message>
</context>
<context>
    <name>calibration.without_it_centre</name>
    <message>
        <source>Check %1: without it the optical centre moves by %2.</source>
        <translation>Vérifiez %1 : sans elle, le centre optique se déplace de %2.</translation>
    </message>
</context>
<context>
    <name>calibration.without_it_focal</name>
    <message>
        <source>Check %1: without it the focal length changes by %2.</source>
        <translation>Vérifiez %1 : sans elle, la distance focale change de %2.</translation>
    </message>
</context>
<context>
    <name>calibration.write_tags_as</name>
    <message>
        <source>write a tag as 100 or 36h11:100, its corner as 100.tl, the middle of two as 12+13</source>
        <translation>écrivez un tag 100 ou 36h11:100, son coin 100.tl, le milieu de deux 12+13</translation>
    </message>
</context>
<context>
    <name>calibration.wrong_by_more</name>
    <message>
        <source>it may be wrong by much more</source>
        <translation>l’erreur peut être bien plus grande</translation>
    </message>
</context>
<context>
    <name>calibration.x_without_length</name>
    <message>
        <source>the two markers for the X axis have the same position</source>
        <translation>les marqueurs que X doit suivre sont au même endroit</translation>
    </message>
</context>
<context>
    <name>calibration.y_left_of_x</name>
    <message>
        <source>seen from above, Y must point to the left of X</source>
        <translation>vu d’en haut, Y doit pointer à gauche de X</translation>
    </message>
</context>
<context>
    <name>capture.access_to_cameras</name>
    <message>
        <source>Access to cameras</source>
        <translation>Accès aux caméras</translation>
    </message>
</context>
<context>
    <name>capture.all_pictures_damaged</name>
    <message>
        <source>all its frames arrive damaged</source>
        <translation>toutes ses images arrivent endommagées</translation>
    </message>
</context>
<context>
    <name>capture.answers_but_silent</name>
    <message>
        <source>it answers but sends no frames</source>
        <translation>elle répond, mais n’envoie pas d’images</translation>
    </message>
</context>
<context>
    <name>capture.answers_but_silent_advice</name>
    <message>
        <source>check its trigger and this computer&apos;s firewall</source>
        <translation>vérifiez son déclencheur et le pare-feu de cet ordinateur</translation>
    </message>
</context>
<context>
    <name>capture.aravis_place_missing</name>
    <message>
        <source>it contains neither an address nor a serial number</source>
        <translation>elle ne donne ni adresse ni numéro de série</translation>
    </message>
</context>
<context>
    <name>capture.aravis_wishes</name>
    <message>
        <source>use rate, exposure_ms, gain, format, size, trigger=software, packet_size or packet_delay_us, as in ?rate=30&amp;size=640x480</source>
        <translation>prenez rate, exposure_ms, gain, format, size, trigger=software, packet_size ou packet_delay_us, comme dans&#xa0;?rate=30&amp;size=640x480</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_less</name>
    <message>
        <source>choose a smaller size or a lower rate</source>
        <translation>demandez une taille ou une cadence plus faible</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_other_mode</name>
    <message>
        <source>choose another size or format</source>
        <translation>demandez une autre taille ou un autre format</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_something_else</name>
    <message>
        <source>use another value, or leave the choice to the camera</source>
        <translation>demandez autre chose, ou laissez faire la caméra</translation>
    </message>
</context>
<context>
    <name>capture.ask_for_usable_format</name>
    <message>
        <source>choose one of %1</source>
        <translation>demandez-en un parmi %1</translation>
    </message>
</context>
<context>
    <name>capture.ask_within_sensor</name>
    <message>
        <source>choose a size within that</source>
        <translation>demandez une taille qui y tient</translation>
    </message>
</context>
<context>
    <name>capture.automatics_held</name>
    <message>
        <source>exposure, gain, white balance and focus are held</source>
        <translation>exposition, gain, balance des blancs et mise au point sont figés</translation>
    </message>
</context>
<context>
    <name>capture.automatics_of_camera</name>
    <message>
        <source>Automatic settings, camera %1</source>
        <translation>Automatismes, caméra %1</translation>
    </message>
</context>
<context>
    <name>capture.buffer_enough</name>
    <message>
        <source>up to %1, enough for network cameras</source>
        <translation>jusqu’à %1, assez pour des caméras réseau</translation>
    </message>
</context>
<context>
    <name>capture.buffer_not_known</name>
    <message>
        <source>the system does not report its maximum size (net.core.rmem_max)</source>
        <translation>le système ne dit pas quelle taille il peut avoir (net.core.rmem_max)</translation>
    </message>
</context>
<context>
    <name>capture.buffer_small</name>
    <message>
        <source>only %1</source>
        <translation>seulement %1</translation>
    </message>
</context>
<context>
    <name>capture.buffer_without_use</name>
    <message>
        <source>%1, too small only for network cameras</source>
        <translation>%1, trop peu seulement pour des caméras réseau</translation>
    </message>
</context>
<context>
    <name>capture.bus_of_speed_shared</name>
    <message>
        <source>cameras %1 share the bus %2, of %3</source>
        <translation>les caméras %1 partagent le bus %2, de %3</translation>
    </message>
</context>
<context>
    <name>capture.bus_shared</name>
    <message>
        <source>cameras %1 share the bus %2</source>
        <translation>les caméras %1 partagent le bus %2</translation>
    </message>
</context>
<context>
    <name>capture.came_back_changed</name>
    <message>
        <source>it came back with another frame size or format</source>
        <translation>elle est revenue avec des images d’une autre taille ou d’un autre format</translation>
    </message>
</context>
<context>
    <name>capture.camera_at_address</name>
    <message>
        <source>camera %1</source>
        <translation>caméra %1</translation>
    </message>
</context>
<context>
    <name>capture.camera_does_not_deliver</name>
    <message>
        <source>a camera sends no frames</source>
        <translation>une caméra ne livre pas d’images</translation>
    </message>
</context>
<context>
    <name>capture.cameras_are_listed</name>
    <message>
        <source>odograph cameras lists them</source>
        <translation>«&#xa0;Caméras…&#xa0;» dans Filmer les liste</translation>
    </message>
</context>
<context>
    <name>capture.cameras_will_lose</name>
    <message>
        <source>%1 will lose frames</source>
        <translation>%1 perdra des images</translation>
    </message>
</context>
<context>
    <name>capture.cannot_be_opened</name>
    <message>
        <source>it cannot be opened (%1)</source>
        <translation>elle ne peut pas être ouverte (%1)</translation>
    </message>
</context>
<context>
    <name>capture.check_cable</name>
    <message>
        <source>check its cable</source>
        <translation>vérifiez son câble</translation>
    </message>
</context>
<context>
    <name>capture.check_cable_and_address</name>
    <message>
        <source>check its cable and address</source>
        <translation>vérifiez son câble et son adresse</translation>
    </message>
</context>
<context>
    <name>capture.check_cable_and_network</name>
    <message>
        <source>check its cable and the network</source>
        <translation>vérifiez son câble et le réseau</translation>
    </message>
</context>
<context>
    <name>capture.check_power_and_cable</name>
    <message>
        <source>check its power and cable</source>
        <translation>vérifiez son alimentation et son câble</translation>
    </message>
</context>
<context>
    <name>capture.check_power_and_network</name>
    <message>
        <source>check its power and cable, and that this computer has an address in the camera&apos;s network</source>
        <translation>vérifiez son alimentation et son câble, et que cet ordinateur a une adresse dans le réseau de la caméra</translation>
    </message>
</context>
<context>
    <name>capture.check_usb_rights</name>
    <message>
        <source>check that you may use it (a udev rule), and that no other program does</source>
        <translation>vérifiez que vous pouvez l’utiliser (une règle udev), et qu’aucun autre programme ne le fait</translation>
    </message>
</context>
<context>
    <name>capture.choose_another_value</name>
    <message>
        <source>choose another one</source>
        <translation>choisissez-en un autre</translation>
    </message>
</context>
<context>
    <name>capture.choose_listed</name>
    <message>
        <source>choose a camera that odograph cameras lists</source>
        <translation>choisissez une caméra que liste «&#xa0;Caméras…&#xa0;» dans Filmer</translation>
    </message>
</context>
<context>
    <name>capture.choose_of_offer</name>
    <message>
        <source>choose one that it offers</source>
        <translation>choisissez dans ce qu’elle offre</translation>
    </message>
</context>
<context>
    <name>capture.choose_value_between</name>
    <message>
        <source>choose a value between</source>
        <translation>choisissez une valeur entre les deux</translation>
    </message>
</context>
<context>
    <name>capture.close_that_program</name>
    <message>
        <source>close that program</source>
        <translation>fermez ce programme</translation>
    </message>
</context>
<context>
    <name>capture.connect_right_camera</name>
    <message>
        <source>reconnect the original camera, or start over with this one</source>
        <translation>branchez celle qui convient, ou recommencez avec celle-ci</translation>
    </message>
</context>
<context>
    <name>capture.control_automatic</name>
    <message>
        <source>%1 cannot be set while it is automatic</source>
        <translation>%1 ne peut pas être réglé tant qu’il est automatique</translation>
    </message>
</context>
<context>
    <name>capture.control_goes</name>
    <message>
        <source>%1 ranges from %2 to %3</source>
        <translation>%1 va de %2 à %3</translation>
    </message>
</context>
<context>
    <name>capture.control_inactive</name>
    <message>
        <source>%1 cannot be set in the camera&apos;s current mode</source>
        <translation>%1 ne peut pas être réglé dans l’état actuel de la caméra</translation>
    </message>
</context>
<context>
    <name>capture.control_not_taken</name>
    <message>
        <source>it rejects this value for %1 (%2)</source>
        <translation>elle n’accepte pas cela pour %1 (%2)</translation>
    </message>
</context>
<context>
    <name>capture.control_value_refused</name>
    <message>
        <source>it rejects this value of %1</source>
        <translation>elle refuse cette valeur de %1</translation>
    </message>
</context>
<context>
    <name>capture.damaged_advice</name>
    <message>
        <source>try another cable or port, or choose a lower rate or a smaller frame size</source>
        <translation>essayez un autre câble ou port, ou demandez moins d’images ou de plus petites</translation>
    </message>
</context>
<context>
    <name>capture.dim_light_halves_rate</name>
    <message>
        <source>in dim light a camera halves its rate unless its automatic exposure is off</source>
        <translation>par faible lumière, une caméra divise d’elle-même sa cadence par deux, sauf si l’exposition automatique est désactivée</translation>
    </message>
</context>
<context>
    <name>capture.disk_full</name>
    <message>
        <source>its disk has only %1 left, of which %2 are kept free</source>
        <translation>il ne reste que %1 sur son disque, dont %2 sont réservés</translation>
    </message>
</context>
<context>
    <name>capture.disk_of</name>
    <message>
        <source>the disk of %1</source>
        <translation>le disque de %1</translation>
    </message>
</context>
<context>
    <name>capture.disk_too_slow</name>
    <message>
        <source>it is too slow</source>
        <translation>il est trop lent</translation>
    </message>
</context>
<context>
    <name>capture.does_not_answer</name>
    <message>
        <source>it does not answer</source>
        <translation>elle ne répond pas</translation>
    </message>
</context>
<context>
    <name>capture.does_not_start</name>
    <message>
        <source>it does not start (%1)</source>
        <translation>elle ne démarre pas (%1)</translation>
    </message>
</context>
<context>
    <name>capture.does_not_start_advice</name>
    <message>
        <source>check its cable, and that no other program uses it</source>
        <translation>vérifiez son câble, et qu’aucun autre programme ne l’utilise</translation>
    </message>
</context>
<context>
    <name>capture.end_other_writers</name>
    <message>
        <source>stop other programs that write to it</source>
        <translation>arrêtez ce qui y écrit par ailleurs</translation>
    </message>
</context>
<context>
    <name>capture.enlarge_buffer</name>
    <message>
        <source>sudo sysctl -w net.core.rmem_max=%1, and add the same line to /etc/sysctl.d/ to keep it</source>
        <translation>sudo sysctl -w net.core.rmem_max=%1, et mettez-le aussi dans /etc/sysctl.d/ pour le garder</translation>
    </message>
</context>
<context>
    <name>capture.expose_for_mains</name>
    <message>
        <source>expose for 10 or 20 ms with mains of 50 Hz, 8.3 or 16.7 ms with 60 Hz</source>
        <translation>exposez 10 ou 20 ms avec un secteur de 50 Hz, 8,3 ou 16,7 ms avec 60 Hz</translation>
    </message>
</context>
<context>
    <name>capture.exposed_for</name>
    <message>
        <source>exposed for %1</source>
        <translation>exposée %1</translation>
    </message>
</context>
<context>
    <name>capture.exposure_and_gain</name>
    <message>
        <source>Exposure and gain</source>
        <translation>Pose et gain</translation>
    </message>
</context>
<context>
    <name>capture.exposure_not_taken</name>
    <message>
        <source>it rejects this exposure (%1)</source>
        <translation>elle n’accepte pas cette pose (%1)</translation>
    </message>
</context>
<context>
    <name>capture.exposure_not_told</name>
    <message>
        <source>it does not report its exposure</source>
        <translation>elle n’indique pas son exposition</translation>
    </message>
</context>
<context>
    <name>capture.exposure_suits_lamps</name>
    <message>
        <source>exposed for %1, which suits lamps</source>
        <translation>exposée %1, ce qui convient aux lampes</translation>
    </message>
</context>
<context>
    <name>capture.failed</name>
    <message>
        <source>it failed (%1)</source>
        <translation>elle a échoué (%1)</translation>
    </message>
</context>
<context>
    <name>capture.failed_advice</name>
    <message>
        <source>if this continues, unplug it and plug it in again</source>
        <translation>débranchez-la et rebranchez-la si cela dure</translation>
    </message>
</context>
<context>
    <name>capture.flicker_filter_off</name>
    <message>
        <source>its filter is off</source>
        <translation>son filtre est désactivé</translation>
    </message>
</context>
<context>
    <name>capture.flicker_filtered</name>
    <message>
        <source>filtered by the camera (%1)</source>
        <translation>filtré par la caméra (%1)</translation>
    </message>
</context>
<context>
    <name>capture.flicker_of_camera</name>
    <message>
        <source>Lamp flicker, camera %1</source>
        <translation>Scintillement des lampes, caméra %1</translation>
    </message>
</context>
<context>
    <name>capture.forbidden</name>
    <message>
        <source>you may not use it</source>
        <translation>vous n’avez pas le droit de l’utiliser</translation>
    </message>
</context>
<context>
    <name>capture.forbidden_advice</name>
    <message>
        <source>join the group video (sudo usermod -aG video YOUR-NAME) and log in again</source>
        <translation>rejoignez le groupe video (sudo usermod -aG video YOUR-NAME) et reconnectez-vous</translation>
    </message>
</context>
<context>
    <name>capture.format</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 à %2</translation>
    </message>
</context>
<context>
    <name>capture.format_not_told</name>
    <message>
        <source>it does not report its pixel format (%1)</source>
        <translation>elle ne dit pas son format de pixel (%1)</translation>
    </message>
</context>
<context>
    <name>capture.format_not_understood</name>
    <message>
        <source>its pixel format is not supported</source>
        <translation>son format de pixel n’est pas compris</translation>
    </message>
</context>
<context>
    <name>capture.free_after_crash</name>
    <message>
        <source>a camera whose program has crashed is free again after some seconds</source>
        <translation>une caméra dont le programme a planté se libère après quelques secondes</translation>
    </message>
</context>
<context>
    <name>capture.gain_not_taken</name>
    <message>
        <source>it rejects this gain (%1)</source>
        <translation>elle n’accepte pas ce gain (%1)</translation>
    </message>
</context>
<context>
    <name>capture.give_address</name>
    <message>
        <source>give one as v4l2:/dev/video0, aravis:192.168.1.20, sim:A or file:PATH</source>
        <translation>donnez-en une comme v4l2:/dev/video0, aravis:192.168.1.20, sim:A ou file:PATH</translation>
    </message>
</context>
<context>
    <name>capture.give_aravis_place</name>
    <message>
        <source>give one as aravis:192.168.1.20 or aravis:SERIAL</source>
        <translation>donnez-en une comme aravis:192.168.1.20 ou aravis:SERIAL</translation>
    </message>
</context>
<context>
    <name>capture.gives_no_pictures</name>
    <message>
        <source>%1 sends no frames</source>
        <translation>%1 ne donne pas d’images</translation>
    </message>
</context>
<context>
    <name>capture.has_been_away</name>
    <message>
        <source>the connection was lost</source>
        <translation>elle était partie</translation>
    </message>
</context>
<context>
    <name>capture.held_while_recording</name>
    <message>
        <source>they are held while recording</source>
        <translation>ils sont figés pendant l’enregistrement</translation>
    </message>
</context>
<context>
    <name>capture.in_step</name>
    <message>
        <source>synchronised to %1</source>
        <translation>synchronisé à %1 près</translation>
    </message>
</context>
<context>
    <name>capture.in_step_as_way</name>
    <message>
        <source>at %1 that is %2</source>
        <translation>à %1, cela fait %2</translation>
    </message>
</context>
<context>
    <name>capture.join_video_group</name>
    <message>
        <source>add yourself to the group video (sudo usermod -aG video $USER), then log out and in again</source>
        <translation>ajoutez-vous au groupe video (sudo usermod -aG video $USER), puis déconnectez-vous et reconnectez-vous</translation>
    </message>
</context>
<context>
    <name>capture.keep_awake</name>
    <message>
        <source>keep it awake while it records</source>
        <translation>gardez-le éveillé pendant l’enregistrement</translation>
    </message>
</context>
<context>
    <name>capture.kept_before_sleep</name>
    <message>
        <source>the recording up to then is kept</source>
        <translation>ce qui précède est gardé</translation>
    </message>
</context>
<context>
    <name>capture.large_packets</name>
    <message>
        <source>large packets are allowed</source>
        <translation>les grands paquets sont permis</translation>
    </message>
</context>
<context>
    <name>capture.largest_picture</name>
    <message>
        <source>its frames have at most %1 pixels</source>
        <translation>ses images ont %1 pixels au plus</translation>
    </message>
</context>
<context>
    <name>capture.leave_control_out</name>
    <message>
        <source>leave it out</source>
        <translation>omettez-le</translation>
    </message>
</context>
<context>
    <name>capture.look_again</name>
    <message>
        <source>wait a few seconds, then check again</source>
        <translation>attendez quelques secondes et regardez à nouveau</translation>
    </message>
</context>
<context>
    <name>capture.look_at_cable</name>
    <message>
        <source>check its cable</source>
        <translation>regardez son câble</translation>
    </message>
</context>
<context>
    <name>capture.lost_by_slow_machine</name>
    <message>
        <source>%1, %2 lost because this machine is too slow</source>
        <translation>%1, %2 perdues car cet ordinateur est trop lent</translation>
    </message>
</context>
<context>
    <name>capture.lost_here</name>
    <message>
        <source>%1, %2 lost here</source>
        <translation>%1, %2 perdues ici</translation>
    </message>
</context>
<context>
    <name>capture.lost_on_wire</name>
    <message>
        <source>%1, %2 lost on the wire</source>
        <translation>%1, %2 perdues sur le câble</translation>
    </message>
</context>
<context>
    <name>capture.lost_on_wire_and_here</name>
    <message>
        <source>%1, %2 lost (%3 on the wire, %4 here)</source>
        <translation>%1, %2 perdues (%3 sur le câble, %4 ici)</translation>
    </message>
</context>
<context>
    <name>capture.machine_slept</name>
    <message>
        <source>it slept for %1 and recorded nothing meanwhile</source>
        <translation>il a été en veille pendant %1, et rien n’a été enregistré entre-temps</translation>
    </message>
</context>
<context>
    <name>capture.make_room</name>
    <message>
        <source>free some disk space, or move the project to another disk</source>
        <translation>libérez de la place, ou déplacez le projet sur un autre disque</translation>
    </message>
</context>
<context>
    <name>capture.mode_not_taken</name>
    <message>
        <source>it rejects %1</source>
        <translation>elle n’accepte pas %1</translation>
    </message>
</context>
<context>
    <name>capture.no_automatics</name>
    <message>
        <source>it has none</source>
        <translation>elle n’en a pas</translation>
    </message>
</context>
<context>
    <name>capture.no_network_camera</name>
    <message>
        <source>no network camera is used</source>
        <translation>aucune caméra réseau n’est utilisée</translation>
    </message>
</context>
<context>
    <name>capture.no_node</name>
    <message>
        <source>this computer has no USB or built-in camera (/dev/video*)</source>
        <translation>cet ordinateur ne montre aucune caméra USB ou intégrée (/dev/video*)</translation>
    </message>
</context>
<context>
    <name>capture.no_node_advice</name>
    <message>
        <source>if one is connected, try another cable and port, without a hub</source>
        <translation>s’il y en a une de branchée, essayez un autre câble et un autre port, sans concentrateur</translation>
    </message>
</context>
<context>
    <name>capture.no_pair_yet</name>
    <message>
        <source>no frames of the cameras have been paired yet</source>
        <translation>aucune paire d’images n’a encore été prise ensemble</translation>
    </message>
</context>
<context>
    <name>capture.no_picture_came</name>
    <message>
        <source>no frame arrived for half a second</source>
        <translation>aucune image n’est venue pendant une demi-seconde</translation>
    </message>
</context>
<context>
    <name>capture.no_picture_for</name>
    <message>
        <source>no frame has arrived for %1</source>
        <translation>aucune image n’est venue depuis %1</translation>
    </message>
</context>
<context>
    <name>capture.no_readable_format</name>
    <message>
        <source>it offers no supported format</source>
        <translation>elle n’a aucun format lisible</translation>
    </message>
</context>
<context>
    <name>capture.no_simulated_camera</name>
    <message>
        <source>simulated camera %1 does not exist</source>
        <translation>il n’y a pas de caméra simulée %1</translation>
    </message>
</context>
<context>
    <name>capture.no_software_trigger</name>
    <message>
        <source>it has no software trigger (%1)</source>
        <translation>elle n’a pas de déclenchement logiciel (%1)</translation>
    </message>
</context>
<context>
    <name>capture.no_such_address</name>
    <message>
        <source>no kind of camera has an address like this</source>
        <translation>aucune caméra n’a cette adresse</translation>
    </message>
</context>
<context>
    <name>capture.no_such_control</name>
    <message>
        <source>it has no setting &apos;%1&apos;</source>
        <translation>elle n’a rien nommé &apos;%1&apos; qui puisse être réglé</translation>
    </message>
</context>
<context>
    <name>capture.no_such_format</name>
    <message>
        <source>it has no format %1 (%2)</source>
        <translation>elle n’a pas le format %1 (%2)</translation>
    </message>
</context>
<context>
    <name>capture.no_usable_format</name>
    <message>
        <source>it offers no supported pixel format</source>
        <translation>elle n’a aucun format de pixel compris</translation>
    </message>
</context>
<context>
    <name>capture.no_usb_camera</name>
    <message>
        <source>no USB camera is used</source>
        <translation>aucune caméra USB n’est utilisée</translation>
    </message>
</context>
<context>
    <name>capture.nodes_forbidden</name>
    <message>
        <source>you may not use %1</source>
        <translation>vous n’avez pas le droit d’utiliser %1</translation>
    </message>
</context>
<context>
    <name>capture.nodes_usable</name>
    <message>
        <source>you may use all %1 video devices</source>
        <translation>vous pouvez utiliser les %1 périphériques vidéo</translation>
    </message>
</context>
<context>
    <name>capture.none_lost</name>
    <message>
        <source>%1, none lost</source>
        <translation>%1, aucune perdue</translation>
    </message>
</context>
<context>
    <name>capture.not_offered</name>
    <message>
        <source>it does not offer the requested mode</source>
        <translation>elle n’offre pas ce qui était demandé</translation>
    </message>
</context>
<context>
    <name>capture.not_registered</name>
    <message>
        <source>it is not registered to the floor</source>
        <translation>elle n’est pas localisée au sol</translation>
    </message>
</context>
<context>
    <name>capture.not_there</name>
    <message>
        <source>it is not connected</source>
        <translation>elle n’est pas là</translation>
    </message>
</context>
<context>
    <name>capture.nothing_lost_yet</name>
    <message>
        <source>nothing is lost yet</source>
        <translation>rien n’est encore perdu</translation>
    </message>
</context>
<context>
    <name>capture.one_camera_in_step</name>
    <message>
        <source>a single camera needs no synchronisation</source>
        <translation>une seule caméra est toujours synchronisée</translation>
    </message>
</context>
<context>
    <name>capture.one_not_held</name>
    <message>
        <source>%1 still adjusts automatically</source>
        <translation>%1 continue de changer de lui-même</translation>
    </message>
</context>
<context>
    <name>capture.open_video_again</name>
    <message>
        <source>open it again to see it from the start</source>
        <translation>rouvrez-la pour la voir depuis le début</translation>
    </message>
</context>
<context>
    <name>capture.other_camera_in_place</name>
    <message>
        <source>another camera (%1) has replaced it</source>
        <translation>une autre caméra (%1) est à sa place</translation>
    </message>
</context>
<context>
    <name>capture.other_serial_in_place</name>
    <message>
        <source>another camera (%1) has replaced camera %2</source>
        <translation>une autre caméra (%1) est à la place de la caméra %2</translation>
    </message>
</context>
<context>
    <name>capture.own_usb_buses</name>
    <message>
        <source>each USB camera has its own bus</source>
        <translation>chaque caméra USB a son propre bus</translation>
    </message>
</context>
<context>
    <name>capture.packet_delay_not_taken</name>
    <message>
        <source>it rejects this packet delay (%1)</source>
        <translation>elle n’accepte pas ce délai de paquet (%1)</translation>
    </message>
</context>
<context>
    <name>capture.packet_size</name>
    <message>
        <source>Packet size</source>
        <translation>Taille des paquets</translation>
    </message>
</context>
<context>
    <name>capture.packet_size_not_taken</name>
    <message>
        <source>it rejects this packet size (%1)</source>
        <translation>elle n’accepte pas cette taille de paquet (%1)</translation>
    </message>
</context>
<context>
    <name>capture.part_not_understood</name>
    <message>
        <source>&apos;%1&apos; is not valid</source>
        <translation>&apos;%1&apos; n’est pas compris</translation>
    </message>
</context>
<context>
    <name>capture.payload_not_told</name>
    <message>
        <source>it does not report how many bytes a frame has (%1)</source>
        <translation>elle ne dit pas quelle taille ont ses images (%1)</translation>
    </message>
</context>
<context>
    <name>capture.picture_of_camera</name>
    <message>
        <source>a frame of camera %1</source>
        <translation>une image de la caméra %1</translation>
    </message>
</context>
<context>
    <name>capture.picture_size_of_camera</name>
    <message>
        <source>Frame size, camera %1</source>
        <translation>Taille d’image, caméra %1</translation>
    </message>
</context>
<context>
    <name>capture.picture_waits_for_disk</name>
    <message>
        <source>a frame has waited %1; the write buffer is %2 full</source>
        <translation>une image l’a attendu %1, et %2 de la place d’attente est prise</translation>
    </message>
</context>
<context>
    <name>capture.pictures_being_lost</name>
    <message>
        <source>frames are being lost</source>
        <translation>des images se perdent</translation>
    </message>
</context>
<context>
    <name>capture.pictures_incomplete</name>
    <message>
        <source>its frames arrive incomplete</source>
        <translation>ses images arrivent incomplètes</translation>
    </message>
</context>
<context>
    <name>capture.pictures_may_pulse</name>
    <message>
        <source>brightness may pulse under lamps</source>
        <translation>les images peuvent pulser sous les lampes</translation>
    </message>
</context>
<context>
    <name>capture.pictures_without_size</name>
    <message>
        <source>its frames have no size</source>
        <translation>ses images n’ont pas de taille</translation>
    </message>
</context>
<context>
    <name>capture.plug_camera_in_again</name>
    <message>
        <source>plug %1 in again</source>
        <translation>rebranchez %1</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_again</name>
    <message>
        <source>plug it in again</source>
        <translation>rebranchez-la</translation>
    </message>
</context>
<context>
    <name>capture.plug_in_or_choose</name>
    <message>
        <source>plug it in, or choose a camera that odograph cameras lists</source>
        <translation>branchez-la, ou choisissez-en une de celles que liste «&#xa0;Caméras…&#xa0;» dans Filmer</translation>
    </message>
</context>
<context>
    <name>capture.put_disk_back</name>
    <message>
        <source>reconnect its disk, or move its folder back</source>
        <translation>remettez son disque ou son dossier où il était</translation>
    </message>
</context>
<context>
    <name>capture.rate_not_taken</name>
    <message>
        <source>it rejects this rate (%1)</source>
        <translation>elle n’accepte pas cette cadence (%1)</translation>
    </message>
</context>
<context>
    <name>capture.rate_too_slow</name>
    <message>
        <source>%1 (too slow)</source>
        <translation>%1 (trop lent)</translation>
    </message>
</context>
<context>
    <name>capture.rates_differ</name>
    <message>
        <source>the cameras run at %1 and %2</source>
        <translation>les caméras tournent à %1 et %2</translation>
    </message>
</context>
<context>
    <name>capture.receive_buffer</name>
    <message>
        <source>Receive buffer</source>
        <translation>Tampon de réception</translation>
    </message>
</context>
<context>
    <name>capture.receive_buffer_granted</name>
    <message>
        <source>the system keeps only %1 of the network&apos;s packets</source>
        <translation>le système ne garde que %1 des paquets du réseau</translation>
    </message>
</context>
<context>
    <name>capture.record_elsewhere</name>
    <message>
        <source>record to another disk, or use fewer cameras</source>
        <translation>filmez sur un autre disque, ou avec moins de caméras</translation>
    </message>
</context>
<context>
    <name>capture.recorded_is_kept</name>
    <message>
        <source>what was recorded so far is kept</source>
        <translation>ce qui a été enregistré jusqu’ici est gardé</translation>
    </message>
</context>
<context>
    <name>capture.recorded_is_there</name>
    <message>
        <source>it holds what was recorded so far</source>
        <translation>ce qui a été enregistré jusqu’ici s’y trouve</translation>
    </message>
</context>
<context>
    <name>capture.recording_file_gone</name>
    <message>
        <source>its file is no longer there</source>
        <translation>son fichier n’est plus là</translation>
    </message>
</context>
<context>
    <name>capture.register_in_testbed</name>
    <message>
        <source>register it in Testbed; Odograph needs this to measure where a robot is</source>
        <translation>localisez-la dans Banc, sinon ses images ne peuvent dire où est un robot</translation>
    </message>
</context>
<context>
    <name>capture.room_for</name>
    <message>
        <source>remaining recording time %1</source>
        <translation>temps d’enregistrement restant %1</translation>
    </message>
</context>
<context>
    <name>capture.see_own_line</name>
    <message>
        <source>see the line of that camera</source>
        <translation>voir sa propre ligne</translation>
    </message>
</context>
<context>
    <name>capture.send_less</name>
    <message>
        <source>or set both to MJPEG or to a smaller frame size</source>
        <translation>ou faites envoyer aux deux du MJPEG, ou des images plus petites</translation>
    </message>
</context>
<context>
    <name>capture.send_registered_size</name>
    <message>
        <source>set it to the size it was registered at, or calibrate and register it again</source>
        <translation>faites-lui envoyer la taille de sa localisation, ou étalonnez-la et localisez-la à nouveau</translation>
    </message>
</context>
<context>
    <name>capture.sends_no_pictures</name>
    <message>
        <source>it sends no frames</source>
        <translation>elle n’envoie pas d’images</translation>
    </message>
</context>
<context>
    <name>capture.serial_advice</name>
    <message>
        <source>check its power and cable; odograph cameras lists those that answer</source>
        <translation>vérifiez son alimentation et son câble&#xa0;; «&#xa0;Caméras…&#xa0;» dans Filmer liste celles qui répondent</translation>
    </message>
</context>
<context>
    <name>capture.serial_does_not_answer</name>
    <message>
        <source>no camera of this serial number answers</source>
        <translation>aucune caméra de ce numéro de série ne répond</translation>
    </message>
</context>
<context>
    <name>capture.set_as_before</name>
    <message>
        <source>restore its settings, or start over with size and format in its address</source>
        <translation>réglez-la comme avant, ou recommencez avec taille et format dans son adresse</translation>
    </message>
</context>
<context>
    <name>capture.set_between</name>
    <message>
        <source>set it to something between</source>
        <translation>réglez sur une valeur entre les deux</translation>
    </message>
</context>
<context>
    <name>capture.set_rate_or_trigger</name>
    <message>
        <source>set both to the same rate, or trigger them together</source>
        <translation>réglez les deux à la même cadence, ou déclenchez-les ensemble</translation>
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
        <translation>réglez &apos;%1&apos; sur votre secteur</translation>
    </message>
</context>
<context>
    <name>capture.set_to_one_rate</name>
    <message>
        <source>set both to the same rate</source>
        <translation>réglez les deux à la même cadence</translation>
    </message>
</context>
<context>
    <name>capture.set_to_something_else</name>
    <message>
        <source>set another value</source>
        <translation>réglez sur autre chose</translation>
    </message>
</context>
<context>
    <name>capture.set_width_and_height</name>
    <message>
        <source>set its width and height</source>
        <translation>réglez sa largeur et sa hauteur</translation>
    </message>
</context>
<context>
    <name>capture.several_not_held</name>
    <message>
        <source>%1 still adjust automatically</source>
        <translation>%1 continuent de changer d’eux-mêmes</translation>
    </message>
</context>
<context>
    <name>capture.simulated_camera</name>
    <message>
        <source>Simulated camera %1</source>
        <translation>Caméra simulée %1</translation>
    </message>
</context>
<context>
    <name>capture.size_as_registered</name>
    <message>
        <source>%1, as it was registered</source>
        <translation>%1, comme à sa localisation</translation>
    </message>
</context>
<context>
    <name>capture.size_not_as_registered</name>
    <message>
        <source>%1, but registered at %2</source>
        <translation>%1, mais localisée en %2</translation>
    </message>
</context>
<context>
    <name>capture.size_not_taken</name>
    <message>
        <source>it rejects this size (%1)</source>
        <translation>elle n’accepte pas cette taille (%1)</translation>
    </message>
</context>
<context>
    <name>capture.size_not_told</name>
    <message>
        <source>it does not report its width and height (%1)</source>
        <translation>elle ne dit pas sa taille (%1)</translation>
    </message>
</context>
<context>
    <name>capture.slow_camera</name>
    <message>
        <source>it delivers only %1 frames per second instead of the requested %2</source>
        <translation>elle ne prend que %1 images par seconde sur les %2 demandées</translation>
    </message>
</context>
<context>
    <name>capture.slow_camera_advice</name>
    <message>
        <source>give it more light or a shorter exposure, or ask for a lower rate</source>
        <translation>donnez-lui plus de lumière ou une pose plus courte, ou demandez une cadence plus basse</translation>
    </message>
</context>
<context>
    <name>capture.small_packets</name>
    <message>
        <source>small packets on %1</source>
        <translation>petits paquets sur %1</translation>
    </message>
</context>
<context>
    <name>capture.small_packets_advice</name>
    <message>
        <source>set the MTU of the camera&apos;s network port to 9000 (sudo ip link set dev NAME mtu 9000), if camera and switch support it</source>
        <translation>donnez au port de la caméra une MTU de 9000 (sudo ip link set dev NAME mtu 9000), si la caméra et le commutateur l’acceptent</translation>
    </message>
</context>
<context>
    <name>capture.step</name>
    <message>
        <source>Synchronisation</source>
        <translation>Synchronisation</translation>
    </message>
</context>
<context>
    <name>capture.take_another_camera</name>
    <message>
        <source>use another camera</source>
        <translation>prenez une autre caméra</translation>
    </message>
</context>
<context>
    <name>capture.take_camera_with_format</name>
    <message>
        <source>use a camera that offers one of %1</source>
        <translation>prenez une caméra qui en a un parmi %1</translation>
    </message>
</context>
<context>
    <name>capture.take_off_and_on</name>
    <message>
        <source>unplug it and plug it in again if this continues</source>
        <translation>débranchez-la et rebranchez-la si cela continue</translation>
    </message>
</context>
<context>
    <name>capture.take_simulated_camera</name>
    <message>
        <source>use sim:A or sim:B</source>
        <translation>prenez sim:A ou sim:B</translation>
    </message>
</context>
<context>
    <name>capture.taken_up_by_itself</name>
    <message>
        <source>Odograph reconnects automatically</source>
        <translation>elle est reprise d’elle-même</translation>
    </message>
</context>
<context>
    <name>capture.the_picture</name>
    <message>
        <source>the frame</source>
        <translation>l’image</translation>
    </message>
</context>
<context>
    <name>capture.the_recording</name>
    <message>
        <source>the recording %1</source>
        <translation>l’enregistrement %1</translation>
    </message>
</context>
<context>
    <name>capture.there_but_silent</name>
    <message>
        <source>it is connected but sends no frames</source>
        <translation>elle est là mais n’envoie pas d’images</translation>
    </message>
</context>
<context>
    <name>capture.there_but_silent_advice</name>
    <message>
        <source>check its cable; if this continues, plug it in again</source>
        <translation>regardez son câble, ou rebranchez-la si cela dure</translation>
    </message>
</context>
<context>
    <name>capture.these_and_others</name>
    <message>
        <source>%1 and others</source>
        <translation>%1 et d’autres</translation>
    </message>
</context>
<context>
    <name>capture.this_computer</name>
    <message>
        <source>this computer</source>
        <translation>cet ordinateur</translation>
    </message>
</context>
<context>
    <name>capture.turn_automatic_off</name>
    <message>
        <source>turn automatic mode off</source>
        <translation>désactivez l’automatisme</translation>
    </message>
</context>
<context>
    <name>capture.turn_off_at_camera</name>
    <message>
        <source>turn it off in the camera&apos;s own program, or keep the light steady while robots run</source>
        <translation>désactivez-le dans le programme de la caméra, ou gardez la lumière stable pendant que les robots roulent</translation>
    </message>
</context>
<context>
    <name>capture.turn_off_automatic_first</name>
    <message>
        <source>first turn off the automatic mode that controls it</source>
        <translation>désactivez d’abord l’automatisme qui le déplace</translation>
    </message>
</context>
<context>
    <name>capture.unplugged</name>
    <message>
        <source>it was unplugged</source>
        <translation>elle a été débranchée</translation>
    </message>
</context>
<context>
    <name>capture.usb_bus_full</name>
    <message>
        <source>its USB bus has no bandwidth left for its frames (the bus is full, not the disk)</source>
        <translation>son bus USB n’a plus de place pour ses images (c’est le bus qui est plein, pas le disque)</translation>
    </message>
</context>
<context>
    <name>capture.usb_bus_full_advice</name>
    <message>
        <source>plug it into a port whose bus no other camera uses, or choose MJPEG, a smaller frame size or a lower rate (?format=MJPG&amp;size=640x480&amp;rate=30)</source>
        <translation>branchez-la là où elle ne partage pas de bus, ou choisissez MJPEG, une image plus petite ou une cadence plus basse (?format=MJPG&amp;size=640x480&amp;rate=30)</translation>
    </message>
</context>
<context>
    <name>capture.usb_buses</name>
    <message>
        <source>USB buses</source>
        <translation>Bus USB</translation>
    </message>
</context>
<context>
    <name>capture.use_daylight</name>
    <message>
        <source>or use daylight</source>
        <translation>ou utilisez la lumière du jour</translation>
    </message>
</context>
<context>
    <name>capture.use_other_port</name>
    <message>
        <source>plug one into a port on the other side of the computer, or into its own USB card</source>
        <translation>branchez-en une sur un port de l’autre côté de l’ordinateur, ou sur sa propre carte</translation>
    </message>
</context>
<context>
    <name>capture.used_by_another_program</name>
    <message>
        <source>another program uses it</source>
        <translation>un autre programme l’utilise</translation>
    </message>
</context>
<context>
    <name>capture.used_by_program</name>
    <message>
        <source>another program uses it (open in %1)</source>
        <translation>un autre programme l’utilise (ouverte dans %1)</translation>
    </message>
</context>
<context>
    <name>capture.usual_mains</name>
    <message>
        <source>50 Hz in most countries, 60 Hz in the Americas</source>
        <translation>50 Hz dans la plupart des pays, 60 Hz en Amérique</translation>
    </message>
</context>
<context>
    <name>capture.v4l2_address_example</name>
    <message>
        <source>write it like v4l2:/dev/video0?size=1280x720&amp;rate=30&amp;format=MJPG</source>
        <translation>écrivez par exemple v4l2:/dev/video0?size=1280x720&amp;rate=30&amp;format=MJPG</translation>
    </message>
</context>
<context>
    <name>capture.video_has_ended</name>
    <message>
        <source>the video has ended</source>
        <translation>la vidéo est finie</translation>
    </message>
</context>
<context>
    <name>capture.wait_for_it</name>
    <message>
        <source>wait: Odograph is reconnecting</source>
        <translation>attendez&#xa0;: elle est reprise</translation>
    </message>
</context>
<context>
    <name>capture.wait_or_check_cable</name>
    <message>
        <source>wait, or check its cable</source>
        <translation>attendez, ou vérifiez son câble</translation>
    </message>
</context>
<context>
    <name>capture.waiting_for_first_picture</name>
    <message>
        <source>waiting for the first frame</source>
        <translation>attend la première image</translation>
    </message>
</context>
<context>
    <name>exchange.accepted</name>
    <message>
        <source>Accepted: %1</source>
        <translation>Accepté&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>exchange.and_lines_more</name>
    <message>
        <source>and %1 more lines</source>
        <translation>et %1 autres lignes</translation>
    </message>
</context>
<context>
    <name>exchange.archive_library_refused</name>
    <message>
        <source>the archive library failed</source>
        <translation>la bibliothèque d’archives a refusé</translation>
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
        <translation>axes du sol : %1 du fichier</translation>
    </message>
</context>
<context>
    <name>exchange.axes_seen</name>
    <message>
        <source>floor axes: %1 of the file, as its %2 stays near %3</source>
        <translation>axes du sol : %1 du fichier, car son %2 reste près de %3</translation>
    </message>
</context>
<context>
    <name>exchange.axes_unclear</name>
    <message>
        <source>its z varies by %1 while its %2 stays near %3</source>
        <translation>son z varie de %1 alors que son %2 reste près de %3</translation>
    </message>
</context>
<context>
    <name>exchange.begin_roster</name>
    <message>
        <source>begin the file with the line class,team or class,team,pseudonym</source>
        <translation>commencez le fichier par la ligne class,team ou class,team,pseudonym</translation>
    </message>
</context>
<context>
    <name>exchange.begin_with_header_or_tum</name>
    <message>
        <source>begin the file with the line %1, or write lines of %2</source>
        <translation>commencez le fichier par la ligne %1, ou écrivez des lignes de %2</translation>
    </message>
</context>
<context>
    <name>exchange.begin_with_line</name>
    <message>
        <source>begin the file with the line %1</source>
        <translation>commencez le fichier par la ligne %1</translation>
    </message>
</context>
<context>
    <name>exchange.break_opened</name>
    <message>
        <source>its positions jump by %1 in line %2 and go on from there: %3 positions around count as not measured, and the path ends at the jump</source>
        <translation>ses positions sautent de %1 à la ligne %2 et continuent de là : %3 positions autour comptent comme non mesurées, et le parcours s’arrête au saut</translation>
    </message>
</context>
<context>
    <name>exchange.breaks_too_often</name>
    <message>
        <source>its positions jump %1 times and go on from elsewhere</source>
        <translation>ses positions sautent %1 fois et continuent ailleurs</translation>
    </message>
</context>
<context>
    <name>exchange.cell_not_a_number</name>
    <message>
        <source>%1 &apos;%2&apos; is not a finite number</source>
        <translation>%1 &apos;%2&apos; n’est pas un nombre fini</translation>
    </message>
</context>
<context>
    <name>exchange.cell_of_columns</name>
    <message>
        <source>it has %1 cell where the header has %2</source>
        <translation>il y a %1 cellule où l’en-tête en a %2</translation>
    </message>
</context>
<context>
    <name>exchange.cells_of_columns</name>
    <message>
        <source>it has %1 cells where the header has %2</source>
        <translation>il y a %1 cellules où l’en-tête en a %2</translation>
    </message>
</context>
<context>
    <name>exchange.centre_impossible</name>
    <message>
        <source>the image centre (%1, %2) is far outside the image of %3 × %4 pixels</source>
        <translation>le centre de l&apos;image (%1, %2) est loin en dehors de l&apos;image de %3 × %4 pixels</translation>
    </message>
</context>
<context>
    <name>exchange.check_both_units</name>
    <message>
        <source>choose the units of its times and positions</source>
        <translation>choisissez les unités de ses temps et de ses positions</translation>
    </message>
</context>
<context>
    <name>exchange.check_it_is_there</name>
    <message>
        <source>check that it exists and that you may read it</source>
        <translation>vérifiez qu’il est là et peut être lu</translation>
    </message>
</context>
<context>
    <name>exchange.check_one_run</name>
    <message>
        <source>check that all lines are of one run</source>
        <translation>vérifiez que toutes les lignes sont d’un même passage</translation>
    </message>
</context>
<context>
    <name>exchange.check_right_file</name>
    <message>
        <source>check that it is the right file</source>
        <translation>vérifiez que c’est le bon fichier</translation>
    </message>
</context>
<context>
    <name>exchange.check_track_column</name>
    <message>
        <source>check which column says the track of a line</source>
        <translation>vérifiez quelle colonne indique la trajectoire d’une ligne</translation>
    </message>
</context>
<context>
    <name>exchange.check_unit_of_places</name>
    <message>
        <source>check the unit of the positions: m, cm or mm</source>
        <translation>vérifiez l’unité des places&#xa0;: m, cm ou mm</translation>
    </message>
</context>
<context>
    <name>exchange.check_unit_of_times</name>
    <message>
        <source>check the unit of the times, and that all lines are of one run</source>
        <translation>vérifiez l’unité des temps, et que toutes les lignes sont d’un même passage</translation>
    </message>
</context>
<context>
    <name>exchange.choose_axes</name>
    <message>
        <source>choose the axes of the floor: %1, or xy if that is right</source>
        <translation>choisissez les axes du sol : %1, ou xy si c’est juste</translation>
    </message>
</context>
<context>
    <name>exchange.choose_axes_xy</name>
    <message>
        <source>choose the axes x and y</source>
        <translation>choisissez les axes x et y</translation>
    </message>
</context>
<context>
    <name>exchange.choose_column</name>
    <message>
        <source>choose from %1</source>
        <translation>choisissez parmi %1</translation>
    </message>
</context>
<context>
    <name>exchange.choose_decimal_sign</name>
    <message>
        <source>choose its decimal sign: point or comma</source>
        <translation>choisissez son signe décimal : point ou virgule</translation>
    </message>
</context>
<context>
    <name>exchange.choose_entry</name>
    <message>
        <source>choose one of them</source>
        <translation>choisissez l&apos;une d&apos;elles</translation>
    </message>
</context>
<context>
    <name>exchange.choose_likely_unit</name>
    <message>
        <source>choose their unit: m, cm, mm, in, ft or px; %1 is likely</source>
        <translation>choisissez leur unité : m, cm, mm, in, ft ou px ; %1 est probable</translation>
    </message>
</context>
<context>
    <name>exchange.choose_longer_track</name>
    <message>
        <source>choose a file with three positions or more</source>
        <translation>choisissez un fichier avec trois positions ou plus</translation>
    </message>
</context>
<context>
    <name>exchange.choose_new_folder</name>
    <message>
        <source>choose a folder that does not exist yet</source>
        <translation>choisissez un dossier qui n’existe pas encore</translation>
    </message>
</context>
<context>
    <name>exchange.choose_packed_file</name>
    <message>
        <source>choose a file that Odograph has packed; if it is damaged, copy it again</source>
        <translation>choisissez un fichier empaqueté par Odograph, et recopiez-le s’il est endommagé</translation>
    </message>
</context>
<context>
    <name>exchange.choose_style</name>
    <message>
        <source>choose analysis, international or continental</source>
        <translation>choisissez analysis, international ou continental</translation>
    </message>
</context>
<context>
    <name>exchange.choose_time_unit</name>
    <message>
        <source>choose their unit: s, ms, us, ns, min, h, d or frame; %1 is likely</source>
        <translation>choisissez leur unité : s, ms, us, ns, min, h, d ou frame ; %1 est probable</translation>
    </message>
</context>
<context>
    <name>exchange.choose_unit</name>
    <message>
        <source>choose their unit: m, cm, mm, in, ft or px</source>
        <translation>choisissez leur unité : m, cm, mm, in, ft ou px</translation>
    </message>
</context>
<context>
    <name>exchange.close_quotes</name>
    <message>
        <source>close the quotes</source>
        <translation>fermez les guillemets</translation>
    </message>
</context>
<context>
    <name>exchange.closed_neither</name>
    <message>
        <source>&apos;closed&apos; is neither true nor false</source>
        <translation>&apos;closed&apos; n’est ni true ni false</translation>
    </message>
</context>
<context>
    <name>exchange.coefficients_no_row</name>
    <message>
        <source>&apos;distortion_coefficients&apos; is neither a row nor a column</source>
        <translation>&apos;distortion_coefficients&apos; n’est ni une ligne ni une colonne</translation>
    </message>
</context>
<context>
    <name>exchange.column_twice</name>
    <message>
        <source>it is named twice</source>
        <translation>elle est nommée deux fois</translation>
    </message>
</context>
<context>
    <name>exchange.commas_group_thousands</name>
    <message>
        <source>commas separate thousands</source>
        <translation>les virgules séparent les milliers</translation>
    </message>
</context>
<context>
    <name>exchange.confidence_not_used</name>
    <message>
        <source>its confidences are neither from 0 to 1 nor from 0 to 100, and were not used</source>
        <translation>ses valeurs de confiance ne vont ni de 0 à 1 ni de 0 à 100 et n’ont pas été utilisées</translation>
    </message>
</context>
<context>
    <name>exchange.csv_column</name>
    <message>
        <source>column &apos;%1&apos; of CSV</source>
        <translation>colonne &apos;%1&apos; de CSV</translation>
    </message>
</context>
<context>
    <name>exchange.csv_style</name>
    <message>
        <source>style &apos;%1&apos; of CSV</source>
        <translation>style &apos;%1&apos; de CSV</translation>
    </message>
</context>
<context>
    <name>exchange.cut_line_left_out</name>
    <message>
        <source>the last line, line %1, was left out, because it ends too early</source>
        <translation>la dernière ligne, la ligne %1, a été omise, car elle se termine trop tôt</translation>
    </message>
</context>
<context>
    <name>exchange.does_not_belong</name>
    <message>
        <source>&apos;%1&apos; does not belong in a packed project</source>
        <translation>&apos;%1&apos; n’a pas sa place dans un projet empaqueté</translation>
    </message>
</context>
<context>
    <name>exchange.entry_is_missing</name>
    <message>
        <source>the entry &apos;%1&apos; is missing</source>
        <translation>l’entrée &apos;%1&apos; manque</translation>
    </message>
</context>
<context>
    <name>exchange.file_too_large</name>
    <message>
        <source>it is larger than %1</source>
        <translation>il mesure plus de %1</translation>
    </message>
</context>
<context>
    <name>exchange.fill_in_all_cells</name>
    <message>
        <source>give each line as many cells as the header</source>
        <translation>donnez à chaque ligne autant de cellules qu’à l’en-tête</translation>
    </message>
</context>
<context>
    <name>exchange.fill_in_both</name>
    <message>
        <source>fill in both or none</source>
        <translation>remplissez les deux ou aucun</translation>
    </message>
</context>
<context>
    <name>exchange.focal_impossible</name>
    <message>
        <source>no lens has a focal length of %1 at %2 × %3 pixels</source>
        <translation>aucun objectif n&apos;a une focale de %1 pour %2 × %3 pixels</translation>
    </message>
</context>
<context>
    <name>exchange.format_has_pixels</name>
    <message>
        <source>%1 writes positions in pixels, which are no lengths</source>
        <translation>%1 écrit les positions en pixels, qui ne sont pas des longueurs</translation>
    </message>
</context>
<context>
    <name>exchange.frame_without_time</name>
    <message>
        <source>it has no time that can be read</source>
        <translation>elle n’a pas de temps lisible</translation>
    </message>
</context>
<context>
    <name>exchange.frames_without_rate</name>
    <message>
        <source>it has frame numbers in place of times</source>
        <translation>il a des numéros d’image au lieu de temps</translation>
    </message>
</context>
<context>
    <name>exchange.give_known_units</name>
    <message>
        <source>give times in s or ms and positions in m, cm or mm</source>
        <translation>donnez les temps en s ou ms et les lieux en m, cm ou mm</translation>
    </message>
</context>
<context>
    <name>exchange.give_lower_confidence</name>
    <message>
        <source>give a lower least confidence</source>
        <translation>indiquez une confiance minimale plus basse</translation>
    </message>
</context>
<context>
    <name>exchange.give_marker_label</name>
    <message>
        <source>give each marker a label</source>
        <translation>donnez un libellé à chaque marqueur</translation>
    </message>
</context>
<context>
    <name>exchange.give_one_path</name>
    <message>
        <source>give one of points_mm, circle, figure_eight or slalom</source>
        <translation>donnez points_mm, circle, figure_eight ou slalom</translation>
    </message>
</context>
<context>
    <name>exchange.give_one_zone</name>
    <message>
        <source>give all corners in order as corners_mm, or two opposite corners as rectangle_mm</source>
        <translation>donnez corners_mm, tout autour, ou deux coins opposés avec rectangle_mm</translation>
    </message>
</context>
<context>
    <name>exchange.give_pixel_length</name>
    <message>
        <source>give how long a pixel is on the floor, or choose another unit of the positions</source>
        <translation>indiquez la longueur d’un pixel au sol, ou choisissez une autre unité des positions</translation>
    </message>
</context>
<context>
    <name>exchange.give_point_label</name>
    <message>
        <source>give each point a label</source>
        <translation>donnez un libellé à chaque point</translation>
    </message>
</context>
<context>
    <name>exchange.give_rate</name>
    <message>
        <source>give the frame rate of the camera</source>
        <translation>indiquez la fréquence d’images de la caméra</translation>
    </message>
</context>
<context>
    <name>exchange.give_two_corners</name>
    <message>
        <source>give two opposite corners: [[x, y], [x, y]]</source>
        <translation>donnez deux coins opposés&#xa0;: [[x, y], [x, y]]</translation>
    </message>
</context>
<context>
    <name>exchange.has_become_shorter</name>
    <message>
        <source>it has become shorter during packing</source>
        <translation>la taille a diminué entre-temps</translation>
    </message>
</context>
<context>
    <name>exchange.held_left_out</name>
    <message>
        <source>%1 positions that only repeat the last one count as not measured; the first is in line %2</source>
        <translation>%1 positions qui ne font que répéter la dernière comptent comme non mesurées ; la première est à la ligne %2</translation>
    </message>
</context>
<context>
    <name>exchange.is_in_it_twice</name>
    <message>
        <source>it contains &apos;%1&apos; twice</source>
        <translation>&apos;%1&apos; s’y trouve deux fois</translation>
    </message>
</context>
<context>
    <name>exchange.is_no_utf8</name>
    <message>
        <source>it is not a UTF-8 text file</source>
        <translation>ce n’est pas un fichier texte UTF-8</translation>
    </message>
</context>
<context>
    <name>exchange.is_utf16</name>
    <message>
        <source>it is written in UTF-16</source>
        <translation>il est écrit en UTF-16</translation>
    </message>
</context>
<context>
    <name>exchange.is_xml</name>
    <message>
        <source>it is written in XML</source>
        <translation>il est écrit en XML</translation>
    </message>
</context>
<context>
    <name>exchange.key_is_no_text</name>
    <message>
        <source>a key is not text, or a bracket is not closed</source>
        <translation>une clé n&apos;est pas un texte, ou une parenthèse n&apos;est pas fermée</translation>
    </message>
</context>
<context>
    <name>exchange.key_is_there_twice</name>
    <message>
        <source>the key &apos;%1&apos; appears twice</source>
        <translation>la clé &apos;%1&apos; y est deux fois</translation>
    </message>
</context>
<context>
    <name>exchange.key_not_known</name>
    <message>
        <source>the key &apos;%1&apos; is not known</source>
        <translation>la clé &apos;%1&apos; n’est pas connue</translation>
    </message>
</context>
<context>
    <name>exchange.label_is_empty</name>
    <message>
        <source>the label is empty</source>
        <translation>le libellé est vide</translation>
    </message>
</context>
<context>
    <name>exchange.label_is_there</name>
    <message>
        <source>line %2 already has the label &apos;%1&apos;</source>
        <translation>le libellé &apos;%1&apos; est déjà à la ligne %2</translation>
    </message>
</context>
<context>
    <name>exchange.lacks_column</name>
    <message>
        <source>it lacks the column %1</source>
        <translation>il manque la colonne %1</translation>
    </message>
</context>
<context>
    <name>exchange.lacks_header</name>
    <message>
        <source>it lacks the expected header line</source>
        <translation>il manque la ligne d’en-tête attendue</translation>
    </message>
</context>
<context>
    <name>exchange.leave_out_confidence</name>
    <message>
        <source>leave out the least confidence</source>
        <translation>omettez la confiance minimale</translation>
    </message>
</context>
<context>
    <name>exchange.leave_out_rate</name>
    <message>
        <source>leave out the frame rate</source>
        <translation>omettez la fréquence d’images</translation>
    </message>
</context>
<context>
    <name>exchange.lens_model_not_known</name>
    <message>
        <source>the lens model &apos;%1&apos; is unknown (known models: plumb_bob, rational_polynomial, equidistant)</source>
        <translation>le modèle d’objectif &apos;%1&apos; n’est pas connu (plumb_bob, rational_polynomial, equidistant le sont)</translation>
    </message>
</context>
<context>
    <name>exchange.line_too_long</name>
    <message>
        <source>it is longer than 8 MiB</source>
        <translation>elle dépasse 8 Mio</translation>
    </message>
</context>
<context>
    <name>exchange.line_without_class</name>
    <message>
        <source>line %1 has no class for team &apos;%2&apos;</source>
        <translation>la ligne %1 n’a pas de classe pour l’équipe &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.line_without_team</name>
    <message>
        <source>line %1 has no team</source>
        <translation>la ligne %1 n’a pas d’équipe</translation>
    </message>
</context>
<context>
    <name>exchange.longer_than_a_week</name>
    <message>
        <source>it is more than a week after the first line</source>
        <translation>c’est plus d’une semaine après la première ligne</translation>
    </message>
</context>
<context>
    <name>exchange.marks_left_out</name>
    <message>
        <source>%1 positions that only mark a lost robot (such as 0, 0) count as not measured; the first is in line %2</source>
        <translation>%1 positions qui ne font que marquer un robot perdu (comme 0, 0) comptent comme non mesurées ; la première est à la ligne %2</translation>
    </message>
</context>
<context>
    <name>exchange.matrix_not_3_by_3</name>
    <message>
        <source>&apos;camera_matrix&apos; is not a 3 × 3 matrix</source>
        <translation>&apos;camera_matrix&apos; n’est pas une matrice 3 × 3</translation>
    </message>
</context>
<context>
    <name>exchange.matrix_of_other_form</name>
    <message>
        <source>&apos;camera_matrix&apos; is not of the form fx 0 cx, 0 fy cy, 0 0 1</source>
        <translation>&apos;camera_matrix&apos; n’est pas de la forme fx 0 cx, 0 fy cy, 0 0 1</translation>
    </message>
</context>
<context>
    <name>exchange.measured_otherwise</name>
    <message>
        <source>It was analysed with a different course than its task has now.</source>
        <translation>Il a été analysé sur un autre parcours que celui de son épreuve actuelle.</translation>
    </message>
</context>
<context>
    <name>exchange.mend_lines</name>
    <message>
        <source>correct these lines</source>
        <translation>corrigez ces lignes</translation>
    </message>
</context>
<context>
    <name>exchange.name_column_once</name>
    <message>
        <source>name each column once</source>
        <translation>nommez chaque colonne une fois</translation>
    </message>
</context>
<context>
    <name>exchange.named_track_has_position</name>
    <message>
        <source>track &apos;%1&apos; has %2 position</source>
        <translation>la trajectoire &apos;%1&apos; a %2 position</translation>
    </message>
</context>
<context>
    <name>exchange.named_track_has_positions</name>
    <message>
        <source>track &apos;%1&apos; has %2 positions</source>
        <translation>la trajectoire &apos;%1&apos; a %2 positions</translation>
    </message>
</context>
<context>
    <name>exchange.neither_header_nor_tum</name>
    <message>
        <source>it has no header with a time, x and y, and it is not a TUM file</source>
        <translation>il n’a pas d’en-tête avec un temps, x et y, et n’est pas non plus du TUM</translation>
    </message>
</context>
<context>
    <name>exchange.nested_too_deep</name>
    <message>
        <source>it is nested more than %1 deep</source>
        <translation>l’imbrication dépasse %1 niveaux</translation>
    </message>
</context>
<context>
    <name>exchange.no_anchors</name>
    <message>
        <source>anchors and aliases are not supported</source>
        <translation>les ancres et les alias ne sont pas compris</translation>
    </message>
</context>
<context>
    <name>exchange.no_confidence</name>
    <message>
        <source>it has no column of confidences</source>
        <translation>il n’a pas de colonne de confiance</translation>
    </message>
</context>
<context>
    <name>exchange.no_list_of_numbers</name>
    <message>
        <source>&apos;%1&apos; is not a list of numbers</source>
        <translation>&apos;%1&apos; n’est pas une liste de nombres</translation>
    </message>
</context>
<context>
    <name>exchange.no_markers</name>
    <message>
        <source>no markers follow the header</source>
        <translation>il n’y a pas de marqueurs sous l’en-tête</translation>
    </message>
</context>
<context>
    <name>exchange.no_project_inside</name>
    <message>
        <source>it contains no project</source>
        <translation>il ne contient pas de projet</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_column</name>
    <message>
        <source>this column does not exist</source>
        <translation>cette colonne n’existe pas</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_entry</name>
    <message>
        <source>it holds no camera &apos;%1&apos;, but %2</source>
        <translation>il ne contient pas de caméra « %1 », mais %2</translation>
    </message>
</context>
<context>
    <name>exchange.no_such_style</name>
    <message>
        <source>this style does not exist</source>
        <translation>ce style n’existe pas</translation>
    </message>
</context>
<context>
    <name>exchange.no_task</name>
    <message>
        <source>the file holds no task</source>
        <translation>le fichier ne contient pas d’épreuve</translation>
    </message>
</context>
<context>
    <name>exchange.no_third_axis</name>
    <message>
        <source>it has no third coordinate</source>
        <translation>il n’a pas de troisième coordonnée</translation>
    </message>
</context>
<context>
    <name>exchange.no_time_column</name>
    <message>
        <source>no column of it is called a time</source>
        <translation>aucune de ses colonnes ne porte le nom d’un temps</translation>
    </message>
</context>
<context>
    <name>exchange.no_track_has_position</name>
    <message>
        <source>none of its tracks has a position</source>
        <translation>aucune de ses trajectoires n’a de position</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_toml</name>
    <message>
        <source>it is not valid TOML (%1)</source>
        <translation>ce n&apos;est pas du TOML valide (%1)</translation>
    </message>
</context>
<context>
    <name>exchange.no_valid_yaml</name>
    <message>
        <source>it is not valid YAML (%1)</source>
        <translation>ce n&apos;est pas du YAML valide (%1)</translation>
    </message>
</context>
<context>
    <name>exchange.none_sure_enough</name>
    <message>
        <source>none of its positions has a confidence of %1</source>
        <translation>aucune de ses positions n’a une confiance de %1</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_finite_number</name>
    <message>
        <source>&apos;%1&apos; is not a finite number</source>
        <translation>&apos;%1&apos; n’est pas un nombre fini</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_list</name>
    <message>
        <source>&apos;%1&apos; is not a list in brackets</source>
        <translation>&apos;%1&apos; n’est pas une liste entre crochets</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_point</name>
    <message>
        <source>&apos;%1&apos; is not a point [x, y] in mm</source>
        <translation>&apos;%1&apos; n’est pas un point [x, y] en mm</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_time</name>
    <message>
        <source>&apos;%1&apos; is not a time</source>
        <translation>&apos;%1&apos; n’est pas un temps</translation>
    </message>
</context>
<context>
    <name>exchange.not_a_whole_number</name>
    <message>
        <source>&apos;%1&apos; is not a whole number from %2 to %3</source>
        <translation>&apos;%1&apos; n’est pas un nombre entier de %2 à %3</translation>
    </message>
</context>
<context>
    <name>exchange.not_above_zero</name>
    <message>
        <source>&apos;%1&apos; is not above zero</source>
        <translation>&apos;%1&apos; n’est pas supérieur à zéro</translation>
    </message>
</context>
<context>
    <name>exchange.not_two_corners</name>
    <message>
        <source>&apos;rectangle_mm&apos; is not two corners</source>
        <translation>&apos;rectangle_mm&apos; n’est pas deux coins</translation>
    </message>
</context>
<context>
    <name>exchange.nothing_imported</name>
    <message>
        <source>nothing was imported</source>
        <translation>rien n’a été importé</translation>
    </message>
</context>
<context>
    <name>exchange.number_in_two_ways</name>
    <message>
        <source>its numbers can be read in two ways: &apos;%1&apos; with three decimals, or as %2</source>
        <translation>ses nombres se lisent de deux façons : &apos;%1&apos; avec trois décimales, ou comme %2</translation>
    </message>
</context>
<context>
    <name>exchange.object_expected</name>
    <message>
        <source>it must be an object in braces</source>
        <translation>un objet entre accolades est attendu ici</translation>
    </message>
</context>
<context>
    <name>exchange.one_error_blank</name>
    <message>
        <source>one of its two uncertainties is blank</source>
        <translation>une de ses deux erreurs est vide</translation>
    </message>
</context>
<context>
    <name>exchange.one_place_blank</name>
    <message>
        <source>one of its two coordinates is blank</source>
        <translation>une de ses deux places est vide</translation>
    </message>
</context>
<context>
    <name>exchange.one_time_a_frame</name>
    <message>
        <source>give one time for each frame, in the order of the frames, under a name such as t_s</source>
        <translation>indiquez un temps pour chaque image, dans l’ordre des images, sous un nom tel que t_s</translation>
    </message>
</context>
<context>
    <name>exchange.order_lines</name>
    <message>
        <source>sort the lines by time, with each time only once</source>
        <translation>mettez les lignes dans l’ordre du temps, chaque temps une fois</translation>
    </message>
</context>
<context>
    <name>exchange.pack</name>
    <message>
        <source>pack &apos;%1&apos;</source>
        <translation>empaquetage de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.packing</name>
    <message>
        <source>packing %1</source>
        <translation>empaquetage de %1</translation>
    </message>
</context>
<context>
    <name>exchange.path_given_twice</name>
    <message>
        <source>the reference path has more than one shape</source>
        <translation>le tracé de référence est donné deux fois</translation>
    </message>
</context>
<context>
    <name>exchange.path_not_given</name>
    <message>
        <source>the reference path has no shape</source>
        <translation>le tracé de référence n’est donné par rien</translation>
    </message>
</context>
<context>
    <name>exchange.pixel_is</name>
    <message>
        <source>a pixel is %1</source>
        <translation>un pixel mesure %1</translation>
    </message>
</context>
<context>
    <name>exchange.place_too_far</name>
    <message>
        <source>its position is more than 100 km away</source>
        <translation>sa place est à plus de 100 km</translation>
    </message>
</context>
<context>
    <name>exchange.points_group_thousands</name>
    <message>
        <source>points separate thousands</source>
        <translation>les points séparent les milliers</translation>
    </message>
</context>
<context>
    <name>exchange.positions_are_pixels</name>
    <message>
        <source>its positions are in pixels, which are no lengths</source>
        <translation>ses positions sont en pixels, qui ne sont pas des longueurs</translation>
    </message>
</context>
<context>
    <name>exchange.positions_as_metres</name>
    <message>
        <source>its positions have no unit and were read as metres</source>
        <translation>ses positions n’ont pas d’unité et ont été lues en mètres</translation>
    </message>
</context>
<context>
    <name>exchange.quoted_cell_does_not_end</name>
    <message>
        <source>a quoted cell does not end</source>
        <translation>une cellule entre guillemets ne se ferme pas</translation>
    </message>
</context>
<context>
    <name>exchange.rate_beside_times</name>
    <message>
        <source>it has times, and no frame numbers</source>
        <translation>il a des temps, et pas de numéros d’image</translation>
    </message>
</context>
<context>
    <name>exchange.reading_line</name>
    <message>
        <source>reading line %1</source>
        <translation>lecture de la ligne %1</translation>
    </message>
</context>
<context>
    <name>exchange.roster</name>
    <message>
        <source>roster &apos;%1&apos;</source>
        <translation>liste de classe &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.roster_is_empty</name>
    <message>
        <source>it has no team</source>
        <translation>il n’a pas d’équipe</translation>
    </message>
</context>
<context>
    <name>exchange.row_without_time</name>
    <message>
        <source>line %1 was left out, because it has no time</source>
        <translation>la ligne %1 a été omise, car elle n’a pas de temps</translation>
    </message>
</context>
<context>
    <name>exchange.rows_without_time</name>
    <message>
        <source>%1 lines were left out, because they have no time; the first is line %2</source>
        <translation>%1 lignes ont été omises, car elles n’ont pas de temps ; la première est la ligne %2</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_csv_utf8</name>
    <message>
        <source>save it again as &quot;CSV UTF-8&quot; or as a UTF-8 text</source>
        <translation>enregistrez-le à nouveau en &quot;CSV UTF-8&quot; ou en texte UTF-8</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_utf8</name>
    <message>
        <source>save it again as UTF-8 text</source>
        <translation>enregistrez-le à nouveau en texte UTF-8</translation>
    </message>
</context>
<context>
    <name>exchange.save_as_yaml</name>
    <message>
        <source>save the calibration as YAML or JSON</source>
        <translation>enregistrez l’étalonnage en YAML ou en JSON</translation>
    </message>
</context>
<context>
    <name>exchange.save_with_commas</name>
    <message>
        <source>save it with commas</source>
        <translation>enregistrez-le avec des virgules</translation>
    </message>
</context>
<context>
    <name>exchange.save_with_commas_and_points</name>
    <message>
        <source>save it with commas, and with a point in its numbers</source>
        <translation>enregistrez-le avec des virgules, et un point dans les nombres</translation>
    </message>
</context>
<context>
    <name>exchange.separated_by_semicolons</name>
    <message>
        <source>its columns are separated by semicolons</source>
        <translation>ses colonnes sont séparées par des points-virgules</translation>
    </message>
</context>
<context>
    <name>exchange.several_cameras</name>
    <message>
        <source>it holds several cameras: %1</source>
        <translation>il contient plusieurs caméras : %1</translation>
    </message>
</context>
<context>
    <name>exchange.several_documents</name>
    <message>
        <source>it holds more than one document</source>
        <translation>il contient plus d’un document</translation>
    </message>
</context>
<context>
    <name>exchange.sides_exchanged</name>
    <message>
        <source>its width and height are exchanged: the image centre (%1, %2) is that of %4 × %3 pixels, not %3 × %4</source>
        <translation>la largeur et la hauteur sont échangées : le centre de l&apos;image (%1, %2) est celui de %4 × %3 pixels, pas de %3 × %4</translation>
    </message>
</context>
<context>
    <name>exchange.sigma_not_above_zero</name>
    <message>
        <source>its uncertainty &apos;%1&apos; is not above zero</source>
        <translation>son incertitude &apos;%1&apos; n’est pas supérieure à zéro</translation>
    </message>
</context>
<context>
    <name>exchange.sigma_or_blank</name>
    <message>
        <source>give the standard deviation of each position, or leave these cells blank</source>
        <translation>indiquez l’écart type de chaque position, ou laissez ces cellules vides</translation>
    </message>
</context>
<context>
    <name>exchange.slalom_without_length</name>
    <message>
        <source>the slalom ends where it starts</source>
        <translation>le slalom finit où il commence</translation>
    </message>
</context>
<context>
    <name>exchange.stamp_left_out</name>
    <message>
        <source>line %1 was left out, because its time repeats or is out of order</source>
        <translation>la ligne %1 a été omise, car son temps se répète ou n’est pas dans l’ordre</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_left_out</name>
    <message>
        <source>%1 lines were left out, because their times repeat or are out of order; the first is line %2</source>
        <translation>%1 lignes ont été omises, car leurs temps se répètent ou ne sont pas dans l’ordre ; la première est la ligne %2</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_shared</name>
    <message>
        <source>its times are so coarse that %1 lines share theirs with the line before</source>
        <translation>ses temps sont si grossiers que %1 lignes partagent celui de la ligne précédente</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_spread</name>
    <message>
        <source>its times are rounded to %1; the lines were spread evenly, %2 frames/s</source>
        <translation>ses temps sont arrondis à %1 ; les lignes ont été réparties régulièrement, %2 images/s</translation>
    </message>
</context>
<context>
    <name>exchange.stamps_spread_with_gaps</name>
    <message>
        <source>its times are rounded to %1; the lines were spread evenly, with gaps</source>
        <translation>ses temps sont arrondis à %1 ; les lignes ont été réparties régulièrement, avec des lacunes</translation>
    </message>
</context>
<context>
    <name>exchange.team_named_again</name>
    <message>
        <source>line %1 names team &apos;%2&apos; again, as line %3</source>
        <translation>la ligne %1 nomme encore l’équipe &apos;%2&apos;, comme la ligne %3</translation>
    </message>
</context>
<context>
    <name>exchange.time_goes_back</name>
    <message>
        <source>its time is earlier than in the line before</source>
        <translation>son temps précède celui de la ligne précédente</translation>
    </message>
</context>
<context>
    <name>exchange.time_of_no_age</name>
    <message>
        <source>its time is more than a century from 1970</source>
        <translation>son temps est à plus d’un siècle de 1970</translation>
    </message>
</context>
<context>
    <name>exchange.time_repeated</name>
    <message>
        <source>its time is the same as in the line before</source>
        <translation>son temps est celui de la ligne précédente</translation>
    </message>
</context>
<context>
    <name>exchange.time_steps_too_long</name>
    <message>
        <source>if its times are seconds, the rows are %1 apart and the run is %2 long</source>
        <translation>si ses temps sont des secondes, les lignes sont espacées de %1 et le parcours dure %2</translation>
    </message>
</context>
<context>
    <name>exchange.time_steps_too_short</name>
    <message>
        <source>its times have no unit, and as seconds the rows would be %1 apart</source>
        <translation>ses temps n’ont pas d’unité, et en secondes les lignes seraient espacées de %1</translation>
    </message>
</context>
<context>
    <name>exchange.timecode_without_rate</name>
    <message>
        <source>the last part of its times counts frames, up to %1 a second</source>
        <translation>la dernière partie de ses temps compte des images, jusqu’à %1 par seconde</translation>
    </message>
</context>
<context>
    <name>exchange.times_by_rate</name>
    <message>
        <source>all its times are the same; the lines were spread at %1 frames/s</source>
        <translation>tous ses temps sont identiques ; les lignes ont été réparties à %1 images/s</translation>
    </message>
</context>
<context>
    <name>exchange.times_in_days</name>
    <message>
        <source>times in days, as spreadsheets write them</source>
        <translation>temps en jours, comme les écrivent les tableurs</translation>
    </message>
</context>
<context>
    <name>exchange.times_in_two_ways</name>
    <message>
        <source>its times can be read in two ways: &apos;%1&apos; with three decimals, or without</source>
        <translation>ses temps se lisent de deux façons : &apos;%1&apos; avec trois décimales, ou sans</translation>
    </message>
</context>
<context>
    <name>exchange.times_since_1970</name>
    <message>
        <source>times in %1 since 1970</source>
        <translation>temps en %1 depuis 1970</translation>
    </message>
</context>
<context>
    <name>exchange.too_fast_as_said</name>
    <message>
        <source>in the units that it gives, the robot would drive at %1</source>
        <translation>dans les unités qu’il donne, le robot roulerait à %1</translation>
    </message>
</context>
<context>
    <name>exchange.too_fast_in_metres</name>
    <message>
        <source>its positions have no unit, and in metres the robot would drive at %1</source>
        <translation>ses positions n’ont pas d’unité, et en mètres le robot roulerait à %1</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_files</name>
    <message>
        <source>it has too many files</source>
        <translation>il a trop de fichiers</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_places</name>
    <message>
        <source>the file has more than 1.5 million positions</source>
        <translation>le fichier a plus de 1,5 million de positions</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_tracks</name>
    <message>
        <source>the file has more than 1000 tracks</source>
        <translation>le fichier a plus de 1000 trajectoires</translation>
    </message>
</context>
<context>
    <name>exchange.too_many_values</name>
    <message>
        <source>it holds more than %1 values</source>
        <translation>il contient plus de %1 valeurs</translation>
    </message>
</context>
<context>
    <name>exchange.too_wide_in_metres</name>
    <message>
        <source>its positions have no unit, and in metres the floor would be %1 wide</source>
        <translation>ses positions n’ont pas d’unité, et en mètres le sol ferait %1 de large</translation>
    </message>
</context>
<context>
    <name>exchange.track_has_position</name>
    <message>
        <source>the track has %1 position</source>
        <translation>la trajectoire a %1 position</translation>
    </message>
</context>
<context>
    <name>exchange.track_has_positions</name>
    <message>
        <source>the track has %1 positions</source>
        <translation>la trajectoire a %1 positions</translation>
    </message>
</context>
<context>
    <name>exchange.tum_entries</name>
    <message>
        <source>it has %1 entries instead of the 8 of TUM</source>
        <translation>il y a %1 entrées au lieu des 8 de TUM</translation>
    </message>
</context>
<context>
    <name>exchange.tum_entry</name>
    <message>
        <source>it has %1 entry instead of the 8 of TUM</source>
        <translation>il y a %1 entrée au lieu des 8 de TUM</translation>
    </message>
</context>
<context>
    <name>exchange.twins_left_out</name>
    <message>
        <source>%1 lines were left out, because they repeat the line before</source>
        <translation>%1 lignes ont été omises, car elles répètent la ligne précédente</translation>
    </message>
</context>
<context>
    <name>exchange.unit_not_known</name>
    <message>
        <source>its column &apos;%1&apos; is in a unit that is not known</source>
        <translation>sa colonne &apos;%1&apos; est dans une unité inconnue</translation>
    </message>
</context>
<context>
    <name>exchange.unpack</name>
    <message>
        <source>unpack &apos;%1&apos;</source>
        <translation>dépaquetage de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.unpack_into</name>
    <message>
        <source>unpack into &apos;%1&apos;</source>
        <translation>dépaquetage dans &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>exchange.unpacking</name>
    <message>
        <source>unpacking</source>
        <translation>dépaquetage</translation>
    </message>
</context>
<context>
    <name>exchange.unpacks_too_large</name>
    <message>
        <source>it unpacks to more than a hundred times its size</source>
        <translation>une fois décompressé, il dépasse cent fois sa taille</translation>
    </message>
</context>
<context>
    <name>exchange.unset_stamps</name>
    <message>
        <source>lines left out because their time is 0: %1</source>
        <translation>lignes omises car leur temps est 0 : %1</translation>
    </message>
</context>
<context>
    <name>exchange.unsure_left_out</name>
    <message>
        <source>%1 positions with a confidence below %2 count as not measured; the first is in line %3</source>
        <translation>%1 positions d’une confiance inférieure à %2 comptent comme non mesurées ; la première est à la ligne %3</translation>
    </message>
</context>
<context>
    <name>exchange.use_calibration_file</name>
    <message>
        <source>use a calibration file as ROS, OpenCV, Kalibr, anipose or PhotonVision writes it</source>
        <translation>utilisez un fichier d&apos;étalonnage tel que l&apos;écrivent ROS, OpenCV, Kalibr, anipose ou PhotonVision</translation>
    </message>
</context>
<context>
    <name>exchange.use_keys</name>
    <message>
        <source>use %1</source>
        <translation>utilisez %1</translation>
    </message>
</context>
<context>
    <name>exchange.wait_for_writers</name>
    <message>
        <source>wait until no program writes to it, and try again</source>
        <translation>attendez que personne n’y écrive, et réessayez</translation>
    </message>
</context>
<context>
    <name>exchange.write_class_and_team</name>
    <message>
        <source>write a line with class and team below the header</source>
        <translation>écrivez sous l’en-tête une ligne avec classe et équipe</translation>
    </message>
</context>
<context>
    <name>exchange.write_decimal_point</name>
    <message>
        <source>write them with a decimal point</source>
        <translation>écrivez-les avec un point décimal</translation>
    </message>
</context>
<context>
    <name>exchange.write_digits</name>
    <message>
        <source>write it with digits, like 12.5</source>
        <translation>écrivez-le avec des chiffres, comme 12.5</translation>
    </message>
</context>
<context>
    <name>exchange.write_digits_or_blank</name>
    <message>
        <source>write it with digits, like 12.5, or leave the cell blank</source>
        <translation>écrivez-le avec des chiffres, comme 12.5, ou laissez la place vide</translation>
    </message>
</context>
<context>
    <name>exchange.write_finer_times</name>
    <message>
        <source>write the times with more digits, or give the frame rate of an even series</source>
        <translation>écrivez les temps avec plus de chiffres, ou indiquez la fréquence d’images d’une série régulière</translation>
    </message>
</context>
<context>
    <name>exchange.write_line_for_marker</name>
    <message>
        <source>write one line for each marker</source>
        <translation>écrivez une ligne par marqueur</translation>
    </message>
</context>
<context>
    <name>exchange.write_object_with</name>
    <message>
        <source>write one with %1</source>
        <translation>écrivez-en un avec %1</translation>
    </message>
</context>
<context>
    <name>exchange.write_task_as_shown</name>
    <message>
        <source>write the task as odograph task list --json shows one</source>
        <translation>créez l’épreuve dans Banc, ou écrivez le fichier comme le montre le manuel</translation>
    </message>
</context>
<context>
    <name>exchange.write_tum_or_header</name>
    <message>
        <source>write %1, or begin the file with the line %2</source>
        <translation>écrivez %1, ou commencez le fichier par la ligne %2</translation>
    </message>
</context>
<context>
    <name>exchange.write_value_for_each</name>
    <message>
        <source>write one value for each of %1</source>
        <translation>écrivez une valeur pour chacun de %1</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_number_of_cells</name>
    <message>
        <source>it has %1 cells instead of %2</source>
        <translation>il a %1 cellules au lieu de %2</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_number_of_numbers</name>
    <message>
        <source>&apos;%1&apos; has %2 numbers instead of %3 × %4</source>
        <translation>&apos;%1&apos; a %2 nombres au lieu de %3 × %4</translation>
    </message>
</context>
<context>
    <name>exchange.wrong_poles</name>
    <message>
        <source>&apos;poles&apos; is not a whole number from 1 to 100</source>
        <translation>&apos;poles&apos; n’est pas un nombre entier de 1 à 100</translation>
    </message>
</context>
<context>
    <name>exchange.zone_given_twice</name>
    <message>
        <source>the zone has more than one shape</source>
        <translation>la zone est donnée deux fois</translation>
    </message>
</context>
<context>
    <name>exchange.zone_not_given</name>
    <message>
        <source>the zone has no shape</source>
        <translation>la zone n’est donnée par rien</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_looked_at</name>
    <message>
        <source>it cannot be accessed (%1)</source>
        <translation>accès impossible (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_read</name>
    <message>
        <source>it cannot be read (%1)</source>
        <translation>lecture impossible (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_be_written</name>
    <message>
        <source>it cannot be written (%1)</source>
        <translation>écriture impossible (%1)</translation>
    </message>
</context>
<context>
    <name>files.cannot_write</name>
    <message>
        <source>cannot write &apos;%1&apos;</source>
        <translation>impossible d’écrire &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>files.check_file_is_there</name>
    <message>
        <source>check that the file exists and that you may read it</source>
        <translation>vérifiez que le fichier est là et peut être lu</translation>
    </message>
</context>
<context>
    <name>files.check_its_folder</name>
    <message>
        <source>check the free space and the permissions of its folder</source>
        <translation>vérifiez la place libre et les droits de son dossier</translation>
    </message>
</context>
<context>
    <name>files.check_may_be_read</name>
    <message>
        <source>check that you may read the file</source>
        <translation>vérifiez que vous pouvez lire le fichier</translation>
    </message>
</context>
<context>
    <name>files.check_name</name>
    <message>
        <source>check the name and the folder</source>
        <translation>vérifiez le nom et le dossier</translation>
    </message>
</context>
<context>
    <name>files.choose_another_file</name>
    <message>
        <source>choose another file</source>
        <translation>choisissez un autre fichier</translation>
    </message>
</context>
<context>
    <name>files.choose_another_folder</name>
    <message>
        <source>choose another folder</source>
        <translation>choisissez un autre dossier</translation>
    </message>
</context>
<context>
    <name>files.choose_another_name</name>
    <message>
        <source>choose another name</source>
        <translation>choisissez un autre nom</translation>
    </message>
</context>
<context>
    <name>files.choose_folder_with_room</name>
    <message>
        <source>choose a folder that you may write to and that has free space</source>
        <translation>choisissez un dossier où vous pouvez écrire et qui a de la place</translation>
    </message>
</context>
<context>
    <name>files.choose_name_or_folder</name>
    <message>
        <source>choose another name or folder</source>
        <translation>choisissez un autre nom ou un autre dossier</translation>
    </message>
</context>
<context>
    <name>files.choose_shorter_name</name>
    <message>
        <source>choose a shorter name</source>
        <translation>choisissez un nom plus court</translation>
    </message>
</context>
<context>
    <name>files.choose_writable_folder</name>
    <message>
        <source>choose a folder that you may write to</source>
        <translation>choisissez un dossier où vous pouvez écrire</translation>
    </message>
</context>
<context>
    <name>files.disk_is_full</name>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
</context>
<context>
    <name>files.file_is_empty</name>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
</context>
<context>
    <name>files.folder_cannot_be_used</name>
    <message>
        <source>its folder cannot be used (%1)</source>
        <translation>son dossier est inutilisable (%1)</translation>
    </message>
</context>
<context>
    <name>files.folder_not_writable</name>
    <message>
        <source>the folder &apos;%1&apos; cannot be written to (%2)</source>
        <translation>le dossier &apos;%1&apos; ne peut pas être modifié (%2)</translation>
    </message>
</context>
<context>
    <name>files.has_no_name</name>
    <message>
        <source>it has no name</source>
        <translation>il n’a pas de nom</translation>
    </message>
</context>
<context>
    <name>files.is_a_database</name>
    <message>
        <source>it is a database</source>
        <translation>c’est une base de données</translation>
    </message>
</context>
<context>
    <name>files.is_another_project</name>
    <message>
        <source>it is another project</source>
        <translation>c’est un autre projet</translation>
    </message>
</context>
<context>
    <name>files.is_beside_project</name>
    <message>
        <source>it is the log, the lock or a backup of a project</source>
        <translation>c’est le journal, le verrou ou une copie de sauvegarde d’un projet</translation>
    </message>
</context>
<context>
    <name>files.is_in_media_folder</name>
    <message>
        <source>it is in the media folder of project &apos;%1&apos;</source>
        <translation>il est dans le dossier des médias du projet &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>files.is_in_some_media_folder</name>
    <message>
        <source>it is in a media folder beside a project</source>
        <translation>il se trouve dans un dossier de médias à côté d’un projet</translation>
    </message>
</context>
<context>
    <name>files.is_input</name>
    <message>
        <source>it is an input of the same command</source>
        <translation>c’est une entrée du même appel</translation>
    </message>
</context>
<context>
    <name>files.is_of_another_kind</name>
    <message>
        <source>a file of another kind has that name</source>
        <translation>un fichier d’un autre type porte ce nom</translation>
    </message>
</context>
<context>
    <name>files.is_open_project</name>
    <message>
        <source>it is a project that is open here</source>
        <translation>c&apos;est un projet qui est ouvert ici</translation>
    </message>
</context>
<context>
    <name>files.is_temporary_name</name>
    <message>
        <source>Odograph uses such names for temporary files</source>
        <translation>Odograph utilise de tels noms pour ses fichiers temporaires</translation>
    </message>
</context>
<context>
    <name>files.is_the_project</name>
    <message>
        <source>it is the project itself</source>
        <translation>c’est le projet lui-même</translation>
    </message>
</context>
<context>
    <name>files.is_there_already</name>
    <message>
        <source>it already exists</source>
        <translation>existe déjà</translation>
    </message>
</context>
<context>
    <name>files.log_left_beside</name>
    <message>
        <source>its folder has &apos;%1&apos;, the log or journal of another file of this name</source>
        <translation>son dossier contient « %1 », le journal d’un autre fichier de ce nom</translation>
    </message>
</context>
<context>
    <name>files.make_folder_first</name>
    <message>
        <source>create the folder first, or choose another one</source>
        <translation>créez d’abord le dossier, ou choisissez-en un autre</translation>
    </message>
</context>
<context>
    <name>files.make_room</name>
    <message>
        <source>free some disk space and try again</source>
        <translation>libérez de la place sur le disque et réessayez</translation>
    </message>
</context>
<context>
    <name>files.move_log_away</name>
    <message>
        <source>choose another name, or move &apos;%1&apos; to another folder first</source>
        <translation>choisissez un autre nom, ou déplacez d’abord « %1 » dans un autre dossier</translation>
    </message>
</context>
<context>
    <name>files.name_a_file</name>
    <message>
        <source>give a file name</source>
        <translation>nommez un fichier</translation>
    </message>
</context>
<context>
    <name>files.name_too_long</name>
    <message>
        <source>its name is too long</source>
        <translation>son nom est trop long</translation>
    </message>
</context>
<context>
    <name>files.names_a_project</name>
    <message>
        <source>only projects have a name ending in .odo</source>
        <translation>un nom qui se termine par .odo est réservé à un projet</translation>
    </message>
</context>
<context>
    <name>files.no_such_file</name>
    <message>
        <source>the file does not exist</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
</context>
<context>
    <name>files.no_such_folder</name>
    <message>
        <source>folder &apos;%1&apos; does not exist</source>
        <translation>il n’y a pas de dossier &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>files.replace_by_force</name>
    <message>
        <source>choose another name, or replace it with --force</source>
        <translation>choisissez un autre nom, ou supprimez d’abord le fichier</translation>
    </message>
</context>
<context>
    <name>files.unreadable</name>
    <message>
        <source>it cannot be read</source>
        <translation>lecture impossible</translation>
    </message>
</context>
<context>
    <name>geometry.add_points</name>
    <message>
        <source>add points</source>
        <translation>ajoutez des points</translation>
    </message>
</context>
<context>
    <name>geometry.at_one_place</name>
    <message>
        <source>%1 have the same position</source>
        <translation>%1 sont au même endroit</translation>
    </message>
</context>
<context>
    <name>geometry.at_one_place_in_picture</name>
    <message>
        <source>%1 have the same position in the image</source>
        <translation>%1 sont au même endroit de l’image</translation>
    </message>
</context>
<context>
    <name>geometry.beyond_horizon</name>
    <message>
        <source>%1 would be beyond the horizon</source>
        <translation>%1 serait au-delà de l’horizon</translation>
    </message>
</context>
<context>
    <name>geometry.bow_tie</name>
    <message>
        <source>the order of the points crosses over like a bow tie</source>
        <translation>l’ordre des points se croise comme un nœud papillon</translation>
    </message>
</context>
<context>
    <name>geometry.calibrate_again</name>
    <message>
        <source>calibrate the camera again, or import another file</source>
        <translation>étalonnez à nouveau la caméra, ou importez un autre fichier</translation>
    </message>
</context>
<context>
    <name>geometry.check_points</name>
    <message>
        <source>check which point is which</source>
        <translation>vérifiez quel point est lequel</translation>
    </message>
</context>
<context>
    <name>geometry.coordinate_not_finite</name>
    <message>
        <source>a coordinate of %1 is not a finite number</source>
        <translation>une coordonnée de %1 n’est pas un nombre fini</translation>
    </message>
</context>
<context>
    <name>geometry.correct_it</name>
    <message>
        <source>correct it</source>
        <translation>corrigez-le</translation>
    </message>
</context>
<context>
    <name>geometry.correct_one</name>
    <message>
        <source>correct one of them</source>
        <translation>corrigez l’un d’eux</translation>
    </message>
</context>
<context>
    <name>geometry.empty_chain</name>
    <message>
        <source>the chain has no links</source>
        <translation>la chaîne n’a pas de maillons</translation>
    </message>
</context>
<context>
    <name>geometry.focal_not_positive</name>
    <message>
        <source>the focal length %1 is not positive</source>
        <translation>la distance focale %1 n’est pas positive</translation>
    </message>
</context>
<context>
    <name>geometry.four_points_needed</name>
    <message>
        <source>four points are needed, %1 given</source>
        <translation>il faut quatre points, %1 donnés</translation>
    </message>
</context>
<context>
    <name>geometry.give_one_link</name>
    <message>
        <source>give at least one</source>
        <translation>donnez-en au moins un</translation>
    </message>
</context>
<context>
    <name>geometry.intrinsics_unusable</name>
    <message>
        <source>these intrinsics cannot be used</source>
        <translation>ces paramètres intrinsèques sont inutilisables</translation>
    </message>
</context>
<context>
    <name>geometry.no_homography</name>
    <message>
        <source>no homography</source>
        <translation>pas d’homographie</translation>
    </message>
</context>
<context>
    <name>geometry.on_one_line</name>
    <message>
        <source>%1 lie on one line</source>
        <translation>%1 sont alignés</translation>
    </message>
</context>
<context>
    <name>geometry.on_one_line_in_picture</name>
    <message>
        <source>%1 lie on one line in the image</source>
        <translation>%1 sont alignés dans l’image</translation>
    </message>
</context>
<context>
    <name>geometry.point</name>
    <message>
        <source>point %1</source>
        <translation>point %1</translation>
    </message>
</context>
<context>
    <name>geometry.points_do_not_tell</name>
    <message>
        <source>the points do not determine it</source>
        <translation>les points ne la déterminent pas</translation>
    </message>
</context>
<context>
    <name>geometry.singular_link</name>
    <message>
        <source>link %1 of %2 of the chain is singular</source>
        <translation>le maillon %1 sur %2 de la chaîne est singulier</translation>
    </message>
</context>
<context>
    <name>geometry.size_not_positive</name>
    <message>
        <source>the image size %1 is not positive</source>
        <translation>la taille d’image %1 n’est pas positive</translation>
    </message>
</context>
<context>
    <name>geometry.spread_points</name>
    <message>
        <source>spread the points</source>
        <translation>écartez les points</translation>
    </message>
</context>
<context>
    <name>geometry.use_four_points</name>
    <message>
        <source>use four points of which no three are in line</source>
        <translation>utilisez quatre points dont trois ne sont jamais alignés</translation>
    </message>
</context>
<context>
    <name>geometry.use_four_points_in_it</name>
    <message>
        <source>use four points in it of which no three are in line</source>
        <translation>utilisez-y quatre points dont trois ne sont jamais alignés</translation>
    </message>
</context>
<context>
    <name>geometry.value_not_finite</name>
    <message>
        <source>one of the values is not a finite number</source>
        <translation>une des valeurs n’est pas un nombre fini</translation>
    </message>
</context>
<context>
    <name>geometry.wrong_coefficients</name>
    <message>
        <source>this lens model does not take %1 distortion coefficients</source>
        <translation>%1 coefficients de distorsion ne vont pas avec ce modèle d’objectif</translation>
    </message>
</context>
<context>
    <name>geometry.wrong_covariance_size</name>
    <message>
        <source>the covariance has the wrong size</source>
        <translation>la covariance n’a pas la bonne taille</translation>
    </message>
</context>
<context>
    <name>odo::AccuracyDialog</name>
    <message>
        <source>may hang &amp;over the floor</source>
        <translation>peut être au-dess&amp;us du sol</translation>
    </message>
    <message>
        <source>&amp;Plan a camera</source>
        <translation>&amp;Prévoir une caméra</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>Find &amp;best position</source>
        <translation>&amp;Meilleure place</translation>
    </message>
    <message>
        <source>Expected accuracy</source>
        <translation>Précision attendue</translation>
    </message>
    <message>
        <source>Expected accuracy in words</source>
        <translation>Précision attendue, en mots</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Ce qui ne va pas</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Cameras included</source>
        <translation>Caméras prises en compte</translation>
    </message>
    <message>
        <source>All ticked cameras (joint)</source>
        <translation>Toutes les caméras cochées ensemble</translation>
    </message>
    <message>
        <source>The chosen camera alone</source>
        <translation>La caméra choisie seule</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Afficher</translation>
    </message>
    <message>
        <source>Height of the robo&amp;t</source>
        <translation>&amp;Hauteur du robot</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>On a ceiling, for example; a tripod would be in the robots&apos; way</source>
        <translation>Comme sous un plafond&#xa0;; un trépied gênerait les robots</translation>
    </message>
    <message>
        <source>Moves the camera to where it, together with the other ticked cameras, minimises the largest uncertainty on the floor</source>
        <translation>Place la caméra là où, avec les autres caméras cochées, l’endroit du sol le moins bien connu l’est le mieux possible</translation>
    </message>
    <message>
        <source>Margin beyond the &amp;markers</source>
        <translation>Mar&amp;ge autour des marqueurs</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>Caméra prévue</translation>
    </message>
    <message>
        <source>%1, registered %2</source>
        <translation>%1, localisée le %2</translation>
    </message>
    <message>
        <source>Planned %1</source>
        <translation>Prévue %1</translation>
    </message>
    <message>
        <source>%1: %2; %3.</source>
        <translation>%1&#xa0;: %2&#xa0;; %3.</translation>
    </message>
    <message>
        <source>Searching for the best position…</source>
        <translation>Recherche de la meilleure place…</translation>
    </message>
</context>
<context>
    <name>odo::BackupsDialog</name>
    <message>
        <source>What restoring would change</source>
        <translation>Ce que changerait la restauration</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>&amp;Back up now</source>
        <translation>Sauvegarder &amp;maintenant</translation>
    </message>
    <message>
        <source>&amp;Restore this backup</source>
        <translation>&amp;Restaurer cette copie</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Copies de sauvegarde</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>Dossier des copies</translation>
    </message>
    <message>
        <source>Backups are in %1. They contain everything except the videos.</source>
        <translation>Les copies sont dans %1. Elles contiennent tout sauf les vidéos.</translation>
    </message>
    <message numerus="yes">
        <source>One is made each day on which you open the project, and kept for %n day(s).</source>
        <translation>
            <numerusform>Une copie est faite chaque jour où vous ouvrez le projet, et conservée %n jour.</numerusform>
            <numerusform>Une copie est faite chaque jour où vous ouvrez le projet, et conservée %n jours.</numerusform>
        </translation>
    </message>
    <message>
        <source>Daily backups are switched off in the preferences.</source>
        <translation>Les copies quotidiennes sont désactivées dans les préférences.</translation>
    </message>
    <message>
        <source>&amp;Open folder</source>
        <translation>&amp;Ouvrir le dossier</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Changes since this backup</source>
        <translation>Modifications depuis cette copie</translation>
    </message>
    <message>
        <source>%1, before an update</source>
        <translation>%1, avant une mise à jour</translation>
    </message>
    <message>
        <source>No backup yet.</source>
        <translation>Pas encore de copie.</translation>
    </message>
    <message>
        <source>Reading the backup…</source>
        <translation>Lecture de la copie…</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) in this backup.</source>
        <translation>
            <numerusform>%n essai dans cette copie.</numerusform>
            <numerusform>%n essais dans cette copie.</numerusform>
        </translation>
    </message>
    <message>
        <source>Without: %1</source>
        <translation>Sans : %1</translation>
    </message>
    <message>
        <source>With, though deleted since: %1</source>
        <translation>Avec, supprimés depuis : %1</translation>
    </message>
    <message numerus="yes">
        <source>%n of its video(s) no longer exist.</source>
        <translation>
            <numerusform>%n de ses vidéos n’existe plus.</numerusform>
            <numerusform>%n de ses vidéos n’existent plus.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring it discards no changes.</source>
        <translation>La restaurer n’annule aucune modification.</translation>
    </message>
    <message numerus="yes">
        <source>Restoring it discards %n change(s) made since:</source>
        <translation>
            <numerusform>La restaurer annule %n modification faite depuis :</numerusform>
            <numerusform>La restaurer annule %n modifications faites depuis :</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It brings back %n change(s).</source>
        <translation>
            <numerusform>Elle rétablit %n modification.</numerusform>
            <numerusform>Elle rétablit %n modifications.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::Badge</name>
    <message>
        <source>not registered</source>
        <translation>non localisée</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>a bougé de %1</translation>
    </message>
    <message>
        <source>marker moved %1</source>
        <translation>marqueur déplacé de %1</translation>
    </message>
    <message>
        <source>markers not found</source>
        <translation>marqueurs introuvables</translation>
    </message>
</context>
<context>
    <name>odo::BoardCanvas</name>
    <message>
        <source>Image of the board</source>
        <translation>Photo de la mire</translation>
    </message>
    <message>
        <source>residuals, longest %1 px</source>
        <translation>résidus, le plus long&#xa0;: %1 px</translation>
    </message>
</context>
<context>
    <name>odo::BoardImagesPage</name>
    <message>
        <source>Move it to the left of the image</source>
        <translation>Déplacez-la vers la gauche de l’image</translation>
    </message>
    <message>
        <source>Move it to the right of the image</source>
        <translation>Déplacez-la vers la droite de l’image</translation>
    </message>
    <message>
        <source>Move it up</source>
        <translation>Déplacez-la vers le haut</translation>
    </message>
    <message>
        <source>Move it down</source>
        <translation>Déplacez-la vers le bas</translation>
    </message>
    <message>
        <source>Closer to the camera</source>
        <translation>Plus près de la caméra</translation>
    </message>
    <message>
        <source>Farther from the camera</source>
        <translation>Plus loin de la caméra</translation>
    </message>
    <message>
        <source>Tilt it: the left side away from the camera</source>
        <translation>Inclinez-la&#xa0;: le côté gauche à l’opposé de la caméra</translation>
    </message>
    <message>
        <source>Tilt it: the right side away from the camera</source>
        <translation>Inclinez-la&#xa0;: le côté droit à l’opposé de la caméra</translation>
    </message>
    <message>
        <source>Tilt it: the upper side away from the camera</source>
        <translation>Inclinez-la&#xa0;: le haut à l’opposé de la caméra</translation>
    </message>
    <message>
        <source>Tilt it: the lower side away from the camera</source>
        <translation>Inclinez-la&#xa0;: le bas à l’opposé de la caméra</translation>
    </message>
    <message>
        <source>Hold it still</source>
        <translation>Tenez-la immobile</translation>
    </message>
    <message>
        <source>&amp;Take an image now</source>
        <translation>&amp;Prendre une photo</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Que faire</translation>
    </message>
    <message>
        <source>No image from the camera</source>
        <translation>Aucune image de la caméra</translation>
    </message>
    <message>
        <source>Rejected images</source>
        <translation>Photos non prises en compte</translation>
    </message>
    <message>
        <source>Coverage of the images</source>
        <translation>Ce que couvrent les photos</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>Non prises en compte</translation>
    </message>
    <message>
        <source>Waiting for the camera…</source>
        <translation>En attente de la caméra…</translation>
    </message>
    <message>
        <source>Detecting the board…</source>
        <translation>Recherche de la mire…</translation>
    </message>
    <message>
        <source>Hold the board before the camera</source>
        <translation>Tenez la mire devant la caméra</translation>
    </message>
    <message>
        <source>Detecting the board</source>
        <translation>Recherche de la mire</translation>
    </message>
    <message>
        <source>Odograph takes an image whenever the board is still, sharp and in a new position.</source>
        <translation>Une photo se prend d’elle-même chaque fois que la mire est immobile, nette et à une nouvelle place.</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>Prise</translation>
    </message>
    <message>
        <source>Now the dashed outline shows where the board would help most.</source>
        <translation>Le contour en tirets montre maintenant où la mire serait le plus utile.</translation>
    </message>
    <message>
        <source>%1 to go</source>
        <translation>encore %1</translation>
    </message>
    <message>
        <source>No image accepted</source>
        <translation>Aucune photo ne compte</translation>
    </message>
    <message>
        <source>See the reasons on the right. Drop other images here to add them.</source>
        <translation>Les raisons sont indiquées à droite. Ajoutez-en d’autres en les déposant ici.</translation>
    </message>
    <message>
        <source>All images checked</source>
        <translation>Toutes examinées</translation>
    </message>
    <message>
        <source>They are enough.</source>
        <translation>C’est assez.</translation>
    </message>
    <message>
        <source>Drop more images here; the bars show what is missing.</source>
        <translation>D’autres photos peuvent être déposées ici&#xa0;; les barres montrent ce qui manque.</translation>
    </message>
</context>
<context>
    <name>odo::BoardSearchWorker</name>
    <message>
        <source>image %1</source>
        <translation>photo %1</translation>
    </message>
    <message>
        <source>none of its images shows a board that is still, sharp and in a new position</source>
        <translation>aucune de ses images ne montre une mire immobile, nette et nouvelle</translation>
    </message>
    <message>
        <source>it cannot be read any more</source>
        <translation>elle n’est plus lisible</translation>
    </message>
</context>
<context>
    <name>odo::BoxCanvas</name>
    <message>
        <source>Video frame; arrow keys move the box round the robot, Shift + arrow keys resize it</source>
        <translation>Image&#xa0;; les flèches déplacent le cadre autour du robot, avec Maj elles changent sa taille</translation>
    </message>
</context>
<context>
    <name>odo::CalibrationResultPage</name>
    <message>
        <source>ordinary</source>
        <translation>ordinaire</translation>
    </message>
    <message>
        <source>wide (rational)</source>
        <translation>grand-angle (rationnel)</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>fisheye</translation>
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
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Calcul</translation>
    </message>
    <message>
        <source>Automatic choice of the lens model</source>
        <translation>Modèle choisi automatiquement</translation>
    </message>
    <message>
        <source>Ordinary lens</source>
        <translation>Objectif ordinaire</translation>
    </message>
    <message>
        <source>Wide lens (rational model)</source>
        <translation>Grand-angle (modèle rationnel)</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>Fisheye</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>Modèle d’objectif</translation>
    </message>
    <message>
        <source>Select a bar to see its image.</source>
        <translation>Choisissez une barre pour voir sa photo.</translation>
    </message>
    <message>
        <source>Appears here after the calibration.</source>
        <translation>S’affiche ici dès que l’objectif est connu.</translation>
    </message>
    <message>
        <source>Image and &amp;residuals</source>
        <translation>Photo et rés&amp;idus</translation>
    </message>
    <message>
        <source>&amp;Straightened</source>
        <translation>Re&amp;dressée</translation>
    </message>
    <message>
        <source>Error by image</source>
        <translation>Erreur par photo</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Objectif</translation>
    </message>
    <message>
        <source>Lens calibration</source>
        <translation>Ce que l’on sait de l’objectif</translation>
    </message>
    <message>
        <source>Solving…</source>
        <translation>Calcul…</translation>
    </message>
    <message>
        <source>straight edges must be straight</source>
        <translation>les bords droits doivent être droits</translation>
    </message>
    <message>
        <source>Storing the lens calibration and its images…</source>
        <translation>Enregistrement de l’objectif et de ses photos…</translation>
    </message>
    <message>
        <source>The lens calibration was not stored. %1</source>
        <translation>L’objectif n’a pas été enregistré. %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Photos</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Board error</source>
        <translation>Erreur sur la mire</translation>
    </message>
    <message>
        <source>Held-out error</source>
        <translation>Erreur de validation</translation>
    </message>
    <message>
        <source>needs six images</source>
        <translation>exige six photos</translation>
    </message>
    <message>
        <source>Corners left out</source>
        <translation>Coins exclus</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Distance focale</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Centre x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Centre y</translation>
    </message>
    <message>
        <source>above the threshold</source>
        <translation>au-dessus du seuil</translation>
    </message>
    <message>
        <source>Images left out</source>
        <translation>Photos exclues</translation>
    </message>
</context>
<context>
    <name>odo::CalibrationSourcePage</name>
    <message>
        <source>&amp;From the camera: hold up the board, Odograph takes the images</source>
        <translation>De&amp;vant la caméra&#xa0;: tenez la mire, les photos se prennent d’elles-mêmes</translation>
    </message>
    <message>
        <source>From existing images or a &amp;video</source>
        <translation>D’après des &amp;photos ou une vidéo que vous avez prises</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Prin&amp;t a board…</source>
        <translation>&amp;Imprimer une mire…</translation>
    </message>
    <message>
        <source>Show a flat calibration board from many sides to calibrate the lens. Odograph recognises checkerboard and ChArUco boards of any size. Measure one square on the paper: every later length depends on it. Do not refocus or zoom afterwards.</source>
        <translation>Une mire plane de carrés, vue de plusieurs côtés, dit comment l’objectif dessine. Damier ou ChArUco, de toute taille&#xa0;: le type est reconnu. Mesurez un carré sur le papier&#xa0;; il détermine toutes les longueurs ensuite. La mise au point et le zoom ne doivent plus changer après.</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Caméra</translation>
    </message>
    <message>
        <source>Side of a &amp;square, measured</source>
        <translation>Côté d’un carré, &amp;mesuré</translation>
    </message>
    <message>
        <source>Source of the board images</source>
        <translation>D’où viennent les photos de la mire</translation>
    </message>
    <message>
        <source>Images and videos of the board</source>
        <translation>Photos et vidéos de la mire</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>A&amp;jouter…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Re&amp;tirer</translation>
    </message>
    <message>
        <source>You can also drop files here.</source>
        <translation>Des fichiers peuvent aussi être déposés ici.</translation>
    </message>
    <message>
        <source>Name the camera, such as A.</source>
        <translation>Donnez un nom à la caméra, par exemple A.</translation>
    </message>
    <message>
        <source>Connect a camera, or choose existing images.</source>
        <translation>Branchez une caméra, ou choisissez des images existantes.</translation>
    </message>
    <message>
        <source>Add images or a video of the board.</source>
        <translation>Ajoutez des images ou une vidéo de la mire.</translation>
    </message>
</context>
<context>
    <name>odo::CameraChoiceDialog</name>
    <message>
        <source>Cameras to record with</source>
        <translation>Caméras pour filmer</translation>
    </message>
    <message>
        <source>Device for camera %1</source>
        <translation>Appareil qui est la caméra %1</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Réglages…</translation>
    </message>
    <message>
        <source>Settings of camera %1</source>
        <translation>Réglages de la caméra %1</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>&amp;Search again</source>
        <translation>&amp;Rechercher</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>non utilisé</translation>
    </message>
    <message>
        <source>in use by another program</source>
        <translation>utilisé par un autre programme</translation>
    </message>
    <message>
        <source>%1 (not connected)</source>
        <translation>%1 (non connecté)</translation>
    </message>
    <message>
        <source>Searching for cameras…</source>
        <translation>Recherche des caméras…</translation>
    </message>
    <message>
        <source>Choose at least one camera. Two cameras locate a robot more accurately, and if one cannot see it, the other often can.</source>
        <translation>Choisissez au moins une caméra. Avec deux, la place d’un robot est mieux connue, et le reste quand l’une ne le voit pas.</translation>
    </message>
    <message>
        <source>You cannot use one device as two cameras.</source>
        <translation>Un appareil ne peut pas être deux caméras.</translation>
    </message>
</context>
<context>
    <name>odo::CameraListModel</name>
    <message>
        <source>not calibrated</source>
        <translation>non étalonnée</translation>
    </message>
    <message>
        <source>calibrated, ±%1 px</source>
        <translation>étalonnée, ±%1 px</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>non localisée</translation>
    </message>
    <message>
        <source>registered, %1</source>
        <translation>localisée, %1</translation>
    </message>
    <message>
        <source>Calibrate the lens, then register the camera to the floor.</source>
        <translation>Étalonnez l’objectif, puis localisez la caméra par rapport au sol.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Objectif</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
</context>
<context>
    <name>odo::CameraPositionDialog</name>
    <message>
        <source>moved %1</source>
        <translation>a bougé de %1</translation>
    </message>
    <message>
        <source>marker moved %1</source>
        <translation>marqueur déplacé de %1</translation>
    </message>
    <message>
        <source>has not moved</source>
        <translation>n’a pas bougé</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>&amp;Vérifier</translation>
    </message>
    <message>
        <source>&amp;Register again…</source>
        <translation>&amp;Relocaliser…</translation>
    </message>
    <message>
        <source>Check camera positions</source>
        <translation>Vérifier les caméras</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>New image</source>
        <translation>Nouvelle image</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Registered cameras</source>
        <translation>Caméras localisées</translation>
    </message>
    <message>
        <source>A camera that someone has pushed measures wrong positions without any sign of it. Before the robots run, check each camera&apos;s markers in a new image.</source>
        <translation>Une caméra bousculée mesure faux sans que rien ne le montre. Avant que les robots roulent, les marqueurs de chaque caméra sont recherchés dans une nouvelle image.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Results of the check</source>
        <translation>Ce qui a été trouvé</translation>
    </message>
    <message>
        <source>New image of camera %1</source>
        <translation>Nouvelle image de la caméra %1</translation>
    </message>
    <message>
        <source>Its newest recording</source>
        <translation>Son dernier enregistrement</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Non vérifiée</translation>
    </message>
    <message>
        <source>An image or video…</source>
        <translation>Une photo ou une vidéo…</translation>
    </message>
    <message>
        <source>detecting…</source>
        <translation>recherche…</translation>
    </message>
    <message>
        <source>undetermined</source>
        <translation>indéterminé</translation>
    </message>
    <message>
        <source>At least two markers must be visible. The check changes nothing.</source>
        <translation>Il faut voir au moins deux marqueurs. La vérification ne déplace et ne modifie rien.</translation>
    </message>
    <message>
        <source>&amp;Register %1 again…</source>
        <translation>&amp;Relocaliser %1…</translation>
    </message>
</context>
<context>
    <name>odo::CameraSettingsDialog</name>
    <message>
        <source>set by the camera</source>
        <translation>selon la caméra</translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation>images/s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Trigger each frame by software, at the same time for all cameras with this setting</source>
        <translation>Demander chaque image, pour que toutes ces caméras la prennent ensemble</translation>
    </message>
    <message>
        <source>Settings of %1</source>
        <translation>Réglages de %1</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposition</translation>
    </message>
    <message>
        <source>Software trigger</source>
        <translation>Déclenchement logiciel</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Rate</source>
        <translation>&amp;Cadence</translation>
    </message>
    <message>
        <source>&amp;Exposure</source>
        <translation>&amp;Exposition</translation>
    </message>
    <message>
        <source>&amp;Trigger</source>
        <translation>&amp;Déclenchement</translation>
    </message>
    <message>
        <source>If the camera does not support a setting, a message says so when it opens.</source>
        <translation>Ce que la caméra ne sait pas faire est indiqué à son ouverture.</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>best for tracking</source>
        <translation>le mieux pour le suivi</translation>
    </message>
</context>
<context>
    <name>odo::CameraView</name>
    <message>
        <source>synchronised to %1 ms</source>
        <translation>synchronisée à %1 ms près</translation>
    </message>
    <message>
        <source>manual offset</source>
        <translation>décalage manuel</translation>
    </message>
    <message>
        <source>not synchronised</source>
        <translation>non synchronisée</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Camera image</source>
        <translation>Image de la caméra</translation>
    </message>
    <message>
        <source>Image of %1</source>
        <translation>Image de %1</translation>
    </message>
</context>
<context>
    <name>odo::ChangeModel</name>
    <message>
        <source>made</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>redone</source>
        <translation>rétabli</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>How</source>
        <translation>État</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Modification</translation>
    </message>
</context>
<context>
    <name>odo::ChangesDialog</name>
    <message>
        <source>Project changes</source>
        <translation>Modifications du projet</translation>
    </message>
    <message>
        <source>No changes yet.</source>
        <translation>Rien n’a encore été modifié.</translation>
    </message>
    <message>
        <source>All changes made in this window and on the command line, newest first. The list includes recordings, imports and tracking, but you cannot undo them.</source>
        <translation>Ce qui a été modifié, dans cette fenêtre et par la ligne de commande, du plus récent au plus ancien. Les enregistrements, les importations et les suivis y figurent aussi&#xa0;; ils ne peuvent pas être annulés.</translation>
    </message>
    <message>
        <source>Search the changes…</source>
        <translation>Chercher dans les modifications…</translation>
    </message>
    <message>
        <source>Search the changes</source>
        <translation>Chercher dans les modifications</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Modifications</translation>
    </message>
</context>
<context>
    <name>odo::ChartImage</name>
    <message>
        <source>&amp;Copy as image</source>
        <translation>&amp;Copier comme image</translation>
    </message>
    <message>
        <source>&amp;Save as image…</source>
        <translation>&amp;Enregistrer comme image…</translation>
    </message>
    <message>
        <source>SVG images (*.svg)</source>
        <translation>Images SVG (*.svg)</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>Images PNG (*.png)</translation>
    </message>
    <message>
        <source>Save as image</source>
        <translation>Enregistrer comme image</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documents PDF (*.pdf)</translation>
    </message>
</context>
<context>
    <name>odo::ChartSpan</name>
    <message>
        <source>Charts: show &amp;less</source>
        <translation>Graphiques&#xa0;: montrer &amp;moins</translation>
    </message>
    <message>
        <source>Charts: show &amp;more</source>
        <translation>Graphiques&#xa0;: montrer pl&amp;us</translation>
    </message>
    <message>
        <source>Charts: show &amp;all</source>
        <translation>Graphiques&#xa0;: montrer &amp;tout</translation>
    </message>
    <message>
        <source>Charts over &amp;distance</source>
        <translation>Graphiques selon la dist&amp;ance</translation>
    </message>
</context>
<context>
    <name>odo::CheckTools</name>
    <message>
        <source>&amp;Check camera positions…</source>
        <translation>&amp;Vérifier les caméras…</translation>
    </message>
    <message>
        <source>Check camera positions…</source>
        <translation>Vérifier les caméras…</translation>
    </message>
    <message>
        <source>Check before the robots run that no camera has moved since its registration</source>
        <translation>Vérifier que chaque caméra est encore là où elle a été localisée, avant que les robots roulent</translation>
    </message>
    <message>
        <source>Check a known &amp;length…</source>
        <translation>Vérifier une lon&amp;gueur connue…</translation>
    </message>
    <message>
        <source>Check a known length…</source>
        <translation>Vérifier une longueur connue…</translation>
    </message>
    <message>
        <source>Measure an object of known length in a camera&apos;s image to check the camera&apos;s stated uncertainty</source>
        <translation>Mesurer dans l’image d’une caméra un objet de longueur connue, pour voir si la caméra est aussi bonne qu’elle le promet</translation>
    </message>
    <message>
        <source>&amp;Expected accuracy…</source>
        <translation>&amp;Précision attendue…</translation>
    </message>
    <message>
        <source>Accuracy…</source>
        <translation>Précision…</translation>
    </message>
    <message>
        <source>Show the expected uncertainty everywhere on the floor, also with planned cameras</source>
        <translation>Voir avec quelle précision chaque endroit du sol sera connu, y compris avec des caméras seulement prévues</translation>
    </message>
    <message>
        <source>&amp;Older calibrations…</source>
        <translation>Étalonnages &amp;antérieurs…</translation>
    </message>
    <message>
        <source>Revisions…</source>
        <translation>Révisions…</translation>
    </message>
    <message>
        <source>Show all calibrations and registrations of a camera, switch to an older one, reanalyse trials</source>
        <translation>Voir tous les étalonnages et toutes les localisations d’une caméra, en remettre un ancien en vigueur, remesurer des essais</translation>
    </message>
    <message>
        <source>Cameras checked: see their badges.</source>
        <translation>Les caméras sont vérifiées&#xa0;: voyez leurs pastilles.</translation>
    </message>
    <message>
        <source>The chosen calibrations and analyses are now current.</source>
        <translation>Étalonnages et essais sont tels que vous les avez choisis.</translation>
    </message>
</context>
<context>
    <name>odo::ClassActions</name>
    <message>
        <source>&amp;Tasks…</source>
        <translation>Épr&amp;euves…</translation>
    </message>
    <message>
        <source>C&amp;lasses and teams…</source>
        <translation>Classes et é&amp;quipes…</translation>
    </message>
    <message>
        <source>R&amp;obots…</source>
        <translation>R&amp;obots…</translation>
    </message>
    <message>
        <source>Show &amp;standings…</source>
        <translation>Afficher le cla&amp;ssement…</translation>
    </message>
</context>
<context>
    <name>odo::ClassesDialog</name>
    <message>
        <source>&amp;New class…</source>
        <translation>&amp;Nouvelle classe…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Renommer…</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>&amp;Archiver</translation>
    </message>
    <message>
        <source>Dele&amp;te</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>New t&amp;eam…</source>
        <translation>Nouvelle é&amp;quipe…</translation>
    </message>
    <message>
        <source>&amp;Move to</source>
        <translation>&amp;Déplacer vers</translation>
    </message>
    <message>
        <source>Members and r&amp;obots…</source>
        <translation>Membres et r&amp;obots…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Su&amp;pprimer</translation>
    </message>
    <message>
        <source>&amp;Import roster…</source>
        <translation>&amp;Importer une liste…</translation>
    </message>
    <message>
        <source>Classes and teams</source>
        <translation>Classes et équipes</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Ce qui a été fait</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>Classes</translation>
    </message>
    <message>
        <source>Archiving hides a class: History, Record and the standings show its teams and trials only if you choose the class by name</source>
        <translation>Une classe archivée est mise de côté&#xa0;: «&#xa0;Historique&#xa0;», «&#xa0;Filmer&#xa0;» et le classement ne montrent ses équipes et ses essais que si elle y est choisie par son nom</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>Pseudonyme</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>Membres</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Teams of the class</source>
        <translation>Équipes de la classe</translation>
    </message>
    <message>
        <source>Double-click or press F2 to change a name or a pseudonym</source>
        <translation>Un double-clic ou F2 modifie un nom ou un pseudonyme</translation>
    </message>
    <message numerus="yes">
        <source>%1 (archived, %n team(s))</source>
        <translation>
            <numerusform>%1 (archivée, %n équipe)</numerusform>
            <numerusform>%1 (archivée, %n équipes)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n team(s))</source>
        <translation>
            <numerusform>%1 (%n équipe)</numerusform>
            <numerusform>%1 (%n équipes)</numerusform>
        </translation>
    </message>
    <message>
        <source>Teams without a class</source>
        <translation>Équipes sans classe</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>Dés&amp;archiver</translation>
    </message>
    <message>
        <source>No class</source>
        <translation>Aucune classe</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nom&#xa0;:</translation>
    </message>
    <message>
        <source>New class</source>
        <translation>Nouvelle classe</translation>
    </message>
    <message>
        <source>Rename class</source>
        <translation>Renommer la classe</translation>
    </message>
    <message>
        <source>New team</source>
        <translation>Nouvelle équipe</translation>
    </message>
</context>
<context>
    <name>odo::CompareColumn</name>
    <message>
        <source>Time difference</source>
        <translation>Écart de temps</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Secteurs</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Grandeurs</translation>
    </message>
    <message>
        <source>Run compared with the first one</source>
        <translation>Passage comparé au premier</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Passages</translation>
    </message>
    <message>
        <source>Times from gate to gate</source>
        <translation>Temps de porte à porte</translation>
    </message>
    <message>
        <source>Metrics of both runs</source>
        <translation>Grandeurs des deux passages</translation>
    </message>
    <message>
        <source>s · drag the gates on the map</source>
        <translation>s · faites glisser les portes sur la carte</translation>
    </message>
    <message>
        <source>grey: not significant</source>
        <translation>gris&#xa0;: dans la marge d’erreur</translation>
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
        <translation>En retard à la fin</translation>
    </message>
    <message>
        <source>Ahead at finish</source>
        <translation>En avance à la fin</translation>
    </message>
    <message>
        <source>Gap at finish</source>
        <translation>À la fin</translation>
    </message>
    <message>
        <source>Behind at cursor</source>
        <translation>En retard ici</translation>
    </message>
    <message>
        <source>Ahead at cursor</source>
        <translation>En avance ici</translation>
    </message>
    <message>
        <source>Gap at cursor</source>
        <translation>Ici</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
</context>
<context>
    <name>odo::CompareDesk</name>
    <message>
        <source>Top-down map</source>
        <translation>Carte vue de dessus</translation>
    </message>
    <message>
        <source>Floor map with the paths of the runs and the gates of the sectors</source>
        <translation>Carte du sol avec les trajets des passages et les portes des secteurs</translation>
    </message>
    <message>
        <source>Drag a gate along the path. Keys: Up and Down select a gate, Left and Right move it</source>
        <translation>Faites glisser une porte le long du trajet&#xa0;; au clavier&#xa0;: Haut et Bas en choisissent une, Gauche et Droite la déplacent</translation>
    </message>
    <message>
        <source>both runs</source>
        <translation>les deux passages</translation>
    </message>
    <message>
        <source>Camera of the first run</source>
        <translation>Caméra du premier passage</translation>
    </message>
    <message>
        <source>Camera of the second run</source>
        <translation>Caméra du second passage</translation>
    </message>
    <message>
        <source>dashed: the task&apos;s path</source>
        <translation>tirets&#xa0;: tracé de l’épreuve</translation>
    </message>
    <message>
        <source>along the first run&apos;s path</source>
        <translation>le long du trajet du premier passage</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Premier</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Second</translation>
    </message>
</context>
<context>
    <name>odo::ComparePage</name>
    <message>
        <source>These runs cannot be compared</source>
        <translation>Ces passages ne peuvent pas être comparés</translation>
    </message>
    <message>
        <source>%1. What to do: %2.</source>
        <translation>%1. Pour y remédier&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Select two runs</source>
        <translation>Il faut deux passages</translation>
    </message>
    <message>
        <source>A comparison shows where one run is faster than the other, and whether the difference is significant. Select two tracked trials, or import another one.</source>
        <translation>La comparaison montre où un passage est plus rapide qu’un autre, et si l’écart dépasse la marge d’erreur. Choisissez deux essais déjà suivis, ou importez-en un autre.</translation>
    </message>
    <message>
        <source>Import trial from videos…</source>
        <translation>Importer les vidéos d’un essai…</translation>
    </message>
</context>
<context>
    <name>odo::ConflictDialog</name>
    <message>
        <source>Changed here and elsewhere</source>
        <translation>Modifié ici et ailleurs</translation>
    </message>
    <message>
        <source>You and another bench changed these. Nothing is lost: the hub keeps the version that is not in force. To bring a value back, enter it here again.</source>
        <translation>Vous et un autre poste avez modifié ceci. Rien n’est perdu&#xa0;: le serveur garde la version qui n’est pas en vigueur. Pour rétablir une valeur, saisissez-la de nouveau ici.</translation>
    </message>
    <message>
        <source>What was changed twice</source>
        <translation>Ce qui a été modifié deux fois</translation>
    </message>
    <message>
        <source>Values that differ</source>
        <translation>Valeurs qui diffèrent</translation>
    </message>
    <message>
        <source>&amp;Remove all from this list</source>
        <translation>&amp;Retirer tout de la liste</translation>
    </message>
    <message>
        <source>The version of this project is in force.</source>
        <translation>La version de ce projet est en vigueur.</translation>
    </message>
    <message>
        <source>The version of the hub is in force. It comes with the next “Pull”.</source>
        <translation>La version du serveur est en vigueur. Elle arrivera à la prochaine réception.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>In this project</source>
        <translation>Dans ce projet</translation>
    </message>
    <message>
        <source>At the hub</source>
        <translation>Sur le serveur</translation>
    </message>
</context>
<context>
    <name>odo::ConnectForm</name>
    <message>
        <source>Odograph keeps it until you close the program, and writes it nowhere</source>
        <translation>Odograph le garde jusqu’à la fermeture du programme et ne l’écrit nulle part</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Mot de passe</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Parcourir…</translation>
    </message>
    <message>
        <source>C&amp;onnect</source>
        <translation>&amp;Connecter</translation>
    </message>
    <message>
        <source>Connect this project to the school&apos;s hub. Odograph sends its trials, tasks and class lists there, and you receive those of the other benches. You can measure without the network; Odograph sends later what it could not send.</source>
        <translation>Connectez ce projet au serveur de l’école. Odograph y envoie ses essais, ses épreuves et ses listes de classe, et vous recevez ceux des autres postes. Vous pouvez mesurer sans réseau&#xa0;; Odograph envoie plus tard ce qu’il n’a pas pu envoyer.</translation>
    </message>
    <message>
        <source>Address of the hub</source>
        <translation>Adresse du serveur</translation>
    </message>
    <message>
        <source>empty: as in ~/.pgpass or PGPASSWORD</source>
        <translation>vide&#xa0;: celui de ~/.pgpass ou PGPASSWORD</translation>
    </message>
    <message>
        <source>optional: a folder that all benches can reach</source>
        <translation>facultatif&#xa0;: un dossier accessible à tous les postes</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>Dossier des enregistrements</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>Parcourir&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Adresse&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Password:</source>
        <translation>&amp;Mot de passe&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Recordings:</source>
        <translation>&amp;Enregistrements&#xa0;:</translation>
    </message>
    <message>
        <source>postgresql://bench1@hub.school.example/school</source>
        <translation>postgresql://poste1@serveur.ecole.example/ecole</translation>
    </message>
</context>
<context>
    <name>odo::CoveragePanel</name>
    <message>
        <source>Across</source>
        <translation>En largeur</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>En hauteur</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>De près</translation>
    </message>
    <message>
        <source>Tilted</source>
        <translation>Inclinée</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Couverture</translation>
    </message>
    <message>
        <source>%1 images: enough. More do no harm.</source>
        <translation>%1 photos&#xa0;: c’est assez. Davantage ne nuit pas.</translation>
    </message>
    <message>
        <source>1 image; take ten or more.</source>
        <translation>1 photo&#xa0;; il en faut au moins dix.</translation>
    </message>
    <message>
        <source>%1 images; take ten or more.</source>
        <translation>%1 photos&#xa0;; il en faut au moins dix.</translation>
    </message>
</context>
<context>
    <name>odo::CrashNotice</name>
    <message>
        <source>Odograph ended unexpectedly</source>
        <translation>Odograph s’est arrêté inopinément</translation>
    </message>
    <message>
        <source>Odograph crashed the last time. Saved data is safe. If a recording was cut off, open its project to recover it up to the last second.</source>
        <translation>La dernière fois, Odograph s’est arrêté à cause d’une erreur interne. Ce qui était enregistré est intact. Une vidéo dont l’enregistrement a été interrompu est conservée jusqu’à sa dernière seconde dès que son projet est rouvert.</translation>
    </message>
    <message>
        <source>Odograph crashed the last time. Saved data is safe.</source>
        <translation>La dernière fois, Odograph s’est arrêté à cause d’une erreur interne. Ce qui était enregistré est intact.</translation>
    </message>
    <message>
        <source>Project:</source>
        <translation>Projet&#xa0;:</translation>
    </message>
    <message>
        <source>Report:</source>
        <translation>Rapport&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Open the project</source>
        <translation>&amp;Ouvrir le projet</translation>
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
        <translation>début</translation>
    </message>
    <message>
        <source>end</source>
        <translation>fin</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Only one of the two runs has it</source>
        <translation>Un seul des deux l’a</translation>
    </message>
    <message>
        <source>%1: significant (95 %)</source>
        <translation>%1&#xa0;: hors marge d’erreur (95&#xa0;%)</translation>
    </message>
    <message>
        <source>%1: not significant (95 %)</source>
        <translation>%1&#xa0;: dans la marge d’erreur (95&#xa0;%), on ne peut conclure à aucune différence</translation>
    </message>
    <message>
        <source>significant</source>
        <translation>hors marge d’erreur</translation>
    </message>
    <message>
        <source>not significant</source>
        <translation>dans la marge d’erreur</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
</context>
<context>
    <name>odo::DistanceChart</name>
    <message>
        <source>Speed over distance</source>
        <translation>Vitesse le long du trajet</translation>
    </message>
    <message>
        <source>Time difference over distance</source>
        <translation>Écart de temps le long du trajet</translation>
    </message>
    <message>
        <source>%1 · smoothed ±95 %</source>
        <translation>%1 · lissé ±95&#xa0;%</translation>
    </message>
    <message>
        <source>s · above 0: %2 is later than %1 · ±95 % · grey: not significant</source>
        <translation>s · au-dessus de 0&#xa0;: %2 en retard sur %1 · ±95&#xa0;% · gris&#xa0;: dans la marge d’erreur</translation>
    </message>
    <message>
        <source>s · above 0: later than %1 · ±95 % · grey: not significant</source>
        <translation>s · au-dessus de 0&#xa0;: en retard sur %1 · ±95&#xa0;% · gris&#xa0;: dans la marge d’erreur</translation>
    </message>
</context>
<context>
    <name>odo::DockGrip</name>
    <message>
        <source>Drag to move, double-click to float</source>
        <translation>Glisser pour déplacer, double-clic pour détacher</translation>
    </message>
</context>
<context>
    <name>odo::DoctorDialog</name>
    <message>
        <source>good</source>
        <translation>bon</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>avertissement</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>mauvais</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Set-up doctor</source>
        <translation>Diagnostic de l’installation</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Ce qui a été trouvé</translation>
    </message>
    <message>
        <source>&amp;Check again</source>
        <translation>&amp;Rechercher</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Recherche…</translation>
    </message>
    <message>
        <source>. What to do: %1.</source>
        <translation>. À faire&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Found nothing that would disturb a recording.</source>
        <translation>Rien n’a été trouvé qui gênerait un enregistrement.</translation>
    </message>
    <message>
        <source>Found one problem.</source>
        <translation>Il y a un point à examiner.</translation>
    </message>
    <message>
        <source>Found %1 problems, the worst first.</source>
        <translation>Il y a %1 points à examiner, le plus grave d’abord.</translation>
    </message>
</context>
<context>
    <name>odo::EditTrialDialog</name>
    <message>
        <source>Robots in the trial</source>
        <translation>Robots de l’essai</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message numerus="yes">
        <source>Edit %n trial(s)</source>
        <translation>
            <numerusform>Modifier %n essai</numerusform>
            <numerusform>Modifier %n essais</numerusform>
        </translation>
    </message>
    <message>
        <source>Why it was not changed</source>
        <translation>Pourquoi rien n’a été modifié</translation>
    </message>
    <message>
        <source>&amp;Change</source>
        <translation>&amp;Modifier</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>T&amp;eam</source>
        <translation>É&amp;quipe</translation>
    </message>
    <message>
        <source>C&amp;lass</source>
        <translation>C&amp;lasse</translation>
    </message>
    <message>
        <source>&amp;Date and time</source>
        <translation>&amp;Date et heure</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>É&amp;preuve</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>R&amp;obots</translation>
    </message>
    <message>
        <source>separated by commas</source>
        <translation>séparées par des virgules</translation>
    </message>
    <message>
        <source>Ta&amp;gs</source>
        <translation>É&amp;tiquettes</translation>
    </message>
    <message>
        <source>Note&amp;s</source>
        <translation>Note&amp;s</translation>
    </message>
    <message>
        <source>&amp;Variables</source>
        <translation>&amp;Variables</translation>
    </message>
    <message>
        <source>&amp;Remove variable</source>
        <translation>Suppr&amp;imer la variable</translation>
    </message>
    <message>
        <source>The variable %1 is in the table twice. Remove one of the rows.</source>
        <translation>La variable %1 figure deux fois dans le tableau. Supprimez l’une des lignes.</translation>
    </message>
</context>
<context>
    <name>odo::FileActions</name>
    <message>
        <source>&amp;New project…</source>
        <translation>&amp;Nouveau projet…</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>&amp;Ouvrir un projet…</translation>
    </message>
    <message>
        <source>Open &amp;demo lesson…</source>
        <translation>Ouvrir la leçon de &amp;démo…</translation>
    </message>
    <message>
        <source>Save a &amp;copy as…</source>
        <translation>Enregistrer une &amp;copie…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Projets &amp;récents</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Effacer cette liste</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Nouveau projet</translation>
    </message>
    <message>
        <source>Project.odo</source>
        <translation>Projet.odo</translation>
    </message>
    <message>
        <source>Odograph projects (*.odo)</source>
        <translation>Projets Odograph (*.odo)</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Ouvrir un projet</translation>
    </message>
    <message>
        <source>Odograph projects (*.odo);;All files (*)</source>
        <translation>Projets Odograph (*.odo);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Choose a folder for the demo lesson</source>
        <translation>Où créer la leçon de démonstration&#xa0;?</translation>
    </message>
    <message>
        <source>Odograph demo</source>
        <translation>Démo Odograph</translation>
    </message>
    <message>
        <source>Copy of %1</source>
        <translation>Copie de %1</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Enregistrer une copie</translation>
    </message>
    <message>
        <source>Copy saved as %1. Its videos stay where they are.</source>
        <translation>Une copie a été enregistrée&#xa0;: %1. Ses vidéos restent où elles sont.</translation>
    </message>
    <message>
        <source>New project from t&amp;his one…</source>
        <translation>Nouveau projet d’après ce&amp;lui-ci…</translation>
    </message>
    <message>
        <source>With its cameras, marker layouts, robots and tasks, without people and trials</source>
        <translation>Avec ses caméras, plans de marqueurs, robots et épreuves, sans personnes ni essais</translation>
    </message>
    <message>
        <source>Open demo lesson</source>
        <translation>Ouvrir la leçon de démo</translation>
    </message>
    <message>
        <source>A demo lesson is in %1.</source>
        <translation>Une leçon de démo se trouve dans %1.</translation>
    </message>
    <message>
        <source>&amp;Open it</source>
        <translation>&amp;L’ouvrir</translation>
    </message>
    <message>
        <source>&amp;Create another…</source>
        <translation>&amp;En créer une autre…</translation>
    </message>
    <message>
        <source>&amp;Backups…</source>
        <translation>Copies de &amp;sauvegarde…</translation>
    </message>
</context>
<context>
    <name>odo::FilmStrip</name>
    <message>
        <source>&amp;Remove</source>
        <translation>Re&amp;tirer</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Accepted images</source>
        <translation>Photos prises en compte</translation>
    </message>
</context>
<context>
    <name>odo::FloorCopy</name>
    <message>
        <source>&amp;Copy floor position</source>
        <translation>&amp;Copier la position au sol</translation>
    </message>
</context>
<context>
    <name>odo::FloorMap</name>
    <message>
        <source>Top-down map</source>
        <translation>Carte vue de dessus</translation>
    </message>
    <message>
        <source>Map: &amp;views&apos; disagreement</source>
        <translation>Carte&#xa0;: désaccord des &amp;vues</translation>
    </message>
    <message>
        <source>Floor map with the robots&apos; trails</source>
        <translation>Carte du sol avec les traces des robots</translation>
    </message>
    <message>
        <source>Colour of the trails on the map</source>
        <translation>Ce qui colore les traces sur la carte</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Disagreement</source>
        <translation>Désaccord</translation>
    </message>
    <message>
        <source>Disagreement of the views: %1</source>
        <translation>Désaccord des vues&#xa0;: %1</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>couleur</translation>
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
        <translation>Pas sur le sol</translation>
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
        <translation>Croquis du banc d’essai vu de dessus</translation>
    </message>
    <message>
        <source>%1 markers, %2 cameras</source>
        <translation>%1 marqueurs, %2 caméras</translation>
    </message>
    <message>
        <source>%1, %2 m high</source>
        <translation>%1, à %2 m de haut</translation>
    </message>
    <message>
        <source>This sketch shows markers and cameras once the testbed has a layout or a registered camera.</source>
        <translation>Marqueurs et caméras sont dessinés ici dès qu’il y a un plan de marqueurs ou une caméra localisée.</translation>
    </message>
    <message>
        <source>grid %1 m</source>
        <translation>grille de %1 m</translation>
    </message>
</context>
<context>
    <name>odo::FloorSourcePage</name>
    <message>
        <source>Image or video of the markers</source>
        <translation>Photo ou vidéo des marqueurs</translation>
    </message>
    <message>
        <source>Markers with known floor positions determine the camera position. Four are enough; a fifth checks them. Do not move the camera afterwards.</source>
        <translation>Des marqueurs dont la place au sol est connue disent où se trouve la caméra. Quatre suffisent, un cinquième les contrôle. Ensuite, la caméra ne doit plus être déplacée.</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>C&amp;améra</translation>
    </message>
    <message>
        <source>Marker &amp;layout</source>
        <translation>P&amp;lan de marqueurs</translation>
    </message>
    <message>
        <source>Image of the markers</source>
        <translation>Où l’on voit les marqueurs</translation>
    </message>
    <message>
        <source>Its lens is calibrated.</source>
        <translation>Son objectif est mesuré.</translation>
    </message>
    <message>
        <source>Its lens is not calibrated. Odograph estimates it from the markers, as far as they determine it.</source>
        <translation>Son objectif n’est pas étalonné. Odograph l’estime d’après les marqueurs, autant qu’ils le déterminent.</translation>
    </message>
    <message>
        <source>Name the camera, such as A.</source>
        <translation>Donnez un nom à la caméra, par exemple A.</translation>
    </message>
    <message>
        <source>Add a marker layout first.</source>
        <translation>Ajoutez d’abord un plan de marqueurs.</translation>
    </message>
    <message>
        <source>Choose an image or a video of the markers.</source>
        <translation>Choisissez une image ou une vidéo des marqueurs.</translation>
    </message>
</context>
<context>
    <name>odo::FloorWizard</name>
    <message>
        <source>Register camera to the floor</source>
        <translation>Localiser une caméra par rapport au sol</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>The camera and its markers</source>
        <translation>La caméra et ses marqueurs</translation>
    </message>
    <message>
        <source>The markers in the image</source>
        <translation>Les marqueurs dans l’image</translation>
    </message>
    <message>
        <source>Detecting the markers…</source>
        <translation>Recherche des marqueurs…</translation>
    </message>
    <message>
        <source>There is no registration to save yet.</source>
        <translation>Il n’y a pas encore de localisation à enregistrer.</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>la localisation</translation>
    </message>
</context>
<context>
    <name>odo::GateTable</name>
    <message>
        <source>start</source>
        <translation>départ</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>arrivée</translation>
    </message>
    <message>
        <source>start and finish</source>
        <translation>départ et arrivée</translation>
    </message>
    <message>
        <source>split</source>
        <translation>intermédiaire</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>Reverse directi&amp;on</source>
        <translation>&amp;Inverser le sens</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Porte</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
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
        <translation>Portes dans l’ordre de franchissement</translation>
    </message>
    <message>
        <source>&amp;Add gate</source>
        <translation>A&amp;jouter une porte</translation>
    </message>
    <message>
        <source>Robots pass the selected gate the other way</source>
        <translation>La porte choisie se franchit dans l’autre sens</translation>
    </message>
    <message>
        <source>Role of the gate</source>
        <translation>Rôle de la porte</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>Intermédiaire %1</translation>
    </message>
</context>
<context>
    <name>odo::GeneralPage</name>
    <message>
        <source>Restart Odograph to see the change.</source>
        <translation>Odograph l’affichera à son prochain démarrage.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>&amp;Units of results</source>
        <translation>&amp;Unités des résultats</translation>
    </message>
    <message>
        <source>Floors and targets always use millimetres, as printed. Exported files use the units of their format.</source>
        <translation>Les sols et les cibles se règlent en millimètres, comme ils sont imprimés. Les fichiers exportés ont les unités que demande leur format.</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>&amp;Colours of maps</source>
        <translation>&amp;Couleurs des cartes</translation>
    </message>
    <message>
        <source>Both remain readable for people with red-green colour blindness and in black-and-white prints.</source>
        <translation>Les deux restent lisibles pour qui ne voit pas le rouge ou le vert, et dans une impression sans couleurs.</translation>
    </message>
    <message>
        <source>Units of results</source>
        <translation>Unités des résultats</translation>
    </message>
    <message>
        <source>Millimetres and metres: mm, m, m/s</source>
        <translation>Millimètres et mètres&#xa0;: mm, m, m/s</translation>
    </message>
    <message>
        <source>Centimetres: cm, cm/s</source>
        <translation>Centimètres&#xa0;: cm, cm/s</translation>
    </message>
    <message>
        <source>Inches and feet: in, ft, ft/s</source>
        <translation>Pouces et pieds&#xa0;: in, ft, ft/s</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>As set on the computer</source>
        <translation>Comme l’ordinateur</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>As set on the desktop</source>
        <translation>Comme le bureau</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Colours of maps</source>
        <translation>Couleurs des cartes</translation>
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
        <translation>Sau&amp;vegarder un projet chaque jour où il est ouvert</translation>
    </message>
    <message>
        <source>&amp;Days to keep backups</source>
        <translation>&amp;Jours de conservation</translation>
    </message>
    <message>
        <source>Backups are beside the project and contain everything except the videos: File ▸ Backups… shows and restores them.</source>
        <translation>Les copies sont à côté du projet et contiennent tout sauf les vidéos : Fichier ▸ Copies de sauvegarde… les montre et les restaure.</translation>
    </message>
</context>
<context>
    <name>odo::GuidanceTool</name>
    <message>
        <source>&amp;Ignore an area</source>
        <translation>&amp;Ignorer une zone</translation>
    </message>
    <message>
        <source>Draw an area of a view to ignore, such as a mirror or a screen: click its corners, then press Enter</source>
        <translation>Dessiner une zone d’une vue à ignorer, comme un miroir ou un écran : cliquez sur ses coins, puis appuyez sur Entrée</translation>
    </message>
    <message>
        <source>Search only an &amp;area</source>
        <translation>N’explorer qu’une &amp;zone</translation>
    </message>
    <message>
        <source>Draw the area of a view in which robots are searched: click its corners, then press Enter</source>
        <translation>Dessiner la zone d’une vue où les robots sont cherchés : cliquez sur ses coins, puis appuyez sur Entrée</translation>
    </message>
    <message>
        <source>&amp;Remove all areas</source>
        <translation>&amp;Retirer toutes les zones</translation>
    </message>
    <message>
        <source>Remove all areas of this trial</source>
        <translation>Retirer toutes les zones de cet essai</translation>
    </message>
    <message>
        <source>Remove this ignored area</source>
        <translation>Retirer cette zone ignorée</translation>
    </message>
    <message>
        <source>Remove this search area</source>
        <translation>Retirer cette zone de recherche</translation>
    </message>
    <message>
        <source>Set %1 here by hand…</source>
        <translation>Placer %1 ici à la main…</translation>
    </message>
    <message>
        <source>%1 is not visible here in the selected time</source>
        <translation>%1 n’est pas visible ici pendant le temps sélectionné</translation>
    </message>
    <message>
        <source>%1 is not visible in any view in the selected time</source>
        <translation>%1 n’est visible dans aucune vue pendant le temps sélectionné</translation>
    </message>
    <message>
        <source>Remove the point set by hand</source>
        <translation>Retirer le point placé à la main</translation>
    </message>
    <message>
        <source>It is visible after all</source>
        <translation>Il est visible en fait</translation>
    </message>
    <message>
        <source>Set a point by hand</source>
        <translation>Placer un point à la main</translation>
    </message>
    <message>
        <source>Uncertainty σ of this point, pixels:</source>
        <translation>Incertitude σ de ce point, pixels :</translation>
    </message>
</context>
<context>
    <name>odo::HelpActions</name>
    <message>
        <source>&amp;Help on this page</source>
        <translation>&amp;Aide sur cette page</translation>
    </message>
    <message>
        <source>&amp;First lesson</source>
        <translation>&amp;Première leçon</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Raccourcis</translation>
    </message>
    <message>
        <source>&amp;About Odograph</source>
        <translation>À propos d’&amp;Odograph</translation>
    </message>
</context>
<context>
    <name>odo::HelpPanel</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Close the help (F1)</source>
        <translation>Fermer l’aide (F1)</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>Fermer l’aide</translation>
    </message>
    <message>
        <source>Help on this page</source>
        <translation>Aide sur cette page</translation>
    </message>
</context>
<context>
    <name>odo::HistoryActions</name>
    <message>
        <source>Import &amp;roster…</source>
        <translation>Importer une &amp;liste de classe…</translation>
    </message>
    <message>
        <source>Show project &amp;changes…</source>
        <translation>&amp;Modifications du projet…</translation>
    </message>
    <message>
        <source>Import a roster: a table with the columns class, team and optionally pseudonym</source>
        <translation>Importer une liste de classe&#xa0;: un tableau avec les colonnes «&#xa0;class&#xa0;» et «&#xa0;team&#xa0;», éventuellement «&#xa0;pseudonym&#xa0;»</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>Tableaux CSV (*.csv)</translation>
    </message>
    <message>
        <source>Roster imported. New teams: %1, changed: %2, unchanged: %3.</source>
        <translation>La liste de classe est importée. Équipes nouvelles&#xa0;: %1, modifiées&#xa0;: %2, inchangées&#xa0;: %3.</translation>
    </message>
    <message numerus="yes">
        <source>Export %n trial(s): choose a folder</source>
        <translation>
            <numerusform>Exporter %n essai&#xa0;: choisissez un dossier</numerusform>
            <numerusform>Exporter %n essais&#xa0;: choisissez un dossier</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Videos of %n trial(s)</source>
        <translation>
            <numerusform>Vidéos de %n essai</numerusform>
            <numerusform>Vidéos de %n essais</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) removed for good.</source>
        <translation>
            <numerusform>%n essai supprimé définitivement.</numerusform>
            <numerusform>%n essais supprimés définitivement.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Removed %1 of %n trial(s) for good; the rest is still in the bin.</source>
        <translation>
            <numerusform>%1 essai sur %n supprimé définitivement&#xa0;; le reste est encore là.</numerusform>
            <numerusform>%1 essais sur %n supprimés définitivement&#xa0;; le reste est encore là.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 could not be deleted; delete it by hand.</source>
        <translation>%1 n’a pas pu être supprimé&#xa0;; supprimez-le à la main.</translation>
    </message>
</context>
<context>
    <name>odo::HistoryPage</name>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Comparer</translation>
    </message>
    <message>
        <source>Teams by &amp;pseudonym</source>
        <translation>Équipes par &amp;pseudonyme</translation>
    </message>
    <message>
        <source>Tr&amp;ials</source>
        <translation>Essai&amp;s</translation>
    </message>
    <message>
        <source>Tea&amp;ms</source>
        <translation>É&amp;quipes</translation>
    </message>
    <message>
        <source>Trials or teams</source>
        <translation>Essais ou équipes</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Rea&amp;nalyse</source>
        <translation>&amp;Remesurer</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>R&amp;apport…</translation>
    </message>
    <message>
        <source>Export &amp;videos…</source>
        <translation>Exporter les &amp;vidéos…</translation>
    </message>
    <message>
        <source>Search trials, teams, tasks, tags, notes…</source>
        <translation>Chercher essais, équipes, épreuves, étiquettes, notes…</translation>
    </message>
    <message>
        <source>Search the trials</source>
        <translation>Chercher dans les essais</translation>
    </message>
    <message>
        <source>Searc&amp;h</source>
        <translation>Cherc&amp;her</translation>
    </message>
    <message>
        <source>%1 (archived)</source>
        <translation>%1 (archivée)</translation>
    </message>
    <message>
        <source>Compare the selected trials</source>
        <translation>Comparer les essais sélectionnés</translation>
    </message>
    <message>
        <source>Select two or more trials (Ctrl+click or Shift+click)</source>
        <translation>Sélectionnez au moins deux essais (Ctrl ou Maj et un clic)</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n essai</numerusform>
            <numerusform>%n essais</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n trial(s)</source>
        <translation>
            <numerusform>%1 sur %n essai</numerusform>
            <numerusform>%1 sur %n essais</numerusform>
        </translation>
    </message>
    <message>
        <source>School hub</source>
        <translation>Serveur de l’école</translation>
    </message>
</context>
<context>
    <name>odo::HubActions</name>
    <message>
        <source>School &amp;hub…</source>
        <translation>Ser&amp;veur de l’école…</translation>
    </message>
</context>
<context>
    <name>odo::HubDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>School hub</source>
        <translation>Serveur de l’école</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Ce qui a été fait</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Cancel the exchange with the hub</source>
        <translation>Annuler l’échange avec le serveur</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Déconnecter</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) are not sent yet. They stay in the project.</source>
        <translation>
            <numerusform>%n modification n’est pas encore envoyée. Elle reste dans le projet.</numerusform>
            <numerusform>%n modifications ne sont pas encore envoyées. Elles restent dans le projet.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Déconnecter</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Connexion…</translation>
    </message>
    <message>
        <source>Asking the hub…</source>
        <translation>Demande au serveur…</translation>
    </message>
    <message>
        <source>The project is read-only here, so nothing can be sent or received.</source>
        <translation>Le projet est ici en lecture seule&#xa0;: rien ne peut être envoyé ni reçu.</translation>
    </message>
</context>
<context>
    <name>odo::HubExchange</name>
    <message>
        <source>Disconnected. All trials stay in the project.</source>
        <translation>Déconnecté. Tous les essais restent dans le projet.</translation>
    </message>
</context>
<context>
    <name>odo::HubPanel</name>
    <message>
        <source>Password of the hub</source>
        <translation>Mot de passe du serveur</translation>
    </message>
    <message>
        <source>Copy &amp;recordings, too</source>
        <translation>Copier aussi les &amp;enregistrements</translation>
    </message>
    <message>
        <source>&amp;Publish now</source>
        <translation>&amp;Publier maintenant</translation>
    </message>
    <message>
        <source>Pu&amp;ll now</source>
        <translation>&amp;Recevoir maintenant</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Déconnecter</translation>
    </message>
    <message>
        <source>Send to the hub what is pending. Odograph also does this by itself.</source>
        <translation>Envoyer au serveur ce qui est en attente. Odograph le fait aussi de lui-même.</translation>
    </message>
    <message>
        <source>Receive class lists, tasks and the trials of other benches</source>
        <translation>Recevoir les listes de classe, les épreuves et les essais des autres postes</translation>
    </message>
    <message>
        <source>To and from the school&apos;s folder for recordings; this can take long</source>
        <translation>Vers et depuis le dossier d’enregistrements de l’école&#xa0;; cela peut être long</translation>
    </message>
    <message>
        <source>Log &amp;in</source>
        <translation>&amp;S’identifier</translation>
    </message>
    <message>
        <source>Pass&amp;word:</source>
        <translation>M&amp;ot de passe&#xa0;:</translation>
    </message>
    <message>
        <source>How the project is connected</source>
        <translation>Comment le projet est connecté</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Connexion</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>pas encore</translation>
    </message>
    <message>
        <source>Hub</source>
        <translation>Serveur</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>Schema</source>
        <translation>Schéma</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Last exchange</source>
        <translation>Dernier échange</translation>
    </message>
    <message>
        <source>Still to be sent</source>
        <translation>Reste à envoyer</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Enregistrements</translation>
    </message>
    <message>
        <source>No folder: they stay at this bench</source>
        <translation>Aucun dossier&#xa0;: ils restent à ce poste</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Changed twice: %n…</source>
        <translation>
            <numerusform>Modifié deux &amp;fois&#xa0;: %n…</numerusform>
            <numerusform>Modifiés deux &amp;fois&#xa0;: %n…</numerusform>
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
        <translation>compte</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>douteux</translation>
    </message>
    <message>
        <source>does not count</source>
        <translation>ne compte pas</translation>
    </message>
    <message>
        <source>another course</source>
        <translation>autre parcours</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Épreuve</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Standings</source>
        <translation>Classement</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Poste</translation>
    </message>
</context>
<context>
    <name>odo::HubRunsPanel</name>
    <message>
        <source>Trials of all benches</source>
        <translation>Essais de tous les postes</translation>
    </message>
    <message>
        <source>Search trials and teams…</source>
        <translation>Chercher des essais et des équipes…</translation>
    </message>
    <message>
        <source>Search the hub</source>
        <translation>Chercher sur le serveur</translation>
    </message>
    <message>
        <source>Three letters or more</source>
        <translation>Trois lettres ou plus</translation>
    </message>
    <message>
        <source>Runs at the hub</source>
        <translation>Parcours sur le serveur</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Recherche…</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n parcours</numerusform>
            <numerusform>%n parcours</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the newest %n run(s)</source>
        <translation>
            <numerusform>le dernier parcours</numerusform>
            <numerusform>les %n derniers parcours</numerusform>
        </translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Poste</translation>
    </message>
    <message>
        <source>All benches</source>
        <translation>Tous les postes</translation>
    </message>
</context>
<context>
    <name>odo::ImageArea</name>
    <message>
        <source>No view</source>
        <translation>Aucune vue</translation>
    </message>
    <message>
        <source>This camera was not recording at this time</source>
        <translation>Cette caméra n’enregistrait pas à cet instant</translation>
    </message>
</context>
<context>
    <name>odo::ImageBars</name>
    <message>
        <source>Error of each image, with a threshold</source>
        <translation>Erreur de chaque photo, avec un seuil</translation>
    </message>
    <message>
        <source>%1: %2 px</source>
        <translation>%1&#xa0;: %2 px</translation>
    </message>
    <message>
        <source>images; rejected above %1 px</source>
        <translation>photos&#xa0;; au-delà de %1 px, elles ne comptent pas</translation>
    </message>
</context>
<context>
    <name>odo::ImageChoice</name>
    <message>
        <source>The camera&apos;s &amp;newest recording</source>
        <translation>Dans le &amp;dernier enregistrement de la caméra</translation>
    </message>
    <message>
        <source>The current image of a &amp;connected camera</source>
        <translation>Dans ce que voit maintenant une caméra c&amp;onnectée</translation>
    </message>
    <message>
        <source>An image or a &amp;video</source>
        <translation>Dans une &amp;photo ou une vidéo</translation>
    </message>
</context>
<context>
    <name>odo::ImportLessonDialog</name>
    <message>
        <source>Robots in the trials</source>
        <translation>Robots des essais</translation>
    </message>
    <message>
        <source>Import a lesson</source>
        <translation>Importer une leçon</translation>
    </message>
    <message>
        <source>Clips that were recorded at the same time belong to one trial. Untick what is no run; names and teams can be changed.</source>
        <translation>Les vidéos enregistrées au même moment appartiennent à un essai. Décochez ce qui n’est pas un parcours ; les noms et les équipes peuvent être changés.</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>É&amp;preuve</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>R&amp;obots</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>Caméra de la vue %1</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Team of row %1</source>
        <translation>Équipe de la ligne %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>no clip</source>
        <translation>pas de vidéo</translation>
    </message>
    <message>
        <source>Each trial needs a name of its own.</source>
        <translation>Chaque essai doit avoir son propre nom.</translation>
    </message>
    <message>
        <source>Tick the trials to import.</source>
        <translation>Cochez les essais à importer.</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Clip of %1</source>
        <translation>Vidéo de %1</translation>
    </message>
    <message>
        <source>Each column of clips needs a camera.</source>
        <translation>Chaque colonne de vidéos doit avoir une caméra.</translation>
    </message>
    <message>
        <source>Two clips of %1 are of the same camera.</source>
        <translation>Deux vidéos de %1 sont de la même caméra.</translation>
    </message>
</context>
<context>
    <name>odo::ImportTracksDialog</name>
    <message>
        <source>Add &amp;robot</source>
        <translation>A&amp;jouter un robot</translation>
    </message>
    <message>
        <source>Import finished tracks</source>
        <translation>Importer des trajectoires</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>É&amp;preuve</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Trajectoires</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Robot of track %1</source>
        <translation>Robot de la trajectoire %1</translation>
    </message>
    <message>
        <source>A new name creates a new robot</source>
        <translation>Un nom nouveau crée un nouveau robot</translation>
    </message>
    <message>
        <source>File of track %1</source>
        <translation>Fichier de la trajectoire %1</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>É&amp;quipe</translation>
    </message>
    <message>
        <source>Positions measured by another program or exported by Odograph: TUM, CSV, Tracker text and others. Odograph analyses them as a run without video.</source>
        <translation>Positions mesurées par un autre programme ou exportées par Odograph : TUM, CSV, texte de Tracker et autres. Odograph les analyse comme un parcours sans vidéo.</translation>
    </message>
    <message>
        <source>Tracks (*.csv *.txt *.tum *.tsv *.trc);;All files (*)</source>
        <translation>Trajectoires (*.csv *.txt *.tum *.tsv *.trc);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>odo::ImportTrialDialog</name>
    <message>
        <source>Robots in the trial</source>
        <translation>Robots de l’essai</translation>
    </message>
    <message>
        <source>Add &amp;view</source>
        <translation>Ajouter une &amp;vue</translation>
    </message>
    <message>
        <source>Camera&apos;s real &amp;rate</source>
        <translation>&amp;Cadence réelle de la caméra</translation>
    </message>
    <message>
        <source>Import trial from videos</source>
        <translation>Importer les vidéos d’un essai</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>É&amp;quipe</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>É&amp;preuve</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>R&amp;obots</translation>
    </message>
    <message>
        <source>Videos</source>
        <translation>Vidéos</translation>
    </message>
    <message>
        <source>&amp;Synchronise</source>
        <translation>&amp;Synchronisation</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Video file</source>
        <translation>Fichier vidéo</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> images/s</translation>
    </message>
    <message>
        <source>Camera&apos;s real rate</source>
        <translation>Cadence réelle de la caméra</translation>
    </message>
    <message>
        <source>For slow motion: the file plays slower than the camera recorded it</source>
        <translation>Pour un ralenti&#xa0;: le fichier se lit plus lentement que la caméra ne l’a pris</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>Caméra de la vue %1</translation>
    </message>
    <message>
        <source>Video of view %1</source>
        <translation>Vidéo de la vue %1</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;All files (*)</source>
        <translation>Vidéos (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Registration of the camera of view %1</source>
        <translation>Localisation de la caméra de la vue %1</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>non indiquée</translation>
    </message>
    <message>
        <source>%1 has no time stamps and states no frame rate. Enter the rate of its camera.</source>
        <translation>%1 n&apos;a pas d&apos;horodatage et n&apos;indique aucune fréquence d&apos;images. Saisissez celle de la caméra.</translation>
    </message>
    <message>
        <source>Chapters of one recording are joined by +; images are given as their folder, or FOLDER/%06d.png, with the rate</source>
        <translation>Les chapitres d’un enregistrement sont réunis par + ; les images sont indiquées par leur dossier, ou FOLDER/%06d.png, avec la fréquence</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Essai %1</translation>
    </message>
</context>
<context>
    <name>odo::IntervalHistogram</name>
    <message>
        <source>Histogram of the frame intervals</source>
        <translation>Histogramme des intervalles entre images</translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2: %n interval(s)</source>
        <translation>
            <numerusform>%1 à %2 : %n intervalle</numerusform>
            <numerusform>%1 à %2 : %n intervalles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>longer than %1: %n interval(s)</source>
        <translation>
            <numerusform>plus de %1 : %n intervalle</numerusform>
            <numerusform>plus de %1 : %n intervalles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::IntervalPanel</name>
    <message>
        <source>%1: fewer than two frames</source>
        <translation>%1 : moins de deux images</translation>
    </message>
    <message>
        <source>%1: frames are %2 apart (%3 frames/s), from %4 to %5</source>
        <translation>%1 : images espacées de %2 (%3 images/s), de %4 à %5</translation>
    </message>
    <message>
        <source>jitter %1</source>
        <translation>gigue %1</translation>
    </message>
    <message>
        <source>no frame missing</source>
        <translation>aucune image manquante</translation>
    </message>
    <message>
        <source>%1 of %2 frames repeat the one before</source>
        <translation>%1 images sur %2 répètent la précédente</translation>
    </message>
    <message>
        <source>no frame repeated</source>
        <translation>aucune image répétée</translation>
    </message>
    <message>
        <source>Frame intervals</source>
        <translation>Intervalles entre images</translation>
    </message>
    <message>
        <source>bars by the logarithm of their number</source>
        <translation>barres selon le logarithme de leur nombre</translation>
    </message>
    <message>
        <source>Frame intervals of the views</source>
        <translation>Intervalles entre images des vues</translation>
    </message>
    <message>
        <source>This trial has no videos.</source>
        <translation>Cet essai n’a pas de vidéos.</translation>
    </message>
    <message numerus="yes">
        <source>%1 missing in %n gap(s)</source>
        <translation>
            <numerusform>%1 manquantes en %n endroit</numerusform>
            <numerusform>%1 manquantes en %n endroits</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::JobIndicator</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Cancel the running job</source>
        <translation>Annuler la tâche en cours</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Arrêt en cours…</translation>
    </message>
</context>
<context>
    <name>odo::JointDialog</name>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Uncertainty before</source>
        <translation>Précision avant</translation>
    </message>
    <message>
        <source>Uncertainty, joint</source>
        <translation>Précision ensemble</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marqueur</translation>
    </message>
    <message>
        <source>Off by, mm</source>
        <translation>Écart, mm</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>Register all cameras (joint)</source>
        <translation>Localiser toutes les caméras ensemble</translation>
    </message>
    <message>
        <source>This fits all cameras of layout %1 jointly to the markers they were registered with. Cameras that see the same markers then agree better, and wrongly measured markers show up.</source>
        <translation>Les caméras du plan %1 sont réajustées d’un coup, d’après les marqueurs qui ont servi à les localiser&#xa0;: là où elles voient les mêmes marqueurs, elles s’accordent mieux ensuite, et un marqueur mal mesuré est repéré.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Uncertainty of the tape measure</source>
        <translation>Erreur du mètre ruban</translation>
    </message>
    <message>
        <source>Marker positions &amp;measured to</source>
        <translation>Places des marqueurs &amp;mesurées à</translation>
    </message>
    <message>
        <source>Fitting the cameras jointly…</source>
        <translation>Ajustement commun des caméras…</translation>
    </message>
    <message>
        <source>The joint uncertainty assumes marker positions measured to %1 mm; registering a single camera assumes them exact. Nothing changes until you save; trials keep the registration they were analysed with.</source>
        <translation>L’ajustement commun tient compte de ce que les places des marqueurs sont mesurées à %1 mm près, alors qu’une caméra localisée seule les prend comme exactes. Rien n’est modifié avant que vous enregistriez&#xa0;; les essais gardent la localisation avec laquelle ils ont été analysés.</translation>
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
        <translation>mesurez-le de nouveau</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>concorde</translation>
    </message>
</context>
<context>
    <name>odo::KeysPage</name>
    <message>
        <source>&amp;Use this key</source>
        <translation>&amp;Utiliser</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>S&amp;ans raccourci</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>Tout par &amp;défaut</translation>
    </message>
    <message>
        <source>Search for a command or a key</source>
        <translation>Chercher une commande ou un raccourci</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Commandes et leurs raccourcis</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>New key for the selected command</source>
        <translation>Nouveau raccourci de la commande choisie</translation>
    </message>
    <message>
        <source>Select a command to change its key.</source>
        <translation>Choisissez une commande pour lui donner un autre raccourci.</translation>
    </message>
    <message>
        <source>%1 is the key of “%2”. That command would lose it.</source>
        <translation>%1 est le raccourci de «&#xa0;%2&#xa0;», qui n’en aurait plus.</translation>
    </message>
    <message>
        <source>Press the new key in the field.</source>
        <translation>Tapez le nouveau raccourci dans le champ.</translation>
    </message>
</context>
<context>
    <name>odo::LayoutDialog</name>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>Tableaux (*.csv *.txt);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Marker layout</source>
        <translation>Plan de marqueurs</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Ce qui ne va pas</translation>
    </message>
    <message>
        <source>Enter the floor positions of the markers, measured with a tape in millimetres from the origin. Seen from above, X points right and Y away from you.</source>
        <translation>Où se trouvent les marqueurs au sol, mesuré au mètre ruban&#xa0;: en millimètres depuis l’origine. Vu de dessus, X va vers la droite, Y s’éloigne de vous.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Libellé</translation>
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
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>A&amp;jouter</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>A&amp;xes</translation>
    </message>
    <message>
        <source>&amp;CSV</source>
        <translation>&amp;CSV</translation>
    </message>
    <message>
        <source>&amp;Origin at the chosen marker</source>
        <translation>&amp;Origine au marqueur choisi</translation>
    </message>
    <message>
        <source>&amp;Quarter turn</source>
        <translation>&amp;Quart de tour</translation>
    </message>
    <message>
        <source>&amp;Half turn</source>
        <translation>&amp;Demi-tour</translation>
    </message>
    <message>
        <source>Convert from &amp;centimetres</source>
        <translation>C’étaient des &amp;centimètres</translation>
    </message>
    <message>
        <source>Convert from &amp;metres</source>
        <translation>C’étaient des &amp;mètres</translation>
    </message>
    <message>
        <source>Convert from &amp;inches</source>
        <translation>C’étaient des &amp;pouces</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>Positions of the markers (label,x_mm,y_mm)</source>
        <translation>Places des marqueurs (label,x_mm,y_mm)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <source>Positions of the markers</source>
        <translation>Places des marqueurs</translation>
    </message>
    <message>
        <source>The layout has no name.</source>
        <translation>Le plan n’a pas de nom.</translation>
    </message>
    <message>
        <source>A layout with this name exists, and cameras may use it. Enter another name.</source>
        <translation>Il existe un plan de ce nom&#xa0;: des caméras peuvent en dépendre, il n’est donc pas écrasé. Donnez un autre nom.</translation>
    </message>
    <message>
        <source>A marker has no label.</source>
        <translation>Un marqueur n’a pas de libellé.</translation>
    </message>
    <message>
        <source>Two markers are called %1.</source>
        <translation>Deux marqueurs s’appellent %1.</translation>
    </message>
    <message>
        <source>The position of %1 is not a number.</source>
        <translation>La place de %1 n’est pas un nombre.</translation>
    </message>
    <message>
        <source>The layout needs four markers; it has %1.</source>
        <translation>Il faut quatre marqueurs, il y en a %1.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same position.</source>
        <translation>%1 et %2 sont au même endroit.</translation>
    </message>
    <message>
        <source>The markers are nearly on a line and cannot determine the camera position. Move one to the side.</source>
        <translation>Les marqueurs sont presque alignés&#xa0;: ils ne disent pas où se trouve la caméra. Écartez-en un de la ligne.</translation>
    </message>
</context>
<context>
    <name>odo::LayoutDrawing</name>
    <message>
        <source>Markers from above</source>
        <translation>Marqueurs vus de dessus</translation>
    </message>
    <message>
        <source>grid %1 m</source>
        <translation>grille de %1 m</translation>
    </message>
</context>
<context>
    <name>odo::LengthPage</name>
    <message>
        <source>S&amp;nap to what is near a click</source>
        <translation>Prendre ce qui est &amp;près d’un clic</translation>
    </message>
    <message>
        <source>Image with both ends; arrow keys move the selected one, Space snaps it</source>
        <translation>Image avec les deux extrémités&#xa0;; les flèches déplacent celle choisie, Espace l’ajuste</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Measured length</source>
        <translation>Longueur mesurée</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>True length</source>
        <translation>Longueur vraie</translation>
    </message>
    <message>
        <source>Unit of the true length</source>
        <translation>Unité de la longueur vraie</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>on the floor</source>
        <translation>posé au sol</translation>
    </message>
    <message>
        <source>&amp;True length</source>
        <translation>&amp;Longueur vraie</translation>
    </message>
    <message>
        <source>H&amp;eight</source>
        <translation>&amp;Hauteur</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Extrémité</translation>
    </message>
    <message>
        <source>Seen as</source>
        <translation>Vu comme</translation>
    </message>
    <message>
        <source>On the floor, mm</source>
        <translation>Au sol, mm</translation>
    </message>
    <message>
        <source>Ends of the length</source>
        <translation>Extrémités de la longueur</translation>
    </message>
    <message>
        <source>Both ends</source>
        <translation>Les deux extrémités</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Ce que c’est</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Put an object of known length anywhere on the floor, such as a metre stick or two markers at a known distance, and click both ends. Keys: arrows move an end (Ctrl: fast, Shift: one pixel), Space snaps it.</source>
        <translation>Posez n’importe où au sol un objet de longueur connue, une règle d’un mètre ou deux marqueurs dont la distance est connue, et cliquez sur ses deux extrémités. Au clavier&#xa0;: les flèches déplacent une extrémité (Ctrl&#xa0;: vite, Maj&#xa0;: un pixel), Espace l’ajuste.</translation>
    </message>
    <message>
        <source>%1 ± %2 mm</source>
        <translation>%1 ± %2 mm</translation>
    </message>
    <message>
        <source>within uncertainty</source>
        <translation>dans l’erreur attendue</translation>
    </message>
    <message>
        <source>outside uncertainty</source>
        <translation>hors de l’erreur attendue</translation>
    </message>
    <message>
        <source> Enter its true length to check the result.</source>
        <translation> Donnez sa longueur vraie pour voir si c’est juste.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>beyond the horizon</source>
        <translation>au-delà de l’horizon</translation>
    </message>
    <message>
        <source>not set yet</source>
        <translation>pas encore placée</translation>
    </message>
</context>
<context>
    <name>odo::LengthWizard</name>
    <message>
        <source>Check a known length</source>
        <translation>Vérifier une longueur connue</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Terminer</translation>
    </message>
    <message>
        <source>Image or video of the length</source>
        <translation>Photo ou vidéo de la longueur</translation>
    </message>
    <message>
        <source>The camera and its image</source>
        <translation>La caméra et son image</translation>
    </message>
    <message>
        <source>Both ends of the length</source>
        <translation>Les deux extrémités de la longueur</translation>
    </message>
    <message>
        <source>Put an object of known length on the floor, away from the markers, to check the camera&apos;s stated uncertainty. This changes nothing.</source>
        <translation>Posez au sol un objet de longueur connue, loin des marqueurs, et voyez si la caméra le mesure aussi bien qu’elle le promet. Cela ne modifie rien.</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>C&amp;améra</translation>
    </message>
    <message>
        <source>Image of the length</source>
        <translation>Où l’on voit la longueur</translation>
    </message>
    <message>
        <source>Loading the image…</source>
        <translation>Lecture de l’image…</translation>
    </message>
    <message>
        <source>Choose an image or a video.</source>
        <translation>Choisissez une image ou une vidéo.</translation>
    </message>
</context>
<context>
    <name>odo::LensWizard</name>
    <message>
        <source>Calibrate camera</source>
        <translation>Étalonner une caméra</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>The camera and the board</source>
        <translation>La caméra et la mire</translation>
    </message>
    <message>
        <source>Images of the board</source>
        <translation>Photos de la mire</translation>
    </message>
    <message>
        <source>The lens</source>
        <translation>L’objectif</translation>
    </message>
    <message>
        <source>At least %1 images that show the board are needed; so far there are %2.</source>
        <translation>Il faut au moins %1 images montrant la mire ; il y en a %2 pour l’instant.</translation>
    </message>
    <message>
        <source>There is no lens calibration to save yet.</source>
        <translation>Il n’y a pas encore d’étalonnage de l’objectif à enregistrer.</translation>
    </message>
    <message numerus="yes">
        <source>%n image(s) of the board</source>
        <translation>
            <numerusform>%n image de la mire</numerusform>
            <numerusform>%n images de la mire</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::LessonBar</name>
    <message>
        <source>Ne&amp;xt</source>
        <translation>Suiva&amp;nt</translation>
    </message>
    <message>
        <source>&amp;Leave the lesson</source>
        <translation>&amp;Quitter la leçon</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Leçon</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>étape %1 sur %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Terminer</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Suivant</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>Passe&amp;r</translation>
    </message>
</context>
<context>
    <name>odo::LiveBoard</name>
    <message>
        <source>Top-down map</source>
        <translation>Carte vue de dessus</translation>
    </message>
    <message>
        <source>Health of cameras, map and disk</source>
        <translation>L’état des caméras, de la carte et du disque</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>Live view of %1</source>
        <translation>Image en direct de %1</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>non localisée</translation>
    </message>
    <message>
        <source>Opening the camera…</source>
        <translation>Ouverture de la caméra…</translation>
    </message>
    <message>
        <source>live, sent to %1</source>
        <translation>en direct, envoyé à %1</translation>
    </message>
    <message>
        <source>live</source>
        <translation>en direct</translation>
    </message>
    <message>
        <source>Waiting for the first frame…</source>
        <translation>En attente de la première image…</translation>
    </message>
    <message>
        <source>No frames now</source>
        <translation>Pas d’image en ce moment</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 images/s</translation>
    </message>
</context>
<context>
    <name>odo::LiveCameraBox</name>
    <message>
        <source>Connected camera</source>
        <translation>Caméra connectée</translation>
    </message>
    <message>
        <source>%1, %2×%3</source>
        <translation>%1, %2×%3</translation>
    </message>
    <message>
        <source>Searching for cameras…</source>
        <translation>Recherche des caméras…</translation>
    </message>
    <message>
        <source>No camera is connected</source>
        <translation>Aucune caméra n’est connectée</translation>
    </message>
</context>
<context>
    <name>odo::LiveMap</name>
    <message>
        <source>Live floor map with the robots</source>
        <translation>Carte du sol avec les robots qui roulent</translation>
    </message>
    <message>
        <source>No camera is registered to the floor: robots cannot be located</source>
        <translation>Aucune caméra n’est localisée par rapport au sol&#xa0;: aucune place n’y peut être donnée</translation>
    </message>
</context>
<context>
    <name>odo::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>Pr&amp;eferences…</source>
        <translation>Pré&amp;férences…</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>A recording is running. The change takes effect when you reopen the project.</source>
        <translation>Les pages suivront à la réouverture du projet, car un enregistrement est en cours.</translation>
    </message>
    <message>
        <source>Restore the backup</source>
        <translation>Restaurer la copie de sauvegarde</translation>
    </message>
    <message>
        <source>Another program deleted, renamed or replaced “%1”. Odograph will rescue its contents when the running job has ended.</source>
        <translation>« %1 » a été supprimé, renommé ou remplacé par un autre programme. Son contenu sera récupéré dès que le travail en cours sera terminé.</translation>
    </message>
    <message>
        <source>Another program deleted, renamed or replaced “%1”. Odograph rescued its contents in “%2” and opened that project.</source>
        <translation>« %1 » a été supprimé, renommé ou remplacé par un autre programme. Son contenu a été récupéré dans « %2 », qui est maintenant ouvert.</translation>
    </message>
    <message>
        <source>Another program overwrote “%1”. Odograph will open the new contents when the running job has ended.</source>
        <translation>Un autre programme a écrasé « %1 ». Son contenu actuel sera ouvert dès que le travail en cours sera terminé.</translation>
    </message>
    <message>
        <source>Another program renamed “%1” and its videos. It is now open as “%2”.</source>
        <translation>Un autre programme a renommé « %1 » avec ses vidéos. Il est maintenant ouvert sous le nom « %2 ».</translation>
    </message>
    <message>
        <source>Another program overwrote “%1” while it was open. Its earlier contents are gone; the window shows the new ones.</source>
        <translation>Un autre programme a écrasé « %1 » pendant qu’il était ouvert : son contenu précédent est perdu. Son contenu actuel est affiché.</translation>
    </message>
    <message>
        <source>C&amp;lass</source>
        <translation>C&amp;lasse</translation>
    </message>
    <message>
        <source>You and another bench changed the same things. Both versions are kept.</source>
        <translation>Vous et un autre poste avez modifié la même chose. Les deux versions sont conservées.</translation>
    </message>
    <message>
        <source>Show both</source>
        <translation>Afficher les deux</translation>
    </message>
</context>
<context>
    <name>odo::MapArea</name>
    <message>
        <source>0 to %1 apart</source>
        <translation>écart de 0 à %1</translation>
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
        <translation>É&amp;toile</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>&amp;Archiver</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>&amp;Empty the bin…</source>
        <translation>&amp;Vider la corbeille…</translation>
    </message>
    <message>
        <source>Remove &amp;star</source>
        <translation>Retirer l’é&amp;toile</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>Dés&amp;archiver</translation>
    </message>
    <message>
        <source>Rest&amp;ore</source>
        <translation>Re&amp;staurer</translation>
    </message>
    <message>
        <source>Restore the selected trials from the bin (Del)</source>
        <translation>Sort les essais sélectionnés de la corbeille (Suppr)</translation>
    </message>
    <message>
        <source>Move the selected trials to the bin (Del); you can restore them</source>
        <translation>Met les essais sélectionnés à la corbeille (Suppr)&#xa0;; ils peuvent être restaurés</translation>
    </message>
    <message>
        <source>Empty the bin</source>
        <translation>Vider la corbeille</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n trial(s) for good?</source>
        <translation>
            <numerusform>Supprimer définitivement %n essai&#xa0;?</numerusform>
            <numerusform>Supprimer définitivement %n essais&#xa0;?</numerusform>
        </translation>
    </message>
    <message>
        <source>This removes their videos (%1), measurements and results from the disk. You cannot undo it.</source>
        <translation>Leurs vidéos (%1), leurs mesures et leurs résultats sont supprimés du disque. Cela ne peut pas être annulé.</translation>
    </message>
    <message>
        <source>&amp;Remove for good</source>
        <translation>&amp;Supprimer définitivement</translation>
    </message>
</context>
<context>
    <name>odo::MarkerCanvas</name>
    <message>
        <source>Image with the markers; arrow keys move the selected one</source>
        <translation>Image avec les marqueurs&#xa0;; les flèches déplacent celui choisi</translation>
    </message>
</context>
<context>
    <name>odo::MarkerPage</name>
    <message>
        <source>&amp;Remove</source>
        <translation>Re&amp;tirer</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marqueur</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>Place, mm</translation>
    </message>
    <message>
        <source>Seen as</source>
        <translation>Vu comme</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>found</source>
        <translation>trouvé</translation>
    </message>
    <message>
        <source>Select a marker in the table and click its position. The click snaps to what is near it, to a tenth of a pixel.</source>
        <translation>Choisissez un marqueur dans le tableau et cliquez là où il est&#xa0;; ce qui est près du clic est repéré au dixième de pixel.</translation>
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
        <translation>non vu</translation>
    </message>
</context>
<context>
    <name>odo::MatDialog</name>
    <message>
        <source>Find the floor mat</source>
        <translation>Chercher le tapis de sol</translation>
    </message>
    <message>
        <source>The mat is searched for in the newest recording of each camera: %1.</source>
        <translation>Le tapis est cherché dans l’enregistrement le plus récent de chaque caméra : %1.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Measure the line at the mat&apos;s lower edge from end mark to end mark. Printers often shrink by 2 to 4 %; what you enter makes up for it.</source>
        <translation>Mesurez la ligne au bord inférieur du tapis d’une marque à l’autre. Les imprimantes réduisent souvent de 2 à 4 % ; votre valeur le compense.</translation>
    </message>
    <message>
        <source>&amp;Check line</source>
        <translation>Ligne de &amp;contrôle</translation>
    </message>
    <message>
        <source>Find the mat</source>
        <translation>Chercher le tapis</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesurée</translation>
    </message>
</context>
<context>
    <name>odo::MessageBar</name>
    <message>
        <source>Close the message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was changed.</source>
        <translation>Annulé. Rien n’a été modifié.</translation>
    </message>
</context>
<context>
    <name>odo::MetricGrid</name>
    <message>
        <source>Metrics</source>
        <translation>Grandeurs</translation>
    </message>
    <message>
        <source>No result yet: track the trial</source>
        <translation>Pas encore de résultat&#xa0;: suivez l’essai</translation>
    </message>
</context>
<context>
    <name>odo::MetricModel</name>
    <message>
        <source>Metric</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
</context>
<context>
    <name>odo::ModeBar</name>
    <message>
        <source>Modes</source>
        <translation>Modes</translation>
    </message>
</context>
<context>
    <name>odo::NetworkPage</name>
    <message>
        <source>&amp;Send live positions on the network</source>
        <translation>&amp;Envoyer les positions en direct sur le réseau</translation>
    </message>
    <message>
        <source>%1: this computer only</source>
        <translation>%1&#xa0;: cette machine seulement</translation>
    </message>
    <message>
        <source>%1: not available now</source>
        <translation>%1&#xa0;: absente en ce moment</translation>
    </message>
    <message>
        <source>Positions of the robots that Record tracks, as SSL-Vision packets for your own controllers and programs. The packets contain no names of teams or robots.</source>
        <translation>Les places des robots que suit «&#xa0;Filmer&#xa0;», en paquets SSL-Vision, pour des contrôleurs et vos propres programmes. Ils ne contiennent aucun nom d’équipe ni de robot.</translation>
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
        <translation>&amp;Interface</translation>
    </message>
    <message>
        <source>Odograph sends nothing.</source>
        <translation>Rien n’est envoyé.</translation>
    </message>
    <message>
        <source>This is not an IPv4 address; enter one such as 224.5.23.2.</source>
        <translation>Ce n’est pas une adresse IPv4&#xa0;; écrivez-la comme 224.5.23.2.</translation>
    </message>
    <message>
        <source>They go only to the computer with this address.</source>
        <translation>Elles vont à la seule machine qui a cette adresse.</translation>
    </message>
    <message>
        <source>They do not leave this computer.</source>
        <translation>Elles ne quittent pas cette machine.</translation>
    </message>
    <message>
        <source>Anyone on that network can read the robots&apos; positions.</source>
        <translation>Quiconque est sur ce réseau peut lire où sont les robots.</translation>
    </message>
</context>
<context>
    <name>odo::NumberText</name>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
</context>
<context>
    <name>odo::PathField</name>
    <message>
        <source>Browse…</source>
        <translation>Parcourir…</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>Parcourir&#xa0;: %1</translation>
    </message>
    <message>
        <source>Images and videos (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov *.webm);;All files (*)</source>
        <translation>Photos et vidéos (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov *.webm);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>odo::PathSketch</name>
    <message>
        <source>The path from above</source>
        <translation>Le parcours vu d’en haut</translation>
    </message>
</context>
<context>
    <name>odo::PickColourDialog</name>
    <message>
        <source>Pick the robot&apos;s colour</source>
        <translation>Couleur du robot d’après une image</translation>
    </message>
    <message>
        <source>Another &amp;video…</source>
        <translation>Autre &amp;vidéo…</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>&amp;Enregistrement</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>&amp;Image</translation>
    </message>
    <message>
        <source>Choose a video that shows the robot.</source>
        <translation>Choisissez une vidéo où l’on voit le robot.</translation>
    </message>
    <message>
        <source>Use this colour</source>
        <translation>Prendre cette couleur</translation>
    </message>
    <message>
        <source>Video that shows the robot</source>
        <translation>Vidéo où l’on voit le robot</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mov *.mkv *.avi *.m4v);;All files (*)</source>
        <translation>Vidéos (*.mp4 *.mov *.mkv *.avi *.m4v);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>The robot&apos;s colour here: %1. It fills %2 % of the box.</source>
        <translation>La couleur du robot ici&#xa0;: %1. Elle remplit %2&#xa0;% du cadre.</translation>
    </message>
    <message>
        <source>Draw a tight box round the robot with the mouse, or use the keyboard: arrow keys move the box, Shift + arrow keys resize it.</source>
        <translation>Tracez à la souris un cadre serré autour du robot&#xa0;; ou avec les flèches, qui déplacent le cadre et, avec Maj, l’agrandissent ou le réduisent.</translation>
    </message>
    <message>
        <source>%1, camera %2</source>
        <translation>%1, caméra %2</translation>
    </message>
</context>
<context>
    <name>odo::PlannedCameraForm</name>
    <message>
        <source>Position x</source>
        <translation>Placée en x</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>Placée en y</translation>
    </message>
    <message>
        <source>Height of the camera</source>
        <translation>Hauteur de la caméra</translation>
    </message>
    <message>
        <source>Looks at x</source>
        <translation>Regarde en x</translation>
    </message>
    <message>
        <source>Looks at y</source>
        <translation>Regarde en y</translation>
    </message>
    <message>
        <source>Viewing direction</source>
        <translation>Direction où elle regarde</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Champ de vision</translation>
    </message>
    <message>
        <source>0° is along X, 90° along Y; the point that the camera looks at turns with it</source>
        <translation>0°&#xa0;: le long de X, 90°&#xa0;: le long de Y&#xa0;; la tourner fait tourner autour de la caméra le point qu’elle regarde</translation>
    </message>
    <message>
        <source>Across the image width: a webcam has about 60° to 80°, a phone 65°</source>
        <translation>Sur la largeur de l’image&#xa0;: une webcam a environ 60° à 80°, un téléphone 65°</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>Taille de ses images</translation>
    </message>
    <message>
        <source>Po&amp;sition x, y</source>
        <translation>Placée en &amp;x, y</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>Hau&amp;teur</translation>
    </message>
    <message>
        <source>&amp;Looks at x, y</source>
        <translation>Regarde e&amp;n x, y</translation>
    </message>
    <message>
        <source>D&amp;irection</source>
        <translation>D&amp;irection</translation>
    </message>
    <message>
        <source>&amp;Field of view</source>
        <translation>&amp;Champ de vision</translation>
    </message>
</context>
<context>
    <name>odo::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>Categories of preferences</source>
        <translation>Catégories de préférences</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;Général</translation>
    </message>
    <message>
        <source>&amp;Reports</source>
        <translation>&amp;Rapports</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>Racc&amp;ourcis</translation>
    </message>
    <message>
        <source>&amp;Network</source>
        <translation>Ré&amp;seau</translation>
    </message>
</context>
<context>
    <name>odo::ProfileChart</name>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Cap</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Vitesse angulaire</translation>
    </message>
    <message>
        <source>Position X</source>
        <translation>Position X</translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation>Position Y</translation>
    </message>
    <message>
        <source>Quantity of the chart</source>
        <translation>Grandeur que montre le graphique</translation>
    </message>
    <message>
        <source>smoothed ±95 %</source>
        <translation>lissé ±95&#xa0;%</translation>
    </message>
    <message>
        <source>measured points</source>
        <translation>points mesurés</translation>
    </message>
    <message>
        <source>1 spike</source>
        <translation>1 pic aberrant</translation>
    </message>
    <message>
        <source>%1 spikes</source>
        <translation>%1 pics aberrants</translation>
    </message>
    <message>
        <source>along the path</source>
        <translation>le long de la trajectoire</translation>
    </message>
    <message>
        <source>of the motion, anticlockwise from X</source>
        <translation>du mouvement, sens trigonométrique depuis X</translation>
    </message>
    <message>
        <source>anticlockwise positive</source>
        <translation>positif dans le sens trigonométrique</translation>
    </message>
    <message>
        <source>Chart: %1 over time</source>
        <translation>Graphique&#xa0;: %1 selon le temps</translation>
    </message>
    <message>
        <source>Chart: %1 over distance</source>
        <translation>Graphique&#xa0;: %1 selon la distance</translation>
    </message>
    <message>
        <source>of the body, anticlockwise from X</source>
        <translation>du corps, sens trigonométrique depuis X</translation>
    </message>
    <message>
        <source>shaded: hidden, ambiguous or not measured</source>
        <translation>ombré&#xa0;: caché, en doute ou non mesuré</translation>
    </message>
    <message>
        <source>Velocity X</source>
        <translation>Vitesse X</translation>
    </message>
    <message>
        <source>Velocity Y</source>
        <translation>Vitesse Y</translation>
    </message>
    <message>
        <source>Lateral acceleration</source>
        <translation>Accélération latérale</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>À-coup</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>Distance parcourue</translation>
    </message>
    <message>
        <source>Distance from the start</source>
        <translation>Distance au départ</translation>
    </message>
    <message>
        <source>to the left positive</source>
        <translation>positive à gauche</translation>
    </message>
    <message>
        <source>along the path, mean over %1</source>
        <translation>le long de la trajectoire, moyenne sur %1</translation>
    </message>
    <message>
        <source>Distance to the nearest robot</source>
        <translation>Distance au robot le plus proche</translation>
    </message>
</context>
<context>
    <name>odo::RangeActions</name>
    <message>
        <source>Set &amp;start here</source>
        <translation>Fixer le &amp;début ici</translation>
    </message>
    <message>
        <source>The results are of the run from this time on; before it nothing counts.</source>
        <translation>Les résultats portent sur le parcours à partir de ce moment ; ce qui précède ne compte pas.</translation>
    </message>
    <message>
        <source>Set &amp;end here</source>
        <translation>Fixer la &amp;fin ici</translation>
    </message>
    <message>
        <source>The results are of the run up to this time; after it nothing counts.</source>
        <translation>Les résultats portent sur le parcours jusqu’à ce moment ; ce qui suit ne compte pas.</translation>
    </message>
    <message>
        <source>From first to last &amp;motion</source>
        <translation>Du premier au dernier &amp;mouvement</translation>
    </message>
    <message>
        <source>The results are of the run from when a robot first moves to when it last does.</source>
        <translation>Les résultats portent sur le parcours du premier au dernier mouvement d’un robot.</translation>
    </message>
    <message>
        <source>&amp;Whole run</source>
        <translation>Parcours &amp;entier</translation>
    </message>
    <message>
        <source>The results are of all of the trial again.</source>
        <translation>Les résultats portent de nouveau sur tout l’essai.</translation>
    </message>
</context>
<context>
    <name>odo::RangeCard</name>
    <message>
        <source>&amp;Fit</source>
        <translation>A&amp;justement</translation>
    </message>
    <message>
        <source>Robot of the statistics</source>
        <translation>Robot dont la plage est montrée</translation>
    </message>
    <message>
        <source>Function to fit to the curve</source>
        <translation>Ce qui est ajusté à la courbe</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>constante</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>parabola</source>
        <translation>parabole</translation>
    </message>
    <message>
        <source>Fitted quantity</source>
        <translation>Grandeur ajustée</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Statistics of the selection</source>
        <translation>Grandeurs de la sélection</translation>
    </message>
</context>
<context>
    <name>odo::RecordPage</name>
    <message>
        <source>No camera is connected</source>
        <translation>Aucune caméra n’est connectée</translation>
    </message>
    <message>
        <source>Connect one or two cameras, then search again. If a connected camera is not found, run the set-up doctor.</source>
        <translation>Connectez une caméra, ou deux, et recherchez de nouveau. Si une caméra connectée n’est pas trouvée, voyez le diagnostic de l’installation.</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Set-up doctor…</source>
        <translation>Diagnostic…</translation>
    </message>
    <message>
        <source>Choose &amp;cameras…</source>
        <translation>Choisir les camé&amp;ras…</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>Caméras…</translation>
    </message>
    <message>
        <source>Assign the connected devices to the cameras of the project</source>
        <translation>Choisir quel appareil connecté est quelle caméra du projet</translation>
    </message>
    <message>
        <source>Set-up &amp;doctor…</source>
        <translation>&amp;Diagnostic de l’installation…</translation>
    </message>
    <message>
        <source>Doctor…</source>
        <translation>Diagnostic…</translation>
    </message>
    <message>
        <source>Check for what makes cameras lose frames or measure wrongly, and get advice</source>
        <translation>Chercher ce qui fait perdre des images aux caméras, ou fausse leurs mesures, avec des conseils</translation>
    </message>
    <message>
        <source>Give the trial a name</source>
        <translation>Donnez un nom à l’essai</translation>
    </message>
</context>
<context>
    <name>odo::ReferenceCameraPage</name>
    <message>
        <source>Image or video of the camera to register</source>
        <translation>Photo ou vidéo de la caméra à localiser</translation>
    </message>
    <message>
        <source>Image or video of the registered camera</source>
        <translation>Photo ou vidéo de la caméra localisée</translation>
    </message>
    <message>
        <source>A camera cannot be registered via itself: choose two different ones.</source>
        <translation>Une caméra ne peut pas être localisée par elle-même&#xa0;: choisissez deux caméras différentes.</translation>
    </message>
    <message>
        <source>Camera to register</source>
        <translation>Caméra à localiser</translation>
    </message>
    <message>
        <source>Registered camera</source>
        <translation>Caméra localisée</translation>
    </message>
    <message>
        <source>Register a camera that sees no markers by floor points that a registered camera also sees: corners of tiles, ends of tape, screws. Four are enough; six or more, spread over the common area, are better. Do not move either camera afterwards.</source>
        <translation>Une caméra qui ne voit pas de marqueurs peut être localisée par des points du sol qu’une caméra localisée voit aussi&#xa0;: coins de carreaux, bouts d’adhésif, vis. Quatre suffisent, six ou plus répartis sur la partie commune valent mieux. Aucune des deux caméras ne doit être déplacée ensuite.</translation>
    </message>
    <message>
        <source>C&amp;amera to register</source>
        <translation>C&amp;améra à localiser</translation>
    </message>
    <message>
        <source>&amp;Via camera</source>
        <translation>Par &amp;la caméra</translation>
    </message>
    <message>
        <source>Its image</source>
        <translation>Son image</translation>
    </message>
    <message>
        <source>The registered camera&apos;s image</source>
        <translation>L’image de la caméra localisée</translation>
    </message>
    <message>
        <source>Choose an image for each camera.</source>
        <translation>Choisissez une image pour chaque caméra.</translation>
    </message>
</context>
<context>
    <name>odo::RegisterViaCameraWizard</name>
    <message>
        <source>Register via another camera</source>
        <translation>Localiser par une autre caméra</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Two cameras and their images</source>
        <translation>Deux caméras et leurs images</translation>
    </message>
    <message>
        <source>The same points in both images</source>
        <translation>Les mêmes points dans les deux images</translation>
    </message>
    <message>
        <source>Loading the images…</source>
        <translation>Lecture des images…</translation>
    </message>
    <message>
        <source>There is no registration to save yet.</source>
        <translation>Il n’y a pas encore de localisation à enregistrer.</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>la localisation</translation>
    </message>
</context>
<context>
    <name>odo::RegistrationVerdict</name>
    <message>
        <source>Camera position</source>
        <translation>Où se trouve la caméra</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Camera position: x %1 m, y %2 m, %3 m above the floor.</source>
        <translation>Elle se trouve à x %1 m, y %2 m, %3 m au-dessus du sol.</translation>
    </message>
    <message>
        <source>The registration was not stored. %1</source>
        <translation>La localisation n’a pas été enregistrée. %1</translation>
    </message>
</context>
<context>
    <name>odo::ReportActions</name>
    <message>
        <source>The trial %1</source>
        <translation>L’essai %1</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>R&amp;apport…</translation>
    </message>
    <message>
        <source>The comparison of %1 and %2</source>
        <translation>La comparaison de %1 et %2</translation>
    </message>
    <message>
        <source>A class</source>
        <translation>Une classe</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s), a page each</source>
        <translation>
            <numerusform>%n essai, une page</numerusform>
            <numerusform>%n essais, une page chacun</numerusform>
        </translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>Fichiers PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report saved as %1.</source>
        <translation>Le rapport est dans %1.</translation>
    </message>
    <message>
        <source>Report sent to printer %1.</source>
        <translation>Le rapport est à l’imprimante %1.</translation>
    </message>
    <message>
        <source>Over the floor that the cameras see</source>
        <translation>Sur le sol que voient les caméras</translation>
    </message>
    <message>
        <source>The simulated run:</source>
        <translation>Le passage simulé&#xa0;:</translation>
    </message>
    <message>
        <source>Save the certificate</source>
        <translation>Enregistrer le certificat</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificat</translation>
    </message>
    <message>
        <source>Certificate saved as %1.</source>
        <translation>Le certificat est dans&#xa0;%1.</translation>
    </message>
    <message>
        <source>C&amp;ertificate of this set-up…</source>
        <translation>Cert&amp;ificat de cette installation…</translation>
    </message>
</context>
<context>
    <name>odo::ReportDialog</name>
    <message>
        <source>A page for each &amp;team</source>
        <translation>Une page par é&amp;quipe</translation>
    </message>
    <message>
        <source>A second page with the &amp;method</source>
        <translation>Une seconde page avec la &amp;méthode</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>&amp;Enregistrer en PDF…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Imprimer…</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>&amp;Classe</translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation>É&amp;preuve</translation>
    </message>
    <message>
        <source>Most common</source>
        <translation>La plus courante</translation>
    </message>
    <message>
        <source>M&amp;etric</source>
        <translation>&amp;Grandeur</translation>
    </message>
    <message>
        <source>Most informative</source>
        <translation>La plus parlante</translation>
    </message>
    <message>
        <source>Report &amp;of</source>
        <translation>Rappor&amp;t sur</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>P&amp;apier</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Lettre US</translation>
    </message>
    <message>
        <source>School, &amp;logo and wording…</source>
        <translation>Établissement, &amp;logo et texte…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Nothing to print yet.</source>
        <translation>Il n’y a encore rien à imprimer.</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n page</numerusform>
            <numerusform>%n pages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n page(s); the file has all of them.</source>
        <translation>
            <numerusform>La première page&#xa0;; le fichier les contient toutes.</numerusform>
            <numerusform>Les %n premières pages&#xa0;; le fichier les contient toutes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportPreview</name>
    <message>
        <source>Preview of the pages</source>
        <translation>Aperçu des pages</translation>
    </message>
    <message>
        <source>Drawing the pages…</source>
        <translation>Dessin des pages en cours…</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s)</source>
        <translation>
            <numerusform>%n page</numerusform>
            <numerusform>%n pages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::ReportsPage</name>
    <message>
        <source>&amp;School</source>
        <translation>É&amp;tablissement</translation>
    </message>
    <message>
        <source>shown at the top of each page</source>
        <translation>figure en tête de chaque page</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg *.svg)</source>
        <translation>Images (*.png *.jpg *.jpeg *.svg)</translation>
    </message>
    <message>
        <source>&amp;Logo</source>
        <translation>&amp;Logo</translation>
    </message>
    <message>
        <source>Preview of the logo</source>
        <translation>Aperçu du logo</translation>
    </message>
    <message>
        <source>&amp;At the bottom</source>
        <translation>Pied de p&amp;age</translation>
    </message>
    <message>
        <source>for example: whom to ask</source>
        <translation>par exemple&#xa0;: qui répond aux questions</translation>
    </message>
</context>
<context>
    <name>odo::ReprocessDialog</name>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>&amp;Reanalyse</source>
        <translation>&amp;Remesurer</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Garder</translation>
    </message>
    <message>
        <source>Reanalyse trials</source>
        <translation>Remesurer des essais</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changement</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Ce qui change</translation>
    </message>
    <message>
        <source>What changes, in words</source>
        <translation>Ce qui change, en mots</translation>
    </message>
    <message>
        <source>What was detected in the videos stays as it is; its floor positions are recomputed with the current registrations. Check what changes, then keep it or not: the older analysis stays in the project too.</source>
        <translation>Ce qui a été vu dans les vidéos reste tel quel&#xa0;; sa place au sol est calculée avec les localisations maintenant en vigueur. Voyez ce qui change, puis gardez-le ou non&#xa0;: l’analyse antérieure reste aussi dans le projet.</translation>
    </message>
    <message>
        <source>&amp;Trial</source>
        <translation>&amp;Essai</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>%1 (measured with an older registration)</source>
        <translation>%1 (mesuré avec une localisation antérieure)</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Mesure en cours…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Kept: the new analysis of %1 is the current one.</source>
        <translation>Gardé&#xa0;: la nouvelle analyse de %1 est l’actuelle.</translation>
    </message>
</context>
<context>
    <name>odo::ResidualPlot</name>
    <message>
        <source>Residual against the cut-off</source>
        <translation>Résidu selon la coupure</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>residual analysis</source>
        <translation>analyse des résidus</translation>
    </message>
    <message>
        <source>a filter of %1 takes away %2</source>
        <translation>un filtre de %1 retire %2</translation>
    </message>
</context>
<context>
    <name>odo::ResultPanel</name>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Robot whose result is shown</source>
        <translation>Robot dont le résultat est montré</translation>
    </message>
    <message>
        <source>robot “%1”</source>
        <translation>robot «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>odo::ReviewColumn</name>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Facts of the trial</source>
        <translation>Données de l’essai</translation>
    </message>
    <message>
        <source>This trial has not been tracked yet. Tracking follows the robot through the videos and computes its position and speed.</source>
        <translation>Cet essai n’a pas encore été suivi. Le suivi accompagne le robot dans les vidéos et détermine où il était et à quelle vitesse.</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>Suivre…</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>The areas have changed since this trial was tracked. Track it again to use them.</source>
        <translation>Les zones ont changé depuis le suivi de cet essai. Suivez-le à nouveau pour les utiliser.</translation>
    </message>
</context>
<context>
    <name>odo::ReviewDesk</name>
    <message>
        <source>&amp;Silhouettes of the robots</source>
        <translation>&amp;Silhouettes des robots</translation>
    </message>
    <message>
        <source>Outline the detected robots in each view</source>
        <translation>Trace dans chaque vue le contour de ce qui a été pris pour un robot</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Zoom avant</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom a&amp;rrière</translation>
    </message>
    <message>
        <source>Zoom to &amp;fit</source>
        <translation>A&amp;juster</translation>
    </message>
    <message>
        <source>&amp;Enlarge, or back</source>
        <translation>Agrandir la vue, ou reve&amp;nir</translation>
    </message>
    <message>
        <source>Of the view or map under the mouse</source>
        <translation>De la vue ou de la carte sous la souris</translation>
    </message>
    <message>
        <source>Lo&amp;upe on the robot</source>
        <translation>Lo&amp;upe sur le robot</translation>
    </message>
    <message>
        <source>Show the surroundings of the robot eight times as large as recorded</source>
        <translation>Montrer les alentours du robot huit fois plus grands que filmés</translation>
    </message>
</context>
<context>
    <name>odo::ReviewPage</name>
    <message>
        <source>No trials yet</source>
        <translation>Pas encore d’essai</translation>
    </message>
    <message>
        <source>A trial is one run of a robot. Import the videos that your cameras took of it to see it here.</source>
        <translation>Un essai est un passage d’un robot. Importez les vidéos que vos caméras en ont prises, et il sera montré ici.</translation>
    </message>
    <message>
        <source>Import trial from videos…</source>
        <translation>Importer les vidéos d’un essai…</translation>
    </message>
    <message>
        <source>Accept doubtful results</source>
        <translation>Accepter des résultats douteux</translation>
    </message>
    <message>
        <source>Why can these results be used? The reason is shown wherever they are.</source>
        <translation>Pourquoi ces résultats sont-ils utilisables ? La raison est affichée partout où ils apparaissent.</translation>
    </message>
</context>
<context>
    <name>odo::RevisionImage</name>
    <message>
        <source>Source image</source>
        <translation>Photo d’où elle provient</translation>
    </message>
    <message>
        <source>Reading the image…</source>
        <translation>Lecture de la photo…</translation>
    </message>
    <message>
        <source>Cannot read the image.</source>
        <translation>La photo ne peut pas être lue.</translation>
    </message>
</context>
<context>
    <name>odo::RevisionsDialog</name>
    <message>
        <source>&amp;Use this one</source>
        <translation>&amp;Utiliser celle-ci</translation>
    </message>
    <message>
        <source>&amp;Register with this calibration</source>
        <translation>&amp;Localiser avec cet objectif</translation>
    </message>
    <message>
        <source>Reanalyse &amp;trials…</source>
        <translation>&amp;Remesurer des essais…</translation>
    </message>
    <message>
        <source>Calibrations and registrations</source>
        <translation>Étalonnages et localisations</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Créé le</translation>
    </message>
    <message>
        <source>Odograph</source>
        <translation>Odograph</translation>
    </message>
    <message>
        <source>From</source>
        <translation>D’après</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>En vigueur</translation>
    </message>
    <message>
        <source>Revisions</source>
        <translation>Révisions</translation>
    </message>
    <message>
        <source>Makes the selected revision the current one for new measurements; trials keep theirs</source>
        <translation>Met la révision choisie en vigueur pour ce qui sera mesuré désormais&#xa0;; les essais gardent la leur</translation>
    </message>
    <message>
        <source>Recomputes the current registration from the same markers, with the current lens calibration</source>
        <translation>Recalcule la localisation en vigueur d’après les mêmes marqueurs, avec l’objectif en vigueur</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>C&amp;améra</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>The camera is neither calibrated nor registered yet.</source>
        <translation>La caméra n’est encore ni étalonnée ni localisée.</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Calibration %1</source>
        <translation>Étalonnage %1</translation>
    </message>
    <message>
        <source>Registration %1</source>
        <translation>Localisation %1</translation>
    </message>
    <message>
        <source>current</source>
        <translation>en vigueur</translation>
    </message>
    <message>
        <source>No trial uses it.</source>
        <translation>Aucun essai n’a été mesuré avec elle.</translation>
    </message>
    <message>
        <source>Trials that use it: %1.</source>
        <translation>Essais mesurés avec elle&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 is now current. The registrations keep the lens calibration that they were made with: register the camera with this one.</source>
        <translation>%1 est en vigueur. Les localisations gardent l’objectif avec lequel elles ont été faites&#xa0;: localisez la caméra avec celui-ci.</translation>
    </message>
    <message>
        <source>%1 is now current. Trials keep theirs until you reanalyse them.</source>
        <translation>%1 est en vigueur. Les essais gardent la leur jusqu’à ce qu’ils soient remesurés.</translation>
    </message>
    <message>
        <source>Registration %1 is now current: the same markers, with this lens calibration. %2</source>
        <translation>La localisation %1 est en vigueur&#xa0;: les mêmes marqueurs, avec cet objectif. %2</translation>
    </message>
</context>
<context>
    <name>odo::RobotDialog</name>
    <message>
        <source>Add robot</source>
        <translation>Ajouter un robot</translation>
    </message>
    <message>
        <source>Estimated from the views</source>
        <translation>Déterminée d’après les vues</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesurée</translation>
    </message>
    <message>
        <source>Changes while it runs (ramp)</source>
        <translation>Change pendant le passage (rampe)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Height of the robot&apos;s top</source>
        <translation>Hauteur du sommet du robot</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>&amp;Pick from a video…</source>
        <translation>D’après une &amp;image…</translation>
    </message>
    <message>
        <source>&amp;Colour of its top</source>
        <translation>&amp;Couleur du sommet</translation>
    </message>
    <message>
        <source>&amp;Drawn in</source>
        <translation>&amp;Dessiné en</translation>
    </message>
    <message>
        <source>&amp;Height of its top</source>
        <translation>&amp;Hauteur du sommet</translation>
    </message>
    <message>
        <source>Colour of the robot&apos;s top</source>
        <translation>Couleur du sommet du robot</translation>
    </message>
    <message>
        <source>Change robot</source>
        <translation>Modifier le robot</translation>
    </message>
    <message>
        <source>Its silhouette</source>
        <translation>Ce qui le distingue du sol</translation>
    </message>
    <message>
        <source>A colour of its own</source>
        <translation>Une couleur à lui</translation>
    </message>
    <message>
        <source>The silhouette works for any robot. A colour of its own helps if several things move.</source>
        <translation>Un robot de n’importe quel aspect est trouvé par ce qui le distingue du sol. Une couleur à lui aide quand plusieurs choses bougent.</translation>
    </message>
    <message>
        <source>D&amp;etected by</source>
        <translation>&amp;Trouvé par</translation>
    </message>
    <message>
        <source>Colour in charts and maps; the robot itself may have another</source>
        <translation>Dans les graphiques et les cartes, quel que soit l’aspect du robot</translation>
    </message>
    <message>
        <source>Offset from the middle of the robot&apos;s footprint; 0 and 0 is the middle itself.</source>
        <translation>Depuis le milieu de ce que le robot couvre du sol ; 0 et 0 est le milieu même.</translation>
    </message>
    <message>
        <source> mm forward</source>
        <translation> mm vers l’avant</translation>
    </message>
    <message>
        <source>Reference point, forward of the robot&apos;s middle</source>
        <translation>Point mesuré, en avant du milieu du robot</translation>
    </message>
    <message>
        <source> mm left</source>
        <translation> mm vers la gauche</translation>
    </message>
    <message>
        <source>Reference point, left of the robot&apos;s middle</source>
        <translation>Point mesuré, à gauche du milieu du robot</translation>
    </message>
    <message>
        <source>&amp;Reference point</source>
        <translation>&amp;Point mesuré</translation>
    </message>
</context>
<context>
    <name>odo::RobotFootprint</name>
    <message>
        <source>The robot from above, heading to the right</source>
        <translation>Le robot vu de dessus, orienté vers la droite</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>No size given. Drawn as %1 × %2 mm</source>
        <translation>Taille non indiquée. Dessiné en %1 × %2 mm</translation>
    </message>
</context>
<context>
    <name>odo::RobotPointing</name>
    <message>
        <source>&amp;Point out a robot</source>
        <translation>&amp;Montrer un robot</translation>
    </message>
    <message>
        <source>Wrong object outlined? Click the robot in a view to track the trial again (%1)</source>
        <translation>Le contour n’est pas celui du robot : cliquez sur le robot dans une image, et l’essai sera suivi de nouveau (%1)</translation>
    </message>
    <message>
        <source>This is %1: track it again</source>
        <translation>C’est %1 : le suivre de nouveau</translation>
    </message>
    <message>
        <source>Find %1 automatically</source>
        <translation>Chercher %1 sans aide</translation>
    </message>
</context>
<context>
    <name>odo::RobotsDialog</name>
    <message>
        <source>estimated from the views</source>
        <translation>déterminée d’après les vues</translation>
    </message>
    <message>
        <source>changes while it runs</source>
        <translation>change pendant le passage</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>A&amp;jouter…</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Modifier…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
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
        <translation>Dessiné en</translation>
    </message>
    <message>
        <source>Height of its top</source>
        <translation>Hauteur du sommet</translation>
    </message>
    <message>
        <source>Length × width</source>
        <translation>Longueur × largeur</translation>
    </message>
    <message>
        <source>A new colour or height applies from the next tracking on; earlier results stay as they are.</source>
        <translation>Une autre couleur ou hauteur compte à partir du prochain suivi&#xa0;; ce qui a été mesuré avant reste tel quel.</translation>
    </message>
    <message>
        <source>Latest change</source>
        <translation>Ce qui a été fait</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>its silhouette</source>
        <translation>sa silhouette</translation>
    </message>
    <message>
        <source>Detected by</source>
        <translation>Trouvé par</translation>
    </message>
</context>
<context>
    <name>odo::RunCard</name>
    <message>
        <source>Up now</source>
        <translation>En piste</translation>
    </message>
    <message>
        <source>Robots of this run</source>
        <translation>Robots qui roulent</translation>
    </message>
    <message>
        <source>&amp;Class</source>
        <translation>&amp;Classe</translation>
    </message>
    <message>
        <source>Te&amp;am</source>
        <translation>É&amp;quipe</translation>
    </message>
    <message>
        <source>Tas&amp;k</source>
        <translation>Épreu&amp;ve</translation>
    </message>
    <message>
        <source>R&amp;obots</source>
        <translation>R&amp;obots</translation>
    </message>
    <message>
        <source>Trial &amp;name</source>
        <translation>&amp;Nom de l’essai</translation>
    </message>
    <message>
        <source>Be&amp;gins</source>
        <translation>Dé&amp;but</translation>
    </message>
    <message>
        <source>&amp;Laps</source>
        <translation>To&amp;urs</translation>
    </message>
    <message>
        <source>Number of laps</source>
        <translation>Tours jusqu’à la fin</translation>
    </message>
    <message>
        <source>Team of this run</source>
        <translation>Équipe en piste</translation>
    </message>
    <message>
        <source>When the recording begins</source>
        <translation>Comment débute l’enregistrement</translation>
    </message>
    <message>
        <source>no class</source>
        <translation>aucune classe</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>no team</source>
        <translation>aucune équipe</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>aussitôt</translation>
    </message>
    <message>
        <source>after a countdown of %1 s</source>
        <translation>après un compte à rebours de %1 s</translation>
    </message>
    <message>
        <source>when the robot passes the start</source>
        <translation>quand le robot franchit le départ</translation>
    </message>
</context>
<context>
    <name>odo::RunChooser</name>
    <message>
        <source>start gate</source>
        <translation>porte de départ</translation>
    </message>
    <message>
        <source>onset of motion</source>
        <translation>début du mouvement</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distance</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>First run</source>
        <translation>Premier passage</translation>
    </message>
    <message>
        <source>Second run</source>
        <translation>Second passage</translation>
    </message>
    <message>
        <source>How to align the runs</source>
        <translation>L’instant pris comme commun</translation>
    </message>
    <message>
        <source>Swap the two runs</source>
        <translation>Échanger les deux passages</translation>
    </message>
    <message>
        <source>Add more runs</source>
        <translation>Autres passages</translation>
    </message>
    <message>
        <source>&amp;Shift</source>
        <translation>&amp;Décalage</translation>
    </message>
    <message>
        <source>Distan&amp;ce</source>
        <translation>Endr&amp;oit</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time shift of the second run; positive: later</source>
        <translation>De combien l’instant du second passage est plus tardif</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>first common point</source>
        <translation>où tous ont commencé</translation>
    </message>
    <message>
        <source>Distance along the path at which the runs are aligned</source>
        <translation>À quelle distance sur le trajet les passages sont pris comme simultanés</translation>
    </message>
    <message>
        <source>F&amp;irst</source>
        <translation>Prem&amp;ier</translation>
    </message>
    <message>
        <source>Seco&amp;nd</source>
        <translation>Seco&amp;nd</translation>
    </message>
    <message>
        <source>&amp;Align by</source>
        <translation>Ali&amp;gner sur</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automatique&#xa0;: %1</translation>
    </message>
    <message>
        <source>No more runs</source>
        <translation>Il n’y a pas d’autre passage</translation>
    </message>
</context>
<context>
    <name>odo::RunResultCard</name>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>&amp;Open in Review</source>
        <translation>E&amp;xaminer</translation>
    </message>
    <message>
        <source>The results appear here shortly after the run ends.</source>
        <translation>Les grandeurs d’un passage s’affichent ici un instant après sa fin.</translation>
    </message>
    <message>
        <source>Analysing…</source>
        <translation>Mesure en cours…</translation>
    </message>
    <message>
        <source>Spikes flagged</source>
        <translation>Pics aberrants signalés</translation>
    </message>
    <message>
        <source>From live tracking. The final results follow shortly, from the recording.</source>
        <translation>D’après le suivi en direct. Les valeurs définitives viennent de l’enregistrement, dans un instant.</translation>
    </message>
    <message>
        <source>Final, from every frame of the recording.</source>
        <translation>Définitif, d’après toutes les images de l’enregistrement.</translation>
    </message>
</context>
<context>
    <name>odo::RunResults</name>
    <message>
        <source>%1 is analysed.</source>
        <translation>%1 est mesuré.</translation>
    </message>
    <message>
        <source>Recorded, but not analysed: %1</source>
        <translation>Il est enregistré, mais n’a pas pu être mesuré&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 is recorded.</source>
        <translation>%1 est enregistré.</translation>
    </message>
    <message>
        <source>Recording failed: %1</source>
        <translation>Il n’a pas pu être enregistré&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>odo::ScoreboardDialog</name>
    <message>
        <source>&amp;Copy address</source>
        <translation>&amp;Copier l’adresse</translation>
    </message>
    <message>
        <source>&amp;Open in browser</source>
        <translation>&amp;Ouvrir dans le navigateur</translation>
    </message>
    <message>
        <source>Standings as a web page</source>
        <translation>Classement en page web</translation>
    </message>
    <message>
        <source>Show the standings on a projector or on phones. The page follows the project as long as this window is open.</source>
        <translation>Affichez le classement sur un projecteur ou des téléphones. La page suit le projet tant que cette fenêtre est ouverte.</translation>
    </message>
    <message>
        <source>C&amp;lass:</source>
        <translation>C&amp;lasse :</translation>
    </message>
    <message>
        <source>&amp;Task:</source>
        <translation>É&amp;preuve :</translation>
    </message>
    <message>
        <source>&amp;Visible to:</source>
        <translation>&amp;Visible pour :</translation>
    </message>
    <message>
        <source>Address of the page</source>
        <translation>Adresse de la page</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>Toutes les classes</translation>
    </message>
    <message>
        <source>Task of the newest trial</source>
        <translation>Épreuve de l’essai le plus récent</translation>
    </message>
    <message>
        <source>This computer only</source>
        <translation>Cet ordinateur seul</translation>
    </message>
    <message>
        <source>All devices in the network</source>
        <translation>Tous les appareils du réseau</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Démarrage…</translation>
    </message>
    <message>
        <source>Everyone in the network can open this page. It shows the names of teams, classes and tasks, and no others.</source>
        <translation>Toute personne sur le réseau peut ouvrir cette page. Elle ne montre que les noms d’équipes, de classes et d’épreuves.</translation>
    </message>
    <message>
        <source>Only this computer can open this page.</source>
        <translation>Seul cet ordinateur peut ouvrir cette page.</translation>
    </message>
</context>
<context>
    <name>odo::ScoringTable</name>
    <message>
        <source>Remo&amp;ve line</source>
        <translation>Retirer la li&amp;gne</translation>
    </message>
    <message>
        <source>Each line gives all its points if the metric reaches the first bound, none at the second bound or worse, and a proportional share between them. Negative points are a penalty.</source>
        <translation>Chaque ligne donne tous ses points si la grandeur atteint la première borne ou fait mieux, aucun à la seconde ou au-delà, et proportionnellement entre les deux. Des points négatifs sont une pénalité.</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>All points at</source>
        <translation>Tous les points à</translation>
    </message>
    <message>
        <source>None at</source>
        <translation>Aucun à</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Lines of the scoring</source>
        <translation>Lignes du barème</translation>
    </message>
    <message>
        <source>What the lines mean</source>
        <translation>Ce que signifient les lignes</translation>
    </message>
    <message>
        <source>&amp;Add line</source>
        <translation>A&amp;jouter une ligne</translation>
    </message>
    <message>
        <source>Scored metric</source>
        <translation>Grandeur qui compte</translation>
    </message>
    <message>
        <source>Without a line, runs of the task are not scored.</source>
        <translation>Sans ligne, les passages de l’épreuve ne sont pas notés.</translation>
    </message>
    <message>
        <source>Total: %1 points.</source>
        <translation>En tout %1 points.</translation>
    </message>
</context>
<context>
    <name>odo::SeriesKey</name>
    <message>
        <source>Legend</source>
        <translation>Légende des lignes</translation>
    </message>
    <message>
        <source>%1: click to hide or show</source>
        <translation>%1 : cliquer pour masquer ou afficher</translation>
    </message>
</context>
<context>
    <name>odo::SharedField</name>
    <message>
        <source>several</source>
        <translation>plusieurs</translation>
    </message>
    <message>
        <source>%1: several</source>
        <translation>%1 : plusieurs</translation>
    </message>
    <message>
        <source>The trials differ here. Press to enter one value for all of them.</source>
        <translation>Les essais diffèrent ici. Appuyez pour saisir une valeur pour tous.</translation>
    </message>
</context>
<context>
    <name>odo::SharedPointsPage</name>
    <message>
        <source>&amp;Remove</source>
        <translation>Re&amp;tirer</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Image of the camera to register; arrow keys move the selected point</source>
        <translation>Image de la caméra à localiser&#xa0;; les flèches déplacent le point choisi</translation>
    </message>
    <message>
        <source>Image of the registered camera; arrow keys move the selected point</source>
        <translation>Image de la caméra localisée&#xa0;; les flèches déplacent le point choisi</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Seen in</source>
        <translation>Vu dans</translation>
    </message>
    <message>
        <source>On the floor, mm</source>
        <translation>Au sol, mm</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Floor points</source>
        <translation>Points du sol</translation>
    </message>
    <message>
        <source>Camera %1, to be registered</source>
        <translation>Caméra %1, à localiser</translation>
    </message>
    <message>
        <source>Camera %1, registered</source>
        <translation>Caméra %1, localisée</translation>
    </message>
    <message>
        <source>P%1</source>
        <comment>a point</comment>
        <translation>P%1</translation>
    </message>
    <message>
        <source>Click a floor point in the left image, then the same point in the right image. A click snaps to what is near it, to a tenth of a pixel; arrow keys move the selected point, Space snaps it.</source>
        <translation>Cliquez sur un point du sol dans l’image de gauche, puis sur le même dans l’image de droite. Ce qui est près d’un clic est repéré au dixième de pixel&#xa0;; les flèches déplacent le point choisi, Espace l’ajuste.</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1&#xa0;; %2</translation>
    </message>
    <message>
        <source>beyond the horizon</source>
        <translation>au-delà de l’horizon</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>both images</source>
        <translation>les deux images</translation>
    </message>
    <message>
        <source>left only</source>
        <translation>gauche seulement</translation>
    </message>
    <message>
        <source>right only</source>
        <translation>droite seulement</translation>
    </message>
    <message>
        <source>not set yet</source>
        <translation>pas encore placé</translation>
    </message>
</context>
<context>
    <name>odo::SmoothingPanel</name>
    <message>
        <source>%1: measured for less than a second</source>
        <translation>%1 : mesuré moins d’une seconde</translation>
    </message>
    <message>
        <source>%1: smoothed automatically like a filter with a cut-off of %2; what it takes away is %3 of each coordinate</source>
        <translation>%1 : lissé automatiquement comme par un filtre de coupure %2 ; il retire %3 à chaque coordonnée</translation>
    </message>
    <message>
        <source>%1: the smoother states no cut-off</source>
        <translation>%1 : le lissage n’indique pas de coupure</translation>
    </message>
    <message>
        <source>Noise of the measurements by their residuals: %1; stated: %2</source>
        <translation>Bruit des mesures d’après leurs résidus : %1 ; indiqué : %2</translation>
    </message>
    <message>
        <source>Cut-off by residual analysis: %1</source>
        <translation>Coupure d’après l’analyse des résidus : %1</translation>
    </message>
    <message>
        <source>Residual analysis gives no cut-off: the residuals are not those of noise.</source>
        <translation>L’analyse des résidus ne donne pas de coupure : les résidus ne sont pas ceux d’un bruit.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>residual of a Butterworth filter, by its cut-off</source>
        <translation>résidu d’un filtre de Butterworth selon sa coupure</translation>
    </message>
    <message>
        <source>Smoothing of the robots</source>
        <translation>Lissage des robots</translation>
    </message>
    <message>
        <source>No curve yet: track the trial.</source>
        <translation>Pas encore de courbe : suivez l’essai.</translation>
    </message>
</context>
<context>
    <name>odo::SoundChart</name>
    <message>
        <source>Loudness</source>
        <translation>Volume sonore</translation>
    </message>
    <message>
        <source>Loudness of both views</source>
        <translation>Volume sonore des deux vues</translation>
    </message>
</context>
<context>
    <name>odo::SpikeActions</name>
    <message>
        <source>&amp;Use sample</source>
        <translation>&amp;Utiliser</translation>
    </message>
    <message>
        <source>Mark the sample at this moment as valid and use it, even if it was flagged</source>
        <translation>Ce qui a été mesuré à cet instant est juste et doit être utilisé, malgré tout ce qui s’y oppose</translation>
    </message>
    <message>
        <source>Mark as &amp;spike</source>
        <translation>&amp;Marquer</translation>
    </message>
    <message>
        <source>Mark the sample at this moment as a spike and do not use it</source>
        <translation>Ce qui a été mesuré à cet instant est faux et ne doit pas être utilisé</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatique</translation>
    </message>
    <message>
        <source>Remove the manual override at this moment</source>
        <translation>Annule ce qui a été dit à la main à cet instant</translation>
    </message>
</context>
<context>
    <name>odo::SpikeList</name>
    <message>
        <source>Spikes</source>
        <translation>Pics aberrants</translation>
    </message>
    <message>
        <source>Spikes with time and reason</source>
        <translation>Pics aberrants, avec l’instant et la raison</translation>
    </message>
    <message>
        <source>Select all with this &amp;reason</source>
        <translation>Sélectionner tous ceux de cette &amp;raison</translation>
    </message>
    <message>
        <source>Select all in the selected ra&amp;nge</source>
        <translation>Sélectionner tous ceux de la &amp;plage sélectionnée</translation>
    </message>
    <message>
        <source>Select all spikes of this robot that have the reason of the selected one</source>
        <translation>Sélectionner tous les pics de ce robot qui ont la raison de celui sélectionné</translation>
    </message>
    <message>
        <source>Select all spikes of this robot within the selection on the time line</source>
        <translation>Sélectionner tous les pics de ce robot dans la sélection de la ligne de temps</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n sélectionné</numerusform>
            <numerusform>%n sélectionnés</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::SpikeModel</name>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>%1 flagged</source>
        <translation>%1 signalés</translation>
    </message>
    <message>
        <source>%1 restored</source>
        <translation>%1 rétablis</translation>
    </message>
    <message>
        <source>used, by hand</source>
        <translation>utilisé, à la main</translation>
    </message>
    <message>
        <source>%1 (restored by hand)</source>
        <translation>%1 (rétabli à la main)</translation>
    </message>
    <message>
        <source>Restored by hand</source>
        <translation>Rétabli à la main</translation>
    </message>
    <message>
        <source>Flagged, not used for the curve</source>
        <translation>Signalé, non utilisé pour la courbe</translation>
    </message>
    <message>
        <source>Flagged, still used for the curve</source>
        <translation>Signalé, mais utilisé pour la courbe</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Raison</translation>
    </message>
    <message>
        <source>%1 ambiguous</source>
        <translation>%1 en doute</translation>
    </message>
    <message>
        <source>%1 hidden</source>
        <translation>%1 avec occultation</translation>
    </message>
    <message>
        <source>%1 not measured</source>
        <translation>%1 non mesuré</translation>
    </message>
</context>
<context>
    <name>odo::StandingsModel</name>
    <message>
        <source>choose a task</source>
        <translation>choisissez une épreuve</translation>
    </message>
    <message>
        <source>needs three trials at different times</source>
        <translation>il faut trois essais de dates différentes</translation>
    </message>
    <message>
        <source>within the spread (%1)</source>
        <translation>dans la dispersion (%1)</translation>
    </message>
    <message>
        <source>better: %1</source>
        <translation>mieux&#xa0;: %1</translation>
    </message>
    <message>
        <source>worse: %1</source>
        <translation>moins bien&#xa0;: %1</translation>
    </message>
    <message>
        <source>one trial</source>
        <translation>un essai</translation>
    </message>
    <message>
        <source>One more than the number of significantly better teams (medians differ by more than 1.96 σ). Runs of different tasks are not ranked</source>
        <translation>Un de plus que le nombre d’équipes sûrement meilleures&#xa0;: leurs médianes diffèrent de plus de 1,96 σ. Les passages d’épreuves différentes ne sont pas classés</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Meilleur</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>Repeatability: standard deviation of one trial about the line of progress</source>
        <translation>Répétabilité&#xa0;: écart-type d’un essai autour de la droite de progrès</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Dispersion</translation>
    </message>
    <message>
        <source>Change over the term by a straight-line fit; Student&apos;s t-test (95 %) decides if it exceeds the spread</source>
        <translation>Évolution au fil du temps selon une droite&#xa0;; hors de la dispersion d’après le test de Student, 95&#xa0;%</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progrès</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n doubtful</source>
        <translation>
            <numerusform>%1, %n douteux</numerusform>
            <numerusform>%1, %n douteux</numerusform>
        </translation>
    </message>
    <message>
        <source>Those with bad results do not count</source>
        <translation>Ceux aux résultats mauvais ne comptent pas</translation>
    </message>
    <message>
        <source>± from the spread of all teams&apos; trials, at least that of the measurement</source>
        <translation>± d’après la dispersion des essais de toutes les équipes, au moins celui de la mesure</translation>
    </message>
</context>
<context>
    <name>odo::StartActions</name>
    <message>
        <source>Registered to the floor mat: %1.</source>
        <translation>Localisées d’après le tapis de sol : %1.</translation>
    </message>
    <message>
        <source>Their newest recordings do not show it: %1.</source>
        <translation>Leurs enregistrements les plus récents ne le montrent pas : %1.</translation>
    </message>
</context>
<context>
    <name>odo::StartCard</name>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>&amp;Record or stop</source>
        <translation>Fil&amp;mer ou arrêter</translation>
    </message>
    <message>
        <source>Recorded time</source>
        <translation>Durée filmée</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Filmer</translation>
    </message>
    <message>
        <source>Writing the last frames…</source>
        <translation>Écriture des dernières images…</translation>
    </message>
    <message>
        <source>F9 records, F9 stops</source>
        <translation>F9 filme, F9 arrête</translation>
    </message>
    <message>
        <source>F9 records, F9 stops; %1</source>
        <translation>F9 filme, F9 arrête&#xa0;; %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>dans %1</translation>
    </message>
    <message>
        <source>Get ready</source>
        <translation>Tenez-vous prêts</translation>
    </message>
    <message>
        <source>Waiting for the robot at “%1”. The recording will include the second before</source>
        <translation>En attente du robot à «&#xa0;%1&#xa0;»&#xa0;; il est filmé à partir d’une seconde avant</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
</context>
<context>
    <name>odo::StartPage</name>
    <message>
        <source>Cameras or clips</source>
        <translation>Caméras ou vidéos</translation>
    </message>
    <message>
        <source>Import clips…</source>
        <translation>Importer des vidéos…</translation>
    </message>
    <message>
        <source>Connect cameras</source>
        <translation>Connecter des caméras</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Find the mat in the clips…</source>
        <translation>Chercher le tapis dans les vidéos…</translation>
    </message>
    <message>
        <source>Print a mat…</source>
        <translation>Imprimer un tapis…</translation>
    </message>
    <message>
        <source>Use other markers…</source>
        <translation>Utiliser d’autres marqueurs…</translation>
    </message>
    <message>
        <source>Lens (optional)</source>
        <translation>Objectif (facultatif)</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Étalonner…</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Add a robot…</source>
        <translation>Ajouter un robot…</translation>
    </message>
    <message>
        <source>First run</source>
        <translation>Premier parcours</translation>
    </message>
    <message>
        <source>Track…</source>
        <translation>Suivre…</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Filmer</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>From clips to a first result</source>
        <translation>Des vidéos au premier résultat</translation>
    </message>
    <message>
        <source>Steps to a first result</source>
        <translation>Étapes vers un premier résultat</translation>
    </message>
</context>
<context>
    <name>odo::StatusLine</name>
    <message>
        <source>No trial</source>
        <translation>Aucun essai</translation>
    </message>
    <message>
        <source>Not tracked yet</source>
        <translation>Pas encore suivi</translation>
    </message>
    <message>
        <source>Analysis %1, Odograph %2</source>
        <translation>Analyse %1, Odograph %2</translation>
    </message>
    <message>
        <source>Units of lengths, speeds and times; change them in the preferences</source>
        <translation>Unités des longueurs, des vitesses et des temps&#xa0;; à choisir dans les préférences</translation>
    </message>
    <message>
        <source>No project is open</source>
        <translation>Aucun projet n’est ouvert</translation>
    </message>
    <message>
        <source>Read only: nothing can be changed</source>
        <translation>Lecture seule&#xa0;: rien ne peut être modifié</translation>
    </message>
    <message>
        <source>All changes saved</source>
        <translation>Toutes les modifications sont enregistrées</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Enregistrement…</translation>
    </message>
    <message>
        <source>The school&apos;s hub</source>
        <translation>Le serveur de l’école</translation>
    </message>
    <message>
        <source>%1. Click for more about the school&apos;s hub</source>
        <translation>%1. Cliquez pour en savoir plus sur le serveur de l’école</translation>
    </message>
</context>
<context>
    <name>odo::StepDialog</name>
    <message>
        <source>&lt; &amp;Back</source>
        <translation>&lt; &amp;Retour</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>étape %1 sur %2</translation>
    </message>
    <message>
        <source>&amp;Next &gt;</source>
        <translation>&amp;Suivant &gt;</translation>
    </message>
    <message>
        <source>Discard %1?</source>
        <translation>Abandonner %1 ?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Abandonner</translation>
    </message>
    <message>
        <source>&amp;Keep working</source>
        <translation>&amp;Continuer</translation>
    </message>
</context>
<context>
    <name>odo::StepRow</name>
    <message>
        <source>Done. %1</source>
        <translation>Fait. %1</translation>
    </message>
</context>
<context>
    <name>odo::SynchroniseDialog</name>
    <message>
        <source>Synchronise %1</source>
        <translation>Synchroniser %1</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>%1 à présent</translation>
    </message>
    <message>
        <source>&amp;Synchronise</source>
        <translation>&amp;Synchroniser</translation>
    </message>
    <message>
        <source>Synchronise</source>
        <translation>Synchroniser</translation>
    </message>
    <message>
        <source>What was tracked in the trial is reanalysed. Choose Undo to return to the synchronisation that it has now.</source>
        <translation>Ce qui a été suivi dans l’essai est analysé de nouveau. « Annuler » rétablit la synchronisation actuelle.</translation>
    </message>
    <message>
        <source>The sound of the videos is being read…</source>
        <translation>Lecture du son des vidéos…</translation>
    </message>
    <message>
        <source>Sound of the first view above, of the other one below. Drag it until both show the same clap at one time; the wheel zooms.</source>
        <translation>Son de la première vue en haut, de l’autre en bas. Faites-le glisser jusqu’à ce que les deux montrent le même claquement au même instant ; la molette agrandit.</translation>
    </message>
    <message>
        <source>There is no sound in both views to compare.</source>
        <translation>Il n’y a pas de son à comparer dans les deux vues.</translation>
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
        <translation>Coins intérieurs dans la longueur de la mire</translation>
    </message>
    <message>
        <source>Inner corners across the board</source>
        <translation>Coins intérieurs dans la largeur de la mire</translation>
    </message>
    <message>
        <source>Print targets</source>
        <translation>Imprimer des cibles</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>&amp;Enregistrer en PDF…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Imprimer…</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>Damier</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>Mire ChArUco</translation>
    </message>
    <message>
        <source>Floor markers: tags</source>
        <translation>Marqueurs au sol&#xa0;: tags</translation>
    </message>
    <message>
        <source>Floor markers: rings</source>
        <translation>Marqueurs au sol&#xa0;: anneaux</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Lettre US</translation>
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
        <translation>&amp;Cible</translation>
    </message>
    <message>
        <source>Pape&amp;r</source>
        <translation>&amp;Papier</translation>
    </message>
    <message>
        <source>&amp;Inner corners</source>
        <translation>Coins intérieu&amp;rs</translation>
    </message>
    <message>
        <source>S&amp;quare</source>
        <translation>C&amp;arré</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Taille</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Libellés</translation>
    </message>
    <message>
        <source>What is printed</source>
        <translation>Ce qui est imprimé</translation>
    </message>
    <message>
        <source>One sheet. Afterwards measure a square on the paper: printers often shrink by 2 to 4 %.</source>
        <translation>Une feuille. Mesurez ensuite un carré sur le papier&#xa0;: les imprimantes réduisent souvent de 2 à 4&#xa0;%.</translation>
    </message>
    <message>
        <source>One sheet for each marker. A tag&apos;s number is the position of its label in the layout.</source>
        <translation>Une feuille par marqueur. Le numéro d’un tag est le rang de son libellé dans le plan.</translation>
    </message>
    <message>
        <source>Save targets</source>
        <translation>Enregistrer les cibles</translation>
    </message>
    <message>
        <source>targets.pdf</source>
        <translation>cibles.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Enregistré&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Sent to the printer.</source>
        <translation>Envoyé à l’imprimante.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Sheets in a row of the mat</source>
        <translation>Feuilles dans une rangée du tapis</translation>
    </message>
    <message>
        <source>Rows of the mat</source>
        <translation>Rangées du tapis</translation>
    </message>
    <message>
        <source>Floor mat</source>
        <translation>Tapis de sol</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>&amp;Feuilles</translation>
    </message>
    <message>
        <source>A plan and %1 sheets, to be taped together to a mat of %2 × %3 m. Its markers are known: nothing on the floor needs to be measured. The larger the mat, the more exact the floor.</source>
        <translation>Un plan et %1 feuilles, à coller ensemble en un tapis de %2 × %3 m. Ses marqueurs sont connus : rien n’est à mesurer au sol. Plus le tapis est grand, plus le sol est exact.</translation>
    </message>
</context>
<context>
    <name>odo::TargetPreview</name>
    <message>
        <source>Preview of the sheets</source>
        <translation>Aperçu des feuilles</translation>
    </message>
</context>
<context>
    <name>odo::TaskCanvas</name>
    <message>
        <source>The task from above</source>
        <translation>L’épreuve vue de dessus</translation>
    </message>
    <message>
        <source>Drag a gate or one of its ends, a zone&apos;s edge or corner. Keys: Page Up and Down choose a gate or a zone, arrows move it (Shift: 100 mm, Ctrl: 1 mm), &lt; and &gt; turn it, + and − change its width</source>
        <translation>Faites glisser une porte ou l’une de ses extrémités, le bord ou un sommet d’une zone. Au clavier&#xa0;: Page précédente et Page suivante choisissent une porte ou une zone, les flèches la déplacent (Maj&#xa0;: 100 mm, Ctrl&#xa0;: 1 mm), &lt; et &gt; la tournent, + et − changent sa largeur</translation>
    </message>
    <message>
        <source>Zone %1, %2: %3 mm</source>
        <translation>Zone %1, %2&#xa0;: %3 mm</translation>
    </message>
    <message>
        <source>No gate or zone is chosen</source>
        <translation>Aucune porte ni zone n’est choisie</translation>
    </message>
    <message>
        <source>Gate %1 from %2, %3 to %4, %5</source>
        <translation>Porte %1 de %2, %3 à %4, %5</translation>
    </message>
</context>
<context>
    <name>odo::TaskEditor</name>
    <message>
        <source>none</source>
        <translation>aucune</translation>
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
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Épreuve</translation>
    </message>
    <message>
        <source>&amp;Course</source>
        <translation>&amp;Parcours</translation>
    </message>
    <message>
        <source>&amp;Zones</source>
        <translation>&amp;Zones</translation>
    </message>
    <message>
        <source>Sco&amp;ring</source>
        <translation>&amp;Barème</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Ce qui ne va pas</translation>
    </message>
    <message>
        <source>Import &amp;file…</source>
        <translation>Importer un &amp;fichier…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Import gates, path, limits and zones from a task file (JSON)</source>
        <translation>Prendre portes, tracé, limites et zones dans un fichier d’épreuve (JSON)</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>Speed limi&amp;t</source>
        <translation>Limite de &amp;vitesse</translation>
    </message>
    <message>
        <source>Acceleration l&amp;imit</source>
        <translation>Limite d’a&amp;ccélération</translation>
    </message>
    <message>
        <source>No robot in the task can exceed it: a measurement beyond it is a spike</source>
        <translation>Ce qu’aucun robot de l’épreuve ne peut faire&#xa0;: une mesure au-delà est un pic aberrant</translation>
    </message>
    <message>
        <source>Task file</source>
        <translation>Fichier d’épreuve</translation>
    </message>
    <message>
        <source>Tasks (*.json *.yaml *.yml);;All files (*)</source>
        <translation>Épreuves (*.json *.yaml *.yml);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The task has no name.</source>
        <translation>L’épreuve n’a pas de nom.</translation>
    </message>
    <message>
        <source>A task with this name exists. Enter another name.</source>
        <translation>Il existe une épreuve de ce nom. Donnez un autre nom.</translation>
    </message>
    <message>
        <source>A gate has no name.</source>
        <translation>Une porte n’a pas de nom.</translation>
    </message>
    <message>
        <source>A zone has no name.</source>
        <translation>Une zone n’a pas de nom.</translation>
    </message>
</context>
<context>
    <name>odo::TasksDialog</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nouvelle</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Modifier…</translation>
    </message>
    <message>
        <source>&amp;Copy…</source>
        <translation>&amp;Copier…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Renommer…</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>&amp;Archiver</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Reanalyse &amp;them</source>
        <translation>R&amp;emesurer</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Épreuves</translation>
    </message>
    <message>
        <source>What depends on the task</source>
        <translation>Ce qui dépend de l’épreuve</translation>
    </message>
    <message>
        <source>Latest change</source>
        <translation>Ce qui a été fait</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Épreuve</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>Utilisée par</translation>
    </message>
    <message>
        <source>Archived tasks no longer appear in lists; their trials, results and scores stay as they are</source>
        <translation>Une épreuve archivée n’est plus proposée&#xa0;; ses essais, résultats et scores restent tels quels</translation>
    </message>
    <message numerus="yes">
        <source>Show %n archived task(s)</source>
        <translation>
            <numerusform>Montrer %n épreuve archivée</numerusform>
            <numerusform>Montrer %n épreuves archivées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n essai</numerusform>
            <numerusform>%n essais</numerusform>
        </translation>
    </message>
    <message>
        <source>earlier results</source>
        <translation>résultats antérieurs</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>%1, archived</source>
        <translation>%1, archivée</translation>
    </message>
    <message>
        <source>No task yet. New creates one from a template. Its gates, path and scoring define the course and rate the runs.</source>
        <translation>Pas encore d’épreuve. «&#xa0;Nouvelle&#xa0;» en crée une d’après un modèle&#xa0;: ses portes, son tracé et son barème disent ce qu’il faut parcourir, et avec quelle réussite.</translation>
    </message>
    <message numerus="yes">
        <source>Earlier version of the course: %n result(s) still use it.</source>
        <translation>
            <numerusform>Le parcours tel qu’il était avant sa modification&#xa0;: %n résultat mesuré sur lui le garde.</numerusform>
            <numerusform>Le parcours tel qu’il était avant sa modification&#xa0;: %n résultats mesurés sur lui le gardent.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) have this task.</source>
        <translation>
            <numerusform>%n essai a cette épreuve.</numerusform>
            <numerusform>%n essais ont cette épreuve.</numerusform>
        </translation>
    </message>
    <message>
        <source>No trial has this task.</source>
        <translation>Aucun essai n’a cette épreuve.</translation>
    </message>
    <message numerus="yes">
        <source>%n of them were measured with another course: their gate times and distances from the path belong to that one, and they have no score until you reanalyse them.</source>
        <translation>
            <numerusform>%n d’entre eux a été mesuré sur un autre parcours&#xa0;: ses temps aux portes et ses écarts au tracé sont de celui-là, et il n’a pas de score avant d’être remesuré.</numerusform>
            <numerusform>%n d’entre eux ont été mesurés sur un autre parcours&#xa0;: leurs temps aux portes et leurs écarts au tracé sont de celui-là, et ils n’ont pas de score avant d’être remesurés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is scored by %n metric(s).</source>
        <translation>
            <numerusform>Elle est notée d’après %n grandeur.</numerusform>
            <numerusform>Elle est notée d’après %n grandeurs.</numerusform>
        </translation>
    </message>
    <message>
        <source>It is not scored.</source>
        <translation>Elle n’est pas notée.</translation>
    </message>
    <message>
        <source>Restore from &amp;archive</source>
        <translation>Dés&amp;archiver</translation>
    </message>
    <message>
        <source>Trials have this task or were measured with it: it stays to document their metrics</source>
        <translation>Des essais ont cette épreuve, ou ont été mesurés sur elle&#xa0;: elle reste, pour que leurs valeurs disent sur quoi elles ont été mesurées</translation>
    </message>
    <message>
        <source>Deletes the task (Del); Ctrl+Z undoes this</source>
        <translation>Supprime l’épreuve (Suppr)&#xa0;; Ctrl+Z l’annule</translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) measured with this course stay valid: if you change the course, they keep the earlier version. Reanalyse the trials to update their times and scores.</source>
        <translation>
            <numerusform>%n résultat mesuré sur ce parcours reste vrai&#xa0;: un parcours modifié est gardé pour lui comme version antérieure. Les essais passent au nouveau&#xa0;; leurs temps et leurs scores suivent dès qu’ils sont remesurés.</numerusform>
            <numerusform>%n résultats mesurés sur ce parcours restent vrais&#xa0;: un parcours modifié est gardé pour eux comme version antérieure. Les essais passent au nouveau&#xa0;; leurs temps et leurs scores suivent dès qu’ils sont remesurés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename task</source>
        <translation>Renommer l’épreuve</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nom&#xa0;:</translation>
    </message>
</context>
<context>
    <name>odo::TeamDialog</name>
    <message>
        <source>Robots of the team</source>
        <translation>Robots de l’équipe</translation>
    </message>
    <message>
        <source>Team %1</source>
        <translation>Équipe %1</translation>
    </message>
    <message>
        <source>One name per line</source>
        <translation>Un nom par ligne</translation>
    </message>
    <message>
        <source>Members of the team, one per line</source>
        <translation>Membres de l’équipe, un par ligne</translation>
    </message>
    <message>
        <source>Record and Import propose these robots for the team&apos;s runs</source>
        <translation>«&#xa0;Filmer&#xa0;» et l’importation proposent ces robots pour les passages de l’équipe</translation>
    </message>
    <message>
        <source>&amp;Members</source>
        <translation>&amp;Membres</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>&amp;Robots</translation>
    </message>
    <message numerus="yes">
        <source>%n member(s)</source>
        <translation>
            <numerusform>%n membre</numerusform>
            <numerusform>%n membres</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TeamsPanel</name>
    <message>
        <source>Teams</source>
        <translation>Équipes</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>All classes</source>
        <translation>Toutes les classes</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Épreuve</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>Toute épreuve</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Standings</source>
        <translation>Classement des équipes</translation>
    </message>
    <message>
        <source>%1 (archived)</source>
        <translation>%1 (archivée)</translation>
    </message>
    <message>
        <source>No team has a result for this metric</source>
        <translation>Aucune équipe n’a de valeur ici</translation>
    </message>
    <message numerus="yes">
        <source>%n team(s)</source>
        <translation>
            <numerusform>%n équipe</numerusform>
            <numerusform>%n équipes</numerusform>
        </translation>
    </message>
    <message>
        <source>choose a task to rank them: runs of different tasks cannot be compared</source>
        <translation>choisissez une épreuve pour les classer&#xa0;: les passages d’épreuves différentes ne peuvent pas être comparés</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: analysed with a different course. Reanalyse them</source>
        <translation>
            <numerusform>%n essai exclu&#xa0;: mesuré sur un autre parcours&#xa0;; remesurez-le</numerusform>
            <numerusform>%n essais exclus&#xa0;: mesurés sur un autre parcours&#xa0;; remesurez-les</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not counted: bad results</source>
        <translation>
            <numerusform>%n essai non compté : résultats mauvais</numerusform>
            <numerusform>%n essais non comptés : résultats mauvais</numerusform>
        </translation>
    </message>
    <message>
        <source>teams that do not differ significantly share a rank</source>
        <translation>les équipes sans différence significative partagent un rang</translation>
    </message>
</context>
<context>
    <name>odo::TemplateForm</name>
    <message>
        <source>Straight line</source>
        <translation>Ligne droite</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>Figure eight</source>
        <translation>Huit</translation>
    </message>
    <message>
        <source>Slalom</source>
        <translation>Slalom</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Te&amp;mplate</source>
        <translation>&amp;Modèle</translation>
    </message>
    <message>
        <source>Centre &amp;x</source>
        <translation>Centre &amp;x</translation>
    </message>
    <message>
        <source>Centre &amp;y</source>
        <translation>Centre &amp;y</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Longueur</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>Lar&amp;geur</translation>
    </message>
    <message>
        <source>Driving direction: 0° along X, 90° along Y</source>
        <translation>Le sens de marche&#xa0;: 0° le long de X, 90° le long de Y</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>&amp;Direction</translation>
    </message>
    <message>
        <source>&amp;Poles</source>
        <translation>Pi&amp;quets</translation>
    </message>
    <message>
        <source>&amp;Gates&apos; width</source>
        <translation>Largeur des p&amp;ortes</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Diam&amp;eter</source>
        <translation>Diamè&amp;tre</translation>
    </message>
    <message>
        <source>Start to finis&amp;h</source>
        <translation>Du dép&amp;art à l’arrivée</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Hauteur</translation>
    </message>
    <message>
        <source>S&amp;wing, side to side</source>
        <translation>Amplit&amp;ude latérale</translation>
    </message>
</context>
<context>
    <name>odo::TestbedPage</name>
    <message>
        <source>From above</source>
        <translation>Vu de dessus</translation>
    </message>
    <message>
        <source>expected &amp;accuracy</source>
        <translation>précision a&amp;ttendue</translation>
    </message>
    <message>
        <source>No cameras yet</source>
        <translation>Pas encore de caméra</translation>
    </message>
    <message>
        <source>A testbed is a floor with markers and the cameras that watch it. Start with the lens calibration of the first camera, or with the marker positions.</source>
        <translation>Un banc d’essai est un sol avec des marqueurs et les caméras qui le regardent. Commencez par l’objectif de la première caméra, ou par les places des marqueurs.</translation>
    </message>
    <message>
        <source>Tas&amp;ks…</source>
        <translation>Épreu&amp;ves…</translation>
    </message>
    <message>
        <source>Courses on this floor: gates, paths, limits, scoring</source>
        <translation>Ce qui se parcourt sur ce sol&#xa0;: portes, tracés, limites, barème</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source>Details of the camera</source>
        <translation>Ce que l’on sait de la caméra</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Marker layouts</source>
        <translation>Plans de marqueurs</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Image</translation>
    </message>
</context>
<context>
    <name>odo::TestbedTools</name>
    <message>
        <source>&amp;Calibrate camera…</source>
        <translation>É&amp;talonner une caméra…</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Étalonner…</translation>
    </message>
    <message>
        <source>Calibrate a camera with images of a board</source>
        <translation>Mesurer l’objectif d’une caméra d’après des photos d’une mire</translation>
    </message>
    <message>
        <source>&amp;Register camera…</source>
        <translation>&amp;Localiser une caméra…</translation>
    </message>
    <message>
        <source>Register…</source>
        <translation>Localiser…</translation>
    </message>
    <message>
        <source>Determine a camera&apos;s position from the floor markers</source>
        <translation>Trouver où est une caméra d’après les marqueurs au sol</translation>
    </message>
    <message>
        <source>Register via anot&amp;her camera…</source>
        <translation>Localiser par une a&amp;utre caméra…</translation>
    </message>
    <message>
        <source>Via another…</source>
        <translation>Par une autre…</translation>
    </message>
    <message>
        <source>Determine the position of a camera that sees no markers, from floor points that another camera also sees</source>
        <translation>Trouver où est une caméra qui ne voit pas de marqueurs, d’après des points du sol qu’une autre caméra voit aussi</translation>
    </message>
    <message>
        <source>Re&amp;gister all cameras (joint)…</source>
        <translation>Localiser toutes les caméras en&amp;semble…</translation>
    </message>
    <message>
        <source>All cameras (joint)…</source>
        <translation>Toutes ensemble…</translation>
    </message>
    <message>
        <source>Fit all cameras of the selected layout jointly to make them agree, and find wrongly measured markers</source>
        <translation>Ajuster d’un coup les caméras du plan choisi, pour qu’elles s’accordent, et repérer les marqueurs mal mesurés</translation>
    </message>
    <message>
        <source>&amp;Import lens calibration…</source>
        <translation>Importer des &amp;intrinsèques…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Importer objectif…</translation>
    </message>
    <message>
        <source>Import a camera&apos;s lens calibration from a ROS or OpenCV YAML file</source>
        <translation>Prendre l’objectif d’une caméra dans un fichier YAML de ROS ou d’OpenCV</translation>
    </message>
    <message>
        <source>New marker &amp;layout…</source>
        <translation>Nouveau plan de &amp;marqueurs…</translation>
    </message>
    <message>
        <source>New layout…</source>
        <translation>Nouveau plan…</translation>
    </message>
    <message>
        <source>Enter the marker positions, from scratch or based on the selected layout</source>
        <translation>Indiquer où se trouvent les marqueurs, depuis zéro ou d’après le plan choisi</translation>
    </message>
    <message>
        <source>Import &amp;marker layout…</source>
        <translation>Importer un pla&amp;n de marqueurs…</translation>
    </message>
    <message>
        <source>Import layout…</source>
        <translation>Importer plan…</translation>
    </message>
    <message>
        <source>Import the marker positions from a table</source>
        <translation>Prendre les places des marqueurs dans un tableau</translation>
    </message>
    <message>
        <source>Print &amp;targets…</source>
        <translation>Imprimer des &amp;cibles…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Imprimer…</translation>
    </message>
    <message>
        <source>Calibration boards and floor markers, to scale</source>
        <translation>Mires pour l’objectif et marqueurs pour le sol, à l’échelle</translation>
    </message>
    <message>
        <source>Camera %1 is calibrated. %2</source>
        <translation>La caméra %1 est étalonnée. %2</translation>
    </message>
    <message>
        <source>Camera %1 is registered. %2</source>
        <translation>La caméra %1 est localisée. %2</translation>
    </message>
    <message>
        <source>Camera %1 is registered via camera %2. %3</source>
        <translation>La caméra %1 est localisée par la caméra %2. %3</translation>
    </message>
    <message>
        <source>The cameras of layout %1 are registered jointly. %2</source>
        <translation>Les caméras du plan %1 sont localisées ensemble. %2</translation>
    </message>
    <message>
        <source>Lens calibration of a camera</source>
        <translation>Paramètres intrinsèques d’une caméra</translation>
    </message>
    <message>
        <source>Import lens calibration</source>
        <translation>Importer des paramètres intrinsèques</translation>
    </message>
    <message>
        <source>Camera:</source>
        <translation>Caméra&#xa0;:</translation>
    </message>
    <message>
        <source>Lens calibration of camera %1 imported from %2.</source>
        <translation>L’objectif de la caméra %1 a été repris de %2.</translation>
    </message>
    <message>
        <source>Positions of the markers (label,x_mm,y_mm)</source>
        <translation>Places des marqueurs (label,x_mm,y_mm)</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>Tableaux (*.csv *.txt);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Layout %1 has %2 markers.</source>
        <translation>Le plan %1 a %2 marqueurs.</translation>
    </message>
    <message>
        <source>Calibrations (*.yaml *.yml *.json *.toml *.ini);;All files (*)</source>
        <translation>Étalonnages (*.yaml *.yml *.json *.toml *.ini);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The file holds several cameras. Which one is %1?</source>
        <translation>Le fichier contient plusieurs caméras. Laquelle est %1 ?</translation>
    </message>
</context>
<context>
    <name>odo::TimeSlider</name>
    <message>
        <source>Time of the trial</source>
        <translation>Temps de l’essai</translation>
    </message>
</context>
<context>
    <name>odo::Timeline</name>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lecture ou pause</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>Image p&amp;récédente</translation>
    </message>
    <message>
        <source>One frame &amp;forward</source>
        <translation>Image suiva&amp;nte</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>Une seconde en arrière</translation>
    </message>
    <message>
        <source>One second forward</source>
        <translation>Une seconde en avant</translation>
    </message>
    <message>
        <source>Play backwards, again: faster</source>
        <translation>Lire en arrière, de nouveau&#xa0;: plus vite</translation>
    </message>
    <message>
        <source>&amp;Stop; while held, the keys beside it step one frame</source>
        <translation>&amp;Arrêter&#xa0;; maintenue, ses voisines vont image par image</translation>
    </message>
    <message>
        <source>Play forwards, again: faster</source>
        <translation>Lire en avant, de nouveau&#xa0;: plus vite</translation>
    </message>
    <message>
        <source>To the first frame</source>
        <translation>À la première image</translation>
    </message>
    <message>
        <source>To the last frame</source>
        <translation>À la dernière image</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Boucle</translation>
    </message>
    <message>
        <source>Selection beg&amp;ins here</source>
        <translation>&amp;Début de la sélection ici</translation>
    </message>
    <message>
        <source>Selection &amp;ends here</source>
        <translation>&amp;Fin de la sélection ici</translation>
    </message>
    <message>
        <source>&amp;Clear the selection</source>
        <translation>&amp;Effacer la sélection</translation>
    </message>
</context>
<context>
    <name>odo::TimelineBar</name>
    <message>
        <source>Timeline</source>
        <translation>Ligne de temps</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Vitesse de lecture</translation>
    </message>
    <message>
        <source>To the first frame (Home)</source>
        <translation>À la première image (Début)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Lecture (Espace)</translation>
    </message>
    <message>
        <source>To the last frame (End)</source>
        <translation>À la dernière image (Fin)</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>aucune image</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>image %1 sur %2</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pause (Espace)</translation>
    </message>
</context>
<context>
    <name>odo::TrackDialog</name>
    <message>
        <source>Robots to track</source>
        <translation>Robots à suivre</translation>
    </message>
    <message>
        <source>Track %1</source>
        <translation>Suivre %1</translation>
    </message>
    <message>
        <source>Kalman/RTS, noise from the data (best)</source>
        <translation>Kalman/RTS, bruit d’après les données (le mieux)</translation>
    </message>
    <message>
        <source>Savitzky–Golay</source>
        <translation>Savitzky–Golay</translation>
    </message>
    <message>
        <source>Differences as in Tracker</source>
        <translation>Différences comme dans Tracker</translation>
    </message>
    <message>
        <source>None: raw differences</source>
        <translation>Aucun&#xa0;: différences brutes</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>&amp;Robots</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>&amp;Lissage</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Suivre</translation>
    </message>
</context>
<context>
    <name>odo::TrackPreview</name>
    <message>
        <source>%1: too long to be shown before the import</source>
        <translation>%1 : trop long pour être montré avant l’importation</translation>
    </message>
    <message>
        <source>%1, track %2</source>
        <translation>%1, trajectoire %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2, %n lines in %3 s</source>
        <translation>
            <numerusform>%1 : %2, %n ligne en %3 s</numerusform>
            <numerusform>%1 : %2, %n lignes en %3 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrackReadingForm</name>
    <message>
        <source>&amp;Unit of positions</source>
        <translation>&amp;Unité des positions</translation>
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
        <translation>pixels</translation>
    </message>
    <message>
        <source>Unit of t&amp;imes</source>
        <translation>Unité des t&amp;emps</translation>
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
        <translation>numéros d’image</translation>
    </message>
    <message>
        <source>F&amp;loor axes</source>
        <translation>Axes du so&amp;l</translation>
    </message>
    <message>
        <source>x and y</source>
        <translation>x et y</translation>
    </message>
    <message>
        <source>x and z</source>
        <translation>x et z</translation>
    </message>
    <message>
        <source>y and z</source>
        <translation>y et z</translation>
    </message>
    <message>
        <source>&amp;Decimal sign</source>
        <translation>Signe &amp;décimal</translation>
    </message>
    <message>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>virgule</translation>
    </message>
    <message>
        <source>&amp;Frame rate</source>
        <translation>&amp;Fréquence d’images</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> images/s</translation>
    </message>
    <message>
        <source>Of a file that numbers its frames</source>
        <translation>D’un fichier qui numérote ses images</translation>
    </message>
    <message>
        <source>Length of a &amp;pixel</source>
        <translation>Lon&amp;gueur d’un pixel</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>On the floor, for positions in pixels</source>
        <translation>Au sol, pour des positions en pixels</translation>
    </message>
    <message>
        <source>Least &amp;confidence</source>
        <translation>&amp;Confiance minimale</translation>
    </message>
    <message>
        <source>Positions with a lower likelihood count as not measured</source>
        <translation>Les positions de vraisemblance plus basse comptent comme non mesurées</translation>
    </message>
    <message>
        <source>Accurac&amp;y</source>
        <translation>E&amp;xactitude</translation>
    </message>
    <message>
        <source>Standard deviation of the positions, slow errors included; scatter alone does not show those</source>
        <translation>Écart type des positions, erreurs lentes comprises ; la dispersion seule ne les montre pas</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>du fichier</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pieds</translation>
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
        <translation>jours</translation>
    </message>
</context>
<context>
    <name>odo::TransferActions</name>
    <message>
        <source>&amp;Pack into one file…</source>
        <translation>&amp;Empaqueter en un fichier…</translation>
    </message>
    <message>
        <source>&amp;Unpack a packed project…</source>
        <translation>Dépaque&amp;ter un projet…</translation>
    </message>
    <message>
        <source>Find &amp;lost videos…</source>
        <translation>Retrouver les vidéos &amp;perdues…</translation>
    </message>
    <message>
        <source>Pack the project with its videos</source>
        <translation>Empaqueter le projet avec ses vidéos</translation>
    </message>
    <message>
        <source>Packed projects (*%1)</source>
        <translation>Projets empaquetés (*%1)</translation>
    </message>
    <message>
        <source>Project packed into %1. To use it on another computer, choose &quot;Unpack a packed project&quot; there.</source>
        <translation>Le projet est empaqueté dans %1. Ailleurs, on le dépaquète par «&#xa0;Dépaqueter un projet&#xa0;».</translation>
    </message>
    <message>
        <source>Note: %1.</source>
        <translation>Remarque&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Unpack a packed project</source>
        <translation>Dépaqueter un projet</translation>
    </message>
    <message>
        <source>Packed projects (*%1);;All files (*)</source>
        <translation>Projets empaquetés (*%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Choose a folder for the unpacked project</source>
        <translation>Où dépaqueter le projet&#xa0;?</translation>
    </message>
    <message>
        <source>Choose the folder to search for the lost videos (with subfolders)</source>
        <translation>Dans quel dossier, ou sous lequel, peuvent être les vidéos perdues&#xa0;?</translation>
    </message>
    <message>
        <source>Found %1 of %2 lost videos by their content.</source>
        <translation>Vidéos perdues retrouvées, d’après leur contenu&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>Find &amp;stray files…</source>
        <translation>Retrouver les &amp;fichiers orphelins…</translation>
    </message>
    <message>
        <source>Every file in the media folder belongs to a trial, a lens calibration or a floor registration.</source>
        <translation>Chaque fichier du dossier des médias appartient à un essai, à un étalonnage d’objectif ou à une localisation de caméra.</translation>
    </message>
    <message>
        <source>Stray files</source>
        <translation>Fichiers orphelins</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) in the media folder belong to no trial, lens calibration or floor registration.</source>
        <translation>
            <numerusform>%n fichier du dossier des médias n’appartient à aucun essai, étalonnage d’objectif ni localisation de caméra.</numerusform>
            <numerusform>%n fichiers du dossier des médias n’appartiennent à aucun essai, étalonnage d’objectif ni localisation de caméra.</numerusform>
        </translation>
    </message>
    <message>
        <source>You can add videos as trials. Removed files are gone for good.</source>
        <translation>Les vidéos peuvent devenir des essais à part entière. Les fichiers supprimés le sont définitivement.</translation>
    </message>
    <message>
        <source>&amp;Add videos as trials</source>
        <translation>&amp;Ajouter les vidéos comme essais</translation>
    </message>
    <message>
        <source>&amp;Remove files</source>
        <translation>&amp;Supprimer les fichiers</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) added. Their names begin with &quot;recovered&quot;.</source>
        <translation>
            <numerusform>%n essai ajouté. Son nom commence par « recovered ».</numerusform>
            <numerusform>%n essais ajoutés. Leurs noms commencent par « recovered ».</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stray file(s) removed.</source>
        <translation>
            <numerusform>%n fichier orphelin supprimé.</numerusform>
            <numerusform>%n fichiers orphelins supprimés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other file(s), listed last, stay: missing recordings, projects, and files that are neither videos nor images.</source>
        <translation>
            <numerusform>%n autre fichier, en fin de liste, reste : un enregistrement manquant, un projet ou ce qui n’est ni vidéo ni image.</numerusform>
            <numerusform>%n autres fichiers, en fin de liste, restent : des enregistrements manquants, des projets et ce qui n’est ni vidéo ni image.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrendChart</name>
    <message>
        <source>Progress of the team</source>
        <translation>Progrès de l’équipe</translation>
    </message>
    <message>
        <source>%1: %2 trials, progress: %3</source>
        <translation>%1&#xa0;: %2 essais, progrès&#xa0;: %3</translation>
    </message>
    <message>
        <source>No team is selected</source>
        <translation>Aucune équipe n’est sélectionnée</translation>
    </message>
    <message>
        <source>Select a team to see its results over the term.</source>
        <translation>Sélectionnez une équipe pour voir ses essais au fil du temps.</translation>
    </message>
</context>
<context>
    <name>odo::TrialActions</name>
    <message>
        <source>%1 in %2 of %3 frames, spikes flagged: %4</source>
        <translation>%1 dans %2 images sur %3, pics aberrants signalés&#xa0;: %4</translation>
    </message>
    <message>
        <source>%1 is tracked: %2.</source>
        <translation>%1 est suivi&#xa0;: %2.</translation>
    </message>
    <message>
        <source>%1 is imported.</source>
        <translation>%1 est importé.</translation>
    </message>
    <message>
        <source>&amp;Import trial from videos…</source>
        <translation>&amp;Importer les vidéos d’un essai…</translation>
    </message>
    <message>
        <source>Import finished tra&amp;cks…</source>
        <translation>Importer des tra&amp;jectoires…</translation>
    </message>
    <message>
        <source>&amp;Track…</source>
        <translation>&amp;Suivre…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporter…</translation>
    </message>
    <message>
        <source>Export &amp;video…</source>
        <translation>Exporter la &amp;vidéo…</translation>
    </message>
    <message>
        <source>Add &amp;robot…</source>
        <translation>Ajouter un &amp;robot…</translation>
    </message>
    <message>
        <source>The sample at %1 of %2 is not used. Choose Undo to use it.</source>
        <translation>L’échantillon à %1 de %2 n’est pas utilisé. Annuler revient en arrière.</translation>
    </message>
    <message>
        <source>The sample at %1 of %2 is used. Choose Undo to reverse this.</source>
        <translation>L’échantillon à %1 de %2 est utilisé. Annuler revient en arrière.</translation>
    </message>
    <message>
        <source>Video of %1</source>
        <translation>Vidéo de %1</translation>
    </message>
    <message>
        <source>MP4 videos (*.mp4)</source>
        <translation>Vidéos MP4 (*.mp4)</translation>
    </message>
    <message>
        <source>Video of %1 saved as %2</source>
        <translation>La vidéo de %1 est prête&#xa0;: %2</translation>
    </message>
    <message>
        <source>Robot %1 added.</source>
        <translation>Le robot %1 est maintenant connu.</translation>
    </message>
    <message>
        <source>%1 is synchronised.</source>
        <translation>%1 est synchronisé.</translation>
    </message>
    <message>
        <source>S&amp;ynchronise…</source>
        <translation>S&amp;ynchroniser…</translation>
    </message>
    <message>
        <source>The results of %1 are of its range, %2 to %3. Choose Undo to reverse this.</source>
        <translation>Les résultats de %1 portent sur sa plage, de %2 à %3. Choisissez Annuler pour revenir en arrière.</translation>
    </message>
    <message>
        <source>The results of %1 are of the whole run.</source>
        <translation>Les résultats de %1 portent sur tout le parcours.</translation>
    </message>
    <message>
        <source>E&amp;dit…</source>
        <translation>Mo&amp;difier…</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) changed. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>%n essai modifié. Choisissez Annuler pour revenir en arrière.</numerusform>
            <numerusform>%n essais modifiés. Choisissez Annuler pour revenir en arrière.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are not used. Choose Undo to use them.</source>
        <translation>
            <numerusform>%n échantillon de %1 n’est pas utilisé. Choisissez Annuler pour l’utiliser.</numerusform>
            <numerusform>%n échantillons de %1 ne sont pas utilisés. Choisissez Annuler pour les utiliser.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples of %1 are used. Choose Undo to reverse this.</source>
        <translation>
            <numerusform>%n échantillon de %1 est utilisé. Choisissez Annuler pour revenir en arrière.</numerusform>
            <numerusform>%n échantillons de %1 sont utilisés. Choisissez Annuler pour revenir en arrière.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>odo::TrialChooser</name>
    <message>
        <source>&amp;Previous trial</source>
        <translation>Essai &amp;précédent</translation>
    </message>
    <message>
        <source>&amp;Next trial</source>
        <translation>Essai s&amp;uivant</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
</context>
<context>
    <name>odo::TrialColumns</name>
    <message>
        <source>&amp;Columns</source>
        <translation>&amp;Colonnes</translation>
    </message>
</context>
<context>
    <name>odo::TrialDetail</name>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Épreuve</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>none: the track was imported</source>
        <translation>aucune&#xa0;: la trajectoire a été importée</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Score</translation>
    </message>
    <message>
        <source>none: analysed with a different course than its task has now. Reanalyse the trial</source>
        <translation>aucun&#xa0;: il a été mesuré sur un autre parcours que celui de son épreuve&#xa0;; remesurez-le</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>none yet: open it and choose Track</source>
        <translation>pas encore&#xa0;: ouvrez-le et choisissez «&#xa0;Suivre&#xa0;»</translation>
    </message>
    <message>
        <source>Open in Review</source>
        <translation>Examiner</translation>
    </message>
    <message>
        <source>Facts of the trial</source>
        <translation>Données de l’essai</translation>
    </message>
    <message>
        <source>Notes of the trial</source>
        <translation>Notes de l’essai</translation>
    </message>
    <message>
        <source>What did you change on the robot? What do you want to remember?</source>
        <translation>Qu’est-ce qui a été changé sur le robot&#xa0;? Que faut-il retenir&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>&amp;Notes</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>No trials yet</source>
        <translation>Pas encore d’essai</translation>
    </message>
    <message>
        <source>No trial selected</source>
        <translation>Aucun essai sélectionné</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
</context>
<context>
    <name>odo::TrialFilterBar</name>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Any class</source>
        <translation>Toute classe</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Any team</source>
        <translation>Toute équipe</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Épreuve</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>Toute épreuve</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Any robot</source>
        <translation>Tout robot</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Any date</source>
        <translation>Toute date</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Aujourd’hui</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>7 derniers jours</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>30 derniers jours</translation>
    </message>
    <message>
        <source>Last 12 months</source>
        <translation>12 derniers mois</translation>
    </message>
    <message>
        <source>Between…</source>
        <translation>Entre…</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archive</translation>
    </message>
    <message>
        <source>Bin</source>
        <translation>Corbeille</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Du</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Au</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>Avec étoile</translation>
    </message>
    <message>
        <source>Only starred trials</source>
        <translation>Essais avec étoile seulement</translation>
    </message>
    <message>
        <source>Show only starred trials</source>
        <translation>Ne montrer que les essais avec étoile</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>Douteux</translation>
    </message>
    <message>
        <source>Only trials with doubtful or bad results</source>
        <translation>Seulement les essais aux résultats douteux ou mauvais</translation>
    </message>
    <message>
        <source>Show only trials with doubtful or bad results</source>
        <translation>Montrer seulement les essais aux résultats douteux ou mauvais</translation>
    </message>
</context>
<context>
    <name>odo::TrialModel</name>
    <message>
        <source>not tracked</source>
        <translation>non suivi</translation>
    </message>
    <message>
        <source>reanalyse</source>
        <translation>à remesurer</translation>
    </message>
    <message>
        <source>starred</source>
        <translation>avec étoile</translation>
    </message>
    <message>
        <source>not starred</source>
        <translation>sans étoile</translation>
    </message>
    <message>
        <source>Tags, separated by commas: double-click or F2 changes them</source>
        <translation>Étiquettes, séparées par des virgules&#xa0;: un double-clic ou F2 les modifie</translation>
    </message>
    <message>
        <source>Star (Ctrl+D)</source>
        <translation>Étoile (Ctrl+D)</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Étoile</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Équipe</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Épreuve</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>Vitesse max.</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Score</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
</context>
<context>
    <name>odo::TrialTable</name>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
</context>
<context>
    <name>odo::UndoActions</name>
    <message>
        <source>Undone: %1.</source>
        <translation>Annulé&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Rétabli&#xa0;: %1.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>odo::VariableTable</name>
    <message>
        <source>several</source>
        <translation>plusieurs</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Variables of your own</source>
        <translation>Variables personnelles</translation>
    </message>
    <message>
        <source>What you want to compare runs by: surface, battery, attempt. Text or a number.</source>
        <translation>Ce selon quoi vous voulez comparer les parcours : surface, batterie, tentative. Du texte ou un nombre.</translation>
    </message>
</context>
<context>
    <name>odo::VideoDialog</name>
    <message>
        <source>Real time</source>
        <translation>Vitesse réelle</translation>
    </message>
    <message>
        <source>Slow motion, 1/2</source>
        <translation>Ralenti, 1/2</translation>
    </message>
    <message>
        <source>Slow motion, 1/4</source>
        <translation>Ralenti, 1/4</translation>
    </message>
    <message>
        <source>Slow motion, 1/10</source>
        <translation>Ralenti, 1/10</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>One video with all camera views, the map and the speed, to show or send. It plays without Odograph.</source>
        <translation>Une vidéo avec les images de toutes les caméras, la carte et la vitesse, à montrer ou à envoyer&#xa0;: qui la reçoit n’a pas besoin d’Odograph.</translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation>&amp;Vitesse</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>Ta&amp;ille</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Choisir un emplacement…</translation>
    </message>
</context>
<context>
    <name>odo::ViewActions</name>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Disposition par &amp;défaut</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Pl&amp;ein écran</translation>
    </message>
    <message>
        <source>Colours of the &amp;desktop</source>
        <translation>Couleurs du &amp;bureau</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>&amp;Sombre</translation>
    </message>
</context>
<context>
    <name>odo::ViewSteps</name>
    <message>
        <source>Same start time</source>
        <translation>Commencées ensemble</translation>
    </message>
    <message>
        <source>By hand: time offset</source>
        <translation>À la main&#xa0;: commencée plus tard de</translation>
    </message>
    <message>
        <source>How to synchronise view %1 with the first</source>
        <translation>Comment la vue %1 est synchronisée avec la première</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time offset of view %1</source>
        <translation>De combien la vue %1 a commencé plus tard</translation>
    </message>
    <message>
        <source>Negative: it started before the first view</source>
        <translation>Inférieur à zéro&#xa0;: elle a commencé plus tôt que la première vue</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vue %1</translation>
    </message>
    <message>
        <source>Automatic: motion, flash or sound</source>
        <translation>Automatique&#xa0;: mouvement, éclair ou son</translation>
    </message>
    <message>
        <source>By the motion</source>
        <translation>D’après le mouvement</translation>
    </message>
    <message>
        <source>By a flash of light</source>
        <translation>D’après un éclair de lumière</translation>
    </message>
    <message>
        <source>By sound</source>
        <translation>D’après le son</translation>
    </message>
    <message>
        <source>A flash: switch the room lights on and off once while all cameras record. Sound: clap twice near the middle of the floor</source>
        <translation>Éclair&#xa0;: allumez et éteignez une fois la lumière de la salle pendant que toutes les caméras filment. Son&#xa0;: tapez deux fois dans vos mains près du milieu du sol</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Tel quel</translation>
    </message>
</context>
<context>
    <name>odo::WarningBar</name>
    <message>
        <source>Problem</source>
        <translation>Ce qui ne va pas</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>Corriger</translation>
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
        <translation>Mesure comment un robot mobile s’est déplacé, à partir des vidéos de caméras ordinaires.</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Projets récents</translation>
    </message>
    <message>
        <source>no longer found</source>
        <translation>introuvable</translation>
    </message>
</context>
<context>
    <name>odo::Workspace</name>
    <message>
        <source>%1: %2. It is read-only here; to change it, close it there and reopen it here.</source>
        <translation>%1&#xa0;: %2. Ici, il ne peut qu’être consulté&#xa0;; pour le modifier, fermez-le là-bas et rouvrez-le ici.</translation>
    </message>
    <message>
        <source>The backup was restored. The damaged file is kept as “%1”.</source>
        <translation>La copie de sauvegarde a été restaurée. Le fichier endommagé est conservé sous « %1 ».</translation>
    </message>
    <message>
        <source>“%1” was written before you cancelled. It was not opened.</source>
        <translation>«&#xa0;%1&#xa0;» était déjà écrit lors de l’annulation. Il n’a pas été ouvert.</translation>
    </message>
    <message>
        <source>The backup was restored. What the project was before is kept as “%1”.</source>
        <translation>La copie de sauvegarde a été restaurée. L’état précédent du projet est conservé sous « %1 ».</translation>
    </message>
</context>
<context>
    <name>odo::ZoneTable</name>
    <message>
        <source>stay inside</source>
        <translation>rester dedans</translation>
    </message>
    <message>
        <source>keep out</source>
        <translation>rester dehors</translation>
    </message>
    <message>
        <source>Remo&amp;ve zone</source>
        <translation>&amp;Retirer la zone</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Règle</translation>
    </message>
    <message>
        <source>Corners: x y; x y; … in mm</source>
        <translation>Sommets&#xa0;: x y; x y; … en mm</translation>
    </message>
    <message>
        <source>Zones of the floor</source>
        <translation>Zones du sol</translation>
    </message>
    <message>
        <source>Add zone to sta&amp;y in</source>
        <translation>Zone où re&amp;ster</translation>
    </message>
    <message>
        <source>Add zone to &amp;keep out of</source>
        <translation>Ajouter une zone à évi&amp;ter</translation>
    </message>
    <message>
        <source>The robot&apos;s reference point must stay in a zone or keep out of it. Each zone counts separately; you can score how often, how long and how far a robot broke it. Drag corners and edges on the map.</source>
        <translation>Le centre du robot doit rester dans une zone, ou en dehors. Chacune est jugée séparément&#xa0;; combien de fois, combien de temps et de combien elle a été enfreinte peut compter au barème. Faites glisser sommets et bords sur la carte.</translation>
    </message>
    <message>
        <source>Rule of the zone</source>
        <translation>Règle de la zone</translation>
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
        <translation>raison d’accepter les résultats</translation>
    </message>
</context>
<context>
    <name>project.add_another_layout</name>
    <message>
        <source>add another layout for other markers</source>
        <translation>ajoutez un autre plan pour d’autres marqueurs</translation>
    </message>
</context>
<context>
    <name>project.add_one_first</name>
    <message>
        <source>add one first</source>
        <translation>ajoutez-en d’abord</translation>
    </message>
</context>
<context>
    <name>project.add_what_it_refers_to</name>
    <message>
        <source>add what it refers to first</source>
        <translation>ajoutez d’abord ce à quoi il renvoie</translation>
    </message>
</context>
<context>
    <name>project.adopt_or_remove</name>
    <message>
        <source>make a trial of it with odograph check P.odo --adopt, or remove it with --remove-strays; the window offers both under &apos;Find stray files…&apos;</source>
        <translation>faites-en un essai ou supprimez-le sous «&#xa0;Retrouver les fichiers orphelins…&#xa0;»</translation>
    </message>
</context>
<context>
    <name>project.an_analysis</name>
    <message>
        <source>analysis of a trial</source>
        <translation>analyse d’un essai</translation>
    </message>
</context>
<context>
    <name>project.analyse_again</name>
    <message>
        <source>reanalyse the trial</source>
        <translation>réanalysez l’essai</translation>
    </message>
</context>
<context>
    <name>project.analysis_number</name>
    <message>
        <source>analysis %1</source>
        <translation>analyse %1</translation>
    </message>
</context>
<context>
    <name>project.analysis_of_project</name>
    <message>
        <source>analysis %1 of the project</source>
        <translation>analyse %1 du projet</translation>
    </message>
</context>
<context>
    <name>project.another_program_writes</name>
    <message>
        <source>another program is writing to it</source>
        <translation>un autre programme y écrit</translation>
    </message>
</context>
<context>
    <name>project.area_few_corners</name>
    <message>
        <source>an area needs at least %1 corners</source>
        <translation>une zone a besoin d’au moins %1 coins</translation>
    </message>
</context>
<context>
    <name>project.area_many_corners</name>
    <message>
        <source>an area has at most %1 corners</source>
        <translation>une zone a au plus %1 coins</translation>
    </message>
</context>
<context>
    <name>project.area_off_frame</name>
    <message>
        <source>a position is not in the frame</source>
        <translation>une position n’est pas dans l’image</translation>
    </message>
</context>
<context>
    <name>project.being_recorded</name>
    <message>
        <source>it is being recorded</source>
        <translation>il est en cours d’enregistrement</translation>
    </message>
</context>
<context>
    <name>project.calibration_of_project</name>
    <message>
        <source>calibration %1 of the project</source>
        <translation>étalonnage %1 du projet</translation>
    </message>
</context>
<context>
    <name>project.calibration_origin</name>
    <message>
        <source>origin of a calibration</source>
        <translation>origine d’un étalonnage</translation>
    </message>
</context>
<context>
    <name>project.calibration_picture_of</name>
    <message>
        <source>the calibration image &apos;%1&apos; of camera &apos;%2&apos;</source>
        <translation>la photo d’étalonnage &apos;%1&apos; de la caméra &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>project.camera_address</name>
    <message>
        <source>address of a camera</source>
        <translation>adresse d’une caméra</translation>
    </message>
</context>
<context>
    <name>project.cannot_be_written_to</name>
    <message>
        <source>it cannot be written to</source>
        <translation>il ne peut pas être modifié</translation>
    </message>
</context>
<context>
    <name>project.cannot_hold</name>
    <message>
        <source>cannot hold %1</source>
        <translation>impossible de verrouiller %1</translation>
    </message>
</context>
<context>
    <name>project.cannot_record_into</name>
    <message>
        <source>cannot record into %1</source>
        <translation>impossible d’enregistrer dans %1</translation>
    </message>
</context>
<context>
    <name>project.cannot_remove</name>
    <message>
        <source>cannot remove &apos;%1&apos;</source>
        <translation>impossible de supprimer &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.change_list</name>
    <message>
        <source>the list of changes</source>
        <translation>la liste des modifications</translation>
    </message>
</context>
<context>
    <name>project.change_not_noted</name>
    <message>
        <source>the change could not be logged (%1)</source>
        <translation>la modification n’a pas pu être notée (%1)</translation>
    </message>
</context>
<context>
    <name>project.change_something_first</name>
    <message>
        <source>change something first</source>
        <translation>changez d’abord quelque chose</translation>
    </message>
</context>
<context>
    <name>project.change_words</name>
    <message>
        <source>description of a change</source>
        <translation>libellé d’une modification</translation>
    </message>
</context>
<context>
    <name>project.changed_since</name>
    <message>
        <source>something it concerns has been changed or used since</source>
        <translation>ce que cela concerne a été changé ou utilisé depuis</translation>
    </message>
</context>
<context>
    <name>project.check</name>
    <message>
        <source>check of the project</source>
        <translation>vérification du projet</translation>
    </message>
</context>
<context>
    <name>project.check_disk</name>
    <message>
        <source>check the disk</source>
        <translation>vérifiez le disque</translation>
    </message>
</context>
<context>
    <name>project.check_disk_and_retry</name>
    <message>
        <source>check the disk and try again</source>
        <translation>vérifiez le disque et réessayez</translation>
    </message>
</context>
<context>
    <name>project.check_folder_is_there</name>
    <message>
        <source>check that the folder exists and that you may read it</source>
        <translation>vérifiez que le dossier est là et peut être lu</translation>
    </message>
</context>
<context>
    <name>project.check_its_input</name>
    <message>
        <source>check the input that it was computed from</source>
        <translation>vérifiez les données dont elle a été calculée</translation>
    </message>
</context>
<context>
    <name>project.check_name_or_make</name>
    <message>
        <source>check the name, or create a new project</source>
        <translation>vérifiez le nom, ou créez un nouveau projet</translation>
    </message>
</context>
<context>
    <name>project.check_project_folder</name>
    <message>
        <source>check the free space and the permissions of the project&apos;s folder</source>
        <translation>vérifiez la place libre et les droits du dossier du projet</translation>
    </message>
</context>
<context>
    <name>project.check_rights</name>
    <message>
        <source>check the permissions of the project&apos;s folder</source>
        <translation>vérifiez les droits du dossier du projet</translation>
    </message>
</context>
<context>
    <name>project.checking</name>
    <message>
        <source>checking %1</source>
        <translation>vérification de %1</translation>
    </message>
</context>
<context>
    <name>project.checking_database</name>
    <message>
        <source>checking the database</source>
        <translation>vérification de la base de données</translation>
    </message>
</context>
<context>
    <name>project.choose_from_list</name>
    <message>
        <source>choose one from the list</source>
        <translation>choisissez-en un dans la liste</translation>
    </message>
</context>
<context>
    <name>project.choose_its_own</name>
    <message>
        <source>choose one of its own (odograph revisions P.odo CAMERA --use), or restore the project from a backup copy</source>
        <translation>choisissez une de ses propres révisions («&#xa0;Étalonnages antérieurs…&#xa0;»), ou restaurez le projet d’une copie de sauvegarde</translation>
    </message>
</context>
<context>
    <name>project.choose_our_file</name>
    <message>
        <source>choose a file that Odograph has written</source>
        <translation>choisissez un fichier écrit par Odograph</translation>
    </message>
</context>
<context>
    <name>project.choose_writable_folder</name>
    <message>
        <source>choose a folder that can be written to and has free space</source>
        <translation>choisissez un dossier modifiable et qui a de la place</translation>
    </message>
</context>
<context>
    <name>project.class_has_team</name>
    <message>
        <source>a team belongs to it</source>
        <translation>une équipe en fait partie</translation>
    </message>
</context>
<context>
    <name>project.class_has_teams</name>
    <message>
        <source>%1 teams belong to it</source>
        <translation>%1 équipes en font partie</translation>
    </message>
</context>
<context>
    <name>project.close_it_there</name>
    <message>
        <source>close it there first</source>
        <translation>fermez-le d’abord là-bas</translation>
    </message>
</context>
<context>
    <name>project.close_other_program</name>
    <message>
        <source>close the other program and try again</source>
        <translation>fermez l’autre programme et réessayez</translation>
    </message>
</context>
<context>
    <name>project.complete_recording</name>
    <message>
        <source>to complete it, open the project for writing: odograph record P.odo --recover</source>
        <translation>ouvrez le projet en écriture, ce qui complète l’enregistrement</translation>
    </message>
</context>
<context>
    <name>project.copy</name>
    <message>
        <source>copy &apos;%1&apos;</source>
        <translation>copie &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.copy_again</name>
    <message>
        <source>copy it again from its source, or restore a backup copy</source>
        <translation>recopiez-le depuis sa source, ou restaurez une copie de sauvegarde</translation>
    </message>
</context>
<context>
    <name>project.copy_differs</name>
    <message>
        <source>the copy differs from what was written</source>
        <translation>la copie diffère de ce qui a été écrit</translation>
    </message>
</context>
<context>
    <name>project.copy_file_beside</name>
    <message>
        <source>copy the file to the project&apos;s folder</source>
        <translation>copiez le fichier à côté du projet</translation>
    </message>
</context>
<context>
    <name>project.copy_of_project</name>
    <message>
        <source>copy of project &apos;%1&apos;</source>
        <translation>copie du projet &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.copy_sound_backup</name>
    <message>
        <source>copy &apos;%1&apos;, which is intact, to a new name, open that copy and keep the damaged file</source>
        <translation>copiez « %1 », qui est intact, sous un nouveau nom et ouvrez cette copie, et gardez le fichier endommagé</translation>
    </message>
</context>
<context>
    <name>project.copy_to_another_disk</name>
    <message>
        <source>check the disk, and copy the project to another one</source>
        <translation>vérifiez le disque, et copiez le projet sur un autre</translation>
    </message>
</context>
<context>
    <name>project.copy_to_writable_folder</name>
    <message>
        <source>copy it to a folder that you may write to, and open the copy</source>
        <translation>copiez-le dans un dossier où vous pouvez écrire, et ouvrez la copie</translation>
    </message>
</context>
<context>
    <name>project.copy_with_side_files</name>
    <message>
        <source>copy it with the files beside it to a folder that you may write to, and open the copy</source>
        <translation>copiez-le avec les fichiers voisins dans un dossier où vous pouvez écrire, et ouvrez la copie</translation>
    </message>
</context>
<context>
    <name>project.copy_with_videos</name>
    <message>
        <source>copy it with its videos to a folder that you may write to, and open the copy</source>
        <translation>copiez-le avec ses vidéos dans un dossier où vous pouvez écrire, et ouvrez la copie</translation>
    </message>
</context>
<context>
    <name>project.corners_of</name>
    <message>
        <source>corners of &apos;%1&apos;</source>
        <translation>coins de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.covariance_not_6_by_6</name>
    <message>
        <source>its stored covariance is not a 6 by 6 matrix</source>
        <translation>sa covariance enregistrée n’est pas une matrice 6 × 6</translation>
    </message>
</context>
<context>
    <name>project.database_refused</name>
    <message>
        <source>the database reported an error</source>
        <translation>la base de données a refusé</translation>
    </message>
</context>
<context>
    <name>project.database_refused_because</name>
    <message>
        <source>the database reported an error (%1)</source>
        <translation>la base de données a refusé (%1)</translation>
    </message>
</context>
<context>
    <name>project.delete_its_trials</name>
    <message>
        <source>delete its trials permanently first, or archive its class</source>
        <translation>supprimez-les d’abord définitivement, ou archivez sa classe</translation>
    </message>
</context>
<context>
    <name>project.disk_error</name>
    <message>
        <source>the disk reported an error, the change was not saved</source>
        <translation>le disque a signalé une erreur, la modification n’a pas été enregistrée</translation>
    </message>
</context>
<context>
    <name>project.disk_full</name>
    <message>
        <source>the disk is full, the change was not saved</source>
        <translation>le disque est plein, la modification n’a pas été enregistrée</translation>
    </message>
</context>
<context>
    <name>project.disk_read_only</name>
    <message>
        <source>the disk has become read-only, the change was not saved</source>
        <translation>le disque est passé en lecture seule, la modification n’a pas été enregistrée</translation>
    </message>
</context>
<context>
    <name>project.disk_unreadable</name>
    <message>
        <source>the disk could not be read; nothing was changed</source>
        <translation>le disque n’a pas pu être lu, et rien n’a été modifié</translation>
    </message>
</context>
<context>
    <name>project.duration_of_recordings_differs</name>
    <message>
        <source>its duration is stored as %1, its recordings last %2</source>
        <translation>la durée enregistrée est %1, ses enregistrements durent %2</translation>
    </message>
</context>
<context>
    <name>project.duration_of_tracks_differs</name>
    <message>
        <source>its duration is stored as %1, its imported tracks last %2</source>
        <translation>la durée enregistrée est %1, ses trajectoires importées durent %2</translation>
    </message>
</context>
<context>
    <name>project.earlier_step_failed</name>
    <message>
        <source>an earlier step of this change failed</source>
        <translation>une étape précédente de cette modification a échoué</translation>
    </message>
</context>
<context>
    <name>project.end_recording_first</name>
    <message>
        <source>end its recording first</source>
        <translation>terminez d’abord son enregistrement</translation>
    </message>
</context>
<context>
    <name>project.figures_without_task</name>
    <message>
        <source>without it, their metrics would not show which rules applied</source>
        <translation>leurs valeurs ne diraient plus avec quoi elles ont été mesurées</translation>
    </message>
</context>
<context>
    <name>project.file_changed</name>
    <message>
        <source>%1 has changed since it was created</source>
        <translation>%1 a changé depuis sa création</translation>
    </message>
</context>
<context>
    <name>project.file_cut_off</name>
    <message>
        <source>the file is incomplete</source>
        <translation>le fichier est tronqué</translation>
    </message>
</context>
<context>
    <name>project.file_damaged</name>
    <message>
        <source>the file is damaged</source>
        <translation>le fichier est endommagé</translation>
    </message>
</context>
<context>
    <name>project.file_lost</name>
    <message>
        <source>its file was deleted, renamed or replaced while it was open; nothing was stored</source>
        <translation>son fichier a été supprimé, renommé ou remplacé pendant qu’il était ouvert ; rien n’a été enregistré</translation>
    </message>
</context>
<context>
    <name>project.file_there_already</name>
    <message>
        <source>a file of that name already exists</source>
        <translation>un fichier de ce nom existe déjà</translation>
    </message>
</context>
<context>
    <name>project.file_unused</name>
    <message>
        <source>no trial, lens calibration or floor registration uses this file</source>
        <translation>aucun essai, étalonnage d’objectif ni localisation de caméra n’utilise ce fichier</translation>
    </message>
</context>
<context>
    <name>project.find_or_put_back</name>
    <message>
        <source>take it from there with odograph check P.odo --find FOLDER or Find lost videos… in the window, or move it back to its folder</source>
        <translation>reprenez-le de là avec «&#xa0;Retrouver les vidéos perdues…&#xa0;», ou remettez-le à sa place</translation>
    </message>
</context>
<context>
    <name>project.folder_read_only</name>
    <message>
        <source>its folder cannot be written to</source>
        <translation>son dossier ne peut pas être modifié</translation>
    </message>
</context>
<context>
    <name>project.foreign_log</name>
    <message>
        <source>the log beside it (&apos;%1&apos;) belongs to another file or to another state of this one</source>
        <translation>le journal à côté (« %1 ») appartient à un autre fichier ou à un autre état de celui-ci</translation>
    </message>
</context>
<context>
    <name>project.format_1</name>
    <message>
        <source>the first schema</source>
        <translation>le premier schéma</translation>
    </message>
</context>
<context>
    <name>project.format_10</name>
    <message>
        <source>for a school year: stars, tags, archive, bin, pseudonyms, scoring and the list of changes</source>
        <translation>ce qu’il faut à une année scolaire&#xa0;: étoiles, étiquettes, archive, corbeille, pseudonymes, barème et liste des modifications</translation>
    </message>
</context>
<context>
    <name>project.format_11</name>
    <message>
        <source>members and robots of teams, zones and the archive of tasks, and imported tracks</source>
        <translation>membres et robots des équipes, zones et archive des épreuves, et trajectoires importées</translation>
    </message>
</context>
<context>
    <name>project.format_12</name>
    <message>
        <source>digests of analyses, and long series in chunks</source>
        <translation>empreintes des analyses, et longues séries en morceaux</translation>
    </message>
</context>
<context>
    <name>project.format_13</name>
    <message>
        <source>reference points of robots</source>
        <translation>le point d’un robot qui est mesuré</translation>
    </message>
</context>
<context>
    <name>project.format_14</name>
    <message>
        <source>periods with ambiguous robot names</source>
        <translation>les moments où des robots de même apparence ne se distinguaient pas</translation>
    </message>
</context>
<context>
    <name>project.format_15</name>
    <message>
        <source>robots marked by hand in a frame</source>
        <translation>robots montrés par une personne dans une image</translation>
    </message>
</context>
<context>
    <name>project.format_16</name>
    <message>
        <source>messages as codes with their arguments</source>
        <translation>phrases sous forme de codes avec leurs arguments</translation>
    </message>
</context>
<context>
    <name>project.format_17</name>
    <message>
        <source>verdicts, and their acceptance</source>
        <translation>les verdicts et leur acceptation</translation>
    </message>
</context>
<context>
    <name>project.format_18</name>
    <message>
        <source>how the frames of recordings are turned</source>
        <translation>la rotation des images des enregistrements</translation>
    </message>
</context>
<context>
    <name>project.format_19</name>
    <message>
        <source>ranges and variables of trials</source>
        <translation>plages et variables des essais</translation>
    </message>
</context>
<context>
    <name>project.format_2</name>
    <message>
        <source>manual overrides of samples</source>
        <translation>échantillons jugés à la main</translation>
    </message>
</context>
<context>
    <name>project.format_20</name>
    <message>
        <source>which observations are in force</source>
        <translation>quelles observations sont en vigueur</translation>
    </message>
</context>
<context>
    <name>project.format_21</name>
    <message>
        <source>guidance of the tracker, and the school&apos;s hub</source>
        <translation>indications pour le suivi et le serveur de l’école</translation>
    </message>
</context>
<context>
    <name>project.format_3</name>
    <message>
        <source>clock rates of the cameras</source>
        <translation>dérives des horloges des caméras</translation>
    </message>
</context>
<context>
    <name>project.format_4</name>
    <message>
        <source>tasks with gates, a reference path and limits</source>
        <translation>épreuves avec portes, tracé de référence et limites</translation>
    </message>
</context>
<context>
    <name>project.format_5</name>
    <message>
        <source>synchronisation of each view</source>
        <translation>comment chaque vue a été synchronisée</translation>
    </message>
</context>
<context>
    <name>project.format_6</name>
    <message>
        <source>calibrations with their boards, corners and images</source>
        <translation>étalonnages avec leurs mires, coins et photos</translation>
    </message>
</context>
<context>
    <name>project.format_7</name>
    <message>
        <source>chosen revisions and registration checks</source>
        <translation>révisions choisies, et contrôles des localisations</translation>
    </message>
</context>
<context>
    <name>project.format_8</name>
    <message>
        <source>trials during recording, and the raw times of their frames</source>
        <translation>essais en cours d’enregistrement, et temps bruts de leurs images</translation>
    </message>
</context>
<context>
    <name>project.format_9</name>
    <message>
        <source>images of registrations</source>
        <translation>photos des localisations</translation>
    </message>
</context>
<context>
    <name>project.frame_times_of</name>
    <message>
        <source>frame times of &apos;%1&apos;</source>
        <translation>temps des images de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.frames_in_wrong_order</name>
    <message>
        <source>it ends before it starts</source>
        <translation>la fin précède le début</translation>
    </message>
</context>
<context>
    <name>project.give_a_height</name>
    <message>
        <source>enter a height, or have it estimated</source>
        <translation>donnez une hauteur, ou laissez-la estimer</translation>
    </message>
</context>
<context>
    <name>project.give_a_name</name>
    <message>
        <source>give the %1 a name</source>
        <translation>donnez un nom (%1)</translation>
    </message>
</context>
<context>
    <name>project.give_a_title</name>
    <message>
        <source>give the project a title</source>
        <translation>donnez un titre au projet</translation>
    </message>
</context>
<context>
    <name>project.give_another_task</name>
    <message>
        <source>give them another task first</source>
        <translation>donnez-leur d’abord une autre épreuve</translation>
    </message>
</context>
<context>
    <name>project.give_fewer_corners</name>
    <message>
        <source>give fewer corners, or two areas</source>
        <translation>donnez moins de coins, ou deux zones</translation>
    </message>
</context>
<context>
    <name>project.give_file_a_name</name>
    <message>
        <source>give the file a name</source>
        <translation>donnez un nom au fichier</translation>
    </message>
</context>
<context>
    <name>project.give_frame_pixels</name>
    <message>
        <source>give positions in pixels of the frame</source>
        <translation>donnez des positions en pixels de l’image</translation>
    </message>
</context>
<context>
    <name>project.give_frames_in_order</name>
    <message>
        <source>give the start before the end</source>
        <translation>donnez le début avant la fin</translation>
    </message>
</context>
<context>
    <name>project.give_members</name>
    <message>
        <source>give the names of the people in the team</source>
        <translation>donnez les noms des personnes de l’équipe</translation>
    </message>
</context>
<context>
    <name>project.give_more_corners</name>
    <message>
        <source>give more corners</source>
        <translation>donnez plus de coins</translation>
    </message>
</context>
<context>
    <name>project.give_robot_size</name>
    <message>
        <source>give length and width in millimetres, like 260x190</source>
        <translation>donnez longueur et largeur en millimètres, comme 260x190</translation>
    </message>
</context>
<context>
    <name>project.give_sigma_px</name>
    <message>
        <source>give σ in pixels</source>
        <translation>donnez σ en pixels</translation>
    </message>
</context>
<context>
    <name>project.give_whole_truth</name>
    <message>
        <source>give position, velocity and acceleration for each time</source>
        <translation>donnez position, vitesse et accélération pour chaque temps</translation>
    </message>
</context>
<context>
    <name>project.guidance</name>
    <message>
        <source>guidance of the tracker</source>
        <translation>indications pour le suivi</translation>
    </message>
</context>
<context>
    <name>project.guidance_is_gone</name>
    <message>
        <source>it was removed meanwhile</source>
        <translation>il a été retiré entre-temps</translation>
    </message>
</context>
<context>
    <name>project.guidance_too_many</name>
    <message>
        <source>the view already has %1 of them</source>
        <translation>la vue en a déjà %1</translation>
    </message>
</context>
<context>
    <name>project.has_bytes_of</name>
    <message>
        <source>it has %1 of %2 bytes</source>
        <translation>il a %1 octets sur %2</translation>
    </message>
</context>
<context>
    <name>project.has_characters</name>
    <message>
        <source>it has %1 characters</source>
        <translation>il a %1 caractères</translation>
    </message>
</context>
<context>
    <name>project.has_names</name>
    <message>
        <source>it has %1</source>
        <translation>présents&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>project.has_none_yet</name>
    <message>
        <source>it has no %1 yet</source>
        <translation>il n’a pas encore de %1</translation>
    </message>
</context>
<context>
    <name>project.has_other_size</name>
    <message>
        <source>%1 has %2 bytes instead of %3</source>
        <translation>%1 a %2 octets au lieu de %3</translation>
    </message>
</context>
<context>
    <name>project.has_robots</name>
    <message>
        <source>it has %1 robots</source>
        <translation>il a %1 robots</translation>
    </message>
</context>
<context>
    <name>project.has_views</name>
    <message>
        <source>it has %1 views</source>
        <translation>il a %1 vues</translation>
    </message>
</context>
<context>
    <name>project.height_below_floor</name>
    <message>
        <source>its height is below the floor</source>
        <translation>sa hauteur est sous le sol</translation>
    </message>
</context>
<context>
    <name>project.height_from_0</name>
    <message>
        <source>give a height of 0 or more</source>
        <translation>donnez une hauteur de 0 ou plus</translation>
    </message>
</context>
<context>
    <name>project.height_not_given</name>
    <message>
        <source>it needs a fixed height, but none is given</source>
        <translation>sa hauteur doit être indiquée, mais aucune ne l’est</translation>
    </message>
</context>
<context>
    <name>project.holds_invisible</name>
    <message>
        <source>it holds an invisible character, %1</source>
        <translation>il contient un caractère invisible, %1</translation>
    </message>
</context>
<context>
    <name>project.holds_line_break</name>
    <message>
        <source>it holds a line break or another control character</source>
        <translation>il contient un saut de ligne ou un autre caractère de contrôle</translation>
    </message>
</context>
<context>
    <name>project.ignored_area</name>
    <message>
        <source>ignored area</source>
        <translation>zone ignorée</translation>
    </message>
</context>
<context>
    <name>project.import_another_file</name>
    <message>
        <source>import another file</source>
        <translation>importez un autre fichier</translation>
    </message>
</context>
<context>
    <name>project.impossible_format</name>
    <message>
        <source>it claims to have format %1</source>
        <translation>il déclare avoir le format %1</translation>
    </message>
</context>
<context>
    <name>project.in_synced_folder</name>
    <message>
        <source>it is in a folder that %1 copies while it changes: a copy may contain half a change</source>
        <translation>il se trouve dans un dossier que %1 copie pendant qu’il change, si bien qu’une copie peut avoir une demi-modification</translation>
    </message>
</context>
<context>
    <name>project.is_missing</name>
    <message>
        <source>%1 is missing</source>
        <translation>%1 manque</translation>
    </message>
</context>
<context>
    <name>project.is_missing_recording</name>
    <message>
        <source>this is a missing recording</source>
        <translation>c’est un enregistrement qui manque</translation>
    </message>
</context>
<context>
    <name>project.journal_of_another</name>
    <message>
        <source>the journal beside it names another file</source>
        <translation>le journal à côté nomme un autre fichier</translation>
    </message>
</context>
<context>
    <name>project.keep_it</name>
    <message>
        <source>keep it</source>
        <translation>gardez-le</translation>
    </message>
</context>
<context>
    <name>project.keep_on_own_disk</name>
    <message>
        <source>keep it on a disk of this computer, and pack it to share it</source>
        <translation>gardez-le sur un disque de cet ordinateur, et empaquetez-le pour le partager</translation>
    </message>
</context>
<context>
    <name>project.kind_calibration</name>
    <message>
        <source>calibration</source>
        <translation>étalonnage</translation>
    </message>
</context>
<context>
    <name>project.kind_camera</name>
    <message>
        <source>camera</source>
        <translation>caméra</translation>
    </message>
</context>
<context>
    <name>project.kind_class</name>
    <message>
        <source>class</source>
        <translation>classe</translation>
    </message>
</context>
<context>
    <name>project.kind_figure</name>
    <message>
        <source>metric</source>
        <translation>grandeur</translation>
    </message>
</context>
<context>
    <name>project.kind_gate</name>
    <message>
        <source>gate</source>
        <translation>porte</translation>
    </message>
</context>
<context>
    <name>project.kind_layout</name>
    <message>
        <source>layout</source>
        <translation>plan</translation>
    </message>
</context>
<context>
    <name>project.kind_lens</name>
    <message>
        <source>lens calibration</source>
        <translation>objectif</translation>
    </message>
</context>
<context>
    <name>project.kind_marker</name>
    <message>
        <source>marker</source>
        <translation>marqueur</translation>
    </message>
</context>
<context>
    <name>project.kind_member</name>
    <message>
        <source>member</source>
        <translation>membre</translation>
    </message>
</context>
<context>
    <name>project.kind_pseudonym</name>
    <message>
        <source>pseudonym</source>
        <translation>pseudonyme</translation>
    </message>
</context>
<context>
    <name>project.kind_registration</name>
    <message>
        <source>registration</source>
        <translation>localisation</translation>
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
        <translation>étiquette</translation>
    </message>
</context>
<context>
    <name>project.kind_task</name>
    <message>
        <source>task</source>
        <translation>épreuve</translation>
    </message>
</context>
<context>
    <name>project.kind_team</name>
    <message>
        <source>team</source>
        <translation>équipe</translation>
    </message>
</context>
<context>
    <name>project.kind_track</name>
    <message>
        <source>track</source>
        <translation>trajectoire</translation>
    </message>
</context>
<context>
    <name>project.kind_trial</name>
    <message>
        <source>trial</source>
        <translation>essai</translation>
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
        <translation>zone</translation>
    </message>
</context>
<context>
    <name>project.label_twice</name>
    <message>
        <source>the label &apos;%1&apos; appears twice</source>
        <translation>le libellé &apos;%1&apos; y est deux fois</translation>
    </message>
</context>
<context>
    <name>project.leave_it</name>
    <message>
        <source>leave it</source>
        <translation>laissez-le</translation>
    </message>
</context>
<context>
    <name>project.leave_one_out</name>
    <message>
        <source>use only one of the two</source>
        <translation>omettez l’un des deux</translation>
    </message>
</context>
<context>
    <name>project.leave_out_unseen_markers</name>
    <message>
        <source>remove those that no camera sees</source>
        <translation>omettez ceux qu’aucune caméra ne voit</translation>
    </message>
</context>
<context>
    <name>project.lengths_differ</name>
    <message>
        <source>samples and profile differ in length</source>
        <translation>échantillons et profil n’ont pas la même longueur</translation>
    </message>
</context>
<context>
    <name>project.lens_kept</name>
    <message>
        <source>the lens calibration remains valid without it</source>
        <translation>l’étalonnage de l’objectif est gardé sans lui</translation>
    </message>
</context>
<context>
    <name>project.lens_of_project</name>
    <message>
        <source>lens calibration %1 of the project</source>
        <translation>objectif %1 du projet</translation>
    </message>
</context>
<context>
    <name>project.lies_in_media</name>
    <message>
        <source>a project is in the media folder of another one</source>
        <translation>un projet se trouve dans le dossier des médias d’un autre</translation>
    </message>
</context>
<context>
    <name>project.lists_too_long</name>
    <message>
        <source>%1: more than %2 of one %3: %4</source>
        <translation>%1 : plus de %2 pour un même %3 : %4</translation>
    </message>
</context>
<context>
    <name>project.look_for_strays</name>
    <message>
        <source>find stray files</source>
        <translation>chercher les fichiers orphelins</translation>
    </message>
</context>
<context>
    <name>project.look_in</name>
    <message>
        <source>search &apos;%1&apos;</source>
        <translation>recherche dans &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.marker_errors_differ</name>
    <message>
        <source>the stored marker errors of registration %1 differ from those of its markers</source>
        <translation>les erreurs des marqueurs de la localisation %1 ne sont pas celles que donnent ses marqueurs</translation>
    </message>
</context>
<context>
    <name>project.marker_off_floor</name>
    <message>
        <source>marker &apos;%1&apos; is not within a floor of 1 km</source>
        <translation>le repère &apos;%1&apos; n’est pas sur un sol de 1 km</translation>
    </message>
</context>
<context>
    <name>project.matrix_not_square</name>
    <message>
        <source>its stored matrix of %1 numbers is not square</source>
        <translation>sa matrice enregistrée de %1 nombres n’est pas carrée</translation>
    </message>
</context>
<context>
    <name>project.may_be_used_beside</name>
    <message>
        <source>project &apos;%1&apos; beside it may use them, and cannot be read (%2)</source>
        <translation>le projet « %1 » à côté les utilise peut-être et ne peut pas être lu (%2)</translation>
    </message>
</context>
<context>
    <name>project.measured_by_task</name>
    <message>
        <source>its rules were used to measure trials</source>
        <translation>des essais ont été mesurés avec elle</translation>
    </message>
</context>
<context>
    <name>project.measurements_changed</name>
    <message>
        <source>the measurements have changed since robot &apos;%1&apos; was analysed</source>
        <translation>les mesures ont changé depuis l’analyse du robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.metric</name>
    <message>
        <source>metric &apos;%1&apos;</source>
        <translation>grandeur &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.metric_differs</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is stored as %3, its positions give %4</source>
        <translation>la grandeur &apos;%1&apos; du robot &apos;%2&apos; est enregistrée comme %3, ses positions donnent %4</translation>
    </message>
</context>
<context>
    <name>project.metric_missing</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is missing, its positions give %3</source>
        <translation>la grandeur &apos;%1&apos; du robot &apos;%2&apos; manque, ses positions donnent %3</translation>
    </message>
</context>
<context>
    <name>project.metric_sigma_differs</name>
    <message>
        <source>the standard deviation of metric &apos;%1&apos; of robot &apos;%2&apos; is stored as %3, its positions give %4</source>
        <translation>l’écart-type de la grandeur &apos;%1&apos; du robot &apos;%2&apos; est enregistré comme %3, ses positions donnent %4</translation>
    </message>
</context>
<context>
    <name>project.metric_without_source</name>
    <message>
        <source>metric &apos;%1&apos; of robot &apos;%2&apos; is stored, but its positions give none</source>
        <translation>la grandeur &apos;%1&apos; du robot &apos;%2&apos; est enregistrée, mais ses positions n’en donnent aucune</translation>
    </message>
</context>
<context>
    <name>project.more_names</name>
    <message>
        <source>%1 more</source>
        <translation>%1 de plus</translation>
    </message>
</context>
<context>
    <name>project.move_file_away</name>
    <message>
        <source>move it to another folder</source>
        <translation>déplacez-le dans un autre dossier</translation>
    </message>
</context>
<context>
    <name>project.move_log_away</name>
    <message>
        <source>move the log to another folder to open the file without it, or restore the file that the log belongs to</source>
        <translation>déplacez le journal dans un autre dossier pour ouvrir le fichier sans lui, ou remettez en place le fichier auquel il appartient</translation>
    </message>
</context>
<context>
    <name>project.move_project_away</name>
    <message>
        <source>move it with its videos to a folder of its own</source>
        <translation>déplacez-le avec ses vidéos dans un dossier à lui</translation>
    </message>
</context>
<context>
    <name>project.move_teams_first</name>
    <message>
        <source>move its teams to another class first, or archive it</source>
        <translation>déplacez d’abord ses équipes dans une autre classe, ou archivez-la</translation>
    </message>
</context>
<context>
    <name>project.name_empty</name>
    <message>
        <source>it is empty</source>
        <translation>il est vide</translation>
    </message>
</context>
<context>
    <name>project.name_of</name>
    <message>
        <source>name of a %1</source>
        <translation>nom (%1)</translation>
    </message>
</context>
<context>
    <name>project.name_robots_once</name>
    <message>
        <source>list each of its robots once</source>
        <translation>nommez chaque robot une fois</translation>
    </message>
</context>
<context>
    <name>project.name_taken</name>
    <message>
        <source>the project already has a %1 of that name</source>
        <translation>le projet a déjà un élément « %1&#xa0;» de ce nom</translation>
    </message>
</context>
<context>
    <name>project.name_video_file</name>
    <message>
        <source>name the video&apos;s file</source>
        <translation>nommez le fichier de la vidéo</translation>
    </message>
</context>
<context>
    <name>project.newer_format</name>
    <message>
        <source>it was written by a newer Odograph (format %1, this one knows formats up to %2)</source>
        <translation>il a été écrit par un Odograph plus récent (format %1, celui-ci connaît les formats jusqu’à %2)</translation>
    </message>
</context>
<context>
    <name>project.no_file_but_other</name>
    <message>
        <source>it is a folder or a device, not a file</source>
        <translation>c’est un dossier ou un périphérique, pas un fichier</translation>
    </message>
</context>
<context>
    <name>project.no_file_name</name>
    <message>
        <source>it has no file name</source>
        <translation>il n’a pas de nom de fichier</translation>
    </message>
</context>
<context>
    <name>project.no_ordinary_number</name>
    <message>
        <source>a value to store is too large or not a number</source>
        <translation>une valeur à enregistrer n’est pas un nombre de taille ordinaire</translation>
    </message>
</context>
<context>
    <name>project.no_place_to_rescue_to</name>
    <message>
        <source>its folder is gone, and no home folder exists to rescue it to</source>
        <translation>son dossier a disparu, et il n&apos;y a pas de dossier personnel où le récupérer</translation>
    </message>
</context>
<context>
    <name>project.no_samples</name>
    <message>
        <source>it has no samples</source>
        <translation>elle n’a pas d’échantillons</translation>
    </message>
</context>
<context>
    <name>project.no_sound_backup</name>
    <message>
        <source>no intact backup was found beside it</source>
        <translation>aucune copie de sauvegarde intacte ne se trouve à côté</translation>
    </message>
</context>
<context>
    <name>project.no_such_name</name>
    <message>
        <source>the project has no such %1</source>
        <translation>absent du projet&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>project.no_such_number</name>
    <message>
        <source>it has no %1 with the number %2</source>
        <translation>absent sous le numéro %2&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>project.not_a_project</name>
    <message>
        <source>it is not a project file</source>
        <translation>ce n’est pas un fichier de projet</translation>
    </message>
</context>
<context>
    <name>project.not_brought_to_format</name>
    <message>
        <source>it could not be converted to format %1 (%2)</source>
        <translation>il n’a pas pu être porté au format %1 (%2)</translation>
    </message>
</context>
<context>
    <name>project.not_complete_yet</name>
    <message>
        <source>it is not complete yet</source>
        <translation>il n’est pas encore complet</translation>
    </message>
</context>
<context>
    <name>project.not_copied</name>
    <message>
        <source>it could not be copied to be read (%1)</source>
        <translation>il n&apos;a pas pu être copié pour être lu (%1)</translation>
    </message>
</context>
<context>
    <name>project.not_finite</name>
    <message>
        <source>it is not a finite number</source>
        <translation>ce n’est pas un nombre fini</translation>
    </message>
</context>
<context>
    <name>project.not_in_bin</name>
    <message>
        <source>it is not in the bin</source>
        <translation>il n’est pas dans la corbeille</translation>
    </message>
</context>
<context>
    <name>project.not_utf8</name>
    <message>
        <source>it is not valid UTF-8 text</source>
        <translation>ce n’est pas un texte UTF-8 valide</translation>
    </message>
</context>
<context>
    <name>project.not_visible_span</name>
    <message>
        <source>time in which a robot is not visible</source>
        <translation>temps où un robot n’est pas visible</translation>
    </message>
</context>
<context>
    <name>project.nothing_to_redo</name>
    <message>
        <source>nothing has been undone</source>
        <translation>rien n’a été annulé</translation>
    </message>
</context>
<context>
    <name>project.nothing_to_undo</name>
    <message>
        <source>nothing has been changed since the project was opened</source>
        <translation>rien n’a été changé depuis l’ouverture du projet</translation>
    </message>
</context>
<context>
    <name>project.numbers_too_large</name>
    <message>
        <source>%1: numbers beyond %2: %3</source>
        <translation>%1 : nombres au-delà de %2 : %3</translation>
    </message>
</context>
<context>
    <name>project.observations_do_not_fit</name>
    <message>
        <source>view &apos;%1&apos; has %2 frames, but the observations of &apos;%3&apos; (%4) do not fit them</source>
        <translation>la vue &apos;%1&apos; a %2 images, mais les observations de &apos;%3&apos; (%4) n’y correspondent pas</translation>
    </message>
</context>
<context>
    <name>project.observations_of_project</name>
    <message>
        <source>observations %1 of the project</source>
        <translation>observations %1 du projet</translation>
    </message>
</context>
<context>
    <name>project.older_format</name>
    <message>
        <source>it has the older format %1 and must be updated before Odograph can read it, but %2</source>
        <translation>il a l’ancien format %1 et doit être mis à jour avant d’être lu, mais %2</translation>
    </message>
</context>
<context>
    <name>project.on_network_disk</name>
    <message>
        <source>it is on a network disk (%1): a recording can stall there, and two computers can damage it</source>
        <translation>il se trouve sur un disque réseau (%1), où un enregistrement peut se bloquer et deux ordinateurs peuvent l’endommager</translation>
    </message>
</context>
<context>
    <name>project.open_again</name>
    <message>
        <source>open it again; if you were recording, find stray files (odograph check --adopt)</source>
        <translation>ouvrez-le à nouveau&#xa0;; si vous étiez en train d’enregistrer, regardez sous «&#xa0;Retrouver les fichiers orphelins…&#xa0;»</translation>
    </message>
</context>
<context>
    <name>project.open_elsewhere</name>
    <message>
        <source>it is open in another window</source>
        <translation>il est ouvert dans une autre fenêtre</translation>
    </message>
</context>
<context>
    <name>project.open_elsewhere_by</name>
    <message>
        <source>it is open in another window (%1)</source>
        <translation>il est ouvert dans une autre fenêtre (%1)</translation>
    </message>
</context>
<context>
    <name>project.open_or_move_that</name>
    <message>
        <source>open that project, or move it to a folder of its own with its videos</source>
        <translation>ouvrez ce projet, ou déplacez-le avec ses vidéos dans un dossier à part</translation>
    </message>
</context>
<context>
    <name>project.open_with_newer_odograph</name>
    <message>
        <source>open the project with a newer Odograph</source>
        <translation>ouvrez le projet avec un Odograph plus récent</translation>
    </message>
</context>
<context>
    <name>project.open_with_that_odograph</name>
    <message>
        <source>open it with that version, or update this one</source>
        <translation>ouvrez-le avec cet Odograph-là, ou mettez celui-ci à jour</translation>
    </message>
</context>
<context>
    <name>project.other_database</name>
    <message>
        <source>it is a database of another program</source>
        <translation>c’est la base de données d’un autre programme</translation>
    </message>
</context>
<context>
    <name>project.other_labels</name>
    <message>
        <source>the labels differ from those of the layout</source>
        <translation>les libellés ne sont pas les siens</translation>
    </message>
</context>
<context>
    <name>project.other_tables</name>
    <message>
        <source>its tables are not those of a project</source>
        <translation>ses tables ne sont pas celles d’un projet</translation>
    </message>
</context>
<context>
    <name>project.others_calibration_chosen</name>
    <message>
        <source>calibration %1 was chosen for it but belongs to camera &apos;%2&apos;; its own newest one is used</source>
        <translation>l’étalonnage %1 a été choisi pour elle, mais il est à la caméra &apos;%2&apos;&#xa0;; le plus récent des siens est utilisé</translation>
    </message>
</context>
<context>
    <name>project.others_registration_chosen</name>
    <message>
        <source>registration %1 was chosen for it but belongs to camera &apos;%2&apos;; its own newest one is used</source>
        <translation>la localisation %1 a été choisie pour elle, mais elle est à la caméra &apos;%2&apos;&#xa0;; la plus récente des siennes est utilisée</translation>
    </message>
</context>
<context>
    <name>project.overrides_changed</name>
    <message>
        <source>the manual overrides have changed since robot &apos;%1&apos; was analysed</source>
        <translation>les décisions prises à la main ont changé depuis l’analyse du robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.path_cut_off</name>
    <message>
        <source>its reference path ends within a point</source>
        <translation>son tracé de référence s’arrête au milieu d’un point</translation>
    </message>
</context>
<context>
    <name>project.path_leaves_folder</name>
    <message>
        <source>its relative path points outside the project&apos;s folder</source>
        <translation>son chemin relatif sort du dossier du projet</translation>
    </message>
</context>
<context>
    <name>project.picture_name</name>
    <message>
        <source>name of a calibration image</source>
        <translation>nom d’une photo d’étalonnage</translation>
    </message>
</context>
<context>
    <name>project.picture_path</name>
    <message>
        <source>path of a calibration image</source>
        <translation>chemin d’une photo d’étalonnage</translation>
    </message>
</context>
<context>
    <name>project.point_by_hand</name>
    <message>
        <source>point set by hand</source>
        <translation>point placé à la main</translation>
    </message>
</context>
<context>
    <name>project.point_without_sigma</name>
    <message>
        <source>it needs one position and a σ above 0 px</source>
        <translation>il faut une position et un σ supérieur à 0 px</translation>
    </message>
</context>
<context>
    <name>project.position_no_number</name>
    <message>
        <source>a position or its covariance is not a number</source>
        <translation>une position ou sa covariance n’est pas un nombre</translation>
    </message>
</context>
<context>
    <name>project.positions_changed</name>
    <message>
        <source>the stored positions of robot &apos;%1&apos; differ from those of its analysis</source>
        <translation>les positions du robot &apos;%1&apos; ne sont pas celles que son analyse a données</translation>
    </message>
</context>
<context>
    <name>project.project</name>
    <message>
        <source>project &apos;%1&apos;</source>
        <translation>projet &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.project_file_damaged</name>
    <message>
        <source>the project file is damaged</source>
        <translation>le fichier du projet est endommagé</translation>
    </message>
</context>
<context>
    <name>project.put_back_and_open</name>
    <message>
        <source>move the file back to its folder, and open the project again</source>
        <translation>remettez le fichier à sa place, et rouvrez le projet</translation>
    </message>
</context>
<context>
    <name>project.put_back_and_retry</name>
    <message>
        <source>move it back to its folder and try again</source>
        <translation>remettez-le à sa place et réessayez</translation>
    </message>
</context>
<context>
    <name>project.put_back_or_find</name>
    <message>
        <source>move the file back to its folder, or find it by its content with odograph check P.odo --find FOLDER or Find lost videos… in the window</source>
        <translation>remettez le fichier à sa place, ou retrouvez-le d’après son contenu avec «&#xa0;Retrouver les vidéos perdues…&#xa0;»</translation>
    </message>
</context>
<context>
    <name>project.put_file_back</name>
    <message>
        <source>move the file back to its folder</source>
        <translation>remettez le fichier à sa place</translation>
    </message>
</context>
<context>
    <name>project.put_into_bin_first</name>
    <message>
        <source>move it to the bin first</source>
        <translation>mettez-le d’abord dans la corbeille</translation>
    </message>
</context>
<context>
    <name>project.put_original_back</name>
    <message>
        <source>move the original file back to its folder</source>
        <translation>remettez le fichier d’origine à sa place</translation>
    </message>
</context>
<context>
    <name>project.range_changed</name>
    <message>
        <source>the trial&apos;s range has changed since robot &apos;%1&apos; was analysed</source>
        <translation>la plage de l’essai a changé depuis l’analyse du robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.range_sentence</name>
    <message>
        <source>Range: %1 to %2 of %3; all results are of this part.</source>
        <translation>Plage : de %1 à %2 sur %3 ; tous les résultats portent sur cette partie.</translation>
    </message>
</context>
<context>
    <name>project.range_without_sample</name>
    <message>
        <source>no sample is within its range</source>
        <translation>aucun échantillon n’est dans sa plage</translation>
    </message>
</context>
<context>
    <name>project.raw_times_of</name>
    <message>
        <source>raw times of recording %1</source>
        <translation>temps bruts de l’enregistrement %1</translation>
    </message>
</context>
<context>
    <name>project.reading</name>
    <message>
        <source>reading %1</source>
        <translation>lecture de %1</translation>
    </message>
</context>
<context>
    <name>project.reading_failed</name>
    <message>
        <source>reading it failed (%1)</source>
        <translation>la lecture a échoué (%1)</translation>
    </message>
</context>
<context>
    <name>project.reason_is_blank</name>
    <message>
        <source>it is blank</source>
        <translation>elle est vide</translation>
    </message>
</context>
<context>
    <name>project.record_another</name>
    <message>
        <source>record another trial</source>
        <translation>filmez un autre essai</translation>
    </message>
</context>
<context>
    <name>project.recorded_into_now</name>
    <message>
        <source>a trial is being recorded into it now</source>
        <translation>un essai y est en cours d’enregistrement</translation>
    </message>
</context>
<context>
    <name>project.recording</name>
    <message>
        <source>recording</source>
        <translation>enregistrement</translation>
    </message>
</context>
<context>
    <name>project.recording_at</name>
    <message>
        <source>recording &apos;%1&apos;</source>
        <translation>enregistrement &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.recording_cut_off</name>
    <message>
        <source>its recording was cut off</source>
        <translation>son enregistrement a été interrompu</translation>
    </message>
</context>
<context>
    <name>project.recording_ended</name>
    <message>
        <source>its recording has ended already</source>
        <translation>son enregistrement est déjà terminé</translation>
    </message>
</context>
<context>
    <name>project.recording_kept</name>
    <message>
        <source>its recording has ended, and is kept</source>
        <translation>son enregistrement est terminé, et gardé</translation>
    </message>
</context>
<context>
    <name>project.recording_of_view</name>
    <message>
        <source>the recording of view &apos;%1&apos;</source>
        <translation>l’enregistrement de la vue &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.recording_path</name>
    <message>
        <source>path of a recording</source>
        <translation>chemin d’un enregistrement</translation>
    </message>
</context>
<context>
    <name>project.recording_without_file</name>
    <message>
        <source>it has no file</source>
        <translation>il n’a pas de fichier</translation>
    </message>
</context>
<context>
    <name>project.recordings_changed</name>
    <message>
        <source>the recordings or their synchronisation have changed since robot &apos;%1&apos; was analysed</source>
        <translation>les enregistrements ou leur synchronisation ont changé depuis l’analyse du robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.redo</name>
    <message>
        <source>redo</source>
        <translation>rétablir</translation>
    </message>
</context>
<context>
    <name>project.redo_of</name>
    <message>
        <source>redo &apos;%1&apos;</source>
        <translation>rétablir &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.reference_too_far</name>
    <message>
        <source>its reference point is more than %1 from its centre</source>
        <translation>son point de référence est à plus de %1 de son centre</translation>
    </message>
</context>
<context>
    <name>project.reference_without_heading</name>
    <message>
        <source>a reference point off its centre needs a heading, but a robot of changing height has none</source>
        <translation>un point de référence hors du centre demande un cap, qui n’est pas connu là où la hauteur change</translation>
    </message>
</context>
<context>
    <name>project.refers_to_nothing</name>
    <message>
        <source>it refers to something missing from the project, or a value is missing</source>
        <translation>il renvoie à quelque chose d’absent du projet, ou une valeur manque</translation>
    </message>
</context>
<context>
    <name>project.registration_kept</name>
    <message>
        <source>the registration remains valid without it</source>
        <translation>la localisation est gardée sans lui</translation>
    </message>
</context>
<context>
    <name>project.registration_of_project</name>
    <message>
        <source>registration %1 of the project</source>
        <translation>localisation %1 du projet</translation>
    </message>
</context>
<context>
    <name>project.registration_picture_of</name>
    <message>
        <source>the image of registration %1 of camera &apos;%2&apos;</source>
        <translation>la photo de la localisation %1 de la caméra &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>project.registration_picture_path</name>
    <message>
        <source>path of a registration&apos;s image</source>
        <translation>chemin de la photo d’une localisation</translation>
    </message>
</context>
<context>
    <name>project.registrations_changed</name>
    <message>
        <source>the registrations have changed since robot &apos;%1&apos; was analysed</source>
        <translation>les localisations ont changé depuis l’analyse du robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.remove_file_first</name>
    <message>
        <source>choose another name, or remove that file first</source>
        <translation>choisissez un autre nom, ou supprimez d’abord ce fichier</translation>
    </message>
</context>
<context>
    <name>project.remove_guidance</name>
    <message>
        <source>remove some first</source>
        <translation>retirez-en d’abord</translation>
    </message>
</context>
<context>
    <name>project.remove_variables</name>
    <message>
        <source>remove some of its variables</source>
        <translation>supprimez quelques-unes de ses variables</translation>
    </message>
</context>
<context>
    <name>project.rest_not_read</name>
    <message>
        <source>Odograph does not read the rest; shorten it here, or in the program that wrote the file</source>
        <translation>le reste n’est pas lu ; changez-le ici ou là d’où vient le fichier</translation>
    </message>
</context>
<context>
    <name>project.restore_file</name>
    <message>
        <source>restore it from a backup copy</source>
        <translation>restaurez-le d’une copie de sauvegarde</translation>
    </message>
</context>
<context>
    <name>project.restore_or_register_again</name>
    <message>
        <source>restore the project from a backup copy, or register the camera again</source>
        <translation>restaurez le projet d’une copie de sauvegarde, ou localisez la caméra à nouveau</translation>
    </message>
</context>
<context>
    <name>project.restore_or_track_again</name>
    <message>
        <source>restore the project from a backup copy, or track the trial again</source>
        <translation>restaurez le projet d’une copie de sauvegarde, ou suivez l’essai à nouveau</translation>
    </message>
</context>
<context>
    <name>project.restore_project</name>
    <message>
        <source>restore the project from a backup copy</source>
        <translation>restaurez le projet d’une copie de sauvegarde</translation>
    </message>
</context>
<context>
    <name>project.results_changed</name>
    <message>
        <source>the stored metrics, spikes or settings of robot &apos;%1&apos; differ from those of its analysis</source>
        <translation>les grandeurs, pics aberrants ou réglages du robot &apos;%1&apos; ne sont pas ceux que son analyse a donnés</translation>
    </message>
</context>
<context>
    <name>project.robot_can_be_renamed</name>
    <message>
        <source>you can rename it</source>
        <translation>on peut lui donner un autre nom</translation>
    </message>
</context>
<context>
    <name>project.robot_drove</name>
    <message>
        <source>a trial uses it</source>
        <translation>il a roulé dans un essai</translation>
    </message>
</context>
<context>
    <name>project.robot_too_large</name>
    <message>
        <source>it is larger than %1</source>
        <translation>il mesure plus de %1</translation>
    </message>
</context>
<context>
    <name>project.robot_twice</name>
    <message>
        <source>it has a robot twice</source>
        <translation>un robot lui appartient deux fois</translation>
    </message>
</context>
<context>
    <name>project.row_refers_to_nothing</name>
    <message>
        <source>row %1 of &apos;%2&apos; refers to a missing row of &apos;%3&apos;</source>
        <translation>la ligne %1 de &apos;%2&apos; renvoie à une ligne de &apos;%3&apos; qui n’existe pas</translation>
    </message>
</context>
<context>
    <name>project.run_check</name>
    <message>
        <source>run a check of the project</source>
        <translation>lancez une vérification du projet</translation>
    </message>
</context>
<context>
    <name>project.say_why</name>
    <message>
        <source>write why the results can be used</source>
        <translation>écrivez pourquoi les résultats sont utilisables</translation>
    </message>
</context>
<context>
    <name>project.school_ask_owner</name>
    <message>
        <source>nothing of it was taken over; ask for it to be published again</source>
        <translation>rien n’en a été repris ; demandez qu’il soit publié de nouveau</translation>
    </message>
</context>
<context>
    <name>project.school_document</name>
    <message>
        <source>document of the hub</source>
        <translation>document du serveur</translation>
    </message>
</context>
<context>
    <name>project.school_field_wrong</name>
    <message>
        <source>what the hub has of it is damaged: field &apos;%1&apos;</source>
        <translation>ce que le serveur en a est endommagé : champ « %1 »</translation>
    </message>
</context>
<context>
    <name>project.school_names_taken</name>
    <message>
        <source>every name for it is taken here</source>
        <translation>tous les noms possibles sont déjà pris ici</translation>
    </message>
</context>
<context>
    <name>project.school_not_readable</name>
    <message>
        <source>what the hub has of it cannot be read</source>
        <translation>ce que le serveur en a est illisible</translation>
    </message>
</context>
<context>
    <name>project.school_publish_again</name>
    <message>
        <source>publish again</source>
        <translation>publiez de nouveau</translation>
    </message>
</context>
<context>
    <name>project.school_recordings</name>
    <message>
        <source>recordings of a trial from the hub</source>
        <translation>enregistrements d’un essai du serveur</translation>
    </message>
</context>
<context>
    <name>project.school_recordings_wrong</name>
    <message>
        <source>their description is damaged: field &apos;%1&apos;</source>
        <translation>leur description est endommagée : champ « %1 »</translation>
    </message>
</context>
<context>
    <name>project.school_rename_yours</name>
    <message>
        <source>rename the trials of that name in this project</source>
        <translation>renommez les essais de ce nom dans ce projet</translation>
    </message>
</context>
<context>
    <name>project.school_row_gone</name>
    <message>
        <source>it is no longer in the project</source>
        <translation>il n’est plus dans le projet</translation>
    </message>
</context>
<context>
    <name>project.search_area</name>
    <message>
        <source>search area</source>
        <translation>zone de recherche</translation>
    </message>
</context>
<context>
    <name>project.series_differ</name>
    <message>
        <source>its series differ in length</source>
        <translation>ses séries n’ont pas la même longueur</translation>
    </message>
</context>
<context>
    <name>project.series_missing</name>
    <message>
        <source>its series are missing</source>
        <translation>ses séries manquent</translation>
    </message>
</context>
<context>
    <name>project.series_of_other_kind</name>
    <message>
        <source>its stored series is not of the expected kind</source>
        <translation>sa série enregistrée n’est pas du genre attendu</translation>
    </message>
</context>
<context>
    <name>project.series_of_other_length</name>
    <message>
        <source>its stored series announces %1 rows but holds %2 bytes</source>
        <translation>sa série enregistrée annonce %1 lignes mais contient %2 octets</translation>
    </message>
</context>
<context>
    <name>project.size_not_above_0</name>
    <message>
        <source>its size is not above 0</source>
        <translation>sa taille n’est pas supérieure à 0</translation>
    </message>
</context>
<context>
    <name>project.spike_without_sample</name>
    <message>
        <source>a spike refers to a missing sample</source>
        <translation>un pic aberrant renvoie à un échantillon absent</translation>
    </message>
</context>
<context>
    <name>project.split_recording</name>
    <message>
        <source>split the recording into shorter ones</source>
        <translation>divisez l’enregistrement en plus courts</translation>
    </message>
</context>
<context>
    <name>project.strays_unknown</name>
    <message>
        <source>cannot determine which files belong to no trial</source>
        <translation>impossible de savoir quels fichiers n’appartiennent à aucun essai</translation>
    </message>
</context>
<context>
    <name>project.synchronisation_differs</name>
    <message>
        <source>its stored synchronisation differs from that of its second view</source>
        <translation>sa synchronisation enregistrée n’est pas celle de sa deuxième vue</translation>
    </message>
</context>
<context>
    <name>project.synchronisation_of_one_view</name>
    <message>
        <source>a synchronisation is stored, but it has no second view</source>
        <translation>une synchronisation est enregistrée, mais il n’a pas de deuxième vue</translation>
    </message>
</context>
<context>
    <name>project.take_later_back</name>
    <message>
        <source>undo the later change first, or leave this one</source>
        <translation>annulez d’abord la modification plus récente, ou laissez</translation>
    </message>
</context>
<context>
    <name>project.task_changed</name>
    <message>
        <source>the task has changed since robot &apos;%1&apos; was analysed</source>
        <translation>l’épreuve a changé depuis l’analyse du robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.task_has_trial</name>
    <message>
        <source>a trial uses it</source>
        <translation>un essai l’utilise</translation>
    </message>
</context>
<context>
    <name>project.task_has_trials</name>
    <message>
        <source>%1 trials use it</source>
        <translation>%1 essais l’utilisent</translation>
    </message>
</context>
<context>
    <name>project.team_has_trial</name>
    <message>
        <source>it has a trial</source>
        <translation>un essai est le sien</translation>
    </message>
</context>
<context>
    <name>project.team_has_trials</name>
    <message>
        <source>it has %1 trials</source>
        <translation>%1 essais sont les siens</translation>
    </message>
</context>
<context>
    <name>project.texts_too_long</name>
    <message>
        <source>%1: texts of more than %2 characters: %3</source>
        <translation>%1 : textes de plus de %2 caractères : %3</translation>
    </message>
</context>
<context>
    <name>project.times_do_not_rise</name>
    <message>
        <source>its times do not increase</source>
        <translation>ses temps ne croissent pas</translation>
    </message>
</context>
<context>
    <name>project.title</name>
    <message>
        <source>title of the project</source>
        <translation>titre du projet</translation>
    </message>
</context>
<context>
    <name>project.too_many_markers</name>
    <message>
        <source>it has more than %1 markers</source>
        <translation>il a plus de %1 repères</translation>
    </message>
</context>
<context>
    <name>project.too_many_members</name>
    <message>
        <source>it has more than %1 members</source>
        <translation>elle a plus de %1 membres</translation>
    </message>
</context>
<context>
    <name>project.too_many_samples</name>
    <message>
        <source>it has more than %1 samples</source>
        <translation>il y a plus de %1 échantillons</translation>
    </message>
</context>
<context>
    <name>project.too_many_variables</name>
    <message>
        <source>a trial has %1 variables at most</source>
        <translation>un essai a au plus %1 variables</translation>
    </message>
</context>
<context>
    <name>project.track</name>
    <message>
        <source>track &apos;%1&apos;</source>
        <translation>trajectoire &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.track_again</name>
    <message>
        <source>track the trial again</source>
        <translation>suivez l’essai à nouveau</translation>
    </message>
</context>
<context>
    <name>project.track_kept</name>
    <message>
        <source>the measured track remains valid without it</source>
        <translation>la trajectoire mesurée est gardée sans lui</translation>
    </message>
</context>
<context>
    <name>project.track_reading</name>
    <message>
        <source>reading of a track</source>
        <translation>lecture d’une trajectoire</translation>
    </message>
</context>
<context>
    <name>project.trial_notes</name>
    <message>
        <source>notes of a trial</source>
        <translation>notes d’un essai</translation>
    </message>
</context>
<context>
    <name>project.trial_of_project</name>
    <message>
        <source>trial %1 of the project</source>
        <translation>essai %1 du projet</translation>
    </message>
</context>
<context>
    <name>project.truth</name>
    <message>
        <source>truth of a trial</source>
        <translation>vérité d’un essai</translation>
    </message>
</context>
<context>
    <name>project.truth_of_trial</name>
    <message>
        <source>truth of trial %1</source>
        <translation>vérité de l’essai %1</translation>
    </message>
</context>
<context>
    <name>project.try_again</name>
    <message>
        <source>try again</source>
        <translation>réessayez</translation>
    </message>
</context>
<context>
    <name>project.try_change_again</name>
    <message>
        <source>try the whole change again</source>
        <translation>réessayez toute la modification</translation>
    </message>
</context>
<context>
    <name>project.type_name_anew</name>
    <message>
        <source>type the name again</source>
        <translation>retapez le nom</translation>
    </message>
</context>
<context>
    <name>project.type_text_anew</name>
    <message>
        <source>type the text again</source>
        <translation>retapez le texte</translation>
    </message>
</context>
<context>
    <name>project.undo</name>
    <message>
        <source>undo</source>
        <translation>annuler</translation>
    </message>
</context>
<context>
    <name>project.undo_of</name>
    <message>
        <source>undo &apos;%1&apos;</source>
        <translation>annuler &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>project.undo_something_first</name>
    <message>
        <source>undo something first</source>
        <translation>annulez d’abord quelque chose</translation>
    </message>
</context>
<context>
    <name>project.unknown_series_layout</name>
    <message>
        <source>its stored series has the unknown layout %1</source>
        <translation>sa série enregistrée a la disposition inconnue %1</translation>
    </message>
</context>
<context>
    <name>project.unknown_setting</name>
    <message>
        <source>its stored setting &apos;%1&apos; is unknown</source>
        <translation>son réglage enregistré &apos;%1&apos; est inconnu</translation>
    </message>
</context>
<context>
    <name>project.use_at_most</name>
    <message>
        <source>use at most %1</source>
        <translation>utilisez-en %1 au plus</translation>
    </message>
</context>
<context>
    <name>project.use_one_line</name>
    <message>
        <source>use a name of one line</source>
        <translation>utilisez un nom d’une seule ligne</translation>
    </message>
</context>
<context>
    <name>project.value_too_large</name>
    <message>
        <source>a value is too large to store</source>
        <translation>une valeur est trop grande pour être enregistrée</translation>
    </message>
</context>
<context>
    <name>project.verdict</name>
    <message>
        <source>verdict on a trial</source>
        <translation>verdict sur un essai</translation>
    </message>
</context>
<context>
    <name>project.views_differ</name>
    <message>
        <source>views and registrations differ in number</source>
        <translation>vues et localisations ne sont pas en même nombre</translation>
    </message>
</context>
<context>
    <name>project.wait_until_ended</name>
    <message>
        <source>wait until that has ended</source>
        <translation>attendez que ce soit terminé</translation>
    </message>
</context>
<context>
    <name>project.writing_failed</name>
    <message>
        <source>writing it failed (%1)</source>
        <translation>l’écriture a échoué (%1)</translation>
    </message>
</context>
<context>
    <name>project.written_over</name>
    <message>
        <source>another program wrote over its file while it was open; nothing more was stored</source>
        <translation>un autre programme a écrasé son fichier pendant qu’il était ouvert ; plus rien n’a été enregistré</translation>
    </message>
</context>
<context>
    <name>project.zone_cut_off</name>
    <message>
        <source>its zone &apos;%1&apos; ends within a point</source>
        <translation>sa zone &apos;%1&apos; s’arrête au milieu d’un point</translation>
    </message>
</context>
<context>
    <name>school.address</name>
    <message>
        <source>address of the school hub</source>
        <translation>adresse du serveur de l’école</translation>
    </message>
</context>
<context>
    <name>school.address_characters</name>
    <message>
        <source>it holds a quotation mark, a backslash, a semicolon or a control character</source>
        <translation>elle contient un guillemet, une barre oblique inverse, un point-virgule ou un caractère de commande</translation>
    </message>
</context>
<context>
    <name>school.address_form</name>
    <message>
        <source>give it as postgresql://user@host/database</source>
        <translation>indiquez-la sous la forme postgresql://user@host/database</translation>
    </message>
</context>
<context>
    <name>school.ask_administrator</name>
    <message>
        <source>ask the hub&apos;s administrator for the role that may</source>
        <translation>demandez le rôle nécessaire à l’administrateur du serveur</translation>
    </message>
</context>
<context>
    <name>school.check_connection</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network; what is recorded meanwhile is sent later</source>
        <translation>vérifiez l’adresse, l’identifiant dans ~/.pgpass et le réseau ; ce qui est enregistré entre-temps sera envoyé plus tard</translation>
    </message>
</context>
<context>
    <name>school.check_server</name>
    <message>
        <source>have the hub&apos;s administrator look at the server</source>
        <translation>demandez à l’administrateur d’examiner le serveur</translation>
    </message>
</context>
<context>
    <name>school.connect_first</name>
    <message>
        <source>connect it with odograph school connect P.odo postgresql://user@host/database</source>
        <translation>connectez-le d’abord</translation>
    </message>
</context>
<context>
    <name>school.connect_with_media</name>
    <message>
        <source>connect it again with --media FOLDER</source>
        <translation>connectez-le de nouveau avec un dossier des médias</translation>
    </message>
</context>
<context>
    <name>school.grant_role</name>
    <message>
        <source>have the hub&apos;s administrator grant it one: GRANT bench TO login</source>
        <translation>demandez à l’administrateur du serveur de lui en donner un : GRANT bench TO login</translation>
    </message>
</context>
<context>
    <name>school.hub_subject</name>
    <message>
        <source>school hub &apos;%1&apos;</source>
        <translation>serveur de l’école « %1 »</translation>
    </message>
</context>
<context>
    <name>school.install_driver</name>
    <message>
        <source>install the package libqt6sql6-psql</source>
        <translation>installez le paquet libqt6sql6-psql</translation>
    </message>
</context>
<context>
    <name>school.media</name>
    <message>
        <source>media folder of the school</source>
        <translation>dossier des médias de l’école</translation>
    </message>
</context>
<context>
    <name>school.never_answers</name>
    <message>
        <source>the server takes connections and answers none</source>
        <translation>le serveur accepte les connexions et ne répond à aucune</translation>
    </message>
</context>
<context>
    <name>school.newer_hub</name>
    <message>
        <source>its schema has version %1, and this Odograph knows up to %2</source>
        <translation>son schéma a la version %1, et cet Odograph connaît jusqu’à %2</translation>
    </message>
</context>
<context>
    <name>school.no_database</name>
    <message>
        <source>it names no database</source>
        <translation>elle ne nomme aucune base de données</translation>
    </message>
</context>
<context>
    <name>school.no_driver</name>
    <message>
        <source>this computer has no driver for PostgreSQL</source>
        <translation>cet ordinateur n’a pas de pilote pour PostgreSQL</translation>
    </message>
</context>
<context>
    <name>school.no_hub</name>
    <message>
        <source>the database has no hub</source>
        <translation>la base de données n’est pas préparée</translation>
    </message>
</context>
<context>
    <name>school.no_media</name>
    <message>
        <source>the project is connected without one</source>
        <translation>le projet est connecté sans dossier</translation>
    </message>
</context>
<context>
    <name>school.no_role</name>
    <message>
        <source>the login has none of the roles teacher, bench and viewer</source>
        <translation>l’identifiant n’a aucun des rôles teacher, bench et viewer</translation>
    </message>
</context>
<context>
    <name>school.no_url</name>
    <message>
        <source>it is no address of a PostgreSQL database</source>
        <translation>ce n’est pas l’adresse d’une base de données PostgreSQL</translation>
    </message>
</context>
<context>
    <name>school.not_allowed</name>
    <message>
        <source>the login may not do that (%1)</source>
        <translation>cet identifiant n’en a pas le droit (%1)</translation>
    </message>
</context>
<context>
    <name>school.not_connected</name>
    <message>
        <source>the project is not connected to one</source>
        <translation>le projet n’est connecté à aucun</translation>
    </message>
</context>
<context>
    <name>school.older_hub</name>
    <message>
        <source>its schema has version %1, and this Odograph needs %2</source>
        <translation>son schéma a la version %1, et cet Odograph a besoin de %2</translation>
    </message>
</context>
<context>
    <name>school.option_unknown</name>
    <message>
        <source>its option &apos;%1&apos; is not known</source>
        <translation>son option « %1 » est inconnue</translation>
    </message>
</context>
<context>
    <name>school.options_known</name>
    <message>
        <source>use sslmode, sslrootcert, host or port</source>
        <translation>utilisez sslmode, sslrootcert, host ou port</translation>
    </message>
</context>
<context>
    <name>school.password_elsewhere</name>
    <message>
        <source>leave it out, and put the password into ~/.pgpass or PGPASSWORD</source>
        <translation>retirez-le et mettez le mot de passe dans ~/.pgpass ou PGPASSWORD</translation>
    </message>
</context>
<context>
    <name>school.password_in_url</name>
    <message>
        <source>it holds a password, which others could read</source>
        <translation>elle contient un mot de passe que d’autres pourraient lire</translation>
    </message>
</context>
<context>
    <name>school.password_place</name>
    <message>
        <source>put the correct one into ~/.pgpass or PGPASSWORD</source>
        <translation>saisissez-le ici, ou mettez-le dans ~/.pgpass</translation>
    </message>
</context>
<context>
    <name>school.password_refused</name>
    <message>
        <source>the server does not accept this login with this password</source>
        <translation>le serveur n’accepte pas cet identifiant avec ce mot de passe</translation>
    </message>
</context>
<context>
    <name>school.password_wanted</name>
    <message>
        <source>the server asks for the password of the login</source>
        <translation>le serveur demande le mot de passe de l’identifiant</translation>
    </message>
</context>
<context>
    <name>school.publish_later</name>
    <message>
        <source>try again later; what was not sent yet is kept</source>
        <translation>réessayez plus tard ; ce qui n’est pas encore envoyé est conservé</translation>
    </message>
</context>
<context>
    <name>school.publishing</name>
    <message>
        <source>publishing</source>
        <translation>publication</translation>
    </message>
</context>
<context>
    <name>school.receiving</name>
    <message>
        <source>receiving %1</source>
        <translation>réception de %1</translation>
    </message>
</context>
<context>
    <name>school.recording_changed</name>
    <message>
        <source>the recording &apos;%1&apos; is missing or has changed, and was left out</source>
        <translation>l’enregistrement « %1 » manque ou a changé et a été laissé de côté</translation>
    </message>
</context>
<context>
    <name>school.recording_elsewhere</name>
    <message>
        <source>trial &apos;%1&apos;, view &apos;%2&apos;: its recording is not in the media folder; bench &apos;%3&apos; has it as &apos;%4&apos;</source>
        <translation>essai « %1 », vue « %2 » : son enregistrement n’est pas dans le dossier des médias ; le poste « %3 » l’a sous « %4 »</translation>
    </message>
</context>
<context>
    <name>school.report_to_administrator</name>
    <message>
        <source>show this to the hub&apos;s administrator</source>
        <translation>montrez ceci à l’administrateur du serveur</translation>
    </message>
</context>
<context>
    <name>school.run_init</name>
    <message>
        <source>have its administrator run odograph school init</source>
        <translation>demandez à l’administrateur de la préparer</translation>
    </message>
</context>
<context>
    <name>school.server_away</name>
    <message>
        <source>the server is away; trying again</source>
        <translation>le serveur est injoignable&#xa0;; nouvelle tentative</translation>
    </message>
</context>
<context>
    <name>school.silent</name>
    <message>
        <source>the server does not answer</source>
        <translation>le serveur ne répond pas</translation>
    </message>
</context>
<context>
    <name>school.sslmode_choices</name>
    <message>
        <source>use disable, allow, prefer, require, verify-ca or verify-full</source>
        <translation>utilisez disable, allow, prefer, require, verify-ca ou verify-full</translation>
    </message>
</context>
<context>
    <name>school.sslmode_unknown</name>
    <message>
        <source>sslmode &apos;%1&apos; is not known</source>
        <translation>sslmode « %1 » est inconnu</translation>
    </message>
</context>
<context>
    <name>school.subject</name>
    <message>
        <source>school hub</source>
        <translation>serveur de l’école</translation>
    </message>
</context>
<context>
    <name>school.update_program</name>
    <message>
        <source>update Odograph</source>
        <translation>mettez Odograph à jour</translation>
    </message>
</context>
<context>
    <name>school.waiting</name>
    <message>
        <source>waiting for the server</source>
        <translation>attente du serveur</translation>
    </message>
</context>
<context>
    <name>school.went_away</name>
    <message>
        <source>the connection was lost (%1)</source>
        <translation>la connexion a été perdue (%1)</translation>
    </message>
</context>
<context>
    <name>simulation.cannot_render</name>
    <message>
        <source>cannot render %1</source>
        <translation>impossible de calculer %1</translation>
    </message>
</context>
<context>
    <name>simulation.lengthen_scene</name>
    <message>
        <source>give the scene a longer duration or start the camera earlier</source>
        <translation>donnez à la scène une durée plus longue ou démarrez la caméra plus tôt</translation>
    </message>
</context>
<context>
    <name>simulation.no_frame</name>
    <message>
        <source>camera %1 takes no frame during the scene</source>
        <translation>la caméra %1 ne prend aucune image tant que dure la scène</translation>
    </message>
</context>
<context>
    <name>simulation.rendering</name>
    <message>
        <source>rendering %1</source>
        <translation>calcul de %1</translation>
    </message>
</context>
<context>
    <name>sync.cost</name>
    <message>
        <source>View %1: its times are known to ±%2, which is ±%3 at the top speed of %4</source>
        <translation>Vue %1 : ses temps sont connus à ±%2 près, soit ±%3 à la vitesse maximale de %4</translation>
    </message>
</context>
<context>
    <name>sync.cost_of_error</name>
    <message>
        <source>View %1: nothing has measured its time offset; an error of %2 would shift the robot by %3 at the top speed of %4</source>
        <translation>Vue %1 : son décalage n’a pas été mesuré ; une erreur de %2 déplacerait le robot de %3 à la vitesse maximale de %4</translation>
    </message>
</context>
<context>
    <name>sync.drift</name>
    <message>
        <source>Its clock runs %1 ±%2 faster than the first view&apos;s</source>
        <translation>Son horloge avance de %1 ±%2 par rapport à celle de la première vue</translation>
    </message>
</context>
<context>
    <name>sync.known_to</name>
    <message>
        <source>View %1: its times are known to ±%2</source>
        <translation>Vue %1 : ses temps sont connus à ±%2 près</translation>
    </message>
</context>
<context>
    <name>sync.no_residual</name>
    <message>
        <source>The views&apos; disagreement does not grow with the speed: a remaining time error is at most %1, or %2 at the top speed</source>
        <translation>Le désaccord des vues n’augmente pas avec la vitesse : l’erreur de temps restante est d’au plus %1, soit %2 à la vitesse maximale</translation>
    </message>
</context>
<context>
    <name>sync.not_measured</name>
    <message>
        <source>View %1: nothing has measured its time offset</source>
        <translation>Vue %1 : son décalage n’a pas été mesuré</translation>
    </message>
</context>
<context>
    <name>sync.pairing</name>
    <message>
        <source>Its frames are %1 on average and at most %2 from the first view&apos;s; positions are interpolated to the same times</source>
        <translation>Ses images sont à %1 en moyenne et au plus à %2 de celles de la première vue ; les positions sont interpolées aux mêmes temps</translation>
    </message>
</context>
<context>
    <name>sync.residual</name>
    <message>
        <source>The views disagree the more the faster the robot is, as a time error of %1 ±%2 would make them: %3 at the top speed</source>
        <translation>Les vues divergent d’autant plus que le robot est rapide, comme avec une erreur de temps de %1 ±%2 : %3 à la vitesse maximale</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_flash</name>
    <message>
        <source>%1 by the flash of light</source>
        <translation>%1 d’après l’éclair de lumière</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_motion</name>
    <message>
        <source>%1 by the motion</source>
        <translation>%1 d’après le mouvement</translation>
    </message>
</context>
<context>
    <name>synchronisation.by_sound</name>
    <message>
        <source>%1 by the sound</source>
        <translation>%1 d’après le son</translation>
    </message>
</context>
<context>
    <name>synchronisation.clap_twice</name>
    <message>
        <source>clap twice near the middle of the floor while both cameras record, or give --sync SECONDS</source>
        <translation>tapez deux fois dans vos mains près du milieu du sol pendant que les deux caméras filment, ou donnez le décalage</translation>
    </message>
</context>
<context>
    <name>synchronisation.clocks_ambiguous</name>
    <message>
        <source>several time offsets, pauses or missing frames explain the views&apos; tracks about equally well</source>
        <translation>plusieurs décalages, pauses ou images manquantes expliquent à peu près aussi bien les trajectoires des vues</translation>
    </message>
</context>
<context>
    <name>synchronisation.different_runs</name>
    <message>
        <source>the views&apos; tracks match at no time offset, frame rate or pause tried, so the videos may be of different runs</source>
        <translation>les trajectoires des vues ne concordent pour aucun décalage, aucune fréquence ni aucune pause essayés ; les vidéos montrent peut-être des parcours différents</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_disagrees</name>
    <message>
        <source>the motion gives a time offset of %1, the flash of light gives %2; the motion was used</source>
        <translation>le mouvement donne un décalage de %1, retenu, et l’éclair de lumière %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_lights</name>
    <message>
        <source>flash the room lights once while both cameras record, or give --sync SECONDS</source>
        <translation>faites clignoter une fois la lumière de la salle pendant que les deux caméras filment, ou donnez le décalage</translation>
    </message>
</context>
<context>
    <name>synchronisation.flash_or_clap</name>
    <message>
        <source>flash the room lights or clap twice while both cameras record, or give --sync SECONDS</source>
        <translation>faites clignoter la lumière de la salle ou tapez deux fois dans vos mains pendant que les deux caméras filment, ou donnez le décalage</translation>
    </message>
</context>
<context>
    <name>synchronisation.flashes_fit_alike</name>
    <message>
        <source>the flashes of light fit equally well at time offsets of %1 and %2</source>
        <translation>les éclairs de lumière conviennent autant à des décalages de %1 et %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.from_flash</name>
    <message>
        <source>measured by a flash of light to only ±%1, because %2</source>
        <translation>d’après un éclair de lumière, à %1 seulement, car %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.from_sound</name>
    <message>
        <source>measured by the sound to only ±%1, because %2</source>
        <translation>d’après le son, à ±%1 seulement, car %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.light_flickers</name>
    <message>
        <source>the light flickers</source>
        <translation>la lumière scintille</translation>
    </message>
</context>
<context>
    <name>synchronisation.motion_repeats</name>
    <message>
        <source>the motion repeats itself</source>
        <translation>le mouvement se répète</translation>
    </message>
</context>
<context>
    <name>synchronisation.motion_too_even</name>
    <message>
        <source>the robot turned and changed its speed too little to give the time offset</source>
        <translation>le robot a trop peu tourné et changé de vitesse pour déterminer le décalage</translation>
    </message>
</context>
<context>
    <name>synchronisation.neither_tells</name>
    <message>
        <source>%1, and %2</source>
        <translation>%1, et %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.no_flash</name>
    <message>
        <source>neither view shows a flash of light</source>
        <translation>aucune des vues ne montre d’éclair de lumière</translation>
    </message>
</context>
<context>
    <name>synchronisation.no_loud_sound</name>
    <message>
        <source>no clap, knock or whistle is heard clearly in both clips</source>
        <translation>aucun claquement de mains, coup ou sifflet ne ressort dans le son des deux clips</translation>
    </message>
</context>
<context>
    <name>synchronisation.none_tells</name>
    <message>
        <source>%1, %2, and %3</source>
        <translation>%1, %2, et %3</translation>
    </message>
</context>
<context>
    <name>synchronisation.of_clips</name>
    <message>
        <source>synchronisation of the clips</source>
        <translation>synchronisation des vidéos</translation>
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
        <translation>des décalages de %1 et %2 conviennent autant</translation>
    </message>
</context>
<context>
    <name>synchronisation.one_flash</name>
    <message>
        <source>only one of the views shows a flash of light</source>
        <translation>une seule des vues montre un éclair de lumière</translation>
    </message>
</context>
<context>
    <name>synchronisation.other_flashes</name>
    <message>
        <source>the flashes of light in the views do not match</source>
        <translation>les éclairs de lumière des vues ne se correspondent pas</translation>
    </message>
</context>
<context>
    <name>synchronisation.other_sounds</name>
    <message>
        <source>the loud sounds of the clips do not match</source>
        <translation>les sons forts des clips ne se correspondent pas</translation>
    </message>
</context>
<context>
    <name>synchronisation.robot_ran_straight</name>
    <message>
        <source>the robot ran straight at constant speed, so every time offset fits</source>
        <translation>le robot a roulé en ligne droite à vitesse constante, si bien que tout décalage convient</translation>
    </message>
</context>
<context>
    <name>synchronisation.robot_rested</name>
    <message>
        <source>the robot stood still, so every time offset fits</source>
        <translation>le robot est resté immobile, si bien que tout décalage convient</translation>
    </message>
</context>
<context>
    <name>synchronisation.robots_disagree</name>
    <message>
        <source>robot %1 gives a time offset of %2, robot %3 gives %4; the second was used</source>
        <translation>le robot %1 donne un décalage de %2, le robot %3 %4, qui a été retenu</translation>
    </message>
</context>
<context>
    <name>synchronisation.seldom_seen</name>
    <message>
        <source>one view saw the robot in fewer than %1 frames</source>
        <translation>une vue a vu le robot dans moins de %1 images</translation>
    </message>
</context>
<context>
    <name>synchronisation.seldom_together</name>
    <message>
        <source>the views rarely saw the robot at the same time</source>
        <translation>les vues n’ont presque jamais vu le robot en même temps</translation>
    </message>
</context>
<context>
    <name>synchronisation.short_overlap</name>
    <message>
        <source>the views seem to have only %1 in common, which is too short to be sure</source>
        <translation>les vues semblent n’avoir que %1 en commun, trop peu pour être sûr</translation>
    </message>
</context>
<context>
    <name>synchronisation.sound_beats</name>
    <message>
        <source>the sound is full of beats that are alike, as in music</source>
        <translation>le son est plein de battements semblables, comme en musique</translation>
    </message>
</context>
<context>
    <name>synchronisation.sounds_fit_alike</name>
    <message>
        <source>the sounds of the clips fit equally well at time offsets of %1 and %2</source>
        <translation>les sons des clips conviennent autant à des décalages de %1 et %2</translation>
    </message>
</context>
<context>
    <name>synchronisation.views_distorted</name>
    <message>
        <source>the views show the same run, but with another size or direction: a camera has moved since its registration, or the videos are exchanged</source>
        <translation>les vues montrent le même parcours, mais avec une autre taille ou direction : une caméra a bougé depuis son enregistrement, ou les vidéos sont échangées</translation>
    </message>
</context>
<context>
    <name>synchronisation.ways_disagree</name>
    <message>
        <source>the time offsets found disagree: %1; the first was used</source>
        <translation>les décalages trouvés ne concordent pas&#xa0;: %1&#xa0;; le premier a été retenu</translation>
    </message>
</context>
<context>
    <name>tracking.add_robot</name>
    <message>
        <source>add a robot with its colour first</source>
        <translation>ajoutez d’abord un robot avec sa couleur</translation>
    </message>
</context>
<context>
    <name>tracking.add_without_colour</name>
    <message>
        <source>add the robot without a colour; background subtraction then finds it</source>
        <translation>ajoutez le robot sans couleur, pour qu’il soit trouvé par ce qui le distingue du sol</translation>
    </message>
</context>
<context>
    <name>tracking.box_is_grey</name>
    <message>
        <source>the robot in it is grey, black or white</source>
        <translation>ce qui diffère du sol autour est gris, noir ou blanc</translation>
    </message>
</context>
<context>
    <name>tracking.box_leaves_nothing</name>
    <message>
        <source>the box leaves no floor around it to compare with</source>
        <translation>le cadre ne laisse rien du sol pour comparer</translation>
    </message>
</context>
<context>
    <name>tracking.box_too_small</name>
    <message>
        <source>the box is too small or outside the image</source>
        <translation>le cadre est trop petit, ou hors de l’image</translation>
    </message>
</context>
<context>
    <name>tracking.box_without_colour</name>
    <message>
        <source>it contains no colour that differs from the floor around it</source>
        <translation>il ne contient aucune couleur différente du sol autour</translation>
    </message>
</context>
<context>
    <name>tracking.cannot_track</name>
    <message>
        <source>Cannot track</source>
        <translation>Suivi impossible</translation>
    </message>
</context>
<context>
    <name>tracking.cannot_track_robot</name>
    <message>
        <source>Cannot track robot %1</source>
        <translation>Impossible de suivre le robot %1</translation>
    </message>
</context>
<context>
    <name>tracking.colour_in_box</name>
    <message>
        <source>colour in the box</source>
        <translation>couleur dans le cadre</translation>
    </message>
</context>
<context>
    <name>tracking.colour_is_grey</name>
    <message>
        <source>its colour %1 is grey, and tracking by colour needs a hue that differs from the floor</source>
        <translation>sa couleur %1 est grise, et seule la teinte distingue un robot du sol</translation>
    </message>
</context>
<context>
    <name>tracking.draw_box_closely</name>
    <message>
        <source>draw it closely round the robot</source>
        <translation>tracez-le au plus près du robot</translation>
    </message>
</context>
<context>
    <name>tracking.draw_box_larger</name>
    <message>
        <source>draw it round the robot, at least 8 pixels wide and high</source>
        <translation>tracez-le autour du robot, d’au moins 8 pixels de large et de haut</translation>
    </message>
</context>
<context>
    <name>tracking.no_robot_given</name>
    <message>
        <source>no robot is given</source>
        <translation>aucun robot n’est donné</translation>
    </message>
</context>
<context>
    <name>tracking.put_plate_on_it</name>
    <message>
        <source>draw it closely round the robot, or put a plate of another colour on it</source>
        <translation>tracez-le au plus près du robot, ou posez dessus une plaque d’une autre couleur</translation>
    </message>
</context>
<context>
    <name>tracking.tell_no_colour</name>
    <message>
        <source>set no colour; background subtraction then finds it</source>
        <translation>n’indiquez aucune couleur, pour qu’il soit trouvé par ce qui le distingue du sol</translation>
    </message>
</context>
<context>
    <name>trajectory.add_view</name>
    <message>
        <source>add a second view, or set one height for the robot</source>
        <translation>ajoutez une deuxième vue, ou donnez une hauteur au robot</translation>
    </message>
</context>
<context>
    <name>trajectory.analysing_position</name>
    <message>
        <source>analysing position %1</source>
        <translation>analyse de la position %1</translation>
    </message>
</context>
<context>
    <name>trajectory.camera_not_registered</name>
    <message>
        <source>camera %1 is not registered to the floor</source>
        <translation>la caméra %1 n’est pas localisée au sol</translation>
    </message>
</context>
<context>
    <name>trajectory.cameras_not_registered</name>
    <message>
        <source>cameras %1 are not registered to the floor</source>
        <translation>les caméras %1 ne sont pas localisées au sol</translation>
    </message>
</context>
<context>
    <name>trajectory.centre_reference</name>
    <message>
        <source>set its reference point to 0,0 and track again</source>
        <translation>donnez-lui le point de référence 0,0 et suivez-le à nouveau</translation>
    </message>
</context>
<context>
    <name>trajectory.check_robot_and_light</name>
    <message>
        <source>check that the robot moves in the video, that its colour, if set, matches the video, and that the light is sufficient</source>
        <translation>vérifiez que le robot se déplace dans les images, qu’une couleur indiquée est bien celle qu’il y a, et que la lumière suffit</translation>
    </message>
</context>
<context>
    <name>trajectory.choose_longer_track</name>
    <message>
        <source>choose a track with more positions</source>
        <translation>choisissez une trajectoire avec plus de positions</translation>
    </message>
</context>
<context>
    <name>trajectory.choose_longer_video</name>
    <message>
        <source>choose a longer video, or check the robot&apos;s colour and the light</source>
        <translation>choisissez une vidéo plus longue, ou vérifiez la couleur du robot et la lumière</translation>
    </message>
</context>
<context>
    <name>trajectory.cut_by_edge</name>
    <message>
        <source>cut by the frame&apos;s edge</source>
        <translation>coupé par le bord de l’image</translation>
    </message>
</context>
<context>
    <name>trajectory.cut_by_frames_edge</name>
    <message>
        <source>cut by the frame&apos;s edge in view %1</source>
        <translation>coupé par le bord de l’image dans la vue %1</translation>
    </message>
</context>
<context>
    <name>trajectory.faster_than_limit</name>
    <message>
        <source>speed above the limit</source>
        <translation>plus rapide que la limite</translation>
    </message>
</context>
<context>
    <name>trajectory.figures_of_seen</name>
    <message>
        <source>the metrics cover only the measured part</source>
        <translation>les valeurs portent sur la partie vue</translation>
    </message>
</context>
<context>
    <name>trajectory.frames_that_tell</name>
    <message>
        <source>only %2 of %1 frames give a usable position</source>
        <translation>sur %1 images, %2 donnent une position utilisable</translation>
    </message>
</context>
<context>
    <name>trajectory.harder_than_limit</name>
    <message>
        <source>acceleration above the limit</source>
        <translation>accélération supérieure à la limite</translation>
    </message>
</context>
<context>
    <name>trajectory.heading_unknown</name>
    <message>
        <source>its reference point is not the centre of its footprint, but its outlines do not show its heading</source>
        <translation>son point de référence est hors de son centre, mais ses contours n’indiquent pas son cap</translation>
    </message>
</context>
<context>
    <name>trajectory.hidden_behind</name>
    <message>
        <source>hidden behind %1 in view %2</source>
        <translation>caché derrière %1 dans la vue %2</translation>
    </message>
</context>
<context>
    <name>trajectory.import_exchanged</name>
    <message>
        <source>import them again, each for its own camera</source>
        <translation>importez-les de nouveau, chacune pour sa propre caméra</translation>
    </message>
</context>
<context>
    <name>trajectory.import_video</name>
    <message>
        <source>import at least one video for it</source>
        <translation>importez au moins une vidéo pour lui</translation>
    </message>
</context>
<context>
    <name>trajectory.jump</name>
    <message>
        <source>jump</source>
        <translation>saut</translation>
    </message>
</context>
<context>
    <name>trajectory.jump_of</name>
    <message>
        <source>jump of %1</source>
        <translation>saut de %1</translation>
    </message>
</context>
<context>
    <name>trajectory.look_and_register</name>
    <message>
        <source>check the outlines, and register the cameras again</source>
        <translation>regardez les contours et localisez de nouveau les caméras</translation>
    </message>
</context>
<context>
    <name>trajectory.move_camera</name>
    <message>
        <source>move or add a camera to cover the whole task</source>
        <translation>déplacez ou ajoutez une caméra pour que toute l’épreuve soit vue</translation>
    </message>
</context>
<context>
    <name>trajectory.no_such_smoother</name>
    <message>
        <source>no smoother has this name</source>
        <translation>il n’y en a pas de ce nom</translation>
    </message>
</context>
<context>
    <name>trajectory.no_view</name>
    <message>
        <source>the trial has no view</source>
        <translation>l’essai n’a pas de vue</translation>
    </message>
</context>
<context>
    <name>trajectory.no_view_trusted</name>
    <message>
        <source>none could be trusted</source>
        <translation>aucune n’était fiable</translation>
    </message>
</context>
<context>
    <name>trajectory.not_enough_data</name>
    <message>
        <source>not enough data</source>
        <translation>pas assez de données</translation>
    </message>
</context>
<context>
    <name>trajectory.not_visible</name>
    <message>
        <source>not visible in view %1</source>
        <translation>non visible dans la vue %1</translation>
    </message>
</context>
<context>
    <name>trajectory.occlusion_span</name>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (de %2 à %3)</translation>
    </message>
</context>
<context>
    <name>trajectory.one_outline</name>
    <message>
        <source>outline merged with %1 in view %2</source>
        <translation>un seul contour avec %1 dans la vue %2</translation>
    </message>
</context>
<context>
    <name>trajectory.only_unregistered</name>
    <message>
        <source>only cameras that are not registered to the floor saw the robot</source>
        <translation>seules des caméras non localisées ont vu le robot</translation>
    </message>
</context>
<context>
    <name>trajectory.outline_larger</name>
    <message>
        <source>outline larger than usual in view %1</source>
        <translation>contour plus grand que d’habitude dans la vue %1</translation>
    </message>
</context>
<context>
    <name>trajectory.outline_smaller</name>
    <message>
        <source>outline smaller than usual in view %1</source>
        <translation>contour plus petit que d’habitude dans la vue %1</translation>
    </message>
</context>
<context>
    <name>trajectory.partly_hidden_behind</name>
    <message>
        <source>partly hidden behind %1 in view %2</source>
        <translation>partiellement caché derrière %1 dans la vue %2</translation>
    </message>
</context>
<context>
    <name>trajectory.path_not_measured</name>
    <message>
        <source>the robot&apos;s path cannot be measured</source>
        <translation>la trajectoire du robot ne peut pas être mesurée</translation>
    </message>
</context>
<context>
    <name>trajectory.register_one</name>
    <message>
        <source>run odograph register for at least one of them</source>
        <translation>localisez-en au moins une</translation>
    </message>
</context>
<context>
    <name>trajectory.register_them</name>
    <message>
        <source>run odograph register for them</source>
        <translation>localisez-les</translation>
    </message>
</context>
<context>
    <name>trajectory.robot_not_found</name>
    <message>
        <source>the robot was not found in any frame of %1</source>
        <translation>le robot n’a été trouvé dans aucune image de %1</translation>
    </message>
</context>
<context>
    <name>trajectory.seldom_together</name>
    <message>
        <source>its height is set to be triangulated, but two registered views rarely saw it at the same time</source>
        <translation>sa hauteur doit être triangulée, mais deux vues localisées ne l’ont presque jamais vu ensemble</translation>
    </message>
</context>
<context>
    <name>trajectory.smoother</name>
    <message>
        <source>smoother %1</source>
        <translation>lissage %1</translation>
    </message>
</context>
<context>
    <name>trajectory.spike_by_hand</name>
    <message>
        <source>marked as a spike by hand</source>
        <translation>signalé comme pic à la main</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_both</name>
    <message>
        <source>spike in position and speed</source>
        <translation>s’écarte en position et en vitesse</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_position</name>
    <message>
        <source>spike in position</source>
        <translation>s’écarte en position</translation>
    </message>
</context>
<context>
    <name>trajectory.stands_out_in_speed</name>
    <message>
        <source>spike in speed</source>
        <translation>s’écarte en vitesse</translation>
    </message>
</context>
<context>
    <name>trajectory.track_first</name>
    <message>
        <source>track the trial&apos;s videos first</source>
        <translation>suivez d’abord les vidéos de l’essai</translation>
    </message>
</context>
<context>
    <name>trajectory.tracker_unsure</name>
    <message>
        <source>the tracker was not sure (score %1)</source>
        <translation>le suivi n’était pas sûr (score %1)</translation>
    </message>
</context>
<context>
    <name>trajectory.unmeasured_between</name>
    <message>
        <source>nothing was measured from %1 to %2</source>
        <translation>rien n&apos;a été mesuré de %1 à %2</translation>
    </message>
</context>
<context>
    <name>trajectory.unseen_after</name>
    <message>
        <source>no view sees it after %1 (it was at X %2, Y %3)</source>
        <translation>aucune vue ne le voit après %1 (il était en X %2, Y %3)</translation>
    </message>
</context>
<context>
    <name>trajectory.unseen_between</name>
    <message>
        <source>no view sees it from %1 to %2 (it was at X %3, Y %4)</source>
        <translation>aucune vue ne le voit de %1 à %2 (il était en X %3, Y %4)</translation>
    </message>
</context>
<context>
    <name>trajectory.use_smoother</name>
    <message>
        <source>use rts, savgol, tracker or none</source>
        <translation>utilisez rts, savgol, tracker ou none</translation>
    </message>
</context>
<context>
    <name>trajectory.view_left_out</name>
    <message>
        <source>one left out</source>
        <translation>une a été écartée</translation>
    </message>
</context>
<context>
    <name>trajectory.view_without_frame</name>
    <message>
        <source>view %1 has no frame</source>
        <translation>la vue %1 n’a pas d’image</translation>
    </message>
</context>
<context>
    <name>trajectory.views_apart</name>
    <message>
        <source>the views&apos; floor positions differ by %1</source>
        <translation>les vues le placent à %1 d’écart</translation>
    </message>
</context>
<context>
    <name>trajectory.views_disagree</name>
    <message>
        <source>views disagree by %1</source>
        <translation>les vues sont en désaccord de %1</translation>
    </message>
</context>
<context>
    <name>trajectory.views_exchanged</name>
    <message>
        <source>the videos of %1 and %2 seem to be exchanged: exchanged, they agree</source>
        <translation>les vidéos de %1 et %2 semblent échangées : échangées, elles concordent</translation>
    </message>
</context>
<context>
    <name>trajectory.why_views_apart</name>
    <message>
        <source>a camera has moved since it was registered, the videos belong to other cameras, or one view follows something else</source>
        <translation>une caméra a été déplacée après sa localisation, les vidéos proviennent d’autres caméras ou une vue suit autre chose</translation>
    </message>
</context>
<context>
    <name>ui.add_camera</name>
    <message>
        <source>add camera %1</source>
        <translation>ajouter la caméra %1</translation>
    </message>
</context>
<context>
    <name>ui.add_class</name>
    <message>
        <source>add class %1</source>
        <translation>ajout de la classe %1</translation>
    </message>
</context>
<context>
    <name>ui.add_layout</name>
    <message>
        <source>add layout %1</source>
        <translation>ajout du plan %1</translation>
    </message>
</context>
<context>
    <name>ui.add_robot</name>
    <message>
        <source>add robot %1</source>
        <translation>ajout du robot %1</translation>
    </message>
</context>
<context>
    <name>ui.add_task</name>
    <message>
        <source>add task %1</source>
        <translation>ajout de l’épreuve %1</translation>
    </message>
</context>
<context>
    <name>ui.add_team</name>
    <message>
        <source>add team %1</source>
        <translation>ajout de l’équipe %1</translation>
    </message>
</context>
<context>
    <name>ui.adding_strays</name>
    <message>
        <source>Adding stray videos as trials</source>
        <translation>Ajout des vidéos orphelines comme essais</translation>
    </message>
</context>
<context>
    <name>ui.address_not_here</name>
    <message>
        <source>it is no address of this computer</source>
        <translation>ce n’est pas une adresse de cet ordinateur</translation>
    </message>
</context>
<context>
    <name>ui.and_more</name>
    <message>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
</context>
<context>
    <name>ui.annotated_video</name>
    <message>
        <source>annotated video of &apos;%1&apos;</source>
        <translation>vidéo annotée de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.another_job_runs</name>
    <message>
        <source>another job is running</source>
        <translation>une autre tâche est en cours</translation>
    </message>
</context>
<context>
    <name>ui.archive_class</name>
    <message>
        <source>archive class %1</source>
        <translation>archivage de la classe %1</translation>
    </message>
</context>
<context>
    <name>ui.archive_task</name>
    <message>
        <source>archive task %1</source>
        <translation>archivage de l’épreuve %1</translation>
    </message>
</context>
<context>
    <name>ui.archive_trial</name>
    <message>
        <source>archive %1</source>
        <translation>archivage de %1</translation>
    </message>
</context>
<context>
    <name>ui.archive_trials</name>
    <message>
        <source>archive %1 trials</source>
        <translation>archivage de %1 essais</translation>
    </message>
</context>
<context>
    <name>ui.backup_is_sound</name>
    <message>
        <source>its backup of %1 is intact; it does not contain later changes</source>
        <translation>sa copie de sauvegarde du %1 est intacte ; ce qui a été fait depuis n’y est pas</translation>
    </message>
</context>
<context>
    <name>ui.board_has_corners</name>
    <message>
        <source>a board has 3 to 30 inner corners each way</source>
        <translation>une mire a de 3 à 30 coins intérieurs dans chaque sens</translation>
    </message>
</context>
<context>
    <name>ui.bring_file_back</name>
    <message>
        <source>move the file back there</source>
        <translation>remettez le fichier à sa place</translation>
    </message>
</context>
<context>
    <name>ui.calibrate_other_first</name>
    <message>
        <source>calibrate the other one, or import a trial with it, first</source>
        <translation>étalonnez d’abord l’autre, ou importez un essai avec elle</translation>
    </message>
</context>
<context>
    <name>ui.camera_named</name>
    <message>
        <source>camera %1</source>
        <translation>caméra %1</translation>
    </message>
</context>
<context>
    <name>ui.cameras</name>
    <message>
        <source>the cameras</source>
        <translation>les caméras</translation>
    </message>
</context>
<context>
    <name>ui.cannot_make_another</name>
    <message>
        <source>cannot create another project</source>
        <translation>impossible de créer un autre projet</translation>
    </message>
</context>
<context>
    <name>ui.cannot_open_another</name>
    <message>
        <source>cannot open another project</source>
        <translation>impossible d’ouvrir un autre projet</translation>
    </message>
</context>
<context>
    <name>ui.change_pseudonym</name>
    <message>
        <source>change the pseudonym of team %1</source>
        <translation>modification du pseudonyme de l’équipe %1</translation>
    </message>
</context>
<context>
    <name>ui.change_robot</name>
    <message>
        <source>change robot %1</source>
        <translation>modification du robot %1</translation>
    </message>
</context>
<context>
    <name>ui.change_tags</name>
    <message>
        <source>change the tags of %1</source>
        <translation>modification des étiquettes de %1</translation>
    </message>
</context>
<context>
    <name>ui.change_task</name>
    <message>
        <source>change task %1</source>
        <translation>modification de l’épreuve %1</translation>
    </message>
</context>
<context>
    <name>ui.change_team</name>
    <message>
        <source>change members and robots of team %1</source>
        <translation>modification des membres et des robots de l’équipe %1</translation>
    </message>
</context>
<context>
    <name>ui.charuco_numbered_in_two_ways</name>
    <message>
        <source>programs number a ChArUco board with %1 rows of squares in two different ways</source>
        <translation>une mire ChArUco de %1 rangées de carrés est numérotée de deux façons selon les programmes</translation>
    </message>
</context>
<context>
    <name>ui.check_hub</name>
    <message>
        <source>check the address, the login in ~/.pgpass, and the network</source>
        <translation>vérifiez l’adresse, l’identifiant dans ~/.pgpass et le réseau</translation>
    </message>
</context>
<context>
    <name>ui.choose_another_port</name>
    <message>
        <source>choose another port, or 0 for any that is free</source>
        <translation>choisissez un autre port, ou 0 pour n’importe quel port libre</translation>
    </message>
</context>
<context>
    <name>ui.choose_high_port</name>
    <message>
        <source>choose a port of 1024 or more</source>
        <translation>choisissez un port à partir de 1024</translation>
    </message>
</context>
<context>
    <name>ui.choose_logo</name>
    <message>
        <source>choose a PNG, JPEG or SVG image</source>
        <translation>choisissez une image PNG, JPEG ou SVG</translation>
    </message>
</context>
<context>
    <name>ui.choose_or_make_class</name>
    <message>
        <source>choose one of them, or create it in the workbench</source>
        <translation>choisissez-en une, ou créez-la dans la fenêtre d’Odograph</translation>
    </message>
</context>
<context>
    <name>ui.choose_own_address</name>
    <message>
        <source>choose 127.0.0.1, an address of this computer, or 0.0.0.0 for all of them</source>
        <translation>choisissez 127.0.0.1, une adresse de cet ordinateur, ou 0.0.0.0 pour toutes</translation>
    </message>
</context>
<context>
    <name>ui.choose_recorded</name>
    <message>
        <source>choose one that was recorded</source>
        <translation>choisissez-en un qui a été filmé</translation>
    </message>
</context>
<context>
    <name>ui.choose_trial_or_class</name>
    <message>
        <source>choose a trial or a class</source>
        <translation>choisissez un essai ou une classe</translation>
    </message>
</context>
<context>
    <name>ui.choose_video_size</name>
    <message>
        <source>choose another, such as 1920x1080</source>
        <translation>choisissez-en une autre, comme 1920x1080</translation>
    </message>
</context>
<context>
    <name>ui.choose_video_speed</name>
    <message>
        <source>choose another, such as 0.25</source>
        <translation>choisissez-en une autre, comme 0.25</translation>
    </message>
</context>
<context>
    <name>ui.clips_being_read</name>
    <message>
        <source>those dropped before are still being read</source>
        <translation>les précédentes sont encore en cours de lecture</translation>
    </message>
</context>
<context>
    <name>ui.completing_recording</name>
    <message>
        <source>Completing an interrupted recording</source>
        <translation>Achèvement d’un enregistrement interrompu</translation>
    </message>
</context>
<context>
    <name>ui.connect_camera</name>
    <message>
        <source>connect camera %1</source>
        <translation>connexion de la caméra %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_class</name>
    <message>
        <source>delete class %1</source>
        <translation>suppression de la classe %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_robot</name>
    <message>
        <source>delete robot %1</source>
        <translation>suppression du robot %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_task</name>
    <message>
        <source>delete task %1</source>
        <translation>suppression de l’épreuve %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_team</name>
    <message>
        <source>delete team %1</source>
        <translation>suppression de l’équipe %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_trial</name>
    <message>
        <source>delete %1</source>
        <translation>suppression de %1</translation>
    </message>
</context>
<context>
    <name>ui.delete_trials</name>
    <message>
        <source>delete %1 trials</source>
        <translation>suppression de %1 essais</translation>
    </message>
</context>
<context>
    <name>ui.does_not_fit_on</name>
    <message>
        <source>%1 by %2 do not fit on %3</source>
        <translation>%1 × %2 ne tiennent pas sur %3</translation>
    </message>
</context>
<context>
    <name>ui.drop_again</name>
    <message>
        <source>drop them again in a moment</source>
        <translation>déposez-les de nouveau dans un instant</translation>
    </message>
</context>
<context>
    <name>ui.dropped_clips</name>
    <message>
        <source>the dropped clips</source>
        <translation>les vidéos déposées</translation>
    </message>
</context>
<context>
    <name>ui.emptying_bin</name>
    <message>
        <source>Emptying the bin</source>
        <translation>Vidage de la corbeille</translation>
    </message>
</context>
<context>
    <name>ui.export_of</name>
    <message>
        <source>export of %1</source>
        <translation>exportation de %1</translation>
    </message>
</context>
<context>
    <name>ui.exported_trials</name>
    <message>
        <source>Exported trials: %1 of %2</source>
        <translation>Essais exportés&#xa0;: %1 sur %2</translation>
    </message>
</context>
<context>
    <name>ui.exporting</name>
    <message>
        <source>Exporting %1 (%2 of %3)</source>
        <translation>Exportation de %1 (%2 sur %3)</translation>
    </message>
</context>
<context>
    <name>ui.finding_mat</name>
    <message>
        <source>Finding the floor mat</source>
        <translation>Recherche du tapis de sol</translation>
    </message>
</context>
<context>
    <name>ui.floor_mat</name>
    <message>
        <source>floor mat</source>
        <translation>tapis de sol</translation>
    </message>
</context>
<context>
    <name>ui.give_board_size</name>
    <message>
        <source>give a size such as 9x6</source>
        <translation>donnez une taille comme 9x6</translation>
    </message>
</context>
<context>
    <name>ui.give_marker_size</name>
    <message>
        <source>give its size, such as 150mm</source>
        <translation>donnez sa taille, comme 150mm</translation>
    </message>
</context>
<context>
    <name>ui.give_mat_size</name>
    <message>
        <source>give a size such as 4x3</source>
        <translation>indiquez une taille telle que 4x3</translation>
    </message>
</context>
<context>
    <name>ui.give_square_side</name>
    <message>
        <source>give the side of a square, such as 25mm</source>
        <translation>donnez le côté d’un carré, comme 25mm</translation>
    </message>
</context>
<context>
    <name>ui.html_page</name>
    <message>
        <source>page</source>
        <translation>page</translation>
    </message>
</context>
<context>
    <name>ui.hub_away</name>
    <message>
        <source>it cannot be reached</source>
        <translation>il est inaccessible</translation>
    </message>
</context>
<context>
    <name>ui.hub_goes_on</name>
    <message>
        <source>the page shows the last standings until it is back</source>
        <translation>la page montre le dernier classement jusqu’à son retour</translation>
    </message>
</context>
<context>
    <name>ui.hub_silent</name>
    <message>
        <source>the server does not answer</source>
        <translation>le serveur ne répond pas</translation>
    </message>
</context>
<context>
    <name>ui.import_or_record_first</name>
    <message>
        <source>import or record one first</source>
        <translation>importez ou filmez d’abord un essai</translation>
    </message>
</context>
<context>
    <name>ui.importing</name>
    <message>
        <source>Importing %1</source>
        <translation>Importation de %1</translation>
    </message>
</context>
<context>
    <name>ui.importing_trials</name>
    <message>
        <source>Importing %1 (%2 of %3)</source>
        <translation>Importation de %1 (%2 sur %3)</translation>
    </message>
</context>
<context>
    <name>ui.is_printer_ready</name>
    <message>
        <source>check that the printer is ready</source>
        <translation>regardez si l’imprimante est prête</translation>
    </message>
</context>
<context>
    <name>ui.job_runs_on_project</name>
    <message>
        <source>a job is running on the project</source>
        <translation>une tâche est en cours sur le projet</translation>
    </message>
</context>
<context>
    <name>ui.lens_of_other_size</name>
    <message>
        <source>its size is %1×%2, but the lens was calibrated at %3×%4</source>
        <translation>elle fait %1×%2, mais l’objectif a été mesuré en %3×%4</translation>
    </message>
</context>
<context>
    <name>ui.logo</name>
    <message>
        <source>logo &apos;%1&apos;</source>
        <translation>logo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.logo_too_large</name>
    <message>
        <source>it is larger than a hundred megapixels</source>
        <translation>il dépasse cent mégapixels</translation>
    </message>
</context>
<context>
    <name>ui.look_at_printer</name>
    <message>
        <source>check the printer and its queue, or save the report as PDF</source>
        <translation>regardez l’imprimante et sa file d’attente, ou enregistrez le rapport en PDF</translation>
    </message>
</context>
<context>
    <name>ui.looking_for_lost</name>
    <message>
        <source>Searching for lost videos</source>
        <translation>Recherche des vidéos perdues</translation>
    </message>
</context>
<context>
    <name>ui.looking_for_strays</name>
    <message>
        <source>Searching for stray files</source>
        <translation>Recherche des fichiers orphelins</translation>
    </message>
</context>
<context>
    <name>ui.make_marker_smaller</name>
    <message>
        <source>make it at most %1, or use larger paper</source>
        <translation>faites-le de %1 au plus, ou prenez un papier plus grand</translation>
    </message>
</context>
<context>
    <name>ui.make_smaller</name>
    <message>
        <source>make it smaller</source>
        <translation>réduisez-la</translation>
    </message>
</context>
<context>
    <name>ui.make_squares_smaller</name>
    <message>
        <source>make the squares at most %1, or use larger paper</source>
        <translation>faites les carrés de %1 au plus, ou prenez un papier plus grand</translation>
    </message>
</context>
<context>
    <name>ui.making_certificate</name>
    <message>
        <source>Simulating the set-up</source>
        <translation>Simulation de l’installation</translation>
    </message>
</context>
<context>
    <name>ui.making_demo</name>
    <message>
        <source>Creating the demo lesson</source>
        <translation>Création de la leçon de démonstration</translation>
    </message>
</context>
<context>
    <name>ui.making_hashes</name>
    <message>
        <source>Computing the hashes of new recordings</source>
        <translation>Calcul des empreintes des nouveaux enregistrements</translation>
    </message>
</context>
<context>
    <name>ui.making_report</name>
    <message>
        <source>Creating the report</source>
        <translation>Création du rapport</translation>
    </message>
</context>
<context>
    <name>ui.making_video</name>
    <message>
        <source>Creating the video of %1</source>
        <translation>Création de la vidéo de %1</translation>
    </message>
</context>
<context>
    <name>ui.making_videos</name>
    <message>
        <source>Creating the video of %1 (%2 of %3)</source>
        <translation>Création de la vidéo de %1 (%2 sur %3)</translation>
    </message>
</context>
<context>
    <name>ui.many_trials</name>
    <message>
        <source>many trials</source>
        <translation>plusieurs essais</translation>
    </message>
</context>
<context>
    <name>ui.mat_has_sheets</name>
    <message>
        <source>a mat has 1 to %1 sheets in a row and 1 to %2 rows</source>
        <translation>un tapis a de 1 à %1 feuilles par rangée et de 1 à %2 rangées</translation>
    </message>
</context>
<context>
    <name>ui.measuring_again</name>
    <message>
        <source>Reanalysing %1</source>
        <translation>Nouvelle mesure de %1</translation>
    </message>
</context>
<context>
    <name>ui.measuring_trials_again</name>
    <message>
        <source>Reanalysing %1 (%2 of %3)</source>
        <translation>Nouvelle mesure de %1 (%2 sur %3)</translation>
    </message>
</context>
<context>
    <name>ui.mend_and_choose_again</name>
    <message>
        <source>correct the listed errors, then select these trials again</source>
        <translation>corrigez ce qui est indiqué, puis choisissez de nouveau ces essais</translation>
    </message>
</context>
<context>
    <name>ui.move_team</name>
    <message>
        <source>move team %1 to class %2</source>
        <translation>déplacement de l’équipe %1 vers la classe %2</translation>
    </message>
</context>
<context>
    <name>ui.name_one_marker</name>
    <message>
        <source>name at least one, for example O</source>
        <translation>nommez-en au moins un, comme O</translation>
    </message>
</context>
<context>
    <name>ui.no_camera_registered</name>
    <message>
        <source>no camera is registered yet</source>
        <translation>aucune caméra n’est encore localisée</translation>
    </message>
</context>
<context>
    <name>ui.no_further_page</name>
    <message>
        <source>it accepts no more pages</source>
        <translation>elle n’accepte plus de page</translation>
    </message>
</context>
<context>
    <name>ui.no_marker_to_print</name>
    <message>
        <source>no marker to print</source>
        <translation>il n’y a aucun marqueur à imprimer</translation>
    </message>
</context>
<context>
    <name>ui.no_page</name>
    <message>
        <source>it has no page</source>
        <translation>il n’a aucune page</translation>
    </message>
</context>
<context>
    <name>ui.no_project_open</name>
    <message>
        <source>no project is open</source>
        <translation>aucun projet n’est ouvert</translation>
    </message>
</context>
<context>
    <name>ui.no_run_with_figure</name>
    <message>
        <source>none of its teams has a run with the metric &apos;%1&apos;</source>
        <translation>aucune de ses équipes n’a de passage avec la grandeur &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.no_run_with_figure_in_task</name>
    <message>
        <source>none of its teams has a run with the metric &apos;%1&apos; in the task &apos;%2&apos;</source>
        <translation>aucune de ses équipes n’a de passage avec la grandeur &apos;%1&apos; dans l’épreuve &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>ui.no_trial_yet</name>
    <message>
        <source>the project has no trial yet</source>
        <translation>il n’y a pas encore d’essai</translation>
    </message>
</context>
<context>
    <name>ui.not_printed</name>
    <message>
        <source>it could not be printed</source>
        <translation>l’impression a échoué</translation>
    </message>
</context>
<context>
    <name>ui.nothing_changed_here</name>
    <message>
        <source>no change was made here</source>
        <translation>rien n’a été modifié ici</translation>
    </message>
</context>
<context>
    <name>ui.only_be_read</name>
    <message>
        <source>this project is read-only</source>
        <translation>ce projet ne peut qu’être lu</translation>
    </message>
</context>
<context>
    <name>ui.only_one_camera</name>
    <message>
        <source>the project has only one camera</source>
        <translation>il n’y a qu’une caméra</translation>
    </message>
</context>
<context>
    <name>ui.only_so_many_charuco_markers</name>
    <message>
        <source>only 250 markers exist for a ChArUco board</source>
        <translation>il n’y a que 250 marqueurs pour une mire ChArUco</translation>
    </message>
</context>
<context>
    <name>ui.only_so_many_tags</name>
    <message>
        <source>only %1 tags exist</source>
        <translation>il n’y a que %1 tags</translation>
    </message>
</context>
<context>
    <name>ui.open_its_project</name>
    <message>
        <source>open the project that it belongs to</source>
        <translation>ouvrez le projet auquel cela appartient</translation>
    </message>
</context>
<context>
    <name>ui.open_project_first</name>
    <message>
        <source>open or create a project first</source>
        <translation>ouvrez ou créez d’abord un projet</translation>
    </message>
</context>
<context>
    <name>ui.opening</name>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
</context>
<context>
    <name>ui.packing</name>
    <message>
        <source>Packing the project</source>
        <translation>Empaquetage du projet</translation>
    </message>
</context>
<context>
    <name>ui.page_of_trial</name>
    <message>
        <source>page of trial &apos;%1&apos;</source>
        <translation>page de l’essai &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.pages_not_taken</name>
    <message>
        <source>it did not accept the pages</source>
        <translation>elle n’a pas accepté les pages</translation>
    </message>
</context>
<context>
    <name>ui.painting_floor</name>
    <message>
        <source>drawing the floor</source>
        <translation>dessin du sol</translation>
    </message>
</context>
<context>
    <name>ui.picture</name>
    <message>
        <source>the image</source>
        <translation>l’image</translation>
    </message>
</context>
<context>
    <name>ui.picture_of</name>
    <message>
        <source>frame %1 of %2</source>
        <translation>image %1 sur %2</translation>
    </message>
</context>
<context>
    <name>ui.port_in_use</name>
    <message>
        <source>another program uses this port</source>
        <translation>un autre programme utilise ce port</translation>
    </message>
</context>
<context>
    <name>ui.port_not_allowed</name>
    <message>
        <source>the system does not allow this port</source>
        <translation>le système n’autorise pas ce port</translation>
    </message>
</context>
<context>
    <name>ui.preview</name>
    <message>
        <source>preview</source>
        <translation>aperçu</translation>
    </message>
</context>
<context>
    <name>ui.print_fewer_markers</name>
    <message>
        <source>print fewer markers</source>
        <translation>imprimez moins de marqueurs</translation>
    </message>
</context>
<context>
    <name>ui.printer_not_reached</name>
    <message>
        <source>it cannot be reached</source>
        <translation>elle est injoignable</translation>
    </message>
</context>
<context>
    <name>ui.printing_on</name>
    <message>
        <source>printing on &apos;%1&apos;</source>
        <translation>impression sur « %1 »</translation>
    </message>
</context>
<context>
    <name>ui.project_has_classes</name>
    <message>
        <source>the project has %1</source>
        <translation>le projet a %1</translation>
    </message>
</context>
<context>
    <name>ui.project_has_no_class</name>
    <message>
        <source>the project has none</source>
        <translation>le projet n’en a aucune</translation>
    </message>
</context>
<context>
    <name>ui.recording_not_there</name>
    <message>
        <source>the recording of camera %1 is not at &apos;%2&apos;</source>
        <translation>l’enregistrement de la caméra %1 ne se trouve pas à &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>ui.register_one_first</name>
    <message>
        <source>register one that sees the markers first</source>
        <translation>localisez-en d’abord une qui voit les marqueurs</translation>
    </message>
</context>
<context>
    <name>ui.registering</name>
    <message>
        <source>Registering camera %1</source>
        <translation>Localisation de la caméra %1</translation>
    </message>
</context>
<context>
    <name>ui.registration_through_another</name>
    <message>
        <source>registration via another camera</source>
        <translation>localisation par une autre caméra</translation>
    </message>
</context>
<context>
    <name>ui.removing_strays</name>
    <message>
        <source>Removing stray files</source>
        <translation>Suppression des fichiers orphelins</translation>
    </message>
</context>
<context>
    <name>ui.rename_class</name>
    <message>
        <source>rename class %1 to %2</source>
        <translation>classe %1 renommée en %2</translation>
    </message>
</context>
<context>
    <name>ui.rename_task</name>
    <message>
        <source>rename task %1 to %2</source>
        <translation>épreuve %1 renommée en %2</translation>
    </message>
</context>
<context>
    <name>ui.rename_team</name>
    <message>
        <source>rename team %1 to %2</source>
        <translation>équipe %1 renommée en %2</translation>
    </message>
</context>
<context>
    <name>ui.report</name>
    <message>
        <source>report</source>
        <translation>rapport</translation>
    </message>
</context>
<context>
    <name>ui.report_file</name>
    <message>
        <source>report &apos;%1&apos;</source>
        <translation>rapport « %1 »</translation>
    </message>
</context>
<context>
    <name>ui.report_of_class</name>
    <message>
        <source>report of class &apos;%1&apos;</source>
        <translation>rapport de la classe &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>ui.restoring_backup</name>
    <message>
        <source>Restoring the backup</source>
        <translation>Restauration de la copie de sauvegarde</translation>
    </message>
</context>
<context>
    <name>ui.save_copy</name>
    <message>
        <source>save a copy and work on the copy</source>
        <translation>enregistrez une copie et travaillez sur celle-ci</translation>
    </message>
</context>
<context>
    <name>ui.saving_copy</name>
    <message>
        <source>Saving a copy</source>
        <translation>Enregistrement d’une copie</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_address</name>
    <message>
        <source>standings at %1 port %2</source>
        <translation>classement sur %1 port %2</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_project_gone</name>
    <message>
        <source>it was moved or deleted, so the standings ended</source>
        <translation>il a été déplacé ou supprimé, le classement s’est donc arrêté</translation>
    </message>
</context>
<context>
    <name>ui.scoreboard_start_again</name>
    <message>
        <source>start them with the file&apos;s present name</source>
        <translation>relancez-le avec le nom actuel du fichier</translation>
    </message>
</context>
<context>
    <name>ui.size_is_no_length</name>
    <message>
        <source>its size is not a length</source>
        <translation>sa taille n’est pas une longueur</translation>
    </message>
</context>
<context>
    <name>ui.star_trial</name>
    <message>
        <source>star %1</source>
        <translation>étoile mise à %1</translation>
    </message>
</context>
<context>
    <name>ui.star_trials</name>
    <message>
        <source>star %1 trials</source>
        <translation>étoile mise à %1 essais</translation>
    </message>
</context>
<context>
    <name>ui.synchronising</name>
    <message>
        <source>Synchronising %1</source>
        <translation>Synchronisation de %1</translation>
    </message>
</context>
<context>
    <name>ui.take_at_that_resolution</name>
    <message>
        <source>use that resolution, or calibrate the lens again</source>
        <translation>prenez-la à cette résolution, ou mesurez l’objectif à nouveau</translation>
    </message>
</context>
<context>
    <name>ui.take_even_rows</name>
    <message>
        <source>use an even number of rows of inner corners, such as 9x6</source>
        <translation>prenez un nombre pair de rangées de coins intérieurs, comme 9x6</translation>
    </message>
</context>
<context>
    <name>ui.take_fewer_squares</name>
    <message>
        <source>use fewer squares</source>
        <translation>prenez moins de carrés</translation>
    </message>
</context>
<context>
    <name>ui.take_team_out</name>
    <message>
        <source>remove team %1 from its class</source>
        <translation>retrait de l’équipe %1 de sa classe</translation>
    </message>
</context>
<context>
    <name>ui.taking_over_setup</name>
    <message>
        <source>Copying the set-up</source>
        <translation>Reprise de l’installation</translation>
    </message>
</context>
<context>
    <name>ui.target</name>
    <message>
        <source>target</source>
        <translation>cible</translation>
    </message>
</context>
<context>
    <name>ui.the_range</name>
    <message>
        <source>the range</source>
        <translation>la plage</translation>
    </message>
</context>
<context>
    <name>ui.the_sample</name>
    <message>
        <source>the sample</source>
        <translation>l’échantillon</translation>
    </message>
</context>
<context>
    <name>ui.the_trial</name>
    <message>
        <source>the trial</source>
        <translation>l’essai</translation>
    </message>
</context>
<context>
    <name>ui.track_or_choose_figure</name>
    <message>
        <source>track its trials, or choose another task or metric</source>
        <translation>suivez ses essais, ou choisissez une autre épreuve ou grandeur</translation>
    </message>
</context>
<context>
    <name>ui.tracking</name>
    <message>
        <source>Tracking %1</source>
        <translation>Suivi de %1</translation>
    </message>
</context>
<context>
    <name>ui.trial_without_recording</name>
    <message>
        <source>the trial has no recording</source>
        <translation>l’essai n’a pas d’enregistrement</translation>
    </message>
</context>
<context>
    <name>ui.trials_imported</name>
    <message>
        <source>Trials imported: %1 of %2</source>
        <translation>Essais importés : %1 sur %2</translation>
    </message>
</context>
<context>
    <name>ui.trials_measured_again</name>
    <message>
        <source>Trials reanalysed: %1 of %2</source>
        <translation>Essais remesurés&#xa0;: %1 sur %2</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_class</name>
    <message>
        <source>restore class %1 from the archive</source>
        <translation>désarchivage de la classe %1</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_task</name>
    <message>
        <source>restore task %1 from the archive</source>
        <translation>désarchivage de l’épreuve %1</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_trial</name>
    <message>
        <source>restore %1 from the archive</source>
        <translation>désarchivage de %1</translation>
    </message>
</context>
<context>
    <name>ui.unarchive_trials</name>
    <message>
        <source>restore %1 trials from the archive</source>
        <translation>désarchivage de %1 essais</translation>
    </message>
</context>
<context>
    <name>ui.undelete_trial</name>
    <message>
        <source>restore %1 from the bin</source>
        <translation>restauration de %1 depuis la corbeille</translation>
    </message>
</context>
<context>
    <name>ui.undelete_trials</name>
    <message>
        <source>restore %1 trials from the bin</source>
        <translation>restauration de %1 essais depuis la corbeille</translation>
    </message>
</context>
<context>
    <name>ui.undo_in_menu</name>
    <message>
        <source>use the window&apos;s Edit menu to undo earlier changes</source>
        <translation>ce qui a été modifié avant s’annule dans le menu «&#xa0;Édition&#xa0;» de la fenêtre</translation>
    </message>
</context>
<context>
    <name>ui.unpacking</name>
    <message>
        <source>Unpacking the project</source>
        <translation>Dépaquetage du projet</translation>
    </message>
</context>
<context>
    <name>ui.unstar_trial</name>
    <message>
        <source>remove the star from %1</source>
        <translation>étoile retirée à %1</translation>
    </message>
</context>
<context>
    <name>ui.unstar_trials</name>
    <message>
        <source>remove the star from %1 trials</source>
        <translation>étoile retirée à %1 essais</translation>
    </message>
</context>
<context>
    <name>ui.video_size_wrong</name>
    <message>
        <source>its size of %1x%2 has an odd number of pixels, or is not between 320x180 and 3840x2160</source>
        <translation>sa taille de %1x%2 est impaire, ou n’est pas comprise entre 320x180 et 3840x2160</translation>
    </message>
</context>
<context>
    <name>ui.video_speed_wrong</name>
    <message>
        <source>its speed is not between 0.1 and 1</source>
        <translation>sa vitesse n’est pas comprise entre 0,1 et 1</translation>
    </message>
</context>
<context>
    <name>ui.videos_made</name>
    <message>
        <source>Videos created: %1 of %2</source>
        <translation>Vidéos créées&#xa0;: %1 sur %2</translation>
    </message>
</context>
<context>
    <name>ui.wait_or_cancel</name>
    <message>
        <source>wait until it is done, or cancel it</source>
        <translation>attendez qu’elle soit finie, ou annulez-la</translation>
    </message>
</context>
<context>
    <name>ui.write_notes</name>
    <message>
        <source>write notes of %1</source>
        <translation>rédaction des notes de %1</translation>
    </message>
</context>
<context>
    <name>ui.writing_back</name>
    <message>
        <source>writing back</source>
        <translation>réécriture dans le projet</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode</name>
    <message>
        <source>cannot decode the video</source>
        <translation>la vidéo ne peut pas être décodée</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode_all</name>
    <message>
        <source>cannot decode all of a frame</source>
        <translation>impossible de décoder toute une image</translation>
    </message>
</context>
<context>
    <name>video.cannot_decode_frame</name>
    <message>
        <source>cannot decode frame %1 of %2</source>
        <translation>impossible de décoder l’image %1 de %2</translation>
    </message>
</context>
<context>
    <name>video.cannot_encode</name>
    <message>
        <source>cannot encode the video</source>
        <translation>impossible d’encoder la vidéo</translation>
    </message>
</context>
<context>
    <name>video.cannot_finish</name>
    <message>
        <source>cannot finish the video %1</source>
        <translation>impossible de terminer la vidéo %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_join</name>
    <message>
        <source>cannot join &apos;%1&apos; to a recording</source>
        <translation>impossible de réunir &apos;%1&apos; à un enregistrement</translation>
    </message>
</context>
<context>
    <name>video.cannot_open</name>
    <message>
        <source>cannot open the video %1</source>
        <translation>impossible d’ouvrir la vidéo %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_read_picture</name>
    <message>
        <source>cannot read the image %1</source>
        <translation>l&apos;image %1 ne peut pas être lue</translation>
    </message>
</context>
<context>
    <name>video.cannot_read_sound</name>
    <message>
        <source>cannot read the sound of %1</source>
        <translation>impossible de lire le son de %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_show_frame</name>
    <message>
        <source>cannot show frame %1 of %2</source>
        <translation>impossible de montrer l’image %1 de %2</translation>
    </message>
</context>
<context>
    <name>video.cannot_take_image</name>
    <message>
        <source>cannot take &apos;%1&apos; as a frame of a video</source>
        <translation>impossible de prendre &apos;%1&apos; comme image d’une vidéo</translation>
    </message>
</context>
<context>
    <name>video.cannot_write</name>
    <message>
        <source>cannot write the video %1</source>
        <translation>impossible d’écrire la vidéo %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_frame</name>
    <message>
        <source>cannot write a frame to the video %1</source>
        <translation>impossible d’écrire une image dans la vidéo %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_joined</name>
    <message>
        <source>cannot write the joined recording %1</source>
        <translation>impossible d’écrire l’enregistrement réuni %1</translation>
    </message>
</context>
<context>
    <name>video.cannot_write_recording</name>
    <message>
        <source>cannot write the recording %1</source>
        <translation>impossible d’écrire l’enregistrement %1</translation>
    </message>
</context>
<context>
    <name>video.chapter_after_gap</name>
    <message>
        <source>by its recording time %1 are missing between &apos;%2&apos; and it; if so, all times behind that are wrong</source>
        <translation>d’après son heure d’enregistrement, il manque %1 entre &apos;%2&apos; et lui ; si c’est le cas, tous les temps qui suivent sont faux</translation>
    </message>
</context>
<context>
    <name>video.chapter_codec</name>
    <message>
        <source>its codec is %1, that of &apos;%2&apos; is %3</source>
        <translation>son codec est %1, celui de &apos;%2&apos; est %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_hides_frames</name>
    <message>
        <source>some of its frames are hidden, as an editor does that cuts a video</source>
        <translation>certaines de ses images sont masquées, comme le fait un logiciel de montage qui coupe une vidéo</translation>
    </message>
</context>
<context>
    <name>video.chapter_mirrored</name>
    <message>
        <source>its frames and those of &apos;%1&apos; are not mirrored alike</source>
        <translation>ses images et celles de &apos;%1&apos; ne sont pas retournées de la même façon</translation>
    </message>
</context>
<context>
    <name>video.chapter_pixels</name>
    <message>
        <source>its pixel format is %1, that of &apos;%2&apos; is %3</source>
        <translation>son format de pixel est %1, celui de &apos;%2&apos; est %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_recorded_before</name>
    <message>
        <source>by its recording time it was started before &apos;%1&apos;, behind which it was joined; check the order of the files</source>
        <translation>d’après son heure d’enregistrement, il a commencé avant &apos;%1&apos;, derrière lequel il a été placé ; vérifiez l’ordre des fichiers</translation>
    </message>
</context>
<context>
    <name>video.chapter_restarts</name>
    <message>
        <source>its time stamps begin again or stand still after %1</source>
        <translation>ses horodatages recommencent ou s&apos;arrêtent après %1</translation>
    </message>
</context>
<context>
    <name>video.chapter_set_up</name>
    <message>
        <source>its encoder was set up in another way than that of &apos;%1&apos;</source>
        <translation>son encodeur était réglé autrement que celui de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.chapter_size</name>
    <message>
        <source>its frames are %1, those of &apos;%2&apos; are %3</source>
        <translation>ses images sont en %1, celles de &apos;%2&apos; en %3</translation>
    </message>
</context>
<context>
    <name>video.chapter_turn</name>
    <message>
        <source>its frames are to be turned by %1°, those of &apos;%2&apos; by %3°</source>
        <translation>ses images sont à tourner de %1°, celles de &apos;%2&apos; de %3°</translation>
    </message>
</context>
<context>
    <name>video.chapter_without_stamps</name>
    <message>
        <source>its frames have no time stamps of their own</source>
        <translation>ses images n’ont pas d’horodatages propres</translation>
    </message>
</context>
<context>
    <name>video.chapters_of_one_frame</name>
    <message>
        <source>each of the files has a single frame</source>
        <translation>chacun des fichiers n’a qu’une image</translation>
    </message>
</context>
<context>
    <name>video.check_its_folder</name>
    <message>
        <source>check that its folder may be written to and has free space</source>
        <translation>vérifiez que son dossier peut être modifié et a de la place</translation>
    </message>
</context>
<context>
    <name>video.check_picture_place</name>
    <message>
        <source>check the folder, the free space, and that the name ends in .png or .jpg</source>
        <translation>vérifiez le dossier, la place libre, et que le nom finit par .png ou .jpg</translation>
    </message>
</context>
<context>
    <name>video.check_room</name>
    <message>
        <source>check the free disk space</source>
        <translation>vérifiez qu’il y a de la place sur le disque</translation>
    </message>
</context>
<context>
    <name>video.check_the_folder</name>
    <message>
        <source>check that the folder exists, may be written to and has free space</source>
        <translation>vérifiez que le dossier existe, peut être modifié et a de la place</translation>
    </message>
</context>
<context>
    <name>video.check_what_was_asked</name>
    <message>
        <source>check the requested size, frame rate and quality</source>
        <translation>vérifiez la taille, la cadence et la qualité demandées</translation>
    </message>
</context>
<context>
    <name>video.choose_one_of_these</name>
    <message>
        <source>choose one of these</source>
        <translation>choisissez-en une</translation>
    </message>
</context>
<context>
    <name>video.convert_sound_to_aac</name>
    <message>
        <source>convert its sound to AAC</source>
        <translation>convertissez son son en AAC</translation>
    </message>
</context>
<context>
    <name>video.convert_to_h264</name>
    <message>
        <source>convert it to H.264</source>
        <translation>convertissez-le en H.264</translation>
    </message>
</context>
<context>
    <name>video.convert_to_png</name>
    <message>
        <source>convert it to PNG or JPEG</source>
        <translation>convertissez-la en PNG ou JPEG</translation>
    </message>
</context>
<context>
    <name>video.convert_to_smaller</name>
    <message>
        <source>convert it to a smaller size</source>
        <translation>convertissez-la à une taille plus petite</translation>
    </message>
</context>
<context>
    <name>video.convert_to_yuv</name>
    <message>
        <source>convert it to 8-bit YUV, e.g. ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4</source>
        <translation>convertissez-la en YUV 8 bits, p. ex. ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4</translation>
    </message>
</context>
<context>
    <name>video.copy_again</name>
    <message>
        <source>copy it again</source>
        <translation>recopiez-la</translation>
    </message>
</context>
<context>
    <name>video.copy_chapter_again</name>
    <message>
        <source>copy it from the camera again: what follows it would get wrong times</source>
        <translation>recopiez-le depuis la caméra : ce qui suit aurait des temps faux</translation>
    </message>
</context>
<context>
    <name>video.copy_from_camera</name>
    <message>
        <source>copy it from the camera again</source>
        <translation>recopiez-le depuis la caméra</translation>
    </message>
</context>
<context>
    <name>video.copy_if_cut_short</name>
    <message>
        <source>copy it from the camera again if it was cut short</source>
        <translation>recopiez-le depuis la caméra s’il a été tronqué</translation>
    </message>
</context>
<context>
    <name>video.cut_chapter_there</name>
    <message>
        <source>cut it there, and give both parts</source>
        <translation>coupez-le à cet endroit et indiquez les deux parties</translation>
    </message>
</context>
<context>
    <name>video.data_damaged</name>
    <message>
        <source>its data are damaged</source>
        <translation>ses données sont abîmées</translation>
    </message>
</context>
<context>
    <name>video.decoder_not_started</name>
    <message>
        <source>its decoder did not start (%1)</source>
        <translation>son décodeur n’a pas démarré (%1)</translation>
    </message>
</context>
<context>
    <name>video.each_at_its_time</name>
    <message>
        <source>each frame keeps its own time</source>
        <translation>chacune compte à son propre instant</translation>
    </message>
</context>
<context>
    <name>video.encoder_not_started</name>
    <message>
        <source>the encoder did not start (%1)</source>
        <translation>l’encodeur n’a pas démarré (%1)</translation>
    </message>
</context>
<context>
    <name>video.ends_early</name>
    <message>
        <source>ends early at %1</source>
        <translation>finit trop tôt, à %1</translation>
    </message>
</context>
<context>
    <name>video.failed_before</name>
    <message>
        <source>writing failed earlier</source>
        <translation>l’écriture avait déjà échoué</translation>
    </message>
</context>
<context>
    <name>video.file_not_read</name>
    <message>
        <source>the file could not be read</source>
        <translation>le fichier n’a pas pu être lu</translation>
    </message>
</context>
<context>
    <name>video.format_differs</name>
    <message>
        <source>its format differs from the video&apos;s</source>
        <translation>son format diffère de celui de la vidéo</translation>
    </message>
</context>
<context>
    <name>video.frame_left_out</name>
    <message>
        <source>it is left out</source>
        <translation>on l’écarte</translation>
    </message>
</context>
<context>
    <name>video.frames_it_has</name>
    <message>
        <source>it has frames 0 to %1</source>
        <translation>elle a les images 0 à %1</translation>
    </message>
</context>
<context>
    <name>video.frames_left_out</name>
    <message>
        <source>%1 frames left out</source>
        <translation>%1 images omises</translation>
    </message>
</context>
<context>
    <name>video.frames_not_encodable</name>
    <message>
        <source>frames of this size or chroma format cannot be encoded</source>
        <translation>les images de cette taille ou de ce format de chrominance ne peuvent pas être codées</translation>
    </message>
</context>
<context>
    <name>video.give_another_format</name>
    <message>
        <source>set the camera to another format</source>
        <translation>faites donner un autre format à la caméra</translation>
    </message>
</context>
<context>
    <name>video.give_as_images</name>
    <message>
        <source>give images as a folder, with their rate</source>
        <translation>indiquez les images par leur dossier, avec leur fréquence</translation>
    </message>
</context>
<context>
    <name>video.give_camera_file</name>
    <message>
        <source>give the file that the camera recorded</source>
        <translation>donnez le fichier enregistré par la caméra</translation>
    </message>
</context>
<context>
    <name>video.give_chapter_of_camera</name>
    <message>
        <source>give the file as the camera wrote it</source>
        <translation>indiquez le fichier tel que la caméra l’a écrit</translation>
    </message>
</context>
<context>
    <name>video.give_container</name>
    <message>
        <source>give an MP4, MOV, MKV or AVI file</source>
        <translation>donnez un fichier MP4, MOV, MKV ou AVI</translation>
    </message>
</context>
<context>
    <name>video.give_known_ending</name>
    <message>
        <source>give it one of these endings</source>
        <translation>donnez-lui une de ces terminaisons</translation>
    </message>
</context>
<context>
    <name>video.give_rate</name>
    <message>
        <source>give the frames per second, e.g. 30</source>
        <translation>donnez les images par seconde, p. ex. 30</translation>
    </message>
</context>
<context>
    <name>video.give_shorter_clip</name>
    <message>
        <source>give a shorter clip</source>
        <translation>donnez un clip plus court</translation>
    </message>
</context>
<context>
    <name>video.h264_needs_even</name>
    <message>
        <source>H.264 needs an even width and height, not %1</source>
        <translation>H.264 exige une largeur et une hauteur paires, pas %1</translation>
    </message>
</context>
<context>
    <name>video.header_not_rewritten</name>
    <message>
        <source>its header could not be rewritten</source>
        <translation>son en-tête n’a pas pu être réécrit</translation>
    </message>
</context>
<context>
    <name>video.header_promises</name>
    <message>
        <source>its header promises %1</source>
        <translation>son en-tête promet %1</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_kind</name>
    <message>
        <source>it is not an upright JPEG in colour as the first, &apos;%1&apos;, is</source>
        <translation>ce n’est pas un JPEG droit en couleur comme la première, &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_layout</name>
    <message>
        <source>its colours are stored in another way than those of the first, &apos;%1&apos;</source>
        <translation>ses couleurs sont enregistrées autrement que celles de la première, &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.image_of_other_size</name>
    <message>
        <source>its size is %1, that of the first, &apos;%2&apos;, is %3</source>
        <translation>sa taille est %1, celle de la première, &apos;%2&apos;, est %3</translation>
    </message>
</context>
<context>
    <name>video.install_libavcodec</name>
    <message>
        <source>install Debian&apos;s libavcodec</source>
        <translation>installez le libavcodec de Debian</translation>
    </message>
</context>
<context>
    <name>video.install_libx264</name>
    <message>
        <source>install Debian&apos;s libavcodec with libx264</source>
        <translation>installez le libavcodec de Debian avec libx264</translation>
    </message>
</context>
<context>
    <name>video.is_finished</name>
    <message>
        <source>it is finished</source>
        <translation>elle est terminée</translation>
    </message>
</context>
<context>
    <name>video.join_one_recording</name>
    <message>
        <source>join only the files into which a camera has split one recording</source>
        <translation>ne réunissez que les fichiers en lesquels une caméra a divisé un même enregistrement</translation>
    </message>
</context>
<context>
    <name>video.joining_chapters</name>
    <message>
        <source>joining &apos;%1&apos;</source>
        <translation>réunion de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.largest_picture</name>
    <message>
        <source>the limit is 50 megapixels and 32000 pixels a side</source>
        <translation>plus de 50 mégapixels ou 32000 pixels de côté ne sont pas lus</translation>
    </message>
</context>
<context>
    <name>video.leave_out_image</name>
    <message>
        <source>leave it out, or convert all of them in the same way</source>
        <translation>omettez-la ou convertissez-les toutes de la même façon</translation>
    </message>
</context>
<context>
    <name>video.make_smaller</name>
    <message>
        <source>make it smaller</source>
        <translation>réduisez-la</translation>
    </message>
</context>
<context>
    <name>video.name_a_picture</name>
    <message>
        <source>choose an image</source>
        <translation>nommez une image</translation>
    </message>
</context>
<context>
    <name>video.no_decoder</name>
    <message>
        <source>there is no decoder for %1</source>
        <translation>il n’y a pas de décodeur pour %1</translation>
    </message>
</context>
<context>
    <name>video.no_encoder</name>
    <message>
        <source>the installed libavcodec has no encoder for it</source>
        <translation>le libavcodec installé n’a pas d’encodeur pour cela</translation>
    </message>
</context>
<context>
    <name>video.no_ffv1_in_mp4</name>
    <message>
        <source>MP4 cannot contain FFV1</source>
        <translation>FFV1 ne va pas dans du MP4</translation>
    </message>
</context>
<context>
    <name>video.no_frame_written</name>
    <message>
        <source>no frame was written to it</source>
        <translation>aucune image n’y a été écrite</translation>
    </message>
</context>
<context>
    <name>video.no_jpeg_layout</name>
    <message>
        <source>JPEG does not support its colour layout</source>
        <translation>JPEG n’a pas sa disposition de couleurs</translation>
    </message>
</context>
<context>
    <name>video.no_known_ending</name>
    <message>
        <source>its name ends with neither .mkv nor .mp4</source>
        <translation>son nom ne finit ni par .mkv ni par .mp4</translation>
    </message>
</context>
<context>
    <name>video.no_picture_format</name>
    <message>
        <source>it is not a PNG, JPEG, TIFF, HEIC, WebP, BMP or PNM image</source>
        <translation>ce n’est pas une image PNG, JPEG, TIFF, HEIC, WebP, BMP ou PNM</translation>
    </message>
</context>
<context>
    <name>video.no_sound</name>
    <message>
        <source>it has no sound</source>
        <translation>il n’a pas de son</translation>
    </message>
</context>
<context>
    <name>video.no_stream</name>
    <message>
        <source>it contains no readable video stream</source>
        <translation>aucun flux vidéo lisible</translation>
    </message>
</context>
<context>
    <name>video.no_time_scale</name>
    <message>
        <source>its time scale was not found where the muxer should have put it</source>
        <translation>son échelle de temps n’est pas là où le multiplexeur devait la mettre</translation>
    </message>
</context>
<context>
    <name>video.no_time_stamps</name>
    <message>
        <source>the file has no time stamps</source>
        <translation>le fichier n’a pas d’horodatages</translation>
    </message>
</context>
<context>
    <name>video.no_video_kind</name>
    <message>
        <source>it is not a supported kind of video, or its header is damaged or missing (%1)</source>
        <translation>ce n’est pas une vidéo d’un type lisible, ou son en-tête est abîmé ou manquant (%1)</translation>
    </message>
</context>
<context>
    <name>video.no_whole_frame</name>
    <message>
        <source>it contains no complete frame</source>
        <translation>aucune image entière n’y est</translation>
    </message>
</context>
<context>
    <name>video.of_chapter</name>
    <message>
        <source>video &apos;%1&apos;</source>
        <translation>vidéo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.packet_damaged</name>
    <message>
        <source>a packet is damaged</source>
        <translation>un paquet y est endommagé</translation>
    </message>
</context>
<context>
    <name>video.picture</name>
    <message>
        <source>image</source>
        <translation>image</translation>
    </message>
</context>
<context>
    <name>video.picture_claims_size</name>
    <message>
        <source>its header says that it has %1 pixels</source>
        <translation>elle dit avoir %1 pixels</translation>
    </message>
</context>
<context>
    <name>video.picture_damaged</name>
    <message>
        <source>its content is damaged or cut short</source>
        <translation>son contenu est abîmé ou tronqué</translation>
    </message>
</context>
<context>
    <name>video.picture_file_too_large</name>
    <message>
        <source>the file is larger than 200 MB</source>
        <translation>le fichier dépasse 200 Mo</translation>
    </message>
</context>
<context>
    <name>video.picture_format_unknown</name>
    <message>
        <source>its format is unknown</source>
        <translation>son format n’est pas connu</translation>
    </message>
</context>
<context>
    <name>video.picture_named</name>
    <message>
        <source>image &apos;%1&apos;</source>
        <translation>image &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.picture_not_coded</name>
    <message>
        <source>a frame cannot be encoded</source>
        <translation>une image ne peut pas être codée</translation>
    </message>
</context>
<context>
    <name>video.picture_not_packed</name>
    <message>
        <source>it could not be compressed</source>
        <translation>elle n’a pas pu être compressée</translation>
    </message>
</context>
<context>
    <name>video.pictures_too_large</name>
    <message>
        <source>its frames have more than 100 megapixels or 32000 pixels a side</source>
        <translation>ses images ont plus de 100 mégapixels ou 32000 pixels de côté</translation>
    </message>
</context>
<context>
    <name>video.pixel_format_not_read</name>
    <message>
        <source>its pixel format %1 is not supported</source>
        <translation>son format de pixel %1 n’est pas lu</translation>
    </message>
</context>
<context>
    <name>video.put_into_mp4</name>
    <message>
        <source>put each file into MP4 first, e.g. ffmpeg -i FILE -c copy NEW.mp4</source>
        <translation>mettez d’abord chaque fichier en MP4, p. ex. ffmpeg -i FILE -c copy NEW.mp4</translation>
    </message>
</context>
<context>
    <name>video.rate_not_positive</name>
    <message>
        <source>its frame rate is not positive</source>
        <translation>sa cadence d’images n’est pas positive</translation>
    </message>
</context>
<context>
    <name>video.rate_varies</name>
    <message>
        <source>its frame rate varies: frames are %1 to %2 apart</source>
        <translation>sa cadence varie, les images sont espacées de %1 à %2</translation>
    </message>
</context>
<context>
    <name>video.reading_chapter</name>
    <message>
        <source>reading &apos;%1&apos;</source>
        <translation>lecture de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>video.record_with_sound</name>
    <message>
        <source>switch the camera&apos;s sound on</source>
        <translation>activez le son de la caméra</translation>
    </message>
</context>
<context>
    <name>video.report_bug</name>
    <message>
        <source>report this as a bug</source>
        <translation>signalez-le comme un bogue</translation>
    </message>
</context>
<context>
    <name>video.siting_not_set</name>
    <message>
        <source>the chroma siting could not be set (%1)</source>
        <translation>la position de la chrominance n’a pas pu être fixée (%1)</translation>
    </message>
</context>
<context>
    <name>video.size_not_found</name>
    <message>
        <source>its frame size could not be determined</source>
        <translation>la taille de ses images n’a pas pu être trouvée</translation>
    </message>
</context>
<context>
    <name>video.sound_left_out</name>
    <message>
        <source>the sound was left out, because the files it is joined with have none or another kind of it</source>
        <translation>le son a été omis, car les fichiers auxquels il est réuni n’en ont pas ou en ont d’une autre sorte</translation>
    </message>
</context>
<context>
    <name>video.sound_part_used</name>
    <message>
        <source>its undamaged part is used</source>
        <translation>la partie intacte est utilisée</translation>
    </message>
</context>
<context>
    <name>video.sound_too_long</name>
    <message>
        <source>its sound is longer than %1</source>
        <translation>son son dure plus de %1</translation>
    </message>
</context>
<context>
    <name>video.stamps_repeat</name>
    <message>
        <source>their time stamps repeat that of the frame before</source>
        <translation>leurs horodatages répètent celui de l’image précédente</translation>
    </message>
</context>
<context>
    <name>video.stamps_span</name>
    <message>
        <source>its time stamps span %1</source>
        <translation>ses horodatages couvrent %1</translation>
    </message>
</context>
<context>
    <name>video.start_it_again</name>
    <message>
        <source>start it again</source>
        <translation>recommencez-la</translation>
    </message>
</context>
<context>
    <name>video.start_video_again</name>
    <message>
        <source>start the video again</source>
        <translation>recommencez la vidéo</translation>
    </message>
</context>
<context>
    <name>video.taking_image</name>
    <message>
        <source>taking image %1 of %2</source>
        <translation>prise de l’image %1 sur %2</translation>
    </message>
</context>
<context>
    <name>video.time_not_after</name>
    <message>
        <source>its time is not later than that of the frame before</source>
        <translation>son temps ne suit pas celui de l’image précédente</translation>
    </message>
</context>
<context>
    <name>video.unknown_format_not_read</name>
    <message>
        <source>its pixel format (unknown) is not supported</source>
        <translation>son format de pixel (inconnu) n’est pas lu</translation>
    </message>
</context>
<context>
    <name>video.use_another_picture</name>
    <message>
        <source>use another image</source>
        <translation>utilisez une autre image</translation>
    </message>
</context>
<context>
    <name>video.use_mjpeg</name>
    <message>
        <source>use MJPEG or FFV1, or another size</source>
        <translation>utilisez MJPEG ou FFV1, ou une autre taille</translation>
    </message>
</context>
<context>
    <name>video.use_mkv</name>
    <message>
        <source>use the ending .mkv</source>
        <translation>utilisez l’extension .mkv</translation>
    </message>
</context>
<context>
    <name>video.use_other_chroma</name>
    <message>
        <source>use 4:2:0, 4:2:2 or 4:4:4</source>
        <translation>utilisez 4:2:0, 4:2:2 ou 4:4:4</translation>
    </message>
</context>
<context>
    <name>video.write_at_least_one</name>
    <message>
        <source>write at least one</source>
        <translation>écrivez-en au moins une</translation>
    </message>
</context>
<context>
    <name>video.write_in_order</name>
    <message>
        <source>write the frames in order, at least a microsecond apart</source>
        <translation>écrivez les images dans l’ordre, à une microseconde au moins l’une de l’autre</translation>
    </message>
</context>
<context>
    <name>video.write_one_format</name>
    <message>
        <source>write one format to a file</source>
        <translation>écrivez un seul format par fichier</translation>
    </message>
</context>
<context>
    <name>workflow.accept_results</name>
    <message>
        <source>accept the results of %1</source>
        <translation>accepter les résultats de %1</translation>
    </message>
</context>
<context>
    <name>workflow.accuracy_given</name>
    <message>
        <source>accurate to %1, as given</source>
        <translation>exact à %1, comme indiqué</translation>
    </message>
</context>
<context>
    <name>workflow.add_layout_of_mat</name>
    <message>
        <source>add layout %1</source>
        <translation>ajouter le plan %1</translation>
    </message>
</context>
<context>
    <name>workflow.add_robot</name>
    <message>
        <source>add one with: odograph robot add PROJECT NAME --colour #rrggbb</source>
        <translation>ajoutez-en un dans Banc</translation>
    </message>
</context>
<context>
    <name>workflow.added_with_colour</name>
    <message>
        <source>it was added with the colour %1</source>
        <translation>il a été ajouté avec la couleur %1</translation>
    </message>
</context>
<context>
    <name>workflow.address_of_live_positions</name>
    <message>
        <source>address &apos;%1&apos; of live positions</source>
        <translation>adresse &apos;%1&apos; des positions en direct</translation>
    </message>
</context>
<context>
    <name>workflow.analyse_it_again</name>
    <message>
        <source>reanalyse it</source>
        <translation>le réanalyser</translation>
    </message>
</context>
<context>
    <name>workflow.analysing</name>
    <message>
        <source>analysing</source>
        <translation>analyse</translation>
    </message>
</context>
<context>
    <name>workflow.analysing_robot</name>
    <message>
        <source>analysing %1</source>
        <translation>analyse de %1</translation>
    </message>
</context>
<context>
    <name>workflow.another_picture_size</name>
    <message>
        <source>its frames are %1, but the camera was registered at %2</source>
        <translation>ses images sont en %1, mais la caméra a été localisée en %2</translation>
    </message>
</context>
<context>
    <name>workflow.assumed_lens</name>
    <message>
        <source>its lens was neither calibrated nor determined by the floor&apos;s markers</source>
        <translation>son objectif n’a été ni étalonné ni déterminé par les marqueurs du sol</translation>
    </message>
</context>
<context>
    <name>workflow.bad_is_not_accepted</name>
    <message>
        <source>bad results cannot be accepted (%1)</source>
        <translation>les résultats mauvais ne peuvent pas être acceptés (%1)</translation>
    </message>
</context>
<context>
    <name>workflow.beyond_limits</name>
    <message>
        <source>%1 of the samples exceed the limits of task &apos;%2&apos;, so the limits were ignored</source>
        <translation>%1 des mesures dépassent les limites de l’épreuve &apos;%2&apos;, qui ont donc été ignorées</translation>
    </message>
</context>
<context>
    <name>workflow.board_in_no_picture</name>
    <message>
        <source>the board was found in none of %1 images (%2)</source>
        <translation>la mire n’a été trouvée dans aucune des %1 photos (%2)</translation>
    </message>
</context>
<context>
    <name>workflow.box_stands_in</name>
    <message>
        <source>the project has none, so a blue box of 260 mm × 190 mm × 60 mm is simulated</source>
        <translation>le projet n’en a aucun, un pavé bleu de 260 mm × 190 mm × 60 mm est donc simulé</translation>
    </message>
</context>
<context>
    <name>workflow.by_layout_and_lens</name>
    <message>
        <source>layout &apos;%1&apos;, lens calibration %2</source>
        <translation>plan &apos;%1&apos;, objectif de l’étalonnage %2</translation>
    </message>
</context>
<context>
    <name>workflow.by_layout_without_lens</name>
    <message>
        <source>layout &apos;%1&apos;, lens not calibrated</source>
        <translation>plan &apos;%1&apos;, objectif non étalonné</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_and_reanalyse</name>
    <message>
        <source>calibrate the lens, register the camera again and reanalyse</source>
        <translation>étalonnez l&apos;objectif, localisez de nouveau la caméra et relancez l&apos;analyse</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_at_its_size</name>
    <message>
        <source>calibrate it at the size it records.</source>
        <translation>étalonnez-la à la taille à laquelle elle filme.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_camera</name>
    <message>
        <source>calibrate camera %1</source>
        <translation>étalonnage de la caméra %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_if_touched</name>
    <message>
        <source>if zoom, focus or the camera&apos;s settings have changed since, calibrate it again.</source>
        <translation>si le zoom, la mise au point ou les réglages de la caméra ont changé depuis, étalonnez-la à nouveau.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_it</name>
    <message>
        <source>calibrate it.</source>
        <translation>étalonnez-le.</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_lens_first</name>
    <message>
        <source>calibrate the lens first, or choose another calibration</source>
        <translation>étalonnez d’abord l’objectif, ou mettez un autre étalonnage en vigueur</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_or_give_picture</name>
    <message>
        <source>calibrate it, import its intrinsics, or give an image or a video as well</source>
        <translation>l’étalonner, importer ses paramètres intrinsèques, ou donner aussi une image ou une vidéo</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_or_import_trial</name>
    <message>
        <source>calibrate it, import its intrinsics, or import a trial with it first</source>
        <translation>étalonnez-la, importez ses paramètres intrinsèques, ou importez d’abord un essai avec elle</translation>
    </message>
</context>
<context>
    <name>workflow.calibrate_pair</name>
    <message>
        <source>calibrate cameras %1 and %2 as a pair</source>
        <translation>étalonnage des caméras %1 et %2 comme paire</translation>
    </message>
</context>
<context>
    <name>workflow.calibrated_from_pictures</name>
    <message>
        <source>calibrated from %1 images</source>
        <translation>étalonné d’après %1 photos</translation>
    </message>
</context>
<context>
    <name>workflow.calibrating_camera</name>
    <message>
        <source>calibrating camera %1</source>
        <translation>étalonnage de la caméra %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibration</name>
    <message>
        <source>calibration %1</source>
        <translation>étalonnage %1</translation>
    </message>
</context>
<context>
    <name>workflow.calibration_of_camera</name>
    <message>
        <source>calibration of camera &apos;%1&apos;</source>
        <translation>étalonnage de la caméra &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.calibration_picture</name>
    <message>
        <source>calibration image &apos;%1&apos;</source>
        <translation>photo d’étalonnage &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.camera</name>
    <message>
        <source>camera &apos;%1&apos;</source>
        <translation>caméra &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.camera_gave_no_picture</name>
    <message>
        <source>camera &apos;%1&apos; delivered no frame</source>
        <translation>la caméra &apos;%1&apos; n’a donné aucune image</translation>
    </message>
</context>
<context>
    <name>workflow.camera_given_twice</name>
    <message>
        <source>camera &apos;%1&apos; or its address &apos;%2&apos; was given twice</source>
        <translation>la caméra &apos;%1&apos; ou son adresse &apos;%2&apos; a été donnée deux fois</translation>
    </message>
</context>
<context>
    <name>workflow.camera_given_two_videos</name>
    <message>
        <source>camera &apos;%1&apos; was given two videos</source>
        <translation>deux vidéos ont été données pour la caméra &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.camera_moved_during</name>
    <message>
        <source>the camera moved by %1 after %2; what it saw from then on was not measured</source>
        <translation>la caméra a bougé de %1 après %2 ; ce qu&apos;elle a vu ensuite n&apos;a pas été mesuré</translation>
    </message>
</context>
<context>
    <name>workflow.camera_not_on_floor</name>
    <message>
        <source>camera &apos;%1&apos; is not registered to the floor</source>
        <translation>la caméra &apos;%1&apos; n’est pas localisée par rapport au sol</translation>
    </message>
</context>
<context>
    <name>workflow.camera_not_registered</name>
    <message>
        <source>camera &apos;%1&apos; is not registered</source>
        <translation>la caméra &apos;%1&apos; n’est pas localisée</translation>
    </message>
</context>
<context>
    <name>workflow.camera_sees_too_little</name>
    <message>
        <source>the camera sees too little of the floor between the markers for a run</source>
        <translation>la caméra voit trop peu de sol entre les repères pour un passage</translation>
    </message>
</context>
<context>
    <name>workflow.cameras_given_one_file</name>
    <message>
        <source>cameras &apos;%1&apos; and &apos;%2&apos; were given the same file, &apos;%3&apos;</source>
        <translation>les caméras « %1 » et « %2 » ont reçu le même fichier, « %3 »</translation>
    </message>
</context>
<context>
    <name>workflow.cameras_share_too_little</name>
    <message>
        <source>no two cameras share enough of the floor between the markers for a run</source>
        <translation>aucune paire de caméras ne partage assez de sol entre les repères pour un passage</translation>
    </message>
</context>
<context>
    <name>workflow.cause_camera_moved</name>
    <message>
        <source>camera %1 seems to have moved by %2 since its registration</source>
        <translation>la caméra %1 semble avoir bougé de %2 depuis sa localisation</translation>
    </message>
</context>
<context>
    <name>workflow.cause_camera_moved_at</name>
    <message>
        <source>camera %1 seems to have moved by %2 at %3</source>
        <translation>la caméra %1 semble avoir bougé de %2 à %3</translation>
    </message>
</context>
<context>
    <name>workflow.cause_cameras_moved</name>
    <message>
        <source>cameras %1 and %2 seem to have moved since their registration</source>
        <translation>les caméras %1 et %2 semblent avoir bougé depuis leur localisation</translation>
    </message>
</context>
<context>
    <name>workflow.cause_clock_rate</name>
    <message>
        <source>the time offset of view %1 seems to change by %2 in each second</source>
        <translation>le décalage temporel de la vue %1 semble changer de %2 chaque seconde</translation>
    </message>
</context>
<context>
    <name>workflow.cause_height</name>
    <message>
        <source>the height given for the robot seems wrong by about %1</source>
        <translation>la hauteur indiquée du robot semble fausse d&apos;environ %1</translation>
    </message>
</context>
<context>
    <name>workflow.cause_offset</name>
    <message>
        <source>the time offset of view %1 seems wrong by %2</source>
        <translation>le décalage temporel de la vue %1 semble faux de %2</translation>
    </message>
</context>
<context>
    <name>workflow.cause_or_cause</name>
    <message>
        <source>%1, or %2</source>
        <translation>%1, ou %2</translation>
    </message>
</context>
<context>
    <name>workflow.certificate</name>
    <message>
        <source>certificate</source>
        <translation>certificat</translation>
    </message>
</context>
<context>
    <name>workflow.change_guidance</name>
    <message>
        <source>change the guidance of %1</source>
        <translation>modification des indications de %1</translation>
    </message>
</context>
<context>
    <name>workflow.changed_in_file</name>
    <message>
        <source>they were changed in the file</source>
        <translation>ils ont été modifiés dans le fichier</translation>
    </message>
</context>
<context>
    <name>workflow.chapter_missing</name>
    <message>
        <source>by their names a file is missing between &apos;%1&apos; and &apos;%2&apos;; if so, all times behind it are wrong</source>
        <translation>d’après leurs noms, il manque un fichier entre &apos;%1&apos; et &apos;%2&apos; ; si c’est le cas, tous les temps qui suivent sont faux</translation>
    </message>
</context>
<context>
    <name>workflow.chapter_twice</name>
    <message>
        <source>&apos;%1&apos; is given twice</source>
        <translation>&apos;%1&apos; est indiqué deux fois</translation>
    </message>
</context>
<context>
    <name>workflow.chapters_out_of_order</name>
    <message>
        <source>by their names &apos;%1&apos; comes before &apos;%2&apos;, and was joined behind it; check the order of the files</source>
        <translation>d’après leurs noms, &apos;%1&apos; vient avant &apos;%2&apos; et a été placé derrière ; vérifiez l’ordre des fichiers</translation>
    </message>
</context>
<context>
    <name>workflow.check_cable_and_bandwidth</name>
    <message>
        <source>check the cable, the bandwidth and what else this computer is doing</source>
        <translation>vérifiez le câble, la bande passante et ce que fait d’autre cet ordinateur</translation>
    </message>
</context>
<context>
    <name>workflow.check_files_and_offset</name>
    <message>
        <source>check the files and the --sync offset</source>
        <translation>vérifiez les fichiers et le décalage</translation>
    </message>
</context>
<context>
    <name>workflow.check_it_is_connected</name>
    <message>
        <source>check that it is connected and not used by another program</source>
        <translation>vérifiez qu’elle est branchée et qu’aucun autre programme ne l’utilise</translation>
    </message>
</context>
<context>
    <name>workflow.check_its_cable</name>
    <message>
        <source>check its cable, and whether another program uses it</source>
        <translation>vérifiez son câble, et si un autre programme l’utilise</translation>
    </message>
</context>
<context>
    <name>workflow.check_line_is</name>
    <message>
        <source>its check line is 1000 or 200 mm long; no print is off by so much</source>
        <translation>sa ligne de contrôle fait 1000 ou 200 mm ; aucune impression ne s’en écarte autant</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_analyse_again</name>
    <message>
        <source>run odograph check, or reanalyse the trial</source>
        <translation>vérifiez le projet, ou analysez de nouveau l’essai</translation>
    </message>
</context>
<context>
    <name>workflow.check_or_register_again</name>
    <message>
        <source>check that the camera has not moved, or register it again.</source>
        <translation>vérifiez que la caméra n’a pas bougé, ou localisez-la à nouveau.</translation>
    </message>
</context>
<context>
    <name>workflow.check_rate</name>
    <message>
        <source>views are matched by time: check --rate if one is in slow motion</source>
        <translation>les vues sont réunies par le temps&#xa0;; vérifiez la cadence réelle si l’une est au ralenti</translation>
    </message>
</context>
<context>
    <name>workflow.check_robot_and_registration</name>
    <message>
        <source>check the robot&apos;s colour and size, and the registrations</source>
        <translation>vérifiez la couleur et la taille du robot, et les localisations</translation>
    </message>
</context>
<context>
    <name>workflow.check_they_are_connected</name>
    <message>
        <source>check that they are connected and not used by another program</source>
        <translation>vérifiez qu’elles sont branchées et qu’aucun autre programme ne les utilise</translation>
    </message>
</context>
<context>
    <name>workflow.check_views_of_one_run</name>
    <message>
        <source>only one view measures the rest, so check that both belong to one run</source>
        <translation>en dehors, une seule vue mesure&#xa0;; vérifiez que les deux sont du même passage</translation>
    </message>
</context>
<context>
    <name>workflow.check_whether_moved</name>
    <message>
        <source>check whether camera %1 has moved</source>
        <translation>vérification du déplacement de la caméra %1</translation>
    </message>
</context>
<context>
    <name>workflow.checking_trials</name>
    <message>
        <source>checks of the trials</source>
        <translation>contrôle des essais</translation>
    </message>
</context>
<context>
    <name>workflow.choose_another_one</name>
    <message>
        <source>choose another one</source>
        <translation>choisissez-en un autre</translation>
    </message>
</context>
<context>
    <name>workflow.choose_calibration</name>
    <message>
        <source>choose calibration %1 of camera %2</source>
        <translation>choix de l’étalonnage %1 de la caméra %2</translation>
    </message>
</context>
<context>
    <name>workflow.choose_folder_for_demo</name>
    <message>
        <source>choose a folder you can write to, with 300 MB free</source>
        <translation>choisissez un dossier où vous pouvez écrire, avec 300 Mo libres</translation>
    </message>
</context>
<context>
    <name>workflow.choose_folder_of_copies</name>
    <message>
        <source>choose the folder where they were copied to</source>
        <translation>choisissez le dossier où elles ont été copiées</translation>
    </message>
</context>
<context>
    <name>workflow.choose_frame</name>
    <message>
        <source>choose one from %1 to %2</source>
        <translation>choisissez-en une de %1 à %2</translation>
    </message>
</context>
<context>
    <name>workflow.choose_interface</name>
    <message>
        <source>choose one that `ip link` lists, or lo to stay on this computer</source>
        <translation>choisissez-en une que `ip link` nomme, ou lo pour rester sur cet ordinateur</translation>
    </message>
</context>
<context>
    <name>workflow.choose_measured_frame</name>
    <message>
        <source>choose a frame with a measurement</source>
        <translation>choisissez une image avec une mesure</translation>
    </message>
</context>
<context>
    <name>workflow.choose_metric</name>
    <message>
        <source>choose from %1</source>
        <translation>choisissez parmi %1</translation>
    </message>
</context>
<context>
    <name>workflow.choose_one_of_them</name>
    <message>
        <source>choose one of them</source>
        <translation>choisissez-en un</translation>
    </message>
</context>
<context>
    <name>workflow.choose_other_group</name>
    <message>
        <source>choose other times or another reason</source>
        <translation>choisissez d’autres temps ou une autre raison</translation>
    </message>
</context>
<context>
    <name>workflow.choose_other_range</name>
    <message>
        <source>choose another range</source>
        <translation>choisissez une autre plage</translation>
    </message>
</context>
<context>
    <name>workflow.choose_range_within</name>
    <message>
        <source>choose a range from 0 to %1</source>
        <translation>choisissez une plage de 0 à %1</translation>
    </message>
</context>
<context>
    <name>workflow.choose_registration</name>
    <message>
        <source>choose registration %1 of camera %2</source>
        <translation>choix de la localisation %1 de la caméra %2</translation>
    </message>
</context>
<context>
    <name>workflow.choose_robot_of_trial</name>
    <message>
        <source>choose a robot of the trial</source>
        <translation>choisissez un robot de l’essai</translation>
    </message>
</context>
<context>
    <name>workflow.choose_run_on_layout</name>
    <message>
        <source>choose a run on the same layout</source>
        <translation>choisir un essai sur la même disposition</translation>
    </message>
</context>
<context>
    <name>workflow.choose_seen_task</name>
    <message>
        <source>choose a task on the floor that they see, or leave the task out</source>
        <translation>choisissez une épreuve sur le sol qu’elles voient, ou n’en indiquez aucune</translation>
    </message>
</context>
<context>
    <name>workflow.choose_task_with_course</name>
    <message>
        <source>choose a task that has, or leave the task out</source>
        <translation>choisissez une épreuve qui en a, ou n’en indiquez aucune</translation>
    </message>
</context>
<context>
    <name>workflow.choose_time</name>
    <message>
        <source>choose a time from %1 to %2</source>
        <translation>choisissez un temps de %1 à %2</translation>
    </message>
</context>
<context>
    <name>workflow.choose_trial_of_views</name>
    <message>
        <source>choose a trial of two views or more</source>
        <translation>choisissez un essai de deux vues ou plus</translation>
    </message>
</context>
<context>
    <name>workflow.choose_with_robot</name>
    <message>
        <source>choose one with --robot</source>
        <translation>choisissez-en un</translation>
    </message>
</context>
<context>
    <name>workflow.class_without_team</name>
    <message>
        <source>without a team it belongs to no class</source>
        <translation>sans équipe, il n’appartient à aucune classe</translation>
    </message>
</context>
<context>
    <name>workflow.clear_range</name>
    <message>
        <source>remove the range of %1</source>
        <translation>suppression de la plage de %1</translation>
    </message>
</context>
<context>
    <name>workflow.clock_jumped</name>
    <message>
        <source>at %1 the clock jumped ahead by %2; later times were corrected</source>
        <translation>à %1, l’horloge a sauté de %2 en avant ; les temps suivants ont été corrigés</translation>
    </message>
</context>
<context>
    <name>workflow.clock_restarts</name>
    <message>
        <source>its time stamps begin again or stand still after %1: two files were joined, or the camera&apos;s clock was reset</source>
        <translation>ses horodatages recommencent ou s&apos;arrêtent après %1 : deux fichiers ont été réunis, ou l&apos;horloge de la caméra a été remise à zéro</translation>
    </message>
</context>
<context>
    <name>workflow.clocks_differ</name>
    <message>
        <source>the clocks of views &apos;%1&apos; and &apos;%2&apos; differ by %3; speeds and times are by the clock of view &apos;%1&apos;</source>
        <translation>les horloges des vues « %1 » et « %2 » diffèrent de %3 ; vitesses et temps suivent l’horloge de la vue « %1 »</translation>
    </message>
</context>
<context>
    <name>workflow.compared_with_itself</name>
    <message>
        <source>a run cannot be compared with itself</source>
        <translation>un passage ne peut pas être comparé à lui-même</translation>
    </message>
</context>
<context>
    <name>workflow.comparison_of_trial</name>
    <message>
        <source>comparison of trial &apos;%1&apos;</source>
        <translation>comparaison de l’essai &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.complete_trial</name>
    <message>
        <source>complete %1, whose recording was cut off</source>
        <translation>achèvement de %1, dont l’enregistrement a été interrompu</translation>
    </message>
</context>
<context>
    <name>workflow.completing_recording</name>
    <message>
        <source>completing a recording that was cut off</source>
        <translation>un enregistrement interrompu est complété</translation>
    </message>
</context>
<context>
    <name>workflow.completing_recordings</name>
    <message>
        <source>completing the recordings</source>
        <translation>compléter les enregistrements</translation>
    </message>
</context>
<context>
    <name>workflow.computing_intrinsics</name>
    <message>
        <source>computing the intrinsics</source>
        <translation>calcul des paramètres intrinsèques</translation>
    </message>
</context>
<context>
    <name>workflow.computing_pair</name>
    <message>
        <source>computing the relative position</source>
        <translation>calcul de la position relative</translation>
    </message>
</context>
<context>
    <name>workflow.copied_while_recorded</name>
    <message>
        <source>its recording has not ended</source>
        <translation>son enregistrement n’est pas terminé</translation>
    </message>
</context>
<context>
    <name>workflow.copy_file_again</name>
    <message>
        <source>copy the file from the camera again</source>
        <translation>copiez de nouveau le fichier depuis la caméra</translation>
    </message>
</context>
<context>
    <name>workflow.copy_of</name>
    <message>
        <source>copy of &apos;%1&apos;</source>
        <translation>copie de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.copy_trial</name>
    <message>
        <source>copy trial %1 to %2</source>
        <translation>essai %1 copié en %2</translation>
    </message>
</context>
<context>
    <name>workflow.copying_project</name>
    <message>
        <source>copying the project</source>
        <translation>copie du projet</translation>
    </message>
</context>
<context>
    <name>workflow.corner_off_frame</name>
    <message>
        <source>a corner is outside the frame</source>
        <translation>un coin est hors de l’image</translation>
    </message>
</context>
<context>
    <name>workflow.correct_by_hand</name>
    <message>
        <source>correct %1 by hand</source>
        <translation>correction de %1 à la main</translation>
    </message>
</context>
<context>
    <name>workflow.course_not_seen</name>
    <message>
        <source>the cameras see only %1 of the course of task &apos;%2&apos;</source>
        <translation>les caméras ne voient que&#xa0;%1 du parcours de l’épreuve &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.course_of_task</name>
    <message>
        <source>course of task &apos;%1&apos;</source>
        <translation>parcours de l’épreuve &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.course_seen_in_part</name>
    <message>
        <source>no camera sees %1 of the run whole</source>
        <translation>aucune caméra ne voit en entier&#xa0;%1 du passage</translation>
    </message>
</context>
<context>
    <name>workflow.cut_at_restart</name>
    <message>
        <source>cut it there, and import each part as its own trial</source>
        <translation>coupez-le à cet endroit et importez chaque partie comme un essai distinct</translation>
    </message>
</context>
<context>
    <name>workflow.damaged_frames</name>
    <message>
        <source>%1 of its %2 frames, from %3 to %4, are damaged and were not measured</source>
        <translation>%1 de ses %2 images, de %3 à %4, sont endommagées et n&apos;ont pas été mesurées</translation>
    </message>
</context>
<context>
    <name>workflow.date_to_come</name>
    <message>
        <source>its new date is in the future</source>
        <translation>sa nouvelle date est dans le futur</translation>
    </message>
</context>
<context>
    <name>workflow.demo</name>
    <message>
        <source>demo</source>
        <translation>démo</translation>
    </message>
</context>
<context>
    <name>workflow.demo_in</name>
    <message>
        <source>demo in &apos;%1&apos;</source>
        <translation>démo dans &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.demo_is_there</name>
    <message>
        <source>%1 already exists</source>
        <translation>%1 existe déjà</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_name</name>
    <message>
        <source>from %1 to %2 this may be %3 or %4</source>
        <translation>de %1 à %2, il n’est pas sûr qu’il s’agisse de %3 ou de %4</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_name_unknown</name>
    <message>
        <source>from %1 to %2 this may be %3 or another robot that looks the same</source>
        <translation>de %1 à %2, il n’est pas sûr qu’il s’agisse de %3 ou d’un autre robot de même apparence</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_names</name>
    <message>
        <source>from %1 to %2 (the first of %3 times) this may be %4 or %5</source>
        <translation>de %1 à %2 (la première de %3 fois), il n’est pas sûr qu’il s’agisse de %4 ou de %5</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_names_unknown</name>
    <message>
        <source>from %1 to %2 (the first of %3 times) this may be %4 or another robot that looks the same</source>
        <translation>de %1 à %2 (la première de %3 fois), il n’est pas sûr qu’il s’agisse de %4 ou d’un autre robot de même apparence</translation>
    </message>
</context>
<context>
    <name>workflow.doubtful_step</name>
    <message>
        <source>it is synchronised only to %1, which is %2 at 1 m/s</source>
        <translation>elle n’est synchronisée qu’à %1 près, soit %2 à 1 m/s</translation>
    </message>
</context>
<context>
    <name>workflow.edit_trial</name>
    <message>
        <source>edit trial %1</source>
        <translation>modification de l’essai %1</translation>
    </message>
</context>
<context>
    <name>workflow.edit_trials</name>
    <message>
        <source>edit %1 trials</source>
        <translation>modification de %1 essais</translation>
    </message>
</context>
<context>
    <name>workflow.error_estimated</name>
    <message>
        <source>positions to %1, estimated from the track</source>
        <translation>positions à %1, estimé d’après elles</translation>
    </message>
</context>
<context>
    <name>workflow.error_stated</name>
    <message>
        <source>positions to %1, as stated in the file</source>
        <translation>positions à %1, d’après le fichier</translation>
    </message>
</context>
<context>
    <name>workflow.evaluation_of_trial</name>
    <message>
        <source>evaluation of trial &apos;%1&apos;</source>
        <translation>évaluation de l’essai &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.export</name>
    <message>
        <source>export of &apos;%1&apos;</source>
        <translation>export de &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.faster_disk_or_fewer_cameras</name>
    <message>
        <source>record to a faster disk, or fewer cameras at once</source>
        <translation>enregistrez sur un disque plus rapide, ou avec moins de caméras à la fois</translation>
    </message>
</context>
<context>
    <name>workflow.file_given_twice</name>
    <message>
        <source>&apos;%1&apos; is given twice</source>
        <translation>« %1 » est donné deux fois</translation>
    </message>
</context>
<context>
    <name>workflow.file_of_another_size</name>
    <message>
        <source>its file has %1 bytes, but had %2 when it was added</source>
        <translation>son fichier a %1 octets, mais en avait %2 lors de l&apos;ajout</translation>
    </message>
</context>
<context>
    <name>workflow.file_of_other_content</name>
    <message>
        <source>its file has changed since it was added</source>
        <translation>son fichier a changé depuis l&apos;ajout</translation>
    </message>
</context>
<context>
    <name>workflow.file_without_picture</name>
    <message>
        <source>it contains no image</source>
        <translation>aucune image n’y est</translation>
    </message>
</context>
<context>
    <name>workflow.film_progressive</name>
    <message>
        <source>choose a progressive mode of the camera (p, not i)</source>
        <translation>choisissez un mode progressif de la caméra (p et non i)</translation>
    </message>
</context>
<context>
    <name>workflow.filmed_at_doubtful_rate</name>
    <message>
        <source>its file says that it was filmed at %1, but its time stamps mean %2</source>
        <translation>son fichier indique qu’elle a été filmée à %1, mais ses horodatages signifient %2</translation>
    </message>
</context>
<context>
    <name>workflow.filmed_at_rate</name>
    <message>
        <source>it was filmed at %1, as its file says, and plays at %2; its times are those of filming</source>
        <translation>d’après son fichier, elle a été filmée à %1 et est lue à %2 ; ses temps sont ceux de la prise de vue</translation>
    </message>
</context>
<context>
    <name>workflow.first_label_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2, its file says %3, so speeds and times are wrong by %4</source>
        <translation>la vue « %1 » a été enregistrée à %2, son fichier indique %3 ; vitesses et temps sont donc faux de %4</translation>
    </message>
</context>
<context>
    <name>workflow.fitting_cameras_together</name>
    <message>
        <source>fitting %1 cameras jointly</source>
        <translation>ajustement de %1 caméras ensemble</translation>
    </message>
</context>
<context>
    <name>workflow.fix_camera</name>
    <message>
        <source>fix the camera, register it again and repeat the run</source>
        <translation>fixez la caméra, localisez-la de nouveau et refaites la course</translation>
    </message>
</context>
<context>
    <name>workflow.floor_has_its_colour</name>
    <message>
        <source>its colour %1 is also the floor&apos;s (%2 of the frame in view %3)</source>
        <translation>sa couleur %1 est aussi celle du sol (%2 de l’image de la vue %3)</translation>
    </message>
</context>
<context>
    <name>workflow.floor_mat</name>
    <message>
        <source>floor mat</source>
        <translation>tapis de sol</translation>
    </message>
</context>
<context>
    <name>workflow.folder</name>
    <message>
        <source>folder &apos;%1&apos;</source>
        <translation>dossier &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.frame_of_file</name>
    <message>
        <source>frame %1 of &apos;%2&apos;</source>
        <translation>image %1 de &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.frame_of_trial</name>
    <message>
        <source>frame %1 of trial &apos;%2&apos;</source>
        <translation>image %1 de l’essai &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.frame_rate_of</name>
    <message>
        <source>frame rate of %1</source>
        <translation>cadence de&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>workflow.frames_doubled</name>
    <message>
        <source>up to %1 frames repeat for %2; later times were corrected</source>
        <translation>jusqu’à %1, des images se répètent pendant %2 ; les temps suivants ont été corrigés</translation>
    </message>
</context>
<context>
    <name>workflow.frames_doubled_unseen</name>
    <message>
        <source>after %1 %2 frames repeat the one before, and its time stamps count them as time; later times were corrected</source>
        <translation>après %1, %2 images répètent la précédente, et ses horodatages les comptent comme du temps ; les temps suivants ont été corrigés</translation>
    </message>
</context>
<context>
    <name>workflow.frames_frozen</name>
    <message>
        <source>after %1 %2 frames show the same image while the robot went on; they were not measured</source>
        <translation>après %1, %2 images montrent la même vue alors que le robot avançait ; elles n&apos;ont pas été mesurées</translation>
    </message>
</context>
<context>
    <name>workflow.frames_lost</name>
    <message>
        <source>after %1 the frames of %2 are missing, because the camera paused or lost them; later times were corrected</source>
        <translation>après %1, les images de %2 manquent, car la caméra a fait une pause ou les a perdues ; les temps suivants ont été corrigés</translation>
    </message>
</context>
<context>
    <name>workflow.frames_missing</name>
    <message>
        <source>%1 without a frame, where %2 is usual; frames are missing, or its time stamps jump</source>
        <translation>%1 sans image, au lieu de %2 d&apos;habitude ; des images manquent, ou les horodatages sautent</translation>
    </message>
</context>
<context>
    <name>workflow.frames_missing_unseen</name>
    <message>
        <source>after %1 %2 frames are missing that its time stamps do not show: the robot moves too far; later times were corrected</source>
        <translation>après %1, %2 images manquent sans que ses horodatages le montrent : le robot avance trop loin ; les temps suivants ont été corrigés</translation>
    </message>
</context>
<context>
    <name>workflow.frames_not_decoded</name>
    <message>
        <source>%1 of its %2 frames are damaged and were not measured</source>
        <translation>%1 de ses %2 images sont endommagées et n&apos;ont pas été mesurées</translation>
    </message>
</context>
<context>
    <name>workflow.frames_without_board</name>
    <message>
        <source>%1 frames: %2</source>
        <translation>%1 images vidéo : %2</translation>
    </message>
</context>
<context>
    <name>workflow.give_another_file</name>
    <message>
        <source>give another file</source>
        <translation>donnez un autre fichier</translation>
    </message>
</context>
<context>
    <name>workflow.give_another_team</name>
    <message>
        <source>give another team, or change the class of this one</source>
        <translation>indiquez une autre équipe, ou changez la classe de celle-ci</translation>
    </message>
</context>
<context>
    <name>workflow.give_camera_rate</name>
    <message>
        <source>give the rate at which the camera took the frames</source>
        <translation>indiquez la fréquence à laquelle la caméra a pris les images</translation>
    </message>
</context>
<context>
    <name>workflow.give_cameras</name>
    <message>
        <source>give one or more, like --camera A=sim:A</source>
        <translation>choisissez-en une ou plusieurs sous «&#xa0;Caméras…&#xa0;»</translation>
    </message>
</context>
<context>
    <name>workflow.give_chapter_once</name>
    <message>
        <source>give each file once, in their order</source>
        <translation>indiquez chaque fichier une fois, dans leur ordre</translation>
    </message>
</context>
<context>
    <name>workflow.give_class_too</name>
    <message>
        <source>give its class too, or another team</source>
        <translation>indiquez aussi sa classe, ou une autre équipe</translation>
    </message>
</context>
<context>
    <name>workflow.give_date_of_run</name>
    <message>
        <source>give the date of the run</source>
        <translation>indiquez la date du parcours</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_file_once</name>
    <message>
        <source>give each file once, to its camera</source>
        <translation>donnez chaque fichier une fois, avec sa caméra</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_frame_time</name>
    <message>
        <source>give one time for each frame</source>
        <translation>indiquez un temps pour chaque image</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_its_file</name>
    <message>
        <source>give each camera its own video</source>
        <translation>donnez à chaque caméra sa propre vidéo</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_robot_one</name>
    <message>
        <source>give each robot one</source>
        <translation>donnez-en une à chaque robot</translation>
    </message>
</context>
<context>
    <name>workflow.give_each_view_its_camera</name>
    <message>
        <source>give each view its own camera</source>
        <translation>donnez à chaque vue sa propre caméra</translation>
    </message>
</context>
<context>
    <name>workflow.give_height_below_camera</name>
    <message>
        <source>give a height below the camera</source>
        <translation>donnez une hauteur inférieure à celle de la caméra</translation>
    </message>
</context>
<context>
    <name>workflow.give_limits_of_fastest</name>
    <message>
        <source>give the task the limits of its fastest robot</source>
        <translation>donnez à l’épreuve les limites de son robot le plus rapide</translation>
    </message>
</context>
<context>
    <name>workflow.give_offset_for_each</name>
    <message>
        <source>give one offset for each view but the first, like --sync 0.1,0.2, or use --sync auto</source>
        <translation>donnez un décalage par vue sauf la première, ou choisissez «&#xa0;D’après le mouvement ou un éclair&#xa0;»</translation>
    </message>
</context>
<context>
    <name>workflow.give_one_table</name>
    <message>
        <source>give one table for each view</source>
        <translation>indiquez une table pour chaque vue</translation>
    </message>
</context>
<context>
    <name>workflow.give_own_colours</name>
    <message>
        <source>give each its own colour</source>
        <translation>donnez à chacun une couleur à lui</translation>
    </message>
</context>
<context>
    <name>workflow.give_picture_of_that_size</name>
    <message>
        <source>give an image of that size</source>
        <translation>donnez une image de cette taille</translation>
    </message>
</context>
<context>
    <name>workflow.give_pixels_or_picture</name>
    <message>
        <source>give the markers&apos; pixels, or an image or a video of the floor</source>
        <translation>donner les pixels des marqueurs, ou une image ou une vidéo du sol</translation>
    </message>
</context>
<context>
    <name>workflow.give_pre_roll</name>
    <message>
        <source>give a pre-roll of 0 to 10 seconds</source>
        <translation>donnez un pré-enregistrement de 0 à 10 secondes</translation>
    </message>
</context>
<context>
    <name>workflow.give_range_in_seconds</name>
    <message>
        <source>give its start and end in seconds</source>
        <translation>indiquez son début et sa fin en secondes</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_table</name>
    <message>
        <source>give one of them</source>
        <translation>indiquez l’un des deux</translation>
    </message>
</context>
<context>
    <name>workflow.give_rate_or_times</name>
    <message>
        <source>give their rate or a table of their times, like --rate 30 or --times A=stamps.csv</source>
        <translation>indiquez la fréquence réelle de la caméra</translation>
    </message>
</context>
<context>
    <name>workflow.give_seconds</name>
    <message>
        <source>give the seconds, such as 10</source>
        <translation>donnez les secondes, comme 10</translation>
    </message>
</context>
<context>
    <name>workflow.give_start_first</name>
    <message>
        <source>give the start first, then a later end</source>
        <translation>indiquez d’abord le début, puis une fin postérieure</translation>
    </message>
</context>
<context>
    <name>workflow.give_table_of_times</name>
    <message>
        <source>give a table of their times, like --times A=stamps.csv</source>
        <translation>numérotez-les de un en un</translation>
    </message>
</context>
<context>
    <name>workflow.give_task</name>
    <message>
        <source>give %1 the task %2</source>
        <translation>épreuve %2 donnée à %1</translation>
    </message>
</context>
<context>
    <name>workflow.give_team</name>
    <message>
        <source>assign %1 to team %2</source>
        <translation>%1 attribué à l’équipe %2</translation>
    </message>
</context>
<context>
    <name>workflow.give_team_too</name>
    <message>
        <source>give it a team too</source>
        <translation>indiquez aussi une équipe</translation>
    </message>
</context>
<context>
    <name>workflow.give_times_to_view</name>
    <message>
        <source>name the camera of one of the videos</source>
        <translation>indiquez la caméra de l’une des vidéos</translation>
    </message>
</context>
<context>
    <name>workflow.give_tracks</name>
    <message>
        <source>give one or more, like --track R=run.csv</source>
        <translation>choisissez-en une ou plusieurs</translation>
    </message>
</context>
<context>
    <name>workflow.give_views</name>
    <message>
        <source>give one view or more, like --video A=a.mp4</source>
        <translation>choisissez une vue ou plusieurs</translation>
    </message>
</context>
<context>
    <name>workflow.guidance_of_view</name>
    <message>
        <source>guidance in view &apos;%1&apos;</source>
        <translation>indications dans la vue « %1 »</translation>
    </message>
</context>
<context>
    <name>workflow.hardly_found</name>
    <message>
        <source>it found robot &apos;%1&apos; in only %2 of the frames in which it should be visible, and the other positions are not checked by a second view</source>
        <translation>elle n’a trouvé le robot &apos;%1&apos; que dans %2 des images où il devrait être visible, et aucune deuxième vue ne vérifie les autres positions</translation>
    </message>
</context>
<context>
    <name>workflow.hardly_possible</name>
    <message>
        <source>a robot hardly moves at %1 with %2; check units and scale</source>
        <translation>un robot ne se déplace guère à %1 avec %2 ; vérifiez les unités et l&apos;échelle</translation>
    </message>
</context>
<context>
    <name>workflow.has_no_two_views</name>
    <message>
        <source>it does not have two views</source>
        <translation>il n’a pas deux vues</translation>
    </message>
</context>
<context>
    <name>workflow.height_above_camera</name>
    <message>
        <source>it is only %1 above the floor, but the points would be at %2</source>
        <translation>elle n’est qu’à %1 au-dessus du sol, mais les points seraient à %2</translation>
    </message>
</context>
<context>
    <name>workflow.image_with_video</name>
    <message>
        <source>one is an image and the other a video</source>
        <translation>l’un est une image et l’autre une vidéo</translation>
    </message>
</context>
<context>
    <name>workflow.images</name>
    <message>
        <source>images &apos;%1&apos;</source>
        <translation>images &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.images_missing</name>
    <message>
        <source>missing numbers: %1, the first behind %2; their frames count as lost, and the others keep their times</source>
        <translation>numéros manquants : %1, le premier après %2 ; leurs images comptent comme perdues, et les autres gardent leurs temps</translation>
    </message>
</context>
<context>
    <name>workflow.images_share_number</name>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; have the same number</source>
        <translation>&apos;%1&apos; et &apos;%2&apos; ont le même numéro</translation>
    </message>
</context>
<context>
    <name>workflow.images_without_times</name>
    <message>
        <source>images have no times</source>
        <translation>les images n’ont pas de temps</translation>
    </message>
</context>
<context>
    <name>workflow.import_lens</name>
    <message>
        <source>import the lens calibration of camera %1 from %2</source>
        <translation>import de l’objectif de la caméra %1 depuis %2</translation>
    </message>
</context>
<context>
    <name>workflow.import_of_trial</name>
    <message>
        <source>import of trial &apos;%1&apos;</source>
        <translation>import de l’essai &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.import_roster</name>
    <message>
        <source>import the roster %1</source>
        <translation>import de la liste de classe %1</translation>
    </message>
</context>
<context>
    <name>workflow.import_to_turn</name>
    <message>
        <source>import the video again to measure it as it is shown</source>
        <translation>importez de nouveau la vidéo pour la mesurer telle qu’elle est affichée</translation>
    </message>
</context>
<context>
    <name>workflow.import_trial</name>
    <message>
        <source>import trial %1</source>
        <translation>import de l’essai %1</translation>
    </message>
</context>
<context>
    <name>workflow.import_trial_from</name>
    <message>
        <source>import trial %1 from %2</source>
        <translation>import de l’essai %1 depuis %2</translation>
    </message>
</context>
<context>
    <name>workflow.interface_of_live_positions</name>
    <message>
        <source>interface &apos;%1&apos; of live positions</source>
        <translation>interface &apos;%1&apos; des positions en direct</translation>
    </message>
</context>
<context>
    <name>workflow.interlaced</name>
    <message>
        <source>it is interlaced: each frame holds two fields taken one after the other, and each is measured at its own time, with half the lines</source>
        <translation>elle est entrelacée : chaque image contient deux trames prises l&apos;une après l&apos;autre, et chacune est mesurée à son propre instant, avec la moitié des lignes</translation>
    </message>
</context>
<context>
    <name>workflow.interlaced_whole</name>
    <message>
        <source>it is interlaced, but was measured by whole frames, of which each shows two moments; import it as a new trial to have each field measured at its own time</source>
        <translation>elle est entrelacée, mais a été mesurée par images entières, dont chacune montre deux instants ; importez-la comme un nouvel essai pour que chaque trame soit mesurée à son propre instant</translation>
    </message>
</context>
<context>
    <name>workflow.intrinsics_of_camera</name>
    <message>
        <source>intrinsics of camera &apos;%1&apos;</source>
        <translation>paramètres intrinsèques de la caméra &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.is_being_recorded</name>
    <message>
        <source>it is being recorded</source>
        <translation>il est en cours d’enregistrement</translation>
    </message>
</context>
<context>
    <name>workflow.join_or_name_camera</name>
    <message>
        <source>give each view a camera of its own, or join the files of one recording with +, like --video A=1.mp4+2.mp4</source>
        <translation>donnez à chaque vue sa propre caméra, ou réunissez les fichiers d’un enregistrement par +</translation>
    </message>
</context>
<context>
    <name>workflow.joined_videos</name>
    <message>
        <source>videos &apos;%1&apos;</source>
        <translation>vidéos &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.keeping_pictures</name>
    <message>
        <source>saving the images</source>
        <translation>conservation des photos</translation>
    </message>
</context>
<context>
    <name>workflow.label_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2, its file says %3</source>
        <translation>la vue « %1 » a été enregistrée à %2, son fichier indique %3</translation>
    </message>
</context>
<context>
    <name>workflow.labels_wrong</name>
    <message>
        <source>view &apos;%1&apos; was recorded at %2 (its file says %3), or view &apos;%4&apos; at %5 (its file says %6); speeds and times are by the file of view &apos;%4&apos;</source>
        <translation>la vue « %1 » a été enregistrée à %2 (son fichier indique %3), ou la vue « %4 » à %5 (son fichier indique %6) ; vitesses et temps suivent le fichier de la vue « %4 »</translation>
    </message>
</context>
<context>
    <name>workflow.leave_frame</name>
    <message>
        <source>remove the override of frame %1 of %2</source>
        <translation>image %1 de %2 laissée au programme</translation>
    </message>
</context>
<context>
    <name>workflow.leave_frames</name>
    <message>
        <source>remove the overrides of %1 samples of %2</source>
        <translation>retrait des corrections manuelles de %1 échantillons de %2</translation>
    </message>
</context>
<context>
    <name>workflow.leave_one_mat</name>
    <message>
        <source>leave one mat on the floor, and use newer files</source>
        <translation>laissez un seul tapis au sol et utilisez des fichiers plus récents</translation>
    </message>
</context>
<context>
    <name>workflow.leave_out_trial</name>
    <message>
        <source>remove %1, which recorded nothing</source>
        <translation>écart de %1, dont rien n’a été enregistré</translation>
    </message>
</context>
<context>
    <name>workflow.lens_at_other_size</name>
    <message>
        <source>its frames are %1, but the lens was calibrated at %2</source>
        <translation>ses images sont en %1, mais l’objectif a été étalonné en %2</translation>
    </message>
</context>
<context>
    <name>workflow.lens_cropped_columns</name>
    <message>
        <source>The lens calibration at %1 was cropped on both sides to %2, as the markers confirm.</source>
        <translation>L’étalonnage de l’objectif en %1 a été rogné des deux côtés en %2, comme les marqueurs le confirment.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_cropped_rows</name>
    <message>
        <source>The lens calibration at %1 was cropped above and below to %2, as the markers confirm.</source>
        <translation>L’étalonnage de l’objectif en %1 a été rogné en haut et en bas en %2, comme les marqueurs le confirment.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_enlarged</name>
    <message>
        <source>The lens calibration at %1 was fitted to %2 by the markers, which show that the image is enlarged by a factor of %3 (± %4).</source>
        <translation>L’étalonnage de l’objectif en %1 a été ajusté à %2 par les marqueurs, qui montrent que l’image est agrandie d’un facteur %3 (± %4).</translation>
    </message>
</context>
<context>
    <name>workflow.lens_imported_from</name>
    <message>
        <source>imported from %1</source>
        <translation>importé de %1</translation>
    </message>
</context>
<context>
    <name>workflow.lens_never_calibrated</name>
    <message>
        <source>The lens of camera &apos;%1&apos; is neither calibrated nor determined by the floor&apos;s markers</source>
        <translation>L’objectif de la caméra &apos;%1&apos; n’est ni étalonné ni déterminé par les marqueurs du sol</translation>
    </message>
</context>
<context>
    <name>workflow.lens_part_unknown</name>
    <message>
        <source>The lens calibration at %1 was cropped to %2, but the markers do not show whether the image is enlarged as well, so its focal length is known only to %3: calibrate the lens at %2, or use more markers.</source>
        <translation>L’étalonnage de l’objectif en %1 a été rogné en %2, mais les marqueurs ne montrent pas si l’image est aussi agrandie ; sa distance focale n’est donc connue qu’à %3 : étalonnez l’objectif en %2, ou utilisez plus de marqueurs.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_scaled</name>
    <message>
        <source>The lens calibration at %1 was converted to %2.</source>
        <translation>L’étalonnage de l’objectif en %1 a été converti en %2.</translation>
    </message>
</context>
<context>
    <name>workflow.lens_turned_either_way</name>
    <message>
        <source>Which way the camera was turned since is not known, so the centre of its images is less certain.</source>
        <translation>On ignore dans quel sens la caméra a été tournée depuis ; le centre de ses images est donc moins sûr.</translation>
    </message>
</context>
<context>
    <name>workflow.link_lost_video</name>
    <message>
        <source>link a lost video</source>
        <translation>reliure d’une vidéo perdue</translation>
    </message>
</context>
<context>
    <name>workflow.link_lost_videos</name>
    <message>
        <source>link %1 lost videos</source>
        <translation>reliure de %1 vidéos perdues</translation>
    </message>
</context>
<context>
    <name>workflow.little_common_time</name>
    <message>
        <source>%1 and %2 long, %3 in common</source>
        <translation>durées %1 et %2, dont %3 en commun</translation>
    </message>
</context>
<context>
    <name>workflow.live_positions_to</name>
    <message>
        <source>live positions to %1</source>
        <translation>positions en direct vers %1</translation>
    </message>
</context>
<context>
    <name>workflow.live_tracking</name>
    <message>
        <source>live tracking</source>
        <translation>suivi en direct</translation>
    </message>
</context>
<context>
    <name>workflow.look_at_outlines</name>
    <message>
        <source>check the outlines, and set the robot&apos;s colour or keep other objects out of view</source>
        <translation>regardez les contours, et indiquez la couleur du robot ou gardez les autres hors des images</translation>
    </message>
</context>
<context>
    <name>workflow.look_for_lost_videos</name>
    <message>
        <source>search for lost videos</source>
        <translation>chercher les vidéos perdues</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_board_in</name>
    <message>
        <source>detecting the board in %1</source>
        <translation>recherche de la mire dans %1</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_board_in_both</name>
    <message>
        <source>detecting the board in %1 and %2</source>
        <translation>recherche de la mire dans %1 et %2</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_files</name>
    <message>
        <source>searching for files</source>
        <translation>recherche de fichiers</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_markers_again</name>
    <message>
        <source>detecting the markers again</source>
        <translation>nouvelle recherche des marqueurs</translation>
    </message>
</context>
<context>
    <name>workflow.looking_for_markers_in</name>
    <message>
        <source>detecting the markers in %1</source>
        <translation>recherche des marqueurs dans %1</translation>
    </message>
</context>
<context>
    <name>workflow.looking_through_media</name>
    <message>
        <source>searching the media folder</source>
        <translation>examen du dossier des médias</translation>
    </message>
</context>
<context>
    <name>workflow.lost_not_packed</name>
    <message>
        <source>the video of camera %1 in trial &apos;%2&apos; is lost and is not in the packed project</source>
        <translation>la vidéo de la caméra %1 dans l’essai &apos;%2&apos; est perdue, et absente du projet empaqueté</translation>
    </message>
</context>
<context>
    <name>workflow.lost_video_not_there</name>
    <message>
        <source>the lost video is not in this folder</source>
        <translation>la vidéo perdue n’y est pas</translation>
    </message>
</context>
<context>
    <name>workflow.lost_videos</name>
    <message>
        <source>lost videos</source>
        <translation>vidéos perdues</translation>
    </message>
</context>
<context>
    <name>workflow.lost_videos_not_there</name>
    <message>
        <source>none of the %1 lost videos is in this folder</source>
        <translation>aucune des %1 vidéos perdues n’y est</translation>
    </message>
</context>
<context>
    <name>workflow.made_through_registration</name>
    <message>
        <source>It was made via registration %1 of the project.</source>
        <translation>Elle a été faite par la localisation %1 du projet.</translation>
    </message>
</context>
<context>
    <name>workflow.made_with_it_already</name>
    <message>
        <source>it already uses that calibration</source>
        <translation>elle a déjà été faite avec lui</translation>
    </message>
</context>
<context>
    <name>workflow.making_hash</name>
    <message>
        <source>computing the hash of %1</source>
        <translation>calcul de l’empreinte de %1</translation>
    </message>
</context>
<context>
    <name>workflow.many_spikes</name>
    <message>
        <source>%1 spikes in %2 positions</source>
        <translation>%1 pics aberrants sur %2 positions</translation>
    </message>
</context>
<context>
    <name>workflow.map_behind</name>
    <message>
        <source>the map is %1 behind, no frame skipped</source>
        <translation>la carte a %1 de retard, rien de sauté</translation>
    </message>
</context>
<context>
    <name>workflow.map_behind_and_skipping</name>
    <message>
        <source>the map is %1 behind, %2 frames skipped</source>
        <translation>la carte a %1 de retard, %2 sautées</translation>
    </message>
</context>
<context>
    <name>workflow.mark_spike</name>
    <message>
        <source>mark frame %1 of %2 as a spike</source>
        <translation>signalement de l’image %1 de %2 comme pic</translation>
    </message>
</context>
<context>
    <name>workflow.mark_spikes</name>
    <message>
        <source>mark %1 samples of %2 as spikes</source>
        <translation>signalement de %1 échantillons de %2 comme pics</translation>
    </message>
</context>
<context>
    <name>workflow.markers_for_camera</name>
    <message>
        <source>markers for camera &apos;%1&apos;</source>
        <translation>marqueurs pour la caméra &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.measure_again</name>
    <message>
        <source>reanalyse %1</source>
        <translation>nouvelle mesure de %1</translation>
    </message>
</context>
<context>
    <name>workflow.measure_check_line</name>
    <message>
        <source>measure the line from end mark to end mark</source>
        <translation>mesurez la ligne d’une marque à l’autre</translation>
    </message>
</context>
<context>
    <name>workflow.measure_height</name>
    <message>
        <source>measure its height, enter it and reanalyse</source>
        <translation>mesurez sa hauteur, saisissez-la et réanalysez</translation>
    </message>
</context>
<context>
    <name>workflow.measure_it_again</name>
    <message>
        <source>repeat the analysis</source>
        <translation>mesurez-le à nouveau</translation>
    </message>
</context>
<context>
    <name>workflow.measured_as_stored</name>
    <message>
        <source>an earlier version measured its frames as stored, but its file says to turn, mirror or stretch them</source>
        <translation>une version antérieure a mesuré ses images telles qu’elles sont enregistrées, mais son fichier demande de les tourner, de les refléter ou de les étirer</translation>
    </message>
</context>
<context>
    <name>workflow.measured_frames</name>
    <message>
        <source>only %1 of the frames give a position</source>
        <translation>seulement %1 des images donnent une position</translation>
    </message>
</context>
<context>
    <name>workflow.measured_in_part</name>
    <message>
        <source>%1 of %2 were measured; lengths, times and maxima are at least as large as stated</source>
        <translation>%1 sur %2 ont été mesurés ; longueurs, durées et maxima valent au moins ce qui est indiqué</translation>
    </message>
</context>
<context>
    <name>workflow.metric_named</name>
    <message>
        <source>metric &apos;%1&apos;</source>
        <translation>grandeur &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.more_frame_steps</name>
    <message>
        <source>up to %1 its frames are wrong at %2 more moments in the same way</source>
        <translation>jusqu&apos;à %1, ses images sont fausses de la même façon à %2 autres moments</translation>
    </message>
</context>
<context>
    <name>workflow.moved_since</name>
    <message>
        <source>it was found moved by %1 since the registration that was used</source>
        <translation>un déplacement de %1 a été constaté depuis la localisation utilisée</translation>
    </message>
</context>
<context>
    <name>workflow.name_another_camera</name>
    <message>
        <source>name another camera that is registered</source>
        <translation>nommez une autre caméra localisée</translation>
    </message>
</context>
<context>
    <name>workflow.name_image_series</name>
    <message>
        <source>give a folder with images such as 000001.png, or a pattern such as FOLDER/%1</source>
        <translation>indiquez un dossier d’images telles que 000001.png, ou un motif tel que FOLDER/%1</translation>
    </message>
</context>
<context>
    <name>workflow.name_its_camera</name>
    <message>
        <source>name one of its cameras</source>
        <translation>nommez l’une de ses caméras</translation>
    </message>
</context>
<context>
    <name>workflow.name_its_robot</name>
    <message>
        <source>name one of its robots</source>
        <translation>nommez l&apos;un de ses robots</translation>
    </message>
</context>
<context>
    <name>workflow.name_one_series</name>
    <message>
        <source>name one of them, like FOLDER/%1</source>
        <translation>indiquez l’une d’elles, comme FOLDER/%1</translation>
    </message>
</context>
<context>
    <name>workflow.name_place_in_pixels</name>
    <message>
        <source>give it in pixels from the frame&apos;s top left corner</source>
        <translation>indiquez-le en pixels depuis le coin supérieur gauche de l’image</translation>
    </message>
</context>
<context>
    <name>workflow.name_robot_after_track</name>
    <message>
        <source>give the robot the name of one of them</source>
        <translation>donnez au robot le nom de l’une d’elles</translation>
    </message>
</context>
<context>
    <name>workflow.name_time_within_trial</name>
    <message>
        <source>name a time within the trial, in seconds</source>
        <translation>indiquez un moment de l’essai, en secondes</translation>
    </message>
</context>
<context>
    <name>workflow.name_two_cameras</name>
    <message>
        <source>name two cameras</source>
        <translation>nommez deux caméras</translation>
    </message>
</context>
<context>
    <name>workflow.nearly_all_beyond_limits</name>
    <message>
        <source>nearly all samples exceed the limits of task &apos;%1&apos;, so the limits were ignored</source>
        <translation>presque toutes les mesures dépassent les limites de l’épreuve &apos;%1&apos;, qui ont donc été ignorées</translation>
    </message>
</context>
<context>
    <name>workflow.neither_lens_nor_recording</name>
    <message>
        <source>it has no intrinsics and no recording</source>
        <translation>elle n’a ni paramètres intrinsèques ni enregistrement</translation>
    </message>
</context>
<context>
    <name>workflow.never_calibrated</name>
    <message>
        <source>it was never calibrated</source>
        <translation>elle n’a jamais été étalonnée</translation>
    </message>
</context>
<context>
    <name>workflow.new_project</name>
    <message>
        <source>new project</source>
        <translation>nouveau projet</translation>
    </message>
</context>
<context>
    <name>workflow.no_address_with_port</name>
    <message>
        <source>it is not an IPv4 address with a port</source>
        <translation>ce n’est pas une adresse IPv4 avec un port</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_gave_picture</name>
    <message>
        <source>no camera delivered a frame</source>
        <translation>aucune caméra n’a donné d’image</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_given</name>
    <message>
        <source>no camera was given</source>
        <translation>aucune caméra n’a été donnée</translation>
    </message>
</context>
<context>
    <name>workflow.no_camera_registered</name>
    <message>
        <source>no camera is registered to the floor</source>
        <translation>aucune caméra n’est localisée par rapport au sol</translation>
    </message>
</context>
<context>
    <name>workflow.no_common_place</name>
    <message>
        <source>The two analyses have no position in common.</source>
        <translation>Aucun endroit n’a été mesuré par les deux analyses.</translation>
    </message>
</context>
<context>
    <name>workflow.no_common_time</name>
    <message>
        <source>views &apos;%1&apos; and &apos;%2&apos; do not overlap with a time offset of %3</source>
        <translation>les vues &apos;%1&apos; et &apos;%2&apos; n’ont pas de temps commun avec un décalage de %3</translation>
    </message>
</context>
<context>
    <name>workflow.no_counterpart</name>
    <message>
        <source>the other camera has no file of its number</source>
        <translation>l’autre caméra n’a pas de fichier de ce numéro</translation>
    </message>
</context>
<context>
    <name>workflow.no_image_series</name>
    <message>
        <source>there are no numbered images (PNG, JPEG, TIFF, BMP, WebP) of that name</source>
        <translation>il n’y a pas d’images numérotées (PNG, JPEG, TIFF, BMP, WebP) de ce nom</translation>
    </message>
</context>
<context>
    <name>workflow.no_live_positions</name>
    <message>
        <source>none of its cameras is registered to the floor, so there are no live positions to send</source>
        <translation>aucune de ses caméras n’est localisée par rapport au sol, il n’y a donc pas de positions en direct à envoyer</translation>
    </message>
</context>
<context>
    <name>workflow.no_mat_seen</name>
    <message>
        <source>no file shows four or more of its tags</source>
        <translation>aucun fichier ne montre quatre de ses étiquettes ou plus</translation>
    </message>
</context>
<context>
    <name>workflow.no_motion</name>
    <message>
        <source>no robot moves in it</source>
        <translation>aucun robot n’y bouge</translation>
    </message>
</context>
<context>
    <name>workflow.no_multicast</name>
    <message>
        <source>interface &apos;%1&apos; does not support multicast</source>
        <translation>l’interface &apos;%1&apos; n’accepte pas le multicast</translation>
    </message>
</context>
<context>
    <name>workflow.no_picture_read</name>
    <message>
        <source>no image could be read</source>
        <translation>aucune photo n’a pu être lue</translation>
    </message>
</context>
<context>
    <name>workflow.no_picture_then</name>
    <message>
        <source>the view has no frame at that time</source>
        <translation>la vue n’a pas d&apos;image à ce moment</translation>
    </message>
</context>
<context>
    <name>workflow.no_pixels_no_picture</name>
    <message>
        <source>it needs pixels, or an image to detect the markers in</source>
        <translation>ni leurs pixels ni une image où chercher n’ont été donnés</translation>
    </message>
</context>
<context>
    <name>workflow.no_robot</name>
    <message>
        <source>the project has no robot to track</source>
        <translation>le projet n’a pas de robot à chercher</translation>
    </message>
</context>
<context>
    <name>workflow.no_sample</name>
    <message>
        <source>the analysis has no sample</source>
        <translation>l’analyse n’a aucun échantillon</translation>
    </message>
</context>
<context>
    <name>workflow.no_sample_in_group</name>
    <message>
        <source>no sample from %1 to %2 is to be changed</source>
        <translation>aucun échantillon de %1 à %2 n’est à changer</translation>
    </message>
</context>
<context>
    <name>workflow.no_socket</name>
    <message>
        <source>the system could not open a socket</source>
        <translation>cet ordinateur ne donne pas de socket</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_frame</name>
    <message>
        <source>this frame does not exist</source>
        <translation>cette image n’existe pas</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_interface</name>
    <message>
        <source>this computer has no interface of that name</source>
        <translation>cet ordinateur n’en a pas de ce nom</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_metric</name>
    <message>
        <source>no trial of the project has it</source>
        <translation>aucun essai du projet ne l’a</translation>
    </message>
</context>
<context>
    <name>workflow.no_such_view</name>
    <message>
        <source>the trial has no such view</source>
        <translation>l’essai n’a pas cette vue</translation>
    </message>
</context>
<context>
    <name>workflow.no_times_in_file</name>
    <message>
        <source>it has no time stamps and states no frame rate</source>
        <translation>il n&apos;a pas d&apos;horodatage et n&apos;indique aucune fréquence d&apos;images</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_given</name>
    <message>
        <source>no track was given</source>
        <translation>aucune trajectoire n’a été donnée</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_imported</name>
    <message>
        <source>no track of it was imported</source>
        <translation>aucune trajectoire de lui n’a été importée</translation>
    </message>
</context>
<context>
    <name>workflow.no_track_of_that_name</name>
    <message>
        <source>none of its tracks is called &apos;%1&apos;; it has %2</source>
        <translation>aucune de ses trajectoires ne s’appelle &apos;%1&apos;&#xa0;; présentes&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>workflow.no_video_given</name>
    <message>
        <source>no video was given</source>
        <translation>aucune vidéo n’a été donnée</translation>
    </message>
</context>
<context>
    <name>workflow.no_video_lost</name>
    <message>
        <source>no video of this project is lost</source>
        <translation>aucune vidéo de ce projet n’est perdue</translation>
    </message>
</context>
<context>
    <name>workflow.none_of_that_number</name>
    <message>
        <source>camera &apos;%1&apos; has no such number</source>
        <translation>la caméra &apos;%1&apos; n’en a pas de ce numéro</translation>
    </message>
</context>
<context>
    <name>workflow.not_measured_in_range</name>
    <message>
        <source>it contains no sample of robot &apos;%1&apos; (%2 to %3)</source>
        <translation>elle ne contient aucun échantillon du robot &apos;%1&apos; (de %2 à %3)</translation>
    </message>
</context>
<context>
    <name>workflow.not_measured_there</name>
    <message>
        <source>the robot has no measurement at that time</source>
        <translation>le robot n’y a pas été mesuré, il n’y a donc rien à juger</translation>
    </message>
</context>
<context>
    <name>workflow.not_synchronised</name>
    <message>
        <source>it is not synchronised: the same start time as the first view was assumed, and positions of a moving robot are wrong</source>
        <translation>elle n’est pas synchronisée mais prise comme commencée avec la première vue, si bien qu’un robot en mouvement n’est pas là où les deux vues le placent</translation>
    </message>
</context>
<context>
    <name>workflow.not_tracked_in_trial</name>
    <message>
        <source>it is not tracked in trial &apos;%1&apos;</source>
        <translation>il n’est pas suivi dans l’essai &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.not_tracked_yet</name>
    <message>
        <source>it has not been tracked yet</source>
        <translation>il n’a pas encore été suivi</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_came</name>
    <message>
        <source>no frame arrived for %1 because %2</source>
        <translation>rien n’est venu pendant %1, car %2</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_recorded</name>
    <message>
        <source>nothing was recorded</source>
        <translation>rien n’a été enregistré</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_said_there</name>
    <message>
        <source>that frame has no manual override</source>
        <translation>rien n’y a été dit à la main</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_stands_out</name>
    <message>
        <source>no foreground object was found at pixel %1,%2 at %3</source>
        <translation>rien ne se distingue du sol en %1,%2 à %3 pendant quelques images</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_accept</name>
    <message>
        <source>all checks were passed</source>
        <translation>tous les contrôles sont réussis</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_analyse_again</name>
    <message>
        <source>it has not been tracked yet, so it cannot be reanalysed</source>
        <translation>il n’a pas encore été suivi, il n’y a donc rien à réanalyser</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_do</name>
    <message>
        <source>no action is needed</source>
        <translation>il n’y a rien à faire</translation>
    </message>
</context>
<context>
    <name>workflow.nothing_to_withdraw</name>
    <message>
        <source>leave it as it is</source>
        <translation>laissez-le tel quel</translation>
    </message>
</context>
<context>
    <name>workflow.number_files_alike</name>
    <message>
        <source>give as many of each, in the same order, or number their names alike</source>
        <translation>donnez-en autant pour chacune, dans le même ordre, ou numérotez leurs noms de la même façon</translation>
    </message>
</context>
<context>
    <name>workflow.number_images_once</name>
    <message>
        <source>give each image a number of its own</source>
        <translation>donnez à chaque image un numéro propre</translation>
    </message>
</context>
<context>
    <name>workflow.numbers_count_no_frames</name>
    <message>
        <source>their numbers go from %1 to %2, and there are %3 images: they do not count frames</source>
        <translation>leurs numéros vont de %1 à %2, et il y a %3 images : ils ne comptent pas les images d’une vidéo</translation>
    </message>
</context>
<context>
    <name>workflow.offsets_of_other_count</name>
    <message>
        <source>the number of views is %1, the number of offsets %2</source>
        <translation>%1 vues ont été données, et les décalages de %2</translation>
    </message>
</context>
<context>
    <name>workflow.old_calibration</name>
    <message>
        <source>The lens calibration of camera &apos;%1&apos; is %2 days old</source>
        <translation>L’étalonnage de l’objectif de la caméra &apos;%1&apos; date de %2 jours</translation>
    </message>
</context>
<context>
    <name>workflow.old_registration</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; is %2 days old</source>
        <translation>La localisation de la caméra &apos;%1&apos; date de %2 jours</translation>
    </message>
</context>
<context>
    <name>workflow.one_follows_something_else</name>
    <message>
        <source>one of them tracks another object, or has moved since its registration</source>
        <translation>l’une d’elles suit autre chose, ou n’est plus là où elle a été localisée</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_doubled</name>
    <message>
        <source>after %1 a frame repeats the one before, and its time stamps count it as time; later times were corrected</source>
        <translation>après %1, une image répète la précédente, et ses horodatages la comptent comme du temps ; les temps suivants ont été corrigés</translation>
    </message>
</context>
<context>
    <name>workflow.one_frame_missing</name>
    <message>
        <source>after %1 a frame is missing that its time stamps do not show: the robot moves too far; later times were corrected</source>
        <translation>après %1, une image manque sans que ses horodatages le montrent : le robot avance trop loin ; les temps suivants ont été corrigés</translation>
    </message>
</context>
<context>
    <name>workflow.only_frame</name>
    <message>
        <source>its only frame is 0</source>
        <translation>la seule est l’image 0</translation>
    </message>
</context>
<context>
    <name>workflow.open_it_or_elsewhere</name>
    <message>
        <source>open it, or choose another folder</source>
        <translation>ouvrez-le, ou choisissez un autre dossier</translation>
    </message>
</context>
<context>
    <name>workflow.other_sample_judged</name>
    <message>
        <source>another sample was overridden while this one was analysed</source>
        <translation>un autre échantillon a été jugé à la main pendant l’analyse de celui-ci</translation>
    </message>
</context>
<context>
    <name>workflow.outside_picture</name>
    <message>
        <source>the position is outside the frame</source>
        <translation>l’endroit est hors de l’image</translation>
    </message>
</context>
<context>
    <name>workflow.pair_like_files</name>
    <message>
        <source>pair images with images and videos with videos</source>
        <translation>associez des images à des images et des vidéos à des vidéos</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_cameras</name>
    <message>
        <source>the relative position of cameras &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>la position relative des caméras &apos;%1&apos; et &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_one_camera</name>
    <message>
        <source>both are the same camera</source>
        <translation>les deux sont la même caméra</translation>
    </message>
</context>
<context>
    <name>workflow.pair_of_other_size</name>
    <message>
        <source>&apos;%1&apos; is %2, but the camera was calibrated at %3</source>
        <translation>&apos;%1&apos; est en %2, mais la caméra a été étalonnée en %3</translation>
    </message>
</context>
<context>
    <name>workflow.paired_files</name>
    <message>
        <source>the files of the two cameras</source>
        <translation>les fichiers des deux caméras</translation>
    </message>
</context>
<context>
    <name>workflow.passed_cameras</name>
    <message>
        <source>no camera was found moved</source>
        <translation>aucune caméra n&apos;a été trouvée déplacée</translation>
    </message>
</context>
<context>
    <name>workflow.passed_decoding</name>
    <message>
        <source>all frames could be decoded</source>
        <translation>toutes les images ont pu être décodées</translation>
    </message>
</context>
<context>
    <name>workflow.passed_frames</name>
    <message>
        <source>the frames came at regular intervals</source>
        <translation>les images sont arrivées à intervalles réguliers</translation>
    </message>
</context>
<context>
    <name>workflow.passed_lens</name>
    <message>
        <source>the lenses are calibrated, or estimated from the floor&apos;s markers</source>
        <translation>les objectifs sont étalonnés ou estimés d’après les marqueurs du sol</translation>
    </message>
</context>
<context>
    <name>workflow.passed_motion</name>
    <message>
        <source>speeds and accelerations are possible</source>
        <translation>les vitesses et accélérations sont possibles</translation>
    </message>
</context>
<context>
    <name>workflow.passed_names</name>
    <message>
        <source>no robot could be another one</source>
        <translation>aucun robot ne peut en être un autre</translation>
    </message>
</context>
<context>
    <name>workflow.passed_precision</name>
    <message>
        <source>positions are precise for the run&apos;s extent</source>
        <translation>les positions sont précises pour l’étendue de la course</translation>
    </message>
</context>
<context>
    <name>workflow.passed_results</name>
    <message>
        <source>the stored results are as computed</source>
        <translation>les résultats enregistrés sont ceux calculés</translation>
    </message>
</context>
<context>
    <name>workflow.passed_spikes</name>
    <message>
        <source>few positions are spikes</source>
        <translation>peu de positions sont des pics aberrants</translation>
    </message>
</context>
<context>
    <name>workflow.passed_synchronisation</name>
    <message>
        <source>the views are synchronised</source>
        <translation>les vues sont synchronisées</translation>
    </message>
</context>
<context>
    <name>workflow.passed_time</name>
    <message>
        <source>the robots were measured all the time</source>
        <translation>les robots ont été mesurés tout le temps</translation>
    </message>
</context>
<context>
    <name>workflow.passed_views</name>
    <message>
        <source>the views agree</source>
        <translation>les vues concordent</translation>
    </message>
</context>
<context>
    <name>workflow.picture_lost_here</name>
    <message>
        <source>1 frame was lost because this computer or its disk was too slow</source>
        <translation>1 image a été perdue car cet ordinateur ou son disque était trop lent</translation>
    </message>
</context>
<context>
    <name>workflow.picture_lost_on_wire</name>
    <message>
        <source>1 frame was lost between the camera and this program</source>
        <translation>1 image a été perdue entre la caméra et ce programme</translation>
    </message>
</context>
<context>
    <name>workflow.picture_made_too_late</name>
    <message>
        <source>1 frame was lost: this computer was too slow to generate it in time</source>
        <translation>1 image a été perdue car cet ordinateur était trop lent pour la produire à temps</translation>
    </message>
</context>
<context>
    <name>workflow.picture_size_not_known</name>
    <message>
        <source>the size of its images is not known</source>
        <translation>la taille de ses images n’est pas connue</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_lost_here</name>
    <message>
        <source>%1 frames were lost because this computer or its disk was too slow</source>
        <translation>%1 images ont été perdues car cet ordinateur ou son disque était trop lent</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_lost_on_wire</name>
    <message>
        <source>%1 frames were lost between the camera and this program</source>
        <translation>%1 images ont été perdues entre la caméra et ce programme</translation>
    </message>
</context>
<context>
    <name>workflow.pictures_made_too_late</name>
    <message>
        <source>%1 frames were lost: this computer was too slow to generate them in time</source>
        <translation>%1 images ont été perdues car cet ordinateur était trop lent pour les produire à temps</translation>
    </message>
</context>
<context>
    <name>workflow.point_out_whole_robot</name>
    <message>
        <source>point it out where the whole robot is visible and moving</source>
        <translation>montrez-le là où il est vu en entier et se déplace</translation>
    </message>
</context>
<context>
    <name>workflow.positions_change</name>
    <message>
        <source>Positions change by %1 RMS, at most by %2 (at %3).</source>
        <translation>Les positions changent de %1 RMS, au plus de %2 (à %3).</translation>
    </message>
</context>
<context>
    <name>workflow.positions_rounded</name>
    <message>
        <source>rounded to %1</source>
        <translation>arrondies à %1</translation>
    </message>
</context>
<context>
    <name>workflow.positions_uncertain</name>
    <message>
        <source>its positions are known to ±%1 only, in a run over %2</source>
        <translation>ses positions ne sont connues qu’à ±%1, dans une course de %2</translation>
    </message>
</context>
<context>
    <name>workflow.project_file_gone</name>
    <message>
        <source>the project file no longer exists</source>
        <translation>le fichier du projet n’est plus là</translation>
    </message>
</context>
<context>
    <name>workflow.project_lost</name>
    <message>
        <source>the project file was deleted, renamed or replaced; recording continues, and its contents will be saved at the end</source>
        <translation>le fichier du projet a été supprimé, renommé ou remplacé ; l’enregistrement continue et son contenu est récupéré à la fin</translation>
    </message>
</context>
<context>
    <name>workflow.project_rescued</name>
    <message>
        <source>the project file was deleted, renamed or replaced; its contents were saved in &apos;%1&apos;, the project from now on</source>
        <translation>le fichier du projet a entre-temps été supprimé, renommé ou remplacé ; son contenu est récupéré dans &apos;%1&apos;, qui est désormais le projet</translation>
    </message>
</context>
<context>
    <name>workflow.put_axes_elsewhere</name>
    <message>
        <source>change the world axes of layout %1</source>
        <translation>déplacement des axes du plan %1</translation>
    </message>
</context>
<context>
    <name>workflow.put_original_or_import</name>
    <message>
        <source>restore the original file, or import this one as another trial</source>
        <translation>remettez le fichier d&apos;origine, ou importez celui-ci comme un autre essai</translation>
    </message>
</context>
<context>
    <name>workflow.put_plate_on_it</name>
    <message>
        <source>put a plate of another colour on it, or set its true colour</source>
        <translation>posez dessus une plaque d’une autre couleur, ou indiquez sa vraie couleur</translation>
    </message>
</context>
<context>
    <name>workflow.range_is_reversed</name>
    <message>
        <source>its start %1 is not before its end %2</source>
        <translation>son début %1 n’est pas avant sa fin %2</translation>
    </message>
</context>
<context>
    <name>workflow.range_of_trial</name>
    <message>
        <source>range of trial &apos;%1&apos;</source>
        <translation>plage de l’essai &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.range_outside_trial</name>
    <message>
        <source>%1 to %2 is not within the trial&apos;s time</source>
        <translation>de %1 à %2 n’est pas dans le temps de l’essai</translation>
    </message>
</context>
<context>
    <name>workflow.range_without_sample</name>
    <message>
        <source>it contains no sample</source>
        <translation>elle ne contient aucun échantillon</translation>
    </message>
</context>
<context>
    <name>workflow.rate_and_times</name>
    <message>
        <source>camera &apos;%1&apos; was given both a frame rate and frame times</source>
        <translation>une fréquence d’images et des temps d’images ont été donnés pour la caméra &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.rate_is_assumed</name>
    <message>
        <source>no recording shows it, so 30 frames/s are simulated</source>
        <translation>aucun enregistrement ne la montre, 30 images/s sont donc simulées</translation>
    </message>
</context>
<context>
    <name>workflow.rate_of_header</name>
    <message>
        <source>its header states an even %1</source>
        <translation>son en-tête indique %1 constantes</translation>
    </message>
</context>
<context>
    <name>workflow.reanalyse_tracks</name>
    <message>
        <source>reanalyse them with: odograph track PROJECT TRIAL --again</source>
        <translation>analysez-les à nouveau</translation>
    </message>
</context>
<context>
    <name>workflow.record</name>
    <message>
        <source>record %1</source>
        <translation>enregistrement de %1</translation>
    </message>
</context>
<context>
    <name>workflow.record_for_longer</name>
    <message>
        <source>record again, for longer</source>
        <translation>enregistrez de nouveau, plus longtemps</translation>
    </message>
</context>
<context>
    <name>workflow.record_it_again</name>
    <message>
        <source>record it again</source>
        <translation>filmez-le à nouveau</translation>
    </message>
</context>
<context>
    <name>workflow.record_to_faster_disk</name>
    <message>
        <source>record to a faster disk</source>
        <translation>enregistrez sur un disque plus rapide</translation>
    </message>
</context>
<context>
    <name>workflow.recorded_at_another_size</name>
    <message>
        <source>The newest recording of camera &apos;%1&apos; is %2, its lens was calibrated at %3</source>
        <translation>Le dernier enregistrement de la caméra &apos;%1&apos; est en %2, son objectif a été étalonné en %3</translation>
    </message>
</context>
<context>
    <name>workflow.recording</name>
    <message>
        <source>recording</source>
        <translation>enregistrement</translation>
    </message>
</context>
<context>
    <name>workflow.recording_of_trial</name>
    <message>
        <source>recording of trial &apos;%1&apos;</source>
        <translation>enregistrement de l’essai &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.recording_of_view</name>
    <message>
        <source>recording of view &apos;%1&apos;</source>
        <translation>enregistrement de la vue « %1 »</translation>
    </message>
</context>
<context>
    <name>workflow.reference_not_calibrated</name>
    <message>
        <source>camera &apos;%1&apos; was registered without a lens calibration: register it again with it</source>
        <translation>la caméra &apos;%1&apos; a été localisée sans étalonnage d’objectif : localisez-la de nouveau avec lui</translation>
    </message>
</context>
<context>
    <name>workflow.register_a_camera</name>
    <message>
        <source>register the cameras first</source>
        <translation>localisez d’abord les caméras</translation>
    </message>
</context>
<context>
    <name>workflow.register_both_again</name>
    <message>
        <source>register both again and reanalyse</source>
        <translation>localisez de nouveau les deux et réanalysez</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera</name>
    <message>
        <source>register camera %1</source>
        <translation>localisation de la caméra %1</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_again</name>
    <message>
        <source>register camera %1 again</source>
        <translation>nouvelle localisation de la caméra %1</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_anew</name>
    <message>
        <source>register the camera again</source>
        <translation>enregistrer de nouveau la caméra</translation>
    </message>
</context>
<context>
    <name>workflow.register_camera_through</name>
    <message>
        <source>register camera %1 via camera %2</source>
        <translation>localisation de la caméra %1 par la caméra %2</translation>
    </message>
</context>
<context>
    <name>workflow.register_cameras_again</name>
    <message>
        <source>register the cameras again</source>
        <translation>localisez de nouveau les caméras</translation>
    </message>
</context>
<context>
    <name>workflow.register_cameras_together</name>
    <message>
        <source>register the cameras of layout %1 jointly</source>
        <translation>localisation commune des caméras du plan %1</translation>
    </message>
</context>
<context>
    <name>workflow.register_if_other_part</name>
    <message>
        <source>if the camera shows another part of the scene at that size, register it again in a frame of this video</source>
        <translation>si la caméra montre une autre partie de la scène à cette taille, localisez-la de nouveau dans une image de cette vidéo</translation>
    </message>
</context>
<context>
    <name>workflow.register_in_its_video</name>
    <message>
        <source>register the camera in a frame of this video, to which its lens calibration is then fitted</source>
        <translation>localisez la caméra dans une image de cette vidéo, à laquelle l’étalonnage de son objectif est alors ajusté</translation>
    </message>
</context>
<context>
    <name>workflow.register_in_this_video</name>
    <message>
        <source>register the camera again in a frame of this video and reanalyse</source>
        <translation>localisez de nouveau la caméra dans une image de cette vidéo et relancez l’analyse</translation>
    </message>
</context>
<context>
    <name>workflow.register_it_again</name>
    <message>
        <source>register it again.</source>
        <translation>localisez-la à nouveau.</translation>
    </message>
</context>
<context>
    <name>workflow.register_it_first</name>
    <message>
        <source>register it first, with markers or via another camera</source>
        <translation>localisez-la d’abord, par marqueurs ou par une autre caméra</translation>
    </message>
</context>
<context>
    <name>workflow.register_moved_again</name>
    <message>
        <source>register it again and reanalyse</source>
        <translation>localisez-la de nouveau et réanalysez</translation>
    </message>
</context>
<context>
    <name>workflow.register_or_do_not_send</name>
    <message>
        <source>run odograph register for one of them, or leave --ssl-vision out</source>
        <translation>localisez-en une, ou n’envoyez pas de positions</translation>
    </message>
</context>
<context>
    <name>workflow.register_through_it_again</name>
    <message>
        <source>register it via that camera again</source>
        <translation>localisez-la à nouveau par cette caméra</translation>
    </message>
</context>
<context>
    <name>workflow.register_upright</name>
    <message>
        <source>register the camera again</source>
        <translation>localisez de nouveau la caméra</translation>
    </message>
</context>
<context>
    <name>workflow.registered_as_stored</name>
    <message>
        <source>its frames are turned or mirrored as its file says, but an earlier version registered camera &apos;%1&apos;, perhaps by frames as stored</source>
        <translation>ses images sont tournées ou reflétées comme son fichier le demande, mais une version antérieure a localisé la caméra &apos;%1&apos;, peut-être d’après des images telles qu’elles sont stockées</translation>
    </message>
</context>
<context>
    <name>workflow.registered_at_another_size</name>
    <message>
        <source>the image is %1, the camera was registered at %2</source>
        <translation>l’image est en %1, la caméra a été localisée en %2</translation>
    </message>
</context>
<context>
    <name>workflow.registered_before_calibration</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; was made before its lens was calibrated</source>
        <translation>La localisation de la caméra &apos;%1&apos; a été faite avant l’étalonnage de son objectif</translation>
    </message>
</context>
<context>
    <name>workflow.registered_on_other_floor</name>
    <message>
        <source>it is registered on another floor, &apos;%1&apos;, and left out</source>
        <translation>elle est localisée sur un autre sol, &apos;%1&apos;, et n’est pas prise en compte</translation>
    </message>
</context>
<context>
    <name>workflow.registered_through_another</name>
    <message>
        <source>it was registered via another camera</source>
        <translation>elle a été localisée par une autre caméra</translation>
    </message>
</context>
<context>
    <name>workflow.registered_with_other_lens</name>
    <message>
        <source>The floor registration of camera &apos;%1&apos; uses another lens calibration than the current one</source>
        <translation>La localisation de la caméra &apos;%1&apos; a été faite avec un autre étalonnage de l’objectif que celui en vigueur</translation>
    </message>
</context>
<context>
    <name>workflow.registration</name>
    <message>
        <source>registration %1</source>
        <translation>localisation %1</translation>
    </message>
</context>
<context>
    <name>workflow.registration_converted</name>
    <message>
        <source>its frames are %1, so the camera&apos;s registration at %2 was converted</source>
        <translation>ses images sont en %1, la localisation de la caméra en %2 a donc été convertie</translation>
    </message>
</context>
<context>
    <name>workflow.registration_counts_as_exact</name>
    <message>
        <source>its uncertainty is not known, so it counts as exact</source>
        <translation>son incertitude n’est pas connue, elle compte donc comme exacte</translation>
    </message>
</context>
<context>
    <name>workflow.registration_in_older_axes</name>
    <message>
        <source>it has other axes: those of its layout were changed since</source>
        <translation>il a d’autres axes : ceux de sa disposition ont changé depuis</translation>
    </message>
</context>
<context>
    <name>workflow.registration_of</name>
    <message>
        <source>registration of %1</source>
        <translation>localisation de&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>workflow.registration_of_camera</name>
    <message>
        <source>registration of camera &apos;%1&apos;</source>
        <translation>localisation de la caméra &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.registration_through</name>
    <message>
        <source>registration of camera &apos;%1&apos; via &apos;%2&apos;</source>
        <translation>localisation de la caméra &apos;%1&apos; par &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.registration_with_lens_in_force</name>
    <message>
        <source>registration of camera &apos;%1&apos; with the current lens calibration</source>
        <translation>localisation de la caméra &apos;%1&apos; avec l’objectif en vigueur</translation>
    </message>
</context>
<context>
    <name>workflow.remove_cause</name>
    <message>
        <source>remove the cause and reanalyse, or record it again</source>
        <translation>supprimez la cause et réanalysez, ou enregistrez à nouveau</translation>
    </message>
</context>
<context>
    <name>workflow.remove_for_good</name>
    <message>
        <source>remove %1 for good</source>
        <translation>suppression définitive de %1</translation>
    </message>
</context>
<context>
    <name>workflow.remove_strays</name>
    <message>
        <source>remove stray files</source>
        <translation>supprimer les fichiers orphelins</translation>
    </message>
</context>
<context>
    <name>workflow.removing</name>
    <message>
        <source>removing %1</source>
        <translation>suppression de %1</translation>
    </message>
</context>
<context>
    <name>workflow.rename_trial</name>
    <message>
        <source>rename trial %1 to %2</source>
        <translation>essai %1 renommé en %2</translation>
    </message>
</context>
<context>
    <name>workflow.replaced_not_packed</name>
    <message>
        <source>the video of camera %1 in trial &apos;%2&apos; is outside the media folder and has changed since; it is not in the packed project</source>
        <translation>la vidéo de la caméra %1 dans l’essai &apos;%2&apos; se trouve ailleurs et n’est plus le même fichier, et absente du projet empaqueté</translation>
    </message>
</context>
<context>
    <name>workflow.results_changed</name>
    <message>
        <source>its results differ from those of its analysis</source>
        <translation>ses résultats ne sont pas ceux que son analyse a donnés</translation>
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
        <translation>deux trajectoires ont été données pour le robot &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.robot_in_view</name>
    <message>
        <source>robot &apos;%1&apos; in view &apos;%2&apos;</source>
        <translation>robot &apos;%1&apos; dans la vue &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.robot_is_new</name>
    <message>
        <source>robot &apos;%1&apos; is new</source>
        <translation>le robot &apos;%1&apos; est nouveau</translation>
    </message>
</context>
<context>
    <name>workflow.robot_leaps</name>
    <message>
        <source>after %1 the robot is suddenly %2 away: frames are missing for an unknown time, or another object was tracked; nothing was measured across it</source>
        <translation>après %1, le robot est soudain à %2 : des images manquent pendant une durée inconnue, ou un autre objet a été suivi ; rien n&apos;a été mesuré à travers ce saut</translation>
    </message>
</context>
<context>
    <name>workflow.robot_not_tracked</name>
    <message>
        <source>robot &apos;%1&apos; was not tracked in it, only %2</source>
        <translation>le robot &apos;%1&apos; n’y a pas été suivi, mais %2 l’a été</translation>
    </message>
</context>
<context>
    <name>workflow.robot_pointed_out</name>
    <message>
        <source>robot &apos;%1&apos; pointed out in view &apos;%2&apos;</source>
        <translation>robot &apos;%1&apos; montré dans la vue &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.roster_line</name>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
</context>
<context>
    <name>workflow.run_calibrate</name>
    <message>
        <source>calibrate its lens, or import its intrinsics</source>
        <translation>étalonner son objectif, ou importer ses paramètres intrinsèques</translation>
    </message>
</context>
<context>
    <name>workflow.run_in_older_axes</name>
    <message>
        <source>it has other axes: those of layout &apos;%1&apos; were changed after it was analysed</source>
        <translation>il a d’autres axes : ceux de la disposition « %1 » ont changé après son analyse</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_first</name>
    <message>
        <source>run odograph track first</source>
        <translation>faites d’abord le suivi</translation>
    </message>
</context>
<context>
    <name>workflow.run_track_without_again</name>
    <message>
        <source>run odograph track without --again first</source>
        <translation>faites d’abord le suivi des vidéos de l’essai</translation>
    </message>
</context>
<context>
    <name>workflow.runs_in_other_axes</name>
    <message>
        <source>it has other axes (layout &apos;%1&apos;) than trial &apos;%2&apos; (layout &apos;%3&apos;)</source>
        <translation>il a d’autres axes (disposition « %1 ») que l’essai « %2 » (disposition « %3 »)</translation>
    </message>
</context>
<context>
    <name>workflow.say_it_again</name>
    <message>
        <source>repeat it for frame %1</source>
        <translation>indiquez-le de nouveau pour l’image %1</translation>
    </message>
</context>
<context>
    <name>workflow.scene_far_shifted</name>
    <message>
        <source>its scene is shifted by %1 against the image by which its camera was registered</source>
        <translation>sa scène est décalée de %1 par rapport à l’image qui a servi à localiser sa caméra</translation>
    </message>
</context>
<context>
    <name>workflow.scene_mirrored</name>
    <message>
        <source>it is mirrored against the image by which its camera was registered</source>
        <translation>elle est inversée en miroir par rapport à l’image qui a servi à localiser sa caméra</translation>
    </message>
</context>
<context>
    <name>workflow.scene_shifted</name>
    <message>
        <source>its scene is shifted by %1 against the image by which its camera was registered, so the camera was moved, and the stated errors were increased by that</source>
        <translation>sa scène est décalée de %1 par rapport à l’image qui a servi à localiser sa caméra ; la caméra a donc bougé, et les erreurs indiquées ont été augmentées d’autant</translation>
    </message>
</context>
<context>
    <name>workflow.scene_turned</name>
    <message>
        <source>it is turned by %1 against the image by which its camera was registered</source>
        <translation>elle est tournée de %1 par rapport à l’image qui a servi à localiser sa caméra</translation>
    </message>
</context>
<context>
    <name>workflow.scene_zoomed</name>
    <message>
        <source>it shows the scene %1 times as large as the image by which its camera was registered</source>
        <translation>elle montre la scène %1 fois plus grande que l’image qui a servi à localiser sa caméra</translation>
    </message>
</context>
<context>
    <name>workflow.see_flags_by_hand</name>
    <message>
        <source>see the flags by_hand in odograph export</source>
        <translation>l’examen marque les échantillons corrigés à la main</translation>
    </message>
</context>
<context>
    <name>workflow.see_revisions</name>
    <message>
        <source>see the list of its revisions</source>
        <translation>voyez dans ses révisions celles qui existent</translation>
    </message>
</context>
<context>
    <name>workflow.set_range</name>
    <message>
        <source>set the range of %1</source>
        <translation>plage de %1 fixée</translation>
    </message>
</context>
<context>
    <name>workflow.settling_names</name>
    <message>
        <source>assigning names to the robots</source>
        <translation>identification des robots</translation>
    </message>
</context>
<context>
    <name>workflow.several_image_series</name>
    <message>
        <source>the folder holds several series: %1 and %2</source>
        <translation>le dossier contient plusieurs séries : %1 et %2</translation>
    </message>
</context>
<context>
    <name>workflow.several_robots</name>
    <message>
        <source>it has several robots</source>
        <translation>il a plusieurs robots</translation>
    </message>
</context>
<context>
    <name>workflow.show_mat</name>
    <message>
        <source>print the mat, lay it where the cameras see all of it, and record again</source>
        <translation>imprimez le tapis, posez-le là où les caméras le voient en entier, et enregistrez de nouveau</translation>
    </message>
</context>
<context>
    <name>workflow.show_whole_board</name>
    <message>
        <source>show the whole board, flat, sharp and evenly lit, and check --pattern and --board</source>
        <translation>montrez toute la mire, plate, nette et éclairée uniformément, et vérifiez motif et taille</translation>
    </message>
</context>
<context>
    <name>workflow.simulated_robot_not_found</name>
    <message>
        <source>the simulated robot was not found in the simulated views</source>
        <translation>le robot simulé n’a pas été trouvé dans les vues simulées</translation>
    </message>
</context>
<context>
    <name>workflow.simulating_run</name>
    <message>
        <source>simulating run %1 of %2</source>
        <translation>simulation du passage&#xa0;%1 sur&#xa0;%2</translation>
    </message>
</context>
<context>
    <name>workflow.slow_errors_not_seen</name>
    <message>
        <source>errors that change slowly are not included</source>
        <translation>les erreurs qui changent lentement ne sont pas comprises</translation>
    </message>
</context>
<context>
    <name>workflow.sought_when_tracked</name>
    <message>
        <source>%1; tracking tries again</source>
        <translation>%1 ; le suivi essaie de nouveau</translation>
    </message>
</context>
<context>
    <name>workflow.sound_of_slow_motion</name>
    <message>
        <source>sound cannot be compared in clips that play in slow motion</source>
        <translation>le son ne peut être comparé dans des clips au ralenti</translation>
    </message>
</context>
<context>
    <name>workflow.sound_unreadable</name>
    <message>
        <source>the sound of view &apos;%1&apos; cannot be read (%2)</source>
        <translation>impossible de lire le son de la vue &apos;%1&apos; (%2)</translation>
    </message>
</context>
<context>
    <name>workflow.spikes_change</name>
    <message>
        <source>Spikes: %1 instead of %2.</source>
        <translation>Pics aberrants&#xa0;: %1 au lieu de %2.</translation>
    </message>
</context>
<context>
    <name>workflow.stamps_too_dense</name>
    <message>
        <source>its time stamps mean %1, which no camera takes</source>
        <translation>ses horodatages signifient %1, ce qu&apos;aucune caméra ne prend</translation>
    </message>
</context>
<context>
    <name>workflow.stopped_before_first_frame</name>
    <message>
        <source>it was stopped before the first frame came</source>
        <translation>il a été arrêté avant l’arrivée de la première image</translation>
    </message>
</context>
<context>
    <name>workflow.synchronisation_of_view</name>
    <message>
        <source>synchronisation of view &apos;%1&apos;</source>
        <translation>synchronisation de la vue &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_again</name>
    <message>
        <source>synchronise the views again and reanalyse</source>
        <translation>synchronisez de nouveau les vues et réanalysez</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_for_offset</name>
    <message>
        <source>synchronise it again with odograph trial set --sync auto, or enter the time offset</source>
        <translation>synchronisez-la de nouveau (Essai ▸ Synchroniser…), ou saisissez-y le décalage</translation>
    </message>
</context>
<context>
    <name>workflow.synchronise_trial</name>
    <message>
        <source>synchronise %1: %2 (before: %3)</source>
        <translation>synchroniser %1 : %2 (avant : %3)</translation>
    </message>
</context>
<context>
    <name>workflow.take_fewer_cameras</name>
    <message>
        <source>close other programs, or use fewer such cameras at once</source>
        <translation>fermez d’autres programmes, ou prenez moins de caméras de ce genre à la fois</translation>
    </message>
</context>
<context>
    <name>workflow.take_over_set_up</name>
    <message>
        <source>copy the set-up of %1</source>
        <translation>reprise de l’installation de %1</translation>
    </message>
</context>
<context>
    <name>workflow.taking_over_set_up</name>
    <message>
        <source>copying the set-up</source>
        <translation>reprise de l’installation</translation>
    </message>
</context>
<context>
    <name>workflow.task_was_changed</name>
    <message>
        <source>its task changed during the analysis</source>
        <translation>son épreuve a été changée pendant la mesure</translation>
    </message>
</context>
<context>
    <name>workflow.task_without_course</name>
    <message>
        <source>task &apos;%1&apos; has neither a path nor gates to drive along</source>
        <translation>l’épreuve &apos;%1&apos; n’a ni trajectoire ni portes à suivre</translation>
    </message>
</context>
<context>
    <name>workflow.team_of_another_class</name>
    <message>
        <source>it belongs to class %1, not to class %2</source>
        <translation>elle appartient à la classe %1, pas à la classe %2</translation>
    </message>
</context>
<context>
    <name>workflow.through_itself</name>
    <message>
        <source>a camera cannot be registered via itself</source>
        <translation>une caméra ne peut pas être localisée par elle-même</translation>
    </message>
</context>
<context>
    <name>workflow.time_of_trial</name>
    <message>
        <source>%1 of trial &apos;%2&apos;</source>
        <translation>%1 de l’essai &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.times_count_from</name>
    <message>
        <source>its times start at %1</source>
        <translation>ses temps comptent à partir de %1</translation>
    </message>
</context>
<context>
    <name>workflow.times_given_twice</name>
    <message>
        <source>camera &apos;%1&apos; was given two tables of frame times</source>
        <translation>deux tables de temps d’images ont été données pour la caméra &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_no_view</name>
    <message>
        <source>there are frame times for camera &apos;%1&apos;, but no video of it</source>
        <translation>il y a des temps d’images pour la caméra &apos;%1&apos;, mais aucune vidéo d’elle</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_other_count</name>
    <message>
        <source>it has %1 times, but the video of view &apos;%2&apos; has %3 frames</source>
        <translation>il a %1 temps, mais la vidéo de la vue &apos;%2&apos; a %3 images</translation>
    </message>
</context>
<context>
    <name>workflow.times_of_view</name>
    <message>
        <source>time stamps of view &apos;%1&apos;</source>
        <translation>horodatages de la vue « %1 »</translation>
    </message>
</context>
<context>
    <name>workflow.track</name>
    <message>
        <source>track %1</source>
        <translation>suivi de %1</translation>
    </message>
</context>
<context>
    <name>workflow.track_it_first</name>
    <message>
        <source>track it first</source>
        <translation>suivez-le d’abord</translation>
    </message>
</context>
<context>
    <name>workflow.track_of_file</name>
    <message>
        <source>the file&apos;s track &apos;%1&apos;</source>
        <translation>trajectoire &apos;%1&apos; du fichier</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_another</name>
    <message>
        <source>track it, or choose another</source>
        <translation>suivez-le, ou choisissez-en un autre</translation>
    </message>
</context>
<context>
    <name>workflow.track_or_choose_with_robot</name>
    <message>
        <source>track it, or choose another with --robot</source>
        <translation>suivez-le, ou choisissez-en un autre</translation>
    </message>
</context>
<context>
    <name>workflow.track_those_seen</name>
    <message>
        <source>track only the robots that are in view (--robot)</source>
        <translation>ne suivez que les robots qui sont dans les images</translation>
    </message>
</context>
<context>
    <name>workflow.tracking</name>
    <message>
        <source>tracking</source>
        <translation>suivi</translation>
    </message>
</context>
<context>
    <name>workflow.tracking_picture</name>
    <message>
        <source>tracking, frame %1 of %2</source>
        <translation>suivi, image %1 sur %2</translation>
    </message>
</context>
<context>
    <name>workflow.tracks_were_imported</name>
    <message>
        <source>its tracks were imported, so it has no video to track</source>
        <translation>ses trajectoires ont été importées, il n’y a donc pas de vidéo à suivre</translation>
    </message>
</context>
<context>
    <name>workflow.trial_being_recorded</name>
    <message>
        <source>trial &apos;%1&apos; is being recorded</source>
        <translation>l’essai &apos;%1&apos; est en cours d’enregistrement</translation>
    </message>
</context>
<context>
    <name>workflow.trial_is_there</name>
    <message>
        <source>the project already has a trial of that name</source>
        <translation>le projet a un essai de ce nom</translation>
    </message>
</context>
<context>
    <name>workflow.trial_left_out</name>
    <message>
        <source>nothing of it had reached the disk, and it was removed</source>
        <translation>rien n’avait atteint le disque, il est écarté</translation>
    </message>
</context>
<context>
    <name>workflow.turn_cameras_to_floor</name>
    <message>
        <source>turn the cameras to the same floor, and register them again</source>
        <translation>tournez les caméras vers le même sol et localisez-les de nouveau</translation>
    </message>
</context>
<context>
    <name>workflow.turn_or_flash</name>
    <message>
        <source>turn the robot, or flash the room light, in view of both cameras</source>
        <translation>faites tourner le robot, ou clignoter la lumière de la salle, là où les deux caméras le voient</translation>
    </message>
</context>
<context>
    <name>workflow.two_mats</name>
    <message>
        <source>the files show mats of different paper</source>
        <translation>les fichiers montrent des tapis de papiers différents</translation>
    </message>
</context>
<context>
    <name>workflow.two_views</name>
    <message>
        <source>views &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>vues &apos;%1&apos; et &apos;%2&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.unequal_files</name>
    <message>
        <source>%1 files of the first camera cannot be paired with %2 of the second one</source>
        <translation>%1 fichiers de la première caméra ne peuvent pas être associés à %2 de la seconde</translation>
    </message>
</context>
<context>
    <name>workflow.unequal_rates</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_frame_rate</name>
    <message>
        <source>its frame rate is not between 0.1 and 100,000 frames a second</source>
        <translation>sa fréquence n’est pas comprise entre 0,1 et 100 000 images par seconde</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_length</name>
    <message>
        <source>the duration must be above zero and at most a day</source>
        <translation>il ne durerait pas, ou plus d’un jour</translation>
    </message>
</context>
<context>
    <name>workflow.unusual_pre_roll</name>
    <message>
        <source>the pre-roll must be from 0 s to 10 s</source>
        <translation>ce qui est gardé d’avant n’est pas une durée, ou dépasse 10 s</translation>
    </message>
</context>
<context>
    <name>workflow.use_as_it_is</name>
    <message>
        <source>use the results as they are</source>
        <translation>utilisez les résultats tels quels</translation>
    </message>
</context>
<context>
    <name>workflow.use_earlier_registration</name>
    <message>
        <source>if it moved before this trial, register it again and reanalyse</source>
        <translation>si elle a bougé avant cet essai, localisez-la de nouveau et relancez l&apos;analyse</translation>
    </message>
</context>
<context>
    <name>workflow.use_frame</name>
    <message>
        <source>use frame %1 of %2</source>
        <translation>utilisation de l’image %1 de %2</translation>
    </message>
</context>
<context>
    <name>workflow.use_frames</name>
    <message>
        <source>use %1 samples of %2</source>
        <translation>utilisation de %1 échantillons de %2</translation>
    </message>
</context>
<context>
    <name>workflow.use_original_or_register</name>
    <message>
        <source>use the file as the camera wrote it, or register the camera again in a frame of this video</source>
        <translation>utilisez le fichier tel que la caméra l’a écrit, ou localisez de nouveau la caméra dans une image de cette vidéo</translation>
    </message>
</context>
<context>
    <name>workflow.use_time_before</name>
    <message>
        <source>use the time before that only</source>
        <translation>n&apos;utilisez que le temps d&apos;avant</translation>
    </message>
</context>
<context>
    <name>workflow.verdict_on</name>
    <message>
        <source>verdict on trial &apos;%1&apos;</source>
        <translation>verdict sur l’essai « %1 »</translation>
    </message>
</context>
<context>
    <name>workflow.video</name>
    <message>
        <source>video &apos;%1&apos;</source>
        <translation>vidéo &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.video_converted</name>
    <message>
        <source>one frame in %1 repeats the one before, because the video was converted to a higher frame rate; its frames were given the times at which they were taken</source>
        <translation>une image sur %1 répète la précédente, car la vidéo a été convertie à une fréquence d&apos;images plus élevée ; ses images ont reçu les temps auxquels elles ont été prises</translation>
    </message>
</context>
<context>
    <name>workflow.video_without_picture</name>
    <message>
        <source>the video has no frame</source>
        <translation>la vidéo n’a pas d’image</translation>
    </message>
</context>
<context>
    <name>workflow.view</name>
    <message>
        <source>view &apos;%1&apos;</source>
        <translation>vue &apos;%1&apos;</translation>
    </message>
</context>
<context>
    <name>workflow.view_begun_later</name>
    <message>
        <source>%1 %2 later</source>
        <translation>%1 %2 plus tard</translation>
    </message>
</context>
<context>
    <name>workflow.view_ended_early</name>
    <message>
        <source>it ended early because %1</source>
        <translation>elle s’est terminée trop tôt, car %1</translation>
    </message>
</context>
<context>
    <name>workflow.view_is_kept</name>
    <message>
        <source>%1 of %2 view were saved, at most the last second is missing</source>
        <translation>%1 de %2 vue sont gardées, tout sauf au plus la dernière seconde</translation>
    </message>
</context>
<context>
    <name>workflow.view_left_out</name>
    <message>
        <source>it recorded nothing and was left out</source>
        <translation>elle est écartée, car rien n’en a été enregistré</translation>
    </message>
</context>
<context>
    <name>workflow.view_not_synchronised</name>
    <message>
        <source>%1 not synchronised</source>
        <translation>%1 non synchronisé</translation>
    </message>
</context>
<context>
    <name>workflow.view_without_sound</name>
    <message>
        <source>view &apos;%1&apos; has no sound</source>
        <translation>la vue &apos;%1&apos; n’a pas de son</translation>
    </message>
</context>
<context>
    <name>workflow.views_are_kept</name>
    <message>
        <source>%1 of %2 views were saved, at most the last second is missing</source>
        <translation>%1 de %2 vues sont gardées, tout sauf au plus la dernière seconde</translation>
    </message>
</context>
<context>
    <name>workflow.views_contradict</name>
    <message>
        <source>in %1 of %2 frames the views contradict each other</source>
        <translation>dans %1 images sur %2, les vues se contredisent</translation>
    </message>
</context>
<context>
    <name>workflow.views_contradict_by</name>
    <message>
        <source>the views contradict each other by %1</source>
        <translation>les vues se contredisent de %1</translation>
    </message>
</context>
<context>
    <name>workflow.views_far_apart</name>
    <message>
        <source>in %1 of %2 frames the views show it at positions far apart</source>
        <translation>dans %1 images sur %2, les vues le placent à des endroits très éloignés</translation>
    </message>
</context>
<context>
    <name>workflow.views_put_it_apart</name>
    <message>
        <source>their floor positions differ by %1</source>
        <translation>elles le placent à %1 d’écart</translation>
    </message>
</context>
<context>
    <name>workflow.waited_for_disk</name>
    <message>
        <source>frames waited up to %1 for the disk, and none was lost</source>
        <translation>des images ont attendu le disque jusqu’à %1, aucune n’a été perdue</translation>
    </message>
</context>
<context>
    <name>workflow.was_not_accepted</name>
    <message>
        <source>nobody accepted it</source>
        <translation>personne ne l’a accepté</translation>
    </message>
</context>
<context>
    <name>workflow.why_views_contradict</name>
    <message>
        <source>a camera has moved since its registration, the views are not synchronised, or the robot&apos;s height is wrong</source>
        <translation>une caméra a été déplacée après sa localisation, les vues ne sont pas synchronisées ou la hauteur du robot n’est pas celle indiquée</translation>
    </message>
</context>
<context>
    <name>workflow.withdraw_acceptance</name>
    <message>
        <source>withdraw the acceptance of %1</source>
        <translation>retirer l’acceptation de %1</translation>
    </message>
</context>
<context>
    <name>workflow.write_address</name>
    <message>
        <source>write it like 224.5.23.2:10006</source>
        <translation>écrivez-la comme 224.5.23.2:10006</translation>
    </message>
</context>
<context>
    <name>workflow.writing_last_pictures</name>
    <message>
        <source>writing the last frames</source>
        <translation>écriture des dernières images</translation>
    </message>
</context>
<context>
    <name>workflow.written_just_now</name>
    <message>
        <source>another program is writing or removing it</source>
        <translation>un autre programme est en train de l’écrire ou de le supprimer</translation>
    </message>
</context>
</TS>
