// Step 3: looking at what was found, and mending it.
#pragma once

#include <QWidget>
#include <array>

#include "gui/import/edit_history.h"
#include "gui/import/import_work.h"
#include "gui/views/slice_scene.h"

class QFrame;
class QGridLayout;
class QLabel;
class QPushButton;
class QTabWidget;

namespace vallecula::gui {

class LabelView;
class LandmarkPanel;
class QualityList;
class SliceView;
class StructurePanel;
class WorkStrip;

class CheckPage : public QWidget {
  Q_OBJECT
 public:
  explicit CheckPage(ImportWork& work, QWidget* parent = nullptr);
  ~CheckPage() override;

  /// A new scan: everything said of an earlier one goes.
  void show_scan(std::shared_ptr<const pipeline::Hounsfield> scan);
  void show_segmentation(const SegmentedScan& scan);
  void show_message(const QString& message, bool problem = true);
  /// What a segmentation could not find, with how to go on.
  void show_failure(const QString& message);
  /// Lets go of the scan.
  void clear();
  /// After a job has begun or ended.
  void show_busy(const QString& what = {});

  SliceScene& scene() { return scene_; }
  EditHistory& history() { return history_; }
  SliceView& slice(SlicePlane plane) { return *slices_[static_cast<std::size_t>(plane)]; }
  LabelView& view_3d() { return *view_3d_; }
  StructurePanel& structures() { return *structures_; }
  /// The report of the segmentation shown, with what was not seen in it.
  const std::vector<pipeline::QualityItem>& report() const { return report_; }
  QualityList& quality() { return *quality_; }
  /// Is there something said that the labels shown do not know of yet?
  bool edits_waiting() const;
  /// See ImportWork::load and save.
  void load(const std::filesystem::path& file, const std::string& structure);
  void save(const std::filesystem::path& file);

 signals:
  void segment_wanted();
  void build_wanted();
  void left();

 private:
  QWidget* make_tools();
  QWidget* make_side();
  QWidget* make_foot();
  void add_step(QWidget* bar, const QString& text, bool undo, const QKeySequence& key);
  void add_tool(QWidget* bar, const QString& text, const char* key, SliceTool tool, const QString& tip);
  void show_alone(QWidget* view);
  void show_state();

  ImportWork& work_;
  SliceScene scene_;
  EditHistory history_;
  SegmentedScan found_;
  std::vector<pipeline::QualityItem> report_;
  QGridLayout* views_;
  std::array<SliceView*, 3> slices_{};
  LabelView* view_3d_;
  QFrame* frame_3d_;  ///< shows that the view has the keyboard
  QTabWidget* tabs_;
  StructurePanel* structures_;
  LandmarkPanel* landmarks_;
  QualityList* quality_;
  QLabel *at_, *message_, *grey_;
  QPushButton *back_, *again_, *build_, *save_, *load_;
  QWidget* side_;
  WorkStrip* strip_;
};

}  // namespace vallecula::gui
