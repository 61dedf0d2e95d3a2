#include "gui/commands/number_options.h"

#include <charconv>
#include <cmath>
#include <sstream>
#include <string>

namespace vallecula::gui {
namespace {

/// from_chars knows no locale and takes no leading blank or plus sign.
template <class Number>
bool reads_as(const std::string& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

template <class Number>
CLI::Validator within(const char* what, Number low, Number high, bool (*fits)(const std::string&, Number, Number)) {
  std::ostringstream range;
  range << what << " from " << low << " to " << high;
  const auto check = [range = range.str(), low, high, fits](std::string& text) {
    return fits(text, low, high) ? std::string() : "'" + text + "' is not " + range;
  };
  std::ostringstream shown;
  shown << "[" << low << " - " << high << "]";
  return CLI::Validator(check, shown.str());
}

}  // namespace

CLI::Validator number_within(double low, double high) {
  return within<double>("a number", low, high, [](const std::string& text, double from, double to) {
    double value = 0.0;
    return reads_as(text, value) && std::isfinite(value) && value >= from && value <= to;
  });
}

CLI::Validator whole_number_within(std::uint64_t low, std::uint64_t high) {
  return within<std::uint64_t>("a whole number", low, high,
                               [](const std::string& text, std::uint64_t from, std::uint64_t to) {
                                 std::uint64_t value = 0;
                                 return reads_as(text, value) && value >= from && value <= to;
                               });
}

}  // namespace vallecula::gui
