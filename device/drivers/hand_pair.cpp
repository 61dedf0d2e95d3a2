#include "device/drivers/hand_pair.h"

#include <fstream>
#include <sstream>

namespace vallecula::device {

namespace {

constexpr std::size_t kFirstOfSecond = 8, kActions = 15, kColumns = 16;

std::vector<std::string> columns_of(const std::string& line) {
  std::vector<std::string> columns;
  std::istringstream text(line);
  for (std::string one; std::getline(text, one, ',');) columns.push_back(one);
  if (!line.empty() && line.back() == ',') columns.emplace_back();  // an empty last column: no action
  return columns;
}

bool is_row(const std::string& line) {
  const std::size_t mark = line.find_first_not_of(" \t\r");
  return mark != std::string::npos && line[mark] != '#';
}

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t\r");
  return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

std::string join(const std::vector<std::string>& columns, std::size_t from, std::size_t to) {
  std::string text;
  for (std::size_t i = from; i < to; ++i) text += "," + columns[i];
  return text;
}

}  // namespace

bool is_hand_pair(const std::filesystem::path& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (is_row(line)) return columns_of(line).size() == kColumns;
  return false;
}

HandPair read_hand_pair(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw DeviceError("trajectory " + file.string() + ": cannot be opened; check the name and the permission");
  // Each hand's own text, line by line, so that whatever is wrong with it is told with its line.
  std::string blade, tube;
  std::vector<std::uint32_t> held;  // a row each
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::string where = "trajectory " + file.string() + ", line " + std::to_string(number) + ": ";
    if (!is_row(line)) {
      // A remark for the second hand's device is none for the first's.
      const std::size_t second = line.find("second-fault");
      blade += second == std::string::npos ? line + "\n" : "\n";
      if (line.find("fault") == std::string::npos)
        tube += line + "\n";
      else
        tube += second == std::string::npos ? "\n" : "# " + line.substr(second + std::string("second-").size()) + "\n";
      continue;
    }
    const std::vector<std::string> columns = columns_of(line);
    if (columns.size() != kColumns)
      throw DeviceError(where + std::to_string(columns.size()) +
                        " columns; expected t,x,y,z,qw,qx,qy,qz,x2,y2,z2,qw2,qx2,qy2,qz2,actions");
    blade += columns[0] + join(columns, 1, kFirstOfSecond) + "\n";
    tube += columns[0] + join(columns, kFirstOfSecond, kActions) + "\n";
    const std::string words = trimmed(columns[kActions]);
    if (words == "actions") continue;  // the line of column names
    try {
      held.push_back(actions_of(words));
    } catch (const DeviceError& error) {
      throw DeviceError(where + error.what());
    }
  }
  HandPair pair;
  std::istringstream blade_text(blade), tube_text(tube);
  pair.blade = read_hand_script(blade_text, file.string());
  pair.tube = read_hand_script(tube_text, file.string() + " (second hand)");
  std::vector<TimedActions> changes;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (changes.empty() || changes.back().bits != held[i]) changes.push_back({pair.blade.keyframes[i].time_s, held[i]});
  pair.actions = ActionPlan(std::move(changes));
  return pair;
}

}  // namespace vallecula::device
