// Which pictures make a series, what is left out or asked about, what is bridged and what is refused.
#include <fstream>

#include "pipeline/dicom/read_series.h"
#include "tests/pipeline/ct_stack.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;
using test::slice_at;
using test::Stack;

class CtSeriesOfAFolder : public test::CtFolder {
 protected:
  /// The stack again as another series, or the same with something changed.
  template <class Change>
  void write_more(const Stack& s, const char* prefix, const Change& change) const {
    for (int k = 0; k < s.slices; ++k) {
      auto d = slice_at(s, k);
      d.instance = prefix + std::to_string(k);
      change(d, k);
      test::write_dicom(d, dir_ / (prefix + std::to_string(k) + ".dcm"));
    }
  }
};

TEST_F(CtSeriesOfAFolder, TwoStacksAreAQuestionAnsweredByNumberOrUid) {
  write(Stack{});
  Stack fine;
  fine.slices = 71;
  fine.step = {0, 0, 1.0};
  write_more(fine, "2", [](auto& d, int) {
    d.series = "1.2.3.4.6";
    d.extra[0x00181210] = {"SH", "H30s"};
  });
  expect_message("2 CT series could be meant");
  expect_message("1 (CT axial, 70 x 58 x 71, 1 x 1.25 x 1 mm, kernel H30s), 2 (CT axial");
  expect_message("--series NUMBER");
  EXPECT_EQ(read_ct_series(dir_, {}, "1").slices, 71);
  EXPECT_EQ(read_ct_series(dir_, {}, "2").slices, 36);
  EXPECT_EQ(read_ct_series(dir_, {}, "1.2.3.4.5").slices, 36);
  EXPECT_TRUE(
      noted(read_ct_series(dir_, {}, "1").notes, "36 pictures of another CT series in the folder were left out"));
  expect_message("there is no number 3", "3");
  expect_message("none of this UID", "1.2.3.4.7");
  EXPECT_EQ(message("1.2.3.4.7").find("1.2.3.4.7"), std::string::npos);
}

TEST_F(CtSeriesOfAFolder, TheListIsInNeutralWords) {
  write(Stack{});
  auto mr = slice_at(Stack{}, 0);
  mr.modality = "MR";
  mr.series = "1.2.3.4.7";
  test::write_dicom(mr, dir_ / "mr.dcm");
  auto named = slice_at(Stack{}, 0);
  named.modality = "DOE";  // free text where a term belongs
  named.series = "1.2.3.4.8";
  test::write_dicom(named, dir_ / "other.dcm");
  auto scout = slice_at(Stack{}, 0);
  scout.extra[0x00080008] = {"CS", "ORIGINAL\\PRIMARY\\LOCALIZER"};
  test::write_dicom(scout, dir_ / "scout.dcm");
  const auto list = list_series(dir_, true);
  ASSERT_EQ(list.size(), 4u);
  EXPECT_TRUE(list[0].usable);
  EXPECT_EQ(list[0].size, (std::array<int, 3>{70, 58, 36}));
  EXPECT_EQ(list[0].orientation, "axial");
  std::string reasons;
  for (const auto& e : list) reasons += std::to_string(e.number) + e.modality + ": " + e.reason + "\n";
  EXPECT_NE(reasons.find("MR: MR, not CT"), std::string::npos) << reasons;
  EXPECT_NE(reasons.find("other: not CT"), std::string::npos) << reasons;
  EXPECT_NE(reasons.find("CT: a scout image"), std::string::npos) << reasons;
  EXPECT_EQ(read_ct_series(dir_).slices, 36);
  EXPECT_TRUE(noted(read_ct_series(dir_).notes, "1 picture of a scout was left out"));
  expect_message("MR, not CT", "2");
}

TEST_F(CtSeriesOfAFolder, TheThumbnailIsTheMiddleSliceInItsShape) {
  write(Stack{});
  const auto t = list_series(dir_, true).at(0).thumbnail;
  ASSERT_EQ(t.height, 128);  // 58 rows of 1.25 mm against 70 columns of 1 mm
  ASSERT_EQ(t.width, 124);
  ASSERT_EQ(t.grey.size(), 128u * 124u);
  const auto at = [&](int x, int y) { return static_cast<int>(t.grey[static_cast<std::size_t>(y) * 124 + x]); };
  EXPECT_EQ(at(2, 2), 0);                              // air
  EXPECT_NEAR(at(62, 64), (40 + 160) * 255 / 400, 3);  // the scene's 40 HU in the middle
  EXPECT_GT(at(90, 40), at(34, 88) + 60);              // and its slope: brighter to the left and to the front
  EXPECT_TRUE(list_series(dir_).at(0).thumbnail.grey.empty()) << "only when asked for";
  renew();
  Stack sagittal;
  sagittal.row = {0, 1, 0};
  sagittal.column = {0, 0, -1};
  sagittal.step = {1.7, 0, 0};
  write(sagittal);
  EXPECT_EQ(list_series(dir_, true).at(0).orientation, "sagittal");
  EXPECT_TRUE(list_series(dir_, true).at(0).thumbnail.grey.empty()) << "it would show a profile";
}

TEST_F(CtSeriesOfAFolder, OddPicturesOfTheSeriesAreLeftOutWithANote) {
  write(Stack{});
  Stack small;
  small.columns = 40;
  auto odd = slice_at(small, 3);
  odd.instance = "90";
  test::write_dicom(odd, dir_ / "small.dcm");
  Stack turned;
  turned.row = {0, 1, 0};
  turned.column = {0, 0, -1};
  odd = slice_at(turned, 3);
  odd.instance = "91";
  test::write_dicom(odd, dir_ / "turned.dcm");
  odd = slice_at(Stack{}, 3);
  odd.instance = "92";
  odd.extra[0x00280002] = {"US", test::bytes_of(3, 2)};
  odd.extra[0x00280004] = {"CS", "RGB"};
  odd.stored.resize(3 * odd.stored.size());
  test::write_dicom(odd, dir_ / "colour.dcm");
  const auto series = read_ct_series(dir_);
  EXPECT_EQ(series.slices, 36);
  EXPECT_EQ(std::count_if(series.notes.begin(), series.notes.end(),
                          [](const auto& n) { return n.find("1 picture of another size") == 0; }),
            3);
}

TEST_F(CtSeriesOfAFolder, DoublesAreKeptOnceAndDifferingOnesRefused) {
  const Stack s;
  write(s);
  fs::copy_file(name(5), dir_ / "copy.dcm");
  auto again = slice_at(s, 6);
  again.instance = "99";
  test::write_dicom(again, dir_ / "exported-again.dcm");
  const auto series = read_ct_series(dir_);
  EXPECT_EQ(series.slices, 36);
  EXPECT_TRUE(noted(series.notes, "2 pictures were there twice"));
  expect_scene(series.hu, 0.76);
  again.stored[1000] += 2;
  test::write_dicom(again, dir_ / "exported-again.dcm");
  expect_message("lie at the same position with different pictures");
  expect_message(told(6));
}

TEST_F(CtSeriesOfAFolder, PhasesOfOneSeriesAreOfferedApart) {
  const Stack s;
  for (int phase = 1; phase <= 2; ++phase) {
    write_more(s, phase == 1 ? "1" : "2", [&](auto& d, int) {
      d.extra[0x00200012] = {"IS", std::to_string(phase)};  // AcquisitionNumber
      for (auto& v : d.stored) v = static_cast<std::uint16_t>(v + 20 * (phase - 1));
    });
  }
  expect_message("2 CT series could be meant");
  expect_message("2 CT series could be meant", "1.2.3.4.5");
  const auto one = read_ct_series(dir_, {}, "1");
  const auto two = read_ct_series(dir_, {}, "2");
  EXPECT_EQ(one.slices, 36);
  EXPECT_EQ(std::abs(two.hu.at(35, 29, 18) - one.hu.at(35, 29, 18)), 10);
}

TEST_F(CtSeriesOfAFolder, AMissingSliceIsBridgedAndSaid) {
  const Stack s;
  write(s);
  fs::remove(name(9));
  const auto series = read_ct_series(dir_);
  EXPECT_EQ(series.slices, 35);
  EXPECT_EQ(series.hu.grid.size[2], 36);
  EXPECT_TRUE(
      noted(series.notes, "1 slices are missing and were interpolated; the widest gap is 4 mm, between z = -19 and"));
  expect_scene(series.hu, 1.26);
  fs::remove(name(10));
  expect_message("a gap of 6 mm between z = -19 and z = -13 mm, where the others lie 2 mm apart and at most 5 mm");
}

TEST_F(CtSeriesOfAFolder, UnevenSlicesAreInterpolatedOntoEvenOnes) {
  Stack s;
  s.step = {0, 0, 1.0};
  s.slices = 60;
  int file = 0;
  for (double k = 0.0; k < 59.0; k += 0.8 + 0.1 * (file % 9)) test::write_dicom(slice_at(s, k), name(file++));
  const auto series = read_ct_series(dir_);
  EXPECT_TRUE(noted(series.notes, "lie unevenly (0.8 to 1.6 mm apart)"));
  EXPECT_FALSE(series.resampled) << "along the slices' normal only";
  expect_scene(series.hu, 1.26);
}

TEST_F(CtSeriesOfAFolder, SlicesNearlyEvenAreResampledFromWhereTheyLie) {
  const Stack s;
  const double slope = 25.0;  // HU for each mm: slices taken as even would be 2.2 HU off
  for (int k = 0; k < s.slices; ++k) {
    auto d = slice_at(s, k);
    auto p = s.position(0, 0, k);
    p[2] += k % 3 == 1 ? 0.09 : 0.0;
    d.position = test::decimal_string({p[0], p[1], p[2]});
    for (auto& v : d.stored) v = static_cast<std::uint16_t>(std::lround(2.0 * (slope * p[2] + 1024.0)));
    test::write_dicom(d, name(k));
  }
  const auto volume = read_ct_volume(dir_);
  EXPECT_TRUE(noted(volume.notes, "deviate by up to 0.09 mm from even spacing; the slices were resampled onto it"));
  ASSERT_EQ(volume.geometry.size[2], 36);
  for (int k = 0; k < s.slices; ++k) {
    const auto p = volume.geometry.position(3, 4, k);
    EXPECT_NEAR(p[2], s.position(3, 4, k)[2], 1e-6);
    EXPECT_NEAR(volume.at(3, 4, k), slope * p[2], 1.26) << k;
  }
}

TEST_F(CtSeriesOfAFolder, WhatIsOffThePatientsAxesByMoreThanAMicrometreIsResampled) {
  for (const double angle : {5e-6, 5e-5}) {  // 0.0007 and 0.007 mm at the far corner
    Stack s;
    s.row = {std::cos(angle), std::sin(angle), 0};
    s.column = {-std::sin(angle), std::cos(angle), 0};
    renew();
    write(s);
    EXPECT_EQ(read_ct_series(dir_).resampled, angle > 1e-5) << angle;
  }
}

TEST_F(CtSeriesOfAFolder, SlicesShiftedSidewaysAreRefused) {
  const Stack s;
  write(s);
  auto d = slice_at(s, 12);
  const auto p = s.position(0, 0, 12);
  d.position = test::decimal_string({p[0] + 3.0, p[1], p[2]});
  test::write_dicom(d, name(12));
  expect_message("shifted sideways against each other by up to 3 mm");
}

TEST_F(CtSeriesOfAFolder, ATiltedGantryIsSaidInDegrees) {
  Stack tilted;
  tilted.column = {0, std::cos(0.26), std::sin(0.26)};
  write(tilted);
  const auto series = read_ct_series(dir_);
  EXPECT_TRUE(series.resampled);
  EXPECT_TRUE(noted(series.notes, "the gantry was tilted by 14.9 degrees"));
  EXPECT_NEAR(series.source_spacing[2], 2.0 * std::cos(0.26), 1e-6) << "between the planes";
  const auto volume = read_ct_volume(dir_);
  EXPECT_NEAR(tilt_degrees(volume.geometry), 0.26 * 180 / 3.14159265, 1e-4);
  EXPECT_LT(norm(volume.geometry.position(69, 57, 35) - tilted.position(69, 57, 35)), 1e-6);
}

TEST_F(CtSeriesOfAFolder, TooCoarseOrTooFewIsRefusedButStillAVolume) {
  Stack s;
  s.step = {0, 0, 6.0};
  s.slices = 20;
  write(s);
  expect_message("too coarse: slices 6 mm apart; at most 5 mm");
  EXPECT_EQ(read_ct_volume(dir_).slices, 20);
  renew();
  s = Stack{};
  s.spacing_row = 2.5;
  write(s);
  expect_message("too coarse: voxels of 2.5 mm");
  renew();
  s = Stack{};
  s.slices = 15;
  write(s);
  expect_message("only 15 slices; at least 16");
  EXPECT_EQ(read_ct_volume(dir_).slices, 15);
}

TEST_F(CtSeriesOfAFolder, SubfoldersAreReadDownToADepth) {
  const Stack s;
  fs::create_directories(dir_ / "a/b/c/d/e");
  for (int k = 0; k < s.slices; ++k)
    test::write_dicom(slice_at(s, k), dir_ / (k % 2 == 0 ? "a" : "a/b/c/d") / std::to_string(k));
  auto hidden = slice_at(s, 3);
  hidden.stored[0] += 100;
  test::write_dicom(hidden, dir_ / "a/.hidden");
  test::write_dicom(hidden, dir_ / "a/b/c/d/e/too-deep");
  const auto series = read_ct_series(dir_);
  EXPECT_EQ(series.slices, 36);
  expect_scene(series.hu, 0.76);
}

TEST_F(CtSeriesOfAFolder, PaddingIsAirForAnImportAndAsRescaledInTheVolume) {
  const Stack s;
  for (int k = 0; k < s.slices; ++k) {
    auto d = slice_at(s, k);
    d.extra[0x00280120] = {"US", test::bytes_of(4090, 2)};
    d.extra[0x00280121] = {"US", test::bytes_of(4095, 2)};
    d.stored[7] = 4095;
    d.stored[8] = 4096;
    test::write_dicom(d, name(k));
  }
  const auto hu = read_ct_series(dir_).hu;
  EXPECT_EQ(hu.at(7, 0, 4), -1024);
  EXPECT_EQ(hu.at(8, 0, 4), 1024);
  EXPECT_EQ(read_ct_volume(dir_).at(7, 0, 4), 1024);  // 4095 / 2 - 1024 = 1023.5
}

TEST_F(CtSeriesOfAFolder, MetalBeyondTheUsualScaleStaysAndBeyondInt16IsClampedAndSaid) {
  const Stack s;
  for (int k = 0; k < s.slices; ++k) {
    auto d = slice_at(s, k);
    for (auto& v : d.stored) v = static_cast<std::uint16_t>(v / 2);
    d.slope = "1";
    d.stored[3] = 31000;
    d.stored[4] = 60000;
    test::write_dicom(d, name(k));
  }
  const auto series = read_ct_series(dir_);
  EXPECT_EQ(series.hu.at(3, 0, 9), 29976);
  EXPECT_EQ(series.hu.at(4, 0, 9), 32767);
  EXPECT_TRUE(noted(series.notes, "36 voxels lay outside -32768 to 32767 HU"));
}

/// An Enhanced CT: all frames in one file, out of order, each with its own place and rescale.
std::string enhanced(const Stack& s) {
  std::vector<test::DicomSlice> slices;
  for (int n = 0; n < s.slices; ++n) {
    const int k = (n * 7 + 4) % s.slices;
    auto d = slice_at(s, k);
    d.intercept = std::to_string(-1024 - k % 3);
    for (auto& v : d.stored) v = static_cast<std::uint16_t>(v + 2 * (k % 3));
    slices.push_back(d);
  }
  return test::enhanced_bytes(slices);
}

TEST_F(CtSeriesOfAFolder, EnhancedCtIsReadFrameByFrame) {
  const Stack s;
  const auto file = dir_ / "anything";
  test::write_bytes(enhanced(s), file);
  for (const auto& place : {dir_, file}) {
    const auto series = read_ct_series(place);
    EXPECT_EQ(series.slices, 36);
    expect_scene(series.hu, 0.76);
    EXPECT_LT(norm(series.hu.grid.position(0, 0, 0) - s.position(0, 0, 0)), 1e-6);
  }
}

TEST_F(CtSeriesOfAFolder, MultiFrameFilesThatDoNotSayWhereAreRefused) {
  auto d = slice_at(Stack{}, 0);
  d.extra[0x00280008] = {"IS", "4"};
  const auto one = d.stored;
  for (int i = 0; i < 3; ++i) d.stored.insert(d.stored.end(), one.begin(), one.end());
  test::write_dicom(d, dir_ / "IM1");
  expect_message("multi-frame file without a position for each frame");
  auto lying = enhanced(Stack{});
  lying.replace(lying.find("IS", lying.find(test::bytes_of(0x00080028, 4))) + 4, 2, "12");
  test::write_bytes(lying, dir_ / "IM1");
  expect_message("describes 36 frames and claims 12");
}

}  // namespace
}  // namespace vallecula::pipeline
