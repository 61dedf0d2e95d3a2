// A button large enough for what a person comes for: a title, a line that says what it leads to, a picture.
#pragma once

#include <QImage>
#include <QPushButton>

class QLabel;

namespace vallecula::gui {

class BigChoice : public QPushButton {
  Q_OBJECT
 public:
  explicit BigChoice(QWidget* parent);
  /// Both are read out by a screen reader as well.
  void say(const QString& title, const QString& about);
  /// Beside the words, at most `height` pixels high; a null one takes it away.
  void show_picture(const QImage& picture, int height);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QLabel *title_, *about_, *picture_;
};

}  // namespace vallecula::gui
