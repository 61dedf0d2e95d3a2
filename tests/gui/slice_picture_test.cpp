// Grey values, slices, measures and edits as plain functions: truth by construction.
#include "gui/views/slice_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "gui/import/edit_history.h"
#include "gui/import/given_labels.h"
#include "gui/import/import_choice.h"
#include "gui/import/import_work.h"
#include "gui/views/slice_measure.h"
#include "pipeline/package/label_map.h"
#include "pipeline/segment/reslice.h"
#include "tests/gui/program.h"

namespace vallecula::gui {
namespace {

using pipeline::Point;

TEST(GreyWindow, IsTheIdentityWhereWindowAndLevelMakeItOne) {
  for (int hu = 0; hu <= 255; ++hu) EXPECT_EQ(grey_of(hu, {128.0, 256.0}), hu);
  EXPECT_EQ(grey_of(-1, {128.0, 256.0}), 0);
  EXPECT_EQ(grey_of(256, {128.0, 256.0}), 255);
}

TEST(GreyWindow, FollowsDicomsLinearFunction) {
  // PS3.3 C.11.2.1.2.1 by hand for W 400, L 40: black up to -160, white from 239; 255 * (0.5 / 399 + 0.5) = 127.8.
  const GreyWindow soft{40.0, 400.0};
  EXPECT_EQ(grey_of(-160, soft), 0);
  EXPECT_EQ(grey_of(-158, soft), 1);
  EXPECT_EQ(grey_of(39, soft), 127);
  EXPECT_EQ(grey_of(40, soft), 128);
  EXPECT_EQ(grey_of(238, soft), 254);
  EXPECT_EQ(grey_of(239, soft), 255);
  // A width of 1 is a threshold at the level.
  EXPECT_EQ(grey_of(99, {100.0, 1.0}), 0);
  EXPECT_EQ(grey_of(100, {100.0, 1.0}), 255);
  const GreyTable table(soft);
  for (int hu = -32768; hu <= 32767; hu += 7) ASSERT_EQ(table[static_cast<std::int16_t>(hu)], grey_of(hu, soft)) << hu;
}

/// 5 x 7 x 9 voxels of 0 HU.
pipeline::Hounsfield small_scan() {
  pipeline::Grid grid;
  grid.size = {5, 7, 9};
  grid.spacing = {0.5, 0.7, 2.0};
  grid.origin = {-10.0, 20.0, 30.0};
  return pipeline::Hounsfield(grid, 0);
}

TEST(SlicePicture, ShowsAMarkedVoxelAtItsPlaceInEveryPlane) {
  auto scan = small_scan();
  scan.at(4, 1, 7) = 1000;  // the patient's left, in front, high
  const GreyTable grey({500.0, 100.0});
  struct Case {
    SlicePlane plane;
    int index, columns, rows, x, y;
  };
  // Axial: left on the right, front above. Coronal: left on the right, head above. Sagittal: front on the left, head
  // above.
  for (const Case& c : {Case{SlicePlane::axial, 7, 5, 7, 4, 1}, Case{SlicePlane::coronal, 1, 5, 9, 4, 1},
                        Case{SlicePlane::sagittal, 4, 7, 9, 1, 1}}) {
    const QImage picture = slice_picture(scan, c.plane, c.index, grey, {});
    ASSERT_EQ(picture.size(), QSize(c.columns, c.rows));
    for (int y = 0; y < c.rows; ++y)
      for (int x = 0; x < c.columns; ++x)
        EXPECT_EQ(qGray(picture.pixel(x, y)), x == c.x && y == c.y ? 255 : 0) << axes_of(c.plane).name << x << ' ' << y;
    const QImage beside = slice_picture(scan, c.plane, c.index - 1, grey, {});
    for (int y = 0; y < c.rows; ++y)
      for (int x = 0; x < c.columns; ++x) EXPECT_EQ(qGray(beside.pixel(x, y)), 0);
  }
  EXPECT_STREQ(axes_of(SlicePlane::axial).left, "R");
  EXPECT_STREQ(axes_of(SlicePlane::coronal).left, "R");
  EXPECT_STREQ(axes_of(SlicePlane::sagittal).left, "A");
}

TEST(SlicePicture, LaysLabelsOverInTheirColourByTheOpacity) {
  const auto scan = small_scan();
  pipeline::Labels labels(scan.grid);
  labels.at(2, 3, 4) = pipeline::kTongue;  // 0.80, 0.36, 0.38
  LabelOverlay overlay;
  overlay.labels = &labels;
  overlay.opacity = 0.5;
  overlay.visible.fill(true);
  const GreyTable grey({0.0, 255.0});  // 0 HU: 255 * (0.5 / 254 + 0.5) = 128
  const auto pixel = [&](int x, int y) { return slice_picture(scan, SlicePlane::axial, 4, grey, overlay).pixel(x, y); };
  EXPECT_EQ(pixel(2, 3), qRgb(166, 110, 112));  // half of 128 and half of the colour
  EXPECT_EQ(pixel(1, 3), qRgb(128, 128, 128));
  overlay.visible[pipeline::kTongue] = false;
  EXPECT_EQ(pixel(2, 3), qRgb(128, 128, 128));
  overlay.threshold = std::array<double, 2>{0.0, 10.0};
  EXPECT_NE(pixel(1, 3), qRgb(128, 128, 128));
  overlay.threshold = std::array<double, 2>{1.0, 10.0};
  EXPECT_EQ(pixel(1, 3), qRgb(128, 128, 128));
}

TEST(SliceMeasure, KnowsLengthsAndAngles) {
  EXPECT_DOUBLE_EQ(length_mm({1, 2, 3}, {4, 6, 3}), 5.0);
  EXPECT_NEAR(angle_deg({1, 0, 0}, {0, 0, 0}, {0, 7, 0}), 90.0, 1e-12);
  EXPECT_NEAR(angle_deg({1, 0, 0}, {0, 0, 0}, {3, 3, 0}), 45.0, 1e-12);
  EXPECT_NEAR(angle_deg({1, 0, 0}, {0, 0, 0}, {-2, 0, 0}), 180.0, 1e-12);
  EXPECT_EQ(angle_deg({1, 0, 0}, {1, 0, 0}, {-2, 0, 0}), 0.0);
  EXPECT_EQ(text_of({SlicePlane::axial, {{0, 0, 0}, {3, 4, 0}}}), "5.0 mm");
  EXPECT_EQ(text_of({SlicePlane::axial, {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}}), "90.0\xc2\xb0");
  EXPECT_EQ(text_of({SlicePlane::axial, {{1, 0, 0}}}), "");
}

TEST(EditHistory, TakesEveryStepBackAndForth) {
  EditHistory history;
  history.set_seed("tongue", {1, 2, 3});
  history.set_threshold("airway", {-1000, -500});
  history.set_landmark("vallecula", {4, 5, 6});
  history.set_accepted("tongue", true);
  history.set_seed("tongue", {7, 8, 9});
  EXPECT_EQ(history.state().accepted.count("tongue"), 0u) << "what is changed is to be looked at again";
  history.stack().undo();
  EXPECT_EQ(history.state().accepted.count("tongue"), 1u);
  EXPECT_EQ(history.state().seeds.at("tongue"), (Point{1, 2, 3}));
  history.stack().undo();
  history.stack().undo();
  EXPECT_TRUE(history.state().landmarks.empty());
  EXPECT_EQ(history.state().thresholds.at("airway"), (std::array<double, 2>{-1000, -500}));
  history.stack().undo();
  history.stack().undo();
  const pipeline::Edits none = history.state().edits();
  EXPECT_TRUE(none.seeds.empty() && none.thresholds.empty() && none.landmarks.empty() && !none.labels);
  while (history.stack().canRedo()) history.stack().redo();
  const pipeline::Edits all = history.state().edits();
  EXPECT_EQ(all.seeds.at("tongue"), (Point{7, 8, 9}));
  EXPECT_EQ(all.landmarks.at("vallecula"), (Point{4, 5, 6}));
  history.forget("tongue");
  EXPECT_TRUE(history.state().seeds.empty());
  const int steps = history.stack().count();
  history.forget("tongue");
  EXPECT_EQ(history.stack().count(), steps) << "nothing to forget is no step";
}

TEST(GivenLabels, ArePutTogetherStructureByStructureOnTheScansGrid) {
  const auto grid = small_scan().grid;
  pipeline::Labels on_scan(grid);
  for (int x = 1; x <= 3; ++x) on_scan.at(x, 2, 4) = pipeline::kTongue;
  const int voxels = 3;

  EditState state = with_given_labels({}, on_scan, {pipeline::kTongue});
  pipeline::Labels airway(grid);
  airway.at(0, 0, 0) = pipeline::kAirway;
  airway.at(1, 0, 0) = pipeline::kSkull;  // not asked for
  state = with_given_labels(state, airway, {pipeline::kAirway});
  EXPECT_EQ(state.replaced, (std::set<std::uint8_t>{pipeline::kTongue, pipeline::kAirway}));
  const pipeline::Edits edits = state.edits();
  ASSERT_TRUE(edits.labels);
  EXPECT_EQ(edits.labels->at(0, 0, 0), pipeline::kAirway);
  EXPECT_EQ(edits.labels->at(1, 0, 0), 0);
  EXPECT_EQ(std::count(edits.labels->voxels.begin(), edits.labels->voxels.end(), pipeline::kTongue), voxels);
  EXPECT_THROW(with_given_labels({}, airway, {pipeline::kTongue}), std::runtime_error);
  EXPECT_THROW(with_given_labels({}, pipeline::Labels(grid), {}), std::runtime_error);
  EXPECT_EQ(with_given_labels({}, airway, {}).replaced, (std::set<std::uint8_t>{pipeline::kAirway, pipeline::kSkull}));
}

TEST(ScanFrame, IsReachedByTheInverseOfThePose) {
  pipeline::PoseChange pose;
  const Point p{12.5, -3.25, 40.0};
  EXPECT_EQ(pipeline::moved(pipeline::inverse_of(pose.scan_to_package), p), p) << "nothing moved: to the bit";
  // 30 degrees about z, then twice the size, then moved.
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  pose.scan_to_package = {2 * c, -2 * s, 0, 5, 2 * s, 2 * c, 0, -7, 0, 0, 2, 11, 0, 0, 0, 1};
  const Point there{2 * (c * p[0] - s * p[1]) + 5, 2 * (s * p[0] + c * p[1]) - 7, 2 * p[2] + 11};
  const Point back = pipeline::moved(pipeline::inverse_of(pose.scan_to_package), there);
  const Point way = pipeline::moved(pose.scan_to_package, p);
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(back[a], p[a], 1e-12);
    EXPECT_NEAR(way[a], there[a], 1e-12);
  }
}

TEST(ImportNames, AreFreeAndNeverTakenFromTheScan) {
  const test::Sandbox box;
  setenv("VALLECULA_HOME", box.home().c_str(), 1);
  EXPECT_EQ(free_patient_name(), "patient-1");
  std::filesystem::create_directories(patients_folder() / "patient-1.patient");
  EXPECT_EQ(free_patient_name(), "patient-2");
  EXPECT_EQ(problem_with_name("patient-2"), "");
  for (const char* bad : {"", "patient-1", "../x", "a b", "a.b", "-x"}) EXPECT_NE(problem_with_name(bad), "") << bad;
  ImportChoice choice;
  choice.source = "/ct";
  choice.name = "case";
  choice.series = "2";
  choice.generic_face = true;
  EXPECT_EQ(options_of(choice).choose, "2");
  EXPECT_TRUE(options_of(choice).generic_face);
  EXPECT_EQ(options_of(choice).out, box.home() / "patients" / "case.patient");
  EXPECT_EQ(options_of(choice).series, "/ct");
  unsetenv("VALLECULA_HOME");
}

TEST(TimeLeft, IsTheRestAtThePaceSoFar) {
  EXPECT_DOUBLE_EQ(seconds_left(0.25, 10.0), 30.0);
  EXPECT_DOUBLE_EQ(seconds_left(1.0, 10.0), 0.0);
  EXPECT_LT(seconds_left(0.01, 10.0), 0.0) << "too little is done to tell";
  EXPECT_EQ(time_left_text(-1.0), "");
  EXPECT_EQ(time_left_text(11.2), "about 12 s left");
  EXPECT_EQ(time_left_text(11.2, 4.0), "about 8 s left") << "it goes on between two reports";
  EXPECT_EQ(time_left_text(61.0), "about 65 s left") << "no exactness that is not there";
  EXPECT_EQ(time_left_text(11.2, 12.0), "about 1 s left");
  EXPECT_EQ(time_left_text(11.2, 20.0), "takes longer than expected") << "and makes no promise any more";
  EXPECT_EQ(time_left_text(150.0), "about 3 min left");
}

}  // namespace
}  // namespace vallecula::gui
