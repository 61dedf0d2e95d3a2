#include "gui/session/package_parts.h"

#include <stdexcept>

namespace vallecula::gui {

engine::Vec3 landmark(const pipeline::PatientPackage& package, const char* name) {
  const auto found = package.landmarks.find(name);
  if (found == package.landmarks.end())
    throw std::runtime_error("patient '" + package.name + "': it has no landmark '" + name + "'; import it again");
  return engine::Vec3(found->second[0], found->second[1], found->second[2]);
}

const pipeline::Surface& surface(const pipeline::PatientPackage& package, const char* name) {
  const auto found = package.surfaces.find(name);
  if (found == package.surfaces.end() || found->second.triangles.empty())
    throw std::runtime_error("patient '" + package.name + "': it has no surface '" + name + "'; import it again");
  return found->second;
}

engine::TriangleMesh mesh_of(const pipeline::Surface& surface, double scale) {
  engine::TriangleMesh mesh;
  mesh.points.reserve(surface.points.size());
  for (const auto& p : surface.points) mesh.points.push_back(engine::Vec3(p[0], p[1], p[2]) * scale);
  mesh.triangles = surface.triangles;
  return mesh;
}

std::map<std::string, pipeline::Point> landmarks_in_metres(const pipeline::PatientPackage& package) {
  std::map<std::string, pipeline::Point> landmarks_m = package.landmarks;
  for (auto& [name, point] : landmarks_m)
    if (name != "glottis_normal")
      for (double& x : point) x *= 1e-3;
  return landmarks_m;
}

std::optional<curricula::Mouth> mouth_of(const pipeline::PatientPackage& package) {
  return curricula::mouth_from_landmarks(landmarks_in_metres(package));
}

}  // namespace vallecula::gui
