// What may be higher than its place, scrolled up and down; never narrower than its content needs.
#pragma once

#include <QScrollArea>

namespace vallecula::gui {

class Scrolled : public QScrollArea {
  Q_OBJECT
 public:
  /// `least_lines`: of text, its own least height.
  Scrolled(QWidget* content, double least_lines, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void tell();
  double least_lines_;
  QSize least_;  ///< as the layout around it knows it
};

}  // namespace vallecula::gui
