// The shipped face over a patient's: outside it is the shipped one, inside everything is as it was.
#include "pipeline/mesh/generic_face.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/manikin/manikin.h"
#include "pipeline/manikin/shapes.h"
#include "pipeline/mesh/anatomy_surfaces.h"
#include "pipeline/mesh/surface_check.h"

namespace vallecula::pipeline {
namespace {

bool within(std::uint8_t label) { return label != kBackground && label != kSkin; }

TEST(GenericFace, IsTheShippedOneOutsideAndLeavesWhatIsWithin) {
  ManikinOptions options;
  options.weight_kg = 1.2;
  options.seed = 2;
  auto s = segment(scan_manikin(options).ct, {});
  const auto before = s.labels;
  give_generic_face(s);

  for (std::size_t i = 0; i < before.voxels.size(); ++i) {
    ASSERT_EQ(within(before.voxels[i]) ? before.voxels[i] : 0, within(s.labels.voxels[i]) ? s.labels.voxels[i] : 0);
    ASSERT_EQ(s.labels.voxels[i] != kBackground, s.head.inside.voxels[i] != 0) << "labels and the head agree";
  }
  const auto face = surfaces_of(s, fields_of(s)).at("face");
  EXPECT_EQ(facts_of(face).fault, "");

  // Points of the surface that are far from the lips, over the neck, and not where bone or airway hold the skin off.
  const double k = s.frame.scale;
  const auto gum = s.landmarks.at("upper_gum_midline");
  const auto to_inner = distance_to(where(s.labels, within));
  const auto shapes = manikin::face_shapes(manikin::vary(0));
  int looked_at = 0;
  int forehead = 0;
  for (std::size_t t = 0; t < face.triangles.size(); ++t) {
    if (face.tissue[t] != static_cast<std::uint8_t>(Tissue::skin)) continue;
    const auto& p = face.points[face.triangles[t][0]];
    const double lips = std::hypot(p[0] - gum[0], p[1] - gum[1], p[2] - (gum[2] - 10.0 * k));
    if (lips < 40.0 * k || p[2] < s.landmarks.at("glottis_centre")[2] + 20.0 * k || value_at(to_inner, p) < 4.0 * k)
      continue;
    const double off = k * shapes.head({(p[0] - gum[0]) / k, (p[1] - gum[1]) / k, (p[2] - gum[2]) / k});
    EXPECT_LT(std::abs(off), 1.3) << p[0] << ' ' << p[1] << ' ' << p[2];
    ++looked_at;
    forehead += p[2] > gum[2] + 25.0 * k ? 1 : 0;
  }
  EXPECT_GT(looked_at, 500);
  std::printf("[ figures  ] %d points of the outside, %d of them over the nose\n", looked_at, forehead);
}

TEST(GenericFace, ALabelMapWithoutAFaceHasTheSameSkinWhateverThePatientsWas) {
  Grid grid;
  grid.size = {41, 21, 21};
  Labels labels(grid, kSkin);
  labels.at(10, 10, 10) = kSkull;
  labels.at(11, 10, 10) = kAirway;
  auto thin = labels;  // the patient's skin ends 2 mm behind the bone
  for (std::size_t i = 0; i < thin.voxels.size(); ++i) {
    if (thin.voxels[i] == kSkin && grid.position(i)[0] < 8.5) thin.voxels[i] = kBackground;
  }
  ASSERT_EQ(thin.at(8, 10, 10), kBackground);
  const auto out = without_face(labels, 2.0);  // 6 mm
  EXPECT_EQ(without_face(thin, 2.0).voxels, out.voxels) << "nothing of where the skin ended is left";
  EXPECT_EQ(without_face(thin, 2.0).at(4, 10, 10), kSkin) << "background within reach becomes skin";
  EXPECT_EQ(out.at(3, 10, 10), kBackground);
  EXPECT_EQ(out.at(11, 10, 10), kAirway);
  EXPECT_EQ(out.at(10, 10, 10), kSkull);
  EXPECT_EQ(out.at(17, 10, 10), kSkin);
  EXPECT_EQ(out.at(18, 10, 10), kBackground);
  EXPECT_EQ(out.at(40, 10, 10), kBackground);
}

}  // namespace
}  // namespace vallecula::pipeline
