#include "gui/pages/key_list.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QKeySequence>
#include <QLabel>
#include <QShortcut>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace vallecula::gui {
namespace {

/// One that was closed is there until the event loop removes it.
QDialog* open_list(QWidget* page) {
  for (auto* list : page->findChildren<QDialog*>("key_list"))
    if (list->isVisible()) return list;
  return nullptr;
}

}  // namespace

QString key_name(int key) {
  // Alone these are no sequence, and Qt would write their code as a letter.
  if (key == Qt::Key_Shift) return QKeySequence(Qt::SHIFT).toString(QKeySequence::NativeText).remove('+');
  if (key == Qt::Key_Return) key = Qt::Key_Enter;  // one name for both, the one that stands on most of them
  return QKeySequence(key).toString(QKeySequence::NativeText);
}

bool close_key_list(QWidget* page) {
  QDialog* open = open_list(page);
  return open != nullptr && open->close();
}

QDialog* show_key_list(QWidget* page, const std::vector<KeyGroup>& groups, const QString& note) {
  if (QDialog* open = open_list(page)) {
    open->raise();
    open->activateWindow();
    return nullptr;
  }
  auto* dialog = new QDialog(page);
  dialog->setObjectName("key_list");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QCoreApplication::translate("KeyList", "Keys of this page"));
  QString text;
  for (const KeyGroup& group : groups) {
    if (group.rows.empty()) continue;
    text += "<h3>" + group.title.toHtmlEscaped() + "</h3><table cellspacing='3'>";
    for (const KeyRow& row : group.rows)
      text += "<tr><td><b>" + row.keys.toHtmlEscaped() + "</b>&nbsp;&nbsp;</td><td>" + row.what.toHtmlEscaped() +
              "</td></tr>";
    text += "</table>";
  }
  auto* list = new QTextBrowser(dialog);
  list->setHtml(text);
  list->setAccessibleName(dialog->windowTitle());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
  auto* again = new QShortcut(Qt::Key_F1, dialog);
  again->setAutoRepeat(false);  // held a little longer it would close what it has just opened
  QObject::connect(again, &QShortcut::activated, dialog, &QDialog::close);
  auto* column = new QVBoxLayout(dialog);
  if (!note.isEmpty()) {
    auto* said = new QLabel(note, dialog);
    said->setObjectName("key_list_note");
    said->setWordWrap(true);
    column->addWidget(said);
  }
  column->addWidget(list, 1);
  column->addWidget(buttons);
  dialog->resize(620, 600);
  dialog->show();
  return dialog;
}

}  // namespace vallecula::gui
