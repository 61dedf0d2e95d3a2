// The voxels of a stack, picture by picture, in processes of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "pipeline/dicom/picture_reader.h"
#include "pipeline/dicom/series_groups.h"

namespace vallecula::pipeline {

/// Zeroed memory that processes forked from this one share.
class SharedMemory {
 public:
  explicit SharedMemory(std::size_t bytes);  ///< throws std::bad_alloc
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  void* data() const { return data_; }

 private:
  void* data_;
  std::size_t bytes_;
};

struct Decoded {
  std::size_t clamped = 0;  ///< voxels that did not fit into int16
  int doubles = 0;          ///< pictures left out because another at the same place is the same
};

/// Decodes the pictures at `places` of the group's plan, one after the other into `hu` (shared memory). Two at one
/// place must be the same. GDCM may die of a damaged file: then, as for any other fault, SeriesError names the file.
/// `alive` gets the share done. Must be called from a process with one thread.
Decoded decode(const FileList& files, const SeriesGroup& group, const std::vector<int>& places, Padding padding,
               std::int16_t* hu, const std::function<void(double)>& alive);

}  // namespace vallecula::pipeline
