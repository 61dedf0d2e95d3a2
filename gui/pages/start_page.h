// The course's page: which scenario of which module, what is open and mastered, on which patient, with which device.
#pragma once

#include <QWidget>
#include <filesystem>
#include <memory>
#include <vector>

#include "curricula/scenario.h"
#include "device/found_devices.h"
#include "gui/session/past_results.h"

class QComboBox;
class QDialog;
class QLabel;
class QLayout;
class QPushButton;

namespace vallecula::gui {

class ModuleTree;
class OfferedTools;

struct Choice {
  std::filesystem::path curriculum;
  curricula::Scenario scenario;
  std::filesystem::path patient;  ///< empty: the built-in manikin that the scenario asks for
  QString device;                 ///< as `vallecula trial --device` takes it
  curricula::ToolChoice taken;    ///< of what the scenario offers
  QString second;                 ///< as `--second`, of a scenario with a tube; empty: what goes with the device
  curricula::Mode mode = curricula::Mode::practice;
};

/// What a click on *Practise* would begin, in a person's words.
struct NextTrial {
  QString scenario, patient, device;
  QString hindrance;  ///< why it cannot begin by one click; empty: it can
};

class StartPage : public QWidget {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);
  /// Replaces the curricula, the first is shown; keeps the last choice where it is still to be had.
  void set_curricula(std::vector<curricula::Curriculum> curricula);
  /// What whoever sits here has done so far: says what is open and mastered. `all_open`: an instructor, for whom
  /// nothing is closed.
  void set_past(PastResults past, bool all_open = false);
  void show_course(const std::string& id);  ///< nothing happens where there is none of this id
  void add_patient(const std::filesystem::path& package, bool choose);
  /// The same for a person who wants to practise on it: patient_taken() follows, also where one of the list is chosen.
  void take_patient(const std::filesystem::path& package);
  /// Where the chosen scenario is for an infant of another size than this patient, who is as large as one of so many
  /// kg, one that is nearer is chosen. Returns what was done, for a person; empty: nothing needed to be, or another
  /// patient was chosen in the meantime.
  QString fit_scenario(const std::filesystem::path& package, double weight_kg);
  void offer_start();                   ///< Enter prepares the trial
  std::string chosen_scenario() const;  ///< its id; empty: none
  /// Offers what is plugged in beside what is always there; what is gone is no longer offered, unless it is chosen.
  void set_found_devices(const std::vector<device::FoundDevice>& devices);
  /// Offers this device and chooses it.
  void choose_device(const QString& name, const QString& label);
  void forget_mode();  ///< whoever comes next begins in practice
  void set_message(const QString& message);
  /// The first scenario of this id, in whichever curriculum, and the device; false where one of them is not to be had.
  /// A scenario that is not open yet is shown, but cannot be started.
  bool select(const QString& scenario, const QString& device);
  /// Throws std::logic_error when no scenario is chosen.
  Choice choice() const;
  /// What is said of the modules: "Handling the blade: open", one each.
  QStringList states() const;
  /// Patient and devices of the choice alone, whatever the scenario.
  Choice hands() const;
  /// Of the choice as it stands, practised: never an assessment.
  NextTrial next_trial() const;
  const std::vector<curricula::Curriculum>& curricula() const { return curricula_; }

 signals:
  void chosen(const vallecula::gui::Choice& choice);
  void import_wanted();
  void devices_wanted();
  void courses_wanted();
  void home_wanted();
  void changed();                              ///< next_trial() may be another
  void patient_taken(const QString& package);  ///< never of the built-in manikin, which is made for the scenario

 private:
  static constexpr const char *kWatchExpert = "scripted:expert", *kWatchNovice = "scripted:novice";

  QLayout* make_head();
  void make_choices();
  QLayout* make_patient_row();
  QLayout* make_left();
  QLayout* make_form(QLayout* patient_row, QWidget* devices);
  QWidget* make_right(QLayout* form);
  void connect_choices();
  /// Fills the tree anew.
  void show_modules();
  void show_chosen();
  void show_scenario(const curricula::Scenario& scenario);
  const curricula::Curriculum* curriculum() const;  ///< that is shown; null: there is none
  /// Nobody learns by a scripted hand, so it may be watched at anything.
  bool watching() const;
  /// As LogHeader::device_kind, of what is chosen.
  std::string kinds() const;
  void browse();
  void allow_start();  ///< where it is open and nothing is left to be chosen
  /// Of the chosen device, as it was last found; null: it was not, or has none.
  std::unique_ptr<QDialog> device_settings();
  std::vector<curricula::Curriculum> curricula_;
  std::vector<device::FoundDevice> found_{device::found_mouse()};  ///< looked for elsewhere: it may take seconds
  PastResults past_;
  bool all_open_ = false;
  curricula::Mode mode_wanted_ = curricula::Mode::practice;  ///< where the module allows it
  ModuleTree* tree_;
  OfferedTools* offered_;
  QLabel *heading_, *briefing_, *why_, *message_, *second_label_, *mode_label_;
  QComboBox *curriculum_, *patient_, *device_, *second_, *mode_;
  QPushButton* go_;
};

}  // namespace vallecula::gui
