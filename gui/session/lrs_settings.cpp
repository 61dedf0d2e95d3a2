#include "gui/session/lrs_settings.h"

#include "gui/session/user_settings.h"

namespace vallecula::gui {

std::optional<LrsChoice> chosen_lrs() {
  const auto kept = user_settings();
  const auto word = [&kept](const char* key) { return kept->value(key).toString().toStdString(); };
  LrsChoice choice;
  choice.lrs.address = word("lrs/address");
  if (choice.lrs.address.empty()) return std::nullopt;
  choice.lrs.key = word("lrs/key");
  choice.lrs.secret = word("lrs/secret");
  choice.home_page = word("lrs/home_page");
  return choice;
}

}  // namespace vallecula::gui
