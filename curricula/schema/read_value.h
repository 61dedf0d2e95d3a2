// From validated YAML into plain values; what is not given stays as it is (private to the library).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "curricula/schema/validator.h"
#include "curricula/text.h"

namespace vallecula::curricula {

inline void read(const YAML::Node& node, double& value) {
  if (node) value = checked_number(node);
}
inline void read(const YAML::Node& node, bool& value) {
  if (node) value = checked_bool(node);
}
inline void read(const YAML::Node& node, std::string& value) {
  if (node) value = node.Scalar();
}
template <class Whole, class = std::enable_if_t<std::is_integral_v<Whole>>>
void read(const YAML::Node& node, Whole& value) {
  if (node) value = static_cast<Whole>(checked_number(node));
}
inline void read(const YAML::Node& node, Text& value) {
  if (!node) return;
  if (!node.IsMap()) {
    value = Text(node.Scalar());
    return;
  }
  std::map<std::string, std::string> by_language;
  for (const auto& entry : node) by_language[entry.first.Scalar()] = entry.second.Scalar();
  value = Text(std::move(by_language));
}
inline void read(const YAML::Node& node, std::array<double, 2>& value) {
  if (node) value = {checked_number(node[0]), checked_number(node[1])};
}
template <class Value>
void read(const YAML::Node& node, std::optional<Value>& value) {
  if (node) read(node, value.emplace());
}
template <class Value>
void read(const YAML::Node& node, std::vector<Value>& values) {
  if (node) values.clear();
  for (std::size_t i = 0; node && i < node.size(); ++i) read(node[i], values.emplace_back());
}

}  // namespace vallecula::curricula
