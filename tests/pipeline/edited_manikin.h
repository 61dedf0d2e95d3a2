// A preterm infant's scan that people's edits are tried on, with its true labels.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "pipeline/manikin/manikin.h"
#include "pipeline/segment/segment.h"

namespace vallecula::pipeline::test {

/// Segmented once without edits.
class EditedManikin : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    ManikinOptions options;
    options.weight_kg = 1.2;
    options.seed = 4;
    scan_ = std::make_unique<ManikinScan>(scan_manikin(options));
    plain_ = std::make_unique<Segmentation>(segment(scan_->ct, {}));
    found_ = std::make_unique<Labels>(on_series_grid(*plain_, scan_->ct.grid));
  }
  static void TearDownTestSuite() {
    scan_.reset();
    plain_.reset();
    found_.reset();
  }

  static const Grid& grid() { return scan_->ct.grid; }
  static Mask truth(std::uint8_t label) {
    return where(scan_->labels, [label](std::uint8_t v) { return v == label; });
  }
  static Mask of(const Labels& labels, std::uint8_t label) {
    return where(labels, [label](std::uint8_t v) { return v == label; });
  }
  static Edits replacing(std::uint8_t label, const Mask& mask) {
    Edits edits;
    edits.labels = Labels(grid());
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) edits.labels->voxels[i] = mask.voxels[i] != 0 ? label : 0;
    edits.replaced = {label};
    return edits;
  }
  static Vector3 centroid(const Mask& mask) {
    Vector3 sum{};
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
      if (mask.voxels[i] != 0) sum = sum + mask.grid.position(i);
    }
    return (1.0 / static_cast<double>(count(mask))) * sum;
  }
  /// The voxel of the mask furthest from its border: surely inside.
  static Vector3 heart(const Mask& mask) {
    const auto depth = distance_to(inverted(mask));
    return mask.grid.position(
        static_cast<std::size_t>(std::max_element(depth.voxels.begin(), depth.voxels.end()) - depth.voxels.begin()));
  }
  static double dice(const Mask& a, const Mask& b) {
    return 2.0 * static_cast<double>(count(all_of(a, b))) / static_cast<double>(count(a) + count(b));
  }
  static Segmentation with(const Edits& edits) { return segment(scan_->ct, edits); }
  static void expect_refused(const Edits& edits, const std::string& naming) {
    try {
      with(edits);
      FAIL() << "followed: " << naming;
    } catch (const std::runtime_error& e) {
      EXPECT_NE(std::string(e.what()).find(naming), std::string::npos) << e.what();
    }
  }

  inline static std::unique_ptr<ManikinScan> scan_;
  inline static std::unique_ptr<Segmentation> plain_;
  inline static std::unique_ptr<Labels> found_;
};

}  // namespace vallecula::pipeline::test
