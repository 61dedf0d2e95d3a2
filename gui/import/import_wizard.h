// From a CT to a patient in four steps, for a person: source, segmentation, check, build.
#pragma once

#include <QWidget>
#include <vector>

#include "gui/import/import_work.h"

class QLabel;
class QStackedWidget;

namespace vallecula::gui {

class BuildPage;
class CheckPage;
class SourcePage;
class WorkStrip;

class ImportWizard : public QWidget {
  Q_OBJECT
 public:
  explicit ImportWizard(QWidget* parent = nullptr);

  /// Begins anew; `source` (may be empty) is looked at at once.
  void begin(const QString& source = {});
  /// Ends what is being done and lets go of the scan.
  void stop();
  /// "source", "segment", "check", "build".
  QString step() const;
  ImportWork& work() { return work_; }
  SourcePage& source_page() { return *source_; }
  CheckPage& check_page() { return *check_; }
  BuildPage& build_page() { return *build_; }

 signals:
  /// A package was written and is to be practised with.
  void finished(const QString& package);
  void saved(const QString& package);      ///< written; its page is still open
  void left_with(const QString& package);  ///< as left(), after it was saved
  void left();

 private:
  QWidget* make_segment_page();
  void show_page(QWidget* page);
  void build();
  void begin_segmentation(const ImportChoice& choice);
  void job_failed(const QString& message);
  void job_cancelled();
  void leave();

  ImportWork work_;
  QStackedWidget* pages_;
  std::vector<QLabel*> steps_;
  SourcePage* source_;
  QWidget* segment_;
  WorkStrip* strip_;
  CheckPage* check_;
  BuildPage* build_;
  QString package_;
};

}  // namespace vallecula::gui
