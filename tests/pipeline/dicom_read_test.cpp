// Geometry and HU of a series: against known functions of space in any orientation, and against VTK's own DICOM parser.
#include <gtest/gtest.h>
#include <vtkDICOMImageReader.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <cmath>
#include <cstdlib>

#include "tests/pipeline/ct_stack.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;
using test::scene;
using test::slice_at;
using test::Stack;

class ReadSeries : public test::CtFolder {};

TEST_F(ReadSeries, AxialWithShuffledNamesAndRescale) {
  const Stack s;
  write(s);
  const auto series = read_ct_series(dir_);
  EXPECT_FALSE(series.resampled);
  EXPECT_EQ(series.hu.grid.size, (std::array<int, 3>{70, 58, 36}));
  EXPECT_NEAR(series.hu.grid.spacing[0], 1.0, 1e-9);
  EXPECT_NEAR(series.hu.grid.spacing[1], 1.25, 1e-9);
  EXPECT_NEAR(series.hu.grid.spacing[2], 2.0, 1e-9);
  const auto first = s.position(0, 0, 0);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(series.hu.grid.origin[a], first[a], 1e-6);
  expect_scene(series.hu, 0.76);
}

TEST_F(ReadSeries, EveryOrientationAlongTheAxesIsTurnedExactly) {
  const std::vector<std::array<Vector3, 3>> turns = {
      {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, -1.7}},   // head first to last
      {Vector3{-1, 0, 0}, Vector3{0, -1, 0}, Vector3{0, 0, 1.7}},  // prone
      {Vector3{0, 1, 0}, Vector3{0, 0, -1}, Vector3{1.7, 0, 0}},   // sagittal
      {Vector3{1, 0, 0}, Vector3{0, 0, -1}, Vector3{0, 1.7, 0}}};  // coronal
  for (const auto& turn : turns) {
    renew();
    Stack s;
    s.row = turn[0];
    s.column = turn[1];
    s.step = turn[2];
    write(s);
    const auto series = read_ct_series(dir_);
    EXPECT_FALSE(series.resampled);
    expect_scene(series.hu, 0.76);
  }
}

TEST_F(ReadSeries, ObliqueAndTiltedStacksAreInterpolated) {
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  Stack oblique;
  oblique.row = {c, s, 0};
  oblique.column = {-s * c, c * c, s};
  oblique.step = {1.5 * s * s, -1.5 * s * c, 1.5 * c};
  oblique.slices = 50;
  write(oblique);
  auto series = read_ct_series(dir_);
  EXPECT_TRUE(series.resampled);
  expect_scene(series.hu, 1.26);

  renew();
  Stack tilted;  // a gantry tilted by 15 degrees: slices are sheared against each other
  tilted.column = {0, std::cos(0.26), std::sin(0.26)};
  tilted.step = {0, 0, 2.0};
  write(tilted);
  series = read_ct_series(dir_);
  EXPECT_TRUE(series.resampled);
  expect_scene(series.hu, 1.26);
}

TEST_F(ReadSeries, SignedVoxelsAndPadding) {
  const Stack s;
  for (int k = 0; k < s.slices; ++k) {
    auto d = slice_at(s, k);
    d.is_signed = true;
    d.slope = "1";
    d.intercept = "-10";
    for (std::size_t i = 0; i < d.stored.size(); ++i) {
      const double hu = scene(s.position(static_cast<double>(i % s.columns), static_cast<double>(i / s.columns), k));
      d.stored[i] = static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(hu + 10.0)));
    }
    d.padding = static_cast<std::uint16_t>(static_cast<std::int16_t>(-2000));
    d.stored[5] = static_cast<std::uint16_t>(d.padding);
    test::write_dicom(d, name(k));
  }
  const auto series = read_ct_series(dir_);
  EXPECT_EQ(series.hu.at(5, 0, 3), -1024);
  expect_scene(series.hu, 0.76);
}

TEST_F(ReadSeries, OtherFilesAreIgnored) {
  write(Stack{});
  std::ofstream(dir_ / "truth.nrrd") << "NRRD0004\nnot ours";
  std::ofstream(dir_ / "notes.txt") << "hello";
  auto scout = slice_at(Stack{}, 0);
  scout.series = "1.2.3.4.6";
  test::write_dicom(scout, dir_ / "scout.dcm");
  const auto series = read_ct_series(dir_);
  EXPECT_EQ(series.slices, 36);
  ASSERT_EQ(series.notes.size(), 1u);
  EXPECT_NE(series.notes[0].find("another CT series"), std::string::npos);
}

TEST_F(ReadSeries, AgreesWithVtksOwnParser) {
  const char* data = std::getenv("VALLECULA_DATA");
  const fs::path root = data != nullptr ? fs::path(data) : fs::path(VALLECULA_SOURCE_DIR) / ".." / "shared" / "data";
  std::vector<fs::path> folders;
  Stack square;  // VTK takes the two spacings in the wrong order
  square.spacing_column = square.spacing_row;
  write(square);
  folders.push_back(dir_);
  if (fs::exists(root / "cerr_head_neck_ct")) folders.push_back(root / "cerr_head_neck_ct" / "dicom");
  for (const auto& folder : folders) {
    const auto series = read_ct_series(folder);
    vtkNew<vtkDICOMImageReader> reader;
    reader->SetDirectoryName(folder.c_str());
    reader->Update();
    auto* image = reader->GetOutput();
    int n[3];
    image->GetDimensions(n);
    ASSERT_EQ(n[0], series.hu.grid.size[0]);
    ASSERT_EQ(n[1], series.hu.grid.size[1]);
    ASSERT_EQ(n[2], series.hu.grid.size[2]);
    EXPECT_NEAR(image->GetSpacing()[0], series.hu.grid.spacing[0], 1e-6);
    EXPECT_NEAR(image->GetSpacing()[1], series.hu.grid.spacing[1], 1e-6);
    std::size_t different = 0;
    for (int z = 0; z < n[2]; ++z) {
      for (int y = 0; y < n[1]; ++y) {
        for (int x = 0; x < n[0]; ++x) {
          // VTK stores rows from below upwards and slices from the head downwards.
          const double theirs = image->GetScalarComponentAsDouble(x, n[1] - 1 - y, n[2] - 1 - z, 0);
          if (std::abs(theirs - series.hu.at(x, y, z)) > 1.0) ++different;
        }
      }
    }
    EXPECT_EQ(different, 0u) << folder.filename();
  }
}

TEST_F(ReadSeries, BadFoldersSayWhatIsWrong) {
  expect_message("empty");
  std::ofstream(dir_ / "notes.txt") << "hello";
  expect_message("no DICOM images");
  fs::remove_all(dir_);
  expect_message("the folder or file given does not exist; check the name");
  std::ofstream(dir_) << "a file";
  expect_message("the file: is no DICOM file");
}

TEST_F(ReadSeries, AnotherModalityIsNamed) {
  const Stack s;
  for (int k = 0; k < s.slices; ++k) {
    auto d = slice_at(s, k);
    d.modality = "MR";
    test::write_dicom(d, name(k));
  }
  expect_message("MR, not CT; name the folder of a CT series");
}

TEST_F(ReadSeries, ADamagedFileIsNamed) {
  const Stack s;
  write(s);
  for (const double share : {0.999, 0.7, 0.09, 0.05, 0.03, 0.02, 0.01, 0.0}) {
    const auto victim = name(7);
    test::write_dicom(slice_at(s, 7), victim);
    fs::resize_file(victim, static_cast<std::uintmax_t>(share * static_cast<double>(fs::file_size(victim))));
    expect_message(told(7));
  }
}

TEST_F(ReadSeries, ASliceWithoutItsGeometryOrRescaleIsNamed) {
  const Stack s;
  write(s);
  for (const auto& [leave_out, words] :
       {std::pair{&test::DicomSlice::intercept, "RescaleIntercept is missing"},
        std::pair{&test::DicomSlice::slope, "RescaleSlope is missing"},
        std::pair{&test::DicomSlice::position, "ImagePositionPatient is missing"},
        std::pair{&test::DicomSlice::orientation, "ImageOrientationPatient is missing"},
        std::pair{&test::DicomSlice::spacing, "PixelSpacing is missing"}}) {
    auto other = slice_at(s, 9);
    (other.*leave_out).clear();
    test::write_dicom(other, name(9));
    expect_message(words);
    expect_message(told(9));
  }
  auto other = slice_at(s, 9);
  other.spacing = "1.25\\wide";
  test::write_dicom(other, name(9));
  expect_message("PixelSpacing is not a number");
}

TEST_F(ReadSeries, ValuesThatAreNoHounsfieldUnits) {
  const Stack s;
  for (int k = 0; k < s.slices; ++k) {
    auto d = slice_at(s, k);
    d.slope = "0.01";
    d.intercept = "0";
    test::write_dicom(d, name(k));
  }
  expect_message("Hounsfield");
}

}  // namespace
}  // namespace vallecula::pipeline
