// What somebody has done so far, as the start page needs it to say what is open.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "curricula/progress/progress.h"
#include "curricula/scenario.h"

namespace vallecula::gui {

/// By curriculum id, oldest first, as Progress::results gives them.
using PastResults = std::map<std::string, std::vector<curricula::PastResult>>;

/// What counts with these hands: a laryngoscopy that was done with the blade's device alone was done with the same hand
/// as when the tube has a device of its own. Kinds as LogHeader::device_kind; `hands` is "touch" or "touch+mouse".
std::vector<curricula::PastResult> with_hands(std::vector<curricula::PastResult> results,
                                              const curricula::Curriculum& curriculum, const std::string& hands);

}  // namespace vallecula::gui
