// The tongue's tetrahedra on a manikin: as many as asked for, of the right volume, well shaped, and marked where they
// are held and where they can be touched.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "pipeline/manikin/manikin.h"
#include "pipeline/mesh/anatomy_surfaces.h"
#include "pipeline/mesh/self_intersection.h"
#include "pipeline/mesh/tet_quality.h"
#include "pipeline/mesh/triangle_tree.h"
#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {
namespace {

/// The faces that belong to one tetrahedron only, looking outwards.
Surface border_of(const TetMesh& m) {
  constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::map<std::array<int, 3>, std::pair<int, std::array<int, 3>>> faces;
  for (const auto& t : m.tets) {
    for (const auto& f : kFaces) {
      const std::array<int, 3> face{t[f[0]], t[f[1]], t[f[2]]};
      auto key = face;
      std::sort(key.begin(), key.end());
      auto& entry = faces[key];
      ++entry.first;
      entry.second = face;
    }
  }
  Surface out;
  out.points = m.points;
  for (const auto& [key, entry] : faces) {
    if (entry.first == 1) out.triangles.push_back(entry.second);
  }
  return out;
}

void check_count_volume_and_shape(const Segmentation& s, const TetMesh& m, int wanted) {
  EXPECT_NEAR(static_cast<double>(m.tets.size()), wanted, 0.1 * wanted);
  const auto q = quality_of(m);
  double label = 0.0;
  for (const auto v : s.labels.voxels) label += v == kTongue || v == kEpiglottis ? 1.0 : 0.0;
  EXPECT_NEAR(q.volume_mm3 / (label * s.labels.grid.voxel_mm3()), 1.0, 0.01) << wanted;
  EXPECT_GT(q.smallest_dihedral_deg, wanted > 50000 ? 5.0 : 10.0) << wanted;
  EXPECT_TRUE(self_intersections(border_of(m)).empty()) << wanted;
}

void check_contacts(const Segmentation& s, const TetMesh& m) {
  const auto border = border_of(m);
  std::vector<std::uint8_t> outside(m.points.size(), 0);
  for (const auto& t : border.triangles) {
    for (const int v : t) outside[v] = 1;
  }
  const auto to_air = distance_to(s.airway.lumen);
  ASSERT_EQ(m.contact.size(), m.points.size());
  double furthest_free = 0.0;
  std::map<int, int> of;
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    ++of[m.contact[v]];
    EXPECT_EQ(outside[v] != 0, m.contact[v] != static_cast<int>(Contact::inside)) << v;
    if (m.contact[v] == static_cast<int>(Contact::free))
      furthest_free = std::max(furthest_free, value_at(to_air, m.points[v]));
  }
  EXPECT_GT(of[1], 100);
  EXPECT_GT(of[2], 50);
  EXPECT_LT(furthest_free, 2.5) << "what can be touched borders the air";
}

void check_anchors(const Segmentation& s, const TetMesh& m) {
  const auto to_jaw = distance_to(s.bones.mandible);
  const auto to_hyoid = distance_to(s.bones.hyoid);
  const auto to_larynx = distance_to(where(s.labels, [](std::uint8_t v) { return v == kLarynx; }));
  std::map<int, double> furthest;
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    const auto& p = m.points[v];
    const int anchor = m.anchor[v];
    if (anchor == static_cast<int>(Anchor::free)) continue;
    const auto& field = anchor == 1 ? to_jaw : anchor == 2 ? to_hyoid : to_larynx;
    furthest[anchor] = std::max(furthest[anchor], value_at(field, p));
    if (anchor != static_cast<int>(Anchor::larynx)) {
      EXPECT_EQ(m.contact[v], static_cast<int>(Contact::tissue));
    }
  }
  // The floor of the mouth lies between the tongue and the jaw's bone.
  EXPECT_LT(furthest[1], 13.5);
  EXPECT_LT(furthest[2], 9.5);
  EXPECT_LT(furthest[3], 3.0);
  std::printf("held nodes at most %.2f mm from the jaw, %.2f from the hyoid, %.2f from the larynx\n", furthest[1],
              furthest[2], furthest[3]);
}

TEST(SoftMesh, HasTheCountTheVolumeAndTheMarksAskedFor) {
  const auto scan = scan_manikin(ManikinOptions{});
  const auto s = segment(scan.ct, {});
  const auto fields = fields_of(s);
  std::vector<int> counts{1000, 5000, 20000};
  if (std::getenv("VALLECULA_SLOW") != nullptr) counts.push_back(100000);
  for (const int wanted : counts) {
    const auto m = soft_mesh(s, fields, wanted);
    check_count_volume_and_shape(s, m, wanted);
    if (wanted != 5000) continue;
    check_contacts(s, m);
    check_anchors(s, m);
    EXPECT_EQ(m.points, soft_mesh(s, fields, wanted).points) << "the same again";
  }
}

}  // namespace
}  // namespace vallecula::pipeline
