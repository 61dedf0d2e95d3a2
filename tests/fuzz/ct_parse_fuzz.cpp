// Any bytes through the reader's own parsing, in this process: the check of whole files, the headers of pictures
// (GDCM's parser below it, which is not instrumented), their sorting into series and stacks, volume headers and voxels.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "pipeline/dicom/limits.h"
#include "pipeline/dicom/series_error.h"
#include "pipeline/dicom/series_groups.h"
#include "pipeline/dicom/volume_file.h"
#include "pipeline/dicom/whole_file.h"

using namespace vallecula::pipeline;

namespace {

void must(bool condition) {
  if (!condition) std::abort();
}

/// A list of one file: what it holds does not matter.
const FileList& files() {
  static const FileList kFiles("/proc/self/exe");
  return kFiles;
}

void as_pictures(std::string_view bytes) {
  auto pictures = read_pictures(bytes, 0);
  for (const auto& p : pictures) {
    if (!p.fault.empty() || !p.has_pixels || p.modality != "CT" || p.localizer || p.colour) continue;
    must(p.columns >= 2 && p.rows >= 2 && static_cast<std::int64_t>(p.columns) * p.rows * p.frames <= kMostVoxels);
    must(std::isfinite(p.slope) && std::isfinite(p.intercept) && p.slope != 0.0);
    for (int a = 0; a < 3; ++a)
      must(std::isfinite(p.position[a]) && std::isfinite(p.row[a]) && std::isfinite(p.column[a]));
  }
  if (pictures.empty()) return;
  auto groups = group_pictures(std::move(pictures), files());
  for (const auto& group : groups) {
    must(group.entry.usable || !group.entry.reason.empty());
    if (!group.readable) continue;
    const auto& g = group.plan.geometry;
    must(static_cast<std::int64_t>(g.count()) <= kMostVoxels &&
         g.size[2] == static_cast<int>(group.plan.sources.size()));
    for (const auto& [place, share] : group.plan.sources) {
      must(place >= 0 && place < group.slices() && share >= 0.0 && share < 1.0);
      must(share == 0.0 || place + 1 < group.slices());
    }
  }
  try {
    choose(groups, "", Purpose::volume);
  } catch (const SeriesError&) {
  }
}

void as_volume(std::string_view bytes) {
  try {
    const auto header = volume_header(bytes);
    if (!header) return;
    must(static_cast<std::int64_t>(header->geometry.count()) <= kMostVoxels);
    if (header->geometry.count() > 100'000 || !header->data_file.empty()) return;
    std::vector<std::int16_t> hu(header->geometry.count());
    read_voxels(*header, bytes, hu.data());
  } catch (const SeriesError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  as_volume(bytes);
  as_pictures(bytes);
  return 0;
}
