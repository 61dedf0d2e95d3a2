// What all views of one scan show together: grey values, labels, landmarks, crosshair, measures. It decides nothing:
// what a person does in a view goes out as a signal.
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "gui/views/grey_window.h"
#include "gui/views/slice_measure.h"
#include "gui/views/slice_picture.h"
#include "pipeline/volume.h"

namespace vallecula::gui {

/// What the left button does in a slice.
enum class SliceTool { crosshair, window, ruler, angle, seed };

struct SceneLandmark {
  pipeline::Point at{};  ///< mm, LPS, scan's frame
  bool given = false;    ///< moved by a person
};

/// A structure's or landmark's name for a person.
QString words_of(const std::string& name);
/// mm to a tenth; never "-0.0".
QString tenths_of(double mm);

class SliceScene : public QObject {
  Q_OBJECT
 public:
  using Point = pipeline::Point;
  explicit SliceScene(QObject* parent = nullptr);

  /// The crosshair goes to the middle; labels, landmarks and measures of an earlier scan go.
  void set_scan(std::shared_ptr<const pipeline::Hounsfield> hu);
  const pipeline::Hounsfield* scan() const { return hu_.get(); }
  /// On the scan's grid, or none. Throws std::invalid_argument for another grid.
  void set_labels(std::shared_ptr<const pipeline::Labels> labels);
  const pipeline::Labels* labels() const { return labels_.get(); }
  std::shared_ptr<const pipeline::Labels> shared_labels() const { return labels_; }
  void set_landmarks(std::map<std::string, SceneLandmark> landmarks);
  const std::map<std::string, SceneLandmark>& landmarks() const { return landmarks_; }
  void set_seeds(std::map<std::string, Point> seeds);
  const std::map<std::string, Point>& seeds() const { return seeds_; }
  /// What fitted views show: the whole scan, unless told. Corners, mm.
  void set_focus(const Point& low, const Point& high);
  const std::array<Point, 2>& focus() const { return focus_; }

  /// Kept inside the scan.
  void set_crosshair(const Point& at);
  const Point& crosshair() const { return crosshair_; }
  /// The slice through the crosshair, counted along the plane's axis.
  int slice_index(SlicePlane plane) const;
  /// `count` slices on, kept inside the scan.
  void scroll(SlicePlane plane, int count);

  void set_grey(const GreyWindow& window);
  const GreyWindow& grey() const { return grey_; }
  void set_opacity(double opacity);
  double opacity() const { return overlay_.opacity; }
  void set_visible(std::uint8_t label, bool visible);
  bool visible(std::uint8_t label) const { return overlay_.visible[label]; }
  void set_threshold_preview(const std::optional<std::array<double, 2>>& hu);
  void set_tool(SliceTool tool);
  SliceTool tool() const { return tool_; }
  QImage picture(SlicePlane plane) const;
  /// Counts up whenever pictures of the same slices have changed.
  int picture_version() const { return picture_version_; }

  /// The tool's next point: a seed is picked, a measure begun, gone on with or ended.
  void put_point(SlicePlane plane, const Point& at);
  const std::vector<Measure>& measures() const { return measures_; }
  bool measuring() const { return measuring_; }
  void remove_last_measure();

  /// While it is dragged; dropped, it is announced.
  void drag_landmark(const std::string& name, const Point& at);
  void drop_landmark(const std::string& name);
  /// Where a person points, for the line that tells it.
  void hover(const Point& at) { emit hovered(at); }

  /// LPS mm (L, P, H rise towards left, back, head), HU and label at a point.
  QString describe(const Point& at) const;

 signals:
  void changed();
  void labels_changed();
  void focus_changed();
  void landmarks_changed();
  void crosshair_moved();
  void hovered(const vallecula::pipeline::Point& at);
  void seed_picked(const vallecula::pipeline::Point& at);
  void landmark_dragged(const QString& name, const vallecula::pipeline::Point& at);
  void landmark_dropped(const QString& name, const vallecula::pipeline::Point& at);
  void tool_changed();

 private:
  void pictures_changed();
  std::shared_ptr<const pipeline::Hounsfield> hu_;
  std::shared_ptr<const pipeline::Labels> labels_;
  std::map<std::string, SceneLandmark> landmarks_;
  std::map<std::string, Point> seeds_;
  std::array<Point, 2> focus_{};
  std::vector<Measure> measures_;
  bool measuring_ = false;
  Point crosshair_{};
  GreyWindow grey_;
  GreyTable table_{GreyWindow()};
  LabelOverlay overlay_;
  SliceTool tool_ = SliceTool::crosshair;
  int picture_version_ = 0;
};

}  // namespace vallecula::gui
