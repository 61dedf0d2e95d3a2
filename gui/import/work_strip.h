// What is being done, how far it is, how long it still takes, and the way out.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace vallecula::gui {

class ImportWork;

class WorkStrip : public QWidget {
  Q_OBJECT
 public:
  explicit WorkStrip(ImportWork& work, QWidget* parent = nullptr);
  /// For a job that begins; it is then filled by ImportWork::progressed.
  void begin(const QString& what);

 private:
  void show_left();
  ImportWork& work_;
  QLabel *stage_, *left_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  QTimer tick_;                 ///< counts down between two reports, which may be seconds apart
  QElapsedTimer reported_;      ///< since the last one
  double seconds_left_ = -1.0;  ///< as it said
};

}  // namespace vallecula::gui
