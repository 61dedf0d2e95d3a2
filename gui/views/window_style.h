// What a style sheet cannot say of the window's controls: boxes to choose from whose words end in dots where they have
// no room, with a list as wide as its entries; dialogs' buttons without pictures.
#pragma once

#include <QProxyStyle>

class QComboBox;

namespace vallecula::gui {

class WindowStyle : public QProxyStyle {
  Q_OBJECT
 public:
  WindowStyle();
  void polish(QWidget* widget) override;
  void unpolish(QWidget* widget) override;
  using QProxyStyle::polish;
  using QProxyStyle::unpolish;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                       const QWidget* widget) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                         const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* more) const override;

  /// A box tells by its tooltip what it has no room for.
  bool eventFilter(QObject* watched, QEvent* event) override;
};

/// What a box shows of its entry: all of it, or its beginning and dots.
QString shown_words(const QComboBox& box);

}  // namespace vallecula::gui
