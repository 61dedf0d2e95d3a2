#include "gui/session/failure_kind.h"

#include <filesystem>
#include <new>

#include "curricula/records/location.h"
#include "curricula/scenario.h"
#include "curricula/trial_log.h"
#include "device/trajectory.h"
#include "pipeline/dicom/series_error.h"
#include "pipeline/import.h"
#include "pipeline/mesh/tetrahedralize.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {
namespace {

template <class... Kinds>
bool is_one_of(const std::exception& error) {
  return ((dynamic_cast<const Kinds*>(&error) != nullptr) || ...);
}

}  // namespace

std::string failure_kind(const std::exception& error) {
  if (is_one_of<pipeline::PackageError>(error)) return "the patient's package";
  if (is_one_of<pipeline::ImportError, pipeline::SeriesError, pipeline::TetrahedralizeError>(error))
    return "making the patient";
  if (is_one_of<curricula::CurriculumError>(error)) return "the course";
  if (is_one_of<curricula::RecordsError>(error)) return "the records";
  if (is_one_of<curricula::TrialLogError>(error)) return "the trial's log";
  if (is_one_of<device::DeviceError>(error)) return "the device";
  if (is_one_of<std::filesystem::filesystem_error>(error)) return "a file";
  if (is_one_of<std::bad_alloc>(error)) return "memory";
  return "another cause";
}

}  // namespace vallecula::gui
