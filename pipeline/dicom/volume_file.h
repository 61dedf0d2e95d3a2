// A CT as one volume file: NIfTI, NRRD, MetaImage, its values HU.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include "pipeline/dicom/volume_header.h"

namespace vallecula::pipeline {

/// The header of a volume file (unpacked where need be); nothing when the bytes are none. Throws SeriesError.
std::optional<VolumeHeader> volume_header(std::string_view bytes);

/// The voxels as HU, rounded and clamped to int16 (what is no number becomes air), geometry.count() of them. `data`:
/// the bytes of the file that holds them. Returns how many had to be clamped. `beat` gets the share done. Throws
/// SeriesError.
std::size_t read_voxels(const VolumeHeader& header, std::string_view data, std::int16_t* hu,
                        const std::function<void(double)>& beat = {});

}  // namespace vallecula::pipeline
