#include "engine/contact/skin_field.h"

namespace vallecula::engine {

SkinField::SkinField(const TriangleMesh& head) {
  if (head.triangles.empty()) return;
  Vec3 low = head.points[static_cast<std::size_t>(head.triangles.front()[0])], high = low;
  for (const auto& triangle : head.triangles)
    for (const int v : triangle) {
      low = low.cwiseMin(head.points[static_cast<std::size_t>(v)]);
      high = high.cwiseMax(head.points[static_cast<std::size_t>(v)]);
    }
  const Vec3 margin = Vec3::Constant(kBand);
  grid_ = std::make_shared<const SignedDistanceGrid>(head, low - margin, high + margin, kSpacing, kBand);
}

}  // namespace vallecula::engine
