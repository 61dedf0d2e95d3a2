#include "gui/pages/notes_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <optional>

#include "curricula/records/recovery.h"
#include "gui/pages/background.h"
#include "gui/pages/timed_list.h"
#include "gui/pages/timeline.h"
#include "gui/session/trial_record.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

NotesPanel::NotesPanel(QWidget* parent) : QWidget(parent) {
  list_ = new TimedList(tr("Notes"), this);
  text_ = new QLineEdit(this);
  text_->setObjectName("note");
  text_->setMaxLength(1000);
  text_->setAccessibleName(tr("A note at this second"));
  add_ = new QPushButton(tr("Add"), this);
  remove_ = new QPushButton(tr("Take away"), this);
  remove_->setToolTip(tr("Takes the chosen note away"));
  told_ = new QLabel(this);
  told_->setObjectName("faint");
  told_->setWordWrap(true);
  told_->hide();
  auto* row = new QHBoxLayout;
  row->addWidget(text_, 1);
  row->addWidget(add_);
  row->addWidget(remove_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(list_, 1);
  column->addWidget(told_);
  column->addLayout(row);
  connect(list_, &TimedList::wanted, this, &NotesPanel::wanted);
  connect(add_, &QPushButton::clicked, this, &NotesPanel::add);
  connect(text_, &QLineEdit::returnPressed, this, &NotesPanel::add);
  connect(text_, &QLineEdit::textChanged, this, [this] { show_time(now_s_); });
  connect(remove_, &QPushButton::clicked, this, &NotesPanel::remove);
  allow(false);
}

NotesPanel::~NotesPanel() {
  if (working_) working_->wait();
}

void NotesPanel::allow(bool on) {
  for (QWidget* part : {static_cast<QWidget*>(text_), static_cast<QWidget*>(add_), static_cast<QWidget*>(remove_)})
    part->setEnabled(on);
}

void NotesPanel::open(const std::filesystem::path& log_file) {
  log_file_ = log_file;
  list_->clear();
  text_->clear();
  ++opened_;
  ask({});
}

void NotesPanel::set_who(const curricula::Who& who) {
  who_ = who;
  if (!log_file_.empty()) ask({});
}

void NotesPanel::show_time(double at_s) {
  now_s_ = at_s;
  if (!text_->text().isEmpty()) return;  // a note that was begun stays where it was begun
  at_s_ = at_s;
  text_->setPlaceholderText(tr("Note at %1").arg(clock_text(at_s)));
}

void NotesPanel::write() {
  if (text_->isEnabled()) text_->setFocus();
}

void NotesPanel::add() {
  const std::string text = text_->text().trimmed().toStdString();
  if (text.empty() || busy()) return;
  ask([who = who_, at_s = at_s_, text](curricula::Notes& notes, long long trial) {
    notes.add(who, trial, at_s, text);
  });
}

void NotesPanel::remove() {
  const int row = list_->currentRow();
  if (row < 0 || busy()) return;
  ask([who = who_, id = list_->id_of(row)](curricula::Notes& notes, long long) { notes.remove(who, id); });
}

void NotesPanel::ask(std::function<void(curricula::Notes&, long long)> change) {
  using Answer = std::optional<std::vector<curricula::Note>>;
  const bool written = static_cast<bool>(change), writing = window()->focusWidget() == text_;
  allow(false);
  working_ = run_in_background<Answer>(
      this,
      [who = who_, log = log_file_, change = std::move(change)]() -> Answer {
        curricula::Records records(records_location());
        curricula::Notes notes(records);
        const long long trial = notes.trial_of_log(curricula::log_sha256(log));
        if (trial == 0) return std::nullopt;
        if (change) change(notes, trial);
        return notes.of_trial(who, trial);
      },
      [this, written, writing, of = opened_](const Answer& notes) {
        if (of != opened_) return;
        allow(notes.has_value());
        tell(notes ? QString() : tr("This trial is in no record of this station, so notes have no place to be kept."));
        show_notes(notes.value_or(std::vector<curricula::Note>()));
        if (written) text_->clear();
        if (writing) text_->setFocus();  // the next one
      },
      [this, written, of = opened_](const QString& message) {
        if (of != opened_) return;
        allow(written);  // what could be read can be tried again
        tell(message);
      });
}

void NotesPanel::tell(const QString& message) {
  told_->setText(message);
  told_->setVisible(!message.isEmpty());  // with large text there is room for list and buttons alone
}

void NotesPanel::show_notes(const std::vector<curricula::Note>& notes) {
  list_->clear();
  std::vector<double> at_s;
  for (const curricula::Note& note : notes) {
    const bool own = who_ && note.author_id == who_->id();
    const QString author = note.author_id == 0 ? tr("nobody signed in") : own ? tr("you") : tr("somebody else");
    list_->add(note.at_s, tr("%1  (%2)").arg(QString::fromStdString(note.text), author), theme::text(),
               tr("Written %1 (UTC) by %2").arg(QString::fromStdString(note.written_utc), author), note.id);
    at_s.push_back(note.at_s);
  }
  emit listed(at_s);
}

}  // namespace vallecula::gui
