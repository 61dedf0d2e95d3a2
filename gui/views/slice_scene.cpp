#include "gui/views/slice_scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gui/session/words_from_below.h"
#include "pipeline/package/label_map.h"
#include "pipeline/package/origin.h"

namespace vallecula::gui {

QString words_of(const std::string& name) { return in_words(pipeline::words_of(name)); }

QString tenths_of(double mm) { return decimal(std::round(10.0 * mm) / 10.0 + 0.0, 1); }

SliceScene::SliceScene(QObject* parent) : QObject(parent) {
  overlay_.visible.fill(true);
  // Skin is every voxel that nothing else is: over grey values it would tint the whole picture.
  overlay_.visible[pipeline::kSkin] = false;
}

void SliceScene::set_scan(std::shared_ptr<const pipeline::Hounsfield> hu) {
  hu_ = std::move(hu);
  labels_.reset();
  overlay_.labels = nullptr;
  overlay_.threshold.reset();
  landmarks_.clear();
  seeds_.clear();
  measures_.clear();
  measuring_ = false;
  if (hu_) {
    const auto& size = hu_->grid.size;
    crosshair_ = hu_->grid.position(size[0] / 2, size[1] / 2, size[2] / 2);
    focus_ = {hu_->grid.position(-0.5, -0.5, -0.5), hu_->grid.position(size[0] - 0.5, size[1] - 0.5, size[2] - 0.5)};
  }
  pictures_changed();
  emit labels_changed();
  emit landmarks_changed();
  emit crosshair_moved();
}

void SliceScene::set_labels(std::shared_ptr<const pipeline::Labels> labels) {
  if (labels && (!hu_ || labels->grid.size != hu_->grid.size))
    throw std::invalid_argument("the labels do not lie on the scan's grid");
  labels_ = std::move(labels);
  overlay_.labels = labels_.get();
  pictures_changed();
  emit labels_changed();
}

void SliceScene::set_landmarks(std::map<std::string, SceneLandmark> landmarks) {
  landmarks_ = std::move(landmarks);
  emit landmarks_changed();
  emit changed();
}

void SliceScene::set_seeds(std::map<std::string, Point> seeds) {
  seeds_ = std::move(seeds);
  emit changed();
}

void SliceScene::set_focus(const Point& low, const Point& high) {
  focus_ = {low, high};
  emit focus_changed();
}

void SliceScene::set_crosshair(const Point& at) {
  if (!hu_) return;
  const auto& g = hu_->grid;
  for (int a = 0; a < 3; ++a)
    crosshair_[a] = std::clamp(at[a], g.origin[a], g.origin[a] + (g.size[a] - 1) * g.spacing[a]);
  emit crosshair_moved();
  emit changed();
}

int SliceScene::slice_index(SlicePlane plane) const {
  return hu_ ? hu_->grid.nearest(crosshair_)[axes_of(plane).through] : 0;
}

void SliceScene::scroll(SlicePlane plane, int count) {
  if (!hu_) return;
  const int a = axes_of(plane).through;
  Point at = crosshair_;
  at[a] = hu_->grid.origin[a] + (slice_index(plane) + count) * hu_->grid.spacing[a];
  set_crosshair(at);
}

void SliceScene::set_grey(const GreyWindow& window) {
  grey_ = {std::clamp(window.centre, -2000.0, 4000.0), std::clamp(window.width, 1.0, 8000.0)};
  table_ = GreyTable(grey_);
  pictures_changed();
}

void SliceScene::set_opacity(double opacity) {
  overlay_.opacity = std::clamp(opacity, 0.0, 1.0);
  pictures_changed();
}

void SliceScene::set_visible(std::uint8_t label, bool visible) {
  if (overlay_.visible[label] == visible) return;
  overlay_.visible[label] = visible;
  pictures_changed();
  emit labels_changed();
}

void SliceScene::set_threshold_preview(const std::optional<std::array<double, 2>>& hu) {
  overlay_.threshold = hu;
  pictures_changed();
}

void SliceScene::set_tool(SliceTool tool) {
  if (measuring_) remove_last_measure();  // a begun one would wait for points of another tool
  tool_ = tool;
  emit tool_changed();
  emit changed();
}

QImage SliceScene::picture(SlicePlane plane) const {
  if (!hu_) return {};
  return slice_picture(*hu_, plane, slice_index(plane), table_, overlay_);
}

void SliceScene::put_point(SlicePlane plane, const Point& at) {
  if (tool_ == SliceTool::seed) {
    emit seed_picked(at);
    return;
  }
  if (tool_ != SliceTool::ruler && tool_ != SliceTool::angle) return;
  if (measuring_ && measures_.back().plane != plane) remove_last_measure();
  // The second click of a double one is not another point.
  if (measuring_ && length_mm(measures_.back().points.back(), at) < 1e-6) return;
  if (!measuring_) {
    measures_.push_back({plane, {}});
    measuring_ = true;
  }
  measures_.back().points.push_back(at);
  measuring_ = measures_.back().points.size() < (tool_ == SliceTool::ruler ? 2u : 3u);
  emit changed();
}

void SliceScene::remove_last_measure() {
  if (!measures_.empty()) measures_.pop_back();
  measuring_ = false;
  emit changed();
}

void SliceScene::drag_landmark(const std::string& name, const Point& at) {
  const auto found = landmarks_.find(name);  // it may have gone while it was dragged: a new segmentation came
  if (found == landmarks_.end()) return;
  found->second = {at, true};
  emit landmark_dragged(QString::fromStdString(name), at);
  emit changed();
}

void SliceScene::drop_landmark(const std::string& name) {
  const auto found = landmarks_.find(name);
  if (found != landmarks_.end()) emit landmark_dropped(QString::fromStdString(name), found->second.at);
}

QString SliceScene::describe(const Point& at) const {
  if (!hu_) return {};
  QString text = QString("L %1   P %2   H %3 mm").arg(tenths_of(at[0]), tenths_of(at[1]), tenths_of(at[2]));
  const auto c = hu_->grid.nearest(at);
  if (!hu_->grid.contains(c[0], c[1], c[2])) return text + "   " + tr("outside the scan");
  text += QString("   %1 HU").arg(hu_->at(c[0], c[1], c[2]));
  if (labels_)
    for (const auto& label : pipeline::kLabelNames)
      if (label.value == labels_->at(c[0], c[1], c[2])) text += "   " + words_of(label.name);
  return text;
}

void SliceScene::pictures_changed() {
  ++picture_version_;
  emit changed();
}

}  // namespace vallecula::gui
