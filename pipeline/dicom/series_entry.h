// A series as it is listed: in neutral words and numbers, nothing of what the files say about a person.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vallecula::pipeline {

/// Eight bits a pixel, from -160 (0) to 240 HU (255), rows from the patient's front to the back, seen from the feet.
struct Thumbnail {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;
};

struct SeriesEntry {
  int number = 0;                   ///< from 1: what --series takes
  std::string modality;             ///< CT, MR ...; "volume" for a NIfTI, NRRD or MetaImage file
  std::array<int, 3> size{};        ///< columns, rows, slices
  std::array<double, 3> spacing{};  ///< mm along a row, along a column, from slice to slice
  std::string orientation;          ///< axial, coronal, sagittal, with the degrees it is off; empty when unknown
  std::string kernel;               ///< reconstruction kernel where it is one of the usual names
  bool usable = false;              ///< for an import
  std::string reason;               ///< why not
  Thumbnail thumbnail;              ///< of the middle slice of an axial CT, when asked for
};

/// "axial, 512 x 512 x 300, 0.5 x 0.5 x 1 mm, kernel H30s"
std::string described(const SeriesEntry& entry);

}  // namespace vallecula::pipeline
