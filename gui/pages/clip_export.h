// From when to when a clip of a replay goes, and its making, a picture at a time.
#pragma once

#include <QDialog>
#include <QImage>
#include <QTimer>
#include <functional>
#include <memory>

#include "gui/report/clip_writer.h"

class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace vallecula::gui {

class ClipExport : public QDialog {
  Q_OBJECT
 public:
  /// Gives the picture of a second of the trial; called on the window's thread.
  using Picture = std::function<QImage(double at_s)>;

  /// Seconds up to `until_s` can be chosen; `step_s`: between two pictures of the replay.
  ClipExport(Picture picture, double from_s, double until_s, double step_s, QWidget* parent = nullptr);
  ~ClipExport() override;
  void set_span(double from_s, double to_s);
  /// Makes FILE.mp4; accepted when it is whole. Cancel, or a failure (shown), leaves nothing.
  void start(const QString& file);
  bool working() const { return writer_ != nullptr; }
  const QString& file() const { return file_; }  ///< that was made, or is being made

 public slots:
  void reject() override;

 private:
  void ask();
  void add_one();
  void stop(const QString& message);

  Picture picture_;
  double step_s_;
  QString file_;
  QDoubleSpinBox *from_, *to_;
  QLabel* told_;
  QProgressBar* bar_;
  QPushButton* save_;
  std::unique_ptr<ClipWriter> writer_;
  QTimer timer_;
  int done_ = 0, all_ = 0;
};

}  // namespace vallecula::gui
