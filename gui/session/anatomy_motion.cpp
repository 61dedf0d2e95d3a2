#include "gui/session/anatomy_motion.h"

#include <algorithm>
#include <stdexcept>

#include "gui/session/package_parts.h"

namespace vallecula::gui {

namespace {

using engine::Vec3;
using pipeline::Tissue;

constexpr double kTermSizeMm = 50.3;  // mm, upper gum to vallecula of the term manikin
// Soft parts go with the jaw as far as its bone is nearer than the upper jaw's, and no farther off than this (assumed;
// term).
constexpr double kNearerFrom = 0.38, kNearerTo = 0.58;
constexpr double kWithBone = 7.0, kOffBone = 16.0;  // mm
// The larynx moves as one with the wall about it, and slides on the spine's (assumed; term).
constexpr double kWithGlottis = 8.0, kOffGlottis = 20.0;  // mm
constexpr double kAboutLips = 8.0;                        // mm of skin that a lip draws along
constexpr double kBackWall = 4.0;                         // mm behind the glottis' hind end

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// The face's lips, with what skin and mucosa lies within `about` (mm) of them.
engine::TriangleMesh lips_of(const pipeline::PatientPackage& package, double about) {
  const engine::TriangleMesh face = mesh_of(surface(package, "face"));
  const auto& tissue = package.surfaces.at("face").tissue;
  engine::TriangleMesh red{face.points, {}}, out;
  for (std::size_t t = 0; t < std::min(tissue.size(), face.triangles.size()); ++t)
    if (static_cast<Tissue>(tissue[t]) == Tissue::lip) red.triangles.push_back(face.triangles[t]);
  if (red.triangles.empty()) return out;
  const engine::TriangleBvh near(red);
  std::vector<int> kept(face.points.size(), -1);
  for (std::size_t t = 0; t < face.triangles.size(); ++t) {
    const auto kind = static_cast<Tissue>(tissue[t]);
    if (kind != Tissue::lip && kind != Tissue::skin && kind != Tissue::mucosa) continue;
    const auto& c = face.triangles[t];
    if (near.closest((face.points[c[0]] + face.points[c[1]] + face.points[c[2]]) / 3, about).triangle < 0) continue;
    std::array<int, 3> own;
    for (int k = 0; k < 3; ++k) {
      int& place = kept[static_cast<std::size_t>(c[k])];
      if (place < 0) {
        place = static_cast<int>(out.points.size());
        out.points.push_back(face.points[static_cast<std::size_t>(c[k])]);
      }
      own[k] = place;
    }
    out.triangles.push_back(own);
  }
  return out;
}

}  // namespace

double size_of(const pipeline::PatientPackage& package) {
  return (landmark(package, "vallecula") - landmark(package, "upper_gum_midline")).norm() / kTermSizeMm;
}

AnatomyMotion::AnatomyMotion(const pipeline::PatientPackage& package)
    : mandible_(mesh_of(surface(package, "mandible"))),
      upper_jaw_(mesh_of(surface(package, "palate"))),
      condyles_(landmark(package, "condyle_axis")),
      glottis_(landmark(package, "glottis_centre")),
      back_(glottis_.y()),
      size_(size_of(package)) {
  for (const Vec3& p : mesh_of(surface(package, "glottis")).points) back_ = std::max(back_, p.y());
  lips_ = lips_of(package, kAboutLips * size_);
  if (!lips_.triangles.empty()) lips_bvh_.emplace(lips_);
}

double AnatomyMotion::with_jaw(const Vec3& p) const {
  const double off = kOffBone * size_;
  const auto lower = mandible_.closest(p, off);
  if (lower.triangle < 0) return 0.0;
  // Where the upper jaw is farther than this the lower is nearer by all that counts.
  const double far = 2 * off,
               upper = upper_jaw_.closest(p, far).triangle < 0 ? far : upper_jaw_.closest(p, far).distance;
  const double nearer = upper / std::max(1e-6, upper + lower.distance);
  return smooth_step(kNearerFrom, kNearerTo, nearer) * (1.0 - smooth_step(kWithBone * size_, off, lower.distance));
}

double AnatomyMotion::with_larynx(const Vec3& p) const {
  return (1.0 - smooth_step(kWithGlottis * size_, kOffGlottis * size_, (p - glottis_).norm())) *
         (1.0 - smooth_step(back_ + 0.25 * kBackWall * size_, back_ + kBackWall * size_, p.y()));
}

engine::TriangleBvh::Hit AnatomyMotion::on_lips(const Vec3& p, double limit) const {
  return lips_bvh_ ? lips_bvh_->closest(p, limit) : engine::TriangleBvh::Hit{};
}

Vec3 AnatomyMotion::displaced(const Vec3& p, double with_jaw, double with_larynx,
                              const std::vector<Vec3>& bodies) const {
  return p + with_jaw * bodies[kMandibleBody].x() * Vec3::UnitX().cross(p - condyles_) +
         with_larynx * kLarynxShare * 1000.0 * bodies[kHyoidBody];
}

}  // namespace vallecula::gui
