// Geometry and HU of a series: against known functions of space in any orientation, and against VTK's own DICOM parser.
#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkDICOMImageReader.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "pipeline/dicom/read_series.h"
#include "tests/pipeline/dicom_file.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;
using Vec = std::array<double, 3>;

/// A head-like scene whose value at a place is known: air outside a ball, a slope of grey inside.
double scene(const Vec& p) {
  const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  return r > 30.0 ? -1000.0 : 40.0 + 2.0 * p[0] - 1.5 * p[1] + 0.75 * p[2];
}

struct Stack {
  Vec row{1, 0, 0};
  Vec column{0, 1, 0};
  Vec step{0, 0, 2.0};
  double spacing_row = 1.0;      ///< along a row
  double spacing_column = 1.25;  ///< along a column
  int columns = 70;
  int rows = 58;
  int slices = 36;
};

class ReadSeries : public ::testing::Test {
 protected:
  void SetUp() override {
    dir_ = fs::temp_directory_path() / ("vallecula-read-test-" + std::to_string(::getpid()));
    fs::remove_all(dir_);
    fs::create_directories(dir_);
  }
  void TearDown() override { fs::remove_all(dir_); }

  Vec position(const Stack& s, double i, double j, double k) const {
    Vec p{};
    for (int a = 0; a < 3; ++a) {
      p[a] = (i - 0.5 * (s.columns - 1)) * s.spacing_row * s.row[a] +
             (j - 0.5 * (s.rows - 1)) * s.spacing_column * s.column[a] + (k - 0.5 * (s.slices - 1)) * s.step[a];
    }
    return p;
  }

  test::DicomSlice slice(const Stack& s, int k) const {
    test::DicomSlice d;
    const auto p = position(s, 0, 0, k);
    d.position = test::decimal_string({p[0], p[1], p[2]});
    d.orientation = test::decimal_string({s.row[0], s.row[1], s.row[2], s.column[0], s.column[1], s.column[2]});
    d.spacing = test::decimal_string({s.spacing_column, s.spacing_row});
    d.columns = s.columns;
    d.rows = s.rows;
    d.instance = std::to_string(k + 1);
    d.slope = "0.5";
    d.intercept = "-1024";
    for (int j = 0; j < s.rows; ++j) {
      for (int i = 0; i < s.columns; ++i) {
        d.stored.push_back(static_cast<std::uint16_t>(std::lround(2.0 * (scene(position(s, i, j, k)) + 1024.0))));
      }
    }
    return d;
  }

  /// File names in an order that has nothing to do with the positions.
  fs::path name(int k) const { return dir_ / ("img" + std::to_string((k * 37 + 11) % 101) + ".dcm"); }

  void write(const Stack& s) const {
    for (int k = 0; k < s.slices; ++k) test::write_dicom(slice(s, k), name(k));
  }

  /// Every voxel well inside the ball has the scene's value at the voxel's place. Storage rounds to steps of 0.5 HU
  /// (0.25 off), a slice's HU to 1 (0.5 off), interpolation to 1 again.
  void expect_scene(const Hounsfield& hu, double tolerance) const {
    std::size_t checked = 0;
    double worst = 0.0;
    for (std::size_t i = 0; i < hu.voxels.size(); ++i) {
      const auto p = hu.grid.position(i);
      const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      if (r > 26.0 && r < 34.0) continue;               // the edge is interpolated
      if (r > 34.0 && hu.voxels[i] == -1024) continue;  // beyond the stack
      worst = std::max(worst, std::abs(hu.voxels[i] - scene(p)));
      ++checked;
    }
    EXPECT_GT(checked, 20000u);
    EXPECT_LE(worst, tolerance);
  }

  std::string message() const {
    try {
      read_ct_series(dir_);
    } catch (const SeriesError& e) {
      return e.what();
    }
    return "no error";
  }
  void expect_message(const std::string& words) const {
    EXPECT_NE(message().find(words), std::string::npos) << message();
  }

  fs::path dir_;
};

TEST_F(ReadSeries, AxialWithShuffledNamesAndRescale) {
  const Stack s;
  write(s);
  const auto series = read_ct_series(dir_);
  EXPECT_FALSE(series.resampled);
  EXPECT_EQ(series.hu.grid.size, (std::array<int, 3>{70, 58, 36}));
  EXPECT_NEAR(series.hu.grid.spacing[0], 1.0, 1e-9);
  EXPECT_NEAR(series.hu.grid.spacing[1], 1.25, 1e-9);
  EXPECT_NEAR(series.hu.grid.spacing[2], 2.0, 1e-9);
  const auto first = position(s, 0, 0, 0);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(series.hu.grid.origin[a], first[a], 1e-6);
  expect_scene(series.hu, 0.76);
}

TEST_F(ReadSeries, EveryOrientationAlongTheAxesIsTurnedExactly) {
  const std::vector<std::array<Vec, 3>> turns = {{Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, -1.7}},   // head first to last
                                                 {Vec{-1, 0, 0}, Vec{0, -1, 0}, Vec{0, 0, 1.7}},  // prone
                                                 {Vec{0, 1, 0}, Vec{0, 0, -1}, Vec{1.7, 0, 0}},   // sagittal
                                                 {Vec{1, 0, 0}, Vec{0, 0, -1}, Vec{0, 1.7, 0}}};  // coronal
  for (const auto& turn : turns) {
    fs::remove_all(dir_);
    fs::create_directories(dir_);
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

  fs::remove_all(dir_);
  fs::create_directories(dir_);
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
    auto d = slice(s, k);
    d.is_signed = true;
    d.slope = "1";
    d.intercept = "-10";
    for (std::size_t i = 0; i < d.stored.size(); ++i) {
      const double hu = scene(position(s, static_cast<double>(i % s.columns), static_cast<double>(i / s.columns), k));
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
  auto scout = slice(Stack{}, 0);
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
  expect_message("no such folder; check the name");
  std::ofstream(dir_) << "a file";
  expect_message("is a file");
}

TEST_F(ReadSeries, AnotherModalityIsNamed) {
  const Stack s;
  for (int k = 0; k < s.slices; ++k) {
    auto d = slice(s, k);
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
    test::write_dicom(slice(s, 7), victim);
    fs::resize_file(victim, static_cast<std::uintmax_t>(share * static_cast<double>(fs::file_size(victim))));
    expect_message(victim.filename().string());
  }
}

TEST_F(ReadSeries, GapsDoublesAndMixedGeometryAreNamed) {
  const Stack s;
  write(s);
  fs::remove(name(9));
  expect_message("a slice is missing");
  expect_message(name(8).filename().string());
  test::write_dicom(slice(s, 8), name(9));
  expect_message("same position");
  auto other = slice(s, 9);
  other.rows -= 1;
  test::write_dicom(other, name(9));
  expect_message(name(9).filename().string());
  other = slice(s, 9);
  other.orientation = "0\\1\\0\\0\\0\\-1";
  test::write_dicom(other, name(9));
  expect_message("orientation");
  other = slice(s, 9);
  other.spacing = "1.25\\1.5";
  test::write_dicom(other, name(9));
  expect_message("PixelSpacing differs");
  expect_message("take it out of the folder");
  other = slice(s, 9);
  other.intercept.clear();
  test::write_dicom(other, name(9));
  expect_message("RescaleIntercept");
  other = slice(s, 9);
  other.position.clear();
  test::write_dicom(other, name(9));
  expect_message("ImagePositionPatient");
}

TEST_F(ReadSeries, TwoStacksAreAQuestion) {
  write(Stack{});
  const Stack s;
  for (int k = 0; k < s.slices; ++k) {
    auto d = slice(s, k);
    d.series = "1.2.3.4.6";
    test::write_dicom(d, dir_ / ("b" + std::to_string(k) + ".dcm"));
  }
  expect_message("2 CT series");
}

TEST_F(ReadSeries, ValuesThatAreNoHounsfieldUnits) {
  const Stack s;
  for (int k = 0; k < s.slices; ++k) {
    auto d = slice(s, k);
    d.slope = "0.01";
    d.intercept = "0";
    test::write_dicom(d, name(k));
  }
  expect_message("Hounsfield");
}

TEST_F(ReadSeries, MessagesNeverIdentifyAPatient) {
  write(Stack{});
  fs::remove(name(9));
  EXPECT_EQ(message().find("Doe"), std::string::npos);
  EXPECT_EQ(message().find("SECRET"), std::string::npos);
}

}  // namespace
}  // namespace vallecula::pipeline
