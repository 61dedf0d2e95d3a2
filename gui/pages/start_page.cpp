#include "gui/pages/start_page.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <algorithm>
#include <stdexcept>

#include "gui/pages/module_tree.h"
#include "gui/pages/module_words.h"
#include "gui/pages/offered_tools.h"
#include "gui/pages/pass_words.h"
#include "gui/report/markdown.h"
#include "gui/session/device_choice.h"
#include "gui/session/words_from_below.h"
#include "gui/views/capitalised.h"

namespace vallecula::gui {
namespace {

QString course_text(const curricula::Curriculum& curriculum) {
  QString text = "<p>" + QCoreApplication::translate("StartPage", "Whoever has finished this course can:") + "</p><ul>";
  for (const auto& goal : curriculum.goals) text += "<li>" + plain_of(goal).toHtmlEscaped() + "</li>";
  return text + "</ul>";
}

}  // namespace

void StartPage::set_curricula(std::vector<curricula::Curriculum> curricula) {
  const int index = std::max(0, curriculum_->currentIndex());
  {
    const QSignalBlocker quiet(curriculum_);
    curricula_ = std::move(curricula);
    curriculum_->clear();
    for (const auto& one : curricula_) curriculum_->addItem(course_words(one.title));
    curriculum_->setCurrentIndex(std::min(index, curriculum_->count() - 1));
  }
  curriculum_->setEnabled(curricula_.size() > 1);
  show_modules();
}

void StartPage::set_past(PastResults past, bool all_open) {
  past_ = std::move(past);
  all_open_ = all_open;
  show_modules();
}

const curricula::Curriculum* StartPage::curriculum() const {
  return curriculum_->currentIndex() < 0 ? nullptr : &curricula_[static_cast<std::size_t>(curriculum_->currentIndex())];
}

bool StartPage::watching() const { return is_scripted(device_->currentData().toString().toStdString()); }

std::string StartPage::kinds() const {
  const auto kind = [](const QComboBox* box) { return box->currentData().toString().section(':', 0, 0).toStdString(); };
  const std::string blade = kind(device_), tube = kind(second_);
  return watching() || blade == "mouse" || tube.empty() ? blade : blade + "+" + tube;
}

void StartPage::show_modules() {
  std::vector<curricula::PastResult> past;
  if (curriculum() != nullptr) past = with_hands(past_[curriculum()->id], *curriculum(), kinds());
  tree_->show_course(curriculum(), past, kinds(), all_open_ || watching());
}

void StartPage::forget_mode() {
  mode_wanted_ = curricula::Mode::practice;
  show_chosen();
}

QStringList StartPage::states() const { return tree_->states(); }

void StartPage::show_chosen() {
  const bool offered = window()->focusWidget() == go_;  // what is disabled for a moment loses the focus
  why_->hide();
  go_->setEnabled(false);
  if (curriculum() == nullptr) {
    heading_->clear();
    briefing_->clear();
  } else if (const curricula::Scenario* scenario = tree_->scenario()) {
    show_scenario(*scenario);
  } else if (const curricula::Module* module = tree_->module()) {
    const curricula::ModuleProgress& progress = tree_->progress_of(*module);
    const QString closed = tree_->why_closed(*curriculum()->find(module->scenarios.front()));
    heading_->setText(course_words(module->title));
    briefing_->setText(html_of(module->goal) + "<p><b>" + capitalised(state_of(progress)) +
                       "</b>: " + progress_line(*module, progress).toHtmlEscaped() + ". " + closed.toHtmlEscaped() +
                       "</p><p>" + mastery_rule(*module).toHtmlEscaped() + ' ' +
                       tr("Trials with another kind of device do not count here.") + "</p>");
  } else {
    heading_->setText(course_words(curriculum()->title));
    briefing_->setText(course_text(*curriculum()));
  }
  if (offered) offer_start();
  emit changed();
}

void StartPage::show_scenario(const curricula::Scenario& scenario) {
  heading_->setText(course_words(scenario.title));
  QString text = html_of(scenario.briefing) + "<p>" + passes_with(scenario).toHtmlEscaped() + "</p>";
  if (const curricula::Module* module = curriculum()->module_of(scenario.id)) {
    if (!watching())
      text += "<p>" + course_words(module->title).toHtmlEscaped() + ": " +
              progress_line(*module, tree_->progress_of(*module)).toHtmlEscaped() + ".</p>";
    auto* modes = qobject_cast<QStandardItemModel*>(mode_->model());
    const auto may = [module](curricula::Mode mode) {
      return std::count(module->modes.begin(), module->modes.end(), mode) > 0;
    };
    for (int i = 0; i < mode_->count(); ++i)
      modes->item(i)->setEnabled(may(static_cast<curricula::Mode>(mode_->itemData(i).toInt())));
    const curricula::Mode mode = may(mode_wanted_) ? mode_wanted_ : module->modes.front();
    mode_->setCurrentIndex(mode_->findData(static_cast<int>(mode)));
  }
  briefing_->setText(text);
  const QString closed = tree_->why_closed(scenario);
  why_->setText(closed + (closed.isEmpty() ? QString() : ' ' + tr("A scripted hand can be watched at it before.")));
  why_->setVisible(!closed.isEmpty());
  mode_->setVisible(!watching());
  mode_label_->setVisible(!watching());
  const bool tube = scenario.intubation.has_value();
  // A scripted novice lifts and levers, but has no tube.
  const int novice = device_->findData(kWatchNovice);
  if (auto* model = qobject_cast<QStandardItemModel*>(device_->model())) model->item(novice)->setEnabled(!tube);
  if (tube && device_->currentIndex() == novice) device_->setCurrentIndex(device_->findData(kWatchExpert));
  const bool choice = tube && !watching() && device_->currentData().toString() != "mouse";
  second_->setVisible(choice);
  second_label_->setVisible(choice);
  offered_->offer(scenario);
  allow_start();
}

void StartPage::allow_start() {
  const curricula::Scenario* scenario = tree_->scenario();
  go_->setEnabled(scenario != nullptr && tree_->why_closed(*scenario).isEmpty() && !offered_->open());
  go_->setToolTip(offered_->open() ? tr("Choose blade and tube first: they count in the score") : "");
  emit changed();
}

void StartPage::show_course(const std::string& id) {
  for (std::size_t c = 0; c < curricula_.size(); ++c)
    if (curricula_[c].id == id) curriculum_->setCurrentIndex(static_cast<int>(c));
}

void StartPage::set_message(const QString& message) { message_->setText(message); }

bool StartPage::select(const QString& scenario, const QString& device) {
  bool found = false;
  for (std::size_t c = 0; c < curricula_.size() && !found; ++c) {
    if (curricula_[c].find(scenario.toStdString()) == nullptr) continue;
    curriculum_->setCurrentIndex(static_cast<int>(c));
    tree_->choose(scenario.toStdString());
    found = true;
  }
  const int index = device_->findData(device);
  if (index >= 0) device_->setCurrentIndex(index);
  return found && index >= 0;
}

Choice StartPage::hands() const {
  Choice choice;
  choice.patient = patient_->currentData().toString().toStdString();
  choice.device = device_->currentData().toString();
  choice.second = second_->currentData().toString();
  return choice;
}

NextTrial StartPage::next_trial() const {
  NextTrial next;
  next.patient = patient_->currentIndex() == 0 ? tr("the built-in manikin")
                                               : QString::fromStdString(std::filesystem::path(
                                                     patient_->currentData().toString().toStdString()).stem().string());
  next.device = device_->currentText();
  const curricula::Scenario* scenario = tree_->scenario();
  if (scenario == nullptr) {
    next.hindrance = tr("Choose a scenario of a course first.");
    return next;
  }
  next.scenario = tr("%1 (%2)").arg(course_words(scenario->title), course_words(curriculum()->title));
  const curricula::Module* module = curriculum()->module_of(scenario->id);
  const bool practised = module == nullptr || watching() ||
                         std::count(module->modes.begin(), module->modes.end(), curricula::Mode::practice) > 0;
  next.hindrance = tree_->why_closed(*scenario);
  if (next.hindrance.isEmpty() && offered_->open()) next.hindrance = tr("Blade and tube are to be chosen first.");
  if (next.hindrance.isEmpty() && !practised) next.hindrance = tr("It can only be taken as an assessment.");
  return next;
}

Choice StartPage::choice() const {
  const curricula::Scenario* scenario = tree_->scenario();
  if (scenario == nullptr) throw std::logic_error("no scenario is chosen");
  const auto mode = watching() ? curricula::Mode::practice : static_cast<curricula::Mode>(mode_->currentData().toInt());
  return {curriculum()->file,
          *scenario,
          patient_->currentData().toString().toStdString(),
          device_->currentData().toString(),
          offered_->taken(),
          second_->isVisibleTo(this) ? second_->currentData().toString() : QString(),
          mode};
}

}  // namespace vallecula::gui
