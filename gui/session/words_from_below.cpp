#include "gui/session/words_from_below.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

namespace vallecula::gui {
namespace {

// Listed for lupdate, and read by no one else than sentences_from_below(): whoever changes one below changes it here.
constexpr const char* kSentences[] = {
    // Devices: what is found, what is wrong and what to do
    QT_TRANSLATE_NOOP("FromBelow", "name"),
    QT_TRANSLATE_NOOP("FromBelow", "model"),
    QT_TRANSLATE_NOOP("FromBelow", "driver"),
    QT_TRANSLATE_NOOP("FromBelow", "rate"),
    QT_TRANSLATE_NOOP("FromBelow", "workspace"),
    QT_TRANSLATE_NOOP("FromBelow", "force"),
    QT_TRANSLATE_NOOP("FromBelow", "calibration"),
    QT_TRANSLATE_NOOP("FromBelow", "not known"),
    QT_TRANSLATE_NOOP("FromBelow", "none: shown as a bar"),
    QT_TRANSLATE_NOOP("FromBelow", "good"),
    QT_TRANSLATE_NOOP("FromBelow", "built in"),
    QT_TRANSLATE_NOOP("FromBelow", "to be done anew"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "move its handle once through the whole workspace before a trial; no force is shown until then"),
    QT_TRANSLATE_NOOP("FromBelow", "to be done by hand"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "a stylus goes into its ink well, a Falcon's grip is pulled all the way out and pushed in, "
                      "before a trial; no force is shown until then"),
    QT_TRANSLATE_NOOP("FromBelow", "The device works."),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "The device was pressed against its force limit for too long and switched its force off: ease the hand."),
    QT_TRANSLATE_NOOP("FromBelow", "The device does not answer: check its cable and its power."),
    QT_TRANSLATE_NOOP("FromBelow", "The device is unplugged: plug it in again."),
    QT_TRANSLATE_NOOP("FromBelow", "The device's motors are too warm: let it rest for a minute."),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "A force that is not a number was held back and zero force was sent: please report this trial's log."),
    QT_TRANSLATE_NOOP("FromBelow", "The servo loop is late: close other programs, and set up real-time priority."),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "The device does not know where it stands: put its pen into the ink well, or move it once to its ends."),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The device's driver reports an error: unplug it, wait five seconds, plug it in again."),
    QT_TRANSLATE_NOOP("FromBelow", "The device reports an unknown fault."),
    QT_TRANSLATE_NOOP("FromBelow", "mouse and keyboard"),
    QT_TRANSLATE_NOOP("FromBelow", "mouse and keyboard; the force is drawn, not felt"),
    QT_TRANSLATE_NOOP("FromBelow", "3D Systems Touch, Touch X and other HDAPI devices; NAME as their set-up calls it"),
    QT_TRANSLATE_NOOP("FromBelow", "a Novint Falcon: position and force; its grip does not turn the blade"),
    QT_TRANSLATE_NOOP("FromBelow", "a SpaceMouse: the cap steers by speed; the force is drawn, not felt"),
    QT_TRANSLATE_NOOP("FromBelow", "none plugged in"),
    QT_TRANSLATE_NOOP("FromBelow", "if there is one, check its cable and power"),
    QT_TRANSLATE_NOOP("FromBelow", "it opens but gives no reading: another program may be using it"),
    QT_TRANSLATE_NOOP("FromBelow", "close the other program; else check the cable and the power"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "no firmware file was found: it works only while it still runs the firmware another program gave it"),
    // Figures: label and definition (curricula/score/figures)
    QT_TRANSLATE_NOOP("FromBelow", "Passed"),
    QT_TRANSLATE_NOOP("FromBelow", "every limit of the scenario was kept"),
    QT_TRANSLATE_NOOP("FromBelow", "Attempt time"),
    QT_TRANSLATE_NOOP("FromBelow", "blade into the mouth to blade out, less pauses; of several the longest"),
    QT_TRANSLATE_NOOP("FromBelow", "Time to first sight"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "from the attempt's start to the first sight of as much of the glottis as the scenario asks for"),
    QT_TRANSLATE_NOOP("FromBelow", "Best view of the glottis"),
    QT_TRANSLATE_NOOP("FromBelow", "largest share of the glottis in sight (POGO)"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak tongue force"),
    QT_TRANSLATE_NOOP("FromBelow", "largest single tick of the model force on the tongue"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak gum force"),
    QT_TRANSLATE_NOOP("FromBelow", "largest single tick of the model force on the gums"),
    QT_TRANSLATE_NOOP("FromBelow", "Time over the target force"),
    QT_TRANSLATE_NOOP("FromBelow", "time with more model force on the tongue than the scenario's target"),
    QT_TRANSLATE_NOOP("FromBelow", "Time over the device limit"),
    QT_TRANSLATE_NOOP("FromBelow", "time in which the device was at its limit, or had let go because of it"),
    QT_TRANSLATE_NOOP("FromBelow", "Attempts"),
    QT_TRANSLATE_NOOP("FromBelow", "ways of the blade into the mouth and out"),
    QT_TRANSLATE_NOOP("FromBelow", "Time to pass the tube"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "from the view (else the attempt's start) to the tip past the cords, in the decisive attempt"),
    QT_TRANSLATE_NOOP("FromBelow", "Lowest saturation"),
    QT_TRANSLATE_NOOP("FromBelow", "displayed, from the first attempt on"),
    QT_TRANSLATE_NOOP("FromBelow", "Lowest heart rate"),
    QT_TRANSLATE_NOOP("FromBelow", "from the first attempt on"),
    QT_TRANSLATE_NOOP("FromBelow", "Severe desaturation"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "in any attempt the displayed saturation fell by 20 points or more from the highest before it"),
    QT_TRANSLATE_NOOP("FromBelow", "Bradycardia"),
    QT_TRANSLATE_NOOP("FromBelow", "in any attempt the heart was below 100 per minute"),
    QT_TRANSLATE_NOOP("FromBelow", "Tube's depth error"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "of the tip in larynx or trachea at the end, from the middle of the good third of this infant's "
                      "way from the cords to the carina; positive: too deep"),
    QT_TRANSLATE_NOOP("FromBelow", "Mean tongue force"),
    QT_TRANSLATE_NOOP("FromBelow", "mean of the model force on the tongue over the time in which there was any"),
    QT_TRANSLATE_NOOP("FromBelow", "Tongue force over time"),
    QT_TRANSLATE_NOOP("FromBelow", "integral of the model force on the tongue over the trial"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak tongue pressure"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "largest mean pressure over the contact with the tongue in a tick with 0.5 N or more on it: "
                      "force by the area of the tissue's surface at rest that the contacts stand for"),
    QT_TRANSLATE_NOOP("FromBelow", "Lifted, not levered"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "share of the load of tongue and epiglottis, along the handle, that the upper jaw did not bear as a fulcrum"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak levered load"),
    QT_TRANSLATE_NOOP("FromBelow", "largest part of that load that the upper jaw bore in a tick"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak palate force"),
    QT_TRANSLATE_NOOP("FromBelow", "largest single tick of the model force on the palate"),
    QT_TRANSLATE_NOOP("FromBelow", "Time to stable view"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "from the attempt's start to the begin of the first 2 s in one piece with as much of the glottis "
                      "in sight as the scenario asks for; 2 s are assumed"),
    QT_TRANSLATE_NOOP("FromBelow", "Mean view of the glottis"),
    QT_TRANSLATE_NOOP(
        "FromBelow", "mean share of the glottis in sight (POGO), over the time in the attempts in which there was any"),
    QT_TRANSLATE_NOOP("FromBelow", "Cormack-Lehane grade"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "1: more than half of the glottis seen at best, 2: less of it; 3 and 4 are none, for no log "
                      "knows whether the epiglottis was in sight"),
    QT_TRANSLATE_NOOP("FromBelow", "Blade's entry left of the midline"),
    QT_TRANSLATE_NOOP("FromBelow", "of the tip as it first enters the mouth; negative: to the patient's right"),
    QT_TRANSLATE_NOOP("FromBelow", "Blade's tip from the midline"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "distance of the tip from the plane through gum midlines and vallecula when it is nearest to the vallecula"),
    QT_TRANSLATE_NOOP("FromBelow", "Blade's tip to the vallecula"),
    QT_TRANSLATE_NOOP("FromBelow", "least distance of the tip from the vallecula's landmark at rest"),
    QT_TRANSLATE_NOOP("FromBelow", "Vallecula reached"),
    QT_TRANSLATE_NOOP("FromBelow", "the tip came within 15 % of the way from gums to vallecula of it; assumed"),
    QT_TRANSLATE_NOOP("FromBelow", "Blade's tip past the vallecula"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "farthest of the tip beyond the vallecula at rest, along the way from the gums to it"),
    QT_TRANSLATE_NOOP("FromBelow", "Entries of the blade"),
    QT_TRANSLATE_NOOP("FromBelow", "times the tip came into the mouth after a second or more outside"),
    QT_TRANSLATE_NOOP("FromBelow", "Way of the blade's tip"),
    QT_TRANSLATE_NOOP("FromBelow", "length of the tip's way in the attempts, from means of 20 ms"),
    QT_TRANSLATE_NOOP("FromBelow", "Smoothness of the hand"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "spectral arc length of the tip's speed in an attempt's longest stretch without a pause (10 Hz, "
                      "threshold 5 %, padding 4, sampled at 50 Hz)"),
    QT_TRANSLATE_NOOP("FromBelow", "Tremor of the hand"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "root mean square of the tip's way from 4 to 12 Hz over the same stretch, three axes together"),
    QT_TRANSLATE_NOOP("FromBelow", "Mean reaction time"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "from a question or alarm shown to its answer within the time allowed, right or wrong, less pauses"),
    QT_TRANSLATE_NOOP("FromBelow", "Errors in the dual task"),
    QT_TRANSLATE_NOOP("FromBelow", "wrong answers, and answers to nothing"),
    QT_TRANSLATE_NOOP("FromBelow", "Missed in the dual task"),
    QT_TRANSLATE_NOOP("FromBelow", "questions and alarms without an answer in the time allowed"),
    // The checklist (curricula/score/checklist)
    QT_TRANSLATE_NOOP("FromBelow", "Blade in at the right corner of the mouth or over the middle"),
    QT_TRANSLATE_NOOP("FromBelow", "The blade was never in the mouth, or its midline is unknown"),
    QT_TRANSLATE_NOOP("FromBelow", "Tip in the vallecula"),
    QT_TRANSLATE_NOOP("FromBelow", "The blade was never in the mouth"),
    QT_TRANSLATE_NOOP("FromBelow", "Lifted, not levered on the upper jaw"),
    QT_TRANSLATE_NOOP("FromBelow", "Too little was lifted to tell"),
    QT_TRANSLATE_NOOP("FromBelow", "Glottis in sight before the tube passed"),
    QT_TRANSLATE_NOOP("FromBelow", "No tube passed the cords in an attempt"),
    QT_TRANSLATE_NOOP("FromBelow", "Tube seen as it passed between the cords"),
    QT_TRANSLATE_NOOP("FromBelow", "Stylet out before the first breath through the tube"),
    QT_TRANSLATE_NOOP("FromBelow", "No breath was given through a tube past the cords"),
    QT_TRANSLATE_NOOP("FromBelow", "Secretions cleared by suction"),
    QT_TRANSLATE_NOOP("FromBelow", "Ventilated between attempts"),
    QT_TRANSLATE_NOOP("FromBelow", "Breaths before each further attempt"),
    QT_TRANSLATE_NOOP("FromBelow", "Place confirmed by the CO2 detector"),
    QT_TRANSLATE_NOOP("FromBelow", "Tip at a good depth"),
    QT_TRANSLATE_NOOP("FromBelow", "Tube in the oesophagus recognised in time"),
    QT_TRANSLATE_NOOP("FromBelow", "not seen"),
    QT_TRANSLATE_NOOP("FromBelow", "No log can tell"),
    QT_TRANSLATE_NOOP("FromBelow", "Tube, blade, light and suction checked before"),
    QT_TRANSLATE_NOOP("FromBelow", "Handle in the left hand"),
    QT_TRANSLATE_NOOP("FromBelow", "Told the team what was seen and done"),
    // Reports and result page: figures as they are named there, and what is said of them
    QT_TRANSLATE_NOOP("FromBelow", "Glottis seen, at best"),
    QT_TRANSLATE_NOOP("FromBelow", "at least"),
    QT_TRANSLATE_NOOP("FromBelow", "never"),
    QT_TRANSLATE_NOOP("FromBelow", "Longest attempt, blade in to blade out"),
    QT_TRANSLATE_NOOP("FromBelow", "Attempt time, blade in to blade out"),
    QT_TRANSLATE_NOOP("FromBelow", "at most"),
    QT_TRANSLATE_NOOP("FromBelow", "no attempt"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the tongue"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the gums"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the epiglottis"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the palate"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the larynx"),
    QT_TRANSLATE_NOOP("FromBelow", "Paused, which counts for nothing"),
    QT_TRANSLATE_NOOP("FromBelow", "report.html: the monitor's chart could not be encoded"),
    QT_TRANSLATE_NOOP("FromBelow", "Figure"),
    QT_TRANSLATE_NOOP("FromBelow", "Measured"),
    QT_TRANSLATE_NOOP("FromBelow", "Demanded"),
    QT_TRANSLATE_NOOP("FromBelow", "R"(
                                       body {
font:
  16px / 1.5 "DejaVu Sans", "Segoe UI", sans - serif;
color:
# 222;
  max - width : 62rem;
margin:
  2rem auto;
padding:
  0 1rem;
                                       } h1 {
                                         font - size : 1.6rem;
                                         margin - bottom : 0;
                                       } h2 {
                                         font - size : 1.15rem;
                                         margin - top : 2rem;
                                       }
                                           .sub {
color:
# 555;
  margin - top : .2rem;
                                           }
                                           .summary {
                                             border - left : .5rem solid;
                                           padding:
                                             .6rem 1rem;
                                             font - size : 1.1rem;
                                           background:
#f6f4ec;
                                           }
                                           .passed { border - color : #009E73; }
                                           .failed { border - color : #D55E00; } table {
                                             border - collapse : collapse;
                                           width:
                                             100 % ;
                                           } th,
                                       td {
                                         text - align : left;
                                       padding:
                                         .35rem .6rem;
                                         border - bottom : 1px solid #ddd;
                                       } td.figure { font - weight : bold; } td
                                           .met {
color:
# 00795a;
                                           } td
                                           .missed {
color:
#b34f00;
  font - weight : bold;
                                           } img {
                                             max - width : 100 % ;
                                           height:
                                             auto;
                                           }
                                           .shots {
display:
  flex;
  flex - wrap : wrap;
gap:
  1rem;
                                           }
                                           .shots figure {
margin:
  0;
flex:
  1 1 26rem;
                                           } figcaption,
                                       .foot {
color:
# 555;
  font - size : .85rem;
                                       }) ""),
    QT_TRANSLATE_NOOP("FromBelow", "reason not recorded"),
    QT_TRANSLATE_NOOP("FromBelow", "the blade never entered the mouth."),
    QT_TRANSLATE_NOOP("FromBelow", "Not passed"),
    QT_TRANSLATE_NOOP("FromBelow", "passed"),
    QT_TRANSLATE_NOOP("FromBelow", "Why it was passed"),
    QT_TRANSLATE_NOOP("FromBelow", "Why it was not passed"),
    QT_TRANSLATE_NOOP("FromBelow", "Figures"),
    QT_TRANSLATE_NOOP("FromBelow", "The monitor"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "Saturation, heart rate and glottis in sight over time, with attempts, breaths and the tube's passing marked"),
    QT_TRANSLATE_NOOP("FromBelow", "Force over time"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "Force on tongue and gum over time, with limit, target, peak and first sight marked"),
    QT_TRANSLATE_NOOP("FromBelow", "Debriefing"),
    QT_TRANSLATE_NOOP("FromBelow", "Pictures"),
    QT_TRANSLATE_NOOP("FromBelow", "How it was recorded"),
    QT_TRANSLATE_NOOP("FromBelow", "Device"),
    QT_TRANSLATE_NOOP("FromBelow", "Servo loop"),
    QT_TRANSLATE_NOOP("FromBelow", "Real-time set-up"),
    QT_TRANSLATE_NOOP("FromBelow", "How it ended"),
    QT_TRANSLATE_NOOP("FromBelow", "Patient package"),
    QT_TRANSLATE_NOOP("FromBelow", "Scenario"),
    QT_TRANSLATE_NOOP("FromBelow", "Tool"),
    QT_TRANSLATE_NOOP("FromBelow", "report.html"),
    QT_TRANSLATE_NOOP("FromBelow", "Cormack-Lehane grade at best"),
    QT_TRANSLATE_NOOP("FromBelow", "3 or 4: nothing of the glottis seen"),
    QT_TRANSLATE_NOOP("FromBelow", "Glottis seen on average, while in sight"),
    QT_TRANSLATE_NOOP("FromBelow", "Force on the tongue, mean and over time"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak pressure on the tongue, over the contact"),
    QT_TRANSLATE_NOOP("FromBelow", "Blade in, from the midline"),
    QT_TRANSLATE_NOOP("FromBelow", "Blade's tip, nearest to the vallecula"),
    QT_TRANSLATE_NOOP("FromBelow", "Blade's tip then, from the midline"),
    QT_TRANSLATE_NOOP("FromBelow", "Blade's tip beyond the vallecula"),
    QT_TRANSLATE_NOOP("FromBelow", "Questions and alarms"),
    QT_TRANSLATE_NOOP("FromBelow", "missed"),
    QT_TRANSLATE_NOOP("FromBelow", "answered to nothing"),
    QT_TRANSLATE_NOOP("FromBelow", "Reaction to them, on average"),
    QT_TRANSLATE_NOOP("FromBelow", "Tube's depth, from the middle of the good third"),
    QT_TRANSLATE_NOOP("FromBelow", "Checklist"),
    QT_TRANSLATE_NOOP("FromBelow", "Item"),
    QT_TRANSLATE_NOOP("FromBelow", "Done"),
    QT_TRANSLATE_NOOP("FromBelow", "Why"),
    QT_TRANSLATE_NOOP("FromBelow", "met"),
    QT_TRANSLATE_NOOP("FromBelow", "What the log has not seen is left to the instructor. The items are not validated."),
    QT_TRANSLATE_NOOP("FromBelow", "Global rating, by a person:"),
    QT_TRANSLATE_NOOP("FromBelow", "Points"),
    QT_TRANSLATE_NOOP("FromBelow", "Limit by"),
    QT_TRANSLATE_NOOP("FromBelow", "Points inform; what fails a trial is the mark, whatever its weight."),
    QT_TRANSLATE_NOOP("FromBelow", "not in larynx or trachea"),
    QT_TRANSLATE_NOOP("FromBelow", "nothing touched"),
    QT_TRANSLATE_NOOP("FromBelow", "Outcome"),
    QT_TRANSLATE_NOOP("FromBelow", "The blade never entered the mouth."),
    QT_TRANSLATE_NOOP("FromBelow", "attempt"),
    QT_TRANSLATE_NOOP("FromBelow", "Tip's depth"),
    QT_TRANSLATE_NOOP("FromBelow", "Time to view, blade in to glottis in sight"),
    QT_TRANSLATE_NOOP("FromBelow", "Time to pass, view to cords passed"),
    QT_TRANSLATE_NOOP("FromBelow", "passed before the blade was in"),
    QT_TRANSLATE_NOOP("FromBelow", "Lowest saturation, displayed"),
    QT_TRANSLATE_NOOP("FromBelow", "CO2 detector"),
    QT_TRANSLATE_NOOP("FromBelow", "yellow, with breath"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force along the tube"),
    QT_TRANSLATE_NOOP("FromBelow", "Tube's peak load by part"),
    QT_TRANSLATE_NOOP("FromBelow", "Breaths given, mask and tube"),
    QT_TRANSLATE_NOOP("FromBelow", "Tip in the oesophagus"),
    QT_TRANSLATE_NOOP("FromBelow", "Secretions"),
    QT_TRANSLATE_NOOP("FromBelow", "From, to (s)"),
    QT_TRANSLATE_NOOP("FromBelow", "Took"),
    QT_TRANSLATE_NOOP("FromBelow", "Breaths before"),
    QT_TRANSLATE_NOOP("FromBelow", "To view"),
    QT_TRANSLATE_NOOP("FromBelow", "To pass"),
    QT_TRANSLATE_NOOP("FromBelow", "Saturation, before and lowest"),
    QT_TRANSLATE_NOOP("FromBelow", "Lowest heart"),
    QT_TRANSLATE_NOOP("FromBelow", "severe desaturation"),
    QT_TRANSLATE_NOOP("FromBelow", "bradycardia"),
    QT_TRANSLATE_NOOP("FromBelow", "Mark"),
    QT_TRANSLATE_NOOP("FromBelow", "Where the mark comes from"),
    QT_TRANSLATE_NOOP("FromBelow", "This trial was cut off: what stands here is what was recorded until then."),
    QT_TRANSLATE_NOOP("FromBelow", "Over time"),
    QT_TRANSLATE_NOOP("FromBelow", "Ticks"),
    QT_TRANSLATE_NOOP("FromBelow", "Trials of nobody"),
    QT_TRANSLATE_NOOP("FromBelow", "not yet"),
    QT_TRANSLATE_NOOP("FromBelow", "cut off"),
    QT_TRANSLATE_NOOP("FromBelow", "not passed"),
    QT_TRANSLATE_NOOP("FromBelow", "By scenario and device"),
    QT_TRANSLATE_NOOP("FromBelow", "Curriculum"),
    QT_TRANSLATE_NOOP("FromBelow", "Trials"),
    QT_TRANSLATE_NOOP("FromBelow", "Cut off"),
    QT_TRANSLATE_NOOP("FromBelow", "CUSUM says competent"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "Passed: every mark met, within the attempts of the rule, which each curve names (two by the "
                      "published one). Figures of different kinds of device are never put together."),
    QT_TRANSLATE_NOOP("FromBelow", "Learning curves"),
    QT_TRANSLATE_NOOP("FromBelow", "All trials"),
    QT_TRANSLATE_NOOP("FromBelow", "Finished (UTC)"),
    QT_TRANSLATE_NOOP("FromBelow", "Mode"),
    QT_TRANSLATE_NOOP("FromBelow", "Result"),
    QT_TRANSLATE_NOOP("FromBelow", "Tube"),
    QT_TRANSLATE_NOOP("FromBelow", "Attempt (s)"),
    QT_TRANSLATE_NOOP("FromBelow", "Tongue (N)"),
    QT_TRANSLATE_NOOP("FromBelow", "Tip past the cords"),
    QT_TRANSLATE_NOOP("FromBelow", "Lowest SpO2"),
    QT_TRANSLATE_NOOP("FromBelow", "Time to view"),
    QT_TRANSLATE_NOOP("FromBelow", "Time to pass"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force, tube"),
    QT_TRANSLATE_NOOP("FromBelow", "In the oesophagus"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force, tongue"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force, gum"),
    QT_TRANSLATE_NOOP("FromBelow", "Glottis visible, best"),
    QT_TRANSLATE_NOOP("FromBelow", "Time to sight"),
    QT_TRANSLATE_NOOP("FromBelow", "Longest attempt"),
    QT_TRANSLATE_NOOP("FromBelow", "Attempt"),
    QT_TRANSLATE_NOOP("FromBelow", "Over the target"),
    QT_TRANSLATE_NOOP("FromBelow", "Over the device limit"),
    QT_TRANSLATE_NOOP("FromBelow", "Paused"),
    QT_TRANSLATE_NOOP("FromBelow", "Loop"),
    QT_TRANSLATE_NOOP("FromBelow", "not there"),
    QT_TRANSLATE_NOOP("FromBelow", "yellow"),
    QT_TRANSLATE_NOOP("FromBelow", "never yellow"),
    QT_TRANSLATE_NOOP("FromBelow", "recognised late"),
    QT_TRANSLATE_NOOP("FromBelow", "no real time"),
    QT_TRANSLATE_NOOP("FromBelow", "with breath"),
    QT_TRANSLATE_NOOP("FromBelow", "at most %1 N"),
    QT_TRANSLATE_NOOP("FromBelow", "at most %1 s"),
    QT_TRANSLATE_NOOP("FromBelow", "at most %1"),
    QT_TRANSLATE_NOOP("FromBelow", "at least %1 %"),
    QT_TRANSLATE_NOOP("FromBelow", "at least %1"),
    QT_TRANSLATE_NOOP("FromBelow", "at least %1 1/min"),
    QT_TRANSLATE_NOOP("FromBelow", "at least %1 /min"),
    QT_TRANSLATE_NOOP("FromBelow", "with breath %1"),
    QT_TRANSLATE_NOOP("FromBelow", "yellow, with breath %1"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 mm"),
    QT_TRANSLATE_NOOP("FromBelow", "from %1 %"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 late, %2 steps dropped"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 breaths"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 % of the way; good: %2 to %3 %"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 N, at %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 %, at %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 per minute, at %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 per minute"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 of %2"),
    QT_TRANSLATE_NOOP("FromBelow", "1 trial"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 trials"),
    QT_TRANSLATE_NOOP("FromBelow", "Trainee %1"),
    QT_TRANSLATE_NOOP("FromBelow", "at trial %1"),
    QT_TRANSLATE_NOOP("FromBelow", "limit %1 N"),
    QT_TRANSLATE_NOOP("FromBelow", "%1, %2 deadline misses, %3 simulation steps dropped"),
    QT_TRANSLATE_NOOP("FromBelow", "Points: %1 of %2"),
    QT_TRANSLATE_NOOP("FromBelow", "Time to glottis in sight (%1 %)"),
    QT_TRANSLATE_NOOP("FromBelow", "Time over the training target (tongue, %1 N)"),
    QT_TRANSLATE_NOOP("FromBelow", "Time over the device limit (%1 N)"),
    QT_TRANSLATE_NOOP("FromBelow", "Time to a stable view (%1 s in one piece)"),
    QT_TRANSLATE_NOOP("FromBelow", "the glottis came into sight after %1 s (%2 % at best)"),
    QT_TRANSLATE_NOOP("FromBelow", "the glottis never came into sight (%1 % at best)"),
    QT_TRANSLATE_NOOP("FromBelow", "with at most %1 N on the tongue and %2 N on the gums"),
    QT_TRANSLATE_NOOP("FromBelow", "in an attempt of %1 s."),
    QT_TRANSLATE_NOOP("FromBelow", "with at most %1 N on the tongue and %2 N along the tube."),
    QT_TRANSLATE_NOOP("FromBelow", "%1 attempt of %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 attempts, the longest of %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "saturation down to %1 %, heart to %2 per minute"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "An attempt is one way of the blade into the mouth and out. Its lowest values count until the "
                      "next one begins, for the display is late. Severe desaturation: %1 points or more. Bradycardia: "
                      "below %2 per minute (both NEAR4NEOS)."),
    QT_TRANSLATE_NOOP("FromBelow", "%1 mm to the left"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 mm to the right"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 % lifted"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 % lifted, at most %2 N levered, at %3 s"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 mm, at %2 s: reached"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 mm, at %2 s: not reached"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 kPa, at %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 s, at %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 N, %2 N s in %3 s"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 mm deeper"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 mm shallower"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 right, %2 wrong, %3 missed"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 Hz over %2 ticks, %3 deadline misses, %4 simulation steps dropped"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 ticks of %2 ms, not in real time"),
    QT_TRANSLATE_NOOP("FromBelow", "finished"),
    QT_TRANSLATE_NOOP("FromBelow", "the scenario's time was over"),
    QT_TRANSLATE_NOOP("FromBelow", "the device did not come back"),
    QT_TRANSLATE_NOOP("FromBelow", "interrupted"),
    QT_TRANSLATE_NOOP("FromBelow", "reset"),
    // Words of scores, modes, outcomes and progress
    QT_TRANSLATE_NOOP("FromBelow", "practice"),
    QT_TRANSLATE_NOOP("FromBelow", "assessment"),
    QT_TRANSLATE_NOOP("FromBelow", "competent"),
    QT_TRANSLATE_NOOP("FromBelow", "not competent"),
    QT_TRANSLATE_NOOP("FromBelow", "undecided"),
    QT_TRANSLATE_NOOP("FromBelow", "yes"),
    QT_TRANSLATE_NOOP("FromBelow", "no"),
    QT_TRANSLATE_NOOP("FromBelow", "unsafe"),
    QT_TRANSLATE_NOOP("FromBelow", "with help at every step"),
    QT_TRANSLATE_NOOP("FromBelow", "with help at some steps"),
    QT_TRANSLATE_NOOP("FromBelow", "alone, with flaws"),
    QT_TRANSLATE_NOOP("FromBelow", "alone and well"),
    QT_TRANSLATE_NOOP("FromBelow", "good depth"),
    QT_TRANSLATE_NOOP("FromBelow", "too shallow"),
    QT_TRANSLATE_NOOP("FromBelow", "too deep"),
    QT_TRANSLATE_NOOP("FromBelow", "oesophagus"),
    QT_TRANSLATE_NOOP("FromBelow", "mainstem"),
    QT_TRANSLATE_NOOP("FromBelow", "cricoid too narrow"),
    QT_TRANSLATE_NOOP("FromBelow", "cords closed"),
    QT_TRANSLATE_NOOP("FromBelow", "out of time"),
    QT_TRANSLATE_NOOP("FromBelow", "abandoned"),
    QT_TRANSLATE_NOOP("FromBelow", "none"),
    // What the instructors did (curricula/records/audit)
    QT_TRANSLATE_NOOP("FromBelow", "person deleted"),
    QT_TRANSLATE_NOOP("FromBelow", "data exported"),
    QT_TRANSLATE_NOOP("FromBelow", "note removed"),
    QT_TRANSLATE_NOOP("FromBelow", "PIN changed"),
    QT_TRANSLATE_NOOP("FromBelow", "PIN reset"),
    QT_TRANSLATE_NOOP("FromBelow", "renamed"),
    QT_TRANSLATE_NOOP("FromBelow", "trial rated"),
    QT_TRANSLATE_NOOP("FromBelow", "registered"),
    QT_TRANSLATE_NOOP("FromBelow", "signed in"),
    QT_TRANSLATE_NOOP("FromBelow", "wrong PIN"),
    // What happened in a trial (gui/session/replay_events, fault_report, replay_film, replay_trial)
    QT_TRANSLATE_NOOP("FromBelow", "at the device's limit"),
    QT_TRANSLATE_NOOP("FromBelow", "tube's tip past the cords"),
    QT_TRANSLATE_NOOP("FromBelow", "tube's tip in the oesophagus"),
    QT_TRANSLATE_NOOP("FromBelow", "CO2 detector yellow"),
    QT_TRANSLATE_NOOP("FromBelow", "heart below 100 a minute"),
    QT_TRANSLATE_NOOP("FromBelow", "a breath given"),
    QT_TRANSLATE_NOOP("FromBelow", " answered rightly"),
    QT_TRANSLATE_NOOP("FromBelow", " answered wrongly"),
    QT_TRANSLATE_NOOP("FromBelow", "glottis in sight"),
    QT_TRANSLATE_NOOP("FromBelow", "the device sent a pose that is no position and rotation; no force was shown"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "the tissue's motion was no longer finite; it was put back to rest and no force was shown"),
    QT_TRANSLATE_NOOP("FromBelow", "a force was not finite; none was shown"),
    QT_TRANSLATE_NOOP("FromBelow", "The recorded hand was paused here; it goes on by itself."),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The device is back. To go on press Enter or a button of the device, or hold the grey blade on "
                      "the steel one for half a second."),
    QT_TRANSLATE_NOOP("FromBelow", "stopped before its end"),
    QT_TRANSLATE_NOOP(
        "FromBelow", "This trial was an assessment: it is not replayed, so that nobody practises on what is assessed."),
    QT_TRANSLATE_NOOP("FromBelow", "Reading the trial"),
    QT_TRANSLATE_NOOP("FromBelow", "Looking for the patient"),
    QT_TRANSLATE_NOOP("FromBelow", "Scoring"),
    QT_TRANSLATE_NOOP("FromBelow", "Building the scene"),
    QT_TRANSLATE_NOOP("FromBelow", "Light and colour"),
    QT_TRANSLATE_NOOP("FromBelow", "Ready"),
    QT_TRANSLATE_NOOP("FromBelow", "tongue force over its training target of %1 N"),
    QT_TRANSLATE_NOOP("FromBelow", "attempt begins: blade into the mouth"),
    QT_TRANSLATE_NOOP("FromBelow", "attempt ends: blade out"),
    QT_TRANSLATE_NOOP("FromBelow", "attempt %1 begins: blade into the mouth"),
    QT_TRANSLATE_NOOP("FromBelow", "attempt %1 ends: blade out"),
    QT_TRANSLATE_NOOP("FromBelow", "peak force along the tube, %1 N"),
    QT_TRANSLATE_NOOP("FromBelow", "peak force on the tongue, %1 N"),
    QT_TRANSLATE_NOOP("FromBelow", "peak force on the gum, %1 N"),
    QT_TRANSLATE_NOOP("FromBelow", "question begins"),
    QT_TRANSLATE_NOOP("FromBelow", "alarm begins"),
    QT_TRANSLATE_NOOP("FromBelow", "talk begins"),
    QT_TRANSLATE_NOOP("FromBelow", "question silenced"),
    QT_TRANSLATE_NOOP("FromBelow", "alarm silenced"),
    QT_TRANSLATE_NOOP("FromBelow", "question answered rightly"),
    QT_TRANSLATE_NOOP("FromBelow", "question answered wrongly"),
    QT_TRANSLATE_NOOP("FromBelow", "question missed"),
    QT_TRANSLATE_NOOP("FromBelow", "alarm missed"),
    QT_TRANSLATE_NOOP("FromBelow", "from %1 s on the tissue's shape may be a little different from what it was"),
    // Anatomy, slices, tissues and how a structure was found (pipeline)
    QT_TRANSLATE_NOOP("FromBelow", "skin"),
    QT_TRANSLATE_NOOP("FromBelow", "skull"),
    QT_TRANSLATE_NOOP("FromBelow", "mandible"),
    QT_TRANSLATE_NOOP("FromBelow", "tongue"),
    QT_TRANSLATE_NOOP("FromBelow", "epiglottis"),
    QT_TRANSLATE_NOOP("FromBelow", "airway"),
    QT_TRANSLATE_NOOP("FromBelow", "larynx"),
    QT_TRANSLATE_NOOP("FromBelow", "soft palate"),
    QT_TRANSLATE_NOOP("FromBelow", "spine"),
    QT_TRANSLATE_NOOP("FromBelow", "measured"),
    QT_TRANSLATE_NOOP("FromBelow", "inferred"),
    QT_TRANSLATE_NOOP("FromBelow", "given"),
    QT_TRANSLATE_NOOP("FromBelow", "template"),
    QT_TRANSLATE_NOOP("FromBelow", "Axial"),
    QT_TRANSLATE_NOOP("FromBelow", "Coronal"),
    QT_TRANSLATE_NOOP("FromBelow", "Sagittal"),
    QT_TRANSLATE_NOOP("FromBelow", "Soft tissue"),
    QT_TRANSLATE_NOOP("FromBelow", "Bone"),
    QT_TRANSLATE_NOOP("FromBelow", "Airway"),
    QT_TRANSLATE_NOOP("FromBelow", "upper gum midline"),
    QT_TRANSLATE_NOOP("FromBelow", "lower gum midline"),
    QT_TRANSLATE_NOOP("FromBelow", "vallecula"),
    QT_TRANSLATE_NOOP("FromBelow", "glottis centre"),
    QT_TRANSLATE_NOOP("FromBelow", "glottis normal"),
    QT_TRANSLATE_NOOP("FromBelow", "operator eye"),
    QT_TRANSLATE_NOOP("FromBelow", "hyoid"),
    QT_TRANSLATE_NOOP("FromBelow", "carina"),
    QT_TRANSLATE_NOOP("FromBelow", "condyle axis"),
    QT_TRANSLATE_NOOP("FromBelow", "epiglottis tip"),
    // The quality report of an import (pipeline/quality): groups and figures
    QT_TRANSLATE_NOOP("FromBelow", "To be checked first"),
    QT_TRANSLATE_NOOP("FromBelow", "Within limits"),
    QT_TRANSLATE_NOOP("FromBelow", "For information"),
    QT_TRANSLATE_NOOP("FromBelow", "tetrahedra"),
    QT_TRANSLATE_NOOP("FromBelow", "tetrahedra volume"),
    QT_TRANSLATE_NOOP("FromBelow", "volume kept by the tetrahedra"),
    QT_TRANSLATE_NOOP("FromBelow", "smallest dihedral angle"),
    QT_TRANSLATE_NOOP("FromBelow", "tetrahedra below 10 degrees"),
    QT_TRANSLATE_NOOP("FromBelow", "shortest edge"),
    QT_TRANSLATE_NOOP("FromBelow", "tongue inside the jaw's bone"),
    QT_TRANSLATE_NOOP("FromBelow", "tongue inside the tissue around it"),
    QT_TRANSLATE_NOOP("FromBelow", "gap where the tongue is held"),
    QT_TRANSLATE_NOOP("FromBelow", "head size"),
    QT_TRANSLATE_NOOP("FromBelow", "child size"),
    QT_TRANSLATE_NOOP("FromBelow", "adult size"),
    QT_TRANSLATE_NOOP("FromBelow", "position corrected"),
    QT_TRANSLATE_NOOP("FromBelow", "scaled"),
    QT_TRANSLATE_NOOP("FromBelow", "tongue volume"),
    QT_TRANSLATE_NOOP("FromBelow", "epiglottis volume"),
    QT_TRANSLATE_NOOP("FromBelow", "airway volume"),
    QT_TRANSLATE_NOOP("FromBelow", "mandible volume"),
    QT_TRANSLATE_NOOP("FromBelow", "mouth open"),
    QT_TRANSLATE_NOOP("FromBelow", "mouth opened"),
    QT_TRANSLATE_NOOP("FromBelow", "head extended"),
    QT_TRANSLATE_NOOP("FromBelow", "gap between the gums"),
    QT_TRANSLATE_NOOP("FromBelow", "glottis area"),
    QT_TRANSLATE_NOOP("FromBelow", "nodes held by the mandible"),
    QT_TRANSLATE_NOOP("FromBelow", "nodes held by the hyoid"),
    QT_TRANSLATE_NOOP("FromBelow", "nodes held by the larynx"),
    QT_TRANSLATE_NOOP("FromBelow", "epiglottis stiffness"),
    QT_TRANSLATE_NOOP("FromBelow", "check by playing"),
    QT_TRANSLATE_NOOP("FromBelow", "glottis in sight at rest"),
    QT_TRANSLATE_NOOP("FromBelow", "glottis in sight when lifted"),
    QT_TRANSLATE_NOOP("FromBelow", "the deepest node"),
    QT_TRANSLATE_NOOP("FromBelow", "the lips stand apart"),
    QT_TRANSLATE_NOOP("FromBelow", "the lips stand apart after the opening"),
    QT_TRANSLATE_NOOP("FromBelow", "the mouth is closed: good for pressing on the tongue, not for a view"),
    QT_TRANSLATE_NOOP("FromBelow", "hidden by tongue and epiglottis, as it should be"),
    QT_TRANSLATE_NOOP("FromBelow", "expected to be hidden before the lift"),
    // Reasons of a score (curricula/score)
    QT_TRANSLATE_NOOP("FromBelow", "The trial was recorded to its end at %1 s"),
    QT_TRANSLATE_NOOP("FromBelow", "The blade entered the mouth at %1 s"),
    QT_TRANSLATE_NOOP("FromBelow", "The attempt never began: the blade's tip did not enter the mouth"),
    QT_TRANSLATE_NOOP("FromBelow", "The glottis was never in sight; %1 % of it must be seen"),
    QT_TRANSLATE_NOOP("FromBelow", "Glottis seen to %1 % at %2 s, at least the %3 % asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "Glottis seen to %1 % at %2 s, less than the %3 % asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "The attempt took %1 s (%2 s to %3 s), within the %4 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "The attempt took %1 s (%2 s to %3 s), more than the %4 s allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow", "The attempt took %1 s (%2 s to %3 s, the blade was still in the mouth), within the %4 s allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "The attempt took %1 s (%2 s to %3 s, the blade was still in the mouth), more than the %4 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the tongue %1 N at %2 s, within the %3 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the tongue %1 N at %2 s, more than the %3 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the tongue %1 N, within the %2 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the tongue %1 N, more than the %2 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the gums %1 N at %2 s, within the %3 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the gums %1 N at %2 s, more than the %3 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the gums %1 N, within the %2 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Peak force on the gums %1 N, more than the %2 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "Force on the tongue above its target of %1 N for %2 s (first at %3 s), within the %4 s allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "Force on the tongue above its target of %1 N for %2 s (first at %3 s), more than the %4 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Force on the tongue above its target of %1 N for %2 s, within the %3 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Force on the tongue above its target of %1 N for %2 s, more than the %3 s allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "Device at its force limit of %1 N or lost, for %2 s (longest from %3 s), within the %4 s allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "Device at its force limit of %1 N or lost, for %2 s (longest from %3 s), more than the %4 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Device at its force limit of %1 N or lost, for %2 s, within the %3 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Device at its force limit of %1 N or lost, for %2 s, more than the %3 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Saturation fell to %1 % at %2 s, at least the %3 % asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "Saturation fell to %1 % at %2 s, less than the %3 % asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "The heart fell to %1 per minute at %2 s, at least the %3 per minute asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "The heart fell to %1 per minute at %2 s, less than the %3 per minute asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "In no attempt did saturation fall by %1 points or more"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube was never in the oesophagus"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube lies in the oesophagus"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube was stopped by the cricoid and never came past it"),
    QT_TRANSLATE_NOOP("FromBelow", "The cords were closed, and the tube is not past them"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube is not in the trachea: the intubation was given up"),
    QT_TRANSLATE_NOOP("FromBelow", "The trial's time was over before the tube was in the trachea"),
    QT_TRANSLATE_NOOP("FromBelow", "The cords were passed before the blade was in the mouth, so not under sight"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The tube's tip lies %1 mm past the cords, %2 % of the way to the carina: good depth"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "The tube's tip lies %1 mm past the cords, %2 % of the way to the carina: in the trachea, but to be advanced"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The tube's tip lies %1 mm past the cords, %2 % of the way to the carina: in the trachea, but to "
                      "be drawn back"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube's tip lies in the right main bronchus: only one lung gets air"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube's tip lies in the left main bronchus: only one lung gets air"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube's tip lies in a main bronchus: only one lung gets air"),
    QT_TRANSLATE_NOOP("FromBelow", "The detector turned yellow with breath %1, within the %2 breaths allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "The detector turned yellow with breath %1, more than the %2 breaths allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 attempt, within the %2 allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 attempts, within the %2 allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 attempts, more than the %2 allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "The tip came in %1 mm to the left of the midline"),
    QT_TRANSLATE_NOOP("FromBelow", "The tip came in %1 mm to the right of the midline"),
    QT_TRANSLATE_NOOP("FromBelow", "The tip came within %1 mm of it"),
    QT_TRANSLATE_NOOP("FromBelow", "The tip came no nearer to it than %1 mm"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The tip came no nearer to it than %1 mm, but the glottis was seen: lifting the epiglottis "
                      "itself is of equal worth"),
    QT_TRANSLATE_NOOP("FromBelow", "The upper jaw never bore more than %1 N of the load"),
    QT_TRANSLATE_NOOP("FromBelow", "From %1 s on the upper jaw bore more than %2 N of the load, %3 N at most"),
    QT_TRANSLATE_NOOP("FromBelow", "In sight at %1 s, passed at %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "Passed at %1 s without a view before"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 % of the glottis in sight at %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "Passed at %1 s with the blade out"),
    QT_TRANSLATE_NOOP("FromBelow", "The first breath at %1 s"),
    QT_TRANSLATE_NOOP("FromBelow", "Still in at the first breath at %1 s"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 ml at first, %2 ml at the end"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 ml at first, %2 ml at the end, no catheter took them"),
    QT_TRANSLATE_NOOP("FromBelow", "The attempt at %1 s began without a breath before"),
};

}  // namespace

QString in_words(const std::string& text) {
  if (text.empty()) return {};
  const QString as_it_is = QString::fromStdString(text);
  const QString whole = QCoreApplication::translate("FromBelow", text.c_str());
  if (whole != as_it_is) return whole;
  // A figure in a sentence is a place to fill in: "at most 6.80 N" is looked for as "at most %1 N".
  static const QRegularExpression figure("(?<![A-Za-z0-9.])-?\\d+(\\.\\d+)?");
  QString pattern;
  QStringList figures;
  int end = 0;
  for (auto found = figure.globalMatch(as_it_is); found.hasNext();) {
    const QRegularExpressionMatch one = found.next();
    figures << one.captured();
    pattern += as_it_is.mid(end, one.capturedStart() - end) + '%' + QString::number(figures.size());
    end = one.capturedEnd();
  }
  if (figures.isEmpty() || figures.size() > 9) return as_it_is;
  pattern += as_it_is.mid(end);
  QString filled = QCoreApplication::translate("FromBelow", pattern.toUtf8().constData());
  if (filled == pattern) return as_it_is;
  for (int i = figures.size(); i > 0; --i) filled.replace('%' + QString::number(i), figures[i - 1]);
  return filled;
}

std::vector<std::string> sentences_from_below() { return {std::begin(kSentences), std::end(kSentences)}; }

}  // namespace vallecula::gui
