// Hounsfield units to grey: window and level.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace vallecula::gui {

struct GreyWindow {
  double centre = 40.0;  ///< HU
  double width = 400.0;  ///< HU, at least 1
  bool operator==(const GreyWindow& other) const { return centre == other.centre && width == other.width; }
};

struct GreyPreset {
  const char* name;
  GreyWindow window;
};
/// The airway's is wide about its border with tissue: lumen, leaf and wall are told apart.
constexpr std::array<GreyPreset, 3> kGreyPresets = {
    {{"Soft tissue", {40.0, 400.0}}, {"Bone", {500.0, 2000.0}}, {"Airway", {-400.0, 1400.0}}}};

/// DICOM's linear window (PS3.3 C.11.2.1.2.1), 0 black to 255 white, rounded to the nearest.
std::uint8_t grey_of(double hu, const GreyWindow& window);

/// The same for every value a voxel can have.
class GreyTable {
 public:
  explicit GreyTable(const GreyWindow& window);
  std::uint8_t operator[](std::int16_t hu) const { return grey_[static_cast<std::uint16_t>(hu)]; }

 private:
  std::vector<std::uint8_t> grey_;
};

}  // namespace vallecula::gui
