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
