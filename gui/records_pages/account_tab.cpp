#include "gui/records_pages/account_tab.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>

#include "curricula/records/personal_data.h"
#include "gui/records_pages/person_dialog.h"
#include "gui/records_pages/person_words.h"
#include "gui/records_pages/pin_try.h"
#include "gui/records_pages/records_desk.h"

namespace vallecula::gui {

using curricula::People;
using curricula::Person;
using curricula::Records;
using curricula::Who;

namespace {

QString nobody_yet() {
  return QCoreApplication::translate(
      "AccountTab", "Nobody is registered here yet: register as a trainee, or set up the first instructor.");
}

struct Names {
  std::vector<Person> people;
  bool has_instructor = false;
};

}  // namespace

AccountTab::AccountTab(RecordsDesk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  halves_ = new QStackedWidget(this);
  halves_->addWidget(make_sign_in());
  halves_->addWidget(make_account());
  auto* all = new QVBoxLayout(this);
  all->addWidget(halves_);
  clock_.setInterval(250);
  connect(&clock_, &QTimer::timeout, this, &AccountTab::show_wait);
  connect(&desk_, &RecordsDesk::changed, this, &AccountTab::show_who);
  show_who();
}

QWidget* AccountTab::make_sign_in() {
  auto* half = new QWidget(this);
  auto* say = new QLabel(tr("Sign in to have your trials counted as yours. Nobody needs to: without signing in one "
                            "practises all the same, "
                            "and "
                            "the trials belong to nobody."),
                         half);
  say->setWordWrap(true);
  name_ = new QComboBox(half);
  name_->setAccessibleName(tr("Name"));
  pin_ = person_line(half, true);
  pin_->setAccessibleName(tr("PIN"));
  message_ = new QLabel(half);
  message_->setObjectName("sign_in_message");
  message_->setWordWrap(true);
  message_->setProperty("role", "warning");
  sign_in_button_ = new QPushButton(tr("Sign in"), half);
  sign_in_button_->setObjectName("primary");
  auto* form = new QFormLayout;
  form->addRow(tr("&Name"), name_);
  form->addRow(tr("&PIN"), pin_);
  auto* new_trainee = new QPushButton(tr("Register as a &trainee ..."), half);
  first_instructor_ = new QPushButton(tr("Set up the first &instructor ..."), half);
  first_instructor_->hide();
  auto* others = new QHBoxLayout;
  others->addWidget(new_trainee);
  others->addWidget(first_instructor_);
  others->addStretch(1);
  auto* column = new QVBoxLayout;
  column->setSpacing(12);
  column->addWidget(say);
  column->addLayout(form);
  column->addWidget(sign_in_button_, 0, Qt::AlignRight);
  column->addWidget(message_);
  column->addSpacing(16);
  column->addLayout(others);
  column->addStretch(1);
  auto* row = new QHBoxLayout(half);
  row->addLayout(column, 3);
  row->addStretch(2);
  connect(sign_in_button_, &QPushButton::clicked, this, &AccountTab::sign_in);
  connect(pin_, &QLineEdit::returnPressed, this, &AccountTab::sign_in);
  connect(name_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    message_->clear();
    clock_.stop();
    show_wait();
  });
  connect(new_trainee, &QPushButton::clicked, this, [this] { register_somebody(false); });
  connect(first_instructor_, &QPushButton::clicked, this, [this] { register_somebody(true); });
  return half;
}

QWidget* AccountTab::make_account() {
  auto* half = new QWidget(this);
  who_ = new QLabel(half);
  who_->setObjectName("heading");
  auto* say = new QLabel(tr("Trials from now on are yours. Sign out when somebody else takes the blade. All that is "
                            "kept of you you can take "
                            "along as a folder of open files, or have deleted whole."),
                         half);
  say->setWordWrap(true);
  auto* out = new QPushButton(tr("Sign &out"), half);
  out->setObjectName("primary");
  auto* pin = new QPushButton(tr("Change &PIN ..."), half);
  auto* take = new QPushButton(tr("&Export all my data ..."), half);
  auto* gone = new QPushButton(tr("&Delete me ..."), half);
  done_ = new QLabel(half);
  done_->setObjectName("account_message");
  done_->setWordWrap(true);
  done_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {out, pin, take, gone}) buttons->addWidget(button);
  buttons->addStretch(1);
  auto* column = new QVBoxLayout(half);
  column->setSpacing(14);
  column->addWidget(who_);
  column->addWidget(say);
  column->addLayout(buttons);
  column->addWidget(done_);
  column->addStretch(1);
  connect(out, &QPushButton::clicked, this, [this] { desk_.sign_out(); });
  connect(pin, &QPushButton::clicked, this, &AccountTab::change_pin);
  connect(take, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Choose where the export's folder is made"));
    if (!folder.isEmpty()) export_own(folder);
  });
  connect(gone, &QPushButton::clicked, this, &AccountTab::delete_own);
  return half;
}

long long AccountTab::chosen() const { return name_->currentData().toLongLong(); }

void AccountTab::show_who() {
  const bool signed_in = desk_.who().has_value();
  halves_->setCurrentIndex(signed_in ? 1 : 0);
  done_->clear();
  pin_->clear();
  if (signed_in) who_->setText(words_of(desk_.person()));
}

void AccountTab::refresh() {
  desk_.ask<Names>(
      this,
      [](Records& records) {
        People people(records);
        return Names{people.list(), people.has_instructor()};
      },
      [this](Names names) {
        const QVariant before = name_->currentData();
        const QSignalBlocker quiet(name_);
        people_ = std::move(names.people);
        name_->clear();
        for (const Person& person : people_)
          name_->addItem(words_of(person), QVariant::fromValue(static_cast<qlonglong>(person.id)));
        name_->setCurrentIndex(std::max(0, name_->findData(before)));
        if (people_.empty()) {
          name_->setCurrentIndex(-1);
          if (message_->text().isEmpty()) message_->setText(nobody_yet());
        } else if (message_->text() == nobody_yet()) {
          message_->clear();
        }
        first_instructor_->setVisible(!names.has_instructor);
        show_wait();
      });
}

void AccountTab::show_wait() {
  const auto found = waits_.find(chosen());
  const qint64 left_ms = found == waits_.end() ? 0 : found->second.remainingTime();
  const bool open = !people_.empty() && left_ms == 0;
  if (left_ms > 0) {
    message_->setText(tr("Too many wrong PINs: wait %1 s, or ask an instructor for a new PIN.")
                          .arg(static_cast<int>(std::ceil(1e-3 * static_cast<double>(left_ms)))));
    clock_.start();
  } else if (clock_.isActive()) {
    clock_.stop();
    message_->setText(tr("Try the PIN again."));
  }
  const bool was_open = pin_->isEnabled();
  pin_->setEnabled(open);
  sign_in_button_->setEnabled(open);
  if (open && !was_open && isVisible()) pin_->setFocus();
}

void AccountTab::sign_in() { sign_in_as(chosen(), pin_->text().toStdString()); }

void AccountTab::sign_in_as(long long id, const std::string& pin) {
  pin_->clear();
  message_->setText(tr("Looking at the PIN ..."));
  sign_in_button_->setEnabled(false);
  desk_.ask<PinTry>(
      this, [id, pin](Records& records) { return try_pin(records, id, pin); },
      [this, id](PinTry answer) {
        sign_in_button_->setEnabled(true);
        message_->setText(answer.refused);
        if (answer.wait_s > 0.0) {
          waits_[id] = QDeadlineTimer(static_cast<qint64>(1e3 * answer.wait_s));
          show_wait();
        }
        if (!answer.who) {
          pin_->setFocus();
          return;
        }
        for (const Person& person : people_)
          if (person.id == id) desk_.sign_in(*answer.who, person);
      },
      [this](const QString& message) {
        sign_in_button_->setEnabled(true);
        message_->setText(message);
      });
}

void AccountTab::register_somebody(bool first_instructor) {
  auto* dialog = new PersonDialog(
      this, first_instructor ? tr("Set up the instructor") : tr("Register"),
      first_instructor
          ? tr("An instructor sees everybody's progress, rates and notes, gives new PINs and deletes people. "
               "There is no way in without this PIN: keep it.")
          : tr("A name or a pseudonym, as you like to be seen in the list. Nobody else can see your PIN; an "
               "instructor can give you a new one."),
      PersonDialog::kName | PersonDialog::kNewPin);
  connect(dialog, &PersonDialog::given, this, [this, dialog, first_instructor] {
    const std::string name = dialog->name(), pin = dialog->new_pin();
    struct Made {
      Who who;
      Person person;
    };
    desk_.ask<Made>(
        dialog,
        [name, pin, first_instructor](Records& records) {
          People people(records);
          const Who who = first_instructor ? people.create_first_instructor(name, pin)
                                           : people.sign_in(people.register_trainee(name, pin), pin);
          for (const Person& person : people.list())
            if (person.id == who->id()) return Made{who, person};
          throw curricula::RecordsError("whoever was just registered has been deleted; register again");
        },
        [this, dialog](Made made) {
          dialog->accept();
          desk_.sign_in(*made.who, made.person);
          emit people_changed();
        },
        [dialog](const QString& message) { dialog->refuse(message); });
  });
  dialog->open();
}

void AccountTab::change_pin() {
  auto* dialog =
      new PersonDialog(this, tr("Change PIN"), tr("The old one first, so that nobody does it in your place."),
                       PersonDialog::kOldPin | PersonDialog::kNewPin);
  connect(dialog, &PersonDialog::given, this, [this, dialog] {
    const curricula::SignedIn who = *desk_.who();
    const std::string old_pin = dialog->old_pin(), new_pin = dialog->new_pin();
    desk_.ask<bool>(
        dialog,
        [who, old_pin, new_pin](Records& records) {
          People(records).change_pin(who, old_pin, new_pin);
          return true;
        },
        [this, dialog](bool) {
          dialog->accept();
          done_->setText(tr("The PIN is changed."));
        },
        [dialog](const QString& message) { dialog->refuse(message); });
  });
  dialog->open();
}

void AccountTab::export_own(const QString& folder) {
  const curricula::SignedIn who = *desk_.who();
  const QString name = new_export_name(), made = folder + "/" + name;
  done_->setText(tr("Exporting ..."));
  desk_.ask<bool>(
      this,
      [who, made](Records& records) {
        curricula::export_person(records, who, who.id(), made.toStdString());
        return true;
      },
      [this, name](bool) {
        done_->setText(tr("All that is kept of you is in %1, in the folder you chose.").arg(name));
      },
      [this](const QString& message) { done_->setText(message); });
}

void AccountTab::delete_own() {
  warn_before_deleting(this, tr("Delete yourself?"), tr("This deletes you"), [this] {
    const curricula::SignedIn who = *desk_.who();
    desk_.ask<curricula::Deletion>(
        this, [who](Records& records) { return curricula::delete_person(records, who, who.id()); },
        [this](curricula::Deletion deletion) {
          desk_.sign_out();
          message_->setText(words_of(deletion));
          emit people_changed();
        },
        [this](const QString& message) { done_->setText(message); });
  });
}

}  // namespace vallecula::gui
