#include "gui/session/device_rows.h"

#include <cstdio>

namespace vallecula::gui {
namespace {

const std::string kNotKnown = "not known";

std::string with_unit(double value, int digits, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f %s", digits, value, unit);
  return text;
}

std::string workspace_of(const device::DeviceInfo& info) {
  const auto& w = info.workspace_m;
  if (!(w[0] > 0.0 && w[1] > 0.0 && w[2] > 0.0)) return "-";
  char text[96];
  std::snprintf(text, sizeof(text), "%.0f x %.0f x %.0f mm", 1e3 * w[0], 1e3 * w[1], 1e3 * w[2]);
  return text;
}

std::string force_of(const device::DeviceInfo& info) {
  if (!(info.peak_force_n > 0.0)) return "none: shown as a bar";
  const std::string peak = with_unit(info.peak_force_n, 1, "N");
  return info.continuous_force_n > 0.0 ? peak + ", for long " + with_unit(info.continuous_force_n, 2, "N") : peak;
}

struct CalibrationWords {
  const char *word, *text, *mend;
};

CalibrationWords words_of(device::Calibration calibration) {
  switch (calibration) {
    case device::Calibration::not_needed:
      return {"not_needed", "", ""};
    case device::Calibration::good:
      return {"good", "good", ""};
    case device::Calibration::needs_update:
      return {"needs_update", "to be done anew",
              "move its handle once through the whole workspace before a trial; no force is shown until then"};
    case device::Calibration::needs_hand:
      return {
          "needs_hand", "to be done by hand",
          "a stylus goes into its ink well, a Falcon's grip is pulled all the way out and pushed in, before a trial; "
          "no force is shown until then"};
  }
  return {"", "", ""};
}

}  // namespace

DeviceRow device_row(const device::FoundDevice& found) {
  const device::DeviceInfo& info = found.info;
  const CalibrationWords calibration = words_of(found.calibration);
  DeviceRow row;
  row.name = found.name.empty() ? "-" : found.name;
  row.model = (info.model.empty() ? info.kind : info.model) + (info.serial.empty() ? "" : " (" + info.serial + ")");
  row.driver = info.driver.empty() ? "built in" : info.driver;
  row.rate = found.figures_known ? with_unit(info.rate_hz, 0, "Hz") : kNotKnown;
  row.workspace = found.figures_known ? workspace_of(info) : kNotKnown;
  row.force = found.figures_known ? force_of(info) : kNotKnown;
  row.calibration = calibration.text;
  if (!found.problem.empty())
    row.trouble = found.problem + (found.mend.empty() ? "" : "; " + found.mend);
  else if (*calibration.mend != '\0')
    row.trouble =
        std::string("calibration ") + calibration.text + ": " + (found.mend.empty() ? calibration.mend : found.mend);
  return row;
}

std::array<std::string, kDeviceColumns.size()> cells_of(const DeviceRow& row) {
  return {row.name, row.model, row.driver, row.rate, row.workspace, row.force, row.calibration};
}

bool usable(const device::FoundDevice& found) { return !found.name.empty(); }

const char* calibration_word(device::Calibration calibration) { return words_of(calibration).word; }

}  // namespace vallecula::gui
