// What somebody has done so far, as the start page needs it to say what is open.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "curricula/progress/progress.h"
#include "curricula/records/people.h"

namespace vallecula::gui {

/// By curriculum id, oldest first.
using PastResults = std::map<std::string, std::vector<curricula::PastResult>>;

/// The finished trials of whoever is signed in, or those that belong to nobody; a trial that was cut off counts for
/// nothing. Throws RecordsError.
PastResults past_results(curricula::Records& records, const curricula::Who& who);

/// What counts with these hands: a laryngoscopy that was done with the blade's device alone was done with the same hand
/// as when the tube has a device of its own. Kinds as LogHeader::device_kind; `hands` is "touch" or "touch+mouse".
std::vector<curricula::PastResult> with_hands(std::vector<curricula::PastResult> results,
                                              const curricula::Curriculum& curriculum, const std::string& hands);

}  // namespace vallecula::gui
