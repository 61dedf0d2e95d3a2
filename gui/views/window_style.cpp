#include "gui/views/window_style.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QHelpEvent>
#include <QPainter>
#include <QPainterPath>
#include <QScreen>
#include <QScrollBar>
#include <QStyleFactory>
#include <QStyleOptionComboBox>
#include <QToolTip>
#include <algorithm>

#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr int kBoxBefore = 7, kBoxAbove = 5;  // px, of a box's words to its edge
constexpr double kBoxRound = 5.0;             // px, a box's corners

/// px at a box's right end, for its arrow.
int box_arrow_wide(const QFontMetrics& type) { return std::max(20, type.height() + 4); }

QRect box_words(const QStyleOptionComboBox& box) {
  const QRect words = box.rect.adjusted(kBoxBefore, 1, -box_arrow_wide(box.fontMetrics), -1);
  return QStyle::visualRect(box.direction, box.rect, words);
}

void draw_box(const QStyleOptionComboBox& box, QPainter& painter) {
  const bool on = (box.state & QStyle::State_Enabled) != 0;
  const bool lit = on && (box.state & (QStyle::State_HasFocus | QStyle::State_On)) != 0;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(theme::shade(lit ? "focus" : "line"));
  painter.setBrush(theme::shade(on ? "panel" : "off"));
  painter.drawRoundedRect(QRectF(box.rect).adjusted(0.5, 0.5, -0.5, -0.5), kBoxRound, kBoxRound);
  const QRect words = box_words(box);
  const double middle =
      box.direction == Qt::RightToLeft ? 0.5 * words.left() : 0.5 * (words.right() + 1 + box.rect.right());
  const double half = 0.22 * box.fontMetrics.height(), low = box.rect.center().y() + 0.5 + 0.5 * half;
  QPainterPath arrow(QPointF(middle - half, low - half));
  arrow.lineTo(middle, low);
  arrow.lineTo(middle + half, low - half);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(on ? theme::text() : theme::shade("off-text"), std::max(1.5, 0.1 * box.fontMetrics.height()),
                      Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(arrow);
  painter.restore();
}

/// As wide as the longest entry, within the screen.
QRect box_list(const QComboBox& box, QRect list) {
  const QAbstractItemView* view = box.view();
  int wide = view->sizeHintForColumn(box.modelColumn()) + 2 * view->frameWidth() + 2;
  if (box.count() > box.maxVisibleItems()) wide += view->verticalScrollBar()->sizeHint().width();
  const QScreen* screen = box.screen();
  if (screen == nullptr || wide <= list.width()) return list;
  const QRect all = screen->availableGeometry();
  list.setWidth(std::min(wide, all.width()));
  const int beyond = box.mapToGlobal(list.topRight()).x() - all.right();
  if (beyond > 0) list.moveLeft(list.left() - beyond);
  return list;
}

}  // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

void WindowStyle::polish(QWidget* widget) {
  QProxyStyle::polish(widget);
  if (qobject_cast<QComboBox*>(widget) != nullptr) widget->installEventFilter(this);
}

void WindowStyle::unpolish(QWidget* widget) {
  widget->removeEventFilter(this);
  QProxyStyle::unpolish(widget);
}

void WindowStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                     const QWidget* widget) const {
  const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
  if (control != CC_ComboBox || box == nullptr)
    return QProxyStyle::drawComplexControl(control, option, painter, widget);
  draw_box(*box, *painter);
}

void WindowStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
  const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
  if (element != CE_ComboBoxLabel || box == nullptr || !box->currentIcon.isNull())
    return QProxyStyle::drawControl(element, option, painter, widget);
  if (box->editable) return;  // its line shows them
  const QRect words = box_words(*box);
  drawItemText(painter, words, static_cast<int>(visualAlignment(box->direction, Qt::AlignLeft | Qt::AlignVCenter)),
               box->palette, (box->state & State_Enabled) != 0,
               box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, words.width()), QPalette::Text);
}

QRect WindowStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                  const QWidget* widget) const {
  const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
  if (control != CC_ComboBox || box == nullptr) return QProxyStyle::subControlRect(control, option, part, widget);
  if (part == SC_ComboBoxEditField) return box_words(*box);
  if (part == SC_ComboBoxArrow) {
    const int wide = box_arrow_wide(box->fontMetrics);
    return visualRect(box->direction, box->rect, box->rect.adjusted(box->rect.width() - wide, 0, 0, 0));
  }
  if (const auto* whole = qobject_cast<const QComboBox*>(widget); whole != nullptr && part == SC_ComboBoxListBoxPopup)
    return box_list(*whole, box->rect);
  return QProxyStyle::subControlRect(control, option, part, widget);
}

QSize WindowStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                    const QWidget* widget) const {
  if (type != CT_ComboBox) return QProxyStyle::sizeFromContents(type, option, contents, widget);
  const QFontMetrics metrics = option != nullptr ? option->fontMetrics : widget->fontMetrics();
  return contents + QSize(kBoxBefore + box_arrow_wide(metrics), 2 * kBoxAbove);
}

int WindowStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* more) const {
  if (hint == SH_ComboBox_Popup) return 0;                    // a list below the box, not over it
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;  // their words say it
  return QProxyStyle::styleHint(hint, option, widget, more);
}

bool WindowStyle::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QProxyStyle::eventFilter(watched, event);
  auto* box = qobject_cast<QComboBox*>(watched);
  if (box == nullptr || shown_words(*box) == box->currentText()) return false;
  QString words = box->currentText();
  if (!box->toolTip().isEmpty() && box->toolTip() != words) words += "\n" + box->toolTip();
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), words, box);
  return true;
}

QString shown_words(const QComboBox& box) {
  const QFontMetrics type = box.fontMetrics();
  return type.elidedText(box.currentText(), Qt::ElideRight, box.width() - kBoxBefore - box_arrow_wide(type));
}

}  // namespace vallecula::gui
