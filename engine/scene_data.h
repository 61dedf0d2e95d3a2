// The scene as the engine steps it: everything precomputed from the description and never changed again.
#pragma once

#include <functional>

#include "engine/aist/thinned_areas.h"
#include "engine/contact/lips.h"
#include "engine/contact/rigid_field.h"
#include "engine/contact/skin_field.h"
#include "engine/contact/tool_field.h"
#include "engine/contact/triangle_contact.h"
#include "engine/haptics/proxy.h"
#include "engine/scene.h"
#include "engine/sight/line_of_sight.h"
#include "engine/tissue/tissue_model.h"
#include "engine/tube/intubation_data.h"

namespace vallecula::engine {

class Scene {
 public:
  /// As build_scene() below.
  explicit Scene(const SceneDescription& description, const Scene* before = nullptr,
                 const std::function<void()>& between = {});
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  SceneDescription description;
  TissueModel model;
  SoftSurface surface;
  std::shared_ptr<const SphereTree> shared_tree;  ///< with other scenes of the same tissue at rest
  const SphereTree& tree;
  TriangleCollision triangles;   ///< only where the description asks for it
  std::shared_ptr<const ToolField> shared_tool;   ///< with other scenes of the same tool
  const ToolField& tool;
  RigidField rigid;              ///< empty (nothing inside) without rigid anatomy
  SkinField skin;                ///< likewise; and without an intubation, which alone asks for it
  Lips lips;
  LineOfSight sight;
  std::vector<float> tube_areas;   ///< of the tree's points that a tube meets (thinned_areas.h)
  ProxySettings proxy;
  std::optional<Intubation> intubation;
  float contact_stiffness = 0.0f;  ///< N/m^3
  Vec3 centre = Vec3::Zero();      ///< of the tissue at rest: device poses are clamped to a ball around it
};

/// As build_scene(description), to the bit, but what `before` (may be null) made of the very same input is shared with
/// it instead of made again: sphere tree and distance fields, nearly all of the time. `between` (may be empty) is
/// called before each of these that is made, and may throw, to leave.
std::shared_ptr<const Scene> build_scene(const SceneDescription& description, const Scene* before,
                                         const std::function<void()>& between);

}  // namespace vallecula::engine
