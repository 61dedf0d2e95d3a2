<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>FromBelow</name>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>driver</source>
        <translation>Treiber</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>workspace</source>
        <translation>Arbeitsraum</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>none: shown as a bar</source>
        <translation>keine: als Balken gezeigt</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>built in</source>
        <translation>eingebaut</translation>
    </message>
    <message>
        <source>to be done anew</source>
        <translation>neu auszuführen</translation>
    </message>
    <message>
        <source>move its handle once through the whole workspace before a trial; no force is shown until then</source>
        <translation>bewegen Sie seinen Griff vor einem Versuch einmal durch den ganzen Arbeitsraum; bis dahin wird keine Kraft gezeigt</translation>
    </message>
    <message>
        <source>to be done by hand</source>
        <translation>von Hand auszuführen</translation>
    </message>
    <message>
        <source>a stylus goes into its ink well, a Falcon&apos;s grip is pulled all the way out and pushed in, before a trial; no force is shown until then</source>
        <translation>vor einem Versuch kommt ein Stift in seine Halterung, der Griff eines Falcon wird ganz herausgezogen und hineingeschoben; bis dahin wird keine Kraft gezeigt</translation>
    </message>
    <message>
        <source>The device works.</source>
        <translation>Das Gerät arbeitet.</translation>
    </message>
    <message>
        <source>The device was pressed against its force limit for too long and switched its force off: ease the hand.</source>
        <translation>Das Gerät wurde zu lange gegen seine Kraftgrenze gedrückt und hat seine Kraft abgeschaltet: Lassen Sie die Hand locker.</translation>
    </message>
    <message>
        <source>The device does not answer: check its cable and its power.</source>
        <translation>Das Gerät antwortet nicht: Prüfen Sie Kabel und Stromversorgung.</translation>
    </message>
    <message>
        <source>The device is unplugged: plug it in again.</source>
        <translation>Das Gerät ist ausgesteckt: Stecken Sie es wieder ein.</translation>
    </message>
    <message>
        <source>The device&apos;s motors are too warm: let it rest for a minute.</source>
        <translation>Die Motoren des Geräts sind zu warm: Lassen Sie es eine Minute ruhen.</translation>
    </message>
    <message>
        <source>A force that is not a number was held back and zero force was sent: please report this trial&apos;s log.</source>
        <translation>Eine Kraft, die keine Zahl ist, wurde zurückgehalten und die Kraft null gesendet: Bitte melden Sie die Aufzeichnung dieses Versuchs.</translation>
    </message>
    <message>
        <source>The servo loop is late: close other programs, and set up real-time priority.</source>
        <translation>Die Regelschleife kommt zu spät: Schließen Sie andere Programme und richten Sie Echtzeitpriorität ein.</translation>
    </message>
    <message>
        <source>The device does not know where it stands: put its pen into the ink well, or move it once to its ends.</source>
        <translation>Das Gerät kennt seine Lage nicht: Stecken Sie den Stift in die Halterung oder führen Sie ihn einmal an seine Enden.</translation>
    </message>
    <message>
        <source>The device&apos;s driver reports an error: unplug it, wait five seconds, plug it in again.</source>
        <translation>Der Gerätetreiber meldet einen Fehler: Ausstecken, fünf Sekunden warten, wieder einstecken.</translation>
    </message>
    <message>
        <source>The device reports an unknown fault.</source>
        <translation>Das Gerät meldet einen unbekannten Fehler.</translation>
    </message>
    <message>
        <source>mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>mouse and keyboard; the force is drawn, not felt</source>
        <translation>Maus und Tastatur; die Kraft wird gezeichnet, nicht gespürt</translation>
    </message>
    <message>
        <source>3D Systems Touch, Touch X and other HDAPI devices; NAME as their set-up calls it</source>
        <translation>3D Systems Touch, Touch X und andere HDAPI-Geräte; NAME wie in ihrer Einrichtung</translation>
    </message>
    <message>
        <source>a Novint Falcon: position and force; its grip does not turn the blade</source>
        <translation>ein Novint Falcon: Lage und Kraft; sein Griff dreht den Spatel nicht</translation>
    </message>
    <message>
        <source>a SpaceMouse: the cap steers by speed; the force is drawn, not felt</source>
        <translation>eine SpaceMouse: Die Kappe steuert durch Geschwindigkeit; die Kraft wird gezeichnet, nicht gespürt</translation>
    </message>
    <message>
        <source>none plugged in</source>
        <translation>nicht angeschlossen</translation>
    </message>
    <message>
        <source>if there is one, check its cable and power</source>
        <translation>falls vorhanden, prüfen Sie Kabel und Stromversorgung</translation>
    </message>
    <message>
        <source>it opens but gives no reading: another program may be using it</source>
        <translation>es lässt sich öffnen, liefert aber keine Werte: Vielleicht benutzt es ein anderes Programm</translation>
    </message>
    <message>
        <source>close the other program; else check the cable and the power</source>
        <translation>schließen Sie das andere Programm; sonst prüfen Sie Kabel und Stromversorgung</translation>
    </message>
    <message>
        <source>no firmware file was found: it works only while it still runs the firmware another program gave it</source>
        <translation>keine Firmware-Datei gefunden: Es arbeitet nur, solange es noch die Firmware eines anderen Programms hat</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>every limit of the scenario was kept</source>
        <translation>jede Grenze des Szenarios wurde eingehalten</translation>
    </message>
    <message>
        <source>Attempt time</source>
        <translation>Dauer des Intubationsversuchs</translation>
    </message>
    <message>
        <source>blade into the mouth to blade out, less pauses; of several the longest</source>
        <translation>Spatel in den Mund bis Spatel heraus, ohne Pausen; von mehreren der längste</translation>
    </message>
    <message>
        <source>Time to first sight</source>
        <translation>Zeit bis zur ersten Sicht</translation>
    </message>
    <message>
        <source>from the attempt&apos;s start to the first sight of as much of the glottis as the scenario asks for</source>
        <translation>vom Beginn des Intubationsversuchs bis zur ersten Sicht auf so viel der Glottis, wie das Szenario verlangt</translation>
    </message>
    <message>
        <source>Best view of the glottis</source>
        <translation>Beste Sicht auf die Glottis</translation>
    </message>
    <message>
        <source>largest share of the glottis in sight (POGO)</source>
        <translation>größter sichtbarer Anteil der Glottis (POGO)</translation>
    </message>
    <message>
        <source>Peak tongue force</source>
        <translation>Höchste Zungenkraft</translation>
    </message>
    <message>
        <source>largest single tick of the model force on the tongue</source>
        <translation>größter Einzelwert der Modellkraft auf die Zunge</translation>
    </message>
    <message>
        <source>Peak gum force</source>
        <translation>Höchste Kraft auf die Zahnleiste</translation>
    </message>
    <message>
        <source>largest single tick of the model force on the gums</source>
        <translation>größter Einzelwert der Modellkraft auf die Zahnleisten</translation>
    </message>
    <message>
        <source>Time over the target force</source>
        <translation>Zeit über der Zielkraft</translation>
    </message>
    <message>
        <source>time with more model force on the tongue than the scenario&apos;s target</source>
        <translation>Zeit mit mehr Modellkraft auf die Zunge, als das Ziel des Szenarios erlaubt</translation>
    </message>
    <message>
        <source>Time over the device limit</source>
        <translation>Zeit über der Gerätegrenze</translation>
    </message>
    <message>
        <source>time in which the device was at its limit, or had let go because of it</source>
        <translation>Zeit, in der das Gerät an seiner Grenze war oder ihretwegen losgelassen hatte</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Intubationsversuche</translation>
    </message>
    <message>
        <source>ways of the blade into the mouth and out</source>
        <translation>Wege des Spatels in den Mund und heraus</translation>
    </message>
    <message>
        <source>Time to pass the tube</source>
        <translation>Zeit bis zur Tubuspassage</translation>
    </message>
    <message>
        <source>from the view (else the attempt&apos;s start) to the tip past the cords, in the decisive attempt</source>
        <translation>von der Sicht (sonst vom Beginn) bis zur Spitze hinter den Stimmlippen, im entscheidenden Intubationsversuch</translation>
    </message>
    <message>
        <source>Lowest saturation</source>
        <translation>Niedrigste Sauerstoffsättigung</translation>
    </message>
    <message>
        <source>displayed, from the first attempt on</source>
        <translation>angezeigt, ab dem ersten Intubationsversuch</translation>
    </message>
    <message>
        <source>Lowest heart rate</source>
        <translation>Niedrigste Herzfrequenz</translation>
    </message>
    <message>
        <source>from the first attempt on</source>
        <translation>ab dem ersten Intubationsversuch</translation>
    </message>
    <message>
        <source>Severe desaturation</source>
        <translation>Schwerer Sättigungsabfall</translation>
    </message>
    <message>
        <source>in any attempt the displayed saturation fell by 20 points or more from the highest before it</source>
        <translation>in einem Intubationsversuch fiel die angezeigte Sättigung um 20 Punkte oder mehr unter den höchsten Wert davor</translation>
    </message>
    <message>
        <source>Bradycardia</source>
        <translation>Bradykardie</translation>
    </message>
    <message>
        <source>in any attempt the heart was below 100 per minute</source>
        <translation>in einem Intubationsversuch lag die Herzfrequenz unter 100 pro Minute</translation>
    </message>
    <message>
        <source>Tube&apos;s depth error</source>
        <translation>Fehler der Tubustiefe</translation>
    </message>
    <message>
        <source>of the tip in larynx or trachea at the end, from the middle of the good third of this infant&apos;s way from the cords to the carina; positive: too deep</source>
        <translation>der Spitze in Kehlkopf oder Trachea am Ende, von der Mitte des guten Drittels des Weges von den Stimmlippen zur Carina dieses Kindes; positiv: zu tief</translation>
    </message>
    <message>
        <source>Mean tongue force</source>
        <translation>Mittlere Zungenkraft</translation>
    </message>
    <message>
        <source>mean of the model force on the tongue over the time in which there was any</source>
        <translation>Mittel der Modellkraft auf die Zunge über die Zeit, in der es eine gab</translation>
    </message>
    <message>
        <source>Tongue force over time</source>
        <translation>Zungenkraft über die Zeit</translation>
    </message>
    <message>
        <source>integral of the model force on the tongue over the trial</source>
        <translation>Integral der Modellkraft auf die Zunge über den Versuch</translation>
    </message>
    <message>
        <source>Peak tongue pressure</source>
        <translation>Höchster Druck auf die Zunge</translation>
    </message>
    <message>
        <source>largest mean pressure over the contact with the tongue in a tick with 0.5 N or more on it: force by the area of the tissue&apos;s surface at rest that the contacts stand for</source>
        <translation>größter mittlerer Druck über die Berührfläche mit der Zunge in einem Takt mit 0,5 N oder mehr: Kraft durch die Fläche der ruhenden Gewebeoberfläche, für die die Kontakte stehen</translation>
    </message>
    <message>
        <source>Lifted, not levered</source>
        <translation>Angehoben, nicht gehebelt</translation>
    </message>
    <message>
        <source>share of the load of tongue and epiglottis, along the handle, that the upper jaw did not bear as a fulcrum</source>
        <translation>Anteil der Last von Zunge und Epiglottis längs des Griffs, den der Oberkiefer nicht als Drehpunkt trug</translation>
    </message>
    <message>
        <source>Peak levered load</source>
        <translation>Höchste gehebelte Last</translation>
    </message>
    <message>
        <source>largest part of that load that the upper jaw bore in a tick</source>
        <translation>größter Teil dieser Last, den der Oberkiefer in einem Takt trug</translation>
    </message>
    <message>
        <source>Peak palate force</source>
        <translation>Höchste Gaumenkraft</translation>
    </message>
    <message>
        <source>largest single tick of the model force on the palate</source>
        <translation>größter Einzelwert der Modellkraft auf den Gaumen</translation>
    </message>
    <message>
        <source>Time to stable view</source>
        <translation>Zeit bis zur stabilen Sicht</translation>
    </message>
    <message>
        <source>from the attempt&apos;s start to the begin of the first 2 s in one piece with as much of the glottis in sight as the scenario asks for; 2 s are assumed</source>
        <translation>vom Beginn des Intubationsversuchs bis zum Beginn der ersten 2 s am Stück mit so viel sichtbarer Glottis, wie das Szenario verlangt; 2 s sind angenommen</translation>
    </message>
    <message>
        <source>Mean view of the glottis</source>
        <translation>Mittlere Sicht auf die Glottis</translation>
    </message>
    <message>
        <source>mean share of the glottis in sight (POGO), over the time in the attempts in which there was any</source>
        <translation>mittlerer sichtbarer Anteil der Glottis (POGO) über die Zeit mit Sicht in den Intubationsversuchen</translation>
    </message>
    <message>
        <source>Cormack-Lehane grade</source>
        <translation>Grad nach Cormack-Lehane</translation>
    </message>
    <message>
        <source>1: more than half of the glottis seen at best, 2: less of it; 3 and 4 are none, for no log knows whether the epiglottis was in sight</source>
        <translation>1: bestenfalls mehr als die Hälfte der Glottis gesehen, 2: weniger; 3 und 4 fehlen, denn keine Aufzeichnung weiß, ob die Epiglottis zu sehen war</translation>
    </message>
    <message>
        <source>Blade&apos;s entry left of the midline</source>
        <translation>Eintritt des Spatels links der Mittellinie</translation>
    </message>
    <message>
        <source>of the tip as it first enters the mouth; negative: to the patient&apos;s right</source>
        <translation>der Spitze beim ersten Eintritt in den Mund; negativ: rechts vom Patienten aus</translation>
    </message>
    <message>
        <source>Blade&apos;s tip from the midline</source>
        <translation>Spatelspitze neben der Mittellinie</translation>
    </message>
    <message>
        <source>distance of the tip from the plane through gum midlines and vallecula when it is nearest to the vallecula</source>
        <translation>Abstand der Spitze von der Ebene durch die Mitten der Zahnleisten und die Vallecula, wenn sie der Vallecula am nächsten ist</translation>
    </message>
    <message>
        <source>Blade&apos;s tip to the vallecula</source>
        <translation>Spatelspitze bis zur Vallecula</translation>
    </message>
    <message>
        <source>least distance of the tip from the vallecula&apos;s landmark at rest</source>
        <translation>kleinster Abstand der Spitze von der Landmarke der ruhenden Vallecula</translation>
    </message>
    <message>
        <source>Vallecula reached</source>
        <translation>Vallecula erreicht</translation>
    </message>
    <message>
        <source>the tip came within 15 % of the way from gums to vallecula of it; assumed</source>
        <translation>die Spitze kam ihr bis auf 15 % des Weges von den Zahnleisten zur Vallecula nahe; angenommen</translation>
    </message>
    <message>
        <source>Blade&apos;s tip past the vallecula</source>
        <translation>Spatelspitze hinter der Vallecula</translation>
    </message>
    <message>
        <source>farthest of the tip beyond the vallecula at rest, along the way from the gums to it</source>
        <translation>am weitesten hinter der ruhenden Vallecula, längs des Weges von den Zahnleisten zu ihr</translation>
    </message>
    <message>
        <source>Entries of the blade</source>
        <translation>Eintritte des Spatels</translation>
    </message>
    <message>
        <source>times the tip came into the mouth after a second or more outside</source>
        <translation>wie oft die Spitze nach einer Sekunde oder mehr außerhalb in den Mund kam</translation>
    </message>
    <message>
        <source>Way of the blade&apos;s tip</source>
        <translation>Weg der Spatelspitze</translation>
    </message>
    <message>
        <source>length of the tip&apos;s way in the attempts, from means of 20 ms</source>
        <translation>Länge des Weges der Spitze in den Intubationsversuchen, aus Mitteln über 20 ms</translation>
    </message>
    <message>
        <source>Smoothness of the hand</source>
        <translation>Gleichmäßigkeit der Hand</translation>
    </message>
    <message>
        <source>spectral arc length of the tip&apos;s speed in an attempt&apos;s longest stretch without a pause (10 Hz, threshold 5 %, padding 4, sampled at 50 Hz)</source>
        <translation>spektrale Bogenlänge der Geschwindigkeit der Spitze im längsten Stück eines Intubationsversuchs ohne Pause (10 Hz, Schwelle 5 %, Auffüllung 4, abgetastet mit 50 Hz)</translation>
    </message>
    <message>
        <source>Tremor of the hand</source>
        <translation>Tremor der Hand</translation>
    </message>
    <message>
        <source>root mean square of the tip&apos;s way from 4 to 12 Hz over the same stretch, three axes together</source>
        <translation>quadratisches Mittel des Weges der Spitze von 4 bis 12 Hz über dasselbe Stück, drei Achsen zusammen</translation>
    </message>
    <message>
        <source>Mean reaction time</source>
        <translation>Mittlere Reaktionszeit</translation>
    </message>
    <message>
        <source>from a question or alarm shown to its answer within the time allowed, right or wrong, less pauses</source>
        <translation>von einer gezeigten Frage oder einem Alarm bis zur Antwort in der erlaubten Zeit, richtig oder falsch, ohne Pausen</translation>
    </message>
    <message>
        <source>Errors in the dual task</source>
        <translation>Fehler in der Zweitaufgabe</translation>
    </message>
    <message>
        <source>wrong answers, and answers to nothing</source>
        <translation>falsche Antworten und Antworten auf nichts</translation>
    </message>
    <message>
        <source>Missed in the dual task</source>
        <translation>Versäumt in der Zweitaufgabe</translation>
    </message>
    <message>
        <source>questions and alarms without an answer in the time allowed</source>
        <translation>Fragen und Alarme ohne Antwort in der erlaubten Zeit</translation>
    </message>
    <message>
        <source>Blade in at the right corner of the mouth or over the middle</source>
        <translation>Spatel am rechten Mundwinkel oder über der Mitte eingeführt</translation>
    </message>
    <message>
        <source>The blade was never in the mouth, or its midline is unknown</source>
        <translation>Der Spatel war nie im Mund, oder die Mittellinie ist unbekannt</translation>
    </message>
    <message>
        <source>Tip in the vallecula</source>
        <translation>Spitze in der Vallecula</translation>
    </message>
    <message>
        <source>The blade was never in the mouth</source>
        <translation>Der Spatel war nie im Mund</translation>
    </message>
    <message>
        <source>Lifted, not levered on the upper jaw</source>
        <translation>Angehoben, nicht am Oberkiefer gehebelt</translation>
    </message>
    <message>
        <source>Too little was lifted to tell</source>
        <translation>Zu wenig angehoben, um es zu beurteilen</translation>
    </message>
    <message>
        <source>Glottis in sight before the tube passed</source>
        <translation>Glottis in Sicht, bevor der Tubus passierte</translation>
    </message>
    <message>
        <source>No tube passed the cords in an attempt</source>
        <translation>Kein Tubus passierte die Stimmlippen in einem Intubationsversuch</translation>
    </message>
    <message>
        <source>Tube seen as it passed between the cords</source>
        <translation>Tubus gesehen, als er zwischen den Stimmlippen passierte</translation>
    </message>
    <message>
        <source>Stylet out before the first breath through the tube</source>
        <translation>Führungsstab vor dem ersten Beatmungshub durch den Tubus gezogen</translation>
    </message>
    <message>
        <source>No breath was given through a tube past the cords</source>
        <translation>Kein Beatmungshub durch einen Tubus hinter den Stimmlippen</translation>
    </message>
    <message>
        <source>Secretions cleared by suction</source>
        <translation>Sekret abgesaugt</translation>
    </message>
    <message>
        <source>Ventilated between attempts</source>
        <translation>Zwischen den Intubationsversuchen beatmet</translation>
    </message>
    <message>
        <source>Breaths before each further attempt</source>
        <translation>Beatmungshübe vor jedem weiteren Intubationsversuch</translation>
    </message>
    <message>
        <source>Place confirmed by the CO2 detector</source>
        <translation>Lage durch den CO2-Detektor bestätigt</translation>
    </message>
    <message>
        <source>Tip at a good depth</source>
        <translation>Spitze in guter Tiefe</translation>
    </message>
    <message>
        <source>Tube in the oesophagus recognised in time</source>
        <translation>Tubus im Ösophagus rechtzeitig erkannt</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>nicht zu sehen</translation>
    </message>
    <message>
        <source>No log can tell</source>
        <translation>Keine Aufzeichnung kann es sagen</translation>
    </message>
    <message>
        <source>Tube, blade, light and suction checked before</source>
        <translation>Tubus, Spatel, Licht und Absaugung vorher geprüft</translation>
    </message>
    <message>
        <source>Handle in the left hand</source>
        <translation>Griff in der linken Hand</translation>
    </message>
    <message>
        <source>Told the team what was seen and done</source>
        <translation>Dem Team gesagt, was gesehen und getan wurde</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::DeviceDialog</name>
    <message>
        <source>Device settings</source>
        <translation>Geräteeinstellungen</translation>
    </message>
    <message>
        <source>Blade&apos;s way</source>
        <translation>Weg des Spatels</translation>
    </message>
    <message>
        <source>the mouse&apos;s way on the picture; + and - change it in a trial</source>
        <translation>Weg der Maus auf dem Bild; + und - ändern ihn im Versuch</translation>
    </message>
    <message>
        <source>stands on the other side</source>
        <translation>steht auf der anderen Seite</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>your hand&apos;s way</source>
        <translation>Weg Ihrer Hand</translation>
    </message>
    <message>
        <source>Device turned</source>
        <translation>Gerät gedreht</translation>
    </message>
    <message>
        <source>against you, anticlockwise seen from above</source>
        <translation>gegen Sie, von oben gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>Linkshändig</translation>
    </message>
    <message>
        <source>turned the other way, first and second button exchanged</source>
        <translation>andersherum gedreht, erste und zweite Taste vertauscht</translation>
    </message>
    <message>
        <source>Clutch button</source>
        <translation>Kupplungstaste</translation>
    </message>
    <message>
        <source>held, it frees your hand: the blade stays where it is</source>
        <translation>gehalten gibt sie Ihre Hand frei: der Spatel bleibt, wo er ist</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Force felt</source>
        <translation>Gespürte Kraft</translation>
    </message>
    <message>
        <source>the force in the patient; automatic: scaled to what the device can show</source>
        <translation>die Kraft im Patienten; automatisch: auf das, was das Gerät zeigen kann</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::DevicesPage</name>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>What is plugged in. The list follows: plug a device in and it appears.</source>
        <translation>Was angeschlossen ist. Die Liste folgt: Ein Gerät erscheint, sobald Sie es anschließen.</translation>
    </message>
    <message>
        <source>Needs</source>
        <translation>Braucht</translation>
    </message>
    <message>
        <source>Looking for devices ...</source>
        <translation>Geräte werden gesucht ...</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Use this one</source>
        <translation>Dieses verwenden</translation>
    </message>
    <message>
        <source>The devices cannot be listed: %1</source>
        <translation>Die Geräte lassen sich nicht auflisten: %1</translation>
    </message>
    <message>
        <source>nothing: ready</source>
        <translation>nichts: bereit</translation>
    </message>
    <message>
        <source>Choose one to see what it needs.</source>
        <translation>Wählen Sie eines, um zu sehen, was es braucht.</translation>
    </message>
    <message>
        <source>%1: ready.</source>
        <translation>%1: bereit.</translation>
    </message>
</context>
</TS>
