#include "gui/records_pages/trial_log_here.h"

#include <filesystem>
#include <stdexcept>

#include "gui/session/files.h"

namespace vallecula::gui {

curricula::TrialLog read_log_here(const curricula::RecordRow& row) {
  std::error_code error;
  if (!std::filesystem::exists(row.trial_path, error))
    throw std::runtime_error(
        "This trial's files are not on this computer: they are on the station it was done at, or were moved.");
  if (!row.log_sha256.empty() && sha256_of_file(row.trial_path) != row.log_sha256)
    throw std::runtime_error("The file at this trial's place is another trial's: it was recorded over, or changed.");
  return curricula::read_trial_log(row.trial_path);
}

}  // namespace vallecula::gui
