// A scene that shares what an earlier one made: only of the very same input, and then it is the same scene to the bit.
#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include "engine/scene_data.h"
#include "tests/engine/mouth_scene.h"

namespace vallecula::engine {
namespace {

/// Built after `before`; how many of the long parts had to be made.
std::shared_ptr<const Scene> built(const SceneDescription& d, const Scene* before, int& made) {
  made = 0;
  return build_scene(d, before, [&made] { ++made; });
}

TEST(Scene, WhatIsMadeOfTheSameIsNotMadeAgain) {
  int made = 0;
  const SceneDescription d = testing::mouth_scene({4, 4, 2});
  const auto first = built(d, nullptr, made);
  EXPECT_EQ(made, 3) << "sphere tree, the tool's field, the rigid anatomy's";
  EXPECT_EQ(&built(d, first.get(), made)->tree, &first->tree);
  EXPECT_EQ(made, 0);
  const auto made_after = [&](auto&& change) {
    SceneDescription other = d;
    change(other);
    built(other, first.get(), made);
    return made;
  };
  EXPECT_EQ(made_after([](auto& o) { o.soft.materials[0].young_pa *= 1.2; }), 0);
  EXPECT_EQ(made_after([](auto& o) { o.soft.bodies[testing::kMouthJaw].stiffness *= 1.2; }), 0);
  EXPECT_EQ(made_after([](auto& o) { o.friction = 0.1; }), 0);
  EXPECT_EQ(made_after([](auto& o) { o.tool.surface.points[0].x() += 1e-9; }), 1);
  EXPECT_EQ(made_after([](auto& o) { o.tool.tissue_high.z() = 0.1; }), 1);
  EXPECT_EQ(made_after([](auto& o) { o.sphere_ratio = 11.0; }), 1);
  EXPECT_EQ(made_after([](auto& o) { o.sphere_levels = 3; }), 1);
  EXPECT_EQ(made_after([](auto& o) { o.coverage = Coverage::paper; }), 1);
  EXPECT_EQ(made_after([](auto& o) { o.soft.node_anchor.back() = 0; }), 1) << "what is touched";
  EXPECT_EQ(made_after([](auto& o) { std::swap(o.soft.tets[0], o.soft.tets[1]); }), 1);
  EXPECT_EQ(made_after([](auto& o) { o.soft.nodes.back().x() += 1e-9; }), 2) << "and the box of the rigid field";
  EXPECT_EQ(made_after([](auto& o) { o.rigid.surface.points[0].x() += 1e-9; }), 1);
  EXPECT_EQ(made_after([](auto& o) { o.rigid.triangle_structure[0] = Structure::palate; }), 1);
  EXPECT_EQ(made_after([](auto& o) { o.rigid.triangle_part[0] = -1; }), 1);
  EXPECT_EQ(made_after([](auto& o) { o.rigid.triangle_part.clear(); }), 1);
}

TEST(Scene, SharingChangesNoBit) {
  SceneDescription d = testing::mouth_scene({4, 4, 2});
  const auto first = build_scene(d);
  d.soft.materials[0].young_pa *= 1.2;
  d.soft.bodies[testing::kMouthJaw].stiffness *= 1.2;
  int made = 0;
  const auto shared = built(d, first.get(), made), alone = build_scene(d);
  ASSERT_EQ(made, 0);
  testing::LateLoop one(*shared), other(*alone), softer(*first);
  bool differs = false;
  for (std::int64_t n = 0; n < static_cast<std::int64_t>(1000 * testing::kTourTime); ++n) {
    PortInput in;
    in.pose = testing::tour(0.001 * static_cast<double>(n));
    const TickRecord a = one.tick(n, in), b = other.tick(n, in), c = softer.tick(n, in);
    ASSERT_EQ(std::memcmp(a.displayed_force_n.data(), b.displayed_force_n.data(), 24), 0) << n;
    for (int s = 0; s < kLoadedStructures; ++s)
      ASSERT_EQ(std::memcmp(a.loads[s].force_n.data(), b.loads[s].force_n.data(), 24), 0) << n;
    differs = differs || a.displayed_force_n != c.displayed_force_n;
  }
  EXPECT_TRUE(differs) << "the stiffer tissue was taken over, not the one before";
}

TEST(Scene, ItsMakingIsLeftBetweenTheParts) {
  struct Left : std::runtime_error {
    Left() : std::runtime_error("left") {}
  };
  int made = 0;
  EXPECT_THROW(build_scene(testing::mouth_scene({4, 4, 2}), nullptr,
                           [&made] {
                             if (++made == 2) throw Left();
                           }),
               Left);
  EXPECT_EQ(made, 2);
}

}  // namespace
}  // namespace vallecula::engine
