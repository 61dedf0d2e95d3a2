// Is a DICOM file whole? Asked before the library reads it: the distribution's GDCM ends the process on some cut files
// and passes others.
#pragma once

#include <string>
#include <string_view>

namespace vallecula::pipeline {

struct DicomCheck {
  bool dicom = false;           ///< has the DICM marker, or begins like a data set without one
  std::string fault;            ///< empty when whole; else what is wrong, in words
  std::string modality;         ///< as far as the file could be walked
  std::string series;           ///< series instance UID, likewise: for grouping only
  std::size_t pixel_bytes = 0;  ///< length of the pixels where they are not packed
};

/// Walks all elements (sequences and encapsulated pixels too) against the file's length; a deflated data set is
/// unpacked first, up to kMostInflatedBytes.
DicomCheck check_dicom(std::string_view bytes);

}  // namespace vallecula::pipeline
