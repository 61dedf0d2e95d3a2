#include "pipeline/dicom/series_entry.h"

#include <sstream>

namespace vallecula::pipeline {

std::string described(const SeriesEntry& entry) {
  std::ostringstream text;
  text.precision(4);
  text << entry.modality;
  if (!entry.orientation.empty()) text << " " << entry.orientation;
  if (entry.size[0] > 0) text << ", " << entry.size[0] << " x " << entry.size[1] << " x " << entry.size[2];
  if (entry.spacing[0] > 0.0)
    text << ", " << entry.spacing[0] << " x " << entry.spacing[1] << " x " << entry.spacing[2] << " mm";
  if (!entry.kernel.empty()) text << ", kernel " << entry.kernel;
  return text.str();
}

}  // namespace vallecula::pipeline
