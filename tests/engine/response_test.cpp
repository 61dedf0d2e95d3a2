// What the responses other than the implicit one promise, contact by contact.
#include "engine/contact/response.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/scene_data.h"
#include "engine/state.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine {
namespace {

Vec3 centre_of(const Scene& scene, const std::vector<Vec3>& displacement, const InnerSphere& sphere) {
  Vec3 centre = Vec3::Zero();
  for (int k = 0; k < sphere.tied_count; ++k) {
    const int node = scene.tree.tied_nodes[sphere.first_tied + k];
    centre += scene.tree.tied_weights[sphere.first_tied + k] * (scene.model.rest[node] + displacement[node]);
  }
  return centre;
}

// DESIGN 4.3: (c' - q) . n >= r + g. One sphere that is 0.1 mm in is put out by 0.1 mm: by no less, and by no more where its
// centre's tetrahedra share no node with the surface point beside it, nor once more in every further iteration. The force it
// reads is the mass moved times its way over h^2.
TEST(Projection, OneSphereIsPutExactlyOut) {
  SceneDescription d = testing::block_scene();
  d.soft = testing::box_body(Vec3(0.012, 0.012, 0.006), {12, 12, 8}, {6000.0, 0.45, 1040.0});  // cells below a radius
  const auto scene = build_scene(d);
  const double depth = 1e-4, h = scene->model.step_s;
  const Vec3 normal = Vec3(0.2, -0.3, -1).normalized();
  int looked_at = 0, apart = 0;
  for (std::size_t s = 0; s < scene->tree.spheres.size(); s += 7) {
    const InnerSphere& sphere = scene->tree.spheres[s];
    EXPECT_LT((centre_of(*scene, std::vector<Vec3>(scene->model.nodes, Vec3::Zero()), sphere) - sphere.centre).norm(), 1e-8);
    const auto& face = scene->surface.triangles[sphere.triangle];
    bool anchored = false, shared = false;
    for (int k = 0; k < sphere.tied_count; ++k) {
      const int node = scene->tree.tied_nodes[sphere.first_tied + k];
      anchored |= scene->model.anchor[node] >= 0;
      shared |= node == face[0] || node == face[1] || node == face[2];
    }
    if (anchored) continue;
    SceneState state(*scene);
    ContactConstraint& c = state.contacts.constraints[0];
    for (int k = 0; k < 4; ++k) {
      c.node[k] = face[std::min(k, 2)];
      c.weight[k] = static_cast<float>(k < 3 ? sphere.surface_weight[k] : 0.0);
    }
    c.normal = from_vec3(normal);
    c.gap = static_cast<float>(-depth);
    c.memory = static_cast<std::int32_t>(s);
    state.contacts.count = 1;
    StageTimes times;
    respond(Response::projection, scene->tree, scene->model, Pose{}, state.tissue, state.contacts, times);
    EXPECT_NEAR((centre_of(*scene, state.tissue.displacement, sphere) - sphere.centre).dot(normal), depth, 1e-8) << s;
    double momentum = 0.0;
    for (int i = 0; i < scene->model.nodes; ++i) momentum += scene->model.mass[i] * state.tissue.displacement[i].dot(normal);
    EXPECT_NEAR(c.multiplier, momentum / (h * h), 1e-3 * c.multiplier) << s;
    ++looked_at;
    apart += shared ? 0 : 1;
  }
  EXPECT_GT(looked_at, 20);
  EXPECT_GT(apart, 3) << "all the spheres looked at hang on the nodes of their surface point";
}

}  // namespace
}  // namespace vallecula::engine
