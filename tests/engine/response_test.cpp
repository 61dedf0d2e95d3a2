// What the responses other than the implicit one promise, contact by contact.
#include "engine/contact/response.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/lab/experiment.h"
#include "engine/scene_data.h"
#include "engine/state.h"
#include "engine/tissue/elasticity.h"
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
    respond(Response::projection, false, scene->tree, scene->model, Pose{}, state.tissue, state.contacts, times);
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

/// A block under a plate pressed in by `depth` with `projection`: by how much the most pressed of the tree's distances is short.
double most_pressed(double depth, bool hold, double* largest_way = nullptr) {
  SceneDescription d = testing::block_scene();
  d.response = Response::projection;
  d.sphere_distances = hold;
  const auto scene = build_scene(d);
  ExperimentSettings settings;
  settings.duration_s = 0.2;
  settings.measure_tissue = false;
  const auto pose = [&](double t) {
    Pose p;
    p.position = Vec3(0.015, 0.015, 0.015 - depth * std::min(1.0, t / 0.1));
    return p;
  };
  const auto result = run_experiment(*scene, pose, settings);
  std::vector<Vec3> moved;
  for (int i = 0; i < scene->model.nodes; ++i) moved.push_back(result.final_nodes[i] - scene->model.rest[i]);
  double most = 0.0;
  for (const SphereDistance& pair : scene->tree.distances) {
    const Vec3 between = centre_of(*scene, moved, scene->tree.spheres[pair.b]) - centre_of(*scene, moved, scene->tree.spheres[pair.a]);
    most = std::max(most, pair.rest - between.norm());
  }
  EXPECT_GT(scene->tree.distances.size(), 50u);
  if (largest_way) *largest_way = result.residual_m;
  return most;
}

// Paper 3.1: spheres that keep their distance. Pressed by 1 mm their distances are nearer to those at rest than without.
TEST(SphereDistances, PressedSpheresStayFurtherApart) {
  const double without = most_pressed(0.001, false), with = most_pressed(0.001, true);
  EXPECT_GT(without, 1e-5);
  EXPECT_LT(with, 0.8 * without);
}

TEST(SphereDistances, TissueAtRestStays) {
  double way = 1.0;
  most_pressed(-0.00001, true, &way);  // the plate is at the tissue without pressing it
  EXPECT_LT(way, 1e-9);
}

// A turned and shifted body is not pressed anywhere: no correction, beyond what the elastic law in single precision moves.
TEST(SphereDistances, RigidMotionMakesNoForce) {
  SceneDescription d = testing::block_scene();
  for (auto& anchor : d.soft.node_anchor) anchor = -1;
  const auto scene = build_scene(d);
  const Mat3 turn = Eigen::AngleAxisd(0.9, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  std::vector<Vec3> after[2];
  for (bool hold : {false, true}) {
    SceneState state(*scene);
    for (int i = 0; i < scene->model.nodes; ++i)
      state.tissue.displacement[i] = turn * scene->model.rest[i] + Vec3(0.01, 0.02, -0.005) - scene->model.rest[i];
    for (int i = 0; i < 40; ++i) elastic_forces(scene->model, state.tissue);  // finds the rotations
    assemble_stiffness(scene->model, state.tissue);
    ContactConstraint& c = state.contacts.constraints[0];  // one that is open: the distances are held while there is contact
    for (int k = 0; k < 4; ++k) {
      c.node[k] = scene->surface.triangles[0][std::min(k, 2)];
      c.weight[k] = k == 0 ? 1.0f : 0.0f;
    }
    c.normal = F4{0, 0, 1, 0};
    c.gap = 1.0f;
    c.memory = 0;
    state.contacts.count = 1;
    StageTimes times;
    for (int i = 0; i < 20; ++i)
      respond(Response::projection, hold, scene->tree, scene->model, Pose{}, state.tissue, state.contacts, times);
    after[hold] = state.tissue.displacement;
  }
  double most = 0.0;
  for (int i = 0; i < scene->model.nodes; ++i) most = std::max(most, (after[1][i] - after[0][i]).norm());
  EXPECT_LT(most, 2e-6);
}

}  // namespace
}  // namespace vallecula::engine
