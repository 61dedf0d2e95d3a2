// The paper's experiments (section 4, figures 2, 3 and 6 to 8), run anew on a patient's tongue: plots and pictures
// (PNG) with their numbers beside them (JSON).
#pragma once

#include <QString>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "curricula/scenario.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

struct FigureSetting {
  pipeline::PatientPackage package;
  curricula::Scenario scenario;
  std::filesystem::path out;    ///< an existing folder
  std::function<void()> pulse;  ///< called again and again while a run goes on; ends it by throwing; may be empty
  double time_share = 1.0;      ///< of the times a hand slides and holds; tests take less
};

struct FigureResult {
  std::vector<std::string> files;  ///< written to `out`
  QString seen;                    ///< what is to be seen, with its figures
};

// All need a WindowApplication (fonts, OpenGL) and throw std::runtime_error naming what could not be done.

/// Figure 6: spheres against triangles in persistent contact: shapes, update rate, collision time.
FigureResult write_figure_6(const FigureSetting& setting);
/// Figure 7: a hand overshoots and lets go: penalty force against the force-aware response.
FigureResult write_figure_7(const FigureSetting& setting);
/// Figure 8: the pilot intubation by the scripted expert, and the ghost where the scripted novice overshoots.
FigureResult write_figure_8(const FigureSetting& setting);
/// Figures 2 and 3: the spheres in the tongue, by level; the paper's rule and full coverage.
FigureResult write_figure_spheres(const FigureSetting& setting);

}  // namespace vallecula::gui
