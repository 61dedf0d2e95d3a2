// One try of a PIN, as every place where somebody signs in asks for it.
#pragma once

#include <QString>
#include <string>

#include "curricula/records/people.h"

namespace vallecula::gui {

struct PinTry {
  curricula::Who who;   ///< empty: it was refused
  QString refused;      ///< why, for a person
  double wait_s = 0.0;  ///< until the next try is looked at
};

/// Not for the window's thread. Throws RecordsError where the records cannot be asked.
PinTry try_pin(curricula::Records& records, long long id, const std::string& pin);

}  // namespace vallecula::gui
