// File > Open: one dialog for what is a file (a course, a scan, a log) and what is a folder (a patient, a trial, a CT).
#pragma once

#include <QFileDialog>

namespace vallecula::gui {

class OpenDialog : public QFileDialog {
  Q_OBJECT
 public:
  /// Begins in this folder.
  explicit OpenDialog(const QString& folder, QWidget* parent = nullptr);

 signals:
  void chosen(const QString& path);  ///< a file, or a folder that is opened as a whole

 protected:
  /// A patient's or a trial's folder is what was meant; any other is gone into.
  void accept() override;

 private:
  void take(const QString& path);
};

}  // namespace vallecula::gui
