// One line of words that may have less room than it needs: then a shorter wording is shown, or dots where even the
// shortest is cut, and the tooltip says the whole.
#pragma once

#include <QLabel>
#include <QStringList>

namespace vallecula::gui {

class ElidedLabel : public QLabel {
  Q_OBJECT
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);
  /// `wordings`: the fullest first, which is text(). `tip`: instead of the whole, whether it is cut or not.
  void say(const QStringList& wordings, const QString& tip = {}, Qt::TextElideMode cut = Qt::ElideRight);
  QString shown() const;  ///< as it is painted

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void tell_whole();
  QStringList wordings_;
  QString tip_;
  Qt::TextElideMode cut_ = Qt::ElideRight;
};

}  // namespace vallecula::gui
