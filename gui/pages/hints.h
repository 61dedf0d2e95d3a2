// What to do next, in one line, by what can be seen at the bedside: never by where the tip is known to be beyond sight.
#pragma once

#include <QString>

#include "engine/snapshot.h"
#include "gui/session/held_tools.h"

namespace vallecula::gui {

/// What the infant needs before anything else is done; empty: nothing. Of a scene with an intubation, as hint_for,
/// which says it first.
QString need_of(const engine::Snapshot& snapshot, bool blade_in);

/// As it stands under the view; loud: as an alarm.
struct Banner {
  QString words;
  bool loud = false;
};
/// What the infant needs, before what the device wants, which says in few words what a hand that lost the blade does.
/// `need` of need_of and not empty; `alert`: what the device wants, else empty.
Banner need_before(const engine::Snapshot& snapshot, const QString& need, const QString& alert);

/// What to say of a blade that presses on the upper gum with so many N; empty: within its target.
QString levering_words(double gum_n, double target_n);

/// Of a scene with an intubation. `sight_percent`: from where on the glottis counts as in sight; `blade_in`: the
/// blade's tip is in the mouth; `other_hand`: the key that takes the tube, empty where a hand
/// has it.
QString hint_for(const engine::Snapshot& snapshot, double sight_percent, bool blade_in, const QString& other_hand);

/// That key. `takes_turns`: one device drives both hands, now the one with `in_hand`.
QString key_to_the_tube(bool takes_turns, Tool in_hand);

}  // namespace vallecula::gui
