// A real adult head-and-neck CT with closed mouth, mask, couch and metal: reference points read by hand from the
// pictures.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "pipeline/dicom/read_series.h"
#include "pipeline/import.h"
#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/tet_quality.h"
#include "pipeline/package/label_map.h"
#include "pipeline/segment/upright.h"
#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

fs::path series() {
  const char* data = std::getenv("VALLECULA_DATA");
  const fs::path root = data != nullptr ? fs::path(data) : fs::path(VALLECULA_SOURCE_DIR) / ".." / "shared" / "data";
  return root / "cerr_head_neck_ct" / "dicom";
}

const Point kTongueCentre{244, -341, -138};

/// One import serves all questions (ctest starts a process for every test, so it is one test).
struct Adult {
  fs::path out;
  PatientPackage package;
  Labels labels;
  Point glottis_on_scan{};
  int label_at(const Point& p) const {
    const auto c = labels.grid.nearest(p);
    return labels.at(c[0], c[1], c[2]);
  }
};

void check_reference_points_have_their_labels(const Adult& in) {
  EXPECT_EQ(in.label_at(kTongueCentre), kTongue);
  for (const Point& p : {Point{242, -305, -111}, Point{243, -309, -162}, Point{242, -308, -201}, Point{239, -312, -219},
                         Point{235, -309, -252}, Point{232, -304, -261}}) {
    EXPECT_EQ(in.label_at(p), kAirway) << p[0] << ' ' << p[1] << ' ' << p[2];
  }
  EXPECT_EQ(in.label_at({244, -372, -141}), kMandible);
  EXPECT_EQ(in.label_at({1, -511, -267}), kBackground);
}

void check_airway_is_one_piece_and_the_gas_in_the_oesophagus_is_not(const Adult& in) {
  const auto airway = where(in.labels, [](std::uint8_t v) { return v == kAirway; });
  const auto parts = components(airway);
  ASSERT_EQ(parts.sizes.size(), 2u) << "one 6-connected component";
  EXPECT_NEAR(static_cast<double>(parts.sizes[1]), 29786.0, 600.0) << "voxels below -400 HU between nose and trachea";
  // The gas behind the trachea: below -400 HU in its box, not 6-connected to the trachea.
  const auto hu = read_ct_series(series()).hu;
  const auto gas = components(where(hu, [](std::int16_t v) { return v < -400; }));
  const int trachea = gas.id.at(234, 202, 5);
  std::size_t pocket = 0;
  for (int z = 0; z <= 4; ++z) {
    for (int y = 216; y <= 233; ++y) {
      for (int x = 227; x <= 262; ++x) {
        if (gas.id.at(x, y, z) == 0 || gas.id.at(x, y, z) == trachea) continue;
        ++pocket;
        EXPECT_NE(in.labels.at(x, y, z), kAirway) << "gas pocket";
      }
    }
  }
  EXPECT_GT(pocket, 50u);
}

void check_couch_and_mask_frame_are_outside(const Adult& in) {
  // The couch lies at y > -150 below the neck; the frame's feet beside the head.
  for (const Point& p :
       {Point{100, -143, -177}, Point{350, -143, -177}, Point{171, -153, -177}, Point{328, -153, -132}}) {
    EXPECT_EQ(in.label_at(p), kBackground) << p[0] << ' ' << p[1] << ' ' << p[2];
  }
}

void check_tongue_stays_within_its_limits(const Adult& in) {
  const auto hu = read_ct_series(series()).hu;
  std::size_t tongue = 0;
  std::size_t soft = 0;
  for (std::size_t i = 0; i < hu.voxels.size(); ++i) {
    if (in.labels.voxels[i] != kTongue) continue;
    ++tongue;
    soft += hu.voxels[i] > -150 && hu.voxels[i] < 250 ? 1 : 0;
    const auto p = hu.grid.position(i);
    ASSERT_LT(std::hypot(p[0] - kTongueCentre[0], p[1] - kTongueCentre[1], p[2] - kTongueCentre[2]), 60.0);
  }
  const double ml = static_cast<double>(tongue) * hu.grid.voxel_mm3() / 1000.0;
  EXPECT_GT(ml, 15.0);
  EXPECT_LT(ml, 130.0);
  EXPECT_GT(static_cast<double>(soft) / static_cast<double>(tongue), 0.95) << "no bone, no air";
}

void check_package_can_be_played(const Adult& in) {
  for (const auto& [name, surface] : in.package.surfaces) {
    if (name == "glottis") continue;
    EXPECT_EQ(facts_of(surface).fault, "") << name;
  }
  EXPECT_GT(quality_of(in.package.tongue).smallest_dihedral_deg, 5.0);
  const Point& glottis = in.glottis_on_scan;
  EXPECT_LT(std::hypot(glottis[0] - 239, glottis[1] + 312, glottis[2] + 219), 6.0) << "two slices of 3 mm";
  bool said = false;
  for (const auto& q : in.package.quality)
    said = said || (q.name == "carina" && q.note.find("inferred: below the scan") != std::string::npos);
  EXPECT_TRUE(said) << "the carina lies below the scan, and the report says so";
}

/// A closed mouth used to be refused without a point inside the tongue.
void check_a_seed_outside_the_head_is_refused(const Adult& in) {
  ImportOptions options;
  options.series = series();
  options.out = in.out.parent_path() / "other.patient";
  options.edits.seeds["tongue"] = {0, 0, 0};
  EXPECT_THROW(import_series(options), ImportError);
  EXPECT_FALSE(fs::exists(options.out));
}

void check_the_position_is_said(const Adult& in) {
  EXPECT_GT(in.package.pose.mouth_opened_deg, 3.0);
  EXPECT_LT(in.package.pose.mouth_opened_deg, 35.0);
  EXPECT_GT(in.package.pose.extension_deg, 3.0);
  EXPECT_EQ(in.package.pose.scale, 1.0) << "only on request";
  EXPECT_EQ(in.package.findings.at("tongue").origin, Origin::inferred);
  const Point upper = in.package.landmarks.at("upper_gum_midline");
  const Point lower = in.package.landmarks.at("lower_gum_midline");
  EXPECT_GT(std::hypot(upper[1] - lower[1], upper[2] - lower[2]), 35.0) << "mm, an adult's open mouth";
}

TEST(RealCt, GivesAPlayablePackageWithoutAHumanSeed) {
  if (!fs::exists(series()))
    GTEST_SKIP() << "outside data absent: cerr_head_neck_ct is looked for in $VALLECULA_DATA, else in ../shared/data";
  Adult in;
  in.out = fs::temp_directory_path() / ("vallecula-real-ct-test-" + std::to_string(::getpid())) / "adult.patient";
  ImportOptions options;
  options.series = series();
  options.out = in.out;
  Import import(options);
  import.read();
  import.segment();
  in.glottis_on_scan = moved(inverse_of(import.segmentation().pose.scan_to_package),
                             import.segmentation().landmarks.at("glottis_centre"));
  import.position();
  import.mesh();
  import.check();
  import.write();
  in.package = read_package(in.out);
  in.labels = read_label_map(in.out / "labels.nrrd");
  check_reference_points_have_their_labels(in);
  check_airway_is_one_piece_and_the_gas_in_the_oesophagus_is_not(in);
  check_couch_and_mask_frame_are_outside(in);
  check_tongue_stays_within_its_limits(in);
  check_package_can_be_played(in);
  check_the_position_is_said(in);
  check_a_seed_outside_the_head_is_refused(in);
  fs::remove_all(in.out.parent_path());
}

}  // namespace
}  // namespace vallecula::pipeline
