#include "gui/session/trial_results.h"

#include "gui/report/force_chart.h"
#include "gui/report/report.h"
#include "gui/session/files.h"

namespace vallecula::gui {

void write_results(const std::filesystem::path& folder, const curricula::TrialLog& log,
                   const curricula::Scenario& scenario, const curricula::Score& score) {
  write_file_whole(folder / "score.json", curricula::score_to_json(score, log, scenario) + "\n");
  write_force_chart(folder / "force.png", log, scenario, score);
  write_report(folder, log, scenario, score);
}

}  // namespace vallecula::gui
