#include "gui/pages/result_page.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QUrl>
#include <QVBoxLayout>
#include <stdexcept>

#include "curricula/trial_log.h"
#include "gui/pages/chart_view.h"
#include "gui/pages/open_outside.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/result_figures.h"
#include "gui/report/advice.h"
#include "gui/report/figure_row.h"
#include "gui/report/force_chart.h"
#include "gui/report/monitor_chart.h"
#include "gui/session/log_on_demand.h"
#include "gui/session/replay_trial.h"
#include "gui/session/words_from_below.h"
#include "gui/views/scrolled.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

namespace {

/// A sentence of the score, as a link to its second where it has one and the trial may be replayed.
QString linked(const std::string& sentence, const curricula::Score& score, bool replayed) {
  const QString text = in_words(sentence).toHtmlEscaped();
  for (const curricula::Criterion& criterion : score.criteria)
    if (replayed && criterion.sentence == sentence && criterion.at_s >= 0.0)
      return QString("<a href='%1'>%2</a>").arg(criterion.at_s, 0, 'f', 3).arg(text);
  return text;
}

}  // namespace

ResultPage::ResultPage(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  title_ = new QLabel(this);
  title_->setObjectName("title");
  title_->setWordWrap(true);  // beside a verdict that is a sentence
  verdict_ = new QLabel(this);
  verdict_->setAlignment(Qt::AlignCenter);
  verdict_->setMinimumWidth(150);
  outcome_ = new QLabel(this);
  outcome_->setWordWrap(true);
  theme::dress(*outcome_, "font-size: @15pt@; font-weight: bold;");
  change_ = new QLabel(this);
  change_->setWordWrap(true);
  change_->setObjectName("heading");
  plot_ = new ChartView(tr("Force over time"), kLeastForceChart, true, this);
  monitor_ = new ChartView(tr("Saturation and heart rate over time"), kLeastMonitorChart, true, this);
  reasons_ = new QLabel(this);
  reasons_->setWordWrap(true);
  reasons_->setTextFormat(Qt::RichText);
  reasons_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  reasons_->setObjectName("reasons");
  reasons_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  reasons_->setToolTip(
      tr("A link opens the replay %1 s before its moment, so that it is seen coming; on the timeline the "
         "moment itself is framed in yellow.")
          .arg(kBeforeReason_s, 0, 'f', 0));
  connect(reasons_, &QLabel::linkActivated, this, [this](const QString& at_s) { emit replay_wanted(at_s.toDouble()); });
  told_ = new QLabel(this);
  told_->setWordWrap(true);
  theme::dress(*told_, "color: @over@; font-weight: bold;");
  told_->hide();
  where_ = new QLabel(this);
  where_->setObjectName("faint");
  where_->setWordWrap(true);
  where_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* head = new QHBoxLayout;
  head->addWidget(title_, 1);
  head->addWidget(verdict_, 0, Qt::AlignVCenter);
  auto* figures_panel = new QFrame(this);
  figures_panel->setObjectName("panel");
  figures_ = new QGridLayout(figures_panel);
  figures_->setHorizontalSpacing(14);
  figures_->setColumnStretch(0, 4);
  figures_->setColumnStretch(2, 5);
  auto* column = new QWidget(this);
  auto* side = new QVBoxLayout(column);
  side->setContentsMargins(0, 0, 0, 0);
  side->addWidget(figures_panel);
  side->addSpacing(6);
  side->addWidget(reasons_, 1);
  auto* plots = new QWidget(this);
  auto* charts = new QVBoxLayout(plots);
  charts->setContentsMargins(0, 0, 0, 0);
  charts->addWidget(plot_, 1);
  charts->addWidget(monitor_, 1);
  // An intubation has more to say than a small window is high, and charts stay readable with large text.
  auto* middle = new QHBoxLayout;
  middle->addWidget(new Scrolled(plots, 10.0, this), 17);
  middle->addWidget(new Scrolled(column, 4.0, this), 11);
  auto* foot = new QHBoxLayout;
  again_ = new QPushButton(tr("Again"), this);
  again_->setObjectName("primary");
  again_->setToolTip(QCoreApplication::translate("ResultPage", "Enter"));
  same_ = new QPushButton(QCoreApplication::translate("ResultPage", "Same attempt again"), this);
  auto* report = new QPushButton(QCoreApplication::translate("ResultPage", "Open the report"), this);
  auto* leave = new QPushButton(QCoreApplication::translate("ResultPage", "Other scenario"), this);
  foot->addWidget(where_, 1);
  replay_ = new QPushButton(QCoreApplication::translate("ResultPage", "Replay"), this);
  replay_->setObjectName("replay");
  connect(replay_, &QPushButton::clicked, this, [this] { emit replay_wanted(-1.0); });
  for (auto* button : {replay_, report, leave, same_, again_}) foot->addWidget(button);
  connect(again_, &QPushButton::clicked, this, &ResultPage::again);
  connect(same_, &QPushButton::clicked, this, &ResultPage::same_again);
  connect(leave, &QPushButton::clicked, this, &ResultPage::other_wanted);
  report->setObjectName("report");
  connect(report, &QPushButton::clicked, this, [this] { tell(open_outside(report_)); });
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(18, 14, 18, 12);
  all->setSpacing(10);
  all->addLayout(head);
  all->addWidget(outcome_);
  all->addWidget(change_);
  all->addLayout(middle, 1);
  all->addWidget(told_);
  all->addLayout(foot);
}

void ResultPage::show_outcome(const TrialOutcome& outcome, const curricula::Scenario& scenario,
                              const std::filesystem::path& folder, const std::vector<std::string>& misfits) {
  const auto& score = outcome.score;
  title_->setText(course_words(scenario.title));
  const bool aside = !score.set_aside.empty();  // it counts neither way; the reasons begin with why
  verdict_->setText(aside ? in_words(verdict(score)) : score.passed ? tr("PASSED") : tr("NOT PASSED"));
  theme::dress(*verdict_, QString("background: @%1@; color: white; font-size: @%2pt@; font-weight: bold; padding: 6px "
                                  "14px; border-radius: 6px;")
                              .arg(aside          ? "accent"
                                   : score.passed ? "within"
                                                  : "bad")
                              .arg(aside ? 11 : 14));  // why it does not count is a sentence
  outcome_->setVisible(score.intubation.has_value());
  if (score.intubation) outcome_->setText(in_words(curricula::outcome_in_words(*score.intubation)) + ".");
  const QString locked = in_words(replay_refusal(scenario));
  replay_->setEnabled(locked.isEmpty());
  replay_->setToolTip(locked.isEmpty() ? tr("L: look at the trial again, at any second of it") : locked);
  tell("");
  change_->setText(QString::fromStdString(what_to_change(score, scenario)));
  show_figures(outcome, scenario);
  QString list;
  for (const auto& misfit : misfits)
    list += "<li style='margin-bottom:5px'><b>" + in_words(misfit).toHtmlEscaped() + "</b></li>";
  if (!outcome.fault.empty())
    list += "<li style='margin-bottom:5px'><b>" + tr("A fault: %1").arg(in_words(outcome.fault)).toHtmlEscaped() +
            "</b></li>";
  for (const auto& reason : score.reasons)
    list += "<li style='margin-bottom:5px'>" + linked(reason, score, locked.isEmpty()) + "</li>";
  const QString how = !locked.isEmpty()       ? locked
                      : list.contains("href") ? tr("a link leads to its second in the replay")
                                              : QString();
  reasons_->setText(list.isEmpty() ? QString()
                                   : "<b>" + tr("Reasons") + "</b>" + (how.isEmpty() ? how : " (" + how + ")") +
                                         "<ul style='margin-left:-22px'>" + list + "</ul>");
  report_ = outcome.report;
  const auto& attempt = scenario.attempt;
  const bool drawn = attempt.seed != 0;
  again_->setText(drawn ? tr("Next attempt") : tr("Again"));
  same_->setVisible(drawn);
  QString where = tr("Results: %1").arg(QString::fromStdString(folder.string()));
  if (drawn) where += '\n' + tr("Attempt seed %1: with it everything is the same once more.").arg(attempt.seed);
  if (!outcome.replay_allowed) where += '\n' + tr("An assessment: its replay stays locked.");
  where_->setText(where);
  show_charts(outcome, scenario);
  setFocus();
}

void ResultPage::tell(const QString& message) {
  told_->setText(message);
  told_->setVisible(!message.isEmpty());
}

/// As large as they are seen. The log is read for the first of them and kept for the others until the page is left.
void ResultPage::show_charts(const TrialOutcome& outcome, const curricula::Scenario& scenario) {
  log_ = std::make_shared<LogOnDemand>(outcome.log);
  const auto of_log = [log = log_, score = outcome.score, scenario](const auto& make, const QString& words) {
    return [=](const ChartForm& form) {
      try {
        return make(form, *log->get(), scenario, score);
      } catch (const std::exception& error) {
        throw std::runtime_error(words.arg(QString::fromUtf8(error.what())).toStdString());
      }
    };
  };
  plot_->show_chart(of_log(make_force_chart, tr("The force plot could not be drawn: %1")),
                    QImage(QString::fromStdString(outcome.force_plot.string())));
  monitor_->setVisible(outcome.score.intubation.has_value());
  if (outcome.score.intubation)
    monitor_->show_chart(of_log(make_monitor_chart, tr("Saturation and heart rate cannot be drawn: %1")));
}

void ResultPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (log_ && !event->spontaneous()) log_->forget();  // long ones take much memory beside a page of text
}

void ResultPage::show_figures(const TrialOutcome& outcome, const curricula::Scenario& scenario) {
  while (QLayoutItem* item = figures_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  const auto& score = outcome.score;
  int row = 0;
  for (const Row& line : result_figures(outcome, scenario)) {
    auto* caption = new QLabel(in_words(line.name));
    caption->setObjectName("faint");
    caption->setWordWrap(true);
    auto* figure = new QLabel(in_words(line.value));
    theme::dress(*figure, QString("font-size: @%1pt@; font-weight: bold; color: @%2@;")
                              .arg(score.intubation ? 11 : 12)
                              .arg(line.verdict == "missed" ? "over" : "text"));
    auto* demand =
        new QLabel(line.verdict.empty() ? in_words(line.limit)
                                        : QString("%1: %2").arg(in_words(line.verdict), in_words(line.limit)));
    demand->setObjectName("faint");
    // Columns as wide as the window allows; a number keeps its unit beside it.
    static const QRegularExpression after_number("(?<=\\d) (?=\\S)");
    demand->setText(demand->text().replace(after_number, QString(QChar::Nbsp)));
    static const QRegularExpression number("\\d");
    figure->setWordWrap(!figure->text().contains(number));
    for (QLabel* part : {caption, demand}) part->setWordWrap(true);
    for (QLabel* part : {caption, figure, demand}) part->setToolTip(in_words(line.about));
    figures_->addWidget(caption, row, 0);
    figures_->addWidget(figure, row, 1);
    figures_->addWidget(demand, row, 2);
    ++row;
  }
  QString about =
      tr("Of %1 forces %2 were written more than 1 ms after they were due, and for %3 the tissue's step was not "
         "finished in time.")
          .arg(score.ticks)
          .arg(score.deadline_misses)
          .arg(score.overruns);
  if (score.loop_rate_hz > 0.0) about += ' ' + tr("The force loop ran at %1 Hz.").arg(score.loop_rate_hz, 0, 'f', 0);
  if (!score.real_time_setup.empty())
    about += '\n' + tr("Real-time set-up: %1.").arg(QString::fromStdString(score.real_time_setup));
  for (int column = 0; column < 3; ++column) figures_->itemAtPosition(row - 1, column)->widget()->setToolTip(about);
}

void ResultPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    emit again();
  else if (event->key() == Qt::Key_Escape)
    emit left();
  else if (event->key() == Qt::Key_L && replay_->isEnabled())
    emit replay_wanted(-1.0);
  else
    QWidget::keyPressEvent(event);
}

}  // namespace vallecula::gui
