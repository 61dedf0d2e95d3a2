#include "gui/records_pages/hand_on.h"

#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <algorithm>
#include <stdexcept>

#include "gui/records_pages/own_rating.h"
#include "gui/records_pages/records_desk.h"
#include "gui/records_pages/trial_log_here.h"
#include "gui/report/pdf_report.h"
#include "gui/session/files.h"

namespace vallecula::gui {

using curricula::ExportTrial;

HandOn::HandOn(RecordsDesk& desk, std::function<Shown()> shown, QWidget* parent)
    : QPushButton(tr("Han&d on ..."), parent), desk_(desk), shown_(std::move(shown)) {
  auto* menu = new QMenu(this);
  table_ = menu->addAction(tr("&Table (CSV) ..."));
  trial_ = menu->addAction(tr("Report of the &chosen trial (PDF) ..."));
  trainee_ = menu->addAction(tr("&Report of this trainee (PDF) ..."));
  menu->addSeparator();
  names_ = menu->addAction(tr("With the trainees' &names"));
  names_->setCheckable(true);
  setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, &HandOn::update_menu);
  connect(&desk_, &RecordsDesk::changed, names_, [this] { names_->setChecked(false); });
  connect(table_, &QAction::triggered, this, [this] { ask_where("trials", "csv", &HandOn::write_table); });
  connect(trial_, &QAction::triggered, this, [this] { ask_where("trial", "pdf", &HandOn::write_trial_report); });
  connect(trainee_, &QAction::triggered, this, [this] { ask_where("trainee", "pdf", &HandOn::write_trainee_report); });
}

void HandOn::update_menu() {
  const Shown shown = shown_();
  table_->setText(shown.filter.trainee_id ? tr("&Table of all trials of this trainee (CSV) ...")
                                          : tr("&Table of the trials behind the curves shown (CSV) ..."));
  trial_->setVisible(shown.filter.trainee_id.has_value());
  trial_->setEnabled(shown.trial.has_value());
  trainee_->setVisible(shown.filter.trainee_id.has_value());
  names_->setVisible(desk_.instructor());
}

/// The name it proposes is by the time: file names name nobody.
void HandOn::ask_where(const QString& kind, const QString& ending, void (HandOn::*write)(const QString&)) {
  const QString name =
      "vallecula-" + kind + "-" + QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss") + "." + ending;
  QString file = QFileDialog::getSaveFileName(this, tr("Hand on"), QDir::home().filePath(name), "*." + ending);
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty()) file += "." + ending;
  (this->*write)(file);
}

void HandOn::hand_on(Shown shown, const QString& file, std::function<void(const Trials&, bool)> write) {
  const bool names = desk_.instructor() && names_->isChecked();
  shown.filter.names = names;
  emit told(tr("Writing %1 ...").arg(QFileInfo(file).fileName()));
  desk_.ask<int>(
      this,
      [who = desk_.who(), shown, names, write](curricula::Records& records) {
        Trials trials = curricula::trials_to_export(records, who, shown.filter);
        if (shown.with)
          trials.erase(std::remove_if(trials.begin(), trials.end(),
                                      [&shown](const ExportTrial& one) { return !shown.with(one.row); }),
                       trials.end());
        std::vector<curricula::RecordRow> rows;
        for (const ExportTrial& one : trials) rows.push_back(one.row);
        const std::set<long long> hidden = to_rate_first(records, who, rows);
        trials.erase(std::remove_if(trials.begin(), trials.end(),
                                    [&hidden](const ExportTrial& one) { return hidden.count(one.row.id) > 0; }),
                     trials.end());
        if (trials.empty()) throw std::runtime_error("There is no trial to hand on; nothing is written.");
        write(trials, names);
        return static_cast<int>(trials.size());
      },
      [this, file](int count) {
        emit told(tr("Written: %1, %n trial(s).", "", count).arg(QFileInfo(file).fileName()));
      },
      [this, file](QString message) {  // a folder may name a person
        emit told(tr("Not handed on. %1").arg(message.remove(QFileInfo(file).path() + "/")));
      });
}

void HandOn::write_table(const QString& file) {
  hand_on(shown_(), file, [path = file.toStdString()](const Trials& trials, bool names) {
    write_file_whole(path, curricula::trials_csv(trials, names));
  });
}

void HandOn::write_trial_report(const QString& file) {
  Shown shown = shown_();
  if (!shown.trial) return;
  shown.filter = {};
  shown.filter.trainee_id = shown.trial->trainee_id;
  shown.with = [id = shown.trial->id](const curricula::RecordRow& row) { return row.id == id; };
  hand_on(std::move(shown), file, [path = file.toStdString()](const Trials& trials, bool) {
    write_trial_pdf(path, read_log_here(trials.front().row), trials.front().trainee_name);
  });
}

void HandOn::write_trainee_report(const QString& file) {
  const Shown shown = shown_();
  if (!shown.filter.trainee_id) return;
  hand_on(shown, file, [path = file.toStdString(), id = *shown.filter.trainee_id](const Trials& trials, bool) {
    write_trainee_pdf(path, id, trials.front().trainee_name, trials);
  });
}

}  // namespace vallecula::gui
