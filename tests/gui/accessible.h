// What a page owes to those who hear it or use the keyboard, and whether its texts fit: asked of any widget.
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QCalendarWidget>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSlider>
#include <QTabBar>
#include <QTextEdit>
#include <QToolButton>
#include <QWidget>
#include <algorithm>
#include <string>
#include <vector>

namespace vallecula::gui::window_test {

/// True for what lies inside another control and speaks with its voice (a spin box's line, a table's header).
inline bool is_inner(const QWidget& widget, const QWidget& page) {
  if (widget.objectName().startsWith("qt_")) return true;
  for (const QWidget* up = widget.parentWidget(); up != nullptr && up != &page; up = up->parentWidget())
    if (qobject_cast<const QAbstractSpinBox*>(up) != nullptr || qobject_cast<const QComboBox*>(up) != nullptr ||
        qobject_cast<const QCalendarWidget*>(up) != nullptr || qobject_cast<const QLineEdit*>(up) != nullptr ||
        qobject_cast<const QTabBar*>(up) != nullptr || qobject_cast<const QAbstractItemView*>(up) != nullptr)
      return true;
  return false;
}

inline bool is_control(const QWidget& widget) {
  return qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
         qobject_cast<const QComboBox*>(&widget) != nullptr || qobject_cast<const QLineEdit*>(&widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
         qobject_cast<const QPlainTextEdit*>(&widget) != nullptr ||
         qobject_cast<const QTextEdit*>(&widget) != nullptr ||
         qobject_cast<const QAbstractSlider*>(&widget) != nullptr ||
         (qobject_cast<const QAbstractItemView*>(&widget) != nullptr &&
          qobject_cast<const QHeaderView*>(&widget) == nullptr);
}

inline std::string described(const QWidget& widget) {
  return std::string(widget.metaObject()->className()) + " '" + widget.objectName().toStdString() + "' in " +
         (widget.parentWidget() == nullptr ? "nothing" : widget.parentWidget()->metaObject()->className());
}

/// Every text of the page whose key with Alt is a menu's in the window's language: then neither answers to it.
inline std::vector<std::string> keys_of_menus(const QWidget& page) {
  std::vector<QKeySequence> menus;
  std::vector<std::string> found;
  for (const char* menu : {"&File", "&View", "&Help"}) {
    menus.push_back(QKeySequence::mnemonic(QCoreApplication::translate("vallecula::gui::MainMenu", menu)));
    if (menus.back().isEmpty()) found.push_back(std::string(menu) + " has no key");
  }
  const auto look = [&](const QString& text) {
    const QKeySequence key = QKeySequence::mnemonic(text);
    if (!key.isEmpty() && std::find(menus.begin(), menus.end(), key) != menus.end())
      found.push_back(text.toStdString());
  };
  for (const auto* button : page.findChildren<QAbstractButton*>()) look(button->text());
  for (const auto* label : page.findChildren<QLabel*>())
    if (label->buddy() != nullptr) look(label->text());
  for (const auto* tabs : page.findChildren<QTabBar*>())
    for (int i = 0; i < tabs->count(); ++i) look(tabs->tabText(i));
  return found;
}

/// Every control of the page that a screen reader could not name: no text of its own, no accessible name, no label
/// whose buddy it is.
inline std::vector<std::string> nameless_controls(const QWidget& page) {
  std::vector<std::string> found;
  const auto labels = page.findChildren<QLabel*>();
  for (const QWidget* one : page.findChildren<QWidget*>()) {
    if (!is_control(*one) || qobject_cast<const QScrollBar*>(one) != nullptr || is_inner(*one, page)) continue;
    const auto* button = qobject_cast<const QAbstractButton*>(one);
    bool named = !one->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
    for (const QLabel* label : labels) named = named || (label->buddy() == one && !label->text().isEmpty());
    if (!named) found.push_back(described(*one));
  }
  return found;
}

/// Every visible control that the Tab key does not lead to.
inline std::vector<std::string> unreachable_controls(const QWidget& page) {
  std::vector<std::string> found;
  for (const QWidget* one : page.findChildren<QWidget*>())
    if (is_control(*one) && one->isVisible() && qobject_cast<const QScrollBar*>(one) == nullptr &&
        !is_inner(*one, page) && (one->focusPolicy() & Qt::TabFocus) == 0)
      found.push_back(described(*one));
  return found;
}

/// Every visible label, button, box and tab whose text has less room than it asks for. A label that may be cut (its
/// horizontal policy ignores its size) must have the whole text as its tooltip.
inline std::vector<std::string> cut_texts(const QWidget& page) {
  std::vector<std::string> found;
  const auto tell = [&found](const QWidget& one, const QString& text, const QString& why) {
    found.push_back(described(one) + ": \"" + text.left(80).toStdString() + "\" " + why.toStdString());
  };
  for (const QLabel* label : page.findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty()) continue;
    const bool may_be_cut = label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
    if (label->wordWrap()) {
      const int wanted = label->heightForWidth(label->width());
      if (wanted > label->height() + 1)
        tell(*label, label->text(), QString("%1 of %2 px high").arg(label->height()).arg(wanted));
    } else if (label->sizeHint().width() > label->width() + 1 &&
               !(may_be_cut && label->toolTip().contains(label->text()))) {
      tell(*label, label->text(), QString("%1 of %2 px wide").arg(label->width()).arg(label->sizeHint().width()));
    }
  }
  for (const QAbstractButton* button : page.findChildren<QAbstractButton*>()) {
    const bool worded = qobject_cast<const QPushButton*>(button) != nullptr ||
                        qobject_cast<const QCheckBox*>(button) != nullptr ||
                        (qobject_cast<const QToolButton*>(button) != nullptr && !button->text().isEmpty());
    if (!button->isVisible() || is_inner(*button, page) || !worded) continue;
    if (button->sizeHint().width() > button->width() + 1)
      tell(*button, button->text(), QString("%1 of %2 px wide").arg(button->width()).arg(button->sizeHint().width()));
  }
  for (const QTabBar* tabs : page.findChildren<QTabBar*>())
    for (int i = 0; i < tabs->count(); ++i) {
      const QSize tab = tabs->tabRect(i).size();
      const int wanted = tabs->fontMetrics().horizontalAdvance(tabs->tabText(i).remove('&'));
      // A bar of one is not shown by a window of docks.
      if (!tabs->visibleRegion().isEmpty() && tabs->count() > 1 &&
          std::max(tab.width(), tab.height()) < wanted)  // some stand on their side
        tell(*tabs, tabs->tabText(i), QString("%1 of %2 px wide").arg(std::max(tab.width(), tab.height())).arg(wanted));
    }
  return found;
}

/// The innermost widgets that ask for more than so many pixels across: what keeps a page from being narrow.
inline std::vector<std::string> wider_than(const QWidget& page, int px) {
  std::vector<std::string> found;
  for (const QWidget* one : page.findChildren<QWidget*>()) {
    if (one->minimumSizeHint().width() <= px) continue;
    bool inner = true;
    for (const QWidget* child : one->findChildren<QWidget*>()) inner = inner && child->minimumSizeHint().width() <= px;
    if (inner) found.push_back(described(*one) + ": " + std::to_string(one->minimumSizeHint().width()) + " px");
  }
  return found;
}

/// For a test's message.
inline std::string lines(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& one : all) text += "\n  " + one;
  return text;
}

}  // namespace vallecula::gui::window_test
