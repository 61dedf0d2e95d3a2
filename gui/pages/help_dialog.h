// The help: chapters with pictures, beside the window they tell of.
#pragma once

#include <QDialog>
#include <QStringList>

class QListWidget;
class QTextBrowser;

namespace vallecula::gui {

/// The chapters' names in their order; each is a resource :/help/NAME.md.
QStringList help_chapters();
/// The chapter about a page of the window, by MainWindow::page_name().
QString help_chapter_of(const QString& page);

class HelpDialog : public QDialog {
  Q_OBJECT
 public:
  explicit HelpDialog(QWidget* parent = nullptr);
  /// Nothing happens where there is no chapter of this name.
  void show_chapter(const QString& name);
  QString chapter() const;

 private:
  QListWidget* list_;
  QTextBrowser* text_;
};

}  // namespace vallecula::gui
