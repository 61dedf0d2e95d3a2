// The landmarks: where they are, how they came about, and moving them without a mouse.
#pragma once

#include <QWidget>
#include <map>
#include <string>

#include "gui/import/edit_history.h"
#include "pipeline/package/origin.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace vallecula::gui {

class SliceScene;

class LandmarkPanel : public QWidget {
  Q_OBJECT
 public:
  LandmarkPanel(SliceScene& scene, EditHistory& history, QWidget* parent = nullptr);
  /// As found, in the scan's frame; edits stand before them.
  void show_found(const std::map<std::string, pipeline::Point>& found,
                  const std::map<std::string, pipeline::Finding>& findings);

 private:
  void show_state();
  std::string selected() const;

  SliceScene& scene_;
  EditHistory& history_;
  std::map<std::string, pipeline::Point> found_;
  std::map<std::string, pipeline::Finding> findings_;
  QTreeWidget* tree_;
  QLabel* how_;
  QPushButton *move_, *back_;
};

}  // namespace vallecula::gui
