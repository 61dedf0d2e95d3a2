// NRRD headers: fields, key-value pairs, and what they say of the voxels.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "pipeline/exchange/placement.h"
#include "pipeline/exchange/voxel_stream.h"

namespace vallecula::pipeline {

struct NrrdHeader {
  std::map<std::string, std::string> fields;  ///< "space origin" and so on
  std::map<std::string, std::string> keys;    ///< "Segment0_Name" and so on
  std::uint64_t data_at = 0;                  ///< byte of the file at which the voxels begin
};
/// Throws LabelMapError.
NrrdHeader read_nrrd_header(const std::filesystem::path& file);

struct NrrdVoxels {
  Placement place;
  int layers = 1;  ///< values a voxel: the first, fastest axis of a file of four dimensions
  VoxelLayout layout;
};
/// Three dimensions, or four with a list axis first; whole numbers or floats; raw or gzip in the same file; space LPS,
/// RAS or LAS. Throws LabelMapError.
NrrdVoxels nrrd_voxels(const NrrdHeader& header, const std::filesystem::path& file);

}  // namespace vallecula::pipeline
