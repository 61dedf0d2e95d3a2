// Landmarks out and back: in the scan's frame, and only moved ones are edits.
#include "pipeline/exchange/landmark_file.h"

#include <gtest/gtest.h>

#include "tests/pipeline/exchange/exchange_folder.h"

namespace vallecula::pipeline {
namespace {

using test::expect_message;

class LandmarkFile : public test::ExchangeFolder {};

PatientPackage package_with_landmarks() {
  PatientPackage p;
  double v = 1.0;
  for (const auto* name : kLandmarks) {
    p.landmarks[name] = {v, -2.0 * v, 30.0 + v};
    v += 1.5;
  }
  p.landmarks["glottis_normal"] = {0.0, -0.6, 0.8};
  p.findings["carina"] = {Origin::inferred, "a rule with \"quotes\""};
  return p;
}

TEST_F(LandmarkFile, LandmarksGoOutAndOnlyMovedOnesComeBack) {
  const auto package = package_with_landmarks();
  const auto file = folder_ / "l.mrk.json";
  write_landmark_file(package, file);
  auto given = read_landmark_file(file);
  EXPECT_TRUE(given.moved.empty());
  EXPECT_EQ(given.unmoved, 10);

  auto text = text_of(file);
  const std::string carina = "\"position\": [8.5000, -17.0000, 38.5000]";
  ASSERT_NE(text.find(carina), std::string::npos) << text;
  text.replace(text.find(carina), carina.size(), "\"position\": [8.5, -16.25, 38.5]");
  given = read_landmark_file(write("moved.mrk.json", text));
  ASSERT_EQ(given.moved.size(), 1u);
  EXPECT_EQ(given.moved.at("carina"), (Point{8.5, -16.25, 38.5}));

  // What another program wrote, in RAS with tabs: all its points count, and the direction is a point beside the
  // glottis.
  const auto ras = read_landmark_file(
      write("ras.mrk.json",
            "{\"markups\": [{\"type\": \"Fiducial\", \"coordinateSystem\": \"RAS\",\n\t\"controlPoints\": [\n"
            "\t\t{\"label\": \"glottis_centre\", \"position\": [-1.0, -2.0, 3.0]},\n"
            "\t\t{\"label\": \"glottis_normal\", \"position\": [-1.0, -2.0, 13.0], \"positionStatus\": \"defined\"},\n"
            "\t\t{\"label\": \"Jane Doe\", \"position\": [0, 0, 0]},\n"
            "\t\t{\"label\": \"carina\", \"position\": [0, 0, 0], \"positionStatus\": \"undefined\"}]}]}"));
  EXPECT_EQ(ras.moved.at("glottis_centre"), (Point{1, 2, 3}));
  EXPECT_EQ(ras.moved.at("glottis_normal"), (Point{0, 0, 1}));
  EXPECT_EQ(ras.left_out, 2);

  expect_message([&] { read_landmark_file(write("file1.mrk.json", "{\"markups\": [")); }, "file1.mrk.json");
  expect_message([&] { read_landmark_file(write("file2.mrk.json", "[1, 2]")); }, "file2.mrk.json");
  expect_message(
      [&] {
        read_landmark_file(write("file3.mrk.json",
                                 "{\"markups\": [{\"controlPoints\": [{\"label\": "
                                 "\"F-1\", \"position\": [0,0,0]}]}]}"));
      },
      "upper_gum_midline");
  expect_message(
      [&] {
        read_landmark_file(write("file4.mrk.json",
                                 "{\"markups\": [{\"controlPoints\": [{\"label\": "
                                 "\"carina\", \"position\": [0,\"a\",0]}]}]}"));
      },
      "file4.mrk.json");
  expect_message([&] { read_landmark_file(folder_ / "file5.mrk.json"); },
                 "landmark file file5.mrk.json: cannot be opened");
  try {
    read_landmark_file(folder_ / "Doe_Jane.mrk.json");
    FAIL();
  } catch (const LandmarkFileError& e) {
    EXPECT_STREQ(e.what(), "landmark file (name withheld): cannot be opened");
  }
}

TEST_F(LandmarkFile, LandmarksLieOnTheScanWhereverThePackageWasMoved) {
  auto package = package_with_landmarks();
  // A quarter turn about x, a shift, all lengths halved: scan (1, 2, 3) is package (0.5 * (1, -3, 2) + (5, 6, 7)).
  package.pose.scan_to_package = {0.5, 0, 0, 5, 0, 0, -0.5, 6, 0, 0.5, 0, 7, 0, 0, 0, 1};
  package.pose.scale = 0.5;
  package.pose.mouth_opened_deg = 12.0;
  package.landmarks["carina"] = {5.5, 4.5, 8.0};
  const auto file = folder_ / "l.mrk.json";
  write_landmark_file(package, file);
  EXPECT_NE(text_of(file).find("[1.0000, 2.0000, 3.0000]"), std::string::npos);
  EXPECT_NE(text_of(file).find("mouth"), std::string::npos) << "what a rigid way back cannot undo is said";
}

}  // namespace
}  // namespace vallecula::pipeline
