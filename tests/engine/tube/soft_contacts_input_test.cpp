// The tube against soft tissue: canals, too many contacts, lost numbers, and what must stay as it is.
#include <gtest/gtest.h>

#include <limits>

#include "tests/engine/allocations.h"
#include "tests/engine/tube/soft_mouth.h"

namespace vallecula::engine {
namespace {

using namespace testing;

TEST(SoftContactInput, WhatLiesInACanalMeetsNothing) {
  const auto scene = build_scene(tongue_block());
  const Rod rod = straight_tube(0.05);
  const double touching = kTop + rod.description().outer_radius_m - 0.0005;
  const double from = 0.0213;
  Mouth mouth(*scene, rod, along_y(0.02, 0.055, touching));
  mouth.outside_from_m = from;
  mouth.tick(along_y(0.02, 0.055, touching));
  ASSERT_GT(mouth.count, 3);
  for (int i = 0; i < mouth.count; ++i)
    EXPECT_GE((mouth.soft.found[i].segment + mouth.soft.found[i].weight) * rod.segment_m(), from - 1e-9);
  mouth.outside_from_m = 0.05;
  mouth.tick(along_y(0.02, 0.055, touching));
  EXPECT_EQ(mouth.count, 0);
  // It comes out of the canal where the tissue is: no blow, and in the end it is pressed as if it had always been
  // there.
  mouth.outside_from_m = 0.0;
  Mouth other(*scene, rod, along_y(0.02, 0.055, touching + 0.002));
  double jump = 0.0, before = 0.0;
  for (int n = 0; n < 600; ++n) {
    mouth.tick(along_y(0.02, 0.055, touching));
    other.tick(along_y(0.02, 0.055, touching + 0.002 - std::min(0.002, 0.02 * 0.001 * n)));
    jump = std::max(jump, std::abs(mouth.load.tongue_n - before));
    before = mouth.load.tongue_n;
  }
  EXPECT_GT(mouth.load.tongue_n, 0.01);
  EXPECT_LT(jump, 0.3 * mouth.load.tongue_n);
  EXPECT_NEAR(mouth.load.tongue_n, other.load.tongue_n, 0.05 * other.load.tongue_n);
}

TEST(SoftContactInput, OfTooManyTheOnesThatPressAreKept) {
  const auto scene = build_scene(tongue_block());
  const Rod rod = straight_tube(0.05);
  const auto hand = [&](double t) {
    return along_y(0.02, 0.055, kTop + rod.description().outer_radius_m - down(0.003, 0.02, t));
  };
  Mouth mouth(*scene, rod, hand(0));
  mouth.capacity = 12;
  Vec3 low = Vec3::Constant(1e9), high = -low;
  int left_out = 0;
  for (int n = 0; n < 1000; ++n) {
    mouth.tick(hand(0.001 * n));
    ASSERT_LE(mouth.count, 12);
    for (int i = 1; i < mouth.count; ++i) ASSERT_LT(mouth.soft.found[i - 1].sphere, mouth.soft.found[i].sphere);
    left_out = std::max(left_out, mouth.soft.left_out);
    if (n < 700) continue;
    low = low.cwiseMin(mouth.load.force_n);
    high = high.cwiseMax(mouth.load.force_n);
  }
  EXPECT_GT(left_out, 3);
  EXPECT_GT(mouth.on_tube.z(), 0.05);
  EXPECT_LT((high - low).norm(), 0.1 * mouth.on_tube.z());
}

TEST(SoftContactInput, EqualTicksAreEqualBitForBitAndAllocateNothing) {
  const auto scene = build_scene(tongue_with_leaf());
  const Stylet stylet;
  const Rod rod = straight_tube(0.06, &stylet);
  const auto hand = [&](double t) { return along_y(0.008 + 0.05 * t, 0.065, 0.0175 + 0.005 * std::cos(9 * t)); };
  Mouth one(*scene, rod, hand(0)), two(*scene, rod, hand(0));
  const long before = allocations;
  int most = 0;
  for (int n = 0; n < 400; ++n) {
    one.tick(hand(0.001 * n));
    most = std::max(most, one.count);
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_GT(most, 10);
  for (int n = 0; n < 400; ++n) two.tick(hand(0.001 * n));
  EXPECT_TRUE(same_bits(one.tube, two.tube));
  for (int i = 0; i < scene->model.nodes; ++i)
    ASSERT_EQ(one.state.tissue.displacement[i], two.state.tissue.displacement[i]) << i;
  EXPECT_EQ(one.load.force_n, two.load.force_n);
}

// A tube that touches nothing changes nothing for the blade, whatever the response.
TEST(SoftContactInput, TheBladesContactsStayWhatTheyAre) {
  for (Response response : {Response::compliant, Response::projection, Response::penalty}) {
    SceneDescription d = tongue_block(10);
    d.tool.surface = box_surface(Vec3(0, 0, 0.0015), Vec3(0.014, 0.014, 0.003));
    d.response = response;
    const auto scene = build_scene(d);
    const Rod rod = straight_tube(0.05);
    RodState tube(rod, along_y(0.02, 0.055, 0.08));
    SceneState with(*scene), without(*scene);
    SoftContactState soft(*scene);
    std::vector<RodContact> contacts(kMostSoftContacts);
    Wrench last;
    for (int n = 0; n < 150; ++n) {
      Pose blade;
      blade.position = Vec3(0.02, 0.02, kTop + 0.001 - 2e-5 * n);
      for (SceneState* state : {&with, &without}) {
        const Pose before = state->proxy.pose;
        state->placed = true;
        state->proxy.pose = blade;
        std::array<StructureLoad, kLoadedStructures> loads{};
        StageTimes times;
        if (state == &with) {
          find_soft_contacts(*scene, with.tissue, rod, tube, 0.0, 0.1, soft, contacts.data(), kMostSoftContacts);
          press_tissue(*scene, tube, contacts.data(), soft);
        }
        step_tissue(*scene, *state, n == 0 ? blade : before, loads, times, state == &with ? &soft : nullptr);
      }
      ASSERT_EQ(with.tissue_wrench.force, without.tissue_wrench.force) << n;
    }
    EXPECT_GT(with.tissue_wrench.force.z(), 0.05);
  }
}

// Blade and tube press at once, some way apart: each is pressed back by itself.
TEST(SoftContactInput, BladeAndTubePressAtOnceWhateverTheResponse) {
  for (Response response : {Response::compliant, Response::projection, Response::penalty}) {
    SceneDescription d = tongue_block(10);
    d.tool.surface = box_surface(Vec3(0, 0, 0.0015), Vec3(0.010, 0.010, 0.003));
    d.response = response;
    const auto scene = build_scene(d);
    const Rod rod = straight_tube(0.05);
    const auto hand = [&](double t) {
      return along_y(0.03, 0.055, kTop + rod.description().outer_radius_m - down(0.002, 0.02, t));
    };
    Mouth mouth(*scene, rod, hand(0));
    mouth.state.placed = true;
    for (int n = 0; n < 400; ++n) {
      Pose& blade = mouth.state.proxy.pose;
      blade.position = Vec3(0.01, 0.02, kTop - std::min(0.0005, 1e-5 * n));
      mouth.tick(hand(0.001 * n));
    }
    EXPECT_GT(mouth.state.tissue_wrench.force.z(), 0.01) << static_cast<int>(response);
    EXPECT_GT(mouth.on_tube.z(), 0.03) << static_cast<int>(response);
    EXPECT_LT((mouth.on_tube + mouth.load.force_n).norm(), 0.02 * mouth.on_tube.norm()) << static_cast<int>(response);
  }
}

TEST(SoftContactInput, WhatIsNotFiniteIsLeftOut) {
  const auto scene = build_scene(tongue_block(10));
  const Rod rod = straight_tube(0.05);
  const Pose hand = along_y(0.02, 0.055, kTop + rod.description().outer_radius_m - 0.0005);
  Mouth mouth(*scene, rod, hand);
  for (int n = 0; n < 300; ++n) mouth.tick(hand);
  const double steady = mouth.load.tongue_n;
  EXPECT_GT(steady, 0.005);

  const double nan = std::numeric_limits<double>::quiet_NaN();
  RodState lost = mouth.tube;
  lost.position[3].y() = nan;
  const auto found = [&](const TissueState& tissue, const RodState& tube, double from) {
    const int count =
        find_soft_contacts(*scene, tissue, rod, tube, from, 0.1, mouth.soft, mouth.contacts.data(), kMostSoftContacts);
    for (int i = 0; i < count; ++i) {
      EXPECT_TRUE(std::isfinite(mouth.contacts[i].depth_m));
      EXPECT_TRUE(mouth.contacts[i].normal.allFinite() && mouth.contacts[i].surface_velocity.allFinite());
    }
    return count;
  };
  EXPECT_EQ(found(mouth.state.tissue, lost, 0.0), 0);
  EXPECT_EQ(found(mouth.state.tissue, mouth.tube, nan), 0);
  TissueState torn = mouth.state.tissue;
  const int whole = found(torn, mouth.tube, 0.0);
  EXPECT_GT(whole, 0);
  const auto& face = scene->surface.triangles[mouth.soft.constraints[0].triangle];
  for (int v : face) torn.displacement[v].x() = nan;
  const int rest = found(torn, mouth.tube, 0.0);
  EXPECT_LT(rest, whole);
  torn.fastest_m = nan;
  EXPECT_EQ(found(torn, mouth.tube, 0.0), 0);
  for (int n = 0; n < 300; ++n) mouth.tick(hand);
  EXPECT_NEAR(mouth.load.tongue_n, steady, 0.1 * steady);
}

}  // namespace
}  // namespace vallecula::engine
