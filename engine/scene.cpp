#include "engine/scene.h"

#include <cmath>
#include <cstring>
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

/// To the bit: what is made of the same is the same, and of nothing less.
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same(const TriangleMesh& a, const TriangleMesh& b) {
  return same(a.points, b.points) && same(a.triangles, b.triangles);
}

/// Nothing else of a soft body enters its sphere tree.
SoftBodyDescription shape_of(const SoftBodyDescription& soft) {
  SoftBodyDescription shape;
  shape.nodes = soft.nodes;
  shape.tets = soft.tets;
  shape.node_anchor = soft.node_anchor;
  return shape;
}

bool same_tree(const SceneDescription& a, const SceneDescription& b) {
  return same(a.soft.nodes, b.soft.nodes) && same(a.soft.tets, b.soft.tets) &&
         same(a.soft.node_anchor, b.soft.node_anchor) && a.coverage == b.coverage && a.sphere_ratio == b.sphere_ratio &&
         a.sphere_levels == b.sphere_levels;
}

std::shared_ptr<const SphereTree> sphere_tree(const SceneDescription& d, const SoftSurface& surface,
                                              const Scene* before, const std::function<void()>& between) {
  if (before != nullptr && same_tree(before->description, d)) return before->shared_tree;
  if (between) between();
  FillSettings settings;
  settings.coverage = d.coverage;
  settings.sphere_ratio = d.sphere_ratio;
  settings.levels = d.sphere_levels;
  return std::make_shared<const SphereTree>(fill_spheres(shape_of(d.soft), surface, settings));
}

std::shared_ptr<const ToolField> tool_field(const ToolDescription& tool, const Scene* before,
                                            const std::function<void()>& between) {
  if (before != nullptr) {
    const ToolDescription& other = before->description.tool;
    if (same(other.surface, tool.surface) && other.tissue_low == tool.tissue_low &&
        other.tissue_high == tool.tissue_high)
      return before->shared_tool;
  }
  if (between) between();
  return std::make_shared<const ToolField>(tool.surface, tool.tissue_low, tool.tissue_high);
}

/// Of the field's samples and of the box they lie in.
bool same_rigid(const SceneDescription& a, const SceneDescription& b) {
  return same(a.rigid.surface, b.rigid.surface) && same(a.rigid.triangle_structure, b.rigid.triangle_structure) &&
         same(a.rigid.triangle_part, b.rigid.triangle_part) && same(a.soft.nodes, b.soft.nodes);
}

RigidField rigid_field(const SceneDescription& d, const Scene* before, const std::function<void()>& between) {
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
  const RigidField* sampled = before != nullptr && same_rigid(before->description, d) ? &before->rigid : nullptr;
  if (between && sampled == nullptr) between();
  return RigidField(d.rigid, d.soft.bodies, low, high, kRigidSpacing, kRigidBand, sampled);
}

SkinField skin_field(const SceneDescription& d, const Scene* before, const std::function<void()>& between) {
  if (!d.intubation) return {};
  if (before != nullptr && before->description.intubation && same(before->description.rigid.surface, d.rigid.surface))
    return before->skin;
  if (between) between();
  return SkinField(d.rigid.surface);
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

Scene::Scene(const SceneDescription& d, const Scene* before, const std::function<void()>& between)
    : description(checked(d)),
      model(d.soft, d.step_s, d.hold_volume),
      surface(extract_surface(d.soft.tets)),
      shared_tree(sphere_tree(d, surface, before, between)),
      tree(*shared_tree),
      triangles(d.collision == Collision::triangles ? TriangleCollision(d.soft.nodes, surface, d.tool.surface)
                                                    : TriangleCollision()),
      shared_tool(tool_field(d.tool, before, between)),
      tool(*shared_tool),
      rigid(rigid_field(d, before, between)),
      skin(skin_field(d, before, between)),
      lips(d.lips, d.soft.bodies, d.step_s),
      sight(d.sight, d.soft.bodies),
      tube_areas(thinned_areas(tree, surface, d.soft.nodes, kTubePointSpacing)),
      proxy(proxy_settings(d)) {
  contact_stiffness = contact_stiffness_per_area(model, surface);
  if (d.intubation) intubation.emplace(*d.intubation, d.soft.bodies);
  for (const Vec3& p : model.rest) centre += p / static_cast<double>(model.nodes);
}

std::shared_ptr<const Scene> build_scene(const SceneDescription& description) {
  return build_scene(description, nullptr, {});
}

std::shared_ptr<const Scene> build_scene(const SceneDescription& description, const Scene* before,
                                         const std::function<void()>& between) {
  return std::make_shared<const Scene>(description, before, between);
}

}  // namespace vallecula::engine
