// The numbers of a voxel file one after another, unpacked as they are read: a header that promises too much costs no
// memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "pipeline/exchange/placement.h"

namespace vallecula::pipeline {

enum class Element { u8, i8, u16, i16, u32, i32, u64, i64, f32, f64 };
int bytes_of(Element element);

/// Where the numbers stand in a file and how they are written.
struct VoxelLayout {
  Element element = Element::u8;
  bool big_endian = false;
  bool gzip = false;       ///< what stands from `at` on is packed
  std::uint64_t at = 0;    ///< byte of the file
  std::uint64_t skip = 0;  ///< bytes to leave out after unpacking
};

/// Throws LabelMapError: "label map NAME: what", with the name as told_name has it.
[[noreturn]] void fail_label_file(const std::filesystem::path& file, const std::string& what);

/// Throws LabelMapError when a size is none or more than this program holds, or the steps span no volume.
void check_placement(const Placement& place, int layers, const std::filesystem::path& file);

/// Throws LabelMapError when the file cannot hold so many values: asked before memory is taken for them.
void check_enough_bytes(const std::filesystem::path& file, const VoxelLayout& layout, std::size_t count);

/// Calls take(values, n) with runs of the next values until `count` are done. Throws LabelMapError when they are fewer.
void read_voxels(const std::filesystem::path& file, const VoxelLayout& layout, std::size_t count,
                 const std::function<void(const double*, std::size_t)>& take);

/// The file's first `count` bytes, unpacked when they are gzip; fewer when it is shorter.
std::string first_bytes(const std::filesystem::path& file, std::size_t count);
bool is_gzip(const std::filesystem::path& file);

}  // namespace vallecula::pipeline
