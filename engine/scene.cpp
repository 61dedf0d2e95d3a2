#include "engine/scene.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/contact/response.h"
#include "engine/scene_data.h"

namespace vallecula::engine {

namespace {

constexpr double kRigidSpacing = 0.0007, kRigidBand = 0.005;
constexpr double kTubePointSpacing = 0.0009;  // between the points of the tissue that a tube meets
constexpr double kRigidMargin = 0.012;  // the rigid field reaches this far beyond the tissue at rest

void check(const SceneDescription& d) {
  const auto positive = [](double value, const char* what, const char* unit) {
    if (!(value > 0) || !std::isfinite(value))
      throw std::invalid_argument(std::string(what) + " is " + std::to_string(value) + " " + unit + "; it must be above 0");
  };
  positive(d.step_s, "the step", "s");
  positive(d.tool.mass_kg, "the tool's mass", "kg");
  positive(d.haptics.device_limit_n, "the device limit", "N");
  positive(d.haptics.coupling_stiffness_n_m, "the coupling stiffness", "N/m");
  positive(d.haptics.coupling_rotation_nm_rad, "the coupling's rotational stiffness", "N m/rad");
  positive(d.haptics.force_rate_n_s, "the force rate", "N/s");
  positive(d.haptics.limit_time_s, "the time over the limit", "s");
  if (!(d.friction >= 0) || !(d.friction <= 2))
    throw std::invalid_argument("the friction is " + std::to_string(d.friction) + "; it must lie between 0 and 2");
  positive(d.sphere_ratio, "the sphere ratio", "tetrahedron volumes");
  if (d.sphere_levels < 1 || d.sphere_levels > 6)
    throw std::invalid_argument("the sphere tree's grid has " + std::to_string(d.sphere_levels) + " levels; 1 to 6 work");
  const auto unit = [](const Vec3& v, const char* what) {
    if (!(std::abs(v.norm() - 1) < 1e-3))
      throw std::invalid_argument(std::string(what) + " has a length of " + std::to_string(v.norm()) + " instead of 1");
  };
  unit(d.sight.eye_right, "the eye's axis to the right");
  unit(d.sight.eye_up, "the eye's axis upwards");
  unit(d.neck.axis, "the neck's axis");
  if (!d.neck.joint.allFinite()) throw std::invalid_argument("the neck's joint is not finite");
  for (const NeckDescription::Carried& c : d.neck.carried)
    if (c.body < 0 || c.body >= static_cast<int>(d.soft.bodies.size()) || !c.at.allFinite() ||
        d.soft.bodies[static_cast<std::size_t>(c.body)].motion != SprungBody::Motion::translation)
      throw std::invalid_argument("the neck carries body " + std::to_string(c.body) + ", which is none that shifts");
  if (d.rigid.triangle_structure.size() != d.rigid.surface.triangles.size())
    throw std::invalid_argument("rigid anatomy: a structure is needed for each triangle");
}

RigidField rigid_field(const SceneDescription& d) {
  if (d.rigid.surface.triangles.empty()) return {};
  // Only where the blade can meet it: around the tissue and from the mouth's opening (the landmarks lie within).
  Vec3 low = d.soft.nodes.front(), high = low;
  for (const Vec3& p : d.soft.nodes) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 margin = Vec3::Constant(kRigidMargin);
  low -= margin;
  high += margin;
  for (std::size_t t = 0; t < d.rigid.surface.triangles.size(); ++t) {
    const Structure s = d.rigid.triangle_structure[t];
    if (s != Structure::gum && s != Structure::palate && s != Structure::teeth) continue;
    for (int v : d.rigid.surface.triangles[t]) {
      low = low.cwiseMin(d.rigid.surface.points[v] - 0.5 * margin);
      high = high.cwiseMax(d.rigid.surface.points[v] + 0.5 * margin);
    }
  }
  return RigidField(d.rigid, d.soft.bodies, low, high, kRigidSpacing, kRigidBand);
}

const SceneDescription& checked(const SceneDescription& d) {
  check(d);
  return d;
}

ProxySettings proxy_settings(const SceneDescription& d) {
  ProxySettings p;
  p.step_s = d.step_s;
  p.mass_kg = d.tool.mass_kg;
  p.stiffness_n_m = d.haptics.coupling_stiffness_n_m;
  p.rotation_nm_rad = d.haptics.coupling_rotation_nm_rad;
  p.force_limit_n = d.haptics.device_limit_n;
  return p;
}

}  // namespace

Scene::Scene(const SceneDescription& d)
    : description(checked(d)),
      model(d.soft, d.step_s, d.hold_volume),
      surface(extract_surface(d.soft.tets)),
      tree(fill_spheres(d.soft, surface, [&d] {
        FillSettings s;
        s.coverage = d.coverage;
        s.sphere_ratio = d.sphere_ratio;
        s.levels = d.sphere_levels;
        return s;
      }())),
      triangles(d.collision == Collision::triangles ? TriangleCollision(d.soft.nodes, surface, d.tool.surface)
                                                    : TriangleCollision()),
      tool(d.tool.surface, d.tool.tissue_low, d.tool.tissue_high),
      rigid(rigid_field(d)),
      lips(d.lips, d.soft.bodies, d.step_s),
      sight(d.sight, d.soft.bodies),
      tube_areas(thinned_areas(tree, surface, d.soft.nodes, kTubePointSpacing)),
      proxy(proxy_settings(d)) {
  contact_stiffness = contact_stiffness_per_area(model, surface);
  if (d.intubation) intubation.emplace(*d.intubation, d.soft.bodies);
  for (const Vec3& p : model.rest) centre += p / static_cast<double>(model.nodes);
}

std::shared_ptr<const Scene> build_scene(const SceneDescription& description) {
  return std::make_shared<const Scene>(description);
}

}  // namespace vallecula::engine
