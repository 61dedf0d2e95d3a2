// Step 4: the patient is built; what came of it, before and after it is saved.
#pragma once

#include <QWidget>
#include <vector>

#include "pipeline/package/patient_package.h"

class QLabel;
class QPushButton;

namespace vallecula::gui {

class ImportWork;
class QualityList;
class WorkStrip;

class BuildPage : public QWidget {
  Q_OBJECT
 public:
  explicit BuildPage(ImportWork& work, QWidget* parent = nullptr);
  void show_building();
  void show_report(const std::vector<pipeline::QualityItem>& quality);
  void show_writing();
  void show_written(const QString& package);
  void show_message(const QString& message);
  bool built() const { return built_; }

 signals:
  void back_wanted();
  void write_wanted();
  void practise_wanted();
  void left();

 private:
  void show_state();
  ImportWork& work_;
  bool built_ = false, written_ = false;
  QLabel *verdict_, *message_;
  QualityList* quality_;
  WorkStrip* strip_;
  QPushButton *back_, *leave_, *save_, *practise_;
};

}  // namespace vallecula::gui
