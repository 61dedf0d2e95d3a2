// A CT, read by the helper program.
#pragma once

#include <functional>
#include <memory>

#include "pipeline/dicom/read_place.h"
#include "pipeline/dicom/reading_helper.h"

namespace vallecula::pipeline {

struct HelperResult {
  ReadAnswer answer;
  std::shared_ptr<const std::int16_t> voxels;  ///< answer.geometry.count() of them; null for a list
};

/// Whatever becomes of the helper, this process goes on: its death, its silence, its limits are a SeriesError that
/// names the file it was at. What `progress` (0..1) throws ends the helper and reaches the caller.
HelperResult run_ct_helper(const ReadRequest& request, const std::function<void(double)>& progress = {},
                           const HelperLimits& limits = {});

}  // namespace vallecula::pipeline
