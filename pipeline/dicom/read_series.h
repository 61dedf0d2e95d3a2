// Reads a CT: a folder with a DICOM series (whatever else is in it), a multi-frame DICOM file, or a NIfTI, NRRD or
// MetaImage volume. The reading itself happens in the helper program vallecula-ct, see ct_helper.h.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/dicom/ct_volume.h"
#include "pipeline/dicom/series_entry.h"
#include "pipeline/dicom/series_error.h"
#include "pipeline/volume.h"

namespace vallecula::pipeline {

struct CtSeries {
  Hounsfield hu;  ///< HU, axial order; x to the left, y to the back, z to the head
  int slices = 0;
  std::array<int, 2> matrix{0, 0};                ///< columns, rows of the source
  std::array<double, 3> source_spacing{0, 0, 0};  ///< mm: along a row, along a column, between slices (from positions)
  bool resampled = false;                         ///< the source was oblique or tilted, so voxels were interpolated
  std::vector<std::string> notes;                 ///< what a person should know, for instance files left out
};

/// What lies at `place`, usable series first; their numbers are what a choice takes. What `progress` (0..1) throws ends
/// it. Throws SeriesError.
std::vector<SeriesEntry> list_series(const std::filesystem::path& place, bool thumbnails = false,
                                     const std::function<void(double)>& progress = {});

/// The volume as its files give it: exact positions, exact HU (rounded to whole numbers, padding as the rescale gives
/// it). Also of series too coarse or too short for an import. `choice` is a number of the list or a series instance
/// UID; empty: the only one that can be meant. `progress` gets 0..1; what it throws ends the reading. Throws
/// SeriesError.
CtVolume read_ct_volume(const std::filesystem::path& place, const std::string& choice = {},
                        const std::function<void(double)>& progress = {});

/// The same turned onto the patient's axes (see to_patient_axes.h), padding set to air; refuses what an import cannot
/// use, see limits.h. Throws SeriesError.
CtSeries read_ct_series(const std::filesystem::path& place, const std::function<void(double)>& progress = {},
                        const std::string& choice = {});

}  // namespace vallecula::pipeline
