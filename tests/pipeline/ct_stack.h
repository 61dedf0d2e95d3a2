// A scene whose value at every place is known, as stacks of slices in any direction.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "pipeline/dicom/read_series.h"
#include "tests/pipeline/dicom_file.h"

namespace vallecula::pipeline::test {

/// Air outside a ball, a slope of grey inside.
inline double scene(const Vector3& p) {
  return norm(p) > 30.0 ? -1000.0 : 40.0 + 2.0 * p[0] - 1.5 * p[1] + 0.75 * p[2];
}

struct Stack {
  Vector3 row{1, 0, 0};
  Vector3 column{0, 1, 0};
  Vector3 step{0, 0, 2.0};
  double spacing_row = 1.0;      ///< along a row
  double spacing_column = 1.25;  ///< along a column
  int columns = 70;
  int rows = 58;
  int slices = 36;

  Vector3 position(double i, double j, double k) const {
    return ((i - 0.5 * (columns - 1)) * spacing_row) * row + ((j - 0.5 * (rows - 1)) * spacing_column) * column +
           (k - 0.5 * (slices - 1)) * step;
  }
};

inline DicomSlice slice_at(const Stack& s, double k) {
  DicomSlice d;
  const auto p = s.position(0, 0, k);
  d.position = decimal_string({p[0], p[1], p[2]});
  d.orientation = decimal_string({s.row[0], s.row[1], s.row[2], s.column[0], s.column[1], s.column[2]});
  d.spacing = decimal_string({s.spacing_column, s.spacing_row});
  d.columns = s.columns;
  d.rows = s.rows;
  d.instance = std::to_string(std::lround(1000 * k) + 1);
  d.slope = "0.5";
  d.intercept = "-1024";
  for (int j = 0; j < s.rows; ++j) {
    for (int i = 0; i < s.columns; ++i)
      d.stored.push_back(static_cast<std::uint16_t>(std::lround(2.0 * (scene(s.position(i, j, k)) + 1024.0))));
  }
  return d;
}

/// A folder that is gone afterwards, with slices in it.
class CtFolder : public ::testing::Test {
 protected:
  void SetUp() override { renew(); }
  void TearDown() override { std::filesystem::remove_all(dir_); }
  void renew() const {
    std::filesystem::remove_all(dir_);
    std::filesystem::create_directories(dir_);
  }

  /// File names in an order that has nothing to do with the positions.
  std::filesystem::path name(int k) const { return dir_ / ("img" + std::to_string((k * 37 + 11) % 101) + ".dcm"); }
  /// How a person is told that file.
  std::string told(int k) const { return "(" + name(k).filename().string() + ")"; }

  void write(const Stack& s) const {
    for (int k = 0; k < s.slices; ++k) write_dicom(slice_at(s, k), name(k));
  }

  /// Every voxel well inside the ball has the scene's value at the voxel's place. Storage rounds to steps of 0.5 HU
  /// (0.25 off), a slice's HU to 1 (0.5 off), interpolation to 1 again.
  static void expect_scene(const Hounsfield& hu, double tolerance) {
    std::size_t checked = 0;
    double worst = 0.0;
    for (std::size_t i = 0; i < hu.voxels.size(); ++i) {
      const auto p = hu.grid.position(i);
      const double r = norm(p);
      if (r > 26.0 && r < 34.0) continue;               // the edge is interpolated
      if (r > 34.0 && hu.voxels[i] == -1024) continue;  // beyond the stack
      worst = std::max(worst, std::abs(hu.voxels[i] - scene(p)));
      ++checked;
    }
    EXPECT_GT(checked, 20000u);
    EXPECT_LE(worst, tolerance);
  }

  std::string message(const std::string& choice = {}) const {
    try {
      read_ct_series(dir_, {}, choice);
    } catch (const SeriesError& e) {
      return e.what();
    }
    return "no error";
  }
  void expect_message(const std::string& words, const std::string& choice = {}) const {
    EXPECT_NE(message(choice).find(words), std::string::npos) << message(choice);
  }
  static bool noted(const std::vector<std::string>& notes, const std::string& words) {
    return std::any_of(notes.begin(), notes.end(), [&](const auto& n) { return n.find(words) != std::string::npos; });
  }

  std::filesystem::path dir_ =
      std::filesystem::temp_directory_path() / ("vallecula-read-test-" + std::to_string(::getpid()));
};

}  // namespace vallecula::pipeline::test
