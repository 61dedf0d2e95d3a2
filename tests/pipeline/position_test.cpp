// A closed mouth opened and a head extended: against rigid motion, which needs no reference but itself.
#include "pipeline/pose/position.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "pipeline/import.h"
#include "pipeline/pose/bare_face.h"
#include "pipeline/segment/free_line.h"
#include "pipeline/segment/mouth_bounds.h"
#include "tests/pipeline/closed_manikin.h"

namespace vallecula::pipeline {
namespace {

double volume_mm3(const Segmentation& s, std::uint8_t label) {
  return static_cast<double>(std::count(s.labels.voxels.begin(), s.labels.voxels.end(), label)) *
         s.labels.grid.voxel_mm3();
}
double tongue_mm3(const Segmentation& s) { return volume_mm3(s, kTongue); }

TEST(Turn, IsRigidAndTakenBack) {
  const Turn turn{{1, 2, 3}, 0.3, {0, -1, 0.5}};
  const Vector3 a{4, 5, -6};
  const Vector3 b{-2, 9, 7};
  EXPECT_NEAR(distance(turn(a), turn(b)), distance(a, b), 1e-12);
  EXPECT_LT(distance(turn.back(turn(a)), a), 1e-12);
  // A chin in front of the joints goes down, and what hangs below them goes back.
  const Turn plain{{}, 0.2, {}};
  EXPECT_LT(plain({0, -10, 0})[2], -1.0);
  EXPECT_GT(plain({0, 0, -10})[1], 1.0);
}

/// One scan serves all questions (a process a test).
struct Closed {
  ManikinScan scan;
  Segmentation before;
  Segmentation after;
  PositionFacts facts;
};

void check_tongue_is_found_without_a_seed(const Closed& in) {
  EXPECT_TRUE(in.before.head.lips.empty()) << "the mouth is shut";
  // This one is stuffed to the cheeks, wider than bounds by rule reach: what is found is tongue, and more than half of
  // it.
  const auto labels = on_series_grid(in.before, in.scan.ct.grid);
  double found = 0.0;
  double truth = 0.0;
  double both = 0.0;
  for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
    const bool here = labels.voxels[i] == kTongue;
    const bool there = in.scan.labels.voxels[i] == kTongue;
    found += here ? 1.0 : 0.0;
    truth += there ? 1.0 : 0.0;
    both += here && there ? 1.0 : 0.0;
  }
  EXPECT_GT(both / found, 0.97);
  EXPECT_GT(both / truth, 0.5);
  EXPECT_EQ(in.before.findings.at("tongue").origin, Origin::inferred);
}

void check_jaw_moved_rigidly(const Closed& in) {
  // The centroid and the spread of its voxels go exactly as the turn says.
  const auto middle = [](const Mask& mask) {
    Vector3 sum{};
    double n = 0.0;
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
      if (mask.voxels[i] == 0) continue;
      sum = sum + mask.grid.position(i);
      n += 1.0;
    }
    return (1.0 / n) * sum;
  };
  EXPECT_LT(distance(in.facts.aim.jaw(middle(in.before.bones.mandible)), middle(in.after.bones.mandible)), 0.3);
  EXPECT_NEAR(
      static_cast<double>(count(in.after.bones.mandible)) / static_cast<double>(count(in.before.bones.mandible)), 1.0,
      0.05);
  // Each voxel of the moved jaw comes from within a voxel of the jaw.
  const auto near = dilated(in.before.bones.mandible, 0.9);
  std::size_t off = 0;
  const auto& g = in.after.bones.mandible.grid;
  for (std::size_t i = 0; i < g.count(); ++i) {
    if (in.after.bones.mandible.voxels[i] == 0) continue;
    const auto c = near.grid.nearest(in.facts.aim.jaw.back(g.position(i)));
    off += near.grid.contains(c[0], c[1], c[2]) && near.at(c[0], c[1], c[2]) != 0 ? 0 : 1;
  }
  EXPECT_EQ(off, 0u);
}

void check_skull_did_not_move(const Closed& in) {
  const auto& from = in.before.bones.skull;
  std::size_t seen = 0;
  std::size_t changed = 0;
  for (std::size_t i = 0; i < from.voxels.size(); ++i) {
    if (from.voxels[i] == 0) continue;
    const auto c = in.after.hu.grid.nearest(from.grid.position(i));
    ++seen;
    changed += in.after.hu.at(c[0], c[1], c[2]) != in.before.hu.voxels[i] ? 1 : 0;
  }
  // Where the jaw came into a joint's voxel the two share it.
  EXPECT_LT(static_cast<double>(changed), 0.002 * static_cast<double>(seen));
}

void check_mouth_is_open(const Closed& in) {
  EXPECT_GT(in.after.head.lips.size(), 20u);
  const double gap = distance(in.after.landmarks.at("upper_gum_midline"), in.after.landmarks.at("lower_gum_midline"));
  EXPECT_NEAR(gap, in.facts.aim.gap_mm, 2.0);
  EXPECT_EQ(components(in.after.airway.lumen).sizes.size(), 2u) << "one piece";
  // It reaches the lips and the trachea.
  const auto box = bounds_of(in.after.airway.lumen);
  const auto& g = in.after.airway.lumen.grid;
  EXPECT_LT(g.origin[1] + box.low[1] * g.spacing[1], in.after.landmarks.at("upper_gum_midline")[1] + 1.0);
  EXPECT_LT(g.origin[2] + box.low[2] * g.spacing[2], in.after.airway.glottis.centre[2] - 20.0);
}

ManikinScan closed_scan(ManikinOptions options = {}) {
  options.seed = 0;
  auto scan = scan_manikin(options);
  close_mouth(scan);
  return scan;
}

/// Soft palate and larynx as given over voxels as dark as air, an eye given, and a hyoid whose middle is not seen.
void check_what_was_given_is_kept(const Closed& in) {
  auto s = in.before;
  for (std::size_t i = 0; i < s.labels.voxels.size(); ++i) {
    const auto label = s.labels.voxels[i];
    if (label != kSoftPalate && label != kLarynx) continue;
    s.hu.voxels[i] = -1000;
    s.head.body.voxels[i] = 1;
  }
  s.replaced = {kSoftPalate, kLarynx};
  const Point eye = Vector3(s.landmarks.at("operator_eye")) + Vector3{3.0, -2.0, 5.0};
  s.landmarks["operator_eye"] = eye;
  s.findings["operator_eye"] = {Origin::given, "placed by a person"};
  s.findings["upper_gum_midline"] = {Origin::inferred, "the mouth is closed"};
  // Only a horn is left of it.
  s.bones.hyoid = Mask(s.hu.grid);
  const Point off = Vector3(s.landmarks.at("hyoid")) + Vector3{6.0 * s.frame.scale, 0.0, 0.0};
  const auto c = s.hu.grid.nearest(off);
  s.bones.hyoid.at(c[0], c[1], c[2]) = 1;
  s.bones.hyoid_seen = true;
  put_into_position(s);
  for (const auto label : {kSoftPalate, kLarynx})
    EXPECT_NEAR(volume_mm3(s, label) / volume_mm3(in.after, label), 1.0, 0.05)
        << static_cast<int>(label) << ": moved as it is when its voxels are bright";
  EXPECT_EQ(s.findings.at("upper_gum_midline").origin, Origin::inferred) << "found after a move, not on the scan";
  EXPECT_NE(s.findings.at("upper_gum_midline").how, "the mouth is closed") << "it was opened";
  EXPECT_EQ(s.landmarks.at("operator_eye"), eye);
  EXPECT_EQ(s.findings.at("operator_eye").origin, Origin::given);
  EXPECT_EQ(s.findings.at("hyoid").origin, Origin::from_model);
  EXPECT_LT(distance(s.landmarks.at("hyoid"), s.landmarks.at("vallecula")), 6.0 * s.frame.scale + 1e-9)
      << "it goes where the vallecula went";
}

/// A mask's strip of 2 mm, 3 mm before the lips, in the head's mask as a scan's joined pieces are.
void check_strips_are_taken_off(const Segmentation& closed) {
  auto bare = closed;
  EXPECT_EQ(bare_face(bare), 0.0) << "lips, nose and chin are no strips";
  auto masked = closed;
  const auto& g = masked.hu.grid;
  const double low = masked.landmarks.at("lower_gum_midline")[2] - 2.0;
  const double high = masked.landmarks.at("upper_gum_midline")[2] + 2.0;
  std::size_t drawn = 0;
  for (int z = 0; z < g.size[2]; ++z) {
    const double pz = g.origin[2] + z * g.spacing[2];
    for (int x = 0; x < g.size[0] && pz > low && pz < high; ++x) {
      if (std::abs(g.origin[0] + x * g.spacing[0] - masked.frame.mid_x) > 12.0) continue;
      int front = 0;
      while (front < g.size[1] && closed.head.inside.at(x, front, z) == 0) ++front;
      for (int y = front - static_cast<int>(5.0 / g.spacing[1]); y < front - static_cast<int>(3.0 / g.spacing[1]);
           ++y) {
        masked.head.body.at(x, y, z) = masked.head.inside.at(x, y, z) = 1;
        masked.labels.at(x, y, z) = kSkin;
        ++drawn;
      }
    }
  }
  ASSERT_GT(drawn, 1000u);
  EXPECT_NEAR(bare_face(masked), static_cast<double>(drawn) * g.voxel_mm3(), 1e-6);
  EXPECT_EQ(masked.head.body.voxels, closed.head.body.voxels);
  EXPECT_EQ(masked.head.inside.voxels, closed.head.inside.voxels);
  EXPECT_EQ(masked.labels.voxels, closed.labels.voxels);
}

TEST(Position, ClosedMouthIsFoundAndOpened) {
  Closed in;
  in.scan = closed_scan();
  in.before = segment(in.scan.ct, {});
  check_tongue_is_found_without_a_seed(in);
  check_strips_are_taken_off(in.before);
  in.after = in.before;
  in.facts = put_into_position(in.after);
  ASSERT_TRUE(in.facts.aim.part);
  check_jaw_moved_rigidly(in);
  check_skull_did_not_move(in);
  check_mouth_is_open(in);
  check_what_was_given_is_kept(in);
  EXPECT_EQ(in.facts.bared_mm3, 0.0);
  EXPECT_EQ(in.after.findings.at("skin").origin, Origin::measured);
  EXPECT_NEAR(in.facts.lower_volume_ratio, 1.0, 0.01);
  EXPECT_NEAR(tongue_mm3(in.after) / tongue_mm3(in.before), 1.0, 0.08);
  std::printf("[ figures  ] jaw %.1f deg, jacobian %.3f, folded %.1f mm3, overlap %.1f mm3, tongue %.3f\n",
              in.after.pose.mouth_opened_deg, in.facts.smallest_jacobian, in.facts.folded_mm3, in.facts.overlap_mm3,
              tongue_mm3(in.after) / tongue_mm3(in.before));

  // All lengths at once.
  const auto gum = in.after.landmarks.at("upper_gum_midline");
  const auto lower = in.after.landmarks.at("lower_gum_midline");
  scale_lengths(in.after, 0.5);
  EXPECT_NEAR(distance(in.after.landmarks.at("upper_gum_midline"), in.after.landmarks.at("lower_gum_midline")),
              0.5 * distance(gum, lower), 1e-9);
  EXPECT_NEAR(distance(in.after.landmarks.at("operator_eye"), in.after.landmarks.at("upper_gum_midline")), 320.0, 1.0)
      << "the operator is no smaller";
  EXPECT_EQ(in.after.pose.scale, 0.5);
}

void write_nrrd(const Hounsfield& hu, const std::filesystem::path& file) {
  const auto& g = hu.grid;
  std::ofstream out(file, std::ios::binary);
  out.precision(17);
  out << "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: " << g.size[0] << " " << g.size[1]
      << " " << g.size[2] << "\nspace directions: (" << g.spacing[0] << ",0,0) (0," << g.spacing[1] << ",0) (0,0,"
      << g.spacing[2] << ")\nkinds: domain domain domain\nencoding: raw\nspace origin: (" << g.origin[0] << ","
      << g.origin[1] << "," << g.origin[2] << ")\nendian: little\n\n";
  out.write(reinterpret_cast<const char*>(hu.voxels.data()),
            static_cast<std::streamsize>(hu.voxels.size() * sizeof(hu.voxels[0])));
}

TEST(Position, CancelledHalfWayLeavesWhatWasMeasured) {
  const auto file =
      std::filesystem::temp_directory_path() / ("vallecula-position-" + std::to_string(::getpid()) + ".nrrd");
  ManikinOptions coarse;
  coarse.in_plane_mm = 0.6;
  coarse.slice_mm = 1.0;
  write_nrrd(closed_scan(coarse).ct, file);
  ImportOptions options;
  options.series = file;
  double cancel_at = 2.0;
  Import import(options, [&](const std::string& stage, double done) {
    if (stage == "position" && done >= cancel_at) throw std::runtime_error("cancelled");
  });
  import.read();
  import.segment();
  std::filesystem::remove(file);
  const auto before = import.segmentation();
  const auto on_scan = import.labels_on_scan().voxels;
  for (const double late : {0.85, 1.0}) {
    cancel_at = stage_begin::kPosition + (stage_begin::kSurfaces - stage_begin::kPosition) * late - 1e-9;
    EXPECT_THROW(import.position(), ImportError);
    const auto& s = import.segmentation();
    EXPECT_EQ(s.hu.voxels, before.hu.voxels);
    EXPECT_EQ(s.labels.voxels, before.labels.voxels);
    EXPECT_EQ(s.head.body.voxels, before.head.body.voxels);
    EXPECT_EQ(s.bones.hyoid.voxels, before.bones.hyoid.voxels);
    EXPECT_EQ(s.airway.glottis.centre, before.airway.glottis.centre);
    EXPECT_EQ(s.landmarks, before.landmarks);
    EXPECT_EQ(s.pose.mouth_opened_deg, 0.0);
  }
  cancel_at = 2.0;
  import.position();
  EXPECT_GT(import.segmentation().pose.mouth_opened_deg, 10.0);
  EXPECT_EQ(import.labels_on_scan().voxels, on_scan);
}

TEST(Position, OpenMouthAndExtendedHeadAreLeftAlone) {
  ManikinOptions options;
  const auto scan = scan_manikin(options);
  auto s = segment(scan.ct, {});
  EXPECT_FALSE(aim_of(s).any());
  // The worked design of its line of sight: free past gum and lip; 20 mm nearer the table the upper lip blocks.
  const Vector3 eye = s.landmarks.at("operator_eye");
  EXPECT_GT(free_share(s, eye), 0.8);
  EXPECT_LT(free_share(s, eye + Vector3{0.0, 20.0, 0.0}), 0.2);
  EXPECT_EQ(s.findings.at("operator_eye").origin, Origin::measured) << "where the design has it";
  const auto labels = s.labels.voxels;
  const auto landmarks = s.landmarks;
  put_into_position(s);
  EXPECT_EQ(s.labels.voxels, labels);
  EXPECT_EQ(s.landmarks, landmarks);
  EXPECT_FALSE(s.pose.moved());
}

}  // namespace
}  // namespace vallecula::pipeline
