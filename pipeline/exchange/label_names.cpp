#include "pipeline/exchange/label_names.h"

#include <cctype>
#include <map>

#include "pipeline/package/label_map.h"

namespace vallecula::pipeline {
namespace {

/// Letters and digits alone, in lower case.
std::string plain(const std::string& name) {
  std::string out;
  for (const unsigned char c : name) {
    if (std::isalnum(c) != 0) out += static_cast<char>(std::tolower(c));
  }
  return out;
}

/// "vertebraec1" and so on: each of TotalSegmentator's vertebrae is spine.
bool is_vertebra(const std::string& name) {
  constexpr const char* kStem = "vertebrae";
  if (name.rfind(kStem, 0) != 0 || name.size() < 11 || name.size() > 12) return false;
  const char region = name[9];
  if (region != 'c' && region != 't' && region != 'l' && region != 's') return false;
  return name.find_first_not_of("0123456789", 10) == std::string::npos;
}

}  // namespace

std::optional<std::uint8_t> label_of_name(const std::string& name) {
  static const std::map<std::string, std::uint8_t> kWords = [] {
    std::map<std::string, std::uint8_t> words = {
        {"head", kSkin},         {"skull", kSkull},           {"cranium", kSkull},       {"boneskull", kSkull},
        {"mandible", kMandible}, {"lowerjaw", kMandible},     {"upperairway", kAirway},  {"esophagus", kOesophagus},
        {"vertebrae", kSpine},   {"vertebralcolumn", kSpine}, {"cervicalspine", kSpine}, {"velum", kSoftPalate}};
    for (const auto& label : kLabelNames) words[plain(label.name)] = label.value;
    return words;
  }();
  const auto word = plain(name);
  if (const auto found = kWords.find(word); found != kWords.end()) return found->second;
  if (is_vertebra(word)) return kSpine;
  return std::nullopt;
}

std::optional<std::uint8_t> label_of_code(const std::string& snomed) {
  for (const auto& label : kLabelNames) {
    if (snomed == label.snomed) return label.value;
  }
  return std::nullopt;
}

std::string known_label_names() {
  std::string names;
  for (const auto& label : kLabelNames) names += (names.empty() ? "" : ", ") + std::string(label.name);
  return names;
}

std::string name_of_label(std::uint8_t value) {
  for (const auto& label : kLabelNames) {
    if (label.value == value) return label.name;
  }
  return "background";
}

}  // namespace vallecula::pipeline
