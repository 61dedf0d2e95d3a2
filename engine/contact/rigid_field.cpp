#include "engine/contact/rigid_field.h"

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>
#include <string>

namespace vallecula::engine {

namespace {

using Motion = SprungBody::Motion;

Mat3 cross_matrix(const Vec3& w) {
  Mat3 m;
  m << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return m;
}

}  // namespace

RigidField::RigidField(const RigidAnatomy& anatomy, const std::vector<SprungBody>& bodies, const Vec3& low,
                       const Vec3& high, double spacing, double band, const RigidField* sampled)
    : parts_(anatomy.parts) {
  if (parts_.size() > kMostRigidParts)
    throw std::invalid_argument("rigid anatomy: " + std::to_string(parts_.size()) + " moving parts; at most " +
                                std::to_string(kMostRigidParts) + " work");
  const auto& triangles = anatomy.surface.triangles;
  if (!anatomy.triangle_part.empty() && anatomy.triangle_part.size() != triangles.size())
    throw std::invalid_argument("rigid anatomy: a part is needed for each triangle, or for none");
  for (const RigidPart& part : parts_) {
    if (part.body < 0 || part.body >= static_cast<int>(bodies.size()) || !(part.share > 0 && part.share <= 1))
      throw std::invalid_argument("rigid anatomy: a part follows body " + std::to_string(part.body) +
                                  " by a share of " + std::to_string(part.share) +
                                  "; the body must exist, the share lie above 0 and up to 1");
    body_.push_back(bodies[static_cast<std::size_t>(part.body)]);
    reach_.push_back(0.0);
  }
  std::vector<std::uint8_t> classes(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const int part = anatomy.triangle_part.empty() ? -1 : anatomy.triangle_part[t];
    if (part < -1 || part >= part_count())
      throw std::invalid_argument("rigid anatomy: triangle " + std::to_string(t) + " names part " +
                                  std::to_string(part));
    classes[t] = static_cast<std::uint8_t>(static_cast<int>(anatomy.triangle_structure[t]) + kPartFactor * (part + 1));
    if (part < 0 || body_[static_cast<std::size_t>(part)].motion != Motion::hinge) continue;
    double& reach = reach_[static_cast<std::size_t>(part)];
    for (int v : triangles[t])
      reach = std::max(reach, (anatomy.surface.points[v] - body_[static_cast<std::size_t>(part)].pivot).norm());
  }
  grid_ = sampled != nullptr
              ? sampled->grid_
              : std::make_shared<const SignedDistanceGrid>(anatomy.surface, low, high, spacing, band, classes);
}

void RigidField::place(const std::vector<Vec3>& displacement, const std::vector<Vec3>& velocity,
                       PartPoses& poses) const noexcept {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    PartPose& pose = poses[p];
    const double share = parts_[p].share;
    const Vec3 q = share * displacement[parts_[p].body], v = share * velocity[parts_[p].body];
    if (body_[p].motion == Motion::translation) {
      pose.shift = q;
      pose.drift = v;
      pose.travel = q;
    } else if (body_[p].motion == Motion::hinge) {
      const Vec3 axis = body_[p].axis.normalized();
      pose.pivot = body_[p].pivot;
      pose.to_rest = (Mat3::Identity() + q[0] * cross_matrix(axis)).inverse();
      pose.spin = v[0] * axis;
      pose.travel = Vec3(q[0] * reach_[p], 0, 0);
    }
  }
}

Vec3 RigidField::lever(int part, const Vec3& rest, const Vec3& n) const noexcept {
  const std::size_t p = static_cast<std::size_t>(part);
  switch (body_[p].motion) {
    case Motion::translation:
      return parts_[p].share * n;
    case Motion::hinge:
      return Vec3(parts_[p].share * n.dot(body_[p].axis.normalized().cross(rest - body_[p].pivot)), 0, 0);
    case Motion::fixed:
      break;
  }
  return Vec3::Zero();
}

}  // namespace vallecula::engine
