#include "gui/records_pages/pin_try.h"

namespace vallecula::gui {

PinTry try_pin(curricula::Records& records, long long id, const std::string& pin) {
  try {
    return {curricula::People(records).sign_in(id, pin), {}, 0.0};
  } catch (const curricula::PinRefused& refused) {
    return {std::nullopt, QString::fromUtf8(refused.what()), refused.wait_s};
  }
}

}  // namespace vallecula::gui
