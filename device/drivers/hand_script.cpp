// The file of a scripted hand: its trajectory, and what the lines that start with # say of the hand and its faults.
#include <charconv>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "device/drivers/scripted_device.h"

namespace vallecula::device {
namespace {

const std::map<std::string, double HandSettings::*> kNumbers = {
    {"stiffness_n_m", &HandSettings::stiffness_n_m},           {"damping_n_s_m", &HandSettings::damping_n_s_m},
    {"tremor_amplitude_m", &HandSettings::tremor_amplitude_m}, {"max_force_n", &HandSettings::max_force_n},
    {"device_limit_n", &HandSettings::device_limit_n},         {"limit_time_s", &HandSettings::limit_time_s},
    {"recovery_time_s", &HandSettings::recovery_time_s}};

template <class Number>
bool parse(const std::string& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

InjectedFault fault_of(const std::vector<std::string>& words, const std::string& where) {
  InjectedFault f;
  if (words.size() == 4) f.fault = fault_named(words[1]);
  if (f.fault == DeviceFault::none || !parse(words[2], f.from_s) || !parse(words[3], f.for_s) || !(f.from_s >= 0.0) ||
      !(f.for_s >= 0.0)) {
    std::string kinds;
    for (auto kind = DeviceFault::force_exceeded; kind <= DeviceFault::driver_error;
         kind = static_cast<DeviceFault>(static_cast<int>(kind) + 1))
      kinds += std::string(kinds.empty() ? "" : ", ") + name_of(kind);
    throw DeviceError(where + "expected # fault KIND FROM_S FOR_S with one of " + kinds);
  }
  return f;
}

void set_hand(const std::vector<std::string>& words, const std::string& where, HandSettings& hand) {
  bool good = words.size() == 3;
  if (good && words[1] == "tremor_seed") {
    good = parse(words[2], hand.tremor_seed);
  } else if (good) {
    const auto number = kNumbers.find(words[1]);
    good = number != kNumbers.end() && parse(words[2], hand.*number->second);
  }
  if (good) return;
  std::string names = "tremor_seed";
  for (const auto& [name, member] : kNumbers) names += ", " + name;
  throw DeviceError(where + "expected # hand NAME VALUE with one of " + names);
}

}  // namespace

HandScript read_hand_script(const std::filesystem::path& file) {
  read_trajectory_csv(file);  // says what is wrong with a file that is none
  std::ifstream in(file);
  return read_hand_script(in, file.string());
}

HandScript read_hand_script(std::istream& in, const std::string& name) {
  HandScript script;
  script.keyframes = read_trajectory_csv(in, name);
  in.clear();
  in.seekg(0);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::size_t mark = line.find_first_not_of(" \t");
    if (mark == std::string::npos || line[mark] != '#') continue;
    std::istringstream text(line.substr(mark + 1));
    std::vector<std::string> words;
    for (std::string word; text >> word;) words.push_back(word);
    const std::string where = "trajectory " + name + ", line " + std::to_string(number) + ": ";
    if (!words.empty() && words[0] == "fault") script.faults.push_back(fault_of(words, where));
    if (!words.empty() && words[0] == "hand") set_hand(words, where, script.hand);
  }
  return script;
}

}  // namespace vallecula::device
