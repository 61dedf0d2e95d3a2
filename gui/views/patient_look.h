// A patient package made ready for drawing: coloured, shaded, smooth. Made once per patient, off the window's thread.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
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

constexpr const char *kTracheaNatural = "Natural", *kTracheaBlue = "Blue";

struct PatientLook {
  vtkSmartPointer<vtkPolyData> face;     ///< points mm, normals, colours
  /// What of it a camera in the mouth may see, whichever way it faces: of the same points.
  vtkSmartPointer<vtkPolyData> around_mouth;
  /// What of it the operator's eye may meet in a view that the mouth fills: likewise of the same points.
  vtkSmartPointer<vtkPolyData> seen_close;
  /// Wall below the glottis, seen from inside; its colours by name: kTracheaNatural, kTracheaBlue.
  vtkSmartPointer<vtkPolyData> trachea;
  std::unique_ptr<SoftSurface> soft;     ///< tongue and epiglottis
  std::unique_ptr<AnatomyMotion> motion;
  std::vector<MovingSurface> moving;     ///< face and trachea
  Framing framing;
  pipeline::PatientPackage package;  ///< what it was made from

  /// Everything as it lies in the snapshot. Several views show one look: who comes second finds it done.
  void update(const engine::Snapshot& snapshot);

 private:
  std::vector<float> shown_soft_;
  std::vector<engine::Vec3> shown_bodies_, shown_lips_;
};

/// From where: what the operator's own eye never meets need not be drawn for it.
enum class Seen { from_the_eye, all_round };

/// Throws std::runtime_error naming the surface or landmark that is missing. `progress(stage, 0..1)` may be empty.
/// `folder`: where the package lies; its labels then give the tongue's fine surface. Left out, or where they cannot be
/// read or do not lie where the tetrahedra are, the tetrahedra's boundary is drawn, rounded.
std::shared_ptr<PatientLook> make_patient_look(pipeline::PatientPackage package,
                                               const std::function<void(const std::string&, double)>& progress = {},
                                               Seen seen = Seen::from_the_eye,
                                               const std::filesystem::path& folder = {});

/// A package surface as VTK has it (mm).
vtkSmartPointer<vtkPolyData> to_poly_data(const pipeline::Surface& surface);

}  // namespace vallecula::gui
