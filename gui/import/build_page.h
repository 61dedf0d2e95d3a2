// Step 4: the patient is built; what came of it, before and after it is saved.
#pragma once

#include <QWidget>
#include <vector>

#include "gui/import/import_choice.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace vallecula::gui {

class ImportWork;
class QualityList;
class WorkStrip;

class BuildPage : public QWidget {
  Q_OBJECT
 public:
  explicit BuildPage(ImportWork& work, QWidget* parent = nullptr);
  /// A new import: the name proposed for it, and nothing else chosen.
  void begin(const QString& name);
  BuildChoice choice() const;
  QString name() const;
  void show_building();
  /// `checked`: the report of the check. Figures say what they were there, or in the build before this one.
  void show_report(const std::vector<pipeline::QualityItem>& quality,
                   const std::vector<pipeline::QualityItem>& checked);
  void show_writing();
  void show_written(const QString& package);
  void show_message(const QString& message);
  bool built() const { return built_; }
  bool written() const { return written_; }
  QualityList& quality() { return *quality_; }

 signals:
  void back_wanted();
  void build_wanted();  ///< again, as chosen now
  void write_wanted();
  void practise_wanted();
  void left();

 private:
  QWidget* make_choices();
  void show_state();
  void say(const QString& message, bool problem);
  ImportWork& work_;
  bool built_ = false, written_ = false;
  BuildChoice built_with_;
  std::vector<pipeline::QualityItem> report_;  ///< of the last build
  QLabel *verdict_, *message_, *name_problem_;
  QLineEdit* name_;
  QCheckBox *keep_position_, *newborn_size_;
  QSpinBox* tetrahedra_;
  QualityList* quality_;
  WorkStrip* strip_;
  QPushButton *back_, *leave_, *again_, *save_, *practise_;
};

}  // namespace vallecula::gui
