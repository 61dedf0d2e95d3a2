// Reading as it runs inside the helper program: files to a volume, or to a list of what there is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/dicom/ct_volume.h"
#include "pipeline/dicom/picture_reader.h"
#include "pipeline/dicom/series_entry.h"
#include "pipeline/dicom/series_groups.h"

namespace vallecula::pipeline {

struct ReadRequest {
  std::string place;   ///< folder or file
  std::string choice;  ///< see choose()
  bool list = false;   ///< only say what there is
  bool thumbnails = false;
  Purpose purpose = Purpose::import;
  Padding padding = Padding::to_air;
};

struct ReadAnswer {
  CtGeometry geometry;  ///< of the volume; its voxels are where ReadHost::voxels said
  int slices = 0;
  std::vector<std::string> notes;
  std::vector<SeriesEntry> entries;  ///< of a list
};

/// What reading asks of the program it runs in.
class ReadHost {
 public:
  virtual ~ReadHost() = default;
  virtual void at_file(const std::string& name) = 0;    ///< about to be parsed: it may end this process
  virtual void alive(double fraction) = 0;              ///< share of the work done
  virtual std::int16_t* voxels(std::size_t count) = 0;  ///< shared memory for the result; throws std::bad_alloc
};

/// Throws SeriesError, std::bad_alloc.
ReadAnswer read_place(const ReadRequest& request, ReadHost& host);

}  // namespace vallecula::pipeline
