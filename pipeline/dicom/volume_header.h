// The headers of volume files (NIfTI, NRRD, MetaImage): a few lines of text or 348 bytes each.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/dicom/ct_volume.h"

namespace vallecula::pipeline {

enum class VoxelType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t bytes_of(VoxelType type);

struct VolumeHeader {
  CtGeometry geometry;
  VoxelType type = VoxelType::int16;
  bool big_endian = false;
  bool packed = false;  ///< gzip or zlib
  double slope = 1.0;   ///< HU = slope * stored + intercept
  double intercept = 0.0;
  std::size_t data_at = 0;  ///< where the voxels begin: in the file, or (whole_file_packed) in what it unpacks to
  bool whole_file_packed = false;  ///< .nii.gz
  bool data_at_end = false;        ///< the voxels are the last bytes of the file
  std::string data_file;           ///< a file beside this one that holds the voxels; empty: this one
};

// Each throws SeriesError without naming the file; sizes are checked against kMostVoxels.
bool is_nifti(std::string_view bytes);
VolumeHeader nifti_header(std::string_view bytes);
bool is_nrrd(std::string_view bytes);
VolumeHeader nrrd_header(std::string_view bytes);
bool is_meta_image(std::string_view bytes);
VolumeHeader meta_image_header(std::string_view bytes);

/// Sizes, spacings and directions that a CT can have; else throws SeriesError.
void check_volume_header(const VolumeHeader& header);

}  // namespace vallecula::pipeline
