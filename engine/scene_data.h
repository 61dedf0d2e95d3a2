// The scene as the engine steps it: everything precomputed from the description and never changed again.
#pragma once

#include "engine/aist/thinned_areas.h"
#include "engine/contact/lips.h"
#include "engine/contact/rigid_field.h"
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
  explicit Scene(const SceneDescription& description);

  SceneDescription description;
  TissueModel model;
  SoftSurface surface;
  SphereTree tree;
  TriangleCollision triangles;   ///< only where the description asks for it
  ToolField tool;
  RigidField rigid;              ///< empty (nothing inside) without rigid anatomy
  Lips lips;
  LineOfSight sight;
  std::vector<float> tube_areas;   ///< of the tree's points that a tube meets (thinned_areas.h)
  ProxySettings proxy;
  std::optional<Intubation> intubation;
  float contact_stiffness = 0.0f;  ///< N/m^3
  Vec3 centre = Vec3::Zero();      ///< of the tissue at rest: device poses are clamped to a ball around it
};

}  // namespace vallecula::engine
