// A patient package made ready for drawing: coloured, shaded, smooth. Made once per patient, off the window's thread.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <memory>
#include <string>

#include "gui/session/anatomy_motion.h"
#include "gui/views/moving_surface.h"
#include "gui/views/soft_surface.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// Where to look and how wide, from the package's landmarks and lips. mm, LPS.
struct Framing {
  pipeline::Point eye{};
  pipeline::Point mouth{};   ///< middle of the opening between the lips
  pipeline::Point inside{};  ///< what matters once the blade is in: on the way from the mouth to the glottis
  pipeline::Point glottis{};
  double face_mm = 100.0;  ///< what the view shows of the face, across, at the mouth
  double mouth_mm = 45.0;  ///< what it shows of the mouth once the blade is in
  double midline_x_mm = 0.0;
};

struct PatientLook {
  vtkSmartPointer<vtkPolyData> face;     ///< points mm, normals, colours
  vtkSmartPointer<vtkPolyData> trachea;  ///< wall below the glottis, seen from inside, the paper's blue
  std::unique_ptr<SoftSurface> soft;     ///< tongue and epiglottis
  std::unique_ptr<AnatomyMotion> motion;
  std::vector<MovingSurface> moving;     ///< face and trachea
  Framing framing;
  pipeline::PatientPackage package;  ///< what it was made from

  /// Everything as it lies in the snapshot.
  void update(const engine::Snapshot& snapshot);
};

/// From where: what the operator's own eye never meets need not be drawn for it.
enum class Seen { from_the_eye, all_round };

/// Throws std::runtime_error naming the surface or landmark that is missing. `progress(stage, 0..1)` may be empty.
std::shared_ptr<PatientLook> make_patient_look(pipeline::PatientPackage package,
                                               const std::function<void(const std::string&, double)>& progress = {},
                                               Seen seen = Seen::from_the_eye);

/// A package surface as VTK has it (mm).
vtkSmartPointer<vtkPolyData> to_poly_data(const pipeline::Surface& surface);

}  // namespace vallecula::gui
