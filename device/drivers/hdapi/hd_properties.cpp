#include "device/drivers/hdapi/hd_properties.h"

#include <algorithm>
#include <vector>

#include "device/drivers/hdapi/hd_library.h"

namespace vallecula::device::hdapi {
namespace {

constexpr double kBelievableForceN = 100.0, kBelievableMm = 5000.0, kBelievableStiffness = 100.0;

/// The library's string, in what a terminal shows.
std::string text_of(const Functions& hd, unsigned int what) {
  const char* text = hd.get_string(what);
  if (take_errors(hd).code != kSuccess || text == nullptr) return "";
  std::string shown;
  for (; *text != '\0' && shown.size() < 64; ++text) shown += *text >= ' ' && *text <= '~' ? *text : '?';
  return shown;
}

int integer_of(const Functions& hd, unsigned int what, int low, int high, int otherwise) {
  int values[8] = {};
  hd.get_integers(what, values);
  return take_errors(hd).code == kSuccess && values[0] >= low && values[0] <= high ? values[0] : otherwise;
}

/// Zero where the library does not know, or says what cannot be.
double number_of(const Functions& hd, unsigned int what, double highest) {
  double values[8] = {};
  hd.get_doubles(what, values);
  return take_errors(hd).code == kSuccess && values[0] > 0.0 && values[0] <= highest ? values[0] : 0.0;
}

Properties properties_of(const Functions& hd) {
  Properties p;
  DeviceInfo& info = p.info;
  info.kind = "touch";
  info.driver = "libHD.so";
  info.own_axes = true;
  info.model = text_of(hd, kModel);
  if (info.model.empty()) info.model = "HDAPI device";
  info.serial = text_of(hd, kSerial);
  info.rate_hz = integer_of(hd, kUpdateRate, 100, 10000, 1000);
  info.sensed_dof = integer_of(hd, kInputDof, 3, 7, 6);
  info.actuated_dof = integer_of(hd, kOutputDof, 0, 7, 3);
  p.motors = std::max(1, info.actuated_dof);
  info.peak_force_n = number_of(hd, kMaxForce, kBelievableForceN);
  info.continuous_force_n = std::min(number_of(hd, kMaxContinuousForce, kBelievableForceN), info.peak_force_n);
  info.max_stiffness_n_m = 1000.0 * number_of(hd, kMaxStiffness, kBelievableStiffness);
  p.calibration_styles = static_cast<unsigned int>(integer_of(hd, kCalibrationStyles, 0, 7, 0));
  double box[6] = {};
  hd.get_doubles(kUsableWorkspace, box);
  bool sound = take_errors(hd).code == kSuccess;
  for (int a = 0; a < 3; ++a) sound = sound && box[a + 3] > box[a] && box[a + 3] - box[a] < kBelievableMm;
  for (int a = 0; sound && a < 3; ++a) {
    p.middle_mm[a] = 0.5 * (box[a] + box[a + 3]);
    info.workspace_m[a] = 1e-3 * (box[a + 3] - box[a]);
  }
  return p;
}

}  // namespace

ErrorInfo take_errors(const Functions& hd) noexcept {
  ErrorInfo oldest;
  for (int i = 0; i < kMostErrors; ++i) {
    const ErrorInfo error = hd.get_error();
    if (error.code == kSuccess) break;
    oldest = error;
  }
  return oldest;
}

Properties open_device(const Functions& hd, const std::string& name, Channel& channel) {
  // The null name means the default device, but fails on Linux where the set-up calls it otherwise: it comes last.
  std::vector<const char*> names{"Default PHANToM", "Default Device", nullptr};
  if (!name.empty()) names = {name.c_str()};
  std::string failed;
  ErrorInfo first;
  for (const char* tried : names) {
    take_errors(hd);
    const Handle handle = hd.init_device(tried);
    const ErrorInfo error = take_errors(hd);
    if (handle != kNoDevice && error.code == kSuccess) {
      hd.make_current(handle);
      const Properties properties = properties_of(hd);
      hd.enable(kForceOutput);
      take_errors(hd);
      channel.attach(handle, properties);
      return properties;
    }
    if (handle != kNoDevice) hd.disable_device(handle);
    // What is said first of a device that is set up says more than that the other names are not.
    if (first.code == kSuccess || first.code == kCommConfigError) {
      if (error.code != kSuccess) first = error;
    }
    const char* text = error.code == kSuccess ? nullptr : hd.error_text(error.code);
    failed += (failed.empty() ? "" : "; ") +
              (tried == nullptr ? std::string("the default") : "'" + std::string(tried) + "'") + ": " +
              (error.code == kSuccess ? "no such device" : name_of(error.code)) +
              (error.internal_code != 0 ? " (" + std::to_string(error.internal_code) + ")" : "") +
              (text != nullptr && *text != '\0' ? ", " + std::string(text) : "");
  }
  throw HdError("no device can be opened (" + failed + ")", mend_of(first.code));
}

}  // namespace vallecula::device::hdapi
