// What trainees read of the courses that come with the program (curricula/courses), word for word as it stands there.
#include <QCoreApplication>

#include "gui/session/from_below/sentences.h"

namespace vallecula::gui::from_below {
namespace {

constexpr const char* kTexts[] = {
    // Titles of courses, modules and scenarios
    QT_TRANSLATE_NOOP("Courses", "First intubation"),
    QT_TRANSLATE_NOOP("Courses", "Term infant, 3.2 kg, tube 3.5"),
    QT_TRANSLATE_NOOP("Courses", "Preterm infant, 1.2 kg, premedicated, tube 2.5"),
    QT_TRANSLATE_NOOP("Courses", "Delivery room, 3.2 kg, one minute old"),
    QT_TRANSLATE_NOOP("Courses", "Term infant, 3.2 kg, secretions before the cords"),
    QT_TRANSLATE_NOOP("Courses", "Term infant, 3.2 kg, cords that shut when touched"),
    QT_TRANSLATE_NOOP("Courses", "First steps in laryngoscopy"),
    QT_TRANSLATE_NOOP("Courses", "Term infant, 3.2 kg"),
    QT_TRANSLATE_NOOP("Courses", "Preterm infant, 1.2 kg"),
    QT_TRANSLATE_NOOP("Courses", "Term infant with a stiff tongue, 3.6 kg"),
    QT_TRANSLATE_NOOP("Courses", "Neonatal intubation"),
    QT_TRANSLATE_NOOP("Courses", "Handling the blade"),
    QT_TRANSLATE_NOOP("Courses", "Finding the view"),
    QT_TRANSLATE_NOOP("Courses", "Passing the tube"),
    QT_TRANSLATE_NOOP("Courses", "Preterm and difficult airway"),
    QT_TRANSLATE_NOOP("Courses", "Under distraction and time"),
    QT_TRANSLATE_NOOP("Courses", "The way in"),
    QT_TRANSLATE_NOOP("Courses", "Lift, do not lever"),
    QT_TRANSLATE_NOOP("Courses", "A light hand"),
    QT_TRANSLATE_NOOP("Courses", "Term infant"),
    QT_TRANSLATE_NOOP("Courses", "No two are the same"),
    QT_TRANSLATE_NOOP("Courses", "Tube 3.5 on a stylet"),
    QT_TRANSLATE_NOOP("Courses", "Tube 3.5 without a stylet"),
    QT_TRANSLATE_NOOP("Courses", "Secretions before the cords"),
    QT_TRANSLATE_NOOP("Courses", "Preterm infant, 1.2 kg, premedicated"),
    QT_TRANSLATE_NOOP("Courses", "Extremely preterm, 0.95 kg"),
    QT_TRANSLATE_NOOP("Courses", "Small mouth, large stiff tongue"),
    QT_TRANSLATE_NOOP("Courses", "High larynx, long epiglottis"),
    QT_TRANSLATE_NOOP("Courses", "Cords that shut when touched"),
    QT_TRANSLATE_NOOP("Courses", "Questions meanwhile"),
    QT_TRANSLATE_NOOP("Courses", "Alarms and a talking team"),
    QT_TRANSLATE_NOOP("Courses", "Delivery room, one minute old"),
    // Goals of courses and modules
    QT_TRANSLATE_NOOP(
        "Courses",
        "Bring the blade to the vallecula without resting on the gum, and lift along the handle instead of levering."),
    QT_TRANSLATE_NOOP("Courses",
                      "Bring the glottis into view in term and preterm infants with no more force than it takes."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Pass the tube under sight within 30 seconds, to a depth that fits this infant, and prove where it lies."),
    QT_TRANSLATE_NOOP("Courses", "Recognise early that an attempt will not succeed, end it, ventilate, and come back."),
    QT_TRANSLATE_NOOP("Courses", "Do so while others talk, ask and sound alarms."),
    QT_TRANSLATE_NOOP("Courses",
                      "The blade goes in at the right corner, takes the tongue along, and rests on nothing."),
    QT_TRANSLATE_NOOP("Courses", "The glottis comes into view in infants of every size, each a little different."),
    QT_TRANSLATE_NOOP("Courses", "The tube passes the cords under sight, to the right depth, and CO2 proves it."),
    QT_TRANSLATE_NOOP("Courses", "Small, stiff, narrow or closed: the plan changes before the force does."),
    QT_TRANSLATE_NOOP("Courses", "The hands go on while the head is asked for something else."),
    // Briefings and debriefings
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.2 kg, head in the sniffing position. Hold the handle in the left hand. Enter at "
        "the right corner of the mouth, sweep the tongue to the left and bring the tip of the blade into the "
        "vallecula. Lift along the handle, to the ceiling and the feet, until at least half (50 %) of the "
        "glottis is in sight. Then take the blade out. You have 30 seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "The lift opens the view, not a turn of the wrist: turning the blade about the upper gum presses on "
        "it and shows less. If the glottis stayed hidden, ask where the tip was: short of the vallecula it "
        "lifts the tongue only, beyond it the epiglottis hangs in the way."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A preterm infant of about 29 weeks and 1.2 kg. Everything is smaller: the same movement of your "
        "hand is a larger part of the way, and the tongue asks for less force. Blade 0. Bring at least half "
        "(50 %) of the glottis into sight within 30 seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "In premedicated preterm infants the saturation was below 90 % at 22 seconds after the last breath "
        "(median), long before the 30 seconds are over: a calm, short attempt is worth more than a full "
        "view. A blade that went past the vallecula has to come back slowly until the epiglottis drops into "
        "sight."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.6 kg whose tongue resists more than usual. The way is the same; the force will "
        "not be. Place the tip well before you lift: a good position is worth more than a strong arm. At "
        "least half (50 %) of the glottis, within 30 seconds, and no more force than with a soft tongue."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A stiff tongue tempts the hand to press on and to lever. If the force went over its target before "
        "anything was to be seen, the tip was not deep enough in the vallecula, or the lift did not follow "
        "the handle."),
    QT_TRANSLATE_NOOP("Courses",
                      "A term newborn of 3.2 kg that breathes by itself and is to be ventilated. Its saturation and "
                      "heart rate are good: it needs no breaths by mask first, but between two attempts; in life "
                      "it would be given oxygen first. Bring the "
                      "blade in at the right corner, lift, and see at least 50 % of the glottis. Take the tube in your "
                      "right hand, enter beside the blade, and watch its tip pass the cords when "
                      "they open with a breath, until the black mark stands between them. Take the blade out within 30 "
                      "seconds. Give breaths through the tube and look at the detector."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Saturation on the monitor is ten seconds old: the number you see belongs to the past. A rising "
        "heart rate is the first sign of success, a detector that turns yellow the second. If the tube met "
        "something hard, it was turned or drawn back, not pushed. Is the tip in the middle third between "
        "cords and carina? The mark at the lip is a help, no proof."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A preterm infant of 29 weeks and 1.2 kg, asleep and relaxed: it does not breathe and the cords "
        "stand still. The last breath was yours, and the saturation falls sooner than in a larger child. See "
        "at least 50 % of the glottis, pass the tube, blade out within 30 seconds. Not there in time? Blade "
        "out, ventilate, try again."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Half of such infants were below ninety percent twenty-two seconds after the last breath. An attempt "
        "that is given up in time is no failure; one that goes on while the numbers fall is. From cords to "
        "carina there are only four centimetres here: a centimetre decides between good, too deep and one "
        "lung."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A newborn of 3.2 kg, one minute old, that does not breathe. The saturation is low, as it is in "
        "every child at that age, and the heart is slow: it needs air more than it needs a tube. Give "
        "breaths by mask until the heart is above 100, then intubate: at least 50 % of the glottis, blade "
        "out within 30 seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A low number at one minute is normal; a heart that does not rise is not. With too little blood "
        "through the lungs the detector stays purple though the tube lies well: look at the chest and the "
        "heart before it is pulled."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.2 kg whose throat is full of fluid: the cords lie below it. Take the suction "
        "catheter before the tube, clear the view, then change outside the mouth. At least 50 % of the "
        "glottis, blade out within 30 seconds; you may take the blade out and ventilate in between."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "What is not seen cannot be intubated: a tube pushed into fluid finds the oesophagus more often than "
        "the trachea. Was the suction ready before the blade went in? Suction costs time and breath; it is "
        "done under sight, and shortly."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.2 kg, awake and without a relaxant. If the tube touches the cords they may shut "
        "and stay so. Then do not push: blade out, wait, give breaths by mask as soon as air goes in, and "
        "come back. At least 50 % of the glottis, each attempt within 30 seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Closed cords are stronger than a tube should be. Whoever waits for them to part with a breath "
        "touches them less; whoever pushes hurts them and gains nothing. No air goes through while they are "
        "shut, by mask neither: the saturation tells of it late, the heart earlier."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.2 kg, head in the sniffing position.\n\n- Handle in the **left** hand, blade in "
        "at the right corner of the mouth.\n- Sweep the tongue to the left.\n- Bring the tip into the "
        "vallecula and lift until 30 % of the glottis is in sight.\n- Take the blade out within 40 seconds."),
    QT_TRANSLATE_NOOP("Courses",
                      "This is about where the blade touches. The upper gum is no support: what you felt there is "
                      "levering. If the\ntongue came back over the blade, it was not swept far enough to the left."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "The same infant. Once the tip is in the vallecula, move the **whole** blade along its handle, to "
        "the ceiling and\nthe feet, without turning the wrist. At least 50 % of the glottis, blade out "
        "within 40 seconds, and the gum left\nalone."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Turning about the upper gum lifts the tip by little and hides the view behind the blade. Look at "
        "the two bars:\nthe tongue's may rise, the gum's may not. An expert lifts, waits a moment, and looks."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.4 kg. The view is the same; the force may be less. At least 50 % of the glottis "
        "within 30\nseconds, and never more than the bar's mark for long."),
    QT_TRANSLATE_NOOP("Courses",
                      "Force grows with every millimetre beyond the place where the view opens. Whoever places the tip "
                      "well needs less\nof it. A peak while lifting is no fault; holding it is."),
    QT_TRANSLATE_NOOP("Courses",
                      "A term newborn of 3.2 kg, another stiffness of the tongue each time. Bring at least 50 % of the "
                      "glottis into\nsight and take the blade out within 30 seconds."),
    QT_TRANSLATE_NOOP("Courses",
                      "If the glottis stayed hidden, ask where the tip was: short of the vallecula it lifts the tongue "
                      "only, beyond it\nthe epiglottis hangs in the way. Coming back slowly lets it drop into sight."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.2 kg, another one each time: tongue, mouth and epiglottis differ within what is "
        "usual. At\nleast 50 % of the glottis within 30 seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "What differed this time? A longer epiglottis asks for a deeper tip, a fuller tongue for a longer "
        "sweep, a\nnarrower mouth for a flatter way in. The order of the steps is always the same."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A preterm infant of 29 weeks and 1.2 kg. Everything is smaller: the same movement of your hand is a "
        "larger part\nof the way, and the tongue asks for less force. At least 50 % of the glottis within 30 "
        "seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A blade that went past the vallecula has to come back slowly until the epiglottis drops into sight. "
        "A calm,\nshort attempt is worth more than a full view: premedicated preterm infants were below 90 % "
        "at 22 seconds after\nthe last breath (median)."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.2 kg that breathes by itself and is to be ventilated. Its saturation and heart "
        "rate are good:\nit needs no breaths by mask first, but between two attempts; in life it would be given oxygen "
        "first.\nSee at least 50 % of the "
        "glottis, take the tube in\nthe right hand, enter **beside** the blade, and watch its tip pass the cords "
        "until the black mark stands between\nthem. Blade out within 30 seconds; then breaths through the tube, and "
        "look at the detector."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Saturation on the monitor is about ten seconds old. A rising heart rate is the first sign of "
        "success, a detector\nthat turns yellow the second. If the tube met something hard: was it turned or "
        "drawn back?"),
    QT_TRANSLATE_NOOP("Courses",
                      "The same with a soft tube: it bends where the stylet held it. Let its own curve lead it to the "
                      "front. At least\n50 % of the glottis, blade out within 30 seconds. Afterwards check the depth."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "The mark at the lip is a help, no proof: the rules hit the middle of the trachea in about half of "
        "all infants.\nIs the tip in the middle third between cords and carina? The head's position moves "
        "it: flexion down, extension\nup."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.2 kg whose throat is full of fluid: the cords lie below it. Suction first, "
        "under sight and\nshortly, then change outside the mouth. At least 50 % of the glottis, blade out "
        "within 30 seconds; you may take\nit out and ventilate in between."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "What is not seen cannot be intubated: a tube pushed into fluid finds the oesophagus more often than "
        "the trachea.\nWas the suction ready before the blade went in?"),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A preterm infant of 29 weeks and 1.2 kg, asleep and relaxed: it does not breathe and the cords "
        "stand still. The\nlast breath was yours, and the saturation falls sooner than in a larger child. At "
        "least 50 % of the glottis,\ntube passed, blade out within 30 seconds. Not there in time? Blade out, "
        "ventilate, try again."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Half of such infants were below ninety percent 22 seconds after the last breath. An attempt that is "
        "given up in\ntime is no failure; one that goes on while the numbers fall is. From cords to carina "
        "there are only four\ncentimetres: a centimetre decides between good, too deep and one lung."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "27 weeks, 0.95 kg, premedicated; blade 00 and tube 2.5. Your movements are as large as its mouth: "
        "brace your\nhand. At least 50 % of the glottis, tube passed, blade out within 30 seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Here the depth is a matter of millimetres, and so is the force. Was the tube seen until its mark "
        "had passed? Was\nthe head back in its neutral place before the depth was judged?"),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.4 kg with a small mouth and a large tongue that resists. The way is the same; "
        "the force will\nnot be. Place the tip well before you lift. At least 50 % of the glottis, tube "
        "passed, blade out within 30\nseconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A stiff tongue tempts the hand to press on and to lever. If the force passed its target before "
        "anything was to\nbe seen, the tip was not deep enough in the vallecula, or the lift did not follow "
        "the handle. Calling for help\nis a step of the plan, not its failure."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.2 kg whose larynx lies high and whose epiglottis is long. Ask for pressure on "
        "the larynx,\nextend the head, or move your own eye by two centimetres. At least 50 % of the "
        "glottis, tube passed, blade out\nwithin 30 seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Which help opened the view? Pressure from outside brings the cords down into the line of sight; too "
        "much of it\ncloses them. Helps are asked for aloud, one at a time, and taken back when they do "
        "nothing."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.2 kg, awake and without a relaxant. If the tube touches the cords they may shut "
        "and stay so.\nThen do not push: blade out, wait, give breaths by mask as soon as air goes in, and "
        "come back. At least 50 % of\nthe glottis, each attempt within 30 seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Closed cords are stronger than a tube should be. Whoever waits for them to part with a breath "
        "touches them less;\nwhoever pushes hurts them and gains nothing. The saturation tells of it late, "
        "the heart earlier."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A term newborn of 3.2 kg. While you intubate you will be asked; answer without letting the infant "
        "wait. At least\n50 % of the glottis, tube passed, blade out within 30 seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "Which answer came late, and what did the hands do meanwhile? It is right to say \"after the tube\" "
        "to a question\nthat can wait; it is wrong not to hear it."),
    QT_TRANSLATE_NOOP("Courses",
                      "A preterm infant of 29 weeks and 1.2 kg, premedicated. Alarms are to be silenced, talk is to be "
                      "ignored. At\nleast 50 % of the glottis, tube passed, blade out within 30 seconds."),
    QT_TRANSLATE_NOOP("Courses",
                      "Not every alarm is this infant's. Who was asked to watch the monitor? One who reads the numbers "
                      "aloud is worth\nmore than three who talk."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A newborn of 3.2 kg that does not breathe; the saturation is low, as in every child at that age, "
        "and the\nheart is slow. It needs air more than it needs a tube: breaths by mask until the heart is "
        "above 100, then\nintubate. At least 50 % of the glottis, and this time within 25 seconds."),
    QT_TRANSLATE_NOOP(
        "Courses",
        "A low number at one minute is normal; a heart that does not rise is not. With too little blood "
        "through the lungs\nthe detector stays purple though the tube lies well: look at the chest and the "
        "heart before it is pulled. Thirty\nseconds are a ceiling, not a goal."),
    // Where a module's rule of mastery comes from; citations stay as they are
    QT_TRANSLATE_NOOP("Courses",
                      "80 % success within two attempts (PMC8290971); unacceptable rate 40 % and both risks 10 % "
                      "assumed"),
    QT_TRANSLATE_NOOP("Courses", "assumed: twice running, so that it was no chance"),
    QT_TRANSLATE_NOOP("Courses", "assumed: three infants running"),
    QT_TRANSLATE_NOOP("Courses", "assumed: the curriculum names no rule"),
    // What is asked and said meanwhile, and alarms
    QT_TRANSLATE_NOOP("Courses",
                      "The nurse asks how long it has been. It is 14:40; the first breath was given at 14:32."),
    QT_TRANSLATE_NOOP("Courses", "6 minutes"),
    QT_TRANSLATE_NOOP("Courses", "8 minutes"),
    QT_TRANSLATE_NOOP("Courses", "12 minutes"),
    QT_TRANSLATE_NOOP("Courses", "Which tube shall I have ready as the next smaller one?"),
    QT_TRANSLATE_NOOP("Courses", "The count of breaths stands at 17, and nine more were given. What do I write down?"),
    QT_TRANSLATE_NOOP("Courses", "\"Bed four is free now, who takes the transport?\""),
    QT_TRANSLATE_NOOP("Courses", "Infusion pump: end of syringe"),
    QT_TRANSLATE_NOOP("Courses", "\"Shall I call the anaesthetist? No? Are you sure?\""),
    QT_TRANSLATE_NOOP("Courses", "Incubator: door open"),
    QT_TRANSLATE_NOOP("Courses", "\"The parents are outside and ask what is going on.\""),
    QT_TRANSLATE_NOOP("Courses", "\"One minute.\""),
    QT_TRANSLATE_NOOP("Courses", "Radiant warmer: skin probe off"),
    QT_TRANSLATE_NOOP("Courses", "The mother's obstetrician asks for the weight you estimate."),
    QT_TRANSLATE_NOOP("Courses", "1.2 kg"),
    QT_TRANSLATE_NOOP("Courses", "2.2 kg"),
    QT_TRANSLATE_NOOP("Courses", "3.2 kg"),
    QT_TRANSLATE_NOOP("Courses", "\"Two minutes. Does anybody have the heart rate?\""),
};

}  // namespace

Sentences shipped_courses() { return {std::begin(kTexts), std::end(kTexts)}; }

}  // namespace vallecula::gui::from_below
