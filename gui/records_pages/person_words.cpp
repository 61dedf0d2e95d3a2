#include "gui/records_pages/person_words.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QMessageBox>
#include <QPushButton>

namespace vallecula::gui {

QString words_of(curricula::Role role) {
  return role == curricula::Role::instructor ? QCoreApplication::translate("PersonWords", "instructor")
                                             : QCoreApplication::translate("PersonWords", "trainee");
}

QString words_of(const curricula::Person& person) {
  return QString::fromStdString(person.name) + " (" + words_of(person.role) + ")";
}

QString words_of(const curricula::Deletion& deletion) {
  QString text = QCoreApplication::translate("PersonWords", "Deleted: %1 trials, %2 notes, %3 files on this computer.")
                     .arg(deletion.trials)
                     .arg(deletion.notes)
                     .arg(deletion.files);
  for (const std::string& left : deletion.left)
    text +=
        '\n' + QCoreApplication::translate("PersonWords", "Still to be deleted: %1").arg(QString::fromStdString(left));
  return text;
}

QString new_export_name() { return "vallecula-export-" + QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss"); }

void warn_before_deleting(QWidget* parent, const QString& title, const QString& this_deletes,
                          const std::function<void()>& delete_them) {
  auto* box = new QMessageBox(
      QMessageBox::Warning, title,
      QCoreApplication::translate(
          "PersonWords",
          "%1 with all trials, figures, ratings and notes, and the trials' files: on this computer now, on others when "
          "they start next. Only a number stays in the audit trail. Nobody can bring it back; export first what is to "
          "be kept.")
          .arg(this_deletes),
      QMessageBox::NoButton, parent);
  box->setAttribute(Qt::WA_DeleteOnClose);
  auto* gone = box->addButton(QCoreApplication::translate("PersonWords", "Delete for good"), QMessageBox::AcceptRole);
  auto* keep = box->addButton(QCoreApplication::translate("PersonWords", "Keep"), QMessageBox::RejectRole);
  gone->setObjectName("delete_for_good");
  box->setDefaultButton(keep);
  box->setEscapeButton(keep);
  QObject::connect(gone, &QPushButton::clicked, parent, delete_them);
  box->open();
}

}  // namespace vallecula::gui
