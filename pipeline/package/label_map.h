// The label map on disk: an NRRD with 3D Slicer's segment keys. One list of names for the whole project (DESIGN section
// 3).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "pipeline/volume.h"

namespace vallecula::pipeline {

enum Label : std::uint8_t {
  kBackground = 0,
  kSkin = 1,
  kSkull = 2,
  kMandible = 3,
  kTongue = 4,
  kEpiglottis = 5,
  kAirway = 6,
  kLarynx = 7,
  kOesophagus = 8,
  kSoftPalate = 9,
  kSpine = 10
};

struct LabelName {
  std::uint8_t value;
  const char* name;           ///< Slicer segment name
  std::array<double, 3> rgb;  ///< 0..1
  const char* snomed;         ///< SNOMED CT code of the structure, as in DICOM's lists (PS3.16)
  const char* meaning;        ///< of the code
};

constexpr std::array<LabelName, 10> kLabelNames = {
    {{kSkin, "skin", {0.91, 0.73, 0.62}, "39937001", "Skin"},
     {kSkull, "bone_skull", {0.95, 0.92, 0.80}, "89546000", "Skull"},
     {kMandible, "bone_mandible", {0.89, 0.84, 0.63}, "91609006", "Mandible"},
     {kTongue, "tongue", {0.80, 0.36, 0.38}, "21974007", "Tongue"},
     {kEpiglottis, "epiglottis", {0.96, 0.66, 0.35}, "61563008", "Epiglottis"},
     {kAirway, "airway", {0.33, 0.62, 0.86}, "89187006", "Airway structure"},
     {kLarynx, "larynx", {0.55, 0.76, 0.60}, "4596009", "Larynx"},
     {kOesophagus, "oesophagus", {0.63, 0.47, 0.35}, "32849002", "Esophagus"},
     {kSoftPalate, "soft_palate", {0.88, 0.53, 0.58}, "49460000", "Soft palate"},
     {kSpine, "spine", {0.75, 0.78, 0.85}, "421060004", "Spine"}}};

/// Says which file, what is wrong with it and how to mend it.
class LabelMapError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes a gzip NRRD (space left-posterior-superior) with 3D Slicer's keys (names, values, colours, SNOMED CT codes,
/// extents), so that it opens there as a segmentation. Throws LabelMapError.
void write_label_map(const Labels& labels, const std::filesystem::path& file);

/// Reads an axis-aligned 8-bit NRRD in LPS (raw or gzip, data in the same file), renaming values by the segment names
/// when they are given. Throws LabelMapError.
Labels read_label_map(const std::filesystem::path& file);

}  // namespace vallecula::pipeline
