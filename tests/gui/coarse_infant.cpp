#include "tests/gui/coarse_infant.h"

#include <unistd.h>

#include <stdexcept>
#include <string>

#include "gui/session/builtin_patient.h"
#include "pipeline/import.h"
#include "pipeline/manikin/manikin.h"

namespace vallecula::gui::test {

namespace fs = std::filesystem;

fs::path coarse_infant() {
  const curricula::ManikinSpec infant{3.2, 1};
  const fs::path folder = fs::path(VALLECULA_BINARY_DIR) / "tests" / "coarse-infant";
  const fs::path kept = folder / (builtin_patient_name(infant) + ".patient");  // named after this build too
  if (fs::exists(kept)) return kept;
  const fs::path work = folder / ("making-" + std::to_string(::getpid()));
  fs::create_directories(work);
  pipeline::ManikinOptions options;
  options.weight_kg = infant.weight_kg;
  options.seed = infant.seed;
  pipeline::write_manikin(options, work / "ct");
  pipeline::ImportOptions import;
  import.series = work / "ct";
  import.out = work / "infant.patient";
  import.tetrahedra = 1000;
  pipeline::import_series(import);
  std::error_code error;
  fs::rename(import.out, kept, error);
  fs::remove_all(work);
  if (error && !fs::exists(kept))  // another test may have been quicker
    throw std::runtime_error(kept.string() + ": " + error.message());
  return kept;
}

}  // namespace vallecula::gui::test
