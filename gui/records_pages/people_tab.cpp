#include "gui/records_pages/people_tab.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <map>

#include "curricula/records/personal_data.h"
#include "gui/records_pages/person_dialog.h"
#include "gui/records_pages/person_words.h"
#include "gui/records_pages/records_desk.h"
#include "gui/records_pages/tables.h"
#include "gui/session/words_from_below.h"
#include "gui/views/capitalised.h"

namespace vallecula::gui {

using curricula::People;
using curricula::Person;
using curricula::Records;
using curricula::Role;

namespace {

constexpr int kAuditLines = 500;

struct Everybody {
  std::vector<Person> people;
  std::vector<curricula::AuditEntry> audit;
};

}  // namespace

PeopleTab::PeopleTab(RecordsDesk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  table_ = new_table(this, tr("People"), {tr("Name"), tr("Role"), tr("Since")});
  audit_ = new_table(this, tr("Audit trail"), {tr("When"), tr("Who"), tr("Did"), tr("With")});
  auto* heading = new QLabel(tr("Audit trail"), this);
  heading->setObjectName("heading");
  auto* about = new QLabel(
      tr("Kept by numbers; a name is shown where the person is still here. Nothing in it can be changed."), this);
  about->setObjectName("faint");
  message_ = new QLabel(this);
  message_->setObjectName("people_message");
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* buttons = new QHBoxLayout;
  const auto button = [&](const QString& text, bool needs_one, const std::function<void()>& what) {
    auto* made = new QPushButton(text, this);
    connect(made, &QPushButton::clicked, this, what);
    buttons->addWidget(made);
    if (needs_one) for_one_.push_back(made);
  };
  button(tr("&Add ..."), false, [this] { add(); });
  button(tr("Re&name ..."), true, [this] { rename(); });
  button(tr("New &PIN ..."), true, [this] { reset_pin(); });
  button(tr("&Export ..."), true, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Choose where the export's folder is made"));
    if (!folder.isEmpty()) export_chosen(folder);
  });
  button(tr("&Delete ..."), true, [this] { delete_chosen(); });
  button(tr("Pro&gress"), true, [this] {
    if (const Person* person = chosen()) emit progress_wanted(person->id);
  });
  buttons->addStretch(1);

  auto* all = new QVBoxLayout(this);
  all->addWidget(table_, 3);
  all->addLayout(buttons);
  all->addWidget(message_);
  all->addWidget(heading);
  all->addWidget(about);
  all->addWidget(audit_, 2);
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    for (QPushButton* one : for_one_) one->setEnabled(chosen() != nullptr);
  });
  connect(table_, &QTableWidget::activated, this, [this] {
    if (const Person* person = chosen()) emit progress_wanted(person->id);
  });
  for (QPushButton* one : for_one_) one->setEnabled(false);
}

void PeopleTab::refresh() {
  if (!desk_.instructor()) return;
  const curricula::SignedIn who = *desk_.who();
  desk_.ask<Everybody>(
      this,
      [who](Records& records) {
        const People people(records);
        return Everybody{people.list(), people.audit(who, kAuditLines)};
      },
      [this](Everybody everybody) { show_people(std::move(everybody.people), everybody.audit); });
}

void PeopleTab::show_people(std::vector<Person> people, const std::vector<curricula::AuditEntry>& audit) {
  const Person* before = chosen();
  const long long kept = before != nullptr ? before->id : 0;
  people_ = std::move(people);
  std::map<long long, QString> names;
  table_->setRowCount(static_cast<int>(people_.size()));
  table_->clearSelection();
  for (std::size_t i = 0; i < people_.size(); ++i) {
    const Person& person = people_[i];
    names[person.id] = QString::fromStdString(person.name);
    fill_row(table_, static_cast<int>(i), {names[person.id], words_of(person.role), for_people(person.created_utc)});
    if (person.id == kept) table_->selectRow(static_cast<int>(i));
  }
  const auto name_of = [&names](long long id) {
    if (id == 0) return tr("nobody signed in");
    const auto found = names.find(id);
    return found == names.end() ? tr("number %1, deleted").arg(id) : found->second;
  };
  audit_->setRowCount(static_cast<int>(audit.size()));
  for (std::size_t i = 0; i < audit.size(); ++i)
    fill_row(audit_, static_cast<int>(i),
             {for_people(audit[i].at_utc), name_of(audit[i].actor_id), in_words(audit[i].action),
              audit[i].subject_id == 0 ? QString() : name_of(audit[i].subject_id)});
  for (QPushButton* one : for_one_) one->setEnabled(chosen() != nullptr);
}

const Person* PeopleTab::chosen() const {
  const auto rows = table_->selectionModel()->selectedRows();
  if (rows.isEmpty() || rows.front().row() >= static_cast<int>(people_.size())) return nullptr;
  return &people_[static_cast<std::size_t>(rows.front().row())];
}

void PeopleTab::done(const QString& message) {
  message_->setText(message);
  emit people_changed();
}

void PeopleTab::add() {
  auto* dialog =
      new PersonDialog(this, tr("Add"), tr("The PIN is the person's own from then on: have it typed by them."),
                       PersonDialog::kName | PersonDialog::kRole | PersonDialog::kNewPin);
  connect(dialog, &PersonDialog::given, this, [this, dialog] {
    const curricula::SignedIn who = *desk_.who();
    const std::string name = dialog->name(), pin = dialog->new_pin();
    const bool instructor = dialog->wants_instructor();
    desk_.ask<long long>(
        dialog,
        [=](Records& records) {
          People people(records);
          return instructor ? people.create_instructor(who, name, pin) : people.register_trainee(name, pin);
        },
        [this, dialog](long long) {
          dialog->accept();
          done(tr("Added."));
        },
        [dialog](const QString& message) { dialog->refuse(message); });
  });
  dialog->open();
}

void PeopleTab::rename() {
  const long long id = chosen()->id;
  auto* dialog = new PersonDialog(this, tr("Rename"), tr("The name everywhere from now on; trials stay the person's."),
                                  PersonDialog::kName);
  dialog->set_name(QString::fromStdString(chosen()->name));
  connect(dialog, &PersonDialog::given, this, [this, dialog, id] {
    const curricula::SignedIn who = *desk_.who();
    const std::string name = dialog->name();
    desk_.ask<bool>(
        dialog,
        [=](Records& records) {
          People(records).rename(who, id, name);
          return true;
        },
        [this, dialog, id, name](bool) {
          dialog->accept();
          if (id == desk_.person().id) desk_.renamed(name);
          done(tr("Renamed."));
        },
        [dialog](const QString& message) { dialog->refuse(message); });
  });
  dialog->open();
}

void PeopleTab::reset_pin() {
  const long long id = chosen()->id;
  auto* dialog = new PersonDialog(
      this, tr("New PIN"), tr("In place of one that was forgotten; it ends a wait as well."), PersonDialog::kNewPin);
  connect(dialog, &PersonDialog::given, this, [this, dialog, id] {
    const curricula::SignedIn who = *desk_.who();
    const std::string pin = dialog->new_pin();
    desk_.ask<bool>(
        dialog,
        [=](Records& records) {
          People(records).reset_pin(who, id, pin);
          return true;
        },
        [this, dialog](bool) {
          dialog->accept();
          done(tr("The new PIN is set."));
        },
        [dialog](const QString& message) { dialog->refuse(message); });
  });
  dialog->open();
}

void PeopleTab::export_chosen(const QString& folder) {
  const Person* person = chosen();
  if (person == nullptr) return;
  const curricula::SignedIn who = *desk_.who();
  const long long id = person->id;
  const QString name = new_export_name(), made = folder + "/" + name;
  message_->setText(tr("Exporting ..."));
  desk_.ask<bool>(
      this,
      [=](Records& records) {
        curricula::export_person(records, who, id, made.toStdString());
        return true;
      },
      [this, name](bool) { done(tr("All that is kept of this person is in %1, in the folder you chose.").arg(name)); },
      [this](const QString& message) { message_->setText(message); });
}

void PeopleTab::delete_chosen() {
  const long long id = chosen()->id;
  const QString name = QString::fromStdString(chosen()->name);
  warn_before_deleting(this, tr("Delete %1?").arg(name), tr("This deletes %1").arg(name), [this, id] {
    const curricula::SignedIn who = *desk_.who();
    desk_.ask<curricula::Deletion>(
        this, [=](Records& records) { return curricula::delete_person(records, who, id); },
        [this, id](curricula::Deletion deletion) {
          if (id == desk_.person().id) desk_.sign_out();
          done(words_of(deletion));
        },
        [this](const QString& message) { message_->setText(message); });
  });
}

}  // namespace vallecula::gui
