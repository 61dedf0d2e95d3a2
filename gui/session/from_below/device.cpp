// Devices: what is found, what is wrong and what to do.
#include <QCoreApplication>

#include "gui/session/from_below/sentences.h"

namespace vallecula::gui::from_below {
namespace {

constexpr const char* kSentences[] = {
    // Kinds, as the records have them: names of products stay
    QT_TRANSLATE_NOOP("FromBelow", "mouse"),
    QT_TRANSLATE_NOOP("FromBelow", "scripted"),
    QT_TRANSLATE_NOOP("FromBelow", "recorded"),
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
    QT_TRANSLATE_NOOP("FromBelow", "The trial is held: it goes on when it is let go."),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The device's driver reports an error: unplug it, wait five seconds, plug it in again."),
    QT_TRANSLATE_NOOP("FromBelow", "The trial is held by the instructor: it goes on when they let it go."),
    QT_TRANSLATE_NOOP("FromBelow", "The trial is held by you for as long as you look at the expert (G)."),
    QT_TRANSLATE_NOOP("FromBelow", "The trial is held by you for as long as the list of keys is open."),
    QT_TRANSLATE_NOOP("FromBelow", "No picture comes to the screen: the trial waits."),
    QT_TRANSLATE_NOOP("FromBelow",
                      "The picture is back. To go on press Enter or a button of the device, or hold the grey blade on "
                      "the steel one for half a second."),
    QT_TRANSLATE_NOOP("FromBelow", "The device reports an unknown fault."),
    QT_TRANSLATE_NOOP("FromBelow", "mouse and keyboard"),
    QT_TRANSLATE_NOOP("FromBelow", "mouse and keyboard; the force is drawn, not felt"),
    QT_TRANSLATE_NOOP("FromBelow", "3D Systems Touch, Touch X and other HDAPI devices; NAME as their set-up calls it"),
    QT_TRANSLATE_NOOP("FromBelow", "a Novint Falcon: position and force; its grip does not turn the blade"),
    QT_TRANSLATE_NOOP("FromBelow", "a SpaceMouse: the cap steers by speed; the force is drawn, not felt"),
    QT_TRANSLATE_NOOP("FromBelow", "the device's library libHD.so cannot be loaded"),
    QT_TRANSLATE_NOOP("FromBelow",
                      "Install OpenHaptics and the Touch driver from 3D Systems, or let VALLECULA_LIBHD name the "
                      "library's file"),
    QT_TRANSLATE_NOOP("FromBelow", "none plugged in"),
    QT_TRANSLATE_NOOP("FromBelow", "if there is one, check its cable and power"),
    QT_TRANSLATE_NOOP("FromBelow", "it opens but gives no reading: another program may be using it"),
    QT_TRANSLATE_NOOP("FromBelow", "close the other program; else check the cable and the power"),
    QT_TRANSLATE_NOOP(
        "FromBelow",
        "no firmware file was found: it works only while it still runs the firmware another program gave it"),
};

}  // namespace

Sentences device() { return {std::begin(kSentences), std::end(kSentences)}; }

}  // namespace vallecula::gui::from_below
