#include "pipeline/package/thumbnail.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "pipeline/package/label_map.h"

namespace vallecula::pipeline {

void write_thumbnail(const Labels& labels, double mid_x_mm, const std::filesystem::path& file) {
  constexpr int kSide = 320;
  constexpr int kOversample = 3;  // averaged down, so that the edges of the labels are not jagged
  const auto& g = labels.grid;
  const int x = std::clamp(g.nearest({mid_x_mm, 0.0, 0.0})[0], 0, g.size[0] - 1);
  const double extent = std::max(g.size[1] * g.spacing[1], g.size[2] * g.spacing[2]);

  cv::Mat picture(kSide * kOversample, kSide * kOversample, CV_8UC3, cv::Scalar(58, 46, 40));
  const double mm_per_pixel = extent / picture.rows;
  const double y_first = 0.5 * (g.size[1] * g.spacing[1] - extent);
  const double z_last = 0.5 * (g.size[2] * g.spacing[2] + extent);
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; ++column) {
      const int y = static_cast<int>(std::lround((y_first + (column + 0.5) * mm_per_pixel) / g.spacing[1]));
      const int z = static_cast<int>(std::lround((z_last - (row + 0.5) * mm_per_pixel) / g.spacing[2]));
      if (!g.contains(x, y, z)) continue;
      const int value = labels.at(x, y, z);
      for (const auto& label : kLabelNames) {
        if (label.value != value) continue;
        auto& pixel = picture.at<cv::Vec3b>(row, column);
        for (int c = 0; c < 3; ++c) pixel[c] = cv::saturate_cast<std::uint8_t>(255.0 * label.rgb[2 - c]);
      }
    }
  }
  cv::Mat small;
  cv::resize(picture, small, cv::Size(kSide, kSide), 0, 0, cv::INTER_AREA);
  if (!cv::imwrite(file.string(), small)) throw std::runtime_error(file.filename().string() + " cannot be written");
}

}  // namespace vallecula::pipeline
