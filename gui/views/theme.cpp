#include "gui/views/theme.h"

#include <QApplication>
#include <QFont>
#include <QPalette>
#include <QStyleFactory>

namespace vallecula::gui::theme {

void apply(QApplication& application) {
  application.setStyle(QStyleFactory::create("Fusion"));
  QPalette palette;
  palette.setColor(QPalette::Window, kGround);
  palette.setColor(QPalette::WindowText, kText);
  palette.setColor(QPalette::Base, kPanel);
  palette.setColor(QPalette::AlternateBase, kGround);
  palette.setColor(QPalette::Text, kText);
  palette.setColor(QPalette::Button, kPanel);
  palette.setColor(QPalette::ButtonText, kText);
  palette.setColor(QPalette::ToolTipBase, kPanel);
  palette.setColor(QPalette::ToolTipText, kText);
  palette.setColor(QPalette::Highlight, kAccent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Disabled, QPalette::ButtonText, kFaint.darker(130));
  palette.setColor(QPalette::Disabled, QPalette::WindowText, kFaint.darker(130));
  application.setPalette(palette);
  QFont font("DejaVu Sans");
  font.setPointSizeF(10.0);
  application.setFont(font);
  application.setStyleSheet(R"(
    QPushButton { background: #343b45; border: 1px solid #4a535f; border-radius: 5px; padding: 7px 16px; }
    QPushButton:hover { background: #3f4854; }
    QPushButton:focus { border: 1px solid #56b4e9; }
    QPushButton:disabled { background: #262b32; color: #69717b; border-color: #343b45; }
    QPushButton#primary { background: #2f78ba; border-color: #3a82c8; font-weight: bold; }
    QPushButton#primary:hover { background: #3a88cc; }
    QPushButton#primary:disabled { background: #2a3b4b; color: #7f8892; border-color: #343b45; }
    QPushButton:pressed { background: #1d5f4c; border-color: #009e73; }
    QPushButton:checked { background: #1d5f4c; border-color: #009e73; }
    QToolButton { background: #343b45; border: 1px solid #4a535f; border-radius: 5px; padding: 5px 10px; }
    QToolButton:hover { background: #3f4854; }
    QToolButton:focus { border: 1px solid #56b4e9; }
    QToolButton:checked { background: #2f5f8c; border-color: #56b4e9; color: white; }
    QToolButton:disabled { background: #262b32; color: #69717b; border-color: #343b45; }
    QCheckBox::indicator:unchecked, QTreeView::indicator:unchecked { background: #1f242b; border: 1px solid #969ea8; border-radius: 3px; }
    QCheckBox::indicator:unchecked:focus { border-color: #56b4e9; }
    QCheckBox::indicator:unchecked:disabled { border-color: #4a535f; }
    QRadioButton::indicator { width: 13px; height: 13px; border-radius: 7px; border: 1px solid #969ea8; background: #1f242b; }
    QRadioButton::indicator:checked { width: 9px; height: 9px; background: #56b4e9; border: 3px solid #1f242b; }
    QRadioButton::indicator:focus { border-color: #56b4e9; }
    QLineEdit { background: #1f242b; border: 1px solid #3a424d; border-radius: 4px; padding: 4px; }
    QLineEdit:focus { border: 1px solid #56b4e9; }
    QAbstractSpinBox QLineEdit { border: none; padding: 1px; }
    QTableView, QTreeView { background: #1f242b; border: 1px solid #3a424d; border-radius: 5px; gridline-color: #2b323b; }
    QTableView::item { padding: 3px 6px; border: 0; }
    QTreeView::item { padding: 3px; }
    QTableView::item:selected, QTreeView::item:selected { background: #2f5f8c; color: white; }
    QHeaderView::section { background: #262c34; border: none; border-right: 1px solid #3a424d; padding: 4px 6px; }
    QTabWidget::pane { border: none; }
    QTabBar::tab { background: #262c34; padding: 6px 14px; border-top-left-radius: 5px; border-top-right-radius: 5px; margin-right: 2px; }
    QTabBar::tab:selected { background: #2f5f8c; color: white; }
    QListWidget, QComboBox, QTextBrowser { background: #1f242b; border: 1px solid #3a424d; border-radius: 5px; padding: 4px; }
    QListWidget::item { padding: 9px 8px; border-radius: 4px; }
    QListWidget::item:selected { background: #2f5f8c; color: white; }
    QLabel#title { font-size: 19pt; font-weight: bold; }
    QLabel#heading { font-size: 12pt; font-weight: bold; }
    QLabel#faint { color: #969ea8; }
    QFrame#panel { background: #1f242b; border-radius: 7px; }
    QProgressBar { background: #343a43; border: none; border-radius: 5px; height: 14px; text-align: center; }
    QProgressBar::chunk { background: #3a82c8; border-radius: 5px; }
  )");
}

}  // namespace vallecula::gui::theme
