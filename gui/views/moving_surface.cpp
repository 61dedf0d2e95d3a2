#include "gui/views/moving_surface.h"

#include <vtkPoints.h>

namespace vallecula::gui {

namespace {

constexpr double kOnLip = 0.6;  // mm: a cut's points lie beside the face's, the airway's have a mesh of their own

}  // namespace

MovingSurface::MovingSurface(vtkPolyData* surface, const AnatomyMotion& motion, Kind kind)
    : surface_(surface), motion_(&motion), kind_(kind) {
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    Follower f;
    f.point = i;
    surface->GetPoint(i, f.rest.data());
    f.with_jaw = motion.with_jaw(f.rest);
    f.with_larynx = motion.with_larynx(f.rest);
    const auto lip = motion.on_lips(f.rest, kOnLip);
    f.lip = lip.triangle < 0 ? std::array<int, 3>{-1, -1, -1}
                             : motion.lips().triangles[static_cast<std::size_t>(lip.triangle)];
    f.weight = lip.weights;
    if (f.with_jaw > 0.0 || f.with_larynx > 0.0 || f.lip[0] >= 0) followers_.push_back(f);
  }
}

void MovingSurface::update(const engine::Snapshot& snapshot) {
  const auto& bodies = snapshot.body_displacement;
  if (followers_.empty() || bodies.size() <= kLarynxBody) return;
  const auto& lips = snapshot.lip_displacement;
  for (const Follower& f : followers_) {
    engine::Vec3 p = motion_->displaced(f.rest, f.with_jaw, f.with_larynx, bodies);
    if (f.lip[0] >= 0 && lips.size() == motion_->lips().points.size())
      for (int k = 0; k < 3; ++k) p += 1000.0 * f.weight[k] * lips[static_cast<std::size_t>(f.lip[k])];
    if (kind_ == Kind::cut) p.x() = f.rest.x();
    surface_->GetPoints()->SetPoint(f.point, p.data());
  }
  surface_->GetPoints()->Modified();
  surface_->Modified();
}

}  // namespace vallecula::gui
