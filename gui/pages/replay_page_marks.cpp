// What the replay page draws beside the trial itself, and its legend.
#include <QCheckBox>
#include <QLabel>

#include "gui/pages/replay_page.h"
#include "gui/session/words_from_below.h"
#include "gui/views/heat_look.h"
#include "gui/views/operator_view.h"
#include "gui/views/replay_marks.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

QString swatch(const QColor& colour) { return QString("<span style='color:%1'>&#9632;</span>").arg(colour.name()); }

QColor heat_swatch(double share) {
  const auto c = heat_colour(share);
  return {c[0], c[1], c[2]};
}

}  // namespace

void ReplayPage::open_marks() {
  operator_view_->add_marks(marks_->props());
  for (const auto& marks : {marks_.get(), cut_marks_.get()})
    marks->set_paths(trial_->path, trial_->expert_path, trial_->scenario.targets.tongue_force_n);
  heat_look_.reset();
  heat_look_ = std::make_unique<HeatLook>(trial_->heat->boundary());
  heat_look_->actor()->SetVisibility(heat_->isChecked());
  operator_view_->add_marks({heat_look_->actor()});
  heat_of_ = 0;
  show_legend();
}

void ReplayPage::show_heat() {
  if (!heat_look_ || !heat_->isChecked() || shown_ < 0) return;
  ContactHeat& heat = *trial_->heat;
  const auto frame = static_cast<std::size_t>(shown_);
  heat_look_->show(*trial_->film->frame(frame), heat.peaks_until(frame));
  heat_of_ = heat.computed();
  show_legend();  // the highest may have become higher
  dirty_ = true;
}

void ReplayPage::follow_heat() {
  // The pressures are found a little later than the film: what is on the screen is shown anew once they are.
  if (heat_look_ && heat_->isChecked() && shown_ >= 0 && heat_of_ <= static_cast<std::size_t>(shown_) &&
      trial_->heat->computed() > heat_of_)
    show_heat();
}

void ReplayPage::show_legend() {
  QStringList lines;
  if (path_->isChecked() && trial_)
    lines << tr("Tip's path: %1 below half the target force on the tongue %2 up to it (%4 N) %3 over it; in white the "
                "expert's")
                 .arg(swatch(theme::device()), swatch(theme::target()), swatch(theme::bad()))
                 .arg(decimal(trial_->scenario.targets.tongue_force_n, 1));
  if (heat_->isChecked() && trial_)
    lines << tr("Highest pressure on tongue and epiglottis so far: %1 little %2 %3 %4 %5 kPa and more, in every trial; "
                "at "
                "most %6 kPa in this one")
                 .arg(swatch(heat_swatch(0.15)), swatch(heat_swatch(0.4)), swatch(heat_swatch(0.7)),
                      swatch(heat_swatch(1.0)))
                 .arg(kHeatTopKpa)
                 .arg(decimal(trial_->heat->highest_kpa(), 1));
  legend_->setText(lines.join("<br>"));
  legend_->setVisible(!lines.isEmpty());
}

}  // namespace vallecula::gui
