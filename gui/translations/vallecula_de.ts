<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AccountTab</name>
    <message>
        <source>Nobody is registered here yet: register as a trainee, or set up the first instructor.</source>
        <translation>Hier ist noch niemand registriert: Registrieren Sie sich als Lernende oder richten Sie die erste Lehrperson ein.</translation>
    </message>
</context>
<context>
    <name>Advice</name>
    <message>
        <source>Draw the tube as soon as six breaths bring no colour and no faster heart: it was in the oesophagus, and that must be known early.</source>
        <translation>Ziehen Sie den Tubus, sobald sechs Beatmungshübe weder Farbe noch eine schnellere Herzfrequenz bringen: Er lag im Ösophagus, und das muss früh erkannt werden.</translation>
    </message>
    <message>
        <source>Watch the tip pass between the cords, and give breaths until the detector tells: the tube went behind the larynx.</source>
        <translation>Sehen Sie zu, wie die Spitze zwischen den Stimmlippen passiert, und beatmen Sie, bis der Detektor es zeigt: Der Tubus ging hinter den Kehlkopf.</translation>
    </message>
    <message>
        <source>Stop when the black mark stands at the cords: deeper, the tube goes into one lung.</source>
        <translation>Halten Sie an, wenn die schwarze Marke an den Stimmlippen steht: Tiefer gelangt der Tubus in eine einzelne Lunge.</translation>
    </message>
    <message>
        <source>Draw the tube back until the black mark stands at the cords, and keep the mark at the lips in mind.</source>
        <translation>Ziehen Sie den Tubus zurück, bis die schwarze Marke an den Stimmlippen steht, und merken Sie sich die Marke an den Lippen.</translation>
    </message>
    <message>
        <source>Bring the tube on until the black mark stands at the cords: a shallow tube slips out when the head moves.</source>
        <translation>Schieben Sie den Tubus vor, bis die schwarze Marke an den Stimmlippen steht: Ein flacher Tubus rutscht heraus, wenn sich der Kopf bewegt.</translation>
    </message>
    <message>
        <source>Take a smaller tube: what does not pass the cricoid with a gentle turn must not be pushed.</source>
        <translation>Nehmen Sie einen kleineren Tubus: Was den Ringknorpel nicht mit sanfter Drehung passiert, darf nicht gedrückt werden.</translation>
    </message>
    <message>
        <source>Wait before closed cords until they open with a breath; closed for long, take the blade out and ventilate.</source>
        <translation>Warten Sie vor geschlossenen Stimmlippen, bis sie sich mit einem Atemzug öffnen; bleiben sie lange geschlossen, nehmen Sie den Spatel heraus und beatmen.</translation>
    </message>
    <message>
        <source>See the glottis first, then take the tube in beside the blade without losing sight of the cords.</source>
        <translation>Stellen Sie zuerst die Glottis ein, dann führen Sie den Tubus neben dem Spatel ein, ohne die Stimmlippen aus dem Blick zu verlieren.</translation>
    </message>
    <message>
        <source>Stop the attempt earlier: the heart slowed down. Blade and tube out, ventilate until it is above 100, then again.</source>
        <translation>Brechen Sie den Intubationsversuch früher ab: Das Herz wurde langsam. Spatel und Tubus heraus, beatmen, bis es über 100 ist, dann erneut.</translation>
    </message>
    <message>
        <source>Give breaths until the saturation is back before each attempt: the display is late, and it goes on falling.</source>
        <translation>Beatmen Sie vor jedem Intubationsversuch, bis die Sättigung zurück ist: Die Anzeige hinkt nach, und sie fällt weiter.</translation>
    </message>
    <message>
        <source>Confirm the tube&apos;s place: give five or six breaths through it and watch the detector before you end.</source>
        <translation>Bestätigen Sie die Lage des Tubus: Geben Sie fünf oder sechs Beatmungshübe hindurch und beobachten Sie den Detektor, bevor Sie beenden.</translation>
    </message>
    <message>
        <source>Turn or draw back where the tube meets resistance; pushing swells the airway it has to go through.</source>
        <translation>Drehen Sie oder ziehen Sie zurück, wo der Tubus auf Widerstand trifft; Drücken lässt den Atemweg anschwellen, durch den er muss.</translation>
    </message>
    <message>
        <source>Prepare more before the blade goes in: tube at hand, throat clear, infant ventilated. Each attempt costs the infant.</source>
        <translation>Bereiten Sie mehr vor, ehe der Spatel eingeht: Tubus zur Hand, Rachen frei, Kind beatmet. Jeder Intubationsversuch belastet das Kind.</translation>
    </message>
    <message>
        <source>Have the tube at the corner of the mouth when the glottis comes into sight: the way from there took too long.</source>
        <translation>Halten Sie den Tubus am Mundwinkel bereit, wenn die Glottis in Sicht kommt: Der Weg von dort dauerte zu lange.</translation>
    </message>
    <message>
        <source>The blade never entered the mouth: bring its tip in at the right corner, then follow the tongue down.</source>
        <translation>Der Spatel war nie im Mund: Führen Sie seine Spitze am rechten Mundwinkel ein und folgen Sie dann der Zunge nach unten.</translation>
    </message>
    <message>
        <source>Lift the whole blade along its handle, to the ceiling and the feet, clear of both gums: turning it about a gum presses there and opens no view.</source>
        <translation>Heben Sie den ganzen Spatel längs des Griffs, zur Decke und zu den Füßen, frei von beiden Zahnleisten: Ihn um eine Zahnleiste zu drehen drückt dort und öffnet keine Sicht.</translation>
    </message>
    <message>
        <source>Stop pressing when the grey blade parts from the steel one: the device is at its limit, and more hand gives no more view.</source>
        <translation>Drücken Sie nicht weiter, wenn sich der graue Spatel vom stählernen trennt: Das Gerät ist an seiner Grenze, und mehr Hand gibt nicht mehr Sicht.</translation>
    </message>
    <message>
        <source>Place the tip deeper in the vallecula before you lift: from there the same view takes less force on the tongue.</source>
        <translation>Setzen Sie die Spitze tiefer in die Vallecula, bevor Sie heben: Von dort braucht dieselbe Sicht weniger Kraft auf die Zunge.</translation>
    </message>
    <message>
        <source>Follow the tongue down to the vallecula before you lift: short of it the lift does not carry the epiglottis away.</source>
        <translation>Folgen Sie der Zunge bis zur Vallecula, bevor Sie heben: Davor nimmt das Heben die Epiglottis nicht mit.</translation>
    </message>
    <message>
        <source>Keep lifting along the handle for a little longer: the view opens from the arytenoids forward.</source>
        <translation>Heben Sie etwas länger längs des Griffs: Die Sicht öffnet sich von den Aryknorpeln nach vorn.</translation>
    </message>
    <message>
        <source>Lower the lift a little once the glottis is in sight: holding the tongue above its target adds force, not view.</source>
        <translation>Senken Sie den Zug etwas, sobald die Glottis in Sicht ist: Die Zunge über ihrem Ziel zu halten bringt Kraft, keine Sicht.</translation>
    </message>
    <message>
        <source>End the attempt at %1 seconds, whatever is to be seen: take the blade out, ventilate, and begin again.</source>
        <translation>Beenden Sie den Intubationsversuch nach %1 Sekunden, was auch immer zu sehen ist: Spatel heraus, beatmen, neu beginnen.</translation>
    </message>
    <message>
        <source>Look at the reasons below and change one of them at a time.</source>
        <translation>Sehen Sie sich die Gründe unten an und ändern Sie jeweils einen.</translation>
    </message>
    <message>
        <source>Well done. Next time keep the blade clear of the gums from beginning to end.</source>
        <translation>Gut gemacht. Halten Sie den Spatel nächstes Mal von Anfang bis Ende frei von den Zahnleisten.</translation>
    </message>
    <message>
        <source>Well done. Next time try for the same view with a gentler lift.</source>
        <translation>Gut gemacht. Versuchen Sie nächstes Mal dieselbe Sicht mit sanfterem Zug.</translation>
    </message>
    <message>
        <source>Well done. Next time go more smoothly, in one motion: the blade went in %1 times.</source>
        <translation>Gut gemacht. Gehen Sie nächstes Mal flüssiger vor, in einer Bewegung: Der Spatel ging %1-mal hinein.</translation>
    </message>
    <message>
        <source>Well done. Do it the same way again.</source>
        <translation>Gut gemacht. Machen Sie es wieder genauso.</translation>
    </message>
    <message>
        <source>The glottis was in sight: take the tube at once then, keep looking at the cords, and bring its tip through them.</source>
        <translation>Die Glottis war zu sehen: Nehmen Sie dann sofort den Tubus, sehen Sie weiter auf die Stimmlippen und führen Sie seine Spitze zwischen ihnen hindurch.</translation>
    </message>
</context>
<context>
    <name>AirwayMarks</name>
    <message>
        <source>good depth</source>
        <translation>gute Tiefe</translation>
    </message>
</context>
<context>
    <name>AuthoringPage</name>
    <message>
        <source>Courses (*.yaml *.yml);;All files (*)</source>
        <translation>Kurse (*.yaml *.yml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1  (cannot be read)</source>
        <translation>%1  (nicht lesbar)</translation>
    </message>
    <message>
        <source>(my copy)</source>
        <translation>(meine Kopie)</translation>
    </message>
</context>
<context>
    <name>Charts</name>
    <message>
        <source>time since the trial began (s)</source>
        <translation>Zeit seit Beginn des Durchgangs (s)</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>peak force on the tongue (N); ● passed, ○ not</source>
        <translation>höchste Kraft auf die Zunge (N); ● bestanden, ○ nicht</translation>
    </message>
    <message>
        <source>cumulative sum; down is success</source>
        <translation>kumulative Summe; abwärts ist Erfolg</translation>
    </message>
    <message>
        <source>competent</source>
        <translation>kompetent</translation>
    </message>
    <message>
        <source>deficient</source>
        <translation>unzureichend</translation>
    </message>
    <message>
        <source>Force over time: %1</source>
        <translation>Kraft über die Zeit: %1</translation>
    </message>
    <message>
        <source>tongue</source>
        <translation>Zunge</translation>
    </message>
    <message>
        <source>gum</source>
        <translation>Zahnleiste</translation>
    </message>
    <message>
        <source>shown by the device</source>
        <translation>vom Gerät gezeigt</translation>
    </message>
    <message>
        <source>force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>seen (%)</source>
        <translation>sichtbar (%)</translation>
    </message>
    <message>
        <source>glottis seen (%)</source>
        <translation>Glottis sichtbar (%)</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>device limit %1 N</source>
        <translation>Gerätegrenze %1 N</translation>
    </message>
    <message>
        <source>counts as in sight from %1 %</source>
        <translation>zählt als in Sicht ab %1 %</translation>
    </message>
    <message>
        <source>first sight, %1 s into the attempt</source>
        <translation>erste Sicht, nach %1 s im Intubationsversuch</translation>
    </message>
    <message>
        <source>gum peak %1 N</source>
        <translation>Höchstwert Zahnleiste %1 N</translation>
    </message>
    <message>
        <source>tongue peak %1 N</source>
        <translation>Höchstwert Zunge %1 N</translation>
    </message>
    <message>
        <source>The monitor: %1</source>
        <translation>Der Monitor: %1</translation>
    </message>
    <message>
        <source>saturation as displayed</source>
        <translation>Sättigung wie angezeigt</translation>
    </message>
    <message>
        <source>as it really was</source>
        <translation>wie sie wirklich war</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>Herz</translation>
    </message>
    <message>
        <source>a breath given</source>
        <translation>ein Beatmungshub</translation>
    </message>
    <message>
        <source>tip in the oesophagus</source>
        <translation>Spitze im Ösophagus</translation>
    </message>
    <message>
        <source>heart (per minute)</source>
        <translation>Herzfrequenz (pro Minute)</translation>
    </message>
    <message>
        <source>not below %1 %</source>
        <translation>nicht unter %1 %</translation>
    </message>
    <message>
        <source>bradycardia below %1</source>
        <translation>Bradykardie unter %1</translation>
    </message>
    <message>
        <source>view</source>
        <translation>Sicht</translation>
    </message>
    <message>
        <source>tube past the cords</source>
        <translation>Tubus hinter den Stimmlippen</translation>
    </message>
    <message>
        <source>CO2: detector yellow</source>
        <translation>CO2: Detektor gelb</translation>
    </message>
    <message>
        <source>lowest %1 %</source>
        <translation>niedrigste %1 %</translation>
    </message>
    <message>
        <source>lowest %1 per minute</source>
        <translation>niedrigste %1 pro Minute</translation>
    </message>
    <message>
        <source>as a device with force would show it (this one shows none)</source>
        <translation>wie ein Gerät mit Kraft sie zeigte (dieses zeigt keine)</translation>
    </message>
    <message>
        <source>first sight</source>
        <translation>erste Sicht</translation>
    </message>
    <message>
        <source>pass limit, tongue %1 N</source>
        <translation>Bestehensgrenze, Zunge %1 N</translation>
    </message>
    <message>
        <source>target, tongue %1 N</source>
        <translation>Ziel, Zunge %1 N</translation>
    </message>
    <message>
        <source>pass limit, gum %1 N</source>
        <translation>Bestehensgrenze, Zahnleiste %1 N</translation>
    </message>
    <message>
        <source>target, gum %1 N</source>
        <translation>Ziel, Zahnleiste %1 N</translation>
    </message>
    <message>
        <source>the display says &lt; %1</source>
        <translation>Anzeige: &lt; %1</translation>
    </message>
    <message>
        <source>lowest: below %1 %</source>
        <translation>niedrigste: unter %1 %</translation>
    </message>
</context>
<context>
    <name>CohortModel</name>
    <message>
        <source>Trainee</source>
        <translation>Lernende</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>kinds of device are never pooled</source>
        <translation>Gerätearten werden nie zusammengefasst</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>whole ones</source>
        <translation>vollständige</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>within two attempts; no pass mark is validated</source>
        <translation>innerhalb von zwei Intubationsversuchen; keine Bestehensgrenze ist validiert</translation>
    </message>
    <message>
        <source>In a row</source>
        <translation>In Folge</translation>
    </message>
    <message>
        <source>successes up to the last trial</source>
        <translation>Erfolge bis zum letzten Durchgang</translation>
    </message>
    <message>
        <source>CUSUM</source>
        <translation>CUSUM</translation>
    </message>
    <message>
        <source>the last verdict of the cumulative sum by the published rule: 80 % success within two attempts (PMC8290971), its other numbers assumed</source>
        <translation>letztes Urteil der kumulativen Summe nach der veröffentlichten Regel: 80 % Erfolg innerhalb von zwei Intubationsversuchen (PMC8290971), ihre übrigen Zahlen angenommen</translation>
    </message>
    <message>
        <source>Cut off</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>interrupted trials: in no other figure</source>
        <translation>unterbrochene Durchgänge: in keiner anderen Zahl</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>when the last trial ended</source>
        <translation>wann der letzte Durchgang endete</translation>
    </message>
    <message>
        <source>changed by an instructor, or begun at the vallecula: in no other figure</source>
        <translation>von einer Lehrperson verändert oder in der Vallecula begonnen: in keiner anderen Größe enthalten</translation>
    </message>
    <message>
        <source>Not counted</source>
        <translation>Nicht gezählt</translation>
    </message>
</context>
<context>
    <name>CourseTree</name>
    <message>
        <source>(no title)</source>
        <translation>(ohne Titel)</translation>
    </message>
</context>
<context>
    <name>Courses</name>
    <message>
        <source>First intubation</source>
        <translation>Erste Intubation</translation>
    </message>
    <message>
        <source>Term infant, 3.2 kg, tube 3.5</source>
        <translation>Reifgeborenes, 3,2 kg, Tubus 3,5</translation>
    </message>
    <message>
        <source>Preterm infant, 1.2 kg, premedicated, tube 2.5</source>
        <translation>Frühgeborenes, 1,2 kg, prämediziert, Tubus 2,5</translation>
    </message>
    <message>
        <source>Delivery room, 3.2 kg, one minute old</source>
        <translation>Kreißsaal, 3,2 kg, eine Minute alt</translation>
    </message>
    <message>
        <source>Term infant, 3.2 kg, secretions before the cords</source>
        <translation>Reifgeborenes, 3,2 kg, Sekret vor den Stimmlippen</translation>
    </message>
    <message>
        <source>Term infant, 3.2 kg, cords that shut when touched</source>
        <translation>Reifgeborenes, 3,2 kg, Stimmlippen, die sich bei Berührung schließen</translation>
    </message>
    <message>
        <source>First steps in laryngoscopy</source>
        <translation>Erste Schritte in der Laryngoskopie</translation>
    </message>
    <message>
        <source>Term infant, 3.2 kg</source>
        <translation>Reifgeborenes, 3,2 kg</translation>
    </message>
    <message>
        <source>Preterm infant, 1.2 kg</source>
        <translation>Frühgeborenes, 1,2 kg</translation>
    </message>
    <message>
        <source>Term infant with a stiff tongue, 3.6 kg</source>
        <translation>Reifgeborenes mit steifer Zunge, 3,6 kg</translation>
    </message>
    <message>
        <source>Neonatal intubation</source>
        <translation>Intubation von Neugeborenen</translation>
    </message>
    <message>
        <source>Handling the blade</source>
        <translation>Umgang mit dem Spatel</translation>
    </message>
    <message>
        <source>Finding the view</source>
        <translation>Die Sicht finden</translation>
    </message>
    <message>
        <source>Passing the tube</source>
        <translation>Den Tubus einführen</translation>
    </message>
    <message>
        <source>Preterm and difficult airway</source>
        <translation>Frühgeborene und schwieriger Atemweg</translation>
    </message>
    <message>
        <source>Under distraction and time</source>
        <translation>Unter Ablenkung und Zeitdruck</translation>
    </message>
    <message>
        <source>The way in</source>
        <translation>Der Weg hinein</translation>
    </message>
    <message>
        <source>Lift, do not lever</source>
        <translation>Anheben, nicht hebeln</translation>
    </message>
    <message>
        <source>A light hand</source>
        <translation>Eine leichte Hand</translation>
    </message>
    <message>
        <source>Term infant</source>
        <translation>Reifgeborenes</translation>
    </message>
    <message>
        <source>No two are the same</source>
        <translation>Keines ist wie das andere</translation>
    </message>
    <message>
        <source>Tube 3.5 on a stylet</source>
        <translation>Tubus 3,5 mit Führungsstab</translation>
    </message>
    <message>
        <source>Tube 3.5 without a stylet</source>
        <translation>Tubus 3,5 ohne Führungsstab</translation>
    </message>
    <message>
        <source>Secretions before the cords</source>
        <translation>Sekret vor den Stimmlippen</translation>
    </message>
    <message>
        <source>Preterm infant, 1.2 kg, premedicated</source>
        <translation>Frühgeborenes, 1,2 kg, prämediziert</translation>
    </message>
    <message>
        <source>Extremely preterm, 0.95 kg</source>
        <translation>Extrem frühgeboren, 0,95 kg</translation>
    </message>
    <message>
        <source>Small mouth, large stiff tongue</source>
        <translation>Kleiner Mund, große steife Zunge</translation>
    </message>
    <message>
        <source>High larynx, long epiglottis</source>
        <translation>Hoher Kehlkopf, lange Epiglottis</translation>
    </message>
    <message>
        <source>Cords that shut when touched</source>
        <translation>Stimmlippen, die sich bei Berührung schließen</translation>
    </message>
    <message>
        <source>Questions meanwhile</source>
        <translation>Fragen nebenher</translation>
    </message>
    <message>
        <source>Alarms and a talking team</source>
        <translation>Alarme und ein redendes Team</translation>
    </message>
    <message>
        <source>Delivery room, one minute old</source>
        <translation>Kreißsaal, eine Minute alt</translation>
    </message>
    <message>
        <source>Bring the blade to the vallecula without resting on the gum, and lift along the handle instead of levering.</source>
        <translation>Den Spatel in die Vallecula führen, ohne sich auf die Zahnleiste zu stützen, und entlang des Griffs anheben statt hebeln.</translation>
    </message>
    <message>
        <source>Bring the glottis into view in term and preterm infants with no more force than it takes.</source>
        <translation>Bei Reif- und Frühgeborenen die Glottis einstellen, mit nicht mehr Kraft als nötig.</translation>
    </message>
    <message>
        <source>Pass the tube under sight within 30 seconds, to a depth that fits this infant, and prove where it lies.</source>
        <translation>Den Tubus innerhalb von 30 Sekunden unter Sicht einführen, so tief, wie es zu diesem Kind passt, und nachweisen, wo er liegt.</translation>
    </message>
    <message>
        <source>Recognise early that an attempt will not succeed, end it, ventilate, and come back.</source>
        <translation>Früh erkennen, dass ein Versuch nicht gelingt, ihn beenden, beatmen und wiederkommen.</translation>
    </message>
    <message>
        <source>Do so while others talk, ask and sound alarms.</source>
        <translation>All das, während andere reden und fragen und Alarme ertönen.</translation>
    </message>
    <message>
        <source>The blade goes in at the right corner, takes the tongue along, and rests on nothing.</source>
        <translation>Der Spatel geht am rechten Mundwinkel hinein, nimmt die Zunge mit und stützt sich auf nichts.</translation>
    </message>
    <message>
        <source>The glottis comes into view in infants of every size, each a little different.</source>
        <translation>Die Glottis kommt bei Kindern jeder Größe in Sicht, jedes ein wenig anders.</translation>
    </message>
    <message>
        <source>The tube passes the cords under sight, to the right depth, and CO2 proves it.</source>
        <translation>Der Tubus passiert die Stimmlippen unter Sicht, liegt richtig tief, und CO2 beweist es.</translation>
    </message>
    <message>
        <source>Small, stiff, narrow or closed: the plan changes before the force does.</source>
        <translation>Klein, steif, eng oder verschlossen: Der Plan ändert sich vor der Kraft.</translation>
    </message>
    <message>
        <source>The hands go on while the head is asked for something else.</source>
        <translation>Die Hände arbeiten weiter, während der Kopf anderes gefragt wird.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg, head in the sniffing position. Hold the handle in the left hand. Enter at the right corner of the mouth, sweep the tongue to the left and bring the tip of the blade into the vallecula. Lift along the handle, to the ceiling and the feet, until at least half (50 %) of the glottis is in sight. Then take the blade out. You have 30 seconds.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, Kopf in Schnüffelstellung. Halten Sie den Griff in der linken Hand. Gehen Sie am rechten Mundwinkel hinein, schieben Sie die Zunge nach links und führen Sie die Spatelspitze in die Vallecula. Heben Sie entlang des Griffs an, zur Decke und zu den Füßen, bis mindestens die Hälfte (50 %) der Glottis in Sicht ist. Dann nehmen Sie den Spatel heraus. Sie haben 30 Sekunden.</translation>
    </message>
    <message>
        <source>The lift opens the view, not a turn of the wrist: turning the blade about the upper gum presses on it and shows less. If the glottis stayed hidden, ask where the tip was: short of the vallecula it lifts the tongue only, beyond it the epiglottis hangs in the way.</source>
        <translation>Die Sicht öffnet das Anheben, nicht ein Drehen des Handgelenks: Wer den Spatel über die obere Zahnleiste dreht, drückt darauf und sieht weniger. Blieb die Glottis verborgen, fragen Sie, wo die Spitze war: Vor der Vallecula hebt sie nur die Zunge, dahinter hängt die Epiglottis im Weg.</translation>
    </message>
    <message>
        <source>A preterm infant of about 29 weeks and 1.2 kg. Everything is smaller: the same movement of your hand is a larger part of the way, and the tongue asks for less force. Blade 0. Bring at least half (50 %) of the glottis into sight within 30 seconds.</source>
        <translation>Ein Frühgeborenes von etwa 29 Wochen und 1,2 kg. Alles ist kleiner: Dieselbe Bewegung Ihrer Hand ist ein größerer Teil des Weges, und die Zunge verlangt weniger Kraft. Spatel 0. Bringen Sie mindestens die Hälfte (50 %) der Glottis innerhalb von 30 Sekunden in Sicht.</translation>
    </message>
    <message>
        <source>In premedicated preterm infants the saturation was below 90 % at 22 seconds after the last breath (median), long before the 30 seconds are over: a calm, short attempt is worth more than a full view. A blade that went past the vallecula has to come back slowly until the epiglottis drops into sight.</source>
        <translation>Bei prämedizierten Frühgeborenen lag die Sättigung 22 Sekunden nach dem letzten Atemzug unter 90 % (Median), lange bevor die 30 Sekunden um sind: Ein ruhiger, kurzer Versuch ist mehr wert als die volle Sicht. Ein Spatel, der an der Vallecula vorbei ist, muss langsam zurück, bis die Epiglottis ins Bild fällt.</translation>
    </message>
    <message>
        <source>A term newborn of 3.6 kg whose tongue resists more than usual. The way is the same; the force will not be. Place the tip well before you lift: a good position is worth more than a strong arm. At least half (50 %) of the glottis, within 30 seconds, and no more force than with a soft tongue.</source>
        <translation>Ein reifes Neugeborenes von 3,6 kg, dessen Zunge mehr Widerstand leistet als sonst. Der Weg ist derselbe, die Kraft nicht. Setzen Sie die Spitze gut, bevor Sie anheben: Eine gute Lage ist mehr wert als ein starker Arm. Mindestens die Hälfte (50 %) der Glottis, innerhalb von 30 Sekunden, und nicht mehr Kraft als bei einer weichen Zunge.</translation>
    </message>
    <message>
        <source>A stiff tongue tempts the hand to press on and to lever. If the force went over its target before anything was to be seen, the tip was not deep enough in the vallecula, or the lift did not follow the handle.</source>
        <translation>Eine steife Zunge verleitet die Hand, weiterzudrücken und zu hebeln. Ging die Kraft über ihr Ziel, bevor etwas zu sehen war, dann lag die Spitze nicht tief genug in der Vallecula, oder das Anheben folgte nicht dem Griff.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg that breathes by itself and is to be ventilated. Its saturation and heart rate are good: it needs no breaths by mask first, but between two attempts; in life it would be given oxygen first. Bring the blade in at the right corner, lift, and see at least 50 % of the glottis. Take the tube in your right hand, enter beside the blade, and watch its tip pass the cords when they open with a breath, until the black mark stands between them. Take the blade out within 30 seconds. Give breaths through the tube and look at the detector.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, das selbst atmet und beatmet werden soll. Sättigung und Herzfrequenz sind gut: Es braucht vorher keine Beatmung mit der Maske, wohl aber zwischen zwei Intubationsversuchen; in Wirklichkeit bekäme es vorher Sauerstoff. Führen Sie den Spatel am rechten Mundwinkel ein, heben Sie an und stellen Sie mindestens 50 % der Glottis ein. Nehmen Sie den Tubus in die rechte Hand, gehen Sie neben dem Spatel hinein und sehen Sie zu, wie seine Spitze die Stimmlippen passiert, wenn sie sich mit einem Atemzug öffnen, bis die schwarze Marke zwischen ihnen steht. Nehmen Sie den Spatel innerhalb von 30 Sekunden heraus. Beatmen Sie durch den Tubus und sehen Sie auf den Detektor.</translation>
    </message>
    <message>
        <source>Saturation on the monitor is ten seconds old: the number you see belongs to the past. A rising heart rate is the first sign of success, a detector that turns yellow the second. If the tube met something hard, it was turned or drawn back, not pushed. Is the tip in the middle third between cords and carina? The mark at the lip is a help, no proof.</source>
        <translation>Die Sättigung auf dem Monitor ist zehn Sekunden alt: Die Zahl, die Sie sehen, gehört der Vergangenheit. Eine steigende Herzfrequenz ist das erste Zeichen des Erfolgs, ein gelber Detektor das zweite. Traf der Tubus auf etwas Hartes, wurde er dann gedreht oder zurückgezogen statt geschoben? Liegt die Spitze im mittleren Drittel zwischen Stimmlippen und Carina? Die Marke an der Lippe ist eine Hilfe, kein Beweis.</translation>
    </message>
    <message>
        <source>A preterm infant of 29 weeks and 1.2 kg, asleep and relaxed: it does not breathe and the cords stand still. The last breath was yours, and the saturation falls sooner than in a larger child. See at least 50 % of the glottis, pass the tube, blade out within 30 seconds. Not there in time? Blade out, ventilate, try again.</source>
        <translation>Ein Frühgeborenes von 29 Wochen und 1,2 kg, schlafend und relaxiert: Es atmet nicht, und die Stimmlippen stehen still. Der letzte Atemzug kam von Ihnen, und die Sättigung fällt früher als bei einem größeren Kind. Stellen Sie mindestens 50 % der Glottis ein, führen Sie den Tubus ein, Spatel innerhalb von 30 Sekunden heraus. Nicht rechtzeitig da? Spatel heraus, beatmen, noch einmal.</translation>
    </message>
    <message>
        <source>Half of such infants were below ninety percent twenty-two seconds after the last breath. An attempt that is given up in time is no failure; one that goes on while the numbers fall is. From cords to carina there are only four centimetres here: a centimetre decides between good, too deep and one lung.</source>
        <translation>Die Hälfte solcher Kinder lag zweiundzwanzig Sekunden nach dem letzten Atemzug unter neunzig Prozent. Ein Versuch, der rechtzeitig aufgegeben wird, ist kein Scheitern; einer, der weitergeht, während die Zahlen fallen, ist eines. Von den Stimmlippen bis zur Carina sind es hier nur vier Zentimeter: Ein Zentimeter entscheidet zwischen gut, zu tief und nur einer Lunge.</translation>
    </message>
    <message>
        <source>A newborn of 3.2 kg, one minute old, that does not breathe. The saturation is low, as it is in every child at that age, and the heart is slow: it needs air more than it needs a tube. Give breaths by mask until the heart is above 100, then intubate: at least 50 % of the glottis, blade out within 30 seconds.</source>
        <translation>Ein Neugeborenes von 3,2 kg, eine Minute alt, das nicht atmet. Die Sättigung ist niedrig, wie bei jedem Kind in diesem Alter, und das Herz ist langsam: Es braucht Luft dringender als einen Tubus. Beatmen Sie mit der Maske, bis das Herz über 100 ist, dann intubieren Sie: mindestens 50 % der Glottis, Spatel innerhalb von 30 Sekunden heraus.</translation>
    </message>
    <message>
        <source>A low number at one minute is normal; a heart that does not rise is not. With too little blood through the lungs the detector stays purple though the tube lies well: look at the chest and the heart before it is pulled.</source>
        <translation>Eine niedrige Zahl nach einer Minute ist normal; ein Herz, das nicht schneller wird, ist es nicht. Fließt zu wenig Blut durch die Lunge, bleibt der Detektor violett, obwohl der Tubus richtig liegt: Sehen Sie auf Brustkorb und Herz, bevor er gezogen wird.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg whose throat is full of fluid: the cords lie below it. Take the suction catheter before the tube, clear the view, then change outside the mouth. At least 50 % of the glottis, blade out within 30 seconds; you may take the blade out and ventilate in between.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, dessen Rachen voll Flüssigkeit ist: Die Stimmlippen liegen darunter. Nehmen Sie vor dem Tubus den Absaugkatheter, machen Sie die Sicht frei und wechseln Sie dann außerhalb des Mundes. Mindestens 50 % der Glottis, Spatel innerhalb von 30 Sekunden heraus; Sie dürfen dazwischen den Spatel herausnehmen und beatmen.</translation>
    </message>
    <message>
        <source>What is not seen cannot be intubated: a tube pushed into fluid finds the oesophagus more often than the trachea. Was the suction ready before the blade went in? Suction costs time and breath; it is done under sight, and shortly.</source>
        <translation>Was nicht zu sehen ist, lässt sich nicht intubieren: Ein Tubus, der in Flüssigkeit geschoben wird, findet öfter den Ösophagus als die Trachea. Lag der Sauger bereit, bevor der Spatel hineinging? Absaugen kostet Zeit und Atem; es geschieht unter Sicht und kurz.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg, awake and without a relaxant. If the tube touches the cords they may shut and stay so. Then do not push: blade out, wait, give breaths by mask as soon as air goes in, and come back. At least 50 % of the glottis, each attempt within 30 seconds.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, wach und ohne Relaxans. Berührt der Tubus die Stimmlippen, können sie sich schließen und so bleiben. Dann nicht schieben: Spatel heraus, warten, mit der Maske beatmen, sobald Luft hineingeht, und wiederkommen. Mindestens 50 % der Glottis, jeder Versuch innerhalb von 30 Sekunden.</translation>
    </message>
    <message>
        <source>Closed cords are stronger than a tube should be. Whoever waits for them to part with a breath touches them less; whoever pushes hurts them and gains nothing. No air goes through while they are shut, by mask neither: the saturation tells of it late, the heart earlier.</source>
        <translation>Geschlossene Stimmlippen sind stärker, als ein Tubus sein sollte. Wer wartet, bis sie sich mit einem Atemzug öffnen, berührt sie weniger; wer schiebt, verletzt sie und gewinnt nichts. Solange sie geschlossen sind, geht keine Luft hindurch, auch mit der Maske nicht: Die Sättigung sagt es spät, das Herz früher.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg, head in the sniffing position.

- Handle in the **left** hand, blade in at the right corner of the mouth.
- Sweep the tongue to the left.
- Bring the tip into the vallecula and lift until 30 % of the glottis is in sight.
- Take the blade out within 40 seconds.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, Kopf in Schnüffelstellung.

- Griff in der **linken** Hand, Spatel am rechten Mundwinkel hinein.
- Schieben Sie die Zunge nach links.
- Führen Sie die Spitze in die Vallecula und heben Sie an, bis 30 % der Glottis in Sicht sind.
- Nehmen Sie den Spatel innerhalb von 40 Sekunden heraus.</translation>
    </message>
    <message>
        <source>This is about where the blade touches. The upper gum is no support: what you felt there is levering. If the
tongue came back over the blade, it was not swept far enough to the left.</source>
        <translation>Hier geht es darum, wo der Spatel berührt. Die obere Zahnleiste ist keine Stütze: Was Sie dort gespürt haben, ist Hebeln. Kam die
Zunge über den Spatel zurück, war sie nicht weit genug nach links geschoben.</translation>
    </message>
    <message>
        <source>The same infant. Once the tip is in the vallecula, move the **whole** blade along its handle, to the ceiling and
the feet, without turning the wrist. At least 50 % of the glottis, blade out within 40 seconds, and the gum left
alone.</source>
        <translation>Dasselbe Kind. Liegt die Spitze in der Vallecula, bewegen Sie den **ganzen** Spatel entlang seines Griffs, zur Decke und
zu den Füßen, ohne das Handgelenk zu drehen. Mindestens 50 % der Glottis, Spatel innerhalb von 40 Sekunden heraus, und die Zahnleiste
bleibt unberührt.</translation>
    </message>
    <message>
        <source>Turning about the upper gum lifts the tip by little and hides the view behind the blade. Look at the two bars:
the tongue&apos;s may rise, the gum&apos;s may not. An expert lifts, waits a moment, and looks.</source>
        <translation>Wer über die obere Zahnleiste dreht, hebt die Spitze nur wenig und verdeckt die Sicht mit dem Spatel. Sehen Sie auf die beiden Balken:
Der der Zunge darf steigen, der der Zahnleiste nicht. Ein Experte hebt an, wartet einen Moment und sieht hin.</translation>
    </message>
    <message>
        <source>A term newborn of 3.4 kg. The view is the same; the force may be less. At least 50 % of the glottis within 30
seconds, and never more than the bar&apos;s mark for long.</source>
        <translation>Ein reifes Neugeborenes von 3,4 kg. Die Sicht ist dieselbe, die Kraft darf geringer sein. Mindestens 50 % der Glottis innerhalb
von 30 Sekunden, und nie lange über der Marke des Balkens.</translation>
    </message>
    <message>
        <source>Force grows with every millimetre beyond the place where the view opens. Whoever places the tip well needs less
of it. A peak while lifting is no fault; holding it is.</source>
        <translation>Die Kraft wächst mit jedem Millimeter über die Stelle hinaus, an der sich die Sicht öffnet. Wer die Spitze gut setzt, braucht
weniger davon. Beim Anheben kurz mehr Kraft zu brauchen ist kein Fehler, sie zu halten schon.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg, another stiffness of the tongue each time. Bring at least 50 % of the glottis into
sight and take the blade out within 30 seconds.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, die Zunge jedes Mal anders steif. Bringen Sie mindestens 50 % der Glottis in
Sicht und nehmen Sie den Spatel innerhalb von 30 Sekunden heraus.</translation>
    </message>
    <message>
        <source>If the glottis stayed hidden, ask where the tip was: short of the vallecula it lifts the tongue only, beyond it
the epiglottis hangs in the way. Coming back slowly lets it drop into sight.</source>
        <translation>Blieb die Glottis verborgen, fragen Sie, wo die Spitze war: Vor der Vallecula hebt sie nur die Zunge, dahinter
hängt die Epiglottis im Weg. Langsam zurück, und sie fällt ins Bild.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg, another one each time: tongue, mouth and epiglottis differ within what is usual. At
least 50 % of the glottis within 30 seconds.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, jedes Mal ein anderes: Zunge, Mund und Epiglottis unterscheiden sich im üblichen Rahmen.
Mindestens 50 % der Glottis innerhalb von 30 Sekunden.</translation>
    </message>
    <message>
        <source>What differed this time? A longer epiglottis asks for a deeper tip, a fuller tongue for a longer sweep, a
narrower mouth for a flatter way in. The order of the steps is always the same.</source>
        <translation>Was war diesmal anders? Eine längere Epiglottis verlangt eine tiefere Spitze, eine vollere Zunge einen weiteren Schwung zur Seite,
ein engerer Mund einen flacheren Weg hinein. Die Reihenfolge der Schritte ist immer dieselbe.</translation>
    </message>
    <message>
        <source>A preterm infant of 29 weeks and 1.2 kg. Everything is smaller: the same movement of your hand is a larger part
of the way, and the tongue asks for less force. At least 50 % of the glottis within 30 seconds.</source>
        <translation>Ein Frühgeborenes von 29 Wochen und 1,2 kg. Alles ist kleiner: Dieselbe Bewegung Ihrer Hand ist ein größerer Teil
des Weges, und die Zunge verlangt weniger Kraft. Mindestens 50 % der Glottis innerhalb von 30 Sekunden.</translation>
    </message>
    <message>
        <source>A blade that went past the vallecula has to come back slowly until the epiglottis drops into sight. A calm,
short attempt is worth more than a full view: premedicated preterm infants were below 90 % at 22 seconds after
the last breath (median).</source>
        <translation>Ein Spatel, der an der Vallecula vorbei ist, muss langsam zurück, bis die Epiglottis ins Bild fällt. Ein ruhiger,
kurzer Versuch ist mehr wert als die volle Sicht: Prämedizierte Frühgeborene lagen 22 Sekunden nach dem letzten
Atemzug unter 90 % (Median).</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg that breathes by itself and is to be ventilated. Its saturation and heart rate are good:
it needs no breaths by mask first, but between two attempts; in life it would be given oxygen first.
See at least 50 % of the glottis, take the tube in
the right hand, enter **beside** the blade, and watch its tip pass the cords until the black mark stands between
them. Blade out within 30 seconds; then breaths through the tube, and look at the detector.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, das selbst atmet und beatmet werden soll. Sättigung und Herzfrequenz sind gut: Es braucht vorher keine Beatmung mit der Maske, wohl aber zwischen zwei Intubationsversuchen; in Wirklichkeit bekäme es vorher Sauerstoff.
Stellen Sie mindestens 50 % der Glottis ein, nehmen Sie den Tubus in die rechte Hand, gehen Sie **neben** dem Spatel hinein und sehen Sie zu, wie seine
Spitze die Stimmlippen passiert, bis die schwarze Marke zwischen ihnen steht. Spatel innerhalb von 30 Sekunden heraus; dann durch den Tubus
beatmen und auf den Detektor sehen.</translation>
    </message>
    <message>
        <source>Saturation on the monitor is about ten seconds old. A rising heart rate is the first sign of success, a detector
that turns yellow the second. If the tube met something hard: was it turned or drawn back?</source>
        <translation>Die Sättigung auf dem Monitor ist etwa zehn Sekunden alt. Eine steigende Herzfrequenz ist das erste Zeichen des Erfolgs,
ein gelber Detektor das zweite. Traf der Tubus auf etwas Hartes: Wurde er gedreht oder zurückgezogen?</translation>
    </message>
    <message>
        <source>The same with a soft tube: it bends where the stylet held it. Let its own curve lead it to the front. At least
50 % of the glottis, blade out within 30 seconds. Afterwards check the depth.</source>
        <translation>Dasselbe mit einem weichen Tubus: Er biegt sich, wo ihn der Führungsstab hielt. Lassen Sie ihn von seiner eigenen Krümmung nach vorn
leiten. Mindestens 50 % der Glottis, Spatel innerhalb von 30 Sekunden heraus. Prüfen Sie danach die Tiefe.</translation>
    </message>
    <message>
        <source>The mark at the lip is a help, no proof: the rules hit the middle of the trachea in about half of all infants.
Is the tip in the middle third between cords and carina? The head&apos;s position moves it: flexion down, extension
up.</source>
        <translation>Die Marke an der Lippe ist eine Hilfe, kein Beweis: Die Regeln treffen die Mitte der Trachea bei etwa der Hälfte aller Kinder.
Liegt die Spitze im mittleren Drittel zwischen Stimmlippen und Carina? Die Haltung des Kopfes bewegt sie: Beugung nach unten, Streckung
nach oben.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg whose throat is full of fluid: the cords lie below it. Suction first, under sight and
shortly, then change outside the mouth. At least 50 % of the glottis, blade out within 30 seconds; you may take
it out and ventilate in between.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, dessen Rachen voll Flüssigkeit ist: Die Stimmlippen liegen darunter. Zuerst absaugen, unter Sicht und
kurz, dann außerhalb des Mundes wechseln. Mindestens 50 % der Glottis, Spatel innerhalb von 30 Sekunden heraus; Sie dürfen ihn
dazwischen herausnehmen und beatmen.</translation>
    </message>
    <message>
        <source>What is not seen cannot be intubated: a tube pushed into fluid finds the oesophagus more often than the trachea.
Was the suction ready before the blade went in?</source>
        <translation>Was nicht zu sehen ist, lässt sich nicht intubieren: Ein Tubus, der in Flüssigkeit geschoben wird, findet öfter den Ösophagus als die
Trachea. Lag der Sauger bereit, bevor der Spatel hineinging?</translation>
    </message>
    <message>
        <source>A preterm infant of 29 weeks and 1.2 kg, asleep and relaxed: it does not breathe and the cords stand still. The
last breath was yours, and the saturation falls sooner than in a larger child. At least 50 % of the glottis,
tube passed, blade out within 30 seconds. Not there in time? Blade out, ventilate, try again.</source>
        <translation>Ein Frühgeborenes von 29 Wochen und 1,2 kg, schlafend und relaxiert: Es atmet nicht, und die Stimmlippen stehen still. Der
letzte Atemzug kam von Ihnen, und die Sättigung fällt früher als bei einem größeren Kind. Mindestens 50 % der Glottis,
Tubus eingeführt, Spatel innerhalb von 30 Sekunden heraus. Nicht rechtzeitig da? Spatel heraus, beatmen, noch einmal.</translation>
    </message>
    <message>
        <source>Half of such infants were below ninety percent 22 seconds after the last breath. An attempt that is given up in
time is no failure; one that goes on while the numbers fall is. From cords to carina there are only four
centimetres: a centimetre decides between good, too deep and one lung.</source>
        <translation>Die Hälfte solcher Kinder lag 22 Sekunden nach dem letzten Atemzug unter neunzig Prozent. Ein Versuch, der rechtzeitig aufgegeben
wird, ist kein Scheitern; einer, der weitergeht, während die Zahlen fallen, ist eines. Von den Stimmlippen bis zur Carina sind es nur vier
Zentimeter: Ein Zentimeter entscheidet zwischen gut, zu tief und nur einer Lunge.</translation>
    </message>
    <message>
        <source>27 weeks, 0.95 kg, premedicated; blade 00 and tube 2.5. Your movements are as large as its mouth: brace your
hand. At least 50 % of the glottis, tube passed, blade out within 30 seconds.</source>
        <translation>27 Wochen, 0,95 kg, prämediziert; Spatel 00 und Tubus 2,5. Ihre Bewegungen sind so groß wie sein Mund: Stützen Sie Ihre
Hand ab. Mindestens 50 % der Glottis, Tubus eingeführt, Spatel innerhalb von 30 Sekunden heraus.</translation>
    </message>
    <message>
        <source>Here the depth is a matter of millimetres, and so is the force. Was the tube seen until its mark had passed? Was
the head back in its neutral place before the depth was judged?</source>
        <translation>Hier geht es bei der Tiefe um Millimeter, und bei der Kraft auch. War der Tubus zu sehen, bis seine Marke hindurch war? War
der Kopf wieder in Neutralstellung, bevor die Tiefe beurteilt wurde?</translation>
    </message>
    <message>
        <source>A term newborn of 3.4 kg with a small mouth and a large tongue that resists. The way is the same; the force will
not be. Place the tip well before you lift. At least 50 % of the glottis, tube passed, blade out within 30
seconds.</source>
        <translation>Ein reifes Neugeborenes von 3,4 kg mit kleinem Mund und großer Zunge, die Widerstand leistet. Der Weg ist derselbe, die Kraft
nicht. Setzen Sie die Spitze gut, bevor Sie anheben. Mindestens 50 % der Glottis, Tubus eingeführt, Spatel innerhalb von 30
Sekunden heraus.</translation>
    </message>
    <message>
        <source>A stiff tongue tempts the hand to press on and to lever. If the force passed its target before anything was to
be seen, the tip was not deep enough in the vallecula, or the lift did not follow the handle. Calling for help
is a step of the plan, not its failure.</source>
        <translation>Eine steife Zunge verleitet die Hand, weiterzudrücken und zu hebeln. Ging die Kraft über ihr Ziel, bevor etwas zu sehen
war, dann lag die Spitze nicht tief genug in der Vallecula, oder das Anheben folgte nicht dem Griff. Hilfe zu rufen
ist ein Schritt des Plans, nicht sein Scheitern.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg whose larynx lies high and whose epiglottis is long. Ask for pressure on the larynx,
extend the head, or move your own eye by two centimetres. At least 50 % of the glottis, tube passed, blade out
within 30 seconds.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, dessen Kehlkopf hoch liegt und dessen Epiglottis lang ist. Bitten Sie um Druck auf den Kehlkopf,
strecken Sie den Kopf, oder bewegen Sie Ihr eigenes Auge um zwei Zentimeter. Mindestens 50 % der Glottis, Tubus eingeführt, Spatel
innerhalb von 30 Sekunden heraus.</translation>
    </message>
    <message>
        <source>Which help opened the view? Pressure from outside brings the cords down into the line of sight; too much of it
closes them. Helps are asked for aloud, one at a time, and taken back when they do nothing.</source>
        <translation>Welche Hilfe hat die Sicht geöffnet? Druck von außen bringt die Stimmlippen in die Blicklinie; zu viel davon schließt
sie. Um Hilfen bittet man laut, eine nach der anderen, und nimmt sie zurück, wenn sie nichts bewirken.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg, awake and without a relaxant. If the tube touches the cords they may shut and stay so.
Then do not push: blade out, wait, give breaths by mask as soon as air goes in, and come back. At least 50 % of
the glottis, each attempt within 30 seconds.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg, wach und ohne Relaxans. Berührt der Tubus die Stimmlippen, können sie sich schließen und so bleiben.
Dann nicht schieben: Spatel heraus, warten, mit der Maske beatmen, sobald Luft hineingeht, und wiederkommen. Mindestens 50 % der
Glottis, jeder Versuch innerhalb von 30 Sekunden.</translation>
    </message>
    <message>
        <source>Closed cords are stronger than a tube should be. Whoever waits for them to part with a breath touches them less;
whoever pushes hurts them and gains nothing. The saturation tells of it late, the heart earlier.</source>
        <translation>Geschlossene Stimmlippen sind stärker, als ein Tubus sein sollte. Wer wartet, bis sie sich mit einem Atemzug öffnen, berührt sie weniger;
wer schiebt, verletzt sie und gewinnt nichts. Die Sättigung sagt es spät, das Herz früher.</translation>
    </message>
    <message>
        <source>A term newborn of 3.2 kg. While you intubate you will be asked; answer without letting the infant wait. At least
50 % of the glottis, tube passed, blade out within 30 seconds.</source>
        <translation>Ein reifes Neugeborenes von 3,2 kg. Während Sie intubieren, werden Sie gefragt; antworten Sie, ohne das Kind warten zu lassen. Mindestens
50 % der Glottis, Tubus eingeführt, Spatel innerhalb von 30 Sekunden heraus.</translation>
    </message>
    <message>
        <source>Which answer came late, and what did the hands do meanwhile? It is right to say &quot;after the tube&quot; to a question
that can wait; it is wrong not to hear it.</source>
        <translation>Welche Antwort kam spät, und was taten die Hände derweil? Auf eine Frage, die warten kann, „nach dem Tubus“ zu sagen, ist richtig;
sie zu überhören ist falsch.</translation>
    </message>
    <message>
        <source>A preterm infant of 29 weeks and 1.2 kg, premedicated. Alarms are to be silenced, talk is to be ignored. At
least 50 % of the glottis, tube passed, blade out within 30 seconds.</source>
        <translation>Ein Frühgeborenes von 29 Wochen und 1,2 kg, prämediziert. Alarme sind stumm zu schalten, Gerede ist zu überhören. Mindestens
50 % der Glottis, Tubus eingeführt, Spatel innerhalb von 30 Sekunden heraus.</translation>
    </message>
    <message>
        <source>Not every alarm is this infant&apos;s. Who was asked to watch the monitor? One who reads the numbers aloud is worth
more than three who talk.</source>
        <translation>Nicht jeder Alarm gehört zu diesem Kind. Wer war gebeten, auf den Monitor zu achten? Jemand, der die Zahlen laut vorliest, ist mehr
wert als drei, die reden.</translation>
    </message>
    <message>
        <source>A newborn of 3.2 kg that does not breathe; the saturation is low, as in every child at that age, and the
heart is slow. It needs air more than it needs a tube: breaths by mask until the heart is above 100, then
intubate. At least 50 % of the glottis, and this time within 25 seconds.</source>
        <translation>Ein Neugeborenes von 3,2 kg, das nicht atmet; die Sättigung ist niedrig, wie bei jedem Kind in diesem Alter, und das
Herz ist langsam. Es braucht Luft dringender als einen Tubus: mit der Maske beatmen, bis das Herz über 100 ist, dann
intubieren. Mindestens 50 % der Glottis, und diesmal innerhalb von 25 Sekunden.</translation>
    </message>
    <message>
        <source>A low number at one minute is normal; a heart that does not rise is not. With too little blood through the lungs
the detector stays purple though the tube lies well: look at the chest and the heart before it is pulled. Thirty
seconds are a ceiling, not a goal.</source>
        <translation>Eine niedrige Zahl nach einer Minute ist normal; ein Herz, das nicht schneller wird, ist es nicht. Fließt zu wenig Blut durch die Lunge,
bleibt der Detektor violett, obwohl der Tubus richtig liegt: Sehen Sie auf Brustkorb und Herz, bevor er gezogen wird. Dreißig
Sekunden sind eine Obergrenze, kein Ziel.</translation>
    </message>
    <message>
        <source>The nurse asks how long it has been. It is 14:40; the first breath was given at 14:32.</source>
        <translation>Die Pflegekraft fragt, wie lange es schon dauert. Es ist 14:40 Uhr; der erste Beatmungshub war um 14:32 Uhr.</translation>
    </message>
    <message>
        <source>6 minutes</source>
        <translation>6 Minuten</translation>
    </message>
    <message>
        <source>8 minutes</source>
        <translation>8 Minuten</translation>
    </message>
    <message>
        <source>12 minutes</source>
        <translation>12 Minuten</translation>
    </message>
    <message>
        <source>Which tube shall I have ready as the next smaller one?</source>
        <translation>Welchen Tubus soll ich als nächstkleineren bereithalten?</translation>
    </message>
    <message>
        <source>The count of breaths stands at 17, and nine more were given. What do I write down?</source>
        <translation>Gezählt sind 17 Beatmungshübe, und neun weitere wurden gegeben. Was schreibe ich auf?</translation>
    </message>
    <message>
        <source>&quot;Bed four is free now, who takes the transport?&quot;</source>
        <translation>„Bett vier ist jetzt frei, wer übernimmt den Transport?“</translation>
    </message>
    <message>
        <source>Infusion pump: end of syringe</source>
        <translation>Infusionspumpe: Spritze leer</translation>
    </message>
    <message>
        <source>&quot;Shall I call the anaesthetist? No? Are you sure?&quot;</source>
        <translation>„Soll ich die Anästhesie rufen? Nein? Sind Sie sicher?“</translation>
    </message>
    <message>
        <source>Incubator: door open</source>
        <translation>Inkubator: Klappe offen</translation>
    </message>
    <message>
        <source>&quot;The parents are outside and ask what is going on.&quot;</source>
        <translation>„Die Eltern sind draußen und fragen, was los ist.“</translation>
    </message>
    <message>
        <source>&quot;One minute.&quot;</source>
        <translation>„Eine Minute.“</translation>
    </message>
    <message>
        <source>Radiant warmer: skin probe off</source>
        <translation>Wärmestrahler: Hautsonde ab</translation>
    </message>
    <message>
        <source>The mother&apos;s obstetrician asks for the weight you estimate.</source>
        <translation>Die Geburtshelferin fragt, welches Gewicht Sie schätzen.</translation>
    </message>
    <message>
        <source>1.2 kg</source>
        <translation>1,2 kg</translation>
    </message>
    <message>
        <source>2.2 kg</source>
        <translation>2,2 kg</translation>
    </message>
    <message>
        <source>3.2 kg</source>
        <translation>3,2 kg</translation>
    </message>
    <message>
        <source>&quot;Two minutes. Does anybody have the heart rate?&quot;</source>
        <translation>„Zwei Minuten. Hat jemand die Herzfrequenz?“</translation>
    </message>
    <message>
        <source>80 % success within two attempts (PMC8290971); unacceptable rate 40 % and both risks 10 % assumed</source>
        <translation>80 % Erfolg innerhalb von zwei Intubationsversuchen (PMC8290971); nicht annehmbare Rate 40 % und beide Risiken 10 % angenommen</translation>
    </message>
    <message>
        <source>assumed: twice running, so that it was no chance</source>
        <translation>angenommen: zweimal hintereinander, damit es kein Zufall war</translation>
    </message>
    <message>
        <source>assumed: three infants running</source>
        <translation>angenommen: drei Kinder hintereinander</translation>
    </message>
    <message>
        <source>assumed: the curriculum names no rule</source>
        <translation>angenommen: der Kurs nennt keine Regel</translation>
    </message>
</context>
<context>
    <name>CurveCharts</name>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>No trial yet.</source>
        <translation>Noch kein Durchgang.</translation>
    </message>
    <message>
        <source>trial %1, %2: %3%4</source>
        <translation>Durchgang %1, %2: %3%4</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>passed from here up</source>
        <translation>bestanden ab hier aufwärts</translation>
    </message>
    <message>
        <source>passed up to here</source>
        <translation>bestanden bis hierher</translation>
    </message>
    <message>
        <source>Cumulative sum (CUSUM) over whole trials</source>
        <translation>Kumulative Summe (CUSUM) über vollständige Durchgänge</translation>
    </message>
    <message>
        <source>No whole trial yet.</source>
        <translation>Noch kein vollständiger Durchgang.</translation>
    </message>
    <message>
        <source>trial %1: %2, sum %3, %4</source>
        <translation>Durchgang %1: %2, Summe %3, %4</translation>
    </message>
    <message>
        <source>success</source>
        <translation>Erfolg</translation>
    </message>
    <message>
        <source>failure</source>
        <translation>Misserfolg</translation>
    </message>
    <message>
        <source>competent below</source>
        <translation>kompetent darunter</translation>
    </message>
    <message>
        <source>not competent above</source>
        <translation>nicht kompetent darüber</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>nicht gezählt</translation>
    </message>
</context>
<context>
    <name>CurveReading</name>
    <message>
        <source>By the rule of the module &quot;%1&quot; (%2), on this scenario alone, and on assessments alone.</source>
        <translation>Nach der Regel des Moduls „%1“ (%2), nur für dieses Szenario und nur für Prüfungen.</translation>
    </message>
    <message>
        <source>By the rule of the module &quot;%1&quot; (%2), on this scenario alone.</source>
        <translation>Nach der Regel des Moduls „%1“ (%2), nur für dieses Szenario.</translation>
    </message>
    <message>
        <source>By the published rule: 80 % success within two attempts (PMC8290971); unacceptable rate and risks are assumed.</source>
        <translation>Nach der veröffentlichten Regel: 80 % Erfolg innerhalb von zwei Intubationsversuchen (PMC8290971); nicht annehmbare Rate und Risiken sind angenommen.</translation>
    </message>
    <message>
        <source>%1 (trial %2)</source>
        <translation>%1 (Durchgang %2)</translation>
    </message>
</context>
<context>
    <name>Direction</name>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>down</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>away from you</source>
        <translation>von Ihnen weg</translation>
    </message>
    <message>
        <source>towards you</source>
        <translation>zu Ihnen hin</translation>
    </message>
</context>
<context>
    <name>DroppedFiles</name>
    <message>
        <source>Drop a CT (its folder, a DICOM, NIfTI, NRRD or MetaImage file), a patient (NAME.patient), a course (.yaml) or a trial (its folder or .vtrial).</source>
        <translation>Legen Sie ein CT (seinen Ordner, eine DICOM-, NIfTI-, NRRD- oder MetaImage-Datei), einen Patienten (NAME.patient), einen Kurs (.yaml) oder einen Durchgang (seinen Ordner oder .vtrial) hier ab.</translation>
    </message>
    <message>
        <source>%1 is no whole patient: it holds no patient.yaml.</source>
        <translation>%1 ist kein ganzer Patient: Es enthält keine patient.yaml.</translation>
    </message>
    <message>
        <source>%1 holds nothing that can be opened here.</source>
        <translation>%1 enthält nichts, was sich hier öffnen lässt.</translation>
    </message>
    <message>
        <source>%1 cannot be opened here.</source>
        <translation>%1 lässt sich hier nicht öffnen.</translation>
    </message>
    <message>
        <source>That is no file.</source>
        <translation>Das ist keine Datei.</translation>
    </message>
    <message>
        <source>%1 is not there.</source>
        <translation>%1 ist nicht da.</translation>
    </message>
    <message>
        <source>These cannot be opened together; drop one of them.</source>
        <translation>Das lässt sich nicht zusammen öffnen; legen Sie eines davon ab.</translation>
    </message>
</context>
<context>
    <name>FieldRow</name>
    <message>
        <source>left out: %1</source>
        <translation>weggelassen: %1</translation>
    </message>
</context>
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
        <translation>keine: als Balken</translation>
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
        <translation>bewegen Sie seinen Griff vor einem Durchgang einmal durch den ganzen Arbeitsraum; bis dahin wird keine Kraft gezeigt</translation>
    </message>
    <message>
        <source>to be done by hand</source>
        <translation>von Hand auszuführen</translation>
    </message>
    <message>
        <source>a stylus goes into its ink well, a Falcon&apos;s grip is pulled all the way out and pushed in, before a trial; no force is shown until then</source>
        <translation>vor einem Durchgang kommt ein Stift in seine Halterung, der Griff eines Falcon wird ganz herausgezogen und hineingeschoben; bis dahin wird keine Kraft gezeigt</translation>
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
        <translation>Eine Kraft, die keine Zahl ist, wurde zurückgehalten und die Kraft null gesendet: Bitte melden Sie die Aufzeichnung dieses Durchgangs.</translation>
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
        <translation>Integral der Modellkraft auf die Zunge über den Durchgang</translation>
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
    <message>
        <source>Glottis seen, at best</source>
        <translation>Glottis sichtbar, bestenfalls</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>mindestens</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>Longest attempt, blade in to blade out</source>
        <translation>Längster Intubationsversuch, Spatel hinein bis heraus</translation>
    </message>
    <message>
        <source>Attempt time, blade in to blade out</source>
        <translation>Dauer des Intubationsversuchs, Spatel hinein bis heraus</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>höchstens</translation>
    </message>
    <message>
        <source>no attempt</source>
        <translation>kein Versuch</translation>
    </message>
    <message>
        <source>Peak force on the tongue</source>
        <translation>Höchste Kraft auf die Zunge</translation>
    </message>
    <message>
        <source>Peak force on the gums</source>
        <translation>Höchste Kraft auf die Zahnleisten</translation>
    </message>
    <message>
        <source>Peak force on the epiglottis</source>
        <translation>Höchste Kraft auf die Epiglottis</translation>
    </message>
    <message>
        <source>Peak force on the palate</source>
        <translation>Höchste Kraft auf den Gaumen</translation>
    </message>
    <message>
        <source>Peak force on the larynx</source>
        <translation>Höchste Kraft auf den Kehlkopf</translation>
    </message>
    <message>
        <source>Paused, which counts for nothing</source>
        <translation>Angehalten, was für nichts zählt</translation>
    </message>
    <message>
        <source>report.html: the monitor&apos;s chart could not be encoded</source>
        <translation>report.html: das Diagramm des Monitors ließ sich nicht kodieren</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Demanded</source>
        <translation>Gefordert</translation>
    </message>
    <message>
        <source>reason not recorded</source>
        <translation>Grund nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>the blade never entered the mouth.</source>
        <translation>der Spatel war nie im Mund.</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>Why it was passed</source>
        <translation>Warum bestanden</translation>
    </message>
    <message>
        <source>Why it was not passed</source>
        <translation>Warum nicht bestanden</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>The monitor</source>
        <translation>Der Monitor</translation>
    </message>
    <message>
        <source>Saturation, heart rate and glottis in sight over time, with attempts, breaths and the tube&apos;s passing marked</source>
        <translation>Sättigung, Herzfrequenz und sichtbare Glottis über die Zeit, mit Intubationsversuchen, Beatmungshüben und der Tubuspassage</translation>
    </message>
    <message>
        <source>Force over time</source>
        <translation>Kraft über die Zeit</translation>
    </message>
    <message>
        <source>Force on tongue and gum over time, with limit, target, peak and first sight marked</source>
        <translation>Kraft auf Zunge und Zahnleiste über die Zeit, mit Grenze, Ziel, Höchstwert und erster Sicht</translation>
    </message>
    <message>
        <source>Debriefing</source>
        <translation>Nachbesprechung</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>How it was recorded</source>
        <translation>Wie aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Servo loop</source>
        <translation>Regelschleife</translation>
    </message>
    <message>
        <source>Real-time set-up</source>
        <translation>Echtzeit-Einrichtung</translation>
    </message>
    <message>
        <source>How it ended</source>
        <translation>Wie es endete</translation>
    </message>
    <message>
        <source>Patient package</source>
        <translation>Patientenpaket</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Cormack-Lehane grade at best</source>
        <translation>Bester Grad nach Cormack-Lehane</translation>
    </message>
    <message>
        <source>3 or 4: nothing of the glottis seen</source>
        <translation>3 oder 4: nichts von der Glottis gesehen</translation>
    </message>
    <message>
        <source>Glottis seen on average, while in sight</source>
        <translation>Glottis im Mittel sichtbar, solange in Sicht</translation>
    </message>
    <message>
        <source>Force on the tongue, mean and over time</source>
        <translation>Kraft auf die Zunge, im Mittel und über die Zeit</translation>
    </message>
    <message>
        <source>Peak pressure on the tongue, over the contact</source>
        <translation>Höchster Druck auf die Zunge, über die Berührfläche</translation>
    </message>
    <message>
        <source>Blade in, from the midline</source>
        <translation>Spatel eingeführt, neben der Mittellinie</translation>
    </message>
    <message>
        <source>Blade&apos;s tip, nearest to the vallecula</source>
        <translation>Spatelspitze, am nächsten an der Vallecula</translation>
    </message>
    <message>
        <source>Blade&apos;s tip then, from the midline</source>
        <translation>Spatelspitze dabei, neben der Mittellinie</translation>
    </message>
    <message>
        <source>Blade&apos;s tip beyond the vallecula</source>
        <translation>Spatelspitze hinter der Vallecula</translation>
    </message>
    <message>
        <source>Questions and alarms</source>
        <translation>Fragen und Alarme</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>verfehlt</translation>
    </message>
    <message>
        <source>answered to nothing</source>
        <translation>auf nichts geantwortet</translation>
    </message>
    <message>
        <source>Reaction to them, on average</source>
        <translation>Reaktion darauf, im Mittel</translation>
    </message>
    <message>
        <source>Tube&apos;s depth, from the middle of the good third</source>
        <translation>Tubustiefe, von der Mitte des guten Drittels</translation>
    </message>
    <message>
        <source>Checklist</source>
        <translation>Checkliste</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Getan</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>met</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>What the log has not seen is left to the instructor. The items are not validated.</source>
        <translation>Was die Aufzeichnung nicht gesehen hat, bleibt der Lehrperson überlassen. Die Punkte sind nicht validiert.</translation>
    </message>
    <message>
        <source>Global rating, by a person:</source>
        <translation>Gesamturteil, durch eine Person:</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Limit by</source>
        <translation>Grenze nach</translation>
    </message>
    <message>
        <source>Points inform; what fails a trial is the mark, whatever its weight.</source>
        <translation>Punkte informieren; nicht bestanden ist, wessen Kriterium verfehlt wurde, gleich welches Gewicht es hat.</translation>
    </message>
    <message>
        <source>not in larynx or trachea</source>
        <translation>nicht in Kehlkopf oder Trachea</translation>
    </message>
    <message>
        <source>nothing touched</source>
        <translation>nichts berührt</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>The blade never entered the mouth.</source>
        <translation>Der Spatel war nie im Mund.</translation>
    </message>
    <message>
        <source>attempt</source>
        <translation>Intubationsversuch</translation>
    </message>
    <message>
        <source>Tip&apos;s depth</source>
        <translation>Tiefe der Spitze</translation>
    </message>
    <message>
        <source>Time to view, blade in to glottis in sight</source>
        <translation>Zeit bis zur Sicht, Spatel hinein bis Glottis in Sicht</translation>
    </message>
    <message>
        <source>Time to pass, view to cords passed</source>
        <translation>Zeit bis zur Passage, Sicht bis hinter die Stimmlippen</translation>
    </message>
    <message>
        <source>passed before the blade was in</source>
        <translation>passiert, bevor der Spatel im Mund war</translation>
    </message>
    <message>
        <source>Lowest saturation, displayed</source>
        <translation>Niedrigste Sättigung, angezeigt</translation>
    </message>
    <message>
        <source>CO2 detector</source>
        <translation>CO2-Detektor</translation>
    </message>
    <message>
        <source>yellow by breath</source>
        <translation>gelb bis Beatmung</translation>
    </message>
    <message>
        <source>Breaths given, mask and tube</source>
        <translation>Beatmungshübe, Maske und Tubus</translation>
    </message>
    <message>
        <source>Tip in the oesophagus</source>
        <translation>Spitze im Ösophagus</translation>
    </message>
    <message>
        <source>Secretions</source>
        <translation>Sekret</translation>
    </message>
    <message>
        <source>From, to (s)</source>
        <translation>Von, bis (s)</translation>
    </message>
    <message>
        <source>Took</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Breaths before</source>
        <translation>Beatmungen davor</translation>
    </message>
    <message>
        <source>To view</source>
        <translation>Bis Sicht</translation>
    </message>
    <message>
        <source>To pass</source>
        <translation>Bis Passage</translation>
    </message>
    <message>
        <source>Saturation, before and lowest</source>
        <translation>Sättigung, davor und niedrigste</translation>
    </message>
    <message>
        <source>Lowest heart</source>
        <translation>Niedrigste Herzfrequenz</translation>
    </message>
    <message>
        <source>severe desaturation</source>
        <translation>schwerer Sättigungsabfall</translation>
    </message>
    <message>
        <source>bradycardia</source>
        <translation>Bradykardie</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Where the mark comes from</source>
        <translation>Woher das Kriterium kommt</translation>
    </message>
    <message>
        <source>This trial was cut off: what stands here is what was recorded until then.</source>
        <translation>Dieser Durchgang wurde abgebrochen: Hier steht, was bis dahin aufgezeichnet wurde.</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Über die Zeit</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>Takte</translation>
    </message>
    <message>
        <source>Trials of nobody</source>
        <translation>Durchgänge ohne Zuordnung</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>By scenario and device</source>
        <translation>Nach Szenario und Gerät</translation>
    </message>
    <message>
        <source>Curriculum</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Cut off</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>CUSUM says competent</source>
        <translation>Nach CUSUM kompetent</translation>
    </message>
    <message>
        <source>Passed: every mark met, within the attempts of the rule, which each curve names (two by the published one). Figures of different kinds of device are never put together.</source>
        <translation>Bestanden: jedes Kriterium erfüllt, innerhalb der Intubationsversuche der Regel, die jede Kurve nennt (zwei nach der veröffentlichten). Zahlen verschiedener Gerätearten werden nie zusammengefasst.</translation>
    </message>
    <message>
        <source>Learning curves</source>
        <translation>Lernkurven</translation>
    </message>
    <message>
        <source>All trials</source>
        <translation>Alle Durchgänge</translation>
    </message>
    <message>
        <source>Finished (UTC)</source>
        <translation>Beendet (UTC)</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Tubus</translation>
    </message>
    <message>
        <source>Attempt (s)</source>
        <translation>Versuch (s)</translation>
    </message>
    <message>
        <source>Tongue (N)</source>
        <translation>Zunge (N)</translation>
    </message>
    <message>
        <source>Tip past the cords</source>
        <translation>Spitze hinter den Stimmlippen</translation>
    </message>
    <message>
        <source>Lowest SpO2</source>
        <translation>Niedrigste SpO2</translation>
    </message>
    <message>
        <source>Time to view</source>
        <translation>Zeit bis Sicht</translation>
    </message>
    <message>
        <source>Time to pass</source>
        <translation>Zeit bis Passage</translation>
    </message>
    <message>
        <source>In the oesophagus</source>
        <translation>Im Ösophagus</translation>
    </message>
    <message>
        <source>Peak force, tongue</source>
        <translation>Höchste Kraft, Zunge</translation>
    </message>
    <message>
        <source>Peak force, gum</source>
        <translation>Höchste Kraft, Zahnleiste</translation>
    </message>
    <message>
        <source>Glottis visible, best</source>
        <translation>Glottis sichtbar, bestenfalls</translation>
    </message>
    <message>
        <source>Time to sight</source>
        <translation>Zeit bis Sicht</translation>
    </message>
    <message>
        <source>Longest attempt</source>
        <translation>Längster Versuch</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Intubationsversuch</translation>
    </message>
    <message>
        <source>Over the device limit</source>
        <translation>Über der Gerätegrenze</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>not there</source>
        <translation>nicht dort</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>gelb</translation>
    </message>
    <message>
        <source>never yellow</source>
        <translation>nie gelb</translation>
    </message>
    <message>
        <source>recognised late</source>
        <translation>spät erkannt</translation>
    </message>
    <message>
        <source>by breath</source>
        <translation>bis Beatmung</translation>
    </message>
    <message>
        <source>at most %1 N</source>
        <translation>höchstens %1 N</translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation>höchstens %1 s</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>at least %1 %</source>
        <translation>mindestens %1 %</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>at least %1 1/min</source>
        <translation>mindestens %1 1/min</translation>
    </message>
    <message>
        <source>at least %1 /min</source>
        <translation>mindestens %1 /min</translation>
    </message>
    <message>
        <source>by breath %1</source>
        <translation>bis Beatmung %1</translation>
    </message>
    <message>
        <source>yellow by breath %1</source>
        <translation>gelb bis Beatmung %1</translation>
    </message>
    <message>
        <source>yellow, breath %1</source>
        <translation>gelb, Beatmung %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>from %1 %</source>
        <translation>ab %1 %</translation>
    </message>
    <message>
        <source>%1 breaths</source>
        <translation>%1 Beatmungen</translation>
    </message>
    <message>
        <source>%1 % of the way; good: %2 to %3 %</source>
        <translation>%1 % des Weges; gut: %2 bis %3 %</translation>
    </message>
    <message>
        <source>%1 N, at %2 s</source>
        <translation>%1 N, bei %2 s</translation>
    </message>
    <message>
        <source>%1 %, at %2 s</source>
        <translation>%1 %, bei %2 s</translation>
    </message>
    <message>
        <source>%1 per minute, at %2 s</source>
        <translation>%1 pro Minute, bei %2 s</translation>
    </message>
    <message>
        <source>%1 per minute</source>
        <translation>%1 pro Minute</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>1 trial</source>
        <translation>1 Durchgang</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 Durchgänge</translation>
    </message>
    <message>
        <source>Trainee %1</source>
        <translation>Lernende Nr. %1</translation>
    </message>
    <message>
        <source>at trial %1</source>
        <translation>bei Durchgang %1</translation>
    </message>
    <message>
        <source>limit %1 N</source>
        <translation>Grenze %1 N</translation>
    </message>
    <message>
        <source>%1, %2 deadline misses, %3 simulation steps dropped</source>
        <translation>%1, %2 verpasste Termine, %3 verworfene Simulationsschritte</translation>
    </message>
    <message>
        <source>Points: %1 of %2</source>
        <translation>Punkte: %1 von %2</translation>
    </message>
    <message>
        <source>Time to glottis in sight (%1 %)</source>
        <translation>Zeit bis Glottis in Sicht (%1 %)</translation>
    </message>
    <message>
        <source>Time over the training target (tongue, %1 N)</source>
        <translation>Zeit über dem Trainingsziel (Zunge, %1 N)</translation>
    </message>
    <message>
        <source>Time over the device limit (%1 N)</source>
        <translation>Zeit über der Gerätegrenze (%1 N)</translation>
    </message>
    <message>
        <source>Time to a stable view (%1 s in one piece)</source>
        <translation>Zeit bis zur stabilen Sicht (%1 s am Stück)</translation>
    </message>
    <message>
        <source>the glottis came into sight after %1 s (%2 % at best)</source>
        <translation>die Glottis kam nach %1 s in Sicht (bestenfalls %2 %)</translation>
    </message>
    <message>
        <source>the glottis never came into sight (%1 % at best)</source>
        <translation>die Glottis kam nie in Sicht (bestenfalls %1 %)</translation>
    </message>
    <message>
        <source>with at most %1 N on the tongue and %2 N on the gums</source>
        <translation>mit höchstens %1 N auf die Zunge und %2 N auf die Zahnleisten</translation>
    </message>
    <message>
        <source>in an attempt of %1 s.</source>
        <translation>in einem Intubationsversuch von %1 s.</translation>
    </message>
    <message>
        <source>with at most %1 N on the tongue and %2 N along the tube.</source>
        <translation>mit höchstens %1 N auf die Zunge und %2 N längs des Tubus.</translation>
    </message>
    <message>
        <source>%1 attempt of %2 s</source>
        <translation>%1 Intubationsversuch von %2 s</translation>
    </message>
    <message>
        <source>%1 attempts, the longest of %2 s</source>
        <translation>%1 Intubationsversuche, der längste von %2 s</translation>
    </message>
    <message>
        <source>An attempt is one way of the blade into the mouth and out. Its lowest values count until the next one begins, for the display is late. Severe desaturation: %1 points or more. Bradycardia: below %2 per minute (both NEAR4NEOS).</source>
        <translation>Ein Intubationsversuch ist ein Weg des Spatels in den Mund und heraus. Seine niedrigsten Werte zählen, bis der nächste beginnt, denn die Anzeige hinkt nach. Schwerer Sättigungsabfall: %1 Punkte oder mehr. Bradykardie: unter %2 pro Minute (beides NEAR4NEOS).</translation>
    </message>
    <message>
        <source>%1 mm to the left</source>
        <translation>%1 mm nach links</translation>
    </message>
    <message>
        <source>%1 mm to the right</source>
        <translation>%1 mm nach rechts</translation>
    </message>
    <message>
        <source>%1 % lifted</source>
        <translation>%1 % angehoben</translation>
    </message>
    <message>
        <source>%1 % lifted, at most %2 N levered, at %3 s</source>
        <translation>%1 % angehoben, höchstens %2 N gehebelt, bei %3 s</translation>
    </message>
    <message>
        <source>%1 mm, at %2 s: reached</source>
        <translation>%1 mm, bei %2 s: erreicht</translation>
    </message>
    <message>
        <source>%1 mm, at %2 s: not reached</source>
        <translation>%1 mm, bei %2 s: nicht erreicht</translation>
    </message>
    <message>
        <source>%1 kPa, at %2 s</source>
        <translation>%1 kPa, bei %2 s</translation>
    </message>
    <message>
        <source>%1 s, at %2 s</source>
        <translation>%1 s, bei %2 s</translation>
    </message>
    <message>
        <source>%1 N, %2 N s in %3 s</source>
        <translation>%1 N, %2 N s in %3 s</translation>
    </message>
    <message>
        <source>%1 mm deeper</source>
        <translation>%1 mm tiefer</translation>
    </message>
    <message>
        <source>%1 mm shallower</source>
        <translation>%1 mm flacher</translation>
    </message>
    <message>
        <source>%1 right, %2 wrong, %3 missed</source>
        <translation>%1 richtig, %2 falsch, %3 versäumt</translation>
    </message>
    <message>
        <source>%1 Hz over %2 ticks, %3 deadline misses, %4 simulation steps dropped</source>
        <translation>%1 Hz über %2 Takte, %3 verpasste Termine, %4 verworfene Simulationsschritte</translation>
    </message>
    <message>
        <source>%1 ticks of %2 ms, not in real time</source>
        <translation>%1 Takte von %2 ms, nicht in Echtzeit</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>the scenario&apos;s time was over</source>
        <translation>die Zeit des Szenarios war um</translation>
    </message>
    <message>
        <source>the device did not come back</source>
        <translation>das Gerät kam nicht zurück</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>reset</source>
        <translation>zurückgesetzt</translation>
    </message>
    <message>
        <source>practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>assessment</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>competent</source>
        <translation>kompetent</translation>
    </message>
    <message>
        <source>not competent</source>
        <translation>nicht kompetent</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>unentschieden</translation>
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
        <source>unsafe</source>
        <translation>unsicher</translation>
    </message>
    <message>
        <source>with help at every step</source>
        <translation>mit Hilfe bei jedem Schritt</translation>
    </message>
    <message>
        <source>with help at some steps</source>
        <translation>mit Hilfe bei einigen Schritten</translation>
    </message>
    <message>
        <source>alone, with flaws</source>
        <translation>allein, mit Mängeln</translation>
    </message>
    <message>
        <source>alone and well</source>
        <translation>allein und gut</translation>
    </message>
    <message>
        <source>good depth</source>
        <translation>gute Tiefe</translation>
    </message>
    <message>
        <source>too shallow</source>
        <translation>zu flach</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>zu tief</translation>
    </message>
    <message>
        <source>oesophagus</source>
        <translation>Ösophagus</translation>
    </message>
    <message>
        <source>mainstem</source>
        <translation>Hauptbronchus</translation>
    </message>
    <message>
        <source>cricoid too narrow</source>
        <translation>Ringknorpel zu eng</translation>
    </message>
    <message>
        <source>cords closed</source>
        <translation>Stimmlippen geschlossen</translation>
    </message>
    <message>
        <source>out of time</source>
        <translation>Zeit abgelaufen</translation>
    </message>
    <message>
        <source>abandoned</source>
        <translation>aufgegeben</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>person deleted</source>
        <translation>Person gelöscht</translation>
    </message>
    <message>
        <source>data exported</source>
        <translation>Daten exportiert</translation>
    </message>
    <message>
        <source>note removed</source>
        <translation>Notiz entfernt</translation>
    </message>
    <message>
        <source>PIN changed</source>
        <translation>PIN geändert</translation>
    </message>
    <message>
        <source>PIN reset</source>
        <translation>PIN zurückgesetzt</translation>
    </message>
    <message>
        <source>renamed</source>
        <translation>umbenannt</translation>
    </message>
    <message>
        <source>trial rated</source>
        <translation>Durchgang bewertet</translation>
    </message>
    <message>
        <source>registered</source>
        <translation>registriert</translation>
    </message>
    <message>
        <source>signed in</source>
        <translation>angemeldet</translation>
    </message>
    <message>
        <source>wrong PIN</source>
        <translation>falsche PIN</translation>
    </message>
    <message>
        <source>at the device&apos;s limit</source>
        <translation>an der Grenze des Geräts</translation>
    </message>
    <message>
        <source>tube&apos;s tip past the cords</source>
        <translation>Tubusspitze hinter den Stimmlippen</translation>
    </message>
    <message>
        <source>tube&apos;s tip in the oesophagus</source>
        <translation>Tubusspitze im Ösophagus</translation>
    </message>
    <message>
        <source>CO2 detector yellow</source>
        <translation>CO2-Detektor gelb</translation>
    </message>
    <message>
        <source>heart below 100 a minute</source>
        <translation>Herzfrequenz unter 100 pro Minute</translation>
    </message>
    <message>
        <source>a breath given</source>
        <translation>ein Beatmungshub</translation>
    </message>
    <message>
        <source>glottis in sight</source>
        <translation>Glottis in Sicht</translation>
    </message>
    <message>
        <source>the device sent a pose that is no position and rotation; no force was shown</source>
        <translation>das Gerät sandte eine Lage, die weder Ort noch Drehung ist; es wurde keine Kraft gezeigt</translation>
    </message>
    <message>
        <source>the tissue&apos;s motion was no longer finite; it was put back to rest and no force was shown</source>
        <translation>die Bewegung des Gewebes war nicht mehr endlich; es wurde in Ruhe zurückversetzt und keine Kraft gezeigt</translation>
    </message>
    <message>
        <source>a force was not finite; none was shown</source>
        <translation>eine Kraft war nicht endlich; es wurde keine gezeigt</translation>
    </message>
    <message>
        <source>The recorded hand was paused here; it goes on by itself.</source>
        <translation>Die aufgezeichnete Hand hatte hier eine Pause; sie geht von selbst weiter.</translation>
    </message>
    <message>
        <source>The device is back. To go on press Enter or a button of the device, or hold the grey blade on the steel one for half a second.</source>
        <translation>Das Gerät ist zurück. Um fortzufahren, drücken Sie Enter oder eine Taste des Geräts, oder halten Sie den grauen Spatel eine halbe Sekunde auf dem stählernen.</translation>
    </message>
    <message>
        <source>stopped before its end</source>
        <translation>vor seinem Ende angehalten</translation>
    </message>
    <message>
        <source>This trial was an assessment: it is not replayed, so that nobody practises on what is assessed.</source>
        <translation>Dieser Durchgang war eine Prüfung: Er wird nicht wiedergegeben, damit niemand an dem übt, was geprüft wird.</translation>
    </message>
    <message>
        <source>Reading the trial</source>
        <translation>Der Durchgang wird gelesen</translation>
    </message>
    <message>
        <source>Looking for the patient</source>
        <translation>Der Patient wird gesucht</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>Wird bewertet</translation>
    </message>
    <message>
        <source>Building the scene</source>
        <translation>Die Szene wird aufgebaut</translation>
    </message>
    <message>
        <source>Light and colour</source>
        <translation>Licht und Farbe</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>tongue force over its training target of %1 N</source>
        <translation>Zungenkraft über ihrem Trainingsziel von %1 N</translation>
    </message>
    <message>
        <source>attempt begins: blade into the mouth</source>
        <translation>Intubationsversuch beginnt: Spatel in den Mund</translation>
    </message>
    <message>
        <source>attempt ends: blade out</source>
        <translation>Intubationsversuch endet: Spatel heraus</translation>
    </message>
    <message>
        <source>attempt %1 begins: blade into the mouth</source>
        <translation>Intubationsversuch %1 beginnt: Spatel in den Mund</translation>
    </message>
    <message>
        <source>attempt %1 ends: blade out</source>
        <translation>Intubationsversuch %1 endet: Spatel heraus</translation>
    </message>
    <message>
        <source>peak force along the tube, %1 N</source>
        <translation>höchste Kraft längs des Tubus, %1 N</translation>
    </message>
    <message>
        <source>peak force on the tongue, %1 N</source>
        <translation>höchste Kraft auf die Zunge, %1 N</translation>
    </message>
    <message>
        <source>peak force on the gum, %1 N</source>
        <translation>höchste Kraft auf die Zahnleiste, %1 N</translation>
    </message>
    <message>
        <source>question begins</source>
        <translation>Frage beginnt</translation>
    </message>
    <message>
        <source>alarm begins</source>
        <translation>Alarm beginnt</translation>
    </message>
    <message>
        <source>talk begins</source>
        <translation>Gespräch beginnt</translation>
    </message>
    <message>
        <source>question silenced</source>
        <translation>Frage stumm geschaltet</translation>
    </message>
    <message>
        <source>alarm silenced</source>
        <translation>Alarm stumm geschaltet</translation>
    </message>
    <message>
        <source>question answered rightly</source>
        <translation>Frage richtig beantwortet</translation>
    </message>
    <message>
        <source>question answered wrongly</source>
        <translation>Frage falsch beantwortet</translation>
    </message>
    <message>
        <source>question missed</source>
        <translation>Frage versäumt</translation>
    </message>
    <message>
        <source>alarm missed</source>
        <translation>Alarm versäumt</translation>
    </message>
    <message>
        <source>from %1 s on the tissue&apos;s shape may be a little different from what it was</source>
        <translation>ab %1 s kann die Form des Gewebes etwas anders sein, als sie war</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>skull</source>
        <translation>Schädel</translation>
    </message>
    <message>
        <source>mandible</source>
        <translation>Unterkiefer</translation>
    </message>
    <message>
        <source>tongue</source>
        <translation>Zunge</translation>
    </message>
    <message>
        <source>epiglottis</source>
        <translation>Epiglottis</translation>
    </message>
    <message>
        <source>airway</source>
        <translation>Atemweg</translation>
    </message>
    <message>
        <source>larynx</source>
        <translation>Kehlkopf</translation>
    </message>
    <message>
        <source>soft palate</source>
        <translation>weicher Gaumen</translation>
    </message>
    <message>
        <source>spine</source>
        <translation>Wirbelsäule</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>inferred</source>
        <translation>abgeleitet</translation>
    </message>
    <message>
        <source>given</source>
        <translation>gegeben</translation>
    </message>
    <message>
        <source>template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Airway</source>
        <translation>Atemweg</translation>
    </message>
    <message>
        <source>upper gum midline</source>
        <translation>Mitte der oberen Zahnleiste</translation>
    </message>
    <message>
        <source>lower gum midline</source>
        <translation>Mitte der unteren Zahnleiste</translation>
    </message>
    <message>
        <source>vallecula</source>
        <translation>Vallecula</translation>
    </message>
    <message>
        <source>glottis centre</source>
        <translation>Mitte der Glottis</translation>
    </message>
    <message>
        <source>glottis normal</source>
        <translation>Richtung der Glottis</translation>
    </message>
    <message>
        <source>operator eye</source>
        <translation>Auge der Intubierenden</translation>
    </message>
    <message>
        <source>hyoid</source>
        <translation>Zungenbein</translation>
    </message>
    <message>
        <source>carina</source>
        <translation>Carina</translation>
    </message>
    <message>
        <source>condyle axis</source>
        <translation>Kiefergelenkachse</translation>
    </message>
    <message>
        <source>epiglottis tip</source>
        <translation>Spitze der Epiglottis</translation>
    </message>
    <message>
        <source>To be checked first</source>
        <translation>Zuerst zu prüfen</translation>
    </message>
    <message>
        <source>Within limits</source>
        <translation>Innerhalb der Grenzen</translation>
    </message>
    <message>
        <source>For information</source>
        <translation>Zur Information</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>tetrahedra volume</source>
        <translation>Volumen der Tetraeder</translation>
    </message>
    <message>
        <source>volume kept by the tetrahedra</source>
        <translation>von den Tetraedern erhaltenes Volumen</translation>
    </message>
    <message>
        <source>smallest dihedral angle</source>
        <translation>kleinster Diederwinkel</translation>
    </message>
    <message>
        <source>tetrahedra below 10 degrees</source>
        <translation>Tetraeder unter 10 Grad</translation>
    </message>
    <message>
        <source>shortest edge</source>
        <translation>kürzeste Kante</translation>
    </message>
    <message>
        <source>tongue inside the jaw&apos;s bone</source>
        <translation>Zunge im Kieferknochen</translation>
    </message>
    <message>
        <source>tongue inside the tissue around it</source>
        <translation>Zunge im Gewebe um sie herum</translation>
    </message>
    <message>
        <source>gap where the tongue is held</source>
        <translation>Spalt, wo die Zunge gehalten wird</translation>
    </message>
    <message>
        <source>head size</source>
        <translation>Kopfgröße</translation>
    </message>
    <message>
        <source>child size</source>
        <translation>Kindesgröße</translation>
    </message>
    <message>
        <source>adult size</source>
        <translation>Erwachsenengröße</translation>
    </message>
    <message>
        <source>position corrected</source>
        <translation>Lage berichtigt</translation>
    </message>
    <message>
        <source>scaled</source>
        <translation>skaliert</translation>
    </message>
    <message>
        <source>tongue volume</source>
        <translation>Volumen der Zunge</translation>
    </message>
    <message>
        <source>epiglottis volume</source>
        <translation>Volumen der Epiglottis</translation>
    </message>
    <message>
        <source>airway volume</source>
        <translation>Volumen des Atemwegs</translation>
    </message>
    <message>
        <source>mandible volume</source>
        <translation>Volumen des Unterkiefers</translation>
    </message>
    <message>
        <source>mouth open</source>
        <translation>Mund offen</translation>
    </message>
    <message>
        <source>mouth opened</source>
        <translation>Mund geöffnet</translation>
    </message>
    <message>
        <source>head extended</source>
        <translation>Kopf gestreckt</translation>
    </message>
    <message>
        <source>gap between the gums</source>
        <translation>Abstand der Zahnleisten</translation>
    </message>
    <message>
        <source>glottis area</source>
        <translation>Fläche der Glottis</translation>
    </message>
    <message>
        <source>nodes held by the mandible</source>
        <translation>vom Unterkiefer gehaltene Knoten</translation>
    </message>
    <message>
        <source>nodes held by the hyoid</source>
        <translation>vom Zungenbein gehaltene Knoten</translation>
    </message>
    <message>
        <source>nodes held by the larynx</source>
        <translation>vom Kehlkopf gehaltene Knoten</translation>
    </message>
    <message>
        <source>epiglottis stiffness</source>
        <translation>Steifigkeit der Epiglottis</translation>
    </message>
    <message>
        <source>check by playing</source>
        <translation>Probe durch Spielen</translation>
    </message>
    <message>
        <source>glottis in sight at rest</source>
        <translation>Glottis in Sicht in Ruhe</translation>
    </message>
    <message>
        <source>glottis in sight when lifted</source>
        <translation>Glottis in Sicht beim Anheben</translation>
    </message>
    <message>
        <source>the deepest node</source>
        <translation>der tiefste Knoten</translation>
    </message>
    <message>
        <source>the lips stand apart</source>
        <translation>die Lippen stehen auseinander</translation>
    </message>
    <message>
        <source>the lips stand apart after the opening</source>
        <translation>die Lippen stehen nach dem Öffnen auseinander</translation>
    </message>
    <message>
        <source>the mouth is closed: good for pressing on the tongue, not for a view</source>
        <translation>der Mund ist geschlossen: gut, um auf die Zunge zu drücken, nicht für eine Sicht</translation>
    </message>
    <message>
        <source>hidden by tongue and epiglottis, as it should be</source>
        <translation>von Zunge und Epiglottis verdeckt, wie es sein soll</translation>
    </message>
    <message>
        <source>expected to be hidden before the lift</source>
        <translation>sollte vor dem Anheben verdeckt sein</translation>
    </message>
    <message>
        <source>The trial was recorded to its end at %1 s</source>
        <translation>Der Durchgang wurde bis zu seinem Ende bei %1 s aufgezeichnet</translation>
    </message>
    <message>
        <source>The blade entered the mouth at %1 s</source>
        <translation>Der Spatel kam bei %1 s in den Mund</translation>
    </message>
    <message>
        <source>The attempt never began: the blade&apos;s tip did not enter the mouth</source>
        <translation>Der Intubationsversuch begann nie: Die Spatelspitze kam nicht in den Mund</translation>
    </message>
    <message>
        <source>The glottis was never in sight; %1 % of it must be seen</source>
        <translation>Die Glottis war nie in Sicht; %1 % von ihr müssen zu sehen sein</translation>
    </message>
    <message>
        <source>Glottis seen to %1 % at %2 s, at least the %3 % asked for</source>
        <translation>Glottis bei %2 s zu %1 % gesehen, mindestens die verlangten %3 %</translation>
    </message>
    <message>
        <source>Glottis seen to %1 % at %2 s, less than the %3 % asked for</source>
        <translation>Glottis bei %2 s zu %1 % gesehen, weniger als die verlangten %3 %</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s), within the %4 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s), innerhalb der erlaubten %4 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s), more than the %4 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s), mehr als die erlaubten %4 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, the blade was still in the mouth), within the %4 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, der Spatel war noch im Mund), innerhalb der erlaubten %4 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, the blade was still in the mouth), more than the %4 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, der Spatel war noch im Mund), mehr als die erlaubten %4 s</translation>
    </message>
    <message>
        <source>Peak force on the tongue %1 N at %2 s, within the %3 N allowed</source>
        <translation>Höchste Kraft auf die Zunge %1 N bei %2 s, innerhalb der erlaubten %3 N</translation>
    </message>
    <message>
        <source>Peak force on the tongue %1 N at %2 s, more than the %3 N allowed</source>
        <translation>Höchste Kraft auf die Zunge %1 N bei %2 s, mehr als die erlaubten %3 N</translation>
    </message>
    <message>
        <source>Peak force on the tongue %1 N, within the %2 N allowed</source>
        <translation>Höchste Kraft auf die Zunge %1 N, innerhalb der erlaubten %2 N</translation>
    </message>
    <message>
        <source>Peak force on the tongue %1 N, more than the %2 N allowed</source>
        <translation>Höchste Kraft auf die Zunge %1 N, mehr als die erlaubten %2 N</translation>
    </message>
    <message>
        <source>Peak force on the gums %1 N at %2 s, within the %3 N allowed</source>
        <translation>Höchste Kraft auf die Zahnleisten %1 N bei %2 s, innerhalb der erlaubten %3 N</translation>
    </message>
    <message>
        <source>Peak force on the gums %1 N at %2 s, more than the %3 N allowed</source>
        <translation>Höchste Kraft auf die Zahnleisten %1 N bei %2 s, mehr als die erlaubten %3 N</translation>
    </message>
    <message>
        <source>Peak force on the gums %1 N, within the %2 N allowed</source>
        <translation>Höchste Kraft auf die Zahnleisten %1 N, innerhalb der erlaubten %2 N</translation>
    </message>
    <message>
        <source>Peak force on the gums %1 N, more than the %2 N allowed</source>
        <translation>Höchste Kraft auf die Zahnleisten %1 N, mehr als die erlaubten %2 N</translation>
    </message>
    <message>
        <source>Force on the tongue above its target of %1 N for %2 s (first at %3 s), within the %4 s allowed</source>
        <translation>Kraft auf die Zunge über ihrem Ziel von %1 N für %2 s (zuerst bei %3 s), innerhalb der erlaubten %4 s</translation>
    </message>
    <message>
        <source>Force on the tongue above its target of %1 N for %2 s (first at %3 s), more than the %4 s allowed</source>
        <translation>Kraft auf die Zunge über ihrem Ziel von %1 N für %2 s (zuerst bei %3 s), mehr als die erlaubten %4 s</translation>
    </message>
    <message>
        <source>Force on the tongue above its target of %1 N for %2 s, within the %3 s allowed</source>
        <translation>Kraft auf die Zunge über ihrem Ziel von %1 N für %2 s, innerhalb der erlaubten %3 s</translation>
    </message>
    <message>
        <source>Force on the tongue above its target of %1 N for %2 s, more than the %3 s allowed</source>
        <translation>Kraft auf die Zunge über ihrem Ziel von %1 N für %2 s, mehr als die erlaubten %3 s</translation>
    </message>
    <message>
        <source>Device at its force limit of %1 N or lost, for %2 s (longest from %3 s), within the %4 s allowed</source>
        <translation>Gerät an seiner Kraftgrenze von %1 N oder verloren, für %2 s (am längsten ab %3 s), innerhalb der erlaubten %4 s</translation>
    </message>
    <message>
        <source>Device at its force limit of %1 N or lost, for %2 s (longest from %3 s), more than the %4 s allowed</source>
        <translation>Gerät an seiner Kraftgrenze von %1 N oder verloren, für %2 s (am längsten ab %3 s), mehr als die erlaubten %4 s</translation>
    </message>
    <message>
        <source>Device at its force limit of %1 N or lost, for %2 s, within the %3 s allowed</source>
        <translation>Gerät an seiner Kraftgrenze von %1 N oder verloren, für %2 s, innerhalb der erlaubten %3 s</translation>
    </message>
    <message>
        <source>Device at its force limit of %1 N or lost, for %2 s, more than the %3 s allowed</source>
        <translation>Gerät an seiner Kraftgrenze von %1 N oder verloren, für %2 s, mehr als die erlaubten %3 s</translation>
    </message>
    <message>
        <source>Saturation fell to %1 % at %2 s, at least the %3 % asked for</source>
        <translation>Die Sättigung fiel bei %2 s auf %1 %, mindestens die verlangten %3 %</translation>
    </message>
    <message>
        <source>Saturation fell to %1 % at %2 s, less than the %3 % asked for</source>
        <translation>Die Sättigung fiel bei %2 s auf %1 %, weniger als die verlangten %3 %</translation>
    </message>
    <message>
        <source>The heart fell to %1 per minute at %2 s, at least the %3 per minute asked for</source>
        <translation>Die Herzfrequenz fiel bei %2 s auf %1 pro Minute, mindestens die verlangten %3 pro Minute</translation>
    </message>
    <message>
        <source>The heart fell to %1 per minute at %2 s, less than the %3 per minute asked for</source>
        <translation>Die Herzfrequenz fiel bei %2 s auf %1 pro Minute, weniger als die verlangten %3 pro Minute</translation>
    </message>
    <message>
        <source>In no attempt did saturation fall by %1 points or more</source>
        <translation>In keinem Intubationsversuch fiel die Sättigung um %1 Punkte oder mehr</translation>
    </message>
    <message>
        <source>The tube was never in the oesophagus</source>
        <translation>Der Tubus war nie im Ösophagus</translation>
    </message>
    <message>
        <source>The tube lies in the oesophagus</source>
        <translation>Der Tubus liegt im Ösophagus</translation>
    </message>
    <message>
        <source>The tube was stopped by the cricoid and never came past it</source>
        <translation>Der Tubus wurde vom Ringknorpel aufgehalten und kam nie hindurch</translation>
    </message>
    <message>
        <source>The cords were closed, and the tube is not past them</source>
        <translation>Die Stimmlippen waren geschlossen, und der Tubus ist nicht dahinter</translation>
    </message>
    <message>
        <source>The tube is not in the trachea: the intubation was given up</source>
        <translation>Der Tubus ist nicht in der Trachea: Die Intubation wurde aufgegeben</translation>
    </message>
    <message>
        <source>The trial&apos;s time was over before the tube was in the trachea</source>
        <translation>Die Zeit war um, bevor der Tubus in der Trachea war</translation>
    </message>
    <message>
        <source>The cords were passed before the blade was in the mouth, so not under sight</source>
        <translation>Die Stimmlippen wurden passiert, bevor der Spatel im Mund war, also nicht unter Sicht</translation>
    </message>
    <message>
        <source>The tube&apos;s tip lies %1 mm past the cords, %2 % of the way to the carina: good depth</source>
        <translation>Die Tubusspitze liegt %1 mm hinter den Stimmlippen, %2 % des Weges zur Carina: gute Tiefe</translation>
    </message>
    <message>
        <source>The tube&apos;s tip lies %1 mm past the cords, %2 % of the way to the carina: in the trachea, but to be advanced</source>
        <translation>Die Tubusspitze liegt %1 mm hinter den Stimmlippen, %2 % des Weges zur Carina: in der Trachea, aber vorzuschieben</translation>
    </message>
    <message>
        <source>The tube&apos;s tip lies %1 mm past the cords, %2 % of the way to the carina: in the trachea, but to be drawn back</source>
        <translation>Die Tubusspitze liegt %1 mm hinter den Stimmlippen, %2 % des Weges zur Carina: in der Trachea, aber zurückzuziehen</translation>
    </message>
    <message>
        <source>The tube&apos;s tip lies in the right main bronchus: only one lung gets air</source>
        <translation>Die Tubusspitze liegt im rechten Hauptbronchus: Nur eine Lunge bekommt Luft</translation>
    </message>
    <message>
        <source>The tube&apos;s tip lies in the left main bronchus: only one lung gets air</source>
        <translation>Die Tubusspitze liegt im linken Hauptbronchus: Nur eine Lunge bekommt Luft</translation>
    </message>
    <message>
        <source>The tube&apos;s tip lies in a main bronchus: only one lung gets air</source>
        <translation>Die Tubusspitze liegt in einem Hauptbronchus: Nur eine Lunge bekommt Luft</translation>
    </message>
    <message>
        <source>The detector turned yellow with breath %1, within the %2 breaths allowed</source>
        <translation>Der Detektor wurde mit Beatmung %1 gelb, innerhalb der erlaubten %2 Beatmungen</translation>
    </message>
    <message>
        <source>The detector turned yellow with breath %1, more than the %2 breaths allowed</source>
        <translation>Der Detektor wurde mit Beatmung %1 gelb, mehr als die erlaubten %2 Beatmungen</translation>
    </message>
    <message>
        <source>%1 attempt, within the %2 allowed</source>
        <translation>%1 Intubationsversuch, innerhalb der erlaubten %2</translation>
    </message>
    <message>
        <source>%1 attempts, within the %2 allowed</source>
        <translation>%1 Intubationsversuche, innerhalb der erlaubten %2</translation>
    </message>
    <message>
        <source>%1 attempts, more than the %2 allowed</source>
        <translation>%1 Intubationsversuche, mehr als die erlaubten %2</translation>
    </message>
    <message>
        <source>The tip came in %1 mm to the left of the midline</source>
        <translation>Die Spitze kam %1 mm links der Mittellinie hinein</translation>
    </message>
    <message>
        <source>The tip came in %1 mm to the right of the midline</source>
        <translation>Die Spitze kam %1 mm rechts der Mittellinie hinein</translation>
    </message>
    <message>
        <source>The tip came within %1 mm of it</source>
        <translation>Die Spitze kam ihr bis auf %1 mm nahe</translation>
    </message>
    <message>
        <source>The tip came no nearer to it than %1 mm</source>
        <translation>Die Spitze kam ihr nicht näher als %1 mm</translation>
    </message>
    <message>
        <source>The tip came no nearer to it than %1 mm, but the glottis was seen: lifting the epiglottis itself is of equal worth</source>
        <translation>Die Spitze kam ihr nicht näher als %1 mm, aber die Glottis wurde gesehen: Die Epiglottis selbst aufzuladen ist gleichwertig</translation>
    </message>
    <message>
        <source>The upper jaw never bore more than %1 N of the load</source>
        <translation>Der Oberkiefer trug nie mehr als %1 N der Last</translation>
    </message>
    <message>
        <source>From %1 s on the upper jaw bore more than %2 N of the load, %3 N at most</source>
        <translation>Ab %1 s trug der Oberkiefer mehr als %2 N der Last, höchstens %3 N</translation>
    </message>
    <message>
        <source>In sight at %1 s, passed at %2 s</source>
        <translation>In Sicht bei %1 s, passiert bei %2 s</translation>
    </message>
    <message>
        <source>Passed at %1 s without a view before</source>
        <translation>Passiert bei %1 s ohne Sicht davor</translation>
    </message>
    <message>
        <source>%1 % of the glottis in sight beside it before the cords, passed at %2 s</source>
        <translation>%1 % der Glottis neben ihm in Sicht vor den Stimmlippen, passiert bei %2 s</translation>
    </message>
    <message>
        <source>Passed at %1 s with the blade out</source>
        <translation>Passiert bei %1 s mit dem Spatel draußen</translation>
    </message>
    <message>
        <source>The first breath at %1 s</source>
        <translation>Die erste Beatmung bei %1 s</translation>
    </message>
    <message>
        <source>Still in at the first breath at %1 s</source>
        <translation>Bei der ersten Beatmung bei %1 s noch darin</translation>
    </message>
    <message>
        <source>%1 ml at first, %2 ml at the end</source>
        <translation>%1 ml anfangs, %2 ml am Ende</translation>
    </message>
    <message>
        <source>%1 ml at first, %2 ml at the end, no catheter took them</source>
        <translation>%1 ml anfangs, %2 ml am Ende, kein Katheter hat sie abgesaugt</translation>
    </message>
    <message>
        <source>The attempt at %1 s began without a breath before</source>
        <translation>Der Intubationsversuch bei %1 s begann ohne einen Beatmungshub davor</translation>
    </message>
    <message>
        <source>A curriculum: scenarios in the order in which they are practised. Every force is a training target, never an injury limit.</source>
        <translation>Ein Kurs: Szenarien in der Reihenfolge, in der sie geübt werden. Jede Kraft ist ein Trainingsziel, nie eine Verletzungsgrenze.</translation>
    </message>
    <message>
        <source>lower-case letters, digits and single hyphens</source>
        <translation>Kleinbuchstaben, Ziffern und einzelne Bindestriche</translation>
    </message>
    <message>
        <source>inner diameter in mm</source>
        <translation>Innendurchmesser in mm</translation>
    </message>
    <message>
        <source>percent</source>
        <translation>Prozent</translation>
    </message>
    <message>
        <source>Schema</source>
        <translation>Schema</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Blades by weight</source>
        <translation>Spatel nach Gewicht</translation>
    </message>
    <message>
        <source>Tubes by weight</source>
        <translation>Tuben nach Gewicht</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Szenarien</translation>
    </message>
    <message>
        <source>rows by growing weight; a scenario without a blade takes the first row above its weight</source>
        <translation>Zeilen nach wachsendem Gewicht; ein Szenario ohne Spatel nimmt die erste Zeile über seinem Gewicht</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Unter</translation>
    </message>
    <message>
        <source>Blade</source>
        <translation>Spatel</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>rows by growing weight; an intubation without a tube takes the first row above the weight</source>
        <translation>Zeilen nach wachsendem Gewicht; eine Intubation ohne Tubus nimmt die erste Zeile über dem Gewicht</translation>
    </message>
    <message>
        <source>Briefing</source>
        <translation>Einweisung</translation>
    </message>
    <message>
        <source>Manikin</source>
        <translation>Phantom</translation>
    </message>
    <message>
        <source>Tongue young</source>
        <translation>Elastizität der Zunge</translation>
    </message>
    <message>
        <source>Sight</source>
        <translation>Sicht</translation>
    </message>
    <message>
        <source>Max attempt</source>
        <translation>Längster Durchgang</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Bestehen</translation>
    </message>
    <message>
        <source>Intubation</source>
        <translation>Intubation</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Pa; without it the patient&apos;s own</source>
        <translation>Pa; ohne Angabe die des Patienten</translation>
    </message>
    <message>
        <source>Tongue force</source>
        <translation>Zungenkraft</translation>
    </message>
    <message>
        <source>Gum force</source>
        <translation>Zahnleistenkraft</translation>
    </message>
    <message>
        <source>Glottis visible</source>
        <translation>Glottis sichtbar</translation>
    </message>
    <message>
        <source>Time over target</source>
        <translation>Zeit über dem Ziel</translation>
    </message>
    <message>
        <source>Time over device limit</source>
        <translation>Zeit über der Gerätegrenze</translation>
    </message>
    <message>
        <source>Stylet</source>
        <translation>Führungsstab</translation>
    </message>
    <message>
        <source>Catheter</source>
        <translation>Katheter</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Gestation</source>
        <translation>Gestationsalter</translation>
    </message>
    <message>
        <source>Infant seed</source>
        <translation>Startwert des Kindes</translation>
    </message>
    <message>
        <source>Added oxygen</source>
        <translation>Zusätzlicher Sauerstoff</translation>
    </message>
    <message>
        <source>Premedicated</source>
        <translation>Prämediziert</translation>
    </message>
    <message>
        <source>Breathes</source>
        <translation>Atmet</translation>
    </message>
    <message>
        <source>Laryngospasm</source>
        <translation>Laryngospasmus</translation>
    </message>
    <message>
        <source>Laryngospasm from start</source>
        <translation>Laryngospasmus von Anfang an</translation>
    </message>
    <message>
        <source>Cord closure</source>
        <translation>Stimmlippenschluss</translation>
    </message>
    <message>
        <source>Laryngeal pressure</source>
        <translation>Kehlkopfdruck</translation>
    </message>
    <message>
        <source>Breaths to confirm</source>
        <translation>Beatmungen bis zur Bestätigung</translation>
    </message>
    <message>
        <source>mm, diameter of its metal; without it 1.2</source>
        <translation>mm, Durchmesser seines Metalls; ohne Angabe 1,2</translation>
    </message>
    <message>
        <source>French; 0: none at hand; without it 8</source>
        <translation>Charrière; 0: keiner zur Hand; ohne Angabe 8</translation>
    </message>
    <message>
        <source>weeks</source>
        <translation>Wochen</translation>
    </message>
    <message>
        <source>percent of the gas, in breaths given; without it 10, of a preoxygenated infant 0</source>
        <translation>Prozent des Gases in gegebenen Beatmungen; ohne Angabe 10, bei präoxygeniertem Kind 0</translation>
    </message>
    <message>
        <source>without it as the course has it</source>
        <translation>ohne Angabe wie im Kurs</translation>
    </message>
    <message>
        <source>by itself; without it true, of a premedicated infant false</source>
        <translation>von selbst; ohne Angabe wahr, bei prämediziertem Kind falsch</translation>
    </message>
    <message>
        <source>s; 0: none</source>
        <translation>s; 0: keiner</translation>
    </message>
    <message>
        <source>s, after a touch; without it 1</source>
        <translation>s, nach einer Berührung; ohne Angabe 1</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>N, of the assistant on request; 0: none; without it 3</source>
        <translation>N, der Assistenz auf Verlangen; 0: keiner; ohne Angabe 3</translation>
    </message>
    <message>
        <source>without it 6</source>
        <translation>ohne Angabe 6</translation>
    </message>
    <message>
        <source>Outcomes</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Tube force</source>
        <translation>Tubuskraft</translation>
    </message>
    <message>
        <source>CO2 confirmed</source>
        <translation>CO2 bestätigt</translation>
    </message>
    <message>
        <source>Depth neutral</source>
        <translation>Tiefe neutral</translation>
    </message>
    <message>
        <source>Oesophagus in time</source>
        <translation>Ösophagus rechtzeitig</translation>
    </message>
    <message>
        <source>No severe desaturation</source>
        <translation>Kein schwerer Sättigungsabfall</translation>
    </message>
    <message>
        <source>accepted; without it good-depth alone</source>
        <translation>anerkannt; ohne Angabe nur good-depth</translation>
    </message>
    <message>
        <source>per minute</source>
        <translation>pro Minute</translation>
    </message>
    <message>
        <source>A curriculum: modules in the order in which they are learned, and their scenarios. Every force is a training target, never an injury limit.</source>
        <translation>Ein Kurs: Module in der Reihenfolge, in der sie gelernt werden, und ihre Szenarien. Jede Kraft ist ein Trainingsziel, nie eine Verletzungsgrenze.</translation>
    </message>
    <message>
        <source>English text, or a text a language, { en: ..., de: ... }; Markdown</source>
        <translation>Englischer Text oder ein Text je Sprache, { en: ..., de: ... }; Markdown</translation>
    </message>
    <message>
        <source>languages like en, de, pt-BR</source>
        <translation>Sprachen wie en, de, pt-BR</translation>
    </message>
    <message>
        <source>where a number comes from, or &quot;assumed&quot;</source>
        <translation>woher eine Zahl kommt, oder &quot;assumed&quot;</translation>
    </message>
    <message>
        <source>inner diameter, in quotes</source>
        <translation>Innendurchmesser, in Anführungszeichen</translation>
    </message>
    <message>
        <source>Short name (id)</source>
        <translation>Kurzname (Id)</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>Lernziele</translation>
    </message>
    <message>
        <source>When it is mastered</source>
        <translation>Wann es gemeistert ist</translation>
    </message>
    <message>
        <source>Weights and sources of the pass marks</source>
        <translation>Gewichte und Quellen der Kriterien</translation>
    </message>
    <message>
        <source>Modules</source>
        <translation>Module</translation>
    </message>
    <message>
        <source>version of these rules</source>
        <translation>Version dieser Regeln</translation>
    </message>
    <message>
        <source>what whoever has finished can do</source>
        <translation>was kann, wer fertig ist</translation>
    </message>
    <message>
        <source>for every module that has no rule of its own</source>
        <translation>für jedes Modul ohne eigene Regel</translation>
    </message>
    <message>
        <source>for every pass mark that a scenario says nothing about</source>
        <translation>für jedes Kriterium, zu dem ein Szenario nichts sagt</translation>
    </message>
    <message>
        <source>Right blade</source>
        <translation>Richtiger Spatel</translation>
    </message>
    <message>
        <source>Right tube</source>
        <translation>Richtiger Tubus</translation>
    </message>
    <message>
        <source>in the order in which they are learned</source>
        <translation>in der Reihenfolge, in der sie gelernt werden</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Lernziel</translation>
    </message>
    <message>
        <source>Opens after</source>
        <translation>Öffnet sich nach</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Modi</translation>
    </message>
    <message>
        <source>their ids, in order; each belongs to one module</source>
        <translation>ihre Ids, der Reihe nach; jede gehört zu einem Modul</translation>
    </message>
    <message>
        <source>ids of modules to be mastered before this one opens</source>
        <translation>Ids der Module, die gemeistert sein müssen, bevor dieses sich öffnet</translation>
    </message>
    <message>
        <source>assessment: no helps, no replay, no variation, own rating before the score</source>
        <translation>Prüfung: keine Hilfen, keine Wiedergabe, keine Variation, eigene Bewertung vor der Wertung</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Passes running</source>
        <translation>Bestanden in Folge</translation>
    </message>
    <message>
        <source>Within attempts</source>
        <translation>Innerhalb von Versuchen</translation>
    </message>
    <message>
        <source>Acceptable failure</source>
        <translation>Annehmbarer Misserfolg</translation>
    </message>
    <message>
        <source>Unacceptable failure</source>
        <translation>Nicht annehmbarer Misserfolg</translation>
    </message>
    <message>
        <source>Risk alpha</source>
        <translation>Risiko alpha</translation>
    </message>
    <message>
        <source>Risk beta</source>
        <translation>Risiko beta</translation>
    </message>
    <message>
        <source>Trials that count</source>
        <translation>Durchgänge, die zählen</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>cusum: over all trials of the module, and each scenario passed once; consecutive: each scenario passed so many times running</source>
        <translation>cusum: über alle Durchgänge des Moduls, und jedes Szenario einmal bestanden; consecutive: jedes Szenario so oft hintereinander bestanden</translation>
    </message>
    <message>
        <source>running, of the rule consecutive</source>
        <translation>hintereinander, der Regel consecutive</translation>
    </message>
    <message>
        <source>a trial that took more is no success</source>
        <translation>ein Durchgang, der mehr brauchte, ist kein Erfolg</translation>
    </message>
    <message>
        <source>of the rule cusum</source>
        <translation>der Regel cusum</translation>
    </message>
    <message>
        <source>of the rule cusum: risk of calling an acceptable hand deficient</source>
        <translation>der Regel cusum: Risiko, eine annehmbare Hand unzureichend zu nennen</translation>
    </message>
    <message>
        <source>of the rule cusum: risk of calling an unacceptable hand competent</source>
        <translation>der Regel cusum: Risiko, eine nicht annehmbare Hand kompetent zu nennen</translation>
    </message>
    <message>
        <source>which trials count</source>
        <translation>welche Durchgänge zählen</translation>
    </message>
    <message>
        <source>share of the points; failing the mark fails the trial whatever its weight</source>
        <translation>Anteil an den Punkten; ein verfehltes Kriterium lässt den Durchgang scheitern, gleich welches Gewicht es hat</translation>
    </message>
    <message>
        <source>Glottis seen at least</source>
        <translation>Glottis mindestens gesehen</translation>
    </message>
    <message>
        <source>Time of an attempt</source>
        <translation>Dauer eines Intubationsversuchs</translation>
    </message>
    <message>
        <source>Time above the target</source>
        <translation>Zeit über dem Ziel</translation>
    </message>
    <message>
        <source>Time at the device&apos;s limit</source>
        <translation>Zeit an der Gerätegrenze</translation>
    </message>
    <message>
        <source>Accepted outcomes</source>
        <translation>Anerkannte Ergebnisse</translation>
    </message>
    <message>
        <source>Force along the tube</source>
        <translation>Kraft längs des Tubus</translation>
    </message>
    <message>
        <source>Time from view to cords passed</source>
        <translation>Zeit von der Sicht bis hinter die Stimmlippen</translation>
    </message>
    <message>
        <source>Confirmed by CO2</source>
        <translation>Durch CO2 bestätigt</translation>
    </message>
    <message>
        <source>Depth good with the head neutral</source>
        <translation>Tiefe gut bei neutralem Kopf</translation>
    </message>
    <message>
        <source>Oesophagus recognised in time</source>
        <translation>Ösophagus rechtzeitig erkannt</translation>
    </message>
    <message>
        <source>weight and source of each pass mark; none of them is validated</source>
        <translation>Gewicht und Quelle jedes Kriteriums; keines ist validiert</translation>
    </message>
    <message>
        <source>The infant</source>
        <translation>Das Kind</translation>
    </message>
    <message>
        <source>Varies from attempt to attempt</source>
        <translation>Wechselt von Durchgang zu Durchgang</translation>
    </message>
    <message>
        <source>Blades to choose from</source>
        <translation>Spatel zur Auswahl</translation>
    </message>
    <message>
        <source>Stiffness of the tongue</source>
        <translation>Steifigkeit der Zunge</translation>
    </message>
    <message>
        <source>In sight from</source>
        <translation>In Sicht ab</translation>
    </message>
    <message>
        <source>The trial ends after</source>
        <translation>Der Durchgang endet nach</translation>
    </message>
    <message>
        <source>Training targets</source>
        <translation>Trainingsziele</translation>
    </message>
    <message>
        <source>Passes with</source>
        <translation>Bestanden mit</translation>
    </message>
    <message>
        <source>Helps on the screen</source>
        <translation>Hilfen auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Distractions</source>
        <translation>Ablenkungen</translation>
    </message>
    <message>
        <source>ids of modules to be mastered before this scenario opens</source>
        <translation>Ids der Module, die gemeistert sein müssen, bevor dieses Szenario sich öffnet</translation>
    </message>
    <message>
        <source>Which infant (seed)</source>
        <translation>Welches Kind (Startwert)</translation>
    </message>
    <message>
        <source>Mouth opening</source>
        <translation>Mundöffnung</translation>
    </message>
    <message>
        <source>Tongue size</source>
        <translation>Zungengröße</translation>
    </message>
    <message>
        <source>Larynx height</source>
        <translation>Kehlkopfhöhe</translation>
    </message>
    <message>
        <source>Epiglottis length</source>
        <translation>Länge der Epiglottis</translation>
    </message>
    <message>
        <source>one infant of that weight; 0 is the unvaried design</source>
        <translation>ein Kind dieses Gewichts; 0 ist der unveränderte Entwurf</translation>
    </message>
    <message>
        <source>sets the way from the cords to the carina</source>
        <translation>bestimmt den Weg von den Stimmlippen zur Carina</translation>
    </message>
    <message>
        <source>on 22 mm between the gums at term</source>
        <translation>bezogen auf 22 mm zwischen den Zahnleisten bei Termingeborenen</translation>
    </message>
    <message>
        <source>on width and height</source>
        <translation>auf Breite und Höhe</translation>
    </message>
    <message>
        <source>towards the head, in a term infant; a smaller one&apos;s is as much smaller</source>
        <translation>kopfwärts, bei einem Termingeborenen; bei einem kleineren entsprechend weniger</translation>
    </message>
    <message>
        <source>the trainee takes one before the trial; blade is the right one and among them</source>
        <translation>Lernende nehmen einen vor dem Durchgang; blade ist der richtige und darunter</translation>
    </message>
    <message>
        <source>stiffness of the tongue</source>
        <translation>Steifigkeit der Zunge</translation>
    </message>
    <message>
        <source>from here on the glottis counts as in sight</source>
        <translation>ab hier zählt die Glottis als in Sicht</translation>
    </message>
    <message>
        <source>the trial ends by itself</source>
        <translation>der Durchgang endet von selbst</translation>
    </message>
    <message>
        <source>Force on the tongue</source>
        <translation>Kraft auf die Zunge</translation>
    </message>
    <message>
        <source>Force on the gums</source>
        <translation>Kraft auf die Zahnleisten</translation>
    </message>
    <message>
        <source>what is trained for; never injury limits</source>
        <translation>worauf trainiert wird; nie Verletzungsgrenzen</translation>
    </message>
    <message>
        <source>to be reached once</source>
        <translation>einmal zu erreichen</translation>
    </message>
    <message>
        <source>at most, blade into the mouth to blade out</source>
        <translation>höchstens, Spatel in den Mund bis Spatel heraus</translation>
    </message>
    <message>
        <source>at most, of the tongue&apos;s force</source>
        <translation>höchstens, der Kraft auf die Zunge</translation>
    </message>
    <message>
        <source>Ghost path</source>
        <translation>Weg des Experten</translation>
    </message>
    <message>
        <source>Glottis highlight</source>
        <translation>Glottis hervorgehoben</translation>
    </message>
    <message>
        <source>Sagittal cut</source>
        <translation>Sagittalschnitt</translation>
    </message>
    <message>
        <source>Force bars</source>
        <translation>Kraftbalken</translation>
    </message>
    <message>
        <source>helps on the screen; all off in assessment</source>
        <translation>Hilfen auf dem Bildschirm; in der Prüfung alle aus</translation>
    </message>
    <message>
        <source>the expert&apos;s way as a grey blade</source>
        <translation>der Weg des Experten als grauer Spatel</translation>
    </message>
    <message>
        <source>the sagittal cut beside the operator&apos;s view</source>
        <translation>der Sagittalschnitt neben der Sicht der Intubierenden</translation>
    </message>
    <message>
        <source>the live bars of force</source>
        <translation>die mitlaufenden Kraftbalken</translation>
    </message>
    <message>
        <source>by growing time</source>
        <translation>nach wachsender Zeit</translation>
    </message>
    <message>
        <source>Blade taken</source>
        <translation>Genommener Spatel</translation>
    </message>
    <message>
        <source>Tube taken</source>
        <translation>Genommener Tubus</translation>
    </message>
    <message>
        <source>written by a trial into its log, never in a curriculum</source>
        <translation>von einem Durchgang in seine Aufzeichnung geschrieben, nie in einen Kurs</translation>
    </message>
    <message>
        <source>what the variation was drawn with; 0: as written</source>
        <translation>womit die Variation gezogen wurde; 0: wie geschrieben</translation>
    </message>
    <message>
        <source>what the trainee took of those offered</source>
        <translation>was vom Angebotenen genommen wurde</translation>
    </message>
    <message>
        <source>likewise</source>
        <translation>ebenso</translation>
    </message>
    <message>
        <source>Infants</source>
        <translation>Kinder</translation>
    </message>
    <message>
        <source>Another course each time</source>
        <translation>Jedes Mal ein anderer Verlauf</translation>
    </message>
    <message>
        <source>Distraction delay</source>
        <translation>Verzögerung der Ablenkungen</translation>
    </message>
    <message>
        <source>each attempt in practice draws from these ranges by its own seed; assessment takes what is written</source>
        <translation>jeder Übungsdurchgang zieht aus diesen Bereichen mit eigenem Startwert; eine Prüfung nimmt, was geschrieben steht</translation>
    </message>
    <message>
        <source>so many infants in turn, each with a seed and a shape of its own; each is made at its first use</source>
        <translation>so viele Kinder der Reihe nach, jedes mit eigenem Startwert und eigener Form; jedes wird beim ersten Gebrauch gemacht</translation>
    </message>
    <message>
        <source>of the infants, from to</source>
        <translation>der Kinder, von bis</translation>
    </message>
    <message>
        <source>from to</source>
        <translation>von bis</translation>
    </message>
    <message>
        <source>from to; needs an intubation</source>
        <translation>von bis; braucht eine Intubation</translation>
    </message>
    <message>
        <source>another infant&apos;s saturation and heart each time; needs an intubation</source>
        <translation>jedes Mal Sättigung und Herz eines anderen Kindes; braucht eine Intubation</translation>
    </message>
    <message>
        <source>from to, added to all distractions</source>
        <translation>von bis, zu allen Ablenkungen addiert</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Right answer</source>
        <translation>Richtige Antwort</translation>
    </message>
    <message>
        <source>Time allowed</source>
        <translation>Erlaubte Zeit</translation>
    </message>
    <message>
        <source>trial time</source>
        <translation>Zeit im Durchgang</translation>
    </message>
    <message>
        <source>question: to be answered; alarm: to be silenced; talk: what the team says, to be ignored</source>
        <translation>question: zu beantworten; alarm: stumm zu schalten; talk: was das Team sagt, zu überhören</translation>
    </message>
    <message>
        <source>of a question</source>
        <translation>einer Frage</translation>
    </message>
    <message>
        <source>which of the answers, counted from 1</source>
        <translation>welche der Antworten, ab 1 gezählt</translation>
    </message>
    <message>
        <source>of a question or an alarm</source>
        <translation>einer Frage oder eines Alarms</translation>
    </message>
    <message>
        <source>Tubes to choose from</source>
        <translation>Tuben zur Auswahl</translation>
    </message>
    <message>
        <source>Stylet&apos;s diameter</source>
        <translation>Durchmesser des Führungsstabs</translation>
    </message>
    <message>
        <source>Suction catheter</source>
        <translation>Absaugkatheter</translation>
    </message>
    <message>
        <source>Saturation and heart</source>
        <translation>Sättigung und Herz</translation>
    </message>
    <message>
        <source>the trainee takes one before the trial; tube is the right one and among them</source>
        <translation>Lernende nehmen einen vor dem Durchgang; tube ist der richtige und darunter</translation>
    </message>
    <message>
        <source>diameter of its metal</source>
        <translation>Durchmesser seines Metalls</translation>
    </message>
    <message>
        <source>0: none at hand</source>
        <translation>0: keiner zur Hand</translation>
    </message>
    <message>
        <source>of saturation and heart; only the first is calibrated to a published one</source>
        <translation>von Sättigung und Herz; nur der erste ist an einem veröffentlichten kalibriert</translation>
    </message>
    <message>
        <source>one infant of the population; 0 its median</source>
        <translation>ein Kind der Population; 0 ihr Median</translation>
    </message>
    <message>
        <source>of the gas, in breaths given</source>
        <translation>des Gases, in gegebenen Beatmungen</translation>
    </message>
    <message>
        <source>atropine and a muscle relaxant</source>
        <translation>Atropin und ein Muskelrelaxans</translation>
    </message>
    <message>
        <source>by itself, all through the trial; the cords open with it</source>
        <translation>von selbst, den ganzen Durchgang lang; die Stimmlippen öffnen sich dabei</translation>
    </message>
    <message>
        <source>after a touch; 0: none</source>
        <translation>nach einer Berührung; 0: keiner</translation>
    </message>
    <message>
        <source>after a touch</source>
        <translation>nach einer Berührung</translation>
    </message>
    <message>
        <source>of the assistant on request; 0: none</source>
        <translation>der Assistenz auf Verlangen; 0: keiner</translation>
    </message>
    <message>
        <source>no colour after so many: not in the trachea</source>
        <translation>nach so vielen keine Farbe: nicht in der Trachea</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>anerkannt</translation>
    </message>
    <message>
        <source>displayed, at least</source>
        <translation>angezeigt, mindestens</translation>
    </message>
    <message>
        <source>at most, along the tube</source>
        <translation>höchstens, längs des Tubus</translation>
    </message>
    <message>
        <source>at most, from the view to the cords passed</source>
        <translation>höchstens, von der Sicht bis hinter die Stimmlippen</translation>
    </message>
    <message>
        <source>within breaths_to_confirm</source>
        <translation>innerhalb von breaths_to_confirm</translation>
    </message>
    <message>
        <source>a tube in the trachea lies in the middle third with the head neutral, too</source>
        <translation>ein Tubus in der Trachea liegt auch bei neutralem Kopf im mittleren Drittel</translation>
    </message>
    <message>
        <source>never more than breaths_to_confirm breaths in one stay in the oesophagus, and not there at the end</source>
        <translation>nie mehr als breaths_to_confirm Beatmungen in einem Aufenthalt im Ösophagus, und nicht dort am Ende</translation>
    </message>
    <message>
        <source>in no attempt a fall by 20 points or more</source>
        <translation>in keinem Intubationsversuch ein Abfall um 20 Punkte oder mehr</translation>
    </message>
    <message>
        <source>up to %1 characters</source>
        <translation>bis zu %1 Zeichen</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 to %2 %3/min</source>
        <translation>%1 bis %2 %3/min</translation>
    </message>
    <message>
        <source>%1 to %2 N</source>
        <translation>%1 bis %2 N</translation>
    </message>
    <message>
        <source>%1 to %2 factor</source>
        <translation>%1 bis %2 als Faktor</translation>
    </message>
    <message>
        <source>%1 to %2 kg</source>
        <translation>%1 bis %2 kg</translation>
    </message>
    <message>
        <source>%1 to %2 s</source>
        <translation>%1 bis %2 s</translation>
    </message>
    <message>
        <source>%1 to %2 Pa</source>
        <translation>%1 bis %2 Pa</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 bis %2 mm</translation>
    </message>
    <message>
        <source>%1 to %2 ml</source>
        <translation>%1 bis %2 ml</translation>
    </message>
    <message>
        <source>%1 to %2 French</source>
        <translation>%1 bis %2 Charrière</translation>
    </message>
    <message>
        <source>%1 to %2 weeks</source>
        <translation>%1 bis %2 Wochen</translation>
    </message>
    <message>
        <source>%1 to %2 %</source>
        <translation>%1 bis %2 %</translation>
    </message>
    <message>
        <source>The trial is held: it goes on when it is let go.</source>
        <translation>Der Durchgang wird angehalten: Er geht weiter, wenn er freigegeben wird.</translation>
    </message>
    <message>
        <source>Why it counts neither way, and what was measured</source>
        <translation>Warum er nicht gewertet wird und was gemessen wurde</translation>
    </message>
    <message>
        <source>Own head moved aside</source>
        <translation>Eigener Kopf zur Seite bewegt</translation>
    </message>
    <message>
        <source>Head extended by an assistant</source>
        <translation>Kopf von einer Assistenz gestreckt</translation>
    </message>
    <message>
        <source>The trial is let go. To go on press Enter or a button of the device, or hold the grey blade on the steel one for half a second.</source>
        <translation>Der Durchgang ist freigegeben. Um weiterzumachen, drücken Sie Enter oder eine Taste des Geräts oder halten Sie den grauen Spatel eine halbe Sekunde auf dem stählernen.</translation>
    </message>
    <message>
        <source>Video laryngoscope</source>
        <translation>Videolaryngoskop</translation>
    </message>
    <message>
        <source>Expert&apos;s loop</source>
        <translation>Expertenschleife</translation>
    </message>
    <message>
        <source>the picture of a camera at the blade&apos;s tip</source>
        <translation>das Bild einer Kamera an der Spatelspitze</translation>
    </message>
    <message>
        <source>manikin: shaping the anatomy</source>
        <translation>Phantom: die Anatomie wird geformt</translation>
    </message>
    <message>
        <source>manikin: scanning</source>
        <translation>Phantom: wird gescannt</translation>
    </message>
    <message>
        <source>manikin: scanner blur and noise</source>
        <translation>Phantom: Unschärfe und Rauschen des Scanners</translation>
    </message>
    <message>
        <source>manikin: writing the series</source>
        <translation>Phantom: die Serie wird geschrieben</translation>
    </message>
    <message>
        <source>manikin: writing the labels</source>
        <translation>Phantom: die Labels werden geschrieben</translation>
    </message>
    <message>
        <source>manikin: done</source>
        <translation>Phantom: fertig</translation>
    </message>
    <message>
        <source>an assessment is not held up; practise the scenario for that</source>
        <translation>eine Prüfung wird nicht angehalten; üben Sie dafür das Szenario</translation>
    </message>
    <message>
        <source>an assessment begins in front of the mouth; practise the scenario for that</source>
        <translation>eine Prüfung beginnt vor dem Mund; üben Sie dafür das Szenario</translation>
    </message>
    <message>
        <source>the expert&apos;s loop stopped at a fault of the computation</source>
        <translation>die Expertenschleife hielt an einem Fehler der Berechnung an</translation>
    </message>
    <message>
        <source>Begun at the vallecula: the blade was led there, so the trial counts neither as passed nor as failed, and its times are not judged</source>
        <translation>An der Vallecula begonnen: Der Spatel wurde dorthin geführt, also zählt der Durchgang weder als bestanden noch als nicht bestanden, und seine Zeiten werden nicht beurteilt</translation>
    </message>
    <message>
        <source>The instructor changed the infant&apos;s vital signs from %1 s: the trial counts neither as passed nor as failed</source>
        <translation>Die Lehrperson änderte ab %1 s die Vitalwerte des Kindes: Der Durchgang zählt weder als bestanden noch als nicht bestanden</translation>
    </message>
    <message>
        <source>The instructor closed the vocal cords from %1 s: the trial counts neither as passed nor as failed</source>
        <translation>Die Lehrperson schloss ab %1 s die Stimmlippen: Der Durchgang zählt weder als bestanden noch als nicht bestanden</translation>
    </message>
    <message>
        <source>%1 time, %2 s in all, first at %3 s</source>
        <translation>%1-mal, insgesamt %2 s, zuerst bei %3 s</translation>
    </message>
    <message>
        <source>%1 times, %2 s in all, first at %3 s</source>
        <translation>%1-mal, insgesamt %2 s, zuerst bei %3 s</translation>
    </message>
    <message>
        <source>Shown an expert, or told a line by the instructor</source>
        <translation>Expertenablauf gezeigt oder Hinweis der Lehrperson</translation>
    </message>
    <message>
        <source>Keeping the trial before</source>
        <translation>Der Durchgang davor wird noch gesichert</translation>
    </message>
    <message>
        <source>the blade did not enter the mouth</source>
        <translation>der Spatel kam nicht in den Mund</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>nicht gezählt</translation>
    </message>
    <message>
        <source>Not counted</source>
        <translation>Nicht gezählt</translation>
    </message>
    <message>
        <source>Practice with help: not counted for the course</source>
        <translation>Übung mit Hilfe: zählt nicht für den Kurs</translation>
    </message>
    <message>
        <source>Changed by the instructor: not counted for the course</source>
        <translation>Von der Lehrperson verändert: zählt nicht für den Kurs</translation>
    </message>
    <message>
        <source>The trial is held by the instructor: it goes on when they let it go.</source>
        <translation>Der Durchgang ist von der Lehrperson angehalten: Er geht weiter, wenn sie ihn freigibt.</translation>
    </message>
    <message>
        <source>The trial is held by you for as long as you look at the expert (G).</source>
        <translation>Der Durchgang ist von Ihnen angehalten, solange Sie dem Experten zusehen (G).</translation>
    </message>
    <message>
        <source>the device&apos;s library libHD.so cannot be loaded</source>
        <translation>die Bibliothek libHD.so des Geräts kann nicht geladen werden</translation>
    </message>
    <message>
        <source>Install OpenHaptics and the Touch driver from 3D Systems, or let VALLECULA_LIBHD name the library&apos;s file</source>
        <translation>installieren Sie OpenHaptics und den Touch-Treiber von 3D Systems, oder nennen Sie mit VALLECULA_LIBHD die Datei der Bibliothek</translation>
    </message>
    <message>
        <source>at least %1 per minute</source>
        <translation>mindestens %1 pro Minute</translation>
    </message>
    <message>
        <source>The trial is held by you for as long as the list of keys is open.</source>
        <translation>Der Durchgang ist von Ihnen angehalten, solange die Tastenliste offen ist.</translation>
    </message>
    <message>
        <source>Neither blade nor tube entered the mouth: no attempt, so the trial counts neither as passed nor as failed</source>
        <translation>Weder Spatel noch Tubus kamen in den Mund: kein Intubationsversuch, also zählt der Durchgang weder als bestanden noch als nicht bestanden</translation>
    </message>
    <message>
        <source>the blade did not enter the mouth; at most %1 s</source>
        <translation>der Spatel kam nicht in den Mund; höchstens %1 s</translation>
    </message>
    <message>
        <source>not timed</source>
        <translation>ohne Zeit</translation>
    </message>
    <message>
        <source>where the mouth begins is not known</source>
        <translation>wo der Mund beginnt, ist nicht bekannt</translation>
    </message>
    <message>
        <source>the attempt could not be timed.</source>
        <translation>die Zeit des Intubationsversuchs war nicht zu messen.</translation>
    </message>
    <message>
        <source>%1; asked for: %2</source>
        <translation>%1; verlangt: %2</translation>
    </message>
    <message>
        <source>The tube was pushed against what stood before its tip (%1) with %2 N at %3 s, within the %4 N allowed</source>
        <translation>Der Tubus wurde gegen das, was vor seiner Spitze stand (%1), mit %2 N bei %3 s gedrückt, innerhalb der erlaubten %4 N</translation>
    </message>
    <message>
        <source>The tube was pushed against what stood before its tip (%1) with %2 N at %3 s, more than the %4 N allowed</source>
        <translation>Der Tubus wurde gegen das, was vor seiner Spitze stand (%1), mit %2 N bei %3 s gedrückt, mehr als die erlaubten %4 N</translation>
    </message>
    <message>
        <source>The tube was pushed against what stood before its tip (%1) with %2 N, within the %3 N allowed</source>
        <translation>Der Tubus wurde gegen das, was vor seiner Spitze stand (%1), mit %2 N gedrückt, innerhalb der erlaubten %3 N</translation>
    </message>
    <message>
        <source>The tube was pushed against what stood before its tip (%1) with %2 N, more than the %3 N allowed</source>
        <translation>Der Tubus wurde gegen das, was vor seiner Spitze stand (%1), mit %2 N gedrückt, mehr als die erlaubten %3 N</translation>
    </message>
    <message>
        <source>The trial was interrupted (%1): its log ends at %2 s</source>
        <translation>Der Durchgang wurde unterbrochen (%1): Seine Aufzeichnung endet bei %2 s</translation>
    </message>
    <message>
        <source>The blade %1 was taken, which is right for this infant</source>
        <translation>Der Spatel %1 wurde genommen, der für dieses Kind richtige</translation>
    </message>
    <message>
        <source>The blade %1 was taken; right for this infant is %2</source>
        <translation>Der Spatel %1 wurde genommen; richtig für dieses Kind ist %2</translation>
    </message>
    <message>
        <source>The tube %1 was taken, which is right for this infant</source>
        <translation>Der Tubus %1 wurde genommen, der für dieses Kind richtige</translation>
    </message>
    <message>
        <source>The tube %1 was taken; right for this infant is %2</source>
        <translation>Der Tubus %1 wurde genommen; richtig für dieses Kind ist %2</translation>
    </message>
    <message>
        <source>%1; not validated</source>
        <translation>%1; nicht validiert</translation>
    </message>
    <message>
        <source>%1 time (%2)</source>
        <translation>%1-mal (%2)</translation>
    </message>
    <message>
        <source>%1 times (%2)</source>
        <translation>%1-mal (%2)</translation>
    </message>
    <message>
        <source>%1 N, at %2 s (%3)</source>
        <translation>%1 N, bei %2 s (%3)</translation>
    </message>
    <message>
        <source>%1: recognised late</source>
        <translation>%1: spät erkannt</translation>
    </message>
    <message>
        <source>pause: %1</source>
        <translation>Pause: %1</translation>
    </message>
    <message>
        <source>from %1 s on the tissue&apos;s shape may be a little different from what it was (%2 is the first to differ); figures are the recorded ones</source>
        <translation>ab %1 s kann die Form des Gewebes ein wenig anders sein, als sie war (%2 weicht als Erstes ab); Werte sind die aufgezeichneten</translation>
    </message>
    <message>
        <source>at %1 s %2 (the %3 ticks up to it are in %4)</source>
        <translation>bei %1 s: %2 (die %3 Takte bis dahin stehen in %4)</translation>
    </message>
    <message>
        <source>the replay stopped: %1</source>
        <translation>die Wiedergabe hielt an: %1</translation>
    </message>
    <message>
        <source>the expert&apos;s loop stopped: %1</source>
        <translation>die Schleife des Experten hielt an: %1</translation>
    </message>
    <message>
        <source>a trial that was cut off could not be kept: %1</source>
        <translation>ein abgebrochener Durchgang konnte nicht aufgehoben werden: %1</translation>
    </message>
    <message>
        <source>a trial that was cut off is kept, but has no report: %1</source>
        <translation>ein abgebrochener Durchgang ist aufgehoben, hat aber keinen Bericht: %1</translation>
    </message>
    <message>
        <source>a deleted person&apos;s files are still there: %1</source>
        <translation>Dateien einer gelöschten Person sind noch da: %1</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, the blade went in %4 times), within the %5 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, der Spatel ging %4-mal hinein), innerhalb der erlaubten %5 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, the blade went in %4 times), more than the %5 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, der Spatel ging %4-mal hinein), mehr als die erlaubten %5 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, the blade went in %4 times, the blade was still in the mouth), within the %5 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, der Spatel ging %4-mal hinein, der Spatel war noch im Mund), innerhalb der erlaubten %5 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, the blade went in %4 times, the blade was still in the mouth), more than the %5 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, der Spatel ging %4-mal hinein, der Spatel war noch im Mund), mehr als die erlaubten %5 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, paused for %4 s), within the %5 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, davon %4 s pausiert), innerhalb der erlaubten %5 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, paused for %4 s), more than the %5 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, davon %4 s pausiert), mehr als die erlaubten %5 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade was still in the mouth), within the %5 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, davon %4 s pausiert, der Spatel war noch im Mund), innerhalb der erlaubten %5 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade was still in the mouth), more than the %5 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, davon %4 s pausiert, der Spatel war noch im Mund), mehr als die erlaubten %5 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade went in %5 times), within the %6 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, davon %4 s pausiert, der Spatel ging %5-mal hinein), innerhalb der erlaubten %6 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade went in %5 times), more than the %6 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, davon %4 s pausiert, der Spatel ging %5-mal hinein), mehr als die erlaubten %6 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade went in %5 times, the blade was still in the mouth), within the %6 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, davon %4 s pausiert, der Spatel ging %5-mal hinein, der Spatel war noch im Mund), innerhalb der erlaubten %6 s</translation>
    </message>
    <message>
        <source>The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade went in %5 times, the blade was still in the mouth), more than the %6 s allowed</source>
        <translation>Der Intubationsversuch dauerte %1 s (%2 s bis %3 s, davon %4 s pausiert, der Spatel ging %5-mal hinein, der Spatel war noch im Mund), mehr als die erlaubten %6 s</translation>
    </message>
    <message>
        <source>Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s), within the %6 s allowed</source>
        <translation>Intubationsversuch %1 von %2, der längste, dauerte %3 s (%4 s bis %5 s), innerhalb der erlaubten %6 s</translation>
    </message>
    <message>
        <source>Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s), more than the %6 s allowed</source>
        <translation>Intubationsversuch %1 von %2, der längste, dauerte %3 s (%4 s bis %5 s), mehr als die erlaubten %6 s</translation>
    </message>
    <message>
        <source>Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, the blade was still in the mouth), within the %6 s allowed</source>
        <translation>Intubationsversuch %1 von %2, der längste, dauerte %3 s (%4 s bis %5 s, der Spatel war noch im Mund), innerhalb der erlaubten %6 s</translation>
    </message>
    <message>
        <source>Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, the blade was still in the mouth), more than the %6 s allowed</source>
        <translation>Intubationsversuch %1 von %2, der längste, dauerte %3 s (%4 s bis %5 s, der Spatel war noch im Mund), mehr als die erlaubten %6 s</translation>
    </message>
    <message>
        <source>Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, paused for %6 s), within the %7 s allowed</source>
        <translation>Intubationsversuch %1 von %2, der längste, dauerte %3 s (%4 s bis %5 s, davon %6 s pausiert), innerhalb der erlaubten %7 s</translation>
    </message>
    <message>
        <source>Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, paused for %6 s), more than the %7 s allowed</source>
        <translation>Intubationsversuch %1 von %2, der längste, dauerte %3 s (%4 s bis %5 s, davon %6 s pausiert), mehr als die erlaubten %7 s</translation>
    </message>
    <message>
        <source>Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, paused for %6 s, the blade was still in the mouth), within the %7 s allowed</source>
        <translation>Intubationsversuch %1 von %2, der längste, dauerte %3 s (%4 s bis %5 s, davon %6 s pausiert, der Spatel war noch im Mund), innerhalb der erlaubten %7 s</translation>
    </message>
    <message>
        <source>Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, paused for %6 s, the blade was still in the mouth), more than the %7 s allowed</source>
        <translation>Intubationsversuch %1 von %2, der längste, dauerte %3 s (%4 s bis %5 s, davon %6 s pausiert, der Spatel war noch im Mund), mehr als die erlaubten %7 s</translation>
    </message>
    <message>
        <source>The trial was interrupted: its log ends at %1 s</source>
        <translation>Der Durchgang wurde unterbrochen: Seine Aufzeichnung endet bei %1 s</translation>
    </message>
    <message>
        <source>The attempt cannot be timed: the log lacks usable landmarks of the gums and the vallecula</source>
        <translation>Die Dauer des Intubationsversuchs ist unbekannt: Der Aufzeichnung fehlen brauchbare Landmarken von Zahnleisten und Vallecula</translation>
    </message>
    <message>
        <source>A recorded force is not a number at %1 s: please report this trial&apos;s log</source>
        <translation>Eine aufgezeichnete Kraft ist bei %1 s keine Zahl: Bitte melden Sie die Aufzeichnung dieses Durchgangs</translation>
    </message>
    <message>
        <source>The tube&apos;s place was not confirmed: the detector did not turn yellow with %1 breaths through it, of %2 breaths allowed</source>
        <translation>Die Lage des Tubus wurde nicht bestätigt: Der Detektor wurde mit %1 Beatmungen durch ihn nicht gelb, von %2 erlaubten</translation>
    </message>
    <message>
        <source>With the head neutral the tube&apos;s tip lies about %1 mm past the cords, %2 % of the way to the carina: in the middle third</source>
        <translation>Mit dem Kopf in Neutralstellung liegt die Tubusspitze etwa %1 mm hinter den Stimmlippen, %2 % des Weges zur Carina: im mittleren Drittel</translation>
    </message>
    <message>
        <source>With the head neutral the tube&apos;s tip lies about %1 mm past the cords, %2 % of the way to the carina: to be drawn back</source>
        <translation>Mit dem Kopf in Neutralstellung liegt die Tubusspitze etwa %1 mm hinter den Stimmlippen, %2 % des Weges zur Carina: zurückzuziehen</translation>
    </message>
    <message>
        <source>With the head neutral the tube&apos;s tip lies about %1 mm past the cords, %2 % of the way to the carina: to be advanced</source>
        <translation>Mit dem Kopf in Neutralstellung liegt die Tubusspitze etwa %1 mm hinter den Stimmlippen, %2 % des Weges zur Carina: vorzuschieben</translation>
    </message>
    <message>
        <source>The tube in the oesophagus was recognised late: more than %1 breaths in one stay at %2 s</source>
        <translation>Der Tubus im Ösophagus wurde spät erkannt: mehr als %1 Beatmungen in einem Aufenthalt, bei %2 s</translation>
    </message>
    <message>
        <source>The tube in the oesophagus was recognised late: more than %1 breaths in one stay</source>
        <translation>Der Tubus im Ösophagus wurde spät erkannt: mehr als %1 Beatmungen in einem Aufenthalt</translation>
    </message>
    <message>
        <source>The tube in the oesophagus was recognised within %1 breaths in one stay</source>
        <translation>Der Tubus im Ösophagus wurde innerhalb von %1 Beatmungen in einem Aufenthalt erkannt</translation>
    </message>
    <message>
        <source>In attempt %1 of %2, begun at %3 s, saturation fell by %4 points or more, from %5 to %6 %</source>
        <translation>Im Intubationsversuch %1 von %2, begonnen bei %3 s, fiel die Sättigung um %4 Punkte oder mehr, von %5 auf %6 %</translation>
    </message>
    <message>
        <source>Saturation fell to %1 %, at least the %2 % asked for</source>
        <translation>Die Sättigung fiel auf %1 %, mindestens die verlangten %2 %</translation>
    </message>
    <message>
        <source>Saturation fell to %1 %, less than the %2 % asked for</source>
        <translation>Die Sättigung fiel auf %1 %, weniger als die verlangten %2 %</translation>
    </message>
    <message>
        <source>The heart fell to %1 per minute, at least the %2 per minute asked for</source>
        <translation>Das Herz fiel auf %1 pro Minute, mindestens die verlangten %2 pro Minute</translation>
    </message>
    <message>
        <source>The heart fell to %1 per minute, less than the %2 per minute asked for</source>
        <translation>Das Herz fiel auf %1 pro Minute, weniger als die verlangten %2 pro Minute</translation>
    </message>
    <message>
        <source>Yellow with breath %1</source>
        <translation>Gelb mit Beatmung %1</translation>
    </message>
    <message>
        <source>Not yellow after %1 breaths</source>
        <translation>Nach %1 Beatmungen nicht gelb</translation>
    </message>
    <message>
        <source>%1 breaths were given there</source>
        <translation>%1 Beatmungen wurden dort gegeben</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
    <message>
        <source>The tube was pushed against what stood before its tip with %1 N at %2 s, within the %3 N allowed</source>
        <translation>Der Tubus wurde gegen das, was vor seiner Spitze stand, mit %1 N bei %2 s gedrückt, innerhalb der erlaubten %3 N</translation>
    </message>
    <message>
        <source>The tube was pushed against what stood before its tip with %1 N, within the %2 N allowed</source>
        <translation>Der Tubus wurde gegen das, was vor seiner Spitze stand, mit %1 N gedrückt, innerhalb der erlaubten %2 N</translation>
    </message>
    <message>
        <source>From the view to the cords passed it took %1 s at %2 s, within the %3 s allowed</source>
        <translation>Von der Sicht bis hinter die Stimmlippen dauerte es %1 s, bei %2 s, innerhalb der erlaubten %3 s</translation>
    </message>
    <message>
        <source>From the view to the cords passed it took %1 s at %2 s, with the blade out already, within the %3 s allowed</source>
        <translation>Von der Sicht bis hinter die Stimmlippen dauerte es %1 s, bei %2 s, mit dem Spatel schon heraus, innerhalb der erlaubten %3 s</translation>
    </message>
    <message>
        <source>From the blade in the mouth to the cords passed, without a view, it took %1 s at %2 s, within the %3 s allowed</source>
        <translation>Vom Spatel im Mund bis hinter die Stimmlippen, ohne Sicht, dauerte es %1 s, bei %2 s, innerhalb der erlaubten %3 s</translation>
    </message>
    <message>
        <source>From the blade in the mouth to the cords passed, without a view, it took %1 s at %2 s, with the blade out already, within the %3 s allowed</source>
        <translation>Vom Spatel im Mund bis hinter die Stimmlippen, ohne Sicht, dauerte es %1 s, bei %2 s, mit dem Spatel schon heraus, innerhalb der erlaubten %3 s</translation>
    </message>
    <message>
        <source>The tube was pushed against what stood before its tip with %1 N at %2 s, more than the %3 N allowed</source>
        <translation>Der Tubus wurde gegen das, was vor seiner Spitze stand, mit %1 N bei %2 s gedrückt, mehr als die erlaubten %3 N</translation>
    </message>
    <message>
        <source>The tube was pushed against what stood before its tip with %1 N, more than the %2 N allowed</source>
        <translation>Der Tubus wurde gegen das, was vor seiner Spitze stand, mit %1 N gedrückt, mehr als die erlaubten %2 N</translation>
    </message>
    <message>
        <source>From the view to the cords passed it took %1 s at %2 s, more than the %3 s allowed</source>
        <translation>Von der Sicht bis hinter die Stimmlippen dauerte es %1 s, bei %2 s, mehr als die erlaubten %3 s</translation>
    </message>
    <message>
        <source>From the view to the cords passed it took %1 s at %2 s, with the blade out already, more than the %3 s allowed</source>
        <translation>Von der Sicht bis hinter die Stimmlippen dauerte es %1 s, bei %2 s, mit dem Spatel schon heraus, mehr als die erlaubten %3 s</translation>
    </message>
    <message>
        <source>From the blade in the mouth to the cords passed, without a view, it took %1 s at %2 s, more than the %3 s allowed</source>
        <translation>Vom Spatel im Mund bis hinter die Stimmlippen, ohne Sicht, dauerte es %1 s, bei %2 s, mehr als die erlaubten %3 s</translation>
    </message>
    <message>
        <source>From the blade in the mouth to the cords passed, without a view, it took %1 s at %2 s, with the blade out already, more than the %3 s allowed</source>
        <translation>Vom Spatel im Mund bis hinter die Stimmlippen, ohne Sicht, dauerte es %1 s, bei %2 s, mit dem Spatel schon heraus, mehr als die erlaubten %3 s</translation>
    </message>
    <message>
        <source>force exceeded</source>
        <translation>Kraftgrenze überschritten</translation>
    </message>
    <message>
        <source>communication lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation>ausgesteckt</translation>
    </message>
    <message>
        <source>motor warm</source>
        <translation>Motor zu warm</translation>
    </message>
    <message>
        <source>non finite command</source>
        <translation>ungültiger Kraftbefehl</translation>
    </message>
    <message>
        <source>servo late</source>
        <translation>Regelschleife zu spät</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
    <message>
        <source>driver error</source>
        <translation>Fehler des Treibers</translation>
    </message>
    <message>
        <source>frozen</source>
        <translation>eingefroren</translation>
    </message>
    <message>
        <source>ended by trainee</source>
        <translation>von der lernenden Person beendet</translation>
    </message>
    <message>
        <source>no source given</source>
        <translation>keine Quelle angegeben</translation>
    </message>
    <message>
        <source>vestibule %1 N</source>
        <translation>Vestibulum %1 N</translation>
    </message>
    <message>
        <source>cords %1 N</source>
        <translation>Stimmlippen %1 N</translation>
    </message>
    <message>
        <source>subglottis %1 N</source>
        <translation>Subglottis %1 N</translation>
    </message>
    <message>
        <source>cricoid %1 N</source>
        <translation>Ringknorpel %1 N</translation>
    </message>
    <message>
        <source>trachea %1 N</source>
        <translation>Trachea %1 N</translation>
    </message>
    <message>
        <source>bronchus %1 N</source>
        <translation>Bronchus %1 N</translation>
    </message>
    <message>
        <source>oesophagus %1 N</source>
        <translation>Ösophagus %1 N</translation>
    </message>
    <message>
        <source>pharynx %1 N</source>
        <translation>Rachen %1 N</translation>
    </message>
    <message>
        <source>tongue %1 N</source>
        <translation>Zunge %1 N</translation>
    </message>
    <message>
        <source>epiglottis %1 N</source>
        <translation>Epiglottis %1 N</translation>
    </message>
    <message>
        <source>blade %1 N</source>
        <translation>Spatel %1 N</translation>
    </message>
    <message>
        <source>vestibule</source>
        <translation>Vestibulum</translation>
    </message>
    <message>
        <source>cords</source>
        <translation>Stimmlippen</translation>
    </message>
    <message>
        <source>subglottis</source>
        <translation>Subglottis</translation>
    </message>
    <message>
        <source>cricoid</source>
        <translation>Ringknorpel</translation>
    </message>
    <message>
        <source>trachea</source>
        <translation>Trachea</translation>
    </message>
    <message>
        <source>bronchus</source>
        <translation>Bronchus</translation>
    </message>
    <message>
        <source>pharynx</source>
        <translation>Rachen</translation>
    </message>
    <message>
        <source>blade</source>
        <translation>Spatel</translation>
    </message>
    <message>
        <source>%1 mm past the cords, %2 % of %3 mm to the carina</source>
        <translation>%1 mm hinter den Stimmlippen, %2 % von %3 mm bis zur Carina</translation>
    </message>
    <message>
        <source>%1 mm past the cords, %2 % of %3 mm to the carina; about %4 mm, %5 %, with the head neutral (assumed)</source>
        <translation>%1 mm hinter den Stimmlippen, %2 % von %3 mm bis zur Carina; etwa %4 mm, %5 %, mit dem Kopf in Neutralstellung (angenommen)</translation>
    </message>
    <message>
        <source>in the right main bronchus</source>
        <translation>im rechten Hauptbronchus</translation>
    </message>
    <message>
        <source>in the left main bronchus</source>
        <translation>im linken Hauptbronchus</translation>
    </message>
    <message>
        <source>in a main bronchus</source>
        <translation>in einem Hauptbronchus</translation>
    </message>
    <message>
        <source>not yellow, %1 breath through the tube</source>
        <translation>nicht gelb, %1 Beatmung durch den Tubus</translation>
    </message>
    <message>
        <source>not yellow, %1 breaths through the tube</source>
        <translation>nicht gelb, %1 Beatmungen durch den Tubus</translation>
    </message>
    <message>
        <source>%1 time</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>%1 breath given there</source>
        <translation>%1 Beatmung dort gegeben</translation>
    </message>
    <message>
        <source>%1 breaths given there</source>
        <translation>%1 Beatmungen dort gegeben</translation>
    </message>
    <message>
        <source>%1 s until withdrawn</source>
        <translation>%1 s bis herausgezogen</translation>
    </message>
    <message>
        <source>%1 ml, at the end %2 ml</source>
        <translation>%1 ml, am Ende %2 ml</translation>
    </message>
    <message>
        <source>%1 right</source>
        <translation>%1 richtig</translation>
    </message>
    <message>
        <source>%1 wrong</source>
        <translation>%1 falsch</translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation>%1 verpasst</translation>
    </message>
    <message>
        <source>%1 answered to nothing</source>
        <translation>%1 ohne Frage beantwortet</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>talk silenced</source>
        <translation>Gespräch stummgeschaltet</translation>
    </message>
    <message>
        <source>alarm answered rightly</source>
        <translation>Alarm richtig beantwortet</translation>
    </message>
    <message>
        <source>alarm answered wrongly</source>
        <translation>Alarm falsch beantwortet</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>SpO2 below %1 %</source>
        <translation>SpO2 unter %1 %</translation>
    </message>
    <message>
        <source>a trial that was cut off is kept as interrupted, up to second %1</source>
        <translation>ein abgebrochener Durchgang ist als unterbrochen aufgehoben, bis Sekunde %1</translation>
    </message>
    <message>
        <source>a finished trial that was cut off from its record has it now</source>
        <translation>ein beendeter Durchgang, dessen Eintrag fehlte, hat ihn jetzt</translation>
    </message>
    <message>
        <source>the airway&apos;s surface ends %1 mm below the cords: from there to the carina the trachea goes straight on as wide as it is</source>
        <translation>die Oberfläche des Atemwegs endet %1 mm unter den Stimmlippen: Von dort bis zur Carina geht die Trachea gerade und gleich weit weiter</translation>
    </message>
    <message>
        <source>no cut above the cords is the larynx&apos; own: its inlet is taken to be as wide as the cords</source>
        <translation>kein Schnitt über den Stimmlippen gehört dem Kehlkopf allein: Sein Eingang wird so weit angenommen wie die Stimmlippen</translation>
    </message>
    <message>
        <source>%1 mm, at %2 s</source>
        <translation>%1 mm, bei %2 s</translation>
    </message>
    <message>
        <source>yellow with breath %1</source>
        <translation>gelb mit Beatmung %1</translation>
    </message>
    <message>
        <source>No attempt: not counted for the course</source>
        <translation>Kein Intubationsversuch: zählt nicht für den Kurs</translation>
    </message>
    <message>
        <source>Peak force along the tube, at its tip</source>
        <translation>Höchste Kraft längs des Tubus, an der Spitze</translation>
    </message>
    <message>
        <source>Tube&apos;s peak push on each part, summed all round</source>
        <translation>Höchste Last des Tubus je Abschnitt, ringsum summiert</translation>
    </message>
    <message>
        <source>Peak force at the tube&apos;s tip</source>
        <translation>Höchste Kraft an der Tubusspitze</translation>
    </message>
    <message>
        <source>Peak force on the tube&apos;s hand</source>
        <translation>Höchste Kraft auf die Hand am Tubus</translation>
    </message>
    <message>
        <source>Peak force, larynx</source>
        <translation>Höchste Kraft, Larynx</translation>
    </message>
    <message>
        <source>The tube&apos;s hand: %1</source>
        <translation>Die Hand am Tubus: %1</translation>
    </message>
    <message>
        <source>recorded by another build (%1, %2); only the same build promises the same bits</source>
        <translation>mit einem anderen Programmstand aufgezeichnet (%1, %2); bis aufs Bit gleich ist die Wiedergabe nur mit demselben Stand</translation>
    </message>
    <message>
        <source>recorded with kernels for %1, computed here with %2</source>
        <translation>mit Rechenkernen für %1 aufgezeichnet, hier mit %2 gerechnet</translation>
    </message>
    <message>
        <source>an expert at this patient, while the trial waits</source>
        <translation>ein Experte an diesem Patienten, während der Durchgang wartet</translation>
    </message>
    <message>
        <source>Saturation stayed at %1 % or above, at least the %2 % asked for</source>
        <translation>Die Sättigung blieb bei %1 % oder darüber, mindestens die verlangten %2 %</translation>
    </message>
    <message>
        <source>Saturation began at %1 % and fell no further, less than the %2 % asked for</source>
        <translation>Die Sättigung begann bei %1 % und fiel nicht weiter, weniger als die verlangten %2 %</translation>
    </message>
    <message>
        <source>The heart stayed at %1 per minute or above, at least the %2 per minute asked for</source>
        <translation>Das Herz blieb bei %1 pro Minute oder darüber, mindestens die verlangten %2 pro Minute</translation>
    </message>
    <message>
        <source>The heart began at %1 per minute and fell no further, less than the %2 per minute asked for</source>
        <translation>Das Herz begann bei %1 pro Minute und fiel nicht weiter, weniger als die verlangten %2 pro Minute</translation>
    </message>
    <message>
        <source>expert shown</source>
        <translation>Expertenablauf gezeigt</translation>
    </message>
    <message>
        <source>list of keys</source>
        <translation>Tastenliste</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>kept up</source>
        <translation>schnell genug</translation>
    </message>
    <message>
        <source>too slow</source>
        <translation>zu langsam</translation>
    </message>
    <message>
        <source>not in real time</source>
        <translation>nicht in Echtzeit</translation>
    </message>
    <message>
        <source>forces came late</source>
        <translation>Kräfte kamen verspätet</translation>
    </message>
    <message>
        <source>the glottis came into sight (%1 % at best)</source>
        <translation>die Glottis kam in Sicht (bestenfalls %1 %)</translation>
    </message>
    <message>
        <source>begun at the vallecula.</source>
        <translation>an der Vallecula begonnen.</translation>
    </message>
    <message>
        <source>Begun at the vallecula</source>
        <translation>An der Vallecula begonnen</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Zeiten</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Bei</translation>
    </message>
    <message>
        <source>lowest saturation %1 %, lowest heart rate %2 per minute</source>
        <translation>niedrigste Sättigung %1 %, niedrigste Herzfrequenz %2 pro Minute</translation>
    </message>
    <message>
        <source>begun at the vallecula</source>
        <translation>an der Vallecula begonnen</translation>
    </message>
    <message>
        <source>The tip stood in the larynx for more than %1 s before it passed, and hid it from the log</source>
        <translation>Die Spitze stand länger als %1 s im Larynx, bevor sie hindurchging, und verdeckte es dem Protokoll</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>scripted</source>
        <translation>Skript</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Tube&apos;s mark at the lips</source>
        <translation>Tubusmarke an den Lippen</translation>
    </message>
    <message>
        <source>the tube&apos;s length inside the upper lip at the end; by the rule, which is a help and judges nothing, the weight in kg and 6 cm</source>
        <translation>Länge des Tubus innerhalb der Oberlippe am Ende; nach der Regel, die eine Hilfe ist und nichts bewertet, das Gewicht in kg und 6 cm</translation>
    </message>
    <message>
        <source>scenario&apos;s weight + %1: %2 cm, a help</source>
        <translation>Gewicht laut Szenario + %1: %2 cm, als Hilfe</translation>
    </message>
    <message>
        <source>not in the mouth</source>
        <translation>nicht im Mund</translation>
    </message>
    <message>
        <source>No picture comes to the screen: the trial waits.</source>
        <translation>Es kommt kein Bild auf den Bildschirm: Der Durchgang wartet.</translation>
    </message>
    <message>
        <source>The picture is back. To go on press Enter or a button of the device, or hold the grey blade on the steel one for half a second.</source>
        <translation>Das Bild ist wieder da. Um weiterzumachen, drücken Sie Enter oder eine Taste des Geräts oder halten Sie den grauen Spatel eine halbe Sekunde auf dem stählernen.</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>In attempt %1 of %2, begun at %3 s, saturation fell by %4 points or more, from %5 to below %6 %</source>
        <translation>Im Intubationsversuch %1 von %2, begonnen bei %3 s, fiel die Sättigung um %4 Punkte oder mehr, von %5 auf unter %6 %</translation>
    </message>
    <message>
        <source>Saturation fell to below %1 %, less than the %2 % asked for</source>
        <translation>Die Sättigung fiel auf unter %1 %, weniger als die verlangten %2 %</translation>
    </message>
    <message>
        <source>Saturation began at below %1 % and fell no further, less than the %2 % asked for</source>
        <translation>Die Sättigung begann unter %1 % und fiel nicht weiter, weniger als die verlangten %2 %</translation>
    </message>
    <message>
        <source>Saturation fell to below %1 % at %2 s, less than the %3 % asked for</source>
        <translation>Die Sättigung fiel bei %2 s auf unter %1 %, weniger als die verlangten %3 %</translation>
    </message>
    <message>
        <source>not judged: no attempt; at most %1 N</source>
        <translation>nicht gewertet: kein Intubationsversuch; höchstens %1 N</translation>
    </message>
    <message>
        <source>not judged: no attempt; at most %1 s</source>
        <translation>nicht gewertet: kein Intubationsversuch; höchstens %1 s</translation>
    </message>
    <message>
        <source>below %1 %</source>
        <translation>unter %1 %</translation>
    </message>
    <message>
        <source>below %1 %, at %2 s</source>
        <translation>unter %1 %, bei %2 s</translation>
    </message>
    <message>
        <source>no limit: what presses on the tube from all sides there, together; the cricoid is the narrowest ring, below the cords</source>
        <translation>keine Grenze: was dort von allen Seiten auf den Tubus drückt, zusammen; der Ringknorpel ist die engste Stelle, unter den Stimmlippen</translation>
    </message>
    <message>
        <source>Along the tube, against what stands before its tip: closed cords, or the cricoid, the narrowest ring below them</source>
        <translation>Längs des Tubus, gegen das, was vor seiner Spitze steht: geschlossene Stimmlippen oder der Ringknorpel, die engste Stelle darunter</translation>
    </message>
    <message>
        <source>lowest saturation below %1 %, lowest heart rate %2 per minute</source>
        <translation>niedrigste Sättigung unter %1 %, niedrigste Herzfrequenz %2 pro Minute</translation>
    </message>
    <message>
        <source>no picture came any more</source>
        <translation>es kam kein Bild mehr</translation>
    </message>
    <message>
        <source>The tube lay in the oesophagus to the end: it was not recognised</source>
        <translation>Der Tubus lag bis zum Ende im Ösophagus: Es wurde nicht erkannt</translation>
    </message>
    <message>
        <source>Over the target, tongue</source>
        <translation>Über dem Ziel, Zunge</translation>
    </message>
</context>
<context>
    <name>GivenLabels</name>
    <message>
        <source>the label map has none of the structures this program knows inside the scan; name its segments as the list here does (tongue, airway, ...)</source>
        <translation>Die Label-Karte hat im Scan keine der Strukturen, die dieses Programm kennt; benennen Sie ihre Segmente wie die Liste hier (tongue, airway, ...)</translation>
    </message>
    <message>
        <source>the label map has no voxel of this structure inside the scan; name its segment as it is named in the list here</source>
        <translation>Die Label-Karte hat im Scan kein Voxel dieser Struktur; benennen Sie ihr Segment so, wie es in der Liste hier heißt</translation>
    </message>
</context>
<context>
    <name>Hints</name>
    <message>
        <source>Heart rate below 60. Stop the attempt: blade and tube out, ventilate by mask (hold B); in life, compressions.</source>
        <translation>Herzfrequenz unter 60. Intubationsversuch abbrechen: Spatel und Tubus heraus, mit Maske beatmen (B halten); im Leben Thoraxkompressionen.</translation>
    </message>
    <message>
        <source>Stop this attempt: blade and tube out, then hold B to ventilate until the heart rate is above 100 and SpO2 is back.</source>
        <translation>Brechen Sie diesen Intubationsversuch ab: Spatel und Tubus heraus, dann B halten und beatmen, bis die Herzfrequenz über 100 und die SpO2 zurück ist.</translation>
    </message>
    <message>
        <source>Hold B to ventilate by mask until the heart rate is above 100 and SpO2 is back. SpO2 lags behind.</source>
        <translation>Halten Sie B und beatmen Sie mit Maske, bis die Herzfrequenz über 100 und die SpO2 zurück ist. Die SpO2 hinkt nach.</translation>
    </message>
    <message>
        <source>Suction catheter: its tip into the secretions, then hold V. Out of the mouth, C gives the tube back.</source>
        <translation>Absaugkatheter: seine Spitze ins Sekret, dann V halten. Außerhalb des Mundes gibt C den Tubus zurück.</translation>
    </message>
    <message>
        <source>The detector is yellow: the tube is in the airway. Bring its tip to good depth and take the blade out; then End.</source>
        <translation>Der Detektor ist gelb: Der Tubus liegt im Atemweg. Bringen Sie seine Spitze in gute Tiefe und nehmen Sie den Spatel heraus; dann Beenden.</translation>
    </message>
    <message>
        <source>No CO2 after these breaths: unless the heart rate rises, the tube is in the wrong place. Out, ventilate by mask, again.</source>
        <translation>Kein CO2 nach diesen Beatmungen: Wenn die Herzfrequenz nicht steigt, liegt der Tubus falsch. Heraus, mit Maske beatmen, erneut.</translation>
    </message>
    <message>
        <source>Cord mark at the cords? Hold B for 5 or 6 breaths; watch the heart rate and the CO2 detector.</source>
        <translation>Marke an den Stimmlippen? Halten Sie B für 5 oder 6 Beatmungen; beobachten Sie Herzfrequenz und CO2-Detektor.</translation>
    </message>
    <message>
        <source>The cords stay shut: laryngospasm. Draw back, ventilate by mask (B) and wait; never push.</source>
        <translation>Die Stimmlippen bleiben geschlossen: Laryngospasmus. Zurückziehen, mit Maske beatmen (B) und warten; nie drücken.</translation>
    </message>
    <message>
        <source>The cords are closed. Wait for them to open; never push.</source>
        <translation>Die Stimmlippen sind geschlossen. Warten Sie, bis sie sich öffnen; nie drücken.</translation>
    </message>
    <message>
        <source>Resistance. Draw back a little, turn the tube, try again; never push.</source>
        <translation>Widerstand. Etwas zurückziehen, den Tubus drehen, erneut versuchen; nie drücken.</translation>
    </message>
    <message>
        <source>Tip before the cords: on, between them, and keep them in sight until the mark has passed.</source>
        <translation>Spitze vor den Stimmlippen: weiter, zwischen ihnen hindurch, und im Blick behalten, bis die Marke passiert ist.</translation>
    </message>
    <message>
        <source>Tube along the right side of the mouth, beside the blade, not down its channel; keep the cords in sight.</source>
        <translation>Tubus an der rechten Seite des Mundes entlang, neben dem Spatel, nicht in seiner Rinne; die Stimmlippen im Blick behalten.</translation>
    </message>
    <message>
        <source>Secretions hide the throat: C takes the suction catheter, V held draws them off.</source>
        <translation>Sekret verdeckt den Rachen: C nimmt den Absaugkatheter, V gehalten saugt ab.</translation>
    </message>
    <message>
        <source>Glottis in sight. The tube in at the right corner of the mouth. L held: pressure on the larynx.</source>
        <translation>Glottis in Sicht. Den Tubus am rechten Mundwinkel einführen. L gehalten: Druck auf den Kehlkopf.</translation>
    </message>
    <message>
        <source>Glottis in sight. %1 takes the tube: in at the right corner of the mouth. L held: pressure on the larynx.</source>
        <translation>Glottis in Sicht. %1 nimmt den Tubus: am rechten Mundwinkel einführen. L gehalten: Druck auf den Kehlkopf.</translation>
    </message>
    <message>
        <source>Tongue to the left, tip into the vallecula, then lift along the handle; do not lever. L held: pressure on the larynx.</source>
        <translation>Zunge nach links, Spitze in die Vallecula, dann längs des Griffs heben; nicht hebeln. L gehalten: Druck auf den Kehlkopf.</translation>
    </message>
    <message>
        <source>Ventilated? Blade in at the right corner of the mouth. An attempt lasts 30 s at most; B held gives breaths between attempts.</source>
        <translation>Beatmet? Spatel am rechten Mundwinkel hinein. Ein Intubationsversuch dauert höchstens 30 s; B gehalten beatmet zwischen den Versuchen.</translation>
    </message>
    <message>
        <source>Bring the grey blade back to the steel one.</source>
        <translation>Den grauen Spatel zum stählernen zurückführen.</translation>
    </message>
    <message>
        <source>Its tip is out of sight. Between the cords? Then T draws the stylet, and the cord mark goes to the cords.</source>
        <translation>Seine Spitze ist nicht mehr zu sehen. Zwischen den Stimmlippen? Dann zieht T den Führungsstab, und die Stimmlippenmarke kommt an die Stimmlippen.</translation>
    </message>
    <message>
        <source>The blade presses on the upper gum: lift along its handle, do not tip it back.</source>
        <translation>Der Spatel drückt auf die obere Zahnleiste: entlang seines Griffs anheben, nicht kippen.</translation>
    </message>
</context>
<context>
    <name>ImportChoice</name>
    <message>
        <source>Give it a name of letters, digits, - and _ (at most 40), not the patient&apos;s.</source>
        <translation>Geben Sie einen Namen aus Buchstaben, Ziffern, - und _ (höchstens 40), nicht den des Patienten.</translation>
    </message>
    <message>
        <source>A patient of this name exists already; choose another name.</source>
        <translation>Ein Patient dieses Namens ist schon vorhanden; wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>ImportWork</name>
    <message>
        <source>Looking at what is there</source>
        <translation>Es wird nachgesehen, was da ist</translation>
    </message>
    <message>
        <source>Reading the series</source>
        <translation>Die Serie wird gelesen</translation>
    </message>
    <message>
        <source>Finding the structures</source>
        <translation>Die Strukturen werden gesucht</translation>
    </message>
    <message>
        <source>Finding the head</source>
        <translation>Der Kopf wird gesucht</translation>
    </message>
    <message>
        <source>Finding the airway</source>
        <translation>Der Atemweg wird gesucht</translation>
    </message>
    <message>
        <source>Finding skull, jaw, spine and hyoid</source>
        <translation>Schädel, Kiefer, Wirbelsäule und Zungenbein werden gesucht</translation>
    </message>
    <message>
        <source>Finding the epiglottis</source>
        <translation>Die Epiglottis wird gesucht</translation>
    </message>
    <message>
        <source>Finding the tongue</source>
        <translation>Die Zunge wird gesucht</translation>
    </message>
    <message>
        <source>Finding soft palate, larynx and oesophagus</source>
        <translation>Weicher Gaumen, Kehlkopf und Ösophagus werden gesucht</translation>
    </message>
    <message>
        <source>Finding the landmarks</source>
        <translation>Die Landmarken werden gesucht</translation>
    </message>
    <message>
        <source>Bringing the patient into position</source>
        <translation>Der Patient wird gelagert</translation>
    </message>
    <message>
        <source>Making the surfaces</source>
        <translation>Die Oberflächen werden gebildet</translation>
    </message>
    <message>
        <source>Making the surface of face and throat</source>
        <translation>Die Oberfläche von Gesicht und Rachen wird gebildet</translation>
    </message>
    <message>
        <source>Making the surface of the airway</source>
        <translation>Die Oberfläche des Atemwegs wird gebildet</translation>
    </message>
    <message>
        <source>Making the surfaces of jaw and palate</source>
        <translation>Die Oberflächen von Kiefer und Gaumen werden gebildet</translation>
    </message>
    <message>
        <source>Filling tongue and epiglottis with tetrahedra</source>
        <translation>Zunge und Epiglottis werden mit Tetraedern gefüllt</translation>
    </message>
    <message>
        <source>Trying an intubation with the scripted expert</source>
        <translation>Eine Intubation mit dem Experten nach Drehbuch wird versucht</translation>
    </message>
    <message>
        <source>Writing the patient</source>
        <translation>Der Patient wird geschrieben</translation>
    </message>
    <message>
        <source>takes longer than expected</source>
        <translation>dauert länger als erwartet</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>noch etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>noch etwa %1 min</translation>
    </message>
</context>
<context>
    <name>KeyList</name>
    <message>
        <source>Keys of this page</source>
        <translation>Tasten dieser Seite</translation>
    </message>
</context>
<context>
    <name>ModuleWords</name>
    <message>
        <source> at the first attempt</source>
        <translation> im ersten Intubationsversuch</translation>
    </message>
    <message>
        <source> within %1 attempts</source>
        <translation> innerhalb von %1 Intubationsversuchen</translation>
    </message>
    <message>
        <source>mastered</source>
        <translation>gemeistert</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>no trial yet</source>
        <translation>noch kein Durchgang</translation>
    </message>
    <message>
        <source>%1 of %2 trials passed%3</source>
        <translation>%1 von %2 Durchgängen bestanden%3</translation>
    </message>
    <message>
        <source>, %1 of %2 scenarios done</source>
        <translation>, %1 von %2 Szenarien erledigt</translation>
    </message>
    <message>
        <source>, cumulative sum %1 (mastered at %2)</source>
        <translation>, kumulative Summe %1 (gemeistert bei %2)</translation>
    </message>
    <message>
        <source>Mastered when the cumulative sum (CUSUM) over all its trials reaches %1 and each scenario has been passed</source>
        <translation>Gemeistert, wenn die kumulative Summe (CUSUM) über alle seine Durchgänge %1 erreicht und jedes Szenario bestanden wurde</translation>
    </message>
    <message>
        <source>Mastered when each scenario has been passed</source>
        <translation>Gemeistert, wenn jedes Szenario bestanden wurde</translation>
    </message>
    <message>
        <source>Mastered when each scenario has been passed %1 times running</source>
        <translation>Gemeistert, wenn jedes Szenario %1-mal hintereinander bestanden wurde</translation>
    </message>
    <message>
        <source>; only assessments count. </source>
        <translation>; nur Prüfungen zählen. </translation>
    </message>
    <message>
        <source>Source: %1. Not validated.</source>
        <translation>Quelle: %1. Nicht validiert.</translation>
    </message>
    <message>
        <source>Opens after %1 is mastered.</source>
        <translation>Öffnet sich, wenn %1 gemeistert ist.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
</context>
<context>
    <name>MonitorPanel</name>
    <message>
        <source>HEART RATE BELOW 60: COMPRESSIONS</source>
        <translation>HERZFREQUENZ UNTER 60: KOMPRESSIONEN</translation>
    </message>
    <message>
        <source>HEART RATE BELOW 100: VENTILATE</source>
        <translation>HERZFREQUENZ UNTER 100: BEATMEN</translation>
    </message>
    <message>
        <source>SpO2 BELOW 80 %</source>
        <translation>SpO2 UNTER 80 %</translation>
    </message>
</context>
<context>
    <name>MouseIntroduction</name>
    <message>
        <source>&lt;tr&gt;&lt;td&gt;&lt;b&gt;Drag, wheel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;moves it in the picture; wheel forward: deeper into the mouth&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ctrl-drag&lt;/b&gt;&lt;/td&gt;&lt;td&gt;turns it about its tip; so do a drag with the right button and W A S D (Q E: roll)&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Space&lt;/b&gt;&lt;/td&gt;&lt;td&gt;held: lifts the blade along its handle; Backspace lowers&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Shift, + and -&lt;/b&gt;&lt;/td&gt;&lt;td&gt;held: all of it finer; farther, or less far, for the same way&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Arrows, PgUp, PgDn &amp;nbsp;&lt;/b&gt;&lt;/td&gt;&lt;td&gt;move it without a mouse&lt;/td&gt;&lt;/tr&gt;</source>
        <translation>&lt;tr&gt;&lt;td&gt;&lt;b&gt;Ziehen, Mausrad&lt;/b&gt;&lt;/td&gt;&lt;td&gt;bewegt es im Bild; Rad nach vorn: tiefer in den Mund&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Strg-Ziehen&lt;/b&gt;&lt;/td&gt;&lt;td&gt;dreht es um seine Spitze; ebenso Ziehen mit der rechten Taste und W A S D (Q E: rollen)&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Leertaste&lt;/b&gt;&lt;/td&gt;&lt;td&gt;gehalten: hebt den Spatel längs seines Griffs; Rücktaste senkt&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Umschalt, + und -&lt;/b&gt;&lt;/td&gt;&lt;td&gt;gehalten: alles feiner; weiter oder weniger weit bei gleichem Weg&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Pfeile, Bild auf/ab &amp;nbsp;&lt;/b&gt;&lt;/td&gt;&lt;td&gt;bewegen es ohne Maus&lt;/td&gt;&lt;/tr&gt;</translation>
    </message>
    <message>
        <source>&lt;tr&gt;&lt;td&gt;&lt;b&gt;X&lt;/b&gt; (or Tab)&lt;/td&gt;&lt;td&gt;the other hand: blade or tube; what you let go of stays where it is&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, L&lt;/b&gt;&lt;/td&gt;&lt;td&gt;held: breaths, by mask, or by the tube once it is in; pressure on the larynx&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;C, V&lt;/b&gt;&lt;/td&gt;&lt;td&gt;suction catheter instead of the tube, and back; V held sucks&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;T&lt;/b&gt;&lt;/td&gt;&lt;td&gt;draws the stylet out of the tube&lt;/td&gt;&lt;/tr&gt;</source>
        <translation>&lt;tr&gt;&lt;td&gt;&lt;b&gt;X&lt;/b&gt; (oder Tab)&lt;/td&gt;&lt;td&gt;die andere Hand: Spatel oder Tubus; was Sie loslassen, bleibt, wo es ist&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;B, L&lt;/b&gt;&lt;/td&gt;&lt;td&gt;gehalten: Beatmung mit Maske, oder durch den Tubus, sobald er liegt; Druck auf den Kehlkopf&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;C, V&lt;/b&gt;&lt;/td&gt;&lt;td&gt;Absaugkatheter statt des Tubus und zurück; V gehalten saugt&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;T&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zieht den Führungsstab aus dem Tubus&lt;/td&gt;&lt;/tr&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Tube in at the right corner, beside the blade; the black mark goes to the cords. Never push against resistance.&lt;br&gt;Heart rate below 100: out, and ventilate. Five or six breaths tell by the CO2 detector.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Tubus am rechten Mundwinkel hinein, neben dem Spatel; die schwarze Marke kommt an die Stimmlippen. Nie gegen Widerstand drücken.&lt;br&gt;Herzfrequenz unter 100: heraus und beatmen. Fünf oder sechs Beatmungen zeigen es am CO2-Detektor.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>A mouse cannot push back: the bars on the right show the force your blade puts on tongue and gum.</source>
        <translation>Eine Maus kann nicht zurückdrücken: Die Balken rechts zeigen die Kraft Ihres Spatels auf Zunge und Zahnleiste.</translation>
    </message>
    <message>
        <source>A mouse cannot push back.</source>
        <translation>Eine Maus kann nicht zurückdrücken.</translation>
    </message>
    <message>
        <source>Lift, do not lever. A solid grey blade is your hand, where the blade could not follow it.</source>
        <translation>Heben, nicht hebeln. Ein fester grauer Spatel ist Ihre Hand, wo der Spatel ihr nicht folgen konnte.</translation>
    </message>
    <message>
        <source>The blade you can see through, which moves by itself, is an expert&apos;s.</source>
        <translation>Der durchscheinende Spatel, der sich von selbst bewegt, ist der eines Experten.</translation>
    </message>
</context>
<context>
    <name>OpenOutside</name>
    <message>
        <source>%1 is not there any more.</source>
        <translation>%1 ist nicht mehr da.</translation>
    </message>
    <message>
        <source>No program was found here that opens it; with a browser it can be read: %1</source>
        <translation>Hier wurde kein Programm gefunden, das ihn öffnet; mit einem Browser ist er zu lesen: %1</translation>
    </message>
</context>
<context>
    <name>PassWords</name>
    <message>
        <source>Passes with: at most %1 N on the tongue and %2 N on the gum, at least %3 % of the glottis seen, within %4 s, at most %5 s above the training target of %6 N on the tongue and %7 s at the device&apos;s force limit.</source>
        <translation>Bestanden mit: höchstens %1 N auf die Zunge und %2 N auf die Zahnleiste, mindestens %3 % der Glottis gesehen, innerhalb von %4 s, höchstens %5 s über dem Trainingsziel von %6 N auf die Zunge und %7 s an der Kraftgrenze des Geräts.</translation>
    </message>
    <message>
        <source>outcome: %1</source>
        <translation>Ergebnis: %1</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>at most %1 attempts</source>
        <translation>höchstens %1 Intubationsversuche</translation>
    </message>
    <message>
        <source>at most %1 s from the view to the cords passed</source>
        <translation>höchstens %1 s von der Sicht bis hinter die Stimmlippen</translation>
    </message>
    <message>
        <source>SpO2 not below %1 %</source>
        <translation>SpO2 nicht unter %1 %</translation>
    </message>
    <message>
        <source>heart rate not below %1</source>
        <translation>Herzfrequenz nicht unter %1</translation>
    </message>
    <message>
        <source>at most %1 N along the tube</source>
        <translation>höchstens %1 N längs des Tubus</translation>
    </message>
    <message>
        <source>the place confirmed by CO2</source>
        <translation>die Lage durch CO2 bestätigt</translation>
    </message>
    <message>
        <source>good depth with the head neutral, too</source>
        <translation>gute Tiefe auch bei neutralem Kopf</translation>
    </message>
    <message>
        <source>a tube in the oesophagus recognised within %1 breaths</source>
        <translation>ein Tubus im Ösophagus innerhalb von %1 Beatmungen erkannt</translation>
    </message>
    <message>
        <source>no fall of saturation by 20 points in an attempt</source>
        <translation>kein Abfall der Sättigung um 20 Punkte in einem Intubationsversuch</translation>
    </message>
    <message>
        <source>The tube: %1.</source>
        <translation>Der Tubus: %1.</translation>
    </message>
</context>
<context>
    <name>PersonWords</name>
    <message>
        <source>instructor</source>
        <translation>Lehrperson</translation>
    </message>
    <message>
        <source>trainee</source>
        <translation>Lernende</translation>
    </message>
    <message>
        <source>Deleted: %1 trials, %2 notes, %3 files on this computer.</source>
        <translation>Gelöscht: %1 Durchgänge, %2 Notizen, %3 Dateien auf diesem Rechner.</translation>
    </message>
    <message>
        <source>Still to be deleted: %1</source>
        <translation>Noch zu löschen: %1</translation>
    </message>
    <message>
        <source>%1 with all trials, figures, ratings and notes, and the trials&apos; files: on this computer now, on others when they start next. Only a number stays in the audit trail. Nobody can bring it back; export first what is to be kept.</source>
        <translation>%1 mit allen Durchgängen, Messwerten, Bewertungen und Notizen und den Dateien der Durchgänge: auf diesem Rechner jetzt, auf anderen bei deren nächstem Start. Nur eine Nummer bleibt im Protokoll. Niemand kann es zurückholen; exportieren Sie zuerst, was bleiben soll.</translation>
    </message>
    <message>
        <source>Delete for good</source>
        <translation>Endgültig löschen</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
</context>
<context>
    <name>ProgressTab</name>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
    <message numerus="yes">
        <source>after %n trial(s)</source>
        <translation>
            <numerusform>nach %n Durchgang</numerusform>
            <numerusform>nach %n Durchgängen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s), %1 passed</source>
        <translation>
            <numerusform>%n Durchgang, %1 bestanden</numerusform>
            <numerusform>%n Durchgänge, %1 bestanden</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>QualityGovernor</name>
    <message>
        <source>rim light</source>
        <translation>Randlicht</translation>
    </message>
    <message>
        <source>shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>fine tongue</source>
        <translation>feine Zunge</translation>
    </message>
    <message>
        <source>resolution (%1 %)</source>
        <translation>Auflösung (%1 %)</translation>
    </message>
    <message>
        <source>Drawn with less to stay fluent: %1</source>
        <translation>Einfacher gezeichnet, um flüssig zu bleiben: %1</translation>
    </message>
    <message>
        <source>cut and video in turn</source>
        <translation>Schnitt und Video im Wechsel</translation>
    </message>
</context>
<context>
    <name>RatingWords</name>
    <message>
        <source>%1: yes</source>
        <translation>%1: ja</translation>
    </message>
    <message>
        <source>%1: no</source>
        <translation>%1: nein</translation>
    </message>
    <message>
        <source>%1 of 5</source>
        <translation>%1 von 5</translation>
    </message>
    <message>
        <source>%1 of 5, %2</source>
        <translation>%1 von 5, %2</translation>
    </message>
    <message>
        <source>The trainee&apos;s own rating: %1</source>
        <translation>Eigene Bewertung der Lernenden: %1</translation>
    </message>
    <message>
        <source>You as the instructor: %1</source>
        <translation>Sie als Lehrperson: %1</translation>
    </message>
    <message>
        <source>An instructor: %1</source>
        <translation>Eine Lehrperson: %1</translation>
    </message>
</context>
<context>
    <name>RecentFiles</name>
    <message>
        <source>Patient: %1</source>
        <translation>Patient: %1</translation>
    </message>
    <message>
        <source>Course: %1</source>
        <translation>Kurs: %1</translation>
    </message>
    <message>
        <source>Trial: %1, %2</source>
        <translation>Durchgang: %1, %2</translation>
    </message>
    <message>
        <source>CT: %1</source>
        <translation>CT: %1</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Trial: %1</source>
        <translation>Durchgang: %1</translation>
    </message>
    <message>
        <source>Scenario %1, %2, seed %3, device %4, patient %5</source>
        <translation>Szenario %1, %2, Startwert %3, Gerät %4, Patient %5</translation>
    </message>
    <message>
        <source>%1 to %2 UTC</source>
        <translation>%1 bis %2 UTC</translation>
    </message>
    <message>
        <source>Patient %1, scenario %2</source>
        <translation>Patient %1, Szenario %2</translation>
    </message>
    <message>
        <source>The shaded span is the attempt, blade into the mouth to blade out; grey is a pause, in which the device could not be used. Tongue and gum: force of the tissue on the blade (model force). The dotted line is what the device was told to show. A peak is the largest single tick of 1 ms, unfiltered. Time over the device limit counts until a device that was lost has taken hold again.</source>
        <translation>Die getönte Spanne ist der Intubationsversuch, Spatel in den Mund bis Spatel heraus; grau ist eine Pause, in der das Gerät nicht zu gebrauchen war. Zunge und Zahnleiste: Kraft des Gewebes auf den Spatel (Modellkraft). Die gepunktete Linie ist, was das Gerät zeigen sollte. Ein Höchstwert ist der größte einzelne Takt von 1 ms, ungefiltert. Die Zeit über der Gerätegrenze zählt, bis ein verlorenes Gerät wieder gefasst hat.</translation>
    </message>
    <message>
        <source>Vallecula is a training tool, not a medical device. Limits and targets are training targets, not injury thresholds.</source>
        <translation>Vallecula ist ein Trainingsgerät, kein Medizinprodukt. Grenzen und Ziele sind Trainingsziele, keine Verletzungsschwellen.</translation>
    </message>
</context>
<context>
    <name>ResultPage</name>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Same attempt again</source>
        <translation>Derselbe Versuch noch einmal</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Other scenario</source>
        <translation>Anderes Szenario</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
</context>
<context>
    <name>SeriesRows</name>
    <message>
        <source>No series</source>
        <translation>Keine Serie</translation>
    </message>
</context>
<context>
    <name>SoundOutput</name>
    <message>
        <source>No sound: the loudspeaker could not be opened. Another program may have it.</source>
        <translation>Kein Ton: Der Lautsprecher ließ sich nicht öffnen. Vielleicht hat ihn ein anderes Programm.</translation>
    </message>
</context>
<context>
    <name>SourcePage</name>
    <message>
        <source>Name, number, dates and all other text of the scan are left out of the new patient. The surface of the face is the patient&apos;s own, though, and whoever knows the patient may recognise it: treat the package as patient data.</source>
        <translation>Name, Nummer, Daten und aller übriger Text des Scans bleiben aus dem neuen Patienten heraus. Die Oberfläche des Gesichts ist allerdings die eigene, und wer den Patienten kennt, mag ihn erkennen: Behandeln Sie das Paket wie Patientendaten.</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>Whoever has finished this course can:</source>
        <translation>Wer diesen Kurs abgeschlossen hat, kann:</translation>
    </message>
    <message>
        <source>&amp;Write a course ...</source>
        <translation>Kurs &amp;schreiben ...</translation>
    </message>
    <message>
        <source>Create, change, try, compare and share courses</source>
        <translation>Kurse anlegen, ändern, ausprobieren, vergleichen und weitergeben</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Device settings ...</source>
        <translation>Einstellungen ...</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Tube&apos;s hand</source>
        <translation>Hand des Tubus</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
</context>
<context>
    <name>StatementsLine</name>
    <message>
        <source>Learning record store: nothing waits to be sent</source>
        <translation>Learning Record Store: nichts wartet auf das Senden</translation>
    </message>
    <message numerus="yes">
        <source>Learning record store: %n trial(s) wait to be sent</source>
        <translation>
            <numerusform>Learning Record Store: %n Durchgang wartet auf das Senden</numerusform>
            <numerusform>Learning Record Store: %n Durchgänge warten auf das Senden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) refused (%1)</source>
        <translation>
            <numerusform>%n Durchgang abgelehnt (%1)</numerusform>
            <numerusform>%n Durchgänge abgelehnt (%1)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Tables</name>
    <message>
        <source>yyyy-MM-dd HH:mm</source>
        <extracomment>A moment in a table, as QDateTime::toString() takes it: all four figures of the year, for trials are kept for years</extracomment>
        <translation>dd.MM.yyyy HH:mm</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::AboutDialog</name>
    <message>
        <source>About Vallecula</source>
        <translation>Über Vallecula</translation>
    </message>
    <message>
        <source>Vallecula %1</source>
        <translation>Vallecula %1</translation>
    </message>
    <message>
        <source>A force-true trainer for neonatal endotracheal intubation. A training tool, not a medical device: it is not made for diagnosis or treatment, and practice here does not replace supervised practice.

Free software under the GNU Affero General Public License, version 3, because TetGen is; without any warranty. The other parts keep their own licences.</source>
        <translation>Ein krafttreuer Trainer für die endotracheale Intubation Neugeborener. Ein Trainingsgerät, kein Medizinprodukt: Er ist nicht für Diagnose oder Behandlung gemacht, und Üben hier ersetzt kein Üben unter Aufsicht.

Freie Software unter der GNU Affero General Public License, Version 3, weil TetGen es ist; ohne jede Gewährleistung. Die anderen Teile behalten ihre eigenen Lizenzen.</translation>
    </message>
    <message>
        <source>Parts of the program</source>
        <translation>Teile des Programms</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation>Gezeichnet von %1</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::AccountTab</name>
    <message>
        <source>Sign in to have your trials counted as yours. Nobody needs to: without signing in one practises all the same, and the trials belong to nobody.</source>
        <translation>Melden Sie sich an, damit Ihre Durchgänge als Ihre zählen. Niemand muss es: Ohne Anmeldung übt man ebenso, und die Durchgänge gehören niemandem.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;PIN</source>
        <translation>&amp;PIN</translation>
    </message>
    <message>
        <source>Register as a &amp;trainee ...</source>
        <translation>Als Lernende &amp;registrieren ...</translation>
    </message>
    <message>
        <source>Set up the first &amp;instructor ...</source>
        <translation>Erste Lehrperson e&amp;inrichten ...</translation>
    </message>
    <message>
        <source>Trials from now on are yours. Sign out when somebody else takes the blade. All that is kept of you you can take along as a folder of open files, or have deleted whole.</source>
        <translation>Von jetzt an sind Durchgänge Ihre. Melden Sie sich ab, wenn jemand anderes den Spatel nimmt. Alles, was von Ihnen aufbewahrt wird, können Sie als Ordner offener Dateien mitnehmen oder ganz löschen lassen.</translation>
    </message>
    <message>
        <source>Sign &amp;out</source>
        <translation>Ab&amp;melden</translation>
    </message>
    <message>
        <source>Change &amp;PIN ...</source>
        <translation>&amp;PIN ändern ...</translation>
    </message>
    <message>
        <source>&amp;Export all my data ...</source>
        <translation>Alle meine Daten &amp;exportieren ...</translation>
    </message>
    <message>
        <source>&amp;Delete me ...</source>
        <translation>Mich &amp;löschen ...</translation>
    </message>
    <message>
        <source>Choose where the export&apos;s folder is made</source>
        <translation>Wählen Sie, wo der Ordner des Exports angelegt wird</translation>
    </message>
    <message>
        <source>Too many wrong PINs: wait %1 s, or ask an instructor for a new PIN.</source>
        <translation>Zu viele falsche PINs: Warten Sie %1 s oder bitten Sie eine Lehrperson um eine neue PIN.</translation>
    </message>
    <message>
        <source>Try the PIN again.</source>
        <translation>Versuchen Sie die PIN erneut.</translation>
    </message>
    <message>
        <source>Looking at the PIN ...</source>
        <translation>Die PIN wird geprüft ...</translation>
    </message>
    <message>
        <source>Set up the instructor</source>
        <translation>Lehrperson einrichten</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>An instructor sees everybody&apos;s progress, rates and notes, gives new PINs and deletes people. There is no way in without this PIN: keep it.</source>
        <translation>Eine Lehrperson sieht den Fortschritt aller, bewertet und notiert, vergibt neue PINs und löscht Personen. Ohne diese PIN führt kein Weg hinein: Bewahren Sie sie auf.</translation>
    </message>
    <message>
        <source>A name or a pseudonym, as you like to be seen in the list. Nobody else can see your PIN; an instructor can give you a new one.</source>
        <translation>Ein Name oder ein Pseudonym, wie Sie in der Liste erscheinen möchten. Niemand sonst kann Ihre PIN sehen; eine Lehrperson kann Ihnen eine neue geben.</translation>
    </message>
    <message>
        <source>Change PIN</source>
        <translation>PIN ändern</translation>
    </message>
    <message>
        <source>The old one first, so that nobody does it in your place.</source>
        <translation>Zuerst die alte, damit es niemand an Ihrer Stelle tut.</translation>
    </message>
    <message>
        <source>The PIN is changed.</source>
        <translation>Die PIN ist geändert.</translation>
    </message>
    <message>
        <source>Exporting ...</source>
        <translation>Wird exportiert ...</translation>
    </message>
    <message>
        <source>All that is kept of you is in %1, in the folder you chose.</source>
        <translation>Alles, was von Ihnen aufbewahrt wird, liegt in %1 im gewählten Ordner.</translation>
    </message>
    <message>
        <source>Delete yourself?</source>
        <translation>Sich selbst löschen?</translation>
    </message>
    <message>
        <source>This deletes you</source>
        <translation>Dies löscht Sie</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::AskPerson</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::AuthoringPage</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>To the start page</source>
        <translation>Zur Startseite</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>An empty course, or a copy of one there is</source>
        <translation>Ein leerer Kurs oder eine Kopie eines vorhandenen</translation>
    </message>
    <message>
        <source>Empty course</source>
        <translation>Leerer Kurs</translation>
    </message>
    <message>
        <source>A copy of</source>
        <translation>Eine Kopie von</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>A course of your own, a shipped one, or a file you were given</source>
        <translation>Ein eigener Kurs, ein mitgelieferter oder eine erhaltene Datei</translation>
    </message>
    <message>
        <source>Another file ...</source>
        <translation>Andere Datei ...</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save a copy ...</source>
        <translation>Kopie ...</translation>
    </message>
    <message>
        <source>One file, to hand on or keep elsewhere</source>
        <translation>Eine Datei, zum Weitergeben oder Aufbewahren</translation>
    </message>
    <message>
        <source>Add to mine</source>
        <translation>Zu meinen</translation>
    </message>
    <message>
        <source>Keep this file among your own courses, so that the start page offers it</source>
        <translation>Diese Datei unter den eigenen Kursen aufbewahren, damit die Startseite sie anbietet</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Try this scenario</source>
        <translation>Ausprobieren</translation>
    </message>
    <message>
        <source>Play it as it stands here, saved or not (F5)</source>
        <translation>Spielen, wie es hier steht, gespeichert oder nicht (F5)</translation>
    </message>
    <message>
        <source>Drag to another place, or Alt and the arrow keys</source>
        <translation>An eine andere Stelle ziehen, oder Alt und die Pfeiltasten</translation>
    </message>
    <message>
        <source>Add scenario</source>
        <translation>Szenario hinzu</translation>
    </message>
    <message>
        <source>At the end of the module</source>
        <translation>Am Ende des Moduls</translation>
    </message>
    <message>
        <source>Add module</source>
        <translation>Modul hinzu</translation>
    </message>
    <message>
        <source>With one scenario</source>
        <translation>Mit einem Szenario</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>The chosen module or scenario once more</source>
        <translation>Das gewählte Modul oder Szenario noch einmal</translation>
    </message>
    <message>
        <source>Copy from ...</source>
        <translation>Kopieren aus ...</translation>
    </message>
    <message>
        <source>A module or scenario of another course</source>
        <translation>Ein Modul oder Szenario eines anderen Kurses</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>The chosen module or scenario</source>
        <translation>Das gewählte Modul oder Szenario</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Earlier in the course (Alt+Up)</source>
        <translation>Früher im Kurs (Alt+Hoch)</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
    <message>
        <source>Later in the course (Alt+Down)</source>
        <translation>Später im Kurs (Alt+Runter)</translation>
    </message>
    <message>
        <source>Divide into modules</source>
        <translation>In Module teilen</translation>
    </message>
    <message>
        <source>This course was written before there were modules: put its scenarios into one</source>
        <translation>Dieser Kurs wurde geschrieben, bevor es Module gab: Seine Szenarien kommen in eines</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Formular</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>ungespeichert</translation>
    </message>
    <message>
        <source>Save as mine</source>
        <translation>Als eigenen speichern</translation>
    </message>
    <message>
        <source>A shipped course stays as it is: this is kept among your own (Ctrl+S)</source>
        <translation>Ein mitgelieferter Kurs bleibt, wie er ist: Dieser kommt zu Ihren eigenen (Strg+S)</translation>
    </message>
    <message>
        <source>Undo: %1 (Ctrl+Z)</source>
        <translation>Rückgängig: %1 (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo: %1 (Ctrl+Shift+Z)</source>
        <translation>Wiederholen: %1 (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Checking ...</source>
        <translation>Wird geprüft ...</translation>
    </message>
    <message>
        <source>Nothing is wrong: this course can be practised.</source>
        <translation>Nichts ist falsch: Mit diesem Kurs kann geübt werden.</translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) to mend; a click leads there:</source>
        <translation>
            <numerusform>%n Stelle zu beheben; ein Klick führt hin:</numerusform>
            <numerusform>%n Stellen zu beheben; ein Klick führt hin:</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a scenario on the left</source>
        <translation>Wählen Sie links ein Szenario</translation>
    </message>
    <message>
        <source>What is listed below is to be mended first</source>
        <translation>Was unten steht, ist zuerst zu beheben</translation>
    </message>
    <message>
        <source>My course</source>
        <translation>Mein Kurs</translation>
    </message>
    <message>
        <source>A copy of %1, not saved yet.</source>
        <translation>Eine Kopie von %1, noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Open a course</source>
        <translation>Einen Kurs öffnen</translation>
    </message>
    <message>
        <source>This course came with Vallecula and stays as it is; what you change is saved among your own.</source>
        <translation>Dieser Kurs kam mit Vallecula und bleibt, wie er ist; was Sie ändern, wird unter Ihren eigenen gespeichert.</translation>
    </message>
    <message>
        <source>This file can only be looked at here: what is wrong with it is said below. Nothing in it is changed.</source>
        <translation>Diese Datei kann hier nur angesehen werden: Was an ihr falsch ist, steht unten. Nichts in ihr wird geändert.</translation>
    </message>
    <message>
        <source>It is not saved: %1 has the id &apos;%2&apos; too, and the records would take the two courses for one. Give this one another id (the course itself on the left, then Id), and save again.</source>
        <translation>Nicht gespeichert: %1 hat ebenfalls die Kennung „%2“, und die Aufzeichnungen hielten beide Kurse für einen. Geben Sie diesem eine andere Kennung (der Kurs selbst links, dann Id) und speichern Sie erneut.</translation>
    </message>
    <message>
        <source>Changed by another program</source>
        <translation>Von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>%1 was changed by another program since it was opened here. Overwrite it?</source>
        <translation>%1 wurde von einem anderen Programm geändert, seit es hier geöffnet wurde. Überschreiben?</translation>
    </message>
    <message>
        <source>It is not saved. Save a copy keeps both; Open shows what the file has now.</source>
        <translation>Nicht gespeichert. „Kopie ...“ behält beide; „Öffnen“ zeigt, was jetzt in der Datei steht.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>Saved as %1. It can be practised once nothing is wrong with it.</source>
        <translation>Gespeichert als %1. Geübt werden kann damit, sobald nichts mehr falsch ist.</translation>
    </message>
    <message>
        <source>Give it an id of its own</source>
        <translation>Eigene Kennung geben</translation>
    </message>
    <message>
        <source>Save a copy of the course</source>
        <translation>Eine Kopie des Kurses speichern</translation>
    </message>
    <message>
        <source>A copy was saved; whoever gets the file opens it here, or checks it with `vallecula curriculum check`.</source>
        <translation>Eine Kopie wurde gespeichert; wer die Datei erhält, öffnet sie hier oder prüft sie mit `vallecula curriculum check`.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The course has changes that are not saved.</source>
        <translation>Der Kurs hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Shipped: %1</source>
        <translation>Mitgeliefert: %1</translation>
    </message>
    <message>
        <source>Mine: %1</source>
        <translation>Eigener: %1</translation>
    </message>
    <message>
        <source>Modules, with their scenarios</source>
        <translation>Module mit ihren Szenarien</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Szenarien</translation>
    </message>
    <message>
        <source>The text cannot be read as it is: %1</source>
        <translation>Der Text lässt sich so nicht lesen: %1</translation>
    </message>
    <message>
        <source>Add a scenario</source>
        <translation>Ein Szenario hinzufügen</translation>
    </message>
    <message>
        <source>This course has no modules yet: divide it into modules first.</source>
        <translation>Dieser Kurs hat noch keine Module: Teilen Sie ihn zuerst in Module.</translation>
    </message>
    <message>
        <source>Add a module</source>
        <translation>Ein Modul hinzufügen</translation>
    </message>
    <message>
        <source>Choose a module or a scenario on the left; New makes a copy of a whole course.</source>
        <translation>Wählen Sie links ein Modul oder Szenario; „Neu“ kopiert einen ganzen Kurs.</translation>
    </message>
    <message>
        <source>Copy a module</source>
        <translation>Ein Modul kopieren</translation>
    </message>
    <message>
        <source>Copy a scenario</source>
        <translation>Ein Szenario kopieren</translation>
    </message>
    <message>
        <source>Choose a module or a scenario on the left.</source>
        <translation>Wählen Sie links ein Modul oder Szenario.</translation>
    </message>
    <message>
        <source>Delete the module</source>
        <translation>Das Modul löschen</translation>
    </message>
    <message>
        <source>Delete the scenario</source>
        <translation>Das Szenario löschen</translation>
    </message>
    <message>
        <source>Choose a scenario on the left to try it.</source>
        <translation>Wählen Sie links ein Szenario zum Ausprobieren.</translation>
    </message>
    <message>
        <source>It cannot be tried yet: %1</source>
        <translation>Es kann noch nicht ausprobiert werden: %1</translation>
    </message>
    <message>
        <source>Go on writing</source>
        <translation>Weiterschreiben</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::BladeControl</name>
    <message>
        <source>Drag: move the tube   |   wheel or PgUp PgDn: in, out   |   Q E: turn it about its length   |   Ctrl-drag, right-drag or W A S D: tilt it   |   Shift: fine   |   + -: gain, now %1</source>
        <translation>Ziehen: Tubus bewegen   |   Rad oder Bild auf/ab: hinein, heraus   |   Q E: um die Längsachse drehen   |   Strg-Ziehen, rechts ziehen oder W A S D: kippen   |   Umschalt: fein   |   + -: Verstärkung, jetzt %1</translation>
    </message>
    <message>
        <source>Drag: move the blade   |   Ctrl-drag, right-drag or W A S D: turn it (Q E: roll)   |   wheel or PgUp PgDn: deeper, back   |   arrows: move (Shift: fine)   |   hold Space: lift along the handle, Backspace: lower   |   + -: gain, now %1</source>
        <translation>Ziehen: Spatel bewegen   |   Strg-Ziehen, rechts ziehen oder W A S D: drehen (Q E: rollen)   |   Rad oder Bild auf/ab: tiefer, zurück   |   Pfeile: bewegen (Umschalt: fein)   |   Leertaste halten: längs des Griffs heben, Rücktaste: senken   |   + -: Verstärkung, jetzt %1</translation>
    </message>
    <message>
        <source>move it to the right and left</source>
        <translation>nach rechts und links bewegen</translation>
    </message>
    <message>
        <source>move it up and down in the picture</source>
        <translation>im Bild nach oben und unten bewegen</translation>
    </message>
    <message>
        <source>deeper, back</source>
        <translation>tiefer, zurück</translation>
    </message>
    <message>
        <source>raise and lower its outer end</source>
        <translation>das äußere Ende heben und senken</translation>
    </message>
    <message>
        <source>turn it to the left and right</source>
        <translation>nach links und rechts drehen</translation>
    </message>
    <message>
        <source>roll it about its length</source>
        <translation>um die Längsachse rollen</translation>
    </message>
    <message>
        <source>held: lift along the handle, lower</source>
        <translation>gehalten: längs des Griffs heben, senken</translation>
    </message>
    <message>
        <source>farther, and less far, for the same way of the hand</source>
        <translation>weiter und weniger weit bei gleichem Weg der Hand</translation>
    </message>
    <message>
        <source>held: all of it finer</source>
        <translation>gehalten: alles feiner</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::BuildPage</name>
    <message>
        <source>L&amp;eave</source>
        <translation>V&amp;erlassen</translation>
    </message>
    <message>
        <source>Back to the &amp;check</source>
        <translation>Zurück zur Prü&amp;fung</translation>
    </message>
    <message>
        <source>Build a&amp;gain</source>
        <translation>Erneut ba&amp;uen</translation>
    </message>
    <message>
        <source>&amp;Save the patient</source>
        <translation>Patient &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Practise with this patient</source>
        <translation>Damit ü&amp;ben</translation>
    </message>
    <message>
        <source>&amp;Leave mouth and neck as scanned</source>
        <translation>Mund und Hals w&amp;ie gescannt</translation>
    </message>
    <message>
        <source>Else a closed mouth is opened and the neck extended, as for an intubation</source>
        <translation>Sonst wird ein geschlossener Mund geöffnet und der Hals gestreckt, wie zur Intubation</translation>
    </message>
    <message>
        <source>Scale to a &amp;newborn&apos;s size</source>
        <translation>Auf &amp;Neugeborenengröße skalieren</translation>
    </message>
    <message>
        <source>All lengths, so that the skull is as broad as a term newborn&apos;s</source>
        <translation>Alle Längen, sodass der Schädel so breit ist wie bei einem reifen Neugeborenen</translation>
    </message>
    <message>
        <source>Tetrahedra of the tongue</source>
        <translation>Tetraeder der Zunge</translation>
    </message>
    <message>
        <source>About so many (within 10 %): more are finer and slower</source>
        <translation>Etwa so viele (auf 10 %): mehr sind feiner und langsamer</translation>
    </message>
    <message>
        <source>Name of the new patient</source>
        <translation>Name des neuen Patienten</translation>
    </message>
    <message>
        <source>&amp;Tetrahedra of the tongue</source>
        <translation>&amp;Tetraeder der Zunge</translation>
    </message>
    <message>
        <source>Na&amp;me of the new patient</source>
        <translation>Na&amp;me des neuen Patienten</translation>
    </message>
    <message>
        <source>Building the patient</source>
        <translation>Der Patient wird gebaut</translation>
    </message>
    <message>
        <source>Bringing the patient into position</source>
        <translation>Der Patient wird gelagert</translation>
    </message>
    <message>
        <source>The patient is built. Nothing stands out.</source>
        <translation>Der Patient ist gebaut. Nichts fällt auf.</translation>
    </message>
    <message numerus="yes">
        <source>The patient is built. %n thing(s) to be checked before it is saved.</source>
        <translation>
            <numerusform>Der Patient ist gebaut. Eine Sache ist vor dem Speichern zu prüfen.</numerusform>
            <numerusform>Der Patient ist gebaut. %n Dinge sind vor dem Speichern zu prüfen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing the patient</source>
        <translation>Der Patient wird geschrieben</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>In %1</translation>
    </message>
    <message>
        <source>The patient could not be built.</source>
        <translation>Der Patient konnte nicht gebaut werden.</translation>
    </message>
    <message>
        <source>The patient is saved and chosen for the next trial.</source>
        <translation>Der Patient ist gespeichert und für den nächsten Durchgang gewählt.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ChartView</name>
    <message>
        <source>Drawing ...</source>
        <translation>Wird gezeichnet ...</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::CheckPage</name>
    <message>
        <source>Under the pointer</source>
        <translation>Unter dem Zeiger</translation>
    </message>
    <message>
        <source>Place under the pointer (mm to the patient&apos;s left, back and head, as the scan has them), grey value (HU) and structure</source>
        <translation>Ort unter dem Zeiger (mm nach links, hinten und kopfwärts vom Patienten aus, wie der Scan sie hat), Grauwert (HU) und Struktur</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Kreuz</translation>
    </message>
    <message>
        <source>Take all slices to a point; drag landmarks</source>
        <translation>Alle Schnitte an einen Punkt führen; Landmarken ziehen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Window and level (HU). Drag: right wider, up darker; the right button does it with any tool</source>
        <translation>Fensterung (HU). Ziehen: rechts breiter, aufwärts dunkler; die rechte Taste tut es mit jedem Werkzeug</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>Length (mm). Drag, or click two points; Delete takes the last one away</source>
        <translation>Länge (mm). Ziehen oder zwei Punkte anklicken; Entf nimmt das letzte weg</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angle (degrees). Click three points, the corner second</source>
        <translation>Winkel (Grad). Drei Punkte anklicken, den Scheitel als zweiten</translation>
    </message>
    <message>
        <source>Window and level for</source>
        <translation>Fensterung für</translation>
    </message>
    <message>
        <source>Window and level for these tissues</source>
        <translation>Fensterung für diese Gewebe</translation>
    </message>
    <message>
        <source>Window and level, HU</source>
        <translation>Fensterung, HU</translation>
    </message>
    <message>
        <source>Opacity of the labels</source>
        <translation>Deckkraft der Strukturen</translation>
    </message>
    <message>
        <source>Opacity of the structures&apos; colours in the slices, %</source>
        <translation>Deckkraft der Strukturfarben in den Schnitten, %</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>S&amp;tructures</source>
        <translation>S&amp;trukturen</translation>
    </message>
    <message>
        <source>Land&amp;marks</source>
        <translation>Land&amp;marken</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>L&amp;oad ...</source>
        <translation>&amp;Laden ...</translation>
    </message>
    <message>
        <source>Labels (.nrrd) and landmarks (.mrk.json beside them), to be painted and moved there</source>
        <translation>Labels (.nrrd) und Landmarken (.mrk.json daneben), um sie dort zu malen und zu verschieben</translation>
    </message>
    <message>
        <source>A label map (all structures in it) or landmarks (.mrk.json), as 3D Slicer saves them.
A label map without names (NIfTI) is read by these values: %1</source>
        <translation>Eine Label-Karte (alle Strukturen darin) oder Landmarken (.mrk.json), wie 3D Slicer sie speichert.
Eine Label-Karte ohne Namen (NIfTI) wird nach diesen Werten gelesen: %1</translation>
    </message>
    <message>
        <source>Choose a label map</source>
        <translation>Eine Label-Karte wählen</translation>
    </message>
    <message>
        <source>Label maps and landmarks (*.nrrd *.nii *.nii.gz *.dcm *.mrk.json);;All files (*)</source>
        <translation>Label-Karten und Landmarken (*.nrrd *.nii *.nii.gz *.dcm *.mrk.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the labels</source>
        <translation>Die Labels speichern</translation>
    </message>
    <message>
        <source>Label maps (*.nrrd)</source>
        <translation>Label-Karten (*.nrrd)</translation>
    </message>
    <message>
        <source>Run a&amp;gain with the edits</source>
        <translation>Erneut a&amp;usführen</translation>
    </message>
    <message>
        <source>Finds the structures anew with the seeds, thresholds, label maps and landmarks given</source>
        <translation>Sucht die Strukturen neu mit den gegebenen Startpunkten, Schwellen, Label-Karten und Landmarken</translation>
    </message>
    <message>
        <source>L&amp;eave</source>
        <translation>V&amp;erlassen</translation>
    </message>
    <message>
        <source>&amp;Build the patient</source>
        <translation>Patient &amp;bauen</translation>
    </message>
    <message>
        <source>&amp;Quality (%1)</source>
        <translation>&amp;Qualität (%1)</translation>
    </message>
    <message>
        <source>To be checked first: %1</source>
        <translation>Zuerst zu prüfen: %1</translation>
    </message>
    <message>
        <source>Choose a structure on the right and give it a seed, a threshold or a label map, then run again.</source>
        <translation>Wählen Sie rechts eine Struktur und geben Sie ihr einen Startpunkt, eine Schwelle oder eine Label-Karte, dann führen Sie es erneut aus.</translation>
    </message>
    <message>
        <source>Reading what was made elsewhere</source>
        <translation>Anderswo Erstelltes wird gelesen</translation>
    </message>
    <message>
        <source>Saving for 3D Slicer</source>
        <translation>Wird für 3D Slicer gespeichert</translation>
    </message>
    <message>
        <source>Save fo&amp;r 3D Slicer ...</source>
        <translation>Fü&amp;r 3D Slicer ...</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::CheckRun</name>
    <message>
        <source>Found and opened</source>
        <translation>Gefunden und geöffnet</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Directions of motion</source>
        <translation>Bewegungsrichtungen</translation>
    </message>
    <message>
        <source>Reach over the mouth</source>
        <translation>Reichweite über dem Mund</translation>
    </message>
    <message>
        <source>Directions of force</source>
        <translation>Kraftrichtungen</translation>
    </message>
    <message>
        <source>Buttons and clutch</source>
        <translation>Tasten und Kupplung</translation>
    </message>
    <message>
        <source>%1, serial number %2</source>
        <translation>%1, Seriennummer %2</translation>
    </message>
    <message>
        <source>not come to</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>the device shows no force</source>
        <translation>das Gerät zeigt keine Kraft</translation>
    </message>
    <message>
        <source>no button is the clutch (Device settings)</source>
        <translation>keine Taste ist die Kupplung (Geräteeinstellungen)</translation>
    </message>
    <message>
        <source>it needs no clutch</source>
        <translation>es braucht keine Kupplung</translation>
    </message>
    <message>
        <source>It failed here: %1</source>
        <translation>Hier ist es gescheitert: %1</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>nicht nötig</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>%1 Hz over %2 s, %3 % of the forces late by more than 1 ms</source>
        <translation>%1 Hz über %2 s, %3 % der Kräfte um mehr als 1 ms verspätet</translation>
    </message>
    <message>
        <source>%1 Hz over %2 s, %3 % of the forces late by more than 1 ms, without real-time priority</source>
        <translation>%1 Hz über %2 s, %3 % der Kräfte um mehr als 1 ms verspätet, ohne Echtzeitpriorität</translation>
    </message>
    <message>
        <source>%1: too slow (at least %2 Hz, at most %3 % late). End other programs; use a port of its own</source>
        <translation>%1: zu langsam (mindestens %2 Hz, höchstens %3 % verspätet). Beenden Sie andere Programme; nehmen Sie einen eigenen Anschluss</translation>
    </message>
    <message>
        <source>It went %1. Once more, straight %2</source>
        <translation>Es ging %1. Noch einmal, gerade %2</translation>
    </message>
    <message>
        <source>moved %1, it went %2</source>
        <translation>%1 bewegt, es ging %2</translation>
    </message>
    <message>
        <source>right, up and towards you are as they should be</source>
        <translation>rechts, oben und zu Ihnen hin sind, wie sie sein sollen</translation>
    </message>
    <message>
        <source>%1: axes are exchanged, or the device stands turned (Device settings)</source>
        <translation>%1: Achsen sind vertauscht, oder das Gerät steht gedreht (Geräteeinstellungen)</translation>
    </message>
    <message>
        <source>covers %1 x %2 x %3 mm</source>
        <translation>umfasst %1 x %2 x %3 mm</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>near</source>
        <translation>nah</translation>
    </message>
    <message>
        <source>far</source>
        <translation>fern</translation>
    </message>
    <message>
        <source>pushed %1, the handle went away: hold it</source>
        <translation>Stoß %1, der Griff wich aus: Halten Sie ihn</translation>
    </message>
    <message>
        <source>pushed %1, nothing was felt</source>
        <translation>Stoß %1, nichts gespürt</translation>
    </message>
    <message>
        <source>pushed %1, felt %2</source>
        <translation>Stoß %1, gespürt %2</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>felt as pushed, with %1</source>
        <translation>gespürt wie gestoßen, mit %1</translation>
    </message>
    <message>
        <source>%1 (with %2): do not practise with this device before it is mended</source>
        <translation>%1 (mit %2): Üben Sie nicht mit diesem Gerät, bevor es in Ordnung gebracht ist</translation>
    </message>
    <message>
        <source>button %1 frees the hand; pressed: %2</source>
        <translation>Taste %1 gibt die Hand frei; gedrückt: %2</translation>
    </message>
    <message>
        <source>the device does not move %1</source>
        <translation>das Gerät bewegt sich nicht %1</translation>
    </message>
    <message>
        <source>not reached: %1. Begin in the middle of the device&apos;s range, or make the blade&apos;s way longer (Device settings)</source>
        <translation>nicht erreicht: %1. Beginnen Sie in der Mitte des Gerätebereichs, oder machen Sie den Weg des Spatels länger (Geräteeinstellungen)</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>no button was noticed</source>
        <translation>keine Taste wurde bemerkt</translation>
    </message>
    <message>
        <source>the clutch, button %1, was not noticed; others were</source>
        <translation>die Kupplung, Taste %1, wurde nicht bemerkt; andere schon</translation>
    </message>
    <message>
        <source>Hold still: the rate is measured for %1 s.</source>
        <translation>Halten Sie still: Die Rate wird %1 s lang gemessen.</translation>
    </message>
    <message>
        <source>Move the handle %1, about %2 cm.</source>
        <translation>Bewegen Sie den Griff %1, etwa %2 cm.</translation>
    </message>
    <message>
        <source>Go to the four corners, then far and near. Still to come: %1.</source>
        <translation>Gehen Sie in die vier Ecken, dann fern und nah. Noch offen: %1.</translation>
    </message>
    <message>
        <source>Hold the handle as in a trial. Push %1 of 3, with at most %2 N: press Push when you are ready.</source>
        <translation>Halten Sie den Griff wie in einem Durchgang. Stoß %1 von 3, mit höchstens %2 N: Drücken Sie „Stoß“, wenn Sie bereit sind.</translation>
    </message>
    <message>
        <source>Which way were you pushed?</source>
        <translation>Wohin wurden Sie gestoßen?</translation>
    </message>
    <message>
        <source>Feel which way it pushes ...</source>
        <translation>Spüren Sie, wohin es stößt ...</translation>
    </message>
    <message>
        <source>Press and hold button %1, the clutch, and let it go.</source>
        <translation>Drücken und halten Sie Taste %1, die Kupplung, und lassen Sie sie los.</translation>
    </message>
    <message>
        <source>Move the blade %1, about %2 cm: drag, wheel or keys.</source>
        <translation>Bewegen Sie den Spatel %1, etwa %2 cm: ziehen, Rad oder Tasten.</translation>
    </message>
    <message>
        <source>Push the cap %1, until the blade has gone about %2 cm.</source>
        <translation>Drücken Sie die Kappe %1, bis der Spatel etwa %2 cm gegangen ist.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ClipExport</name>
    <message>
        <source>Save a clip</source>
        <translation>Clip speichern</translation>
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
        <source>Save ...</source>
        <translation>Speichern ...</translation>
    </message>
    <message>
        <source>The clip ends before it begins: choose a later end.</source>
        <translation>Der Clip endet, bevor er beginnt: Wählen Sie ein späteres Ende.</translation>
    </message>
    <message>
        <source>Drawing ...</source>
        <translation>Wird gezeichnet ...</translation>
    </message>
    <message>
        <source>Both views as they are set now, as MP4 (H.264): slide programs, browsers and players show it.</source>
        <translation>Beide Ansichten, wie sie jetzt eingestellt sind, als MP4 (H.264): Präsentationsprogramme, Browser und Abspieler zeigen es.</translation>
    </message>
    <message>
        <source>Clips (*.mp4)</source>
        <translation>Clips (*.mp4)</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::CohortTab</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Part of the trainee&apos;s name</source>
        <translation>Teil des Namens</translation>
    </message>
    <message>
        <source>Any course</source>
        <translation>Jeder Kurs</translation>
    </message>
    <message>
        <source>Any scenario</source>
        <translation>Jedes Szenario</translation>
    </message>
    <message>
        <source>Any device</source>
        <translation>Jedes Gerät</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Zeitraum</translation>
    </message>
    <message>
        <source>All time</source>
        <translation>Gesamte Zeit</translation>
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
        <source>Last 365 days</source>
        <translation>Letzte 365 Tage</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Enter, or a double click on the curve</source>
        <translation>Enter oder ein Doppelklick auf die Kurve</translation>
    </message>
    <message>
        <source>Nobody who is signed in while practising has a trial in this time; choose a longer one.</source>
        <translation>Niemand, der beim Üben angemeldet war, hat in dieser Zeit einen Durchgang; wählen Sie eine längere.</translation>
    </message>
    <message>
        <source>No trainee has a trial yet. Trainees sign in before they practise; trials without a sign-in belong to nobody and are not shown here.</source>
        <translation>Noch niemand hat einen Durchgang. Lernende melden sich an, bevor sie üben; Durchgänge ohne Anmeldung gehören niemandem und stehen nicht hier.</translation>
    </message>
    <message>
        <source>%1 of %2 curves. Enter or a double click opens one. Kinds of device are never pooled; no pass mark is validated.</source>
        <translation>%1 von %2 Kurven. Enter oder ein Doppelklick öffnet eine. Gerätearten werden nie zusammengefasst; keine Bestehensgrenze ist validiert.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::CompareView</name>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>This course is the same as %1.</source>
        <translation>Dieser Kurs ist gleich %1.</translation>
    </message>
    <message>
        <source>Against %1: %2 lines are new (green, +), %3 are gone (brown, -).</source>
        <translation>Gegenüber %1: %2 Zeilen sind neu (grün, +), %3 sind weg (braun, -).</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::CourseForm</name>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>%1 (left out)</source>
        <translation>%1 (weggelassen)</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Weglassen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add one</source>
        <translation>Eines hinzufügen</translation>
    </message>
    <message>
        <source>Add to %1</source>
        <translation>Zu %1 hinzufügen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <translation>%1 weglassen</translation>
    </message>
    <message>
        <source>is %1; allowed: %2</source>
        <translation>ist %1; erlaubt: %2</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::CourseText</name>
    <message>
        <source>The course&apos;s text</source>
        <translation>Der Text des Kurses</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tippen</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::CourseTree</name>
    <message>
        <source>Course, modules and scenarios</source>
        <translation>Kurs, Module und Szenarien</translation>
    </message>
    <message>
        <source>%1  (in no module)</source>
        <translation>%1  (in keinem Modul)</translation>
    </message>
    <message>
        <source>Something in it is not allowed: see below</source>
        <translation>Etwas darin ist nicht erlaubt: siehe unten</translation>
    </message>
    <message>
        <source>Move the scenario</source>
        <translation>Das Szenario verschieben</translation>
    </message>
    <message>
        <source>Move the module</source>
        <translation>Das Modul verschieben</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::DeviceCheck</name>
    <message>
        <source>Device check</source>
        <translation>Geräteprüfung</translation>
    </message>
    <message>
        <source>&amp;Push</source>
        <translation>&amp;Stoß</translation>
    </message>
    <message>
        <source>Enter: the device pushes once, gently, and you say which way</source>
        <translation>Enter: Das Gerät stößt einmal, sanft, und Sie sagen, wohin</translation>
    </message>
    <message>
        <source>Count from &amp;here</source>
        <translation>Ab &amp;hier zählen</translation>
    </message>
    <message>
        <source>I &amp;cannot do this</source>
        <translation>Das &amp;geht nicht</translation>
    </message>
    <message>
        <source>This step is noted as not done, and the next one comes</source>
        <translation>Dieser Schritt wird als nicht getan notiert, und der nächste kommt</translation>
    </message>
    <message>
        <source>Check &amp;again</source>
        <translation>&amp;Erneut prüfen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Closing the device ...</source>
        <translation>Das Gerät wird geschlossen ...</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Opening the device ...</source>
        <translation>Das Gerät wird geöffnet ...</translation>
    </message>
    <message>
        <source>Check of %1</source>
        <translation>Prüfung von %1</translation>
    </message>
    <message>
        <source>All is as it should be.</source>
        <translation>Alles ist, wie es sein soll.</translation>
    </message>
    <message>
        <source>Not as it should be: %1 of %2.</source>
        <translation>Nicht, wie es sein soll: %1 von %2.</translation>
    </message>
    <message>
        <source>Where you are with it now becomes the middle of the mouth</source>
        <translation>Wo Sie damit jetzt sind, wird die Mitte des Mundes</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::DeviceChecks</name>
    <message>
        <source>Device not checked</source>
        <translation>Gerät nicht geprüft</translation>
    </message>
    <message>
        <source>Device checked just now</source>
        <translation>Gerät eben geprüft</translation>
    </message>
    <message>
        <source>Device checked %1 min ago</source>
        <translation>Gerät vor %1 min geprüft</translation>
    </message>
    <message>
        <source>%1: %2 of %3 not as it should be</source>
        <translation>%1: %2 von %3 nicht, wie es sein soll</translation>
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
        <translation>Weg der Maus auf dem Bild; + und - ändern ihn im Durchgang</translation>
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
    <message>
        <source>&amp;Check this one ...</source>
        <translation>&amp;Prüfen ...</translation>
    </message>
    <message>
        <source>Rate, calibration, directions, reach, force and buttons, step by step</source>
        <translation>Rate, Kalibrierung, Richtungen, Reichweite, Kraft und Tasten, Schritt für Schritt</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::DistractionPanel</name>
    <message>
        <source>You will be asked things meanwhile, here. Keys 1 to 6 answer, M silences an alarm; talk asks for nothing.</source>
        <translation>Sie werden währenddessen hier gefragt. Die Tasten 1 bis 6 antworten, M schaltet einen Alarm stumm; Gespräche verlangen nichts.</translation>
    </message>
    <message>
        <source>Silence (M)</source>
        <translation>Stumm (M)</translation>
    </message>
    <message>
        <source>Silence</source>
        <translation>Stumm</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Verbleibende Zeit</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>The team talks</source>
        <translation>Das Team spricht</translation>
    </message>
    <message>
        <source>Messages of the team</source>
        <translation>Meldungen des Teams</translation>
    </message>
    <message>
        <source>Said before: %1</source>
        <translation>Zuvor gesagt: %1</translation>
    </message>
    <message>
        <source>Nobody has said anything. An instructor&apos;s words come up here.</source>
        <translation>Niemand hat etwas gesagt. Worte einer Lehrperson erscheinen hier.</translation>
    </message>
    <message>
        <source>Instructor</source>
        <translation>Lehrperson</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>answers the question that has been open longest</source>
        <translation>beantwortet die Frage, die am längsten offen ist</translation>
    </message>
    <message>
        <source>silences the alarm that has been open longest</source>
        <translation>schaltet den Alarm stumm, der am längsten offen ist</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::EditHistory</name>
    <message>
        <source>seed of %1</source>
        <translation>Startpunkt von %1</translation>
    </message>
    <message>
        <source>threshold of %1</source>
        <translation>Schwelle von %1</translation>
    </message>
    <message>
        <source>move of %1</source>
        <translation>Verschiebung von %1</translation>
    </message>
    <message>
        <source>accepting %1</source>
        <translation>Annahme von %1</translation>
    </message>
    <message>
        <source>doubting %1</source>
        <translation>Zweifel an %1</translation>
    </message>
    <message>
        <source>dropping the edits of %1</source>
        <translation>Verwerfen der Änderungen an %1</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::FieldRow</name>
    <message>
        <source>In the file: %1</source>
        <translation>In der Datei: %1</translation>
    </message>
    <message>
        <source>%1: from</source>
        <translation>%1: von</translation>
    </message>
    <message>
        <source>%1: to</source>
        <translation>%1: bis</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>(left out)</source>
        <translation>(weggelassen)</translation>
    </message>
    <message>
        <source>(left out: %1)</source>
        <translation>(weggelassen: %1)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::FirstRun</name>
    <message>
        <source>Welcome to Vallecula</source>
        <translation>Willkommen bei Vallecula</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>&amp;Überspringen</translation>
    </message>
    <message>
        <source>Straight to the first page (Esc); Help &gt; First steps comes back here</source>
        <translation>Gleich zur ersten Seite (Esc); Hilfe &gt; Erste Schritte führt hierher zurück</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>How will you steer?</source>
        <translation>Womit steuern Sie?</translation>
    </message>
    <message>
        <source>A mouse is enough: the force of your blade is drawn beside the picture. A haptic device lets you feel it.</source>
        <translation>Eine Maus genügt: Die Kraft Ihres Spatels wird neben dem Bild gezeichnet. Ein haptisches Gerät lässt Sie sie spüren.</translation>
    </message>
    <message>
        <source>No other device was found. One that is plugged in later is chosen under Devices.</source>
        <translation>Kein anderes Gerät wurde gefunden. Eines, das später angeschlossen wird, wählen Sie unter „Geräte“.</translation>
    </message>
    <message>
        <source>The &amp;mouse and the keyboard</source>
        <translation>&amp;Maus und Tastatur</translation>
    </message>
    <message>
        <source>Can you read and hear well?</source>
        <translation>Können Sie gut lesen und hören?</translation>
    </message>
    <message>
        <source>Both can be changed at any time: Ctrl++ and Ctrl+- for the text, Ctrl+, for all settings.</source>
        <translation>Beides lässt sich jederzeit ändern: Strg++ und Strg+- für die Schrift, Strg+, für alle Einstellungen.</translation>
    </message>
    <message>
        <source>Size of all text, 80 to 160 per cent</source>
        <translation>Größe aller Schrift, 80 bis 160 Prozent</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Colours of the whole window</source>
        <translation>Farben des ganzen Fensters</translation>
    </message>
    <message>
        <source>Your first laryngoscopy</source>
        <translation>Ihre erste Laryngoskopie</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>The monitor bee&amp;ps: lower as the saturation falls</source>
        <translation>Der Monitor &amp;piept: tiefer, wenn die Sättigung fällt</translation>
    </message>
    <message>
        <source>Be&amp;gin</source>
        <translation>&amp;Beginnen</translation>
    </message>
    <message>
        <source>A newborn lies before you, its head towards you. You hold the laryngoscope in your left hand: bring the blade over the tongue into the vallecula, lift along the handle, and see the glottis. The key G shows an expert doing it, at this very infant.

Nothing can break, and every try is a new one. Before it begins a card tells what mouse and keys do.</source>
        <translation>Ein Neugeborenes liegt vor Ihnen, den Kopf zu Ihnen. Sie halten das Laryngoskop in der linken Hand: Führen Sie den Spatel über die Zunge in die Vallecula, heben Sie längs des Griffs, und sehen Sie die Glottis. Die Taste G zeigt, wie ein Experte es macht, an eben diesem Kind.

Nichts kann kaputtgehen, und jeder Versuch ist ein neuer. Bevor es beginnt, sagt eine Karte, was Maus und Tasten tun.</translation>
    </message>
    <message>
        <source>Of all words of the window; to be changed in the settings as well (Ctrl+,)</source>
        <translation>Aller Wörter des Fensters; auch in den Einstellungen zu ändern (Strg+,)</translation>
    </message>
    <message>
        <source>&amp;Language / Sprache</source>
        <translation>&amp;Sprache / Language</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>&amp;Schriftgröße</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>&amp;Farben</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ForceBars</name>
    <message>
        <source>Force on the tongue and on the gum</source>
        <translation>Kraft auf Zunge und Zahnleiste</translation>
    </message>
    <message>
        <source>tongue %1 N, gum %2 N, lift %3 N, lever %4 N</source>
        <translation>Zunge %1 N, Zahnleiste %2 N, gehoben %3 N, gehebelt %4 N</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>Ziel %1</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>peak %1</source>
        <translation>höchste %1</translation>
    </message>
    <message>
        <source>lift %1 N</source>
        <translation>gehoben %1 N</translation>
    </message>
    <message>
        <source>lever %1 N</source>
        <translation>gehebelt %1 N</translation>
    </message>
    <message>
        <source>Tongue</source>
        <translation>Zunge</translation>
    </message>
    <message>
        <source>Gum</source>
        <translation>Zahnleiste</translation>
    </message>
    <message>
        <source>An expert&apos;s: tongue %1 N, gum %2 N, lift %3 N, lever %4 N</source>
        <translation>Von Expertenhand: Zunge %1 N, Zahnleiste %2 N, Heben %3 N, Hebeln %4 N</translation>
    </message>
    <message>
        <source>expert</source>
        <translation>Experte</translation>
    </message>
    <message>
        <source>pass limit %1</source>
        <translation>Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>device limit %1</source>
        <translation>Gerätegrenze %1</translation>
    </message>
    <message>
        <source>Below the tongue&apos;s bar: what your hand lifts along the handle of all that lies on the blade, so it may be more than the tongue&apos;s share, and what is levered on the upper jaw (hatched).</source>
        <translation>Unter dem Zungenbalken: was Ihre Hand längs des Griffs von allem hebt, was auf dem Spatel liegt – es kann mehr sein als der Anteil der Zunge –, und was auf den Oberkiefer gehebelt wird (schraffiert).</translation>
    </message>
    <message>
        <source>Bars: model force of the tissue on the blade, in newton. White line: the highest so far.</source>
        <translation>Balken: Modellkraft des Gewebes auf den Spatel, in Newton. Weiße Linie: das Höchste bisher.</translation>
    </message>
    <message>
        <source>Pass limit: red line. A peak above %1 N on the tongue or %2 N on the gum does not pass.</source>
        <translation>Bestehensgrenze: rote Linie. Wer auch nur kurz mit mehr als %1 N auf die Zunge oder %2 N auf die Zahnleiste drückt, besteht nicht.</translation>
    </message>
    <message>
        <source>Device limit: blue dashed line, hatched beyond it. Your device cannot push back with more than %1 N: there the blade stays where it is, and a grey one shows your hand.</source>
        <translation>Gerätegrenze: blaue gestrichelte Linie, dahinter schraffiert. Ihr Gerät kann mit höchstens %1 N zurückdrücken: Dort bleibt der Spatel, wo er ist, und ein grauer zeigt Ihre Hand.</translation>
    </message>
    <message>
        <source>Target: yellow line of dashes and dots. What to train for, %1 N on the tongue and %2 N on the gum; a trial passes with at most %3 s above the tongue&apos;s.</source>
        <translation>Ziel: gelbe Linie aus Strichen und Punkten. Worauf geübt wird, %1 N auf die Zunge und %2 N auf die Zahnleiste; bestanden wird mit höchstens %3 s über dem der Zunge.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::HandOn</name>
    <message>
        <source>&amp;Table (CSV) ...</source>
        <translation>&amp;Tabelle (CSV) ...</translation>
    </message>
    <message>
        <source>Report of the &amp;chosen trial (PDF) ...</source>
        <translation>Bericht des &amp;gewählten Durchgangs (PDF) ...</translation>
    </message>
    <message>
        <source>&amp;Report of this trainee (PDF) ...</source>
        <translation>&amp;Bericht dieser Lernenden (PDF) ...</translation>
    </message>
    <message>
        <source>With the trainees&apos; &amp;names</source>
        <translation>Mit den &amp;Namen der Lernenden</translation>
    </message>
    <message>
        <source>&amp;Table of all trials of this trainee (CSV) ...</source>
        <translation>&amp;Tabelle aller Durchgänge dieser Lernenden (CSV) ...</translation>
    </message>
    <message>
        <source>&amp;Table of the trials behind the curves shown (CSV) ...</source>
        <translation>&amp;Tabelle der Durchgänge hinter den gezeigten Kurven (CSV) ...</translation>
    </message>
    <message>
        <source>Hand on</source>
        <translation>Weitergeben</translation>
    </message>
    <message>
        <source>Writing %1 ...</source>
        <translation>%1 wird geschrieben ...</translation>
    </message>
    <message numerus="yes">
        <source>Written: %1, %n trial(s).</source>
        <translation>
            <numerusform>Geschrieben: %1, %n Durchgang.</numerusform>
            <numerusform>Geschrieben: %1, %n Durchgänge.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not handed on. %1</source>
        <translation>Nicht weitergegeben. %1</translation>
    </message>
    <message>
        <source>Han&amp;d on ...</source>
        <translation>Weiter&amp;geben ...</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::HandPanel</name>
    <message>
        <source>Breath (B)</source>
        <translation>Beatmen (B)</translation>
    </message>
    <message>
        <source>Held: 40 a minute, by mask, or by the tube once it is in</source>
        <translation>Gehalten: 40 pro Minute, mit der Maske oder durch den Tubus, sobald er liegt</translation>
    </message>
    <message>
        <source>Suction (V)</source>
        <translation>Absaugen (V)</translation>
    </message>
    <message>
        <source>Held, with the catheter&apos;s tip in the secretions</source>
        <translation>Gehalten, mit der Spitze des Katheters im Sekret</translation>
    </message>
    <message>
        <source>Press larynx (L)</source>
        <translation>Kehlkopf (L)</translation>
    </message>
    <message>
        <source>Held: the assistant presses on the larynx</source>
        <translation>Gehalten: Die Assistenz drückt auf den Kehlkopf</translation>
    </message>
    <message>
        <source>Stylet out (T)</source>
        <translation>Führungsstab (T)</translation>
    </message>
    <message>
        <source>Draws the stylet out of the tube, for good</source>
        <translation>Zieht den Führungsstab aus dem Tubus, endgültig</translation>
    </message>
    <message>
        <source>Catheter (C)</source>
        <translation>Katheter (C)</translation>
    </message>
    <message>
        <source>Takes the suction catheter in place of the tube, and back: outside the mouth</source>
        <translation>Nimmt den Absaugkatheter statt des Tubus und zurück: außerhalb des Mundes</translation>
    </message>
    <message>
        <source>Other hand (X)</source>
        <translation>Andere Hand (X)</translation>
    </message>
    <message>
        <source>Steers the other hand; what this one holds stays where it is (X or Tab)</source>
        <translation>Steuert die andere Hand; was diese hält, bleibt, wo es ist (X oder Tab)</translation>
    </message>
    <message>
        <source>Tube out first (C)</source>
        <translation>Erst Tubus heraus (C)</translation>
    </message>
    <message>
        <source>Catheter out first (C)</source>
        <translation>Erst Katheter heraus (C)</translation>
    </message>
    <message>
        <source>Tube (C)</source>
        <translation>Tubus (C)</translation>
    </message>
    <message>
        <source>Once the trial runs. %1</source>
        <translation>Sobald der Durchgang läuft. %1</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::HelpDialog</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Kapitel</translation>
    </message>
    <message>
        <source>Text of the chapter</source>
        <translation>Text des Kapitels</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::HelpPanel</name>
    <message>
        <source>From vallecula (F)</source>
        <translation>Ab Vallecula (F)</translation>
    </message>
    <message>
        <source>Expert (G)</source>
        <translation>Experte (G)</translation>
    </message>
    <message>
        <source>Extend head (H)</source>
        <translation>Kopf strecken (H)</translation>
    </message>
    <message>
        <source>My head</source>
        <translation>Mein Kopf</translation>
    </message>
    <message>
        <source>%1: 2 cm, and back when pressed again (%2)</source>
        <translation>%1: 2 cm, und zurück, wenn noch einmal gedrückt (%2)</translation>
    </message>
    <message>
        <source>My head to the left</source>
        <translation>Mein Kopf nach links</translation>
    </message>
    <message>
        <source>Ctrl+Left</source>
        <translation>Strg+Links</translation>
    </message>
    <message>
        <source>My head up</source>
        <translation>Mein Kopf nach oben</translation>
    </message>
    <message>
        <source>Ctrl+Up</source>
        <translation>Strg+Hoch</translation>
    </message>
    <message>
        <source>My head down</source>
        <translation>Mein Kopf nach unten</translation>
    </message>
    <message>
        <source>Ctrl+Down</source>
        <translation>Strg+Runter</translation>
    </message>
    <message>
        <source>My head to the right</source>
        <translation>Mein Kopf nach rechts</translation>
    </message>
    <message>
        <source>Ctrl+Right</source>
        <translation>Strg+Rechts</translation>
    </message>
    <message>
        <source>Begins anew with the blade&apos;s tip in the vallecula (F). What was done until now is kept; the new trial does not count towards mastery.</source>
        <translation>Beginnt neu mit der Spatelspitze in der Vallecula (F). Was bis jetzt getan wurde, bleibt; der neue Durchgang zählt nicht für das Beherrschen.</translation>
    </message>
    <message>
        <source>Once the trial runs</source>
        <translation>Sobald der Durchgang läuft</translation>
    </message>
    <message>
        <source>The infant&apos;s head is extended on the neck by 10 degrees, as by a shoulder roll, and back (H)</source>
        <translation>Der Kopf des Kindes wird um 10 Grad gestreckt, wie durch eine Schulterrolle, und zurück (H)</translation>
    </message>
    <message>
        <source>Up to %1 s of an expert&apos;s hands at this patient, over and over, while your trial waits (G)</source>
        <translation>Bis zu %1 s der Hände eines Experten an diesem Patienten, immer wieder, während Ihr Durchgang wartet (G)</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::HomePage</name>
    <message>
        <source>Practise neonatal intubation, and see what your hands did. A training tool, not a medical device.</source>
        <translation>Üben Sie die Intubation Neugeborener und sehen Sie, was Ihre Hände getan haben. Ein Trainingsgerät, kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Practise</source>
        <translation>Üben</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Choose a scenario, a patient and a device; see what is open and mastered</source>
        <translation>Szenario, Patient und Gerät wählen; sehen, was offen und beherrscht ist</translation>
    </message>
    <message>
        <source>All courses, module by module (Ctrl+2)</source>
        <translation>Alle Kurse, Modul für Modul (Strg+2)</translation>
    </message>
    <message>
        <source>New patient from a CT</source>
        <translation>Neuer Patient aus einem CT</translation>
    </message>
    <message>
        <source>From a CT scan to a patient to practise on</source>
        <translation>Aus einem CT ein Patient zum Üben</translation>
    </message>
    <message>
        <source>Opens the import of a CT; its folder can be dropped on the window as well (Ctrl+N)</source>
        <translation>Öffnet den Import eines CT; sein Ordner lässt sich auch auf dem Fenster ablegen (Strg+N)</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Your trials and progress; for instructors the cohort</source>
        <translation>Ihre Durchgänge und Fortschritte; für Lehrpersonen die Gruppe</translation>
    </message>
    <message>
        <source>Signing in, learning curves, trials to look at again (Ctrl+3)</source>
        <translation>Anmelden, Lernkurven, Durchgänge zum erneuten Ansehen (Strg+3)</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>What is plugged in, and whether it is ready</source>
        <translation>Was angeschlossen ist und ob es bereit ist</translation>
    </message>
    <message>
        <source>Haptic devices, SpaceMouse and mouse (Ctrl+4)</source>
        <translation>Haptische Geräte, SpaceMouse und Maus (Strg+4)</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Recent patients, courses and trials</source>
        <translation>Zuletzt geöffnete Patienten, Kurse und Durchgänge</translation>
    </message>
    <message>
        <source>Enter or double click opens it</source>
        <translation>Enter oder Doppelklick öffnet es</translation>
    </message>
    <message>
        <source>Patients, courses and trials that you open are kept here. You can also drop a CT&apos;s folder, a patient, a course or a trial on this window.</source>
        <translation>Patienten, Kurse und Durchgänge, die Sie öffnen, stehen hier. Sie können auch den Ordner eines CT, einen Patienten, einen Kurs oder einen Durchgang auf diesem Fenster ablegen.</translation>
    </message>
    <message>
        <source>&amp;Write a course ...</source>
        <translation>Kurs &amp;schreiben ...</translation>
    </message>
    <message>
        <source>Create, change, try, compare and share courses</source>
        <translation>Kurse anlegen, ändern, ausprobieren, vergleichen und weitergeben</translation>
    </message>
    <message>
        <source>Hel&amp;p</source>
        <translation>H&amp;ilfe</translation>
    </message>
    <message>
        <source>How to use each page, with pictures (F1)</source>
        <translation>Wie man jede Seite benutzt, mit Bildern (F1)</translation>
    </message>
    <message>
        <source>No scenario is chosen yet</source>
        <translation>Noch ist kein Szenario gewählt</translation>
    </message>
    <message>
        <source>%1
Patient: %2
Device: %3</source>
        <translation>%1
Patient: %2
Gerät: %3</translation>
    </message>
    <message>
        <source>Opens the course, where what is missing can be chosen (Enter)</source>
        <translation>Öffnet den Kurs, wo sich wählen lässt, was fehlt (Enter)</translation>
    </message>
    <message>
        <source>Opens this trial (Enter); it begins with Start, once your hands are in place</source>
        <translation>Öffnet diesen Durchgang (Eingabetaste); er beginnt mit Start, sobald Ihre Hände bereit sind</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ImportWizard</name>
    <message>
        <source>1  Source</source>
        <translation>1  Quelle</translation>
    </message>
    <message>
        <source>2  Segment</source>
        <translation>2  Segmentieren</translation>
    </message>
    <message>
        <source>3  Check</source>
        <translation>3  Prüfen</translation>
    </message>
    <message>
        <source>4  Build</source>
        <translation>4  Bauen</translation>
    </message>
    <message>
        <source>Finding the structures</source>
        <translation>Die Strukturen werden gesucht</translation>
    </message>
    <message>
        <source>Reading the scan and finding the structures</source>
        <translation>Der Scan wird gelesen und die Strukturen gesucht</translation>
    </message>
    <message>
        <source>Nothing is written yet. You look at the result before it becomes a patient.</source>
        <translation>Noch wird nichts geschrieben. Sie sehen das Ergebnis an, bevor es ein Patient wird.</translation>
    </message>
    <message>
        <source>Leave the import</source>
        <translation>Den Import verlassen</translation>
    </message>
    <message>
        <source>Leave without saving the patient? What was built is lost.</source>
        <translation>Verlassen, ohne den Patienten zu speichern? Was gebaut wurde, geht verloren.</translation>
    </message>
    <message>
        <source>Leave without saving the patient? The edits made here are lost.</source>
        <translation>Verlassen, ohne den Patienten zu speichern? Die Änderungen hier gehen verloren.</translation>
    </message>
    <message>
        <source>Reading the series</source>
        <translation>Die Serie wird gelesen</translation>
    </message>
    <message>
        <source>Go back to the check and mend there what it names.</source>
        <translation>Gehen Sie zurück zur Prüfung und beheben Sie dort, was genannt ist.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was saved.</source>
        <translation>Abgebrochen; nichts wurde gespeichert.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ImportWork</name>
    <message>
        <source>loading landmarks</source>
        <translation>Laden von Landmarken</translation>
    </message>
    <message>
        <source>loading labels</source>
        <translation>Laden von Labels</translation>
    </message>
    <message>
        <source>loading %1</source>
        <translation>Laden von %1</translation>
    </message>
    <message>
        <source>%1 and %2; of the skin what lies near other structures, for the face is to be the generic one</source>
        <translation>%1 und %2; von der Haut nur, was nahe anderen Strukturen liegt, denn das Gesicht soll das allgemeine sein</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::InstructorControls</name>
    <message>
        <source>&amp;Freeze</source>
        <translation>&amp;Einfrieren</translation>
    </message>
    <message>
        <source>The trial&apos;s clock stands, no force is shown, the tools stay where they are (F5)</source>
        <translation>Die Uhr des Durchgangs steht, keine Kraft wird gezeigt, die Instrumente bleiben, wo sie sind (F5)</translation>
    </message>
    <message>
        <source>SpO2 ▼</source>
        <translation>SpO2 ▼</translation>
    </message>
    <message>
        <source>Held, the saturation falls (%)</source>
        <translation>Gehalten fällt die Sättigung (%)</translation>
    </message>
    <message>
        <source>SpO2 ▲</source>
        <translation>SpO2 ▲</translation>
    </message>
    <message>
        <source>Held, the saturation rises (%)</source>
        <translation>Gehalten steigt die Sättigung (%)</translation>
    </message>
    <message>
        <source>Heart ▼</source>
        <translation>Herz ▼</translation>
    </message>
    <message>
        <source>Held, the heart slows (beats a minute)</source>
        <translation>Gehalten wird das Herz langsamer (Schläge pro Minute)</translation>
    </message>
    <message>
        <source>Heart ▲</source>
        <translation>Herz ▲</translation>
    </message>
    <message>
        <source>Held, the heart quickens (beats a minute)</source>
        <translation>Gehalten wird das Herz schneller (Schläge pro Minute)</translation>
    </message>
    <message>
        <source>Laryngospasm</source>
        <translation>Laryngospasmus</translation>
    </message>
    <message>
        <source>Pressed, the cords close; pressed again, they are let go</source>
        <translation>Gedrückt schließen sich die Stimmlippen; noch einmal gedrückt öffnen sie sich</translation>
    </message>
    <message>
        <source>What the team says</source>
        <translation>Was das Team sagt</translation>
    </message>
    <message>
        <source>A ready sentence, or your own; Enter has the team say it on the trainee&apos;s screen</source>
        <translation>Ein fertiger Satz oder Ihr eigener; mit Enter sagt ihn das Team auf dem Bildschirm der Lernenden</translation>
    </message>
    <message>
        <source>The team says ...</source>
        <translation>Das Team sagt ...</translation>
    </message>
    <message>
        <source>What do you see?</source>
        <translation>Was sehen Sie?</translation>
    </message>
    <message>
        <source>Saturation is falling.</source>
        <translation>Die Sättigung fällt.</translation>
    </message>
    <message>
        <source>Heart rate below 100.</source>
        <translation>Herzfrequenz unter 100.</translation>
    </message>
    <message>
        <source>Thirty seconds.</source>
        <translation>Dreißig Sekunden.</translation>
    </message>
    <message>
        <source>Shall I press on the larynx?</source>
        <translation>Soll ich auf den Kehlkopf drücken?</translation>
    </message>
    <message>
        <source>Suction is ready.</source>
        <translation>Absaugung ist bereit.</translation>
    </message>
    <message>
        <source>Shall we ventilate by mask?</source>
        <translation>Sollen wir mit Maske beatmen?</translation>
    </message>
    <message>
        <source>Stop, please.</source>
        <translation>Bitte aufhören.</translation>
    </message>
    <message>
        <source>&amp;Say</source>
        <translation>&amp;Sagen</translation>
    </message>
    <message>
        <source>Assessment: it is not held up, and the team says nothing, for a line would be a help. A trial whose vital signs you change counts neither way.</source>
        <translation>Prüfung: Sie wird nicht angehalten, und das Team sagt nichts, denn ein Satz wäre eine Hilfe. Ein Durchgang, dessen Vitalwerte Sie ändern, wird nicht gewertet.</translation>
    </message>
    <message>
        <source>Vital signs you change are recorded; the trial then counts neither way.</source>
        <translation>Vitalwerte, die Sie ändern, werden aufgezeichnet; der Durchgang wird dann nicht gewertet.</translation>
    </message>
    <message>
        <source>This scenario has no infant&apos;s vital signs.</source>
        <translation>Dieses Szenario hat keine Vitalwerte eines Kindes.</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Fortsetzen</translation>
    </message>
    <message>
        <source>This infant is relaxed: its cords do not close</source>
        <translation>Dieses Kind ist relaxiert: seine Stimmlippen schließen sich nicht</translation>
    </message>
    <message>
        <source>Assessment: its forces, figures and events are for an instructor who is signed in here, and so are its vital signs. It is not held up, and the team says nothing, for a line would be a help.</source>
        <translation>Prüfung: Kräfte, Werte und Ereignisse sieht hier nur eine angemeldete Lehrperson, und nur sie ändert die Vitalwerte. Sie wird nicht angehalten, und das Team sagt nichts, denn ein Hinweis wäre eine Hilfe.</translation>
    </message>
    <message>
        <source>Once a trial runs</source>
        <translation>Sobald ein Durchgang läuft</translation>
    </message>
    <message>
        <source>In an assessment for an instructor who is signed in here</source>
        <translation>In einer Prüfung nur für eine Lehrperson, die hier angemeldet ist</translation>
    </message>
    <message>
        <source>The infant&apos;s clock stands: once the trial goes on (F5: Freeze, Continue)</source>
        <translation>Die Uhr des Kindes steht: sobald der Durchgang weitergeht (F5: Anhalten, Weiter)</translation>
    </message>
    <message>
        <source>No trial runs. One begins in the other window, by Practise or Course and there by Start; what is here then acts on it.</source>
        <translation>Es läuft kein Durchgang. Einer beginnt im anderen Fenster, über Üben oder Kurs und dort mit Start; was hier steht, wirkt dann auf ihn.</translation>
    </message>
    <message>
        <source>The trial is prepared: Start in the other window begins it, or Enter there.</source>
        <translation>Der Durchgang ist vorbereitet: Start im anderen Fenster beginnt ihn, oder dort Enter.</translation>
    </message>
    <message>
        <source>The infant&apos;s clock stands: its vital signs are changed once the trial goes on.</source>
        <translation>Die Uhr des Kindes steht: Seine Vitalzeichen werden verändert, sobald der Durchgang weitergeht.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::InstructorStation</name>
    <message>
        <source>&amp;Instructor&apos;s window</source>
        <translation>Fenster der &amp;Lehrperson</translation>
    </message>
    <message>
        <source>Watch the trial, freeze it, change vital signs, tick the checklist (Ctrl+I)</source>
        <translation>Den Durchgang verfolgen, einfrieren, Vitalwerte ändern, die Checkliste abhaken (Strg+I)</translation>
    </message>
    <message>
        <source>&amp;Next trainee ...</source>
        <translation>&amp;Nächste Lernende ...</translation>
    </message>
    <message>
        <source>Signs the present trainee out and the next one in; scenario, patient and device stay (Ctrl+T)</source>
        <translation>Meldet die jetzigen Lernenden ab und die nächsten an; Szenario, Patient und Gerät bleiben (Strg+T)</translation>
    </message>
    <message>
        <source>Instructor&apos;s window</source>
        <translation>Fenster der Lehrperson</translation>
    </message>
    <message>
        <source>An instructor signs in here; whoever is at the blade stays signed in there.</source>
        <translation>Hier meldet sich eine Lehrperson an; wer am Spatel ist, bleibt dort angemeldet.</translation>
    </message>
    <message>
        <source>Next trainee</source>
        <translation>Nächste Lernende</translation>
    </message>
    <message>
        <source>Scenario, patient and device stay; the mode is practice again. Nobody signs in for somebody else.</source>
        <translation>Szenario, Patient und Gerät bleiben; es wird wieder geübt. Niemand meldet sich für jemand anderen an.</translation>
    </message>
    <message>
        <source>%1 is signed out then.</source>
        <translation>%1 wird dann abgemeldet.</translation>
    </message>
    <message>
        <source>A trial runs: whoever began it stays signed in until it is over.</source>
        <translation>Ein Durchgang läuft: Wer ihn begonnen hat, bleibt angemeldet, bis er vorbei ist.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::InstructorWindow</name>
    <message>
        <source>Instructor - Vallecula</source>
        <translation>Lehrperson - Vallecula</translation>
    </message>
    <message>
        <source>&amp;Next trainee ...</source>
        <translation>&amp;Nächste Lernende ...</translation>
    </message>
    <message>
        <source>The present trainee is signed out, the next one signs in (Ctrl+T); not while a trial runs</source>
        <translation>Die jetzigen Lernenden werden abgemeldet, die nächsten melden sich an (Strg+T); nicht, während ein Durchgang läuft</translation>
    </message>
    <message>
        <source>The operator&apos;s view, live</source>
        <translation>Die Sicht der Intubierenden, unmittelbar</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>What happens, by the trial&apos;s clock (min:s)</source>
        <translation>Was geschieht, nach der Uhr des Durchgangs (min:s)</translation>
    </message>
    <message>
        <source>Checklist</source>
        <translation>Checkliste</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>No trial is open</source>
        <translation>Kein Durchgang ist offen</translation>
    </message>
    <message>
        <source>Over; waiting for the next trial</source>
        <translation>Zu Ende; wartet auf den nächsten Durchgang</translation>
    </message>
    <message>
        <source>Waiting for a trial</source>
        <translation>Wartet auf einen Durchgang</translation>
    </message>
    <message>
        <source>Prepared, not started</source>
        <translation>Vorbereitet, nicht begonnen</translation>
    </message>
    <message>
        <source>FROZEN at %1</source>
        <translation>EINGEFROREN bei %1</translation>
    </message>
    <message>
        <source>Running, %1</source>
        <translation>Läuft, %1</translation>
    </message>
    <message>
        <source>Paused at %1</source>
        <translation>Angehalten bei %1</translation>
    </message>
    <message>
        <source>nobody is signed in</source>
        <translation>niemand ist angemeldet</translation>
    </message>
    <message>
        <source>nobody: ticks cannot be kept</source>
        <translation>niemand: Haken lassen sich nicht behalten</translation>
    </message>
    <message>
        <source>At the blade: %1. Here: %2.%3</source>
        <translation>Am Spatel: %1. Hier: %2.%3</translation>
    </message>
    <message>
        <source> Assessment.</source>
        <translation> Prüfung.</translation>
    </message>
    <message>
        <source>You froze the trial</source>
        <translation>Sie haben den Durchgang eingefroren</translation>
    </message>
    <message>
        <source>You let it go on</source>
        <translation>Sie haben ihn weitergehen lassen</translation>
    </message>
    <message>
        <source>You lower the saturation</source>
        <translation>Sie senken die Sättigung</translation>
    </message>
    <message>
        <source>You raise the saturation</source>
        <translation>Sie heben die Sättigung</translation>
    </message>
    <message>
        <source>You slow the heart</source>
        <translation>Sie verlangsamen das Herz</translation>
    </message>
    <message>
        <source>You quicken the heart</source>
        <translation>Sie beschleunigen das Herz</translation>
    </message>
    <message>
        <source>You close the cords</source>
        <translation>Sie schließen die Stimmlippen</translation>
    </message>
    <message>
        <source>The team says: %1</source>
        <translation>Das Team sagt: %1</translation>
    </message>
    <message>
        <source>Recorded. An instructor who is signed in here can keep the ticks.</source>
        <translation>Aufgezeichnet. Eine Lehrperson, die hier angemeldet ist, kann die Haken behalten.</translation>
    </message>
    <message>
        <source>This trial has no record: the ticks cannot be kept.</source>
        <translation>Dieser Durchgang hat keinen Eintrag: Die Haken lassen sich nicht behalten.</translation>
    </message>
    <message>
        <source>Stands at %1: an expert is shown</source>
        <translation>Steht bei %1: der Expertenablauf wird gezeigt</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Closes this window and lets the trial go on (Esc, Ctrl+I); whoever signed in here is signed out</source>
        <translation>Schließt dieses Fenster und lässt den Durchgang weitergehen (Esc, Strg+I); wer hier angemeldet ist, wird abgemeldet</translation>
    </message>
    <message>
        <source>The trial is frozen: continue it first (F5); Close lets it go as well.</source>
        <translation>Der Durchgang ist angehalten: erst fortsetzen (F5); auch Schließen gibt ihn frei.</translation>
    </message>
    <message>
        <source>Stands at %1: the list of keys is read</source>
        <translation>Steht bei %1: die Tastenliste wird gelesen</translation>
    </message>
    <message>
        <source>&amp;Sign in ...</source>
        <translation>An&amp;melden ...</translation>
    </message>
    <message>
        <source>An instructor signs in at this window; whoever is at the blade stays signed in there</source>
        <translation>Eine Lehrperson meldet sich an diesem Fenster an; wer am Spatel ist, bleibt dort angemeldet</translation>
    </message>
    <message>
        <source>Instructor&apos;s window</source>
        <translation>Fenster der Lehrperson</translation>
    </message>
    <message>
        <source>An instructor signs in here; whoever is at the blade stays signed in there.</source>
        <translation>Hier meldet sich eine Lehrperson an; wer am Spatel ist, bleibt dort angemeldet.</translation>
    </message>
    <message>
        <source>Stands at %1: no picture comes to the screen</source>
        <translation>Steht bei %1: Es kommt kein Bild auf den Bildschirm</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::LabelView</name>
    <message>
        <source>Structures in 3D</source>
        <translation>Strukturen in 3D</translation>
    </message>
    <message>
        <source>Arrows turn, plus and minus zoom, 0 looks from the front, F shows this view alone</source>
        <translation>Pfeile drehen, Plus und Minus zoomen, 0 blickt von vorn, F zeigt nur diese Ansicht</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::LandmarkPanel</name>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>L, P, H (mm)</source>
        <translation>L, P, H (mm)</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Bac&amp;k to where it was found</source>
        <translation>&amp;Zurück zum Fundort</translation>
    </message>
    <message>
        <source>Choosing one takes all slices to it. Drag its ring in a slice, or its ball in 3D.</source>
        <translation>Eine zu wählen führt alle Schnitte zu ihr. Ziehen Sie ihren Ring in einem Schnitt oder ihre Kugel in 3D.</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>verschoben</translation>
    </message>
    <message>
        <source>moved by hand</source>
        <translation>von Hand verschoben</translation>
    </message>
    <message>
        <source>Move &amp;it to the crosshair</source>
        <translation>Zum &amp;Fadenkreuz verschieben</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::LinkedChart</name>
    <message>
        <source>Click to go there</source>
        <translation>Klicken, um dorthin zu gehen</translation>
    </message>
    <message>
        <source>The views again</source>
        <translation>Wieder die Ansichten</translation>
    </message>
    <message>
        <source>Larger chart</source>
        <translation>Größeres Diagramm</translation>
    </message>
    <message>
        <source>L: the views again</source>
        <translation>L: wieder die Ansichten</translation>
    </message>
    <message>
        <source>L: a larger chart, in the place of views and monitor</source>
        <translation>L: ein größeres Diagramm, anstelle von Ansicht und Monitor</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::LiveEvents</name>
    <message>
        <source>It goes on</source>
        <translation>Es geht weiter</translation>
    </message>
    <message>
        <source>Paused: %1</source>
        <translation>Angehalten: %1</translation>
    </message>
    <message>
        <source>tongue</source>
        <translation>Zunge</translation>
    </message>
    <message>
        <source>gum</source>
        <translation>Zahnleiste</translation>
    </message>
    <message>
        <source>Blade in the mouth</source>
        <translation>Spatel im Mund</translation>
    </message>
    <message>
        <source>Blade out</source>
        <translation>Spatel heraus</translation>
    </message>
    <message>
        <source>Glottis in sight, %1 %</source>
        <translation>Glottis in Sicht, %1 %</translation>
    </message>
    <message>
        <source>Over the target on the %1: %2 N of %3 N</source>
        <translation>Über dem Ziel an der %1: %2 N von %3 N</translation>
    </message>
    <message>
        <source>Tube past the cords</source>
        <translation>Tubus hinter den Stimmlippen</translation>
    </message>
    <message>
        <source>Tube in a main bronchus</source>
        <translation>Tubus in einem Hauptbronchus</translation>
    </message>
    <message>
        <source>Tube in the oesophagus</source>
        <translation>Tubus im Ösophagus</translation>
    </message>
    <message>
        <source>Tube out</source>
        <translation>Tubus heraus</translation>
    </message>
    <message>
        <source>CO2 detector yellow</source>
        <translation>CO2-Detektor gelb</translation>
    </message>
    <message>
        <source>Laryngospasm begins</source>
        <translation>Laryngospasmus beginnt</translation>
    </message>
    <message>
        <source>Laryngospasm over</source>
        <translation>Laryngospasmus vorbei</translation>
    </message>
    <message>
        <source>Alarm: %1</source>
        <translation>Alarm: %1</translation>
    </message>
    <message>
        <source>Beside the hands: %1</source>
        <translation>Neben den Händen: %1</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::LiveWatch</name>
    <message>
        <source>Begun anew</source>
        <translation>Neu begonnen</translation>
    </message>
    <message>
        <source>the trainee looks at the expert</source>
        <translation>Am Spatel wird der Expertenablauf angesehen</translation>
    </message>
    <message>
        <source>the trainee reads the list of keys</source>
        <translation>Am Spatel wird die Tastenliste gelesen</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::MainMenu</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open ...</source>
        <translation>&amp;Öffnen ...</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Zuletzt &amp;geöffnet</translation>
    </message>
    <message>
        <source>&amp;New patient from a CT ...</source>
        <translation>&amp;Neuer Patient aus einem CT ...</translation>
    </message>
    <message>
        <source>&amp;Write a course ...</source>
        <translation>Kurs &amp;schreiben ...</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>&amp;Settings ...</source>
        <translation>&amp;Einstellungen ...</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Home</source>
        <translation>&amp;Startseite</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>&amp;Course</source>
        <translation>&amp;Kurs</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>&amp;Records</source>
        <translation>&amp;Aufzeichnungen</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>&amp;Devices</source>
        <translation>&amp;Geräte</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Wie der Des&amp;ktop</translation>
    </message>
    <message>
        <source>&amp;Larger text</source>
        <translation>G&amp;rößere Schrift</translation>
    </message>
    <message>
        <source>&amp;Smaller text</source>
        <translation>Kl&amp;einere Schrift</translation>
    </message>
    <message>
        <source>Text as it &amp;was</source>
        <translation>Schrift &amp;wie zuvor</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation>&amp;Inhalt</translation>
    </message>
    <message>
        <source>&amp;First steps ...</source>
        <translation>&amp;Erste Schritte ...</translation>
    </message>
    <message>
        <source>Save a &amp;log to send ...</source>
        <translation>&amp;Protokoll zum Senden speichern ...</translation>
    </message>
    <message>
        <source>&amp;About Vallecula</source>
        <translation>&amp;Über Vallecula</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>&amp;Farben</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::MainWindow</name>
    <message>
        <source>Save a log to send</source>
        <translation>Protokoll zum Senden speichern</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Text (*.txt)</translation>
    </message>
    <message>
        <source>The log is saved. It names no person, no patient and no folder; look through it before you send it.</source>
        <translation>Das Protokoll ist gespeichert. Es nennt keine Person, keinen Patienten und keinen Ordner; sehen Sie es durch, bevor Sie es senden.</translation>
    </message>
    <message>
        <source>Look at it</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>A course was being written when the program ended.</source>
        <translation>Ein Kurs wurde gerade geschrieben, als das Programm endete.</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Daran weiterschreiben</translation>
    </message>
    <message>
        <source>Let it go</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Finish or leave what is under way on this page first; then it can be opened.</source>
        <translation>Beenden oder verlassen Sie erst, was auf dieser Seite im Gange ist; dann lässt es sich öffnen.</translation>
    </message>
    <message>
        <source>%1: a course of this id (%2) is there already; give it another id.</source>
        <translation>%1: Ein Kurs mit dieser Kennung (%2) ist schon da; geben Sie ihm eine andere.</translation>
    </message>
    <message>
        <source>Preparing the patient</source>
        <translation>Der Patient wird vorbereitet</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stopping ...</source>
        <translation>Wird angehalten ...</translation>
    </message>
    <message>
        <source>%1 (used last)</source>
        <translation>%1 (zuletzt benutzt)</translation>
    </message>
    <message>
        <source>Looking for the patient ...</source>
        <translation>Der Patient wird gesucht ...</translation>
    </message>
    <message>
        <source>Reading the trial</source>
        <translation>Der Durchgang wird gelesen</translation>
    </message>
    <message>
        <source>Stopping what was being prepared</source>
        <translation>Das Vorbereitete wird angehalten</translation>
    </message>
    <message>
        <source>Chosen: the window speaks it from the next start on.</source>
        <translation>Gewählt: Das Fenster spricht sie vom nächsten Start an.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ModuleTree</name>
    <message>
        <source>Modules and scenarios</source>
        <translation>Module und Szenarien</translation>
    </message>
    <message>
        <source>About this course</source>
        <translation>Über diesen Kurs</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>open to you</source>
        <translation>offen für Sie</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::MonitorPanel</name>
    <message>
        <source>Monitor: saturation, heart rate, breaths, CO2</source>
        <translation>Monitor: Sättigung, Herzfrequenz, Beatmungshübe, CO2</translation>
    </message>
    <message>
        <source>Since breath</source>
        <translation>Atempause</translation>
    </message>
    <message>
        <source>Given %1/min</source>
        <translation>Gegeben %1/min</translation>
    </message>
    <message>
        <source>%1 given</source>
        <translation>%1 gegeben</translation>
    </message>
    <message>
        <source>None given</source>
        <translation>Keine Beatmung</translation>
    </message>
    <message>
        <source>CO2 detector</source>
        <translation>CO2-Detektor</translation>
    </message>
    <message>
        <source>YELLOW</source>
        <translation>GELB</translation>
    </message>
    <message>
        <source>PURPLE</source>
        <translation>VIOLETT</translation>
    </message>
    <message>
        <source>CO2</source>
        <translation>CO2</translation>
    </message>
    <message>
        <source>no CO2</source>
        <translation>kein CO2</translation>
    </message>
    <message>
        <source>HR</source>
        <translation>HF</translation>
    </message>
    <message>
        <source>Lines: the last minute; dotted: where the alarm begins. Breaths given are counted wherever they went; their rate is the mean of the last %1.</source>
        <translation>Linien: die letzte Minute; gepunktet: wo der Alarm beginnt. Gegebene Beatmungen zählen, wohin sie auch gingen; ihre Frequenz ist das Mittel der letzten %1.</translation>
    </message>
    <message>
        <source>it breathes by itself</source>
        <translation>es atmet selbst</translation>
    </message>
    <message>
        <source>%1 s since the last breath</source>
        <translation>%1 s seit dem letzten Atemzug</translation>
    </message>
    <message>
        <source>saturation %1 %</source>
        <translation>Sättigung %1 %</translation>
    </message>
    <message>
        <source>heart rate %1 a minute</source>
        <translation>Herzfrequenz %1 pro Minute</translation>
    </message>
    <message>
        <source>Your own infant waits</source>
        <translation>Ihr eigenes Kind wartet</translation>
    </message>
    <message>
        <source>Breathing</source>
        <translation>Atmung</translation>
    </message>
    <message>
        <source>by itself</source>
        <translation>spontan</translation>
    </message>
    <message>
        <source>Your own infant: its time stands meanwhile</source>
        <translation>Ihr eigenes Kind: Seine Zeit steht solange</translation>
    </message>
    <message>
        <source>SpO2: real oximeters state their accuracy from 70 to 100 %; below 70 % digits are a trend. Below %1 % none are shown: no newborn&apos;s curve was published so low.</source>
        <translation>SpO2: Für wirkliche Pulsoximeter ist die Genauigkeit von 70 bis 100 % angegeben; unter 70 % zeigen die Ziffern nur einen Trend. Unter %1 % steht keine: So tief wurde keine Kurve Neugeborener veröffentlicht.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::MouseIntroduction</name>
    <message>
        <source>Don&apos;t show this again</source>
        <translation>Nicht mehr zeigen</translation>
    </message>
    <message>
        <source>Got it</source>
        <translation>Verstanden</translation>
    </message>
    <message>
        <source>Your mouse holds the laryngoscope, then the tube</source>
        <translation>Ihre Maus hält das Laryngoskop, dann den Tubus</translation>
    </message>
    <message>
        <source>Your mouse holds the laryngoscope</source>
        <translation>Ihre Maus hält das Laryngoskop</translation>
    </message>
    <message>
        <source>&lt;tr&gt;&lt;td&gt;&lt;b&gt;Enter, Esc, R, Z&lt;/b&gt;&lt;/td&gt;&lt;td&gt;start the trial, end it, begin again; change the view&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;&lt;p&gt;Enter closes this; Enter again starts the trial.&lt;/p&gt;</source>
        <translation>&lt;tr&gt;&lt;td&gt;&lt;b&gt;Enter, Esc, R, Z&lt;/b&gt;&lt;/td&gt;&lt;td&gt;den Durchgang beginnen, beenden, neu beginnen; die Ansicht wechseln&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;&lt;p&gt;Enter schließt dies; Enter noch einmal beginnt den Durchgang.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::NotesPanel</name>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>A note at this second</source>
        <translation>Eine Notiz zu dieser Sekunde</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>Takes the chosen note away</source>
        <translation>Nimmt die gewählte Notiz weg</translation>
    </message>
    <message>
        <source>Note at %1</source>
        <translation>Notiz bei %1</translation>
    </message>
    <message>
        <source>This trial is in no record of this station, so notes have no place to be kept.</source>
        <translation>Dieser Durchgang steht in keiner Aufzeichnung dieser Station, daher gibt es keinen Ort für Notizen.</translation>
    </message>
    <message>
        <source>nobody signed in</source>
        <translation>niemand angemeldet</translation>
    </message>
    <message>
        <source>you</source>
        <translation>Sie</translation>
    </message>
    <message>
        <source>somebody else</source>
        <translation>jemand anderes</translation>
    </message>
    <message>
        <source>%1  (%2)</source>
        <translation>%1  (%2)</translation>
    </message>
    <message>
        <source>Written %1 (UTC) by %2</source>
        <translation>Geschrieben %1 (UTC), %2</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::NumberBox</name>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::OfferedTools</name>
    <message>
        <source>Blade</source>
        <translation>Spatel</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Tubus</translation>
    </message>
    <message>
        <source>Choose for this infant ...</source>
        <translation>Für dieses Kind wählen ...</translation>
    </message>
    <message>
        <source>%1 mm inner diameter</source>
        <translation>%1 mm Innendurchmesser</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::OpenDialog</name>
    <message>
        <source>Open a patient, a trial, a course or a CT</source>
        <translation>Einen Patienten, einen Durchgang, einen Kurs oder ein CT öffnen</translation>
    </message>
    <message>
        <source>What can be opened (*.vtrial *.yaml *.yml *.dcm *.ima *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd);;All files (*)</source>
        <translation>Was sich öffnen lässt (*.vtrial *.yaml *.yml *.dcm *.ima *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open the &amp;folder</source>
        <translation>&amp;Ordner öffnen</translation>
    </message>
    <message>
        <source>Opens the folder that is chosen, or else the one that is shown: a patient (NAME.patient), a trial, a CT</source>
        <translation>Öffnet den gewählten Ordner, sonst den gezeigten: einen Patienten (NAME.patient), einen Durchgang, ein CT</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::PeopleTab</name>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>Did</source>
        <translation>Tat</translation>
    </message>
    <message>
        <source>With</source>
        <translation>Mit</translation>
    </message>
    <message>
        <source>Kept by numbers; a name is shown where the person is still here. Nothing in it can be changed.</source>
        <translation>Nach Nummern geführt; ein Name steht da, wo die Person noch hier ist. Nichts darin lässt sich ändern.</translation>
    </message>
    <message>
        <source>&amp;Add ...</source>
        <translation>Hin&amp;zufügen ...</translation>
    </message>
    <message>
        <source>Re&amp;name ...</source>
        <translation>&amp;Umbenennen ...</translation>
    </message>
    <message>
        <source>New &amp;PIN ...</source>
        <translation>Neue &amp;PIN ...</translation>
    </message>
    <message>
        <source>&amp;Export ...</source>
        <translation>&amp;Exportieren ...</translation>
    </message>
    <message>
        <source>Choose where the export&apos;s folder is made</source>
        <translation>Wählen Sie, wo der Ordner des Exports angelegt wird</translation>
    </message>
    <message>
        <source>&amp;Delete ...</source>
        <translation>&amp;Löschen ...</translation>
    </message>
    <message>
        <source>Pro&amp;gress</source>
        <translation>&amp;Fortschritt</translation>
    </message>
    <message>
        <source>nobody signed in</source>
        <translation>niemand angemeldet</translation>
    </message>
    <message>
        <source>number %1, deleted</source>
        <translation>Nummer %1, gelöscht</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>The PIN is the person&apos;s own from then on: have it typed by them.</source>
        <translation>Die PIN gehört von da an der Person: Lassen Sie sie selbst tippen.</translation>
    </message>
    <message>
        <source>Added.</source>
        <translation>Hinzugefügt.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>The name everywhere from now on; trials stay the person&apos;s.</source>
        <translation>Der Name von jetzt an überall; Durchgänge bleiben die der Person.</translation>
    </message>
    <message>
        <source>Renamed.</source>
        <translation>Umbenannt.</translation>
    </message>
    <message>
        <source>New PIN</source>
        <translation>Neue PIN</translation>
    </message>
    <message>
        <source>In place of one that was forgotten; it ends a wait as well.</source>
        <translation>An Stelle einer vergessenen; sie beendet auch eine Wartezeit.</translation>
    </message>
    <message>
        <source>The new PIN is set.</source>
        <translation>Die neue PIN ist gesetzt.</translation>
    </message>
    <message>
        <source>Exporting ...</source>
        <translation>Wird exportiert ...</translation>
    </message>
    <message>
        <source>All that is kept of this person is in %1, in the folder you chose.</source>
        <translation>Alles, was von dieser Person aufbewahrt wird, liegt in %1 im gewählten Ordner.</translation>
    </message>
    <message>
        <source>Delete %1?</source>
        <translation>%1 löschen?</translation>
    </message>
    <message>
        <source>This deletes %1</source>
        <translation>Dies löscht %1</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::PersonDialog</name>
    <message>
        <source>&amp;Name or pseudonym</source>
        <translation>&amp;Name oder Pseudonym</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Lernende</translation>
    </message>
    <message>
        <source>Instructor</source>
        <translation>Lehrperson</translation>
    </message>
    <message>
        <source>&amp;Role</source>
        <translation>&amp;Rolle</translation>
    </message>
    <message>
        <source>&amp;Old PIN</source>
        <translation>&amp;Alte PIN</translation>
    </message>
    <message>
        <source>New &amp;PIN</source>
        <translation>Neue &amp;PIN</translation>
    </message>
    <message>
        <source>&amp;PIN</source>
        <translation>&amp;PIN</translation>
    </message>
    <message>
        <source>4 to 64 characters</source>
        <translation>4 bis 64 Zeichen</translation>
    </message>
    <message>
        <source>PIN &amp;again</source>
        <translation>PIN noch &amp;einmal</translation>
    </message>
    <message>
        <source>Give a name or a pseudonym.</source>
        <translation>Geben Sie einen Namen oder ein Pseudonym ein.</translation>
    </message>
    <message>
        <source>A PIN has at least 4 characters.</source>
        <translation>Eine PIN hat mindestens 4 Zeichen.</translation>
    </message>
    <message>
        <source>The two PINs are not the same.</source>
        <translation>Die beiden PINs sind nicht gleich.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ProblemList</name>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Ist</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Erlaubt</translation>
    </message>
    <message>
        <source>The whole file</source>
        <translation>Die ganze Datei</translation>
    </message>
    <message>
        <source>... and %1 more</source>
        <translation>... und %1 weitere</translation>
    </message>
    <message>
        <source>In the file: %1</source>
        <translation>In der Datei: %1</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ProgressTab</name>
    <message>
        <source>Whose progress</source>
        <translation>Wessen Fortschritt</translation>
    </message>
    <message>
        <source>Learning curves</source>
        <translation>Lernkurven</translation>
    </message>
    <message>
        <source>Days with trials</source>
        <translation>Tage mit Durchgängen</translation>
    </message>
    <message>
        <source>Figure of the learning curve</source>
        <translation>Messwert der Lernkurve</translation>
    </message>
    <message>
        <source>Progress of %1</source>
        <translation>Fortschritt von %1</translation>
    </message>
    <message>
        <source>Nobody is signed in. These trials belong to nobody; sign in to have progress of your own.</source>
        <translation>Niemand ist angemeldet. Diese Durchgänge gehören niemandem; melden Sie sich an, um eigenen Fortschritt zu haben.</translation>
    </message>
    <message>
        <source>Progress of</source>
        <translation>Fortschritt von</translation>
    </message>
    <message>
        <source>trials that belong to nobody</source>
        <translation>Durchgänge, die niemandem gehören</translation>
    </message>
    <message>
        <source>%1 · %2 of %3 passed</source>
        <translation>%1 · %2 von %3 bestanden</translation>
    </message>
    <message>
        <source> · %1 cut off</source>
        <translation> · %1 abgebrochen</translation>
    </message>
    <message>
        <source> · %1 to rate</source>
        <translation> · %1 zu bewerten</translation>
    </message>
    <message>
        <source>No trial yet. Choose a scenario on the first page and practise it: each trial is a point here.</source>
        <translation>Noch kein Durchgang. Wählen Sie auf der ersten Seite ein Szenario und üben Sie es: Jeder Durchgang ist hier ein Punkt.</translation>
    </message>
    <message>
        <source>no trial on this day</source>
        <translation>kein Durchgang an diesem Tag</translation>
    </message>
    <message>
        <source>%1 on this day</source>
        <translation>%1 an diesem Tag</translation>
    </message>
    <message>
        <source>Learning curve</source>
        <translation>Lernkurve</translation>
    </message>
    <message>
        <source>Cumulative sum (CUSUM)</source>
        <translation>Kumulative Summe (CUSUM)</translation>
    </message>
    <message>
        <source>Rate the assessment in the table below first: then it is a point here.</source>
        <translation>Bewerten Sie zuerst die Prüfung in der Tabelle unten: Dann ist sie hier ein Punkt.</translation>
    </message>
    <message>
        <source>Three in a row: %1.  CUSUM competent: %2.  Now: %3, %4 in a row.%5</source>
        <translation>Drei in Folge: %1.  CUSUM kompetent: %2.  Jetzt: %3, %4 in Folge.%5</translation>
    </message>
    <message>
        <source>  Interrupted: %1, counted in nothing.</source>
        <translation>  Unterbrochen: %1, in nichts gezählt.</translation>
    </message>
    <message>
        <source>No pass mark is validated.</source>
        <translation>Keine Bestehensgrenze ist validiert.</translation>
    </message>
    <message>
        <source> · %1 not counted</source>
        <translation> · %1 nicht gezählt</translation>
    </message>
    <message>
        <source>  Practised with help, changed by an instructor, or without an attempt: %1, counted in nothing.</source>
        <translation>  Mit Hilfe geübt, von einer Lehrperson verändert oder ohne Intubationsversuch: %1, nirgends mitgezählt.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::QualityList</name>
    <message>
        <source>Quality report</source>
        <translation>Qualitätsbericht</translation>
    </message>
    <message>
        <source> (was %1)</source>
        <translation> (war %1)</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::RatingDialog</name>
    <message>
        <source>Rate a trial</source>
        <translation>Einen Durchgang bewerten</translation>
    </message>
    <message>
        <source>The trainee sees your rating beside the figures. A newer one takes its place.</source>
        <translation>Die Lernenden sehen Ihre Bewertung neben den Messwerten. Eine neuere tritt an ihre Stelle.</translation>
    </message>
    <message>
        <source>Without the checklist: %1</source>
        <translation>Ohne die Checkliste: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Keep the rating</source>
        <translation>Bewertung &amp;behalten</translation>
    </message>
    <message>
        <source>Nothing is judged yet: choose one of the five steps, or yes or no.</source>
        <translation>Noch ist nichts beurteilt: Wählen Sie eine der fünf Stufen oder ja oder nein.</translation>
    </message>
    <message>
        <source>How was it, all in all?  (Alt+1 to Alt+5)</source>
        <translation>Wie war es, alles in allem?  (Alt+1 bis Alt+5)</translation>
    </message>
    <message>
        <source>What the recording could not tell</source>
        <translation>Was die Aufzeichnung nicht sagen konnte</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Nicht beurteilt</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ReachPad</name>
    <message>
        <source>Where the blade&apos;s tip is</source>
        <translation>Wo die Spatelspitze ist</translation>
    </message>
    <message>
        <source>The blade&apos;s tip as the operator sees it, and its depth (mm). With the mouse: drag here, the wheel goes deeper.</source>
        <translation>Die Spatelspitze, wie die Intubierenden sie sehen, und ihre Tiefe (mm). Mit der Maus: hier ziehen, das Rad geht tiefer.</translation>
    </message>
    <message>
        <source>far</source>
        <translation>fern</translation>
    </message>
    <message>
        <source>near</source>
        <translation>nah</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::RecordsPage</name>
    <message>
        <source>Records</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Asking the records ...</source>
        <translation>Die Aufzeichnungen werden gefragt ...</translation>
    </message>
    <message>
        <source>Try a&amp;gain</source>
        <translation>&amp;Erneut versuchen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Trying again ...</source>
        <translation>Wird erneut versucht ...</translation>
    </message>
    <message>
        <source>nobody is signed in</source>
        <translation>niemand ist angemeldet</translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Mein Konto</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ReplayPage</name>
    <message>
        <source>Replay: %1</source>
        <translation>Wiedergabe: %1</translation>
    </message>
    <message>
        <source>X: the way a scripted expert&apos;s tip takes in this patient, in white</source>
        <translation>X: der Weg, den die Spitze eines Experten nach Drehbuch in diesem Patienten nimmt, in Weiß</translation>
    </message>
    <message>
        <source>The scripted expert has no plan for this patient</source>
        <translation>Der Experte nach Drehbuch hat keinen Plan für diesen Patienten</translation>
    </message>
    <message>
        <source> (%1 of %2 points)</source>
        <translation> (%1 von %2 Punkten)</translation>
    </message>
    <message>
        <source>Pass mark: %1</source>
        <translation>Kriterium: %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>The replay was stopped before this second.</source>
        <translation>Die Wiedergabe wurde vor dieser Sekunde angehalten.</translation>
    </message>
    <message>
        <source>attempt %1 s</source>
        <translation>Intubationsversuch %1 s</translation>
    </message>
    <message>
        <source>between attempts</source>
        <translation>zwischen Intubationsversuchen</translation>
    </message>
    <message>
        <source>glottis seen %1 %</source>
        <translation>Glottis zu %1 % sichtbar</translation>
    </message>
    <message>
        <source>tube %1 cm at the lips</source>
        <translation>Tubus %1 cm an den Lippen</translation>
    </message>
    <message>
        <source>device %1</source>
        <translation>Gerät %1</translation>
    </message>
    <message>
        <source>  ·  tongue %1 N, gum %2 N</source>
        <translation>  ·  Zunge %1 N, Zahnleiste %2 N</translation>
    </message>
    <message>
        <source>%1: the picture could not be encoded as PNG</source>
        <translation>%1: Das Bild ließ sich nicht als PNG kodieren</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>The picture was not saved</source>
        <translation>Das Bild wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>A: arrows of the blade&apos;s push on the tissue, 5 mm a newton; blue on soft tissue, red on gums, palate and teeth</source>
        <translation>A: Pfeile für den Druck des Spatels auf das Gewebe, 5 mm je Newton; blau auf Weichteilen, rot auf Zahnleisten, Gaumen und Zähnen</translation>
    </message>
    <message>
        <source>Tip&apos;s path</source>
        <translation>Spatelweg</translation>
    </message>
    <message>
        <source>P: the way of the blade&apos;s tip until now, coloured by the force on the tongue</source>
        <translation>P: der Weg der Spatelspitze bis jetzt, nach der Kraft auf die Zunge gefärbt</translation>
    </message>
    <message>
        <source>Expert&apos;s path</source>
        <translation>Expertenweg</translation>
    </message>
    <message>
        <source>Free camera</source>
        <translation>Freie Kamera</translation>
    </message>
    <message>
        <source>F: drag turns the view, Shift-drag moves it, the wheel goes nearer; Shift and arrow keys turn it too</source>
        <translation>F: Ziehen dreht die Ansicht, Umschalt-Ziehen verschiebt sie, das Rad geht näher; auch Umschalt und Pfeiltasten drehen sie</translation>
    </message>
    <message>
        <source>Half head</source>
        <translation>Halber Kopf</translation>
    </message>
    <message>
        <source>H: with the free camera, without the skin of the patient&apos;s left half, for a look from the side</source>
        <translation>H: mit der freien Kamera, ohne die Haut der linken Hälfte des Patienten, für einen Blick von der Seite</translation>
    </message>
    <message>
        <source>Force over time</source>
        <translation>Kraft über die Zeit</translation>
    </message>
    <message>
        <source>Saturation and heart rate over time</source>
        <translation>Sättigung und Herzfrequenz über die Zeit</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Monitor</translation>
    </message>
    <message>
        <source>What was judged</source>
        <translation>Was beurteilt wurde</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Wertung</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>« Event</source>
        <translation>« Ereignis</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>Voriges Ereignis</translation>
    </message>
    <message>
        <source>‹ Frame</source>
        <translation>‹ Bild</translation>
    </message>
    <message>
        <source>A frame back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Frame ›</source>
        <translation>Bild ›</translation>
    </message>
    <message>
        <source>A frame on</source>
        <translation>Ein Bild weiter</translation>
    </message>
    <message>
        <source>Event »</source>
        <translation>Ereignis »</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Nächstes Ereignis</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>+ and -</source>
        <translation>+ und -</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop computing</source>
        <translation>Berechnung anhalten</translation>
    </message>
    <message>
        <source>What is computed stays</source>
        <translation>Was berechnet ist, bleibt</translation>
    </message>
    <message>
        <source>Picture ...</source>
        <translation>Bild ...</translation>
    </message>
    <message>
        <source>Ctrl+S: both views as a PNG</source>
        <translation>Strg+S: beide Ansichten als PNG</translation>
    </message>
    <message>
        <source>Clip ...</source>
        <translation>Clip ...</translation>
    </message>
    <message>
        <source>Save a clip</source>
        <translation>Clip speichern</translation>
    </message>
    <message>
        <source>Both views from one second to another</source>
        <translation>Beide Ansichten von einer Sekunde bis zu einer anderen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Heat map</source>
        <translation>Druckkarte</translation>
    </message>
    <message>
        <source>C: where the blade pressed on tongue and epiglottis so far, and how hard (kPa): the highest pressure on each part</source>
        <translation>C: wo der Spatel bisher auf Zunge und Epiglottis drückte und wie stark (kPa): der höchste Druck auf jede Stelle</translation>
    </message>
    <message>
        <source>Tip&apos;s path: %1 below half the target force on the tongue %2 up to it (%4 N) %3 over it; in white the expert&apos;s</source>
        <translation>Weg der Spitze: %1 unter der halben Zielkraft auf die Zunge %2 bis zu ihr (%4 N) %3 darüber; in Weiß der des Experten</translation>
    </message>
    <message>
        <source>Enter or a click begins %1 s before; on the timeline the moment itself is framed in yellow</source>
        <translation>Enter oder ein Klick beginnt %1 s davor; auf der Zeitleiste ist der Augenblick selbst gelb umrahmt</translation>
    </message>
    <message>
        <source>Highest pressure on tongue and epiglottis so far: %1 little %2 %3 %4 %5 kPa and more, in every trial; at most %6 kPa in this one</source>
        <translation>Höchster Druck auf Zunge und Epiglottis bisher: %1 wenig %2 %3 %4 %5 kPa und mehr, in jedem Durchgang; höchstens %6 kPa in diesem</translation>
    </message>
    <message>
        <source>The film and its seconds go on in pauses, %1 s in all; the attempt&apos;s time stands in them, as in the result.</source>
        <translation>Der Film und seine Sekunden laufen in Pausen weiter, zusammen %1 s; die Zeit des Intubationsversuchs steht in ihnen, wie im Ergebnis.</translation>
    </message>
    <message>
        <source>Simulating the trial again up to %1 ... %2 % (Stop ends it)</source>
        <translation>Durchgang wird neu simuliert bis %1 ... %2 % (Anhalten beendet es)</translation>
    </message>
    <message>
        <source>Simulating the trial again ... %1 % (Stop ends it)</source>
        <translation>Durchgang wird neu simuliert ... %1 % (Anhalten beendet es)</translation>
    </message>
    <message>
        <source>Simulating the trial again</source>
        <translation>Durchgang wird neu simuliert</translation>
    </message>
    <message>
        <source>Simulating the trial again: the tissue&apos;s shape is not in the log and is computed anew. What is blue on the timeline is there; Stop ends it, and what is computed stays.</source>
        <translation>Der Durchgang wird neu simuliert: Die Form des Gewebes steht nicht in der Aufzeichnung und wird neu berechnet. Was auf der Zeitleiste blau ist, ist da; Anhalten beendet es, und was berechnet ist, bleibt.</translation>
    </message>
    <message>
        <source> (with pauses)</source>
        <translation> (mit Pausen)</translation>
    </message>
    <message>
        <source>no attempt</source>
        <translation>kein Intubationsversuch</translation>
    </message>
    <message>
        <source>before the attempt</source>
        <translation>vor dem Intubationsversuch</translation>
    </message>
    <message>
        <source>after the attempt</source>
        <translation>nach dem Intubationsversuch</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Simulating ... %1 %</source>
        <translation>Simulation ... %1 %</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::ResultPage</name>
    <message>
        <source>Force over time</source>
        <translation>Kraft über die Zeit</translation>
    </message>
    <message>
        <source>Saturation and heart rate over time</source>
        <translation>Sättigung und Herzfrequenz über die Zeit</translation>
    </message>
    <message>
        <source>PASSED</source>
        <translation>BESTANDEN</translation>
    </message>
    <message>
        <source>NOT PASSED</source>
        <translation>NICHT BESTANDEN</translation>
    </message>
    <message>
        <source>L: look at the trial again, at any second of it</source>
        <translation>L: den Durchgang noch einmal ansehen, an jeder Sekunde</translation>
    </message>
    <message>
        <source>A fault: %1</source>
        <translation>Eine Störung: %1</translation>
    </message>
    <message>
        <source>a link leads to its second in the replay</source>
        <translation>ein Verweis führt zu seiner Sekunde in der Wiedergabe</translation>
    </message>
    <message>
        <source>Reasons</source>
        <translation>Gründe</translation>
    </message>
    <message>
        <source>Next attempt</source>
        <translation>Nächster Versuch</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Results: %1</source>
        <translation>Ergebnisse: %1</translation>
    </message>
    <message>
        <source>Attempt seed %1: with it everything is the same once more.</source>
        <translation>Startwert %1: Mit ihm ist alles noch einmal gleich.</translation>
    </message>
    <message>
        <source>An assessment: its replay stays locked.</source>
        <translation>Eine Prüfung: Ihre Wiedergabe bleibt gesperrt.</translation>
    </message>
    <message>
        <source>Saturation and heart rate cannot be drawn: %1</source>
        <translation>Sättigung und Herzfrequenz lassen sich nicht zeichnen: %1</translation>
    </message>
    <message>
        <source>Real-time set-up: %1.</source>
        <translation>Echtzeit-Einrichtung: %1.</translation>
    </message>
    <message>
        <source>A link opens the replay %1 s before its moment, so that it is seen coming; on the timeline the moment itself is framed in yellow.</source>
        <translation>Ein Verweis öffnet die Wiedergabe %1 s vor seinem Augenblick, damit man ihn kommen sieht; auf der Zeitleiste ist der Augenblick selbst gelb umrahmt.</translation>
    </message>
    <message>
        <source>The force plot could not be drawn: %1</source>
        <translation>Das Kraftdiagramm konnte nicht gezeichnet werden: %1</translation>
    </message>
    <message>
        <source>Of %1 forces %2 were written more than 1 ms after they were due, and for %3 the tissue&apos;s step was not finished in time.</source>
        <translation>Von %1 Kräften wurden %2 mehr als 1 ms nach ihrer Zeit ausgegeben, und für %3 war der Rechenschritt des Gewebes nicht rechtzeitig fertig.</translation>
    </message>
    <message>
        <source>The force loop ran at %1 Hz.</source>
        <translation>Die Kraftregelung lief mit %1 Hz.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::RunChecklist</name>
    <message>
        <source>All in all</source>
        <translation>Alles in allem</translation>
    </message>
    <message>
        <source>%1 of 5: %2</source>
        <translation>%1 von 5: %2</translation>
    </message>
    <message>
        <source>All in all %1 of 5: %2</source>
        <translation>Alles in allem %1 von 5: %2</translation>
    </message>
    <message>
        <source>&amp;Keep as my rating</source>
        <translation>Als meine &amp;Bewertung behalten</translation>
    </message>
    <message>
        <source>Once the trial is recorded: the ticks become your rating of it</source>
        <translation>Sobald der Durchgang aufgezeichnet ist: Die Haken werden Ihre Bewertung</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>%1: yes</source>
        <translation>%1: ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>%1: no</source>
        <translation>%1: nein</translation>
    </message>
    <message>
        <source>Tick while you watch; ticked again, it is open.</source>
        <translation>Haken Sie ab, während Sie zusehen; noch einmal, und es ist wieder offen.</translation>
    </message>
    <message>
        <source>recorded: yes</source>
        <translation>aufgezeichnet: ja</translation>
    </message>
    <message>
        <source>recorded: no</source>
        <translation>aufgezeichnet: nein</translation>
    </message>
    <message>
        <source>Recorded. What the recording could not tell is yours to give.</source>
        <translation>Aufgezeichnet. Was die Aufzeichnung nicht sagen konnte, geben Sie an.</translation>
    </message>
    <message>
        <source>The rating is kept.</source>
        <translation>Die Bewertung ist aufbewahrt.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::SelfRatingPage</name>
    <message>
        <source>Before you see the score: what do you think yourself? Your answer is kept with the trial and cannot be changed.</source>
        <translation>Bevor Sie die Wertung sehen: Was meinen Sie selbst? Ihre Antwort wird mit dem Durchgang aufbewahrt und kann nicht geändert werden.</translation>
    </message>
    <message>
        <source>How did you do, all in all?  (keys 1 to 5)</source>
        <translation>Wie haben Sie es gemacht, alles in allem?  (Tasten 1 bis 5)</translation>
    </message>
    <message>
        <source>Did the tube go into the trachea, and is it still there?  (Y, N)</source>
        <translation>Kam der Tubus in die Trachea, und ist er noch dort?  (Y, N)</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Are you sure of that?  (S, U)</source>
        <translation>Sind Sie sich dessen sicher?  (S, U)</translation>
    </message>
    <message>
        <source>Sure</source>
        <translation>Sicher</translation>
    </message>
    <message>
        <source>Unsure</source>
        <translation>Unsicher</translation>
    </message>
    <message>
        <source>Show the score</source>
        <translation>Wertung zeigen</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>The trial is over and counts. Your own rating is still missing: give it now. After closing the window once more, Records asks whose trial it is for it before anything of the trial is shown.</source>
        <translation>Der Durchgang ist vorbei und zählt. Ihre eigene Bewertung fehlt noch: Geben Sie sie jetzt ab. Wird das Fenster noch einmal geschlossen, fragen die Aufzeichnungen danach, bevor etwas vom Durchgang gezeigt wird.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Colours of the whole window; pictures of CTs stay on black</source>
        <translation>Farben des ganzen Fensters; CT-Bilder bleiben auf Schwarz</translation>
    </message>
    <message>
        <source>Size of all text in per cent (Ctrl++ and Ctrl+- on every page)</source>
        <translation>Größe aller Schrift in Prozent (Strg++ und Strg+- auf jeder Seite)</translation>
    </message>
    <message>
        <source>Natural</source>
        <translation>Natürlich</translation>
    </message>
    <message>
        <source>Blue, as in the paper</source>
        <translation>Blau, wie in der Veröffentlichung</translation>
    </message>
    <message>
        <source>Automatic: effects give way to fluency</source>
        <translation>Automatisch: Effekte weichen dem flüssigen Bild</translation>
    </message>
    <message>
        <source>High, whatever it costs</source>
        <translation>Hoch, was es auch kostet</translation>
    </message>
    <message>
        <source>Low, for slow computers</source>
        <translation>Niedrig, für langsame Rechner</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Monitor&apos;s beep: its pitch falls with the saturation</source>
        <translation>&amp;Monitorton: Seine Höhe fällt mit der Sättigung</translation>
    </message>
    <message>
        <source>Loudness of the monitor in per cent</source>
        <translation>Lautstärke des Monitors in Prozent</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Worte</translation>
    </message>
    <message>
        <source>Colour of the windpipe in the views of the airway</source>
        <translation>Farbe der Luftröhre in den Ansichten der Atemwege</translation>
    </message>
    <message>
        <source>How the patient is drawn</source>
        <translation>Wie der Patient gezeichnet wird</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>&amp;Schriftgröße</translation>
    </message>
    <message>
        <source>Tra&amp;chea</source>
        <translation>Tra&amp;chea</translation>
    </message>
    <message>
        <source>Vol&amp;ume</source>
        <translation>&amp;Lautstärke</translation>
    </message>
    <message>
        <source>Of the window&apos;s words: followed at once, or from the next start on where something is under way</source>
        <translation>Der Worte des Fensters: sofort, oder ab dem nächsten Start, wo etwas im Gange ist</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>&amp;Farben</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::SignInDialog</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Up and Down change it from the PIN&apos;s field too</source>
        <translation>Hoch und Runter ändern ihn auch vom PIN-Feld aus</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;PIN</source>
        <translation>&amp;PIN</translation>
    </message>
    <message>
        <source>Somebody ne&amp;w ...</source>
        <translation>&amp;Jemand Neues ...</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Asking the records ...</source>
        <translation>Die Aufzeichnungen werden gefragt ...</translation>
    </message>
    <message>
        <source>Nobody is registered here yet.</source>
        <translation>Hier ist noch niemand registriert.</translation>
    </message>
    <message>
        <source>Looking at the PIN ...</source>
        <translation>Die PIN wird geprüft ...</translation>
    </message>
    <message>
        <source>Too many wrong PINs: wait %1 s, or ask an instructor for a new PIN.</source>
        <translation>Zu viele falsche PINs: Warten Sie %1 s oder bitten Sie eine Lehrperson um eine neue PIN.</translation>
    </message>
    <message>
        <source>Go on as nob&amp;ody</source>
        <translation>&amp;Ohne Anmeldung weiter</translation>
    </message>
    <message>
        <source>Trials then belong to nobody</source>
        <translation>Durchgänge gehören dann niemandem</translation>
    </message>
    <message>
        <source>Registers a trainee, who is signed in then</source>
        <translation>Registriert jemanden zum Üben und meldet ihn oder sie an</translation>
    </message>
    <message>
        <source>No instructor is registered here yet: Records in the first window sets up the first one.</source>
        <translation>Hier ist noch keine Lehrperson eingetragen: Die erste wird im ersten Fenster unter Aufzeichnungen eingerichtet.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::SliceScene</name>
    <message>
        <source>outside the scan</source>
        <translation>außerhalb des Scans</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::SliceView</name>
    <message>
        <source>%1 slice</source>
        <translation>%1er Schnitt</translation>
    </message>
    <message>
        <source>Arrows move the crosshair, Page Up and Page Down change the slice, plus, minus and 0 zoom, Enter puts a point of the tool at the crosshair, Escape puts the tool away, Delete removes the last measure, F shows this view alone</source>
        <translation>Pfeile bewegen das Fadenkreuz, Bild auf und Bild ab wechseln den Schnitt, Plus, Minus und 0 zoomen, Enter setzt einen Punkt des Werkzeugs an das Fadenkreuz, Escape legt das Werkzeug weg, Entf entfernt die letzte Messung, F zeigt nur diese Ansicht</translation>
    </message>
    <message>
        <source>seed of %1</source>
        <translation>Startpunkt von %1</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::SoundButton</name>
    <message>
        <source>Sound of the monitor</source>
        <translation>Ton des Monitors</translation>
    </message>
    <message>
        <source>Volume, per cent</source>
        <translation>Lautstärke, Prozent</translation>
    </message>
    <message>
        <source>Volume of the monitor&apos;s sound, per cent</source>
        <translation>Lautstärke des Monitortons, Prozent</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Ton an</translation>
    </message>
    <message>
        <source>Sound off</source>
        <translation>Ton aus</translation>
    </message>
    <message>
        <source>A tone at each heart beat, lower as the saturation falls, and the monitor&apos;s alarms (M)</source>
        <translation>Ein Ton bei jedem Herzschlag, tiefer, wenn die Sättigung fällt, und die Alarme des Monitors (M)</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::SoundOutput</name>
    <message>
        <source>No sound: this computer has no loudspeaker that can be used.</source>
        <translation>Kein Ton: Dieser Rechner hat keinen Lautsprecher, der sich benutzen lässt.</translation>
    </message>
    <message>
        <source>No sound: the loudspeaker takes no 16 bit samples.</source>
        <translation>Kein Ton: Der Lautsprecher nimmt keine 16-Bit-Werte.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::SourcePage</name>
    <message>
        <source>Folder with the CT&apos;s DICOM files</source>
        <translation>Ordner mit den DICOM-Dateien des CT</translation>
    </message>
    <message>
        <source>Where the CT is</source>
        <translation>Wo das CT liegt</translation>
    </message>
    <message>
        <source>F&amp;ile ...</source>
        <translation>Da&amp;tei ...</translation>
    </message>
    <message>
        <source>Series found</source>
        <translation>Gefundene Serien</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Name of the new patient</source>
        <translation>Name des neuen Patienten</translation>
    </message>
    <message>
        <source>&amp;Use the shipped generic face instead</source>
        <translation>Stattdessen das mitgelieferte allgemeine &amp;Gesicht verwenden</translation>
    </message>
    <message>
        <source>&amp;Read and find the structures</source>
        <translation>&amp;Lesen und die Strukturen finden</translation>
    </message>
    <message>
        <source>&amp;Back to the start</source>
        <translation>&amp;Zurück zum Anfang</translation>
    </message>
    <message>
        <source>&amp;Name of the new patient</source>
        <translation>&amp;Name des neuen Patienten</translation>
    </message>
    <message>
        <source>&amp;CT scan</source>
        <translation>&amp;CT-Scan</translation>
    </message>
    <message>
        <source>Choose the folder with the CT</source>
        <translation>Den Ordner mit dem CT wählen</translation>
    </message>
    <message>
        <source>Choose a file of the CT</source>
        <translation>Eine Datei des CT wählen</translation>
    </message>
    <message>
        <source>Looking at what is there</source>
        <translation>Es wird nachgesehen, was da ist</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>can be imported</source>
        <translation>kann importiert werden</translation>
    </message>
    <message>
        <source>Fol&amp;der ...</source>
        <translation>&amp;Ordner ...</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::StartPage</name>
    <message>
        <source>Practise neonatal intubation, and see what your hands did. A training tool, not a medical device.</source>
        <translation>Üben Sie die Intubation Neugeborener und sehen Sie, was Ihre Hände getan haben. Ein Trainingsgerät, kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Curriculum</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Assessment: no helps, own rating first, no replay</source>
        <translation>Prüfung: keine Hilfen, zuerst eigene Bewertung, keine Wiedergabe</translation>
    </message>
    <message>
        <source>Built-in manikin, made for the scenario</source>
        <translation>Eingebautes Phantom, für das Szenario gemacht</translation>
    </message>
    <message>
        <source>Watch a scripted expert</source>
        <translation>Einem Experten nach Drehbuch zusehen</translation>
    </message>
    <message>
        <source>Watch a scripted novice</source>
        <translation>Einem Anfänger nach Drehbuch zusehen</translation>
    </message>
    <message>
        <source>The same device, blade and tube in turn (X changes)</source>
        <translation>Dasselbe Gerät, Spatel und Tubus im Wechsel (X wechselt)</translation>
    </message>
    <message>
        <source>The mouse</source>
        <translation>Die Maus</translation>
    </message>
    <message>
        <source>Other patient ...</source>
        <translation>Anderer Patient ...</translation>
    </message>
    <message>
        <source>New patient from a CT ...</source>
        <translation>Aus einem CT ...</translation>
    </message>
    <message>
        <source>Devices ...</source>
        <translation>Geräte ...</translation>
    </message>
    <message>
        <source>Prepare the trial</source>
        <translation>Durchgang vorbereiten</translation>
    </message>
    <message>
        <source>Trials with another kind of device do not count here.</source>
        <translation>Durchgänge mit einer anderen Geräteart zählen hier nicht.</translation>
    </message>
    <message>
        <source>A scripted hand can be watched at it before.</source>
        <translation>Zuvor kann man einer Hand nach Drehbuch dabei zusehen.</translation>
    </message>
    <message>
        <source>Choose blade and tube first: they count in the score</source>
        <translation>Wählen Sie zuerst Spatel und Tubus: Sie zählen in der Wertung</translation>
    </message>
    <message>
        <source>A scripted hand has nothing to set.</source>
        <translation>Eine Hand nach Drehbuch hat nichts einzustellen.</translation>
    </message>
    <message>
        <source>This device was not found when devices were last looked for: plug it in, and look again with Devices ...</source>
        <translation>Dieses Gerät wurde bei der letzten Suche nicht gefunden: Schließen Sie es an und suchen Sie erneut mit „Geräte ...“</translation>
    </message>
    <message>
        <source>Choose a patient package (a folder NAME.patient)</source>
        <translation>Ein Patientenpaket wählen (ein Ordner NAME.patient)</translation>
    </message>
    <message>
        <source>%1 is not a patient package (it holds no patient.yaml); make one with `vallecula import`.</source>
        <translation>%1 ist kein Patientenpaket (es enthält keine patient.yaml); erstellen Sie eines mit `vallecula import`.</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Tube&apos;s hand</source>
        <translation>Hand des Tubus</translation>
    </message>
    <message>
        <source>H&amp;ome</source>
        <translation>S&amp;tartseite</translation>
    </message>
    <message>
        <source>Back to the first page (Esc)</source>
        <translation>Zurück zur ersten Seite (Esc)</translation>
    </message>
    <message>
        <source>the built-in manikin</source>
        <translation>das eingebaute Phantom</translation>
    </message>
    <message>
        <source>Choose a scenario of a course first.</source>
        <translation>Wählen Sie zuerst ein Szenario eines Kurses.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Blade and tube are to be chosen first.</source>
        <translation>Spatel und Tubus sind erst zu wählen.</translation>
    </message>
    <message>
        <source>It can only be taken as an assessment.</source>
        <translation>Es lässt sich nur als Prüfung nehmen.</translation>
    </message>
    <message>
        <source>This patient is as large as an infant of %1 kg; the chosen scenario is for one of %2 kg. None that is open is nearer: blade, tube and targets do not fit.</source>
        <translation>Dieser Patient ist so groß wie ein Kind von %1 kg; das gewählte Szenario ist für eines von %2 kg. Kein offenes liegt näher: Spatel, Tubus und Ziele passen nicht.</translation>
    </message>
    <message>
        <source>This patient is as large as an infant of %1 kg: &quot;%2&quot; was chosen, with blade, tube and targets for %3 kg.</source>
        <translation>Dieser Patient ist so groß wie ein Kind von %1 kg: Gewählt wurde „%2“, mit Spatel, Tubus und Zielen für %3 kg.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::StatementDelivery</name>
    <message numerus="yes">
        <source>%n trial(s) sent to the learning record store</source>
        <translation>
            <numerusform>%n Durchgang an den Learning Record Store gesendet</numerusform>
            <numerusform>%n Durchgänge an den Learning Record Store gesendet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) refused by the learning record store: %1</source>
        <translation>
            <numerusform>%n Durchgang vom Learning Record Store abgelehnt: %1</numerusform>
            <numerusform>%n Durchgänge vom Learning Record Store abgelehnt: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not sent yet: %1</source>
        <translation>
            <numerusform>%n Durchgang noch nicht gesendet: %1</numerusform>
            <numerusform>%n Durchgänge noch nicht gesendet: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vallecula::gui::StatementsLine</name>
    <message>
        <source>&amp;Send now</source>
        <translation>Jetzt &amp;senden</translation>
    </message>
    <message>
        <source>Sending ...</source>
        <translation>Wird gesendet ...</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) sent</source>
        <translation>
            <numerusform>%n Durchgang gesendet</numerusform>
            <numerusform>%n Durchgänge gesendet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) refused</source>
        <translation>
            <numerusform>%n Durchgang abgelehnt</numerusform>
            <numerusform>%n Durchgänge abgelehnt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not sent yet: %1</source>
        <translation>
            <numerusform>%n Durchgang noch nicht gesendet: %1</numerusform>
            <numerusform>%n Durchgänge noch nicht gesendet: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vallecula::gui::StructurePanel</name>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>The tick shows or hides a structure in the pictures</source>
        <translation>Der Haken zeigt oder verbirgt eine Struktur in den Bildern</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Angenommen</translation>
    </message>
    <message>
        <source>&amp;Accept</source>
        <translation>An&amp;nehmen</translation>
    </message>
    <message>
        <source>It is as it should be</source>
        <translation>Sie ist, wie sie sein soll</translation>
    </message>
    <message>
        <source>Give a &amp;seed ...</source>
        <translation>&amp;Startpunkt geben ...</translation>
    </message>
    <message>
        <source>Then click a point inside the structure, in any slice (or Enter at the crosshair)</source>
        <translation>Dann einen Punkt in der Struktur anklicken, in einem beliebigen Schnitt (oder Enter am Fadenkreuz)</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> HU</translation>
    </message>
    <message>
        <source>Lowest grey value of the structure, HU</source>
        <translation>Niedrigster Grauwert der Struktur, HU</translation>
    </message>
    <message>
        <source>Highest grey value of the structure, HU</source>
        <translation>Höchster Grauwert der Struktur, HU</translation>
    </message>
    <message>
        <source>Lowest HU of the structure</source>
        <translation>Niedrigste HU der Struktur</translation>
    </message>
    <message>
        <source>Highest HU of the structure</source>
        <translation>Höchste HU der Struktur</translation>
    </message>
    <message>
        <source>&amp;Preview</source>
        <translation>&amp;Vorschau</translation>
    </message>
    <message>
        <source>Tints in the slices what lies between the two (HU)</source>
        <translation>Färbt in den Schnitten, was zwischen beiden liegt (HU)</translation>
    </message>
    <message>
        <source>&amp;Use the threshold</source>
        <translation>S&amp;chwelle verwenden</translation>
    </message>
    <message>
        <source>&amp;Load a label map ...</source>
        <translation>&amp;Karte laden ...</translation>
    </message>
    <message>
        <source>Takes this structure from a label map made elsewhere (3D Slicer)</source>
        <translation>Nimmt diese Struktur aus einer anderswo erstellten Label-Karte (3D Slicer)</translation>
    </message>
    <message>
        <source>&amp;Drop edits</source>
        <translation>Ver&amp;werfen</translation>
    </message>
    <message>
        <source>Takes back seed, threshold and label map of this structure</source>
        <translation>Nimmt Startpunkt, Schwelle und Label-Karte dieser Struktur zurück</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>not looked for yet</source>
        <translation>noch nicht gesucht</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source> + seed</source>
        <translation> + Startpunkt</translation>
    </message>
    <message>
        <source> + threshold</source>
        <translation> + Schwelle</translation>
    </message>
    <message>
        <source> + label map</source>
        <translation> + Label-Karte</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>not found: give a seed, a threshold or a label map</source>
        <translation>nicht gefunden: Geben Sie einen Startpunkt, eine Schwelle oder eine Label-Karte</translation>
    </message>
    <message>
        <source>click inside it (Esc: no)</source>
        <translation>hineinklicken (Esc: nein)</translation>
    </message>
    <message>
        <source>%1, %2, %3 mm</source>
        <translation>%1, %2, %3 mm</translation>
    </message>
    <message>
        <source>Finds this structure anew between these two</source>
        <translation>Sucht diese Struktur neu zwischen diesen beiden</translation>
    </message>
    <message>
        <source>The lowest must lie below the highest</source>
        <translation>Der niedrigste muss unter dem höchsten liegen</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::TextField</name>
    <message>
        <source>%1: language</source>
        <translation>%1: Sprache</translation>
    </message>
    <message>
        <source>Add a language ...</source>
        <translation>Sprache hinzufügen ...</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>As the trainee will read it</source>
        <translation>Wie Lernende es lesen werden</translation>
    </message>
    <message>
        <source>As the trainee reads it</source>
        <translation>Wie Lernende es lesen</translation>
    </message>
    <message>
        <source>Add a language</source>
        <translation>Eine Sprache hinzufügen</translation>
    </message>
    <message>
        <source>Its code, like de, fr or pt-BR:</source>
        <translation>Ihr Kürzel, wie de, fr oder pt-BR:</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::Timeline</name>
    <message>
        <source>Time in the trial</source>
        <translation>Zeit im Durchgang</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::TrialChart</name>
    <message>
        <source>trial</source>
        <translation>Durchgang</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::TrialPage</name>
    <message>
        <source>Scoring the trial ...</source>
        <translation>Der Durchgang wird ausgewertet ...</translation>
    </message>
    <message>
        <source>Enter starts the trial and takes hold again after a pause, Esc ends it.</source>
        <translation>Enter beginnt den Durchgang und fasst nach einer Pause wieder zu, Esc beendet ihn.</translation>
    </message>
    <message>
        <source>Button %1 of the device, held, frees your hand: the blade stays.</source>
        <translation>Taste %1 des Geräts, gehalten, gibt Ihre Hand frei: Der Spatel bleibt.</translation>
    </message>
    <message>
        <source>Scripted hands are at work. Esc ends the trial.</source>
        <translation>Hände nach Drehbuch sind am Werk. Esc beendet den Durchgang.</translation>
    </message>
    <message>
        <source>The hands of a recorded trial are at work. Esc ends the trial.</source>
        <translation>Die Hände eines aufgezeichneten Durchgangs sind am Werk. Esc beendet den Durchgang.</translation>
    </message>
    <message>
        <source>%1   |   F1: all keys</source>
        <translation>%1   |   F1: alle Tasten</translation>
    </message>
    <message>
        <source>You hold: right hand, TUBE. The blade stays.</source>
        <translation>Sie halten: rechte Hand, TUBUS. Der Spatel bleibt.</translation>
    </message>
    <message>
        <source>You hold: left hand, BLADE. The tube stays.</source>
        <translation>Sie halten: linke Hand, SPATEL. Der Tubus bleibt.</translation>
    </message>
    <message>
        <source>The trial begins as soon as its log is on the disk.</source>
        <translation>Der Durchgang beginnt, sobald sein Protokoll auf der Platte ist.</translation>
    </message>
    <message>
        <source>The blade is being led to the vallecula; then it is yours.</source>
        <translation>Der Spatel wird zur Vallecula geführt; dann gehört er Ihnen.</translation>
    </message>
    <message>
        <source>View: auto</source>
        <translation>Sicht: auto</translation>
    </message>
    <message>
        <source>View: face</source>
        <translation>Sicht: Gesicht</translation>
    </message>
    <message>
        <source>View: mouth</source>
        <translation>Sicht: Mund</translation>
    </message>
    <message>
        <source>Once the trial runs</source>
        <translation>Sobald der Durchgang läuft</translation>
    </message>
    <message>
        <source>Not in an assessment</source>
        <translation>Nicht in einer Prüfung</translation>
    </message>
    <message>
        <source>This scenario does not show it.</source>
        <translation>Dieses Szenario zeigt das nicht.</translation>
    </message>
    <message>
        <source>Expert - your trial waits</source>
        <translation>Experte - Ihr Durchgang wartet</translation>
    </message>
    <message>
        <source>Back to my trial (G)</source>
        <translation>Zurück (G)</translation>
    </message>
    <message>
        <source>An expert&apos;s hands at this patient, computed for it. Esc or G: back to your trial.</source>
        <translation>Die Hände eines Experten an diesem Patienten, für ihn berechnet. Esc oder G: zurück zu Ihrem Durchgang.</translation>
    </message>
    <message>
        <source>The expert cannot be shown: %1</source>
        <translation>Der Experte lässt sich nicht zeigen: %1</translation>
    </message>
    <message>
        <source>Expert - being computed; your trial waits</source>
        <translation>Experte - wird berechnet; Ihr Durchgang wartet</translation>
    </message>
    <message>
        <source>Expert (G)</source>
        <translation>Experte (G)</translation>
    </message>
    <message>
        <source>starts the trial; takes hold again after a pause</source>
        <translation>beginnt den Durchgang; fasst nach einer Pause wieder zu</translation>
    </message>
    <message>
        <source>ends the trial; before it, goes back</source>
        <translation>beendet den Durchgang; vor dem Beginn zurück</translation>
    </message>
    <message>
        <source>begins anew; what was done is kept</source>
        <translation>beginnt neu; was getan wurde, bleibt</translation>
    </message>
    <message>
        <source>begins anew with the blade&apos;s tip in the vallecula</source>
        <translation>beginnt neu mit der Spatelspitze in der Vallecula</translation>
    </message>
    <message>
        <source>your own head 2 cm to the left, and back</source>
        <translation>Ihr eigener Kopf 2 cm nach links und zurück</translation>
    </message>
    <message>
        <source>your own head 2 cm to the right, and back</source>
        <translation>Ihr eigener Kopf 2 cm nach rechts und zurück</translation>
    </message>
    <message>
        <source>your own head 2 cm up, and back</source>
        <translation>Ihr eigener Kopf 2 cm nach oben und zurück</translation>
    </message>
    <message>
        <source>your own head 2 cm down, and back</source>
        <translation>Ihr eigener Kopf 2 cm nach unten und zurück</translation>
    </message>
    <message>
        <source>extends the infant&apos;s head by 10 degrees, and back</source>
        <translation>streckt den Kopf des Kindes um 10 Grad und zurück</translation>
    </message>
    <message>
        <source>how near the view is: by itself, the face, the mouth</source>
        <translation>wie nah die Sicht ist: von selbst, Gesicht, Mund</translation>
    </message>
    <message>
        <source>the monitor&apos;s sound, on or off</source>
        <translation>Ton des Monitors an oder aus</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>What the hand steers</source>
        <translation>Was die Hand steuert</translation>
    </message>
    <message>
        <source>Hands and helpers</source>
        <translation>Hände und Helfende</translation>
    </message>
    <message>
        <source>Questions and alarms</source>
        <translation>Fragen und Alarme</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Bereiche</translation>
    </message>
    <message>
        <source>Which panels are shown (Alt+1 and on); each may be moved, or taken out of the window</source>
        <translation>Welche Bereiche gezeigt werden (Alt+1 und weiter); jeder lässt sich verschieben oder aus dem Fenster nehmen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>All keys of this page (F1)</source>
        <translation>Alle Tasten dieser Seite (F1)</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Begins the trial (Enter)</source>
        <translation>Beginnt den Durchgang (Enter)</translation>
    </message>
    <message>
        <source>Ends the trial and scores it (Esc)</source>
        <translation>Beendet den Durchgang und wertet ihn aus (Esc)</translation>
    </message>
    <message>
        <source>Begins anew; what was done until now is kept (R)</source>
        <translation>Beginnt neu; was bis jetzt getan wurde, bleibt (R)</translation>
    </message>
    <message>
        <source>How near the operator&apos;s view is: by itself, the face, or the mouth (Z)</source>
        <translation>Wie nah die Sicht der Intubierenden ist: von selbst, Gesicht oder Mund (Z)</translation>
    </message>
    <message>
        <source>Back to where this trial was chosen (Esc, before the start)</source>
        <translation>Zurück dorthin, wo dieser Durchgang gewählt wurde (Esc, vor dem Start)</translation>
    </message>
    <message>
        <source>Expert - your trial waits
%1 of %2 s   |   Esc or G: back to your trial</source>
        <translation>Experte - Ihr Durchgang wartet
%1 von %2 s   |   Esc oder G: zurück zu Ihrem Durchgang</translation>
    </message>
    <message>
        <source>The clock runs on: an assessment is not held up.</source>
        <translation>Die Uhr läuft weiter: Eine Prüfung wird nicht angehalten.</translation>
    </message>
    <message>
        <source>Until then it is not ended here: ask your instructor.</source>
        <translation>Bis dahin lässt er sich hier nicht beenden: Bitte die Lehrperson fragen.</translation>
    </message>
    <message>
        <source>An instructor holds the trial: it is ended once they let it go on</source>
        <translation>Die Lehrperson hält den Durchgang an: Er lässt sich beenden, sobald sie ihn freigibt</translation>
    </message>
    <message>
        <source>an expert at this patient while the trial waits, and back</source>
        <translation>ein Experte an diesem Patienten, während der Durchgang wartet, und zurück</translation>
    </message>
    <message>
        <source>this list, and closes it</source>
        <translation>diese Liste, und schließt sie</translation>
    </message>
    <message>
        <source>Your trial waits while this list is open. F1 or Esc closes it; then it goes on as after any pause.</source>
        <translation>Ihr Durchgang wartet, solange diese Liste offen ist. F1 oder Esc schließt sie; dann geht er weiter wie nach jeder Pause.</translation>
    </message>
    <message>
        <source>For %1 s no picture came to the screen; the trial waited. If it happens again, close other programs.</source>
        <translation>%1 s lang kam kein Bild auf den Bildschirm; der Durchgang hat gewartet. Kommt das wieder vor, schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>The trial waited for %1 s while its window was not to be seen.</source>
        <translation>Der Durchgang hat %1 s lang gewartet, solange sein Fenster nicht zu sehen war.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::TrialPanels</name>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Bereiche</translation>
    </message>
    <message>
        <source>&amp;Monitor</source>
        <translation>&amp;Monitor</translation>
    </message>
    <message>
        <source>Mid-&amp;sagittal cut</source>
        <translation>Sagittal&amp;schnitt</translation>
    </message>
    <message>
        <source>&amp;Video laryngoscope</source>
        <translation>&amp;Videolaryngoskop</translation>
    </message>
    <message>
        <source>&amp;Force</source>
        <translation>&amp;Kraft</translation>
    </message>
    <message>
        <source>&amp;Readings</source>
        <translation>Mess&amp;werte</translation>
    </message>
    <message>
        <source>&amp;Team</source>
        <translation>&amp;Team</translation>
    </message>
    <message>
        <source>This scenario does not show it.</source>
        <translation>Dieses Szenario zeigt das nicht.</translation>
    </message>
    <message>
        <source>In this scenario there is no infant on a monitor.</source>
        <translation>In diesem Szenario ist kein Kind an einem Monitor.</translation>
    </message>
    <message>
        <source>This scenario asks you things: its place stays.</source>
        <translation>Dieses Szenario fragt Sie etwas: Der Platz dafür bleibt.</translation>
    </message>
    <message>
        <source>Switches this panel on and off</source>
        <translation>Schaltet diesen Bereich an und aus</translation>
    </message>
    <message>
        <source>Panels &amp;as at first</source>
        <translation>Bereiche wie am &amp;Anfang</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::TrialReadings</name>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Glottis visible</source>
        <translation>Glottis sichtbar</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Tubus</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Frames drawn a second, and what was left out of the picture so that hand and picture keep their time.</source>
        <translation>Gezeichnete Bilder pro Sekunde, und was im Bild weggelassen wurde, damit Hand und Bild ihre Zeit einhalten.</translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation>höchstens %1 s</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>not in the mouth</source>
        <translation>nicht im Mund</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>misst</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>following your hand</source>
        <translation>folgt Ihrer Hand</translation>
    </message>
    <message>
        <source>at the device limit</source>
        <translation>an der Gerätegrenze</translation>
    </message>
    <message>
        <source>Device limit reached: the device cannot push back harder, so the blade stays where it is. The grey blade shows your hand.</source>
        <translation>Gerätegrenze erreicht: Das Gerät kann nicht stärker zurückdrücken, also bleibt der Spatel, wo er ist. Der graue Spatel zeigt Ihre Hand.</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>gelöst</translation>
    </message>
    <message>
        <source>The device stopped answering. No force is shown until it is back.</source>
        <translation>Das Gerät antwortet nicht mehr. Bis es zurück ist, wird keine Kraft gezeigt.</translation>
    </message>
    <message>
        <source>The device stayed over its limit too long and let go. Bring the grey blade back to the steel one to take hold again.</source>
        <translation>Das Gerät blieb zu lange über seiner Grenze und ließ los. Bringen Sie den grauen Spatel zum stählernen zurück, um wieder zuzufassen.</translation>
    </message>
    <message>
        <source>taking hold again</source>
        <translation>fasst wieder zu</translation>
    </message>
    <message>
        <source>Taking hold again: the force returns gently.</source>
        <translation>Wieder zugefasst: Die Kraft kommt sanft zurück.</translation>
    </message>
    <message>
        <source>Paused. %1</source>
        <translation>Angehalten. %1</translation>
    </message>
    <message>
        <source>A fault: %1. Reset to begin anew; what led to it is kept.</source>
        <translation>Ein Fehler: %1. „Von vorn“ beginnt neu; was dazu führte, ist aufbewahrt.</translation>
    </message>
    <message>
        <source>catheter %1 cm at the lips</source>
        <translation>Katheter, %1 cm an den Lippen</translation>
    </message>
    <message>
        <source>%1 cm at the lips</source>
        <translation>%1 cm an den Lippen</translation>
    </message>
    <message>
        <source>catheter not in the mouth</source>
        <translation>Katheter, nicht im Mund</translation>
    </message>
    <message>
        <source>%1, less detail</source>
        <translation>%1, weniger Details</translation>
    </message>
    <message>
        <source>From Start</source>
        <translation>Ab Start</translation>
    </message>
    <message>
        <source>no attempt: mouth not known</source>
        <translation>kein Versuch: Mund unbekannt</translation>
    </message>
    <message>
        <source>Where this patient&apos;s mouth begins is not known: the clock counts from Start, and the result has no attempt&apos;s time.</source>
        <translation>Wo der Mund dieses Patienten beginnt, ist nicht bekannt: Die Uhr zählt ab Start, und das Ergebnis hat keine Zeit des Intubationsversuchs.</translation>
    </message>
    <message>
        <source>%1, %2 N on the hand</source>
        <translation>%1, %2 N auf die Hand</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>keeps up with the hand</source>
        <translation>hält mit der Hand Schritt</translation>
    </message>
    <message>
        <source>too slow: forces come late</source>
        <translation>zu langsam: Kräfte kommen verspätet</translation>
    </message>
    <message>
        <source>The force loop runs at %1. Of %2 forces %3 were written more than 1 ms after they were due, and for %4 the tissue&apos;s step was not finished in time.</source>
        <translation>Die Kraftregelung läuft mit %1. Von %2 Kräften wurden %3 mehr als 1 ms nach ihrer Zeit ausgegeben, und für %4 war der Rechenschritt des Gewebes nicht rechtzeitig fertig.</translation>
    </message>
    <message>
        <source>catheter beside the mouth</source>
        <translation>Katheter, neben dem Mund</translation>
    </message>
    <message>
        <source>beside the mouth</source>
        <translation>neben dem Mund</translation>
    </message>
    <message>
        <source>catheter %1 cm before the gums</source>
        <translation>Katheter, %1 cm vor der Zahnleiste</translation>
    </message>
    <message>
        <source>%1 cm before the gums</source>
        <translation>%1 cm vor der Zahnleiste</translation>
    </message>
    <message>
        <source>In the mouth: the mark at the lips (cm), and how hard the tube pushes back on the hand (N). Before it: how far the tip is from the gums; to one eye a tube before the mouth looks like one in it.</source>
        <translation>Im Mund: die Marke an den Lippen (cm), und wie stark der Tubus auf die Hand zurückdrückt (N). Davor: wie weit die Spitze von der Zahnleiste ist; mit einem Auge sieht ein Tubus vor dem Mund aus wie einer darin.</translation>
    </message>
    <message>
        <source>Your attempt</source>
        <translation>Ihr Versuch</translation>
    </message>
    <message>
        <source>Glottis visible: expert</source>
        <translation>Glottis sichtbar: Experte</translation>
    </message>
    <message>
        <source>expert: %1</source>
        <translation>Experte: %1</translation>
    </message>
    <message>
        <source>%1 cm at the lips (rule: %2)</source>
        <translation>%1 cm an den Lippen (Regel: %2)</translation>
    </message>
    <message>
        <source>Rule: the scenario&apos;s weight in kg (%1) and 6 cm at the upper lip. A help that hits about half of all infants; judged is where the tip lies.</source>
        <translation>Regel: das Gewicht des Szenarios in kg (%1) und 6 cm, an der Oberlippe. Eine Hilfe, die bei etwa der Hälfte der Kinder stimmt; gewertet wird, wo die Spitze liegt.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::TrialsPanel</name>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Intubationsversuche</translation>
    </message>
    <message>
        <source>Length (s)</source>
        <translation>Dauer (s)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Ra&amp;te ...</source>
        <translation>Be&amp;werten ...</translation>
    </message>
    <message>
        <source>rate it first</source>
        <translation>zuerst bewerten</translation>
    </message>
    <message>
        <source>Enter, or a double click on the trial</source>
        <translation>Enter oder ein Doppelklick auf den Durchgang</translation>
    </message>
    <message>
        <source>This assessment shows its figures, its result and its report once you have rated it yourself.</source>
        <translation>Diese Prüfung zeigt Messwerte, Ergebnis und Bericht, sobald Sie sie selbst bewertet haben.</translation>
    </message>
    <message>
        <source>Nobody has rated this trial.</source>
        <translation>Niemand hat diesen Durchgang bewertet.</translation>
    </message>
    <message>
        <source>This trial&apos;s files are not on this computer: they are on the station it was done at, or were moved.</source>
        <translation>Die Dateien dieses Durchgangs liegen nicht auf diesem Rechner: Sie sind auf der Station, an der er stattfand, oder wurden verschoben.</translation>
    </message>
    <message>
        <source>Rate it first: %1</source>
        <translation>Zuerst bewerten: %1</translation>
    </message>
    <message>
        <source>Reading the trial ...</source>
        <translation>Der Durchgang wird gelesen ...</translation>
    </message>
    <message>
        <source>The rating is kept.</source>
        <translation>Die Bewertung ist aufbewahrt.</translation>
    </message>
    <message>
        <source>Rate it firs&amp;t ...</source>
        <translation>Zuerst &amp;bewerten ...</translation>
    </message>
    <message>
        <source>Squares, at their value but off the line, were interrupted or are not counted (practised with help, changed by an instructor, or without an attempt), crosses not passed, discs passed.</source>
        <translation>Quadrate, bei ihrem Wert, aber nicht in der Linie: abgebrochen oder nicht gezählt (mit Hilfe geübt, von einer Lehrperson verändert oder ohne Intubationsversuch), Kreuze: nicht bestanden, Punkte: bestanden.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::WhoStrip</name>
    <message>
        <source>Sign out</source>
        <translation>Abmelden</translation>
    </message>
    <message>
        <source>&amp;Records ...</source>
        <translation>Auf&amp;zeichnungen ...</translation>
    </message>
    <message>
        <source>Signed in: %1</source>
        <translation>Angemeldet: %1</translation>
    </message>
    <message>
        <source>Nobody is signed in: trials belong to nobody. Records ... is where to sign in.</source>
        <translation>Niemand ist angemeldet: Durchgänge gehören niemandem. Unter „Aufzeichnungen ...“ meldet man sich an.</translation>
    </message>
</context>
<context>
    <name>vallecula::gui::WorkStrip</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Ends it and leaves nothing behind (Esc)</source>
        <translation>Beendet es und hinterlässt nichts (Esc)</translation>
    </message>
    <message>
        <source>Stopping ...</source>
        <translation>Wird angehalten ...</translation>
    </message>
</context>
</TS>
