// The structures found: how each came about, and what a person can say about it.
#pragma once

#include <QWidget>
#include <map>
#include <string>

#include "gui/import/edit_history.h"
#include "pipeline/package/origin.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QTreeWidget;
class QTreeWidgetItem;

namespace vallecula::gui {

class SliceScene;

class StructurePanel : public QWidget {
  Q_OBJECT
 public:
  StructurePanel(SliceScene& scene, EditHistory& history, QWidget* parent = nullptr);
  /// After a segmentation; none: nothing has been found yet.
  void show_findings(const std::map<std::string, pipeline::Finding>& findings);
  std::string selected() const;  ///< a name of kLabelNames
  void select(const std::string& structure);

 signals:
  void load_wanted(const QString& structure);

 private:
  void show_state();
  void show_selected();
  void show_seed();
  void preview();
  QString how(const std::string& structure) const;

  SliceScene& scene_;
  EditHistory& history_;
  std::map<std::string, pipeline::Finding> findings_;
  QTreeWidget* tree_;
  QLabel *name_, *how_, *seed_at_;
  QPushButton *accept_, *seed_, *use_, *load_, *drop_;
  QSpinBox *low_, *high_;
  QCheckBox* preview_;
  std::string shown_;  ///< whose threshold the two boxes show
  bool filling_ = false;
};

/// "measured" and so on, with the rule in words when there is one.
QString finding_text(const pipeline::Finding& finding);

}  // namespace vallecula::gui
