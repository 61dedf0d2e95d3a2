#include "gui/pages/result_page.h"

#include <QDesktopServices>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>

#include "gui/pages/advice.h"
#include "gui/report/report.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

ResultPage::ResultPage(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  title_ = new QLabel(this);
  title_->setObjectName("title");
  verdict_ = new QLabel(this);
  verdict_->setAlignment(Qt::AlignCenter);
  verdict_->setMinimumWidth(150);
  change_ = new QLabel(this);
  change_->setWordWrap(true);
  change_->setObjectName("heading");
  plot_ = new QLabel(this);
  plot_->setMinimumSize(400, 240);
  plot_->setAlignment(Qt::AlignCenter);
  plot_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  plot_->setAccessibleName("Force over time");
  reasons_ = new QLabel(this);
  reasons_->setWordWrap(true);
  reasons_->setTextFormat(Qt::RichText);
  reasons_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  where_ = new QLabel(this);
  where_->setObjectName("faint");
  where_->setWordWrap(true);
  where_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* head = new QHBoxLayout;
  head->addWidget(title_, 1);
  head->addWidget(verdict_);
  auto* figures_panel = new QFrame(this);
  figures_panel->setObjectName("panel");
  figures_ = new QGridLayout(figures_panel);
  figures_->setHorizontalSpacing(18);
  auto* side = new QVBoxLayout;
  side->addWidget(figures_panel);
  side->addSpacing(6);
  side->addWidget(reasons_, 1);
  auto* middle = new QHBoxLayout;
  middle->addWidget(plot_, 17);
  middle->addLayout(side, 10);
  auto* foot = new QHBoxLayout;
  auto* again = new QPushButton("Again", this);
  again->setObjectName("primary");
  auto* report = new QPushButton("Open the report", this);
  auto* leave = new QPushButton("Other scenario", this);
  foot->addWidget(where_, 1);
  for (auto* button : {report, leave, again}) foot->addWidget(button);
  connect(again, &QPushButton::clicked, this, &ResultPage::again);
  connect(leave, &QPushButton::clicked, this, &ResultPage::left);
  connect(report, &QPushButton::clicked, this,
          [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(report_.string()))); });
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(18, 14, 18, 12);
  all->setSpacing(10);
  all->addLayout(head);
  all->addWidget(change_);
  all->addLayout(middle, 1);
  all->addLayout(foot);
}

void ResultPage::show_outcome(const TrialOutcome& outcome, const curricula::Scenario& scenario,
                              const std::filesystem::path& folder, const std::vector<std::string>& misfits) {
  const auto& score = outcome.score;
  title_->setText(QString::fromStdString(scenario.title));
  verdict_->setText(score.passed ? "PASSED" : "NOT PASSED");
  verdict_->setStyleSheet(
      QString(
          "background: %1; color: white; font-size: 14pt; font-weight: bold; padding: 6px 14px; border-radius: 6px;")
          .arg((score.passed ? theme::kWithin : theme::kBad).name()));
  change_->setText(QString::fromStdString(what_to_change(score, scenario)));
  show_figures(outcome, scenario);
  QString list;
  for (const auto& misfit : misfits)
    list += "<li style='margin-bottom:5px'><b>" + QString::fromStdString(misfit).toHtmlEscaped() + "</b></li>";
  if (!outcome.fault.empty())
    list += "<li style='margin-bottom:5px'><b>A fault: " + QString::fromStdString(outcome.fault).toHtmlEscaped() + "</b></li>";
  for (const auto& reason : score.reasons)
    list += "<li style='margin-bottom:5px'>" + QString::fromStdString(reason).toHtmlEscaped() + "</li>";
  reasons_->setText(list.isEmpty() ? QString() : "<b>Reasons</b><ul style='margin-left:-22px'>" + list + "</ul>");
  report_ = outcome.report;
  where_->setText("Results: " + QString::fromStdString(folder.string()));
  plot_picture_ = QPixmap(QString::fromStdString(outcome.force_plot.string()));
  fit_plot();
  setFocus();
}

void ResultPage::show_figures(const TrialOutcome& outcome, const curricula::Scenario& scenario) {
  while (QLayoutItem* item = figures_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  const auto& score = outcome.score;
  const auto& pass = scenario.pass;
  int row = 0;
  const auto add = [&](const QString& name, const QString& value, const QString& limit, bool judged, bool met) {
    auto* caption = new QLabel(name);
    caption->setObjectName("faint");
    auto* figure = new QLabel(value);
    QFont font = figure->font();
    font.setPointSizeF(12.0);
    font.setBold(true);
    figure->setFont(font);
    if (judged && !met) figure->setStyleSheet(QString("color: %1").arg(theme::kOver.name()));
    auto* demand = new QLabel(judged ? (met ? "met: " : "missed: ") + limit : limit);
    demand->setObjectName("faint");
    figures_->addWidget(caption, row, 0);
    figures_->addWidget(figure, row, 1);
    figures_->addWidget(demand, row, 2);
    ++row;
  };
  const auto number = [](double value, int digits, const char* unit) {
    return QString("%1 %2").arg(value, 0, 'f', digits).arg(unit);
  };
  add("Peak force, tongue", number(score.peak_tongue_force_n, 1, "N"),
      "at most " + number(pass.peak_tongue_force_n, 1, "N"), true,
      score.peak_tongue_force_n <= pass.peak_tongue_force_n);
  add("Peak force, gum", number(score.peak_gum_force_n, 1, "N"), "at most " + number(pass.peak_gum_force_n, 1, "N"),
      true, score.peak_gum_force_n <= pass.peak_gum_force_n);
  add("Glottis visible, best", number(score.glottis_visible_max_percent, 0, "%"),
      "at least " + number(pass.glottis_visible_percent, 0, "%"), true,
      score.glottis_visible_max_percent >= pass.glottis_visible_percent);
  add("Time to sight",
      score.time_to_trachea_visible_s < 0.0 ? QString("never") : number(score.time_to_trachea_visible_s, 1, "s"),
      "from " + number(scenario.sight_percent, 0, "%"), false, true);
  if (score.attempt_begun)
    add("Attempt", number(score.attempt_time_s, 1, "s"), "at most " + number(pass.attempt_time_s, 0, "s"), true,
        score.attempt_time_s <= pass.attempt_time_s);
  else
    add("Attempt", "no attempt", "-", false, true);
  add("Over the target", number(score.time_over_target_s, 1, "s"), "at most " + number(pass.time_over_target_s, 1, "s"),
      true, score.time_over_target_s <= pass.time_over_target_s);
  add("Over the device limit", number(score.time_over_force_limit_s, 1, "s"),
      "at most " + number(pass.time_over_device_limit_s, 1, "s"), true,
      score.time_over_force_limit_s <= pass.time_over_device_limit_s);
  if (!score.pauses.empty())
    add("Paused", number(score.paused_s, 1, "s"), QString::fromStdString(pauses_in_words(score)), false, true);
  add("Loop", score.loop_rate_hz > 0.0 ? number(score.loop_rate_hz, 0, "Hz") : QString("no real time"),
      QString("%1 late, %2 steps dropped").arg(score.deadline_misses).arg(score.overruns), false, true);
  QString about = QString("Of %1 ticks. Late: forces written more than 1 ms after they were due. Dropped: ticks whose "
                          "simulation step was not finished in time.")
                      .arg(score.ticks);
  if (!score.real_time_setup.empty())
    about += "\nReal-time set-up: " + QString::fromStdString(score.real_time_setup) + ".";
  for (int column = 0; column < 3; ++column) figures_->itemAtPosition(row - 1, column)->widget()->setToolTip(about);
}

void ResultPage::fit_plot() {
  if (plot_picture_.isNull()) {
    plot_->setText("The force plot could not be read.");
    return;
  }
  plot_->setPixmap(plot_picture_.scaled(plot_->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

void ResultPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!report_.empty()) fit_plot();
}

void ResultPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    emit again();
  else if (event->key() == Qt::Key_Escape)
    emit left();
  else
    QWidget::keyPressEvent(event);
}

}  // namespace vallecula::gui
