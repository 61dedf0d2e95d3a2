// Which of our structures a name or a code from another program means.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace vallecula::pipeline {

/// The label (kLabelNames) that a segment's name means: our own names, the field's other words, those that
/// TotalSegmentator uses; case, spaces, dots, dashes and underscores do not matter.
std::optional<std::uint8_t> label_of_name(const std::string& name);
/// By SNOMED CT code.
std::optional<std::uint8_t> label_of_code(const std::string& snomed);
/// "skin, bone_skull, ...", for messages.
std::string known_label_names();
/// The name in kLabelNames.
std::string name_of_label(std::uint8_t label);

}  // namespace vallecula::pipeline
