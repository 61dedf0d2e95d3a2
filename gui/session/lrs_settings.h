// The learning record store of this user's settings.
#pragma once

#include <optional>
#include <string>

#include "curricula/export/lrs.h"

namespace vallecula::gui {

/// [lrs] address, key, secret, home_page of settings.ini; nothing: no address is set.
struct LrsChoice {
  curricula::LrsSettings lrs;
  std::string home_page;
};
std::optional<LrsChoice> chosen_lrs();

}  // namespace vallecula::gui
