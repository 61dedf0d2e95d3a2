// The voxels of one picture.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "pipeline/dicom/file_list.h"
#include "pipeline/dicom/picture.h"

namespace vallecula::pipeline {

/// What becomes of voxels that the header calls padding.
enum class Padding {
  to_air,  ///< -1024 HU
  keep     ///< the rescale is applied, as a reader does that knows no padding
};

class PictureReader {
 public:
  PictureReader(const FileList& files, Padding padding);
  ~PictureReader();

  /// Writes columns x rows HU, rounded to whole numbers and clamped to int16; returns how many had to be clamped. The
  /// file last read stays open, so frames of one file are best read one after the other. Throws SeriesError.
  std::size_t read(const Picture& picture, std::int16_t* hu);

 private:
  struct OpenFile;
  void open(const Picture& picture);

  const FileList& files_;
  Padding padding_;
  std::unique_ptr<OpenFile> open_;
  std::vector<char> buffer_;
};

/// stored * slope + intercept, to the nearest whole number within int16.
std::int16_t rounded_hu(double stored, double slope, double intercept);

}  // namespace vallecula::pipeline
