// Reasons of a score as its rubric puts them together (curricula/score), and the names of pauses.
#include <QCoreApplication>

#include "gui/session/from_below/sentences.h"

namespace vallecula::gui::from_below {
namespace {

constexpr const char* kSentences[] = {
    // By what happened in the attempt, and whether the limit was kept
    QT_TRANSLATE_NOOP("FromBelow",
                      "The attempt took %1 s (%2 s to %3 s, the blade went in %4 times), within the %5 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The attempt took %1 s (%2 s to %3 s, the blade went in %4 times), more than the %5 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The attempt took %1 s (%2 s to %3 s, the blade went in %4 times, the blade was still in the "
                      "mouth), within the %5 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The attempt took %1 s (%2 s to %3 s, the blade went in %4 times, the blade was still in the "
                      "mouth), more than the %5 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "The attempt took %1 s (%2 s to %3 s, paused for %4 s), within the %5 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "The attempt took %1 s (%2 s to %3 s, paused for %4 s), more than the %5 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade was still in the mouth), within "
                      "the %5 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade was still in the mouth), more "
                      "than the %5 s allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade went in %5 times), within the %6 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade went in %5 times), more than "
                      "the %6 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade went in %5 times, the blade was "
                      "still in the mouth), within the %6 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The attempt took %1 s (%2 s to %3 s, paused for %4 s, the blade went in %5 times, the blade was "
                      "still in the mouth), more than the %6 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s), within the %6 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s), more than the %6 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, the blade was still in the mouth), "
                      "within the %6 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, the blade was still in the mouth), more "
                      "than the %6 s allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, paused for %6 s), within the %7 s allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, paused for %6 s), more than the %7 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, paused for %6 s, the blade was still in "
                      "the mouth), within the %7 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "Attempt %1 of %2, the longest, took %3 s (%4 s to %5 s, paused for %6 s, the blade was still in "
                      "the mouth), more than the %7 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "The trial was interrupted: its log ends at %1 s"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The attempt cannot be timed: the log lacks usable landmarks of the gums and the vallecula"),
    QT_TRANSLATE_NOOP("FromBelow", "A recorded force is not a number at %1 s: please report this trial's log"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The tube's place was not confirmed: the detector did not turn yellow with %1 breaths through "
                      "it, of %2 breaths allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "With the head neutral the tube's tip lies about %1 mm past the cords, %2 % of the way to the "
                      "carina: in the middle third"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "With the head neutral the tube's tip lies about %1 mm past the cords, %2 % of the way to the "
                      "carina: to be drawn back"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "With the head neutral the tube's tip lies about %1 mm past the cords, %2 % of the way to the "
                      "carina: to be advanced"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The tube in the oesophagus was recognised late: more than %1 breaths in one stay at %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube in the oesophagus was recognised late: more than %1 breaths in one stay"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube in the oesophagus was recognised within %1 breaths in one stay"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "In attempt %1 of %2, begun at %3 s, saturation fell by %4 points or more, from %5 to %6 %"),
    QT_TRANSLATE_NOOP(
        "FromBelow", "In attempt %1 of %2, begun at %3 s, saturation fell by %4 points or more, from %5 to below %6 %"),
    QT_TRANSLATE_NOOP("FromBelow", "Saturation fell to %1 %, at least the %2 % asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "Saturation fell to %1 %, less than the %2 % asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "Saturation fell to below %1 %, less than the %2 % asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "The heart fell to %1 per minute, at least the %2 per minute asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "The heart fell to %1 per minute, less than the %2 per minute asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "Saturation stayed at %1 % or above, at least the %2 % asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "Saturation began at %1 % and fell no further, less than the %2 % asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "Saturation began at below %1 % and fell no further, less than the %2 % asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "The heart stayed at %1 per minute or above, at least the %2 per minute asked for"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The heart began at %1 per minute and fell no further, less than the %2 per minute asked for"),
    QT_TRANSLATE_NOOP("FromBelow", "Yellow with breath %1"),
    QT_TRANSLATE_NOOP("FromBelow", "Not yellow after %1 breaths"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 breaths were given there"),
    QT_TRANSLATE_NOOP("FromBelow", "or"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "The tube was pushed against what stood before its tip with %1 N at %2 s, within the %3 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The tube was pushed against what stood before its tip with %1 N, within the %2 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "From the view to the cords passed it took %1 s at %2 s, within the %3 s allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "From the view to the cords passed it took %1 s at %2 s, with the blade out already, within the %3 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "From the blade in the mouth to the cords passed, without a view, it took %1 s at %2 s, within "
                      "the %3 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "From the blade in the mouth to the cords passed, without a view, it took %1 s at %2 s, with the "
                      "blade out already, within the %3 s allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "The tube was pushed against what stood before its tip with %1 N at %2 s, more than the %3 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The tube was pushed against what stood before its tip with %1 N, more than the %2 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "From the view to the cords passed it took %1 s at %2 s, more than the %3 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "From the view to the cords passed it took %1 s at %2 s, with the blade out already, more than "
                      "the %3 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "From the blade in the mouth to the cords passed, without a view, it took %1 s at %2 s, more "
                      "than the %3 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "From the blade in the mouth to the cords passed, without a view, it took %1 s at %2 s, with the "
                      "blade out already, more than the %3 s allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "force exceeded"),
    QT_TRANSLATE_NOOP("FromBelow", "communication lost"),
    QT_TRANSLATE_NOOP("FromBelow", "unplugged"),
    QT_TRANSLATE_NOOP("FromBelow", "motor warm"),
    QT_TRANSLATE_NOOP("FromBelow", "non finite command"),
    QT_TRANSLATE_NOOP("FromBelow", "servo late"),
    QT_TRANSLATE_NOOP("FromBelow", "not calibrated"),
    QT_TRANSLATE_NOOP("FromBelow", "driver error"),
    QT_TRANSLATE_NOOP("FromBelow", "frozen"),
    QT_TRANSLATE_NOOP("FromBelow", "expert shown"),
    QT_TRANSLATE_NOOP("FromBelow", "list of keys"),
    QT_TRANSLATE_NOOP("FromBelow", "no picture"),
    QT_TRANSLATE_NOOP("FromBelow", "ended by trainee"),
    QT_TRANSLATE_NOOP("FromBelow", "no source given"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube lay in the oesophagus to the end: it was not recognised"),
};

}  // namespace

Sentences reasons() { return {std::begin(kSentences), std::end(kSentences)}; }

}  // namespace vallecula::gui::from_below
