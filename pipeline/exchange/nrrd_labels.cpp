// NRRD label maps: with 3D Slicer's segment keys (values and layers named), or plain.
#include <cstdlib>

#include "pipeline/exchange/label_readers.h"
#include "pipeline/exchange/nrrd_file.h"

namespace vallecula::pipeline {
namespace {

/// The type's code of Slicer's tag "TerminologyEntry:CONTEXT~CATEGORY~SCT^CODE^MEANING~...".
std::string snomed_of_tags(const std::string& tags) {
  auto at = tags.find("TerminologyEntry:");
  for (int part = 0; part < 2 && at != std::string::npos; ++part) at = tags.find('~', at + 1);
  if (at == std::string::npos || tags.compare(at, 5, "~SCT^") != 0) return {};
  const auto end = tags.find('^', at + 5);
  return end == std::string::npos ? std::string() : tags.substr(at + 5, end - at - 5);
}

int whole_number(const std::string& text, int low, int high, const std::string& key,
                 const std::filesystem::path& file) {
  char* end = nullptr;
  const long value = std::strtol(text.c_str(), &end, 10);
  if (end == text.c_str() || *end != '\0' || value < low || value > high) {
    fail_label_file(
        file, "\"" + key + "\" is not a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return static_cast<int>(value);
}

}  // namespace

LabelImage read_nrrd_labels(const std::filesystem::path& file, const std::map<int, std::uint8_t>& values) {
  const auto header = read_nrrd_header(file);
  const auto voxels = nrrd_voxels(header, file);
  LabelImage image;
  image.place = voxels.place;
  const auto key = [&](const std::string& name) {
    const auto found = header.keys.find(name);
    return found == header.keys.end() ? std::string() : found->second;
  };
  ValueTable table(voxels.layers);
  bool named = false;
  for (const auto& [name, text] : header.keys) {
    const auto end = name.find("_ID");
    if (name.rfind("Segment", 0) != 0 || end == std::string::npos || end + 3 != name.size()) continue;
    const auto segment = name.substr(0, end);
    const int index = whole_number(segment.substr(7), 0, 65535, name, file);
    named = true;
    // Slicer before 4.11 wrote neither: then a segment is the layer of its number and holds ones.
    const auto layer_text = key(segment + "_Layer");
    const int layer = layer_text.empty() ? (voxels.layers > 1 ? index : 0)
                                         : whole_number(layer_text, 0, 65535, segment + "_Layer", file);
    if (layer >= voxels.layers) fail_label_file(file, "the layer of " + segment + " is not in the file");
    const auto value_text = key(segment + "_LabelValue");
    const int value = value_text.empty() ? 1 : whole_number(value_text, 1, 65535, segment + "_LabelValue", file);
    const auto label = segment_label(key(segment + "_Name"), snomed_of_tags(key(segment + "_Tags")), image.left_out);
    if (label) table.add(layer, value, *label);
  }
  if (!named && voxels.layers > 1) fail_label_file(file, "it has layers but no names of segments");
  if (named) {
    fill_sets(image, file, voxels.layout, table, false);
  } else {
    fill_sets(image, file, voxels.layout, unnamed_table(values), values.empty());
  }
  return image;
}

}  // namespace vallecula::pipeline
