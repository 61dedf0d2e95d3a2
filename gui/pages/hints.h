// What to do next, in one line, by what can be seen at the bedside: never by where the tip is known to be beyond sight.
#pragma once

#include <QString>

#include "engine/snapshot.h"
#include "gui/session/held_tools.h"

namespace vallecula::gui {

/// Of a scene with an intubation. `sight_percent`: from where on the glottis counts as in sight; `blade_in`: the
/// blade's tip is in the mouth; `other_hand`: the key that takes the tube, empty where a hand
/// has it.
QString hint_for(const engine::Snapshot& snapshot, double sight_percent, bool blade_in, const QString& other_hand);

/// That key. `takes_turns`: one device drives both hands, now the one with `in_hand`.
QString key_to_the_tube(bool takes_turns, Tool in_hand);

}  // namespace vallecula::gui
