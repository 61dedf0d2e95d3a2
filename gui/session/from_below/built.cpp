// Sentences that are put together of others, or hold a name: their places are filled with words as well as with
// figures.
#include <QCoreApplication>

#include "gui/session/from_below/sentences.h"

namespace vallecula::gui::from_below {
namespace {

// The first that fits is taken: the longer ones stand before what is only a part of them.
constexpr const char* kSentences[] = {
    // curricula/score
    QT_TRANSLATE_NOOP("FromBelow", "%1; asked for: %2"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "The tube was pushed against what stood before its tip (%1) with %2 N at %3 s, within the %4 N allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "The tube was pushed against what stood before its tip (%1) with %2 N at %3 s, more than the %4 N "
        "allowed"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The tube was pushed against what stood before its tip (%1) with %2 N, within the %3 N allowed"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "The tube was pushed against what stood before its tip (%1) with %2 N, more than the %3 N allowed"),
    QT_TRANSLATE_NOOP("FromBelow", "The trial was interrupted (%1): its log ends at %2 s"),
    QT_TRANSLATE_NOOP("FromBelow", "The blade %1 was taken, which is right for this infant"),
    QT_TRANSLATE_NOOP("FromBelow", "The blade %1 was taken; right for this infant is %2"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube %1 was taken, which is right for this infant"),
    QT_TRANSLATE_NOOP("FromBelow", "The tube %1 was taken; right for this infant is %2"),
    QT_TRANSLATE_NOOP("FromBelow", "%1; not validated"),
    // gui/report
    QT_TRANSLATE_NOOP("FromBelow", "%1 time (%2)"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 times (%2)"),
    QT_TRANSLATE_NOOP("FromBelow", "%1 N, at %2 s (%3)"),
    QT_TRANSLATE_NOOP("FromBelow", "%1: recognised late"),
    // gui/session
    QT_TRANSLATE_NOOP("FromBelow", "The tube's hand: %1"),
    QT_TRANSLATE_NOOP("FromBelow", "pause: %1"),
    QT_TRANSLATE_NOOP("FromBelow", "recorded by another build (%1, %2); only the same build promises the same bits"),
    QT_TRANSLATE_NOOP("FromBelow", "recorded with kernels for %1, computed here with %2"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "from %1 s on the tissue's shape may be a little different from what it was (%2 is the first to "
                      "differ); figures are the recorded ones"),
    QT_TRANSLATE_NOOP("FromBelow", "at %1 s %2 (the %3 ticks up to it are in %4)"),
    QT_TRANSLATE_NOOP("FromBelow", "the replay stopped: %1"),
    QT_TRANSLATE_NOOP("FromBelow", "the expert's loop stopped: %1"),
    QT_TRANSLATE_NOOP("FromBelow", "a trial that was cut off could not be kept: %1"),
    QT_TRANSLATE_NOOP("FromBelow", "a trial that was cut off is kept, but has no report: %1"),
    QT_TRANSLATE_NOOP("FromBelow", "a deleted person's files are still there: %1"),
};

}  // namespace

Sentences built() { return {std::begin(kSentences), std::end(kSentences)}; }

}  // namespace vallecula::gui::from_below
