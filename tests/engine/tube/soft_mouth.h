// A tongue, a tongue with an epiglottis, and tubes that press on them, tick by tick.
#pragma once

#include <cmath>

#include "engine/state.h"
#include "engine/tube/soft_contacts.h"
#include "tests/engine/box_mesh.h"
#include "tests/engine/tube/rods.h"
#include "tests/engine/tube/soft_loads.h"

namespace vallecula::engine::testing {

constexpr double kTop = 0.020;  // of the block, m

/// 40 x 40 x 20 mm, E 6000 Pa, fixed at its base; the blade far above it.
inline SceneDescription tongue_block(int cells = 16) {
  SceneDescription d = block_scene();
  d.soft = box_body(Vec3(0.04, 0.04, kTop), {cells, cells, cells / 2}, {6000.0, 0.45, 1040.0});
  d.tool.surface = box_surface(Vec3(0, 0, 0.5), Vec3(0.01, 0.01, 0.003));
  return d;
}

/// A block of tongue and, standing on it across x, a leaf of cartilage 9 mm wide and high, 1.5 mm thick.
inline SceneDescription tongue_with_leaf() {
  SceneDescription d = tongue_block();
  const SoftBodyDescription whole = box_body(Vec3(0.03, 0.03, 0.024), {20, 20, 16}, {6000.0, 0.45, 1040.0});
  SoftBodyDescription& soft = d.soft;
  soft = SoftBodyDescription{};
  soft.materials = {whole.materials[0], {200e3, 0.45, 1040.0}};
  soft.bodies = whole.bodies;
  std::vector<int> place(whole.nodes.size(), -1);
  for (const auto& tet : whole.tets) {
    const Vec3 at = (whole.nodes[tet[0]] + whole.nodes[tet[1]] + whole.nodes[tet[2]] + whole.nodes[tet[3]]) / 4;
    const bool leaf = at.z() > 0.015;
    if (leaf && (std::abs(at.x() - 0.01575) > 0.00075 || std::abs(at.y() - 0.015) > 0.0045)) continue;
    std::array<int, 4> corners;
    for (int k = 0; k < 4; ++k) {
      int& node = place[tet[k]];
      if (node < 0) {
        node = static_cast<int>(soft.nodes.size());
        soft.nodes.push_back(whole.nodes[tet[k]]);
        soft.node_anchor.push_back(whole.node_anchor[tet[k]]);
      }
      corners[k] = node;
    }
    soft.tets.push_back(corners);
    soft.tet_material.push_back(leaf ? 1 : 0);
    soft.tet_structure.push_back(leaf ? Structure::epiglottis : Structure::tongue);
  }
  return d;
}

/// Held `length` m from its tip, straight: the tests say where it lies by where the hand is.
inline Rod straight_tube(double length, const Stylet* stylet = nullptr) {
  RodDescription d = tube_rod(tube_design("3.5"), stylet, length);
  for (RodSection& s : d.section) s.natural_curvature_per_m = 0.0;
  return Rod(d);
}

/// So stiff that it is a rigid cylinder.
inline Rod rigid_tube(double radius) {
  RodDescription d = straight_rod(0.14);
  d.outer_radius_m = radius;
  for (RodSection& s : d.section) s = {100.0, 70.0, 0.0};
  return Rod(d);
}

/// The hand of a tube that points along -y, its axis through (x, z).
inline Pose along_y(double x, double hand_y, double z) {
  Pose hand;
  hand.position = Vec3(x, hand_y, z);
  hand.rotation = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ());
  return hand;
}

/// A scene with a tube in it, tick by tick.
struct Mouth {
  Mouth(const Scene& scene, const Rod& rod, const Pose& hand)
      : scene(scene), rod(rod), state(scene), soft(scene), tube(rod, hand), contacts(kMostSoftContacts) {}

  void tick(const Pose& hand) noexcept {
    count =
        find_soft_contacts(scene, state.tissue, rod, tube, outside_from_m, friction, soft, contacts.data(), capacity);
    on_hand = step(rod, tube, hand, contacts.data(), count, scene.model.step_s).on_hand;
    press_tissue(scene, tube, contacts.data(), soft);
    std::array<StructureLoad, kLoadedStructures> loads{};
    StageTimes times;
    step_tissue(scene, state, Pose{}, loads, times, &soft);
    load = soft_loads(scene, soft);
    on_tube.setZero();
    for (int i = 0; i < count; ++i) on_tube += contacts[i].force;
  }

  const Scene& scene;
  const Rod& rod;
  SceneState state;
  SoftContactState soft;
  RodState tube;
  std::vector<RodContact> contacts;
  double outside_from_m = 0.0, friction = 0.1;
  int capacity = kMostSoftContacts, count = 0;
  Wrench on_hand;
  SoftLoads load;
  Vec3 on_tube = Vec3::Zero();
};

/// From 0.5 mm above a depth of 0 to `depth` at `speed`, then still.
inline double down(double depth, double speed, double t) { return std::min(depth, speed * t - 0.0005); }

}  // namespace vallecula::engine::testing
