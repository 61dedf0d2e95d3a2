// Elastic forces against analytic elasticity and against finite differences of the energy.
#include "engine/tissue/elasticity.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "engine/mesh/soft_mesh.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine {
namespace {

TissueState deformed(const TissueModel& model, const Mat3& gradient) {
  TissueState state(model);
  for (int i = 0; i < model.nodes; ++i) state.displacement[i] = (gradient - Mat3::Identity()) * model.rest[i];
  return state;
}

// A uniform small strain has the stress of Hooke's law: the block's top face is pulled with exactly sigma_zz A, and no
// node inside feels a force (patch test).
TEST(Elasticity, UniformStrainGivesHookesStress) {
  for (double poisson : {0.0, 0.3, 0.45, 0.49}) {
    auto soft = testing::box_body(Vec3(0.03, 0.02, 0.015), {4, 3, 3}, {6000.0, poisson, 1040.0});
    const TissueModel model(soft, 0.001);
    const double strain = 1e-4;  // small: the law is Hooke's only to first order
    const Mat3 gradient = Eigen::Vector3d(1 - poisson * strain, 1 - poisson * strain, 1 + strain).asDiagonal();
    TissueState state = deformed(model, gradient);  // uniaxial stress: sigma = E strain
    for (int i = 0; i < 5; ++i) elastic_forces(model, state);
    Vec3 top = Vec3::Zero();
    double inside = 0.0, side = 0.0;
    for (int i = 0; i < model.nodes; ++i) {
      const Vec3 &p = model.rest[i], f = to_vec3(state.force[i].v);
      const bool x = p.x() == 0 || p.x() > 0.0299, y = p.y() == 0 || p.y() > 0.0199;
      if (p.z() > 0.0149) {
        top += f;
      } else if (p.z() > 0 && !x && !y) {
        inside = std::max(inside, f.norm());
      } else if (p.z() > 0) {
        side = std::max(side, f.norm());
      }
    }
    const double expected = -6000.0 * strain * 0.03 * 0.02;  // the tissue pulls back
    EXPECT_NEAR(top.z(), expected, 0.005 * std::abs(expected)) << "nu " << poisson;
    EXPECT_LT(inside, 0.002 * std::abs(expected)) << "nu " << poisson;
    EXPECT_LT(side, 0.01 * std::abs(expected)) << "nu " << poisson;
  }
}

TEST(Elasticity, RigidMotionGivesNoForce) {
  auto soft = testing::box_body(Vec3(0.03, 0.02, 0.015), {4, 3, 3}, {6000.0, 0.45, 1040.0});
  const TissueModel model(soft, 0.001);
  const Mat3 turn = Eigen::AngleAxisd(1.9, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
  TissueState state = deformed(model, turn);
  for (int i = 0; i < 20; ++i) elastic_forces(model, state);
  for (int i = 0; i < model.nodes; ++i) EXPECT_LT(to_vec3(state.force[i].v).norm(), 2e-6) << i;
}

TEST(Elasticity, ForceIsTheEnergysDerivative) {
  auto soft = testing::box_body(Vec3(0.02, 0.02, 0.02), {2, 2, 2}, {6000.0, 0.45, 1040.0});
  const TissueModel model(soft, 0.001);
  TissueState state(model);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> way(-0.0015, 0.0015);
  for (Vec3& u : state.displacement) u = Vec3(way(random), way(random), way(random));
  for (int i = 0; i < 30; ++i) elastic_forces(model, state);
  std::vector<Vec3> force;
  for (int i = 0; i < model.nodes; ++i) force.push_back(to_vec3(state.force[i].v));
  double largest = 0.0;
  for (const Vec3& f : force) largest = std::max(largest, f.norm());
  constexpr double kStep = 2e-5;  // m; the energy is summed from single precision, so the step must not be tiny
  for (int i : {0, 5, 13, 20, 26})
    for (int a = 0; a < 3; ++a) {
      const double x = state.displacement[i][a];
      state.displacement[i][a] = x + kStep;
      const double up = elastic_energy(model, state);
      state.displacement[i][a] = x - kStep;
      const double down = elastic_energy(model, state);
      state.displacement[i][a] = x;
      EXPECT_NEAR(force[i][a], -(up - down) / (2 * kStep), 0.01 * largest) << "node " << i << " axis " << a;
    }
}

TEST(Elasticity, RefreshedStiffnessEqualsAssembledAnew) {
  auto soft = testing::box_body(Vec3(0.02, 0.02, 0.02), {3, 3, 3}, {6000.0, 0.45, 1040.0});
  const TissueModel model(soft, 0.001);
  TissueState state = deformed(model, Eigen::AngleAxisd(0.7, Vec3(0.3, 1, 0.2).normalized()).toRotationMatrix());
  for (int i = 0; i < 10; ++i) elastic_forces(model, state);
  refresh_stiffness(model, state, model.tets, model.tets + 8);
  const std::vector<BlockPair> refreshed = state.stiffness;
  assemble_stiffness(model, state);
  for (std::size_t b = 0; b < refreshed.size(); ++b)
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 8; ++r) EXPECT_NEAR(refreshed[b].column[c][r], state.stiffness[b].column[c][r], 0.02) << b;
}

TEST(SoftMesh, BadBodiesAreRefusedWithTheNumber) {
  auto good = testing::box_body(Vec3(0.02, 0.02, 0.02), {2, 2, 2}, {6000.0, 0.45, 1040.0});
  const auto refused = [](SoftBodyDescription soft) -> std::string {
    try {
      check_soft_body(soft);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(refused(good), "");
  auto bad = good;
  std::swap(bad.tets[3][0], bad.tets[3][1]);
  EXPECT_NE(refused(bad).find("tetrahedron 3"), std::string::npos);
  bad = good;
  bad.materials[0].poisson = 0.5;
  EXPECT_NE(refused(bad).find("0.5"), std::string::npos);
  bad = good;
  bad.materials[0].young_pa = -1;
  EXPECT_NE(refused(bad).find("-1"), std::string::npos);
  bad = good;
  bad.nodes[4].x() = std::nan("");
  EXPECT_NE(refused(bad).find("node 4"), std::string::npos);
  bad = good;
  bad.nodes.push_back(Vec3::Zero());
  bad.node_anchor.push_back(-1);
  EXPECT_NE(refused(bad).find("no tetrahedron"), std::string::npos);
}

}  // namespace
}  // namespace vallecula::engine
