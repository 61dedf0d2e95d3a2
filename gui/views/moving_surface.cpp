#include "gui/views/moving_surface.h"

#include <vtkPoints.h>

namespace vallecula::gui {

MovingSurface::MovingSurface(vtkPolyData* surface, const AnatomyMotion& motion) : surface_(surface), motion_(&motion) {
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    engine::Vec3 p;
    surface->GetPoint(i, p.data());
    const double with_jaw = motion.with_jaw(p), with_larynx = motion.with_larynx(p);
    if (with_jaw > 0.0 || with_larynx > 0.0) followers_.push_back({i, p, with_jaw, with_larynx});
  }
}

void MovingSurface::update(const std::vector<engine::Vec3>& bodies) {
  if (followers_.empty() || bodies.size() <= kLarynxBody || bodies == shown_) return;
  shown_ = bodies;
  for (const Follower& f : followers_)
    surface_->GetPoints()->SetPoint(f.point, motion_->displaced(f.rest, f.with_jaw, f.with_larynx, bodies).data());
  surface_->GetPoints()->Modified();
  surface_->Modified();
}

}  // namespace vallecula::gui
